//! Sums, products, quotients, powers and calls of exact values.

use super::{
    Condition, Evaluator, Failure, FailureKind, LARGEST_EXPONENT, LARGEST_PRODUCT, Origin, Value,
    value,
};
use crate::domain::Domain;
use crate::expr::{Expr, ExprKind, Function, Sign};
use crate::span::Span;
use crate::theory::{arithmetic, determinant};
use num_rational::BigRational;
use std::collections::BTreeSet;

impl<D: Domain> Evaluator<'_, D> {
    pub(super) fn sum(
        &mut self,
        terms: &[(Sign, Expr)],
        span: Span,
    ) -> Result<Value<D::Element>, Failure> {
        let mut values = Vec::with_capacity(terms.len());
        for (_, term) in terms {
            values.push(self.expression(term)?);
        }
        // A block of zeros of any shape, as in `[0; g] w`, has as many rows as the sum needs: those of
        // the other terms, wherever it stands among them.
        let rows = |value: &Value<D::Element>| match value {
            Value::Matrix(m) => Some(m.rows()),
            Value::Scalar(_) | Value::Zero => None,
        };
        let heights: BTreeSet<usize> = values.iter().filter_map(rows).collect();
        if heights.len() > 1 {
            for height in heights {
                let mut fitted = values.clone();
                for (value, (_, term)) in fitted.iter_mut().zip(terms) {
                    if rows(value).is_some_and(|r| r != height) {
                        self.frame.wanted_rows = Some(height);
                        let other = self.expression(term);
                        self.frame.wanted_rows = None;
                        *value = other?;
                    }
                }
                if fitted.iter().filter_map(rows).all(|r| r == height) {
                    values = fitted;
                    break;
                }
            }
        }
        let mut sum: Option<Value<D::Element>> = None;
        for (value, (sign, term)) in values.into_iter().zip(terms) {
            sum = Some(match (sum, sign) {
                (None, Sign::Plus) => value,
                (None, Sign::Minus) => value::negate(&self.field, &value),
                (Some(s), Sign::Plus) => value::add(&self.field, &s, &value, term.span)?,
                (Some(s), Sign::Minus) => value::subtract(&self.field, &s, &value, term.span)?,
            });
        }
        sum.ok_or_else(|| Failure::unsupported("an empty sum", span))
    }

    pub(super) fn multiply(
        &self,
        left: &Value<D::Element>,
        right: &Value<D::Element>,
        span: Span,
    ) -> Result<Value<D::Element>, Failure> {
        let largest = |v: &Value<D::Element>| {
            v.entries()
                .iter()
                .map(|e| self.field.size(e))
                .max()
                .unwrap_or(0)
        };
        if largest(left).saturating_mul(largest(right)) > LARGEST_PRODUCT {
            return Err(Failure::new(
                FailureKind::Budget {
                    what: "terms of a product".into(),
                },
                span,
            ));
        }
        value::multiply(&self.field, left, right, span)
    }

    pub(super) fn quotient(
        &mut self,
        numerator: &Expr,
        denominator: &Expr,
    ) -> Result<Value<D::Element>, Failure> {
        let span = denominator.span;
        let top = self.expression(numerator)?;
        let Value::Scalar(divisor) = self.expression(denominator)? else {
            return Err(Failure::unsupported("division by a matrix", span));
        };
        let inverse = self.reciprocal(&divisor, span)?;
        self.multiply(&Value::Scalar(inverse), &top, span)
    }

    /// 1/divisor, with its condition.
    pub(super) fn reciprocal(
        &mut self,
        divisor: &D::Element,
        span: Span,
    ) -> Result<D::Element, Failure> {
        let inverse = self
            .field
            .divide(&self.field.integer(1), divisor)
            .ok_or_else(|| Failure::new(FailureKind::DivisionByZero, span))?;
        self.conditions.push(Condition {
            divisor: divisor.clone(),
            origin: Origin::Divisor(span),
        });
        Ok(inverse)
    }

    pub(super) fn power(
        &mut self,
        base: &Expr,
        exponent: &Expr,
        span: Span,
    ) -> Result<Value<D::Element>, Failure> {
        // It costs what stands in it, and no other place of the document.
        let too_large = || {
            let what = format!("factors: an exponent above {LARGEST_EXPONENT}");
            Failure::new(FailureKind::Budget { what }, exponent.span)
        };
        let n = match self.integer(exponent) {
            Ok(n) => n,
            Err(_) if exceeds_all_integers(exponent) => return Err(too_large()),
            Err(failure) => return self.general_power(base, exponent, failure),
        };
        let magnitude = u32::try_from(n.unsigned_abs())
            .ok()
            .filter(|m| *m <= LARGEST_EXPONENT)
            .ok_or_else(too_large)?;
        if let (ExprKind::Name(name), true) = (&base.kind, n > 0)
            && let Some((node, rest)) = self.model.power_node(name, magnitude)
        {
            let defined = self.node((node, Vec::new(), 0), span)?;
            return self.integer_power(defined, false, rest, span);
        }
        let base = self.expression(base)?;
        self.integer_power(base, n < 0, magnitude, span)
    }

    /// A value to a power by squaring, or its inverse.
    fn integer_power(
        &mut self,
        base: Value<D::Element>,
        inverted: bool,
        magnitude: u32,
        span: Span,
    ) -> Result<Value<D::Element>, Failure> {
        match base {
            Value::Scalar(s) => {
                let s = if inverted {
                    self.reciprocal(&s, span)?
                } else {
                    s
                };
                self.field
                    .power(&s, magnitude)
                    .map(Value::Scalar)
                    .ok_or_else(|| {
                        Failure::new(
                            FailureKind::Budget {
                                what: "terms of a power".into(),
                            },
                            span,
                        )
                    })
            }
            Value::Matrix(m) => {
                if !m.is_square() {
                    let text = Value::Matrix(m).shape_text();
                    return Err(Failure::new(
                        FailureKind::Shape {
                            operation: "power".into(),
                            left: text.clone(),
                            right: text,
                        },
                        span,
                    ));
                }
                let factor = if inverted {
                    if let Some(det) = determinant::determinant(&self.field, &m) {
                        self.reciprocal(&det, span)?;
                    }
                    value::invert(&self.field, &m, span)?
                } else {
                    m
                };
                let one = arithmetic::identity(&self.field, factor.rows());
                let (mut product, mut factor) = (Value::Matrix(one), Value::Matrix(factor));
                let mut rest = magnitude;
                while rest > 0 {
                    if rest & 1 == 1 {
                        product = self.multiply(&product, &factor, span)?;
                    }
                    rest >>= 1;
                    if rest > 0 {
                        factor = self.multiply(&factor, &factor, span)?;
                    }
                }
                Ok(product)
            }
            Value::Zero if inverted => Err(Failure::new(FailureKind::DivisionByZero, span)),
            // The unit matrix, but nothing says of which order.
            Value::Zero if magnitude == 0 => {
                Err(Failure::unsupported("the power 0 of a bare zero", span))
            }
            Value::Zero => Ok(Value::Zero),
        }
    }

    pub(super) fn call(
        &mut self,
        function: Function,
        argument: &Expr,
        span: Span,
    ) -> Result<Value<D::Element>, Failure> {
        let value = self.expression(argument)?;
        let matrix = match &value {
            Value::Matrix(m) => m.clone(),
            Value::Scalar(s) => crate::matrix::Matrix::from_fn(1, 1, |_, _| s.clone()),
            Value::Zero => return Err(Failure::unsupported("a function of a bare zero", span)),
        };
        let result = match function {
            Function::Determinant => determinant::determinant(&self.field, &matrix),
            Function::Trace => arithmetic::trace(&self.field, &matrix),
            // Bars around a square matrix.
            Function::Absolute if matrix.is_square() && matches!(value, Value::Matrix(_)) => {
                determinant::determinant(&self.field, &matrix)
            }
            Function::Absolute
            | Function::RealPart
            | Function::ImaginaryPart
            | Function::Cosine
            | Function::Sine
            | Function::Tangent
            | Function::Cotangent
            | Function::HyperbolicCosine
            | Function::HyperbolicSine
            | Function::HyperbolicTangent
            | Function::Exponential
            | Function::Logarithm
            | Function::SquareRoot => return self.function_of(function, &value, span),
        };
        result.map(Value::Scalar).ok_or_else(|| {
            Failure::new(
                FailureKind::Shape {
                    operation: "determinant or trace".into(),
                    left: value.shape_text(),
                    right: "square".into(),
                },
                span,
            )
        })
    }
}

/// Whether integers under it give an integer, where it is an operation.
fn is_operation(expr: &Expr) -> bool {
    matches!(
        expr.kind,
        ExprKind::Group { .. } | ExprKind::Sum(_) | ExprKind::Product(_) | ExprKind::Power { .. }
    )
}

/// Whether an exponent is an integer, and too large for one.
fn exceeds_all_integers(exponent: &Expr) -> bool {
    let mut whole = true;
    crate::expr::walk::visit(exponent, &mut |e| {
        whole &= is_operation(e) || e.as_number().is_some_and(BigRational::is_integer);
    });
    whole
}

/// The place of a product up to and including a factor.
pub(super) fn p_span(factors: &[Expr], last: &Expr) -> Span {
    factors.first().map_or(last.span, |f| f.span.to(last.span))
}
