//! Bad documents get a diagnostic that points at the place: file, line, column and an excerpt; all
//! errors of a document at once, without a panic, and without work that grows with what is refused.

use rederive::audit::Audit;
use rederive::check::Options;
use rederive::diagnostic::{DiagnosticKind, Rejection};
use rederive::document::{Document, VerdictWord};

const TABLE: &str = "```toml symbols\nx = { meaning = \"a letter\" }\ny = { meaning = \"another\" }\n\
                     '\\mathbf{A}' = { meaning = \"no matrix at all\" }\n```\n";

/// A document around one equation.
fn around(role: &str, latex: &str) -> String {
    format!("# Bad\n\n{TABLE}\n```math 1 {role}\n{latex}\n```\n")
}

fn rejected(text: &str) -> Rejection {
    let result = match Document::parse("bad.md", text) {
        Ok(document) => Audit::of(&document, Options::default()).map(|_| ()),
        Err(diagnostics) => Err(Rejection {
            name: "bad.md".into(),
            text: text.into(),
            diagnostics,
        }),
    };
    result.expect_err("the document is bad")
}

/// The document is refused with a diagnostic of this kind at this line and column.
fn refused(text: &str, line: usize, column: usize, kind: impl Fn(&DiagnosticKind) -> bool) {
    let rejection = rejected(text);
    let diagnostic = rejection
        .diagnostics
        .iter()
        .find(|d| kind(&d.kind))
        .unwrap_or_else(|| panic!("{rejection}"));
    let before = &text[..diagnostic.span.start];
    let found = (
        before.matches('\n').count() + 1,
        before.len() - before.rfind('\n').map_or(0, |n| n + 1) + 1,
    );
    assert_eq!(found, (line, column), "{rejection}");
    let shown = rejection.to_string();
    assert!(
        shown.contains(&format!("bad.md:{line}:{column}")),
        "{shown}"
    );
}

#[test]
fn a_lone_brace_is_pointed_at() {
    refused(&around("claim", "x = \\frac{x}{y"), 10, 13, |k| {
        matches!(k, DiagnosticKind::Unbalanced { .. })
    });
}

#[test]
fn an_undeclared_letter_is_pointed_at() {
    refused(
        &around("claim", "x = x + z"),
        10,
        9,
        |k| matches!(k, DiagnosticKind::UndeclaredName { name } if name == "z"),
    );
}

#[test]
fn a_name_defined_twice_is_pointed_at() {
    let text = around("define", "u = x") + "```math 2 define\nu = y\n```\n";
    refused(
        &text,
        13,
        1,
        |k| matches!(k, DiagnosticKind::DuplicateName { name } if name == "u"),
    );
}

#[test]
fn definitions_in_a_circle_are_pointed_at() {
    let text = around("define", "u = v + x, v = u - y");
    let rejection = rejected(&text);
    assert!(
        rejection.diagnostics.iter().any(|d| matches!(
            &d.kind,
            DiagnosticKind::CyclicDefinition { cycle } if cycle.len() == 2
        )),
        "{rejection}"
    );
}

#[test]
fn a_matrix_of_the_wrong_shape_is_pointed_at() {
    let latex = "\\begin{bmatrix} 1 & 2 \\\\ 3 & 4 \\end{bmatrix} \\begin{bmatrix} 1 \\\\ 2 \\\\ 3 \\end{bmatrix} = 0";
    let defined = format!("u = {latex}").replace(" = 0", "");
    refused(&around("define", &defined), 10, 5, |k| {
        matches!(k, DiagnosticKind::ShapeMismatch { .. })
    });
    refused(
        &around("claim", "\\begin{bmatrix} x & y \\\\ x \\end{bmatrix} = 0"),
        10,
        26,
        |k| !matches!(k, DiagnosticKind::UndeclaredName { .. }),
    );
}

#[test]
fn division_by_something_identically_zero_costs_its_own_link_only() {
    let text = around("claim", "x = \\frac{y}{(x+y)^2 - x^2 - 2xy - y^2}");
    let document = Document::parse("test.md", &text).expect("a document");
    let audit = Audit::of(&document, Options::default()).unwrap_or_else(|r| panic!("{r}"));
    let mut words = audit.outcomes.iter().map(|o| o.verdict.word());
    assert!(words.next_back() == Some(VerdictWord::Undecided));
}

#[test]
fn a_huge_exponent_is_undecided_and_not_computed() {
    let document = around("claim", "y = x^{10^9}");
    let document = Document::parse("bad.md", &document).expect("it can be read");
    let audit = Audit::of(&document, Options::default()).expect("the rest has verdicts");
    assert_eq!(audit.outcomes[0].verdict.word(), VerdictWord::Undecided);
}

#[test]
fn a_hundred_thousand_brackets_are_refused_and_not_entered() {
    let latex = format!("y = {}x{}", "(".repeat(100_000), ")".repeat(100_000));
    let rejection = rejected(&around("claim", &latex));
    assert!(
        rejection
            .diagnostics
            .iter()
            .any(|d| matches!(d.kind, DiagnosticKind::TooDeep { .. })),
        "no TooDeep"
    );
}

#[test]
fn an_empty_document_is_refused() {
    for text in ["", "# Title only\n"] {
        let rejection = rejected(text);
        assert_eq!(rejection.diagnostics[0].kind, DiagnosticKind::EmptyDocument);
    }
}

#[test]
fn a_number_outside_its_meaning_is_pointed_at() {
    let text = "```toml symbols\nx = { meaning = \"\", value = \"1/0\" }\n```\n";
    refused(text, 2, 29, |k| {
        matches!(k, DiagnosticKind::BadNumber { .. })
    });
}

#[test]
fn an_unknown_role_and_a_number_used_twice_are_both_reported() {
    let text =
        around("prove", "x = x") + "```math 1 claim\nx = x\n```\n```math 1 claim\ny = y\n```\n";
    let rejection = rejected(&text);
    let has =
        |kind: fn(&DiagnosticKind) -> bool| rejection.diagnostics.iter().any(|d| kind(&d.kind));
    assert!(
        has(|k| matches!(k, DiagnosticKind::UnknownRole { .. })),
        "{rejection}"
    );
    assert!(
        has(|k| matches!(k, DiagnosticKind::DuplicateLabel { .. })),
        "{rejection}"
    );
}

#[test]
fn all_errors_of_a_document_are_reported_at_once() {
    let text = around("claim", "x = u")
        + "```math 2 claim\ny = w + (x\n```\n```math 3 claim\nx = v_3\n```\n";
    let rejection = rejected(&text);
    let undeclared = rejection
        .diagnostics
        .iter()
        .filter(|d| matches!(d.kind, DiagnosticKind::UndeclaredName { .. }))
        .count();
    assert!(undeclared >= 2, "{rejection}");
    assert!(
        rejection
            .diagnostics
            .iter()
            .any(|d| matches!(d.kind, DiagnosticKind::Unbalanced { .. })),
        "{rejection}"
    );
}

/// What cannot be decided is undecided, never true and never a crash.
#[test]
fn what_lies_outside_is_undecided() {
    for latex in [
        "x = \\int_0^1 \\frac{\\cos y}{y + 1} \\, dy",
        "x = y^{1/3}",
        "x \\neq y",
    ] {
        let text = around("claim", latex);
        let document = Document::parse("odd.md", &text).expect("a document");
        let audit = Audit::of(&document, Options::default()).expect("an audit");
        // What is false at a point may be refuted all the same.
        let word = audit.outcomes[0].verdict.word().as_str();
        assert!(matches!(word, "undecided" | "refuted"), "{latex}: {word}");
    }
}

/// A power that would fill the memory stops at the budget.
#[test]
fn an_exploding_power_is_undecided() {
    let letters: Vec<String> = (1..=12).map(|i| format!("'s_{{{i}}}'")).collect();
    let table: String = letters
        .iter()
        .map(|l| format!("{l} = {{ meaning = \"\" }}\n"))
        .collect();
    let sum: Vec<String> = (1..=12).map(|i| format!("s_{{{i}}}")).collect();
    let text = format!(
        "```toml symbols\n{table}```\n```math 1 claim\n({})^{{400}} = 1\n```\n",
        sum.join(" + ")
    );
    let document = Document::parse("large.md", &text).expect("a document");
    let audit = Audit::of(&document, Options::default()).expect("an audit");
    let word = audit.outcomes[0].verdict.word().as_str();
    assert!(matches!(word, "undecided" | "refuted"), "{word}");
}

/// A chain of definitions, each before what it needs; and one that is too long.
#[test]
fn a_long_chain_of_definitions_is_followed_or_refused() {
    let chain = |length: usize| {
        let mut text = String::from("```toml symbols\nx = { meaning = \"\" }\n```\n");
        for i in 0..length {
            let next = if i + 1 == length {
                "x".into()
            } else {
                format!("y_{{{}}}", i + 1)
            };
            text += &format!("```math d{i} define\ny_{{{i}}} = {next} + 1\n```\n");
        }
        text + &format!("```math 1 claim\ny_{{0}} = x + {length}\n```\n")
    };
    let document = Document::parse("chain.md", &chain(100)).expect("a document");
    let audit = Audit::of(&document, Options::default()).expect("an audit");
    let claim = audit.outcomes.last().expect("the claim");
    assert_eq!(claim.verdict.word().as_str(), "holds");
    let rejection = rejected(&chain(3_000));
    assert!(matches!(
        rejection.diagnostics[0].kind,
        DiagnosticKind::TooManyLetters { .. }
    ));
}

/// What nobody writes by hand ends with an error at its place, before it is computed with.
#[test]
fn hostile_documents_are_refused() {
    let deep =
        |open: &str, close: &str| format!("y = {}x{}", open.repeat(9_000), close.repeat(9_000));
    let rows = vec!["x"; 20_000].join(" & ");
    let bodies = [
        "x = x \\\\\n".repeat(60_000),
        "{".repeat(1_000_000),
        "}".repeat(1_000_000),
        "(".repeat(40_000),
        "x^".repeat(20_000),
        "x_{".repeat(10_000),
        "\\frac{".repeat(6_000),
        "\\sqrt".repeat(8_000),
        "\\left(".repeat(8_000),
        "\\begin{bmatrix}".repeat(3_000),
        "\\\\[".repeat(16_000),
        "-".repeat(40_000),
        format!("x = \\begin{{bmatrix}} {rows} \\end{{bmatrix}} + q"),
        format!("x = {} q", "x".repeat(100_000)),
        "x = \u{0} x".to_owned(),
        "x = \u{1b}[2J".to_owned(),
        "x = \u{202e} y".to_owned(),
        deep("(", ")"),
        deep("{", "}"),
        deep("\\sqrt{", "}"),
        deep("\\int ", " d x"),
        deep("\\underbrace{", "}_y"),
        deep("\\det ", ""),
    ];
    for body in &bodies {
        let rejection = rejected(&around("claim", body));
        let shown = rejection.to_string();
        let start: String = body.chars().take(30).collect();
        assert!(shown.contains("bad.md:"), "{start}");
        assert!(shown.len() < 200_000, "{start}");
    }
    for (table, line) in [
        ("x = { meaning = \"\\ud800\" }", "symbols"),
        ("x = { meaning = \"\\u12\" }", "symbols"),
        ("title = \"a\u{0}b\"", "document"),
    ] {
        let text = format!("```toml {line}\n{table}\n```\n");
        assert!(rejected(&text).to_string().contains("bad.md:2"), "{table}");
    }
    let nested = format!("```toml symbols\nx = {}\n```\n", "[".repeat(100_000));
    rejected(&nested);
    rejected(&">".repeat(100_000));
    rejected(&"- ".repeat(50_000));
    let large = format!(
        "{}\n```math 1 claim\nx = x\n```\n",
        "words ".repeat(1 << 20)
    );
    assert!(matches!(
        rejected(&large).diagnostics[..],
        [rederive::diagnostic::Diagnostic {
            kind: DiagnosticKind::TooLong { .. },
            ..
        }]
    ));
}

/// Many definitions are refused by their number, before any of them is computed.
#[test]
fn five_thousand_definitions_are_refused() {
    let mut text = around("claim", "x = x");
    for i in 0..5_000 {
        text += &format!("```math d{i} define\nu_{{{i}}} = {i}x\n```\n");
    }
    let rejection = rejected(&text);
    assert!(matches!(
        rejection.diagnostics[0].kind,
        DiagnosticKind::TooManyLetters { .. }
    ));
}

/// What is no file with a text of its own is refused before it is read: it may have no end.
#[test]
#[cfg(unix)]
fn devices_and_folders_are_refused_unread() {
    for path in ["/dev/zero", "/dev/null", "/"] {
        let rejection = Document::read(std::path::Path::new(path)).expect_err("no document");
        let kind = &rejection.diagnostics[0].kind;
        let DiagnosticKind::Unreadable { message } = kind else {
            panic!("{rejection}");
        };
        assert!(message.contains("file"), "{message}");
    }
}
