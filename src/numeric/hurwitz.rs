//! The Hurwitz matrix in floating point and the Hurwitz formula for a variance.
//!
//! For `dx/dt = A x + w`, `w` white with intensity `Q`, the output `y = c^T x` has the variance
//!
//! ```text
//! (1 / 2 pi) Int c^T F(i w) Q F(-i w)^T c dw,   F(s) = adj(s E - A) / det(s E - A),
//! ```
//!
//! the integral of an even rational function `g(s) / (h(s) h(-s))`, which the coefficients give
//! without integration (Hurwitz 1895, *Math. Ann.* 46, 273-284; James, Nichols & Phillips, *Theory
//! of Servomechanisms*, 1947, section 7.9). With `H_ij = a_{2i-j}` and `g = sum g_k s^{2(n-1-k)}` up to the
//! sign that makes `g_0 >= 0`, the variance is `(1/2) sum z_k g_k`, where `H^T z = e_1`.

use super::characteristic::{Characteristic, faddeev_leverrier};
use super::linear::{determinant, solve};
use super::{NumericError, cost, order_of_lyapunov};
use nalgebra::{DMatrix, DVector};

/// The `n x n` Hurwitz matrix `H_ij = a_{2i-j}` (`i, j` from 1) of `a_0, ..., a_n`.
pub fn hurwitz_matrix(coefficients: &[f64]) -> DMatrix<f64> {
    let n = coefficients.len().saturating_sub(1);
    DMatrix::from_fn(n, n, |i, j| {
        (2 * (i + 1))
            .checked_sub(j + 1)
            .and_then(|k| coefficients.get(k))
            .copied()
            .unwrap_or(0.0)
    })
}

/// The leading principal minors `H_1, ..., H_n` of an `n x n` matrix by LU, about `n^4 / 6` operations.
pub fn leading_minors(h: &DMatrix<f64>) -> Result<Vec<f64>, NumericError> {
    (1..=h.nrows().min(h.ncols()))
        .map(|k| determinant(&h.view((0, 0), (k, k)).into_owned()))
        .collect()
}

/// The first row of the inverse Hurwitz matrix, `z_k = H_{k+1,1} / det H`, with `a_0 > 0`.
pub(crate) fn first_row_of_inverse(coefficients: &[f64]) -> Result<DVector<f64>, NumericError> {
    let n = coefficients.len() - 1;
    let first = DMatrix::from_fn(n, 1, |i, _| if i == 0 { 1.0 } else { 0.0 });
    let z = solve(&hurwitz_matrix(coefficients).transpose(), &first)?;
    Ok(DVector::from_column_slice(z.as_slice()))
}

/// A variance and what it cost.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Variance {
    /// The variance.
    pub value: f64,
    /// Floating-point operations.
    pub operations: u64,
}

/// The stationary variance of `c^T x` for `dx/dt = A x + w`, `w` white with intensity `Q`, by the
/// Hurwitz formula; `A` and `Q` are `n x n`, `c` has `n` entries; about `2 n^4` operations.
///
/// Unless all leading minors of the Hurwitz matrix are positive there is no stationary
/// covariance: [`NumericError::Unstable`].
pub fn variance(
    a: &DMatrix<f64>,
    q: &DMatrix<f64>,
    c: &DVector<f64>,
) -> Result<Variance, NumericError> {
    let n = order_of_lyapunov(a, q)?;
    if c.len() != n {
        return Err(NumericError::Shape {
            expected: (n, 1),
            found: (c.len(), 1),
        });
    }
    let Characteristic {
        coefficients,
        auxiliary,
        operations,
    } = faddeev_leverrier(a)?;
    let minors = leading_minors(&hurwitz_matrix(&coefficients))?;
    if minors.iter().any(|minor| minor.is_nan() || *minor <= 0.0) {
        return Err(NumericError::Unstable);
    }
    let z = first_row_of_inverse(&coefficients)?;
    // Rows c^T A_m and c^T A_m Q: g_k = sum over m of (-1)^m (c^T A_m) Q (c^T A_{2k-m})^T.
    let rows: Vec<DVector<f64>> = auxiliary.iter().map(|m| m.tr_mul(c)).collect();
    let weighted: Vec<DVector<f64>> = rows.iter().map(|row| q * row).collect();
    let mut value = 0.0;
    for k in 0..n {
        let mut g = 0.0;
        for m in 0..=2 * k {
            if m < n && 2 * k - m < n {
                let term = weighted[m].dot(&rows[2 * k - m]);
                g += if m % 2 == 0 { term } else { -term };
            }
        }
        value += z[k] * g;
    }
    let dots = (n * n) as u64 * n as u64;
    Ok(Variance {
        value: 0.5 * value,
        operations: operations
            + cost::lu(n) * 2
            + cost::triangular_solves(n, 1)
            + 2 * (n as u64) * cost::product(n, n, 1)
            + dots,
    })
}

/// The characteristic coefficients with [`first_row_of_inverse`], for [`super::kreisselmeier`].
pub(crate) fn characteristic_of(
    a: &DMatrix<f64>,
) -> Result<(Characteristic, DVector<f64>), NumericError> {
    let characteristic = faddeev_leverrier(a)?;
    let z = first_row_of_inverse(&characteristic.coefficients)?;
    Ok((characteristic, z))
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    #[test]
    fn hurwitz_matrix_of_order_four_as_printed_in_textbooks() {
        let h = hurwitz_matrix(&[1.0, 2.0, 3.0, 4.0, 5.0]);
        #[rustfmt::skip]
        let printed = DMatrix::from_row_slice(4, 4, &[
            2.0, 1.0, 0.0, 0.0,
            4.0, 3.0, 2.0, 1.0,
            0.0, 5.0, 4.0, 3.0,
            0.0, 0.0, 0.0, 5.0,
        ]);
        assert_eq!(h, printed);
        assert_eq!(hurwitz_matrix(&[1.0]).shape(), (0, 0));
        assert_eq!(leading_minors(&h).unwrap()[0], 2.0);
    }

    #[test]
    fn an_unstable_system_has_no_variance() {
        let q = DMatrix::identity(2, 2);
        let c = DVector::from_element(2, 1.0);
        for entries in [[0.0, 1.0, 1.0, -1.0], [0.0, 1.0, -1.0, 0.0], [0.0; 4]] {
            let a = DMatrix::from_row_slice(2, 2, &entries);
            assert_eq!(variance(&a, &q, &c), Err(NumericError::Unstable));
        }
        let short = DVector::from_element(1, 1.0);
        assert!(matches!(
            variance(&-DMatrix::identity(2, 2), &q, &short),
            Err(NumericError::Shape { .. })
        ));
    }

    #[test]
    fn first_order_noise() {
        // dx/dt = -alpha x + w: sigma^2 = q / (2 alpha)
        let a = DMatrix::from_element(1, 1, -0.25);
        let q = DMatrix::from_element(1, 1, 3.0);
        let c = DVector::from_element(1, 2.0);
        assert_relative_eq!(
            variance(&a, &q, &c).unwrap().value,
            24.0,
            max_relative = 1e-15
        );
    }
}
