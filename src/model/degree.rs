//! Of which degree the equations of a system are in its unknowns, as far as the way they are put together tells.
//!
//! A sum, a product and a power with an exponent that is printed as a number have the degree of polynomials; a function
//! that an equation defines has that of its body at its arguments. Everything else that an unknown may stand in
//! (divisors, roots, sines, cases) is no polynomial. Invariant: what is said to be of degree n is a polynomial
//! of total degree n at most in all entries of all unknowns together, whatever the other letters stand for.

use super::names::{Resolved, literal_integer};
use super::{DefinitionKind, Model, Node, NotationKind};
use crate::expr::walk::children;
use crate::expr::{Display, Expr, ExprKind, Font, Function, Name, Relation};
use crate::latex;
use std::collections::BTreeSet;

/// How deep definitions are looked into.
const DEEPEST: usize = 64;

/// Why equations have no degree in their unknowns.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum NoDegree {
    /// They are no polynomials in them.
    NoPolynomial,
    /// They are not all equations.
    NoEquation,
    /// An unknown stands where it might depend on what moves there: what its equation means is not decided.
    Undecided(&'static str),
}

type Degree = Result<u32, NoDegree>;

impl Model {
    /// A bound of the total degree of a system's equations in its unknowns, where they have these displays.
    ///
    /// # Errors
    /// Where they are no polynomials in them, as far as the way they are put together tells.
    pub fn degree_in_unknowns<'d>(
        &self,
        system: usize,
        display: &dyn Fn(usize) -> &'d Display,
    ) -> Degree {
        let mut degrees = Degrees {
            model: self,
            system,
            display,
            letters: Vec::new(),
            bound: Vec::new(),
            depth: 0,
        };
        let mut largest = 0;
        for clause in &display(self.systems[system].equation).clauses {
            let mut relations = clause.chain.relations.iter();
            if relations.any(|relation| *relation != Relation::Equal) {
                return Err(NoDegree::NoEquation);
            }
            largest = largest.max(degrees.largest(clause.chain.members.iter())?);
        }
        Ok(largest)
    }
}

struct Degrees<'a, 'd> {
    model: &'a Model,
    /// Whose unknowns are meant.
    system: usize,
    display: &'a dyn Fn(usize) -> &'d Display,
    /// Symbols that stand for something of a degree; the last one counts.
    letters: Vec<(usize, u32)>,
    /// The running indices.
    bound: Vec<String>,
    depth: usize,
}

impl<'a> Degrees<'a, '_> {
    fn of(&mut self, expr: &Expr) -> Degree {
        match &expr.kind {
            ExprKind::Number(_) | ExprKind::Infinity | ExprKind::Constant => Ok(0),
            ExprKind::Name(name) => self.of_name(expr, name),
            ExprKind::Apply {
                function,
                arguments,
            } => self.of_application(function, arguments),
            ExprKind::Group { inner, .. }
            | ExprKind::Transpose(inner)
            | ExprKind::Underbrace { body: inner, .. }
            | ExprKind::Named { value: inner, .. } => self.of(inner),
            ExprKind::Sum(terms) => self.largest(terms.iter().map(|(_, term)| term)),
            ExprKind::Matrix { rows, .. } => self.largest(rows.iter().flatten()),
            ExprKind::Product(factors) => {
                let mut sum = 0_u32;
                for factor in factors {
                    sum = sum.saturating_add(self.of(factor)?);
                }
                Ok(sum)
            }
            ExprKind::Quotient {
                numerator,
                denominator,
                ..
            } => {
                self.none(denominator)?;
                self.of(numerator)
            }
            ExprKind::Power { base, exponent } => self.of_power(base, exponent),
            ExprKind::Call { function, argument } => match function {
                Function::Trace => self.of(argument),
                Function::Determinant => self.of_determinant(argument),
                Function::RealPart
                | Function::ImaginaryPart
                | Function::Cosine
                | Function::Sine
                | Function::Tangent
                | Function::Cotangent
                | Function::HyperbolicCosine
                | Function::HyperbolicSine
                | Function::HyperbolicTangent
                | Function::Exponential
                | Function::Logarithm
                | Function::SquareRoot
                | Function::Absolute => self.none(argument),
            },
            ExprKind::BigSum {
                index,
                from,
                to,
                body,
            } => {
                self.none(from)?;
                self.none(to)?;
                self.bound.push(latex::canonical(index));
                let degree = self.of(body);
                self.bound.pop();
                degree
            }
            ExprKind::Integral {
                limits,
                body,
                variable,
            } => {
                for end in limits.iter().flat_map(|(from, to)| [from, to]) {
                    self.none(end)?;
                }
                let hidden = self.symbol(variable).map(|symbol| (symbol, 0));
                self.still(
                    hidden.into_iter().collect(),
                    body,
                    "an unknown in an integrand",
                )
            }
            ExprKind::Derivative { body, .. } => {
                self.still(Vec::new(), body, "the derivative of an unknown")
            }
            ExprKind::Expectation(inner) => {
                self.still(Vec::new(), inner, "the expectation of an unknown")
            }
            ExprKind::Cases(cases) => {
                for (value, conditions) in cases {
                    self.none(value)?;
                    for member in conditions.iter().flat_map(|chain| &chain.members) {
                        self.none(member)?;
                    }
                }
                Ok(0)
            }
            ExprKind::Tuple(items) => {
                for item in items {
                    self.none(item)?;
                }
                Ok(0)
            }
        }
    }

    fn largest<'e>(&mut self, parts: impl Iterator<Item = &'e Expr>) -> Degree {
        let mut largest = 0;
        for part in parts {
            largest = largest.max(self.of(part)?);
        }
        Ok(largest)
    }

    /// What may not depend on the unknowns.
    fn none(&mut self, expr: &Expr) -> Degree {
        match self.of(expr)? {
            0 => Ok(0),
            _ => Err(NoDegree::NoPolynomial),
        }
    }

    /// What an unknown may not stand in, since it might not stand still there.
    fn still(&mut self, hidden: Vec<(usize, u32)>, body: &Expr, what: &'static str) -> Degree {
        let before = self.letters.len();
        self.letters.extend(hidden);
        let degree = self.of(body);
        self.letters.truncate(before);
        match degree? {
            0 => Ok(0),
            _ => Err(NoDegree::Undecided(what)),
        }
    }

    fn of_power(&mut self, base: &Expr, exponent: &Expr) -> Degree {
        self.none(exponent)?;
        let exponent = literal_integer(exponent).and_then(|n| u32::try_from(n).ok());
        if let (ExprKind::Name(name), Some(n)) = (&base.kind, exponent)
            && let Some((node, rest)) = self.model.power_node(name, n)
        {
            return Ok(self.of_node(node)?.saturating_mul(rest));
        }
        match (self.of(base)?, exponent) {
            (0, _) => Ok(0),
            (degree, Some(n)) => Ok(degree.saturating_mul(n)),
            (_, None) => Err(NoDegree::NoPolynomial),
        }
    }

    /// Of a matrix of numbers, the degree of its entries for each of its rows.
    fn of_determinant(&mut self, argument: &Expr) -> Degree {
        let degree = self.of(argument)?;
        if degree == 0 {
            return Ok(0);
        }
        let ExprKind::Matrix { rows, .. } = &argument.without_brackets().kind else {
            return Err(NoDegree::NoPolynomial);
        };
        if !rows.iter().flatten().all(|entry| self.is_number(entry)) {
            return Err(NoDegree::NoPolynomial);
        }
        let order = u32::try_from(rows.len()).unwrap_or(u32::MAX);
        Ok(degree.saturating_mul(order))
    }

    /// Whether an expression certainly has no shape: it is put together from numbers and letters.
    fn is_number(&self, expr: &Expr) -> bool {
        let own = match &expr.kind {
            ExprKind::Name(name) => match self.resolve(name) {
                Some(Resolved::Bound(_) | Resolved::Letter { .. }) => true,
                Some(Resolved::Node {
                    node: Node::Symbol(_),
                    ..
                }) => true,
                Some(Resolved::Node {
                    node: Node::Unknown { .. },
                    ..
                }) => name.letter.font != Font::Bold,
                Some(
                    Resolved::Node { .. } | Resolved::Primed { .. } | Resolved::Indexed { .. },
                )
                | None => false,
            },
            ExprKind::Number(_)
            | ExprKind::Sum(_)
            | ExprKind::Product(_)
            | ExprKind::Quotient { .. }
            | ExprKind::Power { .. }
            | ExprKind::Group { .. } => true,
            ExprKind::Apply { .. }
            | ExprKind::Named { .. }
            | ExprKind::Call { .. }
            | ExprKind::Transpose(_)
            | ExprKind::Matrix { .. }
            | ExprKind::Tuple(_)
            | ExprKind::BigSum { .. }
            | ExprKind::Integral { .. }
            | ExprKind::Derivative { .. }
            | ExprKind::Expectation(_)
            | ExprKind::Underbrace { .. }
            | ExprKind::Cases(_)
            | ExprKind::Infinity
            | ExprKind::Constant => false,
        };
        own && children(expr)
            .into_iter()
            .all(|child| self.is_number(child))
    }

    fn resolve<'n>(&self, name: &'n Name) -> Option<Resolved<'n>>
    where
        'a: 'n,
    {
        let sizes = &self.model.instances[0];
        let bound = |n: &str| self.bound.iter().any(|b| b == n) || sizes.contains_key(n);
        self.model.resolve(name, &bound).ok()
    }

    /// The declared symbol that a name is, if it is one.
    fn symbol(&self, name: &Name) -> Option<usize> {
        match self.model.resolve(name, &|_| false) {
            Ok(Resolved::Letter { symbol, order: 0 }) => Some(symbol),
            _ => None,
        }
    }

    fn of_name(&mut self, expr: &Expr, name: &Name) -> Degree {
        match self.resolve(name) {
            // Without a meaning it has no value either.
            None | Some(Resolved::Bound(_)) => Ok(0),
            Some(Resolved::Letter { symbol, order }) => self.of_symbol(symbol, order),
            Some(Resolved::Node { node, derivatives }) => match self.of_node(node)? {
                0 => Ok(0),
                degree if derivatives == 0 => Ok(degree),
                _ => Err(NoDegree::Undecided("the derivative of an unknown")),
            },
            Some(Resolved::Primed { node, .. }) => match self.of_node(node)? {
                0 => Ok(0),
                _ => Err(NoDegree::NoPolynomial),
            },
            Some(Resolved::Indexed { indices, .. }) => {
                for index in indices {
                    self.none(index)?;
                }
                let mut nodes = BTreeSet::new();
                self.model.collect(expr, &mut nodes);
                let mut largest = 0;
                for node in nodes {
                    largest = largest.max(self.of_node(node)?);
                }
                Ok(largest)
            }
        }
    }

    fn of_symbol(&self, symbol: usize, order: u8) -> Degree {
        let degree = |symbol: usize| {
            let mut letters = self.letters.iter().rev();
            letters.find(|(s, _)| *s == symbol).map_or(0, |(_, d)| *d)
        };
        let moves = self.model.argument_symbols(symbol).any(|s| degree(s) > 0);
        match degree(symbol) {
            0 if !moves => Ok(0),
            degree if order == 0 && !moves => Ok(degree),
            _ => Err(NoDegree::NoPolynomial),
        }
    }

    fn of_node(&mut self, node: Node) -> Degree {
        match node {
            Node::Unknown { system, .. } if system == self.system => return Ok(1),
            Node::Symbol(symbol) => return self.of_symbol(symbol, 0),
            Node::Unknown { .. } | Node::Matrix(_) | Node::Definition(_) | Node::Notation(_) => {}
        }
        // No definition needs an unknown that is looked for with it: it depends on it by arguments only.
        let behind = match self.letters.iter().any(|(_, degree)| *degree > 0) {
            true => self.model.symbols_behind(node, &self.display),
            false => return Ok(0),
        };
        let mut degrees = behind.iter().map(|symbol| self.of_symbol(*symbol, 0));
        if degrees.all(|degree| degree == Ok(0)) {
            return Ok(0);
        }
        let model = self.model;
        let value = match node {
            Node::Definition(d) => {
                let definition = &model.definitions[d];
                match definition.kind {
                    DefinitionKind::Whole => {
                        let display = (self.display)(definition.equation);
                        definition.place.find(display)
                    }
                    DefinitionKind::Power(_)
                    | DefinitionKind::ValueAt(_)
                    | DefinitionKind::Element(_)
                    | DefinitionKind::Family { .. } => None,
                }
            }
            Node::Notation(n) => match &model.notation[n].kind {
                NotationKind::Means(value) => Some(value),
                NotationKind::Identity(_)
                | NotationKind::Zero
                | NotationKind::CharacteristicCoefficient(_)
                | NotationKind::Cofactor(_)
                | NotationKind::LeadingMinor(_)
                | NotationKind::Entry(_)
                | NotationKind::HurwitzMatrix(_)
                | NotationKind::Constant(_)
                | NotationKind::Dirac
                | NotationKind::Rows(_)
                | NotationKind::Covariance(_) => None,
            },
            Node::Unknown { .. } | Node::Matrix(_) | Node::Symbol(_) => None,
        };
        let Some(value) = value.filter(|_| self.depth < DEEPEST) else {
            return Err(NoDegree::NoPolynomial);
        };
        self.depth += 1;
        let bound = std::mem::take(&mut self.bound);
        let degree = self.of(value);
        self.bound = bound;
        self.depth -= 1;
        degree
    }

    fn of_application(&mut self, function: &Name, arguments: &[Expr]) -> Degree {
        let model = self.model;
        let mut degrees = Vec::with_capacity(arguments.len());
        for argument in arguments {
            degrees.push(self.of(argument)?);
        }
        let constant = degrees.iter().all(|degree| *degree == 0);
        let node = match self.resolve(function) {
            Some(Resolved::Node {
                node,
                derivatives: 0,
            }) => Some(node),
            _ => None,
        };
        if let Some(Node::Unknown { system, .. }) = node
            && system == self.system
        {
            let plain = |argument: &Expr| matches!(argument.kind, ExprKind::Name(_));
            return match constant && arguments.iter().all(plain) {
                true => Ok(1),
                false => Err(NoDegree::Undecided("an unknown at another argument")),
            };
        }
        let Some((node, definition)) =
            node.and_then(|node| Some((node, model.function_definition(node)?)))
        else {
            return match constant {
                true => self.of_name(&named(function), function),
                false => Err(NoDegree::NoPolynomial),
            };
        };
        let display = (self.display)(definition.equation);
        let mut relations = display.clauses.iter().flat_map(|c| &c.chain.relations);
        if !constant
            && (relations.any(|relation| *relation != Relation::Equal)
                || model.own_values(&definition.name).next().is_some())
        {
            let what = "an unknown as the argument of a function with a range";
            return Err(NoDegree::Undecided(what));
        }
        let mut images = Vec::new();
        for (position, (argument, degree)) in arguments.iter().zip(degrees).enumerate() {
            let name = match &argument.kind {
                ExprKind::Named { name, .. } => Some(name),
                _ => definition.arguments.get(position),
            };
            match name.and_then(|name| self.symbol(name)) {
                Some(symbol) => images.push((symbol, degree)),
                None if degree == 0 => {}
                None => return Err(NoDegree::NoPolynomial),
            }
        }
        let before = self.letters.len();
        self.letters.extend(images);
        let degree = self.of_node(node);
        self.letters.truncate(before);
        degree
    }
}

/// A name as an expression.
fn named(name: &Name) -> Expr {
    Expr::new(ExprKind::Name(name.clone()), Default::default())
}
