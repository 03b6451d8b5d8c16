//! Integer factors and literals: neighbours, doubles and halves, digits lost or exchanged, the
//! decimal point; a factor 2, π or 2π that a monomial gained or lost, and the same below it.

use super::build::{factor, factors, number, product, quotient, rational};
use super::{Replacement, Scene, Site};
use crate::expr::{Expr, ExprKind, QuotientStyle};
use crate::verdict::EditClass;
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Signed, Zero};

pub(super) fn edits(scene: &Scene<'_>) -> Vec<Replacement> {
    let literals = scene.sites.iter().flat_map(literals);
    let constants = constants(scene);
    let factors = scene.sites.iter().flat_map(|s| gained(s, &constants));
    literals.chain(factors).collect()
}

/// Another number for a printed one; exponents have a class of their own.
fn literals(site: &Site<'_>) -> Vec<Replacement> {
    let ExprKind::Number(value) = &site.expr.kind else {
        return Vec::new();
    };
    let exponent =
        matches!(site.parent.map(|p| &p.kind), Some(ExprKind::Power { .. })) && site.step() == 1;
    if exponent {
        return Vec::new();
    }
    let (one, two) = (BigRational::one(), BigRational::from_integer(2.into()));
    let ten = BigRational::from_integer(10.into());
    let mut others = vec![
        (value + &one, 0),
        (value - &one, 0),
        (value * &two, 0),
        (value / &two, 0),
    ];
    if !value.is_zero() {
        let rare = if value.is_one() { 5 } else { 2 };
        others.extend([(value * &ten, rare), (value / &ten, rare)]);
    }
    if value.is_integer() {
        let digits = digits_changed(value.numer()).into_iter();
        others.extend(digits.map(|n| (BigRational::from_integer(n), 1)));
    }
    // A sum's limits are whole numbers.
    let whole = site.is_count();
    // A factor 1 or a divisor 1 is not written: there the number is left out. A factor 0 is no slip.
    let (factor, divisor) = match site.parent.map(|p| &p.kind) {
        Some(ExprKind::Product(_)) => (true, false),
        Some(ExprKind::Quotient { .. }) => (site.step() == 0, site.step() == 1),
        _ => (false, false),
    };
    let product = matches!(site.parent.map(|p| &p.kind), Some(ExprKind::Product(_)));
    let unwritten = |other: &BigRational| {
        (factor || divisor) && other.is_zero() || (product || divisor) && other.is_one()
    };
    others
        .into_iter()
        .filter(|(other, _)| (!whole || other.is_integer()) && !unwritten(other))
        .map(|(other, rare)| {
            let edit = Replacement::new(site, EditClass::Factor, rational(other, site.expr.span));
            edit.rarer(rare)
        })
        .collect()
}

/// How much rarer than another number it is that a factor is left out: as rare as the 1 that it would be.
pub(super) fn left_out(number: &BigRational) -> u32 {
    let is = |n: i64| *number == BigRational::from_integer(n.into());
    if is(2) || is(0) {
        0
    } else if is(10) {
        2
    } else {
        3
    }
}

/// A number with one digit less, or with two neighbouring digits exchanged.
fn digits_changed(value: &BigInt) -> Vec<BigInt> {
    let text = value.abs().to_string();
    let digits: Vec<char> = text.chars().collect();
    if digits.len() < 2 || digits.len() > 12 {
        return Vec::new();
    }
    let mut found = Vec::new();
    for k in 0..digits.len() {
        let mut fewer = digits.clone();
        fewer.remove(k);
        found.push(fewer);
        if k > 0 && digits[k] != digits[k - 1] {
            let mut exchanged = digits.clone();
            exchanged.swap(k, k - 1);
            found.push(exchanged);
        }
    }
    let sign = value.signum();
    found
        .into_iter()
        .filter_map(|d| d.into_iter().collect::<String>().parse::<BigInt>().ok())
        .map(|n| &sign * n)
        .collect()
}

/// The factors that are easily lost, with how much rarer than a digit.
fn constants(scene: &Scene<'_>) -> Vec<(Expr, u32)> {
    let mut found = vec![(number(2, Default::default()), 0)];
    if let Some(pi) = &scene.context.pi {
        let pi = Expr::new(ExprKind::Name(pi.clone()), Default::default());
        let two = number(2, Default::default());
        let double = product(vec![two, pi.clone()], Default::default());
        found.extend([(pi, 1), (double, 2)]);
    }
    let more = [3, 4, 6, 8].map(|n| (number(n, Default::default()), 4));
    found.extend(more);
    found
}

/// A monomial with one of the constants above or below it.
fn gained(site: &Site<'_>, constants: &[(Expr, u32)]) -> Vec<Replacement> {
    let side = site.parent.is_none() && !matches!(site.expr.kind, ExprKind::Constant);
    if !(site.is_monomial() || side) || number_or_matrix(site) {
        return Vec::new();
    }
    let span = site.expr.span;
    let edit = |to| Replacement::new(site, EditClass::Factor, to);
    constants
        .iter()
        .flat_map(|(constant, rare)| {
            let mut constant = constant.clone();
            constant.span = span;
            let more = with_factor(constant.clone(), site.expr);
            let below = match &site.expr.kind {
                ExprKind::Quotient {
                    numerator,
                    denominator,
                    style,
                } => {
                    let denominator = with_factor(constant, denominator);
                    quotient((**numerator).clone(), denominator, *style, span)
                }
                _ => quotient(site.expr.clone(), constant, QuotientStyle::Bar, span),
            };
            [edit(more).rarer(*rare), edit(below).rarer(*rare)]
        })
        .collect()
}

/// With a factor in front; an integer takes an integer in.
fn with_factor(constant: Expr, expr: &Expr) -> Expr {
    let span = expr.span;
    let mut rest = factors(expr);
    if let (ExprKind::Number(n), Some(ExprKind::Number(m))) =
        (&constant.kind, rest.first().map(|e| &e.kind))
    {
        let first = rational(n * m, span);
        rest[0] = first;
        return product(rest, span);
    }
    let constant = factor(constant);
    product(std::iter::once(constant).chain(rest).collect(), span)
}

/// What other edits change: a bare literal, and a matrix by its entries where it is not the side.
fn number_or_matrix(site: &Site<'_>) -> bool {
    match &site.expr.kind {
        ExprKind::Number(_) | ExprKind::Underbrace { .. } => true,
        ExprKind::Matrix { .. } => site.parent.is_some(),
        _ => false,
    }
}
