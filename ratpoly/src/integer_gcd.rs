//! The greatest common divisor of long integers by Lehmer's method (Lehmer 1938; Knuth, The Art of Computer
//! Programming, volume 2, 4.5.2, Algorithm L): the leading words decide the next quotients of Euclid's
//! algorithm, which are applied to the long operands all at once.
//!
//! The quotients make a matrix of determinant one or minus one. It keeps the greatest common divisor whatever
//! the leading words said; they only decide how fast the operands shrink.

use num_bigint::{BigInt, BigUint};
use num_integer::Integer as _;
use num_traits::ToPrimitive;

/// The bits of the leading parts. Cofactors have at most half as many and fit a word.
const LEADING: u64 = 126;

/// The nonnegative greatest common divisor.
pub(crate) fn integer_gcd(a: &BigInt, b: &BigInt) -> BigInt {
    if let (Some(a), Some(b)) = (a.magnitude().to_u64(), b.magnitude().to_u64()) {
        return a.gcd(&b).into();
    }
    magnitude_gcd(a.magnitude(), b.magnitude()).into()
}

fn magnitude_gcd(a: &BigUint, b: &BigUint) -> BigUint {
    let (mut a, mut b) = if a >= b {
        (a.clone(), b.clone())
    } else {
        (b.clone(), a.clone())
    };
    // Always a >= b.
    loop {
        if let Some(small) = b.to_u64() {
            return match small {
                0 => a,
                small => small.gcd(&(&a % small).to_u64().unwrap_or(0)).into(),
            };
        }
        let shift = a.bits().saturating_sub(LEADING);
        let [p, q, r, s] = quotients(leading(&a, shift), leading(&b, shift));
        if q == 0 {
            let remainder = &a % &b;
            (a, b) = (b, remainder);
        } else {
            (a, b) = (difference(&a * p, &b * q), difference(&a * r, &b * s));
            if a < b {
                (a, b) = (b, a);
            }
        }
    }
}

fn difference(a: BigUint, b: BigUint) -> BigUint {
    if a >= b { a - b } else { b - a }
}

/// The value shifted right, where at most [`LEADING`] bits are left.
fn leading(value: &BigUint, shift: u64) -> u128 {
    let (skip, shift) = ((shift / 64) as usize, (shift % 64) as u32);
    let mut digits = value.iter_u64_digits().skip(skip);
    let mut next = || u128::from(digits.next().unwrap_or(0));
    let (low, middle, high) = (next(), next(), next());
    let pair = (middle << 64 | low) >> shift;
    if shift == 0 {
        pair
    } else {
        pair | high << (128 - shift)
    }
}

/// Euclid's algorithm on leading parts x >= y as far as the long operands would take the same quotients
/// (Collins's condition): `[p, q, r, s]`, so that the operands become `|p x - q y|` and `|r x - s y|`. With
/// q = 0 not even the first quotient is sure.
fn quotients(mut x: u128, mut y: u128) -> [u64; 4] {
    let [mut p, mut q, mut r, mut s] = [1u64, 0, 0, 1];
    while y != 0 {
        let (quotient, remainder) = match x - y {
            // Two of five quotients are one.
            rest if rest < y => (1, rest),
            _ => x.div_rem(&y),
        };
        let next = |old: u64, new: u64| -> Option<u64> {
            let step = u64::try_from(quotient).ok()?.checked_mul(new)?;
            old.checked_add(step)
        };
        let (Some(u), Some(v)) = (next(p, r), next(q, s)) else {
            break;
        };
        if remainder < u128::from(v) || y - remainder < u128::from(v) + u128::from(s) {
            break;
        }
        (x, y) = (y, remainder);
        (p, q, r, s) = (r, s, u, v);
    }
    [p, q, r, s]
}

#[cfg(test)]
mod tests {
    use super::*;
    use num_traits::{One, Zero};

    /// Pseudo-random integers of up to so many bits, of either sign.
    fn integers(bits: u64) -> impl Iterator<Item = BigInt> {
        let mut state = 1u64;
        let mut word = move || {
            state = state
                .wrapping_mul(6364136223846793005)
                .wrapping_add(1442695040888963407);
            state >> 32
        };
        std::iter::repeat_with(move || {
            let length = word() % bits + 1;
            let value = (0..length / 32).fold(BigInt::one(), |v, _| v << 32 | BigInt::from(word()));
            if word() % 2 == 0 { value } else { -value }
        })
    }

    #[test]
    fn agrees_with_the_plain_definition() {
        for bits in [40, 200, 3000] {
            let mut values = integers(bits);
            for _ in 0..300 {
                let mut next = || values.next().expect("endless");
                let (a, b, c) = (next(), next(), next());
                for (a, b) in [(a.clone(), b.clone()), (&a * &c, &b * &c), (&a * &b, b)] {
                    assert_eq!(integer_gcd(&a, &b), a.gcd(&b), "{a} {b}");
                }
            }
        }
    }

    /// Zeros, equal operands, powers of two, neighbours, Fibonacci numbers (all quotients are one), and
    /// quotients that fill a word or more.
    #[test]
    fn special_operands() {
        let one = BigInt::one();
        let power = |k: u32| &one << k;
        let mut values = vec![BigInt::zero(), one.clone(), -&one];
        for k in [31, 32, 62, 63, 64, 65, 126, 127, 128, 129, 192, 1000] {
            values.extend([power(k), power(k) - 1, power(k) + 1, -power(k)]);
        }
        let (mut f, mut g) = (BigInt::zero(), one.clone());
        for k in 0..400 {
            (f, g) = (g.clone(), f + g);
            if k % 37 == 0 {
                values.extend([
                    f.clone(),
                    g.clone(),
                    &g * power(64) + &f,
                    &g * power(130) + 1,
                ]);
            }
        }
        for a in &values {
            for b in &values {
                assert_eq!(integer_gcd(a, b), a.gcd(b), "{a} {b}");
            }
        }
    }
}
