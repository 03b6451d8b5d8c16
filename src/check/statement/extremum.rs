//! Extrema over the range of one letter.
//!
//! On the positive half-line:
//! The derivative's numerator, freed from factors of one sign, is a polynomial in the letter whose
//! coefficients are functions of the others. If these have definite signs with exactly one change,
//! it has exactly one positive root, a simple one, for all values of the others (Descartes 1637),
//! and the quantity one extremum, which is global. Otherwise the same is asked at the reference
//! values of the others.

use super::line::Least;
use super::sign::{MULTIPLES, SignStudy};
use super::{Found, Ground};
use crate::document::VerdictWord;
use crate::model::range::{Numbers, Range};
use crate::model::statement::Proposition;
use crate::theory::algebraic::{Algebraic, square_part};
use crate::verdict::statement::{
    ClosedForm, Fact, Measure, Scope, Sign, SignCertificate, Subject, coefficient_sign, power,
    times,
};
use num_rational::BigRational;
use num_traits::{One, Signed, Zero};
use ratpoly::{Budget, Polynomial, RationalFunction, Ring, resultant_within};
use std::cmp::Ordering;

/// The only extremum on the positive half-line of a letter.
pub(super) struct Extremum {
    minimum: bool,
    scope: Scope,
    /// The polynomial whose root it is.
    polynomial: Polynomial,
    closed: Option<ClosedForm>,
    /// The letter's value there, the others as in the reference.
    place: Option<Algebraic>,
    signs: Vec<SignCertificate>,
}

impl Extremum {
    fn fact(&self, letter: usize, other: bool) -> Fact {
        Fact::Extremum {
            letter,
            minimum: self.minimum,
            closed: self.closed.clone(),
            scope: self.scope.clone(),
            other,
        }
    }
}

impl Ground {
    /// The extremum in a letter that is open on both sides: everywhere, else at the reference values of
    /// the others.
    pub(super) fn extremum(&self, f: &RationalFunction, x: usize) -> Option<Extremum> {
        let derivative = f.derivative(x).ok()?;
        let range = self.range_of(x);
        if range.numbers != Numbers::Real {
            return None;
        }
        if *range == Range::positive() || (range.low.is_none() && range.high.is_none()) {
            self.extremum_everywhere(&derivative, x)
                .or_else(|| self.extremum_on_line(f, &derivative, x))
        } else {
            self.extremum_on_line(f, &derivative, x)
        }
    }

    fn extremum_everywhere(&self, derivative: &RationalFunction, x: usize) -> Option<Extremum> {
        let budget = Budget::default();
        let mut sign = Sign::Positive;
        let mut signs = Vec::new();
        let mut open: Option<Polynomial> = None;
        let product = derivative.numerator() * derivative.denominator();
        let factored = product.factor_within(&budget).ok()?;
        if factored.content.is_negative() {
            sign = Sign::Negative;
        }
        for (factor, multiplicity) in factored.factors {
            let study = self.sign(&RationalFunction::from(factor.clone()), &Scope::Everywhere);
            match study.sign {
                Some(definite @ (Sign::Positive | Sign::Negative)) => {
                    sign = times(sign, power(definite, multiplicity));
                    if study.certificate.as_ref().is_some_and(|c| {
                        coefficient_sign(c.function.numerator(), &self.positive).is_none()
                    }) {
                        signs.extend(study.certificate);
                    }
                }
                _ if multiplicity == 1 && open.is_none() => open = Some(factor),
                _ => return None,
            }
        }
        let open = open?;
        let coefficients = open.coefficients_in(x);
        // On the whole line Descartes' rule says nothing, but of a polynomial of degree one.
        if !self.range_of(x).is_positive() && coefficients.len() != 2 {
            return None;
        }
        let mut definite = Vec::new();
        let counts = |(k, c): &(usize, &Polynomial)| {
            !c.is_zero() && (self.range_of(x).is_positive() || *k == 1)
        };
        for (_, coefficient) in coefficients.iter().enumerate().filter(counts) {
            let study = self.sign(&coefficient.clone().into(), &Scope::Everywhere);
            match study.sign {
                Some(s @ (Sign::Positive | Sign::Negative)) => definite.push(s),
                _ => return None,
            }
            signs.extend(study.certificate);
        }
        let changes = definite.windows(2).filter(|w| w[0] != w[1]).count();
        if changes != 1 && self.range_of(x).is_positive() {
            return None;
        }
        // Beyond the root the polynomial has the sign of its leading coefficient.
        let rising = times(sign, *definite.last()?) == Sign::Positive;
        let place = self
            .restricted(&open.clone().into(), &[x])
            .and_then(|line| self.admitted_roots(line.numerator(), x))
            .and_then(|roots| roots.into_iter().next());
        Some(Extremum {
            minimum: rising,
            scope: Scope::Everywhere,
            closed: self.closed_form(&coefficients),
            polynomial: open,
            place,
            signs,
        })
    }

    fn extremum_on_line(
        &self,
        f: &RationalFunction,
        derivative: &RationalFunction,
        x: usize,
    ) -> Option<Extremum> {
        let line = self.restricted(f, &[x])?;
        let slope = self.restricted(derivative, &[x])?;
        for minimum in [true, false] {
            let Some(Least::At(place, _)) = self.least_on_line(&line, x, minimum) else {
                continue;
            };
            // Without other letters the line is everything.
            let alone = self.letters_in(f).iter().all(|l| *l == x);
            return Some(Extremum {
                minimum,
                scope: match alone {
                    true => Scope::Everywhere,
                    false => Scope::Line(x),
                },
                polynomial: slope.numerator().clone(),
                closed: None,
                place: Some(place),
                signs: Vec::new(),
            });
        }
        None
    }

    /// The roots that the letter may have as values.
    fn admitted_roots(&self, f: &Polynomial, x: usize) -> Option<Vec<Algebraic>> {
        if f.is_constant() {
            return Some(Vec::new());
        }
        let range = self.range_of(x);
        let mut roots = Algebraic::roots(f, x, &Budget::default()).ok()?;
        roots.retain(|root| {
            let low = range.low.as_ref().is_none_or(|end| {
                let order = root.compare_rational(&end.value);
                order.is_gt() || end.included && order.is_eq()
            });
            let high = range.high.as_ref().is_none_or(|end| {
                let order = root.compare_rational(&end.value);
                order.is_lt() || end.included && order.is_eq()
            });
            low && high
        });
        Some(roots)
    }

    /// The positive root of a polynomial of degree one or two with these coefficients.
    fn closed_form(&self, coefficients: &[Polynomial]) -> Option<ClosedForm> {
        let quotient = |a: &Polynomial, b: &Polynomial| RationalFunction::new(a.clone(), b.clone());
        let zero = RationalFunction::zero(self.ring);
        let one = RationalFunction::one(self.ring);
        match coefficients {
            [c, b] => Some(ClosedForm {
                rational: -quotient(c, b).ok()?,
                outside: zero,
                inside: one,
            }),
            [c, b, a] => {
                let twice = a.mul_integer(&2.into());
                let middle = -quotient(b, &twice).ok()?;
                let square = &middle * &middle - quotient(c, a).ok()?;
                let (outside, inside) = self.square_root(&square)?;
                Some(ClosedForm {
                    rational: middle,
                    outside,
                    inside,
                })
            }
            _ => None,
        }
    }

    /// `f = outside^2 inside` with an outside that is positive.
    fn square_root(&self, f: &RationalFunction) -> Option<(RationalFunction, RationalFunction)> {
        let budget = Budget::default();
        let mut parts = Vec::new();
        for polynomial in [f.numerator(), f.denominator()] {
            let factored = polynomial.factor_within(&budget).ok()?;
            let (root, rest) = square_part(&factored.content.abs());
            let mut outside = Polynomial::constant(self.ring, root);
            let mut inside = Polynomial::constant(self.ring, rest * factored.content.signum());
            for (factor, multiplicity) in factored.factors {
                if coefficient_sign(&factor, &self.positive) == Some(Sign::Positive) {
                    outside *= factor.pow(multiplicity / 2);
                    inside *= factor.pow(multiplicity % 2);
                } else {
                    inside *= factor.pow(multiplicity);
                }
            }
            parts.push((outside, inside));
        }
        let (bottom, top) = (parts.pop()?, parts.pop()?);
        Some((
            RationalFunction::new(top.0, bottom.0).ok()?,
            RationalFunction::new(top.1, bottom.1).ok()?,
        ))
    }

    /// The quantity at a letter's value over the quantity at another, the other letters as in the
    /// reference; letters without a reference value may cancel.
    fn quotient_at(
        &self,
        f: &RationalFunction,
        x: usize,
        above: &Algebraic,
        below: &Algebraic,
    ) -> Option<Algebraic> {
        let budget = Budget::default();
        // A second name for the letter.
        let mut names = self.ring.variables().to_vec();
        let mut spare = "elsewhere".to_string();
        while names.contains(&spare) {
            spare.push('_');
        }
        names.push(spare);
        let wide = Ring::new(names, self.ring.order()).ok()?;
        let y = self.reference.len();
        let known = self.letters_in(f).into_iter().filter(|l| *l != x);
        let images: Vec<(usize, RationalFunction)> = known
            .filter_map(|l| {
                let own = self.reference[l].clone()?;
                Some((l, RationalFunction::constant(self.ring, own)))
            })
            .collect();
        let f = f.substitute(&images).ok()?.to_ring(wide).ok()?;
        let renamed = f
            .substitute(&[(x, RationalFunction::variable(wide, y))])
            .ok()?;
        let quotient = f.checked_div(&renamed).ok()?;
        Algebraic::evaluate(
            &quotient,
            &[(x, above.clone()), (y, below.clone())],
            &budget,
        )
        .ok()
    }

    /// How far a value of the letter is from the extremum, relatively, and what that costs in terms of
    /// the modulus of the extreme value; each as far as it can be said.
    fn distance_and_loss(
        &self,
        f: &RationalFunction,
        x: usize,
        value: &Algebraic,
        place: &Algebraic,
    ) -> (Option<Algebraic>, Option<Algebraic>) {
        let budget = Budget::default();
        let less_one = |q: Algebraic| q.less_one(&budget).ok();
        let distance = match place.as_rational() {
            Some(zero) if zero.is_zero() => None,
            _ => value.divided_by(place, &budget).ok().and_then(less_one),
        };
        (distance, self.relative_excess(f, x, value, place))
    }

    /// The quantity at a value of the letter, less that at another one, over the modulus of that; none
    /// where that is zero or its sign is not known.
    fn relative_excess(
        &self,
        f: &RationalFunction,
        x: usize,
        above: &Algebraic,
        below: &Algebraic,
    ) -> Option<Algebraic> {
        let budget = Budget::default();
        let own = match self.restricted(f, &[x]) {
            Some(line) => {
                let value = self.value_at_place(&line, x, below)?;
                value.compare_rational(&BigRational::zero())
            }
            None => match self.sign(f, &Scope::Everywhere) {
                SignStudy {
                    sign: Some(Sign::Positive),
                    ..
                } => Ordering::Greater,
                SignStudy {
                    sign: Some(Sign::Negative),
                    ..
                } => Ordering::Less,
                _ => return None,
            },
        };
        let excess = self
            .quotient_at(f, x, above, below)?
            .less_one(&budget)
            .ok()?;
        match own {
            Ordering::Greater => Some(excess),
            Ordering::Equal => None,
            Ordering::Less => {
                let ring = Ring::new(["x"], self.ring.order()).ok()?;
                let minus = -RationalFunction::variable(ring, 0);
                Algebraic::evaluate(&minus, &[(0, excess)], &budget).ok()
            }
        }
    }

    /// What is known about the extremum in a letter.
    pub(super) fn extremum_facts(&self, f: &RationalFunction, x: usize, other: bool) -> Vec<Fact> {
        let Some(extremum) = self.extremum(f, x) else {
            return Vec::new();
        };
        let mut facts = vec![extremum.fact(x, other)];
        let Some(place) = extremum.place.clone().filter(|_| !other) else {
            return facts;
        };
        facts.push(Fact::Number(Measure::Stationary(x), place.clone()));
        if let Some(own) = self.reference[x].clone() {
            let (distance, loss) = self.distance_and_loss(f, x, &own.into(), &place);
            facts.extend(distance.map(|d| Fact::Number(Measure::Distance(x), d)));
            facts.extend(loss.map(|l| Fact::Number(Measure::Loss(x), l)));
        }
        facts
    }

    pub(super) fn has_extremum(&self, f: &RationalFunction, x: usize, minimum: bool) -> Found {
        let extremum = self.extremum(f, x);
        if let Some(extremum) = &extremum
            && extremum.minimum == minimum
            && extremum.scope == Scope::Everywhere
        {
            let mut found = Found::of(VerdictWord::Holds, self.extremum_facts(f, x, false));
            found.signs.clone_from(&extremum.signs);
            return found;
        }
        let facts = match &extremum {
            Some(_) => self.extremum_facts(f, x, false),
            None => Vec::new(),
        };
        let least = |point: &[Option<BigRational>]| {
            let line = self.restricted_at(f, x, point)?;
            self.least_on_line(&line, x, minimum)
        };
        match least(&self.reference) {
            Some(Least::AtSeveral | Least::Nowhere) if extremum.is_some() => {
                Found::of(VerdictWord::Refuted, facts)
            }
            Some(Least::AtSeveral | Least::Nowhere) => match self.no_extremum(f, x) {
                found if found.word == VerdictWord::Refuted => found,
                _ => Found::of(
                    VerdictWord::Refuted,
                    vec![Fact::NoExtremum(x, Scope::Line(x))],
                ),
            },
            Some(Least::At(..)) => {
                // At the reference values it is so; elsewhere it may be shown not to be.
                let elsewhere = self
                    .near_points(f, x)
                    .any(|point| matches!(least(&point), Some(Least::AtSeveral | Least::Nowhere)));
                match elsewhere {
                    true => Found::of(VerdictWord::Loose, facts),
                    false => Found::undecided(
                        "it is so at the reference values of the others; whether for all is out of \
                         reach",
                    )
                    .and(facts),
                }
            }
            None => match &extremum {
                // Falling first and rising then, on a range without ends, it is largest nowhere.
                Some(other) if other.minimum != minimum && other.scope == Scope::Everywhere => {
                    Found::of(VerdictWord::Refuted, facts)
                }
                _ => self.no_extremum(f, x),
            },
        }
    }

    /// A function of one letter, the others as in a point.
    fn restricted_at(
        &self,
        f: &RationalFunction,
        x: usize,
        point: &[Option<BigRational>],
    ) -> Option<RationalFunction> {
        let others = self.letters_in(f).into_iter().filter(|l| *l != x);
        let images = others
            .map(|l| {
                let value = point[l].clone()?;
                Some((l, RationalFunction::constant(self.ring, value)))
            })
            .collect::<Option<Vec<_>>>()?;
        f.substitute(&images).ok()
    }

    /// Points at which one of the other letters is a multiple of its reference value.
    fn near_points(
        &self,
        f: &RationalFunction,
        x: usize,
    ) -> impl Iterator<Item = Vec<Option<BigRational>>> + '_ {
        let others: Vec<usize> = (self.letters_in(f).into_iter())
            .filter(|l| *l != x && !self.admissible.is_drawn(*l))
            .collect();
        others.into_iter().flat_map(move |letter| {
            MULTIPLES.iter().filter_map(move |(n, d)| {
                let mut point = self.reference.clone();
                let value = point[letter].clone()? * BigRational::new((*n).into(), (*d).into());
                self.may_be(letter, &value).then(|| {
                    point[letter] = Some(value);
                    point
                })
            })
        })
    }

    /// No extremum was found: because there is none, or because it is out of reach.
    fn no_extremum(&self, f: &RationalFunction, x: usize) -> Found {
        let Ok(derivative) = f.derivative(x) else {
            return Found::undecided("the derivative is out of reach");
        };
        let range = self.range_of(x);
        let closed = [&range.low, &range.high]
            .into_iter()
            .flatten()
            .any(|end| end.included);
        for scope in [Scope::Everywhere, Scope::Line(x)] {
            let study = self.sign(&derivative, &scope);
            if let Some(sign) = study.sign.filter(|s| *s != Sign::Both)
                && !closed
                && study.poles.is_empty()
                && range.numbers == Numbers::Real
            {
                let mut found = Found::of(
                    VerdictWord::Refuted,
                    vec![
                        Fact::NoExtremum(x, scope.clone()),
                        Fact::Sign(Subject::Derivative(x), sign, scope),
                    ],
                );
                found.signs.extend(study.certificate);
                return found;
            }
        }
        Found::undecided("more than one stationary point, or none within reach")
    }

    /// Whether a polynomial vanishes at a value of a letter and at no other: what is left without that factor
    /// has no zero. Of a factor more than once it is not said.
    fn is_the_only_root(&self, p: &Polynomial, x: usize, value: &RationalFunction) -> bool {
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
            && self.is_the_only_root(&extremum.polynomial, x, formula)
            && self.lies_in_range(formula, x)
        {
            let mut found = Found::of(VerdictWord::Holds, vec![extremum.fact(x, false)]);
            found.signs.clone_from(&extremum.signs);
            return found;
        }
        let value = match &at {
            Some(formula) => self.at(formula),
            None => self.reference[x].clone(),
        };
        let Some(value) = value else {
            return match extremum {
                None => self.no_extremum(f, x),
                Some(_) => Found::undecided("there are no reference values"),
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
            Some(Least::AtSeveral | Least::Nowhere) => {
                return match self.no_extremum(f, x) {
                    found if found.word == VerdictWord::Refuted => found,
                    _ => facts(Found::of(VerdictWord::Refuted, Vec::new())),
                };
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
                match self.misses_somewhere(f, x, formula) {
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
    fn lies_in_range(&self, formula: &RationalFunction, x: usize) -> bool {
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

    /// Whether the derivative certainly does not vanish at a formula for some values of the letters.
    fn misses_somewhere(&self, f: &RationalFunction, x: usize, formula: &RationalFunction) -> bool {
        let there = f
            .derivative(x)
            .and_then(|slope| slope.substitute(&[(x, formula.clone())]));
        there.is_ok_and(|slope| {
            self.admissible
                .points(&slope)
                .any(|point| self.admissible.is_apart_from_zero(&slope, &point))
        })
    }

    /// The derivative at a value of the letter, which an extremum would make zero.
    fn slope_at(&self, f: &RationalFunction, x: usize, value: &BigRational) -> Option<Fact> {
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
    fn same_again(&self, f: &RationalFunction, x: usize, value: &BigRational) -> Option<Algebraic> {
        let here = self.with_value(f, x, value)?;
        let difference = self.restricted(&(f - &here), &[x])?;
        let roots = self.admitted_roots(difference.numerator(), x)?;
        let mut others = roots.into_iter().filter(|r| r.as_rational() != Some(value));
        let found = others.next()?;
        others.next().is_none().then_some(found)
    }

    fn with_value(
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
                let found = match self.no_extremum(f, x) {
                    found if found.word == VerdictWord::Refuted => found,
                    _ => Found::of(
                        VerdictWord::Refuted,
                        vec![Fact::NoExtremum(x, Scope::Line(x))],
                    ),
                };
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
        let constant = RationalFunction::constant(self.ring, own);
        let excess = f.substitute(&[(x, constant)]).map(|here| f - &here);
        let Ok(excess) = excess else {
            return Found::undecided("it has no value at the bound");
        };
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
        let coincide = resultant_within(&own.polynomial, &theirs.polynomial, x, &budget)
            .and_then(|r| r.factor_within(&budget));
        let mut together = false;
        if let (Ok(resultant), true) = (coincide, everywhere) {
            for (factor, _) in resultant.factors {
                let study = self.sign(&factor.clone().into(), &Scope::Everywhere);
                if !matches!(study.sign, Some(Sign::Positive | Sign::Negative)) {
                    together |= study.points.is_some();
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
