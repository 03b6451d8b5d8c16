//! Sturm sequences (Sturm 1829; Basu, Pollack, Roy, Algorithms in Real Algebraic Geometry, section 2.2).

use super::dense;
use crate::error::Error;
use crate::polynomial::Polynomial;
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{Signed, Zero};
use std::cmp::Ordering;

/// An end of an interval of real numbers.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Bound {
    /// Below every number.
    NegativeInfinity,
    /// A rational number.
    Finite(BigRational),
    /// Above every number.
    PositiveInfinity,
}

impl From<BigRational> for Bound {
    fn from(value: BigRational) -> Self {
        Bound::Finite(value)
    }
}

impl From<i64> for Bound {
    fn from(value: i64) -> Self {
        Bound::Finite(BigRational::from_integer(value.into()))
    }
}

impl Bound {
    pub(crate) fn compare(&self, other: &Bound) -> Ordering {
        let rank = |b: &Bound| match b {
            Bound::NegativeInfinity => -1,
            Bound::Finite(_) => 0,
            Bound::PositiveInfinity => 1,
        };
        match (self, other) {
            (Bound::Finite(a), Bound::Finite(b)) => a.cmp(b),
            _ => rank(self).cmp(&rank(other)),
        }
    }
}

/// The Sturm sequence of a nonzero polynomial in one variable: `f`, its derivative, and the negated
/// remainders, each primitive. It counts the distinct real roots in any interval.
#[derive(Debug, Clone)]
pub struct SturmSequence {
    sequence: Vec<Vec<BigInt>>,
}

impl SturmSequence {
    /// The sequence of a polynomial in which only this variable occurs. The zero polynomial has every
    /// number as its root: [`Error::Unsupported`].
    pub fn new(f: &Polynomial, variable: usize) -> Result<Self, Error> {
        let f = dense::from_polynomial(f, variable)?;
        if f.is_empty() {
            return Err(Error::Unsupported("every number is a root of zero"));
        }
        Ok(Self::of_dense(&f))
    }

    pub(crate) fn of_dense(f: &[BigInt]) -> Self {
        let mut first = dense::square_free_part(f);
        dense::make_primitive(&mut first);
        let mut next = dense::derivative(&first);
        dense::make_primitive(&mut next);
        let mut sequence = vec![first];
        while !next.is_empty() {
            let last = &sequence[sequence.len() - 1];
            let mut rest = dense::positive_remainder(last, &next);
            rest.iter_mut().for_each(|c| *c = -&*c);
            sequence.push(std::mem::replace(&mut next, rest));
        }
        SturmSequence { sequence }
    }

    /// The number of sign changes of the sequence at a number or an infinity.
    pub fn sign_changes(&self, at: &Bound) -> usize {
        let sign = |f: &Vec<BigInt>| {
            let lead = f.last().map_or(Ordering::Equal, |c| c.cmp(&BigInt::zero()));
            match at {
                Bound::Finite(x) => dense::sign_at(f, x),
                Bound::PositiveInfinity => lead,
                Bound::NegativeInfinity if f.len().is_multiple_of(2) => lead.reverse(),
                Bound::NegativeInfinity => lead,
            }
        };
        dense::sign_changes(self.sequence.iter().map(sign))
    }

    /// The number of distinct real roots above `low` and not above `high`; zero if `low >= high`.
    pub fn count_half_open(&self, low: &Bound, high: &Bound) -> usize {
        if low.compare(high).is_ge() {
            return 0;
        }
        self.sign_changes(low) - self.sign_changes(high)
    }

    /// The number of distinct real roots strictly between the ends.
    pub fn count_open(&self, low: &Bound, high: &Bound) -> usize {
        self.count_half_open(low, high)
            - usize::from(low.compare(high).is_lt() && self.vanishes_at(high))
    }

    /// The number of distinct real roots between the ends, ends included.
    pub fn count_closed(&self, low: &Bound, high: &Bound) -> usize {
        match low.compare(high) {
            Ordering::Greater => 0,
            Ordering::Equal => usize::from(self.vanishes_at(low)),
            Ordering::Less => self.count_half_open(low, high) + usize::from(self.vanishes_at(low)),
        }
    }

    /// The number of distinct real roots.
    pub fn count_all(&self) -> usize {
        self.count_half_open(&Bound::NegativeInfinity, &Bound::PositiveInfinity)
    }

    fn vanishes_at(&self, bound: &Bound) -> bool {
        match bound {
            Bound::Finite(x) => dense::sign_at(&self.sequence[0], x).is_eq(),
            _ => false,
        }
    }
}

/// A bound on the absolute values of the complex roots: a power of two (Knuth, TAOCP 2, exercise
/// 4.6.2-20: twice the largest `|a_(n-k) / a_n|^(1/k)`).
pub(crate) fn root_bound(f: &[BigInt]) -> BigInt {
    let n = f.len() - 1;
    let lead = f[n].abs().bits();
    let mut exponent = 0_u64;
    for (k, c) in (1..).zip(f[..n].iter().rev()) {
        if !c.is_zero() {
            // |c / lead| < 2^(bits(c) - bits(lead) + 1)
            let bits = (c.bits() + 1).saturating_sub(lead);
            exponent = exponent.max(bits.div_ceil(k));
        }
    }
    BigInt::from(1) << (exponent + 1)
}
