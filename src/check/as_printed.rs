//! Verdicts on what rests on corrected equations.
//!
//! Slips do not cascade: what a misprint would spoil further down is computed from the corrected equation. But
//! what holds as printed holds, whatever was corrected elsewhere; and where something holds only with a
//! correction, the verdict names it. So an equation is false only where it is false both ways.

use super::Checker;
use crate::expr::Expr;
use crate::model::Node;
use crate::verdict::{Outcome, Verdict};
use std::collections::BTreeSet;

/// What is known of a link as it is printed.
#[derive(Clone, Debug)]
pub(super) enum Known {
    /// Nothing that would count, or that it is false.
    Nothing,
    /// It holds.
    Held(Box<Outcome>),
    /// It is undecided.
    Open(Box<Outcome>),
}

impl<'m> Checker<'m> {
    /// What is known of an equation's links as they are printed, where corrections of other equations are behind
    /// it, and these equations.
    pub(super) fn known_as_printed(&mut self, equation: usize) -> (Vec<Known>, Vec<usize>) {
        let printed = &self.model.equations[equation];
        let none = vec![Known::Nothing; printed.links.len()];
        let display = self.exact.display(equation);
        let sides = printed.links.iter().flat_map(|l| [l.left, l.right]);
        let sides = sides.filter_map(|place| place.find(display));
        let supposed = printed.assume.iter().chain(&printed.given);
        let behind = self.corrected_behind(
            sides.chain(supposed.flat_map(|h| [&h.left, &h.right])),
            Some(equation),
        );
        if behind.is_empty() {
            return (none, behind);
        }
        let mut there = self.as_printed(&behind).only_judging();
        let outcomes = there.settle_in_world(equation, none);
        self.pool = there.pool;
        let known = outcomes.into_iter().map(|outcome| match outcome.verdict {
            _ if outcome.contradiction.is_some() => Known::Nothing,
            Verdict::Holds { .. } | Verdict::HoldsGiven(..) => Known::Held(Box::new(outcome)),
            Verdict::Undecided { .. } => Known::Open(Box::new(outcome)),
            Verdict::Misprint { .. }
            | Verdict::Refuted(_)
            | Verdict::Definition { .. }
            | Verdict::Recalled { .. } => Known::Nothing,
        });
        (known.collect(), behind)
    }

    /// The outcome of a link of which something is known: what holds as printed holds, and what is not known to
    /// be false as printed is not said to be false.
    pub(super) fn outcome_knowing(
        &mut self,
        equation: usize,
        l: usize,
        unusable: Option<&str>,
        known: Known,
    ) -> Outcome {
        match known {
            Known::Nothing => self.outcome(equation, l, unusable),
            Known::Held(outcome) => *outcome,
            Known::Open(outcome) => {
                let repair = std::mem::replace(&mut self.options.repair, false);
                let corrected = self.outcome(equation, l, unusable);
                self.options.repair = repair;
                match corrected.verdict {
                    Verdict::Misprint { .. } | Verdict::Refuted(_) => *outcome,
                    Verdict::Holds { .. }
                    | Verdict::HoldsGiven(..)
                    | Verdict::Undecided { .. }
                    | Verdict::Definition { .. }
                    | Verdict::Recalled { .. } => corrected,
                }
            }
        }
    }

    /// The equations but one whose corrections give something behind some expressions another value.
    pub(super) fn corrected_behind<'e>(
        &self,
        expressions: impl Iterator<Item = &'e Expr>,
        but: Option<usize>,
    ) -> Vec<usize> {
        let world = self.exact.world();
        let mut corrected: BTreeSet<(usize, Node)> = BTreeSet::new();
        for (equation, display) in world.corrections().filter(|(e, _)| Some(*e) != but) {
            let printed = &self.model.equations[equation].display;
            for (d, definition) in self.model.definitions.iter().enumerate() {
                let place = definition.place;
                if definition.equation == equation && place.find(display) != place.find(printed) {
                    corrected.insert((equation, Node::Definition(d)));
                }
            }
            for (system, solved) in self.model.systems.iter().enumerate() {
                let unknowns = 0..solved.unknowns.len();
                if solved.equation == equation {
                    corrected.extend(
                        unknowns.map(|position| (equation, Node::Unknown { system, position })),
                    );
                }
            }
        }
        if corrected.is_empty() {
            return Vec::new();
        }
        let nodes = self.nodes_behind(expressions);
        let behind = corrected
            .into_iter()
            .filter(|(_, node)| nodes.contains(node));
        let behind: BTreeSet<usize> = behind.map(|(equation, _)| equation).collect();
        behind.into_iter().collect()
    }

    /// What the names behind some expressions stand for, through all definitions.
    pub(super) fn nodes_behind<'e>(
        &self,
        expressions: impl Iterator<Item = &'e Expr>,
    ) -> BTreeSet<Node> {
        let display = |equation: usize| self.exact.display(equation);
        let mut nodes = BTreeSet::new();
        for expression in expressions {
            self.model.visit_behind(expression, &display, &mut |e| {
                self.model.collect(e, &mut nodes);
            });
        }
        nodes
    }

    /// The same checker where no corrections are searched for and nobody is told.
    pub(super) fn only_judging(mut self) -> Self {
        self.options.repair = false;
        self.tell = None;
        self
    }

    /// A checker in the world in which these equations stand as they are printed.
    pub(super) fn as_printed(&self, equations: &[usize]) -> Checker<'m> {
        let world = self.exact.world().clone().as_printed(equations);
        let mut there = self.beside(self.exact.in_world(world));
        there.insert_abbreviations();
        there.in_definitions = false;
        there
    }
}
