//! The figures of a document, from its exact formulas: what is drawn, before it is drawn.
//!
//! A [`Figure`] holds what the reports draw and write as tables. Its numbers are rational: the values
//! at the points of a grid, the value at the reference point, the place of an optimum. Nothing here is
//! rounded; how a number or a letter looks is the business of `report::drawing`.

mod curves;
mod grid;
mod points;
mod sketch;
mod surface;
mod table;

pub use curves::{Curve, Curves};
pub use sketch::{Agreement, Sketch};
pub use surface::{Axis, Mark, MarkKind, Surface};
pub use table::{Column, Table};

use crate::check;
use crate::diagnostic::{Diagnostic, DiagnosticKind};
use crate::document::figure::{self as written, FigureKind, Station};
use crate::domain::Symbolic;
use crate::evaluate::Evaluator;
use crate::model::Model;
use crate::unit::Units;
use crate::verdict::Outcome;
use ratpoly::allowance::{self, Allowance};

/// A figure with all its numbers.
#[derive(Clone, Debug)]
pub struct Figure {
    /// The printed number, or a word.
    pub label: String,
    /// What the caption says.
    pub title: String,
    /// Free text below it.
    pub note: Option<String>,
    /// What is drawn; where that is not known, why.
    pub content: Result<Content, String>,
}

/// What a figure draws.
#[derive(Clone, Debug)]
pub enum Content {
    /// A quantity over two letters.
    Surface(Box<Surface>),
    /// A quantity against one letter.
    Curves(Box<Curves>),
    /// Boxes in a row with arrows between them.
    Chain(Vec<Station>),
    /// Masses above each other with what connects them.
    Sketch(Sketch),
}

impl Figure {
    /// The printed number, if the label is one.
    pub fn number(&self) -> Option<u32> {
        self.label.parse().ok()
    }

    /// Whether the figure says something else than the equations that it is a picture of.
    pub fn contradicts(&self) -> bool {
        match &self.content {
            Ok(Content::Sketch(sketch)) => {
                matches!(sketch.equations, Some((_, Agreement::Differs(_))))
            }
            _ => false,
        }
    }

    /// The numbers that are drawn, where the figure has any.
    pub fn table(&self) -> Option<Table> {
        match &self.content {
            Ok(Content::Surface(surface)) => Some(surface.table()),
            Ok(Content::Curves(curves)) => Some(curves.table()),
            _ => None,
        }
    }
}

/// What a figure may cost, and what the search for an optimum in it: without one it is still drawn.
const LARGEST: Allowance = Allowance {
    steps: 300_000_000,
    bytes: 32 << 20,
};
const OPTIMUM: Allowance = Allowance {
    steps: 100_000_000,
    ..LARGEST
};

/// What figures are made from: the model, its equations as corrected, the units of its names.
pub(crate) struct Source<'m> {
    pub model: &'m Model,
    pub exact: Evaluator<'m, Symbolic>,
    pub units: Units,
}

/// Why there is no figure.
#[derive(Debug)]
pub(crate) enum Obstacle {
    /// The document is wrong.
    Wrong(Diagnostic),
    /// It lies outside of what can be drawn.
    Beyond(String),
}

impl From<Diagnostic> for Obstacle {
    fn from(diagnostic: Diagnostic) -> Self {
        match diagnostic.kind {
            // A pole is met by the numbers, and costs this figure and nothing else.
            DiagnosticKind::DivisionByZero => {
                Obstacle::Beyond("its quantity has no value at a point of the grid".into())
            }
            _ => Obstacle::Wrong(diagnostic),
        }
    }
}

/// The figures of a document with these verdicts and the units of its names, in its order.
///
/// # Errors
/// Everything that is wrong with their tables.
pub fn figures(
    model: &Model,
    outcomes: &[Outcome],
    units: Units,
) -> Result<Vec<Figure>, Vec<Diagnostic>> {
    if model.document.figures.is_empty() {
        return Ok(Vec::new());
    }
    let mut source = Source {
        model,
        exact: check::corrected(model, outcomes),
        units,
    };
    let mut figures = Vec::new();
    let mut report = Vec::new();
    for written in &model.document.figures {
        let drawn = allowance::within(LARGEST, || content(&mut source, written));
        let drawn = drawn.unwrap_or_else(|exhausted| {
            source.exact = check::corrected(model, outcomes);
            Err(Obstacle::Beyond(check::bounded::words(exhausted).into()))
        });
        let content = match drawn {
            Ok(content) => Ok(content),
            Err(Obstacle::Beyond(why)) => Err(why),
            Err(Obstacle::Wrong(diagnostic)) => {
                report.push(diagnostic);
                continue;
            }
        };
        figures.push(Figure {
            label: written.label.text.clone(),
            title: written.title.text.clone(),
            note: written.note.as_ref().map(|n| n.text.clone()),
            content,
        });
    }
    if report.is_empty() {
        Ok(figures)
    } else {
        report.sort_by_key(|d| d.span);
        Err(report)
    }
}

fn content(source: &mut Source<'_>, figure: &written::Figure) -> Result<Content, Obstacle> {
    Ok(match &figure.kind {
        FigureKind::Surface(s) => Content::Surface(Box::new(surface::surface(source, s)?)),
        FigureKind::Curves(c) => Content::Curves(Box::new(curves::curves(source, c)?)),
        FigureKind::Chain(chain) => {
            for station in chain {
                if let Some(formula) = &station.formula {
                    points::readable(formula)?;
                }
            }
            Content::Chain(chain.clone())
        }
        FigureKind::Sketch(sketch) => Content::Sketch(sketch::sketch(source, sketch)?),
    })
}
