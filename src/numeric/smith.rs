//! The Lyapunov equation by Smith's squared iteration (R. A. Smith 1968, *SIAM J. Appl. Math.* 16,
//! 198-201).
//!
//! For any `s > 0` the Cayley transform `C = (s E - A)^-1 (s E + A)` turns `A X + X A^T + Q = 0` into
//! `X = C X C^T + M`, `M = 2 s (s E - A)^-1 Q (s E - A)^-T`. When `A` is stable the powers of `C`
//! vanish and `X` is the sum of `C^k M (C^T)^k`; the step `X <- X + C X C^T, C <- C^2` doubles the
//! number of its terms.

use super::linear::solve;
use super::{NumericError, Solution, cost, finite, order_of_lyapunov, symmetrised};
use nalgebra::DMatrix;

/// Doublings allowed: `2^64` terms settle every `C` whose spectral radius is a double below 1.
const DOUBLINGS: usize = 64;

/// The symmetric solution `X` of `A X + X A^T + Q = 0`; all matrices `n x n`, `Q` symmetric.
///
/// About `(20/3 + 6 k) n^3` operations for `k` doublings; `k` grows like the logarithm of
/// `max |lambda| / min |Re lambda|`. An unstable or undamped `A` is [`NumericError::Unstable`].
pub fn lyapunov(a: &DMatrix<f64>, q: &DMatrix<f64>) -> Result<Solution, NumericError> {
    let n = order_of_lyapunov(a, q)?;
    if n == 0 {
        return Ok(Solution {
            matrix: q.clone(),
            operations: 0,
        });
    }
    let s = shift(a)?;
    let unit = DMatrix::<f64>::identity(n, n);
    // s is no eigenvalue of a stable matrix.
    let unstable = |error: NumericError| {
        if error == NumericError::Singular {
            NumericError::Unstable
        } else {
            error
        }
    };
    let resolvent = solve(&(&unit * s - a), &unit).map_err(unstable)?;
    let mut c = &resolvent * (&unit * s + a);
    let mut x = symmetrised(&(&resolvent * q * resolvent.transpose() * (2.0 * s)));
    let mut operations =
        2 * (cost::lu(n) + cost::triangular_solves(n, n)) + 3 * cost::product(n, n, n);
    for _ in 0..DOUBLINGS {
        let step = symmetrised(&(&c * &x * c.transpose()));
        c = &c * &c;
        x += &step;
        operations += 3 * cost::product(n, n, n);
        if finite(&x).is_err() || finite(&c).is_err() {
            return Err(NumericError::Unstable);
        }
        // Both the terms and the powers must be spent: a zero Q says nothing about A.
        if step.amax() <= f64::EPSILON * 0.25 * x.amax() && c.norm() <= f64::EPSILON {
            return Ok(Solution {
                matrix: x,
                operations,
            });
        }
    }
    Err(NumericError::Unstable)
}

/// The shift: the geometric mean of `||A||` and `1 / ||A^-1||`, which estimate the largest and the
/// smallest eigenvalue; for real eigenvalues that choice makes `C` smallest.
fn shift(a: &DMatrix<f64>) -> Result<f64, NumericError> {
    let n = a.nrows();
    let inverse = match solve(a, &DMatrix::identity(n, n)) {
        // An eigenvalue zero: not stable.
        Err(NumericError::Singular) => return Err(NumericError::Unstable),
        other => other?,
    };
    Ok(a.norm().sqrt() / inverse.norm().sqrt())
}
