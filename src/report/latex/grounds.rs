//! Beside the headline: how many of the numbered equations were checked and how many only name
//! something, and what the verdicts rest on.

use super::Tex;
use crate::audit::Audit;
use crate::document::VerdictWord;
use crate::inspection::Inspection;
use crate::paper::Paper;
use crate::report::prose::Prose;

pub(super) fn write(tex: &mut Tex, paper: &Paper, inspections: &[Inspection]) {
    let audits: Vec<&Audit> = paper
        .documents
        .iter()
        .map(|d| &inspections[*d].audit)
        .collect();
    let (mut checked, mut named, mut recalled) = (0, Vec::new(), Vec::new());
    for number in &paper.announced {
        let words: Vec<VerdictWord> = audits
            .iter()
            .filter_map(|audit| Some((audit, audit.model.equation(&number.to_string())?)))
            .flat_map(|(audit, e)| audit.outcomes_of(e).map(|o| o.verdict.word()))
            .collect();
        let only = |word: VerdictWord| words.iter().all(|w| *w == word);
        if only(VerdictWord::Recalled) {
            recalled.push(*number);
        } else if words
            .iter()
            .all(|w| matches!(w, VerdictWord::Definition | VerdictWord::Recalled))
        {
            named.push(*number);
        } else {
            checked += 1;
        }
    }
    let listed = |numbers: &[u32]| {
        let numbers: Vec<String> = numbers.iter().map(|n| format!("({n})")).collect();
        numbers.join(", ")
    };
    let verb = |n: usize, one: &str, many: &str| match n {
        1 => format!("one {one}"),
        n => format!("{n} {many}"),
    };
    let mut line = Prose::of(format!(
        "Of these, {} something that was checked",
        verb(checked, "says", "say")
    ));
    if !named.is_empty() {
        line = line.words(format!(
            "; {} names their values, which the others use: {}",
            verb(named.len(), "only gives", "only give"),
            listed(&named)
        ));
    }
    if !recalled.is_empty() {
        line = line.words(format!(
            "; {} stated without anything to check: {}",
            verb(recalled.len(), "is", "are"),
            listed(&recalled)
        ));
    }
    tex.paragraph(&line.words("."));
    let grounds: Vec<Prose> = audits.iter().filter_map(|audit| ground(audit)).collect();
    if !grounds.is_empty() {
        let all = Prose::joined(grounds, "; ");
        tex.paragraph(&Prose::of("What they rest on: ").then(all).words("."));
    }
}

/// `(1), (4) to (9)`: three and more in a row by the first and the last.
fn runs(numbers: &[u32]) -> String {
    let follows = |one: &u32, next: &u32| *next == one + 1;
    let parts = numbers.chunk_by(follows).flat_map(|run| match run {
        [first, _, .., last] => vec![format!("({first}) to ({last})")],
        short => short.iter().map(|n| format!("({n})")).collect(),
    });
    parts.collect::<Vec<_>>().join(", ")
}

/// `(4), (5): f = 2, 3` and what else the verdicts of a document rest on.
fn ground(audit: &Audit) -> Option<Prose> {
    let document = &audit.model.document;
    let numbers: Vec<u32> = document.announced_numbers().collect();
    if numbers.is_empty() {
        return None;
    }
    let about = runs(&numbers);
    let sizes = document.instance_letters.iter().map(|(letter, values)| {
        let values: Vec<String> = values.iter().map(usize::to_string).collect();
        Prose::new()
            .math(letter.text.clone())
            .words(format!(" = {}", values.join(", ")))
    });
    let mut parts: Vec<Prose> = sizes.collect();
    parts.extend(document.rests_on.iter().map(|t| Prose::text(&t.text)));
    if parts.is_empty() {
        return None;
    }
    Some(Prose::of(format!("{about} on ")).then(Prose::joined(parts, ", ")))
}
