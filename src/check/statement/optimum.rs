//! Whether a value of a letter is nearly the best one, the best one at its lower bound, or bad for
//! another quantity.

use super::extremum::Extremum;
use super::line::Least;
use super::sign::SignStudy;
use super::{Found, Ground};
use crate::document::VerdictWord;
use crate::model::range::Numbers;
use crate::model::statement::Proposition;
use crate::theory::algebraic::Algebraic;
use crate::verdict::statement::{Fact, Measure, Scope, Sign, Subject};
use num_rational::BigRational;
use num_traits::One;
use ratpoly::{Budget, Polynomial, RationalFunction, resultant_within};

impl Ground {
    /// The derivative at a value of the letter, which an extremum would make zero.
    pub(super) fn slope_at(
        &self,
        f: &RationalFunction,
        x: usize,
        value: &BigRational,
    ) -> Option<Fact> {
        let derivative = f.derivative(x).ok()?;
        let mut point = self.reference.clone();
        point[x] = Some(value.clone());
        let slope = self.at_point(&derivative, &point)?;
        let letters = self.letters_in(&derivative).into_iter();
        Some(Fact::Witness {
            subject: Subject::Derivative(x),
            point: letters
                .map(|l| Some((l, point[l].clone()?)))
                .collect::<Option<_>>()?,
            value: slope,
        })
    }

    /// Another value of the letter at which the quantity is the same.
    pub(super) fn same_again(
        &self,
        f: &RationalFunction,
        x: usize,
        value: &BigRational,
    ) -> Option<Algebraic> {
        let here = self.with_value(f, x, value)?;
        let difference = self.restricted(&(f - &here), &[x])?;
        let roots = self.admitted_roots(difference.numerator(), x)?;
        let mut others = roots.into_iter().filter(|r| r.as_rational() != Some(value));
        let found = others.next()?;
        others.next().is_none().then_some(found)
    }

    pub(super) fn with_value(
        &self,
        f: &RationalFunction,
        x: usize,
        value: &BigRational,
    ) -> Option<RationalFunction> {
        let value = RationalFunction::constant(self.ring, value.clone());
        f.substitute(&[(x, value)]).ok()
    }

    pub(super) fn nearly_minimal(
        &self,
        f: &RationalFunction,
        x: usize,
        at: Option<RationalFunction>,
        p: &Proposition,
    ) -> Found {
        let about = Fact::About(Scope::Reference);
        let value = match &at {
            Some(formula) => self.at(formula),
            None => self.reference[x].clone(),
        };
        if value.as_ref().is_some_and(|value| !self.may_be(x, value)) {
            return Found::undecided(
                "this value of the letter is not among those that it may have",
            );
        }
        let extremum = self.extremum(f, x);
        let line = self.restricted(f, &[x]);
        let least = line
            .as_ref()
            .and_then(|line| self.least_on_line(line, x, true));
        let place = match least {
            Some(Least::At(place, _)) => place,
            Some(Least::AtSeveral) => {
                return Found::undecided("it is least at several values of the letter");
            }
            Some(Least::Nowhere) => {
                let found = self.not_once(f, x, true, &Least::Nowhere);
                return found.and(self.elasticity_facts(f, x, p));
            }
            None => match extremum.as_ref().filter(|e| e.minimum) {
                Some(Extremum {
                    place: Some(place), ..
                }) => place.clone(),
                _ => {
                    return self.no_extremum(f, x).and(self.elasticity_facts(f, x, p));
                }
            },
        };
        let Some(value) = value else {
            return Found::undecided("there are no reference values");
        };
        let exact: Algebraic = value.into();
        let (distance, loss) = self.distance_and_loss(f, x, &exact, &place);
        let word = match &loss {
            Some(loss) if loss.compare_rational(&p.tolerance).is_le() => VerdictWord::Holds,
            Some(_) => VerdictWord::Refuted,
            // Of a least value that is zero no part is small.
            None if place == exact => VerdictWord::Holds,
            None if line.is_some() => VerdictWord::Refuted,
            None => return Found::undecided("the sign of its least value is not known"),
        };
        let mut facts = Vec::new();
        facts.extend(loss.map(|l| Fact::Number(Measure::Loss(x), l)));
        facts.extend(distance.map(|d| Fact::Number(Measure::Distance(x), d)));
        facts.extend(extremum.as_ref().map(|e| e.fact(x, false)));
        facts.push(Fact::Number(Measure::Stationary(x), place));
        facts.push(about);
        let mut found = Found::of(word, facts);
        if let Some(extremum) = extremum {
            found.signs = extremum.signs;
        }
        found
    }

    /// If a letter cannot be less than its reference value, that value is the best one.
    pub(super) fn least_at_bound(&self, f: &RationalFunction, x: usize) -> Found {
        let (Ok(derivative), Some(own)) = (f.derivative(x), self.reference[x].clone()) else {
            return Found::undecided("there is no reference value");
        };
        if self.range_of(x).numbers != Numbers::Real {
            return Found::undecided("a bound of a letter that is not real");
        }
        let Some(here) = self
            .with_value(f, x, &own)
            .filter(|here| !self.has_no_value(here))
        else {
            return Found::undecided("it has no value at the bound");
        };
        if !self.has_values_everywhere(&here) {
            return Found::undecided("at the bound it has no value for some values of the others");
        }
        let subject = Subject::Derivative(x);
        let everywhere = Scope::Above(x, own.clone());
        let line = Scope::LineAbove(x, own.clone());
        let study = self.sign(&derivative, &everywhere);
        let rises = |study: &SignStudy, scope: &Scope| {
            study.poles.is_empty()
                && match study.sign {
                    Some(Sign::Positive) => true,
                    Some(Sign::NonNegative) => self.zeros_are_isolated(&derivative, x, scope),
                    _ => false,
                }
        };
        if rises(&study, &everywhere) {
            let sign = study.sign.unwrap_or(Sign::Positive);
            let fact = Fact::Sign(subject, sign, everywhere);
            let mut found = Found::of(VerdictWord::Holds, vec![fact]);
            found.signs.extend(study.certificate);
            return found;
        }
        // Where it does not rise all the way, it may still be larger everywhere above.
        let excess = f - &here;
        let over = self.sign(&excess, &everywhere);
        if over.sign == Some(Sign::Positive) && over.poles.is_empty() {
            let fact = Fact::Sign(Subject::Difference, Sign::Positive, everywhere);
            let mut found = Found::of(VerdictWord::Holds, vec![fact]);
            found.signs.extend(over.certificate);
            return found;
        }
        let inner = self.sign(&excess, &line);
        let slope = self.sign(&derivative, &line);
        let mut found = Found::default();
        if let Some(sign) = slope.sign {
            found.facts.push(Fact::Sign(subject, sign, line));
            found.signs.extend(slope.certificate);
        }
        if !study.boundary.is_empty() {
            found
                .facts
                .push(Fact::Boundary(subject, study.boundary.clone()));
        }
        // A point above the bound that is as good shows it false.
        let better = |study: &SignStudy| match study.sign {
            Some(Sign::Both) => study.points.is_some(),
            Some(Sign::Negative | Sign::NonPositive | Sign::Zero) => true,
            Some(Sign::Positive | Sign::NonNegative) | None => false,
        };
        if better(&inner) {
            found.word = VerdictWord::Refuted;
            return found.and(self.extremum_facts(f, x, false));
        }
        let here = inner.sign == Some(Sign::Positive) && inner.poles.is_empty();
        if here && better(&over) {
            found.word = VerdictWord::Loose;
            if let Some((_, negative)) = study.points {
                let point = self.letters_in(&derivative).into_iter();
                let point: Vec<_> = point.map(|l| (l, negative[l].clone())).collect();
                if let Ok(value) = derivative.evaluate(&negative) {
                    found.facts.push(Fact::Witness {
                        subject,
                        point,
                        value,
                    });
                }
            }
            return found;
        }
        found.reason = Some("the sign of the derivative is out of reach".into());
        found
    }

    /// The value of a letter that is best for another quantity is a bad one for this.
    pub(super) fn worse_at_minimum_of(
        &self,
        f: &RationalFunction,
        other: &RationalFunction,
        x: usize,
        p: &Proposition,
    ) -> Found {
        let (Some(own), Some(theirs)) = (self.extremum(f, x), self.extremum(other, x)) else {
            return Found::undecided("one of the minima is out of reach");
        };
        let (Some(here), Some(there)) = (&own.place, &theirs.place) else {
            return Found::undecided("there are no reference values");
        };
        let worse = self.relative_excess(f, x, there, here);
        let Some(worse) = worse.filter(|_| own.minimum && theirs.minimum) else {
            return Found::undecided("one of the two has no minimum");
        };
        let mut facts = vec![Fact::Number(Measure::Worse(x), worse.clone())];
        if let Some(reference) = self.reference[x].clone()
            && let Some(ratio) = self.quotient_at(f, x, there, &reference.into())
        {
            facts.push(Fact::Number(Measure::AgainstReference(x), ratio));
        }
        facts.push(theirs.fact(x, true));
        facts.push(own.fact(x, false));
        if worse.compare_rational(&p.tolerance).is_le() {
            return Found::of(VerdictWord::Refuted, facts);
        }
        let letters = [f, other].map(|f| self.letters_in(f));
        let alone = letters.iter().flatten().all(|l| *l == x);
        if alone {
            let mut found = Found::of(VerdictWord::Holds, facts);
            found.signs = own.signs;
            found.signs.extend(theirs.signs);
            return found;
        }
        // Elsewhere the two minima may lie near each other: where they coincide the resultant vanishes.
        let everywhere = own.scope == Scope::Everywhere && theirs.scope == Scope::Everywhere;
        let budget = Budget::default();
        let coincide = match (&own.polynomial, &theirs.polynomial) {
            (Some(own), Some(theirs)) if everywhere => resultant_within(own, theirs, x, &budget)
                .and_then(|r| r.factor_within(&budget))
                .ok(),
            _ => None,
        };
        // Two polynomials of two terms that have a common root have their positive roots in common;
        // others may have only roots in common that the letter cannot be.
        let binomial = |p: &Option<Polynomial>| {
            let coefficients = p.iter().flat_map(|p| p.coefficients_in(x));
            coefficients.filter(|c| !c.is_zero()).count() == 2
        };
        let telling = binomial(&own.polynomial) && binomial(&theirs.polynomial);
        let mut together = false;
        if let Some(resultant) = coincide {
            for (factor, _) in resultant.factors {
                let study = self.sign(&factor.clone().into(), &Scope::Everywhere);
                if !matches!(study.sign, Some(Sign::Positive | Sign::Negative)) {
                    together |= telling && study.points.is_some();
                    facts.push(Fact::Boundary(Subject::Difference, vec![factor]));
                }
            }
        }
        let elsewhere = || {
            self.near_points(&(f + other), x).any(|point| {
                let lines = [f, other].map(|f| self.restricted_at(f, x, &point));
                let [Some(own), Some(theirs)] = lines else {
                    return false;
                };
                let (Some(Least::At(_, least)), Some(Least::At(there, _))) = (
                    self.least_on_line(&own, x, true),
                    self.least_on_line(&theirs, x, true),
                ) else {
                    return false;
                };
                // Above its least value by no more than that part of it.
                let bound = BigRational::one() + &p.tolerance;
                let positive = least.is_positive();
                positive
                    && self.value_at_place(&own, x, &there).is_some_and(|value| {
                        value
                            .divided_by(&least, &budget)
                            .is_ok_and(|q| q.compare_rational(&bound).is_le())
                    })
            })
        };
        let word = match together || elsewhere() {
            true => VerdictWord::Loose,
            false => VerdictWord::Undecided,
        };
        let mut found = Found::of(word, facts);
        if word == VerdictWord::Undecided {
            found.reason = Some("it is so at the reference values; elsewhere it is open".into());
        }
        found.signs = own.signs;
        found.signs.extend(theirs.signs);
        found
    }
}
