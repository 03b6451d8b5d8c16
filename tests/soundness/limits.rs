//! Limits whose truth is known: of quotients of polynomials by an evaluator of their own, from both
//! sides where the range of the letter has both, and of functions by hand.

use super::signs::{Family, LETTERS, Random};

type Poly = Vec<i64>;

/// The polynomial in x + g (or g - x).
fn shifted(p: &Poly, g: i64, mirrored: bool) -> Poly {
    let mut sum: Poly = vec![0];
    for c in p.iter().rev() {
        // sum * (g ± x) + c
        let mut next = vec![0; sum.len() + 1];
        for (k, s) in sum.iter().enumerate() {
            next[k] += s * g;
            next[k + 1] += if mirrored { -s } else { *s };
        }
        next[0] += c;
        sum = next;
    }
    sum
}

#[derive(Clone, Copy, PartialEq, Debug)]
enum Limit {
    Finite(i64, i64),
    Plus,
    Minus,
}

fn lowest(p: &Poly) -> Option<(usize, i64)> {
    p.iter()
        .enumerate()
        .find(|(_, c)| **c != 0)
        .map(|(k, c)| (k, *c))
}

fn highest(p: &Poly) -> Option<(usize, i64)> {
    p.iter()
        .enumerate()
        .rev()
        .find(|(_, c)| **c != 0)
        .map(|(k, c)| (k, *c))
}

fn reduced(n: i64, d: i64) -> (i64, i64) {
    let (mut a, mut b) = (n.abs(), d.abs());
    while b != 0 {
        (a, b) = (b, a % b);
    }
    let a = a.max(1) * d.signum();
    (n / a, d / a)
}

/// The limit of N/D for x falling to zero, or growing.
fn one_way(n: &Poly, d: &Poly, growing: bool) -> Limit {
    let end = if growing { highest } else { lowest };
    let Some((k, c)) = end(n) else {
        return Limit::Finite(0, 1);
    };
    let (m, e) = end(d).unwrap();
    let order = if growing { k.cmp(&m) } else { m.cmp(&k) };
    match order {
        std::cmp::Ordering::Less => Limit::Finite(0, 1),
        std::cmp::Ordering::Equal => {
            let (n, d) = reduced(c, e);
            Limit::Finite(n, d)
        }
        std::cmp::Ordering::Greater if (c > 0) == (e > 0) => Limit::Plus,
        std::cmp::Ordering::Greater => Limit::Minus,
    }
}

fn text(p: &Poly, x: &str) -> String {
    let terms: Vec<String> = p
        .iter()
        .enumerate()
        .filter(|(_, c)| **c != 0)
        .map(|(k, c)| match k {
            0 => format!("({c})"),
            _ => format!("({c}){x}^{k}"),
        })
        .collect();
    if terms.is_empty() {
        "0".into()
    } else {
        terms.join(" + ")
    }
}

fn printed(limit: Limit) -> String {
    match limit {
        Limit::Finite(n, 1) => n.to_string(),
        Limit::Finite(n, d) => format!(r"\frac{{{n}}}{{{d}}}"),
        Limit::Plus => r"\infty".into(),
        Limit::Minus => r"-\infty".into(),
    }
}

#[test]
fn quotients_of_polynomials() {
    let mut random = Random::new(3);
    let mut family = Family::new("limits of quotients", LETTERS);
    // A letter, the least and the largest goal, and the ends of its range.
    let letters = [
        ("x", -3, 3, i64::MIN, i64::MAX),
        ("a", 0, 3, 0, i64::MAX),
        ("u", 0, 2, 0, 2),
        ("v", -1, 3, -1, 3),
        ("w", 1, 4, 1, i64::MAX),
    ];
    while family.len() < 300 {
        let (x, from, to, low, high) = *random.pick(&letters);
        let mut poly = |degree: i64| -> Poly {
            (0..=random.between(0, degree))
                .map(|_| random.between(-2, 2))
                .collect()
        };
        let (n, mut d) = (poly(3), poly(2));
        if d.iter().all(|c| *c == 0) {
            d = vec![1];
        }
        let way = random.between(0, 3);
        let (goal, ways) = match way {
            0 if high == i64::MAX => (r"\infty".to_string(), vec![one_way(&n, &d, true)]),
            1 if low == i64::MIN => {
                let mirrored = |p: &Poly| shifted(p, 0, true);
                (
                    r"-\infty".to_string(),
                    vec![one_way(&mirrored(&n), &mirrored(&d), true)],
                )
            }
            0 | 1 => continue,
            _ => {
                let g = random.between(from, to);
                // Factors that vanish there make it interesting.
                let (mut n, mut d) = (n.clone(), d.clone());
                for p in [&mut n, &mut d] {
                    for _ in 0..random.between(0, 2) {
                        let mut product = vec![0; p.len() + 1];
                        for (k, c) in p.iter().enumerate() {
                            product[k] -= c * g;
                            product[k + 1] += c;
                        }
                        *p = product;
                    }
                }
                let mut ways = Vec::new();
                if high > g {
                    ways.push(one_way(
                        &shifted(&n, g, false),
                        &shifted(&d, g, false),
                        false,
                    ));
                }
                if low < g {
                    ways.push(one_way(&shifted(&n, g, true), &shifted(&d, g, true), false));
                }
                let f = format!(r"\frac{{{}}}{{{}}}", text(&n, x), text(&d, x));
                add(&mut family, &mut random, x, &g.to_string(), &f, &ways);
                continue;
            }
        };
        let f = format!(r"\frac{{{}}}{{{}}}", text(&n, x), text(&d, x));
        add(&mut family, &mut random, x, &goal, &f, &ways);
    }
    family.decides(0.95, 0.95);
}

fn add(family: &mut Family, random: &mut Random, x: &str, goal: &str, f: &str, ways: &[Limit]) {
    let claimed = match random.between(0, 5) {
        0 => Limit::Plus,
        1 => Limit::Minus,
        2 => Limit::Finite(random.between(-2, 2), 1),
        _ => ways[0],
    };
    let truth = ways.iter().all(|w| *w == claimed);
    family.add(
        format!(r"{x} \to {goal}, \quad {f} \to {}", printed(claimed)),
        truth,
    );
}

#[test]
fn letters_beside_the_one_that_moves() {
    let mut family = Family::new("limits with letters", LETTERS);
    for (goal, value, limit, truth) in [
        (r"\infty", r"\frac{ax + b}{cx}", r"\frac{a}{c}", true),
        (r"\infty", r"\frac{ax + b}{cx}", r"\frac{b}{c}", false),
        (r"\infty", r"ax - b", r"\infty", true),
        (r"-\infty", r"ax - b", r"\infty", false),
        (r"-\infty", r"ax - b", r"-\infty", true),
        (r"-\infty", r"ax^2 - b", r"\infty", true),
        (r"\infty", r"(a + b)x", r"\infty", true),
        (r"\infty", r"(a - b)x", r"\infty", false),
        (r"\infty", r"\frac{yx + 1}{x}", "y", true),
        (r"\infty", r"\frac{yx + 1}{x^2}", "0", true),
        (r"\infty", r"\frac{x}{x^2 + y^2}", "0", true),
        ("a", "x^2", "a^2", true),
        ("a", "x^2", "a", false),
        ("a", r"\frac{x^2 - a^2}{x - a}", "2a", true),
        ("a", r"\frac{x^2 - a^2}{x - a}", "a", false),
        ("a", r"\frac{1}{x - a}", r"\infty", false),
        ("a", r"\frac{1}{x - a}", r"-\infty", false),
        ("a", r"\frac{1}{(x - a)^2}", r"\infty", true),
        ("a", r"\frac{1}{(x - a)^2}", r"-\infty", false),
        ("-a", r"\frac{x}{a}", "-1", true),
        ("a + b", "x - a", "b", true),
        ("a + b", "x - b", "b", false),
        ("y", "x + y", "2y", true),
        ("y", "x + y", "y", false),
        ("0", r"\frac{a}{x}", r"\infty", false),
        ("0", r"\frac{a}{x^2}", r"\infty", true),
        ("0", r"\frac{|x|}{x}", "1", false),
        ("0", r"|x|", "0", true),
        ("2", "x + a", "2 + a", true),
        ("2", "x + a", "a", false),
    ] {
        family.add(format!(r"x \to {goal}, \quad {value} \to {limit}"), truth);
        if !limit.contains(r"\infty") {
            family.add(
                format!(
                    r"x \to {goal}, \quad c - \left({value}\right) \to c - \left({limit}\right)"
                ),
                truth,
            );
            family.add(
                format!(r"x \to {goal}, \quad {value} \to {limit} + c"),
                false,
            );
        }
    }
    family.check();
    // A leading coefficient that may vanish asks for a condition, or stays open.
    let mut open = Family::new("leading coefficients that vanish", LETTERS);
    for k in 1..20 {
        open.add(
            format!(r"x \to \infty, \quad \frac{{1}}{{(a - {k})x + 1}} \to {k} + 1"),
            false,
        );
        open.add(format!(r"x \to \infty, \quad (a - {k})x \to {k}"), false);
        open.add(format!(r"x \to \infty, \quad (a - {k})x \to \infty"), false);
        open.add(format!(r"x \to \infty, \quad (a + {k})x \to \infty"), true);
        open.add(
            format!(r"x \to \infty, \quad \frac{{x}}{{(a + {k})x + 1}} \to \frac{{1}}{{a + {k}}}"),
            true,
        );
        open.add(
            format!(r"x \to \infty, \quad (y^2 + {k})x \to \infty"),
            true,
        );
        open.add(format!(r"x \to \infty, \quad (y^2 - {k})x \to 0"), false);
    }
    open.check();
}

#[test]
fn limits_of_functions() {
    let mut family = Family::new("limits of functions", LETTERS);
    let claims = [
        (r"x \to \infty", r"e^{-ax}", "0", true),
        (r"x \to \infty", r"e^{-ax}", "1", false),
        (r"x \to -\infty", r"e^{-ax}", r"\infty", true),
        (r"x \to -\infty", r"e^{-ax}", "0", false),
        (r"x \to \infty", r"e^{ax}", r"\infty", true),
        (r"x \to \infty", r"e^{yx}", r"\infty", false),
        (r"x \to \infty", r"x^3e^{-x}", "0", true),
        (r"x \to \infty", r"x^{-3}e^{x}", r"\infty", true),
        (r"x \to \infty", r"\frac{e^x}{x^5}", "0", false),
        (r"x \to \infty", r"e^{x - x^2}", "0", true),
        (r"x \to \infty", r"\frac{e^{2x} + 1}{e^{2x} - 1}", "1", true),
        (
            r"x \to -\infty",
            r"\frac{e^{2x} + 1}{e^{2x} - 1}",
            "-1",
            true,
        ),
        (
            r"x \to -\infty",
            r"\frac{e^{2x} + 1}{e^{2x} - 1}",
            "1",
            false,
        ),
        (r"x \to 0", r"e^{ax}", "1", true),
        (r"x \to 0", r"e^{ax}", "0", false),
        (r"x \to 0", r"\frac{e^x - 1}{x}", "1", true),
        (r"x \to 0", r"\frac{e^{ax} - 1}{x}", "a", true),
        (r"x \to 0", r"\frac{e^x - 1}{x}", "0", false),
        (r"x \to 0", r"\frac{e^x - 1}{x^2}", r"\infty", false),
        (r"x \to 0", r"\frac{\sin x}{x}", "1", true),
        (r"x \to 0", r"\frac{\sin x}{x}", "0", false),
        (r"x \to 0", r"\frac{\sin ax}{x}", "a", true),
        (r"x \to 0", r"\frac{1 - \cos x}{x^2}", r"\frac{1}{2}", true),
        (r"x \to 0", r"\frac{1 - \cos x}{x^2}", "1", false),
        (r"x \to 0", r"\frac{1 - \cos x}{x}", "0", true),
        (r"x \to 0", r"\cos x", "1", true),
        (r"x \to 0", r"\cos x", "0", false),
        (r"x \to 0", r"\frac{\cos x}{x}", r"\infty", false),
        (r"x \to 0", r"\frac{\cos x}{x^2}", r"\infty", true),
        (r"x \to \infty", r"\cos x", "0", false),
        (r"x \to \infty", r"\cos x", "1", false),
        (r"x \to \infty", r"\cos x", r"\infty", false),
        (r"x \to \infty", r"\sin ax", "0", false),
        (r"x \to \infty", r"x\cos x", r"\infty", false),
        (r"x \to \infty", r"x + \cos x", r"\infty", true),
        (r"x \to \infty", r"\frac{\cos x}{x}", "0", true),
        (r"x \to \infty", r"\frac{\cos x}{x}", "1", false),
        (r"x \to \infty", r"e^{-ax}\cos bx", "0", true),
        (r"x \to \infty", r"e^{-ax}\cos bx", r"\infty", false),
        (r"x \to \infty", r"e^{ax}\cos bx", "0", false),
        (r"x \to \infty", r"\frac{x + \sin x}{x}", "1", true),
        (r"x \to \infty", r"\cos^2 x + \sin^2 x", "1", true),
        (r"x \to \infty", r"\sin x\cos x", "0", false),
        (r"x \to \infty", r"x\sin\frac{1}{x}", "1", true),
        (r"x \to \infty", r"\sqrt{x^2 + 1} - x", "0", true),
        (r"x \to \infty", r"\sqrt{x^2 + x} - x", r"\frac{1}{2}", true),
        (r"x \to \infty", r"\sqrt{x^2 + x} - x", "0", false),
        (r"x \to -\infty", r"\frac{\sqrt{x^2 + 1}}{x}", "-1", true),
        (r"x \to -\infty", r"\frac{\sqrt{x^2 + 1}}{x}", "1", false),
        (r"x \to a", r"e^{-x}", r"e^{-a}", true),
        (r"x \to a", r"e^{-x}", "0", false),
        (r"x \to a", r"\cos x", r"\cos a", true),
        (r"x \to 2", r"\cos x", r"\cos 2", true),
        (r"x \to 2", r"\cos x", r"\cos 3", false),
        (r"a \to 0", r"\sqrt a", "0", true),
        (r"a \to \infty", r"\sqrt a", r"\infty", true),
        (r"a \to 0", r"a\ln a", "0", true),
        (r"a \to 0", r"\ln a", r"-\infty", true),
        (r"a \to 0", r"\ln a", r"\infty", false),
        (r"a \to \infty", r"\frac{\ln a}{a}", "0", true),
        (r"a \to \infty", r"\ln a", r"\infty", true),
        (r"a \to 0", r"a^b", "0", true),
        (r"a \to \infty", r"a^{-b}", "0", true),
        (r"a \to \infty", r"a^{b - c}", "0", false),
        (r"a \to 0", r"e^{-1/a}", "0", true),
        (r"n \to \infty", r"\frac{1}{n}", "0", true),
        (r"n \to \infty", r"\frac{n + 1}{n}", "0", false),
        (r"u \to 0", r"\frac{1}{u}", r"\infty", true),
        (r"u \to 2", r"\frac{1}{2 - u}", r"\infty", true),
        (r"u \to 2", r"\frac{1}{u - 2}", r"\infty", false),
        (r"u \to 1", r"\frac{1}{u - 1}", r"\infty", false),
        (r"v \to 3", r"\frac{1}{3 - v}", r"\infty", true),
    ];
    for (goal, value, limit, truth) in claims {
        family.add(format!(r"{goal}, \quad {value} \to {limit}"), truth);
        // A factor and a term that do not move change nothing of it.
        if !limit.contains(r"\infty") {
            family.add(
                format!(r"{goal}, \quad 3\left({value}\right) \to 3\left({limit}\right)"),
                truth,
            );
            family.add(
                format!(r"{goal}, \quad 1 - \left({value}\right) \to 1 - \left({limit}\right)"),
                truth,
            );
            family.add(
                format!(r"{goal}, \quad {value} \to 1 + \left({limit}\right)"),
                goal == r"x \to 0" && limit_is_one_more(value, limit)
                    || value == r"\frac{n + 1}{n}",
            );
        }
    }
    assert!(family.len() >= 200);
    family.decides(0.7, 0.6);
}

/// None of the claims above is true with one added to its limit but these.
fn limit_is_one_more(value: &str, limit: &str) -> bool {
    let truths = [
        (r"e^{ax}", "0"),
        (r"\frac{e^x - 1}{x}", "0"),
        (r"\frac{\sin x}{x}", "0"),
        (r"\cos x", "0"),
    ];
    truths.contains(&(value, limit))
}
