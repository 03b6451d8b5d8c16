//! Many fractions over one denominator: the denominator is factored once, and each numerator is divided
//! by the irreducible factors as often as they go. No gcd is taken, and the results are in lowest terms.

use crate::error::Error;
use crate::polynomial::Polynomial;
use crate::rational_function::RationalFunction;
use crate::ring::Ring;
use num_bigint::BigInt;
use num_integer::Integer as _;
use num_traits::One;
use std::collections::BTreeMap;
use std::sync::Mutex;

/// A nonzero denominator with its factorisation into irreducible polynomials.
#[derive(Debug)]
pub struct FactoredDenominator {
    ring: Ring,
    content: BigInt,
    /// The exponents of the variables that divide.
    monomial: Vec<u32>,
    /// The other irreducible factors, with their multiplicities.
    factors: Vec<(Polynomial, u32)>,
    /// Products of powers of the other factors, as they come up.
    products: Mutex<BTreeMap<Vec<u32>, Polynomial>>,
}

impl FactoredDenominator {
    /// Factors a denominator; [`Error::DivisionByZero`] if it is zero.
    pub fn new(denominator: &Polynomial) -> Result<Self, Error> {
        if denominator.is_zero() {
            return Err(Error::DivisionByZero);
        }
        let factorization = denominator.factor();
        let ring = denominator.ring();
        let mut monomial = vec![0; ring.len()];
        let mut factors = Vec::new();
        for (factor, multiplicity) in factorization.factors {
            match factor.variables_occurring()[..] {
                [variable] if factor.len() == 1 => monomial[variable] += multiplicity,
                _ => factors.push((factor, multiplicity)),
            }
        }
        Ok(FactoredDenominator {
            ring,
            content: factorization.content,
            monomial,
            factors,
            products: Mutex::new(BTreeMap::new()),
        })
    }

    /// The fraction of a numerator over the denominator, in lowest terms.
    pub fn reduce(&self, numerator: &Polynomial) -> Result<RationalFunction, Error> {
        if numerator.ring() != self.ring {
            return Err(Error::RingMismatch);
        }
        if numerator.is_zero() {
            return Ok(RationalFunction::zero(self.ring));
        }
        // Integers and variables in one division by a term.
        let mut common = if self.content.is_one() {
            BigInt::one()
        } else {
            numerator.content().gcd(&self.content)
        };
        let mut left = &self.content / &common;
        if left < BigInt::ZERO {
            left = -left;
            common = -common;
        }
        let content = numerator.monomial_content();
        let shared: Vec<u32> = content
            .iter()
            .zip(&self.monomial)
            .map(|(&a, &b)| a.min(b))
            .collect();
        let mut top = numerator.clone();
        if !common.is_one() || shared.iter().any(|&e| e > 0) {
            let term = Polynomial::from_terms(self.ring, [(&shared, common)])?;
            top = top.div_exact(&term).expect("a common factor of all terms");
        }
        let mut powers = Vec::with_capacity(self.factors.len());
        for (factor, multiplicity) in &self.factors {
            let mut rest = *multiplicity;
            while rest > 0
                && let Some(quotient) = top.div_exact(factor)
            {
                top = quotient;
                rest -= 1;
            }
            powers.push(rest);
        }
        let exponents: Vec<u32> = self
            .monomial
            .iter()
            .zip(&shared)
            .map(|(&b, &e)| b - e)
            .collect();
        let bottom = self.product(powers)?.mul_term(&exponents, &left)?;
        Ok(RationalFunction::from_coprime(top, bottom))
    }

    fn product(&self, powers: Vec<u32>) -> Result<Polynomial, Error> {
        let mut known = self
            .products
            .lock()
            .unwrap_or_else(|poisoned| poisoned.into_inner());
        if let Some(product) = known.get(&powers) {
            return Ok(product.clone());
        }
        let mut product = Polynomial::one(self.ring);
        for ((factor, _), &power) in self.factors.iter().zip(&powers) {
            for _ in 0..power {
                product = product.try_mul(factor)?;
            }
        }
        known.insert(powers, product.clone());
        Ok(product)
    }
}
