//! The value that each subexpression of a side must have so that the sides agree.
//!
//! From the side down: in a sum it is what is missing beside the other terms, in a product the
//! quotient by the other factors, under a square both roots. Below a matrix product, a running sum
//! or a function nothing is needed in particular.

use super::residue::Residue;
use super::sites::Trial;
use super::store::Id;
use crate::check::edit::Address;
use crate::domain::{Domain, PrimeField};
use crate::evaluate::{Value, value};
use crate::expr::{Expr, ExprKind, Function, Sign};
use crate::matrix::Matrix;
use crate::model::links::{Place, children};
use crate::model::names::literal_integer;
use crate::span::Span;
use std::collections::HashMap;
use std::ops::Range;

/// A way down a side.
pub(super) struct Walk<'w, 'r, 'm> {
    pub trial: &'w mut Trial<'r, 'm>,
}

impl Walk<'_, '_, '_> {
    /// The scalar values that the subexpressions of a side must have, by address.
    pub fn needs(
        trial: &mut Trial<'_, '_>,
        expr: &Expr,
        place: Place,
        needed: Value<u64>,
    ) -> HashMap<Address, Vec<u64>> {
        let mut walk = Walk { trial };
        let mut found = Vec::new();
        let mut address = Address::of_side(place);
        walk.visit(
            expr,
            &mut address,
            &[needed],
            &mut |_, _, address, needed| {
                let scalars = needed.iter().filter_map(|v| match v {
                    Value::Scalar(s) => Some(*s),
                    _ => None,
                });
                found.push((address.clone(), scalars.collect()));
            },
        );
        found.into_iter().collect()
    }

    /// Calls `see` on each subexpression that has needed values, parents first, with its node, its
    /// address and these values.
    pub fn visit(
        &mut self,
        expr: &Expr,
        address: &mut Address,
        needed: &[Value<u64>],
        see: &mut impl FnMut(&Expr, Id, &Address, &[Value<u64>]),
    ) {
        let id = self.trial.store.node(expr);
        see(expr, id, address, needed);
        for (step, child) in children(expr).into_iter().enumerate() {
            let below = self.below(expr, step, needed);
            if !below.is_empty() {
                address.path.push(step);
                self.visit(child, address, &below, see);
                address.path.pop();
            }
        }
    }

    fn value(&mut self, expr: &Expr) -> Option<Value<u64>> {
        let id = self.trial.store.node(expr);
        match self.trial.store.value(id, self.trial.env) {
            Residue::Is(value) => Some(value),
            _ => None,
        }
    }

    /// Which rows and columns the entry at a step of a matrix's display fills.
    fn block(&mut self, rows: &[Vec<Expr>], step: usize) -> Option<Block> {
        let width = rows.first()?.len();
        let (mut heights, mut widths) = (vec![1; rows.len()], vec![1; width]);
        for (i, row) in rows.iter().enumerate() {
            for (j, entry) in row.iter().enumerate() {
                if let Some((height, width)) = self.value(entry).and_then(|v| v.shape()) {
                    heights[i] = heights[i].max(height);
                    widths[j] = widths[j].max(width);
                }
            }
        }
        let (i, j) = (step / width, step % width);
        let (top, left) = (heights[..i].iter().sum(), widths[..j].iter().sum());
        Some(Block {
            rows: top..top + heights.get(i)?,
            columns: left..left + widths.get(j)?,
        })
    }

    /// The values that a child must have, for the needed values of the whole.
    fn below(&mut self, expr: &Expr, step: usize, needed: &[Value<u64>]) -> Vec<Value<u64>> {
        let mut found = Vec::new();
        for whole in needed {
            self.needed(expr, step, whole, &mut found);
        }
        found
    }

    fn needed(
        &mut self,
        expr: &Expr,
        step: usize,
        whole: &Value<u64>,
        found: &mut Vec<Value<u64>>,
    ) {
        let field = PrimeField;
        let span = Span::default();
        match &expr.kind {
            ExprKind::Group { .. } | ExprKind::Underbrace { .. } => found.push(whole.clone()),
            ExprKind::Sum(terms) => {
                let mut rest = whole.clone();
                for (k, (sign, term)) in terms.iter().enumerate() {
                    if k == step {
                        continue;
                    }
                    let Some(value) = self.value(term) else {
                        return;
                    };
                    let next = match sign {
                        Sign::Plus => value::subtract(&field, &rest, &value, span),
                        Sign::Minus => value::add(&field, &rest, &value, span),
                    };
                    match next {
                        Ok(next) => rest = next,
                        Err(_) => return,
                    }
                }
                found.push(match terms[step].0 {
                    Sign::Plus => rest,
                    Sign::Minus => value::negate(&field, &rest),
                });
            }
            ExprKind::Product(factors) => {
                let mut others = 1;
                for (k, factor) in factors.iter().enumerate() {
                    if k == step {
                        continue;
                    }
                    match self.value(factor) {
                        Some(Value::Scalar(s)) => others = field.multiply(&others, &s),
                        _ => return,
                    }
                }
                if let Some(inverse) = field.divide(&1, &others) {
                    found.extend(value::multiply(
                        &field,
                        &Value::Scalar(inverse),
                        whole,
                        span,
                    ));
                }
            }
            ExprKind::Quotient {
                numerator,
                denominator,
                ..
            } => match (step, whole) {
                (0, _) => {
                    if let Some(below @ Value::Scalar(_)) = self.value(denominator) {
                        found.extend(value::multiply(&field, &below, whole, span));
                    }
                }
                (_, Value::Scalar(whole)) => {
                    if let Some(Value::Scalar(above)) = self.value(numerator) {
                        found.extend(field.divide(&above, whole).map(Value::Scalar));
                    }
                }
                _ => {}
            },
            ExprKind::Power { exponent, .. } if step == 0 => {
                let Value::Scalar(whole) = whole else {
                    return;
                };
                let power = literal_integer(exponent);
                let whole = match power {
                    Some(1..) => Some(*whole),
                    _ => field.divide(&1, whole),
                };
                let (Some(power), Some(whole)) = (power, whole) else {
                    return;
                };
                match power.abs() {
                    1 => found.push(Value::Scalar(whole)),
                    2 => {
                        if let Some(root) = field.square_root(whole) {
                            found.push(Value::Scalar(root));
                            found.push(Value::Scalar(field.negate(&root)));
                        }
                    }
                    _ => {}
                }
            }
            ExprKind::Call {
                function: Function::SquareRoot,
                ..
            } => {
                if let Value::Scalar(whole) = whole {
                    found.push(Value::Scalar(field.multiply(whole, whole)));
                }
            }
            ExprKind::Transpose(_) => found.push(match whole {
                Value::Matrix(m) => Value::Matrix(m.transpose()),
                other => other.clone(),
            }),
            ExprKind::Matrix { rows, .. } => {
                let (Some(Value::Matrix(printed)), Value::Matrix(whole)) =
                    (self.value(expr), whole)
                else {
                    return;
                };
                let block = self.block(rows, step);
                found.extend(block.and_then(|block| part(&printed, whole, &block)));
            }
            _ => {}
        }
    }
}

/// Rows and columns of a matrix that an entry of its display fills.
struct Block {
    rows: Range<usize>,
    columns: Range<usize>,
}

/// What an entry, which may be a block, must be where all others are as they must be.
fn part(printed: &Matrix<u64>, needed: &Matrix<u64>, block: &Block) -> Option<Value<u64>> {
    if printed.shape() != needed.shape() {
        return None;
    }
    let columns = needed.columns();
    let inside =
        |k: usize| block.rows.contains(&(k / columns)) && block.columns.contains(&(k % columns));
    let mut entries = printed.iter().zip(needed.iter()).enumerate();
    if !entries.all(|(k, (one, other))| inside(k) || one == other) {
        return None;
    }
    let (top, left) = (block.rows.start, block.columns.start);
    Some(match (block.rows.len(), block.columns.len()) {
        (1, 1) => Value::Scalar(needed[(top, left)]),
        (rows, columns) => Value::Matrix(Matrix::from_fn(rows, columns, |i, j| {
            needed[(top + i, left + j)]
        })),
    })
}
