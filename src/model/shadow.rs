//! Running indices with the name of a declared letter.
//!
//! In `\sum_{k=1}^{3} k x_k` the index hides the letter k, and that is what is meant. Where what is summed up
//! binds the letter again (an integral, a derivative), or reaches it by another name (a definition, a process
//! that is a function of it), the print does not say which of the two is meant.

use super::names::Resolved;
use super::{DefinitionKind, Model, Node, NotationKind};
use crate::diagnostic::{Diagnostic, DiagnosticKind};
use crate::expr::walk::children;
use crate::expr::{Expr, ExprKind, Name};
use crate::latex;
use crate::span::Span;
use std::collections::BTreeSet;

impl Model {
    /// Where an expression in which these indices run may mean the letter of the same name.
    pub(super) fn shadowed_letters(
        &self,
        expr: &Expr,
        indices: &mut Vec<String>,
        report: &mut Vec<Diagnostic>,
    ) {
        match &expr.kind {
            ExprKind::BigSum {
                index,
                from,
                to,
                body,
            } => {
                self.shadowed_letters(from, indices, report);
                self.shadowed_letters(to, indices, report);
                if self.is_constant(index) {
                    report.push(both(&latex::canonical(index), expr.span));
                }
                indices.push(latex::canonical(index));
                self.shadowed_letters(body, indices, report);
                indices.pop();
                return;
            }
            ExprKind::Integral { variable, .. }
            | ExprKind::Derivative {
                variable: Some(variable),
                ..
            } => {
                let variable = latex::canonical(variable);
                if indices.contains(&variable) {
                    report.push(both(&variable, expr.span));
                }
            }
            ExprKind::Name(name) => {
                let mut behind = self.symbols_behind_name(name, false);
                behind.extend(self.symbols_behind_entry(name, expr));
                self.report_shadowed(&behind, indices, expr.span, report);
            }
            ExprKind::Apply { function, .. } => {
                let behind = self.symbols_behind_name(function, true);
                self.report_shadowed(&behind, indices, expr.span, report);
            }
            ExprKind::Number(_)
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
            | ExprKind::Constant => {}
        }
        for child in children(expr) {
            self.shadowed_letters(child, indices, report);
        }
    }

    /// Whether the notation says that a name is a constant, such as e or i.
    fn is_constant(&self, name: &Name) -> bool {
        let kinds = self.notation.iter().filter(|n| n.name == *name);
        kinds
            .map(|n| &n.kind)
            .any(|kind| matches!(kind, NotationKind::Constant(_)))
    }

    /// The symbols that a name's value depends on beside itself; without those that a function gets as its
    /// arguments where it is applied.
    fn symbols_behind_name(&self, name: &Name, applied: bool) -> BTreeSet<usize> {
        match self.resolve(name, &|_| false) {
            Ok(Resolved::Letter { symbol, .. }) => self.argument_symbols(symbol).collect(),
            Ok(Resolved::Node { node, .. } | Resolved::Primed { node, .. }) => {
                self.symbols_behind_node(node, applied)
            }
            Ok(Resolved::Bound(_) | Resolved::Indexed { .. }) | Err(_) => BTreeSet::new(),
        }
    }

    /// The symbols that an entry of a matrix, or another number that belongs to one, depends on. A family binds
    /// its own index.
    fn symbols_behind_entry(&self, name: &Name, expr: &Expr) -> BTreeSet<usize> {
        if !matches!(self.resolve(name, &|_| false), Ok(Resolved::Indexed { .. })) {
            return BTreeSet::new();
        }
        let mut nodes = BTreeSet::new();
        self.collect(expr, &mut nodes);
        let family = |node: &Node| {
            matches!(node, Node::Definition(d)
                if matches!(self.definitions[*d].kind, DefinitionKind::Family { .. }))
        };
        let nodes = nodes.into_iter().filter(|node| !family(node));
        nodes
            .flat_map(|node| self.symbols_behind(node, &|e| self.display(e)))
            .collect()
    }

    fn symbols_behind_node(&self, node: Node, applied: bool) -> BTreeSet<usize> {
        let mut behind = self.symbols_behind(node, &|e| self.display(e));
        if applied && let Some(definition) = self.function_definition(node) {
            for argument in &definition.arguments {
                if let Ok(Resolved::Letter { symbol, .. }) = self.resolve(argument, &|_| false) {
                    behind.remove(&symbol);
                }
            }
        }
        behind
    }

    fn report_shadowed(
        &self,
        behind: &BTreeSet<usize>,
        indices: &[String],
        span: Span,
        report: &mut Vec<Diagnostic>,
    ) {
        let names = behind
            .iter()
            .map(|s| latex::canonical(&self.symbols[*s].name));
        if let Some(name) = names.into_iter().find(|name| indices.contains(name)) {
            report.push(both(&name, span));
        }
    }
}

fn both(name: &str, span: Span) -> Diagnostic {
    let readings = vec![
        format!("what depends on the running index {name}"),
        format!("what depends on the letter {name} that is declared"),
    ];
    Diagnostic::new(DiagnosticKind::Ambiguous { readings }, span)
}
