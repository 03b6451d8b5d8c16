//! Evaluators at a point over another field, and the slow filter for what the store cannot judge.

use super::images::Images;
use super::residue::same;
use super::work;
use crate::check::Checker;
use crate::check::sides::sides_of;
use crate::domain::{Domain, PrimeField, Symbolic};
use crate::evaluate::{Evaluator, Failure, FailureKind, Key, Value, World};
use crate::expr::Display;
use crate::functions::FunctionTable;
use crate::model::links::Link;
use crate::span::Span;
use ratpoly::{RationalFunction, allowance};
use std::cell::RefCell;
use std::rc::Rc;

/// What a candidate is modulo the prime.
pub(super) enum Passing {
    /// The sides agree.
    Agrees,
    /// They differ, or have no value.
    Differs,
    /// Functions have no value there: only a proof can tell.
    Unknown,
}

/// What a candidate display is, for all values of the running indices. `functions`: whether the
/// document has letters for functions, which may have no values modulo the prime.
pub(super) fn passes(
    evaluator: &mut Evaluator<'_, PrimeField>,
    functions: bool,
    display: &Display,
    link: &Link,
) -> Passing {
    match sides_of(evaluator, display, link, Span::default()) {
        Ok(pairs) if pairs.iter().all(|(_, l, r)| same(l, r)) => Passing::Agrees,
        Err(Failure {
            kind: FailureKind::Unsupported { .. },
            ..
        }) if functions => Passing::Unknown,
        _ => Passing::Differs,
    }
}

/// Whether the sides agree and there are any.
pub(super) fn holds_modulo(
    evaluator: &mut Evaluator<'_, PrimeField>,
    display: &Display,
    link: &Link,
) -> bool {
    let sides = sides_of(evaluator, display, link, Span::default());
    sides.is_ok_and(|pairs| !pairs.is_empty() && pairs.iter().all(|(_, l, r)| same(l, r)))
}

/// The exact values of names, computed once for all evaluators at one point.
pub(super) type Exact<'m> = Rc<RefCell<Evaluator<'m, Symbolic>>>;

/// Both sides exactly, with letters for functions that nothing else uses.
pub(super) struct ExactFilter<'m> {
    checked: Evaluator<'m, Symbolic>,
    fork: Evaluator<'m, Symbolic>,
    table: Option<FunctionTable>,
    inserted: Vec<(usize, RationalFunction)>,
}

impl<'m> ExactFilter<'m> {
    pub fn new(checker: &Checker<'m>) -> Self {
        let inserted = checker.inserted.iter();
        ExactFilter {
            checked: checker.exact.anew(),
            fork: checker.exact.anew(),
            table: None,
            inserted: inserted.map(|(l, v)| (*l, v.clone())).collect(),
        }
    }

    /// Whether the sides agree, with the definitions inserted, and what it cost to tell.
    pub fn agree(&mut self, display: &Display, link: &Link) -> (bool, u64) {
        let sides = [link.left, link.right].into_iter();
        let mut steps = sides
            .filter_map(|place| place.find(display))
            .map(work::evaluated)
            .sum();
        let before = allowance::steps_left();
        let agree = self.agreeing(display, link, &mut steps);
        steps += work::engine(before.saturating_sub(allowance::steps_left()));
        (agree.unwrap_or(false), steps)
    }

    fn agreeing(&mut self, display: &Display, link: &Link, steps: &mut u64) -> Option<bool> {
        let table = self.checked.model().functions.as_ref()?;
        let enough = |fork: &FunctionTable| 2 * fork.remaining() > table.remaining();
        if !self.table.as_ref().is_some_and(enough) {
            let fork = table.forked();
            self.fork = self.checked.anew();
            self.fork.field = Symbolic::with_functions(fork.clone());
            self.table = Some(fork);
        }
        let table = self.table.as_ref()?;
        let pairs = sides_of(&mut self.fork, display, link, Span::default()).ok()?;
        for (_, left, right) in &pairs {
            *steps += work::exact(left.entries().into_iter().chain(right.entries()));
        }
        let mut image = |value: &RationalFunction| {
            let image = table.substitute(value, &self.inserted).ok();
            *steps += work::exact(&image);
            image
        };
        let mut equal = |left: &RationalFunction, right: &RationalFunction| {
            left == right || {
                let left = image(left);
                left.is_some() && left == image(right)
            }
        };
        Some(pairs.iter().all(|(_, left, right)| {
            let zero = |v: &Value<RationalFunction>| v.entries().iter().all(|e| e.is_zero());
            let shapes = left.shape() == right.shape();
            let entries = left.entries().into_iter().zip(right.entries());
            zero(left) && zero(right) || shapes && entries.into_iter().all(|(l, r)| equal(l, r))
        }))
    }
}

impl<'m> Checker<'m> {
    /// An evaluator over another field at a point, whose names have the images of their exact
    /// values.
    pub(super) fn evaluator_at<D>(
        &self,
        exact: Exact<'m>,
        field: D,
        point: Vec<D::Element>,
        image: impl Fn(&RationalFunction, &[D::Element]) -> Result<D::Element, FailureKind> + 'm,
    ) -> Evaluator<'m, D>
    where
        D: Domain + 'm,
    {
        let at = point.clone();
        // A letter has the value that the hypotheses printed around the equation give it.
        let letters = self.exact.world().letters().iter().zip(&point);
        let point = letters
            .map(|(letter, free)| image(letter, &at).unwrap_or_else(|_| free.clone()))
            .collect();
        let provider = move |key: &Key| -> Option<Result<Value<D::Element>, Failure>> {
            let span = crate::span::Span::default();
            let value = match exact.borrow_mut().value_of(key.clone(), span) {
                Ok(value) => value,
                Err(failure) => return Some(Err(failure)),
            };
            Some(value.try_map(|e| image(e, &at).map_err(|kind| Failure::new(kind, span))))
        };
        let world = World::new(self.model, point).in_instance(self.instance);
        let world = world.corrected_as(self.exact.world());
        world.evaluator(field).with_provider(Box::new(provider))
    }

    /// An exact evaluator of its own, with the corrections so far.
    pub(super) fn exact_anew(&self) -> Exact<'m> {
        Rc::new(RefCell::new(self.exact.anew()))
    }

    /// The same with its own reserve of letters for functions, and the images of all letters at a
    /// random point, of which there are many; names have their exact values there.
    pub(super) fn modulo_prime(
        &self,
        point: u64,
    ) -> (Evaluator<'m, PrimeField>, Exact<'m>, Rc<Images>) {
        let model = self.model;
        let table = model.functions.as_ref().map(FunctionTable::forked);
        let mut exact = self.exact.anew();
        if let Some(table) = &table {
            exact.field = Symbolic::with_functions(table.clone());
        }
        let exact = Rc::new(RefCell::new(exact));
        let letters = model.letters.len();
        let images = Rc::new(Images::new(letters, &self.inserted, table, point));
        let at = Rc::clone(&images);
        let image = move |value: &RationalFunction, _: &[u64]| at.image(value);
        let point = images.point().to_vec();
        let evaluator = self.evaluator_at(Rc::clone(&exact), PrimeField, point, image);
        (evaluator, exact, images)
    }
}
