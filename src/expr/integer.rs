//! The integer that an index or an exponent spells.
//!
//! Literal integers, letters that stand for one, and sums, products, powers and brackets of these; whatever else is
//! printed spells none, and the smallest part that spells none is told.

use super::{Expr, ExprKind, Name, Sign};
use num_traits::ToPrimitive;

/// The integer that an expression spells where `letter` says what letters stand for.
///
/// # Errors
/// The part that spells none, or none of 64 bits.
pub fn integer<'e>(expr: &'e Expr, letter: &dyn Fn(&Name) -> Option<i64>) -> Result<i64, &'e Expr> {
    let found = match &expr.kind {
        ExprKind::Number(n) if n.is_integer() => n.to_integer().to_i64(),
        ExprKind::Name(name) => letter(name),
        ExprKind::Group { inner, .. } => return integer(inner, letter),
        ExprKind::Sum(terms) => {
            let mut sum = 0i64;
            for (sign, term) in terms {
                let value = integer(term, letter)?;
                let next = match sign {
                    Sign::Plus => sum.checked_add(value),
                    Sign::Minus => sum.checked_sub(value),
                };
                sum = next.ok_or(expr)?;
            }
            Some(sum)
        }
        ExprKind::Product(factors) => {
            let mut product = 1i64;
            for factor in factors {
                product = product.checked_mul(integer(factor, letter)?).ok_or(expr)?;
            }
            Some(product)
        }
        ExprKind::Power { base, exponent } => {
            let base = integer(base, letter)?;
            let exponent = u32::try_from(integer(exponent, letter)?).ok();
            exponent.and_then(|e| base.checked_pow(e))
        }
        // A quotient may be an integer, but nobody prints an index so.
        ExprKind::Number(_)
        | ExprKind::Quotient { .. }
        | ExprKind::Apply { .. }
        | ExprKind::Named { .. }
        | ExprKind::Call { .. }
        | ExprKind::Transpose(_)
        | ExprKind::Matrix { .. }
        | ExprKind::Tuple(_)
        | ExprKind::BigSum { .. }
        | ExprKind::Integral { .. }
        | ExprKind::Derivative { .. }
        | ExprKind::Expectation(_)
        | ExprKind::Underbrace { .. }
        | ExprKind::Cases(_)
        | ExprKind::Infinity
        | ExprKind::Constant => None,
    };
    found.ok_or(expr)
}
