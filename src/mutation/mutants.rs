//! The mutants of a document: each claim and each definition with one edit.

use super::dependence::LinkAt;
use crate::check::edit::{self, Context, Replacement};
use crate::expr::{Display, Expr, ExprKind};
use crate::latex;
use crate::model::links::{Link, underbraces};
use crate::model::{Model, Role};
use crate::verdict::{Edit, EditClass};
use std::collections::BTreeSet;

/// An equation with one edit.
#[derive(Clone, Debug)]
pub(super) struct Mutant {
    /// The equation and the link whose sides the edit is in, as indices.
    pub at: LinkAt,
    /// The class of the edit.
    pub class: EditClass,
    /// The edit in LaTeX: `printed` is the original, `corrected` the damage.
    pub edit: Edit,
    /// The damaged display.
    pub display: Display,
    /// Whether the document has to be read anew, because the edit changes which names are defined.
    pub structural: bool,
}

/// All mutants of the links in `links`, in the order of the document; each damaged display once.
pub(super) fn mutants(model: &Model, links: &[LinkAt]) -> Vec<Mutant> {
    let mut found: Vec<Mutant> = Vec::new();
    let mut seen: BTreeSet<(usize, String)> = BTreeSet::new();
    for &(e, l) in links {
        let equation = &model.equations[e];
        let link = &equation.links[l];
        for replacement in singles(model, &equation.display, link) {
            let mut display = equation.display.clone();
            if !replacement.apply(&mut display) {
                continue;
            }
            let Some(edit) = replacement.describe(&equation.display) else {
                continue;
            };
            if !seen.insert((e, latex::write_display(&display))) {
                continue;
            }
            found.push(Mutant {
                at: (e, l),
                class: replacement.class,
                edit,
                structural: is_structural(model, e, &display),
                display,
            });
        }
    }
    found
}

/// Every single edit of a link: the list that the search for corrections uses.
pub(super) fn singles(model: &Model, display: &Display, link: &Link) -> Vec<Replacement> {
    edit::singles(display, &[link.left, link.right], &Context::of(model))
}

/// Whether a damaged display defines other names than the original, or is put together otherwise.
fn is_structural(model: &Model, e: usize, display: &Display) -> bool {
    let equation = &model.equations[e];
    let original = &equation.display;
    let braces = |d: &Display| -> Vec<usize> {
        let clauses = d.clauses.iter();
        clauses.map(|c| underbraces(&c.chain).len()).collect()
    };
    if braces(original) != braces(display) {
        return true;
    }
    let changed = |place: crate::model::links::Place| place.find(original) != place.find(display);
    let renamed = equation
        .links
        .iter()
        .zip(&equation.defines)
        .any(|(link, d)| {
            d.is_some_and(|d| {
                let value = model.definitions[d].place;
                [link.left, link.right]
                    .into_iter()
                    .any(|place| place != value && changed(place))
            })
        });
    renamed || equation.role == Role::Define && abbreviates_no_more(model, e, display)
}

/// Whether a definition that is kept as a letter could not be one any more, or its sign is relied on.
fn abbreviates_no_more(model: &Model, e: usize, display: &Display) -> bool {
    let mut definitions = model.definitions.iter().filter(|d| d.equation == e);
    definitions.any(|definition| {
        let Some(value) = definition.place.find(display) else {
            return true;
        };
        let original = definition.place.find(&model.equations[e].display);
        definition.letter.is_some()
            && original != Some(value)
            && (model.functions.is_some() || !is_constant(model, value))
    })
}

/// Whether an expression is arithmetic on names of constants.
fn is_constant(model: &Model, value: &Expr) -> bool {
    let mut constant = true;
    crate::expr::walk::visit(value, &mut |e| {
        constant &= match &e.kind {
            ExprKind::Number(_)
            | ExprKind::Sum(_)
            | ExprKind::Product(_)
            | ExprKind::Quotient { .. }
            | ExprKind::Group { .. }
            | ExprKind::Power { .. } => true,
            ExprKind::Name(name) => match model.resolve(name, &|_| false) {
                Ok(crate::model::names::Resolved::Letter { symbol, order: 0 }) => {
                    model.symbols[symbol].function_of.is_none()
                }
                Ok(crate::model::names::Resolved::Node {
                    node: crate::model::Node::Definition(d),
                    derivatives: 0,
                }) => model.definitions[d].letter.is_some(),
                _ => false,
            },
            _ => false,
        };
    });
    constant
}
