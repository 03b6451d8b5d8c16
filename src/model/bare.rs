//! Functions without their arguments where the argument matters.
//!
//! With `f(\xi) = \xi^3` the bare name f is f at its own letter. In `\frac{df}{dx}`, `\int_0^1 f\,dx` and
//! `x \to 0, f \to 0` a reader takes it for f(x), and f(\xi) would depend on nothing: both readings are given
//! back, unless what f is made of depends on the letter in another way, as on a parameter or a process.

use super::Model;
use super::names::Resolved;
use crate::diagnostic::{Diagnostic, DiagnosticKind};
use crate::expr::walk::children;
use crate::expr::{Expr, ExprKind, Name};
use crate::latex;

impl Model {
    /// Where an expression in which these letters vary has a function without its argument that may be one
    /// of them.
    pub(super) fn bare_functions(
        &self,
        expr: &Expr,
        varying: &mut Vec<Name>,
        report: &mut Vec<Diagnostic>,
    ) {
        let variable = match &expr.kind {
            ExprKind::Integral { variable, .. }
            | ExprKind::Derivative {
                variable: Some(variable),
                ..
            } => Some(variable),
            // An index that names no letter only counts.
            ExprKind::BigSum { index, .. } => {
                matches!(self.resolve(index, &|_| false), Ok(Resolved::Letter { .. }))
                    .then_some(index)
            }
            ExprKind::Name(name) => {
                self.bare_function(name, expr, varying, report);
                None
            }
            ExprKind::Number(_)
            | ExprKind::Apply { .. }
            | ExprKind::Group { .. }
            | ExprKind::Underbrace { .. }
            | ExprKind::Sum(_)
            | ExprKind::Product(_)
            | ExprKind::Quotient { .. }
            | ExprKind::Power { .. }
            | ExprKind::Transpose(_)
            | ExprKind::Matrix { .. }
            | ExprKind::Call { .. }
            | ExprKind::Derivative { variable: None, .. }
            | ExprKind::Named { .. }
            | ExprKind::Tuple(_)
            | ExprKind::Expectation(_)
            | ExprKind::Cases(_)
            | ExprKind::Infinity
            | ExprKind::Constant => None,
        };
        let before = varying.len();
        varying.extend(variable.cloned());
        for child in children(expr) {
            self.bare_functions(child, varying, report);
        }
        varying.truncate(before);
    }

    fn bare_function(
        &self,
        name: &Name,
        expr: &Expr,
        varying: &[Name],
        report: &mut Vec<Diagnostic>,
    ) {
        let Some(innermost) = varying.last() else {
            return;
        };
        let Ok(Resolved::Node { node, .. } | Resolved::Primed { node, .. }) =
            self.resolve(name, &|_| false)
        else {
            return;
        };
        let Some(function) = self.function_definition(node) else {
            return;
        };
        let behind = self.symbols_behind(node, &|e| self.display(e));
        let depends = behind.iter().any(|symbol| {
            let mut made_of = self.argument_symbols(*symbol).chain([*symbol]);
            made_of.any(|s| varying.contains(&self.symbols[s].name))
        });
        if depends || function.arguments.iter().any(|own| varying.contains(own)) {
            return;
        }
        let name = latex::canonical(name);
        let own: Vec<String> = function.arguments.iter().map(latex::canonical).collect();
        let readings = vec![
            format!(
                "{name} at its own letter, written {name}({})",
                own.join(", ")
            ),
            format!(
                "a function of the letter that varies, written {name}({})",
                latex::canonical(innermost)
            ),
        ];
        report.push(Diagnostic::new(
            DiagnosticKind::Ambiguous { readings },
            expr.span,
        ));
    }
}
