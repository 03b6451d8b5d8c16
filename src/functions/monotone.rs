//! Ranges of increasing functions of an argument whose own range is known: e^u for u < 1 is less than e.
//!
//! The argument is a sum of letters with numbers as factors, and lies between the sums of the ends of their
//! ranges. The function goes over both ends: where its value at one is rational it is taken as it is,
//! otherwise a rational number beyond it, so that the range is only ever too large.

use super::FunctionTable;
use super::enclosure::{Interval, exponential, logarithm, square_root};
use crate::model::range::{End, Numbers, Range};
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Signed, Zero};
use ratpoly::RationalFunction;

/// Binary digits of the ends.
const DIGITS: u32 = 24;
/// Ends of arguments beyond this are not looked at.
const LARGEST: i64 = 1_000;

/// Functions that grow with their argument.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(super) enum Increasing {
    Exponential,
    Logarithm,
    Root,
}

impl Increasing {
    /// The value at a rational number, where it is rational and known to be so.
    fn exactly(self, at: &BigRational) -> Option<BigRational> {
        match self {
            Increasing::Exponential => at.is_zero().then(BigRational::one),
            Increasing::Logarithm => at.is_one().then(BigRational::zero),
            Increasing::Root if at.is_negative() => None,
            Increasing::Root => {
                let root = BigRational::new(at.numer().sqrt(), at.denom().sqrt());
                (&root * &root == *at).then_some(root)
            }
        }
    }

    fn enclosed(self, at: &BigRational) -> Option<Interval> {
        match self {
            Increasing::Exponential => exponential(at),
            Increasing::Logarithm => logarithm(at),
            Increasing::Root => square_root(at),
        }
    }
}

impl FunctionTable {
    /// Narrows the range of a function's values by what is known of its argument.
    pub(super) fn narrow_by_argument(
        &self,
        range: &mut Range,
        function: Increasing,
        argument: &RationalFunction,
    ) {
        let Some(own) = self.argument_range(argument) else {
            return;
        };
        let near = |end: &End| end.value.abs() <= BigRational::from_integer(LARGEST.into());
        if let Some(end) = own.low.as_ref().filter(|end| near(end)) {
            match function.exactly(&end.value) {
                Some(value) => range.raise(value, end.included),
                None => {
                    if let Some((low, _)) = self.known_end(function, &end.value) {
                        range.raise(low, true);
                    }
                }
            }
        }
        if let Some(end) = own.high.as_ref().filter(|end| near(end)) {
            match function.exactly(&end.value) {
                Some(value) => range.lower(value, end.included),
                None => {
                    if let Some((_, high)) = self.known_end(function, &end.value) {
                        range.lower(high, true);
                    }
                }
            }
        }
    }

    /// Short rational numbers below and above a value: the same ones are asked for again and again.
    fn known_end(
        &self,
        function: Increasing,
        at: &BigRational,
    ) -> Option<(BigRational, BigRational)> {
        let key = (function, at.clone());
        if let Some(found) = self.known_signs().ends.get(&key) {
            return found.clone();
        }
        let scale = BigRational::from_integer(BigInt::one() << DIGITS);
        let found = function.enclosed(at).map(|found| {
            let low = (&found.low * &scale).floor() / &scale;
            (low, (&found.high * &scale).ceil() / &scale)
        });
        self.known_signs().ends.insert(key, found.clone());
        found
    }

    /// Between which numbers a sum of real letters with numbers as factors lies.
    fn argument_range(&self, f: &RationalFunction) -> Option<Range> {
        let below = f.denominator().as_constant()?;
        let mut sum = Range::default();
        sum.raise(BigRational::zero(), true);
        sum.lower(BigRational::zero(), true);
        for (monomial, coefficient) in f.numerator().terms() {
            let factor = BigRational::new(coefficient, below.clone());
            let exponents = monomial.exponents();
            let mut occurring = (0..exponents.len()).filter(|l| exponents[*l] > 0);
            let own = match (occurring.next(), occurring.next()) {
                (None, _) => {
                    let mut own = Range::default();
                    own.raise(BigRational::one(), true);
                    own.lower(BigRational::one(), true);
                    own
                }
                (Some(letter), None) if exponents[letter] == 1 && self.is_real_letter(letter) => {
                    self.letter_range(letter)
                }
                (Some(_), _) => return None,
            };
            let (low, high) = match factor.is_positive() {
                true => (own.low, own.high),
                false => (own.high, own.low),
            };
            let added = |sum: Option<End>, own: Option<End>| {
                let (sum, own) = (sum?, own?);
                Some(End {
                    value: &sum.value + &(&own.value * &factor),
                    included: sum.included && own.included,
                })
            };
            sum = Range {
                numbers: Numbers::Real,
                low: added(sum.low, low),
                high: added(sum.high, high),
            };
            if sum.low.is_none() && sum.high.is_none() {
                return None;
            }
        }
        Some(sum)
    }
}
