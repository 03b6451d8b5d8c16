//! The letters of the ring: symbols, their time derivatives, and abbreviations.

use super::links::each_expression;
use super::matrices::MatrixSymbol;
use super::{
    Definition, DefinitionKind, Equation, Letter, Model, Node, Notation, NotationKind, Role, Symbol,
};
use crate::expr::{Expr, ExprKind, Function, Name, Sign};
use crate::functions::FunctionTable;
use crate::latex;
use crate::model::links::Place;
use crate::model::range::{Numbers, Range};
use num_traits::Signed;
use ratpoly::{Order, Ring};
use std::collections::{BTreeMap, BTreeSet};

/// How many orders of time derivatives beyond the printed ones have letters of their own: one for
/// differentiating the equations once, one for restoring a lost dot.
const SPARE_DERIVATIVES: u8 = 2;
/// Letters for functions beyond two for each printed use, and the most that are kept.
const SPARE_FUNCTIONS: usize = 10;
const MOST_FUNCTIONS: usize = 48;
/// The largest number of letters that a document may compute with.
pub(super) const MOST_LETTERS: usize = 500;

/// The letters of the ring but for the abbreviations: each symbol, each process with as many time
/// derivatives as are printed and a few more.
pub(super) fn letters(
    symbols: &[Symbol],
    matrices: &[MatrixSymbol],
    equations: &[Equation],
) -> Vec<Letter> {
    let mut dots = 0;
    let mut own: BTreeMap<String, u8> = BTreeMap::new();
    for equation in equations {
        each_expression(&equation.display, &mut |e| {
            if let ExprKind::Name(name) | ExprKind::Apply { function: name, .. } = &e.kind {
                // A prime over a process is its derivative too.
                let process = |primes: &u8| {
                    let function = name.undotted().unprimed(*primes);
                    symbols.iter().any(|s| function.as_ref() == Some(&s.name))
                };
                let primes = (1..=name.letter.primes).find(process).unwrap_or(0);
                dots = dots.max(name.dots.saturating_add(primes));
                let printed = own.entry(latex::canonical(&name.undotted())).or_default();
                *printed = name.dots.max(*printed);
            }
        });
    }
    let mut letters = Vec::new();
    for (symbol, s) in symbols.iter().enumerate() {
        let orders = match (&s.function_of, s.entry_of) {
            (None, _) => 0,
            (Some(_), None) => dots + SPARE_DERIVATIVES,
            // Matrices have many letters, and every letter of the ring costs.
            (Some(_), Some((m, ..))) => {
                own.get(&latex::canonical(&matrices[m].name.undotted()))
                    .copied()
                    .unwrap_or(0)
                    + 1
            }
        };
        letters.extend((0..=orders).map(|order| Letter::Symbol { symbol, order }));
    }
    letters
}

/// How many letters to keep for functions: none for a document that uses none.
pub(super) fn reserve(
    equations: &[Equation],
    notation: &[Notation],
    definitions: &[Definition],
) -> usize {
    let constants = notation
        .iter()
        .filter(|n| matches!(n.kind, NotationKind::Constant(_) | NotationKind::Dirac))
        .count();
    let mut uses = 0;
    for equation in equations {
        each_expression(&equation.display, &mut |e| {
            uses += usize::from(match &e.kind {
                ExprKind::Call { function, .. } => {
                    !matches!(function, Function::Determinant | Function::Trace)
                }
                ExprKind::Power { exponent, .. } => {
                    super::names::literal_integer(exponent).is_none() && !is_transposition(exponent)
                }
                ExprKind::Integral { .. } | ExprKind::Cases(_) => true,
                // A derivative by an argument is taken over a letter of its own.
                ExprKind::Name(name) | ExprKind::Apply { function: name, .. } => {
                    let defined = |primes| {
                        let function = name.undotted().unprimed(primes);
                        let mut functions = definitions.iter().filter(|d| !d.arguments.is_empty());
                        functions.any(|d| function.as_ref() == Some(&d.name))
                    };
                    (1..=name.letter.primes).any(defined)
                }
                _ => false,
            });
        });
    }
    // Whether an argument is one at which a function has a value of its own, signs tell.
    let own = definitions.iter().filter(|d| {
        let function = |other: &&Definition| other.name == d.name && !other.arguments.is_empty();
        matches!(d.kind, DefinitionKind::ValueAt(_)) && definitions.iter().any(|o| function(&o))
    });
    match uses + constants + own.count() {
        0 => 0,
        n => (SPARE_FUNCTIONS + 2 * n).min(MOST_FUNCTIONS),
    }
}

/// Indices and the T of a transpose stand in exponents too.
fn is_transposition(exponent: &Expr) -> bool {
    matches!(&exponent.kind, ExprKind::Name(name) if name.letter.base == "T")
}

/// A name with nothing but letters, digits and underscores.
fn plain(name: &Name) -> String {
    let mut text = String::new();
    for c in latex::canonical(name).replace("mathbf", "").chars() {
        if c.is_ascii_alphanumeric() {
            text.push(c);
        } else if !text.is_empty() && !text.ends_with('_') {
            text.push('_');
        }
    }
    let text = text.trim_end_matches('_').to_string();
    if text.starts_with(|c: char| c.is_ascii_alphabetic()) {
        text
    } else {
        format!("x_{text}")
    }
}

/// An identifier for a letter in the plain notation of the polynomial crate.
fn plain_name(symbols: &[Symbol], letter: &Letter) -> String {
    match letter {
        Letter::Symbol { symbol, order } => {
            let base = plain(&symbols[*symbol].name);
            match order {
                0 => base,
                n => format!("{base}_t{n}"),
            }
        }
        Letter::Abbreviation { definition } => format!("definition_{definition}"),
        Letter::Function { slot } => format!("function_{slot}"),
    }
}

/// What was found out about definitions, each of which is looked at once.
#[derive(Default)]
struct Seen {
    positive: BTreeMap<usize, bool>,
    complex: BTreeMap<usize, bool>,
}

impl Model {
    /// Finds the abbreviations and gives each a letter of the ring.
    pub(super) fn name_abbreviations(&mut self) {
        let mut found = true;
        while found {
            found = false;
            for d in 0..self.definitions.len() {
                if self.definitions[d].letter.is_none() && self.is_abbreviation(d) {
                    self.definitions[d].letter = Some(self.letters.len());
                    self.letters.push(Letter::Abbreviation { definition: d });
                    found = true;
                }
            }
        }
        // Abbreviations first: they are the letters that the claims are printed in.
        self.letters.sort_by_key(|l| match l {
            Letter::Abbreviation { definition } => (0, *definition, 0),
            Letter::Symbol { symbol, order } => (1, *symbol, *order),
            Letter::Function { slot } => (2, *slot, 0),
        });
        for (position, letter) in self.letters.iter().enumerate() {
            if let Letter::Abbreviation { definition } = letter {
                self.definitions[*definition].letter = Some(position);
            }
        }
        let mut taken: BTreeSet<String> = BTreeSet::new();
        let names: Vec<String> = self
            .letters
            .iter()
            .map(|letter| {
                let mut name = match letter {
                    Letter::Abbreviation { definition } => {
                        plain(&self.definitions[*definition].name)
                    }
                    symbol => plain_name(&self.symbols, symbol),
                };
                while !taken.insert(name.clone()) {
                    name.push('_');
                }
                name
            })
            .collect();
        if let Ok(ring) = Ring::new(names, Order::Grevlex) {
            self.ring = ring;
        }
        let reserved = |l: &Letter| matches!(l, Letter::Function { .. });
        if self.letters.iter().any(reserved) {
            let mut seen = Seen::default();
            let ranges = (0..self.letters.len())
                .filter(|l| !reserved(&self.letters[*l]))
                .map(|l| self.range_among(l, &mut seen))
                .collect();
            let table = FunctionTable::new(self.ring, ranges);
            let dirac = |n: &Notation| matches!(n.kind, NotationKind::Dirac);
            self.functions = Some(match self.notation.iter().any(dirac) {
                true => table.with_distributions(),
                false => table,
            });
        }
    }

    /// Which numbers a letter of the ring stands for, as far as declarations tell.
    pub(crate) fn range_of(&self, letter: usize) -> Range {
        self.range_among(letter, &mut Seen::default())
    }

    fn range_among(&self, letter: usize, seen: &mut Seen) -> Range {
        match &self.letters[letter] {
            Letter::Symbol { symbol, order: 0 } => self.symbols[*symbol].range.clone(),
            // The derivative of a positive process has any sign, that of a complex one any value.
            Letter::Symbol { symbol, .. } => match self.symbols[*symbol].range.numbers {
                Numbers::Complex => Range {
                    numbers: Numbers::Complex,
                    ..Range::default()
                },
                Numbers::Real | Numbers::Integer => Range::default(),
            },
            Letter::Abbreviation { definition } => self.range_of_definition(*definition, seen),
            Letter::Function { .. } => Range::default(),
        }
    }

    /// The values of an abbreviation: positive where it is put together from positive parts, complex
    /// where a part is.
    fn range_of_definition(&self, d: usize, seen: &mut Seen) -> Range {
        if self.is_positive_definition(d, &mut seen.positive) {
            return Range::positive();
        }
        Range {
            numbers: match self.is_complex_definition(d, &mut seen.complex) {
                true => Numbers::Complex,
                false => Range::default().numbers,
            },
            ..Range::default()
        }
    }

    /// Whether an abbreviation has a complex part; each is looked at once, however often it occurs.
    fn is_complex_definition(&self, d: usize, seen: &mut BTreeMap<usize, bool>) -> bool {
        if let Some(known) = seen.get(&d) {
            return *known;
        }
        let definition = &self.definitions[d];
        let display = &self.equations[definition.equation].display;
        let mut complex = false;
        if let Some(value) = definition.place.find(display) {
            crate::expr::walk::visit(value, &mut |e| {
                let ExprKind::Name(name) = &e.kind else {
                    return;
                };
                complex |= match self.names.whole.get(&latex::canonical(name)) {
                    Some(Node::Symbol(s)) => self.symbols[*s].range.numbers == Numbers::Complex,
                    Some(Node::Definition(other)) => {
                        *other < d && self.is_complex_definition(*other, seen)
                    }
                    _ => false,
                };
            });
        }
        seen.insert(d, complex);
        complex
    }

    /// Whether an abbreviation is put together from positive parts without a minus sign; each is looked at
    /// once, however often it occurs.
    fn is_positive_definition(&self, d: usize, seen: &mut BTreeMap<usize, bool>) -> bool {
        if let Some(known) = seen.get(&d) {
            return *known;
        }
        let definition = &self.definitions[d];
        let display = &self.equations[definition.equation].display;
        let Some(value) = definition.place.find(display) else {
            return false;
        };
        let mut positive = true;
        crate::expr::walk::visit(value, &mut |e| match &e.kind {
            ExprKind::Sum(terms) => positive &= terms.iter().all(|(sign, _)| *sign == Sign::Plus),
            ExprKind::Number(n) => positive &= n.is_positive(),
            ExprKind::Name(name) => {
                positive &= match self.names.whole.get(&latex::canonical(name)) {
                    Some(Node::Symbol(s)) => self.symbols[*s].range.is_positive(),
                    Some(Node::Definition(other)) => {
                        *other < d && self.is_positive_definition(*other, seen)
                    }
                    _ => false,
                };
            }
            _ => {}
        });
        seen.insert(d, positive);
        positive
    }

    /// A scalar defined by arithmetic on constant symbols and other abbreviations.
    fn is_abbreviation(&self, d: usize) -> bool {
        let definition = &self.definitions[d];
        let equation = &self.equations[definition.equation];
        let plain = matches!(definition.kind, DefinitionKind::Whole)
            && definition.arguments.is_empty()
            && equation.role == Role::Define
            && matches!(definition.place, Place::Member { .. });
        let Some(value) = definition.place.find(&equation.display).filter(|_| plain) else {
            return false;
        };
        let mut arithmetic = true;
        let mut letters = 0;
        crate::expr::walk::visit(value, &mut |e| match &e.kind {
            ExprKind::Number(_)
            | ExprKind::Sum(_)
            | ExprKind::Product(_)
            | ExprKind::Quotient { .. }
            | ExprKind::Group { .. } => {}
            ExprKind::Power { exponent, .. } => {
                arithmetic &= super::names::literal_integer(exponent).is_some();
            }
            ExprKind::Name(name) => {
                letters += 1;
                arithmetic &= match self.names.whole.get(&latex::canonical(name)) {
                    Some(Node::Symbol(s)) => self.symbols[*s].function_of.is_none(),
                    Some(Node::Definition(other)) => self.definitions[*other].letter.is_some(),
                    _ => false,
                };
            }
            _ => arithmetic = false,
        });
        arithmetic && letters > 0
    }
}
