//! What is true in one case, at one stationary point, on one side of a range or for one motion, and was
//! taken for the whole. Claims and statements whose truth is plain by construction; what has no value or
//! is not written must not be decided.

use super::unwritten::{Claim, Truth, undecided};
use crate::common::audit;
use Truth::{False, Open, True};
use rederive::check::Options;
use rederive::document::VerdictWord;

const CASES: &str = r"```toml symbols
a = { positive = true }
b = { positive = true }
x = { }
y = { }
t = { }
m = { positive = true }
k = { positive = true }
p = { function_of = 't' }
q = { function_of = 't' }
r = { function_of = 't' }
'\xi' = { }
```
```math 1 define
f(\xi) = \begin{cases} \xi & \xi \ge 0 \\ \xi + 3 & \xi < 0 \end{cases}
```
```math 2 define
g(\xi) = \begin{cases} \xi & \xi \ge 0 \\ 0 & \xi < 0 \end{cases}
```
```math 3 define
u(\xi) = \xi^2, \quad 0 < \xi < 1
```
```math 4 define
\ddot p = -\frac{k}{m} p
```
";

/// A hypothesis that is defined by cases says something else in each of them.
#[test]
fn hypotheses_by_cases_are_not_those_of_one_case() {
    let mut claims = Vec::new();
    let hypotheses = [
        ("f(x) = a", "x = a"),
        ("f(x) = 1", "x = 1"),
        ("f(x) = f(y)", "x = y"),
        ("g(x) = 0", "x = 0"),
        ("g(x) = g(y)", "x = y"),
        ("f(x) < 2", "-2 < x"),
        ("g(x) = y", r"x = y"),
        ("f(x - y) = 1", "x = y + 1"),
    ];
    for k in 1..=8 {
        for (hypothesis, claim) in hypotheses {
            let scale = |text: &str| format!("{k}({})", text.replace(" = ", &format!(") = {k}(")));
            let claim = if claim.contains('<') {
                claim.to_string()
            } else {
                scale(claim)
            };
            claims.extend(Claim::assumed_and_given(&claim, &[hypothesis], False));
        }
    }
    undecided(CASES, &claims);
}

/// A sum of cases in which some exclude each other is true as a whole, and no point of one case shows it
/// false.
#[test]
fn combinations_of_cases_are_those_that_exist() {
    let mut claims = Vec::new();
    for k in 1..=25 {
        claims.push(Claim::plain(format!(r"g({k}x) + g(-{k}x) = {k}|x|"), True));
        claims.push(Claim::plain(format!(r"g({k}x) - g(-{k}x) = {k}x"), True));
        claims.push(Claim::plain(format!(r"g({k}x)g(-x) = 0"), True));
        claims.push(Claim::plain(format!(r"g({k}x) + g(-{k}x) = {k}x"), False));
        claims.push(Claim::plain(
            format!(r"\sum_{{j=-1}}^1 g(jx) = {k}x"),
            False,
        ));
    }
    let open = undecided(CASES, &claims);
    assert!(10 * open.len() <= claims.len(), "{open:#?}");
}

/// Limits on the way to which a letter leaves the range of a function, and limits in which other
/// processes go along.
#[test]
fn limits_stay_where_there_are_values() {
    let mut claims = Vec::new();
    for k in 2..=20 {
        claims.push(Claim::plain(
            format!(r"a \to \infty, {k}u(a) \to \infty"),
            Open,
        ));
        claims.push(Claim::plain(
            format!(r"x \to {k}, u(x) \to {}", k * k),
            Open,
        ));
        claims.push(Claim::plain(
            format!(r"q \to \infty, \frac{{{k}r}}{{q}} \to 0"),
            Open,
        ));
        claims.push(Claim::plain(
            format!(r"q \to \infty, \frac{{\dot q}}{{{k}q}} \to 0"),
            Open,
        ));
        claims.push(Claim::plain(
            format!(r"q \to \infty, \frac{{{k}t}}{{q}} \to 0"),
            Open,
        ));
        claims.push(Claim::plain(
            format!(r"\frac{{d}}{{dq}}({k}\dot q^2) = 0"),
            Open,
        ));
        claims.push(Claim::plain(
            format!(r"q \to \infty, \frac{{{k}a}}{{q}} \to 0"),
            True,
        ));
    }
    let open = undecided(CASES, &claims);
    assert!(open.is_empty(), "{open:#?}");
}

/// A hypothesis about a process whose motion the document determines may contradict it.
#[test]
fn hypotheses_do_not_know_the_motion() {
    let mut claims = Vec::new();
    for j in 1..=10 {
        for (hypothesis, claim) in [
            (r"\dot p = 0", "jp = 0"),
            (r"\dot p = p", "jp = 0"),
            (r"\dot p = ap", "jp = 0"),
            (r"p = t", r"j\dot p = j"),
            (r"p = a", r"j\ddot p = 0"),
        ] {
            let claim = claim.replace('j', &j.to_string());
            claims.extend(Claim::assumed_and_given(&claim, &[hypothesis], Open));
        }
    }
    undecided(CASES, &claims);
}

/// A statement about one of the functions, and whether it is true.
fn statement(of: &str, predicate: &str, more: &str) -> VerdictWord {
    let text = format!(
        "```toml symbols\nx = {{ value = \"2\" }}\nw = {{ range = '0 \\le w \\le 3', value = \"1\" }}\n\
         a = {{ positive = true, value = \"1\" }}\nb = {{ positive = true, value = \"1\" }}\n'\\xi' = {{ }}\n```\n\
         ```math 1 define\nh = \\begin{{cases}} x & x \\ge 0 \\\\ -x & x < 0 \\end{{cases}}\n```\n\
         ```math 2 define\nd = \\frac{{x^2 - 4}}{{x - 2}}\n```\n\
         ```statement s\nWords.\n```\n```toml s\nof = ['{of}']\npredicate = \"{predicate}\"\n{more}\n```\n"
    );
    let audit = audit(&text, Options::default()).unwrap_or_else(|r| panic!("{r}"));
    audit.statements[0].word
}

#[test]
fn statements_are_about_all_cases_and_the_only_minimum() {
    let holds = |word| matches!(word, VerdictWord::Holds);
    let stationary = [
        ("x^4 + x^3", "x", "0"),
        ("x^6 + x^5", "x", "0"),
        ("3x^4 - 8x^3 + 6x^2", "x", "1"),
        ("(x - 2)^3(x - 5)", "x", "2"),
        ("w^4 - 4w^3", "w", "0"),
        ("w^3 - 3w^2 + 3w", "w", "1"),
    ];
    for (of, letter, at) in stationary {
        let more = format!("in = ['{letter}']\nat = \"{at}\"");
        assert!(!holds(statement(of, "minimal at", &more)), "{of} at {at}");
    }
    for (of, letter, at) in [
        ("x^2 - 2x", "x", "1"),
        ("x^4 + x^3", "x", r"-\\frac{3}{4}"),
        ("w^4 - 4w^3", "w", "3"),
    ] {
        let more = format!("in = ['{letter}']\nat = \"{at}\"");
        assert!(holds(statement(of, "minimal at", &more)), "{of} at {at}");
    }
    for (of, predicate, more) in [
        ("h", "increasing in", "in = ['x']"),
        ("h", "proportional to", "to = 'x'"),
        ("h", "has a minimum in", "in = ['x']"),
        ("d", "equals", "to = '4'"),
        (r"\frac{a^2 - b^2}{a - b}", "equals", "to = '2'"),
        (r"\frac{x^3}{x}", "minimal at", "in = ['x']\nat = \"0\""),
    ] {
        assert_eq!(
            statement(of, predicate, more),
            VerdictWord::Undecided,
            "{of} {predicate}"
        );
    }
}
