//! Gröbner bases over the rationals, computed with integer coefficients, and normal forms with cofactors.
//!
//! A statement "`f` lies in the ideal" is worth as much as its certificate: [`NormalForm`] holds the
//! identity `multiplier f = sum cofactors[i] divisors[i] + remainder`, and [`NormalForm::verify`] checks
//! it by multiplication, independent of how it was found.

mod buchberger;
mod order;
mod reduce;

pub(crate) use buchberger::groebner_basis;
pub(crate) use order::BlockOrder;
pub(crate) use reduce::Terms;

use crate::budget::Budget;
use crate::error::Error;
use crate::integer_gcd::integer_gcd;
use crate::polynomial::Polynomial;
use crate::ring::Ring;
use buchberger::{Origin, combine_cofactors};
use num_bigint::BigInt;
use num_traits::{One, Zero};

/// The reduced Gröbner basis of an ideal in the order of its ring: each element is primitive with a
/// positive leading coefficient, no term of one is divisible by the leading monomial of another. For a
/// given ideal and order it is unique. The zero ideal has the empty basis, the whole ring has `[1]`.
#[derive(Debug, Clone)]
pub struct GroebnerBasis {
    ring: Ring,
    generators: Vec<Polynomial>,
    elements: Vec<Polynomial>,
    origins: Option<Vec<Origin>>,
}

/// The result of a division: `multiplier * f = sum of cofactors[i] * divisors[i] + remainder` with a
/// positive integer multiplier and no common integer factor of all parts.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct NormalForm {
    /// The positive integer by which the dividend was multiplied, so that everything is integral.
    pub multiplier: BigInt,
    /// One factor for each divisor.
    pub cofactors: Vec<Polynomial>,
    /// What is left; for a Gröbner basis it is zero exactly if the dividend lies in the ideal.
    pub remainder: Polynomial,
}

impl GroebnerBasis {
    /// The reduced basis of the ideal that the polynomials generate.
    pub fn new(ring: Ring, generators: &[Polynomial], budget: &Budget) -> Result<Self, Error> {
        Self::build(ring, generators, false, budget)
    }

    /// The same, and how each element comes from the generators: needed by
    /// [`cofactors_of`](Self::cofactors_of) and [`membership`](Self::membership).
    pub fn with_cofactors(
        ring: Ring,
        generators: &[Polynomial],
        budget: &Budget,
    ) -> Result<Self, Error> {
        Self::build(ring, generators, true, budget)
    }

    fn build(
        ring: Ring,
        generators: &[Polynomial],
        trace: bool,
        budget: &Budget,
    ) -> Result<Self, Error> {
        if generators.iter().any(|g| g.ring() != ring) {
            return Err(Error::RingMismatch);
        }
        let order = BlockOrder::new([(ring.len(), ring.order())]);
        let terms: Vec<Terms> = generators.iter().map(|g| g.terms().collect()).collect();
        let basis = groebner_basis(&order, &terms, trace.then_some(ring), budget)?;
        let mut elements = Vec::with_capacity(basis.len());
        let mut origins = trace.then(Vec::new);
        for element in basis {
            elements.push(Polynomial::from_terms(ring, element.terms)?);
            if let (Some(origins), Some(origin)) = (&mut origins, element.origin) {
                origins.push(origin);
            }
        }
        Ok(GroebnerBasis {
            ring,
            generators: generators.to_vec(),
            elements,
            origins,
        })
    }

    /// The ring, whose order is that of the basis.
    pub fn ring(&self) -> Ring {
        self.ring
    }

    /// The polynomials from which the basis was computed.
    pub fn generators(&self) -> &[Polynomial] {
        &self.generators
    }

    /// The elements, the greatest leading monomial first.
    pub fn elements(&self) -> &[Polynomial] {
        &self.elements
    }

    /// Whether the ideal is the whole ring, that is, the generators have no common complex zero.
    pub fn is_whole_ring(&self) -> bool {
        self.elements.iter().any(Polynomial::is_constant)
    }

    /// Whether a polynomial lies in the ideal.
    pub fn contains(&self, f: &Polynomial, budget: &Budget) -> Result<bool, Error> {
        Ok(self.normal_form(f, budget)?.remainder.is_zero())
    }

    /// Division by the elements of the basis. `remainder / multiplier` depends only on `f` and the ideal.
    pub fn normal_form(&self, f: &Polynomial, budget: &Budget) -> Result<NormalForm, Error> {
        let divisors: Vec<&Polynomial> = self.elements.iter().collect();
        normal_form(f, &divisors, budget)
    }

    /// How the element number `index` comes from the generators: the `multiplier` and the `cofactors` of
    /// `multiplier * element = sum of cofactors[j] * generators[j]`, with remainder zero.
    pub fn cofactors_of(&self, index: usize) -> Result<NormalForm, Error> {
        let origins = self.origins()?;
        let origin = origins.get(index).ok_or(Error::WrongLength {
            expected: origins.len(),
            found: index,
        })?;
        Ok(NormalForm {
            multiplier: origin.multiplier.clone(),
            cofactors: origin.cofactors.clone(),
            remainder: Polynomial::zero(self.ring),
        })
    }

    /// The normal form with cofactors of the generators instead of the basis: a certificate that anyone
    /// can check who knows the generators.
    pub fn membership(&self, f: &Polynomial, budget: &Budget) -> Result<NormalForm, Error> {
        let origins = self.origins()?;
        let NormalForm {
            multiplier,
            cofactors,
            remainder,
        } = self.normal_form(f, budget)?;
        let summands: Vec<(Polynomial, &Origin)> = cofactors.into_iter().zip(origins).collect();
        let combined = if summands.is_empty() {
            Origin {
                multiplier: BigInt::one(),
                cofactors: vec![Polynomial::zero(self.ring); self.generators.len()],
            }
        } else {
            combine_cofactors(self.ring, &summands, budget)?
        };
        let mut form = NormalForm {
            multiplier: multiplier * &combined.multiplier,
            cofactors: combined.cofactors,
            remainder: remainder.mul_integer(&combined.multiplier),
        };
        form.cancel();
        Ok(form)
    }

    fn origins(&self) -> Result<&[Origin], Error> {
        self.origins.as_deref().ok_or(Error::Unsupported(
            "the basis was computed without cofactors",
        ))
    }
}

/// Division of `f` by a list over the rationals (Cox, Little, O'Shea, section 2.3): no term of the
/// remainder is divisible by the leading monomial of a divisor. Unless the divisors are a Gröbner basis
/// the remainder depends on their order.
pub fn normal_form(
    f: &Polynomial,
    divisors: &[&Polynomial],
    budget: &Budget,
) -> Result<NormalForm, Error> {
    let ring = f.ring();
    for divisor in divisors {
        if divisor.ring() != ring {
            return Err(Error::RingMismatch);
        }
        if divisor.is_zero() {
            return Err(Error::DivisionByZero);
        }
    }
    let lists: Vec<Terms> = divisors.iter().map(|d| d.terms().collect()).collect();
    let indexed: Vec<_> = lists.iter().map(Vec::as_slice).enumerate().collect();
    let order = BlockOrder::new([(ring.len(), ring.order())]);
    let reduction = reduce::reduce(&order, f.terms().collect(), &indexed, budget)?;
    let (identity, remainder) = reduction.into_identity(budget)?;
    let mut quotients: Vec<Terms> = vec![Vec::new(); divisors.len()];
    for (i, m, c) in identity.quotients {
        quotients[i].push((m, c));
    }
    let cofactors = quotients
        .into_iter()
        .map(|q| Polynomial::from_terms(ring, q))
        .collect::<Result<_, _>>()?;
    let mut form = NormalForm {
        multiplier: identity.multiplier,
        cofactors,
        remainder: Polynomial::from_terms(ring, remainder)?.mul_integer(&identity.scale),
    };
    form.cancel();
    Ok(form)
}

impl NormalForm {
    /// Whether the identity `multiplier * f = sum of cofactors[i] * divisors[i] + remainder` holds, found
    /// by multiplying out.
    pub fn verify(&self, f: &Polynomial, divisors: &[Polynomial]) -> Result<bool, Error> {
        if divisors.len() != self.cofactors.len() {
            return Err(Error::WrongLength {
                expected: self.cofactors.len(),
                found: divisors.len(),
            });
        }
        let pairs = self.cofactors.iter().zip(divisors);
        let sum = Polynomial::sum_of_products(f.ring(), pairs)?.try_add(&self.remainder)?;
        Ok(!self.multiplier.is_zero() && sum == f.mul_integer(&self.multiplier))
    }

    /// Divides by the common integer factor and makes the multiplier positive.
    fn cancel(&mut self) {
        let mut common = self.multiplier.clone();
        for part in self.cofactors.iter().chain([&self.remainder]) {
            if !part.is_zero() {
                common = integer_gcd(&common, &part.content());
            }
        }
        if self.multiplier < BigInt::zero() {
            common = -common;
        }
        if common.is_one() || common.is_zero() {
            return;
        }
        self.multiplier = &self.multiplier / &common;
        for part in self.cofactors.iter_mut().chain([&mut self.remainder]) {
            *part = part.div_integer(&common).expect("a common factor");
        }
    }
}
