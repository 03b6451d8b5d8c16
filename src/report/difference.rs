//! Which verdicts differ between two runs, read from what `rederive check --json` printed.

use serde::Deserialize;
use std::collections::BTreeMap;
use std::fmt;

/// The version of the shape of `verdicts.json` that is written and read here.
pub const SCHEMA_VERSION: u32 = 2;

/// The verdicts of a run by document, label and member.
#[derive(Debug)]
pub struct Recorded {
    verdicts: BTreeMap<(String, String, usize), Verdict>,
}

#[derive(Clone, Debug, PartialEq, Eq)]
struct Verdict {
    word: String,
    reason: String,
}

#[derive(Deserialize)]
struct Run {
    schema_version: Option<u32>,
    claims: Vec<Claim>,
    statements: Vec<Statement>,
}

#[derive(Deserialize)]
struct Claim {
    document: String,
    equation: String,
    member: usize,
    verdict: String,
    reason: String,
}

#[derive(Deserialize)]
struct Statement {
    document: String,
    statement: String,
    member: usize,
    verdict: String,
    reason: String,
}

/// A verdict that is another one, new, or gone.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Change {
    place: (String, String, usize),
    old: Option<Verdict>,
    new: Option<Verdict>,
}

impl Recorded {
    /// Reads the JSON of a run.
    ///
    /// # Errors
    /// In words, where it is no such JSON or of a later version.
    pub fn read(text: &str) -> Result<Self, String> {
        let run: Run = serde_json::from_str(text)
            .map_err(|e| format!("this is not what `rederive check --json` prints: {e}"))?;
        if let Some(version) = run.schema_version.filter(|v| *v > SCHEMA_VERSION) {
            return Err(format!(
                "its schema version is {version}, and this program reads up to {SCHEMA_VERSION}"
            ));
        }
        let claims = run.claims.into_iter().map(|c| {
            let (word, reason) = (c.verdict, c.reason);
            ((c.document, c.equation, c.member), Verdict { word, reason })
        });
        let statements = run.statements.into_iter().map(|s| {
            let (word, reason) = (s.verdict, s.reason);
            (
                (s.document, s.statement, s.member),
                Verdict { word, reason },
            )
        });
        Ok(Recorded {
            verdicts: claims.chain(statements).collect(),
        })
    }
}

/// The verdicts whose word differs, in the order of documents and labels.
pub fn changes(old: &Recorded, new: &Recorded) -> Vec<Change> {
    let mut places: Vec<_> = old.verdicts.keys().chain(new.verdicts.keys()).collect();
    places.sort();
    places.dedup();
    places
        .into_iter()
        .filter_map(|place| {
            let (old, new) = (old.verdicts.get(place), new.verdicts.get(place));
            let word = |v: Option<&Verdict>| v.map(|v| v.word.clone());
            (word(old) != word(new)).then(|| Change {
                place: place.clone(),
                old: old.cloned(),
                new: new.cloned(),
            })
        })
        .collect()
}

impl fmt::Display for Change {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (document, label, member) = &self.place;
        let word =
            |v: &Option<Verdict>| v.as_ref().map_or("absent", |v| v.word.as_str()).to_owned();
        write!(
            f,
            "{document} ({label}.{member}): {} -> {}",
            word(&self.old),
            word(&self.new)
        )?;
        match &self.new {
            Some(verdict) if !verdict.reason.is_empty() => write!(f, "; {}", verdict.reason),
            _ => Ok(()),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn run(verdict: &str) -> Recorded {
        let text = format!(
            r#"{{"schema_version": 2, "claims": [{{"document": "d", "equation": "1", "member": 1,
            "verdict": "{verdict}", "reason": "why"}}], "statements": []}}"#
        );
        Recorded::read(&text).unwrap()
    }

    #[test]
    fn only_what_differs_is_listed() {
        assert!(changes(&run("holds"), &run("holds")).is_empty());
        let found = changes(&run("holds"), &run("refuted"));
        assert_eq!(found.len(), 1);
        assert_eq!(found[0].to_string(), "d (1.1): holds -> refuted; why");
    }

    #[test]
    fn what_is_no_run_is_refused() {
        assert!(Recorded::read("[]").is_err());
        assert!(
            Recorded::read(r#"{"schema_version": 99, "claims": [], "statements": []}"#).is_err()
        );
    }
}
