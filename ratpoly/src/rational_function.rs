//! Rational functions over the rationals: reduced pairs of polynomials over the integers.
//!
//! Invariants: numerator and denominator have no common factor (no common integer either), the
//! denominator's leading coefficient is positive, zero is 0/1. Sums and products are formed as by
//! Henrici (1956; Knuth, TAOCP 2, 4.5.1): small gcds of the parts instead of one large gcd of the result.

use crate::allowance;
use crate::budget::Budget;
use crate::error::Error;
use crate::gcd::{Cofactors, gcd, gcd_cofactors_within};
use crate::lowest_terms::reduced;
use crate::polynomial::Polynomial;
use crate::powers::Powers;
use crate::ring::Ring;
use crate::substitute::occurring;
use num_rational::BigRational;
use num_traits::Zero;
use std::collections::{BTreeMap, BTreeSet};
use std::ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Sub, SubAssign};

/// A rational function over the rationals, canonical by construction: equality is structural.
#[derive(Clone, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct RationalFunction {
    numerator: Polynomial,
    denominator: Polynomial,
}

impl RationalFunction {
    /// The quotient of two polynomials, reduced.
    pub fn new(numerator: Polynomial, denominator: Polynomial) -> Result<Self, Error> {
        Self::new_within(numerator, denominator, &UNLIMITED)
    }

    /// The quotient of two polynomials, reduced within a budget.
    pub fn new_within(
        numerator: Polynomial,
        denominator: Polynomial,
        budget: &Budget,
    ) -> Result<Self, Error> {
        if numerator.ring() != denominator.ring() {
            return Err(Error::RingMismatch);
        }
        if denominator.is_zero() {
            return Err(Error::DivisionByZero);
        }
        let (numerator, denominator) = cancel(&numerator, &denominator, budget)?;
        Ok(RationalFunction::from_coprime(numerator, denominator))
    }

    /// The quotient of two polynomials without a common factor: only the sign is adjusted.
    pub(crate) fn from_coprime(numerator: Polynomial, denominator: Polynomial) -> Self {
        debug_assert!(!denominator.is_zero());
        if denominator.leads_negative() {
            RationalFunction {
                numerator: -numerator,
                denominator: -denominator,
            }
        } else {
            RationalFunction {
                numerator,
                denominator,
            }
        }
    }

    /// The zero function.
    pub fn zero(ring: Ring) -> Self {
        Polynomial::zero(ring).into()
    }

    /// The function 1.
    pub fn one(ring: Ring) -> Self {
        Polynomial::one(ring).into()
    }

    /// A constant function.
    pub fn constant(ring: Ring, value: BigRational) -> Self {
        let (numerator, denominator) = value.into_raw();
        RationalFunction {
            numerator: Polynomial::constant(ring, numerator),
            denominator: Polynomial::constant(ring, denominator),
        }
    }

    /// The variable at a position of the ring.
    ///
    /// # Panics
    /// If the ring has no such variable.
    pub fn variable(ring: Ring, index: usize) -> Self {
        Polynomial::variable(ring, index).into()
    }

    /// The ring of numerator and denominator.
    pub fn ring(&self) -> Ring {
        self.numerator.ring()
    }

    /// The numerator of the reduced pair.
    pub fn numerator(&self) -> &Polynomial {
        &self.numerator
    }

    /// The denominator of the reduced pair.
    pub fn denominator(&self) -> &Polynomial {
        &self.denominator
    }

    /// Numerator and denominator of the reduced pair.
    pub fn into_parts(self) -> (Polynomial, Polynomial) {
        (self.numerator, self.denominator)
    }

    /// Whether this is 0.
    pub fn is_zero(&self) -> bool {
        self.numerator.is_zero()
    }

    /// Whether this is 1.
    pub fn is_one(&self) -> bool {
        self.numerator.is_one() && self.denominator.is_one()
    }

    /// Whether the denominator is 1.
    pub fn is_polynomial(&self) -> bool {
        self.denominator.is_one()
    }

    /// The value of a constant function.
    pub fn as_constant(&self) -> Option<BigRational> {
        let (n, d) = (
            self.numerator.as_constant()?,
            self.denominator.as_constant()?,
        );
        Some(BigRational::new_raw(n, d))
    }

    /// The sum, or [`Error::RingMismatch`] or [`Error::ExponentOverflow`].
    pub fn try_add(&self, other: &Self) -> Result<Self, Error> {
        let ((a, b), (c, d)) = (self.parts(), other.parts());
        if b == d {
            let sum = a.try_add(c)?;
            return if b.is_one() {
                Ok(sum.into())
            } else {
                Self::new(sum, b.clone())
            };
        }
        if b.ring() != d.ring() {
            return Err(Error::RingMismatch);
        }
        let Cofactors {
            gcd: g,
            first: b,
            second: e,
        } = gcd_cofactors_within(b, d, &UNLIMITED)?;
        let sum = a.try_mul(&e)?.try_add(&c.try_mul(&b)?)?;
        if g.is_one() {
            return Ok(Self::from_coprime(sum, b.try_mul(&e)?));
        }
        // Only a factor of g can be left between the sum and the denominator g b e.
        let (sum, g) = cancel(&sum, &g, &UNLIMITED)?;
        Ok(Self::from_coprime(sum, g.try_mul(&b)?.try_mul(&e)?))
    }

    /// The difference, or [`Error::RingMismatch`] or [`Error::ExponentOverflow`].
    pub fn try_sub(&self, other: &Self) -> Result<Self, Error> {
        self.try_add(&-other)
    }

    /// The product, or [`Error::RingMismatch`] or [`Error::ExponentOverflow`].
    pub fn try_mul(&self, other: &Self) -> Result<Self, Error> {
        if self.ring() != other.ring() {
            return Err(Error::RingMismatch);
        }
        let ((a, b), (c, d)) = (self.parts(), other.parts());
        if b.is_one() && d.is_one() {
            return Ok(a.try_mul(c)?.into());
        }
        let (a, d) = cancel(a, d, &UNLIMITED)?;
        let (c, b) = cancel(c, b, &UNLIMITED)?;
        Ok(Self::from_coprime(a.try_mul(&c)?, b.try_mul(&d)?))
    }

    /// The quotient, or [`Error::DivisionByZero`], [`Error::RingMismatch`], [`Error::ExponentOverflow`].
    pub fn checked_div(&self, other: &Self) -> Result<Self, Error> {
        self.try_mul(&other.inverse()?)
    }

    /// The reciprocal, or [`Error::DivisionByZero`].
    pub fn inverse(&self) -> Result<Self, Error> {
        if self.is_zero() {
            return Err(Error::DivisionByZero);
        }
        Ok(Self::from_coprime(
            self.denominator.clone(),
            self.numerator.clone(),
        ))
    }

    /// The power, also with a negative exponent. The zeroth power is 1, also of 0.
    pub fn pow(&self, exponent: i32) -> Result<Self, Error> {
        self.pow_within(exponent, &UNLIMITED)
    }

    /// The power within a budget.
    pub fn pow_within(&self, exponent: i32, budget: &Budget) -> Result<Self, Error> {
        let base = if exponent < 0 {
            self.inverse()?
        } else {
            self.clone()
        };
        let e = exponent.unsigned_abs();
        Ok(Self::from_coprime(
            base.numerator.pow_within(e, budget)?,
            base.denominator.pow_within(e, budget)?,
        ))
    }

    /// The derivative with respect to one variable.
    pub fn derivative(&self, variable: usize) -> Result<Self, Error> {
        // With e = b / gcd(b, b'): (a/b)' = (a' e - a b' e / b) / (b e).
        let (a, b) = self.parts();
        let slope = b.derivative(variable);
        let (e, slope) = cancel(b, &slope, &UNLIMITED)?;
        let top = a
            .derivative(variable)
            .try_mul(&e)?
            .try_sub(&a.try_mul(&slope)?)?;
        Self::new(top, b.try_mul(&e)?)
    }

    /// The value at a rational point, one coordinate for each variable; [`Error::DivisionByZero`] at a
    /// zero of the reduced denominator.
    pub fn evaluate(&self, point: &[BigRational]) -> Result<BigRational, Error> {
        let (c, d) = self.denominator.fraction_at(point, &UNLIMITED)?;
        if c.is_zero() {
            return Err(Error::DivisionByZero);
        }
        let (a, b) = self.numerator.fraction_at(point, &UNLIMITED)?;
        Ok(reduced(a * d, b * c))
    }

    /// Replaces some variables, all at once, by rational functions of the same ring;
    /// [`Error::DivisionByZero`] if the reduced denominator vanishes identically.
    pub fn substitute(&self, images: &[(usize, RationalFunction)]) -> Result<Self, Error> {
        if images.iter().any(|(_, image)| image.ring() != self.ring()) {
            return Err(Error::RingMismatch);
        }
        let above = occurring(&self.numerator, images)?;
        let below = occurring(&self.denominator, images)?;
        if above.is_empty() && below.is_empty() {
            return Ok(self.clone());
        }
        let mut top = self.numerator.homogenised(&above)?;
        let mut bottom = self.denominator.homogenised(&below)?;
        // Each lacks the power of an image's denominator that its degree says; what both lack cancels.
        let images: BTreeMap<_, _> = above.into_iter().chain(below).collect();
        for (variable, image) in images {
            let degree = |f: &Polynomial| f.degree(variable).unwrap_or(0);
            let (m, n) = (degree(&self.numerator), degree(&self.denominator));
            let power = image.denominator.try_pow(m.abs_diff(n))?;
            if m > n {
                bottom = bottom.try_mul(&power)?;
            } else {
                top = top.try_mul(&power)?;
            }
        }
        Self::new(top, bottom)
    }

    /// The value at rational functions of a ring, one for each variable of `self`.
    pub fn compose(&self, target: Ring, images: &[RationalFunction]) -> Result<Self, Error> {
        let numerator = self.numerator.compose_rational(target, images)?;
        numerator.checked_div(&self.denominator.compose_rational(target, images)?)
    }

    /// The same function in another ring; see [`Polynomial::map_ring`]. Variables may become equal, then
    /// the denominator may vanish: [`Error::DivisionByZero`].
    pub fn map_ring(&self, target: Ring, map: &[Option<usize>]) -> Result<Self, Error> {
        Self::new(
            self.numerator.map_ring(target, map)?,
            self.denominator.map_ring(target, map)?,
        )
    }

    /// The same function in a ring that has all the variables that occur, matched by name.
    pub fn to_ring(&self, target: Ring) -> Result<Self, Error> {
        Ok(Self::from_coprime(
            self.numerator.to_ring(target)?,
            self.denominator.to_ring(target)?,
        ))
    }

    /// Whether the invariants hold. They always do; tests ask.
    pub fn is_canonical(&self) -> bool {
        self.numerator.is_canonical()
            && self.denominator.is_canonical()
            && !self.denominator.leads_negative()
            && !self.denominator.is_zero()
            && gcd(&self.numerator, &self.denominator).is_one()
    }

    fn parts(&self) -> (&Polynomial, &Polynomial) {
        (&self.numerator, &self.denominator)
    }
}

impl Polynomial {
    /// The sum of `c * product n_i^e_i d_i^(deg_i - e_i)` for the images `n_i / d_i` of some variables.
    fn homogenised(
        &self,
        images: &BTreeMap<usize, &RationalFunction>,
    ) -> Result<Polynomial, Error> {
        let variables: Vec<usize> = images.keys().copied().collect();
        let groups = self.coefficients_in_all(&variables);
        let mut tables = Vec::with_capacity(images.len());
        for (k, (&i, image)) in images.iter().enumerate() {
            let degree = self.degree(i).unwrap_or(0);
            let table = |base: &Polynomial, exponents: BTreeSet<u32>| {
                Powers::new(&exponents, |e| base.try_pow(e), |a, b| a.try_mul(b))
            };
            let up = groups.keys().map(|e| e[k]);
            let down = groups.keys().map(|e| degree - e[k]);
            tables.push((
                degree,
                table(&image.numerator, up.collect())?,
                table(&image.denominator, down.collect())?,
            ));
        }
        let summands = groups.into_iter().map(|(exponents, mut value)| {
            for (&e, (degree, top, bottom)) in exponents.iter().zip(&tables) {
                for factor in [top.get(e), bottom.get(degree - e)] {
                    if !factor.is_one() {
                        value = value.try_mul(factor)?;
                    }
                }
            }
            Ok(value)
        });
        Polynomial::sum(self.ring(), summands)
    }

    /// The value at rational functions of a ring, one for each variable of `self`.
    pub fn compose_rational(
        &self,
        target: Ring,
        images: &[RationalFunction],
    ) -> Result<RationalFunction, Error> {
        // Homogenised: sum of c * product n_i^e_i d_i^(deg_i - e_i), over the product of d_i^deg_i.
        let expected = self.ring().len();
        if images.len() != expected {
            return Err(Error::WrongLength {
                expected,
                found: images.len(),
            });
        }
        if images.iter().any(|image| image.ring() != target) {
            return Err(Error::RingMismatch);
        }
        let powers = |base: &Polynomial, degree: u32| -> Result<Vec<Polynomial>, Error> {
            let mut table = vec![Polynomial::one(target)];
            for k in 0..degree as usize {
                let next = table[k].try_mul(base)?;
                table.push(next);
            }
            Ok(table)
        };
        let degrees = self.degrees();
        let mut tables = Vec::new();
        let mut denominator = Polynomial::one(target);
        for (image, &degree) in images.iter().zip(&degrees) {
            let (n, d) = (
                powers(&image.numerator, degree)?,
                powers(&image.denominator, degree)?,
            );
            denominator = denominator.try_mul(&d[degree as usize])?;
            tables.push((n, d));
        }
        let mut sum = Polynomial::zero(target);
        for (monomial, c) in self.terms() {
            let mut value = Polynomial::constant(target, c);
            for ((&e, &degree), (n, d)) in monomial.iter().zip(&degrees).zip(&tables) {
                value = value
                    .try_mul(&n[e as usize])?
                    .try_mul(&d[(degree - e) as usize])?;
            }
            sum = sum.try_add(&value)?;
        }
        RationalFunction::new(sum, denominator)
    }
}

impl From<Polynomial> for RationalFunction {
    fn from(numerator: Polynomial) -> Self {
        let denominator = Polynomial::one(numerator.ring());
        RationalFunction {
            numerator,
            denominator,
        }
    }
}

static UNLIMITED: Budget = Budget::unlimited();

/// What a common divisor counts at least in the steps of an allowance.
const GCD: u64 = 60;

/// Both polynomials without their common factor.
fn cancel(
    f: &Polynomial,
    g: &Polynomial,
    budget: &Budget,
) -> Result<(Polynomial, Polynomial), Error> {
    if f.is_one() || g.is_one() {
        return Ok((f.clone(), g.clone()));
    }
    // Also of the smallest operands it is some tens of operations.
    allowance::spend(GCD);
    let Cofactors { first, second, .. } = gcd_cofactors_within(f, g, budget)?;
    Ok((first, second))
}

impl Neg for &RationalFunction {
    type Output = RationalFunction;
    fn neg(self) -> RationalFunction {
        RationalFunction {
            numerator: -&self.numerator,
            denominator: self.denominator.clone(),
        }
    }
}

impl Neg for RationalFunction {
    type Output = RationalFunction;
    fn neg(self) -> RationalFunction {
        RationalFunction {
            numerator: -self.numerator,
            denominator: self.denominator,
        }
    }
}

macro_rules! operator {
    ($trait:ident $method:ident $assign:ident $assign_method:ident $checked:ident) => {
        /// # Panics
        /// If the operands belong to different rings, on an exponent overflow, on division by zero.
        impl $trait<&RationalFunction> for &RationalFunction {
            type Output = RationalFunction;
            fn $method(self, other: &RationalFunction) -> RationalFunction {
                self.$checked(other).unwrap_or_else(|e| panic!("{e}"))
            }
        }
        impl $trait<RationalFunction> for &RationalFunction {
            type Output = RationalFunction;
            fn $method(self, other: RationalFunction) -> RationalFunction {
                $trait::$method(self, &other)
            }
        }
        impl $trait<&RationalFunction> for RationalFunction {
            type Output = RationalFunction;
            fn $method(self, other: &RationalFunction) -> RationalFunction {
                $trait::$method(&self, other)
            }
        }
        impl $trait<RationalFunction> for RationalFunction {
            type Output = RationalFunction;
            fn $method(self, other: RationalFunction) -> RationalFunction {
                $trait::$method(&self, &other)
            }
        }
        impl $assign<&RationalFunction> for RationalFunction {
            fn $assign_method(&mut self, other: &RationalFunction) {
                *self = $trait::$method(&*self, other);
            }
        }
        impl $assign<RationalFunction> for RationalFunction {
            fn $assign_method(&mut self, other: RationalFunction) {
                *self = $trait::$method(&*self, &other);
            }
        }
    };
}

operator!(Add add AddAssign add_assign try_add);
operator!(Sub sub SubAssign sub_assign try_sub);
operator!(Mul mul MulAssign mul_assign try_mul);
operator!(Div div DivAssign div_assign checked_div);
