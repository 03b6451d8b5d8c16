//! Names without a meaning, and definitions that need themselves.

use super::links::each_expression;
use super::names::{Element, Resolved, literal_integer};
use super::{DefinitionKind, Model, Node, NotationKind, Role};
use crate::diagnostic::{Diagnostic, DiagnosticKind};
use crate::expr::walk::children;
use crate::expr::{Chain, Display, Expr, ExprKind, Relation};
use crate::latex;
use crate::span::Span;
use std::collections::BTreeSet;

impl Model {
    /// One diagnostic for each name in an equation or a notation that has no meaning.
    pub(super) fn check_names(&self) -> Vec<Diagnostic> {
        let mut report = Vec::new();
        // The letters that sizes depend on stand for numbers everywhere.
        let sizes: Vec<String> = self.instances[0].keys().cloned().collect();
        for (e, equation) in self.equations.iter().enumerate() {
            if !matches!(equation.role, Role::Recall(_)) {
                report.extend(self.check_names_of(e, &equation.display));
            }
        }
        for expression in self
            .statements
            .iter()
            .flat_map(|s| &s.propositions)
            .flat_map(|p| p.expressions())
        {
            self.check_expression(expression, &mut Vec::new(), &mut report);
        }
        for notation in &self.notation {
            if let Some(target) = notation.kind.target() {
                self.check_expression(target, &mut sizes.clone(), &mut report);
            }
        }
        report
    }

    /// The same for one equation, if it read so.
    pub(crate) fn check_names_of(&self, equation: usize, display: &Display) -> Vec<Diagnostic> {
        let mut report = Vec::new();
        let sizes: Vec<String> = self.instances[0].keys().cloned().collect();
        let equation = &self.equations[equation];
        let mut tending = Vec::new();
        for (clause_index, clause) in display.clauses.iter().enumerate() {
            let mut bound: Vec<String> = clause
                .ranges
                .iter()
                .map(|r| latex::canonical(&r.index))
                .chain(sizes.iter().cloned())
                .collect();
            let indices = clause.ranges.iter().map(|r| latex::canonical(&r.index));
            let mut indices: Vec<String> = indices.collect();
            let none = equation.settings.recalled_members.is_empty();
            let recalled = |member: usize| {
                !none
                    && equation.links.iter().any(|l| {
                        l.left.clause() == clause_index
                            && equation.settings.recalled_members.contains_key(&l.member)
                            && l.right
                                == super::links::Place::Member {
                                    clause: clause_index,
                                    member,
                                }
                    })
            };
            for (m, member) in clause.chain.members.iter().enumerate() {
                if !recalled(m) {
                    self.check_expression(member, &mut bound, &mut report);
                    self.shadowed_letters(member, &mut indices, &mut report);
                    self.bare_functions(member, &mut tending, &mut report);
                    self.overlapping_cases(member, &mut report);
                }
            }
            if let (Some(Relation::Tends), ExprKind::Name(letter)) = (
                clause.chain.relations.first(),
                &clause.chain.members[0].kind,
            ) {
                tending.push(letter.clone());
            }
            for (_, label) in super::links::underbraces(&clause.chain) {
                for member in &label.members {
                    self.check_expression(member, &mut bound, &mut report);
                }
            }
        }
        for given in equation.given.iter().chain(&equation.assume) {
            for side in [&given.left, &given.right] {
                self.check_expression(side, &mut sizes.clone(), &mut report);
            }
        }
        report
    }

    /// Whether what `nodes`, which an equation gives values, would need themselves if it read so.
    pub(crate) fn would_need_itself(
        &self,
        equation: usize,
        display: &Display,
        nodes: &BTreeSet<Node>,
    ) -> bool {
        nodes.iter().any(|node| {
            let mut used = BTreeSet::new();
            let displays = |e: usize| match e == equation {
                true => display,
                false => self.display(e),
            };
            self.each_value(*node, &displays, &mut |e| self.collect_name(e, &mut used));
            let itself = match node {
                Node::Unknown { .. } => true,
                Node::Definition(d) => {
                    matches!(self.definitions[*d].kind, DefinitionKind::Family { .. })
                }
                _ => false,
            };
            let mut open: Vec<Node> = used.into_iter().filter(|n| !itself || n != node).collect();
            let mut seen = BTreeSet::new();
            while let Some(next) = open.pop() {
                if next == *node {
                    return true;
                }
                if seen.insert(next) {
                    let mut needs = BTreeSet::new();
                    match next {
                        Node::Notation(_) => needs = self.needs(next),
                        _ => self.each_value(next, &displays, &mut |e| {
                            self.collect_name(e, &mut needs);
                        }),
                    }
                    open.extend(needs);
                }
            }
            false
        })
    }

    fn check_expression(&self, expr: &Expr, bound: &mut Vec<String>, report: &mut Vec<Diagnostic>) {
        match &expr.kind {
            ExprKind::Name(name) | ExprKind::Apply { function: name, .. } => {
                let known = |n: &str| bound.iter().any(|b| b == n);
                let resolved = self.resolve(name, &known);
                let (indexed, rate) = match resolved {
                    Err(kind) => {
                        report.push(Diagnostic::new(kind, expr.span));
                        (false, false)
                    }
                    Ok(Resolved::Bound(_)) => (false, false),
                    Ok(Resolved::Letter { order, .. }) => (false, name.dots > 0 && order > 0),
                    Ok(Resolved::Node { derivatives, .. }) => (false, derivatives > 0),
                    Ok(Resolved::Primed { .. }) => (false, name.dots > 0),
                    Ok(Resolved::Indexed { .. }) => (true, false),
                };
                if rate && self.times.is_empty() {
                    report.push(no_time(expr));
                }
                if let (true, Some(subscript)) = (indexed, &name.subscript) {
                    for index in &subscript.indices {
                        if literal_integer(index).is_none() {
                            self.check_expression(index, bound, report);
                        }
                    }
                }
            }
            ExprKind::Derivative {
                variable: None,
                body,
                ..
            } => {
                if self.times.is_empty() {
                    report.push(no_time(expr));
                }
                self.check_expression(body, bound, report);
            }
            // The power of a name may be defined where the name itself is not.
            ExprKind::Power { base, .. }
                if matches!(&base.kind, ExprKind::Name(n)
                    if self.has_power_of(&latex::canonical(n))) => {}
            ExprKind::BigSum {
                index,
                from,
                to,
                body,
            } => {
                self.check_expression(from, bound, report);
                self.check_expression(to, bound, report);
                bound.push(latex::canonical(index));
                self.check_expression(body, bound, report);
                bound.pop();
            }
            ExprKind::Integral { variable, .. } => {
                bound.push(latex::canonical(variable));
                for child in children(expr) {
                    self.check_expression(child, bound, report);
                }
                bound.pop();
            }
            _ => {
                for child in children(expr) {
                    self.check_expression(child, bound, report);
                }
            }
        }
    }

    /// One diagnostic for each circle of definitions.
    pub(super) fn find_cycles(&self) -> Vec<Diagnostic> {
        let mut report = Vec::new();
        let mut done: BTreeSet<Node> = BTreeSet::new();
        let nodes = (0..self.definitions.len())
            .map(Node::Definition)
            .chain((0..self.notation.len()).map(Node::Notation))
            .chain((0..self.systems.len()).map(|system| Node::Unknown {
                system,
                position: 0,
            }));
        for start in nodes {
            let mut path = Vec::new();
            if let Some(cycle) = self.descend(start, &mut path, &mut done) {
                let span = self.node_span(cycle[0]);
                let names = cycle.iter().map(|n| self.node_name(*n)).collect();
                report.push(Diagnostic::new(
                    DiagnosticKind::CyclicDefinition { cycle: names },
                    span,
                ));
            }
        }
        report
    }

    fn descend(
        &self,
        node: Node,
        path: &mut Vec<Node>,
        done: &mut BTreeSet<Node>,
    ) -> Option<Vec<Node>> {
        if done.contains(&node) {
            return None;
        }
        if let Some(at) = path.iter().position(|n| *n == node) {
            let cycle = path[at..].to_vec();
            done.extend(cycle.iter().copied());
            // A family that needs its own members is a recursion by index, decided when evaluated;
            // the unknown of a solve block stands in its own equation.
            let itself = cycle.len() == 1
                && match node {
                    Node::Unknown { .. } => true,
                    Node::Definition(d) => {
                        matches!(self.definitions[d].kind, DefinitionKind::Family { .. })
                    }
                    _ => false,
                };
            return (!itself).then_some(cycle);
        }
        path.push(node);
        for next in self.needs(node) {
            if let Some(cycle) = self.descend(next, path, done) {
                return Some(cycle);
            }
        }
        path.pop();
        done.insert(node);
        None
    }

    /// The nodes that a node's value is computed from; all unknowns of a system count as one.
    pub fn needs(&self, node: Node) -> BTreeSet<Node> {
        let mut found = BTreeSet::new();
        match node {
            Node::Symbol(_) | Node::Matrix(_) => {}
            Node::Definition(d) => {
                let definition = &self.definitions[d];
                let display = &self.equations[definition.equation].display;
                if let Some(value) = definition.place.find(display) {
                    self.collect(value, &mut found);
                }
                // Whether it is one of these depends on the argument.
                let own = self.exceptions(d);
                found.extend(own.iter().map(|(_, value)| Node::Definition(*value)));
                if !own.is_empty() {
                    let letters = definition.arguments.iter();
                    let letters =
                        letters.filter_map(|l| self.names.whole.get(&latex::canonical(l)));
                    found.extend(letters.map(|node| normal(*node)));
                }
            }
            Node::Notation(n) => {
                if let Some(target) = self.notation[n].kind.target() {
                    self.collect(target, &mut found);
                }
                if matches!(self.notation[n].kind, NotationKind::Covariance(_)) {
                    self.collect_covariances(&mut found);
                }
            }
            Node::Unknown { system, .. } => {
                let display = &self.equations[self.systems[system].equation].display;
                each_expression(display, &mut |e| self.collect_name(e, &mut found));
            }
        }
        found
    }

    /// An equation as printed.
    pub fn display(&self, equation: usize) -> &Display {
        &self.equations[equation].display
    }

    /// The symbols that a node's value is computed from, through all definitions, where the equations
    /// have these displays.
    pub fn symbols_behind<'d>(
        &self,
        node: Node,
        display: &impl Fn(usize) -> &'d Display,
    ) -> BTreeSet<usize> {
        let mut seen = BTreeSet::new();
        let mut open = vec![node];
        let mut symbols = BTreeSet::new();
        while let Some(node) = open.pop() {
            if !seen.insert(node) {
                continue;
            }
            if let Node::Symbol(symbol) = node {
                symbols.insert(symbol);
            }
            open.extend(self.needs(node));
            self.each_value(node, display, &mut |e| {
                let mut used = BTreeSet::new();
                self.collect_name(e, &mut used);
                open.extend(used);
                if let ExprKind::Name(name) | ExprKind::Apply { function: name, .. } = &e.kind
                    && let Ok(Resolved::Letter { symbol, .. }) = self.resolve(name, &|_| false)
                {
                    symbols.insert(symbol);
                }
            });
        }
        // A process depends on what it is a function of.
        let arguments: Vec<usize> = symbols
            .iter()
            .flat_map(|s| self.argument_symbols(*s))
            .collect();
        symbols.extend(arguments);
        symbols
    }

    /// Sees every part of an expression and of all that its value is computed from, through all
    /// definitions, where the equations have these displays.
    pub fn visit_behind<'d>(
        &self,
        expr: &Expr,
        display: &impl Fn(usize) -> &'d Display,
        see: &mut impl FnMut(&Expr),
    ) {
        let mut seen = BTreeSet::new();
        let mut open = BTreeSet::new();
        crate::expr::walk::visit(expr, &mut |e| {
            see(e);
            self.collect_name(e, &mut open);
        });
        while let Some(node) = open.pop_first() {
            if !seen.insert(node) {
                continue;
            }
            let mut used = self.needs(node);
            self.each_value(node, display, &mut |e| {
                see(e);
                self.collect_name(e, &mut used);
            });
            open.extend(used);
        }
    }

    /// The symbols that a declared symbol is a function of.
    pub fn argument_symbols(&self, symbol: usize) -> impl Iterator<Item = usize> {
        self.symbols[symbol].arguments.iter().filter_map(|name| {
            match self.resolve(name, &|_| false) {
                Ok(Resolved::Letter { symbol, order: 0 }) => Some(symbol),
                _ => None,
            }
        })
    }

    /// Every expression that a node's value is computed from directly.
    fn each_value<'d>(
        &self,
        node: Node,
        display: &impl Fn(usize) -> &'d Display,
        see: &mut impl FnMut(&Expr),
    ) {
        match node {
            Node::Symbol(_) | Node::Matrix(_) => {}
            Node::Definition(d) => {
                let definition = &self.definitions[d];
                if let Some(value) = definition.place.find(display(definition.equation)) {
                    crate::expr::walk::visit(value, &mut |e| {
                        see(e);
                        // Which case it is depends on the letters of the conditions.
                        for member in conditions(e).flat_map(|chain| &chain.members) {
                            crate::expr::walk::visit(member, &mut |c| see(c));
                        }
                    });
                }
            }
            Node::Notation(n) => {
                if let Some(target) = self.notation[n].kind.target() {
                    crate::expr::walk::visit(target, &mut |e| see(e));
                }
            }
            Node::Unknown { system, .. } => {
                each_expression(display(self.systems[system].equation), &mut |e| see(e));
            }
        }
    }

    /// The nodes that an expression uses directly.
    pub fn collect(&self, expr: &Expr, found: &mut BTreeSet<Node>) {
        crate::expr::walk::visit(expr, &mut |e| self.collect_name(e, found));
    }

    /// What an expectation is computed from: the covariances and their vectors.
    fn collect_covariances(&self, found: &mut BTreeSet<Node>) {
        for (_, node, covariance) in self.covariances() {
            found.insert(normal(node));
            self.collect(&covariance.product, found);
        }
    }

    fn collect_name(&self, expr: &Expr, found: &mut BTreeSet<Node>) {
        let name = match &expr.kind {
            ExprKind::Name(name) | ExprKind::Apply { function: name, .. } => name,
            ExprKind::Power { base, exponent } => {
                if let (ExprKind::Name(name), Some(n)) = (&base.kind, literal_integer(exponent))
                    && let Some((node, _)) =
                        u32::try_from(n).ok().and_then(|n| self.power_node(name, n))
                {
                    found.insert(node);
                }
                return;
            }
            ExprKind::Expectation(_) => return self.collect_covariances(found),
            _ => return,
        };
        // What is bound here is not known: an index may be any letter that means nothing else.
        let index = |n: &str| !self.names.whole.contains_key(n) && *n != latex::canonical(name);
        match self.resolve(name, &index) {
            Ok(Resolved::Node { node, .. } | Resolved::Primed { node, .. }) => {
                found.insert(normal(node));
            }
            Ok(Resolved::Indexed { key, indices }) => {
                let literal: Option<Vec<i64>> =
                    indices.iter().map(|i| literal_integer(i)).collect();
                let elements = literal.map_or_else(Vec::new, |l| self.elements(&key, &l));
                for element in &elements {
                    let (Element::Node(node) | Element::Member(node, _) | Element::Entry(node, _)) =
                        element;
                    found.insert(normal(*node));
                }
                if elements.is_empty() {
                    let families = self.names.families.iter();
                    found.extend(families.filter(|((k, _), _)| *k == key).map(|(_, n)| *n));
                    found.extend(self.names.whole.get(&key).map(|n| normal(*n)));
                    // Unknowns that differ by an index, of which it may be any.
                    let members = self.names.elements.iter().filter(|((k, _), _)| *k == key);
                    let unknown = |node: &Node| matches!(node, Node::Unknown { .. });
                    found.extend(members.map(|(_, n)| normal(*n)).filter(unknown));
                }
            }
            _ => {}
        }
    }

    fn node_name(&self, node: Node) -> String {
        match node {
            Node::Symbol(s) => latex::canonical(&self.symbols[s].name),
            Node::Matrix(m) => latex::canonical(&self.matrices[m].name),
            Node::Definition(d) => latex::canonical(&self.definitions[d].name),
            Node::Notation(n) => latex::canonical(&self.notation[n].name),
            Node::Unknown { system, position } => {
                latex::canonical(&self.systems[system].unknowns[position])
            }
        }
    }

    fn node_span(&self, node: Node) -> Span {
        match node {
            Node::Definition(d) => {
                let definition = &self.definitions[d];
                let equation = &self.equations[definition.equation];
                definition
                    .place
                    .find(&equation.display)
                    .map_or(equation.span, |e| e.span)
            }
            Node::Unknown { system, .. } => self.equations[self.systems[system].equation].span,
            Node::Notation(n) => self.document.notation[n].name.span,
            Node::Symbol(s) => self.document.symbols[self.symbols[s].declared].name.span,
            Node::Matrix(m) => self.document.symbols[self.matrices[m].declared].name.span,
        }
    }
}

/// A dot in a document without a time.
fn no_time(expr: &Expr) -> Diagnostic {
    let name = latex::write_expr(expr);
    Diagnostic::new(DiagnosticKind::NoTime { name }, expr.span)
}

fn normal(node: Node) -> Node {
    match node {
        Node::Unknown { system, .. } => Node::Unknown {
            system,
            position: 0,
        },
        node => node,
    }
}

/// The conditions of cases.
fn conditions(expr: &Expr) -> impl Iterator<Item = &Chain> {
    let cases: &[(Expr, Vec<Chain>)] = match &expr.kind {
        ExprKind::Cases(cases) => cases,
        _ => &[],
    };
    cases.iter().flat_map(|(_, conditions)| conditions)
}
