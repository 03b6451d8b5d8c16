//! `rederive explain 61`: the whole reasoning for one equation, in a terminal.

use crate::audit::Audit;
use crate::report::formula::Formulas;
use crate::report::plain::plain;
use crate::report::prose::Block;
use crate::report::reason::{equation_of, number_of};
use crate::report::reasoning::reasoning;
use crate::standing::Standing;

/// The reasoning for the equation under a label; none when the document has no such equation.
pub fn explain(audit: &Audit, label: &str, width: usize) -> Option<String> {
    let index = audit.model.equation(label)?;
    let equation = &audit.model.equations[index];
    let formulas = Formulas::of(&audit.model);
    let mut out = format!("({label})  {}\n", audit.model.document.name);
    for line in equation.source.trim().lines() {
        out += &format!("    {}\n", line.trim_end());
    }
    if let Some(note) = &equation.settings.note {
        out += &format!(
            "\nNote: {}\n",
            wrapped(&note.text, width, "      ").trim_start()
        );
    }
    for outcome in audit.outcomes_of(index) {
        let link = &equation.links[outcome.member - 1];
        out += &format!(
            "\n{}  {}\n",
            number_of(audit, outcome),
            plain(&equation_of(&equation.display, link))
        );
        let standing = match audit.standing(outcome) {
            Standing::Differs => match equation.expected(outcome.member) {
                Some(word) => format!(" (the document expects: {word})"),
                None => " (the document records no verdict)".into(),
            },
            _ => String::new(),
        };
        out += &format!("  {}{standing}\n", outcome.verdict.word());
        out += &plain_blocks(&reasoning(audit, &formulas, outcome), width);
    }
    Some(out)
}

/// Blocks in a terminal.
pub fn plain_blocks(blocks: &[Block], width: usize) -> String {
    blocks.iter().map(|block| shown(block, width)).collect()
}

fn shown(block: &Block, width: usize) -> String {
    match block {
        Block::Paragraph(prose) => {
            let text = prose.to_plain();
            if text.trim().is_empty() {
                String::new()
            } else {
                wrapped(&text, width, "  ")
            }
        }
        Block::Display { plain, .. } => wrapped(plain, width, "      "),
        Block::Table { rows, .. } => rows
            .iter()
            .map(|row| {
                let cells: Vec<String> = row.iter().map(|c| c.to_plain()).collect();
                wrapped(&cells.join(":  "), width, "      ")
            })
            .collect(),
    }
}

/// Words on lines of about this width, all lines indented.
fn wrapped(text: &str, width: usize, indent: &str) -> String {
    let mut out = String::new();
    let mut line = String::new();
    for word in text.split_whitespace() {
        let length = line.chars().count() + word.chars().count() + 1;
        if !line.is_empty() && length + indent.len() > width {
            out += &format!("{indent}{line}\n");
            line.clear();
        }
        if !line.is_empty() {
            line.push(' ');
        }
        line.push_str(word);
    }
    if !line.is_empty() {
        out += &format!("{indent}{line}\n");
    }
    out
}
