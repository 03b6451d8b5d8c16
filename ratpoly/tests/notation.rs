//! The plain notation: what is read, what is refused and where, and what serde makes of it.

use proptest::prelude::*;
use ratpoly::{Error, Order, ParseErrorKind, Polynomial, RationalFunction, Ring};

fn ring() -> Ring {
    Ring::new(["x", "y_1", "z'"], Order::Lex).unwrap()
}

fn shown(text: &str) -> String {
    RationalFunction::parse(ring(), text).map_or_else(|e| e.to_string(), |r| r.to_string())
}

#[test]
fn expressions_are_read_with_the_usual_precedence() {
    for (text, expected) in [
        ("1 - 2 - 3", "-4"),
        ("8/4/2", "1"),
        ("2*x^3*y_1", "2*x^3*y_1"),
        ("-x^2", "-x^2"),
        ("(-x)^2", "x^2"),
        ("--x", "x"),
        ("2*-x", "-2*x"),
        ("x^-2*y_1", "y_1/x^2"),
        ("x/y_1*z'", "x*z'/y_1"),
        ("x/(y_1*z')", "x/(y_1*z')"),
        ("(x + 1)^0", "1"),
        ("0^0", "1"),
        (" ( x+y_1 ) * ( x-y_1 ) ", "x^2 - y_1^2"),
        ("1/2*x + 1/3", "(3*x + 2)/6"),
        (
            "100000000000000000000000000000*x",
            "100000000000000000000000000000*x",
        ),
    ] {
        assert_eq!(shown(text), expected, "{text}");
    }
}

#[test]
fn what_is_no_expression_is_refused_at_its_place() {
    use ParseErrorKind::*;
    for (text, position, kind) in [
        ("", 0, ExpectedOperand),
        ("x + ", 4, ExpectedOperand),
        ("x y_1", 2, UnexpectedCharacter),
        ("2x", 1, UnexpectedCharacter),
        ("x + w", 4, UnknownVariable),
        ("(x + 1", 6, UnbalancedBracket),
        ("x + 1)", 5, UnbalancedBracket),
        ("(x $ 1)", 3, UnexpectedCharacter),
        ("x^y_1", 2, InvalidExponent),
        ("x^5000000000", 2, InvalidExponent),
        ("x/0", 2, DivisionByZero),
        ("x/(y_1 - y_1)", 2, DivisionByZero),
        ("0^-1", 3, DivisionByZero),
        ("x^4000000000*x^4000000000", 25, TooLarge),
        ("(x + y_1 + z' + 1)^1000000", 26, TooLarge),
        ("é", 0, UnknownVariable),
        ("∞", 0, ExpectedOperand),
    ] {
        let expected = Err(Error::Parse { position, kind });
        assert_eq!(RationalFunction::parse(ring(), text), expected, "{text}");
    }
    let deep = "(".repeat(100_000);
    assert!(matches!(
        Polynomial::parse(ring(), &deep),
        Err(Error::Parse { kind: TooLarge, .. })
    ));
    assert!(matches!(
        Polynomial::parse(ring(), "x/2"),
        Err(Error::Parse {
            kind: NotAPolynomial,
            ..
        })
    ));
}

#[test]
fn values_survive_serialisation() {
    let f = RationalFunction::parse(ring(), "(x^2 - 3)/(2*y_1)").unwrap();
    let text = serde_json::to_string(&f).unwrap();
    let expected = concat!(
        r#"{"ring":{"variables":["x","y_1","z'"],"order":"Lex"},"#,
        r#""value":"(x^2 - 3)/(2*y_1)"}"#
    );
    assert_eq!(text, expected);
    assert_eq!(serde_json::from_str::<RationalFunction>(&text).unwrap(), f);
    let p = f.numerator().clone();
    let text = serde_json::to_string(&p).unwrap();
    assert_eq!(serde_json::from_str::<Polynomial>(&text).unwrap(), p);
    // A polynomial is not read from a proper fraction, nor a ring with a variable named twice.
    assert!(serde_json::from_str::<Polynomial>(&text.replace("x^2 - 3", "1/x")).is_err());
    assert!(serde_json::from_str::<Ring>(r#"{"variables":["x","x"],"order":"Lex"}"#).is_err());
}

proptest! {
    /// Whatever the text, the parser answers; what it reads, it reads again from its own output.
    #[test]
    fn any_text_is_answered(text in "[xy_1z'0-9+*/^() -]{0,24}") {
        if let Ok(r) = RationalFunction::parse(ring(), &text) {
            prop_assert!(r.is_canonical());
            prop_assert_eq!(RationalFunction::parse(ring(), &r.to_string()), Ok(r));
        }
    }

    #[test]
    fn any_characters_are_answered(text in "\\PC{0,12}") {
        let _ = Polynomial::parse(ring(), &text);
    }
}

/// A few characters that denote a polynomial of a thousand million terms, or reduce to one.
#[test]
fn quotients_that_are_too_long() {
    let ring = Ring::new(["x", "y"], Order::Lex).unwrap();
    for text in [
        "(x^1000000000 - 1)/(x - 1)",
        "(x^1000000000 + 1)/(x - 1)",
        "1/(x^1000000000 - 1) + 1/(x - 1)",
        "(x^1000000000 - y^1000000000)/(x^2 - y^2)",
    ] {
        let found = RationalFunction::parse(ring, text).unwrap_err();
        assert!(
            matches!(
                found,
                Error::Parse {
                    kind: ParseErrorKind::TooLarge,
                    ..
                }
            ),
            "{text}: {found}"
        );
    }
}
