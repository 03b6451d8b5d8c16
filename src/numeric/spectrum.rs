//! The spectrum of a real matrix: real Schur form, eigenvalues and the spectral abscissa.

use super::balancing::balance;
use super::{NumericError, finite, square};
use nalgebra::{Complex, DMatrix, Schur};

/// QR steps allowed for each row; LAPACK's `dhseqr` allows 30.
const STEPS_PER_ROW: usize = 60;

/// `(U, T)` with `A = U T U^T`, `U` orthogonal and `T` quasi-triangular (`n x n`, about `25 n^3`).
///
/// nalgebra's plain constructor iterates without bound, so the bounded form is used.
pub fn real_schur(a: &DMatrix<f64>) -> Result<(DMatrix<f64>, DMatrix<f64>), NumericError> {
    let n = square(a)?;
    finite(a)?;
    let iterations = STEPS_PER_ROW * n.max(1);
    Schur::try_new(a.clone(), f64::EPSILON, iterations)
        .map(Schur::unpack)
        .ok_or(NumericError::NoConvergence { iterations })
}

/// The eigenvalues of a real square matrix, balanced first.
pub fn eigenvalues(a: &DMatrix<f64>) -> Result<Vec<Complex<f64>>, NumericError> {
    let n = square(a)?;
    finite(a)?;
    let (balanced, _) = balance(a);
    let (_, t) = real_schur(&balanced)?;
    let mut eigenvalues = Vec::with_capacity(n);
    let mut i = 0;
    while i < n {
        if i + 1 < n && t[(i + 1, i)] != 0.0 {
            eigenvalues.extend(eigenvalues_2x2(
                t[(i, i)],
                t[(i, i + 1)],
                t[(i + 1, i)],
                t[(i + 1, i + 1)],
            ));
            i += 2;
        } else {
            eigenvalues.push(Complex::new(t[(i, i)], 0.0));
            i += 1;
        }
    }
    Ok(eigenvalues)
}

/// The two eigenvalues of `[[a, b], [c, d]]`, without the cancellation of the school formula.
fn eigenvalues_2x2(a: f64, b: f64, c: f64, d: f64) -> [Complex<f64>; 2] {
    let mean = 0.5 * a + 0.5 * d;
    let half = 0.5 * a - 0.5 * d;
    let discriminant = half * half + b * c;
    if discriminant < 0.0 {
        let imaginary = (-discriminant).sqrt();
        return [
            Complex::new(mean, imaginary),
            Complex::new(mean, -imaginary),
        ];
    }
    // The larger one first; the other from the offset of d, as in the QR step's shift.
    let root = half.abs() + discriminant.sqrt();
    if root == 0.0 {
        return [Complex::new(mean, 0.0); 2];
    }
    let (near, far) = if half >= 0.0 {
        (d + root, d - (b / root) * c)
    } else {
        (a + root, a - (b / root) * c)
    };
    [Complex::new(near, 0.0), Complex::new(far, 0.0)]
}

/// The largest real part of an eigenvalue; minus infinity for the empty matrix.
pub fn spectral_abscissa(a: &DMatrix<f64>) -> Result<f64, NumericError> {
    Ok(eigenvalues(a)?
        .iter()
        .map(|l| l.re)
        .fold(f64::NEG_INFINITY, f64::max))
}

/// Refuses a matrix with an eigenvalue on the imaginary axis or right of it.
pub fn require_stable(a: &DMatrix<f64>) -> Result<(), NumericError> {
    if spectral_abscissa(a)? < 0.0 {
        Ok(())
    } else {
        Err(NumericError::Unstable)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    #[test]
    fn eigenvalues_of_blocks_known_by_hand() {
        let oscillator = DMatrix::from_row_slice(2, 2, &[0.0, 1.0, -25.0, -6.0]);
        let l = eigenvalues(&oscillator).unwrap();
        assert_relative_eq!(l[0].re, -3.0, max_relative = 1e-14);
        assert_relative_eq!(l[0].im.abs(), 4.0, max_relative = 1e-14);
        // a triangle keeps its diagonal, in whatever order
        let mut real: Vec<f64> = eigenvalues(&DMatrix::from_row_slice(
            3,
            3,
            &[1.0, 5.0, 7.0, 0.0, -2.0, 9.0, 0.0, 0.0, 4.0],
        ))
        .unwrap()
        .iter()
        .map(|l| l.re)
        .collect();
        real.sort_by(f64::total_cmp);
        for (computed, exact) in real.iter().zip([-2.0, 1.0, 4.0]) {
            assert_relative_eq!(*computed, exact, max_relative = 1e-13);
        }
        assert!(eigenvalues(&DMatrix::zeros(0, 0)).unwrap().is_empty());
    }

    #[test]
    fn refuses_what_has_no_spectrum() {
        assert!(matches!(
            eigenvalues(&DMatrix::zeros(2, 3)),
            Err(NumericError::Shape { .. })
        ));
        let nan = DMatrix::from_element(3, 3, f64::NAN);
        assert_eq!(real_schur(&nan), Err(NumericError::NotFinite));
    }

    #[test]
    fn an_undamped_oscillator_and_an_integrator_are_not_stable() {
        for entries in [[0.0, 1.0, -4.0, 0.0], [0.0, 1.0, 0.0, -1.0]] {
            let a = DMatrix::from_row_slice(2, 2, &entries);
            assert_eq!(require_stable(&a), Err(NumericError::Unstable));
        }
        let damped = DMatrix::from_row_slice(2, 2, &[0.0, 1.0, -4.0, -1e-9]);
        assert_eq!(require_stable(&damped), Ok(()));
    }
}
