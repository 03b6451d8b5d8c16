//! Which candidates are not ruled out: first at one point modulo the prime, then for all indices.

use super::evaluators::{Passing, passes};
use super::parallel::{Blocks, end, first_until, under};
use super::sites::Trial;
use super::work::{self, Spent};
use super::{Candidate, EXACTLY, edited};
use crate::model::links::Place;
use crate::progress::interrupted;
use ratpoly::allowance;

/// Up to how many candidates without an image are evaluated exactly where the print has one: it is dear.
const FEW: usize = 3;

/// How many candidates the slow filter looks at.
const SLOW: usize = 20_000;

/// From how many units on threads are worth their evaluators.
const MANY: usize = 1_000;

/// How many units a thread takes at a time.
const BLOCK: usize = 64;

/// At how many other points a candidate is tried that has no value at the first.
const ELSEWHERE: u64 = 6;

impl<'m> Trial<'_, 'm> {
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
            let found = under(allowance::left(), || {
                let results = (0..units).map(|unit| measured(self, unit));
                first_until(results, limit, |(_, spent)| *spent)
            });
            found.unwrap_or_else(|| {
                end();
                Vec::new()
            })
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
        let mut steps = 0;
        for (result, spent) in results {
            self.spent = self.spent.and(spent);
            steps += spent.work;
            found.push(result);
        }
        // The document pays for it, whichever thread it was done on.
        allowance::spend(work::of_engine(steps, self.functions));
        found
    }

    /// Of so many candidates, those that are not ruled out.
    pub fn passing(
        &mut self,
        candidates: usize,
        candidate: impl Fn(usize) -> Candidate + Sync,
    ) -> Vec<Candidate> {
        self.all = self.all.saturating_add(candidates);
        let judge = |trial: &mut Trial<'_, 'm>, k: usize| {
            let candidate = candidate(k);
            if !trial.fast || trial.touches_elsewhere(&candidate) {
                return None;
            }
            trial
                .told(&candidate.steps)
                .or_else(|| trial.told_elsewhere(&candidate))
        };
        let verdicts = self.each(candidates, self.left(), judge, |_| 1);
        let of = |verdict: Option<bool>| {
            let all = verdicts.iter().enumerate();
            let of = all.filter(move |(_, v)| **v == verdict);
            of.map(|(k, _)| k).collect::<Vec<usize>>()
        };
        let mut open = of(Some(true));
        let certain = open.len();
        let mut unknown = of(None).into_iter();
        open.extend(unknown.by_ref().take(SLOW));
        let left: Vec<u32> = unknown.map(|k| candidate(k).cost).collect();
        self.unjudged.extend(left);
        self.sift(&open, certain, candidate)
    }

    /// Those of some candidates that agree for all indices.
    pub fn sifted(&mut self, found: &[Candidate]) -> Vec<Candidate> {
        let all: Vec<usize> = (0..found.len()).collect();
        self.sift(&all, all.len(), |k| found[k].clone())
    }

    /// Of candidates, of which so many agree at the first indices, those that agree for all; what has no
    /// value modulo the prime, exactly.
    fn sift(
        &mut self,
        open: &[usize],
        agreeing: usize,
        candidate: impl Fn(usize) -> Candidate + Sync,
    ) -> Vec<Candidate> {
        let judge = |trial: &mut Trial<'_, 'm>, k: usize| {
            let display = edited(trial.display, &candidate(open[k]).steps);
            let sides = [trial.link.left, trial.link.right].into_iter();
            let steps = sides.filter_map(|p| p.find(&display)).map(work::evaluated);
            trial.store.charge(steps.sum());
            let evaluator = &mut trial.store.evaluator;
            passes(evaluator, trial.functions, &display, trial.link)
        };
        let verdicts = self.each(open.len(), self.reserve(), judge, |_| 0);
        let (mut passing, mut unknown) = (Vec::new(), Vec::new());
        for (k, verdict) in verdicts.into_iter().enumerate() {
            match verdict {
                Passing::Agrees => passing.push(candidate(open[k])),
                // It agrees where its functions have images: the proof decides.
                Passing::Unknown if k < agreeing => passing.push(candidate(open[k])),
                Passing::Unknown => unknown.push(open[k]),
                Passing::Differs => {}
            }
        }
        // Exactly, one by one: all that can be where the print itself has functions without an image, and a
        // few where it has none.
        let few = unknown.len() <= FEW;
        let most = match self.blind {
            true => EXACTLY,
            false => unknown.len() * usize::from(few),
        };
        let left = self.limit.work.saturating_sub(self.spent.work);
        let (mut steps, mut judged) = (0, 0);
        if let Some(exact) = self.exact.as_mut() {
            for k in unknown.iter().take(most) {
                if steps >= left || interrupted() {
                    break;
                }
                judged += 1;
                let candidate = candidate(*k);
                let display = edited(self.display, &candidate.steps);
                let (agree, cost) = exact.agree(&display, self.link);
                steps += cost;
                if agree {
                    passing.push(candidate);
                }
            }
            self.spent.work += steps;
        }
        let costs = unknown.iter().skip(judged).map(|k| candidate(*k).cost);
        self.unjudged.extend(costs);
        passing
    }

    /// Whether the sides agree with a candidate's edits at another point, where its functions have images.
    fn told_elsewhere(&mut self, candidate: &Candidate) -> Option<bool> {
        if !self.functions || self.blind {
            return None;
        }
        for k in 0..ELSEWHERE {
            let (point, here) = (self.point + 1 + k, k as usize);
            if self.elsewhere.len() <= here {
                let checker = self.seed.checker();
                let other = Trial::at(&checker, self.display, self.link, self.limit, point);
                self.elsewhere.push(other);
            }
            let other = &mut self.elsewhere[here];
            let before = other.store.steps();
            let told = match other.blind {
                true => None,
                false => other.told(&candidate.steps),
            };
            let steps = other.store.steps() - before;
            self.store.charge(steps);
            if told.is_some() {
                return told;
            }
        }
        None
    }

    /// Whether an edit changes what stands in neither side.
    fn touches_elsewhere(&self, candidate: &Candidate) -> bool {
        let sides: [Place; 2] = [self.link.left, self.link.right];
        let mut steps = candidate.steps.iter();
        steps.any(|step| !sides.contains(&step.address.place))
    }
}
