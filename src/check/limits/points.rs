//! How a limit looks at points on the way there: a second opinion beside the verdict, which decides
//! nothing.

use super::{Approach, towards};
use crate::check::Checker;
use crate::domain::Symbolic;
use crate::evaluate::{Evaluator, Value};
use crate::expr::walk::children;
use crate::expr::{Display, Expr, ExprKind, Name};
use crate::model::links::Link;
use crate::model::names::Resolved;
use crate::theory::limit::Towards;
use num_rational::BigRational;
use num_traits::{Signed, Zero};

/// The powers of four at which a limit is looked at: on the way there, and much farther.
const NEAR: usize = 6;
const FAR: usize = 20;

/// One of the combinations of cases of the definitions that are met.
struct Case {
    number: usize,
    of: usize,
}

impl Checker<'_> {
    /// Whether a statement about a limit looks true at points on the way there, as a second opinion
    /// beside the verdict: what grows without bound grows, the integrand of an infinite integral falls
    /// no faster than the reciprocal of its variable, and what has a limit comes closer to it. None
    /// where nothing has a value at such points.
    pub(crate) fn tends_at_points(&mut self, display: &Display, link: &Link) -> Option<bool> {
        let left = link.left.find(display)?;
        let right = link.right.find(display)?;
        let infinite = right.kind == ExprKind::Infinity;
        let approach = self.approach(display, link).ok()?;
        if approach.is_none() && !infinite {
            return None;
        }
        let mut case = Case { number: 0, of: 0 };
        // What is defined by cases has to tend there in each.
        loop {
            let looks = match &approach {
                None => self.integral_at_points(left, &mut case),
                Some(approach) => {
                    self.limit_at_points([left, right], approach, infinite, &mut case)
                }
            };
            case.number += 1;
            match looks {
                Some(true) if case.number < case.of => {}
                looks => return looks,
            }
        }
    }

    fn limit_at_points(
        &mut self,
        [left, right]: [&Expr; 2],
        approach: &Approach,
        infinite: bool,
        case: &mut Case,
    ) -> Option<bool> {
        let end = towards(&approach.goal)?;
        let moving = self.moved(left, approach).unwrap_or_else(|| left.clone());
        let mut at = |expr: &Expr, power| {
            let point = self.at_point(expr, approach.symbol, end, power, case);
            Some(point?.0)
        };
        let (near, far) = (at(&moving, NEAR)?, at(&moving, FAR)?);
        if infinite {
            return Some(near.is_positive() && far > near);
        }
        let there = at(right, FAR)?;
        let (near, far) = ((near - &there).abs(), (far - &there).abs());
        Some(far.is_zero() || far < near)
    }

    fn integral_at_points(&mut self, expr: &Expr, case: &mut Case) -> Option<bool> {
        let (body, variable, ends) = infinite_integral(expr)?;
        let Ok(Resolved::Letter { symbol, order: 0 }) = self.model.resolve(&variable, &|_| false)
        else {
            return None;
        };
        let mut grows = |towards: Towards| {
            let (near, at) = self.at_point(&body, symbol, towards, NEAR, case)?;
            let (far, beyond) = self.at_point(&body, symbol, towards, FAR, case)?;
            Some(near.is_positive() && far * beyond >= near * at)
        };
        let found: Vec<bool> = ends.into_iter().filter_map(&mut grows).collect();
        (!found.is_empty()).then(|| found.contains(&true))
    }

    /// The value of an expression where a symbol is a power of four on its way to zero or to infinity
    /// and all others are at the reference point, with the symbol's own value; where it is irrational,
    /// the middle of an interval around it.
    fn at_point(
        &mut self,
        expr: &Expr,
        symbol: usize,
        towards: Towards,
        power: usize,
        case: &mut Case,
    ) -> Option<(BigRational, BigRational)> {
        let letter = self.model.letter_of_symbol(symbol, 0)?;
        let value = |exact: &mut Evaluator<'_, Symbolic>| exact.expression(expr);
        let (value, cases) = self.exact.in_case(case.number, value);
        case.of = case.of.max(cases);
        let Ok(Value::Scalar(value)) = value else {
            return None;
        };
        let table = self.table();
        let value = self.spelt_out(&value)?;
        let large = num_traits::pow(BigRational::from_integer(4.into()), power);
        let at = match towards {
            Towards::Zero => large.recip(),
            Towards::Infinity => large,
        };
        let mut point: Vec<Option<BigRational>> =
            self.reference_point().into_iter().map(Some).collect();
        for (k, place) in point.iter_mut().enumerate() {
            if self.is_function(k) {
                *place = None;
            }
        }
        point[letter] = Some(at.clone());
        let value = match self.value_at(&value, &point) {
            Some(value) => value,
            None => table.enclosure(&value, &point)?.middle(),
        };
        Some((value, at))
    }
}

/// The integrand, the variable and the ends, zero or infinity, of the first integral.
fn infinite_integral(expr: &Expr) -> Option<(Expr, Name, Vec<Towards>)> {
    if let ExprKind::Integral {
        limits: Some((from, to)),
        body,
        variable,
    } = &expr.kind
    {
        let ends = [from, to].into_iter().filter_map(|end| towards(end));
        return Some(((**body).clone(), variable.clone(), ends.collect()));
    }
    children(expr).into_iter().find_map(infinite_integral)
}
