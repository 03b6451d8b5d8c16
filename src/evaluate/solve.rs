//! `solve` blocks: linear equations for scalars or matrices, solved exactly.
//!
//! The equation's two sides are evaluated with the unknowns at zero and at each unit, which gives
//! the linear system whatever the equation looks like. That it is linear is proved (see [`super::linear`]). The shape of an
//! unknown matrix is the one that fits.
//! Where the map is X -> A X + X A^T, however it is printed, the matrix polynomial of
//! [`crate::theory::lyapunov`] gives the solution. Where the equation is symmetric under transposition
//! of its unknown, n (n + 1) / 2 unknowns do instead of n^2, and that it has no other solution is shown by the skew ones.

use super::{Condition, Evaluator, Failure, FailureKind, Origin, Value, value};
use crate::domain::Domain;
use crate::expr::walk::visit;
use crate::expr::{Font, Name};
use crate::matrix::Matrix;
use crate::model::Node;
use crate::model::degree::NoDegree;
use crate::span::Span;
use crate::theory::arithmetic;
use crate::theory::error::TheoryError;
use crate::theory::linear::{self, Solution};

/// What the equation of a stationary state is about.
#[derive(Clone, Debug)]
pub enum Stationary<E> {
    /// A X + X A^T + Q = 0, up to a factor of either sign: A, and the trace of Q.
    Continuous {
        /// A.
        matrix: Matrix<E>,
        /// The trace of Q.
        noise: E,
    },
    /// X = F X F^T + Q.
    Discrete {
        /// F^2.
        square: Matrix<E>,
    },
}

/// How an equation for a matrix X depends on it.
enum Form<E> {
    Lyapunov([Matrix<E>; 2]),
    Discrete(Matrix<E>),
    Other,
}

pub(super) type Shape = (usize, usize);
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
        let degree = model.degree_in_unknowns(system, &|equation| self.display(equation));
        let degree = degree.map_err(|why| match why {
            NoDegree::NoPolynomial => Failure::new(FailureKind::NotLinear, span),
            NoDegree::NoEquation => Failure::unsupported("what is no equation, to be solved", span),
            NoDegree::Undecided(what) => Failure::unsupported(what, span),
        })?;
        let shapes = self.unknown_shapes(system, unknowns, span)?;
        if degree > 1 {
            let linear = self.require_linear(system, &shapes, degree, span);
            self.frame.trial.clear();
            linear?;
        }
        let by_polynomial = match self.form(system, &shapes, span)? {
            Form::Lyapunov([a, q]) => {
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
                let noise = (0..q.rows()).fold(self.field.integer(0), |sum, i| {
                    self.field.add(&sum, &q[(i, i)])
                });
                let about = Stationary::Continuous { matrix: a, noise };
                self.memo.is_stationary(system, about);
                solved
            }
            Form::Discrete(square) => {
                self.memo
                    .is_stationary(system, Stationary::Discrete { square });
                None
            }
            Form::Other => None,
        };
        let (values, determinant) = match by_polynomial {
            Some(solved) => solved,
            None => {
                let units = self.units(system, &shapes, span)?;
                let result = self.solve_units(system, &shapes, &units, span);
                self.frame.trial.clear();
                let solved = result?;
                if let [(n, columns)] = shapes[..]
                    && n == columns
                    && units.len() < n * n
                {
                    let result = self.refuse_skew_solutions(system, n, span);
                    self.frame.trial.clear();
                    result?;
                }
                solved
            }
        };
        for (position, value) in values.iter().enumerate() {
            self.frame.trial.insert((system, position), value.clone());
        }
        let residual = self.residual(system, span);
        self.frame.trial.clear();
        if residual?.iter().any(|r| !self.field.is_zero(r)) {
            return Err(Failure::new(FailureKind::NotLinear, span));
        }
        self.conditions.push(Condition {
            divisor: determinant,
            origin: Origin::Determinant(model.systems[system].equation),
        });
        Ok(values)
    }

    /// Whether an equation is A X + X A^T + Q = 0 or X = F X F^T + Q for a matrix X, in whatever way it
    /// is printed: A is read off from the images of the diagonal units, and the images of all units must
    /// be those of that map.
    fn form(
        &mut self,
        system: usize,
        shapes: &[Shape],
        span: Span,
    ) -> Result<Form<D::Element>, Failure> {
        let [(n, columns)] = *shapes else {
            return Ok(Form::Other);
        };
        if n != columns || n < 2 {
            return Ok(Form::Other);
        }
        let mut image = |unit: &[(usize, usize, usize)]| {
            self.set_trial(system, shapes, unit);
            let values = self.residual_values(system, span);
            self.frame.trial.clear();
            values.map(|values| match values.as_slice() {
                [Value::Matrix(m)] if m.shape() == (n, n) => Some(m.clone()),
                _ => None,
            })
        };
        let Some(q) = image(&[])? else {
            return Ok(Form::Other);
        };
        let mut images = Vec::with_capacity(n * n);
        for k in 0..n * n {
            let Some(with) = image(&[(0, k / n, k % n)])? else {
                return Ok(Form::Other);
            };
            images.push(with);
        }
        let field = &self.field;
        for image in &mut images {
            *image = Matrix::from_fn(n, n, |i, j| field.subtract(&image[(i, j)], &q[(i, j)]));
        }
        let half = field.divide(&field.integer(1), &field.integer(2));
        let Some(half) = half else {
            return Ok(Form::Other);
        };
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
        if fits {
            return Ok(Form::Lyapunov([a, q]));
        }
        // What else it is, only a covariance needs to know, and only where there are letters.
        let node = Node::Unknown {
            system,
            position: 0,
        };
        let covariance = self.model.covariances().any(|(_, n, _)| n == node);
        Ok(match self.discrete_form(&images, n) {
            Some(square) if covariance => Form::Discrete(square),
            _ => Form::Other,
        })
    }

    /// F^2 of the map X -> X - F X F^T, or its opposite, whose images of the units these are. The
    /// products of two entries of F are seen there, which gives F up to a root: with f = F_ab^2 and
    /// G = F_ab F, F^2 = G^2/f.
    fn discrete_form(&self, images: &[Matrix<D::Element>], n: usize) -> Option<Matrix<D::Element>> {
        let field = &self.field;
        [1, -1].into_iter().find_map(|sign| {
            // F_ir F_js.
            let product = |(i, r): (usize, usize), (j, s): (usize, usize)| {
                let unit = field.integer(i64::from(r == i && s == j));
                let image = &images[r * n + s][(i, j)];
                match sign {
                    1 => field.subtract(&unit, image),
                    _ => field.add(&unit, image),
                }
            };
            let places: Vec<(usize, usize)> = (0..n * n).map(|k| (k / n, k % n)).collect();
            let first = places
                .iter()
                .find(|p| !field.is_zero(&product(**p, **p)))
                .copied();
            let Some(first) = first else {
                let zero = Matrix::from_fn(n, n, |_, _| field.integer(0));
                let none = places
                    .iter()
                    .all(|p| places.iter().all(|q| field.is_zero(&product(*p, *q))));
                return none.then_some(zero);
            };
            let square = product(first, first);
            let scaled = Matrix::from_fn(n, n, |j, s| product(first, (j, s)));
            let fits = places.iter().all(|p| {
                places.iter().all(|q| {
                    field.multiply(&square, &product(*p, *q))
                        == field.multiply(&scaled[*p], &scaled[*q])
                })
            });
            let inverse = field.divide(&field.integer(1), &square)?;
            let product = arithmetic::multiply(field, &scaled, &scaled)?;
            fits.then(|| arithmetic::scale(field, &inverse, &product))
        })
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
            e.frame.trial.clear();
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

    pub(super) fn set_trial(
        &mut self,
        system: usize,
        shapes: &[Shape],
        unit: &[(usize, usize, usize)],
    ) {
        for (u, (rows, columns)) in shapes.iter().enumerate() {
            let value = Matrix::from_fn(*rows, *columns, |i, j| {
                self.field.integer(i64::from(unit.contains(&(u, i, j))))
            });
            self.frame
                .trial
                .insert((system, u), Value::from_matrix(value));
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

    pub(super) fn residual(
        &mut self,
        system: usize,
        span: Span,
    ) -> Result<Vec<D::Element>, Failure> {
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
            self.frame.trial.clear();
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
