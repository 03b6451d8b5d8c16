//! Hensel's lemma: a factorisation modulo p lifted to a power of p, digit by digit.
//!
//! A digit has 62 bits here, so that few steps are needed; each solves Σ δᵢ·Π_{j≠i} gⱼ = e modulo p with
//! inverses that are computed once. (H. Zassenhaus, *On Hensel factorization I*, 1969, in its linear form.)

use num_bigint::BigInt;
use num_integer::Integer;
use num_traits::{One, Zero};

use super::{integer, modular as dense};
use crate::budget::Budget;
use crate::error::Error;
use crate::modular::PrimeField;

/// Lifts the factorisation f ≡ lc(f)·Π gᵢ modulo p into monic factors, with coefficients of least
/// absolute value, modulo the least power of p above `bound`; returns them and that power.
///
/// The gᵢ must be monic and pairwise coprime modulo p, and p must not divide lc(f).
pub fn lift(
    field: &PrimeField,
    f: &[BigInt],
    factors: &[Vec<u64>],
    bound: &BigInt,
    budget: &Budget,
) -> Result<(Vec<Vec<BigInt>>, BigInt), Error> {
    let p = BigInt::from(field.modulus());
    let to_integer = |g: &Vec<u64>| {
        g.iter()
            .map(|&c| BigInt::from(field.to_i64(c)))
            .collect::<Vec<_>>()
    };
    let mut lifted: Vec<Vec<BigInt>> = factors.iter().map(to_integer).collect();
    let mut modulus = p.clone();
    if modulus > *bound {
        return Ok((lifted, modulus));
    }
    let Some(inverses) = cofactor_inverses(field, factors) else {
        return Err(Error::Unsupported("the modular factors are not coprime"));
    };
    let leading = f.last().expect("not zero");
    let steps = (f.len() * f.len()) as u64;
    while modulus <= *bound {
        budget.spend(steps)?;
        budget.check_bits(modulus.bits())?;
        // e = (f - lc·Π gᵢ) / p^k modulo p, brought to the monic form.
        let higher = &modulus * &p;
        let product = lifted.iter().fold(vec![BigInt::one()], |product, g| {
            integer::mul(&product, g)
                .iter()
                .map(|c| c.mod_floor(&higher))
                .collect()
        });
        let inverse = field
            .inverse(field.from_bigint(leading))
            .expect("p does not divide the leading coefficient");
        let mut error: Vec<u64> = f
            .iter()
            .zip(&product)
            .map(|(a, b)| field.mul(field.from_bigint(&((a - leading * b) / &modulus)), inverse))
            .collect();
        dense::trim(&mut error);
        for ((lifted, g), inverse) in lifted.iter_mut().zip(factors).zip(&inverses) {
            let digit = dense::rem(field, &dense::mul(field, &error, inverse), g);
            for (c, &d) in lifted.iter_mut().zip(&digit) {
                *c += &modulus * field.to_i64(d);
            }
        }
        modulus = higher;
    }
    Ok((lifted, modulus))
}

/// For each i the inverse of Π_{j≠i} gⱼ modulo gᵢ; `None` if two factors are not coprime.
pub fn cofactor_inverses(field: &PrimeField, factors: &[Vec<u64>]) -> Option<Vec<Vec<u64>>> {
    let product = factors.iter().fold(vec![field.one()], |product, g| {
        dense::mul(field, &product, g)
    });
    let inverse = |g: &Vec<u64>| {
        let cofactor = dense::rem(field, &dense::div_rem(field, &product, g).0, g);
        let (d, s, _) = dense::extended_gcd(field, &cofactor, g);
        (d.len() == 1).then_some(s)
    };
    factors.iter().map(inverse).collect()
}

/// Whether lc(f)·Π gᵢ ≡ f modulo m: what [`lift`] promises.
pub fn is_factorisation(f: &[BigInt], factors: &[Vec<BigInt>], modulus: &BigInt) -> bool {
    let leading = f.last().cloned().unwrap_or_default();
    let product = factors
        .iter()
        .fold(vec![leading], |product, g| integer::mul(&product, g));
    let zero = BigInt::zero();
    (0..f.len().max(product.len())).all(|i| {
        let difference = f.get(i).unwrap_or(&zero) - product.get(i).unwrap_or(&zero);
        difference.is_multiple_of(modulus)
    })
}
