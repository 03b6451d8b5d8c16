//! What a print leaves unsaid and what names capture: processes that hypotheses tie, limits and statements
//! over the time, derivatives at corners, the ends of integrals, running indices and arguments with the
//! name of a letter. Each family is drawn with truth by construction; what has no value, or of which
//! nothing says enough, must not hold, and nothing true may be refuted.

use super::dots::Draw;
use crate::common::audit;
use rederive::check::Options;
use rederive::document::{Document, VerdictWord};

/// What may be said of a claim.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Truth {
    True,
    False,
    /// No value, or not enough is written: neither.
    Open,
}
use Truth::{False, Open, True};

/// A claim with its hypotheses.
pub struct Claim {
    claim: String,
    key: &'static str,
    hypotheses: Vec<String>,
    truth: Truth,
}

impl Claim {
    pub fn plain(claim: impl Into<String>, truth: Truth) -> Self {
        Claim::under(claim, "assume", &[], truth)
    }

    /// The claim under the same hypotheses twice, as assumed and as given.
    pub fn assumed_and_given(claim: &str, hypotheses: &[&str], truth: Truth) -> [Self; 2] {
        let hypotheses: Vec<String> = hypotheses.iter().map(|h| h.to_string()).collect();
        ["assume", "given"].map(|key| Claim::under(claim, key, &hypotheses, truth))
    }

    pub fn under(
        claim: impl Into<String>,
        key: &'static str,
        hypotheses: &[String],
        truth: Truth,
    ) -> Self {
        Claim {
            claim: claim.into(),
            key,
            hypotheses: hypotheses.to_vec(),
            truth,
        }
    }

    /// Whether it is true or false.
    pub fn has_truth(&self) -> bool {
        self.truth != Open
    }
}

/// Audits all claims in one document; those with a truth that are not decided.
pub fn undecided(preamble: &str, claims: &[Claim]) -> Vec<String> {
    assert!(claims.len() >= 100, "{} claims", claims.len());
    let mut text = preamble.to_string();
    for (k, claim) in claims.iter().enumerate() {
        text += &format!("\n```math claim{k} claim\n{}\n```\n", claim.claim);
        if !claim.hypotheses.is_empty() {
            let all: Vec<String> = claim.hypotheses.iter().map(|h| format!("'{h}'")).collect();
            text += &format!(
                "\n```toml claim{k}\n{} = [{}]\n```\n",
                claim.key,
                all.join(", ")
            );
        }
    }
    let options = Options {
        repair: false,
        ..Options::default()
    };
    let audit = audit(&text, options).unwrap_or_else(|r| panic!("{r}"));
    let mut wrong = Vec::new();
    let mut undecided = Vec::new();
    for (k, claim) in claims.iter().enumerate() {
        let equation = audit.model.equation(&format!("claim{k}")).expect("a claim");
        let outcome = audit.outcomes_of(equation).last().expect("a link");
        assert!(
            outcome.contradiction.is_none(),
            "{}: {:?}",
            claim.claim,
            claim.hypotheses
        );
        let word = outcome.verdict.word();
        let holds = matches!(word, VerdictWord::Holds | VerdictWord::HoldsGiven);
        let false_ = matches!(word, VerdictWord::Refuted | VerdictWord::Misprint);
        let sound = match claim.truth {
            True => !false_,
            False => !holds,
            Open => !holds && !false_,
        };
        if !sound {
            wrong.push(format!(
                "{} given {:?}: {word}",
                claim.claim, claim.hypotheses
            ));
        }
        if claim.truth != Open && !holds && !false_ {
            undecided.push(format!("{} given {:?}", claim.claim, claim.hypotheses));
        }
    }
    assert!(
        wrong.is_empty(),
        "{} of {}: {wrong:#?}",
        wrong.len(),
        claims.len()
    );
    undecided
}

fn with_truth(claims: &[Claim]) -> usize {
    claims.iter().filter(|c| c.truth != Open).count()
}

const PROCESSES: &str = r"```toml symbols
a = { positive = true }
b = { positive = true }
c = { }
t = { }
y = { function_of = 't' }
z = { function_of = 't' }
w = { function_of = 't' }
p = { function_of = 't' }
```
```toml notation
'\pi' = { constant = 'pi' }
e = { constant = 'e' }
```
```math 1 define
h = p^2
```
```math 2 define
K = \dot p
```
";

/// A hypothesis holds at all times, and so do its rates: y = f(t) for polynomials f, said in several
/// ways, by one hypothesis or two.
#[test]
fn hypotheses_on_processes_hold_at_all_times() {
    let mut draw = Draw::new(41);
    let mut claims = Vec::new();
    for k in 0..240 {
        // y = m t^2 + n t + q a.
        let (m, n, q) = (draw.below(3), 1 + draw.below(4), draw.below(3));
        let f = |m: usize| format!("{m}t^2 + {n}t + {q}a");
        let rate = format!("{}t + {n}", 2 * m);
        let second = format!("{}", 2 * m);
        let hypotheses: Vec<String> = match draw.below(9) {
            0 => vec![format!("y = {}", f(m))],
            1 => vec![format!("{} = y", f(m))],
            2 => vec![format!("y - {n}t = {m}t^2 + {q}a")],
            3 => vec![format!("2y = 2({})", f(m))],
            4 => vec!["y = z".into(), format!("z = {}", f(m))],
            5 => vec![format!("z = {}", f(m)), "y = z".into()],
            6 => vec![format!("y + z = {}", f(m)), "z = 0".into()],
            7 => vec![format!("y + z = 2({})", f(m)), "y = z".into()],
            _ => vec![format!("y + c = {} + c", f(m))],
        };
        let key = if k % 3 == 0 { "given" } else { "assume" };
        let truth = if draw.coin() { True } else { False };
        let off = if truth == True { "" } else { " + 1" };
        let claim = match draw.below(5) {
            0 => format!(r"\ddot y = {second}{off}"),
            1 => format!(r"a \dot y = a({rate}{off})"),
            2 => format!(r"2y\dot y = 2({})({rate}{off})", f(m)),
            3 => format!(r"\frac{{d}}{{dt}}y = {rate}{off}"),
            _ => format!(r"\dot y = {rate}{off}"),
        };
        claims.push(Claim::under(claim, key, &hypotheses, truth));
    }
    // Through definitions, and with a rate in a hypothesis.
    let more: [(&str, &[&str], Truth); 16] = [
        (r"\dot h = 2t", &["p = t"], True),
        (r"K = 1", &["p = t"], True),
        (r"K = 0", &["p = t"], False),
        (r"2p\dot p = 1", &["h = t"], True),
        (r"\dot h = 1", &["h = t"], True),
        (r"c = 1", &["y = t", r"\dot y = c"], True),
        (r"\dot z = 2", &["y = t^2", r"\dot y = z"], True),
        (r"z = 1", &["y = t", r"\dot y = z"], True),
        (r"\dot y = 2t", &["y = z^2", "z = t"], True),
        (r"\dot z = a", &["y = z", "y = at"], True),
        (r"z = \dot w", &["y = w", r"\dot y = z"], True),
        (r"\dot y = 0", &[r"a \le y", r"y \le a"], True),
        (r"\dot y = 0", &[r"y^2 \le 0"], True),
        (r"\dot y = 0", &[r"y^2 + z^2 \le 0"], True),
        (r"\dot y = \dot z", &[r"y \le z", r"z \le y"], True),
        (r"\dot y = \dot z", &["y^3 = z^3"], True),
    ];
    for (claim, hypotheses, truth) in more {
        claims.extend(Claim::assumed_and_given(claim, hypotheses, truth));
    }
    let open = undecided(PROCESSES, &claims);
    let most = 3 * with_truth(&claims) / 20;
    assert!(
        open.len() <= most,
        "{} of {}: {open:#?}",
        open.len(),
        claims.len()
    );
}

/// How a process goes with the time is not written, and neither are its limits.
#[test]
fn processes_have_no_limits_in_the_time() {
    let mut draw = Draw::new(42);
    let mut claims = Vec::new();
    let bodies = [
        (r"\frac{P}{t}", "0"),
        (r"P e^{-t}", "0"),
        ("P", "P"),
        (r"\frac{P}{1 + t^2}", "0"),
        (r"\frac{P + t}{t}", "1"),
        (r"\dot{P}", "0"),
        (r"\frac{a P}{P + t}", "0"),
    ];
    for _ in 0..100 {
        let (body, limit) = bodies[draw.below(bodies.len())];
        let process = ["y", "z", "p", "h"][draw.below(4)];
        let to = [r"\infty", "0", "a"][draw.below(3)];
        let claim = format!(r"t \to {to}, {body} \to {limit}").replace('P', process);
        claims.push(Claim::plain(claim, Open));
    }
    for k in 1..=10 {
        claims.push(Claim::plain(
            format!(r"t \to \infty, \frac{{{k}a}}{{t}} \to 0"),
            True,
        ));
        claims.push(Claim::plain(
            format!(r"t \to \infty, \frac{{{k}t + a}}{{t}} \to {k}"),
            True,
        ));
        claims.push(Claim::plain(
            format!(r"t \to \infty, \frac{{{k}t + a}}{{t}} \to 0"),
            False,
        ));
    }
    let open = undecided(PROCESSES, &claims);
    assert!(open.is_empty(), "{open:#?}");
}

const LETTERS: &str = r"```toml symbols
a = { positive = true }
b = { positive = true }
x = { }
y = { }
n = { domain = 'integer' }
v = { range = '0 \le v \le 1' }
t = { }
p = { function_of = 't' }
'\xi' = { }
'\eta' = { }
```
```toml notation
'\pi' = { constant = 'pi' }
e = { constant = 'e' }
'\delta' = { dirac = true }
```
```math 1 define
H(\xi) = \begin{cases} 1 & \xi \ge 0 \\ 0 & \xi < 0 \end{cases}
```
```math 2 define
G(\xi) = \begin{cases} \xi^2 & \xi \ge 1 \\ \xi & \xi < 1 \end{cases}
```
```math 3 define
V(\xi) = \frac{\partial}{\partial x}(x^2 \xi)
```
```math 4 define
U(\xi) = \frac{d}{dx}(x \xi^2 + x^3)
```
```math 5 define
w(\xi) = \xi^2, \quad 0 < \xi < 1
```
```math 6 define
f(\xi) = \xi^3
```
```math 7 claim
f'(x) = 3x^2
```
";

/// Letters that go to a limit and that a relation of order ties to others; those that it does not tie.
#[test]
fn limits_do_not_know_what_ties_their_letter() {
    let mut draw = Draw::new(43);
    let mut claims = Vec::new();
    let tied = [
        (r"x \to \infty, \frac{y}{x} \to 0", "y > x"),
        (r"x \to \infty, \frac{y}{x} \to 0", "|y| > x"),
        (r"x \to \infty, \frac{y}{x} \to 0", "y^2 > x"),
        (r"x \to \infty, \frac{y}{x} \to 0", "x < y < 2x"),
        (r"a \to 0, \frac{b}{a} \to \infty", "b < a"),
        (r"a \to 0, \frac{b}{a} \to \infty", "b < a^2"),
        (r"a \to \infty, \frac{a}{a+b} \to 1", "b > a"),
        (r"a \to \infty, e^{b-a} \to 0", "b > a"),
        (r"a \to 0, ab \to 0", "ab > 1"),
        (r"a \to 0, ab \to 0", r"ab \ge 2"),
    ];
    for _ in 0..100 {
        let (claim, hypothesis) = tied[draw.below(tied.len())];
        let key = if draw.coin() { "assume" } else { "given" };
        claims.push(Claim::under(claim, key, &[hypothesis.into()], Open));
    }
    for k in 1..=5 {
        let free = [
            (r"\frac{y}{x}", "0", True),
            (r"\frac{kx + y}{x}", "k", True),
            (r"\frac{kx + y}{x}", "0", False),
        ];
        for (body, limit, truth) in free {
            let claim = format!(r"x \to \infty, {body} \to {limit}").replace('k', &k.to_string());
            if truth == True {
                claims.push(Claim::under(
                    claim.clone(),
                    "assume",
                    &["y > 2".into()],
                    truth,
                ));
            }
            claims.push(Claim::plain(claim, truth));
        }
    }
    let open = undecided(LETTERS, &claims);
    assert!(open.is_empty(), "{open:#?}");
}

/// Derivatives of what has corners or jumps, by integers, and at the ends of ranges.
#[test]
fn derivatives_need_a_neighbourhood() {
    let mut draw = Draw::new(44);
    let mut claims = Vec::new();
    let shifted = ["x", "x - y", "2x + 1", "3x", "x + b"];
    for _ in 0..120 {
        let inner = shifted[draw.below(shifted.len())];
        let k = 1 + draw.below(5);
        claims.push(match draw.below(8) {
            0 => Claim::plain(format!(r"\frac{{d}}{{dx}}H({inner}) = 0"), Open),
            1 => Claim::plain(format!(r"\frac{{d}}{{dx}}({k}H({inner})) = 0"), Open),
            2 => Claim::under(
                format!(r"\frac{{d}}{{dx}}({k}|x|) = {k}"),
                "assume",
                &[r"x \ge 0".into()],
                Open,
            ),
            3 => Claim::under(
                format!(r"\frac{{d}}{{dx}}({k}|x|) = {k}"),
                "assume",
                &["x > 0".into()],
                True,
            ),
            4 => Claim::plain(format!(r"\frac{{d}}{{dv}}({k}|v|) = {k}"), Open),
            5 => Claim::plain(format!(r"\frac{{d}}{{dn}}\cos({}\pi n) = 0", 2 * k), Open),
            6 => Claim::plain(format!(r"\frac{{d}}{{dt}}({k}H(p)) = 0"), Open),
            _ => Claim::under(
                format!(r"\frac{{d}}{{dx}}({k}|x - y|) = {k}"),
                "given",
                &[r"x \ge y".into()],
                Open,
            ),
        });
    }
    for k in 1..=10 {
        claims.push(Claim::under(
            format!(r"\frac{{d}}{{dx}}G({k}x) = {k}"),
            "assume",
            &[format!(r"{k}x \le 1")],
            Open,
        ));
        claims.push(Claim::plain(format!(r"\frac{{d}}{{dx}}|{k}a| = 0"), True));
        claims.push(Claim::plain(
            format!(r"\frac{{d}}{{dv}}({k}v^2) = {}v", 2 * k),
            True,
        ));
        claims.push(Claim::plain(
            format!(r"\frac{{d}}{{dv}}({k}v^2) = {k}v"),
            False,
        ));
    }
    let open = undecided(LETTERS, &claims);
    assert!(open.is_empty(), "{open:#?}");
}

/// An argument is put in after what stands in the body has been differentiated.
#[test]
fn derivatives_do_not_capture_arguments() {
    let mut claims = Vec::new();
    // The argument, its value in x, and the integral of V over 0..1 where that is asked.
    let arguments = [
        ("x", "(x)"),
        ("2x", "(2x)"),
        ("x^2", "(x^2)"),
        ("a", "(a)"),
        ("x + a", "(x + a)"),
        ("ax", "(ax)"),
        ("3", "(3)"),
        ("y", "(y)"),
        (r"\frac{x}{2}", r"(\frac{x}{2})"),
    ];
    for (argument, value) in arguments {
        for k in 1..=3 {
            let times = ["", "a", "y"][k - 1];
            let right = [(2, True), (3, False), (1, False)];
            for (factor, truth) in right {
                claims.push(Claim::plain(
                    format!(r"{times} V({argument}) = {factor}{value} {times} x"),
                    truth,
                ));
            }
            claims.push(Claim::plain(
                format!(r"{times} U({argument}) = {times} ({value}^2 + 3x^2)"),
                True,
            ));
            claims.push(Claim::plain(
                format!(r"{times} U({argument}) = {times} ({value}^2 + 4x^2)"),
                False,
            ));
        }
    }
    for (claim, truth) in [
        (r"\int_0^1 V(x)\,dx = \frac{2}{3}", True),
        (r"\int_0^1 V(x)\,dx = 1", False),
        (r"\frac{d}{dx} V(x) = 4x", True),
        (r"\frac{d}{dx} V(x) = 6x", False),
        (r"x \to \infty, \frac{V(x)}{x^2} \to 2", True),
        (r"x \to \infty, \frac{V(x)}{x^2} \to 3", False),
    ] {
        claims.push(Claim::plain(claim, truth));
    }
    let open = undecided(LETTERS, &claims);
    let most = with_truth(&claims) / 20;
    assert!(
        open.len() <= most,
        "{} of {}: {open:#?}",
        open.len(),
        claims.len()
    );
}

/// What of a distribution counts at the end of an integral is not written, and outside of its range a
/// function has no value.
#[test]
fn ends_of_integrals_and_ranges() {
    let mut claims = Vec::new();
    for k in 1..=20 {
        claims.push(Claim::plain(
            format!(r"\int_0^{{{k}}} \delta(x)\,dx = 0"),
            Open,
        ));
        claims.push(Claim::plain(
            format!(r"\int_0^{{{k}}} {k}\delta({k}x)\,dx = 1"),
            Open,
        ));
        claims.push(Claim::plain(
            format!(r"\int_{{-{k}}}^0 \delta(x)\,dx = 0"),
            Open,
        ));
        claims.push(Claim::plain(
            format!(r"\int_{{-{k}}}^{{{k}}} \delta(x)\,dx = 1"),
            True,
        ));
        claims.push(Claim::plain(
            format!(r"\int_{{{k}}}^{{{}}} \delta(x)\,dx = 0", k + 1),
            True,
        ));
        claims.push(Claim::plain(
            format!(r"\int_{{{k}}}^{{{}}} \delta(x - {k})\,dx = 0", k + 1),
            Open,
        ));
        claims.push(Claim::plain(
            format!(
                r"w(\frac{{1}}{{{}}}) = \frac{{1}}{{{}}}",
                k + 1,
                (k + 1) * (k + 1)
            ),
            True,
        ));
        claims.push(Claim::plain(format!(r"w({k}) = {}", k * k), Open));
        claims.push(Claim::under(
            "w(x) = x^2",
            "assume",
            &[format!("x > {k}")],
            Open,
        ));
    }
    claims.push(Claim::plain(r"\int_0^\infty \delta(x)e^{-x}\,dx = 0", Open));
    let open = undecided(LETTERS, &claims);
    assert!(open.is_empty(), "{open:#?}");
}

/// A running index hides the letter of its name; where the letter is reached in another way the document
/// is asked which is meant.
#[test]
fn a_running_index_that_may_be_a_letter_is_asked() {
    let index = |claim: &str| {
        let text =
            format!("{LETTERS}\n```math 8 define\nq = x^2\n```\n```math 9 claim\n{claim}\n```\n");
        Document::parse("test.md", &text)
            .ok()
            .and_then(|d| rederive::model::Model::build(&d).ok())
            .is_some()
    };
    let hidden = [
        r"\sum_{x=1}^{2} \int_0^1 x\,dx",
        r"\sum_{x=1}^{2} \int_0^x x\,dx",
        r"\sum_{x=1}^{2} \int_0^1 \int_0^1 x\,dx\,dy",
        r"\sum_{x=1}^{2} \frac{d}{dx} x^2",
        r"\sum_{x=1}^{2} q",
        r"\sum_{x=1}^{2} 2q x",
        r"\sum_{t=1}^{2} p",
        r"\sum_{x=1}^{2} V(y)",
    ];
    for left in hidden {
        for right in ["1", "2", "3", r"\frac{5}{2}", "2x"] {
            assert!(!index(&format!("{left} = {right}")), "{left} = {right}");
        }
    }
    for plain in [
        r"\sum_{x=1}^{2} x = 3",
        r"\sum_{x=1}^{3} f(x) = 36",
        r"\sum_{x=1}^{2} \int_0^x y\,dy = \frac{5}{2}",
        r"\sum_{x=1}^{2} a x = 3a",
    ] {
        assert!(index(plain), "{plain}");
    }
}

/// Two cases that leave out the point between them, and a range, leave a condition.
#[test]
fn gaps_between_cases_and_ranges_are_conditions() {
    let text = r"```toml symbols
a = { positive = true }
x = { }
'\xi' = { }
```
```math 1 define
C(\xi) = \begin{cases} \xi & \xi > 0 \\ -\xi & \xi < 0 \end{cases}
```
```math 2 define
D(\xi) = \begin{cases} \xi & \xi \ge 0 \\ -\xi & \xi < 0 \end{cases}
```
```math 3 define
w(\xi) = \xi^2, \quad 0 < \xi < 1
```
```math 4 claim
C(x) = |x|
```
```math 5 claim
D(x) = |x|
```
```math 6 claim
w(a) = a^2
```
```math 7 claim
C(x - a) = |x - a|
```
";
    let audit = audit(text, Options::default()).unwrap_or_else(|r| panic!("{r}"));
    for (label, conditions) in [("4", 1), ("5", 0), ("6", 1), ("7", 1)] {
        let equation = audit.model.equation(label).expect("a claim");
        let outcome = audit.outcomes_of(equation).next().expect("a link");
        assert_eq!(outcome.verdict.word(), VerdictWord::Holds, "{label}");
        assert_eq!(outcome.conditions.len(), conditions, "{label}");
    }
}
