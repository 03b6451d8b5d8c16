//! The Sylvester and Lyapunov equations by the real Schur form (Bartels & Stewart 1972,
//! *Comm. ACM* 15, 820-826, Algorithm 432).
//!
//! `A X + X B + Q = 0` with `A = U T U^T` and `B^T = V S V^T` becomes `T Y + Y S^T + F = 0` for
//! `Y = U^T X V`, `F = U^T Q V`, and is solved from its last block row and column backwards:
//! each block is a Sylvester equation of order 1 or 2. The matrices are balanced first, which
//! changes the units of the states but no bit of the mantissas.

use super::balancing::balance;
use super::spectrum::real_schur;
use super::{NumericError, Solution, cost, finite, order_of_lyapunov, square, symmetrised};
use nalgebra::DMatrix;

/// The symmetric solution `X` of `A X + X A^T + Q = 0`; all matrices `n x n`, `Q` symmetric.
///
/// About `35 n^3` operations. [`NumericError::Singular`] when two eigenvalues of `A` have the
/// sum zero to working precision; stability is not needed.
pub fn lyapunov(a: &DMatrix<f64>, q: &DMatrix<f64>) -> Result<Solution, NumericError> {
    let n = order_of_lyapunov(a, q)?;
    let (balanced, d) = balance(a);
    // With X = D Z D: (D^-1 A D) Z + Z (D^-1 A D)^T + D^-1 Q D^-1 = 0.
    let scaled = DMatrix::from_fn(n, n, |i, j| q[(i, j)] / d[i] / d[j]);
    let (u, t) = real_schur(&balanced)?;
    let y = back_substitution(&t, &t, &(u.transpose() * scaled * &u))?;
    let z = &u * y * u.transpose();
    let matrix = symmetrised(&DMatrix::from_fn(n, n, |i, j| z[(i, j)] * d[i] * d[j]));
    finite(&matrix)?;
    let operations = cost::real_schur(n) + 5 * cost::product(n, n, n);
    Ok(Solution { matrix, operations })
}

/// The solution `X` of `A X + X B + Q = 0`: `A` is `m x m`, `B` is `n x n`, `Q` and `X` are `m x n`.
///
/// About `25 (m^3 + n^3) + 5 m n (m + n)` operations. [`NumericError::Singular`] when an eigenvalue
/// of `A` and one of `B` have the sum zero to working precision.
pub fn sylvester(
    a: &DMatrix<f64>,
    b: &DMatrix<f64>,
    q: &DMatrix<f64>,
) -> Result<Solution, NumericError> {
    let (m, n) = (square(a)?, square(b)?);
    if q.shape() != (m, n) {
        return Err(NumericError::Shape {
            expected: (m, n),
            found: q.shape(),
        });
    }
    for matrix in [a, b, q] {
        finite(matrix)?;
    }
    let (balanced_a, d) = balance(a);
    let (balanced_b, e) = balance(&b.transpose());
    let scaled = DMatrix::from_fn(m, n, |i, j| q[(i, j)] / d[i] / e[j]);
    let (u, t) = real_schur(&balanced_a)?;
    let (v, s) = real_schur(&balanced_b)?;
    let y = back_substitution(&t, &s, &(u.transpose() * scaled * &v))?;
    let z = &u * y * v.transpose();
    let matrix = DMatrix::from_fn(m, n, |i, j| z[(i, j)] * d[i] * e[j]);
    finite(&matrix)?;
    let products = 2 * (cost::product(m, m, n) + cost::product(m, n, n));
    let operations = cost::real_schur(m) + cost::real_schur(n) + products + products / 4;
    Ok(Solution { matrix, operations })
}

/// `Y` of `T Y + Y S^T + F = 0` with quasi-triangular `T` and `S`.
fn back_substitution(
    t: &DMatrix<f64>,
    s: &DMatrix<f64>,
    f: &DMatrix<f64>,
) -> Result<DMatrix<f64>, NumericError> {
    let (m, n) = f.shape();
    let smallest = (m.max(n)) as f64 * f64::EPSILON * t.norm().max(s.norm());
    let mut y = DMatrix::zeros(m, n);
    for &(j, wide) in blocks(s).iter().rev() {
        for &(i, high) in blocks(t).iter().rev() {
            let mut rest = f.view((i, j), (high, wide)).into_owned();
            let below = m - i - high;
            rest += t.view((i, i + high), (high, below)) * y.view((i + high, j), (below, wide));
            let right = n - j - wide;
            rest += y.view((i, j + wide), (high, right))
                * s.view((j, j + wide), (wide, right)).transpose();
            let block = small_sylvester(
                &t.view((i, i), (high, high)).into_owned(),
                &s.view((j, j), (wide, wide)).into_owned(),
                &rest,
                smallest,
            )?;
            y.view_mut((i, j), (high, wide)).copy_from(&block);
        }
    }
    Ok(y)
}

/// The diagonal blocks of a quasi-triangular matrix as (first row, order 1 or 2).
fn blocks(t: &DMatrix<f64>) -> Vec<(usize, usize)> {
    let n = t.nrows();
    let mut blocks = Vec::with_capacity(n);
    let mut i = 0;
    while i < n {
        let order = if i + 1 < n && t[(i + 1, i)] != 0.0 {
            2
        } else {
            1
        };
        blocks.push((i, order));
        i += order;
    }
    blocks
}

/// `Y` of `T Y + Y S^T + R = 0` for `T` and `S` of order 1 or 2: at most four equations, by
/// complete pivoting; singular when a pivot is not above `smallest`.
fn small_sylvester(
    t: &DMatrix<f64>,
    s: &DMatrix<f64>,
    r: &DMatrix<f64>,
    smallest: f64,
) -> Result<DMatrix<f64>, NumericError> {
    let (m, n) = r.shape();
    let system = DMatrix::identity(n, n).kronecker(t) + s.kronecker(&DMatrix::identity(m, m));
    let lu = system.full_piv_lu();
    let u = lu.u();
    if (0..m * n).any(|k| u[(k, k)].abs() <= smallest) {
        return Err(NumericError::Singular);
    }
    let rhs = DMatrix::from_column_slice(m * n, 1, (-r).as_slice());
    let y = lu.solve(&rhs).ok_or(NumericError::Singular)?;
    Ok(DMatrix::from_column_slice(m, n, y.as_slice()))
}
