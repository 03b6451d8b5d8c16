//! What cannot be mended has a clear answer of its own: sides that do not fit, an empty budget, what is
//! false only on a part of its domain, and corrections that only other evidence tells apart.

mod common;

use rederive::audit::Audit;
use rederive::check::Options;
use rederive::inspection::Inspection;
use rederive::report::formula::Formulas;
use rederive::report::{json, reason};
use rederive::verdict::{Changed, Outcome, Preferred, Verdict};
use serde_json::Value;

const LETTERS: &str = r#"
```toml symbols
x = { value = "-2", meaning = "a real number" }
y = { meaning = "a real number" }
p = { positive = true, value = "2", meaning = "a positive number" }
l = { unit = "m", positive = true, meaning = "a length" }
t = { unit = "s", positive = true, meaning = "a time" }
'\mathbf{A}' = { shape = [2, 2], meaning = "a matrix" }
'\mathbf{v}' = { shape = [2, 1], meaning = "a vector" }
```
```math 1 define
z = x + y
```
"#;

fn audit(text: &str, options: Options) -> Audit {
    common::audit(text, options).unwrap_or_else(|rejection| panic!("{rejection}\n{text}"))
}

fn claimed(claim: &str) -> String {
    format!("{LETTERS}\n```math 2 claim\n{claim}\n```\n")
}

fn outcome<'a>(audit: &'a Audit, label: &str) -> &'a Outcome {
    let equation = audit.model.equation(label).expect("the claim");
    audit.outcomes_of(equation).next().expect("its link")
}

/// The verdict on a claim in one line.
fn answer(claim: &str, options: Options) -> (Verdict, String) {
    let audit = audit(&claimed(claim), options);
    let outcome = outcome(&audit, "2");
    let line = reason::reason(&audit, &Formulas::of(&audit.model), outcome);
    (outcome.verdict.clone(), line.to_plain())
}

fn refuted(claim: &str) -> String {
    let (verdict, line) = answer(claim, Options::default());
    let Verdict::Refuted(refutation) = verdict else {
        panic!("{claim} is {}: {line}", verdict.word());
    };
    assert!(
        refutation.misfit().is_some() || refutation.witness().is_some(),
        "{claim}: {line}"
    );
    line
}

#[test]
fn what_is_false_on_a_part_says_where_it_holds_and_is_not_mended() {
    for (claim, place) in [
        (r"\sqrt{x^2} = x", "where x >= 0"),
        (r"\left|x\right| = x", "where x >= 0"),
        (r"\sqrt{x^2} = -x", "where x <= 0"),
        (r"\left|z\right| = z", "where x + y >= 0"),
        (r"x\sqrt{x^2} = x^2", "where x >= 0"),
        (r"\sqrt{(p - 1)^2} = p - 1", "where p - 1 >= 0"),
        (
            r"\sqrt{x^2} + \sqrt{y^2} = x - y",
            "where x >= 0 and y <= 0",
        ),
        (
            r"\sqrt{x^2y^2} = xy",
            "where x >= 0 and y >= 0, or where x <= 0 and y <= 0",
        ),
    ] {
        let line = refuted(claim);
        assert!(
            line.ends_with(&format!("; it holds {place}")),
            "{claim}: {line}"
        );
    }
    // An inequality: a point at which it is true, beside the one at which it is not.
    let line = refuted("p > 1");
    assert!(line.contains("; it holds at p = "), "{line}");
}

/// The witness lies where the claim fails, also where the reference point does not.
#[test]
fn the_witness_is_beside_the_part() {
    let (verdict, line) = answer(r"\sqrt{(p - 1)^2} = p - 1", Options::default());
    let Verdict::Refuted(refutation) = verdict else {
        panic!("{line}");
    };
    let witness = refutation.witness().cloned().expect("a witness");
    let [left, right] = [witness.left, witness.right].map(|v| v.exact().expect("exact").clone());
    assert_eq!(left, -right);
    let one = num_rational::BigRational::from_integer(1.into());
    assert!(
        witness
            .point
            .iter()
            .all(|(_, value)| value.exact().is_some_and(|v| *v < one)),
        "{line}"
    );
}

#[test]
fn what_is_false_everywhere_has_no_part() {
    for claim in [
        r"\sqrt{x^2} = y",
        r"\sqrt{x^2 + 1} = x + 1",
        r"\left|x\right| + \left|y\right| = 2x - 3y",
        r"\left|x\right| = -1",
    ] {
        let (verdict, line) = answer(claim, Options::default());
        assert!(!line.contains("it holds"), "{claim}: {line}");
        assert_ne!(verdict.word().as_str(), "holds", "{claim}: {line}");
    }
    // A letter lost on both sides, or everything that was said of it, is no correction.
    refuted(r"\sqrt{x^2} = y");
}

#[test]
fn what_is_true_everywhere_is_no_part() {
    for claim in [
        r"\sqrt{p^2} = p",
        r"\sqrt{(x^2 + 1)^2} = x^2 + 1",
        r"\left|x\right|^2 = x^2",
    ] {
        let (verdict, line) = answer(claim, Options::default());
        assert_eq!(verdict.word().as_str(), "holds", "{claim}: {line}");
    }
}

#[test]
fn sides_of_different_shapes_are_named() {
    let line = refuted(r"\mathbf{A}\mathbf{v} = \mathbf{A}");
    assert!(line.contains("shapes do not fit: 2x1 = 2x2"), "{line}");
    let line = refuted(r"\mathbf{v} = p");
    assert!(line.contains("shapes do not fit: 2x1 = scalar"), "{line}");
}

#[test]
fn sides_of_different_units_are_named() {
    let audit = audit(&claimed("l^2 = l + t"), Options::default());
    assert_eq!(outcome(&audit, "2").verdict.word().as_str(), "refuted");
    let units: Vec<String> = audit.units.iter().map(ToString::to_string).collect();
    assert!(
        !units.is_empty() && units.iter().any(|u| u.contains("m^2")),
        "{units:?}"
    );
}

#[test]
fn an_empty_budget_is_said_to_be_empty() {
    let options = Options {
        candidates: 0,
        ..Options::default()
    };
    let (verdict, line) = answer("z = x - y", options);
    assert_eq!(verdict.word().as_str(), "refuted");
    assert!(
        line.ends_with("no correction: the budget is empty"),
        "{line}"
    );
}

/// Two corrections of a definition explain its claims: with one of them the matrix is symmetric.
#[test]
fn symmetry_tells_corrections_of_a_definition_apart() {
    let text = r"
```toml symbols
a = { meaning = 'a number' }
b = { meaning = 'a number' }
d = { meaning = 'a number' }
```
```math 1 define
\mathbf{M} = \begin{bmatrix} a & 2b \\ b & d \end{bmatrix}
```
```math 2 claim
\det \mathbf{M} = ad - (b + b)(b + b)
```
```math 3 claim
(\det\mathbf{M} - ad)^2 = (b + b)^2(b + b)^2
```
";
    let audit = audit(text, Options::default());
    let Verdict::Misprint { correction, .. } = &outcome(&audit, "2").verdict else {
        panic!("{}", outcome(&audit, "2").verdict.word());
    };
    assert_eq!(correction.changed, [Changed::Definition(0)]);
    assert_eq!(correction.preferred, Some(Preferred::Symmetry));
    let edit = &correction.edits[0];
    assert_eq!((&edit.printed[..], &edit.corrected[..]), ("b", "2b"));
    assert!(!correction.alternatives.is_empty());
    let inspection = [Inspection::of(audit)];
    let shown = serde_json::to_value(json::verdicts(&inspection)).expect("JSON");
    let shown = &shown["claims"][1]["correction"];
    assert_eq!(shown["preferred"], "with which the matrix is symmetric");
    assert_eq!(shown["changed"], serde_json::json!(["definition (1)"]));
    assert_eq!(shown["definition"]["equation"], "1");
    assert!(shown["cost"].as_u64() > Some(0) && shown["budget"].as_u64() > shown["tried"].as_u64());
    assert_ne!(shown["alternatives"], Value::Array(Vec::new()));
}

/// Either member of the chain could have the wrong sign; what is said of it later tells which.
#[test]
fn later_claims_tell_corrections_apart() {
    let text = |later: &str| {
        format!(
            r"
```toml symbols
a = {{ meaning = 'a number' }}
b = {{ meaning = 'a number' }}
```
```math 1 define
s = a - b = \frac{{a^2 - b^2}}{{a - b}}
```
```math 2 claim
{later}
```
"
        )
    };
    for (later, member) in [("s - b = a", "a - b"), ("s + b = a", "a - b")] {
        let audit = audit(&text(later), Options::default());
        let equation = audit.model.equation("1").expect("the chain");
        let found = audit.outcomes_of(equation).find_map(|o| match &o.verdict {
            Verdict::Misprint { correction, .. } => Some(correction),
            _ => None,
        });
        let correction = found.expect("a correction");
        assert_eq!(correction.edits[0].printed, member, "{later}");
        assert_eq!(
            correction.preferred,
            Some(Preferred::LaterClaims(1)),
            "{later}"
        );
        assert_eq!(
            outcome(&audit, "2").verdict.word().as_str(),
            "holds",
            "{later}"
        );
    }
}
