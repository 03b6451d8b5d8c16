//! The divisors that must not vanish, in irreducible factors, and why they do not.
//!
//! A polynomial in positive letters whose coefficients all have one sign has no zero. Where the
//! printed letters do not show that, the definitions are inserted and it is asked again.

use super::Checker;
use crate::verdict::{Because, NonVanishing};
use num_traits::Signed;
use ratpoly::{Budget, Polynomial, RationalFunction};

impl Checker<'_> {
    /// The conditions met since they were last cleared.
    pub(crate) fn conditions(&self) -> Vec<NonVanishing> {
        let mut found: Vec<NonVanishing> = Vec::new();
        for condition in &self.exact.conditions {
            for factor in irreducible_factors(condition.divisor.numerator()) {
                if found.iter().any(|f| f.factor == factor) {
                    continue;
                }
                let because = self.nonvanishing(&factor);
                found.push(NonVanishing {
                    factor,
                    origin: condition.origin.clone(),
                    because,
                });
            }
        }
        found
    }

    fn nonvanishing(&self, factor: &Polynomial) -> Option<Because> {
        if self.has_one_sign(factor) {
            return Some(Because::Positive);
        }
        let abbreviations: Vec<usize> = factor
            .variables_occurring()
            .into_iter()
            .filter(|l| self.inserted.contains_key(l))
            .collect();
        let insertion = self.insertion(&abbreviations);
        let inserted = RationalFunction::from(factor.clone())
            .substitute(&insertion.letters)
            .ok()?;
        let positive =
            self.has_one_sign(inserted.numerator()) && self.has_one_sign(inserted.denominator());
        positive.then_some(Because::PositiveBy(insertion.labels))
    }

    /// Whether all letters are positive and all coefficients of one sign.
    fn has_one_sign(&self, polynomial: &Polynomial) -> bool {
        let positive = |letter: &usize| {
            self.model.is_positive(*letter)
                || self.inserted.get(letter).is_some_and(|value| {
                    [value.numerator(), value.denominator()].iter().all(|p| {
                        p.variables_occurring()
                            .iter()
                            .all(|l| self.model.is_positive(*l))
                            && p.terms().all(|(_, c)| c.is_positive())
                    })
                })
        };
        let mut signs = polynomial.terms().map(|(_, c)| c.is_positive());
        let first = signs.next();
        first.is_some()
            && signs.all(|s| Some(s) == first)
            && polynomial.variables_occurring().iter().all(positive)
    }
}

/// The irreducible factors that are not constants; the polynomial itself where factoring is out of
/// reach.
fn irreducible_factors(polynomial: &Polynomial) -> Vec<Polynomial> {
    if polynomial.is_constant() {
        return Vec::new();
    }
    match polynomial.factor_within(&Budget::default()) {
        Ok(product) => product.factors.into_iter().map(|(f, _)| f).collect(),
        Err(_) => vec![polynomial.clone()],
    }
}
