//! Real numbers as they are computed with: rational ones exactly as long as they are short, all
//! others within intervals.
//!
//! Rational results keep equality decidable at rational points; when numerator and denominator
//! outgrow the precision, an interval takes over. Every operation is given the binary digits to keep.

use super::dyadic::Dyadic;
use super::fraction;
use super::functions;
use super::interval::Interval;
use super::series;
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Signed, Zero};
use std::cmp::Ordering;

/// The largest exponent of a power that is multiplied out.
const LARGEST_EXPONENT: u32 = 10_000;
/// Numbers beyond two to plus or minus this are refused, so that exponents cannot overflow.
const LARGEST_MAGNITUDE: i64 = 1 << 40;

/// A real number.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Real {
    /// This rational number.
    Exact(BigRational),
    /// Some number within.
    Enclosed(Interval),
}

/// How many binary digits numerator and denominator have together while a number is kept exactly.
fn longest(bits: u32) -> u64 {
    u64::from(bits)
}

impl Real {
    /// An integer.
    pub fn integer(n: i64) -> Self {
        Real::Exact(BigRational::from_integer(n.into()))
    }

    /// Zero.
    pub fn zero() -> Self {
        Real::integer(0)
    }

    /// A rational number, kept exactly.
    pub fn rational(x: BigRational) -> Self {
        Real::Exact(x)
    }

    fn settled(x: BigRational, bits: u32) -> Self {
        let length = x.numer().bits() + x.denom().bits();
        if length > longest(bits) {
            Real::Enclosed(Interval::rational(&x, bits))
        } else {
            Real::Exact(x)
        }
    }

    fn enclosed(x: Interval) -> Self {
        match x.single() {
            Some(single) if single.exponent().abs() < 64 && single.mantissa().bits() < 64 => {
                Real::Exact(single.to_rational())
            }
            _ => Real::Enclosed(x),
        }
    }

    /// An interval around it.
    pub fn interval(&self, bits: u32) -> Interval {
        match self {
            Real::Exact(x) => Interval::rational(x, bits),
            Real::Enclosed(x) => x.clone(),
        }
    }

    /// The number, where it is known exactly.
    pub fn exact(&self) -> Option<&BigRational> {
        match self {
            Real::Exact(x) => Some(x),
            Real::Enclosed(_) => None,
        }
    }

    /// Whether it certainly is zero.
    pub fn is_zero(&self) -> bool {
        self.sign() == Some(Ordering::Equal)
    }

    /// Whether it certainly is one.
    pub fn is_one(&self) -> bool {
        matches!(self, Real::Exact(x) if x.is_one())
    }

    /// Whether it may be zero.
    pub fn may_vanish(&self) -> bool {
        match self {
            Real::Exact(x) => x.is_zero(),
            Real::Enclosed(x) => x.contains_zero(),
        }
    }

    /// Its sign, where that is certain.
    pub fn sign(&self) -> Option<Ordering> {
        match self {
            Real::Exact(x) => Some(x.cmp(&BigRational::zero())),
            Real::Enclosed(x) => x.sign(),
        }
    }

    /// Whether the two certainly differ.
    pub fn is_apart_from(&self, other: &Self) -> bool {
        match (self, other) {
            (Real::Exact(a), Real::Exact(b)) => a != b,
            (Real::Enclosed(a), Real::Enclosed(b)) => a.is_apart_from(b),
            (Real::Exact(a), Real::Enclosed(b)) | (Real::Enclosed(b), Real::Exact(a)) => {
                !b.contains(a)
            }
        }
    }

    /// How it compares with another, where that is certain.
    pub fn compared(&self, other: &Self) -> Option<Ordering> {
        match (self, other) {
            (Real::Exact(a), Real::Exact(b)) => Some(a.cmp(b)),
            (Real::Exact(a), Real::Enclosed(b)) => {
                if b.low().compared_with(a) == Ordering::Greater {
                    Some(Ordering::Less)
                } else if b.high().compared_with(a) == Ordering::Less {
                    Some(Ordering::Greater)
                } else {
                    None
                }
            }
            (Real::Enclosed(_), Real::Exact(_)) => other.compared(self).map(Ordering::reverse),
            (Real::Enclosed(a), Real::Enclosed(b)) => {
                if a.high() < b.low() {
                    Some(Ordering::Less)
                } else if a.low() > b.high() {
                    Some(Ordering::Greater)
                } else {
                    a.single().filter(|s| b.single() == Some(s))?;
                    Some(Ordering::Equal)
                }
            }
        }
    }

    /// Whether it is known to so many binary digits.
    pub fn is_narrow(&self, digits: i64) -> bool {
        match self {
            Real::Exact(_) => true,
            Real::Enclosed(x) => x.is_narrow(digits),
        }
    }

    /// Whether it is neither so large nor so small that computing with it could overflow.
    pub fn is_moderate(&self) -> bool {
        match self {
            Real::Exact(_) => true,
            Real::Enclosed(x) => [x.low(), x.high()]
                .into_iter()
                .all(|end| end.magnitude().is_none_or(|m| m.abs() < LARGEST_MAGNITUDE)),
        }
    }

    /// About how many binary digits it takes to write it before and after the point.
    pub fn length(&self) -> u64 {
        match self {
            Real::Exact(x) => x.numer().bits().max(x.denom().bits()),
            Real::Enclosed(x) => {
                let ends = [x.low(), x.high()].into_iter();
                let sizes = ends.filter_map(|end| end.magnitude());
                sizes.map(i64::unsigned_abs).max().unwrap_or(0)
            }
        }
    }

    /// `-x`.
    #[must_use]
    pub fn negated(&self) -> Self {
        match self {
            Real::Exact(x) => Real::Exact(-x),
            Real::Enclosed(x) => Real::Enclosed(x.negated()),
        }
    }

    /// `x + y`.
    #[must_use]
    pub fn add(&self, other: &Self, bits: u32) -> Self {
        match (self, other) {
            (Real::Exact(a), b) if a.is_zero() => b.clone(),
            (a, Real::Exact(b)) if b.is_zero() => a.clone(),
            (Real::Exact(a), Real::Exact(b)) => Real::settled(fraction::sum(a, b), bits),
            _ => Real::Enclosed(self.interval(bits).add(&other.interval(bits), bits)),
        }
    }

    /// `x - y`.
    #[must_use]
    pub fn subtract(&self, other: &Self, bits: u32) -> Self {
        self.add(&other.negated(), bits)
    }

    /// `x y`.
    #[must_use]
    pub fn multiply(&self, other: &Self, bits: u32) -> Self {
        match (self, other) {
            (Real::Exact(a), _) if a.is_zero() => Real::zero(),
            (_, Real::Exact(b)) if b.is_zero() => Real::zero(),
            (Real::Exact(a), b) if a.is_one() => b.clone(),
            (a, Real::Exact(b)) if b.is_one() => a.clone(),
            (Real::Exact(a), Real::Exact(b)) => Real::settled(fraction::product(a, b), bits),
            _ => Real::Enclosed(self.interval(bits).multiply(&other.interval(bits), bits)),
        }
    }

    /// `x / y`; none where y may be zero.
    pub fn divide(&self, other: &Self, bits: u32) -> Option<Self> {
        match (self, other) {
            (_, y) if y.may_vanish() => None,
            (Real::Exact(a), _) if a.is_zero() => Some(Real::zero()),
            (Real::Exact(a), Real::Exact(b)) => Some(Real::settled(fraction::quotient(a, b), bits)),
            _ => Some(Real::Enclosed(
                self.interval(bits).divide(&other.interval(bits), bits)?,
            )),
        }
    }

    /// `x^n` for a natural number n, with 1 for n = 0; none beyond the limit.
    pub fn power(&self, n: u32, bits: u32) -> Option<Self> {
        if n > LARGEST_EXPONENT {
            return None;
        }
        let small =
            |x: &BigRational| (x.numer().bits() + x.denom().bits()) * u64::from(n) <= longest(bits);
        match self {
            Real::Exact(x) if x.is_zero() || x.is_one() && n > 0 => Some(if n == 0 {
                Real::integer(1)
            } else {
                self.clone()
            }),
            Real::Exact(x) if small(x) => Some(Real::Exact(num_traits::pow(x.clone(), n as usize))),
            _ => Some(Real::Enclosed(self.interval(bits).power(n, bits))),
        }
    }

    /// The root of a degree of a number that is not negative; none where it may be.
    pub fn root(&self, degree: u32, bits: u32) -> Option<Self> {
        if let Real::Exact(x) = self
            && !x.is_negative()
        {
            let roots = [x.numer(), x.denom()].map(|n| (n, n.nth_root(degree)));
            if roots.iter().all(|(n, root)| root.pow(degree) == **n) {
                let [(_, above), (_, below)] = roots;
                return Some(Real::Exact(BigRational::new(above, below)));
            }
        }
        Some(Real::enclosed(self.interval(bits + 8).root(degree, bits)?))
    }

    /// `|x|`.
    #[must_use]
    pub fn absolute(&self) -> Self {
        match self {
            Real::Exact(x) => Real::Exact(x.abs()),
            Real::Enclosed(x) => Real::Enclosed(x.absolute()),
        }
    }

    fn by(&self, bits: u32, f: fn(&Interval, u32) -> Option<Interval>) -> Option<Self> {
        f(&self.interval(bits + 8), bits).map(Real::enclosed)
    }

    /// e^x; none for too large a number.
    pub fn exponential(&self, bits: u32) -> Option<Self> {
        self.by(bits, functions::exponential)
    }

    /// ln x; none where x may not be positive.
    pub fn logarithm(&self, bits: u32) -> Option<Self> {
        self.by(bits, functions::logarithm)
    }

    /// cos x and sin x; none for too large an angle.
    pub fn cosine_and_sine(&self, bits: u32) -> Option<(Self, Self)> {
        let (cosine, sine) = functions::cosine_and_sine(&self.interval(bits + 8), bits)?;
        Some((Real::enclosed(cosine), Real::enclosed(sine)))
    }

    /// tan x; none where a pole may lie there.
    pub fn tangent(&self, bits: u32) -> Option<Self> {
        self.by(bits, functions::tangent)
    }

    /// arctan x.
    pub fn arctangent(&self, bits: u32) -> Option<Self> {
        self.by(bits, functions::arctangent)
    }

    /// cosh x and sinh x; none for too large a number.
    pub fn hyperbolic(&self, bits: u32) -> Option<(Self, Self)> {
        Some((
            self.by(bits, functions::hyperbolic_cosine)?,
            self.by(bits, functions::hyperbolic_sine)?,
        ))
    }

    /// tanh x; none for too large a number.
    pub fn hyperbolic_tangent(&self, bits: u32) -> Option<Self> {
        self.by(bits, functions::hyperbolic_tangent)
    }

    /// The circle's constant.
    pub fn pi(bits: u32) -> Self {
        Real::Enclosed(series::pi(bits))
    }

    /// The narrowest interval with both.
    #[must_use]
    pub fn hull(&self, other: &Self, bits: u32) -> Self {
        if self == other {
            return self.clone();
        }
        Real::Enclosed(self.interval(bits).hull(&other.interval(bits)))
    }

    /// Zero, or any number up to this one's largest absolute value in either direction.
    #[must_use]
    pub fn spread(&self, bits: u32) -> Self {
        let largest = self.interval(bits).largest();
        Real::Enclosed(Interval::between(largest.negated(), largest))
    }

    /// The integer that it certainly is.
    pub fn to_integer(&self) -> Option<BigInt> {
        self.exact()
            .filter(|x| x.is_integer())
            .map(BigRational::to_integer)
    }

    /// A short rational number within or near the interval.
    pub fn middle(&self, bits: u32) -> BigRational {
        match self {
            Real::Exact(x) => x.clone(),
            Real::Enclosed(x) => x.middle(bits).to_rational(),
        }
    }

    /// The upper end of its absolute value.
    pub fn largest(&self, bits: u32) -> Dyadic {
        self.interval(bits).largest()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn ratio(n: i64, d: i64) -> Real {
        Real::Exact(BigRational::new(n.into(), d.into()))
    }

    #[test]
    fn rational_numbers_stay_exact() {
        let third = ratio(1, 3);
        let sum = third.add(&third, 64).add(&third, 64);
        assert!(sum.is_one());
        assert_eq!(ratio(9, 4).root(2, 64), Some(ratio(3, 2)));
        assert_eq!(ratio(-8, 27).root(2, 64), None);
        assert_eq!(Real::zero().exponential(64), Some(Real::integer(1)));
        assert_eq!(ratio(2, 3).power(0, 64), Some(Real::integer(1)));
        assert_eq!(Real::zero().power(0, 64), Some(Real::integer(1)));
        assert!(Real::integer(3).power(5000, 64).unwrap().exact().is_none());
    }

    #[test]
    fn comparisons_are_certain() {
        let root = Real::integer(2).root(2, 64).unwrap();
        assert_eq!(root.compared(&ratio(3, 2)), Some(Ordering::Less));
        assert_eq!(ratio(7, 5).compared(&root), Some(Ordering::Less));
        let square = root.multiply(&root, 64);
        assert_eq!(square.compared(&Real::integer(2)), None);
        assert!(!square.is_apart_from(&Real::integer(2)));
        assert!(square.subtract(&Real::integer(2), 64).may_vanish());
    }
}
