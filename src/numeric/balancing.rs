//! Balancing: a diagonal similarity that makes a row and its column equally large.
//!
//! `D^-1 A D` with powers of two on the diagonal of `D` has the eigenvalues of `A` and no new
//! rounding error, but a smaller norm when the states have very different units (Parlett &
//! Reinsch 1969, *Numer. Math.* 13, 293-304). Sweeps are bounded: a balance that is not yet
//! perfect is still a similarity.

use super::power_of_two_below;
use nalgebra::{DMatrix, DVector};

const SWEEPS: usize = 100;

/// `(D^-1 A D, d)` for an `n x n` matrix with finite entries; `d` is the diagonal of `D`.
pub(crate) fn balance(a: &DMatrix<f64>) -> (DMatrix<f64>, DVector<f64>) {
    let n = a.nrows();
    let mut balanced = a.clone();
    let mut d = DVector::from_element(n, 1.0);
    for _ in 0..SWEEPS {
        let mut changed = false;
        for i in 0..n {
            let (mut column, mut row) = (0.0f64, 0.0f64);
            for j in (0..n).filter(|&j| j != i) {
                column = column.max(balanced[(j, i)].abs());
                row = row.max(balanced[(i, j)].abs());
            }
            if column == 0.0 || row == 0.0 {
                continue;
            }
            // column * f = row / f  =>  f = sqrt(row / column)
            let f = power_of_two_below((row.sqrt() / column.sqrt()) * std::f64::consts::SQRT_2);
            let next = d[i] * f;
            if f == 1.0 || !next.is_normal() {
                continue;
            }
            changed = true;
            d[i] = next;
            for j in (0..n).filter(|&j| j != i) {
                balanced[(j, i)] *= f;
                balanced[(i, j)] /= f;
            }
        }
        if !changed {
            break;
        }
    }
    (balanced, d)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numeric::spectrum::eigenvalues;
    use approx::assert_relative_eq;

    #[test]
    fn a_badly_scaled_matrix_becomes_even_and_keeps_its_eigenvalues() {
        let a = DMatrix::from_row_slice(2, 2, &[-1.0, 1e12, 1e-12, -3.0]);
        let (balanced, d) = balance(&a);
        assert!(balanced.amax() <= 8.0);
        for i in 0..2 {
            for j in 0..2 {
                // powers of two: exact
                assert_eq!(balanced[(i, j)] * d[i] / d[j], a[(i, j)]);
            }
        }
        // (l + 1)(l + 3) = 1
        let mut real: Vec<f64> = eigenvalues(&a).unwrap().iter().map(|l| l.re).collect();
        real.sort_by(f64::total_cmp);
        assert_relative_eq!(real[0], -2.0 - 2f64.sqrt(), max_relative = 1e-14);
        assert_relative_eq!(real[1], -2.0 + 2f64.sqrt(), max_relative = 1e-14);
    }

    #[test]
    fn extreme_entries_end_the_sweeps() {
        for (x, y) in [(1e300, 1e-300), (f64::MAX, f64::MIN_POSITIVE), (0.0, 1.0)] {
            let (balanced, d) = balance(&DMatrix::from_row_slice(2, 2, &[1.0, x, y, 2.0]));
            assert!(balanced.iter().chain(d.iter()).all(|v| v.is_finite()));
        }
    }
}
