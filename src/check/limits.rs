//! Claims that something tends to a limit, and integrals that are said to be infinite.
//!
//! `\Omega \to 0, \Phi(\Omega) \to \infty`: the clause about a letter says where it goes, the other
//! clauses say what becomes of something there. An argument that is printed as a number is the
//! point itself: `\Phi(0) \to \infty` speaks of the limit at zero and of no other. A goal inside of a
//! letter's range is approached from both sides, and both must lead to the printed limit.

mod points;
mod ways;

use super::Checker;
use super::divergent::Comes;
use super::edit::{Address, Change, Replacement};
use super::stationary::EXISTS_FOR_SOME;
use crate::domain::{Domain, Symbolic};
use crate::evaluate::{Condition, Evaluator, Failure, FailureKind, Origin, Value};
use crate::expr::reading;
use crate::expr::walk::{children, mentions, varied_name};
use crate::expr::{Display, Expr, ExprKind, Name, Relation, Sign};
use crate::functions::FunctionTable;
use crate::model::links::{Link, Place};
use crate::model::names::Resolved;
use crate::theory::limit::{Behaviour, Limit, Towards};
use crate::verdict::certificate::{Leading, Steps};
use crate::verdict::{
    Changed, Correction, CounterProof, EditClass, Refutation, ResidualEntry, Shown, Structure,
    Verdict,
};
use num_traits::Zero;
use ratpoly::{Polynomial, RationalFunction, RegionSign};
use std::collections::BTreeSet;
use ways::infinite;
pub(crate) use ways::{Printed, Way, compared, ways_of};

/// Where a display says that a letter goes.
struct Approach {
    place: Place,
    letter: Name,
    symbol: usize,
    goal: Expr,
    /// The symbols that move as well, of which what has the limit must be free.
    beside: Vec<usize>,
}

/// What a limit was found to be, compared with the printed one.
enum Found {
    /// It is the printed one wherever these polynomials do not vanish.
    True(Vec<Polynomial>),
    /// It is not, for what is shown.
    False(Shown),
}

impl Checker<'_> {
    /// The verdict on `left \to right`.
    pub(super) fn tends(&mut self, equation: usize, link: &Link) -> Verdict {
        let display = self.exact.display(equation).clone();
        let approach = match self.approach(&display, link) {
            Ok(approach) => approach,
            Err(failure) => return self.failed(&failure),
        };
        if approach.as_ref().is_some_and(|a| a.place == link.right) {
            return Verdict::Definition {
                what: "where the limit is taken".into(),
            };
        }
        let flaw = match self.judged_limit(&display, link, approach.as_ref()) {
            Ok(Found::True(conditions)) => {
                self.suppose_nonzero(conditions, &display, link);
                return self.limit_holds(equation, link);
            }
            Ok(Found::False(shown)) => shown,
            Err(failure) => return self.failed(&failure),
        };
        let residual = self.limit_residual(&flaw, &display, link);
        let refutation = Refutation::new(flaw).with_residual(residual);
        // Where the argument that is printed goes elsewhere, the end is what was mistaken. Where the limit
        // is another one, another end would make another statement of it.
        let elsewhere = matches!(refutation.shown(), Shown::Structure(Structure::Elsewhere));
        let Some(approach) = approach.filter(|_| elsewhere) else {
            return Verdict::Refuted(refutation);
        };
        let kind = match towards(&approach.goal) {
            Some(Towards::Zero) => ExprKind::Infinity,
            Some(Towards::Infinity) => ExprKind::Number(num_rational::BigRational::zero()),
            None => return Verdict::Refuted(refutation),
        };
        let replacement = Replacement {
            address: Address {
                place: approach.place,
                path: Vec::new(),
            },
            class: EditClass::Limit,
            change: Change::Whole(kind),
            cost: super::edit::cost_of(EditClass::Limit),
        };
        let mut corrected = display.clone();
        let edit = replacement.describe(&display);
        replacement.apply(&mut corrected);
        let Ok(approach) = self.approach(&corrected, link) else {
            return Verdict::Refuted(refutation);
        };
        let judged = self.judged_limit(&corrected, link, approach.as_ref());
        match (judged, edit) {
            (Ok(Found::True(conditions)), Some(edit)) if conditions.is_empty() => {
                let mut trial = self.corrected(equation, corrected.clone());
                let Verdict::Holds { proof, .. } = trial.limit_holds(equation, link) else {
                    return Verdict::Refuted(refutation);
                };
                self.adopt(trial);
                Verdict::Misprint {
                    refutation,
                    correction: Box::new(Correction {
                        edits: vec![edit],
                        display: corrected,
                        definition: None,
                        changed: vec![Changed::Right],
                        cost: super::edit::cost_of(EditClass::Limit),
                        given: None,
                        proof,
                        tried: 1,
                        budget: 1,
                        others: Vec::new(),
                        preferred: None,
                        unjudged: 0,
                        alternatives: Vec::new(),
                        rejected: Vec::new(),
                    }),
                }
            }
            _ => Verdict::Refuted(refutation),
        }
    }

    /// Lists that the coefficients of leading terms do not vanish, beside the divisors.
    fn suppose_nonzero(&mut self, conditions: Vec<Polynomial>, display: &Display, link: &Link) {
        let span = link
            .left
            .find(display)
            .map_or_else(Default::default, |e| e.span);
        let conditions = conditions.into_iter().map(|divisor| Condition {
            divisor: divisor.into(),
            origin: Origin::Divisor(span),
        });
        self.exact.conditions.extend(conditions);
    }

    /// That a limit is the printed one, with the quotient whose leading terms show it.
    fn limit_holds(&mut self, equation: usize, link: &Link) -> Verdict {
        let display = self.exact.display(equation).clone();
        let approach = self.approach(&display, link).ok().flatten();
        if let Some(approach) = &approach
            && !self.covariances_exist_on_the_way(&display, link, approach)
        {
            return Verdict::Undecided {
                reason: EXISTS_FOR_SOME.into(),
            };
        }
        let moved = approach.as_ref().and_then(|approach| {
            let printed = link.left.find(&display)?;
            let moving = match self.exact.expression_without_cases(printed) {
                Err(failure) if failure.is_without_value() => self.moved(printed, approach)?,
                Ok(_) | Err(_) => printed.clone(),
            };
            let letter = self.model.letter_of_symbol(approach.symbol, 0)?;
            match self.exact.expression_without_cases(&moving).ok()? {
                Value::Scalar(value) => Some((self.spelt_out(&value)?, letter)),
                Value::Matrix(_) | Value::Zero => None,
            }
        });
        let text = |e: Option<&Expr>| e.map_or_else(String::new, reading::expr);
        let limit = text(link.right.find(&display));
        let steps = match (moved, &approach) {
            (Some((quotient, letter)), Some(approach)) => Steps::Leading(Leading {
                quotient: (&quotient).into(),
                letter,
                towards: text(approach.place.find(&display)),
                limit,
            }),
            // An integral that is said to be infinite diverges by the rule that found it.
            _ => Steps::Leading(Leading {
                quotient: (&RationalFunction::one(self.model.ring)).into(),
                letter: 0,
                towards: "its limits of integration".into(),
                limit,
            }),
        };
        match self.verified(equation, link, steps) {
            Some(proof) => Verdict::Holds {
                by: Vec::new(),
                proof,
            },
            None => super::link::unverified(),
        }
    }

    /// The clause that says where the letter goes that a link is about; none for a lone statement.
    ///
    /// # Errors
    /// Where several letters move and what has the limit may depend on more than one of them: then they would move
    /// together, in whatever way, and not one after the other.
    fn approach(&self, display: &Display, link: &Link) -> Result<Option<Approach>, Failure> {
        let mut found: Vec<Approach> = Vec::new();
        for (clause, c) in display.clauses.iter().enumerate() {
            if let ([left, right], [Relation::Tends]) =
                (c.chain.members.as_slice(), c.chain.relations.as_slice())
                && let ExprKind::Name(letter) = &left.kind
                && let Ok(Resolved::Letter { symbol, order: 0 }) =
                    self.model.resolve(letter, &|_| false)
            {
                found.push(Approach {
                    place: Place::Member { clause, member: 1 },
                    letter: letter.clone(),
                    symbol,
                    goal: right.clone(),
                    beside: Vec::new(),
                });
            }
        }
        // A lone `x \to 0` is a statement and no condition.
        if display.clauses.len() <= found.len() {
            return Ok(None);
        }
        // What depends on a letter that moves has a limit and gives none.
        let moving: Vec<usize> = found.iter().map(|a| a.symbol).collect();
        found.retain(|approach| {
            let mut arguments = self.model.argument_symbols(approach.symbol);
            !arguments.any(|argument| moving.contains(&argument))
        });
        if found.len() < 2 {
            return Ok(found.pop());
        }
        if let Some(own) = found.iter().position(|a| a.place == link.right) {
            return Ok(Some(found.swap_remove(own)));
        }
        let moving: Vec<usize> = found.iter().map(|a| a.symbol).collect();
        let behind = |expr: &Expr| {
            let mut symbols = BTreeSet::new();
            let of = |equation: usize| self.exact.display(equation);
            self.model.visit_behind(expr, &of, &mut |e| {
                if let ExprKind::Name(name) | ExprKind::Apply { function: name, .. } = &e.kind
                    && let Ok(Resolved::Letter { symbol, .. }) =
                        self.model.resolve(name, &|_| false)
                {
                    symbols.insert(symbol);
                    symbols.extend(self.model.argument_symbols(symbol));
                }
            });
            symbols
        };
        let left = link.left.find(display);
        let span = left.map_or_else(Default::default, |left| left.span);
        let several = || Failure::unsupported("a limit in which several letters move", span);
        let goals = found
            .iter()
            .map(|a| &a.goal)
            .chain(link.right.find(display));
        for goal in goals {
            if behind(goal).iter().any(|symbol| moving.contains(symbol)) {
                return Err(several());
            }
        }
        let left = left.map(behind).unwrap_or_default();
        let mut own = (0..found.len()).filter(|k| left.contains(&found[*k].symbol));
        let one = match (own.next(), own.next()) {
            (Some(one), None) => one,
            (None, _) => 0,
            (Some(_), Some(_)) => return Err(several()),
        };
        let mut approach = found.swap_remove(one);
        approach.beside = found.iter().map(|a| a.symbol).collect();
        match approach.beside.contains(&approach.symbol) {
            true => Err(several()),
            false => Ok(Some(approach)),
        }
    }

    /// Whether the statement is true; what shows it where it is not.
    ///
    /// # Errors
    /// Where that is not known.
    fn judged_limit(
        &mut self,
        display: &Display,
        link: &Link,
        approach: Option<&Approach>,
    ) -> Result<Found, Failure> {
        let missing = || Failure::unsupported("a link without its sides", Default::default());
        let left = link.left.find(display).ok_or_else(missing)?;
        let right = link.right.find(display).ok_or_else(missing)?;
        let unsupported = |what: &str| Failure::unsupported(what, left.span);
        let goal = match infinite(right) {
            Some(Sign::Plus) => Printed::Infinite,
            Some(Sign::Minus) => Printed::MinusInfinite,
            None => match self.exact.expression_without_cases(right)? {
                Value::Zero => Printed::To(RationalFunction::zero(self.model.ring)),
                Value::Scalar(printed) => {
                    Printed::To(self.spelt_out(&printed).ok_or_else(missing)?)
                }
                Value::Matrix(_) => return Err(unsupported("a limit of a matrix")),
            },
        };
        let ways = match approach {
            Some(approach) => Some(self.ways(approach)?),
            None => None,
        };
        let ways = ways.as_ref();
        let before = self.exact.conditions.clone();
        let printed = self.judged_reading(left, &goal, approach, ways);
        let Some(approach) = approach else {
            return printed;
        };
        let Some(moving) = self.moved(left, approach) else {
            let still = !mentions(left, &approach.letter);
            return match printed {
                Err(failure)
                    if failure.is_without_value()
                        && still
                        && is_elsewhere(left, &approach.goal) =>
                {
                    Ok(Found::False(Shown::Structure(Structure::Elsewhere)))
                }
                printed => printed,
            };
        };
        if printed.as_ref().is_err_and(Failure::is_without_value) {
            self.exact.conditions = before;
        }
        let read = self.judged_reading(&moving, &goal, Some(approach), ways);
        // What has a value at its goal may be meant as this value; then both must say the same.
        match (printed, read) {
            (Err(failure), read) if failure.is_without_value() => read,
            (Ok(Found::True(mut conditions)), Ok(Found::True(more))) => {
                conditions.extend(more);
                Ok(Found::True(conditions))
            }
            (Ok(Found::False(shown)), Ok(Found::False(_))) => Ok(Found::False(shown)),
            (Err(failure), _) => Err(failure),
            (Ok(_), _) => Err(unsupported(
                "a limit whose goal is an argument, which may be meant to move,",
            )),
        }
    }

    /// Whether the statement is true of one reading of what has the limit.
    fn judged_reading(
        &mut self,
        moving: &Expr,
        goal: &Printed,
        approach: Option<&Approach>,
        ways: Option<&Vec<Way>>,
    ) -> Result<Found, Failure> {
        let missing = || Failure::unsupported("a link without its sides", Default::default());
        let unsupported = |what: &str| Failure::unsupported(what, moving.span);
        let mut found: Vec<Result<Found, Failure>> = Vec::new();
        let cases = loop {
            let value = |exact: &mut Evaluator<'_, Symbolic>| exact.expression(moving);
            let before = std::mem::take(&mut self.exact.conditions);
            let (value, cases) = self.exact.in_case(found.len(), value);
            let met = std::mem::replace(&mut self.exact.conditions, before);
            // On its way the letter leaves the range of a definition; ends that are letters are as far out as
            // the limit needs them.
            if let Some(approach) = approach
                && let Some(letter) = self.model.letter_of_symbol(approach.symbol, 0)
                && met.iter().any(|c| {
                    let behind = self.exact.field.letters_behind(&c.divisor);
                    matches!(c.origin, Origin::Range { .. }) && behind.iter().eq([&letter])
                })
            {
                return Err(unsupported("a limit outside of the range of a definition"));
            }
            for condition in met {
                if !self.exact.conditions.contains(&condition) {
                    self.exact.conditions.push(condition);
                }
            }
            found.push(match value {
                Err(
                    failure @ Failure {
                        kind: FailureKind::Divergent { .. },
                        ..
                    },
                ) => {
                    // What else moves may make up for what grows.
                    let grows = match approach {
                        None if cases <= 1 => self.comes_to(moving),
                        None | Some(_) => None,
                    };
                    let Some(Comes::ToNone(Some(towards))) = grows else {
                        return Err(failure);
                    };
                    let limit = match towards {
                        Sign::Plus => Limit::Infinite,
                        Sign::Minus => Limit::MinusInfinite,
                    };
                    Ok(match (towards, goal) {
                        (Sign::Plus, Printed::Infinite) | (Sign::Minus, Printed::MinusInfinite) => {
                            Found::True(Vec::new())
                        }
                        (
                            Sign::Plus | Sign::Minus,
                            Printed::To(_) | Printed::Infinite | Printed::MinusInfinite,
                        ) => Found::False(Shown::CounterProof(CounterProof::Limit(limit))),
                    })
                }
                Err(failure) => return Err(failure),
                Ok(Value::Matrix(_)) => return Err(unsupported("a limit of a matrix")),
                Ok(Value::Zero) => {
                    let zero = RationalFunction::zero(self.model.ring);
                    self.limit_of(&zero, goal, ways, moving)
                }
                Ok(Value::Scalar(value)) => {
                    let value = self.spelt_out(&value).ok_or_else(missing)?;
                    // A hypothesis may tie the one letter to the other.
                    let beside = approach.map_or(&[][..], |a| &a.beside);
                    let mut letters = beside
                        .iter()
                        .filter_map(|s| self.model.letter_of_symbol(*s, 0));
                    let behind = self.exact.field.letters_behind(&value);
                    if letters.any(|letter| behind.contains(&letter)) {
                        return Err(unsupported("a limit in which several letters move"));
                    }
                    self.limit_of(&value, goal, ways, moving)
                }
            });
            if found.len() >= cases {
                break cases;
            }
        };
        let (mut conditions, mut shown, mut failure) = (Vec::new(), Vec::new(), None);
        for one in found {
            match one {
                Ok(Found::True(more)) => conditions.extend(more),
                Ok(Found::False(why)) => shown.push(why),
                Err(why) => failure = failure.or(Some(why)),
            }
        }
        // Which of several cases is meant, nothing says here.
        if shown.len() == cases.max(1) {
            return Ok(Found::False(shown.swap_remove(0)));
        }
        match failure {
            Some(failure) => Err(failure),
            None if shown.is_empty() => Ok(Found::True(conditions)),
            None => Err(unsupported("a limit that differs from case to case")),
        }
    }

    /// Whether the covariances behind a limit exist near its goal: what must be positive grows, has a positive limit, or
    /// falls to zero from above.
    fn covariances_exist_on_the_way(
        &mut self,
        display: &Display,
        link: &Link,
        approach: &Approach,
    ) -> bool {
        let conditions = std::mem::take(&mut self.exact.conditions);
        let partial = self.partial_covariances();
        self.exact.conditions = conditions;
        let sides = [link.left, link.right].into_iter();
        let sides = sides.filter_map(|place| place.find(display));
        let used = self.behind(sides, &partial);
        let Some(letter) = self.model.letter_of_symbol(approach.symbol, 0) else {
            return used.is_empty();
        };
        let functions = used.iter().flat_map(|covariance| covariance.functions());
        let moving: Vec<RationalFunction> = functions
            .filter(|f| self.exact.field.letters_behind(f).contains(&letter))
            .cloned()
            .collect();
        if moving.is_empty() {
            return true;
        }
        let Ok(ways) = self.ways(approach) else {
            return false;
        };
        let (table, admissible) = (self.table(), self.admissible());
        let grows = |way: &Way, f: &RationalFunction| {
            matches!(way.behaviour(f, &table, &admissible),
                Ok(Behaviour::Tends(Limit::Infinite, conditions)) if conditions.is_empty())
        };
        let stays_positive = |way: &Way, f: &RationalFunction| {
            let limit = match way.behaviour(f, &table, &admissible) {
                Ok(Behaviour::Tends(Limit::To(limit), conditions)) if conditions.is_empty() => {
                    limit
                }
                Ok(_) | Err(_) => return grows(way, f),
            };
            match limit.is_zero() {
                true => f.inverse().is_ok_and(|f| grows(way, &f)),
                false => admissible.sign(&limit) == RegionSign::Positive,
            }
        };
        let mut all = moving.iter();
        all.all(|f| ways.iter().all(|way| stays_positive(way, f)))
    }

    /// What has the limit with its argument at the goal moving, where it may be meant so.
    fn moved(&self, printed: &Expr, approach: &Approach) -> Option<Expr> {
        let alone = approach.beside.is_empty();
        let moved = self.model.moved(printed, &approach.letter, &approach.goal);
        moved.filter(|_| alone)
    }

    /// The limit of a value on all ways to the goal, beside the printed one.
    fn limit_of(
        &mut self,
        value: &RationalFunction,
        printed: &Printed,
        ways: Option<&Vec<Way>>,
        left: &Expr,
    ) -> Result<Found, Failure> {
        let admissible = self.admissible();
        let Some(ways) = ways else {
            // Nothing moves but the variables of integrals.
            let limit = Behaviour::Tends(Limit::To(value.clone()), Vec::new());
            return match compared(&limit, printed, &admissible) {
                Some(true) => Ok(Found::True(Vec::new())),
                Some(false) if has_integral(left) => {
                    let limit = Limit::To(value.clone());
                    Ok(Found::False(Shown::CounterProof(CounterProof::Limit(
                        limit,
                    ))))
                }
                Some(false) | None => Err(Failure::unsupported(
                    "a limit without a word where a letter goes",
                    left.span,
                )),
            };
        };
        if let (Printed::To(goal), Some(way)) = (printed, ways.first())
            && super::identity::letters_of([goal]).contains(&way.letter)
        {
            return Err(Failure::unsupported(
                "a limit that depends on the letter that moves",
                left.span,
            ));
        }
        let table = self.table();
        let mut conditions = Vec::new();
        let mut failure = None;
        let mut limits: Vec<Limit> = Vec::new();
        let mut wrong = None;
        for way in ways {
            let behaviour = match way.behaviour(value, &table, &admissible) {
                Ok(behaviour) => behaviour,
                Err(why) => {
                    failure = Some(Failure::impossible(why, left.span));
                    continue;
                }
            };
            match compared(&behaviour, printed, &admissible) {
                Some(true) => {
                    if let Behaviour::Tends(_, more) = &behaviour {
                        conditions.extend(more.iter().cloned());
                    }
                }
                Some(false) => wrong = wrong.or(Some(behaviour.clone())),
                None => {
                    let what = "a limit whose sign or value depends on its letters";
                    failure = Some(Failure::unsupported(what, left.span));
                }
            }
            if let Behaviour::Tends(limit, conditions) = behaviour
                && conditions.is_empty()
                && !limits.contains(&limit)
            {
                limits.push(limit);
            }
        }
        if let Some(wrong) = wrong {
            let proof = match (wrong, limits.as_slice()) {
                (Behaviour::Two(one, other), _) => CounterProof::TwoLimits(one, other),
                (Behaviour::Tends(one, _), [first, second]) if &one == first || &one == second => {
                    CounterProof::TwoLimits(first.clone(), second.clone())
                }
                (Behaviour::Tends(limit, _), _) => CounterProof::Limit(limit),
                // Of either sign, it leaves every bound.
                (Behaviour::Unbounded(_), _) => CounterProof::Limit(Limit::Infinite),
            };
            return Ok(Found::False(Shown::CounterProof(proof)));
        }
        if let Some(failure) = failure {
            return Err(failure);
        }
        let reference = self.reference_point();
        for condition in &conditions {
            let known = condition
                .variables_occurring()
                .iter()
                .all(|l| self.has_reference(*l));
            if known && condition.evaluate(&reference).is_ok_and(|v| v.is_zero()) {
                return Err(Failure::unsupported(
                    "a limit whose leading term vanishes at the declared values",
                    left.span,
                ));
            }
        }
        Ok(Found::True(conditions))
    }

    /// The functions of the document, or none.
    pub(super) fn table(&self) -> FunctionTable {
        let model = self.model;
        let ranges = || (0..model.letters.len()).map(|l| model.range_of(l));
        match self.functions() {
            Some(table) => table.clone(),
            None => FunctionTable::new(model.ring, ranges().collect()),
        }
    }

    /// With all definitions inserted: a letter may go to its limit behind one of them.
    pub(super) fn spelt_out(&self, value: &RationalFunction) -> Option<RationalFunction> {
        let all = self.insertion(&self.inserted.keys().copied().collect::<Vec<_>>());
        match &self.model.functions {
            Some(table) => table.substitute(value, &all.letters).ok(),
            None => value.substitute(&all.letters).ok(),
        }
    }

    fn limit_residual(
        &mut self,
        flaw: &Shown,
        display: &Display,
        link: &Link,
    ) -> Vec<ResidualEntry> {
        let Shown::CounterProof(CounterProof::Limit(Limit::To(left))) = flaw else {
            return Vec::new();
        };
        let right = link
            .right
            .find(display)
            .map(|e| self.exact.expression_without_cases(e));
        match right {
            Some(Ok(Value::Scalar(right))) => vec![ResidualEntry {
                indices: Vec::new(),
                place: None,
                left: left.clone(),
                right,
            }],
            _ => Vec::new(),
        }
    }
}

/// Zero or infinity, where they are printed as such.
fn towards(expr: &Expr) -> Option<Towards> {
    match &expr.kind {
        ExprKind::Infinity => Some(Towards::Infinity),
        ExprKind::Number(n) if n.is_zero() => Some(Towards::Zero),
        _ => None,
    }
}

/// Whether zero or infinity is printed as an argument, and the goal is none.
fn is_elsewhere(expr: &Expr, goal: &Expr) -> bool {
    fn list<'e>(expr: &'e Expr, found: &mut Vec<&'e Expr>) {
        if let ExprKind::Apply { arguments, .. } = &expr.kind {
            found.extend(arguments);
        }
        if varied_name(expr).is_none() {
            for child in children(expr) {
                list(child, found);
            }
        }
    }
    let mut found = Vec::new();
    list(expr, &mut found);
    found.iter().any(|a| towards(a).is_some()) && found.iter().all(|a| *a != goal)
}

fn has_integral(expr: &Expr) -> bool {
    let itself = matches!(&expr.kind, ExprKind::Integral { .. });
    itself || children(expr).into_iter().any(has_integral)
}
