//! Each statement with its sentence as printed, and what was found about it.

use super::Tex;
use super::escape::escape;
use crate::audit::Audit;
use crate::report::explain::likelier;
use crate::report::formula::Formulas;
use crate::report::prose::Prose;
use crate::report::statement::{claim, facts, number_of, proposition_of};
use crate::standing::Standing;
use crate::verdict::statement::SignCertificate;

/// So many facts about a proposition are read; the others are in the file for programs.
const FACTS: usize = 5;

pub(super) fn write(tex: &mut Tex, audit: &Audit, formulas: &Formulas) {
    if audit.model.statements.is_empty() {
        return;
    }
    tex.heading("The statements one by one");
    let all = &audit.statements;
    let signs = || all.iter().flat_map(|o| &o.signs);
    if signs().next().is_some() {
        let by_engine: Vec<String> = all
            .iter()
            .filter(|o| o.signs.iter().any(|s| !s.is_elementary()))
            .map(|o| number_of(audit, o))
            .collect();
        let mut line = Prose::of(match signs().all(SignCertificate::verify) {
            true => {
                "The signs were checked by multiplying out their factors, each with coefficients of \
                 one sign or completed to a square"
            }
            false => "The certificate of a sign does not verify: this is a fault of the program",
        });
        if !by_engine.is_empty() {
            line = line.words(format!(
                "; in {} the sign of a factor is what the polynomial engine found",
                by_engine.join(", ")
            ));
        }
        tex.paragraph(&line.words("."));
    }
    for (index, statement) in audit.model.statements.iter().enumerate() {
        let source = match statement.own {
            true => "in the words of the document",
            false => "as printed",
        };
        tex.line(&format!(
            "\n\\paragraph{{Statement {},}} {source}: ``{}''",
            escape(&statement.label),
            Prose::text(&statement.sentence).to_latex()
        ));
        if let Some(note) = &statement.settings.note {
            tex.paragraph(&Prose::of("Note: ").then(Prose::text(&note.text)));
        }
        if let Some(words) = likelier(&statement.settings) {
            tex.paragraph(&words);
        }
        for (words, text) in [
            ("It should read: “", &statement.settings.reads),
            ("What holds instead is (", &statement.settings.instead),
        ] {
            if let Some(text) = text {
                let end = if words.ends_with('(') { ")." } else { "”" };
                tex.paragraph(&Prose::of(words).then(Prose::text(&text.text)).words(end));
            }
        }
        for outcome in audit.outcomes_of_statement(index) {
            let number = number_of(audit, outcome);
            let mut prose = Prose::new().strong(format!("{number} {}", outcome.word));
            if let Some(proposition) = proposition_of(audit, outcome) {
                prose = prose.words(": ").then(claim(audit, formulas, proposition));
            }
            prose = prose.words(". ");
            if audit.standing_of_statement(outcome) == Standing::Differs {
                prose = prose.words(match statement.expected(outcome.member) {
                    Some(word) => format!("The document expects: {word}. "),
                    None => "The document records no verdict. ".to_string(),
                });
            }
            // One paragraph for all facts.
            let all = facts(audit, formulas, outcome);
            let more = all.len().saturating_sub(FACTS);
            for fact in all.into_iter().take(FACTS) {
                prose = prose.then(fact.capitalised()).words(". ");
            }
            if more > 0 {
                prose = prose.words(format!("More facts ({more}) are in verdicts.json. "));
            }
            if let Some(reason) = &outcome.reason {
                prose = prose.then(Prose::text(reason).capitalised()).words(".");
            }
            tex.paragraph(&prose);
        }
    }
}
