//! The tree is walked here and nowhere else: what the direct subexpressions of an expression are, and walks
//! over all of them.
//!
//! Invariant: [`children`] and [`children_mut`] are one list, written once; a new kind of node does not compile
//! until it is in it. The labels of underbraces, the conditions of cases and the indices of names are not among the
//! subexpressions: they are no parts of the value.

use crate::expr::{Expr, ExprKind, Name};

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

/// The name that a node itself carries, apart from those in its subexpressions, borrowed as it is, and whether it is that
/// of a letter that varies under the node.
macro_rules! own_names {
    ($expr:expr, $as_option:ident $(, $mutable:tt)?) => {
        match &$($mutable)? $expr.kind {
            ExprKind::Name(name)
            | ExprKind::Apply { function: name, .. }
            | ExprKind::Named { name, .. } => Some((name, false)),
            ExprKind::BigSum { index: name, .. } | ExprKind::Integral { variable: name, .. } => {
                Some((name, true))
            }
            ExprKind::Derivative { variable, .. } => variable.$as_option().map(|name| (name, true)),
            ExprKind::Number(_)
            | ExprKind::Call { .. }
            | ExprKind::Sum(_)
            | ExprKind::Product(_)
            | ExprKind::Tuple(_)
            | ExprKind::Quotient { .. }
            | ExprKind::Power { .. }
            | ExprKind::Transpose(_)
            | ExprKind::Group { .. }
            | ExprKind::Matrix { .. }
            | ExprKind::Expectation(_)
            | ExprKind::Underbrace { .. }
            | ExprKind::Cases(_)
            | ExprKind::Infinity
            | ExprKind::Constant => None,
        }
    };
}

/// The name that a node itself carries: what it is, applies, sums, integrates or differentiates by.
pub fn own_name(expr: &Expr) -> Option<&Name> {
    own_names!(expr, as_ref).map(|(name, _)| name)
}

/// The same name, to be changed.
pub fn own_name_mut(expr: &mut Expr) -> Option<&mut Name> {
    own_names!(expr, as_mut, mut).map(|(name, _)| name)
}

/// The letter that varies under a node: what it sums over, integrates or differentiates by.
pub fn varied_name(expr: &Expr) -> Option<&Name> {
    own_names!(expr, as_ref).and_then(|(name, varied)| varied.then_some(name))
}

/// The direct subexpressions, in reading order.
pub fn children(expr: &Expr) -> Vec<&Expr> {
    direct_subexpressions!(expr, iter)
}

/// The direct subexpressions, to be changed; the same ones as [`children`] in the same order.
pub fn children_mut(expr: &mut Expr) -> Vec<&mut Expr> {
    direct_subexpressions!(expr, iter_mut, mut)
}

/// Whether a name stands in an expression, or applies a function there; with the same dots and index.
pub fn mentions(expr: &Expr, name: &Name) -> bool {
    let mut found = false;
    visit(expr, &mut |e| {
        if let ExprKind::Name(own) | ExprKind::Apply { function: own, .. } = &e.kind {
            found |= own == name;
        }
    });
    found
}

/// Calls `see` on every expression of a tree, parents first, in reading order.
pub fn visit<'a>(expr: &'a Expr, see: &mut impl FnMut(&'a Expr)) {
    see(expr);
    for child in children(expr) {
        visit(child, see);
    }
}
