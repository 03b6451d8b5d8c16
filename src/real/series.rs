//! Elementary functions at single dyadic numbers: power series in fixed point with bounded errors.
//!
//! A number is held as an integer in units of 2^-w; every truncation loses less than one unit, and
//! each function's comment adds them up (R. P. Brent & P. Zimmermann, *Modern Computer Arithmetic*,
//! 2010, chapter 4). Arguments are reduced by ln 2 and by pi/2, both enclosed to as many digits as the
//! reduction takes away. Too large arguments have no enclosure.

use super::dyadic::{Dyadic, Rounding};
use super::interval::Interval;
use num_bigint::BigInt;
use num_traits::{One, Signed, ToPrimitive, Zero};
use std::cell::RefCell;
use std::collections::BTreeMap;

/// Arguments of exponentials and angles from 2 to this power on are refused.
const LARGEST: i64 = 24;
/// Binary digits beyond those asked for.
const GUARD: i64 = 24;

/// An integer in units of `2^-places`, and by how many units the number may be away from it.
struct Fixed {
    units: BigInt,
    error: BigInt,
    places: i64,
}

impl Fixed {
    fn interval(&self, bits: u32) -> Interval {
        let end = |units: BigInt| Dyadic::new(units, -self.places);
        let low = end(&self.units - &self.error);
        let high = end(&self.units + &self.error);
        Interval::between(
            low.rounded(bits, Rounding::Down),
            high.rounded(bits, Rounding::Up),
        )
    }
}

fn places_for(bits: u32) -> i64 {
    i64::from(bits) + GUARD
}

/// artanh(1/k), or arctan(1/k) with alternating signs: the sum of k^-(2j+1)/(2j+1).
///
/// Each of the terms loses less than 2 units, in the power and in its quotient; the rest of the series
/// is less than the last power, which is less than 2 units. So the sum is short by less than
/// `2 terms + 4` units.
fn reciprocal_series(k: u32, w: i64, alternating: bool) -> Fixed {
    let square = BigInt::from(k) * k;
    let mut power = (BigInt::one() << w) / k;
    let mut sum = BigInt::zero();
    let mut j = 0u32;
    while !power.is_zero() {
        let term = &power / (2 * j + 1);
        if alternating && j % 2 == 1 {
            sum -= term;
        } else {
            sum += term;
        }
        power /= &square;
        j += 1;
    }
    Fixed {
        units: sum,
        error: BigInt::from(2 * j + 4),
        places: w,
    }
}

thread_local! {
    /// Constants that were computed, by which and by digits: they cost as much as a function.
    static CONSTANTS: RefCell<BTreeMap<(bool, i64), Interval>> = const { RefCell::new(BTreeMap::new()) };
}

fn constant(circle: bool, w: i64) -> Interval {
    let known = CONSTANTS.with_borrow(|known| known.get(&(circle, w)).cloned());
    if let Some(known) = known {
        return known;
    }
    let bits = u32::try_from(w).unwrap_or(u32::MAX);
    let part = |factor: i64, series: Fixed| {
        Interval::integer(factor).multiply(&series.interval(bits + 8), bits + 8)
    };
    let inner = w + 16;
    let value = if circle {
        // J. Machin (1706): pi = 16 arctan(1/5) - 4 arctan(1/239).
        part(16, reciprocal_series(5, inner, true))
            .add(&part(-4, reciprocal_series(239, inner, true)), bits)
    } else {
        // ln 2 = 18 artanh(1/26) - 2 artanh(1/4801) + 8 artanh(1/8749).
        part(18, reciprocal_series(26, inner, false))
            .add(&part(-2, reciprocal_series(4801, inner, false)), bits)
            .add(&part(8, reciprocal_series(8749, inner, false)), bits)
    };
    CONSTANTS.with_borrow_mut(|known| known.insert((circle, w), value.clone()));
    value
}

/// The circle's constant.
pub fn pi(bits: u32) -> Interval {
    constant(true, i64::from(bits).max(16))
}

/// The natural logarithm of two.
pub fn ln_2(bits: u32) -> Interval {
    constant(false, i64::from(bits).max(16))
}

/// `x - n unit` in units of 2^-w with its error, where n is the nearest integer to `x / unit`.
fn reduced(x: &Dyadic, unit: impl Fn(u32) -> Interval, w: i64) -> Option<(Fixed, BigInt)> {
    let size = x.magnitude().unwrap_or(0).max(0);
    if size > LARGEST {
        return None;
    }
    let digits = u32::try_from(w + size + 8).ok()?;
    let unit = unit(digits);
    let quotient = x.divide(unit.low(), 64, Rounding::Down)?;
    // Rounding n wrongly only leaves a little more.
    let n: BigInt = (quotient.fixed(1) + BigInt::one()) >> 1u32;
    // |n| < 2^(size + 2): the error of n times the unit's is less than one unit of 2^-w.
    let times = Interval::point(Dyadic::new(n.clone(), 0)).multiply(&unit, digits + 8);
    let rest = Interval::point(x.clone()).subtract(&times, digits + 8);
    let low = rest.low().fixed(w);
    let high = rest.high().fixed(w) + 1;
    let units = (&low + &high) >> 1;
    let error = &high - &units + 1;
    let fixed = Fixed {
        units,
        error,
        places: w,
    };
    Some((fixed, n))
}

/// e^x. With x = n ln 2 + r and t = r / 2^s the series of e^t is summed and squared s times.
///
/// The terms t^j/j! are truncated once by the product and once by the quotient: a term's error is at
/// most 2 units and a quarter of the one before, less than 3 units, and the tail after the first
/// term that vanishes is less than 6. Squaring the lower and the upper bound keeps them bounds.
pub fn exponential(x: &Dyadic, bits: u32) -> Option<Interval> {
    if x.is_zero() {
        return Some(Interval::integer(1));
    }
    let halvings = 2 + i64::from((bits / 4).isqrt());
    let w = places_for(bits) + halvings + 8;
    let (rest, n) = reduced(x, ln_2, w)?;
    let one = BigInt::one() << w;
    // Below and above the argument, so that the series is summed for a number that is not negative.
    let below = (&rest.units - &rest.error) >> halvings;
    let spread = ((BigInt::from(2) * &rest.error) >> halvings) + 2;
    let negative = below.is_negative();
    let t = below.abs();
    let mut term = t.clone();
    let mut sum = &one + &term;
    let mut j = 2u32;
    while !term.is_zero() {
        term = ((&term * &t) >> w) / j;
        sum += &term;
        j += 1;
    }
    let short = BigInt::from(3 * j + 6);
    let (mut low, mut high) = (sum.clone(), sum + short);
    if negative {
        // e^-t = 1 / e^t, rounded outwards.
        let numerator = &one << w;
        let (a, b) = (&numerator / &high, &numerator / &low + 1);
        (low, high) = (a, b);
    }
    // e^(t + d) <= e^t (1 + 2 d) for 0 <= d < 1.
    high += ((&high * (spread << 1u32)) >> w) + 1;
    for _ in 0..halvings {
        low = (&low * &low) >> w;
        high = ((&high * &high) >> w) + 1;
    }
    let exponent = n.to_i64()? - w;
    Some(Interval::between(
        Dyadic::new(low, exponent).rounded(bits, Rounding::Down),
        Dyadic::new(high, exponent).rounded(bits, Rounding::Up),
    ))
}

/// Cosine and sine. With x = n pi/2 + r, |r| < 1, both series are summed at r.
///
/// A term's error is at most one unit for the square, one for the product's and one for the
/// quotient's truncation, beside what is left of the error before: less than 4 units. The rest of an
/// alternating series is less than its first term left out, less than 4 units; and the error of r
/// moves neither function by more than itself.
pub fn cosine_and_sine(x: &Dyadic, bits: u32) -> Option<(Interval, Interval)> {
    if x.is_zero() {
        return Some((Interval::integer(1), Interval::integer(0)));
    }
    // A small angle's sine needs digits beyond its leading zeros.
    let small = x
        .magnitude()
        .map_or(0, |m| (-m).clamp(0, 4 * i64::from(bits)));
    let w = places_for(bits) + small + 16;
    let half_circle = |digits: u32| pi(digits).scaled(-1);
    let (rest, n) = reduced(x, half_circle, w)?;
    let r = rest.units.abs();
    let square = (&r * &r) >> w;
    let series = |first: BigInt, start: u32| {
        let mut term = first;
        let mut sum = term.clone();
        let mut j = start;
        let mut minus = true;
        while !term.is_zero() {
            term = ((&term * &square) >> w) / (j * (j + 1));
            if minus {
                sum -= &term;
            } else {
                sum += &term;
            }
            minus = !minus;
            j += 2;
        }
        Fixed {
            units: sum,
            error: BigInt::from(4 * j + 8) + &rest.error,
            places: w,
        }
    };
    let cosine = series(BigInt::one() << w, 1).interval(bits);
    let mut sine = series(r.clone(), 2).interval(bits);
    if rest.units.is_negative() {
        sine = sine.negated();
    }
    let bounds = Interval::between(Dyadic::integer(-1), Dyadic::integer(1));
    let clip = |x: Interval| x.intersection(&bounds).unwrap_or_else(|| bounds.clone());
    let (cosine, sine) = (clip(cosine), clip(sine));
    // The quadrant: n modulo 4, from 0.
    let quadrant = (n & BigInt::from(3)).to_u8()?;
    Some(match quadrant {
        0 => (cosine, sine),
        1 => (sine.negated(), cosine),
        2 => (cosine.negated(), sine.negated()),
        _ => (sine, cosine.negated()),
    })
}

/// ln x for x > 0. With x = 2^n m, m from about 0.7 to 1.4, and z = (m - 1)/(m + 1): ln m = 2 artanh z.
///
/// A term's error is at most two units for power and quotient beside that of the power before, which
/// z^2 < 1/30 makes smaller: less than 4 units; the rest of the series is less than its first term
/// left out, less than 4 units; the error of z counts at most 33/32 times.
pub fn logarithm(x: &Dyadic, bits: u32) -> Option<Interval> {
    if !x.is_positive() {
        return None;
    }
    if *x == Dyadic::integer(1) {
        return Some(Interval::integer(0));
    }
    let mut n = x.magnitude()?;
    let mut mantissa = x.scaled(-n);
    // From 1/2 to 1: what is below 0.7 is doubled.
    if mantissa < Dyadic::new(BigInt::from(45), -6) {
        mantissa = mantissa.scaled(1);
        n -= 1;
    }
    let one = Dyadic::integer(1);
    let above = mantissa.plus(&one.negated());
    let below = mantissa.plus(&one);
    // Close to one the logarithm is as small as the difference from it.
    let small = above
        .magnitude()
        .map_or(0, |m| (-m).clamp(0, 4 * i64::from(bits)));
    let w = places_for(bits) + small + 16;
    let digits = u32::try_from(w).ok()?;
    let z = above.divide(&below, digits, Rounding::Down)?.fixed(w);
    let negative = z.is_negative();
    let z = z.abs();
    let square = (&z * &z) >> w;
    let mut power = z;
    let mut sum = BigInt::zero();
    let mut j = 1u32;
    while !power.is_zero() {
        sum += &power / j;
        power = (&power * &square) >> w;
        j += 2;
    }
    let mut rest = Fixed {
        units: sum << 1,
        error: BigInt::from(8 * j + 24),
        places: w,
    }
    .interval(digits);
    if negative {
        rest = rest.negated();
    }
    if n == 0 {
        return Some(rest.rounded(bits));
    }
    let twos = Interval::integer(n).multiply(&ln_2(digits), digits);
    Some(twos.add(&rest, bits))
}

/// arctan x, by two halvings of the angle and the series at |x| < 1/4.
///
/// The errors are as in [`logarithm`], with alternating signs.
pub fn arctangent(x: &Dyadic, bits: u32) -> Option<Interval> {
    if x.is_zero() {
        return Some(Interval::integer(0));
    }
    if x.is_negative() {
        return Some(arctangent(&x.negated(), bits)?.negated());
    }
    let inner = bits + 16;
    let one = Interval::integer(1);
    let mut y = Interval::point(x.clone());
    let large = *x > Dyadic::integer(1);
    if large {
        y = one.divide(&y, inner)?;
    }
    // tan(a/2) = tan a / (1 + sqrt(1 + tan^2 a)).
    const HALVINGS: i64 = 2;
    for _ in 0..HALVINGS {
        let root = one.add(&y.power(2, inner), inner).root(2, inner)?;
        y = y.divide(&one.add(&root, inner), inner)?;
    }
    let y = y.increasing(|end| arctangent_series(end, inner))?;
    let angle = y.scaled(HALVINGS);
    Some(if large {
        pi(inner).scaled(-1).subtract(&angle, bits)
    } else {
        angle.rounded(bits)
    })
}

fn arctangent_series(x: &Dyadic, bits: u32) -> Option<Interval> {
    let small = x
        .magnitude()
        .map_or(0, |m| (-m).clamp(0, 4 * i64::from(bits)));
    let w = places_for(bits) + small;
    let z = x.fixed(w);
    let square = (&z * &z) >> w;
    let mut power = z;
    let mut sum = BigInt::zero();
    let mut j = 1u32;
    let mut minus = false;
    while !power.is_zero() {
        let term = &power / j;
        if minus {
            sum -= term;
        } else {
            sum += term;
        }
        minus = !minus;
        power = (&power * &square) >> w;
        j += 2;
    }
    let fixed = Fixed {
        units: sum,
        error: BigInt::from(4 * j + 12),
        places: w,
    };
    Some(fixed.interval(bits))
}

#[cfg(test)]
mod tests {
    use super::*;
    use num_rational::BigRational;

    fn shows(interval: &Interval, digits: &str, bits: u32) {
        let (whole, decimals) = digits.split_once('.').unwrap();
        let scale = num_traits::pow(BigInt::from(10), decimals.len());
        let known: BigInt = format!("{whole}{decimals}").parse().unwrap();
        let near = BigRational::new(known, scale.clone());
        let unit = BigRational::new(1.into(), scale);
        assert!(
            interval.low().to_rational() <= &near + &unit
                && &near - &unit <= interval.high().to_rational(),
            "{digits}"
        );
        assert!(interval.is_narrow(i64::from(bits) - 4), "{digits}");
    }

    /// Digits from M. Abramowitz & I. A. Stegun (1964), tables 1.1 and chapter 4.
    #[test]
    fn known_digits() {
        for bits in [64, 128, 512, 2048] {
            let at = |n: i64| Dyadic::integer(n);
            shows(&pi(bits), "3.14159265358979323846264", bits);
            shows(&ln_2(bits), "0.69314718055994530941723", bits);
            let e = exponential(&at(1), bits).unwrap();
            shows(&e, "2.71828182845904523536028", bits);
            let e = exponential(&at(-2), bits).unwrap();
            shows(&e, "0.13533528323661269189400", bits);
            let ln = logarithm(&at(10), bits).unwrap();
            shows(&ln, "2.30258509299404568401799", bits);
            let (cosine, sine) = cosine_and_sine(&at(1), bits).unwrap();
            shows(&cosine, "0.54030230586813971740094", bits);
            shows(&sine, "0.84147098480789650665250", bits);
            let angle = arctangent(&at(1), bits).unwrap();
            shows(&angle, "0.78539816339744830961566", bits);
        }
    }

    #[test]
    fn digits_agree_with_those_at_a_higher_precision() {
        let numbers = [
            (3i64, -1),
            (-7, -2),
            (1, -40),
            (-1, -200),
            (12345, -3),
            (-99999, -1),
            (1_000_003, 2),
            (5, -3),
            (1, 0),
            ((1i64 << 40) + 1, -40),
        ];
        for (m, e) in numbers {
            let x = Dyadic::new(BigInt::from(m), e);
            for bits in [40u32, 100, 300] {
                let check = |low: Option<Interval>, high: Option<Interval>| match (low, high) {
                    (Some(low), Some(high)) => {
                        assert!(low.includes(&high), "{m} 2^{e} at {bits}");
                        assert!(low.is_narrow(i64::from(bits) - 6), "{m} 2^{e} at {bits}");
                    }
                    (None, None) => {}
                    _ => panic!("a value at one precision only"),
                };
                let more = 4 * bits;
                check(exponential(&x, bits), exponential(&x, more));
                check(logarithm(&x, bits), logarithm(&x, more));
                check(arctangent(&x, bits), arctangent(&x, more));
                let (a, b) = (
                    cosine_and_sine(&x, bits).unwrap(),
                    cosine_and_sine(&x, more).unwrap(),
                );
                check(Some(a.0), Some(b.0));
                check(Some(a.1), Some(b.1));
            }
        }
    }

    #[test]
    fn exponential_and_logarithm_undo_each_other() {
        for n in [1i64, 2, 3, 17, 1000, -5, -300] {
            let x = Dyadic::new(n.into(), -3);
            let e = exponential(&x, 120).unwrap();
            let back = e.increasing(|end| logarithm(end, 120)).unwrap();
            assert!(back.contains(&x.to_rational()));
            assert!(back.is_narrow(100));
        }
    }

    #[test]
    fn an_argument_beyond_the_limit_is_refused() {
        let x = Dyadic::power_of_two(40);
        assert!(exponential(&x, 64).is_none() && cosine_and_sine(&x, 64).is_none());
    }
}
