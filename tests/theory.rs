//! The theory as a library: from matrices to state equations, variances by two ways, and refusals
//! that name what offends.

use num_rational::BigRational;
use proptest::prelude::*;
use ratpoly::{Order, RationalFunction, Ring};
use rederive::domain::{Domain, Rationals, Symbolic};
use rederive::matrix::Matrix;
use rederive::theory::arithmetic::identity;
use rederive::theory::determinant::determinant;
use rederive::theory::error::TheoryError;
use rederive::theory::lyapunov;
use rederive::theory::shape_filter::{ShapeFilter, from_road_to_time};
use rederive::theory::spectrum::TransferFunction;
use rederive::theory::stability::require_stable;
use rederive::theory::state_equations::{Matrices, MultibodySystem, StateEquations};
use rederive::theory::{arithmetic, sign::Sign};

fn q(value: i64) -> BigRational {
    Rationals.integer(value)
}

fn matrix(rows: &[&[i64]]) -> Matrix<BigRational> {
    let rows = rows.iter().map(|r| r.iter().map(|v| q(*v)).collect());
    Matrix::from_rows(rows.collect()).expect("rows of one length")
}

fn symmetric(f: usize) -> impl Strategy<Value = Matrix<BigRational>> {
    proptest::collection::vec(-3i64..4, f * f)
        .prop_map(move |v| Matrix::from_fn(f, f, |i, j| q(v[i.min(j) * f + i.max(j)])))
}

fn skew(f: usize) -> impl Strategy<Value = Matrix<BigRational>> {
    proptest::collection::vec(-3i64..4, f * f).prop_map(move |v| {
        Matrix::from_fn(f, f, |i, j| match i.cmp(&j) {
            std::cmp::Ordering::Less => q(v[i * f + j]),
            std::cmp::Ordering::Equal => q(0),
            std::cmp::Ordering::Greater => q(-v[j * f + i]),
        })
    })
}

/// A symmetric matrix that dominates by its diagonal.
fn definite(f: usize) -> impl Strategy<Value = Matrix<BigRational>> {
    symmetric(f).prop_map(move |m| {
        Matrix::from_fn(f, f, |i, j| {
            if i == j {
                &m[(i, j)] + q(20)
            } else {
                m[(i, j)].clone()
            }
        })
    })
}

fn system(f: usize) -> impl Strategy<Value = Matrices<BigRational>> {
    (definite(f), definite(f), skew(f), definite(f), skew(f)).prop_map(
        |(mass, damping, gyroscopic, stiffness, circulatory)| Matrices {
            mass,
            damping,
            gyroscopic,
            stiffness,
            circulatory,
        },
    )
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(40))]

    /// det(lambda E - A) det M = det(lambda^2 M + lambda (D + G) + K + N).
    #[test]
    fn the_characteristic_polynomial_of_the_second_order_form(
        matrices in (1usize..4).prop_flat_map(system),
        lambda in -4i64..5,
    ) {
        let mass = matrices.mass.clone();
        let f = mass.rows();
        let body = MultibodySystem::new(&Rationals, matrices).unwrap();
        let state = body.state_equations(&Rationals, &identity(&Rationals, f)).unwrap();
        let scaled = arithmetic::scale(&Rationals, &q(lambda), &identity(&Rationals, 2 * f));
        let first = arithmetic::subtract(&Rationals, &scaled, &state.system).unwrap();
        let second = body.characteristic_matrix(&Rationals, &q(lambda)).unwrap();
        let det = |m: &Matrix<BigRational>| determinant(&Rationals, m).unwrap();
        prop_assert_eq!(det(&first) * det(&mass), det(&second));
    }

    /// The integral of the spectrum by the Hurwitz formula is the variance of the Lyapunov equation.
    #[test]
    fn both_ways_to_the_variance_agree(
        matrices in (1usize..4).prop_flat_map(system),
        weights in proptest::collection::vec(-3i64..4, 6),
        forces in proptest::collection::vec(-2i64..3, 3),
        corner in 1i64..5,
        filtered in any::<bool>(),
    ) {
        let f = matrices.mass.rows();
        let body = MultibodySystem::new(&Rationals, matrices).unwrap();
        let input = Matrix::from_fn(f, 1, |i, _| q(forces[i]));
        let mut state = body.state_equations(&Rationals, &input).unwrap();
        if filtered {
            let filter = ShapeFilter::first_order(&Rationals, &q(corner), &q(2)).unwrap();
            state = filter.extend(&Rationals, &state).unwrap();
        }
        prop_assume!(require_stable(&Rationals, "A", &state.system).is_ok());
        let n = state.system.rows();
        let c = Matrix::from_fn(n, 1, |i, _| q(weights.get(i).copied().unwrap_or(1)));
        let transfer = TransferFunction::of_states(&Rationals, &state.system, &state.input, &c).unwrap();
        let by_formula = transfer.variance(&Rationals, &q(3)).unwrap();
        let intensity = state.intensity(&Rationals, &matrix(&[&[3]])).unwrap();
        let p = lyapunov::solve(&Rationals, &state.system, &intensity).unwrap().solution;
        let row = arithmetic::multiply(&Rationals, &c.transpose(), &p).unwrap();
        let by_covariance = arithmetic::multiply(&Rationals, &row, &c).unwrap();
        prop_assert_eq!(&by_formula, &by_covariance[(0, 0)]);
    }

    #[test]
    fn sums_are_split_into_their_parts(matrices in system(3)) {
        let sum = |a: &Matrix<_>, b: &Matrix<_>| arithmetic::add(&Rationals, a, b).unwrap();
        let velocity = sum(&matrices.damping, &matrices.gyroscopic);
        let position = sum(&matrices.stiffness, &matrices.circulatory);
        let split = MultibodySystem::from_sums(
            &Rationals, matrices.mass.clone(), &velocity, &position,
        ).unwrap();
        prop_assert_eq!(split, MultibodySystem::new(&Rationals, matrices).unwrap());
    }
}

fn plain(mass: Matrix<BigRational>) -> Matrices<BigRational> {
    let zero = || matrix(&[&[0, 0], &[0, 0]]);
    Matrices {
        mass,
        damping: matrix(&[&[2, 1], &[1, 2]]),
        gyroscopic: zero(),
        stiffness: matrix(&[&[5, 0], &[0, 5]]),
        circulatory: zero(),
    }
}

#[test]
fn a_mass_matrix_must_be_symmetric_and_positive_definite() {
    let of = |mass| MultibodySystem::new(&Rationals, plain(mass)).unwrap_err();
    assert_eq!(
        of(matrix(&[&[2, 1], &[0, 2]])),
        TheoryError::NotSymmetric {
            matrix: "M",
            place: (1, 2)
        }
    );
    assert_eq!(
        of(matrix(&[&[1, 2], &[2, 1]])),
        TheoryError::NotPositiveDefinite {
            matrix: "M",
            order: 2,
            minor: "-3".into()
        }
    );
    // A mass of zero leaves an equation that is none of motion.
    assert_eq!(
        of(matrix(&[&[0, 0], &[0, 1]])),
        TheoryError::NotPositiveDefinite {
            matrix: "M",
            order: 1,
            minor: "0".into()
        }
    );
    assert!(matches!(
        of(matrix(&[&[1, 0, 0], &[0, 1, 0]])),
        TheoryError::Shape { matrix: "M", .. }
    ));
}

#[test]
fn each_matrix_must_have_its_symmetry() {
    let mass = || matrix(&[&[1, 0], &[0, 1]]);
    let refused = |change: &dyn Fn(&mut Matrices<BigRational>)| {
        let mut matrices = plain(mass());
        change(&mut matrices);
        MultibodySystem::new(&Rationals, matrices).unwrap_err()
    };
    let crooked = || matrix(&[&[0, 1], &[2, 0]]);
    let symmetric = |matrix| TheoryError::NotSymmetric {
        matrix,
        place: (1, 2),
    };
    let skew = |matrix| TheoryError::NotSkew {
        matrix,
        place: (1, 2),
    };
    assert_eq!(refused(&|m| m.damping = crooked()), symmetric("D"));
    assert_eq!(refused(&|m| m.stiffness = crooked()), symmetric("K"));
    assert_eq!(refused(&|m| m.gyroscopic = crooked()), skew("G"));
    assert_eq!(refused(&|m| m.circulatory = crooked()), skew("N"));
    // A diagonal entry is its own mirror image and must vanish.
    assert_eq!(
        refused(&|m| m.gyroscopic = matrix(&[&[1, 0], &[0, 0]])),
        TheoryError::NotSkew {
            matrix: "G",
            place: (1, 1)
        }
    );
    assert!(matches!(
        refused(&|m| m.stiffness = matrix(&[&[1]])),
        TheoryError::Shape { matrix: "K", .. }
    ));
}

#[test]
fn an_unstable_system_is_refused_with_its_hurwitz_determinant() {
    let mut matrices = plain(matrix(&[&[1, 0], &[0, 1]]));
    // A follower force that overcomes the dampers.
    matrices.circulatory = matrix(&[&[0, 9], &[-9, 0]]);
    let body = MultibodySystem::new(&Rationals, matrices).unwrap();
    let state = body
        .state_equations(&Rationals, &matrix(&[&[1], &[0]]))
        .unwrap();
    let Err(TheoryError::Unstable {
        matrix: "A",
        order,
        determinant,
    }) = require_stable(&Rationals, "A", &state.system)
    else {
        panic!("it is not stable");
    };
    assert_eq!(order, 3);
    assert!(determinant.starts_with('-'), "{determinant}");
    let c = matrix(&[&[1], &[0], &[0], &[0]]);
    let transfer =
        TransferFunction::of_states(&Rationals, &state.system, &state.input, &c).unwrap();
    let refused = transfer.variance(&Rationals, &q(1)).unwrap_err();
    assert!(matches!(refused, TheoryError::Unstable { order: 3, .. }));
    let said = refused.to_string();
    assert!(
        said.contains("H_3") && said.contains(&determinant),
        "{said}"
    );
}

#[test]
fn an_output_that_follows_the_noise_has_an_infinite_variance() {
    let of = |numerator: &[i64], denominator: &[i64]| {
        let coefficients = |c: &[i64]| c.iter().map(|v| q(*v)).collect();
        TransferFunction {
            numerator: coefficients(numerator),
            denominator: coefficients(denominator),
        }
        .variance(&Rationals, &q(1))
    };
    // 1/(s + 2): q/(2 a) = 1/4; 3/(2 s + 4) is 3/2 of it.
    let quarter = BigRational::new(1.into(), 4.into());
    assert_eq!(of(&[1], &[1, 2]), Ok(quarter.clone()));
    assert_eq!(of(&[3], &[2, 4]), Ok(quarter * q(9) / q(4)));
    assert_eq!(of(&[0, 0, 1], &[1, 2]), of(&[1], &[1, 2]));
    for (numerator, denominator) in [(&[1, 0][..], &[1, 2][..]), (&[1, 0, 0], &[1, 2])] {
        assert_eq!(
            of(numerator, denominator),
            Err(TheoryError::Improper {
                numerator: numerator.len() - 1,
                denominator: 1
            })
        );
    }
    // Poles on the axis: an undamped oscillator, and an integrator.
    for denominator in [&[1, 0, 4][..], &[1, 1, 0]] {
        assert!(matches!(
            of(&[1], denominator),
            Err(TheoryError::Unstable { .. })
        ));
    }
    assert_eq!(of(&[0], &[1, -2]), Ok(q(0)));
}

#[test]
fn a_shape_filter_must_be_stable_and_a_speed_positive() {
    let column = |v: &[i64]| Matrix::from_fn(v.len(), 1, |i, _| q(v[i]));
    let of = |f: Matrix<BigRational>| {
        let m = f.rows();
        ShapeFilter::new(&Rationals, f, column(&vec![1; m]), column(&vec![1; m]))
    };
    assert!(of(matrix(&[&[0, 1], &[-5, -2]])).is_ok());
    assert!(matches!(
        of(matrix(&[&[0, 1], &[-5, 2]])),
        Err(TheoryError::Unstable {
            matrix: "F",
            order: 1,
            ..
        })
    ));
    assert!(matches!(
        of(matrix(&[&[0, 1], &[5, -2]])),
        Err(TheoryError::Unstable {
            matrix: "F",
            order: 2,
            ..
        })
    ));
    for speed in [0, -20] {
        let refused = TheoryError::NotPositive {
            quantity: "the speed",
            value: speed.to_string(),
        };
        let filter = ShapeFilter::first_order(&Rationals, &q(1), &q(speed));
        assert_eq!(filter.unwrap_err(), refused);
        let density = from_road_to_time(&Rationals, &q(speed), &q(3), |_| q(1));
        assert_eq!(density.unwrap_err(), refused);
    }
    assert!(matches!(
        ShapeFilter::first_order(&Rationals, &q(-1), &q(20)),
        Err(TheoryError::NotPositive { .. })
    ));
    let wide = StateEquations {
        system: matrix(&[&[-1]]),
        input: matrix(&[&[1, 1]]),
    };
    let filter = ShapeFilter::first_order(&Rationals, &q(1), &q(20)).unwrap();
    assert!(matches!(
        filter.extend(&Rationals, &wide),
        Err(TheoryError::Shape { matrix: "B", .. })
    ));
}

/// With letters: signs for all positive values, and nothing guessed where there is no one sign.
#[test]
fn letters_are_positive_and_their_signs_are_proved() {
    let ring = Ring::new(["m", "d", "k", "q"], Order::Grevlex).unwrap();
    let field = Symbolic::new(ring);
    let of = |text: &str| RationalFunction::parse(ring, text).unwrap();
    let one = |text: &str| Matrix::from_fn(1, 1, |_, _| of(text));
    let oscillator = |mass: &str, damping: &str| Matrices {
        mass: one(mass),
        damping: one(damping),
        gyroscopic: one("0"),
        stiffness: one("k"),
        circulatory: one("0"),
    };
    let body = MultibodySystem::new(&field, oscillator("m", "d")).unwrap();
    let state = body.state_equations(&field, &one("1")).unwrap();
    let c = Matrix::from_fn(2, 1, |i, _| field.integer(i64::from(i == 0)));
    let transfer = TransferFunction::of_states(&field, &state.system, &state.input, &c).unwrap();
    assert_eq!(transfer.variance(&field, &of("q")), Ok(of("q/(2*d*k)")));
    assert!(matches!(
        MultibodySystem::new(&field, oscillator("m - k", "d")),
        Err(TheoryError::UnknownSign { .. })
    ));
    assert!(matches!(
        MultibodySystem::new(&field, oscillator("-m", "d")),
        Err(TheoryError::NotPositiveDefinite { order: 1, .. })
    ));
    let falling = MultibodySystem::new(&field, oscillator("m", "-d")).unwrap();
    let state = falling.state_equations(&field, &one("1")).unwrap();
    assert!(matches!(
        require_stable(&field, "A", &state.system),
        Err(TheoryError::Unstable { order: 1, .. })
    ));
    assert_eq!(of("m^2 + d*k").sign(), Some(std::cmp::Ordering::Greater));
    assert_eq!(of("m - m").sign(), Some(std::cmp::Ordering::Equal));
    assert_eq!(of("m - d").sign(), None);
}
