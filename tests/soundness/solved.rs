//! What a document determines: unknowns of equations that are linear in them and of such that are not, functions
//! with a value of their own at a number or with none there, and limits in which more than one letter moves.
//!
//! What is not determined has no value: a claim about it stands twice in its family, as a true and as a false one, so
//! that no definite verdict on it passes.

use super::signs::{Family, LETTERS, Random};
use crate::common::audit;
use rederive::check::Options;
use rederive::document::{Document, VerdictWord};

/// Adds a claim that is neither true nor false.
fn neither(family: &mut Family, claim: &str) {
    family.add(claim, true);
    family.add(claim, false);
}

/// `+ 3x`, `- x`, and nothing for zero.
fn term(c: i64, what: &str) -> String {
    let sign = if c < 0 { "-" } else { "+" };
    match (c, what) {
        (0, _) => String::new(),
        (_, "") => format!(" {sign} {}", c.abs()),
        (1 | -1, _) => format!(" {sign} {what}"),
        _ => format!(" {sign} {}{what}", c.abs()),
    }
}

/// A sum of such terms, which may be none.
fn sum(terms: &[String]) -> String {
    let text = terms.concat();
    let text = text.strip_prefix(" + ").unwrap_or(&text);
    match text {
        "" => "0".into(),
        text => text.trim().to_string(),
    }
}

fn solve(head: &mut String, number: usize, unknowns: &str, equations: &str) {
    *head += &format!("\n```math s{number} solve {unknowns}\n{equations}\n```\n");
}

const FUNCTIONS: &str = r#"
```toml symbols
'\xi' = { unit = "1", meaning = "" }
```
```math f define
f(\xi) = \begin{cases} \xi & \text{for } \xi \ge 0 \\ -\xi & \text{for } \xi < 0 \end{cases}
```
```math g define
g(\xi) = \xi^2 + \xi
```
```math h define
h(\xi) = 2\xi - 3
```
"#;

#[test]
fn unknowns_that_are_not_linear_have_no_value() {
    let mut random = Random::new(11);
    let mut head = format!("{LETTERS}{FUNCTIONS}");
    let mut claims: Vec<String> = Vec::new();
    for k in 1..=104 {
        let q = format!("q_{{{k}}}");
        let r = random.between(0, 1);
        let s = *random.pick(&[-3, -2, -1, 2, 3, 4]);
        let m = random.between(2, 5);
        let x = *random.pick(&["x", "y", "a", "b"]);
        let (equation, roots): (String, Vec<String>) = match k % 26 {
            0 => (
                format!("{q}^2{}{} = 0", term(-r - s, &q), term(r * s, "")),
                vec![r.to_string(), s.to_string()],
            ),
            1 => (
                format!("({q} - {r})({q} - {x}) = 0"),
                vec![r.to_string(), x.into()],
            ),
            2 => (
                format!("{x}{q}^2 = {q}"),
                vec!["0".into(), format!(r"\frac{{1}}{{{x}}}")],
            ),
            3 => (format!("{q}^2 = {x}{q}"), vec!["0".into(), x.into()]),
            4 => (
                format!(r"\sin({m}{q}) = 0"),
                vec!["0".into(), r"\pi".into()],
            ),
            5 => (format!(r"\cos({q}) = 1"), vec!["0".into(), r"2\pi".into()]),
            6 => (format!("|{q}| = {m}"), vec![m.to_string(), format!("-{m}")]),
            7 => (
                format!(r"\sqrt{{{q}}} = {m}{q}"),
                vec!["0".into(), format!(r"\frac{{1}}{{{}}}", m * m)],
            ),
            8 => (
                format!("f({q}) = {m}"),
                vec![m.to_string(), format!("-{m}")],
            ),
            9 => (format!("g({q}) = 0"), vec!["0".into(), "-1".into()]),
            10 => (
                format!("{q}^3 = {}{q}", m * m),
                vec!["0".into(), m.to_string(), format!("-{m}")],
            ),
            11 => (format!("{q}^2 = 1"), vec!["1".into(), "-1".into()]),
            12 => (
                format!("{q}^2 + {}{q} = {m}", m - 1),
                vec!["1".into(), format!("-{m}")],
            ),
            13 => (
                format!(r"{q}\sin({q}) = 0"),
                vec!["0".into(), r"\pi".into()],
            ),
            14 => (
                format!("{q}^2({q} - {x}) = {m}{q} - {m}{x}"),
                vec![x.into()],
            ),
            15 => (
                format!(r"\sqrt{{{q}^2}} = {m}"),
                vec![m.to_string(), format!("-{m}")],
            ),
            16 => (format!("{q}^4 = {q}"), vec!["0".into(), "1".into()]),
            17 => (
                format!(r"\frac{{{q}^2}}{{{m}}} = {x}{q}"),
                vec!["0".into(), format!("{m}{x}")],
            ),
            18 => (
                format!("{q}({q} + {m}) = {}", m + 1),
                vec!["1".into(), format!("-{}", m + 1)],
            ),
            19 => (
                format!(r"\frac{{\partial}}{{\partial x}}({q}x) = {m}"),
                vec![m.to_string()],
            ),
            20 => (
                format!(r"\int_0^x {q}\,\mathrm{{d}}x = x^2"),
                vec!["x".into(), "2x".into()],
            ),
            21 => (
                format!(r"\det\begin{{bmatrix}} {q} & {m} \\ 0 & {q} - {m} \end{{bmatrix}} = 0"),
                vec!["0".into(), m.to_string()],
            ),
            22 => (
                format!(r"\sum_{{j=1}}^2 {q}^j = 0"),
                vec!["0".into(), "-1".into()],
            ),
            23 => (
                format!(r"\operatorname{{Re}}({q}) = {m}"),
                vec![m.to_string()],
            ),
            24 => (
                format!(r"({q} - {r})\left({q}^2 - {x}^2\right) = 0"),
                vec![r.to_string(), x.into()],
            ),
            _ => (
                format!("|{q} - 1| = {q}^2 - 1 + {q}({q}-1)"),
                vec!["1".into()],
            ),
        };
        if k % 26 == 25 {
            // It has the root 1 and no other: whoever does not prove that has not shown it.
            solve(&mut head, k, &q, &equation);
            continue;
        }
        solve(&mut head, k, &q, &equation);
        claims.extend(roots.iter().map(|root| format!("{q} = {root}")));
    }
    let mut family = Family::new("unknowns that are not linear", &head);
    for claim in &claims {
        neither(&mut family, claim);
    }
    assert!(family.len() >= 300);
    family.check();
}

#[test]
fn several_unknowns_that_are_not_linear_have_no_values() {
    let mut random = Random::new(12);
    let mut head = format!(
        "{LETTERS}{FUNCTIONS}\n```toml notation\n'\\mathbf{{0}}' = {{ zero = true }}\n```\n\
         ```math d define\n\\mathbf{{A}} = \\begin{{bmatrix}} -a & 1 \\\\ 0 & -b \\end{{bmatrix}}, \\quad \
         \\mathbf{{S}} = \\begin{{bmatrix}} a & x \\\\ x & b \\end{{bmatrix}}\n```\n"
    );
    let mut claims: Vec<String> = Vec::new();
    for k in 1..=72 {
        let (q, r) = (format!("q_{{{k}}}"), format!("r_{{{k}}}"));
        let p = format!(r"\mathbf{{P}}_{{{k}}}");
        let m = random.between(2, 5);
        let x = *random.pick(&["x", "y", "a"]);
        let (unknowns, equations, roots): (String, String, Vec<String>) = match k % 9 {
            0 => (
                format!("{q}, {r}"),
                format!(r"{q} + {r} = {m}, \quad {q}^2 = 1"),
                vec![
                    format!("{q} = 1"),
                    format!("{r} = {}", m - 1),
                    format!("{q} = -1"),
                ],
            ),
            1 => (
                format!("{q}, {r}"),
                format!(r"{q} + {r} = {x}, \quad |{r}| = {m}"),
                vec![format!("{r} = {m}"), format!("{q} = {x} - {m}")],
            ),
            2 => (
                format!("{q}, {r}"),
                format!(r"{q} = {x}{r}, \quad {q}{r} = {q}"),
                vec![format!("{q} = 0"), format!("{r} = 0"), format!("{r} = 1")],
            ),
            3 => (
                p.clone(),
                format!(r"\mathbf{{A}}{p} + {p}\mathbf{{A}}^T - {m}{p}{p} = \mathbf{{0}}"),
                vec![format!(r"{p} = \mathbf{{0}}")],
            ),
            4 => (
                p.clone(),
                format!(r"\mathbf{{A}}{p} = {p}\mathbf{{S}}{p}"),
                vec![
                    format!(r"{p} = \mathbf{{0}}"),
                    format!(r"\operatorname{{tr}}({p}) = 0"),
                ],
            ),
            // Whatever is skew may be added.
            5 => (
                p.clone(),
                format!(r"{p} + {p}^T = {m}\mathbf{{S}} + {m}\mathbf{{S}}^T"),
                vec![format!(r"{p} = {m}\mathbf{{S}}")],
            ),
            6 => (
                p.clone(),
                format!(r"\mathbf{{A}}{p}{p} + {p} = \mathbf{{0}}"),
                vec![format!(r"{p} = \mathbf{{0}}")],
            ),
            7 => (
                format!("{q}, {r}"),
                format!(r"{q} + {r} = 1, \quad {q}{r} + {m}{q} = 0"),
                vec![format!("{q} = 0"), format!("{r} = 1")],
            ),
            _ => (
                p.clone(),
                format!(r"\mathbf{{A}}{p} + {p}\mathbf{{A}}^T = {p}^T\mathbf{{S}}{p}"),
                vec![format!(r"{p} = \mathbf{{0}}")],
            ),
        };
        solve(&mut head, k, &unknowns, &equations);
        claims.extend(roots);
    }
    let mut family = Family::new("several unknowns that are not linear", &head);
    for claim in &claims {
        neither(&mut family, claim);
    }
    assert!(family.len() >= 200);
    family.check();
}

#[test]
fn unknowns_that_are_linear_have_their_value() {
    let mut random = Random::new(13);
    let mut head = format!(
        "{LETTERS}{FUNCTIONS}\n```math d define\n\\mathbf{{A}} = \\begin{{bmatrix}} -a & 1 \\\\ 0 & -b \\end{{bmatrix}}\n```\n"
    );
    let mut claims: Vec<(String, String)> = Vec::new();
    for k in 1..=96 {
        let (q, r) = (format!("q_{{{k}}}"), format!("r_{{{k}}}"));
        let p = format!(r"\mathbf{{P}}_{{{k}}}");
        let (m, n) = (random.between(2, 5), random.between(-4, 4));
        let x = *random.pick(&["x", "y", "a", "b"]);
        let over = |above: &str, below: &str| format!(r"\frac{{{above}}}{{{below}}}");
        let (unknowns, equations, values): (String, String, Vec<(String, String)>) = match k % 12 {
            0 => (
                q.clone(),
                format!("{m}{q}{} = {x}", term(n, "")),
                vec![(
                    q.clone(),
                    over(&sum(&[format!(" + {x}"), term(-n, "")]), &m.to_string()),
                )],
            ),
            // Linear, but not at sight.
            1 => (
                q.clone(),
                format!(
                    "({q} + {m})^2 = {q}^2{}",
                    sum(&[format!(" + {}", n + 30)]).replacen("", " + ", 1)
                ),
                vec![(
                    q.clone(),
                    over(&(n + 30 - m * m).to_string(), &(2 * m).to_string()),
                )],
            ),
            2 => (
                q.clone(),
                format!("{q}({q} + b) = {q}^2 + {m}bx"),
                vec![(q.clone(), format!("{m}x"))],
            ),
            3 => (
                format!("{q}, {r}"),
                format!(r"{q} + {r} = {m}{x}, \quad {q} - {r} = {n}"),
                vec![
                    (
                        q.clone(),
                        over(&sum(&[format!(" + {m}{x}"), term(n, "")]), "2"),
                    ),
                    (
                        r.clone(),
                        over(&sum(&[format!(" + {m}{x}"), term(-n, "")]), "2"),
                    ),
                ],
            ),
            4 => (
                q.clone(),
                format!("h({q}) = {x}"),
                vec![(q.clone(), over(&format!("{x} + 3"), "2"))],
            ),
            5 => (
                q.clone(),
                format!(r"\sum_{{j=1}}^{m} j{q} = {}x", m * (m + 1) / 2),
                vec![(q.clone(), "x".into())],
            ),
            6 => (
                q.clone(),
                format!(r"\frac{{{q}}}{{a}} + \frac{{x}}{{b}} = {m}"),
                vec![(q.clone(), format!(r"{m}a - \frac{{ax}}{{b}}"))],
            ),
            7 => (
                q.clone(),
                format!(r"{q}\cos(x) + {q} = {m}\cos(x) + {m}"),
                vec![(q.clone(), m.to_string())],
            ),
            8 => (
                p.clone(),
                format!(r"\mathbf{{A}}{p} = {m}\mathbf{{A}}\mathbf{{A}}"),
                vec![(p.clone(), format!(r"{m}\mathbf{{A}}"))],
            ),
            9 => (
                q.clone(),
                format!(r"g({q}) = {q}^2 + {x}"),
                vec![(q.clone(), x.into())],
            ),
            10 => (
                q.clone(),
                format!(r"\det\begin{{bmatrix}} {q} & {m} \\ 1 & 2 \end{{bmatrix}} = {x}"),
                vec![(q.clone(), over(&format!("{x} + {m}"), "2"))],
            ),
            _ => (
                q.clone(),
                format!(r"\frac{{1}}{{2}}({q} - x)({q} + x) = \frac{{1}}{{2}}{q}^2 + {q} - {m}"),
                vec![(q.clone(), format!(r"{m} - \frac{{x^2}}{{2}}"))],
            ),
        };
        solve(&mut head, k, &unknowns, &equations);
        claims.extend(values);
    }
    let mut family = Family::new("unknowns that are linear", &head);
    for (unknown, value) in &claims {
        family.add(format!("{unknown} = {value}"), true);
        match unknown.contains("mathbf") {
            true => family.add(format!(r"{unknown} = 2({value})"), false),
            false => family.add(format!("{unknown} = {value} + 1"), false),
        }
    }
    assert!(family.len() >= 200);
    family.decides(0.95, 0.95);
}

/// Whether the text is refused, or at least nothing is decided in it.
fn says_nothing(text: &str) -> bool {
    let options = Options {
        repair: false,
        ..Options::default()
    };
    let Ok(document) = Document::parse("test.md", text) else {
        return true;
    };
    match rederive::audit::Audit::of(&document, options) {
        Err(_) => true,
        Ok(audit) => audit.outcomes.iter().all(|o| match o.verdict.word() {
            VerdictWord::Undecided | VerdictWord::Recalled => true,
            VerdictWord::Definition
            | VerdictWord::Holds
            | VerdictWord::HoldsGiven
            | VerdictWord::Misprint
            | VerdictWord::Refuted
            | VerdictWord::Loose => false,
        }),
    }
}

#[test]
fn only_equations_are_solved() {
    let mut wrong = Vec::new();
    let mut count = 0;
    for relation in [">", r"\ge", "<", r"\le", r"\ne", r"\approx", r"\to"] {
        for right in ["0", "1", "x", "2x + 1", "a"] {
            for left in ["q", "2q + 1", "q - x", "xq", "a - q", "q + q"] {
                count += 1;
                let claim = ["q = 0", "q > 0"][count % 2];
                let text = format!(
                    "{LETTERS}\n```math 1 solve q\n{left} {relation} {right}\n```\n```math 2 claim\n{claim}\n```\n"
                );
                if !says_nothing(&text) {
                    wrong.push(format!("{left} {relation} {right}: {claim}"));
                }
            }
        }
    }
    for condition in [
        r"\text{ for } x > 0",
        r"\text{ if } x = y",
        r", \quad x > 0",
        r", \quad q > 0",
        r"\quad (x \ne 0)",
        r"\text{ for } 0 < x < 1",
        r", \quad x \ne y",
        r"\text{ provided that } a < b",
    ] {
        for equation in ["q = 2x", "2q = x + y", "xq = y", "q + a = b", "q - x = 1"] {
            count += 1;
            let text = format!(
                "{LETTERS}\n```math 1 solve q\n{equation}{condition}\n```\n```math 2 claim\nq = 2x\n```\n"
            );
            if !says_nothing(&text) {
                wrong.push(format!("{equation}{condition}"));
            }
        }
    }
    println!("relations and conditions in systems: {count} seen");
    assert!(
        wrong.is_empty(),
        "{} are taken for equations:\n{}",
        wrong.len(),
        wrong.join("\n")
    );
}

/// A polynomial in x, from its constant on.
fn polynomial(p: &[i64], x: &str) -> String {
    let powers = [
        "".to_string(),
        x.to_string(),
        format!("{x}^2"),
        format!("{x}^3"),
    ];
    let terms: Vec<String> = p
        .iter()
        .zip(&powers)
        .rev()
        .map(|(c, power)| term(*c, power))
        .collect();
    sum(&terms)
}

fn at(p: &[i64], n: i64) -> i64 {
    p.iter().rev().fold(0, |sum, c| sum * n + c)
}

const NAMES: [&str; 6] = ["F", "G", "H", "K", "L", "M"];

/// `x - x + n`.
fn disguised(n: i64) -> String {
    format!("x - x{}", if n == 0 { String::new() } else { term(n, "") })
}

#[test]
fn functions_with_a_value_of_their_own_at_a_number() {
    let mut random = Random::new(14);
    let (mut decided, mut total) = (0.0, 0);
    for document in 0..6 {
        let mut head = LETTERS.to_string();
        let mut claims: Vec<(String, bool)> = Vec::new();
        for (k, name) in NAMES.iter().enumerate() {
            let n = random.between(-1, 2);
            let p: Vec<i64> = (0..3).map(|_| random.between(-3, 3)).collect();
            let own = match (k + document) % 3 {
                0 => at(&p, n),
                _ => at(&p, n) + *random.pick(&[-2, -1, 1, 2, 3]),
            };
            let with = disguised(n);
            let body = match (k + document) % 3 {
                2 => {
                    // The same with a factor that cannot be taken out: it has no value at n.
                    let factor = sum(&[" + x".into(), term(-n, "")]);
                    format!(r"\frac{{({})({factor})}}{{{factor}}}", polynomial(&p, "x"))
                }
                _ => polynomial(&p, "x"),
            };
            head += &format!(
                "\n```math {name} define\n{name}(x) = {body}, \\quad {name}({n}) = {own}\n```\n"
            );
            claims.push((format!("{name}({n}) = {own}"), true));
            claims.push((format!("{name}({with}) = {own}"), true));
            claims.push((format!("{name}({n}) = {}", own + 1), false));
            claims.push((format!("{name}({with}) = {}", own + 2), false));
            let image = polynomial(&p, "x");
            let same = own == at(&p, n);
            if (k + document) % 3 == 2 {
                claims.push((format!("{name}(x) = {body}"), true));
                claims.push((format!("{name}(x) = {image}"), false));
            } else {
                claims.push((format!("{name}(x) = {image}"), same));
                claims.push((format!("{name}(y) = {}", polynomial(&p, "y")), same));
            }
            if !same {
                claims.push((format!("{name}({with}) = {}", at(&p, n)), false));
                claims.push((
                    format!(r"\sum_{{j={n}}}^{{{n}}} {name}(j) = {}", at(&p, n)),
                    false,
                ));
                claims.push((
                    format!(
                        "{name}(y - x) - {name}(x - y) = ({}) - ({})",
                        polynomial(&p, "(y - x)"),
                        polynomial(&p, "(x - y)")
                    ),
                    n == 0,
                ));
            }
            claims.push((format!("{name}(x) = {image} + 1"), false));
        }
        let mut family = Family::new("functions with a value of their own", &head);
        for (claim, truth) in claims {
            family.add(claim, truth);
        }
        total += family.len();
        let (t, _) = family.check();
        decided += t / 6.0;
    }
    assert!(total >= 200, "{total}");
    assert!(decided > 0.3, "{decided}");
}

#[test]
fn functions_without_a_value_at_a_number() {
    let mut random = Random::new(15);
    let (mut decided, mut total) = (0.0, 0);
    for document in 0..5 {
        let mut head = LETTERS.to_string();
        let mut claims: Vec<(String, bool)> = Vec::new();
        for (k, name) in NAMES.iter().enumerate() {
            let n = if k % 2 == 0 { 0 } else { random.between(-1, 2) };
            let p: Vec<i64> = (0..3).map(|_| random.between(-3, 3)).collect();
            let (body, with) = (polynomial(&p, "x"), disguised(n));
            let condition = match (k + document) % 3 {
                0 => format!(r", \quad x \ne {n}"),
                1 => format!(r"\quad (x \ne {n})"),
                _ => format!(r"\quad \text{{for }} x \ne {n}"),
            };
            let own = at(&p, n) + 1;
            let has_own = k >= 3;
            let value = match has_own {
                true => format!(r", \quad {name}({n}) = {own}"),
                false => String::new(),
            };
            head +=
                &format!("\n```math {name} define\n{name}(x) = {body}{condition}{value}\n```\n");
            // What has no value at n, nothing holds of there.
            claims.push((format!("{name}({n}) = {}", at(&p, n)), false));
            claims.push((format!("{name}({with}) = {}", at(&p, n)), false));
            claims.push((format!("{name}(x) = {body} + 1"), false));
            claims.push((
                format!(
                    "{name}(y - y{}) = {own}",
                    if n == 0 { String::new() } else { term(n, "") }
                ),
                has_own,
            ));
            if n == 0 {
                claims.push((format!("{name}(a) = {}", polynomial(&p, "a")), true));
                claims.push((
                    format!("{name}(a + b) = {} + 2", polynomial(&p, "(a + b)")),
                    false,
                ));
            }
            if has_own {
                claims.push((format!("{name}(x) = {body}"), false));
                claims.push((format!("{name}({n}) = {own}"), true));
            } else {
                claims.push((format!("{name}(x) = {body}"), true));
                claims.push((format!("{name}(y) = {}", polynomial(&p, "y")), true));
            }
        }
        let mut family = Family::new("functions without a value at a number", &head);
        for (claim, truth) in claims {
            family.add(claim, truth);
        }
        total += family.len();
        let (t, _) = family.check();
        decided += t / 5.0;
        // The conditions themselves are no claims.
        let audit = audit(&head, Options::default()).expect("a document");
        for outcome in &audit.outcomes {
            assert_eq!(
                outcome.verdict.word(),
                VerdictWord::Definition,
                "{}: {}",
                audit.model.equations[outcome.equation].label,
                outcome.member
            );
        }
    }
    assert!(total >= 180, "{total}");
    assert!(decided > 0.8, "{decided}");
}

#[test]
fn limits_in_which_two_letters_move() {
    let mut random = Random::new(16);
    let mut family = Family::new("limits in which two letters move", LETTERS);
    while family.len() < 220 {
        let (i, j) = (random.between(0, 2), random.between(0, 2));
        let (c, d) = (random.between(1, 3), *random.pick(&[-2, -1, 1, 2]));
        let goals = format!(r"x \to {i}, \quad y \to {j}, \quad ");
        let dx = sum(&[" + x".into(), term(-i, "")]);
        let dy = sum(&[" + y".into(), term(-j, "")]);
        let off = *random.pick(&[0, 0, 1, -1]);
        // What depends on one of the two has its limit, and so has a continuous function of both.
        let (what, limit) = match random.between(0, 4) {
            0 => (format!("{c}x^2{}", term(d, "x")), c * i * i + d * i),
            1 => (format!("{c}y^2{}", term(d, "y")), c * j * j + d * j),
            2 => (format!("{c}x{}", term(d, "y")), c * i + d * j),
            3 => (format!("{c}xy{}", term(d, "")), c * i * j + d),
            _ => (format!(r"\frac{{{c}a({dy})}}{{{dy}}}{}", term(d, "a")), 0),
        };
        if what.contains('a') {
            family.add(
                format!("{goals}{what} \\to {}", sum(&[term(c + d + off, "a")])),
                off == 0,
            );
        } else {
            family.add(format!("{goals}{what} \\to {}", limit + off), off == 0);
        }
        // On the two axes, or on the diagonals, the limit is another one.
        let (u, v) = (format!("({dx})"), format!("({dy})"));
        let (what, limit) = match random.between(0, 3) {
            0 => (format!(r"\frac{{{u}{v}}}{{{u}^2 + {v}^2}}"), 0),
            1 => (
                format!(r"\frac{{{u}^2 - {v}^2}}{{{u}^2 + {v}^2}}"),
                *random.pick(&[-1, 0, 1]),
            ),
            2 => (
                format!(r"\frac{{{c}{u}^2}}{{{u}^2 + {v}^2}}"),
                *random.pick(&[0, c]),
            ),
            _ => (
                format!(r"\frac{{{u}}}{{{u} + {c}{v}}}"),
                *random.pick(&[0, 1]),
            ),
        };
        family.add(format!("{goals}{what} \\to {limit}"), false);
    }
    // The letters' own clauses say where they go, and are no claims.
    for i in ["0", "1", r"\infty"] {
        for j in ["0", "2", r"\infty"] {
            neither(&mut family, &format!(r"y \to {i}, \quad x \to {j}"));
            neither(
                &mut family,
                &format!(r"x \to {i}, \quad x^2 + y \to y, \quad x \to {j}"),
            );
        }
    }
    family.decides(0.15, 0.1);
}
