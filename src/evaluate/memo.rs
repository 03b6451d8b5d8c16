//! What has been computed in one world: values of names, with the conditions under which they exist.
//!
//! Invariant: a value is kept only where it depends on nothing but the world. What is computed while a letter
//! stands for something else has a memo of its own, and what is computed from trial values of unknowns or in one of
//! several cases is not kept.

use super::{Condition, Key, Stationary, Value};
use crate::model::Node;
use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;

/// The most bytes of values that are kept: then they are forgotten, and computed again where they are needed.
const MOST_KEPT: usize = 32 << 20;

/// A value with the conditions under which it exists.
#[derive(Debug)]
pub(super) struct Known<E> {
    pub value: Value<E>,
    pub conditions: Vec<Condition<E>>,
    /// About how many bytes it has.
    pub bytes: usize,
}

/// What has been computed.
#[derive(Clone, Debug)]
pub(super) struct Memo<E> {
    known: BTreeMap<Key, Arc<Known<E>>>,
    /// About how many bytes the known values have.
    kept: usize,
    /// What the systems that are equations of a stationary state are about.
    stationary: BTreeMap<usize, Stationary<E>>,
    /// The symbols that each node's value depends on.
    behind: BTreeMap<Node, BTreeSet<usize>>,
}

impl<E> Default for Memo<E> {
    fn default() -> Self {
        Memo {
            known: BTreeMap::new(),
            kept: 0,
            stationary: BTreeMap::new(),
            behind: BTreeMap::new(),
        }
    }
}

impl<E> Memo<E> {
    /// What is known of a value.
    pub fn known(&self, key: &Key) -> Option<&Arc<Known<E>>> {
        self.known.get(key)
    }

    /// Keeps a value.
    pub fn keep(&mut self, key: Key, known: Known<E>) {
        if self.kept.saturating_add(known.bytes) > MOST_KEPT {
            self.known.clear();
            self.kept = 0;
        }
        self.kept = self.kept.saturating_add(known.bytes);
        self.known.insert(key, Arc::new(known));
    }

    /// What a system is about, where that was found out while it was solved.
    pub fn stationary(&self, system: usize) -> Option<&Stationary<E>> {
        self.stationary.get(&system)
    }

    /// Keeps what a system is about.
    pub fn is_stationary(&mut self, system: usize, about: Stationary<E>) {
        self.stationary.insert(system, about);
    }

    /// The symbols that a node's value depends on, looked up once.
    pub fn symbols_behind(
        &mut self,
        node: Node,
        find: impl FnOnce() -> BTreeSet<usize>,
    ) -> &BTreeSet<usize> {
        self.behind.entry(node).or_insert_with(find)
    }

    /// What is known still where these nodes have other values.
    pub fn without(&self, stale: &BTreeSet<Node>) -> Self
    where
        E: Clone,
    {
        let known: BTreeMap<Key, Arc<Known<E>>> = self
            .known
            .iter()
            .filter(|(key, _)| !stale.contains(&common(key.0)))
            .map(|(key, known)| (key.clone(), Arc::clone(known)))
            .collect();
        Memo {
            kept: known.values().map(|known| known.bytes).sum(),
            known,
            stationary: self.stationary.clone(),
            behind: BTreeMap::new(),
        }
    }
}

/// The node as dependences know it: all unknowns of a system are one.
fn common(node: Node) -> Node {
    match node {
        Node::Unknown { system, .. } => Node::Unknown {
            system,
            position: 0,
        },
        Node::Symbol(_) | Node::Matrix(_) | Node::Definition(_) | Node::Notation(_) => node,
    }
}
