//! The candidates of one link as they are tried: each costs its new nodes from the edited place up
//! to the side.

use super::evaluators::{ExactFilter, Passing, passes};
use super::pairs::Table;
use super::parallel::{Blocks, Seed, first_until};
use super::residue::{Residue, compared, operation};
use super::store::{Env, Id, Shape, Store};
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
    /// What stands directly below.
    pub children: Vec<usize>,
    /// What stands below: all after this one and before that.
    pub end: usize,
    /// Whether it is no operation, but brackets or a brace around one.
    plain: bool,
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
    pub nodes: Option<Rc<Vec<Id>>>,
    pub tried: usize,
    pub limit: usize,
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
        limit: usize,
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
            tried: 0,
            limit,
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
        if self.spots[parent].plain {
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
            trial.told(&candidate.steps)
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

    /// Whether the sides agree with some edits, at the first indices that tell; none where that cannot
    /// be told.
    pub(super) fn told(&mut self, steps: &[Replacement]) -> Option<bool> {
        if let Some(puts) = self.puts(steps) {
            let sides = [self.link.left, self.link.right];
            let [left, right] = sides.map(|place| self.side_with(place, &puts));
            return compared(&left, &right);
        }
        let sides = self.edited_sides(steps);
        self.compare(sides, self.env)
    }

    /// Several edits at places of which none holds another, with their nodes.
    fn puts<'e>(&mut self, steps: &'e [Replacement]) -> Option<Vec<(usize, Id, &'e Replacement)>> {
        let mut puts: Vec<(usize, Id, &Replacement)> = Vec::with_capacity(steps.len());
        if steps.len() < 2 {
            return None;
        }
        for step in steps {
            let spot = *self.spot_at.get(&step.address)?;
            if puts.iter().any(|(other, ..)| self.are_nested(spot, *other)) {
                return None;
            }
            let expr = Expr::new(step.kind.clone(), crate::span::Span::default());
            puts.push((spot, self.store.node(&expr), step));
        }
        Some(puts)
    }

    /// Whether one of two places holds the other.
    pub fn are_nested(&self, one: usize, two: usize) -> bool {
        let holds = |a: usize, b: usize| (a..self.spots[a].end).contains(&b);
        holds(one, two) || holds(two, one)
    }

    /// The value of a side with other nodes put in some of its places, which keeps nothing.
    pub fn side_with(&mut self, place: Place, puts: &[(usize, Id, &Replacement)]) -> Residue {
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
        for (_, _, edit) in puts.iter().filter(|(_, _, e)| e.address.place == place) {
            if let Some(expr) = edit.address.below(&mut side) {
                expr.kind = edit.kind.clone();
            }
        }
        self.store.evaluated(&side, self.env)
    }

    /// The value of a printed subexpression with other nodes put in some places below it; none where
    /// only the whole expression tells.
    fn value_with(&mut self, spot: usize, puts: &[(usize, Id, &Replacement)]) -> Option<Residue> {
        if let Some((_, id, _)) = puts.iter().find(|(at, ..)| *at == spot) {
            return Some(self.store.value(*id, self.env));
        }
        let here = &self.spots[spot];
        let inside = |from: usize| puts.iter().any(|(at, ..)| (from..here.end).contains(at));
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
