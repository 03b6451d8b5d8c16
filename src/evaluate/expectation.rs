//! The expectation `E{...}` of expressions of degree two in zero-mean random quantities.
//!
//! What is random, the notation says: `P = { covariance_of = "x" }` makes the entries of x random
//! with mean zero and P their covariance, whatever else determines P. The entries are linear forms
//! in processes (an acceleration is one by the equation of motion). The expectation is linear:
//! a constant is its own, a term of degree one has none, and the quadratic terms are written as
//! a combination of products of two such entries, by comparing coefficients, each of which has its
//! covariance. What cannot be written so is outside of what is decided; nothing is assumed. Above all a
//! function of a random quantity is neither a constant nor a polynomial, whatever stands beside it.

use super::{Evaluator, Failure, Value};
use crate::domain::Domain;
use crate::expr::Expr;
use crate::matrix::Matrix;
use crate::model::Letter;
use crate::span::Span;
use crate::theory::linear::{self, Solution};
use ratpoly::RationalFunction;
use std::collections::{BTreeMap, BTreeSet};

/// A product of two processes, by their letters in increasing order.
type Pair = (usize, usize);

/// A random quantity as a linear form: processes with their coefficients.
type Form<E> = Vec<(usize, E)>;

/// An entry of a covariance: which of the notation's covariances, row and column.
type Source = (usize, usize, usize);

/// The product of two random quantities, and where its covariance stands.
struct Moment<E> {
    /// The coefficient of each product of two processes.
    product: BTreeMap<Pair, E>,
    /// The covariances that say the same.
    sources: Vec<Source>,
}

/// An expectation before the covariances have values.
#[derive(Clone, PartialEq)]
struct Combination<E> {
    constant: E,
    /// Multiples of covariances, each with all the entries that state it.
    terms: Vec<(E, Vec<Source>)>,
}

impl<D: Domain> Evaluator<'_, D> {
    /// The expectation of an expression.
    pub(super) fn expectation(
        &mut self,
        body: &Expr,
        span: Span,
    ) -> Result<Value<D::Element>, Failure> {
        let combinations = if self.field.has_letters() {
            self.combinations(body, span)?
        } else {
            // What is random is known by its letters; only the covariances are taken here.
            let model = self.model;
            let world = self.world.with_letters(super::letters_themselves(model));
            let mut symbolic = world.evaluator(model.field());
            let combinations =
                symbolic.with_indices(&self.frame.bound, |e| e.combinations(body, span))?;
            combinations.try_map(|combination| self.image(combination, span))?
        };
        let mut covariances = Vec::new();
        for (_, node, _) in self.model.covariances() {
            covariances.push(self.value_of((node, Vec::new(), 0), span)?);
        }
        combinations.try_map(|combination| {
            let mut sum = combination.constant.clone();
            for (factor, sources) in &combination.terms {
                let mut values = Vec::new();
                for (which, i, j) in sources {
                    values.push(self.covariance_entry(&covariances[*which], *i, *j, span)?);
                }
                if values.windows(2).any(|pair| pair[0] != pair[1]) {
                    let what = "a product with two different covariances";
                    return Err(Failure::unsupported(what, span));
                }
                if let Some(value) = values.first() {
                    let term = self.field.multiply(factor, value);
                    sum = self.field.add(&sum, &term);
                }
            }
            Ok(sum)
        })
    }

    fn covariance_entry(
        &self,
        covariance: &Value<D::Element>,
        i: usize,
        j: usize,
        span: Span,
    ) -> Result<D::Element, Failure> {
        match covariance {
            Value::Scalar(s) if (i, j) == (0, 0) => Ok(s.clone()),
            Value::Matrix(m) if i < m.rows() && j < m.columns() => Ok(m[(i, j)].clone()),
            Value::Zero => Ok(self.field.integer(0)),
            Value::Scalar(_) | Value::Matrix(_) => Err(Failure::unsupported(
                "a covariance of another shape than its vectors have",
                span,
            )),
        }
    }

    /// A combination with its coefficients in this field.
    fn image(
        &self,
        combination: &Combination<RationalFunction>,
        span: Span,
    ) -> Result<Combination<D::Element>, Failure> {
        let image = |f: &RationalFunction| {
            self.field.image(f, self.world.letters()).ok_or_else(|| {
                Failure::unsupported("an expectation with a coefficient that has no value", span)
            })
        };
        let terms = combination.terms.iter();
        Ok(Combination {
            constant: image(&combination.constant)?,
            terms: terms
                .map(|(factor, sources)| Ok((image(factor)?, sources.clone())))
                .collect::<Result<_, Failure>>()?,
        })
    }

    /// Each entry of an expression as a combination of covariances.
    fn combinations(
        &mut self,
        body: &Expr,
        span: Span,
    ) -> Result<Value<Combination<D::Element>>, Failure> {
        let value = self.expression(body)?;
        let vectors = self.random_vectors(span)?;
        let random: BTreeSet<usize> = vectors
            .iter()
            .flat_map(|[left, right]| left.iter().chain(right))
            .flat_map(|entry| self.field.letters(entry))
            .filter(|letter| self.is_process(*letter))
            .collect();
        let moments = self.moments(&vectors, &random, span)?;
        value.try_map(|entry| self.combination(entry, &random, &moments, span))
    }

    fn is_process(&self, letter: usize) -> bool {
        match self.model.letters[letter] {
            Letter::Symbol { symbol, .. } => self.model.symbols[symbol].function_of.is_some(),
            Letter::Abbreviation { .. } | Letter::Function { .. } => false,
        }
    }

    /// Whether any process stands in an element, alone or in the argument of a function.
    fn holds_process(&self, element: &D::Element) -> bool {
        let letters = self.field.letters_behind(element);
        letters.iter().any(|letter| self.is_process(*letter))
    }

    /// Whether an element has a function of a process.
    fn holds_function_of_process(&self, element: &D::Element) -> bool {
        let plain = self.field.letters(element);
        let mut behind = self.field.letters_behind(element).into_iter();
        let functions = plain
            .iter()
            .any(|l| matches!(self.model.letters[*l], Letter::Function { .. }));
        // A letter of a function that occurs, and a process behind it.
        functions
            && (behind.any(|l| self.is_process(l) && !plain.contains(&l))
                || plain.iter().any(|l| {
                    let steps = self.field.functions().and_then(|f| f.chain(*l));
                    match steps {
                        None => false,
                        Some(Err(_)) => true,
                        Some(Ok(steps)) => steps.iter().any(|(_, inner)| self.holds_process(inner)),
                    }
                }))
    }

    /// The random vectors of the notation, in pairs.
    fn random_vectors(&mut self, span: Span) -> Result<Vec<[Vec<D::Element>; 2]>, Failure> {
        let model = self.model;
        let mut found = Vec::new();
        for (_, _, covariance) in model.covariances() {
            let mut vector = |expr: &Expr| -> Result<Vec<D::Element>, Failure> {
                let value = self.expression(expr)?;
                match value.shape() {
                    Some((_, 1)) => Ok(value.entries().into_iter().cloned().collect()),
                    _ => Err(Failure::unsupported(
                        "a random vector that is no column",
                        span,
                    )),
                }
            };
            found.push([vector(&covariance.left)?, vector(&covariance.right)?]);
        }
        Ok(found)
    }

    /// The products of two random quantities that have a covariance, each once.
    fn moments(
        &self,
        vectors: &[[Vec<D::Element>; 2]],
        random: &BTreeSet<usize>,
        span: Span,
    ) -> Result<Vec<Moment<D::Element>>, Failure> {
        let mut moments: Vec<Moment<D::Element>> = Vec::new();
        let forms = |entries: &[D::Element]| -> Result<Vec<Form<D::Element>>, Failure> {
            let form = |entry| self.linear_form(entry, random, span);
            entries.iter().map(form).collect()
        };
        for (which, [left, right]) in vectors.iter().enumerate() {
            let (rows, columns) = (forms(left)?, forms(right)?);
            for (i, row) in rows.iter().enumerate() {
                for (j, column) in columns.iter().enumerate() {
                    let product = self.product_of_forms(row, column);
                    let source = (which, i, j);
                    match moments.iter_mut().find(|m| m.product == product) {
                        Some(known) => known.sources.push(source),
                        None => moments.push(Moment {
                            product,
                            sources: vec![source],
                        }),
                    }
                }
            }
        }
        // A product that vanishes says nothing.
        moments.retain(|m| !m.product.is_empty());
        Ok(moments)
    }

    /// The coefficients of a random quantity in the processes.
    fn linear_form(
        &self,
        entry: &D::Element,
        random: &BTreeSet<usize>,
        span: Span,
    ) -> Result<Form<D::Element>, Failure> {
        let outside = || Failure::unsupported("a random quantity that is not linear", span);
        let terms = self
            .field
            .polynomial_in(entry, random)
            .ok_or_else(outside)?;
        terms
            .into_iter()
            .map(|(letters, coefficient)| match letters[..] {
                [letter] if !self.holds_process(&coefficient) => Ok((letter, coefficient)),
                _ => Err(outside()),
            })
            .collect()
    }

    fn product_of_forms(
        &self,
        left: &[(usize, D::Element)],
        right: &[(usize, D::Element)],
    ) -> BTreeMap<Pair, D::Element> {
        let mut product: BTreeMap<Pair, D::Element> = BTreeMap::new();
        for (i, a) in left {
            for (j, b) in right {
                let place = (*i.min(j), *i.max(j));
                let term = self.field.multiply(a, b);
                let sum = match product.get(&place) {
                    Some(known) => self.field.add(known, &term),
                    None => term,
                };
                product.insert(place, sum);
            }
        }
        product.retain(|_, coefficient| !self.field.is_zero(coefficient));
        product
    }

    /// A scalar's expectation as a combination of covariances.
    fn combination(
        &self,
        entry: &D::Element,
        random: &BTreeSet<usize>,
        moments: &[Moment<D::Element>],
        span: Span,
    ) -> Result<Combination<D::Element>, Failure> {
        let outside = |what: &str| Failure::unsupported(what, span);
        if self.holds_function_of_process(entry) {
            return Err(outside(
                "the expectation of a function of random quantities",
            ));
        }
        let terms = self
            .field
            .polynomial_in(entry, random)
            .ok_or_else(|| outside("the expectation of something that is no polynomial"))?;
        let mut constant = self.field.integer(0);
        let mut quadratic: BTreeMap<Pair, D::Element> = BTreeMap::new();
        for (letters, coefficient) in terms {
            if self.holds_process(&coefficient) {
                return Err(outside(
                    "the expectation of a process that no covariance names",
                ));
            }
            match letters[..] {
                [] => constant = self.field.add(&constant, &coefficient),
                // The means are zero.
                [_] => {}
                [i, j] => {
                    quadratic.insert((i, j), coefficient);
                }
                _ => return Err(outside("the expectation of a product of three")),
            }
        }
        if quadratic.is_empty() {
            let terms = Vec::new();
            return Ok(Combination { constant, terms });
        }
        if moments.is_empty() {
            return Err(outside("an expectation without any covariance"));
        }
        let places: BTreeSet<Pair> = moments
            .iter()
            .flat_map(|m| m.product.keys())
            .chain(quadratic.keys())
            .copied()
            .collect();
        let places: Vec<Pair> = places.into_iter().collect();
        let at = |product: &BTreeMap<Pair, D::Element>, place: &Pair| {
            let coefficient = product.get(place).cloned();
            coefficient.unwrap_or_else(|| self.field.integer(0))
        };
        let matrix = Matrix::from_fn(places.len(), moments.len(), |i, j| {
            at(&moments[j].product, &places[i])
        });
        let right = places.iter().map(|place| at(&quadratic, place)).collect();
        match linear::solve(&self.field, matrix, right) {
            Solution::Unique { values, .. } => Ok(Combination {
                constant,
                terms: values
                    .into_iter()
                    .zip(moments)
                    .filter(|(value, _)| !self.field.is_zero(value))
                    .map(|(value, moment)| (value, moment.sources.clone()))
                    .collect(),
            }),
            Solution::Inconsistent => Err(outside(
                "the expectation of a product that no covariance covers",
            )),
            Solution::TooLarge => Err(outside("an expectation with so many terms")),
            Solution::Underdetermined => Err(outside(
                "an expectation by covariances of quantities that depend on each other",
            )),
        }
    }
}
