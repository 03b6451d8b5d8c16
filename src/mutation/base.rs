//! What is damaged: the document with its known misprints corrected, and which of its links are true.

use super::dependence::LinkAt;
use crate::check::trial::Finding;
use crate::check::{self, Checker, Options};
use crate::diagnostic::Rejection;
use crate::document::Document;
use crate::latex;
use crate::model::{Model, Role};

/// Why a link is not damaged.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct LeftOut {
    /// The label of the equation.
    pub label: String,
    /// The link's number within it, from 1.
    pub member: usize,
    /// Why.
    pub why: String,
}

/// What a link is before it is damaged.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum Standing {
    /// A claim that is true.
    True,
    /// A definition that has a value.
    Defines,
    /// It says nothing that could be checked.
    Silent,
    /// It is not true, or not known to be.
    Out(String),
}

/// The document with the corrections that the checker proposes written into it.
///
/// # Errors
/// When the document cannot be checked.
pub(super) fn corrected(document: &Document) -> Result<Document, Rejection> {
    let reject = |diagnostics| document.reject(diagnostics);
    let mut model = Model::build(document).map_err(reject)?;
    // Statements in words are neither damaged nor asked.
    model.statements.clear();
    let verdicts = check::check(&model, Options::default()).map_err(reject)?;
    let exact = check::corrected(&model, &verdicts.links);
    let mut text = document.text.clone();
    let mut corrections: Vec<_> = exact.world().corrections().collect();
    corrections.sort_by_key(|(e, _)| std::cmp::Reverse(model.equations[*e].span));
    for (e, display) in corrections {
        let span = model.equations[e].span;
        let mut written = latex::write_display(display);
        if text[span.start..span.end].ends_with('\n') {
            written.push('\n');
        }
        let mut attempt = text.clone();
        attempt.replace_range(span.start..span.end, &written);
        let same = Document::parse(&document.name, &attempt)
            .ok()
            .and_then(|d| Model::build(&d).ok())
            .is_some_and(|m| m.equations.get(e).is_some_and(|q| q.display == *display));
        // What cannot be written so that it is read back the same stays as printed.
        if same {
            text = attempt;
        }
    }
    Document::parse(&document.name, &text).map_err(reject)
}

/// What each link of each equation is, by the checkers of all instances. Everything that the links
/// need has been computed afterwards.
pub(super) fn standings(model: &Model, checkers: &mut [Checker<'_>]) -> Vec<Vec<Standing>> {
    let mut standings: Vec<Vec<Standing>> = model
        .equations
        .iter()
        .map(|equation| vec![Standing::Silent; equation.links.len()])
        .collect();
    for e in model.settling_order() {
        for (l, standing) in standings[e].iter_mut().enumerate() {
            *standing = standing_of(model, checkers, (e, l));
        }
    }
    standings
}

fn standing_of(model: &Model, checkers: &mut [Checker<'_>], (e, l): LinkAt) -> Standing {
    let equation = &model.equations[e];
    let link = &equation.links[l];
    let recalled = equation
        .settings
        .recalled_members
        .contains_key(&link.member);
    if recalled || matches!(equation.role, Role::Recall(_)) {
        return Standing::Silent;
    }
    let defines = equation.defines[l].is_some() || equation.role == Role::Solve;
    for checker in checkers {
        match checker.finding(e, l) {
            Finding::Accepted => {}
            Finding::NothingToCheck => return Standing::Silent,
            Finding::Refuted => return Standing::Out("false as it stands".into()),
            Finding::Meaningless(nonsense) => return Standing::Out(nonsense.as_str().into()),
            Finding::Undecided(reason) => return Standing::Out(reason),
        }
    }
    if defines {
        Standing::Defines
    } else {
        Standing::True
    }
}
