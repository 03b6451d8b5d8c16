//! The sift on several threads.
//!
//! Each thread has evaluators of its own. Blocks of candidates have a fixed size, and what comes of
//! them is put together in their order, so that the number of threads changes nothing but the time.

use super::work::Spent;
use crate::check::hypotheses::Supposed;
use crate::check::worlds::Insertions;
use crate::check::{Checker, Options};
use crate::domain::Symbolic;
use crate::evaluate::World;
use crate::progress::interrupted;
use crate::stack::Queue;
use ratpoly::RationalFunction;
use ratpoly::allowance::{self, Allowance};
use std::ops::Range;
use std::sync::Arc;
use std::sync::atomic::{AtomicU64, AtomicUsize, Ordering};

/// What a thread needs for a checker of its own.
pub(super) struct Seed<'m> {
    world: World<'m, RationalFunction>,
    field: Symbolic,
    options: Options,
    inserted: Arc<Insertions>,
    supposed: Arc<Supposed>,
}

impl<'m> Seed<'m> {
    pub fn of(checker: &Checker<'m>) -> Self {
        Seed {
            world: checker.exact.world().clone(),
            field: checker.exact.field.clone(),
            options: checker.options,
            inserted: Arc::clone(&checker.inserted),
            supposed: Arc::clone(&checker.supposed),
        }
    }

    /// A checker that has computed nothing yet.
    pub fn checker(&self) -> Checker<'m> {
        let exact = self.world.clone().evaluator(self.field.clone());
        let (inserted, supposed) = (Arc::clone(&self.inserted), Arc::clone(&self.supposed));
        Checker::with(exact, self.options, inserted, supposed)
    }
}

/// Blocks of so many units.
#[derive(Clone, Copy)]
pub(super) struct Blocks {
    pub units: usize,
    pub size: usize,
    pub threads: usize,
}

impl Blocks {
    fn range(&self, block: usize) -> Range<usize> {
        block * self.size..((block + 1) * self.size).min(self.units)
    }

    /// The results of the first blocks, until what they have `spent` together reaches `limit`, or the
    /// run is interrupted. Each thread works with what `start` gives it.
    pub fn run<S, R: Send>(
        self,
        limit: Spent,
        start: impl Fn() -> S + Sync,
        work: impl Fn(&mut S, Range<usize>) -> R + Sync,
        spent: impl Fn(&R) -> Spent + Sync,
    ) -> Vec<R> {
        let blocks = self.units.div_ceil(self.size.max(1));
        let (tried, steps) = (AtomicUsize::new(0), AtomicU64::new(0));
        let total = || Spent {
            tried: tried.load(Ordering::Relaxed),
            work: steps.load(Ordering::Relaxed),
        };
        let allowed = allowance::left();
        let results = Queue::run(blocks, self.threads, |queue| {
            let Some(mut state) = under(allowed, &start) else {
                return;
            };
            // Blocks are taken in order: what is done at any time are the first ones.
            while !total().reaches(limit)
                && !interrupted()
                && let Some(block) = queue.take()
            {
                // What was cut short left the state in the middle of something.
                let Some(result) = under(allowed, || work(&mut state, self.range(block))) else {
                    return;
                };
                let spent = spent(&result);
                tried.fetch_add(spent.tried, Ordering::Relaxed);
                steps.fetch_add(spent.work, Ordering::Relaxed);
                queue.put(block, result);
            }
        });
        let found = first_until(
            results.into_iter().map_while(|result| result),
            limit,
            &spent,
        );
        let whole = found.iter().map(&spent).fold(Spent::default(), Spent::and);
        if found.len() < blocks && !whole.reaches(limit) {
            end();
        }
        found
    }
}

/// What comes of work under an allowance, as far as one is in force: each thread has its own, and each
/// block the same one. What it spends is counted in the steps of the search.
pub(super) fn under<T>(allowed: Option<Allowance>, work: impl FnOnce() -> T) -> Option<T> {
    match allowed {
        Some(allowed) => allowance::apart(allowed, work).ok(),
        None => Some(work()),
    }
}

/// Ends the search: a part of it came to the end of its allowance.
pub(super) fn end() {
    allowance::spend(u64::MAX);
}

/// The first results, until what they have `spent` together reaches `limit`.
pub(super) fn first_until<R>(
    mut results: impl Iterator<Item = R>,
    limit: Spent,
    spent: impl Fn(&R) -> Spent,
) -> Vec<R> {
    let mut sum = Spent::default();
    let mut found = Vec::new();
    while !sum.reaches(limit)
        && !interrupted()
        && let Some(result) = results.next()
    {
        sum = sum.and(spent(&result));
        found.push(result);
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_same_results_from_any_number_of_threads() {
        let units: Vec<usize> = (0..1000).map(|k| k * k % 17).collect();
        let run = |threads, tried| {
            let work = if tried == 100 { 30 } else { u64::MAX };
            let limit = Spent { tried, work };
            let blocks = Blocks {
                units: units.len(),
                size: 7,
                threads,
            };
            blocks.run(
                limit,
                || (),
                |(), range| units[range].to_vec(),
                |found: &Vec<usize>| Spent {
                    tried: found.iter().sum(),
                    work: found.len() as u64,
                },
            )
        };
        assert_eq!(run(1, usize::MAX).concat(), units);
        for limit in [0, 1, 100, 5000, usize::MAX] {
            let one = run(1, limit);
            assert_eq!(one, run(2, limit));
            assert_eq!(one, run(5, limit));
        }
        assert!(run(3, 0).is_empty());
    }
}
