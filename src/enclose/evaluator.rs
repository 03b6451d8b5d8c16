//! Expressions at a point, by the meaning of their notation.
//!
//! Written from the specification of documents and from nothing else: the exact engine, its letters for
//! functions and its normal forms take no part, so that what both say is said twice. Invariants: a
//! value encloses what the expression means at the point; an expression without a value has a reason;
//! work and depth are bounded.

use super::arithmetic::Arithmetic;
use super::blocks::assembled;
use super::failure::{NoValue, Reason, Undefined};
use super::jet::Jet;
use super::letters::Layer;
use super::point::Point;
use super::value::{Value, misfit};
use super::world::{Known, World};
use crate::expr::{Expr, ExprKind, Function, Name, Sign, integer};
use crate::latex;
use crate::model::Node;
use crate::real::{Complex, Real};
use crate::span::Span;
use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;

/// The deepest nesting of expressions, through definitions too.
const DEEPEST: usize = 3_000;
/// The largest exponent that is multiplied out.
const LARGEST_EXPONENT: i64 = 10_000;
/// The largest number of terms of a sum.
const LARGEST_RANGE: i64 = 10_000;

pub(super) type Result<T> = std::result::Result<T, NoValue>;

/// What names a value: a node and its indices.
pub(super) type Key = (Node, Vec<i64>);

/// Evaluates the expressions of a world at a point.
pub struct Evaluator<'w, 'm> {
    pub(super) world: &'w World<'m>,
    pub(super) point: &'w Point,
    pub(super) arithmetic: Arithmetic,
    /// What letters stand for otherwise, the innermost last.
    pub(super) layers: Vec<Layer>,
    /// Values of names at the point itself.
    pub(super) known: BTreeMap<Key, Arc<Known>>,
    /// What is being computed, each with the number of its innermost layer.
    pub(super) open: BTreeSet<(Key, u64)>,
    pub(super) layers_so_far: u64,
    /// How many layers lie below the expectation that is being computed, if one is.
    pub(super) expected_above: Option<usize>,
    pub(super) bound: Vec<(String, i64)>,
    /// How many rows the next matrix should have where zeros of any shape leave that open.
    pub(super) wanted_rows: Option<usize>,
    /// Whether something was computed to few digits only, whatever the precision.
    pub(super) coarse: bool,
    /// The letters that were used, with their values.
    pub(super) used: BTreeMap<(usize, u8), Complex>,
    depth: usize,
}

impl<'w, 'm> Evaluator<'w, 'm> {
    /// An evaluator that keeps so many digits and does so much work.
    pub fn new(world: &'w World<'m>, point: &'w Point, bits: u32, work: u64) -> Self {
        Evaluator {
            world,
            point,
            arithmetic: Arithmetic::new(bits, work),
            layers: Vec::new(),
            known: BTreeMap::new(),
            open: BTreeSet::new(),
            layers_so_far: 0,
            expected_above: None,
            bound: Vec::new(),
            wanted_rows: None,
            coarse: false,
            used: BTreeMap::new(),
            depth: 0,
        }
    }

    /// The letters that values were computed from so far: symbol, order of its derivative, value.
    pub fn used(&self) -> impl Iterator<Item = (usize, u8, &Complex)> {
        self.used.iter().map(|((s, order), z)| (*s, *order, z))
    }

    /// Runs `body` with these indices bound.
    pub fn with_indices<T>(
        &mut self,
        indices: &[(String, i64)],
        body: impl FnOnce(&mut Self) -> T,
    ) -> T {
        let before = self.bound.len();
        self.bound.extend(indices.iter().cloned());
        let result = body(self);
        self.bound.truncate(before);
        result
    }

    /// The value of an expression.
    ///
    /// # Errors
    /// Why there is none.
    pub fn expression(&mut self, expr: &Expr) -> Result<Value> {
        if self.depth >= DEEPEST {
            return Err(Reason::Budget("nested expressions").at(expr.span));
        }
        self.arithmetic.spend(1).map_err(|r| r.at(expr.span))?;
        self.depth += 1;
        let value = self.nested(expr);
        self.depth -= 1;
        value
    }

    fn nested(&mut self, expr: &Expr) -> Result<Value> {
        let span = expr.span;
        let unsupported = |what| Err(Reason::Unsupported(what).at(span));
        match &expr.kind {
            ExprKind::Number(number) => {
                Ok(Value::Scalar(Jet::from(Real::rational(number.clone()))))
            }
            ExprKind::Name(name) => self.name(name, span),
            ExprKind::Apply {
                function,
                arguments,
            } => self.apply(function, arguments, span),
            ExprKind::Group { inner, .. } | ExprKind::Underbrace { body: inner, .. } => {
                self.expression(inner)
            }
            ExprKind::Call { function, argument } => self.call(*function, argument, span),
            ExprKind::Sum(terms) => self.sum(terms, span),
            ExprKind::Product(factors) => self.product(factors, span),
            ExprKind::Quotient {
                numerator,
                denominator,
                ..
            } => {
                let above = self.expression(numerator)?;
                let below = self.expression(denominator)?;
                let below = match below {
                    Value::Scalar(below) => below,
                    Value::Zero => return Err(Reason::Undefined(Undefined::Divisor).at(span)),
                    Value::Matrix(_) => return unsupported("division by a matrix"),
                };
                // A zero of any shape has no quotient by what has none.
                let one = Jet::integer(1);
                match above {
                    Value::Scalar(above) => {
                        self.arithmetic.divide(&above, &below).map(Value::Scalar)
                    }
                    Value::Matrix(_) | Value::Zero => self
                        .arithmetic
                        .divide(&one, &below)
                        .and_then(|i| self.arithmetic.product(&Value::Scalar(i), &above)),
                }
                .map_err(|r| r.at(denominator.span))
            }
            ExprKind::Power { base, exponent } => self.power(base, exponent, span),
            ExprKind::Transpose(inner) => match self.expression(inner)? {
                Value::Scalar(_) if !latex::is_matrix_like(inner) => {
                    unsupported(latex::SCALAR_TRANSPOSED)
                }
                value @ (Value::Scalar(_) | Value::Matrix(_) | Value::Zero) => {
                    Ok(value.transposed())
                }
            },
            ExprKind::Matrix { rows, .. } => self.matrix(rows, span),
            ExprKind::BigSum {
                index,
                from,
                to,
                body,
            } => self.big_sum(index, [from, to], body, span),
            ExprKind::Integral {
                limits,
                body,
                variable,
            } => match limits {
                Some((from, to)) => self.integral([from, to], body, variable, span),
                None => unsupported("an integral without limits"),
            },
            ExprKind::Derivative {
                order,
                variable,
                body,
            } => self.derivative(*order, variable.as_ref(), body, span),
            ExprKind::Cases(cases) => self.by_cases(cases, span),
            ExprKind::Named { .. } => unsupported("an argument by name"),
            ExprKind::Tuple(_) => unsupported("a tuple"),
            ExprKind::Expectation(inner) => self.expectation(inner, span),
            ExprKind::Infinity => unsupported("infinity"),
            ExprKind::Constant => unsupported("an unnamed constant"),
        }
    }

    /// The number that an expression is.
    pub(super) fn scalar(&mut self, expr: &Expr) -> Result<Jet> {
        let value = self.expression(expr)?;
        let misfit = misfit("argument", &value, &value);
        value.into_scalar().ok_or_else(|| misfit.at(expr.span))
    }

    fn sum(&mut self, terms: &[(Sign, Expr)], span: Span) -> Result<Value> {
        let mut sum: Option<Value> = None;
        for (sign, term) in terms {
            let mut value = self.expression(term)?;
            // A block of zeros of any shape, as in `[0; g] w`, has as many rows as the sum needs.
            if let (Some(Value::Matrix(s)), Value::Matrix(m)) = (&sum, &value)
                && s.rows() != m.rows()
                && s.columns() == m.columns()
            {
                self.wanted_rows = Some(s.rows());
                let fitted = self.expression(term);
                self.wanted_rows = None;
                value = fitted?;
            }
            let signed = match sign {
                Sign::Plus => value,
                Sign::Minus => value.negated(),
            };
            sum = Some(match sum {
                None => signed,
                Some(sum) => self
                    .arithmetic
                    .sum(&sum, &signed)
                    .map_err(|r| r.at(term.span))?,
            });
        }
        sum.ok_or_else(|| Reason::Unsupported("an empty sum").at(span))
    }

    fn product(&mut self, factors: &[Expr], span: Span) -> Result<Value> {
        let mut product: Option<Value> = None;
        for factor in factors {
            let value = self.expression(factor)?;
            product = Some(match product {
                None => value,
                Some(product) => self
                    .arithmetic
                    .product(&product, &value)
                    .map_err(|r| r.at(factor.span))?,
            });
        }
        product.ok_or_else(|| Reason::Unsupported("an empty product").at(span))
    }

    fn big_sum(
        &mut self,
        index: &Name,
        [from, to]: [&Expr; 2],
        body: &Expr,
        span: Span,
    ) -> Result<Value> {
        let (from, to) = (self.integer(from)?, self.integer(to)?);
        if to.saturating_sub(from) >= LARGEST_RANGE {
            return Err(Reason::Budget("terms of a sum").at(span));
        }
        let index = latex::canonical(index);
        let mut sum = Value::Zero;
        for k in from..=to {
            let term = self.with_indices(&[(index.clone(), k)], |e| e.expression(body))?;
            sum = self
                .arithmetic
                .sum(&sum, &term)
                .map_err(|r| r.at(body.span))?;
        }
        Ok(if from > to {
            Value::Scalar(Jet::zero())
        } else {
            sum
        })
    }

    fn power(&mut self, base: &Expr, exponent: &Expr, span: Span) -> Result<Value> {
        let Ok(n) = self.integer(exponent) else {
            return self.general_power(base, exponent, span);
        };
        let small = i32::try_from(n)
            .ok()
            .filter(|_| n.abs() <= LARGEST_EXPONENT);
        let small =
            small.ok_or_else(|| Reason::Budget("the exponent of a power").at(exponent.span))?;
        if let (ExprKind::Name(name), Ok(positive)) = (&base.kind, u32::try_from(n))
            && positive > 0
            && let Some((node, rest)) = self.world.model.power_node(name, positive)
        {
            let value = self.node((node, Vec::new()), span)?;
            let rest = i32::try_from(rest).unwrap_or(small);
            return self.power_of(&value, rest, span);
        }
        let value = self.expression(base)?;
        self.power_of(&value, small, span)
    }

    fn power_of(&mut self, value: &Value, n: i32, span: Span) -> Result<Value> {
        match value {
            Value::Scalar(x) => self.arithmetic.integer_power(x, n).map(Value::Scalar),
            Value::Matrix(m) if m.is_square() => {
                self.arithmetic.matrix_power(m, n).map(Value::from_matrix)
            }
            Value::Matrix(_) => Err(misfit("power", value, value)),
            Value::Zero if n > 0 => Ok(Value::Zero),
            Value::Zero => Err(Reason::Undefined(Undefined::Divisor)),
        }
        .map_err(|r| r.at(span))
    }

    fn general_power(&mut self, base: &Expr, exponent: &Expr, span: Span) -> Result<Value> {
        let y = self.scalar(exponent)?;
        if let ExprKind::Name(name) = &base.kind
            && self.is_euler(name)
        {
            let value = self.arithmetic.exponential(&y);
            return value.map(Value::Scalar).map_err(|r| r.at(span));
        }
        match self.expression(base)? {
            Value::Scalar(x) => self
                .arithmetic
                .power(&x, &y)
                .map(Value::Scalar)
                .map_err(|r| r.at(span)),
            Value::Matrix(_) | Value::Zero => {
                Err(Reason::Unsupported("such a power of a matrix").at(span))
            }
        }
    }

    fn matrix(&mut self, rows: &[Vec<Expr>], span: Span) -> Result<Value> {
        let wanted = self.wanted_rows.take();
        let mut blocks: Vec<Vec<Value>> = Vec::with_capacity(rows.len());
        for row in rows {
            blocks.push(
                row.iter()
                    .map(|e| self.expression(e))
                    .collect::<Result<_>>()?,
            );
        }
        assembled(&blocks, wanted).map_err(|reason| reason.at(span))
    }

    fn call(&mut self, function: Function, argument: &Expr, span: Span) -> Result<Value> {
        let value = self.expression(argument)?;
        let fail = |reason: Reason| reason.at(span);
        let a = &self.arithmetic;
        let bars = function == Function::Absolute && matches!(value, Value::Matrix(_));
        if bars || function == Function::Determinant {
            let matrix = value.square("determinant").map_err(fail)?;
            return a.determinant(&matrix).map(Value::Scalar).map_err(fail);
        }
        if function == Function::Trace {
            let matrix = value.square("trace").map_err(fail)?;
            return Ok(Value::Scalar(a.trace(&matrix)));
        }
        let shape = misfit("function", &value, &value);
        let x = match value {
            Value::Scalar(x) => x,
            Value::Zero | Value::Matrix(_) => return Err(fail(shape)),
        };
        // Bars around one entry of a matrix may mean its determinant: they agree unless it is negative.
        let entry = function == Function::Absolute && looks_like_a_matrix(argument);
        if entry && x.number().re.sign().is_none_or(|s| s.is_lt()) {
            return Err(fail(Reason::Unsupported(
                "bars that may mean a determinant",
            )));
        }
        let not_analytic = matches!(
            function,
            Function::RealPart | Function::ImaginaryPart | Function::Absolute
        );
        if not_analytic && x.as_number().is_none() && self.differentiates_by_complex() {
            return Err(fail(Reason::Unsupported(
                "a complex derivative of what is not analytic",
            )));
        }
        match function {
            Function::RealPart => Ok(x.real_part()),
            Function::ImaginaryPart => Ok(x.imaginary_part()),
            Function::Cosine => a.cosine_and_sine(&x).map(|(cosine, _)| cosine),
            Function::Sine => a.cosine_and_sine(&x).map(|(_, sine)| sine),
            Function::Tangent => a.tangent(&x),
            Function::Cotangent => a
                .cosine_and_sine(&x)
                .and_then(|(cosine, sine)| a.divide(&cosine, &sine)),
            Function::HyperbolicCosine => a.hyperbolic(&x).map(|(cosh, _)| cosh),
            Function::HyperbolicSine => a.hyperbolic(&x).map(|(_, sinh)| sinh),
            Function::HyperbolicTangent => a.hyperbolic_tangent(&x),
            Function::Exponential => a.exponential(&x),
            Function::Logarithm => a.logarithm(&x),
            Function::SquareRoot => a.square_root(&x),
            Function::Absolute => a.absolute(&x),
            Function::Determinant | Function::Trace => Ok(x),
        }
        .map(Value::Scalar)
        .map_err(fail)
    }

    /// The integer that an index or exponent is: literal integers, bound letters, sizes.
    pub(super) fn integer(&self, expr: &Expr) -> Result<i64> {
        let letter = |name: &Name| self.bound_value(&latex::canonical(name));
        integer::integer(expr, &letter)
            .map_err(|part| Reason::Unsupported("an index that is no integer").at(part.span))
    }

    pub(super) fn bound_value(&self, name: &str) -> Option<i64> {
        let bound = self.bound.iter().rev().find(|(n, _)| n == name);
        bound
            .map(|(_, value)| *value)
            .or_else(|| self.world.size(name))
    }
}

/// Whether an expression is printed as matrices are.
fn looks_like_a_matrix(expr: &Expr) -> bool {
    let mut bold = false;
    super::world::each(expr, &mut |e| {
        bold |= matches!(e.kind, ExprKind::Matrix { .. })
            || e.as_name().is_some_and(|name| {
                name.letter.font == crate::expr::Font::Bold && name.subscript.is_none()
            });
    });
    bold
}
