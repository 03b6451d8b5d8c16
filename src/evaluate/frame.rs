//! Where the evaluation stands within one expression: what its indices, letters and unknowns are for now.
//!
//! Invariant: between two expressions the frame is empty. Whoever enters something takes it out again, also
//! where the evaluation fails, by running what it is entered for as a body.

use super::{Evaluator, Failure, FailureKind, Key, Value, memo};
use crate::domain::Domain;
use crate::expr::Name;
use crate::functions::Supposed;
use crate::functions::integral::End;
use crate::model::time::Clock;
use crate::model::{Letter, Node};
use crate::span::Span;
use num_rational::BigRational;
use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;

/// The most terms of sums inside of sums together.
const MOST_TERMS: u64 = 200_000;

/// Letters that stand for something else, and the values computed so.
#[derive(Debug)]
pub(super) struct Replaced<E> {
    /// The symbols, with those that were replaced before.
    pub symbols: BTreeSet<usize>,
    /// What stands in place of their letters, without what was replaced before.
    images: Vec<(usize, E)>,
    /// What was computed with them so.
    pub known: BTreeMap<Key, Arc<memo::Known<E>>>,
}

/// Where the evaluation stands.
#[derive(Debug)]
pub(super) struct Frame<E> {
    /// The number at which processes are taken, if at one.
    pub at: Option<BigRational>,
    /// The values that are being computed.
    pub open: BTreeSet<Key>,
    /// The values that unknowns are tried with.
    pub trial: BTreeMap<(usize, usize), Value<E>>,
    /// The running indices.
    pub bound: Vec<(String, i64)>,
    /// How many terms the sums have together that are being added up.
    running: u64,
    /// How many rows the next matrix should have where zeros of any shape leave that open.
    pub wanted_rows: Option<usize>,
    /// Letters that stand for something else while a function's body is evaluated.
    pub replaced: Vec<Replaced<E>>,
    /// How many letters of integrals and derivatives are in use.
    pub integrals: usize,
    /// Between what the variables of the open integrals lie.
    pub between: Vec<Supposed<E>>,
    /// These variables with the ends of their integrals.
    pub open_integrals: Vec<(E, End<E>, End<E>)>,
}

impl<E> Default for Frame<E> {
    fn default() -> Self {
        Frame {
            at: None,
            open: BTreeSet::new(),
            trial: BTreeMap::new(),
            bound: Vec::new(),
            running: 1,
            wanted_rows: None,
            replaced: Vec::new(),
            integrals: 0,
            between: Vec::new(),
            open_integrals: Vec::new(),
        }
    }
}

impl<D: Domain> Evaluator<'_, D> {
    /// The value of a letter, or what stands in its place.
    pub(super) fn letter(&self, letter: usize) -> &D::Element {
        let images = self.frame.replaced.iter().rev().flat_map(|r| &r.images);
        let mut images = images.filter(|(replaced, _)| *replaced == letter);
        match images.next() {
            Some((_, image)) => image,
            None => &self.world.letters()[letter],
        }
    }

    /// Runs `body` with these indices bound.
    pub fn with_indices<T>(
        &mut self,
        indices: &[(String, i64)],
        body: impl FnOnce(&mut Self) -> T,
    ) -> T {
        let before = self.frame.bound.len();
        self.frame.bound.extend(indices.iter().cloned());
        let result = body(self);
        self.frame.bound.truncate(before);
        result
    }

    /// Runs `body` with an index bound to a value.
    pub fn with_bound<T>(
        &mut self,
        index: &str,
        value: i64,
        body: impl FnOnce(&mut Self) -> T,
    ) -> T {
        self.with_indices(&[(index.to_string(), value)], body)
    }

    /// The value of a running index, or of the letter of a size.
    pub(super) fn bound_value(&self, name: &str) -> Option<i64> {
        let sizes = &self.model.instances[self.world.instance()];
        let size = || sizes.get(name).and_then(|n| i64::try_from(*n).ok());
        let bound = self.frame.bound.iter().rev().find(|(n, _)| n == name);
        bound.map(|(_, v)| *v).or_else(size)
    }

    /// Whether the name is an index or the letter of a size.
    pub(super) fn is_bound(&self, name: &Name) -> bool {
        self.bound_value(&crate::latex::canonical(name)).is_some()
    }

    /// Runs `body` as one of so many terms of a sum with a running index.
    ///
    /// # Errors
    /// Where the sums around it have too many terms together, and those of `body`.
    pub(super) fn with_terms<T>(
        &mut self,
        terms: u64,
        span: Span,
        body: impl FnOnce(&mut Self) -> Result<T, Failure>,
    ) -> Result<T, Failure> {
        let together = self.frame.running.saturating_mul(terms.max(1));
        if together > MOST_TERMS {
            let what = "terms of a sum".into();
            return Err(Failure::new(FailureKind::Budget { what }, span));
        }
        let outer = std::mem::replace(&mut self.frame.running, together);
        let result = body(self);
        self.frame.running = outer;
        result
    }

    /// Runs `body` while symbols stand for something else.
    pub fn with_symbols<T>(
        &mut self,
        images: Vec<(usize, D::Element)>,
        body: impl FnOnce(&mut Self) -> T,
    ) -> T {
        let mut symbols = BTreeSet::new();
        let mut replaced = Vec::new();
        for (symbol, image) in images {
            let Some(letter) = self.model.letter_of_symbol(symbol, 0) else {
                continue;
            };
            if *self.letter(letter) != image {
                replaced.push((letter, image));
                symbols.insert(symbol);
            }
        }
        if symbols.is_empty() {
            return body(self);
        }
        if let Some(outer) = self.frame.replaced.last() {
            symbols.extend(&outer.symbols);
        }
        self.frame.replaced.push(Replaced {
            symbols,
            images: replaced,
            known: BTreeMap::new(),
        });
        let open = std::mem::take(&mut self.frame.open);
        let result = body(self);
        self.frame.open = open;
        self.frame.replaced.pop();
        result
    }

    /// Whether what stands in place of another symbol's letter depends on this letter.
    pub(super) fn is_in_an_argument(&self, symbol: usize, letter: usize) -> bool {
        let own = self.model.letter_of_symbol(symbol, 0);
        let images = self.frame.replaced.iter().flat_map(|r| &r.images);
        let mut others = images.filter(|(replaced, _)| Some(*replaced) != own);
        others.any(|(_, image)| self.field.letters_behind(image).contains(&letter))
    }

    /// Whether what stands in place of a letter changes with the time.
    pub(super) fn has_moving_arguments(&self) -> bool {
        let images = self.frame.replaced.iter().flat_map(|r| &r.images);
        let mut behind = images.flat_map(|(_, image)| self.field.letters_behind(image));
        behind.any(|letter| match self.model.letters[letter] {
            Letter::Symbol { symbol, .. } => {
                self.model.symbols[symbol].function_of.is_some()
                    || self.model.clock(symbol) != Clock::Still
            }
            // What it stands for is differentiated with it.
            Letter::Abbreviation { .. } => true,
            Letter::Function { .. } => false,
        })
    }

    /// Whether a node's value depends on a symbol that stands for something else now.
    pub(super) fn replaced_behind(&mut self, node: Node) -> bool {
        let Some(replaced) = self.frame.replaced.last() else {
            return false;
        };
        let replaced = replaced.symbols.clone();
        !self.symbols_behind(node).is_disjoint(&replaced)
    }

    /// The symbols that a node's value depends on.
    pub(super) fn symbols_behind(&mut self, node: Node) -> &BTreeSet<usize> {
        let (model, world) = (self.model, &self.world);
        let find = || model.symbols_behind(node, &|equation| world.display(equation));
        self.memo.symbols_behind(node, find)
    }
}
