//! Fraction-free reduction of a list of terms by a list of others, with a record of what was subtracted.
//!
//! Terms are kept in strictly descending order of a [`BlockOrder`], coefficients are nonzero integers.

use super::order::BlockOrder;
use crate::budget::Budget;
use crate::error::Error;
use crate::integer_gcd::integer_gcd;
use crate::monomial::Monomial;
use num_bigint::BigInt;
use num_traits::{One, Signed, Zero};

pub(crate) type Terms = Vec<(Monomial, BigInt)>;

/// What was done with a dividend: its steps in order, and what is left, on a scale of its own.
pub(crate) struct Reduction {
    pub(crate) steps: Vec<Step>,
    pub(crate) remainder: Terms,
}

/// `rest := (multiplier * rest - coefficient * shift * divisor[index]) / content`.
pub(crate) struct Step {
    pub(crate) index: usize,
    pub(crate) shift: Monomial,
    coefficient: BigInt,
    multiplier: BigInt,
    content: BigInt,
}

/// `multiplier f = sum of coefficient * monomial * divisor[index] over the quotients + scale * remainder`.
pub(crate) struct Identity {
    pub(crate) multiplier: BigInt,
    pub(crate) quotients: Vec<(usize, Monomial, BigInt)>,
    pub(crate) scale: BigInt,
}

impl Reduction {
    /// The steps on one common scale, with the remainder that they leave.
    pub(crate) fn into_identity(self, budget: &Budget) -> Result<(Identity, Terms), Error> {
        // Before a step the dividend was so many times what was then left.
        let mut scale = BigInt::one();
        let mut quotients: Vec<(usize, Monomial, BigInt)> = Vec::with_capacity(self.steps.len());
        let mut multipliers: Vec<BigInt> = Vec::with_capacity(self.steps.len());
        for step in self.steps {
            quotients.push((step.index, step.shift, step.coefficient * &scale));
            multipliers.push(step.multiplier);
            if !step.content.is_one() {
                scale *= step.content;
            }
        }
        // Each step was multiplied by the multipliers of all later ones.
        let mut multiplier = BigInt::one();
        for (quotient, later) in quotients.iter_mut().zip(multipliers).rev() {
            if !multiplier.is_one() {
                budget.spend(Budget::products(1, quotient.2.bits(), multiplier.bits()))?;
                quotient.2 *= &multiplier;
            }
            multiplier *= later;
        }
        let identity = Identity {
            multiplier,
            quotients,
            scale,
        };
        Ok((identity, self.remainder))
    }
}

/// `a f + b x^shift g`.
pub(crate) fn combine(
    order: &BlockOrder,
    (a, f): (&BigInt, impl ExactSizeIterator<Item = (Monomial, BigInt)>),
    (b, shift, g): (&BigInt, &Monomial, &[(Monomial, BigInt)]),
) -> Result<Terms, Error> {
    let mut sum = Vec::with_capacity(f.len() + g.len());
    let mut left = f.peekable();
    let scale = |c: BigInt| if a.is_one() { c } else { a * c };
    for (m, d) in g {
        let m = m.checked_mul(shift).ok_or(Error::ExponentOverflow)?;
        while let Some((n, c)) = left.next_if(|t| order.compare(&t.0, &m).is_gt()) {
            sum.push((n, scale(c)));
        }
        let mut value = b * d;
        if let Some((_, c)) = left.next_if(|t| t.0 == m) {
            value += scale(c);
        }
        if !value.is_zero() {
            sum.push((m, value));
        }
    }
    sum.extend(left.map(|(n, c)| (n, scale(c))));
    Ok(sum)
}

/// Divides by the content and makes the leading coefficient positive; returns the signed content, zero
/// for no terms.
pub(crate) fn make_primitive(terms: &mut Terms) -> BigInt {
    let mut content = content(terms.iter().map(|t| &t.1), BigInt::zero());
    if terms.first().is_some_and(|t| t.1.is_negative()) {
        content = -content;
    }
    divide(terms.iter_mut().map(|t| &mut t.1), &content);
    content
}

/// The nonnegative greatest common divisor of the integers and another one.
fn content<'a>(integers: impl Iterator<Item = &'a BigInt>, mut content: BigInt) -> BigInt {
    for c in integers {
        if content.is_one() {
            break;
        }
        content = integer_gcd(&content, c);
    }
    content
}

fn divide<'a>(integers: impl Iterator<Item = &'a mut BigInt>, content: &BigInt) {
    if !content.is_one() && !content.is_zero() {
        integers.for_each(|c| *c = &*c / content);
    }
}

/// A term of a reduction costs about so many steps, however short its coefficient: monomials and
/// coefficients are made anew.
const TERM_STEPS: u64 = 32;

/// The gcd of two integers costs about as much as so many products of theirs.
pub(crate) const GCD_PRODUCTS: u64 = 4;

fn bits<'a>(terms: impl IntoIterator<Item = &'a (Monomial, BigInt)>) -> u64 {
    terms.into_iter().map(|t| t.1.bits()).max().unwrap_or(0)
}

/// Terms that no divisor reduces. Their coefficients lag behind: the multipliers of later steps are still to
/// be applied.
#[derive(Default)]
struct Settled {
    /// With the number of multipliers that do not concern the term.
    terms: Vec<(usize, Monomial, BigInt)>,
    multipliers: Vec<BigInt>,
}

impl Settled {
    fn push(&mut self, monomial: Monomial, coefficient: BigInt) {
        self.terms
            .push((self.multipliers.len(), monomial, coefficient));
    }

    fn catch_up(&mut self, budget: &Budget) -> Result<(), Error> {
        let mut product = BigInt::one();
        let mut place = self.multipliers.len();
        for (since, _, c) in self.terms.iter_mut().rev() {
            for multiplier in self.multipliers[*since..place].iter().rev() {
                product *= multiplier;
            }
            place = *since;
            *since = 0;
            if !product.is_one() {
                budget.spend(Budget::products(1, c.bits(), product.bits()))?;
                *c *= &product;
            }
        }
        self.multipliers.clear();
        Ok(())
    }
}

/// Reduces until no term is divisible by the leading monomial of a divisor. Among several the first divisor
/// is taken. Divisors are `(index, terms)`.
///
/// The multipliers of the steps pile up in the coefficients, mostly as a common factor, which is taken out
/// whenever the multipliers since the last time are as long as the coefficients were then.
pub(crate) fn reduce(
    order: &BlockOrder,
    terms: Terms,
    divisors: &[(usize, &[(Monomial, BigInt)])],
    budget: &Budget,
) -> Result<Reduction, Error> {
    let mut steps: Vec<Step> = Vec::new();
    let mut settled = Settled::default();
    let mut rest = terms.into_iter();
    let (mut piled, mut allowed) = (0, SPARE_BITS);
    while let Some((m, c)) = rest.as_slice().first() {
        let found = divisors
            .iter()
            .find_map(|&(i, g)| Some((i, g, m.checked_div(&g[0].0)?)));
        let Some((index, g, shift)) = found else {
            budget.spend(divisors.len() as u64)?;
            if let Some((m, c)) = rest.next() {
                settled.push(m, c);
            }
            continue;
        };
        let lead = &g[0].1;
        let common = integer_gcd(lead, c);
        let (multiplier, coefficient) = (lead / &common, c / &common);
        let (n, m) = (rest.len() as u64, g.len() as u64);
        let cost = [
            TERM_STEPS * (n + m) + divisors.len() as u64,
            Budget::products(GCD_PRODUCTS, lead.bits(), c.bits()),
            Budget::products(n, multiplier.bits(), bits(rest.as_slice())),
            Budget::products(m, coefficient.bits(), bits(g)),
        ];
        budget.spend(cost.into_iter().fold(0, u64::saturating_add))?;
        rest.next();
        let mut sum = combine(
            order,
            (&multiplier, rest),
            (&-&coefficient, &shift, &g[1..]),
        )?;
        budget.check_terms(sum.len())?;
        budget.check_bits(sum.first().map_or(0, |t| t.1.bits()))?;
        let mut removed = BigInt::one();
        piled += multiplier.bits();
        settled.multipliers.push(multiplier.clone());
        if piled > allowed && !sum.is_empty() {
            settled.catch_up(budget)?;
            // One true gcd; the other coefficients are mostly multiples of what it found.
            let (count, longest) = (sum.len() + settled.terms.len(), bits(&sum));
            let products = count as u64 + GCD_PRODUCTS;
            budget.spend(Budget::products(products, longest, longest))?;
            removed = content(sum.iter().map(|t| &t.1), BigInt::zero());
            removed = content(settled.terms.iter().map(|t| &t.2), removed);
            divide(sum.iter_mut().map(|t| &mut t.1), &removed);
            divide(settled.terms.iter_mut().map(|t| &mut t.2), &removed);
            (piled, allowed) = (0, bits(&sum) + SPARE_BITS);
        }
        rest = sum.into_iter();
        steps.push(Step {
            index,
            shift,
            coefficient,
            multiplier,
            content: removed,
        });
    }
    settled.catch_up(budget)?;
    let remainder = settled.terms.into_iter().map(|(_, m, c)| (m, c)).collect();
    Ok(Reduction { steps, remainder })
}

/// So many bits may pile up in any case: below that, taking them out costs more than they.
const SPARE_BITS: u64 = 256;
