//! Floating-point solutions, one method a file, on `f64` matrices.
//!
//! This route shares nothing with the exact engine: it starts from the same printed expressions
//! and never sees a polynomial. A result is compared with the exact value at the very same
//! point (see [`agreement`]), so its error is known and not estimated.
//!
//! The central problem is the Lyapunov equation `A X + X A^T + Q = 0`, whose solution is the
//! stationary covariance of `dx/dt = A x + w`, `w` white with intensity `Q`:
//!
//! | method | needs a stable `A` | gives |
//! | --- | --- | --- |
//! | [`bartels_stewart`] | no | `X` |
//! | [`kronecker`] | no | `X`; solves any linear matrix equation |
//! | [`kreisselmeier`] | no | `X` |
//! | [`smith`] | yes | `X` |
//! | [`hurwitz`] | yes | the variance of one output |
//! | [`spectral`] | yes | the variance of one output |
//! | [`simulation`] | yes | an estimate of `X` with its standard error |
//!
//! Invariants: every iteration is bounded; input that a method cannot treat is a
//! [`NumericError`], never a panic and never a silent NaN; only `+ - * /`, square roots and
//! `libm` are used, so that the same input gives the same bits on every machine.

#![warn(clippy::wildcard_enum_match_arm)]

use nalgebra::DMatrix;

pub mod agreement;
mod balancing;
pub mod bartels_stewart;
pub mod characteristic;
pub mod cost;
pub mod discretisation;
pub mod evaluate;
mod function;
pub mod hurwitz;
pub mod kreisselmeier;
pub mod kronecker;
pub mod linear;
pub mod point;
pub mod quadrature;
pub mod resolver;
pub mod sample;
pub mod simulation;
pub mod smith;
pub mod spectral;
pub mod spectrum;
pub mod sylvester_form;
pub mod unknowns;
pub mod value;

/// Why a floating-point method gives no result.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum NumericError {
    /// A matrix of another shape was needed, as (rows, columns).
    Shape {
        /// What was needed.
        expected: (usize, usize),
        /// What was given.
        found: (usize, usize),
    },
    /// An infinity or NaN in the input, or an overflow in the result.
    NotFinite,
    /// `Q` differs from its transpose.
    NotSymmetric,
    /// The iteration did not settle within its limit.
    NoConvergence {
        /// The limit.
        iterations: usize,
    },
    /// No unique solution to working precision; for a Lyapunov equation two eigenvalues have
    /// the sum zero.
    Singular,
    /// No stationary covariance: an eigenvalue does not lie in the open left half plane.
    Unstable,
    /// The equation is not linear in its unknowns.
    NotLinear,
    /// The number of scalar equations differs from the number of scalar unknowns.
    Count {
        /// Scalar equations.
        equations: usize,
        /// Scalar unknowns.
        unknowns: usize,
    },
    /// The quadrature ended at its evaluation limit with an error above the tolerance.
    Tolerance {
        /// The best value found.
        value: f64,
        /// Its error estimate.
        error: f64,
        /// Evaluations of the integrand.
        evaluations: usize,
    },
    /// A range that is empty, not positive or not finite, or an option without meaning.
    Range,
}

/// A matrix and what it cost.
#[derive(Clone, Debug, PartialEq)]
pub struct Solution {
    /// The solution.
    pub matrix: DMatrix<f64>,
    /// Floating-point operations by the formulas of [`cost`], with the iterations that ran.
    pub operations: u64,
}

/// The methods that give the whole covariance matrix.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum LyapunovMethod {
    /// Real Schur form and back substitution.
    BartelsStewart,
    /// The linear system of all entries.
    Kronecker,
    /// Squared series after a Cayley transform.
    Smith,
    /// A finite sum with the characteristic coefficients.
    Kreisselmeier,
}

impl LyapunovMethod {
    /// All of them, in the order of the table.
    pub const ALL: [LyapunovMethod; 4] = [
        LyapunovMethod::BartelsStewart,
        LyapunovMethod::Kronecker,
        LyapunovMethod::Smith,
        LyapunovMethod::Kreisselmeier,
    ];

    /// The solution of `A X + X A^T + Q = 0` for `n x n` matrices, `Q` symmetric.
    pub fn solve(self, a: &DMatrix<f64>, q: &DMatrix<f64>) -> Result<Solution, NumericError> {
        match self {
            LyapunovMethod::BartelsStewart => bartels_stewart::lyapunov(a, q),
            LyapunovMethod::Kronecker => kronecker::lyapunov(a, q),
            LyapunovMethod::Smith => smith::lyapunov(a, q),
            LyapunovMethod::Kreisselmeier => kreisselmeier::lyapunov(a, q),
        }
    }
}

/// The order `n` of the Lyapunov equation, after its matrices were checked.
pub(crate) fn order_of_lyapunov(a: &DMatrix<f64>, q: &DMatrix<f64>) -> Result<usize, NumericError> {
    let n = square(a)?;
    if q.shape() != (n, n) {
        return Err(NumericError::Shape {
            expected: (n, n),
            found: q.shape(),
        });
    }
    finite(a)?;
    finite(q)?;
    if !is_symmetric(q) {
        return Err(NumericError::NotSymmetric);
    }
    Ok(n)
}

/// The order of a square matrix.
pub(crate) fn square(a: &DMatrix<f64>) -> Result<usize, NumericError> {
    if a.is_square() {
        Ok(a.nrows())
    } else {
        Err(NumericError::Shape {
            expected: (a.nrows(), a.nrows()),
            found: a.shape(),
        })
    }
}

/// Refuses infinities and NaN.
pub(crate) fn finite(m: &DMatrix<f64>) -> Result<(), NumericError> {
    if m.iter().all(|x| x.is_finite()) {
        Ok(())
    } else {
        Err(NumericError::NotFinite)
    }
}

/// Symmetric up to the rounding of a product such as `q B B^T`.
pub(crate) fn is_symmetric(m: &DMatrix<f64>) -> bool {
    let scale = m.amax();
    m.is_square()
        && (0..m.nrows())
            .all(|i| (0..i).all(|j| (m[(i, j)] - m[(j, i)]).abs() <= 8.0 * f64::EPSILON * scale))
}

/// The mean of a matrix and its transpose: exactly symmetric.
pub(crate) fn symmetrised(m: &DMatrix<f64>) -> DMatrix<f64> {
    (m + m.transpose()) * 0.5
}

/// The power of two next below a positive `x`, by its exponent bits; 1 for zero and subnormals.
pub(crate) fn power_of_two_below(x: f64) -> f64 {
    const MANTISSA: u64 = (1 << 52) - 1;
    let power = f64::from_bits(x.abs().to_bits() & !MANTISSA);
    if power.is_normal() { power } else { 1.0 }
}
