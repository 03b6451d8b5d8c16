//! The unknowns of linear equations, scalars or matrices, whatever the equation looks like.
//!
//! A Lyapunov equation `A X + X A^T + Q = 0` is recognised by its terms (one ends in `X`, one begins
//! with it, the others are free of it) and given to the method asked for; a Sylvester equation
//! `A X + X B + Q = 0` to Bartels & Stewart. What is recognised is checked against the printed
//! equation at a matrix without symmetry. Everything else goes the Kronecker route: the equation
//! evaluated at zero and at the basis matrices.

use super::bartels_stewart::sylvester;
use super::evaluate::Evaluator;
use super::kronecker::solve_affine;
use super::resolver::{Resolver, System};
use super::value::{Failure, FailureKind, Value};
use super::{LyapunovMethod, NumericError, is_symmetric};
use crate::expr::{Expr, ExprKind, Sign};
use crate::span::Span;
use nalgebra::DMatrix;

type Shape = (usize, usize);

/// The most scalar unknowns of a system: its LU factors cost `2/3 N^3` operations.
const MOST_UNKNOWNS: usize = 1024;

/// `A X + X B + Q = 0`.
struct Sylvester {
    a: DMatrix<f64>,
    b: DMatrix<f64>,
    q: DMatrix<f64>,
}

/// A failure of the map or of the method, at a place that the method does not know.
enum Trouble {
    Map(Failure),
    Method(NumericError),
}

impl From<NumericError> for Trouble {
    fn from(error: NumericError) -> Self {
        Trouble::Method(error)
    }
}

impl<'r, R: Resolver> Evaluator<'r, R> {
    /// The value of an unknown: its trial value while its system is being solved.
    pub(super) fn unknown(
        &mut self,
        system: usize,
        position: usize,
        span: Span,
    ) -> Result<Value, Failure> {
        if let Some(value) = self.trial.get(&(system, position)) {
            self.touched = true;
            return Ok(value.clone());
        }
        if !self.solved.contains_key(&system) {
            // Systems may need each other's solutions, but not in a circle.
            if !self.solving.insert(system) {
                return Err(Failure::new(FailureKind::Cyclic, span));
            }
            let outer = (
                std::mem::take(&mut self.trial),
                std::mem::take(&mut self.bound),
                self.touched,
            );
            let solution = self.solve(system, span);
            (self.trial, self.bound, self.touched) = outer;
            self.solving.remove(&system);
            self.solved.insert(system, solution?);
        }
        self.solved[&system]
            .1
            .get(position)
            .cloned()
            .ok_or_else(|| Failure::unsupported("an unknown without a place", span))
    }

    fn solve(
        &mut self,
        system: usize,
        span: Span,
    ) -> Result<(LyapunovMethod, Vec<Value>), Failure> {
        let equations = self
            .resolver
            .system(system)
            .ok_or_else(|| Failure::unsupported("an unknown without equations", span))?;
        let shapes = self.shapes(system, &equations, span)?;
        if let ([(left, right)], [shape], true) = (
            equations.equations.as_slice(),
            shapes.as_slice(),
            self.method != LyapunovMethod::Kronecker,
        ) && let Some(form) = self.sylvester_form(system, left, right, *shape)
        {
            let lyapunov = form.b == form.a.transpose() && is_symmetric(&form.q);
            let direct = if lyapunov {
                Some((self.method, self.method.solve(&form.a, &form.q)))
            } else if self.method == LyapunovMethod::BartelsStewart {
                Some((self.method, sylvester(&form.a, &form.b, &form.q)))
            } else {
                None
            };
            if let Some((method, solution)) = direct {
                let solution = solution.map_err(|e| Failure::numeric(e, span))?;
                return Ok((method, vec![Value::from_matrix(solution.matrix)]));
            }
        }
        let solution = solve_affine(&shapes, |values| {
            self.try_values(system, values);
            self.residual(&equations).map_err(Trouble::Map)
        })
        .map_err(|trouble| match trouble {
            Trouble::Map(failure) => failure,
            Trouble::Method(error) => Failure::numeric(error, span),
        })?;
        let values = solution.into_iter().map(Value::from_matrix).collect();
        Ok((LyapunovMethod::Kronecker, values))
    }

    fn try_values(&mut self, system: usize, values: &[DMatrix<f64>]) {
        for (position, value) in values.iter().enumerate() {
            self.trial
                .insert((system, position), Value::from_matrix(value.clone()));
        }
    }

    /// Left minus right of every equation; a zero of any shape gives no equations.
    fn residual(&mut self, system: &System<'_>) -> Result<Vec<DMatrix<f64>>, Failure> {
        system
            .equations
            .iter()
            .map(|(left, right)| {
                let difference = self
                    .expression(left)?
                    .add(self.expression(right)?.negated(), right.span)?;
                Ok(difference.into_matrix((0, 0)))
            })
            .collect()
    }

    /// The shapes of the unknowns: a light letter is a scalar; a bold one has the largest shape,
    /// made of the sizes in the equations, for which they make sense and are as many as the
    /// unknowns.
    fn shapes(
        &mut self,
        system: usize,
        equations: &System<'_>,
        span: Span,
    ) -> Result<Vec<Shape>, Failure> {
        let mut sizes = vec![1];
        for side in equations.equations.iter().flat_map(|(l, r)| [l, r]) {
            self.sizes(side, &mut sizes);
        }
        sizes.sort_unstable();
        sizes.dedup();
        let matrices: Vec<Shape> = sizes
            .iter()
            .flat_map(|rows| sizes.iter().map(move |columns| (*rows, *columns)))
            .collect();
        let mut candidates = vec![Vec::new()];
        for bold in &equations.matrices {
            let options: &[Shape] = if *bold { &matrices } else { &[(1, 1)] };
            candidates = candidates
                .iter()
                .flat_map(|chosen: &Vec<Shape>| {
                    options.iter().map(move |shape| {
                        let mut longer = chosen.clone();
                        longer.push(*shape);
                        longer
                    })
                })
                .collect();
            if candidates.len() > MOST_UNKNOWNS {
                return Err(Failure::new(FailureKind::Budget, span));
            }
        }
        let scalars = |shapes: &[Shape]| shapes.iter().map(|(r, c)| r * c).sum::<usize>();
        candidates.sort_by_key(|shapes| std::cmp::Reverse(scalars(shapes)));
        let mut failure = None;
        for shapes in candidates {
            let unknowns = scalars(&shapes);
            if unknowns > MOST_UNKNOWNS {
                return Err(Failure::new(FailureKind::Budget, span));
            }
            let ones: Vec<DMatrix<f64>> = shapes
                .iter()
                .map(|(rows, columns)| DMatrix::from_element(*rows, *columns, 1.0))
                .collect();
            self.try_values(system, &ones);
            let residual = self.residual(equations);
            self.trial.clear();
            match residual {
                Ok(values) if values.iter().map(DMatrix::len).sum::<usize>() == unknowns => {
                    return Ok(shapes);
                }
                Ok(values) => {
                    failure = Some(Failure::numeric(
                        NumericError::Count {
                            equations: values.iter().map(DMatrix::len).sum(),
                            unknowns,
                        },
                        span,
                    ));
                }
                Err(other) => failure = failure.or(Some(other)),
            }
        }
        Err(failure.unwrap_or_else(|| Failure::unsupported("a system without unknowns", span)))
    }

    /// The sizes of what can be evaluated without the unknowns.
    fn sizes(&mut self, expr: &Expr, sizes: &mut Vec<usize>) {
        let parts: Vec<&Expr> = match &expr.kind {
            ExprKind::Sum(terms) => terms.iter().map(|(_, term)| term).collect(),
            ExprKind::Product(factors) => factors.iter().collect(),
            ExprKind::Group { inner, .. }
            | ExprKind::Transpose(inner)
            | ExprKind::Underbrace { body: inner, .. } => vec![inner],
            ExprKind::Power { base, .. } => vec![base],
            _ => {
                // The unknowns themselves fail here, being solved without trial values.
                let value = self.expression(expr);
                if let Ok(Some((rows, columns))) = value.map(|v| v.shape()) {
                    sizes.extend([rows, columns]);
                }
                return;
            }
        };
        for part in parts {
            self.sizes(part, sizes);
        }
    }

    /// The equation as `A X + X B + Q = 0`, if that is what its terms say.
    fn sylvester_form(
        &mut self,
        system: usize,
        left: &Expr,
        right: &Expr,
        shape: Shape,
    ) -> Option<Sylvester> {
        let (rows, columns) = shape;
        let probe = DMatrix::from_fn(rows, columns, |i, j| {
            1.0 + 0.25 * i as f64 - 0.625 * j as f64
        });
        self.try_values(system, std::slice::from_ref(&probe));
        let form = self.collect_terms(left, right, shape);
        let printed = self.residual(&System {
            equations: vec![(left, right)],
            matrices: vec![true],
        });
        self.trial.clear();
        let form = form?;
        let printed = printed.ok()?.into_iter().next()?;
        if printed.shape() != shape {
            return None;
        }
        let model = &form.a * &probe + &probe * &form.b + &form.q;
        let size = (form.a.norm() + form.b.norm()) * probe.norm() + form.q.norm();
        let distance = (&printed - &model).norm().min((printed + model).norm());
        (distance <= 1e-13 * size).then_some(form)
    }

    fn collect_terms(&mut self, left: &Expr, right: &Expr, shape: Shape) -> Option<Sylvester> {
        let mut terms = Vec::new();
        flatten(left, Sign::Plus, &mut terms);
        flatten(right, Sign::Minus, &mut terms);
        let (mut a, mut b, mut q) = (None, None, Value::Zero);
        for (sign, term) in terms {
            let signed = |value: Value| match sign {
                Sign::Plus => value,
                Sign::Minus => value.negated(),
            };
            let (value, free) = self.free(|e| e.expression(term));
            if free {
                q = q.add(signed(value?), term.span).ok()?;
                continue;
            }
            let ExprKind::Product(factors) = &term.kind else {
                return None;
            };
            let (first, others) = factors.split_first()?;
            let (last, before) = factors.split_last()?;
            let (prefix, prefix_free) = self.free(|e| e.product(before, term.span));
            let (suffix, suffix_free) = self.free(|e| e.product(others, term.span));
            let unknown = |e: &Expr| matches!(strip(e).kind, ExprKind::Name(_));
            if prefix_free && unknown(last) && a.is_none() {
                a = Some(coefficient(signed(prefix?), shape.0)?);
            } else if suffix_free && unknown(first) && b.is_none() {
                b = Some(coefficient(signed(suffix?), shape.1)?);
            } else {
                return None;
            }
        }
        let (a, b, q) = (a?, b?, q.into_matrix(shape));
        if q.shape() != shape {
            return None;
        }
        // Written with all signs changed it is the same equation; the methods that need a stable
        // `A`, whose trace is negative, are given that one.
        Some(if a.trace() > 0.0 {
            Sylvester {
                a: -a,
                b: -b,
                q: -q,
            }
        } else {
            Sylvester { a, b, q }
        })
    }

    /// A value, and whether no trial value went into it.
    fn free(
        &mut self,
        compute: impl FnOnce(&mut Self) -> Result<Value, Failure>,
    ) -> (Option<Value>, bool) {
        self.touched = false;
        let value = compute(self);
        (value.ok(), !self.touched)
    }
}

/// The terms of a sum of sums with their signs.
fn flatten<'e>(expr: &'e Expr, sign: Sign, terms: &mut Vec<(Sign, &'e Expr)>) {
    match &strip(expr).kind {
        ExprKind::Sum(inner) => {
            for (own, term) in inner {
                let sign = if *own == sign {
                    Sign::Plus
                } else {
                    Sign::Minus
                };
                flatten(term, sign, terms);
            }
        }
        _ => terms.push((sign, strip(expr))),
    }
}

/// The expression inside brackets and underbraces.
fn strip(expr: &Expr) -> &Expr {
    match &expr.kind {
        ExprKind::Group { inner, .. } | ExprKind::Underbrace { body: inner, .. } => strip(inner),
        _ => expr,
    }
}

/// A coefficient of the unknown as a square matrix.
fn coefficient(value: Value, order: usize) -> Option<DMatrix<f64>> {
    match value {
        Value::Scalar(s) => Some(DMatrix::identity(order, order) * s),
        Value::Matrix(m) if m.shape() == (order, order) => Some(m),
        Value::Matrix(_) => None,
        Value::Zero => Some(DMatrix::zeros(order, order)),
    }
}
