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
mod replacement;
mod rows;
mod sign;
mod term;
pub mod written;

pub use address::{Address, Site, sites};
pub use bound::measures;
pub use context::{Context, Kind, Known};
pub(super) use letter::name_of;
pub use mark::dots_below;
pub use replacement::{Change, Replacement};
pub use rows::braces_under_all_rows;

use crate::expr::{Display, Expr, ExprKind};
use crate::model::links::Place;
use crate::progress::interrupted;
use crate::verdict::EditClass;
use std::collections::{BTreeMap, BTreeSet};

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

/// How many nodes all edits of an equation put in together, at most.
const ROOM: usize = 120_000;

/// From how many terms on a sum is not copied for each of its edits.
const LONG: usize = 64;

/// What the classes look at.
pub(super) struct Scene<'a> {
    pub display: &'a Display,
    pub sites: Vec<Site<'a>>,
    pub context: &'a Context,
}

impl<'a> Scene<'a> {
    /// The sites, until somebody asks to stop.
    fn sites_in_time(&self) -> impl Iterator<Item = &Site<'a>> {
        self.sites.iter().take_while(|_| !interrupted())
    }
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
    let mut found: Vec<Replacement> = Vec::new();
    let mut room = ROOM;
    for class in classes {
        if interrupted() {
            break;
        }
        // The first classes are the likeliest slips: of a very long equation they are all there is.
        for edit in class(&scene) {
            let size = edit.change.size() + 1;
            if size > room {
                break;
            }
            room -= size;
            found.push(edit);
        }
    }
    // What is named alone on the left is computed on the right, where slips are likelier.
    for edit in &mut found {
        let side = edit.address.place.find(display).map(Expr::without_brackets);
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
    let expressions: BTreeMap<&Address, &Expr> =
        scene.sites.iter().map(|s| (&s.address, s.expr)).collect();
    let mut seen: BTreeSet<(Address, String)> = BTreeSet::new();
    found.retain(|r| {
        let printed = expressions.get(&r.address);
        let text = printed.and_then(|printed| r.change.text(printed));
        text.is_some_and(|text| seen.insert((r.address.clone(), text)))
    });
    found
}
