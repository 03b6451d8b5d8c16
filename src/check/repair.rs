//! The search for the smallest correction of a refuted equation.
//!
//! Candidates are combinations of the single edits of [`super::edit`], fewest edits first. Each is
//! evaluated modulo a 61-bit prime at a random point of the declared symbols; a candidate that is
//! true as a formula passes, a false one passes with negligible probability, and what passes is
//! then proved over the rational functions like any other claim.

use super::edit::{self, Address, Replacement};
use super::identity::Decision;
use super::{Checker, index_tuples};
use crate::domain::{PRIME, PrimeField};
use crate::evaluate::{Evaluator, Failure, FailureKind, Key, Value};
use crate::expr::Display;
use crate::latex;
use crate::model::links::Link;
use crate::verdict::{Certificate, Correction, Edit, EditClass, Rejected};
use ratpoly::RationalFunction;
use std::cell::RefCell;
use std::rc::Rc;

/// How many readings of the same places are reported as rejected.
const REPORTED: usize = 128;

/// What a candidate is modulo the prime.
enum Passing {
    /// The sides agree.
    Agrees,
    /// They differ, or have no value.
    Differs,
    /// It names something that does not exist.
    Missing(String),
}

impl<'m> Checker<'m> {
    /// The cheapest correction of a link with its proof, if one is found among `limit` candidates.
    pub(crate) fn search(
        &mut self,
        equation: usize,
        link: &Link,
        limit: usize,
    ) -> Option<(Correction, Certificate)> {
        let display = self.exact.display(equation).clone();
        let places = [link.left, link.right];
        let singles: Vec<Vec<Replacement>> = [
            edit::signs,
            edit::indices,
            edit::exponents,
            edit::literals,
            edit::letters,
            edit::dots,
        ]
        .iter()
        .map(|class| class(&display, &places))
        .collect();
        let mut trials = Trials {
            display: &display,
            link,
            filter: self.filter(),
            tried: 0,
            limit,
            passing: Vec::new(),
            rejected: Vec::new(),
        };
        // One edit of any class; then several of the same class, as one slip repeated (a lost dot
        // in each row, both indices of a formula).
        for replacement in singles.iter().flatten() {
            trials.consider(vec![replacement]);
        }
        for size in 2..=4 {
            for class in &singles {
                let largest = match class.first().map(|r| r.class) {
                    Some(EditClass::Dot) => 4,
                    Some(EditClass::Index) => 2,
                    _ => 1,
                };
                if trials.passing.is_empty() && size <= largest {
                    for combination in combinations(class, size, limit) {
                        trials.consider(combination);
                    }
                }
            }
        }
        let Trials {
            tried,
            passing,
            rejected,
            ..
        } = trials;
        let describe = |combination: &[&Replacement]| -> Vec<Edit> {
            combination
                .iter()
                .filter_map(|r| r.describe(&display))
                .collect()
        };
        // Of the rejected readings, those that change the same places in the same way matter.
        let touched: Vec<Vec<(&Address, EditClass)>> = passing
            .iter()
            .map(|c| c.iter().map(|r| (&r.address, r.class)).collect())
            .collect();
        let rejected: Vec<(Vec<Edit>, Option<String>)> = rejected
            .iter()
            .filter(|(combination, _)| {
                touched.iter().any(|places| {
                    combination
                        .iter()
                        .all(|r| places.contains(&(&r.address, r.class)))
                })
            })
            .map(|(combination, missing)| (describe(combination), missing.clone()))
            .collect();
        let passing: Vec<(Vec<Edit>, Display)> = passing
            .iter()
            .map(|combination| {
                let mut candidate = display.clone();
                for replacement in combination {
                    replacement.apply(&mut candidate);
                }
                (describe(combination), candidate)
            })
            .collect();
        self.choose(equation, link, passing, rejected, tried)
    }

    /// Proves the candidates that passed; the first proved one is the correction.
    fn choose(
        &mut self,
        equation: usize,
        link: &Link,
        passing: Vec<(Vec<Edit>, Display)>,
        rejected: Vec<(Vec<Edit>, Option<String>)>,
        tried: usize,
    ) -> Option<(Correction, Certificate)> {
        let before = self.exact.display(equation).clone();
        let mut proved: Vec<(
            Vec<Edit>,
            Display,
            Option<crate::verdict::Given>,
            Certificate,
        )> = Vec::new();
        for (edits, display) in passing {
            self.exact.correct(equation, display.clone());
            let Ok(entries) = self.sides(equation, link) else {
                continue;
            };
            // A correction that makes both sides the same text says nothing.
            let sides = [link.left, link.right].map(|p| p.find(&display).map(latex::write_expr));
            if sides[0] == sides[1] {
                continue;
            }
            match self.decide(&entries, equation) {
                Ok(Decision::Holds(by)) => {
                    let proof = self.certificate(entries, &by, None);
                    proved.push((edits, display, None, proof));
                }
                Ok(Decision::HoldsGiven(by, given)) => {
                    let open = given.cofactors.iter().map(|g| g.entry.clone()).collect();
                    let proof = self.certificate(open, &by, Some(&given));
                    proved.push((edits, display, Some(given), proof));
                }
                _ => {}
            }
        }
        self.exact.correct(equation, before);
        // Identities before equations that need a relation.
        proved.sort_by_key(|(_, _, given, _)| given.is_some());
        let mut proved = proved.into_iter();
        let (edits, display, given, proof) = proved.next()?;
        let places: Vec<_> = edits.iter().map(|e| (e.span, e.class)).collect();
        let rejected = rejected
            .into_iter()
            .filter(|(other, _)| other.iter().all(|e| places.contains(&(e.span, e.class))))
            .take(REPORTED)
            .map(|(edits, missing)| Rejected {
                edits,
                missing,
                witness: None,
            })
            .collect();
        Some((
            Correction {
                edits,
                display,
                given,
                tried,
                alternatives: proved.map(|(edits, ..)| edits).collect(),
                rejected,
            },
            proof,
        ))
    }

    /// The filter modulo the prime: names have their exact values there.
    fn filter(&self) -> Filter<'m> {
        let model = self.model;
        let mut state = 0x9E37_79B9_7F4A_7C15_u64;
        let mut random = || {
            // SplitMix64 (Steele, Lea & Flood 2014), seeded the same every time.
            state = state.wrapping_add(0x9E37_79B9_7F4A_7C15);
            let mut z = state;
            z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
            z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
            (z ^ (z >> 31)) % PRIME
        };
        let mut point: Vec<u64> = (0..model.letters.len()).map(|_| random()).collect();
        for (letter, value) in &self.inserted {
            if let Some(image) = residue(value, &point) {
                point[*letter] = image;
            }
        }
        let exact = Rc::new(RefCell::new(super::symbolic(model)));
        for (equation, display) in self.exact.corrections() {
            exact.borrow_mut().correct(*equation, display.clone());
        }
        let at = point.clone();
        let provider = move |key: &Key| -> Option<Result<Value<u64>, Failure>> {
            let span = crate::span::Span::default();
            let value = match exact.borrow_mut().value_of(key.clone(), span) {
                Ok(value) => value,
                Err(failure) => return Some(Err(failure)),
            };
            let image = value.try_map(|e| {
                residue(e, &at).ok_or(Failure::new(FailureKind::DivisionByZero, span))
            });
            Some(image)
        };
        let evaluator = Evaluator::new(model, PrimeField, point).with_provider(Box::new(provider));
        Filter { evaluator }
    }
}

/// The candidates of one link as they are tried.
struct Trials<'r, 'm> {
    display: &'r Display,
    link: &'r Link,
    filter: Filter<'m>,
    tried: usize,
    limit: usize,
    passing: Vec<Vec<&'r Replacement>>,
    rejected: Vec<(Vec<&'r Replacement>, Option<String>)>,
}

impl<'r> Trials<'r, '_> {
    fn consider(&mut self, combination: Vec<&'r Replacement>) {
        if self.tried >= self.limit {
            return;
        }
        self.tried += 1;
        let mut candidate = self.display.clone();
        if !combination.iter().all(|r| r.apply(&mut candidate)) {
            return;
        }
        match self.filter.passes(&candidate, self.link) {
            Passing::Agrees => self.passing.push(combination),
            Passing::Missing(name) => self.rejected.push((combination, Some(name))),
            Passing::Differs => self.rejected.push((combination, None)),
        }
    }
}

struct Filter<'m> {
    evaluator: Evaluator<'m, PrimeField>,
}

impl Filter<'_> {
    fn passes(&mut self, display: &Display, link: &Link) -> Passing {
        let (Some(left), Some(right)) = (link.left.find(display), link.right.find(display)) else {
            return Passing::Differs;
        };
        let ranges = &display.clauses[link.left.clause()].ranges;
        let mut bounds = Vec::new();
        for range in ranges {
            match (
                self.evaluator.integer(&range.from),
                self.evaluator.integer(&range.to),
            ) {
                (Ok(from), Ok(to)) => bounds.push((from, to)),
                _ => return Passing::Differs,
            }
        }
        let names: Vec<String> = ranges.iter().map(|r| latex::canonical(&r.index)).collect();
        for tuple in index_tuples(&bounds) {
            let indices: Vec<(String, i64)> = names.iter().cloned().zip(tuple).collect();
            let sides = self.evaluator.with_indices(&indices, |e| {
                Ok((e.expression(left)?, e.expression(right)?))
            });
            match sides {
                Ok((l, r)) if same(&l, &r) => {}
                Err(Failure {
                    kind: FailureKind::Outside { name },
                    ..
                }) => return Passing::Missing(name),
                _ => return Passing::Differs,
            }
        }
        Passing::Agrees
    }
}

fn same(left: &Value<u64>, right: &Value<u64>) -> bool {
    let zero = |v: &Value<u64>| v.entries().iter().all(|e| **e == 0);
    match (left, right) {
        (Value::Zero, other) | (other, Value::Zero) => zero(other),
        (Value::Scalar(0), other) | (other, Value::Scalar(0)) => zero(other),
        _ => left == right,
    }
}

fn residue(value: &RationalFunction, point: &[u64]) -> Option<u64> {
    use crate::domain::Domain;
    let top = value.numerator().evaluate_mod(point, PRIME).ok()?;
    let bottom = value.denominator().evaluate_mod(point, PRIME).ok()?;
    PrimeField.divide(&top, &bottom)
}

/// Combinations of `size` edits at different places, in order, at most `limit` of them.
fn combinations(class: &[Replacement], size: usize, limit: usize) -> Vec<Vec<&Replacement>> {
    let mut found: Vec<Vec<&Replacement>> = vec![Vec::new()];
    for _ in 0..size {
        let mut longer = Vec::new();
        for combination in &found {
            let from = combination.last().map(|last| &last.address);
            for replacement in class {
                if from.is_none_or(|a| *a < replacement.address) {
                    let mut next = combination.clone();
                    next.push(replacement);
                    longer.push(next);
                    if longer.len() >= limit {
                        break;
                    }
                }
            }
        }
        found = longer;
    }
    found
}
