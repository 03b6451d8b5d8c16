//! The statements: sentences of the paper with a mathematical meaning, and that meaning.

use super::equation::{self, Settings};
use super::table::{Entries, Fields, Value, ValueKind, number, string};
use super::{Text, write_number};
use crate::diagnostic::{Diagnostic, DiagnosticKind};
use crate::span::Span;
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::Signed;

/// A sentence under a label, and what it says of which quantities.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Statement {
    /// A word, or a number of its own.
    pub label: Text,
    /// The sentence as printed.
    pub sentence: Text,
    /// What the document says about it; of these the recorded verdict, the reason, the note, and
    /// where a slip is likelier.
    pub settings: Settings,
    /// Whether the sentence is the document's own and none of the paper's.
    pub own: bool,
    /// Whether its propositions are different readings of it, of which it needs only one.
    pub alternatives: bool,
    /// What the sentence means; none for one that is only recalled.
    pub meaning: Option<Meaning>,
}

/// What a sentence says: a predicate of one or more quantities, with its arguments.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Meaning {
    /// The predicate.
    pub predicate: Predicate,
    /// The quantities, in LaTeX.
    pub of: Vec<Text>,
    /// The letters that it is about.
    pub letters: Vec<Text>,
    /// Groups of letters.
    pub groups: Vec<Vec<Text>>,
    /// What each quantity is compared with, in LaTeX; one for all, or one for each.
    pub to: Vec<Text>,
    /// The value of the letter, in LaTeX; the reference value where there is none.
    pub at: Option<Text>,
    /// Where the letter goes.
    pub approach: Option<Text>,
    /// Another quantity whose minimum is meant, in LaTeX.
    pub minimum_of: Option<Text>,
    /// Letters that have their reference values here.
    pub fixed: Vec<Text>,
    /// Whether the quantity is divided by its value at the reference values of the letters.
    pub normalised: bool,
    /// Whether the statement is about the box only, and not about all positive parameters.
    pub only_in_box: bool,
    /// The letters of the box, and the multiples of their reference values between which they
    /// lie; the other letters have their reference values there.
    pub around: Vec<Text>,
    /// Smallest and largest multiple of the reference values in the box.
    pub times: (BigRational, BigRational),
    /// Up to where something is called small, or close.
    pub tolerance: BigRational,
}

/// What can be said of a quantity.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Predicate {
    /// Greater than zero.
    Positive,
    /// The derivative is positive.
    IncreasingIn,
    /// The derivative is negative.
    DecreasingIn,
    /// The derivative has both signs.
    NotMonotoneIn,
    /// The second derivative is positive.
    ConvexIn,
    /// One letter has a best value between zero and infinity.
    HasAMinimumIn,
    /// The same for the largest value.
    HasAMaximumIn,
    /// The best value of a letter is this one.
    MinimalAt,
    /// The same for the largest value.
    MaximalAt,
    /// At this value of a letter the quantity is hardly more than its least.
    NearlyMinimalAt,
    /// If the letter cannot be smaller than its reference value, that is the best value.
    LeastAtTheLowerBoundOf,
    /// The letter's best value for another quantity is a bad one for this.
    WorseAtTheMinimumOf,
    /// The derivative vanishes.
    IndependentOf,
    /// Every other derivative vanishes, and these do not.
    DependsOnlyOn,
    /// A relative change of the letter shows in the quantity.
    DependsEssentiallyOn,
    /// A sum or a product of functions of one group of letters each.
    SeparatesInto,
    /// The quotient does not depend on the letters of the divisor.
    ProportionalTo,
    /// The limit in one letter.
    TendsTo,
    /// The same.
    Equals,
    /// Nearly the same at the reference point.
    CloseTo,
    /// Much smaller at the reference point.
    SmallComparedWith,
    /// The same unit.
    MeasuredLike,
    /// A rational function of the declared letters.
    Explicit,
}

impl Predicate {
    /// Every predicate, in the order of the format's page.
    pub const ALL: [Predicate; 23] = [
        Predicate::Positive,
        Predicate::IncreasingIn,
        Predicate::DecreasingIn,
        Predicate::NotMonotoneIn,
        Predicate::ConvexIn,
        Predicate::HasAMinimumIn,
        Predicate::HasAMaximumIn,
        Predicate::MinimalAt,
        Predicate::MaximalAt,
        Predicate::NearlyMinimalAt,
        Predicate::LeastAtTheLowerBoundOf,
        Predicate::WorseAtTheMinimumOf,
        Predicate::IndependentOf,
        Predicate::DependsOnlyOn,
        Predicate::DependsEssentiallyOn,
        Predicate::SeparatesInto,
        Predicate::ProportionalTo,
        Predicate::TendsTo,
        Predicate::Equals,
        Predicate::CloseTo,
        Predicate::SmallComparedWith,
        Predicate::MeasuredLike,
        Predicate::Explicit,
    ];

    /// The words of a document.
    pub fn as_str(self) -> &'static str {
        match self {
            Predicate::Positive => "positive",
            Predicate::IncreasingIn => "increasing in",
            Predicate::DecreasingIn => "decreasing in",
            Predicate::NotMonotoneIn => "not monotone in",
            Predicate::ConvexIn => "convex in",
            Predicate::HasAMinimumIn => "has a minimum in",
            Predicate::HasAMaximumIn => "has a maximum in",
            Predicate::MinimalAt => "minimal at",
            Predicate::MaximalAt => "maximal at",
            Predicate::NearlyMinimalAt => "nearly minimal at",
            Predicate::LeastAtTheLowerBoundOf => "least at the lower bound of",
            Predicate::WorseAtTheMinimumOf => "worse at the minimum of",
            Predicate::IndependentOf => "independent of",
            Predicate::DependsOnlyOn => "depends only on",
            Predicate::DependsEssentiallyOn => "depends essentially on",
            Predicate::SeparatesInto => "separates into",
            Predicate::ProportionalTo => "proportional to",
            Predicate::TendsTo => "tends to",
            Predicate::Equals => "equals",
            Predicate::CloseTo => "close to",
            Predicate::SmallComparedWith => "small compared with",
            Predicate::MeasuredLike => "measured like",
            Predicate::Explicit => "explicit",
        }
    }

    /// The arguments that it must have, and those that it may have.
    fn arguments(self) -> (&'static [&'static str], &'static [&'static str]) {
        match self {
            Predicate::Positive | Predicate::Explicit => (&[], &[]),
            Predicate::IncreasingIn | Predicate::DecreasingIn => (&["in"], &["tolerance"]),
            Predicate::NotMonotoneIn
            | Predicate::ConvexIn
            | Predicate::HasAMinimumIn
            | Predicate::HasAMaximumIn
            | Predicate::LeastAtTheLowerBoundOf => (&["in"], &[]),
            Predicate::MinimalAt | Predicate::MaximalAt | Predicate::NearlyMinimalAt => {
                (&["in"], &["at", "tolerance"])
            }
            Predicate::WorseAtTheMinimumOf => (&["in", "minimum_of"], &["tolerance"]),
            Predicate::IndependentOf | Predicate::DependsEssentiallyOn => (&["in"], &["tolerance"]),
            Predicate::DependsOnlyOn => (&["in"], &["normalised"]),
            Predicate::SeparatesInto => (&["groups"], &["tolerance"]),
            Predicate::ProportionalTo | Predicate::CloseTo | Predicate::SmallComparedWith => {
                (&["to"], &["tolerance"])
            }
            Predicate::TendsTo => (&["in", "as", "to"], &[]),
            Predicate::Equals | Predicate::MeasuredLike => (&["to"], &[]),
        }
    }
}

/// Adds a `toml LABEL` table to its statement.
pub(super) fn settings(
    entries: Entries,
    span: Span,
    statement: &mut Statement,
    report: &mut Vec<Diagnostic>,
) {
    let mut fields = Fields::new(entries, report);
    equation::judgement(&mut fields, &mut statement.settings);
    statement.own |= fields.boolean("own").unwrap_or(false);
    statement.alternatives |= fields.boolean("alternatives").unwrap_or(false);
    let predicate = fields
        .text("predicate")
        .and_then(|word| predicate(word, fields.report()));
    let given: Vec<&'static str> = [
        "of",
        "in",
        "groups",
        "to",
        "at",
        "as",
        "minimum_of",
        "fixed",
        "normalised",
        "over",
        "box",
        "times",
        "tolerance",
    ]
    .into_iter()
    .filter(|key| fields.has(key))
    .collect();
    let of = texts("of", &mut fields);
    let letters = texts("in", &mut fields);
    let groups = groups(&mut fields);
    let to = texts("to", &mut fields);
    let at = fields.text("at");
    let approach = fields.text("as");
    let minimum_of = fields.text("minimum_of");
    let fixed = texts("fixed", &mut fields);
    let normalised = fields.boolean("normalised").unwrap_or(false);
    let only_in_box = over(&mut fields);
    let around = texts("box", &mut fields);
    let times = times(&mut fields);
    let tolerance = tolerance(&mut fields);
    fields.finish();
    let Some((predicate, place)) = predicate else {
        return;
    };
    if of.is_empty() {
        report.push(missing(predicate, "of", place));
    }
    let (needed, allowed) = predicate.arguments();
    for key in needed {
        if !given.contains(key) {
            report.push(missing(predicate, key, place));
        }
    }
    for key in &given {
        let common = ["of", "over", "box", "times", "fixed"];
        if !needed.contains(key) && !allowed.contains(key) && !common.contains(key) {
            report.push(Diagnostic::new(
                DiagnosticKind::Unexpected {
                    found: format!("`{key}`"),
                    expected: format!("no such argument of `{}`", predicate.as_str()),
                },
                place,
            ));
        }
    }
    if to.len() > 1 && to.len() != of.len() {
        report.push(Diagnostic::new(
            DiagnosticKind::Unexpected {
                found: format!("{} entries of `to`", to.len()),
                expected: format!("one, or one for each of the {} quantities", of.len()),
            },
            to[0].span,
        ));
    }
    if only_in_box && around.is_empty() {
        report.push(missing(predicate, "box", span));
    }
    statement.meaning = Some(Meaning {
        predicate,
        of,
        letters,
        groups,
        to,
        at,
        approach,
        minimum_of,
        fixed,
        normalised,
        only_in_box,
        around,
        times: times.unwrap_or_else(|| (half(1), half(3))),
        tolerance: tolerance.unwrap_or_else(|| BigRational::new(1.into(), 10.into())),
    });
}

/// `n / 2`.
fn half(n: i64) -> BigRational {
    BigRational::new(BigInt::from(n), BigInt::from(2))
}

fn missing(predicate: Predicate, key: &str, span: Span) -> Diagnostic {
    Diagnostic::new(
        DiagnosticKind::Unexpected {
            found: format!("`{}` without `{key}`", predicate.as_str()),
            expected: format!("`{key} = ...` beside it"),
        },
        span,
    )
}

fn predicate(word: Text, report: &mut Vec<Diagnostic>) -> Option<(Predicate, Span)> {
    let found = Predicate::ALL.into_iter().find(|p| p.as_str() == word.text);
    if found.is_none() {
        report.push(Diagnostic::new(
            DiagnosticKind::UnknownWord {
                word: word.text,
                known: Predicate::ALL.map(|p| p.as_str().into()).into(),
            },
            word.span,
        ));
    }
    found.map(|found| (found, word.span))
}

/// A string, or an array of strings.
fn texts(key: &'static str, fields: &mut Fields<'_>) -> Vec<Text> {
    match fields.take(key) {
        None => Vec::new(),
        Some(value) => list(value, fields.report()),
    }
}

fn list(value: Value, report: &mut Vec<Diagnostic>) -> Vec<Text> {
    match value.kind {
        ValueKind::Array(items) => items
            .into_iter()
            .filter_map(|item| string(item, report))
            .collect(),
        ValueKind::String(text) => vec![text],
        _ => {
            report.push(value.expected("a string, or an array of strings"));
            Vec::new()
        }
    }
}

fn groups(fields: &mut Fields<'_>) -> Vec<Vec<Text>> {
    let Some(value) = fields.take("groups") else {
        return Vec::new();
    };
    let shape = value.expected("an array of two or more arrays of letters");
    match value.kind {
        ValueKind::Array(items) if items.len() >= 2 => items
            .into_iter()
            .map(|item| list(item, fields.report()))
            .collect(),
        _ => {
            fields.report().push(shape);
            Vec::new()
        }
    }
}

fn over(fields: &mut Fields<'_>) -> bool {
    match fields.text("over") {
        None => false,
        Some(word) => match word.text.as_str() {
            "positive" => false,
            "box" => true,
            _ => {
                fields.report().push(Diagnostic::new(
                    DiagnosticKind::UnknownWord {
                        word: word.text,
                        known: vec!["positive".into(), "box".into()],
                    },
                    word.span,
                ));
                false
            }
        },
    }
}

/// `times = ["1/2", "3/2"]`: multiples of the reference values.
fn times(fields: &mut Fields<'_>) -> Option<(BigRational, BigRational)> {
    let value = fields.take("times")?;
    let span = value.span;
    let shape = value.expected("two multiples [\"low\", \"high\"]");
    let ValueKind::Array(items) = value.kind else {
        fields.report().push(shape);
        return None;
    };
    let Ok([low, high]) = <[Value; 2]>::try_from(items) else {
        fields.report().push(shape);
        return None;
    };
    let (low, high) = (number(low, fields.report()), number(high, fields.report()));
    let (low, high) = (low?, high?);
    if !low.is_positive() || low >= high {
        fields.report().push(Diagnostic::new(
            DiagnosticKind::EmptyRange {
                low: write_number(&low),
                high: write_number(&high),
                logarithmic: true,
            },
            span,
        ));
        return None;
    }
    Some((low, high))
}

fn tolerance(fields: &mut Fields<'_>) -> Option<BigRational> {
    let (tolerance, span) = fields.number("tolerance")?;
    if tolerance.is_positive() {
        return Some(tolerance);
    }
    fields.report().push(Diagnostic::new(
        DiagnosticKind::NotPositive {
            name: "tolerance".into(),
            value: write_number(&tolerance),
        },
        span,
    ));
    None
}
