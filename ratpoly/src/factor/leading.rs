//! Which factors of the leading coefficient belong to which factor, read off from one image.
//!
//! P. S. Wang, *An improved multivariate polynomial factoring algorithm*, 1978.

use crate::integer_gcd::integer_gcd;
use num_bigint::BigInt;
use num_integer::Integer;
use num_traits::{One, Signed, Zero};

/// For each univariate image the multiplicity of each factor of the leading coefficient, if it can be
/// told.
///
/// `values` are the values at the point of the factors of the leading coefficient, with their
/// multiplicities; `content` is the integer content of the image times that of the leading
/// coefficient; `leading` are the leading coefficients of the primitive univariate factors.
pub(super) fn distribute(
    values: &[(BigInt, u32)],
    content: &BigInt,
    leading: &[BigInt],
) -> Option<Vec<Vec<u32>>> {
    // A divisor of each value that has nothing in common with the content and the values before.
    let mut marks: Vec<BigInt> = Vec::new();
    for (value, _) in values {
        let mut mark = value.abs();
        for other in
            std::iter::once(content).chain(values[..marks.len()].iter().map(|(value, _)| value))
        {
            loop {
                let common = integer_gcd(&mark, other);
                if common.is_one() || mark.is_zero() {
                    break;
                }
                mark /= common;
            }
        }
        if mark.is_one() || mark.is_zero() {
            return None;
        }
        marks.push(mark);
    }
    let mut missing: Vec<u32> = values
        .iter()
        .map(|(_, multiplicity)| *multiplicity)
        .collect();
    let mut shares = Vec::new();
    for coefficient in leading {
        let mut share = vec![0; values.len()];
        let mut rest = coefficient.abs() * content.abs();
        for m in (0..values.len()).rev() {
            while rest.is_multiple_of(&marks[m]) {
                let (quotient, remainder) = rest.div_rem(&values[m].0);
                rest = if remainder.is_zero() {
                    quotient
                } else {
                    rest / &marks[m]
                };
                share[m] += 1;
                missing[m] = missing[m].checked_sub(1)?;
            }
        }
        shares.push(share);
    }
    missing.iter().all(|&m| m == 0).then_some(shares)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn numbers(list: &[i64]) -> Vec<BigInt> {
        list.iter().map(|&n| BigInt::from(n)).collect()
    }

    #[test]
    fn factors_go_where_their_primes_go() {
        let values: Vec<(BigInt, u32)> = [(-14, 2), (3, 1), (-11, 2), (-17, 1)]
            .map(|(v, e)| (BigInt::from(v), e))
            .into();
        let leading = numbers(&[14 * 11 * 17, 14 * 3 * 11]);
        let shares = vec![vec![1, 0, 1, 1], vec![1, 1, 1, 0]];
        assert_eq!(distribute(&values, &BigInt::one(), &leading), Some(shares));
        // A multiplicity that does not add up.
        assert_eq!(
            distribute(&values, &BigInt::one(), &numbers(&[14 * 11 * 17, 14 * 11])),
            None
        );
        // A value without a prime of its own.
        let values: Vec<(BigInt, u32)> = [(6, 1), (3, 1)].map(|(v, e)| (BigInt::from(v), e)).into();
        assert_eq!(distribute(&values, &BigInt::one(), &numbers(&[6, 3])), None);
        // A content that hides one.
        assert_eq!(
            distribute(&[(BigInt::from(7), 1)], &BigInt::from(7), &numbers(&[7, 1])),
            None
        );
    }
}
