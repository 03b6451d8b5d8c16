//! A document's model at a point: every letter has a double, every name a meaning.
//!
//! The point is the doubles themselves. The exact engine is compared at the very same point, so
//! [`Point::exact`] gives the doubles as rationals, and not the decimal numbers they came from.

use super::NumericError;
use super::agreement::nearest;
use super::resolver::{Element, Meaning, Reference, Resolver, System};
use super::sample::{Range, Sampler};
use crate::document::{Numeric, Scale};
use crate::expr::walk::visit;
use crate::expr::{Display, Expr, ExprKind, Font, Name};
use crate::functions::Constant;
use crate::latex;
use crate::model::names::{self, Resolved};
use crate::model::{DefinitionKind, Model, Node, NotationKind};
use num_rational::BigRational;
use std::collections::BTreeMap;

/// A model with a double for each of its symbols that has one.
#[derive(Clone, Debug)]
pub struct Point<'m> {
    model: &'m Model,
    values: Vec<Option<f64>>,
    corrected: BTreeMap<usize, Display>,
}

/// A point and what the document calls it.
#[derive(Clone, Debug)]
pub struct NamedPoint<'m> {
    /// Its name, or `sample 7`.
    pub name: String,
    /// The point.
    pub point: Point<'m>,
}

impl<'m> Point<'m> {
    /// The reference values of the document, each rounded to the nearest double.
    pub fn reference(model: &'m Model) -> Self {
        let nearest = |value: &Option<BigRational>| value.as_ref().and_then(nearest);
        Point {
            model,
            values: model.symbols.iter().map(|s| nearest(&s.value)).collect(),
            corrected: BTreeMap::new(),
        }
    }

    /// The point with another value of one symbol.
    #[must_use]
    pub fn with(mut self, symbol: usize, value: f64) -> Self {
        if let Some(place) = self.values.get_mut(symbol) {
            *place = Some(value);
        }
        self
    }

    /// The point with a corrected display in place of an equation's printed one.
    #[must_use]
    pub fn corrected(mut self, equation: usize, display: Display) -> Self {
        self.corrected.insert(equation, display);
        self
    }

    /// The value of each symbol, in the order of the model.
    pub fn values(&self) -> &[Option<f64>] {
        &self.values
    }

    /// The same values as exact rationals.
    pub fn exact(&self) -> Vec<Option<BigRational>> {
        self.values
            .iter()
            .map(|value| value.and_then(BigRational::from_float))
            .collect()
    }

    /// The named points and the seeded samples of a document's numeric table, in its order.
    ///
    /// [`NumericError::Range`] where a range or a value is no range of doubles; letters that the
    /// model does not declare are left out.
    pub fn of_table(
        model: &'m Model,
        table: &Numeric,
    ) -> Result<Vec<NamedPoint<'m>>, NumericError> {
        let mut points = Vec::new();
        for named in &table.points {
            let mut point = Point::reference(model);
            for (letter, value) in &named.values {
                if let Some(symbol) = symbol(model, &letter.text) {
                    let value = nearest(value).ok_or(NumericError::Range)?;
                    point = point.with(symbol, value);
                }
            }
            points.push(NamedPoint {
                name: named.name.text.clone(),
                point,
            });
        }
        let mut sampler = Sampler::new(table.seed);
        for number in 1..=table.samples {
            let mut point = Point::reference(model);
            for range in &table.ranges {
                let low = nearest(&range.low).ok_or(NumericError::Range)?;
                let high = nearest(&range.high).ok_or(NumericError::Range)?;
                let value = match table.scale {
                    Scale::Logarithmic => sampler.coordinate(Range::new(low, high)?),
                    Scale::Linear => sampler.uniform(low, high)?,
                };
                if let Some(symbol) = symbol(model, &range.name.text) {
                    point = point.with(symbol, value);
                }
            }
            points.push(NamedPoint {
                name: format!("sample {number}"),
                point,
            });
        }
        Ok(points)
    }

    /// Processes have no numbers, so a name that is defined as an expectation is computed by the first
    /// claim that begins with it and goes on without one; the exact route proves that claim.
    fn without_expectation<'e>(&'e self, node: Node, defined: &'e Expr) -> &'e Expr {
        let holds_expectation = |expr: &Expr| {
            let mut found = false;
            visit(expr, &mut |e| {
                found |= matches!(e.kind, ExprKind::Expectation(_));
            });
            found
        };
        if !holds_expectation(defined) {
            return defined;
        }
        let claimed = |e: usize| -> Option<&'e Expr> {
            let chains = self.display(e)?.clauses.iter().map(|c| &c.chain.members);
            chains.into_iter().find_map(|members| {
                let (first, rest) = members.split_first()?;
                let named = self.node_of(first) == Some(node);
                rest.iter()
                    .find(|member| named && !holds_expectation(member))
            })
        };
        let claims = (0..self.model.equations.len())
            .filter(|e| self.model.equations[*e].role == crate::model::Role::Claim);
        claims.into_iter().find_map(claimed).unwrap_or(defined)
    }

    /// The definition that a name, or the power of one, stands for.
    fn node_of(&self, expr: &Expr) -> Option<Node> {
        if let Some(name) = expr.as_name() {
            return match self.model.resolve(name, &|_| false) {
                Ok(Resolved::Node {
                    node,
                    derivatives: 0,
                }) => Some(node),
                _ => None,
            };
        }
        let ExprKind::Power { base, exponent } = &expr.kind else {
            return None;
        };
        let exponent = u32::try_from(names::literal_integer(exponent)?).ok()?;
        let (node, rest) = self.model.power_node(base.as_name()?, exponent)?;
        (rest == 1).then_some(node)
    }

    fn display(&self, equation: usize) -> Option<&Display> {
        self.corrected
            .get(&equation)
            .or_else(|| self.model.equations.get(equation).map(|e| &e.display))
    }
}

/// The symbol with this printed name.
fn symbol(model: &Model, printed: &str) -> Option<usize> {
    let name = latex::canonical(&latex::parse_name(printed, 0).ok()?);
    model
        .symbols
        .iter()
        .position(|s| latex::canonical(&s.name) == name)
}

impl Resolver for Point<'_> {
    type Node = Node;

    fn canonical(&self, name: &Name) -> String {
        latex::canonical(name)
    }

    fn resolve<'n>(&'n self, name: &'n Name, bound: &dyn Fn(&str) -> bool) -> Reference<'n, Node> {
        match self.model.resolve(name, bound) {
            Err(_) => Reference::Undeclared,
            Ok(Resolved::Bound(index)) => Reference::Bound(index),
            Ok(Resolved::Letter { symbol, order: 0 }) => Reference::Node(Node::Symbol(symbol)),
            Ok(Resolved::Node {
                node,
                derivatives: 0,
            }) => Reference::Node(node),
            Ok(Resolved::Letter { .. } | Resolved::Node { .. } | Resolved::Primed { .. }) => {
                Reference::WithoutValue
            }
            Ok(Resolved::Indexed { key, indices }) => Reference::Indexed {
                family: key,
                indices,
            },
        }
    }

    fn elements(&self, family: &str, indices: &[i64]) -> Vec<Element<Node>> {
        self.model
            .elements(&family.to_string(), indices)
            .into_iter()
            .map(|element| match element {
                names::Element::Node(node) => Element::Member(node, Vec::new()),
                names::Element::Member(node, indices) => Element::Member(node, indices),
                names::Element::Entry(node, indices) => Element::Entry(node, indices),
            })
            .collect()
    }

    fn power(&self, base: &Name, exponent: u32) -> Option<(Node, u32)> {
        self.model.power_node(base, exponent)
    }

    fn is_plain_application(&self, function: &Name, arguments: &[Expr]) -> bool {
        self.model.is_plain_application(function, arguments)
    }

    fn parameters(&self, function: &Name) -> Vec<Node> {
        let Ok(Resolved::Node { node, .. }) = self.model.resolve(function, &|_| false) else {
            return Vec::new();
        };
        let Some(definition) = self.model.function_definition(node) else {
            return Vec::new();
        };
        let letters =
            definition
                .arguments
                .iter()
                .map(|name| match self.model.resolve(name, &|_| false) {
                    Ok(Resolved::Letter { symbol, order: 0 }) => Some(Node::Symbol(symbol)),
                    _ => None,
                });
        letters.collect::<Option<_>>().unwrap_or_default()
    }

    fn meaning(&self, node: Node, indices: &[i64]) -> Option<Meaning<'_>> {
        match node {
            Node::Symbol(symbol) => Some(Meaning::Number(*self.values.get(symbol)?)),
            // A declared matrix is letters without values.
            Node::Matrix(_) => Some(Meaning::Number(None)),
            Node::Unknown { system, position } => Some(Meaning::Unknown { system, position }),
            // Which of its values is meant, is not decided with rounding.
            Node::Definition(definition) if !self.model.exceptions(definition).is_empty() => {
                Some(Meaning::Number(None))
            }
            Node::Definition(definition) => {
                let definition = self.model.definitions.get(definition)?;
                let bound = match &definition.kind {
                    DefinitionKind::Family { indices: names, .. } => {
                        names.iter().cloned().zip(indices.iter().copied()).collect()
                    }
                    DefinitionKind::Whole
                    | DefinitionKind::Power(_)
                    | DefinitionKind::ValueAt(_)
                    | DefinitionKind::Element(_) => Vec::new(),
                };
                let expr = definition.place.find(self.display(definition.equation)?)?;
                let expr = self.without_expectation(node, expr);
                Some(Meaning::Expression { expr, bound })
            }
            Node::Notation(notation) => Some(match &self.model.notation.get(notation)?.kind {
                NotationKind::Identity(n) => Meaning::Identity(n.at(&self.model.instances[0])),
                NotationKind::Zero => Meaning::Zero,
                NotationKind::CharacteristicCoefficient(of) => {
                    Meaning::CharacteristicCoefficient(of)
                }
                NotationKind::Cofactor(of) => Meaning::Cofactor(of),
                NotationKind::LeadingMinor(of) => Meaning::LeadingMinor(of),
                NotationKind::Entry(of) => Meaning::Entry(of),
                NotationKind::HurwitzMatrix(of) => Meaning::HurwitzMatrix(of),
                NotationKind::Covariance(covariance) => Meaning::Expression {
                    expr: &covariance.product,
                    bound: Vec::new(),
                },
                // How large a matrix is, is not computed with rounding.
                NotationKind::Rows(_) => Meaning::Number(None),
                NotationKind::Constant(Constant::Pi) => Meaning::Number(Some(std::f64::consts::PI)),
                NotationKind::Constant(Constant::Euler) => {
                    Meaning::Number(Some(std::f64::consts::E))
                }
                NotationKind::Constant(Constant::ImaginaryUnit) | NotationKind::Dirac => {
                    Meaning::Number(None)
                }
                NotationKind::Means(expr) => Meaning::Expression {
                    expr,
                    bound: Vec::new(),
                },
            }),
        }
    }

    fn system(&self, system: usize) -> Option<System<'_>> {
        // What is no polynomial in its unknowns is not solved at two points that happen to fit.
        let of = |equation: usize| {
            let corrected = self.corrected.get(&equation);
            corrected.unwrap_or(&self.model.equations[equation].display)
        };
        if system >= self.model.systems.len() || self.model.degree_in_unknowns(system, &of).is_err()
        {
            return None;
        }
        let system = self.model.systems.get(system)?;
        let display = self.display(system.equation)?;
        Some(System {
            equations: display
                .clauses
                .iter()
                .flat_map(|clause| clause.chain.members.windows(2))
                .map(|pair| (&pair[0], &pair[1]))
                .collect(),
            matrices: system
                .unknowns
                .iter()
                .map(|unknown| unknown.letter.font == Font::Bold)
                .collect(),
        })
    }
}
