//! Hypotheses that a paper prints around an equation, as in "for D = 0 and h = 0 ...".
//!
//! Each is solved for a letter in which it is linear with a constant coefficient, and the letter
//! replaced wherever the equation needs it, its time derivatives with it: what solves an equation
//! of motion then does so under the hypothesis.

use super::Checker;
use crate::domain::Symbolic;
use crate::evaluate::{Evaluator, FailureKind, Value};
use crate::expr::Relation;
use crate::model::Letter;
use crate::span::Span;
use ratpoly::RationalFunction;
use std::collections::BTreeMap;

/// What the hypotheses make of an evaluation.
pub(super) struct Hypotheses<'m> {
    /// An evaluator in which they hold.
    pub exact: Evaluator<'m, Symbolic>,
    /// The values of the abbreviations under them.
    pub inserted: BTreeMap<usize, RationalFunction>,
}

impl<'m> Checker<'m> {
    /// The evaluation of an equation under the hypotheses printed around it.
    ///
    /// # Errors
    /// Why they cannot be used.
    pub(super) fn under_hypotheses(&mut self, equation: usize) -> Result<Hypotheses<'m>, String> {
        let model = self.model;
        let mut replaced: Vec<(usize, RationalFunction)> = Vec::new();
        for hypothesis in &model.equations[equation].assume {
            if hypothesis.relation != Relation::Equal {
                return Err("a hypothesis that is no equation".into());
            }
            let value = self
                .exact
                .expression(&hypothesis.difference())
                .map_err(|failure| {
                    self.note(&failure);
                    match failure.kind {
                        FailureKind::Unsupported { what } => format!("{what} in a hypothesis"),
                        _ => "a hypothesis without a value".into(),
                    }
                })?;
            let entries: Vec<RationalFunction> = value.entries().into_iter().cloned().collect();
            for entry in entries {
                self.replace_by(&entry, &mut replaced, hypothesis.span)?;
            }
        }
        let image = |value: &RationalFunction| {
            value
                .substitute(&replaced)
                .map_err(|_| "a divisor vanishes under the hypotheses".to_string())
        };
        let letters = self.exact.letters().iter().map(image);
        let exact = self.exact.with_letters(letters.collect::<Result<_, _>>()?);
        let inserted = self
            .inserted
            .iter()
            .map(|(letter, value)| Ok((*letter, image(value)?)))
            .collect::<Result<_, String>>()?;
        Ok(Hypotheses { exact, inserted })
    }

    /// Adds to the replacements what `vanishing = 0` says.
    fn replace_by(
        &mut self,
        vanishing: &RationalFunction,
        replaced: &mut Vec<(usize, RationalFunction)>,
        span: Span,
    ) -> Result<(), String> {
        let rest = vanishing
            .substitute(replaced)
            .map_err(|_| "a divisor vanishes under the hypotheses".to_string())?;
        if rest.is_zero() {
            return Ok(());
        }
        let numerator = RationalFunction::from(rest.numerator().clone());
        let solved = rest
            .numerator()
            .variables_occurring()
            .into_iter()
            .find_map(|letter| {
                let slope = numerator.derivative(letter).ok()?;
                let constant = slope.numerator().is_constant() && slope.denominator().is_constant();
                let by_letter = RationalFunction::variable(self.model.ring, letter);
                let quotient = numerator.checked_div(&slope).ok()?;
                constant.then(|| (letter, &by_letter - &quotient))
            });
        let Some((letter, value)) = solved else {
            return Err("a hypothesis that is not linear in any letter".into());
        };
        self.replace(letter, value, replaced, span)
    }

    /// Replaces a letter, and its time derivatives by those of its value.
    fn replace(
        &mut self,
        letter: usize,
        value: RationalFunction,
        replaced: &mut Vec<(usize, RationalFunction)>,
        span: Span,
    ) -> Result<(), String> {
        let mut pending = vec![(letter, value)];
        while let Some((letter, value)) = pending.pop() {
            let only = [(letter, value.clone())];
            for (_, earlier) in replaced.iter_mut() {
                *earlier = earlier
                    .substitute(&only)
                    .map_err(|_| "a divisor vanishes under the hypotheses".to_string())?;
            }
            let next = match self.model.letters[letter] {
                Letter::Symbol { symbol, order } => self.model.letter_of_symbol(symbol, order + 1),
                Letter::Abbreviation { .. } | Letter::Function { .. } => None,
            };
            let known = |l: usize| replaced.iter().any(|(r, _)| *r == l);
            if let Some(next) = next.filter(|next| !known(*next)) {
                let rate = self
                    .exact
                    .differentiate(Value::Scalar(value.clone()), 1, span)
                    .map_err(|_| "a hypothesis that cannot be differentiated".to_string())?;
                if let Value::Scalar(rate) = rate {
                    let rate = rate
                        .substitute(replaced)
                        .and_then(|rate| rate.substitute(&only))
                        .map_err(|_| "a divisor vanishes under the hypotheses".to_string())?;
                    pending.push((next, rate));
                }
            }
            replaced.push((letter, value));
        }
        Ok(())
    }
}
