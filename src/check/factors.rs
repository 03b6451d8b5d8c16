//! A factor that a whole side has lost: 2, and where the document knows π also π and 2π, or their
//! reciprocals. Conventions of spectra differ by these: one-sided or two-sided, with 2π or without.

use super::edit::{Address, Replacement};
use crate::expr::{Bracket, Display, Expr, ExprKind, Name, QuotientStyle};
use crate::functions::Constant;
use crate::model::links::Place;
use crate::model::{Model, NotationKind};
use crate::verdict::EditClass;
use num_bigint::BigInt;
use num_rational::BigRational;

/// The side with each of these factors.
pub(crate) fn factors(model: &Model, display: &Display, place: Place) -> Vec<Replacement> {
    let Some(side) = place.find(display) else {
        return Vec::new();
    };
    let pi = model
        .notation
        .iter()
        .find(|n| matches!(n.kind, NotationKind::Constant(Constant::Pi)))
        .map(|n| &n.name);
    let expr = |kind| Expr::new(kind, side.span);
    let number = |n: i64| expr(ExprKind::Number(BigRational::from_integer(BigInt::from(n))));
    let letter = |name: &Name| expr(ExprKind::Name(name.clone()));
    let mut values = vec![number(2)];
    if let Some(name) = pi {
        values.push(letter(name));
        values.push(expr(ExprKind::Product(vec![number(2), letter(name)])));
    }
    let rest = match &side.kind {
        ExprKind::Product(factors) => factors.clone(),
        ExprKind::Sum(_) => vec![expr(ExprKind::Group {
            bracket: Bracket::Round,
            inner: Box::new(side.clone()),
        })],
        _ => vec![side.clone()],
    };
    let address = Address {
        place,
        path: Vec::new(),
    };
    values
        .into_iter()
        .flat_map(|value| {
            let reciprocal = expr(ExprKind::Quotient {
                numerator: Box::new(number(1)),
                denominator: Box::new(value.clone()),
                style: QuotientStyle::Bar,
            });
            [value, reciprocal]
        })
        .map(|factor| Replacement {
            address: address.clone(),
            class: EditClass::Factor,
            kind: ExprKind::Product(std::iter::once(factor).chain(rest.clone()).collect()),
        })
        .collect()
}
