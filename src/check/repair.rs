//! The search for the smallest correction of a refuted equation.
//!
//! Candidates are combinations of the single edits of [`super::edit`], fewest edits first. Each is
//! evaluated modulo a 61-bit prime at a random point of the declared symbols; a candidate that is
//! true as a formula passes, a false one passes with negligible probability, and what passes is
//! then proved over the rational functions like any other claim.

use super::Checker;
use super::edit::{self, Address, Replacement};
use super::identity::Decision;
use super::sides::sides_of;
use crate::domain::{Domain, PRIME, PrimeField, Rationals};
use crate::evaluate::{Evaluator, Failure, FailureKind, Key, Value};
use crate::expr::Display;
use crate::latex;
use crate::model::links::Link;
use crate::span::Span;
use crate::verdict::{Certificate, Correction, Edit, EditClass, Rejected, Witness};
use num_rational::BigRational;
use ratpoly::RationalFunction;

/// How many readings of the same places are reported as rejected.
const REPORTED: usize = 128;

/// How many candidates that the filter cannot judge are proved or refuted one by one.
const PROVED: usize = 400;

/// What a candidate is modulo the prime.
enum Passing {
    /// The sides agree.
    Agrees,
    /// They differ, or have no value.
    Differs,
    /// It names something that does not exist.
    Missing(String),
    /// Functions have no value there: only a proof can tell.
    Unknown,
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
        let context = edit::Context::of(self.model);
        let mut singles: Vec<Vec<Replacement>> = Vec::new();
        for single in edit::singles(&display, &places, &context) {
            match singles.iter_mut().find(|class| class[0].class == single.class) {
                Some(class) => class.push(single),
                None => singles.push(vec![single]),
            }
        }
        let rows = edit::braces_under_all_rows(&display, link.right);
        let filter = Some(self.filter());
        let mut trials = Trials::new(&display, link, filter, 0, limit);
        if !rows.is_empty() {
            trials.consider(rows.iter().collect());
        }
        // One edit of any class; then several of the same class, as one slip repeated (a lost dot
        // in each row, both indices of a formula).
        for replacement in singles.iter().flatten() {
            trials.consider(vec![replacement]);
        }
        for size in 2..=4 {
            for class in &singles {
                let largest = match class.first().map(|r| r.class) {
                    Some(EditClass::Dot) => 4,
                    Some(EditClass::Transpose) => 3,
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
        let (tried, filter) = (trials.tried, trials.filter.take());
        if let Some(found) = self.prove(equation, trials) {
            return Some(found);
        }
        // Two slips of different kinds, where the filter can tell.
        let edits: usize = singles.iter().map(Vec::len).sum();
        if edits.saturating_mul(edits) / 2 > limit.saturating_sub(tried) {
            return None;
        }
        let mut trials = Trials::new(&display, link, filter, tried, limit);
        for (one, two) in different_pairs(&singles) {
            trials.consider(vec![one, two]);
        }
        trials.unknown.clear();
        self.prove(equation, trials)
    }

    /// Proves the candidates that were not ruled out.
    fn prove(
        &mut self,
        equation: usize,
        trials: Trials<'_, '_>,
    ) -> Option<(Correction, Certificate)> {
        let display = trials.display;
        let link = trials.link;
        let Trials {
            tried,
            mut passing,
            unknown,
            rejected,
            ..
        } = trials;
        passing.extend(unknown.into_iter().take(PROVED));
        let describe = |combination: &[&Replacement]| -> Vec<Edit> {
            combination
                .iter()
                .filter_map(|r| r.describe(display))
                .collect()
        };
        // Of the rejected readings, those that change the same places in the same way matter.
        let touched: Vec<Vec<(&Address, EditClass)>> = passing
            .iter()
            .map(|c| c.iter().map(|r| (&r.address, r.class)).collect())
            .collect();
        let rejected: Vec<Candidate> = rejected
            .iter()
            .filter(|(combination, _)| {
                touched.iter().any(|places| {
                    combination
                        .iter()
                        .all(|r| places.contains(&(&r.address, r.class)))
                })
            })
            .map(|(combination, missing)| Candidate {
                edits: describe(combination),
                display: edited(display, combination),
                missing: missing.clone(),
            })
            .collect();
        let passing: Vec<Candidate> = passing
            .iter()
            .map(|combination| Candidate {
                edits: describe(combination),
                display: edited(display, combination),
                missing: None,
            })
            .collect();
        self.choose(equation, link, passing, rejected, tried)
    }

    /// Proves the candidates that passed; the first proved one is the correction.
    fn choose(
        &mut self,
        equation: usize,
        link: &Link,
        passing: Vec<Candidate>,
        rejected: Vec<Candidate>,
        tried: usize,
    ) -> Option<(Correction, Certificate)> {
        let before = self.exact.display(equation).clone();
        let mut proved: Vec<(
            Vec<Edit>,
            Display,
            Option<crate::verdict::Given>,
            Certificate,
        )> = Vec::new();
        for Candidate { edits, display, .. } in passing {
            self.exact.correct(equation, display.clone());
            let Ok(entries) = self.sides(equation, link) else {
                continue;
            };
            // A correction that makes both sides the same text says nothing.
            let sides = [link.left, link.right].map(|p| p.find(&display).map(latex::write_expr));
            if sides[0] == sides[1] {
                continue;
            }
            match self.decide_true(&entries, equation) {
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
        self.exact.correct(equation, before.clone());
        // Identities before equations that need a relation; of these what fits the units best.
        proved.sort_by_key(|(_, _, given, _)| given.is_some());
        let mut proved = self
            .fitting_units_best(equation, proved, |(_, display, ..)| display)
            .into_iter();
        let (edits, display, given, proof) = proved.next()?;
        let places: Vec<_> = edits.iter().map(|e| (e.span, e.class)).collect();
        let as_printed = Candidate {
            edits: Vec::new(),
            display: before,
            missing: None,
        };
        let rejected: Vec<Candidate> = [as_printed]
            .into_iter()
            .chain(rejected)
            .filter(|other| {
                let mut edits = other.edits.iter();
                edits.all(|e| places.contains(&(e.span, e.class)))
            })
            .take(REPORTED)
            .collect();
        let rejected = self.explain_rejected(link, rejected);
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

    /// Where each rejected reading fails: what it names that does not exist, and both sides at the
    /// reference point.
    fn explain_rejected(&self, link: &Link, rejected: Vec<Candidate>) -> Vec<Rejected> {
        let span = Span::default();
        let point = self.reference_point();
        let shown: Vec<(usize, BigRational)> = (0..point.len())
            .filter(|l| self.has_reference(*l))
            .map(|l| (l, point[l].clone()))
            .collect();
        let table = self.model.functions.clone();
        let real: Vec<Option<BigRational>> = (0..point.len())
            .map(|l| (!self.is_function(l)).then(|| point[l].clone()))
            .collect();
        let mut evaluator = self.evaluator_at(Rationals, point, move |value, point| {
            match &table {
                Some(table) => table.rational_value(value, &real),
                None => value.evaluate(point).ok(),
            }
            .ok_or(FailureKind::DivisionByZero)
        });
        rejected
            .into_iter()
            .map(|candidate| {
                let mut missing = candidate.missing;
                let mut misfit = None;
                evaluator.lenient = false;
                if let Err(failure) = sides_of(&mut evaluator, &candidate.display, link, span) {
                    misfit = failure.misfit();
                    if let FailureKind::Outside { name } = failure.kind {
                        missing = Some(name);
                    }
                }
                evaluator.lenient = true;
                let witness = sides_of(&mut evaluator, &candidate.display, link, span)
                    .ok()
                    .and_then(|pairs| {
                        pairs.into_iter().find_map(|(indices, left, right)| {
                            let (place, left, right) = first_difference(&left, &right)?;
                            Some(Witness {
                                point: shown.clone(),
                                left,
                                right,
                                place,
                                indices,
                            })
                        })
                    });
                Rejected {
                    edits: candidate.edits,
                    missing,
                    misfit,
                    witness,
                }
            })
            .collect()
    }

    /// An evaluator over another field at a point, whose names have the images of their exact
    /// values.
    fn evaluator_at<D>(
        &self,
        field: D,
        point: Vec<D::Element>,
        image: impl Fn(&RationalFunction, &[D::Element]) -> Result<D::Element, FailureKind> + 'm,
    ) -> Evaluator<'m, D>
    where
        D: Domain + 'm,
    {
        let mut exact = self.exact.anew();
        let at = point.clone();
        // A letter has the value that the hypotheses printed around the equation give it.
        let letters = self.exact.letters().iter().zip(&point);
        let point = letters
            .map(|(letter, free)| image(letter, &at).unwrap_or_else(|_| free.clone()))
            .collect();
        let provider = move |key: &Key| -> Option<Result<Value<D::Element>, Failure>> {
            let span = crate::span::Span::default();
            let value = match exact.value_of(key.clone(), span) {
                Ok(value) => value,
                Err(failure) => return Some(Err(failure)),
            };
            Some(value.try_map(|e| image(e, &at).map_err(|kind| Failure::new(kind, span))))
        };
        let mut evaluator = Evaluator::new(self.model, field, point)
            .in_instance(self.instance)
            .with_provider(Box::new(provider));
        for (equation, display) in self.exact.corrections() {
            evaluator.correct(*equation, display.clone());
        }
        evaluator
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
            if let Some(image) = PrimeField.image(value, &point) {
                point[*letter] = image;
            }
        }
        // A root or a sine at a random point would not keep its relation.
        let table = model.functions.clone();
        let image = move |value: &RationalFunction, point: &[u64]| {
            if let Some(table) = &table {
                let quadratic = |p: &ratpoly::Polynomial| {
                    let quadratics = table.quadratics();
                    quadratics.iter().any(|q| p.degree(q.letter) > Some(0))
                };
                if quadratic(value.numerator()) || quadratic(value.denominator()) {
                    return Err(FailureKind::Unsupported {
                        what: "a quadratic letter modulo a prime".into(),
                    });
                }
            }
            PrimeField
                .image(value, point)
                .ok_or(FailureKind::DivisionByZero)
        };
        Filter {
            evaluator: self.evaluator_at(PrimeField, point, image),
            functions: model.functions.is_some(),
        }
    }
}

/// The candidates of one link as they are tried.
struct Trials<'r, 'm> {
    display: &'r Display,
    link: &'r Link,
    filter: Option<Filter<'m>>,
    tried: usize,
    limit: usize,
    passing: Vec<Vec<&'r Replacement>>,
    /// Candidates that only a proof can tell apart.
    unknown: Vec<Vec<&'r Replacement>>,
    rejected: Vec<(Vec<&'r Replacement>, Option<String>)>,
}

impl<'r, 'm> Trials<'r, 'm> {
    fn new(
        display: &'r Display,
        link: &'r Link,
        filter: Option<Filter<'m>>,
        tried: usize,
        limit: usize,
    ) -> Self {
        Trials {
            display,
            link,
            filter,
            tried,
            limit,
            passing: Vec::new(),
            unknown: Vec::new(),
            rejected: Vec::new(),
        }
    }

    fn consider(&mut self, combination: Vec<&'r Replacement>) {
        if self.tried >= self.limit {
            return;
        }
        self.tried += 1;
        let mut candidate = self.display.clone();
        if !combination.iter().all(|r| r.apply(&mut candidate)) {
            return;
        }
        let Some(filter) = &mut self.filter else {
            return;
        };
        match filter.passes(&candidate, self.link) {
            Passing::Agrees => self.passing.push(combination),
            Passing::Unknown => self.unknown.push(combination),
            Passing::Missing(name) => self.rejected.push((combination, Some(name))),
            Passing::Differs => self.rejected.push((combination, None)),
        }
    }
}

struct Filter<'m> {
    evaluator: Evaluator<'m, PrimeField>,
    /// Whether the document has letters for functions, which have no values modulo the prime.
    functions: bool,
}

impl Filter<'_> {
    fn passes(&mut self, display: &Display, link: &Link) -> Passing {
        match sides_of(&mut self.evaluator, display, link, Span::default()) {
            Ok(pairs) if pairs.iter().all(|(_, l, r)| same(l, r)) => Passing::Agrees,
            Err(Failure {
                kind: FailureKind::Outside { name },
                ..
            }) => Passing::Missing(name),
            Err(Failure {
                kind: FailureKind::Unsupported { .. },
                ..
            }) if self.functions => Passing::Unknown,
            _ => Passing::Differs,
        }
    }
}

/// A candidate with its changes, and what it names that does not exist.
struct Candidate {
    edits: Vec<Edit>,
    display: Display,
    missing: Option<String>,
}

fn edited(display: &Display, combination: &[&Replacement]) -> Display {
    let mut candidate = display.clone();
    for replacement in combination {
        replacement.apply(&mut candidate);
    }
    candidate
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

fn same(left: &Value<u64>, right: &Value<u64>) -> bool {
    let zero = |v: &Value<u64>| v.entries().iter().all(|e| **e == 0);
    match (left, right) {
        (Value::Zero, other) | (other, Value::Zero) => zero(other),
        (Value::Scalar(0), other) | (other, Value::Scalar(0)) => zero(other),
        _ => left == right,
    }
}

/// Pairs of edits of different kinds at different places.
fn different_pairs(
    singles: &[Vec<Replacement>],
) -> impl Iterator<Item = (&Replacement, &Replacement)> {
    singles.iter().enumerate().flat_map(move |(k, class)| {
        class.iter().flat_map(move |one| {
            singles[k + 1..]
                .iter()
                .flatten()
                .filter(move |two| !one.address.is_nested_with(&two.address))
                .map(move |two| (one, two))
        })
    })
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
