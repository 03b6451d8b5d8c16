//! Lines, columns, cases, words and braces: a print is read as it is seen, or is asked about.
//!
//! Each family is generated with both truth values, and with the truth that another reading would give; what a
//! person could read in two ways must be refused.

use super::dots::{Draw, Tally, verdicts};
use rederive::audit::Audit;
use rederive::check::Options;
use rederive::diagnostic::{Diagnostic, DiagnosticKind};
use rederive::document::Document;

const LETTERS: &str = r"```toml symbols
a = { positive = true }
b = { positive = true }
x = { }
y = { }
n = { domain = 'integer' }
'\mathbf{A}' = { shape = [2, 2] }
'\mathbf{B}' = { shape = [2, 2] }
'\mathbf{u}' = { shape = [2, 1] }
```
```toml notation
'A_{i,j}' = { entry_of = '\mathbf{A}' }
'\pi' = { constant = 'pi' }
e = { constant = 'e' }
```
";

/// What is wrong with a claim beside some definitions.
fn errors(definitions: &str, claim: &str) -> Vec<Diagnostic> {
    let text = format!("{LETTERS}{definitions}```math 1 claim\n{claim}\n```\n");
    match Document::parse("test.md", &text) {
        Err(diagnostics) => diagnostics,
        Ok(document) => match Audit::of(&document, Options::default()) {
            Err(rejection) => rejection.diagnostics,
            Ok(_) => Vec::new(),
        },
    }
}

fn asked(definitions: &str, claim: &str) {
    let found = errors(definitions, claim);
    let ambiguous = |d: &Diagnostic| matches!(d.kind, DiagnosticKind::Ambiguous { .. });
    assert!(found.iter().any(ambiguous), "{claim}: {found:?}");
}

fn refused(definitions: &str, claim: &str) {
    assert!(!errors(definitions, claim).is_empty(), "{claim}");
}

fn judged(preamble: &str, claims: &[(String, bool)], least: usize) {
    let all: Vec<String> = claims.iter().map(|(claim, _)| claim.clone()).collect();
    let mut tally = Tally::default();
    for ((claim, truth), word) in claims.iter().zip(verdicts(preamble, &all)) {
        tally.count(claim, *truth, word);
    }
    assert!(tally.wrong.is_empty(), "{:#?}", tally.wrong);
    assert!(tally.right >= least, "{tally:?}");
}

/// A row of cases: its print behind `&`, and where it applies.
type Row = (String, Box<dyn Fn(f64) -> bool>);

#[test]
fn conditions_of_cases_are_conditions() {
    let mut draw = Draw::new(11);
    let (mut preamble, mut claims) = (LETTERS.to_string(), Vec::new());
    for k in 0..40 {
        let c = draw.below(5) as f64 - 2.0;
        let d = c - 1.0 - draw.below(2) as f64;
        let rows: [Row; 6] = [
            (format!(r"x > {c}"), Box::new(move |x| x > c)),
            (
                format!(r"\text{{if }} x \ge {c}"),
                Box::new(move |x| x >= c),
            ),
            (format!(r"\text{{if $x < {c}$}}"), Box::new(move |x| x < c)),
            (
                format!(r"\text{{for }} x > {c} \text{{ or }} x < {d}"),
                Box::new(move |x| x > c || x < d),
            ),
            (
                format!(r"{d} < x, \quad x < {c}"),
                Box::new(move |x| d < x && x < c),
            ),
            (
                format!(r"x \ge {d} \text{{ and }} x \le {c}"),
                Box::new(move |x| d <= x && x <= c),
            ),
        ];
        let others = [
            r"\text{otherwise}",
            r"\text{else}",
            r"\text{elsewhere}",
            r"\text{otherwise.}",
            r"\text{in all other cases}",
        ];
        let (row, applies) = &rows[draw.below(rows.len())];
        let other = others[draw.below(others.len())];
        let (f, one, two) = (format!("f_{{{k}}}"), 1 + draw.below(3), 5 + draw.below(3));
        preamble += &format!(
            "```math f{k} define\n{f}(x) = \\begin{{cases}} {one} & {row} \\\\ {two} & {other} \\end{{cases}}\n```\n"
        );
        for at in [c - 3.0, c, c + 0.5, d, d - 2.0] {
            let value = if applies(at) { one } else { two };
            let point = if at < 0.0 {
                format!("({at})")
            } else {
                at.to_string()
            };
            let point = point.replace("()", "");
            claims.push((
                format!("{f}({}) = {value}", point.trim_matches(['(', ')'])),
                true,
            ));
            claims.push((
                format!(
                    "{f}({}) = {}",
                    point.trim_matches(['(', ')']),
                    one + two - value
                ),
                false,
            ));
        }
    }
    judged(&preamble, &claims, claims.len() * 9 / 10);
    for condition in [
        r"y",
        "0",
        r"\text{even}",
        r"\text{on the left}",
        r"\text{if x > 0}",
        r"n \text{ even}",
        r"x \text{ positive}",
        "",
    ] {
        refused(
            "",
            &format!(r"x = \begin{{cases}} x & {condition} \\ -x & x < 0 \end{{cases}}"),
        );
    }
    refused(
        "",
        r"x = \begin{cases} x & \text{otherwise} \\ -x & x < 0 \end{cases}",
    );
    asked(
        "",
        r"x = \begin{cases} x & x > 0, y > 0 \text{ or } a > b \\ -x & \text{else} \end{cases}",
    );
}

#[test]
fn words_beside_an_equation_are_read_or_asked_about() {
    for equation in ["x = y", "x + 1 = 1 + x", "|x| = x", r"\sin x = x", "a > b"] {
        for words in [
            "for positive $x$",
            "up to a factor",
            "unless a vanishes",
            "does not hold",
            "is false",
            "by no means",
            "by more than 2",
            "by approximation",
            "from above",
            "from the left",
            "when the speed is small",
            "(for large speeds)",
            "approximately true",
        ] {
            let claim = format!(r"{equation} \text{{ {words}}}");
            refused("", &claim);
        }
        for words in [
            "by symmetry",
            "from the definition",
            "by the chain rule",
            "see above",
        ] {
            let claim = format!(r"{equation} \text{{ {words}}}");
            assert!(errors("", &claim).is_empty(), "{claim}");
        }
        for words in ["False: ", "Not: ", "Never:", "Only if:"] {
            refused("", &format!(r"\text{{{words}}} {equation}"));
        }
    }
    let claims = [
        (r"|x| = x \text{ if $x > 0$}".to_string(), true),
        (r"|x| = -x \text{ if $x > 0$}".to_string(), false),
        (r"|x| = x, \quad \text{for $x \ge 0$}".to_string(), true),
        (
            r"|x| = x \text{ for all $x$ with $x < 0$}".to_string(),
            false,
        ),
    ];
    for (claim, truth) in &claims[..3] {
        judged(LETTERS, &[(claim.clone(), *truth)], 1);
    }
    for word in ["or", "if", "unless", "when"] {
        for key in ["assume", "given"] {
            let text = format!(
                "{LETTERS}```math 1 claim\n|x| = x\n```\n```toml 1\n{key} = ['x > 0 \\text{{ {word} }} y > 0']\n```\n"
            );
            let document = Document::parse("test.md", &text).expect("a document");
            assert!(Audit::of(&document, Options::default()).is_err(), "{word}");
        }
    }
}

/// Braces that nobody sees, and the same print without them.
#[test]
fn braces_change_nothing() {
    let functions = [r"\sin x", r"\cos 2x", r"\ln a", r"\sin ax", r"2\cos x"];
    for function in functions {
        for behind in ["y", "b", "(x + y)", r"\sqrt{a}", r"\frac{a}{b}"] {
            asked("", &format!("{{{function}}} {behind} = x"));
            asked("", &format!("x + {{{function}}} {behind} = x"));
        }
        for script in ["^2", "^n", "^{-1}"] {
            asked("", &format!("{{{function}}}{script} = x"));
        }
        // Where nothing follows the brace is nothing.
        let claims = [
            (format!("{{{function}}} + x = x + {function}"), true),
            (format!("y{{{function}}} = {function} + y"), false),
        ];
        judged(LETTERS, &claims, 1);
    }
    for open in [
        r"\sum_{k=1}^2 k",
        r"\int_0^1 x\,dx",
        r"\frac{\mathrm{d}}{\mathrm{d}x} x^2",
    ] {
        asked("", &format!("{{{open}}}^2 = x"));
    }
    for base in ["x^2", "(x + 1)^2", r"\mathbf{A}^T"] {
        asked("", &format!("{{{base}}}^2 = x"));
    }
    for argument in ["(x)", "(x + y)", "[x]"] {
        asked("", &format!(r"\sin{{{argument}}}^2 = x"));
        asked("", &format!(r"\sin{argument}^2 = x"));
        let claim = (format!(r"\cos{{{argument}}} = \cos{argument}"), true);
        judged(LETTERS, &[claim], 1);
    }
}

#[test]
fn a_line_that_begins_with_a_sign_is_an_equation() {
    let mut draw = Draw::new(5);
    let sides = ["a", "x", "2x", "a + b", "xy", r"\frac{x}{2}", "-x"];
    let mut claims = Vec::new();
    for _ in 0..60 {
        let [one, other] = [0; 2].map(|_| sides[draw.below(sides.len())]);
        let (first, second) = (draw.coin(), draw.coin());
        let off = |truth: bool| if truth { "" } else { " + 1" };
        let environment = ["aligned", "align", "align*", "split"][draw.below(2)];
        let (left, right) = (
            format!("{one} &= {one}{}", off(first)),
            format!("-({other}) &= -({other}){}", off(second)),
        );
        claims.push((
            format!(r"\begin{{{environment}}} {left} \\ {right} \end{{{environment}}}"),
            first && second,
        ));
    }
    for (claim, truth) in &claims {
        let text = format!("{LETTERS}```math 1 claim\n{claim}\n```\n");
        let document = Document::parse("test.md", &text).expect("a document");
        let options = Options {
            repair: false,
            ..Options::default()
        };
        let audit = Audit::of(&document, options).unwrap_or_else(|r| panic!("{r}"));
        let words: Vec<&str> = audit
            .outcomes
            .iter()
            .map(|o| o.verdict.word().as_str())
            .collect();
        assert_eq!(words.len(), 2, "{claim}");
        assert_eq!(
            words.iter().all(|w| *w == "holds"),
            *truth,
            "{claim}: {words:?}"
        );
    }
    for (first, second) in [
        ("a = 2a", "-a = a"),
        ("x = y", "+x = y"),
        ("a > 0", "-a = -a"),
    ] {
        asked(
            "",
            &format!(r"\begin{{gathered}} {first} \\ {second} \end{{gathered}}"),
        );
        asked("", &format!(r"{first} \quad {}", second.replace('+', "-")));
    }
    // Alignment before the sign, tags, columns, wide spaces: each is seen as two equations, or is asked about.
    let pairs = [
        ("x = 2x", "-x = x", false),
        ("1 = 2", "-1 = 1", false),
        ("x = x", "-x = -x", true),
        ("xy = yx", "-y = -y", true),
    ];
    for (one, other, truth) in pairs {
        let [first, second] = [one, other].map(|e| e.replace(" = ", " &= "));
        for claim in [
            format!(r"\begin{{aligned}} & {one} \\ & {other} \end{{aligned}}"),
            format!(r"\begin{{align}} {first} \tag{{1}} \\ {second} \end{{align}}"),
            format!(r"\begin{{align}} {first} \nonumber \\ {second} \end{{align}}"),
        ] {
            let text = format!("{LETTERS}```math 1 claim\n{claim}\n```\n");
            let document = Document::parse("test.md", &text).expect("a document");
            let audit =
                Audit::of(&document, Options::default()).unwrap_or_else(|r| panic!("{claim}: {r}"));
            let all = audit
                .outcomes
                .iter()
                .all(|o| o.verdict.word().as_str() == "holds");
            assert_eq!((audit.outcomes.len(), all), (2, truth), "{claim}");
        }
        for space in [r"\quad", r"\qquad", r"\;\;\;", r"\ \ \ ", "~~"] {
            asked("", &format!("{one} {space} {other}"));
        }
        asked(
            "",
            &format!(r"\begin{{array}}{{cc}} {one} & {other} \end{{array}}"),
        );
    }
    let system = format!(
        "{LETTERS}```math 1 solve q, r\n\\begin{{array}}{{rcrcl}} q & + & r & = & 3 \\\\ -q & + & r & = & 1 \\end{{array}}\n```\n"
    );
    judged(
        &system,
        &[
            ("q = 1".into(), true),
            ("r = 2".into(), true),
            (r"r = \frac32".into(), false),
        ],
        3,
    );
    // An exponential ends the argument of a function, for most.
    for function in [r"\sin x", r"\cos ax", r"\ln a"] {
        asked("", &format!("{function} e^{{-x}} = x"));
    }
    for power in ["^2", "^{-1}", "^T"] {
        asked("", &format!(r"\mathbf{{A}}{power}_{{12}} = x"));
    }
    // What goes on is aligned behind the relation, or has none of its own.
    for claim in [
        r"\begin{aligned} x &= y \\ &\quad - y + x \end{aligned}",
        r"\begin{aligned} x &= y + x \\ - y \end{aligned}",
        r"\begin{aligned} (x+y)^2 &= x^2 \\ & + 2xy + y^2 = (y+x)^2 \end{aligned}",
    ] {
        judged(LETTERS, &[(claim.to_string(), true)], 1);
    }
    let text = format!(
        "{LETTERS}```math 1 solve q, r\n\\begin{{aligned}} q + r &= 3 \\\\ -q + r &= 1 \\end{{aligned}}\n```\n"
    );
    judged(
        &text,
        &[
            ("q = 1".into(), true),
            ("r = 2".into(), true),
            (r"q = \frac32".into(), false),
        ],
        3,
    );
    let columns = [
        (r"\begin{array}{ll} x = x & y = y \end{array}", true),
        (r"\begin{aligned} x = y & y = x \end{aligned}", false),
        (r"\begin{array}{ll} xy = x & y = xy \end{array}", false),
    ];
    for (claim, truth) in columns {
        let found = errors("", claim);
        assert!(found.is_empty(), "{claim}: {found:?}");
        let text = format!("{LETTERS}```math 1 claim\n{claim}\n```\n");
        let document = Document::parse("test.md", &text).expect("a document");
        let audit = Audit::of(&document, Options::default()).unwrap_or_else(|r| panic!("{r}"));
        let all = audit
            .outcomes
            .iter()
            .all(|o| o.verdict.word().as_str() == "holds");
        assert_eq!((audit.outcomes.len(), all), (2, truth), "{claim}");
    }
}

#[test]
fn products_of_functions_commutators_and_entries_of_powers_are_asked_about() {
    let functions = "```math f define\nf(x) = x^3\n```\n```math g define\ng(x) = x^2\n```\n";
    for claim in [
        "(f + g)(y) = f(y) + g(y)",
        "(fg)(y) = f(y)g(y)",
        "(f - g)(2) = 4",
        "fg(y) = f(y)g(y)",
        "(2f)(y) = 2f(y)",
    ] {
        asked(functions, claim);
    }
    judged(
        &format!("{LETTERS}{functions}"),
        &[
            ("f(y)g(y) = y^5".into(), true),
            ("f(x)g(x) = x^6".into(), false),
        ],
        2,
    );
    let (a, b) = (r"\mathbf{A}", r"\mathbf{B}");
    for claim in [
        format!("[{a}, {b}] = {a}{b} - {b}{a}"),
        format!(r"\operatorname{{tr}}[{a}, {b}] = 0"),
        format!("[{a}, {a}] = 0"),
        format!("[{a}{b}, {b}] = 0"),
    ] {
        asked("", &claim);
    }
    for power in ["-1", "2", "3", "n"] {
        asked("", &format!("A^{{{power}}}_{{12}} = A_{{12}}"));
        let claim = (format!("A_{{12}}^{{{power}}} = A_{{12}}^{{{power}}}"), true);
        let found = errors("", &claim.0);
        assert!(found.is_empty(), "{}: {found:?}", claim.0);
    }
    // A running index that is a letter behind an entry.
    let matrix = "```math P define\n\\mathbf{P} = \\begin{bmatrix} x & 1 \\\\ 0 & y \\end{bmatrix}\n```\n\
                  ```toml notation\n'P_{i,j}' = { entry_of = '\\mathbf{P}' }\n```\n";
    for claim in ["= 3", "= 2x", "= 2x + 1"] {
        asked(matrix, &format!(r"\sum_{{x=1}}^2 P_{{11}} {claim}"));
        asked(matrix, &format!(r"\sum_{{y=1}}^2 (P_{{22}} + x) {claim}"));
    }
    assert!(errors(matrix, r"\sum_{k=1}^2 P_{11} = 2x").is_empty());
    for space in [r"\;", r"\ ", "~", r"\:"] {
        asked("", &format!("[a{space}b] = ab"));
    }
    for space in [r"\quad", r"\qquad"] {
        for row in [
            "(a{}b)",
            r"\left(a{}b\right)",
            "(a{}-b)",
            r"\begin{pmatrix} a{}b \\ b{}a \end{pmatrix}",
        ] {
            asked(
                "",
                &format!("{} = x", row.replace("{}", &format!("{space} "))),
            );
        }
        let spaced = format!(r"\begin{{pmatrix}} a {space} & b \\ b & {space} a \end{{pmatrix}}");
        let plain = r"\begin{pmatrix} a & b \\ b & a \end{pmatrix}";
        judged(LETTERS, &[(format!("{spaced} = {plain}"), true)], 1);
    }
}

/// A condition behind a claim of one line need not be meant for the claims of the others.
#[test]
fn conditions_of_one_line_are_asked_about() {
    let claims = ["|x| &= x", "x &= 0", r"\sqrt{x^2} &= x", "x + 1 &= y + 1"];
    for one in claims {
        for other in claims {
            for condition in [
                r"&& \text{if } x = y",
                r", && \text{for } x > 0",
                r"& \text{if } x \ge 0",
            ] {
                asked(
                    "",
                    &format!(r"\begin{{aligned}} {one} {condition} \\ {other} \end{{aligned}}"),
                );
                asked(
                    "",
                    &format!(r"\begin{{aligned}} {one} \\ {other} {condition} \end{{aligned}}"),
                );
            }
            // On a line of its own it is meant for all.
            let all = format!(
                r"\begin{{aligned}} {one} \\ {other} \\ &\text{{for }} x > 0 \end{{aligned}}"
            );
            let found = errors("", &all);
            assert!(found.is_empty(), "{all}: {found:?}");
        }
    }
    let text = format!(
        "{LETTERS}```math 1 define\n\\begin{{aligned}} g_1(x) &= x, && x > 0 \\\\ g_2(x) &= |x| \\end{{aligned}}\n```\n"
    );
    let document = Document::parse("test.md", &text).expect("a document");
    let refused = Audit::of(&document, Options::default()).expect_err("a range of one of two");
    let ambiguous = |d: &Diagnostic| matches!(d.kind, DiagnosticKind::Ambiguous { .. });
    assert!(refused.diagnostics.iter().any(ambiguous));
}
