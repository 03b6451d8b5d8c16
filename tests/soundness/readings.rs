//! What is read is what a person reads, or is named, or is refused; and no claim vanishes.
//!
//! Each family is generated: the members that must be read are compared with the same written
//! without a choice, as trees or by verdicts; the others must be refused with the kind of error that
//! says why.

use super::common::audit;
use rederive::audit::Audit;
use rederive::check::Options;
use rederive::diagnostic::{Diagnostic, DiagnosticKind, printable, printable_line};
use rederive::document::Document;
use rederive::expr::Display;
use rederive::latex::{Reading, Signature, parse_display, parse_name, parse_printed};

/// SplitMix64 (Steele, Lea, Flood 2014): the members of a family, the same in every run.
struct Draw(u64);

impl Draw {
    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        z ^ (z >> 31)
    }

    fn from<'a>(&mut self, items: &[&'a str]) -> &'a str {
        items[(self.next() % items.len() as u64) as usize]
    }

    fn number(&mut self, from: u64, to: u64) -> u64 {
        from + self.next() % (to - from + 1)
    }
}

const LETTERS: [&str; 8] = ["a", "b", "c", "m", "v", "x", "y", "\\omega "];
const SPACES: [&str; 7] = [
    "\\,",
    "\\, ",
    "\\;",
    "\\ ",
    "~",
    "\\thinspace ",
    "\\hspace{2pt}",
];
/// What may stand behind a divisor.
const FACTORS: [&str; 9] = [
    "m v^2",
    "mv",
    "x^2",
    "a b c",
    "(a + b)",
    "\\frac{a}{b}",
    "\\sqrt{a + b}",
    "\\cos x",
    "\\omega_0^2 x",
];

fn signature(names: &[&str]) -> Signature {
    let mut signature = Signature::default();
    for name in names {
        signature.declare(&parse_name(name, 0).expect("a name"));
    }
    signature
}

fn printed(text: &str, signature: &Signature) -> (Display, Vec<Reading>) {
    parse_printed(text, 0, signature).unwrap_or_else(|why| panic!("{text}: {why:?}"))
}

fn tree(text: &str, signature: &Signature) -> Display {
    printed(text, signature).0
}

fn refused(text: &str, signature: &Signature) -> Vec<DiagnosticKind> {
    match parse_display(text, 0, signature) {
        Ok(display) => panic!("{text} is read as {display:?}"),
        Err(diagnostics) => diagnostics.into_iter().map(|d| d.kind).collect(),
    }
}

fn is_ambiguous(kinds: &[DiagnosticKind]) -> bool {
    let mut kinds = kinds.iter();
    kinds.any(|k| matches!(k, DiagnosticKind::Ambiguous { readings } if readings.len() == 2))
}

/// A document with these letters and equations, labelled from 1.
fn document(symbols: &[&str], equations: &[(&str, &str)]) -> String {
    let mut text = String::from("```toml symbols\n");
    for symbol in symbols {
        text += &format!("{symbol}\n");
    }
    text += "```\n";
    for (k, (role, latex)) in equations.iter().enumerate() {
        text += &format!("```math {} {role}\n{latex}\n```\n", k + 1);
    }
    text
}

/// Everything that is wrong with a document.
fn errors(text: &str) -> Vec<Diagnostic> {
    match Document::parse("test.md", text) {
        Err(diagnostics) => diagnostics,
        Ok(document) => match Audit::of(&document, Options::default()) {
            Err(rejection) => rejection.diagnostics,
            Ok(_) => Vec::new(),
        },
    }
}

fn quick() -> Options {
    Options {
        repair: false,
        ..Options::default()
    }
}

/// The words of all verdicts, label by label.
fn verdicts(text: &str) -> Vec<(String, &'static str)> {
    let audit = audit(text, quick()).unwrap_or_else(|rejection| panic!("{rejection}"));
    let label = |equation: usize| audit.model.equations[equation].label.clone();
    let outcomes = audit.outcomes.iter();
    outcomes
        .map(|o| (label(o.equation), o.verdict.word().as_str()))
        .collect()
}

/// `1/2\, mv^2` is half of mv^2, and named; without the space both readings are given back.
#[test]
fn a_slash_reaches_as_far_as_a_person_reads() {
    let mut draw = Draw(1);
    let signature = signature(&LETTERS);
    for _ in 0..120 {
        let (n, m) = (draw.number(1, 9), draw.number(2, 12));
        let (space, factors) = (draw.from(&SPACES), draw.from(&FACTORS));
        let (read, readings) = printed(&format!("y = {n}/{m}{space}{factors}"), &signature);
        let spelt = tree(&format!("y = {n}/{m} \\cdot {factors}"), &signature);
        assert_eq!(read, spelt, "{n}/{m}{space}{factors}");
        assert_eq!(readings.len(), 1, "{n}/{m}{space}{factors}");
        let start = format!("({n}/{m})");
        assert!(readings[0].latex.starts_with(&start), "{readings:?}");
        for tight in ["", " ", "{}", "\\!"] {
            let latex = format!("y = {n}/{m}{tight}{factors}");
            assert!(is_ambiguous(&refused(&latex, &signature)), "{latex}");
        }
    }
    for _ in 0..60 {
        let [a, b, c] = [0; 3].map(|_| draw.from(&LETTERS));
        let (n, space) = (draw.number(2, 9), draw.from(&SPACES));
        let factors = draw.from(&FACTORS);
        // A bracket or a root shows where it ends.
        for divisor in [
            format!("({n}{b})"),
            format!("\\sqrt{{{n}{b}}}"),
            format!("({b} + {c})^2"),
        ] {
            let (read, readings) =
                printed(&format!("y = {a}/{divisor}{space}{factors}"), &signature);
            let spelt = tree(&format!("y = {a}/{divisor} \\cdot {factors}"), &signature);
            assert_eq!(read, spelt);
            assert_eq!(readings.len(), 1);
            let latex = format!("y = {a}/{divisor}{factors}");
            assert!(is_ambiguous(&refused(&latex, &signature)), "{latex}");
        }
        // A space between letters ends nothing.
        let latex = format!("y = {a}/{b}{space}{c}");
        assert!(is_ambiguous(&refused(&latex, &signature)), "{latex}");
        let latex = format!("y = {a}/{n}{b}{space}{c}");
        assert!(is_ambiguous(&refused(&latex, &signature)), "{latex}");
        // The convention of papers, q/2de, which is named.
        let (read, readings) = printed(&format!("y = {a}/{n}{b}{c}"), &signature);
        assert_eq!(
            read,
            tree(
                &format!("y = {a}/{{{n}{b}{c}}}").replace(['{', '}'], ""),
                &signature
            )
        );
        let named = &readings[0].latex;
        assert!(readings.len() == 1 && named.contains("/("), "{readings:?}");
        // Nothing to choose.
        for latex in [
            format!("y = {a}/{b}"),
            format!("y = {a}/({n}{b}{c})"),
            format!("y = ({n}/{n}){b}"),
        ] {
            assert!(printed(&latex, &signature).1.is_empty(), "{latex}");
        }
    }
}

/// The same by verdicts: what is read is true as a person reads it, and false as the other reading.
#[test]
fn verdicts_follow_the_reading_of_a_slash() {
    let mut draw = Draw(2);
    let symbols = LETTERS.map(|letter| format!("'{}' = {{ positive = true }}", letter.trim()));
    let symbols: Vec<&str> = symbols.iter().map(String::as_str).collect();
    let mut equations = Vec::new();
    for _ in 0..60 {
        let (n, m) = (draw.number(1, 9), draw.number(2, 12));
        let [a, b] = [0; 2].map(|_| draw.from(&LETTERS));
        let space = draw.from(&SPACES);
        equations.push(format!("{n}/{m}{space}{a}{b} = \\frac{{{n}{a}{b}}}{{{m}}}"));
        equations.push(format!("{n}/{m}{space}{a}{b} = \\frac{{{n}}}{{{m}{a}{b}}}"));
        equations.push(format!("{a}/{m}{b}x = \\frac{{{a}}}{{{m}{b}x}}"));
        equations.push(format!("{a}/{m}{b}x = \\frac{{{a}{b}x}}{{{m}}}"));
    }
    let claims: Vec<(&str, &str)> = equations.iter().map(|e| ("claim", e.as_str())).collect();
    for (k, (_, word)) in verdicts(&document(&symbols, &claims)).iter().enumerate() {
        let expected: &[&str] = match k % 2 {
            0 => &["holds"],
            _ => &["refuted", "misprint", "holds given"],
        };
        assert!(expected.contains(word), "{}: {word}", equations[k]);
    }
}

/// With a letter `d` in the document, `\frac{d}{dx} f` is the derivative and named as such; where
/// the letter may be meant it is refused.
#[test]
fn a_letter_d_does_not_take_the_derivatives() {
    let mut draw = Draw(3);
    let mut with_d = signature(&LETTERS);
    with_d.declare(&parse_name("d", 0).expect("a name"));
    let mut defined = signature(&LETTERS);
    defined.declare_definitions("d = 2a");
    for k in 0..120 {
        let signature = if k % 2 == 0 { &with_d } else { &defined };
        let x = draw.from(&LETTERS);
        let power = ["", "^2", "^3"][k % 3];
        let body = draw.from(&["a x^2", "(x + y)", "\\cos x", "\\frac{1}{x}"]);
        let upright = tree(
            &format!("\\frac{{\\mathrm{{d}}{power}}}{{\\mathrm{{d}}{x}{power}}} {body} = 0"),
            signature,
        );
        let (read, readings) = printed(
            &format!("\\frac{{d{power}}}{{d{x}{power}}} {body} = 0"),
            signature,
        );
        assert_eq!(read, upright);
        assert_eq!(readings.len(), 1);
        for latex in [
            format!("\\frac{{d{power}}}{{d{x}{power}}} = {body}"),
            format!("\\frac{{d{power} {body}}}{{d{x}{power}}} = 0"),
            format!("a = d/d{x}"),
            format!("\\int_0^1 {body} d{x} d{x} = 0"),
        ] {
            assert!(is_ambiguous(&refused(&latex, signature)), "{latex}");
        }
        // Upright above and below, nothing is in doubt.
        let latex = format!("\\frac{{\\mathrm{{d}} {body}}}{{\\mathrm{{d}}{x}}} = d");
        assert!(printed(&latex, signature).1.is_empty());
    }
    // A product of other letters stays one.
    assert_eq!(
        tree("\\frac{ad}{de} = 1", &with_d),
        tree("\\frac{a \\cdot d}{d \\cdot e} = 1", &with_d)
    );
}

/// Conditions after a claim are supposed, and not claimed; alone they are claims.
#[test]
fn conditions_are_supposed() {
    let symbols = ["a = {}", "b = {}", "c = {}", "n = { domain = \"integer\" }"];
    let conditions = [
        ", \\quad b \\ge 0",
        ", b > 0",
        " \\text{ for } b > 0",
        " \\text{ for all } b \\neq 0",
        ", \\text{ where } b \\ge 1",
        " \\text{ if } a > b",
        ", \\text{when } 0 < b < 1",
        ", \\quad 0 < b < \\infty",
        ", \\quad a, b > 0",
        ", \\text{ for } a > 0 \\text{ and } b < 0",
        " \\text{ provided that } a + b > c",
        " \\text{ with } b > 0, \\quad c > 0",
        ", \\quad b \\ne 0, \\quad c \\le a",
        ", \\text{ for any } n \\ge 2",
    ];
    // The claim, and whether it is true of all values.
    let claims = [
        ("a + b = b + a", true),
        ("(a + b)^2 = a^2 + 2ab + b^2", true),
        ("a - (b - c) = a - b + c", true),
        ("ab = ba = 1ab", true),
        ("\\frac{ab + ac}{a} = b + c", true),
        ("a + b = b + 2a", false),
        ("(a + b)^2 = a^2 + b^2", false),
        ("a - (b - c) = a - b - c", false),
        ("a(b + c) = ab + c", false),
        ("\\frac{ab + ac}{a} = b - c", false),
    ];
    let mut equations = Vec::new();
    for (claim, _) in &claims {
        for condition in &conditions {
            equations.push(format!("{claim}{condition}"));
            equations.push(format!(
                "\\begin{{aligned}} &{claim}{condition} \\end{{aligned}}"
            ));
        }
    }
    let roles: Vec<(&str, &str)> = equations.iter().map(|e| ("claim", e.as_str())).collect();
    let text = document(&symbols, &roles);
    let audit = audit(&text, quick()).unwrap_or_else(|rejection| panic!("{rejection}"));
    assert_eq!(audit.model.equations.len(), equations.len());
    for (k, equation) in audit.model.equations.iter().enumerate() {
        let (claim, is_true) = claims[k / (2 * conditions.len())];
        let links = claim.matches('=').count();
        assert_eq!(equation.links.len(), links, "{}", equations[k]);
        assert!(!equation.assume.is_empty(), "{}", equations[k]);
        for outcome in audit.outcomes_of(k) {
            assert!(!outcome.assumed.is_empty(), "{}", equations[k]);
            let word = outcome.verdict.word().as_str();
            let wrong: &[&str] = match is_true {
                true => &["refuted", "misprint", "definition"],
                false => &["holds", "definition"],
            };
            assert!(!wrong.contains(&word), "{}: {word}", equations[k]);
        }
    }
    // An equation behind a word is a condition too; one behind a comma is a claim.
    let text = document(
        &symbols,
        &[
            ("claim", "a + c = 2c \\text{ if } a = c"),
            ("claim", "a + c = 3c \\text{ if } a = c"),
            ("claim", "a + c = c + a, a = c"),
            ("claim", "b^2 \\ge 0"),
            ("claim", "b \\ge 0"),
            ("claim", "b \\ge 0, c \\ge 0"),
        ],
    );
    let words: Vec<&str> = verdicts(&text).into_iter().map(|(_, word)| word).collect();
    assert_eq!(words[..1], ["holds"], "{words:?}");
    assert!(
        words[1] != "holds" && words[3] != "holds" && words[4] != "refuted",
        "{words:?}"
    );
    assert_eq!(words.len(), 8, "{words:?}");
    assert!(words[5..].iter().all(|word| *word != "holds"), "{words:?}");
}

/// `P_{3,4}` is not the declared letter `P_{34}`, and no entry of nothing.
#[test]
fn an_entry_that_nothing_declares_is_no_zero() {
    for (i, j) in (1..=9).flat_map(|i| (1..=9).map(move |j| (i, j))) {
        let declared = format!("'P_{{{i}{j}}}' = {{}}");
        for used in [
            format!("P_{{{i},{j}}}"),
            format!("P_{{{j}{}}}", i + 10),
            format!("P_{{{i}}}"),
        ] {
            let text = document(
                &[&declared, "a = {}"],
                &[("claim", &format!("a + {used} = {used} + a"))],
            );
            let found = errors(&text);
            assert!(
                matches!(&found[..], [only] if matches!(only.kind, DiagnosticKind::UndeclaredName { .. })),
                "{used}: {found:?}"
            );
        }
    }
}

/// A point before digits, a comma or point between them, lists of values, marks in brackets.
#[test]
fn numbers_are_numbers() {
    let mut draw = Draw(4);
    let signature = signature(&LETTERS);
    for _ in 0..100 {
        let x = draw.from(&LETTERS);
        let (n, m) = (draw.number(1, 999), draw.number(100, 999));
        assert_eq!(
            tree(&format!("y = .{n}{x}"), &signature),
            tree(&format!("y = 0.{n}{x}"), &signature)
        );
        assert_eq!(
            tree(&format!(".{n}{x} = y"), &signature),
            tree(&format!("0.{n}{x} = y"), &signature)
        );
        assert_eq!(
            tree(&format!("y = {n}{{,}}5{x}"), &signature),
            tree(&format!("y = {n}.5{x}"), &signature)
        );
        assert_eq!(
            tree(&format!("y = {n}{{,}}{m}{{,}}{m}"), &signature),
            tree(&format!("y = {n}{m}{m}"), &signature)
        );
        for latex in [
            format!("y = {n},{m}{x}"),
            format!("{n},{m} = {x}"),
            format!("y = {n}{{,}}{m}{x}"),
            format!("y = {n}.{x}"),
            format!("y = {x}.5"),
            format!("y = {x}^{{({n})}}"),
            format!("y = {x}_1^{{(n)}}"),
            "y = \\mathbf{b}_1^{(k + 1)}".to_string(),
            format!("y = \\frac.5{x}"),
        ] {
            assert!(is_ambiguous(&refused(&latex, &signature)), "{latex}");
        }
        // A power stays one.
        for exponent in ["2", "{2}", "{-2}", "{(n + 1)/2}", "{2(n + 1)}", "{(1/2)}"] {
            tree(&format!("y = {x}^{exponent}"), &signature);
        }
        tree(&format!("y = 2^{{(n)}} + e^{{({x})}}"), &signature);
    }
    for values in ["0, 1, 2", "1, 2", "-1, 1", "0, 1/2"] {
        for role in ["claim", "define"] {
            let text = document(&["x = {}"], &[(role, &format!("a = {values}"))]);
            let found = errors(&text);
            let says_nothing =
                |d: &Diagnostic| matches!(d.kind, DiagnosticKind::SaysNothing { .. });
            assert!(found.iter().any(says_nothing), "{values}: {found:?}");
        }
    }
}

/// A fence that is nearly one of the document's is one, or an error: its claim does not vanish.
#[test]
fn no_fence_vanishes() {
    let good = "```toml symbols\na = {}\n```\n\n";
    let bodies = [
        ("math", "1 claim", "a = a"),
        ("toml", "document", "title = \"T\""),
        ("statement", "s", "Words."),
    ];
    let mut tried = 0;
    for (language, rest, body) in bodies {
        let capital = language[..1].to_uppercase() + &language[1..];
        let upper = language.to_uppercase();
        let shorter = &language[..language.len() - 1];
        let mut openings = vec![
            format!("{capital} {rest}"),
            format!("{upper} {rest}"),
            format!("{language}{rest}"),
            format!("{language}1 {rest}"),
            format!("{language}:{rest}"),
            format!("{{{language}}} {rest}"),
            format!("{language}s {rest}"),
            format!("{shorter} {rest}"),
            format!("\u{200b}{language} {rest}"),
            format!("\u{feff}{language} {rest}"),
        ];
        if language != "math" {
            // Braces and marks before the word leave nothing to tell it by but a role.
            openings.remove(5);
        }
        for opening in &openings {
            for (open, close) in [
                ("```", "```"),
                ("~~~", "~~~"),
                ("`````", "`````"),
                ("   ```", "   ```"),
                ("> ```", "> ```"),
            ] {
                let line = if open.starts_with('>') { "> " } else { "" };
                let text = format!("{good}{open}{opening}\n{line}{body}\n{close}\n");
                assert!(!errors(&text).is_empty(), "{text}");
                tried += 1;
            }
        }
        let opening = format!("{language} {rest}");
        for (before, after) in [
            ("    ```", "    ```"),
            ("\t```", "\t```"),
            ("\u{feff}```", "```"),
            ("``", "``"),
            ("<div>\n```", "```\n</div>"),
            ("- a\n\n      ```", "      ```"),
            ("```text\nopen\n\n```", "```"),
            ("```math 7 claim\na = a\n```", "```"),
            ("words \u{feff}\n\u{200b}```", "```"),
        ] {
            let text = format!("{good}{before}{opening}\n{body}\n{after}\n");
            assert!(!errors(&text).is_empty(), "{text}");
            tried += 1;
        }
        // What Markdown reads as a fence is one.
        for (before, after) in [
            ("```", "```"),
            ("~~~", "~~~"),
            ("``` ", "```"),
            ("  ```", "  ```"),
            ("\u{feff}```", "```"),
            ("> ```", "> ```"),
            ("- ```", "  ```"),
        ] {
            let indent = match before.chars().next() {
                Some('>') => "> ",
                Some('-') => "  ",
                _ => "",
            };
            // A byte order mark stands at the very beginning.
            let text = format!("{before}{opening}\n{indent}{body}\n{after}\n\n{good}");
            let document = Document::parse("test.md", &text);
            let errors = document.as_ref().err();
            let only_meaning = errors.is_none_or(|e| {
                e.iter()
                    .all(|d| matches!(d.kind, DiagnosticKind::MissingMeaning { .. }))
            });
            assert!(only_meaning, "{text}: {errors:?}");
            if let Ok(document) = document {
                let read = document.equations.len() + usize::from(document.title == "T");
                assert_eq!(read, 1, "{text}");
            }
            tried += 1;
        }
    }
    assert!(tried >= 180, "{tried}");
    // Other languages, examples within longer fences, words about fences, and comments are nothing.
    for innocent in [
        "```text\nmath 1 claim\n```",
        "```matlab\na = b\n```",
        "```tex\n\\frac{a}{b}\n```",
        "```html\n<p>\n```",
        "```yaml\na: b\n```",
        "````markdown\n```math 1 claim\na = a\n```\n````",
        "~~~~\n```math 1 claim\n```\n~~~~",
        "``math`` fences hold equations.",
        "<!--\n```math 9 claim\na = 2a\n```\n-->",
        "the fence ```math LABEL ROLE``` is one",
    ] {
        assert_eq!(errors(&format!("{good}{innocent}\n")), [], "{innocent}");
    }
}

/// What a claim begins with has a meaning; a claim has a relation; operators keep their arguments.
#[test]
fn claims_do_not_turn_into_definitions() {
    let symbols = [
        "a = {}",
        "b = {}",
        "n = {}",
        "'\\mathbf{A}' = { shape = [2, 2] }",
        "'\\mathbf{B}' = { shape = [2, 2] }",
    ];
    let undefined = |claim: &str| {
        let found = errors(&document(&symbols, &[("claim", claim)]));
        let all = found.iter().all(|d| {
            // An index may be that of a letter with indices.
            let indexed = claim.contains("a_1");
            matches!(d.kind, DiagnosticKind::Undefined { .. })
                || indexed && matches!(d.kind, DiagnosticKind::UndeclaredName { .. })
        });
        assert!(all && found.len() == 1, "{claim}: {found:?}");
    };
    let mut draw = Draw(5);
    let unknown = [
        "u",
        "A",
        "a_1",
        "\\alpha",
        "\\mathbf{a}",
        "\\hat{a}",
        "c_{n-3}",
        "c_{n+1}",
        "\\dot{u}",
        "u^2",
        "f(a)",
        "\\operatorname{adj}(\\mathbf{A})",
        "\\mathrm{rank}(\\mathbf{A})",
        "g(a, b)",
    ];
    for name in unknown {
        for _ in 0..8 {
            let (n, m) = (draw.number(1, 99), draw.number(1, 99));
            let sign = draw.from(&["+", "-"]);
            undefined(&format!("{name} = {n}a {sign} {m}b"));
            undefined(&format!("a + b = b + a, \\quad {name} = {n}a {sign} {m}b"));
        }
    }
    // With another member more than the name rests on the claim.
    let text = document(
        &symbols,
        &[
            ("claim", "u = a + b = b + a"),
            ("claim", "w = a + b = b - a"),
        ],
    );
    let words: Vec<&str> = verdicts(&text).into_iter().map(|(_, word)| word).collect();
    assert_eq!(words[..3], ["definition", "holds", "definition"]);
    assert_ne!(words[3], "holds");
    // Claims without a relation.
    for claim in [
        "a",
        "a + b",
        "\\frac{a}{b}",
        "a = a, \\quad b",
        "\\det\\mathbf{A}",
        "-a",
        "a_i, \\quad i = 1(1)4",
    ] {
        let found = errors(&document(&symbols, &[("claim", claim)]));
        let says_nothing = |d: &Diagnostic| matches!(d.kind, DiagnosticKind::SaysNothing { .. });
        assert!(found.iter().any(says_nothing), "{claim}: {found:?}");
    }
    for claim in ["a = b \\text{ or } a = -b", "a = a \\text{ or } b = b"] {
        let found = errors(&document(&symbols, &[("claim", claim)]));
        let alternatives = |d: &Diagnostic| d.kind == DiagnosticKind::Alternatives;
        assert!(found.iter().any(alternatives), "{claim}: {found:?}");
    }
    // What is said of one argument is not said of another.
    for operator in [
        "\\operatorname{adj}",
        "\\mathrm{rank}",
        "F",
        "\\mathbf{G}",
        "\\Phi",
    ] {
        for definition in ["7\\mathbf{A}", "\\mathbf{A}\\mathbf{A}", "\\mathbf{A}^T"] {
            let text = document(
                &symbols,
                &[
                    (
                        "define",
                        &format!("{operator}(\\mathbf{{A}}) = {definition}"),
                    ),
                    (
                        "claim",
                        &format!("{operator}(\\mathbf{{B}}) = {operator}(\\mathbf{{A}})"),
                    ),
                    (
                        "claim",
                        &format!("{operator}(\\mathbf{{B}}) = {definition}"),
                    ),
                    (
                        "claim",
                        &format!("{operator}(\\mathbf{{A}}) = {definition}"),
                    ),
                ],
            );
            let words = verdicts(&text);
            let of = |label: &str| {
                let mut words = words.iter();
                words.find(|(l, _)| l == label).map(|(_, word)| *word)
            };
            assert_eq!(of("4"), Some("holds"), "{text}");
            assert!(
                of("2") != Some("holds") && of("3") != Some("holds"),
                "{words:?}"
            );
        }
    }
}

/// One error for each cause, all at once, with words that are true.
#[test]
fn errors_are_complete_and_true() {
    for occurrences in 1..40 {
        let latex = vec!["q"; occurrences].join(" + ");
        let found = errors(&document(
            &["a = {}"],
            &[
                ("claim", &format!("a = {latex}")),
                ("claim", "a = q"),
                ("claim", "q = 2a"),
            ],
        ));
        assert_eq!(found.len(), 1, "{found:?}");
    }
    let text = document(
        &["a = {}"],
        &[
            ("claim", "a = \\foo + \\foo"),
            ("prove", "a = a"),
            ("claim", "(a = a"),
        ],
    );
    let found = errors(&text);
    let has = |kind: fn(&DiagnosticKind) -> bool| found.iter().filter(|d| kind(&d.kind)).count();
    assert_eq!(
        has(|k| matches!(k, DiagnosticKind::UnknownCommand { .. })),
        1
    );
    assert_eq!(has(|k| matches!(k, DiagnosticKind::UnknownRole { .. })), 1);
    assert_eq!(has(|k| matches!(k, DiagnosticKind::Unbalanced { .. })), 1);
    let long = "9".repeat(2_000);
    let found = errors(&document(&["a = {}"], &[("claim", &format!("a = {long}"))]));
    assert!(
        matches!(
            found[0].kind,
            DiagnosticKind::LongNumber { digits: 2_000, .. }
        ),
        "{found:?}"
    );
    // Every character that cannot be shown is named by its code point, and reaches nobody as itself.
    let unseen = (0u32..0x20)
        .chain(0x7F..0xA0)
        .chain([0xAD, 0x61C, 0xFEFF])
        .chain(0x200B..=0x200F);
    let unseen = unseen.chain(0x2028..=0x202E).chain(0x2060..=0x2069);
    for c in unseen.filter_map(char::from_u32) {
        assert_eq!(
            printable_line(&c.to_string()),
            format!("<U+{:04X}>", u32::from(c))
        );
        let text = document(&["a = {}"], &[("claim", &format!("a = {c}b"))]);
        let rejection = match Document::parse("x\u{1b}[31m.md", &text) {
            Ok(document) => match Audit::of(&document, quick()) {
                Ok(_) => panic!("{c:?}"),
                Err(rejection) => rejection.to_string(),
            },
            Err(diagnostics) => {
                rederive::diagnostic::render("x\u{1b}[31m.md", &text, &diagnostics, false)
            }
        };
        assert_eq!(printable(&rejection), rejection, "{c:?}");
        if !c.is_whitespace() {
            assert!(
                rejection.contains(&format!("U+{:04X}", u32::from(c))),
                "{rejection}"
            );
        }
    }
}

/// Claims that hold of all values, with what a condition on b would not change.
const TRUE_CLAIMS: [&str; 6] = [
    "2a = a + a",
    "(a + b)^2 = a^2 + 2ab + b^2",
    "a - (b - c) = a - b + c",
    "ab = ba",
    "a < a + 1",
    "(a + 1)^2 > 2a",
];

/// Comparisons of declared letters.
const COMPARISONS: [&str; 6] = [
    "b > 0",
    "b \\ge 1",
    "b \\ne 0",
    "0 < b < 1",
    "b > c",
    "c \\le b",
];

/// What the print says of a clause.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Said {
    Supposed,
    Claimed,
    Asked,
}

/// How a clause is joined to the claim before it, and what it is then; an `&` is a column.
const JOINTS: [(&str, Said); 24] = [
    (", \\quad ", Said::Supposed),
    (", ", Said::Supposed),
    (" \\text{ for } ", Said::Supposed),
    (", \\text{ where } ", Said::Supposed),
    (", \\text{ if } ", Said::Supposed),
    (" \\\\ \\text{for } ", Said::Supposed),
    (" && \\text{for } ", Said::Supposed),
    (" \\quad (", Said::Supposed),
    (", \\quad (", Said::Supposed),
    (", \\text{ so that } ", Said::Claimed),
    (" \\text{ so that } ", Said::Claimed),
    (", \\text{ hence } ", Said::Claimed),
    (" \\text{ and thus } ", Said::Claimed),
    (", \\text{ therefore, } ", Said::Claimed),
    (" \\text{ and } ", Said::Claimed),
    (", \\text{ and } ", Said::Claimed),
    (". \\quad ", Said::Claimed),
    (" \\\\ ", Said::Claimed),
    (". \\\\ ", Said::Claimed),
    ("; \\quad ", Said::Asked),
    (" \\qquad ", Said::Asked),
    (" && ", Said::Asked),
    (", && ", Said::Asked),
    (", \\\\ ", Said::Asked),
];

/// A comparison after a claim supposes only where words or marks say so; else it is claimed, or asked about.
#[test]
fn a_claim_does_not_vanish_into_a_condition() {
    let symbols = ["a = {}", "b = {}", "c = {}"];
    let mut read = Vec::new();
    for (k, claim) in TRUE_CLAIMS.iter().enumerate() {
        for (j, (joint, said)) in JOINTS.iter().enumerate() {
            let comparison = COMPARISONS[(k + j) % COMPARISONS.len()];
            let close = if joint.ends_with('(') { ")" } else { "" };
            let latex =
                format!("\\begin{{aligned}} {claim}{joint}{comparison}{close} \\end{{aligned}}");
            // A comparison that follows from a claim goes on with claims.
            let more = format!("{claim}, \\text{{ so that }} {comparison}, \\quad c > 0");
            match said {
                Said::Asked => {
                    assert!(asked(&symbols, &latex), "{latex}");
                    assert!(asked(&symbols, &more), "{more}");
                }
                Said::Supposed | Said::Claimed => read.push((latex, *said)),
            }
        }
    }
    let claims: Vec<(&str, &str)> = read.iter().map(|(l, _)| ("claim", l.as_str())).collect();
    let text = document(&symbols, &claims);
    let audit = audit(&text, quick()).unwrap_or_else(|rejection| panic!("{rejection}"));
    for (k, equation) in audit.model.equations.iter().enumerate() {
        let (latex, said) = &read[k];
        let supposed = *said == Said::Supposed;
        assert_eq!(equation.assume.is_empty(), !supposed, "{latex}");
        let mut words = audit.outcomes_of(k).map(|o| o.verdict.word().as_str());
        let all_hold = words.all(|word| word == "holds");
        assert_eq!(all_hold, supposed, "{latex}");
    }
    assert!(read.len() > 100);
}

fn asked(symbols: &[&str], claim: &str) -> bool {
    asked_after(symbols, &[], claim)
}

/// Whether both readings of a claim are given back, beside these definitions.
fn asked_after(symbols: &[&str], definitions: &[&str], claim: &str) -> bool {
    let mut equations: Vec<(&str, &str)> = definitions.iter().map(|d| ("define", *d)).collect();
    equations.push(("claim", claim));
    let kinds: Vec<_> = errors(&document(symbols, &equations))
        .into_iter()
        .map(|d| d.kind)
        .collect();
    is_ambiguous(&kinds)
}

/// What follows a condition is one too, or both readings are given back.
#[test]
fn the_rest_of_a_condition_is_no_claim() {
    let symbols = ["a = {}", "b = {}", "c = {}"];
    let first = [
        " \\text{ for } a = b",
        " \\text{ for } a > b",
        ", \\text{ if } a = 1",
        ", \\text{ where } a > 0",
        ", \\quad a > 0",
        ", \\quad a > 0, \\quad b > 0",
    ];
    let rest = ["b = 1", "c = a", "c = b = 1", "a = c"];
    for claim in TRUE_CLAIMS {
        for first in first {
            for rest in rest {
                for comma in [", ", ", \\quad ", "; "] {
                    let latex = format!("{claim}{first}{comma}{rest}");
                    assert!(asked(&symbols, &latex), "{latex}");
                }
                // What "and" joins to a condition is one.
                let latex = format!("{claim}{first} \\text{{ and }} {rest}");
                let found = audit(&document(&symbols, &[("claim", &latex)]), quick());
                let found = found.unwrap_or_else(|rejection| panic!("{latex}: {rejection}"));
                assert_eq!(found.model.equations[0].links.len(), 1, "{latex}");
                let latex = format!("{claim} \\quad ({rest})");
                assert!(asked(&symbols, &latex), "{latex}");
            }
        }
    }
    // What comes first and only compares may be what the rest is said under.
    for first in COMPARISONS {
        for joint in [", ", ", \\quad ", "; ", ", \\text{ so that } ", " \\qquad "] {
            for claim in ["|a| = a", "a^2 > -1", "a + b = b + a"] {
                let latex = format!("{first}{joint}{claim}");
                assert!(asked(&symbols, &latex), "{latex}");
            }
        }
        let latex = format!("{first} \\text{{ and }} a + b = b + a");
        let found = audit(&document(&symbols, &[("claim", &latex)]), quick());
        let found = found.unwrap_or_else(|rejection| panic!("{latex}: {rejection}"));
        assert!(found.model.equations[0].assume.is_empty(), "{latex}");
    }
    // Behind a condition that comes first stands the claim.
    for latex in [
        "\\text{if } a > 0, \\text{ then } |a| = a",
        "\\text{if } a > 0, \\quad |a| = a",
        "\\text{for } a > 0, b > 0: \\quad |ab| = ab",
    ] {
        let Ok(found) = audit(&document(&symbols, &[("claim", latex)]), quick()) else {
            assert!(latex.contains(':'), "{latex}");
            continue;
        };
        assert_eq!(found.model.equations[0].links.len(), 1, "{latex}");
        assert_eq!(
            found.outcomes[0].verdict.word().as_str(),
            "holds",
            "{latex}"
        );
    }
}

/// `F^{-1}(x)` is the inverse function or one over it; `F^2(x)` is a square, which is named.
#[test]
fn powers_of_functions_are_asked_about_or_named() {
    let symbols = [
        "x = {}",
        "y = {}",
        "'\\xi' = {}",
        "t = {}",
        "q = { function_of = \"t\" }",
    ];
    let bodies = [
        "2\\xi",
        "\\xi + 1",
        "\\exp \\xi",
        "y\\xi",
        "\\frac{1}{1 + \\xi^2}",
        "\\xi^3",
    ];
    let names = ["F", "G", "h", "\\Phi", "F_1", "\\tilde{f}"];
    let arguments = ["x", "\\xi", "2\\xi", "\\xi + y", "\\xi^2", "1"];
    let products = ["2x", "x + y", "y^2", "xy"];
    for (k, body) in bodies.iter().enumerate() {
        for (j, name) in names.iter().enumerate() {
            let argument = arguments[(k + j) % arguments.len()];
            let definition = format!("{name}(\\xi) = {body}");
            let doubtful = [
                format!("{name}^{{-1}}({argument}) = x"),
                format!("y = {name}^{{-1}}({name}({argument}))"),
                format!("x {name}^{{-1}} = x"),
                format!("y + 2{name}^{{-1}}(\\xi)^2 = x"),
            ];
            // Not even a function with an argument: the square may be a factor.
            let product = products[(k + j) % products.len()];
            let factor = format!("{name}^2({product}) = x");
            for latex in doubtful.into_iter().chain([factor]) {
                assert!(asked_after(&symbols, &[&definition], &latex), "{latex}");
            }
            let mut signature = signature(&["x", "y", "\\xi"]);
            signature.declare_definitions(&definition);
            let (square, readings) = printed(&format!("{name}^2({argument}) = x"), &signature);
            let spelt = tree(&format!("{name}({argument})^2 = x"), &signature);
            assert_eq!(square, spelt);
            assert_eq!(readings.len(), 1, "{name}^2({argument})");
            let (_, readings) = printed(&format!("{name}({argument})^{{-1}} = x"), &signature);
            assert!(readings.is_empty(), "{readings:?}");
        }
    }
    // A function of the time cannot be put into itself, and a matrix has no inverse but one.
    let mut of_time = signature(&["x", "y", "t"]);
    let t = parse_name("t", 0).expect("a name");
    for name in ["q", "\\mathbf{M}"] {
        of_time.declare_function(
            &parse_name(name, 0).expect("a name"),
            std::slice::from_ref(&t),
        );
    }
    for latex in [
        "q^2(t) = x",
        "\\mathbf{M}^{-1}(t) = x",
        "\\mathbf{M}^2(t) = x",
    ] {
        assert!(printed(latex, &of_time).1.is_empty(), "{latex}");
    }
}

/// Where another letter than its own varies, a function without its argument is not its value at its own.
#[test]
fn functions_need_their_arguments_where_these_matter() {
    let symbols = ["x = {}", "y = {}", "'\\xi' = {}", "a = { positive = true }"];
    let bodies = [
        "\\xi^3",
        "2\\xi + 1",
        "a\\xi^2",
        "\\exp \\xi",
        "\\cos a\\xi",
    ];
    for (k, body) in bodies.iter().enumerate() {
        for name in ["f", "F", "\\psi", "u_1"] {
            let definition = format!("{name}(\\xi) = {body}");
            let made_of = format!("h = {name} + 1");
            let v = ["x", "y"][k % 2];
            for latex in [
                format!("\\frac{{\\mathrm{{d}}{name}}}{{\\mathrm{{d}}{v}}} = 0"),
                format!("\\frac{{\\mathrm{{d}}^2{name}}}{{\\mathrm{{d}}{v}^2}} = 0"),
                format!("\\frac{{\\mathrm{{d}}}}{{\\mathrm{{d}}{v}}}(x + {name}) = 1"),
                format!("\\frac{{\\partial {name}}}{{\\partial {v}}} = 0"),
                format!("\\int_0^1 {name}\\,\\mathrm{{d}}{v} = {name}"),
                format!("\\int_0^1 {v}{name}\\,\\mathrm{{d}}{v} = \\frac{{1}}{{2}}{name}"),
                format!("\\int_0^1 2{name}'\\,\\mathrm{{d}}{v} = 0"),
                format!("{v} \\to 0, \\quad {name} \\to 0"),
                format!("{v} \\to 1, \\quad {v}{name} \\to {name}"),
                format!("\\sum_{{{v}=1}}^2 {name} = 2{name}"),
                format!("\\frac{{\\mathrm{{d}}h}}{{\\mathrm{{d}}{v}}} = 0"),
                format!("\\int_0^1 h^2\\,\\mathrm{{d}}{v} = h^2"),
            ] {
                assert!(
                    asked_after(&symbols, &[&definition, &made_of], &latex),
                    "{latex}: {definition}"
                );
            }
            let mut read = vec![
                format!("\\frac{{\\mathrm{{d}}{name}}}{{\\mathrm{{d}}\\xi}} = {name}'"),
                format!("\\frac{{\\mathrm{{d}}}}{{\\mathrm{{d}}{v}}} {name}({v}) = {name}'({v})"),
                format!("\\xi \\to 0, \\quad {name} \\to {name}(0)"),
                format!("\\sum_{{k=1}}^3 {name} = 3{name}"),
                format!("{name} = {body}"),
            ];
            if body.contains('a') {
                read.push(format!("\\frac{{\\partial {name}}}{{\\partial a}} - \\frac{{\\partial {name}(\\xi)}}{{\\partial a}} = 0"));
            }
            let mut equations = vec![("define", definition.as_str())];
            equations.extend(read.iter().map(|latex| ("claim", latex.as_str())));
            let found = errors(&document(&symbols, &equations));
            assert_eq!(found, [], "{definition}");
        }
    }
}

/// A bracket directly behind the bracket of a function may belong to its argument.
#[test]
fn a_bracket_behind_the_bracket_of_a_function_is_asked_about() {
    let mut draw = Draw(6);
    let signature = signature(&LETTERS);
    let functions = [
        "\\operatorname{Re}",
        "\\operatorname{Im}",
        "\\operatorname{tr}",
        "\\det",
        "\\ln",
        "\\sin",
        "\\cos",
        "\\exp",
        "\\tan",
        "\\cosh",
        "\\Re",
        "\\sin^2",
        "\\ln^2",
    ];
    for function in functions {
        for _ in 0..10 {
            let [a, b, c] = [0; 3].map(|_| draw.from(&LETTERS));
            let space = draw.from(&SPACES);
            for latex in [
                format!("y = {function}({a} + {b})({a} - {b})"),
                format!("y = {function}({a})({c})"),
                format!("{function}[{a}]({b} + 1) = {c}"),
                format!("{function}\\left({a}\\right)\\left[{b} + {c}\\right] = 0"),
                format!("y = 2{function}({a})({b})^2"),
            ] {
                assert!(is_ambiguous(&refused(&latex, &signature)), "{latex}");
            }
            let spelt = tree(
                &format!("y = {function}({a}) \\cdot ({b} + {c})"),
                &signature,
            );
            let spaced = tree(
                &format!("y = {function}({a}){space}({b} + {c})"),
                &signature,
            );
            assert_eq!(spelt, spaced);
            for latex in [
                format!("y = {function}({a}){b}"),
                format!("y = {function}({a})\\cos({b})"),
                format!("y = ({b} + {c}){function}({a})"),
                format!("y = {function}({a})/({b} + {c})"),
                format!("y = {function}(({a})({b}))"),
            ] {
                tree(&latex, &signature);
            }
        }
    }
}

/// The dot between two columns is their scalar product, which is named; a cross and a square are asked about.
#[test]
fn dots_between_columns_are_scalar_products() {
    let mut sizes = Vec::new();
    for n in ["2", "3"] {
        sizes.push(vec![
            format!("'\\mathbf{{u}}' = {{ shape = [{n}, 1] }}"),
            format!("'\\mathbf{{v}}' = {{ shape = [{n}, 1] }}"),
            format!("'\\mathbf{{w}}' = {{ shape = [{n}, 1] }}"),
            format!("'\\mathbf{{A}}' = {{ shape = [{n}, {n}] }}"),
            format!("'\\mathbf{{B}}' = {{ shape = [{n}, {n}] }}"),
            "a = {}".to_owned(),
            "b = {}".to_owned(),
        ]);
    }
    let columns = ["\\mathbf{u}", "\\mathbf{v}", "\\mathbf{w}"];
    for symbols in &sizes {
        let symbols: Vec<&str> = symbols.iter().map(String::as_str).collect();
        let mut claims: Vec<(String, bool)> = Vec::new();
        for x in columns {
            for y in columns.into_iter().filter(|y| *y != x) {
                let z = columns
                    .into_iter()
                    .find(|z| *z != x && *z != y)
                    .unwrap_or(x);
                for (left, right) in [
                    (format!("{x}\\cdot {y}"), format!("{x}^T{y}")),
                    (format!("{x}\\cdot {y}"), format!("{y}\\cdot {x}")),
                    (format!("a{x}\\cdot {y}"), format!("{x}\\cdot a{y}")),
                    (
                        format!("({x} + {y})\\cdot {z}"),
                        format!("{x}\\cdot {z} + {y}\\cdot {z}"),
                    ),
                    (
                        format!("\\mathbf{{A}}{x}\\cdot {y}"),
                        format!("{x}\\cdot\\mathbf{{A}}^T{y}"),
                    ),
                    (
                        format!("(\\mathbf{{A}}{x})\\cdot {y}"),
                        format!("{y}^T\\mathbf{{A}}{x}"),
                    ),
                    (format!("({x}\\cdot {y}){z}"), format!("{z}{x}^T{y}")),
                    (format!("a\\cdot {x}"), format!("{x}a")),
                    (format!("{x}\\cdot {y}^T"), format!("{x}{y}^T")),
                    (format!("{x}^T\\cdot {y}"), format!("{x}^T{y}")),
                    (
                        "\\mathbf{A}\\cdot\\mathbf{B}".to_owned(),
                        "\\mathbf{A}\\mathbf{B}".to_owned(),
                    ),
                    (
                        format!("\\mathbf{{A}}\\cdot {x}"),
                        format!("\\mathbf{{A}}{x}"),
                    ),
                ] {
                    claims.push((format!("{left} = {right}"), true));
                    claims.push((format!("2 {left} = {right}"), false));
                }
                for latex in [
                    format!("{x}\\times {y} = -{y}\\times {x}"),
                    format!("a = {x}\\cdot({y}\\times {z})"),
                    format!("{x}^2 = {x}^T{x}"),
                    format!("a = b({x} + {y})^2"),
                    format!("a{x}\\times b{y} = \\mathbf{{0}}"),
                    format!("a = {x}\\cdot\\mathbf{{A}}\\cdot {y}"),
                    format!("a = {x}\\cdot a\\mathbf{{A}}"),
                    format!("a = \\mathbf{{A}}\\times {y}"),
                ] {
                    assert!(asked(&symbols, &latex), "{latex}");
                }
            }
        }
        let equations: Vec<(&str, &str)> =
            claims.iter().map(|(l, _)| ("claim", l.as_str())).collect();
        let found = verdicts(&document(&symbols, &equations));
        assert_eq!(found.len(), claims.len());
        for ((latex, is_true), (_, word)) in claims.iter().zip(&found) {
            match is_true {
                true => assert_eq!(*word, "holds", "{latex}"),
                false => assert!(
                    matches!(*word, "refuted" | "misprint" | "holds given"),
                    "{latex}: {word}"
                ),
            }
        }
    }
    // Columns that are printed entry by entry, and bold letters whose shape is not printed.
    let symbols = ["a = {}", "b = {}", "'\\mathbf{A}' = { shape = [2, 2] }"];
    let definitions = [
        "\\mathbf{p} = \\begin{bmatrix} a \\\\ b \\end{bmatrix}",
        "\\mathbf{q} = \\mathbf{A}\\mathbf{p}",
        "\\mathbf{C} = \\begin{bmatrix} a & b \\\\ b & a \\end{bmatrix}",
    ];
    for latex in [
        "\\mathbf{p}\\cdot\\mathbf{q} = \\mathbf{p}^T\\mathbf{q}",
        "\\mathbf{q}\\cdot\\mathbf{p} = a",
        "\\mathbf{q}\\cdot\\mathbf{q} = a",
        "\\mathbf{p}\\times\\mathbf{q} = a",
        "\\mathbf{p}^2 = a^2 + b^2",
    ] {
        assert!(asked_after(&symbols, &definitions, latex), "{latex}");
    }
    let mut equations: Vec<(&str, &str)> = definitions.iter().map(|d| ("define", *d)).collect();
    equations.extend([
        ("claim", "\\mathbf{p}\\cdot\\mathbf{p} = a^2 + b^2"),
        (
            "claim",
            "\\mathbf{C}\\cdot\\mathbf{p} = \\mathbf{C}\\mathbf{p}",
        ),
        ("claim", "\\mathbf{C}^2 = \\mathbf{C}\\mathbf{C}"),
        (
            "claim",
            "\\mathbf{p}\\cdot\\mathbf{C}\\mathbf{p} = \\mathbf{p}^T\\mathbf{C}\\mathbf{p}",
        ),
    ]);
    let found = verdicts(&document(&symbols, &equations));
    assert!(
        found
            .iter()
            .all(|(_, word)| matches!(*word, "holds" | "definition")),
        "{found:?}"
    );
}

/// Logarithms without a base, expectations that may be products, indices with a zero before them.
#[test]
fn logarithms_expectations_and_indices_are_asked_about() {
    let mut draw = Draw(7);
    let plain = signature(&LETTERS);
    for _ in 0..40 {
        let [a, b] = [0; 2].map(|_| draw.from(&LETTERS));
        let n = draw.number(2, 99);
        for latex in [
            format!("\\log {n} = {a}"),
            format!("y = {n}\\log {a}"),
            format!("\\log({a}{b}) = \\log {a} + \\log {b}"),
            format!("y = \\mathrm{{log}}({a})"),
            format!("y = \\log^2 {a}"),
        ] {
            assert!(is_ambiguous(&refused(&latex, &plain)), "{latex}");
        }
        tree(&format!("y = {n}\\ln {a} + \\ln {b}"), &plain);
        // The letter E of a table or an equation, and one that runs.
        let mut table = plain.clone();
        table.declare(&parse_name("E", 0).expect("a name"));
        let mut defined = plain.clone();
        defined.declare_definitions(&format!("E = {n}"));
        for latex in [
            format!("E\\{{{a} + {b}\\}} = y"),
            format!("y = {n}E\\{{{a}\\}}"),
            format!("y = E\\left\\{{{a} - 1\\right\\}}"),
        ] {
            for signature in [&table, &defined] {
                assert!(is_ambiguous(&refused(&latex, signature)), "{latex}");
            }
            tree(&latex, &plain);
        }
        let latex = format!("\\sum_{{E=1}}^{n} E\\{{{a}\\}} = y")
            .replace(&format!("^{n}"), &format!("^{{{n}}}"));
        assert!(is_ambiguous(&refused(&latex, &plain)), "{latex}");
        for signature in [&table, &defined, &plain] {
            tree(&format!("y = E({a} + {b})"), signature);
        }
    }
    for k in 1..=9 {
        let symbols = [
            format!("A_{k} = {{}}"),
            "'\\mathbf{B}' = { shape = [9, 9] }".to_owned(),
        ];
        let symbols: Vec<&str> = symbols.iter().map(String::as_str).collect();
        for latex in [format!("A_{{0{k}}} = 0"), format!("A_{k} = A_{{00{k}}}")] {
            let found = errors(&document(&symbols, &[("claim", &latex)]));
            let named = |d: &Diagnostic| {
                matches!(&d.kind, DiagnosticKind::UndeclaredName { name } | DiagnosticKind::Undefined { name }
                    if name.contains(&format!("0{k}")))
            };
            assert!(
                !found.is_empty() && found.iter().all(named),
                "{latex}: {found:?}"
            );
        }
    }
}
