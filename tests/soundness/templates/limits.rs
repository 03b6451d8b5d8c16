//! Limits: by the leading orders of rational functions, and known ones of functions.

use crate::generated::generator::{Claim, Kind, REALS, Template, Truth, VALUES};
use crate::generated::random::Random;

pub const TEMPLATES: &[Template] = &[
    Template {
        name: "limits/rational, positive letter",
        kind: Kind::Other,
        header: REALS,
        make: |r, l| rational(r, l, false),
    },
    Template {
        name: "limits/rational, real letter",
        kind: Kind::Other,
        header: REALS,
        make: |r, l| rational(r, l, true),
    },
    Template {
        name: "limits/functions",
        kind: Kind::Other,
        header: REALS,
        make: functions,
    },
    Template {
        name: "limits/elsewhere",
        kind: Kind::Other,
        header: REALS,
        make: elsewhere,
    },
    Template {
        name: "limits/vanishing leading coefficient",
        kind: Kind::Other,
        header: VALUES,
        make: vanishing,
    },
];

fn word(holds: bool) -> Truth {
    if holds { Truth::True } else { Truth::False }
}

/// What a function tends to.
#[derive(Clone, PartialEq)]
enum Goal {
    Value(i64, i64),
    Plus,
    Minus,
    /// Different on both sides.
    None,
}

impl Goal {
    fn latex(&self) -> String {
        match self {
            Goal::Value(0, _) => "0".into(),
            Goal::Value(a, 1) => a.to_string(),
            Goal::Value(a, b) if *a < 0 => format!("-\\frac{{{}}}{{{b}}}", -a),
            Goal::Value(a, b) => format!("\\frac{{{a}}}{{{b}}}"),
            Goal::Plus => "\\infty".into(),
            Goal::Minus | Goal::None => "-\\infty".into(),
        }
    }
}

fn written(coefficients: &[i64], x: &str) -> String {
    let mut out = String::new();
    for (k, c) in coefficients.iter().enumerate().rev() {
        if *c == 0 {
            continue;
        }
        let power = match k {
            0 => String::new(),
            1 => x.to_string(),
            k => format!("{x}^{k}"),
        };
        let sign = if *c < 0 {
            "-"
        } else if out.is_empty() {
            ""
        } else {
            "+"
        };
        match (c.abs(), power.is_empty()) {
            (1, false) => out += &format!(" {sign} {power}"),
            (c, _) => out += &format!(" {sign} {c}{power}"),
        }
    }
    out.trim().to_string()
}

/// A quotient of polynomials with numbers, at zero or at infinity.
fn rational(r: &mut Random, label: &str, real: bool) -> Claim {
    let x = if real {
        r.pick(&["x", "y", "p"])
    } else {
        r.pick(&["a", "b", "c"])
    };
    let poly = |r: &mut Random| loop {
        let degree = r.below(4);
        let c: Vec<i64> = (0..=degree)
            .map(|_| if r.once_in(3) { 0 } else { r.nonzero(-5, 5) })
            .collect();
        if c.iter().any(|c| *c != 0) {
            return c;
        }
    };
    let (a, b) = (poly(r), poly(r));
    let at_zero = r.once_in(2);
    // The leading term: the lowest at zero, the highest at infinity.
    let lead = |c: &[i64]| {
        let mut k: Vec<usize> = (0..c.len()).filter(|k| c[*k] != 0).collect();
        if !at_zero {
            k.reverse();
        }
        (c[k[0]], i64::try_from(k[0]).expect("small"))
    };
    let ((ca, ka), (cb, kb)) = (lead(&a), lead(&b));
    let order = if at_zero { ka - kb } else { kb - ka };
    let sign = (ca * cb).signum();
    let goal = match order {
        0 => {
            let g = gcd(ca.abs(), cb.abs());
            Goal::Value(sign * ca.abs() / g, cb.abs() / g)
        }
        o if o > 0 => Goal::Value(0, 1),
        // A pole of odd order is met from both sides where the letter is real.
        o if real && at_zero && o % 2 != 0 => Goal::None,
        _ if sign > 0 => Goal::Plus,
        _ => Goal::Minus,
    };
    let others = [
        Goal::Value(0, 1),
        Goal::Plus,
        Goal::Minus,
        Goal::Value(1, 1),
        Goal::Value(-2, 3),
    ];
    let shown = match (&goal, r.once_in(2)) {
        (Goal::None, _) => r.pick(&[Goal::Plus, Goal::Minus, Goal::Value(0, 1)]),
        (_, true) => goal.clone(),
        (_, false) => loop {
            let other = r.pick(&others);
            if other != goal {
                break other;
            }
        },
    };
    let end = if at_zero { "0" } else { "\\infty" };
    let latex = format!(
        "{x} \\to {end}, \\quad \\frac{{{}}}{{{}}} \\to {}",
        written(&a, x),
        written(&b, x),
        shown.latex()
    );
    Claim::of(label, &latex, word(shown == goal && goal != Goal::None)).last_link()
}

fn gcd(a: i64, b: i64) -> i64 {
    if b == 0 { a } else { gcd(b, a % b) }
}

fn functions(r: &mut Random, label: &str) -> Claim {
    let x = r.pick(&["a", "b"]);
    let k = r.between(2, 4);
    let (end, f, goal, wrong) = match r.below(14) {
        0 => ("\\infty", format!("e^{{-{k}{x}}}"), "0", "\\infty"),
        1 => ("\\infty", format!("{x}^{k} e^{{-{x}}}"), "0", "\\infty"),
        2 => ("0", format!("\\frac{{\\sin {x}}}{{{x}}}"), "1", "0"),
        3 => ("\\infty", format!("\\frac{{\\sin {x}}}{{{x}}}"), "0", "1"),
        4 => ("\\infty", format!("\\tanh {x}"), "1", "0"),
        5 => ("0", format!("\\ln {x}"), "-\\infty", "\\infty"),
        6 => ("\\infty", format!("\\ln {x}"), "\\infty", "0"),
        7 => (
            "\\infty",
            format!("\\frac{{\\ln {x}}}{{{x}}}"),
            "0",
            "\\infty",
        ),
        8 => ("0", format!("\\cos {x}"), "1", "0"),
        // Without a limit.
        9 => ("\\infty", format!("\\cos {x}"), "none", "0"),
        10 => ("\\infty", format!("{x}\\sin {x}"), "none", "\\infty"),
        11 => (
            "\\infty",
            format!("\\sqrt{{{x}^2 + {k}}} - {x}"),
            "0",
            "\\infty",
        ),
        12 => (
            "0",
            format!("\\frac{{1 - \\cos {x}}}{{{x}^2}}"),
            "\\frac{1}{2}",
            "0",
        ),
        _ => ("0", format!("\\sqrt{{{x}}} + {k}"), "positive", "0"),
    };
    let holds = r.once_in(2) && goal != "none";
    let shown = match (holds, goal) {
        (true, "positive") => k.to_string(),
        (true, goal) => goal.to_string(),
        (false, _) => wrong.to_string(),
    };
    let latex = format!("{x} \\to {end}, \\quad {f} \\to {shown}");
    Claim::of(label, &latex, word(holds)).last_link()
}

/// A limit at another place than zero and infinity.
fn elsewhere(r: &mut Random, label: &str) -> Claim {
    let x = r.pick(&["x", "y", "a"]);
    let k = r.between(1, 5);
    let (f, goal) = match r.below(4) {
        0 => (format!("{x}^2"), k * k),
        1 => (format!("2{x} + 1"), 2 * k + 1),
        2 => (format!("\\frac{{{x}^2 - {}}}{{{x} - {k}}}", k * k), 2 * k),
        _ => (format!("({x} - {k})({x} + 3)"), 0),
    };
    let holds = r.once_in(2);
    let shown = if holds { goal } else { goal + r.nonzero(1, 3) };
    let latex = format!("{x} \\to {k}, \\quad {f} \\to {shown}");
    Claim::of(label, &latex, word(holds)).last_link()
}

/// Coefficients that are letters: one that may vanish decides.
fn vanishing(r: &mut Random, label: &str) -> Claim {
    // s and z are real: s has the value 0. Of a positive letter the leading coefficient has a sign.
    let (f, end, goal, holds) = match r.below(7) {
        0 => ("\\frac{s a^2 + a}{a + 1}", "\\infty", "\\infty", false),
        1 => ("\\frac{s a^2 + a}{a^2 + 1}", "\\infty", "s", true),
        2 => ("\\frac{b a^2 + a}{a + 1}", "\\infty", "\\infty", true),
        3 => ("\\frac{z a^2 + a}{a + 1}", "\\infty", "\\infty", false),
        4 => ("\\frac{b}{z^2 + a}", "\\infty", "0", true),
        5 => (
            "\\frac{(b - c) a^2 + a}{a + 1}",
            "\\infty",
            "\\infty",
            false,
        ),
        _ => ("\\frac{b + a}{c + a}", "0", "\\frac{b}{c}", true),
    };
    let latex = format!("a \\to {end}, \\quad {f} \\to {goal}");
    Claim::of(label, &latex, word(holds)).last_link()
}
