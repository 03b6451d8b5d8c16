//! No false verdict, ever: generated claims whose truth is known by construction or by an
//! independent evaluator, one family of relatives a module.

#[allow(dead_code)]
mod common;
#[path = "soundness/enclosures.rs"]
mod enclosures;
#[path = "soundness/functions.rs"]
mod functions;
#[path = "soundness/limits.rs"]
mod limits;
#[path = "soundness/signs.rs"]
mod signs;
#[path = "soundness/statements.rs"]
mod statements;
#[path = "soundness/corrections.rs"]
mod corrections;
#[path = "soundness/mod.rs"]
mod generated;
