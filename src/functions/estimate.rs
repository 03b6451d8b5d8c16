//! Signs by estimates of functions: 1 + u <= e^u, 1 - 1/p <= ln p <= p - 1, u - u^3/6 <= sin u <= u for u >= 0,
//! 1 - u^2/2 <= cos u <= 1 - u^2/2 + u^4/24 (Taylor's theorem with Lagrange's remainder), ln q < ln p and q^e < p^e for
//! q < p and e > 0; sums of logarithms by the product of their arguments.
//!
//! A function is its estimate and a rest that is not negative: the function's letter stands for the rest then. In place
//! of e^u its reciprocal e^{-u} may be estimated: e^u is positive, so that a polynomial in it has the
//! sign of that in the reciprocal with the coefficients in the opposite order.

use super::sign::{Sign, SignCertificate, SignFact};
use super::{FunctionLetter, FunctionTable};
use crate::model::range::Range;
use num_bigint::BigInt;
use num_integer::Integer;
use num_rational::BigRational;
use num_traits::{Signed, ToPrimitive, Zero};
use ratpoly::{Budget, Polynomial, RationalFunction};
use std::collections::BTreeMap;

/// The greatest factor of a logarithm in a sum of them, and number beside them.
const LARGEST: i64 = 8;

/// Functions in longer polynomials are not estimated.
const LONG: usize = 20;

/// What the sign with one estimate may cost: there are many of them.
fn budget() -> Budget {
    Budget::new(1_000, 300, 300_000)
}

/// What a function is by an estimate.
struct Estimate {
    /// In the letter of the function, which stands for the rest.
    image: RationalFunction,
    /// Whether the rest is never zero.
    strict: bool,
    /// Which power of the letter is estimated.
    power: usize,
    /// Whether it is the reciprocal that is estimated.
    reciprocal: bool,
}

impl FunctionTable {
    /// With a letter in terms of its estimate and a rest that is not negative.
    pub(super) fn sign_by_estimates(
        &self,
        p: &Polynomial,
        ranges: &BTreeMap<usize, Range>,
    ) -> Option<SignCertificate> {
        let occurring = p.variables_occurring();
        if p.len() > LONG {
            return None;
        }
        for letter in &occurring {
            for estimate in self.estimates(p, *letter, &occurring) {
                let found = self.sign_by_estimate(p, *letter, estimate, ranges);
                if found.is_some() {
                    return found;
                }
            }
        }
        None
    }

    fn sign_by_estimate(
        &self,
        p: &Polynomial,
        letter: usize,
        estimate: Estimate,
        ranges: &BTreeMap<usize, Range>,
    ) -> Option<SignCertificate> {
        let before = self.with_power(p, letter, estimate.power, estimate.reciprocal)?;
        let image = RationalFunction::from(before)
            .substitute(&[(letter, estimate.image.clone())])
            .ok()?;
        let mut ranges = ranges.clone();
        let mut rest = Range::default();
        rest.raise(BigRational::zero(), !estimate.strict);
        ranges.insert(letter, rest);
        let mut sign = Sign::Positive;
        for part in [image.numerator(), image.denominator()] {
            for l in part.variables_occurring() {
                if !self.is_real_letter(l) {
                    return None;
                }
                ranges.entry(l).or_insert_with(|| self.letter_range(l));
            }
            sign = sign.times(self.sign_on_box_within(part, &ranges, &budget())?);
        }
        // The denominator is no free choice here: it must not vanish.
        let below = self.sign_on_box_within(image.denominator(), &ranges, &budget());
        if !matches!(below, Some(Sign::Positive | Sign::Negative)) {
            return None;
        }
        let mut facts: Vec<SignFact> = ranges
            .into_iter()
            .filter(|(l, _)| *l != letter)
            .map(|(l, r)| SignFact::Range(l, r))
            .collect();
        facts.push(SignFact::Estimate { letter, image });
        Some(SignCertificate::new(sign, facts))
    }

    /// A polynomial in a power of a letter, times a power of the reciprocal if it is in that.
    fn with_power(
        &self,
        p: &Polynomial,
        letter: usize,
        power: usize,
        reciprocal: bool,
    ) -> Option<Polynomial> {
        if power == 1 && !reciprocal {
            return Some(p.clone());
        }
        let variable = Polynomial::variable(self.ring, letter);
        let mut coefficients: Vec<Polynomial> = p
            .coefficients_in(letter)
            .into_iter()
            .step_by(power)
            .collect();
        if reciprocal {
            coefficients.reverse();
        }
        let mut sum = Polynomial::zero(self.ring);
        for (k, coefficient) in coefficients.iter().enumerate() {
            let power = variable.try_pow(u32::try_from(k).ok()?).ok()?;
            sum = &sum + &(coefficient * &power);
        }
        Some(sum)
    }

    /// What a letter is in terms of how far it is from its estimates, for which the letter itself stands.
    fn estimates(&self, p: &Polynomial, letter: usize, occurring: &[usize]) -> Vec<Estimate> {
        let one = self.integer(1);
        let rest = self.variable(letter);
        let strict = |f: &RationalFunction| {
            matches!(self.known_sign(f), Some(Sign::Positive | Sign::Negative))
        };
        let plain = |image: RationalFunction, strict: bool| Estimate {
            image,
            strict,
            power: 1,
            reciprocal: false,
        };
        let over = |f: &RationalFunction, n: i64| {
            f * &RationalFunction::constant(self.ring, BigRational::new(1.into(), n.into()))
        };
        match self.meaning(letter) {
            Some(FunctionLetter::Exponential(u)) => {
                // e^{nu} is estimated where all powers of the letter are powers of that.
                let coefficients = p.coefficients_in(letter);
                let occur = (1..coefficients.len()).filter(|k| !coefficients[*k].is_zero());
                let power = occur.fold(0, |n: usize, k| n.gcd(&k)).max(1);
                let times = i64::try_from(power).unwrap_or(1);
                let u = &u * &self.integer(times);
                let sign = self.known_sign(&u);
                let strict = matches!(sign, Some(Sign::Positive | Sign::Negative));
                let mut all = Vec::new();
                for reciprocal in [false, true] {
                    // e^v, the letter or its reciprocal.
                    let (v, sign) = match reciprocal {
                        false => (u.clone(), sign),
                        true => (-&u, sign.map(Sign::reversed)),
                    };
                    let square = over(&(&v * &v), 2);
                    let first = &one + &v;
                    let second = &first + &square;
                    let third = &second + &over(&(&(&v * &v) * &v), 6);
                    let mut add = |image: RationalFunction| {
                        all.push(Estimate {
                            image,
                            strict,
                            power,
                            reciprocal,
                        });
                    };
                    add(&first + &rest);
                    match sign {
                        Some(Sign::Positive | Sign::NotNegative) => {
                            add(&second + &rest);
                            add(&third + &rest);
                        }
                        Some(Sign::Negative | Sign::NotPositive) => {
                            add(&second - &rest);
                            add(&third + &rest);
                        }
                        Some(Sign::Zero) | None => add(&third + &rest),
                    }
                }
                all
            }
            Some(FunctionLetter::Logarithm(argument)) => {
                let own = RationalFunction::from(argument);
                let away = strict(&(&own - &one));
                let mut all = vec![plain(&(&own - &one) - &rest, away)];
                if let Ok(inverse) = own.inverse() {
                    all.push(plain(&(&one - &inverse) + &rest, away));
                }
                // ln of a product is the sum of those of its factors.
                if let Some((product, others)) = self.product_of_logarithms(p, letter, occurring) {
                    let away = strict(&(&product - &one));
                    let first = &(&product - &one) - &others;
                    all.push(plain(&first - &rest, away));
                    if let Ok(inverse) = product.inverse() {
                        let first = &(&one - &inverse) - &others;
                        all.push(plain(&first + &rest, away));
                    }
                }
                for other in occurring {
                    if let Some(FunctionLetter::Logarithm(q)) = self.meaning(*other)
                        && *other != letter
                    {
                        let sign = self.known_sign(&(&own - &RationalFunction::from(q)));
                        all.extend(self.beside(letter, *other, sign));
                    }
                }
                all
            }
            Some(FunctionLetter::Power(base, exponent)) => {
                let mut all = Vec::new();
                for other in occurring {
                    if let Some(FunctionLetter::Power(own, other_exponent)) = self.meaning(*other)
                        && *other != letter
                        && other_exponent == exponent
                    {
                        let bases = &RationalFunction::from(base.clone()) - &own.into();
                        let signs = self.known_sign(&bases).zip(self.known_sign(&exponent));
                        all.extend(self.beside(letter, *other, signs.map(|(b, e)| b.times(e))));
                    }
                }
                all
            }
            Some(FunctionLetter::Sine(u, _)) => {
                let cubic = &u - &over(&(&(&u * &u) * &u), 6);
                let strictly = strict(&u);
                match self.known_sign(&u) {
                    Some(Sign::Positive | Sign::NotNegative) => {
                        vec![plain(&u - &rest, strictly), plain(&cubic + &rest, strictly)]
                    }
                    Some(Sign::Negative | Sign::NotPositive) => {
                        vec![plain(&u + &rest, strictly), plain(&cubic - &rest, strictly)]
                    }
                    Some(Sign::Zero) | None => Vec::new(),
                }
            }
            Some(FunctionLetter::Cosine(u)) => {
                let square = &u * &u;
                let second = &one - &over(&square, 2);
                let fourth = &second + &over(&(&square * &square), 24);
                vec![
                    plain(&second + &rest, strict(&u)),
                    plain(&fourth - &rest, strict(&u)),
                ]
            }
            None
            | Some(
                FunctionLetter::Pi
                | FunctionLetter::ImaginaryUnit
                | FunctionLetter::Root(_)
                | FunctionLetter::Dirac(_)
                | FunctionLetter::Bound { .. },
            ) => Vec::new(),
        }
    }

    /// Where a polynomial is n (ln p + k ln q + ...) and a rest without logarithms: p q^k ..., and k ln q + ...
    /// as letters, for the letter ln p.
    fn product_of_logarithms(
        &self,
        p: &Polynomial,
        letter: usize,
        occurring: &[usize],
    ) -> Option<(RationalFunction, RationalFunction)> {
        let coefficient = |l: usize| match &p.coefficients_in(l)[..] {
            [_, slope] => slope.as_constant(),
            _ => None,
        };
        let own = coefficient(letter)?;
        let mut product = self.integer(1);
        let mut others = self.integer(0);
        for l in occurring {
            let Some(FunctionLetter::Logarithm(argument)) = self.meaning(*l) else {
                continue;
            };
            let times = coefficient(*l)?;
            if !(&times % &own).is_zero() {
                return None;
            }
            let times = (&times / &own).to_i64().filter(|n| n.abs() <= LARGEST)?;
            product = &product * &self.power_of(&argument.into(), times).ok()?;
            if *l != letter {
                others = &others + &(&self.integer(times) * &self.variable(*l));
            }
        }
        Some((product, others))
    }

    /// A letter as another one and a rest, where the sign of their difference is known.
    fn beside(&self, letter: usize, other: usize, sign: Option<Sign>) -> Option<Estimate> {
        let (other, rest) = (self.variable(other), self.variable(letter));
        let (image, strict) = match sign? {
            Sign::Positive => (&other + &rest, true),
            Sign::NotNegative => (&other + &rest, false),
            Sign::Negative => (&other - &rest, true),
            Sign::NotPositive => (&other - &rest, false),
            Sign::Zero => return None,
        };
        Some(Estimate {
            image,
            strict,
            power: 1,
            reciprocal: false,
        })
    }

    /// n_1 ln p_1 + ... + c, with integers, has the sign of the product of the powers p^n and e^c, those with
    /// positive exponents less those with negative ones.
    pub(super) fn sign_by_logarithms(
        &self,
        p: &Polynomial,
        depth: usize,
    ) -> Option<SignCertificate> {
        let mut above = self.integer(1);
        let mut below = self.integer(1);
        let mut logarithms = 0;
        for (monomial, coefficient) in p.terms() {
            let n = coefficient.to_i64().filter(|n| n.abs() <= LARGEST)?;
            let exponents = monomial.exponents();
            let mut letters = (0..exponents.len()).filter(|l| exponents[*l] > 0);
            let base = match (letters.next(), letters.next()) {
                (None, _) => self.exponential(&self.integer(1)).ok()?,
                (Some(letter), None) if exponents[letter] == 1 => match self.meaning(letter) {
                    Some(FunctionLetter::Logarithm(argument)) => {
                        logarithms += 1;
                        argument.into()
                    }
                    _ => return None,
                },
                (Some(_), _) => return None,
            };
            let power = self.power_of(&base, n.abs()).ok()?;
            match coefficient > BigInt::zero() {
                true => above = &above * &power,
                false => below = &below * &power,
            }
        }
        if logarithms == 0 {
            return None;
        }
        let difference = self.reduce(&above - &below);
        let mut found = self.sign_within(&difference, depth - 1)?;
        found.facts.push(SignFact::Logarithms(difference));
        Some(found)
    }
}
