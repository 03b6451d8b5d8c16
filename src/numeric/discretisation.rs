//! Exact discretisation of a linear system under white noise (Van Loan 1978, *IEEE Trans.
//! Automatic Control* 23, 395-404).
//!
//! `dx/dt = A x + w` sampled every `h` is `x_{k+1} = F x_k + v_k` with `F = e^{A h}` and the covariance
//! `G = Int_0^h e^{A s} Q e^{A^T s} ds` of `v_k`: no error of integration is made. Both stand in the
//! exponential of the block matrix `[[-A, Q], [0, A^T]] h`. That exponential is taken for a small
//! step, where its Taylor series is short, and the step is then doubled by `F <- F F`,
//! `G <- F G F^T + G`, so that `e^{-A h}` never grows.

use super::{NumericError, finite, order_of_lyapunov, symmetrised};
use nalgebra::DMatrix;

/// A sampled linear system `x_{k+1} = F x_k + v_k`.
#[derive(Clone, Debug, PartialEq)]
pub struct Discretisation {
    /// `F = e^{A h}`, `n x n`.
    pub transition: DMatrix<f64>,
    /// The covariance of `v_k`, `n x n`, symmetric.
    pub noise: DMatrix<f64>,
}

/// Terms of the Taylor series: the first one left out is below `2^-n / n! = 7e-23`.
const TERMS: usize = 18;
/// Doublings allowed; more would mean a step of `2^200` small ones.
const DOUBLINGS: u32 = 200;

/// `F` and `G` for the step `h > 0`; `A` and `Q` are `n x n`; about `16 * 18 n^3` operations and
/// `6 n^3` for each doubling.
pub fn discretise(
    a: &DMatrix<f64>,
    q: &DMatrix<f64>,
    h: f64,
) -> Result<Discretisation, NumericError> {
    let n = order_of_lyapunov(a, q)?;
    if !(h.is_finite() && h > 0.0) {
        return Err(NumericError::Range);
    }
    let mut step = h;
    let mut doublings = 0;
    while a.norm() * step > 0.25 {
        step *= 0.5;
        doublings += 1;
        if doublings > DOUBLINGS {
            return Err(NumericError::Range);
        }
    }
    // G is proportional to Q: a Q of norm 1 keeps the block matrix small.
    let intensity = q.norm();
    let unit = if intensity > 0.0 {
        q / intensity
    } else {
        q.clone()
    };
    let mut block = DMatrix::zeros(2 * n, 2 * n);
    block.view_mut((0, 0), (n, n)).copy_from(&(a * -step));
    block.view_mut((0, n), (n, n)).copy_from(&(unit * 0.25));
    block
        .view_mut((n, n), (n, n))
        .copy_from(&(a.transpose() * step));
    let exponential = taylor(&block);
    let mut transition = exponential.view((n, n), (n, n)).transpose();
    let mut noise =
        symmetrised(&(&transition * exponential.view((0, n), (n, n)) * (4.0 * step * intensity)));
    for _ in 0..doublings {
        noise = symmetrised(&(&transition * &noise * transition.transpose())) + noise;
        transition = &transition * &transition;
    }
    finite(&transition)?;
    finite(&noise)?;
    Ok(Discretisation { transition, noise })
}

/// `e^M` for `||M|| < 1` by Horner's rule.
fn taylor(m: &DMatrix<f64>) -> DMatrix<f64> {
    let unit = DMatrix::identity(m.nrows(), m.ncols());
    let mut sum = unit.clone();
    for k in (1..=TERMS).rev() {
        sum = &unit + m * sum / k as f64;
    }
    sum
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    #[test]
    fn first_order_noise_in_closed_form() {
        // F = e^{-alpha h}, G = q (1 - e^{-2 alpha h}) / (2 alpha)
        for (alpha, h) in [(0.5f64, 0.1f64), (3.0, 20.0), (1e-8, 1.0), (1e6, 1.0)] {
            let a = DMatrix::from_element(1, 1, -alpha);
            let q = DMatrix::from_element(1, 1, 7.0);
            let d = discretise(&a, &q, h).unwrap();
            assert_relative_eq!(d.transition[0], (-alpha * h).exp(), max_relative = 1e-12);
            let exact = 7.0 * -(-2.0 * alpha * h).exp_m1() / (2.0 * alpha);
            assert_relative_eq!(d.noise[0], exact, max_relative = 1e-13);
        }
    }

    #[test]
    fn the_double_integrator_in_closed_form() {
        // A = [[0, 1], [0, 0]], Q = diag(0, q): G = q [[h^3/3, h^2/2], [h^2/2, h]]
        let a = DMatrix::from_row_slice(2, 2, &[0.0, 1.0, 0.0, 0.0]);
        let q = DMatrix::from_row_slice(2, 2, &[0.0, 0.0, 0.0, 5.0]);
        let h = 3.0;
        let d = discretise(&a, &q, h).unwrap();
        let exact = [h * h * h / 3.0, h * h / 2.0, h * h / 2.0, h].map(|g| 5.0 * g);
        for (computed, exact) in d.noise.iter().zip(exact) {
            assert_relative_eq!(*computed, exact, max_relative = 1e-14);
        }
        assert_eq!(d.transition[(0, 1)], h);
    }

    #[test]
    fn refuses_steps_without_meaning_and_overflow() {
        let one = DMatrix::from_element(1, 1, 1.0);
        for h in [0.0, -1.0, f64::NAN, f64::INFINITY] {
            assert_eq!(discretise(&one, &one, h), Err(NumericError::Range));
        }
        assert_eq!(discretise(&one, &one, 1e6), Err(NumericError::NotFinite));
    }
}
