//! Fraction-free elimination (Bareiss 1968): every division is exact, every intermediate entry is a minor.

use super::Matrix;
use crate::budget::Budget;
use crate::error::Error;
use crate::polynomial::Polynomial;

/// The determinant by one-step fraction-free elimination.
pub(crate) fn determinant(
    matrix: &Matrix<Polynomial>,
    budget: &Budget,
) -> Result<Polynomial, Error> {
    let mut work = matrix.clone();
    let n = work.rows;
    let mut previous = Polynomial::one(work.ring);
    let mut negative = false;
    for k in 0..n {
        let Some(pivot) = choose_pivot(&work, k) else {
            return Ok(Polynomial::zero(work.ring));
        };
        negative ^= work.swap_rows(k, pivot);
        for i in k + 1..n {
            work.eliminate(i, k, k + 1, &previous, budget)?;
        }
        previous = work[(k, k)].clone();
    }
    Ok(if negative { -previous } else { previous })
}

/// The pivot of column `k` at or below the diagonal: the one of the fewest terms, the first of these.
fn choose_pivot(work: &Matrix<Polynomial>, k: usize) -> Option<usize> {
    (k..work.rows)
        .filter(|&i| !work[(i, k)].is_zero())
        .min_by_key(|&i| work[(i, k)].len())
}

impl Matrix<Polynomial> {
    /// The solution of `self X = right` as numerators `N` over one denominator `d`: `self N = d right`
    /// with `d` the determinant of `self` up to its sign. [`Error::SingularMatrix`] if that is zero.
    pub fn solve(
        &self,
        right: &Matrix<Polynomial>,
        budget: &Budget,
    ) -> Result<(Matrix<Polynomial>, Polynomial), Error> {
        let n = self.check_square()?;
        self.check_product(right)?;
        let mut work = Matrix::build(self.ring, (n, n + right.columns), |i, j| {
            match j.checked_sub(n) {
                None => self[(i, j)].clone(),
                Some(j) => right[(i, j)].clone(),
            }
        });
        let mut previous = Polynomial::one(self.ring);
        for k in 0..n {
            let pivot = choose_pivot(&work, k).ok_or(Error::SingularMatrix)?;
            work.swap_rows(k, pivot);
            // Below and above the diagonal (Gauss-Jordan): then all pivots become the determinant.
            for i in (0..n).filter(|&i| i != k) {
                work.eliminate(i, k, k + 1, &previous, budget)?;
            }
            previous = work[(k, k)].clone();
        }
        let solution = Matrix::build(self.ring, (n, right.columns), |i, j| {
            work[(i, n + j)].clone()
        });
        Ok((solution, previous))
    }

    /// The rank over the field of rational functions.
    pub fn rank(&self, budget: &Budget) -> Result<usize, Error> {
        let mut work = self.clone();
        let mut previous = Polynomial::one(self.ring);
        let mut rank = 0;
        for column in 0..self.columns {
            let candidates = (rank..self.rows).filter(|&i| !work[(i, column)].is_zero());
            let Some(pivot) = candidates.min_by_key(|&i| work[(i, column)].len()) else {
                continue;
            };
            work.swap_rows(rank, pivot);
            let top = work[(rank, column)].clone();
            for i in rank + 1..self.rows {
                let factor = work[(i, column)].clone();
                for j in column + 1..self.columns {
                    let value = cross(&top, &work[(i, j)], &factor, &work[(rank, j)], budget)?;
                    work.entries[i * self.columns + j] = exact(&value, &previous);
                }
            }
            previous = top;
            rank += 1;
        }
        Ok(rank)
    }

    /// Row `i` becomes `(pivot row i - entry row k) / previous` from a column on; the entry itself vanishes.
    fn eliminate(
        &mut self,
        i: usize,
        k: usize,
        from: usize,
        previous: &Polynomial,
        budget: &Budget,
    ) -> Result<(), Error> {
        let factor = self[(i, k)].clone();
        let pivot = self[(k, k)].clone();
        for j in from..self.columns {
            let value = cross(&pivot, &self[(i, j)], &factor, &self[(k, j)], budget)?;
            self.entries[i * self.columns + j] = exact(&value, previous);
        }
        if i < k {
            // In rows above, the diagonal entry follows the pivots.
            self.entries[i * self.columns + i] = pivot;
        }
        Ok(())
    }

    fn swap_rows(&mut self, i: usize, j: usize) -> bool {
        if i == j {
            return false;
        }
        for column in 0..self.columns {
            self.entries
                .swap(i * self.columns + column, j * self.columns + column);
        }
        true
    }
}

/// `a b - c d`.
fn cross(
    a: &Polynomial,
    b: &Polynomial,
    c: &Polynomial,
    d: &Polynomial,
    budget: &Budget,
) -> Result<Polynomial, Error> {
    a.mul_within(b, budget)?.try_sub(&c.mul_within(d, budget)?)
}

fn exact(f: &Polynomial, divisor: &Polynomial) -> Polynomial {
    if divisor.is_one() {
        return f.clone();
    }
    f.div_exact(divisor).expect("exact by Sylvester's identity")
}
