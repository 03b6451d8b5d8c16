//! Definitions by cases and ranges of definitions.
//!
//! A condition that is true for all admitted values picks its case, one that is false for all leaves it out. Where
//! several cases are left, the evaluation is done once for each combination of choices, each time supposing the
//! conditions of what was chosen, so that a second look at the same condition chooses the same. A path of
//! choices is a number in mixed radix: the first choice is its lowest digit.
//!
//! A condition that is linear in the variable of an integral holds between the ends if it holds at both. One that
//! holds at one end only is refused: there one case after the other would have to be integrated over its own part.

use super::{Evaluator, Failure, FailureKind, Value};
use crate::domain::Domain;
use crate::expr::{Chain, Expr, Name, Relation, Sign};
use crate::functions::integral::End;
use crate::functions::{Sign as KnownSign, Supposed};
use crate::latex;
use crate::model::{Definition, Letter};
use crate::span::Span;

/// The most combinations of cases that are looked at.
const MOST_CASES: usize = 64;

/// Which case of the definitions by cases that are met is looked at.
#[derive(Debug)]
pub(super) struct Choice<E> {
    /// The number of the combination of cases, from 0.
    pub case: usize,
    /// How many combinations the definitions met so far have; 0 where none was met.
    pub met: usize,
    /// The product of the choices so far.
    radix: usize,
    /// What the cases chosen so far suppose; of no meaning where no case was met.
    supposed: Vec<Supposed<E>>,
}

impl<E> Default for Choice<E> {
    fn default() -> Self {
        Choice::of(0)
    }
}

impl<E> Choice<E> {
    fn of(case: usize) -> Self {
        Choice {
            case,
            met: 0,
            radix: 1,
            supposed: Vec::new(),
        }
    }
}

impl<E> Choice<E> {
    /// What the cases chosen so far suppose.
    pub(super) fn known(&self) -> &[Supposed<E>] {
        match self.met {
            0 => &[],
            _ => &self.supposed,
        }
    }
}

type Result<T> = std::result::Result<T, Failure>;

/// What becomes of a condition.
enum Standing<E> {
    /// True for all admitted values.
    True,
    /// False for all of them.
    False,
    /// True where this is so.
    Open(Vec<Supposed<E>>),
    /// True all the way between the ends of an integral where this is so.
    Between(Vec<Supposed<E>>),
}

/// What is not computed where a function has no value because its argument is none of its own.
pub(super) const OUTSIDE_OF_RANGE: &str = "an argument outside of the range of its definition";

impl<D: Domain> Evaluator<'_, D> {
    /// The result of `body` in one combination of cases, numbered from 0, and how many the definitions by
    /// cases that it met have; 0 where it met none.
    pub(crate) fn in_case<T>(
        &mut self,
        case: usize,
        body: impl FnOnce(&mut Self) -> T,
    ) -> (T, usize) {
        let outer = std::mem::replace(&mut self.choice, Choice::of(case));
        let result = body(self);
        let met = std::mem::replace(&mut self.choice, outer).met;
        (result, met)
    }

    /// What the case that is looked at supposes.
    pub(crate) fn supposed_here(&self) -> &[Supposed<D::Element>] {
        &self.choice.supposed
    }

    /// The value of an expression that has the same one in all cases.
    ///
    /// # Errors
    /// As [`Evaluator::expression`], and where the value is another one from case to case.
    pub(crate) fn expression_without_cases(&mut self, expr: &Expr) -> Result<Value<D::Element>> {
        let (value, cases) = self.in_case(0, |e| e.expression(expr));
        match cases {
            0 | 1 => value,
            _ => value.and(Err(Failure::unsupported(
                "what is defined by cases",
                expr.span,
            ))),
        }
    }

    /// The results of `body` in each case of the definitions by cases that it meets, with the number of
    /// the case from 0; one without a number where it meets none.
    ///
    /// # Errors
    /// The first of `body`.
    pub fn in_each_case<T, E>(
        &mut self,
        mut body: impl FnMut(&mut Self) -> std::result::Result<T, E>,
    ) -> std::result::Result<Vec<(Option<usize>, T)>, E> {
        let mut results = Vec::new();
        let mut most = 0;
        loop {
            let case = results.len();
            let (result, met) = self.in_case(case, &mut body);
            // Some paths have more choices than others; their prefixes come first.
            most = most.max(met);
            results.push(((most > 1).then_some(case), result?));
            if results.len() >= most {
                return Ok(results);
            }
        }
    }

    /// A value with its functions evaluated anew under what the case supposes.
    pub(crate) fn in_this_case(&self, value: Value<D::Element>) -> Value<D::Element> {
        let Some(functions) = self.field.functions() else {
            return value;
        };
        if self.choice.met == 0 || self.choice.supposed.is_empty() {
            return value;
        }
        let anew = |element: &D::Element| -> std::result::Result<D::Element, Failure> {
            let value = functions.value_where(element, &self.choice.supposed);
            Ok(value.unwrap_or_else(|_| element.clone()))
        };
        value.try_map(anew).unwrap_or(value)
    }

    /// The value in the case that is looked at, among those that the conditions do not exclude.
    pub(super) fn by_cases(
        &mut self,
        cases: &[(Expr, Vec<Chain>)],
        span: Span,
    ) -> Result<Value<D::Element>> {
        if self.choice.met == 0 {
            self.choice = Choice::of(self.choice.case);
        }
        let mut admitted = Vec::new();
        let mut between = false;
        // That none of the cases so far applies, as far as it can be supposed.
        let mut otherwise = Vec::new();
        for (value, conditions) in cases {
            match self.standing(conditions)? {
                Standing::False => {}
                Standing::True if admitted.is_empty() => return self.expression(value),
                Standing::True => {
                    let supposed = match conditions.is_empty() {
                        true => std::mem::take(&mut otherwise),
                        false => Vec::new(),
                    };
                    admitted.push((value, supposed));
                    break;
                }
                Standing::Open(supposed) => {
                    otherwise.extend(self.opposite(conditions, &supposed));
                    admitted.push((value, supposed));
                }
                Standing::Between(supposed) => {
                    between = true;
                    admitted.push((value, supposed));
                }
            }
        }
        self.leave_gap(&admitted, span);
        let choices = admitted.len();
        if between && choices > 1 {
            return Err(Failure::unsupported(
                "a definition by cases under an integral",
                span,
            ));
        }
        let choice = match self.field.functions() {
            _ if choices == 0 => {
                return Err(Failure::unsupported(
                    "an argument outside of every case",
                    span,
                ));
            }
            // Without signs no condition is recognised a second time: one choice for all.
            None => {
                self.choice.met = self.choice.met.max(choices);
                self.choice.case.min(choices - 1)
            }
            Some(_) => {
                let choice = self.choice.case / self.choice.radix % choices;
                let radix = self.choice.radix.saturating_mul(choices);
                if radix > MOST_CASES {
                    return Err(Failure::new(
                        FailureKind::Budget {
                            what: "combinations of cases".into(),
                        },
                        span,
                    ));
                }
                self.choice.radix = radix;
                self.choice.met = self.choice.met.max(radix);
                choice
            }
        };
        let (value, supposed) = admitted.swap_remove(choice);
        self.choice.supposed.extend(supposed);
        self.expression(value)
    }

    /// What is so where conditions do not hold, if it is one relation: those that are open are one.
    fn opposite(
        &self,
        conditions: &[Chain],
        supposed: &[Supposed<D::Element>],
    ) -> Option<Supposed<D::Element>> {
        let all_supposed = conditions
            .iter()
            .flat_map(|c| &c.relations)
            .all(|r| match r {
                Relation::Less
                | Relation::LessEqual
                | Relation::Greater
                | Relation::GreaterEqual => true,
                Relation::Equal
                | Relation::NotEqual
                | Relation::Distributed
                | Relation::Approximately
                | Relation::Tends => false,
            });
        match supposed {
            [one] if all_supposed => Some(Supposed {
                element: self.field.negate(&one.element),
                strict: !one.strict,
            }),
            _ => None,
        }
    }

    /// What lies between two cases that exclude each other, where neither has the point between them,
    /// has no value.
    fn leave_gap(&mut self, admitted: &[(&Expr, Vec<Supposed<D::Element>>)], span: Span) {
        let [(_, one), (_, other)] = admitted else {
            return;
        };
        let ([one], [other]) = (&one[..], &other[..]) else {
            return;
        };
        let sum = self.field.add(&one.element, &other.element);
        if one.strict && other.strict && self.field.is_zero(&sum) {
            self.conditions.push(super::Condition {
                divisor: one.element.clone(),
                origin: super::Origin::Divisor(span),
            });
        }
    }

    /// Supposes that the letters of a function lie in the range that stands beside its definition.
    pub(super) fn suppose_range(&mut self, range: &[Chain], span: Span) -> Result<()> {
        if range.is_empty() {
            return Ok(());
        }
        if self.choice.met == 0 {
            self.choice = Choice::of(self.choice.case);
        }
        // Ends that are letters are as far out as an integral needs them.
        let by_letters = !self.frame.open_integrals.is_empty()
            && range.iter().flat_map(|chain| &chain.members).any(|member| {
                let value = self.expression(member);
                let letters = |v: Value<D::Element>| {
                    let entries = v.entries().into_iter();
                    let mut all = entries.flat_map(|e| self.field.letters(e));
                    all.any(|letter| matches!(self.model.letters[letter], Letter::Symbol { .. }))
                };
                value.is_ok_and(letters)
            });
        if self.field.functions().is_none() {
            self.leave_range_open(range, span);
        }
        self.leave_out(range, span)?;
        match self.standing(range) {
            Ok(Standing::False) | Err(_) if by_letters => Ok(()),
            Err(failure) => Err(failure),
            Ok(Standing::True) => Ok(()),
            Ok(Standing::False) => Err(Failure::unsupported(OUTSIDE_OF_RANGE, span)),
            Ok(Standing::Open(supposed) | Standing::Between(supposed)) => {
                let functions = self.field.functions();
                let depends = |e: &D::Element| functions.is_some_and(|f| f.depends_on_bound(e));
                let meant = supposed.iter().filter(|s| !depends(&s.element));
                self.conditions.extend(meant.map(|s| super::Condition {
                    divisor: s.element.clone(),
                    origin: super::Origin::Range {
                        span,
                        strict: s.strict,
                    },
                }));
                self.choice.met = self.choice.met.max(self.choice.radix);
                self.choice.supposed.extend(supposed);
                Ok(())
            }
        }
    }

    /// Leaves it as conditions that the letters of a function are none of the numbers that are left out of its range.
    fn leave_out(&mut self, range: &[Chain], span: Span) -> Result<()> {
        for chain in range {
            for (pair, relation) in chain.members.windows(2).zip(&chain.relations) {
                if *relation != Relation::NotEqual {
                    continue;
                }
                let (left, right) = (self.expression(&pair[0])?, self.expression(&pair[1])?);
                let difference = super::value::subtract(&self.field, &left, &right, span)?;
                let Value::Scalar(divisor) = difference else {
                    return Err(Failure::unsupported("a condition on matrices", span));
                };
                if self.field.is_zero(&divisor) {
                    return Err(Failure::unsupported(OUTSIDE_OF_RANGE, span));
                }
                let functions = self.field.functions();
                if functions.is_some_and(|f| f.depends_on_bound(&divisor)) {
                    // One point less changes no integral.
                    continue;
                }
                if !self.field.letters(&divisor).is_empty() {
                    self.conditions.push(super::Condition {
                        divisor,
                        origin: super::Origin::Divisor(span),
                    });
                }
            }
        }
        Ok(())
    }

    /// Leaves it as conditions that the letters of a function lie in a range, over a field that knows no signs.
    fn leave_range_open(&mut self, range: &[Chain], span: Span) {
        for chain in range {
            for (pair, relation) in chain.members.windows(2).zip(&chain.relations) {
                let (lower, upper) = match relation {
                    Relation::Less | Relation::LessEqual => (&pair[0], &pair[1]),
                    Relation::Greater | Relation::GreaterEqual => (&pair[1], &pair[0]),
                    Relation::Equal
                    | Relation::NotEqual
                    | Relation::Distributed
                    | Relation::Approximately
                    | Relation::Tends => continue,
                };
                if lower.as_infinity().is_some() || upper.as_infinity().is_some() {
                    continue;
                }
                let (Ok(Value::Scalar(lower)), Ok(Value::Scalar(upper))) =
                    (self.expression(lower), self.expression(upper))
                else {
                    continue;
                };
                let divisor = self.field.subtract(&upper, &lower);
                if !self.field.letters(&divisor).is_empty() {
                    self.conditions.push(super::Condition {
                        divisor,
                        origin: super::Origin::Range {
                            span,
                            strict: matches!(relation, Relation::Less | Relation::Greater),
                        },
                    });
                }
            }
        }
    }

    /// The chains beside a definition that say between what its letters lie.
    pub(super) fn range_of(&self, definition: &Definition, parameters: &[Name]) -> Vec<Chain> {
        let display = self.display(definition.equation);
        let order = |relation: &Relation| relation.limits();
        let is_letter = |e: &Expr| {
            e.as_name().is_some_and(|name| {
                let name = latex::canonical(name);
                parameters.iter().any(|p| latex::canonical(p) == name)
            })
        };
        display
            .clauses
            .iter()
            .map(|clause| &clause.chain)
            .filter(|chain| chain.members.iter().any(is_letter))
            .filter(|chain| !chain.relations.is_empty() && chain.relations.iter().all(order))
            .cloned()
            .collect()
    }

    /// Whether conditions hold together.
    fn standing(&mut self, conditions: &[Chain]) -> Result<Standing<D::Element>> {
        if self.field.functions().is_none() {
            return Ok(Standing::Open(Vec::new()));
        }
        let mut open = Vec::new();
        let (mut undecided, mut between) = (false, false);
        for condition in conditions {
            let pairs = condition.members.windows(2).zip(&condition.relations);
            for (pair, relation) in pairs {
                let [left, right] = pair else { continue };
                match self.standing_of(left, *relation, right)? {
                    Standing::True => {}
                    Standing::False => return Ok(Standing::False),
                    Standing::Open(supposed) => {
                        undecided = true;
                        open.extend(supposed);
                    }
                    Standing::Between(supposed) => {
                        between = true;
                        open.extend(supposed);
                    }
                }
            }
        }
        Ok(match (between, undecided) {
            (true, _) => Standing::Between(open),
            (false, true) => Standing::Open(open),
            (false, false) => Standing::True,
        })
    }

    fn standing_of(
        &mut self,
        left: &Expr,
        relation: Relation,
        right: &Expr,
    ) -> Result<Standing<D::Element>> {
        let (left, relation, right) = match relation {
            Relation::Greater => (right, Relation::Less, left),
            Relation::GreaterEqual => (right, Relation::LessEqual, left),
            Relation::Less
            | Relation::LessEqual
            | Relation::Equal
            | Relation::NotEqual
            | Relation::Distributed
            | Relation::Approximately
            | Relation::Tends => (left, relation, right),
        };
        match (left.as_infinity(), right.as_infinity()) {
            (None, None) => {}
            (Some(Sign::Minus), None) | (_, Some(Sign::Plus)) => return Ok(Standing::True),
            (Some(Sign::Plus), _) | (_, Some(Sign::Minus)) => return Ok(Standing::False),
        }
        let span = left.span.to(right.span);
        let unsupported = |what: &str| Err(Failure::unsupported(what, span));
        let zero = || self.field.integer(0);
        let zeros = [zero(), zero()];
        let [lower_zero, upper_zero] = zeros;
        let (Some(lower), Some(upper)) = (
            self.expression(left)?.into_scalar(lower_zero),
            self.expression(right)?.into_scalar(upper_zero),
        ) else {
            return unsupported("a condition on matrices");
        };
        let difference = self.field.subtract(&upper, &lower);
        let Some(functions) = self.field.functions() else {
            return Ok(Standing::Open(Vec::new()));
        };
        let known: Vec<_> = self
            .choice
            .supposed
            .iter()
            .chain(&self.frame.between)
            .cloned()
            .collect();
        let sign = functions.sign_where(&difference, &known);
        let standing = match (relation, sign) {
            (Relation::Less, Some(KnownSign::Positive)) => Some(true),
            (Relation::Less, Some(sign)) if sign.is_not_positive() => Some(false),
            (Relation::LessEqual, Some(sign)) if sign.is_not_negative() => Some(true),
            (Relation::LessEqual, Some(KnownSign::Negative)) => Some(false),
            (Relation::Equal, Some(KnownSign::Zero)) => Some(true),
            (Relation::NotEqual, Some(KnownSign::Zero)) => Some(false),
            (Relation::Equal, Some(KnownSign::Positive | KnownSign::Negative)) => Some(false),
            (Relation::NotEqual, Some(KnownSign::Positive | KnownSign::Negative)) => Some(true),
            _ => None,
        };
        match standing {
            Some(true) => return Ok(Standing::True),
            Some(false) => return Ok(Standing::False),
            None => {}
        }
        if functions.depends_on_bound(&difference) {
            return match relation {
                Relation::Less | Relation::LessEqual => self.standing_between(&difference, span),
                Relation::Equal
                | Relation::NotEqual
                | Relation::Greater
                | Relation::GreaterEqual
                | Relation::Distributed
                | Relation::Approximately
                | Relation::Tends => unsupported("a definition by cases under an integral"),
            };
        }
        match relation {
            Relation::Less | Relation::LessEqual => Ok(Standing::Open(vec![Supposed {
                element: difference,
                strict: relation == Relation::Less,
            }])),
            Relation::NotEqual => Ok(Standing::Open(Vec::new())),
            Relation::Equal => unsupported("a case on one value of a letter"),
            Relation::Greater
            | Relation::GreaterEqual
            | Relation::Distributed
            | Relation::Approximately
            | Relation::Tends => unsupported("such a condition of a case"),
        }
    }

    /// Whether something that depends on the variable of an integral is not negative between its ends; at
    /// single points it may be.
    fn standing_between(
        &self,
        difference: &D::Element,
        span: Span,
    ) -> Result<Standing<D::Element>> {
        let refused = || Failure::unsupported("a definition by cases under an integral", span);
        let functions = self.field.functions().ok_or_else(refused)?;
        let occurring = self.field.letters(difference);
        let mut variables = self.frame.open_integrals.iter().filter_map(|open| {
            match self.field.letters(&open.0)[..] {
                [letter] if occurring.contains(&letter) => Some((letter, open)),
                _ => None,
            }
        });
        let (Some((letter, (variable, from, to))), None) = (variables.next(), variables.next())
        else {
            return Err(refused());
        };
        let partials = self
            .field
            .partial_derivatives(difference)
            .unwrap_or_default();
        let mut own = partials.into_iter().filter(|(l, _)| *l == letter);
        let slope = own.next().map(|(_, slope)| slope).ok_or_else(refused)?;
        if functions.depends_on_bound(&slope) {
            return Err(refused());
        }
        let mut open = Vec::new();
        let mut ends = Vec::new();
        for end in [from, to] {
            let sign = match end {
                End::At(end) => {
                    let step = self.field.subtract(end, variable);
                    let step = self.field.multiply(&slope, &step);
                    let there = self.field.add(difference, &step);
                    if functions.depends_on_bound(&there) {
                        return Err(refused());
                    }
                    let sign = functions.sign_where(&there, &self.choice.supposed);
                    if !sign.is_some_and(|s| s.is_not_negative() || s == KnownSign::Negative) {
                        open.push(Supposed {
                            element: there,
                            strict: false,
                        });
                    }
                    sign
                }
                End::Above => functions.sign_where(&slope, &self.choice.supposed),
                End::Below => functions
                    .sign_where(&slope, &self.choice.supposed)
                    .map(KnownSign::reversed),
            };
            ends.push(match sign {
                Some(sign) if sign.is_not_negative() => Some(true),
                Some(KnownSign::Negative) => Some(false),
                Some(_) | None => match end {
                    End::At(_) => None,
                    End::Above | End::Below => return Err(refused()),
                },
            });
        }
        match ends[..] {
            [Some(true), Some(true)] => Ok(Standing::True),
            [Some(false), Some(false)] => Ok(Standing::False),
            [Some(true) | None, Some(true) | None] => Ok(Standing::Between(open)),
            _ => Err(refused()),
        }
    }
}
