//! `E{...}` of what has degree two at most in random quantities with mean zero.
//!
//! What is random the covariances of the notation say: the entries of their vectors, linear forms in the
//! letters of processes. That an expression has degree two at most is seen from how it is put
//! together; its coefficients are read off along the axes and the diagonals between them. Then it is
//! what it is where the letters vanish, plus a combination of products of two entries, which is found by
//! elimination, and each of which has its covariance. An expectation of what is no such combination is
//! not known.

use super::degrees::Degrees;
use super::evaluator::{Evaluator, Result};
use super::failure::Reason;
use super::jet::Jet;
use super::letters::{Layer, LayerKind};
use super::value::Value;
use crate::expr::Expr;
use crate::matrix::Matrix;
use crate::model::Node;
use crate::span::Span;
use std::collections::{BTreeMap, BTreeSet};

/// A symbol or its derivative of an order.
type Letter = (usize, u8);

/// The most letters of processes that an expectation is computed for.
const MOST_LETTERS: usize = 24;

/// A linear form: a coefficient for each letter.
type Form = Vec<Jet>;

/// The product of two random quantities: a coefficient for each pair of letters, and where its
/// covariance stands.
struct Moment {
    product: Vec<Jet>,
    node: Node,
    row: usize,
    column: usize,
    /// The numbers of entries of the two vectors, and whether these are one.
    shape: (usize, usize),
    itself: bool,
}

/// What an expression is in the letters: its value where they vanish, its linear coefficients, and those
/// of the products of pairs.
struct Quadratic {
    constant: Value,
    linear: Vec<Value>,
    pairs: Vec<Value>,
}

impl Evaluator<'_, '_> {
    /// An expectation; one inside of another knows nothing of what the outer one varies.
    pub(super) fn expectation(&mut self, body: &Expr, span: Span) -> Result<Value> {
        let outer = self.expected_above;
        let depth = outer.unwrap_or(self.layers.len());
        let varies = |layer: &Layer| matches!(layer.kind, LayerKind::Given(_));
        if !self.layers[depth..].iter().all(varies) {
            let what = "an expectation of what another one varies";
            return Err(Reason::Unsupported(what).at(span));
        }
        self.below(depth, |evaluator| {
            evaluator.expected_above = Some(depth);
            let found = evaluator.expectation_alone(body, span);
            evaluator.expected_above = outer;
            found
        })
    }

    fn expectation_alone(&mut self, body: &Expr, span: Span) -> Result<Value> {
        let world = self.world;
        let degree = Degrees::new(world).of(body);
        if degree.is_none_or(|degree| degree > 2) {
            let what = "an expectation of another degree than two";
            return Err(Reason::Unsupported(what).at(span));
        }
        let covariances: Vec<_> = world.model().covariances().collect();
        let mut letters = self.processes_in(body)?;
        for (_, _, covariance) in &covariances {
            letters.extend(self.processes_in(&covariance.left)?);
            letters.extend(self.processes_in(&covariance.right)?);
        }
        let letters: Vec<Letter> = letters.into_iter().collect();
        if letters.len() > MOST_LETTERS {
            return Err(Reason::Budget("random quantities").at(span));
        }
        let mut random: Vec<Form> = Vec::new();
        let mut moments: Vec<Moment> = Vec::new();
        for (_, node, covariance) in covariances {
            let left = self.forms(&covariance.left, &letters)?;
            let right = self.forms(&covariance.right, &letters)?;
            // A letter that is random and a function of nothing is no constant, and none of these letters.
            let (Some(left), Some(right)) = (left, right) else {
                let what = "an expectation beside a random quantity that is not linear";
                return Err(Reason::Unsupported(what).at(span));
            };
            for (row, a) in left.iter().enumerate() {
                for (column, b) in right.iter().enumerate() {
                    let product = self.product_of(a, b).map_err(|r| r.at(span))?;
                    if !moments.iter().any(|m| m.product == product) {
                        moments.push(Moment {
                            product,
                            node,
                            row,
                            column,
                            shape: (left.len(), right.len()),
                            itself: covariance.left == covariance.right,
                        });
                    }
                }
            }
            random.extend(left);
            random.extend(right);
        }
        let quadratic = self.quadratic(body, &letters, span)?;
        // A term of degree one has mean zero if its letter is random itself.
        let is_random = |k: usize| {
            let own = |form: &Form| {
                let mut entries = form.iter().enumerate();
                entries.all(|(l, x)| {
                    if l == k {
                        *x == Jet::integer(1)
                    } else {
                        x.is_zero()
                    }
                })
            };
            random.iter().any(own)
        };
        let vanishes = |v: &Value| v.entries().iter().all(|x| x.is_zero());
        let mut linear = quadratic.linear.iter().enumerate();
        if !linear.all(|(k, v)| vanishes(v) || is_random(k)) {
            let what = "an expectation of what is not known to be random";
            return Err(Reason::Unsupported(what).at(span));
        }
        self.combined(&quadratic, &moments, span)
    }

    /// The constant, and the covariances times the coefficients of their products.
    fn combined(&mut self, quadratic: &Quadratic, moments: &[Moment], span: Span) -> Result<Value> {
        let mut covariances = Vec::with_capacity(moments.len());
        let vanishes = |v: &Value| v.entries().iter().all(|x| x.is_zero());
        if quadratic.pairs.iter().all(vanishes) {
            return Ok(quadratic.constant.clone());
        }
        for moment in moments {
            let value = self.node((moment.node, Vec::new()), span)?;
            covariances.push(match &value {
                Value::Scalar(x) if moment.shape == (1, 1) => x.clone(),
                Value::Matrix(m) if (m.rows(), m.columns()) == moment.shape => {
                    let (i, j) = (moment.row, moment.column);
                    // That of a vector with itself is square.
                    if moment.itself && m[(i, j)].number().is_apart_from(m[(j, i)].number()) {
                        let what = "a covariance that is not symmetric";
                        return Err(Reason::Unsupported(what).at(span));
                    }
                    m[(i, j)].clone()
                }
                Value::Zero => Jet::zero(),
                Value::Scalar(_) | Value::Matrix(_) => {
                    return Err(Reason::Unsupported("a covariance of another shape").at(span));
                }
            });
        }
        // One right side for each entry of the value.
        let entries = quadratic.constant.entries().len();
        let rows = quadratic.pairs.len();
        if moments.is_empty() || rows < moments.len() || entries == 0 {
            let what = "an expectation of what is not known to be random";
            return Err(Reason::Unsupported(what).at(span));
        }
        let matrix = Matrix::from_fn(rows, moments.len(), |i, k| moments[k].product[i].clone());
        let right = Matrix::from_fn(rows, entries, |i, e| {
            let value = quadratic.pairs[i].entries();
            value.get(e).map_or_else(Jet::zero, |x| (*x).clone())
        });
        let a = &self.arithmetic;
        let factors = a.solve(&matrix, &right).map_err(|reason| {
            // No combination, or not only one: then it is not known.
            if let Reason::Undefined(_) = reason {
                let what = "an expectation of what is not known to be random";
                return Reason::Unsupported(what).at(span);
            }
            reason.at(span)
        })?;
        let mut next = 0;
        quadratic
            .constant
            .map(|constant| {
                let mut sum = constant.clone();
                for (k, covariance) in covariances.iter().enumerate() {
                    let term = a.multiply(&factors[(k, next)], covariance)?;
                    sum = a.add(&sum, &term);
                }
                next += 1;
                Ok(sum)
            })
            .map_err(|r: Reason| r.at(span))
    }

    /// The letters of processes that an expression is computed from.
    fn processes_in(&mut self, expr: &Expr) -> Result<BTreeSet<Letter>> {
        // What is known already would not be used again.
        let known = std::mem::take(&mut self.known);
        let layers = self.layers.iter_mut();
        let of_layers: Vec<_> = layers.map(|l| std::mem::take(&mut l.known)).collect();
        let before = std::mem::take(&mut self.used);
        let value = self.expression(expr);
        let used = std::mem::replace(&mut self.used, before);
        self.known = known;
        for (layer, known) in self.layers.iter_mut().zip(of_layers) {
            layer.known = known;
        }
        value?;
        let model = self.world.model();
        let process = |l: &&Letter| model.symbols[l.0].function_of.is_some();
        let found = used.keys().filter(process).copied().collect();
        self.used.extend(used);
        Ok(found)
    }

    /// The entries of a column as linear forms; none where they are not.
    fn forms(&mut self, vector: &Expr, letters: &[Letter]) -> Result<Option<Vec<Form>>> {
        let variable = self.arithmetic.open(0);
        let given = letters.iter().enumerate().map(|(k, letter)| {
            let slopes = BTreeMap::from([(k, Jet::integer(1))]);
            (*letter, Jet::form(variable, Jet::zero(), slopes))
        });
        let layer = LayerKind::Given(given.collect());
        let value = self.with_layer(layer, |e| e.expression(vector));
        self.arithmetic.close();
        let value = match value {
            Ok(value) => value,
            Err(none) if none.reason == Reason::NotLinear => return Ok(None),
            Err(none) => return Err(none),
        };
        if value.shape().is_none_or(|(_, columns)| columns != 1) {
            return Ok(None);
        }
        let mut forms = Vec::new();
        for entry in value.entries() {
            let (constant, slopes) = entry.parts(variable);
            if !constant.is_zero() {
                return Ok(None);
            }
            let slope = |k: usize| slopes.get(&k).cloned().unwrap_or_else(Jet::zero);
            forms.push((0..letters.len()).map(slope).collect());
        }
        Ok(Some(forms))
    }

    /// The coefficients of a product of two forms, pair by pair.
    fn product_of(&self, a: &Form, b: &Form) -> std::result::Result<Vec<Jet>, Reason> {
        let arithmetic = &self.arithmetic;
        pairs(a.len())
            .map(|(i, j)| {
                let one = arithmetic.multiply(&a[i], &b[j])?;
                if i == j {
                    return Ok(one);
                }
                Ok(arithmetic.add(&one, &arithmetic.multiply(&a[j], &b[i])?))
            })
            .collect()
    }

    fn quadratic(&mut self, body: &Expr, letters: &[Letter], span: Span) -> Result<Quadratic> {
        let mut constant = None;
        let mut linear = Vec::new();
        let mut squares: Vec<Value> = Vec::new();
        let mut found = Vec::new();
        for i in 0..letters.len() {
            let [zero, one, two] = self.along(body, letters, &[i], span)?;
            constant.get_or_insert(zero);
            linear.push(one);
            squares.push(two);
        }
        for (i, j) in pairs(letters.len()) {
            if i == j {
                found.push(squares[i].clone());
                continue;
            }
            // Of (r_i + r_j): the square of each is in it.
            let [_, _, two] = self.along(body, letters, &[i, j], span)?;
            let both = self.arithmetic.sum(&squares[i], &squares[j]);
            let rest = both.and_then(|both| self.arithmetic.sum(&two, &both.negated()));
            found.push(rest.map_err(|r| r.at(span))?);
        }
        Ok(Quadratic {
            constant: match constant {
                Some(constant) => constant,
                None => self.expression(body)?,
            },
            linear,
            pairs: found,
        })
    }

    /// The coefficients of e^0, e^1 and e^2 where the letters with these numbers are e and the others
    /// vanish.
    fn along(
        &mut self,
        body: &Expr,
        letters: &[Letter],
        numbers: &[usize],
        span: Span,
    ) -> Result<[Value; 3]> {
        let variable = self.arithmetic.open(2);
        let given = letters.iter().enumerate().map(|(k, letter)| {
            let value = if numbers.contains(&k) {
                Jet::series(variable, vec![Jet::zero(), Jet::integer(1)])
            } else {
                Jet::zero()
            };
            (*letter, value)
        });
        let layer = LayerKind::Given(given.collect());
        let value = self.with_layer(layer, |e| e.expression(body));
        self.arithmetic.close();
        let value = value?;
        let coefficient = |k: usize| {
            let taken = value.map(|x| Ok::<_, Reason>(x.coefficient(variable, k)));
            taken.map_err(|r| r.at(span))
        };
        Ok([coefficient(0)?, coefficient(1)?, coefficient(2)?])
    }
}

/// The pairs of numbers below n, the smaller one first.
fn pairs(n: usize) -> impl Iterator<Item = (usize, usize)> {
    (0..n).flat_map(move |i| (i..n).map(move |j| (i, j)))
}
