//! The sheet in Markdown, with formulas as code hosts render them.

use super::{Erratum, Sheet};
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
        out += "\n## Relations that are used and not written\n\n";
        for unwritten in &sheet.unwritten {
            out += &format!(
                "- {} for {}\n",
                words(&unwritten.relations),
                unwritten.equations.join(", ")
            );
        }
    }
    if !sheet.sentences.is_empty() {
        out += "\n## Sentences\n";
        for sentence in &sheet.sentences {
            out += &format!("\n> {}\n\n", escape(&sentence.text));
            for fact in &sentence.facts {
                out += &format!("- {}\n", words(fact));
            }
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
    out += &format!("\n- Correction: {}.\n", words(&one.correction));
    if !one.why.is_empty() {
        out += &format!("- Why: {}.\n", words(&one.why));
    }
    if let Some(effect) = &one.effect {
        out += &format!("- Effect: {}.\n", words(effect));
    }
    if let Some((source, because)) = &one.source {
        let because = match because.is_empty() {
            true => String::new(),
            false => format!(": {}", escape(because)),
        };
        out += &format!("- Likelier the {}'s{because}\n", source.as_str());
    }
    if let Some(note) = &one.note {
        out += &format!("- Note: {}\n", escape(note));
    }
    out
}

fn display(latex: &str) -> String {
    format!("```math\n{latex}\n```\n")
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
