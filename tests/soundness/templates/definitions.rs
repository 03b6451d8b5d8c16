//! Definitions, abbreviations and functions of a letter: what is claimed is the definition put in.

use super::functions::real;
use super::rational::{letters, polynomial, rewrite};
use crate::generated::generator::{Claim, Kind, REALS, Template, Truth, VALUES, damaged, define};
use crate::generated::random::Random;
use crate::generated::term::{Term, n, v};
use crate::generated::truth::equal;

pub const TEMPLATES: &[Template] = &[
    Template {
        name: "definitions/abbreviation",
        kind: Kind::Rational,
        header: REALS,
        make: abbreviation,
    },
    Template {
        name: "definitions/beside values",
        kind: Kind::Rational,
        header: VALUES,
        make: abbreviation,
    },
    Template {
        name: "definitions/nested",
        kind: Kind::Rational,
        header: REALS,
        make: nested,
    },
    Template {
        name: "definitions/function",
        kind: Kind::Rational,
        header: REALS,
        make: function,
    },
    Template {
        name: "definitions/functions inside",
        kind: Kind::Functions,
        header: REALS,
        make: functions_inside,
    },
    Template {
        name: "definitions/cancelled",
        kind: Kind::Other,
        header: REALS,
        make: cancelled,
    },
    Template {
        name: "definitions/range",
        kind: Kind::Other,
        header: REALS,
        make: range,
    },
];

fn sides(claim: (Term, Term)) -> String {
    format!("{} = {}", claim.0.latex(), claim.1.latex())
}

fn word(holds: bool) -> Truth {
    if holds { Truth::True } else { Truth::False }
}

fn abbreviation(r: &mut Random, label: &str) -> Claim {
    let name: &'static str = r.pick(&[r"\zeta", r"\rho", "h", r"\mu"]);
    loop {
        let l = letters(r, 2);
        let value = polynomial(r, &l);
        let value = if r.once_in(3) {
            value / v(r.pick(&["a", "b"]))
        } else {
            value
        };
        if let Some((latex, holds)) = about(r, &value) {
            let own = numbered(name, label);
            let fences = define(&format!("{label}d"), &format!("{own} = {}", value.latex()));
            return Claim::of(label, &latex.replace(PLACE, &own), word(holds)).after(&fences);
        }
    }
}

/// What stands for the defined name until it has its number.
const PLACE: &str = r"\placeholder";

/// Two forms of a term in which one name is defined: true, or damaged.
fn about(r: &mut Random, value: &Term) -> Option<(String, bool)> {
    let l = letters(r, 2);
    let inner = polynomial(r, &[l[0], PLACE]) * v(PLACE) + polynomial(r, &l);
    let inner = if r.once_in(3) {
        inner / v(r.pick(&["a", "b", "c"]))
    } else {
        inner
    };
    let put_in = inner.with(PLACE, value);
    let other = rewrite(&put_in, r);
    let other = if r.once_in(2) {
        damaged(&other, r)
    } else {
        other
    };
    let holds = equal(&put_in, &other, r)?;
    Some((sides((inner, other)), holds))
}

fn numbered(name: &str, label: &str) -> String {
    format!("{name}_{{{}}}", label.trim_start_matches('c'))
}

fn nested(r: &mut Random, label: &str) -> Claim {
    loop {
        let l = letters(r, 2);
        let first = polynomial(r, &l);
        let second = polynomial(r, &[l[0], PLACE]) + v(PLACE);
        let value = second.with(PLACE, &first);
        if let Some((latex, holds)) = about(r, &value) {
            let (one, two) = (numbered(r"\rho", label), numbered("h", label));
            let text = format!(
                "{one} = {}, \\quad {two} = {}",
                first.latex(),
                second.latex().replace(PLACE, &one)
            );
            let fences = define(&format!("{label}d"), &text);
            return Claim::of(label, &latex.replace(PLACE, &two), word(holds)).after(&fences);
        }
    }
}

/// `h(x) = ...`, at other arguments.
fn function(r: &mut Random, label: &str) -> Claim {
    loop {
        let body = polynomial(r, &["x", "a"]) + n(r.nonzero(-3, 3)) * v("x").pow(r.between(1, 3));
        let argument = match r.below(4) {
            0 => n(r.between(-3, 3)),
            1 => v(r.pick(&["b", "y", "s"])),
            2 => v("y") + n(r.nonzero(-2, 2)),
            _ => -v("x"),
        };
        let value = body.with("x", &argument);
        let other = rewrite(&value, r);
        let other = if r.once_in(2) {
            damaged(&other, r)
        } else {
            other
        };
        let Some(holds) = equal(&value, &other, r) else {
            continue;
        };
        let header = format!(
            "{REALS}{}",
            define("d", &format!("h(x) = {}", body.latex()))
        );
        let latex = format!("h({}) = {}", argument.latex(), other.latex());
        return Claim::of(label, &latex, word(holds)).alone(&header);
    }
}

fn functions_inside(r: &mut Random, label: &str) -> Claim {
    use crate::generated::term::{cos, exp, sin};
    loop {
        let x = real(r);
        let value = match r.below(3) {
            0 => cos(x.clone()),
            1 => sin(x.clone()),
            _ => exp(x.clone()),
        };
        if let Some((latex, holds)) = about(r, &value) {
            let own = numbered("h", label);
            let fences = define(&format!("{label}d"), &format!("{own} = {}", value.latex()));
            return Claim::of(label, &latex.replace(PLACE, &own), word(holds)).after(&fences);
        }
    }
}

/// A defined name that is zero, as a divisor or beside a sign.
fn cancelled(r: &mut Random, label: &str) -> Claim {
    let x = r.pick(&["x", "y", "z", "a"]);
    let own = numbered("h", label);
    let value = match r.below(4) {
        0 => format!("{x} - {x}"),
        1 => format!("2{x} - {x} - {x}"),
        2 => format!("({x} + 1)^2 - {x}^2 - 2{x} - 1"),
        _ => format!("{x} \\cdot 0"),
    };
    let fences = define(&format!("{label}d"), &format!("{own} = {value}"));
    let k = r.between(1, 5);
    let (latex, truth) = match r.below(9) {
        0 => (
            format!("\\frac{{{own}}}{{{own}}} = {k}"),
            Truth::Meaningless,
        ),
        1 => (
            format!("\\frac{{{k}}}{{{own}}} = \\frac{{{k}}}{{{own}}}"),
            Truth::Meaningless,
        ),
        2 => (
            format!("\\frac{{{own}^2}}{{{own}}} = {own}"),
            Truth::Meaningless,
        ),
        3 => (format!("{own} > 0"), Truth::False),
        4 => (format!("{own} = {k}"), Truth::False),
        5 => (format!("{own} + {k} = {k}"), Truth::True),
        6 => (format!("{own}^{k} = 0"), Truth::True),
        7 => (format!("{own} \\ge 0"), Truth::True),
        _ => (format!("{k} {own} = {own}"), Truth::True),
    };
    Claim::of(label, &latex, truth).after(&fences)
}

/// A definition with a range says nothing beyond it.
fn range(r: &mut Random, label: &str) -> Claim {
    let (low, high) = (r.between(-3, 0), r.between(1, 4));
    let e = r.between(2, 3);
    let fences = define("d", &format!("h(x) = x^{e}, \\quad {low} < x < {high}"));
    let header = format!("{REALS}{fences}");
    let inside = r.once_in(2);
    let at = match inside {
        true if high - low > 1 => r.between(low + 1, high - 1),
        true => {
            let latex = format!(
                "h(\\frac{{1}}{{2}}) = \\frac{{1}}{{{}}}",
                2_i64.pow(u32::try_from(e).expect("small"))
            );
            return Claim::of(label, &latex, Truth::True).alone(&header);
        }
        false => r.pick(&[low - 2, high + 1, high + 3]),
    };
    let value = at.pow(u32::try_from(e).expect("small"));
    let off = r.once_in(3);
    let shown = if off { value + 1 } else { value };
    let truth = match (inside, off) {
        (false, _) => Truth::Meaningless,
        (true, false) => Truth::True,
        (true, true) => Truth::False,
    };
    Claim::of(label, &format!("h({at}) = {shown}"), truth).alone(&header)
}
