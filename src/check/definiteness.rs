//! Definite matrices by how they are built: sums, positive multiples, congruences and inverses of what
//! is definite are so, whatever their size.
//!
//! A sum of semidefinite matrices is semidefinite, and definite if one of them is; B^T X B is
//! semidefinite with X, and definite if B has independent columns, that is, if det B^T B is not zero
//! (Horn & Johnson, *Matrix Analysis*, 7.1). What is definite has an inverse, and that is definite.

use super::Checker;
use super::admissible::Admissible;
use crate::evaluate::{Value, value};
use crate::expr::{Expr, ExprKind, Function, Sign};
use crate::matrix::Matrix;
use crate::model::names::Resolved;
use crate::model::{DefinitionKind, Node, NotationKind};
use crate::theory::{arithmetic, determinant};
use num_integer::Integer;
use ratpoly::{RationalFunction, RegionSign};

/// How many definitions are followed.
const DEPTH: usize = 12;

/// A symmetric matrix that has one sign.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Definiteness {
    /// Whether the sign is minus.
    pub negative: bool,
    /// Whether it is definite; otherwise semidefinite, as far as is known.
    pub strict: bool,
}

const SEMIDEFINITE: Definiteness = Definiteness {
    negative: false,
    strict: false,
};
const DEFINITE: Definiteness = Definiteness {
    negative: false,
    strict: true,
};

impl Definiteness {
    fn times(self, other: Self) -> Self {
        Definiteness {
            negative: self.negative != other.negative,
            strict: self.strict && other.strict,
        }
    }

    fn of_sign(sign: &RegionSign) -> Option<Self> {
        let (negative, strict) = match sign {
            RegionSign::Positive => (false, true),
            RegionSign::Negative => (true, true),
            RegionSign::NonNegative | RegionSign::Zero => (false, false),
            RegionSign::NonPositive => (true, false),
            RegionSign::Changes { .. } | RegionSign::Undecided => return None,
        };
        Some(Definiteness { negative, strict })
    }
}

impl Checker<'_> {
    /// The sign of `upper - lower` as a matrix, or as a number that is made of definite matrices, where
    /// its structure tells it.
    pub(super) fn definite_difference(
        &mut self,
        upper: &Expr,
        lower: &Expr,
        admissible: &Admissible,
    ) -> Option<Definiteness> {
        let above = self.definiteness(upper, admissible, DEPTH);
        if self.is_zero(lower) {
            return above;
        }
        let below = self.definiteness(lower, admissible, DEPTH)?;
        if self.is_zero(upper) {
            return Some(Definiteness {
                negative: !below.negative,
                ..below
            });
        }
        sum(
            above?,
            Definiteness {
                negative: !below.negative,
                ..below
            },
        )
    }

    fn is_zero(&mut self, expr: &Expr) -> bool {
        match self.exact.expression(expr) {
            Ok(Value::Zero) => true,
            Ok(Value::Scalar(s)) => s.is_zero(),
            Ok(Value::Matrix(m)) => m.iter().all(RationalFunction::is_zero),
            Err(_) => false,
        }
    }

    fn definiteness(
        &mut self,
        expr: &Expr,
        admissible: &Admissible,
        depth: usize,
    ) -> Option<Definiteness> {
        let found = self.by_structure(expr, admissible, depth);
        if found.is_some() || !matches!(self.exact.expression(expr), Ok(Value::Scalar(_))) {
            return found;
        }
        self.by_value(expr, admissible)
    }

    fn by_structure(
        &mut self,
        expr: &Expr,
        admissible: &Admissible,
        depth: usize,
    ) -> Option<Definiteness> {
        let depth = depth.checked_sub(1)?;
        match &expr.kind {
            ExprKind::Group { inner, .. } => self.definiteness(inner, admissible, depth),
            ExprKind::Transpose(inner) => self.definiteness(inner, admissible, depth),
            ExprKind::Underbrace { body, .. } => self.definiteness(body, admissible, depth),
            ExprKind::Name(name) => {
                let Ok(Resolved::Node {
                    node,
                    derivatives: 0,
                }) = self.model.resolve(name, &|_| false)
                else {
                    return self.by_value(expr, admissible);
                };
                match node {
                    Node::Matrix(m) if self.model.matrices[m].shape.positive_definite => {
                        Some(DEFINITE)
                    }
                    Node::Definition(d) => {
                        let definition = &self.model.definitions[d];
                        let whole = matches!(definition.kind, DefinitionKind::Whole)
                            && definition.arguments.is_empty();
                        let display = self.exact.display(definition.equation).clone();
                        let body = definition.place.find(&display).filter(|_| whole)?;
                        self.definiteness(body, admissible, depth)
                    }
                    Node::Notation(n) => match &self.model.notation[n].kind {
                        NotationKind::Identity(_) => Some(DEFINITE),
                        NotationKind::Means(other) => {
                            let other = other.clone();
                            self.definiteness(&other, admissible, depth)
                        }
                        NotationKind::Zero
                        | NotationKind::CharacteristicCoefficient(_)
                        | NotationKind::Cofactor(_)
                        | NotationKind::LeadingMinor(_)
                        | NotationKind::Entry(_)
                        | NotationKind::HurwitzMatrix(_)
                        | NotationKind::Constant(_)
                        | NotationKind::Dirac
                        | NotationKind::Rows(_)
                        | NotationKind::Covariance(_) => self.by_value(expr, admissible),
                    },
                    Node::Symbol(_) | Node::Matrix(_) | Node::Unknown { .. } => {
                        self.by_value(expr, admissible)
                    }
                }
            }
            ExprKind::Sum(terms) => {
                let mut total: Option<Definiteness> = None;
                for (sign, term) in terms {
                    let mut own = self.definiteness(term, admissible, depth)?;
                    own.negative ^= *sign == Sign::Minus;
                    total = Some(match total {
                        None => own,
                        Some(known) => sum(known, own)?,
                    });
                }
                total
            }
            ExprKind::Product(factors) => self.of_product(factors, admissible, depth),
            ExprKind::Quotient {
                numerator,
                denominator,
                ..
            } => {
                let above = self.definiteness(numerator, admissible, depth)?;
                let below = self.definiteness(denominator, admissible, depth)?;
                // A divisor is not zero.
                Some(above.times(Definiteness {
                    strict: true,
                    ..below
                }))
            }
            ExprKind::Power { base, exponent } => {
                let Ok(Value::Scalar(exponent)) = self.exact.expression(exponent) else {
                    return None;
                };
                let exponent = exponent.as_constant().filter(|e| e.is_integer())?;
                let base = self.definiteness(base, admissible, depth)?;
                let even = exponent.numer().is_even();
                // A power that is printed has a value: of a negative one the base is invertible.
                let strict = base.strict || exponent < num_traits::Zero::zero();
                Some(Definiteness {
                    negative: base.negative && !even,
                    strict,
                })
            }
            ExprKind::Call {
                function: Function::Determinant | Function::Trace,
                argument,
            } => {
                let own = self.definiteness(argument, admissible, depth)?;
                // The sign of a determinant of negative matrices depends on their size.
                (!own.negative).then_some(own)
            }
            ExprKind::Number(_)
            | ExprKind::Apply { .. }
            | ExprKind::Named { .. }
            | ExprKind::Call { .. }
            | ExprKind::Matrix { .. }
            | ExprKind::Tuple(_)
            | ExprKind::BigSum { .. }
            | ExprKind::Integral { .. }
            | ExprKind::Derivative { .. }
            | ExprKind::Expectation(_)
            | ExprKind::Cases(_)
            | ExprKind::Infinity
            | ExprKind::Constant => self.by_value(expr, admissible),
        }
    }

    /// Numbers by their sign, matrices by their minors.
    fn by_value(&mut self, expr: &Expr, admissible: &Admissible) -> Option<Definiteness> {
        match self.exact.expression(expr).ok()? {
            Value::Zero => Some(SEMIDEFINITE),
            Value::Scalar(s) => {
                let value = self.spelt_out(&s)?;
                Definiteness::of_sign(&admissible.sign(&value))
            }
            Value::Matrix(m) => {
                if !m.is_square() || m != m.transpose() {
                    return None;
                }
                let mut strict = true;
                for n in 1..=m.rows() {
                    let minor = determinant::determinant(&self.model.field(), &m.leading(n))?;
                    let minor = self.spelt_out(&minor)?;
                    strict &= admissible.sign(&minor) == RegionSign::Positive;
                }
                strict.then_some(DEFINITE)
            }
        }
    }

    /// Numbers times a congruence `B^T X B`, `B B^T` or a single matrix.
    fn of_product(
        &mut self,
        factors: &[Expr],
        admissible: &Admissible,
        depth: usize,
    ) -> Option<Definiteness> {
        let mut total = DEFINITE;
        let mut matrices: Vec<&Expr> = Vec::new();
        for factor in flattened(factors) {
            match self.exact.expression(factor).ok()? {
                Value::Zero => return Some(SEMIDEFINITE),
                // What is a number by its shape may be a product of vectors.
                Value::Scalar(_) => {
                    total = total.times(self.definiteness(factor, admissible, depth)?);
                }
                Value::Matrix(_) => matrices.push(factor),
            }
        }
        if matrices.is_empty() {
            return Some(total);
        }
        let half = matrices.len() / 2;
        let (outer, rest) = matrices.split_at(half);
        let (inner, right) = match matrices.len() % 2 {
            1 => (Some(rest[0]), &rest[1..]),
            _ => (None, rest),
        };
        let own = match inner {
            Some(inner) => self.definiteness(inner, admissible, depth)?,
            None => DEFINITE,
        };
        if outer.is_empty() {
            return Some(total.times(own));
        }
        let field = self.model.field();
        let (left, right) = (self.product(outer)?, self.product(right)?);
        if left != right.transpose() {
            return None;
        }
        let gram = arithmetic::multiply(&field, &right.transpose(), &right)?;
        let strict = own.strict && {
            let gram = determinant::determinant(&field, &gram)?;
            let gram = self.spelt_out(&gram)?;
            admissible.sign(&gram) == RegionSign::Positive
        };
        Some(total.times(Definiteness { strict, ..own }))
    }

    fn product(&mut self, factors: &[&Expr]) -> Option<Matrix<RationalFunction>> {
        let field = self.model.field();
        let mut product: Option<Value<RationalFunction>> = None;
        for factor in factors {
            let own = self.exact.expression(factor).ok()?;
            product = Some(match product {
                None => own,
                Some(known) => value::multiply(&field, &known, &own, factor.span).ok()?,
            });
        }
        match product? {
            Value::Matrix(m) => Some(m),
            Value::Scalar(_) | Value::Zero => None,
        }
    }
}

/// The factors, those of a product in brackets among them.
fn flattened(factors: &[Expr]) -> Vec<&Expr> {
    let mut flat = Vec::new();
    for factor in factors {
        match &factor.kind {
            ExprKind::Group { inner, .. } => match &inner.kind {
                ExprKind::Product(inner) => flat.extend(flattened(inner)),
                _ => flat.push(factor),
            },
            ExprKind::Product(inner) => flat.extend(flattened(inner)),
            _ => flat.push(factor),
        }
    }
    flat
}

fn sum(a: Definiteness, b: Definiteness) -> Option<Definiteness> {
    if a.negative == b.negative {
        return Some(Definiteness {
            negative: a.negative,
            strict: a.strict || b.strict,
        });
    }
    None
}
