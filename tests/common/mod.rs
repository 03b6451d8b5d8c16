//! What several tests do with a document that stands in them as a text.

use rederive::audit::Audit;
use rederive::check::Options;
use rederive::diagnostic::{Rejection, render};
use rederive::document::Document;

/// The audit of a text that can be read.
pub fn audit(text: &str, options: Options) -> Result<Audit, Rejection> {
    let document = Document::parse("test.md", text)
        .unwrap_or_else(|diagnostics| panic!("{}", render("test.md", text, &diagnostics, false)));
    Audit::of(&document, options)
}
