//! The other sign: of a term, of a whole side, bracket or bar, of an entry, of an exponent.

use super::build::{flipped, negated, sum};
use super::{Change, LONG, Replacement, Scene, Site};
use crate::expr::{ExprKind, Sign};
use crate::verdict::EditClass;
use num_traits::Zero;

pub(super) fn edits(scene: &Scene<'_>) -> Vec<Replacement> {
    scene.sites.iter().flat_map(of_site).collect()
}

fn of_site(site: &Site<'_>) -> Vec<Replacement> {
    let edit = |to| Replacement::new(site, EditClass::Sign, to);
    if let ExprKind::Sum(terms) = &site.expr.kind {
        let changed = |k: usize| {
            if terms.len() > LONG {
                let (sign, term) = &terms[k];
                let by = vec![(flipped(*sign), term.clone())];
                let change = Change::of_terms(terms, k, k + 1, by);
                return Replacement::of(site, EditClass::Sign, change);
            }
            let mut terms = terms.clone();
            // In front of the first term nothing is printed that could be the other sign.
            let rare = u32::from(k == 0 && terms[k].0 == Sign::Plus && terms.len() > 1);
            terms[k].0 = flipped(terms[k].0);
            edit(sum(terms, site.expr.span)).rarer(rare)
        };
        return (0..terms.len()).map(changed).collect();
    }
    let in_sum = matches!(site.parent.map(|p| &p.kind), Some(ExprKind::Sum(_)));
    let exponent =
        matches!(site.parent.map(|p| &p.kind), Some(ExprKind::Power { .. })) && site.step() == 1;
    // The exponent 2 with a minus is a reciprocal, and rarer than a lost minus before a term.
    if exponent {
        let mut negative = edit(negated(site.expr.clone())).rarer(20);
        negative.class = EditClass::Exponent;
        return vec![negative];
    }
    let zero = matches!(&site.expr.kind, ExprKind::Number(n) if n.is_zero());
    let container = matches!(
        site.expr.kind,
        ExprKind::Matrix { .. } | ExprKind::Underbrace { .. } | ExprKind::Constant
    ) && site.parent.is_some();
    if !site.is_monomial() || in_sum || zero || container {
        return Vec::new();
    }
    vec![edit(negated(site.expr.clone()))]
}
