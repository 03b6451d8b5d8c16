//! One equation changed for a while: what does not depend on it keeps its value.
//!
//! Invariant: after [`Evaluator::put_back`] the evaluator is as it was before
//! [`Evaluator::put_in_place`], down to what it has computed.

use super::{Evaluator, Key, Known, Stationary};
use crate::domain::Domain;
use crate::expr::Display;
use crate::model::Node;
use std::collections::{BTreeMap, BTreeSet};

/// What a changed display has displaced.
#[derive(Debug)]
pub(crate) struct Displaced<E> {
    equation: usize,
    display: Option<Display>,
    known: BTreeMap<Key, Known<E>>,
    kept: BTreeSet<Key>,
    stationary: BTreeMap<usize, Stationary<E>>,
}

/// The node as dependences know it: all unknowns of a system are one.
fn common(node: Node) -> Node {
    match node {
        Node::Unknown { system, .. } => Node::Unknown {
            system,
            position: 0,
        },
        node => node,
    }
}

impl<D: Domain> Evaluator<'_, D> {
    /// Puts a changed display in place of an equation's; the values of the nodes in `stale`, which
    /// depend on it, are set aside.
    pub(crate) fn put_in_place(
        &mut self,
        equation: usize,
        display: Display,
        stale: &BTreeSet<Node>,
    ) -> Displaced<D::Element> {
        let keys: Vec<Key> = self
            .known
            .keys()
            .filter(|key| stale.contains(&common(key.0)))
            .cloned()
            .collect();
        let known = keys
            .into_iter()
            .filter_map(|key| self.known.remove_entry(&key))
            .collect();
        let stationary = if stale.is_empty() {
            BTreeMap::new()
        } else {
            self.stationary.clone()
        };
        self.behind.clear();
        Displaced {
            equation,
            display: self.corrected.insert(equation, display),
            known,
            kept: self.known.keys().cloned().collect(),
            stationary,
        }
    }

    /// Undoes [`Evaluator::put_in_place`], the last one first. What was computed meanwhile is
    /// forgotten, so that no result depends on what was tried before.
    pub(crate) fn put_back(&mut self, displaced: Displaced<D::Element>) {
        match displaced.display {
            Some(display) => self.corrected.insert(displaced.equation, display),
            None => self.corrected.remove(&displaced.equation),
        };
        self.known.retain(|key, _| displaced.kept.contains(key));
        self.known.extend(displaced.known);
        if !displaced.stationary.is_empty() {
            self.stationary = displaced.stationary;
        }
        self.behind.clear();
        // A failure may have left these behind.
        self.open.clear();
        self.trial.clear();
        self.bound.clear();
        self.replaced.clear();
        self.conditions.clear();
        self.begin_case(0);
        self.between.clear();
        self.open_integrals.clear();
        self.integrals = 0;
        (self.lenient, self.wanted_rows, self.at) = (false, None, None);
    }

    /// A second evaluator that has computed what this one has.
    pub(crate) fn twin(&self) -> Self
    where
        D: Clone,
    {
        let mut twin = self.anew();
        twin.known = self.known.clone();
        twin.stationary = self.stationary.clone();
        twin
    }
}
