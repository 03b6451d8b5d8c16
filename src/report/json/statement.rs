//! Statements for programs.

use crate::audit::Audit;
use crate::report::algebraic::{closed, enclosure};
use crate::report::formula::{Formulas, Script};
use crate::report::ordered::Ordered;
use crate::report::statement::{claim, facts, meaning, proposition_of, reason};
use crate::standing::Standing;
use crate::theory::algebraic::Algebraic;
use crate::verdict::statement::{Fact, SignCertificate, StatementOutcome};
use serde::Serialize;

/// A proposition with its verdict.
#[derive(Debug, Serialize)]
pub(super) struct Statement {
    document: String,
    statement: String,
    member: usize,
    sentence: String,
    /// What it says, as it was read; none for one that is only recalled.
    proposition: Option<String>,
    verdict: &'static str,
    expected: Option<&'static str>,
    as_expected: bool,
    reason: String,
    facts: Vec<String>,
    numbers: Vec<Number>,
    boundary: Vec<String>,
    witness: Option<Witness>,
    /// Whether the signs that it rests on were confirmed by multiplying out; none without any.
    certificate_verified: Option<bool>,
    /// Whether no sign rests on more than multiplication.
    certificate_elementary: Option<bool>,
    likelier: Option<&'static str>,
    because: Option<String>,
}

#[derive(Debug, Serialize)]
struct Number {
    meaning: String,
    /// For a rational number.
    exact: Option<String>,
    /// In square roots, or the rational number again; none where that would be too long.
    closed: Option<String>,
    /// The coefficients, from the constant one, of the irreducible polynomial of an irrational
    /// number.
    polynomial: Option<Vec<String>>,
    /// Rational numbers that enclose it, equal for a rational one.
    low: String,
    high: String,
    decimal: String,
}

#[derive(Debug, Serialize)]
struct Witness {
    point: Ordered<String>,
    value: String,
}

pub(super) fn statement(
    audit: &Audit,
    formulas: &Formulas,
    outcome: &StatementOutcome,
) -> Statement {
    let statement = &audit.model.statements[outcome.statement];
    let proposition = proposition_of(audit, outcome);
    let named = |measure, value: &Algebraic, which: &str| {
        let words = proposition.map(|p| meaning(audit, formulas, p, measure).to_plain());
        number(format!("{which}{}", words.unwrap_or_default()), value)
    };
    let numbers = outcome.facts.iter().flat_map(|fact| match fact {
        Fact::Number(measure, value) => vec![named(measure, value, "")],
        Fact::Range {
            measure, low, high, ..
        } => vec![
            named(measure, low, "least "),
            named(measure, high, "largest "),
        ],
        _ => Vec::new(),
    });
    let boundary = outcome.facts.iter().flat_map(|fact| match fact {
        Fact::Boundary(_, polynomials) => polynomials
            .iter()
            .map(|p| formulas.polynomial(p, Script::Code))
            .collect(),
        _ => Vec::new(),
    });
    let witness = outcome.facts.iter().find_map(|fact| match fact {
        Fact::Witness { point, value, .. } => Some(Witness {
            point: Ordered(
                point
                    .iter()
                    .map(|(l, v)| {
                        (
                            formulas.letter(*l, Script::Latex).to_string(),
                            v.to_string(),
                        )
                    })
                    .collect(),
            ),
            value: value.to_string(),
        }),
        _ => None,
    });
    let signs = |test: fn(&SignCertificate) -> bool| {
        (!outcome.signs.is_empty()).then(|| outcome.signs.iter().all(test))
    };
    Statement {
        document: audit.model.document.name.clone(),
        statement: statement.label.clone(),
        member: outcome.member,
        sentence: statement.sentence.clone(),
        proposition: proposition.map(|p| claim(audit, formulas, p).to_plain()),
        verdict: outcome.word.as_str(),
        expected: statement.expected(outcome.member).map(|w| w.as_str()),
        as_expected: audit.standing_of_statement(outcome) == Standing::AsExpected,
        reason: reason(audit, formulas, outcome).to_plain(),
        facts: facts(audit, formulas, outcome)
            .iter()
            .map(|f| f.to_plain())
            .collect(),
        numbers: numbers.collect(),
        boundary: boundary.collect(),
        witness,
        certificate_verified: signs(SignCertificate::verify),
        certificate_elementary: signs(SignCertificate::is_elementary),
        likelier: statement.settings.likelier.map(|s| s.as_str()),
        because: statement.settings.because.as_ref().map(|b| b.text.clone()),
    }
}

fn number(meaning: String, value: &Algebraic) -> Number {
    let (low, high) = enclosure(value);
    let polynomial = match value {
        Algebraic::Rational(_) => None,
        Algebraic::Root { polynomial, .. } => {
            let degree = polynomial.degree(0).unwrap_or(0);
            let coefficients = (0..=degree).map(|k| polynomial.coefficient(&[k]).to_string());
            Some(coefficients.collect())
        }
    };
    Number {
        meaning,
        exact: value.as_rational().map(ToString::to_string),
        closed: closed(value).map(|[_, plain]| plain),
        polynomial,
        low: low.to_string(),
        high: high.to_string(),
        decimal: value.decimal(12),
    }
}
