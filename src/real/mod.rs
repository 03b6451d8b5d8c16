//! Certified real and complex numbers: what is computed encloses what is meant.
//!
//! Rational numbers stay exact while they are short; everything else is an interval with dyadic ends,
//! rounded outwards to the binary digits that the caller asks for, so that a caller can begin with
//! few and ask for more. Nothing here knows of expressions, and no result is a guess: where a value
//! cannot be enclosed, there is none.

pub mod complex;
pub mod decimal;
pub mod dyadic;
mod fraction;
pub mod functions;
pub mod interval;
pub mod number;
pub mod series;

pub use complex::Complex;
pub use interval::Interval;
pub use number::Real;
