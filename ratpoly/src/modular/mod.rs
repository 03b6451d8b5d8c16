//! Arithmetic modulo primes of word size, and the way back to the integers.
//!
//! The gcd and the factorisation work on images modulo a prime of 62 bits: no coefficient grows, an
//! operation is a few machine instructions, and an accident (an unlucky prime or evaluation point) has a
//! chance of about degree / 2⁶². An accident can cost time, never truth: what comes back is checked over
//! the integers.
//!
//! * [`PrimeField`]: the field, its elements in Montgomery form;
//! * [`is_prime`], [`primes_below`], [`two_adic_primes`]: deterministic sequences of primes;
//! * [`ChineseRemainder`], [`rational_reconstruction`]: from residues to integers and fractions;
//! * [`BerlekampMassey`], [`subgroup_logarithms`], [`solve_transposed_vandermonde`]: the three steps of
//!   sparse interpolation after Ben-Or and Tiwari.

mod chinese_remainder;
mod evaluation;
mod field;
mod primes;
mod sparse_interpolation;

pub use chinese_remainder::{ChineseRemainder, rational_reconstruction};
pub(crate) use evaluation::{PowerTable, random_elements};
pub use field::PrimeField;
pub use primes::{is_prime, primes_below, two_adic_primes};
pub use sparse_interpolation::{
    BerlekampMassey, solve_transposed_vandermonde, subgroup_logarithms,
};
