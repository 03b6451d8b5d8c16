//! A document as mathematics: its letters, what each name stands for, and the links to check.
//!
//! Invariants: every name in every link, definition and notation entry resolves; no definition
//! needs itself (a family may need members with another index); each name has one meaning.

mod bare;
mod build;
mod conditions;
mod cycles;
pub mod degree;
mod letters;
pub mod limits;
pub mod links;
pub mod matrices;
pub mod names;
mod overlap;
pub mod range;
mod shadow;
pub mod statement;
pub mod time;

use crate::document::{Document, Instance, Settings, Size, VerdictWord};
use crate::domain::Symbolic;
use crate::expr::{Display, Expr, ExprKind, Name, Relation, Sign};
use crate::functions::{Constant, FunctionTable};
use crate::latex::{Reading, Signature};
use crate::span::Span;
use links::{Link, Place};
use matrices::MatrixSymbol;
pub(crate) use names::EIGENVALUES;
use names::Names;
use num_rational::BigRational;
use range::Range;
use ratpoly::Ring;
use statement::Statement;
use std::collections::BTreeSet;

/// Something with a value: what a name can stand for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Node {
    /// A declared symbol.
    Symbol(usize),
    /// A declared matrix.
    Matrix(usize),
    /// A definition in an equation.
    Definition(usize),
    /// An entry of the notation table.
    Notation(usize),
    /// The unknown at a position of a `solve` block.
    Unknown {
        /// Which block, as an index into [`Model::systems`].
        system: usize,
        /// Which of its unknowns.
        position: usize,
    },
}

/// A declared symbol: a letter that the document leaves free.
#[derive(Clone, Debug)]
pub struct Symbol {
    /// The name.
    pub name: Name,
    /// Which numbers it stands for; what is declared positive has the range from zero on.
    pub range: Range,
    /// The reference value, if any.
    pub value: Option<BigRational>,
    /// The SI unit as written, if any.
    pub unit: Option<String>,
    /// What it is.
    pub meaning: String,
    /// The letter it is a function of, if any; dots differentiate by it.
    pub function_of: Option<Name>,
    /// All letters it is a function of.
    pub arguments: Vec<Name>,
    /// Where it is declared, as an index into the document's symbols.
    pub declared: usize,
    /// The declared matrix that it is an entry of, and its row and column from 0.
    pub entry_of: Option<(usize, usize, usize)>,
}

/// A variable of the ring in which the document is evaluated.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Letter {
    /// A symbol, or its time derivative of an order.
    Symbol {
        /// Index into [`Model::symbols`].
        symbol: usize,
        /// Order of the derivative.
        order: u8,
    },
    /// An abbreviation, kept free until a claim needs its definition.
    Abbreviation {
        /// Index into [`Model::definitions`].
        definition: usize,
    },
    /// Given out on demand to a function of an argument; which, says [`Model::functions`].
    Function {
        /// Its place in the reserve.
        slot: usize,
    },
}

/// What a definition defines.
#[derive(Clone, Debug)]
pub enum DefinitionKind {
    /// A name.
    Whole,
    /// A power of a name.
    Power(u32),
    /// The value of a process at a number, as in `\mathbf{y}(0) = \mathbf{y}_0`.
    ValueAt(BigRational),
    /// A single member of a family.
    Element(Vec<i64>),
    /// A family with running indices.
    Family {
        /// The canonical names of the indices.
        indices: Vec<String>,
        /// First and last value of each.
        ranges: Vec<(i64, i64)>,
    },
}

/// A name that gets its value from a place in a display.
#[derive(Clone, Debug)]
pub struct Definition {
    /// The name on the left, as printed.
    pub name: Name,
    /// What kind of name it is.
    pub kind: DefinitionKind,
    /// The equation, as an index into [`Model::equations`].
    pub equation: usize,
    /// Where the value stands in its display.
    pub place: Place,
    /// The declared letters that it is defined as a function of.
    pub arguments: Vec<Name>,
    /// What stands in the brackets after the name on the left; none for a bare name.
    pub head: Option<Vec<Expr>>,
    /// The letter of the ring that stands for it where it is an abbreviation: a scalar defined
    /// by arithmetic on constant symbols and other abbreviations.
    pub letter: Option<usize>,
}

/// An entry of the notation table.
#[derive(Clone, Debug)]
pub struct Notation {
    /// The name or pattern.
    pub name: Name,
    /// What it means.
    pub kind: NotationKind,
}

/// What a notation can mean; the expressions name what it is taken of.
#[derive(Clone, Debug)]
pub enum NotationKind {
    /// The unit matrix of an order.
    Identity(Size),
    /// Zero of any shape.
    Zero,
    /// The coefficient a_i of lambda^(n-i) in det(lambda E - A).
    CharacteristicCoefficient(Expr),
    /// The cofactor of an entry.
    Cofactor(Expr),
    /// The leading principal minor of an order.
    LeadingMinor(Expr),
    /// The entry of a matrix.
    Entry(Expr),
    /// The Hurwitz matrix of the characteristic polynomial of a matrix.
    HurwitzMatrix(Expr),
    /// A constant with a letter of its own.
    Constant(Constant),
    /// The Dirac distribution.
    Dirac,
    /// Another way of writing an expression.
    Means(Expr),
    /// The number of rows of a matrix.
    Rows(Expr),
    /// The covariance of zero-mean random vectors.
    Covariance(Box<Covariance>),
}

/// `E{left right^T}` for two zero-mean random vectors, or twice the same.
#[derive(Clone, Debug)]
pub struct Covariance {
    /// The vector whose entries number the rows.
    pub left: Expr,
    /// The vector whose entries number the columns.
    pub right: Expr,
    /// `left right^T`.
    pub product: Expr,
}

impl NotationKind {
    /// The expression that the notation is about, if any.
    pub fn target(&self) -> Option<&Expr> {
        match self {
            NotationKind::Identity(_)
            | NotationKind::Zero
            | NotationKind::Constant(_)
            | NotationKind::Dirac => None,
            NotationKind::CharacteristicCoefficient(e)
            | NotationKind::Cofactor(e)
            | NotationKind::LeadingMinor(e)
            | NotationKind::Entry(e)
            | NotationKind::HurwitzMatrix(e)
            | NotationKind::Rows(e)
            | NotationKind::Means(e) => Some(e),
            NotationKind::Covariance(covariance) => Some(&covariance.product),
        }
    }
}

/// A `solve` block: equations and the unknowns they determine.
#[derive(Clone, Debug)]
pub struct System {
    /// The equation, as an index into [`Model::equations`].
    pub equation: usize,
    /// The unknowns in the order given.
    pub unknowns: Vec<Name>,
}

/// What an equation does in its document.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Role {
    /// Gives names values.
    Define,
    /// Determines unknowns; which, is in [`Model::systems`].
    Solve,
    /// Is to be checked.
    Claim,
    /// Is stated, with nothing to check, for this reason.
    Recall(String),
}

/// What a document supposes: a relation between two neighbours of a chain.
#[derive(Clone, Debug)]
pub struct Hypothesis {
    /// What stands left of the relation.
    pub left: Expr,
    /// The relation.
    pub relation: Relation,
    /// What stands right of it.
    pub right: Expr,
    /// Where.
    pub span: Span,
}

impl Hypothesis {
    /// Left minus right.
    pub fn difference(&self) -> Expr {
        Expr::new(
            ExprKind::Sum(vec![
                (Sign::Plus, self.left.clone()),
                (Sign::Minus, self.right.clone()),
            ]),
            self.span,
        )
    }
}

/// A displayed equation.
#[derive(Clone, Debug)]
pub struct Equation {
    /// Its printed number, or a word.
    pub label: String,
    /// Its role.
    pub role: Role,
    /// The LaTeX as printed.
    pub source: String,
    /// The display as printed.
    pub display: Display,
    /// Its links.
    pub links: Vec<Link>,
    /// For each link, the definition that it makes, if it makes one.
    pub defines: Vec<Option<usize>>,
    /// The author's settings.
    pub settings: Settings,
    /// The hypotheses that the author states.
    pub given: Vec<Hypothesis>,
    /// The hypotheses that are printed around it, and the conditions in its own display.
    pub assume: Vec<Hypothesis>,
    /// How it was read where the print leaves a choice, in the order of the text.
    pub readings: Vec<Reading>,
    /// Where the printed equation stands.
    pub span: Span,
}

/// A document as mathematics.
#[derive(Clone, Debug)]
pub struct Model {
    /// The document.
    pub document: Document,
    /// The declared symbols, the entries of declared matrices among them.
    pub symbols: Vec<Symbol>,
    /// The declared matrices.
    pub matrices: Vec<MatrixSymbol>,
    /// Every combination of values of the letters that sizes depend on: at least one.
    pub instances: Vec<Instance>,
    /// The notation table.
    pub notation: Vec<Notation>,
    /// The definitions.
    pub definitions: Vec<Definition>,
    /// The `solve` blocks.
    pub systems: Vec<System>,
    /// The equations in the order of the document.
    pub equations: Vec<Equation>,
    /// The statements in words, in the order of the document.
    pub statements: Vec<Statement>,
    /// The variables of the ring.
    pub letters: Vec<Letter>,
    /// The ring in which the document is evaluated.
    pub ring: Ring,
    /// What the letters of the reserve stand for; none where the document uses no functions.
    pub functions: Option<FunctionTable>,
    /// The letters that some process is a function of.
    pub arguments: BTreeSet<String>,
    /// The letters that dots differentiate by: see [`time`].
    pub times: BTreeSet<String>,
    pub(crate) names: Names,
    /// How its equations are read.
    pub(crate) signature: Signature,
}

impl Model {
    /// The equation with this label.
    pub fn equation(&self, label: &str) -> Option<usize> {
        self.equations.iter().position(|e| e.label == label)
    }

    /// The covariances of the notation whose matrices have their values from elsewhere.
    pub fn covariances(&self) -> impl Iterator<Item = (usize, Node, &Covariance)> {
        self.notation
            .iter()
            .enumerate()
            .filter_map(|(n, notation)| match &notation.kind {
                NotationKind::Covariance(covariance) => {
                    let key = crate::latex::canonical(&notation.name);
                    let node = *self.names.whole.get(&key)?;
                    (node != Node::Notation(n)).then_some((n, node, &**covariance))
                }
                _ => None,
            })
    }

    /// The variable of the ring for a symbol's derivative.
    pub fn letter_of_symbol(&self, symbol: usize, order: u8) -> Option<usize> {
        self.letters
            .iter()
            .position(|l| *l == Letter::Symbol { symbol, order })
    }

    /// Whether a variable of the ring is declared positive. An abbreviation is positive when its
    /// value is, which the caller finds out by inserting it.
    pub fn is_positive(&self, letter: usize) -> bool {
        match self.letters[letter] {
            Letter::Symbol { symbol, order } => {
                order == 0 && self.symbols[symbol].range.is_positive()
            }
            Letter::Abbreviation { .. } => false,
            Letter::Function { .. } => self
                .functions
                .as_ref()
                .is_some_and(|table| table.is_positive_letter(letter)),
        }
    }

    /// The field in which the document is evaluated.
    pub fn field(&self) -> Symbolic {
        match &self.functions {
            Some(table) => Symbolic::with_functions(table.clone()),
            None => Symbolic::new(self.ring),
        }
    }

    /// The definition that a name is applied as, if it is defined as a function.
    pub fn function_definition(&self, node: Node) -> Option<&Definition> {
        match node {
            Node::Definition(d) => {
                Some(&self.definitions[d]).filter(|definition| !definition.arguments.is_empty())
            }
            _ => None,
        }
    }

    /// Whether a name is defined as a function of letters none of which is a time or what processes depend on: at a
    /// number such a letter is that number, and nothing else is. A value at a number that is none of the function's
    /// own is something else.
    pub fn is_function_of_no_time(&self, node: Node, at: &BigRational) -> bool {
        let moving = |argument: &Name| {
            let argument = crate::latex::canonical(argument);
            self.times.contains(&argument) || self.arguments.contains(&argument)
        };
        let own = match node {
            Node::Definition(d) => !self.exceptions(d).is_empty(),
            Node::Symbol(_) | Node::Matrix(_) | Node::Notation(_) | Node::Unknown { .. } => false,
        };
        self.function_definition(node).is_some_and(|definition| {
            !definition.arguments.iter().any(moving)
                && (own || self.value_at(&definition.name, at).is_none())
        })
    }

    /// The printed name of a variable of the ring.
    pub fn letter_name(&self, letter: usize) -> Name {
        match self.letters[letter] {
            Letter::Symbol { symbol, order } => {
                let mut name = self.symbols[symbol].name.clone();
                name.dots += order;
                name
            }
            Letter::Abbreviation { definition } => self.definitions[definition].name.clone(),
            Letter::Function { slot } => Name::italic(&format!("f_{{{slot}}}")),
        }
    }

    /// Whether this is the canonical name of a vector, declared or defined, as the first argument
    /// of `\mathbf{a}(\mathbf{x}, t)` is.
    fn is_vector(&self, name: &str) -> bool {
        name.contains("\\mathbf")
            && matches!(
                self.names.whole.get(name),
                Some(Node::Matrix(_) | Node::Definition(_))
            )
    }

    /// The definition of a process's value at a number.
    pub fn value_at(&self, process: &Name, at: &BigRational) -> Option<usize> {
        let key = (crate::latex::canonical(process), at.clone());
        self.names.values.get(&key).copied()
    }

    /// The values at numbers that the document gives something of this name: the numbers with the definitions.
    pub fn own_values(&self, name: &Name) -> impl Iterator<Item = (&BigRational, usize)> {
        let key = crate::latex::canonical(name);
        let values = self.names.values.iter();
        values
            .filter(move |((name, _), _)| *name == key)
            .map(|((_, at), definition)| (at, *definition))
    }

    /// The values of its own that a function of one argument has at numbers beside the general one. What is a
    /// function of the time, or of what processes are functions of, has none: they are its values there.
    pub fn exceptions(&self, definition: usize) -> Vec<(BigRational, usize)> {
        let definition = &self.definitions[definition];
        let argument = match (&definition.kind, &definition.arguments[..]) {
            (DefinitionKind::Whole, [argument]) => crate::latex::canonical(argument),
            _ => return Vec::new(),
        };
        if self.times.contains(&argument) || self.arguments.contains(&argument) {
            return Vec::new();
        }
        let own = self.own_values(&definition.name);
        own.map(|(at, value)| (at.clone(), value)).collect()
    }

    /// Whether the document says of any process what its value at this number is.
    pub fn has_values_at(&self, at: &BigRational) -> bool {
        self.names.values.keys().any(|(_, number)| number == at)
    }

    /// Whether a name with these arguments is no more than the name: a process at the letters that
    /// it is a function of, or what an equation defines with exactly these arguments.
    pub fn is_plain_application(&self, function: &Name, arguments: &[Expr]) -> bool {
        if let Ok(names::Resolved::Node {
            node: Node::Definition(d),
            ..
        }) = self.resolve(function, &|_| false)
            && let Some(head) = &self.definitions[d].head
            && !same_letters(head, arguments)
        {
            return false;
        }
        arguments.iter().all(|argument| match &argument.kind {
            ExprKind::Name(name) => self.is_argument_of(function, &crate::latex::canonical(name)),
            _ => false,
        })
    }

    /// Whether `argument` is the letter that this process is declared a function of.
    pub fn is_argument_of(&self, process: &Name, argument: &str) -> bool {
        let undotted = crate::latex::canonical(&process.undotted());
        let among = |names: &[Name]| names.iter().any(|n| crate::latex::canonical(n) == argument);
        match self.names.whole.get(&undotted) {
            Some(Node::Symbol(s)) => among(&self.symbols[*s].arguments),
            Some(Node::Matrix(m)) => among(&self.matrices[*m].arguments),
            // A name that an equation defines is a function of whatever its letters are.
            _ => {
                self.arguments.contains(argument)
                    || self.times.contains(argument)
                    || self.is_vector(argument)
            }
        }
    }
}

impl Equation {
    /// The number of a link: the label, and the link's own number where there are several.
    pub fn number_of(&self, member: usize) -> String {
        match self.links.len() {
            0 | 1 => self.label.clone(),
            _ => format!("{}.{member}", self.label),
        }
    }

    /// The verdict that the document records for a link.
    pub fn expected(&self, member: usize) -> Option<VerdictWord> {
        self.settings.expected(member)
    }
}

/// Whether two lists of arguments name the same letters in the same order.
fn same_letters(head: &[Expr], arguments: &[Expr]) -> bool {
    let letter = |e: &Expr| match &e.kind {
        ExprKind::Name(name) => Some(crate::latex::canonical(name)),
        _ => None,
    };
    head.len() == arguments.len()
        && head
            .iter()
            .zip(arguments)
            .all(|(a, b)| letter(a).is_some() && letter(a) == letter(b))
}
