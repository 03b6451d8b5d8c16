//! Minors by expansion along columns, each computed once: the minor of the last columns and a set of rows
//! is known by the set, written as a bit mask. There are at most `2^n` of them, for banded and Hurwitz
//! matrices far fewer, and nothing is ever divided (Gentleman, Johnson 1976, recommend it for sparse
//! symbolic matrices).

use crate::budget::Budget;
use crate::error::Error;
use crate::polynomial::Polynomial;
use crate::ring::Ring;
use crate::sum_of_products::SignedProduct;

/// A square matrix that borrows its entries.
pub(crate) struct Cells<'a> {
    pub(crate) ring: Ring,
    pub(crate) size: usize,
    /// Row by row; `None` for zero.
    pub(crate) entries: Vec<Option<&'a Polynomial>>,
}

/// The sets of rows that expansion visits, column by column.
pub(crate) struct Plan {
    /// Entry `k`: the sets of the minors of the columns from `k` on, ascending.
    levels: Vec<Vec<u64>>,
    /// The column from which the wanted minors begin.
    first: usize,
}

impl Plan {
    /// What the minors of the given sets of rows, all of one size, need; `None` beyond `limit` sets or 62
    /// rows.
    pub(crate) fn new(cells: &Cells<'_>, wanted: Vec<u64>, limit: usize) -> Option<Self> {
        let n = cells.size;
        let first = n - wanted.first()?.count_ones() as usize;
        let mut levels = vec![Vec::new(); first];
        let mut count = wanted.len();
        let mut level = wanted;
        level.sort_unstable();
        level.dedup();
        for column in first..n {
            let mut next = Vec::with_capacity(2 * level.len());
            for &rows in &level {
                for row in members(rows) {
                    if cells.entries[row * n + column].is_some() {
                        next.push(rows & !(1 << row));
                    }
                }
            }
            next.sort_unstable();
            next.dedup();
            count += next.len();
            if n > 62 || count > limit {
                return None;
            }
            levels.push(std::mem::replace(&mut level, next));
        }
        levels.push(level);
        Some(Plan { levels, first })
    }

    /// The number of sets.
    pub(crate) fn len(&self) -> usize {
        self.levels.iter().map(Vec::len).sum()
    }

    /// The minors of the wanted sets, ascending by set. From the last column backwards only two columns'
    /// minors are kept.
    pub(crate) fn minors(
        &self,
        cells: &Cells<'_>,
        budget: &Budget,
    ) -> Result<Vec<Polynomial>, Error> {
        let (ring, n) = (cells.ring, cells.size);
        let mut known = vec![Polynomial::one(ring); self.levels[n].len()];
        for column in (self.first..n).rev() {
            let below = &self.levels[column + 1];
            let mut next = Vec::with_capacity(self.levels[column].len());
            let mut summands: Vec<SignedProduct<'_>> = Vec::with_capacity(n);
            for &rows in &self.levels[column] {
                if column + 1 == n {
                    let entry = cells.entries[rows.trailing_zeros() as usize * n + column];
                    next.push(entry.map_or_else(|| Polynomial::zero(ring), Polynomial::clone));
                    continue;
                }
                summands.clear();
                let mut work = 0;
                for (position, row) in members(rows).enumerate() {
                    let Some(entry) = cells.entries[row * n + column] else {
                        continue;
                    };
                    let rest = below
                        .binary_search(&(rows & !(1 << row)))
                        .expect("the plan holds every set that is needed");
                    let minor = &known[rest];
                    if !minor.is_zero() {
                        work += (entry.len() * minor.len()) as u64;
                        summands.push((position % 2 == 1, entry, minor));
                    }
                }
                budget.spend(work)?;
                let minor = Polynomial::signed_sum_of_products(ring, &summands)?;
                budget.check_terms(minor.len())?;
                if budget.bits() < u64::MAX {
                    budget.check_bits(minor.coefficient_bits())?;
                }
                next.push(minor);
            }
            known = next;
        }
        Ok(known)
    }
}

/// The elements of a set, ascending.
fn members(mut set: u64) -> impl Iterator<Item = usize> {
    std::iter::from_fn(move || {
        (set != 0).then(|| {
            let least = set.trailing_zeros() as usize;
            set &= set - 1;
            least
        })
    })
}
