//! Inequalities: positive definite matrices, signs of scalars, and stable matrices.
//!
//! A symmetric matrix is positive definite if and only if its leading principal minors are positive
//! (Sylvester's criterion; Gantmacher, *The Theory of Matrices* I, 1959, ch. X). A matrix is stable
//! if and only if its Hurwitz determinants are positive (Hurwitz 1895). The signs are decided for
//! all values of the letters, those declared positive being positive.

use super::Checker;
use crate::domain::Symbolic;
use crate::evaluate::{Failure, Value};
use crate::expr::{Display, Expr, ExprKind, Function, Relation};
use crate::latex;
use crate::matrix::Matrix;
use crate::model::links::Link;
use crate::model::{Letter, Node};
use crate::theory::{characteristic, determinant, hurwitz};
use crate::verdict::certificate::{Ordered, Steps};
use crate::verdict::{
    Part, PointValue, PositiveBy, Positivity, Refutation, ResidualEntry, Verdict, Witness,
};
use num_rational::BigRational;
use num_traits::Zero;
use ratpoly::{Bound, Budget, RationalFunction, Region, RegionSign, sign_of_quotient_on};

/// What has to be positive, in the order in which it is asked, and what that shows.
struct Signs {
    positive: Vec<RationalFunction>,
    shows: Positivity,
}

impl Checker<'_> {
    /// The verdict on `left > right`, or with another relation of order.
    pub(super) fn inequality(
        &mut self,
        equation: usize,
        link: &Link,
        positivity: &mut Option<Positivity>,
    ) -> Verdict {
        let display = self.display(equation);
        let (Some(left), Some(right)) = (link.left.find(&display), link.right.find(&display))
        else {
            return undecided("a link without its sides");
        };
        let (upper, lower) = match link.relation {
            Relation::Greater | Relation::GreaterEqual => (left, right),
            Relation::Less | Relation::LessEqual => (right, left),
            _ => return undecided("only equations and inequalities are decided here"),
        };
        let strict = matches!(link.relation, Relation::Greater | Relation::Less);
        let signs = match self.signs_asked(upper, lower, strict) {
            Ok(Ok(signs)) => signs,
            Ok(Err(verdict)) => return verdict,
            Err(failure) => return self.failed(&failure),
        };
        *positivity = Some(signs.shows);
        for value in &signs.positive {
            match self.sign(value) {
                RegionSign::Positive => {}
                RegionSign::Zero | RegionSign::NonNegative if !strict => {}
                RegionSign::Undecided => {
                    *positivity = None;
                    return undecided("the sign of a determinant or expression is out of reach");
                }
                sign => {
                    *positivity = None;
                    let Some(mut refutation) = self.not_positive(value, &sign) else {
                        return undecided(
                            "it does not hold for all values by its signs, and no point was found \
                             that shows it false",
                        );
                    };
                    // One of several conditions says little of where all hold.
                    if signs.positive.len() > 1 {
                        refutation.part = None;
                    }
                    return Verdict::Refuted(refutation);
                }
            }
        }
        let ordered = Ordered {
            positive: signs.positive.iter().map(Into::into).collect(),
            strict,
            criterion: match &positivity.as_ref().map(|p| &p.by) {
                Some(PositiveBy::Declared(name)) => format!("a positive multiple of {name}"),
                Some(PositiveBy::Minors(_)) => "leading principal minors".into(),
                Some(PositiveBy::Hurwitz(_)) => "Hurwitz determinants".into(),
                Some(PositiveBy::Sign) | None => "its sign".into(),
            },
        };
        match self.verified(equation, link, Steps::Ordered(ordered)) {
            Some(proof) => Verdict::Holds {
                by: Vec::new(),
                proof,
            },
            None => super::link::unverified(),
        }
    }

    /// What a link with a relation of order asks to be positive, or not negative, in the declared
    /// symbols; none where that is not known.
    pub(crate) fn asked_positive(
        &mut self,
        display: &Display,
        link: &Link,
    ) -> Option<Vec<RationalFunction>> {
        let (left, right) = (link.left.find(display)?, link.right.find(display)?);
        let (upper, lower) = match link.relation {
            Relation::Greater | Relation::GreaterEqual => (left, right),
            Relation::Less | Relation::LessEqual => (right, left),
            _ => return None,
        };
        let strict = matches!(link.relation, Relation::Greater | Relation::Less);
        let signs = self.signs_asked(upper, lower, strict).ok()?.ok()?;
        let all = self.insertion(&self.inserted.keys().copied().collect::<Vec<_>>());
        let inserted = signs.positive.iter().map(|f| f.substitute(&all.letters));
        inserted.collect::<Result<_, _>>().ok()
    }

    /// What must be positive for `upper - lower` to be so; a verdict where that is clear already.
    fn signs_asked(
        &mut self,
        upper: &Expr,
        lower: &Expr,
        strict: bool,
    ) -> Result<Result<Signs, Verdict>, Failure> {
        let field = self.model.field();
        if let (Some(matrix), bound @ (Value::Zero | Value::Scalar(_)), true) =
            (stability(lower), self.exact.expression(upper)?, strict)
        {
            // Re λ(A) < c if and only if Re λ(A - cE) < 0.
            let value = self.exact.expression(matrix)?;
            let value = match (value, bound) {
                (Value::Matrix(m), Value::Scalar(c)) if m.is_square() => {
                    Value::Matrix(Matrix::from_fn(m.rows(), m.rows(), |i, j| {
                        if i == j {
                            &m[(i, j)] - &c
                        } else {
                            m[(i, j)].clone()
                        }
                    }))
                }
                (Value::Scalar(s), Value::Scalar(c)) => Value::Scalar(&s - &c),
                (value, _) => value,
            };
            let matrix = match value {
                Value::Matrix(m) if m.is_square() => m,
                Value::Scalar(s) => Matrix::from_fn(1, 1, |_, _| s.clone()),
                _ => {
                    return Ok(Err(undecided(
                        "the eigenvalues of what is no square matrix",
                    )));
                }
            };
            let positive = characteristic::characteristic_coefficients(&field, &matrix)
                .and_then(|c| hurwitz::hurwitz_matrix(&field, &c))
                .map(|h| leading_minors(&field, &h));
            return Ok(match positive {
                Some(positive) => Ok(Signs {
                    shows: Positivity {
                        form: false,
                        by: PositiveBy::Hurwitz(positive.len()),
                    },
                    positive,
                }),
                None => Err(undecided("the Hurwitz determinants are out of reach")),
            });
        }
        let (above, below) = (self.exact.expression(upper)?, self.exact.expression(lower)?);
        let value = crate::evaluate::value::subtract(&field, &above, &below, upper.span)?;
        let matrix = match value {
            Value::Zero => Matrix::from_fn(1, 1, |_, _| RationalFunction::zero(self.model.ring)),
            Value::Scalar(s) => Matrix::from_fn(1, 1, |_, _| s.clone()),
            Value::Matrix(m) if m.is_square() => m,
            Value::Matrix(_) => return Ok(Err(undecided("a matrix that is not square"))),
        };
        if let Some(refutation) = self.asymmetry(&matrix) {
            return Ok(Err(Verdict::Refuted(refutation)));
        }
        if !strict && matrix.rows() > 1 {
            return Ok(Err(undecided("a semidefinite matrix")));
        }
        // A quadratic form is positive wherever its letters do not all vanish if its matrix is so.
        let gram = (matrix.rows() == 1)
            .then(|| self.gram_matrix(&matrix[(0, 0)]))
            .flatten();
        let form = gram.is_some();
        let matrix = gram.unwrap_or(matrix);
        let (by, positive) = match self.declared_definite(&matrix) {
            Some(name) => (PositiveBy::Declared(name), Vec::new()),
            None if matrix.rows() == 1 => (PositiveBy::Sign, vec![matrix[(0, 0)].clone()]),
            None => (
                PositiveBy::Minors(matrix.rows()),
                leading_minors(&field, &matrix),
            ),
        };
        Ok(Ok(Signs {
            positive,
            shows: Positivity { form, by },
        }))
    }

    /// The declared positive definite matrix that this one is a positive multiple of.
    fn declared_definite(&mut self, matrix: &Matrix<RationalFunction>) -> Option<String> {
        let model = self.model;
        let definite = |m: &usize| model.matrices[*m].shape.positive_definite;
        let found = (0..model.matrices.len()).filter(definite).find(|m| {
            let key = (Node::Matrix(*m), Vec::new(), 0);
            let declared = match self.exact.value_of(key, Default::default()) {
                Ok(Value::Matrix(d)) if d.shape() == matrix.shape() => d,
                Ok(Value::Scalar(s)) if matrix.shape() == (1, 1) => {
                    Matrix::from_fn(1, 1, |_, _| s.clone())
                }
                _ => return false,
            };
            let Ok(factor) = matrix[(0, 0)].checked_div(&declared[(0, 0)]) else {
                return false;
            };
            let mut pairs = declared.iter().zip(matrix.iter());
            pairs.all(|(d, m)| &factor * d == *m) && self.sign(&factor) == RegionSign::Positive
        });
        found.map(|m| latex::canonical(&model.matrices[m].name))
    }

    /// The matrix S of a form z^T S z in the derivatives of processes, where the value is one.
    fn gram_matrix(&self, value: &RationalFunction) -> Option<Matrix<RationalFunction>> {
        let is_motion = |letter: &usize| {
            matches!(self.model.letters[*letter], Letter::Symbol { symbol, .. }
                if self.model.symbols[symbol].function_of.is_some()
                    && !self.model.symbols[symbol].range.is_positive()
                    && !self.is_in_definite(symbol))
        };
        let mut letters = value.numerator().variables_occurring();
        letters.retain(is_motion);
        let in_denominator = value.denominator().variables_occurring();
        if letters.is_empty() || in_denominator.iter().any(is_motion) {
            return None;
        }
        let half =
            RationalFunction::constant(self.model.ring, BigRational::new(1.into(), 2.into()));
        let n = letters.len();
        let gram = Matrix::try_from_fn(n, n, |i, j| {
            let second = value
                .derivative(letters[i])
                .and_then(|d| d.derivative(letters[j]))
                .map_err(|_| ())?;
            Ok::<_, ()>(&second * &half)
        })
        .ok()?;
        // It is that form and nothing else.
        let mut sum = RationalFunction::zero(self.model.ring);
        for i in 0..n {
            for j in 0..n {
                let [x, y] = [letters[i], letters[j]]
                    .map(|l| RationalFunction::variable(self.model.ring, l));
                sum = &sum + &(&(&x * &gram[(i, j)]) * &y);
            }
        }
        (sum == *value).then_some(gram)
    }

    /// Whether a symbol is an entry of a matrix that is declared positive definite.
    fn is_in_definite(&self, symbol: usize) -> bool {
        let matrix = self.model.symbols[symbol].entry_of;
        matrix.is_some_and(|(m, ..)| self.model.matrices[m].shape.positive_definite)
    }

    /// Why a matrix that is not symmetric cannot be positive definite in the sense of the word.
    fn asymmetry(&self, matrix: &Matrix<RationalFunction>) -> Option<Refutation> {
        let open: Vec<ResidualEntry> = (0..matrix.rows())
            .flat_map(|i| (0..i).map(move |j| (i, j)))
            .filter(|&(i, j)| matrix[(i, j)] != matrix[(j, i)])
            .map(|(i, j)| ResidualEntry {
                indices: Vec::new(),
                place: Some((i + 1, j + 1)),
                left: matrix[(i, j)].clone(),
                right: matrix[(j, i)].clone(),
            })
            .collect();
        let open: Vec<&ResidualEntry> = open.iter().collect();
        let all = self.insertion(&self.inserted.keys().copied().collect::<Vec<_>>());
        let expanded = super::identity::insert(&open, &all, self.model.functions.as_ref()).ok()?;
        let different = expanded.iter().any(|e| e.left != e.right);
        different.then(|| self.refutation(&open, &expanded))?
    }

    /// The sign for all values of the letters, the definitions inserted.
    pub(super) fn sign(&self, value: &RationalFunction) -> RegionSign {
        let all = self.insertion(&self.inserted.keys().copied().collect::<Vec<_>>());
        let Ok(value) = value.substitute(&all.letters) else {
            return RegionSign::Undecided;
        };
        let line = (Bound::NegativeInfinity, Bound::PositiveInfinity);
        let intervals: Vec<(Bound, Bound)> = (0..self.model.letters.len())
            .map(|letter| {
                if self.model.is_positive(letter) {
                    (Bound::from(0), Bound::PositiveInfinity)
                } else {
                    line.clone()
                }
            })
            .collect();
        Region::new(intervals)
            .and_then(|region| sign_of_quotient_on(&value, &region, &Budget::default()))
            .unwrap_or(RegionSign::Undecided)
    }

    /// A point at which what should be positive is not.
    fn not_positive(&self, value: &RationalFunction, sign: &RegionSign) -> Option<Refutation> {
        let all = self.insertion(&self.inserted.keys().copied().collect::<Vec<_>>());
        let expanded = value
            .substitute(&all.letters)
            .unwrap_or_else(|_| value.clone());
        let entry = ResidualEntry {
            indices: Vec::new(),
            place: None,
            left: value.clone(),
            right: RationalFunction::zero(self.model.ring),
        };
        let letters = super::identity::letters_of([&expanded]);
        let candidates = match sign {
            RegionSign::Changes { negative, .. } => vec![negative.clone()],
            _ => vec![
                self.reference_point(),
                vec![BigRational::zero(); self.model.letters.len()],
            ],
        };
        let witness = candidates.into_iter().find_map(|point| {
            let found = expanded.evaluate(&point).ok()?;
            let zero = BigRational::zero();
            (found <= zero).then(|| Witness {
                point: letters
                    .iter()
                    .map(|l| (*l, PointValue::Exact(point[*l].clone())))
                    .collect(),
                left: PointValue::Exact(found),
                right: PointValue::Exact(zero),
                place: None,
                indices: Vec::new(),
            })
        });
        // Where it changes its sign, the inequality is true on a part.
        let part = match sign {
            RegionSign::Changes { positive, .. } => expanded
                .evaluate(positive)
                .is_ok_and(|value| value > BigRational::zero())
                .then(|| letters.iter().map(|l| (*l, positive[*l].clone())).collect())
                .map(Part::Around),
            _ => None,
        };
        let mut refutation = Refutation::at(witness?).with_residual(vec![entry]);
        refutation.part = part;
        Some(refutation)
    }
}

fn undecided(reason: &str) -> Verdict {
    Verdict::Undecided {
        reason: reason.into(),
    }
}

/// The leading principal minors.
fn leading_minors(field: &Symbolic, matrix: &Matrix<RationalFunction>) -> Vec<RationalFunction> {
    (1..=matrix.rows())
        .filter_map(|n| determinant::determinant(field, &matrix.leading(n)))
        .collect()
}

/// F in `Re λ(F)`, the real parts of the eigenvalues.
fn stability(expr: &Expr) -> Option<&Expr> {
    let ExprKind::Call {
        function: Function::RealPart,
        argument,
    } = &ungrouped(expr).kind
    else {
        return None;
    };
    let is_lambda = |base: &str| base == "\\lambda";
    match &ungrouped(argument).kind {
        ExprKind::Apply {
            function,
            arguments,
        } if is_lambda(&function.letter.base) && arguments.len() == 1 => Some(&arguments[0]),
        ExprKind::Product(factors) => match factors.as_slice() {
            [lambda, matrix] => match &lambda.kind {
                ExprKind::Name(name) if is_lambda(&name.letter.base) => Some(ungrouped(matrix)),
                _ => None,
            },
            _ => None,
        },
        _ => None,
    }
}

fn ungrouped(expr: &Expr) -> &Expr {
    match &expr.kind {
        ExprKind::Group { inner, .. } => ungrouped(inner),
        _ => expr,
    }
}
