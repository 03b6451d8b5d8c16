//! Expressions to floating-point values.
//!
//! The same printed expressions as the exact route, by the standard floating-point methods:
//! determinants, minors and cofactors by LU, characteristic coefficients by the
//! Faddeev-LeVerrier recursion, inverses by LU, unknowns of linear equations as in
//! [`super::unknowns`]. Values of names are computed once. Invariants: a value is finite or a
//! [`Failure`]; no definition is entered twice at a time; nothing is computed exactly.

use super::characteristic::faddeev_leverrier;
use super::hurwitz::hurwitz_matrix;
use super::linear::determinant;
use super::resolver::{Element, Meaning, Reference, Resolver};
use super::unknowns::SolvedSystem;
use super::value::{Failure, FailureKind, Value};
use super::{LyapunovMethod, NumericError};
use crate::expr::{Expr, ExprKind, Function, Name, Sign, integer};
use crate::latex;
use crate::span::Span;
use nalgebra::DMatrix;
use num_traits::ToPrimitive;
use std::collections::{BTreeMap, BTreeSet};

/// The largest exponent that is evaluated.
const LARGEST_EXPONENT: i64 = 10_000;
/// The largest number of terms of a sum with a running index.
const LARGEST_RANGE: i64 = 10_000;

/// The deepest nesting of expressions, through definitions too: each level takes stack.
const DEEPEST: usize = 256;

/// What names a value: a node and its indices.
pub(super) type Key<N> = (N, Vec<i64>);

/// Evaluates the expressions of a document at the point that its resolver stands for.
pub struct Evaluator<'r, R: Resolver> {
    pub(super) resolver: &'r R,
    pub(super) method: LyapunovMethod,
    pub(super) known: BTreeMap<Key<R::Node>, Known>,
    pub(super) open: BTreeSet<Key<R::Node>>,
    /// Letters with other values than their own, the innermost last.
    pub(super) replaced: Vec<(R::Node, f64)>,
    pub(super) bound: Vec<(String, i64)>,
    depth: usize,
    /// The systems that are being solved.
    pub(super) solving: BTreeSet<usize>,
    /// Trial values of the unknowns of the innermost of them.
    pub(super) trial: BTreeMap<(usize, usize), Value>,
    /// Whether a trial value was used since this was last cleared.
    pub(super) touched: bool,
    /// The systems that are solved.
    pub(super) solved: BTreeMap<usize, SolvedSystem>,
    /// Whether the solution of a system was used since this was last cleared.
    pub(super) by_method: bool,
}

/// A value, and whether the solution of a system was used for it.
#[derive(Clone, Debug)]
pub(super) struct Known {
    value: Value,
    by_method: bool,
}

impl<'r, R: Resolver> Evaluator<'r, R> {
    /// An evaluator that solves Lyapunov equations by `method`, and every other linear equation
    /// by the Kronecker route.
    pub fn new(resolver: &'r R, method: LyapunovMethod) -> Self {
        Evaluator {
            resolver,
            method,
            known: BTreeMap::new(),
            open: BTreeSet::new(),
            replaced: Vec::new(),
            bound: Vec::new(),
            depth: 0,
            solving: BTreeSet::new(),
            trial: BTreeMap::new(),
            touched: false,
            solved: BTreeMap::new(),
            by_method: false,
        }
    }

    /// The value of an expression, and whether it depends on the method: where it does not, all methods
    /// have the same.
    pub fn value_and_dependence(&mut self, expr: &Expr) -> (Result<Value, Failure>, bool) {
        self.by_method = false;
        (self.value(expr), self.by_method)
    }

    /// The value of an expression: finite, or a failure with its place.
    pub fn value(&mut self, expr: &Expr) -> Result<Value, Failure> {
        let value = self.expression(expr)?;
        if value.is_finite() {
            Ok(value)
        } else {
            Err(Failure::new(
                FailureKind::Numeric(NumericError::NotFinite),
                expr.span,
            ))
        }
    }

    /// A system that an earlier value needed: how it was solved and its solution.
    pub fn solved(&self, system: usize) -> Option<&SolvedSystem> {
        self.solved.get(&system)
    }

    /// Runs `body` with an index bound to a value.
    pub fn with_bound<T>(
        &mut self,
        index: &Name,
        value: i64,
        body: impl FnOnce(&mut Self) -> T,
    ) -> T {
        self.bound.push((self.resolver.canonical(index), value));
        let result = body(self);
        self.bound.pop();
        result
    }

    pub(super) fn expression(&mut self, expr: &Expr) -> Result<Value, Failure> {
        if self.depth >= DEEPEST {
            return Err(Failure::new(FailureKind::Budget, expr.span));
        }
        self.depth += 1;
        let value = self.nested_expression(expr);
        self.depth -= 1;
        value
    }

    fn nested_expression(&mut self, expr: &Expr) -> Result<Value, Failure> {
        let span = expr.span;
        match &expr.kind {
            ExprKind::Number(number) => Ok(Value::Scalar(number.to_f64().unwrap_or(f64::NAN))),
            ExprKind::Name(name) => self.name(name, span),
            ExprKind::Apply {
                function,
                arguments,
            } if self.resolver.parameters(function).is_empty()
                && self.resolver.is_plain_application(function, arguments) =>
            {
                self.name(function, span)
            }
            ExprKind::Apply {
                function,
                arguments,
            } => self.apply(function, arguments, span),
            ExprKind::Cases(cases) => self.by_cases(cases, span),
            ExprKind::Integral {
                limits,
                body,
                variable,
            } => {
                let limits = limits.as_ref().map(|(from, to)| (&**from, &**to));
                self.integral(limits, body, variable, span)
            }
            ExprKind::Group { inner, .. } | ExprKind::Underbrace { body: inner, .. } => {
                self.expression(inner)
            }
            ExprKind::Sum(terms) => self.sum(terms),
            ExprKind::Product(factors) => self.product(factors, span),
            ExprKind::Quotient {
                numerator,
                denominator,
                ..
            } => self.quotient(numerator, denominator),
            ExprKind::Power { base, exponent } => self.power(base, exponent, span),
            ExprKind::Transpose(inner) => match self.expression(inner)? {
                Value::Scalar(_) if !latex::is_matrix_like(inner) => {
                    Err(Failure::unsupported(latex::SCALAR_TRANSPOSED, span))
                }
                value @ (Value::Scalar(_) | Value::Matrix(_) | Value::Zero) => {
                    Ok(value.transposed())
                }
            },
            ExprKind::Matrix { rows, .. } => self.matrix(rows, span),
            ExprKind::Call { function, argument } => self.call(*function, argument, span),
            ExprKind::BigSum {
                index,
                from,
                to,
                body,
            } => self.big_sum(index, [from, to], body, span),
            ExprKind::Tuple(_) => Err(Failure::unsupported("a tuple", span)),
            ExprKind::Named { .. } => Err(Failure::unsupported("a named argument", span)),
            ExprKind::Derivative { .. } => Err(Failure::unsupported("a derivative", span)),
            ExprKind::Expectation(_) => Err(Failure::unsupported("an expectation", span)),
            ExprKind::Infinity => Err(Failure::unsupported("infinity", span)),
            ExprKind::Constant => Err(Failure::unsupported("an unnamed constant", span)),
        }
    }

    fn sum(&mut self, terms: &[(Sign, Expr)]) -> Result<Value, Failure> {
        let mut sum = Value::Zero;
        for (sign, term) in terms {
            let value = self.expression(term)?;
            let signed = match sign {
                Sign::Plus => value,
                Sign::Minus => value.negated(),
            };
            sum = sum.add(signed, term.span)?;
        }
        Ok(sum)
    }

    fn quotient(&mut self, numerator: &Expr, denominator: &Expr) -> Result<Value, Failure> {
        let top = self.expression(numerator)?;
        let bottom = self.expression(denominator)?;
        top.divide(bottom, denominator.span)
    }

    fn matrix(&mut self, rows: &[Vec<Expr>], span: Span) -> Result<Value, Failure> {
        let mut blocks = Vec::with_capacity(rows.len());
        for row in rows {
            let mut values = Vec::with_capacity(row.len());
            for entry in row {
                values.push((self.expression(entry)?, entry.span));
            }
            blocks.push(values);
        }
        Value::from_blocks(&blocks, span)
    }

    fn big_sum(
        &mut self,
        index: &Name,
        [from, to]: [&Expr; 2],
        body: &Expr,
        span: Span,
    ) -> Result<Value, Failure> {
        let (from, to) = (self.integer(from)?, self.integer(to)?);
        if to.saturating_sub(from) >= LARGEST_RANGE {
            return Err(Failure::new(FailureKind::Budget, span));
        }
        if from > to {
            return Ok(Value::Scalar(0.0));
        }
        let mut sum = Value::Zero;
        for k in from..=to {
            let term = self.with_bound(index, k, |e| e.expression(body))?;
            sum = sum.add(term, body.span)?;
        }
        Ok(sum)
    }

    pub(super) fn product(&mut self, factors: &[Expr], span: Span) -> Result<Value, Failure> {
        let mut product: Option<Value> = None;
        for factor in factors {
            let value = self.expression(factor)?;
            product = Some(match product {
                None => value,
                Some(product) => product.multiply(value, factor.span)?,
            });
        }
        product.ok_or_else(|| Failure::unsupported("an empty product", span))
    }

    fn power(&mut self, base: &Expr, exponent: &Expr, span: Span) -> Result<Value, Failure> {
        let Ok(n) = self.integer(exponent) else {
            let base = self.expression(base)?;
            return match (base, self.expression(exponent)?) {
                (Value::Scalar(base), Value::Scalar(exponent)) => {
                    Ok(Value::Scalar(libm::pow(base, exponent)))
                }
                (base, exponent) => Err(Failure::shape("power", &base, &exponent, span)),
            };
        };
        let magnitude = u32::try_from(n.unsigned_abs()).unwrap_or(u32::MAX);
        let small = i32::try_from(n)
            .ok()
            .filter(|_| i64::from(magnitude) <= LARGEST_EXPONENT)
            .ok_or_else(|| Failure::new(FailureKind::Exponent, exponent.span))?;
        if let (ExprKind::Name(name), true) = (&base.kind, n > 0)
            && let Some((node, rest)) = self.resolver.power(name, magnitude)
        {
            let rest = i32::try_from(rest).unwrap_or(small);
            return self.node((node, Vec::new()), span)?.power(rest, span);
        }
        self.expression(base)?.power(small, span)
    }

    fn call(&mut self, function: Function, argument: &Expr, span: Span) -> Result<Value, Failure> {
        let value = self.expression(argument)?;
        let number = |image: fn(f64) -> f64, value: Value| {
            let x = value.into_number("function", span)?;
            Ok(Value::Scalar(image(x)))
        };
        let of_square = |value: Value| {
            let matrix = square(value, span)?;
            determinant(&matrix)
                .map(Value::Scalar)
                .map_err(|e| Failure::numeric(e, span))
        };
        match function {
            Function::Determinant => of_square(value),
            Function::Trace => Ok(Value::Scalar(square(value, span)?.trace())),
            // Bars around a matrix mean its determinant.
            Function::Absolute => match value {
                Value::Matrix(_) => of_square(value),
                Value::Scalar(_) | Value::Zero => number(f64::abs, value),
            },
            Function::RealPart => number(|x| x, value),
            Function::ImaginaryPart => number(|_| 0.0, value),
            Function::Cosine => number(libm::cos, value),
            Function::Sine => number(libm::sin, value),
            Function::Tangent => number(libm::tan, value),
            Function::Cotangent => number(|x| 1.0 / libm::tan(x), value),
            Function::HyperbolicCosine => number(libm::cosh, value),
            Function::HyperbolicSine => number(libm::sinh, value),
            Function::HyperbolicTangent => number(libm::tanh, value),
            Function::Exponential => number(libm::exp, value),
            Function::Logarithm => number(libm::log, value),
            Function::SquareRoot => number(f64::sqrt, value),
        }
    }

    pub(super) fn name(&mut self, name: &Name, span: Span) -> Result<Value, Failure> {
        let reference = {
            let bound = &self.bound;
            let is_bound = |index: &str| bound.iter().any(|(b, _)| b == index);
            self.resolver.resolve(name, &is_bound)
        };
        match reference {
            Reference::Bound(index) => self
                .bound_value(&index)
                .map(|v| Value::Scalar(v as f64))
                .ok_or_else(|| Failure::new(FailureKind::Undeclared { name: index }, span)),
            Reference::Node(node) => {
                let mut value = self.node((node, Vec::new()), span);
                if let Err(failure) = &mut value {
                    self.put_in_name(failure, name);
                }
                value
            }
            Reference::Indexed { family, indices } => self.indexed(&family, &indices, span),
            Reference::Undeclared => {
                let name = self.resolver.canonical(name);
                Err(Failure::new(FailureKind::Undeclared { name }, span))
            }
            Reference::WithoutValue => {
                let name = self.resolver.canonical(name);
                Err(Failure::new(FailureKind::WithoutValue { name }, span))
            }
        }
    }

    /// A letter's own name is known only where it was printed.
    fn put_in_name(&self, failure: &mut Failure, printed: &Name) {
        if let FailureKind::WithoutValue { name } = &mut failure.kind
            && name.is_empty()
        {
            *name = self.resolver.canonical(printed);
        }
    }

    fn indexed(&mut self, family: &str, indices: &[&Expr], span: Span) -> Result<Value, Failure> {
        let mut values = Vec::with_capacity(indices.len());
        for index in indices {
            values.push(self.integer(index)?);
        }
        let mut existing = Vec::new();
        for element in self.resolver.elements(family, &values) {
            let value = match element {
                Element::Member(node, indices) => self.node((node, indices), span),
                Element::Entry(node, indices) => self
                    .node((node, Vec::new()), span)
                    .and_then(|matrix| entry(matrix, &indices, span)),
            };
            match value {
                Err(failure) if matches!(failure.kind, FailureKind::Outside { .. }) => {}
                other => existing.push(other?),
            }
        }
        match existing.pop() {
            None => Err(outside(&values, span)),
            Some(value) if existing.is_empty() => Ok(value),
            Some(_) => Err(Failure::unsupported("an index with two readings", span)),
        }
    }

    fn bound_value(&self, index: &str) -> Option<i64> {
        self.bound
            .iter()
            .rev()
            .find(|(name, _)| name == index)
            .map(|(_, value)| *value)
    }

    /// The value of a node, computed once; nothing that used a trial value is kept.
    fn node(&mut self, key: Key<R::Node>, span: Span) -> Result<Value, Failure> {
        if let Some((_, number)) = self.replaced.iter().rev().find(|(n, _)| *n == key.0) {
            return Ok(Value::Scalar(*number));
        }
        if let Some(known) = self.known.get(&key) {
            self.by_method |= known.by_method;
            return Ok(known.value.clone());
        }
        let (node, indices) = &key;
        let meaning = self
            .resolver
            .meaning(*node, indices)
            .ok_or_else(|| outside(indices, span))?;
        if let Meaning::Unknown { system, position } = meaning {
            return self.unknown(system, position, span);
        }
        if !self.open.insert(key.clone()) {
            return Err(Failure::new(FailureKind::Cyclic, span));
        }
        let outer = std::mem::take(&mut self.bound);
        let before = (self.touched, self.by_method);
        (self.touched, self.by_method) = (false, false);
        let result = self.compute(meaning, &key.1, span);
        let (touched, by_method) = (self.touched, self.by_method);
        self.touched |= before.0;
        self.by_method |= before.1;
        self.bound = outer;
        self.open.remove(&key);
        let value = result?;
        if !touched {
            let value = value.clone();
            self.known.insert(key, Known { value, by_method });
        }
        Ok(value)
    }

    fn compute(
        &mut self,
        meaning: Meaning<'r>,
        indices: &[i64],
        span: Span,
    ) -> Result<Value, Failure> {
        match meaning {
            Meaning::Expression { expr, bound } => {
                self.bound = bound;
                self.expression(expr)
            }
            Meaning::Entry(of) => {
                let matrix = self.expression(of)?;
                entry(matrix, indices, span)
            }
            Meaning::CharacteristicCoefficient(of) => {
                let matrix = square(self.expression(of)?, span)?;
                characteristic_coefficient(&matrix, indices, span)
            }
            Meaning::HurwitzMatrix(of) => {
                let matrix = square(self.expression(of)?, span)?;
                let found = faddeev_leverrier(&matrix).map_err(|e| Failure::numeric(e, span))?;
                Ok(Value::from_matrix(hurwitz_matrix(&found.coefficients)))
            }
            Meaning::Cofactor(of) => {
                let matrix = square(self.expression(of)?, span)?;
                cofactor(&matrix, indices, span)
            }
            Meaning::LeadingMinor(of) => {
                let matrix = square(self.expression(of)?, span)?;
                leading_minor(&matrix, indices, span)
            }
            Meaning::Unknown { system, position } => self.unknown(system, position, span),
            Meaning::Number(Some(number)) => Ok(Value::Scalar(number)),
            Meaning::Number(None) => {
                let name = String::new();
                Err(Failure::new(FailureKind::WithoutValue { name }, span))
            }
            Meaning::Identity(n) => Ok(Value::from_matrix(DMatrix::identity(n, n))),
            Meaning::Zero => Ok(Value::Zero),
        }
    }

    /// The integer that an index or exponent evaluates to.
    fn integer(&self, expr: &Expr) -> Result<i64, Failure> {
        let letter = |name: &Name| self.bound_value(&self.resolver.canonical(name));
        integer::integer(expr, &letter)
            .map_err(|part| Failure::new(FailureKind::Exponent, part.span))
    }
}

/// The index at a position, where it counts the rows and columns of a matrix.
fn index_within(matrix: &DMatrix<f64>, indices: &[i64], position: usize) -> Option<usize> {
    let index = usize::try_from(*indices.get(position)?).ok()?;
    (1..=matrix.nrows()).contains(&index).then_some(index)
}

fn characteristic_coefficient(
    matrix: &DMatrix<f64>,
    indices: &[i64],
    span: Span,
) -> Result<Value, Failure> {
    let order = indices.first().and_then(|i| usize::try_from(*i).ok());
    let order = order.ok_or_else(|| outside(indices, span))?;
    let found = faddeev_leverrier(matrix).map_err(|e| Failure::numeric(e, span))?;
    // Beyond the degree a polynomial's coefficients are zero.
    let coefficient = found.coefficients.get(order).copied();
    Ok(Value::Scalar(coefficient.unwrap_or(0.0)))
}

fn cofactor(matrix: &DMatrix<f64>, indices: &[i64], span: Span) -> Result<Value, Failure> {
    let [row, column] = [0, 1].map(|at| index_within(matrix, indices, at));
    let (i, j) = row.zip(column).ok_or_else(|| outside(indices, span))?;
    let minor = matrix.clone().remove_row(i - 1).remove_column(j - 1);
    let value = determinant(&minor).map_err(|e| Failure::numeric(e, span))?;
    Ok(Value::Scalar(if (i + j) % 2 == 0 { value } else { -value }))
}

fn leading_minor(matrix: &DMatrix<f64>, indices: &[i64], span: Span) -> Result<Value, Failure> {
    let order = index_within(matrix, indices, 0).ok_or_else(|| outside(indices, span))?;
    let leading = matrix.view((0, 0), (order, order)).into_owned();
    let value = determinant(&leading).map_err(|e| Failure::numeric(e, span))?;
    Ok(Value::Scalar(value))
}

fn outside(indices: &[i64], span: Span) -> Failure {
    let indices = indices.to_vec();
    Failure::new(FailureKind::Outside { indices }, span)
}

fn square(value: Value, span: Span) -> Result<DMatrix<f64>, Failure> {
    match &value {
        Value::Scalar(s) => Ok(DMatrix::from_element(1, 1, *s)),
        Value::Matrix(m) if m.is_square() => Ok(m.clone()),
        Value::Matrix(_) | Value::Zero => Err(Failure::shape("determinant", &value, &value, span)),
    }
}

/// The entry with these indices, from 1; a vector may have one index.
fn entry(value: Value, indices: &[i64], span: Span) -> Result<Value, Failure> {
    let at = |k: i64| usize::try_from(k).ok()?.checked_sub(1);
    // Which entries the zero of any shape has is not known.
    let (rows, columns) = value
        .shape()
        .ok_or_else(|| Failure::unsupported("an entry of a zero without a shape", span))?;
    let place = match indices {
        [i, j] => at(*i).zip(at(*j)),
        [i] if columns == 1 => at(*i).map(|i| (i, 0)),
        [j] if rows == 1 => at(*j).map(|j| (0, j)),
        _ => None,
    };
    match (value, place) {
        (Value::Matrix(m), Some((i, j))) if i < rows && j < columns => Ok(Value::Scalar(m[(i, j)])),
        (Value::Scalar(s), Some((0, 0))) => Ok(Value::Scalar(s)),
        (Value::Matrix(_) | Value::Scalar(_) | Value::Zero, _) => Err(outside(indices, span)),
    }
}
