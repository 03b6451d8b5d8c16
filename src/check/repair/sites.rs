//! The candidates of one link as they are tried: each costs what it puts in and the operations from
//! there up to the side, and keeps nothing.

use super::evaluators::{ExactFilter, Passing, passes};
use super::pairs::Table;
use super::parallel::{Blocks, Seed, first_until};
use super::residue::{Residue, compared, operation};
use super::store::{Env, Id, Shape, Store};
use super::work::{self, Spent};
use super::{Candidate, edited};
use crate::check::edit::{Address, Change, Replacement, sites};
use crate::check::{Checker, index_tuples};
use crate::expr::{Display, Expr, ExprKind};
use crate::latex;
use crate::model::links::{Link, Place};
use crate::progress::interrupted;
use std::collections::HashMap;
use std::rc::Rc;

/// A subexpression of the printed sides.
pub(super) struct Spot {
    pub address: Address,
    pub id: Id,
    pub parent: Option<usize>,
    pub step: usize,
    /// What stands directly below.
    pub children: Vec<usize>,
    /// What stands below: all after this one and before that.
    pub end: usize,
    /// Whether it is no operation, but brackets or a brace around one.
    plain: bool,
}

/// An edit at its place, with the nodes of what it puts in.
pub(super) struct Put<'e> {
    pub spot: usize,
    pub nodes: Vec<Id>,
    pub edit: &'e Replacement,
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
    /// For pairs that are evaluated one by one: the node of each edit.
    pub nodes: Option<Rc<Vec<Vec<Id>>>>,
    pub spent: Spent,
    pub limit: Spent,
    /// How many candidates there are, as far as they were listed.
    pub all: usize,
    /// How many candidates make the sides agree and say less than the print.
    pub empty: usize,
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
        limit: Spent,
    ) -> Trial<'r, 'm> {
        let (evaluator, exact, images) = checker.modulo_prime();
        let functions = checker.model.functions.is_some();
        let exact = functions.then_some((exact, images));
        let mut store = Store::new(display, evaluator, exact);
        let mut spots: Vec<Spot> = Vec::new();
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
                let here = spots.len();
                spot_at.insert(site.address.clone(), here);
                let mut above = parent;
                if let Some(parent) = parent {
                    spots[parent].children.push(here);
                }
                while let Some(spot) = above {
                    spots[spot].end = here + 1;
                    above = spots[spot].parent;
                }
                spots.push(Spot {
                    id: store.node(site.expr),
                    address: site.address,
                    parent,
                    step,
                    children: Vec::new(),
                    end: here + 1,
                    plain: matches!(
                        site.expr.kind,
                        ExprKind::Group { .. } | ExprKind::Underbrace { .. }
                    ),
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
            nodes: None,
            spent: Spent::default(),
            limit,
            all: 0,
            empty: 0,
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
        trial.store.printed();
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
        compared(&left, &right)
    }

    /// The nodes of both sides with some edits.
    fn edited_sides(&mut self, steps: &[Replacement]) -> [Id; 2] {
        let mut sides = self.sides();
        let display = edited(self.display, steps);
        for (side, place) in sides.iter_mut().zip([self.link.left, self.link.right]) {
            if let Some(expr) = place.find(&display) {
                *side = self.store.node(expr);
            }
        }
        sides
    }

    /// What is left for candidates.
    pub fn left(&self) -> Spent {
        self.limit.less(self.spent)
    }

    /// What is left for what passed: a part of the whole is kept for it.
    pub fn reserve(&self) -> Spent {
        let whole = self.limit.work.saturating_add(self.limit.work / 4);
        Spent {
            tried: usize::MAX,
            work: whole.saturating_sub(self.spent.work),
        }
    }

    /// What `work` says of each of some units, on several threads where there are many of them; no
    /// more units once what they have spent together reaches a limit. A unit has `tried` so many
    /// candidates.
    pub fn each<R: Send>(
        &mut self,
        units: usize,
        limit: Spent,
        work: impl Fn(&mut Trial<'_, 'm>, usize) -> R + Sync,
        tried: impl Fn(&R) -> usize + Sync,
    ) -> Vec<R> {
        let measured = |trial: &mut Trial<'_, 'm>, unit: usize| {
            let before = trial.store.steps();
            let result = work(trial, unit);
            let spent = Spent {
                tried: tried(&result),
                work: trial.store.steps() - before + 1,
            };
            (result, spent)
        };
        let results = if self.threads < 2 || units < MANY {
            let results = (0..units).map(|unit| measured(self, unit));
            first_until(results, limit, |(_, spent)| *spent)
        } else {
            let (display, link, whole, seed) = (self.display, self.link, self.limit, &self.seed);
            let blocks = Blocks {
                units,
                size: BLOCK,
                threads: self.threads,
            };
            let start = || Trial::new(&seed.checker(), display, link, whole);
            let results = blocks.run(
                limit,
                start,
                |trial, range| range.map(|unit| measured(trial, unit)).collect::<Vec<_>>(),
                |results| {
                    let spent = results.iter().map(|(_, spent)| *spent);
                    spent.fold(Spent::default(), Spent::and)
                },
            );
            first_until(results.into_iter().flatten(), limit, |(_, spent)| *spent)
        };
        let mut found = Vec::with_capacity(results.len());
        for (result, spent) in results {
            self.spent = self.spent.and(spent);
            found.push(result);
        }
        found
    }

    /// Of some candidates, those that are not ruled out.
    pub fn passing(&mut self, candidates: Vec<Candidate>) -> Vec<Candidate> {
        self.all += candidates.len();
        let left = self.left();
        let judge = |trial: &mut Trial<'_, 'm>, k: usize| {
            let candidate: &Candidate = &candidates[k];
            if !trial.fast || trial.touches_elsewhere(candidate) {
                return None;
            }
            trial.told(&candidate.steps)
        };
        let verdicts = self.each(candidates.len(), left, judge, |_| 1);
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

    /// Whether the sides agree with some edits, at the first indices that tell; none where that cannot
    /// be told.
    pub(super) fn told(&mut self, steps: &[Replacement]) -> Option<bool> {
        let mark = self.store.mark();
        let told = match self.puts(steps) {
            Some(puts) => {
                let sides = [self.link.left, self.link.right];
                let [left, right] = sides.map(|place| self.side_with(place, &puts));
                compared(&left, &right)
            }
            None => {
                let sides = self.edited_sides(steps);
                self.compare(sides, self.env)
            }
        };
        self.store.release(mark);
        told
    }

    /// Edits at places of which none holds another, with their nodes.
    fn puts<'e>(&mut self, steps: &'e [Replacement]) -> Option<Vec<Put<'e>>> {
        let mut puts: Vec<Put<'e>> = Vec::with_capacity(steps.len());
        for edit in steps {
            let spot = *self.spot_at.get(&edit.address)?;
            if puts.iter().any(|other| self.are_nested(spot, other.spot)) {
                return None;
            }
            let nodes = self.nodes_put_in(edit);
            puts.push(Put { spot, nodes, edit });
        }
        Some(puts)
    }

    /// The nodes of what an edit puts in.
    pub fn nodes_put_in(&mut self, edit: &Replacement) -> Vec<Id> {
        match &edit.change {
            Change::Whole(kind) => {
                let expr = Expr::new(kind.clone(), crate::span::Span::default());
                vec![self.store.node(&expr)]
            }
            change @ (Change::Terms { .. } | Change::Factors { .. }) => {
                let pieces = change.pieces().into_iter();
                pieces.map(|piece| self.store.node(piece)).collect()
            }
        }
    }

    /// The value of an edited subexpression; none where only the whole expression tells.
    pub fn put_value(&mut self, put: &Put<'_>) -> Option<Residue> {
        let printed = self.store.shape(self.spots[put.spot].id);
        let shape = match (&put.edit.change, &*printed) {
            (Change::Whole(_), _) => {
                let id = *put.nodes.first()?;
                return Some(self.store.value(id, self.env));
            }
            (Change::Terms { from, to, by }, Shape::Sum(terms)) => {
                let new = by
                    .iter()
                    .zip(&put.nodes)
                    .map(|((sign, _), id)| (*sign, *id));
                let mut terms = terms.clone();
                terms.splice(*from..*to, new);
                Shape::Sum(terms)
            }
            (Change::Factors { from, to, .. }, Shape::Product(factors)) => {
                let mut factors = factors.clone();
                factors.splice(*from..*to, put.nodes.iter().copied());
                Shape::Product(factors)
            }
            (Change::Terms { .. } | Change::Factors { .. }, _) => return None,
        };
        let residue = operation(&shape, &mut |_, id| self.store.value(id, self.env));
        let value = residue.as_ref().and_then(Residue::value);
        self.store.charge(work::operation(value, shape.operands()));
        residue
    }

    /// Whether one of two places holds the other.
    pub fn are_nested(&self, one: usize, two: usize) -> bool {
        let holds = |a: usize, b: usize| (a..self.spots[a].end).contains(&b);
        holds(one, two) || holds(two, one)
    }

    /// The value of a side with other nodes put in some of its places, which keeps nothing.
    pub fn side_with(&mut self, place: Place, puts: &[Put<'_>]) -> Residue {
        let Some(root) = self.spot_at.get(&Address::of_side(place)).copied() else {
            return Residue::Unknown;
        };
        if let Some(residue) = self.value_with(root, puts) {
            return residue;
        }
        let Some(printed) = place.find(self.display) else {
            return Residue::Unknown;
        };
        let mut side = printed.clone();
        let here = puts.iter().map(|put| put.edit);
        for edit in here.filter(|e| e.address.place == place) {
            if let Some(expr) = edit.address.below(&mut side) {
                edit.change.apply(expr);
            }
        }
        self.store.evaluated(&side, self.env)
    }

    /// The value of a printed subexpression with other nodes put in some places below it; none where
    /// only the whole expression tells.
    fn value_with(&mut self, spot: usize, puts: &[Put<'_>]) -> Option<Residue> {
        if let Some(put) = puts.iter().find(|put| put.spot == spot) {
            return self.put_value(put);
        }
        let here = &self.spots[spot];
        let inside = |from: usize| puts.iter().any(|put| (from..here.end).contains(&put.spot));
        if !inside(spot) {
            return Some(self.store.value(here.id, self.env));
        }
        if here.plain {
            return self.value_with(*here.children.first()?, puts);
        }
        let shape = self.store.shape(here.id);
        // An exponent is no operand.
        if let Some(next) = here.children.get(shape.operands())
            && inside(*next)
        {
            return None;
        }
        let mut told = true;
        let residue = operation(&shape, &mut |k, _| {
            let child = self.spots[spot].children.get(k).copied();
            let value = child.and_then(|child| self.value_with(child, puts));
            told &= value.is_some();
            value.unwrap_or(Residue::Unknown)
        });
        let value = residue.as_ref().and_then(Residue::value);
        self.store.charge(work::operation(value, shape.operands()));
        residue.filter(|_| told)
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
            let sides = [trial.link.left, trial.link.right].into_iter();
            let steps = sides.filter_map(|p| p.find(&display)).map(work::evaluated);
            trial.store.charge(steps.sum());
            let evaluator = &mut trial.store.evaluator;
            passes(evaluator, trial.functions, &display, trial.link)
        };
        let verdicts = self.each(candidates.len(), self.reserve(), judge, |_| 0);
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
            let left = self.limit.work.saturating_sub(self.spent.work);
            let mut steps = 0;
            for (candidate, display) in open.into_iter().take(super::EXACTLY) {
                if steps >= left || interrupted() {
                    break;
                }
                let (agree, cost) = exact.agree(&display, self.link);
                steps += cost;
                if agree {
                    passing.push(candidate);
                }
            }
            self.spent.work += steps;
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
