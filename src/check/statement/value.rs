//! Whether a quantity has a value at a place. What has none there is neither true nor false of it.
//!
//! A divisor that was cancelled is seen before ([`super::Checker::quantity`]); here it is asked of what is
//! compared, before it cancels in a difference or a quotient.

use super::{Found, Ground};
use crate::verdict::statement::{Scope, Sign};
use ratpoly::{Budget, Polynomial, RationalFunction};

impl Ground {
    /// Whether a function has no value at the reference point, whatever the letters without a reference
    /// value are.
    pub(super) fn has_no_value(&self, f: &RationalFunction) -> bool {
        self.is_zero_but_for(f.denominator(), &[])
    }

    /// Whether a function is zero at the reference point, whatever the letters without a reference value are.
    pub(super) fn vanishes_here(&self, f: &RationalFunction) -> bool {
        self.vanishes_on_lines(f, &[])
    }

    /// Whether a function is zero at the reference point, whatever these letters are besides.
    pub(super) fn vanishes_on_lines(&self, f: &RationalFunction, kept: &[usize]) -> bool {
        self.is_zero_but_for(f.numerator(), kept) && !self.has_no_value(f)
    }

    /// Whether a polynomial is zero where the letters have their reference values, but for these letters.
    fn is_zero_but_for(&self, p: &Polynomial, kept: &[usize]) -> bool {
        let p = RationalFunction::from(p.clone());
        let known = self.letters_in(&p).into_iter().filter_map(|l| {
            let own = self.reference[l].clone().filter(|_| !kept.contains(&l))?;
            Some((l, RationalFunction::constant(self.ring, own)))
        });
        let images: Vec<_> = known.collect();
        p.substitute(&images).is_ok_and(|there| there.is_zero())
    }

    /// Whether a function certainly has a value for all values of its letters.
    pub(super) fn has_values_everywhere(&self, f: &RationalFunction) -> bool {
        let denominator = RationalFunction::from(f.denominator().clone());
        matches!(
            self.sign(&denominator, &Scope::Everywhere).sign,
            Some(Sign::Positive | Sign::Negative)
        )
    }

    /// Why none of these gives a number at the reference point.
    pub(super) fn without_value(&self, of: &[&RationalFunction]) -> Found {
        Found::undecided(match of.iter().any(|f| self.has_no_value(f)) {
            true => "there is no value at the reference values",
            false => "there are no reference values",
        })
    }

    /// Whether what is divided by in one of these vanishes somewhere in a scope, though it is cancelled in
    /// their quotient.
    pub(super) fn cancels_a_pole(
        &self,
        quotient: &RationalFunction,
        of: [&RationalFunction; 2],
        scope: &Scope,
    ) -> bool {
        let [above, below] = of;
        let divisors = [above.denominator(), below.denominator(), below.numerator()];
        divisors.into_iter().any(|divisor| {
            let factors = match divisor.factor_within(&Budget::default()) {
                Ok(product) => product.factors.into_iter().map(|(f, _)| f).collect(),
                Err(_) => vec![divisor.clone()],
            };
            factors.into_iter().any(|factor| {
                quotient.denominator().div_exact(&factor).is_none()
                    && !matches!(
                        self.sign(&factor.into(), scope).sign,
                        Some(Sign::Positive | Sign::Negative)
                    )
            })
        })
    }
}
