//! Exact values at the doubles of a point.
//!
//! Each polynomial of a document is evaluated once at a point, however many entries it is part of.

use crate::domain::Symbolic;
use crate::evaluate;
use crate::expr::Expr;
use crate::model::{Letter, Model};
use crate::numeric::point::Point;
use num_rational::BigRational;
use num_traits::Zero;
use ratpoly::{Polynomial, RationalFunction, quotient};
use std::collections::BTreeMap;

pub(super) type Exact = evaluate::Value<RationalFunction>;

/// The exact value of an expression, if it has one and holds no process.
pub(super) fn number(exact: &mut evaluate::Evaluator<'_, Symbolic>, expr: &Expr) -> Option<Exact> {
    let model = exact.model();
    let value = exact.expression_without_cases(expr).ok()?;
    let valued = value.entries().iter().all(|f| {
        let parts = [f.numerator(), f.denominator()];
        parts
            .iter()
            .flat_map(|p| p.variables_occurring())
            .all(|l| match &model.letters[l] {
                Letter::Symbol { symbol, order: 0 } => model.symbols[*symbol].value.is_some(),
                Letter::Symbol { .. } => false,
                Letter::Abbreviation { .. } => true,
                // Its value is enclosed; whether it has one, is seen at the point.
                Letter::Function { .. } => model.functions.as_ref().is_some_and(|table| {
                    let behind = table.letters_behind(&RationalFunction::variable(model.ring, l));
                    behind.iter().all(|b| match &model.letters[*b] {
                        Letter::Symbol { symbol, order: 0 } => {
                            model.symbols[*symbol].value.is_some()
                        }
                        Letter::Symbol { .. } => false,
                        Letter::Abbreviation { .. } | Letter::Function { .. } => true,
                    })
                }),
            })
    });
    valued.then_some(value)
}

/// A subject: what is evaluated in floating point, and its exact value.
pub(super) struct Prepared {
    pub expr: Expr,
    pub exact: evaluate::Value<Element>,
}

/// An entry of an exact value.
#[derive(Clone, PartialEq)]
pub(super) enum Element {
    /// A quotient of polynomials, by their places among those of the document: the entries of a
    /// covariance matrix have one denominator, and half of them are equal.
    Rational {
        numerator: usize,
        denominator: usize,
    },
    /// Functions occur.
    Function(RationalFunction),
}

impl Prepared {
    /// With the polynomials that its value is made of put among those of the document.
    pub fn new(
        model: &Model,
        expr: Expr,
        exact: &Exact,
        shared: &mut BTreeMap<Polynomial, usize>,
    ) -> Prepared {
        let mut place = |p: &Polynomial| {
            let next = shared.len();
            *shared.entry(p.clone()).or_insert(next)
        };
        let exact = exact.map(|f| {
            let mut letters = f.numerator().variables_occurring();
            letters.extend(f.denominator().variables_occurring());
            let function = |l: &usize| matches!(model.letters[*l], Letter::Function { .. });
            if letters.iter().any(function) {
                Element::Function(f.clone())
            } else {
                Element::Rational {
                    numerator: place(f.numerator()),
                    denominator: place(f.denominator()),
                }
            }
        });
        Prepared { expr, exact }
    }
}

/// The polynomials in the order of their places.
pub(super) fn in_order(shared: BTreeMap<Polynomial, usize>) -> Vec<Polynomial> {
    let mut placed: Vec<(usize, Polynomial)> = shared.into_iter().map(|(p, k)| (k, p)).collect();
    placed.sort_unstable_by_key(|(k, _)| *k);
    placed.into_iter().map(|(_, p)| p).collect()
}

/// The exact values at one point.
pub(super) struct AtPoint<'a> {
    model: &'a Model,
    point: Vec<BigRational>,
    polynomials: &'a [Polynomial],
    values: Vec<Option<BigRational>>,
}

impl<'a> AtPoint<'a> {
    pub fn new(model: &'a Model, point: Vec<BigRational>, polynomials: &'a [Polynomial]) -> Self {
        let values = vec![None; polynomials.len()];
        AtPoint {
            model,
            point,
            polynomials,
            values,
        }
    }

    /// The value of an entry, and whether it is exact or only enclosed.
    pub fn value(&mut self, element: &Element) -> Option<(BigRational, bool)> {
        match element {
            Element::Rational {
                numerator,
                denominator,
            } => {
                let (top, bottom) = (self.polynomial(*numerator)?, self.polynomial(*denominator)?);
                quotient(&top, &bottom).map(|value| (value, true))
            }
            Element::Function(f) => enclosed_at(self.model, f, &self.point).map(|v| (v, false)),
        }
    }

    fn polynomial(&mut self, k: usize) -> Option<BigRational> {
        if self.values[k].is_none() {
            self.values[k] = self.polynomials[k].evaluate(&self.point).ok();
        }
        self.values[k].clone()
    }
}

/// A value for each letter of the ring at a point.
pub(crate) fn exact_point(
    model: &Model,
    point: &Point<'_>,
    abbreviations: &[(usize, RationalFunction)],
) -> Vec<BigRational> {
    let values = point.exact();
    let letters = model.letters.iter().map(|letter| match letter {
        Letter::Symbol { symbol, order: 0 } => values[*symbol].clone().unwrap_or_default(),
        _ => BigRational::zero(),
    });
    let mut point: Vec<BigRational> = letters.collect();
    for (letter, value) in abbreviations {
        if let Ok(value) = value.evaluate(&point) {
            point[*letter] = value;
        }
    }
    point
}

/// The value of an element with functions, to more digits than any double has.
fn enclosed_at(model: &Model, f: &RationalFunction, point: &[BigRational]) -> Option<BigRational> {
    let table = model.functions.as_ref()?;
    let known: Vec<Option<BigRational>> = point
        .iter()
        .enumerate()
        .map(|(l, value)| match model.letters[l] {
            Letter::Function { .. } => None,
            _ => Some(value.clone()),
        })
        .collect();
    Some(table.enclosure(f, &known)?.middle())
}
