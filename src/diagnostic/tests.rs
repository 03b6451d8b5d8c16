//! Every kind in words, against text written by hand, and hostile input.

use super::*;

const TEXT: &str = "# Title\n\n```math 47 define\na = \\frac{c_A}{m_A}\n```\n";

/// Line, column and excerpt of a diagnostic under `\frac` and of one of a kind.
fn shown(kind: DiagnosticKind) -> String {
    let start = TEXT.find("\\frac").unwrap();
    render(
        "car.md",
        TEXT,
        &[Diagnostic::new(kind, Span::new(start, start + 5))],
        false,
    )
}

#[test]
fn a_diagnostic_names_the_place_and_what_to_do() {
    let command = "\\frac".into();
    assert_eq!(
        shown(DiagnosticKind::UnknownCommand { command }),
        "\
error: the command `\\frac` is outside the LaTeX that is read
 --> car.md:4:5
  |
4 | a = \\frac{c_A}{m_A}
  |     ^^^^^ unknown command
  |
  = help: a command that is only typesetting can be left out; one that carries meaning needs the notation it stands for
"
    );
}

#[test]
fn the_second_place_is_shown() {
    let mut diagnostic = Diagnostic::new(
        DiagnosticKind::DuplicateLabel { label: "47".into() },
        Span::new(38, 39),
    );
    diagnostic.related = Some(Span::new(17, 19));
    let shown = render("car.md", TEXT, &[diagnostic], false);
    assert!(
        shown.contains("first time") && shown.contains("second time"),
        "{shown}"
    );
    assert!(shown.contains("3 | ```math 47 define"), "{shown}");
}

#[test]
fn the_probable_word_is_suggested() {
    let known = vec!["unit".into(), "value".into(), "meaning".into()];
    let key = "units".into();
    let text = shown(DiagnosticKind::UnknownKey {
        key,
        known: known.clone(),
    });
    assert!(
        text.contains("did you mean `unit`? Known here: `unit`, `value`, `meaning`"),
        "{text}"
    );
    let text = shown(DiagnosticKind::UnknownKey {
        key: "colour".into(),
        known,
    });
    assert!(text.contains("help: known here: `unit`"), "{text}");
}

#[test]
fn every_kind_has_words() {
    let s = || String::from("stuff");
    let kinds = [
        (
            DiagnosticKind::Unexpected {
                found: s(),
                expected: "a name".into(),
            },
            "expected a name, found stuff",
        ),
        (
            DiagnosticKind::Unbalanced {
                delimiter: "{".into(),
            },
            "`{` without its partner",
        ),
        (
            DiagnosticKind::TooManyLetters {
                count: 600,
                limit: 500,
            },
            "more than 500 letters and abbreviations",
        ),
        (
            DiagnosticKind::TooDeep { limit: 200 },
            "nested too deeply to be read",
        ),
        (
            DiagnosticKind::UnknownCommand { command: s() },
            "the command `stuff` is outside",
        ),
        (
            DiagnosticKind::Ambiguous {
                readings: vec![s(), "x".into()],
            },
            "could be `stuff`, `x`",
        ),
        (
            DiagnosticKind::UndeclaredName { name: s() },
            "nothing says what `stuff` is",
        ),
        (
            DiagnosticKind::NoTime { name: s() },
            "by what the dot over `stuff` differentiates",
        ),
        (
            DiagnosticKind::DuplicateName { name: s() },
            "`stuff` is declared or defined twice",
        ),
        (
            DiagnosticKind::CyclicDefinition {
                cycle: vec!["a".into(), "b".into(), "a".into()],
            },
            "a -> b -> a",
        ),
        (
            DiagnosticKind::ShapeMismatch {
                operation: "sum".into(),
                left: "2x2".into(),
                right: "3x3".into(),
            },
            "sum of 2x2 and 3x3",
        ),
        (
            DiagnosticKind::DivisionByZero,
            "division by something that is zero",
        ),
        (
            DiagnosticKind::Exponent {
                exponent: "10^9".into(),
                limit: 64,
            },
            "at most 64",
        ),
        (
            DiagnosticKind::BadNumber { text: "1/0".into() },
            "`1/0` is not a number",
        ),
        (
            DiagnosticKind::DuplicateLabel { label: "47".into() },
            "`47` is used twice",
        ),
        (
            DiagnosticKind::BadLabel {
                found: String::new(),
            },
            "this fence has no label",
        ),
        (
            DiagnosticKind::BadLabel {
                found: "claim".into(),
            },
            "`claim` cannot be a label",
        ),
        (
            DiagnosticKind::UnknownLabel {
                label: "48".into(),
                tables: vec!["symbols".into()],
            },
            "no equation has the label `48`",
        ),
        (
            DiagnosticKind::UnknownRole {
                role: String::new(),
            },
            "this equation has no role",
        ),
        (
            DiagnosticKind::UnknownRole {
                role: "claims".into(),
            },
            "did you mean `claim`?",
        ),
        (
            DiagnosticKind::UnknownKey {
                key: s(),
                known: vec![],
            },
            "no key `stuff`",
        ),
        (
            DiagnosticKind::UnknownWord {
                word: s(),
                known: vec![],
            },
            "`stuff` is not one of the words",
        ),
        (
            DiagnosticKind::MissingReason { label: "53".into() },
            "equation 53 is recalled without a reason",
        ),
        (
            DiagnosticKind::NotPositive {
                name: "m".into(),
                value: "-1".into(),
            },
            "`m` is declared positive, but its value is -1",
        ),
        (
            DiagnosticKind::BadUnit {
                unit: "ft".into(),
                message: s(),
            },
            "`ft` is not a unit: stuff",
        ),
        (
            DiagnosticKind::IncoherentUnit {
                unit: "kN".into(),
                coherent: "kg m/s^2".into(),
            },
            "give the value in kg m/s^2",
        ),
        (
            DiagnosticKind::EmptyRange {
                low: "2".into(),
                high: "1".into(),
                logarithmic: true,
            },
            "from 2 to 1",
        ),
        (
            DiagnosticKind::LongNumber {
                digits: 2000,
                limit: 1000,
            },
            "a number of 2000 digits; at most 1000",
        ),
        (
            DiagnosticKind::Undefined { name: s() },
            "write `define` instead of `claim`",
        ),
        (DiagnosticKind::Alternatives, "joined by `or`"),
        (
            DiagnosticKind::SaysNothing { clause: s() },
            "`stuff` alone says nothing",
        ),
        (
            DiagnosticKind::NoFence {
                line: s(),
                expected: "```math LABEL ROLE".into(),
            },
            "looks like a fence and is none",
        ),
        (
            DiagnosticKind::TooLong {
                what: "a document",
                size: 9,
                limit: 8,
            },
            "a document of 9 bytes",
        ),
        (DiagnosticKind::EmptyDocument, "nothing to check"),
        (DiagnosticKind::NotUtf8, "not UTF-8"),
        (
            DiagnosticKind::Unreadable { message: s() },
            "cannot read the file: stuff",
        ),
        (
            DiagnosticKind::Toml { message: s() },
            "this table is not TOML: stuff",
        ),
    ];
    for (kind, expected) in kinds {
        let text = shown(kind);
        assert!(text.contains(expected), "{text}");
        assert!(text.contains("car.md:4:5"), "{text}");
    }
}

#[test]
fn a_file_without_text_is_named() {
    let rejection = Rejection {
        name: "gone.md".into(),
        text: String::new(),
        diagnostics: vec![Diagnostic::new(
            DiagnosticKind::Unreadable {
                message: "no such file".into(),
            },
            Span::default(),
        )],
    };
    let shown = rejection.to_string();
    assert!(
        shown.contains("no such file") && shown.contains("gone.md"),
        "{shown}"
    );
}

#[test]
fn colour_is_only_added_on_demand() {
    let diagnostic = Diagnostic::new(DiagnosticKind::EmptyDocument, Span::default());
    assert!(!render("a.md", TEXT, std::slice::from_ref(&diagnostic), false).contains('\u{1b}'));
    assert!(render("a.md", TEXT, &[diagnostic], true).contains('\u{1b}'));
}

#[test]
fn escape_sequences_in_the_source_do_not_reach_the_terminal() {
    let text = "```math 1 claim\nx \u{1b}[31m = y\n```\n";
    let found = "\u{1b}[2J".into();
    let kind = DiagnosticKind::Unexpected {
        found,
        expected: "x".into(),
    };
    let shown = render(
        "\u{1b}]0;title\u{7}.md",
        text,
        &[Diagnostic::new(kind, Span::new(16, 20))],
        false,
    );
    assert!(
        !shown.contains('\u{1b}') && !shown.contains('\u{7}'),
        "{shown:?}"
    );
}

#[test]
fn any_span_in_any_text_can_be_shown() {
    for text in ["", "é", "x\n", "a\r\nb\té\u{301}\n\n", "\n\n\n"] {
        for start in 0..=text.len() + 1 {
            for end in 0..=text.len() + 1 {
                let mut diagnostic =
                    Diagnostic::new(DiagnosticKind::DivisionByZero, Span::new(start, end));
                diagnostic.related = Some(Span::new(end, start));
                assert!(render("a.md", text, &[diagnostic], false).contains("division"));
            }
        }
    }
}

#[test]
fn a_long_line_and_many_diagnostics_stay_readable() {
    let text = format!("```math 1 claim\n{}\n```\n", "(".repeat(100_000));
    let many: Vec<Diagnostic> = (0..100_000)
        .map(|at| {
            let delimiter = "(".into();
            Diagnostic::new(
                DiagnosticKind::Unbalanced { delimiter },
                Span::new(16 + at, 17 + at),
            )
        })
        .collect();
    let shown = render("a.md", &text, &many, false);
    assert!(shown.len() < 100_000, "{}", shown.len());
    assert!(shown.contains("and 99950 more in a.md"));
    let whole = Diagnostic::new(DiagnosticKind::TooDeep { limit: 9 }, Span::new(16, 100_016));
    let last = Diagnostic::new(
        DiagnosticKind::TooDeep { limit: 9 },
        Span::new(100_000, 100_001),
    );
    let shown = render("a.md", &text, &[whole, last], false);
    assert!(shown.len() < 5_000, "{}", shown.len());
    assert!(
        shown.contains("a.md:2:1") && shown.contains("a.md:2:99985"),
        "{shown}"
    );
}
