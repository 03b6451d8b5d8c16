//! Whether a value of a letter is the best one: minimal or maximal there.
//!
//! The place is compared with that of the only extremum over the range of the letter, exactly; a formula
//! for it must be the place for all values of the other letters. At an end of the range the derivative
//! need not vanish: what the quantity is worse by elsewhere has a sign then.

use super::extremum::Extremum;
use super::line::Least;
use super::{Found, Ground};
use crate::document::VerdictWord;
use crate::model::range::{End, Numbers};
use crate::model::statement::Proposition;
use crate::theory::algebraic::Algebraic;
use crate::verdict::PointValue;
use crate::verdict::statement::{Fact, Measure, Scope, Sign};
use num_rational::BigRational;
use num_traits::Zero;
use ratpoly::{Polynomial, RationalFunction};
use std::cmp::Ordering;

impl Ground {
    /// Whether a polynomial vanishes at a value of a letter and at no other: what is left without that factor
    /// has no zero. Of a factor more than once it is not said.
    pub(super) fn is_the_only_root(
        &self,
        p: &Polynomial,
        x: usize,
        value: &RationalFunction,
    ) -> bool {
        let letter = RationalFunction::variable(self.ring, x);
        let factor = (&letter - value).numerator().primitive_part();
        let Some(rest) = p.div_exact(&factor) else {
            return false;
        };
        let study = self.sign(&rest.into(), &Scope::Everywhere);
        matches!(study.sign, Some(Sign::Positive | Sign::Negative)) && study.poles.is_empty()
    }

    pub(super) fn extremal_at(
        &self,
        f: &RationalFunction,
        x: usize,
        minimum: bool,
        at: Option<RationalFunction>,
        p: &Proposition,
    ) -> Found {
        let extremum = self.extremum(f, x);
        // A formula for the place that makes the derivative vanish for all values of the letters.
        if let Some(extremum) = &extremum
            && extremum.minimum == minimum
            && let Some(formula) = &at
            && extremum.scope == Scope::Everywhere
            && !self.letters_in(formula).contains(&x)
            && let Some(polynomial) = &extremum.polynomial
            && self.is_the_only_root(polynomial, x, formula)
            && self.lies_in_range(formula, x)
        {
            let mut found = Found::of(VerdictWord::Holds, vec![extremum.fact(x, false)]);
            found.signs.clone_from(&extremum.signs);
            return found;
        }
        if let Some(formula) = &at
            && let Some(proof) = self.is_best_everywhere(f, x, minimum, formula)
        {
            return proof;
        }
        let value = match &at {
            Some(formula) => self.at(formula),
            None => self.reference[x].clone(),
        };
        let Some(value) = value else {
            return match extremum {
                None => self.no_extremum(f, x),
                Some(_) => self.without_value(&at.iter().collect::<Vec<_>>()),
            };
        };
        if !self.may_be(x, &value) {
            return Found::undecided(
                "this value of the letter is not among those that it may have",
            );
        }
        let facts = |found: Found| found.and(self.extremum_facts(f, x, false));
        let line = self.restricted(f, &[x]);
        let least = line
            .as_ref()
            .and_then(|line| self.least_on_line(line, x, minimum));
        let place = match least {
            Some(Least::At(place, _)) => place,
            Some(found @ (Least::AtSeveral | Least::Nowhere)) => {
                return facts(self.not_once(f, x, minimum, &found));
            }
            // Letters without a value may not matter for the place.
            None => match extremum.as_ref().filter(|e| e.minimum == minimum) {
                Some(Extremum {
                    place: Some(place), ..
                }) => place.clone(),
                _ => return self.has_extremum(f, x, minimum).unless_it_holds(),
            },
        };
        let exact: Algebraic = value.clone().into();
        let (distance, loss) = self.distance_and_loss(f, x, &exact, &place);
        let negative = -p.tolerance.clone();
        let near = distance.as_ref().is_some_and(|distance| {
            distance.compare_rational(&p.tolerance).is_le()
                && distance.compare_rational(&negative).is_ge()
        });
        let same = place == exact;
        let word = match (&at, same) {
            // The reference value is meant at the reference values of the others; what stands as `at`
            // would have to be the place for all of theirs.
            (Some(formula), true)
                if formula.as_constant().is_none()
                    || self.letters_in(f).into_iter().any(|l| l != x) =>
            {
                match self.misses_somewhere(f, x, minimum, formula) {
                    true => VerdictWord::Loose,
                    false => VerdictWord::Undecided,
                }
            }
            (_, true) => VerdictWord::Holds,
            (_, false) if near => VerdictWord::Loose,
            (_, false) => VerdictWord::Refuted,
        };
        let mut all: Vec<Fact> = Vec::new();
        all.extend(distance.map(|d| Fact::Number(Measure::Distance(x), d)));
        all.extend(loss.map(|l| Fact::Number(Measure::Loss(x), l)));
        all.extend(extremum.as_ref().map(|e| e.fact(x, false)));
        all.push(Fact::Number(Measure::Stationary(x), place));
        if word != VerdictWord::Holds {
            all.extend(self.slope_at(f, x, &value));
            if let Some(again) = self.same_again(f, x, &value) {
                all.push(Fact::Number(Measure::SameAgain(x), again));
            }
        }
        let mut found = Found::of(word, all);
        if word == VerdictWord::Undecided {
            found.reason = Some("whether it is so for all values of the letters is open".into());
        }
        if near && !same {
            found = found.nearly();
        }
        if let Some(extremum) = extremum {
            found.signs = extremum.signs;
        }
        found
    }

    /// Whether a formula lies inside of the range of a letter for all values of its own letters.
    pub(super) fn lies_in_range(&self, formula: &RationalFunction, x: usize) -> bool {
        let range = self.range_of(x);
        let constant = |v: &BigRational| RationalFunction::constant(self.ring, v.clone());
        let beyond = |f: RationalFunction, included: bool| {
            let study = self.sign(&f, &Scope::Everywhere);
            study.poles.is_empty()
                && match study.sign {
                    Some(Sign::Positive) => true,
                    Some(Sign::NonNegative | Sign::Zero) => included,
                    Some(Sign::Negative | Sign::NonPositive | Sign::Both) | None => false,
                }
        };
        let low = range
            .low
            .as_ref()
            .is_none_or(|e| beyond(formula - &constant(&e.value), e.included));
        let high = range
            .high
            .as_ref()
            .is_none_or(|e| beyond(&constant(&e.value) - formula, e.included));
        low && high
    }

    /// The proof that a quantity is better at a formula than at all other values of a letter, whatever the
    /// other letters are: what it is worse by elsewhere is a power of the distance, of one sign over the
    /// range, times what is positive.
    fn is_best_everywhere(
        &self,
        f: &RationalFunction,
        x: usize,
        minimum: bool,
        formula: &RationalFunction,
    ) -> Option<Found> {
        if self.range_of(x).numbers != Numbers::Real || self.letters_in(formula).contains(&x) {
            return None;
        }
        let there = f.substitute(&[(x, formula.clone())]).ok()?;
        if !self.has_values_everywhere(&there) || !self.lies_in_range(formula, x) {
            return None;
        }
        let mut rest = match minimum {
            true => f - &there,
            false => &there - f,
        };
        let distance = RationalFunction::variable(self.ring, x) - formula;
        let factor = distance.numerator().primitive_part();
        let mut odd = false;
        while !rest.is_zero() && rest.numerator().div_exact(&factor).is_some() {
            rest = rest.checked_div(&distance).ok()?;
            odd = !odd;
        }
        if odd {
            // Below the upper end it is the distance with the other sign.
            let end = formula.as_constant()?;
            let is = |e: &Option<End>| e.as_ref().is_some_and(|e| e.included && e.value == end);
            let range = self.range_of(x);
            match (is(&range.low), is(&range.high)) {
                (true, _) => {}
                (false, true) => rest = -rest,
                (false, false) => return None,
            }
        }
        let study = self.sign(&rest, &Scope::Everywhere);
        if study.sign != Some(Sign::Positive) || !study.poles.is_empty() {
            return None;
        }
        let facts = vec![Fact::Best {
            letter: x,
            minimum,
            end: odd,
        }];
        let mut found = Found::of(VerdictWord::Holds, facts);
        found.signs.extend(study.certificate);
        Some(found)
    }

    /// Whether some values of the other letters show that a quantity is not best at a formula: the derivative
    /// does not vanish there inside of the range, or leads to what is better from an end of it, or what is best
    /// is known to be elsewhere.
    fn misses_somewhere(
        &self,
        f: &RationalFunction,
        x: usize,
        minimum: bool,
        formula: &RationalFunction,
    ) -> bool {
        let there = f
            .derivative(x)
            .and_then(|slope| slope.substitute(&[(x, formula.clone())]));
        let Ok(slope) = there else {
            return false;
        };
        let range = self.range_of(x);
        let letters = self.letters_in(formula);
        let leads_away = |point: &Vec<Option<BigRational>>| {
            if letters.iter().any(|l| point[*l].is_none()) {
                return false;
            }
            let zero = BigRational::zero();
            let slope = self.admissible.certain(&slope, point);
            let place = self.admissible.certain(formula, point);
            let (Some(slope), Some(place)) = (slope, place) else {
                return false;
            };
            let sign = order(&slope, &zero);
            if !matches!(sign, Some(Ordering::Less | Ordering::Greater)) {
                return false;
            }
            let rises = (sign == Some(Ordering::Greater)) == minimum;
            // From an end it goes on to one side only.
            let from_low = match &range.low {
                None => false,
                Some(end) => match order(&place, &end.value) {
                    Some(Ordering::Greater) => false,
                    Some(Ordering::Equal) if end.included => true,
                    _ => return false,
                },
            };
            let from_high = match &range.high {
                None => false,
                Some(end) => match order(&place, &end.value) {
                    Some(Ordering::Less) => false,
                    Some(Ordering::Equal) if end.included => true,
                    _ => return false,
                },
            };
            !(from_low && rises || from_high && !rises)
        };
        if self
            .admissible
            .points(&slope)
            .any(|point| leads_away(&point))
        {
            return true;
        }
        self.near_points(f, x).any(|point| {
            let Some(line) = self.restricted_at(f, x, &point) else {
                return false;
            };
            match self.least_on_line(&line, x, minimum) {
                Some(Least::At(place, _)) => {
                    let named = self.at_point(formula, &point);
                    named.is_some_and(|named| {
                        self.may_be(x, &named) && !place.compare_rational(&named).is_eq()
                    })
                }
                Some(Least::AtSeveral | Least::Nowhere) => true,
                None => false,
            }
        })
    }
}

/// How a value that is certain compares with a number.
fn order(value: &PointValue, number: &BigRational) -> Option<Ordering> {
    match value {
        PointValue::Exact(value) => Some(value.cmp(number)),
        PointValue::Between(low, _) if low > number => Some(Ordering::Greater),
        PointValue::Between(_, high) if high < number => Some(Ordering::Less),
        PointValue::Between(..) | PointValue::Complex(_) => None,
    }
}
