//! Images of the scaled gcd along a geometric sequence of points, and its monomials and coefficients from
//! them; see [`super::sparse`] for why.

use super::sparse::{Plan, Support};
use super::view::Views;
use crate::budget::Budget;
use crate::error::Error;
use crate::modular::{
    BerlekampMassey, PowerTable, PrimeField, random_elements, solve_transposed_vandermonde,
    subgroup_logarithms,
};
use crate::polynomial::Polynomial;
use crate::univariate::modular as dense;

/// The images modulo one prime along one geometric sequence of points.
pub(super) struct Images<'a> {
    field: &'a PrimeField,
    plan: &'a Plan,
    operands: [Geometric; 2],
    gamma: Geometric,
    /// An element whose order is the least power of two, 2^k, not below the range.
    alpha: u64,
    k: u32,
    /// The inverses of the coordinates of β.
    inverse_beta: Vec<u64>,
    range: u64,
    /// The terms of both operands: what an image costs.
    cost: u64,
}

impl<'a> Images<'a> {
    /// `None` if the field has no element of the order wanted.
    pub(super) fn new(
        field: &'a PrimeField,
        views: &Views,
        plan: &'a Plan,
        seed: u64,
    ) -> Option<Images<'a>> {
        let n = views.variables.len();
        let range = plan.range()?;
        let k = 64 - (range - 1).leading_zeros();
        let alpha = root_of_unity(field, k)?;
        let beta = random_elements(field, seed.wrapping_mul(0x1_0001).wrapping_add(77), n);
        let mut strides = vec![0; n];
        let mut weight = 1u64;
        for (stride, &radix) in strides.iter_mut().zip(&plan.radix) {
            *stride = weight;
            weight *= radix;
        }
        let steps: Vec<u64> = (0..n)
            .map(|i| {
                if i == plan.main {
                    field.one()
                } else {
                    field.pow(alpha, strides[i])
                }
            })
            .collect();
        let gamma_degree = |i: usize| {
            plan.gamma_exponents
                .chunks_exact(n)
                .map(|e| e[i])
                .max()
                .unwrap_or(0)
        };
        let degree = |i: usize| {
            views.degrees[0][i]
                .max(views.degrees[1][i])
                .max(gamma_degree(i))
        };
        // The main variable stays: its powers only sort the terms.
        let mut starts = beta.clone();
        starts[plan.main] = field.one();
        let starts = PowerTable::new(field, &starts, (0..n).map(degree));
        let steps = PowerTable::new(field, &steps, (0..n).map(degree));
        let geometric = |f: &Polynomial, exponents: &[u32], degree: u32| {
            Geometric::new(field, f, exponents, plan.main, degree, &starts, &steps)
        };
        let operand = |w: usize| {
            geometric(
                views.operands[w].polynomial,
                &views.exponents[w],
                views.degrees[w][plan.main],
            )
        };
        let operands = [operand(0), operand(1)];
        let gamma = geometric(&plan.gamma, &plan.gamma_exponents, 0);
        let mut inverse_beta = beta;
        field.invert_all(&mut inverse_beta);
        let cost = views.polynomials().iter().map(|f| f.len() as u64).sum();
        Some(Images {
            field,
            plan,
            operands,
            gamma,
            alpha,
            k,
            inverse_beta,
            range,
            cost,
        })
    }

    /// The next image of Γ: its coefficients of the powers of the main variable. `None` at a point where
    /// an extreme coefficient vanishes.
    fn next(&mut self) -> Option<Vec<u64>> {
        let field = self.field;
        let [mut f, mut g] = [0, 1].map(|which| self.operands[which].next(field));
        let gamma = self.gamma.next(field)[0];
        let extreme = |image: &[u64]| {
            if self.plan.leading {
                image.last().copied()
            } else {
                image.first().copied()
            }
        };
        if gamma == 0 || (extreme(&f) == Some(0) && extreme(&g) == Some(0)) {
            return None;
        }
        dense::trim(&mut f);
        dense::trim(&mut g);
        let mut image = dense::gcd_up_to_unit(field, f, g);
        // γ comes in plain form and divided by R once more.
        let gamma = field.from_u64(field.from_u64(gamma));
        let scale = field.mul(gamma, field.inverse(extreme(&image)?)?);
        dense::scale(field, &mut image, scale);
        Some(image)
    }

    /// The monomials of Γ and its coefficients modulo the prime.
    pub(super) fn interpolate(
        &mut self,
        bounds: &[u32],
        budget: &Budget,
    ) -> Result<Option<(Support, Vec<u64>)>, Error> {
        let field = self.field;
        let Some(first) = self.next() else {
            return Ok(None);
        };
        let degree = first.len() - 1;
        if degree as u64 > u64::from(bounds[self.plan.main]) {
            return Ok(None);
        }
        let known = if self.plan.leading { degree } else { 0 };
        let mut sequences: Vec<BerlekampMassey> =
            first.iter().map(|_| BerlekampMassey::new(field)).collect();
        let mut image = first;
        let mut count = 0;
        let solved = loop {
            budget.spend(self.cost)?;
            for (k, (sequence, &value)) in sequences.iter_mut().zip(&image).enumerate() {
                if k != known {
                    sequence.push(field, value);
                }
            }
            count += 1;
            let finished = |(k, s): (usize, &BerlekampMassey)| k == known || s.confirmations() > 0;
            if count > 1 && sequences.iter().enumerate().all(finished) {
                break true;
            }
            if count == self.range {
                break false;
            }
            match self.next() {
                Some(next) if next.len() == degree + 1 => image = next,
                _ => return Ok(None),
            }
        };
        let mut exponents = Vec::with_capacity(degree + 1);
        let mut residues = Vec::new();
        for (k, sequence) in sequences.iter().enumerate() {
            if k == known {
                exponents.push(Vec::new());
                continue;
            }
            let mut packed = if solved {
                let Some(locator) = sequence.locator() else {
                    return Ok(None);
                };
                let Some(packed) = subgroup_logarithms(field, &locator, self.alpha, self.k) else {
                    return Ok(None);
                };
                packed
            } else {
                (0..self.range).collect()
            };
            if packed.last().is_some_and(|&e| e >= self.range) {
                return Ok(None);
            }
            let Some(mut values) = self.solve(&packed, sequence.sequence()) else {
                return Ok(None);
            };
            if !solved {
                let mut nonzero = values.iter().map(|&c| c != 0);
                packed.retain(|_| nonzero.next() == Some(true));
                values.retain(|&c| c != 0);
            }
            exponents.push(packed);
            residues.extend(values);
        }
        Ok(Some((
            Support {
                degree: degree as u32,
                exponents,
            },
            residues,
        )))
    }

    /// The coefficients of Γ modulo the prime, given its monomials; `None` if they do not fit.
    pub(super) fn interpolate_on(
        &mut self,
        support: &Support,
        budget: &Budget,
    ) -> Result<Option<Vec<u64>>, Error> {
        // One image more than is needed tests the monomials.
        let count = 1 + support.exponents.iter().map(Vec::len).max().unwrap_or(0);
        let mut sequences = vec![Vec::with_capacity(count); support.exponents.len()];
        for _ in 0..count {
            budget.spend(self.cost)?;
            match self.next() {
                Some(image) if image.len() == sequences.len() => {
                    for (sequence, value) in sequences.iter_mut().zip(image) {
                        sequence.push(value);
                    }
                }
                _ => return Ok(None),
            }
        }
        let known = if self.plan.leading {
            support.degree as usize
        } else {
            0
        };
        let mut residues = Vec::new();
        for (k, (packed, sequence)) in support.exponents.iter().zip(&sequences).enumerate() {
            if k != known {
                let Some(values) = self.solve(packed, sequence) else {
                    return Ok(None);
                };
                residues.extend(values);
            }
        }
        Ok(Some(residues))
    }

    /// The coefficients of one power of the main variable from its monomials and its images; `None` if
    /// a later image contradicts them.
    fn solve(&self, packed: &[u64], sequence: &[u64]) -> Option<Vec<u64>> {
        let field = self.field;
        let nodes: Vec<u64> = packed.iter().map(|&e| field.pow(self.alpha, e)).collect();
        let mut values = solve_transposed_vandermonde(field, &nodes, sequence)?;
        if let Some(&test) = sequence.get(nodes.len()) {
            let terms = values.iter().zip(&nodes);
            let power = nodes.len() as u64;
            let predicted = terms.fold(0, |sum, (&c, &node)| {
                field.add(sum, field.mul(c, field.pow(node, power)))
            });
            if predicted != test {
                return None;
            }
        }
        // So far they are the coefficients of Γ(β·x).
        for (value, &packed) in values.iter_mut().zip(packed) {
            let mut rest = packed;
            for (&inverse, &radix) in self.inverse_beta.iter().zip(&self.plan.radix) {
                *value = field.mul(*value, field.pow(inverse, rest % radix));
                rest /= radix;
            }
        }
        Some(values)
    }
}

/// An element of the order 2^k.
fn root_of_unity(field: &PrimeField, k: u32) -> Option<u64> {
    if k == 0 {
        return Some(field.one());
    }
    if (field.modulus() - 1).trailing_zeros() < k {
        return None;
    }
    (2..200)
        .map(|a| field.pow(field.from_u64(a), (field.modulus() - 1) >> k))
        .find(|&a| field.pow(a, 1 << (k - 1)) == field.neg(field.one()))
}

/// The values of the terms of a polynomial along a geometric sequence of points: each is multiplied by
/// its own ratio from one point to the next. Terms are grouped by their power of the main variable.
struct Geometric {
    values: Vec<u64>,
    ratios: Vec<u64>,
    /// Where the group of each power ends.
    ends: Vec<usize>,
    started: bool,
}

impl Geometric {
    fn new(
        field: &PrimeField,
        f: &Polynomial,
        exponents: &[u32],
        main: usize,
        degree: u32,
        starts: &PowerTable,
        steps: &PowerTable,
    ) -> Geometric {
        let n = exponents.len() / f.len();
        let mut ends = vec![0; degree as usize + 1];
        for term in exponents.chunks_exact(n) {
            ends[term[main] as usize] += 1;
        }
        let mut total = 0;
        for end in &mut ends {
            total += std::mem::replace(end, total);
        }
        let mut images = Geometric {
            values: vec![0; f.len()],
            ratios: vec![0; f.len()],
            ends,
            started: false,
        };
        for (term, residue) in exponents.chunks_exact(n).zip(f.residues(field.modulus())) {
            let place = &mut images.ends[term[main] as usize];
            images.values[*place] = field.mul(residue, starts.monomial(field, term));
            images.ratios[*place] = steps.monomial(field, term);
            *place += 1;
        }
        images
    }

    /// The coefficients of the image at the next point, all divided by R.
    fn next(&mut self, field: &PrimeField) -> Vec<u64> {
        let mut image = Vec::with_capacity(self.ends.len());
        let mut start = 0;
        for &end in &self.ends {
            let mut sum = 0u128;
            for (value, &ratio) in self.values[start..end]
                .iter_mut()
                .zip(&self.ratios[start..end])
            {
                if self.started {
                    *value = field.mul(*value, ratio);
                }
                sum += u128::from(*value);
            }
            image.push(field.reduce(sum));
            start = end;
        }
        self.started = true;
        image
    }
}
