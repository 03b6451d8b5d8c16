//! Arithmetic of short fractions in machine words.
//!
//! The greatest common divisors of long integers cost more than all else; fractions whose numerator
//! and denominator fit into a word are added and multiplied without them. Invariant: the results are in
//! lowest terms with positive denominators, as those of the long way are.

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, ToPrimitive, Zero};

/// Numerator and denominator, each below 2^62 in absolute value, so that sums of products of two fit
/// into 128 bits.
fn short(x: &BigRational) -> Option<(i128, i128)> {
    let part = |n: &BigInt| n.to_i64().filter(|n| n.unsigned_abs() < 1 << 62);
    Some((part(x.numer())?.into(), part(x.denom())?.into()))
}

/// Euclid's algorithm.
fn divisor(mut a: u128, mut b: u128) -> u128 {
    while b != 0 {
        // Half of the work is done by the short division.
        if let (Ok(mut x), Ok(mut y)) = (u64::try_from(a), u64::try_from(b)) {
            while y != 0 {
                (x, y) = (y, x % y);
            }
            return x.into();
        }
        (a, b) = (b, a % b);
    }
    a
}

fn reduced(numerator: i128, denominator: i128) -> BigRational {
    if numerator == 0 {
        return BigRational::zero();
    }
    let common = divisor(numerator.unsigned_abs(), denominator.unsigned_abs());
    let part = |n: i128| -> BigInt {
        let magnitude = BigInt::from(n.unsigned_abs() / common);
        if (n < 0) != (denominator < 0) {
            -magnitude
        } else {
            magnitude
        }
    };
    let below = BigInt::from(denominator.unsigned_abs() / common);
    BigRational::new_raw(part(numerator), below)
}

/// `a + b`.
pub(super) fn sum(a: &BigRational, b: &BigRational) -> BigRational {
    if a.denom().is_one() && b.denom().is_one() {
        return BigRational::from_integer(a.numer() + b.numer());
    }
    match (short(a), short(b)) {
        (Some((n, d)), Some((m, e))) => reduced(n * e + m * d, d * e),
        _ => a + b,
    }
}

/// `a b`.
pub(super) fn product(a: &BigRational, b: &BigRational) -> BigRational {
    if a.denom().is_one() && b.denom().is_one() {
        return BigRational::from_integer(a.numer() * b.numer());
    }
    match (short(a), short(b)) {
        (Some((n, d)), Some((m, e))) => reduced(n * m, d * e),
        _ => a * b,
    }
}

/// `a / b` for b other than zero.
pub(super) fn quotient(a: &BigRational, b: &BigRational) -> BigRational {
    match (short(a), short(b)) {
        (Some((n, d)), Some((m, e))) => reduced(n * e, d * m),
        _ => a / b,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn fraction() -> impl Strategy<Value = BigRational> {
        let wide = any::<i64>().prop_flat_map(|n| (Just(n), 0u32..64));
        (wide, 1i64..=i64::MAX, 0u32..63)
            .prop_map(|((n, s), d, t)| BigRational::new((n >> s).into(), ((d >> t).max(1)).into()))
    }

    proptest! {
        #[test]
        fn as_the_long_way(a in fraction(), b in fraction()) {
            prop_assert_eq!(sum(&a, &b), &a + &b);
            prop_assert_eq!(product(&a, &b), &a * &b);
            if !b.is_zero() {
                let q = quotient(&a, &b);
                let long = &a / &b;
                prop_assert_eq!(q.numer(), long.numer());
                prop_assert_eq!(q.denom(), long.denom());
            }
        }
    }
}
