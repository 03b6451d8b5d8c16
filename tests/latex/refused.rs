//! What must be refused, by kind and place.

use super::{cases, string, strings};
use rederive::diagnostic::{Diagnostic, DiagnosticKind};
use rederive::latex::{DEPTH_LIMIT, Signature, parse_chain, parse_display, parse_expr, parse_name};
use rederive::span::Span;

/// Takes the marks out and returns the places they enclosed.
fn unmark(marked: &str) -> (String, Vec<Span>) {
    let mut text = String::new();
    let mut spans = Vec::new();
    let mut start = 0;
    for c in marked.chars() {
        match c {
            '⟦' => start = text.len(),
            '⟧' => spans.push(Span::new(start, text.len())),
            c => text.push(c),
        }
    }
    (text, spans)
}

fn kind(diagnostic: &Diagnostic) -> String {
    let text = format!("{:?}", diagnostic.kind);
    let end = text.find([' ', '{']).unwrap_or(text.len());
    text[..end].to_owned()
}

#[test]
fn every_bad_form_is_refused_where_it_is_bad() {
    let cases = cases(include_str!("refused.toml"));
    assert!(cases.len() > 80);
    let mut failures = Vec::new();
    for (case, signature) in cases {
        let marked = string(&case, "latex");
        let (text, spans) = unmark(marked);
        let expected: Vec<(String, Span)> =
            strings(&case, "kinds").into_iter().zip(spans).collect();
        let offset = 1000;
        let found: Vec<(String, Span)> = match parse_display(&text, offset, &signature) {
            Ok(_) => Vec::new(),
            Err(diagnostics) => diagnostics
                .iter()
                .map(|d| {
                    (
                        kind(d),
                        Span::new(d.span.start - offset, d.span.end - offset),
                    )
                })
                .collect(),
        };
        if found != expected {
            failures.push(format!(
                "{marked}\n  found    {found:?}\n  expected {expected:?}"
            ));
        }
    }
    assert!(failures.is_empty(), "{}", failures.join("\n"));
}

/// The deepest nesting that is read, one more, and far too much: quickly, and on a small stack.
#[test]
fn nesting_is_limited() {
    let signature = Signature::default();
    let nests: [(&str, &str, &str); 11] = [
        ("(", "a", ")"),
        ("{", "a", "}"),
        ("\\left[", "a", "\\right]"),
        ("\\frac{a}{", "b", "}"),
        ("\\begin{bmatrix}", "a", "\\end{bmatrix}"),
        ("a_{", "b", "}"),
        ("a^{", "b", "}"),
        ("\\dot{", "a", "}"),
        ("\\sum_{k=0}^3 ", "a", ""),
        ("\\det ", "a", ""),
        ("\\underbrace{", "a", "}_b"),
    ];
    for (open, inner, close) in nests {
        let nest = |depth: usize| format!("{}{inner}{}", open.repeat(depth), close.repeat(depth));
        assert!(parse_expr(&nest(40), 0, &signature).is_ok(), "{open}");
        for depth in [DEPTH_LIMIT + 1, 10_000] {
            let wrong = parse_expr(&nest(depth), 0, &signature).expect_err(open);
            let limit = DEPTH_LIMIT;
            assert_eq!(wrong[0].kind, DiagnosticKind::TooDeep { limit }, "{open}");
            assert_eq!(wrong.len(), 1, "{open}");
        }
    }
    let lone = "(".repeat(100_000);
    let wrong = parse_display(&lone, 0, &signature).expect_err("lone brackets");
    assert_eq!(wrong.len(), 1);
}

/// Long texts without nesting take no more than time proportional to their length.
#[test]
fn length_is_no_obstacle() {
    let signature = Signature::default();
    let long = |piece: &str| piece.repeat(20_000);
    // One equation has an end, or its tree takes more room than a document may.
    let one = |piece: &str| piece.repeat(6_000);
    for text in [
        format!("a{}", one(" + b")),
        one("a b "),
        format!("[a{}]", one(" \\ b")),
        format!(
            "\\begin{{aligned}} {} \\end{{aligned}}",
            long("a &= b \\\\ ")
        ),
        format!("a {} = b", long("\\ \\quad ")),
        format!("a = b{}", long(", a = b")),
        format!("a{}", one("'")),
    ] {
        assert!(parse_display(&text, 0, &signature).is_ok(), "{:.40}", text);
    }
    for text in [
        long(")"),
        long("a = = b, "),
        long("\\foo "),
        long("g(h) "),
        long("\\tag{1}"),
        format!("a{}", long(" + b")),
    ] {
        assert!(parse_display(&text, 0, &signature).is_err(), "{:.40}", text);
    }
    let digits = "9".repeat(200_000);
    let wrong = parse_expr(&digits, 0, &signature).expect_err("a number of 200,000 digits");
    assert!(matches!(wrong[0].kind, DiagnosticKind::LongNumber { .. }));
}

#[test]
fn the_other_entrances_refuse_what_is_left_over() {
    let signature = Signature::default();
    assert!(parse_expr("a = b", 0, &signature).is_err());
    assert!(parse_expr("a, b", 0, &signature).is_err());
    assert!(parse_expr("", 0, &signature).is_err());
    assert!(parse_chain("bd = ae, a = b", 0, &signature).is_err());
    assert!(parse_chain("bd = ae", 0, &signature).is_ok());
    for bad in [
        "a b",
        "a^2",
        "2",
        "a(t)",
        "\\frac{a}{b}",
        "",
        "\\dot{(a)}",
        "a+b",
        "\\foo",
    ] {
        assert!(parse_name(bad, 0).is_err(), "{bad}");
    }
    for good in [
        "a",
        "m_A",
        "\\mathbf{0}",
        "H_{i,j}",
        "\\sigma_{a \\text{ ref}}",
        "\\ddot{z}_A",
    ] {
        assert!(parse_name(good, 0).is_ok(), "{good}");
    }
}

/// Whatever stands in the text, the places that are pointed at lie in it.
#[test]
fn places_lie_in_the_text() {
    let signature = Signature::default();
    let text = "a = \\frac{b}{c} + (d";
    for end in 0..=text.len() {
        if let Err(diagnostics) = parse_display(&text[..end], 7, &signature) {
            for diagnostic in diagnostics {
                let Span { start, end: stop } = diagnostic.span;
                assert!(7 <= start && start <= stop && stop <= 7 + end);
            }
        }
    }
}
