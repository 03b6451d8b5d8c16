//! The documents that travel inside the program, so that it checks something without any file:
//! whatever stands below `proofs/` when it is built.

use crate::diagnostic::Rejection;
use crate::document::Document;
use crate::input::{Input, is_document};
use include_dir::{Dir, include_dir};

static PROOFS: Dir = include_dir!("$CARGO_MANIFEST_DIR/proofs");

/// The documents, decoded, by name.
pub fn documents() -> Vec<Input> {
    let mut files = Vec::new();
    markdown(&PROOFS, &mut files);
    files.sort_unstable();
    files
        .into_iter()
        .map(|(name, text)| {
            let name = format!("proofs/{name}");
            Document::parse(&name, text).map_err(|diagnostics| Rejection {
                name,
                text: text.into(),
                diagnostics,
            })
        })
        .filter(is_document)
        .collect()
}

/// Name and text of every Markdown file of a folder and those below it.
fn markdown(folder: &'static Dir, found: &mut Vec<(String, &'static str)>) {
    for file in folder.files() {
        let path = file.path();
        if path.extension().is_some_and(|e| e == "md")
            && let Some(text) = file.contents_utf8()
        {
            // The same name on every system.
            let parts: Vec<_> = path.iter().map(|part| part.to_string_lossy()).collect();
            found.push((parts.join("/"), text));
        }
    }
    for inner in folder.dirs() {
        markdown(inner, found);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::input;

    #[test]
    fn the_documents_inside_are_those_of_the_folder() {
        let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/proofs");
        let texts = |inputs: Vec<Input>| -> Vec<String> {
            let documents = inputs
                .into_iter()
                .map(|d| d.unwrap_or_else(|e| panic!("{e}")));
            documents.map(|d| d.text).collect()
        };
        let inside = texts(input::read::<&str>(&[]));
        assert!(!inside.is_empty());
        assert_eq!(inside, texts(input::read(&[folder])));
    }
}
