//! A hypothesis that a document states and that its own reference values break. What is false without the
//! hypothesis may be true with it, and no point at which it does not hold shows anything.

use super::dots::Draw;
use super::unwritten::{Claim, Truth, undecided};
use crate::common::audit;
use rederive::check::Options;
use rederive::verdict::Verdict;

const PREAMBLE: &str = r#"# Hypotheses against the reference values

```toml symbols
x = { value = "1" }
y = { value = "-2" }
z = { value = "0" }
a = { positive = true, value = "2" }
b = { positive = true, value = "3" }
c = {}
u = { range = '0 \le u \le 1', value = "1/2" }
n = { domain = "integer", value = "4" }
```

```math s define
s = x + y
```
"#;

/// Claims that follow from a hypothesis, and claims that do not.
struct Under {
    given: &'static [&'static str],
    follows: &'static [&'static str],
    does_not: &'static [&'static str],
}

/// All broken by the reference values.
const BROKEN: &[Under] = &[
    Under {
        given: &["x = y"],
        follows: &[
            "x^2 = y^2",
            "xc = yc",
            "x^3 + c = y^3 + c",
            "x - y = 0",
            r"\frac{x}{1 + c^2} = \frac{y}{1 + c^2}",
            r"x \le y",
            "s = 2y",
        ],
        does_not: &["x = y + 1", "x^2 = y^2 + 1", "xc = 2yc", "x > y", "s = 3y"],
    },
    Under {
        given: &["x^3 = y^3"],
        follows: &["x = y", "x^2 = xy", r"x \ge y"],
        does_not: &["x = -y", "x = 2y + 1", "x < y"],
    },
    Under {
        given: &["a > b"],
        follows: &[r"a \ge b", "a - b > 0", r"a \ne b", "a^2 > b^2"],
        does_not: &["a < b", "a = b", "a > 2b", "a > b + 1"],
    },
    Under {
        given: &["a^2 = b^2"],
        follows: &["a = b", "ca = cb", r"a \le b"],
        does_not: &["a = 2b", "a < b", "a = b^2"],
    },
    Under {
        given: &[r"a > \frac52"],
        follows: &["a > 2", "2a > 5", r"a \ge \frac94", r"a \ne 2"],
        does_not: &["a > 3", "a = 2", "a < 3"],
    },
    Under {
        given: &[r"z \ne 0"],
        follows: &["z^2 > 0", r"z^2 \ne 0"],
        does_not: &["z > 0", "z = 0", "z^2 > 1", "z^2 = 0"],
    },
    Under {
        given: &["2z = 2"],
        follows: &["z = 1", "z^2 = z", "cz = c", "z > 0"],
        does_not: &["z = 2", "z = 0", "z > 1", "cz = 2c"],
    },
    Under {
        given: &["x < 0"],
        follows: &["|x| = -x", r"x \ne 0", "x^3 < 0"],
        does_not: &["|x| = x", "x < -1", "x^2 < 0"],
    },
    Under {
        given: &["y > 0", "a > b"],
        follows: &["|y| = y", "ay > by", "a + y > b"],
        does_not: &["|y| = -y", "ay = by", "ay < by"],
    },
    Under {
        given: &["s = 0"],
        follows: &["x = -y", "x^2 = y^2", "cx = -cy"],
        does_not: &["x = y", "x^2 = 2y^2", "cx = cy + 1"],
    },
    Under {
        given: &[r"\sqrt{a} = 2"],
        follows: &["a = 4", "ca = 4c"],
        does_not: &["a = 2", "ca = 2c"],
    },
    Under {
        given: &["2u = 2"],
        follows: &["u = 1", "u^2 = u"],
        does_not: &["u = 0", "u < 1"],
    },
    Under {
        given: &["n^2 = 9", "n > 0"],
        follows: &["n = 3"],
        does_not: &["n = -3", "n = 4"],
    },
];

/// Broken by none.
const KEPT: &[Under] = &[
    Under {
        given: &["a < b"],
        follows: &[r"a \le b", "b - a > 0"],
        does_not: &["a > b", "a = b"],
    },
    Under {
        given: &["x = c"],
        follows: &["x^2 = c^2"],
        does_not: &["x = -c", "x^2 = 2c^2"],
    },
    Under {
        given: &["y < 0"],
        follows: &["|y| = -y"],
        does_not: &["|y| = y"],
    },
];

fn claims_of(all: &[Under], draw: &mut Draw, most: usize) -> Vec<Claim> {
    let mut claims = Vec::new();
    for under in all {
        let given: Vec<String> = under.given.iter().map(|g| g.to_string()).collect();
        let lists = [(under.follows, Truth::True), (under.does_not, Truth::False)];
        for (list, truth) in lists {
            for claim in list {
                claims.push(Claim::under(*claim, "given", &given, truth));
                // Both sides moved by what stands for nothing new.
                let Some((left, right)) = claim.split_once(" = ") else {
                    continue;
                };
                for by in ["c", "7", "2ab", r"\frac{1}{a}"] {
                    if claims.len() < most && draw.below(3) > 0 {
                        let more = format!("{by} + {left} = {right} + {by}");
                        claims.push(Claim::under(more, "given", &given, truth));
                    }
                }
            }
        }
    }
    claims
}

#[test]
fn what_the_reference_values_break_is_refuted_by_no_point_of_theirs() {
    let mut draw = Draw::new(5);
    let claims = claims_of(BROKEN, &mut draw, 400);
    assert!(claims.len() > 200, "{}", claims.len());
    undecided(PREAMBLE, &claims);
}

#[test]
fn what_they_do_not_break_is_decided() {
    let mut draw = Draw::new(6);
    let mut claims = claims_of(KEPT, &mut draw, 400);
    for k in 0..100 {
        claims.push(Claim::plain(format!("{k}x = {k}x"), Truth::True));
    }
    let open = undecided(PREAMBLE, &claims);
    assert!(open.is_empty(), "{open:#?}");
}

#[test]
fn the_verdict_names_the_hypothesis_and_the_values() {
    for (claim, given, names) in [
        ("x^2 = y^2", "x = y", [r"x = y", "x = 1", "y = -2"]),
        ("z^2 > 0", r"z \ne 0", [r"z \neq 0", "z = 0", "values"]),
        ("x^2 = 2y^2", "x = y", ["x = y", "x = 1", "y = -2"]),
    ] {
        let text = format!(
            "{PREAMBLE}\n```math 1 claim\n{claim}\n```\n\n```toml 1\ngiven = ['{given}']\n```\n"
        );
        let audit = audit(&text, Options::default()).unwrap_or_else(|r| panic!("{r}"));
        let equation = audit.model.equation("1").expect("a claim");
        let outcome = audit.outcomes_of(equation).next().expect("a link");
        let reason = match &outcome.verdict {
            Verdict::Undecided { reason } => reason.clone(),
            Verdict::Refuted(refutation) => refutation.contradicted.clone().unwrap_or_default(),
            other => panic!("{claim}: {}", other.word()),
        };
        for name in names {
            assert!(reason.contains(name), "{reason}");
        }
    }
}
