//! From a linear multibody system to its state equations.
//!
//! M y'' + (D + G) y' + (K + N) y = h with M symmetric and positive definite, D and K symmetric,
//! G and N skew (Mueller & Schiehlen 1985, ch. 2) becomes x' = A x + B h for x = (y, y'),
//!
//! ```text
//! A = [ 0  E ; -M^-1 (K + N)  -M^-1 (D + G) ],   B = [ 0 ; M^-1 ].
//! ```
//!
//! Invariant: a [`MultibodySystem`] has these properties; they are checked when it is made.

use super::arithmetic::{add, identity, multiply, scale};
use super::determinant::determinant;
use super::error::TheoryError;
use super::linear::{self, Solution};
use super::sign::Sign;
use crate::domain::Domain;
use crate::matrix::Matrix;

/// The matrices of a linear, time-invariant multibody system.
#[derive(Clone, Debug, PartialEq)]
pub struct MultibodySystem<E> {
    mass: Matrix<E>,
    damping: Matrix<E>,
    gyroscopic: Matrix<E>,
    stiffness: Matrix<E>,
    circulatory: Matrix<E>,
}

/// The matrices that a [`MultibodySystem`] is made of.
#[derive(Clone, Debug)]
pub struct Matrices<E> {
    /// M, the inertia.
    pub mass: Matrix<E>,
    /// D, the damping.
    pub damping: Matrix<E>,
    /// G, the gyroscopic forces.
    pub gyroscopic: Matrix<E>,
    /// K, the stiffness.
    pub stiffness: Matrix<E>,
    /// N, the circulatory forces.
    pub circulatory: Matrix<E>,
}

/// State equations x' = A x + B u.
#[derive(Clone, Debug, PartialEq)]
pub struct StateEquations<E> {
    /// A, n x n.
    pub system: Matrix<E>,
    /// B, n x r.
    pub input: Matrix<E>,
}

impl<E: Sign + Clone + PartialEq + std::fmt::Debug> MultibodySystem<E> {
    /// A system with these matrices.
    ///
    /// # Errors
    /// The first property that one of them lacks: shape, symmetry, definiteness of M.
    pub fn new<D: Domain<Element = E>>(
        field: &D,
        matrices: Matrices<E>,
    ) -> Result<Self, TheoryError> {
        let Matrices {
            mass,
            damping,
            gyroscopic,
            stiffness,
            circulatory,
        } = matrices;
        let f = mass.rows();
        let all = [
            ("M", &mass),
            ("D", &damping),
            ("G", &gyroscopic),
            ("K", &stiffness),
            ("N", &circulatory),
        ];
        for (name, matrix) in all {
            if matrix.shape() != (f, f) {
                return Err(TheoryError::Shape {
                    matrix: name,
                    expected: (f, f),
                    found: matrix.shape(),
                });
            }
            let skew = matches!(name, "G" | "N");
            for (i, j) in (0..f).flat_map(|i| (0..=i).map(move |j| (i, j))) {
                let mirrored = &matrix[(j, i)];
                let place = (j + 1, i + 1);
                if skew && matrix[(i, j)] != field.negate(mirrored) {
                    return Err(TheoryError::NotSkew {
                        matrix: name,
                        place,
                    });
                }
                if !skew && matrix[(i, j)] != *mirrored {
                    return Err(TheoryError::NotSymmetric {
                        matrix: name,
                        place,
                    });
                }
            }
        }
        require_positive_definite(field, "M", &mass)?;
        Ok(MultibodySystem {
            mass,
            damping,
            gyroscopic,
            stiffness,
            circulatory,
        })
    }

    /// A system with the velocity and position matrices P = D + G and Q = K + N, which are split into
    /// their symmetric and skew parts.
    ///
    /// # Errors
    /// As [`MultibodySystem::new`].
    pub fn from_sums<D: Domain<Element = E>>(
        field: &D,
        mass: Matrix<E>,
        velocity: &Matrix<E>,
        position: &Matrix<E>,
    ) -> Result<Self, TheoryError> {
        let [damping, gyroscopic] = parts(field, "P", velocity)?;
        let [stiffness, circulatory] = parts(field, "Q", position)?;
        let matrices = Matrices {
            mass,
            damping,
            gyroscopic,
            stiffness,
            circulatory,
        };
        MultibodySystem::new(field, matrices)
    }

    /// The number of degrees of freedom.
    pub fn degrees_of_freedom(&self) -> usize {
        self.mass.rows()
    }

    /// The state equations for the forces h = `input` u; `input` has f rows.
    ///
    /// # Errors
    /// [`TheoryError::Shape`].
    pub fn state_equations<D: Domain<Element = E>>(
        &self,
        field: &D,
        input: &Matrix<E>,
    ) -> Result<StateEquations<E>, TheoryError> {
        let f = self.degrees_of_freedom();
        let shape = || TheoryError::Shape {
            matrix: "the input matrix",
            expected: (f, input.columns()),
            found: input.shape(),
        };
        if input.rows() != f {
            return Err(shape());
        }
        let velocity = add(field, &self.damping, &self.gyroscopic).ok_or_else(shape)?;
        let position = add(field, &self.stiffness, &self.circulatory).ok_or_else(shape)?;
        let minus = field.integer(-1);
        let lower = scale(field, &minus, &self.divided_by_mass(field, &position)?);
        let right = scale(field, &minus, &self.divided_by_mass(field, &velocity)?);
        let below = self.divided_by_mass(field, input)?;
        Ok(StateEquations {
            system: Matrix::from_fn(2 * f, 2 * f, |i, j| match (i < f, j < f) {
                (true, _) => field.integer(i64::from(j == i + f)),
                (false, true) => lower[(i - f, j)].clone(),
                (false, false) => right[(i - f, j - f)].clone(),
            }),
            input: Matrix::from_fn(2 * f, input.columns(), |i, j| {
                if i < f {
                    field.integer(0)
                } else {
                    below[(i - f, j)].clone()
                }
            }),
        })
    }

    /// M^-1 times a matrix.
    fn divided_by_mass<D: Domain<Element = E>>(
        &self,
        field: &D,
        matrix: &Matrix<E>,
    ) -> Result<Matrix<E>, TheoryError> {
        let mut columns = Vec::new();
        for j in 0..matrix.columns() {
            let right = (0..matrix.rows()).map(|i| matrix[(i, j)].clone()).collect();
            match linear::solve(field, self.mass.clone(), right) {
                Solution::Unique { values, .. } => columns.push(values),
                Solution::TooLarge => return Err(TheoryError::Budget),
                _ => return Err(TheoryError::Singular),
            }
        }
        Ok(Matrix::from_fn(matrix.rows(), matrix.columns(), |i, j| {
            columns[j][i].clone()
        }))
    }
}

impl<E: Clone + PartialEq> StateEquations<E> {
    /// The intensity B Q B^T of the white noise that the states see where u has the intensity Q.
    ///
    /// # Errors
    /// [`TheoryError::Shape`].
    pub fn intensity<D: Domain<Element = E>>(
        &self,
        field: &D,
        of_input: &Matrix<E>,
    ) -> Result<Matrix<E>, TheoryError> {
        let r = self.input.columns();
        multiply(field, &self.input, of_input)
            .and_then(|left| multiply(field, &left, &self.input.transpose()))
            .ok_or(TheoryError::Shape {
                matrix: "the intensity",
                expected: (r, r),
                found: of_input.shape(),
            })
    }
}

/// That all leading principal minors of a symmetric matrix are positive (Sylvester's criterion).
///
/// # Errors
/// [`TheoryError::NotPositiveDefinite`] with the first minor that is not.
pub fn require_positive_definite<D: Domain>(
    field: &D,
    name: &'static str,
    matrix: &Matrix<D::Element>,
) -> Result<(), TheoryError>
where
    D::Element: Sign,
{
    for order in 1..=matrix.rows() {
        let minor = determinant(field, &matrix.leading(order)).ok_or(TheoryError::Singular)?;
        if !minor.is_positive()? {
            return Err(TheoryError::NotPositiveDefinite {
                matrix: name,
                order,
                minor: minor.to_string(),
            });
        }
    }
    Ok(())
}

/// The symmetric and the skew part of a square matrix.
fn parts<D: Domain>(
    field: &D,
    name: &'static str,
    matrix: &Matrix<D::Element>,
) -> Result<[Matrix<D::Element>; 2], TheoryError> {
    let f = matrix.rows();
    if !matrix.is_square() {
        return Err(TheoryError::Shape {
            matrix: name,
            expected: (f, f),
            found: matrix.shape(),
        });
    }
    let half = field
        .divide(&field.integer(1), &field.integer(2))
        .ok_or(TheoryError::Singular)?;
    let mixed = |sign: i64| {
        let factor = field.multiply(&half, &field.integer(sign));
        Matrix::from_fn(f, f, |i, j| {
            let own = field.multiply(&half, &matrix[(i, j)]);
            field.add(&own, &field.multiply(&factor, &matrix[(j, i)]))
        })
    };
    Ok([mixed(1), mixed(-1)])
}

impl<E: Sign + Clone + PartialEq + std::fmt::Debug> MultibodySystem<E> {
    /// lambda^2 M + lambda (D + G) + K + N: the matrix whose determinant, divided by det M, is det(lambda E - A).
    ///
    /// # Errors
    /// Never for a system that was made: its matrices have one shape.
    pub fn characteristic_matrix<D: Domain<Element = E>>(
        &self,
        field: &D,
        lambda: &E,
    ) -> Result<Matrix<E>, TheoryError> {
        let square = field.multiply(lambda, lambda);
        let terms = [
            (&self.mass, square),
            (&self.damping, lambda.clone()),
            (&self.gyroscopic, lambda.clone()),
            (&self.stiffness, field.integer(1)),
            (&self.circulatory, field.integer(1)),
        ];
        let zero = scale(field, &field.integer(0), &identity(field, self.mass.rows()));
        terms.iter().try_fold(zero, |sum, (matrix, factor)| {
            add(field, &sum, &scale(field, factor, matrix)).ok_or(TheoryError::Singular)
        })
    }
}
