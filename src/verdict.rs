//! What the checker says of a link, and what it says it with.
//!
//! A verdict is a value; a failure to reach one is another type. Whatever a verdict claims can be
//! checked by multiplication alone: see [`Certificate::verify`].

pub mod statement;

use crate::document::VerdictWord;
use crate::evaluate::Origin;
use crate::expr::Display;
use crate::functions::quadratic::{Quadratic, reduce_polynomial};
use crate::span::Span;
use crate::theory::limit::Limit;
use num_rational::BigRational;
use ratpoly::{Polynomial, RationalFunction};

/// The verdict on one link of a chain.
#[derive(Clone, Debug)]
pub enum Verdict {
    /// An identity.
    Holds {
        /// Labels of the definitions that had to be inserted, none for an identity in the printed
        /// letters.
        by: Vec<String>,
    },
    /// True only under a relation.
    HoldsGiven(Box<Given>),
    /// False as printed, true as corrected.
    Misprint {
        /// Why it is false.
        refutation: Refutation,
        /// What makes it true.
        correction: Box<Correction>,
    },
    /// False, and no correction is known.
    Refuted(Refutation),
    /// A statement in words that is true only approximately.
    Loose {
        /// The number that shows how far.
        measure: BigRational,
        /// What the number is.
        meaning: String,
    },
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
            Verdict::HoldsGiven(_) => VerdictWord::HoldsGiven,
            Verdict::Misprint { .. } => VerdictWord::Misprint,
            Verdict::Refuted(_) => VerdictWord::Refuted,
            Verdict::Loose { .. } => VerdictWord::Loose,
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
    /// Labels of the definitions that imply them; empty when nothing in the document does.
    pub implied_by: Vec<String>,
    /// For each entry that is not an identity: left minus right = sum of cofactor times relation.
    pub cofactors: Vec<GivenEntry>,
    /// A point in the printed letters, off the relations, where the equation is false.
    pub counterexample: Option<Witness>,
}

/// How one entry of the residual follows from the relations.
#[derive(Clone, Debug)]
pub struct GivenEntry {
    /// The entry.
    pub entry: ResidualEntry,
    /// One cofactor for each relation.
    pub cofactors: Vec<RationalFunction>,
}

/// What is wrong with an equation beside a difference of its sides.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Flaw {
    /// A function's argument is not free in what defines it.
    Scope {
        /// The argument.
        argument: String,
        /// Whether an integral binds it; otherwise it does not occur.
        bound: bool,
        /// The letters that are left free instead.
        free: Vec<String>,
    },
    /// The limit is another one.
    Limit(Limit),
    /// The limit is taken elsewhere than at the printed argument.
    Elsewhere,
    /// A covariance of a system that has no stationary state.
    Unstable {
        /// The order of the first Hurwitz determinant that is not positive.
        order: usize,
        /// That determinant, at the reference values where there are such.
        determinant: String,
    },
}

/// Why an equation is false.
#[derive(Clone, Debug, Default)]
pub struct Refutation {
    /// What is wrong beside a difference of the sides.
    pub flaw: Option<Flaw>,
    /// Something that the equation names does not exist, such as `H_{0,1}`.
    pub missing: Option<String>,
    /// Shapes in the equation that do not fit; then there is no residual.
    pub misfit: Option<Misfit>,
    /// How far a correction was looked for in vain; none where it was not looked for or was found.
    pub searched: Option<Searched>,
    /// Left minus right, the entries that do not vanish. With something missing, as if it were zero.
    pub residual: Vec<ResidualEntry>,
    /// A point where the sides differ.
    pub witness: Option<Witness>,
    /// Where it is true all the same, if it is false only on a part of its domain.
    pub part: Option<Part>,
}

/// Where an equation or inequality is true that is false elsewhere.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Part {
    /// Where all conditions of one of these lists hold.
    Signs(Vec<Vec<SignCondition>>),
    /// At least around this point.
    Around(Vec<(usize, BigRational)>),
}

/// That a function is not negative, or not positive.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SignCondition {
    /// The function of the declared letters.
    pub function: Polynomial,
    /// Whether it is not positive.
    pub negative: bool,
}

/// An operation in an equation whose operands' shapes do not fit.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Misfit {
    /// What was being done, such as `*` or `=`.
    pub operation: String,
    /// The left operand's shape, such as `4x1`.
    pub left: String,
    /// The right operand's shape.
    pub right: String,
    /// Where.
    pub span: Span,
}

/// A point with exact values of both sides.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Witness {
    /// Letters of the ring that occur and their values.
    pub point: Vec<(usize, BigRational)>,
    /// The left side's entry there.
    pub left: BigRational,
    /// The right side's entry there.
    pub right: BigRational,
    /// Which entry.
    pub place: Option<(usize, usize)>,
    /// Values of the running indices.
    pub indices: Vec<(String, i64)>,
}

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

/// How many candidates for a correction were tried, and how many would have been at most.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Searched {
    /// Tried.
    pub tried: usize,
    /// The most.
    pub budget: usize,
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
    /// How many candidates were tried, this one included.
    pub tried: usize,
    /// How many would have been at most.
    pub budget: usize,
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
    /// So many Hurwitz determinants are positive.
    Hurwitz(usize),
    /// Its sign for all values of the letters.
    Sign,
}

/// What proves a verdict, checkable by multiplication.
#[derive(Clone, Debug, Default)]
pub struct Certificate {
    /// Pairs that are equal after the substitutions below.
    pub entries: Vec<ResidualEntry>,
    /// Letters of the ring and the values inserted for them.
    pub inserted: Vec<(usize, RationalFunction)>,
    /// The relations and, for each entry, the cofactors.
    pub relations: Vec<Polynomial>,
    /// For each entry, its cofactors; empty for an identity.
    pub cofactors: Vec<Vec<RationalFunction>>,
    /// The letters whose squares are known: i, roots, sines.
    pub quadratics: Vec<Quadratic>,
}

impl Certificate {
    /// Whether every entry is what the certificate claims, by multiplying out: no division, no gcd
    /// and no search is used.
    pub fn verify(&self) -> bool {
        self.entries.iter().enumerate().all(|(k, entry)| {
            let sides = [&entry.left, &entry.right].map(|side| side.substitute(&self.inserted));
            let [Ok(left), Ok(right)] = sides else {
                return false;
            };
            let (ln, ld) = (left.numerator(), left.denominator());
            let (rn, rd) = (right.numerator(), right.denominator());
            let mut numerator = &(ln * rd) - &(rn * ld);
            let mut denominator = ld * rd;
            for (relation, cofactor) in self
                .relations
                .iter()
                .zip(self.cofactors.get(k).map_or(&[][..], |c| c))
            {
                let term = &(cofactor.numerator() * relation) * &denominator;
                numerator = &(&numerator * cofactor.denominator()) - &term;
                denominator = &denominator * cofactor.denominator();
            }
            let numerator = reduce_polynomial(&numerator, &self.quadratics);
            let denominator = reduce_polynomial(&denominator, &self.quadratics);
            numerator.is_zero() && !denominator.is_zero()
        })
    }
}

/// An earlier link of the same equation whose correction changes a side of a later one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct After {
    /// The number of that link.
    pub member: usize,
    /// Whether the later link is true with both of its sides as printed.
    pub true_as_printed: bool,
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
    /// What proves it.
    pub certificate: Certificate,
    /// Why an inequality holds.
    pub positivity: Option<Positivity>,
    /// Where it is false, an earlier link whose correction changed a side of it.
    pub after: Option<After>,
    /// The hypotheses printed around the equation that were used, in LaTeX.
    pub assumed: Vec<String>,
    /// The instances of the model for which the verdict is this one: all, or those for which it is
    /// worst.
    pub instances: Vec<usize>,
}
