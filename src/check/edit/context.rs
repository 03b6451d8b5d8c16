//! Which letters a document has, and of what kind: what may stand for what.

use crate::expr::{Font, Name};
use crate::functions::Constant;
use crate::model::{DefinitionKind, Model, NotationKind};

/// What a letter can be exchanged with.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Kind {
    /// A number: a symbol, or something defined as a scalar.
    Scalar,
    /// A function of a letter, such as a process.
    Process,
    /// A matrix or a vector.
    Matrix,
}

/// A letter of the document.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Known {
    /// Its name, without dots.
    pub name: Name,
    /// Its kind.
    pub kind: Kind,
    /// Its unit as declared.
    pub unit: Option<String>,
}

/// What is known of a document when one of its equations is edited.
#[derive(Clone, Debug, Default)]
pub struct Context {
    /// Its letters, in the order in which they are declared and defined.
    pub letters: Vec<Known>,
    /// The letter of the ratio of a circle's circumference to its diameter, where it has one.
    pub pi: Option<Name>,
    /// The letter of the zero of any shape, where it has one.
    pub zero: Option<Name>,
    /// Whether it uses functions beyond arithmetic, such as roots and sines.
    pub functions: bool,
    /// What it defines as functions of letters: their names alone stand for no values.
    pub applied: Vec<Name>,
}

impl Context {
    /// What a model knows.
    pub fn of(model: &Model) -> Self {
        let mut letters: Vec<Known> = Vec::new();
        let mut add = |name: &Name, kind: Kind, unit: Option<String>| {
            let name = name.undotted();
            if !letters.iter().any(|known| known.name == name) {
                letters.push(Known { name, kind, unit });
            }
        };
        let by_font = |name: &Name| match name.letter.font {
            Font::Bold => Kind::Matrix,
            _ => Kind::Scalar,
        };
        for symbol in model.symbols.iter().filter(|s| s.entry_of.is_none()) {
            let kind = match symbol.function_of {
                Some(_) => Kind::Process,
                None => Kind::Scalar,
            };
            add(&symbol.name, kind, symbol.unit.clone());
        }
        for matrix in &model.matrices {
            add(&matrix.name, Kind::Matrix, None);
        }
        for definition in &model.definitions {
            let plain = matches!(definition.kind, DefinitionKind::Whole);
            if plain && definition.arguments.is_empty() {
                let kind = match definition.letter {
                    Some(_) => Kind::Scalar,
                    None => by_font(&definition.name),
                };
                add(&definition.name, kind, None);
            }
        }
        for unknown in model.systems.iter().flat_map(|s| &s.unknowns) {
            add(unknown, by_font(unknown), None);
        }
        for notation in &model.notation {
            let kind = match notation.kind {
                NotationKind::Identity(_) | NotationKind::HurwitzMatrix(_) => Kind::Matrix,
                NotationKind::Means(_) | NotationKind::Constant(_) => by_font(&notation.name),
                _ => continue,
            };
            add(&notation.name, kind, None);
        }
        let pi = model
            .notation
            .iter()
            .find(|n| matches!(n.kind, NotationKind::Constant(Constant::Pi)))
            .map(|n| n.name.clone());
        let zero = model
            .notation
            .iter()
            .find(|n| matches!(n.kind, NotationKind::Zero))
            .map(|n| n.name.clone());
        Context {
            letters,
            pi,
            zero,
            functions: model.functions.is_some(),
            applied: model
                .definitions
                .iter()
                // What moves is written with its time or without.
                .filter(|d| {
                    let moves = d.arguments.iter().any(|a| model.is_time(a));
                    !d.arguments.is_empty() && d.name.dots == 0 && !moves
                })
                .map(|d| d.name.undotted())
                .collect(),
        }
    }

    /// Whether a name is that of a function that the document defines, or of a derivative of one: it is
    /// written with an argument, and never where a number stands.
    pub fn is_applied(&self, name: &Name) -> bool {
        let name = name.undotted();
        (0..=name.letter.primes).any(|primes| {
            let function = name.unprimed(primes);
            let mut all = self.applied.iter();
            all.any(|known| *known == name || function.as_ref() == Some(known))
        })
    }

    /// The kind of a name, dots aside; by its typeface where the document does not say.
    pub fn kind_of(&self, name: &Name) -> Kind {
        let undotted = name.undotted();
        match self.letters.iter().find(|k| k.name == undotted) {
            Some(known) => known.kind,
            None if name.letter.font == Font::Bold => Kind::Matrix,
            None => Kind::Scalar,
        }
    }

    /// The declared unit of a name.
    pub fn unit_of(&self, name: &Name) -> Option<&str> {
        let undotted = name.undotted();
        let known = self.letters.iter().find(|k| k.name == undotted)?;
        known.unit.as_deref()
    }

    /// Whether a name is the circle's constant.
    pub fn is_pi(&self, name: &Name) -> bool {
        self.pi.as_ref() == Some(name)
    }
}
