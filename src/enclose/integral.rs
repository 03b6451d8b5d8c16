//! Integrals between finite limits, by Taylor series with Lagrange's remainder.
//!
//! The variable runs over a + (b - a) u with u from 0 to 1, so that limits may carry infinitesimals.
//! On a panel of half width h around m, the integral of f is the sum of its even Taylor
//! coefficients at m times 2 h^(k+1)/(k+1), and a remainder: the coefficient of order n, enclosed over
//! the whole panel, times 2 h^(n+1)/(n+1) for even n (Moore, *Interval Analysis*, 1966, chapter 8). Panels
//! are halved until the remainder is small; an integrand that cannot be enclosed there is taken as a
//! whole, and where even that is impossible there is no value.

use super::evaluator::{Evaluator, Result};
use super::failure::{NoValue, Reason, Undefined};
use super::jet::Jet;
use super::letters::LayerKind;
use super::value::Value;
use crate::expr::{Expr, Name};
use crate::model::names::Resolved;
use crate::real::dyadic::Dyadic;
use crate::real::{Interval, Real};
use crate::span::Span;
use num_rational::BigRational;

/// The order of the remainder.
const ORDER: usize = 10;
/// A panel is small enough when its remainder is below 2 to this beside the integrand.
const ENOUGH: i64 = -34;
/// How often a panel is halved, and how many panels there are at most.
const DEEPEST: u32 = 10;
const MOST_PANELS: usize = 96;

impl Evaluator<'_, '_> {
    pub(super) fn integral(
        &mut self,
        [from, to]: [&Expr; 2],
        body: &Expr,
        variable: &Name,
        span: Span,
    ) -> Result<Value> {
        let resolved = self.world.model.resolve(variable, &|_| false);
        let Ok(Resolved::Letter { symbol, order: 0 }) = resolved else {
            return Err(Reason::Unsupported("an integral over what is no letter").at(span));
        };
        let (from, to) = (self.scalar(from)?, self.scalar(to)?);
        if !from.is_real() || !to.is_real() {
            return Err(Reason::Unsupported("an integral in the complex plane").at(span));
        }
        self.coarse = true;
        let width = self.arithmetic.subtract(&to, &from);
        let mut sum = Value::Zero;
        // The left end and the depth of each panel that is open, the leftmost last.
        let mut open = vec![(0u32, 0u32)];
        let mut panels = 0;
        while let Some((left, depth)) = open.pop() {
            panels += 1;
            if panels > MOST_PANELS {
                return Err(Reason::Budget("panels of an integral").at(span));
            }
            let last = depth >= DEEPEST;
            let panel = Panel { left, depth };
            match self.over_panel(&panel, symbol, [&from, &width], body, last) {
                Ok(Some(part)) => {
                    sum = self.arithmetic.sum(&sum, &part).map_err(|r| r.at(span))?;
                }
                Ok(None) if !last => {
                    open.push((2 * left + 1, depth + 1));
                    open.push((2 * left, depth + 1));
                }
                Err(none) if none.reason.is_imprecise() && !last => {
                    open.push((2 * left + 1, depth + 1));
                    open.push((2 * left, depth + 1));
                }
                Ok(None) => return Err(Reason::Imprecise(Undefined::Size).at(span)),
                Err(none) => return Err(none),
            }
        }
        let product = self.arithmetic.product(&Value::Scalar(width), &sum);
        product.map_err(|r| r.at(span))
    }

    /// The integral over a panel; none where its remainder is still large.
    fn over_panel(
        &mut self,
        panel: &Panel,
        symbol: usize,
        [from, width]: [&Jet; 2],
        body: &Expr,
        last: bool,
    ) -> Result<Option<Value>> {
        let span = body.span;
        let bits = self.arithmetic.bits;
        let half = panel.half_width();
        let whole = Jet::from(Real::Enclosed(panel.interval()));
        let variable = self.arithmetic.open(ORDER);
        let step = Jet::series(variable, vec![Jet::zero(), Jet::integer(1)]);
        let at = |e: &mut Self, u: &Jet| -> Result<Value> {
            let u = e.arithmetic.add(u, &step);
            let product = e.arithmetic.multiply(width, &u).map_err(|r| r.at(span))?;
            let value = e.arithmetic.add(from, &product);
            let layer = LayerKind::Replaced {
                symbol,
                value,
                bound: true,
            };
            e.with_layer(layer, |e| e.expression(body))
        };
        let over = at(self, &whole);
        let middle = match &over {
            Ok(_) => at(self, &panel.middle()),
            Err(none) => Err(none.clone()),
        };
        self.arithmetic.close();
        let fail = |r: Reason| r.at(span);
        let (over, middle) = match (over, middle) {
            (Ok(over), Ok(middle)) => (over, middle),
            // What is undefined at a point may be so at an end or a gap only.
            (Err(none), _) | (_, Err(none)) if last => {
                return self.crudely(panel, symbol, [from, width], body, &none);
            }
            (Err(none), _) | (_, Err(none)) => return Err(doubtful(none)),
        };
        let a = &self.arithmetic;
        let moment = |k: usize| {
            let power = num_traits::pow(half.clone(), k + 1);
            let factor = BigRational::new(2.into(), (k + 1).into());
            Jet::from(Real::Enclosed(Interval::rational(&(power * factor), bits)))
        };
        let remainder = over
            .map(|f| a.multiply(&f.coefficient(variable, ORDER), &moment(ORDER)))
            .map_err(fail)?;
        // Small beside the integrand's size on the panel.
        let size = |jet: &Jet| {
            let number = jet.number();
            number.re.largest(64).max(number.im.largest(64))
        };
        let largest = over
            .entries()
            .into_iter()
            .map(|f| size(&f.coefficient(variable, 0)));
        let scale = largest.max().unwrap_or_else(Dyadic::zero);
        let enough = scale.max(Dyadic::power_of_two(-30)).scaled(ENOUGH);
        let small = |jet: &&Jet| {
            let parts = [&jet.number().re, &jet.number().im];
            parts
                .iter()
                .all(|part| part.interval(bits).width() < enough)
        };
        if !last && !remainder.entries().iter().all(small) {
            return Ok(None);
        }
        let sum = middle
            .map(|f| {
                let mut sum = Jet::zero();
                for k in (0..ORDER).step_by(2) {
                    let term = a.multiply(&f.coefficient(variable, k), &moment(k))?;
                    sum = a.add(&sum, &term);
                }
                Ok(sum)
            })
            .map_err(fail)?;
        a.sum(&sum, &remainder).map(Some).map_err(fail)
    }

    /// A panel's width times all values on it.
    fn crudely(
        &mut self,
        panel: &Panel,
        symbol: usize,
        [from, width]: [&Jet; 2],
        body: &Expr,
        none: &NoValue,
    ) -> Result<Option<Value>> {
        let span = body.span;
        if !matches!(none.reason, Reason::Imprecise(_) | Reason::Undefined(_)) {
            return Err(none.clone());
        }
        let whole = Jet::from(Real::Enclosed(panel.interval()));
        let product = self
            .arithmetic
            .multiply(width, &whole)
            .map_err(|r| r.at(span))?;
        let value = self.arithmetic.add(from, &product);
        // A number with infinitesimals would need derivatives where there may be none.
        if value.as_number().is_none() {
            return Err(doubtful(none.clone()));
        }
        let layer = LayerKind::Replaced {
            symbol,
            value,
            bound: true,
        };
        let over = self
            .with_layer(layer, |e| e.expression(body))
            .map_err(doubtful)?;
        if over.entries().iter().any(|e| e.as_number().is_none()) {
            return Err(doubtful(none.clone()));
        }
        let full = Jet::from(Real::rational(
            panel.half_width() * BigRational::from_integer(2.into()),
        ));
        let product = self.arithmetic.product(&Value::Scalar(full), &over);
        product.map(Some).map_err(|r| r.at(span))
    }
}

/// An integrand without a value somewhere does not make the integral certainly undefined.
fn doubtful(none: NoValue) -> NoValue {
    none.reason.doubtful().at(none.span)
}

/// The numbers from `left / 2^depth` to `(left + 1) / 2^depth`.
struct Panel {
    left: u32,
    depth: u32,
}

impl Panel {
    fn end(&self, twice: u32) -> Dyadic {
        Dyadic::new(twice.into(), -i64::from(self.depth) - 1)
    }

    fn interval(&self) -> Interval {
        Interval::between(self.end(2 * self.left), self.end(2 * self.left + 2))
    }

    fn middle(&self) -> Jet {
        Jet::from(Real::rational(self.end(2 * self.left + 1).to_rational()))
    }

    fn half_width(&self) -> BigRational {
        Dyadic::power_of_two(-i64::from(self.depth) - 1).to_rational()
    }
}
