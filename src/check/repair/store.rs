//! Expressions shared by structure, with their values modulo the prime.
//!
//! Equal subexpressions are one node (hash-consing; A. P. Ershov, 1958), and each node has its value
//! computed once for each assignment of the bound indices it depends on. A candidate that differs
//! from the printed equation in one place costs the few new nodes from there to the root.
//!
//! What is neither arithmetic nor a matrix of scalars is left to the evaluator, node by node.
//!
//! What a candidate puts in is released when it is judged, so that a store is as large as the printed
//! equation and one candidate.

use super::evaluators::Exact;
use super::images::Images;
use super::residue::{Residue, operation};
use super::work;
use crate::domain::{Domain, PrimeField};
use crate::evaluate::{Evaluator, FailureKind, Value, value};
use crate::expr::walk::visit;
use crate::expr::{Display, Expr, ExprKind, Name, Sign};
use crate::latex;
use crate::model::links::each_expression;
use crate::model::names::literal_integer;
use crate::span::Span;
use num_rational::BigRational;
use ratpoly::allowance;
use std::collections::{BTreeSet, HashMap};
use std::rc::Rc;

/// A node.
pub(super) type Id = usize;
/// An assignment of the bound indices; 0 is the empty one.
pub(super) type Env = usize;

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

impl Shape {
    /// How many of the children of the expression are operands; none where it is no operation.
    pub fn operands(&self) -> usize {
        match self {
            Shape::Sum(terms) => terms.len(),
            Shape::Product(ids) | Shape::Matrix(_, ids) => ids.len(),
            Shape::Quotient(..) => 2,
            Shape::Power(..) | Shape::Transpose(_) => 1,
            Shape::Number(_) | Shape::Name(_) | Shape::Running(..) | Shape::Whole(_) => 0,
        }
    }
}

/// How much a store holds.
#[derive(Clone, Copy)]
pub(super) struct Mark {
    nodes: usize,
    expressions: usize,
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
    of_shape: HashMap<Rc<Shape>, Id>,
    of_name: HashMap<Name, Id>,
    expressions: Vec<(Rc<Expr>, Rc<str>)>,
    of_text: HashMap<Rc<str>, usize>,
    indices: BTreeSet<String>,
    envs: Vec<Vec<(String, i64)>>,
    env_of: HashMap<Vec<(String, i64)>, Env>,
    closed: Vec<Option<Residue>>,
    open: HashMap<(Id, Env), Residue>,
    /// From which node on values are what a candidate costs; those before are the print's.
    own: Id,
    steps: u64,
}

/// Steps for each value of a running index, beside those of the term.
const RUNNING: u64 = 20;

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
            env_of: HashMap::from([(Vec::new(), 0)]),
            closed: Vec::new(),
            open: HashMap::new(),
            own: 0,
            steps: 0,
        }
    }

    /// What is there now is the print's: its values cost no candidate anything.
    pub fn printed(&mut self) {
        self.own = self.nodes.len();
        self.steps = 0;
    }

    /// How many steps all candidates together have cost.
    pub fn steps(&self) -> u64 {
        self.steps
    }

    /// Goes back to a count: what was done since then is done once for all candidates.
    pub fn uncount(&mut self, steps: u64) {
        self.steps = steps;
    }

    /// Counts steps.
    pub fn charge(&mut self, steps: u64) {
        self.steps = self.steps.saturating_add(steps);
    }

    /// How much there is now.
    pub fn mark(&self) -> Mark {
        Mark {
            nodes: self.nodes.len(),
            expressions: self.expressions.len(),
        }
    }

    /// Forgets what was added since then.
    pub fn release(&mut self, mark: Mark) {
        let mut bound = false;
        while self.nodes.len() > mark.nodes
            && let Some(node) = self.nodes.pop()
        {
            self.closed.pop();
            bound |= node.bound;
            match &*node.shape {
                Shape::Name(name) => drop(self.of_name.remove(name)),
                shape => drop(self.of_shape.remove(shape)),
            }
        }
        while self.expressions.len() > mark.expressions
            && let Some((_, text)) = self.expressions.pop()
        {
            self.of_text.remove(&text);
        }
        if bound {
            self.open.retain(|(id, _), _| *id < mark.nodes);
        }
    }

    /// The assignment of these indices.
    pub fn env(&mut self, indices: &[(String, i64)]) -> Env {
        if let Some(env) = self.env_of.get(indices) {
            return *env;
        }
        let env = self.envs.len();
        self.envs.push(indices.to_vec());
        self.env_of.insert(indices.to_vec(), env);
        env
    }

    /// What a node is made of.
    pub fn shape(&self, id: Id) -> Rc<Shape> {
        Rc::clone(&self.nodes[id].shape)
    }

    /// The node of an expression.
    pub fn node(&mut self, expr: &Expr) -> Id {
        self.charge(1);
        match &expr.kind {
            ExprKind::Group { inner, .. } | ExprKind::Underbrace { body: inner, .. } => {
                self.node(inner)
            }
            ExprKind::Name(name) => match self.of_name.get(name) {
                Some(id) => *id,
                None => {
                    let id = self.add(Rc::new(Shape::Name(name.clone())), Some(expr));
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
        let text: Rc<str> = latex::write_expr(expr).into();
        if let Some(place) = self.of_text.get(&text) {
            return *place;
        }
        self.expressions
            .push((Rc::new(expr.clone()), Rc::clone(&text)));
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
                let shape = Rc::new(shape);
                let id = self.add(Rc::clone(&shape), expr);
                self.of_shape.insert(shape, id);
                id
            }
        }
    }

    fn add(&mut self, shape: Rc<Shape>, expr: Option<&Expr>) -> Id {
        let of = |id: &Id| self.nodes[*id].bound;
        let bound = match &*shape {
            Shape::Number(_) => false,
            Shape::Sum(terms) => terms.iter().any(|(_, id)| of(id)),
            Shape::Product(ids) | Shape::Matrix(_, ids) => ids.iter().any(of),
            Shape::Quotient(one, other) => of(one) || of(other),
            Shape::Power(id, _) | Shape::Transpose(id) => of(id),
            Shape::Running(_, from, to, body) => {
                let limits = [from, to].map(|place| self.mentions(&self.expressions[*place].0));
                of(body) || limits.contains(&true)
            }
            Shape::Name(_) | Shape::Whole(_) => expr.is_some_and(|e| self.mentions(e)),
        };
        self.nodes.push(Node {
            shape,
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
        let before = self.steps;
        let value = self.compute(id, env);
        if id < self.own {
            self.steps = before;
        } else {
            let operands = self.nodes[id].shape.operands();
            self.charge(work::operation(value.value(), operands));
        }
        match env {
            0 => self.closed[id] = Some(value.clone()),
            _ => drop(self.open.insert((id, env), value.clone())),
        }
        value
    }

    fn compute(&mut self, id: Id, env: Env) -> Residue {
        let shape = self.shape(id);
        match &*shape {
            Shape::Number(number) => match PrimeField.rational(number) {
                Some(n) => Residue::Is(Value::Scalar(n)),
                None => Residue::Absent,
            },
            Shape::Running(index, from, to, body) => self.running(index, [*from, *to], *body, env),
            Shape::Name(_) | Shape::Whole(_) => self.evaluated_node(id, env),
            shape => match operation(shape, &mut |_, operand| self.value(operand, env)) {
                Some(residue) => residue,
                None => self.evaluated_node(id, env),
            },
        }
    }

    fn running(&mut self, index: &Name, limits: [usize; 2], body: Id, env: Env) -> Residue {
        let bound = self.envs[env].clone();
        let mut integer = |place: usize| {
            let expr = Rc::clone(&self.expressions[place].0);
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
            self.charge(RUNNING);
            let mut inner = bound.clone();
            inner.push((index.clone(), k));
            let inner = self.env(&inner);
            let term = match self.value(body, inner) {
                Residue::Is(term) => term,
                none @ (Residue::Absent | Residue::Unknown) => return none,
            };
            match value::add(&PrimeField, &sum, &term, Span::default()) {
                Ok(next) => sum = next,
                Err(_) => return Residue::Absent,
            }
        }
        Residue::Is(match sum {
            Value::Zero if from > to => Value::Scalar(0),
            sum @ (Value::Zero | Value::Scalar(_) | Value::Matrix(_)) => sum,
        })
    }

    fn evaluated_node(&mut self, id: Id, env: Env) -> Residue {
        match self.nodes[id].expr.clone() {
            Some(expr) => self.evaluated(&expr, env),
            None => Residue::Unknown,
        }
    }

    /// What the evaluator says of an expression.
    pub fn evaluated(&mut self, expr: &Expr, env: Env) -> Residue {
        let before = allowance::steps_left();
        let residue = self.evaluated_freely(expr, env);
        self.charge(work::evaluated(expr));
        // Only one thread searches where the exact engine is asked: the count is the same everywhere.
        if self.exact.is_some() {
            let spent = before.saturating_sub(allowance::steps_left());
            self.charge(work::engine(spent));
        }
        residue
    }

    fn evaluated_freely(&mut self, expr: &Expr, env: Env) -> Residue {
        let bound = self.envs[env].clone();
        let value = self.evaluator.with_indices(&bound, |e| e.expression(expr));
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
            .with_indices(&bound, |e| e.expression(expr));
        let value = match value {
            Ok(value) => value,
            // Another reserve of letters may be enough.
            Err(failure)
                if matches!(
                    failure.kind,
                    FailureKind::Budget { .. } | FailureKind::Exhausted { .. }
                ) =>
            {
                return Residue::Unknown;
            }
            Err(_) => return Residue::Absent,
        };
        let steps = work::exact(value.entries());
        let image = value.try_map(|element| images.image(element));
        self.charge(steps);
        match image {
            Ok(value) => Residue::Is(value),
            Err(FailureKind::Unsupported { .. }) => Residue::Unknown,
            Err(_) => Residue::Absent,
        }
    }
}
