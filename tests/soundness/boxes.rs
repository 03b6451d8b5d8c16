//! Statements over a box: what is so for all values may be otherwise in a part of them. Polynomials whose derivative
//! has known roots, over boxes around the reference value; truth by where the roots lie.

use super::dots::Draw;
use super::statements::{Poly, q};
use crate::common::audit;
use rederive::check::Options;
use rederive::document::VerdictWord::{self, Holds, Loose, Refuted, Undecided};

const PREAMBLE: &str = r#"# Over a box

```toml symbols
x = { positive = true, value = "3" }
y = { positive = true, value = "2" }
```
"#;

#[test]
fn what_is_said_of_a_box_is_judged_in_it() {
    let mut draw = Draw::new(8);
    let mut text = PREAMBLE.to_string();
    let mut all: Vec<(String, bool)> = Vec::new();
    while all.len() < 240 {
        // Roots in halves; the box goes from 5/2 to 7/2.
        let roots: Vec<i128> = (0..1 + draw.below(3))
            .map(|_| draw.below(12) as i128)
            .collect();
        let sign = if draw.coin() { 1 } else { -1 };
        let poly = Poly::with_slope(sign, &roots, draw.below(5) as i128);
        let inside = roots.iter().any(|r| (5..=7).contains(r));
        // At an end, or with an even root, the sign says nothing here.
        if roots.iter().any(|r| matches!(r, 5 | 7)) || roots.iter().filter(|r| **r == 6).count() > 1
        {
            continue;
        }
        let rising = sign * roots.iter().map(|r| (6 - r).signum()).product::<i128>() > 0;
        let here = roots.contains(&6);
        let minimum_inside = here && {
            let others: i128 = roots
                .iter()
                .filter(|r| **r != 6)
                .map(|r| (6 - r).signum())
                .product();
            sign * others > 0
        };
        let (predicate, truth) = match draw.below(8) {
            0 => ("increasing in", !inside && rising),
            1 => ("decreasing in", !inside && !rising),
            2 => ("not monotone in", inside),
            3 => ("has a minimum in", !inside || minimum_inside),
            4 => ("has a maximum in", !inside || !minimum_inside),
            5 => ("minimal at", minimum_inside),
            6 => ("maximal at", here && !minimum_inside),
            _ => ("least at the lower bound of", !inside && rising),
        };
        // Two ends with equal values would be two places.
        if predicate.starts_with("has a") && inside {
            continue;
        }
        // What is said of a lower bound goes from the reference value on.
        if predicate.starts_with("least") {
            continue;
        }
        let k = all.len();
        text += &format!(
            "\n```statement s{k}\nA sentence.\n```\n\n```toml s{k}\nof = ['{}']\npredicate = \"{predicate}\"\n\
             in = ['x']\nbox = ['x']\ntimes = ['5/6', '7/6']\nover = 'box'\n```\n",
            poly.text("x")
        );
        all.push((format!("{roots:?} {sign} {predicate}"), truth));
    }
    assert_eq!(q(2, 4), (1, 2));
    let audit = audit(&text, Options::default()).unwrap_or_else(|r| panic!("{r}"));
    let mut open = 0;
    let mut wrong = Vec::new();
    for (outcome, (what, truth)) in audit.statements.iter().zip(&all) {
        match (outcome.word, truth) {
            (Undecided, _) => open += 1,
            (Holds, true) | (Refuted | Loose, false) => {}
            (word, truth) => wrong.push(format!("{what} is {truth}: {word}")),
        }
    }
    assert!(
        wrong.is_empty(),
        "{} of {}: {wrong:#?}",
        wrong.len(),
        all.len()
    );
    assert!(
        2 * open < 3 * all.len() / 2,
        "{open} of {} undecided",
        all.len()
    );
}

#[test]
fn what_no_box_is_asked_for_is_open() {
    for (of, rest, allowed) in [
        (
            "(1-x)^2",
            "predicate = \"minimal at\"\nat = '1'",
            &[Undecided, Refuted][..],
        ),
        (
            "x + 1/x",
            "predicate = \"has a maximum in\"",
            &[Undecided, Holds],
        ),
        (
            "x",
            "predicate = \"maximal at\"\nat = '7/2'",
            &[Undecided, Holds],
        ),
        (
            "x^2",
            "predicate = \"minimal at\"\nat = '5/2'",
            &[Undecided, Holds],
        ),
        (
            "xy",
            "predicate = \"independent of\"",
            &[Undecided, Refuted],
        ),
        ("y", "predicate = \"independent of\"", &[Holds]),
        (
            "x",
            "predicate = \"equals\"\nto = '3'",
            &[Undecided, Refuted, Loose],
        ),
    ] as [(&str, &str, &[VerdictWord]); 7]
    {
        let letter = if rest.contains("equals") {
            ""
        } else {
            "in = ['x']\n"
        };
        let text = format!(
            "{PREAMBLE}\n```statement s\nA sentence.\n```\n\n```toml s\nof = ['{of}']\n{rest}\n{letter}\
             box = ['x']\ntimes = ['5/6', '7/6']\nover = 'box'\n```\n"
        );
        let audit = audit(&text, Options::default()).unwrap_or_else(|r| panic!("{r}"));
        let word = audit.statements[0].word;
        assert!(allowed.contains(&word), "{of} {rest}: {word}");
    }
}
