//! Expectations and covariances: what is no polynomial of degree two in the random quantities has no
//! expectation here, and a system without a stationary state has no covariance. The truth comes from
//! the second moments that the document states, and from the eigenvalues of 1x1 and 2x2 systems.

use super::dots::{Draw, Tally, verdicts};
use crate::common::audit;
use rederive::check::Options;
use rederive::document::VerdictWord;

/// Two random quantities with their second moments, and constants.
const MOMENTS: &str = r"```toml symbols
a = { positive = true }
b = { }
v = { positive = true }
w = { positive = true }
c = { }
t = { }
r = { function_of = 't' }
s = { function_of = 't' }
n = { function_of = 't' }
```
```toml notation
'V' = { covariance_of = 'r' }
'W' = { covariance_of = 's' }
'C' = { covariance_of = ['r', 's'] }
'e' = { constant = 'e' }
```
```math 1 define
V = v, \quad W = w, \quad C = c
```
";

/// Audits claims about these moments: each is decided, and rightly.
fn all_are_decided(claims: &[String], truths: &[bool]) {
    let mut tally = Tally::default();
    for ((claim, truth), word) in claims.iter().zip(truths).zip(verdicts(MOMENTS, claims)) {
        tally.count(claim, *truth, word);
    }
    assert!(tally.wrong.is_empty(), "{:#?}", tally.wrong);
    assert_eq!(tally.open, 0);
}

#[test]
fn second_moments_are_decided() {
    let mut draw = Draw::new(5);
    let (mut claims, mut truths) = (Vec::new(), Vec::new());
    let letters = ["", "a", "b", "ab"];
    for _ in 0..100 {
        let k = |draw: &mut Draw| 1 + draw.below(4) as i64;
        let (rr, rs, ss) = (k(&mut draw), k(&mut draw), k(&mut draw));
        let (r, s, one) = (k(&mut draw), k(&mut draw), k(&mut draw));
        let l = |draw: &mut Draw| letters[draw.below(4)];
        let (f, g) = (l(&mut draw), l(&mut draw));
        let body = format!("{rr}{f}r^2 + {rs}{g}rs + {ss}s^2 + {r}{g}r - {s}s + {one}");
        let mut moments = [rr, rs, ss, one];
        let truth = draw.coin();
        if !truth {
            moments[draw.below(4)] += 1;
        }
        let [rr, rs, ss, one] = moments;
        claims.push(format!(
            r"E\{{{body}\}} = {rr}{f}v + {rs}{g}c + {ss}w + {one}"
        ));
        truths.push(truth);
    }
    all_are_decided(&claims, &truths);
}

/// An expectation inside of another is a constant there, whatever letters it has.
#[test]
fn nested_expectations_are_constants() {
    let mut draw = Draw::new(9);
    let (mut claims, mut truths) = (Vec::new(), Vec::new());
    // An inner expectation and its value.
    let inner = [
        (r"E\{r\}", "0"),
        (r"E\{s^2\}", "w"),
        (r"E\{rs\}", "c"),
        (r"E\{r^2 + 1\}", "(v + 1)"),
        (r"E\{ar + b\}", "b"),
        (r"E\{(r - E\{r\})^2\}", "v"),
    ];
    for _ in 0..200 {
        let (constant, value) = inner[draw.below(inner.len())];
        let k = 1 + draw.below(4);
        let (body, right) = match draw.below(5) {
            0 => (
                format!("({k}r - {constant})^2"),
                format!("{}v + {value}^2", k * k),
            ),
            1 => (format!("{k}r{constant}"), "0".into()),
            2 => (format!("{k}s^2 {constant}"), format!(r"{k}w \cdot {value}")),
            3 => (format!("{k}r + {constant}"), value.into()),
            _ => (
                format!("(r + {constant})(s - {k})"),
                format!(r"c - {k} \cdot {value}"),
            ),
        };
        let truth = draw.coin();
        let off = if truth { "" } else { " + 1" };
        claims.push(format!(r"E\{{{body}\}} = {right}{off}"));
        truths.push(truth);
    }
    all_are_decided(&claims, &truths);
}

/// A hypothesis about what is random itself changes its moments in a way that is not written.
#[test]
fn hypotheses_on_what_is_random_leave_moments_open() {
    let hypotheses = ["r = 0", "r = s", "r = 3", "rs = 1", "r^2 = v", "n = r"];
    let claims = [
        "E\\{r^2\\} = v",
        "E\\{r^2\\} = w",
        "E\\{r\\} = 3",
        "E\\{r\\} = 0",
        "E\\{s^2\\} = w",
    ];
    let mut text = MOMENTS.to_string();
    let mut labels = Vec::new();
    for (h, hypothesis) in hypotheses.iter().enumerate() {
        for (c, claim) in claims.iter().enumerate() {
            for key in ["assume", "given"] {
                let label = format!("{key}{h}x{c}");
                text += &format!("\n```math {label} claim\n{claim}\n```\n");
                text += &format!("\n```toml {label}\n{key} = ['{hypothesis}']\n```\n");
                labels.push(label);
            }
        }
    }
    let audit = audit(&text, Options::default()).unwrap_or_else(|r| panic!("{r}"));
    for label in labels {
        let equation = audit.model.equation(&label).expect("a claim");
        let outcome = audit.outcomes_of(equation).next().expect("a link");
        let word = outcome.verdict.word();
        // What holds without the hypothesis holds with it.
        let sound = matches!(word, VerdictWord::Undecided | VerdictWord::Holds);
        assert!(sound, "{label}: {word}");
    }
}

/// What stands under the expectation is no polynomial of degree two: true or false, nothing stated
/// says so.
#[test]
fn what_moments_do_not_give_is_undecided() {
    let functions = [
        r"\cos X",
        r"\sin X",
        "e^{X}",
        r"\exp(X)",
        r"\sqrt{1 + X^2}",
        "|X|",
        r"\ln(1 + X^2)",
        r"\frac{1}{1 + X^2}",
        r"\frac{a}{b + X}",
        r"\cosh X",
        "X^3",
        "X^4",
        "a^{X}",
        r"\cos(aX + b)",
        r"\sin(\cos X)",
        r"\sqrt{X^4 + 1}",
    ];
    let arguments = ["r", "s", "r + s", "ar", "(r - s)", "rs"];
    let factors = ["", r"r \cdot ", r"s \cdot ", r"a r \cdot "];
    let mut draw = Draw::new(6);
    let mut claims = Vec::new();
    for _ in 0..260 {
        let function = functions[draw.below(functions.len())];
        let argument = arguments[draw.below(6)];
        let bracketed = match argument.len() > 1 && !argument.starts_with('(') {
            true if function.contains("X^") || function.ends_with(" X") => format!("({argument})"),
            // An exponent in brackets is another thing.
            _ if function.ends_with("^{X}") => argument.trim_matches(['(', ')']).to_string(),
            _ => argument.to_string(),
        };
        let body = format!(
            "{}{}",
            factors[draw.below(4)],
            function.replace('X', &bracketed)
        );
        let right = match draw.below(6) {
            0 => body.clone(),
            1 => "0".into(),
            2 => "1".into(),
            3 => "v".into(),
            4 => r"\cos 0 + c".into(),
            _ => "c - v".into(),
        };
        claims.push(format!(r"E\{{{body}\}} = {right}"));
    }
    // What no covariance names is not constant either.
    for body in ["n", "n^2", r"\cos n", "rn", "e^{n}r"] {
        claims.push(format!(r"E\{{{body}\}} = {body}"));
        claims.push(format!(r"E\{{{body}\}} = 0"));
    }
    let wrong: Vec<String> = claims
        .iter()
        .zip(verdicts(MOMENTS, &claims))
        .filter(|(_, word)| *word != VerdictWord::Undecided)
        .map(|(claim, word)| format!("{claim}: {word}"))
        .collect();
    assert!(
        wrong.is_empty(),
        "{} of {}: {wrong:#?}",
        wrong.len(),
        claims.len()
    );
}

/// `3/4`, or `-3/4`.
fn number(n: i64, d: i64) -> String {
    match d {
        1 => n.to_string(),
        _ => format!(
            r"{}\frac{{{}}}{{{d}}}",
            if n < 0 { "-" } else { "" },
            n.abs()
        ),
    }
}

/// Whether the claims about a covariance hold, where they may: `holds` for a system without a
/// stationary state is wrong, and so is a refutation of a true claim for one that has it.
fn check(text: &str, claims: &[(String, bool, bool)], tally: &mut Tally) {
    let texts: Vec<String> = claims.iter().map(|(c, ..)| c.clone()).collect();
    for ((claim, stable, truth), word) in claims.iter().zip(verdicts(text, &texts)) {
        match (stable, word) {
            (true, word) => tally.count(claim, *truth, word),
            (false, VerdictWord::Undecided | VerdictWord::Refuted | VerdictWord::Misprint) => {
                tally.right += 1;
            }
            (false, word) => tally
                .wrong
                .push(format!("{claim} of no stationary state: {word}")),
        }
    }
}

/// The letters that name the systems of one document.
const SYSTEMS: [&str; 8] = ["A", "B", "C", "D", "F", "G", "H", "K"];

fn scalar_preamble() -> String {
    let mut text = "```toml symbols\nq = { positive = true }\nt = { }\nd = { positive = true }\nm = { positive = true }\n".to_string();
    for k in SYSTEMS {
        text += &format!("'r_{{\\mathrm{{{k}}}}}' = {{ function_of = 't' }}\n");
    }
    text += "```\n```toml notation\n";
    for k in SYSTEMS {
        text +=
            &format!("'p_{{\\mathrm{{{k}}}}}' = {{ covariance_of = 'r_{{\\mathrm{{{k}}}}}' }}\n");
    }
    text + "```\n"
}

#[test]
fn a_scalar_without_a_stationary_state_has_no_variance() {
    let mut tally = Tally::default();
    for seed in 20..28 {
        let mut draw = Draw::new(seed);
        let mut text = scalar_preamble();
        let mut claims = Vec::new();
        for k in SYSTEMS {
            let p = format!("p_{{\\mathrm{{{k}}}}}");
            let discrete = draw.coin();
            let (n, d) = (draw.below(9) as i64 - 4, 1 + draw.below(4) as i64);
            let damper = ["", "d", r"\frac{d}{m}"][draw.below(3)];
            // 2ap + q = 0, or p = (n/d)^2 p + q.
            let (equation, stable, value) = if discrete {
                let phi = number(n, d);
                if n * n == d * d {
                    continue;
                }
                let forms = [
                    format!(r"{p} = ({phi}) {p} ({phi}) + q"),
                    format!(r"{p} - ({phi})^2 {p} = q"),
                    format!(r"({phi})^2 {p} + q - {p} = 0"),
                ];
                let value = format!(r"\frac{{q}}{{1 - ({phi})^2}}");
                (forms[draw.below(3)].clone(), n.abs() < d, value)
            } else {
                if n == 0 {
                    continue;
                }
                let a = format!("({}) {damper}", number(n, d));
                let forms = [
                    format!("2 {a} {p} + q = 0"),
                    format!("{a} {p} + {p} {a} = -q"),
                    format!("0 = -(2 {a} {p}) - q"),
                ];
                (
                    forms[draw.below(3)].clone(),
                    n < 0,
                    format!(r"(-\frac{{q}}{{2 {a}}})"),
                )
            };
            text += &format!("```math solve{k} solve {p}\n{equation}\n```\n");
            let r = format!("r_{{\\mathrm{{{k}}}}}");
            claims.push((format!("{p} = {value}"), stable, true));
            claims.push((format!("E\\{{{r}^2\\}} = {value}"), stable, true));
            claims.push((format!("E\\{{({r} + 1)^2\\}} = {value} + 1"), stable, true));
            claims.push((format!("{p} = 2 {value}"), stable, false));
            claims.push((format!("{p} - {value} = 0"), stable, true));
        }
        check(&text, &claims, &mut tally);
    }
    assert!(
        tally.wrong.is_empty(),
        "{} of {}: {:#?}",
        tally.wrong.len(),
        tally.all(),
        tally.wrong
    );
    assert!(
        tally.all() >= 200 && 2 * tally.right >= tally.all(),
        "{tally:?}"
    );
}

#[test]
fn a_matrix_without_a_stationary_state_has_no_covariance() {
    let mut tally = Tally::default();
    for seed in 40..50 {
        let mut draw = Draw::new(seed);
        let mut text = "```toml symbols\nq = { positive = true }\nt = { }\n".to_string();
        for k in SYSTEMS {
            for i in ["r", "s"] {
                text += &format!("'{i}_{{\\mathrm{{{k}}}}}' = {{ function_of = 't' }}\n");
            }
        }
        text += "```\n```toml notation\n'\\mathbf{0}' = { zero = true }\n";
        for k in SYSTEMS {
            let vector = format!(
                "\\begin{{bmatrix}} r_{{\\mathrm{{{k}}}}} \\\\ s_{{\\mathrm{{{k}}}}} \\end{{bmatrix}}"
            );
            text += &format!(
                "'\\mathbf{{P}}_{{\\mathrm{{{k}}}}}' = {{ covariance_of = '{vector}' }}\n"
            );
        }
        text += "```\n";
        let mut claims = Vec::new();
        for k in SYSTEMS {
            let discrete = draw.coin();
            let d = if discrete { 4 } else { 1 };
            let entry = |draw: &mut Draw| draw.below(9) as i64 - 4;
            let [a, b, c, e] = [0; 4].map(|_| entry(&mut draw));
            let (trace, det) = (a + e, a * e - b * c);
            // The eigenvalues of [a b; c e] / d, and whether the equation has one solution.
            let (stable, unique) = if discrete {
                let (one, t) = (d * d, trace.abs() * d);
                (t < one + det && det < one, {
                    // No product of two eigenvalues is one: 1 - det, (1 + det)^2 - trace^2.
                    det != one && (one + det) * (one + det) != t * t
                })
            } else {
                (trace < 0 && det > 0, trace != 0 && det != 0)
            };
            if !unique {
                continue;
            }
            let matrix = |name: &str| format!("\\mathbf{{{name}}}_{{\\mathrm{{{k}}}}}");
            let (system, p) = (matrix("A"), matrix("P"));
            let [a, b, c, e] = [a, b, c, e].map(|n| number(n, d));
            text += &format!(
                "```math A{k} define\n{system} = \\begin{{bmatrix}} {a} & {b} \\\\ {c} & {e} \\end{{bmatrix}}\n```\n"
            );
            let noise = "\\begin{bmatrix} 2q & q \\\\ q & q \\end{bmatrix}";
            let (left, right) = if discrete {
                (format!("{system} {p} {system}^T + {noise}"), p.clone())
            } else {
                (
                    format!("{system} {p} + {p} {system}^T + {noise}"),
                    "\\mathbf{0}".to_string(),
                )
            };
            let forms = [format!("{left} = {right}"), format!("{right} = {left}")];
            text += &format!("```math P{k} solve {p}\n{}\n```\n", forms[draw.below(2)]);
            claims.push((format!("{left} = {right}"), stable, true));
            claims.push((
                format!("{} = {right}", left.replace("2q", "3q")),
                stable,
                false,
            ));
            claims.push((format!("{p} = {p}^T"), stable, true));
        }
        check(&text, &claims, &mut tally);
    }
    assert!(
        tally.wrong.is_empty(),
        "{} of {}: {:#?}",
        tally.wrong.len(),
        tally.all(),
        tally.wrong
    );
    assert!(
        tally.all() >= 150 && 4 * tally.right >= tally.all(),
        "{tally:?}"
    );
}

/// Where some combination of random quantities has the variance zero it is zero almost surely, and no point of
/// them shows that it is not; where none has, points do.
#[test]
fn what_has_no_variance_is_zero_almost_surely() {
    let mut draw = Draw::new(77);
    let mut claims = Vec::new();
    let mut text = String::new();
    let mut symbols = "g = { positive = true }\nh = { positive = true }\nt = { }\n".to_string();
    let mut notation = String::new();
    for k in 0..24 {
        let [r, s, v] = ["r", "s", "V"].map(|l| format!("{l}_{{{k}}}"));
        symbols += &format!("'{r}' = {{ function_of = 't' }}\n'{s}' = {{ function_of = 't' }}\n");
        let [m, n] = [0; 2].map(|_| 1 + draw.below(4) as i64);
        // The variances and covariance of m g and n g times one quantity, or of two.
        let (vr, c, vs, singular) = match k % 6 {
            0 => (
                format!("{}g", m * m),
                format!("{}g", m * n),
                format!("{}g", n * n),
                true,
            ),
            1 => (
                format!("{}gh^2", m * m),
                format!("{}gh^2", m * n),
                format!("{}gh^2", n * n),
                true,
            ),
            2 => (
                format!("{}", m * m),
                format!("{}", m * n),
                format!("{}", n * n),
                true,
            ),
            3 => (
                format!("{}g", m * m),
                "0".into(),
                format!("{}h", n * n),
                false,
            ),
            4 => (
                format!("{}g", m * m + 1),
                format!("{}g", m * n),
                format!("{}g", n * n),
                false,
            ),
            _ => (
                format!("{}", m * m),
                format!("{}", m * n),
                format!("{}+g", n * n),
                false,
            ),
        };
        if k % 2 == 0 {
            notation += &format!(
                "'\\mathbf{{V}}_{{{k}}}' = {{ covariance_of = '\\begin{{bmatrix}} {r} \\\\ {s} \\end{{bmatrix}}' }}\n"
            );
            text += &format!(
                "```math d{k} define\n\\mathbf{{V}}_{{{k}}} = \\begin{{bmatrix}} {vr} & {c} \\\\ {c} & {vs} \\end{{bmatrix}}\n```\n"
            );
        } else {
            for (name, of) in [
                (v.clone(), format!("'{r}'")),
                (format!("W_{{{k}}}"), format!("'{s}'")),
                (format!("C_{{{k}}}"), format!("['{r}', '{s}']")),
            ] {
                notation += &format!("'{name}' = {{ covariance_of = {of} }}\n");
            }
            text += &format!(
                "```math d{k} define\n{v} = {vr}, \\quad W_{{{k}}} = {vs}, \\quad C_{{{k}}} = {c}\n```\n"
            );
        }
        let own = [
            format!("{n}{r} = {m}{s}"),
            format!("{r} = \\frac{{{m}}}{{{n}}}{s}"),
            format!("{n}\\dot {r} = {m}\\dot {s}"),
            format!("{}{r}^2 = {}{s}^2", n * n, m * m),
            format!("({n}{r} - {m}{s})g = 0"),
        ];
        claims.extend(own.into_iter().map(|claim| (claim, singular)));
        claims.push((format!("E\\{{({n}{r} - {m}{s})^2\\}} = 0"), singular));
    }
    let preamble =
        format!("```toml symbols\n{symbols}```\n```toml notation\n{notation}```\n{text}");
    let all: Vec<String> = claims.iter().map(|(claim, _)| claim.clone()).collect();
    let mut tally = Tally::default();
    for ((claim, truth), word) in claims.iter().zip(verdicts(&preamble, &all)) {
        tally.count(claim, *truth, word);
    }
    assert!(tally.wrong.is_empty(), "{:#?}", tally.wrong);
    assert!(2 * tally.right >= tally.all(), "{tally:?}");
}
