//! The verdicts of this library, and what can be found out apart about what they propose.

use super::expression;
use super::generator::{Claim, Truth};
use super::judge::Said;
use super::random::Random;
use super::truth;
use rederive::audit::Audit;
use rederive::check::Options;
use rederive::document::Document;
use rederive::latex::canonical;
use rederive::verdict::{Given, Verdict};
use std::panic::{AssertUnwindSafe, catch_unwind};

/// What is said of each link of some claims, or why there is nothing.
pub fn by_library(text: &str, repair: bool, claims: &[&Claim]) -> Result<Vec<Vec<Said>>, Said> {
    let options = Options {
        repair,
        candidates: 400,
        work: 3_000_000,
        threads: 1,
    };
    let audit = catch_unwind(AssertUnwindSafe(|| {
        let document = Document::parse("generated.md", text).ok()?;
        Audit::of(&document, options).ok()
    }));
    let audit = match audit {
        Ok(Some(audit)) => audit,
        Ok(None) => return Err(Said::Refused),
        Err(_) => return Err(Said::Panic),
    };
    Ok(claims.iter().map(|claim| of_claim(&audit, claim)).collect())
}

fn of_claim(audit: &Audit, claim: &Claim) -> Vec<Said> {
    let mut said = vec![Said::Refused; claim.truth.len()];
    let Some(equation) = audit.model.equation(&claim.label) else {
        let statement = audit.model.statement(&claim.label);
        for outcome in &audit.statements {
            if Some(outcome.statement) == statement
                && let Some(slot) = said.get_mut(outcome.member - 1)
            {
                *slot = Said::Word(outcome.word);
            }
        }
        return said;
    };
    let skipped = match claim.last {
        true => audit.outcomes_of(equation).count().saturating_sub(1),
        false => 0,
    };
    for outcome in audit.outcomes_of(equation).skip(skipped) {
        let Some(slot) = said.get_mut(outcome.member - 1 - skipped) else {
            continue;
        };
        *slot = match &outcome.verdict {
            Verdict::HoldsGiven(given, _) if claim.truth[0] != Truth::Given => {
                Said::HoldsGiven(makes_true(audit, given, claim))
            }
            Verdict::Misprint { correction, .. }
                if correction.definition.is_none()
                    && correction.given.is_none()
                    && expression::display_is_false(&correction.display, claim) =>
            {
                Said::FalseCorrection(rederive::latex::write_display(&correction.display))
            }
            verdict => Said::Word(verdict.word()),
        };
        if claim.sides.is_some()
            && expression::is_misread(&audit.model.equations[equation].display, claim)
        {
            *slot = Said::MisRead(rederive::latex::write_display(
                &audit.model.equations[equation].display,
            ));
        }
    }
    said
}

/// Whether a relation is false in general and the claim true under it, found out apart.
fn makes_true(audit: &Audit, given: &Given, claim: &Claim) -> Option<bool> {
    let (left, right) = claim.sides.as_ref()?;
    let [relation] = given.relations.as_slice() else {
        return None;
    };
    let ring = audit.model.letters.len();
    let mut letters = left.letters();
    letters.extend(
        right
            .letters()
            .iter()
            .filter(|l| !left.letters().contains(l)),
    );
    let names: Vec<String> = (0..ring)
        .map(|l| canonical(&audit.model.letter_name(l)))
        .collect();
    let value = |point: &[(&'static str, f64)]| {
        let exact: Vec<num_rational::BigRational> = names
            .iter()
            .map(|name| {
                let found = point.iter().find(|(l, _)| l == name);
                let x = found.map_or(0.0, |(_, x)| *x);
                num_rational::BigRational::from_float(x).unwrap_or_default()
            })
            .collect();
        relation.evaluate(&exact).ok().map(|f| truth::float(&f))
    };
    let mut random = Random::new(1, &claim.label);
    truth::true_given((left, right), &value, &letters, &mut random)
}
