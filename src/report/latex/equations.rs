//! Each equation as printed, with the reasoning for each of its links.

use super::Tex;
use super::escape::escape;
use super::printed::printed;
use crate::audit::Audit;
use crate::model::Role;
use crate::report::explain::likelier;
use crate::report::formula::{Formulas, width};
use crate::report::prose::{Block, Prose};
use crate::report::reason::{Kind, equation_of, kind_of, number_of};
use crate::report::reasoning::{argument, conditions};
use crate::standing::Standing;
use crate::verdict::{NonVanishing, Outcome, Verdict};
use std::borrow::Cow;

/// Links whose equation is shorter than this are repeated beside their verdict.
const INLINE: usize = 60;

pub(super) fn write(tex: &mut Tex, audit: &Audit, formulas: &Formulas) {
    tex.heading("The equations one by one");
    // A divisor is named with the first equation that needs it.
    let mut known: Vec<NonVanishing> = Vec::new();
    for (index, equation) in audit.model.equations.iter().enumerate() {
        let role = match &equation.role {
            Role::Define => "a definition",
            Role::Solve => "determines its unknowns",
            Role::Claim => "a claim",
            Role::Recall(_) => "recalled",
        };
        let settings = &equation.settings;
        let source = match &settings.quote {
            _ if equation.label.parse::<u32>().is_ok() => Prose::of("as printed:"),
            Some(quote) => Prose::of("of the words “")
                .then(Prose::text(&quote.text))
                .words("”:"),
            None => Prose::of("as written in the document:"),
        };
        tex.line(&format!(
            "\n\\paragraph{{Equation ({}),}} {role}, {}",
            escape(&equation.label),
            source.to_latex()
        ));
        tex.numbered(&equation.label, &printed(&equation.source));
        if let Some(note) = &equation.settings.note {
            tex.paragraph(&Prose::of("Note: ").then(Prose::text(&note.text)));
        }
        if let Some(words) = likelier(settings) {
            tex.paragraph(&words);
        }
        let outcomes: Vec<&Outcome> = audit.outcomes_of(index).collect();
        let (plain, rest): (Vec<&Outcome>, Vec<&Outcome>) =
            outcomes.into_iter().partition(|o| is_plain(audit, o));
        together(tex, audit, &plain);
        for outcome in rest {
            let mut prose = head(audit, outcome);
            let mut blocks = argument(audit, formulas, outcome);
            if let Some(Block::Paragraph(first)) = blocks.first().cloned() {
                blocks.remove(0);
                prose = prose.words(" ").then(first);
            }
            tex.paragraph(&prose);
            tex.blocks(&blocks);
        }
        let mut divisors: Vec<NonVanishing> = Vec::new();
        for outcome in audit.outcomes_of(index) {
            for condition in &outcome.conditions {
                // Where letters stood for other functions the same polynomial is another divisor.
                let known_here = match outcome.letters {
                    None => &mut known,
                    Some(_) => &mut divisors,
                };
                if known_here.iter().any(|d| d.factor == condition.factor) {
                    continue;
                }
                if outcome.letters.is_none() {
                    known.push(condition.clone());
                }
                divisors.push(condition.clone());
            }
        }
        // All links of an equation are settled with the same letters.
        let formulas = match audit.outcomes_of(index).next() {
            Some(outcome) => formulas.here(&audit.model, outcome),
            None => Cow::Borrowed(formulas),
        };
        if let Some(prose) = conditions(&formulas, &divisors) {
            tex.paragraph(&prose);
        }
    }
}

/// Whether the verdict needs no words beyond its own.
fn is_plain(audit: &Audit, outcome: &Outcome) -> bool {
    match &outcome.verdict {
        Verdict::Holds { by, .. } => {
            by.is_empty()
                && outcome.positivity.is_none()
                && outcome.assumed.is_empty()
                && kind_of(audit, outcome) == Kind::Equality
        }
        Verdict::Definition { .. } => true,
        _ => false,
    }
}

/// `(62.1) and (62.3) are identities in the printed letters.`
fn together(tex: &mut Tex, audit: &Audit, outcomes: &[&Outcome]) {
    let numbers = |wanted: fn(&Verdict) -> bool| -> Vec<String> {
        outcomes
            .iter()
            .filter(|o| wanted(&o.verdict))
            .map(|o| number_of(audit, o))
            .collect()
    };
    let said = [
        (
            numbers(|v| matches!(v, Verdict::Holds { .. })),
            "is an identity in the printed letters.",
            "are identities in the printed letters.",
        ),
        (
            numbers(|v| matches!(v, Verdict::Definition { .. })),
            "is a definition.",
            "are definitions.",
        ),
    ];
    // Of a definition it is said before that it is one.
    let of_claims = outcomes
        .iter()
        .any(|o| audit.model.equations[o.equation].role == Role::Claim);
    for (k, (numbers, one, several)) in said.into_iter().enumerate() {
        if !numbers.is_empty() && (k == 0 || of_claims) {
            let words = if numbers.len() == 1 { one } else { several };
            let list = crate::report::reason::labels(&numbers);
            tex.paragraph(&Prose::of(format!("{list} {words}")));
        }
    }
}

/// `(61.2) holds given: a_4H_3 = ac(c^2de).`
fn head(audit: &Audit, outcome: &Outcome) -> Prose {
    let equation = &audit.model.equations[outcome.equation];
    let link = &equation.links[outcome.member - 1];
    let mut prose = Prose::new().strong(format!(
        "({}) {}",
        number_of(audit, outcome),
        outcome.verdict.word()
    ));
    if equation.links.len() > 1 {
        let latex = equation_of(&equation.display, link);
        if width(&latex) <= INLINE && !latex.contains("\\begin") {
            prose = prose.words(": ").math(latex);
        }
    }
    prose = prose.words(".");
    if audit.standing(outcome) == Standing::Differs {
        prose = prose.words(match equation.expected(outcome.member) {
            Some(word) => format!(" The document expects: {word}."),
            None => " The document records no verdict.".to_string(),
        });
    }
    prose
}
