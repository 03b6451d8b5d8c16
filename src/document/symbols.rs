//! What the letters are: the `toml symbols` and `toml notation` tables.

use super::Text;
use super::number::write_number;
use super::size::Size;
use super::table::{Entries, Fields, Value, ValueKind, string};
use crate::diagnostic::{Diagnostic, DiagnosticKind};
use crate::functions::Constant;
use crate::model::range::Numbers;
use crate::unit::Unit;
use num_rational::BigRational;
use num_traits::Signed;

/// A letter with what the document says about it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Symbol {
    /// The name as printed, in LaTeX.
    pub name: Text,
    /// Its SI unit.
    pub unit: Option<Text>,
    /// Whether it is greater than zero.
    pub positive: bool,
    /// Which numbers it stands for.
    pub domain: Numbers,
    /// Between which numbers it lies, as a chain in LaTeX such as `0 < a < 2`.
    pub range: Option<Text>,
    /// Its value in the reference case.
    pub value: Option<BigRational>,
    /// What it stands for.
    pub meaning: Option<Text>,
    /// The letter that it is a function of and that dots differentiate by: the last of a list.
    pub function_of: Option<Text>,
    /// All letters that it is a function of.
    pub arguments: Vec<Text>,
    /// Its rows and columns, where it is a matrix of letters.
    pub shape: Option<MatrixShape>,
}

/// A matrix of letters.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct MatrixShape {
    /// The number of rows.
    pub rows: Size,
    /// The number of columns; 1 for a vector.
    pub columns: Size,
    /// Which entries share a letter.
    pub structure: Structure,
    /// Whether x^T M x > 0 for every x other than zero.
    pub positive_definite: bool,
}

/// Which entries of a matrix of letters share a letter.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Structure {
    /// None.
    General,
    /// Entry (i, j) is entry (j, i).
    Symmetric,
    /// Entry (i, j) is minus entry (j, i).
    Skew,
}

/// A name that has its meaning by a convention the paper leaves to the reader.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Notation {
    /// The name as printed, in LaTeX; an index stands for every value of that index.
    pub name: Text,
    /// The convention.
    pub kind: NotationKind,
    /// In words.
    pub meaning: Option<Text>,
}

/// The conventions that a document can name.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum NotationKind {
    /// The unit matrix of this order.
    Identity(Size),
    /// Zero of whatever shape fits.
    Zero,
    /// `a_i`: the coefficient of lambda^(n-i) in det(lambda E - A); a_0 = 1, and 0 beyond n.
    CharacteristicCoefficientOf(Text),
    /// `H_{i,j}`: the signed minor without row i and column j.
    CofactorOf(Text),
    /// `H_i`: the determinant of the first i rows and columns.
    LeadingMinorOf(Text),
    /// `P_{i,j}`: row i, column j.
    EntryOf(Text),
    /// Another spelling of the same thing.
    Means(Text),
    /// The Hurwitz matrix of the characteristic coefficients of a matrix: entry (i, j) is a_{2i-j}.
    HurwitzMatrixOf(Text),
    /// The covariance of a zero-mean random vector, or of two.
    CovarianceOf(Text, Option<Text>),
    /// The number of rows of a matrix or vector.
    RowsOf(Text),
    /// The circle's constant, the base of the natural logarithm, or the imaginary unit.
    Constant(Constant),
    /// The Dirac distribution.
    Dirac,
}

/// Decodes a table of symbols.
pub(super) fn symbols(entries: Entries, report: &mut Vec<Diagnostic>) -> Vec<Symbol> {
    entries
        .into_iter()
        .map(|(name, value)| symbol(name, value, report))
        .collect()
}

fn symbol(name: Text, value: Value, report: &mut Vec<Diagnostic>) -> Symbol {
    let mut fields = Fields::of(value, "a table such as { unit = \"kg\" }", report);
    let unit = fields.text("unit");
    let positive = fields.boolean("positive").unwrap_or(false);
    let domain = domain(&mut fields);
    let range = fields.text("range");
    let number = fields.number("value");
    let meaning = fields.words("meaning");
    let arguments = fields.take("function_of");
    let arguments =
        arguments.map_or_else(Vec::new, |value| self::arguments(value, fields.report()));
    let shape = shape(&mut fields, &name);
    if let (Some(_), Some((_, span))) = (&shape, &number) {
        fields.report().push(Diagnostic::new(
            DiagnosticKind::Unexpected {
                found: "a value of a matrix".into(),
                expected: "letters only: numbers are given to matrices by equations".into(),
            },
            *span,
        ));
    }
    if let Some((number, span)) = &number
        && positive
        && !number.is_positive()
    {
        fields.report().push(Diagnostic::new(
            DiagnosticKind::NotPositive {
                name: name.text.clone(),
                value: write_number(number),
            },
            *span,
        ));
    }
    if let Some(unit) = &unit {
        let kind = match Unit::parse(&unit.text) {
            Err(message) => Some(DiagnosticKind::BadUnit {
                unit: unit.text.clone(),
                message,
            }),
            // Formulas add numbers, not quantities: a value in kN would be wrong by a thousand.
            Ok(parsed) if !parsed.coherent && number.is_some() => {
                Some(DiagnosticKind::IncoherentUnit {
                    unit: unit.text.clone(),
                    coherent: parsed.dimension.to_string(),
                })
            }
            Ok(_) => None,
        };
        let diagnostic = kind.map(|kind| Diagnostic::new(kind, unit.span));
        fields.report().extend(diagnostic);
    }
    fields.finish();
    Symbol {
        name,
        unit,
        positive,
        domain,
        range,
        value: number.map(|(number, _)| number),
        meaning,
        function_of: arguments.last().cloned(),
        arguments,
        shape,
    }
}

/// `domain`: real unless told.
fn domain(fields: &mut Fields) -> Numbers {
    let Some(text) = fields.text("domain") else {
        return Numbers::Real;
    };
    match text.text.as_str() {
        "real" => Numbers::Real,
        "complex" => Numbers::Complex,
        "integer" => Numbers::Integer,
        _ => {
            fields.report().push(Diagnostic::new(
                DiagnosticKind::Unexpected {
                    found: format!("domain = \"{}\"", text.text),
                    expected: "real, complex or integer".into(),
                },
                text.span,
            ));
            Numbers::Real
        }
    }
}

/// `function_of`: a letter or several.
fn arguments(value: Value, report: &mut Vec<Diagnostic>) -> Vec<Text> {
    match value.kind {
        ValueKind::Array(items) => items
            .into_iter()
            .filter_map(|item| string(item, report))
            .collect(),
        _ => string(value, report).into_iter().collect(),
    }
}

/// The keys of a matrix of letters.
fn shape(fields: &mut Fields, name: &Text) -> Option<MatrixShape> {
    let sizes = fields.take("shape");
    let symmetric = fields.boolean("symmetric").unwrap_or(false);
    let skew = fields.boolean("skew").unwrap_or(false);
    let positive_definite = fields.boolean("positive_definite").unwrap_or(false);
    let report = fields.report();
    let mut refuse = |found: &str, expected: &str| {
        report.push(Diagnostic::new(
            DiagnosticKind::Unexpected {
                found: found.into(),
                expected: expected.into(),
            },
            name.span,
        ));
    };
    let Some(sizes) = sizes else {
        if symmetric || skew || positive_definite {
            refuse(
                "a property of matrices without a shape",
                "shape = [rows, columns]",
            );
        }
        return None;
    };
    match (symmetric, skew, positive_definite) {
        (true, true, _) => refuse("symmetric and skew", "one of them: only zero is both"),
        (false, _, true) => refuse(
            "positive_definite without symmetric",
            "symmetric = true beside it",
        ),
        _ => {}
    }
    let pair = match &sizes.kind {
        ValueKind::Array(items) if items.len() == 2 => items
            .iter()
            .map(|item| Size::decode(item, fields.report()))
            .collect::<Option<Vec<Size>>>()?,
        _ => {
            let what = "rows and columns such as [\"f\", 1]";
            fields.report().push(sizes.expected(what));
            return None;
        }
    };
    let [rows, columns] = <[Size; 2]>::try_from(pair).ok()?;
    if (symmetric || skew) && rows != columns {
        fields.report().push(Diagnostic::new(
            DiagnosticKind::Unexpected {
                found: format!("a symmetric or skew matrix of shape {rows}x{columns}"),
                expected: "as many rows as columns".into(),
            },
            sizes.span,
        ));
    }
    let structure = match (symmetric, skew) {
        (true, _) => Structure::Symmetric,
        (_, true) => Structure::Skew,
        _ => Structure::General,
    };
    Some(MatrixShape {
        rows,
        columns,
        structure,
        positive_definite,
    })
}

/// Decodes a table of notation.
pub(super) fn notation(entries: Entries, report: &mut Vec<Diagnostic>) -> Vec<Notation> {
    entries
        .into_iter()
        .filter_map(|(name, value)| convention(name, value, report))
        .collect()
}

/// The conventions by their keys.
const KINDS: [&str; 12] = [
    "identity",
    "zero",
    "characteristic_coefficient_of",
    "cofactor_of",
    "leading_minor_of",
    "entry_of",
    "means",
    "hurwitz_matrix_of",
    "covariance_of",
    "rows_of",
    "constant",
    "dirac",
];

/// The constants by their words.
const CONSTANTS: [(&str, Constant); 3] = [
    ("pi", Constant::Pi),
    ("e", Constant::Euler),
    ("i", Constant::ImaginaryUnit),
];

fn convention(name: Text, value: Value, report: &mut Vec<Diagnostic>) -> Option<Notation> {
    let mut fields = Fields::of(value, "a table such as { identity = 4 }", report);
    let mut kinds = Vec::new();
    for key in KINDS {
        if let Some(value) = fields.take(key) {
            let span = value.span;
            kinds.push((span, kind(key, value, fields.report())));
        }
    }
    let meaning = fields.words("meaning");
    if kinds.len() != 1 {
        let span = kinds.get(1).map_or(name.span, |(span, _)| *span);
        let diagnostic = Diagnostic::new(
            DiagnosticKind::Unexpected {
                found: match kinds.len() {
                    0 => format!("`{}` without a convention", name.text),
                    _ => format!("`{}` with more than one convention", name.text),
                },
                expected: format!("exactly one of {}", KINDS.join(", ")),
            },
            span,
        );
        fields.report().push(diagnostic);
    }
    fields.finish();
    let kind = kinds.into_iter().next()?.1?;
    Some(Notation {
        name,
        kind,
        meaning,
    })
}

fn kind(key: &str, value: Value, report: &mut Vec<Diagnostic>) -> Option<NotationKind> {
    match key {
        "identity" => Size::decode(&value, report).map(NotationKind::Identity),
        "zero" | "dirac" => match value.kind {
            ValueKind::Boolean(true) => Some(if key == "zero" {
                NotationKind::Zero
            } else {
                NotationKind::Dirac
            }),
            _ => {
                report.push(value.expected("true"));
                None
            }
        },
        "covariance_of" => covariance(value, report),
        "constant" => {
            let found = match &value.kind {
                ValueKind::String(word) => CONSTANTS.iter().find(|(w, _)| *w == word.text),
                _ => None,
            };
            if found.is_none() {
                report.push(value.expected("\"pi\", \"e\" or \"i\""));
            }
            found.map(|(_, constant)| NotationKind::Constant(*constant))
        }
        _ => {
            let of = string(value, report)?;
            Some(match key {
                "characteristic_coefficient_of" => NotationKind::CharacteristicCoefficientOf(of),
                "cofactor_of" => NotationKind::CofactorOf(of),
                "leading_minor_of" => NotationKind::LeadingMinorOf(of),
                "entry_of" => NotationKind::EntryOf(of),
                "means" => NotationKind::Means(of),
                "rows_of" => NotationKind::RowsOf(of),
                _ => NotationKind::HurwitzMatrixOf(of),
            })
        }
    }
}

/// One random vector, or two between which the covariance is meant.
fn covariance(value: Value, report: &mut Vec<Diagnostic>) -> Option<NotationKind> {
    let ValueKind::Array(items) = value.kind else {
        return Some(NotationKind::CovarianceOf(string(value, report)?, None));
    };
    let span = value.span;
    let Ok([left, right]) = <[Value; 2]>::try_from(items) else {
        report.push(Diagnostic::new(
            DiagnosticKind::Unexpected {
                found: "this list".into(),
                expected: "one random vector, or a list of two".into(),
            },
            span,
        ));
        return None;
    };
    let (left, right) = (string(left, report), string(right, report));
    Some(NotationKind::CovarianceOf(left?, Some(right?)))
}
