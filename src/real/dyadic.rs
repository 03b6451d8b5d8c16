//! Numbers m * 2^e with integers m and e: the ends of intervals.
//!
//! Sums and products are exact before they are rounded, downwards or upwards, to a number of binary
//! digits. Invariant: m is odd, or m and e are zero, so that equal numbers are equal data.

use num_bigint::{BigInt, Sign};
use num_integer::Integer;
use num_rational::BigRational;
use num_traits::{One, Signed, Zero};
use std::cmp::Ordering;

/// Digits beyond the precision below which an addend only says in which direction to round.
const SLACK: i64 = 8;

/// A number `mantissa * 2^exponent`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Dyadic {
    mantissa: BigInt,
    exponent: i64,
}

/// Where a rounded number may lie.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Rounding {
    /// At the exact one or below it.
    Down,
    /// At the exact one or above it.
    Up,
}

impl Rounding {
    fn reversed(self) -> Self {
        match self {
            Rounding::Down => Rounding::Up,
            Rounding::Up => Rounding::Down,
        }
    }
}

impl Dyadic {
    /// `mantissa * 2^exponent`.
    pub fn new(mantissa: BigInt, exponent: i64) -> Self {
        match mantissa.trailing_zeros() {
            None => Dyadic {
                mantissa: BigInt::zero(),
                exponent: 0,
            },
            Some(0) => Dyadic { mantissa, exponent },
            Some(zeros) => Dyadic {
                mantissa: mantissa >> zeros,
                exponent: exponent + i64::try_from(zeros).unwrap_or(0),
            },
        }
    }

    /// Zero.
    pub fn zero() -> Self {
        Dyadic {
            mantissa: BigInt::zero(),
            exponent: 0,
        }
    }

    /// An integer.
    pub fn integer(n: i64) -> Self {
        Dyadic::new(n.into(), 0)
    }

    /// `2^exponent`.
    pub fn power_of_two(exponent: i64) -> Self {
        Dyadic {
            mantissa: BigInt::one(),
            exponent,
        }
    }

    /// The odd factor.
    pub fn mantissa(&self) -> &BigInt {
        &self.mantissa
    }

    /// The exponent of two.
    pub fn exponent(&self) -> i64 {
        self.exponent
    }

    /// Whether it is zero.
    pub fn is_zero(&self) -> bool {
        self.mantissa.is_zero()
    }

    /// Whether it is greater than zero.
    pub fn is_positive(&self) -> bool {
        self.mantissa.is_positive()
    }

    /// Whether it is less than zero.
    pub fn is_negative(&self) -> bool {
        self.mantissa.is_negative()
    }

    /// The k with `2^(k-1) <= |x| < 2^k`; none for zero.
    pub fn magnitude(&self) -> Option<i64> {
        (!self.is_zero()).then(|| self.length() + self.exponent)
    }

    fn length(&self) -> i64 {
        i64::try_from(self.mantissa.bits()).unwrap_or(i64::MAX / 4)
    }

    /// `-x`.
    #[must_use]
    pub fn negated(&self) -> Self {
        Dyadic {
            mantissa: -&self.mantissa,
            exponent: self.exponent,
        }
    }

    /// `|x|`.
    #[must_use]
    pub fn absolute(&self) -> Self {
        Dyadic {
            mantissa: self.mantissa.abs(),
            exponent: self.exponent,
        }
    }

    /// `2^by x`.
    #[must_use]
    pub fn scaled(&self, by: i64) -> Self {
        if self.is_zero() {
            return self.clone();
        }
        Dyadic {
            mantissa: self.mantissa.clone(),
            exponent: self.exponent + by,
        }
    }

    /// The nearest number with at most so many binary digits in a direction.
    #[must_use]
    pub fn rounded(self, bits: u32, rounding: Rounding) -> Self {
        if self.length() <= i64::from(bits) {
            return self;
        }
        Dyadic::shortened(self.mantissa, self.exponent, bits, rounding)
    }

    /// The exact sum.
    #[must_use]
    pub fn plus(&self, other: &Self) -> Self {
        if self.is_zero() {
            return other.clone();
        }
        if other.is_zero() {
            return self.clone();
        }
        let gap = self.exponent - other.exponent;
        match gap.cmp(&0) {
            Ordering::Equal => Dyadic::new(&self.mantissa + &other.mantissa, self.exponent),
            Ordering::Greater => {
                Dyadic::new((&self.mantissa << gap) + &other.mantissa, other.exponent)
            }
            Ordering::Less => {
                Dyadic::new(&self.mantissa + (&other.mantissa << -gap), self.exponent)
            }
        }
    }

    /// The rounded sum; an addend that is too small to matter is replaced by one on the safe side.
    #[must_use]
    pub fn add(&self, other: &Self, bits: u32, rounding: Rounding) -> Self {
        let (Some(a), Some(b)) = (self.magnitude(), other.magnitude()) else {
            return self.plus(other).rounded(bits, rounding);
        };
        let (large, small, top) = if a >= b {
            (self, other, a)
        } else {
            (other, self, b)
        };
        let least = top - i64::from(bits) - SLACK;
        if a.min(b) < least {
            let tiny = Dyadic::power_of_two(least);
            let stand_in = match (rounding, small.is_positive()) {
                (Rounding::Down, true) | (Rounding::Up, false) => Dyadic::zero(),
                (Rounding::Down, false) => tiny.negated(),
                (Rounding::Up, true) => tiny,
            };
            let large = large.clone().rounded(bits + 4, rounding);
            return large.plus(&stand_in).rounded(bits, rounding);
        }
        self.plus(other).rounded(bits, rounding)
    }

    /// The exact product.
    #[must_use]
    pub fn times(&self, other: &Self) -> Self {
        Dyadic::new(
            &self.mantissa * &other.mantissa,
            self.exponent + other.exponent,
        )
    }

    /// The rounded quotient; none for the divisor zero.
    pub fn divide(&self, other: &Self, bits: u32, rounding: Rounding) -> Option<Self> {
        if other.is_zero() {
            return None;
        }
        let shift = (i64::from(bits) + 2 + other.length() - self.length()).max(0);
        let (above, below) = match other.is_negative() {
            true => (-(&self.mantissa << shift), -&other.mantissa),
            false => (&self.mantissa << shift, other.mantissa.clone()),
        };
        let quotient = match rounding {
            Rounding::Down => above.div_floor(&below),
            Rounding::Up => above.div_ceil(&below),
        };
        let exponent = self.exponent - other.exponent - shift;
        Some(Dyadic::shortened(quotient, exponent, bits, rounding))
    }

    /// A rational number, rounded.
    pub fn from_rational(x: &BigRational, bits: u32, rounding: Rounding) -> Self {
        let above = Dyadic::new(x.numer().clone(), 0);
        if x.denom().is_one() {
            return above.rounded(bits, rounding);
        }
        let below = Dyadic::new(x.denom().clone(), 0);
        // A denominator is not zero.
        above.divide(&below, bits, rounding).unwrap_or(above)
    }

    /// The number that a rational one is, where it is one with so few digits.
    pub fn exactly(x: &BigRational, bits: u32) -> Option<Self> {
        let below = x.denom().trailing_zeros()?;
        if x.denom().bits() != below + 1 || x.numer().bits() > u64::from(bits) {
            return None;
        }
        Some(Dyadic::new(x.numer().clone(), -i64::try_from(below).ok()?))
    }

    /// The number as a rational one.
    pub fn to_rational(&self) -> BigRational {
        match u64::try_from(self.exponent) {
            Ok(up) => BigRational::from_integer(&self.mantissa << up),
            Err(_) => BigRational::new_raw(
                self.mantissa.clone(),
                BigInt::one() << self.exponent.unsigned_abs(),
            ),
        }
    }

    /// How it compares with a rational number; where their sizes tell, nothing long is formed.
    pub fn compared_with(&self, x: &BigRational) -> Ordering {
        let sign = |positive: bool, negative: bool| i8::from(positive) - i8::from(negative);
        let own = sign(self.is_positive(), self.is_negative());
        let other = sign(x.is_positive(), x.is_negative());
        if own != other || own == 0 {
            return own.cmp(&other);
        }
        let bits = |n: &BigInt| i64::try_from(n.bits()).unwrap_or(i64::MAX / 4);
        // 2^(size - 1) < |x| < 2^(size + 1).
        let size = bits(x.numer()) - bits(x.denom());
        let larger = match self.magnitude() {
            Some(own) if own - 1 > size => Ordering::Greater,
            Some(own) if own < size - 1 => Ordering::Less,
            _ => return self.to_rational().cmp(x),
        };
        if own > 0 { larger } else { larger.reverse() }
    }

    /// The largest integer not above `x * 2^places`.
    pub fn fixed(&self, places: i64) -> BigInt {
        let shift = self.exponent + places;
        if shift >= 0 {
            &self.mantissa << shift
        } else {
            &self.mantissa >> -shift
        }
    }

    /// The integer part of the root of a number that is not negative, rounded.
    pub fn root(&self, degree: u32, bits: u32, rounding: Rounding) -> Self {
        if self.is_zero() || degree == 0 {
            return Dyadic::zero();
        }
        let d = i64::from(degree);
        // As many digits as are needed, and an exponent that the degree divides.
        let mut shift = ((i64::from(bits) + 2) * d - self.length()).max(0);
        while (self.exponent - shift).rem_euclid(d) != 0 {
            shift += 1;
        }
        let scaled = &self.mantissa << shift;
        let root = scaled.nth_root(degree);
        let exact = root.pow(degree) == scaled;
        let root = match rounding {
            Rounding::Up if !exact => root + 1,
            _ => root,
        };
        Dyadic::new(root, (self.exponent - shift).div_euclid(d)).rounded(bits, rounding)
    }

    /// The rounded product.
    #[must_use]
    pub fn multiply(&self, other: &Self, bits: u32, rounding: Rounding) -> Self {
        Dyadic::shortened(
            &self.mantissa * &other.mantissa,
            self.exponent + other.exponent,
            bits,
            rounding,
        )
    }

    /// `mantissa * 2^exponent`, rounded.
    fn shortened(mantissa: BigInt, exponent: i64, bits: u32, rounding: Rounding) -> Self {
        let length = i64::try_from(mantissa.bits()).unwrap_or(i64::MAX / 4);
        let excess = length - i64::from(bits);
        if excess <= 0 {
            return Dyadic::new(mantissa, exponent);
        }
        // `>>` on integers rounds down, for negative ones too.
        let kept = match rounding {
            Rounding::Down => mantissa >> excess,
            Rounding::Up => -((-mantissa) >> excess),
        };
        Dyadic::new(kept, exponent + excess)
    }

    /// A rounded power with a natural exponent of a number that is not negative.
    #[must_use]
    pub fn power(&self, mut exponent: u32, bits: u32, rounding: Rounding) -> Self {
        let mut square = self.clone();
        let mut result = Dyadic::integer(1);
        while exponent > 0 {
            if exponent & 1 == 1 {
                result = result.multiply(&square, bits, rounding);
            }
            exponent >>= 1;
            if exponent > 0 {
                square = square.multiply(&square, bits, rounding);
            }
        }
        result
    }

    /// The rounded difference.
    #[must_use]
    pub fn subtract(&self, other: &Self, bits: u32, rounding: Rounding) -> Self {
        let negative = self.negated();
        negative.add(other, bits, rounding.reversed()).negated()
    }
}

impl PartialOrd for Dyadic {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Dyadic {
    fn cmp(&self, other: &Self) -> Ordering {
        let (left, right) = (self.mantissa.sign(), other.mantissa.sign());
        if left != right {
            return left.cmp(&right);
        }
        let by_size = match (self.magnitude(), other.magnitude()) {
            (Some(a), Some(b)) => a.cmp(&b),
            _ => return Ordering::Equal,
        };
        let size = by_size.then_with(|| {
            let gap = self.exponent - other.exponent;
            let (a, b) = (self.mantissa.magnitude(), other.mantissa.magnitude());
            match gap.cmp(&0) {
                Ordering::Equal => a.cmp(b),
                Ordering::Greater => (a << gap).cmp(b),
                Ordering::Less => a.cmp(&(b << -gap)),
            }
        });
        match left {
            Sign::Minus => size.reverse(),
            Sign::NoSign | Sign::Plus => size,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn dyadic() -> impl Strategy<Value = Dyadic> {
        (any::<i64>(), -90i64..90).prop_map(|(m, e)| Dyadic::new(m.into(), e))
    }

    proptest! {
        #[test]
        fn arithmetic_is_that_of_rational_numbers(a in dyadic(), b in dyadic(), bits in 2u32..80) {
            let (x, y) = (a.to_rational(), b.to_rational());
            prop_assert_eq!(a.plus(&b).to_rational(), &x + &y);
            prop_assert_eq!(a.times(&b).to_rational(), &x * &y);
            prop_assert_eq!(a.cmp(&b), x.cmp(&y));
            let sum = [Rounding::Down, Rounding::Up].map(|r| a.add(&b, bits, r).to_rational());
            prop_assert!(sum[0] <= &x + &y && &x + &y <= sum[1]);
            let difference = [Rounding::Down, Rounding::Up].map(|r| a.subtract(&b, bits, r).to_rational());
            prop_assert!(difference[0] <= &x - &y && &x - &y <= difference[1]);
            if !b.is_zero() {
                let q = [Rounding::Down, Rounding::Up].map(|r| a.divide(&b, bits, r).unwrap().to_rational());
                prop_assert!(q[0] <= &x / &y && &x / &y <= q[1]);
            }
        }

        #[test]
        fn roots_are_between(a in dyadic(), degree in 1u32..6, bits in 4u32..80) {
            let a = a.absolute();
            let low = a.root(degree, bits, Rounding::Down);
            let high = a.root(degree, bits, Rounding::Up);
            let power = |x: &Dyadic| num_traits::pow(x.to_rational(), degree as usize);
            prop_assert!(power(&low) <= a.to_rational() && a.to_rational() <= power(&high));
        }

        #[test]
        fn far_addends_round_outwards(a in dyadic(), b in dyadic(), far in 200i64..2000) {
            let b = b.scaled(-far);
            let exact = a.plus(&b);
            prop_assert!(a.add(&b, 40, Rounding::Down) <= exact);
            prop_assert!(exact <= a.add(&b, 40, Rounding::Up));
        }
    }
}
