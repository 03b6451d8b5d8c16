//! Unknown dimensions solved from equations between dimensions.
//!
//! An equation between products of powers is linear in the exponents, and the exponents are
//! rational, so that Gaussian elimination decides it (A. Kennedy, Programming Languages and
//! Dimensions, 1996; over the rationals his unification needs no Euclidean algorithm).
//! Invariant: no solved unknown occurs in the solution of any other.

use super::dimension::{Dimension, Unknown};
use num_rational::BigRational;
use num_traits::One;
use std::collections::BTreeMap;

/// The unknowns so far, and those that are solved in terms of the others.
#[derive(Clone, Debug, Default)]
pub(super) struct Unification {
    names: Vec<String>,
    solved: BTreeMap<Unknown, Dimension>,
}

impl Unification {
    /// A new unknown dimension, with a name for messages.
    pub fn unknown(&mut self, name: String) -> Dimension {
        self.names.push(name);
        Dimension::unknown(Unknown(self.names.len() - 1))
    }

    /// The dimension in terms of unsolved unknowns.
    pub fn resolve(&self, dimension: &Dimension) -> Dimension {
        let mut resolved = dimension.clone();
        for (unknown, exponent) in dimension.unknowns() {
            if let Some(solution) = self.solved.get(&unknown) {
                resolved = resolved
                    .times_power(&Dimension::unknown(unknown), &-exponent)
                    .times_power(solution, exponent);
            }
        }
        resolved
    }

    /// Makes two dimensions equal, or says that they cannot be.
    pub fn unify(&mut self, left: &Dimension, right: &Dimension) -> bool {
        let quotient = self.resolve(left).over(&self.resolve(right));
        let Some((unknown, exponent)) = quotient.first_unknown() else {
            return quotient.is_one();
        };
        let exponent = exponent.clone();
        let solution = quotient
            .times_power(&Dimension::unknown(unknown), &-exponent.clone())
            .power(&-(BigRational::one() / exponent));
        for other in self.solved.values_mut() {
            let occurs = other.unknowns().find(|(u, _)| *u == unknown);
            if let Some(power) = occurs.map(|(_, power)| power.clone()) {
                *other = other
                    .times_power(&Dimension::unknown(unknown), &-power.clone())
                    .times_power(&solution, &power);
            }
        }
        self.solved.insert(unknown, solution);
        true
    }

    /// Forgets the solutions since `earlier`, but not the unknowns.
    pub fn forget_since(&mut self, earlier: &Unification) {
        self.solved = earlier.solved.clone();
    }

    /// The dimension for a reader.
    pub fn show(&self, dimension: &Dimension) -> String {
        self.resolve(dimension)
            .show(&|unknown| self.names[unknown.0].clone())
    }
}

#[cfg(test)]
mod tests {
    use super::super::dimension::Base;
    use super::*;
    use proptest::prelude::*;

    fn ratio(numerator: i64, denominator: i64) -> BigRational {
        BigRational::new(numerator.into(), denominator.into())
    }

    #[test]
    fn an_unknown_takes_any_rational_power() {
        let mut unification = Unification::default();
        let sigma = unification.unknown("sigma".into());
        let acceleration =
            Dimension::base(Base::Metre).times_power(&Dimension::base(Base::Second), &ratio(-3, 1));
        assert!(unification.unify(&sigma.power(&ratio(2, 1)), &acceleration));
        assert_eq!(unification.show(&sigma), "m^(1/2)/s^(3/2)");
        assert!(!unification.unify(&sigma, &Dimension::one()));
        assert_eq!(unification.show(&sigma), "m^(1/2)/s^(3/2)");
    }

    proptest! {
        /// What was made equal stays equal, whatever is made equal later.
        #[test]
        fn equations_stay_solved(rows in prop::collection::vec(prop::collection::vec(-3i64..4, 6), 1..7)) {
            let mut unification = Unification::default();
            let unknowns: Vec<_> = (0..4).map(|i| unification.unknown(i.to_string())).collect();
            let generators: Vec<_> = unknowns.iter().cloned()
                .chain([Dimension::base(Base::Metre), Dimension::base(Base::Second)]).collect();
            let mut accepted = Vec::new();
            for row in rows {
                let dimension = row.iter().zip(&generators)
                    .fold(Dimension::one(), |d, (n, g)| d.times_power(g, &ratio(*n, 1)));
                if unification.unify(&dimension, &Dimension::one()) {
                    accepted.push(dimension);
                } else {
                    prop_assert!(unification.resolve(&dimension).is_known());
                    prop_assert!(!unification.resolve(&dimension).is_one());
                }
                for dimension in &accepted {
                    prop_assert!(unification.resolve(dimension).is_one());
                }
            }
        }
    }
}
