//! What a reader wants first: coverage, the slips, the hypotheses, all verdicts in one table.

use super::Tex;
use super::escape::escape;
use super::printed::printed;
use crate::audit::Audit;
use crate::document::Structure;
use crate::report::formula::{Formulas, Script};
use crate::report::prose::Prose;
use crate::report::rows::rows;
use crate::report::statement::{in_latex, is_strong};
use crate::report::terminal::{coverage, tally};

pub(super) fn write(tex: &mut Tex, audit: &Audit, formulas: &Formulas) {
    let document = &audit.model.document;
    if let Some(source) = &document.source {
        tex.paragraph(&Prose::of(format!("Checked: {}.", source.text)));
    }
    tex.paragraph(&Prose::of(format!("Coverage: {}.", coverage(audit))));
    let counts: Vec<String> = tally(&audit.outcomes)
        .iter()
        .map(|(word, count)| format!("{count} {word}"))
        .collect();
    tex.paragraph(&Prose::of(format!(
        "The verdicts on the links: {}.",
        counts.join(", ")
    )));
    letters(tex, audit, formulas);
    tex.heading("Verdicts");
    let rows: Vec<Vec<String>> = rows(audit, formulas)
        .into_iter()
        .map(|row| {
            let shown = if is_strong(row.word) {
                format!("\\textbf{{{}}}", row.word)
            } else {
                row.word.to_string()
            };
            vec![escape(&row.number), shown, row.reason.to_latex()]
        })
        .collect();
    let head = ["Link", "Verdict", "Reason"].map(String::from);
    // A label is not broken while there is room for it.
    let longest = rows.iter().map(|row| row[0].len()).max().unwrap_or(0);
    let labels = (0.0125 * longest as f64).clamp(0.1, 0.32);
    tex.table(&[labels, 0.13, 0.82 - labels], &head, &rows);
}

/// A unit as the tables show it; a power that is written is one.
fn unit(unit: &str) -> String {
    match unit.contains('^') && printed(unit) == unit {
        true => format!("${}$", in_latex(unit)),
        false => escape(unit),
    }
}

/// The declared symbols with unit, reference value and meaning.
fn letters(tex: &mut Tex, audit: &Audit, formulas: &Formulas) {
    let symbols = &audit.model.symbols;
    if symbols.is_empty() {
        return;
    }
    tex.heading("Letters");
    let matrices = audit.model.matrices.iter().map(|matrix| {
        let structure = match (matrix.shape.structure, matrix.shape.positive_definite) {
            (_, true) => "symmetric, positive definite",
            (Structure::Symmetric, _) => "symmetric",
            (Structure::Skew, _) => "skew-symmetric",
            (Structure::General, _) => "a matrix of letters",
        };
        let (rows, columns) = (&matrix.shape.rows, &matrix.shape.columns);
        let mut meaning = Prose::text(&matrix.meaning).to_latex();
        meaning += &escape(&format!(" ({rows} x {columns}, {structure})"));
        if let Some(argument) = matrix.arguments.last() {
            meaning += &format!(", a function of ${}$", crate::latex::canonical(argument));
        }
        vec![
            format!("${}$", crate::latex::canonical(&matrix.name)),
            matrix.unit.as_deref().map_or_else(String::new, unit),
            String::new(),
            meaning,
        ]
    });
    let scalars = symbols
        .iter()
        .filter(|symbol| symbol.entry_of.is_none())
        .map(|symbol| {
            let value = symbol.value.as_ref();
            let mut meaning = Prose::text(&symbol.meaning).to_latex();
            if symbol.range.is_positive() {
                meaning += " (positive)";
            }
            if let Some(argument) = &symbol.function_of {
                meaning += &format!(", a function of ${}$", crate::latex::canonical(argument));
            }
            vec![
                format!("${}$", crate::latex::canonical(&symbol.name)),
                symbol.unit.as_deref().map_or_else(String::new, unit),
                value.map_or_else(String::new, |v| {
                    format!("${}$", formulas.number(v, Script::Plain))
                }),
                meaning,
            ]
        });
    let mut rows: Vec<Vec<String>> = scalars.chain(matrices).collect();
    let mut head: Vec<String> = ["Letter", "Unit", "Reference", "Meaning"]
        .map(String::from)
        .into();
    let mut widths = vec![0.12, 0.12, 0.2, 0.46];
    // A column without entries is none.
    for column in [2, 1] {
        if rows.iter().all(|row| row[column].is_empty()) {
            head.remove(column);
            let width = widths.remove(column);
            if let Some(last) = widths.last_mut() {
                *last += width;
            }
            for row in &mut rows {
                row.remove(column);
            }
        }
    }
    tex.table(&widths, &head, &rows);
}
