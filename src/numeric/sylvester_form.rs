//! Lyapunov and Sylvester equations recognised in print.
//!
//! `A X + X B + Q = 0` is recognised by its terms: one ends in `X`, one begins with it, the others
//! are free of it, on whichever side and in whichever brackets. What is recognised is checked
//! against the printed equation at a matrix without symmetry, so that a letter that only hides
//! the unknown cannot be taken for it.

use super::evaluate::Evaluator;
use super::is_symmetric;
use super::resolver::{Resolver, System};
use super::value::{Failure, Value};
use crate::expr::{Expr, ExprKind, Sign};
use nalgebra::DMatrix;

/// `A X + X B + Q = 0`: `A` is `m x m`, `B` is `n x n`, `Q` is `m x n`.
#[derive(Clone, Debug, PartialEq)]
pub struct SylvesterForm {
    /// What stands before the unknown.
    pub a: DMatrix<f64>,
    /// What stands after it.
    pub b: DMatrix<f64>,
    /// What is free of it.
    pub q: DMatrix<f64>,
}

impl SylvesterForm {
    /// Whether it is a Lyapunov equation `A X + X A^T + Q = 0` with a symmetric `Q`.
    pub fn is_lyapunov(&self) -> bool {
        self.b == self.a.transpose() && is_symmetric(&self.q)
    }
}

impl<'r, R: Resolver> Evaluator<'r, R> {
    /// The equation as `A X + X B + Q = 0`, if that is what its terms say.
    pub(super) fn recognise(
        &mut self,
        system: usize,
        [left, right]: [&Expr; 2],
        shape: (usize, usize),
    ) -> Option<SylvesterForm> {
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

    fn collect_terms(
        &mut self,
        left: &Expr,
        right: &Expr,
        shape: (usize, usize),
    ) -> Option<SylvesterForm> {
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
            SylvesterForm {
                a: -a,
                b: -b,
                q: -q,
            }
        } else {
            SylvesterForm { a, b, q }
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
    let expr = strip(expr);
    let ExprKind::Sum(inner) = &expr.kind else {
        terms.push((sign, expr));
        return;
    };
    for (own, term) in inner {
        let sign = if *own == sign {
            Sign::Plus
        } else {
            Sign::Minus
        };
        flatten(term, sign, terms);
    }
}

/// The expression inside brackets and underbraces.
fn strip(expr: &Expr) -> &Expr {
    if let ExprKind::Group { inner, .. } | ExprKind::Underbrace { body: inner, .. } = &expr.kind {
        strip(inner)
    } else {
        expr
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
