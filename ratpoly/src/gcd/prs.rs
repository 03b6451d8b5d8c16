//! The primitive remainder sequence: slow and always right (W. S. Brown, *On Euclid's algorithm and the
//! computation of polynomial greatest common divisors*, 1971). It stands in where the modular method
//! cannot be used: more monomials than a word-sized group has elements.

use super::{Common, common, exact, primitive_part};
use crate::budget::Budget;
use crate::error::Error;
use crate::polynomial::Polynomial;

/// The gcd of two polynomials that are not zero and depend on the same variables, less its integer
/// and monomial content; `None` if that is 1.
pub(super) fn primitive_gcd(
    operands: [&Polynomial; 2],
    budget: &Budget,
) -> Result<Option<Common>, Error> {
    let [p, q] = operands;
    let degree = |v: usize| p.degree(v).max(q.degree(v));
    let Some(v) = p
        .variables_occurring()
        .into_iter()
        .min_by_key(|&v| degree(v))
    else {
        return Ok(None);
    };
    let (content_p, content_q) = (
        p.content_in_within(v, budget)?,
        q.content_in_within(v, budget)?,
    );
    let content = common(&content_p, &content_q, budget)?.gcd;
    let (mut f, mut g) = (exact(p, &content_p), exact(q, &content_q));
    if f.degree(v) < g.degree(v) {
        std::mem::swap(&mut f, &mut g);
    }
    while !g.is_zero() {
        budget.spend((f.len() + g.len()) as u64)?;
        let remainder = f.pseudo_remainder(&g, v)?;
        budget.check_terms(remainder.len())?;
        budget.check_bits(remainder.coefficient_bits())?;
        let primitive = if remainder.is_zero() {
            remainder
        } else {
            exact(&remainder, &remainder.content_in_within(v, budget)?)
        };
        (f, g) = (g, primitive);
    }
    let gcd = if f.degree(v) == Some(0) {
        content
    } else {
        f.try_mul(&content)?
    };
    let gcd = primitive_part(&gcd).unit_normal();
    Ok((gcd.len() > 1).then_some(Common {
        gcd,
        quotients: None,
    }))
}
