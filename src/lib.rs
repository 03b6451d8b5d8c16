//! Re-derives published equations exactly.

pub mod diagnostic;
pub mod expr;
pub mod span;
