//! Values of a polynomial at points: over the rationals, the integers, and modulo a word.

use crate::error::Error;
use crate::polynomial::Polynomial;
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Zero};

impl Polynomial {
    /// The value at a rational point, one coordinate for each variable.
    pub fn evaluate(&self, point: &[BigRational]) -> Result<BigRational, Error> {
        // On a common denominator d_i in each variable the sum stays within the integers.
        self.check_point(point.len())?;
        let degrees = self.degrees();
        let mut sum = BigInt::zero();
        let tables: Vec<(Vec<BigInt>, Vec<BigInt>)> = point
            .iter()
            .zip(&degrees)
            .map(|(x, &d)| (powers(x.numer(), d), powers(x.denom(), d)))
            .collect();
        self.for_each_term(|exponents, c| {
            let mut value = c.to_big();
            for ((&e, &d), (n, q)) in exponents.iter().zip(&degrees).zip(&tables) {
                value = value * &n[e as usize] * &q[(d - e) as usize];
            }
            sum += value;
        });
        let mut denominator = BigInt::one();
        for (&d, (_, q)) in degrees.iter().zip(&tables) {
            denominator *= &q[d as usize];
        }
        Ok(BigRational::new(sum, denominator))
    }

    /// The value at an integer point.
    pub fn evaluate_integers(&self, point: &[BigInt]) -> Result<BigInt, Error> {
        self.check_point(point.len())?;
        let degrees = self.degrees();
        let tables: Vec<_> = point
            .iter()
            .zip(&degrees)
            .map(|(x, &d)| powers(x, d))
            .collect();
        let mut sum = BigInt::zero();
        self.for_each_term(|exponents, c| {
            let mut value = c.to_big();
            for (&e, table) in exponents.iter().zip(&tables) {
                if e > 0 {
                    value *= &table[e as usize];
                }
            }
            sum += value;
        });
        Ok(sum)
    }

    /// The value modulo `modulus` at a point of residues.
    pub fn evaluate_mod(&self, point: &[u64], modulus: u64) -> Result<u64, Error> {
        self.check_point(point.len())?;
        if modulus == 0 {
            return Err(Error::DivisionByZero);
        }
        let mul = |a: u64, b: u64| (u128::from(a) * u128::from(b) % u128::from(modulus)) as u64;
        let mut sum = 0u64;
        self.for_each_term(|exponents, c| {
            let mut value = c.residue(modulus);
            for (&e, &x) in exponents.iter().zip(point) {
                let (mut base, mut e) = (x % modulus, e);
                while e > 0 {
                    if e & 1 == 1 {
                        value = mul(value, base);
                    }
                    base = mul(base, base);
                    e >>= 1;
                }
            }
            sum = ((u128::from(sum) + u128::from(value)) % u128::from(modulus)) as u64;
        });
        Ok(sum)
    }

    fn check_point(&self, found: usize) -> Result<(), Error> {
        let expected = self.ring().len();
        if found == expected {
            Ok(())
        } else {
            Err(Error::WrongLength { expected, found })
        }
    }
}

/// The powers `0..=degree`.
fn powers(base: &BigInt, degree: u32) -> Vec<BigInt> {
    let mut table = vec![BigInt::one()];
    for k in 0..degree as usize {
        let next = &table[k] * base;
        table.push(next);
    }
    table
}
