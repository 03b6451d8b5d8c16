//! The ways on which a letter comes to its goal, and what a function tends to on each of them.
//!
//! A way is a positive letter t that falls to zero or grows: x = a + t, x = a - t, x = t, x = -t. Its
//! range says from which sides a letter can come: a positive one comes to zero from above only.

use super::Approach;
use crate::check::Checker;
use crate::check::admissible::Admissible;
use crate::evaluate::{Failure, Value};
use crate::expr::{Expr, ExprKind, Sign};
use crate::functions::{FunctionTable, Possible};
use crate::model::range::{Numbers, Range};
use crate::theory::limit::{Behaviour, Known, Limit, Search, Towards};
use num_rational::BigRational;
use num_traits::Zero;
use ratpoly::{Polynomial, RationalFunction, RegionSign};

/// The depth of nesting that no variable of an integral has.
const MOVING: usize = 1_000_000;

/// What is printed as the limit.
pub(crate) enum Printed {
    /// An expression.
    To(RationalFunction),
    /// Infinity.
    Infinite,
    /// Minus infinity.
    MinusInfinite,
}

/// How a letter goes to its goal.
pub(crate) struct Way {
    /// The letter.
    pub letter: usize,
    /// The goal, none for infinity.
    pub from: Option<RationalFunction>,
    /// Whether it comes from below, or falls.
    pub below: bool,
    /// Whether the letter is one of positive numbers already and need not be replaced.
    pub plain: bool,
    /// Whether it takes all real numbers.
    pub continuous: bool,
}

/// The sign of a printed infinity.
pub(super) fn infinite(expr: &Expr) -> Option<Sign> {
    match &expr.kind {
        ExprKind::Infinity => Some(Sign::Plus),
        ExprKind::Sum(terms) => match &terms[..] {
            [(sign, term)] if term.kind == ExprKind::Infinity => Some(*sign),
            _ => None,
        },
        ExprKind::Group { inner, .. } => infinite(inner),
        _ => None,
    }
}

impl Known for Admissible {
    fn sign(&self, f: &RationalFunction) -> RegionSign {
        Admissible::sign(self, f)
    }

    fn differs_from_zero(&self, f: &RationalFunction) -> bool {
        !f.is_zero()
            && self
                .points(f)
                .any(|point| self.is_apart_from_zero(f, &point))
    }
}

impl Checker<'_> {
    /// The ways on which the letter can come to its goal.
    pub(super) fn ways(&mut self, approach: &Approach) -> Result<Vec<Way>, Failure> {
        let span = approach.goal.span;
        let unsupported = |what: &str| Err(Failure::unsupported(what, span));
        let Some(letter) = self.model.letter_of_symbol(approach.symbol, 0) else {
            return unsupported("a limit in this letter");
        };
        let admissible = self.admissible();
        let range = admissible.range(letter).clone();
        if range.numbers == Numbers::Complex {
            return unsupported("a limit in a complex letter");
        }
        let way = |from: Option<RationalFunction>, below: bool| {
            let at_zero = from.as_ref().is_none_or(RationalFunction::is_zero);
            Way {
                letter,
                plain: at_zero && !below && range.is_positive(),
                from,
                below,
                continuous: range.numbers == Numbers::Real,
            }
        };
        match infinite(&approach.goal) {
            Some(Sign::Plus) if range.high.is_none() => return Ok(vec![way(None, false)]),
            Some(Sign::Minus) if range.low.is_none() => return Ok(vec![way(None, true)]),
            Some(_) => return unsupported("a limit where the letter cannot go"),
            None => {}
        }
        if range.numbers == Numbers::Integer {
            return unsupported("a limit where an integer cannot go");
        }
        let goal = match self.exact.expression_without_cases(&approach.goal)? {
            Value::Zero => RationalFunction::zero(self.model.ring),
            Value::Scalar(goal) => match self.spelt_out(&goal) {
                Some(goal) => goal,
                None => return unsupported("a limit at a goal without a value"),
            },
            Value::Matrix(_) => return unsupported("a limit at a matrix"),
        };
        if super::super::identity::letters_of([&goal]).contains(&letter) {
            return unsupported("a limit at a goal that moves");
        }
        let mut ways = Vec::new();
        let one_sided = one_sided(&approach.goal);
        if one_sided != Some(Sign::Minus) {
            match reaches(&range, &goal, false, &admissible) {
                Some(true) => ways.push(way(Some(goal.clone()), false)),
                Some(false) => {}
                None => return unsupported("a limit at a goal that may lie outside of the range"),
            }
        }
        if one_sided != Some(Sign::Plus) {
            match reaches(&range, &goal, true, &admissible) {
                Some(true) => ways.push(way(Some(goal), true)),
                Some(false) => {}
                None => return unsupported("a limit at a goal that may lie outside of the range"),
            }
        }
        if ways.is_empty() {
            return unsupported("a limit where the letter cannot go");
        }
        Ok(ways)
    }
}

/// The ways on which a letter can come to a goal of its own, or grow where there is none; none where it
/// cannot, or where that is not known.
pub(crate) fn ways_of(
    letter: usize,
    goal: Option<RationalFunction>,
    admissible: &Admissible,
) -> Option<Vec<Way>> {
    let range = admissible.range(letter);
    let way = |from: Option<RationalFunction>, below: bool| {
        let at_zero = from.as_ref().is_none_or(RationalFunction::is_zero);
        Way {
            letter,
            plain: at_zero && !below && range.is_positive(),
            from,
            below,
            continuous: range.numbers == Numbers::Real,
        }
    };
    let Some(goal) = goal else {
        let grows = range.high.is_none() && range.numbers != Numbers::Complex;
        return grows.then(|| vec![way(None, false)]);
    };
    if range.numbers != Numbers::Real {
        return None;
    }
    let mut ways = Vec::new();
    for below in [false, true] {
        if reaches(range, &goal, below, admissible)? {
            ways.push(way(Some(goal.clone()), below));
        }
    }
    (!ways.is_empty()).then_some(ways)
}

/// `+0` and `-0` say from which side.
fn one_sided(goal: &Expr) -> Option<Sign> {
    match &goal.kind {
        ExprKind::Sum(terms) => match &terms[..] {
            [(sign, term)] => match &term.kind {
                ExprKind::Number(n) if n.is_zero() => Some(*sign),
                _ => None,
            },
            _ => None,
        },
        _ => None,
    }
}

/// Whether there are numbers of a range just above (below) a goal, for all values of its letters or
/// for none.
fn reaches(
    range: &Range,
    goal: &RationalFunction,
    below: bool,
    admissible: &Admissible,
) -> Option<bool> {
    let constant = |value: &BigRational| RationalFunction::constant(goal.ring(), value.clone());
    // The end that must lie beyond the goal, and the one that must not.
    let (beyond, behind) = match below {
        false => (&range.high, &range.low),
        true => (&range.low, &range.high),
    };
    let oriented = |f: RationalFunction| if below { -&f } else { f };
    if let Some(end) = beyond {
        match admissible.sign(&oriented(&constant(&end.value) - goal)) {
            RegionSign::Positive => {}
            RegionSign::Negative | RegionSign::NonPositive | RegionSign::Zero => {
                return Some(false);
            }
            RegionSign::NonNegative | RegionSign::Changes { .. } | RegionSign::Undecided => {
                return None;
            }
        }
    }
    if let Some(end) = behind {
        match admissible.sign(&oriented(goal - &constant(&end.value))) {
            RegionSign::Positive | RegionSign::NonNegative | RegionSign::Zero => {}
            RegionSign::Negative => return Some(false),
            RegionSign::NonPositive | RegionSign::Changes { .. } | RegionSign::Undecided => {
                return None;
            }
        }
    }
    Some(true)
}

impl Way {
    /// What becomes of a value on this way.
    pub fn behaviour(
        &self,
        value: &RationalFunction,
        table: &FunctionTable,
        admissible: &Admissible,
    ) -> Possible<Behaviour> {
        let (moved, letter) = if self.plain {
            (value.clone(), self.letter)
        } else {
            // Where there are no functions the letter itself can stand for what is positive.
            let functions = !table.all().is_empty();
            let t = match functions {
                true => table.bound(MOVING, true)?,
                false => RationalFunction::variable(value.ring(), self.letter),
            };
            let step = if self.below { -&t } else { t.clone() };
            let image = match &self.from {
                Some(goal) => goal + &step,
                None => step,
            };
            let letter = t.numerator().variables_occurring();
            let letter = letter.first().copied().unwrap_or(self.letter);
            (table.substitute(value, &[(self.letter, image)])?, letter)
        };
        let search = Search {
            table,
            known: admissible,
            letter,
            towards: match self.from {
                Some(_) => Towards::Zero,
                None => Towards::Infinity,
            },
            continuous: self.continuous,
        };
        search.behaviour(&moved)
    }
}

/// Whether what was found is what is printed; none where that depends on the letters.
pub(crate) fn compared(
    found: &Behaviour,
    printed: &Printed,
    admissible: &Admissible,
) -> Option<bool> {
    // What is concluded from a limit is so at a point at least where its conditions are met.
    let somewhere = |conditions: &[Polynomial], beside: Option<RationalFunction>| {
        let mut product = beside?;
        for condition in conditions {
            product = &product * &RationalFunction::from(condition.clone());
        }
        admissible.differs_from_zero(&product).then_some(false)
    };
    match (found, printed) {
        (Behaviour::Tends(Limit::Infinite, _), Printed::Infinite)
        | (Behaviour::Tends(Limit::MinusInfinite, _), Printed::MinusInfinite) => Some(true),
        (Behaviour::Tends(Limit::To(limit), conditions), Printed::To(printed)) => {
            let difference = limit - printed;
            if difference.is_zero() {
                return Some(true);
            }
            somewhere(conditions, Some(difference))
        }
        (Behaviour::Tends(limit, conditions), _) => {
            let ring = match (limit, printed) {
                (Limit::To(f), _) | (_, Printed::To(f)) => f.ring(),
                (
                    Limit::Infinite | Limit::MinusInfinite,
                    Printed::Infinite | Printed::MinusInfinite,
                ) => match conditions.first() {
                    Some(condition) => condition.ring(),
                    None => return Some(false),
                },
            };
            somewhere(conditions, Some(RationalFunction::one(ring)))
        }
        (Behaviour::Unbounded(conditions), Printed::To(printed)) => {
            somewhere(conditions, Some(RationalFunction::one(printed.ring())))
        }
        (Behaviour::Unbounded(_), Printed::Infinite | Printed::MinusInfinite) => None,
        (Behaviour::Two(..), _) => Some(false),
    }
}
