//! Minors by expansion along columns, each computed once: the minor of the last columns and a set of rows
//! is known by the set, written as a bit mask. There are at most `2^n` of them, for banded and Hurwitz
//! matrices far fewer, and nothing is ever divided (Gentleman, Johnson 1976, recommend it for sparse
//! symbolic matrices).

use super::Matrix;
use crate::budget::Budget;
use crate::error::Error;
use crate::polynomial::Polynomial;
use std::collections::HashMap;

/// The minors of a square matrix, found on demand.
pub(crate) struct Minors<'a> {
    matrix: &'a Matrix<Polynomial>,
    /// The entries with the opposite sign.
    negated: Vec<Polynomial>,
    /// By set of rows. Only looked up, never iterated.
    known: HashMap<u64, Polynomial>,
    budget: &'a Budget,
}

impl<'a> Minors<'a> {
    pub(crate) fn new(matrix: &'a Matrix<Polynomial>, budget: &'a Budget) -> Self {
        Minors {
            matrix,
            negated: matrix.entries.iter().map(|entry| -entry).collect(),
            known: HashMap::new(),
            budget,
        }
    }

    /// The minor of a set of rows and as many last columns.
    pub(crate) fn minor(&mut self, rows: u64) -> Result<&Polynomial, Error> {
        if !self.known.contains_key(&rows) {
            let minor = self.expand(rows)?;
            self.known.insert(rows, minor);
        }
        Ok(&self.known[&rows])
    }

    fn expand(&mut self, rows: u64) -> Result<Polynomial, Error> {
        let n = self.matrix.columns;
        let ring = self.matrix.ring;
        if rows == 0 {
            return Ok(Polynomial::one(ring));
        }
        let column = n - rows.count_ones() as usize;
        let mut summands: Vec<(usize, u64)> = Vec::new();
        let members = (0..n).filter(|row| rows >> row & 1 == 1);
        for (position, row) in members.enumerate() {
            let place = row * n + column;
            if !self.matrix.entries[place].is_zero() {
                let rest = rows & !(1 << row);
                if !self.minor(rest)?.is_zero() {
                    // An odd place in the set takes the other sign, which is marked by an offset.
                    summands.push((place + position % 2 * n * n, rest));
                }
            }
        }
        let pairs: Vec<(&Polynomial, &Polynomial)> = summands
            .iter()
            .map(|&(place, rest)| {
                let entry = match place.checked_sub(n * n) {
                    None => &self.matrix.entries[place],
                    Some(place) => &self.negated[place],
                };
                (entry, &self.known[&rest])
            })
            .collect();
        for (f, g) in &pairs {
            self.budget.spend((f.len() as u64) * (g.len() as u64))?;
        }
        let minor = Polynomial::sum_of_products(ring, pairs)?;
        self.budget.check_terms(minor.len())?;
        self.budget.check_bits(minor.coefficient_bits())?;
        Ok(minor)
    }
}

/// The number of sets of rows that expansion along columns visits, or `None` beyond a limit.
pub(crate) fn count_states(matrix: &Matrix<Polynomial>, limit: usize) -> Option<usize> {
    let n = matrix.columns;
    if n > 62 {
        return None;
    }
    let mut level = vec![(1_u64 << n) - 1];
    let mut count = 1;
    for column in 0..n {
        let mut next = Vec::new();
        for rows in level {
            for row in (0..n).filter(|row| rows >> row & 1 == 1) {
                if !matrix.entries[row * n + column].is_zero() {
                    next.push(rows & !(1 << row));
                }
            }
        }
        next.sort_unstable();
        next.dedup();
        count += next.len();
        if count > limit {
            return None;
        }
        level = next;
    }
    Some(count)
}
