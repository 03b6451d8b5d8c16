//! What an expression evaluates to: a scalar, a matrix, or the zero of whatever shape fits.
//!
//! A 1x1 matrix is the scalar it holds, as in `c^T P c`; every operation returns it as such.

use super::{Failure, FailureKind};
use crate::domain::Domain;
use crate::matrix::Matrix;
use crate::span::Span;
use crate::theory::{arithmetic, linear};

/// A value over the elements of a field.
#[derive(Clone, Debug, PartialEq)]
pub enum Value<E> {
    /// A scalar.
    Scalar(E),
    /// A matrix with more than one entry.
    Matrix(Matrix<E>),
    /// Zero of any shape: the printed bold zero.
    Zero,
}

impl<E: Clone + PartialEq> Value<E> {
    /// The value of a matrix; a 1x1 matrix becomes a scalar.
    pub fn from_matrix(matrix: Matrix<E>) -> Self {
        if matrix.shape() == (1, 1) {
            Value::Scalar(matrix[(0, 0)].clone())
        } else {
            Value::Matrix(matrix)
        }
    }

    /// The scalar that it is, where the zero of any shape is the scalar `zero`; none for a matrix.
    pub fn into_scalar(self, zero: E) -> Option<E> {
        match self {
            Value::Scalar(e) => Some(e),
            Value::Zero => Some(zero),
            Value::Matrix(_) => None,
        }
    }

    /// `(rows, columns)`; `None` for the zero of any shape.
    pub fn shape(&self) -> Option<(usize, usize)> {
        match self {
            Value::Scalar(_) => Some((1, 1)),
            Value::Matrix(m) => Some(m.shape()),
            Value::Zero => None,
        }
    }

    /// The entries row by row; none for the zero of any shape.
    pub fn entries(&self) -> Vec<&E> {
        match self {
            Value::Scalar(e) => vec![e],
            Value::Matrix(m) => m.iter().collect(),
            Value::Zero => Vec::new(),
        }
    }

    /// The value whose entries are the images of this one's.
    ///
    /// # Errors
    /// The first error of `image`.
    pub fn try_map<F: Clone + PartialEq, X>(
        &self,
        mut image: impl FnMut(&E) -> Result<F, X>,
    ) -> Result<Value<F>, X> {
        Ok(match self {
            Value::Scalar(e) => Value::Scalar(image(e)?),
            Value::Matrix(m) => Value::Matrix(m.try_map(image)?),
            Value::Zero => Value::Zero,
        })
    }

    /// The value whose entries are the images of this one's.
    pub fn map<F: Clone + PartialEq>(&self, mut image: impl FnMut(&E) -> F) -> Value<F> {
        match self {
            Value::Scalar(e) => Value::Scalar(image(e)),
            Value::Matrix(m) => Value::Matrix(m.map(image)),
            Value::Zero => Value::Zero,
        }
    }

    /// `4x1`, for messages.
    pub fn shape_text(&self) -> String {
        match self {
            Value::Scalar(_) => "scalar".into(),
            Value::Matrix(m) => format!("{}x{}", m.rows(), m.columns()),
            Value::Zero => "zero".into(),
        }
    }
}

fn misfit<E: Clone + PartialEq>(
    operation: &str,
    left: &Value<E>,
    right: &Value<E>,
    span: Span,
) -> Failure {
    Failure::new(
        FailureKind::Shape {
            operation: operation.into(),
            left: left.shape_text(),
            right: right.shape_text(),
        },
        span,
    )
}

/// `left + right`.
///
/// # Errors
/// When the shapes differ.
pub fn add<D: Domain>(
    field: &D,
    left: &Value<D::Element>,
    right: &Value<D::Element>,
    span: Span,
) -> Result<Value<D::Element>, Failure> {
    match (left, right) {
        (Value::Zero, other) | (other, Value::Zero) => Ok(other.clone()),
        (Value::Scalar(a), Value::Scalar(b)) => Ok(Value::Scalar(field.add(a, b))),
        (Value::Matrix(a), Value::Matrix(b)) => arithmetic::add(field, a, b)
            .map(Value::Matrix)
            .ok_or_else(|| misfit("+", left, right, span)),
        // `[...]\dot x + 0`: a plain zero beside a matrix is the zero matrix.
        (Value::Matrix(m), Value::Scalar(s)) | (Value::Scalar(s), Value::Matrix(m))
            if field.is_zero(s) =>
        {
            Ok(Value::Matrix(m.clone()))
        }
        (Value::Matrix(_), Value::Scalar(_)) | (Value::Scalar(_), Value::Matrix(_)) => {
            Err(misfit("+", left, right, span))
        }
    }
}

/// `-value`.
pub fn negate<D: Domain>(field: &D, value: &Value<D::Element>) -> Value<D::Element> {
    value.map(|e| field.negate(e))
}

/// `left - right`.
///
/// # Errors
/// When the shapes differ.
pub fn subtract<D: Domain>(
    field: &D,
    left: &Value<D::Element>,
    right: &Value<D::Element>,
    span: Span,
) -> Result<Value<D::Element>, Failure> {
    match (left, right) {
        (Value::Scalar(a), Value::Scalar(b)) => Ok(Value::Scalar(field.subtract(a, b))),
        (Value::Matrix(a), Value::Matrix(b)) => arithmetic::subtract(field, a, b)
            .map(Value::Matrix)
            .ok_or_else(|| misfit("-", left, right, span)),
        (Value::Zero, _)
        | (_, Value::Zero)
        | (Value::Matrix(_), Value::Scalar(_))
        | (Value::Scalar(_), Value::Matrix(_)) => add(field, left, &negate(field, right), span)
            .map_err(|_| misfit("-", left, right, span)),
    }
}

/// `left right`.
///
/// # Errors
/// When the inner sizes differ.
pub fn multiply<D: Domain>(
    field: &D,
    left: &Value<D::Element>,
    right: &Value<D::Element>,
    span: Span,
) -> Result<Value<D::Element>, Failure> {
    Ok(match (left, right) {
        (Value::Zero, _) | (_, Value::Zero) => Value::Zero,
        (Value::Scalar(a), Value::Scalar(b)) => Value::Scalar(field.multiply(a, b)),
        (Value::Scalar(s), Value::Matrix(m)) | (Value::Matrix(m), Value::Scalar(s)) => {
            Value::Matrix(arithmetic::scale(field, s, m))
        }
        (Value::Matrix(a), Value::Matrix(b)) => Value::from_matrix(
            arithmetic::multiply(field, a, b).ok_or_else(|| misfit("times", left, right, span))?,
        ),
    })
}

/// The inverse of a square matrix, column by column.
///
/// # Errors
/// When the matrix is not square or not invertible.
pub fn invert<D: Domain>(
    field: &D,
    matrix: &Matrix<D::Element>,
    span: Span,
) -> Result<Matrix<D::Element>, Failure> {
    let value = Value::Matrix(matrix.clone());
    if !matrix.is_square() {
        return Err(misfit("inverse", &value, &value, span));
    }
    let n = matrix.rows();
    let mut columns = Vec::with_capacity(n);
    for j in 0..n {
        let unit = (0..n).map(|i| field.integer(i64::from(i == j))).collect();
        match linear::solve(field, matrix.clone(), unit) {
            linear::Solution::Unique { values, .. } => columns.push(values),
            linear::Solution::TooLarge => {
                let what = "terms of an inverse matrix".into();
                return Err(Failure::new(FailureKind::Budget { what }, span));
            }
            linear::Solution::Inconsistent | linear::Solution::Underdetermined => {
                return Err(Failure::new(FailureKind::DivisionByZero, span));
            }
        }
    }
    Ok(Matrix::from_fn(n, n, |i, j| columns[j][i].clone()))
}
