//! Functions of elements, in the letters of the table.
//!
//! Arguments of exp, cos and sin are split into terms q m/d (q rational, m a monomial, d the
//! denominator without its content) and put together again by the addition theorems, so that
//! functions of dependent arguments have dependent letters. Radicands and bases are split into
//! irreducible factors; what is known to be positive gets a letter of its own.

use super::{FunctionLetter, FunctionTable, Impossible, Possible};
use crate::expr::Function;
use num_bigint::BigInt;
use num_integer::Integer;
use num_rational::BigRational;
use num_traits::{One, Signed, ToPrimitive, Zero};
use ratpoly::{Budget, Polynomial, RationalFunction};
use std::cmp::Ordering;

/// The largest multiple of an angle and the largest power of a letter that are worked out.
const LARGEST_MULTIPLE: i64 = 64;
/// The largest prime that is looked for in an integer under a root.
const LARGEST_PRIME: u64 = 100_000;

/// `number * atom`: one term of an argument.
struct Term {
    number: BigRational,
    atom: RationalFunction,
}

/// Factors that repeat: each with its multiplicity, and a rational number in front.
struct Split {
    content: BigRational,
    factors: Vec<(Polynomial, i64)>,
}

impl FunctionTable {
    fn constant(&self, value: BigRational) -> RationalFunction {
        RationalFunction::constant(self.ring, value)
    }

    pub(super) fn integer(&self, value: i64) -> RationalFunction {
        self.constant(BigRational::from_integer(value.into()))
    }

    /// A power within the limits, in normal form.
    pub(super) fn power_of(&self, base: &RationalFunction, n: i64) -> Possible<RationalFunction> {
        let n = i32::try_from(n).map_err(|_| Impossible::unsupported("so high a power"))?;
        let base = if n < 0 {
            self.reduce(base.inverse()?)
        } else {
            base.clone()
        };
        Ok(self.reduce(base.pow_within(n.abs(), &Budget::default())?))
    }

    /// A function of an element.
    ///
    /// # Errors
    /// Where it is outside of what is decided, or the letters are used up.
    pub fn call(
        &self,
        function: Function,
        argument: &RationalFunction,
    ) -> Possible<RationalFunction> {
        match function {
            Function::Exponential => self.exponential(argument),
            Function::Cosine => Ok(self.cosine_and_sine(argument)?.0),
            Function::Sine => Ok(self.cosine_and_sine(argument)?.1),
            Function::Tangent | Function::Cotangent => {
                let (cosine, sine) = self.cosine_and_sine(argument)?;
                let quotient = match function {
                    Function::Tangent => sine.checked_div(&cosine)?,
                    _ => cosine.checked_div(&sine)?,
                };
                Ok(self.reduce(quotient))
            }
            Function::HyperbolicCosine | Function::HyperbolicSine | Function::HyperbolicTangent => {
                let up = self.exponential(argument)?;
                let down = self.reduce(up.inverse()?);
                let (sum, difference) = (&up + &down, &up - &down);
                let two = self.integer(2);
                Ok(self.reduce(match function {
                    Function::HyperbolicCosine => sum.checked_div(&two)?,
                    Function::HyperbolicSine => difference.checked_div(&two)?,
                    _ => difference.checked_div(&sum)?,
                }))
            }
            Function::SquareRoot => self.square_root(argument),
            Function::Absolute => self.absolute(argument),
            Function::Logarithm => self.logarithm(argument),
            Function::RealPart => Ok(self.real_and_imaginary(argument)?.0),
            Function::ImaginaryPart => Ok(self.real_and_imaginary(argument)?.1),
            Function::Determinant | Function::Trace => Ok(argument.clone()),
        }
    }

    /// Real and imaginary part, all letters but i being real.
    pub fn real_and_imaginary(
        &self,
        f: &RationalFunction,
    ) -> Possible<(RationalFunction, RationalFunction)> {
        let Some(i) = self
            .all()
            .into_iter()
            .find(|(_, f)| *f == FunctionLetter::ImaginaryUnit)
            .map(|(letter, _)| letter)
        else {
            return Ok((f.clone(), self.integer(0)));
        };
        let mut parts = f.numerator().coefficients_in(i).into_iter();
        let below: RationalFunction = f.denominator().clone().into();
        let mut part = || match parts.next() {
            Some(p) => RationalFunction::from(p).checked_div(&below),
            None => Ok(self.integer(0)),
        };
        Ok((part()?, part()?))
    }

    /// The complex conjugate.
    pub fn conjugate(&self, f: &RationalFunction) -> Possible<RationalFunction> {
        let (real, imaginary) = self.real_and_imaginary(f)?;
        Ok(&real - &self.reduce(&imaginary * &self.imaginary_unit()?))
    }

    /// The terms of an argument. What is multiplied with a variable of integration stays together:
    /// it is one frequency.
    fn terms(&self, argument: &RationalFunction) -> Possible<Vec<Term>> {
        let below = argument.denominator();
        let content = below.content();
        let primitive: RationalFunction = below.primitive_part().into();
        let bound: Vec<usize> = self
            .all()
            .into_iter()
            .filter(|(_, f)| matches!(f, FunctionLetter::Bound { .. }))
            .map(|(letter, _)| letter)
            .collect();
        let mut groups: Vec<(Vec<u32>, super::TermList)> = Vec::new();
        for (monomial, coefficient) in argument.numerator().terms() {
            let exponents = monomial.exponents().to_vec();
            let is_bound = bound.iter().any(|b| exponents[*b] > 0);
            // Terms with the same variables of integration go together, any other stands alone.
            let key = if is_bound {
                bound.iter().map(|b| exponents[*b]).collect()
            } else {
                let mut key = vec![u32::MAX];
                key.extend(&exponents);
                key
            };
            match groups.iter_mut().find(|(k, _)| *k == key) {
                Some((_, terms)) => terms.push((exponents, coefficient)),
                None => groups.push((key, vec![(exponents, coefficient)])),
            }
        }
        groups
            .into_iter()
            .map(|(_, terms)| {
                let p = Polynomial::from_terms(self.ring, terms)?;
                let mut number = p.content();
                if p.leading_coefficient().is_negative() {
                    number = -number;
                }
                let atom = RationalFunction::from(p.unit_normal().primitive_part());
                Ok(Term {
                    number: BigRational::new(number, content.clone()),
                    atom: atom.checked_div(&primitive)?,
                })
            })
            .collect()
    }

    /// The number n for which `number * atom` is n times the argument of a known letter, with that
    /// argument; otherwise the atom is divided as `number` wants it.
    fn multiple(
        &self,
        term: &Term,
        known: impl Fn(&FunctionLetter) -> Option<RationalFunction>,
    ) -> Possible<(i64, RationalFunction)> {
        let arguments: Vec<RationalFunction> =
            self.all().iter().filter_map(|(_, f)| known(f)).collect();
        let whole = &self.constant(term.number.clone()) * &term.atom;
        for argument in arguments {
            if let Some(ratio) = whole.checked_div(&argument)?.as_constant() {
                if !ratio.is_integer() {
                    return Err(Impossible::unsupported(
                        "a fraction of an argument that was met before",
                    ));
                }
                let n = ratio
                    .to_integer()
                    .to_i64()
                    .filter(|n| n.abs() <= LARGEST_MULTIPLE);
                let n = n.ok_or_else(|| Impossible::unsupported("so large a multiple"))?;
                return Ok((n, argument));
            }
        }
        // The sign that is met first stays with the argument: e^{-at} is the letter.
        let n = term.number.numer().clone();
        let magnitude = n
            .abs()
            .to_i64()
            .filter(|n| *n <= LARGEST_MULTIPLE)
            .ok_or_else(|| Impossible::unsupported("so large a multiple"))?;
        let unit = &term.number / BigRational::from_integer(magnitude.into());
        Ok((magnitude, &self.constant(unit) * &term.atom))
    }

    fn imaginary_letter(&self) -> Option<usize> {
        self.all()
            .into_iter()
            .find(|(_, f)| *f == FunctionLetter::ImaginaryUnit)
            .map(|(letter, _)| letter)
    }

    /// `e^argument`.
    pub fn exponential(&self, argument: &RationalFunction) -> Possible<RationalFunction> {
        let (real, imaginary) = self.real_and_imaginary(argument)?;
        let mut value = self.integer(1);
        for term in self.terms(&real)? {
            let (n, unit) = self.multiple(&term, |f| match f {
                FunctionLetter::Exponential(u) => Some(u.clone()),
                _ => None,
            })?;
            let letter = self.letter_value(FunctionLetter::Exponential(unit))?;
            value = &value * &self.power_of(&letter, n)?;
        }
        if !imaginary.is_zero() {
            let (cosine, sine) = self.cosine_and_sine(&imaginary)?;
            let i = self.imaginary_unit()?;
            value = self.reduce(&value * &(&cosine + &(&i * &sine)));
        }
        Ok(value)
    }

    /// `cos argument` and `sin argument`.
    pub fn cosine_and_sine(
        &self,
        argument: &RationalFunction,
    ) -> Possible<(RationalFunction, RationalFunction)> {
        if let Some(i) = self.imaginary_letter()
            && argument.numerator().degree(i) > Some(0)
        {
            return Err(Impossible::unsupported("an angle that is not real"));
        }
        let mut whole = (self.integer(1), self.integer(0));
        for term in self.terms(argument)? {
            let part = self.angle(term)?;
            whole = self.sum_of_angles(&whole, &part);
        }
        Ok(whole)
    }

    fn sum_of_angles(
        &self,
        (c, s): &(RationalFunction, RationalFunction),
        (d, t): &(RationalFunction, RationalFunction),
    ) -> (RationalFunction, RationalFunction) {
        (
            self.reduce(&(c * d) - &(s * t)),
            self.reduce(&(s * d) + &(c * t)),
        )
    }

    /// Cosine and sine of one term.
    fn angle(&self, mut term: Term) -> Possible<(RationalFunction, RationalFunction)> {
        // |x| in an angle: the cosine is even, the sine odd.
        let mut odd = self.integer(1);
        for (letter, function) in self.all() {
            let FunctionLetter::Root(square) = function else {
                continue;
            };
            if term.atom.numerator().degree(letter) != Some(1) {
                continue;
            }
            if let Some(x) = square_root_of(&square) {
                let magnitude = self.variable(letter);
                let x = RationalFunction::from(x);
                term.atom = &term.atom.checked_div(&magnitude)? * &x;
                odd = self.reduce(&odd * &magnitude.checked_div(&x)?);
            }
        }
        if let Some(quarters) = self.quarter_turns(&term)? {
            let (c, s) = [(1, 0), (0, 1), (-1, 0), (0, -1)][quarters];
            return Ok((self.integer(c), self.integer(s)));
        }
        let (n, unit) = self.multiple(&term, |f| match f {
            FunctionLetter::Cosine(u) => Some(u.clone()),
            _ => None,
        })?;
        // The letter's angle has a positive leading coefficient.
        let (n, unit) = with_positive_lead(n, unit);
        let cosine = self.letter(FunctionLetter::Cosine(unit.clone()))?;
        let sine = self.letter_value(FunctionLetter::Sine(unit, cosine))?;
        let once = (self.variable(cosine), sine);
        let mut part = (self.integer(1), self.integer(0));
        for _ in 0..n.unsigned_abs() {
            part = self.sum_of_angles(&part, &once);
        }
        let sine = if n < 0 { -&part.1 } else { part.1 };
        Ok((part.0, self.reduce(&sine * &odd)))
    }

    /// How many quarters of a turn an angle is, modulo four.
    fn quarter_turns(&self, term: &Term) -> Possible<Option<usize>> {
        let is_pi = self
            .all()
            .iter()
            .any(|(l, f)| *f == FunctionLetter::Pi && self.variable(*l) == term.atom);
        let quarters = &term.number * BigRational::from_integer(2.into());
        if !is_pi || !quarters.is_integer() {
            return Ok(None);
        }
        Ok(quarters.to_integer().mod_floor(&BigInt::from(4)).to_usize())
    }

    /// The factors of numerator and denominator together, with their multiplicities.
    fn split(&self, f: &RationalFunction) -> Possible<Split> {
        let budget = Budget::default();
        let above = f.numerator().factor_within(&budget)?;
        let below = f.denominator().factor_within(&budget)?;
        let mut factors: Vec<(Polynomial, i64)> = Vec::new();
        factors.extend(above.factors.into_iter().map(|(p, e)| (p, i64::from(e))));
        factors.extend(below.factors.into_iter().map(|(p, e)| (p, -i64::from(e))));
        Ok(Split {
            content: BigRational::new(above.content, below.content),
            factors,
        })
    }

    /// `|f|` for real f.
    pub fn absolute(&self, f: &RationalFunction) -> Possible<RationalFunction> {
        match self.sign(f) {
            Some(Ordering::Less) => return Ok(-f),
            Some(_) => return Ok(f.clone()),
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
            let factor_value: RationalFunction = factor.clone().into();
            let magnitude = match self.sign(&factor_value) {
                Some(Ordering::Less) => -&factor_value,
                Some(_) => factor_value,
                None if multiplicity % 2 == 0 => factor_value,
                None => self.letter_value(FunctionLetter::Root(&factor * &factor))?,
            };
            value = self.reduce(&value * &self.power_of(&magnitude, multiplicity)?);
        }
        Ok(value)
    }

    /// The root with nonnegative real part that is meant by the root sign; imaginary for what is
    /// known to be negative.
    pub fn square_root(&self, f: &RationalFunction) -> Possible<RationalFunction> {
        if f.is_zero() {
            return Ok(f.clone());
        }
        let negative = match self.sign(f) {
            Some(Ordering::Less) => true,
            _ if f
                .numerator()
                .variables_occurring()
                .iter()
                .any(|l| !self.is_real_letter(*l)) =>
            {
                return Err(Impossible::unsupported("the root of a complex number"));
            }
            _ => false,
        };
        let split = self.split(&if negative { -f } else { f.clone() })?;
        let mut value = self.integer(1);
        if negative {
            value = self.imaginary_unit()?;
        }
        // sqrt(p/q) = sqrt(p q)/q for the rational number in front.
        let content = split.content.numer() * split.content.denom();
        value = &value * &self.constant(BigRational::new(1.into(), split.content.denom().clone()));
        let mut unknown = Polynomial::one(self.ring);
        if content.is_negative() {
            unknown = -unknown;
        }
        for (prime, multiplicity) in prime_factors(&content.abs())? {
            let base = self.constant(BigRational::from_integer(prime.clone()));
            value = self.reduce(&value * &self.power_of(&base, multiplicity / 2)?);
            if multiplicity % 2 == 1 {
                let root = FunctionLetter::Root(Polynomial::constant(self.ring, prime));
                value = self.reduce(&value * &self.letter_value(root)?);
            }
        }
        for (factor, multiplicity) in split.factors {
            let half = multiplicity.div_euclid(2);
            let base: RationalFunction = factor.clone().into();
            let sign = self.sign(&base);
            let magnitude = if half % 2 == 0 {
                base.clone()
            } else {
                self.absolute(&base)?
            };
            value = self.reduce(&value * &self.power_of(&magnitude, half)?);
            if multiplicity.rem_euclid(2) == 1 {
                if sign == Some(Ordering::Greater) {
                    value = self.reduce(&value * &self.letter_value(FunctionLetter::Root(factor))?);
                } else {
                    unknown = &unknown * &factor;
                }
            }
        }
        if !unknown.is_one() {
            value = self.reduce(&value * &self.letter_value(FunctionLetter::Root(unknown))?);
        }
        Ok(value)
    }

    /// The natural logarithm of something positive, factor by factor.
    pub fn logarithm(&self, f: &RationalFunction) -> Possible<RationalFunction> {
        if !self.is_positive(f) {
            return Err(Impossible::unsupported(
                "the logarithm of something that is not known to be positive",
            ));
        }
        let split = self.split(f)?;
        let mut value = self.integer(0);
        for (number, sign) in [(split.content.numer(), 1), (split.content.denom(), -1)] {
            for (prime, multiplicity) in prime_factors(number)? {
                let prime = FunctionLetter::Logarithm(Polynomial::constant(self.ring, prime));
                let term = &self.integer(sign * multiplicity) * &self.letter_value(prime)?;
                value = &value + &term;
            }
        }
        for (factor, multiplicity) in split.factors {
            let known = self.all().into_iter().find_map(|(letter, f)| match f {
                FunctionLetter::Exponential(u)
                    if factor == Polynomial::variable(self.ring, letter) =>
                {
                    Some(u)
                }
                _ => None,
            });
            let part = match known {
                Some(argument) => argument,
                None => {
                    self.letter_value(FunctionLetter::Logarithm(self.positive_factor(factor)?))?
                }
            };
            value = &value + &(&self.integer(multiplicity) * &part);
        }
        Ok(value)
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
    pub fn power(
        &self,
        base: &RationalFunction,
        exponent: &RationalFunction,
    ) -> Possible<RationalFunction> {
        if let Some(number) = exponent.as_constant() {
            let n = number
                .numer()
                .to_i64()
                .filter(|n| n.abs() <= LARGEST_MULTIPLE);
            let n = n.ok_or_else(|| Impossible::unsupported("so high a power"))?;
            return match number.denom().to_i64() {
                Some(1) => self.power_of(base, n),
                Some(2) => self.power_of(&self.square_root(base)?, n),
                _ => Err(Impossible::unsupported(
                    "a root of higher than second order",
                )),
            };
        }
        if !self.is_positive(base) {
            return Err(Impossible::unsupported(
                "a power with a symbolic exponent of something that is not known to be positive",
            ));
        }
        let split = self.split(base)?;
        let mut factors: Vec<(Polynomial, i64)> = Vec::new();
        for (number, sign) in [(split.content.numer(), 1), (split.content.denom(), -1)] {
            for (prime, multiplicity) in prime_factors(number)? {
                factors.push((Polynomial::constant(self.ring, prime), sign * multiplicity));
            }
        }
        for (factor, multiplicity) in split.factors {
            factors.push((self.positive_factor(factor)?, multiplicity));
        }
        let mut value = self.integer(1);
        for (factor, multiplicity) in factors {
            for mut term in self.terms(exponent)? {
                term.number *= BigRational::from_integer(multiplicity.into());
                let part = if term.atom.is_one() {
                    self.power(&factor.clone().into(), &self.constant(term.number))?
                } else {
                    let (n, unit) = self.multiple(&term, |f| match f {
                        FunctionLetter::Power(b, e) if *b == factor => Some(e.clone()),
                        _ => None,
                    })?;
                    let (n, unit) = with_positive_lead(n, unit);
                    let letter = self.letter_value(FunctionLetter::Power(factor.clone(), unit))?;
                    self.power_of(&letter, n)?
                };
                value = self.reduce(&value * &part);
            }
        }
        Ok(value)
    }

    /// The Dirac distribution: a positive factor of the argument comes out of it.
    pub fn dirac(&self, argument: &RationalFunction) -> Possible<RationalFunction> {
        let split = self.split(argument)?;
        let mut factor = self.constant(split.content.abs());
        let mut rest = self.integer(1);
        for (p, multiplicity) in split.factors {
            let power = self.power_of(&p.clone().into(), multiplicity)?;
            if self.sign(&p.into()).is_some() {
                factor = &factor * &self.absolute(&power)?;
            } else {
                rest = &rest * &power;
            }
        }
        if rest.is_one() {
            // It vanishes wherever its argument does not.
            return Ok(self.integer(0));
        }
        let letter = self.letter_value(FunctionLetter::Dirac(rest))?;
        Ok(letter.checked_div(&factor)?)
    }
}

/// The polynomial whose square this is, if it is one, up to sign.
pub(crate) fn square_root_of(square: &Polynomial) -> Option<Polynomial> {
    let factorization = square.square_free_factorization();
    if factorization.content.is_negative() {
        return None;
    }
    let root = factorization.content.sqrt();
    if &root * &root != factorization.content {
        return None;
    }
    let mut product = Polynomial::constant(square.ring(), root);
    for (factor, multiplicity) in factorization.factors {
        if multiplicity % 2 == 1 {
            return None;
        }
        product = &product * &factor.try_pow(multiplicity / 2).ok()?;
    }
    Some(product)
}

/// The primes of a positive integer.
fn prime_factors(n: &BigInt) -> Possible<Vec<(BigInt, i64)>> {
    let mut rest = n.clone();
    let mut found: Vec<(BigInt, i64)> = Vec::new();
    let mut prime = 2u64;
    while !rest.is_one() {
        if BigInt::from(prime) * prime > rest {
            found.push((rest.clone(), 1));
            break;
        }
        let p = BigInt::from(prime);
        let mut multiplicity = 0;
        while (&rest % &p).is_zero() {
            rest /= &p;
            multiplicity += 1;
        }
        if multiplicity > 0 {
            found.push((p, multiplicity));
        }
        prime += if prime == 2 { 1 } else { 2 };
        if prime > LARGEST_PRIME {
            return Err(Impossible::unsupported(
                "a root of a number with large primes",
            ));
        }
    }
    Ok(found)
}

/// The multiple of an argument whose leading coefficient is positive.
fn with_positive_lead(n: i64, argument: RationalFunction) -> (i64, RationalFunction) {
    if argument.numerator().leading_coefficient().is_negative() {
        (-n, -&argument)
    } else {
        (n, argument)
    }
}
