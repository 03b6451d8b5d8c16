//! Decimal digits that are proved: those on which both ends of an interval agree.

use super::complex::Complex;
use super::number::Real;
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Signed, Zero};

/// A real number in decimal notation, truncated towards zero: digits that are certain, at most so many
/// significant ones. A rational number that is short is written exactly; three dots say that
/// digits follow. None where not even one digit is certain.
pub fn digits(x: &Real, most: usize) -> Option<String> {
    let (low, high) = match x {
        Real::Exact(x) => {
            let short = x.numer().bits() + x.denom().bits() <= 96;
            if short {
                return Some(x.to_string());
            }
            (x.clone(), x.clone())
        }
        Real::Enclosed(x) => (x.low().to_rational(), x.high().to_rational()),
    };
    if low.is_negative() != high.is_negative() || low.is_zero() || high.is_zero() {
        return None;
    }
    let sign = if low.is_negative() { "-" } else { "" };
    let (small, large) = {
        let (a, b) = (low.abs(), high.abs());
        if a <= b { (a, b) } else { (b, a) }
    };
    // The power of ten of the leading digit: 10^lead <= large < 10^(lead + 1).
    let lead = leading_power(&large);
    for count in (1..=most).rev() {
        let places = i64::try_from(count).ok()? - 1 - lead;
        let scaled = |x: &BigRational| (x * ten(places)).to_integer();
        let (a, b) = (scaled(&small), scaled(&large));
        if a == b && !a.is_zero() {
            return Some(format!("{sign}{}…", written(&a, places)));
        }
    }
    None
}

/// A complex number: its real part alone where that is all of it.
pub fn complex_digits(z: &Complex, most: usize) -> Option<String> {
    if z.is_real() {
        return digits(&z.re, most);
    }
    let im = digits(&z.im, most)?;
    if z.re.is_zero() {
        return Some(format!("{im} i"));
    }
    let re = digits(&z.re, most)?;
    Some(match im.strip_prefix('-') {
        Some(im) => format!("{re} - {im} i"),
        None => format!("{re} + {im} i"),
    })
}

fn ten(power: i64) -> BigRational {
    let power_of_ten =
        BigInt::from(10).pow(u32::try_from(power.unsigned_abs()).unwrap_or(u32::MAX));
    if power >= 0 {
        BigRational::from_integer(power_of_ten)
    } else {
        BigRational::new(BigInt::one(), power_of_ten)
    }
}

fn leading_power(x: &BigRational) -> i64 {
    // From the binary length, off by one or two, and then put right.
    let bits = |n: &BigInt| i64::try_from(n.bits()).unwrap_or(i64::MAX / 4);
    let mut lead = (bits(x.numer()) - bits(x.denom())) * 30103 / 100_000;
    while *x < ten(lead) {
        lead -= 1;
    }
    while *x >= ten(lead + 1) {
        lead += 1;
    }
    lead
}

/// `n / 10^places` with its decimal point, or as a multiple of a power of ten.
fn written(n: &BigInt, places: i64) -> String {
    let digits = n.to_string();
    let length = i64::try_from(digits.len()).unwrap_or(i64::MAX);
    let whole = length - places;
    if places > 0 && (-4..=0).contains(&whole) {
        let zeros = usize::try_from(-whole).unwrap_or(0);
        return format!("0.{}{digits}", "0".repeat(zeros));
    }
    if places > 0 && whole > 0 {
        let (before, after) = digits.split_at(usize::try_from(whole).unwrap_or(0));
        return format!("{before}.{after}");
    }
    if places == 0 {
        return digits;
    }
    let (first, rest) = digits.split_at(1);
    let point = if rest.is_empty() { "" } else { "." };
    format!("{first}{point}{rest}e{}", whole - 1)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_certain_digits_are_shown() {
        let root = Real::integer(2).root(2, 64).unwrap();
        assert_eq!(digits(&root, 10).unwrap(), "1.414213562…");
        let shown = digits(&root, 60).unwrap();
        assert!(
            "1.41421356237309504880168872420969807856967".starts_with(shown.trim_end_matches('…'))
        );
        assert!(shown.len() > 17);
        let square = root.multiply(&root, 64);
        assert_eq!(digits(&square, 10), None);
        assert_eq!(digits(&Real::pi(64).negated(), 5).unwrap(), "-3.1415…");
        let third = Real::rational(BigRational::new(1.into(), 3.into()));
        assert_eq!(digits(&third, 5).unwrap(), "1/3");
        let large = Real::integer(30).exponential(80).unwrap();
        assert_eq!(digits(&large, 4).unwrap(), "1.068e13…");
        let small = Real::integer(-5).exponential(80).unwrap();
        assert_eq!(digits(&small, 4).unwrap(), "0.006737…");
    }
}
