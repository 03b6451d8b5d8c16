//! Hypotheses that a paper prints around an equation, as in "for D = 0 and 0 < h < 1 ...".
//!
//! Inequalities bound the ranges of letters, or give polynomials signs. An equation is solved for a
//! letter in which it is linear with a coefficient that does not vanish, and the letter replaced
//! wherever the equation needs it, its time derivatives with it: a hypothesis holds at all times. What
//! is known of the replaced letter is known of its value from then on. Equations that no letter solves
//! are kept as relations, in whose [ideal] claims are decided. All this is repeated with what was found
//! until nothing changes: a function of a letter that was replaced is evaluated anew.
//!
//! From hypotheses that contradict each other everything would follow: they are not used, and a point
//! at which all of them hold is [exhibited](points) first.

pub(crate) mod admitted;
pub(super) mod ideal;
mod points;
pub(crate) mod possible;
mod signs;
mod solve;
mod stated;

use super::Checker;
use super::worlds::Insertions;
use crate::check::hypotheses::admitted::Admitted;
use crate::check::hypotheses::possible::Signs;
use crate::check::hypotheses::solve::Valid;
use crate::domain::Symbolic;
use crate::evaluate::{Evaluator, Failure, FailureKind, Value};
use crate::expr::Relation;
use crate::functions::{FunctionTable, Impossible, Supposed as Supposition};
use crate::model::range::End;
use crate::model::{Hypothesis, Letter, Model};
use ratpoly::{Polynomial, RationalFunction};
use std::collections::BTreeSet;
use std::sync::Arc;

/// How often the hypotheses are evaluated anew with what was found from them.
const PASSES: usize = 8;

/// Sums are made of so many suppositions.
const SUMS: usize = 8;

/// What is supposed of the letters.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(crate) struct Supposed {
    /// Which values they have.
    pub admitted: Admitted,
    /// Equations that no letter was solved from: these polynomials vanish.
    pub relations: Vec<Polynomial>,
    /// Letters that were solved for, with their values in the other letters.
    pub replaced: Vec<(usize, RationalFunction)>,
    /// What follows at all times from what was replaced, and vanishes too.
    consequences: Vec<RationalFunction>,
    /// What the hypotheses divide by.
    divisors: Vec<Polynomial>,
    /// Whether hypotheses are in force, beside what is declared.
    pub in_force: bool,
}

/// Why hypotheses cannot be used.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Unusable {
    /// One lies outside of what is decided.
    Outside(String),
    /// One has no value.
    NoValue,
    /// They make a divisor vanish.
    Vanishing,
    /// They contradict each other or what is declared.
    Contradictory,
    /// No values of the letters were found that satisfy them.
    NotExhibited,
    /// A limit was hit.
    Limit,
}

impl From<Impossible> for Unusable {
    fn from(why: Impossible) -> Self {
        match why {
            Impossible::DivisionByZero => Unusable::Vanishing,
            Impossible::Unsupported(what) => Unusable::Outside(what),
            Impossible::Divergent { .. } => Unusable::NoValue,
            Impossible::NoLetter => Unusable::Limit,
        }
    }
}

impl Supposed {
    /// What a model's declarations say.
    pub fn declared(model: &Model) -> Self {
        let plain = |letter: &usize| !matches!(model.letters[*letter], Letter::Function { .. });
        let ranges = (0..model.letters.len()).filter(plain);
        Supposed {
            admitted: Admitted::within(ranges.map(|l| model.range_of(l)).collect()),
            ..Supposed::default()
        }
    }

    /// Whether the hypotheses say of a letter more than between which numbers it lies, given the letters
    /// behind an element.
    pub(crate) fn is_about(
        &self,
        letter: usize,
        behind: &impl Fn(&RationalFunction) -> BTreeSet<usize>,
    ) -> bool {
        let signs = self.admitted.signs.iter().map(|(p, _)| p);
        let polynomials = signs.chain(&self.relations).chain(&self.divisors);
        let mut elements = polynomials.map(|p| RationalFunction::from(p.clone()));
        let mut replaced = self.replaced.iter();
        elements.any(|f| behind(&f).contains(&letter))
            || replaced.any(|(l, value)| *l == letter || behind(value).contains(&letter))
            || self
                .consequences
                .iter()
                .any(|f| behind(f).contains(&letter))
    }
}

impl<'m> Checker<'m> {
    /// What the letters of functions stand for under the hypotheses in force.
    pub(crate) fn functions(&self) -> Option<&FunctionTable> {
        self.exact.field.table()
    }

    /// A checker in which the hypotheses printed around an equation hold.
    ///
    /// # Errors
    /// Why they cannot be used.
    pub(crate) fn under_hypotheses(&mut self, equation: usize) -> Result<Checker<'m>, Unusable> {
        let model = self.model;
        let hypotheses: Vec<&Hypothesis> = model.equations[equation].assume.iter().collect();
        self.suppose(&hypotheses)
    }

    /// A checker in which some hypotheses hold.
    ///
    /// # Errors
    /// Why they cannot be used.
    pub(crate) fn suppose(
        &mut self,
        hypotheses: &[&'m Hypothesis],
    ) -> Result<Checker<'m>, Unusable> {
        let mut supposed = Supposed::clone(&self.supposed);
        supposed.in_force = true;
        // What is put in at a moment is no value at other times: then nothing is said of rates.
        let valid = match self.hold_at_a_moment(hypotheses) {
            true => [Valid::AtAMoment; 2],
            false => [Valid::Always, Valid::AsARate],
        };
        let mut stable = false;
        for _ in 0..PASSES {
            let next = self.pass(hypotheses, &supposed, valid)?;
            stable = next == supposed;
            supposed = next;
            if stable {
                break;
            }
        }
        if !stable {
            return Err(Unusable::Limit);
        }
        self.consistent(hypotheses, &supposed)?;
        let under = self.evaluator_under(&supposed)?;
        let mut letters = under.world().letters().to_vec();
        for (letter, value) in self.replaced_abbreviations(hypotheses) {
            letters[letter] = image(under.field.table(), &value, &supposed.replaced)?;
        }
        let there = self.exact.world().with_letters(letters);
        let exact = there.evaluator(under.field.clone());
        let inserted = self
            .inserted
            .iter()
            .map(|(letter, value)| {
                let table = under.field.table();
                Ok((*letter, image(table, value, &supposed.replaced)?))
            })
            .collect::<Result<Insertions, Unusable>>()?;
        Ok(self.elsewhere(exact, Arc::new(inserted), Arc::new(supposed)))
    }

    /// An evaluator in which letters have the values that are supposed, and the definitions are inserted.
    fn evaluator_under(&self, supposed: &Supposed) -> Result<Evaluator<'m, Symbolic>, Unusable> {
        let field = match self.functions() {
            Some(table) => Symbolic::with_functions(table.supposing(&self.suppositions(supposed))),
            None => self.exact.field.clone(),
        };
        let letters = self
            .exact
            .world()
            .letters()
            .iter()
            .map(|value| image(field.table(), value, &supposed.replaced))
            .collect::<Result<_, _>>()?;
        let world = self.exact.world().with_letters(letters).inserting();
        Ok(world.evaluator(field))
    }

    /// What is supposed, as the table of functions takes it: ends of ranges, signs, and sums of these,
    /// so that a < b < c says a < c.
    fn suppositions(&self, supposed: &Supposed) -> Vec<Supposition<RationalFunction>> {
        let ring = self.model.ring;
        let mut all: Vec<Supposition<RationalFunction>> = Vec::new();
        let mut add = |element: RationalFunction, strict: bool| {
            all.push(Supposition { element, strict });
        };
        for (letter, range) in supposed.admitted.ranges.iter().enumerate() {
            let declared = &self.supposed.admitted.ranges[letter];
            let x = || RationalFunction::variable(ring, letter);
            let number = |end: &End| RationalFunction::constant(ring, end.value.clone());
            if let Some(low) = range.low.as_ref().filter(|_| range.low != declared.low) {
                add(&x() - &number(low), !low.included);
            }
            if let Some(high) = range.high.as_ref().filter(|_| range.high != declared.high) {
                add(&number(high) - &x(), !high.included);
            }
        }
        for (p, signs) in &supposed.admitted.signs {
            let element = RationalFunction::from(p.clone());
            match *signs {
                Signs::POSITIVE => add(element, true),
                Signs::NOT_NEGATIVE => add(element, false),
                Signs::NEGATIVE => add(-&element, true),
                Signs::NOT_POSITIVE => add(-&element, false),
                _ => {}
            }
        }
        let single = all.len();
        for i in 0..single.min(SUMS) {
            for j in 0..i {
                let element = &all[i].element + &all[j].element;
                let strict = all[i].strict || all[j].strict;
                if element.as_constant().is_none() {
                    all.push(Supposition { element, strict });
                }
            }
        }
        all
    }

    /// What the hypotheses say, evaluated where what was found before is supposed.
    fn pass(
        &mut self,
        hypotheses: &[&'m Hypothesis],
        before: &Supposed,
        [as_stated, as_a_rate]: [Valid; 2],
    ) -> Result<Supposed, Unusable> {
        let mut exact = self.evaluator_under(before)?;
        let mut next = Supposed {
            relations: self.supposed.relations.clone(),
            divisors: self.supposed.divisors.clone(),
            admitted: self.supposed.admitted.clone(),
            ..before.clone()
        };
        for (letter, value) in &before.replaced {
            self.suppose_value(value, &mut next);
            self.transfer(*letter, value, &mut next)?;
        }
        // Signs first: they tell which slopes do not vanish.
        let equations = |h: &&&Hypothesis| h.relation == Relation::Equal;
        let orders = hypotheses.iter().filter(|h| !equations(h));
        for hypothesis in orders.chain(hypotheses.iter().filter(equations)) {
            exact.conditions.clear();
            let difference = hypothesis.difference();
            // It says something else in each of several cases.
            let value = match exact.expression_without_cases(&difference) {
                Ok(value) => value,
                Err(failure) => return Err(self.unusable(&failure)),
            };
            for condition in std::mem::take(&mut exact.conditions) {
                let divisor = condition.divisor.numerator().clone();
                if !next.divisors.contains(&divisor) {
                    next.divisors.push(divisor);
                }
            }
            let signs = match hypothesis.relation {
                Relation::Equal => {
                    for entry in value.entries() {
                        let entry = image(exact.field.table(), entry, &next.replaced)?;
                        self.solve(&entry, &mut exact, &mut next, (as_stated, hypothesis.span))?;
                    }
                    continue;
                }
                Relation::NotEqual => Signs::NOT_ZERO,
                Relation::Less => Signs::NEGATIVE,
                Relation::LessEqual => Signs::NOT_POSITIVE,
                Relation::Greater => Signs::POSITIVE,
                Relation::GreaterEqual => Signs::NOT_NEGATIVE,
                Relation::Approximately | Relation::Distributed | Relation::Tends => {
                    return Err(Unusable::Outside("a hypothesis that is approximate".into()));
                }
            };
            match value {
                Value::Scalar(value) => {
                    let value = image(exact.field.table(), &value, &next.replaced)?;
                    self.suppose_sign(&value, signs, &mut next)?;
                }
                Value::Zero if !signs.admits(Signs::ZERO) => return Err(Unusable::Contradictory),
                Value::Zero => {}
                Value::Matrix(_) => {
                    let what = "an inequality of matrices as a hypothesis";
                    return Err(Unusable::Outside(what.into()));
                }
            }
        }
        // A range of one number is an equation.
        for letter in 0..next.admitted.ranges.len() {
            let single = next.admitted.ranges[letter].single().cloned();
            let known = next.replaced.iter().any(|(l, _)| *l == letter);
            let symbol = matches!(self.model.letters[letter], Letter::Symbol { .. });
            if let (Some(value), false, true) = (single, known, symbol) {
                if self.is_clock(letter) {
                    let what = "a time between two equal ends";
                    return Err(Unusable::Outside(what.into()));
                }
                let x = RationalFunction::variable(self.model.ring, letter);
                let equation = &x - &RationalFunction::constant(self.model.ring, value);
                let span = hypotheses.first().map_or_else(Default::default, |h| h.span);
                self.solve(&equation, &mut exact, &mut next, (Valid::AtAMoment, span))?;
            }
        }
        for consequence in next.consequences.clone() {
            let span = hypotheses.first().map_or_else(Default::default, |h| h.span);
            let value = image(exact.field.table(), &consequence, &next.replaced)?;
            self.solve(&value, &mut exact, &mut next, (as_a_rate, span))?;
        }
        Ok(next)
    }

    fn unusable(&mut self, failure: &Failure) -> Unusable {
        if failure.kind != FailureKind::DivisionByZero {
            self.note(failure);
        }
        match &failure.kind {
            FailureKind::Unsupported { what } => Unusable::Outside(what.clone()),
            FailureKind::Budget { .. } | FailureKind::Exhausted { .. } => Unusable::Limit,
            FailureKind::DivisionByZero => Unusable::Vanishing,
            FailureKind::Shape { .. }
            | FailureKind::Exponent { .. }
            | FailureKind::Outside { .. }
            | FailureKind::Undeclared { .. }
            | FailureKind::Ambiguous { .. }
            | FailureKind::NotLinear
            | FailureKind::NotStationary
            | FailureKind::Underdetermined
            | FailureKind::Inconsistent
            | FailureKind::Divergent { .. }
            | FailureKind::NeedsItself => Unusable::NoValue,
        }
    }

    /// Whether the hypotheses contradict nothing, and hold somewhere.
    fn consistent(
        &self,
        hypotheses: &[&'m Hypothesis],
        supposed: &Supposed,
    ) -> Result<(), Unusable> {
        let signs = |p: &Polynomial| self.signs_in(supposed, p);
        let others = |letter: usize| self.range_of(letter);
        let empty = supposed.admitted.is_empty(&others, &signs::budget())
            || supposed.divisors.iter().any(Polynomial::is_zero)
            || supposed.relations.iter().any(|r| signs(r).excludes_zero());
        if empty || self.has_no_zero(supposed) {
            return Err(Unusable::Contradictory);
        }
        if self.is_exhibited(supposed) {
            return Ok(());
        }
        match self.admits_a_point(hypotheses) {
            Some(true) => Ok(()),
            Some(false) => Err(Unusable::NotExhibited),
            None => Err(Unusable::Contradictory),
        }
    }

    /// Why hypotheses cannot be used, in words.
    pub(crate) fn words_of(&self, unusable: &Unusable) -> String {
        match unusable {
            Unusable::Outside(what) => format!("{what} in a hypothesis"),
            Unusable::NoValue => "a hypothesis without a value".into(),
            Unusable::Vanishing => "a divisor vanishes under the hypotheses".into(),
            Unusable::Contradictory => {
                "the hypotheses contradict each other or what is declared: nothing holds".into()
            }
            Unusable::NotExhibited => {
                "no values of the letters were found that satisfy the hypotheses".into()
            }
            Unusable::Limit => "the hypotheses are out of reach".into(),
        }
    }
}

/// An element with values in place of letters, in the arguments of functions too.
fn image(
    table: Option<&FunctionTable>,
    value: &RationalFunction,
    replaced: &[(usize, RationalFunction)],
) -> Result<RationalFunction, Unusable> {
    if replaced.is_empty() || value.is_zero() {
        return Ok(value.clone());
    }
    match table {
        Some(table) => Ok(table.substitute(value, replaced)?),
        None => value.substitute(replaced).map_err(|_| Unusable::Vanishing),
    }
}
