//! What is said beside a floating-point comparison is true: an inequality, or an equation under a hypothesis, has no
//! error at random points, zero digits have no sign, and no value is missing in the reference vectors without a word.

use super::dots::Draw;
use crate::common::audit;
use rederive::check::Options;
use rederive::comparison::Subject;
use rederive::inspection::Inspection;
use rederive::report::vectors::vectors;

const PREAMBLE: &str = r#"# Floating point

```toml symbols
a = { positive = true, value = "2" }
b = { positive = true, value = "3" }
x = { value = "2" }
u = { range = '0 \le u \le 1', value = "1/2" }
c = {}
```

```math defined define
h = a^2 + b, \quad g = \frac{1}{a - 2}, \quad k = \sqrt{a}, \quad p = c + 1, \quad m = gb
```

```math matrix define
\mathbf{A} = \begin{bmatrix} a & \sqrt{b} \\ 0 & 1 \end{bmatrix}
```

```toml numeric
seed = 3
samples = 4
quantities = ['h', '(a + 10^{20}) - 10^{20}']
box = { a = ["1", "10"], b = ["1", "10"], x = ["1", "5"], u = ["1/8", "1"] }
points = { one = { a = "1" }, two = { a = "2" } }
```
"#;

fn inspected(claims: &[(String, &str)]) -> Inspection {
    let mut text = PREAMBLE.to_string();
    for (k, (claim, settings)) in claims.iter().enumerate() {
        text += &format!("\n```math claim{k} claim\n{claim}\n```\n");
        if !settings.is_empty() {
            text += &format!("\n```toml claim{k}\n{settings}\n```\n");
        }
    }
    let options = Options {
        repair: false,
        ..Options::default()
    };
    Inspection::of(audit(&text, options).unwrap_or_else(|r| panic!("{r}")))
}

#[test]
fn what_is_no_equation_for_all_values_has_no_error() {
    let mut draw = Draw::new(6);
    let mut claims = Vec::new();
    let mut equations = Vec::new();
    for k in 0..220 {
        let n = draw.below(9) + 1;
        let (claim, settings, equation) = match k % 10 {
            0 => (format!("a + {n} > 0"), "", false),
            1 => (format!(r"{n}a \ne 0"), "", false),
            2 => (format!(r"{n}u \le {n}"), "", false),
            3 => (format!("{n}x^2 = {n}a^2"), "assume = ['x = a']", false),
            4 => (format!("x^2 + {n} = a^2 + {n}"), "given = ['x = a']", false),
            5 => (format!(r"h \ge b - {n}"), "", false),
            6 => (format!("a < a + {n}"), "", false),
            7 => (format!("{n}h = {n}a^2 + {n}b"), "", true),
            8 => (
                format!("(a + {n})^2 = a^2 + {}a + {}", 2 * n, n * n),
                "",
                true,
            ),
            _ => (format!("{n}k^2 = {n}a"), "", true),
        };
        if equation {
            equations.push(k);
        }
        claims.push((claim, settings));
    }
    let inspection = inspected(&claims);
    let comparison = inspection.comparison.as_ref().expect("a numeric table");
    let conflicts: Vec<String> = comparison
        .conflicts()
        .into_iter()
        .map(|subject| inspection.subject(subject))
        .collect();
    assert!(
        conflicts.is_empty() || conflicts == ["(a + 10^{20}) - 10^{20}"],
        "{conflicts:?}"
    );
    let compared: Vec<usize> = comparison
        .subjects
        .iter()
        .filter_map(|subject| match subject {
            Subject::Link { equation, .. } => {
                let label = &inspection.audit.model.equations[*equation].label;
                label.strip_prefix("claim")?.parse().ok()
            }
            Subject::Quantity(_) => None,
        })
        .collect();
    assert_eq!(compared, equations);
    for row in &comparison.rows {
        for digits in row.computed.iter().filter_map(|c| c.digits) {
            assert!(digits.is_sign_positive(), "{digits}");
        }
    }
    assert_eq!(
        inspection
            .fewest_digits(true)
            .map(|(d, _)| format!("{d:.1}")),
        Some("0.0".into())
    );
}

#[test]
fn no_value_is_missing_without_a_word() {
    let inspection = inspected(&[("h = a^2 + b".into(), "")]);
    let json = serde_json::to_value(vectors(&[inspection])).expect("JSON");
    let points = json["documents"][0]["points"].as_array().expect("points");
    assert_eq!(points.len(), 2);
    for (point, pole) in points.iter().zip([false, true]) {
        let mut said: Vec<(String, String)> = Vec::new();
        let text = |v: &serde_json::Value| v.as_str().unwrap_or_default().to_string();
        for quantity in point["quantities"].as_array().expect("quantities") {
            said.push((text(&quantity["name"]), "number".into()));
        }
        for quantity in point["left_out"].as_array().expect("left out") {
            said.push((text(&quantity["name"]), text(&quantity["why"])));
        }
        said.sort();
        let at_pole = if pole { "pole" } else { "number" };
        let expected = [
            (r"\mathbf{A}", "functions"),
            ("g", at_pole),
            ("h", "number"),
            ("k", "functions"),
            ("m", at_pole),
            ("p", "letters"),
        ];
        let expected = expected.map(|(name, why)| (name.to_string(), why.to_string()));
        assert_eq!(said, expected);
    }
}
