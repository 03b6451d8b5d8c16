//! What a slip changes numerically: the printed value over the true one, at the reference point and
//! over the box around it.
//!
//! The values at the reference point are read off the exact witness of the refutation, which the
//! checker takes there where it tells the sides apart; the range over the box is that of the quotient
//! of the sides, a rational function.

use super::identity::{insert, letters_of};
use super::statement::Ground;
use super::{Checker, Options};
use crate::expr::Expr;
use crate::functions::FunctionTable;
use crate::model::{Letter, Model, Node};
use crate::theory::algebraic::Algebraic;
use crate::verdict::statement::Scope;
use crate::verdict::{Correction, Outcome, ResidualEntry, Verdict};
use num_rational::BigRational;
use num_traits::{One, Zero};
use ratpoly::RationalFunction;
use std::collections::BTreeSet;

/// The two values of a false equation at the reference point.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Effect {
    /// The value of the side that is misprinted; the left one where no correction is known.
    pub printed: BigRational,
    /// The value of the other side.
    pub correct: BigRational,
    /// Whether a correction says which side is the true one.
    pub corrected: bool,
}

impl Effect {
    /// Printed over correct.
    pub fn ratio(&self) -> BigRational {
        &self.printed / &self.correct
    }
}

/// The effect of a slip in a scalar equation whose letters have reference values.
pub fn effect(model: &Model, outcome: &Outcome) -> Option<Effect> {
    let (refutation, correction) = match &outcome.verdict {
        Verdict::Misprint {
            refutation,
            correction,
        } => (refutation, Some(correction)),
        Verdict::Refuted(refutation) => (refutation, None),
        _ => return None,
    };
    let witness = refutation.witness()?;
    let scalar = witness.place.is_none() && witness.indices.is_empty();
    let at_reference = witness.point.iter().all(|(letter, value)| {
        matches!(model.letters[*letter], Letter::Symbol { symbol, order: 0 }
            if model.symbols[symbol].value.as_ref() == value.exact())
            && value.exact().is_some()
    });
    if !scalar || !at_reference || refutation.missing().is_some() {
        return None;
    }
    let (mut printed, mut correct) = (
        witness.left.exact()?.clone(),
        witness.right.exact()?.clone(),
    );
    let corrected = match correction {
        None => false,
        Some(correction) => {
            if wrong_side(model, outcome, correction)? == Side::Right {
                std::mem::swap(&mut printed, &mut correct);
            }
            true
        }
    };
    (!correct.is_zero()).then_some(Effect {
        printed,
        correct,
        corrected,
    })
}

/// A side of a link.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Side {
    /// Before the sign.
    Left,
    /// Behind it.
    Right,
}

/// The side that holds all of a correction's changes; none where the slip is not in one side of the
/// link alone.
pub fn wrong_side(model: &Model, outcome: &Outcome, correction: &Correction) -> Option<Side> {
    let equation = &model.equations[outcome.equation];
    let link = equation.links.get(outcome.member - 1)?;
    if let Some((definition, _)) = correction.definition {
        // What does not rest on the definition is right.
        let rests = |place: crate::model::links::Place| {
            let side = place.find(&equation.display)?;
            Some(rests_on(model, side, definition))
        };
        return match (rests(link.left)?, rests(link.right)?) {
            (true, false) => Some(Side::Left),
            (false, true) => Some(Side::Right),
            _ => None,
        };
    }
    let within = |place: crate::model::links::Place| {
        let side = place.find(&equation.display)?.span;
        let mut edits = correction.edits.iter();
        Some(edits.all(|e| side.start <= e.span.start && e.span.end <= side.end))
    };
    match (within(link.left)?, within(link.right)?) {
        (true, false) => Some(Side::Left),
        (false, true) => Some(Side::Right),
        _ => None,
    }
}

/// Whether the value of an expression is computed from what an equation defines.
fn rests_on(model: &Model, expr: &Expr, equation: usize) -> bool {
    let mut used = BTreeSet::new();
    model.collect(expr, &mut used);
    let mut open: Vec<Node> = used.iter().copied().collect();
    while let Some(node) = open.pop() {
        let defined_in = match node {
            Node::Definition(d) => Some(model.definitions[d].equation),
            Node::Unknown { system, .. } => Some(model.systems[system].equation),
            _ => None,
        };
        if defined_in == Some(equation) {
            return true;
        }
        open.extend(model.needs(node).into_iter().filter(|n| used.insert(*n)));
    }
    false
}

/// How far a misprint takes a value from the true one.
#[derive(Clone, Debug)]
pub struct Change {
    /// Values of the running indices.
    pub indices: Vec<(String, i64)>,
    /// Row and column from 1, for a matrix with more than one entry.
    pub place: Option<(usize, usize)>,
    /// Printed over correct, less one, at the reference values; none where a letter has none.
    pub at_reference: Option<BigRational>,
    /// The least and the largest value of the same over the box; equal where it is a constant.
    pub range: Option<(Algebraic, Algebraic)>,
}

/// The box of [`Changes`]: its letters lie between these multiples of their reference values.
pub const BOX: [(i64, i64); 2] = [(1, 2), (3, 2)];

/// The effects of a model's misprints, with the definitions inserted.
pub struct Changes<'m> {
    model: &'m Model,
    checker: Option<Checker<'m>>,
    ground: Ground,
}

impl<'m> Changes<'m> {
    /// Ready for the outcomes of this model.
    pub fn of(model: &'m Model) -> Self {
        Changes {
            model,
            checker: Checker::new(model, Options::default()).ok(),
            ground: Ground::of(model, 0),
        }
    }

    /// What a misprint changes, entry by entry, as far as the true entry is not zero; empty where
    /// nothing can be said.
    pub fn by(&self, outcome: &Outcome) -> Vec<Change> {
        let Verdict::Misprint {
            refutation,
            correction,
        } = &outcome.verdict
        else {
            return Vec::new();
        };
        if refutation.missing().is_some() {
            return Vec::new();
        }
        let Some(side) = wrong_side(self.model, outcome, correction) else {
            return Vec::new();
        };
        let entries = refutation.residual.iter();
        entries
            .filter_map(|e| self.change(e, side, outcome.letters.as_ref()))
            .collect()
    }

    fn change(
        &self,
        entry: &ResidualEntry,
        wrong: Side,
        letters: Option<&FunctionTable>,
    ) -> Option<Change> {
        let checker = self.checker.as_ref()?;
        let all: Vec<usize> = checker.inserted.keys().copied().collect();
        let functions = letters.or(self.model.functions.as_ref());
        let inserted = insert(&[entry], &checker.insertion(&all), functions).ok()?;
        let entry = inserted.into_iter().next()?;
        let (printed, correct) = match wrong {
            Side::Left => (&entry.left, &entry.right),
            Side::Right => (&entry.right, &entry.left),
        };
        let quotient = printed.checked_div(correct).ok()?;
        let change = quotient - RationalFunction::constant(self.model.ring, BigRational::one());
        let letters = letters_of([&change]);
        let plain = letters.iter().all(|l| checker.has_reference(*l));
        let at_reference = plain.then(|| change.evaluate(&checker.reference_point()).ok());
        let scaled =
            |value: &BigRational, (n, d): (i64, i64)| value * BigRational::new(n.into(), d.into());
        let sides = letters.iter().filter_map(|letter| {
            let own = self.ground.reference(*letter)?;
            Some((*letter, scaled(own, BOX[0]), scaled(own, BOX[1])))
        });
        let range = match change.as_constant() {
            Some(constant) => Some((constant.clone().into(), constant.into())),
            None if plain => self.ground.range(&change, &Scope::Box(sides.collect())),
            None => None,
        };
        Some(Change {
            indices: entry.indices,
            place: entry.place,
            at_reference: at_reference.flatten(),
            range,
        })
    }
}
