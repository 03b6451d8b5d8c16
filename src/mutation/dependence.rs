//! Which values and which claims depend on what an equation defines.

use crate::model::links::Place;
use crate::model::{DefinitionKind, Model, Node};
use std::collections::{BTreeMap, BTreeSet};

/// A link of an equation, both as indices.
pub(super) type LinkAt = (usize, usize);

/// What depends on some nodes.
#[derive(Clone, Debug, Default)]
pub(super) struct Dependents {
    /// The nodes whose values depend on them, these included.
    pub stale: BTreeSet<Node>,
    /// The claims, those that need least first.
    pub claims: Vec<LinkAt>,
}

/// The dependences of a model.
pub(super) struct Dependences {
    /// For each node the nodes that its value is computed from, itself included.
    behind: BTreeMap<Node, BTreeSet<Node>>,
    /// For each claim the nodes that it is computed from.
    claims: Vec<(LinkAt, BTreeSet<Node>)>,
    /// Nodes that derivatives of processes are taken from without being named.
    motions: BTreeSet<Node>,
}

impl Dependences {
    /// The dependences among the nodes, and of these claims.
    pub fn of(model: &Model, claims: &[LinkAt]) -> Self {
        let nodes = (0..model.definitions.len())
            .map(Node::Definition)
            .chain((0..model.notation.len()).map(Node::Notation))
            .chain((0..model.systems.len()).map(|system| Node::Unknown {
                system,
                position: 0,
            }));
        let closure = |start: BTreeSet<Node>| {
            let mut seen = BTreeSet::new();
            let mut open: Vec<Node> = start.into_iter().collect();
            while let Some(node) = open.pop() {
                if seen.insert(node) {
                    open.extend(model.needs(node));
                }
            }
            seen
        };
        let behind: BTreeMap<Node, BTreeSet<Node>> = nodes
            .map(|node| (node, closure(BTreeSet::from([node]))))
            .collect();
        let mut of_claims: Vec<(LinkAt, BTreeSet<Node>)> = claims
            .iter()
            .map(|&(e, l)| {
                let equation = &model.equations[e];
                let link = equation.links[l];
                let mut used = BTreeSet::new();
                // The arguments of what tends somewhere, and the ranges, belong to the claim too.
                for place in [link.left, link.right] {
                    if let Some(expr) = place.find(&equation.display) {
                        model.collect(expr, &mut used);
                    }
                }
                for hypothesis in equation.given.iter().chain(&equation.assume) {
                    model.collect(&hypothesis.left, &mut used);
                    model.collect(&hypothesis.right, &mut used);
                }
                ((e, l), closure(used))
            })
            .collect();
        of_claims.sort_by_key(|(at, used)| (used.len(), *at));
        let dotted = |node: &Node| match *node {
            Node::Definition(d) => {
                let definition = &model.definitions[d];
                definition.name.dots > 0 || matches!(definition.kind, DefinitionKind::ValueAt(_))
            }
            Node::Unknown { system, .. } => {
                model.systems[system].unknowns.iter().any(|n| n.dots > 0)
            }
            _ => false,
        };
        Dependences {
            motions: behind.keys().copied().filter(dotted).collect(),
            behind,
            claims: of_claims,
        }
    }

    /// What depends on these nodes. A derivative of a process may be inserted anywhere without being
    /// named, so that on an equation of motion everything depends.
    pub fn dependents(&self, changed: &BTreeSet<Node>) -> Dependents {
        if changed.is_empty() {
            return Dependents::default();
        }
        let touches = |used: &BTreeSet<Node>| !used.is_disjoint(changed);
        let stale: BTreeSet<Node> = self
            .behind
            .iter()
            .filter(|(_, used)| touches(used))
            .map(|(node, _)| *node)
            .collect();
        if !stale.is_disjoint(&self.motions) {
            return Dependents {
                stale: self.behind.keys().copied().collect(),
                claims: self.claims.iter().map(|(at, _)| *at).collect(),
            };
        }
        Dependents {
            claims: self
                .claims
                .iter()
                .filter(|(_, used)| touches(used))
                .map(|(at, _)| *at)
                .collect(),
            stale,
        }
    }
}

/// The nodes that get their values from an equation, each with its place: none for the unknowns of a
/// system, for which the whole display counts.
pub(super) fn values_of(model: &Model, equation: usize) -> Vec<(Node, Option<Place>)> {
    let defined = model
        .definitions
        .iter()
        .enumerate()
        .filter(|(_, d)| d.equation == equation)
        .map(|(d, definition)| (Node::Definition(d), Some(definition.place)));
    let solved = model
        .systems
        .iter()
        .enumerate()
        .filter(|(_, s)| s.equation == equation)
        .map(|(system, _)| {
            let node = Node::Unknown {
                system,
                position: 0,
            };
            (node, None)
        });
    defined.chain(solved).collect()
}
