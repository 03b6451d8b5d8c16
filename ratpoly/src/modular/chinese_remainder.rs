//! From residues back to integers and fractions.

use num_bigint::BigInt;
use num_integer::Integer;
use num_traits::{One, Signed, Zero};

use super::PrimeField;
use crate::integer_gcd::integer_gcd;

/// A vector of integers known modulo a growing product of primes, held as the residues of least absolute
/// value (Garner's mixed-radix step, one prime at a time).
#[derive(Clone, Debug)]
pub struct ChineseRemainder {
    modulus: BigInt,
    values: Vec<BigInt>,
}

impl ChineseRemainder {
    /// The vector known by its residues modulo one prime.
    pub fn new(field: &PrimeField, residues: &[u64]) -> ChineseRemainder {
        let values = residues
            .iter()
            .map(|&r| BigInt::from(field.to_i64(r)))
            .collect();
        ChineseRemainder {
            modulus: BigInt::from(field.modulus()),
            values,
        }
    }

    /// The product of the primes so far.
    pub fn modulus(&self) -> &BigInt {
        &self.modulus
    }

    /// The integers of least absolute value with the given residues.
    pub fn values(&self) -> &[BigInt] {
        &self.values
    }

    /// Adds the residues modulo another prime, and says whether any value changed: if none did, the
    /// values are likely the true ones.
    ///
    /// # Panics
    ///
    /// If the number of residues differs from before, or the prime was already used.
    pub fn add(&mut self, field: &PrimeField, residues: &[u64]) -> bool {
        assert_eq!(
            residues.len(),
            self.values.len(),
            "the vector keeps its length"
        );
        let inverse = field
            .inverse(field.from_bigint(&self.modulus))
            .expect("a prime that was not used before");
        let mut changed = false;
        for (value, &residue) in self.values.iter_mut().zip(residues) {
            let difference = field.sub(residue, field.from_bigint(value));
            if difference != 0 {
                changed = true;
                *value += &self.modulus * field.to_i64(field.mul(difference, inverse));
            }
        }
        self.modulus *= field.modulus();
        changed
    }
}

/// The fraction n/d with |n|, d ≤ √(m/2) and d coprime to m that is congruent to `a` modulo `m`, if there
/// is one; it is then unique. (P. S. Wang, *A p-adic algorithm for univariate partial fractions*, 1981.)
pub fn rational_reconstruction(a: &BigInt, m: &BigInt) -> Option<(BigInt, BigInt)> {
    let bound = (m / 2u32).sqrt();
    let (mut r0, mut r1) = (m.clone(), a.mod_floor(m));
    let (mut s0, mut s1) = (BigInt::zero(), BigInt::one());
    while r1 > bound {
        let (quotient, remainder) = r0.div_rem(&r1);
        (r0, r1) = (r1, remainder);
        let next = s0 - quotient * &s1;
        (s0, s1) = (s1, next);
    }
    if s1.is_zero()
        || s1.abs() > bound
        || !integer_gcd(&r1, &s1).is_one()
        || !integer_gcd(&s1, m).is_one()
    {
        return None;
    }
    if s1.is_negative() {
        Some((-r1, -s1))
    } else {
        Some((r1, s1))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::modular::two_adic_primes;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn integers_come_back(digits in prop::collection::vec(any::<i64>(), 0..5)) {
            let integer = digits.iter().fold(BigInt::zero(), |n, &d| (n << 64u32) + d);
            let integers = [integer.clone(), -integer, BigInt::zero(), BigInt::from(-1)];
            let mut known: Option<ChineseRemainder> = None;
            for p in two_adic_primes(32).take(7) {
                let field = PrimeField::new(p).unwrap();
                let residues: Vec<u64> = integers.iter().map(|n| field.from_bigint(n)).collect();
                match &mut known {
                    None => known = Some(ChineseRemainder::new(&field, &residues)),
                    Some(known) => { known.add(&field, &residues); }
                }
            }
            let known = known.unwrap();
            prop_assert_eq!(known.values(), integers);
        }

        #[test]
        fn fractions_come_back(n: i64, d in 1i64..) {
            let p = BigInt::from((1u64 << 61) - 1);
            let m = &p * &p * &p;
            let divisor = n.gcd(&d).max(1);
            let (n, d) = (BigInt::from(n / divisor), BigInt::from(d / divisor));
            let inverse = d.modpow(&(&p * &p * (&p - 1) - 1), &m);
            prop_assert_eq!(rational_reconstruction(&(&n * inverse), &m), Some((n, d)));
        }
    }

    #[test]
    fn what_is_no_small_fraction_is_refused() {
        let m = BigInt::from(101);
        let fractions: Vec<_> = (0..101)
            .filter_map(|a| rational_reconstruction(&a.into(), &m))
            .collect();
        assert!(fractions.len() < 101);
        for (n, d) in &fractions {
            assert!(n.abs() <= 7.into() && d <= &7.into() && d.is_positive());
        }
    }
}
