//! Common divisors of many polynomials: what a gcd without certain variables divides.

use super::{Common, common, common_divisor, primitive_part};
use crate::budget::Budget;
use crate::error::Error;
use crate::polynomial::Polynomial;
use crate::ring::Ring;

/// The gcd of two polynomials, less its integer and monomial content, when it is known to contain none
/// of the variables marked `absent`: it is the gcd of all coefficients with respect to these.
pub(super) fn common_without(
    operands: [&Polynomial; 2],
    absent: &[bool],
    budget: &Budget,
) -> Result<Option<Common>, Error> {
    let mut coefficients = coefficients(operands[0], absent);
    coefficients.extend(self::coefficients(operands[1], absent));
    coefficients.sort_by_key(Polynomial::len);
    if coefficients[0].len() == 1 {
        return Ok(None);
    }
    let ring = operands[0].ring();
    let mut candidate = primitive_part(&coefficients[0]);
    let mut rest = coefficients.into_iter().skip(1);
    if let Some(second) = rest.next() {
        candidate = primitive_part(&common(&candidate, &second, budget)?.gcd);
    }
    let rest: Vec<Polynomial> = rest.collect();
    if !rest.is_empty() && candidate.len() > 1 {
        // One combination with odd weights mostly has what all of them have in common.
        let combination = combine(ring, &rest)?;
        let combined = primitive_part(&common(&candidate, &combination, budget)?.gcd);
        if combined.len() == 1 {
            return Ok(None);
        }
        if let Some(found) = common_divisor(operands, &combined, 0, budget)? {
            return Ok(Some(found));
        }
        for polynomial in &rest {
            candidate = primitive_part(&common(&candidate, polynomial, budget)?.gcd);
            if candidate.len() == 1 {
                return Ok(None);
            }
        }
    }
    if candidate.len() == 1 {
        return Ok(None);
    }
    Ok(Some(
        common_divisor(operands, &candidate, 0, budget)?.expect("it divides all coefficients"),
    ))
}

/// The gcd of a list, with its contents; 0 for none.
pub(super) fn gcd_of_list(
    ring: Ring,
    mut list: Vec<Polynomial>,
    budget: &Budget,
) -> Result<Polynomial, Error> {
    list.retain(|f| !f.is_zero());
    list.sort_by_key(Polynomial::len);
    let mut rest = list.iter();
    let Some(first) = rest.next() else {
        return Ok(Polynomial::zero(ring));
    };
    let Some(second) = rest.next() else {
        return Ok(first.unit_normal());
    };
    let mut gcd = common(first, second, budget)?.gcd;
    if rest.len() > 1 && gcd.len() > 1 {
        let combined = common(&gcd, &combine(ring, rest.as_slice())?, budget)?.gcd;
        if rest.as_slice().iter().all(|f| combined.divides(f)) {
            return Ok(combined);
        }
    }
    for f in rest {
        if gcd.is_one() {
            break;
        }
        gcd = common(&gcd, f, budget)?.gcd;
    }
    Ok(gcd)
}

/// The combination of a list with fixed weights that look random.
fn combine(ring: Ring, list: &[Polynomial]) -> Result<Polynomial, Error> {
    let mut weight = 1u64;
    let mut sum = Polynomial::zero(ring);
    for polynomial in list {
        weight = weight * 37 % 251;
        sum = sum.try_add(&polynomial.mul_integer(&weight.into()))?;
    }
    Ok(sum)
}

/// The coefficients of a polynomial with respect to the marked variables, which they do not contain.
fn coefficients(f: &Polynomial, marked: &[bool]) -> Vec<Polynomial> {
    let ring = f.ring();
    let mut terms: Vec<(Vec<u32>, Vec<u32>, _)> = f
        .terms()
        .map(|(monomial, c)| {
            let part = |which: bool| {
                monomial
                    .iter()
                    .zip(marked)
                    .map(|(&e, &m)| if m == which { e } else { 0 })
                    .collect::<Vec<u32>>()
            };
            (part(true), part(false), c)
        })
        .collect();
    terms.sort_by(|a, b| a.0.cmp(&b.0));
    terms
        .chunk_by(|a, b| a.0 == b.0)
        .map(|group| {
            let list = group.iter().map(|(_, rest, c)| (rest, c.clone()));
            Polynomial::from_terms(ring, list).expect("terms of the same ring")
        })
        .collect()
}
