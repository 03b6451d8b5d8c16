//! Single edits of an equation: what a typist, a typesetter or an author could have done.
//!
//! Every edit replaces one subexpression, addressed by the way to it. The lists are finite and
//! deterministic, and depend on what is printed and on which letters the document has, never on
//! what would make the equation true. Each class has its file; each slip that is in a list has its
//! inverse there too, as far as what was lost still stands somewhere in the document.

mod address;
mod bound;
mod bracket;
pub mod build;
mod context;
mod exponent;
pub mod form;
mod index;
mod letter;
mod literal;
mod mark;
mod quotient;
mod rows;
mod sign;
mod term;
pub mod written;

pub use address::{Address, Site, sites};
pub use bound::measures;
pub use context::{Context, Kind, Known};
pub(super) use letter::name_of;
pub use mark::dots_below;
pub use rows::braces_under_all_rows;

use crate::expr::{Display, Expr, ExprKind, Sign};
use crate::latex;
use crate::model::links::Place;
use crate::verdict::{Edit, EditClass};
use std::collections::BTreeSet;

/// A subexpression and what to put in its place.
#[derive(Clone, Debug)]
pub struct Replacement {
    /// Where.
    pub address: Address,
    /// What kind of slip it would repair.
    pub class: EditClass,
    /// What to put there.
    pub kind: ExprKind,
    /// How far-fetched it is: ten times the rank of its class, and a little more for what is rarer.
    pub cost: u32,
}

impl Replacement {
    /// An edit with the cost of its class.
    pub fn new(site: &Site<'_>, class: EditClass, to: Expr) -> Self {
        Replacement {
            address: site.address.clone(),
            class,
            kind: to.kind,
            cost: cost_of(class),
        }
    }

    /// The same with a higher cost.
    #[must_use]
    pub fn rarer(mut self, by: u32) -> Self {
        self.cost += by;
        self
    }

    /// Changes the display; `false` when the address is not in it.
    pub fn apply(&self, display: &mut Display) -> bool {
        match self.address.find_mut(display) {
            Some(expr) => {
                expr.kind = self.kind.clone();
                true
            }
            None => false,
        }
    }

    /// The change in LaTeX: of a long sum or product the part that differs.
    pub fn describe(&self, display: &Display) -> Option<Edit> {
        let old = self.address.find(display)?;
        let (printed, corrected) = differing(old, &self.kind);
        Some(Edit {
            class: self.class,
            span: printed.span,
            printed: latex::write_expr(&printed),
            corrected: latex::write_expr(&corrected),
        })
    }
}

/// Ten times the rank of a class.
pub fn cost_of(class: EditClass) -> u32 {
    match class {
        EditClass::Sign => 10,
        EditClass::Factor => 20,
        EditClass::Exponent => 30,
        EditClass::Index => 40,
        EditClass::Letter => 50,
        EditClass::Term => 60,
        EditClass::Bracket => 70,
        EditClass::Transpose | EditClass::Dot => 80,
        EditClass::Inversion => 90,
        EditClass::Measure | EditClass::Limit => 100,
    }
}

/// What it costs more to change a left side that is a name.
const SUBJECT: u32 = 60;

/// Terms that stay beside what differs when an edit of a long sum is described.
const SHOWN: usize = 1;

/// Of two sums that begin and end alike, the parts that differ.
fn differing(old: &Expr, new: &ExprKind) -> (Expr, Expr) {
    let whole = || (old.clone(), Expr::new(new.clone(), old.span));
    let (ExprKind::Sum(before), ExprKind::Sum(after)) = (&old.kind, new) else {
        return whole();
    };
    if before.len().max(after.len()) <= 4 {
        return whole();
    }
    let pairs = before.iter().zip(after);
    let alike = pairs.take_while(|(one, other)| one == other).count();
    let shorter = before.len().min(after.len()) - alike;
    let pairs = before.iter().rev().zip(after.iter().rev());
    let after_it = pairs
        .take(shorter)
        .take_while(|(one, other)| one == other)
        .count();
    let (from, behind) = (alike.saturating_sub(SHOWN), after_it.saturating_sub(SHOWN));
    let part = |terms: &[(Sign, Expr)]| {
        let terms = terms[from..terms.len() - behind].to_vec();
        let span = match (terms.first(), terms.last()) {
            (Some(first), Some(last)) => first.1.span.to(last.1.span),
            _ => old.span,
        };
        build::sum(terms, span)
    };
    (part(before), part(after))
}

/// What the classes look at.
pub(super) struct Scene<'a> {
    pub display: &'a Display,
    pub sites: Vec<Site<'a>>,
    pub context: &'a Context,
}

/// A class: its edits of an equation.
type Class = fn(&Scene<'_>) -> Vec<Replacement>;

/// All single edits of the sides at these places, the cheapest first; no two put the same at the
/// same address, and none changes nothing.
pub fn singles(display: &Display, places: &[Place], context: &Context) -> Vec<Replacement> {
    let scene = Scene {
        display,
        sites: places.iter().flat_map(|p| sites(display, *p)).collect(),
        context,
    };
    let classes: [Class; 10] = [
        sign::edits,
        literal::edits,
        exponent::edits,
        index::edits,
        letter::edits,
        term::edits,
        bracket::edits,
        mark::edits,
        quotient::edits,
        bound::edits,
    ];
    let mut found: Vec<Replacement> = classes.iter().flat_map(|class| class(&scene)).collect();
    // What is named alone on the left is computed on the right, where slips are likelier.
    for edit in &mut found {
        let side = edit.address.place.find(display).map(build::inside);
        let named = side.is_some_and(|e| match &e.kind {
            ExprKind::Power { base, .. } => matches!(base.kind, ExprKind::Name(_)),
            kind => matches!(kind, ExprKind::Name(_) | ExprKind::Apply { .. }),
        });
        if named && places.len() > 1 && places.first() == Some(&edit.address.place) {
            // Another subject altogether is the last that a reader would think of.
            let whole = edit.address.path.is_empty() && edit.class != EditClass::Dot;
            edit.cost += if whole { SUBJECT } else { 1 };
        }
    }
    found.sort_by_key(|r| r.cost);
    let mut seen: BTreeSet<(Address, String)> = BTreeSet::new();
    for site in &scene.sites {
        seen.insert((site.address.clone(), latex::write_expr(site.expr)));
    }
    found.retain(|r| {
        let text = latex::write_expr(&Expr::new(r.kind.clone(), crate::span::Span::default()));
        seen.insert((r.address.clone(), text))
    });
    found
}
