//! Functions of elements, in the letters of the table.
//!
//! Arguments of exp, cos and sin are split into terms q m/d (q rational, m a monomial, d the
//! denominator without its content) and put together again by the addition theorems, so that
//! functions of dependent arguments have dependent letters. Radicands and bases are split into
//! irreducible factors; what is known to be positive gets a letter of its own.

use super::{FunctionLetter, FunctionTable, Impossible, Possible};
use crate::expr::Function;
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Signed, ToPrimitive, Zero};
use ratpoly::{Budget, Polynomial, RationalFunction, allowance};

/// The largest multiple of an angle and the largest power of a letter that are worked out.
pub(super) const LARGEST_MULTIPLE: i64 = 64;

/// Terms, bits and steps that the factorisation of one argument may take: a search for a correction
/// asks for thousands, and what a paper prints needs a hundredth of it.
const FACTORED: (usize, u64, u64) = (20_000, 20_000, 20_000_000);
/// The largest prime that is looked for in an integer under a root.
const LARGEST_PRIME: u64 = 100_000;

/// `number * atom`: one term of an argument.
pub(super) struct Term {
    pub number: BigRational,
    pub atom: RationalFunction,
}

/// Factors that repeat: each with its multiplicity, and a rational number in front.
pub(super) struct Split {
    pub content: BigRational,
    pub factors: Vec<(Polynomial, i64)>,
}

impl FunctionTable {
    pub(super) fn constant(&self, value: BigRational) -> RationalFunction {
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
            Function::Tangent => {
                let (cosine, sine) = self.cosine_and_sine(argument)?;
                Ok(self.reduce(sine.checked_div(&cosine)?))
            }
            Function::Cotangent => {
                let (cosine, sine) = self.cosine_and_sine(argument)?;
                Ok(self.reduce(cosine.checked_div(&sine)?))
            }
            Function::HyperbolicCosine => {
                let (sum, _) = self.sum_and_difference_of_exponentials(argument)?;
                Ok(self.reduce(sum.checked_div(&self.integer(2))?))
            }
            Function::HyperbolicSine => {
                let (_, difference) = self.sum_and_difference_of_exponentials(argument)?;
                Ok(self.reduce(difference.checked_div(&self.integer(2))?))
            }
            Function::HyperbolicTangent => {
                let (sum, difference) = self.sum_and_difference_of_exponentials(argument)?;
                Ok(self.reduce(difference.checked_div(&sum)?))
            }
            Function::SquareRoot => self.square_root(argument),
            Function::Absolute => self.absolute(argument),
            Function::Logarithm => self.logarithm(argument),
            Function::RealPart => Ok(self.real_and_imaginary(argument)?.0),
            Function::ImaginaryPart => Ok(self.real_and_imaginary(argument)?.1),
            Function::Determinant | Function::Trace => Ok(argument.clone()),
        }
    }

    /// Real and imaginary part.
    ///
    /// # Errors
    /// Where another letter than i may be complex.
    pub fn real_and_imaginary(
        &self,
        f: &RationalFunction,
    ) -> Possible<(RationalFunction, RationalFunction)> {
        let parts = self.parts_by_i(&self.reduce(f.clone()))?;
        if self.is_real(&parts.0) && self.is_real(&parts.1) {
            Ok(parts)
        } else {
            Err(Impossible::unsupported(
                "the real part of something with a letter that may be complex",
            ))
        }
    }

    /// u and v of u + iv, in which i does not occur; they are the real and the imaginary part only
    /// where both are real.
    pub(super) fn parts_by_i(
        &self,
        f: &RationalFunction,
    ) -> Possible<(RationalFunction, RationalFunction)> {
        let Some(i) = self.imaginary_letter() else {
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
    pub(super) fn terms(&self, argument: &RationalFunction) -> Possible<Vec<Term>> {
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

    /// `e^u + e^(-u)` and `e^u - e^(-u)`.
    fn sum_and_difference_of_exponentials(
        &self,
        argument: &RationalFunction,
    ) -> Possible<(RationalFunction, RationalFunction)> {
        let up = self.exponential(argument)?;
        let down = self.reduce(up.inverse()?);
        Ok((&up + &down, &up - &down))
    }

    /// The number n for which `number * atom` is n times the argument of a known letter, with that
    /// argument; otherwise the atom is divided as `number` wants it.
    pub(super) fn multiple(
        &self,
        term: &Term,
        known: impl Fn(&FunctionLetter) -> Option<RationalFunction>,
    ) -> Possible<(i64, RationalFunction)> {
        let whole = &self.constant(term.number.clone()) * &term.atom;
        for (letter, function) in self.all() {
            let Some(argument) = known(&function) else {
                continue;
            };
            // What has been replaced by a finer one has that in its place among the others; a sign
            // (-1)^n is no power of a finer angle's letters here.
            if self.is_replaced(letter) || self.is_sign_of_half_turns(letter, &function) {
                continue;
            }
            let Some(ratio) = whole.checked_div(&argument)?.as_constant() else {
                continue;
            };
            let (Some(n), Some(times)) = (
                ratio
                    .numer()
                    .to_i64()
                    .filter(|n| n.abs() <= LARGEST_MULTIPLE),
                ratio
                    .denom()
                    .to_u32()
                    .filter(|d| i64::from(*d) <= LARGEST_MULTIPLE),
            ) else {
                return Err(Impossible::unsupported("so large a multiple"));
            };
            if times == 1 {
                return Ok((n, argument));
            }
            let part = self.constant(BigRational::new(1.into(), times.into()));
            let finer = &argument * &part;
            let fine = match function {
                FunctionLetter::Exponential(_) => FunctionLetter::Exponential(finer.clone()),
                FunctionLetter::Cosine(_) => FunctionLetter::Cosine(finer.clone()),
                FunctionLetter::Power(base, _) => FunctionLetter::Power(base, finer.clone()),
                FunctionLetter::Sine(..)
                | FunctionLetter::Root(_)
                | FunctionLetter::Logarithm(_)
                | FunctionLetter::Dirac(_)
                | FunctionLetter::Pi
                | FunctionLetter::ImaginaryUnit
                | FunctionLetter::Bound { .. } => {
                    return Err(Impossible::unsupported("a fraction of this argument"));
                }
            };
            let fine = self.letter(fine)?;
            self.replace_by_finer(letter, fine, times);
            return Ok((n, finer));
        }
        // The sign that is met first stays with the argument: e^{-at} is the letter. So does a number
        // too large for a power: in cos 1000t the angle is 1000t, and only cos t beside it is too much.
        let n = term.number.numer().clone();
        let magnitude = n
            .abs()
            .to_i64()
            .filter(|n| *n <= LARGEST_MULTIPLE)
            .unwrap_or(1);
        let unit = &term.number / BigRational::from_integer(magnitude.into());
        Ok((magnitude, &self.constant(unit) * &term.atom))
    }

    pub(super) fn imaginary_letter(&self) -> Option<usize> {
        self.place_of(&FunctionLetter::ImaginaryUnit)
    }

    /// The factors of numerator and denominator together, with their multiplicities.
    pub(super) fn split(&self, f: &RationalFunction) -> Possible<Split> {
        let budget = Budget::new(FACTORED.0, FACTORED.1, FACTORED.2);
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
}

/// The primes of a positive integer.
pub(super) fn prime_factors(n: &BigInt) -> Possible<Vec<(BigInt, i64)>> {
    let mut rest = n.clone();
    let mut found: Vec<(BigInt, i64)> = Vec::new();
    let mut prime = 2u64;
    while !rest.is_one() {
        if BigInt::from(prime) * prime > rest {
            found.push((rest.clone(), 1));
            break;
        }
        allowance::spend(2 + rest.bits() / 32);
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
pub(super) fn with_positive_lead(n: i64, argument: RationalFunction) -> (i64, RationalFunction) {
    if argument.numerator().leading_coefficient().is_negative() {
        (-n, -&argument)
    } else {
        (n, argument)
    }
}
