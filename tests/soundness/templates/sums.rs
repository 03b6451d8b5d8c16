//! Sums with a running index, families by recursion, and definitions by cases.

use crate::generated::generator::{Claim, Kind, REALS, Template, Truth, define};
use crate::generated::random::Random;

pub const TEMPLATES: &[Template] = &[
    Template {
        name: "sums/numbers",
        kind: Kind::Rational,
        header: REALS,
        make: numbers,
    },
    Template {
        name: "sums/letters",
        kind: Kind::Rational,
        header: REALS,
        make: letters,
    },
    Template {
        name: "sums/recursion",
        kind: Kind::Rational,
        header: REALS,
        make: recursion,
    },
    Template {
        name: "sums/claims for all indices",
        kind: Kind::Rational,
        header: REALS,
        make: indexed,
    },
    Template {
        name: "cases/modulus",
        kind: Kind::Other,
        header: REALS,
        make: modulus,
    },
    Template {
        name: "cases/pieces",
        kind: Kind::Other,
        header: REALS,
        make: pieces,
    },
];

fn word(holds: bool) -> Truth {
    if holds { Truth::True } else { Truth::False }
}

fn numbers(r: &mut Random, label: &str) -> Claim {
    let (low, high) = (r.between(0, 3), r.between(3, 9));
    let e = r.between(1, 3);
    let c = r.nonzero(-3, 3);
    let exponent = u32::try_from(e).expect("small");
    let value: i64 = (low..=high).map(|k| c * k.pow(exponent) + 1).sum();
    let holds = r.once_in(2);
    let shown = if holds {
        value
    } else {
        value + r.nonzero(-3, 3)
    };
    Claim::of(
        label,
        &format!("\\sum_{{k={low}}}^{{{high}}} ({c} k^{e} + 1) = {shown}"),
        word(holds),
    )
}

fn letters(r: &mut Random, label: &str) -> Claim {
    let high = r.between(2, 5);
    let x = r.pick(&["x", "a", "y"]);
    let (left, right) = match r.below(3) {
        0 => (
            format!("\\sum_{{k=0}}^{{{high}}} {x}^k"),
            format!("\\frac{{{x}^{{{}}} - 1}}{{{x} - 1}}", high + 1),
        ),
        1 => (
            format!("\\sum_{{k=1}}^{{{high}}} k {x}"),
            format!("{} {x}", high * (high + 1) / 2),
        ),
        _ => (
            format!("\\sum_{{k=1}}^{{{high}}} ({x} + k b)"),
            format!("{high} {x} + {} b", high * (high + 1) / 2),
        ),
    };
    let holds = r.once_in(2);
    let right = if holds {
        right
    } else {
        format!("{right} {}", r.pick(&["+ 1", "- b", "+ 2a"]))
    };
    Claim::of(label, &format!("{left} = {right}"), word(holds))
}

fn recursion(r: &mut Random, label: &str) -> Claim {
    let (start, factor, more) = (r.between(-2, 3), r.nonzero(-3, 3), r.nonzero(-3, 3));
    let header = format!(
        "{REALS}{}",
        define(
            "d",
            &format!("h_0 = {start}, \\quad h_k = {factor} h_{{k-1}} + {more}, k = 1(1)6")
                .replace("+ -", "- ")
        )
    );
    let at = r.between(1, 6);
    let value = (0..at).fold(start, |h, _| factor * h + more);
    let holds = r.once_in(2);
    let shown = if holds {
        value
    } else {
        value + r.nonzero(-2, 2)
    };
    Claim::of(label, &format!("h_{at} = {shown}"), word(holds)).alone(&header)
}

/// An equation for each value of an index.
fn indexed(r: &mut Random, label: &str) -> Claim {
    let high = r.between(2, 6);
    let header = format!(
        "{REALS}{}",
        define(
            "d",
            &format!("h_0 = 0, \\quad h_k = h_{{k-1}} + k, k = 1(1){high}")
        )
    );
    let (latex, holds) = match r.below(4) {
        0 => (
            format!("h_k = \\frac{{k(k + 1)}}{{2}}, k = 0(1){high}"),
            true,
        ),
        1 => (format!("h_k = k^2, k = 1(1){high}"), false),
        2 => (format!("h_k - h_{{k-1}} = k, k = 1(1){high}"), true),
        _ => (
            format!("h_k = \\frac{{k(k - 1)}}{{2}}, k = 0(1){high}"),
            false,
        ),
    };
    Claim::of(label, &latex, word(holds)).alone(&header)
}

fn modulus(r: &mut Random, label: &str) -> Claim {
    let k = r.between(1, 4);
    let header = format!(
        "{REALS}{}",
        define(
            "d",
            "h(x) = \\begin{cases} x & x \\ge 0 \\\\ -x & x < 0 \\end{cases}"
        )
    );
    let (latex, holds) = match r.below(8) {
        0 => ("h(x) = |x|".to_string(), true),
        1 => ("h(x) = x".to_string(), false),
        2 => ("h(a) = a".to_string(), true),
        3 => (format!("h(-{k}) = {k}"), true),
        4 => (format!("h(-{k}) = -{k}"), false),
        5 => ("h(x)^2 = x^2".to_string(), true),
        6 => ("h(x) \\ge 0".to_string(), true),
        _ => ("h(x) = -x".to_string(), false),
    };
    Claim::of(label, &latex, word(holds)).alone(&header)
}

/// Two polynomials beside each other, at numbers.
fn pieces(r: &mut Random, label: &str) -> Claim {
    let (at, c, m) = (r.between(-1, 2), r.nonzero(-4, 4), r.between(-3, 3));
    let header = format!(
        "{REALS}{}",
        define("d", &format!("h(x) = \\begin{{cases}} {c} x & x < {at} \\\\ x^2 + {m} & x \\ge {at} \\end{{cases}}").replace("+ -", "- "))
    );
    let x = r.between(-4, 5);
    let value = if x < at { c * x } else { x * x + m };
    let holds = r.once_in(2);
    let shown = if holds {
        value
    } else {
        value + r.nonzero(-2, 2)
    };
    Claim::of(label, &format!("h({x}) = {shown}"), word(holds)).alone(&header)
}
