//! Exact division, division with remainder, pseudo-division.

use crate::error::Error;
use crate::monomial::Monomial;
use crate::polynomial::Polynomial;
use num_bigint::BigInt;
use num_integer::Integer as _;
use num_traits::Zero;

impl Polynomial {
    /// The quotient if `divisor` divides; `None` if it does not or is zero.
    ///
    /// # Panics
    /// If the operands belong to different rings.
    pub fn div_exact(&self, divisor: &Polynomial) -> Option<Polynomial> {
        assert!(self.ring() == divisor.ring(), "{}", Error::RingMismatch);
        if divisor.is_zero() {
            return None;
        }
        let (quotients, remainder) = self.divide(&[divisor], true);
        remainder.is_zero().then(|| {
            quotients
                .into_iter()
                .next()
                .expect("one divisor, one quotient")
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

    /// Division of every coefficient by an integer, if it divides them all.
    pub fn div_integer(&self, divisor: &BigInt) -> Option<Polynomial> {
        if divisor.is_zero()
            || self
                .raw_terms()
                .iter()
                .any(|t| !t.1.is_multiple_of(divisor))
        {
            return None;
        }
        Some(self.map_coefficients(|c| c / divisor))
    }

    /// Division by a list (Cox, Little, O'Shea, Ideals, Varieties, and Algorithms, section 2.3): quotients
    /// `q` and remainder `r` with `self = sum q[i] divisors[i] + r`, where no term of `r` is divisible, as
    /// a term over the integers (monomial and coefficient), by the leading term of a divisor.
    pub fn div_rem(
        &self,
        divisors: &[&Polynomial],
    ) -> Result<(Vec<Polynomial>, Polynomial), Error> {
        for divisor in divisors {
            if divisor.ring() != self.ring() {
                return Err(Error::RingMismatch);
            }
            if divisor.is_zero() {
                return Err(Error::DivisionByZero);
            }
        }
        Ok(self.divide(divisors, false))
    }

    fn divide(&self, divisors: &[&Polynomial], exact: bool) -> (Vec<Polynomial>, Polynomial) {
        let ring = self.ring();
        let mut rest = self.clone();
        let mut quotients: Vec<Vec<(Monomial, BigInt)>> = vec![Vec::new(); divisors.len()];
        let mut remainder = Vec::new();
        while let Some((m, c)) = rest.leading_term() {
            let step = divisors.iter().enumerate().find_map(|(i, g)| {
                let (lm, lc) = &g.raw_terms()[0];
                let quotient = m.checked_div(lm)?;
                c.is_multiple_of(lc).then(|| (i, quotient, &c / lc))
            });
            if let Some((i, quotient, factor)) = step {
                // The leading monomials cancel; in a degree order no exponent of the product can pass
                // those of `rest` by more than its total degree, in lex it may: then keep the term.
                let subtract = divisors[i].mul_term(&quotient, &-&factor);
                if let Ok(subtract) = subtract {
                    rest += &subtract;
                    quotients[i].push((quotient, factor));
                    continue;
                }
            }
            let head = Polynomial::collect(ring, vec![(m.clone(), c.clone())]);
            rest -= &head;
            remainder.push((m, c));
            if exact {
                break;
            }
        }
        let quotients = quotients
            .into_iter()
            .map(|q| Polynomial::collect(ring, q))
            .collect();
        (quotients, Polynomial::collect(ring, remainder))
    }

    /// Pseudo-division in one variable (Knuth, TAOCP 2, 4.6.1, algorithm R): quotient `q` and remainder
    /// `r` with `lc^(deg self - deg divisor + 1) self = q divisor + r` and `deg r < deg divisor`, where `lc`
    /// is the divisor's leading coefficient in that variable. If `deg self < deg divisor`, then `(0, self)`.
    pub fn pseudo_div_rem(
        &self,
        divisor: &Polynomial,
        variable: usize,
    ) -> Result<(Polynomial, Polynomial), Error> {
        let ring = self.ring();
        if ring != divisor.ring() {
            return Err(Error::RingMismatch);
        }
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
