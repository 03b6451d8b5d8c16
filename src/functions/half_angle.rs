//! Signs of polynomials in the cosine and sine of an angle by the tangent t of half of it.
//!
//! cos u = (1 - t^2)/(1 + t^2) and sin u = 2t/(1 + t^2) with a real t reach every point of the circle but (-1, 0), which is
//! looked at apart: so sin u + cos u <= 2^{1/2}, where the ranges of cosine and sine on their own are not enough.

use super::sign::{Sign, SignCertificate, SignFact};
use super::{FunctionLetter, FunctionTable};
use ratpoly::{Polynomial, RationalFunction};

/// The number of the letter t among variables of integration: no integral is as deep.
const FIRST: usize = 2_000;
/// Longer polynomials are not looked at.
const LONG: usize = 12;
/// Nor those of greater degree in cosine and sine.
const DEGREE: u32 = 6;

impl FunctionTable {
    /// The sign of a polynomial in a sine and the cosine of the same angle.
    pub(super) fn sign_by_half_angles(
        &self,
        p: &Polynomial,
        depth: usize,
    ) -> Option<SignCertificate> {
        if p.len() > LONG {
            return None;
        }
        let occurring = p.variables_occurring();
        for sine in &occurring {
            let sine = *sine;
            let Some(FunctionLetter::Sine(angle, cosine)) = self.meaning(sine) else {
                continue;
            };
            // One angle only: with several the degrees multiply.
            let other = |l: &usize| match self.meaning(*l) {
                Some(FunctionLetter::Sine(..)) => *l != sine,
                Some(FunctionLetter::Cosine(_)) => *l != cosine,
                None
                | Some(
                    FunctionLetter::Pi
                    | FunctionLetter::ImaginaryUnit
                    | FunctionLetter::Exponential(_)
                    | FunctionLetter::Root(_)
                    | FunctionLetter::Power(..)
                    | FunctionLetter::Logarithm(_)
                    | FunctionLetter::Dirac(_)
                    | FunctionLetter::Bound { .. },
                ) => false,
            };
            if occurring.iter().any(other) {
                return None;
            }
            let degree = |l: usize| p.degree(l).unwrap_or(0);
            if !self.is_real(&angle) || degree(sine) + degree(cosine) > DEGREE {
                continue;
            }
            let letter = FunctionLetter::Bound {
                depth: FIRST + depth,
                positive: false,
            };
            let t = self.letter_value(letter).ok()?;
            let one = self.integer(1);
            let square = &t * &t;
            let below = (&one + &square).inverse().ok()?;
            let put = |c: RationalFunction, s: RationalFunction| {
                let images = [(cosine, c), (sine, s)];
                let there = RationalFunction::from(p.clone()).substitute(&images).ok()?;
                // The denominator is a power of 1 + t^2, or a number.
                Some(self.reduce(there.numerator().clone().into()))
            };
            let there = put(
                &(&one - &square) * &below,
                &(&self.integer(2) * &t) * &below,
            )?;
            let Some(found) = self.sign_within(&there, depth - 1) else {
                continue;
            };
            let left = put(-&one, self.integer(0))?;
            let left = self.sign_within(&left, depth - 1);
            // By continuity the sign is the same there, or zero.
            let sign = match (found.sign, left.map(|l| l.sign)) {
                (Sign::Positive, Some(Sign::Positive)) => Sign::Positive,
                (Sign::Negative, Some(Sign::Negative)) => Sign::Negative,
                (Sign::Positive | Sign::NotNegative, _) => Sign::NotNegative,
                (Sign::Negative | Sign::NotPositive, _) => Sign::NotPositive,
                (Sign::Zero, _) => continue,
            };
            let mut facts = found.facts;
            facts.push(SignFact::HalfAngle(there));
            return Some(SignCertificate::new(sign, facts));
        }
        None
    }
}
