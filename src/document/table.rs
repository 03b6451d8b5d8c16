//! TOML tables with every key and value at its place in the document.
//!
//! The reader of TOML recovers from an error, so that all errors of all tables are reported at
//! once. [`Fields`] decodes one table: each known key is taken, and what is left over is unknown.

use super::Text;
use super::number::{exact_number, write_number};
use crate::diagnostic::{Diagnostic, DiagnosticKind, printable};
use crate::span::Span;
use num_rational::BigRational;
use num_traits::Signed;
use toml::de::{DeTable, DeValue};

/// A TOML value at its place.
#[derive(Clone, Debug)]
pub(super) struct Value {
    pub kind: ValueKind,
    pub span: Span,
}

#[derive(Clone, Debug)]
pub(super) enum ValueKind {
    String(Text),
    /// An integer or a float as written: TOML's doubles are never made.
    Number(String),
    Boolean(bool),
    Array(Vec<Value>),
    Table(Entries),
    Date,
}

/// The entries of a table in the order of writing.
pub(super) type Entries = Vec<(Text, Value)>;

impl Value {
    /// The name of the type, for messages.
    fn type_name(&self) -> &'static str {
        match self.kind {
            ValueKind::String(_) => "a string",
            ValueKind::Number(_) => "a number",
            ValueKind::Boolean(_) => "true or false",
            ValueKind::Array(_) => "an array",
            ValueKind::Table(_) => "a table",
            ValueKind::Date => "a date",
        }
    }

    pub(super) fn expected(&self, what: &str) -> Diagnostic {
        Diagnostic::new(
            DiagnosticKind::Unexpected {
                found: self.type_name().into(),
                expected: what.into(),
            },
            self.span,
        )
    }
}

/// Reads the TOML of a fence that begins at byte `offset` of the document.
pub(super) fn parse(body: &str, offset: usize, report: &mut Vec<Diagnostic>) -> Entries {
    let (table, errors) = DeTable::parse_recoverable(body);
    for error in errors {
        let range = error.span().unwrap_or(0..0);
        report.push(Diagnostic::new(
            DiagnosticKind::Toml {
                message: error.message().into(),
            },
            Span::new(offset + range.start, offset + range.end),
        ));
    }
    entries(body, offset, table.into_inner())
}

fn entries(body: &str, offset: usize, table: DeTable<'_>) -> Entries {
    let mut entries: Entries = table
        .into_iter()
        .map(|(key, item)| {
            let key_text = text(body, offset, key.span(), key.get_ref());
            let item_span = item.span();
            (
                key_text,
                value(
                    body,
                    offset,
                    item_span.start..item_span.end,
                    item.into_inner(),
                ),
            )
        })
        .collect();
    entries.sort_by_key(|(key, _)| key.span);
    entries
}

fn value(body: &str, offset: usize, range: std::ops::Range<usize>, value: DeValue<'_>) -> Value {
    let span = Span::new(offset + range.start, offset + range.end);
    let kind = match value {
        DeValue::String(words) => ValueKind::String(text(body, offset, range, &words)),
        DeValue::Integer(number) if number.radix() == 10 => {
            ValueKind::Number(number.as_str().into())
        }
        DeValue::Integer(number) => ValueKind::Number(number.to_string()),
        DeValue::Float(number) => ValueKind::Number(number.as_str().into()),
        DeValue::Boolean(truth) => ValueKind::Boolean(truth),
        DeValue::Datetime(_) => ValueKind::Date,
        DeValue::Array(items) => ValueKind::Array(
            items
                .into_iter()
                .map(|item| {
                    let range = item.span();
                    self::value(body, offset, range, item.into_inner())
                })
                .collect(),
        ),
        DeValue::Table(table) => ValueKind::Table(entries(body, offset, table)),
    };
    Value { kind, span }
}

/// A string or key at its place: inside the quotation marks where nothing is escaped, so that an
/// offset into the text is an offset into the document; otherwise the place of the whole.
fn text(body: &str, offset: usize, range: std::ops::Range<usize>, words: &str) -> Text {
    let raw = body.get(range.clone()).unwrap_or("");
    let quote = [1, 3]
        .into_iter()
        .find(|&n| raw.len() >= 2 * n && raw.get(n..raw.len() - n) == Some(words));
    let inset = if raw == words { 0 } else { quote.unwrap_or(0) };
    // What a string spells out with escapes is no more to be obeyed than what stands there as it is.
    Text {
        text: printable(words).into_owned(),
        span: Span::new(offset + range.start + inset, offset + range.end - inset),
    }
}

/// One table being decoded.
pub(super) struct Fields<'r> {
    rest: Entries,
    known: Vec<&'static str>,
    present: Vec<&'static str>,
    report: &'r mut Vec<Diagnostic>,
}

impl<'r> Fields<'r> {
    pub(super) fn new(entries: Entries, report: &'r mut Vec<Diagnostic>) -> Self {
        Fields {
            rest: entries,
            known: Vec::new(),
            present: Vec::new(),
            report,
        }
    }

    /// The fields of a value that must be a table.
    pub(super) fn of(value: Value, what: &str, report: &'r mut Vec<Diagnostic>) -> Self {
        match value.kind {
            ValueKind::Table(entries) => Fields::new(entries, report),
            _ => {
                report.push(value.expected(what));
                Fields::new(Vec::new(), report)
            }
        }
    }

    /// Whether an entry that nobody took has this key.
    pub(super) fn has(&self, key: &str) -> bool {
        self.rest.iter().any(|(name, _)| name.text == key)
    }

    pub(super) fn take(&mut self, key: &'static str) -> Option<Value> {
        self.known.push(key);
        let at = self.rest.iter().position(|(name, _)| name.text == key)?;
        self.present.push(key);
        Some(self.rest.remove(at).1)
    }

    /// Whether a key that was taken was there, of whatever type.
    pub(super) fn was_present(&self, key: &str) -> bool {
        self.present.contains(&key)
    }

    pub(super) fn text(&mut self, key: &'static str) -> Option<Text> {
        let value = self.take(key)?;
        string(value, self.report)
    }

    /// Words for people: on one line, however they are written.
    pub(super) fn words(&mut self, key: &'static str) -> Option<Text> {
        self.text(key).map(Text::on_one_line)
    }

    pub(super) fn boolean(&mut self, key: &'static str) -> Option<bool> {
        let value = self.take(key)?;
        match value.kind {
            ValueKind::Boolean(truth) => Some(truth),
            _ => {
                self.report.push(value.expected("true or false"));
                None
            }
        }
    }

    pub(super) fn number(&mut self, key: &'static str) -> Option<(BigRational, Span)> {
        let value = self.take(key)?;
        let span = value.span;
        number(value, self.report).map(|number| (number, span))
    }

    /// A natural number up to `limit`.
    pub(super) fn natural(&mut self, key: &'static str, limit: u64) -> Option<u64> {
        let value = self.take(key)?;
        match &value.kind {
            ValueKind::Number(digits) => match digits.parse::<u64>() {
                Ok(natural) if natural <= limit => Some(natural),
                _ => {
                    self.report.push(Diagnostic::new(
                        DiagnosticKind::Unexpected {
                            found: format!("`{digits}`"),
                            expected: format!("a whole number from 0 to {limit}"),
                        },
                        value.span,
                    ));
                    None
                }
            },
            _ => {
                self.report.push(value.expected("a whole number"));
                None
            }
        }
    }

    pub(super) fn texts(&mut self, key: &'static str) -> Vec<Text> {
        match self.take(key) {
            None => Vec::new(),
            Some(value) => match value.kind {
                ValueKind::Array(items) => items
                    .into_iter()
                    .filter_map(|item| string(item, self.report))
                    .collect(),
                _ => {
                    self.report.push(value.expected("an array of strings"));
                    Vec::new()
                }
            },
        }
    }

    pub(super) fn table(&mut self, key: &'static str) -> Entries {
        match self.take(key) {
            None => Vec::new(),
            Some(value) => match value.kind {
                ValueKind::Table(entries) => entries,
                _ => {
                    self.report.push(value.expected("a table"));
                    Vec::new()
                }
            },
        }
    }

    pub(super) fn report(&mut self) -> &mut Vec<Diagnostic> {
        self.report
    }

    /// What nobody took is unknown.
    pub(super) fn finish(self) {
        for (key, _) in self.rest {
            self.report.push(Diagnostic::new(
                DiagnosticKind::UnknownKey {
                    key: key.text,
                    known: self.known.iter().map(|&known| known.into()).collect(),
                },
                key.span,
            ));
        }
    }
}

/// The value as a string.
pub(super) fn string(value: Value, report: &mut Vec<Diagnostic>) -> Option<Text> {
    match value.kind {
        ValueKind::String(text) => Some(text),
        _ => {
            report.push(value.expected("a string"));
            None
        }
    }
}

/// The value as an exact number; a bare TOML number is read by its digits, not by its double.
pub(super) fn number(value: Value, report: &mut Vec<Diagnostic>) -> Option<BigRational> {
    let digits = match &value.kind {
        ValueKind::String(text) => &text.text,
        ValueKind::Number(digits) => digits,
        _ => {
            report.push(value.expected("a number such as \"0.35\" or \"7/20\""));
            return None;
        }
    };
    match exact_number(digits) {
        Ok(number) => Some(number),
        Err(kind) => {
            report.push(Diagnostic::new(kind, value.span));
            None
        }
    }
}

/// A range `["low", "high"]`, of positive numbers where it is logarithmic; one with equal ends is empty
/// unless it may be a point.
pub(super) fn range(
    value: Value,
    logarithmic: bool,
    may_be_a_point: bool,
    report: &mut Vec<Diagnostic>,
) -> Option<(BigRational, BigRational)> {
    let span = value.span;
    let shape = value.expected("a range [\"low\", \"high\"]");
    let ValueKind::Array(items) = value.kind else {
        report.push(shape);
        return None;
    };
    let Ok([low, high]) = <[Value; 2]>::try_from(items) else {
        report.push(shape);
        return None;
    };
    let (low, high) = (number(low, report), number(high, report));
    let (low, high) = (low?, high?);
    let empty = low > high || (low == high && !may_be_a_point);
    if empty || (logarithmic && !low.is_positive()) {
        report.push(Diagnostic::new(
            DiagnosticKind::EmptyRange {
                low: write_number(&low),
                high: write_number(&high),
                logarithmic,
            },
            span,
        ));
        return None;
    }
    Some((low, high))
}
