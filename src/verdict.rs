//! What the checker says of a link, and what it says it with.
//!
//! A verdict is a value; a failure to reach one is another type. What is said true carries a [`Proof`],
//! which only [`Certificate::verify`] makes; what is said false carries a [`Refutation`].

pub mod certificate;
mod correction;
mod refutation;
pub mod statement;

pub use certificate::{Certificate, Proof};
pub use correction::{Changed, Correction, Edit, EditClass, Preferred, Proposal, Rejected};
pub use refutation::{
    CounterProof, Ended, Misfit, Part, PointValue, Refutation, Searched, Shown, SignCondition,
    Structure, Witness,
};

use crate::document::VerdictWord;
use crate::evaluate::Origin;
use crate::functions::FunctionTable;
use ratpoly::{Polynomial, RationalFunction};

/// The verdict on one link of a chain.
#[derive(Clone, Debug)]
pub enum Verdict {
    /// An identity.
    Holds {
        /// Labels of the definitions that had to be inserted, none for an identity in the printed
        /// letters.
        by: Vec<String>,
        /// What proves it.
        proof: Proof,
    },
    /// True only under a relation, and what proves that.
    HoldsGiven(Box<Given>, Proof),
    /// False as printed, true as corrected.
    Misprint {
        /// Why it is false.
        refutation: Refutation,
        /// What makes it true.
        correction: Box<Correction>,
    },
    /// False, and no correction is known.
    Refuted(Refutation),
    /// A limit was hit, or it lies outside of what is decided here.
    Undecided {
        /// Which.
        reason: String,
    },
    /// Gives a name its value: nothing to check.
    Definition {
        /// What it defines.
        what: String,
    },
    /// Stated only.
    Recalled {
        /// Why there is nothing to check.
        reason: String,
    },
}

impl Verdict {
    /// The word for it.
    pub fn word(&self) -> VerdictWord {
        match self {
            Verdict::Holds { .. } => VerdictWord::Holds,
            Verdict::HoldsGiven(..) => VerdictWord::HoldsGiven,
            Verdict::Misprint { .. } => VerdictWord::Misprint,
            Verdict::Refuted(_) => VerdictWord::Refuted,
            Verdict::Undecided { .. } => VerdictWord::Undecided,
            Verdict::Definition { .. } => VerdictWord::Definition,
            Verdict::Recalled { .. } => VerdictWord::Recalled,
        }
    }
}

/// One entry of left minus right.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ResidualEntry {
    /// Values of the running indices, as in `p = 4`.
    pub indices: Vec<(String, i64)>,
    /// Row and column from 1, for a matrix with more than one entry.
    pub place: Option<(usize, usize)>,
    /// The left side's entry.
    pub left: RationalFunction,
    /// The right side's entry.
    pub right: RationalFunction,
}

impl ResidualEntry {
    /// Left minus right.
    pub fn difference(&self) -> RationalFunction {
        &self.left - &self.right
    }
}

/// A hypothesis that the printed equation needs.
#[derive(Clone, Debug)]
pub struct Given {
    /// The relations: polynomials that vanish, in the printed letters.
    pub relations: Vec<Polynomial>,
    /// Other hypotheses that the document states and that are needed, in LaTeX: inequalities, and
    /// equations between other things than polynomials.
    pub stated: Vec<String>,
    /// Labels of the definitions that imply them; empty when nothing in the document does.
    pub implied_by: Vec<String>,
    /// For each entry that is not an identity: left minus right = sum of cofactor times relation.
    pub cofactors: Vec<GivenEntry>,
    /// A point in the printed letters, off the relations, where the equation is false.
    pub counterexample: Option<Witness>,
    /// A point at which the relations hold, where neither the document states them nor its definitions
    /// imply them.
    pub instance: Option<Witness>,
}

impl Given {
    /// Whether it is only offered: nothing in the document states or implies it.
    pub fn is_offered(&self) -> bool {
        self.instance.is_some()
    }
}

/// How one entry of the residual follows from the relations.
#[derive(Clone, Debug)]
pub struct GivenEntry {
    /// The entry.
    pub entry: ResidualEntry,
    /// One cofactor for each relation.
    pub cofactors: Vec<RationalFunction>,
}

/// A divisor that must not vanish, and why it does not.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct NonVanishing {
    /// The irreducible factor.
    pub factor: Polynomial,
    /// Where it comes from.
    pub origin: Origin,
    /// Why it cannot vanish, if that is known.
    pub because: Option<Because>,
}

/// Why something cannot vanish.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Because {
    /// All its letters are positive and so are all its coefficients.
    Positive,
    /// So it is once the definitions of these labels are inserted.
    PositiveBy(Vec<String>),
    /// It is a principal minor of the matrix of this name, which is declared positive definite.
    Definite(String),
    /// By its sign for all values of the letters, or that of its squared modulus.
    Sign,
    /// By the hypotheses.
    Supposed,
}

/// Why something is positive.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Positivity {
    /// A number that is a quadratic form in derivatives of processes: positive unless they vanish.
    pub form: bool,
    /// What shows it.
    pub by: PositiveBy,
}

/// What shows that something is positive.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum PositiveBy {
    /// It is a positive multiple of the matrix of this name, which is declared positive definite.
    Declared(String),
    /// So many leading principal minors are positive.
    Minors(usize),
    /// All principal minors of a matrix of this order are not negative.
    PrincipalMinors(usize),
    /// It is made of definite matrices by sums, positive multiples, congruences and inverses.
    Structure,
    /// So many Hurwitz determinants are positive.
    Hurwitz(usize),
    /// Its sign for all values of the letters.
    Sign,
}

/// An earlier link of the same equation whose correction changes a side of a later one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct After {
    /// The number of that link.
    pub member: usize,
    /// Whether the later link is true with both of its sides as printed.
    pub true_as_printed: bool,
}

/// How the program contradicts itself.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Contradiction {
    /// A certificate does not verify.
    Certificate,
    /// The sides are apart at a point, by enclosures that share nothing with what proved them equal.
    Challenge(Box<Witness>),
}

/// Everything that was found out about one link.
#[derive(Clone, Debug)]
pub struct Outcome {
    /// The equation, as an index into the model.
    pub equation: usize,
    /// The link's number within it, from 1.
    pub member: usize,
    /// The verdict.
    pub verdict: Verdict,
    /// The divisors that must not vanish.
    pub conditions: Vec<NonVanishing>,
    /// Whether the program contradicts itself here: a certificate that does not verify, or a point at
    /// which a second route finds apart what was proved equal.
    pub contradiction: Option<Contradiction>,
    /// Why an inequality holds.
    pub positivity: Option<Positivity>,
    /// An earlier link whose correction changed a side of it: where it is false, or holds with that only.
    pub after: Option<After>,
    /// The other equations that it was judged with as corrected: as printed it is not seen to hold.
    pub corrected: Vec<usize>,
    /// The hypotheses printed around the equation that were used, in LaTeX.
    pub assumed: Vec<String>,
    /// The instances at which something was seen to hold that depends on their sizes and was proved at
    /// these only; none where the proof is free of sizes.
    pub sizes: Option<Vec<usize>>,
    /// The instances of the model for which the verdict is this one: all, or those for which it is
    /// worst.
    pub instances: Vec<usize>,
    /// What the letters of functions stand for in all of this, where the reserve of the model was given to
    /// other functions since; else they stand for what they do in the model.
    pub letters: Option<FunctionTable>,
}

impl Verdict {
    /// What proves it, where it is said to be true, or true as corrected.
    pub fn proof(&self) -> Option<&Proof> {
        match self {
            Verdict::Holds { proof, .. } => Some(proof),
            Verdict::HoldsGiven(_, proof) => Some(proof),
            Verdict::Misprint { correction, .. } => Some(&correction.proof),
            Verdict::Refuted(_)
            | Verdict::Undecided { .. }
            | Verdict::Definition { .. }
            | Verdict::Recalled { .. } => None,
        }
    }
}
