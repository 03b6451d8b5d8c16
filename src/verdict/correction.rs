//! What would make a false equation true: the changes, and the proof of what they make of it.

use super::Given;
use super::certificate::Proof;
use super::refutation::{Misfit, Witness};
use crate::expr::Display;
use crate::span::Span;

/// What kind of slip an edit repairs.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum EditClass {
    /// A plus for a minus.
    Sign,
    /// An integer factor or literal.
    Factor,
    /// An exponent.
    Exponent,
    /// An index.
    Index,
    /// One letter for another.
    Letter,
    /// A lost or superfluous dot.
    Dot,
    /// A lost or superfluous term or factor.
    Term,
    /// A bracket, a bar's, a slash's or a root's reach, the order of matrices.
    Bracket,
    /// A transposition or prime.
    Transpose,
    /// Numerator and denominator.
    Inversion,
    /// The measure of an integration or its limits.
    Measure,
    /// Where a limit is taken.
    Limit,
}

impl EditClass {
    /// The word for it.
    pub fn as_str(self) -> &'static str {
        match self {
            EditClass::Sign => "sign",
            EditClass::Factor => "factor",
            EditClass::Exponent => "exponent",
            EditClass::Index => "index",
            EditClass::Letter => "letter",
            EditClass::Dot => "dot",
            EditClass::Term => "term",
            EditClass::Bracket => "bracket",
            EditClass::Transpose => "transpose",
            EditClass::Inversion => "numerator and denominator",
            EditClass::Measure => "measure of integration",
            EditClass::Limit => "limit",
        }
    }
}

/// One change of a printed equation.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Edit {
    /// What kind.
    pub class: EditClass,
    /// Where, in the document.
    pub span: Span,
    /// As printed, in LaTeX.
    pub printed: String,
    /// As it should read, in LaTeX.
    pub corrected: String,
}

/// What a correction changes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Changed {
    /// The left side of the link.
    Left,
    /// The right side of the link.
    Right,
    /// An equation that defines what the link names, as an index into the model's equations.
    Definition(usize),
}

/// Why one of several corrections at the same cost comes first.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Preferred {
    /// The units of the others do not fit.
    Units,
    /// With it the matrices that a definition defines are symmetric, with the others not.
    Symmetry,
    /// With it so many other links of the same equation hold, with the others fewer.
    OtherLinks(usize),
    /// With it so many claims that rest on the equation hold, with the others fewer.
    LaterClaims(usize),
}

/// A correction beside the first.
#[derive(Clone, Debug)]
pub struct Proposal {
    /// The changes.
    pub edits: Vec<Edit>,
    /// The corrected display.
    pub display: Display,
    /// How far-fetched it is.
    pub cost: u32,
}

/// An edit of an equation that makes it true.
#[derive(Clone, Debug)]
pub struct Correction {
    /// The changes.
    pub edits: Vec<Edit>,
    /// The corrected display; as printed where a definition is corrected.
    pub display: Display,
    /// The definition that is corrected instead of the claim, and its corrected display.
    pub definition: Option<(usize, Display)>,
    /// What is changed.
    pub changed: Vec<Changed>,
    /// How far-fetched it is: ten times the rank of the class of each edit, and more for what is
    /// rarer.
    pub cost: u32,
    /// The relations that it still needs, if any, as in [`Given`].
    pub given: Option<Given>,
    /// What proves the corrected equation.
    pub proof: Proof,
    /// How many candidates were tried, this one included.
    pub tried: usize,
    /// How many would have been at most.
    pub budget: usize,
    /// How many candidates that cost no more could not be judged: where there are any, nobody knows whether it
    /// is the only one.
    pub unjudged: usize,
    /// Other corrections at the same cost.
    pub alternatives: Vec<Vec<Edit>>,
    /// All other corrections that were proved, these among them, the cheapest first.
    pub others: Vec<Proposal>,
    /// Why this one comes before the alternatives, where something says so.
    pub preferred: Option<Preferred>,
    /// What came of the other readings of the same places.
    pub rejected: Vec<Rejected>,
}

/// A reading that was tried and does not make the equation true.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Rejected {
    /// The changes that lead to it; none for the equation as printed.
    pub edits: Vec<Edit>,
    /// What does not exist in it, if anything.
    pub missing: Option<String>,
    /// Shapes in it that do not fit, if any.
    pub misfit: Option<Misfit>,
    /// Both sides at the reference point, if they have values and differ.
    pub witness: Option<Witness>,
}
