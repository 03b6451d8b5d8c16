//! Integrals from tables, divergent ones, and the Dirac distribution.

use crate::generated::generator::{Claim, Kind, REALS, Template, Truth};
use crate::generated::random::Random;

pub const TEMPLATES: &[Template] = &[
    Template {
        name: "integrals/polynomials",
        kind: Kind::Rational,
        header: REALS,
        make: polynomials,
    },
    Template {
        name: "integrals/functions",
        kind: Kind::Functions,
        header: REALS,
        make: functions,
    },
    Template {
        name: "integrals/half and whole axis",
        kind: Kind::Functions,
        header: REALS,
        make: improper,
    },
    Template {
        name: "integrals/integer frequencies",
        kind: Kind::Other,
        header: FOURIER,
        make: fourier,
    },
    Template {
        name: "integrals/divergent",
        kind: Kind::Other,
        header: REALS,
        make: divergent,
    },
    Template {
        name: "distributions/products",
        kind: Kind::Other,
        header: DIRAC,
        make: products,
    },
    Template {
        name: "distributions/integrals",
        kind: Kind::Other,
        header: DIRAC,
        make: sifting,
    },
];

const DIRAC: &str = r#"```toml symbols
a = { positive = true }
b = { positive = true }
x = { }
y = { }
s = { }
```
```toml notation
e = { constant = "e" }
'\delta' = { dirac = true }
```
"#;

const FOURIER: &str = r#"```toml symbols
k = { domain = "integer", range = "k > 0" }
n = { domain = "integer" }
m = { domain = "integer" }
x = { }
a = { positive = true }
```
```toml notation
e = { constant = "e" }
j = { constant = "i" }
'\pi' = { constant = "pi" }
```
"#;

/// Fourier integrals: k is positive, n and m may vanish or be the same, and then the value is another.
fn fourier(r: &mut Random, label: &str) -> Claim {
    let truth = |k: bool, wrong: bool| word(k && !wrong);
    let wrong = r.once_in(3);
    let tail = if wrong { " + a" } else { "" };
    let l = r.pick(&["k", "n"]);
    let positive = *l == *"k";
    let (latex, truth) = match r.below(7) {
        0 => (
            format!("\\int_0^\\pi \\cos({l}x)\\,dx = 0"),
            truth(positive, wrong),
        ),
        1 => (
            format!("\\int_0^\\pi \\sin({l}x)\\,dx = \\frac{{1 - (-1)^{l}}}{{{l}}}"),
            // Where n vanishes the right side has no value.
            match (positive, wrong) {
                (_, true) => Truth::False,
                (true, false) => Truth::True,
                (false, false) => Truth::Unforced,
            },
        ),
        2 => (
            format!("\\int_0^{{2\\pi}} \\cos^2({l}x)\\,dx = \\pi"),
            truth(positive, wrong),
        ),
        3 => (
            "\\int_0^{2\\pi} \\cos(nx)\\cos(mx)\\,dx = 0".into(),
            Truth::False,
        ),
        4 => (
            "\\int_0^{2\\pi} \\sin(nx)\\cos(mx)\\,dx = 0".into(),
            truth(true, wrong),
        ),
        5 => (
            format!("\\int_0^{{2\\pi}} e^{{j{l}x}}\\,dx = 0"),
            truth(positive, wrong),
        ),
        _ => (
            "\\int_0^\\pi x\\sin(kx)\\,dx = -\\frac{\\pi(-1)^k}{k}".into(),
            truth(true, wrong),
        ),
    };
    Claim::of(label, &format!("{latex}{tail}"), truth)
}

fn word(holds: bool) -> Truth {
    if holds { Truth::True } else { Truth::False }
}

fn fraction(a: i64, b: i64) -> String {
    match (a < 0, b) {
        (false, 1) => a.to_string(),
        (true, 1) => format!("-{}", -a),
        (false, b) => format!("\\frac{{{a}}}{{{b}}}"),
        (true, b) => format!("-\\frac{{{}}}{{{b}}}", -a),
    }
}

fn polynomials(r: &mut Random, label: &str) -> Claim {
    let (c, e) = (r.nonzero(-5, 5), r.between(0, 4));
    let (low, high) = (r.between(-3, 1), r.between(1, 4));
    let power = |x: i64| x.pow(u32::try_from(e + 1).expect("small"));
    let holds = r.once_in(2);
    let off = if holds { 0 } else { r.nonzero(-2, 2) };
    match r.below(3) {
        0 => {
            let value = c * (power(high) - power(low)) + off;
            Claim::of(
                label,
                &format!(
                    "\\int_{{{low}}}^{{{high}}} {c} x^{e} dx = {}",
                    fraction(value, e + 1)
                ),
                word(holds),
            )
        }
        1 => Claim::of(
            label,
            &format!(
                "\\int_0^a ({c} x^{e} + b) dx = {} a^{{{}}} + ab {}",
                fraction(c, e + 1),
                e + 1,
                if holds {
                    "".into()
                } else {
                    format!("+ ({off})a")
                }
            ),
            word(holds),
        ),
        _ => Claim::of(
            label,
            &format!(
                "\\int_a^b x^{e} dx = \\frac{{b^{{{0}}} - a^{{{0}}}}}{{{1}}}",
                e + 1,
                e + 1 + off.abs()
            ),
            word(holds),
        ),
    }
}

fn functions(r: &mut Random, label: &str) -> Claim {
    let k = r.between(1, 4);
    let holds = r.once_in(2);
    let (left, right) = match r.below(7) {
        0 => (
            format!("\\int_0^a \\cos({k}x) dx"),
            format!("\\frac{{\\sin({k}a)}}{{{k}}}"),
        ),
        1 => (
            format!("\\int_0^a e^{{-{k}x}} dx"),
            format!("\\frac{{1 - e^{{-{k}a}}}}{{{k}}}"),
        ),
        2 => (
            format!("\\int_0^\\pi \\sin^2({k}x) dx"),
            "\\frac{\\pi}{2}".into(),
        ),
        3 => (
            "\\int_0^a x e^{-bx} dx".into(),
            "\\frac{1 - e^{-ab} - ab e^{-ab}}{b^2}".into(),
        ),
        4 => (
            "\\int_0^a \\sinh(bx) dx".into(),
            "\\frac{\\cosh(ab) - 1}{b}".into(),
        ),
        5 => (
            format!("\\int_0^{{2\\pi}} \\cos(x)\\cos({}x) dx", k + 1),
            "0".into(),
        ),
        _ => ("\\int_0^1 \\sqrt{x} dx".to_string(), "\\frac{2}{3}".into()),
    };
    let right = if holds {
        right
    } else {
        r.pick(&[
            format!("{right} + a"),
            format!("-2({right}) + 1"),
            format!("2 + {right}"),
        ])
    };
    Claim::of(label, &format!("{left} = {right}"), word(holds))
}

fn improper(r: &mut Random, label: &str) -> Claim {
    let k = r.between(1, 4);
    let holds = r.once_in(2);
    let factorial: i64 = (1..=k).product();
    let (left, right) = match r.below(7) {
        0 => (
            "\\int_0^\\infty e^{-ax} dx".to_string(),
            "\\frac{1}{a}".to_string(),
        ),
        1 => (
            format!("\\int_0^\\infty x^{k} e^{{-ax}} dx"),
            format!("\\frac{{{factorial}}}{{a^{{{}}}}}", k + 1),
        ),
        2 => (
            "\\int_0^\\infty e^{-ax}\\cos(bx) dx".into(),
            "\\frac{a}{a^2 + b^2}".into(),
        ),
        3 => (
            "\\int_0^\\infty e^{-ax}\\sin(bx) dx".into(),
            "\\frac{b}{a^2 + b^2}".into(),
        ),
        4 => (
            "\\int_{-\\infty}^\\infty \\frac{1}{x^2 + a^2} dx".into(),
            "\\frac{\\pi}{a}".into(),
        ),
        5 => (
            "\\int_{-\\infty}^\\infty e^{-a|x|} dx".into(),
            "\\frac{2}{a}".into(),
        ),
        _ => (
            "\\int_0^\\infty \\frac{1}{(x^2 + a^2)(x^2 + b^2)} dx".into(),
            "\\frac{\\pi}{2ab(a + b)}".into(),
        ),
    };
    let right = if holds {
        right
    } else {
        r.pick(&[
            format!("2 \\cdot {right}"),
            format!("-{right}"),
            format!("{right} + {k}"),
        ])
    };
    Claim::of(label, &format!("{left} = {right}"), word(holds))
}

fn divergent(r: &mut Random, label: &str) -> Claim {
    let k = r.between(1, 3);
    let left = match r.below(11) {
        0 => "\\int_0^\\infty \\cos x dx".to_string(),
        1 => format!("\\int_0^\\infty \\sin({k}x) dx"),
        2 => format!("\\int_0^\\infty x^{k} dx"),
        3 => format!("\\int_0^1 \\frac{{1}}{{x^{k}}} dx"),
        4 => "\\int_{-1}^1 \\frac{1}{x} dx".into(),
        5 => format!("\\int_{{-1}}^{{1}} \\frac{{1}}{{x^{}}} dx", 2 * k),
        6 => format!("\\int_0^\\infty e^{{{k}x}} dx"),
        7 => "\\int_0^\\infty e^{xs} dx".into(),
        8 => "\\int_0^2 \\frac{1}{x - 1} dx".to_string(),
        9 => "\\int_{-\\infty}^\\infty x dx".into(),
        _ => "\\int_0^\\infty \\frac{1}{a^2 - x^2} dx".into(),
    };
    let right = match r.below(5) {
        0 => "0".to_string(),
        1 => format!("{k}"),
        2 => "-2".to_string(),
        3 => "-\\frac{1}{s}".to_string(),
        _ => format!("-\\frac{{1}}{{{k}}}"),
    };
    Claim::of(label, &format!("{left} = {right}"), Truth::Meaningless)
}

fn products(r: &mut Random, label: &str) -> Claim {
    let k = r.between(2, 5);
    let (latex, holds) = match r.below(10) {
        0 => ("x\\delta(x) = 0".to_string(), true),
        1 => (format!("x^{k}\\delta(x) = 0"), true),
        2 => (format!("x\\delta(x) = {k}\\delta(x)"), false),
        3 => (format!("(x + {k})\\delta(x) = {k}\\delta(x)"), true),
        4 => ("\\delta(-x) = \\delta(x)".into(), true),
        5 => ("\\delta(-x) = -\\delta(x)".into(), false),
        6 => (
            format!("\\delta({k}x) = \\frac{{1}}{{{k}}}\\delta(x)"),
            true,
        ),
        7 => (format!("\\delta({k}x) = {k}\\delta(x)"), false),
        8 => ("x\\delta(x - a) = a\\delta(x - a)".into(), true),
        _ => ("\\cos(x)\\delta(x) = \\delta(x)".into(), true),
    };
    Claim::of(label, &latex, word(holds))
}

fn sifting(r: &mut Random, label: &str) -> Claim {
    let k = r.between(2, 4);
    let holds = r.once_in(2);
    let (left, right) = match r.below(6) {
        0 => (
            "\\int_{-\\infty}^\\infty \\delta(x) dx".to_string(),
            "1".to_string(),
        ),
        1 => (
            format!("\\int_{{-\\infty}}^\\infty x^{k}\\delta(x - a) dx"),
            format!("a^{k}"),
        ),
        2 => (
            format!("\\int_{{-\\infty}}^\\infty \\cos({k}x)\\delta(x) dx"),
            "1".into(),
        ),
        3 => (
            "\\int_{-\\infty}^\\infty e^{-x}\\delta(x - y) dx".into(),
            "e^{-y}".into(),
        ),
        4 => (
            format!("\\int_{{-1}}^{{1}} (x + {k})\\delta(x) dx"),
            format!("{k}"),
        ),
        _ => ("\\int_1^2 \\delta(x) dx".into(), "0".into()),
    };
    let right = if holds {
        right
    } else {
        format!("{right} + {k}")
    };
    Claim::of(label, &format!("{left} = {right}"), word(holds))
}
