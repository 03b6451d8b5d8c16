//! What textbooks say: inequalities of elementary functions, what follows from hypotheses, functions that are
//! defined by cases. Each true claim stands beside relatives that are false; both are known by construction.

use crate::signs::{Family, LETTERS, Random};

/// How many claims stand in one document.
const PART: usize = 8;

/// Arguments that take every real value, zero among them, some of them together with another letter.
const ARGUMENTS: [&str; 3] = ["x", "x - 1", "x + y"];

/// Bounds of functions by polynomials and of one function by another.
#[test]
fn estimates_of_functions() {
    let mut family = Family::new("estimates of functions", LETTERS);
    for u in ARGUMENTS {
        for (claim, truth) in [
            (format!("e^{{{u}}} \\ge 1 + ({u})"), true),
            (format!("e^{{{u}}} > 1 + ({u})"), false),
            (format!("e^{{{u}}} \\le 1 + ({u})"), false),
            (
                format!("e^{{{u}}} \\ge 1 + ({u}) + \\frac{{({u})^2}}{{2}}"),
                false,
            ),
            (format!("\\cosh({u}) \\ge 1"), true),
            (format!("\\cosh({u}) > 1"), false),
            (format!("\\cosh({u}) \\ge 1 + \\frac{{({u})^2}}{{2}}"), true),
            (format!("\\cosh({u}) > 1 + \\frac{{({u})^2}}{{2}}"), false),
            (format!("\\cosh({u}) \\ge 1 + ({u})^2"), false),
            (format!("|\\sin({u})| \\le |{u}|"), true),
            (format!("\\sin({u}) \\le {u}"), false),
            (format!("\\cos({u}) \\ge 1 - \\frac{{({u})^2}}{{2}}"), true),
            (format!("\\cos({u}) > 1 - \\frac{{({u})^2}}{{2}}"), false),
            (format!("|\\tanh({u})| < 1"), true),
            (format!("\\tanh({u}) < \\frac{{1}}{{2}}"), false),
            (format!("\\frac{{|{u}|}}{{1 + |{u}|}} < 1"), true),
            (format!("\\frac{{|{u}|}}{{1 + |{u}|}} > 0"), false),
        ] {
            family.add(claim, truth);
        }
    }
    for u in ["a", "2a", "a + b", "ab", "b/2"] {
        for (claim, truth) in [
            (format!("\\ln({u}) \\le {u} - 1"), true),
            (format!("\\ln({u}) < {u} - 1"), false),
            (format!("\\ln({u}) \\le {u} - 2"), false),
            (format!("\\ln(1 + {u}) > \\frac{{{u}}}{{1 + {u}}}"), true),
            (format!("\\ln(1 + {u}) < \\frac{{{u}}}{{1 + {u}}}"), false),
            (format!("\\sinh({u}) > {u}"), true),
            (format!("\\sinh({u}) > 2({u})"), false),
            (
                format!("e^{{{u}}} > 1 + {u} + \\frac{{({u})^2}}{{2}}"),
                true,
            ),
            (format!("e^{{{u}}} > 1 + {u} + ({u})^2"), false),
        ] {
            family.add(claim, truth);
        }
    }
    for u in ["a", "b", "a/3", "c/2"] {
        family.add(format!("\\sin({u}) < {u}"), true);
        family.add(format!("\\sin({u}) > {u} - \\frac{{({u})^3}}{{6}}"), true);
        family.add(format!("\\sin({u}) > {u} - \\frac{{({u})^3}}{{7}}"), false);
    }
    family.decides_in_parts(PART, 0.9, 0.9);
}

/// Sines and cosines of one angle, sums of squares, means, and integers. Equality at an angle that is no rational
/// number is shown by no point: of the false ones with `<` some stay open.
#[test]
fn inequalities_by_cases() {
    let mut family = Family::new("inequalities by cases", LETTERS);
    for (p, q) in [(1, 1), (3, 4), (1, 2), (5, 12)] {
        let square = p * p + q * q;
        for u in ["x", "2x", "3z"] {
            for (claim, truth) in [
                (
                    format!("{p}\\sin({u}) + {q}\\cos({u}) \\le \\sqrt{{{square}}}"),
                    true,
                ),
                (
                    format!("{p}\\sin({u}) - {q}\\cos({u}) < \\sqrt{{{}}}", square + 1),
                    true,
                ),
                (
                    format!("{p}\\sin({u}) + {q}\\cos({u}) < \\sqrt{{{square}}}"),
                    false,
                ),
                (
                    format!(
                        "{p}\\sin({u}) + {q}\\cos({u}) \\le \\sqrt{{{}}}",
                        square - 1
                    ),
                    false,
                ),
            ] {
                family.add(claim, truth);
            }
        }
    }
    for u in ["x", "2x", "3z", "y/2"] {
        family.add(format!("\\sin({u})\\cos({u}) \\le \\frac{{1}}{{2}}"), true);
        family.add(format!("\\sin({u})\\cos({u}) < \\frac{{1}}{{2}}"), false);
        family.add(format!("\\sin({u})\\cos({u}) \\le \\frac{{1}}{{3}}"), false);
    }
    let sum = "(a + b + c)(\\frac{1}{a} + \\frac{1}{b} + \\frac{1}{c})";
    let nesbitt = "\\frac{a}{b + c} + \\frac{b}{a + c} + \\frac{c}{a + b}";
    for (claim, truth) in [
        (format!("{sum} \\ge 9"), true),
        (format!("{sum} > 9"), false),
        (format!("{sum} \\ge 10"), false),
        (format!("{nesbitt} \\ge \\frac{{3}}{{2}}"), true),
        (format!("{nesbitt} > \\frac{{3}}{{2}}"), false),
        (format!("{nesbitt} \\ge \\frac{{5}}{{3}}"), false),
        ("a^3 + b^3 + c^3 \\ge 3abc".into(), true),
        ("a^3 + b^3 + c^3 > 3abc".into(), false),
        ("x^3 + y^3 + z^3 \\ge 3xyz".into(), false),
    ] {
        family.add(claim, truth);
    }
    for s in -2..=2_i64 {
        let shifted = |by: i64| format!("(k + {})", s + by + 9);
        for (claim, truth) in [
            (format!("{}{} \\ge 0", shifted(0), shifted(1)), true),
            (format!("{}{} > 0", shifted(0), shifted(1)), false),
            (format!("{}{} \\ge 0", shifted(0), shifted(2)), false),
            (format!("{}^2 \\ge {}", shifted(0), shifted(0)), true),
            (format!("{}^2 > {}", shifted(0), shifted(0)), false),
            (format!("{}^2 \\ge 2{}", shifted(0), shifted(0)), false),
        ] {
            family.add(claim, truth);
        }
    }
    for (f, of) in [("e^{", "}"), ("(", ")^3"), ("2(", ")")] {
        for (u, v) in [("x", "y"), ("2x", "2y"), ("x + z", "y + z"), ("-y", "-x")] {
            let (left, right) = (format!("{f}{u}{of}"), format!("{f}{v}{of}"));
            family.add(
                format!("{left} < {right} \\quad \\text{{for }} x < y"),
                true,
            );
            family.add(
                format!("{left} > {right} \\quad \\text{{for }} x < y"),
                false,
            );
            family.add(
                format!("{left} < {right} \\quad \\text{{for }} x \\le y"),
                false,
            );
        }
    }
    for (left, right) in [
        ("\\ln a", "\\ln b"),
        ("\\sqrt{a}", "\\sqrt{b}"),
        ("a^2", "b^2"),
        ("a^c", "b^c"),
        ("\\frac{1}{b}", "\\frac{1}{a}"),
    ] {
        family.add(
            format!("{left} < {right} \\quad \\text{{for }} a < b"),
            true,
        );
        family.add(
            format!("{left} > {right} \\quad \\text{{for }} a < b"),
            false,
        );
        family.add(
            format!("{left} \\ne {right} + 1 - 1 \\quad \\text{{for }} a \\le b"),
            false,
        );
    }
    family.decides_in_parts(PART, 0.9, 0.75);
}

/// What follows from an equation that no letter is solved from, and what does not.
#[test]
fn conclusions_from_hypotheses() {
    let mut family = Family::new("conclusions from hypotheses", LETTERS);
    let mut random = Random::new(20_261_130);
    let mut add = |claim: String, hypothesis: String, truth: bool| {
        family.add(format!("{claim} \\quad \\text{{for }} {hypothesis}"), truth);
    };
    for _ in 0..4 {
        let (p, q) = (random.between(1, 5), random.between(1, 5));
        let (s, t) = (random.between(1, 4), random.between(1, 4));
        // Sums of squares.
        let squares = format!("{p}(x - {s})^2 + {q}(y + {t})^2 = 0");
        add(format!("x = {s}"), squares.clone(), true);
        add(format!("y = -{t}"), squares.clone(), true);
        add(format!("x = -{s}"), squares.clone(), false);
        add(format!("x + y = {}", s - t + 1), squares, false);
        // Functions that increase.
        for (left, right) in [
            (format!("e^{{{p}x}}"), format!("e^{{{p}y}}")),
            (format!("{p}x^3"), format!("{p}y^3")),
            (format!("x^3 + {q}x"), format!("y^3 + {q}y")),
            (format!("e^x + {q}x"), format!("e^y + {q}y")),
            (format!("\\sinh({p}x)"), format!("\\sinh({p}y)")),
        ] {
            let equation = format!("{left} = {right}");
            add("x = y".into(), equation.clone(), true);
            add("x = -y".into(), equation.clone(), false);
            add(format!("x = y + {p}"), equation, false);
        }
        for (left, right) in [
            (format!("\\ln({p}a)"), format!("\\ln({p}b)")),
            (format!("{p}a^2"), format!("{p}b^2")),
            (format!("{p}a^4"), format!("{p}b^4")),
            (format!("a + {q}\\ln a"), format!("b + {q}\\ln b")),
        ] {
            add("a = b".into(), format!("{left} = {right}"), true);
            add("a = 2b".into(), format!("{left} = {right}"), false);
        }
        // Moduli, and functions that are even.
        add(format!("x = {s}"), format!("|x - {s}| = 0"), true);
        add(format!("x = {s}"), format!("|x| = {s}"), false);
        add("x = y".into(), format!("{p}x^2 = {p}y^2"), false);
        add("x = y".into(), "\\cosh x = \\cosh y".into(), false);
        add("x = 0".into(), format!("e^{{{p}x}} = 1"), true);
        add("x = 1".into(), format!("e^{{{p}x}} = 1"), false);
        add("a = 1".into(), format!("{p}\\ln a = 0"), true);
        add(format!("a = {}", p + 1), format!("{p}\\ln a = 0"), false);
        add(
            format!("x = {s}"),
            format!("x \\ge {s}, \\quad x \\le {s}"),
            true,
        );
        add(
            format!("x = {s}"),
            format!("x \\ge {s}, \\quad x \\le {}", s + 1),
            false,
        );
    }
    family.decides_in_parts(PART, 0.9, 0.85);
}

/// Functions that are defined by cases: parity, signs, and what they are equal to.
#[test]
fn functions_by_cases() {
    for k in 1..=12 {
        let definitions = format!(
            "\n```math d1 define\nf(x) = \\begin{{cases}} {k}x & x \\ge 0 \\\\ -{k}x & x < 0 \\end{{cases}}\n```\n\
             \n```math d2 define\ng(x) = \\begin{{cases}} {k}x^2 & x \\ge 0 \\\\ -{k}x^2 & x < 0 \\end{{cases}}\n```\n\
             \n```math d3 define\nh(x) = \\begin{{cases}} x - {k} & x > {k} \\\\ 0 & x \\le {k} \\end{{cases}}\n```\n"
        );
        let name = format!("functions by cases, {k}");
        let mut family = Family::new(&name, &format!("{LETTERS}{definitions}"));
        let square = k * k;
        for (claim, truth) in [
            ("f(-x) = f(x)".into(), true),
            ("f(-x) = -f(x)".into(), false),
            ("g(-x) = -g(x)".into(), true),
            ("g(-x) = g(x)".into(), false),
            ("f(x) \\ge 0".into(), true),
            ("f(x) > 0".into(), false),
            (format!("f(x) \\ge {k}x"), true),
            (format!("f(x) > {k}x"), false),
            (format!("f(x)^2 = {square}x^2"), true),
            (format!("f(x)^2 = {}x^2", square + 1), false),
            (format!("f(x) = {k}|x|"), true),
            (format!("f(x) = {k}x"), false),
            ("xg(x) \\ge 0".into(), true),
            ("g(x) \\ge 0".into(), false),
            ("h(x) \\ge 0".into(), true),
            ("h(x) > 0".into(), false),
            (format!("h(x) \\ge x - {k}"), true),
            ("h(x) \\ge x".into(), false),
            ("f(x - y) = f(y - x)".into(), true),
            ("f(x - y) = f(x + y)".into(), false),
        ] {
            let claim: String = claim;
            family.add(claim, truth);
        }
        family.decides_in_parts(PART, 0.9, 0.7);
    }
}

/// A polynomial in n and k with integer coefficients, in LaTeX, and whether it is odd for even and odd n and k.
fn polynomial(random: &mut Random) -> (String, [bool; 4]) {
    let mut text = String::new();
    let mut odd = [false; 4];
    for monomial in 0..6 {
        let coefficient = random.between(-3, 3);
        if coefficient == 0 {
            continue;
        }
        let sign = if coefficient < 0 { "-" } else { "+" };
        let (name, parity): (&str, [bool; 4]) = match monomial {
            0 => ("n", [false, true, false, true]),
            1 => ("k", [false, false, true, true]),
            2 => ("n^2", [false, true, false, true]),
            3 => ("nk", [false, false, false, true]),
            4 => ("k^3", [false, false, true, true]),
            _ => ("", [true; 4]),
        };
        text += &format!("{sign}{}{name}", coefficient.abs());
        for (o, p) in odd.iter_mut().zip(parity) {
            *o ^= p && coefficient % 2 != 0;
        }
    }
    match text.strip_prefix('+') {
        Some(rest) => (rest.into(), odd),
        None if text.is_empty() => ("2n".into(), odd),
        None => (text, odd),
    }
}

/// Powers of -1 and i with integer exponents: equal if and only if the exponents have the same parity for
/// all integers.
#[test]
fn powers_of_units() {
    let head = format!("{LETTERS}\n```toml notation\n'i' = {{ constant = \"i\" }}\n```\n");
    let mut family = Family::new("powers of units", &head);
    let mut random = Random::new(20_261_201);
    for _ in 0..10 {
        let ((p, odd), (q, other)) = (polynomial(&mut random), polynomial(&mut random));
        family.add(format!("(-1)^{{{p}}} = (-1)^{{{q}}}"), odd == other);
        family.add(format!("(-1)^{{{p} + n^2 + n}} = (-1)^{{{p} + 4k}}"), true);
        family.add(format!("i^{{2({p}) + 1}} = i(-1)^{{{q}}}"), odd == other);
        family.add(format!("i^{{2({p})}} = (-1)^{{{p}}}"), true);
    }
    family.decides_in_parts(PART, 1.0, 0.3);
}
