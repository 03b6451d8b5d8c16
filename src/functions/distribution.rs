//! The Dirac distribution: delta(cu) = delta(u)/|c|, f(x) delta(x - a) = f(a) delta(x - a), and integrals over it.
//!
//! The normal form of what is linear in deltas has as the coefficient of delta(u) its value where u vanishes,
//! u being linear in a letter (L. Schwartz, *Théorie des distributions*, 1950, ch. V: the product with a smooth
//! function). Products of deltas, quotients by them and functions of them have no meaning here and are
//! refused where elements are compared.

use super::{FunctionLetter, FunctionTable, Impossible, Possible, Sign};
use num_traits::Signed;
use ratpoly::{Polynomial, RationalFunction};

impl FunctionTable {
    /// The Dirac distribution: factors of its argument with a sign come out of it.
    pub fn dirac(&self, argument: &RationalFunction) -> Possible<RationalFunction> {
        let argument = &self.reduce(argument.clone());
        self.refuse_distributions(argument)?;
        if argument.is_zero() || !self.is_real(argument) {
            return Err(Impossible::unsupported(
                "a distribution at zero or at complex numbers",
            ));
        }
        let split = self.split(argument)?;
        let mut factor = self.constant(split.content.abs());
        let mut rest = self.integer(1);
        for (p, multiplicity) in split.factors {
            let power = self.power_of(&p.clone().into(), multiplicity)?;
            if self.sign(&p.into()).is_some() {
                factor = &factor * &self.absolute(&power)?;
            } else if multiplicity == 1 {
                rest = &rest * &power;
            } else {
                return Err(Impossible::unsupported(
                    "a distribution of what vanishes in another way than simply",
                ));
            }
        }
        if rest.is_one() {
            // It vanishes wherever its argument does not.
            return Ok(self.integer(0));
        }
        let letter = self.letter_value(FunctionLetter::Dirac(rest))?;
        Ok(self.reduce(letter.checked_div(&factor)?))
    }

    fn is_distribution(&self, letter: usize) -> bool {
        matches!(self.meaning(letter), Some(FunctionLetter::Dirac(_)))
    }

    /// The distributions that occur in an element.
    pub(crate) fn distributions(&self, f: &RationalFunction) -> Vec<(usize, RationalFunction)> {
        let letters = f.numerator().variables_occurring().into_iter();
        let meanings = letters.filter_map(|letter| match self.meaning(letter) {
            Some(FunctionLetter::Dirac(u)) => Some((letter, u)),
            _ => None,
        });
        meanings.collect()
    }

    /// The form in which elements are compared: finer letters, coefficients of distributions taken where
    /// these stand.
    ///
    /// # Errors
    /// For a product of distributions, a quotient by one, and a coefficient without a value there.
    pub fn comparable(&self, f: &RationalFunction) -> Possible<RationalFunction> {
        let f = self.reduce(f.clone());
        let below = f.denominator().variables_occurring();
        if below.into_iter().any(|l| self.is_distribution(l)) {
            return Err(Impossible::unsupported("a quotient by a distribution"));
        }
        let found = self.distributions(&f);
        if found.is_empty() {
            return Ok(f);
        }
        let below = RationalFunction::from(f.denominator().clone());
        let mut rest = f.numerator().clone();
        let mut sum = self.integer(0);
        for (letter, argument) in found {
            let parts = rest.coefficients_in(letter);
            let (Some(first), Some(coefficient), true) =
                (parts.first(), parts.get(1), parts.len() == 2)
            else {
                return Err(Impossible::unsupported("a power of a distribution"));
            };
            let several = coefficient.variables_occurring().into_iter();
            if several.clone().any(|l| self.is_distribution(l)) {
                return Err(Impossible::unsupported("a product of distributions"));
            }
            let coefficient = RationalFunction::from(coefficient.clone()).checked_div(&below)?;
            let there = self.where_it_stands(&coefficient, &argument)?;
            sum = &sum + &(&there * &self.variable(letter));
            rest = first.clone();
        }
        Ok(self.reduce(&sum + &RationalFunction::from(rest).checked_div(&below)?))
    }

    /// A coefficient with the letter that an argument is linear in replaced by where the argument
    /// vanishes: the last letter whose factor has a sign.
    fn where_it_stands(
        &self,
        coefficient: &RationalFunction,
        argument: &RationalFunction,
    ) -> Possible<RationalFunction> {
        let letters = argument.numerator().variables_occurring().into_iter().rev();
        for letter in letters {
            if let Some((zero, _)) = self.simple_zero(argument, letter) {
                let image = [(letter, zero)];
                return self.substitute(coefficient, &image).map_err(|_| {
                    Impossible::unsupported(
                        "a coefficient without a value where a distribution stands",
                    )
                });
            }
        }
        // Nothing is known of where it stands: the coefficient stays as it is.
        match coefficient.as_constant() {
            Some(_) => Ok(coefficient.clone()),
            None => Err(Impossible::unsupported(
                "a distribution of what is not linear in a letter",
            )),
        }
    }

    /// Where an argument vanishes as a function of a letter in which it is linear, with the slope there, which
    /// has a sign.
    pub(crate) fn simple_zero(
        &self,
        argument: &RationalFunction,
        letter: usize,
    ) -> Option<(RationalFunction, RationalFunction)> {
        if self.is_distribution(letter) {
            return None;
        }
        let parts = argument.numerator().coefficients_in(letter);
        let [constant, slope] = parts.as_slice() else {
            return None;
        };
        if argument.denominator().degree(letter) > Some(0) {
            return None;
        }
        let below = RationalFunction::from(argument.denominator().clone());
        let over = |p: &Polynomial| RationalFunction::from(p.clone()).checked_div(&below).ok();
        let (constant, slope) = (over(constant)?, over(slope)?);
        let behind = |f: &RationalFunction| self.letters_behind(f).contains(&letter);
        if behind(&constant) || behind(&slope) || letter >= self.first && !self.is_variable(letter)
        {
            return None;
        }
        let known = self.known_sign(&slope);
        if !matches!(known, Some(Sign::Positive | Sign::Negative)) {
            return None;
        }
        let zero = self.reduce((-&constant).checked_div(&slope).ok()?);
        Some((zero, slope))
    }

    fn is_variable(&self, letter: usize) -> bool {
        matches!(self.meaning(letter), Some(FunctionLetter::Bound { .. }))
    }
}
