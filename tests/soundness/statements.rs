//! Statements in words whose truth is known by an evaluator of their own: what is said of polynomials
//! in one letter over its range, by exact fractions; and of functions of several letters, by hand.

use super::signs::Random;
use crate::common::audit;
use rederive::check::Options;
use rederive::document::VerdictWord;

/// A fraction.
pub type Q = (i128, i128);

pub fn q(n: i128, d: i128) -> Q {
    let (mut a, mut b) = (n.abs(), d.abs());
    while b != 0 {
        (a, b) = (b, a % b);
    }
    let g = a.max(1) * d.signum();
    (n / g, d / g)
}

fn add(a: Q, b: Q) -> Q {
    q(a.0 * b.1 + b.0 * a.1, a.1 * b.1)
}

fn times(a: Q, b: Q) -> Q {
    q(a.0 * b.0, a.1 * b.1)
}

fn less(a: Q, b: Q) -> bool {
    a.0 * b.1 < b.0 * a.1
}

/// A polynomial in one letter with its derivative's roots, in halves.
pub struct Poly {
    coefficients: Vec<Q>,
    pub roots: Vec<i128>,
}

impl Poly {
    /// The integral of c times the product of (2x - r), with a constant.
    pub fn with_slope(c: i128, roots: &[i128], constant: i128) -> Self {
        let mut slope: Vec<Q> = vec![q(c, 1)];
        for r in roots {
            let mut next = vec![q(0, 1); slope.len() + 1];
            for (k, s) in slope.iter().enumerate() {
                next[k] = add(next[k], times(*s, q(-r, 1)));
                next[k + 1] = add(next[k + 1], times(*s, q(2, 1)));
            }
            slope = next;
        }
        let mut coefficients = vec![q(constant, 1)];
        for (k, s) in slope.iter().enumerate() {
            coefficients.push(times(*s, q(1, k as i128 + 1)));
        }
        Poly {
            coefficients,
            roots: roots.to_vec(),
        }
    }

    fn at(&self, x: Q) -> Q {
        let horner = |sum, c: &Q| add(times(sum, x), *c);
        self.coefficients.iter().rev().fold(q(0, 1), horner)
    }

    fn slope(&self, x: Q) -> Q {
        let terms = self.coefficients.iter().enumerate().skip(1).rev();
        terms.fold(q(0, 1), |sum, (k, c)| {
            add(times(sum, x), times(*c, q(k as i128, 1)))
        })
    }

    fn second(&self, x: Q) -> Q {
        let terms = self.coefficients.iter().enumerate().skip(2).rev();
        terms.fold(q(0, 1), |sum, (k, c)| {
            let k = k as i128;
            add(times(sum, x), times(*c, q(k * (k - 1), 1)))
        })
    }

    pub fn text(&self, x: &str) -> String {
        let terms = self.coefficients.iter().enumerate();
        let terms: Vec<String> = terms
            .filter(|(_, c)| c.0 != 0)
            .map(|(k, (n, d))| format!(r"\left({n}\right)\frac{{{x}^{k}}}{{{d}}}"))
            .collect();
        if terms.is_empty() {
            "0".into()
        } else {
            terms.join(" + ")
        }
    }
}

/// A letter: its name, its reference value, and its ends in halves, each with whether it belongs to it.
#[derive(Clone, Copy)]
pub struct Letter {
    pub name: &'static str,
    pub value: i128,
    pub low: Option<(i128, bool)>,
    pub high: Option<(i128, bool)>,
}

const LETTERS: [Letter; 5] = [
    Letter {
        name: "x",
        value: 2,
        low: Some((0, false)),
        high: None,
    },
    Letter {
        name: "r",
        value: 1,
        low: None,
        high: None,
    },
    Letter {
        name: "u",
        value: 1,
        low: Some((0, true)),
        high: Some((4, true)),
    },
    Letter {
        name: "v",
        value: 1,
        low: Some((-2, false)),
        high: Some((6, false)),
    },
    Letter {
        name: "w",
        value: 2,
        low: Some((2, true)),
        high: None,
    },
];

impl Letter {
    fn contains(&self, halves: i128) -> bool {
        self.low.is_none_or(|(l, c)| halves > l || c && halves == l)
            && self
                .high
                .is_none_or(|(l, c)| halves < l || c && halves == l)
    }

    /// Points in quarters that show every sign of a function with roots in halves.
    fn grid(&self) -> Vec<Q> {
        let inside = |k: &i128| {
            self.low.is_none_or(|(l, c)| *k > 2 * l || c && *k == 2 * l)
                && self
                    .high
                    .is_none_or(|(l, c)| *k < 2 * l || c && *k == 2 * l)
        };
        (-60..=120).filter(inside).map(|k| q(k, 4)).collect()
    }

    /// The only place at which a polynomial is least, with the value there.
    pub fn least(&self, f: &Poly, sign: i128) -> Option<(Q, Q)> {
        let value = |x: Q| times(q(sign, 1), f.at(x));
        let mut places: Vec<Q> = f
            .roots
            .iter()
            .filter(|r| self.contains(**r))
            .map(|r| q(*r, 2))
            .collect();
        let mut limits = Vec::new();
        for (end, far) in [(self.low, -1_000), (self.high, 1_000)] {
            match end {
                Some((end, true)) => places.push(q(end, 2)),
                Some((end, false)) => limits.push(value(q(end, 2))),
                // Far beyond all roots it runs to one of the infinities.
                None => limits.push(value(q(far, 1))),
            }
        }
        places.sort_by(|a, b| (a.0 * b.1).cmp(&(b.0 * a.1)));
        places.dedup();
        let best = places
            .iter()
            .map(|p| value(*p))
            .reduce(|a, b| if less(b, a) { b } else { a })?;
        let at: Vec<&Q> = places.iter().filter(|p| value(**p) == best).collect();
        if at.len() != 1 || limits.iter().any(|l| less(*l, best)) {
            return None;
        }
        Some((*at[0], f.at(*at[0])))
    }
}

const HEAD: &str = r#"
```toml symbols
x = { unit = "m", positive = true, value = "2", meaning = "" }
y = { unit = "s", positive = true, value = "3", meaning = "" }
z = { unit = "1", positive = true, meaning = "" }
r = { unit = "1", value = "1", meaning = "" }
s = { unit = "1", value = "-1", meaning = "" }
u = { unit = "1", range = '0 \le u \le 2', value = "1", meaning = "" }
v = { unit = "1", range = '-1 < v < 3', value = "1", meaning = "" }
w = { unit = "1", range = '1 \le w', value = "2", meaning = "" }
n = { unit = "1", domain = "integer", range = '0 < n', value = "2", meaning = "" }
```
```toml notation
'\pi' = { constant = "pi" }
```
"#;

struct Statements {
    name: &'static str,
    all: Vec<(String, bool)>,
}

impl Statements {
    fn new(name: &'static str) -> Self {
        Statements {
            name,
            all: Vec::new(),
        }
    }

    fn say(&mut self, of: &str, predicate: &str, arguments: &str, truth: bool) {
        let settings = format!("of = ['{of}']\npredicate = \"{predicate}\"\n{arguments}\n");
        self.all.push((settings, truth));
    }

    /// None may hold that is false, and none that is true may be refuted or called loose.
    fn decides(&self, of_true: f64, of_false: f64) {
        let mut text = HEAD.to_string();
        for (k, (settings, _)) in self.all.iter().enumerate() {
            text +=
                &format!("\n```statement S{k}\nAs printed.\n```\n```toml S{k}\n{settings}```\n");
        }
        let options = Options {
            repair: false,
            ..Options::default()
        };
        let audit = audit(&text, options).unwrap_or_else(|e| panic!("{}: {e}", self.name));
        let mut wrong = Vec::new();
        let (mut decided, mut all) = ([0_usize; 2], [0_usize; 2]);
        for outcome in &audit.statements {
            let (settings, truth) = &self.all[outcome.statement];
            let word = outcome.word;
            all[usize::from(*truth)] += 1;
            decided[usize::from(*truth)] += usize::from(word != VerdictWord::Undecided);
            let bad = match truth {
                true => matches!(word, VerdictWord::Refuted | VerdictWord::Loose),
                false => word == VerdictWord::Holds,
            };
            if bad {
                wrong.push(format!(
                    "{settings}is {truth}, and said to be {word:?}: {:?}",
                    outcome.facts
                ));
            }
        }
        let count = self.all.len();
        assert!(
            wrong.is_empty(),
            "{}: {} of {count} are wrong:\n{}",
            self.name,
            wrong.len(),
            wrong.join("\n")
        );
        let share = |k: usize| decided[k] as f64 / all[k].max(1) as f64;
        println!(
            "{}: {} true, {:.0} % decided; {} false, {:.0} % decided",
            self.name,
            all[1],
            100.0 * share(1),
            all[0],
            100.0 * share(0)
        );
        assert!(share(1) >= of_true && share(0) >= of_false, "{}", self.name);
    }
}

fn polynomial(random: &mut Random) -> (Letter, Poly) {
    let letter = *random.pick(&LETTERS);
    let roots: Vec<i128> = (0..random.between(0, 3))
        .map(|_| i128::from(random.between(-3, 7)))
        .collect();
    let c = i128::from(*random.pick(&[-3, -1, 1, 2]));
    let f = Poly::with_slope(c, &roots, i128::from(random.between(-4, 4)));
    (letter, f)
}

#[test]
fn monotony_and_convexity() {
    let mut random = Random::new(11);
    let mut family = Statements::new("monotony and convexity");
    for _ in 0..70 {
        let (letter, f) = polynomial(&mut random);
        let (text, x) = (f.text(letter.name), letter.name);
        let arguments = format!("in = \"{x}\"");
        let grid = letter.grid();
        let rises = grid.iter().all(|p| f.slope(*p).0 >= 0);
        let falls = grid.iter().all(|p| f.slope(*p).0 <= 0);
        family.say(&text, "increasing in", &arguments, rises);
        family.say(&text, "decreasing in", &arguments, falls);
        family.say(&text, "not monotone in", &arguments, !rises && !falls);
        if f.roots.len() < 2 {
            // Of a straight line it is said that it is not convex in the strict sense.
            let convex = f.roots.len() == 1 && f.second(q(0, 1)).0 > 0;
            family.say(&text, "convex in", &arguments, convex);
        }
    }
    for (of, predicate, truth) in [
        (r"\frac{1}{r}", "decreasing in", false),
        (r"-\frac{1}{r}", "increasing in", false),
        (r"\frac{1}{r}", "increasing in", false),
        (r"\frac{r}{r^2 + 1}", "increasing in", false),
        (r"\frac{1}{r - 5}", "decreasing in", false),
        (r"\frac{1}{r^2 + 1}", "not monotone in", true),
        (r"r^3", "increasing in", true),
        (r"r^3", "convex in", false),
        (r"r^4", "convex in", true),
        (r"r^3 + r", "increasing in", true),
        (r"(r - y)^3", "increasing in", true),
        (r"(s - y)r", "decreasing in", false),
        (r"(s^2 + y)r", "increasing in", true),
        (r"s^2r", "increasing in", false),
    ] {
        family.say(of, predicate, "in = \"r\"", truth);
        family.say(
            &format!(r"3 + 2\left({of}\right)"),
            predicate,
            "in = \"r\"",
            truth,
        );
    }
    for (of, predicate, letter, truth) in [
        (r"\frac{1}{x}", "decreasing in", "x", true),
        (r"\frac{1}{x - y}", "decreasing in", "x", false),
        (r"\frac{1}{2 - v}", "increasing in", "v", false),
        (r"\frac{1}{4 - v}", "increasing in", "v", true),
        (r"\frac{1}{3 - v}", "increasing in", "v", true),
        (r"\frac{1}{u + 1}", "decreasing in", "u", true),
        (r"n^2", "increasing in", "n", true),
        (r"(2n - 3)^2", "increasing in", "n", false),
        (r"(2n - 2)^2", "increasing in", "n", true),
        (r"uw", "increasing in", "w", false),
        (r"uw", "increasing in", "u", true),
        (r"vw", "increasing in", "w", false),
    ] {
        family.say(of, predicate, &format!("in = \"{letter}\""), truth);
        family.say(
            &format!(r"1 + \left({of}\right)"),
            predicate,
            &format!("in = \"{letter}\""),
            truth,
        );
    }
    assert!(family.all.len() >= 200);
    family.decides(0.9, 0.8);
}

#[test]
fn positive_quantities() {
    let mut random = Random::new(12);
    let mut family = Statements::new("positive quantities");
    while family.all.len() < 180 {
        let letter = *random.pick(&LETTERS);
        let roots: Vec<i64> = (0..random.between(1, 3))
            .map(|_| random.between(-3, 7))
            .collect();
        let x = letter.name;
        let factors: Vec<String> = roots.iter().map(|r| format!("(2{x} - ({r}))")).collect();
        let value = |p: &Q| {
            let signs = roots
                .iter()
                .map(|r| (2 * p.0 - i128::from(*r) * p.1).signum());
            signs.product::<i128>()
        };
        let truth = letter.grid().iter().all(|p| value(p) > 0);
        family.say(&factors.concat(), "positive", "", truth);
    }
    for (of, truth) in [
        ("x - x", false),
        ("0", false),
        ("r^2", false),
        ("r^2 + 1", true),
        ("r", false),
        ("u", false),
        ("u + 1", true),
        ("w", true),
        ("v + 1", true),
        ("v", false),
        (r"\frac{1}{r^2}", false),
        (r"\frac{1}{r^2 + 1}", true),
        (r"\frac{1}{(x - y)^2}", false),
        (r"(r - s)^2", false),
        (r"(r - s)^2 + x", true),
        (r"rs + 1", false),
        (r"\pi - 3", true),
        (r"\pi - 4", false),
        (r"3 - v", true),
        (r"2 - u", false),
        (r"n - \frac{1}{2}", true),
        (r"n - 1", false),
    ] {
        family.say(of, "positive", "", truth);
    }
    assert!(family.all.len() >= 200);
    family.decides(0.85, 0.9);
}

#[test]
fn extrema() {
    let mut random = Random::new(13);
    let mut family = Statements::new("extrema");
    for _ in 0..60 {
        let (letter, f) = polynomial(&mut random);
        let (text, x) = (f.text(letter.name), letter.name);
        let least = letter.least(&f, 1);
        let largest = letter.least(&f, -1);
        let arguments = format!("in = \"{x}\"");
        family.say(&text, "has a minimum in", &arguments, least.is_some());
        family.say(&text, "has a maximum in", &arguments, largest.is_some());
        for (predicate, best) in [("minimal at", least), ("maximal at", largest)] {
            let here = best.is_some_and(|(at, _)| at == q(letter.value, 1));
            family.say(&text, predicate, &arguments, here);
            let h = i128::from(random.between(-2, 6));
            let at = match best {
                Some((at, _)) if random.between(0, 1) == 0 => at,
                _ => q(h, 2),
            };
            let truth = best.is_some_and(|(place, _)| place == at);
            let formula = format!(r"\left({}\right)\frac{{1}}{{{}}}", at.0, at.1);
            family.say(
                &text,
                predicate,
                &format!("{arguments}\nat = '{formula}'"),
                truth,
            );
        }
        let value = q(letter.value, 1);
        let near = least.is_some_and(|(_, m)| {
            let excess = add(f.at(value), times(q(-1, 1), m));
            // At most a tenth of the modulus.
            !less(times(q(m.0.abs(), m.1), q(1, 10)), excess)
        });
        family.say(&text, "nearly minimal at", &arguments, near);
        let above: Vec<Q> = f
            .roots
            .iter()
            .filter(|r| letter.contains(**r) && **r > 2 * letter.value)
            .map(|r| q(*r, 2))
            .chain(letter.high.map(|(h, _)| q(h, 2)))
            .chain(letter.high.is_none().then_some(q(1_000, 1)))
            .chain([add(value, q(1, 64))])
            .collect();
        let worse = above.iter().all(|p| less(f.at(value), f.at(*p)));
        family.say(&text, "least at the lower bound of", &arguments, worse);
    }
    for (of, predicate, arguments, truth) in [
        ("x^2 - 100x", "nearly minimal at", "in = \"x\"", false),
        ("x^2 - 4x", "nearly minimal at", "in = \"x\"", true),
        ("x^2 - 4.1x", "nearly minimal at", "in = \"x\"", true),
        ("(x - 2)^2", "minimal at", "in = \"x\"", true),
        ("(x - 2)^2", "nearly minimal at", "in = \"x\"", true),
        ("(x - 3)^2", "minimal at", "in = \"x\"", false),
        ("(x - 3)^2", "nearly minimal at", "in = \"x\"", false),
        ("(r - s)^2", "minimal at", "in = \"r\"\nat = 's'", true),
        ("r^2 - 2rs", "minimal at", "in = \"r\"\nat = 's'", true),
        ("r^2 - 2rs", "minimal at", "in = \"r\"\nat = '-s'", false),
        ("r^2", "minimal at", "in = \"r\"\nat = '0'", true),
        ("r^2", "has a minimum in", "in = \"r\"", true),
        ("sr^2", "has a minimum in", "in = \"r\"", false),
        ("(s^2 + 1)r^2 - r", "has a minimum in", "in = \"r\"", true),
        ("u", "has a minimum in", "in = \"u\"", true),
        ("u", "minimal at", "in = \"u\"\nat = '0'", true),
        ("v", "has a minimum in", "in = \"v\"", false),
        ("w^2", "has a minimum in", "in = \"w\"", true),
        ("w^2", "has a maximum in", "in = \"w\"", false),
        (r"r + \frac{1}{r}", "has a minimum in", "in = \"r\"", false),
        (r"x + \frac{1}{x}", "has a minimum in", "in = \"x\"", true),
        (
            r"r^2 + \frac{1}{r^2}",
            "has a minimum in",
            "in = \"r\"",
            false,
        ),
        (r"(r^2 - 1)^2", "has a minimum in", "in = \"r\"", false),
        (
            r"x^4 - 8x^3 + 22x^2 - 24x + \frac{x}{100}",
            "has a minimum in",
            "in = \"x\"",
            true,
        ),
        (r"-(x - 2)^2", "maximal at", "in = \"x\"", true),
        (
            r"x + \frac{8}{x}",
            "worse at the minimum of",
            "in = \"x\"\nminimum_of = 'x + \\frac{2}{x}'",
            true,
        ),
        (
            r"x + \frac{8}{x} - 100",
            "worse at the minimum of",
            "in = \"x\"\nminimum_of = 'x + \\frac{2}{x}'",
            false,
        ),
        (
            r"x + \frac{y + 1}{x}",
            "worse at the minimum of",
            "in = \"x\"\nminimum_of = 'x + \\frac{1}{x}'",
            false,
        ),
        (
            r"(x - 3)^2 + 1",
            "worse at the minimum of",
            "in = \"x\"\nminimum_of = '(x - 2)^2'",
            true,
        ),
        (
            r"(x - 3)^2 + 100",
            "worse at the minimum of",
            "in = \"x\"\nminimum_of = '(x - 2)^2'",
            false,
        ),
        (
            r"(r - 3)^2 - 100",
            "worse at the minimum of",
            "in = \"r\"\nminimum_of = '(r - 2)^2'",
            false,
        ),
    ] {
        family.say(of, predicate, arguments, truth);
        if !predicate.contains("nearly") && !predicate.contains("worse") {
            family.say(
                &format!(r"3\left({of}\right) - 7"),
                predicate,
                arguments,
                truth,
            );
        }
    }
    assert!(family.all.len() >= 400);
    family.decides(0.85, 0.85);
}

#[test]
fn dependence_and_comparison() {
    let mut family = Statements::new("dependence and comparison");
    let letters = [
        ("x", "y"),
        ("y", "x"),
        ("r", "s"),
        ("s", "x"),
        ("u", "w"),
        ("v", "u"),
    ];
    for (a, b) in letters {
        let on = format!("in = \"{a}\"");
        let both = format!("in = [\"{a}\", \"{b}\"]");
        for (of, predicate, arguments, truth) in [
            (
                format!("{b}^2 + {a} - {a}"),
                "independent of",
                on.clone(),
                true,
            ),
            (format!("{b}^2 + 5{a}"), "independent of", on.clone(), false),
            (
                format!(r"\frac{{{a}{b}}}{{{a}}}"),
                "independent of",
                on.clone(),
                true,
            ),
            (
                format!("({a} + {b})^2 - {a}^2 - 2{a}{b}"),
                "independent of",
                on.clone(),
                true,
            ),
            (format!("{a}^2"), "depends only on", on.clone(), true),
            (format!("{a}{b}"), "depends only on", on.clone(), false),
            (format!("{a}{b}"), "depends only on", both.clone(), true),
            (a.to_string(), "depends only on", both, false),
            (format!("{a}^3"), "depends essentially on", on.clone(), true),
            (
                format!("{b}^3"),
                "depends essentially on",
                on.clone(),
                false,
            ),
            (
                format!("1000{b} + {a}"),
                "depends essentially on",
                on,
                false,
            ),
            (
                format!("{a}^2 + {b}"),
                "separates into",
                format!("groups = [[\"{a}\"], [\"{b}\"]]"),
                true,
            ),
            (
                format!("{a}^2{b} + {a}^2"),
                "separates into",
                format!("groups = [[\"{a}\"], [\"{b}\"]]"),
                true,
            ),
            (
                format!("{a}^2{b} + {a}"),
                "separates into",
                format!("groups = [[\"{a}\"], [\"{b}\"]]"),
                false,
            ),
            (
                format!("3{a}^2{b}"),
                "proportional to",
                format!("to = '{a}^2'"),
                true,
            ),
            (
                format!("3{a}^2{b}"),
                "proportional to",
                format!("to = '{a}'"),
                false,
            ),
            (
                format!("{a} + 1"),
                "proportional to",
                format!("to = '{a}'"),
                false,
            ),
            (
                format!("({a} + {b})^2"),
                "equals",
                format!("to = '{a}^2 + 2{a}{b} + {b}^2'"),
                true,
            ),
            (
                format!("({a} + {b})^2"),
                "equals",
                format!("to = '{a}^2 + {a}{b} + {b}^2'"),
                false,
            ),
            (format!("{a} + 7"), "equals", format!("to = '{a}'"), false),
            (
                format!("100{b}^2 + {b}^2"),
                "close to",
                format!("to = '100{b}^2'"),
                true,
            ),
            (
                format!("100{b}^2"),
                "close to",
                format!("to = '-100{b}^2'"),
                false,
            ),
            (
                format!("2{b}^2"),
                "close to",
                format!("to = '{b}^2'"),
                false,
            ),
            (
                format!("{b}^2"),
                "small compared with",
                format!("to = '100{b}^2'"),
                true,
            ),
            (
                format!("-{b}^2"),
                "small compared with",
                format!("to = '2{b}^2'"),
                false,
            ),
            (
                format!("100{b}^2"),
                "small compared with",
                format!("to = '{b}^2'"),
                false,
            ),
            (
                format!(r"\frac{{{a}}}{{{b} + 5}}"),
                "explicit",
                String::new(),
                true,
            ),
            (
                format!(r"\sqrt{{{a}^2 + 1}}"),
                "explicit",
                String::new(),
                false,
            ),
        ] {
            family.say(&of, predicate, &arguments, truth);
        }
    }
    for (of, to, truth) in [
        ("x", "xz", true),
        ("x", "y", false),
        ("x^2", "x", false),
        ("x + 2x", "x", true),
        ("x + y", "x", false),
        ("x + y", "y", false),
        ("x", "x + y", false),
        ("x + r", "x", false),
        (r"\frac{x}{y}", "x", false),
        (r"\frac{xy}{y}", "x", true),
        ("x + x^2", "x", false),
        ("r + s", "u", true),
        ("rx + sx", "x", true),
        ("rx + sy", "x", false),
        (r"\sqrt{x^2}", "x", true),
        (r"\sqrt{x^2 + y^2}", "x", false),
        (r"x^2 - y^2", "x^2", false),
        (r"\frac{x + y}{z}", "x", false),
        (r"(x + y)^2", "x^2", false),
        (r"x\cos r", "x", true),
        (r"x\cos x", "x", false),
    ] {
        family.say(of, "measured like", &format!("to = '{to}'"), truth);
    }
    for (of, letter, goal, to, truth) in [
        (r"\frac{1}{x}", "x", "0", r"\infty", true),
        (r"\frac{1}{r}", "r", "0", r"\infty", false),
        (r"\frac{1}{r^2}", "r", "0", r"\infty", true),
        (r"\frac{s}{r^2}", "r", "0", r"\infty", false),
        (r"\frac{1}{r}", "r", r"\infty", "0", true),
        (r"\frac{rs + 1}{r}", "r", r"\infty", "s", true),
        (r"\frac{rs + 1}{r}", "r", r"\infty", "0", false),
        (r"\frac{rs + 1}{r + x}", "r", "0", r"\frac{1}{x}", true),
        (r"\frac{rs + 1}{r + x}", "r", "0", r"x", false),
        (r"\frac{1}{rs + 1}", "r", r"\infty", "1", false),
        (r"\frac{1}{u}", "u", "0", r"\infty", true),
        (r"u^2 + s", "u", "0", "s", true),
        (r"u^2 + s", "u", "0", "r", false),
        (r"sx", "x", r"\infty", r"\infty", false),
        (r"yx", "x", r"\infty", r"\infty", true),
        (r"wx", "x", r"\infty", r"\infty", true),
        (r"vx", "x", r"\infty", r"\infty", false),
        (r"(s^2 + 1)x", "x", r"\infty", r"\infty", true),
        (r"-x", "x", r"\infty", r"\infty", false),
        (r"\frac{n}{n + 1}", "n", r"\infty", "1", true),
    ] {
        let arguments = format!("in = \"{letter}\"\nas = '{goal}'\nto = '{to}'");
        family.say(of, "tends to", &arguments, truth);
    }
    assert!(family.all.len() >= 200);
    family.decides(0.85, 0.7);
}
