//! Re-derives published equations exactly.

pub mod diagnostic;
pub mod document;
pub mod expr;
pub mod latex;
pub mod numeric;
pub mod span;
