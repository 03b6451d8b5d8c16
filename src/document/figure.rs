//! Figures: `toml figure LABEL` tables that say what is drawn, never how.

use super::Text;
use super::table::{Entries, Fields, Value, ValueKind, number, range, string};
use crate::diagnostic::{Diagnostic, DiagnosticKind};
use crate::span::Span;
use num_rational::BigRational;

/// Most points of an axis that a document may ask for.
const POINTS_LIMIT: u64 = 201;

/// A figure of the paper, by what it shows.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Figure {
    /// The printed number, or a word, which the coverage does not count.
    pub label: Text,
    /// What the caption says.
    pub title: Text,
    /// What is drawn.
    pub kind: FigureKind,
    /// Free text below the caption.
    pub note: Option<Text>,
    /// The table.
    pub span: Span,
}

impl Figure {
    /// The printed number, if the label is one.
    pub fn number(&self) -> Option<u32> {
        self.label.text.parse().ok()
    }
}

/// What a figure shows.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum FigureKind {
    /// A quantity over two letters.
    Surface(Surface),
    /// A quantity against one letter, for each member of a family.
    Curves(Curves),
    /// Boxes in a row with arrows between them.
    Chain(Vec<Station>),
    /// Masses above each other with what connects them.
    Sketch(Sketch),
}

/// The words for the kinds, in the order of the format.
const KINDS: [&str; 4] = ["surface", "curves", "chain", "sketch"];

/// A quantity over two letters around their reference values, divided by its value there.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Surface {
    /// In LaTeX.
    pub quantity: Text,
    /// The letters with their ranges, as multiples of the reference values.
    pub axes: [Interval; 2],
    /// Points along each axis.
    pub points: usize,
    /// What is marked beside the reference point.
    pub optimum: Option<Extremum>,
}

/// A letter with a range.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Interval {
    /// The letter.
    pub name: Text,
    /// The lower end.
    pub low: BigRational,
    /// The upper end, greater than the lower.
    pub high: BigRational,
}

/// Which extremum of a surface is marked.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Extremum {
    /// The smallest value.
    Minimum,
    /// The largest value.
    Maximum,
}

/// A quantity against one letter.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Curves {
    /// In LaTeX.
    pub quantity: Text,
    /// The letter on the horizontal axis.
    pub axis: Interval,
    /// Points along it.
    pub points: usize,
    /// Whether the horizontal and the vertical axis are logarithmic.
    pub logarithmic: [bool; 2],
    /// Other letters whose reference values are replaced.
    pub at: Vec<(Text, BigRational)>,
    /// The letter by which the curves differ, with the name and the value of each.
    pub family: Option<Family>,
}

/// Curves that differ by the value of a letter.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Family {
    /// The letter.
    pub name: Text,
    /// A name and a value for each curve.
    pub members: Vec<(Text, BigRational)>,
}

/// A part of a chain.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Station {
    /// Whether it is a box; otherwise an arrow.
    pub is_box: bool,
    /// LaTeX beside the arrow or in the box.
    pub formula: Option<Text>,
    /// Words beside the arrow or in the box.
    pub words: Option<Text>,
}

/// A column of masses, from top to bottom.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Sketch {
    /// The masses, the links between them and the road, alternating.
    pub column: Vec<Part>,
    /// The equations of motion that the sketch is a picture of.
    pub equations: Option<Text>,
}

/// A part of a column.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Part {
    /// A mass that moves vertically.
    Mass {
        /// Its letter.
        mass: Text,
        /// Its displacement.
        coordinate: Text,
    },
    /// What connects two neighbours.
    Link {
        /// A spring.
        spring: Option<Text>,
        /// A damper.
        damper: Option<Text>,
        /// Whether it is a tyre, drawn with the wheel that it belongs to.
        tyre: bool,
    },
    /// The moving ground, with its height.
    Road {
        /// The height.
        height: Text,
    },
}

/// Decodes a figure; the label was read from the fence.
pub(super) fn figure(
    label: Text,
    entries: Entries,
    span: Span,
    report: &mut Vec<Diagnostic>,
) -> Option<Figure> {
    let before = report.len();
    let mut fields = Fields::new(entries, report);
    let title = required(&mut fields, "title", &label);
    let note = fields.words("note");
    let word = required(&mut fields, "kind", &label);
    let kind = match word.as_ref().map(|word| word.text.as_str()) {
        Some("surface") => surface(&mut fields, &label).map(FigureKind::Surface),
        Some("curves") => curves(&mut fields, &label).map(FigureKind::Curves),
        Some("chain") => chain(&mut fields, &label).map(FigureKind::Chain),
        Some("sketch") => sketch(&mut fields, &label).map(FigureKind::Sketch),
        // Without its kind nobody can tell which keys are known: one message is enough.
        None => return None,
        Some(_) => {
            unknown(word.as_ref()?, &KINDS, fields.report());
            return None;
        }
    };
    fields.finish();
    let complete = report.len() == before;
    let (title, kind) = (title?.on_one_line(), kind?);
    complete.then_some(Figure {
        label,
        title,
        kind,
        note,
        span,
    })
}

fn unknown(word: &Text, known: &[&str], report: &mut Vec<Diagnostic>) {
    report.push(Diagnostic::new(
        DiagnosticKind::UnknownWord {
            word: word.text.clone(),
            known: known.iter().map(|&k| k.into()).collect(),
        },
        word.span,
    ));
}

fn missing(key: &str, place: &Text, report: &mut Vec<Diagnostic>) {
    report.push(Diagnostic::new(
        DiagnosticKind::MissingKey { key: key.into() },
        place.span,
    ));
}

fn required(fields: &mut Fields<'_>, key: &'static str, label: &Text) -> Option<Text> {
    let text = fields.text(key);
    // A value of another type has its message already.
    if text.is_none() && !fields.was_present(key) {
        missing(key, label, fields.report());
    }
    text
}

fn points(fields: &mut Fields<'_>, usual: usize) -> usize {
    let Some(value) = fields.take("points") else {
        return usual;
    };
    let span = value.span;
    let found = number(value, fields.report());
    let natural = found
        .filter(BigRational::is_integer)
        .and_then(|n| u64::try_from(n.to_integer()).ok())
        .filter(|n| (2..=POINTS_LIMIT).contains(n));
    match natural {
        Some(n) => n as usize,
        None => {
            fields.report().push(Diagnostic::new(
                DiagnosticKind::Unexpected {
                    found: "this".into(),
                    expected: format!("a whole number from 2 to {POINTS_LIMIT}"),
                },
                span,
            ));
            usual
        }
    }
}

/// `{ c_A = ["1/2", "3/2"], ... }` with as many letters as are wanted.
fn intervals(
    fields: &mut Fields<'_>,
    key: &'static str,
    wanted: usize,
    logarithmic: bool,
    label: &Text,
) -> Option<Vec<Interval>> {
    let Some(value) = fields.take(key) else {
        missing(key, label, fields.report());
        return None;
    };
    let what = match wanted {
        1 => "one letter with its range, as in { x = [\"1\", \"2\"] }",
        _ => {
            "two letters with their ranges, as in { x = [\"1/2\", \"3/2\"], y = [\"1/2\", \"3/2\"] }"
        }
    };
    let shape = value.expected(what);
    let span = value.span;
    let ValueKind::Table(entries) = value.kind else {
        fields.report().push(shape);
        return None;
    };
    if entries.len() != wanted {
        fields.report().push(Diagnostic::new(
            DiagnosticKind::Unexpected {
                found: format!("{} of them", entries.len()),
                expected: what.into(),
            },
            span,
        ));
        return None;
    }
    let found: Vec<Interval> = entries
        .into_iter()
        .filter_map(|(name, value)| interval(name, value, logarithmic, fields.report()))
        .collect();
    (found.len() == wanted).then_some(found)
}

fn interval(
    name: Text,
    value: Value,
    logarithmic: bool,
    report: &mut Vec<Diagnostic>,
) -> Option<Interval> {
    let (low, high) = range(value, logarithmic, false, report)?;
    Some(Interval { name, low, high })
}

fn surface(fields: &mut Fields<'_>, label: &Text) -> Option<Surface> {
    let quantity = required(fields, "quantity", label);
    let points = points(fields, 41);
    let optimum = match fields.text("optimum") {
        None => None,
        Some(word) => match word.text.as_str() {
            "minimum" => Some(Extremum::Minimum),
            "maximum" => Some(Extremum::Maximum),
            _ => {
                unknown(&word, &["minimum", "maximum"], fields.report());
                None
            }
        },
    };
    // Of the reference values, so that both ends are positive.
    let axes = intervals(fields, "relative", 2, false, label)?;
    Some(Surface {
        quantity: quantity?,
        axes: axes.try_into().ok()?,
        points,
        optimum,
    })
}

fn curves(fields: &mut Fields<'_>, label: &Text) -> Option<Curves> {
    let quantity = required(fields, "quantity", label);
    let points = points(fields, 61);
    let logarithmic = match fields.text("axes") {
        None => [false, false],
        Some(word) => match word.text.as_str() {
            "linear" => [false, false],
            "log-log" => [true, true],
            "log-linear" => [true, false],
            "linear-log" => [false, true],
            _ => {
                let known = ["linear", "log-log", "log-linear", "linear-log"];
                unknown(&word, &known, fields.report());
                [false, false]
            }
        },
    };
    let at = values(fields, "at");
    let family = match fields.take("family") {
        None => None,
        Some(value) => family(value, fields.report()),
    };
    let mut axis = intervals(fields, "over", 1, logarithmic[0], label)?;
    Some(Curves {
        quantity: quantity?,
        axis: axis.pop()?,
        points,
        logarithmic,
        at,
        family,
    })
}

fn values(fields: &mut Fields<'_>, key: &'static str) -> Vec<(Text, BigRational)> {
    fields
        .table(key)
        .into_iter()
        .filter_map(|(name, value)| Some((name, number(value, fields.report())?)))
        .collect()
}

fn family(value: Value, report: &mut Vec<Diagnostic>) -> Option<Family> {
    let shape =
        value.expected("one letter with a value for each curve, as in { q = { A = \"1\" } }");
    let ValueKind::Table(entries) = value.kind else {
        report.push(shape);
        return None;
    };
    let Ok([(name, members)]) = <[(Text, Value); 1]>::try_from(entries) else {
        report.push(shape);
        return None;
    };
    let ValueKind::Table(members) = members.kind else {
        report.push(shape);
        return None;
    };
    let members: Vec<(Text, BigRational)> = members
        .into_iter()
        .filter_map(|(word, value)| Some((word, number(value, report)?)))
        .collect();
    if members.is_empty() {
        report.push(shape);
        return None;
    }
    Some(Family { name, members })
}

/// The tables of an array.
fn parts(fields: &mut Fields<'_>, key: &'static str, label: &Text) -> Option<Vec<(Entries, Span)>> {
    let Some(value) = fields.take(key) else {
        missing(key, label, fields.report());
        return None;
    };
    let shape = value.expected("an array of tables, one for each part");
    let ValueKind::Array(items) = value.kind else {
        fields.report().push(shape);
        return None;
    };
    let mut found = Vec::new();
    for item in items {
        let wrong = item.expected("a table");
        match item.kind {
            ValueKind::Table(entries) => found.push((entries, item.span)),
            _ => fields.report().push(wrong),
        }
    }
    if found.is_empty() {
        fields.report().push(shape);
        return None;
    }
    Some(found)
}

fn out_of_turn(found: &str, expected: &str, span: Span, report: &mut Vec<Diagnostic>) {
    report.push(Diagnostic::new(
        DiagnosticKind::Unexpected {
            found: found.into(),
            expected: expected.into(),
        },
        span,
    ));
}

fn chain(fields: &mut Fields<'_>, label: &Text) -> Option<Vec<Station>> {
    let mut chain: Vec<Station> = Vec::new();
    for (entries, span) in parts(fields, "chain", label)? {
        let mut part = Fields::new(entries, fields.report());
        let inside = part.text("box");
        let beside = part.text("arrow");
        let words = part.words("words");
        part.finish();
        let station = match (inside, beside) {
            (Some(formula), None) => Station {
                is_box: true,
                formula: Some(formula).filter(|f| !f.text.trim().is_empty()),
                words,
            },
            (None, Some(formula)) => Station {
                is_box: false,
                formula: Some(formula).filter(|f| !f.text.trim().is_empty()),
                words,
            },
            _ => {
                let expected = "either `box` or `arrow`";
                out_of_turn("this part", expected, span, fields.report());
                continue;
            }
        };
        if chain
            .last()
            .is_some_and(|last| last.is_box == station.is_box)
        {
            let (found, expected) = match station.is_box {
                true => ("two boxes in a row", "an arrow between them"),
                false => ("two arrows in a row", "a box between them"),
            };
            out_of_turn(found, expected, span, fields.report());
        }
        chain.push(station);
    }
    Some(chain)
}

fn sketch(fields: &mut Fields<'_>, label: &Text) -> Option<Sketch> {
    let equations = match fields.take("equations") {
        None => None,
        Some(value) => string(value, fields.report()),
    };
    let mut column: Vec<Part> = Vec::new();
    let parts = parts(fields, "column", label)?;
    let last = parts.len() - 1;
    for (at, (entries, span)) in parts.into_iter().enumerate() {
        let mut part = Fields::new(entries, fields.report());
        let mass = part.text("mass");
        let coordinate = part.text("coordinate");
        let (spring, damper) = (part.text("spring"), part.text("damper"));
        let tyre = part.boolean("tyre").unwrap_or(false);
        let height = part.text("road");
        part.finish();
        let connects = spring.is_some() || damper.is_some();
        let part = match (mass, coordinate, height) {
            (Some(mass), Some(coordinate), None) if !connects => Part::Mass { mass, coordinate },
            (None, None, None) if connects => Part::Link {
                spring,
                damper,
                tyre,
            },
            (None, None, Some(height)) if !connects => Part::Road { height },
            _ => {
                let expected = "a mass with its coordinate, a spring or damper, or a road";
                out_of_turn("this part", expected, span, fields.report());
                continue;
            }
        };
        let fits = match &part {
            Part::Mass { .. } => at.is_multiple_of(2) && at != last,
            Part::Link { .. } => !at.is_multiple_of(2) && at != last,
            Part::Road { .. } => at.is_multiple_of(2) && at == last && at > 0,
        };
        if !fits {
            let expected = "masses and links in turn, from the top, and the road at the end";
            out_of_turn("this part here", expected, span, fields.report());
        }
        column.push(part);
    }
    Some(Sketch { column, equations })
}
