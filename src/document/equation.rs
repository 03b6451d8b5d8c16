//! The equations: what stands under a number, the role it plays, and its settings.

use super::Text;
use super::table::{Entries, Fields, Value, ValueKind, string};
use crate::diagnostic::{Diagnostic, DiagnosticKind};
use crate::span::Span;
use std::collections::BTreeMap;
use std::fmt;

/// An equation (or chain, or several) under one label.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Equation {
    /// The printed number, such as `47`, or a word, which the coverage does not count.
    pub label: Text,
    /// What the document does with it.
    pub role: Role,
    /// The LaTeX as printed. It has as many bytes as its span.
    pub body: Text,
    /// What the document says about it.
    pub settings: Settings,
}

impl Equation {
    /// The printed number, if the label is one.
    pub fn number(&self) -> Option<u32> {
        self.label.text.parse().ok()
    }
}

/// What the document does with an equation.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Role {
    /// Names get values.
    Define,
    /// The names are the unique solution of the equation, which is linear in them.
    Solve(Vec<Text>),
    /// Neighbours of the chain must be equal.
    Claim,
    /// Stated, nothing to check.
    Recall,
}

/// The words for the roles, in the order of the format.
pub(super) const ROLES: [&str; 4] = ["define", "solve", "claim", "recall"];

/// What the document says about an equation: its `toml LABEL` tables.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Settings {
    /// The verdict of the whole equation that the document records.
    pub expect: Option<(VerdictWord, Span)>,
    /// The verdicts that it records member by member, from 1.
    pub expect_members: BTreeMap<usize, (VerdictWord, Span)>,
    /// Relations under which it is expected to hold.
    pub given: Vec<Text>,
    /// Hypotheses that are printed around it, as in `D = 0, h = 0`.
    pub assume: Vec<Text>,
    /// Why there is nothing to check.
    pub reason: Option<Text>,
    /// Members that are stated only, with the reason.
    pub recalled_members: BTreeMap<usize, Text>,
    /// Free text for the report.
    pub note: Option<Text>,
    /// Where a slip is likelier.
    pub likelier: Option<Source>,
    /// Why it is likelier there.
    pub because: Option<Text>,
    /// The words of the paper that an equation of the document puts into a formula.
    pub quote: Option<Text>,
    /// How the words should read.
    pub reads: Option<Text>,
    /// The label of another proposition of the document that holds and is meant instead.
    pub instead: Option<Text>,
    /// Labels of equations that might be the false ones instead: of these and this one, one is.
    pub or: Vec<Text>,
    /// Labels of equations that need this one, which the paper does not write.
    pub unwritten: Vec<Text>,
    /// Where in the paper it stands, in words.
    pub place: Option<Text>,
}

impl Settings {
    /// The verdict on record for a member.
    pub fn expected(&self, member: usize) -> Option<VerdictWord> {
        let (word, _) = self.expect_members.get(&member).or(self.expect.as_ref())?;
        Some(*word)
    }
}

/// Where a slip can have come in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Source {
    /// The printed page.
    Paper,
    /// Its transcription.
    Transcription,
}

impl Source {
    /// The word for it.
    pub fn as_str(self) -> &'static str {
        match self {
            Source::Paper => "paper",
            Source::Transcription => "transcription",
        }
    }
}

/// The word for a verdict, as a document, a report and a test write it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum VerdictWord {
    /// `holds`
    Holds,
    /// `holds given`
    HoldsGiven,
    /// `misprint`
    Misprint,
    /// `refuted`
    Refuted,
    /// `loose`
    Loose,
    /// `undecided`
    Undecided,
    /// `definition`
    Definition,
    /// `recalled`
    Recalled,
}

impl VerdictWord {
    /// Every word, in the order of the design.
    pub const ALL: [VerdictWord; 8] = [
        VerdictWord::Holds,
        VerdictWord::HoldsGiven,
        VerdictWord::Misprint,
        VerdictWord::Refuted,
        VerdictWord::Loose,
        VerdictWord::Undecided,
        VerdictWord::Definition,
        VerdictWord::Recalled,
    ];

    /// The word itself.
    pub fn as_str(self) -> &'static str {
        match self {
            VerdictWord::Holds => "holds",
            VerdictWord::HoldsGiven => "holds given",
            VerdictWord::Misprint => "misprint",
            VerdictWord::Refuted => "refuted",
            VerdictWord::Loose => "loose",
            VerdictWord::Undecided => "undecided",
            VerdictWord::Definition => "definition",
            VerdictWord::Recalled => "recalled",
        }
    }
}

impl fmt::Display for VerdictWord {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.as_str())
    }
}

/// Whether a word can be a label: letters, digits, `.`, `-` and `_`, beginning with a letter or digit.
pub(super) fn is_label(word: &str) -> bool {
    word.starts_with(|c: char| c.is_ascii_alphanumeric())
        && word
            .chars()
            .all(|c| c.is_ascii_alphanumeric() || "._-".contains(c))
}

/// The names after `solve`, between commas outside braces.
pub(super) fn targets(words: &str, offset: usize) -> Vec<Text> {
    let mut names = Vec::new();
    let mut depth = 0_i32;
    let mut start = 0;
    let ends = words.char_indices().chain([(words.len(), ',')]);
    for (at, c) in ends {
        match c {
            '{' => depth += 1,
            '}' => depth -= 1,
            ',' if depth <= 0 || at == words.len() => {
                let piece = &words[start..at];
                let inset = piece.len() - piece.trim_start().len();
                let name = piece.trim();
                if !name.is_empty() {
                    let begin = offset + start + inset;
                    names.push(Text {
                        text: name.into(),
                        span: Span::new(begin, begin + name.len()),
                    });
                }
                start = (at + 1).min(words.len());
            }
            _ => {}
        }
    }
    names
}

/// Adds a `toml LABEL` table to the settings of its equation.
pub(super) fn settings(entries: Entries, settings: &mut Settings, report: &mut Vec<Diagnostic>) {
    let mut fields = Fields::new(entries, report);
    judgement(&mut fields, settings);
    if let Some(quote) = fields.words("quote") {
        settings.quote = Some(quote);
    }
    settings.given.extend(fields.texts("given"));
    settings.or.extend(fields.texts("or"));
    settings.unwritten.extend(fields.texts("unwritten"));
    for (key, value) in fields.table("members") {
        let member = member(&key, fields.report());
        let recall = recalled(value, fields.report());
        if let (Some(member), Some(recall)) = (member, recall) {
            settings.recalled_members.insert(member, recall);
        }
    }
    fields.finish();
}

/// What is said of equations and statements alike: the verdict on record, the reason, the note,
/// where a slip is likelier, and what should stand there.
pub(super) fn judgement(fields: &mut Fields<'_>, settings: &mut Settings) {
    if let Some(value) = fields.take("expect") {
        match value.kind {
            ValueKind::Table(entries) => {
                for (key, value) in entries {
                    let member = member(&key, fields.report());
                    let word = string(value, fields.report())
                        .and_then(|word| verdict_word(&word, fields.report()));
                    if let (Some(member), Some(word)) = (member, word) {
                        settings.expect_members.insert(member, word);
                    }
                }
            }
            _ => {
                settings.expect = string(value, fields.report())
                    .and_then(|word| verdict_word(&word, fields.report()));
            }
        }
    }
    settings.assume.extend(fields.texts("assume"));
    if let Some(reason) = fields.words("reason") {
        settings.reason = Some(reason);
    }
    if let Some(note) = fields.words("note") {
        settings.note = Some(note);
    }
    for (key, place) in [
        ("reads", &mut settings.reads),
        ("instead", &mut settings.instead),
        ("place", &mut settings.place),
    ] {
        if let Some(text) = fields.words(key) {
            *place = Some(text);
        }
    }
    if let Some(word) = fields.text("likelier") {
        settings.likelier = source(&word, fields.report());
    }
    if let Some(because) = fields.words("because") {
        if settings.likelier.is_none() {
            let found = "`because` without `likelier`".into();
            let expected = "`likelier = \"paper\"` or `likelier = \"transcription\"` beside it";
            fields.report().push(Diagnostic::new(
                DiagnosticKind::Unexpected {
                    found,
                    expected: expected.into(),
                },
                because.span,
            ));
        }
        settings.because = Some(because);
    }
}

fn source(word: &Text, report: &mut Vec<Diagnostic>) -> Option<Source> {
    let known = [Source::Paper, Source::Transcription];
    let found = known.into_iter().find(|s| s.as_str() == word.text);
    if found.is_none() {
        report.push(Diagnostic::new(
            DiagnosticKind::UnknownWord {
                word: word.text.clone(),
                known: known.map(|s| s.as_str().into()).into(),
            },
            word.span,
        ));
    }
    found
}

fn recalled(value: Value, report: &mut Vec<Diagnostic>) -> Option<Text> {
    let mut fields = Fields::of(value, "a table such as { recall = \"why\" }", report);
    let recall = fields.words("recall");
    fields.finish();
    recall
}

/// A member of a chain by its number, from 1.
fn member(key: &Text, report: &mut Vec<Diagnostic>) -> Option<usize> {
    match key.text.parse::<usize>() {
        Ok(member @ 1..=1000) => Some(member),
        _ => {
            report.push(Diagnostic::new(
                DiagnosticKind::Unexpected {
                    found: format!("`{}`", key.text),
                    expected: "the number of a member of the chain, from 1".into(),
                },
                key.span,
            ));
            None
        }
    }
}

fn verdict_word(word: &Text, report: &mut Vec<Diagnostic>) -> Option<(VerdictWord, Span)> {
    let found = VerdictWord::ALL
        .into_iter()
        .find(|known| known.as_str() == word.text);
    if found.is_none() {
        report.push(Diagnostic::new(
            DiagnosticKind::UnknownWord {
                word: word.text.clone(),
                known: VerdictWord::ALL.map(|known| known.as_str().into()).into(),
            },
            word.span,
        ));
    }
    found.map(|found| (found, word.span))
}
