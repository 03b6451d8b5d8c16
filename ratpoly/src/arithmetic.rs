//! Addition, multiplication and powers of polynomials.

use crate::budget::Budget;
use crate::error::Error;
use crate::monomial::Monomial;
use crate::polynomial::Polynomial;
use num_bigint::BigInt;
use num_traits::{One, Zero};
use std::ops::{Add, AddAssign, Mul, MulAssign, Neg, Sub, SubAssign};

impl Polynomial {
    /// The sum, or [`Error::RingMismatch`].
    pub fn try_add(&self, other: &Polynomial) -> Result<Polynomial, Error> {
        let ring = self.ring();
        if ring != other.ring() {
            return Err(Error::RingMismatch);
        }
        let list = self
            .raw_terms()
            .iter()
            .chain(other.raw_terms())
            .cloned()
            .collect();
        Ok(Polynomial::collect(ring, list))
    }

    /// The difference, or [`Error::RingMismatch`].
    pub fn try_sub(&self, other: &Polynomial) -> Result<Polynomial, Error> {
        self.try_add(&-other)
    }

    /// The product, or [`Error::RingMismatch`] or [`Error::ExponentOverflow`].
    pub fn try_mul(&self, other: &Polynomial) -> Result<Polynomial, Error> {
        self.mul_within(other, &Budget::unlimited())
    }

    /// The power, or [`Error::ExponentOverflow`]. The zeroth power is 1, also of 0.
    pub fn try_pow(&self, exponent: u32) -> Result<Polynomial, Error> {
        self.pow_within(exponent, &Budget::unlimited())
    }

    /// The product within a budget.
    pub fn mul_within(&self, other: &Polynomial, budget: &Budget) -> Result<Polynomial, Error> {
        let ring = self.ring();
        if ring != other.ring() {
            return Err(Error::RingMismatch);
        }
        let mut list = Vec::new();
        for (m, c) in self.raw_terms() {
            budget.spend(other.len() as u64)?;
            for (n, d) in other.raw_terms() {
                list.push((m.checked_mul(n).ok_or(Error::ExponentOverflow)?, c * d));
            }
            if list.len() > 1 << 20 {
                let partial = Polynomial::collect(ring, list);
                budget.check_terms(partial.len())?;
                list = partial.raw_terms().to_vec();
            }
        }
        let product = Polynomial::collect(ring, list);
        budget.check_terms(product.len())?;
        budget.check_bits(product.coefficient_bits())?;
        Ok(product)
    }

    /// The power within a budget.
    pub fn pow_within(&self, exponent: u32, budget: &Budget) -> Result<Polynomial, Error> {
        if let [(m, c)] = self.raw_terms() {
            let power = m
                .iter()
                .map(|&e| e.checked_mul(exponent))
                .collect::<Option<Vec<_>>>();
            budget.check_bits((c.bits() - 1).saturating_mul(u64::from(exponent)))?;
            let power = power.ok_or(Error::ExponentOverflow)?;
            let term = (
                Monomial::new(power),
                num_traits::pow(c.clone(), exponent as usize),
            );
            return Ok(Polynomial::collect(self.ring(), vec![term]));
        }
        let mut result = Polynomial::one(self.ring());
        // For sparse polynomials repeated multiplication beats repeated squaring.
        for _ in 0..exponent {
            result = result.mul_within(self, budget)?;
            if result.is_zero() {
                break;
            }
        }
        Ok(result)
    }

    /// The power; see [`try_pow`](Self::try_pow).
    ///
    /// # Panics
    /// On an exponent overflow.
    pub fn pow(&self, exponent: u32) -> Polynomial {
        self.try_pow(exponent).unwrap_or_else(|e| panic!("{e}"))
    }

    /// The product with an integer.
    pub fn mul_integer(&self, factor: &BigInt) -> Polynomial {
        if factor.is_zero() {
            return Polynomial::zero(self.ring());
        }
        if factor.is_one() {
            return self.clone();
        }
        self.map_coefficients(|c| c * factor)
    }

    /// The product with a term.
    pub fn mul_term(&self, exponents: &[u32], factor: &BigInt) -> Result<Polynomial, Error> {
        self.try_mul(&Polynomial::from_terms(
            self.ring(),
            [(exponents, factor.clone())],
        )?)
    }

    /// The sum of the products of pairs, in one pass.
    pub fn sum_of_products<'a>(
        ring: crate::Ring,
        pairs: impl IntoIterator<Item = (&'a Polynomial, &'a Polynomial)>,
    ) -> Result<Polynomial, Error> {
        let mut sum = Polynomial::zero(ring);
        for (f, g) in pairs {
            sum = sum.try_add(&f.try_mul(g)?)?;
        }
        Ok(sum)
    }
}

impl Neg for &Polynomial {
    type Output = Polynomial;
    fn neg(self) -> Polynomial {
        self.map_coefficients(|c| -c)
    }
}

impl Neg for Polynomial {
    type Output = Polynomial;
    fn neg(self) -> Polynomial {
        -&self
    }
}

macro_rules! operator {
    ($trait:ident $method:ident $assign:ident $assign_method:ident $checked:ident) => {
        /// # Panics
        /// If the operands belong to different rings, or on an exponent overflow.
        impl $trait<&Polynomial> for &Polynomial {
            type Output = Polynomial;
            fn $method(self, other: &Polynomial) -> Polynomial {
                self.$checked(other).unwrap_or_else(|e| panic!("{e}"))
            }
        }
        impl $trait<Polynomial> for &Polynomial {
            type Output = Polynomial;
            fn $method(self, other: Polynomial) -> Polynomial {
                $trait::$method(self, &other)
            }
        }
        impl $trait<&Polynomial> for Polynomial {
            type Output = Polynomial;
            fn $method(self, other: &Polynomial) -> Polynomial {
                $trait::$method(&self, other)
            }
        }
        impl $trait<Polynomial> for Polynomial {
            type Output = Polynomial;
            fn $method(self, other: Polynomial) -> Polynomial {
                $trait::$method(&self, &other)
            }
        }
        impl $assign<&Polynomial> for Polynomial {
            fn $assign_method(&mut self, other: &Polynomial) {
                *self = $trait::$method(&*self, other);
            }
        }
        impl $assign<Polynomial> for Polynomial {
            fn $assign_method(&mut self, other: Polynomial) {
                *self = $trait::$method(&*self, &other);
            }
        }
    };
}

operator!(Add add AddAssign add_assign try_add);
operator!(Sub sub SubAssign sub_assign try_sub);
operator!(Mul mul MulAssign mul_assign try_mul);
