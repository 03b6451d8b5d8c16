//! Whether a rewritten claim keeps its verdict.

use super::bench::{Bench, LOST, checkers};
use super::fresh::Anew;
use super::rewritings::{Rewriting, Rewritten};
use super::{Case, Class, Fate};
use crate::check::trial::Finding;
use crate::document::Document;
use crate::latex;
use crate::model::{Model, Node};
use std::collections::BTreeSet;

/// What becomes of a rewritten claim.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Kept {
    /// It is accepted as before.
    Accepted,
    /// It is not decided any more.
    Undecided(String),
    /// It is called false or without a meaning: a fault of ours.
    Rejected(String),
}

/// One rewriting and what became of it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Said {
    /// The label of the equation.
    pub label: String,
    /// Its link, from 1.
    pub member: usize,
    /// How it was rewritten.
    pub rewriting: Rewriting,
    /// The equation as it was, in LaTeX.
    pub printed: String,
    /// The rewritten equation.
    pub rewritten: String,
    /// What became of it.
    pub kept: Kept,
}

pub(super) fn said(model: &Model, rewritten: &Rewritten, kept: Kept) -> Said {
    let (e, l) = rewritten.at;
    let equation = &model.equations[e];
    Said {
        label: equation.label.clone(),
        member: equation.links[l].member,
        rewriting: rewritten.rewriting,
        printed: latex::write_display(&equation.display),
        rewritten: latex::write_display(&rewritten.display),
        kept,
    }
}

impl Bench<'_, '_> {
    /// What becomes of a rewriting.
    pub(super) fn keeps(&mut self, rewritten: &Rewritten) -> Kept {
        if let Some(anew) = &rewritten.anew {
            return self.keeps_anew(rewritten, anew);
        }
        let e = rewritten.at.0;
        let original = self.model.equations[e].display.clone();
        let changed = self.changed(e, &rewritten.display);
        let nodes: BTreeSet<Node> = changed.nodes.iter().map(|(node, _)| *node).collect();
        let dependents = self.plan.dependences.dependents(&nodes);
        for instance in 0..self.checkers.len() {
            let display = rewritten.display.clone();
            let mut checker = self.checkers[instance].changed(e, display, &dependents.stale);
            let kept = match checker.nonsense() {
                Some(nonsense) => Kept::Rejected(nonsense.to_string()),
                None => {
                    let case = Case {
                        class: Class::Rewriting(rewritten.rewriting),
                        original: &original,
                        changed: &rewritten.display,
                    };
                    of_fate(self.judged(&mut checker, e, &case, &changed, &dependents))
                }
            };
            drop(checker);
            if let Some(table) = &self.model.functions {
                table.take_back(self.letters);
            }
            if kept != Kept::Accepted {
                return kept;
            }
        }
        Kept::Accepted
    }

    fn keeps_anew(&self, rewritten: &Rewritten, anew: &Anew) -> Kept {
        let refused = || Kept::Rejected("the document is refused".into());
        let Ok(document) = Document::parse(&self.plan.document.name, &anew.text) else {
            return refused();
        };
        let Ok(model) = Model::build(&document) else {
            return refused();
        };
        let Ok(mut checkers) = checkers(&model) else {
            return refused();
        };
        let Some(e) = model.equation(&anew.label) else {
            return refused();
        };
        let case = Case {
            class: Class::Rewriting(rewritten.rewriting),
            original: &self.model.equations[rewritten.at.0].display,
            changed: &rewritten.display,
        };
        for member in anew.members.clone() {
            for checker in &mut checkers {
                let decide = self.plan.decide;
                let found = decide.decide(&case, &mut || checker.finding(e, member - 1));
                match found {
                    Finding::Accepted => {}
                    Finding::Undecided(reason) => return Kept::Undecided(reason),
                    Finding::Refuted => return Kept::Rejected("called false".into()),
                    Finding::Meaningless(nonsense) => return Kept::Rejected(nonsense.to_string()),
                    Finding::NothingToCheck => return Kept::Undecided(LOST.into()),
                }
            }
        }
        Kept::Accepted
    }
}

/// What a fate says of a rewriting; it passes where nothing speaks against it.
fn of_fate(fate: Fate) -> Kept {
    match fate {
        Fate::Survived | Fate::Equivalent(_) => Kept::Accepted,
        Fate::Undecided(reason) => Kept::Undecided(reason),
        Fate::Refuted { by, .. } => Kept::Rejected(format!("({}.{}) is called false", by.0, by.1)),
        Fate::Meaningless { why, .. } => Kept::Rejected(why.to_string()),
    }
}
