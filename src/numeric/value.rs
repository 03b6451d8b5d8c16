//! What an expression evaluates to in floating point: a scalar, a matrix, or the zero of whatever
//! shape fits. A 1x1 matrix is the scalar it holds, as in `c^T P c`.

use super::linear;
use super::{NumericError, finite};
use crate::span::Span;
use nalgebra::DMatrix;

/// A floating-point value.
#[derive(Clone, Debug, PartialEq)]
pub enum Value {
    /// A scalar.
    Scalar(f64),
    /// A matrix with more than one entry, or none.
    Matrix(DMatrix<f64>),
    /// Zero of any shape: the printed bold zero.
    Zero,
}

/// Why an expression has no floating-point value, and where.
#[derive(Clone, Debug, PartialEq)]
pub struct Failure {
    /// Why.
    pub kind: FailureKind,
    /// Where.
    pub span: Span,
}

/// Why an expression has no floating-point value.
#[derive(Clone, Debug, PartialEq)]
pub enum FailureKind {
    /// Shapes that do not fit.
    Shape {
        /// What was being done.
        operation: &'static str,
        /// The shape of the left operand; none for the zero of any shape.
        left: Option<(usize, usize)>,
        /// The shape of the right operand.
        right: Option<(usize, usize)>,
    },
    /// A divisor that is zero.
    DivisionByZero,
    /// An index that is no integer, or an exponent beyond the limit.
    Exponent,
    /// A member of a family, or an entry, that does not exist.
    Outside {
        /// The indices.
        indices: Vec<i64>,
    },
    /// A name without a meaning.
    Undeclared {
        /// The name.
        name: String,
    },
    /// A letter without a number.
    WithoutValue {
        /// The name.
        name: String,
    },
    /// A definition that needs itself.
    Cyclic,
    /// Too many terms, factors or unknowns.
    Budget,
    /// Outside of what is evaluated here.
    Unsupported(&'static str),
    /// The numerical method refuses it.
    Numeric(NumericError),
}

impl Failure {
    /// A failure at a place.
    pub fn new(kind: FailureKind, span: Span) -> Self {
        Failure { kind, span }
    }

    pub(super) fn unsupported(what: &'static str, span: Span) -> Self {
        Failure::new(FailureKind::Unsupported(what), span)
    }

    pub(super) fn shape(operation: &'static str, left: &Value, right: &Value, span: Span) -> Self {
        let (left, right) = (left.shape(), right.shape());
        let kind = FailureKind::Shape {
            operation,
            left,
            right,
        };
        Failure::new(kind, span)
    }

    pub(super) fn numeric(error: NumericError, span: Span) -> Self {
        match error {
            NumericError::Shape { expected, found } => Failure::new(
                FailureKind::Shape {
                    operation: "solve",
                    left: Some(expected),
                    right: Some(found),
                },
                span,
            ),
            NumericError::Range
            | NumericError::NotFinite
            | NumericError::NotSymmetric
            | NumericError::NoConvergence { .. }
            | NumericError::Singular
            | NumericError::Unstable
            | NumericError::NotLinear
            | NumericError::Count { .. }
            | NumericError::Tolerance { .. } => Failure::new(FailureKind::Numeric(error), span),
        }
    }
}

impl Value {
    /// The value of a matrix; a 1x1 matrix becomes a scalar.
    pub fn from_matrix(matrix: DMatrix<f64>) -> Self {
        if matrix.shape() == (1, 1) {
            Value::Scalar(matrix[(0, 0)])
        } else {
            Value::Matrix(matrix)
        }
    }

    /// The value as a matrix; a zero takes the shape that is asked for.
    pub fn into_matrix(self, zero: (usize, usize)) -> DMatrix<f64> {
        match self {
            Value::Scalar(s) => DMatrix::from_element(1, 1, s),
            Value::Matrix(m) => m,
            Value::Zero => DMatrix::zeros(zero.0, zero.1),
        }
    }

    /// The number that it is, where the zero of any shape is 0.
    ///
    /// # Errors
    /// Where it is a matrix.
    pub(super) fn into_number(self, operation: &'static str, span: Span) -> Result<f64, Failure> {
        match self {
            Value::Scalar(x) => Ok(x),
            Value::Zero => Ok(0.0),
            Value::Matrix(_) => Err(Failure::shape(operation, &self, &Value::Scalar(0.0), span)),
        }
    }

    /// `(rows, columns)`; none for the zero of any shape.
    pub fn shape(&self) -> Option<(usize, usize)> {
        match self {
            Value::Scalar(_) => Some((1, 1)),
            Value::Matrix(m) => Some(m.shape()),
            Value::Zero => None,
        }
    }

    /// Whether no entry is infinite or NaN.
    pub fn is_finite(&self) -> bool {
        match self {
            Value::Scalar(s) => s.is_finite(),
            Value::Matrix(m) => finite(m).is_ok(),
            Value::Zero => true,
        }
    }

    /// The value with its sign changed.
    #[must_use]
    pub fn negated(self) -> Self {
        match self {
            Value::Scalar(s) => Value::Scalar(-s),
            Value::Matrix(m) => Value::Matrix(-m),
            Value::Zero => Value::Zero,
        }
    }

    /// The transposed value.
    #[must_use]
    pub fn transposed(self) -> Self {
        match self {
            Value::Matrix(m) => Value::Matrix(m.transpose()),
            Value::Scalar(_) | Value::Zero => self,
        }
    }

    /// `self + other`; a plain zero beside a matrix is the zero matrix.
    pub fn add(self, other: Value, span: Span) -> Result<Value, Failure> {
        match (self, other) {
            (Value::Zero, other) | (other, Value::Zero) => Ok(other),
            (Value::Scalar(a), Value::Scalar(b)) => Ok(Value::Scalar(a + b)),
            (Value::Matrix(a), Value::Matrix(b)) if a.shape() == b.shape() => {
                Ok(Value::Matrix(a + b))
            }
            (Value::Matrix(m), Value::Scalar(s)) | (Value::Scalar(s), Value::Matrix(m))
                if s == 0.0 =>
            {
                Ok(Value::Matrix(m))
            }
            (left, right) => Err(Failure::shape("+", &left, &right, span)),
        }
    }

    /// `self other`, where a scalar scales a matrix.
    pub fn multiply(self, other: Value, span: Span) -> Result<Value, Failure> {
        match (self, other) {
            (Value::Zero, _) | (_, Value::Zero) => Ok(Value::Zero),
            (Value::Scalar(a), Value::Scalar(b)) => Ok(Value::Scalar(a * b)),
            (Value::Scalar(s), Value::Matrix(m)) | (Value::Matrix(m), Value::Scalar(s)) => {
                Ok(Value::Matrix(m * s))
            }
            (Value::Matrix(a), Value::Matrix(b)) if a.ncols() == b.nrows() => {
                Ok(Value::from_matrix(a * b))
            }
            (left, right) => Err(Failure::shape("times", &left, &right, span)),
        }
    }

    /// `self / divisor` by a scalar that is not zero.
    pub fn divide(self, divisor: Value, span: Span) -> Result<Value, Failure> {
        match (self, divisor) {
            (_, Value::Zero) => Err(Failure::new(FailureKind::DivisionByZero, span)),
            (_, Value::Scalar(0.0)) => Err(Failure::new(FailureKind::DivisionByZero, span)),
            (Value::Scalar(a), Value::Scalar(b)) => Ok(Value::Scalar(a / b)),
            (Value::Matrix(m), Value::Scalar(b)) => Ok(Value::Matrix(m / b)),
            (Value::Zero, Value::Scalar(_)) => Ok(Value::Zero),
            (left, right) => Err(Failure::shape("/", &left, &right, span)),
        }
    }

    /// An integer power by squaring; a negative one of a matrix by LU.
    pub fn power(self, exponent: i32, span: Span) -> Result<Value, Failure> {
        let base = match (self, exponent < 0) {
            (Value::Zero, false) if exponent > 0 => return Ok(Value::Zero),
            (Value::Zero, _) => return Err(Failure::new(FailureKind::DivisionByZero, span)),
            (Value::Matrix(m), _) if !m.is_square() => {
                let value = Value::Matrix(m);
                return Err(Failure::shape("power", &value, &value, span));
            }
            (Value::Matrix(m), true) => {
                let unit = DMatrix::identity(m.nrows(), m.nrows());
                let inverse = linear::solve(&m, &unit).map_err(|e| Failure::numeric(e, span))?;
                Value::Matrix(inverse)
            }
            (base, true) => Value::Scalar(1.0).divide(base, span)?,
            (base, false) => base,
        };
        let mut result = match &base {
            Value::Matrix(m) => Value::Matrix(DMatrix::identity(m.nrows(), m.nrows())),
            Value::Scalar(_) | Value::Zero => Value::Scalar(1.0),
        };
        let (mut square, mut rest) = (base, exponent.unsigned_abs());
        while rest > 0 {
            if rest % 2 == 1 {
                result = result.multiply(square.clone(), span)?;
            }
            rest /= 2;
            if rest > 0 {
                square = square.clone().multiply(square, span)?;
            }
        }
        Ok(result)
    }

    /// The matrix of blocks; a zero takes the shape that its neighbours need.
    pub fn from_blocks(blocks: &[Vec<(Value, Span)>], span: Span) -> Result<Value, Failure> {
        let columns = blocks.first().map_or(0, Vec::len);
        if columns == 0 || blocks.iter().any(|row| row.len() != columns) {
            return Err(Failure::unsupported("a matrix with ragged rows", span));
        }
        // A zero of any shape is square where its neighbours leave a side open.
        let height =
            |row: &Vec<(Value, Span)>| row.iter().find_map(|(v, _)| v.shape()).map(|s| s.0);
        let width = |j: usize| blocks.iter().find_map(|row| row[j].0.shape()).map(|s| s.1);
        let square = [
            (0..columns).find_map(width).unwrap_or(1),
            blocks.iter().find_map(height).unwrap_or(1),
        ];
        let heights: Vec<usize> = blocks
            .iter()
            .map(|row| height(row).unwrap_or(square[0]))
            .collect();
        let widths: Vec<usize> = (0..columns)
            .map(|j| width(j).unwrap_or(square[1]))
            .collect();
        let mut matrix = DMatrix::zeros(heights.iter().sum(), widths.iter().sum());
        let mut top = 0;
        for (row, height) in blocks.iter().zip(&heights) {
            let mut left = 0;
            for ((value, at), width) in row.iter().zip(&widths) {
                let expected = (*height, *width);
                match value {
                    Value::Zero => {}
                    Value::Scalar(s) if expected == (1, 1) => matrix[(top, left)] = *s,
                    Value::Scalar(0.0) => {}
                    Value::Matrix(m) if m.shape() == expected => {
                        matrix.view_mut((top, left), expected).copy_from(m);
                    }
                    Value::Scalar(_) | Value::Matrix(_) => {
                        let kind = FailureKind::Shape {
                            operation: "matrix block",
                            left: Some(expected),
                            right: value.shape(),
                        };
                        return Err(Failure::new(kind, *at));
                    }
                }
                left += width;
            }
            top += height;
        }
        Ok(Value::from_matrix(matrix))
    }
}
