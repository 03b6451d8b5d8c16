//! Indices and exponents: the integers that they spell, with the values of bound letters.

use super::{Evaluator, Failure, FailureKind, LARGEST_EXPONENT};
use crate::domain::Domain;
use crate::expr::{Expr, Name, integer};

impl<D: Domain> Evaluator<'_, D> {
    /// The integer that the bound of a sum evaluates to; another bound makes nothing wrong.
    pub(super) fn bound_of_sum(&self, expr: &Expr) -> Result<i64, Failure> {
        self.integer(expr).map_err(|failure| {
            if let FailureKind::Exponent { exponent, .. } = &failure.kind {
                let what = format!("a sum that runs to or from {exponent}");
                return Failure::unsupported(&what, failure.span);
            }
            failure
        })
    }

    /// The integer that an index or exponent evaluates to.
    ///
    /// # Errors
    /// When it is no integer.
    pub fn integer(&self, expr: &Expr) -> Result<i64, Failure> {
        let letter = |name: &Name| self.bound_value(&crate::latex::canonical(name));
        integer::integer(expr, &letter).map_err(|part| {
            Failure::new(
                FailureKind::Exponent {
                    exponent: crate::latex::write_expr(part),
                    limit: LARGEST_EXPONENT,
                },
                part.span,
            )
        })
    }
}
