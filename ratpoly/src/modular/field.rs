//! The field of integers modulo an odd prime below 2⁶².
//!
//! Elements are `u64` in Montgomery form: the residue a is stored as a·R mod p with R = 2⁶⁴, so that a
//! product costs three multiplications and no division (P. L. Montgomery, *Modular multiplication without
//! trial division*, 1985). The form of 0 is 0, and every stored element is below p, so elements compare
//! with `==`. The bound 2⁶² leaves room to add fifteen products before reducing.

use num_bigint::{BigInt, Sign};

/// The field of integers modulo an odd prime below 2⁶²; see the module's description.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct PrimeField {
    modulus: u64,
    /// The inverse of the modulus modulo 2⁶⁴.
    inverse: u64,
    /// R mod p, the form of 1.
    one: u64,
    /// R² mod p, which brings a residue into Montgomery form.
    radix_squared: u64,
}

impl PrimeField {
    /// The field of `modulus` elements. The modulus must be an odd prime below 2⁶²; that it is prime is
    /// not checked here (see [`is_prime`](super::is_prime)).
    ///
    /// Returns `None` when the modulus is even, below 3 or not below 2⁶².
    pub const fn new(modulus: u64) -> Option<PrimeField> {
        if modulus & 1 == 0 || modulus < 3 || modulus >> 62 != 0 {
            return None;
        }
        // Newton's iteration doubles the correct low bits: 3, 6, 12, 24, 48, 96.
        let mut inverse = modulus;
        let mut step = 0;
        while step < 5 {
            inverse = inverse.wrapping_mul(2u64.wrapping_sub(modulus.wrapping_mul(inverse)));
            step += 1;
        }
        let one = ((1u128 << 64) % modulus as u128) as u64;
        let radix_squared = ((one as u128 * one as u128) % modulus as u128) as u64;
        Some(PrimeField {
            modulus,
            inverse,
            one,
            radix_squared,
        })
    }

    /// The prime.
    pub const fn modulus(&self) -> u64 {
        self.modulus
    }

    /// The element 1.
    #[inline]
    pub const fn one(&self) -> u64 {
        self.one
    }

    /// a·b/R for a number `product` = a·b below p·2⁶⁴.
    #[inline(always)]
    pub const fn reduce(&self, product: u128) -> u64 {
        let quotient = (product as u64).wrapping_mul(self.inverse);
        let correction = ((quotient as u128 * self.modulus as u128) >> 64) as u64;
        let (difference, borrow) = ((product >> 64) as u64).overflowing_sub(correction);
        if borrow {
            difference.wrapping_add(self.modulus)
        } else {
            difference
        }
    }

    /// a·b. One factor may be any `u64` (not only an element) when the other is an element.
    #[inline(always)]
    pub const fn mul(&self, a: u64, b: u64) -> u64 {
        self.reduce(a as u128 * b as u128)
    }

    /// a + b.
    #[inline(always)]
    pub const fn add(&self, a: u64, b: u64) -> u64 {
        let sum = a + b;
        if sum >= self.modulus {
            sum - self.modulus
        } else {
            sum
        }
    }

    /// a - b.
    #[inline(always)]
    pub const fn sub(&self, a: u64, b: u64) -> u64 {
        let (difference, borrow) = a.overflowing_sub(b);
        if borrow {
            difference.wrapping_add(self.modulus)
        } else {
            difference
        }
    }

    /// -a.
    #[inline(always)]
    pub const fn neg(&self, a: u64) -> u64 {
        if a == 0 { 0 } else { self.modulus - a }
    }

    /// a·b - c·d with one reduction.
    #[inline(always)]
    pub const fn mul_sub_mul(&self, a: u64, b: u64, c: u64, d: u64) -> u64 {
        self.reduce(a as u128 * b as u128 + (self.modulus - c) as u128 * d as u128)
    }

    /// a^exponent.
    pub const fn pow(&self, a: u64, mut exponent: u64) -> u64 {
        let (mut power, mut square) = (self.one, a);
        while exponent != 0 {
            if exponent & 1 == 1 {
                power = self.mul(power, square);
            }
            exponent >>= 1;
            if exponent != 0 {
                square = self.mul(square, square);
            }
        }
        power
    }

    /// 1/a, or `None` for zero.
    pub fn inverse(&self, a: u64) -> Option<u64> {
        // Euclid on the stored form a·R gives 1/(a·R); two multiplications by R² lift it to R/a.
        let (mut r0, mut r1) = (self.modulus, a);
        let (mut s0, mut s1) = (0i64, 1i64);
        while r1 != 0 {
            let quotient = r0 / r1;
            (r0, r1) = (r1, r0 - quotient * r1);
            (s0, s1) = (s1, s0.wrapping_sub((quotient as i64).wrapping_mul(s1)));
        }
        if r0 != 1 {
            return None;
        }
        let residue = if s0 < 0 {
            s0.wrapping_add(self.modulus as i64)
        } else {
            s0
        } as u64;
        Some(self.mul(self.mul(residue, self.radix_squared), self.radix_squared))
    }

    /// Replaces every element by its inverse with one inversion in all; `false` (and nothing changed)
    /// when one of them is zero. (P. L. Montgomery, 1987.)
    pub fn invert_all(&self, elements: &mut [u64]) -> bool {
        let mut prefix = Vec::with_capacity(elements.len());
        let mut product = self.one;
        for &element in elements.iter() {
            prefix.push(product);
            product = self.mul(product, element);
        }
        let Some(mut inverse) = self.inverse(product) else {
            return false;
        };
        for (element, before) in elements.iter_mut().zip(prefix).rev() {
            let next = self.mul(inverse, *element);
            *element = self.mul(inverse, before);
            inverse = next;
        }
        true
    }

    /// The element of an unsigned machine integer.
    #[inline]
    pub const fn from_u64(&self, integer: u64) -> u64 {
        self.mul(integer, self.radix_squared)
    }

    /// The element of a signed machine integer.
    #[inline]
    pub const fn from_i64(&self, integer: i64) -> u64 {
        let magnitude = self.from_u64(integer.unsigned_abs());
        if integer < 0 {
            self.neg(magnitude)
        } else {
            magnitude
        }
    }

    /// The element of an integer of any size.
    pub fn from_bigint(&self, integer: &BigInt) -> u64 {
        let mut magnitude = 0;
        for digit in integer.magnitude().iter_u64_digits().rev() {
            magnitude = self.add(
                self.mul(magnitude, self.radix_squared),
                self.from_u64(digit),
            );
        }
        if integer.sign() == Sign::Minus {
            self.neg(magnitude)
        } else {
            magnitude
        }
    }

    /// The residue in 0..p.
    #[inline]
    pub const fn to_u64(&self, a: u64) -> u64 {
        self.reduce(a as u128)
    }

    /// The residue of least absolute value, in -(p-1)/2 ..= (p-1)/2.
    #[inline]
    pub const fn to_i64(&self, a: u64) -> i64 {
        let residue = self.to_u64(a);
        if residue > self.modulus / 2 {
            residue as i64 - self.modulus as i64
        } else {
            residue as i64
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use num_bigint::BigInt;
    use proptest::prelude::*;

    const PRIMES: [u64; 5] = [3, 65537, 2147483647, (1 << 61) - 1, (1 << 62) - 57];

    #[test]
    fn moduli_outside_the_range_are_refused() {
        for modulus in [0, 1, 2, 4, 1 << 62, u64::MAX] {
            assert_eq!(PrimeField::new(modulus), None);
        }
    }

    proptest! {
        #[test]
        fn agrees_with_the_plain_definition(a: u64, b: u64, c: i64, which in 0usize..5) {
            let p = PRIMES[which];
            let field = PrimeField::new(p).unwrap();
            let (x, y) = (field.from_u64(a), field.from_u64(b));
            let wide = u128::from(p);
            let (a, b) = (u128::from(a), u128::from(b));
            prop_assert_eq!(u128::from(field.to_u64(field.add(x, y))), (a + b) % wide);
            prop_assert_eq!(u128::from(field.to_u64(field.mul(x, y))), (a % wide) * (b % wide) % wide);
            prop_assert_eq!(field.add(field.sub(x, y), y), x);
            prop_assert_eq!(field.add(field.neg(x), x), 0);
            prop_assert_eq!(field.mul_sub_mul(x, y, y, x), 0);
            prop_assert_eq!(field.mul_sub_mul(x, y, 0, x), field.mul(x, y));
            match field.inverse(x) {
                Some(inverse) => prop_assert_eq!(field.mul(inverse, x), field.one()),
                None => prop_assert_eq!(x, 0),
            }
            let signed = field.from_i64(c);
            prop_assert_eq!((i128::from(field.to_i64(signed)) - i128::from(c)) % i128::from(p), 0);
            prop_assert_eq!(field.from_bigint(&BigInt::from(c)), signed);
            let large = BigInt::from(a) * BigInt::from(b) * BigInt::from(c);
            prop_assert_eq!(field.from_bigint(&large), field.mul(field.mul(x, y), signed));
        }

        #[test]
        fn powers_and_batches(a: u64, exponent in 0u64..200, which in 0usize..5) {
            let field = PrimeField::new(PRIMES[which]).unwrap();
            let x = field.from_u64(a);
            let plain = (0..exponent).fold(field.one(), |power, _| field.mul(power, x));
            prop_assert_eq!(field.pow(x, exponent), plain);
            let mut batch: Vec<u64> = (1..20).map(|i| field.from_u64(a.wrapping_mul(i) | 1)).collect();
            let before = batch.clone();
            if field.invert_all(&mut batch) {
                for (x, y) in batch.iter().zip(&before) {
                    prop_assert_eq!(field.mul(*x, *y), field.one());
                }
            } else {
                prop_assert!(before.contains(&0));
                prop_assert_eq!(batch, before);
            }
        }
    }
}
