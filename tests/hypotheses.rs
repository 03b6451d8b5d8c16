//! What a document declares is taken seriously: counterexamples lie where it holds, divisors that it
//! keeps from vanishing are said not to vanish, and what is assumed is not called printed.

mod common;

use num_rational::BigRational;
use num_traits::{Signed, Zero};
use rederive::audit::Audit;
use rederive::check::Options;
use rederive::inspection::Inspection;
use rederive::verdict::{Because, Verdict};

fn audit(text: &str, repair: bool) -> Audit {
    let options = Options {
        repair,
        ..Options::default()
    };
    common::audit(text, options).unwrap_or_else(|r| panic!("{r}"))
}

const MATRIX: &str = r#"```toml document
title = "t"
instances = { f = [2, 3] }
```
```toml symbols
'\mathbf{M}' = { shape = ["f", "f"], symmetric = true, positive_definite = true, meaning = "mass" }
'\mathbf{x}' = { shape = ["f", 1], meaning = "direction" }
```
```toml notation
'\mathbf{E}' = { identity = "f" }
```
"#;

#[test]
fn a_counterexample_has_a_positive_definite_matrix_where_one_is_declared() {
    let text = format!(
        "{MATRIX}```math 1 claim\n\\mathbf{{x}}^T\\mathbf{{M}}\\mathbf{{x}} = 2\\mathbf{{x}}^T\\mathbf{{M}}\\mathbf{{x}}\n```\n"
    );
    let audit = audit(&text, false);
    let Verdict::Refuted(refutation) = &audit.outcomes[0].verdict else {
        panic!("{:?}", audit.outcomes[0].verdict);
    };
    let witness = refutation.witness().expect("a point");
    let value = |name: &str| -> BigRational {
        let found = witness.point.iter().find(|(letter, _)| {
            rederive::latex::canonical(&audit.model.letter_name(*letter)) == name
        });
        found.map_or_else(BigRational::zero, |(_, v)| {
            v.exact().expect("exact").clone()
        })
    };
    let [a, b, c] = ["11", "12", "22"].map(|k| value(&format!("\\mathbf{{M}}_{{{k}}}")));
    assert!(a.is_positive() && !b.is_zero(), "{witness:?}");
    assert!((&a * &c - &b * &b).is_positive(), "{witness:?}");
}

fn because(text: &str) -> Vec<Option<Because>> {
    let audit = audit(text, true);
    let conditions = audit.outcomes.iter().flat_map(|o| o.conditions.clone());
    conditions.map(|c| c.because).collect()
}

#[test]
fn the_determinant_of_a_positive_definite_matrix_does_not_vanish() {
    let text = format!(
        "{MATRIX}```math 1 claim\n\\mathbf{{M}}^{{-1}}\\mathbf{{M}} = \\mathbf{{E}}\n```\n"
    );
    let found = because(&text);
    assert_eq!(found.len(), 2, "one for each f");
    for one in found {
        assert_eq!(one, Some(Because::Definite("\\mathbf{M}".into())));
    }
    // A matrix that is only symmetric may be singular.
    let general = because(&text.replace(", positive_definite = true", ""));
    assert_eq!(general, [None, None]);
}

const SCALARS: &str = r#"```toml symbols
a = { positive = true, meaning = "positive" }
b = { positive = true, meaning = "positive" }
x = { meaning = "any" }
```
```toml notation
i = { constant = "i" }
```
"#;

#[test]
fn sums_of_squares_with_a_positive_term_do_not_vanish() {
    for (divisor, expected) in [
        ("a^2 + (b - x)^2", Some(Because::Sign)),
        ("ix + a", Some(Because::Sign)),
        ("x^2 + ixb - a", Some(Because::Sign)),
        ("(b - x)^2", None),
        ("a - b", None),
        ("a + b", Some(Because::Positive)),
    ] {
        let text =
            format!("{SCALARS}```math 1 claim\n\\frac{{{divisor}}}{{{divisor}}}y = y\n```\n");
        let text = text.replace("x = {", "y = { meaning = \"any\" }\nx = {");
        let found = because(&text);
        assert_eq!(found, [expected], "{divisor}");
    }
}

#[test]
fn the_report_calls_printed_what_the_paper_prints_and_assumed_what_is_assumed() {
    let text = format!(
        "{SCALARS}```math 1 claim\na + b > 0\n```\n```math own claim\nx + a = a\n```\n\
         ```toml own\nassume = [\"x = 0\"]\n```\n```math words claim\na - a = 0\n```\n\
         ```toml words\nquote = 'It vanishes for every $a$.'\n```\n"
    );
    let audit = audit(&text, true);
    let inspection = Inspection {
        audit,
        comparison: None,
    };
    let tex = rederive::report::latex::report(&[inspection]);
    for expected in [
        "Equation (1),} a claim, as printed:",
        "Equation (own),} a claim, as written in the document:",
        "It vanishes for every $a$.",
        "as assumed",
        "ositive for all values of the letters",
    ] {
        assert!(tex.contains(expected), "{expected}\n{tex}");
    }
    assert!(
        !tex.contains("(1) is an identity"),
        "an inequality is no identity"
    );
}

#[test]
fn the_report_says_beside_its_headline_what_the_verdicts_rest_on() {
    let of = |number: u32, more: &str, role: &str| {
        let text = format!(
            "```toml document\ntitle = \"t\"\npaper = \"A paper\"\nequations = \"{number}\"\n{more}```\n\
             {SCALARS}```math {number} {role}\ny = a\n```\n"
        );
        let text = match role {
            "claim" => text.replace("y = a", "a = a"),
            _ => text,
        };
        Inspection {
            audit: audit(&text, true),
            comparison: None,
        }
    };
    let both = [
        of(1, "rests_on = \"one example\"\n", "claim"),
        of(2, "", "define"),
    ];
    let tex = rederive::report::latex::report(&both);
    for expected in [
        "Of these, one says something that was checked; one only gives names their values",
        "What they rest on: (1) on one example.",
        "A paper: a re-derivation",
    ] {
        assert!(tex.contains(expected), "{expected}\n{tex}");
    }
}
