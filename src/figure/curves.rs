//! A quantity against one letter, for each member of a family.

use super::points::{Quantity, symbol};
use super::{Column, Obstacle, Source, Table, grid};
use crate::diagnostic::{Diagnostic, DiagnosticKind};
use crate::document::figure::Curves as Written;
use crate::latex;
use num_rational::BigRational;
use num_traits::Signed;

/// One curve.
#[derive(Clone, Debug)]
pub struct Curve {
    /// Its name; none where there is only one.
    pub name: Option<String>,
    /// The value of the family's letter.
    pub parameter: Option<BigRational>,
    /// The values at the points of the grid.
    pub values: Vec<BigRational>,
}

/// A quantity against one letter.
#[derive(Clone, Debug)]
pub struct Curves {
    /// The quantity in LaTeX.
    pub quantity: String,
    /// Its SI unit.
    pub unit: Option<String>,
    /// The letter on the horizontal axis in LaTeX.
    pub letter: String,
    /// Its SI unit.
    pub letter_unit: Option<String>,
    /// Whether the horizontal and the vertical axis are logarithmic.
    pub logarithmic: [bool; 2],
    /// The points.
    pub grid: Vec<BigRational>,
    /// The letter by which the curves differ, in LaTeX, with its unit.
    pub family: Option<(String, Option<String>)>,
    /// Other letters, in LaTeX, with their values and units.
    pub at: Vec<(String, BigRational, Option<String>)>,
    /// The curves.
    pub curves: Vec<Curve>,
}

impl Curves {
    /// The points and a column for each curve.
    pub fn table(&self) -> Table {
        let mut columns = vec![Column {
            name: self.letter.clone(),
            unit: self.letter_unit.clone(),
            values: self.grid.clone(),
        }];
        for curve in &self.curves {
            columns.push(Column {
                name: match &curve.name {
                    Some(name) => format!("{} ({name})", self.quantity),
                    None => self.quantity.clone(),
                },
                unit: self.unit.clone(),
                values: curve.values.clone(),
            });
        }
        Table { columns }
    }
}

/// Evaluates the curves.
pub(super) fn curves(source: &mut Source<'_>, written: &Written) -> Result<Curves, Obstacle> {
    let model = source.model;
    let letter = symbol(model, &written.axis.name)?;
    let mut values: Vec<Option<BigRational>> =
        model.symbols.iter().map(|s| s.value.clone()).collect();
    let mut at = Vec::new();
    for (name, value) in &written.at {
        let index = symbol(model, name)?;
        values[index] = Some(value.clone());
        at.push((index, value.clone()));
    }
    let quantity = Quantity::of(source, &written.quantity, &at)?;
    let unit = quantity.unit(source);
    let axis = &written.axis;
    let grid = match written.logarithmic[0] {
        true => grid::logarithmic(&axis.low, &axis.high, written.points),
        false => grid::linear(&axis.low, &axis.high, written.points),
    };
    let family = match &written.family {
        None => None,
        Some(family) => Some((symbol(model, &family.name)?, family)),
    };
    let members: Vec<Option<&(crate::document::Text, BigRational)>> = match family {
        None => vec![None],
        Some((_, family)) => family.members.iter().map(Some).collect(),
    };
    let mut curves = Vec::new();
    for member in members {
        if let (Some((index, _)), Some((_, value))) = (family, member) {
            values[index] = Some(value.clone());
        }
        let mut curve = Vec::new();
        for x in &grid {
            values[letter] = Some(x.clone());
            let value = quantity.at(source, &values)?;
            if written.logarithmic[1] && !value.is_positive() {
                return Err(Diagnostic::new(
                    DiagnosticKind::NotPositive {
                        name: written.quantity.text.clone(),
                        value: crate::document::write_number(&value),
                    },
                    written.quantity.span,
                )
                .into());
            }
            curve.push(value);
        }
        curves.push(Curve {
            name: member.map(|(name, _)| name.text.clone()),
            parameter: member.map(|(_, value)| value.clone()),
            values: curve,
        });
    }
    let name_of = |symbol: usize| latex::canonical(&model.symbols[symbol].name);
    Ok(Curves {
        quantity: written.quantity.text.clone(),
        unit,
        letter: name_of(letter),
        letter_unit: model.symbols[letter].unit.clone(),
        logarithmic: written.logarithmic,
        grid,
        family: family.map(|(s, _)| (name_of(s), model.symbols[s].unit.clone())),
        at: at
            .into_iter()
            .map(|(s, value)| (name_of(s), value, model.symbols[s].unit.clone()))
            .collect(),
        curves,
    })
}
