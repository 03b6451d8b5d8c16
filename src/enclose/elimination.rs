//! Determinants, inverses, linear systems and characteristic polynomials of enclosed matrices.
//!
//! Gauss elimination whose pivots certainly differ from zero: then every step is an equivalence, and
//! the enclosures contain the solutions for all matrices within (A. Neumaier, *Interval Methods for
//! Systems of Equations*, 1990, chapter 4). Where no pivot is certain there is no result, unless a column
//! certainly vanishes.

use super::apply::Truth;
use super::arithmetic::Arithmetic;
use super::failure::{Reason, Undefined};
use super::jet::{Jet, Result};
use super::value::identity;
use crate::expr::Relation;
use crate::matrix::Matrix;
use crate::real::Real;
use crate::real::dyadic::Dyadic;
use num_rational::BigRational;

/// What a column offers as its pivot.
enum Pivot {
    Row(usize),
    /// Every entry certainly is zero.
    None,
    /// Some entry may be zero or not.
    Unknown,
}

fn pivot(rows: &[Vec<Jet>], column: usize, from: usize) -> Pivot {
    let mut best: Option<(usize, Dyadic)> = None;
    let mut zeros = true;
    for (i, row) in rows.iter().enumerate().skip(from) {
        let z = row[column].number();
        zeros &= row[column].is_zero();
        if z.may_vanish() {
            continue;
        }
        let size = |x: &Real| x.interval(64).smallest();
        let weight = size(&z.re).max(size(&z.im));
        if best.as_ref().is_none_or(|(_, other)| weight > *other) {
            best = Some((i, weight));
        }
    }
    match best {
        Some((row, _)) => Pivot::Row(row),
        None if zeros => Pivot::None,
        None => Pivot::Unknown,
    }
}

impl Arithmetic {
    /// Subtracts multiples of row `k` from those below it, so that column `column` vanishes there.
    fn eliminate(&self, rows: &mut [Vec<Jet>], k: usize, column: usize) -> Result<()> {
        let (done, open) = rows.split_at_mut(k + 1);
        let top = &done[k];
        for row in open {
            if row[column].is_zero() {
                continue;
            }
            let factor = self.divide(&row[column], &top[column])?;
            row[column] = Jet::zero();
            for j in column + 1..row.len() {
                let product = self.multiply(&factor, &top[j])?;
                row[j] = self.subtract(&row[j], &product);
            }
        }
        Ok(())
    }

    /// The determinant. Where pivots are not certain, by minors of the first row if that is small.
    pub(super) fn determinant(&self, m: &Matrix<Jet>) -> Result<Jet> {
        let n = m.rows();
        if n <= 3 {
            return self.by_minors(m);
        }
        let mut rows = rows_of(m);
        let mut product = Jet::integer(1);
        for k in 0..n {
            match pivot(&rows, k, k) {
                Pivot::Row(row) => {
                    if row != k {
                        rows.swap(row, k);
                        product = product.negated();
                    }
                }
                Pivot::None => return Ok(Jet::zero()),
                Pivot::Unknown if n <= 6 => return self.by_minors(m),
                Pivot::Unknown => return Err(Reason::Imprecise(Undefined::Singular)),
            }
            self.eliminate(&mut rows, k, k)?;
            product = self.multiply(&product, &rows[k][k])?;
        }
        Ok(product)
    }

    /// Laplace's expansion.
    fn by_minors(&self, m: &Matrix<Jet>) -> Result<Jet> {
        if m.rows() == 1 {
            return Ok(m[(0, 0)].clone());
        }
        let mut sum = Jet::zero();
        for j in 0..m.columns() {
            if m[(0, j)].is_zero() {
                continue;
            }
            let Some(rest) = m.without(0, j) else {
                continue;
            };
            let term = self.multiply(&m[(0, j)], &self.by_minors(&rest)?)?;
            sum = if j % 2 == 0 {
                self.add(&sum, &term)
            } else {
                self.subtract(&sum, &term)
            };
        }
        Ok(sum)
    }

    /// The one solution of `matrix x = right` for each column of `right`; there may be more equations
    /// than unknowns.
    pub(super) fn solve(&self, matrix: &Matrix<Jet>, right: &Matrix<Jet>) -> Result<Matrix<Jet>> {
        let n = matrix.columns();
        let width = n + right.columns();
        let mut rows: Vec<Vec<Jet>> = (0..matrix.rows())
            .map(|i| {
                let left = (0..n).map(|j| matrix[(i, j)].clone());
                left.chain((0..right.columns()).map(|j| right[(i, j)].clone()))
                    .collect()
            })
            .collect();
        for k in 0..n {
            match pivot(&rows, k, k) {
                Pivot::Row(row) => rows.swap(row, k),
                Pivot::None => return Err(Reason::Undefined(Undefined::Singular)),
                Pivot::Unknown => return Err(Reason::Imprecise(Undefined::Singular)),
            }
            self.eliminate(&mut rows, k, k)?;
        }
        // What is left of further equations must say nothing.
        for entry in rows[n..].iter().flat_map(|row| &row[n..]) {
            if !entry.number().may_vanish() {
                return Err(Reason::Undefined(Undefined::Singular));
            }
            if !entry.is_zero() {
                return Err(Reason::Imprecise(Undefined::Singular));
            }
        }
        for k in (0..n).rev() {
            for c in n..width {
                let mut rest = rows[k][c].clone();
                for j in k + 1..n {
                    let product = self.multiply(&rows[k][j], &rows[j][c])?;
                    rest = self.subtract(&rest, &product);
                }
                rows[k][c] = self.divide(&rest, &rows[k][k])?;
            }
        }
        Ok(Matrix::from_fn(n, right.columns(), |i, j| {
            rows[i][n + j].clone()
        }))
    }

    /// The inverse of a square matrix.
    pub(super) fn inverse(&self, m: &Matrix<Jet>) -> Result<Matrix<Jet>> {
        if !m.is_square() {
            return Err(Reason::Shape {
                operation: "inverse",
                left: Some(m.shape()),
                right: Some(m.shape()),
            });
        }
        self.solve(m, &identity(m.rows()))
    }

    /// The coefficients of det(x E - A), the leading one first (U. Le Verrier 1840, D. K. Faddeev &
    /// I. S. Sominsky 1949): `M_k = A M_(k-1) + c_(k-1) E`, `c_k = -tr(A M_k) / k`.
    pub(super) fn characteristic_coefficients(&self, a: &Matrix<Jet>) -> Result<Vec<Jet>> {
        let n = a.rows();
        let mut coefficients = vec![Jet::integer(1)];
        let mut m = identity(n);
        for k in 1..=n {
            let product = self.matrix_product(a, &m)?;
            let denominator = BigRational::new((-1).into(), k.into());
            let factor = Jet::from(Real::rational(denominator));
            let c = self.multiply(&self.trace(&product), &factor)?;
            m = Matrix::from_fn(n, n, |i, j| {
                if i == j {
                    self.add(&product[(i, j)], &c)
                } else {
                    product[(i, j)].clone()
                }
            });
            coefficients.push(c);
        }
        Ok(coefficients)
    }

    /// The matrix of a polynomial's coefficients with entries a_(2i-j), i and j from 1.
    pub(super) fn hurwitz_matrix(coefficients: &[Jet]) -> Option<Matrix<Jet>> {
        let n = coefficients.len().checked_sub(1).filter(|n| *n > 0)?;
        Some(Matrix::from_fn(n, n, |i, j| {
            (2 * (i + 1))
                .checked_sub(j + 1)
                .and_then(|k| coefficients.get(k).cloned())
                .unwrap_or_else(Jet::zero)
        }))
    }
}

fn rows_of(m: &Matrix<Jet>) -> Vec<Vec<Jet>> {
    (0..m.rows())
        .map(|i| (0..m.columns()).map(|j| m[(i, j)].clone()).collect())
        .collect()
}

/// Whether a symmetric matrix is positive definite (`strict`) or semidefinite, by the pivots of its
/// elimination along the diagonal: those of a positive definite matrix are positive, and a negative
/// pivot, or a zero one beside an entry that is not zero, shows a vector on which the form is negative
/// (G. H. Golub & C. F. Van Loan, *Matrix Computations*, section 4.2).
pub(super) fn definite(arithmetic: &Arithmetic, m: &Matrix<Jet>, strict: bool) -> Truth {
    let mut rows = rows_of(m);
    let mut all = Truth::True;
    for k in 0..rows.len() {
        let number = rows[k][k].number().clone();
        if !number.is_real() {
            return Truth::Unknown;
        }
        let zero = Jet::zero();
        if arithmetic.related(&rows[k][k], Relation::Less, &zero) == Truth::True {
            return Truth::False;
        }
        if number.is_zero() {
            if strict || rows[k][k + 1..].iter().any(|e| !e.number().may_vanish()) {
                return Truth::False;
            }
            // The row must vanish for the rest to be decided.
            if rows[k][k + 1..].iter().any(|e| !e.is_zero()) {
                return Truth::Unknown;
            }
            continue;
        }
        if arithmetic.related(&rows[k][k], Relation::LessEqual, &zero) == Truth::True && strict {
            return Truth::False;
        }
        if number.may_vanish() {
            return Truth::Unknown;
        }
        if arithmetic.eliminate(&mut rows, k, k).is_err() {
            all = Truth::Unknown;
            break;
        }
    }
    all
}
