//! Exact numbers as a document writes them: `"1200"`, `"0.35"`, `"7/20"`, `"1e-6"`.
//!
//! A decimal is the fraction it abbreviates; nothing is ever rounded.

use crate::diagnostic::DiagnosticKind;
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Zero};

/// Largest power of ten that a number may carry, so that `1e999999999` costs nothing.
pub const EXPONENT_LIMIT: u32 = 400;

/// Most characters that a number may have.
const LENGTH_LIMIT: usize = 1_000;

/// Reads an exact number: an integer, a decimal with an optional power of ten, or a fraction.
pub fn exact_number(text: &str) -> Result<BigRational, DiagnosticKind> {
    let bad = || DiagnosticKind::BadNumber { text: text.into() };
    let trimmed = text.trim();
    if trimmed.len() > LENGTH_LIMIT {
        return Err(DiagnosticKind::BadNumber {
            text: format!("{} ...", trimmed.chars().take(40).collect::<String>()),
        });
    }
    match trimmed.split_once('/') {
        None => decimal(trimmed)?.ok_or_else(bad),
        Some((numerator, denominator)) => {
            let numerator = decimal(numerator.trim_end())?.ok_or_else(bad)?;
            let denominator = decimal(denominator.trim_start())?.ok_or_else(bad)?;
            if denominator.is_zero() {
                return Err(bad());
            }
            Ok(numerator / denominator)
        }
    }
}

/// `[+-] digits [. digits] [e [+-] digits]`, with at least one digit before or after the point.
fn decimal(text: &str) -> Result<Option<BigRational>, DiagnosticKind> {
    let (mantissa, power) = match text.split_once(['e', 'E']) {
        Some((mantissa, power)) => match exponent(power)? {
            Some(power) => (mantissa, power),
            None => return Ok(None),
        },
        None => (text, 0),
    };
    let (negative, mantissa) = match mantissa.strip_prefix('-') {
        Some(rest) => (true, rest),
        None => (false, mantissa.strip_prefix('+').unwrap_or(mantissa)),
    };
    let (whole, fraction) = mantissa.split_once('.').unwrap_or((mantissa, ""));
    let digits = format!("{whole}{fraction}");
    if digits.is_empty() || !digits.bytes().all(|b| b.is_ascii_digit()) {
        return Ok(None);
    }
    let Some(value) = BigInt::parse_bytes(digits.as_bytes(), 10) else {
        return Ok(None);
    };
    let value = if negative { -value } else { value };
    let shift = power - fraction.len() as i64;
    let scale = BigInt::from(10).pow(shift.unsigned_abs() as u32);
    Ok(Some(if shift >= 0 {
        BigRational::from(value * scale)
    } else {
        BigRational::new(value, scale)
    }))
}

fn exponent(text: &str) -> Result<Option<i64>, DiagnosticKind> {
    let digits = text.strip_prefix(['+', '-']).unwrap_or(text);
    if digits.is_empty() || !digits.bytes().all(|b| b.is_ascii_digit()) {
        return Ok(None);
    }
    match text.parse::<i64>() {
        Ok(power) if power.unsigned_abs() <= u64::from(EXPONENT_LIMIT) => Ok(Some(power)),
        _ => Err(DiagnosticKind::Exponent {
            exponent: text.into(),
            limit: EXPONENT_LIMIT,
        }),
    }
}

/// A number as a document would write it: the decimal if it ends, else the fraction.
pub fn write_number(number: &BigRational) -> String {
    if number.denom().is_one() {
        return number.numer().to_string();
    }
    format!("{}/{}", number.numer(), number.denom())
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn ratio(numerator: i64, denominator: i64) -> BigRational {
        BigRational::new(numerator.into(), denominator.into())
    }

    #[test]
    fn the_forms_of_the_format() {
        for (text, numerator, denominator) in [
            ("1200", 1200, 1),
            ("0.35", 7, 20),
            ("7/20", 7, 20),
            ("-7 / 20", -7, 20),
            ("1e-6", 1, 1_000_000),
            ("2.5E+3", 2500, 1),
            (".5", 1, 2),
            ("5.", 5, 1),
            ("+3", 3, 1),
            ("0.10/0.5", 1, 5),
            ("-0", 0, 1),
        ] {
            assert_eq!(
                exact_number(text),
                Ok(ratio(numerator, denominator)),
                "{text}"
            );
        }
    }

    #[test]
    fn what_is_no_number_is_refused() {
        for text in [
            "", " ", "abc", "1/0", "1/", "/2", "1/2/3", "1e", "e5", ".", "-", "--1", "1_000",
            "0x10", "1,5", "inf", "nan", "1 2", "١", "1/0.0", "+-1", "1.2.3", "-.e1",
        ] {
            assert_eq!(
                exact_number(text),
                Err(DiagnosticKind::BadNumber { text: text.into() }),
                "{text}"
            );
        }
    }

    #[test]
    fn huge_numbers_cost_nothing() {
        for text in ["1e401", "1e-999999999", "1e99999999999999999999999"] {
            assert!(matches!(
                exact_number(text),
                Err(DiagnosticKind::Exponent { limit: 400, .. })
            ));
        }
        assert!(matches!(
            exact_number(&"9".repeat(1_000_000)),
            Err(DiagnosticKind::BadNumber { .. })
        ));
    }

    proptest! {
        #[test]
        fn what_is_written_is_read_back(numerator: i64, denominator in 1i64..) {
            let number = ratio(numerator, denominator);
            prop_assert_eq!(exact_number(&write_number(&number)), Ok(number));
        }

        #[test]
        fn a_decimal_is_its_digits_over_a_power_of_ten(whole: u32, fraction in 0u32..1000) {
            let expected = ratio(i64::from(whole) * 1000 + i64::from(fraction), 1000);
            prop_assert_eq!(exact_number(&format!("{whole}.{fraction:03}")), Ok(expected));
        }

        #[test]
        fn no_text_panics(text in ".{0,20}") {
            let _ = exact_number(&text);
        }
    }
}
