//! The Lyapunov equation by a finite sum with the characteristic coefficients (Kreisselmeier 1972,
//! *SIAM J. Appl. Math.* 23, 334-338; in the matrix-polynomial form of Mueller & Schiehlen 1985,
//! *Linear Vibrations*).
//!
//! The solution of `A X + X A^T + Q = 0` is a combination of the products `A_i Q A_j^T`, where
//! `adj(s E - A) = sum A_m s^{n-1-m}`:
//!
//! ```text
//! X = (1/2) sum_k z_k sum_m (-1)^m A_m Q A_{2k-m}^T,   k = 0..n-1, m = 0..2k,   H^T z = e_1,
//! ```
//!
//! with the Hurwitz matrix `H`: only an `n x n` system is solved, where Kronecker's has order `n^2`.
//! The `z_k` are the cofactors `H_{k+1,1} / det H`, found here without a determinant.

use super::hurwitz::characteristic_of;
use super::{NumericError, Solution, cost, finite, order_of_lyapunov, symmetrised};
use nalgebra::DMatrix;

/// The symmetric solution `X` of `A X + X A^T + Q = 0`; all matrices `n x n`, `Q` symmetric.
///
/// About `7 n^4` operations. [`NumericError::Singular`] when two eigenvalues of `A` have the sum
/// zero to working precision; stability is not needed. The accuracy is that of the
/// Faddeev-LeVerrier recursion, see [`super::characteristic`].
pub fn lyapunov(a: &DMatrix<f64>, q: &DMatrix<f64>) -> Result<Solution, NumericError> {
    let n = order_of_lyapunov(a, q)?;
    let (characteristic, z) = characteristic_of(a)?;
    let auxiliary = &characteristic.auxiliary;
    let mut sum = DMatrix::zeros(n, n);
    for m in 0..n {
        // The partners of A_m: sum over k of z_k A_{2k-m}.
        let mut partner = DMatrix::zeros(n, n);
        for k in m.div_ceil(2)..n {
            if let Some(other) = auxiliary.get(2 * k - m) {
                partner += other * z[k];
            }
        }
        let term = &auxiliary[m] * q * partner.transpose();
        if m % 2 == 0 {
            sum += term;
        } else {
            sum -= term;
        }
    }
    let matrix = symmetrised(&sum) * 0.5;
    finite(&matrix)?;
    let order = n as u64;
    let operations = characteristic.operations
        + cost::lu(n)
        + cost::triangular_solves(n, 1)
        + order * 2 * cost::product(n, n, n)
        + order * order * order * order;
    Ok(Solution { matrix, operations })
}
