//! The other readings of the same places, and where each fails.

use crate::check::Checker;
use crate::check::edit::Replacement;
use crate::check::sides::sides_of;
use crate::domain::{Domain, Rationals};
use crate::evaluate::{FailureKind, Value};
use crate::expr::Display;
use crate::model::links::Link;
use crate::span::Span;
use crate::verdict::{Edit, PointValue, Rejected, Witness};
use num_rational::BigRational;
use ratpoly::RationalFunction;
use std::rc::Rc;

/// How many readings of the same places are reported as rejected.
const REPORTED: usize = 128;

impl Checker<'_> {
    /// The readings that change some of the places of a correction in the same way as it does: as
    /// printed, one place, several.
    pub(super) fn rejected(
        &self,
        display: &Display,
        link: &Link,
        steps: &[Replacement],
        singles: &[Replacement],
    ) -> Vec<Rejected> {
        let mut readings: Vec<Vec<&Replacement>> = vec![Vec::new()];
        for (k, step) in steps.iter().enumerate() {
            let apart = steps[..k]
                .iter()
                .all(|other| !other.address.is_nested_with(&step.address));
            if !apart {
                break;
            }
            let same = |r: &&Replacement| r.address == step.address && r.class == step.class;
            let here: Vec<&Replacement> = singles.iter().filter(same).collect();
            let longer: Vec<Vec<&Replacement>> = here
                .iter()
                .flat_map(|r| {
                    readings.iter().map(move |reading| {
                        let mut longer = reading.clone();
                        longer.push(r);
                        longer
                    })
                })
                .collect();
            readings.extend(longer);
            readings.truncate(4 * REPORTED);
        }
        readings.sort_by_key(Vec::len);
        let corrected = super::edited(display, steps);
        let readings = readings
            .into_iter()
            .map(|reading| {
                let steps: Vec<Replacement> = reading.into_iter().cloned().collect();
                let edits = steps.iter().filter_map(|r| r.describe(display)).collect();
                (edits, super::edited(display, &steps))
            })
            .filter(|(_, display)| *display != corrected)
            .take(REPORTED)
            .collect();
        self.explain_rejected(link, readings)
    }

    /// Where each rejected reading fails: what it names that does not exist, and both sides at the
    /// reference point.
    fn explain_rejected(&self, link: &Link, rejected: Vec<(Vec<Edit>, Display)>) -> Vec<Rejected> {
        let span = Span::default();
        let point = self.reference_point();
        let shown: Vec<(usize, PointValue)> = (0..point.len())
            .filter(|l| self.has_reference(*l))
            .map(|l| (l, PointValue::Exact(point[l].clone())))
            .collect();
        let table = self.model.functions.clone();
        let real: Vec<Option<BigRational>> = (0..point.len())
            .map(|l| (!self.is_function(l)).then(|| point[l].clone()))
            .collect();
        let exact = self.exact_anew();
        let evaluator = || {
            let (table, real) = (table.clone(), real.clone());
            let image = move |value: &RationalFunction, point: &[BigRational]| {
                match &table {
                    Some(table) => table.rational_value(value, &real),
                    None => value.evaluate(point).ok(),
                }
                .ok_or(FailureKind::DivisionByZero)
            };
            self.evaluator_at(Rc::clone(&exact), Rationals, point.clone(), image)
        };
        let (mut evaluator, mut lenient) = (evaluator(), evaluator().leniently());
        rejected
            .into_iter()
            .filter_map(|(edits, display)| {
                let mut missing = None;
                let mut misfit = None;
                if let Err(failure) = sides_of(&mut evaluator, &display, link, span) {
                    misfit = failure.misfit();
                    if let FailureKind::Outside { name } = failure.kind {
                        missing = Some(name);
                    }
                }
                let witness = sides_of(&mut lenient, &display, link, span)
                    .ok()
                    .and_then(|pairs| {
                        pairs.into_iter().find_map(|(indices, left, right)| {
                            let (place, left, right) = first_difference(&left, &right)?;
                            Some(Witness {
                                point: shown.clone(),
                                left: PointValue::Exact(left),
                                right: PointValue::Exact(right),
                                place,
                                indices,
                            })
                        })
                    });
                // What agrees here may be another correction.
                let fails = missing.is_some() || misfit.is_some() || witness.is_some();
                fails.then_some(Rejected {
                    edits,
                    missing,
                    misfit,
                    witness,
                })
            })
            .collect()
    }
}

/// An entry in which two values differ: its place, and both numbers.
type Difference = (Option<(usize, usize)>, BigRational, BigRational);

/// The first entry in which two values differ.
fn first_difference(left: &Value<BigRational>, right: &Value<BigRational>) -> Option<Difference> {
    let (rows, columns) = left.shape().or(right.shape())?;
    let at = |value: &Value<BigRational>, i: usize, j: usize| match value {
        Value::Matrix(m) if m.shape() == (rows, columns) => Some(m[(i, j)].clone()),
        Value::Matrix(_) => None,
        Value::Scalar(s) => Some(s.clone()),
        Value::Zero => Some(Rationals.integer(0)),
    };
    (0..rows * columns).find_map(|k| {
        let (i, j) = (k / columns, k % columns);
        let (l, r) = (at(left, i, j)?, at(right, i, j)?);
        let place = (rows * columns > 1).then_some((i + 1, j + 1));
        (l != r).then_some((place, l, r))
    })
}
