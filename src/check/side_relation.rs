//! A relation that would make a false equation true: a factor of its residual.
//!
//! Where one factor of left minus right can vanish among the admitted values and the others cannot,
//! the equation holds if and only if that factor vanishes: what the paper leaves unsaid may be this. It
//! is offered only if no single slip explains the equation, with a point at which it fails and one at
//! which it is true; and not where the factor is, but for a number, the equation itself.

use super::Checker;
use super::hypotheses::Supposed;
use super::identity::{Insertion, insert, is_the_claim, letters_of};
use super::link::unverified;
use crate::expr::Display;
use crate::model::Letter;
use crate::model::links::Link;
use crate::unit::{Dimension, Unit};
use crate::verdict::{Given, GivenEntry, PointValue, Refutation, ResidualEntry, Verdict, Witness};
use num_rational::BigRational;
use num_traits::Zero;
use ratpoly::{Budget, Polynomial, RationalFunction};

/// What an author would write beside an equation has few terms.
const TERMS: usize = 3;
/// Residuals of more terms are not factored.
const LONG: usize = 200;

impl Checker<'_> {
    /// The verdict, or in its place that the equation holds given a relation.
    pub(super) fn or_side_relation(
        &mut self,
        equation: usize,
        link: &Link,
        before: &Display,
        entries: &[ResidualEntry],
        verdict: Verdict,
    ) -> Verdict {
        if !self.model.equations[equation].given.is_empty() {
            return verdict;
        }
        let refutation = match &verdict {
            Verdict::Refuted(refutation) if refutation.searched.is_some() => refutation,
            // Two slips at once are rarer than one relation that is not written.
            Verdict::Misprint {
                refutation,
                correction,
            } if correction.definition.is_none() && different_slips(&correction.edits) => {
                refutation
            }
            _ => return verdict,
        };
        let Some(given) = self.side_relation(equation, entries, refutation) else {
            return verdict;
        };
        if matches!(verdict, Verdict::Misprint { .. }) {
            self.correct(equation, before.clone());
        }
        match self.proved(equation, link, &[], &Insertion::default(), Some(&given)) {
            Some(proof) => Verdict::HoldsGiven(Box::new(given), proof),
            None => unverified(),
        }
    }

    /// The relation under which entries that differ are equal, if it is one factor.
    fn side_relation(
        &self,
        equation: usize,
        entries: &[ResidualEntry],
        refutation: &Refutation,
    ) -> Option<Given> {
        let counterexample = refutation.witness().cloned()?;
        let open: Vec<&ResidualEntry> = entries.iter().filter(|e| e.left != e.right).collect();
        let all = self.insertion(&self.inserted.keys().copied().collect::<Vec<_>>());
        let expanded = insert(&open, &all, self.functions()).ok()?;
        let mut relation: Option<Polynomial> = None;
        let mut cofactors = Vec::new();
        for entry in expanded.into_iter().filter(|e| e.left != e.right) {
            let difference = entry.difference();
            let numerator = difference.numerator();
            if numerator.len() > LONG
                || numerator
                    .variables_occurring()
                    .iter()
                    .any(|l| self.is_function(*l))
            {
                return None;
            }
            let product = numerator.factor_within(&Budget::default()).ok()?;
            let mut vanishing = product
                .factors
                .iter()
                .filter(|(f, _)| !self.signs(f).excludes_zero());
            let (Some((factor, _)), None) = (vanishing.next(), vanishing.next()) else {
                return None;
            };
            let factor = factor.unit_normal();
            if relation.as_ref().is_some_and(|known| *known != factor) {
                return None;
            }
            let quotient = numerator.div_exact(&factor)?;
            let cofactor =
                RationalFunction::new(quotient, difference.denominator().clone()).ok()?;
            cofactors.push(GivenEntry {
                entry,
                cofactors: vec![cofactor],
            });
            relation = Some(factor);
        }
        let relation = relation?;
        let letters = relation.variables_occurring();
        // It would hold at all times, and with it what it says of the rates: a point knows nothing of them.
        if self.moves(equation, &letters) {
            return None;
        }
        let linear = letters.iter().any(|l| relation.degree(*l) == Some(1));
        if relation.len() > TERMS || letters.len() < 2 || !linear || !self.is_homogeneous(&relation)
        {
            return None;
        }
        let instance = self.zero_of(&relation, &cofactors)?;
        let given = Given {
            relations: vec![relation],
            stated: Vec::new(),
            implied_by: Vec::new(),
            cofactors,
            counterexample: Some(counterexample),
            instance: Some(instance),
        };
        (!is_the_claim(&given)).then_some(given)
    }

    /// Whether a process is among some letters of whose motion the document or a hypothesis says something.
    fn moves(&self, equation: usize, letters: &[usize]) -> bool {
        let tied = self.ties_processes(equation);
        letters
            .iter()
            .any(|letter| match self.model.letters[*letter] {
                Letter::Symbol { symbol, .. } => {
                    self.is_process(symbol) && (tied || self.has_own_motion(symbol))
                }
                Letter::Abbreviation { .. } | Letter::Function { .. } => false,
            })
    }

    /// Whether all terms have one unit, as far as the units of their letters are declared.
    fn is_homogeneous(&self, p: &Polynomial) -> bool {
        let dimension = |exponents: &[u32]| {
            let mut product = Dimension::one();
            for (letter, exponent) in exponents.iter().enumerate().filter(|(_, e)| **e > 0) {
                let Letter::Symbol { symbol, order: 0 } = self.model.letters[letter] else {
                    return None;
                };
                let unit = Unit::parse(self.model.symbols[symbol].unit.as_deref()?).ok()?;
                let power = BigRational::from_integer((*exponent).into());
                product = product.times_power(&unit.dimension, &power);
            }
            Some(product)
        };
        let dimensions: Option<Vec<Dimension>> =
            p.terms().map(|(m, _)| dimension(m.exponents())).collect();
        dimensions.is_none_or(|all| all.windows(2).all(|pair| pair[0] == pair[1]))
    }

    /// A point at which the relation holds, and with it the equation.
    fn zero_of(&self, relation: &Polynomial, cofactors: &[GivenEntry]) -> Option<Witness> {
        let mut supposed = Supposed::clone(&self.supposed);
        supposed.relations.push(relation.clone());
        let sides = cofactors
            .iter()
            .flat_map(|c| [&c.entry.left, &c.entry.right]);
        let letters = letters_of(sides);
        let entry = &cofactors.first()?.entry;
        self.points_under(&supposed, &letters)
            .into_iter()
            .find_map(|point| {
                let left = self.value_at(&entry.left, &point)?;
                let right = self.value_at(&entry.right, &point)?;
                let there = self.value_at(&relation.clone().into(), &point)?;
                (left == right && there.is_zero()).then(|| Witness {
                    point: self.shown(&point),
                    left: PointValue::Exact(left),
                    right: PointValue::Exact(right),
                    place: entry.place,
                    indices: entry.indices.clone(),
                })
            })
    }
}

/// Whether edits are more than one slip, and not the same one repeated.
fn different_slips(edits: &[crate::verdict::Edit]) -> bool {
    edits.len() > 1 && edits.iter().any(|edit| edit.class != edits[0].class)
}
