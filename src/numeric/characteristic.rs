//! The characteristic polynomial in floating point by the Faddeev-LeVerrier recursion
//! (Faddeev & Faddeeva, *Computational Methods of Linear Algebra*, 1963, section 47).

use super::{NumericError, cost, finite, square};
use nalgebra::DMatrix;

/// Characteristic coefficients and auxiliary matrices of one matrix.
#[derive(Clone, Debug, PartialEq)]
pub struct Characteristic {
    /// `a_0 = 1, a_1, ..., a_n` of `det(lambda E - A) = a_0 lambda^n + ... + a_n`.
    pub coefficients: Vec<f64>,
    /// `A_0 = E, ..., A_{n-1}` with `adj(lambda E - A) = A_0 lambda^{n-1} + ... + A_{n-1}`.
    pub auxiliary: Vec<DMatrix<f64>>,
    /// Floating-point operations.
    pub operations: u64,
}

/// `A_0 = E`, `a_m = -tr(A A_{m-1}) / m`, `A_m = A A_{m-1} + a_m E` for an `n x n` matrix;
/// `2 n^4` operations.
///
/// The recursion is the definition that papers print and exact for small integers, but not
/// backward stable: `a_m` suffers cancellation when it is much smaller than `||A||^m`. That loss
/// belongs to every method built on it and is part of what the comparison measures.
pub fn faddeev_leverrier(a: &DMatrix<f64>) -> Result<Characteristic, NumericError> {
    let n = square(a)?;
    finite(a)?;
    let mut coefficients = vec![1.0];
    let mut auxiliary = Vec::with_capacity(n);
    let mut current = DMatrix::identity(n, n);
    for m in 1..=n {
        let mut next = a * &current;
        let coefficient = -next.trace() / m as f64;
        for i in 0..n {
            next[(i, i)] += coefficient;
        }
        auxiliary.push(current);
        coefficients.push(coefficient);
        current = next;
    }
    if coefficients.iter().any(|c| !c.is_finite()) {
        return Err(NumericError::NotFinite);
    }
    Ok(Characteristic {
        coefficients,
        auxiliary,
        operations: n as u64 * cost::product(n, n, n),
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numeric::linear::determinant;
    use approx::assert_relative_eq;

    #[test]
    fn companion_matrix_gives_its_coefficients() {
        // det(lambda E - A) = lambda^3 + 2 lambda^2 + 3 lambda + 4
        let a = DMatrix::from_row_slice(3, 3, &[0.0, 1.0, 0.0, 0.0, 0.0, 1.0, -4.0, -3.0, -2.0]);
        let c = faddeev_leverrier(&a).unwrap();
        assert_eq!(c.coefficients, [1.0, 2.0, 3.0, 4.0]);
        assert_eq!(c.auxiliary.len(), 3);
        assert_eq!(
            faddeev_leverrier(&DMatrix::zeros(0, 0))
                .unwrap()
                .coefficients,
            [1.0]
        );
    }

    #[test]
    fn last_coefficient_is_the_signed_determinant() {
        for n in 1..6 {
            let a = DMatrix::from_fn(n, n, |i, j| ((3 * i + 7 * j) % 5) as f64 - 1.5);
            let last = faddeev_leverrier(&a).unwrap().coefficients[n];
            let det = determinant(&a).unwrap();
            let sign = if n % 2 == 0 { 1.0 } else { -1.0 };
            assert_relative_eq!(last, sign * det, max_relative = 1e-10, epsilon = 1e-10);
        }
    }
}
