//! Elementary functions of intervals: by their values at the ends where they are monotone, and with
//! the extreme values that lie between.

use super::dyadic::Dyadic;
use super::interval::Interval;
use super::series;
use num_bigint::BigInt;
use num_traits::{One, ToPrimitive};

/// Digits beyond those asked for.
const GUARD: u32 = 16;
/// Angles in an interval with more quarter turns than this take every value.
const QUARTERS: i64 = 5;

/// e^x, which increases.
pub fn exponential(x: &Interval, bits: u32) -> Option<Interval> {
    x.increasing(|end| series::exponential(end, bits))
}

/// ln x, which increases; none where x may not be positive.
pub fn logarithm(x: &Interval, bits: u32) -> Option<Interval> {
    x.increasing(|end| series::logarithm(end, bits))
}

/// arctan x, which increases.
pub fn arctangent(x: &Interval, bits: u32) -> Option<Interval> {
    x.increasing(|end| series::arctangent(end, bits))
}

/// cos x and sin x.
pub fn cosine_and_sine(x: &Interval, bits: u32) -> Option<(Interval, Interval)> {
    let (cosine, sine) = series::cosine_and_sine(x.low(), bits)?;
    if x.single().is_some() {
        return Some((cosine, sine));
    }
    let (c, s) = series::cosine_and_sine(x.high(), bits)?;
    let (mut cosine, mut sine) = (cosine.hull(&c), sine.hull(&s));
    // Extreme values are taken at multiples of a quarter turn; which of them lie within is seen from
    // the ends in quarters, where one too many does no harm.
    let digits = bits + GUARD;
    let quarter = series::pi(digits).scaled(-1);
    let first = Interval::point(x.low().clone()).divide(&quarter, digits)?;
    let last = Interval::point(x.high().clone()).divide(&quarter, digits)?;
    let from = first.low().fixed(0);
    let to = last.high().fixed(0) + BigInt::one();
    let all = || Interval::between(Dyadic::integer(-1), Dyadic::integer(1));
    if &to - &from > BigInt::from(QUARTERS + 1) {
        return Some((all(), all()));
    }
    let mut k = from;
    while k <= to {
        let at = Dyadic::new(k.clone(), 0);
        if *first.low() <= at && at <= *last.high() {
            let value = |n: i64| Interval::integer(n);
            match (&k & BigInt::from(3)).to_u8()? {
                0 => cosine = cosine.hull(&value(1)),
                1 => sine = sine.hull(&value(1)),
                2 => cosine = cosine.hull(&value(-1)),
                _ => sine = sine.hull(&value(-1)),
            }
        }
        k += 1;
    }
    Some((cosine, sine))
}

/// tan x, which increases between its poles; none where a pole may lie within.
pub fn tangent(x: &Interval, bits: u32) -> Option<Interval> {
    let (cosine, _) = cosine_and_sine(x, bits)?;
    if cosine.contains_zero() {
        return None;
    }
    x.increasing(|end| {
        let (cosine, sine) = series::cosine_and_sine(end, bits + GUARD)?;
        sine.divide(&cosine, bits)
    })
}

/// e^x and e^-x at a single number, with as many digits more as sinh x has zeros in front.
fn both_exponentials(x: &Dyadic, bits: u32) -> Option<(Interval, Interval, u32)> {
    let small = x
        .magnitude()
        .map_or(0, |m| (-m).clamp(0, 4 * i64::from(bits)));
    let digits = bits + GUARD + u32::try_from(small).ok()?;
    let up = series::exponential(x, digits)?;
    let down = Interval::integer(1).divide(&up, digits)?;
    Some((up, down, digits))
}

/// sinh x, which increases.
pub fn hyperbolic_sine(x: &Interval, bits: u32) -> Option<Interval> {
    x.increasing(|end| {
        if end.is_zero() {
            return Some(Interval::integer(0));
        }
        let (up, down, digits) = both_exponentials(end, bits)?;
        Some(up.subtract(&down, digits).scaled(-1).rounded(bits))
    })
}

/// cosh x, which increases with |x|.
pub fn hyperbolic_cosine(x: &Interval, bits: u32) -> Option<Interval> {
    x.absolute().increasing(|end| {
        if end.is_zero() {
            return Some(Interval::integer(1));
        }
        let (up, down, digits) = both_exponentials(end, bits)?;
        Some(up.add(&down, digits).scaled(-1).rounded(bits))
    })
}

/// tanh x, which increases.
pub fn hyperbolic_tangent(x: &Interval, bits: u32) -> Option<Interval> {
    x.increasing(|end| {
        if end.is_zero() {
            return Some(Interval::integer(0));
        }
        let (up, down, digits) = both_exponentials(end, bits)?;
        up.subtract(&down, digits)
            .divide(&up.add(&down, digits), bits)
    })
}

/// arcsin x = arctan(x / sqrt(1 - x^2)) for -1 < x < 1, which increases; none where |x| may be one.
pub fn arcsine(x: &Interval, bits: u32) -> Option<Interval> {
    x.increasing(|end| {
        let digits = bits + GUARD;
        let x = Interval::point(end.clone());
        let rest = Interval::integer(1).subtract(&x.power(2, 4 * digits), 4 * digits);
        let tangent = x.divide(&rest.root(2, digits)?, digits)?;
        arctangent(&tangent, bits)
    })
}

/// arccos x = pi/2 - arcsin x for -1 < x < 1.
pub fn arccosine(x: &Interval, bits: u32) -> Option<Interval> {
    let digits = bits + GUARD;
    let quarter = series::pi(digits).scaled(-1);
    Some(quarter.subtract(&arcsine(x, digits)?, bits))
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    /// An interval and a number in it.
    fn sample() -> impl Strategy<Value = (Interval, Dyadic)> {
        (-6000i64..6000, 0i64..4000, 0i64..=16, 2i64..12).prop_map(|(from, by, part, scale)| {
            let at = |n: i64| Dyadic::new(n.into(), -4 - scale);
            let low = at(16 * from);
            let high = at(16 * (from + by));
            (Interval::between(low, high), at(16 * from + part * by))
        })
    }

    fn unite(x: Option<Interval>, y: Option<Interval>) -> (Interval, Interval) {
        (x.unwrap(), y.unwrap())
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(64))]
        #[test]
        fn a_wide_interval_holds_the_values_within((wide, x) in sample(), bits in 30u32..90) {
            let single = Interval::point(x);
            prop_assert!(wide.includes(&single));
            let overlaps = |(a, b): (Interval, Interval)| !a.is_apart_from(&b);
            let pairs: Vec<fn(&Interval, u32) -> Option<Interval>> =
                vec![exponential, arctangent, hyperbolic_sine, hyperbolic_cosine, hyperbolic_tangent];
            for f in pairs {
                let (a, b) = unite(f(&wide, bits), f(&single, 3 * bits));
                prop_assert!(a.includes(&b) || overlaps((a, b)));
            }
            let (c, s) = cosine_and_sine(&wide, bits).unwrap();
            let (d, t) = cosine_and_sine(&single, 3 * bits).unwrap();
            prop_assert!(c.includes(&d) && s.includes(&t));
            if let Some(tangent_of_all) = tangent(&wide, bits) {
                prop_assert!(tangent_of_all.includes(&tangent(&single, 3 * bits).unwrap()));
            }
            if let Some(all) = logarithm(&wide, bits) {
                prop_assert!(all.includes(&logarithm(&single, 3 * bits).unwrap()));
            }
        }

        #[test]
        fn identities_overlap((_, x) in sample(), (_, y) in sample(), bits in 40u32..120) {
            let (x, y) = (Interval::point(x), Interval::point(y));
            let sum = x.add(&y, 400);
            let (cx, sx) = cosine_and_sine(&x, bits).unwrap();
            let (cy, sy) = cosine_and_sine(&y, bits).unwrap();
            let (_, s) = cosine_and_sine(&sum, bits).unwrap();
            let formula = sx.multiply(&cy, bits).add(&cx.multiply(&sy, bits), bits);
            prop_assert!(!s.is_apart_from(&formula));
            prop_assert!(s.subtract(&formula, bits).largest() < Dyadic::power_of_two(6 - i64::from(bits)));
            let one = cx.power(2, bits).add(&sx.power(2, bits), bits);
            prop_assert!(one.contains(&num_traits::One::one()));
            let product = exponential(&x, bits).unwrap().multiply(&exponential(&y, bits).unwrap(), bits);
            prop_assert!(!product.is_apart_from(&exponential(&sum, bits).unwrap()));
            let (sinh, cosh) = unite(hyperbolic_sine(&x, bits), hyperbolic_cosine(&x, bits));
            let e = exponential(&x, bits).unwrap();
            prop_assert!(!sinh.add(&cosh, bits).is_apart_from(&e));
            let angle = arctangent(&x, bits).unwrap();
            let back = tangent(&angle, bits);
            prop_assert!(back.is_none_or(|t| !t.is_apart_from(&x)));
        }
    }

    #[test]
    fn arcsine_undoes_sine() {
        for n in [-9i64, -4, 0, 1, 5, 11] {
            let x = Interval::point(Dyadic::new(n.into(), -3));
            let (_, sine) = cosine_and_sine(&x, 120).unwrap();
            let back = arcsine(&sine, 100).unwrap();
            assert!(
                !back.is_apart_from(&x)
                    && back.widened(&Dyadic::power_of_two(-80), 100).includes(&x)
            );
            let sum = back.add(&arccosine(&sine, 100).unwrap(), 100).scaled(1);
            assert!(!sum.is_apart_from(&series::pi(100)));
        }
    }
}
