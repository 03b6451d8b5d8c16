//! Dense polynomials in one variable, as slices of coefficients with the constant term first.
//!
//! * [`modular`]: arithmetic, gcd, evaluation and interpolation over a [`PrimeField`](crate::modular::PrimeField).
//!
//! The zero polynomial is the empty slice; a non-zero polynomial ends with a non-zero coefficient.

pub mod modular;
