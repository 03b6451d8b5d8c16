//! Division: exact, with remainder by one or many, pseudo-division.

use crate::budget::Budget;
use crate::divide_heap::{Outcome, divide};
use crate::error::{Error, Resource};
use crate::monomial::Monomial;
use crate::polynomial::{Polynomial, layout_of};
use crate::ring::Ring;
use crate::scalar::Scalar;
use crate::terms::same_layout;
use num_bigint::BigInt;
use std::cmp::Ordering;
use std::collections::BTreeMap;

static UNLIMITED: Budget = Budget::unlimited();

impl Polynomial {
    /// The quotient if `divisor` divides; `None` if it does not or is zero.
    ///
    /// # Panics
    /// If the operands belong to different rings.
    pub fn div_exact(&self, divisor: &Polynomial) -> Option<Polynomial> {
        self.div_exact_within(divisor, &UNLIMITED)
            .unwrap_or_else(|e| panic!("{e}"))
    }

    /// The quotient if `divisor` divides, within a budget: few terms may have a quotient of millions, as
    /// `x^1000000 - 1` by `x - 1`.
    pub fn div_exact_within(
        &self,
        divisor: &Polynomial,
        budget: &Budget,
    ) -> Result<Option<Polynomial>, Error> {
        self.check_ring(divisor)?;
        // A divisor with greater exponents than the dividend does not divide; both are canonical.
        if divisor.is_zero() || (!self.is_zero() && divisor.terms.kind() > self.terms.kind()) {
            return Ok(None);
        }
        let length = divisor.len() as u64;
        let left = budget.steps().saturating_sub(budget.spent()) / length;
        let most = usize::try_from(left).unwrap_or(usize::MAX);
        let most = most.min(budget.terms());
        let quotient = same_layout!(self.ring, &self.terms, &divisor.terms, a, b => {
            match divide(a, b, layout_of(a, self.ring), most) {
                Outcome::Quotient(list) => self.with(list),
                Outcome::NotDivisible => return Ok(None),
                Outcome::TooLong => {
                    budget.check_terms(most.saturating_add(1))?;
                    return Err(Error::BudgetExceeded(Resource::Steps));
                }
            }
        });
        budget.spend(length.saturating_mul(quotient.len() as u64))?;
        Ok(Some(quotient))
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
        self.div_rem_within(divisors, &Budget::unlimited())
    }

    /// [`div_rem`](Self::div_rem) within a budget.
    pub fn div_rem_within(
        &self,
        divisors: &[&Polynomial],
        budget: &Budget,
    ) -> Result<(Vec<Polynomial>, Polynomial), Error> {
        let ring = self.ring;
        let mut leading = Vec::with_capacity(divisors.len());
        for divisor in divisors {
            self.check_ring(divisor)?;
            let (monomial, c) = divisor.leading_scalar().ok_or(Error::DivisionByZero)?;
            let tail: Vec<(Monomial, Scalar)> = divisor.scalar_terms().skip(1).collect();
            leading.push((monomial, c, tail));
        }
        // The dividend by descending monomials: the last entry is the leading term.
        let mut rest: BTreeMap<Ranked, Scalar> = self
            .scalar_terms()
            .map(|(monomial, c)| (Ranked { ring, monomial }, c))
            .collect();
        let mut quotients = vec![Vec::new(); divisors.len()];
        let mut remainder = Vec::new();
        while let Some((Ranked { monomial, .. }, c)) = rest.pop_last() {
            if c.is_zero() {
                continue;
            }
            let step = leading.iter().enumerate().find_map(|(i, (lm, lc, tail))| {
                Some((i, monomial.checked_div(lm)?, lc.divide(c.value())?, tail))
            });
            let Some((i, quotient, factor, tail)) = step else {
                remainder.push((monomial, c));
                continue;
            };
            budget.spend(1 + tail.len() as u64)?;
            let negated = factor.clone().negated();
            for (m, c) in tail {
                let monomial = quotient.checked_mul(m).ok_or(Error::ExponentOverflow)?;
                let entry = rest.entry(Ranked { ring, monomial });
                let entry = entry.or_insert(Scalar::Small(0));
                *entry = entry.plus(&negated.times(c.value()));
            }
            budget.check_terms(rest.len())?;
            quotients[i].push((quotient, factor));
        }
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
        self.pseudo_div_rem_within(divisor, variable, &Budget::unlimited())
    }

    /// [`pseudo_div_rem`](Self::pseudo_div_rem) within a budget.
    pub fn pseudo_div_rem_within(
        &self,
        divisor: &Polynomial,
        variable: usize,
        budget: &Budget,
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
        let lc = divisor.leading_coefficient_in(variable);
        while let Some(n) = rest.degree(variable).filter(|n| *n >= d) {
            let head = rest.leading_coefficient_in(variable);
            let mut shift = vec![0; ring.len()];
            shift[variable] = n - d;
            let term = head.mul_term(&shift, &BigInt::from(1))?;
            quotient = quotient.mul_within(&lc, budget)?.try_add(&term)?;
            rest = rest
                .mul_within(&lc, budget)?
                .try_sub(&term.mul_within(divisor, budget)?)?;
            missing -= 1;
        }
        let power = lc.pow_within(missing, budget)?;
        Ok((
            quotient.mul_within(&power, budget)?,
            rest.mul_within(&power, budget)?,
        ))
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

/// A monomial in the order of its ring.
#[derive(PartialEq, Eq)]
struct Ranked {
    ring: Ring,
    monomial: Monomial,
}

impl Ord for Ranked {
    fn cmp(&self, other: &Self) -> Ordering {
        self.ring.compare(&self.monomial, &other.monomial)
    }
}

impl PartialOrd for Ranked {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}
