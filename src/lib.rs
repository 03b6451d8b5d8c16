//! Re-derives published equations exactly.

pub mod diagnostic;
pub mod document;
pub mod expr;
pub mod span;
