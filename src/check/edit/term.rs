//! Terms and factors dropped or added. What is added is taken from what the equation itself holds:
//! its letters as factors and divisors, its terms and letters as terms; what the search solves for
//! instead is in `solved`.

use super::build::{factor, factors, number, product, quotient, sum, terms};
use super::literal::left_out;
use super::mark::may_be_matrix;
use super::{Change, Kind, LONG, ROOM, Replacement, Scene, Site, name_of};
use crate::expr::walk::visit;
use crate::expr::{Expr, ExprKind, QuotientStyle, Sign};
use crate::verdict::EditClass;

/// Terms of the equation that are tried in its sums.
const TERMS: usize = 12;
/// Letters of the equation that are tried as factors.
const FACTORS: usize = 16;
/// Matrices of the equation that are tried as factors.
const MATRICES: usize = 6;

pub(super) fn edits(scene: &Scene<'_>) -> Vec<Replacement> {
    let (letters, terms) = (letters(scene), pool(scene));
    let matrices = matrices(scene);
    let mut found = Vec::new();
    for site in scene.sites_in_time() {
        if found.len() > ROOM {
            break;
        }
        dropped(scene, site, &mut found);
        with_factors(site, &letters, &mut found);
        with_matrices(site, &matrices, &mut found);
        with_terms(site, &terms, &mut found);
    }
    found
}

fn edit(site: &Site<'_>, to: Expr) -> Replacement {
    Replacement::new(site, EditClass::Term, to)
}

/// A term or factor left out; an integer factor left out is a slip of its own class.
fn dropped(scene: &Scene<'_>, site: &Site<'_>, found: &mut Vec<Replacement>) {
    let span = site.expr.span;
    match &site.expr.kind {
        ExprKind::Sum(terms) if terms.len() > 1 => {
            for k in 0..terms.len() {
                if terms.len() > LONG {
                    let change = Change::of_terms(terms, k, k + 1, Vec::new());
                    found.push(Replacement::of(site, EditClass::Term, change));
                    continue;
                }
                let mut fewer = terms.clone();
                fewer.remove(k);
                found.push(edit(site, sum(fewer, span)));
            }
        }
        ExprKind::Product(items) => {
            for k in 0..items.len() {
                let mut fewer = items.clone();
                let gone = fewer.remove(k);
                let (class, rare) = match &gone.kind {
                    ExprKind::Number(n) => (EditClass::Factor, left_out(n)),
                    _ => (EditClass::Term, 3),
                };
                found.push(Replacement::new(site, class, product(fewer, span)).rarer(rare));
            }
            // 2π is gained and lost as one.
            let circle = |e: &Expr| name_of(e).is_some_and(|n| scene.context.is_pi(n));
            if let [first, second, rest @ ..] = items.as_slice()
                && matches!(first.kind, ExprKind::Number(_))
                && circle(second)
            {
                let fewer = product(rest.to_vec(), span);
                found.push(Replacement::new(site, EditClass::Factor, fewer).rarer(3));
            }
        }
        ExprKind::Quotient {
            numerator,
            denominator,
            style,
        } => {
            let (class, rare) = match &denominator.kind {
                ExprKind::Number(n) => (EditClass::Factor, left_out(n)),
                _ => (EditClass::Term, 3),
            };
            found.push(Replacement::new(site, class, factor((**numerator).clone())).rarer(rare));
            if !super::build::is_one(numerator) {
                let one = number(1, numerator.span);
                let reciprocal = quotient(one, (**denominator).clone(), *style, span);
                found.push(edit(site, reciprocal).rarer(2));
            }
        }
        _ => {}
    }
}

/// The scalar letters of the equation.
fn letters(scene: &Scene<'_>) -> Vec<Expr> {
    let mut found: Vec<Expr> = Vec::new();
    for site in scene.sites_in_time() {
        let Some(name) = name_of(site.expr) else {
            continue;
        };
        let atom = matches!(site.expr.kind, ExprKind::Name(_) | ExprKind::Apply { .. });
        let in_apply = matches!(
            site.parent.map(|p| &p.kind),
            Some(ExprKind::Apply { .. } | ExprKind::Named { .. })
        );
        let scalar = scene.context.kind_of(name) != Kind::Matrix;
        if atom && scalar && !in_apply && !site.is_count() && !found.contains(site.expr) {
            found.push(site.expr.clone());
        }
        if found.len() == FACTORS {
            break;
        }
    }
    found
}

/// A letter of the equation as a factor or divisor of a monomial.
fn with_factors(site: &Site<'_>, letters: &[Expr], found: &mut Vec<Replacement>) {
    let bracket = matches!(
        site.expr.kind,
        ExprKind::Underbrace { .. } | ExprKind::Matrix { .. } | ExprKind::Constant
    );
    let number = matches!(&site.expr.kind, ExprKind::Number(n) if n.numer() == &0.into());
    let side = site.parent.is_none();
    let monomial = site.is_monomial() && !bracket;
    if number || !(side || monomial) {
        return;
    }
    let span = site.expr.span;
    for letter in letters {
        let mut letter = letter.clone();
        letter.span = span;
        let mut more = factors(site.expr);
        // A one with a factor is the factor; otherwise it comes last.
        if super::build::is_one(site.expr) {
            more.clear();
        }
        more.push(letter.clone());
        found.push(edit(site, product(more, span)));
        let below = match &site.expr.kind {
            ExprKind::Quotient {
                numerator,
                denominator,
                style,
            } => {
                let mut items = factors(denominator);
                items.push(letter);
                let items = product(items, span);
                quotient((**numerator).clone(), items, *style, span)
            }
            _ => quotient(site.expr.clone(), letter, QuotientStyle::Bar, span),
        };
        found.push(edit(site, below).rarer(2));
    }
}

/// The matrices of the equation by their letters, and transposed.
fn matrices(scene: &Scene<'_>) -> Vec<Expr> {
    let mut found: Vec<Expr> = Vec::new();
    for site in scene.sites_in_time() {
        let ExprKind::Name(name) = &site.expr.kind else {
            continue;
        };
        let matrix = scene.context.kind_of(name) == Kind::Matrix;
        if matrix && scene.context.zero.as_ref() != Some(name) && !found.contains(site.expr) {
            found.push(site.expr.clone());
        }
    }
    found.truncate(MATRICES);
    let transposed = found.clone().into_iter().map(transposed);
    found.extend(transposed);
    found
}

/// The transpose of a matrix; of a transpose what it is taken of.
fn transposed(expr: Expr) -> Expr {
    let span = expr.span;
    match expr.kind {
        ExprKind::Transpose(inner) => *inner,
        _ => Expr::new(ExprKind::Transpose(Box::new(expr)), span),
    }
}

/// The transpose of a product: its matrices transposed in the other order.
fn transposed_product(expr: &Expr) -> Option<Expr> {
    let ExprKind::Product(items) = &expr.kind else {
        return None;
    };
    let (matrices, mut items): (Vec<Expr>, Vec<Expr>) =
        items.iter().cloned().partition(may_be_matrix);
    if matrices.is_empty() {
        return None;
    }
    items.extend(matrices.into_iter().rev().map(transposed));
    Some(product(items, expr.span))
}

/// A matrix of the equation as a factor of a monomial, in front of a matrix or behind all.
fn with_matrices(site: &Site<'_>, matrices: &[Expr], found: &mut Vec<Replacement>) {
    let container = matches!(
        site.expr.kind,
        ExprKind::Underbrace { .. } | ExprKind::Matrix { .. } | ExprKind::Constant
    );
    let mut among = false;
    visit(site.parent.unwrap_or(site.expr), &mut |e| {
        among |= matches!(e.kind, ExprKind::Name(_)) && may_be_matrix(e);
    });
    if container || !among || !site.is_monomial() {
        return;
    }
    let items = factors(site.expr);
    for place in 0..=items.len() {
        if items.get(place).is_some_and(|item| !may_be_matrix(item)) {
            continue;
        }
        for (k, matrix) in matrices.iter().enumerate() {
            let mut matrix = matrix.clone();
            matrix.span = site.expr.span;
            let mut more = items.clone();
            more.insert(place, matrix);
            let rare = 2 + 2 * u32::from(2 * k >= matrices.len());
            found.push(edit(site, product(more, site.expr.span)).rarer(rare));
        }
    }
}

/// The terms of the equation: those of its sums, then its letters and their products.
fn pool(scene: &Scene<'_>) -> Vec<Expr> {
    let mut found: Vec<Expr> = Vec::new();
    let mut add = |expr: &Expr| {
        let matrix = matches!(
            expr.kind,
            ExprKind::Matrix { .. } | ExprKind::Underbrace { .. }
        );
        if !matrix && found.len() < TERMS && !found.contains(expr) {
            found.push(expr.clone());
        }
    };
    for site in scene.sites_in_time() {
        let whole = matches!(site.parent.map(|p| &p.kind), Some(ExprKind::Sum(_)));
        if whole && !matches!(site.expr.kind, ExprKind::Sum(_)) {
            add(site.expr);
        }
    }
    // What stands beside its transpose in an equation that is symmetric.
    for term in found.clone() {
        if let Some(other) = transposed_product(&term)
            && !found.contains(&other)
        {
            found.push(other);
        }
    }
    let mut add = |expr: &Expr| {
        if !found.contains(expr) {
            found.push(expr.clone());
        }
    };
    for letter in letters(scene) {
        add(&letter);
    }
    add(&number(1, Default::default()));
    found.truncate(TERMS);
    found
}

/// A term of the equation added to a sum, or to what stands alone.
fn with_terms(site: &Site<'_>, pool: &[Expr], found: &mut Vec<Replacement>) {
    if !site.takes_terms() || matches!(site.expr.kind, ExprKind::Constant) {
        return;
    }
    let span = site.expr.span;
    let present = terms(site.expr);
    for term in pool {
        if present.iter().any(|(_, t)| t == term) {
            continue;
        }
        let mut term = term.clone();
        term.span = span;
        for sign in [Sign::Plus, Sign::Minus] {
            let mut more = present.clone();
            more.push((sign, term.clone()));
            found.push(edit(site, sum(more, span)).rarer(5));
        }
    }
}
