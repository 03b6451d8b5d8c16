//! Functions without their arguments where the argument matters.
//!
//! With `f(\xi) = \xi^3` the bare name f is f at its own letter. In `\frac{df}{dx}`, `\int_0^1 f\,dx` and
//! `x \to 0, f \to 0` a reader takes it for f(x), and f(\xi) would depend on nothing: both readings are given
//! back, unless what f is made of depends on the letter in another way, as on a parameter or a process.

use super::names::Resolved;
use super::{Model, Node};
use crate::diagnostic::{Diagnostic, DiagnosticKind};
use crate::expr::walk::{children, varied_name};
use crate::expr::{Bracket, Expr, ExprKind, Name};
use crate::latex;
use std::collections::BTreeSet;

impl Model {
    /// Where an expression in which these letters vary has a function without its argument that may be one
    /// of them.
    pub(super) fn bare_functions(
        &self,
        expr: &Expr,
        varying: &mut Vec<Name>,
        report: &mut Vec<Diagnostic>,
    ) {
        if let Some(name) = expr.as_name() {
            self.bare_function(name, expr, varying, report);
        }
        if let ExprKind::Product(factors) = &expr.kind {
            for pair in factors.windows(2) {
                self.applied_together(&pair[0], &pair[1], report);
            }
        }
        // An index that names no letter only counts.
        let counts = |name: &Name| {
            matches!(expr.kind, ExprKind::BigSum { .. })
                && !matches!(self.resolve(name, &|_| false), Ok(Resolved::Letter { .. }))
        };
        let variable = varied_name(expr).filter(|name| !counts(name));
        let before = varying.len();
        varying.extend(variable.cloned());
        for child in children(expr) {
            self.bare_functions(child, varying, report);
        }
        varying.truncate(before);
    }

    /// `(f + g)(x)` and `fg(x)`, where f and g are functions without arguments of their own.
    fn applied_together(&self, first: &Expr, second: &Expr, report: &mut Vec<Diagnostic>) {
        let bracket = |e: &Expr| {
            matches!(
                e.kind,
                ExprKind::Group {
                    bracket: Bracket::Round,
                    ..
                }
            )
        };
        let mut bare = Vec::new();
        match (&first.kind, &second.kind) {
            (ExprKind::Group { inner, .. }, _) if bracket(first) && bracket(second) => {
                self.bare_nodes(inner, &mut bare);
            }
            (ExprKind::Name(_), ExprKind::Apply { function, .. })
                if matches!(
                    self.resolve(function, &|_| false),
                    Ok(Resolved::Node { .. } | Resolved::Primed { .. })
                ) =>
            {
                self.bare_nodes(first, &mut bare);
            }
            _ => return,
        }
        let functions = bare
            .iter()
            .any(|node| self.function_definition(*node).is_some());
        let itself = match &second.kind {
            ExprKind::Group { inner, .. } => Some(&**inner),
            ExprKind::Apply { arguments, .. } => match arguments.as_slice() {
                [only] => Some(only),
                _ => None,
            },
            _ => None,
        };
        let own = itself
            .and_then(Expr::as_name)
            .map(latex::canonical)
            .is_some_and(|name| {
                bare.iter()
                    .all(|node| self.own_letters(*node).contains(&name))
            });
        // At its own letter both readings of f are one.
        if !functions || own && matches!(first.kind, ExprKind::Name(_)) {
            return;
        }
        let readings = vec![
            "functions of what stands in the bracket, each written with its argument".to_owned(),
            "a product with functions at their own letters".to_owned(),
        ];
        report.push(Diagnostic::new(
            DiagnosticKind::Ambiguous { readings },
            first.span.to(second.span),
        ));
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
        let own = self.own_letters(node);
        if own.is_empty() {
            return;
        }
        let behind = self.symbols_behind(node, &|e| self.display(e));
        let depends = behind.iter().any(|symbol| {
            let mut made_of = self.argument_symbols(*symbol).chain([*symbol]);
            made_of.any(|s| varying.contains(&self.symbols[s].name))
        });
        let name = latex::canonical(name);
        if depends || varying.iter().any(|v| own.contains(&latex::canonical(v))) {
            return;
        }
        let own: Vec<String> = own.into_iter().collect();
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

    /// The letters of the functions that a node is, or is made of without their arguments.
    fn own_letters(&self, node: Node) -> BTreeSet<String> {
        let mut own = BTreeSet::new();
        let mut seen = BTreeSet::new();
        let mut open = vec![node];
        while let Some(node) = open.pop() {
            let Node::Definition(d) = node else {
                continue;
            };
            if let Some(function) = self.function_definition(node) {
                own.extend(function.arguments.iter().map(latex::canonical));
            } else if seen.insert(node) {
                let definition = &self.definitions[d];
                let display = self.display(definition.equation);
                if let Some(value) = definition.place.find(display) {
                    self.bare_nodes(value, &mut open);
                }
            }
        }
        own
    }

    /// What the names without arguments in an expression stand for, but for where it binds letters itself.
    fn bare_nodes(&self, expr: &Expr, found: &mut Vec<Node>) {
        match &expr.kind {
            ExprKind::Integral { .. }
            | ExprKind::BigSum { .. }
            | ExprKind::Derivative { .. }
            | ExprKind::Expectation(_) => return,
            ExprKind::Name(name) => {
                if let Ok(Resolved::Node { node, .. } | Resolved::Primed { node, .. }) =
                    self.resolve(name, &|_| false)
                {
                    found.push(node);
                }
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
            | ExprKind::Named { .. }
            | ExprKind::Tuple(_)
            | ExprKind::Cases(_)
            | ExprKind::Infinity
            | ExprKind::Constant => {}
        }
        for child in children(expr) {
            self.bare_nodes(child, found);
        }
    }
}
