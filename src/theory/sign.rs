//! Signs of exact values: of numbers, and of functions of positive letters.

use super::error::TheoryError;
use num_rational::BigRational;
use num_traits::Zero;
use ratpoly::{Budget, RationalFunction, Region, RegionSign, sign_of_quotient_on};
use std::cmp::Ordering;

/// Elements with a sign, as far as it can be found.
pub trait Sign: std::fmt::Display {
    /// The sign: of a function, the one that it has wherever all its letters are positive; `None`
    /// where it has several or the search ends.
    fn sign(&self) -> Option<Ordering>;

    /// Whether it is positive.
    ///
    /// # Errors
    /// [`TheoryError::UnknownSign`].
    fn is_positive(&self) -> Result<bool, TheoryError> {
        match self.sign() {
            Some(sign) => Ok(sign == Ordering::Greater),
            None => Err(TheoryError::UnknownSign {
                quantity: self.to_string(),
            }),
        }
    }
}

impl Sign for BigRational {
    fn sign(&self) -> Option<Ordering> {
        Some(self.cmp(&BigRational::zero()))
    }
}

impl Sign for RationalFunction {
    fn sign(&self) -> Option<Ordering> {
        let orthant = Region::positive_orthant(self.numerator().ring().len());
        match sign_of_quotient_on(self, &orthant, &Budget::default()).ok()? {
            RegionSign::Zero => Some(Ordering::Equal),
            RegionSign::Positive => Some(Ordering::Greater),
            RegionSign::Negative => Some(Ordering::Less),
            _ => None,
        }
    }
}
