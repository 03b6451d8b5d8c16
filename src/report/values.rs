//! The quantities of a document by name: what the report prints as formulas and the reference
//! vectors give as numbers.

use crate::audit::Audit;
use crate::check;
use crate::domain::Symbolic;
use crate::evaluate::{Evaluator, Key, Value};
use crate::expr::{Name, Subscript};
use crate::latex;
use crate::matrix::Matrix;
use crate::model::{DefinitionKind, Letter, Model, Node, NotationKind};
use crate::span::Span;
use crate::theory::determinant::{cofactor, determinant};
use num_rational::BigRational;
use num_traits::Zero;
use ratpoly::RationalFunction;
use std::collections::BTreeSet;

/// Largest order whose cofactors are listed.
const LARGEST_ORDER: usize = 8;

/// What a quantity is in its document.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// A letter that stands for an expression in the declared symbols.
    Abbreviation,
    /// Any other defined name.
    Definition,
    /// What a `solve` block determines.
    Solution,
    /// A coefficient of a characteristic polynomial.
    CharacteristicCoefficient,
    /// The Hurwitz matrix of a characteristic polynomial.
    HurwitzMatrix,
    /// Its determinant.
    Determinant,
    /// A leading principal minor.
    LeadingMinor,
    /// The matrix of cofactors.
    Cofactors,
}

impl Kind {
    /// The words for it.
    pub fn as_str(self) -> &'static str {
        match self {
            Kind::Abbreviation => "abbreviation",
            Kind::Definition => "definition",
            Kind::Solution => "solution",
            Kind::CharacteristicCoefficient => "characteristic coefficient",
            Kind::HurwitzMatrix => "Hurwitz matrix",
            Kind::Determinant => "determinant",
            Kind::LeadingMinor => "leading principal minor",
            Kind::Cofactors => "cofactors",
        }
    }
}

/// A quantity with its exact value.
#[derive(Clone, Debug)]
pub struct Quantity {
    /// Its name in LaTeX.
    pub name: String,
    /// What it is.
    pub kind: Kind,
    /// Its value in the letters of the document; abbreviations stay letters.
    pub value: Value<RationalFunction>,
}

/// The exact values of a document's quantities, computed from the equations as corrected.
pub struct Quantities<'m> {
    model: &'m Model,
    /// The quantities without process letters, in the order of the document.
    pub list: Vec<Quantity>,
    /// The names of those with functions in them, whose values need not be rational.
    pub with_functions: Vec<String>,
    /// The values of the abbreviations in the declared symbols, by letter.
    pub inserted: Vec<(usize, RationalFunction)>,
}

impl<'m> Quantities<'m> {
    /// Computes them.
    pub fn of(audit: &'m Audit) -> Self {
        let model = &audit.model;
        let mut exact = check::corrected(&audit.model, &audit.outcomes);
        let inserted = exact.abbreviations();
        let mut quantities = Quantities {
            model,
            list: Vec::new(),
            with_functions: Vec::new(),
            inserted,
        };
        quantities.definitions(&mut exact);
        quantities.notations(&mut exact);
        quantities.solutions(&mut exact);
        quantities
    }

    fn push(&mut self, name: String, kind: Kind, value: Value<RationalFunction>) {
        let entries = value.entries();
        if !entries.iter().all(|e| self.is_constant(e)) {
            return;
        }
        let functions = entries.iter().any(|e| self.has_functions(e));
        if functions && !self.with_functions.contains(&name) {
            self.with_functions.push(name);
        } else if !functions && !self.list.iter().any(|q| q.name == name) {
            self.list.push(Quantity { name, kind, value });
        }
    }

    fn has_functions(&self, f: &RationalFunction) -> bool {
        let function = |l: &usize| matches!(self.model.letters[*l], Letter::Function { .. });
        occurring(f).iter().any(function)
    }

    /// Whether no process occurs: only such quantities have values at a point.
    fn is_constant(&self, f: &RationalFunction) -> bool {
        let letters = match &self.model.functions {
            Some(table) => table.letters_behind(f),
            None => occurring(f),
        };
        letters.into_iter().all(|l| match self.model.letters[l] {
            Letter::Symbol { symbol, order } => {
                order == 0 && self.model.symbols[symbol].function_of.is_none()
            }
            Letter::Abbreviation { .. } | Letter::Function { .. } => true,
        })
    }

    fn definitions(&mut self, exact: &mut Evaluator<'_, Symbolic>) {
        for (index, definition) in self.model.definitions.iter().enumerate() {
            let mut name = latex::canonical(&definition.name);
            let kind = match (&definition.kind, definition.letter) {
                (_, Some(letter)) => {
                    let value = self.inserted.iter().find(|(l, _)| *l == letter);
                    if let Some((_, value)) = value.cloned() {
                        self.push(name, Kind::Abbreviation, Value::Scalar(value));
                    }
                    continue;
                }
                (DefinitionKind::Whole, None) => Kind::Definition,
                (DefinitionKind::Power(n), None) => {
                    name = format!("{name}^{n}");
                    Kind::Definition
                }
                (
                    DefinitionKind::Element(_)
                    | DefinitionKind::Family { .. }
                    | DefinitionKind::ValueAt(_),
                    None,
                ) => continue,
            };
            let key = (Node::Definition(index), Vec::new(), 0);
            if let Some(value) = value(exact, key) {
                self.push(name, kind, value);
            }
        }
    }

    fn notations(&mut self, exact: &mut Evaluator<'_, Symbolic>) {
        let field = self.model.field();
        for (index, notation) in self.model.notation.iter().enumerate() {
            let node = Node::Notation(index);
            let order = match notation.kind.target().map(|t| exact.expression(t)) {
                Some(Ok(Value::Matrix(m))) if m.is_square() => m.rows(),
                _ => continue,
            };
            if order > LARGEST_ORDER {
                continue;
            }
            let orders = 1..=i64::try_from(order).unwrap_or(0);
            match &notation.kind {
                NotationKind::CharacteristicCoefficient(_) => {
                    for k in orders {
                        if let Some(value) = value(exact, (node, vec![k], 0)) {
                            let name = indexed(&notation.name, &k.to_string());
                            self.push(name, Kind::CharacteristicCoefficient, value);
                        }
                    }
                }
                NotationKind::LeadingMinor(_) => {
                    for k in orders {
                        if let Some(value) = value(exact, (node, vec![k], 0)) {
                            let name = indexed(&notation.name, &k.to_string());
                            self.push(name, Kind::LeadingMinor, value);
                        }
                    }
                }
                NotationKind::HurwitzMatrix(_) => {
                    let name = latex::canonical(&notation.name);
                    if let Some(Value::Matrix(m)) = value(exact, (node, Vec::new(), 0)) {
                        if let Some(det) = determinant(&field, &m) {
                            let det_name = format!("\\det {name}");
                            self.push(det_name, Kind::Determinant, Value::Scalar(det));
                        }
                        self.push(name, Kind::HurwitzMatrix, Value::Matrix(m));
                    }
                }
                NotationKind::Cofactor(target) => {
                    let Ok(Value::Matrix(m)) = exact.expression(target) else {
                        continue;
                    };
                    let entries = Matrix::try_from_fn(order, order, |i, j| {
                        cofactor(&field, &m, i, j).ok_or(())
                    });
                    if let Ok(entries) = entries {
                        let name = latex::canonical(&notation.name);
                        self.push(name, Kind::Cofactors, Value::Matrix(entries));
                    }
                }
                _ => {}
            }
        }
    }

    fn solutions(&mut self, exact: &mut Evaluator<'_, Symbolic>) {
        for (system, block) in self.model.systems.iter().enumerate() {
            for (position, unknown) in block.unknowns.iter().enumerate() {
                let key = (Node::Unknown { system, position }, Vec::new(), 0);
                if let Some(value) = value(exact, key) {
                    self.push(latex::canonical(unknown), Kind::Solution, value);
                }
            }
        }
    }

    /// A quantity with all abbreviations replaced by what they stand for.
    pub fn expanded(&self, value: &Value<RationalFunction>) -> Option<Value<RationalFunction>> {
        value.try_map(|e| e.substitute(&self.inserted)).ok()
    }

    /// The value of each letter at a point of the declared symbols; the letters that have no value
    /// there, and only those, are `None`.
    pub fn point(&self, symbol: impl Fn(usize) -> Option<BigRational>) -> Vec<Option<BigRational>> {
        let mut point: Vec<Option<BigRational>> = self
            .model
            .letters
            .iter()
            .map(|letter| match letter {
                Letter::Symbol {
                    symbol: s,
                    order: 0,
                } => symbol(*s),
                _ => None,
            })
            .collect();
        for (letter, value) in &self.inserted {
            point[*letter] = self.at(value, &point);
        }
        point
    }

    /// Whether each declared letter behind a rational function has a value at a point, so that where it has none itself
    /// it divides by zero.
    pub fn has_values(&self, f: &RationalFunction, point: &[Option<BigRational>]) -> bool {
        occurring(f).into_iter().all(|letter| {
            let mut inserted = self.inserted.iter().filter(|(l, _)| *l == letter);
            match inserted.next() {
                Some((_, value)) => occurring(value).into_iter().all(|l| point[l].is_some()),
                None => point[letter].is_some(),
            }
        })
    }

    /// A rational function at a point; none where a letter of it has no value or it has a pole.
    pub fn at(&self, f: &RationalFunction, point: &[Option<BigRational>]) -> Option<BigRational> {
        let known = occurring(f).into_iter().all(|l| point[l].is_some());
        let point: Vec<BigRational> = point
            .iter()
            .map(|v| v.clone().unwrap_or_else(BigRational::zero))
            .collect();
        known.then(|| f.evaluate(&point).ok()).flatten()
    }
}

/// The letters in a rational function.
fn occurring(f: &RationalFunction) -> BTreeSet<usize> {
    let parts = [f.numerator(), f.denominator()];
    let letters = parts.iter().flat_map(|p| p.variables_occurring());
    letters.collect()
}

fn value(exact: &mut Evaluator<'_, Symbolic>, key: Key) -> Option<Value<RationalFunction>> {
    // A formula of one case would pass for that of all.
    let (value, cases) = exact.in_case(0, |exact| exact.value_of(key, Span::default()));
    if cases > 1 {
        return None;
    }
    match value {
        Ok(Value::Zero) | Err(_) => None,
        Ok(value) => Some(value),
    }
}

/// The pattern `a_i` with a number for its index.
fn indexed(pattern: &Name, label: &str) -> String {
    latex::canonical(&Name {
        subscript: Some(Subscript {
            indices: Vec::new(),
            label: label.into(),
        }),
        ..pattern.clone()
    })
}
