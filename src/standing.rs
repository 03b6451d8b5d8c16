//! Whether a verdict is what it should be, and what the process says to its caller.
//!
//! Unknown is never a pass. A verdict that the document records must come out again; where it
//! records none, a slip that nobody has acknowledged counts as a difference.

use crate::audit::Audit;
use crate::check;
use crate::document::VerdictWord;
use crate::evaluate::Value;
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
        let mut exact = check::symbolic(&self.model);
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
    let expected = match recorded {
        Some(recorded) => recorded == word,
        None => !matches!(
            word,
            VerdictWord::Misprint | VerdictWord::Refuted | VerdictWord::Loose
        ),
    };
    if expected {
        Standing::AsExpected
    } else {
        Standing::Differs
    }
}

/// The exit code of a run: 0 all as expected, 1 a verdict differs, 2 something is undecided or a
/// numbered equation has no verdict or a numbered figure is not drawn, 3 a document could not be
/// read, 4 the exact and the floating-point route contradict each other. Of several, the largest.
pub fn exit_code(inspections: &[Inspection], rejected: usize) -> u8 {
    let mut code = if rejected > 0 { 3 } else { 0 };
    for Inspection { audit, comparison } in inspections {
        if comparison
            .as_ref()
            .is_some_and(|c| !c.conflicts().is_empty())
        {
            code = 4;
        }
        let links = audit.outcomes.iter().map(|o| audit.standing(o));
        let statements = audit.statements.iter();
        let statements = statements.map(|o| audit.standing_of_statement(o));
        for standing in links.chain(statements) {
            code = code.max(match standing {
                Standing::AsExpected => 0,
                Standing::Differs => 1,
                Standing::Undecided => 2,
            });
        }
        let coverage = audit.coverage();
        if coverage.covered() < coverage.announced.len() {
            code = code.max(2);
        }
        if !audit.figure_coverage().absent.is_empty() {
            code = code.max(2);
        }
        if audit.figures.iter().any(Figure::contradicts) {
            code = code.max(1);
        }
    }
    let whole = |paper: &Paper| paper.covered() == paper.announced.len();
    if !papers(inspections).iter().all(whole) {
        code = code.max(2);
    }
    code
}
