//! Names, numbers, relations and delimiters.

use crate::expr::{Accent, Bracket, Font, Function, Letter, Name, Relation};
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Signed, Zero};

/// The one spelling of a name: equal strings are equal names.
pub fn canonical(name: &Name) -> String {
    let mut text = letter(&name.letter);
    let mut dots = name.dots;
    while dots > 0 {
        let now = dots.min(4);
        dots -= now;
        let command = ["\\dot", "\\ddot", "\\dddot", "\\ddddot"][usize::from(now) - 1];
        text = format!("{command}{{{text}}}");
    }
    text += &"'".repeat(usize::from(name.letter.primes));
    if let Some(subscript) = &name.subscript {
        let label = &subscript.label;
        let mut characters = label.chars();
        match (characters.next(), characters.next()) {
            (Some(c), None) if c.is_ascii_alphanumeric() => text += &format!("_{c}"),
            _ => text += &format!("_{{{label}}}"),
        }
    }
    text
}

/// Appends, with a blank where a control word would swallow the next letter.
pub(super) fn push(text: &mut String, piece: &str) {
    let word = text
        .rfind('\\')
        .map(|start| &text[start + 1..])
        .is_some_and(|word| !word.is_empty() && word.chars().all(|c| c.is_ascii_alphabetic()));
    if word && piece.starts_with(|c: char| c.is_ascii_alphabetic()) {
        text.push(' ');
    }
    text.push_str(piece);
}

pub(super) fn upright(word: &str) -> String {
    if word.chars().all(|c| c.is_ascii_alphanumeric()) {
        format!("\\mathrm{{{word}}}")
    } else {
        format!("\\text{{{word}}}")
    }
}

pub(super) fn letter(letter: &Letter) -> String {
    let base = &letter.base;
    let text = match letter.font {
        Font::Italic => base.clone(),
        Font::Bold if base.starts_with('\\') => format!("\\boldsymbol{{{base}}}"),
        Font::Bold => format!("\\mathbf{{{base}}}"),
        Font::Roman => upright(base),
        Font::Calligraphic => format!("\\mathcal{{{base}}}"),
        Font::Blackboard => format!("\\mathbb{{{base}}}"),
    };
    match letter.accent {
        None => text,
        Some(Accent::Tilde) => format!("\\tilde{{{text}}}"),
        Some(Accent::Hat) => format!("\\hat{{{text}}}"),
        Some(Accent::Bar) => format!("\\bar{{{text}}}"),
        Some(Accent::Vector) => format!("\\vec{{{text}}}"),
    }
}

/// The sign of a relation.
pub fn relation(relation: Relation) -> &'static str {
    match relation {
        Relation::Equal => "=",
        Relation::NotEqual => "\\neq",
        Relation::Less => "<",
        Relation::LessEqual => "\\le",
        Relation::Greater => ">",
        Relation::GreaterEqual => "\\ge",
        Relation::Distributed => "\\sim",
        Relation::Approximately => "\\approx",
        Relation::Tends => "\\to",
    }
}

pub(super) fn function(function: Function) -> &'static str {
    match function {
        Function::Determinant => "\\det",
        Function::Trace => "\\operatorname{tr}",
        Function::RealPart => "\\operatorname{Re}",
        Function::ImaginaryPart => "\\operatorname{Im}",
        Function::Cosine => "\\cos",
        Function::Sine => "\\sin",
        Function::Tangent => "\\tan",
        Function::Cotangent => "\\cot",
        Function::HyperbolicCosine => "\\cosh",
        Function::HyperbolicSine => "\\sinh",
        Function::HyperbolicTangent => "\\tanh",
        Function::Exponential => "\\exp",
        Function::Logarithm => "\\ln",
        Function::SquareRoot => "\\sqrt",
        Function::Absolute => "",
    }
}

/// A number; without a finite decimal form, a fraction.
pub(super) fn number(value: &BigRational) -> String {
    if value.is_negative() {
        return format!("(-{})", number(&-value));
    }
    let (two, five, ten) = (BigInt::from(2), BigInt::from(5), BigInt::from(10));
    let mut rest = value.denom().clone();
    let mut places = 0;
    for prime in [&two, &five] {
        let mut count = 0usize;
        while (&rest % prime).is_zero() {
            rest /= prime;
            count += 1;
        }
        places = places.max(count);
    }
    if !rest.is_one() {
        return format!("\\frac{{{}}}{{{}}}", value.numer(), value.denom());
    }
    if places == 0 {
        return value.numer().to_string();
    }
    let scaled = value * BigRational::from_integer(num_traits::pow(ten, places));
    let digits = format!("{:0>width$}", scaled.to_integer(), width = places + 1);
    let (whole, decimals) = digits.split_at(digits.len() - places);
    format!("{whole}.{decimals}")
}

/// Between the delimiters, which grow with what they hold.
pub(super) fn enclose(bracket: Bracket, inner: &str) -> String {
    let (open, close) = match bracket {
        Bracket::Round => ("(", ")"),
        Bracket::Square => ("[", "]"),
        Bracket::Curly => ("\\{", "\\}"),
        Bracket::Bar => ("|", "|"),
        Bracket::None => return format!("\\underbrace{{{inner}}}"),
    };
    let tall = ["\\frac", "\\begin", "\\sum", "\\int", "\\underbrace"]
        .iter()
        .any(|command| inner.contains(command));
    if tall || bracket == Bracket::Bar {
        let mut text = format!("\\left{open}");
        push(&mut text, inner);
        text + "\\right" + close
    } else {
        format!("{open}{inner}{close}")
    }
}
