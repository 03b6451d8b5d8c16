//! Determinants and cofactors.
//!
//! Expansion column by column with every minor computed once, addressed by the set of its rows:
//! division-free, so that no condition arises, and the cheapest known way for the sparse matrices
//! of symbols that stability theory writes down (Gentleman & Johnson 1976 compare it with
//! elimination). Orders above twelve go by elimination, and so do matrices of numbers, whose quotients are no
//! longer than they are.

use super::linear::eliminate;
use crate::domain::Domain;
use crate::matrix::Matrix;
use ratpoly::allowance;

/// The largest order that is expanded: 2^order minors are kept.
const LARGEST_EXPANSION: usize = 12;

/// The determinant; `None` when the matrix is not square.
pub fn determinant<D: Domain>(field: &D, matrix: &Matrix<D::Element>) -> Option<D::Element> {
    if !matrix.is_square() {
        return None;
    }
    let n = matrix.rows();
    if n > LARGEST_EXPANSION || field.is_of_numbers() && n > 3 {
        return Some(eliminate(field, matrix.clone()));
    }
    let mut minors: Vec<Option<D::Element>> = vec![None; 1 << n];
    minors[0] = Some(field.integer(1));
    let all = (1 << n) - 1;
    Some(minor(field, matrix, all, &mut minors, &mut 0))
}

/// The minor of the rows in `rows` (a bit set) and the last `|rows|` columns.
fn minor<D: Domain>(
    field: &D,
    matrix: &Matrix<D::Element>,
    rows: usize,
    minors: &mut Vec<Option<D::Element>>,
    kept: &mut usize,
) -> D::Element {
    if let Some(known) = &minors[rows] {
        return known.clone();
    }
    let column = matrix.columns() - rows.count_ones() as usize;
    let mut sum = field.integer(0);
    let mut positive = true;
    for i in (0..matrix.rows()).filter(|i| rows >> i & 1 == 1) {
        let entry = &matrix[(i, column)];
        if !field.is_zero(entry) {
            let term = field.multiply(entry, &minor(field, matrix, rows & !(1 << i), minors, kept));
            sum = if positive {
                field.add(&sum, &term)
            } else {
                field.subtract(&sum, &term)
            };
        }
        positive = !positive;
    }
    // All minors are kept: together they are held to what one object may take.
    *kept = kept.saturating_add(field.size(&sum));
    allowance::reserve(kept.saturating_mul(field.bytes_of_a_term()));
    minors[rows] = Some(sum.clone());
    sum
}

/// The cofactor of entry (i, j), both from 0: the signed minor without row i and column j.
///
/// `None` when the matrix is not square or has no such entry. The cofactor of a 1x1 matrix is 1.
pub fn cofactor<D: Domain>(
    field: &D,
    matrix: &Matrix<D::Element>,
    i: usize,
    j: usize,
) -> Option<D::Element> {
    if !matrix.is_square() || i >= matrix.rows() || j >= matrix.columns() {
        return None;
    }
    let minor = match matrix.without(i, j) {
        Some(rest) => determinant(field, &rest)?,
        None => field.integer(1),
    };
    Some(if (i + j).is_multiple_of(2) {
        minor
    } else {
        field.negate(&minor)
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::domain::{Domain, PrimeField, Rationals};
    use crate::theory::arithmetic::multiply;

    /// The adjugate rule (cofactors transposed) A adj A = det A E, at orders on both sides of the
    /// switch from expansion to elimination.
    #[test]
    fn cofactors_make_the_adjugate() {
        for n in [1usize, 2, 5, 13] {
            let field = PrimeField;
            let a = Matrix::from_fn(n, n, |i, j| {
                field
                    .power(&field.integer(3 + i as i64), (7 * j + i * j) as u32)
                    .unwrap()
            });
            let det = determinant(&field, &a).unwrap();
            let adjugate = Matrix::from_fn(n, n, |i, j| cofactor(&field, &a, j, i).unwrap());
            let product = multiply(&field, &a, &adjugate).unwrap();
            for i in 0..n {
                for j in 0..n {
                    assert_eq!(product[(i, j)], if i == j { det } else { 0 });
                }
            }
        }
    }

    #[test]
    fn no_determinant_without_a_square() {
        let m = Matrix::from_fn(2, 3, |_, _| Rationals.integer(1));
        assert_eq!(determinant(&Rationals, &m), None);
        assert_eq!(cofactor(&Rationals, &m.leading(2), 2, 0), None);
    }
}
