//! Whether the search for corrections finds the way back from a mutant.

use super::bench::Bench;
use super::dependence::values_of;
use super::mutants::Mutant;
use super::{Fate, Options, Tried};
use crate::check;
use crate::expr::Display;
use crate::latex;
use crate::model::Node;
use std::collections::BTreeSet;

/// What the search proposes for a mutant.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Repair {
    /// Whether its first proposal is the original, or is proved to say the same.
    pub first: bool,
    /// Whether the original is among its proposals.
    pub any: bool,
    /// The first proposal in LaTeX, if it has one.
    pub proposal: Option<String>,
}

/// Which of the mutants the search is tried on: a sample of the refuted claims.
pub(super) fn chosen(tried: &[Tried], mutants: &[&Mutant], options: &Options) -> Vec<usize> {
    let refuted: Vec<usize> = (0..tried.len())
        .filter(|k| {
            let claim = !tried[*k].definition && !mutants[*k].structural;
            claim && matches!(tried[*k].fate, Fate::Refuted { .. })
        })
        .collect();
    match options.repairs {
        Some(limit) => super::sample(refuted, limit, options.seed),
        None => refuted,
    }
}

impl Bench<'_, '_> {
    /// What the search proposes for a mutant of a claim.
    pub(super) fn repair(&mut self, mutant: &Mutant) -> Repair {
        let (e, l) = mutant.at;
        let stale = self.stale(values_of(self.model, e).into_iter().map(|(node, _)| node));
        let damaged = self.checkers[0].changed(e, mutant.display.clone(), &stale);
        let mut searching = damaged.spending(check::Options {
            threads: 1,
            ..check::Options::default()
        });
        let correction = searching.correction(e, l);
        drop((searching, damaged));
        let mut repair = Repair {
            first: false,
            any: false,
            proposal: None,
        };
        if let Some(correction) = correction {
            // The display is the mutant's own where a definition is proposed instead.
            let proposed = correction.definition.as_ref();
            let proposed = proposed.map_or(&correction.display, |(_, display)| display);
            repair.proposal = Some(latex::write_display(proposed));
            repair.first = correction.definition.is_none()
                && self.says_the_same(mutant, &correction.display, &stale);
            repair.any = repair.first
                || correction
                    .others
                    .iter()
                    .any(|other| self.says_the_same(mutant, &other.display, &stale));
        }
        if let Some(table) = &self.model.functions {
            table.take_back(self.letters);
        }
        repair
    }

    /// Whether a display is the original, or both sides of the link have its values.
    fn says_the_same(
        &mut self,
        mutant: &Mutant,
        display: &Display,
        stale: &BTreeSet<Node>,
    ) -> bool {
        let (e, l) = mutant.at;
        let equation = &self.model.equations[e];
        if latex::write_display(display) == latex::write_display(&equation.display) {
            return true;
        }
        let link = &equation.links[l];
        let checker = &mut self.checkers[0];
        let original = checker.expanded_sides(e, &equation.display, link);
        let mut mended = checker.changed(e, display.clone(), stale);
        let proposed = mended.expanded_sides(e, display, link);
        proposed.is_some() && proposed == original
    }
}
