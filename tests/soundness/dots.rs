//! Dots and primes: what is defined through the time is a function of it, a prime is the derivative by
//! the argument. Claims about random polynomials; the derivative is taken here, by its own rule.

use crate::common::audit;
use rederive::check::Options;
use rederive::diagnostic::DiagnosticKind;
use rederive::document::{Document, VerdictWord};
use std::collections::BTreeMap;

/// A reproducible sequence (Knuth's MMIX generator).
pub struct Draw(u64);

impl Draw {
    pub fn new(seed: u64) -> Self {
        let mut draw = Draw(seed);
        draw.below(7);
        draw
    }

    pub fn below(&mut self, n: usize) -> usize {
        self.0 = self
            .0
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 33) as usize % n
    }

    pub fn coin(&mut self) -> bool {
        self.below(2) == 0
    }
}

/// How often a verdict was what it must be, and how often it was none.
#[derive(Debug, Default)]
pub struct Tally {
    pub right: usize,
    pub open: usize,
    pub wrong: Vec<String>,
}

impl Tally {
    /// Counts a verdict on a claim that is true or false.
    pub fn count(&mut self, claim: &str, truth: bool, word: VerdictWord) {
        use VerdictWord::{Definition, Holds, HoldsGiven, Loose, Misprint, Recalled, Refuted};
        let said = match word {
            Holds | HoldsGiven => Some(true),
            Refuted | Misprint | Loose => Some(false),
            Definition | Recalled => {
                self.wrong.push(format!("{claim}: {word}"));
                return;
            }
            VerdictWord::Undecided => None,
        };
        match said {
            None => self.open += 1,
            Some(said) if said == truth => self.right += 1,
            Some(_) => self.wrong.push(format!("{claim} is {truth}: {word}")),
        }
    }

    pub fn all(&self) -> usize {
        self.right + self.open + self.wrong.len()
    }
}

/// Verdicts on claims that stand in fences of their own after a preamble, in their order.
pub fn verdicts(preamble: &str, claims: &[String]) -> Vec<VerdictWord> {
    let mut text = preamble.to_string();
    for (k, claim) in claims.iter().enumerate() {
        text += &format!("\n```math claim{k} claim\n{claim}\n```\n");
    }
    let options = Options {
        repair: false,
        ..Options::default()
    };
    let audit = audit(&text, options).unwrap_or_else(|r| panic!("{r}"));
    (0..claims.len())
        .map(|k| {
            let equation = audit.model.equation(&format!("claim{k}")).expect("a claim");
            let outcome = audit.outcomes_of(equation).next().expect("a link");
            outcome.verdict.word()
        })
        .collect()
}

/// The letters of the polynomials: two constants, the time, the argument of functions, and a process
/// with its first two derivatives.
const LETTERS: [&str; 7] = ["a", "b", "t", "u", "y", r"\dot{y}", r"\ddot{y}"];
const T: usize = 2;
const U: usize = 3;
const Y: usize = 4;

/// Exponents and coefficients.
#[derive(Clone, Debug, Default, PartialEq)]
struct Sum(BTreeMap<[u32; 7], i64>);

impl Sum {
    fn random(draw: &mut Draw, letters: &[usize]) -> Sum {
        let mut sum = Sum::default();
        for _ in 0..1 + draw.below(3) {
            let mut exponents = [0; 7];
            for letter in letters {
                exponents[*letter] = draw.below(3) as u32;
            }
            sum.add(exponents, 1 + draw.below(4) as i64);
        }
        sum
    }

    fn add(&mut self, exponents: [u32; 7], coefficient: i64) {
        *self.0.entry(exponents).or_default() += coefficient;
        self.0.retain(|_, c| *c != 0);
    }

    fn times(&self, other: &Sum) -> Sum {
        let mut product = Sum::default();
        for (e, c) in &self.0 {
            for (f, d) in &other.0 {
                let mut g = *e;
                (0..7).for_each(|k| g[k] += f[k]);
                product.add(g, c * d);
            }
        }
        product
    }

    fn plus(&self, other: &Sum) -> Sum {
        let mut sum = self.clone();
        other.0.iter().for_each(|(e, c)| sum.add(*e, *c));
        sum
    }

    fn partial(&self, letter: usize) -> Sum {
        let mut sum = Sum::default();
        for (e, c) in &self.0 {
            let mut f = *e;
            if f[letter] > 0 {
                f[letter] -= 1;
                sum.add(f, c * i64::from(e[letter]));
            }
        }
        sum
    }

    /// The total derivative by the time.
    fn rate(&self) -> Sum {
        let mut rate = self.partial(T);
        for k in [Y, Y + 1] {
            let mut letter = [0; 7];
            letter[k + 1] = 1;
            let one = Sum(BTreeMap::from([(letter, 1)]));
            rate = rate.plus(&self.partial(k).times(&one));
        }
        rate
    }

    /// With a multiple of u, or a number, in place of u.
    fn at(&self, factor: i64, power: u32) -> Sum {
        let mut sum = Sum::default();
        for (e, c) in &self.0 {
            let mut f = *e;
            f[U] *= power;
            sum.add(f, c * factor.pow(e[U]));
        }
        sum
    }

    fn latex(&self) -> String {
        let mut text = String::new();
        for (e, c) in &self.0 {
            text += if *c < 0 { " - " } else { " + " };
            text += &c.abs().to_string();
            for (letter, n) in LETTERS.iter().zip(e) {
                match n {
                    0 => {}
                    1 => text += &format!(" {letter}"),
                    n => text += &format!(" {letter}^{n}"),
                }
            }
        }
        match text.strip_prefix(" + ") {
            Some(rest) => rest.to_string(),
            None if text.is_empty() => "0".into(),
            None => text,
        }
    }

    /// The same or, at random, something else.
    fn perhaps_damaged(&self, draw: &mut Draw) -> Sum {
        match draw.below(6) {
            0 => Sum::default(),
            1 => self.plus(self),
            2 => self.plus(&Sum::random(draw, &[0, T])),
            _ => self.clone(),
        }
    }
}

/// Names without a meaning of their own, to be defined.
const NAMES: [&str; 6] = ["x", "z", r"\varphi", r"\psi", "s", "v"];
const FUNCTIONS: [&str; 4] = ["f", "g", "h", "k"];

fn definitions(names: &[&str], sums: &[Sum], argument: &str) -> String {
    let mut text = String::new();
    for (k, (name, sum)) in names.iter().zip(sums).enumerate() {
        let value = sum.latex();
        text += &format!("\n```math define{k} define\n{name}{argument} = {value}\n```\n");
    }
    text
}

const CONSTANTS: &str = "```toml symbols\na = { positive = true }\nb = { }\nu = { }\n";

#[test]
fn what_is_defined_through_the_time_moves() {
    let mut tally = Tally::default();
    for (seed, process) in [(1, true), (2, false), (3, true), (4, false)] {
        let mut draw = Draw::new(seed);
        let letters: &[usize] = if process { &[0, T, Y] } else { &[0, 1, T] };
        let sums: Vec<Sum> = NAMES
            .iter()
            .map(|_| Sum::random(&mut draw, letters))
            .collect();
        let table = match process {
            true => "t = { }\ny = { function_of = 't' }\n```\n",
            false => "t = { }\n```\n",
        };
        let preamble = [CONSTANTS, table, &definitions(&NAMES, &sums, "")].concat();
        let (mut claims, mut truths) = (Vec::new(), Vec::new());
        for _ in 0..60 {
            let (i, j) = (draw.below(6), draw.below(6));
            let (x, z) = (NAMES[i], NAMES[j]);
            let product = sums[i].times(&sums[j]);
            let (left, value) = match draw.below(7) {
                0 | 1 => (format!(r"\dot{{{x}}}"), sums[i].rate()),
                2 => (format!(r"\ddot{{{x}}}"), sums[i].rate().rate()),
                3 => (format!(r"\frac{{d}}{{dt}} {x}"), sums[i].rate()),
                4 => (format!(r"\frac{{d}}{{dt}} ({x} {z})"), product.rate()),
                5 => (
                    format!(r"\dot{{{x}}} {z} + {x} \dot{{{z}}}"),
                    product.rate(),
                ),
                _ => (format!(r"\dot{{{x}}} {z}"), sums[i].rate().times(&sums[j])),
            };
            let said = value.perhaps_damaged(&mut draw);
            claims.push(format!("{left} = {}", said.latex()));
            truths.push(said == value);
        }
        for ((claim, truth), word) in claims.iter().zip(&truths).zip(verdicts(&preamble, &claims)) {
            tally.count(claim, *truth, word);
        }
    }
    assert!(
        tally.wrong.is_empty(),
        "{} of {}: {:#?}",
        tally.wrong.len(),
        tally.all(),
        tally.wrong
    );
    assert_eq!(tally.open, 0, "all are decided");
}

#[test]
fn a_prime_is_the_derivative_by_the_argument() {
    let mut tally = Tally::default();
    for seed in 11..14 {
        let mut draw = Draw::new(seed);
        let sums: Vec<Sum> = FUNCTIONS
            .iter()
            .map(|_| Sum::random(&mut draw, &[0, 1, U]))
            .collect();
        let preamble = [CONSTANTS, "```\n", &definitions(&FUNCTIONS, &sums, "(u)")].concat();
        let (mut claims, mut truths) = (Vec::new(), Vec::new());
        for _ in 0..80 {
            let i = draw.below(4);
            let f = FUNCTIONS[i];
            let first = sums[i].partial(U);
            let second = first.partial(U);
            let (left, value) = match draw.below(8) {
                0 | 1 => (format!("{f}'(u)"), first),
                2 => (format!("{f}''(u)"), second),
                3 => (format!("{f}'(0)"), first.at(0, 0)),
                4 => (format!("{f}'(2u)"), first.at(2, 1)),
                5 => (format!("{f}'(u^2)"), first.at(1, 2)),
                6 => (format!("{f}''(3)"), second.at(3, 0)),
                _ => (format!("{f}'(u) {f}(u)"), first.times(&sums[i])),
            };
            let said = value.perhaps_damaged(&mut draw);
            // What does not depend on the time must not be damaged by it.
            if said.0.keys().any(|e| e[T] > 0) {
                continue;
            }
            claims.push(format!("{left} = {}", said.latex()));
            truths.push(said == value);
        }
        for ((claim, truth), word) in claims.iter().zip(&truths).zip(verdicts(&preamble, &claims)) {
            tally.count(claim, *truth, word);
        }
    }
    assert!(
        tally.wrong.is_empty(),
        "{} of {}: {:#?}",
        tally.wrong.len(),
        tally.all(),
        tally.wrong
    );
    assert_eq!(tally.open, 0, "all are decided");
    assert!(tally.all() >= 200, "{}", tally.all());
}

/// What a text is refused for.
fn refused(text: &str) -> Vec<DiagnosticKind> {
    let document = match Document::parse("test.md", text) {
        Ok(document) => document,
        Err(diagnostics) => return diagnostics.into_iter().map(|d| d.kind).collect(),
    };
    match rederive::audit::Audit::of(&document, Options::default()) {
        Ok(_) => Vec::new(),
        Err(rejection) => rejection.diagnostics.into_iter().map(|d| d.kind).collect(),
    }
}

#[test]
fn a_dot_without_a_time_is_an_error_with_its_place() {
    for claim in [
        r"\dot{a} = 0",
        r"\ddot{b} = b",
        r"\dot{x} = 0",
        r"a\dot{x} + b = b",
        r"\dot{(ab)} = 0",
        r"\frac{\dot{a}}{b} = 0",
    ] {
        let text = format!(
            "{CONSTANTS}```\n```math 1 define\nx = a b^2\n```\n```math 2 claim\n{claim}\n```\n"
        );
        let kinds = refused(&text);
        assert!(
            matches!(kinds[..], [DiagnosticKind::NoTime { .. }]),
            "{claim}: {kinds:?}"
        );
        // With a time a constant stands still.
        let timed = text.replace("u = { }\n", "u = { }\nt = { unit = 's' }\n");
        assert!(refused(&timed).is_empty(), "{claim}: {:?}", refused(&timed));
    }
}

#[test]
fn primes_keep_a_meaning_of_their_own() {
    let table = "```toml symbols\na = { }\ny = { }\nx = { }\n'g'''  = { }\n```\n"
        .replace("'g'''  ", "\"g'\" ");
    let preamble = format!(
        "{table}\n```math 1 define\nf(y) = a y^2\n```\n```math 2 define\ng = a y\n```\n```math 3 define\nx' = 3 a\n```\n"
    );
    let claims: Vec<(&str, VerdictWord)> = vec![
        (r"g' = g' + a - a", VerdictWord::Holds),
        (r"g' = a", VerdictWord::Refuted),
        (r"x' = 3a", VerdictWord::Holds),
        (r"x' = 0", VerdictWord::Refuted),
        (r"f'(y) = 2ay", VerdictWord::Holds),
        (r"f'(y) = 7ay", VerdictWord::Refuted),
        (r"f'(x') = 6a^2", VerdictWord::Holds),
    ];
    let texts: Vec<String> = claims.iter().map(|(c, _)| (*c).to_string()).collect();
    for ((claim, expected), word) in claims.iter().zip(verdicts(&preamble, &texts)) {
        assert_eq!(word, *expected, "{claim}");
    }
    // Without any function a prime makes another letter, which must be declared.
    let text = format!("{preamble}\n```math 4 claim\na = q' + a\n```\n");
    assert!(matches!(
        refused(&text)[..],
        [DiagnosticKind::UndeclaredName { .. }]
    ));
}

#[test]
fn two_letters_for_the_time_are_not_mixed_up() {
    let preamble = "```toml symbols\na = { }\nt = { }\ns = { }\ny = { function_of = 't' }\nw = { function_of = 's' }\n```\n\
        \n```math 1 define\nx = a t y\n```\n```math 2 define\nz = w y\n```\n```math 3 define\nv = s w\n```\n";
    let claims: Vec<(&str, Option<bool>)> = vec![
        (r"\dot{x} = a y + a t \dot{y}", Some(true)),
        (r"\dot{x} = a t \dot{y}", Some(false)),
        (r"\dot{z} = \dot{w} y + w \dot{y}", None),
        (r"\dot{v} = w + s\dot{w}", Some(true)),
        (r"\dot{v} = 0", Some(false)),
        (r"\frac{d}{dt} w = \dot{w}", None),
    ];
    let texts: Vec<String> = claims.iter().map(|(c, _)| (*c).to_string()).collect();
    let mut tally = Tally::default();
    for ((claim, truth), word) in claims.iter().zip(verdicts(preamble, &texts)) {
        match truth {
            Some(truth) => tally.count(claim, *truth, word),
            // Nothing says how one letter depends on the other.
            None => assert!(
                matches!(word, VerdictWord::Undecided | VerdictWord::Refuted),
                "{claim}: {word}"
            ),
        }
    }
    assert!(tally.wrong.is_empty(), "{:#?}", tally.wrong);
}
