//! Exponentials, logarithms and powers: one normal form for the three.
//!
//! The logarithm of something positive is taken factor by factor, of a root half that of its radicand, of
//! a power the exponent times that of its base, of e^u with a real u that is u. An exponential is taken
//! term by term; a term c ln b makes it b^c, so that a^x and e^{x ln a} have one letter, and (a^x)^y is
//! a^{xy}. Of two logarithms in one term that of the smaller base, in the order of polynomials, goes: a^{ln b}
//! is b^{ln a}.

use super::elementary::{LARGEST_MULTIPLE, Term, prime_factors, with_positive_lead};
use super::{FunctionLetter, FunctionTable, Impossible, Possible};
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{Signed, ToPrimitive};
use ratpoly::{Polynomial, RationalFunction};
use std::cmp::Ordering;

impl FunctionTable {
    /// `e^argument`.
    pub fn exponential(&self, argument: &RationalFunction) -> Possible<RationalFunction> {
        let argument = self.reduce(argument.clone());
        self.refuse_distributions(&argument)?;
        let (real, imaginary) = self.parts_by_i(&argument)?;
        let mut value = self.integer(1);
        for term in self.terms(&real)? {
            value = self.reduce(&value * &self.exponential_of(&term)?);
        }
        if !imaginary.is_zero() {
            let (cosine, sine) = self.cosine_and_sine(&imaginary)?;
            let i = self.imaginary_unit()?;
            value = self.reduce(&value * &(&cosine + &(&i * &sine)));
        }
        Ok(value)
    }

    /// The exponential of one term.
    fn exponential_of(&self, term: &Term) -> Possible<RationalFunction> {
        if let Some((logarithm, base)) = self.smallest_logarithm(&term.atom) {
            let atom = term.atom.checked_div(&self.variable(logarithm))?;
            let number = term.number.clone();
            return self.power_by(&base, Term { number, atom });
        }
        let (n, unit) = self.multiple(term, |f| f.as_exponential().cloned())?;
        let letter = self.letter_value(FunctionLetter::Exponential(unit))?;
        self.power_of(&letter, n)
    }

    /// The logarithm with the smallest base among the factors of one term, and that base.
    fn smallest_logarithm(&self, atom: &RationalFunction) -> Option<(usize, Polynomial)> {
        let mut terms = atom.numerator().terms();
        let (monomial, _) = terms.next()?;
        if terms.next().is_some() {
            return None;
        }
        let exponents = monomial.exponents();
        let letters = self.all().into_iter();
        let logarithms = letters.filter_map(|(letter, f)| {
            if let FunctionLetter::Logarithm(base) = f
                && exponents[letter] > 0
            {
                Some((letter, base))
            } else {
                None
            }
        });
        logarithms.min_by(|(_, a), (_, b)| a.cmp(b))
    }

    /// `base^exponent`, one positive irreducible base and one term as the exponent.
    fn power_by(&self, base: &Polynomial, exponent: Term) -> Possible<RationalFunction> {
        if exponent.atom.is_one() {
            return self.rational_power(&base.clone().into(), &exponent.number);
        }
        if let Some((logarithm, smaller)) = self.smallest_logarithm(&exponent.atom)
            && smaller < *base
        {
            let own = self.letter_value(FunctionLetter::Logarithm(base.clone()))?;
            let atom = exponent.atom.checked_div(&self.variable(logarithm))?;
            let number = exponent.number;
            return self.power_by(
                &smaller,
                Term {
                    number,
                    atom: &atom * &own,
                },
            );
        }
        let (n, unit) = self.multiple(&exponent, |f| {
            let (b, e) = f.as_power()?;
            (b == base).then(|| e.clone())
        })?;
        let (n, unit) = with_positive_lead(n, unit);
        let letter = self.letter_value(FunctionLetter::Power(base.clone(), unit))?;
        self.power_of(&letter, n)
    }

    /// A power with a rational exponent.
    fn rational_power(
        &self,
        base: &RationalFunction,
        exponent: &BigRational,
    ) -> Possible<RationalFunction> {
        let n = exponent
            .numer()
            .to_i64()
            .filter(|n| n.abs() <= LARGEST_MULTIPLE);
        let n = n.ok_or_else(|| Impossible::unsupported("so high a power"))?;
        match exponent.denom().to_i64() {
            Some(1) => self.power_of(base, n),
            Some(d @ (2 | 4 | 8)) => {
                // For the principal branch only of what is not negative.
                let known = self.known_sign(base);
                if d > 2 && !known.is_some_and(super::Sign::is_not_negative) {
                    return Err(Impossible::unsupported(
                        "a root of higher order of something that may be negative",
                    ));
                }
                let mut root = self.square_root(base)?;
                for _ in 1..d.trailing_zeros() {
                    root = self.square_root(&root)?;
                }
                self.power_of(&root, n)
            }
            Some(d) => {
                // Only of a positive number that is such a power.
                let root = |n: &BigInt| {
                    let order = u32::try_from(d).ok().filter(|_| n.is_positive())?;
                    let root = n.nth_root(order);
                    (root.pow(order) == *n).then_some(root)
                };
                let number = base.as_constant();
                let root =
                    number.and_then(|n| Some(BigRational::new(root(n.numer())?, root(n.denom())?)));
                let root = root.ok_or_else(|| {
                    Impossible::unsupported("a root whose order is no power of two")
                })?;
                self.power_of(&self.constant(root), n)
            }
            None => Err(Impossible::unsupported("so high a root")),
        }
    }

    /// The natural logarithm of something positive, factor by factor.
    ///
    /// # Errors
    /// Where that is not known to be positive.
    pub fn logarithm(&self, f: &RationalFunction) -> Possible<RationalFunction> {
        let f = &self.reduce(f.clone());
        if !self.is_positive(f) {
            return Err(Impossible::unsupported(
                "the logarithm of something that is not known to be positive",
            ));
        }
        let split = self.split(f)?;
        let mut value = self.integer(0);
        for (number, sign) in [(split.content.numer(), 1), (split.content.denom(), -1)] {
            for (prime, multiplicity) in prime_factors(&num_traits::Signed::abs(number))? {
                let prime = FunctionLetter::Logarithm(Polynomial::constant(self.ring, prime));
                let term = &self.integer(sign * multiplicity) * &self.letter_value(prime)?;
                value = &value + &term;
            }
        }
        for (factor, multiplicity) in split.factors {
            let part = self.logarithm_of(&factor)?;
            value = &value + &(&self.integer(multiplicity) * &part);
        }
        Ok(self.reduce(value))
    }

    /// The logarithm of the modulus of an irreducible factor.
    fn logarithm_of(&self, factor: &Polynomial) -> Possible<RationalFunction> {
        let factor = self.positive_factor(factor.clone())?;
        if let [letter] = factor.variables_occurring()[..]
            && factor == Polynomial::variable(self.ring, letter)
        {
            match self.meaning(letter) {
                Some(FunctionLetter::Exponential(u)) => return Ok(u),
                Some(FunctionLetter::Root(radicand)) => {
                    let half = self.constant(BigRational::new(1.into(), 2.into()));
                    return Ok(&half * &self.logarithm(&radicand.into())?);
                }
                Some(FunctionLetter::Power(base, exponent)) => {
                    return Ok(self.reduce(&exponent * &self.logarithm(&base.into())?));
                }
                _ => {}
            }
        }
        self.letter_value(FunctionLetter::Logarithm(factor))
    }

    fn positive_factor(&self, factor: Polynomial) -> Possible<Polynomial> {
        match self.sign(&factor.clone().into()) {
            Some(Ordering::Greater) => Ok(factor),
            Some(Ordering::Less) => Ok(-factor),
            _ => Err(Impossible::unsupported(
                "a power or logarithm of something that is not known to be positive",
            )),
        }
    }

    /// `base^exponent` for an exponent that is no plain integer.
    ///
    /// # Errors
    /// Where the base of a symbolic exponent is not known to be positive.
    pub fn power(
        &self,
        base: &RationalFunction,
        exponent: &RationalFunction,
    ) -> Possible<RationalFunction> {
        let (base, exponent) = (&self.reduce(base.clone()), &self.reduce(exponent.clone()));
        if let Some(number) = exponent.as_constant() {
            return self.rational_power(base, &number);
        }
        self.refuse_distributions(exponent)?;
        if base
            .as_constant()
            .is_some_and(|number| number.is_negative())
            && let Some(sign) = self.power_of_minus_one(exponent)?
        {
            return Ok(self.reduce(&sign * &self.power(&-base, exponent)?));
        }
        if let Some(value) = self.power_of_imaginary_unit(base, exponent)? {
            return Ok(self.reduce(value));
        }
        if !self.is_positive(base) {
            return Err(Impossible::unsupported(
                "a power with a symbolic exponent of something that is not known to be positive",
            ));
        }
        if !self.parts_by_i(exponent)?.1.is_zero() {
            return self.exponential(&self.reduce(exponent * &self.logarithm(base)?));
        }
        let split = self.split(base)?;
        let mut value = self.integer(1);
        let mut factors: Vec<(Polynomial, i64)> = Vec::new();
        for (number, sign) in [(split.content.numer(), 1), (split.content.denom(), -1)] {
            for (prime, multiplicity) in prime_factors(&num_traits::Signed::abs(number))? {
                factors.push((Polynomial::constant(self.ring, prime), sign * multiplicity));
            }
        }
        for (factor, multiplicity) in split.factors {
            factors.push((self.positive_factor(factor)?, multiplicity));
        }
        for (factor, multiplicity) in factors {
            let part = match self.logarithm_is_known(&factor)? {
                Some(logarithm) => {
                    let all = &self.integer(multiplicity) * exponent;
                    self.exponential(&self.reduce(&all * &logarithm))?
                }
                None => {
                    let mut product = self.integer(1);
                    for mut term in self.terms(exponent)? {
                        term.number *= BigRational::from_integer(multiplicity.into());
                        product = self.reduce(&product * &self.power_by(&factor, term)?);
                    }
                    product
                }
            };
            value = self.reduce(&value * &part);
        }
        Ok(value)
    }

    /// The logarithm of a factor that is an exponential, a root or a power itself.
    fn logarithm_is_known(&self, factor: &Polynomial) -> Possible<Option<RationalFunction>> {
        let [letter] = factor.variables_occurring()[..] else {
            return Ok(None);
        };
        if *factor != Polynomial::variable(self.ring, letter) {
            return Ok(None);
        }
        match self.meaning(letter) {
            Some(
                FunctionLetter::Exponential(_)
                | FunctionLetter::Root(_)
                | FunctionLetter::Power(..),
            ) => self.logarithm_of(factor).map(Some),
            _ => Ok(None),
        }
    }
}
