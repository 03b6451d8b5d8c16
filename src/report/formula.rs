//! Exact polynomials and rational functions as a reader wants them: factored, in the printed
//! names, in the document's order of the letters.
//!
//! Invariants: what is written is equal to what was given; the sign stands in front of the whole;
//! single letters are juxtaposed as in print, longer names and numbers keep a blank.

mod lines;
#[cfg(test)]
mod tests;

pub use lines::width;

use crate::functions::{FunctionLetter, FunctionTable};
use crate::latex;
use crate::model::Model;
use crate::report::plain::plain_name;
use crate::verdict::Outcome;
use lines::{LINE, broken};
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Signed, Zero};
use ratpoly::{Budget, Monomial, Polynomial, RationalFunction};
use std::borrow::Cow;

/// What is written for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Script {
    /// A TeX that reads mathematics.
    Latex,
    /// A terminal.
    Plain,
    /// A program: every product has its `*`, the letters are those of the polynomial ring.
    Code,
}

/// Writes in the letters of one model.
#[derive(Clone, Debug)]
pub struct Formulas {
    latex: Vec<String>,
    plain: Vec<String>,
    code: Vec<String>,
}

/// `content * letters^monomial * factors`, with the sign in the content.
struct Factors {
    content: BigInt,
    monomial: Monomial,
    factors: Vec<(Polynomial, u32)>,
}

/// The most bytes of the text of a function.
const LONGEST_FUNCTION: usize = 4_000;
/// The most terms of a polynomial that is factored to be shown.
const LONGEST_FACTORED: usize = 1_000;
/// Terms, bits and steps that this may take: a report is printed at once.
const FACTORING: (usize, u64, u64) = (20_000, 20_000, 10_000_000);

/// A polynomial in irreducible factors; by its contents only where factoring is out of reach.
fn factors(p: &Polynomial) -> Factors {
    let variables = p.ring().len();
    let mut parts = Factors {
        content: BigInt::zero(),
        monomial: Monomial::one(variables),
        factors: Vec::new(),
    };
    if p.is_zero() {
        return parts;
    }
    if p.len() > LONGEST_FACTORED {
        return by_contents(p);
    }
    let (terms, bits, steps) = FACTORING;
    let Ok(found) = p.factor_within(&Budget::new(terms, bits, steps)) else {
        return by_contents(p);
    };
    parts.content = found.content;
    let mut exponents = vec![0; variables];
    for (factor, power) in found.factors {
        match factor.leading_monomial() {
            Some(m) if factor.len() == 1 && m.total_degree() == 1 => {
                for (total, e) in exponents.iter_mut().zip(m.exponents()) {
                    *total += e * power;
                }
            }
            _ => parts.factors.push((factor, power)),
        }
    }
    parts.monomial = Monomial::new(exponents);
    parts
}

/// A polynomial as content, monomial content and what is left.
fn by_contents(p: &Polynomial) -> Factors {
    let mut content = p.content();
    if p.leading_coefficient().is_negative() {
        content = -content;
    }
    let monomial = p.monomial_content();
    let rest = p.terms().filter_map(|(m, c)| {
        let exponents = m.checked_div(&monomial)?;
        Some((exponents.exponents().to_vec(), c / &content))
    });
    let rest = Polynomial::from_terms(p.ring(), rest)
        .expect("the terms of a polynomial divided by their common divisor");
    let factors = if rest.is_one() {
        Vec::new()
    } else {
        vec![(rest, 1)]
    };
    Factors {
        content,
        monomial,
        factors,
    }
}

/// Sums up to about this many characters are not broken.
const SHORT: usize = 24;

impl Formulas {
    /// For the letters of a model.
    pub fn of(model: &Model) -> Self {
        Formulas::with(model, model.functions.as_ref())
    }

    /// The same for what an outcome says: its letters may have stood for other functions.
    pub fn here<'f>(&'f self, model: &Model, outcome: &Outcome) -> Cow<'f, Formulas> {
        match &outcome.letters {
            Some(functions) => Cow::Owned(Formulas::with(model, Some(functions))),
            None => Cow::Borrowed(self),
        }
    }

    fn with(model: &Model, functions: Option<&FunctionTable>) -> Self {
        let latex: Vec<String> = (0..model.letters.len())
            .map(|letter| latex::canonical(&model.letter_name(letter)))
            .collect();
        let plain = latex.iter().map(|name| plain_name(name)).collect();
        let code = model.ring.variables().to_vec();
        let mut formulas = Formulas { latex, plain, code };
        // Arguments mention earlier letters only.
        for (letter, function) in functions.iter().flat_map(|table| table.all()) {
            let texts = [Script::Latex, Script::Plain, Script::Code]
                .map(|script| formulas.function(&function, script));
            // Functions of functions are as long as all that is in them: such a one keeps its name.
            if texts.iter().any(|text| text.len() > LONGEST_FUNCTION) {
                continue;
            }
            let [latex, plain, code] = texts;
            formulas.latex[letter] = latex;
            formulas.plain[letter] = plain;
            formulas.code[letter] = code;
        }
        formulas
    }

    /// What a letter stands for that was given out to a function.
    fn function(&self, function: &FunctionLetter, script: Script) -> String {
        let latex = script == Script::Latex;
        let call = |name: &str, argument: String| match script {
            Script::Latex => format!("\\{name}({argument})"),
            _ => format!("{name}({argument})"),
        };
        let of = |p: &Polynomial| self.rational(&p.clone().into(), script);
        match function {
            FunctionLetter::Pi => match script {
                Script::Latex => "\\pi".into(),
                Script::Plain => "\u{3c0}".into(),
                Script::Code => "pi".into(),
            },
            FunctionLetter::ImaginaryUnit if latex => "\\mathrm{i}".into(),
            FunctionLetter::ImaginaryUnit => "i".into(),
            FunctionLetter::Exponential(u) => call("exp", self.rational(u, script)),
            FunctionLetter::Cosine(u) => call("cos", self.rational(u, script)),
            FunctionLetter::Sine(u, _) => call("sin", self.rational(u, script)),
            FunctionLetter::Logarithm(p) => call("ln", of(p)),
            FunctionLetter::Dirac(u) => match script {
                Script::Plain => format!("\u{3b4}({})", self.rational(u, script)),
                _ => call("delta", self.rational(u, script)),
            },
            FunctionLetter::Root(p) if latex => format!("\\sqrt{{{}}}", of(p)),
            FunctionLetter::Root(p) => format!("sqrt({})", of(p)),
            FunctionLetter::Power(base, exponent) => {
                let base = match base.len() {
                    1 => of(base),
                    _ => format!("({})", of(base)),
                };
                let exponent = self.rational(exponent, script);
                match script {
                    Script::Latex => format!("{{{base}^{{{exponent}}}}}"),
                    _ => format!("({base}^({exponent}))"),
                }
            }
            FunctionLetter::Bound { depth, .. } => format!("s_{depth}"),
        }
    }

    /// The name of a letter.
    pub fn letter(&self, letter: usize, script: Script) -> &str {
        match script {
            Script::Latex => &self.latex[letter],
            Script::Plain => &self.plain[letter],
            Script::Code => &self.code[letter],
        }
    }

    /// A rational function, factored.
    pub fn rational(&self, f: &RationalFunction, script: Script) -> String {
        self.quotient(factors(f.numerator()), factors(f.denominator()), script)
    }

    /// A rational function times a polynomial that is left as it is.
    pub fn multiple(&self, f: &RationalFunction, of: &Polynomial, script: Script) -> String {
        let mut top = factors(f.numerator());
        top.factors.push((of.clone(), 1));
        self.quotient(top, factors(f.denominator()), script)
    }

    fn quotient(&self, top: Factors, bottom: Factors, script: Script) -> String {
        if top.content.is_zero() {
            return "0".into();
        }
        let negative = top.content.is_negative() != bottom.content.is_negative();
        if is_one(&bottom) {
            return match (negative, is_sum(&top)) {
                (true, true) => self.sum(&-&top.factors[0].0, script),
                (true, false) => format!("-{}", self.product(&top, script)),
                (false, _) => self.alone(&top, script),
            };
        }
        let sign = if negative { "-" } else { "" };
        match script {
            Script::Latex => format!(
                "{sign}\\frac{{{}}}{{{}}}",
                self.alone(&top, script),
                self.alone(&bottom, script)
            ),
            Script::Plain | Script::Code => {
                let denominator = self.product(&bottom, script);
                let denominator = if is_single(&bottom) {
                    denominator
                } else if is_sum(&bottom) {
                    format!("({})", self.alone(&bottom, script))
                } else {
                    format!("({denominator})")
                };
                format!("{sign}{}/{denominator}", self.product(&top, script))
            }
        }
    }

    /// A polynomial, factored.
    pub fn polynomial(&self, p: &Polynomial, script: Script) -> String {
        self.rational(&RationalFunction::from(p.clone()), script)
    }

    /// A polynomial that vanishes as an equation between its positive and its negative terms:
    /// `bd = ae`.
    pub fn relation(&self, p: &Polynomial, script: Script) -> String {
        let p = p.primitive_part().unit_normal();
        let side = |positive: bool| {
            let terms: Vec<String> = p
                .terms()
                .filter(|(_, c)| c.is_positive() == positive)
                .map(|(m, c)| self.term(&c.abs(), &m, script))
                .collect();
            if terms.is_empty() {
                "0".to_string()
            } else {
                terms.join(" + ")
            }
        };
        format!("{} = {}", side(true), side(false))
    }

    /// A rational number.
    pub fn number(&self, value: &BigRational, script: Script) -> String {
        number(value, script)
    }

    /// A name and its value as a display of LaTeX that fits a line: long numerators are broken
    /// between their terms, below the sign of equality.
    pub fn display(&self, name: &str, f: &RationalFunction) -> String {
        let whole = self.rational(f, Script::Latex);
        if width(&whole) <= LINE {
            return format!("{name} = {whole}");
        }
        let (top, bottom) = (factors(f.numerator()), factors(f.denominator()));
        let sign = if top.content.is_negative() != bottom.content.is_negative() {
            "-"
        } else {
            ""
        };
        let mut pieces: Vec<String> = Vec::new();
        let monomial = self.term(&top.content.abs(), &top.monomial, Script::Latex);
        if f.denominator().is_one() {
            let shown = if monomial == "1" { "" } else { &monomial };
            pieces.push(format!("{sign}{shown}"));
        } else {
            let below = self.alone(&bottom, Script::Latex);
            if width(&below) <= LINE {
                pieces.push(format!("{sign}\\frac{{{monomial}}}{{{below}}}"));
            } else {
                let shown = if monomial == "1" { "" } else { &monomial };
                pieces.push(format!("{sign}{shown}"));
                for (factor, power) in &top.factors {
                    self.broken_factor(factor, *power, &mut pieces);
                }
                pieces.push("\\Big/ \\Bigl(".into());
                let monomial = self.term(&bottom.content.abs(), &bottom.monomial, Script::Latex);
                pieces.push(if monomial == "1" {
                    String::new()
                } else {
                    monomial
                });
                for (factor, power) in &bottom.factors {
                    self.broken_factor(factor, *power, &mut pieces);
                }
                pieces.push("\\Bigr)".into());
                return broken(name, &pieces);
            }
        }
        for (factor, power) in &top.factors {
            self.broken_factor(factor, *power, &mut pieces);
        }
        broken(name, &pieces)
    }

    fn broken_factor(&self, factor: &Polynomial, power: u32, pieces: &mut Vec<String>) {
        let whole = format!("({})", self.sum(factor, Script::Latex));
        if width(&whole) <= SHORT {
            pieces.push(match power {
                1 => whole,
                n => format!("{whole}^{{{n}}}"),
            });
            return;
        }
        let last = factor.len().saturating_sub(1);
        for (k, (m, c)) in factor.terms().enumerate() {
            let sign = match (k, c.is_negative()) {
                (0, false) => "\\bigl(",
                (0, true) => "\\bigl(-",
                (_, false) => "+ ",
                (_, true) => "- ",
            };
            let mut piece = format!("{sign}{}", self.term(&c.abs(), &m, Script::Latex));
            if k == last {
                piece += "\\bigr)";
                if power > 1 {
                    piece += &format!("^{{{power}}}");
                }
            }
            pieces.push(piece);
        }
    }

    /// A product that stands alone: a lone sum needs no brackets.
    fn alone(&self, parts: &Factors, script: Script) -> String {
        if is_sum(parts) {
            self.sum(&parts.factors[0].0, script)
        } else {
            self.product(parts, script)
        }
    }

    fn product(&self, parts: &Factors, script: Script) -> String {
        let mut pieces = Vec::new();
        if parts.factors.is_empty() || !parts.content.abs().is_one() || !parts.monomial.is_one() {
            pieces.push(self.term(&parts.content.abs(), &parts.monomial, script));
        }
        for (factor, power) in &parts.factors {
            let inner = self.sum(factor, script);
            pieces.push(match power {
                1 => format!("({inner})"),
                n if script == Script::Latex => format!("({inner})^{{{n}}}"),
                n => format!("({inner})^{n}"),
            });
        }
        let between = match script {
            Script::Latex => "",
            Script::Plain => " ",
            Script::Code => "*",
        };
        // A single letter before a bracket stands close in print and on a terminal.
        let mut text = String::new();
        for piece in pieces {
            if !text.is_empty() {
                let close = script == Script::Plain && self.is_short(&text);
                text += if close { "" } else { between };
            }
            text += &piece;
        }
        text
    }

    /// Whether nothing but single letters, digits and brackets were written.
    fn is_short(&self, text: &str) -> bool {
        !text.contains('_') && !text.trim_end_matches(')').contains(") ")
    }

    fn sum(&self, p: &Polynomial, script: Script) -> String {
        let mut text = String::new();
        for (k, (m, c)) in p.terms().enumerate() {
            text += match (k, c.is_negative()) {
                (0, false) => "",
                (0, true) => "-",
                (_, false) => " + ",
                (_, true) => " - ",
            };
            text += &self.term(&c.abs(), &m, script);
        }
        text
    }

    /// A positive coefficient times a power product.
    fn term(&self, coefficient: &BigInt, monomial: &Monomial, script: Script) -> String {
        let mut pieces = Vec::new();
        if !coefficient.is_one() || monomial.is_one() {
            pieces.push((coefficient.to_string(), true));
        }
        for (letter, &exponent) in monomial.exponents().iter().enumerate() {
            if exponent == 0 {
                continue;
            }
            let name = self.letter(letter, script);
            let short = name.chars().count() == 1;
            pieces.push((
                match exponent {
                    1 => name.to_string(),
                    2..=9 => format!("{name}^{exponent}"),
                    _ if script == Script::Latex => format!("{name}^{{{exponent}}}"),
                    _ => format!("{name}^{exponent}"),
                },
                short,
            ));
        }
        let mut text = String::new();
        let mut close = true;
        for (piece, short) in pieces {
            if !text.is_empty() {
                text += match script {
                    Script::Code => "*",
                    _ if close && short => "",
                    _ => " ",
                };
            }
            text += &piece;
            close = short;
        }
        text
    }
}

fn is_one(parts: &Factors) -> bool {
    parts.factors.is_empty() && parts.content.abs().is_one() && parts.monomial.is_one()
}

fn is_sum(parts: &Factors) -> bool {
    parts.factors.len() == 1
        && parts.factors[0].1 == 1
        && parts.content.abs().is_one()
        && parts.monomial.is_one()
}

/// Whether the product is one factor, which a slash takes without brackets.
fn is_single(parts: &Factors) -> bool {
    let letters = parts
        .monomial
        .exponents()
        .iter()
        .filter(|e| **e > 0)
        .count();
    let number = usize::from(!parts.content.abs().is_one());
    letters + number + parts.factors.len() == 1
}

/// A rational number: an integer, or numerator over denominator.
pub fn number(value: &BigRational, script: Script) -> String {
    if value.is_integer() {
        return value.numer().to_string();
    }
    match script {
        Script::Latex => {
            let sign = if value.is_negative() { "-" } else { "" };
            format!(
                "{sign}\\frac{{{}}}{{{}}}",
                value.numer().abs(),
                value.denom()
            )
        }
        Script::Plain | Script::Code => format!("{}/{}", value.numer(), value.denom()),
    }
}
