//! The table of verdicts, in the order of the document: links of one equation with the same
//! verdict for the same reason share a row, each proposition of a statement has its own.

use crate::audit::Audit;
use crate::document::VerdictWord;
use crate::report::formula::Formulas;
use crate::report::prose::Prose;
use crate::report::reason::{number_of, reason};
use crate::report::statement;
use crate::standing::Standing;
use crate::verdict::Verdict;

/// A row.
#[derive(Clone, Debug)]
pub struct Row {
    /// `61.2`, or `63.1-9`.
    pub number: String,
    /// The verdict.
    pub word: VerdictWord,
    /// Whether it is as expected.
    pub standing: Standing,
    /// Why, in one line.
    pub reason: Prose,
}

/// The rows of a document, in its order.
pub fn rows(audit: &Audit, formulas: &Formulas) -> Vec<Row> {
    let mut rows: Vec<(usize, usize, Row)> = Vec::new();
    for outcome in &audit.outcomes {
        let row = Row {
            number: number_of(audit, outcome),
            word: outcome.verdict.word(),
            standing: audit.standing(outcome),
            reason: reason(audit, formulas, outcome),
        };
        if let Some((equation, first, last)) = rows.last_mut()
            && *equation == outcome.equation
            && last.word == row.word
            && last.standing == row.standing
        {
            let shared = match &outcome.verdict {
                Verdict::Holds { .. } | Verdict::Recalled { .. } => {
                    (last.reason == row.reason).then(|| last.reason.clone())
                }
                Verdict::Definition { what } => {
                    let more = crate::report::reason::defined(what);
                    match last.reason.to_plain().ends_with(&more.to_plain()) {
                        true => Some(last.reason.clone()),
                        false => Some(last.reason.clone().words(", ").then(more)),
                    }
                }
                _ => None,
            };
            if let Some(reason) = shared {
                let label = &audit.model.equations[outcome.equation].label;
                last.reason = reason;
                last.number = format!("{label}.{first}-{}", outcome.member);
                continue;
            }
        }
        rows.push((outcome.equation, outcome.member, row));
    }
    let model = &audit.model;
    let statements = audit.statements.iter().map(|outcome| {
        let row = Row {
            number: statement::number_of(audit, outcome),
            word: outcome.word,
            standing: audit.standing_of_statement(outcome),
            reason: statement::reason(audit, formulas, outcome),
        };
        (model.statements[outcome.statement].span, row)
    });
    let mut placed: Vec<_> = rows
        .into_iter()
        .map(|(equation, _, row)| (model.equations[equation].span, row))
        .chain(statements)
        .collect();
    placed.sort_by_key(|(span, _)| *span);
    placed.into_iter().map(|(_, row)| row).collect()
}
