//! The fast path for short polynomials with coefficients of one word: a sum of products in one pass.
//!
//! All products of terms are written into one vector, sorted and combined there; the vector becomes the
//! result. A bound shows beforehand that neither exponents nor coefficients can overflow; where it does
//! not, or where a product is long enough for a better method, the caller multiplies one by one.

use crate::coefficient::Accumulator;
use crate::layout::Layout;
use crate::multiply::SMALL;
use crate::packed::{Packed, PackedMonomial, Wide};
use crate::polynomial::Polynomial;
use crate::ring::Ring;
use crate::terms::{Term, TermList, Terms};

/// The sum of the products of pairs from one ring, if the fast path applies.
#[inline]
pub(crate) fn sum_of_products(
    ring: Ring,
    pairs: &[(&Polynomial, &Polynomial)],
) -> Option<Polynomial> {
    let terms = match &pairs.first()?.0.terms {
        Terms::One(_) => sum_in_layout::<Packed<1>>(ring, pairs)?.into_terms(ring),
        Terms::Two(_) => sum_in_layout::<Packed<2>>(ring, pairs)?.into_terms(ring),
        Terms::Four(_) => sum_in_layout::<Packed<4>>(ring, pairs)?.into_terms(ring),
        Terms::Wide(_) => sum_in_layout::<Wide>(ring, pairs)?.into_terms(ring),
    };
    Some(Polynomial { ring, terms })
}

fn sum_in_layout<M: PackedMonomial>(
    ring: Ring,
    pairs: &[(&Polynomial, &Polynomial)],
) -> Option<TermList<M>> {
    let layout = M::layout(ring);
    let mut products = 0;
    let mut bound: u64 = 0;
    for (f, g) in pairs {
        let (f, g) = (M::words(&f.terms)?, M::words(&g.terms)?);
        let (shorter, count) = (f.len().min(g.len()), f.len() * g.len());
        if count == 0 {
            continue;
        }
        if shorter > 1 && count > SMALL {
            return None;
        }
        products += count;
        bound = bound.checked_add(coefficient_bound(f, g, shorter, layout)?)?;
    }
    if bound > i64::MAX as u64 {
        return None;
    }
    let mut all: Vec<Term<M, i64>> = Vec::with_capacity(products);
    for (f, g) in pairs {
        let (f, g) = (M::words(&f.terms)?, M::words(&g.terms)?);
        let (shorter, longer) = if f.len() <= g.len() { (f, g) } else { (g, f) };
        for a in shorter {
            all.extend(longer.iter().map(|b| Term {
                monomial: a.monomial.product(&b.monomial),
                coefficient: a.coefficient * b.coefficient,
            }));
        }
    }
    if let [(f, g)] = pairs
        && (f.len() == 1 || g.len() == 1)
    {
        return Some(TermList::Word(all));
    }
    Some(i64::collect(all))
}

/// A bound on the coefficients of a product; `None` if they or the exponents may overflow.
#[inline]
fn coefficient_bound<M: PackedMonomial>(
    f: &[Term<M, i64>],
    g: &[Term<M, i64>],
    shorter: usize,
    layout: &Layout,
) -> Option<u64> {
    if layout.is_wide() {
        return None;
    }
    let ((m, a), (n, b)) = (join(f)?, join(g)?);
    if m.product(&n).overflows(layout) {
        return None;
    }
    // Both disjunctions are below the next power of two, and so are all coefficients.
    let bits = 128 - a.leading_zeros() - b.leading_zeros();
    if bits > 62 {
        None
    } else {
        (1u64 << bits).checked_mul(shorter as u64)
    }
}

/// The disjunctions of all monomials and of all magnitudes of coefficients.
#[inline]
fn join<M: PackedMonomial>(terms: &[Term<M, i64>]) -> Option<(M, u64)> {
    let (first, rest) = terms.split_first()?;
    let mut joined = (first.monomial.clone(), first.coefficient.unsigned_abs());
    for term in rest {
        joined.0 = joined.0.join(&term.monomial);
        joined.1 |= term.coefficient.unsigned_abs();
    }
    Some(joined)
}
