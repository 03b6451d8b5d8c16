//! Extrema on the positive half-line of one letter.
//!
//! The derivative's numerator, freed from factors of one sign, is a polynomial in the letter whose
//! coefficients are functions of the others. If these have definite signs with exactly one change,
//! it has exactly one positive root, a simple one, for all values of the others (Descartes 1637),
//! and the quantity one extremum, which is global. Otherwise the same is asked at the reference
//! values of the others.

use super::{Found, Ground};
use crate::document::VerdictWord;
use crate::model::statement::Proposition;
use crate::theory::algebraic::{Algebraic, square_part};
use crate::verdict::statement::{
    ClosedForm, Fact, Measure, Scope, Sign, SignCertificate, Subject, coefficient_sign, power,
    times,
};
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Signed, Zero};
use ratpoly::{Budget, Polynomial, RationalFunction, Ring, resultant_within};

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
    /// The extremum in a letter: everywhere, else at the reference values of the others.
    pub(super) fn extremum(&self, f: &RationalFunction, x: usize) -> Option<Extremum> {
        let derivative = f.derivative(x).ok()?;
        self.extremum_everywhere(&derivative, x)
            .or_else(|| self.extremum_on_line(&derivative, x))
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
        let mut definite = Vec::new();
        for coefficient in coefficients.iter().filter(|c| !c.is_zero()) {
            let study = self.sign(&coefficient.clone().into(), &Scope::Everywhere);
            match study.sign {
                Some(s @ (Sign::Positive | Sign::Negative)) => definite.push(s),
                _ => return None,
            }
            signs.extend(study.certificate);
        }
        let changes = definite.windows(2).filter(|w| w[0] != w[1]).count();
        if changes != 1 {
            return None;
        }
        // Beyond the root the polynomial has the sign of its leading coefficient.
        let rising = times(sign, *definite.last()?) == Sign::Positive;
        let place = self
            .restricted(&open.clone().into(), &[x])
            .and_then(|line| self.positive_roots(line.numerator(), x))
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

    fn extremum_on_line(&self, derivative: &RationalFunction, x: usize) -> Option<Extremum> {
        let line = self.restricted(derivative, &[x])?;
        let denominator = RationalFunction::from(line.denominator().clone());
        match self.sign(&denominator, &Scope::Line(x)).sign {
            Some(Sign::Positive | Sign::Negative) => {}
            _ => return None,
        }
        let roots = self.positive_roots(line.numerator(), x)?;
        let [place] = <[Algebraic; 1]>::try_from(roots).ok()?;
        let side = |value: BigRational| {
            let mut point = self.reference.clone();
            point[x] = Some(value);
            self.at_point(&line, &point)
        };
        let (low, high) = place.enclosure(&BigRational::one()).ok()?;
        let below = side((low / BigInt::from(2)).max(BigRational::zero()))?;
        let above = side(high + BigRational::one())?;
        if below.is_zero() || below.is_positive() == above.is_positive() {
            return None;
        }
        Some(Extremum {
            minimum: above.is_positive(),
            scope: Scope::Line(x),
            polynomial: line.numerator().clone(),
            closed: None,
            place: Some(place),
            signs: Vec::new(),
        })
    }

    fn positive_roots(&self, f: &Polynomial, x: usize) -> Option<Vec<Algebraic>> {
        if f.is_constant() {
            return Some(Vec::new());
        }
        let mut roots = Algebraic::roots(f, x, &Budget::default()).ok()?;
        roots.retain(Algebraic::is_positive);
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

    /// How far a value of the letter is from the extremum, and what that costs.
    fn distance_and_loss(
        &self,
        f: &RationalFunction,
        x: usize,
        value: &Algebraic,
        place: &Algebraic,
    ) -> Option<(Algebraic, Algebraic)> {
        let budget = Budget::default();
        let distance = value
            .divided_by(place, &budget)
            .ok()?
            .less_one(&budget)
            .ok()?;
        let loss = self
            .quotient_at(f, x, value, place)?
            .less_one(&budget)
            .ok()?;
        Some((distance, loss))
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
        if let Some(own) = self.reference[x].clone()
            && let Some((distance, loss)) = self.distance_and_loss(f, x, &own.into(), &place)
        {
            facts.push(Fact::Number(Measure::Distance(x), distance));
            facts.push(Fact::Number(Measure::Loss(x), loss));
        }
        facts
    }

    pub(super) fn has_extremum(&self, f: &RationalFunction, x: usize, minimum: bool) -> Found {
        match self.extremum(f, x) {
            Some(extremum) if extremum.minimum == minimum => {
                let word = match extremum.scope {
                    Scope::Everywhere => VerdictWord::Holds,
                    _ => VerdictWord::Loose,
                };
                let mut found = Found::of(word, self.extremum_facts(f, x, false));
                found.signs = extremum.signs;
                found
            }
            Some(_) => Found::of(VerdictWord::Refuted, self.extremum_facts(f, x, false)),
            None => self.no_extremum(f, x),
        }
    }

    /// No extremum was found: because there is none, or because it is out of reach.
    fn no_extremum(&self, f: &RationalFunction, x: usize) -> Found {
        let Ok(derivative) = f.derivative(x) else {
            return Found::undecided("the derivative is out of reach");
        };
        for scope in [Scope::Everywhere, Scope::Line(x)] {
            let study = self.sign(&derivative, &scope);
            if let Some(sign) = study.sign.filter(|s| *s != Sign::Both) {
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

    pub(super) fn extremal_at(
        &self,
        f: &RationalFunction,
        x: usize,
        minimum: bool,
        at: Option<RationalFunction>,
        p: &Proposition,
    ) -> Found {
        let Some(extremum) = self.extremum(f, x) else {
            return self.no_extremum(f, x);
        };
        if extremum.minimum != minimum {
            return Found::of(VerdictWord::Refuted, self.extremum_facts(f, x, false));
        }
        let fact = extremum.fact(x, false);
        // A formula for the place that makes the derivative vanish for all values of the letters.
        if let Some(formula) = &at
            && extremum.scope == Scope::Everywhere
            && !self.letters_in(formula).contains(&x)
            && let Ok(inserted) = RationalFunction::from(extremum.polynomial.clone())
                .substitute(&[(x, formula.clone())])
            && inserted.is_zero()
            && self.sign(formula, &Scope::Everywhere).sign == Some(Sign::Positive)
        {
            let mut found = Found::of(VerdictWord::Holds, vec![fact]);
            found.signs = extremum.signs;
            return found;
        }
        let value = match &at {
            Some(formula) => self.at(formula),
            None => self.reference[x].clone(),
        };
        let (Some(value), Some(place)) = (value, extremum.place) else {
            return Found::undecided("there are no reference values");
        };
        let measured = self.distance_and_loss(f, x, &value.clone().into(), &place);
        let Some((distance, loss)) = measured else {
            return Found::undecided("the extremum is out of reach");
        };
        let negative = -p.tolerance.clone();
        let near = distance.compare_rational(&p.tolerance).is_le()
            && distance.compare_rational(&negative).is_ge();
        let distance_is_zero = distance.as_rational().is_some_and(Zero::is_zero);
        let word = match distance.as_rational() {
            // A number is right at the reference values; a formula would have to be so everywhere.
            Some(zero) if zero.is_zero() => match &at {
                Some(formula) if formula.as_constant().is_none() => VerdictWord::Loose,
                _ => VerdictWord::Holds,
            },
            _ if near => VerdictWord::Loose,
            _ => VerdictWord::Refuted,
        };
        let mut facts = vec![
            Fact::Number(Measure::Distance(x), distance),
            Fact::Number(Measure::Loss(x), loss),
            fact,
            Fact::Number(Measure::Stationary(x), place),
        ];
        if word != VerdictWord::Holds {
            facts.extend(self.slope_at(f, x, &value));
            if let Some(again) = self.same_again(f, x, &value) {
                facts.push(Fact::Number(Measure::SameAgain(x), again));
            }
        }
        let mut found = Found::of(word, facts);
        if near && !distance_is_zero {
            found = found.nearly();
        }
        found.signs = extremum.signs;
        found
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
        let roots = self.positive_roots(difference.numerator(), x)?;
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
        let Some(extremum) = self.extremum(f, x) else {
            return self.no_extremum(f, x).and(self.elasticity_facts(f, x, p));
        };
        let fact = extremum.fact(x, false);
        let value = match &at {
            Some(formula) => self.at(formula),
            None => self.reference[x].clone(),
        };
        let measured = match (value, &extremum.place) {
            (Some(value), Some(place)) => self.distance_and_loss(f, x, &value.into(), place),
            _ => None,
        };
        let (Some((distance, loss)), Some(place)) = (measured, extremum.place) else {
            return Found::undecided("there are no reference values");
        };
        let word = if extremum.minimum && loss.compare_rational(&p.tolerance).is_le() {
            VerdictWord::Holds
        } else {
            VerdictWord::Refuted
        };
        let mut found = Found::of(
            word,
            vec![
                Fact::Number(Measure::Loss(x), loss),
                Fact::Number(Measure::Distance(x), distance),
                fact,
                Fact::Number(Measure::Stationary(x), place),
            ],
        );
        found.signs = extremum.signs;
        found
    }

    /// If a letter cannot be less than its reference value, that value is the best one.
    pub(super) fn least_at_bound(&self, f: &RationalFunction, x: usize) -> Found {
        let (Ok(derivative), Some(own)) = (f.derivative(x), self.reference[x].clone()) else {
            return Found::undecided("there is no reference value");
        };
        let subject = Subject::Derivative(x);
        let everywhere = Scope::Above(x, own.clone());
        let line = Scope::LineAbove(x, own);
        let study = self.sign(&derivative, &everywhere);
        if study.sign == Some(Sign::Positive) {
            let fact = Fact::Sign(subject, Sign::Positive, everywhere);
            let mut found = Found::of(VerdictWord::Holds, vec![fact]);
            found.signs.extend(study.certificate);
            return found;
        }
        let inner = self.sign(&derivative, &line);
        let Some(sign) = inner.sign else {
            return Found::undecided("the sign of the derivative is out of reach");
        };
        let word = if sign == Sign::Positive {
            VerdictWord::Loose
        } else {
            VerdictWord::Refuted
        };
        let mut found = Found::of(word, vec![Fact::Sign(subject, sign, line)]);
        found.signs.extend(inner.certificate);
        if !study.boundary.is_empty() {
            found.facts.push(Fact::Boundary(subject, study.boundary));
        }
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
        if sign == Sign::Positive {
            found
        } else {
            found.and(self.extremum_facts(f, x, false))
        }
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
        let worse = self
            .quotient_at(f, x, there, here)
            .and_then(|q| q.less_one(&Budget::default()).ok());
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
        // The two minima coincide where the resultant vanishes.
        let everywhere = own.scope == Scope::Everywhere && theirs.scope == Scope::Everywhere;
        let budget = Budget::default();
        let coincide = resultant_within(&own.polynomial, &theirs.polynomial, x, &budget)
            .and_then(|r| r.factor_within(&budget));
        let mut word = if everywhere {
            VerdictWord::Holds
        } else {
            VerdictWord::Loose
        };
        let mut signs = own.signs;
        signs.extend(theirs.signs);
        match coincide {
            Ok(resultant) if everywhere => {
                for (factor, _) in resultant.factors {
                    let study = self.sign(&factor.clone().into(), &Scope::Everywhere);
                    match study.sign {
                        Some(Sign::Positive | Sign::Negative) => signs.extend(study.certificate),
                        _ => {
                            word = VerdictWord::Loose;
                            facts.push(Fact::Boundary(Subject::Difference, vec![factor]));
                        }
                    }
                }
            }
            _ => word = VerdictWord::Loose,
        }
        let mut found = Found::of(word, facts);
        found.signs = signs;
        found
    }
}
