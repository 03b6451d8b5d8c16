//! The shapes of unknown names, from the shapes of their neighbours.
//!
//! Rows and columns are passed up from what is known and down to what is not, until nothing more
//! is learned. What stays unknown is not checked.

use super::names::{Names, family_key, key};
use crate::expr::{Chain, Expr, ExprKind, Font, Function, Name};
use crate::model::NotationKind;
use num_traits::{One, ToPrimitive};
use std::collections::{BTreeMap, BTreeSet};

/// Rows and columns, as far as they are known.
pub(super) type Shape = (Option<usize>, Option<usize>);

const SCALAR: Shape = (Some(1), Some(1));

/// Most rounds of learning; each teaches at least one shape or is the last.
const ROUNDS: usize = 12;

pub(super) struct Shapes<'n> {
    names: &'n Names,
    learned: BTreeMap<String, Shape>,
    /// Families whose shape is being found out.
    open: BTreeSet<String>,
}

fn merge(a: Shape, b: Shape) -> Shape {
    (a.0.or(b.0), a.1.or(b.1))
}

/// Whether a letter without further knowledge is a scalar: small and plain.
fn is_small(name: &Name) -> bool {
    name.letter.font == Font::Italic
        && name
            .letter
            .base
            .trim_start_matches('\\')
            .starts_with(|c: char| c.is_lowercase())
}

impl<'n> Shapes<'n> {
    pub fn new(names: &'n Names) -> Self {
        Shapes {
            names,
            learned: BTreeMap::new(),
            open: BTreeSet::new(),
        }
    }

    /// Learns from these chains, whose members have one shape each.
    pub fn learn(&mut self, chains: &[&Chain]) {
        for _ in 0..ROUNDS {
            let before = self.learned.clone();
            for chain in chains {
                let shapes: Vec<Shape> = chain.members.iter().map(|m| self.of(m)).collect();
                let common = shapes.into_iter().reduce(merge).unwrap_or_default();
                for member in &chain.members {
                    self.impose(member, common);
                }
            }
            if before == self.learned {
                break;
            }
        }
    }

    /// The shape of an unknown name, once both its sides are known.
    pub fn learned(&self, name: &Name) -> Option<(usize, usize)> {
        if is_small(name) {
            return Some((1, 1));
        }
        match self.learned.get(&key(name))? {
            (Some(rows), Some(columns)) => Some((*rows, *columns)),
            _ => None,
        }
    }

    fn name(&mut self, name: &Name) -> Shape {
        let known_as = key(name);
        if let Some(binding) = self.names.bindings.get(&known_as) {
            return sides(binding.measure.shape());
        }
        if let Some(convention) = self.names.conventions.get(&known_as) {
            return match convention {
                NotationKind::Identity(order) => {
                    let order = order.at(&self.names.instance);
                    (Some(order), Some(order))
                }
                NotationKind::Rows(_) => SCALAR,
                NotationKind::Means(e) | NotationKind::HurwitzMatrix(e) => {
                    self.guarded(&known_as, e)
                }
                NotationKind::Covariance(c) => self.guarded(&known_as, &c.product),
                NotationKind::Constant(_)
                | NotationKind::CharacteristicCoefficient(_)
                | NotationKind::Cofactor(_)
                | NotationKind::LeadingMinor(_)
                | NotationKind::Entry(_) => SCALAR,
                NotationKind::Zero | NotationKind::Dirac => (None, None),
            };
        }
        if self.names.knows(name) {
            let family = family_key(name);
            let arity = name.subscript.as_ref().map_or(0, |s| s.indices.len());
            return match self.names.families.get(&(family.clone(), arity)) {
                Some(found) => self.guarded(&family, &found.body),
                None => SCALAR,
            };
        }
        match self.learned.get(&known_as) {
            Some(shape) => *shape,
            None if is_small(name) => SCALAR,
            None => (None, None),
        }
    }

    fn guarded(&mut self, known_as: &str, expr: &Expr) -> Shape {
        if !self.open.insert(known_as.into()) {
            return (None, None);
        }
        let shape = self.of(expr);
        self.open.remove(known_as);
        shape
    }

    fn of(&mut self, expr: &Expr) -> Shape {
        match &expr.kind {
            ExprKind::Number(number) if number.to_i8() == Some(0) => (None, None),
            ExprKind::Name(name) | ExprKind::Apply { function: name, .. } => self.name(name),
            ExprKind::Sum(terms) => terms
                .iter()
                .map(|(_, term)| self.of(term))
                .reduce(merge)
                .unwrap_or_default(),
            ExprKind::Product(factors) => {
                let shapes: Vec<Shape> = factors.iter().map(|f| self.of(f)).collect();
                let mut matrices = shapes.iter().filter(|shape| **shape != SCALAR);
                match (matrices.next(), matrices.next_back()) {
                    (None, _) => SCALAR,
                    (Some(only), None) => *only,
                    (Some(first), Some(last)) => (first.0, last.1),
                }
            }
            ExprKind::Transpose(inner) => {
                let (rows, columns) = self.of(inner);
                (columns, rows)
            }
            ExprKind::Matrix { rows, .. } => {
                let blocks = rows
                    .iter()
                    .flatten()
                    .any(|entry| self.of(entry) != SCALAR && !is_zero(entry));
                if blocks {
                    (None, None)
                } else {
                    (Some(rows.len()), rows.first().map(Vec::len))
                }
            }
            ExprKind::Quotient {
                numerator: inner, ..
            }
            | ExprKind::Power { base: inner, .. }
            | ExprKind::Group { inner, .. }
            | ExprKind::Expectation(inner)
            | ExprKind::Named { value: inner, .. }
            | ExprKind::BigSum { body: inner, .. }
            | ExprKind::Integral { body: inner, .. }
            | ExprKind::Derivative { body: inner, .. }
            | ExprKind::Underbrace { body: inner, .. } => self.of(inner),
            ExprKind::Call { function, argument } => {
                let by_entries = matches!(function, Function::RealPart | Function::ImaginaryPart);
                if by_entries {
                    self.of(argument)
                } else {
                    SCALAR
                }
            }
            ExprKind::Cases(cases) => cases
                .iter()
                .map(|(e, _)| self.of(e))
                .reduce(merge)
                .unwrap_or_default(),
            ExprKind::Number(_) => SCALAR,
            ExprKind::Tuple(_) | ExprKind::Infinity | ExprKind::Constant => (None, None),
        }
    }

    /// Learns what an expression must be if it has this shape.
    fn impose(&mut self, expr: &Expr, shape: Shape) {
        let shape = merge(self.of(expr), shape);
        match &expr.kind {
            ExprKind::Name(name) | ExprKind::Apply { function: name, .. }
                if !self.names.knows(name) && !is_small(name) =>
            {
                let learned = self.learned.entry(key(name)).or_default();
                *learned = merge(*learned, shape);
            }
            ExprKind::Sum(terms) => {
                for (_, term) in terms {
                    self.impose(term, shape);
                }
            }
            ExprKind::Product(factors) => self.impose_product(factors, shape),
            ExprKind::Transpose(inner) => self.impose(inner, (shape.1, shape.0)),
            ExprKind::Power { base, exponent } if !matches!(&exponent.kind, ExprKind::Number(n) if n.is_one()) =>
            {
                // Only square matrices have powers.
                let side = shape.0.or(shape.1);
                self.impose(base, (side, side));
            }
            ExprKind::Quotient {
                numerator,
                denominator,
                ..
            } => {
                self.impose(numerator, shape);
                self.impose(denominator, SCALAR);
            }
            ExprKind::Group { inner, .. }
            | ExprKind::Expectation(inner)
            | ExprKind::BigSum { body: inner, .. }
            | ExprKind::Integral { body: inner, .. }
            | ExprKind::Derivative { body: inner, .. }
            | ExprKind::Underbrace { body: inner, .. } => self.impose(inner, shape),
            ExprKind::Call { argument, .. } => {
                let inner = self.of(argument);
                self.impose(argument, inner);
            }
            ExprKind::Cases(cases) => {
                for (value, _) in cases {
                    self.impose(value, shape);
                }
            }
            // Known already, or without a shape to give on.
            ExprKind::Name(_)
            | ExprKind::Apply { .. }
            | ExprKind::Named { .. }
            | ExprKind::Number(_)
            | ExprKind::Power { .. }
            | ExprKind::Matrix { .. }
            | ExprKind::Tuple(_)
            | ExprKind::Infinity
            | ExprKind::Constant => {}
        }
    }

    fn impose_product(&mut self, factors: &[Expr], shape: Shape) {
        let matrices: Vec<&Expr> = factors.iter().filter(|f| self.of(f) != SCALAR).collect();
        let shapes: Vec<Shape> = matrices.iter().map(|m| self.of(m)).collect();
        for (at, matrix) in matrices.iter().enumerate() {
            let rows = match at.checked_sub(1) {
                None => shape.0,
                Some(left) => shapes[left].1,
            };
            let columns = match shapes.get(at + 1) {
                None => shape.1,
                Some(right) => right.0,
            };
            self.impose(matrix, (rows, columns));
        }
    }
}

fn is_zero(expr: &Expr) -> bool {
    matches!(&expr.kind, ExprKind::Number(number) if number.to_i8() == Some(0))
}

fn sides(shape: Option<(usize, usize)>) -> Shape {
    match shape {
        Some((rows, columns)) => (Some(rows), Some(columns)),
        None => (None, None),
    }
}
