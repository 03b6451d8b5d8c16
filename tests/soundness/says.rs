//! Corrections of false claims say something, and verdicts do not depend on what stands before.
//!
//! Families of false claims that definitions, functions, integers and hypotheses make easy to mend in words
//! only. Each correction that is printed is judged apart, by an evaluator in floating point and by the look
//! of it: it is true; each of its edits is needed; it is about letters where the print was; it is no
//! definition said again in other letters; no function's name stands where a number does.

use crate::common::audit;
use crate::generated::random::Random;
use num_traits::ToPrimitive;
use rederive::audit::Audit;
use rederive::check::Options;
use rederive::document::VerdictWord;
use rederive::expr::walk::{children, children_mut};
use rederive::expr::{Display, Expr, ExprKind, Function, Sign};
use rederive::latex;
use rederive::model::Model;
use rederive::model::links::Link;
use rederive::verdict::Verdict;
use std::collections::{BTreeMap, BTreeSet};

type Point = BTreeMap<String, f64>;

/// The value of an expression, definitions inserted; none where this evaluator knows none.
fn value(model: &Model, expr: &Expr, at: &Point, depth: usize) -> Option<f64> {
    let of = |e: &Expr| value(model, e, at, depth);
    let found = match &expr.kind {
        ExprKind::Number(n) => n.to_f64()?,
        ExprKind::Name(_) => {
            let name = latex::write_expr(expr);
            match at.get(&name) {
                Some(value) => *value,
                None => defined(model, expr, &[], at, depth)?,
            }
        }
        ExprKind::Apply { arguments, .. } => defined(model, expr, arguments, at, depth)?,
        ExprKind::Group { inner, .. } => of(inner)?,
        ExprKind::Sum(terms) => {
            let mut sum = 0.0;
            for (sign, term) in terms {
                sum += match sign {
                    Sign::Plus => of(term)?,
                    Sign::Minus => -of(term)?,
                };
            }
            sum
        }
        ExprKind::Product(factors) => {
            let mut product = 1.0;
            for factor in factors {
                product *= of(factor)?;
            }
            product
        }
        ExprKind::Quotient {
            numerator,
            denominator,
            ..
        } => of(numerator)? / of(denominator)?,
        ExprKind::Power { base, exponent } => of(base)?.powf(of(exponent)?),
        ExprKind::Call { function, argument } => {
            let x = of(argument)?;
            match function {
                Function::Cosine => x.cos(),
                Function::Sine => x.sin(),
                Function::Tangent => x.tan(),
                Function::HyperbolicCosine => x.cosh(),
                Function::HyperbolicSine => x.sinh(),
                Function::Exponential => x.exp(),
                Function::Logarithm => x.ln(),
                Function::SquareRoot => x.sqrt(),
                Function::Absolute => x.abs(),
                _ => return None,
            }
        }
        ExprKind::Integral {
            limits: Some((from, to)),
            body,
            variable,
        } => {
            let (from, to) = (of(from)?, of(to)?);
            let name = latex::canonical(variable);
            const STEPS: i32 = 400;
            let mut sum = 0.0;
            for k in 0..=STEPS {
                let mut inside = at.clone();
                let x = from + (to - from) * f64::from(k) / f64::from(STEPS);
                inside.insert(name.clone(), x);
                let weight = match k {
                    0 | STEPS => 1.0,
                    k if k % 2 == 1 => 4.0,
                    _ => 2.0,
                };
                sum += weight * value(model, body, &inside, depth)?;
            }
            sum * (to - from) / f64::from(STEPS) / 3.0
        }
        _ => return None,
    };
    found.is_finite().then_some(found)
}

/// The value of a name or a function by its definition.
fn defined(
    model: &Model,
    expr: &Expr,
    arguments: &[Expr],
    at: &Point,
    depth: usize,
) -> Option<f64> {
    if depth == 0 {
        return None;
    }
    let (ExprKind::Name(name) | ExprKind::Apply { function: name, .. }) = &expr.kind else {
        return None;
    };
    let mut all = model.definitions.iter();
    let definition = all.find(|d| d.name == *name && d.arguments.len() == arguments.len())?;
    let body = (definition.place).find(&model.equations[definition.equation].display)?;
    let mut inside = at.clone();
    for (parameter, argument) in definition.arguments.iter().zip(arguments) {
        let argument = value(model, argument, at, depth)?;
        inside.insert(latex::canonical(parameter), argument);
    }
    value(model, body, &inside, depth - 1)
}

fn sides<'d>(display: &'d Display, link: &Link) -> [&'d Expr; 2] {
    [link.left, link.right].map(|place| place.find(display).expect("a side"))
}

/// Whether the sides agree at all points at which both have values; none where there are none.
fn agrees(model: &Model, sides: [&Expr; 2], points: &[Point]) -> Option<bool> {
    let mut seen = 0;
    for at in points {
        let [left, right] = sides.map(|e| value(model, e, at, 6));
        let (Some(left), Some(right)) = (left, right) else {
            continue;
        };
        seen += 1;
        if (left - right).abs() > 1e-7 * (1.0 + left.abs() + right.abs()) {
            return Some(false);
        }
    }
    (seen > 0).then_some(true)
}

/// The smallest places at which two trees differ.
fn differences(one: &Expr, other: &Expr, path: &mut Vec<usize>, found: &mut Vec<Vec<usize>>) {
    if latex::write_expr(one) == latex::write_expr(other) {
        return;
    }
    let (parts, others) = (children(one), children(other));
    let head = |e: &Expr| {
        let mut empty = e.clone();
        for part in children_mut(&mut empty) {
            part.kind = ExprKind::Infinity;
        }
        latex::write_expr(&empty)
    };
    if parts.is_empty() || parts.len() != others.len() || head(one) != head(other) {
        found.push(path.clone());
        return;
    }
    for (k, (part, other)) in parts.into_iter().zip(others).enumerate() {
        path.push(k);
        differences(part, other, path, found);
        path.pop();
    }
}

fn part<'e>(expr: &'e Expr, path: &[usize]) -> &'e Expr {
    path.iter().fold(expr, |e, step| children(e)[*step])
}

fn put(expr: &mut Expr, path: &[usize], value: &Expr) {
    match path.split_first() {
        None => *expr = value.clone(),
        Some((step, rest)) => put(
            children_mut(expr)
                .into_iter()
                .nth(*step)
                .expect("the same shape"),
            rest,
            value,
        ),
    }
}

/// The letters of an expression that stand for values: no constants.
fn letters(model: &Model, expr: &Expr, found: &mut BTreeSet<String>) {
    if let ExprKind::Name(name) = &expr.kind {
        let constant = model.notation.iter().any(|n| n.name == *name);
        if !constant {
            found.insert(latex::canonical(name));
        }
    }
    for child in children(expr) {
        letters(model, child, found);
    }
}

/// A monomial with its definitions inserted: its number and the exponents of its letters.
fn monomial(model: &Model, expr: &Expr, depth: usize) -> Option<(f64, BTreeMap<String, i64>)> {
    let one = (1.0, BTreeMap::new());
    let times = |a: (f64, BTreeMap<String, i64>), b: (f64, BTreeMap<String, i64>), e: i64| {
        let mut powers = a.1;
        for (letter, n) in b.1 {
            *powers.entry(letter).or_insert(0) += e * n;
        }
        powers.retain(|_, n| *n != 0);
        (a.0 * b.0.powi(i32::try_from(e).expect("small")), powers)
    };
    match &expr.kind {
        ExprKind::Number(n) => Some((n.to_f64()?, BTreeMap::new())),
        ExprKind::Name(name) => {
            let definition = (model.definitions.iter())
                .find(|d| d.name == *name && d.arguments.is_empty() && depth > 0);
            match definition {
                Some(d) => {
                    let body = d.place.find(&model.equations[d.equation].display)?;
                    monomial(model, body, depth - 1)
                }
                None => Some((1.0, BTreeMap::from([(latex::canonical(name), 1)]))),
            }
        }
        ExprKind::Group { inner, .. } | ExprKind::Transpose(inner) => monomial(model, inner, depth),
        ExprKind::Sum(terms) => match terms.as_slice() {
            [(Sign::Plus, only)] => monomial(model, only, depth),
            [(Sign::Minus, only)] => {
                let (number, letters) = monomial(model, only, depth)?;
                Some((-number, letters))
            }
            _ => None,
        },
        ExprKind::Product(factors) => {
            let mut all = one;
            for factor in factors {
                all = times(all, monomial(model, factor, depth)?, 1);
            }
            Some(all)
        }
        ExprKind::Quotient {
            numerator,
            denominator,
            ..
        } => Some(times(
            monomial(model, numerator, depth)?,
            monomial(model, denominator, depth)?,
            -1,
        )),
        ExprKind::Power { base, exponent } => match &monomial(model, exponent, depth)? {
            (n, letters) if letters.is_empty() && n.fract() == 0.0 && n.abs() < 20.0 => {
                Some(times(one, monomial(model, base, depth)?, *n as i64))
            }
            _ => None,
        },
        _ => None,
    }
}

/// What is wrong with a correction.
fn fault(
    model: &Model,
    printed: &Display,
    corrected: &Display,
    link: &Link,
    points: &[Point],
) -> Option<&'static str> {
    let (before, after) = (sides(printed, link), sides(corrected, link));
    if agrees(model, after, points) == Some(false) {
        return Some("false");
    }
    let functions: Vec<String> = (model.definitions.iter())
        .filter(|d| !d.arguments.is_empty())
        .map(|d| latex::canonical(&d.name))
        .collect();
    let mut names = [BTreeSet::new(), BTreeSet::new()];
    for k in 0..2 {
        letters(model, before[k], &mut names[0]);
        letters(model, after[k], &mut names[1]);
    }
    if names[1].iter().any(|name| functions.contains(name)) {
        return Some("a function's name as a number");
    }
    if !names[0].is_empty() && names[1].is_empty() {
        return Some("about nothing");
    }
    // Each edit is needed.
    let mut changes = Vec::new();
    for k in 0..2 {
        let mut found = Vec::new();
        differences(before[k], after[k], &mut Vec::new(), &mut found);
        changes.extend(found.into_iter().map(|path| (k, path)));
    }
    if changes.len() > 1 {
        for (k, path) in &changes {
            let mut less = [after[0].clone(), after[1].clone()];
            put(&mut less[*k], path, part(before[*k], path));
            if agrees(model, [&less[0], &less[1]], points) == Some(true) {
                return Some("an edit that is not needed");
            }
        }
    }
    let new_side = (0..2).any(|k| {
        let other = changes
            .iter()
            .any(|(side, path)| *side == k && path.is_empty());
        other && matches!(after[k].kind, ExprKind::Name(_))
    });
    let put_in = names[1].difference(&names[0]).next().is_some();
    if put_in
        && (changes.len() > 1 || new_side)
        && let (Some(left), Some(right)) =
            (monomial(model, after[0], 6), monomial(model, after[1], 6))
        && left == right
    {
        return Some("a definition said again");
    }
    None
}

const HEAD: &str = r"# Letters

```toml symbols
a = { positive = true }
b = { positive = true }
c = { positive = true }
x = { }
y = { }
z = { }
n = { domain = 'integer' }
m = { domain = 'integer' }
'\xi' = { }
```
```toml notation
'\pi' = { constant = 'pi' }
e = { constant = 'e' }
```
```math d1 define
w = \frac{1}{x}
```
```math d2 define
u = 3a + b
```
```math d3 define
k = ab
```
```math d4 define
h(\xi) = \xi^2 + 1
```
```math d5 define
r(\xi) = 2\xi
```
```math d6 define
s(n) = \cos(2\pi n)
```
```math d7 define
v = \begin{cases} x & x \ge y \\ y & x < y \end{cases}
```
";

struct Claims {
    text: String,
    count: usize,
}

impl Claims {
    fn new() -> Self {
        Claims {
            text: HEAD.into(),
            count: 0,
        }
    }

    fn add(&mut self, claim: &str, assume: &[&str]) {
        let k = self.count;
        self.text += &format!("\n```math c{k} claim\n{claim}\n```\n");
        if !assume.is_empty() {
            let all: Vec<String> = assume.iter().map(|a| format!("'{a}'")).collect();
            self.text += &format!("```toml c{k}\nassume = [{}]\n```\n", all.join(", "));
        }
        self.count += 1;
    }

    fn audit(&self, candidates: usize) -> Audit {
        let options = Options {
            candidates,
            ..Options::default()
        };
        audit(&self.text, options).unwrap_or_else(|rejection| panic!("{rejection}\n{}", self.text))
    }
}

fn points(model: &Model, random: &mut Random) -> Vec<Point> {
    let mut all = Vec::new();
    for _ in 0..6 {
        let mut at = Point::new();
        at.insert(r"\pi".into(), std::f64::consts::PI);
        at.insert("e".into(), std::f64::consts::E);
        for symbol in &model.symbols {
            let name = latex::canonical(&symbol.name);
            let value = match name.as_str() {
                "n" | "m" => random.between(-5, 5) as f64,
                "a" | "b" | "c" => 0.3 + 2.0 * random.unit(),
                _ => 3.0 * random.unit() - 1.5,
            };
            at.insert(name, value);
        }
        all.push(at);
    }
    all
}

/// How many claims got a correction, and what is wrong with any.
fn judged(audit: &Audit, random: &mut Random) -> (usize, usize, Vec<String>) {
    let points = points(&audit.model, random);
    let (mut mended, mut decided, mut wrong) = (0, 0, Vec::new());
    for outcome in &audit.outcomes {
        let equation = &audit.model.equations[outcome.equation];
        if !equation.label.starts_with('c') {
            continue;
        }
        let written = latex::write_display(&equation.display);
        match &outcome.verdict {
            Verdict::Holds { .. } => wrong.push(format!("holds: {written}")),
            Verdict::Refuted(_) => decided += 1,
            Verdict::Misprint { correction, .. } => {
                decided += 1;
                mended += 1;
                if correction.definition.is_some() {
                    continue;
                }
                let link = &equation.links[outcome.member - 1];
                let mut all = vec![&correction.display];
                all.extend(correction.others.iter().map(|o| &o.display));
                for display in all {
                    // Under hypotheses the points are not theirs.
                    let points = match equation.assume.is_empty() && correction.given.is_none() {
                        true => points.as_slice(),
                        false => &[],
                    };
                    let why = fault(&audit.model, &equation.display, display, link, points);
                    if let Some(why) = why {
                        let text = latex::write_display(display);
                        wrong.push(format!("{why}: {written}  ->  {text}"));
                    }
                }
            }
            _ => {}
        }
    }
    (mended, decided, wrong)
}

fn family(seed: u64, candidates: usize, make: impl Fn(&mut Random, &mut Claims)) -> [usize; 3] {
    let mut random = Random::seeded(seed);
    let mut claims = Claims::new();
    make(&mut random, &mut claims);
    let audit = claims.audit(candidates);
    let (mended, decided, wrong) = judged(&audit, &mut random);
    println!(
        "{} claims, {decided} decided, {mended} mended",
        claims.count
    );
    assert!(wrong.is_empty(), "{} wrong: {wrong:#?}", wrong.len());
    [claims.count, decided, mended]
}

/// Names that are defined by others: a definition said again mends nothing.
#[test]
fn definitions_are_not_said_again() {
    let [all, decided, _] = family(3, 1_500, |random, claims| {
        // Only once: a slip in the definition would explain several.
        claims.add("v = x", &[]);
        for _ in 0..9 {
            let p = random.between(2, 9);
            let q = p + random.between(1, 5);
            claims.add(&format!("x = {p}"), &[]);
            claims.add(&format!("x^{p} = x"), &[]);
            claims.add(&format!("w^{p} = w"), &[]);
            claims.add(&format!("{p}w = x"), &[]);
            claims.add(&format!("w = {p}"), &[]);
            claims.add("y = x", &[]);
            claims.add(&format!("k = {p}a"), &[]);
            claims.add(&format!("u = {p}a"), &[]);
            claims.add(&format!("{p}x = {q}y"), &[]);
            claims.add(&format!("{p}x = {q}x"), &[]);
            claims.add(&format!("x = {p}"), &[&format!("(x - {p})(y - 2) = 0")]);
            claims.add("x = y", &[r"\cosh x = \cosh y"]);
            claims.add("x^{-1} = z", &[]);
            claims.add(&format!("{p}wx = {q}"), &[]);
        }
    });
    assert!(4 * decided >= 3 * all, "{decided} of {all}");
}

/// A function's name stands for no number, and a function of numbers alone is about nothing.
#[test]
fn names_of_functions_are_no_numbers() {
    let [all, decided, _] = family(5, 700, |random, claims| {
        for _ in 0..7 {
            let p = random.between(2, 6);
            let q = random.between(3, 8);
            claims.add("h(x^2) = h(x)", &[]);
            claims.add(&format!("h({p}x) = {p}h(x)"), &[]);
            claims.add(&format!("h(x) + {p} = h(x + y)"), &[]);
            claims.add(&format!("h(x) = {p}"), &[]);
            claims.add(&format!("h({p}) = {q}"), &[]);
            claims.add("h(h(x)) = x", &[]);
            claims.add("r(x) = h(x)", &[]);
            claims.add("r(h(x)) = h(r(x))", &[]);
            claims.add(&format!("r(x) = {q}x"), &[]);
            claims.add(&format!(r"\int_{{-{q}}}^{{-1}} h(a)\, da = {p}"), &[]);
            claims.add(&format!("s(x) = {p}"), &[]);
            claims.add("s(x) = 1", &[]);
        }
    });
    assert!(3 * decided >= 2 * all, "{decided} of {all}");
}

/// What is true of integers and of functions: each edit is needed, and something is said.
#[test]
fn corrections_with_functions_edit_no_more_than_they_must() {
    let [all, decided, mended] = family(7, 600, |random, claims| {
        for _ in 0..4 {
            let odd = 2 * random.between(0, 3) + 1;
            let p = random.between(2, 6);
            let n = match odd {
                1 => String::new(),
                n => n.to_string(),
            };
            claims.add(&format!(r"\cos({n}\pi n + x) = \cos x"), &[]);
            claims.add(&format!(r"\sin(\frac{{{n}\pi n}}{{2}}) = 0"), &[]);
            claims.add(&format!(r"\sin({n}n\pi/2) = 0"), &[]);
            claims.add(&format!(r"\sin({p}x) = {p}\sin x"), &[]);
            claims.add(&format!(r"e^{{{p}x}} = {p}e^x"), &[]);
            claims.add(&format!(r"\ln(a^{p}) = \ln a"), &[]);
            claims.add(r"\cos^2 x + \sin^3 x = 1", &[]);
        }
    });
    assert!(2 * decided >= all, "{decided} of {all}");
    assert!(5 * mended >= all, "{mended} of {all}");
}

const FUNCTIONS: &str = r"# Functions

```toml symbols
a = { positive = true }
b = { positive = true }
x = { }
y = { }
u = { range = '0 < u < 1' }
n = { domain = 'integer' }
```
```toml notation
'\pi' = { constant = 'pi' }
e = { constant = 'e' }
```
";

/// The words of some claims in one document.
fn words(claims: &[String]) -> Vec<VerdictWord> {
    let mut text = FUNCTIONS.to_string();
    for (k, claim) in claims.iter().enumerate() {
        text += &format!("\n```math {k} claim\n{claim}\n```\n");
    }
    let options = Options {
        candidates: 60,
        ..Options::default()
    };
    let audit = audit(&text, options).unwrap_or_else(|rejection| panic!("{rejection}"));
    audit.outcomes.iter().map(|o| o.verdict.word()).collect()
}

/// What a claim is found to be does not depend on how many functions stand before it.
#[test]
fn verdicts_do_not_depend_on_what_stands_before() {
    let mut random = Random::seeded(9);
    let mut claims = Vec::new();
    for _ in 0..4 {
        let p = random.between(2, 9);
        let q = random.between(2, 9);
        claims.push(format!(
            r"\cos(x + {p}y) = \cos x\cos({p}y) - \sin x\sin({p}y)"
        ));
        claims.push(format!(r"\sin({p}x + y) = \sin({p}x) + \sin y"));
        claims.push(format!(r"e^{{{p}x + {q}y}} = e^{{{p}x}}e^{{{q}y}}"));
        claims.push(format!(r"e^{{{p}x}} + e^{{y}} = e^{{{p}x + y}}"));
        claims.push(format!(r"\ln({p}a) = \ln {p} + \ln a"));
        claims.push(format!(r"\sqrt{{{p}a + b}}^2 = {p}a + b"));
        claims.push(format!(r"\sqrt{{{p}a + b}} = \sqrt{{{p}a}} + \sqrt b"));
        claims.push(r"\ln u < 0".into());
        claims.push(r"e^{-u} > 1 - u".into());
        claims.push(format!(r"\sin^2({p}xy) + \cos^2({p}xy) = 1"));
    }
    let forward = words(&claims);
    let reversed: Vec<String> = claims.iter().rev().cloned().collect();
    let mut backward = words(&reversed);
    backward.reverse();
    let mut wrong = Vec::new();
    for (k, claim) in claims.iter().enumerate() {
        let alone = words(std::slice::from_ref(claim))[0];
        if alone != forward[k] || alone != backward[k] {
            wrong.push(format!(
                "{claim}: alone {alone:?}, in order {:?}, in reverse {:?}",
                forward[k], backward[k]
            ));
        }
    }
    let open = forward
        .iter()
        .filter(|w| **w == VerdictWord::Undecided)
        .count();
    println!("{} claims, {open} undecided", claims.len());
    assert!(wrong.is_empty(), "{wrong:#?}");
    assert!(10 * open <= claims.len(), "{open} undecided");
}

#[test]
fn what_holds_of_all_values_is_no_correction() {
    let mut text = r"# M
```toml symbols
a = { positive = true }
t = { }
p = { function_of = 't' }
q = { function_of = 't' }
'\mathbf{u}' = { shape = [2, 1] }
'\mathbf{v}' = { shape = [2, 1] }
'\mathbf{A}' = { shape = [2, 2] }
'\mathbf{S}' = { shape = [2, 2], symmetric = true }
```
```math 1 define
\mathbf{C} = \mathbf{A}\mathbf{S}
```
"
    .to_string();
    let mut claims: Vec<String> = [
        r"\mathbf{u} = \mathbf{v}",
        r"\mathbf{v} = \mathbf{u}",
        r"\mathbf{A}\mathbf{u} = \mathbf{v}",
        r"\dot p = 1",
        r"\dot p = 0",
        r"\dot p + \dot q = 1",
    ]
    .map(String::from)
    .into();
    for n in 2..12 {
        claims.push(format!(r"\frac{{1}}{{{n}}} = 0.{}", 100 / n + 1));
        claims.push(format!(r"0.{} = \frac{{1}}{{{n}}}", 100 / n + 1));
    }
    for (k, claim) in claims.iter().enumerate() {
        text += &format!("\n```math c{k} claim\n{claim}\n```\n");
    }
    let options = Options {
        candidates: 3_000,
        ..Options::default()
    };
    let audit = audit(&text, options).unwrap_or_else(|rejection| panic!("{rejection}"));
    let mut wrong = Vec::new();
    for outcome in &audit.outcomes {
        let equation = &audit.model.equations[outcome.equation];
        match &outcome.verdict {
            Verdict::Refuted(_) | Verdict::Definition { .. } => {}
            Verdict::Misprint { correction, .. } => wrong.push(format!(
                "{} -> {}",
                latex::write_display(&equation.display),
                latex::write_display(&correction.display)
            )),
            other => wrong.push(format!("{} is {}", equation.label, other.word())),
        }
    }
    assert!(wrong.is_empty(), "{wrong:#?}");
}
