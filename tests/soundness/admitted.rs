//! Relations of order, limits and statements where hypotheses narrow what the letters may be: what
//! follows from the narrowed ranges holds, and what is refuted fails at a point that the hypotheses
//! admit. The truth is known from all points of a fine grid, or by hand; every point that is shown is
//! put into the hypotheses again.

use super::signs::Random;
use crate::common::audit;
use num_rational::BigRational;
use num_traits::ToPrimitive;
use rederive::check::Options;
use rederive::model::Letter;
use rederive::verdict::Verdict;

/// The letters and where they may be by their declarations.
const SYMBOLS: &str = r#"```toml symbols
x = { meaning = "any" }
y = { meaning = "any" }
z = { meaning = "any" }
a = { positive = true }
b = { positive = true }
c = { positive = true }
u = { range = '0 \le u \le 2' }
v = { range = '-1 < v < 3' }
n = { domain = "integer", range = '-4 < n' }
```
```toml notation
'e' = { constant = "e" }
'\pi' = { constant = "pi" }
```
"#;

/// Whether a value of a letter is admitted by its declaration.
fn declared(letter: &str, value: f64) -> bool {
    match letter {
        "a" | "b" | "c" => value > 0.0,
        "u" => (0.0..=2.0).contains(&value),
        "v" => value > -1.0 && value < 3.0,
        "n" => value > -4.0 && value.fract() == 0.0,
        _ => true,
    }
}

type Test = Box<dyn Fn(&[f64]) -> bool>;

/// A claim in some letters under hypotheses.
struct Relative {
    claim: String,
    key: &'static str,
    hypotheses: Vec<String>,
    letters: Vec<&'static str>,
    admits: Test,
    truth: bool,
}

fn document(relatives: &[Relative]) -> String {
    let mut text = format!("```toml document\ntitle = \"t\"\n```\n{SYMBOLS}");
    for (k, relative) in relatives.iter().enumerate() {
        text += &format!("```math c{k} claim\n{}\n```\n", relative.claim);
        let list: Vec<String> = relative
            .hypotheses
            .iter()
            .map(|h| format!("'{h}'"))
            .collect();
        let (key, list) = (relative.key, list.join(", "));
        text += &format!("```toml c{k}\n{key} = [{list}]\n```\n");
    }
    text
}

/// Whether the point that shows a claim false satisfies the hypotheses.
fn shown_where_admitted(
    relative: &Relative,
    verdict: &Verdict,
    model: &rederive::model::Model,
) -> bool {
    let refutation = match verdict {
        Verdict::Refuted(refutation) => refutation,
        Verdict::Misprint { refutation, .. } => refutation,
        _ => return true,
    };
    let Some(witness) = refutation.witness() else {
        return true;
    };
    let mut values = vec![None; relative.letters.len()];
    for (letter, value) in &witness.point {
        let Letter::Symbol { symbol, order: 0 } = model.letters[*letter] else {
            continue;
        };
        let name = rederive::latex::canonical(&model.symbols[symbol].name);
        let place = relative.letters.iter().position(|l| *l == name);
        if let (Some(place), Some(value)) = (place, value.exact()) {
            values[place] = BigRational::to_f64(value);
        }
    }
    // Of a letter that is not shown nothing is said: it is not used.
    let Some(values) = values.into_iter().collect::<Option<Vec<f64>>>() else {
        return relative.letters.len() > 1;
    };
    let mut named = relative.letters.iter().zip(&values);
    named.all(|(l, v)| declared(l, *v)) && (relative.admits)(&values)
}

fn judge(relatives: &[Relative], of_true: f64, of_false: f64) {
    let options = Options {
        repair: false,
        ..Options::default()
    };
    let text = document(relatives);
    let audit = audit(&text, options).unwrap_or_else(|r| panic!("{r}"));
    // Of a limit the first member says where it is taken.
    let claims = audit.outcomes.iter();
    let claims = claims.filter(|o| !matches!(o.verdict, Verdict::Definition { .. }));
    let claims: Vec<_> = claims.collect();
    assert_eq!(claims.len(), relatives.len());
    let (mut wrong, mut open) = (Vec::new(), Vec::new());
    let (mut decided, mut all) = ([0_usize; 2], [0_usize; 2]);
    for (relative, outcome) in relatives.iter().zip(claims) {
        let shown = format!(
            "{} with {} {:?} is {}: {:?}",
            relative.claim, relative.key, relative.hypotheses, relative.truth, outcome.verdict
        );
        all[usize::from(relative.truth)] += 1;
        let said = match &outcome.verdict {
            Verdict::Holds { .. } | Verdict::HoldsGiven(..) => Some(true),
            Verdict::Refuted(_) | Verdict::Misprint { .. } => Some(false),
            Verdict::Undecided { .. } => None,
            Verdict::Definition { .. } | Verdict::Recalled { .. } => panic!("{shown}"),
        };
        match said {
            Some(said) if said != relative.truth => wrong.push(shown),
            Some(_) if !shown_where_admitted(relative, &outcome.verdict, &audit.model) => {
                wrong.push(format!("at a point that is not admitted: {shown}"));
            }
            Some(_) => decided[usize::from(relative.truth)] += 1,
            None => open.push(shown),
        }
    }
    let count = relatives.len();
    assert!(
        wrong.is_empty(),
        "{} of {count}:\n{}",
        wrong.len(),
        wrong.join("\n")
    );
    let share = |k: usize| decided[k] as f64 / all[k].max(1) as f64;
    println!(
        "{decided:?} of {all:?} decided (false, true); open:\n{}",
        open.join("\n")
    );
    assert!(
        share(1) >= of_true && share(0) >= of_false,
        "{decided:?} of {all:?} decided, open:\n{}",
        open.join("\n")
    );
}

/// Quarters between these whole numbers.
fn quarters(low: i32, high: i32) -> Vec<f64> {
    (4 * low..=4 * high).map(|q| f64::from(q) / 4.0).collect()
}

fn compare(relation: &str, left: f64, right: f64) -> bool {
    match relation {
        ">" => left > right,
        r"\ge" => left >= right,
        "<" => left < right,
        r"\le" => left <= right,
        _ => left != right,
    }
}

const ORDERS: [&str; 5] = [">", r"\ge", "<", r"\le", r"\ne"];

#[test]
fn one_letter_in_a_supposed_range() {
    let mut random = Random::new(11);
    let mut all: Vec<Relative> = Vec::new();
    while all.len() < 300 {
        let letter = *random.pick(&["x", "a", "u", "v", "n"]);
        // One or two hypotheses beside the declaration, some of them not in the simplest form.
        let mut hypotheses = Vec::new();
        let mut tests: Vec<(&'static str, f64)> = Vec::new();
        for _ in 0..random.between(1, 2) {
            let relation = *random.pick(&ORDERS);
            let at = random.between(-2, 4);
            hypotheses.push(match random.between(0, 3) {
                0 => format!("2{letter} + 1 {relation} {}", 2 * at + 1),
                1 => format!("{letter} - ({at}) {relation} 0"),
                _ => format!("{letter} {relation} {at}"),
            });
            tests.push((relation, at as f64));
        }
        let admits = move |p: &[f64]| tests.iter().all(|(r, at)| compare(r, p[0], *at));
        let points: Vec<f64> = quarters(-20, 40)
            .into_iter()
            .filter(|v| declared(letter, *v) && admits(&[*v]))
            .collect();
        if points.is_empty() {
            continue;
        }
        let roots: Vec<i64> = (0..random.between(1, 3))
            .map(|_| random.between(-2, 4))
            .collect();
        let relation = *random.pick(&ORDERS);
        let product: String = roots
            .iter()
            .map(|r| format!("({letter} - ({r}))"))
            .collect();
        let value = |v: f64| roots.iter().map(|r| v - *r as f64).product::<f64>();
        let (claim, truth) = match random.between(0, 5) {
            0 => {
                let claim = format!(r"\frac{{{product}}}{{{letter}^2 + 1}} {relation} 0");
                (
                    claim,
                    points.iter().all(|v| compare(relation, value(*v), 0.0)),
                )
            }
            1 => {
                let r = roots[0];
                let claim = format!("{letter} + 1 {relation} {}", r + 1);
                (
                    claim,
                    points.iter().all(|v| compare(relation, *v, r as f64)),
                )
            }
            2 => {
                let claim = format!("0 {relation} {product}");
                (
                    claim,
                    points.iter().all(|v| compare(relation, 0.0, value(*v))),
                )
            }
            3 => {
                let claim = format!("({product})^2 {relation} 0");
                let square = |v: f64| value(v).powi(2);
                (
                    claim,
                    points.iter().all(|v| compare(relation, square(*v), 0.0)),
                )
            }
            _ => {
                let claim = format!("{product} {relation} 0");
                (
                    claim,
                    points.iter().all(|v| compare(relation, value(*v), 0.0)),
                )
            }
        };
        all.push(Relative {
            claim,
            key: "assume",
            hypotheses,
            letters: vec![letter],
            admits: Box::new(admits),
            truth,
        });
    }
    judge(&all, 0.95, 0.95);
}

/// A relation between letters as a hypothesis.
struct Between {
    text: &'static str,
    letters: [&'static str; 2],
    admits: fn(f64, f64) -> bool,
}

const BETWEEN: [Between; 16] = [
    Between {
        text: "a > b",
        letters: ["a", "b"],
        admits: |a, b| a > b,
    },
    Between {
        text: r"a \ge b",
        letters: ["a", "b"],
        admits: |a, b| a >= b,
    },
    Between {
        text: "x < y",
        letters: ["x", "y"],
        admits: |x, y| x < y,
    },
    Between {
        text: r"x \ne y",
        letters: ["x", "y"],
        admits: |x, y| x != y,
    },
    Between {
        text: "x + y < 1",
        letters: ["x", "y"],
        admits: |x, y| x + y < 1.0,
    },
    Between {
        text: r"a + b \le 2",
        letters: ["a", "b"],
        admits: |a, b| a + b <= 2.0,
    },
    Between {
        text: "xy > 0",
        letters: ["x", "y"],
        admits: |x, y| x * y > 0.0,
    },
    Between {
        text: "x < y < 2",
        letters: ["x", "y"],
        admits: |x, y| x < y && y < 2.0,
    },
    Between {
        text: "0 < x < y",
        letters: ["x", "y"],
        admits: |x, y| 0.0 < x && x < y,
    },
    Between {
        text: "1 < b < a",
        letters: ["a", "b"],
        admits: |a, b| 1.0 < b && b < a,
    },
    Between {
        text: "x = 2y",
        letters: ["x", "y"],
        admits: |x, y| x == 2.0 * y,
    },
    Between {
        text: "a = b + 1",
        letters: ["a", "b"],
        admits: |a, b| a == b + 1.0,
    },
    Between {
        text: "a = x^2",
        letters: ["a", "x"],
        admits: |a, x| a == x * x,
    },
    Between {
        text: "x > a",
        letters: ["x", "a"],
        admits: |x, a| x > a,
    },
    Between {
        text: r"\frac{x}{a} < 1",
        letters: ["x", "a"],
        admits: |x, a| x < a,
    },
    Between {
        text: "x^2 + y^2 < 1",
        letters: ["x", "y"],
        admits: |x, y| x * x + y * y < 1.0,
    },
];

#[test]
fn two_letters_that_are_compared() {
    let mut random = Random::new(12);
    let mut all: Vec<Relative> = Vec::new();
    let mut grid = quarters(-6, 8);
    // Beside the quarters some numbers near zero and far away.
    for far in [0.125, 0.015625, 0.4375, 0.875, 100.0] {
        grid.extend([far, -far, 2.0 * far, far * far, far + 1.0]);
    }
    while all.len() < 240 {
        let between = random.pick(&BETWEEN);
        let [p, q] = between.letters;
        let key = if all.len() % 5 == 4 {
            "given"
        } else {
            "assume"
        };
        let relation = *random.pick(&ORDERS);
        let [i, j, k] = [0; 3].map(|_: i64| random.between(-2, 2));
        let (left, value): (String, Box<dyn Fn(f64, f64) -> f64>) = match random.between(0, 5) {
            0 => (
                format!("({p} - {q})({p} + {q})"),
                Box::new(|p: f64, q: f64| (p - q) * (p + q)),
            ),
            1 => (
                format!("({p} - {q})^2"),
                Box::new(|p: f64, q: f64| (p - q).powi(2)),
            ),
            // That pq is no such number the grid cannot tell.
            2 if relation != r"\ne" => (
                format!("{p}{q} + ({k})"),
                Box::new(move |p: f64, q: f64| p * q + k as f64),
            ),
            3 => (
                format!("({p} - ({k}))({q} - ({j}))"),
                Box::new(move |p: f64, q: f64| (p - k as f64) * (q - j as f64)),
            ),
            _ => (
                format!("({i}){p} + ({j}){q} + ({k})"),
                Box::new(move |p: f64, q: f64| i as f64 * p + j as f64 * q + k as f64),
            ),
        };
        let admits = between.admits;
        let truth = grid.iter().all(|p0| {
            grid.iter().all(|q0| {
                let there = declared(p, *p0) && declared(q, *q0) && admits(*p0, *q0);
                !there || compare(relation, value(*p0, *q0), 0.0)
            })
        });
        // The claim is more than the hypothesis itself, and needs it where it is `given`.
        let needed = !grid.iter().all(|p0| {
            grid.iter().all(|q0| {
                let there = declared(p, *p0) && declared(q, *q0);
                !there || compare(relation, value(*p0, *q0), 0.0)
            })
        });
        // What is only stated is no hypothesis of a claim that is false all the same.
        if key == "given" && !(truth && needed) {
            continue;
        }
        all.push(Relative {
            claim: format!("{left} {relation} 0"),
            key,
            hypotheses: vec![between.text.into()],
            letters: between.letters.to_vec(),
            admits: Box::new(move |v: &[f64]| admits(v[0], v[1])),
            truth,
        });
    }
    judge(&all, 0.8, 0.8);
}

/// An increasing function as it is printed of an argument, and computed.
type Increasing = (&'static str, fn(f64) -> f64);

const INCREASING: [Increasing; 8] = [
    ("e^{#}", f64::exp),
    (r"\ln(#)", f64::ln),
    (r"\sqrt{#}", f64::sqrt),
    (r"\tanh(#)", f64::tanh),
    (r"\sinh(#)", f64::sinh),
    (r"-e^{-(#)}", |t| -(-t).exp()),
    (r"(#)^3 + (#)", |t| t * t * t + t),
    (r"\frac{1}{1 + e^{-(#)}}", |t| 1.0 / (1.0 + (-t).exp())),
];

/// Increasing functions of letters in a supposed range: their ends tell what is true.
#[test]
fn increasing_functions_in_a_supposed_range() {
    let mut random = Random::new(13);
    let mut all: Vec<Relative> = Vec::new();
    while all.len() < 48 {
        let (printed, f) = *random.pick(&INCREASING);
        let positive = printed.contains("ln") || printed.contains("sqrt");
        let (low, size) = (
            random.between(if positive { 0 } else { -2 }, 2),
            random.between(1, 3),
        );
        let high = low + size;
        let letter: &'static str = if positive { "a" } else { "x" };
        let [closed_low, closed_high] = [0; 2].map(|_: i32| random.between(0, 1) == 1);
        let sign = |closed: bool| if closed { r"\le" } else { "<" };
        let hypotheses = match random.between(0, 2) {
            0 => vec![format!(
                "{low} {} {letter} {} {high}",
                sign(closed_low),
                sign(closed_high)
            )],
            _ => vec![
                format!("{low} {} {letter}", sign(closed_low)),
                format!("{letter} {} {high}", sign(closed_high)),
            ],
        };
        // The argument is the letter, moved or stretched.
        let (argument, at): (String, fn(f64) -> f64) = match random.between(0, 3) {
            0 => (format!("{letter} + 1"), |t| t + 1.0),
            1 => (format!("2{letter}"), |t| 2.0 * t),
            _ => (letter.into(), |t| t),
        };
        let [least, most] = [low, high].map(|end| f(at(end as f64)));
        // A half that is near one of the ends or between them.
        let halves = match random.between(0, 3) {
            0 => 2.0 * least,
            1 => 2.0 * most,
            2 => least + most,
            _ => 2.0 * most + 2.0,
        };
        let c = (halves.clamp(-200.0, 200.0)).round() as i64;
        let number = match c % 2 {
            0 => format!("({})", c / 2),
            _ => format!("({c}/2)"),
        };
        let c = c as f64 / 2.0;
        let relation = *random.pick(&ORDERS[..4]);
        // The values are all numbers between the ends, and an end where the letter has it.
        let closed_low = closed_low && !(positive && low == 0);
        let same = |a: f64, b: f64| (a - b).abs() < 1e-9;
        let below = |v: f64, taken: bool, strict: bool| match same(v, c) {
            true => !strict || !taken,
            false => v < c,
        };
        let above = |v: f64, taken: bool, strict: bool| match same(v, c) {
            true => !strict || !taken,
            false => v > c,
        };
        let truth = match relation {
            "<" => below(most, closed_high, true),
            r"\le" => below(most, closed_high, false),
            ">" => above(least, closed_low, true),
            _ => above(least, closed_low, false),
        };
        let (low, high) = (low as f64, high as f64);
        all.push(Relative {
            claim: format!("{} {relation} {number}", printed.replace('#', &argument)),
            key: "assume",
            hypotheses,
            letters: vec![letter],
            admits: Box::new(move |p| low <= p[0] && p[0] <= high),
            truth,
        });
    }
    judge(&all, 0.7, 0.8);
}

fn by_hand(claim: &str, hypothesis: &str, truth: bool) -> Relative {
    Relative {
        claim: claim.into(),
        key: "assume",
        hypotheses: vec![hypothesis.into()],
        letters: vec!["x", "y", "z", "a", "b", "c"],
        // Points are shown with letters of their own; only the verdict is looked at.
        admits: Box::new(|_| true),
        truth,
    }
}

#[test]
fn functions_under_relations() {
    let mut all = Vec::new();
    for (claim, hypothesis, truth) in [
        (r"\sqrt{a - b} > 0", "a > b", true),
        (r"\sqrt{a - b} \ge 0", r"a \ge b", true),
        (r"\sqrt{a - b} > 0", r"a \ge b", false),
        (r"\sqrt a > \sqrt b", "a > b", true),
        (r"\sqrt a < \sqrt b", "a > b", false),
        (r"\ln a > 0", "a > 1", true),
        (r"\ln a < 0", "a > 1", false),
        (r"\ln a < 0", "a < 1", true),
        (r"\ln a < 0", r"a \le 1", false),
        ("e^{x - y} < 1", "x < y", true),
        ("e^{x - y} > 1", "x < y", false),
        ("e^x < e^y", "x < y", true),
        ("e^x > 1", "x > 0", true),
        (r"e^x \ge 1", r"x \ge 0", true),
        ("e^x > 1", r"x \ge 0", false),
        ("e^x < 3", "x < 1", true),
        ("e^x < 2", "x < 1", false),
        (r"\cos x > \frac12", "0 < x < 1", true),
        (r"\cos x > \frac34", "0 < x < 1", false),
        (r"\sin x < x", "x > 0", true),
        (r"\sin x > 0", "x > 0", false),
        (r"|x| < 1", "-1 < x < 1", true),
        (r"|x| < 1", "-2 < x < 1", false),
        (r"|x - y| > 0", r"x \ne y", true),
        (r"\sinh x > x", "x > 0", true),
        (r"\cosh x > 1", r"x \ne 0", true),
        (r"\cosh x > 1", r"x \ge 0", false),
        (r"\tanh x < 0", "x < 0", true),
        (r"\tanh x < -\frac12", "x < 0", false),
        (r"a^b > 1", "a > 1", true),
        (r"a^b > 1", "a < 1", false),
        (r"a + b > 2\sqrt{ab}", "a > b", true),
        (r"a + b > 2\sqrt{ab}", r"a \ge b", false),
        (r"\ln(1 + x) \le x", "x > -1", true),
        (r"\ln(1 + x) < x", "x > 0", true),
        (r"\ln(1 + x) > x", "x > 0", false),
        (r"x\ln x < 0", "0 < x < 1", true),
        (r"x\ln x > 0", "0 < x < 1", false),
    ] {
        all.push(by_hand(claim, hypothesis, truth));
    }
    judge(&all, 0.7, 0.8);
}

#[test]
fn limits_under_hypotheses() {
    let mut all = Vec::new();
    let one_way = |holds: bool| if holds { "" } else { "-" };
    for (p, q, above) in [
        ("x", "x > 0", true),
        ("x", "x < 0", false),
        ("a - 2", "a < 2", false),
        ("a - 2", "a > 2", true),
        ("a - b", "a > b", true),
        ("b - a", "a > b", false),
        ("(a - 3)", "a > 4", true),
        ("x^2 - 1", "-1 < x < 1", false),
        ("x^2 - 1", "x > 1", true),
        ("x^2 - y^2", "0 < x < y", false),
        ("a + x", "x > 0", true),
    ] {
        for (right, printed) in [(true, above), (false, !above)] {
            for shape in ["c({p})", r"\frac{c^2}{ {p} }", r"({p})^3c^2 + c"] {
                let value = shape.replace("{p}", p.trim_matches(['(', ')']));
                let claim = format!(
                    r"c \to \infty, \quad {value} \to {}\infty",
                    one_way(printed)
                );
                all.push(by_hand(&claim, q, right));
            }
            let claim = format!(
                r"c \to 0, \quad \frac{{{p}}}{{c}} \to {}\infty",
                one_way(printed)
            );
            all.push(by_hand(&claim, q, right));
        }
        let claim = format!(r"c \to \infty, \quad \frac{{({p})c}}{{c + 1}} \to {p}");
        all.push(by_hand(&claim, q, true));
        let claim = format!(r"c \to \infty, \quad \frac{{({p})c}}{{c + 1}} \to 0");
        all.push(by_hand(&claim, q, false));
    }
    judge(&all, 0.8, 0.6);
}
