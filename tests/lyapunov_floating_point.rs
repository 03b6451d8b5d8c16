//! Laws of the floating-point Lyapunov solvers: small residual, symmetry, agreement with each
//! other and with closed forms; and the inputs that each of them must refuse.

use approx::assert_relative_eq;
use nalgebra::{DMatrix, DVector};
use proptest::prelude::*;
use rederive::numeric::quadrature::Limits;
use rederive::numeric::spectrum::spectral_abscissa;
use rederive::numeric::{
    LyapunovMethod, NumericError, bartels_stewart, hurwitz, kronecker, spectral,
};

/// `A X + X A^T + Q`, relative to the size of its terms.
fn relative_residual(a: &DMatrix<f64>, q: &DMatrix<f64>, x: &DMatrix<f64>) -> f64 {
    let residual = a * x + x * a.transpose() + q;
    residual.norm() / (2.0 * a.norm() * x.norm() + q.norm()).max(f64::MIN_POSITIVE)
}

/// A square matrix of order 1 to 6 with entries between -1 and 1.
fn square() -> impl Strategy<Value = DMatrix<f64>> {
    (1usize..=6).prop_flat_map(|n| {
        proptest::collection::vec(-1.0f64..1.0, n * n)
            .prop_map(move |entries| DMatrix::from_vec(n, n, entries))
    })
}

/// A stable matrix: Gershgorin's discs are pushed into the left half plane.
fn stable() -> impl Strategy<Value = DMatrix<f64>> {
    (square(), 0.05f64..2.0).prop_map(|(m, margin)| {
        let n = m.nrows();
        let radius = (0..n)
            .map(|i| m.row(i).iter().map(|v| v.abs()).sum::<f64>())
            .fold(0.0, f64::max);
        m - DMatrix::identity(n, n) * (radius + margin)
    })
}

/// A stable matrix with a positive semidefinite intensity of any rank, also zero.
fn system() -> impl Strategy<Value = (DMatrix<f64>, DMatrix<f64>)> {
    (stable(), 0usize..=2).prop_flat_map(|(a, rank)| {
        let n = a.nrows();
        proptest::collection::vec(-1.0f64..1.0, n * rank).prop_map(move |entries| {
            let b = DMatrix::from_vec(n, rank, entries);
            (a.clone(), &b * b.transpose())
        })
    })
}

/// A quarter car in the state of Schiehlen 2006, eq. (48): `m_A, m_R, c_A, c_R, d_A`, intensity `q`.
fn quarter_car(m: [f64; 2], c: [f64; 2], damping: f64, q: f64) -> (DMatrix<f64>, DMatrix<f64>) {
    let (ma, mr) = (m[0], m[1]);
    let (ca, cr) = (c[0], c[1]);
    let (a, b, c, d, e) = (ca / ma, ca / mr, cr / mr, damping / ma, damping / mr);
    #[rustfmt::skip]
    let system = DMatrix::from_row_slice(4, 4, &[
        0.0, 0.0, 1.0, 0.0,
        0.0, 0.0, 0.0, 1.0,
        -a, a, -d, d,
        b, -b - c, e, -e,
    ]);
    let input = DMatrix::from_column_slice(4, 1, &[0.0, 0.0, 0.0, c]);
    (system, &input * input.transpose() * q)
}

proptest! {
    // Debug builds of dense algebra are slow; 64 systems of each kind are many.
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn the_residual_is_small_and_the_solution_symmetric((a, q) in system()) {
        for method in LyapunovMethod::ALL {
            let x = method.solve(&a, &q).unwrap().matrix;
            prop_assert!(relative_residual(&a, &q, &x) < 1e-13, "{method:?}");
            prop_assert_eq!(&x, &x.transpose());
        }
    }

    #[test]
    fn the_methods_agree((a, q) in system()) {
        let [first, rest @ ..] = LyapunovMethod::ALL.map(|m| m.solve(&a, &q).unwrap().matrix);
        for other in rest {
            prop_assert!((&first - other).norm() <= 1e-10 * first.norm());
        }
    }

    #[test]
    fn the_covariance_is_linear_in_the_intensity((a, q) in system(), factor in 1e-3f64..1e3) {
        for method in LyapunovMethod::ALL {
            let x = method.solve(&a, &q).unwrap().matrix;
            let scaled = method.solve(&a, &(&q * factor)).unwrap().matrix;
            prop_assert!((&scaled - x * factor).norm() <= 1e-12 * scaled.norm());
        }
    }

    #[test]
    fn the_variance_of_an_output_by_three_routes((a, q) in system(), seed in 0.0f64..1.0) {
        let n = a.nrows();
        let c = DVector::from_fn(n, |i, _| 1.0 - seed * i as f64);
        let x = bartels_stewart::lyapunov(&a, &q).unwrap().matrix;
        let covariance = (c.transpose() * &x * &c)[0];
        let scale = c.norm_squared() * x.norm();
        let by_formula = hurwitz::variance(&a, &q, &c).unwrap().value;
        let (by_integral, _) = spectral::variance(&a, &q, &c, Limits::default()).unwrap();
        prop_assert!((covariance - by_formula).abs() <= 1e-10 * scale);
        prop_assert!((covariance - by_integral.value).abs() <= 1e-10 * scale);
    }

    #[test]
    fn an_unstable_system_keeps_its_algebraic_solution_and_loses_its_covariance((a, q) in system()) {
        let unstable = -&a;
        let x = bartels_stewart::lyapunov(&a, &q).unwrap().matrix;
        for method in LyapunovMethod::ALL {
            match method {
                LyapunovMethod::Smith => {
                    prop_assert_eq!(method.solve(&unstable, &q), Err(NumericError::Unstable));
                }
                // The solution of the reversed system is the negative one.
                _ => {
                    let reversed = method.solve(&unstable, &q).unwrap().matrix;
                    prop_assert!((&reversed + &x).norm() <= 1e-10 * x.norm());
                }
            }
        }
        let c = DVector::from_element(a.nrows(), 1.0);
        prop_assert_eq!(hurwitz::variance(&unstable, &q, &c), Err(NumericError::Unstable));
        prop_assert_eq!(
            spectral::variance(&unstable, &q, &c, Limits::default()),
            Err(NumericError::Unstable)
        );
    }

    #[test]
    fn opposite_eigenvalues_are_singular(a in stable()) {
        // diag(A, -A): every eigenvalue meets its opposite.
        let n = a.nrows().min(3);
        let a = a.view((0, 0), (n, n)).into_owned();
        let mut both = DMatrix::zeros(2 * n, 2 * n);
        both.view_mut((0, 0), (n, n)).copy_from(&a);
        both.view_mut((n, n), (n, n)).copy_from(&-&a);
        both[(0, 2 * n - 1)] = 0.5;
        let q = DMatrix::identity(2 * n, 2 * n);
        prop_assert_eq!(bartels_stewart::lyapunov(&both, &q), Err(NumericError::Singular));
        prop_assert_eq!(kronecker::lyapunov(&both, &q), Err(NumericError::Singular));
        prop_assert_eq!(LyapunovMethod::Smith.solve(&both, &q), Err(NumericError::Unstable));
    }

    #[test]
    fn sylvester_agrees_with_the_kronecker_route(a in stable(), b in stable()) {
        let q = DMatrix::from_fn(a.nrows(), b.nrows(), |i, j| (1 + i) as f64 - 0.5 * j as f64);
        let x = bartels_stewart::sylvester(&a, &b, &q).unwrap().matrix;
        let residual = &a * &x + &x * &b + &q;
        prop_assert!(residual.norm() <= 1e-12 * q.norm());
        let other = kronecker::solve_affine::<NumericError>(&[q.shape()], |x| {
            Ok(vec![&a * &x[0] + &x[0] * &b + &q])
        }).unwrap();
        prop_assert!((&x - &other[0]).norm() <= 1e-11 * x.norm());
    }
}

/// `z'' + 2 D w0 z' + w0^2 z = noise of intensity q`: the variances are `q / (4 D w0^3)` and
/// `q / (4 D w0)`, displacement and velocity are uncorrelated (Crandall & Mark, *Random Vibration in
/// Mechanical Systems*, 1963, chapter 2).
#[test]
fn oscillator_in_closed_form() {
    for (damping, w0, q) in [
        (0.2, 3.0, 1.0),
        (0.01, 50.0, 1e-4),
        (1.0, 2.0, 5.0),
        (3.0, 0.1, 2.0),
    ] {
        let a = DMatrix::from_row_slice(2, 2, &[0.0, 1.0, -w0 * w0, -2.0 * damping * w0]);
        let intensity = DMatrix::from_row_slice(2, 2, &[0.0, 0.0, 0.0, q]);
        let (z, v) = (q / (4.0 * damping * w0 * w0 * w0), q / (4.0 * damping * w0));
        for method in LyapunovMethod::ALL {
            let x = method.solve(&a, &intensity).unwrap().matrix;
            assert_relative_eq!(x[(0, 0)], z, max_relative = 1e-12);
            assert_relative_eq!(x[(1, 1)], v, max_relative = 1e-12);
            assert!(x[(0, 1)].abs() <= 1e-12 * (z * v).sqrt(), "{method:?}");
        }
        let c = DVector::from_column_slice(&[1.0, 0.0]);
        let formula = hurwitz::variance(&a, &intensity, &c).unwrap();
        assert_relative_eq!(formula.value, z, max_relative = 1e-12);
        let (integral, _) = spectral::variance(&a, &intensity, &c, Limits::default()).unwrap();
        assert_relative_eq!(integral.value, z, max_relative = 1e-11);
    }
}

/// Schiehlen 2006, eq. (67), at the car of its section 5.
#[test]
fn acceleration_of_the_reference_car() {
    let ([ma, mr], [ca, cr], da) = ([1200.0, 80.0], [30000.0, 320000.0], 4800.0);
    let (a, q) = quarter_car([ma, mr], [ca, cr], da, 1.0);
    let printed = 0.5 * (cr * da / (ma * ma) + ca * ca * (ma + mr) / (da * ma * ma));
    for method in LyapunovMethod::ALL {
        let x = method.solve(&a, &q).unwrap().matrix;
        assert_relative_eq!(x[(2, 2)], printed, max_relative = 1e-12);
    }
    let c = DVector::from_column_slice(&[0.0, 0.0, 1.0, 0.0]);
    let (integral, quadrature) = spectral::variance(&a, &q, &c, Limits::default()).unwrap();
    assert_relative_eq!(integral.value, printed, max_relative = 1e-11);
    // The paper's claim, in operations: the integral costs many covariance analyses.
    let covariance = bartels_stewart::lyapunov(&a, &q).unwrap();
    assert!(quadrature.evaluations > 50);
    assert!(integral.operations > 10 * covariance.operations);
}

/// Damping 1e-6: an iteration needs the more doublings, and the peaks are a millionth wide.
#[test]
fn light_damping_is_survived_by_every_method() {
    let (ma, mr, ca, cr, da) = (1.0, 0.1, 1.0, 10.0, 1e-6);
    let (a, q) = quarter_car([ma, mr], [ca, cr], da, 1.0);
    assert!(spectral_abscissa(&a).unwrap() < 0.0);
    let printed = 0.5 * (cr * da / (ma * ma) + ca * ca * (ma + mr) / (da * ma * ma));
    for method in LyapunovMethod::ALL {
        let x = method.solve(&a, &q).unwrap().matrix;
        assert_relative_eq!(x[(2, 2)], printed, max_relative = 1e-7);
    }
    let c = DVector::from_column_slice(&[0.0, 0.0, 1.0, 0.0]);
    let (integral, _) = spectral::variance(&a, &q, &c, Limits::default()).unwrap();
    assert_relative_eq!(integral.value, printed, max_relative = 1e-7);
}

#[test]
fn undamped_oscillators_have_no_unique_solution() {
    let a = DMatrix::from_row_slice(2, 2, &[0.0, 1.0, -4.0, 0.0]);
    let q = DMatrix::from_row_slice(2, 2, &[0.0, 0.0, 0.0, 1.0]);
    for method in LyapunovMethod::ALL {
        let refused = match method {
            LyapunovMethod::Smith => NumericError::Unstable,
            _ => NumericError::Singular,
        };
        assert_eq!(method.solve(&a, &q), Err(refused), "{method:?}");
    }
    // Also when Q lies in the range of the map, so that solutions exist, only not one.
    let zero = DMatrix::zeros(2, 2);
    for method in LyapunovMethod::ALL {
        assert!(method.solve(&a, &zero).is_err(), "{method:?}");
    }
}

#[test]
fn input_that_is_no_lyapunov_equation() {
    let two = DMatrix::<f64>::identity(2, 2);
    let skew = DMatrix::from_row_slice(2, 2, &[0.0, 1.0, -1.0, 0.0]);
    let infinite = DMatrix::from_element(2, 2, f64::INFINITY);
    for method in LyapunovMethod::ALL {
        let solve = |a: &DMatrix<f64>, q: &DMatrix<f64>| method.solve(a, q).unwrap_err();
        assert!(matches!(
            solve(&DMatrix::zeros(2, 3), &two),
            NumericError::Shape { .. }
        ));
        assert!(matches!(
            solve(&-&two, &DMatrix::zeros(3, 3)),
            NumericError::Shape { .. }
        ));
        assert_eq!(solve(&-&two, &skew), NumericError::NotSymmetric);
        assert_eq!(solve(&infinite, &two), NumericError::NotFinite);
        assert_eq!(solve(&-&two, &infinite), NumericError::NotFinite);
    }
}

#[test]
fn the_empty_equation_has_the_empty_solution() {
    let empty = DMatrix::zeros(0, 0);
    for method in LyapunovMethod::ALL {
        assert_eq!(method.solve(&empty, &empty).unwrap().matrix, empty);
    }
}
