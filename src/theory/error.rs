//! Why the theory has no answer: each refusal with what offends.

use std::fmt;

/// Why something of the theory does not exist for this input.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum TheoryError {
    /// A matrix of another shape was needed, as (rows, columns).
    Shape {
        /// Which matrix.
        matrix: &'static str,
        /// What was needed.
        expected: (usize, usize),
        /// What was given.
        found: (usize, usize),
    },
    /// A matrix that must be its own transpose is not.
    NotSymmetric {
        /// Which matrix.
        matrix: &'static str,
        /// The first place, from 1, that differs from its mirror image.
        place: (usize, usize),
    },
    /// A matrix that must be its own negative transpose is not.
    NotSkew {
        /// Which matrix.
        matrix: &'static str,
        /// The first place, from 1, that is not the negative of its mirror image.
        place: (usize, usize),
    },
    /// A symmetric matrix with a leading principal minor that is not positive.
    NotPositiveDefinite {
        /// Which matrix.
        matrix: &'static str,
        /// The order of the minor.
        order: usize,
        /// The minor.
        minor: String,
    },
    /// No stationary state: an eigenvalue does not lie in the open left half plane.
    Unstable {
        /// Which matrix.
        matrix: &'static str,
        /// The order of the first Hurwitz determinant that is not positive.
        order: usize,
        /// That determinant.
        determinant: String,
    },
    /// An output that follows white noise itself: the variance is infinite.
    Improper {
        /// The degree of the transfer function's numerator.
        numerator: usize,
        /// That of its denominator, which is not larger.
        denominator: usize,
    },
    /// A quantity that must be positive, such as a speed, is not.
    NotPositive {
        /// Which quantity.
        quantity: &'static str,
        /// Its value.
        value: String,
    },
    /// The sign of a quantity with letters is not the same for all positive values of the letters,
    /// or could not be found.
    UnknownSign {
        /// The quantity.
        quantity: String,
    },
    /// No unique solution: two eigenvalues have the sum zero.
    Singular,
    /// A limit of the exact engine was hit.
    Budget,
}

impl fmt::Display for TheoryError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            TheoryError::Shape {
                matrix,
                expected,
                found,
            } => write!(
                f,
                "{matrix} is {}x{}, but {}x{} is needed",
                found.0, found.1, expected.0, expected.1
            ),
            TheoryError::NotSymmetric {
                matrix,
                place: (i, j),
            } => write!(
                f,
                "{matrix} is not symmetric: its entries ({i},{j}) and ({j},{i}) differ"
            ),
            TheoryError::NotSkew {
                matrix,
                place: (i, j),
            } => write!(
                f,
                "{matrix} is not skew-symmetric at ({i},{j}): the entry is not minus its mirror image"
            ),
            TheoryError::NotPositiveDefinite {
                matrix,
                order,
                minor,
            } => write!(
                f,
                "{matrix} is not positive definite: its leading minor of order {order} is {minor}"
            ),
            TheoryError::Unstable {
                matrix,
                order,
                determinant,
            } => write!(
                f,
                "no stationary covariance: {matrix} is not stable, its Hurwitz determinant H_{order} is {determinant}"
            ),
            TheoryError::Improper {
                numerator,
                denominator,
            } => write!(
                f,
                "infinite variance: the transfer function is not strictly proper (degree {numerator} over {denominator})"
            ),
            TheoryError::NotPositive { quantity, value } => {
                write!(f, "{quantity} must be positive, but is {value}")
            }
            TheoryError::UnknownSign { quantity } => write!(
                f,
                "{quantity} does not have one sign for all positive letters, or it could not be found"
            ),
            TheoryError::Singular => {
                f.write_str("no unique solution: two eigenvalues have the sum zero")
            }
            TheoryError::Budget => f.write_str("a limit of the exact engine was hit"),
        }
    }
}

impl std::error::Error for TheoryError {}
