//! Which letters stand for real numbers, and between which numbers these lie.
//!
//! A root is real where its radicand is known not to be negative, a logarithm and a power where their base
//! is known to be positive, other functions where their arguments are real. What is not known to be real may
//! be complex, and nothing that is true of real numbers only is used of it.

use super::monotone::Increasing;
use super::{FunctionLetter, FunctionTable, Sign};
use crate::model::range::{End, Numbers, Range};
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Zero};
use ratpoly::RationalFunction;
use std::collections::BTreeSet;

/// Binary digits of the ends around a number.
const DIGITS: u32 = 60;

/// The letters of an element, without those inside of the arguments of functions.
fn letters_in(f: &RationalFunction) -> Vec<usize> {
    let mut letters = f.numerator().variables_occurring();
    letters.extend(f.denominator().variables_occurring());
    letters
}

impl FunctionTable {
    /// Whether an element is known to be real wherever it has a value.
    pub fn is_real(&self, f: &RationalFunction) -> bool {
        self.are_real(letters_in(f))
    }

    /// Whether a letter stands for real numbers and nothing else.
    pub(crate) fn is_real_letter(&self, letter: usize) -> bool {
        self.are_real(vec![letter])
    }

    /// Whether all these letters do: each is looked at once, however often it stands in arguments.
    fn are_real(&self, mut open: Vec<usize>) -> bool {
        let mut seen: BTreeSet<usize> = open.iter().copied().collect();
        while let Some(letter) = open.pop() {
            if letter < self.first {
                if self.ranges[letter].numbers == Numbers::Complex {
                    return false;
                }
                continue;
            }
            let argument = match self.meaning(letter) {
                Some(FunctionLetter::Pi | FunctionLetter::Bound { .. }) => continue,
                None | Some(FunctionLetter::ImaginaryUnit | FunctionLetter::Dirac(_)) => {
                    return false;
                }
                Some(
                    FunctionLetter::Exponential(u)
                    | FunctionLetter::Cosine(u)
                    | FunctionLetter::Sine(u, _),
                ) => u,
                Some(FunctionLetter::Root(p)) => {
                    let sign = self.known_sign(&p.into());
                    match sign.is_some_and(Sign::is_not_negative) {
                        true => continue,
                        false => return false,
                    }
                }
                Some(FunctionLetter::Logarithm(p)) => match self.is_positive(&p.into()) {
                    true => continue,
                    false => return false,
                },
                Some(FunctionLetter::Power(base, exponent)) => {
                    match self.is_positive(&base.into()) {
                        true => exponent,
                        false => return false,
                    }
                }
            };
            let inside = letters_in(&argument).into_iter();
            open.extend(inside.filter(|l| seen.insert(*l)));
        }
        true
    }

    /// Whether a letter is known to be positive.
    pub fn is_positive_letter(&self, letter: usize) -> bool {
        if letter < self.first {
            return self.ranges[letter].is_positive();
        }
        match self.meaning(letter) {
            Some(FunctionLetter::Pi | FunctionLetter::Bound { positive: true, .. }) => true,
            Some(FunctionLetter::Exponential(_) | FunctionLetter::Power(..)) => {
                self.is_real_letter(letter)
            }
            Some(FunctionLetter::Root(radicand)) => self.is_positive(&radicand.into()),
            Some(FunctionLetter::Logarithm(_)) => self.letter_range(letter).is_positive(),
            None
            | Some(
                FunctionLetter::ImaginaryUnit
                | FunctionLetter::Cosine(_)
                | FunctionLetter::Sine(..)
                | FunctionLetter::Dirac(_)
                | FunctionLetter::Bound {
                    positive: false, ..
                },
            ) => false,
        }
    }

    /// Whether a letter stands for one number: no symbol and no variable stands behind it.
    pub(super) fn is_number(&self, letter: usize) -> bool {
        self.letters_behind(&self.variable(letter))
            .into_iter()
            .all(|l| {
                l >= self.first
                    && !matches!(
                        self.meaning(l),
                        None | Some(FunctionLetter::Bound { .. } | FunctionLetter::Dirac(_))
                    )
            })
    }

    /// The numbers between which the values of a real letter lie.
    pub(crate) fn letter_range(&self, letter: usize) -> Range {
        if letter < self.first {
            return self.ranges[letter].clone();
        }
        let Some(meaning) = self.meaning(letter) else {
            return Range::default();
        };
        if !matches!(meaning, FunctionLetter::ImaginaryUnit)
            && self.is_number(letter)
            && let Some(range) = self.around(letter)
        {
            return range;
        }
        let zero = BigRational::zero;
        let one = BigRational::one;
        match meaning {
            FunctionLetter::Exponential(u) => {
                let mut range = self.power_range(self.known_sign(&u));
                self.narrow_by_argument(&mut range, Increasing::Exponential, &u);
                range
            }
            FunctionLetter::Power(base, exponent) => {
                let above = self.known_sign(&(&RationalFunction::from(base) - &self.integer(1)));
                let product = above
                    .zip(self.known_sign(&exponent))
                    .map(|(b, e)| b.times(e));
                self.power_range(product)
            }
            FunctionLetter::Logarithm(p) => {
                let mut range = Range::default();
                let p = RationalFunction::from(p);
                self.narrow_by_argument(&mut range, Increasing::Logarithm, &p);
                match self.known_sign(&(&p - &self.integer(1))) {
                    Some(Sign::Positive) => range.raise(zero(), false),
                    Some(Sign::NotNegative) => range.raise(zero(), true),
                    Some(Sign::Negative) => range.lower(zero(), false),
                    Some(Sign::NotPositive) => range.lower(zero(), true),
                    Some(Sign::Zero) | None => {}
                }
                range
            }
            FunctionLetter::Cosine(_) | FunctionLetter::Sine(..) => Range {
                low: Some(End {
                    value: -one(),
                    included: true,
                }),
                high: Some(End {
                    value: one(),
                    included: true,
                }),
                ..Range::default()
            },
            FunctionLetter::Root(p) => {
                let mut range = Range::default();
                let p = RationalFunction::from(p);
                range.raise(zero(), !self.is_positive(&p));
                self.narrow_by_argument(&mut range, Increasing::Root, &p);
                range
            }
            FunctionLetter::Bound { positive: true, .. } => Range::positive(),
            FunctionLetter::Bound {
                positive: false, ..
            }
            | FunctionLetter::Pi
            | FunctionLetter::ImaginaryUnit
            | FunctionLetter::Dirac(_) => Range::default(),
        }
    }

    /// The values of e^u where the sign of u is known.
    fn power_range(&self, sign: Option<Sign>) -> Range {
        let mut range = Range::positive();
        let one = BigRational::one();
        match sign {
            Some(Sign::Positive) => range.raise(one, false),
            Some(Sign::NotNegative) => range.raise(one, true),
            Some(Sign::Negative) => range.lower(one, false),
            Some(Sign::NotPositive) => range.lower(one, true),
            Some(Sign::Zero) | None => {}
        }
        range
    }

    /// Rational numbers below and above a number.
    fn around(&self, letter: usize) -> Option<Range> {
        let point = vec![None; self.ring.len()];
        let interval = self.enclosure(&self.variable(letter), &point)?;
        let scale = BigRational::from_integer(BigInt::one() << DIGITS);
        let mut range = Range::default();
        range.raise((&interval.low * &scale).floor() / &scale, true);
        range.lower((&interval.high * &scale).ceil() / &scale, true);
        Some(range)
    }
}
