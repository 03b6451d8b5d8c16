//! `E{...}` of what has degree two at most in random quantities with mean zero.
//!
//! Which letters are random the covariances of the notation say: the entries of their vectors. That an
//! expression has degree two at most in them is seen from how it is put together; then it is what it is
//! where they vanish, plus the coefficients of their products times the covariances, and the
//! coefficients are read off along the axes and the diagonals between them.

use super::degrees::Degrees;
use super::evaluator::{Evaluator, Result};
use super::failure::Reason;
use super::jet::Jet;
use super::letters::LayerKind;
use super::value::Value;
use super::world::World;
use crate::expr::{Expr, ExprKind};
use crate::latex;
use crate::model::Node;
use crate::model::names::Resolved;
use crate::span::Span;
use std::collections::{BTreeMap, BTreeSet};

/// A symbol or its derivative of an order.
type Letter = (usize, u8);

/// The most random letters that an expectation is computed for.
const MOST_LETTERS: usize = 24;

/// The coefficients of products of two letters, by their numbers.
type Coefficients = BTreeMap<(usize, usize), Value>;

/// Where the covariance of two letters stands: the matrix, its row and its column.
type Source = (Node, usize, usize);

impl Evaluator<'_, '_> {
    pub(super) fn expectation(&mut self, body: &Expr, span: Span) -> Result<Value> {
        let unsupported = |what| Err(Reason::Unsupported(what).at(span));
        let world = self.world;
        let moments = moments(world);
        let degree = Degrees::new(world).of(body);
        if degree.is_none_or(|degree| degree > 2) {
            return unsupported("an expectation of another degree than two");
        }
        let behind = world.behind_expression(body);
        let random: BTreeSet<Letter> = moments
            .keys()
            .flat_map(|(a, b)| [*a, *b])
            .filter(|(s, _)| behind.symbols.contains(s))
            .collect();
        let random: Vec<Letter> = random.into_iter().collect();
        if random.len() > MOST_LETTERS {
            return Err(Reason::Budget("random quantities").at(span));
        }
        let outside = std::mem::take(&mut self.used);
        let coefficients = self.quadratic_coefficients(body, &random, span);
        let used = std::mem::replace(&mut self.used, outside);
        let process = |s: usize| world.model().symbols[s].function_of.is_some();
        let other = used.keys().any(|(s, _)| process(*s));
        self.used.extend(used);
        if other {
            return unsupported("an expectation of what is not known to be random");
        }
        let (mut sum, coefficients) = coefficients?;
        for ((i, j), coefficient) in coefficients {
            let zero = coefficient.entries().iter().all(|c| c.is_zero());
            if zero {
                continue;
            }
            let (a, b) = (random[i].min(random[j]), random[i].max(random[j]));
            let Some((node, row, column)) = moments.get(&(a, b)) else {
                return unsupported("a product without a covariance");
            };
            let covariance = self.node((*node, Vec::new()), span)?;
            let entry = match &covariance {
                Value::Scalar(x) if (*row, *column) == (0, 0) => x.clone(),
                Value::Matrix(m) if *row < m.rows() && *column < m.columns() => {
                    m[(*row, *column)].clone()
                }
                Value::Zero => Jet::zero(),
                Value::Scalar(_) | Value::Matrix(_) => {
                    return unsupported("a covariance of another shape");
                }
            };
            let term = self
                .arithmetic
                .product(&Value::Scalar(entry), &coefficient)
                .map_err(|r| r.at(span))?;
            sum = self.arithmetic.sum(&sum, &term).map_err(|r| r.at(span))?;
        }
        Ok(sum)
    }

    /// The value where all random letters vanish, and the coefficients of their products.
    fn quadratic_coefficients(
        &mut self,
        body: &Expr,
        random: &[Letter],
        span: Span,
    ) -> Result<(Value, Coefficients)> {
        let mut constant = Value::Zero;
        let mut found: BTreeMap<(usize, usize), Value> = BTreeMap::new();
        let n = random.len();
        let pairs = (0..n).map(|i| (i, i));
        let pairs = pairs.chain((0..n).flat_map(|i| (i + 1..n).map(move |j| (i, j))));
        for (i, j) in pairs {
            let value = self.along(body, random, &[i, j], span)?;
            constant = value.0;
            let coefficient = if i == j {
                value.1
            } else {
                // Of (r_i + r_j): the square of each is in it.
                let both = self.arithmetic.sum(&found[&(i, i)], &found[&(j, j)]);
                let both = both.map_err(|r| r.at(span))?;
                let rest = self.arithmetic.sum(&value.1, &both.negated());
                rest.map_err(|r| r.at(span))?
            };
            found.insert((i, j), coefficient);
        }
        if n == 0 {
            constant = self.expression(body)?;
        }
        Ok((constant, found))
    }

    /// The coefficients of e^0 and e^2 where the letters with these numbers are e and the others vanish.
    fn along(
        &mut self,
        body: &Expr,
        random: &[Letter],
        numbers: &[usize],
        span: Span,
    ) -> Result<(Value, Value)> {
        let variable = self.arithmetic.open(2);
        let values = random.iter().enumerate().map(|(k, letter)| {
            let value = if numbers.contains(&k) {
                Jet::series(variable, vec![Jet::zero(), Jet::integer(1)])
            } else {
                Jet::zero()
            };
            (*letter, value)
        });
        let layer = LayerKind::Given(values.collect());
        let value = self.with_layer(layer, |e| e.expression(body));
        self.arithmetic.close();
        let value = value?;
        let coefficient = |k: usize| value.map(|x| Ok::<_, Reason>(x.coefficient(variable, k)));
        let pair = coefficient(0).and_then(|zero| Ok((zero, coefficient(2)?)));
        pair.map_err(|r| r.at(span))
    }
}

/// The covariances of pairs of letters.
fn moments(world: &World<'_>) -> BTreeMap<(Letter, Letter), Source> {
    let mut found = BTreeMap::new();
    for (_, node, covariance) in world.model().covariances() {
        let vectors = [&covariance.left, &covariance.right].map(|v| letters_of(world, v, 0));
        let [Some(left), Some(right)] = vectors else {
            continue;
        };
        for (i, a) in left.iter().enumerate() {
            for (j, b) in right.iter().enumerate() {
                let pair = (*a.min(b), *a.max(b));
                found.entry(pair).or_insert((node, i, j));
            }
        }
    }
    found
}

/// The letters that the entries of a column are, if that is all they are.
fn letters_of(world: &World<'_>, vector: &Expr, depth: usize) -> Option<Vec<Letter>> {
    let model = world.model();
    if depth > 16 {
        return None;
    }
    match &vector.kind {
        ExprKind::Group { inner, .. } | ExprKind::Underbrace { body: inner, .. } => {
            letters_of(world, inner, depth + 1)
        }
        ExprKind::Apply {
            function,
            arguments,
        } => {
            let plain = |a: &Expr| {
                matches!(&a.kind, ExprKind::Name(n)
                    if model.is_argument_of(function, &latex::canonical(n)))
            };
            let defined = match model.resolve(function, &|_| false) {
                Ok(Resolved::Node { node, .. }) => model.function_definition(node).is_some(),
                _ => false,
            };
            if defined || !arguments.iter().all(plain) {
                return None;
            }
            let name = Expr::new(ExprKind::Name(function.clone()), vector.span);
            letters_of(world, &name, depth + 1)
        }
        ExprKind::Name(name) => match model.resolve(name, &|_| false).ok()? {
            Resolved::Letter { symbol, order } => Some(vec![(symbol, order)]),
            Resolved::Node {
                node: Node::Matrix(m),
                derivatives,
            } => {
                let matrix = &model.matrices[m];
                let (rows, columns) = matrix.shape_in(&model.instances[world.instance]);
                if columns != 1 {
                    return None;
                }
                let letters = (0..rows).map(|i| match matrix.entry(i, 0) {
                    crate::model::matrices::MatrixEntry::Symbol(s) => Some((s, derivatives)),
                    _ => None,
                });
                letters.collect()
            }
            Resolved::Node {
                node: Node::Definition(d),
                derivatives,
            } => {
                let definition = &model.definitions[d];
                let value = definition.place.find(world.display(definition.equation))?;
                let letters = letters_of(world, value, depth + 1)?;
                // A derivative of a letter is a letter unless an equation of motion gives it.
                let higher = |l: Letter| -> Option<Letter> {
                    let order = l.1 + derivatives;
                    let free = (l.1 + 1..=order).all(|k| is_free(world, (l.0, k)));
                    free.then_some((l.0, order))
                };
                letters.into_iter().map(higher).collect()
            }
            _ => None,
        },
        ExprKind::Matrix { rows, .. } => {
            let mut letters = Vec::new();
            for row in rows {
                let [entry] = row.as_slice() else {
                    return None;
                };
                letters.extend(letters_of(world, entry, depth + 1)?);
            }
            Some(letters)
        }
        _ => None,
    }
}

/// Whether nothing determines a derivative of a symbol.
fn is_free(world: &World<'_>, (symbol, order): Letter) -> bool {
    let model = world.model();
    let declared = &model.symbols[symbol];
    let mut name = match declared.entry_of {
        Some((matrix, ..)) => model.matrices[matrix].name.clone(),
        None => declared.name.clone(),
    };
    name.dots = name.dots.saturating_add(order);
    match model.resolve(&name, &|_| false) {
        Ok(Resolved::Node { node, .. }) => matches!(node, Node::Matrix(_)),
        _ => true,
    }
}
