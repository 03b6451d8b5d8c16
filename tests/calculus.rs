//! Derivatives, integrals and limits of what stands behind a definition: a name for a formula is no
//! constant, whoever differentiates by a letter of the formula.

use rederive::audit::Audit;
use rederive::check::Options;
use rederive::document::{Document, VerdictWord};

const LETTERS: &str = r#"```toml symbols
c = { positive = true, value = "3" }
m = { positive = true, value = "2" }
x = { positive = true, value = "5" }
t = { }
y = { function_of = "t" }
```

```math 1 define
a = \frac{c}{m}, \quad f = a^2 + x, \quad h = 2xc, \quad b = 3y
```

"#;

/// The verdict on the last link of a claim after the definitions above.
fn verdict(claim: &str, assume: &str) -> VerdictWord {
    let settings = match assume {
        "" => String::new(),
        relation => format!("```toml 2\nassume = ['{relation}']\n```\n"),
    };
    let text = format!("{LETTERS}```math 2 claim\n{claim}\n```\n{settings}");
    let document = Document::parse("test.md", &text).expect("a document");
    let audit = Audit::of(
        &document,
        Options {
            repair: false,
            ..Options::default()
        },
    );
    let audit = audit.unwrap_or_else(|rejection| panic!("{claim}: {rejection}"));
    audit.outcomes.last().expect("an outcome").verdict.word()
}

#[test]
fn a_derivative_reaches_behind_definitions() {
    for (claim, expected, hunts) in [
        (
            r"\frac{\mathrm{d}}{\mathrm{d}c} a = \frac{1}{m}",
            VerdictWord::Holds,
            "",
        ),
        (
            r"\frac{\mathrm{d}}{\mathrm{d}c} a = 0",
            VerdictWord::Refuted,
            "a name taken for a constant",
        ),
        (
            r"\frac{\mathrm{d}}{\mathrm{d}c} f = \frac{2c}{m^2}",
            VerdictWord::Holds,
            "",
        ),
        (
            r"\frac{\mathrm{d}}{\mathrm{d}c} f = \frac{c}{m^2}",
            VerdictWord::Refuted,
            "half the inner derivative",
        ),
        (
            r"\frac{\mathrm{d}}{\mathrm{d}m} f = -\frac{2c^2}{m^3}",
            VerdictWord::Holds,
            "",
        ),
        (
            r"\frac{\mathrm{d}}{\mathrm{d}m} f = \frac{2c^2}{m^3}",
            VerdictWord::Refuted,
            "the sign",
        ),
        (r"\dot{b} = 3\dot{y}", VerdictWord::Holds, ""),
        (
            r"\dot{b} = 0",
            VerdictWord::Refuted,
            "a process behind a name taken for a constant",
        ),
    ] {
        assert_eq!(verdict(claim, ""), expected, "{claim} {hunts}");
    }
}

#[test]
fn nothing_is_differentiated_by_a_letter_that_has_a_value() {
    for claim in [
        r"\frac{\mathrm{d}}{\mathrm{d}x} x^2 = 0",
        r"\frac{\mathrm{d}}{\mathrm{d}x} f = 1",
    ] {
        assert_eq!(verdict(claim, "x = 2"), VerdictWord::Undecided, "{claim}");
    }
    assert_eq!(
        verdict(r"\frac{\mathrm{d}}{\mathrm{d}x} f = 1", "c = 2"),
        VerdictWord::Holds
    );
}

#[test]
fn limits_reach_behind_definitions() {
    for (claim, expected) in [
        (r"x \to 0, \quad h \to 0", VerdictWord::Holds),
        (r"x \to \infty, \quad h \to \infty", VerdictWord::Holds),
        (r"x \to \infty, \quad -h \to -\infty", VerdictWord::Holds),
        (r"x \to \infty, \quad -h \to \infty", VerdictWord::Refuted),
        (
            r"x \to \infty, \quad \frac{2h + 1}{h} \to 2",
            VerdictWord::Holds,
        ),
        (
            r"x \to \infty, \quad \frac{2h + 1}{h} \to 3",
            VerdictWord::Refuted,
        ),
        (r"m \to \infty, \quad a \to 0", VerdictWord::Holds),
        (r"m \to \infty, \quad a \to c", VerdictWord::Refuted),
    ] {
        // The other end of a limit is tried even without a search.
        let found = match verdict(claim, "") {
            VerdictWord::Misprint => VerdictWord::Refuted,
            word => word,
        };
        assert_eq!(found, expected, "{claim}");
    }
}

#[test]
fn integrals_reach_behind_definitions() {
    for (claim, expected) in [
        (r"\int_0^1 h dx = c", VerdictWord::Holds),
        (r"\int_0^1 h dx = h", VerdictWord::Refuted),
        (r"\int_0^m a dx = c", VerdictWord::Holds),
    ] {
        assert_eq!(verdict(claim, ""), expected, "{claim}");
    }
}
