//! Why an expression has no value at a point, or none that was found.
//!
//! What certainly has no value there (a quotient by zero, a function outside of its range) is told
//! apart from what more digits may settle and from what this evaluator does not know.

use crate::span::Span;

/// An expression without a value, and where.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct NoValue {
    /// Why.
    pub reason: Reason,
    /// Where.
    pub span: Span,
}

/// Why there is no value.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Reason {
    /// There certainly is none.
    Undefined(Undefined),
    /// An interval is too wide to tell; with more digits it may be told.
    Imprecise(Undefined),
    /// The evaluator does not know how to compute it.
    Unsupported(&'static str),
    /// It costs more than it may.
    Budget(&'static str),
    /// The shapes of two values do not fit.
    Shape {
        /// Which operation.
        operation: &'static str,
        /// Rows and columns of the left value; none for zero of any shape.
        left: Option<(usize, usize)>,
        /// Rows and columns of the right one.
        right: Option<(usize, usize)>,
    },
    /// A name means nothing.
    Undeclared(String),
    /// An index lies outside of what it counts.
    Outside(Vec<i64>),
    /// A definition needs itself.
    Cyclic,
    /// The equations of a system are not linear in their unknowns.
    NotLinear,
}

/// What it is that a number lacks.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Undefined {
    /// A divisor is zero.
    Divisor,
    /// The logarithm of zero or of a negative number.
    Logarithm,
    /// A power such as 0 to the 0, or of a negative number with an exponent that is no integer.
    Power,
    /// A complex number on the cut of a root or logarithm.
    Cut,
    /// A derivative where there is none, as of |x| at 0.
    Derivative,
    /// An argument outside of the range that a definition is given for.
    Range,
    /// No case of a definition by cases applies.
    Cases,
    /// A matrix without an inverse, or equations without exactly one solution.
    Singular,
    /// A covariance that would not be positive semidefinite.
    Covariance,
    /// A number beyond all that is computed with.
    Size,
}

impl Reason {
    /// The same at a place.
    pub fn at(self, span: Span) -> NoValue {
        NoValue { reason: self, span }
    }

    /// Whether there certainly is no value.
    pub fn is_certain(&self) -> bool {
        match self {
            Reason::Undefined(_) | Reason::Outside(_) => true,
            Reason::Imprecise(_)
            | Reason::Unsupported(_)
            | Reason::Budget(_)
            | Reason::Shape { .. }
            | Reason::Undeclared(_)
            | Reason::Cyclic
            | Reason::NotLinear => false,
        }
    }

    /// The same where a lack that is certain of a part makes the whole only doubtful.
    #[must_use]
    pub fn doubtful(self) -> Reason {
        match self {
            Reason::Undefined(lack) => Reason::Imprecise(lack),
            Reason::Imprecise(_)
            | Reason::Unsupported(_)
            | Reason::Budget(_)
            | Reason::Shape { .. }
            | Reason::Undeclared(_)
            | Reason::Outside(_)
            | Reason::Cyclic
            | Reason::NotLinear => self,
        }
    }

    /// The same where what lacks is named otherwise: of the power, and not of the logarithm in it.
    #[must_use]
    pub fn renamed(self, from: Undefined, to: Undefined) -> Reason {
        if self == Reason::Undefined(from) {
            Reason::Undefined(to)
        } else if self == Reason::Imprecise(from) {
            Reason::Imprecise(to)
        } else {
            self
        }
    }

    /// Whether more digits may help.
    pub fn is_imprecise(&self) -> bool {
        matches!(self, Reason::Imprecise(_))
    }
}
