//! Matrices that are put together from blocks.

use super::failure::Reason;
use super::jet::{Jet, Result};
use super::value::Value;
use crate::matrix::Matrix;

/// The most entries of a matrix of blocks.
const MOST_ENTRIES: usize = 100_000;

/// A matrix of blocks. A zero of any shape takes what its neighbours need, then what the other terms of
/// a sum need, and is square where they leave a side open.
pub(super) fn assembled(blocks: &[Vec<Value>], wanted: Option<usize>) -> Result<Value> {
    let columns = blocks.first().map_or(0, Vec::len);
    let bad = |value: &Value, expected: (usize, usize)| Reason::Shape {
        operation: "block",
        left: Some(expected),
        right: value.shape(),
    };
    if columns == 0 || blocks.iter().any(|row| row.len() != columns) {
        return Err(Reason::Unsupported("rows of different lengths"));
    }
    let known_height = |i: usize| blocks[i].iter().find_map(Value::shape).map(|s| s.0);
    let known_width = |j: usize| blocks.iter().find_map(|row| row[j].shape()).map(|s| s.1);
    let others: usize = (0..blocks.len()).filter_map(known_height).sum();
    let open = (0..blocks.len()).filter(|i| known_height(*i).is_none());
    let left_open = wanted
        .and_then(|wanted| wanted.checked_sub(others))
        .filter(|rest| *rest > 0 && open.count() == 1);
    let height = |i: usize| {
        let square = || (0..columns).find_map(known_width);
        known_height(i).or(left_open).or_else(square).unwrap_or(1)
    };
    let width = |j: usize| {
        let square = || (0..blocks.len()).find_map(known_height);
        known_width(j).or_else(square).unwrap_or(1)
    };
    let heights: Vec<usize> = (0..blocks.len()).map(height).collect();
    let widths: Vec<usize> = (0..columns).map(width).collect();
    let entries = heights.iter().sum::<usize>() * widths.iter().sum::<usize>();
    if entries > MOST_ENTRIES {
        return Err(Reason::Budget("entries of a matrix"));
    }
    let mut all = Vec::new();
    for (row, &height) in blocks.iter().zip(&heights) {
        for r in 0..height {
            let mut line = Vec::new();
            for (value, &width) in row.iter().zip(&widths) {
                for c in 0..width {
                    line.push(match value {
                        Value::Zero => Jet::zero(),
                        Value::Scalar(s) if (height, width) == (1, 1) => s.clone(),
                        Value::Scalar(s) if s.is_zero() => s.clone(),
                        Value::Matrix(m) if m.shape() == (height, width) => m[(r, c)].clone(),
                        Value::Scalar(_) | Value::Matrix(_) => {
                            return Err(bad(value, (height, width)));
                        }
                    });
                }
            }
            all.push(line);
        }
    }
    Matrix::from_rows(all)
        .map(Value::from_matrix)
        .ok_or(Reason::Unsupported("an empty matrix"))
}
