//! Statements in words: every predicate, of quantities of which its truth is known by construction.

use crate::generated::generator::{Claim, Kind, REALS, Template, Truth, define};
use crate::generated::random::Random;

pub const TEMPLATES: &[Template] = &[
    Template {
        name: "statements/positive",
        kind: Kind::Other,
        header: LETTERS,
        make: positive,
    },
    Template {
        name: "statements/monotone",
        kind: Kind::Other,
        header: LETTERS,
        make: monotone,
    },
    Template {
        name: "statements/convex",
        kind: Kind::Other,
        header: LETTERS,
        make: convex,
    },
    Template {
        name: "statements/optimum",
        kind: Kind::Other,
        header: LETTERS,
        make: optimum,
    },
    Template {
        name: "statements/nearly minimal",
        kind: Kind::Other,
        header: LETTERS,
        make: nearly,
    },
    Template {
        name: "statements/dependence",
        kind: Kind::Other,
        header: LETTERS,
        make: dependence,
    },
    Template {
        name: "statements/proportional",
        kind: Kind::Other,
        header: LETTERS,
        make: proportional,
    },
    Template {
        name: "statements/tends to",
        kind: Kind::Other,
        header: LETTERS,
        make: tends,
    },
    Template {
        name: "statements/equals",
        kind: Kind::Other,
        header: LETTERS,
        make: equals,
    },
    Template {
        name: "statements/small",
        kind: Kind::Other,
        header: LETTERS,
        make: small,
    },
    Template {
        name: "statements/separates",
        kind: Kind::Other,
        header: LETTERS,
        make: separates,
    },
    Template {
        name: "statements/explicit",
        kind: Kind::Other,
        header: LETTERS,
        make: explicit,
    },
    Template {
        name: "units/measured like",
        kind: Kind::Other,
        header: LETTERS,
        make: units,
    },
    Template {
        name: "relations/signs",
        kind: Kind::Other,
        header: REALS,
        make: relations,
    },
];

const LETTERS: &str = r#"```toml symbols
a = { unit = "kg", positive = true, value = "2" }
b = { unit = "m", positive = true, value = "3" }
c = { unit = "s", positive = true, value = "1/2" }
g = { unit = "1", positive = true, value = "7" }
x = { value = "2" }
y = { value = "-3" }
s = { value = "1" }
```
"#;

fn word(holds: bool) -> Truth {
    if holds { Truth::True } else { Truth::False }
}

/// A claim about a quantity with a name of its own.
fn about(label: &str, quantity: &str, predicate: &str, arguments: &str, truth: Truth) -> Claim {
    let name = format!("h_{{{}}}", label.trim_start_matches('c'));
    let settings = format!("of = ['{name}']\npredicate = \"{predicate}\"\n{arguments}");
    Claim::statement(label, settings.trim_end(), truth).after(&define(
        &format!("{label}d"),
        &format!("{name} = {quantity}"),
    ))
}

fn letters(r: &mut Random) -> (&'static str, &'static str) {
    let l = r.some(&["a", "b", "c", "g"], 2);
    (l[0], l[1])
}

fn positive(r: &mut Random, label: &str) -> Claim {
    let (a, b) = letters(r);
    let k = r.between(1, 5);
    let (q, holds) = match r.below(8) {
        0 => (format!("{a} + {k}{b}"), true),
        1 => (format!("{a}^2 - {a}{b} + {b}^2"), true),
        2 => (format!("{a} - {b}"), false),
        3 => (format!("({a} - {b})^2"), false),
        4 => (format!("({a} - {b})^2 + {k}"), true),
        5 => (format!("{a}^2 - 3{a}{b} + {b}^2"), false),
        6 => (format!("\\frac{{{a}}}{{{b} + {k}}}"), true),
        _ => (format!("{a} - {a}"), false),
    };
    about(label, &q, "positive", "", word(holds))
}

fn monotone(r: &mut Random, label: &str) -> Claim {
    let (a, b) = letters(r);
    let k = r.between(1, 5);
    // 1 increasing, -1 decreasing, 0 neither, 2 constant.
    let (q, kind) = match r.below(9) {
        0 => (format!("{a}^2 {b} + {k}"), 1),
        1 => (format!("\\frac{{{b}}}{{{a}}}"), -1),
        2 => (format!("{a} - \\frac{{{b}}}{{{a}}}"), 1),
        3 => (format!("{a} + \\frac{{{b}}}{{{a}}}"), 0),
        4 => (format!("{b}^2 + {k}"), 2),
        5 => (format!("\\frac{{{a}}}{{{a} + {b}}}"), 1),
        6 => (format!("\\frac{{1}}{{{a}^2 + {b}^2}}"), -1),
        7 => (format!("{a}^2 - {b}{a}"), 0),
        _ => (format!("-{k}{a}^3"), -1),
    };
    let (predicate, holds) = match r.below(4) {
        0 => ("increasing in", kind == 1),
        1 => ("decreasing in", kind == -1),
        2 => ("not monotone in", kind == 0),
        _ => ("independent of", kind == 2),
    };
    about(label, &q, predicate, &format!("in = \"{a}\""), word(holds))
}

fn convex(r: &mut Random, label: &str) -> Claim {
    let (a, b) = letters(r);
    let (q, holds) = match r.below(6) {
        0 => (format!("{a}^2 {b}"), true),
        1 => (format!("\\frac{{{b}}}{{{a}}} + {a}"), true),
        2 => (format!("{a} {b}"), false),
        3 => (format!("-{a}^2 + {b}"), false),
        4 => (format!("{a}^3 - {a}^2"), false),
        _ => (format!("{a}^3 + {b}{a}"), true),
    };
    about(
        label,
        &q,
        "convex in",
        &format!("in = \"{a}\""),
        word(holds),
    )
}

fn optimum(r: &mut Random, label: &str) -> Claim {
    let (a, b) = letters(r);
    let k = r.between(1, 5);
    // Quantity, the kind of its only optimum over positive values, and where it is.
    let (q, kind, place) = match r.below(7) {
        0 => (
            format!("{a} + \\frac{{{b}^2}}{{{a}}}"),
            1,
            Some(b.to_string()),
        ),
        1 => (
            format!("{a}^2 - {}{a}{b}", 2 * k),
            1,
            Some(format!("{k}{b}")),
        ),
        2 => (
            format!("{}{a}{b} - {a}^2", 2 * k),
            -1,
            Some(format!("{k}{b}")),
        ),
        3 => (format!("({a} - {b})^2"), 1, Some(b.to_string())),
        4 => (format!("{a} {b}"), 0, None),
        5 => (
            format!("\\frac{{{a}}}{{{a}^2 + {b}^2}}"),
            -1,
            Some(b.to_string()),
        ),
        _ => (format!("\\frac{{{b}}}{{{a}}}"), 0, None),
    };
    let least = r.once_in(2);
    let wanted = if least { 1 } else { -1 };
    if r.once_in(2) {
        let predicate = if least {
            "has a minimum in"
        } else {
            "has a maximum in"
        };
        return about(
            label,
            &q,
            predicate,
            &format!("in = \"{a}\""),
            word(kind == wanted),
        );
    }
    let predicate = if least { "minimal at" } else { "maximal at" };
    let right = r.once_in(2);
    let at = match (&place, right) {
        (Some(place), true) => place.clone(),
        _ => format!("{}{b}", k + 7),
    };
    about(
        label,
        &q,
        predicate,
        &format!("in = \"{a}\"\nat = '{at}'"),
        word(kind == wanted && right && place.is_some()),
    )
}

/// The loss at a value, by the modulus of the least one.
fn nearly(r: &mut Random, label: &str) -> Claim {
    // x^2 - 2 p x + c has the least value c - p^2 at p, and (at - p)^2 more at `at`.
    let p = r.between(2, 60);
    let c = r.pick(&[0, 1, p * p + 1, p * p + 50, -p]);
    let at = r.pick(&[1, 2, p - 1, p, p + 1, 2 * p]).max(1);
    let least = c - p * p;
    let loss = (at - p) * (at - p);
    // At most a tenth of the modulus; a least value of zero has no such loss but at it.
    let holds = 10 * loss <= least.abs();
    let q = format!("g^2 - {} g + {c}", 2 * p).replace("+ -", "- ");
    about(
        label,
        &q,
        "nearly minimal at",
        &format!("in = \"g\"\nat = \"{at}\""),
        word(holds),
    )
}

fn dependence(r: &mut Random, label: &str) -> Claim {
    let (a, b) = letters(r);
    let (q, free) = match r.below(5) {
        0 => (format!("\\frac{{{a}{b}}}{{{a}}}"), true),
        1 => (format!("({a} + {b})^2 - {a}^2 - 2{a}{b}"), true),
        2 => (format!("{a} + {b}"), false),
        3 => (format!("{b}^2 - {a}{b} + {a}^2"), false),
        _ => (format!("\\frac{{{b}{a} + {a}}}{{{a}}}"), true),
    };
    match r.once_in(2) {
        true => about(
            label,
            &q,
            "independent of",
            &format!("in = \"{a}\""),
            word(free),
        ),
        false => about(
            label,
            &q,
            "depends only on",
            &format!("in = \"{b}\""),
            word(free),
        ),
    }
}

fn proportional(r: &mut Random, label: &str) -> Claim {
    let (a, b) = letters(r);
    let k = r.between(1, 5);
    let (q, holds) = match r.below(5) {
        0 => (format!("{k}{a}{b}"), true),
        1 => (format!("{a}{b} + {a}"), true),
        2 => (format!("{a}^2"), false),
        3 => (format!("{a} + {k}"), false),
        _ => (format!("\\frac{{{b}}}{{{a}}}"), false),
    };
    about(
        label,
        &q,
        "proportional to",
        &format!("to = '{a}'"),
        word(holds),
    )
}

fn tends(r: &mut Random, label: &str) -> Claim {
    let (a, b) = letters(r);
    let (q, at, goal) = match r.below(8) {
        0 => (format!("\\frac{{{b}}}{{{a}}}"), "\\infty", "0"),
        1 => (format!("\\frac{{{b}}}{{{a}}}"), "0", "\\infty"),
        2 => (format!("{a}^2 - {b}{a}"), "\\infty", "\\infty"),
        3 => (format!("-{a}{b}"), "\\infty", "-\\infty"),
        4 => (format!("\\frac{{{a}}}{{{a} + {b}}}"), "\\infty", "1"),
        5 => (format!("\\frac{{{a}}}{{{a} + {b}}}"), "0", "0"),
        6 => (format!("\\frac{{{a}^2 + {b}}}{{{a}}}"), "0", "\\infty"),
        _ => (format!("{a} + 1"), "0", "1"),
    };
    let holds = r.once_in(2);
    let to = match holds {
        true => goal,
        false => loop {
            let other = r.pick(&["0", "\\infty", "-\\infty", "1"]);
            if other != goal {
                break other;
            }
        },
    };
    about(
        label,
        &q,
        "tends to",
        &format!("in = \"{a}\"\nas = '{at}'\nto = '{to}'"),
        word(holds),
    )
}

fn equals(r: &mut Random, label: &str) -> Claim {
    let (a, b) = letters(r);
    let k = r.between(2, 5);
    let (q, to, holds) = match r.below(4) {
        0 => (
            format!("({a} + {b})^2"),
            format!("{a}^2 + 2{a}{b} + {b}^2"),
            true,
        ),
        1 => (format!("{k}{a}"), a.to_string(), false),
        2 => (format!("\\frac{{{a}{b}}}{{{b}}}"), a.to_string(), true),
        _ => (format!("{a} + {b}"), format!("{a} - {b}"), false),
    };
    about(label, &q, "equals", &format!("to = '{to}'"), word(holds))
}

/// At the reference values, by the modulus.
fn small(r: &mut Random, label: &str) -> Claim {
    // g is 7, x is 2 and y is -3.
    let k = r.pick(&[1, 2, 5, 8, 12, 40]);
    let (q, to, value, other) = match r.below(3) {
        0 => (format!("{k}g"), "100g".to_string(), 7 * k, 700),
        1 => (format!("{k}y"), "20x".to_string(), -3 * k, 40),
        _ => (format!("{k}x"), "30y".to_string(), 2 * k, -90),
    };
    let (value, other): (i64, i64) = (value, other);
    let holds = 10 * value.abs() <= other.abs();
    about(
        label,
        &q,
        "small compared with",
        &format!("to = '{to}'"),
        word(holds),
    )
}

fn separates(r: &mut Random, label: &str) -> Claim {
    let (a, b) = letters(r);
    let k = r.between(1, 5);
    let (q, holds) = match r.below(5) {
        0 => (format!("{a}^2 + {b}"), true),
        1 => (format!("({a} + {k})({b}^2 + 1)"), true),
        2 => (format!("({a} + {b})^2"), false),
        3 => (format!("\\frac{{{a}}}{{{b}}}"), true),
        _ => (format!("{a}{b} + {a} + {b} + 1"), true),
    };
    about(
        label,
        &q,
        "separates into",
        &format!("groups = [[\"{a}\"], [\"{b}\"]]"),
        word(holds),
    )
}

fn explicit(r: &mut Random, label: &str) -> Claim {
    let (a, b) = letters(r);
    let (q, holds) = r.pick(&[
        (format!("\\frac{{{a}}}{{{a} + {b}}}"), true),
        (format!("{a}^2 + 1"), true),
        (format!("\\sqrt{{{a}}}"), false),
        (format!("\\sqrt{{{a}^2 + {b}^2}}"), false),
        (format!("\\frac{{\\sqrt{{{a}^2}}}}{{{b}}}"), true),
    ]);
    about(label, &q, "explicit", "", word(holds))
}

fn units(r: &mut Random, label: &str) -> Claim {
    // Exponents of kg, m, s.
    let make = |r: &mut Random| {
        let e = [r.between(-2, 3), r.between(-2, 3), r.between(-2, 3)];
        let text: Vec<String> = ["a", "b", "c"]
            .iter()
            .zip(e)
            .filter(|(_, e)| *e != 0)
            .map(|(l, e)| format!("{l}^{{{e}}}"))
            .collect();
        (
            e,
            if text.is_empty() {
                "g".to_string()
            } else {
                text.join(" ")
            },
        )
    };
    let (one, q) = make(r);
    let (other, to) = match r.once_in(2) {
        true => (one, format!("{}g + 2{q}", q.clone() + " ")),
        false => make(r),
    };
    match r.below(6) {
        // What mixes units is measured like nothing.
        0 => about(
            label,
            "b + c",
            "measured like",
            &format!("to = '{}'", r.pick(&["b", "c"])),
            Truth::Meaningless,
        ),
        _ => about(
            label,
            &q,
            "measured like",
            &format!("to = '{to}'"),
            word(one == other),
        ),
    }
}

/// Signs and inequalities of rational functions of letters of both signs.
fn relations(r: &mut Random, label: &str) -> Claim {
    let k = r.between(1, 5);
    let (x, y) = {
        let l = r.some(&["x", "y", "s"], 2);
        (l[0], l[1])
    };
    let (latex, holds) = match r.below(14) {
        0 => (format!("{x}^2 + {k} > 0"), true),
        1 => (format!("{x}^2 > 0"), false),
        2 => (format!("{x}^2 \\ge 0"), true),
        3 => (format!("2{x}z - {y}^2 + z^2 \\ge 0"), false),
        4 => (format!("{x}^2 + {y}^2 - 2{x}{y} \\ge 0"), true),
        5 => (format!("{x}^2 + {y}^2 - 3{x}{y} \\ge 0"), false),
        6 => ("a + b > 0".to_string(), true),
        7 => ("a - b > 0".to_string(), false),
        8 => (format!("{x} > 0"), false),
        9 => (format!("{x} \\ne {y}"), false),
        10 => (format!("{x}^2 + {k} \\ne 0"), true),
        11 => (format!("{x}^4 - {x}^2 + 1 > 0"), true),
        12 => (format!("({x} - {y})^2 + a \\ge a"), true),
        _ => (format!("{x}^2 - {}{x} + {} > 0", 2 * k, k * k), false),
    };
    Claim::of(label, &latex, word(holds))
}
