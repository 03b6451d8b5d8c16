//! The stationary covariance estimated from a seeded simulation in time.
//!
//! The sampled system of [`super::discretisation`] is exact, so the only error is statistical: it
//! falls like the square root of the number of steps, and its size is estimated from the same
//! run by batch means (Law & Kelton, *Simulation Modeling and Analysis*, section 9.5.3). The noise
//! comes from PCG-64 (O'Neill 2014) by Marsaglia's polar method (Marsaglia & Bray 1964), with
//! `libm`'s logarithm: the same seed gives the same bits on every machine.

use super::discretisation::discretise;
use super::spectrum::spectral_abscissa;
use super::{NumericError, cost, order_of_lyapunov};
use nalgebra::{DMatrix, DVector, SymmetricEigen};
use rand_core::Rng;
use rand_pcg::Pcg64;

/// Batches for the standard error.
const BATCHES: usize = 32;
/// PCG's stream, fixed so that a seed is one number.
const STREAM: u128 = 0xa02b_dbf7_bb3c_0a7a_c28f_a16a_64ab_f96b;

/// How to simulate.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Simulation {
    /// The time between samples.
    pub step: f64,
    /// Samples that count.
    pub samples: usize,
    /// Samples before them, in which the start from rest is forgotten.
    pub discarded: usize,
    /// The seed.
    pub seed: u64,
}

/// An estimate of the stationary covariance.
#[derive(Clone, Debug, PartialEq)]
pub struct Estimate {
    /// The estimate, `n x n`, symmetric.
    pub covariance: DMatrix<f64>,
    /// Its standard error, entry by entry.
    pub standard_error: DMatrix<f64>,
    /// Floating-point operations.
    pub operations: u64,
}

impl Simulation {
    /// A step of half the slowest time constant and a start forgotten to `e^-40`.
    pub fn of(a: &DMatrix<f64>, samples: usize, seed: u64) -> Result<Self, NumericError> {
        let abscissa = spectral_abscissa(a)?;
        let step = -0.5 / abscissa;
        if !(abscissa < 0.0 && step.is_finite() && step > 0.0) {
            return Err(NumericError::Unstable);
        }
        Ok(Simulation {
            step,
            samples,
            discarded: 80,
            seed,
        })
    }

    /// Runs it for `dx/dt = A x + w`, `w` Gaussian and white with intensity `Q`; `A` and `Q` are `n x n`,
    /// `Q` positive semidefinite; about `5 n^2` operations a step.
    ///
    /// An unstable or undamped `A` is [`NumericError::Unstable`]; fewer than 64 samples
    /// are [`NumericError::Range`].
    pub fn run(&self, a: &DMatrix<f64>, q: &DMatrix<f64>) -> Result<Estimate, NumericError> {
        let n = order_of_lyapunov(a, q)?;
        let length = self.samples / BATCHES;
        if length < 2 {
            return Err(NumericError::Range);
        }
        let abscissa = spectral_abscissa(a)?;
        if abscissa.is_nan() || abscissa >= 0.0 {
            return Err(NumericError::Unstable);
        }
        let system = discretise(a, q, self.step)?;
        let factor = square_root(&system.noise)?;
        let mut normal = Normal::new(self.seed);
        let mut x = DVector::zeros(n);
        let mut drive = DVector::zeros(n);
        let mut advance = |x: &mut DVector<f64>| {
            drive.apply(|v| *v = normal.next());
            *x = &system.transition * &*x + &factor * &drive;
        };
        for _ in 0..self.discarded {
            advance(&mut x);
        }
        let mut mean = DMatrix::zeros(n, n);
        let mut squares = DMatrix::zeros(n, n);
        for _ in 0..BATCHES {
            let mut batch = DMatrix::zeros(n, n);
            for _ in 0..length {
                advance(&mut x);
                batch.ger(1.0, &x, &x, 1.0);
            }
            batch /= length as f64;
            mean += &batch;
            squares += batch.component_mul(&batch);
        }
        mean /= BATCHES as f64;
        let standard_error = DMatrix::from_fn(n, n, |i, j| {
            let variance = squares[(i, j)] / BATCHES as f64 - mean[(i, j)] * mean[(i, j)];
            (variance.max(0.0) / (BATCHES - 1) as f64).sqrt()
        });
        let steps = (self.discarded + length * BATCHES) as u64;
        Ok(Estimate {
            covariance: mean,
            standard_error,
            operations: steps * 3 * cost::product(n, n, 1),
        })
    }
}

/// `L` with `L L^T = G` for a positive semidefinite `G`, which Cholesky's method would refuse when
/// the noise drives few states: from the spectral decomposition, its negative rounding cut off.
fn square_root(g: &DMatrix<f64>) -> Result<DMatrix<f64>, NumericError> {
    let n = g.nrows();
    // In units in which every state has the variance 1, small states keep their digits.
    let d = DVector::from_fn(n, |i, _| {
        if g[(i, i)] > 0.0 {
            g[(i, i)].sqrt()
        } else {
            1.0
        }
    });
    let correlation = DMatrix::from_fn(n, n, |i, j| g[(i, j)] / d[i] / d[j]);
    let iterations = 60 * n.max(1);
    let eigen = SymmetricEigen::try_new(correlation, f64::EPSILON, iterations)
        .ok_or(NumericError::NoConvergence { iterations })?;
    if eigen.eigenvalues.iter().any(|l| *l < -1e-9) {
        return Err(NumericError::Range);
    }
    Ok(DMatrix::from_fn(n, n, |i, j| {
        d[i] * eigen.eigenvectors[(i, j)] * eigen.eigenvalues[j].max(0.0).sqrt()
    }))
}

/// Standard normal numbers.
struct Normal {
    source: Pcg64,
    spare: Option<f64>,
}

impl Normal {
    fn new(seed: u64) -> Self {
        Normal {
            source: Pcg64::new(u128::from(seed), STREAM),
            spare: None,
        }
    }

    fn next(&mut self) -> f64 {
        if let Some(spare) = self.spare.take() {
            return spare;
        }
        loop {
            let mut uniform = || (self.source.next_u64() >> 11) as f64 / (1u64 << 52) as f64 - 1.0;
            let (u, v) = (uniform(), uniform());
            let s = u * u + v * v;
            if s > 0.0 && s < 1.0 {
                let f = (-2.0 * libm::log(s) / s).sqrt();
                self.spare = Some(v * f);
                return u * f;
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn moments_of_the_normal_numbers() {
        let mut normal = Normal::new(1);
        let n = 200_000;
        let (mut first, mut second, mut fourth) = (0.0, 0.0, 0.0);
        for _ in 0..n {
            let x = normal.next();
            first += x;
            second += x * x;
            fourth += x * x * x * x;
        }
        let n = f64::from(n);
        // five standard errors of each moment
        assert!((first / n).abs() < 5.0 / n.sqrt());
        assert!((second / n - 1.0).abs() < 5.0 * (2.0 / n).sqrt());
        assert!((fourth / n - 3.0).abs() < 5.0 * (96.0 / n).sqrt());
    }

    #[test]
    fn an_oscillator_within_five_standard_errors() {
        // z'' + 2 z' + 10 z = w, intensity 4: var z = 4 / (2 2 10), var z' = 4 / (2 2)
        let a = DMatrix::from_row_slice(2, 2, &[0.0, 1.0, -10.0, -2.0]);
        let q = DMatrix::from_row_slice(2, 2, &[0.0, 0.0, 0.0, 4.0]);
        let simulation = Simulation::of(&a, 64_000, 7).unwrap();
        let estimate = simulation.run(&a, &q).unwrap();
        for ((i, j), exact) in [((0, 0), 0.1), ((1, 1), 1.0), ((0, 1), 0.0)] {
            let error = (estimate.covariance[(i, j)] - exact).abs();
            let standard = estimate.standard_error[(i, j)];
            assert!(
                error <= 5.0 * standard,
                "({i}, {j}): {error} > 5 * {standard}"
            );
            assert!(standard < 0.02);
        }
        assert_eq!(simulation.run(&a, &q).unwrap(), estimate);
        let other = Simulation {
            seed: 8,
            ..simulation
        };
        assert_ne!(other.run(&a, &q).unwrap(), estimate);
    }

    #[test]
    fn refuses_unstable_systems_negative_noise_and_short_runs() {
        let stable = DMatrix::from_row_slice(2, 2, &[0.0, 1.0, -1.0, -1.0]);
        let unstable = DMatrix::from_row_slice(2, 2, &[0.0, 1.0, -1.0, 0.5]);
        let q = DMatrix::from_row_slice(2, 2, &[0.0, 0.0, 0.0, 1.0]);
        assert_eq!(
            Simulation::of(&unstable, 1000, 1),
            Err(NumericError::Unstable)
        );
        let simulation = Simulation::of(&stable, 1000, 1).unwrap();
        assert_eq!(simulation.run(&unstable, &q), Err(NumericError::Unstable));
        assert_eq!(simulation.run(&stable, &-&q), Err(NumericError::Range));
        let short = Simulation {
            samples: 63,
            ..simulation
        };
        assert_eq!(short.run(&stable, &q), Err(NumericError::Range));
    }
}
