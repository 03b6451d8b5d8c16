//! A quantity over two letters around the reference point, with its optimum.

use super::points::{Quantity, reference, symbol};
use super::{Column, OPTIMUM, Obstacle, Source, Table, grid};
use crate::diagnostic::{Diagnostic, DiagnosticKind};
use crate::document::figure::{Extremum, Surface as Written};
use crate::latex;
use crate::model::Letter;
use crate::theory::extremum::{self, Place, Unknown};
use num_rational::BigRational;
use num_traits::{One, Signed};
use ratpoly::{RationalFunction, allowance};

/// One of the two letters.
#[derive(Clone, Debug)]
pub struct Axis {
    /// The letter in LaTeX.
    pub name: String,
    /// Its SI unit.
    pub unit: Option<String>,
    /// Its meaning.
    pub meaning: String,
    /// Its reference value.
    pub reference: BigRational,
    /// The points of the grid, as multiples of the reference value.
    pub grid: Vec<BigRational>,
}

impl Axis {
    /// The range, as multiples of the reference value.
    pub fn range(&self) -> (&BigRational, &BigRational) {
        (&self.grid[0], &self.grid[self.grid.len() - 1])
    }
}

/// What a mark shows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MarkKind {
    /// The optimum in the drawn rectangle.
    Optimum(Extremum),
    /// The optimum along one axis (0 or 1) through the reference point, over all positive values.
    Section(usize, Extremum),
}

/// A place that is marked beside the reference point; its coordinates are multiples of the reference
/// values, its value is divided by the one at the reference point.
#[derive(Clone, Debug)]
pub struct Mark {
    /// What it shows.
    pub kind: MarkKind,
    /// Where it is: both coordinates for an optimum, the one along its axis for a section.
    pub place: Result<Place, Unknown>,
}

/// A quantity over two letters, divided by its value at the reference point.
#[derive(Clone, Debug)]
pub struct Surface {
    /// The quantity in LaTeX.
    pub quantity: String,
    /// Its SI unit.
    pub unit: Option<String>,
    /// Its value at the reference point, which is not zero.
    pub reference: BigRational,
    /// The two letters.
    pub axes: [Axis; 2],
    /// The values divided by that at the reference point: for each point of the second axis those
    /// along the first.
    pub values: Vec<Vec<BigRational>>,
    /// What is marked beside the reference point.
    pub marks: Vec<Mark>,
}

impl Surface {
    /// All points with their values, in multiples of the reference and as they are.
    pub fn table(&self) -> Table {
        let [x, y] = &self.axes;
        let mut columns: Vec<Column> = Vec::new();
        let each = |pick: &dyn Fn(usize, usize) -> BigRational| {
            let rows = 0..y.grid.len();
            rows.flat_map(|j| (0..x.grid.len()).map(move |i| (i, j)))
                .map(|(i, j)| pick(i, j))
                .collect::<Vec<BigRational>>()
        };
        let mut push = |name: String, unit: Option<String>, values| {
            columns.push(Column { name, unit, values });
        };
        let one = || Some("1".to_string());
        let relative = |name: &str| format!("{name} / reference");
        push(
            x.name.clone(),
            x.unit.clone(),
            each(&|i, _| &x.grid[i] * &x.reference),
        );
        push(
            y.name.clone(),
            y.unit.clone(),
            each(&|_, j| &y.grid[j] * &y.reference),
        );
        push(
            self.quantity.clone(),
            self.unit.clone(),
            each(&|i, j| &self.values[j][i] * &self.reference),
        );
        push(relative(&x.name), one(), each(&|i, _| x.grid[i].clone()));
        push(relative(&y.name), one(), each(&|_, j| y.grid[j].clone()));
        push(
            relative(&self.quantity),
            one(),
            each(&|i, j| self.values[j][i].clone()),
        );
        Table { columns }
    }
}

/// Evaluates a surface.
pub(super) fn surface(source: &mut Source<'_>, written: &Written) -> Result<Surface, Obstacle> {
    let model = source.model;
    let quantity = Quantity::of(source, &written.quantity, &[])?;
    let unit = quantity.unit(source);
    let Some(f) = quantity.symbolic.clone() else {
        let why = "the quantity is not a rational function of the letters";
        return Err(Obstacle::Beyond(why.into()));
    };
    let mut symbols = [0; 2];
    let mut references = Vec::new();
    for (found, interval) in symbols.iter_mut().zip(&written.axes) {
        *found = symbol(model, &interval.name)?;
        let value = reference(model, *found, interval.name.span)?;
        if !value.is_positive() {
            return Err(Diagnostic::new(
                DiagnosticKind::NotPositive {
                    name: interval.name.text.clone(),
                    value: crate::document::write_number(&value),
                },
                interval.name.span,
            )
            .into());
        }
        references.push(value);
    }
    if symbols[0] == symbols[1] {
        let name = written.axes[1].name.text.clone();
        let kind = DiagnosticKind::DuplicateName { name };
        return Err(Diagnostic::new(kind, written.axes[1].name.span).into());
    }
    let values: Vec<Option<BigRational>> = model.symbols.iter().map(|s| s.value.clone()).collect();
    if let Some(name) = quantity.lacking(&f, &values) {
        return Err(
            Diagnostic::new(DiagnosticKind::NoValue { name }, written.quantity.span).into(),
        );
    }
    let normal = quantity.at(source, &values)?;
    if normal == BigRational::default() {
        return Err(Diagnostic::new(DiagnosticKind::DivisionByZero, written.quantity.span).into());
    }
    // The two letters as multiples of their reference values, the others at theirs.
    let images: Vec<(usize, RationalFunction)> = model
        .letters
        .iter()
        .enumerate()
        .filter_map(|(letter, kind)| match kind {
            Letter::Symbol { symbol, order: 0 } => {
                let value = RationalFunction::constant(model.ring, values[*symbol].clone()?);
                let image = match symbols.contains(symbol) {
                    true => value * RationalFunction::variable(model.ring, letter),
                    false => value,
                };
                Some((letter, image))
            }
            _ => None,
        })
        .collect();
    let beyond = |_| Obstacle::Beyond("the function is too large to draw".into());
    let inverse = RationalFunction::constant(model.ring, normal.recip());
    let f = f.substitute(&images).map_err(beyond)?;
    let f = f.try_mul(&inverse).map_err(beyond)?;
    let letters = symbols.map(|s| model.letter_of_symbol(s, 0).unwrap_or_default());
    let grids = written
        .axes
        .each_ref()
        .map(|axis| grid::linear(&axis.low, &axis.high, written.points));
    let mut point = vec![BigRational::one(); model.letters.len()];
    let mut there = values.clone();
    let mut rows = Vec::new();
    for v in &grids[1] {
        point[letters[1]] = v.clone();
        there[symbols[1]] = Some(v * &references[1]);
        let mut row = Vec::new();
        for u in &grids[0] {
            point[letters[0]] = u.clone();
            there[symbols[0]] = Some(u * &references[0]);
            quantity.refuse_hole(&there)?;
            let value = f.evaluate(&point);
            let kind = DiagnosticKind::DivisionByZero;
            row.push(value.map_err(|_| Diagnostic::new(kind, written.quantity.span))?);
        }
        rows.push(row);
    }
    let marks = written
        .optimum
        .map_or_else(Vec::new, |extremum| marks(&f, letters, written, extremum));
    let mut grids = grids.into_iter();
    let mut references = references.into_iter();
    let axes = symbols.map(|s| {
        let symbol = &model.symbols[s];
        Axis {
            name: latex::canonical(&symbol.name),
            unit: symbol.unit.clone(),
            meaning: symbol.meaning.clone(),
            reference: references.next().unwrap_or_default(),
            grid: grids.next().unwrap_or_default(),
        }
    });
    Ok(Surface {
        quantity: written.quantity.text.clone(),
        unit,
        reference: normal,
        axes,
        values: rows,
        marks,
    })
}

/// The optimum in the rectangle, and those along the axes through the reference point.
fn marks(
    f: &RationalFunction,
    letters: [usize; 2],
    written: &Written,
    kind: Extremum,
) -> Vec<Mark> {
    let f = match kind {
        Extremum::Minimum => f.clone(),
        Extremum::Maximum => -f,
    };
    let turned = |search: &dyn Fn() -> Result<Place, Unknown>| {
        let place = allowance::within(OPTIMUM, search).unwrap_or(Err(Unknown::Limit));
        place.map(|mut place| {
            if kind == Extremum::Maximum {
                place.value = (-place.value.1, -place.value.0);
            }
            place
        })
    };
    let ranges = written.axes.each_ref().map(|axis| (&axis.low, &axis.high));
    let mut marks = vec![Mark {
        kind: MarkKind::Optimum(kind),
        place: turned(&|| extremum::on_rectangle(&f, letters, ranges)),
    }];
    for axis in 0..2 {
        let one = RationalFunction::one(f.ring());
        let Ok(section) = f.substitute(&[(letters[1 - axis], one)]) else {
            continue;
        };
        marks.push(Mark {
            kind: MarkKind::Section(axis, kind),
            place: turned(&|| extremum::on_half_line(&section, letters[axis])),
        });
    }
    marks
}
