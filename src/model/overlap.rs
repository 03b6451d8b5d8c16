//! Cases that contradict each other.
//!
//! Where two rows of a definition by cases apply to the same values of a letter and say different things, the print does not
//! say which of them is meant: the first, or one that the other was meant to leave out. Rows that meet at one value
//! only, as in u for u ≥ 0 and -u for u ≤ 0, are left to the values there.

use super::Model;
use super::names::literal_number;
use super::range::Range;
use crate::diagnostic::{Diagnostic, DiagnosticKind};
use crate::expr::walk::children;
use crate::expr::{Chain, Expr, ExprKind};
use crate::latex;

impl Model {
    /// The rows of cases in an expression that say different things of the same values of a letter.
    pub(super) fn overlapping_cases(&self, expr: &Expr, report: &mut Vec<Diagnostic>) {
        if let ExprKind::Cases(rows) = &expr.kind {
            let ranges: Vec<Option<(String, Range)>> = rows
                .iter()
                .map(|(_, conditions)| range_of(conditions))
                .collect();
            for (j, later) in ranges.iter().enumerate() {
                for (k, earlier) in ranges.iter().enumerate().take(j) {
                    let (Some((one, mut range)), Some((other, bound))) =
                        (earlier.clone(), later.clone())
                    else {
                        continue;
                    };
                    if one != other || rows[j].0 == rows[k].0 {
                        continue;
                    }
                    if let Some(end) = &bound.low {
                        range.raise(end.value.clone(), end.included);
                    }
                    if let Some(end) = &bound.high {
                        range.lower(end.value.clone(), end.included);
                    }
                    if !range.is_empty() && range.single().is_none() {
                        let readings = vec![
                            "the first row where several apply".to_owned(),
                            "rows whose conditions exclude each other".to_owned(),
                        ];
                        report.push(Diagnostic::new(
                            DiagnosticKind::Ambiguous { readings },
                            rows[j].0.span,
                        ));
                    }
                }
            }
        }
        for child in children(expr) {
            self.overlapping_cases(child, report);
        }
    }
}

/// Between which numbers some conditions say that one letter lies, if that is all they say.
fn range_of(conditions: &[Chain]) -> Option<(String, Range)> {
    let mut letter: Option<String> = None;
    let mut range = Range::default();
    for chain in conditions {
        for (sides, relation) in chain.members.windows(2).zip(&chain.relations) {
            let (left, right) = (&sides[0], &sides[1]);
            let (name, value, below) = match (literal_number(left), literal_number(right)) {
                (None, Some(value)) => (left.as_name()?, value, false),
                (Some(value), None) => (right.as_name()?, value, true),
                (Some(_), Some(_)) | (None, None) => return None,
            };
            let name = latex::canonical(name);
            if letter.get_or_insert_with(|| name.clone()) != &name {
                return None;
            }
            if !range.compare(*relation, below, value) {
                return None;
            }
        }
    }
    letter.map(|letter| (letter, range))
}
