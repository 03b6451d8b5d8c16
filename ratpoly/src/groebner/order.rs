//! Block orders: a product of the plain orders, each on its own run of consecutive variables. An earlier
//! block outranks all later ones, so it can be eliminated (Cox, Little, O'Shea, Ideals, Varieties, and
//! Algorithms, section 3.1, exercise 6).

use crate::ring::Order;
use std::cmp::Ordering;

/// A product order on exponent vectors.
#[derive(Debug, Clone)]
pub(crate) struct BlockOrder {
    /// How many variables, under which order.
    blocks: Vec<(usize, Order)>,
}

impl BlockOrder {
    pub(crate) fn new(blocks: impl Into<Vec<(usize, Order)>>) -> Self {
        BlockOrder {
            blocks: blocks.into(),
        }
    }

    pub(crate) fn compare(&self, a: &[u32], b: &[u32]) -> Ordering {
        let mut start = 0;
        for &(len, order) in &self.blocks {
            let range = start..start + len;
            let ordering = compare(order, &a[range.clone()], &b[range]);
            if ordering.is_ne() {
                return ordering;
            }
            start += len;
        }
        Ordering::Equal
    }
}

fn compare(order: Order, a: &[u32], b: &[u32]) -> Ordering {
    let degree = |e: &[u32]| e.iter().map(|&x| u64::from(x)).sum::<u64>();
    match order {
        Order::Lex => a.cmp(b),
        Order::Grlex => degree(a).cmp(&degree(b)).then_with(|| a.cmp(b)),
        Order::Grevlex => degree(a)
            .cmp(&degree(b))
            .then_with(|| b.iter().rev().cmp(a.iter().rev())),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_earlier_block_outranks_a_later_one_of_any_degree() {
        let order = BlockOrder::new([(1, Order::Grevlex), (2, Order::Grlex)]);
        assert!(order.compare(&[1, 0, 0], &[0, 9, 9]).is_gt());
        assert!(order.compare(&[1, 0, 2], &[1, 1, 0]).is_gt());
        assert!(order.compare(&[1, 1, 1], &[1, 0, 2]).is_gt());
        assert!(order.compare(&[2, 1, 1], &[2, 1, 1]).is_eq());
    }
}
