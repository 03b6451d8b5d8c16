//! Deterministic sequences of primes.

use super::PrimeField;

/// Whether `n` is prime: the Miller-Rabin test with the first twelve primes as bases, which is a proof
/// for every n below 2⁶⁴ (J. Sorenson and J. Webster, *Strong pseudoprimes to twelve prime bases*, 2017).
/// Numbers from 2⁶² on are beyond [`PrimeField`] and are answered by the same test in plain arithmetic.
pub fn is_prime(n: u64) -> bool {
    const BASES: [u64; 12] = [2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31, 37];
    if n < 2 {
        return false;
    }
    if let Some(&divisor) = BASES.iter().find(|&&base| n.is_multiple_of(base)) {
        return n == divisor;
    }
    let twos = (n - 1).trailing_zeros();
    let odd = (n - 1) >> twos;
    match PrimeField::new(n) {
        Some(field) => {
            let minus_one = field.neg(field.one());
            passes(
                &BASES,
                field.one(),
                minus_one,
                twos,
                |b| field.pow(field.from_u64(b), odd),
                |a| field.mul(a, a),
            )
        }
        None => {
            let square = |a: u64| (u128::from(a) * u128::from(a) % u128::from(n)) as u64;
            let power = |base: u64| {
                let mut result = 1;
                for bit in (0..64 - odd.leading_zeros()).rev() {
                    result = square(result);
                    if odd >> bit & 1 == 1 {
                        result = (u128::from(result) * u128::from(base) % u128::from(n)) as u64;
                    }
                }
                result
            };
            passes(&BASES, 1, n - 1, twos, power, square)
        }
    }
}

/// Whether n is a strong probable prime to every base; `power(b)` is b^odd where n - 1 = 2^twos · odd.
fn passes(
    bases: &[u64],
    one: u64,
    minus_one: u64,
    twos: u32,
    power: impl Fn(u64) -> u64,
    square: impl Fn(u64) -> u64,
) -> bool {
    bases.iter().all(|&base| {
        let mut value = power(base);
        if value == one || value == minus_one {
            return true;
        }
        for _ in 1..twos {
            value = square(value);
            if value == minus_one {
                return true;
            }
        }
        false
    })
}

/// The odd primes below `bound`, from the greatest down.
pub fn primes_below(bound: u64) -> impl Iterator<Item = u64> {
    (3..bound).rev().filter(|&n| n & 1 == 1 && is_prime(n))
}

/// The primes c·2^k + 1 below 2⁶², from the greatest down. Their multiplicative group has a subgroup of
/// order 2^k, in which discrete logarithms are easy.
///
/// For k = 32 there are some fifty million of them, for k = 50 about a hundred.
pub fn two_adic_primes(k: u32) -> impl Iterator<Item = u64> {
    let greatest = if k < 62 { (1u64 << (62 - k)) - 1 } else { 0 };
    (1..=greatest)
        .rev()
        .map(move |c| (c << k) + 1)
        .filter(|&n| is_prime(n))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn agrees_with_trial_division() {
        for n in 0..5000u64 {
            let plain = n >= 2 && (2..n).take_while(|d| d * d <= n).all(|d| n % d != 0);
            assert_eq!(is_prime(n), plain, "{n}");
        }
    }

    #[test]
    fn strong_pseudoprimes_and_known_primes() {
        // psi_4 .. psi_11: the least strong pseudoprimes to the first bases (OEIS A014233).
        for n in [
            3215031751,
            2152302898747,
            3474749660383,
            341550071728321,
            3825123056546413051,
        ] {
            assert!(!is_prime(n), "{n}");
        }
        // 2^61 - 1 is a Mersenne prime; 2^64 - 59 is the greatest prime below 2^64.
        assert!(is_prime((1 << 61) - 1) && is_prime(u64::MAX - 58));
        assert!(!is_prime(u64::MAX - 56) && !is_prime(4294967291 * 4294967279));
    }

    #[test]
    fn sequences_descend_and_have_their_shape() {
        assert_eq!(
            primes_below(20).collect::<Vec<_>>(),
            [19, 17, 13, 11, 7, 5, 3]
        );
        for k in [32, 50] {
            let primes: Vec<u64> = two_adic_primes(k).take(20).collect();
            assert!(primes.windows(2).all(|pair| pair[0] > pair[1]));
            assert!(
                primes
                    .iter()
                    .all(|p| p % (1 << k) == 1 && is_prime(*p) && p >> 62 == 0)
            );
        }
    }
}
