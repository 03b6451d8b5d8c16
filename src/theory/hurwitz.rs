//! The Hurwitz matrix of a polynomial (Hurwitz 1895; Gantmacher II, 1959, ch. XV).

use crate::domain::Domain;
use crate::matrix::Matrix;

/// The n x n Hurwitz matrix of lambda^n + a_1 lambda^(n-1) + ... + a_n: the entry in row i,
/// column j (from 1) is a_(2i-j), with a_0 the leading coefficient and a_k = 0 outside 0..n.
///
/// `coefficients` are a_0, ..., a_n; `None` when there are fewer than two.
pub fn hurwitz_matrix<D: Domain>(
    field: &D,
    coefficients: &[D::Element],
) -> Option<Matrix<D::Element>> {
    let n = coefficients.len().checked_sub(1).filter(|n| *n > 0)?;
    Some(Matrix::from_fn(n, n, |i, j| {
        (2 * (i + 1))
            .checked_sub(j + 1)
            .and_then(|k| coefficients.get(k))
            .cloned()
            .unwrap_or_else(|| field.integer(0))
    }))
}
