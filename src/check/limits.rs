//! Claims that something tends to a limit, and integrals that are said to be infinite.
//!
//! `\Omega \to 0, \Phi(\Omega) \to \infty`: the clause about a letter says where it goes, the other
//! clauses say what becomes of something there. An argument that is printed as a number is the
//! point itself: `\Phi(0) \to \infty` speaks of the limit at zero and of no other.

use super::Checker;
use super::edit::{Address, Replacement};
use crate::evaluate::{Failure, FailureKind, Value};
use crate::expr::reading;
use crate::expr::{Display, Expr, ExprKind, Name, Relation, Sign};
use crate::functions::{FunctionTable, Impossible};
use crate::model::links::{Link, Place, children, children_mut};
use crate::model::names::Resolved;
use crate::theory::limit::{Limit, Towards, limit};
use crate::verdict::certificate::{Leading, Steps};
use crate::verdict::{
    Changed, Correction, CounterProof, EditClass, Refutation, ResidualEntry, Shown, Structure,
    Verdict,
};
use num_rational::BigRational;
use num_traits::{Signed, Zero};
use ratpoly::RationalFunction;

/// The powers of four at which a limit is looked at: on the way there, and much farther.
const NEAR: usize = 6;
const FAR: usize = 20;

/// Where a display says that a letter goes.
struct Approach {
    place: Place,
    letter: Name,
    symbol: usize,
    towards: Towards,
}

impl Checker<'_> {
    /// The verdict on `left \to right`.
    pub(super) fn tends(&mut self, equation: usize, link: &Link) -> Verdict {
        let display = self.exact.display(equation).clone();
        let approach = self.approach(&display, link);
        if approach.as_ref().is_some_and(|a| a.place == link.right) {
            return Verdict::Definition {
                what: "where the limit is taken".into(),
            };
        }
        let flaw = match self.flaw_of_limit(&display, link, approach.as_ref()) {
            Ok(None) => return self.limit_holds(equation, link),
            Ok(Some(flaw)) => flaw,
            Err(failure) => return self.failed(&failure),
        };
        let residual = self.limit_residual(&flaw, &display, link);
        let refutation = Refutation::new(flaw).with_residual(residual);
        // The other end is what is easily mistaken.
        let Some(approach) = approach else {
            return Verdict::Refuted(refutation);
        };
        let kind = match approach.towards {
            Towards::Zero => ExprKind::Infinity,
            Towards::Infinity => ExprKind::Number(num_rational::BigRational::zero()),
        };
        let replacement = Replacement {
            address: Address {
                place: approach.place,
                path: Vec::new(),
            },
            class: EditClass::Limit,
            kind,
            cost: super::edit::cost_of(EditClass::Limit),
        };
        let mut corrected = display.clone();
        let edit = replacement.describe(&display);
        replacement.apply(&mut corrected);
        let approach = self.approach(&corrected, link);
        match (
            self.flaw_of_limit(&corrected, link, approach.as_ref()),
            edit,
        ) {
            (Ok(None), Some(edit)) => {
                self.exact.correct(equation, corrected.clone());
                let Verdict::Holds { proof, .. } = self.limit_holds(equation, link) else {
                    self.exact.correct(equation, display);
                    return Verdict::Refuted(refutation);
                };
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
                        alternatives: Vec::new(),
                        rejected: Vec::new(),
                    }),
                }
            }
            _ => Verdict::Refuted(refutation),
        }
    }

    /// That a limit is the printed one, with the quotient whose leading terms show it.
    fn limit_holds(&mut self, equation: usize, link: &Link) -> Verdict {
        let display = self.exact.display(equation).clone();
        let approach = self.approach(&display, link);
        let moved = approach.as_ref().and_then(|approach| {
            let mut moving = link.left.find(&display)?.clone();
            set_moving(&mut moving, approach, &mut false);
            let letter = self.model.letter_of_symbol(approach.symbol, 0)?;
            match self.exact.expression(&moving).ok()? {
                Value::Scalar(value) => Some((self.spelt_out(&self.table(), &value)?, letter)),
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

    /// The clause that says where a letter goes; none for a lone statement.
    fn approach(&self, display: &Display, link: &Link) -> Option<Approach> {
        let mut found = Vec::new();
        for (clause, c) in display.clauses.iter().enumerate() {
            if let ([left, right], [Relation::Tends]) =
                (c.chain.members.as_slice(), c.chain.relations.as_slice())
                && let ExprKind::Name(letter) = &left.kind
                && let Ok(Resolved::Letter { symbol, order: 0 }) =
                    self.model.resolve(letter, &|_| false)
                && let Some(towards) = towards(right)
            {
                found.push(Approach {
                    place: Place::Member { clause, member: 1 },
                    letter: letter.clone(),
                    symbol,
                    towards,
                });
            }
        }
        // A lone `x \to 0` is a statement and no condition.
        let others = display.clauses.len() > found.len();
        found.truncate(1);
        found.pop().filter(|a| others || a.place != link.right)
    }

    /// What is wrong with the statement; nothing where it is true.
    fn flaw_of_limit(
        &mut self,
        display: &Display,
        link: &Link,
        approach: Option<&Approach>,
    ) -> Result<Option<Shown>, Failure> {
        let missing = || Failure::unsupported("a link without its sides", Default::default());
        let left = link.left.find(display).ok_or_else(missing)?;
        let right = link.right.find(display).ok_or_else(missing)?;
        let infinite = match &right.kind {
            ExprKind::Infinity => Some(Sign::Plus),
            ExprKind::Sum(terms) => match &terms[..] {
                [(sign, term)] if term.kind == ExprKind::Infinity => Some(*sign),
                _ => None,
            },
            _ => None,
        };
        let mut moving = left.clone();
        if let Some(approach) = approach {
            let mut elsewhere = false;
            set_moving(&mut moving, approach, &mut elsewhere);
            if elsewhere {
                return Ok(Some(Shown::Structure(Structure::Elsewhere)));
            }
        }
        let mut wrong = None;
        self.exact.cases_met = 0;
        let mut case = 0;
        loop {
            self.exact.begin_case(case);
            let value = self.exact.expression(&moving);
            let cases = self.exact.cases_met;
            if case + 1 >= cases || value.is_err() {
                (self.exact.case, self.exact.cases_met) = (0, 0);
            }
            let found = match value {
                Err(Failure {
                    kind: FailureKind::Divergent { positive: true, .. },
                    ..
                }) => Limit::Infinite,
                Err(failure) => return Err(failure),
                Ok(Value::Scalar(value)) => match approach {
                    Some(approach) => {
                        let letter = self.model.letter_of_symbol(approach.symbol, 0);
                        let letter = letter.ok_or_else(missing)?;
                        let table = self.table();
                        let value = self.spelt_out(&table, &value).ok_or_else(missing)?;
                        limit(&table, &value, letter, approach.towards)
                            .map_err(|why: Impossible| Failure::impossible(why, left.span))?
                    }
                    None => Limit::To(value),
                },
                Ok(_) => return Err(Failure::unsupported("a limit of a matrix", left.span)),
            };
            let agrees = match (&found, infinite) {
                (Limit::Infinite, Some(Sign::Plus)) | (Limit::MinusInfinite, Some(Sign::Minus)) => {
                    true
                }
                (Limit::To(found), None) => match self.exact.expression(right)? {
                    Value::Scalar(printed) => {
                        let table = self.table();
                        let printed = self.spelt_out(&table, &printed).ok_or_else(missing)?;
                        self.spelt_out(&table, found).ok_or_else(missing)? == printed
                    }
                    _ => return Err(Failure::unsupported("this limit", right.span)),
                },
                _ => false,
            };
            if !agrees && wrong.is_none() {
                wrong = Some(Shown::CounterProof(CounterProof::Limit(found)));
            }
            case += 1;
            if case >= cases {
                return Ok(wrong);
            }
        }
    }

    /// Whether a statement about a limit looks true at points on the way there, as a second opinion
    /// beside the verdict: what grows without bound grows, the integrand of an infinite integral falls
    /// no faster than the reciprocal of its variable, and what has a limit comes closer to it. None
    /// where nothing has a value at such points.
    pub(crate) fn tends_at_points(&mut self, display: &Display, link: &Link) -> Option<bool> {
        let left = link.left.find(display)?;
        let right = link.right.find(display)?;
        let infinite = right.kind == ExprKind::Infinity;
        let approach = self.approach(display, link);
        if approach.is_none() && !infinite {
            return None;
        }
        let mut case = 0;
        // What is defined by cases has to tend there in each.
        loop {
            self.exact.cases_met = 0;
            let looks = match &approach {
                None => self.integral_at_points(left, case),
                Some(approach) => self.limit_at_points([left, right], approach, infinite, case),
            };
            let cases = std::mem::take(&mut self.exact.cases_met);
            case += 1;
            match looks {
                Some(true) if case < cases => {}
                looks => return looks,
            }
        }
    }

    fn limit_at_points(
        &mut self,
        [left, right]: [&Expr; 2],
        approach: &Approach,
        infinite: bool,
        case: usize,
    ) -> Option<bool> {
        let mut moving = left.clone();
        set_moving(&mut moving, approach, &mut false);
        let mut at = |expr: &Expr, power| {
            let point = self.at_point(expr, approach.symbol, approach.towards, power, case);
            Some(point?.0)
        };
        let (near, far) = (at(&moving, NEAR)?, at(&moving, FAR)?);
        if infinite {
            return Some(near.is_positive() && far > near);
        }
        let there = at(right, FAR)?;
        let (near, far) = ((near - &there).abs(), (far - &there).abs());
        Some(far.is_zero() || far < near)
    }

    fn integral_at_points(&mut self, expr: &Expr, case: usize) -> Option<bool> {
        let (body, variable, ends) = infinite_integral(expr)?;
        let Ok(Resolved::Letter { symbol, order: 0 }) = self.model.resolve(&variable, &|_| false)
        else {
            return None;
        };
        let mut grows = |towards: Towards| {
            let (near, at) = self.at_point(&body, symbol, towards, NEAR, case)?;
            let (far, beyond) = self.at_point(&body, symbol, towards, FAR, case)?;
            Some(near.is_positive() && far * beyond >= near * at)
        };
        let found: Vec<bool> = ends.into_iter().filter_map(&mut grows).collect();
        (!found.is_empty()).then(|| found.contains(&true))
    }

    /// The value of an expression where a symbol is a power of four on its way to zero or to infinity
    /// and all others are at the reference point, with the symbol's own value; where it is irrational,
    /// the middle of an interval around it.
    fn at_point(
        &mut self,
        expr: &Expr,
        symbol: usize,
        towards: Towards,
        power: usize,
        case: usize,
    ) -> Option<(BigRational, BigRational)> {
        let letter = self.model.letter_of_symbol(symbol, 0)?;
        self.exact.begin_case(case);
        let value = self.exact.expression(expr);
        self.exact.case = 0;
        let Ok(Value::Scalar(value)) = value else {
            return None;
        };
        let table = self.table();
        let value = self.spelt_out(&table, &value)?;
        let large = num_traits::pow(BigRational::from_integer(4.into()), power);
        let at = match towards {
            Towards::Zero => large.recip(),
            Towards::Infinity => large,
        };
        let mut point: Vec<Option<BigRational>> =
            self.reference_point().into_iter().map(Some).collect();
        for (k, place) in point.iter_mut().enumerate() {
            if self.is_function(k) {
                *place = None;
            }
        }
        point[letter] = Some(at.clone());
        let value = match self.value_at(&value, &point) {
            Some(value) => value,
            None => table.enclosure(&value, &point)?.middle(),
        };
        Some((value, at))
    }

    /// The functions of the document, or none.
    fn table(&self) -> FunctionTable {
        let model = self.model;
        let ranges = || (0..model.letters.len()).map(|l| model.range_of(l));
        match &model.functions {
            Some(table) => table.clone(),
            None => FunctionTable::new(model.ring, ranges().collect()),
        }
    }

    /// With all definitions inserted: a letter may go to its limit behind one of them.
    fn spelt_out(
        &self,
        table: &FunctionTable,
        value: &RationalFunction,
    ) -> Option<RationalFunction> {
        let all = self.insertion(&self.inserted.keys().copied().collect::<Vec<_>>());
        table.substitute(value, &all.letters).ok()
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
        let right = link.right.find(display).map(|e| self.exact.expression(e));
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

/// The integrand, the variable and the ends, zero or infinity, of the first integral.
fn infinite_integral(expr: &Expr) -> Option<(Expr, Name, Vec<Towards>)> {
    if let ExprKind::Integral {
        limits: Some((from, to)),
        body,
        variable,
    } = &expr.kind
    {
        let ends = [from, to].into_iter().filter_map(|end| towards(end));
        return Some(((**body).clone(), variable.clone(), ends.collect()));
    }
    children(expr).into_iter().find_map(infinite_integral)
}

fn towards(expr: &Expr) -> Option<Towards> {
    match &expr.kind {
        ExprKind::Infinity => Some(Towards::Infinity),
        ExprKind::Number(n) if n.is_zero() => Some(Towards::Zero),
        _ => None,
    }
}

/// Puts the letter where its goal is printed as an argument; `elsewhere` where another goal is.
fn set_moving(expr: &mut Expr, approach: &Approach, elsewhere: &mut bool) {
    if let ExprKind::Apply { arguments, .. } = &mut expr.kind {
        for argument in arguments {
            if let Some(goal) = towards(argument) {
                *elsewhere |= goal != approach.towards;
                argument.kind = ExprKind::Name(approach.letter.clone());
            }
        }
    }
    for child in children_mut(expr) {
        set_moving(child, approach, elsewhere);
    }
}
