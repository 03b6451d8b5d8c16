//! The value that each subexpression of a side must have so that the sides agree.
//!
//! From the side down: in a sum it is what is missing beside the other terms, in a product the
//! quotient by the other factors, under a square both roots. Below a matrix product, a running sum
//! or a function nothing is needed in particular.

use super::residue::Residue;
use super::sites::Trial;
use super::store::Id;
use super::work;
use crate::check::edit::Address;
use crate::domain::{Domain, PrimeField};
use crate::evaluate::{Value, value};
use crate::expr::walk::children;
use crate::expr::{Expr, ExprKind, Function, Sign};
use crate::matrix::Matrix;
use crate::model::links::Place;
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
                    Value::Matrix(_) | Value::Zero => None,
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
        let children = children(expr);
        let mut below = self.below(expr, children.len(), needed);
        for (step, child) in children.into_iter().enumerate() {
            let below = std::mem::take(&mut below[step]);
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
            Residue::Absent | Residue::Unknown => None,
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

    /// The values that each child must have, for the needed values of the whole.
    fn below(
        &mut self,
        expr: &Expr,
        children: usize,
        needed: &[Value<u64>],
    ) -> Vec<Vec<Value<u64>>> {
        match &expr.kind {
            ExprKind::Sum(terms) => self.below_sum(terms, needed),
            ExprKind::Product(factors) => self.below_product(factors, needed),
            _ => {
                let mut found = vec![Vec::new(); children];
                for (step, found) in found.iter_mut().enumerate() {
                    for whole in needed {
                        self.needed(expr, step, whole, found);
                    }
                }
                found
            }
        }
    }

    /// In a sum: what is missing beside the other terms. Where a term has no value, only it can be needed.
    fn below_sum(&mut self, terms: &[(Sign, Expr)], needed: &[Value<u64>]) -> Vec<Vec<Value<u64>>> {
        let (field, span) = (PrimeField, Span::default());
        let mut found = vec![Vec::new(); terms.len()];
        let steps = work::operation(needed.first(), 3 * terms.len());
        self.trial.store.charge(steps);
        let values: Vec<_> = terms.iter().map(|(_, term)| self.value(term)).collect();
        let mut missing = (0..terms.len()).filter(|k| values[*k].is_none());
        let (lone, more) = (missing.next(), missing.next().is_some());
        if more {
            return found;
        }
        for whole in needed {
            // What is missing beside all terms that have values.
            let mut rest = Some(whole.clone());
            for ((sign, _), value) in terms.iter().zip(&values) {
                rest = match (rest, value) {
                    (Some(rest), Some(value)) => match sign {
                        Sign::Plus => value::subtract(&field, &rest, value, span).ok(),
                        Sign::Minus => value::add(&field, &rest, value, span).ok(),
                    },
                    (rest, _) => rest,
                };
            }
            let Some(rest) = rest else {
                continue;
            };
            for (k, (sign, _)) in terms.iter().enumerate() {
                let rest = match sign {
                    Sign::Plus => rest.clone(),
                    Sign::Minus => value::negate(&field, &rest),
                };
                match &values[k] {
                    None => found[k].push(rest),
                    Some(value) if lone.is_none() => {
                        found[k].extend(value::add(&field, value, &rest, span));
                    }
                    Some(_) => {}
                }
            }
        }
        found
    }

    /// In a product: the quotient by the other factors, which are numbers.
    fn below_product(&mut self, factors: &[Expr], needed: &[Value<u64>]) -> Vec<Vec<Value<u64>>> {
        let (field, span) = (PrimeField, Span::default());
        let steps = work::operation(needed.first(), 5 * factors.len());
        self.trial.store.charge(steps);
        let scalars: Vec<Option<u64>> = factors
            .iter()
            .map(|factor| match self.value(factor) {
                Some(Value::Scalar(s)) => Some(s),
                _ => None,
            })
            .collect();
        // The products of all factors before each, and of all behind it.
        let step = |product: &mut Option<u64>, factor: &Option<u64>| {
            let before = *product;
            *product = before.zip(*factor).map(|(p, f)| field.multiply(&p, &f));
            Some(before)
        };
        let before: Vec<Option<u64>> = scalars.iter().scan(Some(1), step).collect();
        let behind: Vec<Option<u64>> = scalars.iter().rev().scan(Some(1), step).collect();
        let mut found = vec![Vec::new(); factors.len()];
        for (k, found) in found.iter_mut().enumerate() {
            let others = before[k].zip(behind[factors.len() - 1 - k]);
            let others = others.map(|(one, other)| field.multiply(&one, &other));
            let Some(inverse) = others.and_then(|others| field.divide(&1, &others)) else {
                continue;
            };
            for whole in needed {
                let value = value::multiply(&field, &Value::Scalar(inverse), whole, span);
                found.extend(value);
            }
        }
        found
    }

    /// What a child of anything else must be.
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
                Value::Scalar(_) | Value::Zero => whole.clone(),
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
