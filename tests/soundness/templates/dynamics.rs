//! Dots and primes: explicit time, processes, the chain rule, equations of motion, energies.

use crate::generated::generator::{Claim, Kind, Template, Truth, define};
use crate::generated::random::Random;

pub const TEMPLATES: &[Template] = &[
    Template {
        name: "dynamics/explicit time",
        kind: Kind::Other,
        header: TIME,
        make: explicit,
    },
    Template {
        name: "dynamics/explicit functions of time",
        kind: Kind::Other,
        header: TIME,
        make: functions,
    },
    Template {
        name: "dynamics/processes",
        kind: Kind::Other,
        header: TIME,
        make: processes,
    },
    Template {
        name: "dynamics/dot without a time",
        kind: Kind::Other,
        header: TIME,
        make: untimed,
    },
    Template {
        name: "dynamics/primes",
        kind: Kind::Other,
        header: TIME,
        make: primes,
    },
    Template {
        name: "dynamics/energy",
        kind: Kind::Other,
        header: TIME,
        make: energy,
    },
    Template {
        name: "dynamics/motion assumed",
        kind: Kind::Other,
        header: TIME,
        make: assumed,
    },
    Template {
        name: "dynamics/motion solved",
        kind: Kind::Other,
        header: TIME,
        make: solved,
    },
];

const TIME: &str = r#"```toml symbols
a = { positive = true }
b = { positive = true }
c = { positive = true }
k = { positive = true }
m = { positive = true }
'\omega' = { positive = true }
x = { }
t = { }
y = { function_of = "t" }
z = { function_of = "t" }
```
```toml notation
e = { constant = "e" }
```
"#;

fn own(label: &str) -> String {
    label.trim_start_matches('c').to_string()
}

fn word(holds: bool) -> Truth {
    if holds { Truth::True } else { Truth::False }
}

/// A quantity, its name's subscript, and its time derivative: true, or one of some that are not.
fn derivative(r: &mut Random, label: &str, value: &str, right: &str, wrong: &[String]) -> Claim {
    let name = format!("h_{{{}}}", own(label));
    let dotted = format!("\\dot{{h}}_{{{}}}", own(label));
    let holds = r.once_in(2);
    let shown = if holds {
        right.to_string()
    } else {
        r.pick(wrong)
    };
    let fences = define(&format!("{label}d"), &format!("{name} = {value}"));
    Claim::of(label, &format!("{dotted} = {shown}"), word(holds)).after(&fences)
}

fn explicit(r: &mut Random, label: &str) -> Claim {
    let a = r.pick(&["a", "b", "x", "\\omega"]);
    let k = r.between(2, 5);
    let (value, right) = match r.below(4) {
        0 => (format!("{a} t"), a.to_string()),
        1 => (format!("{a} t^{k}"), format!("{k} {a} t^{{{}}}", k - 1)),
        2 => (format!("{a} t^2 + {k} t + c"), format!("2 {a} t + {k}")),
        _ => (
            format!("\\frac{{{a}}}{{t + {k}}}"),
            format!("-\\frac{{{a}}}{{(t + {k})^2}}"),
        ),
    };
    let wrong = [
        "0".into(),
        format!("-({right})"),
        format!("{right} + {a}"),
        format!("{k} ({right})"),
    ];
    derivative(r, label, &value, &right, &wrong)
}

fn functions(r: &mut Random, label: &str) -> Claim {
    let w = r.pick(&["\\omega", "a", "k"]);
    let (value, right) = match r.below(5) {
        0 => (format!("b\\cos({w} t)"), format!("-b {w} \\sin({w} t)")),
        1 => (format!("b\\sin({w} t)"), format!("b {w} \\cos({w} t)")),
        2 => (format!("e^{{-{w} t}}"), format!("-{w} e^{{-{w} t}}")),
        3 => (
            format!("t\\sin({w} t)"),
            format!("\\sin({w} t) + {w} t \\cos({w} t)"),
        ),
        _ => (
            format!("\\sqrt{{t^2 + {w}}}"),
            format!("\\frac{{t}}{{\\sqrt{{t^2 + {w}}}}}"),
        ),
    };
    let wrong = [
        "0".into(),
        format!("-({right})"),
        format!("2({right})"),
        format!("{right} + b"),
    ];
    derivative(r, label, &value, &right, &wrong)
}

fn processes(r: &mut Random, label: &str) -> Claim {
    let y = r.pick(&["y", "z"]);
    let k = r.between(2, 4);
    let (value, right) = match r.below(6) {
        0 => (format!("{k} {y}"), format!("{k} \\dot{{{y}}}")),
        1 => (
            format!("{y}^{k}"),
            format!("{k} {y}^{{{}}} \\dot{{{y}}}", k - 1),
        ),
        2 => ("y z".into(), "\\dot{y} z + y \\dot{z}".into()),
        3 => (format!("a {y}^2 + b t"), format!("2 a {y}\\dot{{{y}}} + b")),
        4 => (format!("t {y}"), format!("{y} + t\\dot{{{y}}}")),
        _ => (
            format!("\\frac{{1}}{{2}} m \\dot{{{y}}}^2"),
            format!("m \\dot{{{y}}}\\ddot{{{y}}}"),
        ),
    };
    let wrong = [
        "0".into(),
        format!("-({right})"),
        format!("2({right})"),
        format!("{right} + a"),
    ];
    derivative(r, label, &value, &right, &wrong)
}

/// Nothing says how a constant depends on the time, or that it does.
fn untimed(r: &mut Random, label: &str) -> Claim {
    let a = r.pick(&["a", "b", "x", "k"]);
    let (latex, timed) = match r.below(3) {
        0 => (format!("\\dot{{{a}}} = 0"), Truth::True),
        1 => (format!("\\dot{{{a}}} = {a}"), Truth::False),
        _ => (format!("2\\dot{{{a}}} = \\dot{{{a}}}"), Truth::True),
    };
    // Where the document has a time, what is declared to be no function of it stands still.
    if r.below(4) == 0 {
        return Claim::of(label, &latex, timed).alone(TIME);
    }
    let of_time = |line: &&str| !line.starts_with("t =") && !line.contains("function_of");
    let header: Vec<&str> = TIME.lines().filter(of_time).collect();
    Claim::of(label, &latex, Truth::Meaningless).alone(&(header.join("\n") + "\n"))
}

fn primes(r: &mut Random, label: &str) -> Claim {
    let k = r.between(2, 4);
    let (body, right) = match r.below(3) {
        0 => (format!("a x^{k}"), format!("{k} a x^{{{}}}", k - 1)),
        1 => (format!("\\sin({k} x)"), format!("{k} \\cos({k} x)")),
        _ => (
            format!("\\frac{{b}}{{x}} + {k} x"),
            format!("{k} - \\frac{{b}}{{x^2}}"),
        ),
    };
    let header = format!("{TIME}{}", define("d", &format!("f(x) = {body}")));
    let holds = r.once_in(2);
    let shown = match holds {
        true => right,
        false => r.pick(&[
            format!("7({right})"),
            format!("-({right})"),
            format!("{right} + a"),
            body,
        ]),
    };
    Claim::of(label, &format!("f'(x) = {shown}"), word(holds)).alone(&header)
}

/// An oscillator, damped or not, and what its energy does.
fn energy(r: &mut Random, label: &str) -> Claim {
    let damped = r.once_in(2);
    let (m, k) = (r.pick(&["m", "a", "2m"]), r.pick(&["k", "b", "3k"]));
    let damping = if damped { "+ c\\dot{y}" } else { "" };
    let header =
        format!("{TIME}```math d solve \\ddot{{y}}\n{m}\\ddot{{y}} {damping} + {k} y = 0\n```\n");
    let energy = format!("\\frac{{{m} \\dot{{y}}^2}}{{2}} + \\frac{{1}}{{2}} \\cdot {k} y^2");
    let (latex, holds) = match r.below(5) {
        0 => (format!("{energy} = \\mathrm{{const.}}"), !damped),
        1 => (
            format!("{m} \\dot{{y}}^2 + {k} y^2 = \\mathrm{{const.}}"),
            !damped,
        ),
        2 => (
            format!("\\frac{{d}}{{dt}}\\left({energy}\\right) = -c\\dot{{y}}^2"),
            damped,
        ),
        3 => (
            format!("\\frac{{d}}{{dt}}\\left({energy}\\right) = 0"),
            !damped,
        ),
        _ => (
            format!("{m} \\dot{{y}}^2 - {k} y^2 = \\mathrm{{const.}}"),
            false,
        ),
    };
    Claim::of(label, &latex, word(holds)).alone(&header)
}

/// The same with the equation of motion as a hypothesis.
fn assumed(r: &mut Random, label: &str) -> Claim {
    let (m, k) = (r.pick(&["m", "a"]), r.pick(&["k", "b"]));
    let energy = format!("\\frac{{1}}{{2}} {m} \\dot{{y}}^2 + \\frac{{1}}{{2}} {k} y^2");
    let (latex, holds) = match r.below(5) {
        0 => (
            format!("\\frac{{d}}{{dt}}\\left({energy}\\right) = 0"),
            true,
        ),
        1 => (format!("\\ddot{{y}} = -\\frac{{{k}}}{{{m}}} y"), true),
        2 => (format!("\\ddot{{y}} = \\frac{{{k}}}{{{m}}} y"), false),
        3 => (format!("{m}\\ddot{{y}} y = -{k} y^2"), true),
        _ => (
            format!("\\frac{{d}}{{dt}}\\left({energy}\\right) = {k} y\\dot{{y}}"),
            false,
        ),
    };
    Claim::of(label, &latex, word(holds))
        .set(&format!("assume = ['{m}\\ddot{{y}} = -{k} y']"))
        .alone(TIME)
}

/// Two masses: accelerations from a linear system.
fn solved(r: &mut Random, label: &str) -> Claim {
    let j = r.between(1, 4);
    let header = format!(
        "{TIME}```math d solve \\ddot{{y}}, \\ddot{{z}}\n\\begin{{bmatrix}} m & {j} \\\\ 0 & a \\end{{bmatrix}}\\begin{{bmatrix}} \\ddot{{y}} \\\\ \\ddot{{z}} \\end{{bmatrix}} + \\begin{{bmatrix}} k y \\\\ b z \\end{{bmatrix}} = \\begin{{bmatrix}} 0 \\\\ 0 \\end{{bmatrix}}\n```\n"
    );
    let (latex, holds) = match r.below(5) {
        0 => ("\\ddot{z} = -\\frac{b}{a} z".to_string(), true),
        1 => ("\\ddot{z} = \\frac{b}{a} z".to_string(), false),
        2 => (
            format!("\\ddot{{y}} = -\\frac{{k}}{{m}} y + \\frac{{{j} b}}{{a m}} z"),
            true,
        ),
        3 => (
            format!("\\ddot{{y}} = -\\frac{{k}}{{m}} y - \\frac{{{j} b}}{{a m}} z"),
            false,
        ),
        _ => (format!("m\\ddot{{y}} + {j}\\ddot{{z}} + k y = 0"), true),
    };
    Claim::of(label, &latex, word(holds)).alone(&header)
}
