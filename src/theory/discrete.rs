//! Discrete stability: all eigenvalues lie inside of the unit circle.
//!
//! By the bilinear map z = (1 + s)/(1 - s), which takes the inside of the unit circle to the left half
//! plane, the question becomes Hurwitz's (E. I. Jury, *Theory and Application of the z-Transform Method*,
//! 1964, ch. 3; the tests of Schur 1917 and Cohn 1922 without it).

use super::determinant::determinant;
use super::hurwitz::hurwitz_matrix;
use crate::domain::Domain;

/// What must be positive for all zeros of z^n + a_1 z^(n-1) + ... + a_n to lie inside of the unit
/// circle: the Hurwitz determinants of its bilinear image.
///
/// `coefficients` are a_0, ..., a_n. `None` when there are fewer than two; and, since -1 is a zero then,
/// when the image has no leading coefficient.
pub fn inside_the_unit_circle<D: Domain>(
    field: &D,
    coefficients: &[D::Element],
) -> Option<Vec<D::Element>> {
    let n = coefficients.len().checked_sub(1).filter(|n| *n > 0)?;
    // The sum of a_k (1 + s)^(n-k) (1 - s)^k, by increasing powers of s.
    let mut image = vec![field.integer(0); n + 1];
    for (k, coefficient) in coefficients.iter().enumerate() {
        let mut product = vec![field.integer(1)];
        for factor in 0..n {
            let minus = factor >= n - k;
            let mut longer = product.clone();
            longer.push(field.integer(0));
            for (power, c) in product.iter().enumerate() {
                longer[power + 1] = if minus {
                    field.subtract(&longer[power + 1], c)
                } else {
                    field.add(&longer[power + 1], c)
                };
            }
            product = longer;
        }
        for (sum, c) in image.iter_mut().zip(&product) {
            *sum = field.add(sum, &field.multiply(coefficient, c));
        }
    }
    image.reverse();
    let lead = image.first()?.clone();
    let monic: Option<Vec<D::Element>> = image.iter().map(|c| field.divide(c, &lead)).collect();
    let hurwitz = hurwitz_matrix(field, &monic?)?;
    (1..=n)
        .map(|k| determinant(field, &hurwitz.leading(k)))
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::domain::Rationals;
    use num_rational::BigRational;
    use num_traits::Signed;

    fn stable(coefficients: &[(i64, i64)]) -> bool {
        let all: Vec<BigRational> = coefficients
            .iter()
            .map(|(n, d)| BigRational::new((*n).into(), (*d).into()))
            .collect();
        inside_the_unit_circle(&Rationals, &all)
            .is_some_and(|minors| minors.iter().all(Signed::is_positive))
    }

    #[test]
    fn zeros_on_either_side_of_the_circle() {
        for (n, d) in [(0, 1), (1, 2), (-1, 2), (99, 100), (-99, 100)] {
            assert!(stable(&[(1, 1), (-n, d)]), "{n}/{d}");
        }
        for (n, d) in [(1, 1), (-1, 1), (2, 1), (-2, 1), (101, 100), (-101, 100)] {
            assert!(!stable(&[(1, 1), (-n, d)]), "{n}/{d}");
        }
        // For two zeros: |a_1| < 1 + a_2 and a_2 < 1.
        for a in -12i64..=12 {
            for b in -12i64..=12 {
                let expected = a.abs() < 4 + b && b < 4;
                assert_eq!(stable(&[(1, 1), (a, 4), (b, 4)]), expected, "{a} {b}");
            }
        }
        // z^3 - 1/2 has its zeros inside, z^3 - 2 has not.
        assert!(stable(&[(1, 1), (0, 1), (0, 1), (-1, 2)]));
        assert!(!stable(&[(1, 1), (0, 1), (0, 1), (-2, 1)]));
    }
}
