//! Shape filters: coloured noise as the output of a stable linear system under white noise.
//!
//! zeta = h^T v, v' = F v + g w, all eigenvalues of F in the open left half plane. A vehicle
//! x' = A x + b zeta extended by the filter is again a system under white noise,
//!
//! ```text
//! (x, v)' = [ A  b h^T ; 0  F ] (x, v) + [ 0 ; g ] w.
//! ```

use super::error::TheoryError;
use super::sign::Sign;
use super::stability::require_stable;
use super::state_equations::StateEquations;
use crate::domain::Domain;
use crate::matrix::Matrix;

/// A shape filter of order m; F is stable and the shapes fit.
#[derive(Clone, Debug, PartialEq)]
pub struct ShapeFilter<E> {
    system: Matrix<E>,
    input: Matrix<E>,
    output: Matrix<E>,
}

impl<E: Sign + Clone + PartialEq + std::fmt::Debug> ShapeFilter<E> {
    /// The filter with F, g and h; F is m x m, g and h are columns of m entries.
    ///
    /// # Errors
    /// [`TheoryError::Shape`], or [`TheoryError::Unstable`] where F has a pole in the closed right half
    /// plane.
    pub fn new<D: Domain<Element = E>>(
        field: &D,
        system: Matrix<E>,
        input: Matrix<E>,
        output: Matrix<E>,
    ) -> Result<Self, TheoryError> {
        let m = system.rows();
        for (matrix, found, expected) in [
            ("F", system.shape(), (m, m)),
            ("g", input.shape(), (m, 1)),
            ("h", output.shape(), (m, 1)),
        ] {
            if found != expected {
                return Err(TheoryError::Shape {
                    matrix,
                    expected,
                    found,
                });
            }
        }
        require_stable(field, "F", &system)?;
        Ok(ShapeFilter {
            system,
            input,
            output,
        })
    }

    /// First order: a road with the correlation e^(-corner |xi|), travelled at a speed; for w of intensity
    /// 2 corner speed sigma^2 the output has the variance sigma^2.
    ///
    /// # Errors
    /// [`TheoryError::NotPositive`] for the speed or the corner.
    pub fn first_order<D: Domain<Element = E>>(
        field: &D,
        corner: &E,
        speed: &E,
    ) -> Result<Self, TheoryError> {
        require_positive("the speed", speed)?;
        require_positive("the corner wave number", corner)?;
        let pole = field.negate(&field.multiply(corner, speed));
        let one = || Matrix::from_fn(1, 1, |_, _| field.integer(1));
        ShapeFilter::new(
            field,
            Matrix::from_fn(1, 1, |_, _| pole.clone()),
            one(),
            one(),
        )
    }

    /// The states, outputs and inputs of a system x' = A x + b zeta whose excitation is the filter's
    /// output; b is the only column of the input matrix.
    ///
    /// # Errors
    /// [`TheoryError::Shape`] for an input matrix with more columns.
    pub fn extend<D: Domain<Element = E>>(
        &self,
        field: &D,
        vehicle: &StateEquations<E>,
    ) -> Result<StateEquations<E>, TheoryError> {
        let (n, m) = (vehicle.system.rows(), self.system.rows());
        if vehicle.input.shape() != (n, 1) {
            return Err(TheoryError::Shape {
                matrix: "B",
                expected: (n, 1),
                found: vehicle.input.shape(),
            });
        }
        Ok(StateEquations {
            system: Matrix::from_fn(n + m, n + m, |i, j| match (i < n, j < n) {
                (true, true) => vehicle.system[(i, j)].clone(),
                (true, false) => field.multiply(&vehicle.input[(i, 0)], &self.output[(j - n, 0)]),
                (false, true) => field.integer(0),
                (false, false) => self.system[(i - n, j - n)].clone(),
            }),
            input: Matrix::from_fn(n + m, 1, |i, _| {
                if i < n {
                    field.integer(0)
                } else {
                    self.input[(i - n, 0)].clone()
                }
            }),
        })
    }
}

/// The density of a process in time, by its density along the road: Phi(omega / v) / v.
///
/// # Errors
/// [`TheoryError::NotPositive`] unless the speed is positive.
pub fn from_road_to_time<D: Domain>(
    field: &D,
    speed: &D::Element,
    omega: &D::Element,
    density: impl Fn(&D::Element) -> D::Element,
) -> Result<D::Element, TheoryError>
where
    D::Element: Sign,
{
    require_positive("the speed", speed)?;
    let wave_number = field.divide(omega, speed).ok_or(TheoryError::Singular)?;
    field
        .divide(&density(&wave_number), speed)
        .ok_or(TheoryError::Singular)
}

fn require_positive<E: Sign>(quantity: &'static str, value: &E) -> Result<(), TheoryError> {
    if value.is_positive()? {
        Ok(())
    } else {
        Err(TheoryError::NotPositive {
            quantity,
            value: value.to_string(),
        })
    }
}
