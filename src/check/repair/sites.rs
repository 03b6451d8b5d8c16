//! The candidates of one link as they are tried: each costs its new nodes from the edited place up
//! to the side.

use super::evaluators::{ExactFilter, Passing, passes};
use super::pairs::Table;
use super::parallel::{Blocks, Seed, first_until};
use super::store::{Env, Id, Residue, Shape, Store, same};
use super::{Candidate, edited};
use crate::check::edit::{Address, Replacement, sites};
use crate::check::{Checker, index_tuples};
use crate::expr::{Display, Expr, ExprKind};
use crate::latex;
use crate::model::links::{Link, Place};
use std::collections::HashMap;
use std::rc::Rc;

/// A subexpression of the printed sides.
pub(super) struct Spot {
    pub address: Address,
    pub id: Id,
    pub parent: Option<usize>,
    pub step: usize,
}

/// The candidates of a link.
pub(super) struct Trial<'r, 'm> {
    pub display: &'r Display,
    pub link: &'r Link,
    pub store: Store<'m>,
    pub spots: Vec<Spot>,
    pub spot_at: HashMap<Address, usize>,
    /// The indices for which candidates are compared first: the sides as printed differ there.
    pub env: Env,
    /// Whether the store can judge at all.
    pub fast: bool,
    functions: bool,
    exact: Option<ExactFilter<'m>>,
    seed: Seed<'m>,
    threads: usize,
    /// For pairs: what each edit puts at its place.
    pub table: Option<Rc<Table>>,
    pub tried: usize,
    pub limit: usize,
    /// Whether both sides as printed are zero.
    pub zero: bool,
}

/// How many candidates the slow filter looks at.
const SLOW: usize = 20_000;

/// From how many units on threads are worth their evaluators.
const MANY: usize = 1_000;

/// How many units a thread takes at a time.
const BLOCK: usize = 64;

impl<'r, 'm> Trial<'r, 'm> {
    pub fn new(
        checker: &Checker<'m>,
        display: &'r Display,
        link: &'r Link,
        limit: usize,
    ) -> Trial<'r, 'm> {
        let (evaluator, exact, images) = checker.modulo_prime();
        let functions = checker.model.functions.is_some();
        let exact = functions.then_some((exact, images));
        let mut store = Store::new(display, evaluator, exact);
        let mut spots = Vec::new();
        let mut spot_at = HashMap::new();
        for place in [link.left, link.right] {
            for site in sites(display, place) {
                let (step, parent) = match site.address.path.split_last() {
                    Some((step, up)) => {
                        let up = Address {
                            place,
                            path: up.to_vec(),
                        };
                        (*step, spot_at.get(&up).copied())
                    }
                    None => (0, None),
                };
                spot_at.insert(site.address.clone(), spots.len());
                spots.push(Spot {
                    id: store.node(site.expr),
                    address: site.address,
                    parent,
                    step,
                });
            }
        }
        // The first values of the running indices for which the sides differ.
        let ranges = &display.clauses[link.left.clause()].ranges;
        let names = ranges.iter().map(|r| latex::canonical(&r.index));
        let names: Vec<String> = names.collect();
        let bounds: Option<Vec<(i64, i64)>> = ranges
            .iter()
            .map(|r| {
                let from = store.evaluator.integer(&r.from).ok()?;
                Some((from, store.evaluator.integer(&r.to).ok()?))
            })
            .collect();
        let mut trial = Trial {
            display,
            link,
            store,
            spots,
            spot_at,
            env: 0,
            fast: bounds.is_some() && !constant_or_cases(display, link),
            functions,
            exact: functions.then(|| ExactFilter::new(checker)),
            seed: Seed::of(checker),
            // The images of functions depend on the order in which they are met.
            threads: if functions {
                1
            } else {
                checker.options.threads
            },
            table: None,
            tried: 0,
            limit,
            zero: false,
        };
        let sides = trial.sides();
        let mut first = None;
        for tuple in index_tuples(&bounds.unwrap_or_default()) {
            let indices: Vec<(String, i64)> = names.iter().cloned().zip(tuple).collect();
            let env = trial.store.env(&indices);
            first = first.or(Some(env));
            if trial.compare(sides, env) != Some(true) {
                first = Some(env);
                break;
            }
        }
        trial.env = first.unwrap_or(0);
        let zero = |residue: Residue| {
            residue
                .value()
                .is_some_and(|v| v.entries().iter().all(|e| **e == 0))
        };
        trial.zero = sides
            .iter()
            .all(|id| zero(trial.store.value(*id, trial.env)));
        trial
    }

    /// The nodes of both sides as printed.
    pub fn sides(&self) -> [Id; 2] {
        [self.link.left, self.link.right].map(|place| {
            let spot = self.spot_at.get(&Address::of_side(place));
            spot.map_or(0, |s| self.spots[*s].id)
        })
    }

    /// Whether two nodes are equal; none where that cannot be told.
    fn compare(&mut self, sides: [Id; 2], env: Env) -> Option<bool> {
        let [left, right] = sides.map(|id| self.store.value(id, env));
        match (left, right) {
            (Residue::Is(left), Residue::Is(right)) => Some(same(&left, &right)),
            (Residue::Unknown, _) | (_, Residue::Unknown) => None,
            _ => Some(false),
        }
    }

    /// The node of a side with an edit.
    fn lifted(&mut self, replacement: &Replacement) -> Option<Id> {
        let mut spot = *self.spot_at.get(&replacement.address)?;
        let expr = Expr::new(replacement.kind.clone(), crate::span::Span::default());
        let mut id = self.store.node(&expr);
        while let Some(parent) = self.spots[spot].parent {
            id = self.with_child(parent, self.spots[spot].step, id)?;
            spot = parent;
        }
        Some(id)
    }

    /// The node of a subexpression with another child; none where its children are no nodes.
    fn with_child(&mut self, parent: usize, step: usize, child: Id) -> Option<Id> {
        let expr = self.spots[parent].address.find(self.display)?;
        if matches!(
            expr.kind,
            ExprKind::Group { .. } | ExprKind::Underbrace { .. }
        ) {
            return Some(child);
        }
        let mut shape = (*self.store.shape(self.spots[parent].id)).clone();
        match &mut shape {
            Shape::Sum(terms) => terms.get_mut(step)?.1 = child,
            Shape::Product(ids) => *ids.get_mut(step)? = child,
            Shape::Quotient(above, below) => *[above, below].into_iter().nth(step)? = child,
            Shape::Power(base, _) if step == 0 => *base = child,
            Shape::Transpose(inner) => *inner = child,
            Shape::Running(_, _, _, body) if step == 2 => *body = child,
            // A matrix may need its expression for blocks.
            _ => return None,
        }
        Some(self.store.shared(shape, None))
    }

    /// The nodes of both sides with some edits.
    fn edited_sides(&mut self, steps: &[Replacement]) -> [Id; 2] {
        let mut sides = self.sides();
        if let [only] = steps
            && let Some(id) = self.lifted(only)
        {
            sides[usize::from(only.address.place != self.link.left)] = id;
            return sides;
        }
        let display = edited(self.display, steps);
        for (side, place) in sides.iter_mut().zip([self.link.left, self.link.right]) {
            if let Some(expr) = place.find(&display) {
                *side = self.store.node(expr);
            }
        }
        sides
    }

    /// What `work` says of each of some units, on several threads where there are many of them; no
    /// more units once what they have `spent` together reaches a bound.
    pub fn each<R: Send>(
        &mut self,
        units: usize,
        left: usize,
        work: impl Fn(&mut Trial<'_, 'm>, usize) -> R + Sync,
        spent: impl Fn(&R) -> usize + Sync,
    ) -> Vec<R> {
        if self.threads < 2 || units < MANY {
            return first_until((0..units).map(|unit| work(self, unit)), left, spent);
        }
        let (display, link, limit, seed) = (self.display, self.link, self.limit, &self.seed);
        let blocks = Blocks {
            units,
            size: BLOCK,
            threads: self.threads,
        };
        let start = || Trial::new(&seed.checker(), display, link, limit);
        let results = blocks.run(
            left,
            start,
            |trial, range| range.map(|unit| work(trial, unit)).collect::<Vec<R>>(),
            |results| results.iter().map(&spent).sum(),
        );
        first_until(results.into_iter().flatten(), left, spent)
    }

    /// Of some candidates, those that are not ruled out.
    pub fn passing(&mut self, candidates: Vec<Candidate>) -> Vec<Candidate> {
        let left = self.limit.saturating_sub(self.tried);
        let judge = |trial: &mut Trial<'_, 'm>, k: usize| {
            let candidate: &Candidate = &candidates[k];
            if !trial.fast || trial.touches_elsewhere(candidate) {
                return None;
            }
            let sides = trial.edited_sides(&candidate.steps);
            trial.compare(sides, trial.env)
        };
        let verdicts = self.each(candidates.len(), left, judge, |_| 1);
        self.tried += verdicts.len();
        let mut found = Vec::new();
        let mut unknown = Vec::new();
        for (candidate, verdict) in candidates.into_iter().zip(verdicts) {
            match verdict {
                Some(true) => found.push(candidate),
                Some(false) => {}
                None => unknown.push(candidate),
            }
        }
        self.sifted(found, unknown)
    }

    /// Whether the sides agree with some edits, at the first indices that tell.
    pub fn agrees(&mut self, candidate: &Candidate) -> bool {
        let sides = self.edited_sides(&candidate.steps);
        self.compare(sides, self.env) == Some(true)
    }

    /// Whether an edit changes what stands in neither side.
    fn touches_elsewhere(&self, candidate: &Candidate) -> bool {
        let sides: [Place; 2] = [self.link.left, self.link.right];
        let mut steps = candidate.steps.iter();
        steps.any(|step| !sides.contains(&step.address.place))
    }

    /// Those that agree for all indices; what the store cannot tell, by the evaluator.
    pub fn sifted(&mut self, found: Vec<Candidate>, unknown: Vec<Candidate>) -> Vec<Candidate> {
        let mut passing = Vec::new();
        let mut open = Vec::new();
        let candidates: Vec<Candidate> = found
            .into_iter()
            .chain(unknown.into_iter().take(SLOW))
            .collect();
        let judge = |trial: &mut Trial<'_, 'm>, k: usize| {
            let display = edited(trial.display, &candidates[k].steps);
            let evaluator = &mut trial.store.evaluator;
            passes(evaluator, trial.functions, &display, trial.link)
        };
        let verdicts = self.each(candidates.len(), usize::MAX, judge, |_| 0);
        for (candidate, verdict) in candidates.into_iter().zip(verdicts) {
            match verdict {
                Passing::Agrees => passing.push(candidate),
                Passing::Unknown => {
                    let display = edited(self.display, &candidate.steps);
                    open.push((candidate, display));
                }
                Passing::Differs => {}
            }
        }
        // With functions that have no image modulo the prime: exactly, one by one.
        if let Some(exact) = &mut self.exact {
            for (candidate, display) in open.into_iter().take(super::EXACTLY) {
                if exact.agree(&display, self.link) {
                    passing.push(candidate);
                }
            }
        }
        passing
    }
}

/// Whether a side is "some constant", or something is defined by cases.
fn constant_or_cases(display: &Display, link: &Link) -> bool {
    let mut found = false;
    for place in [link.left, link.right] {
        if let Some(expr) = place.find(display) {
            crate::model::links::visit(expr, &mut |e| {
                found |= matches!(e.kind, ExprKind::Constant | ExprKind::Cases(_));
            });
        }
    }
    found
}
