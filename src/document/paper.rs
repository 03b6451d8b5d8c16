//! The publication that a document belongs to, and lists of printed numbers.

use super::Text;
use super::table::{Fields, Value, ValueKind};
use crate::diagnostic::{Diagnostic, DiagnosticKind};
use std::ops::RangeInclusive;

/// Most numbered equations that a document may announce.
const NUMBERS_LIMIT: u32 = 100_000;

/// A publication that several documents may share.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Paper {
    /// What it is called; documents with the same title are of the same paper.
    pub title: Text,
    /// Its numbered equations, where the document says which it has.
    pub equation_numbers: Vec<RangeInclusive<u32>>,
    /// Its numbered figures, likewise.
    pub figure_numbers: Vec<RangeInclusive<u32>>,
}

/// `paper = "..."`, or with the numbers of all its equations.
pub(super) fn paper(value: Value, report: &mut Vec<Diagnostic>) -> Option<Paper> {
    let what = "the paper's title, or a table such as { title = \"...\", equations = \"1-68\" }";
    let (span, is_table) = (value.span, matches!(value.kind, ValueKind::Table(_)));
    if let ValueKind::String(title) = value.kind {
        return Some(Paper {
            title: title.on_one_line(),
            equation_numbers: Vec::new(),
            figure_numbers: Vec::new(),
        });
    }
    let mut fields = Fields::of(value, what, report);
    let (title, listed) = (fields.words("title"), fields.text("equations"));
    let figures = fields.text("figures");
    fields.finish();
    if title.is_none() && is_table {
        let found = "no title".into();
        let expected = what.into();
        let kind = DiagnosticKind::Unexpected { found, expected };
        report.push(Diagnostic::new(kind, span));
    }
    let equation_numbers = numbers(listed, report);
    let figure_numbers = numbers(figures, report);
    title.map(|title| Paper {
        title,
        equation_numbers,
        figure_numbers,
    })
}

/// The printed numbers that a text lists.
pub(super) fn numbers(
    listed: Option<Text>,
    report: &mut Vec<Diagnostic>,
) -> Vec<RangeInclusive<u32>> {
    let Some(listed) = listed else {
        return Vec::new();
    };
    ranges(&listed.text).unwrap_or_else(|| {
        let kind = DiagnosticKind::Unexpected {
            found: format!("`{}`", listed.text),
            expected: "numbers and ranges such as \"1-20, 23\"".into(),
        };
        report.push(Diagnostic::new(kind, listed.span));
        Vec::new()
    })
}

/// `"1-20, 23"`: increasing and without overlap.
fn ranges(text: &str) -> Option<Vec<RangeInclusive<u32>>> {
    let mut ranges: Vec<RangeInclusive<u32>> = Vec::new();
    for piece in text.split(',') {
        let (first, last) = piece.split_once('-').unwrap_or((piece, piece));
        let first: u32 = first.trim().parse().ok()?;
        let last: u32 = last.trim().parse().ok()?;
        let follows = ranges.last().is_none_or(|range| *range.end() < first);
        if !follows || first > last || last > NUMBERS_LIMIT {
            return None;
        }
        ranges.push(first..=last);
    }
    Some(ranges)
}
