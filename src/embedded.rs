//! The documents that travel inside the program, so that it checks something without any file.

use crate::diagnostic::Rejection;
use crate::document::Document;
use crate::input::Input;

/// Name and text of each document below `proofs/`.
pub const DOCUMENTS: &[(&str, &str)] = &[
    (
        "proofs/matrix-polynomial/lyapunov.md",
        include_str!("../proofs/matrix-polynomial/lyapunov.md"),
    ),
    (
        "proofs/schiehlen-2006/quarter-car.md",
        include_str!("../proofs/schiehlen-2006/quarter-car.md"),
    ),
];

/// The documents, decoded.
pub fn documents() -> Vec<Input> {
    DOCUMENTS
        .iter()
        .map(|(name, text)| {
            Document::parse(name, text).map_err(|diagnostics| Rejection {
                name: (*name).into(),
                text: (*text).into(),
                diagnostics,
            })
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::input;

    #[test]
    fn no_document_of_the_folder_is_forgotten() {
        let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/proofs");
        let on_disk: Vec<String> = input::read(&[folder])
            .into_iter()
            .map(|d| d.unwrap_or_else(|e| panic!("{e}")).text)
            .collect();
        let inside: Vec<String> = DOCUMENTS.iter().map(|(_, text)| text.to_string()).collect();
        assert_eq!(inside, on_disk);
    }
}
