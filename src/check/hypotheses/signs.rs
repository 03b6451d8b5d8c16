//! The signs of expressions under what is supposed, and what a supposed sign says of the parts of an
//! expression.

use super::{Supposed, Unusable};
use crate::check::Checker;
use crate::check::hypotheses::possible::Signs;
use crate::model::range::{Numbers, Range};
use num_bigint::BigInt;
use num_traits::{Signed, Zero};
use ratpoly::{Budget, Polynomial, RationalFunction, RegionSign};

/// What one sign may cost.
pub(super) fn budget() -> Budget {
    Budget::new(20_000, 4_000, 5_000_000)
}

impl Checker<'_> {
    /// Which numbers a letter stands for, one that stands for a function too.
    pub(in crate::check) fn range_of(&self, letter: usize) -> Range {
        match self.functions() {
            Some(table) if !table.is_real_letter(letter) => Range {
                numbers: Numbers::Complex,
                ..Range::default()
            },
            Some(table) => table.letter_range(letter),
            None => self.model.range_of(letter),
        }
    }

    /// The signs that a polynomial may have where all that is supposed holds.
    pub(crate) fn signs_in(&self, supposed: &Supposed, p: &Polynomial) -> Signs {
        let others = |letter: usize| self.range_of(letter);
        supposed.admitted.signs_of(p, &others, &budget())
    }

    /// The signs that a polynomial in the declared letters may have.
    pub(crate) fn signs(&self, p: &Polynomial) -> Signs {
        self.signs_in(&self.supposed, p)
    }

    /// What is known of a sign, and what the hypotheses in force say of it besides.
    pub(in crate::check) fn sign_where_supposed(
        &self,
        f: &RationalFunction,
        known: RegionSign,
    ) -> RegionSign {
        if !self.supposed.in_force {
            return known;
        }
        let below = self.signs(f.denominator()).and(Signs::NOT_ZERO);
        let mut above = self.signs(f.numerator());
        for relation in &self.supposed.relations {
            above = above.and(self.signs_modulo(f.numerator(), relation));
        }
        if above.only().is_none() {
            above = above.and(self.signs_of_factors(f.numerator()));
        }
        match above.times(below).and(Signs::of_region(&known)) {
            Signs::POSITIVE => RegionSign::Positive,
            Signs::NEGATIVE => RegionSign::Negative,
            Signs::ZERO => RegionSign::Zero,
            Signs::NOT_NEGATIVE => RegionSign::NonNegative,
            Signs::NOT_POSITIVE => RegionSign::NonPositive,
            _ => RegionSign::Undecided,
        }
    }

    /// The signs of a product by those of its factors.
    fn signs_of_factors(&self, p: &Polynomial) -> Signs {
        let Ok(all) = factors(p) else {
            return Signs::ANY;
        };
        let mut product = match all.content.is_negative() {
            true => Signs::NEGATIVE,
            false => Signs::POSITIVE,
        };
        for (factor, multiplicity) in &all.factors {
            let own = self.signs(factor);
            let real = |l: usize| match self.supposed.admitted.ranges.get(l) {
                Some(range) => range.numbers != Numbers::Complex,
                None => self.range_of(l).numbers != Numbers::Complex,
            };
            product = product.times(match multiplicity % 2 {
                1 => own,
                _ if !factor.variables_occurring().into_iter().all(real) => Signs::ANY,
                _ if own.excludes_zero() => Signs::POSITIVE,
                _ => Signs::NOT_NEGATIVE,
            });
        }
        product
    }

    /// Whether a function certainly has no zero where all that is supposed holds: none of the factors of
    /// its numerator has one.
    pub(in crate::check) fn vanishes_nowhere(&self, f: &RationalFunction) -> bool {
        let never = |p: &Polynomial| {
            self.signs(p).excludes_zero()
                || self
                    .supposed
                    .relations
                    .iter()
                    .any(|r| self.signs_modulo(p, r).excludes_zero())
        };
        match factors(f.numerator()) {
            Ok(all) => all.factors.iter().all(|(factor, _)| never(factor)),
            Err(_) => false,
        }
    }

    /// The signs of a polynomial where a relation holds: of its sums with multiples of the relation in
    /// which a term of both cancels.
    fn signs_modulo(&self, p: &Polynomial, relation: &Polynomial) -> Signs {
        let mut found = Signs::ANY;
        for (monomial, coefficient) in relation.terms() {
            let own = p.coefficient(monomial.exponents());
            if own.is_zero() {
                continue;
            }
            let sum = &p.mul_integer(&coefficient) - &relation.mul_integer(&own);
            let signs = self.signs(&sum);
            found = found.and(match coefficient.sign() {
                num_bigint::Sign::Minus => signs.reversed(),
                _ => signs,
            });
        }
        found
    }

    /// What is known of a letter is known of the value that replaces it.
    pub(super) fn transfer(
        &self,
        letter: usize,
        value: &RationalFunction,
        supposed: &mut Supposed,
    ) -> Result<(), Unusable> {
        let range = self.supposed.admitted.ranges[letter].clone();
        if range.numbers == Numbers::Complex {
            return Ok(());
        }
        if let Some(number) = value.as_constant() {
            return match range.contains(&number) {
                true => Ok(()),
                false => Err(Unusable::Contradictory),
            };
        }
        let ring = self.model.ring;
        for (end, beyond, within) in [
            (&range.low, Signs::POSITIVE, Signs::NOT_NEGATIVE),
            (&range.high, Signs::NEGATIVE, Signs::NOT_POSITIVE),
        ] {
            if let Some(end) = end {
                let signs = if end.included { within } else { beyond };
                let distance = value - &RationalFunction::constant(ring, end.value.clone());
                self.suppose_sign(&distance, signs, supposed)?;
            }
        }
        Ok(())
    }

    /// Supposes that an expression has one of these signs: of its factors those of known sign are left
    /// out.
    pub(super) fn suppose_sign(
        &self,
        value: &RationalFunction,
        signs: Signs,
        supposed: &mut Supposed,
    ) -> Result<(), Unusable> {
        if value.is_zero() {
            return match signs.admits(Signs::ZERO) {
                true => Ok(()),
                false => Err(Unusable::Contradictory),
            };
        }
        let letters = crate::check::identity::letters_of([value]);
        let complex = |l: &usize| match supposed.admitted.ranges.get(*l) {
            Some(range) => range.numbers == Numbers::Complex,
            None => self.range_of(*l).numbers == Numbers::Complex,
        };
        if signs != Signs::NOT_ZERO && letters.iter().any(complex) {
            return Err(Unusable::Outside("an order of complex numbers".into()));
        }
        let (above, below) = (factors(value.numerator())?, factors(value.denominator())?);
        for (factor, _) in &below.factors {
            supposed.admitted.suppose(factor, Signs::NOT_ZERO);
        }
        let mut wanted = signs;
        if (above.content * below.content).is_negative() {
            wanted = wanted.reversed();
        }
        let mut product = Polynomial::one(self.model.ring);
        for (factor, multiplicity) in above.factors.into_iter().chain(below.factors) {
            let known = self.signs_in(supposed, &factor);
            if known == Signs::NONE {
                return Err(Unusable::Contradictory);
            }
            if known == Signs::ZERO {
                // All of it is zero, whatever the other factors are.
                return match signs.admits(Signs::ZERO) {
                    true => Ok(()),
                    false => Err(Unusable::Contradictory),
                };
            }
            if wanted.excludes_zero() && !known.excludes_zero() {
                supposed.admitted.suppose(&factor, Signs::NOT_ZERO);
            }
            if known == Signs::NEGATIVE && multiplicity % 2 == 1 {
                wanted = wanted.reversed();
            } else if known.only().is_none() && multiplicity % 2 == 1 {
                product = &product * &factor;
            } else if known.only().is_none() && !known.excludes_zero() && !wanted.excludes_zero() {
                product = &(&product * &factor) * &factor;
            }
        }
        if product.is_constant() {
            return match wanted.admits(Signs::POSITIVE) {
                true => Ok(()),
                false => Err(Unusable::Contradictory),
            };
        }
        if wanted != Signs::NOT_ZERO {
            supposed.admitted.suppose(&product, wanted);
        }
        Ok(())
    }

    /// The part of a polynomial that vanishes where it does: without powers and without factors that
    /// cannot vanish.
    pub(super) fn essential(
        &self,
        p: &Polynomial,
        supposed: &Supposed,
    ) -> Result<Polynomial, Unusable> {
        let mut product = Polynomial::one(self.model.ring);
        for (factor, _) in factors(p)?.factors {
            let vanishes = !self.signs_in(supposed, &factor).excludes_zero();
            let divides = |d: &Polynomial| !d.is_zero() && d.div_exact(&factor).is_some();
            if vanishes && !supposed.divisors.iter().any(divides) {
                product = &product * &factor;
            }
        }
        match product.is_constant() {
            true => Err(Unusable::Contradictory),
            false => Ok(product),
        }
    }
}

/// A number and irreducible factors with their multiplicities.
struct Factors {
    content: BigInt,
    factors: Vec<(Polynomial, u32)>,
}

/// The irreducible factors; the polynomial itself where factoring is out of reach.
fn factors(p: &Polynomial) -> Result<Factors, Unusable> {
    if p.is_zero() {
        return Err(Unusable::Contradictory);
    }
    Ok(match p.factor_within(&Budget::default()) {
        Ok(found) => Factors {
            content: found.content,
            factors: found.factors,
        },
        Err(_) => Factors {
            content: BigInt::from(1),
            factors: vec![(p.clone(), 1)],
        },
    })
}
