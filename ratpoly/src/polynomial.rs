//! Sparse distributed polynomials over the integers.
//!
//! Invariants: the terms are in strictly descending order in the ring's order, no coefficient is zero.

use crate::error::Error;
use crate::monomial::Monomial;
use crate::ring::Ring;
use num_bigint::BigInt;
use num_integer::Integer as _;
use num_traits::{One, Signed, Zero};
use std::cmp::Ordering;

/// A polynomial over the integers, canonical by construction: equality is structural.
#[derive(Clone, PartialEq, Eq, Hash)]
pub struct Polynomial {
    ring: Ring,
    terms: Vec<(Monomial, BigInt)>,
}

impl Polynomial {
    /// The zero polynomial.
    pub fn zero(ring: Ring) -> Self {
        Polynomial {
            ring,
            terms: Vec::new(),
        }
    }

    /// The polynomial 1.
    pub fn one(ring: Ring) -> Self {
        Polynomial::constant(ring, 1)
    }

    /// A constant polynomial.
    pub fn constant(ring: Ring, value: impl Into<BigInt>) -> Self {
        let value = value.into();
        let terms = if value.is_zero() {
            Vec::new()
        } else {
            vec![(Monomial::one(ring.len()), value)]
        };
        Polynomial { ring, terms }
    }

    /// The variable at a position of the ring.
    ///
    /// # Panics
    /// If the ring has no such variable.
    pub fn variable(ring: Ring, index: usize) -> Self {
        assert!(
            index < ring.len(),
            "the ring has no variable number {index}"
        );
        let mut exponents = vec![0; ring.len()];
        exponents[index] = 1;
        Polynomial {
            ring,
            terms: vec![(Monomial::new(exponents), BigInt::one())],
        }
    }

    /// The variable of this name.
    pub fn named(ring: Ring, name: &str) -> Result<Self, Error> {
        Ok(Polynomial::variable(ring, ring.index_of(name)?))
    }

    /// The sum of the given terms, in any order, repeated monomials allowed.
    pub fn from_terms<E, I>(ring: Ring, terms: I) -> Result<Self, Error>
    where
        E: AsRef<[u32]>,
        I: IntoIterator<Item = (E, BigInt)>,
    {
        let mut list = Vec::new();
        for (exponents, coefficient) in terms {
            let exponents = exponents.as_ref();
            if exponents.len() != ring.len() {
                return Err(Error::WrongLength {
                    expected: ring.len(),
                    found: exponents.len(),
                });
            }
            list.push((Monomial::new(exponents), coefficient));
        }
        Ok(Polynomial::collect(ring, list))
    }

    /// Sorts, adds equal monomials and drops zeros: the normalising constructor.
    pub(crate) fn collect(ring: Ring, mut list: Vec<(Monomial, BigInt)>) -> Self {
        list.sort_by(|a, b| ring.compare(&b.0, &a.0));
        let mut terms: Vec<(Monomial, BigInt)> = Vec::with_capacity(list.len());
        for (monomial, coefficient) in list {
            match terms.last_mut() {
                Some(last) if last.0 == monomial => last.1 += coefficient,
                _ => {
                    if terms.last().is_some_and(|t| t.1.is_zero()) {
                        terms.pop();
                    }
                    terms.push((monomial, coefficient));
                }
            }
        }
        if terms.last().is_some_and(|t| t.1.is_zero()) {
            terms.pop();
        }
        Polynomial { ring, terms }
    }

    /// The ring.
    pub fn ring(&self) -> Ring {
        self.ring
    }

    /// The terms in descending order.
    pub fn terms(&self) -> impl DoubleEndedIterator<Item = (Monomial, BigInt)> + ExactSizeIterator {
        self.terms.iter().cloned()
    }

    /// The exponent vectors of all terms, one after the other, in descending order.
    pub fn exponents_flat(&self) -> Vec<u32> {
        self.terms
            .iter()
            .flat_map(|t| t.0.exponents().iter().copied())
            .collect()
    }

    /// The residues of all coefficients in `0..modulus`, in the order of the terms.
    ///
    /// # Panics
    /// If the modulus is zero.
    pub fn residues(&self, modulus: u64) -> Vec<u64> {
        self.terms
            .iter()
            .map(|t| crate::evaluate::residue(&t.1, modulus))
            .collect()
    }

    /// Only for the kernel of this crate: the representation is about to change.
    pub(crate) fn raw_terms(&self) -> &[(Monomial, BigInt)] {
        &self.terms
    }

    /// The number of terms.
    pub fn len(&self) -> usize {
        self.terms.len()
    }

    /// Whether there is no term, the same as [`is_zero`](Self::is_zero).
    pub fn is_empty(&self) -> bool {
        self.is_zero()
    }

    /// Whether this is 0.
    pub fn is_zero(&self) -> bool {
        self.terms.is_empty()
    }

    /// Whether this is 1.
    pub fn is_one(&self) -> bool {
        self.terms.len() == 1 && self.terms[0].0.is_one() && self.terms[0].1.is_one()
    }

    /// Whether no variable occurs.
    pub fn is_constant(&self) -> bool {
        self.is_zero() || (self.terms.len() == 1 && self.terms[0].0.is_one())
    }

    /// The value of a constant polynomial.
    pub fn as_constant(&self) -> Option<BigInt> {
        if self.is_zero() {
            Some(BigInt::zero())
        } else {
            self.is_constant().then(|| self.terms[0].1.clone())
        }
    }

    /// The greatest term.
    pub fn leading_term(&self) -> Option<(Monomial, BigInt)> {
        self.terms.first().cloned()
    }

    /// The monomial of the greatest term.
    pub fn leading_monomial(&self) -> Option<Monomial> {
        self.terms.first().map(|t| t.0.clone())
    }

    /// The coefficient of the greatest term, zero for the zero polynomial.
    pub fn leading_coefficient(&self) -> BigInt {
        self.terms
            .first()
            .map_or_else(BigInt::zero, |t| t.1.clone())
    }

    /// The coefficient of a monomial, zero if it does not occur.
    pub fn coefficient(&self, exponents: &[u32]) -> BigInt {
        match self
            .terms
            .binary_search_by(|t| self.ring.compare(exponents, &t.0))
        {
            Ok(i) => self.terms[i].1.clone(),
            Err(_) => BigInt::zero(),
        }
    }

    /// The degree in one variable; `None` for the zero polynomial.
    pub fn degree(&self, variable: usize) -> Option<u32> {
        self.terms.iter().map(|t| t.0[variable]).max()
    }

    /// The degrees in all variables, zeros for the zero polynomial.
    pub fn degrees(&self) -> Vec<u32> {
        let mut degrees = vec![0; self.ring.len()];
        for (monomial, _) in &self.terms {
            for (d, &e) in degrees.iter_mut().zip(monomial.exponents()) {
                *d = (*d).max(e);
            }
        }
        degrees
    }

    /// The greatest total degree of a term; `None` for the zero polynomial.
    pub fn total_degree(&self) -> Option<u64> {
        self.terms.iter().map(|t| t.0.total_degree()).max()
    }

    /// The variables that occur, ascending.
    pub fn variables_occurring(&self) -> Vec<usize> {
        self.degrees()
            .iter()
            .enumerate()
            .filter(|(_, d)| **d > 0)
            .map(|(i, _)| i)
            .collect()
    }

    /// The nonnegative greatest common divisor of the coefficients.
    pub fn content(&self) -> BigInt {
        let mut content = BigInt::zero();
        for (_, c) in &self.terms {
            content = content.gcd(c);
            if content.is_one() {
                break;
            }
        }
        content
    }

    /// The polynomial divided by its content, with the sign of the leading coefficient kept.
    pub fn primitive_part(&self) -> Polynomial {
        let content = self.content();
        if content.is_zero() || content.is_one() {
            return self.clone();
        }
        self.map_coefficients(|c| c / &content)
    }

    /// `self` or `-self`, so that the leading coefficient is positive.
    pub fn unit_normal(&self) -> Polynomial {
        if self.terms.first().is_some_and(|t| t.1.is_negative()) {
            -self
        } else {
            self.clone()
        }
    }

    /// The greatest monomial that divides every term; 1 for the zero polynomial.
    pub fn monomial_content(&self) -> Monomial {
        let mut terms = self.terms.iter();
        let Some((first, _)) = terms.next() else {
            return Monomial::one(self.ring.len());
        };
        terms.fold(first.clone(), |content, (m, _)| content.gcd(m))
    }

    /// The largest number of bits of a coefficient.
    pub fn coefficient_bits(&self) -> u64 {
        self.terms.iter().map(|t| t.1.bits()).max().unwrap_or(0)
    }

    /// The coefficients as a polynomial in one variable: entry `k` belongs to its `k`-th power and no
    /// longer contains it. Empty for the zero polynomial.
    pub fn coefficients_in(&self, variable: usize) -> Vec<Polynomial> {
        let Some(degree) = self.degree(variable) else {
            return Vec::new();
        };
        let mut lists = vec![Vec::new(); degree as usize + 1];
        for (monomial, c) in &self.terms {
            let mut exponents = monomial.exponents().to_vec();
            let k = std::mem::take(&mut exponents[variable]);
            lists[k as usize].push((Monomial::new(exponents), c.clone()));
        }
        lists
            .into_iter()
            .map(|list| Polynomial::collect(self.ring, list))
            .collect()
    }

    /// The sum of `coefficients[k]` times the `k`-th power of a variable.
    pub fn from_coefficients_in(
        ring: Ring,
        variable: usize,
        coefficients: &[Polynomial],
    ) -> Result<Polynomial, Error> {
        if variable >= ring.len() {
            return Err(Error::VariableOutOfRange(variable));
        }
        let mut list = Vec::new();
        for (k, polynomial) in coefficients.iter().enumerate() {
            if polynomial.ring != ring {
                return Err(Error::RingMismatch);
            }
            let k = u32::try_from(k).map_err(|_| Error::ExponentOverflow)?;
            for (monomial, c) in &polynomial.terms {
                let mut exponents = monomial.exponents().to_vec();
                exponents[variable] = exponents[variable]
                    .checked_add(k)
                    .ok_or(Error::ExponentOverflow)?;
                list.push((Monomial::new(exponents), c.clone()));
            }
        }
        Ok(Polynomial::collect(ring, list))
    }

    /// The derivative with respect to one variable.
    pub fn derivative(&self, variable: usize) -> Polynomial {
        let list = self
            .terms
            .iter()
            .filter(|t| t.0[variable] > 0)
            .map(|(monomial, c)| {
                let mut exponents = monomial.exponents().to_vec();
                let e = exponents[variable];
                exponents[variable] -= 1;
                (Monomial::new(exponents), c * e)
            });
        Polynomial::collect(self.ring, list.collect())
    }

    /// Applies a map that sends nonzero coefficients to nonzero coefficients.
    pub(crate) fn map_coefficients(&self, f: impl Fn(&BigInt) -> BigInt) -> Polynomial {
        let terms = self.terms.iter().map(|(m, c)| (m.clone(), f(c))).collect();
        Polynomial {
            ring: self.ring,
            terms,
        }
    }

    /// Whether the invariants hold. They always do; tests ask.
    pub fn is_canonical(&self) -> bool {
        self.terms
            .iter()
            .all(|t| t.0.len() == self.ring.len() && !t.1.is_zero())
            && self
                .terms
                .windows(2)
                .all(|w| self.ring.compare(&w[0].0, &w[1].0).is_gt())
    }
}

impl PartialOrd for Polynomial {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Polynomial {
    /// A total order for sorting: by ring, then term by term (monomial, then coefficient) from the
    /// leading term down; a polynomial is greater than its own leading part.
    fn cmp(&self, other: &Self) -> Ordering {
        self.ring.cmp(&other.ring).then_with(|| {
            for (a, b) in self.terms.iter().zip(&other.terms) {
                let order = self.ring.compare(&a.0, &b.0).then_with(|| a.1.cmp(&b.1));
                if order.is_ne() {
                    return order;
                }
            }
            self.terms.len().cmp(&other.terms.len())
        })
    }
}
