//! One `cargo test` per claim.
//!
//! In the `Cargo.toml` of another crate:
//!
//! ```toml
//! [dev-dependencies]
//! rederive = "0.1"
//!
//! [[test]]
//! name = "derivations"
//! harness = false
//! ```
//!
//! and in its `tests/derivations.rs`:
//!
//! ```no_run
//! fn main() -> std::process::ExitCode {
//!     rederive::harness::run(&["proofs"])
//! }
//! ```
//!
//! Every link of every equation becomes a test such as `quarter_car::eq_61_2`, so that
//! `cargo test eq_61` runs those of equation (61); every proposition of a statement becomes one
//! such as `quarter_car::statement_safety_1`, so that `cargo test statement_` runs these; `quarter_car::coverage` asks that every
//! announced number has a verdict. A test passes when the verdict is the one that the document
//! records, or, where none is recorded, when the equation is true. An undecided one fails.

use crate::audit::Audit;
use crate::check::Options;
use crate::document::VerdictWord;
use crate::input;
use crate::report::explain;
use crate::report::formula::Formulas;
use crate::report::reason::reason;
use crate::report::reasoning::reasoning;
use crate::report::statement;
use crate::report::terminal;
use crate::standing::Standing;
use crate::verdict::Outcome;
use crate::verdict::statement::StatementOutcome;
use libtest_mimic::{Failed, Trial};
use std::path::Path;
use std::process::ExitCode;

/// Runs the claims of the documents in these files and folders as tests, with the arguments that
/// `cargo test` gives to this process. The paths are relative to the package's root.
pub fn run<P: AsRef<Path>>(paths: &[P]) -> ExitCode {
    let arguments = libtest_mimic::Arguments::from_args();
    libtest_mimic::run(&arguments, trials(paths)).exit_code()
}

/// The tests of the documents in these files and folders.
pub fn trials<P: AsRef<Path>>(paths: &[P]) -> Vec<Trial> {
    let mut modules: Vec<String> = Vec::new();
    let mut trials = Vec::new();
    for document in input::read(paths) {
        let name = match &document {
            Ok(document) => document.name.clone(),
            Err(rejection) => rejection.name.clone(),
        };
        let module = unused(&module_names(&name), &modules);
        modules.push(module.clone());
        match document.and_then(|d| Audit::of(&d, Options::default())) {
            Ok(audit) => trials.extend(claims(&audit, &module)),
            Err(rejection) => trials.push(Trial::test(format!("{module}::reads"), move || {
                Err(Failed::from(rejection.to_string()))
            })),
        }
    }
    trials
}

fn claims(audit: &Audit, module: &str) -> Vec<Trial> {
    let formulas = Formulas::of(&audit.model);
    let mut trials: Vec<Trial> = audit
        .outcomes
        .iter()
        .map(|outcome| {
            let equation = &audit.model.equations[outcome.equation];
            let label = identifier(&equation.label);
            let name = format!("{module}::eq_{label}_{}", outcome.member);
            let failure = match audit.standing(outcome) {
                Standing::AsExpected => None,
                Standing::Differs | Standing::Undecided => Some(failure(audit, &formulas, outcome)),
            };
            Trial::test(name, move || match failure {
                None => Ok(()),
                Some(words) => Err(Failed::from(words)),
            })
        })
        .collect();
    trials.extend(statements(audit, &formulas, module));
    let coverage = audit.coverage();
    let words = terminal::coverage(audit);
    let drawn = audit.figure_coverage().absent.is_empty();
    let whole = drawn && coverage.covered() == coverage.announced.len();
    trials.push(Trial::test(format!("{module}::coverage"), move || {
        if whole {
            Ok(())
        } else {
            Err(Failed::from(words))
        }
    }));
    trials
}

fn statements(audit: &Audit, formulas: &Formulas, module: &str) -> Vec<Trial> {
    let trial = |outcome: &StatementOutcome| {
        let settled = &audit.model.statements[outcome.statement];
        let label = identifier(&settled.label);
        let name = format!("{module}::statement_{label}_{}", outcome.member);
        let failure = match audit.standing_of_statement(outcome) {
            Standing::AsExpected => None,
            Standing::Differs | Standing::Undecided => Some(format!(
                "{}: {}, {}\n  \"{}\"\n  {}\n{}",
                statement::number_of(audit, outcome),
                outcome.word,
                recorded(settled.expected(outcome.member)),
                settled.sentence,
                statement::reason(audit, formulas, outcome).to_plain(),
                explain::plain_blocks(&statement::reasoning(audit, formulas, outcome), 100)
            )),
        };
        Trial::test(name, move || match failure {
            None => Ok(()),
            Some(words) => Err(Failed::from(words)),
        })
    };
    audit.statements.iter().map(trial).collect()
}

fn recorded(expected: Option<VerdictWord>) -> String {
    match expected {
        Some(word) => format!("the document records: {word}"),
        None => "the document records no verdict".to_string(),
    }
}

/// What a failed test prints: the verdict and the recorded one, residual, witness.
fn failure(audit: &Audit, formulas: &Formulas, outcome: &Outcome) -> String {
    let equation = &audit.model.equations[outcome.equation];
    let expected = recorded(equation.expected(outcome.member));
    let blocks = reasoning(audit, formulas, outcome);
    format!(
        "({}), member {}: {}, {expected}\n  {}\n{}",
        equation.label,
        outcome.member,
        outcome.verdict.word(),
        reason(audit, formulas, outcome).to_plain(),
        explain::plain_blocks(&blocks, 100)
    )
}

/// Module names for a document, the shortest first: the file's, then with its folders'.
fn module_names(path: &str) -> Vec<String> {
    let path = path.strip_suffix(".md").unwrap_or(path);
    let parts: Vec<String> = path
        .split(['/', '\\'])
        .filter(|part| !part.is_empty() && *part != ".")
        .map(identifier)
        .collect();
    (1..=parts.len())
        .map(|n| parts[parts.len() - n..].join("::"))
        .collect()
}

fn unused(names: &[String], taken: &[String]) -> String {
    let free = names.iter().find(|name| !taken.contains(name));
    free.or(names.last())
        .cloned()
        .unwrap_or_else(|| "document".into())
}

/// Letters, digits and underscores only.
fn identifier(text: &str) -> String {
    text.chars()
        .map(|c| if c.is_alphanumeric() { c } else { '_' })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn documents_of_the_same_name_are_told_apart_by_their_folders() {
        let names = module_names("proofs/schiehlen-2006/quarter-car.md");
        assert_eq!(names[0], "quarter_car");
        assert_eq!(names[1], "schiehlen_2006::quarter_car");
        let taken = vec!["quarter_car".to_string()];
        assert_eq!(unused(&names, &taken), "schiehlen_2006::quarter_car");
    }
}
