//! Square roots and moduli.
//!
//! The root sign means the principal root: sqrt(gu) = sqrt(g) sqrt(u) and sqrt(g^2) = g for g >= 0 and any
//! complex u, sqrt(p^2 u) = |p| sqrt(u) for real p. What is known not to be negative gets a root of its own;
//! the rest stays together under one root, whose only known relation is its square. A root over roots is
//! taken in the [tower](super::tower) where it has one, or by sqrt(a + b sqrt r) = sqrt((a + d)/2) +-
//! sqrt((a - d)/2), d^2 = a^2 - b^2 r, where both radicands are known not to be negative.

use super::elementary::prime_factors;
use super::{FunctionLetter, FunctionTable, Impossible, Possible, Sign, square_root_of};
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::Signed;
use ratpoly::{Polynomial, RationalFunction};

/// How deep nested roots are taken apart.
const DEEPEST: usize = 6;

impl FunctionTable {
    /// `|f|`.
    ///
    /// # Errors
    /// For what may be complex, but for roots and what has the imaginary unit in it.
    pub fn absolute(&self, f: &RationalFunction) -> Possible<RationalFunction> {
        let f = &self.reduce(f.clone());
        match self.known_sign(f) {
            Some(sign) if sign.is_not_negative() => return Ok(f.clone()),
            Some(_) => return Ok(-f),
            None => {}
        }
        if self
            .imaginary_letter()
            .is_some_and(|i| f.numerator().degree(i) > Some(0))
        {
            let (real, imaginary) = self.real_and_imaginary(f)?;
            return self.square_root(&self.reduce(&(&real * &real) + &(&imaginary * &imaginary)));
        }
        let split = self.split(f)?;
        let mut value = self.constant(split.content.abs());
        for (factor, multiplicity) in split.factors {
            let magnitude = self.magnitude(&factor, multiplicity % 2 == 0, DEEPEST)?;
            value = self.reduce(&value * &self.power_of(&magnitude, multiplicity)?);
        }
        Ok(value)
    }

    /// The modulus of an irreducible polynomial; where only its square is wanted, itself if it is real.
    fn magnitude(
        &self,
        factor: &Polynomial,
        squared: bool,
        depth: usize,
    ) -> Possible<RationalFunction> {
        let value = RationalFunction::from(factor.clone());
        match self.known_sign(&value) {
            Some(sign) if sign.is_not_negative() => return Ok(value),
            Some(_) => return Ok(-&value),
            None => {}
        }
        if self.is_real(&value) {
            if squared {
                return Ok(value);
            }
            let square = self.reduce(&value * &value);
            if !square.is_polynomial() {
                return Err(Impossible::unsupported("this modulus"));
            }
            // A square that is written otherwise in the letters has its own root letters.
            let plain = *square.numerator() == factor * factor;
            return match plain || depth == 0 {
                true => self.root_letter(square.numerator()),
                false => self.nested_root(&square, depth - 1),
            };
        }
        // |sqrt p| = sqrt |p| for every complex p.
        if let [letter] = factor.variables_occurring()[..]
            && *factor == Polynomial::variable(self.ring, letter)
            && let Some(FunctionLetter::Root(radicand)) = self.meaning(letter)
        {
            return self.square_root(&self.absolute(&radicand.into())?);
        }
        Err(Impossible::unsupported(
            "the modulus of something that is not known to be real",
        ))
    }

    /// The principal root.
    ///
    /// # Errors
    /// For what has the imaginary unit or a distribution in it, and a complex divisor.
    pub fn square_root(&self, f: &RationalFunction) -> Possible<RationalFunction> {
        self.nested_root(&self.reduce(f.clone()), DEEPEST)
    }

    fn nested_root(&self, f: &RationalFunction, depth: usize) -> Possible<RationalFunction> {
        if f.is_zero() {
            return Ok(f.clone());
        }
        let letters = f.numerator().variables_occurring();
        let never = |l: &usize| {
            matches!(
                self.meaning(*l),
                Some(FunctionLetter::ImaginaryUnit | FunctionLetter::Dirac(_))
            )
        };
        if letters.iter().any(never) {
            return Err(Impossible::unsupported("the root of a complex number"));
        }
        if let Some(root) = self.denested(f, depth)? {
            return Ok(root);
        }
        let split = self.split(f)?;
        let mut value = self.integer(1);
        // sqrt(p/q) = sqrt(p q)/q for the rational number in front.
        let content = split.content.numer() * split.content.denom();
        value = &value * &self.constant(BigRational::new(1.into(), split.content.denom().clone()));
        // What may vanish stays together where letters have relations: (1 - cos x)(1 + cos x) is a square.
        let mut weak = Polynomial::one(self.ring);
        let mut unknown = Polynomial::one(self.ring);
        if content.is_negative() {
            unknown = -unknown;
        }
        for (prime, multiplicity) in prime_factors(&content.abs())? {
            let base = self.constant(BigRational::from_integer(prime.clone()));
            value = self.reduce(&value * &self.power_of(&base, multiplicity / 2)?);
            if multiplicity % 2 == 1 {
                let root = self.root_letter(&Polynomial::constant(self.ring, prime))?;
                value = self.reduce(&value * &root);
            }
        }
        for (factor, multiplicity) in split.factors {
            let base: RationalFunction = factor.clone().into();
            if !self.is_real(&base) {
                if multiplicity < 0 {
                    return Err(Impossible::unsupported(
                        "the root of a quotient that is not known to be real",
                    ));
                }
                let power = u32::try_from(multiplicity).unwrap_or(0);
                unknown = &unknown * &factor.try_pow(power)?;
                continue;
            }
            let half = multiplicity.div_euclid(2);
            let magnitude = self.magnitude(&factor, half % 2 == 0, depth)?;
            value = self.reduce(&value * &self.power_of(&magnitude, half)?);
            if multiplicity.rem_euclid(2) == 0 {
                continue;
            }
            match self.known_sign(&base) {
                Some(Sign::Positive) => {
                    value = self.reduce(&value * &self.simple_root(&factor, depth)?);
                }
                Some(Sign::Negative) => {
                    value = self.reduce(&value * &self.simple_root(&-factor, depth)?);
                    unknown = -unknown;
                }
                Some(Sign::NotNegative) if self.is_free(&factor) => {
                    value = self.reduce(&value * &self.root_letter(&factor)?);
                }
                Some(Sign::NotPositive) if self.is_free(&factor) => {
                    value = self.reduce(&value * &self.root_letter(&-factor)?);
                    unknown = -unknown;
                }
                Some(Sign::NotNegative | Sign::Zero) => weak = &weak * &factor,
                Some(Sign::NotPositive) => {
                    weak = -(&weak * &factor);
                    unknown = -unknown;
                }
                None => unknown = &unknown * &factor,
            }
        }
        if !weak.is_one() {
            value = self.reduce(&value * &self.simple_root(&weak, depth)?);
        }
        if unknown == -Polynomial::one(self.ring) {
            value = self.reduce(&value * &self.imaginary_unit()?);
        } else if !unknown.is_one() {
            value = self.reduce(&value * &self.root_letter(&unknown)?);
        }
        Ok(value)
    }

    /// Whether no letter of known square is in a polynomial: where it is irreducible it is no factor of a
    /// square in which others stand but once.
    fn is_free(&self, p: &Polynomial) -> bool {
        let quadratics = self.quadratics();
        let letters = p.variables_occurring();
        !quadratics.iter().any(|q| letters.contains(&q.letter))
    }

    /// The root of a polynomial that is not negative and no product.
    fn simple_root(&self, p: &Polynomial, depth: usize) -> Possible<RationalFunction> {
        match self.denested(&p.clone().into(), depth)? {
            Some(root) => Ok(root),
            None => self.root_letter(p),
        }
    }

    fn root_letter(&self, radicand: &Polynomial) -> Possible<RationalFunction> {
        self.letter_value(FunctionLetter::Root(radicand.clone()))
    }

    /// The root of something with roots in it, where it has one with fewer roots within roots.
    fn denested(&self, f: &RationalFunction, depth: usize) -> Possible<Option<RationalFunction>> {
        let quadratic = self.quadratics();
        let nested = f
            .numerator()
            .variables_occurring()
            .into_iter()
            .rev()
            .find(|l| {
                quadratic.iter().any(|q| q.letter == *l)
                    && matches!(self.meaning(*l), Some(FunctionLetter::Root(_)))
            });
        let sines = f
            .numerator()
            .variables_occurring()
            .into_iter()
            .any(|l| matches!(self.meaning(l), Some(FunctionLetter::Sine(..))));
        if nested.is_none() && !sines || depth == 0 || !self.is_real(f) {
            return Ok(None);
        }
        if let Some(root) = self.root_in_tower(f)
            && self.is_real(&root)
        {
            match self.known_sign(&root) {
                Some(sign) if sign.is_not_negative() => return Ok(Some(root)),
                Some(_) => return Ok(Some(-&root)),
                // |root|, whose letter is the root of its square: found without this.
                None => return Ok(None),
            }
        }
        let Some(letter) = nested else {
            return Ok(None);
        };
        let Some(FunctionLetter::Root(radicand)) = self.meaning(letter) else {
            return Ok(None);
        };
        let parts = f.numerator().coefficients_in(letter);
        let [a, b] = parts.as_slice() else {
            return Ok(None);
        };
        let below = RationalFunction::from(f.denominator().clone());
        let [a, b] = [a, b].map(|p| RationalFunction::from(p.clone()).checked_div(&below));
        let (a, b) = (a?, b?);
        let square = RationalFunction::from(radicand);
        let norm = self.reduce(&(&a * &a) - &(&(&b * &b) * &square));
        let is_known = |f: &RationalFunction| self.known_sign(f);
        let Some(d) = self.root_of_square(&norm) else {
            return Ok(None);
        };
        let d = match is_known(&d) {
            Some(sign) if sign.is_not_negative() => d,
            Some(_) => -&d,
            None => return Ok(None),
        };
        let half = self.constant(BigRational::new(1.into(), 2.into()));
        let (larger, smaller) = (&(&a + &d) * &half, &(&a - &d) * &half);
        let (Some(first), Some(second), Some(sign)) =
            (is_known(&larger), is_known(&smaller), is_known(&b))
        else {
            return Ok(None);
        };
        if !first.is_not_negative() || !second.is_not_negative() {
            return Ok(None);
        }
        let larger = self.nested_root(&larger, depth - 1)?;
        let smaller = self.nested_root(&smaller, depth - 1)?;
        let root = if sign.is_not_negative() {
            self.reduce(&larger + &smaller)
        } else {
            self.reduce(&larger - &smaller)
        };
        Ok((self.reduce(&root * &root) == *f).then_some(root))
    }

    /// A root of an element that is a square, in the letters so far.
    fn root_of_square(&self, f: &RationalFunction) -> Option<RationalFunction> {
        if let Some(constant) = f.as_constant() {
            let root = |n: &BigInt| {
                let root = n.sqrt();
                (&root * &root == *n).then_some(root)
            };
            if constant.is_negative() {
                return None;
            }
            let value = BigRational::new(root(constant.numer())?, root(constant.denom())?);
            return Some(self.constant(value));
        }
        let plain = square_root_of(f.numerator()).zip(square_root_of(f.denominator()));
        match plain {
            Some((above, below)) => RationalFunction::new(above, below).ok(),
            None => self.root_in_tower(f),
        }
    }
}
