//! That equations to be solved are linear in their unknowns, and have no solution beside the one found.
//!
//! Equations are linear by the way they are put together ([`crate::model::degree`]), or, where that gives a degree d
//! beyond one, by their values at all points of the unknowns with coordinates 0, 1, 2, ... whose sum is at
//! most d: a polynomial of total degree d that vanishes there vanishes (K. C. Chung, T. H. Yao, On lattices admitting unique
//! Lagrange interpolations, 1977).

use super::solve::Shape;
use super::{Condition, Evaluator, Failure, FailureKind, Origin, Value};
use crate::domain::Domain;
use crate::matrix::Matrix;
use crate::span::Span;
use crate::theory::linear::{self, Solution};

/// The most points at which it is looked whether an equation is linear.
const MOST_POINTS: usize = 1_000;

impl<D: Domain> Evaluator<'_, D> {
    /// That equations of a degree in their unknowns are linear: they agree with what their values at zero and at
    /// the units make of them on as many points as a polynomial of this degree is known by.
    pub(super) fn require_linear(
        &mut self,
        system: usize,
        shapes: &[Shape],
        degree: u32,
        span: Span,
    ) -> Result<(), Failure> {
        let unknowns: usize = shapes.iter().map(|(rows, columns)| rows * columns).sum();
        let values = |e: &mut Self, point: &[i64]| {
            e.set_point(system, shapes, point);
            e.residual(system, span)
        };
        let mut point = vec![0; unknowns];
        let constant = values(self, &point)?;
        let mut slopes = Vec::with_capacity(unknowns);
        for k in 0..unknowns {
            point[k] = 1;
            let image = values(self, &point)?;
            point[k] = 0;
            if image.len() != constant.len() {
                return Err(Failure::new(FailureKind::NotLinear, span));
            }
            let slope = image.iter().zip(&constant);
            let slope = slope.map(|(with, without)| self.field.subtract(with, without));
            slopes.push(slope.collect::<Vec<_>>());
        }
        let mut seen = 0;
        for sum in 2..=i64::from(degree) {
            let mut next = first_point(unknowns, sum);
            while let Some(point) = next {
                seen += 1;
                if seen > MOST_POINTS {
                    let what = "points at which an equation is seen to be linear".into();
                    return Err(Failure::new(FailureKind::Budget { what }, span));
                }
                let image = values(self, &point)?;
                let linear = image.len() == constant.len()
                    && image.iter().enumerate().all(|(i, value)| {
                        let mut expected = constant[i].clone();
                        for (times, slope) in point.iter().zip(&slopes) {
                            let part = self.field.integer(*times);
                            let part = self.field.multiply(&part, &slope[i]);
                            expected = self.field.add(&expected, &part);
                        }
                        self.field.is_zero(&self.field.subtract(value, &expected))
                    });
                if !linear {
                    return Err(Failure::new(FailureKind::NotLinear, span));
                }
                next = next_point(point);
            }
        }
        Ok(())
    }

    /// That no skew matrix can be added to the solution of an equation that is symmetric under transposition:
    /// every matrix is the sum of a symmetric and a skew one, and the equation keeps them apart.
    pub(super) fn refuse_skew_solutions(
        &mut self,
        system: usize,
        n: usize,
        span: Span,
    ) -> Result<(), Failure> {
        let shapes = [(n, n)];
        self.set_trial(system, &shapes, &[]);
        let constant = self.residual(system, span)?;
        let mut columns = Vec::new();
        for (i, j) in (0..n).flat_map(|i| (0..i).map(move |j| (i, j))) {
            let mut point = vec![0; n * n];
            point[i * n + j] = 1;
            point[j * n + i] = -1;
            self.set_point(system, &shapes, &point);
            let image = self.residual(system, span)?;
            let slope = image.iter().zip(&constant);
            let slope = slope.map(|(with, without)| self.field.subtract(with, without));
            columns.push(slope.collect::<Vec<_>>());
        }
        let matrix = Matrix::from_fn(constant.len(), columns.len(), |i, j| columns[j][i].clone());
        let right = constant.iter().map(|_| self.field.integer(0)).collect();
        match linear::solve(&self.field, matrix, right) {
            Solution::Unique { pivots, .. } => {
                for divisor in pivots {
                    self.conditions.push(Condition {
                        divisor,
                        origin: Origin::Determinant(self.model.systems[system].equation),
                    });
                }
                Ok(())
            }
            Solution::TooLarge => {
                let what = "terms of the solution of a linear system".into();
                Err(Failure::new(FailureKind::Budget { what }, span))
            }
            Solution::Underdetermined | Solution::Inconsistent => {
                Err(Failure::new(FailureKind::Underdetermined, span))
            }
        }
    }

    /// Tries the unknowns with integers for their entries, one unknown after the other, row by row.
    fn set_point(&mut self, system: usize, shapes: &[Shape], point: &[i64]) {
        let mut offset = 0;
        for (u, (rows, columns)) in shapes.iter().enumerate() {
            let value = Matrix::from_fn(*rows, *columns, |i, j| {
                self.field.integer(point[offset + i * columns + j])
            });
            offset += rows * columns;
            self.frame
                .trial
                .insert((system, u), Value::from_matrix(value));
        }
    }
}

/// The first of the points whose coordinates are natural numbers with this sum.
fn first_point(unknowns: usize, sum: i64) -> Option<Vec<i64>> {
    let mut point = vec![0; unknowns];
    *point.first_mut()? = sum;
    Some(point)
}

/// The next one: the last but one coordinate that is not zero gives one to its neighbour, which gets
/// what the last one has.
fn next_point(mut point: Vec<i64>) -> Option<Vec<i64>> {
    let last = point.len().checked_sub(1)?;
    let rest = std::mem::take(&mut point[last]);
    let from = point.iter().rposition(|c| *c > 0)?;
    point[from] -= 1;
    point[from + 1] = rest + 1;
    Some(point)
}

#[cfg(test)]
mod tests {
    use super::{first_point, next_point};

    #[test]
    fn points_of_one_sum_are_met_once_each() {
        for (unknowns, sum, count) in [(1, 5, 1), (2, 3, 4), (3, 2, 6), (4, 3, 20)] {
            let mut seen = std::collections::BTreeSet::new();
            let mut next = first_point(unknowns, sum);
            while let Some(point) = next {
                assert_eq!(point.iter().sum::<i64>(), sum);
                assert!(seen.insert(point.clone()));
                next = next_point(point);
            }
            assert_eq!(seen.len(), count);
        }
    }
}
