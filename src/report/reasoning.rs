//! The whole reasoning behind one verdict: residual, relation and cofactor, witness, correction,
//! conditions.

use crate::audit::Audit;
use crate::check::effect::effect;
use crate::document::Settings;
use crate::evaluate::Origin;
use crate::report::algebraic::equals;
use crate::report::formula::{Formulas, Script};
use crate::report::plain::plain;
use crate::report::prose::{Block, Prose};
use crate::report::reason::{
    absent, after, classes, combination, difference, edits, equation_of, hypothesis, labels,
    missing, place, reason, relations, uniqueness, values, where_it_holds,
};
use crate::verdict::{
    Because, Correction, Given, NonVanishing, Outcome, Proof, Refutation, Rejected, ResidualEntry,
    Searched, Verdict,
};

/// Entries of a matrix residual that are written out.
const ENTRIES: usize = 4;
/// Changes of more characters than this are shown by the corrected equation only.
const LONG: usize = 60;
/// Rejected readings that are listed.
const READINGS: usize = 8;

/// Everything there is to say about one link.
pub fn reasoning(audit: &Audit, formulas: &Formulas, outcome: &Outcome) -> Vec<Block> {
    let formulas = &*formulas.here(&audit.model, outcome);
    let mut blocks = argument(audit, formulas, outcome);
    if let Some(line) = conditions(formulas, &outcome.conditions) {
        blocks.push(Block::paragraph(line));
    }
    blocks
}

/// The same without the conditions.
pub fn argument(audit: &Audit, formulas: &Formulas, outcome: &Outcome) -> Vec<Block> {
    let formulas = &*formulas.here(&audit.model, outcome);
    let mut blocks = Vec::new();
    match &outcome.verdict {
        Verdict::Holds { .. } => {
            let line = reason(audit, formulas, outcome);
            blocks.push(Block::paragraph(
                sentence(line).then(multiplied_out(outcome)),
            ));
        }
        Verdict::HoldsGiven(given, _) => {
            given_blocks(formulas, given, &mut blocks);
            blocks.push(Block::paragraph(multiplied_out(outcome)));
        }
        Verdict::Misprint {
            refutation,
            correction,
        } => {
            refutation_blocks(audit, formulas, outcome, refutation, &mut blocks);
            correction_blocks(audit, formulas, outcome, correction, &mut blocks);
            blocks.extend(effect_block(audit, outcome));
            blocks.push(Block::paragraph(multiplied_out(outcome)));
        }
        Verdict::Refuted(refutation) => {
            refutation_blocks(audit, formulas, outcome, refutation, &mut blocks);
            blocks.extend(effect_block(audit, outcome));
            let settings = &audit.model.equations[outcome.equation].settings;
            if let Some(line) = instead(settings) {
                blocks.push(Block::paragraph(line));
                return blocks;
            }
            blocks.push(Block::paragraph(Prose::of(match refutation.searched {
                Some(Searched { budget: 0, .. }) => {
                    "No correction: the budget is empty.".to_string()
                }
                Some(searched) if searched.tried == 0 => {
                    format!("No correction{}.", super::reason::in_vain(&searched))
                }
                Some(searched) => format!(
                    "No correction{}. Tried were single edits, repeated slips, pairs of edits, and \
                     edits of what it rests on (the budget was {}).",
                    super::reason::in_vain(&searched),
                    searched.budget
                ),
                None if refutation.part.is_some() => {
                    "It lacks a hypothesis, and no correction was looked for.".to_string()
                }
                None => "No correction was looked for.".to_string(),
            })));
        }
        Verdict::Undecided { .. } | Verdict::Definition { .. } | Verdict::Recalled { .. } => {
            blocks.push(Block::paragraph(sentence(reason(audit, formulas, outcome))));
        }
    }
    blocks
}

/// `What holds instead is (6-from-4).`
pub fn instead(settings: &Settings) -> Option<Prose> {
    let instead = settings.instead.as_ref()?;
    Some(Prose::of(format!(
        "What holds instead is ({}).",
        instead.text
    )))
}

/// A line with a capital letter and a full stop is a sentence.
fn sentence(line: Prose) -> Prose {
    line.capitalised().words(". ")
}

fn given_blocks(formulas: &Formulas, given: &Given, blocks: &mut Vec<Block>) {
    blocks.push(Block::paragraph(
        Prose::of("In the printed letters it is no identity; it holds given ")
            .then(hypothesis(formulas, given))
            .words(". Left minus right is a multiple of what vanishes then:"),
    ));
    for entry in given.cofactors.iter().take(ENTRIES) {
        let [latex, plain] = combination(formulas, given, entry);
        let label = place(&entry.entry);
        blocks.push(Block::Display {
            latex: format!(
                "{}\\mathrm{{lhs}} - \\mathrm{{rhs}} = {latex}",
                text_of(&label)
            ),
            plain: format!("{}lhs - rhs = {plain}", label.to_plain()),
        });
    }
    more(given.cofactors.len(), "entries are not identities", blocks);
    if let Some(witness) = &given.counterexample {
        blocks.push(Block::paragraph(
            Prose::of("Without the relation it is false: ")
                .then(values(formulas, witness))
                .words("."),
        ));
    }
}

/// A label in front of a display.
fn text_of(label: &Prose) -> String {
    if label.is_empty() {
        String::new()
    } else {
        format!("\\text{{{}}}", label.to_latex())
    }
}

fn more(count: usize, what: &str, blocks: &mut Vec<Block>) {
    if count > ENTRIES {
        blocks.push(Block::paragraph(Prose::of(format!(
            "In all {count} {what}; the others are in verdicts.json.",
        ))));
    }
}

fn refutation_blocks(
    audit: &Audit,
    formulas: &Formulas,
    outcome: &Outcome,
    refutation: &Refutation,
    blocks: &mut Vec<Block>,
) {
    let absent = missing(refutation);
    let after = after(audit, outcome);
    if !after.is_empty() {
        let line = after.capitalised();
        blocks.push(Block::paragraph(if absent.is_empty() {
            line.words("left minus right is not zero:")
        } else {
            line.words("it is false: ").then(absent).words(".")
        }));
    } else if !absent.is_empty() {
        let rest = if refutation.residual.is_empty() {
            "."
        } else {
            ". Even where that is read as zero, the sides differ:"
        };
        blocks.push(Block::paragraph(
            Prose::of("False as printed: ").then(absent).words(rest),
        ));
    } else {
        blocks.push(Block::paragraph(Prose::of(
            "False as printed; left minus right is not zero:",
        )));
    }
    for entry in refutation.residual.iter().take(ENTRIES) {
        blocks.push(residual(formulas, entry));
    }
    more(refutation.residual.len(), "entries differ", blocks);
    if let Some(witness) = refutation.witness() {
        blocks.push(Block::paragraph(
            Prose::of("An exact point where the sides differ: ")
                .then(values(formulas, witness))
                .words("."),
        ));
    }
    if let Some(contradicted) = &refutation.contradicted {
        blocks.push(Block::paragraph(
            Prose::of(contradicted.clone()).capitalised().words("."),
        ));
    }
    if let Some(part) = &refutation.part {
        blocks.push(Block::paragraph(
            Prose::of("On a part of its domain it is true: it holds ")
                .then(where_it_holds(formulas, part))
                .words("."),
        ));
    }
}

/// `At the reference point printed/true = 1/400.`
fn effect_block(audit: &Audit, outcome: &Outcome) -> Option<Block> {
    let effect = effect(&audit.model, outcome)?;
    let names = if effect.corrected {
        "printed/true"
    } else {
        "left/right"
    };
    Some(Block::paragraph(
        Prose::of("At the reference point ")
            .words(names)
            .then(equals(&effect.ratio().into()))
            .words("."),
    ))
}

fn residual(formulas: &Formulas, entry: &ResidualEntry) -> Block {
    let f = entry.difference();
    let label = place(entry);
    let name = format!("{}\\mathrm{{lhs}} - \\mathrm{{rhs}}", text_of(&label));
    Block::Display {
        latex: formulas.display(&name, &f),
        plain: format!(
            "{}lhs - rhs = {}",
            label.to_plain(),
            difference(formulas, &f)[1]
        ),
    }
}

fn correction_blocks(
    audit: &Audit,
    formulas: &Formulas,
    outcome: &Outcome,
    correction: &Correction,
    blocks: &mut Vec<Block>,
) {
    let class = classes(&correction.edits);
    let change = edits(&correction.edits);
    // A long one is seen in the corrected equation.
    let slip = match change.to_plain().chars().count() > LONG {
        true => Prose::of(format!("The slip is one of {class}")),
        false => Prose::of(format!("The slip is one of {class}: ")).then(change),
    };
    blocks.push(Block::paragraph(
        slip.words(format!(", {}. Corrected it reads", uniqueness(correction))),
    ));
    let equation = &audit.model.equations[outcome.equation];
    if let Some(link) = equation.links.get(outcome.member - 1) {
        let latex = equation_of(&correction.display, link);
        blocks.push(Block::Display {
            plain: plain(&latex),
            latex,
        });
    }
    if let Some(given) = &correction.given {
        blocks.push(Block::paragraph(
            Prose::of("which holds given ")
                .then(relations(formulas, given))
                .words("."),
        ));
    }
    if !correction.alternatives.is_empty() {
        let others = correction
            .alternatives
            .iter()
            .take(READINGS)
            .map(|e| edits(e));
        blocks.push(Block::paragraph(
            Prose::of("Others that would do as well: ")
                .then(Prose::joined(others, "; "))
                .words("."),
        ));
    }
    if correction.rejected.is_empty() {
        return;
    }
    let mut readings: Vec<&Rejected> = correction.rejected.iter().collect();
    readings.sort_by_key(|r| rank(r, correction));
    // The same change in several places is one row.
    let mut rows: Vec<Vec<Prose>> = Vec::new();
    for rejected in readings {
        let reading = if rejected.edits.is_empty() {
            Prose::of("as printed")
        } else {
            edits(&rejected.edits)
        };
        let absent = absent(rejected.missing.as_deref(), rejected.misfit.as_ref());
        let why = match &rejected.witness {
            _ if !absent.is_empty() => absent,
            Some(witness) => {
                let mut here = witness.clone();
                here.point.clear();
                values(formulas, &here)
            }
            None => Prose::of("the sides differ"),
        };
        if !rows.iter().any(|row| row[0] == reading) {
            rows.push(vec![reading, why]);
        }
    }
    // That it is false as printed was said.
    if matches!(&rows[..], [only] if only[0] == Prose::of("as printed")) {
        return;
    }
    let more = rows.len().saturating_sub(READINGS);
    rows.truncate(READINGS);
    blocks.push(Block::paragraph(Prose::of(
        "Other readings of the same places, and what came of them at the reference point:",
    )));
    blocks.push(Block::Table {
        head: vec!["reading".into(), "why not".into()],
        rows,
    });
    if more > 0 {
        blocks.push(Block::paragraph(Prose::of(format!(
            "And {more} more that are not true either, of {} in all.",
            correction.rejected.len()
        ))));
    }
}

/// First what leaves out a part of the correction, then what changes all of its places, then the
/// rest.
fn rank(rejected: &Rejected, correction: &Correction) -> u8 {
    if rejected.edits.iter().all(|e| correction.edits.contains(e)) {
        0
    } else if rejected.edits.len() == correction.edits.len() {
        1
    } else {
        2
    }
}

/// That what proves the verdict was multiplied out.
fn multiplied_out(outcome: &Outcome) -> Prose {
    match outcome.verdict.proof().map_or(0, Proof::entries) {
        0 => Prose::new(),
        1 => Prose::of("Checked by multiplying out the equation."),
        entries => Prose::of(format!("Checked by multiplying out all {entries} entries.")),
    }
}

/// What must not vanish, by the reason why it does not.
pub fn conditions(formulas: &Formulas, conditions: &[NonVanishing]) -> Option<Prose> {
    let positive = |words: &str, is_meant: fn(&Origin) -> bool| {
        let meant = conditions.iter().filter(|c| is_meant(&c.origin));
        let formulas = meant.map(|c| {
            Prose::new().formula(
                formulas.polynomial(&c.factor, Script::Latex),
                formulas.polynomial(&c.factor, Script::Plain),
            )
        });
        let formulas: Vec<Prose> = formulas.collect();
        (!formulas.is_empty()).then(|| {
            Prose::of(words)
                .then(Prose::joined(formulas, ", "))
                .words(".")
        })
    };
    let stable = |o: &Origin| matches!(o, Origin::Stability(_));
    let ranged = |o: &Origin| matches!(o, Origin::Range { .. });
    let stationary = positive("Stationary only where these are positive: ", stable);
    let inside = positive(
        "Within the ranges of the definitions, where these are positive: ",
        |o| matches!(o, Origin::Range { strict: true, .. }),
    );
    let within = positive(
        "Within the ranges of the definitions, where these are not negative: ",
        |o| matches!(o, Origin::Range { strict: false, .. }),
    );
    let both = |first: Option<Prose>, second: Option<Prose>| match (first, second) {
        (Some(first), Some(second)) => Some(first.words(" ").then(second)),
        (one, other) => one.or(other),
    };
    let stationary = both(both(stationary, inside), within);
    let mut groups: Vec<(&Option<Because>, Vec<&NonVanishing>)> = Vec::new();
    let must_be_positive = |c: &&NonVanishing| stable(&c.origin) || ranged(&c.origin);
    for condition in conditions.iter().filter(|c| !must_be_positive(c)) {
        match groups
            .iter_mut()
            .find(|(because, _)| **because == condition.because)
        {
            Some((_, group)) => group.push(condition),
            None => groups.push((&condition.because, vec![condition])),
        }
    }
    if groups.is_empty() {
        return stationary;
    }
    let each = groups.into_iter().map(|(because, group)| {
        let factors = group.iter().map(|c| {
            Prose::new().formula(
                formulas.polynomial(&c.factor, Script::Latex),
                formulas.polynomial(&c.factor, Script::Plain),
            )
        });
        Prose::joined(factors, ", ").words(match because {
            Some(Because::Positive) => " (of positive letters)".to_string(),
            Some(Because::PositiveBy(by)) => format!(" (positive once {} is inserted)", labels(by)),
            Some(Because::Definite(name)) => format!(
                " (a minor of {}, which is positive definite)",
                crate::report::plain::plain(name)
            ),
            Some(Because::Sign) => " (zero for no values of the letters)".to_string(),
            Some(Because::Supposed) => " (by the hypotheses)".to_string(),
            None => " (which nothing declared here ensures)".to_string(),
        })
    });
    let divisors = Prose::of("Divided by, and so not zero: ")
        .then(Prose::joined(each, "; "))
        .words(".");
    Some(match stationary {
        Some(stationary) => divisors.words(" ").then(stationary),
        None => divisors,
    })
}
