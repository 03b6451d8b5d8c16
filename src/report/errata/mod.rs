//! The errata sheet of a paper: where, as printed, as it should read, why, and what it changes.
//!
//! It says only what a verdict says. What is likelier a slip of the transcription is kept apart: it
//! has to be compared with the printed page before anybody writes to a journal.

mod latex;
mod mark;
mod markdown;

pub use latex::latex;
pub use markdown::markdown;

use crate::audit::Audit;
use crate::check::effect::{BOX, Change, Changes};
use crate::document::{Source, VerdictWord};
use crate::report::algebraic::shown;
use crate::report::formula::Formulas;
use crate::report::prose::Prose;
use crate::report::reason::{bare_reason, edits, number_of, place_of, relations, side, uniqueness};
use crate::report::statement;
use crate::verdict::{Correction, Outcome, Refutation, Verdict};
use num_rational::BigRational;
use num_traits::Signed;

/// A point with more letters than this says less than the formulas.
const WITNESS: usize = 8;

/// The errata of one paper, or of one document that names no paper.
#[derive(Clone, Debug)]
pub struct Sheet {
    /// The paper.
    pub title: String,
    /// Where it was published, from its documents.
    pub sources: Vec<String>,
    /// What is false, in the order of the numbers.
    pub errata: Vec<Erratum>,
    /// Hypotheses that equations need and the paper does not write.
    pub unwritten: Vec<Unwritten>,
    /// Sentences that are false.
    pub sentences: Vec<Sentence>,
    /// How many sentences are true only approximately.
    pub loose: usize,
}

/// A false equation.
#[derive(Clone, Debug)]
pub struct Erratum {
    /// `(61), second equality`.
    pub location: String,
    /// The link as printed, in LaTeX, with what is wrong underlined.
    pub printed: String,
    /// As it should read, with what changed underlined; none where no correction is known, or where it
    /// changes something outside of the link.
    pub corrected: Option<String>,
    /// Whether a correction is known.
    pub mended: bool,
    /// What kind of slip, and how sure the correction is.
    pub correction: Prose,
    /// Why it is false.
    pub why: Prose,
    /// What it changes.
    pub effect: Option<Prose>,
    /// Where it came in, and why that is thought.
    pub source: Option<(Source, String)>,
    /// The document's own remark.
    pub note: Option<String>,
}

/// Equations that hold only under relations which the definitions imply.
#[derive(Clone, Debug)]
pub struct Unwritten {
    /// The relations, and which equations imply them.
    pub relations: Prose,
    /// The equations that need them.
    pub equations: Vec<String>,
}

/// A false sentence.
#[derive(Clone, Debug)]
pub struct Sentence {
    /// As printed.
    pub text: String,
    /// What it says, and what is the case.
    pub facts: Vec<Prose>,
}

/// The sheets of some documents: one for each paper, in the order of their first documents.
pub fn sheets(audits: &[&Audit]) -> Vec<Sheet> {
    let mut sheets: Vec<Sheet> = Vec::new();
    for audit in audits {
        let document = &audit.model.document;
        let title = match &document.paper {
            Some(paper) => &paper.title.text,
            None => &document.title,
        };
        let source = document.source.as_ref().map(|s| s.text.clone());
        let index = match sheets.iter().position(|s| s.title == *title) {
            Some(index) => index,
            None => {
                sheets.push(Sheet {
                    title: title.clone(),
                    sources: Vec::new(),
                    errata: Vec::new(),
                    unwritten: Vec::new(),
                    sentences: Vec::new(),
                    loose: 0,
                });
                sheets.len() - 1
            }
        };
        let sheet = &mut sheets[index];
        if let Some(source) = source.filter(|s| !sheet.sources.contains(s)) {
            sheet.sources.push(source);
        }
        collect(sheet, audit);
    }
    for sheet in &mut sheets {
        sheet.errata.sort_by_key(|e| number_in(&e.location));
        // What stands in several documents is one slip of the paper.
        let mut known: Vec<[String; 2]> = Vec::new();
        sheet.errata.retain(|e| {
            let key = [e.printed.clone(), e.corrected.clone().unwrap_or_default()];
            let is_new = !known.contains(&key);
            known.push(key);
            is_new
        });
    }
    sheets
}

/// The number that a label begins with: (5) comes before (12).
fn number_in(location: &str) -> usize {
    let digits: String = location
        .trim_start_matches('(')
        .chars()
        .take_while(char::is_ascii_digit)
        .collect();
    digits.parse().unwrap_or(usize::MAX)
}

fn collect(sheet: &mut Sheet, audit: &Audit) {
    let model = &audit.model;
    let formulas = Formulas::of(model);
    let changes = Changes::of(model);
    let part_of_paper = model.document.paper.is_some();
    for outcome in &audit.outcomes {
        let label = &model.equations[outcome.equation].label;
        // An equation that a document adds to the paper's is none of the paper's.
        if part_of_paper && !label.starts_with(|c: char| c.is_ascii_digit()) {
            continue;
        }
        match &outcome.verdict {
            Verdict::Misprint {
                refutation,
                correction,
            } => {
                let correction = Some(&**correction);
                let erratum = erratum(audit, &formulas, outcome, refutation, correction);
                sheet.errata.push(Erratum {
                    effect: effect(&changes.by(outcome)),
                    ..erratum
                });
            }
            Verdict::Refuted(refutation) => {
                sheet
                    .errata
                    .push(erratum(audit, &formulas, outcome, refutation, None));
            }
            Verdict::HoldsGiven(given) => {
                let mut line = relations(&formulas, given);
                if !given.implied_by.is_empty() {
                    let by = crate::report::reason::labels(&given.implied_by);
                    line = line.words(format!(", which {by} implies"));
                }
                let number = format!("({})", number_of(audit, outcome));
                match sheet.unwritten.iter_mut().find(|u| u.relations == line) {
                    Some(known) => known.equations.push(number),
                    None => sheet.unwritten.push(Unwritten {
                        relations: line,
                        equations: vec![number],
                    }),
                }
            }
            _ => {}
        }
    }
    for (index, printed) in model.statements.iter().enumerate() {
        let mut facts = Vec::new();
        for outcome in audit.outcomes_of_statement(index) {
            match outcome.word {
                VerdictWord::Refuted => facts.push(statement::reason(audit, &formulas, outcome)),
                VerdictWord::Loose => sheet.loose += 1,
                _ => {}
            }
        }
        if !facts.is_empty() {
            sheet.sentences.push(Sentence {
                text: printed.sentence.clone(),
                facts,
            });
        }
    }
}

fn erratum(
    audit: &Audit,
    formulas: &Formulas,
    outcome: &Outcome,
    refutation: &Refutation,
    correction: Option<&Correction>,
) -> Erratum {
    let equation = &audit.model.equations[outcome.equation];
    let link = &equation.links[outcome.member - 1];
    let relation = crate::latex::write_relation(link.relation);
    let joined = |[left, right]: [String; 2]| match link.left == link.right {
        true => left,
        false => format!("{left} {relation} {right}"),
    };
    let places = [link.left, link.right];
    let (printed, corrected) = match correction {
        None => (joined(places.map(|p| side(&equation.display, p))), None),
        Some(correction) => {
            let pairs = places.map(|place| {
                let old = place.find(&equation.display);
                let new = place.find(&correction.display);
                match (old, new) {
                    (Some(old), Some(new)) => mark::marked(old, new),
                    _ => [side(&equation.display, place), String::new()],
                }
            });
            let [left, right] = pairs;
            let [old, new] = [0, 1].map(|k| joined([left[k].clone(), right[k].clone()]));
            // A correction elsewhere, as of where a limit is taken, leaves the link as it is.
            let changed = old != new;
            (old, changed.then_some(new))
        }
    };
    let mut shorter = refutation.clone();
    shorter.witness = shorter.witness.filter(|w| w.point.len() <= WITNESS);
    let why = bare_reason(
        audit,
        formulas,
        &Outcome {
            verdict: Verdict::Refuted(shorter),
            ..outcome.clone()
        },
    );
    let words = match correction {
        None => Prose::of("no correction was found"),
        Some(correction) => {
            let class = correction.edits.first().map_or("", |e| e.class.as_str());
            let line = Prose::of(class);
            // Where the displays show the change, it is not said again.
            let line = match corrected {
                Some(_) => line,
                None => line.words(": ").then(edits(&correction.edits)),
            };
            line.words(format!("; {}", uniqueness(correction)))
        }
    };
    let settings = &equation.settings;
    let because = settings.because.as_ref().map(|t| t.text.clone());
    Erratum {
        location: location(audit, outcome),
        printed,
        corrected,
        mended: correction.is_some(),
        correction: words,
        why,
        effect: None,
        source: settings.likelier.map(|s| (s, because.unwrap_or_default())),
        note: settings.note.as_ref().map(|n| n.text.clone()),
    }
}

/// `(61), link 2`; links are the neighbours in a chain of equalities, counted in the order of reading.
fn location(audit: &Audit, outcome: &Outcome) -> String {
    let equation = &audit.model.equations[outcome.equation];
    // A label such as `16-slope` is the document's name for a formula in the text.
    let number = match equation.label.split_once('-') {
        Some((number, _)) if number.parse::<u32>().is_ok() => {
            format!("({number}), the text beside it")
        }
        _ => format!("({})", equation.label),
    };
    if equation.links.len() == 1 {
        number
    } else {
        format!("{number}, link {}", outcome.member)
    }
}

/// `At the reference values the printed value is 2.5 % too large; between ... over the box`: of the entry
/// that changes most.
fn effect(changes: &[Change]) -> Option<Prose> {
    let most = changes
        .iter()
        .filter(|c| c.at_reference.is_some() || c.range.is_some())
        .max_by_key(|c| c.at_reference.as_ref().map(Signed::abs))?;
    let mut line = Prose::of("printed/correct − 1 = ");
    let constant = match &most.range {
        Some((least, greatest)) if least.compare(greatest).is_eq() => Some(least.clone()),
        _ => None,
    };
    let everywhere = constant.is_some();
    if let Some(value) = constant {
        line = line.then(shown(&value)).words(" everywhere");
    } else if let Some(value) = &most.at_reference {
        line = line
            .then(shown(&value.clone().into()))
            .words(" at the reference values");
    } else {
        return None;
    }
    if let (false, Some((least, greatest))) = (everywhere, &most.range) {
        let times = BOX.map(|(n, d)| BigRational::new(n.into(), d.into()).to_string());
        line = line
            .words(", between ")
            .then(shown(least))
            .words(" and ")
            .then(shown(greatest))
            .words(format!(
                " where each letter lies between {} and {} of its reference value",
                times[0], times[1]
            ));
    }
    let place = place_of(most.place, &most.indices).to_plain();
    let place = place.trim_end_matches(": ");
    if !place.is_empty() {
        line = line.words(format!(", in {place}"));
    }
    let others = changes.len() - 1;
    if others > 0 {
        line = line.words(format!(", the largest of {} entries", others + 1));
    }
    Some(line)
}

impl Sheet {
    /// Errata of the paper, those of unknown origin among them, and those that are likelier slips of
    /// the transcription.
    fn by_source(&self) -> [Vec<&Erratum>; 2] {
        let (ours, theirs) = self
            .errata
            .iter()
            .partition(|e| matches!(e.source, Some((Source::Transcription, _))));
        [theirs, ours]
    }

    /// Whether there is nothing to send.
    pub fn is_empty(&self) -> bool {
        self.errata.is_empty()
            && self.unwritten.is_empty()
            && self.sentences.is_empty()
            && self.loose == 0
    }

    /// What the sheet says first.
    fn summary(&self) -> String {
        let [theirs, ours] = self.by_source();
        let open = theirs.iter().filter(|e| !e.mended).count();
        let count = |n: usize, one: &str, many: &str| match n {
            1 => format!("one {one}"),
            n => format!("{n} {many}"),
        };
        let mut parts = vec![count(theirs.len(), "false equation", "false equations")];
        if open > 0 {
            parts.push(format!("{open} of them without a correction"));
        }
        if !ours.is_empty() {
            parts.push(format!(
                "{} that may be slips of the transcription",
                ours.len()
            ));
        }
        if !self.unwritten.is_empty() {
            let equations: usize = self.unwritten.iter().map(|u| u.equations.len()).sum();
            parts.push(format!(
                "{} given a relation that is not written",
                count(equations, "true equation", "true equations")
            ));
        }
        if !self.sentences.is_empty() {
            parts.push(count(
                self.sentences.len(),
                "false sentence",
                "false sentences",
            ));
        }
        if self.loose > 0 {
            parts.push(format!("{} true only approximately", self.loose));
        }
        parts.join("; ")
    }
}
