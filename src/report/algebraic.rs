//! Real algebraic numbers in print: in closed form where that is readable, and as decimals.

use crate::report::formula::{Script, number};
use crate::report::prose::Prose;
use crate::theory::algebraic::{Algebraic, Radicals};
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Signed, Zero};

/// Significant decimals of a number.
const DIGITS: u32 = 5;
/// Numbers of more characters than this are shown as decimals.
const LONG: usize = 24;

/// A number as exactly as is readable, with its decimals where it is no integer.
pub fn shown(value: &Algebraic) -> Prose {
    let decimal = value.decimal(DIGITS);
    match closed(value) {
        Some([latex, plain]) => {
            let line = Prose::new().formula(latex, plain);
            if value.as_rational().is_some_and(BigRational::is_integer) {
                line
            } else {
                line.formula(format!("\\;\\approx {decimal}"), format!(" ≈ {decimal}"))
            }
        }
        None => Prose::new().formula(format!("\\approx {decimal}"), format!("≈ {decimal}")),
    }
}

/// The same after an equals sign, or after that of an approximation where only decimals are shown.
pub fn equals(value: &Algebraic) -> Prose {
    match closed(value) {
        Some(_) => Prose::new().formula("\\;=\\;", " = ").then(shown(value)),
        None => Prose::new().formula("\\;", " ").then(shown(value)),
    }
}

/// A number in closed form, in LaTeX and for a terminal; none where that would be too long.
pub fn closed(value: &Algebraic) -> Option<[String; 2]> {
    if let Some(rational) = value.as_rational() {
        let plain = number(rational, Script::Plain);
        return (plain.len() <= LONG).then(|| [number(rational, Script::Latex), plain]);
    }
    let radicals = value.radicals()?;
    let both = [Script::Latex, Script::Plain].map(|script| written(&radicals, script));
    (both[1].chars().count() <= 2 * LONG).then_some(both)
}

fn written(radicals: &Radicals, script: Script) -> String {
    let (rational, coefficient, radicand) = &radicals.sum;
    let root = |inside: &str, single: bool| match script {
        Script::Latex => format!("\\sqrt{{{inside}}}"),
        _ if single => format!("√{inside}"),
        _ => format!("√({inside})"),
    };
    let term = {
        let top = coefficient.numer().abs();
        let factor = if top.is_one() {
            String::new()
        } else {
            top.to_string()
        };
        let surd = format!("{factor}{}", root(&radicand.to_string(), true));
        match (coefficient.denom().is_one(), script) {
            (true, _) => surd,
            (false, Script::Latex) => format!("\\frac{{{surd}}}{{{}}}", coefficient.denom()),
            (false, _) => format!("{surd}/{}", coefficient.denom()),
        }
    };
    let sum = match (rational.is_zero(), coefficient.is_negative()) {
        (true, false) => term,
        (true, true) => format!("-{term}"),
        // The positive part first.
        (false, false) if rational.is_negative() => {
            format!("{term} - {}", number(&rational.abs(), script))
        }
        (false, negative) => {
            let sign = if negative { "-" } else { "+" };
            format!("{} {sign} {term}", number(rational, script))
        }
    };
    if !radicals.squared {
        return sum;
    }
    let sign = if radicals.negative { "-" } else { "" };
    format!("{sign}{}", root(&sum, false))
}

/// Rational numbers around a number that differ by less than a trillionth.
pub fn enclosure(value: &Algebraic) -> (BigRational, BigRational) {
    let width = BigRational::new(BigInt::one(), BigInt::from(10).pow(12));
    value.enclosure(&width).unwrap_or_default()
}
