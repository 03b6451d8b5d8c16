//! The least value of a rational function of one letter over its range: decided exactly.
//!
//! A least value is taken at an end that belongs to the range or at a stationary point. The values at
//! these places, real algebraic numbers, are compared with each other and with the limits at the other
//! ends, at infinity and at the poles.

use super::Ground;
use crate::model::range::{Numbers, Range};
use crate::theory::algebraic::Algebraic;
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Signed, Zero};
use ratpoly::{Budget, Polynomial, RationalFunction};
use std::cmp::Ordering;

/// Where a function is least (or largest).
pub(super) enum Least {
    /// At this place and no other, with the value there.
    At(Algebraic, Algebraic),
    /// At several places, or at all.
    AtSeveral,
    /// Nowhere: it comes as near as it likes to a bound that it does not reach, or has none.
    Nowhere,
}

/// What a function tends to at an open end.
enum End {
    Value(Algebraic),
    Above,
    Below,
}

impl Ground {
    /// Where a function of one letter alone is least, or largest; none where that is out of reach.
    pub(super) fn least_on_line(
        &self,
        line: &RationalFunction,
        x: usize,
        minimum: bool,
    ) -> Option<Least> {
        if self.letters_in(line).iter().any(|l| *l != x) {
            return None;
        }
        let range = self.range_of(x);
        if range.numbers != Numbers::Real {
            return None;
        }
        let budget = Budget::default();
        let f = if minimum { line.clone() } else { -line };
        let slope = f.derivative(x).ok()?;
        if slope.is_zero() {
            return Some(Least::AtSeveral);
        }
        let inside = |root: &Algebraic| {
            let above = |end: &BigRational| root.compare_rational(end).is_gt();
            let below = |end: &BigRational| root.compare_rational(end).is_lt();
            range.low.as_ref().is_none_or(|e| above(&e.value))
                && range.high.as_ref().is_none_or(|e| below(&e.value))
        };
        let roots = |p: &Polynomial| -> Option<Vec<Algebraic>> {
            match p.is_constant() {
                true => Some(Vec::new()),
                false => Algebraic::roots(p, x, &budget).ok(),
            }
        };
        let poles = roots(f.denominator())?;
        let zeros = roots(f.numerator())?;
        // Signs of the function change at these only.
        let mut marks: Vec<Algebraic> = poles.iter().chain(&zeros).cloned().collect();
        marks.sort_by(Algebraic::compare);
        marks.dedup_by(|a, b| a == b);
        for pole in &poles {
            let (left, right) = (beside(&marks, pole, false)?, beside(&marks, pole, true)?);
            let closed = |end: &Option<crate::model::range::End>| {
                end.as_ref()
                    .is_some_and(|e| pole.compare_rational(&e.value) == Ordering::Equal)
            };
            let sides = [
                (inside(pole) || closed(&range.high), left),
                (inside(pole) || closed(&range.low), right),
            ];
            for (counts, at) in sides {
                if counts && self.value_on(&f, x, &at)?.is_negative() {
                    return Some(Least::Nowhere);
                }
            }
        }
        let mut places: Vec<Algebraic> = roots(slope.numerator())?
            .into_iter()
            .filter(&inside)
            .collect();
        let is_pole = |value: &BigRational| {
            poles
                .iter()
                .any(|p| p.compare_rational(value) == Ordering::Equal)
        };
        let mut ends = Vec::new();
        for (end, upper) in [(&range.low, false), (&range.high, true)] {
            match end {
                // Beside a pole it grows, as was seen above.
                Some(end) if is_pole(&end.value) => ends.push(End::Above),
                Some(end) if end.included => places.push(end.value.clone().into()),
                Some(end) => ends.push(End::Value(self.value_on(&f, x, &end.value)?.into())),
                None => ends.push(far(&f, x, upper)?),
            }
        }
        places.sort_by(Algebraic::compare);
        places.dedup_by(|a, b| a == b);
        let mut best: Option<(Algebraic, Algebraic)> = None;
        let mut several = false;
        for place in places {
            let value = Algebraic::evaluate(&f, &[(x, place.clone())], &budget).ok()?;
            match best.as_ref().map(|(_, known)| value.compare(known)) {
                None | Some(Ordering::Less) => {
                    best = Some((place, value));
                    several = false;
                }
                Some(Ordering::Equal) => several = true,
                Some(Ordering::Greater) => {}
            }
        }
        let Some((place, value)) = best else {
            return Some(Least::Nowhere);
        };
        let undercut = ends.iter().any(|end| match end {
            End::Value(limit) => limit.compare(&value).is_lt(),
            End::Above => false,
            End::Below => true,
        });
        if undercut {
            return Some(Least::Nowhere);
        }
        if several {
            return Some(Least::AtSeveral);
        }
        let value = match minimum {
            true => value,
            false => Algebraic::evaluate(line, &[(x, place.clone())], &budget).ok()?,
        };
        Some(Least::At(place, value))
    }

    fn value_on(&self, f: &RationalFunction, x: usize, at: &BigRational) -> Option<BigRational> {
        let mut point = vec![BigRational::zero(); self.reference.len()];
        point[x].clone_from(at);
        f.evaluate(&point).ok()
    }

    /// The value of a function of one letter alone at a number.
    pub(super) fn value_at_place(
        &self,
        line: &RationalFunction,
        x: usize,
        place: &Algebraic,
    ) -> Option<Algebraic> {
        Algebraic::evaluate(line, &[(x, place.clone())], &Budget::default()).ok()
    }

    /// Whether a number is a value that a letter may have.
    pub(super) fn may_be(&self, x: usize, value: &BigRational) -> bool {
        Range::contains(self.range_of(x), value)
    }
}

/// A rational number just beside a mark, before the next one.
fn beside(marks: &[Algebraic], mark: &Algebraic, above: bool) -> Option<BigRational> {
    let own = marks.iter().position(|m| m == mark)?;
    let neighbour = match above {
        true => marks.get(own + 1),
        false => own.checked_sub(1).and_then(|k| marks.get(k)),
    };
    let mut width = BigRational::one();
    for _ in 0..60 {
        let (low, high) = mark.enclosure(&width).ok()?;
        let edge = match above {
            true => high + &width,
            false => low - &width,
        };
        let free = neighbour.is_none_or(|n| {
            let order = n.compare_rational(&edge);
            if above { order.is_gt() } else { order.is_lt() }
        });
        if free {
            return Some(edge);
        }
        width /= BigInt::one() << 8;
    }
    None
}

/// What a function of one letter tends to far away.
fn far(f: &RationalFunction, x: usize, upper: bool) -> Option<End> {
    let leading = |p: &Polynomial| -> Option<(u32, BigInt)> {
        let degree = p.degree(x)?;
        let parts = p.coefficients_in(x);
        Some((degree, parts.get(degree as usize)?.as_constant()?))
    };
    let (n, above) = leading(f.numerator())?;
    let (d, below) = leading(f.denominator())?;
    Some(match n.cmp(&d) {
        Ordering::Less => End::Value(BigRational::zero().into()),
        Ordering::Equal => End::Value(BigRational::new(above, below).into()),
        Ordering::Greater => {
            let odd = (n - d) % 2 == 1 && !upper;
            match (above.is_positive() == below.is_positive()) != odd {
                true => End::Above,
                false => End::Below,
            }
        }
    })
}
