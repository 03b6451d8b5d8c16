//! Expectations of random processes, and covariances that exist or do not.

use crate::generated::generator::{Claim, Kind, Template, Truth};
use crate::generated::random::Random;

pub const TEMPLATES: &[Template] = &[
    Template {
        name: "expectations/quadratic",
        kind: Kind::Other,
        header: GIVEN,
        make: quadratic,
    },
    Template {
        name: "expectations/not known",
        kind: Kind::Other,
        header: GIVEN,
        make: not_known,
    },
    Template {
        name: "expectations/oscillator",
        kind: Kind::Other,
        header: GIVEN,
        make: oscillator,
    },
    Template {
        name: "expectations/stationary or not",
        kind: Kind::Other,
        header: GIVEN,
        make: stationary,
    },
];

/// Two random processes with given covariance.
const GIVEN: &str = r#"```toml symbols
a = { positive = true }
b = { positive = true }
k = { }
g = { positive = true }
h = { positive = true }
x = { }
t = { }
r = { function_of = "t" }
s = { function_of = "t" }
```
```toml notation
e = { constant = "e" }
'\mathbf{V}' = { covariance_of = '\mathbf{r}' }
```
```math 1 define
\mathbf{r} = \begin{bmatrix} r \\ s \end{bmatrix}, \quad \mathbf{V} = \begin{bmatrix} g & x \\ x & h \end{bmatrix}
```
"#;

fn word(holds: bool) -> Truth {
    if holds { Truth::True } else { Truth::False }
}

fn quadratic(r: &mut Random, label: &str) -> Claim {
    let (i, j, k) = (r.nonzero(-4, 4), r.nonzero(-4, 4), r.nonzero(-3, 3));
    let signed = |n: i64| {
        if n < 0 {
            format!("- {}", -n)
        } else {
            format!("+ {n}")
        }
    };
    // E (i r + j s + k)^2 = i^2 g + 2 i j x + j^2 h + k^2
    let holds = r.once_in(2);
    let off = if holds { 0 } else { r.nonzero(-2, 2) };
    let (latex, holds) = match r.below(6) {
        0 => (
            format!(
                "E\\{{({i} r {} s {})^2\\}} = {} g {} x {} h {}",
                signed(j),
                signed(k),
                i * i,
                signed(2 * i * j + off),
                signed(j * j),
                signed(k * k)
            ),
            holds,
        ),
        1 => (format!("E\\{{a r {} b s\\}} = {off}", signed(i)), holds),
        2 => (format!("E\\{{{i} r s\\}} = {} x", i + off), holds),
        3 => (
            format!(
                "E\\{{a r^2 {} s^2\\}} = a g {} h",
                signed(j),
                signed(j + off)
            ),
            holds,
        ),
        4 => (format!("E\\{{{k}\\}} = {}", k + off), holds),
        _ => (
            format!("E\\{{r s\\}} = E\\{{r\\}}E\\{{s\\}} {}", signed(off)),
            false,
        ),
    };
    Claim::of(label, &latex, word(holds))
}

/// What no covariance decides: it is false for some law, and must not hold.
fn not_known(r: &mut Random, label: &str) -> Claim {
    let (y, k) = (r.pick(&["r", "s"]), r.between(2, 4));
    let latex = match r.below(9) {
        0 => format!("E\\{{\\cos {y}\\}} = \\cos {y}"),
        1 => "E\\{r e^s\\} = 0".to_string(),
        2 => format!("E\\{{\\cos {y}\\}} = 1"),
        3 => format!("E\\{{{y}^{}\\}} = 0", 2 * k - 1),
        4 => format!("E\\{{e^{{{y}}}\\}} = 1"),
        5 => format!("E\\{{|{y}|\\}} = |{y}|"),
        6 => format!("E\\{{\\frac{{1}}{{{y}}}\\}} = 0"),
        7 => format!("E\\{{{y}^{}\\}} = g^{k}", 2 * k),
        _ => format!("E\\{{{y}^2\\}} = {y}^2"),
    };
    Claim::of(label, &latex, Truth::Meaningless)
}

fn oscillator(r: &mut Random, label: &str) -> Claim {
    let (c, d) = (r.between(1, 9), r.between(1, 9));
    let header = format!(
        r#"```toml symbols
a = {{ positive = true }}
q = {{ positive = true }}
t = {{ }}
y = {{ function_of = "t" }}
```
```toml notation
'\mathbf{{0}}' = {{ zero = true }}
'\mathbf{{P}}' = {{ covariance_of = '\mathbf{{x}}' }}
'P_{{i,j}}' = {{ entry_of = '\mathbf{{P}}' }}
```
```math 1 define
\mathbf{{x}} = \begin{{bmatrix}} y \\ \dot{{y}} \end{{bmatrix}}, \quad \mathbf{{A}} = \begin{{bmatrix}} 0 & 1 \\ -{c} a & -{d} \end{{bmatrix}}, \quad \mathbf{{B}} = \begin{{bmatrix}} 0 \\ 1 \end{{bmatrix}}
```
```math 2 solve \mathbf{{P}}
\mathbf{{A}}\mathbf{{P}} + \mathbf{{P}}\mathbf{{A}}^T + q\mathbf{{B}}\mathbf{{B}}^T = \mathbf{{0}}
```
"#
    );
    let (latex, holds) = match r.below(6) {
        0 => (
            format!("E\\{{y^2\\}} = \\frac{{q}}{{{} a}}", 2 * c * d),
            true,
        ),
        1 => (format!("E\\{{y^2\\}} = \\frac{{q}}{{{} a}}", c * d), false),
        2 => (
            format!("E\\{{\\dot{{y}}^2\\}} = \\frac{{q}}{{{}}}", 2 * d),
            true,
        ),
        3 => ("E\\{y\\dot{y}\\} = 0".into(), true),
        4 => (format!("P_{{22}} = {c} a P_{{11}}"), true),
        _ => (
            format!("E\\{{\\dot{{y}}^2\\}} = \\frac{{q}}{{{}}}", 2 * d + 1),
            false,
        ),
    };
    Claim::of(label, &latex, word(holds)).alone(&header)
}

/// A scalar or discrete system: a covariance where it is stable, none where it is not.
fn stationary(r: &mut Random, label: &str) -> Claim {
    let discrete = r.once_in(2);
    let stable = r.once_in(2);
    let (rate, p, equation) = match (discrete, stable) {
        (false, stable) => {
            let a = r.between(1, 5);
            let a = if stable { -a } else { a };
            (
                a,
                format!("\\frac{{q}}{{{}}}", -2 * a),
                "\\phi\\mathbf{P} + \\mathbf{P}\\phi + q = 0",
            )
        }
        (true, true) => {
            let d = r.between(2, 5);
            (
                d,
                format!("\\frac{{{} q}}{{{}}}", d * d, d * d - 1),
                "\\phi\\mathbf{P}\\phi + q = \\mathbf{P}",
            )
        }
        (true, false) => {
            let a = r.between(2, 4);
            (
                a,
                format!("\\frac{{q}}{{{}}}", 1 - a * a),
                "\\phi\\mathbf{P}\\phi + q = \\mathbf{P}",
            )
        }
    };
    let rate = match (discrete, stable) {
        (true, true) => format!("\\frac{{1}}{{{rate}}}"),
        _ => rate.to_string(),
    };
    let header = format!(
        "```toml symbols\nq = {{ positive = true }}\nt = {{ }}\ny = {{ function_of = \"t\" }}\n```\n\
         ```toml notation\n'\\mathbf{{P}}' = {{ covariance_of = 'y' }}\n```\n\
         ```math 1 define\n\\phi = {rate}\n```\n```math 2 solve \\mathbf{{P}}\n{equation}\n```\n"
    );
    let wrong = r.once_in(3);
    let shown = if wrong { format!("2{p}") } else { p };
    let truth = match (stable, wrong) {
        (true, wrong) => word(!wrong),
        (false, _) => Truth::Meaningless,
    };
    // That a number solves the equation says nothing of a covariance, so only the discrete system's
    // equation has to be known for one.
    let truth = if discrete && truth == Truth::True {
        Truth::Unforced
    } else {
        truth
    };
    Claim::of(label, &format!("E\\{{y^2\\}} = {shown}"), truth).alone(&header)
}
