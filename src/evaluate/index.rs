//! Indices and exponents: integer arithmetic on literals and bound letters.

use super::{Evaluator, Failure, FailureKind, LARGEST_EXPONENT};
use crate::domain::Domain;
use crate::expr::{Expr, ExprKind, Sign};
use num_traits::ToPrimitive;

impl<D: Domain> Evaluator<'_, D> {
    /// The integer that the bound of a sum evaluates to; another bound makes nothing wrong.
    pub(super) fn bound_of_sum(&mut self, expr: &Expr) -> Result<i64, Failure> {
        self.integer(expr).map_err(|failure| match failure.kind {
            FailureKind::Exponent { exponent, .. } => {
                let what = format!("a sum that runs to or from {exponent}");
                Failure::unsupported(&what, failure.span)
            }
            _ => failure,
        })
    }

    /// The integer that an index or exponent evaluates to.
    ///
    /// # Errors
    /// When it is no integer.
    pub fn integer(&mut self, expr: &Expr) -> Result<i64, Failure> {
        let fail = || {
            Failure::new(
                FailureKind::Exponent {
                    exponent: crate::latex::write_expr(expr),
                    limit: LARGEST_EXPONENT,
                },
                expr.span,
            )
        };
        match &expr.kind {
            ExprKind::Number(n) if n.is_integer() => n.to_integer().to_i64().ok_or_else(fail),
            ExprKind::Name(name) => self
                .bound_value(&crate::latex::canonical(name))
                .ok_or_else(fail),
            ExprKind::Group { inner, .. } => self.integer(inner),
            ExprKind::Sum(terms) => {
                let mut sum = 0i64;
                for (sign, term) in terms {
                    let value = self.integer(term)?;
                    sum = match sign {
                        Sign::Plus => sum.checked_add(value),
                        Sign::Minus => sum.checked_sub(value),
                    }
                    .ok_or_else(fail)?;
                }
                Ok(sum)
            }
            ExprKind::Product(factors) => {
                let mut product = 1i64;
                for factor in factors {
                    product = product
                        .checked_mul(self.integer(factor)?)
                        .ok_or_else(fail)?;
                }
                Ok(product)
            }
            ExprKind::Power { base, exponent } => {
                let base = self.integer(base)?;
                u32::try_from(self.integer(exponent)?)
                    .ok()
                    .and_then(|e| base.checked_pow(e))
                    .ok_or_else(fail)
            }
            _ => Err(fail()),
        }
    }
}
