//! What can go wrong: one flat, typed enumeration for the whole crate.

use std::fmt;

/// A failure of an operation on polynomials. Never a statement about their values.
#[derive(Debug, Clone, PartialEq, Eq)]
#[non_exhaustive]
pub enum Error {
    /// Two operands belong to different rings.
    RingMismatch,
    /// A divisor, denominator or modulus is zero.
    DivisionByZero,
    /// An exponent would pass the largest one that a monomial can hold.
    ExponentOverflow,
    /// A ring has no variable of this name.
    UnknownVariable(String),
    /// A variable index is not below the number of variables of the ring.
    VariableOutOfRange(usize),
    /// The same variable was named twice.
    DuplicateVariable(String),
    /// A variable name is not an identifier of the plain notation.
    InvalidVariableName(String),
    /// A list (of values, exponents, images) has the wrong length.
    WrongLength {
        /// What the operation needs.
        expected: usize,
        /// What was given.
        found: usize,
    },
    /// A matrix that must be invertible has the determinant zero.
    SingularMatrix,
    /// A limit of the [`Budget`](crate::Budget) was reached.
    BudgetExceeded(Resource),
    /// Text is not a polynomial in the plain notation.
    Parse {
        /// Byte offset in the text.
        position: usize,
        /// What is wrong there.
        kind: ParseErrorKind,
    },
    /// The operands do not satisfy what the operation requires, named by the text.
    Unsupported(&'static str),
}

/// What a [`Budget`](crate::Budget) limits.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Resource {
    /// The number of terms of one polynomial.
    Terms,
    /// The bits of one coefficient.
    Bits,
    /// The elementary steps of a whole computation.
    Steps,
}

/// What is wrong with a text.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum ParseErrorKind {
    /// A number, a name or an opening bracket should stand here.
    ExpectedOperand,
    /// A character that has no meaning here.
    UnexpectedCharacter,
    /// A name that is no variable of the ring.
    UnknownVariable,
    /// A bracket without its partner.
    UnbalancedBracket,
    /// After `^` stands no number, or one that is too large.
    InvalidExponent,
    /// The divisor is zero.
    DivisionByZero,
    /// The text denotes a rational function where a polynomial over the integers is wanted.
    NotAPolynomial,
    /// Brackets are nested too deep, or the value grows too large.
    TooLarge,
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Error::RingMismatch => write!(f, "the operands belong to different rings"),
            Error::DivisionByZero => write!(f, "division by zero"),
            Error::ExponentOverflow => write!(f, "an exponent is too large"),
            Error::UnknownVariable(name) => write!(f, "the ring has no variable `{name}`"),
            Error::VariableOutOfRange(index) => {
                write!(f, "the ring has no variable number {index}")
            }
            Error::DuplicateVariable(name) => write!(f, "the variable `{name}` is named twice"),
            Error::InvalidVariableName(name) => write!(f, "`{name}` is not a variable name"),
            Error::WrongLength { expected, found } => {
                write!(f, "{expected} items are needed, {found} were given")
            }
            Error::SingularMatrix => write!(f, "the matrix is singular"),
            Error::BudgetExceeded(Resource::Terms) => write!(f, "too many terms"),
            Error::BudgetExceeded(Resource::Bits) => write!(f, "a coefficient has too many bits"),
            Error::BudgetExceeded(Resource::Steps) => write!(f, "too many steps"),
            Error::Parse { position, kind } => write!(f, "at byte {position}: {kind}"),
            Error::Unsupported(what) => write!(f, "{what}"),
        }
    }
}

impl fmt::Display for ParseErrorKind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            ParseErrorKind::ExpectedOperand => "a number, a name or an opening bracket is missing",
            ParseErrorKind::UnexpectedCharacter => "unexpected character",
            ParseErrorKind::UnknownVariable => "unknown variable",
            ParseErrorKind::UnbalancedBracket => "unbalanced bracket",
            ParseErrorKind::InvalidExponent => "invalid exponent",
            ParseErrorKind::DivisionByZero => "division by zero",
            ParseErrorKind::NotAPolynomial => "not a polynomial with integer coefficients",
            ParseErrorKind::TooLarge => "the expression is too large",
        })
    }
}

impl std::error::Error for Error {}
