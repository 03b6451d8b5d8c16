//! What a check of the units finds.

use crate::expr::Name;
use crate::span::Span;
use std::fmt;

/// A place where dimensions do not fit.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct UnitFinding {
    /// The equation's label.
    pub label: String,
    /// What does not fit.
    pub site: UnitSite,
    /// The dimension found there, in SI base units.
    pub found: String,
    /// The dimension that its neighbours have, in SI base units.
    pub expected: String,
    /// Where.
    pub span: Span,
    /// Names in this equation that come from equations with findings of their own.
    pub suspects: Vec<Name>,
}

/// What does not fit to its neighbours.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum UnitSite {
    /// A term of a sum.
    Term,
    /// A member of a chain, counted from 1.
    Member(usize),
    /// An entry of a matrix in a sum.
    TermEntry {
        /// Row, from 1.
        row: usize,
        /// Column, from 1.
        column: usize,
    },
    /// An entry of a matrix that is a member of a chain.
    MemberEntry {
        /// The member, from 1.
        member: usize,
        /// Row, from 1.
        row: usize,
        /// Column, from 1.
        column: usize,
    },
    /// A term of the sum that makes up an entry of a matrix product.
    ProductTerm {
        /// Row, from 1.
        row: usize,
        /// Column, from 1.
        column: usize,
        /// Which term, from 1.
        term: usize,
    },
    /// An entry of a matrix whose determinant, inverse or eigenvalues are taken.
    DeterminantEntry {
        /// Row, from 1.
        row: usize,
        /// Column, from 1.
        column: usize,
    },
    /// The argument of a function that takes pure numbers, or of a function of a declared letter.
    Argument,
    /// An exponent.
    Exponent,
    /// The expression is too large for its units to be checked.
    TooLarge,
}

impl fmt::Display for UnitSite {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            UnitSite::Term => f.write_str("a term"),
            UnitSite::Member(member) => write!(f, "member {member}"),
            UnitSite::TermEntry { row, column } => write!(f, "entry ({row},{column}) of a term"),
            UnitSite::MemberEntry {
                member,
                row,
                column,
            } => write!(f, "entry ({row},{column}) of member {member}"),
            UnitSite::ProductTerm { row, column, term } => {
                write!(
                    f,
                    "term {term} of entry ({row},{column}) of a matrix product"
                )
            }
            UnitSite::DeterminantEntry { row, column } => write!(
                f,
                "entry ({row},{column}) of a matrix whose determinant is taken"
            ),
            UnitSite::Argument => f.write_str("the argument of a function"),
            UnitSite::Exponent => f.write_str("an exponent"),
            UnitSite::TooLarge => f.write_str("an expression too large to check"),
        }
    }
}

/// `entry (3,1) of member 2 has 1/s^3, its neighbours 1/s^2`.
impl fmt::Display for UnitFinding {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.site == UnitSite::TooLarge {
            return write!(f, "{}", self.site);
        }
        let neighbours = match self.site {
            UnitSite::Argument | UnitSite::Exponent => "but must have",
            UnitSite::Term
            | UnitSite::Member(_)
            | UnitSite::TermEntry { .. }
            | UnitSite::MemberEntry { .. }
            | UnitSite::ProductTerm { .. }
            | UnitSite::DeterminantEntry { .. }
            | UnitSite::TooLarge => "its neighbours",
        };
        write!(
            f,
            "{} has {}, {neighbours} {}",
            self.site, self.found, self.expected
        )
    }
}
