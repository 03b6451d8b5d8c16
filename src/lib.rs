//! Re-derives published equations exactly.
//!
//! A [`document`] (Markdown with the equations as printed, in LaTeX) becomes a [`model`]: its names
//! bound to symbols, definitions and unknowns. The model is [evaluated](evaluate) over the rational
//! functions in its letters, [checked](check) link by link, and each link gets a [`verdict`] with a
//! certificate. [`audit`] is the whole way.
//!
//! ```text
//! proofs/<paper>/*.md --document--> fences --latex--> Expr --model--> names, links
//!    Expr --evaluate--> exact values --check--> Verdict + Certificate --+
//!    Expr --numeric---> floating point -----comparison--> digits -------+--> report
//! ```
//!
//! What is kept everywhere: no float decides a verdict; the exact and the floating-point route meet
//! only in [`expr`] and in [`comparison`]; unknown is never a pass; every division leaves a
//! condition; the same input gives the same bytes.
//!
//! Words: a *display* is what stands under one number, a *clause* one equation or chain of it, a
//! *link* two neighbours of a chain, a *member* a link's number. An *abbreviation* is a scalar
//! defined by arithmetic on declared symbols; it stays a letter until its definition is needed.
//! A declared matrix is a *matrix of letters*; an *instance* is a choice of the numbers that sizes
//! depend on, and a verdict is the common one of all instances or the worst.

pub mod audit;
pub mod check;
pub mod cli;
pub mod comparison;
pub mod diagnostic;
pub mod document;
pub mod domain;
pub mod embedded;
pub mod enclose;
pub mod evaluate;
pub mod expr;
pub mod figure;
pub mod functions;
pub mod harness;
pub mod input;
pub mod inspection;
pub mod latex;
pub mod matrix;
pub mod methods;
pub mod model;
pub mod mutation;
pub mod numeric;
pub mod paper;
pub mod progress;
pub mod real;
pub mod report;
pub mod span;
mod stack;
pub mod standing;
pub mod theory;
pub mod unit;
pub mod verdict;

/// The README's Rust examples, compiled as documentation tests.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
