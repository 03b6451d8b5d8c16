//! `rederive explain 61`: the whole reasoning for one equation or statement, in a terminal.

use crate::audit::Audit;
use crate::document::{Settings, VerdictWord};
use crate::report::formula::Formulas;
use crate::report::plain::plain;
use crate::report::prose::{Block, Prose};
use crate::report::reason::{equation_of, number_of};
use crate::report::reasoning::reasoning;
use crate::report::statement;
use crate::standing::Standing;

/// The reasoning for the equation or statement under a label; none when the document has neither.
pub fn explain(audit: &Audit, label: &str, width: usize) -> Option<String> {
    match audit.model.equation(label) {
        Some(index) => Some(equation(audit, index, width)),
        None => Some(statement(audit, audit.model.statement(label)?, width)),
    }
}

fn statement(audit: &Audit, index: usize, width: usize) -> String {
    let statement = &audit.model.statements[index];
    let formulas = Formulas::of(&audit.model);
    let mut out = format!("{}  {}\n", statement.label, audit.model.document.name);
    out += &wrapped(
        &format!("\"{}\"", Prose::text(&statement.sentence).to_plain()),
        width,
        "    ",
    );
    out += &remarks(&statement.settings, width);
    for outcome in audit.outcomes_of_statement(index) {
        let claim = statement::proposition_of(audit, outcome)
            .map(|p| statement::claim(audit, &formulas, p).to_plain());
        out += &format!(
            "\n{}  {}\n",
            statement::number_of(audit, outcome),
            claim.unwrap_or_default()
        );
        let standing = standing(
            audit.standing_of_statement(outcome),
            statement.expected(outcome.member),
        );
        out += &format!("  {}{standing}\n", outcome.word);
        out += &plain_blocks(&statement::reasoning(audit, &formulas, outcome), width);
    }
    out
}

/// The note, and where a slip is likelier.
fn remarks(settings: &Settings, width: usize) -> String {
    let mut out = String::new();
    let note = settings.note.as_ref();
    let note = note.map(|n| Prose::of("Note: ").then(Prose::text(&n.text)));
    for remark in note.into_iter().chain(likelier(settings)) {
        let text = wrapped(&remark.to_plain(), width, "      ");
        out += &format!("\n{}\n", text.trim());
    }
    out
}

/// `The slip is likelier the paper's: ...`.
pub fn likelier(settings: &Settings) -> Option<Prose> {
    let source = settings.likelier?.as_str();
    Some(match &settings.because {
        Some(because) => Prose::of(format!("The slip is likelier the {source}'s: "))
            .then(Prose::text(&because.text))
            .words("."),
        None => Prose::of(format!("The slip is likelier the {source}'s.")),
    })
}

fn standing(standing: Standing, expected: Option<VerdictWord>) -> String {
    match (standing, expected) {
        (Standing::Differs, Some(word)) => format!(" (the document expects: {word})"),
        (Standing::Differs, None) => " (the document records no verdict)".into(),
        _ => String::new(),
    }
}

fn equation(audit: &Audit, index: usize, width: usize) -> String {
    let label = &audit.model.equations[index].label;
    let equation = &audit.model.equations[index];
    let formulas = Formulas::of(&audit.model);
    let mut out = format!("({label})  {}\n", audit.model.document.name);
    for line in equation.source.trim().lines() {
        out += &format!("    {}\n", line.trim_end());
    }
    out += &remarks(&equation.settings, width);
    for outcome in audit.outcomes_of(index) {
        let link = &equation.links[outcome.member - 1];
        out += &format!(
            "\n{}  {}\n",
            number_of(audit, outcome),
            plain(&equation_of(&equation.display, link))
        );
        let standing = standing(audit.standing(outcome), equation.expected(outcome.member));
        out += &format!("  {}{standing}\n", outcome.verdict.word());
        out += &plain_blocks(&reasoning(audit, &formulas, outcome), width);
    }
    out
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
