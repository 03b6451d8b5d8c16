//! Half turns by an integer: cos nπ = (-1)^n, sin nπ = 0 for a letter n that stands for integers.
//!
//! The letter of cos(π p), p a product of integer letters, is the sign (-1)^p: its square is 1, its
//! sine is 0, and an even multiple of the angle is a whole number of turns. A power of a negative
//! number with an integer exponent is that sign times the power of its modulus.

use super::elementary::Term;
use super::{FunctionLetter, FunctionTable, Impossible, Possible};
use crate::model::range::Numbers;
use num_integer::Integer;
use ratpoly::{Polynomial, RationalFunction};
use std::cmp::Ordering;

impl FunctionTable {
    /// Whether an element has integer values only: a polynomial in integer letters.
    pub(super) fn is_integer(&self, f: &RationalFunction) -> bool {
        let integer = |letter: &usize| {
            let range = self.ranges.get(*letter);
            range.is_some_and(|r| r.numbers == Numbers::Integer)
        };
        f.is_polynomial() && f.numerator().variables_occurring().iter().all(integer)
    }

    /// p of an angle π p that is a half turn so many times.
    fn half_turns(&self, angle: &RationalFunction) -> Option<RationalFunction> {
        let pi = self
            .all()
            .into_iter()
            .find(|(_, f)| *f == FunctionLetter::Pi);
        let (pi, _) = pi?;
        if angle.numerator().degree(pi) != Some(1) {
            return None;
        }
        let times = angle.checked_div(&self.variable(pi)).ok()?;
        (times.as_constant().is_none() && self.is_integer(&times)).then_some(times)
    }

    /// Cosine and sine of a term that is an integer multiple of a half turn.
    pub(super) fn sign_of_half_turns(
        &self,
        term: &Term,
    ) -> Possible<Option<(RationalFunction, RationalFunction)>> {
        let Some(times) = self
            .half_turns(&term.atom)
            .filter(|_| term.number.is_integer())
        else {
            return Ok(None);
        };
        let cosine = match term.number.numer().is_even() {
            true => self.integer(1),
            false => {
                let angle = &self.pi()? * &self.of_same_parity(&times)?;
                self.letter_value(FunctionLetter::Cosine(angle))?
            }
        };
        Ok(Some((self.reduce(cosine), self.integer(0))))
    }

    /// A product of integer letters without their powers: n^2 is even where n is.
    fn of_same_parity(&self, times: &RationalFunction) -> Possible<RationalFunction> {
        let terms = times.numerator().terms().map(|(monomial, coefficient)| {
            let exponents = monomial.exponents().iter();
            (exponents.map(|e| (*e).min(1)).collect(), coefficient)
        });
        let terms: super::TermList = terms.collect();
        Ok(match terms.len() {
            1 => Polynomial::from_terms(self.ring, terms)?.into(),
            _ => times.clone(),
        })
    }

    /// i^exponent where the exponent is 2p or 2p + 1 with a p that has integer values only: (-1)^p or i (-1)^p.
    pub(super) fn power_of_imaginary_unit(
        &self,
        base: &RationalFunction,
        exponent: &RationalFunction,
    ) -> Possible<Option<RationalFunction>> {
        let Some(unit) = self.imaginary_letter().map(|i| self.variable(i)) else {
            return Ok(None);
        };
        if *base != unit || !self.is_integer(exponent) {
            return Ok(None);
        }
        let constant = exponent.numerator().coefficient(&vec![0; self.ring.len()]);
        let odd = constant.is_odd();
        let even = if odd {
            exponent - &self.integer(1)
        } else {
            exponent.clone()
        };
        let half = even.checked_div(&self.integer(2))?;
        let Some(sign) = self.power_of_minus_one(&half)? else {
            return Ok(None);
        };
        Ok(Some(if odd { &sign * &unit } else { sign }))
    }

    /// Whether a letter is the cosine of half turns: no other cosine has a square of its own.
    pub(super) fn is_sign_of_half_turns(&self, letter: usize, function: &FunctionLetter) -> bool {
        matches!(function, FunctionLetter::Cosine(_))
            && self.quadratics().iter().any(|q| q.letter == letter)
    }

    /// The square of the cosine of half turns.
    pub(super) fn square_of_sign(&self, angle: &RationalFunction) -> Option<Polynomial> {
        let half = self.half_turns(angle)?;
        let one = half.numerator().content() == 1.into() && half.denominator().is_one();
        one.then(|| Polynomial::one(self.ring))
    }

    /// Refuses a coefficient of an antiderivative that may have a pole at integers: what follows from it
    /// elsewhere says nothing there, as the integral of cos nx from 0 to π vanishes but for n = 0. Of a
    /// real letter the value at such a point is the limit.
    pub(super) fn refuse_integer_poles(&self, coefficient: &RationalFunction) -> Possible<()> {
        let below = RationalFunction::from(coefficient.denominator().clone());
        let integer = |letter: &usize| self.is_integer(&self.variable(*letter));
        if !below.numerator().variables_occurring().iter().any(integer) {
            return Ok(());
        }
        for (factor, _) in self.split(&below)?.factors {
            let letters = factor.variables_occurring();
            let number = |letter: &usize| integer(letter) || self.is_number(*letter);
            if letters.iter().any(integer)
                && letters.iter().all(number)
                && !matches!(
                    self.sign(&factor.into()),
                    Some(Ordering::Less | Ordering::Greater)
                )
            {
                return Err(Impossible::unsupported(
                    "an integral with another value where an integer letter makes a divisor vanish",
                ));
            }
        }
        Ok(())
    }

    /// (-1)^exponent, where the exponent has integer values only.
    pub(super) fn power_of_minus_one(
        &self,
        exponent: &RationalFunction,
    ) -> Possible<Option<RationalFunction>> {
        if !self.is_integer(exponent) {
            return Ok(None);
        }
        let angle = exponent * &self.pi()?;
        Ok(Some(self.cosine_and_sine(&angle)?.0))
    }
}
