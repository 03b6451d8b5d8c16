//! Characteristic coefficients: det(lambda E - A) = lambda^n + a_1 lambda^(n-1) + ... + a_n.
//!
//! By the recursion of Le Verrier in the form of Faddeev (Gantmacher, *The Theory of Matrices* I,
//! 1959, ch. IV): A_0 = E, a_k = -tr(A A_(k-1)) / k, A_k = A A_(k-1) + a_k E, and A_n = 0.

use super::arithmetic::{identity, multiply, trace};
use crate::domain::Domain;
use crate::matrix::Matrix;

/// The characteristic coefficients a_0 = 1, a_1, ..., a_n of a square matrix of order n.
///
/// `None` when the matrix is not square or an integer up to n vanishes in the field.
pub fn characteristic_coefficients<D: Domain>(
    field: &D,
    matrix: &Matrix<D::Element>,
) -> Option<Vec<D::Element>> {
    if !matrix.is_square() {
        return None;
    }
    let n = matrix.rows();
    let mut coefficients = vec![field.integer(1)];
    let mut auxiliary = identity(field, n);
    for k in 1..=n {
        let mut product = multiply(field, matrix, &auxiliary)?;
        let trace = trace(field, &product)?;
        let coefficient = field.divide(
            &field.negate(&trace),
            &field.integer(i64::try_from(k).ok()?),
        )?;
        for i in 0..n {
            product[(i, i)] = field.add(&product[(i, i)], &coefficient);
        }
        coefficients.push(coefficient);
        auxiliary = product;
    }
    Some(coefficients)
}
