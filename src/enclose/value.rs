//! Scalars, matrices, and the zero of whatever shape fits.
//!
//! A matrix with one entry is the scalar it holds, as in `c^T P c`; every operation returns it as such.

use super::arithmetic::Arithmetic;
use super::failure::Reason;
use super::jet::{Jet, Result};
use crate::matrix::Matrix;

/// What an expression evaluates to.
#[derive(Clone, Debug, PartialEq)]
pub enum Value {
    /// A scalar.
    Scalar(Jet),
    /// A matrix with more than one entry.
    Matrix(Matrix<Jet>),
    /// Zero of any shape.
    Zero,
}

impl Value {
    /// The value of a matrix.
    pub fn from_matrix(matrix: Matrix<Jet>) -> Self {
        if matrix.shape() == (1, 1) {
            Value::Scalar(matrix[(0, 0)].clone())
        } else {
            Value::Matrix(matrix)
        }
    }

    /// Rows and columns; none for the zero of any shape.
    pub fn shape(&self) -> Option<(usize, usize)> {
        match self {
            Value::Scalar(_) => Some((1, 1)),
            Value::Matrix(m) => Some(m.shape()),
            Value::Zero => None,
        }
    }

    /// The entries row by row; none for the zero of any shape.
    pub fn entries(&self) -> Vec<&Jet> {
        match self {
            Value::Scalar(x) => vec![x],
            Value::Matrix(m) => m.iter().collect(),
            Value::Zero => Vec::new(),
        }
    }

    /// The value whose entries are the images of this one's.
    pub(super) fn map<E>(
        &self,
        mut image: impl FnMut(&Jet) -> std::result::Result<Jet, E>,
    ) -> std::result::Result<Value, E> {
        Ok(match self {
            Value::Scalar(x) => Value::Scalar(image(x)?),
            Value::Matrix(m) => Value::Matrix(m.try_map(image)?),
            Value::Zero => Value::Zero,
        })
    }

    /// `-value`.
    #[must_use]
    pub fn negated(&self) -> Value {
        match self {
            Value::Scalar(x) => Value::Scalar(x.negated()),
            Value::Matrix(m) => Value::Matrix(m.map(Jet::negated)),
            Value::Zero => Value::Zero,
        }
    }

    /// The transposed value.
    #[must_use]
    pub fn transposed(&self) -> Value {
        match self {
            Value::Matrix(m) => Value::Matrix(m.transpose()),
            Value::Scalar(_) | Value::Zero => self.clone(),
        }
    }

    /// The matrix that it is.
    pub fn as_matrix(&self) -> Option<&Matrix<Jet>> {
        match self {
            Value::Matrix(m) => Some(m),
            Value::Scalar(_) | Value::Zero => None,
        }
    }

    /// The scalar that it is; a plain zero where it is the zero of any shape.
    pub fn into_scalar(self) -> Option<Jet> {
        match self {
            Value::Scalar(x) => Some(x),
            Value::Zero => Some(Jet::zero()),
            Value::Matrix(_) => None,
        }
    }

    /// The square matrix that it is.
    pub(super) fn square(&self, operation: &'static str) -> Result<Matrix<Jet>> {
        match self {
            Value::Scalar(x) => Ok(Matrix::from_fn(1, 1, |_, _| x.clone())),
            Value::Matrix(m) if m.is_square() => Ok(m.clone()),
            Value::Matrix(_) => Err(misfit(operation, self, self)),
            Value::Zero => Err(Reason::Unsupported(
                "a determinant of a zero without a shape",
            )),
        }
    }
}

pub(super) fn misfit(operation: &'static str, left: &Value, right: &Value) -> Reason {
    Reason::Shape {
        operation,
        left: left.shape(),
        right: right.shape(),
    }
}

impl Arithmetic {
    /// `x + y`. A plain zero beside a matrix is the zero matrix.
    pub(super) fn sum(&self, x: &Value, y: &Value) -> Result<Value> {
        match (x, y) {
            (Value::Zero, other) | (other, Value::Zero) => Ok(other.clone()),
            (Value::Scalar(a), Value::Scalar(b)) => Ok(Value::Scalar(self.add(a, b))),
            (Value::Matrix(a), Value::Matrix(b)) if a.shape() == b.shape() => {
                let (rows, columns) = a.shape();
                Ok(Value::Matrix(Matrix::from_fn(rows, columns, |i, j| {
                    self.add(&a[(i, j)], &b[(i, j)])
                })))
            }
            (Value::Matrix(m), Value::Scalar(s)) | (Value::Scalar(s), Value::Matrix(m))
                if s.is_zero() =>
            {
                Ok(Value::Matrix(m.clone()))
            }
            (Value::Matrix(_), Value::Matrix(_) | Value::Scalar(_))
            | (Value::Scalar(_), Value::Matrix(_)) => Err(misfit("+", x, y)),
        }
    }

    /// `x y`.
    pub(super) fn product(&self, x: &Value, y: &Value) -> Result<Value> {
        match (x, y) {
            (Value::Zero, _) | (_, Value::Zero) => Ok(Value::Zero),
            (Value::Scalar(a), Value::Scalar(b)) => Ok(Value::Scalar(self.multiply(a, b)?)),
            (Value::Scalar(s), Value::Matrix(m)) | (Value::Matrix(m), Value::Scalar(s)) => {
                Ok(Value::Matrix(m.try_map(|e| self.multiply(s, e))?))
            }
            (Value::Matrix(a), Value::Matrix(b)) if a.columns() == b.rows() => {
                Ok(Value::from_matrix(self.matrix_product(a, b)?))
            }
            (Value::Matrix(_), Value::Matrix(_)) => Err(misfit("times", x, y)),
        }
    }

    pub(super) fn matrix_product(&self, a: &Matrix<Jet>, b: &Matrix<Jet>) -> Result<Matrix<Jet>> {
        Matrix::try_from_fn(a.rows(), b.columns(), |i, j| {
            let mut sum = Jet::zero();
            for k in 0..a.columns() {
                sum = self.add(&sum, &self.multiply(&a[(i, k)], &b[(k, j)])?);
            }
            Ok(sum)
        })
    }

    /// A power of a square matrix.
    pub(super) fn matrix_power(&self, m: &Matrix<Jet>, n: i32) -> Result<Matrix<Jet>> {
        let base = if n < 0 { self.inverse(m)? } else { m.clone() };
        let mut result = identity(m.rows());
        let mut square = base;
        let mut exponent = n.unsigned_abs();
        while exponent > 0 {
            if exponent & 1 == 1 {
                result = self.matrix_product(&result, &square)?;
            }
            exponent >>= 1;
            if exponent > 0 {
                square = self.matrix_product(&square, &square)?;
            }
        }
        Ok(result)
    }

    pub(super) fn trace(&self, m: &Matrix<Jet>) -> Jet {
        (0..m.rows()).fold(Jet::zero(), |sum, i| self.add(&sum, &m[(i, i)]))
    }
}

/// The unit matrix.
pub(super) fn identity(n: usize) -> Matrix<Jet> {
    Matrix::from_fn(n, n, |i, j| Jet::integer(i64::from(i == j)))
}
