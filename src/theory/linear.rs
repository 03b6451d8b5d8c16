//! Systems of linear equations over a field, by elimination with the smallest pivot.
//!
//! Over rational functions the cost is decided by the size of the pivots (Markowitz 1957 for
//! sparsity); the rule is deterministic: smallest size, then fewest nonzero entries in its row,
//! then first. Where no order of elimination keeps the elements small, it ends at a limit.

use crate::domain::Domain;
use crate::matrix::Matrix;

/// What a linear system has for a solution.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Solution<E> {
    /// Exactly one; with the nonzero product of the pivots. For a square system that product is
    /// the determinant up to sign, and its vanishing is where uniqueness is lost.
    Unique {
        /// The unknowns.
        values: Vec<E>,
        /// The product of the pivots.
        pivots: Vec<E>,
    },
    /// More than one.
    Underdetermined,
    /// None.
    Inconsistent,
    /// The elements grew beyond the limit.
    TooLarge,
}

/// The most that elements may grow: the terms of one, and the products of two operands' sizes in all.
const LARGEST_ELEMENT: usize = 500;
const LARGEST_WORK: usize = 250_000;

/// What an elimination has spent.
struct Spent(usize);

impl Spent {
    /// Whether `left` and `right` are still to be multiplied or divided.
    fn admits<D: Domain>(&mut self, field: &D, left: &D::Element, right: &D::Element) -> bool {
        let (left, right) = (field.size(left), field.size(right));
        self.0 = self.0.saturating_add(left.saturating_mul(right));
        left.max(right) <= LARGEST_ELEMENT && self.0 <= LARGEST_WORK
    }
}

/// Solves `matrix x = right` for x; the system may have more equations than unknowns.
///
/// # Panics
/// When `right` has not one entry for each row: a programming error.
pub fn solve<D: Domain>(
    field: &D,
    matrix: Matrix<D::Element>,
    right: Vec<D::Element>,
) -> Solution<D::Element> {
    assert_eq!(matrix.rows(), right.len(), "one right-hand side per row");
    let (m, n) = matrix.shape();
    let mut rows: Vec<Vec<D::Element>> = right
        .into_iter()
        .enumerate()
        .map(|(i, r)| (0..n).map(|j| matrix[(i, j)].clone()).chain([r]).collect())
        .collect();
    let mut pivot_of_column = vec![None; n];
    let mut used = vec![false; m];
    let mut pivots = Vec::with_capacity(n);
    let mut spent = Spent(0);
    for _ in 0..n {
        let candidate = (0..m)
            .filter(|i| !used[*i])
            .flat_map(|i| (0..n).map(move |j| (i, j)))
            .filter(|&(i, j)| pivot_of_column[j].is_none() && !field.is_zero(&rows[i][j]))
            .min_by_key(|&(i, j)| {
                let in_row = rows[i].iter().filter(|e| !field.is_zero(e)).count();
                let in_column = (0..m)
                    .filter(|k| !used[*k] && !field.is_zero(&rows[*k][j]))
                    .count();
                (
                    (in_row - 1) * (in_column - 1),
                    field.size(&rows[i][j]),
                    i,
                    j,
                )
            });
        let Some((p, j)) = candidate else {
            return Solution::Underdetermined;
        };
        used[p] = true;
        pivot_of_column[j] = Some(p);
        let pivot_row = rows[p].clone();
        let pivot = pivot_row[j].clone();
        for i in (0..m).filter(|i| !used[*i]) {
            if field.is_zero(&rows[i][j]) {
                continue;
            }
            if !spent.admits(field, &rows[i][j], &pivot) {
                return Solution::TooLarge;
            }
            let Some(factor) = field.divide(&rows[i][j], &pivot) else {
                continue;
            };
            for k in 0..=n {
                if k == j {
                    rows[i][k] = field.integer(0);
                } else if !field.is_zero(&pivot_row[k]) {
                    if !spent.admits(field, &factor, &pivot_row[k]) {
                        return Solution::TooLarge;
                    }
                    rows[i][k] =
                        field.subtract(&rows[i][k], &field.multiply(&factor, &pivot_row[k]));
                }
            }
        }
        pivots.push((p, j, pivot));
    }
    if (0..m).any(|i| !used[i] && !field.is_zero(&rows[i][n])) {
        return Solution::Inconsistent;
    }
    let mut values = vec![field.integer(0); n];
    for (p, j, pivot) in pivots.iter().rev() {
        let mut sum = rows[*p][n].clone();
        for k in (0..n).filter(|k| k != j) {
            if !field.is_zero(&rows[*p][k]) {
                if !spent.admits(field, &rows[*p][k], &values[k]) {
                    return Solution::TooLarge;
                }
                sum = field.subtract(&sum, &field.multiply(&rows[*p][k], &values[k]));
            }
        }
        if !spent.admits(field, &sum, pivot) {
            return Solution::TooLarge;
        }
        values[*j] = field
            .divide(&sum, pivot)
            .unwrap_or_else(|| field.integer(0));
    }
    Solution::Unique {
        values,
        pivots: pivots.into_iter().map(|(_, _, pivot)| pivot).collect(),
    }
}

/// The determinant of a square matrix by elimination.
pub fn eliminate<D: Domain>(field: &D, mut matrix: Matrix<D::Element>) -> D::Element {
    let n = matrix.rows();
    let mut determinant = field.integer(1);
    for k in 0..n {
        let pivot_row = (k..n)
            .filter(|i| !field.is_zero(&matrix[(*i, k)]))
            .min_by_key(|i| (field.size(&matrix[(*i, k)]), *i));
        let Some(p) = pivot_row else {
            return field.integer(0);
        };
        if p != k {
            for j in 0..n {
                let (upper, lower) = (matrix[(k, j)].clone(), matrix[(p, j)].clone());
                matrix[(k, j)] = lower;
                matrix[(p, j)] = upper;
            }
            determinant = field.negate(&determinant);
        }
        let pivot = matrix[(k, k)].clone();
        determinant = field.multiply(&determinant, &pivot);
        for i in k + 1..n {
            let Some(factor) = field
                .divide(&matrix[(i, k)], &pivot)
                .filter(|f| !field.is_zero(f))
            else {
                continue;
            };
            for j in k..n {
                matrix[(i, j)] =
                    field.subtract(&matrix[(i, j)], &field.multiply(&factor, &matrix[(k, j)]));
            }
        }
    }
    determinant
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::domain::{Domain, Rationals};
    use num_rational::BigRational;

    fn q(v: i64) -> BigRational {
        Rationals.integer(v)
    }

    #[test]
    fn unique_under_and_over_determined() {
        let m = |rows: &[&[i64]]| {
            Matrix::from_rows(
                rows.iter()
                    .map(|r| r.iter().map(|v| q(*v)).collect())
                    .collect(),
            )
            .unwrap()
        };
        let over = m(&[&[0, 2], &[3, 0], &[3, 2]]);
        match solve(&Rationals, over.clone(), vec![q(2), q(3), q(5)]) {
            Solution::Unique { values, .. } => assert_eq!(values, vec![q(1), q(1)]),
            other => unreachable!("{other:?}"),
        }
        assert_eq!(
            solve(&Rationals, over, vec![q(2), q(3), q(6)]),
            Solution::Inconsistent
        );
        assert_eq!(
            solve(&Rationals, m(&[&[1, 2], &[2, 4]]), vec![q(1), q(2)]),
            Solution::Underdetermined
        );
        assert_eq!(eliminate(&Rationals, m(&[&[0, 2], &[3, 5]])), q(-6));
    }
}
