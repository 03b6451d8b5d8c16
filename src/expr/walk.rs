//! The tree is walked here and nowhere else: what the direct subexpressions of an expression are, and walks
//! over all of them.
//!
//! Invariant: [`children`] and [`children_mut`] are one list, written once; a new kind of node does not compile
//! until it is in it. The labels of underbraces, the conditions of cases and the indices of names are not among the
//! subexpressions: they are no parts of the value.

use crate::expr::{Expr, ExprKind};

/// The direct subexpressions of an expression in reading order, borrowed as the expression is.
macro_rules! direct_subexpressions {
    ($expr:expr, $iter:ident $(, $mutable:tt)?) => {
        match &$($mutable)? $expr.kind {
            ExprKind::Number(_) | ExprKind::Name(_) | ExprKind::Infinity | ExprKind::Constant => {
                Vec::new()
            }
            ExprKind::Apply { arguments, .. } => arguments.$iter().collect(),
            ExprKind::Call { argument, .. } => vec![&$($mutable)? **argument],
            ExprKind::Sum(terms) => terms.$iter().map(|(_, e)| e).collect(),
            ExprKind::Product(items) | ExprKind::Tuple(items) => items.$iter().collect(),
            ExprKind::Quotient {
                numerator,
                denominator,
                ..
            } => vec![&$($mutable)? **numerator, &$($mutable)? **denominator],
            ExprKind::Power { base, exponent } => {
                vec![&$($mutable)? **base, &$($mutable)? **exponent]
            }
            ExprKind::Transpose(inner)
            | ExprKind::Group { inner, .. }
            | ExprKind::Expectation(inner)
            | ExprKind::Derivative { body: inner, .. }
            | ExprKind::Underbrace { body: inner, .. }
            | ExprKind::Named { value: inner, .. } => vec![&$($mutable)? **inner],
            ExprKind::Matrix { rows, .. } => rows.$iter().flatten().collect(),
            ExprKind::BigSum { from, to, body, .. } => vec![
                &$($mutable)? **from,
                &$($mutable)? **to,
                &$($mutable)? **body,
            ],
            ExprKind::Integral { limits, body, .. } => limits
                .$iter()
                .flat_map(|(a, b)| [&$($mutable)? **a, &$($mutable)? **b])
                .chain([&$($mutable)? **body])
                .collect(),
            ExprKind::Cases(cases) => cases.$iter().map(|(e, _)| e).collect(),
        }
    };
}

/// The direct subexpressions, in reading order.
pub fn children(expr: &Expr) -> Vec<&Expr> {
    direct_subexpressions!(expr, iter)
}

/// The direct subexpressions, to be changed; the same ones as [`children`] in the same order.
pub fn children_mut(expr: &mut Expr) -> Vec<&mut Expr> {
    direct_subexpressions!(expr, iter_mut, mut)
}

/// Calls `see` on every expression of a tree, parents first, in reading order.
pub fn visit<'a>(expr: &'a Expr, see: &mut impl FnMut(&'a Expr)) {
    see(expr);
    for child in children(expr) {
        visit(child, see);
    }
}
