//! What a document supposes: relations of every kind, ranges and domains, ideals of several letters,
//! contradictions, and hypotheses that only help.

use super::rational::{letters, polynomial, rewrite};
use crate::generated::generator::{Claim, Kind, REALS, Template, Truth, VALUES, define};
use crate::generated::polynomial::fraction;
use crate::generated::random::Random;
use crate::generated::term::{Term, n, v};
use crate::generated::truth::equal;

pub const TEMPLATES: &[Template] = &[
    Template {
        name: "hypotheses/equation put in",
        kind: Kind::Rational,
        header: REALS,
        make: put_in,
    },
    Template {
        name: "hypotheses/ideal",
        kind: Kind::Other,
        header: REALS,
        make: ideal,
    },
    Template {
        name: "hypotheses/given",
        kind: Kind::Other,
        header: REALS,
        make: given,
    },
    Template {
        name: "hypotheses/given beside values",
        kind: Kind::Other,
        header: VALUES,
        make: given_beside_values,
    },
    Template {
        name: "hypotheses/bounds",
        kind: Kind::Other,
        header: REALS,
        make: bounds,
    },
    Template {
        name: "hypotheses/chains",
        kind: Kind::Other,
        header: REALS,
        make: chains,
    },
    Template {
        name: "hypotheses/not equal",
        kind: Kind::Other,
        header: REALS,
        make: not_equal,
    },
    Template {
        name: "hypotheses/contradictory",
        kind: Kind::Other,
        header: REALS,
        make: contradictory,
    },
    Template {
        name: "hypotheses/circular",
        kind: Kind::Other,
        header: REALS,
        make: circular,
    },
    Template {
        name: "hypotheses/inside functions",
        kind: Kind::Other,
        header: REALS,
        make: inside_functions,
    },
    Template {
        name: "hypotheses/ranges",
        kind: Kind::Other,
        header: REALS,
        make: ranges,
    },
    Template {
        name: "hypotheses/domains",
        kind: Kind::Other,
        header: REALS,
        make: domains,
    },
];

fn word(holds: bool) -> Truth {
    if holds { Truth::True } else { Truth::False }
}

fn assume(claim: Claim, relations: &[&str]) -> Claim {
    let list: Vec<String> = relations.iter().map(|r| format!("'{r}'")).collect();
    claim.set(&format!("assume = [{}]", list.join(", ")))
}

/// `x = p(others)`, and a claim in which it may be put in.
fn put_in(r: &mut Random, label: &str) -> Claim {
    loop {
        let letter = r.pick(&["x", "y", "z", "s"]);
        let others: Vec<&'static str> = letters(r, 4)
            .into_iter()
            .filter(|l| *l != letter)
            .take(2)
            .collect();
        let value = polynomial(r, &others);
        let inner = polynomial(r, &[letter, others[0]]) * v(letter) + polynomial(r, &others);
        let right = rewrite(&inner.with(letter, &value), r);
        let holds = r.once_in(2);
        let right = if holds {
            right
        } else {
            right + n(r.nonzero(-3, 3))
        };
        if value.letters().contains(&letter) || equal(&inner, &right, r) != Some(false) {
            continue;
        }
        let latex = format!("{} = {}", inner.latex(), right.latex());
        let relation = format!("{letter} = {}", value.latex());
        return assume(Claim::of(label, &latex, word(holds)), &[&relation]);
    }
}

/// Relations that no letter is solved from, with points where they are true.
fn relation(r: &mut Random) -> (Term, Term) {
    let [x, y, z] = [v("x"), v("y"), v("z")];
    let (a, b) = (v("a"), v("b"));
    match r.below(7) {
        0 => (x.pow(2) + y.pow(2), n(1)),
        1 => (a * x, b * y),
        2 => (a * (n(1) + x), n(1)),
        3 => (x * y, z),
        4 => (a.clone() * z * x, b + a),
        5 => (x.pow(2), a),
        _ => (x.pow(2) + y.pow(2) + z.pow(2), a),
    }
}

/// A multiple of the relation added to an identity.
fn ideal(r: &mut Random, label: &str) -> Claim {
    loop {
        let (left, right) = relation(r);
        let l = letters(r, 2);
        let cofactor = polynomial(r, &["x", "a", l[0]]);
        let rest = polynomial(r, &l);
        let whole = rest.clone() + cofactor * (left.clone() - right.clone());
        let Some((whole, _)) = fraction(&whole) else {
            continue;
        };
        let holds = r.once_in(2);
        let other = if holds {
            rest
        } else {
            rest + n(r.nonzero(-3, 3))
        };
        if equal(&whole.term(), &other, r) != Some(false) {
            continue;
        }
        let latex = format!("{} = {}", whole.term().latex(), other.latex());
        let relation = format!("{} = {}", left.latex(), right.latex());
        return assume(Claim::of(label, &latex, word(holds)), &[&relation]);
    }
}

/// The same under `given`: it holds given the relation, and not without it.
fn given_with(r: &mut Random, label: &str, relation: fn(&mut Random) -> (Term, Term)) -> Claim {
    loop {
        let (left, right) = relation(r);
        let l = letters(r, 2);
        let cofactor = polynomial(r, &["x", "a", l[0]]);
        let rest = polynomial(r, &l);
        let whole = rest.clone() + cofactor * (left.clone() - right.clone());
        let Some((whole, _)) = fraction(&whole) else {
            continue;
        };
        let holds = r.once_in(2);
        let other = if holds {
            rest
        } else {
            rest + n(r.nonzero(-3, 3))
        };
        if equal(&whole.term(), &other, r) != Some(false) {
            continue;
        }
        let latex = format!("{} = {}", whole.term().latex(), other.latex());
        let truth = if holds { Truth::Given } else { Truth::False };
        return Claim::of(label, &latex, truth).set(&format!(
            "given = ['{} = {}']",
            left.latex(),
            right.latex()
        ));
    }
}

fn given(r: &mut Random, label: &str) -> Claim {
    given_with(r, label, |r| {
        let l = letters(r, 3);
        match r.below(3) {
            0 => (v(l[0]), v(l[1])),
            1 => (v(l[0]) * v("a"), v(l[1]) * v("b")),
            _ => (v(l[0]), v(l[1]) + v(l[2])),
        }
    })
}

/// Relations that the reference values do not satisfy.
fn given_beside_values(r: &mut Random, label: &str) -> Claim {
    let claim = given_with(r, label, |r| {
        let l = r.some(&["x", "y", "z", "p"], 2);
        (v(l[0]), n(r.nonzero(1, 3)) * v(l[1]))
    });
    // The values contradict the hypothesis: what follows from it is not refuted by them, and need not hold.
    let truth = match claim.truth[0] {
        Truth::Given => Truth::Unforced,
        truth => truth,
    };
    Claim {
        truth: vec![truth],
        ..claim
    }
}

/// One bound of a letter, and what follows from it, or does not.
fn bounds(r: &mut Random, label: &str) -> Claim {
    let letter = r.pick(&["a", "b", "x", "y"]);
    let k = r.between(2, 6);
    let positive = matches!(letter, "a" | "b");
    let (relation, latex, holds) = match r.below(12) {
        0 => (format!("{letter} < {k}"), format!("{letter} = {k}"), false),
        1 => (
            format!("{letter} < {k}"),
            format!("{k} - {letter} > 0"),
            true,
        ),
        2 => (
            format!("{letter} < {k}"),
            format!("{letter} < {}", k + 1),
            true,
        ),
        3 => (
            format!("{letter} < {k}"),
            format!("{letter} < {}", k - 1),
            false,
        ),
        4 => (format!("{letter} > {k}"), format!("{letter} = {k}"), false),
        5 => (
            format!("{letter} > {k}"),
            format!("{letter}^2 - {} > 0", k * k),
            true,
        ),
        6 => (
            format!("{letter} > {k}"),
            format!("|{letter}| = {letter}"),
            true,
        ),
        7 => (
            format!("{letter} < {k}"),
            format!("{} - {letter}^2 > 0", k * k),
            positive,
        ),
        8 => (
            format!("{letter} \\le {k}"),
            format!("{k} - {letter} > 0"),
            false,
        ),
        9 => (
            format!("{letter} \\ge {k}"),
            format!("{letter} \\ge {k}"),
            true,
        ),
        10 => (
            format!("{letter} > {k}"),
            format!("\\sqrt{{({letter} - {k})^2}} = {letter} - {k}"),
            true,
        ),
        _ => (
            format!("{letter} < {k}"),
            format!("\\sqrt{{({letter} - {k})^2}} = {letter} - {k}"),
            false,
        ),
    };
    assume(Claim::of(label, &latex, word(holds)), &[&relation])
}

fn chains(r: &mut Random, label: &str) -> Claim {
    let letter = r.pick(&["x", "y", "a"]);
    let k = r.between(1, 5);
    let relation = format!("0 < {letter} < {k}");
    let (latex, holds) = match r.below(8) {
        0 => (format!("{letter}({k} - {letter}) > 0"), true),
        1 => (format!("|{letter}| = {letter}"), true),
        2 => (format!("|{letter} - {k}| = {k} - {letter}"), true),
        3 => (format!("|{letter} - {k}| = {letter} - {k}"), false),
        4 => (format!("{letter}({k} - {letter}) < 0"), false),
        5 => (format!("{letter} < {}", k + 1), true),
        6 => (format!("{letter} = {k}"), false),
        _ => (format!("{} - 2{letter} > 0", k), false),
    };
    assume(Claim::of(label, &latex, word(holds)), &[&relation])
}

fn not_equal(r: &mut Random, label: &str) -> Claim {
    let l = r.some(&["x", "y", "z", "a", "b"], 2);
    let (x, y) = (l[0], l[1]);
    let relation = format!("{x} \\ne {y}");
    let (latex, holds) = match r.below(5) {
        0 => (format!("{x} = {y}"), false),
        1 => (
            format!("\\frac{{{x}^2 - {y}^2}}{{{x} - {y}}} = {x} + {y}"),
            true,
        ),
        2 => (
            format!("\\frac{{{x}^2 - {y}^2}}{{{x} - {y}}} = {x} - {y}"),
            false,
        ),
        3 => (format!("({x} - {y})^2 > 0"), true),
        _ => (format!("{x} - {y} > 0"), false),
    };
    assume(Claim::of(label, &latex, word(holds)), &[&relation])
}

/// No admissible values: nothing holds.
fn contradictory(r: &mut Random, label: &str) -> Claim {
    let l = r.some(&["a", "b", "c", "g"], 2);
    let (a, b) = (l[0], l[1]);
    let k = r.between(1, 4);
    let relations: Vec<String> = match r.below(7) {
        0 => vec![format!("{a} + {b} = 0")],
        1 => vec![format!("{a} > 0"), format!("{a} < 0")],
        2 => vec![format!("x = {k}"), format!("x = {}", k + 1)],
        3 => vec![format!("{a} = -{k}")],
        4 => vec![format!("x^2 + {k} = 0")],
        5 => vec![format!("x > {k}"), format!("x < {k}")],
        _ => vec![format!("{a} {b} = 0")],
    };
    let latex = match r.below(4) {
        0 => format!("{a} = {b}"),
        1 => format!("\\frac{{{a}}}{{{b}}} = -1"),
        2 => "x = x".to_string(),
        _ => format!("x + {a} = {k}"),
    };
    let relations: Vec<&str> = relations.iter().map(String::as_str).collect();
    assume(Claim::of(label, &latex, Truth::Meaningless), &relations)
}

/// A hypothesis that says no more than the definitions do.
fn circular(r: &mut Random, label: &str) -> Claim {
    let number = label.trim_start_matches('c');
    let (h, k) = (format!("h_{{{number}}}"), format!("k_{{{number}}}"));
    let m = r.between(2, 5);
    let x = r.pick(&["x", "a", "y"]);
    let fences = define(
        &format!("{label}d"),
        &format!("{h} = \\frac{{1 + {x}}}{{{m}}}, \\quad {k} = \\frac{{1 - {x}}}{{{m}}}"),
    );
    let claim = match r.below(3) {
        0 => Claim::of(label, &format!("{m}{h} + {m}{k} = 2"), Truth::True),
        1 => Claim::of(label, &format!("{m}{h} - {m}{k} = 2{x}"), Truth::True),
        _ => Claim::of(label, &format!("{m}{h} + {m}{k} = 3"), Truth::False),
    };
    let claim = claim.after(&fences);
    match r.below(3) {
        0 => claim,
        1 => claim.set(&format!("given = ['{m}{h} + {m}{k} = 2']")),
        _ => claim.set(&format!("assume = ['{m}{h} + {m}{k} = 2']")),
    }
}

/// A letter that has a value is no letter inside of functions either.
fn inside_functions(r: &mut Random, label: &str) -> Claim {
    let x = r.pick(&["x", "y", "s"]);
    let a = r.pick(&["a", "b"]);
    let (relations, latex, holds): (Vec<String>, String, bool) = match r.below(9) {
        0 => (vec![format!("{x} = {a}")], format!("|{x}| = {a}"), true),
        1 => (vec![format!("{x} = -{a}")], format!("|{x}| = {a}"), true),
        2 => (vec![format!("{x} = -{a}")], format!("|{x}| = {x}"), false),
        3 => (
            vec![format!("\\cos {x} = z"), format!("{x} = 0")],
            "z = 1".into(),
            true,
        ),
        4 => (vec![format!("{x} = 0")], format!("e^{{{x}}} = 1"), true),
        5 => (
            vec![format!("{x} = {a}^2")],
            format!("\\sqrt{{{x}}} = {a}"),
            true,
        ),
        6 => (
            vec![format!("{x} = {a}^2")],
            format!("\\sqrt{{{x}}} = -{a}"),
            false,
        ),
        7 => (vec![format!("{x} = \\pi")], format!("\\sin {x} = 0"), true),
        _ => (
            vec![format!("{x} = \\ln {a}")],
            format!("e^{{{x}}} = {a}"),
            true,
        ),
    };
    let relations: Vec<&str> = relations.iter().map(String::as_str).collect();
    assume(Claim::of(label, &latex, word(holds)), &relations)
}

/// `range` among the symbols.
fn ranges(r: &mut Random, label: &str) -> Claim {
    let k = r.between(1, 4);
    let header = format!(
        "```toml symbols\nh = {{ range = '0 < h \\le {k}' }}\nf = {{ range = '-{k} \\le f < 0' }}\nx = {{ }}\n```\n"
    );
    let (latex, holds) = match r.below(10) {
        0 => ("|h| = h".to_string(), true),
        1 => ("|f| = -f".to_string(), true),
        2 => ("|f| = f".to_string(), false),
        3 => (format!("h \\le {k}"), true),
        4 => (format!("h < {k}"), false),
        5 => ("h f < 0".to_string(), true),
        6 => ("h f > 0".to_string(), false),
        7 => (format!("{k} - h \\ge 0"), true),
        8 => (format!("h = {}", k + 1), false),
        _ => ("\\sqrt{h^2f^2} = -hf".to_string(), true),
    };
    Claim::of(label, &latex, word(holds)).alone(&header)
}

/// Real unless told.
fn domains(r: &mut Random, label: &str) -> Claim {
    let domain = r.pick(&["real", "complex", "integer", ""]);
    let told = if domain.is_empty() {
        String::new()
    } else {
        format!("domain = \"{domain}\"")
    };
    let header = format!(
        "```toml symbols\nh = {{ {told} }}\na = {{ positive = true }}\n```\n```toml notation\n'\\pi' = {{ constant = \"pi\" }}\n```\n"
    );
    let real = domain != "complex";
    let integer = domain == "integer";
    let (latex, truth) = match r.below(7) {
        0 => ("|h|^2 = h^2", word(real)),
        1 => (
            "h^2 \\ge 0",
            if real {
                Truth::True
            } else {
                Truth::Meaningless
            },
        ),
        2 => ("\\sqrt{h^2} = |h|", word(real)),
        3 => ("\\sin(\\pi h) = 0", word(integer)),
        4 => ("\\cos(2\\pi h) = 1", word(integer)),
        5 => ("(h + a)^2 = h^2 + 2ah + a^2", Truth::True),
        _ => ("|h^2| = |h|^2", Truth::True),
    };
    Claim::of(label, latex, truth).alone(&header)
}
