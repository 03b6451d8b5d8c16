//! Exact integrals by the shape of the integrand in the variable of integration.
//!
//! Powers of the variable have an antiderivative; an even rational function over the whole or half
//! axis goes by [spectral factorisation](crate::theory::spectral_factor) and the [Hurwitz
//! formula](crate::theory::hurwitz_integral); times a cosine by the [cosine
//! transform](crate::theory::cosine_transform), a constant giving pi times a Dirac distribution;
//! exponential polynomials go by undetermined coefficients (`exponential_integral`). An integral
//! that diverges is said to, with the reason.

use super::divergence::uncertain;
use super::{FunctionLetter, FunctionTable, Impossible, Possible};
use crate::domain::Symbolic;
use crate::model::range::Numbers;
use crate::theory::cosine_transform::correlation;
use crate::theory::hurwitz_integral::hurwitz_integral;
use crate::theory::spectral_factor::spectral_factor;
use num_rational::BigRational;
use num_traits::ToPrimitive;
use ratpoly::{Polynomial, RationalFunction};
use std::cmp::Ordering;

/// An end of an interval of integration.
#[derive(Clone, Debug, PartialEq)]
pub enum End<E> {
    /// Minus infinity.
    Below,
    /// An element.
    At(E),
    /// Infinity.
    Above,
}

impl<E> End<E> {
    /// The end with another element.
    pub fn map<F>(self, image: impl FnOnce(E) -> F) -> End<F> {
        match self {
            End::Below => End::Below,
            End::At(value) => End::At(image(value)),
            End::Above => End::Above,
        }
    }
}

/// `coefficient * variable^exponent`
pub(super) struct PowerTerm {
    pub coefficient: RationalFunction,
    pub exponent: RationalFunction,
}

/// `spectrum * cos(frequency * variable)`
#[derive(Clone)]
pub(super) struct Spectrum {
    pub spectrum: RationalFunction,
    pub frequency: RationalFunction,
}

/// One more than the highest power of a cosine in an integrand.
const MOST_ANGLES: usize = 9;

impl FunctionTable {
    /// The integral of an element over a variable, a letter of the ring.
    ///
    /// # Errors
    /// [`Impossible::Divergent`] with the reason, or what is outside of what is decided.
    pub fn integral(
        &self,
        integrand: &RationalFunction,
        variable: usize,
        from: &End<RationalFunction>,
        to: &End<RationalFunction>,
    ) -> Possible<RationalFunction> {
        if integrand.is_zero() {
            return Ok(integrand.clone());
        }
        let value = self.integral_by_shape(integrand, variable, from, to);
        match value {
            Err(Impossible::Divergent { reason, .. }) => {
                match self.has_no_principal_value(integrand, variable, from, to)? {
                    true => Err(Impossible::Divergent {
                        reason,
                        towards: self.grows_towards(integrand, from, to),
                    }),
                    false => Err(Impossible::unsupported(
                        "an integral that has a principal value at most",
                    )),
                }
            }
            value => value,
        }
    }

    pub(super) fn integral_by_shape(
        &self,
        integrand: &RationalFunction,
        variable: usize,
        from: &End<RationalFunction>,
        to: &End<RationalFunction>,
    ) -> Possible<RationalFunction> {
        if matches!(from, End::Above) || matches!(to, End::Below) {
            return Err(Impossible::unsupported(
                "limits from the upper to the lower",
            ));
        }
        if let Some(value) = self.integral_over_distribution(integrand, variable, from, to)? {
            return Ok(value);
        }
        let kernels = self.kernels(integrand, variable);
        let half = match (from, to) {
            (End::At(zero), End::Above) if zero.is_zero() => Some(true),
            (End::Below, End::Above) => Some(false),
            _ => None,
        };
        let powers_only = kernels.iter().all(|(_, f)| {
            matches!(f, FunctionLetter::Power(b, _)
                if *b == Polynomial::variable(self.ring, variable))
        });
        if powers_only && let Some(terms) = self.power_terms(integrand, variable)? {
            return match self.integral_of_powers(&terms, from, to) {
                Err(Impossible::Divergent { .. }) if !self.powers_diverge(&terms, from, to) => {
                    Err(uncertain())
                }
                value => value,
            };
        }
        if let Some(value) = self.with_modulus(integrand, variable, from, to)? {
            return Ok(value);
        }
        if !kernels.is_empty()
            && let Some(value) =
                self.integral_of_exponentials(integrand, variable, &kernels, from, to)?
        {
            return Ok(value);
        }
        let Some(half) = half else {
            return Err(Impossible::unsupported(
                "an integral of this integrand between these limits",
            ));
        };
        if kernels.is_empty() {
            let value = self.integral_of_spectrum(integrand, variable)?;
            return self.over_axis(&value, half);
        }
        self.integral_with_cosine(integrand, variable, &kernels, half)
    }

    /// An integral over a Dirac distribution of the variable: the value of its factor where it stands, if
    /// that is known to lie between the ends, nothing if it is known to lie outside.
    fn integral_over_distribution(
        &self,
        integrand: &RationalFunction,
        variable: usize,
        from: &End<RationalFunction>,
        to: &End<RationalFunction>,
    ) -> Possible<Option<RationalFunction>> {
        let found = self.distributions(integrand).into_iter();
        let mut found = found.filter(|(_, u)| self.letters_behind(u).contains(&variable));
        let Some((letter, argument)) = found.next() else {
            return Ok(None);
        };
        let beyond = || Impossible::unsupported("an integral over this distribution");
        let below = RationalFunction::from(integrand.denominator().clone());
        let parts = integrand.numerator().coefficients_in(letter);
        let [rest, factor] = parts.as_slice() else {
            return Err(beyond());
        };
        let over = |p: &Polynomial| RationalFunction::from(p.clone()).checked_div(&below);
        let (rest, factor) = (over(rest)?, over(factor)?);
        if !self.distributions(&factor).is_empty() {
            return Err(Impossible::unsupported("a product of distributions"));
        }
        let (place, slope) = self.simple_zero(&argument, variable).ok_or_else(beyond)?;
        // Whether it lies above the lower and below the upper end.
        let side = |end: &End<RationalFunction>| match end {
            End::Below => Some(Ordering::Greater),
            End::Above => Some(Ordering::Less),
            End::At(end) => self.sign(&(&place - end)),
        };
        let value = match (side(from), side(to)) {
            (Some(Ordering::Greater), Some(Ordering::Less)) => {
                let there = self.substitute(&factor, &[(variable, place)])?;
                there.checked_div(&self.absolute(&slope)?)?
            }
            (Some(Ordering::Greater), Some(Ordering::Greater))
            | (Some(Ordering::Less), Some(Ordering::Less)) => self.integer(0),
            _ => {
                return Err(Impossible::unsupported(
                    "an integral whose ends are not known to lie apart from a distribution's place",
                ));
            }
        };
        let rest = self.integral(&rest, variable, from, to)?;
        Ok(Some(self.reduce(&value + &rest)))
    }

    /// An integral over the whole axis in which the variable's modulus occurs: one over each half.
    fn with_modulus(
        &self,
        integrand: &RationalFunction,
        variable: usize,
        from: &End<RationalFunction>,
        to: &End<RationalFunction>,
    ) -> Possible<Option<RationalFunction>> {
        let x = self.variable(variable);
        let root = FunctionLetter::Root(x.numerator() * x.numerator());
        let modulus = self
            .letters_behind(integrand)
            .into_iter()
            .find(|letter| self.meaning(*letter).as_ref() == Some(&root));
        let Some(modulus) = modulus.filter(|_| (from, to) == (&End::Below, &End::Above)) else {
            return Ok(None);
        };
        let mut sum = self.integer(0);
        for side in [x.clone(), -&x] {
            let half = self.substitute(integrand, &[(modulus, x.clone()), (variable, side)])?;
            sum = &sum + &self.integral(&half, variable, &End::At(self.integer(0)), &End::Above)?;
        }
        Ok(Some(self.reduce(sum)))
    }

    /// The functions of the variable that occur.
    fn kernels(
        &self,
        integrand: &RationalFunction,
        variable: usize,
    ) -> Vec<(usize, FunctionLetter)> {
        let mut letters = integrand.numerator().variables_occurring();
        letters.extend(integrand.denominator().variables_occurring());
        self.all()
            .into_iter()
            .filter(|(letter, _)| {
                *letter != variable
                    && letters.contains(letter)
                    && self
                        .letters_behind(&self.variable(*letter))
                        .contains(&variable)
            })
            .collect()
    }

    /// `pi value` over the half axis, twice that over the whole.
    fn over_axis(&self, value: &RationalFunction, half: bool) -> Possible<RationalFunction> {
        let pi = self.pi()?;
        let value = value * &pi;
        Ok(self.reduce(if half { value } else { &value + &value }))
    }

    /// An integrand as a sum of powers of the variable, if it is one.
    fn power_terms(
        &self,
        integrand: &RationalFunction,
        variable: usize,
    ) -> Possible<Option<Vec<PowerTerm>>> {
        let powers: Vec<(usize, RationalFunction)> = self
            .kernels(integrand, variable)
            .into_iter()
            .filter_map(|(letter, f)| Some((letter, f.as_power()?.1.clone())))
            .collect();
        if powers
            .iter()
            .any(|(_, e)| self.letters_behind(e).contains(&variable))
        {
            return Ok(None);
        }
        // The denominator must be one power times what is free of the variable.
        let exponents = |p: &Polynomial| -> Vec<(Vec<u32>, Polynomial)> {
            let mut parts: Vec<(Vec<u32>, super::TermList)> = Vec::new();
            for (monomial, c) in p.terms() {
                let mut rest = monomial.exponents().to_vec();
                let mut key = vec![std::mem::take(&mut rest[variable])];
                key.extend(powers.iter().map(|(l, _)| std::mem::take(&mut rest[*l])));
                match parts.iter_mut().find(|(k, _)| *k == key) {
                    Some((_, terms)) => terms.push((rest, c)),
                    None => parts.push((key, vec![(rest, c)])),
                }
            }
            parts
                .into_iter()
                .filter_map(|(k, terms)| Some((k, Polynomial::from_terms(self.ring, terms).ok()?)))
                .collect()
        };
        let below = exponents(integrand.denominator());
        let [(low, divisor)] = below.as_slice() else {
            return Ok(None);
        };
        let number =
            |n: i64| RationalFunction::constant(self.ring, BigRational::from_integer(n.into()));
        let mut terms = Vec::new();
        for (high, coefficient) in exponents(integrand.numerator()) {
            let at = |k: usize| i64::from(high[k]) - i64::from(low[k]);
            let mut exponent = number(at(0));
            for (k, (_, e)) in powers.iter().enumerate() {
                exponent = &exponent + &(&number(at(k + 1)) * e);
            }
            let coefficient = RationalFunction::new(coefficient, divisor.clone())?;
            terms.push(PowerTerm {
                coefficient,
                exponent,
            });
        }
        Ok(Some(terms))
    }

    fn integral_of_powers(
        &self,
        terms: &[PowerTerm],
        from: &End<RationalFunction>,
        to: &End<RationalFunction>,
    ) -> Possible<RationalFunction> {
        let one = RationalFunction::one(self.ring);
        let mut sum = RationalFunction::zero(self.ring);
        if let (End::At(zero), End::Above, [_]) = (from, to, terms)
            && zero.is_zero()
        {
            return Err(Impossible::divergent(
                "no power is integrable over the whole half axis",
            ));
        }
        for term in terms {
            let next = &term.exponent + &one;
            let upper = self.antiderivative(&next, to)?;
            let lower = self.antiderivative(&next, from)?;
            let difference = if next.is_zero() {
                &upper - &lower
            } else {
                (&upper - &lower).checked_div(&next)?
            };
            sum = &sum + &(&term.coefficient * &difference);
        }
        Ok(self.reduce(sum))
    }

    /// `x^exponent` at an end, `ln x` for the exponent 0.
    fn antiderivative(
        &self,
        exponent: &RationalFunction,
        end: &End<RationalFunction>,
    ) -> Possible<RationalFunction> {
        let sign = self.sign(exponent);
        let whole = exponent.as_constant().filter(|n| n.is_integer());
        let natural = whole
            .and_then(|n| n.to_integer().to_i64())
            .filter(|n| *n > 0);
        let unknown =
            || Impossible::unsupported("an integral whose convergence depends on its letters");
        let zero = RationalFunction::zero(self.ring);
        let diverges = |at: &str| {
            Err(Impossible::divergent(&format!(
                "the integrand is not integrable towards {at}"
            )))
        };
        match (end, sign) {
            (End::Below, _) => diverges("minus infinity"),
            (End::Above, Some(Ordering::Less)) => Ok(zero),
            (End::Above, Some(_)) => diverges("infinity"),
            (End::Above, None) => Err(unknown()),
            (End::At(x), _) if natural.is_some() => self.power_of(x, natural.unwrap_or(0)),
            (End::At(x), Some(Ordering::Greater)) if x.is_zero() => Ok(zero),
            (End::At(x), Some(_)) if x.is_zero() => diverges("zero"),
            (End::At(x), None) if x.is_zero() => Err(unknown()),
            (End::At(x), _) if !self.is_positive(x) => Err(Impossible::unsupported(
                "an integral of a power between limits that are not known to be positive",
            )),
            (End::At(x), Some(Ordering::Equal)) => self.logarithm(x),
            (End::At(x), _) => self.power(x, exponent),
        }
    }

    /// `(1/2 pi) int_-oo^oo spectrum d variable` of an even rational function.
    fn integral_of_spectrum(
        &self,
        spectrum: &RationalFunction,
        variable: usize,
    ) -> Possible<RationalFunction> {
        let degree = |p: &Polynomial| i64::from(p.degree(variable).unwrap_or(0));
        let excess = degree(spectrum.denominator()) - degree(spectrum.numerator());
        let factor = spectral_factor(self, spectrum, variable);
        let pole = matches!(factor, Err(Impossible::Divergent { .. }));
        if (excess < 2 || pole) && !self.quotient_diverges(spectrum, variable)? {
            return Err(match pole {
                true => Impossible::unsupported("an integral over a pole"),
                false => uncertain(),
            });
        }
        if excess < 2 && !pole {
            return Err(Impossible::divergent(match excess {
                1 => "the integrand falls off no faster than the reciprocal of the variable",
                0 => "the integrand does not vanish at infinity",
                _ => "the integrand grows towards infinity",
            }));
        }
        let factor = factor?;
        let field = Symbolic::with_functions(self.clone());
        hurwitz_integral(&field, &factor.stable, &factor.numerator)
            .ok_or_else(|| Impossible::unsupported("this integral"))
    }

    /// `A + B cos(k variable)`, also with multiple angles, which powers of the cosine are: A must be integrable by itself,
    /// B has a cosine transform; poles of both that cancel are taken out before. Over the whole axis nothing is left of a sine beside an even factor.
    fn integral_with_cosine(
        &self,
        integrand: &RationalFunction,
        variable: usize,
        kernels: &[(usize, FunctionLetter)],
        half: bool,
    ) -> Possible<RationalFunction> {
        let beyond = || Impossible::unsupported("an integral of this integrand");
        let angle = kernels.iter().find_map(|(_, f)| f.as_circular());
        let angle = angle.ok_or_else(beyond)?.clone();
        let same = kernels.iter().all(|(_, f)| f.as_circular() == Some(&angle));
        let frequency = angle.checked_div(&self.variable(variable))?;
        if !same || self.letters_behind(&frequency).contains(&variable) {
            return Err(beyond());
        }
        let below = integrand.denominator();
        if kernels.iter().any(|(l, _)| below.degree(*l) > Some(0)) {
            return Err(beyond());
        }
        let below: RationalFunction = below.clone().into();
        let over = |p: &Polynomial| RationalFunction::from(p.clone()).checked_div(&below);
        let mut cosine = None;
        let mut parts = vec![integrand.numerator().clone()];
        for (letter, function) in kernels {
            match function.as_cosine() {
                Some(_) => cosine = Some(*letter),
                None => parts = parts[0].coefficients_in(*letter),
            }
        }
        let powers = |p: &Polynomial| match cosine {
            Some(letter) => p.coefficients_in(letter),
            None => vec![p.clone()],
        };
        let has_sine = match parts.as_slice() {
            [_] => false,
            [_, beside] => {
                for factor in powers(beside) {
                    let spectrum = over(&factor)?;
                    if half || !is_even(&spectrum, variable) || !self.is_real(&frequency) {
                        return Err(beyond());
                    }
                    self.vanishing_with_sine(&spectrum, variable, &frequency)?;
                }
                true
            }
            _ => return Err(beyond()),
        };
        let powers = powers(&parts[0])
            .iter()
            .map(over)
            .collect::<std::result::Result<Vec<_>, _>>()?;
        if powers.len() > MOST_ANGLES {
            return Err(beyond());
        }
        let mut spectra = self.multiple_angles(&powers);
        let rest = spectra.remove(0);
        let alone = rest.is_zero() && !has_sine;
        let spectra: Vec<Spectrum> = (1_i64..)
            .zip(spectra)
            .filter(|(_, spectrum)| !spectrum.is_zero())
            .map(|(multiple, spectrum)| Spectrum {
                frequency: self.reduce(&self.integer(multiple) * &frequency),
                spectrum,
            })
            .collect();
        if alone
            && !self.distributions
            && let [one] = spectra.as_slice()
            && let Some(reason) = self.cosine_diverges(&one.spectrum, variable)?
        {
            return Err(Impossible::divergent(reason));
        }
        let sum = self
            .cosines_and_rest(&rest, &spectra, variable)
            .map_err(|why| match why {
                Impossible::Divergent { .. } => uncertain(),
                why @ (Impossible::Unsupported(_)
                | Impossible::DivisionByZero
                | Impossible::NoLetter) => why,
            })?;
        self.over_axis(&sum, half)
    }

    /// That an even factor of the odd sine has an integral by itself, or as a distribution: then the two have
    /// none but zero over the whole axis.
    fn vanishing_with_sine(
        &self,
        spectrum: &RationalFunction,
        variable: usize,
        frequency: &RationalFunction,
    ) -> Possible<()> {
        let (_, proper) = self.white_part(spectrum, variable, frequency)?;
        if proper.is_zero() {
            return Ok(());
        }
        match self.integral_of_spectrum(&proper, variable) {
            // Where the frequency vanishes the sine does, too.
            Err(Impossible::Divergent { .. }) => Err(uncertain()),
            value => value.map(|_| ()),
        }
    }

    /// Why `B cos(k variable)` certainly has no integral over the axis, whatever k.
    fn cosine_diverges(
        &self,
        spectrum: &RationalFunction,
        variable: usize,
    ) -> Possible<Option<&'static str>> {
        let degree = |p: &Polynomial| p.degree(variable).unwrap_or(0);
        let (above, below) = (spectrum.numerator(), spectrum.denominator());
        let never = |p: Option<&Polynomial>| {
            p.is_some_and(|p| self.never_vanishes(&RationalFunction::from(p.clone())))
        };
        let coefficients = above.coefficients_in(variable);
        if degree(above) >= degree(below) && never(coefficients.last()) {
            return Ok(Some(match degree(above) > degree(below) {
                true => "the integrand grows towards infinity",
                false => "the integrand oscillates without end",
            }));
        }
        // The cosine is one where its argument is zero.
        let pole = below.coefficients_in(variable);
        let pole = pole.first().is_some_and(Polynomial::is_zero);
        Ok((pole && never(coefficients.first())).then_some("the integrand has a pole at zero"))
    }

    /// The coefficients of 1, cos x, cos 2x and so on of a polynomial in cos x.
    fn multiple_angles(&self, powers: &[RationalFunction]) -> Vec<RationalFunction> {
        // By Horner's scheme, with 2 cos x cos kx = cos (k + 1)x + cos (k - 1)x.
        let half = RationalFunction::constant(self.ring, BigRational::new(1.into(), 2.into()));
        let mut sum = vec![self.integer(0); powers.len().max(1)];
        for power in powers.iter().rev() {
            let mut next = vec![self.integer(0); sum.len()];
            for (k, c) in sum.iter().enumerate().filter(|(_, c)| !c.is_zero()) {
                match k {
                    0 => next[1] = &next[1] + c,
                    _ => {
                        let c = &half * c;
                        next[k - 1] = &next[k - 1] + &c;
                        next[k + 1] = &next[k + 1] + &c;
                    }
                }
            }
            next[0] = &next[0] + power;
            sum = next;
        }
        sum
    }

    /// `1/pi` times the integral of A and several `B cos(k variable)` over the half axis.
    fn cosines_and_rest(
        &self,
        rest: &RationalFunction,
        spectra: &[Spectrum],
        variable: usize,
    ) -> Possible<RationalFunction> {
        let regular = self.without_removable_poles(rest, spectra, variable)?;
        let mut sum = regular.value;
        for one in regular.spectra.iter().filter(|s| !s.spectrum.is_zero()) {
            sum = &sum + &self.cosine_integral(&one.spectrum, variable, &one.frequency)?;
        }
        if !regular.rest.is_zero() {
            sum = &sum + &self.integral_of_spectrum(&regular.rest, variable)?;
        }
        Ok(self.reduce(sum))
    }

    /// What a spectrum tends to at infinity, which is white, and the rest of it, which decays.
    fn white_part(
        &self,
        spectrum: &RationalFunction,
        variable: usize,
        frequency: &RationalFunction,
    ) -> Possible<(RationalFunction, RationalFunction)> {
        let degree = |p: &Polynomial| p.degree(variable).unwrap_or(0);
        let (above, below) = (degree(spectrum.numerator()), degree(spectrum.denominator()));
        if above < below {
            return Ok((self.integer(0), spectrum.clone()));
        }
        // A distribution in the frequency, which letters stand for. At a number, also at one with a letter of its own, the
        // oscillation goes on for ever.
        if above > below || !self.distributions || !self.is_continuous(frequency) {
            return Err(Impossible::unsupported(
                "an integral of what does not decay",
            ));
        }
        let last = |p: &Polynomial| -> RationalFunction {
            let mut coefficients = p.coefficients_in(variable);
            coefficients
                .pop()
                .unwrap_or_else(|| Polynomial::zero(self.ring))
                .into()
        };
        let white = last(spectrum.numerator()).checked_div(&last(spectrum.denominator()))?;
        let proper = self.reduce(spectrum - &white);
        Ok((white, proper))
    }

    /// Whether a frequency is made of real letters.
    fn is_continuous(&self, frequency: &RationalFunction) -> bool {
        let behind = self.letters_behind(frequency);
        let mut declared = behind.iter().filter(|letter| **letter < self.first);
        let real = |letter: &usize| self.ranges[*letter].numbers == Numbers::Real;
        declared.clone().next().is_some() && declared.all(real)
    }

    fn cosine_integral(
        &self,
        spectrum: &RationalFunction,
        variable: usize,
        frequency: &RationalFunction,
    ) -> Possible<RationalFunction> {
        let (white, proper) = self.white_part(spectrum, variable, frequency)?;
        let mut value = RationalFunction::zero(self.ring);
        if !white.is_zero() {
            value = &white * &self.dirac(frequency)?;
        }
        if !proper.is_zero() {
            let factor = spectral_factor(self, &proper, variable)?;
            let time = self.absolute(frequency)?;
            value = &value + &correlation(self, &factor, &time)?;
        }
        Ok(value)
    }
}

pub(super) fn is_even(f: &RationalFunction, variable: usize) -> bool {
    let parity = |p: &Polynomial, odd: usize| {
        let coefficients = p.coefficients_in(variable);
        coefficients
            .iter()
            .skip(odd)
            .step_by(2)
            .all(Polynomial::is_zero)
    };
    [0, 1]
        .iter()
        .any(|odd| parity(f.numerator(), *odd) && parity(f.denominator(), *odd))
}
