//! The variance as the integral of the power spectral density.
//!
//! For `dx/dt = A x + w`, `w` white with intensity `Q`, the output `c^T x` has the two-sided density
//!
//! ```text
//! S(w) = (1 / 2 pi) c^T F(i w) Q F(i w)^* c,   F(s) = (s E - A)^-1,   sigma^2 = Int_-oo^oo S(w) dw,
//! ```
//!
//! the convention in which white noise of intensity `q` has the density `q / (2 pi)`.

use super::hurwitz::Variance;
use super::quadrature::{Limits, Quadrature, integrate_half_axis};
use super::spectrum::eigenvalues;
use super::{NumericError, cost, order_of_lyapunov, square};
use nalgebra::{Complex, DMatrix, DVector};

/// The two-sided density `S(omega)`: one complex LU, `8/3 n^3` operations in real numbers.
pub fn density(
    a: &DMatrix<f64>,
    q: &DMatrix<f64>,
    c: &DVector<f64>,
    omega: f64,
) -> Result<f64, NumericError> {
    let n = shapes(a, q, c)?;
    // y = F^T c, so that c^T F = y^T.
    let system = DMatrix::from_fn(n, n, |i, j| {
        let imaginary = if i == j { omega } else { 0.0 };
        Complex::new(-a[(j, i)], imaginary)
    });
    let y = system
        .lu()
        .solve(&c.map(|v| Complex::new(v, 0.0)))
        .ok_or(NumericError::Unstable)?;
    let (re, im) = (y.map(|v| v.re), y.map(|v| v.im));
    Ok((re.dot(&(q * &re)) + im.dot(&(q * &im))) / (2.0 * std::f64::consts::PI))
}

/// The order of the system, where the shapes fit.
fn shapes(a: &DMatrix<f64>, q: &DMatrix<f64>, c: &DVector<f64>) -> Result<usize, NumericError> {
    let n = square(a)?;
    for (expected, found) in [((n, n), q.shape()), ((n, 1), c.shape())] {
        if expected != found {
            return Err(NumericError::Shape { expected, found });
        }
    }
    Ok(n)
}

/// The stationary variance of `c^T x` by adaptive quadrature of [`density`]; `A` and `Q` are `n x n`,
/// `c` has `n` entries; about `8/3 n^3` operations for each of the evaluations.
///
/// The axis is mapped with the geometric mean of the eigenfrequencies as its unit, and cut at the
/// imaginary parts of the eigenvalues, where a lightly damped system has peaks that no fixed
/// grid would see. An unstable or undamped `A` is [`NumericError::Unstable`].
pub fn variance(
    a: &DMatrix<f64>,
    q: &DMatrix<f64>,
    c: &DVector<f64>,
    limits: Limits,
) -> Result<(Variance, Quadrature), NumericError> {
    let n = order_of_lyapunov(a, q)?;
    shapes(a, q, c)?;
    let spectrum = eigenvalues(a)?;
    if spectrum.iter().any(|l| l.re.is_nan() || l.re >= 0.0) {
        return Err(NumericError::Unstable);
    }
    let peaks: Vec<f64> = spectrum.iter().map(|l| l.im).filter(|w| *w > 0.0).collect();
    let quadrature = integrate_half_axis(
        &mut |omega| density(a, q, c, omega),
        scale(&spectrum),
        &peaks,
        limits,
    )?;
    let each =
        cost::COMPLEX * (cost::lu(n) + cost::triangular_solves(n, 1)) + 2 * cost::product(n, n, 1);
    let variance = Variance {
        value: 2.0 * quadrature.value,
        operations: cost::real_schur(n) + quadrature.evaluations as u64 * each,
    };
    Ok((variance, quadrature))
}

/// The geometric mean of the moduli of the eigenvalues, by their logarithms.
fn scale(spectrum: &[Complex<f64>]) -> f64 {
    let moduli = spectrum
        .iter()
        .map(|l| (l.re * l.re + l.im * l.im).sqrt())
        .filter(|r| r.is_normal());
    let (sum, count) = moduli.fold((0.0, 0usize), |(sum, count), r| {
        (sum + libm::log2(r), count + 1)
    });
    if count == 0 {
        1.0
    } else {
        libm::exp2(sum / count as f64)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    #[test]
    fn white_noise_through_a_first_order_filter() {
        // S = q / (2 pi (omega^2 + alpha^2)), sigma^2 = q / (2 alpha)
        let a = DMatrix::from_element(1, 1, -2.0);
        let q = DMatrix::from_element(1, 1, 3.0);
        let c = DVector::from_element(1, 1.0);
        let s = density(&a, &q, &c, 1.5).unwrap();
        assert_relative_eq!(
            s,
            3.0 / (2.0 * std::f64::consts::PI * 6.25),
            max_relative = 1e-15
        );
        let (variance, quadrature) = variance(&a, &q, &c, Limits::default()).unwrap();
        assert_relative_eq!(variance.value, 0.75, max_relative = 1e-13);
        assert!(quadrature.evaluations >= 15 && variance.operations > 0);
    }

    #[test]
    fn shapes_must_fit() {
        let (two, three) = (DMatrix::identity(2, 2), DVector::zeros(3));
        let wide = DMatrix::zeros(2, 3);
        for (a, q, c) in [
            (&wide, &two, &DVector::zeros(2)),
            (&two, &wide, &DVector::zeros(2)),
            (&two, &two, &three),
        ] {
            assert!(matches!(
                density(a, q, c, 1.0),
                Err(NumericError::Shape { .. })
            ));
        }
    }

    #[test]
    fn an_unstable_system_is_refused_although_its_integral_is_finite() {
        let a = DMatrix::from_element(1, 1, 2.0);
        let one = DMatrix::from_element(1, 1, 1.0);
        let c = DVector::from_element(1, 1.0);
        assert_eq!(
            variance(&a, &one, &c, Limits::default()),
            Err(NumericError::Unstable)
        );
    }
}
