//! Misprints planted in published formulas of other fields: each is refuted, nearly all are mended at
//! the first proposal, and what is proposed is never the claim's own value in other words.

use rederive::audit::Audit;
use rederive::check::Options;
use rederive::check::edit::form::same_reading;
use rederive::document::{Document, VerdictWord};
use rederive::verdict::{Outcome, Verdict};
use std::fmt::Write;
use std::path::Path;

struct Planted {
    field: String,
    document: String,
    printed: String,
}

/// A document with the letters and definitions of a group, the true claim and one damaged.
fn planted() -> Vec<Planted> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/repairs/formulas.toml");
    let text = std::fs::read_to_string(path).expect("the table");
    let table: toml::Table = text.parse().expect("TOML");
    let strings = |value: &toml::Value| -> Vec<String> {
        let array = value.as_array().expect("a list");
        array
            .iter()
            .map(|v| v.as_str().expect("text").into())
            .collect()
    };
    let mut found = Vec::new();
    for group in table["group"].as_array().expect("groups") {
        let field = group["field"].as_str().expect("a field");
        let mut head = format!("# {field}\n\n```toml symbols\n");
        for letter in strings(&group["letters"]) {
            writeln!(
                head,
                "'{letter}' = {{ positive = true, meaning = \"a letter\" }}"
            )
            .expect("text");
        }
        head += "```\n";
        for (k, definition) in strings(&group["define"]).iter().enumerate() {
            write!(head, "\n```math d{k} define\n{definition}\n```\n").expect("text");
        }
        for claim in group["claim"].as_array().expect("claims") {
            let truth = claim["true"].as_str().expect("the claim");
            for printed in strings(&claim["printed"]) {
                let claims = format!(
                    "\n```math true claim\n{truth}\n```\n\n```math printed claim\n{printed}\n```\n"
                );
                found.push(Planted {
                    field: field.into(),
                    document: format!("{head}{claims}"),
                    printed,
                });
            }
        }
    }
    found
}

fn audit(text: &str, options: Options) -> Audit {
    let document = Document::parse("planted.md", text)
        .unwrap_or_else(|diagnostics| panic!("{diagnostics:?}\n{text}"));
    Audit::of(&document, options).unwrap_or_else(|rejection| panic!("{rejection}\n{text}"))
}

fn outcome<'a>(audit: &'a Audit, label: &str) -> &'a Outcome {
    let equation = audit.model.equation(label).expect("the claim");
    audit.outcomes_of(equation).next().expect("its link")
}

#[test]
fn planted_misprints_are_refuted_and_mended() {
    let all = planted();
    assert!(all.len() >= 60, "{} misprints", all.len());
    let (mut first, mut among, mut other) = (0, 0, String::new());
    for planted in &all {
        let audit = audit(&planted.document, Options::default());
        let truth = outcome(&audit, "true");
        assert_ne!(
            truth.verdict.word(),
            VerdictWord::Refuted,
            "{}",
            planted.document
        );
        assert_ne!(
            truth.verdict.word(),
            VerdictWord::Misprint,
            "{}",
            planted.document
        );
        let outcome = outcome(&audit, "printed");
        let intended = &audit.model.equations[truth.equation].display;
        let link = &audit.model.equations[outcome.equation].links[0];
        match &outcome.verdict {
            Verdict::Misprint { correction, .. } => {
                if same_reading(&correction.display, intended, link) {
                    first += 1;
                    among += 1;
                    continue;
                }
                let others = &correction.others;
                let proposed = others
                    .iter()
                    .any(|p| same_reading(&p.display, intended, link));
                among += usize::from(proposed);
                let edits = &correction.edits;
                let shown = edits
                    .iter()
                    .map(|e| format!("{} -> {}", e.printed, e.corrected));
                let shown: Vec<String> = shown.collect();
                let place = if proposed { "among others" } else { "not" };
                let line = format!(
                    "{}: {}: {shown:?}, {place}\n",
                    planted.field, planted.printed
                );
                other += &line;
            }
            Verdict::Refuted(_) => {
                other += &format!("{}: {}: no correction\n", planted.field, planted.printed);
            }
            verdict => panic!("{} is {}", planted.printed, verdict.word()),
        }
    }
    println!(
        "{} planted, first {first}, among the proposals {among}\n{other}",
        all.len()
    );
    assert!(
        100 * first >= 85 * all.len(),
        "first {first} of {}\n{other}",
        all.len()
    );
    assert!(
        100 * among >= 95 * all.len(),
        "among {among} of {}\n{other}",
        all.len()
    );
}

#[test]
fn an_empty_budget_finds_nothing_and_says_so() {
    let planted = planted().remove(0);
    let options = Options {
        candidates: 0,
        ..Options::default()
    };
    let audit = audit(&planted.document, options);
    let Verdict::Refuted(refutation) = &outcome(&audit, "printed").verdict else {
        panic!("a correction without a budget");
    };
    let searched = refutation.searched.expect("how far it was looked for");
    assert_eq!((searched.tried, searched.budget), (0, 0));
}

/// A definition that makes three claims false is corrected instead of the claims.
#[test]
fn a_slip_in_a_definition_is_found_there() {
    let text = "# A lens\n\n```toml symbols\nf = { meaning = \"focal length\" }\ng = { meaning = \"distance\" }\n```\n\n```math 1 define\nb = \\frac{fg}{g + f}\n```\n\n```math 2 claim\n\\frac{1}{f} - \\frac{1}{g} = \\frac{1}{b}\n```\n\n```math 3 claim\n(g - f)(b - f) = f^2\n```\n\n```math 4 claim\ng + b = \\frac{g^2}{g - f}\n```\n";
    let audit = audit(text, Options::default());
    let named = audit.model.equation("1").expect("the definition");
    for label in ["2", "3", "4"] {
        let Verdict::Misprint { correction, .. } = &outcome(&audit, label).verdict else {
            panic!("({label}) is {}", outcome(&audit, label).verdict.word());
        };
        let definition = correction.definition.as_ref();
        assert_eq!(definition.map(|(d, _)| *d), Some(named), "({label})");
    }
}

/// Both sides made the same by the edit say nothing, and neither does zero times both.
#[test]
fn a_correction_that_says_nothing_is_none() {
    let text = "# Letters\n\n```toml symbols\na = { meaning = \"one\" }\nb = { meaning = \"two\" }\n```\n\n```math 1 define\nc = a^2 + ab + b^3\n```\n\n```math 2 claim\nc = a\n```\n";
    let audit = audit(text, Options::default());
    let outcome = outcome(&audit, "2");
    if let Verdict::Misprint { correction, .. } = &outcome.verdict {
        let written: Vec<_> = correction.edits.iter().map(|e| &e.corrected).collect();
        panic!("{written:?}");
    }
}

/// Long sums, matrices and definitions, so that every stage of the search has much to sift.
const LONG: &str = r#"# Long
```toml symbols
a = { positive = true, meaning = "a number" }
b = { positive = true, meaning = "a number" }
c = { positive = true, meaning = "a number" }
d = { positive = true, meaning = "a number" }
```
```math 1 define
s = \frac{ab + c^2}{c + d} + \frac{a^2 - 2bd}{b + d}, \quad
\mathbf{M} = \begin{bmatrix} a & b \\ c & s \end{bmatrix}
```
```math 2 claim
s = \frac{7ab^3 - 11c^2}{13c + d^2} + \frac{a^2 - 5bd}{b + 3d} - \frac{17a}{bcd} + 3ab - 2cd + 5ac
```
```math 3 claim
\mathbf{M}\mathbf{M} = \begin{bmatrix} a^2 + bc & ab + bs \\ ac + sc & bc + 7s^3d \end{bmatrix} + \mathbf{M}^3
```
```math 4 claim
s(c + d)(b + d) = (ab + c^2)(b + d) + (a^2 + 2bd)(c + d)
```
"#;

#[test]
fn the_number_of_threads_changes_nothing() {
    let found = |threads: usize| {
        let options = Options {
            candidates: 300_000,
            threads,
            ..Options::default()
        };
        format!("{:?}", audit(LONG, options).outcomes)
    };
    let one = found(1);
    assert!(one.contains("tried: 300000") || one.contains("budget: 300000"));
    assert_eq!(one, found(2));
    assert_eq!(one, found(5));
}
