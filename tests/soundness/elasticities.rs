//! Quantities that are zero at the reference values whatever one of their letters is: there the elasticity is
//! 0/0, which cancels before values are put in, and nothing rests on it.

use crate::common::audit;
use rederive::check::Options;
use rederive::document::VerdictWord::{self, Holds, Loose, Refuted, Undecided};

const PREAMBLE: &str = r#"# Zero at the reference values

```toml symbols
x = { value = "1" }
y = { value = "3" }
z = { value = "0" }
u = { range = '0 \le u \le 1', value = "0" }
v = { range = '0 \le v \le 1', value = "1" }
p = { positive = true, value = "2" }
a = { positive = true, value = "2" }
b = { positive = true, value = "3" }
k = {}
```
"#;

/// Zero at the reference values, without x.
const ZEROS: [&str; 12] = [
    "z",
    "z^2",
    "u",
    "(v - 1)",
    "(p - a)",
    "(ab - 6)",
    "z(y + 1)",
    r"\left(\frac{p}{a} - 1\right)",
    "(y - b)",
    "(1 - v^2)",
    "zk",
    "z(k^2 + 1)",
];

/// Factors with the elasticity in x that they have at the reference values, in halves.
const FACTORS: [(&str, i64); 8] = [
    ("x", 2),
    ("x^2", 4),
    ("(x^2 + 1)", 2),
    (r"\frac{x}{a}", 2),
    (r"\frac{1}{x}", -2),
    (r"\frac{a}{1 + x}", -1),
    ("(x + 1)^2", 2),
    (r"\frac{x^3}{1 + y^2}", 6),
];

struct Said {
    of: String,
    rest: String,
    allowed: Vec<VerdictWord>,
}

fn said(of: String, rest: &str, allowed: &[VerdictWord]) -> Said {
    Said {
        of,
        rest: rest.into(),
        allowed: allowed.to_vec(),
    }
}

#[test]
fn what_is_zero_whatever_a_letter_is_has_no_elasticity_in_it() {
    let essential = "predicate = \"depends essentially on\"\nin = ['x']";
    let independent = "predicate = \"independent of\"\nin = ['x']";
    let mut all = Vec::new();
    for (factor, halves) in FACTORS {
        all.push(said(factor.into(), essential, &[Holds]));
        all.push(said(factor.into(), independent, &[Refuted]));
        assert_ne!(halves, 0);
        for zero in ZEROS {
            let of = format!(r"{zero} \cdot {factor}");
            all.push(said(of.clone(), essential, &[Undecided]));
            all.push(said(of.clone(), independent, &[Loose]));
            // Beside what does not vanish x changes nothing.
            let beside = format!("{of} + y");
            let known: &[VerdictWord] = match zero.contains('k') {
                true => &[Refuted, Undecided],
                false => &[Refuted],
            };
            all.push(said(beside.clone(), essential, known));
            all.push(said(beside, independent, &[Loose]));
            for predicate in ["small compared with", "close to"] {
                let rest = format!("predicate = \"{predicate}\"\nto = '1000 \\cdot {of}'");
                all.push(said(of.clone(), &rest, &[Undecided]));
            }
            let rest = format!("predicate = \"equals\"\nto = '2 \\cdot {of}'");
            all.push(said(of.clone(), &rest, &[Holds]));
        }
    }
    // Where y varies, y - b does not vanish.
    for zero in ZEROS.iter().filter(|zero| **zero != "(y - b)") {
        let of = format!(r"{zero} \cdot x(x + y)");
        let groups = "predicate = \"separates into\"\ngroups = [['x'], ['y']]";
        all.push(said(of, groups, &[Loose, Undecided]));
    }
    let mut text = PREAMBLE.to_string();
    for (k, said) in all.iter().enumerate() {
        let of = &said.of;
        let rest = &said.rest;
        text += &format!(
            "\n```statement s{k}\nA sentence.\n```\n\n```toml s{k}\nof = ['{of}']\n{rest}\n```\n"
        );
    }
    let audit = audit(&text, Options::default()).unwrap_or_else(|r| panic!("{r}"));
    assert_eq!(audit.statements.len(), all.len());
    let wrong: Vec<String> = audit
        .statements
        .iter()
        .zip(&all)
        .filter(|(outcome, said)| !said.allowed.contains(&outcome.word))
        .map(|(o, said)| format!("{} {}: {}", said.of, said.rest, o.word))
        .collect();
    assert!(
        wrong.is_empty(),
        "{} of {}: {wrong:#?}",
        wrong.len(),
        all.len()
    );
}
