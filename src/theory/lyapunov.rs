//! The Lyapunov equation A X + X A^T + Q = 0 by the matrix polynomial (Mueller & Schiehlen 1985,
//! *Linear Vibrations*).
//!
//! With the auxiliary matrices A_m of Faddeev's recursion and the cofactors h_k of the first column
//! of the Hurwitz matrix H of A,
//!
//! ```text
//! 2 det H X = sum over k of h_k (sum over m + l = 2 k of (-1)^m A_m Q A_l^T),
//! ```
//!
//! for every Q and every A for which X is unique. Nothing is divided before the last step, so over
//! rational functions the work is done on polynomials: the denominators of A and Q are cleared,
//! det H is factored once, and each numerator is divided by its irreducible factors.

use super::arithmetic::{identity, multiply, trace};
use super::determinant::{cofactor, determinant};
use super::error::TheoryError;
use super::hurwitz::hurwitz_matrix;
use crate::domain::Domain;
use crate::matrix::Matrix;
use num_bigint::BigInt;
use ratpoly::{Budget, FactoredDenominator, Polynomial, RationalFunction, Ring};

/// The solution, and the determinant of the Hurwitz matrix, whose vanishing is where it ends to be
/// unique.
#[derive(Clone, Debug)]
pub struct Lyapunov<E> {
    /// X.
    pub solution: Matrix<E>,
    /// det H, up to a factor that does not vanish.
    pub determinant: E,
}

/// The shapes: A and Q square, of one order.
fn order<E>(a: &Matrix<E>, q: &Matrix<E>) -> Result<usize, TheoryError> {
    let n = a.rows();
    for (matrix, found) in [("A", a.shape()), ("Q", q.shape())] {
        if found != (n, n) {
            return Err(TheoryError::Shape {
                matrix,
                expected: (n, n),
                found,
            });
        }
    }
    Ok(n)
}

/// Solves A X + X A^T + Q = 0 in the operations of the field.
///
/// # Errors
/// [`TheoryError::Shape`], and [`TheoryError::Singular`] where X is not unique.
pub fn solve<D: Domain>(
    field: &D,
    a: &Matrix<D::Element>,
    q: &Matrix<D::Element>,
) -> Result<Lyapunov<D::Element>, TheoryError> {
    let n = order(a, q)?;
    let singular = || TheoryError::Singular;
    let mut coefficients = vec![field.integer(1)];
    let mut auxiliary = Vec::with_capacity(n);
    let mut current = identity(field, n);
    for m in 1..=n {
        let mut next = multiply(field, a, &current).ok_or_else(singular)?;
        let trace = trace(field, &next).ok_or_else(singular)?;
        let m = field.integer(i64::try_from(m).unwrap_or(i64::MAX));
        let coefficient = field
            .divide(&field.negate(&trace), &m)
            .ok_or_else(singular)?;
        for i in 0..n {
            next[(i, i)] = field.add(&next[(i, i)], &coefficient);
        }
        coefficients.push(coefficient);
        auxiliary.push(std::mem::replace(&mut current, next));
    }
    let hurwitz = hurwitz_matrix(field, &coefficients).ok_or_else(singular)?;
    let determinant = determinant(field, &hurwitz).ok_or_else(singular)?;
    let twice = field.add(&determinant, &determinant);
    let scale = field
        .divide(&field.integer(1), &twice)
        .ok_or_else(singular)?;
    let mut sum = Matrix::from_fn(n, n, |_, _| field.integer(0));
    // Q as the sum of its columns times unit rows: a column of zeros costs nothing.
    for r in (0..n).filter(|r| (0..n).any(|i| !field.is_zero(&q[(i, *r)]))) {
        let column = Matrix::from_fn(n, 1, |i, _| q[(i, r)].clone());
        let before: Vec<Matrix<D::Element>> = auxiliary
            .iter()
            .map(|m| multiply(field, m, &column).ok_or_else(singular))
            .collect::<Result<_, _>>()?;
        for k in 0..n {
            let factor = cofactor(field, &hurwitz, k, 0).ok_or_else(singular)?;
            for m in (2 * k).saturating_sub(n - 1)..=(2 * k).min(n - 1) {
                let signed = if m % 2 == 1 {
                    field.negate(&factor)
                } else {
                    factor.clone()
                };
                let after = &auxiliary[2 * k - m];
                for i in 0..n {
                    let left = field.multiply(&signed, &before[m][(i, 0)]);
                    for j in (0..n).filter(|_| !field.is_zero(&left)) {
                        let term = field.multiply(&left, &after[(j, r)]);
                        sum[(i, j)] = field.add(&sum[(i, j)], &term);
                    }
                }
            }
        }
    }
    Ok(Lyapunov {
        solution: sum.map(|entry| field.multiply(&scale, entry)),
        determinant,
    })
}

/// The same over rational functions, on polynomials.
///
/// # Errors
/// As [`solve`], and [`TheoryError::Budget`].
pub fn solve_symbolic(
    ring: Ring,
    a: &Matrix<RationalFunction>,
    q: &Matrix<RationalFunction>,
) -> Result<Lyapunov<RationalFunction>, TheoryError> {
    let n = order(a, q)?;
    let limit = |_| TheoryError::Budget;
    let budget = Budget::default();
    // A = cleared / below_a and Q = intensity / below_q; then X = below_a / below_q times the solution
    // for the cleared matrices.
    let (cleared, below_a) = cleared(ring, a)?;
    let (intensity, below_q) = self::cleared(ring, q)?;
    let rows = (0..n).map(|i| (0..n).map(|j| cleared[(i, j)].clone()).collect());
    let matrix = ratpoly::Matrix::<Polynomial>::new(ring, rows.collect()).map_err(limit)?;
    let recursion = matrix.faddeev_le_verrier(&budget).map_err(limit)?;
    let (cofactors, determinant) =
        ratpoly::hurwitz_cofactors(ring, &recursion.coefficients, &budget).map_err(limit)?;
    if determinant.is_zero() {
        return Err(TheoryError::Singular);
    }
    let columns: Vec<usize> = (0..n)
        .filter(|r| (0..n).any(|i| !intensity[(i, *r)].is_zero()))
        .collect();
    // before[r][m] = (-1)^m A_m times column r of the intensity.
    let mut before: Vec<Vec<Vec<Polynomial>>> = Vec::new();
    for r in &columns {
        let column: Vec<&Polynomial> = (0..n).map(|i| &intensity[(i, *r)]).collect();
        let mut vectors = Vec::new();
        for (m, auxiliary) in recursion.matrices.iter().take(n).enumerate() {
            let mut vector = Vec::new();
            for i in 0..n {
                let pairs = auxiliary.row(i).iter().zip(column.iter().copied());
                let sum = sum_of_products(ring, pairs, &budget)?;
                vector.push(if m % 2 == 1 { -&sum } else { sum });
            }
            vectors.push(vector);
        }
        before.push(vectors);
    }
    let symmetric = *q == q.transpose();
    let denominator = (&determinant.mul_integer(&BigInt::from(2))) * &below_q;
    let common = FactoredDenominator::new(&denominator).map_err(limit)?;
    let mut entries: Vec<Option<RationalFunction>> = vec![None; n * n];
    for i in 0..n {
        for j in 0..n {
            if symmetric && j < i {
                entries[i * n + j] = entries[j * n + i].clone();
                continue;
            }
            let mut forms = Vec::with_capacity(n);
            for k in 0..n {
                let mut pairs = Vec::new();
                for (vectors, r) in before.iter().zip(&columns) {
                    for (m, vector) in vectors.iter().enumerate().take(2 * k + 1) {
                        // Beyond the last auxiliary matrix they are zero.
                        let after = recursion.matrices[..n].get(2 * k - m);
                        let after = after.and_then(|matrix| matrix.get(j, *r));
                        pairs.extend(after.map(|after| (&vector[i], after)));
                    }
                }
                forms.push(sum_of_products(ring, pairs.into_iter(), &budget)?);
            }
            let sum = sum_of_products(ring, forms.iter().zip(&cofactors), &budget)?;
            let numerator = &sum * &below_a;
            entries[i * n + j] = Some(common.reduce(&numerator).map_err(limit)?);
        }
    }
    let zero = RationalFunction::zero(ring);
    Ok(Lyapunov {
        solution: Matrix::from_fn(n, n, |i, j| {
            entries[i * n + j].clone().unwrap_or_else(|| zero.clone())
        }),
        determinant: RationalFunction::from(determinant),
    })
}

/// A matrix as polynomials over one denominator.
fn cleared(
    ring: Ring,
    matrix: &Matrix<RationalFunction>,
) -> Result<(Matrix<Polynomial>, Polynomial), TheoryError> {
    let denominator = matrix.iter().fold(Polynomial::one(ring), |common, entry| {
        ratpoly::lcm(&common, entry.denominator())
    });
    let cleared = matrix.try_map(|entry| {
        let factor = denominator.div_exact(entry.denominator());
        let factor = factor.ok_or(TheoryError::Budget)?;
        Ok(entry.numerator() * &factor)
    })?;
    Ok((cleared, denominator))
}

/// A sum of products, paid for beforehand.
fn sum_of_products<'a>(
    ring: Ring,
    pairs: impl Iterator<Item = (&'a Polynomial, &'a Polynomial)>,
    budget: &Budget,
) -> Result<Polynomial, TheoryError> {
    let pairs: Vec<_> = pairs
        .filter(|(f, g)| !f.is_zero() && !g.is_zero())
        .collect();
    let work = pairs.iter().map(|(f, g)| f.len() as u64 * g.len() as u64);
    budget.spend(work.sum()).map_err(|_| TheoryError::Budget)?;
    Polynomial::sum_of_products(ring, pairs).map_err(|_| TheoryError::Budget)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::domain::{PrimeField, Rationals, Symbolic};
    use crate::theory::arithmetic::add;
    use num_rational::BigRational;
    use proptest::prelude::*;
    use ratpoly::Order;

    fn residual<D: Domain>(
        field: &D,
        a: &Matrix<D::Element>,
        x: &Matrix<D::Element>,
        q: &Matrix<D::Element>,
    ) -> Matrix<D::Element> {
        let ax = multiply(field, a, x).unwrap();
        let xa = multiply(field, x, &a.transpose()).unwrap();
        add(field, &add(field, &ax, &xa).unwrap(), q).unwrap()
    }

    fn matrix(n: usize, entries: &[i64]) -> Matrix<BigRational> {
        Matrix::from_fn(n, n, |i, j| Rationals.integer(entries[i * n + j]))
    }

    proptest! {
        /// Whatever Q is, symmetric or not, and wherever the eigenvalues lie.
        #[test]
        fn the_residual_vanishes(
            n in 1usize..6,
            a in proptest::collection::vec(-3i64..4, 25),
            q in proptest::collection::vec(-2i64..3, 25),
        ) {
            let (a, q) = (matrix(n, &a), matrix(n, &q));
            match solve(&Rationals, &a, &q) {
                Ok(found) => {
                    let rest = residual(&Rationals, &a, &found.solution, &q);
                    prop_assert!(rest.iter().all(|e| Rationals.is_zero(e)));
                }
                Err(error) => prop_assert_eq!(error, TheoryError::Singular),
            }
        }
    }

    #[test]
    fn symbols_with_denominators_and_numbers_agree() {
        let ring = Ring::new(["m", "k", "d", "q"], Order::Grevlex).unwrap();
        let field = Symbolic::new(ring);
        let parse = |text: &str| RationalFunction::parse(ring, text).unwrap();
        let a = Matrix::from_rows(vec![
            vec![parse("0"), parse("1")],
            vec![parse("-k/m"), parse("-d/m")],
        ])
        .unwrap();
        let q = Matrix::from_rows(vec![
            vec![parse("0"), parse("0")],
            vec![parse("0"), parse("q/m^2")],
        ])
        .unwrap();
        let found = solve_symbolic(ring, &a, &q).unwrap();
        assert_eq!(found.solution[(0, 0)], parse("q/(2*d*k)"));
        assert_eq!(found.solution[(1, 1)], parse("q/(2*d*m)"));
        assert!(found.solution[(0, 1)].is_zero());
        assert_eq!(found.solution, solve(&field, &a, &q).unwrap().solution);
        let skew = Matrix::from_fn(2, 2, |i, j| parse(["0", "q", "-q", "d/k"][2 * i + j]));
        let found = solve_symbolic(ring, &a, &skew).unwrap().solution;
        assert_eq!(found, solve(&field, &a, &skew).unwrap().solution);
    }

    #[test]
    fn an_eigenvalue_and_its_negative_leave_nothing_unique() {
        let a = matrix(2, &[1, 0, 0, -1]);
        let q = matrix(2, &[1, 0, 0, 1]);
        assert_eq!(
            solve(&Rationals, &a, &q).unwrap_err(),
            TheoryError::Singular
        );
        let a = Matrix::from_fn(2, 2, |i, j| [0, 1, crate::domain::PRIME - 4, 0][2 * i + j]);
        let q = Matrix::from_fn(2, 2, |_, _| 1);
        assert_eq!(
            solve(&PrimeField, &a, &q).unwrap_err(),
            TheoryError::Singular
        );
    }

    #[test]
    fn shapes_are_asked_for() {
        let a = matrix(2, &[1, 0, 0, -1]);
        let q = matrix(3, &[0; 9]);
        assert!(matches!(
            solve(&Rationals, &a, &q),
            Err(TheoryError::Shape { matrix: "Q", .. })
        ));
    }
}
