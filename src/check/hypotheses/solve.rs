//! Equations among the hypotheses, solved for letters.

use super::{Supposed, Unusable, image};
use crate::check::Checker;
use crate::check::hypotheses::possible::Signs;
use crate::domain::Symbolic;
use crate::evaluate::{Evaluator, Value};
use crate::expr::Relation;
use crate::model::range::{Numbers, Range};
use crate::model::time::Clock;
use crate::model::{Hypothesis, Letter};
use crate::span::Span;
use ratpoly::{Polynomial, RationalFunction};

/// How often a relation that no letter solves is differentiated by the time.
const RATES: usize = 2;

/// A letter that an equation can be solved for.
struct Candidate {
    letter: usize,
    value: RationalFunction,
}

/// When an equation between letters holds.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Valid {
    /// At a moment at least: it says nothing of rates.
    AtAMoment,
    /// At all times.
    Always,
    /// At all times, as the rate of something else: where no letter solves it, its own rates are not looked at.
    AsARate,
}

impl<'m> Checker<'m> {
    /// Adds what `vanishing = 0` says, in letters that are not replaced; whether its rates are to be
    /// looked at too, and where it stands.
    pub(super) fn solve(
        &mut self,
        vanishing: &RationalFunction,
        exact: &mut Evaluator<'m, Symbolic>,
        supposed: &mut Supposed,
        (valid, span): (Valid, Span),
    ) -> Result<(), Unusable> {
        if vanishing.is_zero() {
            return Ok(());
        }
        if vanishing.numerator().is_constant() {
            return Err(Unusable::Contradictory);
        }
        let candidate = match self.candidate(vanishing.numerator(), supposed, true) {
            Some(candidate) => Some(candidate),
            None => {
                let essential = self.essential(vanishing.numerator(), supposed)?;
                let candidate = self.candidate(&essential, supposed, false);
                if candidate.is_none() && !supposed.relations.contains(&essential) {
                    if valid == Valid::Always {
                        self.follow(&essential, exact, supposed, span);
                    }
                    supposed.relations.push(essential);
                }
                candidate
            }
        };
        match candidate {
            Some(found) => {
                let Candidate { letter, value } = found;
                self.suppose_value(&value, supposed);
                self.replace((letter, value), exact, supposed, (valid, span))
            }
            None => Ok(()),
        }
    }

    /// Where a letter has a value in others, what that divides by does not vanish: xy = 1 says that y is not
    /// zero.
    pub(super) fn suppose_value(&self, value: &RationalFunction, supposed: &mut Supposed) {
        let divisor = value.denominator();
        if !divisor.is_constant() && !self.signs_in(supposed, divisor).excludes_zero() {
            supposed.admitted.suppose(divisor, Signs::NOT_ZERO);
        }
    }

    /// What a relation says of the rates: it holds at all times.
    fn follow(
        &mut self,
        relation: &Polynomial,
        exact: &mut Evaluator<'m, Symbolic>,
        supposed: &mut Supposed,
        span: Span,
    ) {
        let mut rate = RationalFunction::from(relation.clone());
        for _ in 0..RATES {
            match exact.differentiate(Value::Scalar(rate), 1, span) {
                Ok(Value::Scalar(next)) if !next.is_zero() => {
                    if !supposed.consequences.contains(&next) {
                        supposed.consequences.push(next.clone());
                    }
                    rate = next;
                }
                _ => return,
            }
        }
    }

    /// The letter that an equation is solved for: one whose coefficient is a number, if there is one;
    /// of these one of which the least is declared, and the highest derivative of a process.
    fn candidate(
        &self,
        vanishing: &Polynomial,
        supposed: &Supposed,
        constant: bool,
    ) -> Option<Candidate> {
        let occurring = vanishing.variables_occurring();
        let ranges = &supposed.admitted.ranges;
        let complex = |l: &usize| match ranges.get(*l) {
            Some(range) => range.numbers == Numbers::Complex,
            None => self.range_of(*l).numbers == Numbers::Complex,
        };
        let any_complex = occurring.iter().any(complex);
        let mut best: Option<((usize, usize, usize, usize), Candidate)> = None;
        for letter in &occurring {
            let Letter::Symbol { symbol, order } = self.model.letters[*letter] else {
                continue;
            };
            if any_complex && !complex(letter) || self.stands_in_function(*letter, &occurring) {
                continue;
            }
            let [rest, slope] = &vanishing.coefficients_in(*letter)[..] else {
                continue;
            };
            let never = |p: &Polynomial| {
                self.signs_in(supposed, p).excludes_zero()
                    || supposed
                        .divisors
                        .iter()
                        .any(|d| !d.is_zero() && d.div_exact(p).is_some())
            };
            // Where slope times letter is not zero, neither is the slope.
            let solvable = match constant {
                true => slope.is_constant(),
                false => slope.is_constant() || never(slope) || never(rest),
            };
            if !solvable {
                continue;
            }
            let Ok(value) = RationalFunction::new(-rest.clone(), slope.clone()) else {
                continue;
            };
            let range = &ranges[*letter];
            if range.numbers == Numbers::Integer && value.as_constant().is_none() {
                continue;
            }
            let definite = self.model.symbols[symbol]
                .entry_of
                .is_some_and(|(m, ..)| self.model.matrices[m].shape.positive_definite);
            let known = match () {
                () if range.numbers == Numbers::Complex => 0,
                () if definite => 3,
                () if *range == Range::default() => 1,
                () => 2,
            };
            let runs = matches!(self.model.clock(symbol), Clock::Runs(_));
            let time = runs && self.model.symbols[symbol].function_of.is_none();
            let rank = (
                usize::from(!slope.is_constant()),
                usize::from(time),
                known,
                usize::from(u8::MAX - order),
            );
            if best.as_ref().is_none_or(|(other, _)| rank < *other) {
                best = Some((
                    rank,
                    Candidate {
                        letter: *letter,
                        value,
                    },
                ));
            }
        }
        best.map(|(_, candidate)| candidate)
    }

    /// Whether a letter stands in the argument of a function among these letters.
    fn stands_in_function(&self, letter: usize, among: &[usize]) -> bool {
        self.functions().is_some_and(|table| {
            among.iter().any(|l| {
                *l != letter
                    && table.meaning(*l).is_some()
                    && table.letters_behind(&table.variable(*l)).contains(&letter)
            })
        })
    }

    /// Replaces a letter, and its time derivatives by those of its value.
    fn replace(
        &mut self,
        first: (usize, RationalFunction),
        exact: &mut Evaluator<'m, Symbolic>,
        supposed: &mut Supposed,
        (valid, span): (Valid, Span),
    ) -> Result<(), Unusable> {
        let mut pending = vec![first];
        while let Some((letter, value)) = pending.pop() {
            let table = exact.field.table().cloned();
            let only = [(letter, value.clone())];
            for (_, earlier) in &mut supposed.replaced {
                *earlier = image(table.as_ref(), earlier, &only)?;
            }
            for relation in std::mem::take(&mut supposed.relations) {
                let relation = image(table.as_ref(), &relation.into(), &only)?;
                if !relation.is_zero() && !supposed.consequences.contains(&relation) {
                    supposed.consequences.push(relation);
                }
            }
            for divisor in &mut supposed.divisors {
                let there = image(table.as_ref(), &divisor.clone().into(), &only)?;
                *divisor = there.numerator().clone();
            }
            self.transfer(letter, &value, supposed)?;
            supposed.replaced.push((letter, value.clone()));
            let Letter::Symbol { symbol, order } = self.model.letters[letter] else {
                continue;
            };
            if valid == Valid::AtAMoment {
                continue;
            }
            let Ok(Value::Scalar(rate)) = exact.differentiate(Value::Scalar(value), 1, span) else {
                if self.model.letter_of_symbol(symbol, order + 1).is_some() {
                    let what = "a rate of a hypothesis";
                    return Err(Unusable::Outside(what.into()));
                }
                continue;
            };
            let rate = image(table.as_ref(), &rate, &supposed.replaced)?;
            let constant = self.model.symbols[symbol].function_of.is_none();
            // A time goes on by itself.
            let own = match self.model.clock(symbol) {
                Clock::Runs(_) if constant => RationalFunction::one(self.model.ring),
                Clock::Runs(_) | Clock::Still | Clock::Unclear => {
                    RationalFunction::zero(self.model.ring)
                }
            };
            match self.model.letter_of_symbol(symbol, order + 1) {
                Some(next) => match supposed.replaced.iter().find(|(known, _)| *known == next) {
                    None => pending.push((next, rate)),
                    Some((_, known)) => {
                        let difference = &rate - known;
                        if !difference.is_zero() && !supposed.consequences.contains(&difference) {
                            supposed.consequences.push(difference);
                        }
                    }
                },
                // What does not move has no rate, and a time that has a value always is none.
                None if constant => {
                    let difference = &rate - &own;
                    if !difference.is_zero() && !supposed.consequences.contains(&difference) {
                        supposed.consequences.push(difference);
                    }
                }
                None => {}
            }
        }
        Ok(())
    }

    /// Abbreviations that hypotheses give a value in the other printed letters.
    pub(super) fn replaced_abbreviations(
        &mut self,
        hypotheses: &[&'m Hypothesis],
    ) -> Vec<(usize, RationalFunction)> {
        let mut replaced: Vec<(usize, RationalFunction)> = Vec::new();
        for hypothesis in hypotheses {
            if hypothesis.relation != Relation::Equal {
                continue;
            }
            let Ok(Value::Scalar(value)) = self
                .exact
                .expression_without_cases(&hypothesis.difference())
            else {
                continue;
            };
            let Ok(rest) = image(self.functions(), &value, &replaced) else {
                continue;
            };
            let found = rest
                .numerator()
                .variables_occurring()
                .into_iter()
                .find_map(|letter| {
                    self.inserted.get(&letter)?;
                    let [rest, slope] = &rest.numerator().coefficients_in(letter)[..] else {
                        return None;
                    };
                    let never = slope.is_constant() || self.signs(slope) == Signs::POSITIVE;
                    let value = RationalFunction::new(-rest.clone(), slope.clone()).ok()?;
                    never.then_some((letter, value))
                });
            let Some((letter, value)) = found else {
                continue;
            };
            let only = [(letter, value.clone())];
            let earlier: Result<Vec<_>, Unusable> = replaced
                .iter()
                .map(|(l, v)| Ok((*l, image(self.functions(), v, &only)?)))
                .collect();
            if let Ok(mut earlier) = earlier {
                earlier.push((letter, value));
                replaced = earlier;
            }
        }
        replaced
    }
}
