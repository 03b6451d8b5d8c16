//! Numerator and denominator exchanged, and a quotient for a product.

use super::build::{factors, product, quotient};
use super::{Replacement, Scene};
use crate::expr::{ExprKind, QuotientStyle};
use crate::verdict::EditClass;

pub(super) fn edits(scene: &Scene<'_>) -> Vec<Replacement> {
    let mut found = Vec::new();
    for site in scene.sites_in_time() {
        let span = site.expr.span;
        let mut edit = |to, rare| {
            found.push(Replacement::new(site, EditClass::Inversion, to).rarer(rare));
        };
        match &site.expr.kind {
            ExprKind::Quotient {
                numerator,
                denominator,
                style,
            } => {
                let (above, below) = ((**numerator).clone(), (**denominator).clone());
                edit(quotient(below, above, *style, span), 0);
                let mut all = factors(numerator);
                all.extend(factors(denominator));
                edit(product(all, span), 2);
            }
            ExprKind::Product(items) if items.len() == 2 => {
                let (above, below) = (items[0].clone(), items[1].clone());
                let matrix = super::mark::may_be_matrix(&below);
                if !matrix {
                    edit(quotient(above, below, QuotientStyle::Bar, span), 3);
                }
            }
            _ => {}
        }
    }
    found
}
