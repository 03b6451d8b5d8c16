//! Templates: each makes claims of one kind whose truth is known, by construction or by the
//! independent evaluator. A claim is a piece of a document with a label of its own.

use super::random::Random;
use super::term::Term;
use super::truth;

/// What is known of a claim.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Truth {
    /// True for all admissible values.
    True,
    /// False for some admissible values.
    False,
    /// False in general, true under the hypothesis that the document gives.
    Given,
    /// Without a value, or about nothing: it must not hold.
    Meaningless,
    /// True; but as nothing in the document says why, it may be left undecided.
    Unforced,
}

/// A claim with what it needs around it.
#[derive(Clone, Debug)]
pub struct Claim {
    /// Its label.
    pub label: String,
    /// Its fences, and those of its definitions.
    pub text: String,
    /// What it says, for people.
    pub shown: String,
    /// What is known of each of its links.
    pub truth: Vec<Truth>,
    /// Its sides, where it is an equation between terms in the letters of [`truth::LETTERS`].
    pub sides: Option<(Term, Term)>,
    /// Declarations of its own; then it stands alone in its document.
    pub header: Option<String>,
    /// Whether its last link alone is meant; those before it say where.
    pub last: bool,
}

/// How much of a template has to be decided.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// Rational functions, and formulas of tables: all.
    Rational,
    /// Elementary functions: nine tenths.
    Functions,
    /// As much as there was.
    Other,
}

/// A kind of claims.
pub struct Template {
    /// `family/kind`.
    pub name: &'static str,
    pub kind: Kind,
    /// The declarations that its claims share.
    pub header: &'static str,
    /// A claim with this label.
    pub make: fn(&mut Random, &str) -> Claim,
}

/// The letters of [`truth::LETTERS`] but for the integer and the complex ones.
pub const REALS: &str = r#"```toml symbols
a = { positive = true }
b = { positive = true }
c = { positive = true }
g = { positive = true }
'\alpha' = { positive = true }
'\beta' = { positive = true }
x = { }
y = { }
z = { }
s = { }
'\xi' = { }
p = { }
```
```toml notation
e = { constant = "e" }
j = { constant = "i" }
'\pi' = { constant = "pi" }
```
"#;

/// The same letters with reference values.
pub const VALUES: &str = r#"```toml symbols
a = { positive = true, value = "2" }
b = { positive = true, value = "3" }
c = { positive = true, value = "1/2" }
g = { positive = true, value = "7" }
'\alpha' = { positive = true, value = "5/3" }
'\beta' = { positive = true, value = "11" }
x = { value = "5" }
y = { value = "-3" }
z = { value = "1/3" }
s = { value = "0" }
'\xi' = { value = "-1/7" }
p = { value = "-2" }
```
```toml notation
e = { constant = "e" }
j = { constant = "i" }
'\pi' = { constant = "pi" }
```
"#;

/// All of them, with their domains.
pub const DOMAINS: &str = r#"```toml symbols
a = { positive = true }
b = { positive = true }
c = { positive = true }
g = { positive = true }
x = { domain = "real" }
y = { }
z = { }
s = { domain = "real" }
p = { domain = "real", value = "-2" }
n = { domain = "integer" }
m = { domain = "integer" }
u = { domain = "complex" }
w = { domain = "complex" }
```
```toml notation
e = { constant = "e" }
j = { constant = "i" }
'\pi' = { constant = "pi" }
```
"#;

impl Claim {
    /// A claim of one link in LaTeX.
    pub fn of(label: &str, latex: &str, truth: Truth) -> Claim {
        Claim {
            label: label.into(),
            text: format!("```math {label} claim\n{latex}\n```\n"),
            shown: latex.into(),
            truth: vec![truth],
            sides: None,
            header: None,
            last: false,
        }
    }

    /// An equation between two terms, of which it is known whether it is true.
    pub fn equation(label: &str, left: &Term, right: &Term, holds: bool) -> Claim {
        let truth = if holds { Truth::True } else { Truth::False };
        let latex = format!("{} = {}", left.latex(), right.latex());
        Claim {
            sides: Some((left.clone(), right.clone())),
            ..Claim::of(label, &latex, truth)
        }
    }

    /// The same behind other fences, such as definitions.
    #[must_use]
    pub fn after(mut self, fences: &str) -> Claim {
        self.text = format!("{fences}{}", self.text);
        self.shown = format!("{}; {}", one_line(fences), self.shown);
        self
    }

    /// With settings such as `assume = [...]`.
    #[must_use]
    pub fn set(mut self, settings: &str) -> Claim {
        self.text = format!("{}```toml {}\n{settings}\n```\n", self.text, self.label);
        self.shown = format!("{}   [{settings}]", self.shown);
        self
    }

    /// Of which the last link is meant.
    #[must_use]
    pub fn last_link(mut self) -> Claim {
        self.last = true;
        self
    }

    /// In a document of its own with these declarations.
    #[must_use]
    pub fn alone(mut self, header: &str) -> Claim {
        self.header = Some(header.into());
        self
    }

    /// A statement about a quantity, in the words of the table of predicates.
    pub fn statement(label: &str, settings: &str, truth: Truth) -> Claim {
        Claim {
            label: label.into(),
            text: format!(
                "```statement {label}\nAs it is said.\n```\n```toml {label}\n{settings}\n```\n"
            ),
            shown: one_line(settings),
            truth: vec![truth],
            sides: None,
            header: None,
            last: false,
        }
    }
}

/// A definition.
pub fn define(label: &str, latex: &str) -> String {
    format!("```math {label} define\n{latex}\n```\n")
}

fn one_line(text: &str) -> String {
    let lines = text.lines().filter(|line| !line.starts_with("```"));
    lines.collect::<Vec<_>>().join("; ")
}

/// An equation from a maker of true equations: as it is, or damaged once in two; whether it is then
/// true is for the evaluator to say.
pub fn damaged_or_not(
    label: &str,
    random: &mut Random,
    make: &dyn Fn(&mut Random) -> (Term, Term),
) -> Claim {
    made(label, random, make, true)
}

/// The same from a maker of equations of which only the evaluator knows whether they are true.
pub fn evaluated(
    label: &str,
    random: &mut Random,
    make: &dyn Fn(&mut Random) -> (Term, Term),
) -> Claim {
    made(label, random, make, false)
}

fn made(
    label: &str,
    random: &mut Random,
    make: &dyn Fn(&mut Random) -> (Term, Term),
    true_ones: bool,
) -> Claim {
    loop {
        let (left, right) = make(random);
        let damage = random.once_in(2);
        let (left, right) = match damage {
            false => (left, right),
            true if random.once_in(4) => (damaged(&left, random), right),
            true => {
                let right = damaged(&right, random);
                (left, right)
            }
        };
        match truth::equal(&left, &right, random) {
            Some(holds) => {
                assert!(
                    holds || damage || !true_ones,
                    "the generator itself is wrong: {} = {}",
                    left.latex(),
                    right.latex()
                );
                return Claim::equation(label, &left, &right, holds);
            }
            None => continue,
        }
    }
}

/// One thing changed somewhere: a number, a sign, an exponent, a letter, a function.
pub fn damaged(t: &Term, random: &mut Random) -> Term {
    let mut copy = t.clone();
    let places = places_of(&copy);
    let mut at = random.below(places);
    damage_at(&mut copy, &mut at, random);
    copy
}

fn places_of(t: &Term) -> usize {
    1 + t.children().into_iter().map(places_of).sum::<usize>()
}

fn damage_at(t: &mut Term, at: &mut usize, random: &mut Random) -> bool {
    if *at == 0 {
        damage_here(t, random);
        return true;
    }
    *at -= 1;
    for child in t.children_mut() {
        if damage_at(child, at, random) {
            return true;
        }
    }
    false
}

fn damage_here(t: &mut Term, random: &mut Random) {
    use super::term::{Function, n};
    let whole = t.clone();
    *t = match whole.clone() {
        Term::Number(x) => Term::Number(x + super::term::integer(random.nonzero(-2, 3))),
        Term::Letter(name) => {
            let alike: Vec<&'static str> = truth::LETTERS
                .iter()
                .filter(|(l, d)| *l != name && *d == truth::domain(name))
                .map(|(l, _)| *l)
                .take(3)
                .collect();
            match alike.is_empty() {
                true => -whole,
                false => super::term::v(random.pick(&alike)),
            }
        }
        Term::Sum(mut terms) if terms.len() > 1 => {
            let at = random.below(terms.len());
            match random.below(3) {
                0 => {
                    terms.remove(at);
                }
                1 => terms[at] = -terms[at].clone(),
                _ => terms[at] = n(2) * terms[at].clone(),
            }
            Term::Sum(terms)
        }
        Term::Power(base, exponent) => match *exponent {
            Term::Number(x) => {
                Term::Power(base, Box::new(Term::Number(x + super::term::integer(1))))
            }
            other => Term::Power(base, Box::new(-other)),
        },
        Term::Call(function, argument) => {
            let other = match function {
                Function::Sin => Function::Cos,
                Function::Cos => Function::Sin,
                Function::Sinh => Function::Cosh,
                Function::Cosh => Function::Sinh,
                Function::Tan => Function::Cot,
                Function::Cot => Function::Tan,
                Function::Re => Function::Im,
                Function::Im => Function::Re,
                Function::Tanh => Function::Sinh,
                Function::Sqrt | Function::Exp | Function::Ln | Function::Abs => {
                    *t = n(random.pick(&[2, 3, -1])) * whole;
                    return;
                }
            };
            Term::Call(other, argument)
        }
        Term::Quotient(a, b) if random.once_in(2) => Term::Quotient(b, a),
        Term::Sum(_)
        | Term::Product(_)
        | Term::Minus(_)
        | Term::Quotient(..)
        | Term::Pi
        | Term::E
        | Term::I => match random.below(3) {
            0 => -whole,
            1 => n(2) * whole,
            _ => whole + n(1),
        },
    };
}
