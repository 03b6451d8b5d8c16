//! Labels that settings name: each must be one of the document's.

use super::{Equation, Settings, Statement};
use crate::diagnostic::{Diagnostic, DiagnosticKind};

/// Refuses settings that name no equation or statement of the document, or their own.
pub(super) fn check(
    equations: &[Equation],
    statements: &[Statement],
    report: &mut Vec<Diagnostic>,
) {
    let numbers = equations.iter().map(|e| e.label.text.as_str());
    let words = statements.iter().map(|s| s.label.text.as_str());
    let known: Vec<&str> = numbers.clone().chain(words).collect();
    let all = equations.iter().map(|e| (&e.label, &e.settings));
    let all = all.chain(statements.iter().map(|s| (&s.label, &s.settings)));
    for (label, settings) in all {
        let Settings {
            instead,
            or,
            unwritten,
            ..
        } = settings;
        for named in instead.iter().chain(or).chain(unwritten) {
            if named.text == label.text || !known.contains(&named.text.as_str()) {
                report.push(Diagnostic::new(
                    DiagnosticKind::UnknownWord {
                        word: named.text.clone(),
                        known: known
                            .iter()
                            .filter(|word| **word != label.text)
                            .map(|word| (*word).into())
                            .collect(),
                    },
                    named.span,
                ));
            }
        }
    }
}
