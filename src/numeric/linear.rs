//! Systems of linear equations: LU with partial pivoting after equilibration.
//!
//! Rows, then columns, are scaled by powers of two (no rounding) until their largest entries
//! lie in [1, 2); then a tiny pivot means a nearly singular system and not merely small units
//! (Golub & Van Loan, *Matrix Computations*, section 3.5.2).

use super::{NumericError, finite, power_of_two_below, square};
use nalgebra::DMatrix;

/// The solution `X` of `M X = R`: `M` is `n x n`, `R` and `X` are `n x k`;
/// `2/3 n^3 + 2 n^2 k` operations.
pub fn solve(m: &DMatrix<f64>, r: &DMatrix<f64>) -> Result<DMatrix<f64>, NumericError> {
    let n = square(m)?;
    if r.nrows() != n {
        return Err(NumericError::Shape {
            expected: (n, r.ncols()),
            found: r.shape(),
        });
    }
    finite(m)?;
    finite(r)?;
    if n == 0 {
        return Ok(r.clone());
    }
    let mut scaled = m.clone();
    let mut x = r.clone();
    for i in 0..n {
        let f = power_of_two_below(scaled.row(i).amax());
        scaled.row_mut(i).apply(|v| *v /= f);
        x.row_mut(i).apply(|v| *v /= f);
    }
    let mut column_scale = vec![1.0; n];
    for (j, scale) in column_scale.iter_mut().enumerate() {
        *scale = power_of_two_below(scaled.column(j).amax());
        scaled.column_mut(j).apply(|v| *v /= *scale);
    }
    let lu = scaled.lu();
    let u = lu.u();
    let threshold = n as f64 * f64::EPSILON;
    if (0..n).any(|i| u[(i, i)].abs() <= threshold) || !lu.solve_mut(&mut x) {
        return Err(NumericError::Singular);
    }
    for (j, scale) in column_scale.iter().enumerate() {
        x.row_mut(j).apply(|v| *v /= scale);
    }
    finite(&x)?;
    Ok(x)
}

/// `det M` of an `n x n` matrix by LU with partial pivoting, `2/3 n^3` operations;
/// 1 for the empty matrix.
pub fn determinant(m: &DMatrix<f64>) -> Result<f64, NumericError> {
    square(m)?;
    finite(m)?;
    Ok(if m.is_empty() {
        1.0
    } else {
        m.clone().lu().determinant()
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    #[test]
    fn small_units_are_not_singular() {
        let m = DMatrix::from_row_slice(2, 2, &[1e-200, 2e-200, 3e100, 4e100]);
        let x = solve(&m, &DMatrix::from_row_slice(2, 1, &[5e-200, 11e100])).unwrap();
        assert_relative_eq!(x[0], 1.0, max_relative = 1e-14);
        assert_relative_eq!(x[1], 2.0, max_relative = 1e-14);
    }

    #[test]
    fn dependent_rows_are_singular_even_when_rounding_hides_it() {
        let m = DMatrix::from_row_slice(3, 3, &[0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9]);
        assert_eq!(
            solve(&m, &DMatrix::identity(3, 3)),
            Err(NumericError::Singular)
        );
        let zero = DMatrix::zeros(2, 2);
        assert_eq!(solve(&zero, &zero), Err(NumericError::Singular));
    }

    #[test]
    fn determinants() {
        assert_eq!(determinant(&DMatrix::zeros(0, 0)), Ok(1.0));
        assert_eq!(determinant(&DMatrix::zeros(2, 2)), Ok(0.0));
        let m = DMatrix::from_row_slice(2, 2, &[1.0, 2.0, 3.0, 4.0]);
        assert_relative_eq!(determinant(&m).unwrap(), -2.0, max_relative = 1e-15);
        assert!(determinant(&DMatrix::zeros(1, 2)).is_err());
    }
}
