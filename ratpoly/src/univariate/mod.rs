//! Dense polynomials in one variable, as slices of coefficients with the constant term first.
//!
//! * [`modular`]: arithmetic, gcd, evaluation and interpolation over a [`PrimeField`](crate::modular::PrimeField);
//! * [`factor_modular`]: distinct-degree and equal-degree factorisation over a prime field;
//! * [`integer`]: the little that is needed over the integers;
//! * [`hensel`]: lifting a factorisation from p to a power of p;
//! * [`zassenhaus`]: factorisation over the integers.
//!
//! The zero polynomial is the empty slice; a non-zero polynomial ends with a non-zero coefficient.

pub mod factor_modular;
pub mod hensel;
pub mod integer;
pub mod modular;
pub mod zassenhaus;
