//! No false verdict, ever: generated claims whose truth is known by construction or by an
//! independent evaluator, one family of relatives a module.

#[allow(dead_code)]
mod common;

#[path = "soundness/dots.rs"]
mod dots;
#[path = "soundness/expectations.rs"]
mod expectations;
#[path = "soundness/sizes.rs"]
mod sizes;
#[path = "soundness/zero.rs"]
mod zero;
