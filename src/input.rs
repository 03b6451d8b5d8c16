//! Documents from the command line and from tests: files, folders, or the ones inside the program.

use crate::diagnostic::{Diagnostic, DiagnosticKind, Rejection};
use crate::document::Document;
use crate::embedded;
use crate::span::Span;
use num_rational::BigRational;
use num_traits::Zero;
use std::path::{Path, PathBuf};

/// A document, or why it is none.
pub type Input = Result<Document, Rejection>;

/// All documents among these files and folders, by name within each folder, those of one paper in
/// the order of what they cover; without paths the
/// documents inside the program. In a folder, Markdown files without a `math` or `toml` fence are
/// no documents and are passed over; a file that is named itself must be one.
pub fn read<P: AsRef<Path>>(paths: &[P]) -> Vec<Input> {
    if paths.is_empty() {
        let mut inputs = embedded::documents();
        in_order_of_papers(&mut inputs);
        return inputs;
    }
    let mut inputs = Vec::new();
    for path in paths {
        let path = path.as_ref();
        if path.is_dir() {
            let mut files = Vec::new();
            match markdown_files(path, &mut files) {
                Ok(()) => {}
                Err(error) => inputs.push(Err(unreadable(path, error.to_string()))),
            }
            let before = inputs.len();
            inputs.extend(files.iter().map(|f| Document::read(f)).filter(is_document));
            if inputs.len() == before {
                let message = "no document in this folder".to_string();
                inputs.push(Err(unreadable(path, message)));
            }
        } else {
            inputs.push(Document::read(path));
        }
    }
    in_order_of_papers(&mut inputs);
    inputs
}

/// Brings the documents of one paper together, where its first one stands, in the order of what they
/// cover.
fn in_order_of_papers(inputs: &mut Vec<Input>) {
    let mut papers: Vec<String> = Vec::new();
    let mut keyed: Vec<(usize, BigRational, Input)> = Vec::new();
    for (k, input) in std::mem::take(inputs).into_iter().enumerate() {
        let paper = match &input {
            Ok(document) => document.paper.as_ref().map(|p| p.title.text.clone()),
            Err(_) => None,
        };
        let title = paper.unwrap_or_else(|| format!("\u{0}{k}"));
        let place = match papers.iter().position(|p| *p == title) {
            Some(place) => place,
            None => {
                papers.push(title);
                papers.len() - 1
            }
        };
        let order = input
            .as_ref()
            .map_or_else(|_| BigRational::zero(), Document::order);
        keyed.push((place, order, input));
    }
    keyed.sort_by(|a, b| (a.0, &a.1).cmp(&(b.0, &b.1)));
    inputs.extend(keyed.into_iter().map(|(_, _, input)| input));
}

pub(crate) fn is_document(input: &Input) -> bool {
    match input {
        Ok(_) => true,
        Err(rejection) => !rejection
            .diagnostics
            .iter()
            .all(|d| d.kind == DiagnosticKind::EmptyDocument),
    }
}

/// The Markdown files below a folder, in the order of their names; hidden ones are left out.
fn markdown_files(folder: &Path, found: &mut Vec<PathBuf>) -> std::io::Result<()> {
    let mut entries: Vec<PathBuf> = std::fs::read_dir(folder)?
        .map(|entry| entry.map(|e| e.path()))
        .collect::<Result<_, _>>()?;
    entries.sort();
    for path in entries {
        let hidden = path
            .file_name()
            .is_none_or(|name| name.to_string_lossy().starts_with('.'));
        if hidden {
            continue;
        }
        // A link to a folder could lead round in a circle.
        let is_folder = path.symlink_metadata()?.is_dir();
        if is_folder {
            markdown_files(&path, found)?;
        } else if path.extension().is_some_and(|e| e == "md") && path.is_file() {
            found.push(path);
        }
    }
    Ok(())
}

fn unreadable(path: &Path, message: String) -> Rejection {
    Rejection {
        name: path.display().to_string(),
        text: String::new(),
        diagnostics: vec![Diagnostic::new(
            DiagnosticKind::Unreadable { message },
            Span::default(),
        )],
    }
}
