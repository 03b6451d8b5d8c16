//! What is said of a place at which there is nothing: the ends of a range, bounds and reference values
//! at which a quantity has no value, hypotheses that hold nowhere, covariances of systems without a
//! stationary state, the Dirac distribution away from zero, cases that are taken otherwise, points of
//! a figure. The truth is plain by construction or comes from exact fractions.

use super::signs::Random;
use super::statements::{Letter, Poly, q};
use super::unwritten::{Claim, Truth, undecided};
use crate::common::audit;
use Truth::{False, Open, True};
use rederive::check::Options;
use rederive::document::VerdictWord;
use rederive::figure::Content;

/// Statements with their truth, under a preamble.
struct Statements {
    preamble: &'static str,
    all: Vec<(String, Truth)>,
}

impl Statements {
    fn new(preamble: &'static str) -> Self {
        Statements {
            preamble,
            all: Vec::new(),
        }
    }

    fn say(&mut self, of: &str, predicate: &str, more: &str, truth: Truth) {
        let settings = format!("of = ['{of}']\npredicate = \"{predicate}\"\n{more}\n");
        self.all.push((settings, truth));
    }

    /// None may have the wrong definite verdict; what is returned are those with a truth that are open.
    fn undecided(&self) -> Vec<String> {
        let mut text = self.preamble.to_string();
        for (k, (settings, _)) in self.all.iter().enumerate() {
            text += &format!("\n```statement S{k}\nWords.\n```\n```toml S{k}\n{settings}```\n");
        }
        let options = Options {
            repair: false,
            ..Options::default()
        };
        let audit = audit(&text, options).unwrap_or_else(|r| panic!("{r}"));
        let (mut wrong, mut open) = (Vec::new(), Vec::new());
        for outcome in &audit.statements {
            let (settings, truth) = &self.all[outcome.statement];
            let holds = outcome.word == VerdictWord::Holds;
            let false_ = matches!(outcome.word, VerdictWord::Refuted | VerdictWord::Loose);
            let sound = match truth {
                True => !false_,
                False => !holds,
                Open => !holds && !false_,
            };
            let line = format!(
                "{settings}is {truth:?}: {}, {:?}",
                outcome.word, outcome.facts
            );
            if !sound {
                wrong.push(line);
            } else if *truth != Open && !holds && !false_ {
                open.push(format!("{line} {:?}", outcome.reason));
            }
        }
        let (count, of) = (wrong.len(), self.all.len());
        assert!(wrong.is_empty(), "{count} of {of}:\n{}", wrong.join("\n"));
        println!("{of} statements, {} open", open.len());
        open
    }
}

const ENDS: &str = r#"```toml symbols
a = { positive = true, value = "1/2" }
b = { positive = true, value = "3" }
y = { value = "1" }
u = { range = '0 < u \le 2', value = "1" }
v = { range = '0 \le v \le 3', value = "1" }
w = { range = '0 \le w \le 1', value = "1/2" }
z = { range = '-1 \le z < 2', value = "0" }
x = { range = '1 \le x', value = "2" }
```
"#;

/// The same letters, with their ends in halves.
const LETTERS: [Letter; 5] = [
    Letter {
        name: "u",
        value: 1,
        low: Some((0, false)),
        high: Some((4, true)),
    },
    Letter {
        name: "v",
        value: 1,
        low: Some((0, true)),
        high: Some((6, true)),
    },
    Letter {
        name: "w",
        value: 1,
        low: Some((0, true)),
        high: Some((2, true)),
    },
    Letter {
        name: "z",
        value: 0,
        low: Some((-2, true)),
        high: Some((4, false)),
    },
    Letter {
        name: "x",
        value: 2,
        low: Some((2, true)),
        high: None,
    },
];

/// A polynomial is least at an end of the range, where its derivative need not vanish, or at the
/// other kind of extremum: alone and with other letters beside it.
#[test]
fn the_extremum_is_the_place_that_is_named() {
    let mut draw = Random::new(71);
    let mut family = Statements::new(ENDS);
    for k in 0..90 {
        let letter = LETTERS[k % LETTERS.len()];
        // One stationary point inside, or two, one of them perhaps outside.
        let count = 1 + k % 2;
        let roots: Vec<i128> = (0..count)
            .map(|_| i128::from(draw.between(-1, 5)))
            .collect();
        let sign = [1, -1, 2, -3][k % 4];
        let f = Poly::with_slope(sign, &roots, draw.between(-2, 2).into());
        let text = f.text(letter.name);
        let forms = [
            text.clone(),
            format!(r"a\left({text}\right)"),
            format!(r"{text} + y^2"),
            format!(r"\frac{{ab}}{{b + 1}}\left({text}\right) - b"),
        ];
        let mut places: Vec<i128> = roots.clone();
        places.extend(letter.low.filter(|e| e.1).map(|e| e.0));
        places.extend(letter.high.filter(|e| e.1).map(|e| e.0));
        for (predicate, sign) in [("minimal at", 1), ("maximal at", -1)] {
            let best = letter.least(&f, sign).map(|(place, _)| place);
            let place = places[draw.between(0, places.len() as i64 - 1) as usize];
            let at = q(place, 2);
            let inside =
                letter.low.is_none_or(|e| place >= e.0) && letter.high.is_none_or(|e| place <= e.0);
            let truth = match (inside, best == Some(at)) {
                (_, true) => True,
                (true, false) => False,
                (false, false) => continue,
            };
            let more = format!(
                "in = \"{}\"\nat = '\\left({}\\right)\\frac{{1}}{{{}}}'",
                letter.name, at.0, at.1
            );
            family.say(&forms[k / 5 % 4], predicate, &more, truth);
            family.say(&forms[0], predicate, &more, truth);
        }
    }
    for (of, letter, minimal, maximal) in [
        ("aw", "w", "0", "1"),
        ("a + w", "w", "0", "1"),
        ("-aw", "w", "1", "0"),
        (r"\frac{a}{w + 1}", "w", "1", "0"),
        (r"\frac{w}{w + a}", "w", "0", "1"),
        (r"aw + bw^2", "w", "0", "1"),
        (r"(a + w)^3", "w", "0", "1"),
        ("w(a + y^2)", "w", "0", "1"),
        (r"\frac{a}{u}", "u", "2", ""),
        ("au", "u", "", "2"),
        (r"\frac{ab}{b+1}w-aw^2", "w", "1", ""),
        ("bx - a", "x", "1", ""),
        (r"\frac{a}{x}", "x", "", "1"),
        ("w^3 - w", "w", r"\\frac{1}{\\sqrt 3}", ""),
    ] {
        if minimal.contains("sqrt") {
            continue;
        }
        for (predicate, at) in [("minimal at", minimal), ("maximal at", maximal)] {
            if at.is_empty() {
                continue;
            }
            let other = ["0", "1", "2"].into_iter().find(|o| *o != at);
            let other = if letter == "u" || letter == "x" {
                if at == "1" { "2" } else { "1" }
            } else {
                other.filter(|o| *o != "2").unwrap_or("1")
            };
            family.say(
                of,
                predicate,
                &format!("in = \"{letter}\"\nat = '{at}'"),
                True,
            );
            family.say(
                of,
                predicate,
                &format!("in = \"{letter}\"\nat = '{other}'"),
                False,
            );
        }
    }
    // So at the reference values of the others only.
    for (of, letter, at, truth) in [
        ("(b - 1)w", "w", "0", False),
        ("(1 - a)w", "w", "0", False),
        ("yw", "w", "0", False),
        ("aw - w", "w", "1", False),
        ("bw - w^2", "w", "0", False),
        (r"(w - a)^2", "w", r"\\frac{1}{2}", False),
        (r"(w - a)^2", "w", "a", Open),
        (r"(v - a)^2", "v", "a", Open),
        (r"(x - b)^2", "x", "3", False),
        ("(y^2 + 1)w", "w", "0", True),
        ("y^2w + w", "w", "0", True),
    ] {
        let at = at.replace("\\\\", "\\");
        let more = format!("in = \"{letter}\"\nat = '{at}'");
        family.say(of, "minimal at", &more, truth);
        family.say(&format!(r"-\left({of}\right)"), "maximal at", &more, truth);
    }
    assert!(family.all.len() >= 200);
    let open = family.undecided();
    assert!(10 * open.len() <= family.all.len(), "{open:#?}");
}

const POLES: &str = r#"```toml symbols
x = { value = "2" }
y = { value = "3" }
a = { positive = true, value = "1/2" }
b = { positive = true, value = "1" }
m = { }
```
```math 1 define
g = \frac{1}{x - 2}
```
```math 2 define
h = \frac{a}{1 - 2a}
```
```math 3 define
k = \frac{y - 3}{y^2 - 9}
```
```math 4 define
f = \frac{b - 1}{(x - 2)(b - 1)}
```
"#;

/// At the bound, or at the reference values, there is no value: nothing is said of it.
#[test]
fn nothing_is_true_where_there_is_no_value() {
    let mut family = Statements::new(POLES);
    let poles = [
        ("g", "x"),
        ("h", "a"),
        ("k", "y"),
        ("f", "b"),
        (r"\frac{1}{x - 2}", "x"),
        (r"\frac{x}{2 - x}", "x"),
        (r"\frac{2}{1 - 2a}", "a"),
        (r"\frac{b^2}{b - 1}", "b"),
        (r"\frac{1}{xa - 1}", "x"),
        (r"\frac{y}{(x - 2)^2}", "x"),
    ];
    for n in 1..=5 {
        for (of, letter) in poles {
            let of = format!("{n}{of}");
            let on = format!("in = \"{letter}\"");
            for of in [of.clone(), format!("-{of}")] {
                family.say(&of, "least at the lower bound of", &on, Open);
            }
            family.say(&of, "equals", &format!("to = '{of}'"), Open);
            family.say(&of, "close to", &format!("to = '{of}'"), Open);
            let small = format!("to = '1000{of}'");
            family.say(&of, "small compared with", &small, Open);
            let near = format!("to = '\\left(1 + \\frac{{1}}{{1000}}\\right){of}'");
            family.say(&of, "close to", &near, Open);
            family.say(&of, "depends essentially on", &on, Open);
        }
        for (of, letter) in [("(x - 2)", "x"), ("(1 - 2a)", "a"), ("(y - 3)b", "y")] {
            let of = format!("{n}{of}");
            let on = format!("in = \"{letter}\"");
            family.say(&of, "depends essentially on", &on, Open);
            family.say(&of, "small compared with", &format!("to = '{of}'"), Open);
        }
        // There is a value.
        for (of, letter) in [
            (r"-\frac{1}{x}", "x"),
            (r"\frac{x}{x + 1}", "x"),
            (r"x^2", "x"),
            (r"-\frac{1}{2a + 1}", "a"),
            (r"\frac{b}{b + 1}", "b"),
            (r"(y - 1)^2", "y"),
        ] {
            let of = format!("{n}\\left({of}\\right)");
            let on = format!("in = \"{letter}\"");
            family.say(&of, "least at the lower bound of", &on, True);
            let minus = format!("-{of}");
            family.say(&minus, "least at the lower bound of", &on, False);
            family.say(
                &of,
                "equals",
                &format!("to = '{of} + {letter} - {letter}'"),
                True,
            );
            family.say(&of, "close to", &format!("to = '{of}'"), True);
            family.say(
                &of,
                "small compared with",
                &format!("to = '1000{of}'"),
                True,
            );
            family.say(&of, "small compared with", &format!("to = '{of}'"), False);
            // A letter without a value may cancel.
            family.say(
                &format!(r"m\left({of}\right)"),
                "close to",
                &format!(r"to = 'm\left({of}\right)'"),
                True,
            );
            family.say(&of, "depends essentially on", &on, True);
        }
    }
    assert!(family.all.len() >= 200);
    let open = family.undecided();
    assert!(10 * open.len() <= family.all.len(), "{open:#?}");
}

#[test]
fn why_there_is_no_elasticity_is_said() {
    let text = format!(
        "{POLES}\n```statement S\nWords.\n```\n```toml S\nof = ['g', 'x - 2']\n\
         predicate = \"depends essentially on\"\nin = 'x'\n```\n"
    );
    let audit = audit(&text, Options::default()).unwrap_or_else(|r| panic!("{r}"));
    assert_eq!(audit.statements.len(), 2);
    for outcome in &audit.statements {
        assert_eq!(outcome.word, VerdictWord::Undecided);
        let reason = outcome.reason.as_deref().unwrap_or_default();
        assert!(reason.contains("no value at the reference"), "{reason}");
    }
}

const STEPS: &str = r"```toml symbols
x = { }
y = { }
a = { positive = true }
b = { positive = true }
'\xi' = { }
```
```toml notation
'\pi' = { constant = 'pi' }
```
```math 1 define
h(\xi) = \begin{cases} 1 & \xi \ge 0 \\ 0 & \xi < 0 \end{cases}
```
```math 2 define
g(\xi) = \begin{cases} \xi & \xi \ge 0 \\ 0 & \xi < 0 \end{cases}
```
";

/// What is given holds nowhere: nothing is shown of anything by it. What is given and true is none.
#[test]
fn a_given_that_holds_nowhere_shows_nothing() {
    let mut claims = Vec::new();
    let never = [
        "1 = 2",
        "1 < 0",
        "0 > 0",
        "b - b > 0",
        "a - a = 1",
        "h(a) = 0",
        "h(-a) = 1",
        "g(-a) > 0",
        "g(-a) = b - b + 1",
        "h(a) + h(b) = 1",
        r"1 \ne 1",
        r"2 \le 1",
        r"\pi = 3",
        r"\pi < 3",
        r"a - a \ne 0",
        "3 = 4 - 2",
    ];
    let always = [
        "1 = 1",
        "0 < 1",
        "h(a) = 1",
        "g(-a) = 0",
        "a - a = 0",
        r"1 \ne 2",
    ];
    for n in 2..=5 {
        for key in ["given", "assume"] {
            for hypothesis in never {
                for claim in [format!("y = {n}y"), format!("a > {n}b")] {
                    claims.push(Claim::under(claim, key, &[hypothesis.into()], Open));
                }
            }
            for hypothesis in always {
                claims.push(Claim::under(
                    format!("y = {n}y"),
                    key,
                    &[hypothesis.into()],
                    False,
                ));
                let claim = format!("{n}y = {n}y + a - a");
                claims.push(Claim::under(claim, key, &[hypothesis.into()], True));
            }
        }
    }
    assert!(claims.len() >= 200);
    let open = undecided(STEPS, &claims);
    assert!(2 * open.len() <= 6 * 16, "{open:#?}");
}

const COVARIANCES: &str = r"```toml symbols
q = { positive = true }
b = { positive = true }
x = { }
y = { }
r = { function_of = 't' }
s = { function_of = 't' }
n = { function_of = 't' }
o = { function_of = 't' }
u = { function_of = 't' }
v = { function_of = 't' }
t = { }
```
```toml notation
'\mathbf{V}' = { covariance_of = '\mathbf{r}' }
'V_{i,j}' = { entry_of = '\mathbf{V}' }
'\mathbf{W}' = { covariance_of = '\mathbf{s}' }
'W_{i,j}' = { entry_of = '\mathbf{W}' }
'\mathbf{P}' = { covariance_of = '\mathbf{n}' }
'P_{i,j}' = { entry_of = '\mathbf{P}' }
'\mathbf{D}' = { covariance_of = '\mathbf{u}' }
'D_{i,j}' = { entry_of = '\mathbf{D}' }
'\mathbf{0}' = { zero = true }
```
```math 1 define
\mathbf{r} = \begin{bmatrix} r \end{bmatrix}, \quad \mathbf{A} = \begin{bmatrix} x \end{bmatrix}, \quad \mathbf{Q} = \begin{bmatrix} q \end{bmatrix}
```
```math 2 solve \mathbf{V}
\mathbf{A}\mathbf{V} + \mathbf{V}\mathbf{A}^T + \mathbf{Q} = \mathbf{0}
```
```math 3 define
\mathbf{s} = \begin{bmatrix} s \\ o \end{bmatrix}, \quad \mathbf{B} = \begin{bmatrix} 0 & 1 \\ -b & -y \end{bmatrix}, \quad \mathbf{K} = \begin{bmatrix} 0 & 0 \\ 0 & q \end{bmatrix}
```
```math 4 solve \mathbf{W}
\mathbf{B}\mathbf{W} + \mathbf{W}\mathbf{B}^T + \mathbf{K} = \mathbf{0}
```
```math 5 define
\mathbf{n} = \begin{bmatrix} n \end{bmatrix}, \quad \mathbf{F} = \begin{bmatrix} x \end{bmatrix}
```
```math 6 solve \mathbf{P}
\mathbf{P} = \mathbf{F}\mathbf{P}\mathbf{F}^T + \mathbf{Q}
```
```math 7 define
\mathbf{u} = \begin{bmatrix} u \\ v \end{bmatrix}, \quad \mathbf{C} = \begin{bmatrix} -b & 0 \\ 0 & -1 \end{bmatrix}, \quad \mathbf{L} = \begin{bmatrix} y & 0 \\ 0 & q \end{bmatrix}
```
```math 8 solve \mathbf{D}
\mathbf{C}\mathbf{D} + \mathbf{D}\mathbf{C}^T + \mathbf{L} = \mathbf{0}
```
";

/// Entries of a covariance are meant where the system has a stationary state, however they are written.
#[test]
fn covariances_are_those_of_stationary_states() {
    let mut claims = Vec::new();
    // What is positive wherever it exists, and an admitted point at which it is more than one.
    let variances = [
        ("V_{11}", "n"),
        (r"E\{r^2\}", "n"),
        ("W_{11}", "n"),
        ("W_{22}", "n"),
        (r"E\{s^2\}", "n"),
        (r"E\{o^2\}", "n"),
        ("W_{11} + W_{22}", "n"),
        ("P_{11}", "n"),
        (r"E\{n^2\}", "n"),
        ("D_{22}", "n"),
        (r"\det\mathbf{W}", "n"),
        (r"bW_{11}", "n"),
    ];
    for n in 1..=4 {
        for (variance, _) in variances {
            let many = format!("{n}({variance})");
            for (claim, truth) in [
                (format!("{many} > 0"), True),
                (format!(r"{many} \ge 0"), True),
                (format!(r"{many} \ne 0"), True),
                (format!("{many} = |{many}|"), True),
                (format!("{many} + {n} > {n}"), True),
                (format!("{many} < 0"), False),
                (format!("{many} = -|{many}|"), False),
                (format!("{many} > 5q"), False),
                (format!("{many} = 0"), False),
            ] {
                claims.push(Claim::plain(claim, truth));
            }
        }
        for (claim, truth) in [
            (format!(r"P_{{11}} \ge {n}q - {}q", n - 1), True),
            (format!(r"{n}D_{{11}} \ge 0"), True),
            (format!(r"{n}E\{{u^2\}} \ge 0"), True),
            (format!(r"{n}D_{{11}}D_{{22}} \ge 0"), True),
            (format!(r"{n}D_{{11}} = {n}|D_{{11}}|"), True),
            (format!(r"{n}D_{{11}} < 0"), False),
            (format!(r"{n}\mathbf{{W}} > \mathbf{{0}}"), True),
            (format!(r"{n}V_{{11}} = -\frac{{{n}q}}{{2x}}"), True),
            (format!(r"{n}V_{{11}} = \frac{{{n}q}}{{2x}}"), False),
            (format!(r"{n}W_{{22}} = {n}bW_{{11}}"), True),
            (format!(r"{n}W_{{22}} = {n}yW_{{11}}"), False),
            (
                format!(
                    r"{n}\frac{{1}}{{x}} = -{n}\left|\frac{{1}}{{x}}\right| + V_{{11}} - V_{{11}}"
                ),
                True,
            ),
        ] {
            claims.push(Claim::plain(claim, truth));
        }
    }
    assert!(claims.len() >= 200);
    let open = undecided(COVARIANCES, &claims);
    println!("{} claims, {} open", claims.len(), open.len());
    assert!(2 * open.len() <= claims.len(), "{open:#?}");
}

#[test]
fn statements_on_covariances_are_about_stationary_states() {
    let mut family = Statements::new(COVARIANCES);
    for n in 1..=5 {
        for (of, letter) in [
            ("V_{11}", "x"),
            ("W_{11}", "y"),
            ("W_{22}", "y"),
            ("P_{11}", "x"),
        ] {
            let of = format!("{n}{of}");
            family.say(&of, "positive", "", True);
            family.say(&format!("-{of}"), "positive", "", False);
            let on = format!("in = \"{letter}\"");
            let truth = match letter {
                // q/(2y) falls; -q/(2x) rises below zero; q/(1 - x^2) is least at zero.
                "y" => "decreasing in",
                _ if of.contains('V') => "increasing in",
                _ => "has a minimum in",
            };
            family.say(&of, truth, &on, True);
            family.say(&of, "independent of", &on, False);
            family.say(&of, "convex in", &on, True);
            if letter == "y" || of.contains('V') {
                family.say(&of, "not monotone in", &on, False);
                family.say(
                    &of,
                    "tends to",
                    &format!("{on}\nas = \"0\"\nto = '\\infty'"),
                    True,
                );
            }
        }
        family.say(&format!("{n}D_{{11}}"), "increasing in", "in = \"y\"", True);
        family.say(&format!("{n}D_{{11}} + 1"), "positive", "", True);
        family.say(&format!("{n}D_{{11}} + q"), "positive", "", True);
    }
    let open = family.undecided();
    assert!(10 * open.len() <= 9 * family.all.len(), "{open:#?}");
}

const DIRAC: &str = r"```toml symbols
x = { }
y = { }
a = { positive = true }
t = { }
```
```toml notation
'\delta' = { dirac = true }
e = { constant = 'e' }
```
";

/// The Dirac distribution of a letter that hypotheses keep from zero, or do not.
#[test]
fn the_dirac_distribution_away_from_zero() {
    let mut claims = Vec::new();
    let away = [
        r"x \ne 0",
        "|x| > 1",
        "x^2 > 1",
        "x^2 = a",
        "x > 0",
        "x = 2",
        "x < -a",
        r"|x| \ge a",
        "x = -a",
        "x(x + 1) > 0",
        r"2x \ne x",
        "xy = 1",
        "xy = a",
        r"xy \ne 0",
        "x^2 - a^2 = 1",
        "x^3 = a",
        r"\frac{1}{x} = y",
    ];
    // What says nothing of whether it is zero.
    let near = ["x > -1", "x < a", "y > 0", "|x| < 1", "a = 2", r"x \ne 1"];
    for n in 1..=6 {
        for hypothesis in away {
            for claim in [
                format!(r"{n}\delta(x) = 0"),
                format!(r"{n}y\delta(x) = 0"),
                format!(r"\delta(x) + {n} = {n}"),
            ] {
                claims.push(Claim::under(claim, "assume", &[hypothesis.into()], True));
            }
        }
        for hypothesis in near {
            for claim in [
                format!(r"{n}\delta(x) = 0"),
                format!(r"\delta(x) + {n} = {n}"),
            ] {
                claims.push(Claim::under(claim, "assume", &[hypothesis.into()], False));
            }
        }
        claims.push(Claim::plain(format!(r"{n}\delta(x) = 0"), False));
        claims.push(Claim::plain(format!(r"{n}x\delta(x) = 0"), True));
        claims.push(Claim::plain(
            format!(r"{n}\delta(t)\cos t = {n}\delta(t)"),
            True,
        ));
    }
    assert!(claims.len() >= 200);
    let open = undecided(DIRAC, &claims);
    println!("{} claims, {} open", claims.len(), open.len());
    // Without hypotheses it is decided.
    assert!(
        open.iter().all(|line| !line.ends_with("given []")),
        "{open:#?}"
    );
}

const OTHERWISE: &str = r"```toml symbols
x = { }
y = { }
a = { positive = true }
b = { positive = true }
'\xi' = { }
```
```math 1 define
g(\xi) = \begin{cases} \xi & \xi \ge 0 \\ -\xi & \text{otherwise} \end{cases}
```
```math 2 define
h(\xi) = \begin{cases} 1 & \xi > 0 \\ 0 & \text{otherwise} \end{cases}
```
```math 3 define
f(\xi) = \begin{cases} -1 & \xi < 0 \\ 1 & \xi > 0 \\ 0 & \text{otherwise} \end{cases}
```
";

/// Where no other case applies, and only there, the last one does.
#[test]
fn otherwise_is_where_no_other_case_applies() {
    let mut claims = Vec::new();
    let modulus = |z: &str| {
        format!(
            r"\begin{{cases}} {z} & \text{{if }} {z} \ge 0 \\ -{z} & \text{{otherwise}} \end{{cases}}"
        )
    };
    for n in 1..=10 {
        for (claim, truth) in [
            (format!("{n}|x| = {n}{}", modulus("x")), True),
            (format!("{n}x = {n}{}", modulus("x")), False),
            (format!("g({n}x) = |{n}x|"), True),
            (format!("g(-{n}x) = g({n}x)"), True),
            (format!("g(x)^2 = x^2 + {n} - {n}"), True),
            (format!("g({n}ax) = {n}ag(x)"), True),
            (format!("h({n}x)^2 = h(x)"), True),
            (format!("h({n}ax) = h(x)"), True),
            (format!("f({n}x)g(x) = x"), True),
            (format!("f({n}x)|x| = x"), True),
            (format!("h({n}x) + h(-x) = f(x)^2"), True),
            (format!("h({n}x) - h(-x) = f(x)"), True),
            (format!("g({n}x) = {n}x"), False),
            (format!("g({n}x) = -{n}x"), False),
            (format!("h({n}x) = 1"), False),
            (format!("h({n}x) = 0"), False),
            (format!("h({n}x) + h(-x) = 1"), False),
            (format!("h({n}x) = 1 - h(-x)"), False),
            (format!("f({n}x)^2 = 1"), False),
            (format!("h({n}a) = 1"), True),
            (format!("h(-{n}a) = 0"), True),
        ] {
            claims.push(Claim::plain(claim, truth));
        }
    }
    assert!(claims.len() >= 200);
    let open = undecided(OTHERWISE, &claims);
    assert!(10 * open.len() <= 2 * claims.len(), "{open:#?}");
}

/// A figure has no value where its quantity has none, and says so in words.
#[test]
fn figures_show_no_value_where_there_is_none() {
    for (quantity, over, drawn) in [
        (r"\frac{a^2-4}{a-2}", r#"["1", "3"]"#, false),
        (r"\frac{a^2-4}{a-2}", r#"["3", "4"]"#, true),
        ("z", r#"["1", "3"]"#, false),
        ("z", r#"["3", "4"]"#, true),
        (r"\frac{1}{a-2}", r#"["1", "3"]"#, false),
        (r"\frac{a(a - 2)}{(a - 2)(a + 1)}", r#"["1", "3"]"#, false),
        (r"\frac{a}{a}", r#"["0", "1"]"#, false),
        (r"z - z", r#"["1", "3"]"#, false),
        (r"0z", r#"["1", "3"]"#, false),
        (r"a + 2", r#"["1", "3"]"#, true),
        ("k", r#"["1", "3"]"#, false),
        (r"\ln(a)", r#"["1", "3"]"#, false),
    ] {
        let text = format!(
            "```toml symbols\na = {{ value = \"3\" }}\n```\n\
             ```math 1 define\nz = \\frac{{a^2-4}}{{a-2}}\n```\n\
             ```math 2 define\nk = \\begin{{cases}} a & a > 0 \\\\ 0 & a \\le 0 \\end{{cases}}\n```\n\
             ```toml figure 1\ntitle = \"z\"\nkind = \"curves\"\nquantity = '{quantity}'\n\
             over = {{ a = {over} }}\npoints = 5\n```\n"
        );
        let audit = audit(&text, Options::default()).unwrap_or_else(|r| panic!("{r}"));
        match &audit.figures[0].content {
            Ok(Content::Curves(_)) => assert!(drawn, "{quantity} over {over}"),
            Ok(_) => panic!("{quantity}: no curves"),
            Err(reason) => {
                assert!(!drawn, "{quantity} over {over}: {reason}");
                assert!(!reason.contains(['{', '"']), "{quantity}: {reason}");
            }
        }
    }
}
