//! What a document declares about its letters, as far as reading depends on it.

use super::writer::canonical;
use crate::expr::{Letter, Name};
use std::collections::{BTreeMap, BTreeSet};

/// The names a document declares, as far as the reading of an equation depends on them.
///
/// `\zeta(t)` is an application if `\zeta` is a function, a product if it is declared as
/// anything else; if it is not declared, it is an application where some declared function is a
/// function of `t`, and an ambiguity otherwise. All names are compared by their
/// [`canonical`] form without dots: `\dot{\zeta}(t)` is an application too.
#[derive(Clone, Debug)]
pub struct Signature {
    /// Functions, with the bases of the letters they are functions of.
    functions: BTreeMap<String, BTreeSet<String>>,
    /// Those that an equation defines of any argument.
    formal: BTreeSet<String>,
    /// Names of columns, and of other matrices, as far as their shapes are printed.
    columns: BTreeSet<String>,
    matrices: BTreeSet<String>,
    names: BTreeSet<String>,
    /// Names that an equation defines and no table declares.
    defined: BTreeSet<String>,
    indexed: BTreeSet<Letter>,
    /// Letters that with two indices are the entries of a matrix.
    entries: BTreeSet<Letter>,
    /// Letters that stand somewhere without a bracket after them; none where nothing was noted.
    bare: Option<BTreeSet<String>>,
    expectation: Option<String>,
}

/// Whether a name stands for a column or for another matrix.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Shape {
    /// Entries one below the other.
    Column,
    /// Anything else.
    Matrix,
}

/// What stands alone on the left of an equals sign.
pub(super) struct Head {
    pub name: Name,
    /// The arguments of a function.
    pub arguments: Vec<Name>,
    /// The shape of the matrix that is printed on the right, if one is.
    pub shape: Option<Shape>,
}

impl Default for Signature {
    /// Nothing is declared; `E\{...\}` is the expectation.
    fn default() -> Self {
        Signature {
            functions: BTreeMap::new(),
            formal: BTreeSet::new(),
            columns: BTreeSet::new(),
            matrices: BTreeSet::new(),
            names: BTreeSet::new(),
            defined: BTreeSet::new(),
            indexed: BTreeSet::new(),
            entries: BTreeSet::new(),
            bare: None,
            expectation: Some("E".to_owned()),
        }
    }
}

impl Signature {
    /// Declares a name that is no function: a letter, a matrix, or with an index pattern such as
    /// `H_{i,j}` every letter with an index.
    pub fn declare(&mut self, name: &Name) {
        self.names.insert(canonical(&name.undotted()));
        if name.subscript.is_some() {
            self.indexed.insert(name.letter.clone());
        }
    }

    /// Declares the entries of a matrix, with an index pattern such as `A_{i,j}`.
    pub(crate) fn declare_entries(&mut self, name: &Name) {
        self.entries.insert(name.letter.clone());
        self.declare(name);
    }

    /// Whether a name is an entry of a matrix.
    pub(super) fn has_entries(&self, name: &Name) -> bool {
        name.subscript.is_some() && self.entries.contains(&name.letter)
    }

    /// Declares a function and the letters it is a function of.
    pub fn declare_function(&mut self, name: &Name, variables: &[Name]) {
        let variables = variables.iter().map(|v| v.letter.base.clone());
        self.functions
            .entry(canonical(&name.undotted()))
            .or_default()
            .extend(variables);
    }

    /// Declares what the equations of a display define: the names, and the functions with their
    /// arguments, that stand alone on the left of an equals sign, and the names under its
    /// braces. A name defined so may still be a function of time: it is applied in `x(t)`. What is wrong with the display is for [`parse_display`](super::parse_display) to say.
    pub fn declare_definitions(&mut self, text: &str) {
        for Head {
            name,
            arguments,
            shape,
        } in super::heads_with_arguments(text)
        {
            if let Some(shape) = shape {
                self.declare_shape(&name, shape);
            }
            if arguments.is_empty() {
                self.defined.insert(canonical(&name.undotted()));
                if name.subscript.is_some() {
                    self.indexed.insert(name.letter.clone());
                }
            } else if !self.has_name(&name) {
                if !self.is_function(&name) {
                    self.formal.insert(canonical(&name.undotted()));
                }
                self.declare_function(&name, &arguments);
            }
        }
    }

    /// Declares whether a name that has a meaning is a column or another matrix.
    pub(crate) fn declare_shape(&mut self, name: &Name, shape: Shape) {
        let known = match shape {
            Shape::Column => &mut self.columns,
            Shape::Matrix => &mut self.matrices,
        };
        known.insert(canonical(&name.undotted()));
    }

    /// Which of the two it is, if that is printed.
    pub(super) fn shape(&self, name: &Name) -> Option<Shape> {
        let key = canonical(&name.undotted());
        match (self.columns.contains(&key), self.matrices.contains(&key)) {
            (true, false) => Some(Shape::Column),
            (false, true) => Some(Shape::Matrix),
            _ => None,
        }
    }

    /// Whether an equation, and no table, says of which letter it is a function: then it may be one of anything.
    pub(super) fn is_formal(&self, name: &Name) -> bool {
        let unprimed = (0..=name.letter.primes).filter_map(|n| name.undotted().unprimed(n));
        let mut keys = unprimed.map(|function| canonical(&function));
        keys.any(|key| self.formal.contains(&key))
    }

    /// Notes which letters of a text stand without arguments. A function that always has some is one
    /// in `h(y - 1)` too; `x(a + b)` may be a product where `x` stands alone elsewhere.
    pub fn note_uses(&mut self, text: &str) {
        let bare = self.bare.get_or_insert_default();
        bare.extend(super::letters_without_bracket(text));
    }

    /// Whether uses were noted and the name is nowhere without arguments.
    pub(super) fn is_always_applied(&self, name: &Name) -> bool {
        let bare = self.bare.as_ref();
        bare.is_some_and(|bare| !bare.contains(&name.letter.base))
    }

    /// Chooses the letter that before `\{` stands for the expectation; `E` unless told.
    pub fn set_expectation(&mut self, name: Option<&Name>) {
        self.expectation = name.map(canonical);
    }

    /// Whether the name is a function.
    pub fn is_function(&self, name: &Name) -> bool {
        self.variables(name).is_some()
    }

    /// Whether the name is declared as something else than a function.
    pub fn is_declared(&self, name: &Name) -> bool {
        let key = canonical(&name.undotted());
        self.names.contains(&key)
            || self.defined.contains(&key)
            || name.subscript.is_some() && self.indexed.contains(&name.letter)
    }

    /// Whether an equation defines it, alone or as a function, and no table declares it.
    pub(super) fn is_defined(&self, name: &Name) -> bool {
        let key = canonical(&name.undotted());
        !self.names.contains(&key) && (self.defined.contains(&key) || self.formal.contains(&key))
    }

    /// Whether exactly this name, and not only its letter with another index, is no function.
    fn has_name(&self, name: &Name) -> bool {
        let key = canonical(&name.undotted());
        self.names.contains(&key) || self.defined.contains(&key)
    }

    /// Whether a table says that the name is no function.
    pub(super) fn is_no_function(&self, name: &Name) -> bool {
        self.names.contains(&canonical(&name.undotted()))
    }

    /// Whether the name is the expectation where `\{` follows.
    pub fn is_expectation(&self, name: &Name) -> bool {
        self.expectation.as_deref() == Some(canonical(name).as_str())
    }

    /// Whether the italic letter is declared, as a function or not.
    pub(super) fn knows_letter(&self, letter: &str) -> bool {
        self.names.contains(letter) || self.functions.contains_key(letter)
    }

    /// Whether the italic letter has a meaning in the document, by a table or by an equation.
    pub(super) fn has_letter(&self, letter: &str) -> bool {
        self.knows_letter(letter) || self.defined.contains(letter)
    }

    /// The bases of the letters that the name is a function of, as far as they are declared.
    pub(super) fn variables(&self, name: &Name) -> Option<&BTreeSet<String>> {
        // A derivative, f', is a function of what f is one of.
        let unprimed = (0..=name.letter.primes).filter_map(|n| name.undotted().unprimed(n));
        let own = self.has_name(name);
        unprimed
            .take(if own { 1 } else { usize::MAX })
            .find_map(|function| self.functions.get(&canonical(&function)))
    }

    /// Whether some function is declared as a function of the letter.
    pub(super) fn is_variable(&self, base: &str) -> bool {
        self.functions.values().any(|bases| bases.contains(base))
    }
}
