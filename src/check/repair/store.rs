//! Expressions shared by structure, with their values modulo the prime.
//!
//! Equal subexpressions are one node (hash-consing; A. P. Ershov, 1958), and each node has its value
//! computed once for each assignment of the bound indices it depends on. A candidate that differs
//! from the printed equation in one place costs the few new nodes from there to the root.
//!
//! What is neither arithmetic nor a matrix of scalars is left to the evaluator, node by node.

use super::evaluators::Exact;
use super::images::Images;
use crate::domain::{Domain, PRIME, PrimeField};
use crate::evaluate::{Evaluator, Failure, FailureKind, Value, value};
use crate::expr::{Display, Expr, ExprKind, Name, Sign};
use crate::latex;
use crate::matrix::Matrix;
use crate::model::links::{each_expression, visit};
use crate::model::names::literal_integer;
use crate::span::Span;
use num_rational::BigRational;
use std::collections::{BTreeSet, HashMap};
use std::rc::Rc;

/// A node.
pub(super) type Id = usize;
/// An assignment of the bound indices; 0 is the empty one.
pub(super) type Env = usize;

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
            _ => None,
        }
    }
}

/// What a node is made of.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub(super) enum Shape {
    Number(BigRational),
    Name(Name),
    Sum(Vec<(Sign, Id)>),
    Product(Vec<Id>),
    Quotient(Id, Id),
    Power(Id, i64),
    Transpose(Id),
    Matrix(usize, Vec<Id>),
    /// The index, and the expressions of its limits.
    Running(Name, usize, usize, Id),
    /// Anything else.
    Whole(usize),
}

struct Node {
    shape: Rc<Shape>,
    /// Whether a bound index occurs.
    bound: bool,
    /// The matrix, in case its entries are blocks.
    expr: Option<Rc<Expr>>,
}

/// The nodes and their values.
pub(super) struct Store<'m> {
    pub evaluator: Evaluator<'m, PrimeField>,
    /// For what has a value only as a letter of a function.
    exact: Option<(Exact<'m>, Rc<Images>)>,
    nodes: Vec<Node>,
    of_shape: HashMap<Shape, Id>,
    of_name: HashMap<Name, Id>,
    expressions: Vec<Rc<Expr>>,
    of_text: HashMap<String, usize>,
    indices: BTreeSet<String>,
    envs: Vec<Vec<(String, i64)>>,
    closed: Vec<Option<Residue>>,
    open: HashMap<(Id, Env), Residue>,
}

impl<'m> Store<'m> {
    /// An empty store for the expressions of a display.
    pub fn new(
        display: &Display,
        evaluator: Evaluator<'m, PrimeField>,
        exact: Option<(Exact<'m>, Rc<Images>)>,
    ) -> Self {
        let mut indices = BTreeSet::new();
        for clause in &display.clauses {
            indices.extend(clause.ranges.iter().map(|r| latex::canonical(&r.index)));
        }
        each_expression(display, &mut |e| {
            if let ExprKind::BigSum { index, .. } = &e.kind {
                indices.insert(latex::canonical(index));
            }
        });
        Store {
            evaluator,
            exact,
            nodes: Vec::new(),
            of_shape: HashMap::new(),
            of_name: HashMap::new(),
            expressions: Vec::new(),
            of_text: HashMap::new(),
            indices,
            envs: vec![Vec::new()],
            closed: Vec::new(),
            open: HashMap::new(),
        }
    }

    /// The assignment of these indices.
    pub fn env(&mut self, indices: &[(String, i64)]) -> Env {
        match self.envs.iter().position(|e| e == indices) {
            Some(env) => env,
            None => {
                self.envs.push(indices.to_vec());
                self.envs.len() - 1
            }
        }
    }

    /// What a node is made of.
    pub fn shape(&self, id: Id) -> Rc<Shape> {
        Rc::clone(&self.nodes[id].shape)
    }

    /// The node of an expression.
    pub fn node(&mut self, expr: &Expr) -> Id {
        match &expr.kind {
            ExprKind::Group { inner, .. } | ExprKind::Underbrace { body: inner, .. } => {
                self.node(inner)
            }
            ExprKind::Name(name) => match self.of_name.get(name) {
                Some(id) => *id,
                None => {
                    let id = self.add(Shape::Name(name.clone()), Some(expr));
                    self.of_name.insert(name.clone(), id);
                    id
                }
            },
            ExprKind::Number(number) => self.shared(Shape::Number(number.clone()), None),
            ExprKind::Sum(terms) => {
                let terms = terms.iter().map(|(s, e)| (*s, self.node(e))).collect();
                // Blocks of zeros get their height from the other terms, which the evaluator sees.
                let mut blocks = false;
                visit(expr, &mut |e| {
                    blocks |= matches!(e.kind, ExprKind::Matrix { .. });
                });
                self.shared(Shape::Sum(terms), blocks.then_some(expr))
            }
            ExprKind::Product(factors) => {
                let factors = factors.iter().map(|e| self.node(e)).collect();
                self.shared(Shape::Product(factors), None)
            }
            ExprKind::Quotient {
                numerator,
                denominator,
                ..
            } => {
                let shape = Shape::Quotient(self.node(numerator), self.node(denominator));
                self.shared(shape, None)
            }
            ExprKind::Power { base, exponent } => match literal_integer(exponent) {
                // A power may be what the document defines, not its base.
                Some(n) if n.unsigned_abs() <= 64 && !self.is_defined_by_powers(base) => {
                    let shape = Shape::Power(self.node(base), n);
                    self.shared(shape, None)
                }
                _ => self.whole(expr),
            },
            ExprKind::Transpose(inner) => {
                let shape = Shape::Transpose(self.node(inner));
                self.shared(shape, None)
            }
            ExprKind::Matrix { rows, .. } => {
                let columns = rows.first().map_or(0, Vec::len);
                let entries = rows.iter().flatten().map(|e| self.node(e)).collect();
                self.shared(Shape::Matrix(columns, entries), Some(expr))
            }
            ExprKind::BigSum {
                index,
                from,
                to,
                body,
            } => {
                let (from, to) = (self.expression(from), self.expression(to));
                let shape = Shape::Running(index.clone(), from, to, self.node(body));
                self.shared(shape, None)
            }
            _ => self.whole(expr),
        }
    }

    fn is_defined_by_powers(&self, base: &Expr) -> bool {
        matches!(&base.kind, ExprKind::Name(name)
            if self.evaluator.model().has_power_of(&latex::canonical(name)))
    }

    fn expression(&mut self, expr: &Expr) -> usize {
        let text = latex::write_expr(expr);
        if let Some(place) = self.of_text.get(&text) {
            return *place;
        }
        self.expressions.push(Rc::new(expr.clone()));
        self.of_text.insert(text, self.expressions.len() - 1);
        self.expressions.len() - 1
    }

    fn whole(&mut self, expr: &Expr) -> Id {
        let place = self.expression(expr);
        self.shared(Shape::Whole(place), Some(expr))
    }

    /// The node of a shape.
    pub fn shared(&mut self, shape: Shape, expr: Option<&Expr>) -> Id {
        match self.of_shape.get(&shape) {
            Some(id) => *id,
            None => {
                let id = self.add(shape.clone(), expr);
                self.of_shape.insert(shape, id);
                id
            }
        }
    }

    fn add(&mut self, shape: Shape, expr: Option<&Expr>) -> Id {
        let of = |id: &Id| self.nodes[*id].bound;
        let bound = match &shape {
            Shape::Number(_) => false,
            Shape::Sum(terms) => terms.iter().any(|(_, id)| of(id)),
            Shape::Product(ids) | Shape::Matrix(_, ids) => ids.iter().any(of),
            Shape::Quotient(one, other) => of(one) || of(other),
            Shape::Power(id, _) | Shape::Transpose(id) => of(id),
            Shape::Running(_, from, to, body) => {
                let limits = [from, to].map(|place| self.mentions(&self.expressions[*place]));
                of(body) || limits.contains(&true)
            }
            Shape::Name(_) | Shape::Whole(_) => expr.is_some_and(|e| self.mentions(e)),
        };
        self.nodes.push(Node {
            shape: Rc::new(shape),
            bound,
            expr: expr.map(|e| Rc::new(e.clone())),
        });
        self.closed.push(None);
        self.nodes.len() - 1
    }

    /// Whether a bound index occurs in an expression or below one of its letters.
    fn mentions(&self, expr: &Expr) -> bool {
        let mut found = false;
        visit(expr, &mut |e| {
            if let ExprKind::Name(name) | ExprKind::Apply { function: name, .. } = &e.kind {
                found |= self.indices.contains(&latex::canonical(name));
                let subscript = name.subscript.iter().flat_map(|s| &s.indices);
                found |= subscript.into_iter().any(|i| self.mentions(i));
            }
        });
        found
    }

    /// The value of a node.
    pub fn value(&mut self, id: Id, env: Env) -> Residue {
        let env = if self.nodes[id].bound { env } else { 0 };
        let known = match env {
            0 => self.closed[id].as_ref(),
            _ => self.open.get(&(id, env)),
        };
        if let Some(known) = known {
            return known.clone();
        }
        let value = self.compute(id, env);
        match env {
            0 => self.closed[id] = Some(value.clone()),
            _ => drop(self.open.insert((id, env), value.clone())),
        }
        value
    }

    fn compute(&mut self, id: Id, env: Env) -> Residue {
        let field = PrimeField;
        let span = Span::default();
        let shape = self.shape(id);
        match &*shape {
            Shape::Number(number) => match field.rational(number) {
                Some(n) => Residue::Is(Value::Scalar(n)),
                None => Residue::Absent,
            },
            Shape::Sum(terms) => {
                let mut sum: Option<Value<u64>> = None;
                for (sign, term) in terms {
                    let value = match self.value(*term, env) {
                        Residue::Is(value) => value,
                        other => return other,
                    };
                    let next = match (&sum, sign) {
                        (None, Sign::Plus) => Ok(value),
                        (None, Sign::Minus) => Ok(value::negate(&field, &value)),
                        (Some(s), Sign::Plus) => value::add(&field, s, &value, span),
                        (Some(s), Sign::Minus) => value::subtract(&field, s, &value, span),
                    };
                    match next {
                        Ok(next) => sum = Some(next),
                        // Blocks of zeros may still fit.
                        Err(_) => return self.evaluated(id, env),
                    }
                }
                sum.map_or(Residue::Absent, Residue::Is)
            }
            Shape::Product(factors) => {
                let mut product: Option<Value<u64>> = None;
                for factor in factors {
                    let value = match self.value(*factor, env) {
                        Residue::Is(value) => value,
                        other => return other,
                    };
                    product = Some(match product {
                        None => value,
                        Some(p) => match value::multiply(&field, &p, &value, span) {
                            Ok(value) => value,
                            Err(_) => return Residue::Absent,
                        },
                    });
                }
                product.map_or(Residue::Absent, Residue::Is)
            }
            Shape::Quotient(above, below) => {
                let (above, below) = (self.value(*above, env), self.value(*below, env));
                match (above, below) {
                    (Residue::Is(above), Residue::Is(Value::Scalar(below))) => {
                        let inverse = field.divide(&1, &below).map(Value::Scalar);
                        let quotient =
                            inverse.and_then(|i| value::multiply(&field, &i, &above, span).ok());
                        quotient.map_or(Residue::Absent, Residue::Is)
                    }
                    (Residue::Unknown, _) | (_, Residue::Unknown) => Residue::Unknown,
                    _ => Residue::Absent,
                }
            }
            Shape::Power(base, exponent) => match self.value(*base, env) {
                Residue::Is(Value::Scalar(s)) => {
                    let base = if *exponent < 0 {
                        field.divide(&1, &s)
                    } else {
                        Some(s)
                    };
                    let magnitude = u32::try_from(exponent.unsigned_abs()).unwrap_or(u32::MAX);
                    let power = base.and_then(|b| field.power(&b, magnitude));
                    power.map_or(Residue::Absent, |p| Residue::Is(Value::Scalar(p)))
                }
                Residue::Is(Value::Zero) => Residue::Is(Value::Zero),
                Residue::Is(Value::Matrix(matrix)) => {
                    let factor = match exponent {
                        0 => return Residue::Unknown,
                        1.. => Ok(matrix),
                        _ => value::invert(&field, &matrix, span),
                    };
                    let Ok(factor) = factor.map(Value::Matrix) else {
                        return Residue::Absent;
                    };
                    let mut product = factor.clone();
                    for _ in 1..exponent.unsigned_abs() {
                        match value::multiply(&field, &product, &factor, span) {
                            Ok(next) => product = next,
                            Err(_) => return Residue::Absent,
                        }
                    }
                    Residue::Is(product)
                }
                other => other,
            },
            Shape::Transpose(inner) => match self.value(*inner, env) {
                Residue::Is(Value::Matrix(m)) => Residue::Is(Value::Matrix(m.transpose())),
                other => other,
            },
            Shape::Matrix(columns, entries) => {
                let mut values = Vec::with_capacity(entries.len());
                for entry in entries {
                    match self.value(*entry, env) {
                        Residue::Is(Value::Scalar(s)) => values.push(s),
                        Residue::Is(_) => return self.evaluated(id, env),
                        other => return other,
                    }
                }
                let rows = values.len() / (*columns).max(1);
                let entry = |i: usize, j: usize| values[i * columns + j];
                let matrix = Matrix::from_fn(rows, *columns, entry);
                Residue::Is(Value::from_matrix(matrix))
            }
            Shape::Running(index, from, to, body) => self.running(index, [*from, *to], *body, env),
            Shape::Name(_) | Shape::Whole(_) => self.evaluated(id, env),
        }
    }

    fn running(&mut self, index: &Name, limits: [usize; 2], body: Id, env: Env) -> Residue {
        let bound = self.envs[env].clone();
        let mut integer = |place: usize| {
            let expr = Rc::clone(&self.expressions[place]);
            self.evaluator.with_indices(&bound, |e| e.integer(&expr))
        };
        let (Ok(from), Ok(to)) = (integer(limits[0]), integer(limits[1])) else {
            return Residue::Absent;
        };
        if to.saturating_sub(from) > 1000 {
            return Residue::Unknown;
        }
        let index = latex::canonical(index);
        let mut sum = Value::Zero;
        for k in from..=to {
            let mut inner = bound.clone();
            inner.push((index.clone(), k));
            let inner = self.env(&inner);
            let term = match self.value(body, inner) {
                Residue::Is(term) => term,
                other => return other,
            };
            match value::add(&PrimeField, &sum, &term, Span::default()) {
                Ok(next) => sum = next,
                Err(_) => return Residue::Absent,
            }
        }
        Residue::Is(match sum {
            Value::Zero if from > to => Value::Scalar(0),
            sum => sum,
        })
    }

    /// What the evaluator says of a node.
    fn evaluated(&mut self, id: Id, env: Env) -> Residue {
        let Some(expr) = self.nodes[id].expr.clone() else {
            return Residue::Unknown;
        };
        let bound = self.envs[env].clone();
        let value = self.evaluator.with_indices(&bound, |e| e.expression(&expr));
        let failure = match value {
            Ok(value) => return Residue::Is(value),
            Err(failure) => failure,
        };
        let (FailureKind::Unsupported { .. }, Some((exact, images))) =
            (&failure.kind, &mut self.exact)
        else {
            return Residue::Absent;
        };
        let value = exact
            .borrow_mut()
            .with_indices(&bound, |e| e.expression(&expr))
            .and_then(|v| v.try_map(|f| images.image(f).map_err(|k| Failure::new(k, expr.span))));
        match value {
            Ok(value) => Residue::Is(value),
            Err(Failure {
                kind: FailureKind::Unsupported { .. } | FailureKind::Budget { .. },
                ..
            }) => Residue::Unknown,
            Err(_) => Residue::Absent,
        }
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

const _: () = assert!(
    PRIME % 4 == 3,
    "square roots are powers modulo such a prime"
);
