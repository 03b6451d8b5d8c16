//! What is wrong with a document, where, and what to do: kind + span + data.
//!
//! The stages make [`Diagnostic`] values and never prose; the words and the source excerpt are
//! made here and only here. All of a document's diagnostics are reported at once.

mod printable;
mod render;
#[cfg(test)]
mod tests;
mod words;

pub use printable::{printable, printable_line};
pub use render::render;

use crate::span::Span;
use std::collections::BTreeSet;

/// One thing that is wrong with a document.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Diagnostic {
    /// What is wrong.
    pub kind: DiagnosticKind,
    /// Where.
    pub span: Span,
    /// A second place that belongs to it, such as the first definition of a name defined twice.
    pub related: Option<Span>,
}

impl Diagnostic {
    /// A diagnostic at a place.
    pub fn new(kind: DiagnosticKind, span: Span) -> Self {
        Diagnostic {
            kind,
            span,
            related: None,
        }
    }
}

/// A text that cannot be checked: all that is wrong with it, and the text to quote from.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Rejection {
    /// The file's name.
    pub name: String,
    /// The text that the diagnostics point into.
    pub text: String,
    /// What is wrong, by place.
    pub diagnostics: Vec<Diagnostic>,
}

/// What can be wrong with a document. Tests match on these, not on words.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum DiagnosticKind {
    /// The parser met something it cannot read here.
    Unexpected {
        /// What was found.
        found: String,
        /// What would have fitted.
        expected: String,
    },
    /// A brace or bracket without its partner.
    Unbalanced {
        /// The lone delimiter.
        delimiter: String,
    },
    /// Brackets nested deeper than the limit.
    TooDeep {
        /// The limit.
        limit: usize,
    },
    /// More letters than are computed with.
    TooManyLetters {
        /// How many.
        count: usize,
        /// The limit.
        limit: usize,
    },
    /// A LaTeX command outside the fragment.
    UnknownCommand {
        /// The command.
        command: String,
    },
    /// Two readings are possible and the document does not say which is meant.
    Ambiguous {
        /// The readings.
        readings: Vec<String>,
    },
    /// A letter that no table and no equation declares.
    UndeclaredName {
        /// The letter as printed.
        name: String,
    },
    /// A dot in a document that has no time.
    NoTime {
        /// What stands under it.
        name: String,
    },
    /// A name declared or defined twice.
    DuplicateName {
        /// The name.
        name: String,
    },
    /// Definitions that need each other.
    CyclicDefinition {
        /// The names around the circle.
        cycle: Vec<String>,
    },
    /// Two shapes that do not fit.
    ShapeMismatch {
        /// What was being done.
        operation: String,
        /// Shape of the left operand.
        left: String,
        /// Shape of the right operand.
        right: String,
    },
    /// A divisor that is zero identically.
    DivisionByZero,
    /// An exponent beyond the limit, or one that is no integer.
    Exponent {
        /// The exponent as printed.
        exponent: String,
        /// The largest that is allowed.
        limit: u32,
    },
    /// A number that cannot be read.
    BadNumber {
        /// As written.
        text: String,
    },
    /// A number with more digits than are read.
    LongNumber {
        /// How many it has.
        digits: usize,
        /// The limit.
        limit: usize,
    },
    /// A name that a claim begins with and nothing declares or defines.
    Undefined {
        /// The name as printed.
        name: String,
    },
    /// Alternatives, of which one is true, where every equation must hold.
    Alternatives,
    /// A clause that says nothing, such as a number alone.
    SaysNothing {
        /// The clause as printed.
        clause: String,
    },
    /// A line that looks like the beginning of a fence and is none.
    NoFence {
        /// The line.
        line: String,
        /// How it should begin.
        expected: String,
    },
    /// A document, or a display in it, that is longer than is read.
    TooLong {
        /// What.
        what: &'static str,
        /// Its size in bytes.
        size: usize,
        /// The limit, in bytes or in letters and signs.
        limit: usize,
    },
    /// An equation number, or a table of which there is one, used twice.
    DuplicateLabel {
        /// The number.
        label: String,
    },
    /// A fence without a number or word after `math` or `toml`, or with one that cannot be a label.
    BadLabel {
        /// What stands there; empty when nothing does.
        found: String,
    },
    /// A statement without a predicate, and without a reason why it has none.
    MissingMeaning {
        /// The label of the statement.
        label: String,
    },
    /// A settings table for an equation that the document does not have.
    UnknownLabel {
        /// The label.
        label: String,
        /// The tables that are no settings.
        tables: Vec<String>,
    },
    /// A fence whose role is none of those the format knows.
    UnknownRole {
        /// The role; empty when there is none.
        role: String,
    },
    /// A key that the format does not know.
    UnknownKey {
        /// The key.
        key: String,
        /// The keys that could stand here.
        known: Vec<String>,
    },
    /// A letter without a reference value where one is needed.
    NoValue {
        /// The letter.
        name: String,
    },
    /// A label that no equation has.
    UnknownEquation {
        /// The label.
        label: String,
    },
    /// A table without a key that it needs.
    MissingKey {
        /// The key.
        key: String,
    },
    /// A word that the format does not know.
    UnknownWord {
        /// The word.
        word: String,
        /// The words that could stand here.
        known: Vec<String>,
    },
    /// An equation that is recalled without saying why there is nothing to check.
    MissingReason {
        /// The equation's label.
        label: String,
    },
    /// A letter declared positive with a value that is not.
    NotPositive {
        /// The letter.
        name: String,
        /// The value.
        value: String,
    },
    /// A unit that cannot be read.
    BadUnit {
        /// As written.
        unit: String,
        /// What is wrong with it.
        message: String,
    },
    /// A value in a unit such as `kN` or `h`, which formulas of numbers cannot take.
    IncoherentUnit {
        /// As written.
        unit: String,
        /// The same in SI base units.
        coherent: String,
    },
    /// A range from which nothing can be drawn.
    EmptyRange {
        /// Its lower end.
        low: String,
        /// Its upper end.
        high: String,
        /// Whether it is drawn from by its logarithm, so that it must be positive.
        logarithmic: bool,
    },
    /// A document without a single fence.
    EmptyDocument,
    /// The file is not UTF-8 text.
    NotUtf8,
    /// The file cannot be read at all, in the words of the operating system.
    Unreadable {
        /// The words.
        message: String,
    },
    /// A TOML table that cannot be read, in the words of its reader.
    Toml {
        /// The words.
        message: String,
    },
}

/// One diagnostic for each cause: a name or command that occurs again is the same fault.
/// `unread` are the names that what cannot be read might have given a meaning.
pub(crate) fn one_for_each_cause(
    report: Vec<Diagnostic>,
    text: &str,
    unread: BTreeSet<String>,
) -> Vec<Diagnostic> {
    let mut known = unread;
    for diagnostic in &report {
        if let DiagnosticKind::Undefined { name } = &diagnostic.kind {
            known.insert(name.clone());
        }
    }
    let mut seen = BTreeSet::new();
    let first = |diagnostic: &Diagnostic| match &diagnostic.kind {
        DiagnosticKind::UndeclaredName { name } => {
            !known.contains(name) && seen.insert((0, name.clone()))
        }
        DiagnosticKind::Undefined { name } => seen.insert((1, name.clone())),
        DiagnosticKind::UnknownCommand { command } => seen.insert((2, command.clone())),
        DiagnosticKind::Ambiguous { readings } => {
            let printed = text.get(diagnostic.span.start..diagnostic.span.end);
            let cause = format!("{}\n{}", printed.unwrap_or_default(), readings.join("\n"));
            seen.insert((3, cause))
        }
        _ => true,
    };
    report.into_iter().filter(first).collect()
}
