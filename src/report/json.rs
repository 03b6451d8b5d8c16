//! Verdicts for programs: `--json` and `verdicts.json`. The shape is kept and described by
//! `schemas/verdicts.schema.json`; keys may be added, none changes its meaning.

mod statement;

use crate::audit::Audit;
use crate::check::effect::effect;
use crate::comparison::{Comparison, Subject};
use crate::evaluate::Origin;
use crate::inspection::Inspection;
use crate::latex;
use crate::paper::papers;
use crate::report::difference::SCHEMA_VERSION;
use crate::report::formula::{Formulas, Script};
use crate::report::ordered::Ordered;
use crate::report::reason::{equation_of, preferred_as, reason, where_it_holds};
use crate::standing::Standing;
use crate::verdict::{
    Because, Changed, Correction, Edit, Given, Outcome, PointValue, Refutation, ResidualEntry,
    Verdict, Witness,
};
use serde::Serialize;
use sha2::{Digest, Sha256};
use statement::Statement;
use std::borrow::Cow;

/// The whole object.
#[derive(Debug, Serialize)]
pub struct Verdicts {
    /// The version of this object's shape: it grows when a key goes or changes its meaning.
    schema_version: u32,
    software: Software,
    coverage: Coverage,
    documents: Vec<Document>,
    claims: Vec<Claim>,
    statements: Vec<Statement>,
    units: Vec<UnitText>,
}

/// The program that wrote a file.
#[derive(Debug, Serialize)]
pub struct Software {
    name: &'static str,
    version: &'static str,
}

impl Software {
    /// This program.
    pub fn this() -> Self {
        Software {
            name: env!("CARGO_PKG_NAME"),
            version: env!("CARGO_PKG_VERSION"),
        }
    }
}

/// The hash of a text in hexadecimal digits.
pub fn sha256(text: &str) -> String {
    Sha256::digest(text.as_bytes())
        .iter()
        .map(|byte| format!("{byte:02x}"))
        .collect()
}

#[derive(Debug, Serialize)]
struct Coverage {
    /// How many equation numbers the documents announce.
    numbered: usize,
    /// How many of them have a verdict.
    covered: usize,
    /// Those that are not in their document.
    absent: Vec<Place>,
    /// Those with an undecided link.
    undecided: Vec<Place>,
    /// The papers that several of the documents belong to.
    papers: Vec<PaperCoverage>,
    figures: FigureCoverage,
}

#[derive(Debug, Serialize)]
struct PaperCoverage {
    paper: String,
    documents: Vec<String>,
    numbered: usize,
    covered: usize,
    absent: Vec<u32>,
    undecided: Vec<u32>,
}

#[derive(Debug, Serialize)]
struct FigureCoverage {
    /// How many figure numbers the documents announce.
    numbered: usize,
    /// How many of them are drawn.
    covered: usize,
}

#[derive(Debug, Serialize)]
struct Place {
    document: String,
    equation: String,
}

#[derive(Debug, Serialize)]
struct Document {
    document: String,
    title: String,
    sha256: String,
    numbered: usize,
    covered: usize,
    links: crate::audit::Counts,
    readings: Vec<ReadingText>,
}

/// How something was read where the print leaves a choice.
#[derive(Debug, Serialize)]
struct ReadingText {
    equation: String,
    printed: String,
    read: String,
}

#[derive(Debug, Serialize)]
struct Claim {
    document: String,
    equation: String,
    member: usize,
    printed: String,
    verdict: &'static str,
    expected: Option<&'static str>,
    as_expected: bool,
    reason: String,
    given: Option<Vec<String>>,
    implied_by: Option<Vec<String>>,
    missing: Option<String>,
    misfit: Option<MisfitText>,
    /// The hypotheses printed around the equation that were used.
    assumed: Vec<String>,
    /// The values of the letters that sizes depend on, for which the verdict is this one.
    instances: Vec<Ordered<usize>>,
    residual: Option<Vec<Residual>>,
    witness: Option<Point>,
    /// Where it is true, if it is false only on a part of its domain.
    holds_where: Option<String>,
    correction: Option<CorrectionText>,
    /// How far a correction was looked for in vain.
    searched: Option<SearchedText>,
    conditions: Vec<Condition>,
    certificate_verified: bool,
    /// How the floating-point route agrees, where it was asked.
    agreement: Option<Agreement>,
    /// What the slip changes at the reference point.
    effect: Option<EffectText>,
    /// Where a slip is likelier, and why.
    likelier: Option<&'static str>,
    because: Option<String>,
}

/// Shapes that do not fit, as in `4x1 = 1x4`.
#[derive(Debug, Serialize)]
struct MisfitText {
    operation: String,
    left: String,
    right: String,
}

#[derive(Debug, Serialize)]
struct Residual {
    indices: Ordered<i64>,
    entry: Option<(usize, usize)>,
    value: String,
    /// Where a hypothesis makes it vanish: one cofactor for each relation.
    cofactors: Option<Vec<String>>,
}

#[derive(Debug, Serialize)]
struct Point {
    point: Ordered<String>,
    indices: Ordered<i64>,
    entry: Option<(usize, usize)>,
    lhs: String,
    rhs: String,
}

#[derive(Debug, Serialize)]
struct CorrectionText {
    class: Option<&'static str>,
    edits: Vec<EditText>,
    corrected: String,
    given: Option<Vec<String>>,
    only: bool,
    /// How far-fetched it is: ten times the rank of each edit's class, and more for what is rarer.
    cost: u32,
    /// What was changed: a side, or the label of a definition.
    changed: Vec<String>,
    /// The corrected definition, where not the claim but what it rests on is changed.
    definition: Option<DefinitionText>,
    alternatives: Vec<Vec<EditText>>,
    /// Why this one and not the alternatives.
    preferred: Option<&'static str>,
    tried: usize,
    budget: usize,
}

#[derive(Debug, Serialize)]
struct SearchedText {
    tried: usize,
    budget: usize,
}

#[derive(Debug, Serialize)]
struct DefinitionText {
    equation: String,
    corrected: String,
}

#[derive(Debug, Serialize)]
struct EditText {
    class: &'static str,
    line: usize,
    column: usize,
    printed: String,
    corrected: String,
}

/// The printed side over the true one; for an equation without a correction, left over right.
#[derive(Debug, Serialize)]
struct EffectText {
    printed: String,
    correct: Option<String>,
    ratio: String,
}

#[derive(Debug, Serialize)]
struct Condition {
    formula: String,
    must: &'static str,
    because: Option<String>,
}

/// How many digits of the right side the best floating-point method gets right, against the exact
/// value of the left side.
#[derive(Debug, Serialize)]
struct Agreement {
    /// At the first named point.
    digits: f64,
    /// The fewest at any point.
    worst_digits: f64,
    /// Where that is.
    worst_at: String,
    /// At how many points they were compared.
    points: usize,
    /// Whether the two routes contradict each other.
    conflict: bool,
}

/// A place where units do not fit.
#[derive(Debug, Serialize)]
struct UnitText {
    document: String,
    equation: String,
    finding: String,
}

/// The verdicts on some documents.
pub fn verdicts(inspections: &[Inspection]) -> Verdicts {
    let mut verdicts = Verdicts {
        schema_version: SCHEMA_VERSION,
        software: Software::this(),
        coverage: Coverage {
            numbered: 0,
            covered: 0,
            absent: Vec::new(),
            undecided: Vec::new(),
            papers: papers(inspections)
                .into_iter()
                .map(|paper| PaperCoverage {
                    covered: paper.covered(),
                    documents: paper
                        .documents
                        .iter()
                        .map(|d| inspections[*d].audit.model.document.name.clone())
                        .collect(),
                    numbered: paper.announced.len(),
                    paper: paper.title,
                    absent: paper.absent,
                    undecided: paper.undecided,
                })
                .collect(),
            figures: FigureCoverage {
                numbered: 0,
                covered: 0,
            },
        },
        documents: Vec::new(),
        claims: Vec::new(),
        statements: Vec::new(),
        units: Vec::new(),
    };
    for inspection in inspections {
        let audit = &inspection.audit;
        let document = &audit.model.document;
        let coverage = audit.coverage();
        let places = |numbers: &[u32]| -> Vec<Place> {
            let place = |n: &u32| Place {
                document: document.name.clone(),
                equation: n.to_string(),
            };
            numbers.iter().map(place).collect()
        };
        verdicts.coverage.numbered += coverage.announced.len();
        verdicts.coverage.covered += coverage.covered();
        verdicts.coverage.absent.extend(places(&coverage.absent));
        verdicts
            .coverage
            .undecided
            .extend(places(&coverage.undecided));
        let figures = audit.figure_coverage();
        verdicts.coverage.figures.numbered += figures.announced.len();
        verdicts.coverage.figures.covered += figures.covered();
        verdicts.documents.push(Document {
            document: document.name.clone(),
            title: document.title.clone(),
            sha256: sha256(&document.text),
            numbered: coverage.announced.len(),
            covered: coverage.covered(),
            links: audit.counts(),
            readings: readings(audit),
        });
        verdicts
            .units
            .extend(audit.units.iter().map(|finding| UnitText {
                document: document.name.clone(),
                equation: finding.label.clone(),
                finding: finding.to_string(),
            }));
        let formulas = Formulas::of(&audit.model);
        let writer = Writer {
            audit,
            comparison: inspection.comparison.as_ref(),
            formulas: Cow::Borrowed(&formulas),
        };
        verdicts
            .claims
            .extend(audit.outcomes.iter().map(|o| writer.here(o).claim(o)));
        let statements = audit.statements.iter();
        verdicts
            .statements
            .extend(statements.map(|o| statement::statement(audit, &writer.formulas, o)));
    }
    verdicts
}

struct Writer<'a> {
    audit: &'a Audit,
    comparison: Option<&'a Comparison>,
    formulas: Cow<'a, Formulas>,
}

impl Writer<'_> {
    /// The same in the letters of an outcome.
    fn here<'w>(&'w self, outcome: &Outcome) -> Writer<'w> {
        Writer {
            audit: self.audit,
            comparison: self.comparison,
            formulas: self.formulas.here(&self.audit.model, outcome),
        }
    }

    fn claim(&self, outcome: &Outcome) -> Claim {
        let equation = &self.audit.model.equations[outcome.equation];
        let link = &equation.links[outcome.member - 1];
        let (given, refutation, correction) = match &outcome.verdict {
            Verdict::HoldsGiven(given, _) => (Some(&**given), None, None),
            Verdict::Misprint {
                refutation,
                correction,
            } => (
                correction.given.as_ref(),
                Some(refutation),
                Some(&**correction),
            ),
            Verdict::Refuted(refutation) => (None, Some(refutation), None),
            _ => (None, None, None),
        };
        let witness = match &outcome.verdict {
            Verdict::HoldsGiven(given, _) => given.counterexample.as_ref(),
            _ => refutation.and_then(Refutation::witness),
        };
        Claim {
            document: self.audit.model.document.name.clone(),
            equation: equation.label.clone(),
            member: outcome.member,
            printed: equation_of(&equation.display, link),
            verdict: outcome.verdict.word().as_str(),
            expected: equation.expected(outcome.member).map(|w| w.as_str()),
            as_expected: self.audit.standing(outcome) == Standing::AsExpected,
            reason: reason(self.audit, &self.formulas, outcome).to_plain(),
            given: given.map(|g| self.relations(g)),
            implied_by: given.map(|g| g.implied_by.clone()),
            missing: refutation.and_then(|r| r.missing().map(str::to_owned)),
            misfit: refutation.and_then(|r| {
                r.misfit().map(|m| MisfitText {
                    operation: m.operation.clone(),
                    left: m.left.clone(),
                    right: m.right.clone(),
                })
            }),
            assumed: outcome.assumed.clone(),
            instances: self.instances(outcome),
            residual: self.residual(&outcome.verdict, refutation),
            witness: witness.map(|w| self.witness(w)),
            holds_where: refutation
                .and_then(|r| r.part.as_ref())
                .map(|part| where_it_holds(&self.formulas, part).to_plain()),
            correction: correction.map(|c| self.correction(outcome, c)),
            searched: refutation.and_then(|r| r.searched).map(|s| SearchedText {
                tried: s.tried,
                budget: s.budget,
            }),
            conditions: outcome
                .conditions
                .iter()
                .map(|c| Condition {
                    formula: self.formulas.polynomial(&c.factor, Script::Code),
                    must: match c.origin {
                        Origin::Divisor(_) | Origin::Determinant(_) => "not vanish",
                        Origin::Stability(_) => "be positive",
                        Origin::Range { strict: true, .. } => "be positive",
                        Origin::Range { strict: false, .. } => "not be negative",
                    },
                    because: c.because.as_ref().map(|b| match b {
                        Because::Positive => "positive".to_string(),
                        Because::Definite(name) => format!("minor of the positive definite {name}"),
                        Because::Sign => "of one sign".to_string(),
                        Because::Supposed => "by the hypotheses".to_string(),
                        Because::PositiveBy(by) => {
                            format!("positive with {}", crate::report::reason::labels(by))
                        }
                    }),
                })
                .collect(),
            certificate_verified: outcome.contradiction.is_none(),
            agreement: self.agreement(outcome),
            effect: effect(&self.audit.model, outcome).map(|e| EffectText {
                ratio: e.ratio().to_string(),
                correct: e.corrected.then(|| e.correct.to_string()),
                printed: e.printed.to_string(),
            }),
            likelier: equation.settings.likelier.map(|s| s.as_str()),
            because: equation.settings.because.as_ref().map(|b| b.text.clone()),
        }
    }

    fn instances(&self, outcome: &Outcome) -> Vec<Ordered<usize>> {
        let of = |instance: &usize| {
            let values = &self.audit.model.instances[*instance];
            Ordered(values.iter().map(|(l, v)| (l.clone(), *v)).collect())
        };
        let all = outcome.instances.iter().map(of);
        all.filter(|values| !values.0.is_empty()).collect()
    }

    fn agreement(&self, outcome: &Outcome) -> Option<Agreement> {
        let comparison = self.comparison?;
        let (first, worst, point) = comparison.agreement(outcome.equation, outcome.member)?;
        let link = Subject::Link {
            equation: outcome.equation,
            member: outcome.member,
        };
        Some(Agreement {
            digits: first,
            worst_digits: worst,
            worst_at: comparison.points[point].name.clone(),
            points: comparison.points.len(),
            conflict: comparison.conflicts().contains(&&link),
        })
    }

    fn relations(&self, given: &Given) -> Vec<String> {
        given
            .relations
            .iter()
            .map(|r| self.formulas.relation(r, Script::Latex))
            .chain(given.stated.iter().cloned())
            .collect()
    }

    fn residual(
        &self,
        verdict: &Verdict,
        refutation: Option<&Refutation>,
    ) -> Option<Vec<Residual>> {
        let entry = |e: &ResidualEntry, cofactors: Option<Vec<String>>| Residual {
            indices: Ordered(e.indices.clone()),
            entry: e.place,
            value: self.formulas.rational(&e.difference(), Script::Code),
            cofactors,
        };
        match (verdict, refutation) {
            (Verdict::HoldsGiven(given, _), _) => Some(
                given
                    .cofactors
                    .iter()
                    .map(|g| {
                        let cofactors = g.cofactors.iter();
                        let written = cofactors
                            .map(|c| self.formulas.rational(c, Script::Code))
                            .collect();
                        entry(&g.entry, Some(written))
                    })
                    .collect(),
            ),
            (_, Some(refutation)) => {
                Some(refutation.residual.iter().map(|e| entry(e, None)).collect())
            }
            _ => None,
        }
    }

    fn witness(&self, witness: &Witness) -> Point {
        let letter = |letter: usize| self.formulas.letter(letter, Script::Latex).to_string();
        Point {
            point: Ordered(
                witness
                    .point
                    .iter()
                    .map(|(l, value)| (letter(*l), point_value(value)))
                    .collect(),
            ),
            indices: Ordered(witness.indices.clone()),
            entry: witness.place,
            lhs: point_value(&witness.left),
            rhs: point_value(&witness.right),
        }
    }

    fn correction(&self, outcome: &Outcome, correction: &Correction) -> CorrectionText {
        let edits = |edits: &[Edit]| edits.iter().map(|e| self.edit(e)).collect();
        let equation = &self.audit.model.equations[outcome.equation];
        let link = &equation.links[outcome.member - 1];
        CorrectionText {
            class: correction.edits.first().map(|e| e.class.as_str()),
            edits: edits(&correction.edits),
            corrected: equation_of(&correction.display, link),
            given: correction.given.as_ref().map(|g| self.relations(g)),
            only: correction.alternatives.is_empty() && correction.unjudged == 0,
            cost: correction.cost,
            changed: correction
                .changed
                .iter()
                .map(|changed| match changed {
                    Changed::Left => "left".to_string(),
                    Changed::Right => "right".to_string(),
                    Changed::Definition(e) => {
                        format!("definition ({})", self.audit.model.equations[*e].label)
                    }
                })
                .collect(),
            definition: correction
                .definition
                .as_ref()
                .map(|(e, display)| DefinitionText {
                    equation: self.audit.model.equations[*e].label.clone(),
                    corrected: latex::write_display(display),
                }),
            alternatives: correction.alternatives.iter().map(|a| edits(a)).collect(),
            preferred: correction.preferred.map(preferred_as),
            tried: correction.tried,
            budget: correction.budget,
        }
    }

    fn edit(&self, edit: &Edit) -> EditText {
        let before = self
            .audit
            .model
            .document
            .text
            .get(..edit.span.start)
            .unwrap_or_default();
        let line_start = before.rfind('\n').map_or(0, |at| at + 1);
        EditText {
            class: edit.class.as_str(),
            line: 1 + before.matches('\n').count(),
            column: 1 + before[line_start..].chars().count(),
            printed: edit.printed.clone(),
            corrected: edit.corrected.clone(),
        }
    }
}

/// A value at a point: a fraction, or the two between which it lies.
fn point_value(value: &PointValue) -> String {
    match value {
        PointValue::Exact(number) => number.to_string(),
        PointValue::Between(low, high) => format!("[{low}, {high}]"),
        PointValue::Complex(parts) => {
            format!("{} + i*{}", point_value(&parts[0]), point_value(&parts[1]))
        }
    }
}

fn readings(audit: &Audit) -> Vec<ReadingText> {
    audit
        .readings()
        .map(|(equation, printed, read)| ReadingText {
            equation: equation.to_string(),
            printed: printed.to_string(),
            read: read.to_string(),
        })
        .collect()
}
