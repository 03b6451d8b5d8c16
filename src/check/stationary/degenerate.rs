//! Random quantities that depend on each other almost surely.
//!
//! Where the determinant of a covariance vanishes for all values of the letters, some combination of the
//! random quantities has the variance zero, and is zero almost surely: their values are not free to be chosen,
//! and a point of them shows nothing false.

use super::super::Checker;
use crate::domain::{Domain, PrimeField};
use crate::evaluate::Value;
use crate::expr::{Expr, ExprKind};
use crate::latex;
use crate::matrix::Matrix;
use crate::model::Node;
use crate::model::links::Link;
use crate::model::names::Resolved;
use crate::theory::determinant::determinant;
use crate::verdict::Verdict;
use ratpoly::RationalFunction;
use std::collections::BTreeSet;

/// Determinants with functions of a larger order are not computed.
const LARGEST_ORDER: usize = 4;

impl Checker<'_> {
    /// What is said of a link whose random quantities need not be free: nothing that a point shows.
    pub(in crate::check) fn where_quantities_are_free(
        &mut self,
        equation: usize,
        link: &Link,
        verdict: Verdict,
    ) -> Verdict {
        let by_point = match &verdict {
            Verdict::Refuted(refutation) | Verdict::Misprint { refutation, .. } => {
                refutation.witness().is_some()
            }
            Verdict::Holds { .. }
            | Verdict::HoldsGiven(..)
            | Verdict::Definition { .. }
            | Verdict::Recalled { .. }
            | Verdict::Undecided { .. } => false,
        };
        match by_point && self.has_dependent_quantities(equation, link) {
            false => verdict,
            true => Verdict::Undecided {
                reason: "random quantities in it have a covariance that is singular, or not known \
                         not to be: what is false at a point of them may hold almost surely"
                    .into(),
            },
        }
    }

    /// Whether random quantities stand in a link, outside of expectations, whose covariance is singular or
    /// is not known not to be.
    fn has_dependent_quantities(&mut self, equation: usize, link: &Link) -> bool {
        let display = self.exact.display(equation);
        let sides = [link.left, link.right].into_iter();
        let sides: Vec<&Expr> = sides.filter_map(|place| place.find(display)).collect();
        if !sides
            .iter()
            .any(|side| self.has_random_value(side, &mut BTreeSet::new()))
        {
            return false;
        }
        let quantities = self.processes_behind(sides.into_iter());
        let vectors = self.vectors_of(&quantities);
        // What the covariances divide by is no matter of the link.
        let conditions = self.exact.conditions.clone();
        let dependent = !vectors.is_empty() && self.may_be_singular(&vectors);
        self.exact.conditions = conditions;
        dependent
    }

    /// Whether a random quantity stands in an expression, or in what defines a name in it; moments of random
    /// quantities are none.
    fn has_random_value(&self, expr: &Expr, seen: &mut BTreeSet<Node>) -> bool {
        let model = self.model;
        let name = match &expr.kind {
            ExprKind::Expectation(_) => return false,
            ExprKind::Name(name) | ExprKind::Apply { function: name, .. } => Some(name),
            _ => None,
        };
        let own = name.is_some_and(|name| match model.resolve(name, &|_| false) {
            Ok(Resolved::Letter { symbol, .. }) => {
                self.is_process(symbol) || self.random_constants().contains(&symbol)
            }
            Ok(Resolved::Node { node, .. } | Resolved::Primed { node, .. }) => {
                let moment = model.covariances().any(|(_, n, _)| n == node);
                !moment && seen.insert(node) && self.node_has_random_value(node, seen)
            }
            Ok(Resolved::Bound(_) | Resolved::Indexed { .. }) | Err(_) => false,
        });
        let mut children = crate::expr::walk::children(expr).into_iter();
        own || children.any(|child| self.has_random_value(child, seen))
    }

    fn node_has_random_value(&self, node: Node, seen: &mut BTreeSet<Node>) -> bool {
        let model = self.model;
        match node {
            Node::Definition(d) => {
                let definition = &model.definitions[d];
                let value = definition
                    .place
                    .find(self.exact.display(definition.equation));
                value.is_some_and(|value| self.has_random_value(value, seen))
            }
            Node::Unknown { system, .. } => {
                let display = self.exact.display(model.systems[system].equation);
                let mut members = display.clauses.iter().flat_map(|c| &c.chain.members);
                members.any(|member| self.has_random_value(member, seen))
            }
            Node::Symbol(symbol) => self.is_process(symbol),
            Node::Matrix(matrix) => !model.matrices[matrix].arguments.is_empty(),
            Node::Notation(_) => false,
        }
    }

    /// The random vectors that have a covariance and some of these quantities; none whose quantities
    /// another one has.
    fn vectors_of(&self, quantities: &BTreeSet<usize>) -> Vec<(Expr, Node)> {
        let own = self.model.covariances();
        let own = own.filter(|(_, _, covariance)| covariance.left == covariance.right);
        let mut all: Vec<(BTreeSet<usize>, Expr, Node)> = own
            .map(|(_, node, covariance)| {
                let made_of = self.processes_behind(std::iter::once(&covariance.left));
                (made_of, covariance.left.clone(), node)
            })
            .filter(|(made_of, ..)| !made_of.is_disjoint(quantities))
            .collect();
        all.sort_by_key(|(made_of, ..)| std::cmp::Reverse(made_of.len()));
        let mut kept: Vec<(BTreeSet<usize>, Expr, Node)> = Vec::new();
        for vector in all {
            if !kept.iter().any(|(made_of, ..)| vector.0.is_subset(made_of)) {
                kept.push(vector);
            }
        }
        kept.into_iter()
            .map(|(_, vector, node)| (vector, node))
            .collect()
    }

    fn processes_behind<'e>(&self, sides: impl Iterator<Item = &'e Expr>) -> BTreeSet<usize> {
        let model = self.model;
        let display = |equation: usize| self.exact.display(equation);
        let constants = self.random_constants();
        let mut found = BTreeSet::new();
        for side in sides {
            model.visit_behind(side, &display, &mut |e| {
                if let ExprKind::Name(name) | ExprKind::Apply { function: name, .. } = &e.kind {
                    let named = self.symbols_named(name).into_iter();
                    found.extend(named.filter(|s| self.is_process(*s) || constants.contains(s)));
                }
            });
        }
        found
    }

    /// Whether the covariance of some vectors together need not be regular; what nothing says of two of them
    /// may be zero.
    fn may_be_singular(&mut self, vectors: &[(Expr, Node)]) -> bool {
        if !self.supposed.relations.is_empty() {
            return true;
        }
        let crosses: Vec<(Node, Expr, Expr)> = self
            .model
            .covariances()
            .filter(|(_, _, covariance)| covariance.left != covariance.right)
            .map(|(_, node, c)| (node, c.left.clone(), c.right.clone()))
            .collect();
        let same = |one: &Expr, other: &Expr| latex::write_expr(one) == latex::write_expr(other);
        let mut blocks = Vec::new();
        for (one, (left, own)) in vectors.iter().enumerate() {
            match self.block_of(*own) {
                // It stands for itself, with entries of its own.
                None => return false,
                Some(None) => return true,
                Some(Some(block)) => blocks.push((one, one, block)),
            }
            for (other, (right, _)) in vectors.iter().enumerate() {
                let cross = crosses
                    .iter()
                    .find(|(_, l, r)| same(l, left) && same(r, right));
                match cross.map(|(node, ..)| self.block_of(*node)) {
                    None | Some(None) => {}
                    Some(Some(None)) => return true,
                    Some(Some(Some(block))) => blocks.push((one, other, block)),
                }
            }
        }
        let sizes: Vec<usize> = (0..vectors.len())
            .map(|k| {
                let own = blocks.iter().find(|(i, j, _)| (*i, *j) == (k, k));
                own.map_or(0, |(_, _, block)| block.rows())
            })
            .collect();
        let start = |k: usize| -> usize { sizes[..k].iter().sum() };
        let n = start(sizes.len());
        let mut joint = Matrix::from_fn(n, n, |_, _| self.exact.field.integer(0));
        for (one, other, block) in &blocks {
            if (block.rows(), block.columns()) != (sizes[*one], sizes[*other]) {
                return true;
            }
            for i in 0..block.rows() {
                for j in 0..block.columns() {
                    let (row, column) = (start(*one) + i, start(*other) + j);
                    joint[(row, column)] = block[(i, j)].clone();
                    joint[(column, row)] = block[(i, j)].clone();
                }
            }
        }
        self.is_singular(&joint)
    }

    /// A covariance as a matrix; nothing where it stands for itself, and no matrix where it has no value.
    fn block_of(&mut self, node: Node) -> Option<Option<Matrix<RationalFunction>>> {
        let equation = self.model.equation_giving(node)?;
        let span = self.model.equations[equation].span;
        let matrix = match self.exact.value_of((node, Vec::new(), 0), span) {
            Ok(Value::Scalar(s)) => Matrix::from_fn(1, 1, |_, _| s.clone()),
            Ok(Value::Matrix(m)) => m,
            Ok(Value::Zero) | Err(_) => return Some(None),
        };
        let entries: Option<Vec<_>> = matrix.iter().map(|entry| self.spelt(entry)).collect();
        let columns = matrix.columns();
        Some(entries.map(|entries| {
            Matrix::from_fn(matrix.rows(), columns, |i, j| {
                entries[i * columns + j].clone()
            })
        }))
    }

    fn is_singular(&self, matrix: &Matrix<RationalFunction>) -> bool {
        let letters = |entry| self.exact.field.letters(entry).into_iter();
        let free = matrix
            .iter()
            .all(|entry| letters(entry).all(|letter| !self.is_function(letter)));
        if free {
            // That it does not vanish modulo a prime proves that it is not zero.
            let letters: Vec<u64> = (1..=self.model.letters.len() as u64)
                .map(|k| k * k * 7_919 + 104_729 * k + 31)
                .collect();
            let images: Option<Vec<u64>> = matrix
                .iter()
                .map(|entry| PrimeField.image(entry, &letters))
                .collect();
            let Some(images) = images else {
                return true;
            };
            let n = matrix.rows();
            let image = Matrix::from_fn(n, n, |i, j| images[i * n + j]);
            return determinant(&PrimeField, &image).is_none_or(|d| d == 0);
        }
        matrix.rows() > LARGEST_ORDER
            || determinant(&self.exact.field, matrix).is_none_or(|d| d.is_zero())
    }
}
