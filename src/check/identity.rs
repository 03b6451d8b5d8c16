//! Whether two sides are equal: first in the printed letters, then with the definitions inserted.
//!
//! The steps, each exact: (1) left minus right in the letters as printed; (2) those abbreviations
//! inserted whose definition is spelt in letters that the link itself uses, so that nothing hidden
//! enters; (3) all definitions inserted. What vanishes at (1) or (2) holds; what vanishes only at
//! (3) needs a relation between the printed letters, which [`super::relations`] finds; what
//! survives (3) is false.

use super::Checker;
use super::sides::sides_of;
use crate::evaluate::{Failure, FailureKind, Value};
use crate::functions::FunctionTable;
use crate::model::Letter;
use crate::model::links::{Link, Place};
use crate::verdict::{Given, Refutation, ResidualEntry};
use ratpoly::RationalFunction;
use std::collections::BTreeSet;

/// Definitions inserted for letters, and the labels of their equations.
#[derive(Clone, Debug, Default)]
pub(crate) struct Insertion {
    pub letters: Vec<(usize, RationalFunction)>,
    pub labels: Vec<String>,
}

/// What became of an equation.
pub(crate) enum Decision {
    /// True, with these insertions.
    Holds(Insertion),
    /// True by relations among the hypotheses in force.
    Follows(Insertion, Given),
    /// True under relations.
    HoldsGiven(Insertion, Given),
    /// Not proved: the open entries as printed and with all definitions inserted, which are different
    /// formulas.
    False(Vec<ResidualEntry>, Vec<ResidualEntry>),
    /// False, with what shows it.
    Refuted(Refutation),
}

impl Checker<'_> {
    /// Both sides of a link, entry by entry, for every value of its running indices.
    pub(crate) fn sides(
        &mut self,
        equation: usize,
        link: &Link,
    ) -> Result<Vec<ResidualEntry>, Failure> {
        let display = self.display(equation);
        let span = self.model.equations[equation].span;
        let at = |place: Place| place.find(&display).map_or(span, |side| side.span);
        let both = at(link.left).to(at(link.right));
        // The divisors of these sides only: others may stand there from before.
        let before = std::mem::take(&mut self.exact.conditions);
        let sides = sides_of(&mut self.exact, &display, link, span);
        let vanishing = self.vanishing_divisor();
        let valueless = match &sides {
            Ok(sides) => self.has_no_value_at_a_support(equation, link, sides),
            Err(_) => false,
        };
        for condition in before {
            if !self.exact.conditions.contains(&condition) {
                self.exact.conditions.push(condition);
            }
        }
        let sides = sides?;
        if let Some(failure) = vanishing {
            return Err(failure);
        }
        if valueless {
            let what = "a factor that may have no value where a distribution stands";
            return Err(Failure::unsupported(what, both));
        }
        let mut entries = Vec::new();
        for (indices, left, right) in sides {
            entries.extend(self.paired(&left, &right, &indices, both)?);
        }
        self.at_supports(equation, link, entries, both)
    }

    fn paired(
        &self,
        left: &Value<RationalFunction>,
        right: &Value<RationalFunction>,
        indices: &[(String, i64)],
        span: crate::span::Span,
    ) -> Result<Vec<ResidualEntry>, Failure> {
        let zero = RationalFunction::zero(self.model.ring);
        let is_zero = |v: &Value<RationalFunction>| match v {
            Value::Zero => true,
            Value::Scalar(s) => s.is_zero(),
            Value::Matrix(_) => false,
        };
        let shape = match (left.shape(), right.shape()) {
            (Some(l), Some(r)) if l == r => l,
            (Some(l), _) if is_zero(right) => l,
            (_, Some(r)) if is_zero(left) => r,
            (None, None) => (1, 1),
            _ => {
                return Err(Failure::new(
                    FailureKind::Shape {
                        operation: "=".into(),
                        left: left.shape_text(),
                        right: right.shape_text(),
                    },
                    span,
                ));
            }
        };
        let at = |value: &Value<RationalFunction>, i: usize, j: usize| match value {
            Value::Matrix(m) => m[(i, j)].clone(),
            Value::Scalar(s) => s.clone(),
            Value::Zero => zero.clone(),
        };
        let comparable = |f: RationalFunction| match &self.model.functions {
            Some(table) => table
                .comparable(&f)
                .map_err(|why| Failure::impossible(why, span)),
            None => Ok(f),
        };
        let mut entries = Vec::new();
        for i in 0..shape.0 {
            for j in 0..shape.1 {
                entries.push(ResidualEntry {
                    indices: indices.to_vec(),
                    place: (shape != (1, 1)).then_some((i + 1, j + 1)),
                    left: comparable(at(left, i, j))?,
                    right: comparable(at(right, i, j))?,
                });
            }
        }
        Ok(entries)
    }

    /// Decides the equality of the sides.
    ///
    /// # Errors
    /// A reason why it stays undecided.
    pub(crate) fn decide(
        &mut self,
        entries: &[ResidualEntry],
        equation: usize,
    ) -> Result<Decision, String> {
        match self.decide_true(entries, equation)? {
            Decision::False(open, expanded) => {
                let shown: Vec<&ResidualEntry> = open.iter().collect();
                match self.refutation(&shown, &expanded) {
                    Some(refutation) => Ok(Decision::Refuted(refutation)),
                    None => Ok(Decision::False(open, expanded)),
                }
            }
            decision => Ok(decision),
        }
    }

    /// Whether the sides are equal; what is false stays without its witness.
    ///
    /// # Errors
    /// A reason why it stays undecided.
    pub(crate) fn decide_true(
        &mut self,
        entries: &[ResidualEntry],
        equation: usize,
    ) -> Result<Decision, String> {
        let open: Vec<&ResidualEntry> = entries.iter().filter(|e| e.left != e.right).collect();
        if open.is_empty() {
            return Ok(Decision::Holds(Insertion::default()));
        }
        let visible = self.visible_insertion(entries);
        let functions = self.functions();
        let remaining = insert(&open, &visible, functions)?;
        if remaining.iter().all(|e| e.left == e.right) {
            return Ok(Decision::Holds(visible));
        }
        let all = self.insertion(&self.inserted.keys().copied().collect::<Vec<_>>());
        let expanded = insert(&remaining.iter().collect::<Vec<_>>(), &all, functions)?;
        if expanded.iter().all(|e| e.left == e.right) {
            let open = remaining
                .iter()
                .filter(|e| e.left != e.right)
                .cloned()
                .collect();
            let given = self.hidden_relations(open)?;
            // A relation that is the claim is no hypothesis: the definitions make it true.
            if is_the_claim(&given) {
                return Ok(Decision::Holds(self.needed(&remaining)));
            }
            return Ok(Decision::HoldsGiven(visible, given));
        }
        let different: Vec<ResidualEntry> = expanded
            .iter()
            .filter(|e| e.left != e.right)
            .cloned()
            .collect();
        if let Some(given) = self.by_relations(&different) {
            return Ok(Decision::Follows(self.needed(&remaining), given));
        }
        if let Some(given) = self.stated_relations(&open, equation)? {
            return Ok(Decision::HoldsGiven(Insertion::default(), given));
        }
        let open = open.into_iter().cloned().collect();
        Ok(Decision::False(open, expanded))
    }

    /// The insertion of the definitions of these letters.
    pub(crate) fn insertion(&self, letters: &[usize]) -> Insertion {
        let mut labels: Vec<(usize, String)> = letters
            .iter()
            .filter_map(|letter| match self.model.letters[*letter] {
                Letter::Abbreviation { definition } => {
                    let equation = self.model.definitions[definition].equation;
                    Some((equation, self.model.equations[equation].label.clone()))
                }
                Letter::Symbol { .. } | Letter::Function { .. } => None,
            })
            .collect();
        labels.sort();
        labels.dedup();
        Insertion {
            letters: letters
                .iter()
                .filter_map(|l| Some((*l, self.inserted.get(l)?.clone())))
                .collect(),
            labels: labels.into_iter().map(|(_, label)| label).collect(),
        }
    }

    /// The insertion of the definitions of the letters that occur in entries.
    fn needed(&self, entries: &[ResidualEntry]) -> Insertion {
        let letters = letters_of(entries.iter().flat_map(|e| [&e.left, &e.right]));
        self.insertion(&letters.into_iter().collect::<Vec<_>>())
    }

    /// The abbreviations whose definition is spelt in letters that the link uses.
    fn visible_insertion(&self, entries: &[ResidualEntry]) -> Insertion {
        let used = letters_of(entries.iter().flat_map(|e| [&e.left, &e.right]));
        let visible: Vec<usize> = self
            .inserted
            .iter()
            .filter(|(letter, value)| {
                used.contains(letter) && letters_of([*value]).is_subset(&used)
            })
            .map(|(letter, _)| *letter)
            .collect();
        self.insertion(&visible)
    }
}

/// Whether the only relation is, but for a number, what is to be shown.
pub(super) fn is_the_claim(given: &Given) -> bool {
    let number = |c: &RationalFunction| c.as_constant().is_some();
    given.relations.len() == 1
        && given
            .cofactors
            .iter()
            .all(|entry| entry.cofactors.iter().all(number))
}

/// The entries with definitions inserted.
pub(crate) fn insert(
    entries: &[&ResidualEntry],
    insertion: &Insertion,
    functions: Option<&FunctionTable>,
) -> Result<Vec<ResidualEntry>, String> {
    let image = |side: &RationalFunction| {
        if insertion.letters.is_empty() {
            return Ok(side.clone());
        }
        match functions {
            Some(table) => table.substitute(side, &insertion.letters).ok(),
            None => side.substitute(&insertion.letters).ok(),
        }
        .ok_or_else(|| "a denominator vanishes by the definitions".to_string())
    };
    entries
        .iter()
        .map(|e| {
            Ok(ResidualEntry {
                indices: e.indices.clone(),
                place: e.place,
                left: image(&e.left)?,
                right: image(&e.right)?,
            })
        })
        .collect()
}

/// The letters that occur in some rational functions.
pub(crate) fn letters_of<'a>(
    functions: impl IntoIterator<Item = &'a RationalFunction>,
) -> BTreeSet<usize> {
    functions
        .into_iter()
        .flat_map(|f| {
            let mut letters = f.numerator().variables_occurring();
            letters.extend(f.denominator().variables_occurring());
            letters
        })
        .collect()
}
