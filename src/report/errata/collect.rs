//! What of some audits belongs on the sheets.

use super::{Erratum, Sentence, Sheet, Unwritten, mark};
use crate::audit::Audit;
use crate::check::effect::{BOX, Change, Changes};
use crate::document::{Settings, Text, VerdictWord};
use crate::expr::Display;
use crate::model::Equation;
use crate::model::links::Place;
use crate::report::algebraic::{equals, shown};
use crate::report::formula::Formulas;
use crate::report::prose::Prose;
use crate::report::reason::{
    classes, edits, equation_of, false_because, is_long, labels, number_of, place_of, relations,
    uniqueness,
};
use crate::report::statement;
use crate::theory::algebraic::Algebraic;
use crate::verdict::statement::{Fact, Loose, Scope, StatementOutcome};
use crate::verdict::{Changed, Correction, Outcome, Shown, Verdict};
use num_rational::BigRational;
use num_traits::Signed;

/// A point with more letters than this says less than the formulas.
const WITNESS: usize = 8;

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
                    ..Sheet::default()
                });
                sheets.len() - 1
            }
        };
        let sheet = &mut sheets[index];
        if let Some(source) = source.filter(|s| !sheet.sources.contains(s)) {
            sheet.sources.push(source);
        }
        Collector {
            audit,
            formulas: Formulas::of(&audit.model),
            changes: Changes::of(&audit.model),
        }
        .collect(sheet);
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
        sheet.sources = in_short(std::mem::take(&mut sheet.sources));
        for group in [&mut sheet.sentences, &mut sheet.partly, &mut sheet.nearly] {
            let mut merged: Vec<Sentence> = Vec::new();
            for one in group.drain(..) {
                match merged.iter_mut().find(|known| known.text == one.text) {
                    Some(known) => {
                        let facts = one.facts.into_iter();
                        let more: Vec<Prose> = facts.filter(|f| !known.facts.contains(f)).collect();
                        known.facts.extend(more);
                    }
                    None => merged.push(one),
                }
            }
            *group = merged;
        }
    }
    sheets
}

/// What the places of publication have in common, up to a comma, if that says enough.
fn in_short(sources: Vec<String>) -> Vec<String> {
    let [first, others @ ..] = sources.as_slice() else {
        return sources;
    };
    if others.is_empty() {
        return sources;
    }
    let common = |a: &str, b: &str| {
        let pairs = a.char_indices().zip(b.chars());
        let same = pairs.take_while(|((_, x), y)| x == y);
        same.last().map_or(0, |((at, c), _)| at + c.len_utf8())
    };
    let length = others.iter().map(|o| common(first, o)).min().unwrap_or(0);
    match first[..length].rfind(',') {
        Some(comma) if comma > 20 => vec![first[..comma].to_string()],
        _ => sources,
    }
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

struct Collector<'a> {
    audit: &'a Audit,
    formulas: Formulas,
    changes: Changes<'a>,
}

impl Collector<'_> {
    fn collect(&self, sheet: &mut Sheet) {
        let model = &self.audit.model;
        let part_of_paper = model.document.paper.is_some();
        for (index, equation) in model.equations.iter().enumerate() {
            let outcomes: Vec<&Outcome> = self.audit.outcomes_of(index).collect();
            if !equation.settings.unwritten.is_empty() && outcomes.iter().all(|o| is_true(o)) {
                sheet.unwritten.push(unwritten(equation));
            }
            // An equation that a document adds to the paper's is none of the paper's, but for what
            // stands in its words.
            let settings = &equation.settings;
            let numbered = equation.label.starts_with(|c: char| c.is_ascii_digit());
            if part_of_paper && !numbered && settings.quote.is_none() {
                continue;
            }
            // What a slip in a definition makes false stands with the definition.
            let wrong: Vec<&Outcome> = outcomes
                .iter()
                .copied()
                .filter(|o| is_false(o) && corrected_definition(o).is_none())
                .collect();
            sheet.errata.extend(self.definition(index));
            if !wrong.is_empty() {
                let erratum = self.erratum(equation, &wrong);
                match &settings.quote {
                    Some(quote) => sheet.sentences.push(Sentence {
                        label: equation.label.clone(),
                        place: settings.place.as_ref().map(prose),
                        text: prose(quote),
                        reads: self.reads(settings),
                        // A formula without a correction says less than the words.
                        formula: erratum
                            .corrected
                            .map(|corrected| (erratum.printed, Some(corrected))),
                        facts: erratum
                            .why
                            .into_iter()
                            .map(|why| Prose::of("as a formula it is false: ").then(why))
                            .collect(),
                        source: erratum.source,
                        note: erratum.note,
                    }),
                    None => sheet.errata.push(erratum),
                }
            }
            for outcome in outcomes {
                if let Verdict::HoldsGiven(given, _) = &outcome.verdict {
                    let mut line =
                        relations(&self.formulas.here(&self.audit.model, outcome), given);
                    if !given.implied_by.is_empty() {
                        let by = labels(&given.implied_by);
                        line = line.words(format!(", which {by} implies"));
                    }
                    let number = format!("({})", number_of(self.audit, outcome));
                    match sheet.unwritten.iter_mut().find(|u| u.relations == line) {
                        Some(known) => known.equations.push(number),
                        None => sheet.unwritten.push(Unwritten {
                            relations: line,
                            implied: !given.implied_by.is_empty(),
                            equations: vec![number],
                            note: None,
                        }),
                    }
                }
            }
        }
        for index in 0..model.statements.len() {
            self.sentence(index, sheet);
        }
        let remarks = model.document.remarks.iter().map(prose);
        sheet.remarks.extend(remarks);
    }

    /// A sentence under what is worst about it.
    fn sentence(&self, index: usize, sheet: &mut Sheet) {
        let statement = &self.audit.model.statements[index];
        if statement.own {
            return;
        }
        let outcomes: Vec<&StatementOutcome> = self.audit.outcomes_of_statement(index).collect();
        let of = |wanted: &dyn Fn(&StatementOutcome) -> bool| {
            let wanted = outcomes.iter().filter(|o| wanted(o));
            let facts: Vec<Prose> = wanted.map(|o| self.judgement(o)).collect();
            facts
        };
        let loose = |how: &[Loose]| {
            let how = how.to_vec();
            move |o: &StatementOutcome| o.loose.is_some_and(|l| how.contains(&l))
        };
        let settings = &statement.settings;
        for (facts, group) in [
            (
                of(&|o| o.word == VerdictWord::Refuted),
                &mut sheet.sentences,
            ),
            (
                of(&loose(&[Loose::Nearly, Loose::Otherwise])),
                &mut sheet.nearly,
            ),
            (of(&loose(&[Loose::Partly])), &mut sheet.partly),
        ] {
            if facts.is_empty() {
                continue;
            }
            group.push(Sentence {
                label: statement.label.clone(),
                place: settings.place.as_ref().map(prose),
                text: Prose::text(&statement.sentence),
                reads: self.reads(settings),
                formula: None,
                facts,
                source: source(settings),
                note: settings.note.as_ref().map(prose),
            });
            return;
        }
    }

    /// What is said of what was read, and the facts that show it.
    fn judgement(&self, outcome: &StatementOutcome) -> Prose {
        let Some(proposition) = statement::proposition_of(self.audit, outcome) else {
            return Prose::text(outcome.reason.as_deref().unwrap_or_default());
        };
        let said = match (outcome.word, outcome.loose) {
            (_, Some(Loose::Nearly)) => "true only approximately",
            (_, Some(Loose::Partly)) => "true at the reference values, and not for all",
            (_, Some(Loose::Otherwise)) => "false, while another reading is true",
            (VerdictWord::Refuted, _) => "false",
            (word, _) => word.as_str(),
        };
        let line = Prose::of("read “")
            .then(statement::claim(self.audit, &self.formulas, proposition))
            .words(format!("”, it is {said}"));
        // The first fact, and what is known of the box.
        let in_box = |f: &Fact| matches!(f, Fact::Sign(_, _, Scope::Box(_)));
        let shown = statement::facts(self.audit, &self.formulas, outcome);
        let facts = outcome.facts.iter().zip(shown).enumerate();
        let facts = facts.filter(|(k, (fact, _))| *k == 0 || in_box(fact));
        let facts: Vec<Prose> = facts.take(2).map(|(_, (_, words))| words).collect();
        match facts.is_empty() {
            true => line,
            false => line.words(": ").then(Prose::joined(facts, "; ")),
        }
    }

    /// How a sentence should read: as the document says, or as the sentence that is meant instead.
    fn reads(&self, settings: &Settings) -> Option<Prose> {
        if let Some(reads) = &settings.reads {
            return Some(prose(reads));
        }
        let model = &self.audit.model;
        let statement = model.statement(&settings.instead.as_ref()?.text)?;
        Some(Prose::text(&model.statements[statement].sentence))
    }

    /// The equation that is meant instead of a false one.
    fn meant(&self, settings: &Settings) -> Option<&Equation> {
        let model = &self.audit.model;
        let index = model.equation(&settings.instead.as_ref()?.text)?;
        Some(&model.equations[index])
    }

    /// The slip in a definition that makes some claims false.
    fn definition(&self, index: usize) -> Option<Erratum> {
        let of = |o: &&Outcome| corrected_definition(o).is_some_and(|(d, _)| d == index);
        let claims: Vec<&Outcome> = self.audit.outcomes.iter().filter(of).collect();
        let (first, equation) = (claims.first()?, &self.audit.model.equations[index]);
        let Verdict::Misprint { correction, .. } = &first.verdict else {
            return None;
        };
        let (_, display) = corrected_definition(first)?;
        let body = self.body_of(equation);
        let pair = [&equation.display, display];
        let signature = &self.audit.model.signature;
        let [printed, corrected] = mark::displays(&body.text, body.span.start, pair, signature);
        let slip = Prose::of(classes(&correction.edits))
            .words(format!("; {}", uniqueness(correction)))
            .words("; what rests on it is true then");
        let named = |outcome: &Outcome, rest: Prose| {
            Prose::of(format!("({}): ", number_of(self.audit, outcome))).then(rest)
        };
        let why = claims.iter().filter_map(|o| Some(named(o, self.why(o)?)));
        let effects = claims
            .iter()
            .filter_map(|o| Some(named(o, effect(&self.changes.by(o))?)));
        let settings = &equation.settings;
        Some(Erratum {
            location: location(equation),
            printed,
            corrected: Some(corrected),
            mended: true,
            corrections: vec![slip],
            why: why.collect(),
            effects: effects.collect(),
            source: source(settings),
            note: settings.note.as_ref().map(prose),
        })
    }

    fn erratum(&self, equation: &Equation, wrong: &[&Outcome]) -> Erratum {
        let several = equation.links.len() > 1;
        let correction = |o: &Outcome| match &o.verdict {
            Verdict::Misprint { correction, .. } => Some(Box::clone(correction)),
            _ => None,
        };
        let last = wrong
            .iter()
            .rev()
            .filter_map(|o| correction(o))
            .find(|c| c.definition.is_none());
        let (printed, corrected) = match last {
            Some(last) if !wrong.iter().any(|o| is_about_a_brace(equation, o)) => {
                let body = self.body_of(equation);
                let pair = [&equation.display, &last.display];
                let signature = &self.audit.model.signature;
                let [old, new] = mark::displays(&body.text, body.span.start, pair, signature);
                // A correction elsewhere leaves the equation as it is.
                let changed = old != new;
                (old, changed.then_some(new))
            }
            Some(last) => self.one_link(equation, wrong, &last),
            None => {
                let meant = self.meant(&equation.settings).map(|e| &e.source);
                let other = meant.filter(|source| **source != equation.source);
                let other = other.map(|source| source.trim().to_string());
                (equation.source.trim().to_string(), other)
            }
        };
        let meant = self.meant(&equation.settings);
        let mut corrections = Vec::new();
        let mut why = Vec::new();
        let mut effects = Vec::new();
        for outcome in wrong {
            let name = match several {
                true => Prose::of(format!("({}): ", number_of(self.audit, outcome))),
                false => Prose::new(),
            };
            let line = match correction(outcome) {
                None if meant.is_some() => Prose::of(format!(
                    "what holds is ({})",
                    meant.map_or("", |e| &e.label)
                )),
                None => Prose::of("no correction was found"),
                Some(correction) => {
                    let line = Prose::of(classes(&correction.edits));
                    // Where the displays show the change, it is not said again.
                    let line = match corrected {
                        Some(_) => line,
                        None => line.words(": ").then(edits(&correction.edits)),
                    };
                    line.words(format!("; {}", uniqueness(&correction)))
                }
            };
            corrections.push(name.clone().then(line));
            why.extend(self.why(outcome).map(|because| name.clone().then(because)));
            if let Some(effect) = effect(&self.changes.by(outcome)) {
                effects.push(name.then(effect));
            }
        }
        let settings = &equation.settings;
        Erratum {
            location: location(equation),
            printed,
            corrected,
            mended: meant.is_some() || wrong.iter().all(|o| correction(o).is_some()),
            corrections,
            why,
            effects,
            source: source(settings),
            note: settings.note.as_ref().map(prose),
        }
    }

    /// The LaTeX of an equation at its place in the document.
    fn body_of(&self, equation: &Equation) -> Text {
        let found = self.audit.model.document.equation(&equation.label);
        found.map_or_else(
            || Text {
                text: equation.source.clone(),
                span: equation.span,
            },
            |e| e.body.clone(),
        )
    }

    /// Of a correction that only a brace asks for, the link that it makes true.
    fn one_link(
        &self,
        equation: &Equation,
        wrong: &[&Outcome],
        correction: &Correction,
    ) -> (String, Option<String>) {
        let about = wrong.iter().find(|o| is_about_a_brace(equation, o));
        match about.or(wrong.first()) {
            Some(outcome) => {
                let link = &equation.links[outcome.member - 1];
                (
                    equation_of(&equation.display, link),
                    Some(equation_of(&correction.display, link)),
                )
            }
            None => (equation.source.clone(), None),
        }
    }

    /// Why an equation is false; none where there is only the length of a difference to tell.
    fn why(&self, outcome: &Outcome) -> Option<Prose> {
        let (Verdict::Misprint { refutation, .. } | Verdict::Refuted(refutation)) =
            &outcome.verdict
        else {
            return None;
        };
        let formulas = self.formulas.here(&self.audit.model, outcome);
        // Only the first entry's difference would be shown.
        let shown = match refutation.shown() {
            Shown::Point(witness) => witness.point.len() <= WITNESS,
            Shown::Structure(_) | Shown::CounterProof(_) => true,
        };
        let first = refutation.residual.first();
        let long = first.is_some_and(|e| is_long(&formulas, e));
        if !shown && refutation.part.is_none() && long {
            return None;
        }
        let reason = false_because(self.audit, &formulas, outcome, refutation, WITNESS);
        (!reason.is_empty()).then_some(reason)
    }
}

fn prose(text: &Text) -> Prose {
    Prose::text(&text.text)
}

fn source(settings: &Settings) -> Option<(crate::document::Source, Prose)> {
    let because = settings.because.as_ref().map(prose).unwrap_or_default();
    settings.likelier.map(|source| (source, because))
}

fn is_false(outcome: &Outcome) -> bool {
    matches!(
        outcome.verdict,
        Verdict::Misprint { .. } | Verdict::Refuted(_)
    )
}

/// The definition that is corrected instead of a claim, and how it should read.
fn corrected_definition(outcome: &Outcome) -> Option<(usize, &Display)> {
    match &outcome.verdict {
        Verdict::Misprint { correction, .. } => {
            let (definition, display) = correction.definition.as_ref()?;
            Some((*definition, display))
        }
        _ => None,
    }
}

fn is_true(outcome: &Outcome) -> bool {
    matches!(
        outcome.verdict.word(),
        VerdictWord::Holds | VerdictWord::HoldsGiven | VerdictWord::Definition
    )
}

/// Whether a correction changes what stands above a brace because of what stands below it.
fn is_about_a_brace(equation: &Equation, outcome: &Outcome) -> bool {
    match &outcome.verdict {
        Verdict::Misprint { correction, .. } => {
            let link = &equation.links[outcome.member - 1];
            matches!(link.right, Place::Body { .. }) && correction.changed.contains(&Changed::Right)
        }
        _ => false,
    }
}

/// What a document says that the paper does not write.
fn unwritten(equation: &Equation) -> Unwritten {
    let formula = equation.source.trim().trim_end_matches(['.', ',']);
    let needed = equation.settings.unwritten.iter();
    Unwritten {
        implied: false,
        relations: Prose::new().formula(
            crate::report::latex::printed::printed(formula),
            crate::report::plain::plain(formula),
        ),
        equations: needed.map(|label| format!("({})", label.text)).collect(),
        note: equation.settings.note.as_ref().map(prose),
    }
}

/// `(61)`, with the other equations that might be false instead.
fn location(equation: &Equation) -> String {
    // A label such as `16-slope` is the document's name for a formula in the text.
    let number = match equation.label.split_once('-') {
        Some((number, _)) if number.parse::<u32>().is_ok() => {
            format!("({number}), the text beside it")
        }
        _ => format!("({})", equation.label),
    };
    let others = equation
        .settings
        .or
        .iter()
        .map(|o| format!(" or ({})", o.text));
    number + &others.collect::<String>()
}

/// `At the reference values the printed value is 2.5 % too large; between ... over the box`: of the entry
/// that changes most.
fn effect(changes: &[Change]) -> Option<Prose> {
    let most = changes
        .iter()
        .filter(|c| c.at_reference.is_some() || c.range.is_some())
        .max_by_key(|c| c.at_reference.as_ref().map(Signed::abs))?;
    let mut line = Prose::of("printed/correct − 1");
    let constant = match &most.range {
        Some((least, greatest)) if least.compare(greatest).is_eq() => Some(least.clone()),
        _ => None,
    };
    let everywhere = constant.is_some();
    // What is zero as printed, such as a distribution at a wrong argument, has no size to compare.
    let zero = |value: &Algebraic| {
        let minus_one = BigRational::from_integer((-1).into());
        value.compare(&minus_one.into()).is_eq()
    };
    if constant.as_ref().is_some_and(zero) {
        return None;
    }
    if let Some(value) = constant {
        line = line.then(equals(&value)).words(" everywhere");
    } else if let Some(value) = &most.at_reference {
        line = line
            .then(equals(&value.clone().into()))
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
