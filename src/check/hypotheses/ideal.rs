//! Claims in the ideal of relations: what vanishes wherever the relations do and some factors do not.
//!
//! A polynomial f vanishes there if h^k f is a combination of the relations for a product h of factors
//! that do not vanish; the combination is found by a Groebner basis with cofactors, in a ring of the
//! letters that occur (Cox, Little & O'Shea, *Ideals, Varieties, and Algorithms*, ch. 2 and 4). It is
//! checked by multiplying out, whatever found it.

use super::Supposed;
use crate::check::Checker;
use crate::functions::quadratic::reduce_polynomial;
use crate::verdict::{Given, GivenEntry, ResidualEntry};
use num_bigint::BigInt;
use num_traits::One;
use ratpoly::{Budget, GroebnerBasis, Ideal, Order, Polynomial, RationalFunction, Ring};
use std::collections::BTreeSet;

/// The highest power of the factors that do not vanish.
const HIGHEST: usize = 6;
/// Ideals in more letters, or of more relations, are not looked at.
const MOST_LETTERS: usize = 16;
const MOST_RELATIONS: usize = 12;

fn budget() -> Budget {
    Budget::new(4_000, 4_000, 3_000_000)
}

/// `multiplier f = sum of cofactors times relations`.
struct Combination {
    multiplier: Polynomial,
    cofactors: Vec<Polynomial>,
}

impl Checker<'_> {
    /// How the entries follow from the relations among the hypotheses in force; none where they do not,
    /// or it is out of reach.
    pub(in crate::check) fn by_relations(&self, open: &[ResidualEntry]) -> Option<Given> {
        self.combined(open, &self.supposed)
    }

    fn combined(&self, open: &[ResidualEntry], supposed: &Supposed) -> Option<Given> {
        self.combination_of(open, &supposed.relations, &supposed.divisors)
    }

    /// How the entries follow from relations where these divisors do not vanish.
    pub(in crate::check) fn combination_of(
        &self,
        open: &[ResidualEntry],
        relations: &[Polynomial],
        divisors: &[Polynomial],
    ) -> Option<Given> {
        if relations.is_empty() {
            return None;
        }
        let mut entries = Vec::new();
        for entry in open {
            let difference = entry.difference();
            let mut nonzero: Vec<Polynomial> = divisors.to_vec();
            nonzero.push(difference.denominator().clone());
            let found = self.combination(difference.numerator(), relations, &nonzero)?;
            let scale = &found.multiplier * difference.denominator();
            let cofactors = found
                .cofactors
                .into_iter()
                .map(|c| RationalFunction::new(c, scale.clone()).ok())
                .collect::<Option<Vec<_>>>()?;
            entries.push(GivenEntry {
                entry: entry.clone(),
                cofactors,
            });
        }
        let used: Vec<usize> = (0..relations.len())
            .filter(|k| entries.iter().any(|e| !e.cofactors[*k].is_zero()))
            .collect();
        for entry in &mut entries {
            entry.cofactors = used.iter().map(|k| entry.cofactors[*k].clone()).collect();
        }
        Some(Given {
            relations: used.iter().map(|k| relations[*k].clone()).collect(),
            implied_by: Vec::new(),
            cofactors: entries,
            counterexample: None,
            stated: Vec::new(),
            instance: None,
        })
    }

    /// Whether the relations have no common zero where nothing vanishes that does not.
    pub(super) fn has_no_zero(&self, supposed: &Supposed) -> bool {
        if supposed.relations.is_empty() {
            return false;
        }
        let one = Polynomial::one(self.model.ring);
        self.combination(&one, &supposed.relations, &supposed.divisors)
            .is_some()
    }

    /// Whether a divisor vanishes wherever the hypotheses hold.
    pub(in crate::check) fn vanishes_under_relations(&self, divisor: &Polynomial) -> bool {
        let supposed = &self.supposed;
        !supposed.relations.is_empty()
            && self
                .combination(divisor, &supposed.relations, &supposed.divisors)
                .is_some()
    }

    fn combination(
        &self,
        f: &Polynomial,
        relations: &[Polynomial],
        nonzero: &[Polynomial],
    ) -> Option<Combination> {
        let small = self.small_ring(f, relations)?;
        let to = |p: &Polynomial| p.to_ring(small).ok();
        let back = |p: &Polynomial| p.to_ring(self.model.ring).ok();
        let (quadratics, letters) = self.quadratics_among(f, relations);
        let mut generators: Vec<Polynomial> = relations.iter().map(to).collect::<Option<_>>()?;
        generators.extend(quadratics.iter().map(to).collect::<Option<Vec<_>>>()?);
        let budget = budget();
        let basis = GroebnerBasis::with_cofactors(small, &generators, &budget).ok()?;
        // What does not vanish: what is known so, and what is divided by.
        let mut factor = Polynomial::one(small);
        for p in self.nonvanishing_among(&letters, nonzero) {
            factor = &factor * &to(&p)?;
        }
        let f_small = to(f)?;
        let highest = if factor.is_one() { 0 } else { HIGHEST };
        let mut power = Polynomial::one(small);
        for k in 0..=highest {
            let form = basis.membership(&(&f_small * &power), &budget).ok()?;
            if form.remainder.is_zero() {
                let multiplier = back(&power)?.mul_integer(&form.multiplier);
                let cofactors: Vec<Polynomial> = form.cofactors[..relations.len()]
                    .iter()
                    .map(back)
                    .collect::<Option<_>>()?;
                return self.multiplied_out(f, relations, multiplier, cofactors);
            }
            // Whether any power serves is known from the saturated ideal.
            if k == 1 {
                let ideal = Ideal::new(small, generators.clone()).ok()?;
                let saturated = ideal.saturate(&factor, &budget).ok()?;
                if !saturated.contains(&f_small, &budget).ok()? {
                    return None;
                }
            }
            power = power.mul_within(&factor, &budget).ok()?;
        }
        None
    }

    /// The combination, if it is one: multiplied out, with the letters of functions in normal form.
    fn multiplied_out(
        &self,
        f: &Polynomial,
        relations: &[Polynomial],
        multiplier: Polynomial,
        cofactors: Vec<Polynomial>,
    ) -> Option<Combination> {
        let mut rest = f * &multiplier;
        for (relation, cofactor) in relations.iter().zip(&cofactors) {
            rest = &rest - &(cofactor * relation);
        }
        if let Some(table) = self.functions() {
            rest = reduce_polynomial(&rest, &table.quadratics());
        }
        rest.is_zero().then_some(Combination {
            multiplier,
            cofactors,
        })
    }

    /// The squares of the letters of functions that occur, as relations, and all letters.
    fn quadratics_among(
        &self,
        f: &Polynomial,
        relations: &[Polynomial],
    ) -> (Vec<Polynomial>, BTreeSet<usize>) {
        let mut letters: BTreeSet<usize> = f.variables_occurring().into_iter().collect();
        letters.extend(relations.iter().flat_map(Polynomial::variables_occurring));
        let mut squares = Vec::new();
        if let Some(table) = self.functions() {
            // From the last to the first: a square mentions earlier letters only.
            for quadratic in table.quadratics().iter().rev() {
                if letters.contains(&quadratic.letter) {
                    let letter = Polynomial::variable(self.model.ring, quadratic.letter);
                    letters.extend(quadratic.square.variables_occurring());
                    squares.push(&(&letter * &letter) - &quadratic.square);
                }
            }
        }
        (squares, letters)
    }

    fn small_ring(&self, f: &Polynomial, relations: &[Polynomial]) -> Option<Ring> {
        let (_, letters) = self.quadratics_among(f, relations);
        if letters.len() > MOST_LETTERS || relations.len() > MOST_RELATIONS {
            return None;
        }
        let names = self.model.ring.variables();
        Ring::new(letters.iter().map(|l| names[*l].as_str()), Order::Grevlex).ok()
    }

    /// Irreducible polynomials in these letters that are known not to vanish.
    fn nonvanishing_among(
        &self,
        letters: &BTreeSet<usize>,
        divisors: &[Polynomial],
    ) -> Vec<Polynomial> {
        let mut found: Vec<Polynomial> = Vec::new();
        let mut add = |p: Polynomial| {
            let p = p.primitive_part().unit_normal();
            let within = p.variables_occurring().iter().all(|l| letters.contains(l));
            if within && !p.is_constant() && !found.contains(&p) {
                found.push(p);
            }
        };
        for letter in letters {
            let variable = Polynomial::variable(self.model.ring, *letter);
            if self.signs(&variable).excludes_zero() {
                add(variable);
            }
        }
        for divisor in divisors.iter().filter(|d| !d.is_zero()) {
            match divisor.factor_within(&Budget::default()) {
                Ok(product) => product.factors.into_iter().for_each(|(f, _)| add(f)),
                Err(_) => add(divisor.clone()),
            }
        }
        for (p, signs) in &self.supposed.admitted.signs {
            if signs.excludes_zero() {
                add(p.clone());
            }
        }
        debug_assert!(found.iter().all(|p| p.content() == BigInt::one()));
        found
    }
}
