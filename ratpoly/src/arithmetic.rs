//! The operators of polynomials: sums, products, powers, and their forms with typed errors and budgets.

use crate::allowance;
use crate::budget::Budget;
use crate::error::{Error, Resource};
use crate::multiply::{Failure, multiply};
use crate::polynomial::{Polynomial, layout_of};
use crate::ring::Ring;
use crate::scalar::Scalar;
use crate::sum_of_products::fused;
use crate::terms::{each_layout, each_width, same_layout};
use num_bigint::BigInt;
use std::ops::{Add, AddAssign, Mul, MulAssign, Neg, Sub, SubAssign};

impl Polynomial {
    /// The sum, or [`Error::RingMismatch`].
    pub fn try_add(&self, other: &Polynomial) -> Result<Polynomial, Error> {
        self.check_ring(other)?;
        self.allow_sum(other);
        Ok(
            same_layout!(self.ring, &self.terms, &other.terms, a, b => self.with(a.merge::<false>(b))),
        )
    }

    /// The difference, or [`Error::RingMismatch`].
    pub fn try_sub(&self, other: &Polynomial) -> Result<Polynomial, Error> {
        self.check_ring(other)?;
        self.allow_sum(other);
        Ok(
            same_layout!(self.ring, &self.terms, &other.terms, a, b => self.with(a.merge::<true>(b))),
        )
    }

    /// Holds this polynomial to the memory that one may take.
    fn allow(&self) {
        let bytes = 24 + 8 * self.ring.len() + self.coefficient_bits() as usize / 8;
        allowance::reserve(self.len().saturating_mul(bytes));
    }

    /// Counts a sum against the allowance of the thread, before it is formed.
    pub(crate) fn allow_sum(&self, other: &Polynomial) {
        let terms = self.len() + other.len();
        allowance::spend(4 + terms as u64);
        // The length of a coefficient is asked for only where it can matter.
        let bytes = terms.saturating_mul(24 + 8 * self.ring.len());
        allowance::reserve(bytes);
    }

    /// The product, or [`Error::RingMismatch`] or [`Error::ExponentOverflow`].
    pub fn try_mul(&self, other: &Polynomial) -> Result<Polynomial, Error> {
        self.check_ring(other)?;
        match fused(self.ring, &[(false, self, other)]) {
            Some(product) => Ok(product),
            None => self.mul_within(other, &UNLIMITED),
        }
    }

    /// The power, or [`Error::ExponentOverflow`]. The zeroth power is 1, also of 0.
    pub fn try_pow(&self, exponent: u32) -> Result<Polynomial, Error> {
        self.pow_within(exponent, &UNLIMITED)
    }

    /// The product within a budget.
    pub fn mul_within(&self, other: &Polynomial, budget: &Budget) -> Result<Polynomial, Error> {
        self.check_ring(other)?;
        let ring = self.ring;
        let product = same_layout!(ring, &self.terms, &other.terms, a, b => {
            multiply(a, b, layout_of(a, ring), budget).map(|list| self.with(list))
        });
        match product {
            Ok(product) => {
                product.allow();
                Ok(product)
            }
            Err(Failure::Error(error)) => Err(error),
            Err(Failure::Layout) => self.mul_wider(other, budget),
        }
    }

    /// The product, whose exponents do not fit the operands' layout.
    #[cold]
    fn mul_wider(&self, other: &Polynomial, budget: &Budget) -> Result<Polynomial, Error> {
        let ring = self.ring;
        let narrow = self.terms.kind().max(other.terms.kind());
        for kind in narrow + 1..crate::layout::KINDS {
            if ring.layout(kind).is_none() {
                continue;
            }
            let (a, b) = (
                self.terms.in_kind(ring, kind),
                other.terms.in_kind(ring, kind),
            );
            let product = same_layout!(ring, &a, &b, a, b => {
                multiply(a, b, layout_of(a, ring), budget).map(|list| self.with(list))
            });
            match product {
                Ok(product) => return Ok(product),
                Err(Failure::Error(error)) => return Err(error),
                Err(Failure::Layout) => {}
            }
        }
        Err(Error::ExponentOverflow)
    }

    /// The power within a budget.
    pub fn pow_within(&self, exponent: u32, budget: &Budget) -> Result<Polynomial, Error> {
        if exponent == 0 || self.is_one() {
            return Ok(Polynomial::one(self.ring));
        }
        if self.len() == 1 {
            let (monomial, c) = self.leading_term().expect("one term");
            let power = monomial
                .iter()
                .map(|&e| e.checked_mul(exponent))
                .collect::<Option<Vec<_>>>();
            // c^k has more than (bits(c) - 1) k bits.
            let power = power.ok_or(Error::ExponentOverflow)?;
            budget.check_bits((c.bits() - 1).saturating_mul(u64::from(exponent)))?;
            budget.spend((c.bits() - 1).saturating_mul(u64::from(exponent)) / 64)?;
            let c = c.pow(exponent);
            return Ok(Polynomial::from_term(self.ring, &power, c.into()));
        }
        if self.is_zero() {
            return Ok(Polynomial::zero(self.ring));
        }
        refuse_hopeless_power(exponent, budget)?;
        // For sparse polynomials repeated multiplication beats repeated squaring (Fateman 1974).
        let mut power = self.clone();
        for _ in 1..exponent {
            // A product with a coefficient of many words is as many steps.
            let words = power.coefficient_bits() / 64;
            budget.spend((power.len() as u64 * self.len() as u64).saturating_mul(words))?;
            power = power.mul_within(self, budget)?;
        }
        Ok(power)
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
        self.mul_scalar(&factor.into())
    }

    pub(crate) fn mul_scalar(&self, factor: &Scalar) -> Polynomial {
        if factor.is_zero() {
            return Polynomial::zero(self.ring);
        }
        if factor.is_one() {
            return self.clone();
        }
        self.map_coefficients(|c| Some(factor.times(c)))
            .expect("a product always exists")
    }

    /// The product with a term.
    pub fn mul_term(&self, exponents: &[u32], factor: &BigInt) -> Result<Polynomial, Error> {
        if exponents.len() != self.ring.len() {
            return Err(Error::WrongLength {
                expected: self.ring.len(),
                found: exponents.len(),
            });
        }
        self.try_mul(&Polynomial::from_term(self.ring, exponents, factor.into()))
    }

    /// The sum of polynomials of a ring, each taken when the ones before are added. Sums wait for one of
    /// like length, as in a binary counter, so that no long one is copied often and few are held at once.
    pub(crate) fn sum(
        ring: Ring,
        summands: impl IntoIterator<Item = Result<Polynomial, Error>>,
    ) -> Result<Polynomial, Error> {
        let mut waiting: Vec<Polynomial> = Vec::new();
        for summand in summands {
            let mut sum = summand?;
            while let Some(last) = waiting.pop_if(|last| last.len() <= 2 * sum.len()) {
                sum = last.try_add(&sum)?;
            }
            waiting.push(sum);
        }
        let mut sum = waiting.pop().unwrap_or_else(|| Polynomial::zero(ring));
        while let Some(last) = waiting.pop() {
            sum = last.try_add(&sum)?;
        }
        sum.shrink();
        Ok(sum)
    }

    /// Gives back room that cancelled terms have left.
    fn shrink(&mut self) {
        each_layout!(&mut self.terms, list => each_width!(list, terms => {
            if terms.capacity() / 5 > terms.len() / 4 {
                terms.shrink_to_fit();
            }
        }));
    }

    pub(crate) fn check_ring(&self, other: &Polynomial) -> Result<(), Error> {
        if self.ring == other.ring {
            Ok(())
        } else {
            Err(Error::RingMismatch)
        }
    }
}

/// Refuses the k-th power of a polynomial of several terms if even that of a binomial passes the budget.
/// Along an edge of Newton's polytope it has k + 1 terms at least, and by Parseval's identity a coefficient
/// of k/2 bits, less the logarithm of the number of terms.
fn refuse_hopeless_power(exponent: u32, budget: &Budget) -> Result<(), Error> {
    let k = u64::from(exponent);
    budget.check_terms(exponent as usize)?;
    budget.check_bits((k / 2).saturating_sub(64))?;
    let steps = u128::from(k).pow(2) / 2 + u128::from(k).pow(3) / 400;
    if steps > u128::from(budget.steps()) {
        return Err(Error::BudgetExceeded(Resource::Steps));
    }
    Ok(())
}

static UNLIMITED: Budget = Budget::unlimited();

impl Neg for &Polynomial {
    type Output = Polynomial;
    fn neg(self) -> Polynomial {
        each_layout!(&self.terms, list => self.with(list.negated()))
    }
}

impl Neg for Polynomial {
    type Output = Polynomial;
    fn neg(mut self) -> Polynomial {
        self.negate();
        self
    }
}

/// # Panics
/// If the operands belong to different rings.
impl AddAssign<&Polynomial> for Polynomial {
    fn add_assign(&mut self, other: &Polynomial) {
        if !self.merge_in_place::<false>(other) {
            *self = self.try_add(other).unwrap_or_else(|e| panic!("{e}"));
        }
    }
}

/// # Panics
/// If the operands belong to different rings.
impl SubAssign<&Polynomial> for Polynomial {
    fn sub_assign(&mut self, other: &Polynomial) {
        if !self.merge_in_place::<true>(other) {
            *self = self.try_sub(other).unwrap_or_else(|e| panic!("{e}"));
        }
    }
}

/// # Panics
/// If the operands belong to different rings, or on an exponent overflow.
impl MulAssign<&Polynomial> for Polynomial {
    fn mul_assign(&mut self, other: &Polynomial) {
        *self = &*self * other;
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
            fn $method(mut self, other: &Polynomial) -> Polynomial {
                $assign::$assign_method(&mut self, other);
                self
            }
        }
        impl $trait<Polynomial> for Polynomial {
            type Output = Polynomial;
            fn $method(mut self, other: Polynomial) -> Polynomial {
                $assign::$assign_method(&mut self, &other);
                self
            }
        }
        impl $assign<Polynomial> for Polynomial {
            fn $assign_method(&mut self, other: Polynomial) {
                $assign::$assign_method(self, &other);
            }
        }
    };
}

operator!(Add add AddAssign add_assign try_add);
operator!(Sub sub SubAssign sub_assign try_sub);
operator!(Mul mul MulAssign mul_assign try_mul);
