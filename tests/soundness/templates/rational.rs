//! Identities between rational functions: rewritten in many ways, and damaged.

use crate::generated::generator::{Claim, Kind, REALS, Template, VALUES, damaged_or_not};
use crate::generated::polynomial::fraction;
use crate::generated::random::Random;
use crate::generated::term::{Term, n, q, v};

pub const TEMPLATES: &[Template] = &[
    Template {
        name: "rational/rewritten",
        kind: Kind::Rational,
        header: REALS,
        make: |r, l| damaged_or_not(l, r, &rewritten),
    },
    Template {
        name: "rational/rewritten beside values",
        kind: Kind::Rational,
        header: VALUES,
        make: |r, l| damaged_or_not(l, r, &rewritten),
    },
    Template {
        name: "rational/table",
        kind: Kind::Rational,
        header: REALS,
        make: |r, l| damaged_or_not(l, r, &table),
    },
    Template {
        name: "rational/numbers",
        kind: Kind::Rational,
        header: REALS,
        make: |r, l| damaged_or_not(l, r, &numbers),
    },
    Template {
        name: "rational/one side zero",
        kind: Kind::Rational,
        header: REALS,
        make: |r, l| damaged_or_not(l, r, &difference),
    },
    Template {
        name: "rational/chain",
        kind: Kind::Rational,
        header: REALS,
        make: chain,
    },
    Template {
        name: "rational/side relation",
        kind: Kind::Rational,
        header: REALS,
        make: side_relation,
    },
];

const POOL: [&str; 9] = ["a", "b", "c", r"\alpha", "x", "y", "z", "s", "p"];

/// Some letters of both signs and of one.
pub fn letters(r: &mut Random, how_many: usize) -> Vec<&'static str> {
    r.some(&POOL, how_many)
}

/// A monomial with a small coefficient.
pub fn monomial(r: &mut Random, letters: &[&'static str]) -> Term {
    let coefficient = match r.below(5) {
        0 => q(r.nonzero(-5, 5), r.pick(&[2, 3, 7])),
        _ => n(r.nonzero(-6, 6)),
    };
    let mut t = coefficient;
    for _ in 0..r.below(3) {
        let letter = v(r.pick(letters));
        t = t * match r.below(3) {
            0 => letter.pow(r.between(2, 3)),
            _ => letter,
        };
    }
    t
}

/// A sum of some monomials.
pub fn polynomial(r: &mut Random, letters: &[&'static str]) -> Term {
    let first = v(r.pick(letters));
    let more = 1 + r.below(2);
    (0..more).fold(first, |t, _| t + monomial(r, letters))
}

fn rational(r: &mut Random, letters: &[&'static str], depth: usize) -> Term {
    if depth == 0 {
        return polynomial(r, letters);
    }
    let a = rational(r, letters, depth - 1);
    let b = polynomial(r, letters);
    match r.below(6) {
        0 => a + b,
        1 => a - b,
        2 | 3 => a * b,
        4 => a / b,
        _ => a.pow(2),
    }
}

/// The same in another form.
pub fn rewrite(t: &Term, r: &mut Random) -> Term {
    match r.below(5) {
        0 => shuffled(t, r),
        1 => {
            let extra = v(r.pick(&POOL)) + n(r.nonzero(-3, 3));
            (t.clone() - extra.clone()) + extra
        }
        2 => {
            let extra = v(r.pick(&["a", "b", "c"])) + v(r.pick(&["a", "b", "c"]));
            (extra.clone() * t.clone()) / extra
        }
        _ => match fraction(t) {
            Some((a, b)) if a.len() < 40 && b.len() < 12 => {
                match b.len() == 1 && b.term() == n(1) {
                    true => a.term(),
                    false => a.term() / b.term(),
                }
            }
            _ => shuffled(t, r),
        },
    }
}

fn shuffled(t: &Term, r: &mut Random) -> Term {
    let mut copy = t.clone();
    for child in copy.children_mut() {
        *child = shuffled(child, r);
    }
    match &mut copy {
        Term::Sum(parts) | Term::Product(parts) => r.shuffle(parts),
        _ => {}
    }
    copy
}

fn rewritten(r: &mut Random) -> (Term, Term) {
    let how_many = 1 + r.below(3);
    let letters = letters(r, how_many);
    let depth = r.below(3);
    let t = rational(r, &letters, depth);
    let other = rewrite(&t, r);
    (t, other)
}

fn difference(r: &mut Random) -> (Term, Term) {
    let (a, b) = rewritten(r);
    match r.once_in(2) {
        true => (a - b, n(0)),
        false => (n(0), b - a),
    }
}

fn numbers(r: &mut Random) -> (Term, Term) {
    let one = |r: &mut Random| q(r.nonzero(-9, 9), r.between(1, 9));
    let (a, b) = (one(r), one(r));
    let t = match r.below(4) {
        0 => a + b,
        1 => a - b,
        2 => a * b,
        _ => a / b,
    };
    let t = match r.below(3) {
        0 => t.pow(2),
        1 => t + n(r.between(-3, 3)),
        _ => t,
    };
    let value = t.exact(&|_| None).expect("a number");
    (t, Term::Number(value))
}

/// Well-known identities, of any letters and numbers.
pub fn table(r: &mut Random) -> (Term, Term) {
    let l = letters(r, 4);
    let part = |r: &mut Random, k: usize| match r.below(4) {
        0 => n(r.nonzero(-4, 4)) * v(l[k]),
        1 => v(l[k]) + n(r.nonzero(-3, 3)),
        _ => v(l[k]),
    };
    let (a, b, c, d) = (part(r, 0), part(r, 1), part(r, 2), part(r, 3));
    // Equal arguments now and then.
    let b = if r.once_in(9) { a.clone() } else { b };
    let two = || n(2);
    match r.below(14) {
        0 => (
            (a.clone() + b.clone()).pow(2),
            a.clone().pow(2) + two() * a * b.clone() + b.pow(2),
        ),
        1 => (
            a.clone().pow(2) - b.clone().pow(2),
            (a.clone() - b.clone()) * (a + b),
        ),
        2 => (
            a.clone().pow(3) + b.clone().pow(3),
            (a.clone() + b.clone()) * (a.clone().pow(2) - a * b.clone() + b.pow(2)),
        ),
        3 => (
            a.clone().pow(4) + n(4) * b.clone().pow(4),
            (a.clone().pow(2) + two() * b.clone().pow(2) + two() * a.clone() * b.clone())
                * (a.clone().pow(2) + two() * b.clone().pow(2) - two() * a * b),
        ),
        4 => (
            n(1) / a.clone() + n(1) / b.clone(),
            (a.clone() + b.clone()) / (a * b),
        ),
        5 => (
            n(1) / (a.clone() * (a.clone() + n(1))),
            n(1) / a.clone() - n(1) / (a + n(1)),
        ),
        6 => (
            (a.clone().pow(2) + b.clone().pow(2)) * (c.clone().pow(2) + d.clone().pow(2)),
            (a.clone() * c.clone() - b.clone() * d.clone()).pow(2) + (a * d + b * c).pow(2),
        ),
        7 => (
            (a.clone() + b.clone() + c.clone()).pow(2),
            a.clone().pow(2)
                + b.clone().pow(2)
                + c.clone().pow(2)
                + two() * a.clone() * b.clone()
                + two() * b * c.clone()
                + two() * a * c,
        ),
        8 => (
            (a.clone() / b.clone()) / (c.clone() / d.clone()),
            (a * d) / (b * c),
        ),
        9 => (
            a.clone() * b.clone(),
            ((a.clone() + b.clone()).pow(2) - (a - b).pow(2)) / n(4),
        ),
        10 => (n(1) / (n(1) + n(1) / a.clone()), a.clone() / (a + n(1))),
        11 => (
            a.clone().pow(-2) * a.clone().pow(3) * b.clone().pow(-1),
            a / b,
        ),
        12 => (
            (a.clone() - b.clone()) * (b.clone() - c.clone()) * (a.clone() - c.clone()),
            a.clone() * (c.clone().pow(2) - b.clone().pow(2))
                + b.clone() * (a.clone().pow(2) - c.clone().pow(2))
                + c * (b.pow(2) - a.pow(2)),
        ),
        _ => (
            (a.clone() * d.clone() + b.clone() * c.clone()) / (b.clone() * d.clone()),
            a / b + c / d,
        ),
    }
}

fn chain(r: &mut Random, label: &str) -> Claim {
    use crate::generated::generator::{Truth, damaged};
    use crate::generated::truth::equal;
    loop {
        let (a, b) = rewritten(r);
        let b = if r.once_in(3) { damaged(&b, r) } else { b };
        let c = rewrite(&a, r);
        let c = if r.once_in(3) { damaged(&c, r) } else { c };
        let (Some(first), Some(second)) = (equal(&a, &b, r), equal(&b, &c, r)) else {
            continue;
        };
        let word = |x: bool| if x { Truth::True } else { Truth::False };
        let latex = format!("{} = {} = {}", a.latex(), b.latex(), c.latex());
        return Claim {
            truth: vec![word(first), word(second)],
            ..Claim::of(label, &latex, Truth::True)
        };
    }
}

/// Off by a factor that vanishes for some admissible values, or for none, or is no relation at all.
fn side_relation(r: &mut Random, label: &str) -> Claim {
    use crate::generated::truth::equal;
    loop {
        let l = letters(r, 3);
        let t = polynomial(r, &l);
        let cofactor = polynomial(r, &l);
        let relation = match r.below(4) {
            0 => v(l[0]) - v(l[1]),
            1 => v("a") + v("b"),
            2 => v(l[0]).pow(2) + v(l[1]).pow(2) + n(1),
            _ => v(l[0]) * v(l[1]) - v(l[2]),
        };
        let off = t.clone() + relation * cofactor;
        let Some((off, _)) = fraction(&off) else {
            continue;
        };
        let (left, right) = match r.once_in(2) {
            true => (off.term(), t),
            false => (off.term() / v("c"), t / v("c")),
        };
        if equal(&left, &right, r) == Some(false) {
            return Claim::equation(label, &left, &right, false);
        }
    }
}
