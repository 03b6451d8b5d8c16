//! Hidden hypotheses: the relations between printed letters that make an equation true.
//!
//! The letters of an equation satisfy the ideal of relations among their definitions, found by
//! elimination (Cox, Little & O'Shea, *Ideals, Varieties, and Algorithms*, ch. 3). The residual
//! lies in that ideal; dividing it by a Groebner basis gives the cofactors that show how.

use super::Checker;
use super::identity::{is_the_claim, letters_of};
use crate::expr::Relation;
use crate::verdict::{Given, GivenEntry, ResidualEntry};
use ratpoly::{Budget, Polynomial, RationalFunction};
use std::collections::BTreeSet;

impl Checker<'_> {
    /// The relations that the definitions imply among the letters of these entries, as far as the
    /// entries need them.
    ///
    /// # Errors
    /// When a limit is hit.
    pub(crate) fn hidden_relations(&self, open: Vec<ResidualEntry>) -> Result<Given, String> {
        let ring = self.model.ring;
        let letters = letters_of(open.iter().flat_map(|e| [&e.left, &e.right]));
        let functions: Vec<(&str, RationalFunction)> = letters
            .iter()
            .map(|l| {
                let value = self
                    .inserted
                    .get(l)
                    .cloned()
                    .unwrap_or_else(|| RationalFunction::variable(ring, *l));
                (ring.variables()[*l].as_str(), value)
            })
            .collect();
        let limit = |_| "the relations among the definitions are out of reach".to_string();
        let budget = Budget::default();
        let basis: Vec<Polynomial> = ratpoly::relations_within(&functions, &budget)
            .map_err(limit)?
            .iter()
            .map(|r| r.to_ring(ring))
            .collect::<Result<_, _>>()
            .map_err(limit)?;
        let mut given = self.divide(open, basis, &budget)?;
        let labels = given
            .relations
            .iter()
            .flat_map(Polynomial::variables_occurring)
            .filter(|l| self.inserted.contains_key(l))
            .collect::<BTreeSet<_>>();
        given.implied_by = self
            .insertion(&labels.into_iter().collect::<Vec<_>>())
            .labels;
        Ok(given)
    }

    /// The relations that the author states as a hypothesis, if the entries follow from them.
    ///
    /// # Errors
    /// When a limit is hit.
    pub(crate) fn stated_relations(
        &mut self,
        open: &[&ResidualEntry],
        equation: usize,
    ) -> Result<Option<Given>, String> {
        let model = self.model;
        let mut stated: Vec<Polynomial> = Vec::new();
        let mut divisors: Vec<Polynomial> = Vec::new();
        for hypothesis in &model.equations[equation].given {
            if hypothesis.relation != Relation::Equal {
                return Ok(None);
            }
            let before = self.exact.conditions.len();
            let value = self
                .exact
                .expression_without_cases(&hypothesis.difference());
            let met = self.exact.conditions.split_off(before);
            divisors.extend(met.iter().map(|c| c.divisor.numerator().clone()));
            match value {
                Ok(crate::evaluate::Value::Scalar(s)) if !s.is_zero() => {
                    stated.push(s.numerator().clone());
                }
                _ => return Ok(None),
            }
        }
        if stated.is_empty() {
            return Ok(None);
        }
        let hypotheses: Vec<_> = model.equations[equation].given.iter().collect();
        // From what contradicts the document anything would follow.
        if self.breaks_reference(&hypotheses) || self.suppose(&hypotheses).is_err() {
            return Ok(None);
        }
        let entries: Vec<ResidualEntry> = open.iter().map(|e| (*e).clone()).collect();
        let budget = Budget::default();
        let basis = ratpoly::Ideal::new(model.ring, stated.clone())
            .and_then(|ideal| ideal.groebner_basis(&budget))
            .map_err(|_| "the stated hypotheses are out of reach".to_string())?;
        // Of several the basis has other elements than what is stated.
        let by_basis = |checker: &Self| match stated.len() {
            1 => checker
                .divide(entries.clone(), basis.elements().to_vec(), &budget)
                .ok(),
            _ => None,
        };
        let found = by_basis(self).or_else(|| {
            let mut given = self.combination_of(&entries, &stated, &divisors)?;
            let first = given.cofactors.first();
            given.counterexample = first.and_then(|c| self.free_witness(&c.entry));
            Some(given)
        });
        Ok(found.filter(|given| !is_the_claim(given)))
    }

    /// Writes each residual as a combination of the basis and keeps the elements that are used.
    fn divide(
        &self,
        open: Vec<ResidualEntry>,
        basis: Vec<Polynomial>,
        budget: &Budget,
    ) -> Result<Given, String> {
        let limit = |_| "the residual's cofactors are out of reach".to_string();
        let divisors: Vec<&Polynomial> = basis.iter().collect();
        let mut cofactors = Vec::new();
        for entry in open {
            let difference = entry.difference();
            let form =
                ratpoly::normal_form(difference.numerator(), &divisors, budget).map_err(limit)?;
            if !form.remainder.is_zero() {
                return Err("the residual is not in the ideal of the relations".into());
            }
            let scale = difference.denominator().mul_integer(&form.multiplier);
            let quotients = form
                .cofactors
                .into_iter()
                .map(|c| RationalFunction::new(c, scale.clone()))
                .collect::<Result<Vec<_>, _>>()
                .map_err(limit)?;
            cofactors.push(GivenEntry {
                entry,
                cofactors: quotients,
            });
        }
        let used: Vec<usize> = (0..basis.len())
            .filter(|k| cofactors.iter().any(|c| !c.cofactors[*k].is_zero()))
            .collect();
        for entry in &mut cofactors {
            entry.cofactors = used.iter().map(|k| entry.cofactors[*k].clone()).collect();
        }
        let counterexample = cofactors.first().and_then(|c| self.free_witness(&c.entry));
        Ok(Given {
            relations: used.iter().map(|k| basis[*k].clone()).collect(),
            implied_by: Vec::new(),
            cofactors,
            counterexample,
            stated: Vec::new(),
            instance: None,
        })
    }
}
