//! The values of names: letters, definitions, members of families, entries, unknowns, and what the
//! table of notation says.

use super::arithmetic::Arithmetic;
use super::evaluator::{Evaluator, Key, Result};
use super::failure::Reason;
use super::jet::Jet;
use super::letters::LayerKind;
use super::value::{Value, identity};
use super::world::Known;
use crate::expr::Name;
use crate::functions::Constant;
use crate::latex;
use crate::matrix::Matrix;
use crate::model::matrices::MatrixEntry;
use crate::model::names::{Element, Resolved};
use crate::model::{DefinitionKind, Node, NotationKind};
use crate::real::{Complex, Real};
use crate::span::Span;
use std::sync::Arc;

impl Evaluator<'_, '_> {
    pub(super) fn name(&mut self, name: &Name, span: Span) -> Result<Value> {
        let model = self.world.model;
        let at = self
            .layers
            .iter()
            .rev()
            .find_map(|layer| match &layer.kind {
                LayerKind::At(number) => Some(number),
                LayerKind::Replaced { .. }
                | LayerKind::Shifted { .. }
                | LayerKind::Passing { .. }
                | LayerKind::Given(_)
                | LayerKind::Unknowns { .. } => None,
            });
        if let Some(definition) = at.and_then(|at| model.value_at(name, at)) {
            // What the document says of it there.
            let depth = self
                .layers
                .iter()
                .position(|l| matches!(l.kind, LayerKind::At(_)));
            return self.below(depth.unwrap_or(0), |e| {
                e.node((Node::Definition(definition), Vec::new()), span)
            });
        }
        let resolved = {
            let is_bound = |n: &str| self.bound_value(n).is_some();
            model.resolve(name, &is_bound)
        };
        let resolved = resolved.map_err(|_| Reason::Undeclared(latex::canonical(name)).at(span))?;
        match resolved {
            Resolved::Bound(index) => match self.bound_value(&index) {
                Some(value) => Ok(Value::Scalar(Jet::integer(value))),
                None => Err(Reason::Undeclared(index).at(span)),
            },
            Resolved::Letter { symbol, order } => {
                self.letter(symbol, order, span).map(Value::Scalar)
            }
            Resolved::Node { node, derivatives } => self.node_rate(node, derivatives, span),
            Resolved::Primed { .. } => {
                let what = "the derivative of a function by its argument";
                Err(Reason::Unsupported(what).at(span))
            }
            Resolved::Indexed { key, indices } => {
                let indices: Vec<i64> = indices
                    .iter()
                    .map(|index| self.integer(index))
                    .collect::<Result<_>>()?;
                self.element(&key, &indices, span)
            }
        }
    }

    /// Whether a name is the base of exponentials.
    pub(super) fn is_euler(&self, name: &Name) -> bool {
        let model = self.world.model;
        match model.resolve(name, &|_| false) {
            Ok(Resolved::Node {
                node: Node::Notation(n),
                derivatives: 0,
            }) => matches!(
                model.notation[n].kind,
                NotationKind::Constant(Constant::Euler)
            ),
            _ => false,
        }
    }

    fn element(&mut self, key: &str, indices: &[i64], span: Span) -> Result<Value> {
        let mut existing = Vec::new();
        for element in self.world.model.elements(&key.to_string(), indices) {
            let value = match element {
                Element::Node(node) => self.node((node, Vec::new()), span),
                Element::Member(node, indices) => self.node((node, indices), span),
                Element::Entry(node, indices) => self
                    .node((node, Vec::new()), span)
                    .and_then(|matrix| entry(&matrix, &indices, span)),
            };
            match value {
                Err(none) if matches!(none.reason, Reason::Outside(_)) => {}
                other => existing.push(other?),
            }
        }
        match existing.pop() {
            None => Err(Reason::Outside(indices.to_vec()).at(span)),
            Some(value) if existing.is_empty() => Ok(value),
            Some(_) => Err(Reason::Unsupported("an index with two readings").at(span)),
        }
    }

    /// The value of a node, computed once for the layers that it depends on.
    pub(super) fn node(&mut self, key: Key, span: Span) -> Result<Value> {
        let behind = self.world.behind(key.0);
        let affecting = self
            .layers
            .iter()
            .rposition(|layer| layer.affects(&behind, self.world));
        let depth = affecting.map_or(0, |k| k + 1);
        self.below(depth, |e| e.node_here(key, span))
    }

    fn node_here(&mut self, key: Key, span: Span) -> Result<Value> {
        if let Node::Unknown { system, position } = key.0 {
            let trial = self.layers.iter().rev().find_map(|layer| {
                let LayerKind::Unknowns { system: of, values } = &layer.kind else {
                    return None;
                };
                (*of == system).then(|| values.get(position))?
            });
            if let Some(value) = trial {
                return Ok(value.clone());
            }
        }
        match self.layers.last() {
            Some(layer) => {
                if let Some(value) = layer.known.get(&key) {
                    return Ok(value.clone());
                }
            }
            None => {
                if let Some(value) = self.known_at_point(&key) {
                    return Ok(value);
                }
            }
        }
        let opened = (
            key.clone(),
            self.layers.last().map_or(0, |layer| layer.number),
        );
        if !self.open.insert(opened.clone()) {
            return Err(Reason::Cyclic.at(span));
        }
        let outer = std::mem::take(&mut self.bound);
        let wanted = self.wanted_rows.take();
        let used = std::mem::take(&mut self.used);
        let coarse = std::mem::take(&mut self.coarse);
        let value = self.compute(&key, span);
        self.bound = outer;
        self.wanted_rows = wanted;
        self.open.remove(&opened);
        if let Ok(value) = &value {
            self.remember(key, value.clone());
        }
        self.used.extend(used);
        self.coarse |= coarse;
        value
    }

    /// A value that was computed before at the point itself, for this claim or for another.
    fn known_at_point(&mut self, key: &Key) -> Option<Value> {
        let bits = self.arithmetic.bits;
        let known = match self.known.get(key) {
            Some(known) => known.clone(),
            None => {
                let known = self.world.known(self.point, bits, key)?;
                self.known.insert(key.clone(), known.clone());
                known
            }
        };
        for (letter, value) in &known.used {
            self.used.entry(*letter).or_insert_with(|| value.clone());
        }
        self.coarse |= known.coarse;
        Some(known.value.clone())
    }

    /// Keeps a value for the present layers, with what was used since its computation began.
    pub(super) fn remember(&mut self, key: Key, value: Value) {
        match self.layers.last_mut() {
            Some(layer) => {
                layer.known.insert(key, value);
            }
            None => {
                let known = Arc::new(Known {
                    value,
                    used: self.used.clone(),
                    coarse: self.coarse,
                });
                let bits = self.arithmetic.bits;
                self.world.keep(self.point, bits, &key, &known);
                self.known.insert(key, known);
            }
        }
    }

    fn compute(&mut self, key: &Key, span: Span) -> Result<Value> {
        let model = self.world.model;
        let (node, indices) = key;
        match node {
            Node::Symbol(symbol) => self.letter(*symbol, 0, span).map(Value::Scalar),
            Node::Matrix(matrix) => self.declared_matrix(*matrix, span),
            Node::Definition(d) => {
                let definition = &model.definitions[*d];
                if let DefinitionKind::Family { indices: names, .. } = &definition.kind {
                    self.bound = names.iter().cloned().zip(indices.iter().copied()).collect();
                }
                if let Some(value) = self.own_value_here(*d, span)? {
                    return Ok(value);
                }
                let world = self.world;
                match definition.place.find(world.display(definition.equation)) {
                    Some(expr) => self.expression(expr),
                    None => Err(Reason::Unsupported("a definition without a value").at(span)),
                }
            }
            Node::Unknown { system, position } => {
                let values = self.solve_system(*system, span)?;
                let value = values.get(*position).cloned();
                for (other, value) in values.into_iter().enumerate() {
                    let node = Node::Unknown {
                        system: *system,
                        position: other,
                    };
                    self.remember((node, Vec::new()), value);
                }
                value.ok_or_else(|| Reason::Unsupported("an unknown without a place").at(span))
            }
            Node::Notation(n) => self.notation(*n, indices, span),
        }
    }

    fn declared_matrix(&mut self, matrix: usize, span: Span) -> Result<Value> {
        let model = self.world.model;
        let declared = &model.matrices[matrix];
        let (rows, columns) = declared.shape_in(&model.instances[self.world.instance]);
        let letters = Matrix::try_from_fn(rows, columns, |i, j| match declared.entry(i, j) {
            MatrixEntry::Zero => Ok(Jet::zero()),
            MatrixEntry::Symbol(symbol) => self.letter(symbol, 0, span),
            MatrixEntry::MinusSymbol(symbol) => Ok(self.letter(symbol, 0, span)?.negated()),
        })?;
        Ok(Value::from_matrix(letters))
    }

    fn notation(&mut self, index: usize, indices: &[i64], span: Span) -> Result<Value> {
        let model = self.world.model;
        let fail = |reason: Reason| reason.at(span);
        let outside = || Reason::Outside(indices.to_vec()).at(span);
        let number = |k: usize| indices.get(k).and_then(|i| usize::try_from(*i).ok());
        let coefficients = |e: &mut Self, of| {
            let matrix = e.expression(of)?.square("determinant").map_err(fail)?;
            e.arithmetic
                .characteristic_coefficients(&matrix)
                .map_err(fail)
        };
        match &model.notation[index].kind {
            NotationKind::Identity(size) => {
                let order = size.at(&model.instances[self.world.instance]);
                Ok(Value::from_matrix(identity(order)))
            }
            NotationKind::Zero => Ok(Value::Zero),
            NotationKind::Means(of) => self.expression(of),
            NotationKind::Constant(constant) => Ok(Value::Scalar(self.constant(*constant, span)?)),
            NotationKind::Entry(of) => {
                let matrix = self.expression(of)?;
                entry(&matrix, indices, span)
            }
            NotationKind::Rows(of) => {
                let shape = self.expression(of)?.shape();
                let rows = shape.and_then(|(rows, _)| i64::try_from(rows).ok());
                let rows =
                    rows.ok_or_else(|| Reason::Unsupported("the rows of a zero").at(span))?;
                Ok(Value::Scalar(Jet::integer(rows)))
            }
            NotationKind::CharacteristicCoefficient(of) => {
                let k = number(0).ok_or_else(outside)?;
                // Beyond the degree a polynomial's coefficients are zero.
                let found = coefficients(self, of)?;
                Ok(Value::Scalar(
                    found.get(k).cloned().unwrap_or_else(Jet::zero),
                ))
            }
            NotationKind::HurwitzMatrix(of) => {
                let found = coefficients(self, of)?;
                let matrix = Arithmetic::hurwitz_matrix(&found).ok_or_else(outside)?;
                Ok(Value::from_matrix(matrix))
            }
            NotationKind::Cofactor(of) => {
                let matrix = self.expression(of)?.square("cofactor").map_err(fail)?;
                let place = |k: usize| number(k).and_then(|n| n.checked_sub(1));
                let (i, j) = place(0).zip(place(1)).ok_or_else(outside)?;
                if i >= matrix.rows() || j >= matrix.columns() {
                    return Err(outside());
                }
                // The cofactor of a single number is the empty determinant.
                let minor = match matrix.without(i, j) {
                    Some(rest) => self.arithmetic.determinant(&rest).map_err(fail)?,
                    None => Jet::integer(1),
                };
                Ok(Value::Scalar(if (i + j) % 2 == 0 {
                    minor
                } else {
                    minor.negated()
                }))
            }
            NotationKind::LeadingMinor(of) => {
                let matrix = self.expression(of)?.square("minor").map_err(fail)?;
                let order = number(0).filter(|n| (1..=matrix.rows()).contains(n));
                let leading = matrix.leading(order.ok_or_else(outside)?);
                self.arithmetic
                    .determinant(&leading)
                    .map(Value::Scalar)
                    .map_err(fail)
            }
            NotationKind::Dirac => Err(Reason::Unsupported("the Dirac distribution").at(span)),
            NotationKind::Covariance(covariance) => self.expectation(&covariance.product, span),
        }
    }

    fn constant(&self, constant: Constant, span: Span) -> Result<Jet> {
        let bits = self.arithmetic.bits;
        match constant {
            Constant::Pi => Ok(Jet::from(Real::pi(bits))),
            Constant::Euler => self
                .arithmetic
                .exponential(&Jet::integer(1))
                .map_err(|r| r.at(span)),
            Constant::ImaginaryUnit => Ok(Jet::Number(Complex::imaginary_unit())),
        }
    }
}

/// The entry with these indices, from 1; a vector may have one index.
fn entry(value: &Value, indices: &[i64], span: Span) -> Result<Value> {
    let at = |k: i64| usize::try_from(k).ok()?.checked_sub(1);
    // Which entries the zero of any shape has is not known.
    let none = Reason::Unsupported("an entry of a zero without a shape");
    let (rows, columns) = value.shape().ok_or_else(|| none.at(span))?;
    let place = match indices {
        [i, j] => at(*i).zip(at(*j)),
        [i] if columns == 1 => at(*i).map(|i| (i, 0)),
        [j] if rows == 1 => at(*j).map(|j| (0, j)),
        _ => None,
    };
    match (value, place) {
        (Value::Matrix(m), Some((i, j))) if i < rows && j < columns => {
            Ok(Value::Scalar(m[(i, j)].clone()))
        }
        (Value::Scalar(x), Some((0, 0))) => Ok(Value::Scalar(x.clone())),
        (Value::Matrix(_) | Value::Scalar(_) | Value::Zero, _) => {
            Err(Reason::Outside(indices.to_vec()).at(span))
        }
    }
}
