//! Checkers in other worlds: with a display in place of a printed one, under hypotheses, with a node
//! that has no value.
//!
//! A trial is a checker of its own that is dropped when it is over; a checker goes on in another world
//! where a correction is accepted or something is found to have no value. Invariant: the values of the
//! abbreviations are those of the checker's world.

use super::hypotheses::Supposed;
use super::{Checker, Options, bounded};
use crate::domain::{Domain, Symbolic};
use crate::evaluate::{self, Evaluator, Failure, FailureKind, Value};
use crate::expr::Display;
use crate::model::{Letter, Node, Role};
use crate::verdict::certificate::Print;
use ratpoly::allowance::Exhausted;
use ratpoly::{RationalFunction, allowance};
use std::collections::{BTreeMap, BTreeSet};
use std::sync::{Arc, OnceLock};

/// For each letter that is an abbreviation, its value in the declared symbols.
pub(crate) type Insertions = BTreeMap<usize, RationalFunction>;

/// The equations as printed, with their hashes, each made once.
pub(super) type Prints = Arc<[OnceLock<Arc<Print>>]>;

impl<'m> Checker<'m> {
    /// A checker that has found nothing yet.
    pub(super) fn with(
        exact: Evaluator<'m, Symbolic>,
        options: Options,
        inserted: Arc<Insertions>,
        supposed: Arc<Supposed>,
    ) -> Self {
        let prints = exact.model().equations.iter();
        let prints = prints.map(|_| OnceLock::new()).collect();
        Checker::with_prints(exact, options, inserted, supposed, prints)
    }

    fn with_prints(
        exact: Evaluator<'m, Symbolic>,
        options: Options,
        inserted: Arc<Insertions>,
        supposed: Arc<Supposed>,
        prints: Prints,
    ) -> Self {
        Checker {
            model: exact.model(),
            instance: exact.world().instance(),
            exact,
            options,
            supposed,
            inserted,
            diagnostics: Vec::new(),
            readings: Default::default(),
            in_definitions: true,
            tell: None,
            failure: None,
            contradiction: None,
            pool: bounded::Pool::default(),
            prints,
        }
    }

    /// A checker with another evaluator, which has found nothing yet.
    pub(super) fn elsewhere(
        &self,
        exact: Evaluator<'m, Symbolic>,
        inserted: Arc<Insertions>,
        supposed: Arc<Supposed>,
    ) -> Self {
        let prints = Arc::clone(&self.prints);
        Checker {
            in_definitions: self.in_definitions,
            tell: self.tell,
            pool: self.pool,
            ..Checker::with_prints(exact, self.options, inserted, supposed, prints)
        }
    }

    /// The same, where abbreviations have the values and letters the ranges that they have here.
    pub(super) fn beside(&self, exact: Evaluator<'m, Symbolic>) -> Self {
        self.elsewhere(
            exact,
            Arc::clone(&self.inserted),
            Arc::clone(&self.supposed),
        )
    }

    /// A checker in the same world that spends what `options` say.
    pub(crate) fn spending(&self, options: Options) -> Self {
        Checker {
            options,
            ..self.beside(self.exact.anew())
        }
    }

    /// A checker in the world with a display in place of an equation's.
    pub(crate) fn corrected(&self, equation: usize, display: Display) -> Self {
        let exact = self.exact.corrected(equation, display);
        self.anew_if(exact, self.gives_values(equation))
    }

    /// The same, where what has been computed is known still but for these nodes, which are all whose
    /// values depend on the equation.
    pub(crate) fn changed(
        &self,
        equation: usize,
        display: Display,
        stale: &BTreeSet<Node>,
    ) -> Self {
        let exact = self.exact.changed(equation, display, stale);
        let abbreviation = |letter: &Letter| {
            matches!(letter, Letter::Abbreviation { definition }
                if stale.contains(&Node::Definition(*definition)))
        };
        self.anew_if(exact, self.model.letters.iter().any(abbreviation))
    }

    fn anew_if(&self, exact: Evaluator<'m, Symbolic>, changed: bool) -> Self {
        let mut other = self.beside(exact);
        if changed {
            other.insert_abbreviations();
        }
        other
    }

    /// An evaluator in this world with nothing supposed and all definitions inserted.
    pub(super) fn unsupposed(&self) -> Evaluator<'m, Symbolic> {
        let world = evaluate::symbolic(self.model).in_instance(self.instance);
        let world = world.corrected_as(self.exact.world()).inserting();
        world.evaluator(self.model.field())
    }

    /// Goes on in the world of another checker.
    pub(super) fn adopt(&mut self, other: Checker<'m>) {
        self.exact = other.exact;
        self.inserted = other.inserted;
    }

    /// Goes on where an equation reads so.
    pub(super) fn correct(&mut self, equation: usize, display: Display) {
        let corrected = self.corrected(equation, display);
        self.adopt(corrected);
    }

    /// Goes on where a node has no value, for this reason; the conditions that were met stay.
    pub(super) fn has_no_value(&mut self, node: Node, kind: FailureKind) {
        let world = self.exact.world().clone().without(node, kind);
        let conditions = std::mem::take(&mut self.exact.conditions);
        self.exact = self.exact.in_world(world);
        self.exact.conditions = conditions;
    }

    /// Whether an equation gives names their values.
    fn gives_values(&self, equation: usize) -> bool {
        let mut definitions = self.model.definitions.iter();
        definitions.any(|d| d.equation == equation)
            || self.model.equations[equation].role == Role::Solve
    }

    /// Computes the values of all abbreviations in the declared symbols.
    pub(super) fn insert_abbreviations(&mut self) {
        let model = self.model;
        let abbreviation = |node: &Node| matches!(node, Node::Definition(d) if model.definitions[*d].letter.is_some());
        let world = self.exact.world().clone();
        let mut world = world.with_values(|node| !abbreviation(node));
        let mut values = Insertions::new();
        let mut kept = 0;
        let term = self.exact.field.bytes_of_a_term();
        let bytes =
            |f: &RationalFunction| term.saturating_mul(f.numerator().len() + f.denominator().len());
        let mut inserting = world.clone().inserting();
        let mut expanding = self.exact.in_world(inserting.clone());
        for (letter, kind) in model.letters.iter().enumerate() {
            let Letter::Abbreviation { definition } = kind else {
                continue;
            };
            let node = Node::Definition(*definition);
            let span = model.equations[model.definitions[*definition].equation].span;
            let value = || expanding.value_of((node, Vec::new(), 0), span);
            let found = allowance::within(self.allowance(), value);
            let found = found.unwrap_or_else(|exhausted| {
                let what = bounded::words(exhausted).into();
                let kind = FailureKind::Exhausted { what };
                // What rests on it does not try it again.
                inserting = inserting.clone().without(node, kind.clone());
                expanding = self.exact.in_world(inserting.clone());
                Err(Failure::new(kind, span))
            });
            match found {
                // All of them are kept as long as the checker is.
                Ok(Value::Scalar(value)) if kept + bytes(&value) > bounded::BYTES => {
                    let what = bounded::words(Exhausted::Memory).into();
                    world = world.without(node, FailureKind::Exhausted { what });
                }
                Ok(Value::Scalar(value)) => {
                    kept += bytes(&value);
                    values.insert(letter, value);
                }
                Ok(_) => {}
                Err(failure) => {
                    self.note(&failure);
                    // A letter for what has no value would pass for any number.
                    world = world.without(node, failure.kind);
                }
            }
        }
        if world.without_value() != self.exact.world().without_value() {
            self.exact = self.exact.in_world(world);
        }
        self.inserted = Arc::new(values);
    }
}
