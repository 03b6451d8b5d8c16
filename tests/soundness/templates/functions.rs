//! Identities between elementary functions: tables with any letters, numbers and arguments put in,
//! and damaged. Where a logarithm or a root needs it, the argument is positive.

use crate::generated::generator::{
    Claim, DOMAINS, Kind, REALS, Template, Truth, VALUES, damaged_or_not, evaluated,
};
use crate::generated::random::Random;
use crate::generated::term::{
    Function, Term, abs, call, cos, cosh, exp, ln, n, q, sin, sinh, sqrt, tan, tanh, v,
};
use crate::generated::truth::{Domain, domain};

pub const TEMPLATES: &[Template] = &[
    template("functions/exponentials", REALS, |r, l| {
        damaged_or_not(l, r, &exponentials)
    }),
    template("functions/logarithms", REALS, |r, l| {
        damaged_or_not(l, r, &logarithms)
    }),
    template("functions/powers", REALS, |r, l| {
        damaged_or_not(l, r, &powers)
    }),
    template("functions/roots", REALS, |r, l| {
        damaged_or_not(l, r, &roots)
    }),
    template("functions/nested roots", REALS, |r, l| {
        damaged_or_not(l, r, &nested_roots)
    }),
    template("functions/circular", REALS, |r, l| {
        damaged_or_not(l, r, &circular)
    }),
    template("functions/hyperbolic", REALS, |r, l| {
        damaged_or_not(l, r, &hyperbolic)
    }),
    template("functions/moduli", REALS, |r, l| {
        damaged_or_not(l, r, &moduli)
    }),
    template("functions/special angles", REALS, |r, l| {
        damaged_or_not(l, r, &special_angles)
    }),
    template("functions/constants", REALS, |r, l| {
        damaged_or_not(l, r, &constants)
    }),
    template("functions/beside values", VALUES, |r, l| {
        damaged_or_not(l, r, &any)
    }),
    template("functions/real roots of both signs", VALUES, |r, l| {
        evaluated(l, r, &both_signs)
    }),
    template("functions/imaginary", REALS, |r, l| {
        damaged_or_not(l, r, &imaginary)
    }),
    template("functions/complex letters", DOMAINS, |r, l| {
        evaluated(l, r, &complex_letters)
    }),
    template("functions/integer letters", DOMAINS, |r, l| {
        evaluated(l, r, &integer_letters)
    }),
    template("functions/signs", REALS, signs),
    template("functions/derivatives", REALS, derivatives),
];

const fn template(
    name: &'static str,
    header: &'static str,
    make: fn(&mut Random, &str) -> Claim,
) -> Template {
    Template {
        name,
        kind: Kind::Functions,
        header,
        make,
    }
}

const POSITIVE: [&str; 6] = ["a", "b", "c", "g", r"\alpha", r"\beta"];
const REAL: [&str; 6] = ["x", "y", "z", "s", r"\xi", "p"];

/// A positive argument.
fn positive(r: &mut Random) -> Term {
    let letter = v(r.pick(&POSITIVE));
    match r.below(6) {
        0 => letter + n(r.between(1, 3)),
        1 => n(r.between(2, 5)) * letter,
        2 => letter / v(r.pick(&POSITIVE)),
        3 => letter + v(r.pick(&POSITIVE)),
        _ => letter,
    }
}

/// A real argument of either sign.
pub fn real(r: &mut Random) -> Term {
    let letter = v(r.pick(&REAL));
    match r.below(8) {
        0 => letter + n(r.nonzero(-2, 2)),
        1 => n(r.nonzero(-3, 3)) * letter,
        2 => letter / n(r.between(2, 3)),
        3 => letter - v(r.pick(&REAL)),
        4 => v(r.pick(&POSITIVE)) * letter,
        5 => v(r.pick(&POSITIVE)),
        _ => letter,
    }
}

fn exponentials(r: &mut Random) -> (Term, Term) {
    let (x, y, a) = (real(r), real(r), positive(r));
    let k = r.between(2, 3);
    match r.below(8) {
        0 => (exp(x.clone()) * exp(y.clone()), exp(x + y)),
        1 => (exp(x.clone()).to(y.clone()), exp(x * y)),
        2 => (exp(x.clone()).pow(k), exp(n(k) * x)),
        3 => (exp(-x.clone()), n(1) / exp(x)),
        4 => (exp(ln(a.clone())), a),
        5 => (ln(exp(x.clone())), x),
        6 => (exp(n(k) * ln(a.clone())), a.pow(k)),
        _ => (
            (exp(x.clone()) + n(1)).pow(2),
            exp(n(2) * x.clone()) + n(2) * exp(x) + n(1),
        ),
    }
}

fn logarithms(r: &mut Random) -> (Term, Term) {
    let (a, b, x) = (positive(r), positive(r), real(r));
    let k = r.between(2, 5);
    match r.below(9) {
        0 => (ln(a.clone() * b.clone()), ln(a) + ln(b)),
        1 => (ln(a.clone() / b.clone()), ln(a) - ln(b)),
        2 => (ln(a.clone().pow(k)), n(k) * ln(a)),
        3 => (ln(sqrt(a.clone())), q(1, 2) * ln(a)),
        4 => (ln(n(1) / a.clone()), -ln(a)),
        5 => (ln(a.clone() * exp(x.clone())), ln(a) + x),
        6 => (ln(a.clone().to(x.clone())), x * ln(a)),
        7 => (ln(n(k * k)), n(2) * ln(n(k))),
        _ => (ln(n(6)) - ln(n(2)), ln(n(3))),
    }
}

fn powers(r: &mut Random) -> (Term, Term) {
    let (a, b, x, y) = (positive(r), positive(r), real(r), real(r));
    let k = r.between(2, 4);
    match r.below(8) {
        0 => (
            a.clone().to(x.clone()) * a.clone().to(y.clone()),
            a.to(x + y),
        ),
        1 => (a.clone().to(x.clone()).to(y.clone()), a.to(x * y)),
        2 => (
            (a.clone() * b.clone()).to(x.clone()),
            a.to(x.clone()) * b.to(x),
        ),
        3 => (a.clone().to(x.clone()), exp(x * ln(a))),
        4 => (n(k).to(x.clone()), exp(x * ln(n(k)))),
        5 => (a.clone().to(q(1, 2)), sqrt(a)),
        6 => (a.clone().to(q(2, 3)).pow(3), a.pow(2)),
        _ => (a.clone().to(-x.clone()), n(1) / a.to(x)),
    }
}

fn roots(r: &mut Random) -> (Term, Term) {
    let (a, b) = (positive(r), positive(r));
    let (x, y) = (real(r), real(r));
    let k = r.between(2, 5);
    match r.below(10) {
        0 => (sqrt(a.clone() * b.clone()), sqrt(a) * sqrt(b)),
        1 => (sqrt(a.clone() / b.clone()), sqrt(a) / sqrt(b)),
        2 => (sqrt(a.clone().pow(2)), a),
        3 => (sqrt(a.clone()).pow(2), a),
        4 => (sqrt(x.clone().pow(2)), abs(x)),
        5 => (sqrt(n(k * k) * a.clone()), n(k) * sqrt(a)),
        6 => (
            n(1) / (sqrt(a.clone()) + sqrt(b.clone())),
            (sqrt(a.clone()) - sqrt(b.clone())) / (a - b),
        ),
        7 => (sqrt(a.clone().pow(3)), a.clone() * sqrt(a)),
        8 => (
            sqrt(x.clone().pow(2) + y.clone().pow(2)).pow(2),
            x.pow(2) + y.pow(2),
        ),
        _ => (sqrt((x.clone() - y.clone()).pow(2)), abs(y - x)),
    }
}

fn nested_roots(r: &mut Random) -> (Term, Term) {
    let (a, b, x) = (positive(r), positive(r), real(r));
    let (h, k) = (r.between(2, 7), r.between(1, 4));
    match r.below(6) {
        // (sqrt h + k)^2
        0 => (
            sqrt(n(h + k * k) + n(2 * k) * sqrt(n(h))),
            n(k) + sqrt(n(h)),
        ),
        1 => (
            sqrt(a.clone() + b.clone() + n(2) * sqrt(a.clone() * b.clone())),
            sqrt(a) + sqrt(b),
        ),
        2 => (sqrt(sin(x.clone()).pow(2)), abs(sin(x))),
        3 => (sqrt(sqrt(a.clone())), a.to(q(1, 4))),
        4 => (sqrt(exp(n(2) * x.clone())), exp(x)),
        _ => (sqrt(n(1) - cos(x.clone()).pow(2)), abs(sin(x))),
    }
}

fn circular(r: &mut Random) -> (Term, Term) {
    let (x, y) = (real(r), real(r));
    let y = if r.once_in(8) { x.clone() } else { y };
    let two = || n(2);
    match r.below(14) {
        0 => (sin(x.clone()).pow(2) + cos(x).pow(2), n(1)),
        1 => (
            sin(x.clone() + y.clone()),
            sin(x.clone()) * cos(y.clone()) + cos(x) * sin(y),
        ),
        2 => (
            cos(x.clone() - y.clone()),
            cos(x.clone()) * cos(y.clone()) + sin(x) * sin(y),
        ),
        3 => (sin(two() * x.clone()), two() * sin(x.clone()) * cos(x)),
        4 => (cos(two() * x.clone()), n(1) - two() * sin(x).pow(2)),
        5 => (tan(x.clone()) * cos(x.clone()), sin(x)),
        6 => (n(1) + tan(x.clone()).pow(2), n(1) / cos(x).pow(2)),
        7 => (
            sin(n(3) * x.clone()),
            n(3) * sin(x.clone()) - n(4) * sin(x).pow(3),
        ),
        8 => (
            two() * cos(x.clone()) * cos(y.clone()),
            cos(x.clone() + y.clone()) + cos(x - y),
        ),
        9 => (sin(-x.clone()), -sin(x)),
        10 => (cos(x.clone() + Term::Pi), -cos(x)),
        11 => (sin(Term::Pi / two() - x.clone()), cos(x)),
        12 => (call(Function::Cot, x.clone()) * tan(x), n(1)),
        _ => (
            cos(x.clone()).pow(4) - sin(x.clone()).pow(4),
            cos(two() * x),
        ),
    }
}

fn hyperbolic(r: &mut Random) -> (Term, Term) {
    let (x, y) = (real(r), real(r));
    match r.below(9) {
        0 => (cosh(x.clone()).pow(2) - sinh(x).pow(2), n(1)),
        1 => (
            sinh(x.clone() + y.clone()),
            sinh(x.clone()) * cosh(y.clone()) + cosh(x) * sinh(y),
        ),
        2 => (cosh(x.clone()) + sinh(x.clone()), exp(x)),
        3 => (tanh(x.clone()), sinh(x.clone()) / cosh(x)),
        4 => (
            tanh(x.clone()),
            (exp(n(2) * x.clone()) - n(1)) / (exp(n(2) * x) + n(1)),
        ),
        5 => (n(2) * cosh(x.clone()).pow(2), cosh(n(2) * x) + n(1)),
        6 => (cosh(-x.clone()), cosh(x)),
        7 => (sinh(-x.clone()), -sinh(x)),
        _ => (
            cosh(x.clone() - y.clone()),
            cosh(x.clone()) * cosh(y.clone()) - sinh(x) * sinh(y),
        ),
    }
}

fn moduli(r: &mut Random) -> (Term, Term) {
    let (x, y, a) = (real(r), real(r), positive(r));
    match r.below(8) {
        0 => (abs(x.clone() * y.clone()), abs(x) * abs(y)),
        1 => (abs(x.clone()).pow(2), x.pow(2)),
        2 => (abs(-x.clone()), abs(x)),
        3 => (abs(a.clone()), a),
        4 => (abs(x.clone() / a.clone()), abs(x) / a),
        5 => (abs(x.clone() - y.clone()), abs(y - x)),
        6 => (abs(exp(x.clone())), exp(x)),
        // False for one sign only.
        _ => (abs(x.clone()), abs(abs(x))),
    }
}

fn special_angles(r: &mut Random) -> (Term, Term) {
    let k = r.between(-5, 7);
    let pi = |a: i64, b: i64| match (a, b) {
        (1, 1) => Term::Pi,
        (1, b) => Term::Pi / n(b),
        (a, 1) => n(a) * Term::Pi,
        (a, b) => (n(a) * Term::Pi) / n(b),
    };
    match r.below(9) {
        0 => (cos(pi(1, 3)), q(1, 2)),
        1 => (sin(pi(1, 4)), sqrt(n(2)) / n(2)),
        2 => (cos(pi(1, 6)), sqrt(n(3)) / n(2)),
        3 => (sin(pi(k, 1)), n(0)),
        4 => (cos(pi(k, 1)), n(if k % 2 == 0 { 1 } else { -1 })),
        5 => (tan(pi(1, 4)), n(1)),
        6 => (sin(pi(5, 6)), q(1, 2)),
        7 => (cos(pi(2, 3)), q(-1, 2)),
        _ => (cos(pi(1, 5)), (n(1) + sqrt(n(5))) / n(4)),
    }
}

fn constants(r: &mut Random) -> (Term, Term) {
    let (h, k) = (r.between(2, 6), r.between(2, 7));
    match r.below(9) {
        0 => (sqrt(n(h)) * sqrt(n(k)), sqrt(n(h * k))),
        1 => (sqrt(n(h * h * k)), n(h) * sqrt(n(k))),
        2 => (
            n(1) / (sqrt(n(k + 1)) - sqrt(n(k))),
            sqrt(n(k + 1)) + sqrt(n(k)),
        ),
        3 => (exp(n(h)) * exp(n(k)), exp(n(h + k))),
        4 => (ln(n(h * k)), ln(n(h)) + ln(n(k))),
        5 => (n(8).to(q(1, 3)), n(2)),
        6 => (exp(Term::Pi * Term::I), n(-1)),
        7 => (ln(Term::E), n(1)),
        _ => ((n(1) + sqrt(n(k))).pow(2), n(1 + k) + n(2) * sqrt(n(k))),
    }
}

fn any(r: &mut Random) -> (Term, Term) {
    let tables = [
        exponentials,
        logarithms,
        powers,
        roots,
        circular,
        hyperbolic,
        moduli,
    ];
    r.pick(&tables)(r)
}

/// Roots of what may be negative: true for both signs, or for one only.
fn both_signs(r: &mut Random) -> (Term, Term) {
    let x = v(r.pick(&REAL));
    match r.below(9) {
        5 => (sqrt(x.clone().pow(2)), x),
        6 => (abs(sqrt(x.clone())).pow(2), x),
        7 => (abs(x.clone()), x),
        8 => (sqrt(x.clone().pow(2)), -x),
        0 => (sqrt(x.clone().pow(2)), abs(x)),
        1 => (sqrt(x.clone()).pow(2), x),
        2 => (abs(sqrt(x.clone())).pow(2), abs(x)),
        3 => (sqrt(x.clone().pow(4)), x.pow(2)),
        _ => (sqrt(x.clone().pow(2)).pow(3), abs(x).pow(3)),
    }
}

fn imaginary(r: &mut Random) -> (Term, Term) {
    let (x, a, b) = (real(r), positive(r), positive(r));
    let i = || Term::I;
    match r.below(8) {
        0 => (exp(i() * x.clone()), cos(x.clone()) + i() * sin(x)),
        1 => (abs(a.clone() + i() * b.clone()).pow(2), a.pow(2) + b.pow(2)),
        2 => (
            cos(x.clone()),
            (exp(i() * x.clone()) + exp(-(i() * x))) / n(2),
        ),
        3 => (i().pow(2), n(-1)),
        4 => (abs(exp(i() * x)), n(1)),
        5 => (
            n(1) / (a.clone() + i() * x.clone()),
            (a.clone() - i() * x.clone()) / (a.pow(2) + x.pow(2)),
        ),
        6 => (call(Function::Re, a.clone() + i() * b), a),
        _ => (cosh(i() * x.clone()), cos(x)),
    }
}

/// What is true of real letters only, and what is true of complex ones too.
fn complex_letters(r: &mut Random) -> (Term, Term) {
    let u = v(r.pick(&["u", "w", "x"]));
    let w = v(r.pick(&["u", "w", "y"]));
    let (re, im) = (|t| call(Function::Re, t), |t| call(Function::Im, t));
    match r.below(19) {
        12 => (
            re(u.clone() * w.clone()),
            re(u.clone()) * re(w.clone()) - im(u) * im(w),
        ),
        13 => (
            im(u.clone() * w.clone()),
            re(u.clone()) * im(w.clone()) + im(u) * re(w),
        ),
        14 => (abs(u.clone() / w.clone()), abs(u) / abs(w)),
        15 => (abs(u.clone() + w.clone()), abs(u) + abs(w)),
        16 => (
            abs(u.clone() + w.clone()).pow(2) + abs(u.clone() - w.clone()).pow(2),
            n(2) * abs(u).pow(2) + n(2) * abs(w).pow(2),
        ),
        17 => (re(u.clone() * w.clone()), re(u) * re(w)),
        18 => (abs(exp(u.clone())), exp(re(u))),
        6 => (abs(u.clone()).pow(2), u.pow(2)),
        7 => (sqrt(u.clone().pow(2)), abs(u)),
        8 => (call(Function::Re, u.clone()), u),
        9 => (call(Function::Im, u), n(0)),
        10 => (abs(exp(u.clone())), exp(u)),
        11 => (sqrt(u.clone().pow(2)), u),
        0 => (abs(u.clone()).pow(2), abs(u.pow(2))),
        1 => (abs(u.clone() * w.clone()), abs(u) * abs(w)),
        2 => (sin(u.clone()).pow(2) + cos(u).pow(2), n(1)),
        3 => (exp(u.clone()) * exp(w.clone()), exp(u + w)),
        4 => (
            (u.clone() + w.clone()).pow(2),
            u.clone().pow(2) + n(2) * u * w.clone() + w.pow(2),
        ),
        _ => (
            call(Function::Re, u.clone() + w.clone()),
            call(Function::Re, u) + call(Function::Re, w),
        ),
    }
}

fn integer_letters(r: &mut Random) -> (Term, Term) {
    let k = v(r.pick(&["n", "m"]));
    match r.below(9) {
        5 => (cos(k * Term::Pi), n(1)),
        6 => (sin(v("x") * Term::Pi), n(0)),
        7 => (n(-1).to(k), n(1)),
        8 => (cos(v("x") * Term::Pi).pow(2), n(1)),
        0 => (cos(k.clone() * Term::Pi), n(-1).to(k)),
        1 => (sin(k * Term::Pi), n(0)),
        2 => (n(-1).to(n(2) * k), n(1)),
        3 => (exp(n(2) * Term::Pi * Term::I * k), n(1)),
        _ => (cos(v("x") + n(2) * Term::Pi * k), cos(v("x"))),
    }
}

/// Inequalities: known bounds, with what would be needed to break them.
fn signs(r: &mut Random, label: &str) -> Claim {
    let (x, a, b) = (real(r), v(r.pick(&POSITIVE)), v(r.pick(&POSITIVE)));
    let x = v(x.letters()[0]);
    let positive = domain(x.letters()[0]) == Domain::Positive;
    let k = r.between(1, 4);
    let (left, relation, right, holds) = match r.below(14) {
        0 => (cos(x), "<", n(1 + k), true),
        1 => (cos(x), "<", n(1), false),
        2 => (sin(x), r"\le", n(1), true),
        3 => (exp(a), ">", n(1), true),
        4 => (exp(x), ">", n(0), true),
        5 => (exp(x), ">", n(1), positive),
        6 if a != b => (a.clone() + b.clone(), r"\ge", n(2) * sqrt(a * b), true),
        7 if a != b => (a.clone() + b.clone(), r"\ge", n(3) * sqrt(a * b), false),
        8 => (sqrt(a.clone() + n(k)), ">", sqrt(a), true),
        9 => (sqrt(a.clone()), ">", a, false),
        10 => (cosh(x), r"\ge", n(1), true),
        11 => (tanh(x), "<", n(1), true),
        12 => (ln(a.clone()), "<", a, true),
        _ => (abs(x.clone()), r"\ge", x, true),
    };
    let truth = if holds { Truth::True } else { Truth::False };
    Claim::of(
        label,
        &format!("{} {relation} {}", left.latex(), right.latex()),
        truth,
    )
}

/// Derivatives by a letter, from the rules.
fn derivatives(r: &mut Random, label: &str) -> Claim {
    let letter = r.pick(&["x", "y", "s"]);
    let x = v(letter);
    let k = n(r.nonzero(-3, 3));
    let a = v(r.pick(&POSITIVE));
    let e = r.between(2, 5);
    let u = k.clone() * x.clone();
    let (f, d) = match r.below(9) {
        0 => (sin(u.clone()), k * cos(u)),
        1 => (cos(u.clone()), -(k * sin(u))),
        2 => (exp(u.clone()), k * exp(u)),
        3 => (x.clone().pow(e), n(e) * x.pow(e - 1)),
        4 => (x.clone() * exp(u.clone()), (n(1) + u.clone()) * exp(u)),
        5 => (
            a.clone() / (x.clone().pow(2) + n(1)),
            -((n(2) * a * x.clone()) / (x.pow(2) + n(1)).pow(2)),
        ),
        6 => (
            ln(a.clone() * x.clone().pow(2) + n(1)),
            (n(2) * a.clone() * x.clone()) / (a * x.pow(2) + n(1)),
        ),
        7 => (
            sqrt(a.clone() + x.clone().pow(2)),
            x.clone() / sqrt(a + x.pow(2)),
        ),
        _ => (tanh(u.clone()), k / cosh(u).pow(2)),
    };
    let holds = r.once_in(2);
    let shown = match holds {
        true => d.clone(),
        false => loop {
            let other = crate::generated::generator::damaged(&d, r);
            if crate::generated::truth::equal(&d, &other, r) == Some(false) {
                break other;
            }
        },
    };
    let truth = if holds { Truth::True } else { Truth::False };
    let latex = format!(
        r"\frac{{d}}{{d {letter}}}\left({}\right) = {}",
        f.latex(),
        shown.latex()
    );
    Claim::of(label, &latex, truth)
}
