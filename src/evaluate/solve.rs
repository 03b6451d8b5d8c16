//! `solve` blocks: linear equations for scalars or matrices, solved exactly.
//!
//! The equation's two sides are evaluated with the unknowns at zero and at each unit, which gives
//! the linear system whatever the equation looks like; the solution is then inserted, so that an
//! equation that is not linear cannot pass. The shape of an unknown matrix is the one that fits.
//! Where the map is X -> A X + X A^T, however it is printed, the matrix polynomial of
//! [`crate::theory::lyapunov`] gives the solution. Where the equation is symmetric under transposition
//! of its unknown, its unique solution is symmetric, and n (n + 1) / 2 unknowns do instead of n^2.

use super::{Condition, Evaluator, Failure, FailureKind, Origin, Value, value};
use crate::domain::Domain;
use crate::expr::{Font, Name};
use crate::matrix::Matrix;
use crate::model::links::visit;
use crate::span::Span;
use crate::theory::error::TheoryError;
use crate::theory::linear::{self, Solution};

type Shape = (usize, usize);
/// A scalar degree of freedom: the entries (unknown, row, column) that are one where it is one.
type Unit = Vec<(usize, usize, usize)>;
/// The unknowns and the determinant of their system.
type Solved<E> = (Vec<Value<E>>, E);

impl<D: Domain> Evaluator<'_, D> {
    /// The unknowns of a system.
    pub(super) fn solve(
        &mut self,
        system: usize,
        span: Span,
    ) -> Result<Vec<Value<D::Element>>, Failure> {
        let model = self.model;
        let unknowns = &model.systems[system].unknowns;
        let shapes = self.unknown_shapes(system, unknowns, span)?;
        let by_polynomial = match self.lyapunov_form(system, &shapes, span)? {
            Some([a, q]) => {
                let solved = match self.field.lyapunov(&a, &q) {
                    Ok(found) => {
                        Some((vec![Value::from_matrix(found.solution)], found.determinant))
                    }
                    Err(TheoryError::Budget) => {
                        let what = "terms of the solution of a Lyapunov equation".into();
                        return Err(Failure::new(FailureKind::Budget { what }, span));
                    }
                    // Which of the two, none or many, elimination tells.
                    Err(_) => None,
                };
                self.lyapunov.insert(system, a);
                solved
            }
            None => None,
        };
        let (values, determinant) = match by_polynomial {
            Some(solved) => solved,
            None => {
                let units = self.units(system, &shapes, span)?;
                let result = self.solve_units(system, &shapes, &units, span);
                self.trial.clear();
                result?
            }
        };
        for (position, value) in values.iter().enumerate() {
            self.trial.insert((system, position), value.clone());
        }
        let residual = self.residual(system, span);
        self.trial.clear();
        if residual?.iter().any(|r| !self.field.is_zero(r)) {
            return Err(Failure::new(FailureKind::NotLinear, span));
        }
        self.conditions.push(Condition {
            divisor: determinant,
            origin: Origin::Determinant(model.systems[system].equation),
        });
        Ok(values)
    }

    /// The matrices A and Q of an equation A X + X A^T + Q = 0 for a matrix X, in whatever way it is
    /// printed: A is read off from the images of the diagonal units, and the images of all units must
    /// be those of that map.
    fn lyapunov_form(
        &mut self,
        system: usize,
        shapes: &[Shape],
        span: Span,
    ) -> Result<Option<[Matrix<D::Element>; 2]>, Failure> {
        let [(n, columns)] = *shapes else {
            return Ok(None);
        };
        if n != columns || n < 2 {
            return Ok(None);
        }
        let mut image = |unit: &[(usize, usize, usize)]| {
            self.set_trial(system, shapes, unit);
            let values = self.residual_values(system, span);
            self.trial.clear();
            values.map(|values| match values.as_slice() {
                [Value::Matrix(m)] if m.shape() == (n, n) => Some(m.clone()),
                _ => None,
            })
        };
        let Some(q) = image(&[])? else {
            return Ok(None);
        };
        let mut images = Vec::with_capacity(n * n);
        for k in 0..n * n {
            let Some(with) = image(&[(0, k / n, k % n)])? else {
                return Ok(None);
            };
            images.push(with);
        }
        let field = &self.field;
        for image in &mut images {
            *image = Matrix::from_fn(n, n, |i, j| field.subtract(&image[(i, j)], &q[(i, j)]));
        }
        let half = field.divide(&field.integer(1), &field.integer(2));
        let Some(half) = half else { return Ok(None) };
        let a = Matrix::from_fn(n, n, |i, j| {
            let entry = &images[j * n + j][(i, j)];
            if i == j {
                field.multiply(&half, entry)
            } else {
                entry.clone()
            }
        });
        // The image of the unit (r, s): column r of A in column s, and column s of A in row r.
        let fits = (0..n * n).all(|k| {
            let (r, s) = (k / n, k % n);
            (0..n * n).all(|place| {
                let (i, j) = (place / n, place % n);
                let mut expected = field.integer(0);
                if j == s {
                    expected = field.add(&expected, &a[(i, r)]);
                }
                if i == r {
                    expected = field.add(&expected, &a[(j, s)]);
                }
                images[k][(i, j)] == expected
            })
        });
        Ok(fits.then_some([a, q]))
    }

    /// The scalar degrees of freedom: each a list of (unknown, row, column) that are one.
    fn units(&mut self, system: usize, shapes: &[Shape], span: Span) -> Result<Vec<Unit>, Failure> {
        if let [(n, columns)] = shapes
            && n == columns
            && *n > 1
            && self.is_symmetric(system, *n, span)?
        {
            return Ok((0..*n)
                .flat_map(|i| (i..*n).map(move |j| (i, j)))
                .map(|(i, j)| {
                    if i == j {
                        vec![(0, i, i)]
                    } else {
                        vec![(0, i, j), (0, j, i)]
                    }
                })
                .collect());
        }
        Ok(shapes
            .iter()
            .enumerate()
            .flat_map(|(u, (rows, columns))| {
                (0..rows * columns).map(move |k| vec![(u, k / columns, k % columns)])
            })
            .collect())
    }

    /// Whether the transposed unknown gives the transposed residual.
    fn is_symmetric(&mut self, system: usize, n: usize, span: Span) -> Result<bool, Failure> {
        let residual = |e: &mut Self, unit: &[(usize, usize, usize)]| {
            e.set_trial(system, &[(n, n)], unit);
            let r = e.residual_values(system, span);
            e.trial.clear();
            r
        };
        let square = |values: Vec<Value<D::Element>>| match values.as_slice() {
            [Value::Matrix(m)] if m.shape() == (n, n) => Some(m.clone()),
            _ => None,
        };
        let Some(zero) = square(residual(self, &[])?) else {
            return Ok(false);
        };
        if zero != zero.transpose() {
            return Ok(false);
        }
        for i in 0..n {
            for j in 0..i {
                let (lower, upper) = (
                    square(residual(self, &[(0, i, j)])?),
                    square(residual(self, &[(0, j, i)])?),
                );
                if lower.map(|m| m.transpose()) != upper {
                    return Ok(false);
                }
            }
        }
        Ok(true)
    }

    fn solve_units(
        &mut self,
        system: usize,
        shapes: &[Shape],
        units: &[Unit],
        span: Span,
    ) -> Result<Solved<D::Element>, Failure> {
        self.set_trial(system, shapes, &[]);
        let constant = self.residual(system, span)?;
        let mut columns = Vec::with_capacity(units.len());
        for unit in units {
            self.set_trial(system, shapes, unit);
            let image = self.residual(system, span)?;
            columns.push(
                image
                    .iter()
                    .zip(&constant)
                    .map(|(with, without)| self.field.subtract(with, without))
                    .collect::<Vec<_>>(),
            );
        }
        let matrix = Matrix::from_fn(constant.len(), units.len(), |i, j| columns[j][i].clone());
        let right = constant.iter().map(|r| self.field.negate(r)).collect();
        match linear::solve(&self.field, matrix, right) {
            Solution::Unique { values, pivots } => {
                let mut determinant = self.field.integer(1);
                for pivot in &pivots {
                    let sizes = [&determinant, pivot].map(|e| self.field.size(e));
                    if sizes[0].saturating_mul(sizes[1]) > super::LARGEST_PRODUCT {
                        let what = "terms of the determinant of a linear system".into();
                        return Err(Failure::new(FailureKind::Budget { what }, span));
                    }
                    determinant = self.field.multiply(&determinant, pivot);
                }
                let solution = shapes
                    .iter()
                    .enumerate()
                    .map(|(u, (rows, columns))| {
                        Value::from_matrix(Matrix::from_fn(*rows, *columns, |i, j| {
                            units
                                .iter()
                                .position(|unit| unit.contains(&(u, i, j)))
                                .map_or_else(|| self.field.integer(0), |k| values[k].clone())
                        }))
                    })
                    .collect();
                Ok((solution, determinant))
            }
            Solution::TooLarge => {
                let what = "terms of the solution of a linear system".into();
                Err(Failure::new(FailureKind::Budget { what }, span))
            }
            Solution::Underdetermined => Err(Failure::new(FailureKind::Underdetermined, span)),
            Solution::Inconsistent => Err(Failure::new(FailureKind::Inconsistent, span)),
        }
    }

    fn set_trial(&mut self, system: usize, shapes: &[Shape], unit: &[(usize, usize, usize)]) {
        for (u, (rows, columns)) in shapes.iter().enumerate() {
            let value = Matrix::from_fn(*rows, *columns, |i, j| {
                self.field.integer(i64::from(unit.contains(&(u, i, j))))
            });
            self.trial.insert((system, u), Value::from_matrix(value));
        }
    }

    /// Left minus right of every link of the system's equation.
    fn residual_values(
        &mut self,
        system: usize,
        span: Span,
    ) -> Result<Vec<Value<D::Element>>, Failure> {
        let equation = self.model.systems[system].equation;
        let display = self.display(equation).clone();
        let mut residuals = Vec::new();
        for clause in &display.clauses {
            for pair in clause.chain.members.windows(2) {
                let left = self.expression(&pair[0])?;
                let right = self.expression(&pair[1])?;
                residuals.push(value::subtract(&self.field, &left, &right, span)?);
            }
        }
        Ok(residuals)
    }

    fn residual(&mut self, system: usize, span: Span) -> Result<Vec<D::Element>, Failure> {
        Ok(self
            .residual_values(system, span)?
            .iter()
            .flat_map(|v| v.entries().into_iter().cloned().collect::<Vec<_>>())
            .collect())
    }

    /// The shapes of the unknowns: a light letter is a scalar; a bold one is a matrix of the one
    /// shape, made of the sizes that occur in the equation, for which the equation makes sense.
    fn unknown_shapes(
        &mut self,
        system: usize,
        unknowns: &[Name],
        span: Span,
    ) -> Result<Vec<Shape>, Failure> {
        if unknowns.iter().all(|u| u.letter.font != Font::Bold) {
            return Ok(vec![(1, 1); unknowns.len()]);
        }
        let mut sizes = self.sizes_in(system);
        sizes.sort_unstable();
        sizes.dedup();
        let candidates: Vec<Shape> = sizes
            .iter()
            .flat_map(|r| sizes.iter().map(move |c| (*r, *c)))
            .collect();
        let mut fitting: Vec<Vec<Shape>> = vec![Vec::new()];
        for unknown in unknowns {
            let options: &[Shape] = if unknown.letter.font == Font::Bold {
                &candidates
            } else {
                &[(1, 1)]
            };
            fitting = fitting
                .iter()
                .flat_map(|chosen| {
                    options.iter().map(move |o| {
                        let mut longer = chosen.clone();
                        longer.push(*o);
                        longer
                    })
                })
                .collect();
        }
        fitting.retain(|shapes| {
            // A unit and not zero, since zeros of wrong shape may slip through products.
            let ones: Vec<_> = (0..shapes.len()).map(|u| (u, 0, 0)).collect();
            self.set_trial(system, shapes, &ones);
            let fits = self.residual_values(system, span).is_ok();
            self.trial.clear();
            fits
        });
        // A matrix, where both a matrix and a scalar would do.
        fitting.sort_by_key(|shapes| {
            std::cmp::Reverse(shapes.iter().map(|s| s.0 * s.1).sum::<usize>())
        });
        fitting.into_iter().next().ok_or_else(|| {
            Failure::new(
                FailureKind::Shape {
                    operation: "solve".into(),
                    left: "unknown".into(),
                    right: "no shape fits the equation".into(),
                },
                span,
            )
        })
    }

    fn sizes_in(&mut self, system: usize) -> Vec<usize> {
        let equation = self.model.systems[system].equation;
        let display = self.display(equation).clone();
        let mut sizes = vec![1];
        for member in display.clauses.iter().flat_map(|c| &c.chain.members) {
            let mut parts = Vec::new();
            visit(member, &mut |e| parts.push(e));
            for part in parts {
                if let Ok(Some((rows, columns))) = self.expression(part).map(|v| v.shape()) {
                    sizes.extend([rows, columns]);
                }
            }
        }
        sizes
    }
}
