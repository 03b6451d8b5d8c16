//! What the checker says of generated claims, and where that is wrong. The checker is this library,
//! or any program that prints its verdicts with `check --json`.

use super::generator::{Claim, Truth};
use super::library::by_library;
use super::program::by_program;
use rederive::document::VerdictWord;
use std::path::PathBuf;

/// What is said of one link.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Said {
    Word(VerdictWord),
    /// It holds under relations, of which it was found out apart whether they make it true.
    HoldsGiven(Option<bool>),
    /// A correction was proposed that is itself false.
    FalseCorrection(String),
    /// What was read is not what was printed.
    MisRead(String),
    /// The document was refused.
    Refused,
    /// The program ended.
    Panic,
}

/// Who judges.
#[derive(Clone, Debug)]
pub enum Judge {
    /// The library, with or without a search for corrections.
    Library { repair: bool },
    /// A program.
    Program { path: PathBuf, folder: PathBuf },
}

/// What is said of each link of some claims of one document.
pub fn said(judge: &Judge, header: &str, claims: &[&Claim]) -> Vec<Vec<Said>> {
    let mut text = header.to_string();
    for claim in claims {
        text += "\n";
        text += &claim.text;
    }
    let found = match judge {
        Judge::Library { repair } => by_library(&text, *repair, claims),
        Judge::Program { path, folder } => by_program(&text, path, folder, claims),
    };
    match found {
        Ok(found) => found,
        Err(why) if claims.len() == 1 => vec![vec![why; claims[0].truth.len()]],
        // One bad claim must not hide the others.
        Err(_) => claims
            .iter()
            .flat_map(|claim| said(judge, header, &[claim]))
            .collect(),
    }
}

/// What is wrong with what is said; nothing where it is right or leaves it open.
pub fn fault(truth: Truth, said: &Said) -> Option<&'static str> {
    use VerdictWord as W;
    match said {
        Said::Panic => Some("the program ended"),
        Said::MisRead(_) => Some("read as something else"),
        Said::FalseCorrection(_) => Some("the correction is false"),
        Said::Refused => None,
        Said::HoldsGiven(verified) => match truth {
            Truth::True | Truth::Unforced => Some("true, and holds only under a relation"),
            Truth::Given => None,
            Truth::Meaningless => Some("has no value, and holds under a relation"),
            Truth::False => match verified {
                Some(true) | None => None,
                Some(false) => Some("holds under a relation that does not make it true"),
            },
        },
        Said::Word(word) => match (truth, word) {
            (_, W::Undecided) => None,
            (Truth::True | Truth::Unforced, W::Refuted | W::Misprint | W::Loose) => {
                Some("true, and rejected")
            }
            (Truth::Given, W::Refuted | W::Misprint | W::Loose) => {
                Some("true under the hypothesis, and rejected")
            }
            (Truth::False, W::Holds) => Some("false, and accepted"),
            (Truth::Given, W::Holds) => Some("false without the hypothesis, and accepted"),
            (Truth::Meaningless, W::Holds | W::HoldsGiven) => Some("has no value, and accepted"),
            (_, W::Definition | W::Recalled) => Some("a claim that vanished"),
            (Truth::True | Truth::Unforced, W::Holds | W::HoldsGiven) => None,
            (Truth::False, W::HoldsGiven | W::Refuted | W::Misprint | W::Loose) => None,
            (Truth::Given, W::HoldsGiven) => None,
            (Truth::Meaningless, W::Refuted | W::Misprint | W::Loose) => None,
        },
    }
}

/// Whether it is decided, rightly or wrongly.
pub fn is_decided(truth: Truth, said: &Said) -> bool {
    match said {
        Said::Word(VerdictWord::Undecided) | Said::Refused => truth == Truth::Meaningless,
        Said::Panic => false,
        _ => true,
    }
}
