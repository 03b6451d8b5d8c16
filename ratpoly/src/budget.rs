//! The budget of a computation: limits on terms, coefficient bits and elementary steps.

use crate::allowance;
use crate::error::{Error, Resource};
use std::sync::atomic::{AtomicU64, Ordering};

/// Limits on what a computation may use. Steps are counted across all calls that share the budget;
/// terms and bits limit each polynomial that arises.
///
/// A budget is passed by reference. A step is about one product of two coefficients of a word or two; longer
/// ones count as many as there are products of words, by twos.
#[derive(Debug)]
pub struct Budget {
    terms: usize,
    bits: u64,
    steps: u64,
    spent: AtomicU64,
}

impl Budget {
    /// At most `terms` terms in a polynomial, `bits` bits in a coefficient and `steps` steps in all.
    pub const fn new(terms: usize, bits: u64, steps: u64) -> Self {
        Budget {
            terms,
            bits,
            steps,
            spent: AtomicU64::new(0),
        }
    }

    /// No limit at all.
    pub const fn unlimited() -> Self {
        Budget::new(usize::MAX, u64::MAX, u64::MAX)
    }

    /// The limit on the terms of one polynomial.
    pub fn terms(&self) -> usize {
        self.terms
    }

    /// The limit on the bits of one coefficient.
    pub fn bits(&self) -> u64 {
        self.bits
    }

    /// The limit on the steps of the whole computation.
    pub fn steps(&self) -> u64 {
        self.steps
    }

    /// The steps spent so far.
    pub fn spent(&self) -> u64 {
        self.spent.load(Ordering::Relaxed)
    }

    /// The steps of `count` products of integers of so many bits.
    pub(crate) fn products(count: u64, bits: u64, other_bits: u64) -> u64 {
        let words = |bits: u64| 1 + bits / 64;
        let each = words(bits).saturating_mul(words(other_bits)).div_ceil(2);
        count.saturating_mul(each)
    }

    /// Counts `steps` more steps.
    pub fn spend(&self, steps: u64) -> Result<(), Error> {
        allowance::spend(steps);
        if self.steps == u64::MAX {
            return Ok(());
        }
        // Saturating, so that what is spent once stays spent.
        let before = self
            .spent
            .fetch_update(Ordering::Relaxed, Ordering::Relaxed, |spent| {
                Some(spent.saturating_add(steps))
            })
            .unwrap_or_else(|spent| spent);
        if before.saturating_add(steps) > self.steps {
            return Err(Error::BudgetExceeded(Resource::Steps));
        }
        Ok(())
    }

    /// Refuses a polynomial of `terms` terms if that is too many.
    pub fn check_terms(&self, terms: usize) -> Result<(), Error> {
        if terms > self.terms {
            return Err(Error::BudgetExceeded(Resource::Terms));
        }
        Ok(())
    }

    /// Refuses a coefficient of `bits` bits if that is too many.
    pub fn check_bits(&self, bits: u64) -> Result<(), Error> {
        if bits > self.bits {
            return Err(Error::BudgetExceeded(Resource::Bits));
        }
        Ok(())
    }
}

impl Default for Budget {
    /// What a desktop machine does in seconds: a million terms, a million bits, 10^10 steps.
    fn default() -> Self {
        Budget::new(1_000_000, 1_000_000, 10_000_000_000)
    }
}

impl Clone for Budget {
    /// The same limits with the steps spent so far.
    fn clone(&self) -> Self {
        Budget {
            spent: AtomicU64::new(self.spent()),
            ..*self
        }
    }
}
