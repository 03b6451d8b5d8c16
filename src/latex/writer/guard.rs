//! Where the page would be misread without a bracket or a dot.

use super::Writer;
use crate::expr::{Bracket, Expr, ExprKind, Function, Name, QuotientStyle};
use crate::latex::parser::looks_mixed;

/// Whether what is written after it would be taken into it.
pub(super) fn is_open_ended(expr: &Expr) -> bool {
    match &expr.kind {
        ExprKind::BigSum { .. }
        | ExprKind::Derivative {
            variable: Some(_), ..
        } => true,
        ExprKind::Product(factors) => factors.last().is_some_and(is_open_ended),
        ExprKind::Quotient {
            denominator,
            style: QuotientStyle::Slash,
            ..
        } => is_open_ended(denominator),
        _ => false,
    }
}

/// The name at the right end of a factor, before its exponent.
pub(super) fn final_name(expr: &Expr) -> Option<&Name> {
    match &expr.kind {
        ExprKind::Name(name) => Some(name),
        ExprKind::Power { base, .. } | ExprKind::Transpose(base) => final_name(base),
        _ => None,
    }
}

/// Whether a function stands at the right end whose argument has no bracket.
pub(super) fn ends_in_bare_argument(expr: &Expr) -> bool {
    match &expr.kind {
        ExprKind::Call { function, argument } => match function {
            Function::SquareRoot | Function::Absolute => false,
            _ => !matches!(
                argument.kind,
                ExprKind::Group { .. } | ExprKind::Matrix { .. } | ExprKind::Sum(_)
            ),
        },
        ExprKind::Power { base, .. } => ends_in_bare_argument(base),
        _ => false,
    }
}

/// Whether a function stands at the right end whose argument a bracket behind it may belong to.
fn ends_in_call(expr: &Expr) -> bool {
    match &expr.kind {
        ExprKind::Call { function, .. } => {
            !matches!(function, Function::SquareRoot | Function::Absolute)
        }
        ExprKind::Power { base, .. } => ends_in_call(base),
        _ => false,
    }
}

/// Whether a bare argument of a function visibly ends before this factor.
pub(super) fn ends_argument(expr: &Expr) -> bool {
    match &expr.kind {
        ExprKind::Call { function, argument } => {
            *function != Function::Absolute
                && !matches!(
                    argument.kind,
                    ExprKind::Matrix {
                        bracket: Bracket::Bar,
                        ..
                    }
                )
        }
        ExprKind::BigSum { .. } | ExprKind::Integral { .. } => true,
        _ => false,
    }
}

pub(super) fn is_slash(expr: &Expr) -> bool {
    matches!(
        expr.kind,
        ExprKind::Quotient {
            style: QuotientStyle::Slash,
            ..
        }
    )
}

/// Whether the name is a bare `d`, which before a letter looks like a differential.
pub(super) fn is_bare_d(expr: &Expr) -> bool {
    match &expr.kind {
        ExprKind::Name(name) => {
            matches!(name.letter.base.as_str(), "d" | "\\partial")
                && name.letter.accent.is_none()
                && name.letter.primes == 0
                && name.dots == 0
                && name.subscript.is_none()
        }
        ExprKind::Power { base, .. } => is_bare_d(base),
        _ => false,
    }
}

/// Whether a bare `d` stands at the right end, where the variable of integration follows.
pub(super) fn ends_in_bare_d(expr: &Expr) -> bool {
    match &expr.kind {
        ExprKind::Product(factors) => factors.last().is_some_and(ends_in_bare_d),
        ExprKind::Sum(terms) => terms.last().is_some_and(|(_, term)| ends_in_bare_d(term)),
        ExprKind::Quotient {
            denominator: last,
            style: QuotientStyle::Slash,
            ..
        }
        | ExprKind::BigSum { body: last, .. }
        | ExprKind::Derivative { body: last, .. }
        | ExprKind::Call { argument: last, .. } => ends_in_bare_d(last),
        ExprKind::Name(_) => is_bare_d(expr),
        _ => false,
    }
}

/// Whether the factor begins with a name.
pub(super) fn final_or_first_name(expr: &Expr) -> bool {
    match &expr.kind {
        ExprKind::Apply { .. } => true,
        ExprKind::Derivative { variable: None, .. } => true,
        ExprKind::Power { base, .. } | ExprKind::Transpose(base) => final_or_first_name(base),
        _ => final_name(expr).is_some(),
    }
}

/// Whether the factor, which after a name begins with a bracket, would be read as its arguments.
pub(super) fn looks_like_arguments(expr: &Expr) -> bool {
    match &expr.kind {
        ExprKind::Tuple(_) => true,
        ExprKind::Group { inner, .. } => is_leaf(inner),
        ExprKind::Power { base, .. } | ExprKind::Transpose(base) => {
            is_leaf(base) || looks_like_arguments(base)
        }
        _ => false,
    }
}

fn is_leaf(expr: &Expr) -> bool {
    matches!(
        expr.kind,
        ExprKind::Name(_) | ExprKind::Number(_) | ExprKind::Infinity | ExprKind::Constant
    )
}

impl Writer {
    pub(super) fn needs_dot(
        self,
        before: &Expr,
        factor: &Expr,
        piece: &str,
        bracketed: bool,
    ) -> bool {
        if piece.starts_with(|c: char| c.is_ascii_digit()) {
            return true;
        }
        if is_slash(before) || !bracketed && is_slash(factor) || looks_mixed(before, factor) {
            return true;
        }
        if ends_in_bare_argument(before) && (bracketed || !ends_argument(factor)) {
            return true;
        }
        if self.differential && is_bare_d(before) && final_or_first_name(factor) {
            return true;
        }
        let opens = |bracket: &str| {
            piece.starts_with(bracket) || piece.starts_with(&format!("\\left{bracket}"))
        };
        if ends_in_call(before) && (opens("(") || opens("[") || opens("\\{")) {
            return true;
        }
        let Some(name) = final_name(before) else {
            return false;
        };
        if name.letter.base == "E" && (opens("\\{") || opens("(") || opens("[")) {
            return true;
        }
        opens("(") && looks_like_arguments(factor)
    }
}
