//! Expressions as the parser would read them: no sum in a product without brackets, no product in a
//! product, no exponent 1.

use crate::expr::{Bracket, Expr, ExprKind, QuotientStyle, Sign};
use crate::span::Span;
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::One;

/// An integer.
pub fn number(value: i64, span: Span) -> Expr {
    rational(BigRational::from_integer(BigInt::from(value)), span)
}

/// A number.
pub fn rational(value: BigRational, span: Span) -> Expr {
    Expr::new(ExprKind::Number(value), span)
}

/// Whether it is the number 1.
pub fn is_one(expr: &Expr) -> bool {
    matches!(&expr.kind, ExprKind::Number(n) if n.is_one())
}

/// In round brackets.
pub fn group(inner: Expr) -> Expr {
    let span = inner.span;
    Expr::new(
        ExprKind::Group {
            bracket: Bracket::Round,
            inner: Box::new(inner),
        },
        span,
    )
}

/// In round brackets where it is a sum.
pub fn factor(expr: Expr) -> Expr {
    match expr.kind {
        ExprKind::Sum(_) => group(expr),
        _ => expr,
    }
}

/// The product of some factors: 1 of none, the only one itself.
pub fn product(factors: Vec<Expr>, span: Span) -> Expr {
    let mut flat = Vec::with_capacity(factors.len());
    for expr in factors {
        match expr.kind {
            ExprKind::Product(inner) => flat.extend(inner),
            _ => flat.push(factor(expr)),
        }
    }
    match flat.len() {
        0 => number(1, span),
        1 => flat.remove(0),
        _ => Expr::new(ExprKind::Product(flat), span),
    }
}

/// The sum of some terms: 0 of none, a single positive one itself.
pub fn sum(terms: Vec<(Sign, Expr)>, span: Span) -> Expr {
    let mut flat: Vec<(Sign, Expr)> = Vec::with_capacity(terms.len());
    for (sign, term) in terms {
        match term.kind {
            ExprKind::Sum(inner) if inner.len() == 1 || sign == Sign::Plus => {
                flat.extend(inner.into_iter().map(|(s, e)| (times(sign, s), e)));
            }
            ExprKind::Sum(_) => flat.push((sign, group(term))),
            _ => flat.push((sign, term)),
        }
    }
    match flat.as_slice() {
        [] => number(0, span),
        [(Sign::Plus, _)] => flat.remove(0).1,
        _ => Expr::new(ExprKind::Sum(flat), span),
    }
}

/// The product of two signs.
pub fn times(one: Sign, other: Sign) -> Sign {
    if one == other {
        Sign::Plus
    } else {
        Sign::Minus
    }
}

/// The other sign.
pub fn flipped(sign: Sign) -> Sign {
    times(sign, Sign::Minus)
}

/// With the other sign, in brackets where it is a sum of several terms.
pub fn negated(expr: Expr) -> Expr {
    let span = expr.span;
    sum(vec![(Sign::Minus, expr)], span)
}

/// The terms of a sum; anything else is a single one.
pub fn terms(expr: &Expr) -> Vec<(Sign, Expr)> {
    match &expr.kind {
        ExprKind::Sum(terms) => terms.clone(),
        _ => vec![(Sign::Plus, expr.clone())],
    }
}

/// The factors of a product; anything else is a single one.
pub fn factors(expr: &Expr) -> Vec<Expr> {
    match &expr.kind {
        ExprKind::Product(factors) => factors.clone(),
        _ => vec![factor(expr.clone())],
    }
}

/// A quotient; a denominator 1 is none.
pub fn quotient(numerator: Expr, denominator: Expr, style: QuotientStyle, span: Span) -> Expr {
    if is_one(&denominator) {
        return numerator;
    }
    Expr::new(
        ExprKind::Quotient {
            numerator: Box::new(numerator),
            denominator: Box::new(denominator),
            style,
        },
        span,
    )
}

/// A power with a literal exponent; the exponent 1 is none.
pub fn power(base: Expr, exponent: i64) -> Expr {
    if exponent == 1 {
        return base;
    }
    let span = base.span;
    let above = match exponent {
        0.. => number(exponent, span),
        _ => negated(number(-exponent, span)),
    };
    raised(base, above)
}

/// A power with any exponent, its base in brackets where it needs them.
pub fn raised(base: Expr, exponent: Expr) -> Expr {
    let span = base.span;
    let base = match base.kind {
        ExprKind::Sum(_)
        | ExprKind::Product(_)
        | ExprKind::Quotient { .. }
        | ExprKind::Power { .. }
        | ExprKind::BigSum { .. } => group(base),
        _ => base,
    };
    Expr::new(
        ExprKind::Power {
            base: Box::new(base),
            exponent: Box::new(exponent),
        },
        span,
    )
}
