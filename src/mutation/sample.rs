//! Seeded samples, always the same.

use rand_core::Rng;
use rand_pcg::Pcg64;

const STREAM: u128 = 0x0a02_bdbf_7bb3_c0a7_ac28_fa16_a64a_bf96;

/// `size` of the items, each equally likely, in their order (selection sampling: Knuth, *The Art of
/// Computer Programming* 2, algorithm S).
pub(super) fn sample<T>(items: Vec<T>, size: usize, seed: u64) -> Vec<T> {
    let mut source = Pcg64::new(u128::from(seed), STREAM);
    let mut left = items.len();
    let mut wanted = size.min(left);
    items
        .into_iter()
        .filter(|_| {
            let bound = left as u64;
            left -= 1;
            // The bias of a remainder of 64 bits is far below anything that is measured here.
            let taken = (source.next_u64() % bound) < wanted as u64;
            wanted -= usize::from(taken);
            taken
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_sample_has_its_size_and_order_and_depends_on_the_seed() {
        let items: Vec<u32> = (0..1000).collect();
        for size in [0, 1, 10, 999, 1000, 2000] {
            let drawn = sample(items.clone(), size, 7);
            assert_eq!(drawn.len(), size.min(1000));
            assert!(drawn.is_sorted());
            assert_eq!(drawn, sample(items.clone(), size, 7));
        }
        assert_ne!(sample(items.clone(), 10, 7), sample(items, 10, 8));
        assert_eq!(sample(Vec::<u32>::new(), 3, 7), Vec::<u32>::new());
    }
}
