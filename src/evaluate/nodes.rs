//! The values of names: symbols, definitions, families, notation, and their time derivatives.

use super::memo::Known;
use super::{Evaluator, Failure, FailureKind, Key, Value};
use crate::domain::Domain;
use crate::expr::{Expr, Name};
use crate::matrix::Matrix;
use crate::model::matrices::MatrixEntry;
use crate::model::names::{Element, FamilyKey};
use crate::model::time::Clock;
use crate::model::{DefinitionKind, Node, NotationKind};
use crate::span::Span;
use crate::theory::{arithmetic, characteristic, determinant, hurwitz};
use num_rational::BigRational;
use std::sync::Arc;

impl<D: Domain> Evaluator<'_, D> {
    /// The value of a symbol's time derivative of an order.
    pub(super) fn symbol(
        &mut self,
        symbol: usize,
        order: u8,
        span: Span,
    ) -> Result<Value<D::Element>, Failure> {
        if self.frame.at.is_some() && self.model.symbols[symbol].function_of.is_some() {
            return Err(Failure::unsupported(
                "the value of a process where nothing says it",
                span,
            ));
        }
        let elsewhere = |argument| {
            let mut replaced = self.frame.replaced.iter();
            replaced.any(|r| r.symbols.contains(&argument))
        };
        // By a hypothesis such as v' = 0 it has the same value everywhere.
        let constant = || {
            let rate = self.model.letter_of_symbol(symbol, order + 1);
            rate.is_some_and(|rate| self.field.is_zero(self.letter(rate)))
        };
        if self.model.argument_symbols(symbol).any(elsewhere) && !constant() {
            return Err(Failure::unsupported("a process at another argument", span));
        }
        // A process has a letter for each order in use; of anything else the derivative is computed.
        if self.model.symbols[symbol].function_of.is_none() {
            if order > 0 {
                return self.rate_of_symbol(symbol, order, span);
            }
            if let (Some(at), Clock::Runs(_)) = (&self.frame.at, self.model.clock(symbol)) {
                let at = self.field.rational(at);
                return at
                    .map(Value::Scalar)
                    .ok_or_else(|| Failure::new(FailureKind::DivisionByZero, span));
            }
        }
        self.model
            .letter_of_symbol(symbol, order)
            .map(|letter| Value::Scalar(self.letter(letter).clone()))
            .ok_or_else(|| Failure::unsupported("a time derivative of so high an order", span))
    }

    /// A declared matrix, or its time derivative of an order: a matrix of letters.
    fn declared_matrix(
        &mut self,
        matrix: usize,
        order: u8,
        span: Span,
    ) -> Result<Value<D::Element>, Failure> {
        let model = self.model;
        let matrix = &model.matrices[matrix];
        let (rows, columns) = matrix.shape_in(&model.instances[self.world.instance()]);
        let letters = Matrix::try_from_fn(rows, columns, |i, j| {
            let (symbol, negative) = match matrix.entry(i, j) {
                MatrixEntry::Zero => return Ok(self.field.integer(0)),
                MatrixEntry::Symbol(symbol) => (symbol, false),
                MatrixEntry::MinusSymbol(symbol) => (symbol, true),
            };
            let entry = self.symbol(symbol, order, span)?;
            let entry = entry.into_scalar(self.field.integer(0));
            let entry =
                entry.ok_or_else(|| Failure::unsupported("an entry that is a matrix", span))?;
            Ok(if negative {
                self.field.negate(&entry)
            } else {
                entry
            })
        })?;
        Ok(Value::from_matrix(letters))
    }

    /// Something at a number: what the document says of it, or its value with every process in it
    /// taken there.
    pub(super) fn taken_at(
        &mut self,
        function: &Name,
        at: &BigRational,
        span: Span,
    ) -> Result<Value<D::Element>, Failure> {
        // What is known is known of processes as such, not of their values.
        let known = std::mem::take(&mut self.memo);
        let outer = self.frame.at.replace(at.clone());
        let result = self.name(function, span);
        self.frame.at = outer;
        self.memo = known;
        result
    }

    /// The value that the document gives a process at a number.
    pub(super) fn given_value(
        &mut self,
        definition: usize,
        span: Span,
    ) -> Result<Value<D::Element>, Failure> {
        let at = self.frame.at.take();
        let result = self.node((Node::Definition(definition), Vec::new(), 0), span);
        self.frame.at = at;
        result
    }

    /// The value of a node, computed once.
    pub(super) fn node(&mut self, key: Key, span: Span) -> Result<Value<D::Element>, Failure> {
        if let Node::Unknown { system, position } = key.0
            && key.2 == 0
            && let Some(value) = self.frame.trial.get(&(system, position))
        {
            return Ok(value.clone());
        }
        if let Some(kind) = self.world.no_value(key.0) {
            return Err(Failure::new(kind.clone(), span));
        }
        let in_place = self.replaced_behind(key.0);
        if let Node::Definition(d) = key.0
            && key.2 == 0
            && !self.world.is_inserting()
            && !in_place
            && let Some(letter) = self.model.definitions[d].letter
            // At a number what depends on the time has another value than as such.
            && (self.frame.at.is_none() || self.clocks(key.0).is_empty())
        {
            return Ok(Value::Scalar(self.letter(letter).clone()));
        }
        let known = match self.frame.replaced.last() {
            Some(replaced) if in_place => replaced.known.get(&key),
            _ => self.memo.known(&key),
        };
        if let Some(known) = known {
            let known = Arc::clone(known);
            for condition in &known.conditions {
                if !self.conditions.contains(condition) {
                    self.conditions.push(condition.clone());
                }
            }
            return Ok(known.value.clone());
        }
        if !in_place
            && self.frame.at.is_none()
            && let Some(mut provider) = self.provider.take()
        {
            let provided = provider(&key);
            self.provider = Some(provider);
            if let Some(result) = provided {
                let value = result?;
                self.remember(key, value.clone(), usize::MAX, in_place);
                return Ok(value);
            }
        }
        if self.frame.open.len() >= super::LONGEST_CHAIN {
            return Err(Failure::new(
                FailureKind::Budget {
                    what: "definitions that need each other in a chain".into(),
                },
                span,
            ));
        }
        if !self.frame.open.insert(key.clone()) {
            return Err(Failure::new(FailureKind::NeedsItself, span));
        }
        let before = self.conditions.len();
        let outer = std::mem::take(&mut self.frame.bound);
        let result = self.compute(&key, span);
        self.frame.bound = outer;
        self.frame.open.remove(&key);
        let value = result?;
        self.remember(key, value.clone(), before, in_place);
        Ok(value)
    }

    fn remember(
        &mut self,
        key: Key,
        value: Value<D::Element>,
        conditions_from: usize,
        in_place: bool,
    ) {
        // While unknowns hold trial values nothing computed from them may outlive the trial, and a
        // value by cases is that of one case.
        if self.frame.trial.is_empty() && self.choice.met == 0 {
            let terms = value.entries().into_iter().map(|e| self.field.size(e));
            let bytes = terms
                .sum::<usize>()
                .saturating_mul(self.field.bytes_of_a_term());
            let conditions = self.conditions.get(conditions_from..).unwrap_or_default();
            let known = Known {
                value,
                conditions: conditions.to_vec(),
                bytes,
            };
            match self.frame.replaced.last_mut() {
                Some(replaced) if in_place => {
                    replaced.known.insert(key, Arc::new(known));
                }
                _ => self.memo.keep(key, known),
            }
        }
    }

    pub(super) fn compute(&mut self, key: &Key, span: Span) -> Result<Value<D::Element>, Failure> {
        let (node, indices, derivatives) = key;
        if let Node::Matrix(matrix) = node {
            return self.declared_matrix(*matrix, *derivatives, span);
        }
        if *derivatives > 0 {
            return self.rate_of_node(key, span);
        }
        match node {
            Node::Symbol(symbol) => self.symbol(*symbol, 0, span),
            Node::Matrix(matrix) => self.declared_matrix(*matrix, 0, span),
            Node::Definition(d) => {
                let model = self.model;
                let definition = &model.definitions[*d];
                if let DefinitionKind::Family { indices: names, .. } = &definition.kind {
                    self.frame.bound = names.iter().cloned().zip(indices.iter().copied()).collect();
                }
                if let Some(value) = self.own_value_here(*d, span)? {
                    return Ok(value);
                }
                let expr = self.printed(*d, span)?;
                self.expression(&expr)
            }
            Node::Unknown { system, position } => {
                let values = self.solve(*system, span)?;
                Ok(values[*position].clone())
            }
            Node::Notation(n) => self.notation(*n, indices, span),
        }
    }

    /// The value of a member of a family or an entry of a matrix.
    pub(super) fn element(
        &mut self,
        key: &FamilyKey,
        indices: &[i64],
        span: Span,
    ) -> Result<Value<D::Element>, Failure> {
        let mut existing = Vec::new();
        for element in self.model.elements(key, indices) {
            let value = match element {
                Element::Node(node) => self.node((node, Vec::new(), 0), span),
                Element::Member(node, indices) => self.node((node, indices, 0), span),
                Element::Entry(node, indices) => self
                    .node((node, Vec::new(), 0), span)
                    .and_then(|value| self.entry(&value, key, &indices, span)),
            };
            match value {
                Err(Failure {
                    kind: FailureKind::Outside { .. },
                    ..
                }) => {}
                other => existing.push(other?),
            }
        }
        match existing.len() {
            0 if self.world.is_lenient() => Ok(Value::Zero),
            0 => self.outside(key, indices, span),
            1 => Ok(existing.remove(0)),
            _ => Err(Failure::new(
                FailureKind::Ambiguous {
                    name: element_name(key, indices),
                },
                span,
            )),
        }
    }

    fn outside(
        &self,
        key: &str,
        indices: &[i64],
        span: Span,
    ) -> Result<Value<D::Element>, Failure> {
        Err(Failure::new(
            FailureKind::Outside {
                name: element_name(key, indices),
            },
            span,
        ))
    }

    fn entry(
        &self,
        value: &Value<D::Element>,
        key: &str,
        indices: &[i64],
        span: Span,
    ) -> Result<Value<D::Element>, Failure> {
        let at = |k: i64| usize::try_from(k - 1).ok();
        // Which entries the zero of any shape has is not known.
        let (rows, columns) = value
            .shape()
            .ok_or_else(|| Failure::unsupported("an entry of a zero without a shape", span))?;
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
            (Value::Scalar(s), Some((0, 0))) => Ok(Value::Scalar(s.clone())),
            (Value::Matrix(_) | Value::Scalar(_) | Value::Zero, _) => {
                self.outside(key, indices, span)
            }
        }
    }

    fn notation(
        &mut self,
        index: usize,
        indices: &[i64],
        span: Span,
    ) -> Result<Value<D::Element>, Failure> {
        let model = self.model;
        let notation = &model.notation[index];
        let key = crate::model::names::family_key(&notation.name);
        let square = |value: Value<D::Element>| match &value {
            Value::Matrix(m) if m.is_square() => Ok(m.clone()),
            Value::Scalar(s) => Ok(Matrix::from_fn(1, 1, |_, _| s.clone())),
            Value::Zero => Err(Failure::unsupported(
                "a determinant of a zero without a shape",
                span,
            )),
            Value::Matrix(_) => Err(Failure::new(
                FailureKind::Shape {
                    operation: "determinant".into(),
                    left: value.shape_text(),
                    right: "square".into(),
                },
                span,
            )),
        };
        if let NotationKind::Covariance(covariance) = &notation.kind {
            return self.expectation(&covariance.product, span);
        }
        let target = match notation.kind.target() {
            Some(expr) => self.expression(expr)?,
            None => Value::Zero,
        };
        let result = match &notation.kind {
            NotationKind::Identity(n) => {
                let order = n.at(&model.instances[self.world.instance()]);
                Some(Value::from_matrix(arithmetic::identity(&self.field, order)))
            }
            NotationKind::Rows(_) => {
                let (rows, _) = target.shape().ok_or_else(|| {
                    Failure::unsupported("the rows of a zero without a shape", span)
                })?;
                let rows = i64::try_from(rows).ok();
                rows.map(|rows| Value::Scalar(self.field.integer(rows)))
            }
            NotationKind::Zero => Some(Value::Zero),
            NotationKind::Constant(constant) => return self.constant(*constant, span),
            NotationKind::Dirac => {
                return Err(Failure::unsupported(
                    "a distribution without an argument",
                    span,
                ));
            }
            NotationKind::Means(_) | NotationKind::Covariance(_) => Some(target),
            NotationKind::Entry(_) => return self.entry(&target, &key, indices, span),
            NotationKind::CharacteristicCoefficient(_) => {
                let coefficients =
                    characteristic::characteristic_coefficients(&self.field, &square(target)?);
                // Beyond the degree a polynomial's coefficients are zero.
                coefficients.zip(indices.first()).and_then(|(c, i)| {
                    let i = usize::try_from(*i).ok()?;
                    Some(Value::Scalar(
                        c.get(i).cloned().unwrap_or_else(|| self.field.integer(0)),
                    ))
                })
            }
            NotationKind::HurwitzMatrix(_) => {
                characteristic::characteristic_coefficients(&self.field, &square(target)?)
                    .and_then(|c| hurwitz::hurwitz_matrix(&self.field, &c))
                    .map(Value::from_matrix)
            }
            NotationKind::Cofactor(_) => {
                let matrix = square(target)?;
                match indices {
                    [i, j] => usize::try_from(i - 1)
                        .ok()
                        .zip(usize::try_from(j - 1).ok())
                        .and_then(|(i, j)| determinant::cofactor(&self.field, &matrix, i, j))
                        .map(Value::Scalar),
                    _ => None,
                }
            }
            NotationKind::LeadingMinor(_) => {
                let matrix = square(target)?;
                indices
                    .first()
                    .and_then(|n| usize::try_from(*n).ok())
                    .filter(|n| (1..=matrix.rows()).contains(n))
                    .and_then(|n| determinant::determinant(&self.field, &matrix.leading(n)))
                    .map(Value::Scalar)
            }
        };
        match result {
            Some(value) => Ok(value),
            None => self.outside(&key, indices, span),
        }
    }

    pub(super) fn matrix(
        &mut self,
        rows: &[Vec<Expr>],
        span: Span,
    ) -> Result<Value<D::Element>, Failure> {
        let wanted = self.frame.wanted_rows.take();
        let mut blocks = Vec::with_capacity(rows.len());
        for row in rows {
            let mut values = Vec::with_capacity(row.len());
            for entry in row {
                values.push((self.expression(entry)?, entry.span));
            }
            blocks.push(values);
        }
        let misfit = |at: Span, left: String, right: String| {
            Failure::new(
                FailureKind::Shape {
                    operation: "matrix block".into(),
                    left,
                    right,
                },
                at,
            )
        };
        let columns = blocks.first().map_or(0, Vec::len);
        if let Some(row) = blocks.iter().find(|row| row.len() != columns) {
            let at = row.last().map_or(span, |(_, at)| *at);
            return Err(misfit(
                at,
                format!("{columns} columns"),
                format!("{} columns", row.len()),
            ));
        }
        // Heights and widths of the blocks; a zero of any shape takes what its neighbours need, then
        // what the other terms of a sum need, and is square where they leave a side open.
        let known_height = |i: usize| blocks[i].iter().find_map(|(v, _)| v.shape()).map(|s| s.0);
        let known_width = |j: usize| blocks.iter().find_map(|row| row[j].0.shape()).map(|s| s.1);
        let others: usize = (0..blocks.len()).filter_map(known_height).sum();
        let open = (0..blocks.len()).filter(|i| known_height(*i).is_none());
        let left_open = wanted
            .and_then(|wanted| wanted.checked_sub(others))
            .filter(|rest| *rest > 0 && open.count() == 1);
        let height = |i: usize| {
            let square = || (0..columns).find_map(known_width);
            known_height(i).or(left_open).or_else(square).unwrap_or(1)
        };
        let width = |j: usize| {
            let square = || (0..blocks.len()).find_map(known_height);
            known_width(j).or_else(square).unwrap_or(1)
        };
        let mut entries = Vec::new();
        for (i, row) in blocks.iter().enumerate() {
            for r in 0..height(i) {
                let mut line = Vec::new();
                for (j, (value, at)) in row.iter().enumerate() {
                    let expected = (height(i), width(j));
                    for c in 0..expected.1 {
                        line.push(match value {
                            Value::Zero => self.field.integer(0),
                            Value::Scalar(s) if expected == (1, 1) => s.clone(),
                            Value::Matrix(m) if m.shape() == expected => m[(r, c)].clone(),
                            Value::Scalar(s) if self.field.is_zero(s) => s.clone(),
                            Value::Scalar(_) | Value::Matrix(_) => {
                                return Err(misfit(
                                    *at,
                                    format!("{}x{}", expected.0, expected.1),
                                    value.shape_text(),
                                ));
                            }
                        });
                    }
                }
                entries.push(line);
            }
        }
        Matrix::from_rows(entries)
            .map(Value::from_matrix)
            .ok_or_else(|| misfit(span, "rows".into(), "empty".into()))
    }
}

/// `H_{0,1}`, for messages.
fn element_name(key: &str, indices: &[i64]) -> String {
    let indices: Vec<String> = indices.iter().map(ToString::to_string).collect();
    format!("{key}_{{{}}}", indices.join(","))
}
