//! Transfer functions and the variance of their response to white noise.
//!
//! White noise of intensity q through H(s) = b(s)/a(s) has the two-sided density
//! q |H(i omega)|^2 / (2 pi), whose integral over the whole axis is the variance. The integrand is an
//! even rational function, so the integral is a quotient of determinants of the Hurwitz matrix of a
//! (Hurwitz 1895; James, Nichols & Phillips 1947, section 7.9): no integration is needed.

use super::arithmetic::{identity, multiply, trace};
use super::determinant::determinant;
use super::error::TheoryError;
use super::hurwitz::hurwitz_matrix;
use super::sign::Sign;
use crate::domain::Domain;
use crate::matrix::Matrix;

/// b(s)/a(s) by its coefficients, highest power first; the first of the denominator is not zero.
#[derive(Clone, Debug, PartialEq)]
pub struct TransferFunction<E> {
    /// The coefficients of b.
    pub numerator: Vec<E>,
    /// The coefficients of a.
    pub denominator: Vec<E>,
}

impl<E: Sign + Clone + PartialEq + std::fmt::Debug> TransferFunction<E> {
    /// c^T (s E - A)^-1 b over the characteristic polynomial of A; c and b are columns.
    ///
    /// # Errors
    /// [`TheoryError::Shape`].
    pub fn of_states<D: Domain<Element = E>>(
        field: &D,
        system: &Matrix<E>,
        input: &Matrix<E>,
        output: &Matrix<E>,
    ) -> Result<Self, TheoryError> {
        let n = system.rows();
        for (matrix, found, expected) in [
            ("A", system.shape(), (n, n)),
            ("b", input.shape(), (n, 1)),
            ("c", output.shape(), (n, 1)),
        ] {
            if found != expected {
                return Err(TheoryError::Shape {
                    matrix,
                    expected,
                    found,
                });
            }
        }
        let row = output.transpose();
        let mut auxiliary = identity(field, n);
        let mut numerator = Vec::with_capacity(n);
        let mut denominator = vec![field.integer(1)];
        for m in 1..=n {
            let value = multiply(field, &row, &auxiliary)
                .and_then(|row| multiply(field, &row, input))
                .ok_or(TheoryError::Singular)?;
            numerator.push(value[(0, 0)].clone());
            let mut next = multiply(field, system, &auxiliary).ok_or(TheoryError::Singular)?;
            let trace = trace(field, &next).ok_or(TheoryError::Singular)?;
            let m = field.integer(i64::try_from(m).unwrap_or(i64::MAX));
            let coefficient = field
                .divide(&field.negate(&trace), &m)
                .ok_or(TheoryError::Singular)?;
            for i in 0..n {
                next[(i, i)] = field.add(&next[(i, i)], &coefficient);
            }
            denominator.push(coefficient);
            auxiliary = next;
        }
        Ok(TransferFunction {
            numerator,
            denominator,
        })
    }

    /// The variance of the response to white noise of an intensity.
    ///
    /// # Errors
    /// [`TheoryError::Improper`] where the response follows the noise itself,
    /// [`TheoryError::Unstable`] with the offending Hurwitz determinant.
    pub fn variance<D: Domain<Element = E>>(
        &self,
        field: &D,
        intensity: &E,
    ) -> Result<E, TheoryError> {
        let trimmed = |coefficients: &[E]| -> Vec<E> {
            let leading = coefficients.iter().position(|c| !field.is_zero(c));
            leading.map_or_else(Vec::new, |k| coefficients[k..].to_vec())
        };
        let (b, a) = (trimmed(&self.numerator), trimmed(&self.denominator));
        if b.is_empty() {
            return Ok(field.integer(0));
        }
        if a.is_empty() {
            return Err(TheoryError::Singular);
        }
        let n = a.len() - 1;
        if b.len() > n {
            return Err(TheoryError::Improper {
                numerator: b.len() - 1,
                denominator: n,
            });
        }
        // Monic, so that stability is a matter of signs alone.
        let monic: Vec<E> = a
            .iter()
            .map(|c| field.divide(c, &a[0]).ok_or(TheoryError::Singular))
            .collect::<Result<_, _>>()?;
        let hurwitz = hurwitz_matrix(field, &monic).ok_or(TheoryError::Singular)?;
        let minor = |k: usize| determinant(field, &hurwitz.leading(k)).ok_or(TheoryError::Singular);
        for order in 1..=n {
            let minor = minor(order)?;
            if !minor.is_positive()? {
                return Err(TheoryError::Unstable {
                    matrix: "the denominator",
                    order,
                    determinant: minor.to_string(),
                });
            }
        }
        // b(s) b(-s) = sum over k of (-1)^(n-1) g_k s^(2 (n-1-k)).
        let padded = |k: usize| {
            let offset = n - b.len();
            k.checked_sub(offset)
                .and_then(|k| b.get(k))
                .cloned()
                .unwrap_or_else(|| field.integer(0))
        };
        let g: Vec<E> = (0..n)
            .map(|k| {
                (0..=2 * k)
                    .filter(|m| *m < n && 2 * k - m < n)
                    .fold(field.integer(0), |sum, m| {
                        let term = field.multiply(&padded(m), &padded(2 * k - m));
                        if m % 2 == 0 {
                            field.add(&sum, &term)
                        } else {
                            field.subtract(&sum, &term)
                        }
                    })
            })
            .collect();
        // The variance is half the sum of g_k times the cofactors of H's first column, over det H: a
        // determinant with that column replaced by the g_k.
        let replaced = Matrix::from_fn(n, n, |i, j| {
            if j == 0 {
                g[i].clone()
            } else {
                hurwitz[(i, j)].clone()
            }
        });
        let top = determinant(field, &replaced).ok_or(TheoryError::Singular)?;
        let bottom = field.multiply(&field.integer(2), &minor(n)?);
        let value = field.divide(&top, &bottom).ok_or(TheoryError::Singular)?;
        let scaled = field
            .divide(intensity, &field.multiply(&a[0], &a[0]))
            .ok_or(TheoryError::Singular)?;
        Ok(field.multiply(&scaled, &value))
    }
}
