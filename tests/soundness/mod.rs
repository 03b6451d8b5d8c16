//! The generator of claims, the independent evaluator, and the run over all templates.

mod complex;
mod expression;
mod generator;
mod judge;
mod library;
mod polynomial;
mod program;
pub mod random;
mod run;
mod templates;
mod term;
mod truth;
