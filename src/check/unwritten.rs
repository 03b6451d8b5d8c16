//! What a print leaves unsaid, so that nothing can be said of it.
//!
//! A hypothesis is an equation at every moment or at one only, along the way to a limit or at its end; which of
//! them is meant is not written, and what is random, what is differentiated and what goes to a limit depends
//! on it.

use super::Checker;
use super::rates::Timed;
use crate::expr::walk::{children, mentions, visit};
use crate::expr::{Expr, ExprKind, Function, Name, Relation};
use crate::functions::{FunctionLetter, Sign};
use crate::model::links::Link;
use crate::model::names::Resolved;
use crate::model::{Hypothesis, Node};
use ratpoly::RationalFunction;
use std::collections::BTreeSet;

impl Checker<'_> {
    /// Why nothing can be said of a link: what its hypotheses or declarations mean is not written.
    pub(super) fn unwritten(&self, equation: usize, link: &Link) -> Option<&'static str> {
        let display = self.exact.display(equation);
        if link.relation == Relation::Tends {
            let mut goes = display.clauses.iter().filter_map(|clause| {
                let first = clause.chain.members.first()?;
                let tends = clause.chain.relations.first() == Some(&Relation::Tends);
                match &first.kind {
                    ExprKind::Name(name) if tends => Some(name),
                    _ => None,
                }
            });
            let sides = [link.left, link.right];
            let sides: Vec<&Expr> = sides.iter().filter_map(|p| p.find(display)).collect();
            return goes.find_map(|name| {
                if self.ties(equation, name) || self.bounds_by_others(equation, name, |_| true) {
                    Some("a hypothesis ties the letter that goes to a limit")
                } else if sides.iter().any(|side| self.moves_with(side, name)) {
                    Some("how a process goes with the letter that goes to a limit is not written")
                } else {
                    None
                }
            });
        }
        if let Some(reason) = self.constant_in_pieces(equation, link) {
            return Some(reason);
        }
        let (mut tied, mut integrated, mut cornered, mut moved, mut moments) =
            (false, false, false, false, false);
        for place in [link.left, link.right] {
            let Some(side) = place.find(display) else {
                continue;
            };
            visit(side, &mut |e| {
                moments |= matches!(e.kind, ExprKind::Expectation(_));
                match &e.kind {
                    ExprKind::Derivative {
                        variable: Some(variable),
                        body,
                        ..
                    } if !self.model.is_time(variable) => {
                        tied |= self.ties(equation, variable) || self.pinches(equation, variable);
                        // The curly one holds all others fixed.
                        moved |= !self.model.is_partial(e.span) && self.moves_with(body, variable);
                        cornered |= self.ends_at(equation, variable) && self.has_corners(body);
                    }
                    ExprKind::Derivative { body, .. } => {
                        cornered |= self.has_bounded_process(equation) && self.has_corners(body);
                    }
                    ExprKind::Integral { variable, body, .. } => {
                        integrated |= self.ties(equation, variable);
                        moved |= self.moves_with(body, variable);
                    }
                    _ => {}
                }
            });
        }
        let timed = || self.ties_the_time(equation) || self.timed(equation) != Timed::No;
        if self.has_rates(equation, link) && timed() {
            return Some(
                "a hypothesis is about the time: whether it holds at a moment or always is not written",
            );
        }
        if !self.random_constants().is_empty() && self.has_expectations(equation, link) {
            return Some(
                "a covariance is declared of letters that are functions of nothing: declare them as \
                 functions of the time",
            );
        }
        if self.ties_processes(equation) && (moments || self.has_moments(equation, link)) {
            return Some(
                "a hypothesis ties what is random: which moments it has then is not written",
            );
        }
        if moved {
            return Some("how processes go with each other is not written");
        }
        if self.moves_by_itself(equation) {
            return Some("a hypothesis is about a process whose motion the document determines");
        }
        if integrated {
            return Some("a hypothesis ties the letter over which is integrated");
        }
        if cornered {
            return Some("at the end of the range of its letter the derivative may not exist");
        }
        tied.then_some(
            "a hypothesis ties the letter by which is differentiated: what depends on it is not written",
        )
    }

    /// Why what is said to be some constant may be one in pieces only: its derivative says nothing of jumps.
    fn constant_in_pieces(&self, equation: usize, link: &Link) -> Option<&'static str> {
        let model = self.model;
        let own = self.exact.display(equation);
        let (left, right) = (link.left.find(own)?, link.right.find(own)?);
        let side = match (&left.kind, &right.kind) {
            (_, ExprKind::Constant) => left,
            (ExprKind::Constant, _) => right,
            _ => return None,
        };
        let mut cases = false;
        let display = |e: usize| self.exact.display(e);
        model.visit_behind(side, &display, &mut |e| {
            cases |= matches!(e.kind, ExprKind::Cases(_));
        });
        if cases {
            return Some("what is defined by cases may be another constant in each of them");
        }
        let mut exact = self.unsupposed();
        let value = exact.expression(side).ok()?;
        let table = exact.field.table()?;
        let jumps = |letter: usize| {
            let Some(FunctionLetter::Root(radicand)) = table.meaning(letter) else {
                return false;
            };
            let radicand = RationalFunction::from(radicand);
            let symbols = table.letters_behind(&radicand);
            let open = symbols.into_iter().any(|l| table.meaning(l).is_none());
            open && table.known_sign(&radicand) != Some(Sign::Positive)
        };
        let elements = value.entries().into_iter();
        let mut behind = elements.flat_map(|f| table.letters_behind(f));
        behind
            .any(jumps)
            .then_some("a root may be another constant on each side of where it vanishes")
    }

    pub(super) fn hypotheses_of(&self, equation: usize) -> impl Iterator<Item = &Hypothesis> {
        let printed = &self.model.equations[equation];
        printed.assume.iter().chain(&printed.given)
    }

    /// Whether an equation among the hypotheses has a letter.
    fn ties(&self, equation: usize, name: &Name) -> bool {
        let mut equations = self
            .hypotheses_of(equation)
            .filter(|h| h.relation == Relation::Equal);
        equations.any(|h| mentions(&h.left, name) || mentions(&h.right, name))
    }

    /// Whether an order that may be an equality, among the hypotheses, is between a letter and others.
    fn pinches(&self, equation: usize, name: &Name) -> bool {
        let orders = [Relation::LessEqual, Relation::GreaterEqual];
        self.bounds_by_others(equation, name, |relation| orders.contains(&relation))
    }

    /// Whether such a relation among the hypotheses is between a letter and others.
    fn bounds_by_others(
        &self,
        equation: usize,
        name: &Name,
        such: impl Fn(Relation) -> bool,
    ) -> bool {
        let mut hypotheses = self.hypotheses_of(equation).filter(|h| such(h.relation));
        hypotheses.any(|h| {
            let sides = [&h.left, &h.right];
            let (mut own, mut others) = (false, false);
            for side in sides {
                visit(side, &mut |e| {
                    if let ExprKind::Name(n) | ExprKind::Apply { function: n, .. } = &e.kind {
                        own |= n == name;
                        others |= n != name;
                    }
                });
            }
            own && others
        })
    }

    /// Whether an equation among the hypotheses has a time and nothing that changes with it.
    fn ties_the_time(&self, equation: usize) -> bool {
        let mut equations = self
            .hypotheses_of(equation)
            .filter(|h| h.relation == Relation::Equal);
        equations.any(|h| {
            let sides = [&h.left, &h.right];
            let mut timed = false;
            for side in sides {
                visit(side, &mut |e| {
                    if let ExprKind::Name(name) = &e.kind {
                        timed |= self.model.is_time(name);
                    }
                });
            }
            timed && !sides.into_iter().any(|side| self.is_random(side))
        })
    }

    /// Whether an equation among the hypotheses is about processes of which the document gives all a rate:
    /// nothing is left for which it could be solved.
    fn moves_by_itself(&self, equation: usize) -> bool {
        let mut equations = self
            .hypotheses_of(equation)
            .filter(|h| h.relation == Relation::Equal);
        equations.any(|h| {
            let (mut moving, mut free) = (false, false);
            for side in [&h.left, &h.right] {
                visit(side, &mut |e| {
                    if let ExprKind::Name(name) | ExprKind::Apply { function: name, .. } = &e.kind
                        && let Ok(Resolved::Letter { symbol, .. }) =
                            self.model.resolve(&name.undotted(), &|_| false)
                        && self.is_process(symbol)
                    {
                        match self.has_own_motion(symbol) {
                            true => moving = true,
                            false => free = true,
                        }
                    }
                });
            }
            moving && !free
        })
    }

    /// Whether the range of a letter, declared or supposed, has an end that belongs to it.
    fn ends_at(&self, equation: usize, name: &Name) -> bool {
        let mut bounds = self
            .hypotheses_of(equation)
            .filter(|h| matches!(h.relation, Relation::LessEqual | Relation::GreaterEqual));
        if bounds.any(|h| mentions(&h.left, name) || mentions(&h.right, name)) {
            return true;
        }
        let Ok(Resolved::Letter { symbol, .. }) = self.model.resolve(name, &|_| false) else {
            return false;
        };
        let range = &self.model.symbols[symbol].range;
        let ends = [&range.low, &range.high];
        ends.into_iter().flatten().any(|end| end.included)
    }

    /// Whether a hypothesis gives what processes stand in an end that belongs to its range.
    fn has_bounded_process(&self, equation: usize) -> bool {
        let mut bounds = self
            .hypotheses_of(equation)
            .filter(|h| matches!(h.relation, Relation::LessEqual | Relation::GreaterEqual));
        bounds.any(|h| self.is_random(&h.left) || self.is_random(&h.right))
    }

    /// Whether something that is not smooth stands behind an expression.
    pub(super) fn has_corners(&self, expr: &Expr) -> bool {
        let mut found = false;
        let display = |e: usize| self.exact.display(e);
        self.model.visit_behind(expr, &display, &mut |e| {
            found |= matches!(
                e.kind,
                ExprKind::Cases(_)
                    | ExprKind::Call {
                        function: Function::Absolute | Function::SquareRoot,
                        ..
                    }
            );
        });
        found
    }

    /// Whether a process that is a function of a letter stands behind an expression.
    pub(super) fn moves_with(&self, expr: &Expr, letter: &Name) -> bool {
        let model = self.model;
        let Ok(Resolved::Letter { symbol: goes, .. }) = model.resolve(letter, &|_| false) else {
            return false;
        };
        // With a process its rates move, the time, and all that changes with the time.
        let process = self.is_process(goes);
        let mut found = false;
        let display = |e: usize| self.exact.display(e);
        model.visit_behind(expr, &display, &mut |e| {
            if let ExprKind::Name(name) | ExprKind::Apply { function: name, .. } = &e.kind {
                match model.resolve(name, &|_| false) {
                    Ok(Resolved::Letter { symbol, order }) => {
                        found |= model.argument_symbols(symbol).any(|s| s == goes);
                        found |= process
                            && (symbol == goes && order > 0
                                || symbol != goes && self.is_process(symbol)
                                || model.is_time(name));
                    }
                    Ok(Resolved::Node { derivatives, .. }) => found |= process && derivatives > 0,
                    Ok(Resolved::Bound(_) | Resolved::Primed { .. } | Resolved::Indexed { .. })
                    | Err(_) => {}
                }
            }
        });
        found
    }

    /// Whether a hypothesis of an equation is about processes themselves and not about their moments.
    pub(super) fn ties_processes(&self, equation: usize) -> bool {
        let mut sides = self
            .hypotheses_of(equation)
            .flat_map(|h| [&h.left, &h.right]);
        sides.any(|side| self.is_random(side))
    }

    /// Whether a node is defined as a letter, or as a matrix of letters: values that the document does not
    /// compute.
    fn is_given_by_letters(&self, node: Node) -> bool {
        let Node::Definition(d) = node else {
            return false;
        };
        let definition = &self.model.definitions[d];
        let display = self.exact.display(definition.equation);
        let mut plain = true;
        let Some(value) = definition.place.find(display) else {
            return false;
        };
        visit(value, &mut |e| {
            plain &= matches!(
                e.kind,
                ExprKind::Name(_)
                    | ExprKind::Number(_)
                    | ExprKind::Matrix { .. }
                    | ExprKind::Group { .. }
            );
        });
        plain
    }

    /// Whether letters that the entries of a covariance are given in stand behind a link.
    pub(super) fn has_moments(&self, equation: usize, link: &Link) -> bool {
        let model = self.model;
        let display = |e: usize| self.exact.display(e);
        let mut behind = BTreeSet::new();
        for (_, node, _) in model.covariances() {
            if self.is_given_by_letters(node) {
                behind.extend(model.symbols_behind(node, &display));
            }
        }
        behind.retain(|s| !self.is_process(*s));
        if behind.is_empty() {
            return false;
        }
        let mut found = false;
        for place in [link.left, link.right] {
            let Some(side) = place.find(self.exact.display(equation)) else {
                continue;
            };
            model.visit_behind(side, &display, &mut |e| {
                if let ExprKind::Name(name) | ExprKind::Apply { function: name, .. } = &e.kind
                    && let Ok(Resolved::Letter { symbol, .. }) = model.resolve(name, &|_| false)
                {
                    found |= behind.contains(&symbol);
                }
            });
        }
        found
    }

    pub(super) fn is_process(&self, symbol: usize) -> bool {
        self.model.symbols[symbol].function_of.is_some()
    }

    /// Whether a process, or another random letter, stands in an expression outside of expectations.
    pub(super) fn is_random(&self, expr: &Expr) -> bool {
        self.is_random_beside(expr, &self.random_constants())
    }

    fn is_random_beside(&self, expr: &Expr, constants: &BTreeSet<usize>) -> bool {
        let model = self.model;
        let name = match &expr.kind {
            ExprKind::Expectation(_) => return false,
            ExprKind::Name(name) | ExprKind::Apply { function: name, .. } => Some(name),
            _ => None,
        };
        let random = |s: usize| self.is_process(s) || constants.contains(&s);
        let own = name.is_some_and(|name| match model.resolve(name, &|_| false) {
            Ok(Resolved::Letter { symbol, .. }) => random(symbol),
            Ok(Resolved::Node { node, .. }) => {
                let behind = model.symbols_behind(node, &|e| model.display(e));
                behind
                    .into_iter()
                    .chain(self.symbols_named_by(node))
                    .any(random)
            }
            Ok(Resolved::Bound(_) | Resolved::Primed { .. } | Resolved::Indexed { .. })
            | Err(_) => false,
        });
        own || children(expr)
            .into_iter()
            .any(|child| self.is_random_beside(child, constants))
    }

    /// The letters of random vectors in which nothing is a process: by their declaration they are numbers.
    pub(super) fn random_constants(&self) -> BTreeSet<usize> {
        let model = self.model;
        let display = |equation: usize| model.display(equation);
        let mut found = BTreeSet::new();
        for (_, _, covariance) in model.covariances() {
            for vector in [&covariance.left, &covariance.right] {
                let mut letters = BTreeSet::new();
                model.visit_behind(vector, &display, &mut |e| {
                    if let ExprKind::Name(name) | ExprKind::Apply { function: name, .. } = &e.kind {
                        letters.extend(self.symbols_named(name));
                    }
                });
                if !letters.iter().any(|s| self.is_process(*s)) {
                    found.extend(letters);
                }
            }
        }
        found
    }

    /// The declared letters that a name stands for: its own, or the entries of its matrix.
    pub(super) fn symbols_named(&self, name: &Name) -> Vec<usize> {
        match self.model.resolve(name, &|_| false) {
            Ok(Resolved::Letter { symbol, .. }) => vec![symbol],
            Ok(Resolved::Node { node, .. }) => self.symbols_named_by(node),
            Ok(Resolved::Bound(_) | Resolved::Primed { .. } | Resolved::Indexed { .. })
            | Err(_) => Vec::new(),
        }
    }

    /// The entries of a declared matrix.
    fn symbols_named_by(&self, node: Node) -> Vec<usize> {
        let Node::Matrix(matrix) = node else {
            return Vec::new();
        };
        let symbols = self.model.symbols.iter().enumerate();
        let own = symbols.filter(|(_, s)| matches!(s.entry_of, Some((m, ..)) if m == matrix));
        own.map(|(symbol, _)| symbol).collect()
    }

    /// Whether an expectation stands in a link or behind it.
    fn has_expectations(&self, equation: usize, link: &Link) -> bool {
        let display = |e: usize| self.exact.display(e);
        let mut found = false;
        for place in [link.left, link.right] {
            if let Some(side) = place.find(display(equation)) {
                self.model.visit_behind(side, &display, &mut |e| {
                    found |= matches!(e.kind, ExprKind::Expectation(_));
                });
            }
        }
        found
    }
}
