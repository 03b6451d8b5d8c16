//! What values are computed from, as a value.
//!
//! A [`World`] is a model in one of its instances, with the values of its letters, the displays that stand in
//! place of printed ones, the nodes that are known to have no value, and how names are read. Nothing changes a
//! world: another one is made of it, and whatever is large is shared. An [`Evaluator`](super::Evaluator) lives in one
//! world for as long as it lives, so that nothing it has computed can belong to another.

use super::{Evaluator, FailureKind};
use crate::domain::Domain;
use crate::expr::Display;
use crate::model::{Model, Node};
use std::collections::BTreeMap;
use std::sync::Arc;

/// What values are computed from.
#[derive(Clone, Debug)]
pub struct World<'m, E> {
    model: &'m Model,
    /// Which of the model's instances sizes are taken from.
    instance: usize,
    /// The value of each letter of the model's ring.
    letters: Arc<[E]>,
    /// The displays that stand in place of printed ones, by equation.
    corrections: Arc<BTreeMap<usize, Arc<Display>>>,
    /// The nodes that have no value, and why.
    without_value: Arc<BTreeMap<Node, FailureKind>>,
    /// Whether abbreviations have the values of their definitions; else they are letters.
    inserting: bool,
    /// Whether a family's members outside of its range are zero; else they do not exist.
    lenient: bool,
}

impl<'m, E> World<'m, E> {
    /// The document as printed, in the first instance of its sizes, with a value for each letter of the
    /// model's ring. Abbreviations are letters.
    ///
    /// # Panics
    /// When there is not one value for each letter: a programming error.
    pub fn new(model: &'m Model, letters: Vec<E>) -> Self {
        assert_eq!(letters.len(), model.letters.len(), "one value per letter");
        World {
            model,
            instance: 0,
            letters: letters.into(),
            corrections: Arc::default(),
            without_value: Arc::default(),
            inserting: false,
            lenient: false,
        }
    }

    /// The same with the sizes of another of the model's instances.
    #[must_use]
    pub fn in_instance(mut self, instance: usize) -> Self {
        self.instance = instance;
        self
    }

    /// The same with the definitions of abbreviations inserted.
    #[must_use]
    pub fn inserting(mut self) -> Self {
        self.inserting = true;
        self
    }

    /// The same with members outside of a family's range read as zero.
    #[must_use]
    pub fn leniently(mut self) -> Self {
        self.lenient = true;
        self
    }

    /// The same with a display in place of an equation's.
    #[must_use]
    pub fn corrected(mut self, equation: usize, display: Display) -> Self {
        Arc::make_mut(&mut self.corrections).insert(equation, Arc::new(display));
        self
    }

    /// The same where some equations stand as they are printed.
    #[must_use]
    pub fn as_printed(mut self, equations: &[usize]) -> Self {
        Arc::make_mut(&mut self.corrections).retain(|equation, _| !equations.contains(equation));
        self
    }

    /// The same with the displays of another world in place of the printed ones.
    #[must_use]
    pub fn corrected_as<F>(mut self, other: &World<'m, F>) -> Self {
        self.corrections = Arc::clone(&other.corrections);
        self
    }

    /// The same where a node has no value, for this reason.
    #[must_use]
    pub fn without(mut self, node: Node, kind: FailureKind) -> Self {
        Arc::make_mut(&mut self.without_value)
            .entry(node)
            .or_insert(kind);
        self
    }

    /// The same where of the nodes without a value only these have none.
    #[must_use]
    pub fn with_values(mut self, but: impl Fn(&Node) -> bool) -> Self {
        Arc::make_mut(&mut self.without_value).retain(|node, _| but(node));
        self
    }

    /// The same with other values of the letters, one for each, of this field or of another.
    ///
    /// # Panics
    /// When there is not one value for each letter: a programming error.
    #[must_use]
    pub fn with_letters<F>(&self, letters: Vec<F>) -> World<'m, F> {
        assert_eq!(letters.len(), self.letters.len(), "one value per letter");
        World {
            model: self.model,
            instance: self.instance,
            letters: letters.into(),
            corrections: Arc::clone(&self.corrections),
            without_value: Arc::clone(&self.without_value),
            inserting: self.inserting,
            lenient: self.lenient,
        }
    }

    /// The model.
    pub fn model(&self) -> &'m Model {
        self.model
    }

    /// Which of the model's instances sizes are taken from.
    pub fn instance(&self) -> usize {
        self.instance
    }

    /// The value of each letter of the model's ring.
    pub fn letters(&self) -> &[E] {
        &self.letters
    }

    /// The display that an equation is evaluated from.
    pub fn display(&self, equation: usize) -> &Display {
        self.correction(equation)
            .unwrap_or(&self.model.equations[equation].display)
    }

    /// The display that stands in place of an equation's printed one, if one does.
    pub fn correction(&self, equation: usize) -> Option<&Display> {
        self.corrections.get(&equation).map(|display| &**display)
    }

    /// The displays that stand in place of printed ones, by equation.
    pub fn corrections(&self) -> impl Iterator<Item = (usize, &Display)> {
        self.corrections.iter().map(|(e, display)| (*e, &**display))
    }

    /// Why a node has no value, where it is known to have none.
    pub(super) fn no_value(&self, node: Node) -> Option<&FailureKind> {
        self.without_value.get(&node)
    }

    /// The nodes that are known to have no value.
    pub(crate) fn without_value(&self) -> &BTreeMap<Node, FailureKind> {
        &self.without_value
    }

    /// Whether abbreviations have the values of their definitions.
    pub(super) fn is_inserting(&self) -> bool {
        self.inserting
    }

    /// Whether a family's members outside of its range are zero.
    pub(super) fn is_lenient(&self) -> bool {
        self.lenient
    }

    /// An evaluator that has computed nothing yet.
    pub fn evaluator<D: Domain<Element = E>>(self, field: D) -> Evaluator<'m, D> {
        Evaluator::new(field, self)
    }
}
