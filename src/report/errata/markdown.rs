//! The sheet in Markdown, with formulas as code hosts render them.

use super::{Erratum, Sentence, Sheet};
use crate::document::Source;
use crate::report::prose::{Piece, Prose};

/// All sheets, one after the other.
pub fn markdown(sheets: &[Sheet]) -> String {
    if sheets.iter().all(Sheet::is_empty) {
        return "Nothing to mend.\n".into();
    }
    let sheets = sheets.iter().filter(|s| !s.is_empty());
    sheets.map(sheet).collect::<Vec<_>>().join("\n")
}

fn sheet(sheet: &Sheet) -> String {
    let mut out = format!("# Errata: {}\n\n", escape(&sheet.title));
    for source in &sheet.sources {
        out += &format!("- {}\n", escape(source));
    }
    out += &format!("\n{}.\n", sheet.summary());
    let [theirs, ours] = sheet.by_source();
    for (title, errata) in [
        ("Equations", theirs),
        ("To be compared with the printed page first", ours),
    ] {
        if errata.is_empty() {
            continue;
        }
        out += &format!("\n## {title}\n");
        for one in errata {
            out += &erratum(one);
        }
    }
    if !sheet.unwritten.is_empty() {
        out += "\n## What is used and not written\n\n";
        for unwritten in &sheet.unwritten {
            out += &format!(
                "- {} for {}",
                words(&unwritten.relations),
                unwritten.equations.join(", ")
            );
            out += &match &unwritten.note {
                Some(note) => format!(". {}\n", words(note)),
                None => "\n".into(),
            };
        }
    }
    for (title, sentences) in sheet.groups() {
        if sentences.is_empty() {
            continue;
        }
        out += &format!("\n## {title}\n");
        for one in sentences {
            out += &sentence(one);
        }
    }
    if !sheet.remarks.is_empty() {
        out += "\n## Notation\n\n";
        for remark in &sheet.remarks {
            out += &format!("- {}\n", words(remark));
        }
    }
    out
}

fn erratum(one: &Erratum) -> String {
    let mut out = format!("\n### {}\n\nPrinted:\n\n", escape(&one.location));
    out += &display(&one.printed);
    if let Some(corrected) = &one.corrected {
        out += "\nShould read:\n\n";
        out += &display(corrected);
    }
    out.push('\n');
    for (title, lines) in [
        ("Correction", &one.corrections),
        ("Why", &one.why),
        ("Effect", &one.effects),
    ] {
        for line in lines {
            out += &format!("- {title}: {}.\n", words(line));
        }
    }
    out + &origin(&one.source) + &note(&one.note)
}

fn sentence(one: &Sentence) -> String {
    let place = match &one.place {
        Some(place) => format!(" ({})", words(place)),
        None => String::new(),
    };
    let mut out = format!("\n> {}{place}\n\n", words(&one.text));
    if let Some(reads) = &one.reads {
        out += &format!("Should read:\n\n> {}\n\n", words(reads));
    }
    if let Some((printed, corrected)) = &one.formula {
        out += &format!("As a formula:\n\n{}\n", display(printed));
        if let Some(corrected) = corrected {
            out += &format!("It should be:\n\n{}\n", display(corrected));
        }
    }
    for fact in &one.facts {
        out += &format!("- {}.\n", words(&fact.clone().capitalised()));
    }
    out + &origin(&one.source) + &note(&one.note)
}

fn origin(source: &Option<(Source, Prose)>) -> String {
    match source {
        None => String::new(),
        Some((source, because)) if because.is_empty() => {
            format!("- Likelier the {}'s\n", source.as_str())
        }
        Some((source, because)) => {
            format!("- Likelier the {}'s: {}\n", source.as_str(), words(because))
        }
    }
}

fn note(note: &Option<Prose>) -> String {
    note.as_ref()
        .map_or_else(String::new, |note| format!("- Note: {}\n", words(note)))
}

fn display(latex: &str) -> String {
    format!("```math\n{}\n```\n", latex.trim())
}

fn words(prose: &Prose) -> String {
    // Backticks keep Markdown's own signs out of formulas.
    prose.written(["$`", "`$"], |piece| match piece {
        Piece::Words(text) => escape(text),
        Piece::Strong(text) => format!("**{}**", escape(text)),
        Piece::Code(text) => format!("`{text}`"),
        Piece::Math { latex, .. } => latex.clone(),
    })
}

/// Free text cannot act as Markdown.
fn escape(text: &str) -> String {
    let mut out = String::new();
    for c in text.chars() {
        if matches!(
            c,
            '\\' | '`' | '*' | '_' | '[' | ']' | '<' | '>' | '#' | '|' | '$'
        ) {
            out.push('\\');
        }
        out.push(if c == '\n' { ' ' } else { c });
    }
    out
}
