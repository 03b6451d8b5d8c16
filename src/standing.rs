//! Whether a verdict is what it should be, and what the process says to its caller.
//!
//! Unknown is never a pass. A verdict that the document records must come out again; where it
//! records none, a slip that nobody has acknowledged counts as a difference.

use crate::audit::Audit;
use crate::document::VerdictWord;
use crate::evaluate::{self, Value};
use crate::expr::Relation;
use crate::figure::Figure;
use crate::inspection::Inspection;
use crate::paper::{Paper, papers};
use crate::verdict::statement::StatementOutcome;
use crate::verdict::{Outcome, Verdict};
use ratpoly::Polynomial;

/// How a verdict stands to what the document expects.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Standing {
    /// As recorded; or not recorded and true.
    AsExpected,
    /// Another verdict than the recorded one, another hypothesis than the stated one, or a slip
    /// that the document does not record.
    Differs,
    /// No verdict was reached.
    Undecided,
}

impl Audit {
    /// How the verdict on a link stands to what the document expects.
    pub fn standing(&self, outcome: &Outcome) -> Standing {
        let recorded = self.model.equations[outcome.equation].expected(outcome.member);
        // A relation that nothing states or implies has to be acknowledged.
        let offered =
            matches!(&outcome.verdict, Verdict::HoldsGiven(given, _) if given.is_offered());
        if offered && recorded.is_none() {
            return Standing::Differs;
        }
        match standing(outcome.verdict.word(), recorded) {
            Standing::AsExpected if recorded.is_some() && !self.hypothesis_as_stated(outcome) => {
                Standing::Differs
            }
            standing => standing,
        }
    }

    /// How the verdict on a proposition stands to what the document expects.
    pub fn standing_of_statement(&self, outcome: &StatementOutcome) -> Standing {
        let recorded = self.model.statements[outcome.statement].expected(outcome.member);
        standing(outcome.word, recorded)
    }

    /// Whether each relation that a verdict needs is among those that the document states, if it
    /// states any.
    fn hypothesis_as_stated(&self, outcome: &Outcome) -> bool {
        let given = match &outcome.verdict {
            Verdict::HoldsGiven(given, _) => given,
            _ => return true,
        };
        let stated = &self.model.equations[outcome.equation].given;
        if stated.is_empty() {
            return true;
        }
        let normal = |p: &Polynomial| p.primitive_part().unit_normal();
        let mut exact = evaluate::symbolic(&self.model).evaluator(self.model.field());
        let stated: Vec<Polynomial> = stated
            .iter()
            .filter(|hypothesis| hypothesis.relation == Relation::Equal)
            .filter_map(
                |hypothesis| match exact.expression(&hypothesis.difference()) {
                    Ok(Value::Scalar(value)) => Some(normal(value.numerator())),
                    _ => None,
                },
            )
            .collect();
        given.relations.iter().all(|r| stated.contains(&normal(r)))
    }
}

/// How a verdict stands to the recorded one, if there is one.
fn standing(word: VerdictWord, recorded: Option<VerdictWord>) -> Standing {
    if word == VerdictWord::Undecided {
        return Standing::Undecided;
    }
    let expected = match (recorded, word) {
        (Some(recorded), word) => recorded == word,
        (
            None,
            VerdictWord::Holds
            | VerdictWord::HoldsGiven
            | VerdictWord::Definition
            | VerdictWord::Recalled,
        ) => true,
        (
            None,
            VerdictWord::Misprint
            | VerdictWord::Refuted
            | VerdictWord::Loose
            | VerdictWord::Undecided,
        ) => false,
    };
    if expected {
        Standing::AsExpected
    } else {
        Standing::Differs
    }
}

/// What a run found that its caller must know, the gravest last.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Gravity {
    /// All is as expected.
    AsExpected,
    /// Something is undecided, or a numbered equation has no verdict, or a figure is not drawn.
    Undecided,
    /// A verdict differs from the recorded one, or a slip is not recorded.
    Differs,
    /// A document could not be read.
    BadInput,
    /// What was proved is contradicted: by a certificate that does not verify, or by certified
    /// enclosures at a point.
    Contradiction,
}

impl Gravity {
    /// The exit code of the process: of several findings, that of the gravest, so that a difference
    /// is not hidden by something undecided.
    pub fn exit_code(self) -> u8 {
        match self {
            Gravity::AsExpected => 0,
            Gravity::Differs => 1,
            Gravity::Undecided => 2,
            Gravity::BadInput => 3,
            Gravity::Contradiction => 4,
        }
    }
}

/// The exit code of a run, in which so many documents could not be read.
pub fn exit_code(inspections: &[Inspection], rejected: usize) -> u8 {
    let read = match rejected {
        0 => Gravity::AsExpected,
        _ => Gravity::BadInput,
    };
    let of_documents = inspections.iter().map(|i| gravity(&i.audit));
    let whole = papers(inspections)
        .iter()
        .all(|paper: &Paper| paper.covered() == paper.announced.len());
    let covered = match whole {
        true => Gravity::AsExpected,
        false => Gravity::Undecided,
    };
    let gravest = of_documents.chain([read, covered]).max();
    gravest.map_or(0, Gravity::exit_code)
}

/// The gravest finding in a document.
fn gravity(audit: &Audit) -> Gravity {
    let contradicted = audit.outcomes.iter().any(|o| o.contradiction.is_some());
    let links = audit.outcomes.iter().map(|o| audit.standing(o));
    let statements = audit.statements.iter();
    let statements = statements.map(|o| audit.standing_of_statement(o));
    let standings = links.chain(statements).map(|standing| match standing {
        Standing::AsExpected => Gravity::AsExpected,
        Standing::Differs => Gravity::Differs,
        Standing::Undecided => Gravity::Undecided,
    });
    let coverage = audit.coverage();
    let more = [
        (contradicted, Gravity::Contradiction),
        (
            coverage.covered() < coverage.announced.len(),
            Gravity::Undecided,
        ),
        (
            !audit.figure_coverage().absent.is_empty()
                || audit.figures.iter().any(|f| f.content.is_err()),
            Gravity::Undecided,
        ),
        (
            audit.figures.iter().any(Figure::contradicts),
            Gravity::Differs,
        ),
    ];
    let more = more.into_iter().filter(|(met, _)| *met).map(|(_, g)| g);
    standings.chain(more).max().unwrap_or(Gravity::AsExpected)
}
