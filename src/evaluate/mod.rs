//! Expressions to exact values: the only bridge between the syntax tree and the polynomial engine.
//!
//! An [`Evaluator`] runs over any [`Domain`]. Values of names are computed once and kept with the
//! conditions under which they exist: every divisor is recorded before anything cancels.
//! Abbreviations (scalars defined by arithmetic on declared symbols) stay letters; inserting their
//! definitions is the checker's business.

#![warn(clippy::wildcard_enum_match_arm)]

mod cases;
mod expectation;
mod failure;
mod frame;
mod function;
mod index;
mod linear;
mod memo;
mod nodes;
mod operations;
mod own;
mod rate;
mod solve;
pub mod value;
mod world;

use cases::Choice;
use frame::Frame;
use memo::Memo;
use operations::p_span;

pub use failure::{Failure, FailureKind};
pub use solve::Stationary;
pub use value::Value;
pub use world::World;

use crate::domain::Domain;
use crate::expr::{Display, Expr, ExprKind, Name, Sign};
use crate::latex;
use crate::model::names::Resolved;
use crate::model::{Letter, Model, Node};
use crate::span::Span;
use ratpoly::{RationalFunction, allowance};
use std::collections::BTreeSet;

/// The largest exponent that is evaluated.
pub const LARGEST_EXPONENT: u32 = 10_000;
/// The largest number of terms that a sum with running index is evaluated for.
const LARGEST_RANGE: i64 = 10_000;
/// The longest chain of definitions that need each other.
const LONGEST_CHAIN: usize = 5_000;
/// The largest product of two operands' sizes (terms) that is multiplied out.
const LARGEST_PRODUCT: usize = 500_000;

/// A divisor that must not vanish.
#[derive(Clone, Debug, PartialEq)]
pub struct Condition<E> {
    /// What must not be zero.
    pub divisor: E,
    /// Why.
    pub origin: Origin,
}

/// Why something must not be zero.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Origin {
    /// It is divided by here.
    Divisor(Span),
    /// It is the determinant of the linear system that this equation poses (an index into the
    /// model's equations).
    Determinant(usize),
    /// It must even be positive for the covariance that this equation determines to exist.
    Stability(usize),
    /// It must not be negative for the argument of a function to lie in the range of its definition, and
    /// positive where the end does not belong to the range.
    Range {
        /// Where the function is applied.
        span: Span,
        /// Whether the end is left out.
        strict: bool,
    },
}

/// The letters of a model's ring, each standing for itself.
pub(crate) fn letters_themselves(model: &Model) -> Vec<RationalFunction> {
    (0..model.letters.len())
        .map(|i| RationalFunction::variable(model.ring, i))
        .collect()
}

/// The document as printed over the rational functions in the letters of the model's ring.
pub(crate) fn symbolic(model: &Model) -> World<'_, RationalFunction> {
    World::new(model, letters_themselves(model))
}

/// What names a value: a node, its indices and how often it is differentiated.
pub type Key = (Node, Vec<i64>, u8);

/// The values of the two sides of a link.
pub type Sides<E> = (Value<E>, Value<E>);

/// Where a value may come from other than the document's own equations.
pub type Provider<'p, E> = dyn FnMut(&Key) -> Option<Result<Value<E>, Failure>> + 'p;

/// Evaluates the expressions of a model over a field, in one world.
pub struct Evaluator<'m, D: Domain> {
    /// The field.
    pub field: D,
    /// Conditions met since the caller last looked.
    pub conditions: Vec<Condition<D::Element>>,
    model: &'m Model,
    world: World<'m, D::Element>,
    memo: Memo<D::Element>,
    frame: Frame<D::Element>,
    choice: Choice<D::Element>,
    provider: Option<Box<Provider<'m, D::Element>>>,
}

impl<'m, D: Domain> Evaluator<'m, D> {
    /// An evaluator that has computed nothing yet.
    pub fn new(field: D, world: World<'m, D::Element>) -> Self {
        Evaluator {
            field,
            conditions: Vec::new(),
            model: world.model(),
            world,
            memo: Memo::default(),
            frame: Frame::default(),
            choice: Choice::default(),
            provider: None,
        }
    }

    /// Takes the values of names from `provider` where it has them.
    pub fn with_provider(mut self, provider: Box<Provider<'m, D::Element>>) -> Self {
        self.provider = Some(provider);
        self
    }

    /// The same with members outside of a family's range read as zero.
    #[must_use]
    pub fn leniently(self) -> Self {
        Evaluator {
            world: self.world.leniently(),
            memo: Memo::default(),
            ..self
        }
    }

    /// What values are computed from.
    pub fn world(&self) -> &World<'m, D::Element> {
        &self.world
    }

    /// The model.
    pub fn model(&self) -> &'m Model {
        self.model
    }

    /// The display that an equation is evaluated from.
    pub fn display(&self, equation: usize) -> &Display {
        self.world.display(equation)
    }

    /// Another evaluator over the same field in the same world, for which nothing has been computed yet.
    #[must_use]
    pub fn anew(&self) -> Self
    where
        D: Clone,
    {
        self.in_world(self.world.clone())
    }

    /// One in another world.
    #[must_use]
    pub fn in_world(&self, world: World<'m, D::Element>) -> Self
    where
        D: Clone,
    {
        Evaluator::new(self.field.clone(), world)
    }

    /// One in the world with a display in place of an equation's.
    #[must_use]
    pub fn corrected(&self, equation: usize, display: Display) -> Self
    where
        D: Clone,
    {
        self.in_world(self.world.clone().corrected(equation, display))
    }

    /// The same, where what has been computed is known still but for these nodes, which are all whose
    /// values depend on the equation.
    #[must_use]
    pub fn changed(&self, equation: usize, display: Display, stale: &BTreeSet<Node>) -> Self
    where
        D: Clone,
    {
        Evaluator {
            memo: self.memo.without(stale),
            ..self.corrected(equation, display)
        }
    }

    /// The values of the abbreviations in the declared symbols, by letter, of those that have one.
    pub(crate) fn abbreviations(&self) -> Vec<(usize, D::Element)>
    where
        D: Clone,
    {
        let mut expanding = self.in_world(self.world.clone().inserting());
        let mut found = Vec::new();
        for (letter, kind) in self.model.letters.iter().enumerate() {
            if let Letter::Abbreviation { definition } = kind {
                let key = (Node::Definition(*definition), Vec::new(), 0);
                if let Ok(Value::Scalar(value)) = expanding.value_of(key, Span::default()) {
                    found.push((letter, value));
                }
            }
        }
        found
    }

    /// What a solved system is about, if it is the equation of a stationary state.
    pub fn stationary(&self, system: usize) -> Option<&Stationary<D::Element>> {
        self.memo.stationary(system)
    }

    /// The value of a node.
    ///
    /// # Errors
    /// A [`Failure`] with its place, `span` where it has none of its own.
    pub fn value_of(&mut self, key: Key, span: Span) -> Result<Value<D::Element>, Failure> {
        self.node(key, span)
    }

    /// The value of an expression.
    ///
    /// # Errors
    /// A [`Failure`] with its place.
    pub fn expression(&mut self, expr: &Expr) -> Result<Value<D::Element>, Failure> {
        let span = expr.span;
        allowance::spend(self.field.node_steps());
        match &expr.kind {
            ExprKind::Number(number) => self
                .field
                .rational(number)
                .map(Value::Scalar)
                .ok_or_else(|| Failure::new(FailureKind::DivisionByZero, span)),
            ExprKind::Name(name) => self.name(name, span),
            ExprKind::Apply {
                function,
                arguments,
            } => self.apply(function, arguments, span),
            ExprKind::Group { inner, .. } | ExprKind::Underbrace { body: inner, .. } => {
                self.expression(inner)
            }
            ExprKind::Sum(terms) => self.sum(terms, span),
            ExprKind::Product(factors) => {
                let mut product: Option<Value<D::Element>> = None;
                for factor in factors {
                    let value = self.expression(factor)?;
                    product = Some(match product {
                        None => value,
                        Some(p) => self.multiply(&p, &value, p_span(factors, factor))?,
                    });
                }
                product.ok_or_else(|| Failure::unsupported("an empty product", span))
            }
            ExprKind::Quotient {
                numerator,
                denominator,
                ..
            } => self.quotient(numerator, denominator),
            ExprKind::Power { base, exponent } => self.power(base, exponent, span),
            ExprKind::Transpose(inner) => match self.expression(inner)? {
                Value::Matrix(m) => Ok(Value::Matrix(m.transpose())),
                Value::Scalar(_) if !latex::is_matrix_like(inner) => {
                    Err(Failure::unsupported(latex::SCALAR_TRANSPOSED, span))
                }
                value @ (Value::Scalar(_) | Value::Zero) => Ok(value),
            },
            ExprKind::Matrix { rows, .. } => self.matrix(rows, span),
            ExprKind::Call { function, argument } => self.call(*function, argument, span),
            ExprKind::BigSum {
                index,
                from,
                to,
                body,
            } => {
                let (from, to) = (self.bound_of_sum(from)?, self.bound_of_sum(to)?);
                let terms = to.saturating_sub(from).saturating_add(1);
                if terms > LARGEST_RANGE {
                    let what = "terms of a sum".into();
                    return Err(Failure::new(FailureKind::Budget { what }, span));
                }
                let index = crate::latex::canonical(index);
                let terms = u64::try_from(terms).unwrap_or(0);
                let sum = self.with_terms(terms, span, |e| {
                    let mut sum = Value::Zero;
                    for k in from..=to {
                        let term = e.with_bound(&index, k, |e| e.expression(body))?;
                        sum = value::add(&e.field, &sum, &term, body.span)?;
                    }
                    Ok(sum)
                })?;
                Ok(if from > to {
                    Value::Scalar(self.field.integer(0))
                } else {
                    sum
                })
            }
            ExprKind::Derivative {
                order,
                variable,
                body,
            } => match variable {
                Some(letter) if !self.is_time(Some(letter)) => {
                    self.derivative(*order, letter, body, span)
                }
                _ => {
                    self.one_time(variable.as_ref(), body, span)?;
                    self.nothing_held_fixed(body, span)?;
                    self.smooth(span, |e| e.rate_of(body, *order, span))
                }
            },
            ExprKind::Named { .. } => Err(Failure::unsupported("an argument by name", span)),
            ExprKind::Tuple(_) => Err(Failure::unsupported("a tuple", span)),
            ExprKind::Integral {
                limits,
                body,
                variable,
            } => {
                let limits = limits.as_ref().map(|(from, to)| (&**from, &**to));
                self.integral(limits, body, variable, span)
            }
            ExprKind::Expectation(inner) => self.expectation(inner, span),
            ExprKind::Cases(cases) => self.by_cases(cases, span),
            ExprKind::Infinity => Err(Failure::unsupported("infinity", span)),
            ExprKind::Constant => Err(Failure::unsupported("an unnamed constant", span)),
        }
    }

    /// Both sides of a link. That something is a constant says that its time derivative is zero.
    ///
    /// # Errors
    /// A [`Failure`] with its place.
    pub fn sides(&mut self, left: &Expr, right: &Expr) -> Result<Sides<D::Element>, Failure> {
        match (&left.kind, &right.kind) {
            (ExprKind::Constant, ExprKind::Constant) => Ok((Value::Zero, Value::Zero)),
            (_, ExprKind::Constant) => Ok((self.rate_of_constant(left)?, Value::Zero)),
            (ExprKind::Constant, _) => Ok((Value::Zero, self.rate_of_constant(right)?)),
            _ => Ok((self.expression(left)?, self.expression(right)?)),
        }
    }

    /// The total time derivative of an expression, term by term where it is a sum: the derivative of
    /// a name is the name with a dot, which has a value over fields without letters too.
    fn rate_of(
        &mut self,
        expr: &Expr,
        order: u8,
        span: Span,
    ) -> Result<Value<D::Element>, Failure> {
        if let Some(name) = expr.as_name()
            && !self.is_bound(name)
        {
            let mut dotted = name.clone();
            dotted.dots = dotted.dots.saturating_add(order);
            return self.name(&dotted, span);
        }
        if let ExprKind::Group { inner, .. } | ExprKind::Underbrace { body: inner, .. } = &expr.kind
        {
            return self.rate_of(inner, order, span);
        }
        if let ExprKind::Sum(terms) = &expr.kind {
            let mut sum: Option<Value<D::Element>> = None;
            for (sign, term) in terms {
                let mut rate = self.rate_of(term, order, span)?;
                if *sign == Sign::Minus {
                    rate = value::negate(&self.field, &rate);
                }
                sum = Some(match sum {
                    None => rate,
                    Some(s) => value::add(&self.field, &s, &rate, term.span)?,
                });
            }
            return sum.ok_or_else(|| Failure::unsupported("an empty sum", span));
        }
        // Whatever else is printed is differentiated by its value.
        let value = self.expression(expr)?;
        self.differentiate(value, order, span)
    }

    /// The time derivative of what is said to be constant.
    fn rate_of_constant(&mut self, expr: &Expr) -> Result<Value<D::Element>, Failure> {
        if self.model.times.is_empty() {
            let what = "a constant where nothing is the time";
            return Err(Failure::unsupported(what, expr.span));
        }
        self.one_time(None, expr, expr.span)?;
        self.rate_of(expr, 1, expr.span)
    }

    /// Whether a derivative by this variable is the one that dots mean: no variable is printed, or
    /// a time of the document.
    pub(super) fn is_time(&self, variable: Option<&Name>) -> bool {
        variable.is_none_or(|name| self.model.is_time(name))
    }

    fn name(&mut self, name: &Name, span: Span) -> Result<Value<D::Element>, Failure> {
        let model = self.model;
        if let Some(definition) = self
            .frame
            .at
            .as_ref()
            .and_then(|at| model.value_at(name, at))
        {
            return self.given_value(definition, span);
        }
        let bound: Vec<String> = self.frame.bound.iter().map(|(n, _)| n.clone()).collect();
        let sizes = &model.instances[self.world.instance()];
        let resolved = model
            .resolve(name, &|n| {
                bound.iter().any(|b| b == n) || sizes.contains_key(n)
            })
            .map_err(|_| {
                let name = crate::latex::canonical(name);
                if model.has_power_of(&name) {
                    Failure::unsupported("a name of which only a power is defined", span)
                } else {
                    Failure::new(FailureKind::Undeclared { name }, span)
                }
            })?;
        match resolved {
            Resolved::Bound(index) => self
                .bound_value(&index)
                .map(|v| Value::Scalar(self.field.integer(v)))
                .ok_or_else(|| Failure::new(FailureKind::Undeclared { name: index }, span)),
            Resolved::Letter { symbol, order } => self.symbol(symbol, order, span),
            Resolved::Node { node, derivatives } => {
                self.node((node, Vec::new(), derivatives), span)
            }
            Resolved::Primed { node, primes } => {
                self.derivative_by_argument(node, primes, None, span)
            }
            Resolved::Indexed { key, indices } => {
                let mut values = Vec::with_capacity(indices.len());
                for index in indices {
                    values.push(self.integer(index)?);
                }
                self.element(&key, &values, span)
            }
        }
    }
}
