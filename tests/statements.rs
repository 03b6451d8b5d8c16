//! Statements in words: every predicate with a case where it holds, and with mutations (the other
//! direction, another letter, another quantity) that must not; the exact numbers that loose ones
//! carry; and what is refused.

use rederive::audit::Audit;
use rederive::check::Options;
use rederive::diagnostic::DiagnosticKind;
use rederive::document::{Document, Predicate, VerdictWord};
use rederive::verdict::statement::{Fact, Loose as Short, Measure, StatementOutcome};
use rederive::verdict::statement::{Sign, Subject};
use std::collections::BTreeSet;

/// Three positive letters, and a quantity.
fn document(quantity: &str, settings: &str) -> String {
    format!(
        "```toml symbols\n\
         x = {{ unit = \"m\", positive = true, value = \"2\", meaning = \"\" }}\n\
         y = {{ unit = \"s\", positive = true, value = \"3\", meaning = \"\" }}\n\
         z = {{ unit = \"1\", positive = true, meaning = \"without a value\" }}\n\
         ```\n\
         ```math 1 define\nf = {quantity}\n```\n\
         ```statement S\nAs printed.\n```\n\
         ```toml S\n{settings}\n```\n"
    )
}

fn audit(text: &str) -> Audit {
    let document = Document::parse("test.md", text).unwrap_or_else(|diagnostics| {
        let shown = rederive::diagnostic::render("test.md", text, &diagnostics, false);
        panic!("{shown}")
    });
    Audit::of(&document, Options::default()).unwrap_or_else(|r| panic!("{r}"))
}

fn outcome(quantity: &str, settings: &str) -> StatementOutcome {
    let audit = audit(&document(quantity, settings));
    assert_eq!(audit.statements.len(), 1, "{settings}");
    audit.statements[0].clone()
}

struct Case {
    predicate: &'static str,
    quantity: &'static str,
    arguments: &'static str,
    word: VerdictWord,
}

const fn case(
    predicate: &'static str,
    quantity: &'static str,
    arguments: &'static str,
    word: VerdictWord,
) -> Case {
    Case {
        predicate,
        quantity,
        arguments,
        word,
    }
}

use VerdictWord::{Holds, Loose, Refuted, Undecided};

/// The reference point is x = 2, y = 3; z has no value. After a case that holds come its mutations.
const CASES: &[Case] = &[
    case("positive", r"x^2 - xy + y^2", "", Holds),
    // A changed sign, and one that is positive at the reference point only.
    case("positive", r"x^2 - y^2", "", Refuted),
    case("positive", r"y - x", "", Loose),
    case("positive", r"x - x", "", Refuted),
    case("positive", r"(x - y)^2", "", Loose),
    case(
        "positive",
        r"y - x",
        "box = \"x\"\ntimes = [\"1/2\", \"2\"]\nover = \"box\"",
        Loose,
    ),
    case(
        "positive",
        r"y - x",
        "box = \"x\"\ntimes = [\"1/2\", \"5/4\"]\nover = \"box\"",
        Holds,
    ),
    case("increasing in", r"x^2y - \frac{y}{x}", "in = \"x\"", Holds),
    case(
        "decreasing in",
        r"x^2y - \frac{y}{x}",
        "in = \"x\"",
        Refuted,
    ),
    case("increasing in", r"\frac{y}{x}", "in = \"x\"", Refuted),
    case("increasing in", r"y", "in = \"x\"", Refuted),
    case("increasing in", r"x + \frac{1}{x}", "in = \"x\"", Loose),
    // Its derivative is zero at single points only: it increases strictly.
    case("increasing in", r"(x - y)^3", "in = \"x\"", Holds),
    case("increasing in", r"xz", "in = \"x\"", Holds),
    case("decreasing in", r"\frac{y}{x}", "in = \"x\"", Holds),
    case("increasing in", r"\frac{y}{x}", "in = \"y\"", Holds),
    case("decreasing in", r"\frac{y}{x}", "in = \"y\"", Refuted),
    case("decreasing in", r"x + \frac{9}{x}", "in = \"x\"", Loose),
    // It turns at 1.025 times the reference value.
    case(
        "increasing in",
        r"x + \frac{4.2025}{x}",
        "in = \"x\"",
        Loose,
    ),
    case(
        "increasing in",
        r"x + \frac{4.2025}{x}",
        "in = \"x\"\ntolerance = \"1/50\"",
        Refuted,
    ),
    case("not monotone in", r"x + \frac{1}{x}", "in = \"x\"", Holds),
    case(
        "not monotone in",
        r"x + \frac{1}{x} + y",
        "in = \"y\"",
        Refuted,
    ),
    case("not monotone in", r"x^3", "in = \"x\"", Refuted),
    // Only for other values of y than the reference.
    case(
        "not monotone in",
        r"(y - 4)x - (y - 4)x^2 + 9x + x^2 - 9x^2 + 9x^2",
        "in = \"x\"",
        Loose,
    ),
    case("convex in", r"x^3 + \frac{y}{x}", "in = \"x\"", Holds),
    case("convex in", r"x^3 + \frac{y}{x}", "in = \"y\"", Refuted),
    case("convex in", r"-x^2", "in = \"x\"", Refuted),
    case("convex in", r"x^3 - x^2", "in = \"x\"", Loose),
    case("has a minimum in", r"xy + \frac{1}{x}", "in = \"x\"", Holds),
    case(
        "has a maximum in",
        r"xy + \frac{1}{x}",
        "in = \"x\"",
        Refuted,
    ),
    case(
        "has a minimum in",
        r"xy + \frac{1}{x}",
        "in = \"y\"",
        Refuted,
    ),
    case(
        "has a minimum in",
        r"xy - \frac{1}{x}",
        "in = \"x\"",
        Refuted,
    ),
    case(
        "has a minimum in",
        r"\frac{y - 1}{x} + x",
        "in = \"x\"",
        Loose,
    ),
    case("has a maximum in", r"xy - x^2", "in = \"x\"", Holds),
    case("has a minimum in", r"xy - x^2", "in = \"x\"", Refuted),
    case(
        "has a maximum in",
        r"xy - \frac{1}{x}",
        "in = \"x\"",
        Refuted,
    ),
    case("minimal at", r"x + \frac{4}{x}", "in = \"x\"", Holds),
    case("minimal at", r"x^2 - 2xy", "in = \"x\"\nat = \"y\"", Holds),
    case(
        "maximal at",
        r"x^2 - 2xy",
        "in = \"x\"\nat = \"y\"",
        Refuted,
    ),
    case(
        "minimal at",
        r"x^2 - 2xy",
        "in = \"x\"\nat = \"2y\"",
        Refuted,
    ),
    case(
        "minimal at",
        r"x^2 - 2xy",
        "in = \"y\"\nat = \"x\"",
        Refuted,
    ),
    // Right at the reference values only; and one twentieth off.
    case("minimal at", r"x^2 - 2xy", "in = \"x\"\nat = \"3\"", Loose),
    case(
        "minimal at",
        r"x^2 - 2xy",
        r#"in = "x"
at = '\frac{y^2}{3}'"#,
        Loose,
    ),
    case(
        "minimal at",
        r"x^2 - 2xy",
        r#"in = "x"
at = '\frac{21y}{20}'"#,
        Loose,
    ),
    case("minimal at", r"x^2 - 2xy", "in = \"x\"", Refuted),
    case(
        "minimal at",
        r"x^2 - 2xy",
        "in = \"x\"\ntolerance = \"1/2\"",
        Loose,
    ),
    case("maximal at", r"2xy - x^2", "in = \"x\"\nat = \"y\"", Holds),
    case("maximal at", r"2xy - x^2", "in = \"x\"", Refuted),
    case("nearly minimal at", r"x + \frac{5}{x}", "in = \"x\"", Holds),
    case(
        "nearly minimal at",
        r"x + \frac{50}{x}",
        "in = \"x\"",
        Refuted,
    ),
    case("nearly minimal at", r"\frac{1}{x}", "in = \"x\"", Refuted),
    case("nearly minimal at", r"xy - x^2", "in = \"x\"", Refuted),
    case(
        "least at the lower bound of",
        r"x^2 + y",
        "in = \"x\"",
        Holds,
    ),
    case(
        "least at the lower bound of",
        r"\frac{1}{x} + y",
        "in = \"x\"",
        Refuted,
    ),
    case(
        "least at the lower bound of",
        r"x + \frac{4}{x}",
        "in = \"x\"",
        Holds,
    ),
    case(
        "least at the lower bound of",
        r"x + \frac{y}{x}",
        "in = \"x\"",
        Loose,
    ),
    case(
        "least at the lower bound of",
        r"x + \frac{5}{x}",
        "in = \"x\"",
        Refuted,
    ),
    case(
        "worse at the minimum of",
        r"x + \frac{8}{x}",
        r#"in = "x"
minimum_of = 'x + \frac{2}{x}'"#,
        Holds,
    ),
    case(
        "worse at the minimum of",
        r"x + \frac{8}{x}",
        r#"in = "x"
minimum_of = 'x + \frac{8}{x} + y'"#,
        Refuted,
    ),
    case(
        "worse at the minimum of",
        r"x + \frac{8}{x}",
        r#"in = "x"
minimum_of = 'x + \frac{7}{x}'"#,
        Refuted,
    ),
    case(
        "worse at the minimum of",
        r"x + \frac{8}{x}",
        r#"in = "x"
minimum_of = 'x + \frac{y^3}{x}'"#,
        Loose,
    ),
    case(
        "worse at the minimum of",
        r"x + \frac{8}{x}",
        r#"in = "x"
minimum_of = 'x'"#,
        Undecided,
    ),
    case("independent of", r"y + z", "in = \"x\"", Holds),
    case(
        "independent of",
        r"\frac{x^2y - xy}{x^2 - x}",
        "in = \"x\"",
        Holds,
    ),
    case("independent of", r"y + z", "in = \"y\"", Refuted),
    case("independent of", r"y + \frac{x}{10}", "in = \"x\"", Loose),
    case(
        "independent of",
        r"y + \frac{x}{10}",
        "in = \"x\"\ntolerance = \"1/100\"",
        Refuted,
    ),
    case("independent of", r"y + x", "in = \"x\"", Refuted),
    case(
        "depends only on",
        r"\frac{xyz}{z}",
        "in = [\"x\", \"y\"]",
        Holds,
    ),
    case("depends only on", r"\frac{xyz}{z}", "in = \"x\"", Refuted),
    case("depends only on", r"x", "in = [\"x\", \"y\"]", Refuted),
    case("depends only on", r"xyz", "in = [\"x\", \"y\"]", Refuted),
    case(
        "depends only on",
        r"xyz",
        "in = \"x\"\nnormalised = true",
        Holds,
    ),
    case(
        "depends only on",
        r"xz + y",
        "in = \"x\"\nnormalised = true",
        Refuted,
    ),
    case(
        "depends only on",
        r"xz + y - y",
        "in = \"x\"\nfixed = \"y\"\nnormalised = true",
        Holds,
    ),
    case("depends essentially on", r"xy", "in = \"x\"", Holds),
    case("depends essentially on", r"y", "in = \"x\"", Refuted),
    case("depends essentially on", r"100y + x", "in = \"x\"", Refuted),
    case(
        "depends essentially on",
        r"100y + x",
        "in = \"x\"\ntolerance = \"1/1000\"",
        Holds,
    ),
    case(
        "separates into",
        r"x^2 + \frac{1}{y}",
        "groups = [[\"x\"], [\"y\"]]",
        Holds,
    ),
    case(
        "separates into",
        r"(x + 1)(y + z)",
        "groups = [[\"x\"], [\"y\", \"z\"]]",
        Holds,
    ),
    case(
        "separates into",
        r"(x + 1)(y + x)",
        "groups = [[\"x\"], [\"y\"]]",
        Refuted,
    ),
    case(
        "separates into",
        r"(x + 1)(y + 100x)",
        "groups = [[\"x\"], [\"y\"]]",
        Loose,
    ),
    case(
        "separates into",
        r"(x + 1)(y + z)",
        "groups = [[\"x\", \"y\"], [\"z\"]]",
        Refuted,
    ),
    case("proportional to", r"xyz", "to = \"z\"", Holds),
    case("proportional to", r"x^2yz", "to = 'x^2'", Holds),
    case("proportional to", r"x^2yz", "to = 'x'", Refuted),
    case("proportional to", r"x^2yz", "to = 'x^3'", Refuted),
    case("proportional to", r"x + 1", "to = 'x'", Refuted),
    case("proportional to", r"100x + 1", "to = 'x'", Loose),
    case("proportional to", r"y", "to = 'x'", Refuted),
    case(
        "tends to",
        r"\frac{xy + 1}{x + z}",
        "in = \"x\"\nas = '\\infty'\nto = \"y\"",
        Holds,
    ),
    case(
        "tends to",
        r"\frac{xy + 1}{x + z}",
        "in = \"x\"\nas = '\\infty'\nto = \"x\"",
        Refuted,
    ),
    case(
        "tends to",
        r"\frac{xy + 1}{x + z}",
        "in = \"x\"\nas = \"0\"\nto = \"y\"",
        Refuted,
    ),
    case(
        "tends to",
        r"\frac{xy + 1}{x + z}",
        r#"in = "x"
as = "0"
to = '\frac{1}{z}'"#,
        Holds,
    ),
    case(
        "tends to",
        r"\frac{xy + 1}{x + z}",
        "in = \"x\"\nas = '\\infty'\nto = '\\infty'",
        Refuted,
    ),
    case(
        "tends to",
        r"\frac{y}{x} - x",
        "in = \"x\"\nas = \"0\"\nto = '\\infty'",
        Holds,
    ),
    case(
        "tends to",
        r"\frac{y}{x} - x",
        "in = \"x\"\nas = '\\infty'\nto = '\\infty'",
        Refuted,
    ),
    case(
        "tends to",
        r"\frac{1}{x}",
        "in = \"x\"\nas = '\\infty'\nto = \"0\"",
        Holds,
    ),
    case(
        "tends to",
        r"(y - z)x",
        "in = \"x\"\nas = '\\infty'\nto = '\\infty'",
        Undecided,
    ),
    case("equals", r"x + 1", "to = \"y\"", Holds),
    case("equals", r"(x + z)^2 - 2xz", "to = 'x^2 + z^2'", Holds),
    case("equals", r"x", "to = \"y\"", Refuted),
    case("equals", r"x + 1", "to = \"4\"", Refuted),
    case("close to", r"20x", "to = '13y'", Holds),
    case("close to", r"x", "to = 'y'", Refuted),
    case("close to", r"-20x", "to = '13y'", Refuted),
    case("close to", r"x", "to = 'y'\ntolerance = \"1/2\"", Holds),
    // x/y is 2/3 at the reference, and between 1/3 and 4/3 in the box.
    case(
        "small compared with",
        "x",
        "to = \"y\"\ntolerance = \"3/2\"\nbox = \"x\"\ntimes = [\"1/2\", \"2\"]\nover = \"box\"",
        Holds,
    ),
    case(
        "small compared with",
        "x",
        "to = \"y\"\ntolerance = \"1\"\nbox = \"x\"\ntimes = [\"1/2\", \"2\"]\nover = \"box\"",
        Loose,
    ),
    case(
        "close to",
        "x",
        "to = \"y\"\ntolerance = \"1/4\"\nbox = \"x\"\ntimes = [\"1/2\", \"2\"]\nover = \"box\"",
        Refuted,
    ),
    case("small compared with", r"xz", "to = '100yz'", Holds),
    case("small compared with", r"-xz", "to = 'yz'", Refuted),
    case("small compared with", r"xz", "to = 'y'", Undecided),
    case("measured like", r"x", "to = 'xz'", Holds),
    case("measured like", r"x^2", "to = 'x'", Refuted),
    case("measured like", r"x", "to = 'y'", Refuted),
    case(
        "explicit",
        r"\begin{bmatrix} x & y \\ 0 & z \end{bmatrix}^{-1}",
        "",
        Holds,
    ),
];

fn decide(case: &Case) -> StatementOutcome {
    let settings = format!(
        "of = \"f\"\npredicate = \"{}\"\n{}",
        case.predicate, case.arguments
    );
    outcome(case.quantity, &settings)
}

/// What a checker gets wrong, given what it says of each case.
fn faults(says: impl Fn(&Case) -> VerdictWord) -> Vec<String> {
    CASES
        .iter()
        .filter_map(|case| {
            let word = says(case);
            let shown = format!("{} {} {}", case.quantity, case.predicate, case.arguments);
            (word != case.word).then(|| format!("{shown}: {word}, not {}", case.word))
        })
        .collect()
}

#[test]
fn every_predicate_is_decided() {
    let found = faults(|case| decide(case).word);
    assert!(found.is_empty(), "{found:#?}");
}

#[test]
fn blind_checkers_are_caught() {
    for word in [Holds, Loose, Refuted, Undecided] {
        assert!(!faults(|_| word).is_empty(), "always {word}");
    }
    // One that takes loose statements for true ones, and one that refutes them.
    for as_word in [Holds, Refuted] {
        let blind = |case: &Case| {
            if case.word == Loose {
                as_word
            } else {
                case.word
            }
        };
        assert!(!faults(blind).is_empty());
    }
    // For each predicate a case that holds and one that does not.
    for predicate in Predicate::ALL {
        let words: BTreeSet<VerdictWord> = CASES
            .iter()
            .filter(|c| c.predicate == predicate.as_str())
            .map(|c| c.word)
            .collect();
        assert!(words.contains(&Holds), "{}", predicate.as_str());
        // That something is explicit is refuted by nothing: what is not, is undecided.
        let refutable = predicate != Predicate::Explicit;
        assert_eq!(
            words.contains(&Refuted),
            refutable,
            "{}",
            predicate.as_str()
        );
    }
}

#[test]
fn every_sign_has_a_certificate_that_verifies_and_none_does_after_damage() {
    let mut certificates = 0;
    for case in CASES {
        for certificate in decide(case).signs {
            certificates += 1;
            assert!(certificate.verify(), "{}", case.quantity);
            let mut damaged = certificate.clone();
            damaged.sign = match damaged.sign {
                Sign::Positive => Sign::Negative,
                _ => Sign::Positive,
            };
            assert!(!damaged.verify(), "{}", case.quantity);
            let mut damaged = certificate.clone();
            damaged.content += 1;
            assert!(!damaged.verify(), "{}", case.quantity);
            if certificate.is_elementary() && !certificate.factors.is_empty() {
                let mut damaged = certificate;
                damaged.positive.clear();
                assert!(!damaged.verify(), "{}", case.quantity);
            }
        }
    }
    assert!(certificates > 20);
}

#[test]
fn a_witness_has_the_value_that_is_said() {
    let mut witnesses = 0;
    for case in CASES {
        let settings = format!(
            "of = \"f\"\npredicate = \"{}\"\n{}",
            case.predicate, case.arguments
        );
        let audit = audit(&document(case.quantity, &settings));
        for fact in &audit.statements[0].facts {
            let Fact::Witness {
                subject,
                point,
                value,
            } = fact
            else {
                continue;
            };
            if *subject != Subject::Quantity {
                continue;
            }
            // The quantity again, by substitution into the document's own equation.
            let mut text = document(case.quantity, &settings);
            for (letter, number) in point {
                let name = audit.model.ring.variables()[*letter].clone();
                let from = text.find(&format!("\n{name} = {{")).expect("the letter");
                let line = text[from + 1..]
                    .lines()
                    .next()
                    .expect("its line")
                    .to_string();
                let replaced =
                    format!("{name} = {{ positive = true, value = \"{number}\", meaning = \"\" }}");
                text = text.replace(&line, &replaced);
            }
            let start = text.find("```toml S").expect("the settings");
            text.truncate(start);
            text +=
                &format!("```toml S\nof = \"f\"\npredicate = \"equals\"\nto = \"{value}\"\n```\n");
            let again = self::audit(&text);
            assert_eq!(again.statements[0].word, Holds, "{}", case.quantity);
            witnesses += 1;
        }
    }
    assert!(witnesses >= 3);
}

fn quarter_car() -> Audit {
    let path = concat!(
        env!("CARGO_MANIFEST_DIR"),
        "/proofs/schiehlen-2006/quarter-car.md"
    );
    let text = std::fs::read_to_string(path).expect("the document");
    audit(&text)
}

/// The numbers of one proposition, in their closed form, in the order of the facts.
fn numbers(audit: &Audit, label: &str, member: usize) -> Vec<(Measure, String)> {
    let statement = audit.model.statement(label).expect("the statement");
    let mut outcomes = audit.outcomes_of_statement(statement);
    let outcome = outcomes.find(|o| o.member == member).expect("the member");
    let facts = outcome.facts.iter().filter_map(|fact| match fact {
        Fact::Number(measure, value) => {
            let [_, plain] = rederive::report::algebraic::closed(value)?;
            Some((measure.clone(), plain))
        }
        _ => None,
    });
    facts.collect()
}

/// By hand from (67) and (68): comfort is c_R d/m_A^2 + c_A^2 (m_A + m_R)/(d m_A^2), so that at the
/// reference car its two terms are as 32 to 5; safety is a d + b/d with b/a = 21600000.
#[test]
fn the_numbers_of_the_quarter_car() {
    let audit = quarter_car();
    let cases = [
        ("strut-3", 1, "15/248"),
        ("strut-4", 1, "4√15/15 - 1"),
        ("strut-4", 1, "31√15/120 - 1"),
        ("strut-4", 1, "1200√15"),
        ("strut-4", 1, "4500"),
        ("strut-4-comfort", 1, "7√6/12 - 1"),
        ("strut-2", 2, "√10/8"),
        ("strut-2", 1, "10/37"),
        ("strut-2", 2, "27/37"),
        ("axle-1", 1, "5/592"),
        ("axle-2-essentially", 1, "61/128"),
        ("axle-3", 1, "32/37"),
        ("summary", 3, "45/3923"),
        ("summary", 3, "18750"),
        ("summary", 2, "600√10"),
        ("decoupling", 1, "1/175"),
        ("reduction", 1, "-320/1369"),
        ("reduction", 2, "-420/961"),
    ];
    for (label, member, number) in cases {
        let found = numbers(&audit, label, member);
        assert!(
            found.iter().any(|(_, n)| n == number),
            "{label}.{member}: {number} is not among {found:?}"
        );
    }
}

/// No statement of the paper survives its opposite.
#[test]
fn the_opposite_of_a_statement_does_not_hold() {
    let path = concat!(
        env!("CARGO_MANIFEST_DIR"),
        "/proofs/schiehlen-2006/quarter-car.md"
    );
    let text = std::fs::read_to_string(path).expect("the document");
    let opposites = [
        ("increasing in", "decreasing in"),
        ("decreasing in", "increasing in"),
        ("has a minimum in", "has a maximum in"),
        ("minimal at", "maximal at"),
        ("independent of", "depends essentially on"),
        ("depends essentially on", "independent of"),
    ];
    let mut lines: Vec<String> = text.lines().map(String::from).collect();
    let mut changed = 0;
    for line in &mut lines {
        for (from, to) in opposites {
            if *line == format!("predicate = \"{from}\"") {
                *line = format!("predicate = \"{to}\"");
                changed += 1;
                break;
            }
        }
    }
    assert!(changed > 10);
    let opposite = audit(&lines.join("\n"));
    let original = quarter_car();
    for (before, after) in original.statements.iter().zip(&opposite.statements) {
        let statement = &original.model.statements[before.statement];
        let predicate = |a: &Audit| {
            let s = &a.model.statements[before.statement].propositions;
            s.get(before.member - 1).map(|p| p.predicate)
        };
        if predicate(&original) != predicate(&opposite) {
            let told = format!("{} {}: {}", statement.label, before.member, after.word);
            assert!(before.word == Refuted || after.word != Holds, "{told}");
            assert!(before.word != Holds || after.word == Refuted, "{told}");
        }
    }
}

fn kinds(settings: &str) -> Vec<DiagnosticKind> {
    let text = document("x + y", settings);
    let diagnostics = match Document::parse("test.md", &text) {
        Err(diagnostics) => diagnostics,
        Ok(document) => match Audit::of(&document, Options::default()) {
            Ok(_) => Vec::new(),
            Err(rejection) => rejection.diagnostics,
        },
    };
    diagnostics.into_iter().map(|d| d.kind).collect()
}

#[test]
fn what_is_refused() {
    let refused = |settings: &str, wanted: fn(&DiagnosticKind) -> bool| {
        let kinds = kinds(settings);
        assert!(
            kinds.len() == 1 && wanted(&kinds[0]),
            "{settings}: {kinds:?}"
        );
    };
    let unexpected = |kind: &DiagnosticKind| matches!(kind, DiagnosticKind::Unexpected { .. });
    let base = "of = \"f\"\npredicate = ";
    refused("", |k| matches!(k, DiagnosticKind::MissingMeaning { .. }));
    refused(&format!("{base}\"grows with\""), |k| {
        matches!(k, DiagnosticKind::UnknownWord { .. })
    });
    refused("predicate = \"positive\"", unexpected);
    refused(&format!("{base}\"increasing in\""), unexpected);
    refused(&format!("{base}\"positive\"\nin = \"x\""), unexpected);
    refused(&format!("{base}\"increasing in\"\nin = \"f\""), unexpected);
    refused(&format!("{base}\"increasing in\"\nin = \"w\""), unexpected);
    refused(&format!("{base}\"positive\"\nbox = \"z\""), unexpected);
    refused(&format!("{base}\"positive\"\nover = \"box\""), unexpected);
    refused(&format!("{base}\"positive\"\nover = \"here\""), |k| {
        matches!(k, DiagnosticKind::UnknownWord { .. })
    });
    refused(
        &format!("{base}\"positive\"\ntimes = [\"2\", \"1\"]"),
        |k| matches!(k, DiagnosticKind::EmptyRange { .. }),
    );
    refused(
        &format!("{base}\"independent of\"\nin = \"x\"\ntolerance = \"0\""),
        |k| matches!(k, DiagnosticKind::NotPositive { .. }),
    );
    refused(&format!("{base}\"positive\"\ncolour = \"red\""), |k| {
        matches!(k, DiagnosticKind::UnknownKey { .. })
    });
    refused("of = \"w\"\npredicate = \"positive\"", |k| {
        matches!(k, DiagnosticKind::UndeclaredName { .. })
    });
    refused("of = \"(x\"\npredicate = \"positive\"", |k| {
        matches!(k, DiagnosticKind::Unbalanced { .. })
    });
    refused(
        &format!("{base}\"separates into\"\ngroups = [\"x\"]"),
        unexpected,
    );
    refused(
        "of = [\"f\", \"x\", \"y\"]\npredicate = \"close to\"\nto = [\"x\", \"y\"]",
        unexpected,
    );
    refused(
        &format!("{base}\"positive\"\nbecause = \"of it\""),
        unexpected,
    );
    refused(
        &format!("{base}\"positive\"\nlikelier = \"printer\""),
        |k| matches!(k, DiagnosticKind::UnknownWord { .. }),
    );
    assert_eq!(kinds("reason = \"an opinion\""), []);
    assert_eq!(
        kinds(&format!(
            "{base}\"positive\"\nlikelier = \"paper\"\nbecause = \"of it\""
        )),
        []
    );
}

#[test]
fn a_slip_says_what_it_changes() {
    let text = "```toml symbols\nv = { positive = true, value = \"20\", meaning = \"speed\" }\n\
                k = { positive = true, value = \"3\", meaning = \"\" }\n```\n\
                ```math 1 define\nS = kv^3\n```\n\
                ```math 2 claim\nS = kv\n```\n\
                ```math 3 claim\nkv = S\n```\n\
                ```math 4 claim\nS = k + v\n```\n";
    let audit = audit(text);
    let effect = |label: &str| {
        let equation = audit.model.equation(label).expect("the equation");
        let outcome = audit.outcomes_of(equation).next().expect("a link");
        rederive::check::effect::effect(&audit.model, outcome)
    };
    // A power of v was lost: 1/400 at v = 20, on whichever side it stands.
    assert_eq!(effect("2").expect("an effect").ratio().to_string(), "1/400");
    assert_eq!(effect("3").expect("an effect").ratio().to_string(), "1/400");
    let unknown = effect("4").expect("an effect");
    assert!(!unknown.corrected);
    assert_eq!(unknown.ratio().to_string(), "24000/23");
    assert_eq!(effect("1"), None);
}

#[test]
fn a_sentence_that_is_true_in_one_reading_is_loose_and_not_refuted() {
    let readings =
        "of = [\"f\", \"f\", \"f\"]\npredicate = \"equals\"\nto = [\"x^2\", \"2x\", \"y\"]\n";
    let words = |settings: &str| -> Vec<(VerdictWord, Option<Short>)> {
        let audit = audit(&document("x^2", settings));
        audit.statements.iter().map(|o| (o.word, o.loose)).collect()
    };
    assert_eq!(
        words(readings),
        [(Holds, None), (Holds, None), (Refuted, None)]
    );
    assert_eq!(
        words(&format!("{readings}alternatives = true\n")),
        [
            (Holds, None),
            (Holds, None),
            (Loose, Some(Short::Otherwise))
        ]
    );
    let neither =
        "of = [\"f\", \"f\"]\npredicate = \"equals\"\nto = [\"x\", \"y\"]\nalternatives = true\n";
    assert_eq!(words(neither), [(Refuted, None), (Refuted, None)]);
}

#[test]
fn how_a_loose_statement_falls_short_is_told_apart() {
    for (quantity, settings, expected) in [
        (
            "x + \\frac{1}{x}",
            "predicate = \"increasing in\"\nin = \"x\"",
            Short::Partly,
        ),
        (
            "x + \\frac{4.2025}{x}",
            "predicate = \"increasing in\"\nin = \"x\"",
            Short::Nearly,
        ),
        (
            "y + x/100",
            "predicate = \"independent of\"\nin = \"x\"",
            Short::Nearly,
        ),
        (
            "\\frac{x}{2.1} + \\frac{2.1}{x}",
            "predicate = \"minimal at\"\nin = \"x\"",
            Short::Nearly,
        ),
    ] {
        let outcome = outcome(quantity, &format!("of = \"f\"\n{settings}"));
        assert_eq!(
            (outcome.word, outcome.loose),
            (Loose, Some(expected)),
            "{quantity}"
        );
    }
}

#[test]
fn a_function_that_is_not_rational_is_not_explicit() {
    let of = |quantity| outcome(quantity, "of = \"f\"\npredicate = \"explicit\"").word;
    assert_eq!(of("\\frac{1}{z^2 + 1}"), Holds);
    assert_eq!(of("\\exp(z)"), Refuted);
}
