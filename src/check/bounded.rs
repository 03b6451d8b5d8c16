//! What a link, a statement or a definition may cost, and what becomes of it where it costs more.
//!
//! The exact engine counts its steps against an [`allowance`] and ends in the middle of an operation where they
//! are spent, where one polynomial would take too much memory, or where the user wants to stop. The checker is
//! then put back to where it was before: nothing of what was cut short is kept, the link is undecided and says
//! why, and the next one begins with an allowance of its own. A document has steps in all besides; once they
//! are spent each link gets a small allowance only, so that many dear links end too. Steps are counted,
//! so that the same document has the same verdicts everywhere.

use super::Checker;
use crate::progress::interrupted;
use ratpoly::allowance::{self, Allowance, Exhausted};
use std::sync::Arc;

/// The most steps of one stage of a link: its proof, a second route, the search for a correction.
const STEPS: u64 = 250_000_000;
/// What all stages of a link together may take: so many fifths of one.
const STAGES: u64 = 6;
/// The least, however much the others have cost.
const FEWEST_STEPS: u64 = 5_000_000;
/// The steps of a document, of which each takes its own.
const DOCUMENT_STEPS: u64 = 1_000_000_000;
/// How many steps of the engine a step of a search stands for, and some more for what passes: where the
/// engine is asked for functions, and where it is not.
const SEARCH: [u64; 2] = [18, 8];
/// The bytes of one polynomial.
pub(super) const BYTES: usize = 32 << 20;

/// What the stages around the links of a document may cost.
pub(crate) const WHOLE: Allowance = Allowance {
    steps: 20 * DOCUMENT_STEPS,
    // What its links keep is its own.
    bytes: 2 * BYTES,
};

/// The steps that a document has left.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Pool {
    steps: u64,
    /// Whether they were fewer than a stage may take when the last computation began.
    scarce: bool,
    /// Whether a computation of a link is under way, of which others are parts.
    in_use: bool,
}

impl Default for Pool {
    fn default() -> Self {
        Pool {
            steps: DOCUMENT_STEPS,
            scarce: false,
            in_use: false,
        }
    }
}

impl Pool {
    /// The same for one of so many instances, which share it.
    pub(crate) fn of_one_in(instances: usize) -> Self {
        Pool {
            steps: DOCUMENT_STEPS / instances.max(1) as u64,
            ..Pool::default()
        }
    }
}

/// What was too large, in words.
pub(crate) fn words(exhausted: Exhausted) -> &'static str {
    match exhausted {
        Exhausted::Steps => "too many steps of the exact engine",
        Exhausted::Memory => "too many terms: a polynomial would take too much memory",
        Exhausted::Interrupted => "interrupted",
    }
}

impl Checker<'_> {
    /// What was too large, in words: where the links before have left few steps of the document's, it may be
    /// that alone.
    pub(super) fn words_of_exhaustion(&self, exhausted: Exhausted) -> &'static str {
        match exhausted {
            Exhausted::Steps if self.pool.scarce => {
                "too many steps of the exact engine for what other links or sizes have left of the document's"
            }
            Exhausted::Steps | Exhausted::Memory | Exhausted::Interrupted => words(exhausted),
        }
    }

    /// The steps that a search may take of what the options allow: it ends by itself before the
    /// allowance of its stage does.
    pub(super) fn work_of_a_search(&self) -> u64 {
        let [asked, not_asked] = SEARCH;
        let each = match self.model.functions {
            Some(_) => asked,
            None => not_asked,
        };
        self.options.work.min(self.allowance().steps / each)
    }

    /// What the next computation may cost: a part has no more than the whole has left.
    pub(super) fn allowance(&self) -> Allowance {
        let own = self.pool.steps.clamp(FEWEST_STEPS, STEPS);
        Allowance {
            steps: own.min(allowance::steps_left()),
            bytes: BYTES,
        }
    }

    /// Runs `work` under the allowance of one stage. Where it is cut short the checker is as before.
    ///
    /// # Errors
    /// What ran out.
    pub(crate) fn bounded<T>(&mut self, work: impl FnOnce(&mut Self) -> T) -> Result<T, Exhausted> {
        self.bounded_by(5, work)
    }

    /// The same for all stages of a link together, or of what costs as much.
    ///
    /// # Errors
    /// What ran out.
    pub(crate) fn bounded_in_all<T>(
        &mut self,
        work: impl FnOnce(&mut Self) -> T,
    ) -> Result<T, Exhausted> {
        self.bounded_by(STAGES, work)
    }

    fn bounded_by<T>(
        &mut self,
        fifths: u64,
        work: impl FnOnce(&mut Self) -> T,
    ) -> Result<T, Exhausted> {
        if interrupted() {
            return Err(Exhausted::Interrupted);
        }
        let nested = std::mem::replace(&mut self.pool.in_use, true);
        if !nested {
            self.pool.scarce = self.pool.steps < STEPS;
        }
        let mut allowed = self.allowance();
        let whole = allowance::steps_left();
        allowed.steps = (allowed.steps / 5 * fifths).min(whole);
        let world = self.exact.world().clone();
        let inserted = Arc::clone(&self.inserted);
        let supposed = Arc::clone(&self.supposed);
        let options = self.options;
        let noted = self.diagnostics.len();
        let found = allowance::within(allowed, || work(self));
        self.pool.in_use = nested;
        if !nested {
            let spent = whole.saturating_sub(allowance::steps_left());
            self.pool.steps = self.pool.steps.saturating_sub(spent);
        }
        match found {
            Ok(result) => Ok(result),
            Err(exhausted) => {
                self.exact = self.exact.in_world(world);
                self.inserted = inserted;
                self.supposed = supposed;
                self.options = options;
                self.diagnostics.truncate(noted);
                self.failure = None;
                Err(exhausted)
            }
        }
    }
}
