//! Linear matrix equations as one system for all entries of the unknowns.
//!
//! With `vec` stacking columns, `vec(A X B) = (B^T (x) A) vec X`, so that the Lyapunov equation is
//! `(E (x) A + A (x) E) vec X = -vec Q` (MacDuffee, *The Theory of Matrices*, 1933, section 46).
//! The general solver needs no such formula: a linear map is known by its values at the basis
//! matrices, whatever the equation looks like in print.

use super::linear::solve;
use super::{NumericError, Solution, cost, order_of_lyapunov, power_of_two_below, symmetrised};
use nalgebra::DMatrix;

/// The symmetric solution `X` of `A X + X A^T + Q = 0`; all matrices `n x n`, `Q` symmetric.
///
/// `2/3 n^6` operations for the LU factors of the `n^2 x n^2` system.
/// [`NumericError::Singular`] when two eigenvalues of `A` have the sum zero to working precision.
pub fn lyapunov(a: &DMatrix<f64>, q: &DMatrix<f64>) -> Result<Solution, NumericError> {
    let n = order_of_lyapunov(a, q)?;
    let unit = DMatrix::identity(n, n);
    let system = unit.kronecker(a) + a.kronecker(&unit);
    let rhs = DMatrix::from_column_slice(n * n, 1, (-q).as_slice());
    let x = solve(&system, &rhs)?;
    Ok(Solution {
        matrix: symmetrised(&DMatrix::from_column_slice(n, n, x.as_slice())),
        operations: cost::lu(n * n) + cost::triangular_solves(n * n, 1),
    })
}

/// How far above the constant part of a map its basis matrices lie.
const ABOVE: f64 = (1u128 << 100) as f64;

/// The zeros of a map that is affine in the unknown matrices.
///
/// `shapes` are the shapes of the unknowns; `map` gives the left-hand sides (each minus its
/// right-hand side) of the equations, of any shapes, as many scalars in all as there are
/// unknown scalars. With `N` scalars: `N + 3` evaluations and `2/3 N^3` operations. The map is
/// checked for linearity at two further points ([`NumericError::NotLinear`]).
///
/// The columns of the system are differences `f(t E_k) - f(0)`. With `t = 1` they would lose the
/// digits in which `f(0)` is larger; `t` is a power of two so large that `f(0)` is lost instead,
/// which is known anyway.
pub fn solve_affine<E: From<NumericError>>(
    shapes: &[(usize, usize)],
    mut map: impl FnMut(&[DMatrix<f64>]) -> Result<Vec<DMatrix<f64>>, E>,
) -> Result<Vec<DMatrix<f64>>, E> {
    let unknowns: usize = shapes.iter().map(|(rows, columns)| rows * columns).sum();
    let mut at = |vector: &[f64]| map(&unstack(vector, shapes)).map(|values| stack(&values));

    let constant = at(&vec![0.0; unknowns])?;
    let equations = constant.len();
    if equations != unknowns {
        return Err(NumericError::Count {
            equations,
            unknowns,
        }
        .into());
    }
    let largest = constant.iter().fold(0.0f64, |max, c| max.max(c.abs()));
    if constant.iter().any(|c| !c.is_finite()) {
        return Err(NumericError::NotFinite.into());
    }
    let t = if largest > 0.0 {
        power_of_two_below(largest) * ABOVE
    } else {
        1.0
    };
    let mut system = DMatrix::zeros(unknowns, unknowns);
    let mut basis = vec![0.0; unknowns];
    for j in 0..unknowns {
        basis[j] = t;
        let value = at(&basis)?;
        basis[j] = 0.0;
        if value.len() != equations {
            return Err(NumericError::NotLinear.into());
        }
        for (i, (v, c)) in value.iter().zip(&constant).enumerate() {
            system[(i, j)] = (v - c) / t;
        }
    }
    for scale in [1.0, t] {
        require_linear(&system, &constant, scale, &mut at)?;
    }
    let rhs = -DMatrix::from_column_slice(unknowns, 1, &constant);
    let x = solve(&system, &rhs)?;
    Ok(unstack(x.as_slice(), shapes))
}

/// Compares the map with its linear model at a point of this size without symmetry.
fn require_linear<E: From<NumericError>>(
    system: &DMatrix<f64>,
    constant: &[f64],
    scale: f64,
    at: &mut impl FnMut(&[f64]) -> Result<Vec<f64>, E>,
) -> Result<(), E> {
    let n = constant.len();
    // Multiples of 1/8 between 1 and 3, some negative: neither they nor their products cancel.
    let point: Vec<f64> = (0..n)
        .map(|k| {
            let size = scale * (1.0 + ((5 * k + 3) % 16) as f64 / 8.0);
            if k % 3 == 1 { -size } else { size }
        })
        .collect();
    let value = at(&point)?;
    let close = value.len() == n
        && (0..n).all(|i| {
            let mut model = constant[i];
            let mut size = constant[i].abs() + value[i].abs();
            for (j, x) in point.iter().enumerate() {
                model += system[(i, j)] * x;
                size += (system[(i, j)] * x).abs();
            }
            (value[i] - model).abs() <= 1e-9 * size
        });
    if close {
        Ok(())
    } else {
        Err(NumericError::NotLinear.into())
    }
}

fn stack(matrices: &[DMatrix<f64>]) -> Vec<f64> {
    matrices.iter().flat_map(|m| m.iter().copied()).collect()
}

fn unstack(vector: &[f64], shapes: &[(usize, usize)]) -> Vec<DMatrix<f64>> {
    let mut rest = vector;
    shapes
        .iter()
        .map(|&(rows, columns)| {
            let (head, tail) = rest.split_at(rows * columns);
            rest = tail;
            DMatrix::from_column_slice(rows, columns, head)
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    fn matrix(n: usize, entries: &[f64]) -> DMatrix<f64> {
        DMatrix::from_row_slice(n, n, entries)
    }

    #[test]
    fn a_discrete_lyapunov_equation_needs_no_formula() {
        // X - A X A^T - Q = 0: not of the continuous form, and still linear.
        let a = matrix(2, &[0.5, 0.1, -0.2, 0.3]);
        let q = matrix(2, &[2.0, 1.0, 1.0, 3.0]);
        let x = solve_affine::<NumericError>(&[(2, 2)], |x| {
            Ok(vec![&x[0] - &a * &x[0] * a.transpose() - &q])
        })
        .unwrap()
        .remove(0);
        let residual = &x - &a * &x * a.transpose() - &q;
        assert!(residual.amax() < 1e-14);
    }

    #[test]
    fn two_unknowns_of_different_shapes() {
        // M x = y, x + y = b with x, y columns of three and two entries stacked crosswise.
        let x = solve_affine::<NumericError>(&[(2, 1), (1, 1)], |u| {
            let (x, s) = (&u[0], &u[1]);
            Ok(vec![
                DMatrix::from_element(1, 1, x[0] + x[1] - 3.0),
                DMatrix::from_column_slice(2, 1, &[x[0] - s[0], 2.0 * x[1] - s[0]]),
            ])
        })
        .unwrap();
        assert_relative_eq!(x[0][0], 2.0, max_relative = 1e-14);
        assert_relative_eq!(x[0][1], 1.0, max_relative = 1e-14);
        assert_relative_eq!(x[1][0], 2.0, max_relative = 1e-14);
    }

    #[test]
    fn a_quadratic_equation_is_not_linear() {
        let quadratic = |x: &[DMatrix<f64>]| Ok(vec![&x[0] * &x[0] - DMatrix::identity(2, 2)]);
        assert_eq!(
            solve_affine::<NumericError>(&[(2, 2)], quadratic),
            Err(NumericError::NotLinear)
        );
        let bilinear = |x: &[DMatrix<f64>]| {
            let product = x[0][0] * x[0][1];
            Ok(vec![DMatrix::from_column_slice(2, 1, &[product, x[0][0]])])
        };
        assert_eq!(
            solve_affine::<NumericError>(&[(2, 1)], bilinear),
            Err(NumericError::NotLinear)
        );
    }

    #[test]
    fn a_large_constant_does_not_swallow_a_small_coefficient() {
        // 3e-9 x + 1e12 = 0: with the basis at 1 the coefficient would come out as 0.
        let x = solve_affine::<NumericError>(&[(1, 1)], |x| {
            Ok(vec![DMatrix::from_element(1, 1, 3e-9 * x[0][0] + 1e12)])
        })
        .unwrap();
        assert_relative_eq!(x[0][0], -1e21 / 3.0, max_relative = 1e-15);
    }

    #[test]
    fn a_small_quadratic_term_beside_a_large_constant_is_seen() {
        let quadratic = |x: &[DMatrix<f64>]| {
            let x = x[0][0];
            Ok(vec![DMatrix::from_element(1, 1, 1e-6 * x * x + x + 1e12)])
        };
        assert_eq!(
            solve_affine::<NumericError>(&[(1, 1)], quadratic),
            Err(NumericError::NotLinear)
        );
    }

    #[test]
    fn too_few_equations_and_dependent_ones_are_refused() {
        let trace = |x: &[DMatrix<f64>]| Ok(vec![DMatrix::from_element(1, 1, x[0].trace())]);
        assert_eq!(
            solve_affine::<NumericError>(&[(2, 2)], trace),
            Err(NumericError::Count {
                equations: 1,
                unknowns: 4
            })
        );
        // X - X^T = 0 leaves every symmetric matrix free.
        let skew = |x: &[DMatrix<f64>]| Ok(vec![&x[0] - x[0].transpose()]);
        assert_eq!(
            solve_affine::<NumericError>(&[(2, 2)], skew),
            Err(NumericError::Singular)
        );
    }
}
