//! The errata sheet of a paper: where, as printed, as it should read, why, and what it changes.
//!
//! It says only what a verdict says. One equation is one entry, whatever of it is false, with one
//! corrected display. What is likelier a slip of the transcription is kept apart: it has to be compared
//! with the printed page before anybody writes to a journal.

mod collect;
mod latex;
mod mark;
mod markdown;

pub use collect::sheets;
pub use latex::latex;
pub(crate) use latex::write;
pub use markdown::markdown;

use crate::document::Source;
use crate::report::prose::Prose;
use std::collections::BTreeSet;

/// The errata of one paper, or of one document that names no paper.
#[derive(Clone, Debug, Default)]
pub struct Sheet {
    /// The paper.
    pub title: String,
    /// Where it was published, from its documents.
    pub sources: Vec<String>,
    /// What is false, in the order of the numbers.
    pub errata: Vec<Erratum>,
    /// Relations and conventions that equations need and the paper does not write.
    pub unwritten: Vec<Unwritten>,
    /// Sentences that are false.
    pub sentences: Vec<Sentence>,
    /// Sentences that are true at the reference values and not for all values.
    pub partly: Vec<Sentence>,
    /// Sentences that are true only approximately, or in one of their readings.
    pub nearly: Vec<Sentence>,
    /// What the paper writes without saying what it is, or in two ways.
    pub remarks: Vec<Prose>,
}

/// A false equation.
#[derive(Clone, Debug)]
pub struct Erratum {
    /// `(61)`; `(61) or (44)` where one of the two is false and nothing says which.
    pub location: String,
    /// As printed, in LaTeX, with what is wrong underlined.
    pub printed: String,
    /// As it should read, with what changed underlined; none where no correction is known, or where it
    /// changes something outside of the equation.
    pub corrected: Option<String>,
    /// Whether a correction is known of each link that is false.
    pub mended: bool,
    /// For each false link what kind of slip, and how sure the correction is.
    pub corrections: Vec<Prose>,
    /// For each why it is false.
    pub why: Vec<Prose>,
    /// What it changes.
    pub effects: Vec<Prose>,
    /// Where it came in, and why that is thought.
    pub source: Option<(Source, Prose)>,
    /// The document's own remark.
    pub note: Option<Prose>,
}

/// Something that equations need and the paper does not write.
#[derive(Clone, Debug)]
pub struct Unwritten {
    /// What, and which equations imply it.
    pub relations: Prose,
    /// Whether other equations of the paper imply it.
    pub implied: bool,
    /// The equations that need it.
    pub equations: Vec<String>,
    /// The document's own remark.
    pub note: Option<Prose>,
}

/// A sentence that is not true as it stands.
#[derive(Clone, Debug)]
pub struct Sentence {
    /// The label that it has in its document.
    pub label: String,
    /// Where it stands.
    pub place: Option<Prose>,
    /// As printed.
    pub text: Prose,
    /// As it should read.
    pub reads: Option<Prose>,
    /// The formula that it was read as, and that formula corrected.
    pub formula: Option<(String, Option<String>)>,
    /// How it was read, and what is the case.
    pub facts: Vec<Prose>,
    /// Where a slip came in, and why that is thought.
    pub source: Option<(Source, Prose)>,
    /// The document's own remark.
    pub note: Option<Prose>,
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

    /// The sentences under their headings.
    fn groups(&self) -> [(&'static str, &[Sentence]); 3] {
        [
            ("Sentences", &self.sentences),
            (
                "Sentences that are true at the reference values, but not for all values",
                &self.partly,
            ),
            (
                "Sentences that are true only approximately, or in one reading",
                &self.nearly,
            ),
        ]
    }

    /// Whether there is nothing to send.
    pub fn is_empty(&self) -> bool {
        self.errata.is_empty()
            && self.unwritten.is_empty()
            && self.remarks.is_empty()
            && self.groups().iter().all(|(_, group)| group.is_empty())
    }

    /// What the sheet says first.
    pub fn summary(&self) -> String {
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
                count(ours.len(), "equation", "equations")
            ));
        }
        let needy = |implied: bool| {
            let unwritten = self.unwritten.iter().filter(|u| u.implied == implied);
            let equations: BTreeSet<&String> = unwritten.flat_map(|u| &u.equations).collect();
            equations.len()
        };
        for (n, one, many) in [
            (
                needy(false),
                "equation that needs something which is not written",
                "equations that need something which is not written",
            ),
            (
                needy(true),
                "equation that uses what others imply without saying so",
                "equations that use what others imply without saying so",
            ),
            (self.sentences.len(), "false sentence", "false sentences"),
            (
                self.partly.len(),
                "sentence true at the reference values but not for all values",
                "sentences true at the reference values but not for all values",
            ),
            (
                self.nearly.len(),
                "sentence true only approximately or in one reading",
                "sentences true only approximately or in one reading",
            ),
            (
                self.remarks.len(),
                "remark on the notation",
                "remarks on the notation",
            ),
        ] {
            if n > 0 {
                parts.push(count(n, one, many));
            }
        }
        parts.join("; ")
    }
}
