//! The operands as the modular algorithms see them: only the variables that both contain, monomial
//! contents removed, exponents divided by their common stride (x⁶ + x³ is y² + y with y = x³).

use super::shape::{Operand, gcd};
use crate::error::{Error, Resource};
use crate::polynomial::Polynomial;

/// The greatest sum of degrees for which dense univariate images are made.
pub(super) const MAXIMAL_DEGREES: u64 = 1 << 26;

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
