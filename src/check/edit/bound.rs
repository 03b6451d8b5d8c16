//! Bound letters: another variable of integration, limits exchanged, the limits of a sum one off or
//! without a factor.

use super::build::{number, sum};
use super::{Replacement, Scene, Site, sites};
use crate::expr::walk::visit;
use crate::expr::{Display, Expr, ExprKind, Name, Sign};
use crate::model::links::Place;
use crate::verdict::EditClass;

pub(super) fn edits(scene: &Scene<'_>) -> Vec<Replacement> {
    let mut found = Vec::new();
    for site in scene.sites_in_time() {
        measure(site, &mut found);
        limits(site, &mut found);
        range(site, &mut found);
    }
    found
}

/// Another letter of the integrand as the variable of an integral.
pub fn measures(display: &Display, places: &[Place]) -> Vec<Replacement> {
    let mut found = Vec::new();
    for site in places.iter().flat_map(|p| sites(display, *p)) {
        measure(&site, &mut found);
    }
    found
}

fn measure(site: &Site<'_>, found: &mut Vec<Replacement>) {
    let ExprKind::Integral {
        limits,
        body,
        variable,
    } = &site.expr.kind
    else {
        return;
    };
    let mut names: Vec<Name> = Vec::new();
    visit(body, &mut |e| {
        if let ExprKind::Name(name) = &e.kind
            && name != variable
            && !names.contains(name)
        {
            names.push(name.clone());
        }
    });
    found.extend(names.into_iter().map(|variable| {
        let kind = ExprKind::Integral {
            limits: limits.clone(),
            body: body.clone(),
            variable,
        };
        let to = Expr::new(kind, site.expr.span);
        Replacement::new(site, EditClass::Measure, to)
    }));
}

/// The limits of an integral exchanged.
fn limits(site: &Site<'_>, found: &mut Vec<Replacement>) {
    if let ExprKind::Integral {
        limits: Some((from, to)),
        body,
        variable,
    } = &site.expr.kind
    {
        let kind = ExprKind::Integral {
            limits: Some((to.clone(), from.clone())),
            body: body.clone(),
            variable: variable.clone(),
        };
        let to = Expr::new(kind, site.expr.span);
        found.push(Replacement::new(site, EditClass::Measure, to));
    }
}

/// A limit of a sum that is no number: one off, or a factor or term less.
fn range(site: &Site<'_>, found: &mut Vec<Replacement>) {
    let limit =
        matches!(site.parent.map(|p| &p.kind), Some(ExprKind::BigSum { .. })) && site.step() < 2;
    if !limit || matches!(site.expr.kind, ExprKind::Number(_)) {
        return;
    }
    let span = site.expr.span;
    let mut edit = |to| found.push(Replacement::new(site, EditClass::Index, to));
    let terms = super::build::terms(site.expr);
    for sign in [Sign::Plus, Sign::Minus] {
        let mut more = terms.clone();
        match more.iter().position(|(_, e)| super::build::is_one(e)) {
            Some(k) if more[k].0 != sign => drop(more.remove(k)),
            _ => more.push((sign, number(1, span))),
        }
        edit(sum(more, span));
    }
}
