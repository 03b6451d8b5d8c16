//! Monomials at the interface: exponent vectors. (Inside a polynomial they may be packed.)

use std::ops::Deref;

/// A power product of the variables of a ring, given by its exponents. It knows no ring: two are
/// compared in a ring's order by [`Ring::compare`](crate::Ring::compare).
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub struct Monomial(Box<[u32]>);

impl Monomial {
    /// The power product with these exponents.
    pub fn new(exponents: impl Into<Box<[u32]>>) -> Self {
        Monomial(exponents.into())
    }

    /// The empty product.
    pub fn one(variables: usize) -> Self {
        Monomial(vec![0; variables].into())
    }

    /// The exponents.
    pub fn exponents(&self) -> &[u32] {
        &self.0
    }

    /// The sum of the exponents.
    pub fn total_degree(&self) -> u64 {
        self.0.iter().map(|&e| u64::from(e)).sum()
    }

    /// Whether all exponents are zero.
    pub fn is_one(&self) -> bool {
        self.0.iter().all(|&e| e == 0)
    }

    /// The product, unless an exponent overflows.
    pub fn checked_mul(&self, other: &Self) -> Option<Self> {
        self.zip(other, u32::checked_add)
    }

    /// The quotient, if `other` divides.
    pub fn checked_div(&self, other: &Self) -> Option<Self> {
        self.zip(other, u32::checked_sub)
    }

    /// Whether `self` divides `other`.
    pub fn divides(&self, other: &Self) -> bool {
        self.0.iter().zip(&other.0).all(|(a, b)| a <= b)
    }

    /// The greatest common divisor.
    pub fn gcd(&self, other: &Self) -> Self {
        Monomial(
            self.0
                .iter()
                .zip(&other.0)
                .map(|(&a, &b)| a.min(b))
                .collect(),
        )
    }

    /// The least common multiple.
    pub fn lcm(&self, other: &Self) -> Self {
        Monomial(
            self.0
                .iter()
                .zip(&other.0)
                .map(|(&a, &b)| a.max(b))
                .collect(),
        )
    }

    fn zip(&self, other: &Self, f: impl Fn(u32, u32) -> Option<u32>) -> Option<Self> {
        debug_assert_eq!(self.0.len(), other.0.len());
        self.0
            .iter()
            .zip(&other.0)
            .map(|(&a, &b)| f(a, b))
            .collect::<Option<_>>()
            .map(Monomial)
    }
}

impl Deref for Monomial {
    type Target = [u32];
    fn deref(&self) -> &[u32] {
        &self.0
    }
}

impl AsRef<[u32]> for Monomial {
    fn as_ref(&self) -> &[u32] {
        &self.0
    }
}
