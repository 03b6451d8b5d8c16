//! What was found, for readers and for programs.
//!
//! Sentences are written once ([`reason`], [`reasoning`]) and shown twice, in the terminal
//! ([`terminal`], [`explain`]) and in LaTeX ([`latex`]); programs read [`json`] and [`vectors`].
//! Same document, same bytes: nothing here depends on the time, the machine or an address.

pub mod algebraic;
pub mod csv;
pub mod decimal;
pub mod difference;
pub mod drawing;
pub mod errata;
pub mod explain;
pub mod formula;
pub mod json;
pub mod latex;
pub mod methods;
pub mod mutation;
mod ordered;
pub mod output;
pub mod plain;
pub mod prose;
pub mod reason;
pub mod reasoning;
pub mod rows;
pub mod statement;
pub mod terminal;
pub mod values;
pub mod vectors;
