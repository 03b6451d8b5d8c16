//! Division: exact, with remainder by one or many, pseudo-division.

use crate::divide_heap::{Outcome, divide};
use crate::error::Error;
use crate::polynomial::{Polynomial, layout_of};
use crate::scalar::Scalar;
use crate::terms::same_layout;
use num_bigint::BigInt;

impl Polynomial {
    /// The quotient if `divisor` divides; `None` if it does not or is zero.
    ///
    /// # Panics
    /// If the operands belong to different rings.
    pub fn div_exact(&self, divisor: &Polynomial) -> Option<Polynomial> {
        if self.ring != divisor.ring {
            panic!("{}", Error::RingMismatch);
        }
        // A divisor with greater exponents than the dividend does not divide; both are canonical.
        if divisor.is_zero() || (!self.is_zero() && divisor.terms.kind() > self.terms.kind()) {
            return None;
        }
        same_layout!(self.ring, &self.terms, &divisor.terms, a, b => {
            match divide(a, b, layout_of(a, self.ring)) {
                Outcome::Quotient(list) => Some(self.with(list)),
                Outcome::NotDivisible => None,
            }
        })
    }

    /// Whether `self` divides `other`. Zero divides only zero.
    pub fn divides(&self, other: &Polynomial) -> bool {
        if self.is_zero() {
            other.is_zero()
        } else {
            other.div_exact(self).is_some()
        }
    }

    /// Division of every coefficient by an integer, if it divides them all; zero divides nothing.
    pub fn div_integer(&self, divisor: &BigInt) -> Option<Polynomial> {
        self.div_scalar(&divisor.into())
    }

    pub(crate) fn div_scalar(&self, divisor: &Scalar) -> Option<Polynomial> {
        if divisor.is_zero() {
            return None;
        }
        self.map_coefficients(|c| divisor.divide(c))
    }

    /// Division by a list (Cox, Little, O'Shea, Ideals, Varieties, and Algorithms, section 2.3): quotients
    /// `q` and remainder `r` with `self = sum q[i] divisors[i] + r`, where no term of `r` is divisible, as
    /// a term over the integers (monomial and coefficient), by the leading term of a divisor.
    pub fn div_rem(
        &self,
        divisors: &[&Polynomial],
    ) -> Result<(Vec<Polynomial>, Polynomial), Error> {
        for divisor in divisors {
            self.check_ring(divisor)?;
            if divisor.is_zero() {
                return Err(Error::DivisionByZero);
            }
        }
        let leading: Vec<_> = divisors.iter().map(|g| g.leading_scalar()).collect();
        let mut rest = self.clone();
        let mut quotients = vec![Vec::new(); divisors.len()];
        let mut remainder = Vec::new();
        while let Some((monomial, c)) = rest.leading_scalar() {
            let step = leading.iter().enumerate().find_map(|(i, lead)| {
                let (lm, lc) = lead.as_ref()?;
                Some((i, monomial.checked_div(lm)?, lc.divide(c.value())?))
            });
            match step {
                Some((i, quotient, factor)) => {
                    let term = Polynomial::from_term(self.ring, &quotient, factor.clone());
                    rest = rest.try_sub(&term.try_mul(divisors[i])?)?;
                    quotients[i].push((quotient, factor));
                }
                None => {
                    rest -= Polynomial::from_term(self.ring, &monomial, c.clone());
                    remainder.push((monomial, c));
                }
            }
        }
        let ring = self.ring;
        let quotients = quotients
            .into_iter()
            .map(|q| Polynomial::from_list(ring, q))
            .collect();
        Ok((quotients, Polynomial::from_list(ring, remainder)))
    }

    /// Pseudo-division in one variable (Knuth, TAOCP 2, 4.6.1, algorithm R): quotient `q` and remainder
    /// `r` with `lc^(deg self - deg divisor + 1) self = q divisor + r` and `deg r < deg divisor`, where `lc`
    /// is the divisor's leading coefficient in that variable. If `deg self < deg divisor`, then `(0, self)`.
    pub fn pseudo_div_rem(
        &self,
        divisor: &Polynomial,
        variable: usize,
    ) -> Result<(Polynomial, Polynomial), Error> {
        let ring = self.ring;
        self.check_ring(divisor)?;
        if variable >= ring.len() {
            return Err(Error::VariableOutOfRange(variable));
        }
        let Some(d) = divisor.degree(variable) else {
            return Err(Error::DivisionByZero);
        };
        let mut quotient = Polynomial::zero(ring);
        let mut rest = self.clone();
        let Some(mut missing) = self.degree(variable).and_then(|n| (n + 1).checked_sub(d)) else {
            return Ok((quotient, rest));
        };
        let lc = divisor
            .coefficients_in(variable)
            .pop()
            .expect("the divisor is not zero");
        while let Some(n) = rest.degree(variable).filter(|n| *n >= d) {
            let head = rest
                .coefficients_in(variable)
                .pop()
                .expect("the rest is not zero");
            let mut shift = vec![0; ring.len()];
            shift[variable] = n - d;
            let term = head.mul_term(&shift, &BigInt::from(1))?;
            quotient = quotient.try_mul(&lc)?.try_add(&term)?;
            rest = rest.try_mul(&lc)?.try_sub(&term.try_mul(divisor)?)?;
            missing -= 1;
        }
        let power = lc.try_pow(missing)?;
        Ok((quotient.try_mul(&power)?, rest.try_mul(&power)?))
    }

    /// The remainder of [`pseudo_div_rem`](Self::pseudo_div_rem).
    pub fn pseudo_remainder(
        &self,
        divisor: &Polynomial,
        variable: usize,
    ) -> Result<Polynomial, Error> {
        Ok(self.pseudo_div_rem(divisor, variable)?.1)
    }
}
