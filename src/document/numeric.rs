//! Where the floating-point comparison looks: the `toml numeric` table.

use super::Text;
use super::table::{Entries, Fields, Value, ValueKind, number, range};
use crate::diagnostic::{Diagnostic, DiagnosticKind};
use crate::span::Span;
use num_rational::BigRational;

/// Most random samples that a document may ask for.
const SAMPLES_LIMIT: u64 = 100_000;

/// What the floating-point comparison computes, and where.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Numeric {
    /// The seed of the random samples.
    pub seed: u64,
    /// How many random samples.
    pub samples: usize,
    /// How a sample is drawn from a range.
    pub scale: Scale,
    /// The ranges of the letters; a letter without one keeps its value.
    pub ranges: Vec<SampleRange>,
    /// Named points.
    pub points: Vec<Point>,
    /// What is computed at each of them, in LaTeX.
    pub quantities: Vec<Text>,
    /// The named points at which the methods are compared.
    pub methods: Vec<Text>,
    /// The weights of the output whose variance they compute, in LaTeX.
    pub output: Option<Text>,
    /// Where the table stands.
    pub span: Span,
}

/// How a sample is drawn from a range.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Scale {
    /// Every decade of the range is as likely as its size in decades.
    #[default]
    Logarithmic,
    /// Every part of the range is as likely as its length.
    Linear,
}

/// `m_A = ["200", "5000"]`: the closed range from which a letter is drawn.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SampleRange {
    /// The letter as printed.
    pub name: Text,
    /// Its smallest value.
    pub low: BigRational,
    /// Its largest value.
    pub high: BigRational,
    /// Where the range stands.
    pub span: Span,
}

/// A named point: the reference values with some of them replaced.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Point {
    /// The name of the point.
    pub name: Text,
    /// The letters with other values, in the order of writing.
    pub values: Vec<(Text, BigRational)>,
}

/// Decodes a numeric table.
pub(super) fn numeric(entries: Entries, span: Span, report: &mut Vec<Diagnostic>) -> Numeric {
    let mut fields = Fields::new(entries, report);
    let seed = fields.natural("seed", i64::MAX as u64).unwrap_or(0);
    let samples = fields.natural("samples", SAMPLES_LIMIT).unwrap_or(0) as usize;
    let scale = match fields.text("scale") {
        None => Scale::default(),
        Some(word) => match word.text.as_str() {
            "logarithmic" => Scale::Logarithmic,
            "linear" => Scale::Linear,
            _ => {
                fields.report().push(Diagnostic::new(
                    DiagnosticKind::UnknownWord {
                        word: word.text,
                        known: vec!["logarithmic".into(), "linear".into()],
                    },
                    word.span,
                ));
                Scale::default()
            }
        },
    };
    let ranges = fields
        .table("box")
        .into_iter()
        .filter_map(|(name, value)| sample_range(name, value, scale, fields.report()))
        .collect();
    let points: Vec<Point> = fields
        .table("points")
        .into_iter()
        .map(|(name, value)| point(name, value, fields.report()))
        .collect();
    let quantities = fields.texts("quantities");
    let methods = fields.texts("methods");
    let output = fields.text("output");
    for unknown in methods.iter().filter(|m| {
        let known = |p: &Point| p.name.text == m.text;
        !points.iter().any(known)
    }) {
        fields.report().push(Diagnostic::new(
            DiagnosticKind::UnknownWord {
                word: unknown.text.clone(),
                known: points.iter().map(|p: &Point| p.name.text.clone()).collect(),
            },
            unknown.span,
        ));
    }
    fields.finish();
    Numeric {
        seed,
        samples,
        scale,
        ranges,
        points,
        quantities,
        methods,
        output,
        span,
    }
}

fn sample_range(
    name: Text,
    value: Value,
    scale: Scale,
    report: &mut Vec<Diagnostic>,
) -> Option<SampleRange> {
    let span = value.span;
    let (low, high) = range(value, scale == Scale::Logarithmic, true, report)?;
    Some(SampleRange {
        name,
        low,
        high,
        span,
    })
}

fn point(name: Text, value: Value, report: &mut Vec<Diagnostic>) -> Point {
    let values = match value.kind {
        ValueKind::Table(entries) => entries
            .into_iter()
            .filter_map(|(letter, value)| Some((letter, number(value, report)?)))
            .collect(),
        _ => {
            report.push(value.expected("a table of values such as { d_A = \"1e-6\" }"));
            Vec::new()
        }
    };
    Point { name, values }
}
