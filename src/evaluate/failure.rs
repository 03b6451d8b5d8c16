//! Why an expression has no value.

use crate::diagnostic::{Diagnostic, DiagnosticKind};
use crate::expr::Sign;
use crate::functions::Impossible;
use crate::span::Span;
use crate::verdict::Misfit;

/// An evaluation that came to nothing, and where.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Failure {
    /// Why.
    pub kind: FailureKind,
    /// Where.
    pub span: Span,
}

/// Why an expression has no value.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum FailureKind {
    /// Shapes that do not fit.
    Shape {
        /// What was being done.
        operation: String,
        /// The left operand.
        left: String,
        /// The right operand.
        right: String,
    },
    /// A divisor that is zero identically.
    DivisionByZero,
    /// An exponent or index that is no integer or too large.
    Exponent {
        /// As printed.
        exponent: String,
        /// The limit.
        limit: u32,
    },
    /// A member of a family, or an entry, that does not exist.
    Outside {
        /// The name with its indices' values.
        name: String,
    },
    /// A name with two meanings.
    Ambiguous {
        /// The name.
        name: String,
    },
    /// A name without a meaning.
    Undeclared {
        /// The name.
        name: String,
    },
    /// A definition whose value needs itself.
    NeedsItself,
    /// A covariance whose system has no stationary state.
    NotStationary,
    /// An equation to be solved that is not linear in its unknowns.
    NotLinear,
    /// An equation to be solved with more than one solution.
    Underdetermined,
    /// An equation to be solved with no solution.
    Inconsistent,
    /// A limit was hit.
    Budget {
        /// Of what.
        what: String,
    },
    /// What an exact computation may cost was spent.
    Exhausted {
        /// What ran out, in words.
        what: String,
    },
    /// An integral without a value, whatever admitted values the letters have.
    Divergent {
        /// Why.
        reason: String,
        /// The sign of the infinity that it grows to, if it is known to grow to one.
        towards: Option<Sign>,
    },
    /// Outside of what is decided here.
    Unsupported {
        /// What.
        what: String,
    },
}

impl Failure {
    /// A failure at a place.
    pub fn new(kind: FailureKind, span: Span) -> Self {
        Failure { kind, span }
    }

    /// The failure of an operation with functions.
    pub fn impossible(why: Impossible, span: Span) -> Self {
        let kind = match why {
            Impossible::Unsupported(what) => FailureKind::Unsupported { what },
            Impossible::Divergent { reason, towards } => FailureKind::Divergent { reason, towards },
            Impossible::DivisionByZero => FailureKind::DivisionByZero,
            Impossible::NoLetter => FailureKind::Budget {
                what: "different functions".into(),
            },
        };
        Failure::new(kind, span)
    }

    /// A failure because something lies outside of what is decided.
    pub fn unsupported(what: &str, span: Span) -> Self {
        Failure::new(FailureKind::Unsupported { what: what.into() }, span)
    }

    /// Whether what is printed certainly has no value there: it divides by zero, or an argument lies outside of
    /// the range of a definition.
    pub(crate) fn is_without_value(&self) -> bool {
        match &self.kind {
            FailureKind::DivisionByZero => true,
            FailureKind::Unsupported { what } => what == super::cases::OUTSIDE_OF_RANGE,
            FailureKind::Shape { .. }
            | FailureKind::Outside { .. }
            | FailureKind::Exponent { .. }
            | FailureKind::Ambiguous { .. }
            | FailureKind::Undeclared { .. }
            | FailureKind::NeedsItself
            | FailureKind::NotStationary
            | FailureKind::NotLinear
            | FailureKind::Underdetermined
            | FailureKind::Inconsistent
            | FailureKind::Budget { .. }
            | FailureKind::Exhausted { .. }
            | FailureKind::Divergent { .. } => false,
        }
    }

    /// The shapes that do not fit, if that is why.
    pub fn misfit(&self) -> Option<Misfit> {
        if let FailureKind::Shape {
            operation,
            left,
            right,
        } = &self.kind
        {
            return Some(Misfit {
                operation: operation.clone(),
                left: left.clone(),
                right: right.clone(),
                span: self.span,
            });
        }
        None
    }

    /// The diagnostic for a failure that makes a document unusable; `None` for one that only
    /// leaves a claim undecided (a limit, a divisor that is zero, something unsupported) or refutes it
    /// (an index outside).
    pub fn diagnostic(&self) -> Option<Diagnostic> {
        let kind = match self.kind.clone() {
            FailureKind::Shape {
                operation,
                left,
                right,
            } => DiagnosticKind::ShapeMismatch {
                operation,
                left,
                right,
            },
            FailureKind::Exponent { exponent, limit } => {
                DiagnosticKind::Exponent { exponent, limit }
            }
            FailureKind::Ambiguous { name } => DiagnosticKind::Ambiguous {
                readings: vec![
                    format!("{name} with one index"),
                    format!("{name} with an index for each digit"),
                ],
            },
            FailureKind::Undeclared { name } => DiagnosticKind::UndeclaredName { name },
            // What these spoil is the place where they stand and what rests on it, and no more.
            FailureKind::DivisionByZero
            | FailureKind::Outside { .. }
            | FailureKind::NeedsItself
            | FailureKind::NotStationary
            | FailureKind::NotLinear
            | FailureKind::Underdetermined
            | FailureKind::Inconsistent
            | FailureKind::Budget { .. }
            | FailureKind::Exhausted { .. }
            | FailureKind::Divergent { .. }
            | FailureKind::Unsupported { .. } => return None,
        };
        Some(Diagnostic::new(kind, self.span))
    }
}
