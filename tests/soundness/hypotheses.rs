//! What is supposed means what it says: relatives of hypotheses that lose their relation, that no
//! letter solves, that contradict each other or are the claim, that leave signs and arguments behind,
//! and of relations in a residual. The truth of each is known by construction.

use crate::common;
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{Signed, Zero};
use rederive::audit::Audit;
use rederive::check::Options;
use rederive::model::Letter;
use rederive::verdict::{PointValue, Verdict, Witness};

/// What is true of a claim.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Truth {
    True,
    False,
    /// The hypotheses say nothing: the claim is neither.
    Nothing,
}

use Truth::{False, Nothing, True};

/// Numbers that are always the same.
struct Draw(u64);

impl Draw {
    fn below(&mut self, n: i64) -> i64 {
        self.0 = self
            .0
            .wrapping_mul(6364136223846793005)
            .wrapping_add(1442695040888963407);
        ((self.0 >> 33) % n as u64) as i64
    }

    fn between(&mut self, low: i64, high: i64) -> i64 {
        low + self.below(high - low + 1)
    }

    fn of<'a>(&mut self, list: &[&'a str]) -> &'a str {
        list[self.below(list.len() as i64) as usize]
    }
}

/// A claim with what stands around it.
struct Relative {
    claim: String,
    key: &'static str,
    hypotheses: Vec<String>,
    truth: Truth,
}

fn relative(claim: impl Into<String>, hypotheses: &[&str], truth: Truth) -> Relative {
    Relative {
        claim: claim.into(),
        key: "assume",
        hypotheses: hypotheses.iter().map(|h| h.to_string()).collect(),
        truth,
    }
}

impl Relative {
    fn given(mut self) -> Self {
        self.key = "given";
        self
    }
}

const LETTERS: &str = r#"```toml symbols
a = { positive = true }
b = { positive = true }
c = { positive = true }
g = { positive = true }
m = { positive = true }
k = { positive = true }
x = { meaning = "any" }
y = { meaning = "any" }
z = { meaning = "any" }
r = { meaning = "any" }
s = { meaning = "any" }
p = { positive = true, value = "3" }
n = { domain = "integer", range = "0 < n < 4" }
w = { range = '0 < w \le 2' }
v = { range = "v < 0" }
t = { meaning = "time" }
u = { function_of = "t" }
```
"#;

fn document(relatives: &[Relative], symbols: &str) -> String {
    let mut text = format!("```toml document\ntitle = \"t\"\n```\n{symbols}");
    for (number, relative) in relatives.iter().enumerate() {
        text += &format!("```math c{number} claim\n{}\n```\n", relative.claim);
        let list: Vec<String> = relative
            .hypotheses
            .iter()
            .map(|h| format!("'{h}'"))
            .collect();
        if !list.is_empty() {
            text += &format!(
                "```toml c{number}\n{} = [{}]\n```\n",
                relative.key,
                list.join(", ")
            );
        }
    }
    text
}

fn audit(relatives: &[Relative], symbols: &str, options: Options) -> Audit {
    let text = document(relatives, symbols);
    common::audit(&text, options).unwrap_or_else(|r| panic!("{r}\n{text}"))
}

fn quickly() -> Options {
    Options {
        repair: false,
        ..Options::default()
    }
}

/// No verdict is wrong, and of those that have one at least so many hundredths are decided.
fn judge(relatives: &[Relative], symbols: &str, least: usize) {
    assert!(relatives.len() >= 200, "{}", relatives.len());
    let audit = audit(relatives, symbols, quickly());
    let (mut wrong, mut decided, mut decidable) = (Vec::new(), 0, 0);
    let mut open = Vec::new();
    for (relative, outcome) in relatives.iter().zip(&audit.outcomes) {
        let fine = match (&outcome.verdict, relative.truth) {
            (Verdict::Holds { .. } | Verdict::HoldsGiven(..), truth) => truth == True,
            (Verdict::Refuted(_) | Verdict::Misprint { .. }, truth) => truth == False,
            (Verdict::Undecided { .. }, _) => true,
            _ => false,
        };
        let is_undecided = matches!(outcome.verdict, Verdict::Undecided { .. });
        decided += usize::from(!is_undecided);
        decidable += usize::from(relative.truth != Nothing);
        let shown = format!(
            "{} with {:?}: {:?}, but {:?}",
            relative.claim, relative.hypotheses, relative.truth, outcome.verdict
        );
        if !fine {
            wrong.push(shown);
        } else if is_undecided && relative.truth != Nothing {
            open.push(shown);
        }
    }
    assert!(
        wrong.is_empty(),
        "{} wrong:\n{}",
        wrong.len(),
        wrong[..wrong.len().min(12)].join("\n")
    );
    println!("{decided} of {decidable} decided");
    assert!(
        100 * decided >= least * decidable,
        "{decided} of {decidable} decided:\n{}",
        open[..open.len().min(12)].join("\n")
    );
}

#[test]
fn a_relation_means_what_it_says() {
    let mut draw = Draw(1);
    let mut all = Vec::new();
    let truth = |holds: bool| if holds { True } else { False };
    for _ in 0..12 {
        let (l, h) = (draw.between(-4, 0), draw.between(1, 5));
        let q = draw.between(-6, 7);
        let x = draw.of(&["x", "y", "z"]);
        // Equations of what an inequality leaves open.
        for relation in ["<", ">", r"\le", r"\ge", r"\ne"] {
            all.push(relative(
                format!("{x} = {q}"),
                &[&format!("{x} {relation} {q}")],
                False,
            ));
        }
        all.push(relative(
            format!("a = {h}"),
            &[&format!("a < {}", h + 1)],
            False,
        ));
        all.push(relative(
            format!("{x} = {h}"),
            &[&format!("{h} \\le {x} \\le {h}")],
            True,
        ));
        // Moduli and roots of squares.
        let shifted = |n: i64| {
            if n < 0 {
                format!("{x} + {}", -n)
            } else {
                format!("{x} - {n}")
            }
        };
        all.push(relative(
            format!("|{}| = {}", shifted(q), shifted(q)),
            &[&format!("{x} > {h}")],
            truth(q <= h),
        ));
        all.push(relative(
            format!("\\sqrt{{({})^2}} = -({})", shifted(q), shifted(q)),
            &[&format!("{x} \\le {l}")],
            truth(q >= l),
        ));
        // Inequalities that follow and such that do not.
        all.push(relative(
            format!("{x} > {q}"),
            &[&format!("{x} > {h}")],
            truth(q <= h),
        ));
        all.push(relative(
            format!("{x} \\ge {q}"),
            &[&format!("{h} < {x} < {}", h + 3)],
            truth(q <= h),
        ));
        all.push(relative(
            format!("({})({}) < 0", shifted(l), shifted(h)),
            &[&format!("{l} < {x} < {h}")],
            True,
        ));
        all.push(relative(
            format!("({})({}) < 0", shifted(l), shifted(h)),
            &[&format!("{l} \\le {x} < {h}")],
            False,
        ));
        all.push(relative(
            format!("({})({}) > 0", shifted(q), shifted(l)),
            &[&format!("{x} > {h}")],
            truth(q <= h),
        ));
    }
    for (one, other) in [("a", "b"), ("b", "c"), ("x", "y"), ("a", "x"), ("z", "c")] {
        for (relation, sign) in [("<", -1), (">", 1), (r"\le", -1), (r"\ge", 1)] {
            let h = format!("{one} {relation} {other}");
            let (low, high) = if sign < 0 { (one, other) } else { (other, one) };
            let strict = relation.len() == 1;
            all.push(relative(
                format!("|{one} - {other}| = {high} - {low}"),
                &[&h],
                True,
            ));
            all.push(relative(
                format!("|{one} - {other}| = {low} - {high}"),
                &[&h],
                False,
            ));
            all.push(relative(
                format!("2{low} < {one} + {other}"),
                &[&h],
                truth(strict),
            ));
            all.push(relative(format!("{low}^3 \\le {high}^3"), &[&h], True));
            all.push(relative(format!("{one} = {other}"), &[&h], False));
            all.push(relative(format!("{low} > {high} + 1"), &[&h], False));
        }
        let different = format!("{one} \\ne {other}");
        let quotient = format!("\\frac{{{one}^2 - {other}^2}}{{{one} - {other}}}");
        all.push(relative(
            format!("{quotient} = {one} + {other}"),
            &[&different],
            True,
        ));
        all.push(relative(
            format!("{quotient} = {one} - {other}"),
            &[&different],
            False,
        ));
        all.push(relative(format!("{one} = {other}"), &[&different], False));
    }
    for (chain, holds) in [
        ("a < b < c", True),
        ("a < b, c < b", False),
        ("a < b, b < g, g < c", True),
        ("c < a, b < c", False),
    ] {
        all.push(relative("a < c", &[chain], holds));
        all.push(relative("|a - c| = c - a", &[chain], holds));
    }
    judge(&all, LETTERS, 95);
}

#[test]
fn stated_relations_are_used_and_named() {
    let mut draw = Draw(2);
    let mut all = Vec::new();
    for _ in 0..30 {
        let q = draw.between(0, 4);
        let x = draw.of(&["x", "y", "z"]);
        all.push(relative(format!("|{x}| = {x}"), &[&format!("{x} > {q}")], True).given());
        all.push(
            relative(
                format!("|{x}| = -{x}"),
                &[&format!("{x} \\ge {}", q + 1)],
                False,
            )
            .given(),
        );
        all.push(
            relative(
                format!("\\sqrt{{{x}^2}} = -{x}"),
                &[&format!("{x} \\le -{q}")],
                True,
            )
            .given(),
        );
        all.push(relative(format!("{x} = {q}"), &[&format!("{x} \\ge {q}")], False).given());
        all.push(relative(format!("{x}^2 = {q}{x}"), &[&format!("{x} = {q}")], True).given());
        all.push(
            relative(
                format!("{x}^2 = {}{x}", q + 2),
                &[&format!("{x} = {}", q + 1)],
                False,
            )
            .given(),
        );
        all.push(relative(format!("{x} > {q}"), &[&format!("{x} > {}", q + 1)], True).given());
        all.push(relative(format!("{x} > {}", q + 1), &[&format!("{x} > {q}")], False).given());
        // The claim itself is no hypothesis, and what the document's numbers break is none.
        all.push(relative(format!("{x} = {q}"), &[&format!("{x} = {q}")], False).given());
        all.push(
            relative(
                format!("p^2 = {}p", q + 4),
                &[&format!("p = {}", q + 4)],
                False,
            )
            .given(),
        );
    }
    all.push(relative("p^2 = 3p", &["p = 3"], True).given());
    // Those two kinds, a fifth of all, may stay open: false without the hypothesis, and it says nothing.
    judge(&all, LETTERS, 78);
}

/// A polynomial in letters, as a list of terms.
#[derive(Clone)]
struct Terms(Vec<(i64, Vec<(&'static str, u32)>)>);

impl Terms {
    fn times(&self, other: &Terms) -> Terms {
        let mut product: Vec<(i64, Vec<(&'static str, u32)>)> = Vec::new();
        for (c, m) in &self.0 {
            for (d, n) in &other.0 {
                let mut power = m.clone();
                for (letter, e) in n {
                    match power.iter_mut().find(|(l, _)| l == letter) {
                        Some((_, f)) => *f += e,
                        None => power.push((letter, *e)),
                    }
                }
                power.sort();
                match product.iter_mut().find(|(_, p)| *p == power) {
                    Some((e, _)) => *e += c * d,
                    None => product.push((c * d, power)),
                }
            }
        }
        product.retain(|(c, _)| *c != 0);
        Terms(product)
    }

    fn at(&self, point: &[(&str, BigRational)]) -> BigRational {
        let value = |letter: &str| {
            let found = point.iter().find(|(l, _)| *l == letter);
            found.map_or_else(BigRational::zero, |(_, v)| v.clone())
        };
        self.0
            .iter()
            .map(|(c, power)| {
                let factors = power
                    .iter()
                    .map(|(l, e)| num_traits::pow(value(l), *e as usize));
                BigRational::from_integer(BigInt::from(*c)) * factors.product::<BigRational>()
            })
            .sum()
    }

    /// `left = right` with some of the terms on either side.
    fn equation(&self, draw: &mut Draw) -> String {
        let mut sides = [String::new(), String::new()];
        for (c, power) in &self.0 {
            let side = draw.below(2) as usize;
            let c = if side == 0 { *c } else { -c };
            let letters: String = power
                .iter()
                .map(|(l, e)| {
                    if *e == 1 {
                        format!("{l} ")
                    } else {
                        format!("{l}^{{{e}}} ")
                    }
                })
                .collect();
            let text = &mut sides[side];
            *text += if c < 0 { " - " } else { " + " };
            if c.abs() != 1 || letters.is_empty() {
                *text += &c.abs().to_string();
            }
            *text += &letters;
        }
        let [left, right] = sides.map(|side| match side.trim_start().strip_prefix("+ ") {
            Some(rest) => rest.to_string(),
            None if side.is_empty() => "0".into(),
            None => side.trim_start().to_string(),
        });
        format!("{left} = {right}")
    }
}

fn number(n: i64, d: i64) -> BigRational {
    BigRational::new(n.into(), d.into())
}

#[test]
fn claims_follow_from_relations_that_no_letter_solves() {
    type Power = Vec<(&'static str, u32)>;
    let one = |l: &'static str| -> Power { vec![(l, 1)] };
    let two = |l: &'static str, m: &'static str| -> Power { vec![(l, 1), (m, 1)] };
    let square = |l: &'static str| -> Power { vec![(l, 2)] };
    // Each relation as printed, as a polynomial, and a point at which it holds.
    let relations: Vec<(&str, Terms, Vec<(&str, BigRational)>)> = vec![
        (
            "r^2 + s^2 = 1",
            Terms(vec![(1, square("r")), (1, square("s")), (-1, vec![])]),
            vec![
                ("r", number(3, 5)),
                ("s", number(4, 5)),
                ("x", number(2, 1)),
                ("a", number(3, 1)),
            ],
        ),
        (
            "ac = bg",
            Terms(vec![(1, two("a", "c")), (-1, two("b", "g"))]),
            vec![
                ("a", number(6, 1)),
                ("c", number(5, 1)),
                ("b", number(3, 1)),
                ("g", number(10, 1)),
                ("x", number(7, 1)),
            ],
        ),
        (
            "x(1 + y) = 1",
            Terms(vec![(1, one("x")), (1, two("x", "y")), (-1, vec![])]),
            vec![
                ("x", number(1, 3)),
                ("y", number(2, 1)),
                ("a", number(5, 1)),
            ],
        ),
        (
            r"z = \frac{x^2}{2 - x}",
            Terms(vec![(2, one("z")), (-1, two("x", "z")), (-1, square("x"))]),
            vec![
                ("x", number(3, 2)),
                ("z", number(9, 2)),
                ("a", number(5, 1)),
            ],
        ),
        (
            "x^2 - y^2 = 3",
            Terms(vec![(1, square("x")), (-1, square("y")), (-3, vec![])]),
            vec![
                ("x", number(2, 1)),
                ("y", number(1, 1)),
                ("a", number(7, 1)),
            ],
        ),
        (
            "x^3 = 8y^2",
            Terms(vec![(1, vec![("x", 3)]), (-8, square("y"))]),
            vec![
                ("x", number(2, 1)),
                ("y", number(1, 1)),
                ("a", number(7, 1)),
            ],
        ),
    ];
    let mut draw = Draw(3);
    let mut all = Vec::new();
    for round in 0..24 {
        for (printed, relation, point) in &relations {
            let letters: Vec<&'static str> = ["a", "x", "r", "s", "y", "b"]
                .into_iter()
                .filter(|l| point.iter().any(|(known, _)| known == l))
                .collect();
            let mut cofactor = Terms(Vec::new());
            for _ in 0..draw.between(1, 3) {
                let l = letters[draw.below(letters.len() as i64) as usize];
                let c = draw.between(1, 4) * if draw.below(2) == 0 { 1 } else { -1 };
                cofactor.0.push((c, vec![(l, draw.between(0, 2) as u32)]));
            }
            cofactor
                .0
                .iter_mut()
                .for_each(|(_, m)| m.retain(|(_, e)| *e > 0));
            let cofactor = cofactor.times(&Terms(vec![(1, vec![])]));
            let mut claim = cofactor.times(relation);
            if claim.0.is_empty() || round % 8 == 0 && cofactor.0.len() == 1 {
                claim = relation.times(&Terms(vec![(1, vec![("a", 1)])]));
            }
            let constant = cofactor.0.iter().all(|(_, m)| m.is_empty());
            if round % 2 == 0 && !constant {
                all.push(relative(claim.equation(&mut draw), &[printed], True));
            } else {
                let l = letters[draw.below(letters.len() as i64) as usize];
                claim.0.push((draw.between(1, 3), vec![(l, 1)]));
                let claim = claim.times(&Terms(vec![(1, vec![])]));
                let truth = if claim.at(point).is_zero() {
                    continue;
                } else {
                    False
                };
                all.push(relative(claim.equation(&mut draw), &[printed], truth));
            }
        }
    }
    for q in 1..12 {
        let h = r"m\ddot u = -ku";
        let energy = |f: i64, g: i64| format!(r"\frac{{d}}{{dt}}({f}m\dot u^2 + {g}ku^2) = 0");
        all.push(relative(energy(q, q), &[h], True));
        all.push(relative(energy(q, q + 1), &[h], False));
        all.push(relative(
            format!(r"{q}m\ddot u + {q}ku = 0"),
            &[h, "m = 2k"],
            True,
        ));
        all.push(relative(
            format!(r"\ddot u = -{q}u"),
            &[h, &format!("k = {q}m")],
            True,
        ));
        all.push(relative(
            format!(r"\ddot u = {q}u"),
            &[h, &format!("k = {q}m")],
            False,
        ));
        all.push(relative(
            format!(r"\frac{{d^2}}{{dt^2}}(m\ddot u) = {q}^2 u"),
            &[h, &format!("k = {q}"), "m = 1"],
            True,
        ));
        all.push(relative(
            format!(r"{}x^2 = {q}", 2 * q),
            &[r"x = 1/\sqrt2"],
            True,
        ));
        all.push(relative(
            format!(r"{}x^2 = {q}", q),
            &[r"x = 1/\sqrt2"],
            False,
        ));
    }
    judge(&all, LETTERS, 90);
}

#[test]
fn from_a_contradiction_nothing_follows() {
    let mut draw = Draw(4);
    let mut all = Vec::new();
    for _ in 0..10 {
        let (l, h) = (draw.between(1, 4), draw.between(5, 9));
        let claims = ["a = a", "x = 2x + 1", "a > 0", "|x| = x", "ab = ba"];
        let contradictions: Vec<Vec<String>> = vec![
            vec!["a + b = 0".into()],
            vec![format!("a = -{l}b")],
            vec![format!("a > {h}"), format!("a < {l}")],
            vec!["a > b".into(), "b > a".into()],
            vec!["a < b < c < a".into()],
            vec![format!("x = {l}"), format!("x = {h}")],
            vec![format!("x^2 + {l} = 0")],
            vec![format!("x = {l}"), format!("x < {l}")],
            vec!["r^2 + s^2 = 1".into(), format!("s > {h}")],
            vec![format!("xy = {l}"), "x = 0".into()],
            vec!["a = b".into(), r"a \ne b".into()],
            vec![format!("{l} = {h}")],
            vec![format!("w = {h}")],
            vec![format!("v = {h}a")],
            vec![format!("n = {h}")],
        ];
        for hypotheses in contradictions {
            let list: Vec<&str> = hypotheses.iter().map(String::as_str).collect();
            let claim = draw.of(&claims);
            all.push(relative(claim, &list, Nothing));
        }
        // Near to them, and none.
        all.push(relative("b = 2b", &["a - b = 0"], False));
        all.push(relative(
            format!("a^2 = {}b^2", l * l),
            &[&format!("a = {l}b")],
            True,
        ));
        all.push(relative(
            format!("a < {h}"),
            &[&format!("{l} < a"), &format!("a < {}", h - 1)],
            True,
        ));
        all.push(relative(
            format!("x^2 = {}", l * l),
            &[&format!("x = {l}")],
            True,
        ));
        all.push(relative(format!("w < {h}"), &[], True));
        all.push(relative("v < 0", &[], True));
        // What is supposed proves itself, and nothing else.
        all.push(relative("x = y", &["x = y"], Nothing));
        all.push(relative(format!("{l}x = {l}y"), &["x = y"], True));
        all.push(relative(
            format!("x < {l}"),
            &[&format!("x < {l}")],
            Nothing,
        ));
    }
    judge(&all, LETTERS, 95);
}

#[test]
fn definitions_make_their_relations_true() {
    let mut text = String::from(
        "```toml document\ntitle = \"t\"\n```\n```toml symbols\na = { positive = true }\nb = { positive = true }\n```\n",
    );
    let mut truths = Vec::new();
    for k in 1..=70 {
        let (n, m) = (k % 7 + 2, k % 5 + 1);
        text += &format!(
            "```math d{k} define\np_{{{k}}} = \\frac{{1 + {m}a}}{{{n}}}, \\quad q_{{{k}}} = \\frac{{1 - {m}a}}{{{n}}}\n```\n"
        );
        for (j, (claim, truth)) in [
            (format!("p_{{{k}}} + q_{{{k}}} = \\frac{{2}}{{{n}}}"), true),
            (format!("{n}p_{{{k}}} = 2 - {n}q_{{{k}}}"), true),
            (format!("p_{{{k}}} - q_{{{k}}} = \\frac{{2}}{{{n}}}"), false),
        ]
        .into_iter()
        .enumerate()
        {
            text += &format!("```math c{k}-{j} claim\n{claim}\n```\n");
            truths.push(truth);
        }
    }
    let audit = common::audit(&text, quickly()).unwrap_or_else(|r| panic!("{r}"));
    let claims = audit
        .outcomes
        .iter()
        .filter(|o| audit.model.equations[o.equation].label.starts_with('c'));
    let mut count = 0;
    for (outcome, truth) in claims.zip(truths) {
        count += 1;
        match &outcome.verdict {
            Verdict::Holds { by, .. } => assert!(truth && by.len() == 1),
            Verdict::Refuted(_) => assert!(!truth),
            other => panic!("{other:?}"),
        }
    }
    assert_eq!(count, 210);
}

#[test]
fn what_is_replaced_keeps_its_sign_and_its_functions_follow() {
    let mut draw = Draw(5);
    let mut all = Vec::new();
    for _ in 0..10 {
        let x = draw.of(&["x", "y"]);
        let (q, e) = (
            draw.between(1, 9),
            draw.of(&["a", "ab", "a + b", "a^2 + c"]),
        );
        let h = format!("{x} = {q}({e})");
        let back = format!("{q}({e}) = {x}");
        for h in [&h, &back] {
            all.push(relative(format!("|{x}| = {x}"), &[h], True));
            all.push(relative(format!("|{x}| = {q}({e})"), &[h], True));
            all.push(relative(format!("\\sqrt{{{x}^2}} = -{x}"), &[h], False));
            all.push(relative(
                format!("\\sqrt{{({e}){x}}} = \\sqrt{{{q}}}({e})"),
                &[h],
                True,
            ));
            all.push(relative(format!("{x} > 0"), &[h], True));
        }
        let negative = format!("{x} = -{e}");
        let negative = if e.contains('+') {
            format!("{x} = -({e})")
        } else {
            negative
        };
        all.push(relative(format!("|{x}| = {e}"), &[&negative], True));
        all.push(relative(format!("|{x}| = {x}"), &[&negative], False));
        for (function, at, value, wrong) in [
            (r"\cos z", "z = 0", 1, 0),
            (r"\sin z", "z = 0", 0, 1),
            (r"e^z", "z = 0", 1, 2),
            (r"\sqrt{z}", "z = 9", 3, 9),
            (r"\sqrt{z + 7}", "z = 9", 4, 3),
            (r"|z - 5|", "z = 2", 3, -3),
        ] {
            let h = format!("{function} = {x}");
            for order in [[h.as_str(), at], [at, h.as_str()]] {
                all.push(relative(format!("{q}{x} = {}", q * value), &order, True));
                all.push(relative(format!("{q}{x} = {}", q * wrong), &order, False));
            }
        }
    }
    judge(
        &all,
        &format!("{LETTERS}```toml notation\ne = {{ constant = \"e\" }}\n```\n"),
        95,
    );
}

#[test]
fn a_relation_in_a_residual_is_offered_where_nothing_else_can_vanish() {
    let mut draw = Draw(6);
    let mut all = Vec::new();
    // left - right = cofactor (relation), and whether it may be offered.
    let mut offers = Vec::new();
    for k in 0..210 {
        let (q, e) = (draw.between(2, 9), draw.of(&["a", "b", "c"]));
        let (cofactor, able) = match k % 6 {
            0 => (format!("{e}^2"), true),
            1 => (format!("\\frac{{{e}}}{{{q}}}"), true),
            2 => (format!("({e} + {q})"), true),
            // The relation alone, a factor that may vanish too, and one that is a number.
            3 => (q.to_string(), false),
            4 => ("(x - 1)".to_string(), false),
            _ => ("1".to_string(), false),
        };
        let (one, other) = [("a", "g"), ("ab", "cg"), ("b^2", "c"), ("g", "bc")][k / 6 % 4];
        let claim = format!("{cofactor}{one} + bg = {cofactor}{other} + bg");
        all.push(relative(claim, &[], False));
        offers.push(able);
    }
    let options = Options {
        candidates: 40,
        ..Options::default()
    };
    let audit = audit(&all, LETTERS, options);
    let mut offered = 0;
    for ((outcome, able), relative) in audit.outcomes.iter().zip(&offers).zip(&all) {
        match &outcome.verdict {
            Verdict::HoldsGiven(given, _) => {
                assert!(*able && given.is_offered(), "{}", relative.claim);
                offered += 1;
                let relation = &given.relations[0];
                let at = |witness: &Witness| {
                    let mut point = vec![BigRational::zero(); audit.model.letters.len()];
                    for (letter, value) in &witness.point {
                        let value = exact(value);
                        if let Letter::Symbol { symbol, .. } = audit.model.letters[*letter] {
                            let range = &audit.model.symbols[symbol].range;
                            assert!(range.contains(value), "{}", relative.claim);
                        }
                        point[*letter] = value.clone();
                    }
                    relation.evaluate(&point).unwrap()
                };
                let (yes, no) = (given.instance.as_ref(), given.counterexample.as_ref());
                let (yes, no) = (yes.unwrap(), no.unwrap());
                assert!(
                    at(yes).is_zero() && yes.left == yes.right,
                    "{}",
                    relative.claim
                );
                assert!(
                    !at(no).is_zero() && no.left != no.right,
                    "{}",
                    relative.claim
                );
                // Nothing has acknowledged it.
                assert_eq!(
                    audit.standing(outcome),
                    rederive::standing::Standing::Differs
                );
            }
            Verdict::Refuted(_) | Verdict::Misprint { .. } => {}
            other => panic!("{}: {other:?}", relative.claim),
        }
    }
    println!("{offered} offered");
    assert!(offered >= 60, "{offered}");
}

fn exact(value: &PointValue) -> &BigRational {
    value.exact().expect("a rational number")
}

#[test]
fn counterexamples_lie_where_the_hypotheses_hold() {
    let mut draw = Draw(7);
    let mut all = Vec::new();
    for _ in 0..70 {
        let q = draw.between(1, 5);
        all.push(relative(
            format!("x^2 = {q}x"),
            &[&format!("{q} < x < {}", q + 1)],
            False,
        ));
        all.push(relative(format!("w + n = {q}v"), &[], False));
        all.push(relative(
            format!("r = {q}s"),
            &["r^2 + s^2 = 1", "r > 0"],
            False,
        ));
    }
    let audit = audit(&all, LETTERS, quickly());
    let mut shown = 0;
    for (outcome, relative) in audit.outcomes.iter().zip(&all) {
        let Verdict::Refuted(refutation) = &outcome.verdict else {
            continue;
        };
        let witness = refutation.witness().expect("a point");
        let value = |name: &str| {
            let named = |l: usize| rederive::latex::canonical(&audit.model.letter_name(l)) == name;
            let found = witness.point.iter().find(|(l, _)| named(*l));
            found.and_then(|(_, v)| v.exact().cloned())
        };
        for (letter, value) in &witness.point {
            let PointValue::Exact(value) = value else {
                continue;
            };
            if let Letter::Symbol { symbol, .. } = audit.model.letters[*letter] {
                let range = &audit.model.symbols[symbol].range;
                assert!(range.contains(value), "{}: {witness:?}", relative.claim);
            }
        }
        if let (Some(r), Some(s)) = (value("r"), value("s")) {
            assert!(
                (&r * &r + &s * &s) == number(1, 1) && r.is_positive(),
                "{witness:?}"
            );
        }
        shown += 1;
    }
    assert!(shown >= 200, "{shown} of {}", all.len());
}
