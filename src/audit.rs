//! The whole way of a document: read, modelled, checked.

use crate::check::{self, Options, Told, Verdicts};
use crate::diagnostic::{Diagnostic, DiagnosticKind, Rejection};
use crate::document::{Document, VerdictWord};
use crate::figure::{self, Figure};
use crate::model::Model;
use crate::span::Span;
use crate::stack::with_deep_stack;
use crate::unit::{self, UnitFinding};
use crate::verdict::Outcome;
use crate::verdict::statement::StatementOutcome;
use ratpoly::allowance;
use serde::Serialize;

/// A document with the verdicts on all its links.
#[derive(Clone, Debug)]
pub struct Audit {
    /// The document as mathematics.
    pub model: Model,
    /// One outcome for each link, in the order of the document.
    pub outcomes: Vec<Outcome>,
    /// One outcome for each proposition of the statements, in the order of the document.
    pub statements: Vec<StatementOutcome>,
    /// The places where units do not fit. They are checked apart and decide no verdict.
    pub units: Vec<UnitFinding>,
    /// The figures, computed from the equations as corrected.
    pub figures: Vec<Figure>,
    /// The recalled links, by equation and number of the link, that are false as identities: said
    /// beside them, and never counted as checked.
    pub recalled_and_false: Vec<(usize, usize)>,
}

/// What became of the links of a document: each is one of these.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
pub struct Counts {
    /// With a verdict that was computed: true, true given a relation, or false.
    pub checked: usize,
    /// Give names their values; nothing to check.
    pub defined: usize,
    /// Only stated.
    pub recalled: usize,
    /// Neither shown true nor false.
    pub undecided: usize,
    /// Announced equation numbers that stand in no fence.
    pub not_read: usize,
}

/// How many of the numbered equations have a verdict that was computed.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Coverage {
    /// The numbers that the document announces.
    pub announced: Vec<u32>,
    /// Those without an equation in the document.
    pub absent: Vec<u32>,
    /// Those with an undecided link.
    pub undecided: Vec<u32>,
}

impl Coverage {
    /// How many of the announced numbers are covered.
    pub fn covered(&self) -> usize {
        self.announced.len() - self.absent.len() - self.undecided.len()
    }
}

/// How many of the numbered figures are drawn.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct FigureCoverage {
    /// The numbers that the document announces.
    pub announced: Vec<u32>,
    /// Those without a table in the document, or with one that cannot be drawn.
    pub absent: Vec<u32>,
}

impl FigureCoverage {
    /// How many of the announced numbers are drawn.
    pub fn covered(&self) -> usize {
        self.announced.len() - self.absent.len()
    }
}

impl Audit {
    /// Checks a document.
    ///
    /// # Errors
    /// Everything that makes the document unusable, with its places.
    pub fn of(document: &Document, options: Options) -> Result<Audit, Rejection> {
        Audit::telling(document, options, &|_, _| {})
    }

    /// The same, telling the number of each link that is false before a correction is searched for: a
    /// search may take long, the verdict stands.
    ///
    /// # Errors
    /// As [`Audit::of`].
    pub fn telling(
        document: &Document,
        options: Options,
        tell: &(dyn Fn(&Model, Told<'_>) + Sync),
    ) -> Result<Audit, Rejection> {
        with_deep_stack(|| {
            let whole = || Audit::compute(document, options, tell);
            allowance::patiently(check::bounded::WHOLE, whole).unwrap_or_else(|exhausted| {
                let message = format!(
                    "the document as a whole cannot be checked: {}",
                    check::bounded::words(exhausted)
                );
                let kind = DiagnosticKind::Unreadable { message };
                Err(document.reject(vec![Diagnostic::new(kind, Span::default())]))
            })
        })
    }

    fn compute(
        document: &Document,
        options: Options,
        tell: &(dyn Fn(&Model, Told<'_>) + Sync),
    ) -> Result<Audit, Rejection> {
        let reject = |diagnostics| document.reject(diagnostics);
        let model = Model::build(document).map_err(reject)?;
        let verdicts = check::check_telling(&model, options, &|told| tell(&model, told));
        let verdicts = verdicts.map_err(reject)?;
        check_mends(&model, &verdicts).map_err(reject)?;
        let (of_names, units) = unit::audit(&model);
        let figures = figure::figures(&model, &verdicts.links, of_names).map_err(reject)?;
        let recalled_and_false = check::recalled_and_false(&model, options);
        Ok(Audit {
            model,
            outcomes: verdicts.links,
            statements: verdicts.statements,
            units,
            figures,
            recalled_and_false,
        })
    }

    /// How equations were read where the print leaves a choice: the label, what is printed, and how it
    /// is read, both in LaTeX.
    pub fn readings(&self) -> impl Iterator<Item = (&str, &str, &str)> {
        let text = &self.model.document.text;
        self.model.equations.iter().flat_map(move |equation| {
            equation.readings.iter().map(move |reading| {
                let printed = &text[reading.span.start..reading.span.end];
                (equation.label.as_str(), printed, reading.latex.as_str())
            })
        })
    }

    /// What became of the links.
    pub fn counts(&self) -> Counts {
        let mut counts = Counts {
            not_read: self.coverage().absent.len(),
            ..Counts::default()
        };
        for outcome in &self.outcomes {
            *match outcome.verdict.word() {
                VerdictWord::Holds
                | VerdictWord::HoldsGiven
                | VerdictWord::Misprint
                | VerdictWord::Refuted
                | VerdictWord::Loose => &mut counts.checked,
                VerdictWord::Definition => &mut counts.defined,
                VerdictWord::Recalled => &mut counts.recalled,
                VerdictWord::Undecided => &mut counts.undecided,
            } += 1;
        }
        counts
    }

    /// Which of the announced equation numbers have a verdict.
    pub fn coverage(&self) -> Coverage {
        let announced: Vec<u32> = self.model.document.announced_numbers().collect();
        let equation = |n: &u32| self.model.equation(&n.to_string());
        let absent = announced
            .iter()
            .copied()
            .filter(|n| equation(n).is_none())
            .collect();
        let undecided = announced
            .iter()
            .copied()
            .filter(|n| {
                equation(n).is_some_and(|e| {
                    self.outcomes_of(e)
                        .any(|o| o.verdict.word() == VerdictWord::Undecided)
                })
            })
            .collect();
        Coverage {
            announced,
            absent,
            undecided,
        }
    }

    /// Which of the announced figures can be drawn.
    pub fn figure_coverage(&self) -> FigureCoverage {
        let announced: Vec<u32> = self.model.document.announced_figures().collect();
        let drawn = |n: &u32| {
            let mut figures = self.figures.iter();
            figures.any(|f| f.number() == Some(*n) && f.content.is_ok())
        };
        let absent = announced.iter().copied().filter(|n| !drawn(n)).collect();
        FigureCoverage { announced, absent }
    }

    /// The outcomes of one equation.
    pub fn outcomes_of(&self, equation: usize) -> impl Iterator<Item = &Outcome> {
        self.outcomes.iter().filter(move |o| o.equation == equation)
    }

    /// The outcomes of one statement.
    pub fn outcomes_of_statement(
        &self,
        statement: usize,
    ) -> impl Iterator<Item = &StatementOutcome> {
        let outcomes = self.statements.iter();
        outcomes.filter(move |o| o.statement == statement)
    }
}

/// What a document says is meant instead of something false must be true itself.
fn check_mends(model: &Model, verdicts: &Verdicts) -> Result<(), Vec<Diagnostic>> {
    let settings = model.equations.iter().map(|e| &e.settings);
    let settings = settings.chain(model.statements.iter().map(|s| &s.settings));
    let mut report = Vec::new();
    for instead in settings.filter_map(|s| s.instead.as_ref()) {
        let words: Vec<VerdictWord> = match model.equation(&instead.text) {
            Some(equation) => {
                let links = verdicts.links.iter().filter(|o| o.equation == equation);
                links.map(|o| o.verdict.word()).collect()
            }
            None => {
                let statement = model.statement(&instead.text);
                let all = verdicts.statements.iter();
                let of_it = all.filter(|o| Some(o.statement) == statement);
                of_it.map(|o| o.word).collect()
            }
        };
        let true_ = |word: &VerdictWord| {
            matches!(
                word,
                VerdictWord::Holds | VerdictWord::HoldsGiven | VerdictWord::Definition
            )
        };
        if let Some(word) = words.iter().find(|word| !true_(word)) {
            let kind = DiagnosticKind::Unexpected {
                found: format!("`{}`, which is {word}", instead.text),
                expected: "something that holds".into(),
            };
            report.push(Diagnostic::new(kind, instead.span));
        }
    }
    if report.is_empty() {
        Ok(())
    } else {
        Err(report)
    }
}
