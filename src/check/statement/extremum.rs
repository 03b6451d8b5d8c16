//! Extrema over the range of one letter.
//!
//! On the positive half-line:
//! The derivative's numerator, freed from factors of one sign, is a polynomial in the letter whose
//! coefficients are functions of the others. If these have definite signs with exactly one change,
//! it has exactly one positive root, a simple one, for all values of the others (Descartes 1637),
//! and the quantity one extremum, which is global. Otherwise the same is asked at the reference
//! values of the others.

use super::line::Least;
use super::sign::MULTIPLES;
use super::{Found, Ground};
use crate::document::VerdictWord;
use crate::model::range::{Numbers, Range};
use crate::theory::algebraic::{Algebraic, square_part};
use crate::verdict::statement::{
    ClosedForm, Fact, Measure, Scope, Sign, SignCertificate, Subject, coefficient_sign, power,
    times,
};
use num_rational::BigRational;
use num_traits::Signed;
use ratpoly::{Budget, Polynomial, RationalFunction};

/// The only extremum over the range of a letter.
pub(super) struct Extremum {
    pub(super) minimum: bool,
    pub(super) scope: Scope,
    /// The polynomial whose only root in the range it is; none where it is at an end of the range, at
    /// which no derivative need vanish, or where there are other roots.
    pub(super) polynomial: Option<Polynomial>,
    /// Whether it is at an end of the range.
    pub(super) at_end: bool,
    closed: Option<ClosedForm>,
    /// The letter's value there, the others as in the reference.
    pub(super) place: Option<Algebraic>,
    pub(super) signs: Vec<SignCertificate>,
}

impl Extremum {
    pub(super) fn fact(&self, letter: usize, other: bool) -> Fact {
        Fact::Extremum {
            letter,
            minimum: self.minimum,
            closed: self.closed.clone(),
            scope: self.scope.clone(),
            at_end: self.at_end,
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

    pub(super) fn extremum_everywhere(
        &self,
        derivative: &RationalFunction,
        x: usize,
    ) -> Option<Extremum> {
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
            polynomial: Some(open),
            at_end: false,
            place,
            signs,
        })
    }

    pub(super) fn extremum_on_line(
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
            let at_end = self.is_an_end(&place, x);
            let roots = match at_end {
                true => None,
                false => self.admitted_roots(slope.numerator(), x),
            };
            let only = roots.is_some_and(|roots| roots == [place.clone()]);
            return Some(Extremum {
                minimum,
                at_end,
                scope: match alone {
                    true => Scope::Everywhere,
                    false => Scope::Line(x),
                },
                polynomial: only.then(|| slope.numerator().clone()),
                closed: None,
                place: Some(place),
                signs: Vec::new(),
            });
        }
        None
    }

    /// Whether a number is an end of the range of a letter that belongs to it.
    pub(super) fn is_an_end(&self, place: &Algebraic, x: usize) -> bool {
        let range = self.range_of(x);
        [&range.low, &range.high]
            .into_iter()
            .flatten()
            .any(|end| end.included && place.compare_rational(&end.value).is_eq())
    }

    /// The roots that the letter may have as values.
    pub(super) fn admitted_roots(&self, f: &Polynomial, x: usize) -> Option<Vec<Algebraic>> {
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
    pub(super) fn closed_form(&self, coefficients: &[Polynomial]) -> Option<ClosedForm> {
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
    pub(super) fn square_root(
        &self,
        f: &RationalFunction,
    ) -> Option<(RationalFunction, RationalFunction)> {
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
            Some(found @ (Least::AtSeveral | Least::Nowhere)) => {
                self.not_once(f, x, minimum, &found).and(facts)
            }
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
    pub(super) fn restricted_at(
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
    pub(super) fn near_points(
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

    /// What is least (largest) at several values of the letter or at none, and why.
    pub(super) fn not_once(
        &self,
        f: &RationalFunction,
        x: usize,
        minimum: bool,
        least: &Least,
    ) -> Found {
        let several = match least {
            Least::AtSeveral => true,
            Least::Nowhere => false,
            Least::At(..) => return Found::undecided("it is so at one value of the letter"),
        };
        let alone = self.letters_in(f).iter().all(|l| *l == x);
        let fact = Fact::NotOnce {
            letter: x,
            minimum,
            several,
            scope: match alone {
                true => Scope::Everywhere,
                false => Scope::Line(x),
            },
        };
        match self.no_extremum(f, x) {
            found if found.word == VerdictWord::Refuted => found.and([fact]),
            _ => Found::of(VerdictWord::Refuted, vec![fact]),
        }
    }

    /// No extremum was found: because there is none, or because it is out of reach.
    pub(super) fn no_extremum(&self, f: &RationalFunction, x: usize) -> Found {
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
                let mut facts = Vec::new();
                // What only does not change its sign may vanish, as that of x^3 does at 0.
                if matches!(sign, Sign::Positive | Sign::Negative) {
                    facts.push(Fact::NoExtremum(x, scope.clone()));
                }
                facts.push(Fact::Sign(Subject::Derivative(x), sign, scope));
                let mut found = Found::of(VerdictWord::Refuted, facts);
                found.signs.extend(study.certificate);
                return found;
            }
        }
        Found::undecided("more than one stationary point, or none within reach")
    }
}
