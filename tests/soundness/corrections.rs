//! Corrections: each one that is proposed is true at random points by an evaluator of its own, says as
//! much as the print did, and is called the only one only if no other single edit does as well.
//!
//! Three families. Claims that nothing sensible mends, so that whatever is proposed tends to say
//! nothing; identities with one slip, as equations and as residuals `... = 0`, which are to be mended;
//! and true rewritings, which get no correction.

use super::common::audit;
use num_bigint::BigInt;
use num_integer::Integer;
use num_rational::BigRational;
use num_traits::{One, Signed, Zero};
use rederive::audit::Audit;
use rederive::check::Options;
use rederive::check::edit::form::same_reading;
use rederive::check::edit::{Context, singles};
use rederive::document::VerdictWord;
use rederive::expr::walk::children;
use rederive::expr::{Display, Expr, ExprKind, Function, Sign};
use rederive::latex;
use rederive::model::links::{Link, Place};
use rederive::verdict::{Ended, Outcome, Verdict};
use std::collections::BTreeMap;

/// A small generator of random numbers (SplitMix64).
struct Random(u64);

impl Random {
    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        z ^ (z >> 31)
    }

    fn below(&mut self, n: u64) -> u64 {
        self.next() % n
    }

    fn from(&mut self, low: i64, high: i64) -> i64 {
        low + i64::try_from(self.below(u64::try_from(high - low + 1).expect("a range")))
            .expect("small")
    }

    fn pick<'t, T>(&mut self, all: &'t [T]) -> &'t T {
        &all[usize::try_from(self.below(all.len() as u64)).expect("an index")]
    }
}

/// An exact complex number.
#[derive(Clone, Debug, PartialEq)]
struct Complex(BigRational, BigRational);

impl Complex {
    fn real(value: BigRational) -> Self {
        Complex(value, BigRational::zero())
    }

    fn plus(&self, other: &Self) -> Self {
        Complex(&self.0 + &other.0, &self.1 + &other.1)
    }

    fn negative(&self) -> Self {
        Complex(-self.0.clone(), -self.1.clone())
    }

    fn times(&self, other: &Self) -> Self {
        let (a, b, c, d) = (&self.0, &self.1, &other.0, &other.1);
        Complex(a * c - b * d, a * d + b * c)
    }

    fn inverse(&self) -> Option<Self> {
        let modulus = &self.0 * &self.0 + &self.1 * &self.1;
        (!modulus.is_zero()).then(|| Complex(&self.0 / &modulus, -&self.1 / &modulus))
    }

    fn is_zero(&self) -> bool {
        self.0.is_zero() && self.1.is_zero()
    }
}

/// The values of the letters by their names as written.
type Point = BTreeMap<String, Complex>;

/// The value of an expression of arithmetic; none where it has none or is none.
fn value(expr: &Expr, at: &Point) -> Option<Complex> {
    Some(match &expr.kind {
        ExprKind::Number(n) => Complex::real(n.clone()),
        ExprKind::Name(_) => at.get(&latex::write_expr(expr))?.clone(),
        ExprKind::Group { inner, .. } => value(inner, at)?,
        ExprKind::Sum(terms) => {
            let mut sum = Complex::real(BigRational::zero());
            for (sign, term) in terms {
                let term = value(term, at)?;
                sum = sum.plus(&match sign {
                    Sign::Plus => term,
                    Sign::Minus => term.negative(),
                });
            }
            sum
        }
        ExprKind::Product(factors) => {
            let mut product = Complex::real(BigRational::one());
            for factor in factors {
                product = product.times(&value(factor, at)?);
            }
            product
        }
        ExprKind::Quotient {
            numerator,
            denominator,
            ..
        } => value(numerator, at)?.times(&value(denominator, at)?.inverse()?),
        ExprKind::Power { base, exponent } => {
            let exponent = value(exponent, at)?;
            if !exponent.1.is_zero() || !exponent.0.is_integer() || exponent.0.abs() > integer(40) {
                return None;
            }
            let n: i64 = exponent.0.to_integer().to_string().parse().ok()?;
            let base = value(base, at)?;
            let base = if n < 0 { base.inverse()? } else { base };
            let mut power = Complex::real(BigRational::one());
            for _ in 0..n.abs() {
                power = power.times(&base);
            }
            power
        }
        ExprKind::Call {
            function: Function::SquareRoot,
            argument,
        } => {
            let square = value(argument, at)?;
            let root = |n: &BigInt| Some(n.sqrt()).filter(|r| r * r == *n);
            if !square.1.is_zero() || square.0.is_negative() {
                return None;
            }
            let (above, below) = (root(square.0.numer())?, root(square.0.denom())?);
            Complex::real(BigRational::new(above, below))
        }
        _ => return None,
    })
}

fn integer(n: i64) -> BigRational {
    BigRational::from_integer(BigInt::from(n))
}

fn sides<'d>(display: &'d Display, link: &Link) -> [&'d Expr; 2] {
    [link.left, link.right].map(|place| place.find(display).expect("a side"))
}

/// Whether both sides have the same value at all of some points.
fn agrees(display: &Display, link: &Link, points: &[Point]) -> bool {
    let [left, right] = sides(display, link);
    points.iter().all(|at| {
        let values = (value(left, at), value(right, at));
        matches!(values, (Some(left), Some(right)) if left == right)
    })
}

/// The same text for what is the same but for brackets and the order of terms and factors.
fn arranged(expr: &Expr) -> String {
    match &expr.kind {
        ExprKind::Group { inner, .. } => arranged(inner),
        ExprKind::Sum(terms) => {
            let mut all: Vec<String> = terms
                .iter()
                .map(|(sign, term)| format!("{sign:?}{}", arranged(term)))
                .collect();
            all.sort();
            format!("<{}>", all.join(" "))
        }
        ExprKind::Product(factors) => {
            let mut all: Vec<String> = factors.iter().map(arranged).collect();
            all.sort();
            format!("[{}]", all.join(" "))
        }
        _ => {
            let parts: Vec<String> = children(expr).into_iter().map(arranged).collect();
            match parts.is_empty() {
                true => latex::write_expr(expr),
                false => format!(
                    "{:?}({})",
                    std::mem::discriminant(&expr.kind),
                    parts.join(";")
                ),
            }
        }
    }
}

fn names(expr: &Expr, found: &mut Vec<String>) {
    if let ExprKind::Name(_) = expr.kind {
        found.push(latex::write_expr(expr));
    }
    for child in children(expr) {
        names(child, found);
    }
}

fn mentions(expr: &Expr, name: &str) -> bool {
    let mut all = Vec::new();
    names(expr, &mut all);
    all.iter().any(|n| n == name)
}

/// The integer in front, or 1.
fn first_number(expr: &Expr) -> BigInt {
    match &expr.kind {
        ExprKind::Number(n) if n.is_integer() && !n.is_zero() => n.to_integer(),
        ExprKind::Product(factors) => first_number(&factors[0]),
        _ => BigInt::one(),
    }
}

fn is_number(expr: &Expr, n: i64) -> bool {
    matches!(&expr.kind, ExprKind::Number(m) if *m == integer(n))
}

/// How often something stands in an expression that nobody writes: a factor 0 or 1, a term 0, a
/// fraction above 0 or over 1, an exponent 0 or 1, a power of i or of what is 1, a factor of value 1,
/// and, but for the whole of what is said to vanish, a factor or a term of value 0.
fn oddities(expr: &Expr, at: &Point, whole: bool) -> usize {
    let zero = |e: &Expr| value(e, at).is_some_and(|v| v.is_zero());
    let one = |e: &Expr| value(e, at) == Some(Complex::real(BigRational::one()));
    let own = match &expr.kind {
        ExprKind::Sum(terms) if terms.len() > 1 => terms.iter().filter(|(_, t)| zero(t)).count(),
        ExprKind::Product(factors) => {
            let zeros = factors.iter().filter(|f| zero(f)).count();
            factors.iter().filter(|f| one(f)).count() + if whole { 0 } else { zeros }
        }
        ExprKind::Quotient {
            numerator,
            denominator,
            ..
        } => {
            let common = first_number(numerator).gcd(&first_number(denominator));
            usize::from(!whole && zero(numerator))
                + usize::from(one(denominator))
                + usize::from(!common.is_one())
        }
        ExprKind::Power { base, exponent } => {
            let unit = value(base, at).is_some_and(|v| {
                let square = v.times(&v);
                square.times(&square) == Complex::real(BigRational::one())
            });
            usize::from(unit || is_number(exponent, 0) || is_number(exponent, 1))
        }
        _ => 0,
    };
    let inner = |e: &Expr| matches!(e.kind, ExprKind::Group { .. }) || whole;
    let below = children(expr).into_iter().map(|child| {
        let still = whole && inner(expr) && !matches!(expr.kind, ExprKind::Sum(_));
        oddities(child, at, still)
    });
    own + below.sum::<usize>()
}

/// Why a corrected link says less than the printed one, if it does.
fn emptiness(
    printed: &Display,
    corrected: &Display,
    link: &Link,
    at: &Point,
) -> Option<&'static str> {
    let (before, after) = (sides(printed, link), sides(corrected, link));
    if arranged(after[0]) == arranged(after[1]) {
        return Some("both sides are the same");
    }
    for (k, side) in after.iter().enumerate() {
        let other = 1 - k;
        if is_number(before[k], 0) && !matches!(side.kind, ExprKind::Number(_)) {
            return Some("the zero is edited");
        }
        if let ExprKind::Name(_) = side.kind {
            let name = latex::write_expr(side);
            if mentions(after[other], &name) && !mentions(before[other], &name) {
                return Some("it borrows the other side's name");
            }
        }
    }
    let zero = |e: &Expr| value(e, at).is_some_and(|v| v.is_zero());
    let vanishing = before.iter().any(|side| zero(side));
    if after.iter().all(|side| zero(side)) && !vanishing {
        return Some("both sides vanish");
    }
    let odd = |all: [&Expr; 2]| {
        all.iter()
            .map(|e| oddities(e, at, vanishing))
            .sum::<usize>()
    };
    if odd(after) > odd(before) {
        return Some("something that nobody writes");
    }
    for (k, side) in after.iter().enumerate() {
        if let ExprKind::Sum(terms) = &side.kind {
            let opposite = |sign: Sign, text: &str| {
                let mut all = terms.iter();
                all.any(|(s, t)| *s != sign && arranged(t) == text)
            };
            let cancels = terms.iter().any(|(sign, t)| opposite(*sign, &arranged(t)));
            let _ = k;
            if cancels {
                return Some("a term and its opposite");
            }
        }
    }
    None
}

/// A document with one claim after the other, in these letters.
struct Claims {
    text: String,
    labels: Vec<String>,
}

impl Claims {
    fn new(letters: &[&str], define: &[&str]) -> Self {
        let mut text = "# Letters\n\n```toml symbols\n".to_string();
        for letter in letters {
            text += &format!("'{letter}' = {{ positive = true, meaning = \"a letter\" }}\n");
        }
        text += "```\n```toml notation\nj = { constant = \"i\" }\n```\n";
        for (k, definition) in define.iter().enumerate() {
            text += &format!("\n```math d{k} define\n{definition}\n```\n");
        }
        Claims {
            text,
            labels: Vec::new(),
        }
    }

    fn add(&mut self, claim: &str) {
        let label = format!("c{}", self.labels.len());
        self.text += &format!("\n```math {label} claim\n{claim}\n```\n");
        self.labels.push(label);
    }

    fn audit(&self, candidates: usize) -> Audit {
        let options = Options {
            candidates,
            ..Options::default()
        };
        audit(&self.text, options).unwrap_or_else(|rejection| panic!("{rejection}\n{}", self.text))
    }
}

/// Random points of the declared letters, with the defined ones by their definitions.
fn points(
    audit: &Audit,
    random: &mut Random,
    corrections: &BTreeMap<usize, Display>,
) -> Vec<Point> {
    let model = &audit.model;
    let one = |random: &mut Random| {
        let mut at = Point::new();
        at.insert("j".into(), Complex(BigRational::zero(), BigRational::one()));
        for symbol in &model.symbols {
            let number = BigRational::new(random.from(2, 400).into(), random.from(1, 60).into());
            at.insert(latex::canonical(&symbol.name), Complex::real(number));
        }
        for _ in 0..4 {
            for definition in &model.definitions {
                let equation = &model.equations[definition.equation];
                let display = corrections
                    .get(&definition.equation)
                    .unwrap_or(&equation.display);
                let body = definition.place.find(display).and_then(|e| value(e, &at));
                if let Some(body) = body {
                    at.insert(latex::canonical(&definition.name), body);
                }
            }
        }
        at
    };
    (0..3).map(|_| one(random)).collect()
}

#[derive(Default, Debug)]
struct Counts {
    claims: usize,
    misprints: usize,
    refuted: usize,
    proposals: usize,
    wrong: Vec<String>,
}

fn written(display: &Display, link: &Link) -> String {
    sides(display, link).map(latex::write_expr).join(" = ")
}

/// Judges everything that is proposed for the claims of a document.
fn judge(audit: &Audit, random: &mut Random, counts: &mut Counts) {
    let context = Context::of(&audit.model);
    for outcome in &audit.outcomes {
        let equation = &audit.model.equations[outcome.equation];
        if !equation.label.starts_with('c') {
            continue;
        }
        counts.claims += 1;
        let link = &equation.links[outcome.member - 1];
        let correction = match &outcome.verdict {
            Verdict::Misprint { correction, .. } => correction,
            Verdict::Refuted(_) => {
                counts.refuted += 1;
                continue;
            }
            _ => continue,
        };
        counts.misprints += 1;
        let printed = &equation.display;
        let mut corrections = BTreeMap::new();
        if let Some((definition, display)) = &correction.definition {
            corrections.insert(*definition, display.clone());
        }
        let points = points(audit, random, &corrections);
        let mut proposals = vec![&correction.display];
        proposals.extend(correction.others.iter().map(|o| &o.display));
        for proposal in proposals {
            counts.proposals += 1;
            let text = format!(
                "{}  ->  {}",
                written(printed, link),
                written(proposal, link)
            );
            if !agrees(proposal, link, &points) && correction.given.is_none() {
                counts.wrong.push(format!("false: {text}"));
            }
            if correction.definition.is_none()
                && let Some(why) = emptiness(printed, proposal, link, &points[0])
            {
                counts.wrong.push(format!("{why}: {text}"));
            }
        }
        // What is called the only one at its cost is the only single edit at its cost.
        let only = correction.alternatives.is_empty() && correction.preferred.is_none();
        if only && correction.definition.is_none() && correction.edits.len() == 1 {
            let places: [Place; 2] = [link.left, link.right];
            for edit in singles(printed, &places, &context) {
                let mut edited = printed.clone();
                let same_cost = edit.cost == correction.cost && edit.apply(&mut edited);
                if same_cost
                    && agrees(&edited, link, &points)
                    && emptiness(printed, &edited, link, &points[0]).is_none()
                    && !same_reading(&edited, &correction.display, link)
                {
                    counts.wrong.push(format!(
                        "not the only one: {}  ->  {}, {}",
                        written(printed, link),
                        written(&correction.display, link),
                        written(&edited, link)
                    ));
                }
            }
        }
    }
}

/// Claims that nothing sensible mends.
#[test]
fn what_cannot_be_mended_gets_no_empty_correction() {
    let mut random = Random(11);
    let mut counts = Counts::default();
    let define = [
        "u = 3a + b^2",
        "v = \\frac{a}{b + c}",
        "w = a - 2b",
        "k = a + jb",
    ];
    let mut claims = Claims::new(&["a", "b", "c", "x", "y"], &define);
    let letters = ["a", "b", "c", "x", "y", "u", "v", "w"];
    let free = ["x", "y"];
    for round in 0..14 {
        let n = random.from(2, 9);
        let m = n + random.from(1, 4);
        let (p, q) = (*random.pick(&letters), *random.pick(&letters));
        let (f, g) = (*random.pick(&free), *random.pick(&["a", "b", "c"]));
        claims.add(&format!("{p} = 0"));
        claims.add(&format!("{p} = {n}{p}"));
        claims.add(&format!("{n}{p} = {m}{p}"));
        claims.add(&format!("{f} = \\frac{{{n}}}{{a + b}}"));
        claims.add(&format!("{f} = \\frac{{{g}}}{{{g} + {n}}}"));
        claims.add(&format!("{f} = {g}^{n}"));
        claims.add(&format!("{f} = {n}"));
        claims.add(&format!("{f}^2 = {n}{g}{g}_0", g = g).replace(&format!("{g}_0"), "c"));
        claims.add(&format!("{p} = {p} + {n}"));
        claims.add(&format!("{p}^{n} = {p}"));
        claims.add(&format!("{f}{g} = 0"));
        claims.add(&format!("{n}{p} - {m}{p} = 0"));
        claims.add(&format!("j{f} = {f}"));
        claims.add(&format!("j = {n}"));
        claims.add(&format!("{f} + j{g} = {g} + j"));
        claims.add(&format!("{p} = -{p}"));
        if p != q {
            claims.add(&format!("{f} + {g} = {n}"));
        }
        if round % 2 == 0 {
            claims.add(&format!("{f} = {g} + j"));
            claims.add(&format!("\\frac{{{f}}}{{{n}}} = {f}"));
        }
    }
    assert!(claims.labels.len() >= 200);
    let audit = claims.audit(1_500);
    judge(&audit, &mut random, &mut counts);
    println!(
        "{} claims, {} misprints, {} refuted, {} proposals",
        counts.claims, counts.misprints, counts.refuted, counts.proposals
    );
    assert!(
        counts.wrong.is_empty(),
        "{} wrong: {:#?}",
        counts.wrong.len(),
        counts.wrong
    );
    // What has no value at the points looked at is undecided.
    let decided = counts.misprints + counts.refuted;
    assert!(
        decided <= counts.claims && 5 * decided >= 4 * counts.claims,
        "{decided}"
    );
}

/// Identities in the letters a, b, c and some definitions: the left side and the terms of the right.
fn identities(random: &mut Random) -> Vec<(String, Vec<String>)> {
    let n = random.from(2, 7);
    let m = random.from(2, 7);
    let (nn, mm, nm2) = (n * n, m * m, 2 * n * m);
    let all = |left: String, right: &[String]| (left, right.to_vec());
    vec![
        all(
            format!("({n}a + {m}b)^2"),
            &[
                format!("+{nn}a^2"),
                format!("+{nm2}ab"),
                format!("+{mm}b^2"),
            ],
        ),
        all(
            format!("({n}a - {m}c)({n}a + {m}c)"),
            &[format!("+{nn}a^2"), format!("-{mm}c^2")],
        ),
        all(
            format!("(a + {n}b)(c - {m}a)"),
            &[
                "+ac".into(),
                format!("-{m}a^2"),
                format!("+{n}bc"),
                format!("-{}ab", n * m),
            ],
        ),
        all(
            format!("\\frac{{a + {n}b}}{{ab}}"),
            &["+\\frac{1}{b}".into(), format!("+\\frac{{{n}}}{{a}}")],
        ),
        all(
            format!("(a - {n}b)^3"),
            &[
                "+a^3".into(),
                format!("-{}a^2b", 3 * n),
                format!("+{}ab^2", 3 * nn),
                format!("-{}b^3", nn * n),
            ],
        ),
        all(
            format!("\\frac{{{n}}}{{a + b}} + \\frac{{{m}}}{{a - b}}"),
            &[
                format!("+\\frac{{{}a}}{{a^2 - b^2}}", n + m),
                format!("-\\frac{{{}b}}{{a^2 - b^2}}", n - m),
            ],
        ),
        all(
            format!("(a + {n}jb)(a - {n}jb)"),
            &["+a^2".into(), format!("+{nn}b^2")],
        ),
        all(
            format!("{m}u - {n}w"),
            &[
                format!("+{}a", 3 * m - n),
                format!("+{m}b^2"),
                format!("+{}b", 2 * n),
            ],
        ),
        all("v(b + c)".into(), &["+a".into()]),
        all(
            format!("w(a + {n}b)"),
            &[
                "+a^2".into(),
                format!("+{}ab", n - 2),
                format!("-{}b^2", 2 * n),
            ],
        ),
    ]
}

/// One slip in a list of terms: a sign, a number, an exponent, a lost term.
fn slip(terms: &[String], random: &mut Random) -> Vec<String> {
    let mut terms = terms.to_vec();
    let k = usize::try_from(random.below(terms.len() as u64)).expect("small");
    let term = terms[k].clone();
    terms[k] = match random.below(3) {
        0 if terms.len() > 1 => match term.strip_prefix('+') {
            Some(rest) => format!("-{rest}"),
            None => format!("+{}", &term[1..]),
        },
        1 if term.contains("^2") => term.replacen("^2", "^3", 1),
        _ => {
            format!(
                "{}{}{}",
                &term[..1],
                "2",
                match term[1..].starts_with(|c: char| c.is_ascii_digit()) {
                    true => "",
                    false => "",
                }
            ) + &term[1..]
        }
    };
    terms
}

fn joined(terms: &[String]) -> String {
    let text = terms.join(" ").replace("+-", "-").replace("--", "+");
    text.strip_prefix('+').unwrap_or(&text).to_string()
}

/// With all signs turned.
fn turned(terms: &[String]) -> Vec<String> {
    let turn = |t: &String| match t.strip_prefix('+') {
        Some(rest) => format!("-{rest}"),
        None => format!("+{}", &t[1..]),
    };
    terms.iter().map(turn).collect()
}

const DEFINITIONS: [&str; 3] = ["u = 3a + b^2", "v = \\frac{a}{b + c}", "w = a - 2b"];

fn intended(outcome: &Outcome, truth: &Display, link: &Link) -> bool {
    match &outcome.verdict {
        Verdict::Misprint { correction, .. } => {
            let others = correction.others.iter().map(|o| &o.display);
            let mut all = std::iter::once(&correction.display).chain(others);
            all.any(|display| same_reading(display, truth, link))
        }
        _ => false,
    }
}

fn slips(residual: bool, seed: u64, rounds: usize) {
    let mut random = Random(seed);
    let mut counts = Counts::default();
    let (mut mended, mut all, mut lost) = (0, 0, Vec::new());
    for _ in 0..rounds {
        let mut claims = Claims::new(&["a", "b", "c"], &DEFINITIONS);
        for (left, terms) in identities(&mut random) {
            let damaged = slip(&terms, &mut random);
            for terms in [&terms, &damaged] {
                claims.add(&match residual {
                    true => format!("{left} {} = 0", turned(terms).join(" ").replace("--", "+")),
                    false => format!("{left} = {}", joined(terms)),
                });
            }
        }
        let audit = claims.audit(6_000);
        judge(&audit, &mut random, &mut counts);
        for pair in claims.labels.chunks(2) {
            let outcomes = [&pair[0], &pair[1]].map(|label| {
                let equation = audit.model.equation(label).expect("the claim");
                audit.outcomes_of(equation).next().expect("its link")
            });
            let truth = &audit.model.equations[outcomes[0].equation];
            let link = &audit.model.equations[outcomes[1].equation].links[0];
            assert!(
                matches!(
                    outcomes[0].verdict.word(),
                    VerdictWord::Holds | VerdictWord::HoldsGiven
                ),
                "{}",
                written(&truth.display, link)
            );
            if !matches!(
                outcomes[1].verdict.word(),
                VerdictWord::Misprint | VerdictWord::Refuted
            ) {
                continue;
            }
            all += 1;
            match intended(outcomes[1], &truth.display, link) {
                true => mended += 1,
                false => lost.push(written(
                    &audit.model.equations[outcomes[1].equation].display,
                    link,
                )),
            }
        }
    }
    println!(
        "{all} slips, {mended} mended, {} proposals\n{lost:#?}",
        counts.proposals
    );
    assert!(
        counts.wrong.is_empty(),
        "{} wrong: {:#?}",
        counts.wrong.len(),
        counts.wrong
    );
    assert!(
        all >= 90 * rounds / 10 && 10 * mended >= 9 * all,
        "{mended} of {all}: {lost:#?}"
    );
}

#[test]
fn slips_in_identities_are_mended() {
    slips(false, 5, 10);
}

#[test]
fn slips_in_residuals_are_mended() {
    slips(true, 6, 11);
}

/// A slip in a definition behind several residuals is found there.
#[test]
fn slips_in_definitions_behind_residuals_are_found() {
    let mut random = Random(8);
    let (mut found, mut all) = (0, 0);
    for _ in 0..20 {
        let n = random.from(2, 9);
        let m = *random.pick(&[n + 1, n - 1, 2 * n, 10 * n]);
        let definition = format!("s = {n}a + b^2");
        let mut claims = Claims::new(&["a", "b", "c"], &[&definition]);
        claims.add(&format!("s - {m}a - b^2 = 0"));
        claims.add(&format!("(s - b^2)c - {m}ac = 0"));
        claims.add(&format!("(s - {m}a)^2 - b^4 = 0"));
        let audit = claims.audit(6_000);
        let mut counts = Counts::default();
        judge(&audit, &mut random, &mut counts);
        assert!(counts.wrong.is_empty(), "{:#?}", counts.wrong);
        for outcome in audit.outcomes.iter().skip(1) {
            all += 1;
            if let Verdict::Misprint { correction, .. } = &outcome.verdict {
                found += usize::from(correction.definition.is_some());
            }
        }
    }
    assert!(10 * found >= 9 * all, "{found} of {all}");
}

/// The rows as they were first seen.
#[test]
fn the_first_examples() {
    let mut claims = Claims::new(&["a", "b", "x", "y"], &[]);
    for claim in [
        "x = 0",
        "a = 2a",
        "y = 1/(a + b)",
        "j = 1",
        "2a = 3a",
        "(a + b)^2 - a^2 + 2ab - b^2 = 0",
    ] {
        claims.add(claim);
    }
    let audit = claims.audit(100_000);
    let mut counts = Counts::default();
    judge(&audit, &mut Random(3), &mut counts);
    assert!(counts.wrong.is_empty(), "{:#?}", counts.wrong);
    let last = audit.outcomes.last().expect("an outcome");
    let Verdict::Misprint { correction, .. } = &last.verdict else {
        panic!("{:?}", last.verdict.word());
    };
    assert_eq!(correction.edits.len(), 1);
    assert!(correction.edits[0].corrected.contains("- 2ab"));
}

/// Another end is another statement.
#[test]
fn the_end_of_a_limit_is_not_edited() {
    let mut claims = Claims::new(
        &["a", "b", "x"],
        &["f = \\frac{a}{a + x}", "g = \\frac{x^2}{b + x}"],
    );
    let mut random = Random(4);
    for _ in 0..20 {
        let (n, m) = (random.from(2, 9), random.from(2, 9));
        let end = *random.pick(&["0", "\\infty"]);
        let wrong = match end {
            "0" => ["0", "\\infty"],
            _ => ["1", "0"],
        };
        claims.add(&format!("x \\to {end}, \\quad f \\to {}", wrong[0]));
        claims.add(&format!(
            "x \\to {end}, \\quad {n}g + {m} \\to {}",
            wrong[1]
        ));
    }
    for outcome in &claims.audit(1_000).outcomes {
        let found = matches!(outcome.verdict, Verdict::Misprint { .. });
        assert!(!found, "{outcome:?}");
    }
}

/// A false sum of so many terms.
fn long_sum(terms: usize) -> Claims {
    let mut random = Random(9);
    let mut claims = Claims::new(&["a", "b", "c", "d"], &[]);
    let mut sum = String::new();
    for k in 0..terms {
        let powers = ["a", "b", "c", "d"].map(|letter| match random.below(4) {
            0 => String::new(),
            n => format!("{letter}^{}", n + 1),
        });
        let sign = *random.pick(&["+", "-"]);
        let sign = if k == 0 { "" } else { sign };
        sum += &format!("{sign} {}{} ", random.from(2, 99), powers.concat());
    }
    claims.add(&format!("{sum} = (a + b + c + d)^3"));
    claims
}

/// The budget is work: it ends the search in a long sum, after the same candidates on any number of
/// threads, and says after how many of how many.
#[test]
fn a_search_ends_with_its_work() {
    let searched = |threads: usize, work: u64| {
        let options = Options {
            work,
            threads,
            ..Options::default()
        };
        let audit = audit(&long_sum(60).text, options).expect("an audit");
        let Verdict::Refuted(refutation) = &audit.outcomes[0].verdict else {
            panic!("a correction of a sum that has none");
        };
        refutation.searched.expect("how far it was looked for")
    };
    let one = searched(1, 400_000);
    assert_eq!(one.ended, Some(Ended::Work));
    assert!(one.tried < one.of && one.tried > 100, "{one:?}");
    assert_eq!(one, searched(2, 400_000));
    assert_eq!(one, searched(3, 400_000));
    assert!(searched(1, 800_000).tried > one.tried);
}

/// A quotient with cosines was multiplied out for each candidate.
#[test]
fn functions_are_not_multiplied_out_for_each_candidate() {
    let define = ["p = 8a + 3b\\cos(x - y)", "q = 2b + 3a\\cos(x - y)"];
    let mut claims = Claims::new(&["a", "b", "x", "y"], &define);
    claims.add("b = \\frac{2q - 3\\cos(x - y)p}{16 - 9\\cos^2(x - y)}");
    let audit = claims.audit(20_000);
    let last = audit.outcomes.last().expect("an outcome");
    let Verdict::Misprint { correction, .. } = &last.verdict else {
        panic!("{:?}", last.verdict.word());
    };
    assert_eq!(correction.edits[0].corrected, "8q");
}
