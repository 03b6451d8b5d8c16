//! What a search spends, and how much it may.
//!
//! Work is counted in steps: one for each operation on a number modulo the prime and for each node that
//! is put in, and so many for each term of an exact value. Only what a candidate itself costs counts,
//! not what is computed once for all of them, so that the count is the same on any number of threads.

use crate::evaluate::Value;
use crate::expr::walk::visit;
use crate::expr::{Expr, ExprKind};
use ratpoly::RationalFunction;

/// Steps for each node of an expression that the evaluator computes.
const EVALUATED: u64 = 8;
/// How many nodes a function counts as.
const FUNCTION: u64 = 400;

/// Steps for each term of an exact value.
const TERM: u64 = 40;

/// How many steps of the exact engine are one of a search where it is asked, and where it is not: there
/// a step is an operation on a number with all that is done around it.
const ENGINE: u64 = 16;
const NUMBERS: u64 = 4;

/// What was spent, or may be.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct Spent {
    /// Candidates that were looked at.
    pub tried: usize,
    /// Steps.
    pub work: u64,
}

impl Spent {
    /// Both together.
    pub fn and(self, other: Spent) -> Spent {
        Spent {
            tried: self.tried.saturating_add(other.tried),
            work: self.work.saturating_add(other.work),
        }
    }

    /// What is left of it after some was spent.
    pub fn less(self, spent: Spent) -> Spent {
        Spent {
            tried: self.tried.saturating_sub(spent.tried),
            work: self.work.saturating_sub(spent.work),
        }
    }

    /// Whether either of the two has come to a limit.
    pub fn reaches(self, limit: Spent) -> bool {
        self.tried >= limit.tried || self.work >= limit.work
    }
}

/// How many nodes an expression has.
pub(super) fn size(expr: &Expr) -> u64 {
    let mut count = 0;
    visit(expr, &mut |_| count += 1);
    count
}

/// What the evaluator spends on an expression.
///
/// A function is dear: its argument is factored, and its letters are sought.
pub(super) fn evaluated(expr: &Expr) -> u64 {
    let mut functions = 0;
    visit(expr, &mut |e| {
        functions += u64::from(matches!(
            e.kind,
            ExprKind::Call { .. } | ExprKind::Integral { .. }
        ));
    });
    EVALUATED * (size(expr) + FUNCTION * functions)
}

/// What so many steps of the exact engine count.
pub(super) fn engine(steps: u64) -> u64 {
    steps / ENGINE
}

/// What steps of a search count among those of the exact engine.
pub(super) fn of_engine(steps: u64, functions: bool) -> u64 {
    steps.saturating_mul(if functions { ENGINE } else { NUMBERS })
}

/// What one operation with such a result and so many operands costs: a product of matrices is dear.
pub(super) fn operation<E>(value: Option<&Value<E>>, operands: usize) -> u64 {
    let operands = operands as u64 + 1;
    match value {
        Some(Value::Matrix(m)) => {
            let (rows, columns) = m.shape();
            operands * (rows * columns * rows.max(columns)) as u64
        }
        Some(Value::Scalar(_) | Value::Zero) | None => operands,
    }
}

/// What some exact values cost.
pub(super) fn exact<'v>(values: impl IntoIterator<Item = &'v RationalFunction>) -> u64 {
    let terms = |value: &RationalFunction| {
        let count = value.numerator().terms().count() + value.denominator().terms().count();
        count as u64
    };
    values.into_iter().map(|value| TERM * terms(value)).sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_limit_is_reached_by_either() {
        let limit = Spent {
            tried: 10,
            work: 100,
        };
        let one = Spent { tried: 9, work: 50 };
        assert!(!one.reaches(limit));
        assert!(one.and(Spent { tried: 1, work: 0 }).reaches(limit));
        assert!(one.and(Spent { tried: 0, work: 50 }).reaches(limit));
        assert_eq!(limit.less(one), Spent { tried: 1, work: 50 });
        assert_eq!(one.less(limit), Spent::default());
    }
}
