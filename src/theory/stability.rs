//! Asymptotic stability by the Hurwitz determinants (Hurwitz 1895; Gantmacher II, 1959, ch. XV).

use super::characteristic::characteristic_coefficients;
use super::determinant::determinant;
use super::error::TheoryError;
use super::hurwitz::hurwitz_matrix;
use super::sign::Sign;
use crate::domain::Domain;
use crate::matrix::Matrix;

/// The Hurwitz determinants H_1, ..., H_n of the characteristic polynomial of a square matrix.
///
/// # Errors
/// [`TheoryError::Shape`] where the matrix is not square.
pub fn hurwitz_determinants<D: Domain>(
    field: &D,
    name: &'static str,
    matrix: &Matrix<D::Element>,
) -> Result<Vec<D::Element>, TheoryError> {
    let n = matrix.rows();
    let shape = || TheoryError::Shape {
        matrix: name,
        expected: (n, n),
        found: matrix.shape(),
    };
    let coefficients = characteristic_coefficients(field, matrix).ok_or_else(shape)?;
    let hurwitz = hurwitz_matrix(field, &coefficients).ok_or_else(shape)?;
    (1..=n)
        .map(|k| determinant(field, &hurwitz.leading(k)).ok_or_else(shape))
        .collect()
}

/// That all eigenvalues lie in the open left half plane: all Hurwitz determinants are positive.
///
/// # Errors
/// [`TheoryError::Unstable`] with the first determinant that is not, [`TheoryError::UnknownSign`].
pub fn require_stable<D: Domain>(
    field: &D,
    name: &'static str,
    matrix: &Matrix<D::Element>,
) -> Result<(), TheoryError>
where
    D::Element: Sign,
{
    for (k, minor) in hurwitz_determinants(field, name, matrix)?
        .iter()
        .enumerate()
    {
        if !minor.is_positive()? {
            return Err(TheoryError::Unstable {
                matrix: name,
                order: k + 1,
                determinant: minor.to_string(),
            });
        }
    }
    Ok(())
}
