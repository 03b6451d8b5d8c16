//! Slow plain definitions that the fast methods are tested against.

#![allow(dead_code)]

use ratpoly::{BigInt, Polynomial, Ring};

/// The determinant as Leibniz defines it: the signed sum over all permutations.
pub fn leibniz_determinant(ring: Ring, rows: &[Vec<Polynomial>]) -> Polynomial {
    fn permute(
        rows: &[Vec<Polynomial>],
        row: usize,
        used: &mut Vec<usize>,
        product: &Polynomial,
        sum: &mut Polynomial,
    ) {
        if row == rows.len() {
            let n = used.len();
            let inversions = (0..n).flat_map(|i| (i + 1..n).map(move |j| (i, j)));
            let odd = inversions.filter(|&(i, j)| used[i] > used[j]).count() % 2 == 1;
            if odd {
                *sum -= product;
            } else {
                *sum += product;
            }
            return;
        }
        for column in 0..rows.len() {
            if !used.contains(&column) && !rows[row][column].is_zero() {
                used.push(column);
                permute(rows, row + 1, used, &(product * &rows[row][column]), sum);
                used.pop();
            }
        }
    }
    let mut sum = Polynomial::zero(ring);
    permute(rows, 0, &mut Vec::new(), &Polynomial::one(ring), &mut sum);
    sum
}

/// Sylvester's matrix of two polynomials of positive degree.
pub fn sylvester(f: &Polynomial, g: &Polynomial, variable: usize) -> Vec<Vec<Polynomial>> {
    let (a, b) = (f.coefficients_in(variable), g.coefficients_in(variable));
    let (m, n) = (a.len() - 1, b.len() - 1);
    let mut rows = vec![vec![Polynomial::zero(f.ring()); m + n]; m + n];
    for i in 0..n {
        for (k, c) in a.iter().rev().enumerate() {
            rows[i][i + k] = c.clone();
        }
    }
    for i in 0..m {
        for (k, c) in b.iter().rev().enumerate() {
            rows[n + i][i + k] = c.clone();
        }
    }
    rows
}

/// A polynomial from small integers, for generators: exponents below 3 in each variable.
pub fn from_small(ring: Ring, terms: Vec<(Vec<u32>, i64)>) -> Polynomial {
    let terms = terms.into_iter().map(|(e, c)| (e, BigInt::from(c)));
    Polynomial::from_terms(ring, terms).unwrap()
}
