//! Expressions to exact values: the only bridge between the syntax tree and the polynomial engine.
//!
//! An [`Evaluator`] runs over any [`Domain`]. Values of names are computed once and kept with the
//! conditions under which they exist: every divisor is recorded before anything cancels.
//! Abbreviations (scalars defined by arithmetic on declared symbols) stay letters; inserting their
//! definitions is the checker's business.

mod cases;
mod change;
mod expectation;
mod failure;
mod function;
mod index;
mod nodes;
mod operations;
mod rate;
mod solve;
pub mod value;

use operations::p_span;

pub(crate) use change::Displaced;
pub use failure::{Failure, FailureKind};
pub use solve::Stationary;
pub use value::Value;

use crate::domain::Domain;
use crate::expr::{Display, Expr, ExprKind, Name, Sign};
use crate::functions::Supposed;
use crate::functions::integral::End;
use crate::model::names::Resolved;
use crate::model::{Model, Node};
use crate::span::Span;
use num_rational::BigRational;
use ratpoly::allowance;
use std::collections::{BTreeMap, BTreeSet};

/// The largest exponent that is evaluated.
pub const LARGEST_EXPONENT: u32 = 1000;
/// The largest number of terms that a sum with running index is evaluated for.
const LARGEST_RANGE: i64 = 10_000;
/// The longest chain of definitions that need each other.
const LONGEST_CHAIN: usize = 5_000;
/// The largest product of two operands' sizes (terms) that is multiplied out.
const LARGEST_PRODUCT: usize = 500_000;
/// The largest number of terms of sums inside of sums together.
const MOST_TERMS: u64 = 200_000;
/// The most bytes of values that are kept: then they are forgotten, and computed again where they are needed.
const MOST_KEPT: usize = 64 << 20;

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
}

/// What names a value: a node, its indices and how often it is differentiated.
pub type Key = (Node, Vec<i64>, u8);

/// The values of the two sides of a link.
pub type Sides<E> = (Value<E>, Value<E>);

/// A value with the conditions under which it exists.
#[derive(Clone, Debug)]
struct Known<E> {
    value: Value<E>,
    conditions: Vec<Condition<E>>,
}

/// Where a value may come from other than the document's own equations.
pub type Provider<'p, E> = dyn FnMut(&Key) -> Option<Result<Value<E>, Failure>> + 'p;

/// Evaluates the expressions of a model over a field.
pub struct Evaluator<'m, D: Domain> {
    /// The field.
    pub field: D,
    /// Conditions met since the caller last looked.
    pub conditions: Vec<Condition<D::Element>>,
    /// Reads a family's members outside its range as zero instead of refusing them.
    pub lenient: bool,
    /// Keeps abbreviations as letters.
    pub keep_abbreviations: bool,
    /// Which of the model's instances sizes are taken from.
    instance: usize,
    /// The number at which processes are taken, if at one.
    at: Option<BigRational>,
    model: &'m Model,
    letters: Vec<D::Element>,
    corrected: BTreeMap<usize, Display>,
    known: BTreeMap<Key, Known<D::Element>>,
    open: BTreeSet<Key>,
    trial: BTreeMap<(usize, usize), Value<D::Element>>,
    bound: Vec<(String, i64)>,
    /// How many terms the sums have together that are being added up.
    running: u64,
    /// About how many bytes the known values have.
    kept: usize,
    /// How many rows the next matrix should have where zeros of any shape leave that open.
    wanted_rows: Option<usize>,
    /// What the systems that are equations of a stationary state are about.
    stationary: BTreeMap<usize, Stationary<D::Element>>,
    /// Nodes that were found to have no value, and why.
    without_value: BTreeMap<Node, FailureKind>,
    provider: Option<Box<Provider<'m, D::Element>>>,
    /// Letters that stand for something else while a function's body is evaluated: the symbols,
    /// and what was computed with them so.
    replaced: Vec<function::Replaced<D::Element>>,
    /// The symbols that each node's value depends on.
    behind: BTreeMap<Node, BTreeSet<usize>>,
    /// How many integrals are open.
    integrals: usize,
    /// Which case of a definition by cases is taken, from 0.
    pub case: usize,
    /// How many cases the definitions met so far have; 0 where none was met.
    pub cases_met: usize,
    /// The product of the choices so far.
    radix: usize,
    /// What the cases chosen so far suppose; of no meaning where no case was met.
    supposed: Vec<Supposed<D::Element>>,
    /// Between what the variables of the open integrals lie.
    between: Vec<Supposed<D::Element>>,
    /// These variables with the ends of their integrals.
    open_integrals: Vec<(D::Element, End<D::Element>, End<D::Element>)>,
}

impl<'m, D: Domain> Evaluator<'m, D> {
    /// An evaluator with a value for each letter of the model's ring.
    ///
    /// # Panics
    /// When there is not one value for each letter: a programming error.
    pub fn new(model: &'m Model, field: D, letters: Vec<D::Element>) -> Self {
        assert_eq!(letters.len(), model.letters.len(), "one value per letter");
        Evaluator {
            field,
            conditions: Vec::new(),
            lenient: false,
            keep_abbreviations: true,
            instance: 0,
            at: None,
            model,
            letters,
            corrected: BTreeMap::new(),
            known: BTreeMap::new(),
            open: BTreeSet::new(),
            trial: BTreeMap::new(),
            bound: Vec::new(),
            running: 1,
            kept: 0,
            wanted_rows: None,
            stationary: BTreeMap::new(),
            without_value: BTreeMap::new(),
            provider: None,
            replaced: Vec::new(),
            behind: BTreeMap::new(),
            integrals: 0,
            case: 0,
            cases_met: 0,
            radix: 1,
            supposed: Vec::new(),
            between: Vec::new(),
            open_integrals: Vec::new(),
        }
    }

    /// Takes the values of names from `provider` where it has them.
    pub fn with_provider(mut self, provider: Box<Provider<'m, D::Element>>) -> Self {
        self.provider = Some(provider);
        self
    }

    /// Takes the sizes of matrices from one of the model's instances.
    #[must_use]
    pub fn in_instance(mut self, instance: usize) -> Self {
        self.instance = instance;
        self.known.clear();
        self
    }

    /// Which of the model's instances sizes are taken from.
    pub fn instance(&self) -> usize {
        self.instance
    }

    /// The value of each letter of the model's ring.
    pub fn letters(&self) -> &[D::Element] {
        &self.letters
    }

    /// Uses a corrected display in place of an equation's printed one.
    pub fn correct(&mut self, equation: usize, display: Display) {
        self.corrected.insert(equation, display);
        self.known.clear();
        self.behind.clear();
    }

    /// The display that an equation is evaluated from.
    pub fn display(&self, equation: usize) -> &Display {
        self.corrected
            .get(&equation)
            .unwrap_or(&self.model.equations[equation].display)
    }

    /// The display that stands in place of an equation's printed one, if one does.
    pub fn corrected_display(&self, equation: usize) -> Option<&Display> {
        self.corrected.get(&equation)
    }

    /// Another evaluator over the same field with the same letters, sizes and corrections, for which
    /// nothing has been computed yet.
    #[must_use]
    pub fn anew(&self) -> Self
    where
        D: Clone,
    {
        let mut anew = Evaluator::new(self.model, self.field.clone(), self.letters.clone());
        anew.instance = self.instance;
        anew.corrected = self.corrected.clone();
        anew.without_value = self.without_value.clone();
        anew
    }

    /// Another evaluator in the state that this one has between two expressions, for what may end in the
    /// middle of one; what was computed is computed again.
    #[must_use]
    pub(crate) fn spare(&self) -> Self
    where
        D: Clone,
    {
        let mut spare = self.anew();
        spare.lenient = self.lenient;
        spare.keep_abbreviations = self.keep_abbreviations;
        spare.stationary = self.stationary.clone();
        spare
    }

    /// The same with other values of the letters.
    #[must_use]
    pub fn with_letters(&self, letters: Vec<D::Element>) -> Self
    where
        D: Clone,
    {
        let mut other = self.anew();
        other.letters = letters;
        other
    }

    /// What a solved system is about, if it is the equation of a stationary state.
    pub fn stationary(&self, system: usize) -> Option<&Stationary<D::Element>> {
        self.stationary.get(&system)
    }

    /// Takes it that a node has no value, for this reason.
    pub(crate) fn has_no_value(&mut self, node: Node, kind: FailureKind) {
        if self.without_value.insert(node, kind).is_none() {
            self.known.clear();
        }
    }

    /// The nodes that have no value.
    pub(crate) fn without_value(&self) -> &BTreeMap<Node, FailureKind> {
        &self.without_value
    }

    /// Takes back what was found out about nodes without a value, for this.
    pub(crate) fn set_without_value(&mut self, nodes: BTreeMap<Node, FailureKind>) {
        if self.without_value != nodes {
            self.without_value = nodes;
            self.known.clear();
        }
    }

    /// The model.
    pub fn model(&self) -> &'m Model {
        self.model
    }

    /// The corrected displays, by equation.
    pub fn corrections(&self) -> impl Iterator<Item = (&usize, &Display)> {
        self.corrected.iter()
    }

    /// The value of a node.
    ///
    /// # Errors
    /// A [`Failure`] with its place, `span` where it has none of its own.
    pub fn value_of(&mut self, key: Key, span: Span) -> Result<Value<D::Element>, Failure> {
        self.node(key, span)
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

    /// Runs `body` with an index bound to a value.
    pub fn with_bound<T>(
        &mut self,
        index: &str,
        value: i64,
        body: impl FnOnce(&mut Self) -> T,
    ) -> T {
        self.bound.push((index.to_string(), value));
        let result = body(self);
        self.bound.pop();
        result
    }

    fn bound_value(&self, name: &str) -> Option<i64> {
        let sizes = &self.model.instances[self.instance];
        let size = || sizes.get(name).and_then(|n| i64::try_from(*n).ok());
        let bound = self.bound.iter().rev().find(|(n, _)| n == name);
        bound.map(|(_, v)| *v).or_else(size)
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
            ExprKind::Transpose(inner) => Ok(match self.expression(inner)? {
                Value::Matrix(m) => Value::Matrix(m.transpose()),
                other => other,
            }),
            ExprKind::Matrix { rows, .. } => self.matrix(rows, span),
            ExprKind::Call { function, argument } => self.call(*function, argument, span),
            ExprKind::BigSum {
                index,
                from,
                to,
                body,
            } => {
                let (from, to) = (self.bound_of_sum(from)?, self.bound_of_sum(to)?);
                let own = u64::try_from(to.saturating_sub(from).saturating_add(1)).unwrap_or(0);
                let together = self.running.saturating_mul(own.max(1));
                if to.saturating_sub(from) > LARGEST_RANGE || together > MOST_TERMS {
                    return Err(Failure::new(
                        FailureKind::Budget {
                            what: "terms of a sum".into(),
                        },
                        span,
                    ));
                }
                let index = crate::latex::canonical(index);
                let mut sum = Value::Zero;
                let outer = std::mem::replace(&mut self.running, together);
                for k in from..=to {
                    let term = self.with_bound(&index, k, |e| e.expression(body));
                    match term.and_then(|term| value::add(&self.field, &sum, &term, body.span)) {
                        Ok(longer) => sum = longer,
                        Err(failure) => {
                            self.running = outer;
                            return Err(failure);
                        }
                    }
                }
                self.running = outer;
                Ok(match sum {
                    Value::Zero if from > to => Value::Scalar(self.field.integer(0)),
                    sum => sum,
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
                    self.rate_of(body, *order, span)
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
        match &expr.kind {
            ExprKind::Name(name) if !self.is_bound(name) => {
                let mut dotted = name.clone();
                dotted.dots = dotted.dots.saturating_add(order);
                self.name(&dotted, span)
            }
            ExprKind::Group { inner, .. } | ExprKind::Underbrace { body: inner, .. } => {
                self.rate_of(inner, order, span)
            }
            ExprKind::Sum(terms) => {
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
                sum.ok_or_else(|| Failure::unsupported("an empty sum", span))
            }
            _ => {
                let value = self.expression(expr)?;
                self.differentiate(value, order, span)
            }
        }
    }

    /// Whether the name is an index or the letter of a size.
    fn is_bound(&self, name: &Name) -> bool {
        self.bound_value(&crate::latex::canonical(name)).is_some()
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
        if let Some(definition) = self.at.as_ref().and_then(|at| model.value_at(name, at)) {
            return self.given_value(definition, span);
        }
        let bound: Vec<String> = self.bound.iter().map(|(n, _)| n.clone()).collect();
        let sizes = &model.instances[self.instance];
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
