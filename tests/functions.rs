//! Damage to formulas with functions and integrals: each must be refuted, as the undamaged ones hold.

use rederive::audit::Audit;
use rederive::check::Options;
use rederive::document::{Document, VerdictWord};
use std::path::Path;

fn read(name: &str) -> String {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("proofs/schiehlen-2006");
    // The measure of (20) mended, so that what depends on it can be judged.
    std::fs::read_to_string(folder.join(name))
        .expect("a document")
        .replace(r"\cos \Omega\xi d\xi", r"\cos \Omega\xi d\Omega")
}

fn word(text: &str, label: &str, member: usize) -> VerdictWord {
    let document = Document::parse("damaged.md", text).unwrap_or_else(|d| panic!("{d:?}"));
    let options = Options {
        repair: false,
        ..Options::default()
    };
    let audit = Audit::of(&document, options).unwrap_or_else(|r| panic!("{r}"));
    let equation = audit.model.equation(label).expect("the equation");
    let outcome = audit
        .outcomes_of(equation)
        .find(|o| o.member == member)
        .expect("the link");
    outcome.verdict.word()
}

/// Document, what is printed, what is put there, the link that it makes false, and the mistake.
const DAMAGE: [(&str, &str, &str, &str, usize, &str); 10] = [
    (
        "coloured-noise-1.md",
        r"\sigma^2 e^{-\alpha|\xi|}",
        r"\sigma^2 e^{\alpha|\xi|}",
        "20",
        1,
        "sign in the exponent",
    ),
    (
        "coloured-noise-1.md",
        r"\frac{2\alpha\sigma^2}{\pi}",
        r"\frac{\alpha\sigma^2}{\pi}",
        "20",
        1,
        "a lost factor 2",
    ),
    (
        "coloured-noise-1.md",
        r"\frac{2\alpha\sigma^2}{\pi}",
        r"2\alpha\sigma^2",
        "20-variance",
        2,
        "a missing pi",
    ),
    (
        "coloured-noise-1.md",
        r"(g^2 q_w = 2\alpha v \sigma^2),",
        r"(g^2 q_w = 2\alpha v \sigma),",
        "34",
        4,
        "exponent 1 for 2",
    ),
    (
        "coloured-noise-1.md",
        r"e^{\mathbf{F}|\tau|}",
        r"e^{-\mathbf{F}|\tau|}",
        "34-correlation",
        1,
        "sign in the exponent",
    ),
    (
        "coloured-noise-2.md",
        r"\cos \beta\xi,",
        r"\sin \beta\xi,",
        "20",
        1,
        "sine for cosine",
    ),
    (
        "coloured-noise-2.md",
        r"\cos \beta\xi,",
        r"\cos \alpha\xi,",
        "20",
        1,
        "alpha for beta",
    ),
    (
        "coloured-noise-2.md",
        r"\Omega^2 + \alpha^2 + \beta^2}",
        r"\Omega^2 + \alpha^2 - \beta^2}",
        "20",
        1,
        "a sign in the spectrum",
    ),
    (
        "roads.md",
        r"\frac{1}{v} \Phi_Z",
        r"v \Phi_Z",
        "26",
        1,
        "the speed inverted",
    ),
    (
        "roads.md",
        r"q_{\dot{\zeta}} = \pi v",
        r"q_{\dot{\zeta}} = 2\pi v",
        "29",
        2,
        "the two-sided intensity",
    ),
];

#[test]
fn every_damage_is_refuted() {
    for (name, from, to, label, member, mistake) in DAMAGE {
        let sound = read(name);
        assert!(sound.contains(from), "{name}: {from}");
        let damaged = sound.replacen(from, to, 1);
        assert_eq!(
            word(&damaged, label, member),
            VerdictWord::Refuted,
            "{name} ({label}): {mistake}"
        );
    }
    for (name, label, member) in [
        ("coloured-noise-1.md", "20", 1),
        ("coloured-noise-1.md", "20-variance", 2),
        ("coloured-noise-1.md", "34", 4),
        ("coloured-noise-1.md", "34-correlation", 1),
        ("coloured-noise-2.md", "20", 1),
        ("roads.md", "26", 1),
        ("roads.md", "29", 2),
    ] {
        assert_eq!(
            word(&read(name), label, member),
            VerdictWord::Holds,
            "{name} ({label})"
        );
    }
}

fn lone(latex: &str) -> VerdictWord {
    let text = format!(
        "```toml symbols\na = {{ positive = true }}\nb = {{ positive = true }}\nx = {{ meaning = \"\" }}\n\
         y = {{ meaning = \"\" }}\nw = {{ positive = true }}\n```\n```toml notation\n'\\pi' = {{ constant = \"pi\" }}\n\
         e = {{ constant = \"e\" }}\ni = {{ constant = \"i\" }}\n'\\delta' = {{ dirac = true }}\n```\n\
         ```math 1 claim\n{latex}\n```\n"
    );
    word(&text, "1", 1)
}

/// Pairs and values from tables: Erdelyi, *Tables of Integral Transforms* I (1954), sections 1.2 and
/// 1.3, and Abramowitz & Stegun (1964), ch. 4.
#[test]
fn known_formulas_hold() {
    for latex in [
        r"\int_0^\infty \frac{a}{a^2 + x^2} \cos xy dx = \frac{\pi}{2} e^{-a|y|}",
        r"\int_0^\infty \frac{1}{(a^2 + x^2)^2} \cos xb dx = \frac{\pi}{4a^3}(1 + ab)e^{-ab}",
        r"\int_{-\infty}^\infty \frac{1}{(x^2 + a^2)(x^2 + b^2)} dx = \frac{\pi}{ab(a + b)}",
        r"\int_0^\infty a \cos xy dx = \pi a\delta(y)",
        r"\int_0^a x^2 dx = \frac{1}{3}a^3",
        r"\int_0^a x^w dx = \frac{a^{w+1}}{w+1}",
        r"\cos 2x = 1 - 2\sin^2 x",
        r"\sin(x + y) = \sin x \cos y + \cos x \sin y",
        r"e^{ix} = \cos x + i\sin x",
        r"e^{x + y}e^{-y} = e^x",
        r"\cos(x + \pi) = -\cos x",
        r"\sqrt{a^2b} = a\sqrt{b}",
        r"(\sqrt{a} + \sqrt{b})(\sqrt{a} - \sqrt{b}) = a - b",
        r"\frac{1}{\sqrt{a} + \sqrt{b}} = \frac{\sqrt{a} - \sqrt{b}}{a - b}",
        r"(ab)^w = a^w b^w",
        r"\frac{d}{dx} e^{ax} \cos x = ae^{ax}\cos x - e^{ax}\sin x",
        r"\frac{d}{da} a^w = wa^{w - 1}",
        r"|x|^2 = x^2",
    ] {
        assert_eq!(lone(latex), VerdictWord::Holds, "{latex}");
    }
}

#[test]
fn false_formulas_are_refuted() {
    for latex in [
        r"\int_0^\infty \frac{a}{a^2 + x^2} \cos xy dx = \pi e^{-a|y|}",
        r"\int_0^\infty \frac{a}{a^2 + x^2} \cos xy dx = \frac{\pi}{2} e^{-ay}",
        r"\cos 2x = 1 + 2\sin^2 x",
        r"e^{x + y} = e^x + e^y",
        r"|x| = x",
        r"\sqrt{a + b} = \sqrt{a} + \sqrt{b}",
        r"(ab)^w = a^w b",
        r"e^{i\pi} = 1",
    ] {
        assert_eq!(lone(latex), VerdictWord::Refuted, "{latex}");
    }
}

/// What diverges has no value, and what is not decided is not refuted.
#[test]
fn no_value() {
    for latex in [
        r"\int_0^\infty \frac{1}{a^2 - x^2} dx = 0",
        r"\int_0^\infty \frac{x^2}{a^2 + x^2} dx = 0",
        r"\int_0^1 \frac{1}{x} dx = 0",
        r"\int_0^1 e^{x^2} dx = 1",
    ] {
        // An integral without a value is refuted, what is not known undecided.
        let word = lone(latex);
        assert!(
            matches!(word, VerdictWord::Undecided | VerdictWord::Refuted),
            "{latex}: {word}"
        );
    }
    assert_eq!(
        lone(r"\int_0^\infty \frac{x^2}{a^2 + x^2} dx \to \infty"),
        VerdictWord::Holds
    );
}
