//! Re-derives published equations exactly.
