//! Random vibration by document: expectations, covariances, shapes, and what must be refuted.

#[path = "random_vibration/covariance.rs"]
mod covariance;
#[path = "random_vibration/damage.rs"]
mod damage;
#[path = "random_vibration/expectation.rs"]
mod expectation;
#[path = "random_vibration/shapes.rs"]
mod shapes;

use rederive::audit::Audit;
use rederive::check::Options;
use rederive::document::{Document, VerdictWord};
use rederive::verdict::{Outcome, Verdict};

/// The audit of a document that is one.
fn audit(text: &str) -> Audit {
    let document =
        Document::parse("test.md", text).unwrap_or_else(|diagnostics| panic!("{diagnostics:?}"));
    Audit::of(&document, Options::default()).unwrap_or_else(|rejection| panic!("{rejection}"))
}

/// The outcome on a link, named as in `44.1`.
fn outcome<'a>(audit: &'a Audit, link: &str) -> &'a Outcome {
    let (label, member) = link.rsplit_once('.').expect("label.member");
    let equation = audit.model.equation(label).expect("an equation");
    audit
        .outcomes_of(equation)
        .find(|o| o.member.to_string() == member)
        .expect("a link")
}

fn word(audit: &Audit, link: &str) -> VerdictWord {
    outcome(audit, link).verdict.word()
}

/// The corrections of a misprint, as `printed -> corrected`, the first one first.
fn corrections(audit: &Audit, link: &str) -> Vec<Vec<String>> {
    let Verdict::Misprint { correction, .. } = &outcome(audit, link).verdict else {
        panic!("({link}): {:?}", outcome(audit, link).verdict);
    };
    std::iter::once(&correction.edits)
        .chain(&correction.alternatives)
        .map(|edits| {
            edits
                .iter()
                .map(|e| format!("{} -> {}", e.printed, e.corrected))
                .collect()
        })
        .collect()
}
