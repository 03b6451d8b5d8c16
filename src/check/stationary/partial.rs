//! Covariances that are not known to exist for all admitted values, and what rests on them.
//!
//! Invariant: where one may not exist nothing is shown false, by a limit or by a point, but at a point at
//! which it exists for all values of the other letters.

use super::super::Checker;
use super::Standing;
use crate::domain::Domain;
use crate::expr::{Expr, ExprKind, Name};
use crate::model::Node;
use crate::model::links::Link;
use crate::model::names::Resolved;
use crate::verdict::Verdict;
use num_rational::BigRational;
use ratpoly::{RationalFunction, RegionSign};

/// Why nothing is said.
pub(in crate::check) const EXISTS_FOR_SOME: &str =
    "its covariance exists for some values of the letters only";

/// A covariance that is not known to exist for all admitted values.
pub(in crate::check) struct PartialCovariance {
    node: Node,
    /// What must be positive there, or not negative, in the declared symbols.
    functions: Vec<RationalFunction>,
    strict: bool,
    /// Whether it is not known to exist for all of them.
    partial: bool,
}

impl PartialCovariance {
    /// What must be positive, or not negative, for it to exist.
    pub(in crate::check) fn functions(&self) -> &[RationalFunction] {
        &self.functions
    }
}

impl Checker<'_> {
    /// The covariances that are not known to exist for all admitted values.
    pub(in crate::check) fn partial_covariances(&mut self) -> Vec<PartialCovariance> {
        let mut all = self.demanding_covariances();
        all.retain(|covariance| covariance.partial);
        all
    }

    /// The covariances whose existence depends on letters.
    fn demanding_covariances(&mut self) -> Vec<PartialCovariance> {
        let own = self.model.covariances();
        let own = own.filter(|(_, _, covariance)| covariance.left == covariance.right);
        let nodes: Vec<Node> = own.map(|(_, node, _)| node).collect();
        let mut found = Vec::new();
        for node in nodes {
            let Some((demand, _)) = self.demand(node) else {
                continue;
            };
            let (functions, partial) = match self.standing(&demand) {
                Standing::Never(_) => continue,
                Standing::Exists => (demand.functions, false),
                Standing::Where(functions) => (functions, true),
                Standing::Unknown => (demand.functions, true),
            };
            found.push(PartialCovariance {
                node,
                functions: functions.iter().filter_map(|f| self.spelt(f)).collect(),
                strict: demand.strict,
                partial,
            });
        }
        found
    }

    /// Whether a link integrates over a letter on which the existence of a covariance depends: whether it exists
    /// between the ends is not looked at. Where it exists for all real values it does.
    pub(in crate::check) fn integrates_over_existence(
        &mut self,
        equation: usize,
        link: &Link,
    ) -> bool {
        if self.model.covariances().next().is_none() {
            return false;
        }
        let mut integrals: Vec<(Name, Expr)> = Vec::new();
        let display = self.exact.display(equation);
        for side in [link.left, link.right] {
            if let Some(side) = side.find(display) {
                let of = |equation: usize| self.exact.display(equation);
                self.model.visit_behind(side, &of, &mut |e| {
                    if let ExprKind::Integral { body, variable, .. } = &e.kind {
                        integrals.push((variable.clone(), (**body).clone()));
                    }
                });
            }
        }
        if integrals.is_empty() {
            return false;
        }
        let conditions = std::mem::take(&mut self.exact.conditions);
        let covariances = self.demanding_covariances();
        self.exact.conditions = conditions;
        integrals.iter().any(|(variable, body)| {
            let Ok(Resolved::Letter { symbol, order: 0 }) =
                self.model.resolve(variable, &|_| false)
            else {
                return false;
            };
            let Some(letter) = self.model.letter_of_symbol(symbol, 0) else {
                return false;
            };
            let range = &self.model.symbols[symbol].range;
            let bounded = range.low.is_some() || range.high.is_some();
            let behind = self.behind([body].into_iter(), &covariances);
            behind.iter().any(|covariance| {
                let mut functions = covariance.functions.iter();
                (covariance.partial || bounded)
                    && functions.any(|f| self.exact.field.letters_behind(f).contains(&letter))
            })
        })
    }

    /// Whether what is needed for a covariance to exist is so where these letters have these values, whatever
    /// the others are.
    pub(in crate::check) fn exists_at(
        &self,
        covariance: &PartialCovariance,
        point: &[(usize, BigRational)],
    ) -> bool {
        let constant = |v: &BigRational| RationalFunction::constant(self.model.ring, v.clone());
        let images: Vec<_> = point.iter().map(|(l, v)| (*l, constant(v))).collect();
        covariance.functions.iter().all(|function| {
            let there = match self.functions() {
                Some(table) => table.substitute(function, &images).ok(),
                None => function.substitute(&images).ok(),
            };
            match there.map(|there| self.sign(&there)) {
                Some(RegionSign::Positive) => true,
                Some(RegionSign::NonNegative | RegionSign::Zero) => !covariance.strict,
                Some(
                    RegionSign::Negative
                    | RegionSign::NonPositive
                    | RegionSign::Changes { .. }
                    | RegionSign::Undecided,
                )
                | None => false,
            }
        })
    }

    /// Those of these covariances that expressions rest on.
    pub(in crate::check) fn behind<'p, 'e>(
        &self,
        expressions: impl Iterator<Item = &'e Expr>,
        covariances: &'p [PartialCovariance],
    ) -> Vec<&'p PartialCovariance> {
        let nodes = self.nodes_behind(expressions);
        // All unknowns of a system come from one another.
        let system = |node: Node| match node {
            Node::Unknown { system, .. } => Some(system),
            Node::Definition(_) | Node::Symbol(_) | Node::Matrix(_) | Node::Notation(_) => None,
        };
        let used = |c: &&PartialCovariance| {
            nodes.contains(&c.node)
                || system(c.node).is_some() && nodes.iter().any(|n| system(*n) == system(c.node))
        };
        covariances.iter().filter(used).collect()
    }

    /// What is said of a limit on the way to which a covariance need not exist: nothing that is false.
    pub(in crate::check) fn where_covariances_exist(
        &mut self,
        equation: usize,
        link: &Link,
        verdict: Verdict,
    ) -> Verdict {
        match matches!(verdict, Verdict::Refuted(_))
            && self.rests_on_partial_covariances(equation, link)
        {
            false => verdict,
            true => Verdict::Undecided {
                reason: EXISTS_FOR_SOME.into(),
            },
        }
    }

    /// Whether a side of a link rests on a covariance that is not known to exist for all admitted values.
    pub(in crate::check) fn rests_on_partial_covariances(
        &mut self,
        equation: usize,
        link: &Link,
    ) -> bool {
        let conditions = std::mem::take(&mut self.exact.conditions);
        let partial = self.partial_covariances();
        self.exact.conditions = conditions;
        let display = self.exact.display(equation);
        let sides = [link.left, link.right].into_iter();
        let sides = sides.filter_map(|place| place.find(display));
        !partial.is_empty() && !self.behind(sides, &partial).is_empty()
    }
}
