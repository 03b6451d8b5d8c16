//! Both sides of a link at a point, and whether they are certainly apart.

use super::apply::Truth;
use super::elimination::definite;
use super::evaluator::Evaluator;
use super::failure::{NoValue, Reason};
use super::jet::Jet;
use super::point::Point;
use super::shown::{Comparison, Shown};
use super::stable::Stability;
use super::value::{Value, misfit};
use super::world::World;
use crate::expr::{Chain, Display, Expr, ExprKind, Relation};
use crate::latex;
use crate::matrix::Matrix;
use crate::model::Hypothesis;
use crate::model::links::Link;
use crate::model::time::Constancy;
use crate::real::dyadic::Dyadic;
use crate::real::{Complex, Real};
use crate::span::Span;
use crate::stack::with_deep_stack;
use num_rational::BigRational;

/// The most combinations of running indices.
const MOST_INDICES: usize = 2_000;

/// The values of running indices, and both sides there.
type Sides = Vec<(Vec<(String, i64)>, Value, Value)>;

impl Evaluator<'_, '_> {
    /// Both sides of a link of a display, for every value of its running indices. That something is a
    /// constant says that its derivative is zero: by the time, or by x where the chain begins with f(x).
    ///
    /// # Errors
    /// Why a side has no value.
    pub fn sides(&mut self, display: &Display, link: &Link) -> Result<Sides, NoValue> {
        let missing = || Reason::Unsupported("a link without its sides").at(Span::default());
        let left = link.left.find(display).ok_or_else(missing)?;
        let right = link.right.find(display).ok_or_else(missing)?;
        let clause = &display.clauses[link.left.clause()];
        let head = clause.chain.members.first();
        let mut tuples: Vec<Vec<(String, i64)>> = vec![Vec::new()];
        for range in &clause.ranges {
            let (from, to) = (self.integer(&range.from)?, self.integer(&range.to)?);
            let step = self.integer(&range.step)?;
            if step < 1 || tuples.len().saturating_mul(span_of(from, to)) > MOST_INDICES {
                return Err(Reason::Budget("running indices").at(range.from.span));
            }
            let name = latex::canonical(&range.index);
            tuples = tuples
                .iter()
                .flat_map(|tuple| {
                    let mut values = Vec::new();
                    let mut k = from;
                    while k <= to {
                        let mut longer = tuple.clone();
                        longer.push((name.clone(), k));
                        values.push(longer);
                        k += step;
                    }
                    values
                })
                .collect();
        }
        let mut sides = Vec::new();
        for indices in tuples {
            let (l, r) = self.with_indices(&indices, |e| e.two_sides(head, left, right))?;
            sides.push((indices, l, r));
        }
        Ok(sides)
    }

    fn two_sides(
        &mut self,
        head: Option<&Expr>,
        left: &Expr,
        right: &Expr,
    ) -> Result<(Value, Value), NoValue> {
        let other = match (&left.kind, &right.kind) {
            (ExprKind::Constant, ExprKind::Constant) => return Ok((Value::Zero, Value::Zero)),
            (ExprKind::Constant, _) => right,
            (_, ExprKind::Constant) => left,
            _ => return Ok((self.expression(left)?, self.expression(right)?)),
        };
        let argument = match self.world.model().constancy(head) {
            Constancy::Letter(name) => Some(name),
            Constancy::Time => None,
            Constancy::Unclear => {
                let what = "a constant where nothing says in which letter";
                return Err(Reason::Unsupported(what).at(other.span));
            }
        };
        let rate = self.derivative(1, argument, other, other.span)?;
        Ok((rate, Value::Zero))
    }

    /// Whether a hypothesis is true.
    ///
    /// # Errors
    /// Why a side has no value.
    pub fn is_true(&mut self, hypothesis: &Hypothesis) -> Result<Truth, NoValue> {
        let order = |r: Relation| {
            matches!(
                r,
                Relation::Less | Relation::LessEqual | Relation::Greater | Relation::GreaterEqual
            )
        };
        let infinite = |e: &Expr| {
            let mut found = false;
            super::world::each(e, &mut |e| found |= e.kind == ExprKind::Infinity);
            found
        };
        if order(hypothesis.relation) && (infinite(&hypothesis.left) || infinite(&hypothesis.right))
        {
            return self.holds(&Chain {
                members: vec![hypothesis.left.clone(), hypothesis.right.clone()],
                relations: vec![hypothesis.relation],
                span: hypothesis.span,
            });
        }
        let (l, r) = self.two_sides(None, &hypothesis.left, &hypothesis.right)?;
        self.truth(&l, hypothesis.relation, &r)
            .map_err(|reason| reason.at(hypothesis.span))
    }

    /// Whether two values stand in a relation.
    pub(super) fn truth(
        &self,
        left: &Value,
        relation: Relation,
        right: &Value,
    ) -> Result<Truth, Reason> {
        let pairs = paired(left, right)?;
        let zero = Jet::zero();
        match relation {
            Relation::Equal | Relation::NotEqual => {
                let mut equal = Truth::True;
                for (_, l, r) in &pairs {
                    equal = equal.and(self.arithmetic.related(l, Relation::Equal, r));
                }
                Ok(match (relation, equal) {
                    (Relation::NotEqual, Truth::True) => Truth::False,
                    (Relation::NotEqual, Truth::False) => Truth::True,
                    (_, equal) => equal,
                })
            }
            Relation::Less | Relation::LessEqual | Relation::Greater | Relation::GreaterEqual => {
                let strict = matches!(relation, Relation::Less | Relation::Greater);
                let downwards = matches!(relation, Relation::Greater | Relation::GreaterEqual);
                let (upper, lower) = if downwards {
                    (left, right)
                } else {
                    (right, left)
                };
                let difference = self.arithmetic.sum(upper, &lower.negated())?;
                match &difference {
                    Value::Scalar(x) => {
                        let above = if strict {
                            Relation::Greater
                        } else {
                            Relation::GreaterEqual
                        };
                        Ok(self.arithmetic.related(x, above, &zero))
                    }
                    Value::Zero => Ok(if strict { Truth::False } else { Truth::True }),
                    Value::Matrix(m) => {
                        let symmetric = self.symmetric_part(m)?;
                        Ok(definite(&self.arithmetic, &symmetric, strict))
                    }
                }
            }
            Relation::Distributed => Err(Reason::Unsupported("how something is distributed")),
            Relation::Approximately => Err(Reason::Unsupported("an approximation")),
            Relation::Tends => Err(Reason::Unsupported("a limit")),
        }
    }

    /// What the quadratic form of a matrix depends on.
    fn symmetric_part(&self, m: &Matrix<Jet>) -> Result<Matrix<Jet>, Reason> {
        if !m.is_square() {
            return Err(misfit("order", &Value::Matrix(m.clone()), &Value::Zero));
        }
        let half = Jet::from(Real::rational(BigRational::new(1.into(), 2.into())));
        Matrix::try_from_fn(m.rows(), m.columns(), |i, j| {
            if i == j {
                return Ok(m[(i, i)].clone());
            }
            let sum = self.arithmetic.add(&m[(i, j)], &m[(j, i)]);
            self.arithmetic.multiply(&sum, &half)
        })
    }

    /// Compares both sides of a link.
    pub fn compare(&mut self, display: &Display, link: &Link) -> Comparison {
        if let (Some(left), Some(right)) = (link.left.find(display), link.right.find(display))
            && let Some(claim) = Stability::of(left, link.relation, right)
        {
            return match self.stable(&claim) {
                Err(none) => Comparison::NoValue(none),
                Ok(found) => match found.minor {
                    Some(minor) => Comparison::Apart(Box::new(Shown {
                        letters: self.used().map(|(s, k, z)| (s, k, z.clone())).collect(),
                        indices: Vec::new(),
                        entry: None,
                        left: minor.number().clone(),
                        right: Complex::integer(0),
                        relation: Relation::Greater,
                        matrix: Some(found.matrix.map(|e| e.number().clone())),
                    })),
                    None => Comparison::Overlap {
                        narrow: found.truth == Truth::True,
                    },
                },
            };
        }
        let span = link.left.find(display).map_or(Span::default(), |e| e.span);
        let unknown = match link.relation {
            Relation::Distributed => Some("how something is distributed"),
            Relation::Approximately => Some("an approximation"),
            Relation::Tends => Some("a limit"),
            Relation::Equal
            | Relation::NotEqual
            | Relation::Less
            | Relation::LessEqual
            | Relation::Greater
            | Relation::GreaterEqual => None,
        };
        if let Some(what) = unknown {
            return Comparison::NoValue(Reason::Unsupported(what).at(span));
        }
        let sides = match self.sides(display, link) {
            Ok(sides) => sides,
            Err(none) => return Comparison::NoValue(none),
        };
        let mut narrow = true;
        for (indices, left, right) in &sides {
            match self.truth(left, link.relation, right) {
                Err(reason) => return Comparison::NoValue(reason.at(span)),
                Ok(Truth::False) => {
                    return Comparison::Apart(Box::new(self.shown(link, indices, left, right)));
                }
                Ok(Truth::True) => {}
                Ok(Truth::Unknown) => narrow &= self.coarse || self.is_narrow(left, right),
            }
        }
        Comparison::Overlap { narrow }
    }

    fn shown(&self, link: &Link, indices: &[(String, i64)], left: &Value, right: &Value) -> Shown {
        let pairs = paired(left, right).unwrap_or_default();
        let matrix = |v: &Value| matches!(v, Value::Matrix(_));
        let scalars = !matrix(left) && !matrix(right);
        let violates = |(_, l, r): &&(Option<(usize, usize)>, Jet, Jet)| match link.relation {
            Relation::Equal => self.arithmetic.related(l, Relation::Equal, r) == Truth::False,
            Relation::NotEqual
            | Relation::Less
            | Relation::LessEqual
            | Relation::Greater
            | Relation::GreaterEqual
            | Relation::Distributed
            | Relation::Approximately
            | Relation::Tends => true,
        };
        let (entry, l, r) =
            pairs
                .iter()
                .find(violates)
                .cloned()
                .unwrap_or((None, Jet::zero(), Jet::zero()));
        // Matrices are ordered by the definiteness of their difference.
        let difference = if link.relation.is_order() && !scalars {
            let difference = self.arithmetic.sum(left, &right.negated()).ok();
            difference.and_then(|d| Some(d.as_matrix()?.map(|e| e.number().clone())))
        } else {
            None
        };
        Shown {
            letters: self.used().map(|(s, k, z)| (s, k, z.clone())).collect(),
            indices: indices.to_vec(),
            entry: entry.filter(|_| !scalars && difference.is_none()),
            left: l.number().clone(),
            right: r.number().clone(),
            relation: link.relation,
            matrix: difference,
        }
    }

    /// Whether two values that may be equal are the same up to many digits.
    fn is_narrow(&self, left: &Value, right: &Value) -> bool {
        let bits = self.arithmetic.bits;
        let pairs = paired(left, right).unwrap_or_default();
        pairs.iter().all(|(_, l, r)| {
            let (l, r) = (l.number(), r.number());
            let size = |z: &Complex| z.re.largest(64).max(z.im.largest(64));
            let difference = size(&l.subtract(r, 64));
            let scale = size(l).max(size(r));
            let absolute = Dyadic::power_of_two(-i64::from(bits) / 2);
            difference <= absolute || difference <= scale.scaled(-40)
        })
    }
}

fn span_of(from: i64, to: i64) -> usize {
    usize::try_from(to.saturating_sub(from).saturating_add(1)).unwrap_or(0)
}

/// The entries of two values beside each other, with row and column from 1.
fn paired(left: &Value, right: &Value) -> Result<Vec<(Option<(usize, usize)>, Jet, Jet)>, Reason> {
    let shape = match (left, right) {
        (Value::Zero, other) | (other, Value::Zero) => other.shape(),
        (Value::Scalar(s), other) | (other, Value::Scalar(s)) if s.is_zero() => other.shape(),
        (a, b) if a.shape() == b.shape() => a.shape(),
        (a, b) => return Err(misfit("=", a, b)),
    };
    let (rows, columns) = shape.unwrap_or((1, 1));
    let entry = |v: &Value, i: usize, j: usize| match v {
        Value::Matrix(m) => m[(i, j)].clone(),
        Value::Scalar(s) => s.clone(),
        Value::Zero => Jet::zero(),
    };
    let places = (0..rows).flat_map(|i| (0..columns).map(move |j| (i, j)));
    Ok(places
        .map(|(i, j)| {
            let place = (rows * columns > 1).then_some((i + 1, j + 1));
            (place, entry(left, i, j), entry(right, i, j))
        })
        .collect())
}

impl World<'_> {
    /// Compares both sides of a link of an equation at a point.
    pub fn compare(
        &self,
        equation: usize,
        link: &Link,
        point: &Point,
        bits: u32,
        work: u64,
    ) -> Comparison {
        let display = self.display(equation);
        with_deep_stack(|| Evaluator::new(self, point, bits, work).compare(display, link))
    }

    /// The value of an expression at a point.
    ///
    /// # Errors
    /// Why there is none.
    pub fn value(
        &self,
        expr: &Expr,
        point: &Point,
        bits: u32,
        work: u64,
    ) -> Result<Value, NoValue> {
        with_deep_stack(|| Evaluator::new(self, point, bits, work).expression(expr))
    }

    /// The derivative of an expression by a symbol at a point.
    ///
    /// # Errors
    /// Why there is none.
    pub fn slope(
        &self,
        expr: &Expr,
        symbol: usize,
        order: u8,
        point: &Point,
        bits: u32,
        work: u64,
    ) -> Result<Value, NoValue> {
        with_deep_stack(|| {
            let mut evaluator = Evaluator::new(self, point, bits, work);
            evaluator.partial(symbol, 0, order, expr.span, |e| e.expression(expr))
        })
    }
}
