//! Sums and products of matrices over a field. Shapes are checked: a misfit is `None`.

use crate::domain::Domain;
use crate::matrix::Matrix;
use ratpoly::allowance;

/// `left + right`; `None` when the shapes differ.
pub fn add<D: Domain>(
    field: &D,
    left: &Matrix<D::Element>,
    right: &Matrix<D::Element>,
) -> Option<Matrix<D::Element>> {
    (left.shape() == right.shape()).then(|| {
        Matrix::from_fn(left.rows(), left.columns(), |i, j| {
            field.add(&left[(i, j)], &right[(i, j)])
        })
    })
}

/// `left - right`; `None` when the shapes differ.
pub fn subtract<D: Domain>(
    field: &D,
    left: &Matrix<D::Element>,
    right: &Matrix<D::Element>,
) -> Option<Matrix<D::Element>> {
    (left.shape() == right.shape()).then(|| {
        Matrix::from_fn(left.rows(), left.columns(), |i, j| {
            field.subtract(&left[(i, j)], &right[(i, j)])
        })
    })
}

/// `factor * matrix` for a scalar factor.
pub fn scale<D: Domain>(
    field: &D,
    factor: &D::Element,
    matrix: &Matrix<D::Element>,
) -> Matrix<D::Element> {
    matrix.map(|entry| field.multiply(factor, entry))
}

/// `left * right`; `None` when the inner sizes differ.
pub fn multiply<D: Domain>(
    field: &D,
    left: &Matrix<D::Element>,
    right: &Matrix<D::Element>,
) -> Option<Matrix<D::Element>> {
    let mut kept = 0usize;
    (left.columns() == right.rows()).then(|| {
        Matrix::from_fn(left.rows(), right.columns(), |i, j| {
            let mut sum = field.integer(0);
            for k in 0..left.columns() {
                // Structural zeros are common (companion and block matrices) and cost nothing.
                if !field.is_zero(&left[(i, k)]) && !field.is_zero(&right[(k, j)]) {
                    sum = field.add(&sum, &field.multiply(&left[(i, k)], &right[(k, j)]));
                }
            }
            // All entries together are held to what one object may take.
            kept = kept.saturating_add(field.size(&sum));
            allowance::reserve(kept.saturating_mul(field.bytes_of_a_term()));
            sum
        })
    })
}

/// The unit matrix of an order.
pub fn identity<D: Domain>(field: &D, order: usize) -> Matrix<D::Element> {
    Matrix::from_fn(order, order, |i, j| field.integer(i64::from(i == j)))
}

/// The sum of the diagonal entries; `None` when the matrix is not square.
pub fn trace<D: Domain>(field: &D, matrix: &Matrix<D::Element>) -> Option<D::Element> {
    matrix.is_square().then(|| {
        (0..matrix.rows()).fold(field.integer(0), |sum, i| field.add(&sum, &matrix[(i, i)]))
    })
}
