//! Real roots of an equation in one letter.
//!
//! A root is shown to exist by the intermediate value theorem, between two numbers where the difference
//! of the sides has opposite signs and over which it has values, and enclosed by bisection and Newton's
//! method for intervals (Moore, *Interval Analysis*, 1966, chapter 7).

use super::failure::Reason;
use super::jet::Jet;
use super::letters::LayerKind;
use super::point::Point;
use super::solved::{BITS, Equation, Letter, Solver};
use crate::model::range::{Numbers, Range};
use crate::real::dyadic::{Dyadic, Rounding};
use crate::real::{Complex, Interval, Real};
use num_rational::BigRational;
use std::cmp::Ordering;
use std::collections::BTreeSet;

/// Numbers between which roots are sought: numerators and denominators.
const PROBES: [(i64, i64); 21] = [
    (-1000, 1),
    (-100, 1),
    (-20, 1),
    (-6, 1),
    (-3, 1),
    (-2, 1),
    (-1, 1),
    (-1, 2),
    (-1, 10),
    (-1, 100),
    (0, 1),
    (1, 100),
    (1, 10),
    (1, 2),
    (1, 1),
    (2, 1),
    (3, 1),
    (6, 1),
    (20, 1),
    (100, 1),
    (1000, 1),
];

/// The difference of an equation's sides at a point, with its slope by a letter.
struct Difference {
    value: Jet,
    slope: Jet,
}

impl Solver<'_, '_> {
    /// The difference of the sides of an equation with its slope by a letter.
    fn at(&mut self, point: &Point, equation: Equation<'_>, by: Letter) -> Option<Difference> {
        let entry = equation.entry;
        let span = equation.hypothesis.span;
        self.evaluate(point, |e| {
            let variable = e.arithmetic.open(1);
            let kind = LayerKind::Shifted {
                symbol: by.0,
                order: by.1,
                variable,
            };
            let value = e.with_layer(kind, |e| e.difference(equation.hypothesis));
            e.arithmetic.close();
            let value = value?;
            let whole = value.entries().get(entry).map(|x| (*x).clone());
            let whole = whole
                .ok_or_else(|| Reason::Unsupported("an equation of another shape").at(span))?;
            Ok(Difference {
                value: whole.coefficient(variable, 0),
                slope: whole.coefficient(variable, 1),
            })
        })
    }

    /// The sign of an equation's difference where a letter has this value.
    fn sign_at(
        &mut self,
        point: &Point,
        equation: Equation<'_>,
        letter: Letter,
        x: &Dyadic,
    ) -> Option<Ordering> {
        let value = Real::Enclosed(Interval::point(x.clone())).into();
        let (value, _) = self.plain(&point.clone().with(letter.0, letter.1, value), equation)?;
        let number = value.as_number()?;
        if !number.is_real() {
            return None;
        }
        number.re.sign()
    }

    /// A root by a change of sign.
    pub(super) fn real_root(
        &mut self,
        point: &Point,
        equation: Equation<'_>,
        letter: Letter,
    ) -> Option<Interval> {
        let free = Range::default();
        let range = if letter.1 == 0 {
            &self.ranges[letter.0]
        } else {
            &free
        };
        if range.numbers != Numbers::Real {
            return None;
        }
        let probes = probes(range);
        let mut before: Option<(Dyadic, Ordering)> = None;
        for x in probes {
            let Some(sign) = self.sign_at(point, equation, letter, &x) else {
                before = None;
                continue;
            };
            if sign == Ordering::Equal {
                return Some(Interval::point(x));
            }
            if let Some((left, other)) = &before
                && *other != sign
                && let Some(root) =
                    self.enclosed_root(point, equation, letter, [left.clone(), x.clone()], *other)
            {
                return Some(root);
            }
            before = Some((x, sign));
        }
        None
    }

    /// A root between two numbers, at the first of which the difference has a sign.
    fn enclosed_root(
        &mut self,
        point: &Point,
        equation: Equation<'_>,
        letter: Letter,
        ends: [Dyadic; 2],
        sign: Ordering,
    ) -> Option<Interval> {
        let [mut low, mut high] = ends;
        let mut shown = false;
        for round in 0..2 * BITS {
            let interval = Interval::between(low.clone(), high.clone());
            if interval.is_narrow(i64::from(BITS) - 24) && shown {
                return Some(interval);
            }
            let over =
                point
                    .clone()
                    .with(letter.0, letter.1, Real::Enclosed(interval.clone()).into());
            // A difference with values on all of the interval is continuous there.
            let difference = if round >= 4 || shown {
                self.at(&over, equation, letter)
            } else {
                None
            };
            let mut middle = interval.middle(BITS + 8);
            if let Some(difference) = difference {
                let real = difference.value.as_number().is_some_and(Complex::is_real);
                shown |= real;
                let slope = difference.slope.as_number().filter(|s| s.is_real());
                if real && let Some(slope) = slope {
                    match self.newton(point, equation, letter, &interval, &middle, &slope.re) {
                        Some(narrower) if narrower.width() <= interval.width().scaled(-1) => {
                            // Its ends need not have signs, but the root is within.
                            if narrower.is_narrow(i64::from(BITS) - 24)
                                || narrower.single().is_some()
                            {
                                return Some(narrower);
                            }
                            return self.refined(point, equation, letter, narrower);
                        }
                        Some(narrower) => middle = narrower.middle(BITS + 8),
                        None => {}
                    }
                }
            }
            if middle <= low || middle >= high {
                return shown.then_some(interval);
            }
            match self.sign_at(point, equation, letter, &middle) {
                Some(Ordering::Equal) => return Some(Interval::point(middle)),
                Some(s) if s == sign => low = middle,
                Some(_) => high = middle,
                None => return shown.then_some(interval),
            }
        }
        None
    }

    /// The numbers of an interval that Newton's method leaves: `m - f(m) / f'(X)`.
    fn newton(
        &mut self,
        point: &Point,
        equation: Equation<'_>,
        letter: Letter,
        interval: &Interval,
        middle: &Dyadic,
        slope: &Real,
    ) -> Option<Interval> {
        let slope = slope.interval(BITS + 8);
        if slope.contains_zero() {
            return None;
        }
        let value = Real::Enclosed(Interval::point(middle.clone())).into();
        let (value, _) = self.plain(&point.clone().with(letter.0, letter.1, value), equation)?;
        let number = value.as_number().filter(|z| z.is_real())?;
        let step = number.re.interval(BITS + 8).divide(&slope, BITS + 8)?;
        let moved = Interval::point(middle.clone()).subtract(&step, BITS + 8);
        moved.intersection(interval)
    }

    /// An interval that holds a root, narrowed by Newton's method as long as it helps.
    fn refined(
        &mut self,
        point: &Point,
        equation: Equation<'_>,
        letter: Letter,
        mut interval: Interval,
    ) -> Option<Interval> {
        for _ in 0..40 {
            if interval.is_narrow(i64::from(BITS) - 24) {
                break;
            }
            let over =
                point
                    .clone()
                    .with(letter.0, letter.1, Real::Enclosed(interval.clone()).into());
            let Some(difference) = self.at(&over, equation, letter) else {
                break;
            };
            let Some(slope) = difference.slope.as_number().filter(|s| s.is_real()) else {
                break;
            };
            let middle = interval.middle(BITS + 8);
            let narrower = self.newton(point, equation, letter, &interval, &middle, &slope.re);
            match narrower {
                Some(narrower) if narrower.width() < interval.width() => interval = narrower,
                _ => break,
            }
        }
        Some(interval)
    }
}

/// Numbers of a range in increasing order.
fn probes(range: &Range) -> Vec<Dyadic> {
    let dyadic = |x: &BigRational| Dyadic::from_rational(x, 40, Rounding::Down);
    let mut found: BTreeSet<Dyadic> = PROBES
        .iter()
        .map(|(n, d)| dyadic(&BigRational::new((*n).into(), (*d).into())))
        .collect();
    if let (Some(low), Some(high)) = (&range.low, &range.high) {
        for k in 0..=16i64 {
            let part = BigRational::new(k.into(), 16.into());
            found.insert(dyadic(&(&low.value + (&high.value - &low.value) * part)));
        }
    } else if let Some(end) = range.low.as_ref().or(range.high.as_ref()) {
        for (n, d) in PROBES {
            found.insert(dyadic(&(&end.value + BigRational::new(n.into(), d.into()))));
        }
    }
    let inside = |x: &Dyadic| range.contains(&x.to_rational());
    found.into_iter().filter(inside).collect()
}
