//! Limits of what has an argument at the goal, and integrals that diverge, beside the similar ones that do not:
//! difference quotients, divergent integrals inside of other things, removable poles under a cosine,
//! coefficients of what diverges that may vanish, and spectra that do not decay where distributions are declared.

use super::signs::{Family, LETTERS, Random};
use super::unwritten::Truth::{False, Open, True};
use super::unwritten::{Claim, undecided};

/// A function of q with its derivative.
const FUNCTIONS: &[(&str, &str, &str)] = &[
    ("F", "q^2 + q + 1", "2q + 1"),
    ("G", r"\frac{1}{q + 3}", r"-\frac{1}{(q + 3)^2}"),
    ("H", "e^{2q}", "2e^{2q}"),
    ("L", "q^3 - 2q", "3q^2 - 2"),
    ("C", r"\cos q", r"-\sin q"),
    ("Q", "aq^2 + bq", "2aq + b"),
];

fn with_functions() -> String {
    let mut head = LETTERS.replace("y = {", "q = { }\nt = { }\ny = {");
    for (k, (name, body, _)) in FUNCTIONS.iter().enumerate() {
        head += &format!("```math f{k} define\n{name}(q) = {body}\n```\n");
    }
    head + "```math fk define\nK(q, t) = q + t^2\n```\n\
            ```math fp define\nP(q) = \\frac{1}{q^2}\n```\n\
            ```math fr define\nR(q) = \\frac{q + a}{q}\n```\n\
            ```math fs define\ns(q) = \\begin{cases} 1 & q \\ge 0 \\\\ 2 & q < 0 \\end{cases}\n```\n"
}

/// The increment of a function over that of its argument is the derivative, whatever the goal is called.
#[test]
fn difference_quotients() {
    let mut random = Random::new(91);
    let mut family = Family::new("difference quotients", &with_functions());
    for (name, body, derivative) in FUNCTIONS {
        for goal in ["0", "1", "2", "y", "a", "-1", "b"] {
            if *name == "G" && goal == "y" {
                continue;
            }
            let at = |f: &str| format!("({})", f.replace('q', &format!("({goal})")));
            let (value, slope) = (at(body), at(derivative));
            let step = match goal {
                "0" => "x".to_owned(),
                "-1" => "(x + 1)".to_owned(),
                _ => format!("(x - {goal})"),
            };
            let flat = *name == "C" && goal == "0";
            let forms = [
                (
                    format!(r"\frac{{{name}(x) - {name}({goal})}}{{{step}}}"),
                    slope.clone(),
                    false,
                ),
                (
                    format!(r"\frac{{{name}({goal}) - {name}(x)}}{{2{step}}}"),
                    format!(r"-\frac{{1}}{{2}}{slope}"),
                    false,
                ),
                (
                    format!(r"\frac{{{name}({goal}) - {value}}}{{{step}}}"),
                    "0".to_owned(),
                    true,
                ),
                (
                    format!(r"{name}(x) - {name}({goal}) + {step}"),
                    "0".to_owned(),
                    true,
                ),
                (
                    format!(r"\frac{{{name}(x)^2 - {name}({goal})^2}}{{{step}}}"),
                    format!("2{value}{slope}"),
                    false,
                ),
                (
                    format!(r"\frac{{{name}(x) - {name}({goal}) - {step}{slope}}}{{{step}}}"),
                    "0".to_owned(),
                    true,
                ),
            ];
            let (form, limit, zero) = random.pick(&forms).clone();
            family.add(format!(r"x \to {goal}, \quad {form} \to {limit}"), true);
            family.add(
                format!(r"x \to {goal}, \quad {form} \to {limit} + 1"),
                false,
            );
            // Zero is what the argument at the goal would give if it moved.
            let (form, limit, _) = forms[0].clone();
            family.add(format!(r"x \to {goal}, \quad {form} \to {limit}"), true);
            let vanishing = ["Q", "F", "L"].contains(name) && ["y", "a", "b"].contains(&goal);
            if !flat && !vanishing {
                family.add(format!(r"x \to {goal}, \quad {form} \to 0"), false);
            }
            if !flat && zero {
                let form = &forms[2].0;
                family.add(format!(r"x \to {goal}, \quad {form} \to {slope}"), false);
            }
        }
    }
    for (claim, truth) in [
        (r"x \to 0, \quad \frac{K(x, 0) - x}{x^2} \to 0", true),
        (r"x \to 0, \quad \frac{K(x, 0) - x}{x^2} \to 1", false),
        (r"x \to 0, \quad \frac{K(0, x)}{x^2} \to 1", true),
        (r"x \to 0, \quad \frac{K(0, 0) - x}{x} \to -1", true),
        (r"x \to 1, \quad \frac{F(2 - x) - F(1)}{x - 1} \to -3", true),
        (
            r"x \to 1, \quad \frac{F(2 - x) - F(1)}{x - 1} \to -6",
            false,
        ),
        (
            r"x \to 0, \quad \frac{F(x) - F(0) - xF'(0)}{x^2} \to 1",
            true,
        ),
        (
            r"x \to 0, \quad \frac{F(x) - F(0) - xF'(0)}{x^2} \to 0",
            false,
        ),
        (r"x \to t, \quad \int_0^1 F(t)\,dt \to \frac{11}{6}", true),
        (r"x \to t, \quad \int_0^1 F(t)\,dt \to t^2 + t + 1", false),
        (r"x \to k, \quad \sum_{k=0}^2 F(k) \to 11", true),
        (r"x \to k, \quad \sum_{k=0}^2 F(k) \to 3F(k)", false),
        (r"x \to 0, \quad F(0) \to 1", true),
        (r"x \to 0, \quad F(0) \to 2", false),
        (r"x \to y, \quad F(y) \to F(y)", true),
        (r"x \to y, \quad F(y) \to F(y) + 1", false),
        (r"x \to y, \quad F(y) \to F(x) + 1", false),
        (r"x \to \infty, \quad F(0) \to 1", true),
        (r"x \to \infty, \quad F(0) \to 3", false),
        (r"x \to \infty, \quad F(0) + G(0) \to \frac{4}{3}", true),
        // Where the argument is the goal and there is no value, the limit there is meant.
        (r"x \to 0, \quad P(0) \to \infty", true),
        (r"x \to 0, \quad P(0) \to -\infty", false),
        (r"x \to 0, \quad P(0) \to 0", false),
        (r"x \to 0, \quad 1 - 2P(0) \to -\infty", true),
        (r"x \to 0, \quad 1 - 2P(0) \to \infty", false),
        // A step: its value, or from both sides.
        (r"x \to 0, \quad s(0) \to 1", true),
        (r"x \to 0, \quad s(0) \to 2", false),
        (r"x \to 0, \quad s(0) \to 3", false),
        (r"x \to 0, \quad \frac{s(0) - 1}{x} \to 0", true),
        (r"x \to 0, \quad s(x) - s(0) \to 0", false),
    ] {
        family.add(claim, truth);
    }
    assert!(family.len() >= 150);
    family.decides(0.9, 0.9);
}

const HEAD: &str = r#"```toml symbols
x = { }
y = { }
t = { }
'\omega' = { }
a = { positive = true }
b = { positive = true }
c = { positive = true }
```
```toml notation
e = { constant = "e" }
i = { constant = "i" }
'\pi' = { constant = "pi" }
```
"#;

/// An integral that diverges decides what it stands in only where nothing can make up for it.
#[test]
fn what_diverges_inside() {
    let grows = [
        r"\int_0^1 \frac{1}{t}\,dt",
        r"\int_0^a \frac{b}{t^2}\,dt",
        r"\int_1^\infty \frac{1}{t}\,dt",
        r"\int_0^\infty t\,dt",
        r"\int_0^\infty (1 + at)\,dt",
        r"\int_0^\infty e^{at}\,dt",
        r"\int_0^\infty (e^{at} + e^{bt})\,dt",
        r"\int_0^\infty \frac{t^2}{a^2 + t^2}\,dt",
        r"\int_{-\infty}^\infty \frac{1}{t^2}\,dt",
        r"\int_{-\infty}^\infty a\,dt",
        r"\int_0^\infty \frac{a + t^2}{t^2(b + t^2)}\,dt",
        r"\left(\int_a^0 \frac{-1}{t}\,dt\right)",
    ];
    let falls = [
        r"\int_1^0 \frac{1}{t}\,dt",
        r"\int_a^0 \frac{b}{t^2}\,dt",
        r"\int_0^1 \frac{-2}{t}\,dt",
        r"\int_0^\infty (-a - t)\,dt",
    ];
    let forms = [
        (r"I \to \infty", True),
        (r"I \to -\infty", False),
        (r"I \to 5", False),
        (r"-I \to -\infty", True),
        (r"-I \to \infty", False),
        (r"y - I \to -\infty", True),
        (r"y - I \to \infty", False),
        (r"I + 3\cos y \to \infty", True),
        (r"aI \to \infty", True),
        (r"aI \to -\infty", False),
        (r"-\frac{I}{2a} \to -\infty", True),
        (r"-\frac{I}{2a} \to \infty", False),
        (r"2I + aI \to \infty", True),
        (r"\frac{1}{I} \to \infty", False),
        (r"\frac{a}{1 + I} \to \infty", False),
        (r"e^{-I} \to \infty", False),
        (r"a^{-I} \to \infty", Open),
        (r"\cos(I) \to \infty", False),
        (r"iI \to \infty", False),
        (r"0 \cdot I \to \infty", False),
        (r"yI \to \infty", False),
        (r"(a - b)I \to \infty", False),
        (r"I - 2I \to \infty", False),
        (r"I - I \to 0", Open),
        (r"x \to 0, \quad xI \to \infty", False),
        (r"x \to \infty, \quad e^{-x}I \to \infty", False),
        (r"x \to 0, \quad \frac{\sin x}{x} - I \to \infty", False),
        (r"\int_0^{-1} I\,dx \to \infty", False),
        (r"\sum_{k=1}^{2} (-1)^k I \to \infty", Open),
        (r"I = 5", False),
        (r"y + 2I = y", False),
        (r"I = \infty", True),
        (r"-I = \infty", False),
        (r"I = I", Open),
        (r"yI = 0", Open),
        (r"I > 0", True),
        (r"I \ne 5", True),
    ];
    let mut claims = Vec::new();
    for integral in grows {
        for (form, truth) in forms {
            claims.push(Claim::plain(
                form.replace('I', &format!("{{{integral}}}")),
                truth,
            ));
        }
    }
    for integral in falls {
        for (form, truth) in [
            (r"I \to -\infty", True),
            (r"I \to \infty", False),
            (r"-I \to \infty", True),
            (r"a - 2I \to \infty", True),
            (r"a - 2I \to -\infty", False),
            (r"\frac{a}{I} \to \infty", False),
        ] {
            claims.push(Claim::plain(form.replace('I', integral), truth));
        }
    }
    let open = undecided(HEAD, &claims);
    assert!(
        2 * open.len() < claims.len(),
        "{} of {}: {open:#?}",
        open.len(),
        claims.len()
    );
}

/// What has a pole in its parts and none as a whole has a value.
#[test]
fn removable_poles() {
    let mut claims = Vec::new();
    let frequencies = [
        ("", "(1)"),
        ("2", "(2)"),
        ("a", "a"),
        ("3b", "(3b)"),
        ("x", "|x|"),
    ];
    for (k, size) in frequencies {
        for (p, square) in [("1", "1"), ("b", "b^2"), ("2", "4")] {
            let plain = format!(r"\frac{{1 - \cos {k}t}}{{t^2}}");
            let of_plain = format!(r"\frac{{\pi}}{{2}}{size}");
            let with = format!(r"\frac{{1 - \cos {k}t}}{{t^2({square} + t^2)}}");
            let of_with = format!(
                r"\frac{{\pi}}{{2 \cdot {square}}}\left({size} - \frac{{1 - e^{{-{size}{}}}}}{{{p}}}\right)",
                if p == "1" {
                    String::new()
                } else {
                    format!(r"\cdot {p}")
                }
            );
            for (integrand, value) in [
                (plain.clone(), of_plain.clone()),
                (format!("c{plain}"), format!("c{of_plain}")),
                (
                    format!(r"\left({plain} + \frac{{1}}{{{square} + t^2}}\right)"),
                    format!(r"{of_plain} + \frac{{\pi}}{{2 \cdot {p}}}"),
                ),
                (
                    format!(r"\left(\frac{{c}}{{t^2}} - \frac{{c\cos {k}t}}{{t^2}}\right)"),
                    format!("c{of_plain}"),
                ),
                (with, of_with),
            ] {
                let half = format!(r"\int_0^\infty {integrand}\,dt");
                let whole = format!(r"\int_{{-\infty}}^\infty {integrand}\,dt");
                claims.push(Claim::plain(format!("{half} = {value}"), True));
                claims.push(Claim::plain(
                    format!("{whole} = 2\\left({value}\\right)"),
                    True,
                ));
                claims.push(Claim::plain(format!("{half} = {value} + 1"), False));
                claims.push(Claim::plain(format!(r"{half} \to \infty"), False));
            }
        }
    }
    for (p, square) in [("1", "1"), ("2", "4"), ("b", "b^2")] {
        for (above, value) in [
            (
                format!(r"\cos\frac{{\pi t}}{{2 \cdot {p}}}"),
                format!(r"\frac{{\pi}}{{2 \cdot {p}}}"),
            ),
            (
                format!(r"\cos\frac{{3\pi t}}{{2 \cdot {p}}}"),
                format!(r"-\frac{{\pi}}{{2 \cdot {p}}}"),
            ),
            (
                format!(r"\left(1 + \cos\frac{{\pi t}}{{{p}}}\right)"),
                "0".into(),
            ),
            (
                format!(r"\left(1 - \cos\frac{{2\pi t}}{{{p}}}\right)"),
                "0".into(),
            ),
        ] {
            let half = format!(r"\int_0^\infty \frac{{{above}}}{{{square} - t^2}}\,dt");
            let whole = half.replace("_0", r"_{-\infty}");
            claims.push(Claim::plain(format!("{half} = {value}"), True));
            claims.push(Claim::plain(
                format!("{whole} = 2\\left({value}\\right)"),
                True,
            ));
            claims.push(Claim::plain(format!("{half} = {value} + c"), False));
            claims.push(Claim::plain(format!(r"{half} \to \infty"), False));
        }
        // Poles that stay: principal values at most.
        let stays =
            format!(r"\int_0^\infty \frac{{\cos\frac{{\pi t}}{{{p}}}}}{{{square} - t^2}}\,dt");
        claims.push(Claim::plain(format!("{stays} = 0"), Open));
        claims.push(Claim::plain(
            format!(r"\int_0^\infty \frac{{1}}{{{square} - t^2}}\,dt = 0"),
            Open,
        ));
        for stays in [r"2 - \cos at", r"1 + \cos at", r"a"] {
            let integral = format!(r"\int_0^\infty \frac{{{stays}}}{{t^2({square} + t^2)}}\,dt");
            claims.push(Claim::plain(format!("{integral} = a"), False));
            claims.push(Claim::plain(format!(r"{integral} \to -\infty"), False));
            claims.push(Claim::plain(format!(r"{integral} \to \infty"), True));
        }
    }
    let open = undecided(HEAD, &claims);
    assert!(
        10 * open.len() < claims.len(),
        "{} of {}: {open:#?}",
        open.len(),
        claims.len()
    );
}

/// An integral that diverges unless a coefficient vanishes has a value where it does.
#[test]
fn coefficients_that_may_vanish() {
    // Integrals without a value but for Q = 0, and their values there.
    let forms = [
        (r"\int_0^\infty Qt\,dt", "0"),
        (r"\int_{-\infty}^\infty Q\,dt", "0"),
        (r"\int_0^1 \frac{Q}{t}\,dt", "0"),
        (r"\int_0^1 \left(\frac{Q}{t^2} + 1\right)dt", "1"),
        (r"\int_1^\infty \left(Qt + \frac{1}{t^2}\right)dt", "1"),
        (r"\int_0^\infty Qe^{t}\,dt", "0"),
        (r"\int_0^\infty (Qe^{t} + e^{-t})\,dt", "1"),
        (r"\int_0^\infty e^{t}\sin(Qt)\,dt", "0"),
        (
            r"\int_0^\infty \frac{Qt^2 + 1}{1 + t^2}\,dt",
            r"\frac{\pi}{2}",
        ),
        (
            r"\int_0^\infty \frac{t^2 + Q}{t^2(1 + t^2)}\,dt",
            r"\frac{\pi}{2}",
        ),
        (r"\int_0^\infty \frac{Q\cos t}{1}\,dt", "0"),
        (r"\int_0^\infty \frac{Qt^2\cos t}{1 + t^2}\,dt", "0"),
        (r"\int_0^\infty \frac{Q\cos t}{t^2}\,dt", "0"),
        (r"\int_0^\infty (1 - \cos(Qt))\,dt", "0"),
        (r"\int_{-\infty}^\infty \sin(Qt)\,dt", "0"),
        (
            r"\int_{-\infty}^\infty \frac{t^2\sin(Qt)}{1 + t^2}\,dt",
            "0",
        ),
        (r"\int_0^\infty \frac{Q}{(1 - t)^2(1 + t)^2}\,dt", "0"),
    ];
    let mut claims = Vec::new();
    for (form, value) in forms {
        for f in ["x", "(x - y)", "(a - b)", "xy", "(x^2 - 4)", "(x + 1)"] {
            let integral = form.replace('Q', f);
            claims.push(Claim::plain(format!("{integral} = {value}"), True));
            claims.push(Claim::plain(format!("{integral} = {value} + {f}"), True));
            claims.push(Claim::plain(format!("{integral} = {value} + 1"), False));
            claims.push(Claim::plain(format!("{value} + {f}^2 = {integral}"), True));
        }
    }
    for (claim, truth) in [
        (r"\int_1^\infty (t^a - t^b)\,dt = 0", True),
        (r"\int_0^1 (t^{-1-a} - t^{-1-b})\,dt = 0", True),
        (r"\int_0^\infty (e^{at} - e^{bt} + e^{-t})\,dt = 1", True),
        (r"\int_0^0 \frac{1}{t}\,dt = 0", True),
        (r"\int_x^0 \frac{1}{t}\,dt = x", True),
        (r"\int_{-\infty}^\infty t\,dt = 0", Open),
        (r"\int_{-\infty}^\infty \frac{t}{1 + t^2}\,dt = 0", Open),
        (r"\int_{-\infty}^\infty \frac{t}{1 + |t|}\,dt = 0", Open),
    ] {
        claims.push(Claim::plain(claim, truth));
    }
    undecided(HEAD, &claims);
    // Where the coefficient has a sign there is no value at all.
    let mut claims = Vec::new();
    for (form, _) in forms
        .iter()
        .filter(|(form, _)| !form.contains("sin") && !form.contains("1 - "))
    {
        for f in ["a", "(a + b)", "3", "(x^2 + 1)", "(-a)"] {
            let integral = form.replace('Q', f);
            claims.push(Claim::plain(format!("{integral} = 1"), False));
            claims.push(Claim::plain(format!("a = b + 2{integral}"), False));
        }
    }
    let open = undecided(HEAD, &claims);
    assert!(
        4 * open.len() < claims.len(),
        "{} of {}: {open:#?}",
        open.len(),
        claims.len()
    );
}

/// The Fourier integral of what does not decay is a distribution, with exponentials as with cosines.
#[test]
fn white_spectra() {
    let head = HEAD.replace(
        "```toml notation\n",
        "```toml notation\n'\\delta' = { dirac = true }\n",
    );
    let spectra = [
        ("1", r"2\pi\delta(t)"),
        ("a", r"2a\pi\delta(t)"),
        (r"\frac{1}{\omega^2 + a^2}", r"\frac{\pi}{a}e^{-a|t|}"),
        (
            r"\frac{\omega^2}{\omega^2 + a^2}",
            r"\left(2\pi\delta(t) - \pi ae^{-a|t|}\right)",
        ),
        (
            r"\frac{\omega^2 + b^2}{\omega^2 + 1}",
            r"\left(2\pi\delta(t) + \pi(b^2 - 1)e^{-|t|}\right)",
        ),
    ];
    let mut claims = Vec::new();
    for (spectrum, transform) in spectra {
        for (factor, of_factor) in [("", ""), ("c", "c"), (r"\frac{1}{2\pi}", r"\frac{1}{2\pi}")] {
            for wave in [
                r"\cos(\omega t)",
                r"e^{i\omega t}",
                r"e^{-i\omega t}",
                r"(\cos(\omega t) + i\sin(\omega t))",
                r"(\cos(\omega t) + y\sin(\omega t))",
            ] {
                let integral = format!(
                    r"\int_{{-\infty}}^\infty {factor}\left({spectrum}\right){wave}\,d\omega"
                );
                let value = format!("{of_factor}\\left({transform}\\right)");
                claims.push(Claim::plain(format!("{integral} = {value}"), True));
                claims.push(Claim::plain(format!("{integral} = {value} + c"), False));
                claims.push(Claim::plain(format!("{integral} = 2{value}"), False));
            }
            let odd = format!(
                r"\int_{{-\infty}}^\infty {factor}\left({spectrum}\right)\sin(\omega t)\,d\omega"
            );
            claims.push(Claim::plain(format!("{odd} = 0"), True));
            claims.push(Claim::plain(format!("{odd} = c"), False));
        }
    }
    for (claim, truth) in [
        (
            r"\int_{-\infty}^\infty \omega^2\cos(\omega t)\,d\omega = c",
            Open,
        ),
        (
            r"\int_{-\infty}^\infty \omega^2\sin(\omega t)\,d\omega = 0",
            True,
        ),
        (r"\int_{-\infty}^\infty \cos(3\omega)\,d\omega = 0", True),
        (r"\int_{-\infty}^\infty e^{3i\omega}\,d\omega = 0", True),
        (
            r"\int_{-\infty}^\infty \frac{\omega}{i}e^{i\omega t}\,d\omega = c",
            Open,
        ),
        (
            r"\int_{-\infty}^\infty \frac{1}{i\omega + a}\,d\omega = \pi",
            Open,
        ),
    ] {
        claims.push(Claim::plain(claim, truth));
    }
    let open = undecided(&head, &claims);
    assert!(
        5 * open.len() < 2 * claims.len(),
        "{} of {}: {open:#?}",
        open.len(),
        claims.len()
    );
}

/// At a number, and at an integer, an oscillation has no end, whatever the letters for functions are.
#[test]
fn oscillations_at_numbers() {
    let head = HEAD.replace(
        "```toml notation\n",
        "```toml notation\n'\\delta' = { dirac = true }\n",
    );
    let head = head.replace("a = {", "n = { domain = \"integer\" }\na = {");
    let mut claims = Vec::new();
    let frequencies = [
        "1",
        r"\pi",
        r"\sqrt 2",
        r"e",
        r"(\ln 2)",
        "n",
        "(n + 2)",
        r"\frac{1}{n}",
        "2e",
        r"\pi^2",
        "2",
        r"\frac{\pi}{3}",
    ];
    for frequency in frequencies {
        for (integral, rest) in [
            (r"\int_0^\infty \cos(F t)\,dt", "0"),
            (r"\int_{-\infty}^\infty \cos(F t)\,dt", "0"),
            (r"\int_{-\infty}^\infty e^{F it}\,dt", "0"),
            (r"\int_0^\infty b\cos(F t)\,dt", "0"),
            (
                r"\int_0^\infty \frac{t^2}{b^2 + t^2}\cos(F t)\,dt",
                r"-\frac{\pi b}{2}e^{-F b}",
            ),
        ] {
            let integral = integral.replace('F', frequency);
            let rest = rest.replace('F', frequency);
            claims.push(Claim::plain(format!("{integral} = {rest}"), Open));
            claims.push(Claim::plain(format!("{integral} = {rest} + 1"), False));
            claims.push(Claim::plain(format!("1 - {integral} = 1 - ({rest})"), Open));
        }
    }
    undecided(&head, &claims);
}

/// A covariance has a limit only where it exists on the way to it, and an integral only where it exists between the
/// ends.
#[test]
fn covariances_on_the_way() {
    let head = r#"```toml symbols
t = { }
r = { function_of = "t" }
q = { function_of = "t" }
x = { }
a = { positive = true }
b = { positive = true }
g = { positive = true }
```
```toml notation
'\mathbf{V}' = { covariance_of = '\mathbf{z}' }
'V_{i,j}' = { entry_of = '\mathbf{V}' }
'\mathbf{0}' = { zero = true }
```
```math z define
\mathbf{z} = \begin{bmatrix} r \\ q \end{bmatrix}
```
```math A define
\mathbf{A} = MATRIX
```
```math Q define
\mathbf{Q} = NOISE
```
```math V solve \mathbf{V}
\mathbf{A}\mathbf{V} + \mathbf{V}\mathbf{A}^T + \mathbf{Q} = \mathbf{0}
```
"#;
    let noise = r"\begin{bmatrix} 0 & 0 \\ 0 & g \end{bmatrix}";
    let both = r"\begin{bmatrix} g & 0 \\ 0 & g \end{bmatrix}";
    // The value of V_11, of V_22 and their product with x by which the covariance exists for x > 0 only.
    for (matrix, noise, first, second) in [
        (
            r"\begin{bmatrix} 0 & 1 \\ -b & -x \end{bmatrix}",
            noise,
            r"\frac{g}{2bx}",
            r"\frac{g}{2x}",
        ),
        (
            r"\begin{bmatrix} -x & 0 \\ 0 & -x \end{bmatrix}",
            both,
            r"\frac{g}{2x}",
            r"\frac{g}{2x}",
        ),
        (
            r"\begin{bmatrix} -3x & 0 \\ 0 & -bx \end{bmatrix}",
            both,
            r"\frac{g}{6x}",
            r"\frac{g}{2bx}",
        ),
    ] {
        let head = head.replace("MATRIX", matrix).replace("NOISE", noise);
        let mut claims = Vec::new();
        for (entries, value) in [
            (["V_{11}", r"E\{r^2\}"], first),
            (["V_{22}", r"E\{q^2\}"], second),
        ] {
            let at = |x: &str| value.replace('x', &format!(r" \cdot {x}"));
            let scaled = value.replace('x', "");
            for v in entries {
                for (claim, truth) in [
                    (format!(r"x \to +0, \quad {v} \to \infty"), True),
                    (format!(r"x \to \infty, \quad {v} \to 0"), True),
                    (format!(r"x \to \infty, \quad x{v} \to {scaled}"), True),
                    (format!(r"x \to 2, \quad {v} \to {}", at("2")), True),
                    (format!(r"x \to 2, \quad {v} \to {}", at("3")), False),
                    (format!(r"x \to a, \quad {v} \to {}", at("a")), True),
                    (format!(r"x \to -0, \quad {v} \to -\infty"), Open),
                    (format!(r"x \to -0, \quad x{v} \to {scaled}"), Open),
                    (format!(r"x \to -\infty, \quad {v} \to 0"), Open),
                    (format!(r"x \to -2, \quad {v} \to {}", at("(-2)")), Open),
                    (format!(r"x \to -a, \quad {v} \to {}", at("(-a)")), Open),
                    (format!(r"x \to 0, \quad {v} \to \infty"), Open),
                    (format!(r"\int_{{-2}}^{{-1}} x{v}\,dx = {scaled}"), Open),
                    (format!(r"\int_{{-1}}^{{1}} x^2{v}\,dx = 0"), Open),
                    (format!(r"\int_1^2 x{v}\,dx = {scaled}"), True),
                    (format!(r"\int_1^2 x{v}\,dx = 2{scaled}"), False),
                ] {
                    claims.push(Claim::plain(claim, truth));
                }
            }
        }
        // As many others as a document has at least.
        while claims.len() < 100 {
            let k = claims.len();
            claims.push(Claim::plain(
                format!(
                    r"x \to {k}, \quad V_{{11}} \to {}",
                    first.replace('x', &format!(r" \cdot {k}"))
                ),
                True,
            ));
        }
        let open = undecided(&head, &claims);
        assert!(
            2 * open.len() < claims.len(),
            "{} of {}: {open:#?}",
            open.len(),
            claims.len()
        );
    }
}
