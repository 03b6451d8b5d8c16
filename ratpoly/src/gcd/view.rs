//! The operands as the modular algorithms see them: only the variables that both contain, monomial
//! contents removed, exponents divided by their common stride (x⁶ + x³ is y² + y with y = x³).

use super::shape::{Operand, gcd};
use crate::error::{Error, Resource};
use crate::modular::PrimeField;
use crate::polynomial::Polynomial;

/// The greatest sum of degrees for which dense univariate images are made.
const MAXIMAL_DEGREES: u64 = 1 << 26;

/// Two polynomials seen through variables that vary in both. Other variables are left to the caller.
pub(super) struct Views<'a> {
    /// The operands.
    pub(super) operands: &'a [Operand<'a>; 2],
    /// The variables seen, ascending; every list below is in their order.
    pub(super) variables: Vec<usize>,
    /// The stride of the exponents.
    pub(super) stride: Vec<u32>,
    /// The degrees of each operand as seen.
    pub(super) degrees: [Vec<u32>; 2],
    /// The exponents as seen, term after term.
    pub(super) exponents: [Vec<u32>; 2],
}

impl<'a> Views<'a> {
    /// The view of two polynomials through `variables`, which vary in both.
    pub(super) fn new(
        operands: &'a [Operand<'a>; 2],
        variables: Vec<usize>,
    ) -> Result<Views<'a>, Error> {
        let [p, q] = [&operands[0].shape, &operands[1].shape];
        let stride: Vec<u32> = variables
            .iter()
            .map(|&v| gcd(p.stride[v], q.stride[v]))
            .collect();
        let mut degrees = [Vec::new(), Vec::new()];
        let mut exponents = [Vec::new(), Vec::new()];
        for (which, operand) in operands.iter().enumerate() {
            let low = &operand.shape.low;
            let seen = |full: &[u32], into: &mut Vec<u32>| {
                for (&v, &stride) in variables.iter().zip(&stride) {
                    let above = full[v] - low[v];
                    into.push(if stride == 1 { above } else { above / stride });
                }
            };
            seen(&operand.shape.high, &mut degrees[which]);
            if degrees[which].iter().map(|&d| u64::from(d)).sum::<u64>() > MAXIMAL_DEGREES {
                return Err(Error::BudgetExceeded(Resource::Terms));
            }
            exponents[which].reserve(operand.polynomial.len() * variables.len());
            for full in operand.exponents.chunks_exact(low.len()) {
                seen(full, &mut exponents[which]);
            }
        }
        Ok(Views {
            operands,
            variables,
            stride,
            degrees,
            exponents,
        })
    }

    /// The operands themselves.
    pub(super) fn polynomials(&self) -> [&'a Polynomial; 2] {
        [self.operands[0].polynomial, self.operands[1].polynomial]
    }
}

/// The powers of one element for each of several variables, as far as each needs.
pub(super) struct PowerTable {
    powers: Vec<u64>,
    starts: Vec<usize>,
}

impl PowerTable {
    /// The powers of `bases[i]` up to `degrees[i]`.
    pub(super) fn new(
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
    pub(super) fn power(&self, i: usize, exponent: u32) -> u64 {
        self.powers[self.starts[i] + exponent as usize]
    }

    /// The product of the powers of all bases.
    #[inline]
    pub(super) fn monomial(&self, field: &PrimeField, exponents: &[u32]) -> u64 {
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
pub(super) fn random_elements(field: &PrimeField, seed: u64, count: usize) -> Vec<u64> {
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
