//! What evaluation at points of a field needs: tables of powers, and points that look random.

use super::PrimeField;

/// The powers of one element for each of several variables, as far as each needs.
pub(crate) struct PowerTable {
    powers: Vec<u64>,
    starts: Vec<usize>,
}

impl PowerTable {
    /// The powers of `bases[i]` up to `degrees[i]`.
    pub(crate) fn new(
        field: &PrimeField,
        bases: &[u64],
        degrees: impl Iterator<Item = u32>,
    ) -> PowerTable {
        let mut table = PowerTable {
            powers: Vec::new(),
            starts: Vec::with_capacity(bases.len()),
        };
        for (&base, degree) in bases.iter().zip(degrees) {
            table.starts.push(table.powers.len());
            let mut power = field.one();
            table.powers.push(power);
            for _ in 0..degree {
                power = field.mul(power, base);
                table.powers.push(power);
            }
        }
        table
    }

    /// The power of the base number `i`.
    #[inline(always)]
    pub(crate) fn power(&self, i: usize, exponent: u32) -> u64 {
        self.powers[self.starts[i] + exponent as usize]
    }

    /// The product of the powers of all bases.
    #[inline]
    pub(crate) fn monomial(&self, field: &PrimeField, exponents: &[u32]) -> u64 {
        let mut product = field.one();
        for (i, &e) in exponents.iter().enumerate() {
            if e != 0 {
                product = field.mul(product, self.power(i, e));
            }
        }
        product
    }
}

/// Pseudo-random elements of the field that are not zero, from a seed (Steele, Lea and Flood's
/// splitmix64, 2014).
pub(crate) fn random_elements(field: &PrimeField, seed: u64, count: usize) -> Vec<u64> {
    let mut state = seed;
    let mut next = || {
        state = state.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = state;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        1 + (z ^ (z >> 31)) % (field.modulus() - 1)
    };
    (0..count).map(|_| next()).collect()
}
