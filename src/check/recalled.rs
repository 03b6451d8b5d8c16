//! What a document only states, tried as if it were claimed.
//!
//! A recalled equation counts as nothing, and no verdict rests on this; but that one can be shown
//! false as an identity is said, so that `recall` is no way to pass what is wrong.

use super::{Checker, Options};
use crate::expr::Relation;
use crate::model::{Model, Role};
use crate::verdict::Verdict;

/// The recalled links, by equation and number of the link, that are false as identities in the
/// printed letters. What cannot be evaluated is left out, and so is the search for corrections.
pub(crate) fn recalled_and_false(model: &Model, options: Options) -> Vec<(usize, usize)> {
    let recalled = |e: usize, member: usize| {
        let equation = &model.equations[e];
        matches!(equation.role, Role::Recall(_))
            || equation.settings.recalled_members.contains_key(&member)
    };
    let links = model
        .equations
        .iter()
        .enumerate()
        .flat_map(|(e, equation)| {
            let links = equation.links.iter().enumerate();
            links.map(move |(l, link)| (e, l, *link))
        });
    let tried: Vec<_> = links
        .filter(|(e, l, link)| {
            let equation = &model.equations[*e];
            recalled(*e, link.member)
                && link.left != link.right
                && link.relation == Relation::Equal
                && equation.defines[*l].is_none()
                && equation.assume.is_empty()
                && model.check_names_of(*e, &equation.display).is_empty()
        })
        .collect();
    if tried.is_empty() {
        return Vec::new();
    }
    let options = Options {
        repair: false,
        ..options
    };
    let Ok(mut checker) = Checker::new(model, options) else {
        return Vec::new();
    };
    let is_false = |(e, _, link): &(usize, usize, _)| {
        let verdict = checker.bounded_in_all(|checker| checker.claim(*e, link));
        matches!(verdict, Ok(Verdict::Refuted(_)))
    };
    let found: Vec<_> = tried.into_iter().filter(is_false).collect();
    found
        .into_iter()
        .map(|(e, _, link)| (e, link.member))
        .collect()
}
