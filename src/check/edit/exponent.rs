//! Exponents one or two off, lost, restored, negated, or moved: to a neighbour, into a bracket or
//! out of it, above the bar or below it. A square lost and a root are among them.

use super::build::{factors, group, number, power, product, quotient, raised, sum};
use super::{Kind, Replacement, Scene, Site, name_of};
use crate::expr::{Expr, ExprKind, Function};
use crate::model::names::literal_integer;
use crate::verdict::EditClass;

pub(super) fn edits(scene: &Scene<'_>) -> Vec<Replacement> {
    let mut found = Vec::new();
    for site in scene.sites_in_time() {
        changed(site, &mut found);
        gained(scene, site, &mut found);
        moved(site, &mut found);
        roots(scene, site, &mut found);
    }
    found
}

fn edit(site: &Site<'_>, to: Expr) -> Replacement {
    Replacement::new(site, EditClass::Exponent, to)
}

/// A printed exponent one or two off, lost, or negated.
fn changed(site: &Site<'_>, found: &mut Vec<Replacement>) {
    let ExprKind::Power { base, exponent } = &site.expr.kind else {
        return;
    };
    let base = (**base).clone();
    match literal_integer(exponent) {
        Some(value) => {
            let others = [
                (value - 1, 0),
                (value + 1, 0),
                (value - 2, 2),
                (value + 2, 2),
            ];
            for (other, rare) in others.into_iter().chain([(1, 1), (-value, 3)]) {
                let plausible = other != 0 && other != value && (other > 0 || value < 0);
                if plausible || other == -value {
                    found.push(edit(site, power(base.clone(), other)).rarer(rare));
                }
            }
        }
        None => {
            let above = (**exponent).clone();
            let span = above.span;
            let off = |sign| {
                let one = (sign, number(1, span));
                sum(vec![(crate::expr::Sign::Plus, above.clone()), one], span)
            };
            for sign in [crate::expr::Sign::Plus, crate::expr::Sign::Minus] {
                found.push(edit(site, raised(base.clone(), off(sign))).rarer(2));
            }
            if let ExprKind::Sum(terms) = &above.kind
                && terms.len() > 1
            {
                for k in 0..terms.len() {
                    let mut fewer = terms.clone();
                    fewer.remove(k);
                    found.push(edit(site, raised(base.clone(), sum(fewer, span))).rarer(2));
                }
            }
            found.push(edit(site, base).rarer(3));
        }
    }
}

/// Whether an exponent could be set here and none is.
fn is_bare(site: &Site<'_>) -> bool {
    let atom = matches!(
        site.expr.kind,
        ExprKind::Name(_) | ExprKind::Group { .. } | ExprKind::Apply { .. }
    );
    let elsewhere = matches!(
        site.parent.map(|p| &p.kind),
        Some(
            ExprKind::Power { .. }
                | ExprKind::Transpose(_)
                | ExprKind::Named { .. }
                | ExprKind::Apply { .. }
                | ExprKind::Cases(_)
                | ExprKind::Tuple(_)
        )
    );
    atom && !elsewhere && !site.is_count()
}

/// An exponent on what has none.
fn gained(scene: &Scene<'_>, site: &Site<'_>, found: &mut Vec<Replacement>) {
    if !is_bare(site) {
        return;
    }
    let matrix = name_of(site.expr).is_some_and(|n| scene.context.kind_of(n) == Kind::Matrix);
    let exponents: &[(i64, u32)] = if matrix {
        &[(2, 0), (-1, 2)]
    } else {
        &[(2, 0), (3, 1), (4, 3), (-1, 3), (-2, 4)]
    };
    for (exponent, rare) in exponents {
        found.push(edit(site, power(site.expr.clone(), *exponent)).rarer(*rare));
    }
}

/// The base and exponent of a factor; the exponent is none where it has none.
fn split(expr: &Expr) -> (Expr, Option<Expr>) {
    match &expr.kind {
        ExprKind::Power { base, exponent } => ((**base).clone(), Some((**exponent).clone())),
        _ => (expr.clone(), None),
    }
}

fn joined(base: Expr, exponent: Option<Expr>) -> Expr {
    match exponent {
        Some(exponent) => raised(base, exponent),
        None => base,
    }
}

/// An exponent that stands elsewhere than it should.
fn moved(site: &Site<'_>, found: &mut Vec<Replacement>) {
    let span = site.expr.span;
    match &site.expr.kind {
        ExprKind::Product(items) => {
            for k in 1..items.len() {
                // Neighbours exchange their exponents.
                let ((left, above), (right, behind)) = (split(&items[k - 1]), split(&items[k]));
                if above != behind && !is_number(&left) && !is_number(&right) {
                    let mut exchanged = items.clone();
                    exchanged[k - 1] = joined(left, behind.clone());
                    exchanged[k] = joined(right, above);
                    found.push(edit(site, product(exchanged, span)).rarer(1));
                }
                // The last factor's exponent belongs to a bracket around it and what is before it.
                let (base, Some(exponent)) = split(&items[k]) else {
                    continue;
                };
                let mut from = k;
                while from > 0 && split(&items[from - 1]).1.is_none() {
                    from -= 1;
                    let mut held = items[from..k].to_vec();
                    held.push(base.clone());
                    let bracket = raised(group(product(held, span)), exponent.clone());
                    let mut all = items[..from].to_vec();
                    all.push(bracket);
                    all.extend(items[k + 1..].to_vec());
                    found.push(edit(site, product(all, span)).rarer(2));
                }
            }
        }
        ExprKind::Power { base, exponent } => match &base.without_brackets().kind {
            // (ab)^2 for ab^2, (a + b)^2 for a + b^2, (a/b)^2 for a^2/b and a/b^2.
            ExprKind::Product(items) => {
                for k in 0..items.len() {
                    let mut all = items.clone();
                    all[k] = raised(all[k].clone(), (**exponent).clone());
                    found.push(edit(site, product(all, span)).rarer(2));
                }
            }
            ExprKind::Sum(terms) => {
                for k in 0..terms.len() {
                    let mut all = terms.clone();
                    all[k].1 = with_last_raised(&all[k].1, exponent);
                    found.push(edit(site, group(sum(all, span))).rarer(2));
                }
            }
            ExprKind::Quotient {
                numerator,
                denominator,
                style,
            } => {
                let (top, bottom) = ((**numerator).clone(), (**denominator).clone());
                let up = with_last_raised(&top, exponent);
                let down = with_last_raised(&bottom, exponent);
                for (above, below) in [(up, bottom), (top, down)] {
                    found.push(edit(site, quotient(above, below, *style, span)).rarer(2));
                }
            }
            _ => {}
        },
        ExprKind::Group { inner, .. } => {
            // a + b^2 for (a + b)^2.
            if let ExprKind::Sum(terms) = &inner.kind {
                for (k, (_, term)) in terms.iter().enumerate() {
                    if let Some((lower, exponent)) = without_last_exponent(term) {
                        let mut all = terms.clone();
                        all[k].1 = lower;
                        let bracket = raised(group(sum(all, span)), exponent);
                        found.push(edit(site, bracket).rarer(2));
                    }
                }
            }
        }
        ExprKind::Quotient {
            numerator,
            denominator,
            style,
        } => {
            let (up, down) = (
                without_last_exponent(numerator),
                without_last_exponent(denominator),
            );
            if let Some((top, exponent)) = &up {
                let below = with_last_raised(denominator, exponent);
                let whole = quotient(top.clone(), (**denominator).clone(), *style, span);
                found.push(edit(site, raised(group(whole), exponent.clone())).rarer(2));
                found.push(edit(site, quotient(top.clone(), below, *style, span)).rarer(2));
            }
            if let Some((bottom, exponent)) = &down {
                let above = with_last_raised(numerator, exponent);
                let whole = quotient((**numerator).clone(), bottom.clone(), *style, span);
                found.push(edit(site, raised(group(whole), exponent.clone())).rarer(2));
                found.push(edit(site, quotient(above, bottom.clone(), *style, span)).rarer(2));
            }
        }
        _ => {}
    }
}

fn is_number(expr: &Expr) -> bool {
    matches!(expr.kind, ExprKind::Number(_))
}

/// With an exponent on the last factor.
fn with_last_raised(expr: &Expr, exponent: &Expr) -> Expr {
    let mut items = factors(expr);
    if let Some(last) = items.pop() {
        items.push(raised(last, exponent.clone()));
    }
    product(items, expr.span)
}

/// Without the exponent of the last factor, and that.
fn without_last_exponent(expr: &Expr) -> Option<(Expr, Expr)> {
    let mut items = factors(expr);
    let (base, exponent) = split(&items.pop()?);
    items.push(base);
    Some((product(items, expr.span), exponent?))
}

/// A root lost or gained.
fn roots(scene: &Scene<'_>, site: &Site<'_>, found: &mut Vec<Replacement>) {
    let root = |argument: Expr| {
        let span = argument.span;
        let kind = ExprKind::Call {
            function: Function::SquareRoot,
            argument: Box::new(argument),
        };
        Expr::new(kind, span)
    };
    match &site.expr.kind {
        ExprKind::Call {
            function: Function::SquareRoot,
            argument,
        } => {
            let bare = match argument.kind {
                ExprKind::Sum(_) | ExprKind::Product(_) => group((**argument).clone()),
                _ => (**argument).clone(),
            };
            found.push(edit(site, bare.clone()).rarer(1));
            found.push(edit(site, power(bare, 2)).rarer(4));
        }
        ExprKind::Power { base, exponent }
            if scene.context.functions && literal_integer(exponent) == Some(2) =>
        {
            let inner = base.without_brackets().clone();
            found.push(edit(site, root(inner)).rarer(4));
        }
        _ if scene.context.functions && (is_bare(site) || site.is_monomial()) => {
            let scalar = name_of(site.expr)
                .is_none_or(|n| scene.context.kind_of(n) == Kind::Scalar && n.dots == 0);
            let plain = !matches!(
                site.expr.kind,
                ExprKind::Number(_)
                    | ExprKind::Matrix { .. }
                    | ExprKind::Underbrace { .. }
                    | ExprKind::Constant
                    | ExprKind::Call { .. }
            );
            if scalar && plain {
                found.push(edit(site, root(site.expr.without_brackets().clone())).rarer(4));
            }
        }
        _ => {}
    }
}
