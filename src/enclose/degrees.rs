//! Of which degree an expression is in processes, as far as the way it is put together tells.

use super::world::{World, normal};
use crate::expr::{Expr, ExprKind, Function, Name};
use crate::latex;
use crate::model::names::{Resolved, literal_integer};
use crate::model::{Node, NotationKind};
use std::collections::BTreeSet;

/// The degrees of expressions in processes, as far as the way they are put together tells.
pub(super) struct Degrees<'w, 'm> {
    world: &'w World<'m>,
    open: BTreeSet<Node>,
}

impl<'w, 'm> Degrees<'w, 'm> {
    pub fn new(world: &'w World<'m>) -> Self {
        Degrees {
            world,
            open: BTreeSet::new(),
        }
    }

    /// A bound of the degree; none where there may be none.
    pub fn of(&mut self, expr: &Expr) -> Option<u32> {
        let world = self.world;
        let process = |s: &usize| world.model().symbols[*s].function_of.is_some();
        if !world.behind_expression(expr).symbols.iter().any(process) {
            return Some(0);
        }
        match &expr.kind {
            ExprKind::Number(_) => Some(0),
            ExprKind::Name(name) => self.of_name(name),
            ExprKind::Apply {
                function,
                arguments,
            } => {
                let plain = arguments.iter().all(|a| {
                    matches!(&a.kind, ExprKind::Name(n)
                        if world.model().is_argument_of(function, &latex::canonical(n)))
                });
                let defined = match world.model().resolve(function, &|_| false) {
                    Ok(Resolved::Node { node, .. }) => {
                        world.model().function_definition(node).is_some()
                    }
                    _ => false,
                };
                if plain && !defined {
                    self.of_name(function)
                } else {
                    None
                }
            }
            ExprKind::Group { inner, .. }
            | ExprKind::Transpose(inner)
            | ExprKind::Underbrace { body: inner, .. } => self.of(inner),
            ExprKind::Call { function, argument } => {
                let linear = matches!(
                    function,
                    Function::Trace | Function::RealPart | Function::ImaginaryPart
                );
                if linear { self.of(argument) } else { None }
            }
            ExprKind::Sum(terms) => self.largest(terms.iter().map(|(_, term)| term)),
            ExprKind::Matrix { rows, .. } => self.largest(rows.iter().flatten()),
            ExprKind::Product(factors) => {
                let mut sum = 0u32;
                for factor in factors {
                    sum = sum.checked_add(self.of(factor)?)?;
                }
                Some(sum)
            }
            ExprKind::Quotient {
                numerator,
                denominator,
                ..
            } => {
                let below = self.of(denominator)?;
                if below == 0 { self.of(numerator) } else { None }
            }
            ExprKind::Power { base, exponent } => {
                let n = u32::try_from(literal_integer(exponent)?).ok()?;
                if let ExprKind::Name(name) = &base.kind
                    && let Some((node, rest)) = self.world.model().power_node(name, n)
                {
                    return self.of_node(node)?.checked_mul(rest);
                }
                self.of(base)?.checked_mul(n)
            }
            ExprKind::BigSum { body, .. } => self.of(body),
            ExprKind::Derivative { variable, body, .. } => match variable {
                Some(letter) if !self.world.is_time(letter) => self.of(body),
                _ => self.moving(self.world.behind_expression(body).symbols, |d| d.of(body)),
            },
            ExprKind::Expectation(_) => Some(0),
            ExprKind::Integral { .. }
            | ExprKind::Cases(_)
            | ExprKind::Named { .. }
            | ExprKind::Tuple(_)
            | ExprKind::Infinity
            | ExprKind::Constant => None,
        }
    }

    fn largest<'e>(&mut self, parts: impl Iterator<Item = &'e Expr>) -> Option<u32> {
        let mut largest = 0;
        for part in parts {
            largest = largest.max(self.of(part)?);
        }
        Some(largest)
    }

    /// The degree of a rate: that of what it is the rate of, if all motions are linear.
    fn moving(
        &mut self,
        symbols: BTreeSet<usize>,
        body: impl FnOnce(&mut Self) -> Option<u32>,
    ) -> Option<u32> {
        for symbol in symbols {
            for node in self.world.motions(symbol, 0) {
                if self.of_node(node)? > 1 {
                    return None;
                }
            }
        }
        body(self)
    }

    fn of_name(&mut self, name: &Name) -> Option<u32> {
        match self.world.model().resolve(name, &|_| false).ok()? {
            Resolved::Bound(_) => Some(0),
            Resolved::Letter { .. } => Some(1),
            Resolved::Node { node, derivatives } => {
                if derivatives == 0 {
                    return self.of_node(node);
                }
                let symbols = self.world.behind(node).symbols.clone();
                self.moving(symbols, |d| d.of_node(node))
            }
            Resolved::Primed { .. } | Resolved::Indexed { .. } => None,
        }
    }

    fn of_node(&mut self, node: Node) -> Option<u32> {
        let world = self.world;
        let model = world.model();
        match node {
            Node::Symbol(_) | Node::Matrix(_) => Some(1),
            Node::Unknown { .. } if self.open.contains(&normal(node)) => Some(1),
            Node::Definition(d) => {
                if !self.open.insert(node) {
                    return None;
                }
                let definition = &model.definitions[d];
                let value = definition.place.find(world.display(definition.equation));
                let degree = value.and_then(|value| self.of(value));
                self.open.remove(&node);
                degree
            }
            // Linear in the unknowns and processes together: then so are the unknowns in the processes.
            Node::Unknown { system, .. } => {
                let own = normal(node);
                self.open.insert(own);
                let display = world.display(model.systems[system].equation);
                let members = display.clauses.iter().flat_map(|c| &c.chain.members);
                let degree = self.largest(members);
                self.open.remove(&own);
                degree.filter(|degree| *degree <= 1)
            }
            Node::Notation(n) => match &model.notation[n].kind {
                NotationKind::Means(of) => self.of(of),
                NotationKind::Identity(_)
                | NotationKind::Zero
                | NotationKind::Constant(_)
                | NotationKind::Rows(_) => Some(0),
                NotationKind::CharacteristicCoefficient(_)
                | NotationKind::Cofactor(_)
                | NotationKind::LeadingMinor(_)
                | NotationKind::Entry(_)
                | NotationKind::HurwitzMatrix(_)
                | NotationKind::Dirac
                | NotationKind::Covariance(_) => None,
            },
        }
    }
}
