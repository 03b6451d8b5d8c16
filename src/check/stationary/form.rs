//! Matrices that are called covariances and have a shape or a form that none has.
//!
//! The covariance of two vectors has as many rows as the first has entries and as many columns as the second;
//! that of a vector with itself is symmetric.

use super::super::Checker;
use crate::evaluate::{FailureKind, Value};
use crate::model::Node;
use crate::verdict::Verdict;

impl Checker<'_> {
    /// The verdict on an equation that gives a covariance a value which is none by its form. From now on it has
    /// no value.
    pub(super) fn malformed_covariance(&mut self, node: Node) -> Option<Verdict> {
        let what = self.form_of_none(node)?;
        let kind = FailureKind::Unsupported { what: what.into() };
        self.has_no_value(node, kind);
        Some(Verdict::Undecided {
            reason: format!("it is {what}"),
        })
    }

    fn form_of_none(&mut self, node: Node) -> Option<&'static str> {
        let equation = self.model.equation_giving(node)?;
        let mut own = self.model.covariances();
        let (_, _, covariance) = own.find(|(_, n, _)| *n == node)?;
        let (itself, product) = (covariance.left == covariance.right, &covariance.product);
        let conditions = self.exact.conditions.clone();
        let quantities = self.exact.expression_without_cases(product);
        let span = self.model.equations[equation].span;
        let value = self.exact.value_of((node, Vec::new(), 0), span);
        self.exact.conditions = conditions;
        let (quantities, value) = (quantities.ok()?, value.ok()?);
        let shape = |value: &Value<_>| value.shape().unwrap_or((1, 1));
        if !matches!(value, Value::Zero) && shape(&quantities) != shape(&value) {
            return Some("a covariance of another shape than its random quantities");
        }
        let symmetric = match &value {
            Value::Matrix(m) if itself => {
                (0..m.rows()).all(|i| (0..i).all(|j| m[(i, j)] == m[(j, i)]))
            }
            Value::Matrix(_) | Value::Scalar(_) | Value::Zero => true,
        };
        (!symmetric).then_some("a covariance that is not symmetric")
    }
}
