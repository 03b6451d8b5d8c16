//! Intervals with dyadic ends: every operation contains what it would give for any numbers within.
//!
//! Ends are rounded outwards to a number of binary digits that the caller chooses (R. E. Moore,
//! *Interval Analysis*, 1966). Invariant: `low <= high`.

use super::dyadic::{Dyadic, Rounding};
use num_rational::BigRational;
use std::cmp::Ordering;

/// All real numbers from `low` to `high`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Interval {
    low: Dyadic,
    high: Dyadic,
}

impl Interval {
    /// The numbers between two ends in either order.
    pub fn between(a: Dyadic, b: Dyadic) -> Self {
        if a <= b {
            Interval { low: a, high: b }
        } else {
            Interval { low: b, high: a }
        }
    }

    /// A single number.
    pub fn point(x: Dyadic) -> Self {
        Interval {
            low: x.clone(),
            high: x,
        }
    }

    /// An integer.
    pub fn integer(n: i64) -> Self {
        Interval::point(Dyadic::integer(n))
    }

    /// The narrowest interval with ends of so many digits around a rational number.
    pub fn rational(x: &BigRational, bits: u32) -> Self {
        if let Some(exact) = Dyadic::exactly(x, bits) {
            return Interval::point(exact);
        }
        Interval {
            low: Dyadic::from_rational(x, bits, Rounding::Down),
            high: Dyadic::from_rational(x, bits, Rounding::Up),
        }
    }

    /// The lower end.
    pub fn low(&self) -> &Dyadic {
        &self.low
    }

    /// The upper end.
    pub fn high(&self) -> &Dyadic {
        &self.high
    }

    /// The number, where it is only one.
    pub fn single(&self) -> Option<&Dyadic> {
        (self.low == self.high).then_some(&self.low)
    }

    /// Whether zero is among the numbers.
    pub fn contains_zero(&self) -> bool {
        !self.low.is_positive() && !self.high.is_negative()
    }

    /// The sign that all numbers have, if they have one.
    pub fn sign(&self) -> Option<Ordering> {
        if self.low.is_positive() {
            Some(Ordering::Greater)
        } else if self.high.is_negative() {
            Some(Ordering::Less)
        } else if self.low.is_zero() && self.high.is_zero() {
            Some(Ordering::Equal)
        } else {
            None
        }
    }

    /// Whether a rational number is among them.
    pub fn contains(&self, x: &BigRational) -> bool {
        self.low.compared_with(x) != Ordering::Greater
            && self.high.compared_with(x) != Ordering::Less
    }

    /// Whether the two have no number in common.
    pub fn is_apart_from(&self, other: &Self) -> bool {
        self.high < other.low || other.high < self.low
    }

    /// Whether every number of the other is among these.
    pub fn includes(&self, other: &Self) -> bool {
        self.low <= other.low && other.high <= self.high
    }

    /// Whether the other lies strictly inside.
    pub fn includes_strictly(&self, other: &Self) -> bool {
        self.low < other.low && other.high < self.high
    }

    /// The numbers that are in both; none where there is none.
    pub fn intersection(&self, other: &Self) -> Option<Self> {
        let low = self.low.clone().max(other.low.clone());
        let high = self.high.clone().min(other.high.clone());
        (low <= high).then_some(Interval { low, high })
    }

    /// The narrowest interval with both.
    #[must_use]
    pub fn hull(&self, other: &Self) -> Self {
        Interval {
            low: self.low.clone().min(other.low.clone()),
            high: self.high.clone().max(other.high.clone()),
        }
    }

    /// The exact distance of the ends.
    pub fn width(&self) -> Dyadic {
        self.high.subtract(&self.low, 64, Rounding::Up)
    }

    /// A number near the middle.
    pub fn middle(&self, bits: u32) -> Dyadic {
        let sum = self.low.add(&self.high, bits, Rounding::Down);
        let middle = sum.scaled(-1);
        // Rounding may have left the interval.
        middle.max(self.low.clone()).min(self.high.clone())
    }

    /// The largest absolute value.
    pub fn largest(&self) -> Dyadic {
        self.low.absolute().max(self.high.absolute())
    }

    /// The smallest absolute value.
    pub fn smallest(&self) -> Dyadic {
        match self.sign() {
            Some(Ordering::Greater) => self.low.clone(),
            Some(Ordering::Less) => self.high.negated(),
            Some(Ordering::Equal) | None => Dyadic::zero(),
        }
    }

    /// All `-x`.
    #[must_use]
    pub fn negated(&self) -> Self {
        Interval {
            low: self.high.negated(),
            high: self.low.negated(),
        }
    }

    /// All `|x|`.
    #[must_use]
    pub fn absolute(&self) -> Self {
        Interval {
            low: self.smallest(),
            high: self.largest(),
        }
    }

    /// All `2^by x`.
    #[must_use]
    pub fn scaled(&self, by: i64) -> Self {
        Interval {
            low: self.low.scaled(by),
            high: self.high.scaled(by),
        }
    }

    /// The same with ends of at most so many digits.
    #[must_use]
    pub fn rounded(self, bits: u32) -> Self {
        Interval {
            low: self.low.rounded(bits, Rounding::Down),
            high: self.high.rounded(bits, Rounding::Up),
        }
    }

    /// All numbers no farther than `by` from one of these.
    #[must_use]
    pub fn widened(&self, by: &Dyadic, bits: u32) -> Self {
        Interval {
            low: self.low.subtract(by, bits, Rounding::Down),
            high: self.high.add(by, bits, Rounding::Up),
        }
    }

    /// All `x + y`.
    #[must_use]
    pub fn add(&self, other: &Self, bits: u32) -> Self {
        Interval {
            low: self.low.add(&other.low, bits, Rounding::Down),
            high: self.high.add(&other.high, bits, Rounding::Up),
        }
    }

    /// All `x - y`.
    #[must_use]
    pub fn subtract(&self, other: &Self, bits: u32) -> Self {
        Interval {
            low: self.low.subtract(&other.high, bits, Rounding::Down),
            high: self.high.subtract(&other.low, bits, Rounding::Up),
        }
    }

    /// All `x y`.
    #[must_use]
    pub fn multiply(&self, other: &Self, bits: u32) -> Self {
        let (a, b) = (self, other);
        let ends = |l: (&Dyadic, &Dyadic), h: (&Dyadic, &Dyadic)| Interval {
            low: l.0.multiply(l.1, bits, Rounding::Down),
            high: h.0.multiply(h.1, bits, Rounding::Up),
        };
        let not_negative = |x: &Interval| !x.low.is_negative();
        let not_positive = |x: &Interval| !x.high.is_positive();
        match (
            not_negative(a),
            not_positive(a),
            not_negative(b),
            not_positive(b),
        ) {
            (true, _, true, _) => ends((&a.low, &b.low), (&a.high, &b.high)),
            (true, _, _, true) => ends((&a.high, &b.low), (&a.low, &b.high)),
            (_, true, true, _) => ends((&a.low, &b.high), (&a.high, &b.low)),
            (_, true, _, true) => ends((&a.high, &b.high), (&a.low, &b.low)),
            (true, _, false, false) => ends((&a.high, &b.low), (&a.high, &b.high)),
            (_, true, false, false) => ends((&a.low, &b.high), (&a.low, &b.low)),
            (false, false, true, _) => ends((&a.low, &b.high), (&a.high, &b.high)),
            (false, false, _, true) => ends((&a.high, &b.low), (&a.low, &b.low)),
            (false, false, false, false) => {
                let low = a.low.times(&b.high).min(a.high.times(&b.low));
                let high = a.low.times(&b.low).max(a.high.times(&b.high));
                Interval { low, high }.rounded(bits)
            }
        }
    }

    /// All `x / y`; none where y may be zero.
    pub fn divide(&self, other: &Self, bits: u32) -> Option<Self> {
        if other.contains_zero() {
            return None;
        }
        // The reciprocal's ends are not rounded twice: each end is one quotient.
        let negative = other.high.is_negative();
        let (a, b) = match negative {
            true => (self.negated(), other.negated()),
            false => (self.clone(), other.clone()),
        };
        let below_for_low = if a.low.is_negative() { &b.low } else { &b.high };
        let below_for_high = if a.high.is_negative() {
            &b.high
        } else {
            &b.low
        };
        Some(Interval {
            low: a.low.divide(below_for_low, bits, Rounding::Down)?,
            high: a.high.divide(below_for_high, bits, Rounding::Up)?,
        })
    }

    /// All `x^exponent`, with 1 for the exponent zero.
    #[must_use]
    pub fn power(&self, exponent: u32, bits: u32) -> Self {
        if exponent == 0 {
            return Interval::integer(1);
        }
        let up = |x: &Dyadic| x.power(exponent, bits, Rounding::Up);
        let down = |x: &Dyadic| x.power(exponent, bits, Rounding::Down);
        if exponent.is_multiple_of(2) {
            return Interval {
                low: down(&self.smallest()),
                high: up(&self.largest()),
            };
        }
        let low = match self.low.is_negative() {
            true => up(&self.low.negated()).negated(),
            false => down(&self.low),
        };
        let high = match self.high.is_negative() {
            true => down(&self.high.negated()).negated(),
            false => up(&self.high),
        };
        Interval { low, high }
    }

    /// All roots of a degree, which increase; none where a number may be negative.
    pub fn root(&self, degree: u32, bits: u32) -> Option<Self> {
        (degree > 0 && !self.low.is_negative()).then(|| Interval {
            low: self.low.root(degree, bits, Rounding::Down),
            high: self.high.root(degree, bits, Rounding::Up),
        })
    }

    /// The image under an increasing function of which enclosures at single numbers are known.
    pub fn increasing(&self, f: impl Fn(&Dyadic) -> Option<Interval>) -> Option<Self> {
        let at_low = f(&self.low)?;
        if self.low == self.high {
            return Some(at_low);
        }
        Some(Interval {
            low: at_low.low,
            high: f(&self.high)?.high,
        })
    }

    /// Whether the ends agree to so many binary digits, or both are that close to zero beside one.
    pub fn is_narrow(&self, digits: i64) -> bool {
        if self.low == self.high {
            return true;
        }
        let size = self.largest().magnitude().unwrap_or(0);
        self.width()
            .magnitude()
            .is_none_or(|width| width <= size - digits)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn rational() -> impl Strategy<Value = BigRational> {
        (-4000i64..4000, 1i64..90).prop_map(|(n, d)| BigRational::new(n.into(), d.into()))
    }

    /// An interval and a number in it.
    fn sample() -> impl Strategy<Value = (Interval, BigRational)> {
        (rational(), rational(), 0i64..=8, 6u32..60).prop_map(|(a, b, part, bits)| {
            let inside = &a + (&b - &a) * BigRational::new(part.into(), 8.into());
            let [a, b] = [a, b].map(|end| Interval::rational(&end, bits));
            (a.hull(&b), inside)
        })
    }

    proptest! {
        #[test]
        fn what_is_within_stays_within((a, x) in sample(), (b, y) in sample(), bits in 4u32..60) {
            prop_assert!(a.contains(&x) && b.contains(&y));
            prop_assert!(a.add(&b, bits).contains(&(&x + &y)));
            prop_assert!(a.subtract(&b, bits).contains(&(&x - &y)));
            prop_assert!(a.multiply(&b, bits).contains(&(&x * &y)));
            if let Some(q) = a.divide(&b, bits) {
                prop_assert!(q.contains(&(&x / &y)));
            } else {
                prop_assert!(b.contains_zero());
            }
            for n in 0..5u32 {
                prop_assert!(a.power(n, bits).contains(&num_traits::pow(x.clone(), n as usize)));
            }
            prop_assert!(a.absolute().contains(&num_traits::Signed::abs(&x)));
        }
    }
}
