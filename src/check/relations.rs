//! Hidden hypotheses: the relations between printed letters that make an equation true.
//!
//! The letters of an equation satisfy the ideal of relations among their definitions, found by
//! elimination (Cox, Little & O'Shea, *Ideals, Varieties, and Algorithms*, ch. 3). The residual
//! lies in that ideal; dividing it by a Groebner basis gives the cofactors that show how.

use super::Checker;
use super::identity::letters_of;
use crate::expr::Relation;
use crate::verdict::{Given, GivenEntry, ResidualEntry};
use num_traits::Zero;
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
        let mut stated = Vec::new();
        for hypothesis in &model.equations[equation].given {
            if hypothesis.relation != Relation::Equal {
                continue;
            }
            match self.exact.expression(&hypothesis.difference()) {
                Ok(crate::evaluate::Value::Scalar(s)) if !s.is_zero() && self.can_vanish(&s) => {
                    stated.push(s.numerator().clone());
                }
                _ => {}
            }
        }
        if stated.is_empty() {
            return Ok(None);
        }
        let budget = Budget::default();
        let basis = ratpoly::Ideal::new(model.ring, stated)
            .and_then(|ideal| ideal.groebner_basis(&budget))
            .map_err(|_| "the stated hypotheses are out of reach".to_string())?;
        let entries = open.iter().map(|e| (*e).clone()).collect();
        Ok(self
            .divide(entries, basis.elements().to_vec(), &budget)
            .ok())
    }

    /// Whether the document's own numbers, or where it gives none the signs of its letters, leave room
    /// for a hypothesis: from one that they contradict anything would follow.
    fn can_vanish(&self, difference: &RationalFunction) -> bool {
        let all = self.insertion(&self.inserted.keys().copied().collect::<Vec<_>>());
        let Ok(inserted) = difference.substitute(&all.letters) else {
            return false;
        };
        let letters = letters_of([&inserted]);
        if letters.iter().all(|l| self.has_reference(*l)) {
            let value = inserted.evaluate(&self.reference_point());
            return value.is_ok_and(|v| v.is_zero());
        }
        !self.is_negative(&inserted) && !self.is_negative(&-inserted)
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
        })
    }
}
