//! Whether an integral has no value whatever admitted values the letters have.
//!
//! A coefficient of what diverges may vanish, and two terms that diverge may cancel where their exponents are
//! equal: only coefficients with a sign beside exponents that are certainly apart leave no doubt. What has a
//! principal value (Cauchy 1822) is not said to have none: which value is meant, the print does not say.

use super::integral::{End, PowerTerm, is_even};
use super::{FunctionTable, Impossible, Possible};
use crate::expr::Sign;
use ratpoly::{Budget, Polynomial, RationalFunction};
use std::cmp::Ordering;

/// What is said where not all values of the letters make an integral diverge.
pub(super) fn uncertain() -> Impossible {
    Impossible::unsupported("an integral whose convergence depends on its letters")
}

impl FunctionTable {
    /// Whether an element is known to vanish nowhere.
    pub(super) fn never_vanishes(&self, f: &RationalFunction) -> bool {
        matches!(self.sign(f), Some(Ordering::Less | Ordering::Greater))
    }

    /// The sign of the infinity that a divergent integral grows to: the integrand has a sign.
    pub(super) fn grows_towards(
        &self,
        integrand: &RationalFunction,
        from: &End<RationalFunction>,
        to: &End<RationalFunction>,
    ) -> Option<Sign> {
        let upwards = match (from, to) {
            (End::At(from), End::At(to)) => self.sign(&(to - from))?,
            (End::Below, End::At(_) | End::Above) | (End::At(_), End::Above) => Ordering::Greater,
            (End::Above, _) | (_, End::Below) => return None,
        };
        match (self.sign(integrand)?, upwards) {
            (Ordering::Equal, _) | (_, Ordering::Equal) => None,
            (sign, upwards) if sign == upwards => Some(Sign::Plus),
            (Ordering::Less | Ordering::Greater, Ordering::Less | Ordering::Greater) => {
                Some(Sign::Minus)
            }
        }
    }

    /// Whether a divergent integral does not converge as a principal value at infinity either: over the whole
    /// axis its even part diverges.
    pub(super) fn has_no_principal_value(
        &self,
        integrand: &RationalFunction,
        variable: usize,
        from: &End<RationalFunction>,
        to: &End<RationalFunction>,
    ) -> Possible<bool> {
        if (from, to) != (&End::Below, &End::Above) {
            return Ok(true);
        }
        let mirrored = self.substitute(integrand, &[(variable, -&self.variable(variable))])?;
        let even = self.reduce(integrand + &mirrored);
        let zero = End::At(self.integer(0));
        let half = match even.is_zero() {
            true => return Ok(false),
            false => self.integral_by_shape(&even, variable, &zero, &End::Above),
        };
        Ok(matches!(half, Err(Impossible::Divergent { .. })))
    }

    /// Whether a sum of powers certainly diverges towards an end of its interval.
    pub(super) fn powers_diverge(
        &self,
        terms: &[PowerTerm],
        from: &End<RationalFunction>,
        to: &End<RationalFunction>,
    ) -> bool {
        if let (End::At(zero), End::Above, [term]) = (from, to, terms)
            && zero.is_zero()
        {
            return self.never_vanishes(&term.coefficient);
        }
        let one = self.integer(1);
        let diverges = |term: &PowerTerm, end: &End<RationalFunction>, other: &End<_>| {
            let sign = self.sign(&(&term.exponent + &one));
            match end {
                End::Below => true,
                End::Above => matches!(sign, Some(Ordering::Equal | Ordering::Greater)),
                End::At(x) => {
                    // Nothing diverges over an interval that may be a point.
                    let apart = match other {
                        End::At(other) => self.never_vanishes(other),
                        End::Below | End::Above => true,
                    };
                    x.is_zero() && apart && matches!(sign, Some(Ordering::Equal | Ordering::Less))
                }
            }
        };
        let signs: Vec<_> = terms.iter().map(|t| self.sign(&t.coefficient)).collect();
        let alike = signs.iter().all(|s| s.is_some() && *s == signs[0]);
        [(from, to), (to, from)].into_iter().any(|(end, other)| {
            terms.iter().enumerate().any(|(k, term)| {
                let apart = || {
                    terms.iter().enumerate().all(|(j, other)| {
                        j == k || self.never_vanishes(&(&other.exponent - &term.exponent))
                    })
                };
                diverges(term, end, other)
                    && self.never_vanishes(&term.coefficient)
                    && (alike && *end != End::Below || apart())
            })
        })
    }

    /// Whether a rational function certainly has no integral over the half axis, nor a principal value of one.
    pub(super) fn quotient_diverges(
        &self,
        f: &RationalFunction,
        variable: usize,
    ) -> Possible<bool> {
        let (above, below) = (f.numerator(), f.denominator());
        let degree = |p: &Polynomial| i64::from(p.degree(variable).unwrap_or(0));
        let coefficients = above.coefficients_in(variable);
        let never = |p: Option<&Polynomial>| {
            p.is_some_and(|p| self.never_vanishes(&RationalFunction::from(p.clone())))
        };
        if degree(below) - degree(above) < 2 && never(coefficients.last()) {
            return Ok(true);
        }
        let lowest = below.coefficients_in(variable);
        if lowest.first().is_some_and(Polynomial::is_zero) && never(coefficients.first()) {
            return Ok(true);
        }
        if !is_even(f, variable) {
            return Ok(false);
        }
        for (factor, multiplicity) in below.factor_within(&Budget::default())?.factors {
            let Some(square) = self.square_of_pole(&factor, variable) else {
                continue;
            };
            // A simple pole may have a principal value.
            let there = self.at_square(above, variable, &square)?;
            if multiplicity % 2 == 0 && there.is_some_and(|there| self.never_vanishes(&there)) {
                return Ok(true);
            }
        }
        Ok(false)
    }

    /// The positive square of the variable at which a factor of an even denominator vanishes.
    pub(super) fn square_of_pole(
        &self,
        factor: &Polynomial,
        variable: usize,
    ) -> Option<RationalFunction> {
        let over = |above: &Polynomial, below: &Polynomial| {
            let above = RationalFunction::from(above.clone());
            above.checked_div(&below.clone().into()).ok()
        };
        let square = match factor.coefficients_in(variable).as_slice() {
            [constant, lead] => {
                let place = over(constant, lead)?;
                self.power_of(&place, 2).ok()?
            }
            [constant, linear, lead] if linear.is_zero() => -&over(constant, lead)?,
            _ => return None,
        };
        self.is_positive(&square).then_some(square)
    }

    /// An even polynomial where the square of the variable has a value.
    pub(super) fn at_square(
        &self,
        p: &Polynomial,
        variable: usize,
        square: &RationalFunction,
    ) -> Possible<Option<RationalFunction>> {
        let mut sum = self.integer(0);
        let mut power = self.integer(1);
        for pair in p.coefficients_in(variable).chunks(2) {
            if pair.get(1).is_some_and(|odd| !odd.is_zero()) {
                return Ok(None);
            }
            sum = &sum + &(&RationalFunction::from(pair[0].clone()) * &power);
            power = self.reduce(&power * square);
        }
        Ok(Some(self.reduce(sum)))
    }
}
