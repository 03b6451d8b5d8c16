//! Marks on a letter: dots above it or above its index, primes, transpositions.

use super::letter::{name_of, with_name};
use super::{Replacement, Scene, Site, sites};
use crate::expr::{Display, Expr, ExprKind, Font, Name, Subscript};
use crate::latex;
use crate::model::links::Place;
use crate::verdict::EditClass;

pub(super) fn edits(scene: &Scene<'_>) -> Vec<Replacement> {
    let mut found = dots(scene);
    found.extend(scene.sites.iter().flat_map(dot_below));
    found.extend(scene.sites.iter().flat_map(|site| primes(scene, site)));
    found.extend(scene.sites.iter().filter_map(transposed));
    found
}

/// One dot more or less over each dotted name, one dot on each name that occurs dotted or is a
/// process, and one on a name that stands alone under a brace.
fn dots(scene: &Scene<'_>) -> Vec<Replacement> {
    let dotted: Vec<Name> = scene
        .sites
        .iter()
        .filter_map(|site| name_of(site.expr))
        .filter(|n| n.dots > 0)
        .map(Name::undotted)
        .collect();
    let mut found = Vec::new();
    for site in scene.sites_in_time() {
        let Some(name) = name_of(site.expr) else {
            continue;
        };
        let label = matches!(site.address.place, Place::Label { .. }) && site.parent.is_none();
        let process = scene.context.kind_of(name) == super::Kind::Process;
        if !label && !process && !dotted.contains(&name.undotted()) {
            continue;
        }
        for dots in [name.dots.checked_add(1), name.dots.checked_sub(1)] {
            let Some(dots) = dots.filter(|d| *d <= 4) else {
                continue;
            };
            let name = Name {
                dots,
                ..name.clone()
            };
            let to = with_name(site.expr, name);
            found.push(Replacement::new(site, EditClass::Dot, to));
        }
    }
    found
}

/// One dot more or less over the letter in a subscript, as in the spectrum of a derivative.
pub fn dots_below(display: &Display, places: &[Place]) -> Vec<Replacement> {
    let all = places.iter().flat_map(|p| sites(display, *p));
    all.flat_map(|site| dot_below(&site)).collect()
}

fn dot_below(site: &Site<'_>) -> Vec<Replacement> {
    let Some(name) = name_of(site.expr) else {
        return Vec::new();
    };
    let Some([index]) = name.subscript.as_ref().map(|s| s.indices.as_slice()) else {
        return Vec::new();
    };
    let ExprKind::Name(below) = &index.kind else {
        return Vec::new();
    };
    if below.dots == 0 {
        return Vec::new();
    }
    [below.dots + 1, below.dots - 1]
        .into_iter()
        .map(|dots| {
            let below = Name {
                dots,
                ..below.clone()
            };
            let below = Expr::new(ExprKind::Name(below), index.span);
            let subscript = Subscript {
                label: latex::write_expr(&below),
                indices: vec![below],
            };
            let renamed = Name {
                subscript: Some(subscript),
                ..name.clone()
            };
            let mut edit = Replacement::new(site, EditClass::Dot, with_name(site.expr, renamed));
            // A dot in an index is smaller than anything else that is printed.
            edit.cost = 25;
            edit
        })
        .collect()
}

/// A prime more or less, where the document has that letter.
fn primes(scene: &Scene<'_>, site: &Site<'_>) -> Vec<Replacement> {
    let Some(name) = name_of(site.expr) else {
        return Vec::new();
    };
    let primes = name.letter.primes;
    [primes.checked_add(1), primes.checked_sub(1)]
        .into_iter()
        .flatten()
        .map(|primes| {
            let mut other = name.clone();
            other.letter.primes = primes;
            other
        })
        .filter(|other| {
            let undotted = other.undotted();
            scene.context.letters.iter().any(|k| k.name == undotted)
        })
        .map(|other| Replacement::new(site, EditClass::Dot, with_name(site.expr, other)))
        .collect()
}

/// A transposition more on a bold letter, bracket or matrix, or one less where there is one.
fn transposed(site: &Site<'_>) -> Option<Replacement> {
    let to = match &site.expr.kind {
        ExprKind::Transpose(inner) => (**inner).clone(),
        _ if may_be_matrix(site.expr) && !inside_transpose(site) => {
            let inner = Box::new(site.expr.clone());
            Expr::new(ExprKind::Transpose(inner), site.expr.span)
        }
        _ => return None,
    };
    Some(Replacement::new(site, EditClass::Transpose, to))
}

/// Whether a letter, bracket or matrix could be a matrix by what is printed: something bold in it.
pub(super) fn may_be_matrix(expr: &Expr) -> bool {
    let bold = |e: &Expr| name_of(e).is_some_and(|n| n.letter.font == Font::Bold);
    match &expr.kind {
        ExprKind::Name(_) | ExprKind::Apply { .. } => bold(expr),
        ExprKind::Matrix { .. } => true,
        ExprKind::Transpose(inner) => may_be_matrix(inner),
        ExprKind::Power { base, .. } => may_be_matrix(base),
        ExprKind::Group { .. } => {
            let mut any = false;
            crate::expr::walk::visit(expr, &mut |e| {
                any |= bold(e) || matches!(e.kind, ExprKind::Matrix { .. });
            });
            any
        }
        _ => false,
    }
}

/// Whether the expression is what is transposed already.
fn inside_transpose(site: &Site<'_>) -> bool {
    matches!(site.parent.map(|p| &p.kind), Some(ExprKind::Transpose(_)))
}
