//! Covariances that are not known to exist for all admitted values, and what rests on them.
//!
//! Invariant: where one may not exist nothing is shown false, by a limit or by a point, but at a point at
//! which it exists for all values of the other letters.

use super::super::Checker;
use super::Standing;
use crate::expr::Expr;
use crate::model::Node;
use crate::model::links::Link;
use crate::verdict::Verdict;
use num_rational::BigRational;
use ratpoly::{RationalFunction, RegionSign};
use std::collections::BTreeSet;

/// Why nothing is said.
pub(in crate::check) const EXISTS_FOR_SOME: &str =
    "its covariance exists for some values of the letters only";

/// A covariance that is not known to exist for all admitted values.
pub(in crate::check) struct PartialCovariance {
    node: Node,
    /// What must be positive there, or not negative, in the declared symbols.
    functions: Vec<RationalFunction>,
    strict: bool,
}

impl Checker<'_> {
    /// The covariances that are not known to exist for all admitted values.
    pub(in crate::check) fn partial_covariances(&mut self) -> Vec<PartialCovariance> {
        let own = self.model.covariances();
        let own = own.filter(|(_, _, covariance)| covariance.left == covariance.right);
        let nodes: Vec<Node> = own.map(|(_, node, _)| node).collect();
        let mut found = Vec::new();
        for node in nodes {
            let Some((demand, _)) = self.demand(node) else {
                continue;
            };
            let functions = match self.standing(&demand) {
                Standing::Exists | Standing::Never(_) => continue,
                Standing::Where(functions) => functions,
                Standing::Unknown => demand.functions,
            };
            found.push(PartialCovariance {
                node,
                functions: functions.iter().filter_map(|f| self.spelt(f)).collect(),
                strict: demand.strict,
            });
        }
        found
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
        let mut nodes = BTreeSet::new();
        for expression in expressions {
            let display = |equation: usize| self.exact.display(equation);
            self.model.visit_behind(expression, &display, &mut |e| {
                self.model.collect(e, &mut nodes);
            });
        }
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
