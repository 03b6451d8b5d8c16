//! What expressions come to modulo the prime, and how an operation's value follows from its operands'.

use super::store::{Id, Shape};
use crate::domain::{Domain, PrimeField};
use crate::evaluate::{Value, value};
use crate::expr::Sign;
use crate::matrix::Matrix;
use crate::span::Span;

/// What a node comes to modulo the prime.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Residue {
    /// This.
    Is(Value<u64>),
    /// It has no value: a divisor that vanishes, a name that does not exist, shapes that do not fit.
    Absent,
    /// It cannot be told here.
    Unknown,
}

impl Residue {
    pub fn value(&self) -> Option<&Value<u64>> {
        match self {
            Residue::Is(value) => Some(value),
            Residue::Absent | Residue::Unknown => None,
        }
    }

    fn of(value: Option<Value<u64>>) -> Self {
        value.map_or(Residue::Absent, Residue::Is)
    }
}

/// Whether two nodes are equal; none where that cannot be told.
pub(super) fn compared(left: &Residue, right: &Residue) -> Option<bool> {
    match (left, right) {
        (Residue::Is(left), Residue::Is(right)) => Some(same(left, right)),
        (Residue::Unknown, _) | (_, Residue::Unknown) => None,
        _ => Some(false),
    }
}

/// Whether two values are equal, a zero of any shape among them.
pub(super) fn same(left: &Value<u64>, right: &Value<u64>) -> bool {
    let zero = |v: &Value<u64>| v.entries().iter().all(|e| **e == 0);
    match (left, right) {
        (Value::Zero, other) | (other, Value::Zero) => zero(other),
        (Value::Scalar(0), other) | (other, Value::Scalar(0)) => zero(other),
        _ => left == right,
    }
}

/// What an operation makes of its operands, which are numbered as the children of its expression; none
/// where only the evaluator can tell: for leaves and running sums, and where blocks of zeros get their
/// heights from what stands around them.
pub(super) fn operation(
    shape: &Shape,
    operand: &mut impl FnMut(usize, Id) -> Residue,
) -> Option<Residue> {
    let field = PrimeField;
    let span = Span::default();
    // The value of an operand; what it lacks, the whole lacks.
    macro_rules! value_of {
        ($number:expr, $id:expr) => {
            match operand($number, $id) {
                Residue::Is(value) => value,
                other => return Some(other),
            }
        };
    }
    Some(match shape {
        Shape::Sum(terms) => {
            let mut sum: Option<Value<u64>> = None;
            for (k, (sign, term)) in terms.iter().enumerate() {
                let value = value_of!(k, *term);
                sum = Some(match (sum, sign) {
                    (None, Sign::Plus) => value,
                    (None, Sign::Minus) => value::negate(&field, &value),
                    (Some(s), Sign::Plus) => value::add(&field, &s, &value, span).ok()?,
                    (Some(s), Sign::Minus) => value::subtract(&field, &s, &value, span).ok()?,
                });
            }
            Residue::of(sum)
        }
        Shape::Product(factors) => {
            let mut product: Option<Value<u64>> = None;
            for (k, factor) in factors.iter().enumerate() {
                let value = value_of!(k, *factor);
                product = Some(match product {
                    None => value,
                    Some(p) => match value::multiply(&field, &p, &value, span) {
                        Ok(value) => value,
                        Err(_) => return Some(Residue::Absent),
                    },
                });
            }
            Residue::of(product)
        }
        Shape::Quotient(above, below) => match (operand(0, *above), operand(1, *below)) {
            (Residue::Is(above), Residue::Is(Value::Scalar(below))) => {
                let inverse = field.divide(&1, &below).map(Value::Scalar);
                Residue::of(inverse.and_then(|i| value::multiply(&field, &i, &above, span).ok()))
            }
            (Residue::Unknown, _) | (_, Residue::Unknown) => Residue::Unknown,
            // By a matrix nothing is divided, and not by zero.
            (Residue::Absent, _)
            | (_, Residue::Absent | Residue::Is(Value::Matrix(_) | Value::Zero)) => Residue::Absent,
        },
        Shape::Power(base, exponent) => power(value_of!(0, *base), *exponent),
        Shape::Transpose(inner) => Residue::Is(match value_of!(0, *inner) {
            Value::Matrix(m) => Value::Matrix(m.transpose()),
            value @ (Value::Scalar(_) | Value::Zero) => value,
        }),
        Shape::Matrix(columns, entries) => {
            let mut values = Vec::with_capacity(entries.len());
            for (k, entry) in entries.iter().enumerate() {
                match value_of!(k, *entry) {
                    Value::Scalar(s) => values.push(s),
                    Value::Matrix(_) | Value::Zero => return None,
                }
            }
            let rows = values.len() / (*columns).max(1);
            let entry = |i: usize, j: usize| values[i * columns + j];
            Residue::Is(Value::from_matrix(Matrix::from_fn(rows, *columns, entry)))
        }
        Shape::Number(_) | Shape::Name(_) | Shape::Running(..) | Shape::Whole(_) => return None,
    })
}

/// A power with a literal exponent.
fn power(base: Value<u64>, exponent: i64) -> Residue {
    let field = PrimeField;
    match base {
        Value::Scalar(s) => {
            let base = if exponent < 0 {
                field.divide(&1, &s)
            } else {
                Some(s)
            };
            let magnitude = u32::try_from(exponent.unsigned_abs()).unwrap_or(u32::MAX);
            Residue::of(
                base.and_then(|b| field.power(&b, magnitude))
                    .map(Value::Scalar),
            )
        }
        Value::Zero => Residue::Is(Value::Zero),
        Value::Matrix(matrix) => {
            let factor = match exponent {
                0 => return Residue::Unknown,
                1.. => Ok(matrix),
                _ => value::invert(&field, &matrix, Span::default()),
            };
            let Ok(factor) = factor.map(Value::Matrix) else {
                return Residue::Absent;
            };
            let mut product = factor.clone();
            for _ in 1..exponent.unsigned_abs() {
                match value::multiply(&field, &product, &factor, Span::default()) {
                    Ok(next) => product = next,
                    Err(_) => return Residue::Absent,
                }
            }
            Residue::Is(product)
        }
    }
}
