//! Inequalities: positive definite matrices, signs of scalars, and stable matrices.
//!
//! A symmetric matrix is positive definite if and only if its leading principal minors are positive
//! (Sylvester's criterion; Gantmacher, *The Theory of Matrices* I, 1959, ch. X), and positive
//! semidefinite if and only if all principal minors are not negative: the leading ones are not enough.
//! A matrix is stable if and only if its Hurwitz determinants are positive (Hurwitz 1895). The signs
//! are decided for all admissible values of the letters; what is false is so at an admissible point
//! at which the value certainly has another sign.

use super::Checker;
use super::admissible::Admissible;
use super::hypotheses::possible::Signs as PossibleSigns;
use super::sides::{CASE, Sides, sides_of};
use crate::domain::Symbolic;
use crate::evaluate::{Failure, Value};
use crate::expr::{Display, Expr, ExprKind, Function, Relation};
use crate::latex;
use crate::matrix::Matrix;
use crate::model::links::Link;
use crate::model::matrices::MatrixSymbol;
use crate::model::{EIGENVALUES, Letter, Node};
use crate::theory::{characteristic, determinant, hurwitz};
use crate::verdict::certificate::{Fraction, Ordered, Steps};
use crate::verdict::{
    Part, PointValue, PositiveBy, Positivity, Refutation, ResidualEntry, Verdict, Witness,
};
use num_rational::BigRational;
use num_traits::Zero;
use ratpoly::{RationalFunction, RegionSign};
use std::cmp::Ordering;

/// The principal minors of larger matrices are not looked at.
const LARGEST: usize = 5;
/// How many points are looked at for a rational value once an enclosed one is found.
const MORE: usize = 3;

/// What has to be positive, or not negative, in the order in which it is asked, and what that shows.
struct Signs {
    positive: Vec<RationalFunction>,
    shows: Positivity,
    /// Whether it is so in one of several cases of a definition only.
    in_case: bool,
    /// The values of running indices, and the number of the case.
    indices: Vec<(String, i64)>,
}

/// The larger and the smaller side of a relation of order, and whether they may not be equal.
fn ordered(relation: Relation) -> Option<(bool, bool)> {
    match relation {
        Relation::Greater => Some((false, true)),
        Relation::GreaterEqual => Some((false, false)),
        Relation::Less => Some((true, true)),
        Relation::LessEqual => Some((true, false)),
        Relation::Equal
        | Relation::NotEqual
        | Relation::Distributed
        | Relation::Approximately
        | Relation::Tends => None,
    }
}

impl Checker<'_> {
    /// The verdict on `left > right`, or with another relation of order.
    pub(super) fn inequality(
        &mut self,
        equation: usize,
        link: &Link,
        positivity: &mut Option<Positivity>,
    ) -> Verdict {
        let display = self.exact.display(equation).clone();
        let (Some(left), Some(right)) = (link.left.find(&display), link.right.find(&display))
        else {
            return undecided("a link without its sides");
        };
        let Some((swapped, strict)) = ordered(link.relation) else {
            return match link.relation {
                Relation::NotEqual => self.different(equation, link),
                Relation::Greater
                | Relation::GreaterEqual
                | Relation::Less
                | Relation::LessEqual
                | Relation::Equal
                | Relation::Distributed
                | Relation::Approximately
                | Relation::Tends => undecided("only equations and inequalities are decided here"),
            };
        };
        let (upper, lower) = if swapped {
            (right, left)
        } else {
            (left, right)
        };
        let admissible = self.admissible();
        let several = self.signs_asked(&display, link);
        let several = match several {
            Ok(Ok(several)) => several,
            Ok(Err(verdict)) => {
                let known = matches!(verdict, Verdict::Undecided { .. });
                if known && self.is_definite(upper, lower, strict, &admissible) {
                    *positivity = Some(by_structure());
                    return self.ordered_holds(equation, link, &[], strict, &PositiveBy::Structure);
                }
                return verdict;
            }
            Err(failure) => return self.failed(&failure),
        };
        // What the structure of definite matrices shows needs no determinants.
        let minors = several.iter().any(|signs| !signs.positive.is_empty());
        let definite = |m: &MatrixSymbol| m.shape.positive_definite;
        if minors
            && self.model.matrices.iter().any(definite)
            && self.is_definite(upper, lower, strict, &admissible)
        {
            *positivity = Some(by_structure());
            return self.ordered_holds(equation, link, &[], strict, &PositiveBy::Structure);
        }
        let mut open = None;
        for signs in &several {
            for value in &signs.positive {
                let Some(inserted) = self.spelt_out(value) else {
                    return undecided("a denominator vanishes by the definitions");
                };
                let sign = self.sign_where_supposed(&inserted, admissible.sign(&inserted));
                let fits = match sign {
                    RegionSign::Positive => true,
                    RegionSign::Zero | RegionSign::NonNegative => !strict,
                    RegionSign::Negative
                    | RegionSign::NonPositive
                    | RegionSign::Changes { .. }
                    | RegionSign::Undecided => false,
                };
                if fits {
                    continue;
                }
                if !signs.in_case
                    && let Some(refutation) = self.violated_where_supposed(value, &inserted, strict)
                {
                    return Verdict::Refuted(refutation);
                }
                // In one of several cases not all points are meant.
                if !signs.in_case
                    && !self.supposed.in_force
                    && let Some(mut refutation) =
                        self.violation(value, &inserted, &sign, strict, &admissible)
                {
                    // One of several conditions says little of where all hold.
                    if signs.positive.len() > 1 || several.len() > 1 {
                        refutation.part = None;
                    }
                    return Verdict::Refuted(refutation);
                }
                open = Some(sign);
            }
        }
        match open {
            None => {
                let positive = several.iter().flat_map(|signs| &signs.positive);
                let positive: Vec<Fraction> = positive.map(Into::into).collect();
                *positivity = several.into_iter().next().map(|signs| signs.shows);
                let by = positivity.as_ref().map(|p| p.by.clone());
                let by = by.unwrap_or(PositiveBy::Sign);
                self.ordered_holds(equation, link, &positive, strict, &by)
            }
            Some(RegionSign::NonNegative) => {
                undecided("it is not negative, and nothing shows that it vanishes nowhere")
            }
            Some(_) => undecided("the sign of a determinant or expression is out of reach"),
        }
    }

    /// That what is asked is positive, or not negative, in each case of what is positive, negative or zero.
    pub(super) fn ordered_by_cases(&mut self, equation: usize, link: &Link) -> Option<Verdict> {
        let (_, strict) = ordered(link.relation)?;
        let display = self.exact.display(equation).clone();
        let several = self.signs_asked(&display, link).ok()?.ok()?;
        let mut asked = Vec::new();
        for signs in &several {
            let beside = self.suppositions_of_case(equation, link, &signs.indices)?;
            for value in &signs.positive {
                asked.push((self.spelt_out(value)?, beside.clone()));
            }
        }
        let wanted = match strict {
            true => PossibleSigns::POSITIVE,
            false => PossibleSigns::NOT_NEGATIVE,
        };
        let steps = self.by_cases(&asked, wanted)?;
        let proof = self.verified(equation, link, steps)?;
        Some(Verdict::Holds {
            by: Vec::new(),
            proof,
        })
    }

    /// That an order holds, with what was found to be positive.
    fn ordered_holds(
        &mut self,
        equation: usize,
        link: &Link,
        positive: &[Fraction],
        strict: bool,
        by: &PositiveBy,
    ) -> Verdict {
        let ordered = Ordered {
            positive: positive.to_vec(),
            strict,
            criterion: match by {
                PositiveBy::Declared(name) => format!("a positive multiple of {name}"),
                PositiveBy::Minors(_) => "leading principal minors".into(),
                PositiveBy::PrincipalMinors(_) => "all principal minors".into(),
                PositiveBy::Structure => {
                    "sums, congruences and inverses of definite matrices".into()
                }
                PositiveBy::Hurwitz(_) => "Hurwitz determinants".into(),
                PositiveBy::Sign => "its sign".into(),
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

    /// Whether the structure of a difference shows that it is definite, or semidefinite where that is
    /// enough.
    fn is_definite(
        &mut self,
        upper: &Expr,
        lower: &Expr,
        strict: bool,
        admissible: &Admissible,
    ) -> bool {
        // The structure of one case says nothing of the others.
        let ((), cases) = self.exact.in_case(0, |exact| {
            let _ = (exact.expression(upper), exact.expression(lower));
        });
        if cases > 1 {
            return false;
        }
        let found = self.definite_difference(upper, lower, admissible);
        found.is_some_and(|d| !d.negative && (d.strict || !strict))
    }

    /// The verdict on `left \neq right` for numbers.
    fn different(&mut self, equation: usize, link: &Link) -> Verdict {
        let admissible = self.admissible();
        let entries = match self.sides(equation, link) {
            Ok(entries) => entries,
            Err(failure) => return self.failed(&failure),
        };
        let [entry] = entries.as_slice() else {
            return undecided("matrices that differ");
        };
        let Some(difference) = self.spelt_out(&entry.difference()) else {
            return undecided("a denominator vanishes by the definitions");
        };
        let signed = matches!(
            admissible.sign(&difference),
            RegionSign::Positive | RegionSign::Negative
        );
        if signed || self.vanishes_nowhere(&difference) {
            let positive = [Fraction::from(&difference)];
            return self.ordered_holds(equation, link, &positive, true, &PositiveBy::Sign);
        }
        let equal = admissible.points(&difference).find(|point| {
            admissible.certain(&difference, point) == Some(PointValue::Exact(zero()))
        });
        let equal = equal
            .into_iter()
            .chain(self.zeros_where_supposed(&difference));
        let mut witnesses = equal.filter_map(|point| self.exact_witness(entry, &point));
        match witnesses.next() {
            Some(witness) => {
                Verdict::Refuted(Refutation::at(witness).with_residual(vec![entry.clone()]))
            }
            None => undecided("whether the sides are equal somewhere is out of reach"),
        }
    }

    /// Both sides at a point where they have rational values.
    fn exact_witness(
        &self,
        entry: &ResidualEntry,
        point: &[Option<BigRational>],
    ) -> Option<Witness> {
        let at = |side: &RationalFunction| self.value_at(&self.spelt_out(side)?, point);
        Some(Witness {
            point: shown(point),
            left: PointValue::Exact(at(&entry.left)?),
            right: PointValue::Exact(at(&entry.right)?),
            place: entry.place,
            indices: entry.indices.clone(),
        })
    }

    /// What a link with a relation of order asks to be positive, or not negative, in the declared
    /// symbols; none where that is not known.
    pub(crate) fn asked_positive(
        &mut self,
        display: &Display,
        link: &Link,
    ) -> Option<Vec<RationalFunction>> {
        let several = self.signs_asked(display, link).ok()?.ok()?;
        let asked = several.iter().flat_map(|signs| &signs.positive);
        asked.map(|f| self.spelt_out(f)).collect()
    }

    /// What must be positive for the larger side to be so, for every value of its running indices and
    /// in each case; a verdict where that is clear already.
    fn signs_asked(
        &mut self,
        display: &Display,
        link: &Link,
    ) -> Result<Result<Vec<Signs>, Verdict>, Failure> {
        let missing = || Failure::unsupported("a link without its sides", Default::default());
        let (swapped, strict) = ordered(link.relation).ok_or_else(missing)?;
        let left = link.left.find(display).ok_or_else(missing)?;
        let right = link.right.find(display).ok_or_else(missing)?;
        let (upper, lower) = if swapped {
            (right, left)
        } else {
            (left, right)
        };
        if let (Some(matrix), true) = (stability(lower), strict) {
            let matrix = matrix.clone();
            return Ok(self.stable(&matrix, upper)?.map(|signs| vec![signs]));
        }
        let field = self.model.field();
        // Only what is itself compared with zero is a form: 1 + p^2 > 1 says what it says.
        let beside_zero = [upper, lower]
            .iter()
            .any(|side| side.as_number().is_some_and(Zero::is_zero));
        let sides = sides_of(&mut self.exact, display, link, upper.span)?;
        let cases = sides.len() > 1 && display_has_cases(&sides);
        let mut several = Vec::new();
        for (indices, left, right) in sides {
            let (above, below) = if swapped {
                (right, left)
            } else {
                (left, right)
            };
            let value = crate::evaluate::value::subtract(&field, &above, &below, upper.span)?;
            let matrix = match value {
                Value::Zero => {
                    Matrix::from_fn(1, 1, |_, _| RationalFunction::zero(self.model.ring))
                }
                Value::Scalar(s) => Matrix::from_fn(1, 1, |_, _| s.clone()),
                Value::Matrix(m) if m.is_square() => m,
                Value::Matrix(_) => return Ok(Err(undecided("a matrix that is not square"))),
            };
            match self.signs_of_form(matrix, strict, beside_zero) {
                Ok(signs) => several.push(Signs {
                    in_case: cases,
                    indices,
                    ..signs
                }),
                Err(verdict) => return Ok(Err(verdict)),
            }
        }
        Ok(Ok(several))
    }

    /// What must be positive for a matrix to be definite, or not negative for it to be semidefinite.
    fn signs_of_form(
        &mut self,
        matrix: Matrix<RationalFunction>,
        strict: bool,
        beside_zero: bool,
    ) -> Result<Signs, Verdict> {
        let field = self.model.field();
        if let Some(refutation) = self.asymmetry(&matrix) {
            return Err(Verdict::Refuted(refutation));
        }
        // A quadratic form is positive wherever its letters do not all vanish if its matrix is so.
        let gram = (matrix.rows() == 1)
            .then(|| self.gram_matrix(&matrix[(0, 0)]))
            .flatten()
            // `> 0` of rates means "unless all stand still"; of the processes themselves it means what it says.
            .filter(|_| !strict || beside_zero && self.is_of_rates(&matrix[(0, 0)]));
        let form = gram.is_some();
        let matrix = gram.unwrap_or(matrix);
        if let Some(name) = self.declared_definite(&matrix) {
            return Ok(Signs {
                positive: Vec::new(),
                shows: Positivity {
                    form,
                    by: PositiveBy::Declared(name),
                },
                in_case: false,
                indices: Vec::new(),
            });
        }
        let n = matrix.rows();
        let (minors, by) = if n == 1 {
            (Some(vec![matrix[(0, 0)].clone()]), PositiveBy::Sign)
        } else if strict {
            (leading_minors(&field, &matrix), PositiveBy::Minors(n))
        } else {
            let minors = principal_minors(&field, &matrix);
            (minors, PositiveBy::PrincipalMinors(n))
        };
        match minors {
            Some(positive) => Ok(Signs {
                positive,
                shows: Positivity { form, by },
                in_case: false,
                indices: Vec::new(),
            }),
            None => Err(undecided("the minors are out of reach")),
        }
    }

    /// What must be positive for every eigenvalue of a matrix to have a smaller real part.
    fn stable(&mut self, matrix: &Expr, upper: &Expr) -> Result<Result<Signs, Verdict>, Failure> {
        let field = self.model.field();
        let bound = match self.exact.expression_without_cases(upper)? {
            Value::Zero => RationalFunction::zero(self.model.ring),
            Value::Scalar(bound) => bound,
            Value::Matrix(_) => return Ok(Err(undecided("a real part below a matrix"))),
        };
        // Re λ(A) < c if and only if Re λ(A - cE) < 0.
        let shifted = |m: &Matrix<RationalFunction>| {
            Matrix::from_fn(m.rows(), m.rows(), |i, j| {
                if i == j {
                    &m[(i, j)] - &bound
                } else {
                    m[(i, j)].clone()
                }
            })
        };
        let matrix = match self.exact.expression_without_cases(matrix)? {
            Value::Matrix(m) if m.is_square() => shifted(&m),
            Value::Scalar(s) => shifted(&Matrix::from_fn(1, 1, |_, _| s.clone())),
            Value::Matrix(_) | Value::Zero => {
                return Ok(Err(undecided(
                    "the eigenvalues of what is no square matrix",
                )));
            }
        };
        let positive = characteristic::characteristic_coefficients(&field, &matrix)
            .and_then(|c| hurwitz::hurwitz_matrix(&field, &c))
            .and_then(|h| leading_minors(&field, &h));
        Ok(match positive {
            Some(positive) => Ok(Signs {
                shows: Positivity {
                    form: false,
                    by: PositiveBy::Hurwitz(positive.len()),
                },
                positive,
                in_case: false,
                indices: Vec::new(),
            }),
            None => Err(undecided("the Hurwitz determinants are out of reach")),
        })
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

    /// Whether only derivatives of processes stand in a value, and no process itself.
    fn is_of_rates(&self, value: &RationalFunction) -> bool {
        let itself = |letter: &usize| {
            matches!(self.model.letters[*letter], Letter::Symbol { symbol, order: 0 }
                if self.model.symbols[symbol].function_of.is_some())
        };
        !value.numerator().variables_occurring().iter().any(itself)
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

    /// The sign for all admissible values of the letters, the definitions inserted.
    pub(super) fn sign(&self, value: &RationalFunction) -> RegionSign {
        match self.spelt_out(value) {
            Some(value) => self.admissible().sign(&value),
            None => RegionSign::Undecided,
        }
    }

    /// An admissible point at which what should be positive, or not negative, certainly is not.
    fn violation(
        &self,
        value: &RationalFunction,
        inserted: &RationalFunction,
        sign: &RegionSign,
        strict: bool,
        admissible: &Admissible,
    ) -> Option<Refutation> {
        let letters = super::identity::letters_of([inserted]);
        let known = match sign {
            RegionSign::Changes { negative, .. } => {
                let mut point = vec![None; negative.len()];
                for letter in &letters {
                    point[*letter] = Some(negative[*letter].clone());
                }
                Some(point)
            }
            RegionSign::Positive => return None,
            RegionSign::Zero
            | RegionSign::Negative
            | RegionSign::NonNegative
            | RegionSign::NonPositive
            | RegionSign::Undecided => None,
        };
        let violates = |value: &PointValue| match order(value) {
            Some(Ordering::Less) => true,
            Some(Ordering::Equal) => strict,
            Some(Ordering::Greater) | None => false,
        };
        let mut found: Option<(Vec<Option<BigRational>>, PointValue)> = None;
        let mut more = MORE;
        for point in known.into_iter().chain(admissible.points(inserted)) {
            if found.is_some() {
                more -= 1;
                if more == 0 {
                    break;
                }
            }
            let Some(value) = admissible.certain(inserted, &point).filter(violates) else {
                continue;
            };
            // A number that can be written down tells more than one that is enclosed.
            let exact = value.exact().is_some();
            if exact || found.is_none() {
                found = Some((point, value));
            }
            if exact {
                break;
            }
        }
        let (point, left) = found?;
        let witness = Witness {
            point: shown(&point),
            left,
            right: PointValue::Exact(zero()),
            place: None,
            indices: Vec::new(),
        };
        let entry = ResidualEntry {
            indices: Vec::new(),
            place: None,
            left: value.clone(),
            right: RationalFunction::zero(self.model.ring),
        };
        let mut refutation = Refutation::at(witness).with_residual(vec![entry]);
        // Where it changes its sign, the inequality is true on a part.
        if let RegionSign::Changes { positive, .. } = sign {
            let around = letters.iter().map(|l| (*l, positive[*l].clone())).collect();
            refutation.part = Some(Part::Around(around));
        }
        Some(refutation)
    }
}

fn zero() -> BigRational {
    BigRational::zero()
}

/// The order of a value and zero, if it is certain.
fn order(value: &PointValue) -> Option<Ordering> {
    match value {
        PointValue::Exact(number) => Some(number.cmp(&zero())),
        PointValue::Between(low, _) if *low > zero() => Some(Ordering::Greater),
        PointValue::Between(_, high) if *high < zero() => Some(Ordering::Less),
        PointValue::Between(..) | PointValue::Complex(_) => None,
    }
}

/// The letters that have values at a point.
fn shown(point: &[Option<BigRational>]) -> Vec<(usize, PointValue)> {
    let known = |(letter, value): (usize, &Option<BigRational>)| {
        Some((letter, PointValue::Exact(value.clone()?)))
    };
    point.iter().enumerate().filter_map(known).collect()
}

fn by_structure() -> Positivity {
    Positivity {
        form: false,
        by: PositiveBy::Structure,
    }
}

/// Whether the sides belong to cases of a definition.
fn display_has_cases<E>(sides: &Sides<E>) -> bool {
    sides
        .iter()
        .any(|(indices, ..)| indices.iter().any(|(name, _)| name == CASE))
}

fn undecided(reason: &str) -> Verdict {
    Verdict::Undecided {
        reason: reason.into(),
    }
}

/// The leading principal minors.
fn leading_minors(
    field: &Symbolic,
    matrix: &Matrix<RationalFunction>,
) -> Option<Vec<RationalFunction>> {
    (1..=matrix.rows())
        .map(|n| determinant::determinant(field, &matrix.leading(n)))
        .collect()
}

/// All principal minors.
fn principal_minors(
    field: &Symbolic,
    matrix: &Matrix<RationalFunction>,
) -> Option<Vec<RationalFunction>> {
    let n = matrix.rows();
    if n > LARGEST {
        return None;
    }
    (1_usize..1 << n)
        .map(|chosen| {
            let kept: Vec<usize> = (0..n).filter(|i| chosen >> i & 1 == 1).collect();
            let minor = Matrix::from_fn(kept.len(), kept.len(), |i, j| {
                matrix[(kept[i], kept[j])].clone()
            });
            determinant::determinant(field, &minor)
        })
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
    let is_lambda = |base: &str| base == EIGENVALUES;
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
