//! `solve` blocks: the equations evaluated once, with linear forms for the unknowns.
//!
//! A product of two forms is refused, so what is solved is linear in the unknowns; elimination with
//! certain pivots then encloses the one solution. A light letter is a scalar; a bold one has the
//! largest shape, made of the sizes in the equations, for which they make sense and determine it.

use super::elimination::definite;
use super::evaluator::{Evaluator, Result};
use super::failure::{Reason, Undefined};
use super::jet::Jet;
use super::letters::LayerKind;
use super::value::Value;
use super::world::normal;
use crate::expr::walk::children;
use crate::expr::{Expr, Font};
use crate::latex::write_expr;
use crate::matrix::Matrix;
use crate::model::Node;
use crate::span::Span;
use std::collections::BTreeMap;

type Shape = (usize, usize);

/// The most scalar unknowns of a system.
const MOST_UNKNOWNS: usize = 256;
/// The most combinations of shapes that are tried.
const MOST_SHAPES: usize = 256;

impl Evaluator<'_, '_> {
    /// The values of a system's unknowns.
    pub(super) fn solve_system(&mut self, system: usize, span: Span) -> Result<Vec<Value>> {
        let mut failure = None;
        for shapes in self.shapes(system, span)? {
            match self.solve_shaped(system, &shapes, span) {
                Ok(values) => {
                    self.refuse_no_covariances(system, &values, span)?;
                    return Ok(values);
                }
                Err(none) => {
                    let misfit = matches!(none.reason, Reason::Shape { .. });
                    if !misfit {
                        return Err(none);
                    }
                    failure.get_or_insert(none);
                }
            }
        }
        Err(failure.unwrap_or_else(|| Reason::Unsupported("a system without unknowns").at(span)))
    }

    fn solve_shaped(&mut self, system: usize, shapes: &[Shape], span: Span) -> Result<Vec<Value>> {
        let world = self.world;
        let degree = (world.model).degree_in_unknowns(system, &|equation| world.display(equation));
        if degree.is_err() {
            let what = "an equation that is not linear in its unknowns";
            return Err(Reason::Unsupported(what).at(span));
        }
        let variable = self.arithmetic.open(0);
        let residual = self.residual(system, shapes, variable, span);
        self.arithmetic.close();
        let (constants, slopes): (Vec<Jet>, Vec<BTreeMap<usize, Jet>>) = residual?
            .iter()
            .flat_map(|value| value.entries().into_iter().cloned().collect::<Vec<_>>())
            .map(|entry| entry.parts(variable))
            .filter(|(constant, slopes)| !constant.is_zero() || !slopes.is_empty())
            .unzip();
        let unknowns: usize = shapes.iter().map(|(rows, columns)| rows * columns).sum();
        if constants.len() < unknowns {
            return Err(Reason::Undefined(Undefined::Singular).at(span));
        }
        let matrix = Matrix::from_fn(constants.len(), unknowns, |i, k| {
            slopes[i].get(&k).cloned().unwrap_or_else(Jet::zero)
        });
        let right = Matrix::from_fn(constants.len(), 1, |i, _| constants[i].negated());
        let solution = self
            .arithmetic
            .solve(&matrix, &right)
            .map_err(|r| r.at(span))?;
        let mut offset = 0;
        Ok(shapes
            .iter()
            .map(|(rows, columns)| {
                let first = offset;
                offset += rows * columns;
                Value::from_matrix(Matrix::from_fn(*rows, *columns, |i, j| {
                    solution[(first + i * columns + j, 0)].clone()
                }))
            })
            .collect())
    }

    /// Left minus right of every equation, with forms for the unknowns.
    fn residual(
        &mut self,
        system: usize,
        shapes: &[Shape],
        variable: usize,
        span: Span,
    ) -> Result<Vec<Value>> {
        let mut next = 0;
        let values = shapes.iter().map(|(rows, columns)| {
            Value::from_matrix(Matrix::from_fn(*rows, *columns, |_, _| {
                let slopes = BTreeMap::from([(next, Jet::integer(1))]);
                next += 1;
                Jet::form(variable, Jet::zero(), slopes)
            }))
        });
        let layer = LayerKind::Unknowns {
            system,
            values: values.collect(),
        };
        let world = self.world;
        let display = world.display(world.model.systems[system].equation);
        self.with_layer(layer, |e| {
            let mut residuals = Vec::new();
            for clause in &display.clauses {
                for pair in clause.chain.members.windows(2) {
                    let left = e.expression(&pair[0])?;
                    let right = e.expression(&pair[1])?;
                    let difference = e.arithmetic.sum(&left, &right.negated());
                    residuals.push(difference.map_err(|r| r.at(span))?);
                }
            }
            Ok(residuals)
        })
    }

    /// The shapes that the unknowns may have, the largest first.
    fn shapes(&mut self, system: usize, span: Span) -> Result<Vec<Vec<Shape>>> {
        let world = self.world;
        let unknowns = &world.model.systems[system].unknowns;
        let bold = |u: &crate::expr::Name| u.letter.font == Font::Bold;
        if !unknowns.iter().any(bold) {
            return Ok(vec![vec![(1, 1); unknowns.len()]]);
        }
        let mut sizes = vec![1];
        let display = world.display(world.model.systems[system].equation);
        let mut seen = BTreeMap::new();
        for member in display.clauses.iter().flat_map(|c| &c.chain.members) {
            self.sizes(system, member, &mut sizes, &mut seen);
        }
        sizes.sort_unstable();
        sizes.dedup();
        let matrices: Vec<Shape> = sizes
            .iter()
            .flat_map(|rows| sizes.iter().map(move |columns| (*rows, *columns)))
            .collect();
        let mut candidates: Vec<Vec<Shape>> = vec![Vec::new()];
        for unknown in unknowns {
            let options: &[Shape] = if bold(unknown) { &matrices } else { &[(1, 1)] };
            candidates = candidates
                .iter()
                .flat_map(|chosen| {
                    options.iter().map(move |shape| {
                        let mut longer = chosen.clone();
                        longer.push(*shape);
                        longer
                    })
                })
                .collect();
            if candidates.len() > MOST_SHAPES {
                return Err(Reason::Budget("shapes of unknowns").at(span));
            }
        }
        let scalars = |shapes: &[Shape]| shapes.iter().map(|(r, c)| r * c).sum::<usize>();
        candidates.sort_by_key(|shapes| std::cmp::Reverse(scalars(shapes)));
        if candidates
            .first()
            .is_some_and(|c| scalars(c) > MOST_UNKNOWNS)
        {
            return Err(Reason::Budget("unknowns").at(span));
        }
        Ok(candidates)
    }

    /// The sizes of what does not depend on the unknowns.
    fn sizes(
        &mut self,
        system: usize,
        expr: &Expr,
        sizes: &mut Vec<usize>,
        seen: &mut BTreeMap<String, ()>,
    ) {
        let own = normal(Node::Unknown {
            system,
            position: 0,
        });
        if self.world.behind_expression(expr).nodes.contains(&own) {
            for child in children(expr) {
                self.sizes(system, child, sizes, seen);
            }
            return;
        }
        if seen.insert(write_expr(expr), ()).is_some() {
            return;
        }
        if let Ok(value) = self.expression(expr)
            && let Some((rows, columns)) = value.shape()
        {
            sizes.extend([rows, columns]);
        }
    }

    /// What a document calls a covariance is positive semidefinite.
    fn refuse_no_covariances(&mut self, system: usize, values: &[Value], span: Span) -> Result<()> {
        let model = self.world.model;
        for (_, node, covariance) in model.covariances() {
            let Node::Unknown {
                system: of,
                position,
            } = node
            else {
                continue;
            };
            if of != system || covariance.left != covariance.right {
                continue;
            }
            let Some(value) = values.get(position) else {
                continue;
            };
            let Ok(matrix) = value.square("covariance") else {
                continue;
            };
            if definite(&self.arithmetic, &matrix, false) == super::apply::Truth::False {
                return Err(Reason::Undefined(Undefined::Covariance).at(span));
            }
        }
        Ok(())
    }
}
