//! What a side comes to in which an integral diverges.
//!
//! The integral has no value, and nor has what contains it; only where it is the side itself, with a factor that has a
//! sign and terms that have values, is it said what the side grows to. Inside of anything else (a function, a divisor, two
//! infinities that may cancel, a factor that may vanish) nothing is said.

use super::Checker;
use crate::evaluate::{Failure, FailureKind, Value};
use crate::expr::{Expr, ExprKind, Sign};
use crate::model::names::Resolved;
use crate::model::{DefinitionKind, Node};
use std::cmp::Ordering;

/// What a side comes to.
pub(super) enum Comes {
    /// A value, with its sign where it is a scalar that has one.
    ToValue(Option<Ordering>),
    /// None, as an integral diverges, with the infinity that it grows to, if that is known.
    ToNone(Option<Sign>),
}

impl Checker<'_> {
    /// What an expression comes to; none where that is not known.
    pub(super) fn comes_to(&mut self, expr: &Expr) -> Option<Comes> {
        let (value, cases) = self.exact.in_case(0, |e| e.expression(expr));
        if cases > 1 {
            return None;
        }
        let failure = match value {
            Ok(Value::Zero) => return Some(Comes::ToValue(None)),
            Ok(Value::Matrix(_)) => return Some(Comes::ToValue(None)),
            Ok(Value::Scalar(value)) => {
                let value = self.spelt_out(&value)?;
                return Some(Comes::ToValue(self.table().sign(&value)));
            }
            Err(failure) => failure,
        };
        let Failure {
            kind: FailureKind::Divergent { towards, .. },
            span,
        } = failure
        else {
            return None;
        };
        match &expr.kind {
            ExprKind::Integral { .. } => (span == expr.span).then_some(Comes::ToNone(towards)),
            ExprKind::Group { inner, .. } | ExprKind::Underbrace { body: inner, .. } => {
                self.comes_to(inner)
            }
            ExprKind::Sum(terms) => {
                let mut none: Vec<Option<Sign>> = Vec::new();
                for (sign, term) in terms {
                    match self.comes_to(term)? {
                        Comes::ToValue(_) => {}
                        Comes::ToNone(towards) => none.push(towards.map(|t| times(t, *sign))),
                    }
                }
                match none.as_slice() {
                    [one] => Some(Comes::ToNone(*one)),
                    // Of two that grow to the same infinity none is made up for.
                    [first @ Some(_), rest @ ..] if rest.iter().all(|t| t == first) => {
                        Some(Comes::ToNone(*first))
                    }
                    _ => None,
                }
            }
            ExprKind::Product(factors) => {
                let mut none = None;
                let mut sign = Sign::Plus;
                for factor in factors {
                    match self.comes_to(factor)? {
                        Comes::ToValue(own) => sign = times(sign, sign_of(own?)?),
                        Comes::ToNone(towards) => {
                            if none.replace(towards).is_some() {
                                return None;
                            }
                        }
                    }
                }
                Some(Comes::ToNone(none?.map(|t| times(t, sign))))
            }
            ExprKind::Quotient {
                numerator,
                denominator,
                ..
            } => match (self.comes_to(numerator)?, self.comes_to(denominator)?) {
                (Comes::ToNone(towards), Comes::ToValue(below)) => {
                    let below = sign_of(below?)?;
                    Some(Comes::ToNone(towards.map(|t| times(t, below))))
                }
                (Comes::ToValue(_) | Comes::ToNone(_), _) => None,
            },
            ExprKind::Name(name) => {
                let Ok(Resolved::Node {
                    node: Node::Definition(definition),
                    derivatives: 0,
                }) = self.model.resolve(name, &|_| false)
                else {
                    return None;
                };
                let definition = &self.model.definitions[definition];
                let plain = definition.arguments.is_empty();
                if !plain || !matches!(definition.kind, DefinitionKind::Whole) {
                    return None;
                }
                let display = self.exact.display(definition.equation).clone();
                self.comes_to(definition.place.find(&display)?)
            }
            ExprKind::Number(_)
            | ExprKind::Apply { .. }
            | ExprKind::Call { .. }
            | ExprKind::Power { .. }
            | ExprKind::Transpose(_)
            | ExprKind::Matrix { .. }
            | ExprKind::Tuple(_)
            | ExprKind::BigSum { .. }
            | ExprKind::Derivative { .. }
            | ExprKind::Named { .. }
            | ExprKind::Expectation(_)
            | ExprKind::Cases(_)
            | ExprKind::Infinity
            | ExprKind::Constant => None,
        }
    }
}

fn times(left: Sign, right: Sign) -> Sign {
    match left == right {
        true => Sign::Plus,
        false => Sign::Minus,
    }
}

/// The sign of what is not zero.
fn sign_of(order: Ordering) -> Option<Sign> {
    match order {
        Ordering::Less => Some(Sign::Minus),
        Ordering::Equal => None,
        Ordering::Greater => Some(Sign::Plus),
    }
}
