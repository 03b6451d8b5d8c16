//! `Re λ(A) < c`: the eigenvalues of a matrix lie left of a line.
//!
//! They do for A - cE and zero if and only if the leading minors of its Hurwitz matrix are positive
//! (A. Hurwitz 1895; F. R. Gantmacher, *The Theory of Matrices* II, 1959, chapter XV).

use super::apply::Truth;
use super::arithmetic::Arithmetic;
use super::evaluator::{Evaluator, Result};
use super::failure::Reason;
use super::jet::Jet;
use crate::expr::{Expr, ExprKind, Function, Relation};
use crate::matrix::Matrix;
use crate::model::EIGENVALUES;

/// A claim about all eigenvalues of a matrix.
pub(super) struct Stability<'e> {
    matrix: &'e Expr,
    bound: &'e Expr,
}

/// What is found about it: whether it is true, the matrix, and a minor that shows it where it is false.
pub(super) struct Stable {
    pub truth: Truth,
    pub matrix: Matrix<Jet>,
    pub minor: Option<Jet>,
}

impl<'e> Stability<'e> {
    /// The claim that a link makes, if it is one.
    pub fn of(left: &'e Expr, relation: Relation, right: &'e Expr) -> Option<Self> {
        let (lower, upper) = match relation {
            Relation::Less => (left, right),
            Relation::Greater => (right, left),
            Relation::Equal
            | Relation::NotEqual
            | Relation::LessEqual
            | Relation::GreaterEqual
            | Relation::Distributed
            | Relation::Approximately
            | Relation::Tends => return None,
        };
        let matrix = eigenvalues(lower)?;
        Some(Stability {
            matrix,
            bound: upper,
        })
    }
}

impl Evaluator<'_, '_> {
    pub(super) fn stable(&mut self, claim: &Stability<'_>) -> Result<Stable> {
        let span = claim.matrix.span;
        let fail = |reason: Reason| reason.at(span);
        let bound = self.scalar(claim.bound)?;
        let value = self.expression(claim.matrix)?;
        let matrix = value.square("eigenvalues").map_err(fail)?;
        if !bound.is_real() || matrix.iter().any(|e| !e.is_real()) {
            return Err(fail(Reason::Unsupported("complex matrices' eigenvalues")));
        }
        let a = &self.arithmetic;
        let shifted = Matrix::from_fn(matrix.rows(), matrix.columns(), |i, j| {
            if i == j {
                a.subtract(&matrix[(i, j)], &bound)
            } else {
                matrix[(i, j)].clone()
            }
        });
        let coefficients = a.characteristic_coefficients(&shifted).map_err(fail)?;
        let hurwitz = Arithmetic::hurwitz_matrix(&coefficients)
            .ok_or_else(|| fail(Reason::Unsupported("an empty matrix")))?;
        let mut truth = Truth::True;
        for order in 1..=hurwitz.rows() {
            let minor = a.determinant(&hurwitz.leading(order)).map_err(fail)?;
            match a.related(&minor, Relation::Greater, &Jet::zero()) {
                Truth::True => {}
                Truth::Unknown => truth = Truth::Unknown,
                Truth::False => {
                    return Ok(Stable {
                        truth: Truth::False,
                        matrix,
                        minor: Some(minor),
                    });
                }
            }
        }
        Ok(Stable {
            truth,
            matrix,
            minor: None,
        })
    }
}

/// The matrix in `Re λ(A)`.
fn eigenvalues(expr: &Expr) -> Option<&Expr> {
    let ExprKind::Call {
        function: Function::RealPart,
        argument,
    } = &expr.without_brackets().kind
    else {
        return None;
    };
    let is_lambda = |base: &str| base == EIGENVALUES;
    let argument = argument.without_brackets();
    if let ExprKind::Apply {
        function,
        arguments,
    } = &argument.kind
        && let [matrix] = arguments.as_slice()
    {
        return is_lambda(&function.letter.base).then_some(matrix);
    }
    if let ExprKind::Product(factors) = &argument.kind
        && let [lambda, matrix] = factors.as_slice()
    {
        let lambda = lambda.as_name()?;
        return is_lambda(&lambda.letter.base).then(|| matrix.without_brackets());
    }
    None
}
