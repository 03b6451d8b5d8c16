//! Re-derives published equations exactly.

pub mod audit;
pub mod check;
pub mod comparison;
pub mod diagnostic;
pub mod document;
pub mod domain;
pub mod evaluate;
pub mod expr;
pub mod latex;
pub mod matrix;
pub mod model;
pub mod numeric;
pub mod span;
pub mod theory;
pub mod unit;
pub mod verdict;
