//! Where distributions stand, and which case of a definition is meant there.
//!
//! Of f(x) delta(u(x)) with an f that is defined by cases only the value of f where u vanishes counts, if f is
//! continuous there (L. Schwartz, *Théorie des distributions*, 1950, ch. V). In a case whose conditions exclude
//! that place the distribution is zero. That the sides differ shows something where every other case excludes it and
//! this one has it inside; elsewhere the place is one at which cases meet, or nothing says in which case it is. What
//! is equal in all cases that may have it is equal.

use super::Checker;
use super::sides::{CASE, Sides};
use crate::evaluate::Failure;
use crate::functions::{FunctionLetter, FunctionTable, Functions, Sign, Supposed};
use crate::model::links::Link;
use crate::span::Span;
use crate::verdict::ResidualEntry;
use ratpoly::RationalFunction;
use std::collections::BTreeSet;

/// The conditions of a case where a distribution stands.
type There = Vec<Supposed<RationalFunction>>;

/// Where a distribution stands, as seen from a case.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Stand {
    /// In the interior of the case.
    Inside,
    /// Outside of it, and not at its border.
    Outside,
    /// Neither is known.
    Open,
}

impl Checker<'_> {
    /// The entries of a link with what distributions are worth in each case.
    ///
    /// # Errors
    /// Where the sides differ by a distribution and nothing says which case counts.
    pub(super) fn at_supports(
        &mut self,
        equation: usize,
        link: &Link,
        mut entries: Vec<ResidualEntry>,
        span: Span,
    ) -> Result<Vec<ResidualEntry>, Failure> {
        let case = |e: &ResidualEntry| {
            let mut own = e.indices.iter().filter(|(name, _)| name == CASE);
            own.next().map(|(_, number)| *number)
        };
        let Some(table) = self.functions().cloned() else {
            return Ok(entries);
        };
        let differs = |e: &ResidualEntry| e.left != e.right && !standing_in(&table, e).is_empty();
        if !entries.iter().any(|e| case(e).is_some() && differs(e)) {
            return Ok(entries);
        }
        let unknown = || {
            let what = "a distribution where nothing says which case of a definition counts";
            Failure::unsupported(what, span)
        };
        let cases: BTreeSet<i64> = entries.iter().filter_map(case).collect();
        let mut supposed = Vec::new();
        for number in cases {
            let indices = [(CASE.to_string(), number)];
            let own = self.suppositions_of_case(equation, link, &indices);
            supposed.push((number, own.ok_or_else(unknown)?));
        }
        for entry in &mut entries {
            let Some(number) = case(entry).filter(|_| differs(entry)) else {
                continue;
            };
            if entry.indices.len() > 1 {
                return Err(unknown());
            }
            for (letter, argument) in standing_in(&table, entry) {
                let argument = self.spelt_out(&argument).ok_or_else(unknown)?;
                let place = place_of(&table, &argument).ok_or_else(unknown)?;
                let mut own = None;
                let (mut elsewhere, mut somewhere) = (false, false);
                for (other, conditions) in &supposed {
                    let there = at(&table, conditions, &place).ok_or_else(unknown)?;
                    let stand = stand(&table, &there);
                    somewhere |= stand != Stand::Outside;
                    if *other == number {
                        own = Some((stand, there));
                    } else {
                        elsewhere |= stand != Stand::Outside;
                    }
                }
                let (stand, there) = own.filter(|_| somewhere).ok_or_else(unknown)?;
                let left = multiple(&table, &entry.left, letter).ok_or_else(unknown)?;
                let right = multiple(&table, &entry.right, letter).ok_or_else(unknown)?;
                match stand {
                    Stand::Inside if !elsewhere => continue,
                    Stand::Outside => {}
                    Stand::Inside | Stand::Open => {
                        let apart = self.spelt_out(&(&left - &right)).ok_or_else(unknown)?;
                        if !vanishes(&table, &apart, &there) {
                            return Err(unknown());
                        }
                    }
                }
                let delta = table.variable(letter);
                entry.left = table.reduce(&entry.left - &(&left * &delta));
                entry.right = table.reduce(&entry.right - &(&right * &delta));
            }
        }
        Ok(entries)
    }
}

impl Checker<'_> {
    /// Whether something in the sides of a link, as they are before anything cancels there, has no value where a
    /// distribution in them stands: a divisor that vanishes, or a range that does not reach so far.
    pub(super) fn has_no_value_at_a_support(
        &mut self,
        equation: usize,
        link: &Link,
        sides: &Sides<RationalFunction>,
    ) -> bool {
        let Some(table) = self.functions().cloned() else {
            return false;
        };
        let elements = || {
            let both = sides.iter().flat_map(|(_, left, right)| [left, right]);
            both.flat_map(|side| side.entries())
        };
        let mut found: Vec<RationalFunction> = Vec::new();
        for (_, argument) in elements().flat_map(|f| table.distributions(f)) {
            if !found.contains(&argument) {
                found.push(argument);
            }
        }
        if found.is_empty() {
            return false;
        }
        let mut divisors: Vec<RationalFunction> = Vec::new();
        for condition in &self.exact.conditions {
            divisors.push(condition.divisor.clone());
        }
        for letter in elements().flat_map(|f| table.letters_behind(f)) {
            if let Some(value) = self.inserted.get(&letter) {
                divisors.push(value.denominator().clone().into());
            }
        }
        let by_cases = sides
            .iter()
            .any(|(indices, ..)| indices.iter().any(|(name, _)| name == CASE));
        let range = match by_cases {
            true => Vec::new(),
            false => match self.suppositions_of(equation, link, 0) {
                Some(supposed) => supposed,
                None => return true,
            },
        };
        found.iter().any(|argument| {
            let Some(place) = self.spelt_out(argument).and_then(|u| place_of(&table, &u)) else {
                return false;
            };
            let vanishes = |divisor: &RationalFunction| {
                let image = [(place.0, place.1.clone())];
                let there = self
                    .spelt_out(divisor)
                    .map(|d| table.substitute(&d, &image));
                !matches!(there, Some(Ok(there)) if !there.is_zero())
            };
            // A range of another letter is the same there.
            let about = |s: &&Supposed<RationalFunction>| {
                table.letters_behind(&s.element).contains(&place.0)
            };
            let range: Vec<_> = range.iter().filter(about).cloned().collect();
            let reaches = || match at(&table, &range, &place) {
                Some(there) => there.is_empty() || stand(&table, &there) == Stand::Inside,
                None => false,
            };
            divisors.iter().any(vanishes) || !reaches()
        })
    }
}

/// The distributions in an entry.
fn standing_in(table: &FunctionTable, entry: &ResidualEntry) -> Vec<(usize, RationalFunction)> {
    let mut found = table.distributions(&entry.left);
    for other in table.distributions(&entry.right) {
        if !found.contains(&other) {
            found.push(other);
        }
    }
    found
}

/// The coefficient of a distribution in a side, which is linear in it.
fn multiple(
    table: &FunctionTable,
    side: &RationalFunction,
    letter: usize,
) -> Option<RationalFunction> {
    Some(table.reduce(side.derivative(letter).ok()?))
}

/// A letter, and what it is where an argument vanishes.
fn place_of(
    table: &FunctionTable,
    argument: &RationalFunction,
) -> Option<(usize, RationalFunction)> {
    let letters = argument.numerator().variables_occurring();
    letters.into_iter().rev().find_map(|letter| {
        if matches!(table.meaning(letter), Some(FunctionLetter::Dirac(_))) {
            return None;
        }
        let (zero, _) = table.simple_zero(argument, letter)?;
        Some((letter, zero))
    })
}

/// Conditions at a place.
fn at(
    table: &FunctionTable,
    conditions: &[Supposed<RationalFunction>],
    (letter, zero): &(usize, RationalFunction),
) -> Option<There> {
    let image = [(*letter, zero.clone())];
    let put = |s: &Supposed<RationalFunction>| {
        let element = table.substitute(&s.element, &image).ok()?;
        Some(Supposed { element, ..*s })
    };
    conditions.iter().map(put).collect()
}

/// Where a distribution stands, by the conditions of a case at its place.
fn stand(table: &FunctionTable, there: &There) -> Stand {
    let excludes = |k: usize| {
        let mut others = there.clone();
        let own = others.remove(k);
        // By itself, or beside each of the others: both are asked, for one hides what it contradicts.
        table.known_sign(&own.element) == Some(Sign::Negative)
            || Functions::sign_where(table, &own.element, &others) == Some(Sign::Negative)
    };
    if (0..there.len()).any(excludes) {
        return Stand::Outside;
    }
    let holds = |s: &Supposed<_>| table.known_sign(&s.element) == Some(Sign::Positive);
    match !there.is_empty() && there.iter().all(holds) {
        true => Stand::Inside,
        false => Stand::Open,
    }
}

/// Whether an element is zero where these conditions hold.
fn vanishes(table: &FunctionTable, element: &RationalFunction, there: &There) -> bool {
    let anew = Functions::value_where(table, element, there);
    let element = anew.unwrap_or_else(|_| element.clone());
    if element.is_zero() {
        return true;
    }
    let signs = |k: usize| Functions::sign_where(table, &element, &there[k..=k]);
    let all = || (0..there.len()).filter_map(signs);
    all().any(Sign::is_not_negative) && all().any(Sign::is_not_positive)
}
