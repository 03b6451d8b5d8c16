//! The unknowns of linear equations, scalars or matrices, whatever the equation looks like.
//!
//! A Lyapunov equation (see [`super::sylvester_form`]) is given to the method asked for, a Sylvester
//! equation to Bartels & Stewart. Everything else goes the Kronecker route: the equation evaluated
//! at zero and at the basis matrices.

use super::bartels_stewart::sylvester;
use super::evaluate::Evaluator;
use super::kronecker::solve_affine;
use super::resolver::{Resolver, System};
use super::sylvester_form::SylvesterForm;
use super::value::{Failure, FailureKind, Value};
use super::{LyapunovMethod, NumericError, cost};
use crate::expr::walk::children;
use crate::expr::{Expr, ExprKind};
use crate::span::Span;
use nalgebra::DMatrix;

type Shape = (usize, usize);

/// The most scalar unknowns of a system: its LU factors cost `2/3 N^3` operations.
const MOST_UNKNOWNS: usize = 1024;

/// A system that was solved.
#[derive(Clone, Debug, PartialEq)]
pub struct SolvedSystem {
    /// The method: the one asked for, or [`LyapunovMethod::Kronecker`] where it does not apply.
    pub method: LyapunovMethod,
    /// Its floating-point operations; those of evaluating the equation are not counted.
    pub operations: u64,
    /// The values of the unknowns.
    pub values: Vec<Value>,
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
        self.by_method = true;
        if let Some(value) = self.trial.get(&(system, position)) {
            self.touched = true;
            return Ok(value.clone());
        }
        if !self.solved.contains_key(&system) {
            let solution = self.inside(system, span, |e| e.solve(system, span))?;
            self.solved.insert(system, solution);
        }
        self.solved[&system]
            .values
            .get(position)
            .cloned()
            .ok_or_else(|| Failure::unsupported("an unknown without a place", span))
    }

    /// The equation of a system as `A X + X B + Q = 0`, where its terms say so; the matrices of
    /// a Lyapunov equation are also what the spectral integral and a simulation need.
    pub fn sylvester_form(
        &mut self,
        system: usize,
        span: Span,
    ) -> Result<Option<SylvesterForm>, Failure> {
        self.inside(system, span, |evaluator| {
            let equations = evaluator.equations(system, span)?;
            let shapes = evaluator.shapes(system, &equations, span)?;
            Ok(evaluator.form(system, &equations, &shapes))
        })
    }

    fn form(
        &mut self,
        system: usize,
        equations: &System<'_>,
        shapes: &[Shape],
    ) -> Option<SylvesterForm> {
        match (equations.equations.as_slice(), shapes) {
            ([(left, right)], [shape]) => self.recognise(system, [left, right], *shape),
            _ => None,
        }
    }

    fn equations(&self, system: usize, span: Span) -> Result<System<'r>, Failure> {
        self.resolver.system(system).ok_or_else(|| {
            Failure::unsupported("an unknown that no linear equations determine", span)
        })
    }

    /// Runs `body` while a system is being solved. Systems may need each other's solutions, but
    /// not in a circle.
    fn inside<T>(
        &mut self,
        system: usize,
        span: Span,
        body: impl FnOnce(&mut Self) -> Result<T, Failure>,
    ) -> Result<T, Failure> {
        if !self.solving.insert(system) {
            return Err(Failure::new(FailureKind::Cyclic, span));
        }
        let outer = (
            std::mem::take(&mut self.trial),
            std::mem::take(&mut self.bound),
            self.touched,
        );
        let result = body(self);
        (self.trial, self.bound, self.touched) = outer;
        self.solving.remove(&system);
        result
    }

    fn solve(&mut self, system: usize, span: Span) -> Result<SolvedSystem, Failure> {
        let equations = self.equations(system, span)?;
        let shapes = self.shapes(system, &equations, span)?;
        let form = match self.method {
            LyapunovMethod::Kronecker => None,
            LyapunovMethod::BartelsStewart
            | LyapunovMethod::Smith
            | LyapunovMethod::Kreisselmeier => self.form(system, &equations, &shapes),
        };
        let direct = form.and_then(|form| match self.method {
            method if form.is_lyapunov() => Some(method.solve(&form.a, &form.q)),
            LyapunovMethod::BartelsStewart => Some(sylvester(&form.a, &form.b, &form.q)),
            LyapunovMethod::Kronecker | LyapunovMethod::Smith | LyapunovMethod::Kreisselmeier => {
                None
            }
        });
        if let Some(solution) = direct {
            let solution = solution.map_err(|e| Failure::numeric(e, span))?;
            return Ok(SolvedSystem {
                method: self.method,
                operations: solution.operations,
                values: vec![Value::from_matrix(solution.matrix)],
            });
        }
        let solution = solve_affine(&shapes, |values| {
            self.try_values(system, values);
            self.residual(&equations).map_err(Trouble::Map)
        })
        .map_err(|trouble| match trouble {
            Trouble::Map(failure) => failure,
            Trouble::Method(error) => Failure::numeric(error, span),
        })?;
        let order = shapes.iter().map(|(rows, columns)| rows * columns).sum();
        Ok(SolvedSystem {
            method: LyapunovMethod::Kronecker,
            operations: cost::lu(order) + cost::triangular_solves(order, 1),
            values: solution.into_iter().map(Value::from_matrix).collect(),
        })
    }

    pub(super) fn try_values(&mut self, system: usize, values: &[DMatrix<f64>]) {
        for (position, value) in values.iter().enumerate() {
            self.trial
                .insert((system, position), Value::from_matrix(value.clone()));
        }
    }

    /// Left minus right of every equation; a zero of any shape gives no equations.
    pub(super) fn residual(&mut self, system: &System<'_>) -> Result<Vec<DMatrix<f64>>, Failure> {
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
        if let ExprKind::Power { base, .. } = &expr.kind {
            return self.sizes(base, sizes);
        }
        let made_of_parts = matches!(
            expr.kind,
            ExprKind::Sum(_)
                | ExprKind::Product(_)
                | ExprKind::Group { .. }
                | ExprKind::Transpose(_)
                | ExprKind::Underbrace { .. }
        );
        if made_of_parts {
            for part in children(expr) {
                self.sizes(part, sizes);
            }
            return;
        }
        // The unknowns themselves fail here, being solved without trial values.
        let value = self.expression(expr);
        if let Ok(Some((rows, columns))) = value.map(|v| v.shape()) {
            sizes.extend([rows, columns]);
        }
    }
}
