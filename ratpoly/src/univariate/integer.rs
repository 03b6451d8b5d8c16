//! Dense polynomials in one variable over the integers: the little that factorisation needs.

use num_bigint::BigInt;
use num_integer::Integer;
use num_traits::{One, Signed, Zero};

use crate::integer_gcd::integer_gcd;
use crate::modular::PrimeField;

/// Removes leading zeros.
pub fn trim(f: &mut Vec<BigInt>) {
    while f.last().is_some_and(Zero::is_zero) {
        f.pop();
    }
}

/// f·g.
pub fn mul(f: &[BigInt], g: &[BigInt]) -> Vec<BigInt> {
    if f.is_empty() || g.is_empty() {
        return Vec::new();
    }
    let mut product = vec![BigInt::zero(); f.len() + g.len() - 1];
    for (i, a) in f.iter().enumerate() {
        for (j, b) in g.iter().enumerate() {
            product[i + j] += a * b;
        }
    }
    product
}

/// f/g if g divides f over the integers.
pub fn div_exact(f: &[BigInt], g: &[BigInt]) -> Option<Vec<BigInt>> {
    let leading = g.last()?;
    let mut rest = f.to_vec();
    if f.len() < g.len() {
        return f.is_empty().then(Vec::new);
    }
    let mut quotient = vec![BigInt::zero(); f.len() - g.len() + 1];
    for shift in (0..quotient.len()).rev() {
        let (q, r) = rest[shift + g.len() - 1].div_rem(leading);
        if !r.is_zero() {
            return None;
        }
        if !q.is_zero() {
            for (a, b) in rest[shift..].iter_mut().zip(g) {
                *a -= &q * b;
            }
        }
        quotient[shift] = q;
    }
    rest.iter().all(Zero::is_zero).then_some(quotient)
}

/// The nonnegative gcd of the coefficients.
pub fn content(f: &[BigInt]) -> BigInt {
    let mut content = BigInt::zero();
    for c in f {
        content = integer_gcd(&content, c);
        if content.is_one() {
            break;
        }
    }
    content
}

/// f divided by its content, with a positive leading coefficient; zero stays zero.
pub fn primitive_part(f: &[BigInt]) -> Vec<BigInt> {
    let mut content = content(f);
    let Some(leading) = f.last() else {
        return Vec::new();
    };
    if leading.is_negative() {
        content = -content;
    }
    f.iter().map(|c| c / &content).collect()
}

/// The image over a prime field.
pub fn reduce(field: &PrimeField, f: &[BigInt]) -> Vec<u64> {
    let mut image = f.iter().map(|c| field.from_bigint(c)).collect();
    super::modular::trim(&mut image);
    image
}

/// The residue of least absolute value modulo an odd `modulus`.
pub fn symmetric_residue(a: &BigInt, modulus: &BigInt) -> BigInt {
    let residue = a.mod_floor(modulus);
    if &residue + &residue > *modulus {
        residue - modulus
    } else {
        residue
    }
}

/// A bound for the absolute value of the coefficients of every divisor of f over the integers:
/// 2^n·|f|, the Euclidean norm (M. Mignotte, *An inequality about factors of polynomials*, 1974).
pub fn divisor_bound(f: &[BigInt]) -> BigInt {
    let squares: BigInt = f.iter().map(|c| c * c).sum();
    (squares.sqrt() + 1u32) << f.len().saturating_sub(1)
}
