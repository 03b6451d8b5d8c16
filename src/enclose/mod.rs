//! The meaning of expressions at a point, enclosed with certainty.
//!
//! A second route from the syntax tree to values, which shares nothing with the exact engine but the
//! tree and what names mean: an [`Evaluator`] over a [`World`] computes with certified intervals
//! ([`crate::real`]) at a [`Point`] that satisfies everything that a document declares and supposes. What
//! it finds apart is apart; what overlaps proves nothing; what has no value says why.

#![warn(clippy::wildcard_enum_match_arm)]

mod apply;
mod arithmetic;
mod blocks;
mod challenge;
mod compare;
mod degrees;
mod elementary;
mod elimination;
mod evaluator;
mod expectation;
mod failure;
mod integral;
mod jet;
mod letters;
mod names;
mod point;
mod points;
mod roots;
mod shown;
mod solved;
mod stable;
mod unknowns;
mod value;
mod world;

pub use apply::Truth;
pub use arithmetic::Arithmetic;
pub use challenge::{Budget, Challenge, challenge};
pub use evaluator::Evaluator;
pub use failure::{NoValue, Reason, Undefined};
pub use jet::Jet;
pub use point::Point;
pub use points::{NoPoint, Points};
pub use shown::{Comparison, Shown};
pub use value::Value;
pub use world::World;
