//! The units of a whole document.

use super::{Unit, UnitFinding, Units};
use crate::model::{Model, Symbol};

impl Units {
    /// What a document's tables say about units. A letter without a unit gets one from its uses.
    pub fn of(model: &Model) -> Units {
        let mut units = Units::new();
        // What fits in one instance fits in all: units know nothing of sizes.
        let instance = &model.instances[0];
        units.names.instance = instance.clone();
        for matrix in &model.matrices {
            let (rows, columns) = matrix.shape_in(instance);
            let unit = matrix.unit.as_deref().map(Unit::parse);
            match unit {
                Some(Ok(unit)) => {
                    units.declare_uniform(&matrix.name, rows, columns, &unit.dimension)
                }
                _ => units.declare_matrix(&matrix.name, rows, columns),
            }
        }
        let scalars = || model.symbols.iter().filter(|s| s.entry_of.is_none());
        // Dots over a letter that moves are derivatives; over any other they are an accent.
        let moves = |symbol: &Symbol| {
            let mut processes = scalars().filter(|s| s.function_of.is_some());
            processes.any(|s| s.name.letter == symbol.name.letter)
        };
        for symbol in scalars().filter(|s| s.name.dots > 0 && !moves(s)) {
            units.accents.declare(&symbol.name);
        }
        for symbol in scalars() {
            let unit = symbol.unit.as_deref().map(Unit::parse);
            match unit {
                Some(Ok(unit)) => units.declare(&symbol.name, &unit.dimension),
                _ => units.declare_unknown(&symbol.name),
            }
            if let Some(letter) = &symbol.function_of {
                units.declare_function(&symbol.name, letter);
            }
        }
        for definition in &model.definitions {
            if let [letter] = &definition.arguments[..] {
                units.declare_function(&definition.name, letter);
            }
        }
        // What else determines a covariance tells its units too.
        let elsewhere: Vec<usize> = model.covariances().map(|(n, ..)| n).collect();
        let own = model.notation.iter().enumerate();
        for (_, notation) in own.filter(|(n, _)| !elsewhere.contains(n)) {
            units.declare_notation(&notation.name, notation.kind.clone());
        }
        units
    }
}

/// Every place in a document where units do not fit, and the units of all its names.
pub fn audit(model: &Model) -> (Units, Vec<UnitFinding>) {
    let mut units = Units::of(model);
    let equations = model.equations.iter();
    let findings = units.check_all(equations.map(|e| (&e.label[..], &e.display)));
    (units, findings)
}
