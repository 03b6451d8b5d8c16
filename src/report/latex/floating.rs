//! The floating-point comparison in tables.

use super::Tex;
use super::escape::escape;
use super::printed::printed;
use crate::comparison::{Comparison, Subject, Summary};
use crate::document::Scale;
use crate::inspection::Inspection;
use crate::methods::Methods;
use crate::numeric::LyapunovMethod;
use crate::numeric::agreement::{MOST_DIGITS, nearest};
use crate::report::methods::{cells, head, headline, title};
use crate::report::prose::Prose;
use num_traits::Zero;

pub(super) fn write(tex: &mut Tex, inspection: &Inspection) {
    let Some(comparison) = &inspection.comparison else {
        return;
    };
    if comparison.rows.is_empty() {
        return;
    }
    tex.heading("Floating point");
    words(tex, inspection, comparison);
    random(tex, inspection, comparison);
    named(tex, comparison);
    methods(tex, inspection);
}

/// The methods side by side at the points that the document names for them.
fn methods(tex: &mut Tex, inspection: &Inspection) {
    let Some(found) = Methods::of(&inspection.audit, false) else {
        return;
    };
    tex.paragraph(&Prose::of(format!(
        "The variance of one output and the covariance matrix by each method: correct digits, of \
         the matrix those of its worst entry, and floating-point operations. The simulation uses \
         the seed {}.",
        found.seed
    )));
    for at in &found.points {
        tex.caption(&Prose::of(format!("At {}:", title(at))));
        let head: Vec<String> = head(false).into_iter().map(escape).collect();
        let rows: Vec<Vec<String>> = at
            .rows
            .iter()
            .map(|row| cells(row, false).iter().map(|c| escape(c)).collect())
            .collect();
        tex.table(&[2.2, 1.4, 1.0, 1.2, 1.6], &head, &rows);
        if let Some(line) = headline(at) {
            tex.paragraph(&Prose::of(line).capitalised().words("."));
        }
    }
}

fn words(tex: &mut Tex, inspection: &Inspection, comparison: &Comparison) {
    tex.paragraph(&Prose::of(format!(
        "The same expressions were computed in double precision, never through the exact engine, \
         and compared with the exact rational values at the very same doubles: the errors are \
         known and not estimated. The linear matrix equations were solved by each of the methods \
         below. Given is the number of correct digits, the negative decimal logarithm of the \
         relative error, at most {MOST_DIGITS}; of a matrix, for its worst entry. A link stands \
         for its right side, compared with the exact value of its left side.",
    )));
    let Some(table) = &inspection.audit.model.document.numeric else {
        return;
    };
    let samples = comparison.points.iter().filter(|p| !p.named).count();
    if samples == 0 {
        return;
    }
    let mut prose = Prose::of(format!(
        "{samples} points were drawn at random (seed {}), {}: ",
        comparison.seed,
        match table.scale {
            Scale::Logarithmic => "each letter evenly in its logarithm",
            Scale::Linear => "each letter evenly",
        }
    ));
    for (k, range) in table.ranges.iter().enumerate() {
        let text = |value| nearest(value).map_or_else(String::new, |v| v.to_string());
        prose = prose
            .words(if k == 0 { "" } else { ", " })
            .math(printed(&range.name.text))
            .words(format!(
                " from {} to {}",
                text(&range.low),
                text(&range.high)
            ));
    }
    tex.paragraph(&prose.words("."));
}

fn method(method: LyapunovMethod) -> &'static str {
    match method {
        LyapunovMethod::BartelsStewart => "Bartels--Stewart",
        LyapunovMethod::Kronecker => "Kronecker",
        LyapunovMethod::Smith => "Smith",
        LyapunovMethod::Kreisselmeier => "Kreisselmeier",
    }
}

fn subject(inspection: &Inspection, subject: &Subject) -> String {
    let name = inspection.subject(subject);
    match subject {
        Subject::Quantity(_) => format!("${}$", printed(&name)),
        Subject::Link { .. } => escape(&name),
    }
}

/// Worst and median over the random points: by method where the methods differ, then the rest.
fn random(tex: &mut Tex, inspection: &Inspection, comparison: &Comparison) {
    if comparison.points.iter().all(|p| p.named) {
        return;
    }
    let methods = 0..comparison.methods.len();
    let (differ, alike): (Vec<usize>, Vec<usize>) = (0..comparison.subjects.len()).partition(|s| {
        let first = comparison.summary(*s, 0, false);
        methods
            .clone()
            .any(|m| comparison.summary(*s, m, false) != first)
    });
    let place = |summary: &Summary| {
        let name = &comparison.points[summary.worst.1].name;
        escape(name.strip_prefix("sample ").unwrap_or(name))
    };
    let failures = |summary: &Summary| match summary.failed {
        0 => String::new(),
        n => format!(", {n} failed"),
    };
    if !differ.is_empty() {
        tex.caption(&Prose::of(
            "At the random points, by method: the fewest digits, in brackets the median.",
        ));
        let rows: Vec<Vec<String>> = differ
            .iter()
            .map(|&s| {
                let mut row = vec![subject(inspection, &comparison.subjects[s])];
                row.extend(methods.clone().map(|m| {
                    comparison.summary(s, m, false).map_or_else(
                        || "---".to_string(),
                        |summary| {
                            format!(
                                "{:.1} ({:.1}){}",
                                summary.worst.0,
                                summary.median,
                                failures(&summary)
                            )
                        },
                    )
                }));
                row
            })
            .collect();
        let mut head = vec!["Subject".to_string()];
        head.extend(comparison.methods.iter().map(|m| method(*m).to_string()));
        tex.table(&[0.2, 0.2, 0.2, 0.2, 0.2], &head, &rows);
    }
    let rows: Vec<Vec<String>> = alike
        .iter()
        // Of what is exactly zero no digit counts.
        .filter(|&&s| !always_zero(comparison, s))
        .filter_map(|&s| {
            let summary = comparison.summary(s, 0, false)?;
            Some(vec![
                subject(inspection, &comparison.subjects[s]),
                format!("{:.1}{}", summary.worst.0, failures(&summary)),
                place(&summary),
                format!("{:.1}", summary.median),
            ])
        })
        .collect();
    if !rows.is_empty() {
        tex.caption(&Prose::of(
            "What needs no matrix equation solved is the same by every method:",
        ));
        let head = ["Subject", "Fewest digits", "at sample", "Median"].map(String::from);
        tex.table(&[0.25, 0.25, 0.25, 0.25], &head, &rows);
    }
}

/// Whether a subject is zero at every point.
fn always_zero(comparison: &Comparison, subject: usize) -> bool {
    let mut rows = comparison.rows.iter().filter(|r| r.subject == subject);
    rows.all(|r| r.exact.as_ref().is_some_and(Zero::is_zero))
}

/// Every quantity at every named point.
fn named(tex: &mut Tex, comparison: &Comparison) {
    for (s, of) in comparison.subjects.iter().enumerate() {
        let Subject::Quantity(name) = of else {
            continue;
        };
        let rows: Vec<Vec<String>> = comparison
            .rows
            .iter()
            .filter(|r| r.subject == s && comparison.points[r.point].named)
            .map(|r| {
                let exact = r.exact.as_ref().and_then(nearest);
                let mut row = vec![
                    escape(&comparison.points[r.point].name),
                    exact.map_or_else(|| "---".into(), |v| format!("{v:.6e}")),
                ];
                row.extend(r.computed.iter().map(|c| match c.digits {
                    Some(digits) => format!("{digits:.1}"),
                    None => "fails".to_string(),
                }));
                row
            })
            .collect();
        if rows.is_empty() {
            continue;
        }
        tex.caption(
            &Prose::of("At the named points, correct digits of ")
                .math(printed(name))
                .words(":"),
        );
        let mut head = vec!["Point".to_string(), "Exact value".to_string()];
        head.extend(comparison.methods.iter().map(|m| method(*m).to_string()));
        tex.table(&[0.22, 0.16, 0.15, 0.11, 0.09, 0.14], &head, &rows);
    }
}
