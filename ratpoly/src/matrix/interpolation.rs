//! Determinants by values: modulo primes of word size at a grid of points, then interpolation and the
//! Chinese remainder theorem. The degrees and the coefficients are bounded beforehand, so that the result
//! is certain, not likely (Horowitz, Sahni 1975).

use super::Matrix;
use super::determinant::coefficient_bound;
use crate::budget::Budget;
use crate::error::Error;
use crate::modular::{ChineseRemainder, PrimeField, primes_below};
use crate::polynomial::Polynomial;
use crate::univariate::modular as dense;
use num_bigint::BigInt;

/// Grids beyond this size are never chosen.
const MOST_POINTS: usize = 1 << 16;

/// For each variable a bound on its degree in the determinant: by rows or by columns, whichever is less.
fn degree_bounds(matrix: &Matrix<Polynomial>) -> Vec<usize> {
    let n = matrix.rows;
    let degrees: Vec<Vec<u32>> = matrix.entries.iter().map(Polynomial::degrees).collect();
    (0..matrix.ring.len())
        .map(|v| {
            let most = |line: &dyn Fn(usize) -> usize| {
                (0..n)
                    .map(|k| degrees[line(k)][v] as usize)
                    .max()
                    .unwrap_or(0)
            };
            let rows: usize = (0..n).map(|i| most(&|k| i * n + k)).sum();
            let columns: usize = (0..n).map(|j| most(&|k| k * n + j)).sum();
            rows.min(columns)
        })
        .collect()
}

/// The size of the grid, unless it is out of reach.
pub(crate) fn points_needed(matrix: &Matrix<Polynomial>) -> Option<usize> {
    let mut sizes = degree_bounds(matrix).into_iter();
    sizes
        .try_fold(1_usize, |size, d| size.checked_mul(d + 1))
        .filter(|&size| size <= MOST_POINTS)
}

pub(crate) fn determinant(
    matrix: &Matrix<Polynomial>,
    budget: &Budget,
) -> Result<Polynomial, Error> {
    let ring = matrix.ring;
    let n = matrix.rows;
    let sizes: Vec<usize> = degree_bounds(matrix).iter().map(|d| d + 1).collect();
    let points = points_needed(matrix).ok_or(Error::Unsupported("too many points"))?;
    let terms: usize = matrix.entries.iter().map(Polynomial::len).sum();
    let twice: BigInt = coefficient_bound(matrix) * 2 + 1;
    budget.check_bits(twice.bits())?;
    let mut known: Option<ChineseRemainder> = None;
    for prime in primes_below(1 << 62) {
        let field = PrimeField::new(prime).expect("an odd prime below 2^62");
        budget.spend((points * (n * n * n + terms)) as u64)?;
        let values = coefficients_modulo(matrix, &field, &sizes, points);
        match &mut known {
            None => known = Some(ChineseRemainder::new(&field, &values)),
            Some(known) => {
                known.add(&field, &values);
            }
        }
        if known.as_ref().is_some_and(|k| k.modulus() >= &twice) {
            break;
        }
    }
    let known = known.ok_or(Error::Unsupported("no prime"))?;
    let mut list = Vec::new();
    for (index, value) in known.values().iter().enumerate() {
        if *value == BigInt::ZERO {
            continue;
        }
        let mut rest = index;
        let exponents: Vec<u32> = sizes
            .iter()
            .map(|&size| {
                let e = rest % size;
                rest /= size;
                e as u32
            })
            .collect();
        list.push((exponents, value.clone()));
    }
    budget.check_terms(list.len())?;
    Polynomial::from_terms(ring, list)
}

/// The coefficients of the determinant modulo a prime, mixed-radix by exponents, the first variable
/// fastest.
fn coefficients_modulo(
    matrix: &Matrix<Polynomial>,
    field: &PrimeField,
    sizes: &[usize],
    points: usize,
) -> Vec<u64> {
    // Exponents and residues once, values of all powers of the points 0, 1, 2, ... once.
    let entries: Vec<(Vec<u32>, Vec<u64>)> = matrix
        .entries
        .iter()
        .map(|entry| {
            let residues = entry.residues(field.modulus());
            let residues = residues.iter().map(|&r| field.from_u64(r)).collect();
            (entry.exponents_flat(), residues)
        })
        .collect();
    let grid: Vec<u64> = (0..*sizes.iter().max().unwrap_or(&1) as u64)
        .map(|k| field.from_u64(k))
        .collect();
    let mut place = vec![0_usize; sizes.len()];
    let mut values = Vec::with_capacity(points);
    for _ in 0..points {
        let mut rows: Vec<u64> = entries
            .iter()
            .map(|(exponents, residues)| {
                let mut sum = 0;
                for (k, &residue) in residues.iter().enumerate() {
                    let powers = &exponents[k * sizes.len()..(k + 1) * sizes.len()];
                    let term = powers.iter().zip(&place).fold(residue, |term, (&e, &at)| {
                        field.mul(term, field.pow(grid[at], u64::from(e)))
                    });
                    sum = field.add(sum, term);
                }
                sum
            })
            .collect();
        values.push(numeric_determinant(field, &mut rows, matrix.rows));
        for (at, &size) in place.iter_mut().zip(sizes) {
            *at += 1;
            if *at < size {
                break;
            }
            *at = 0;
        }
    }
    // One variable after the other from values to coefficients.
    let mut stride = 1;
    for &size in sizes {
        for start in (0..points).filter(|s| s / stride % size == 0) {
            let line: Vec<u64> = (0..size).map(|k| values[start + k * stride]).collect();
            let coefficients =
                dense::interpolate(field, &grid[..size], &line).expect("distinct points");
            for k in 0..size {
                values[start + k * stride] = coefficients.get(k).copied().unwrap_or(0);
            }
        }
        stride *= size;
    }
    values
}

/// Gaussian elimination in the field.
fn numeric_determinant(field: &PrimeField, a: &mut [u64], n: usize) -> u64 {
    let mut product = field.one();
    for k in 0..n {
        let Some(pivot) = (k..n).find(|&i| a[i * n + k] != 0) else {
            return 0;
        };
        if pivot != k {
            for j in 0..n {
                a.swap(pivot * n + j, k * n + j);
            }
            product = field.neg(product);
        }
        let top = a[k * n + k];
        product = field.mul(product, top);
        let inverse = field.inverse(top).expect("a pivot is not zero");
        for i in k + 1..n {
            let factor = field.mul(a[i * n + k], inverse);
            if factor != 0 {
                for j in k + 1..n {
                    let value = field.mul(factor, a[k * n + j]);
                    a[i * n + j] = field.sub(a[i * n + j], value);
                }
            }
        }
    }
    product
}
