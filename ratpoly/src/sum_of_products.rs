//! Sums of products in one pass: what matrix products, minors and recursions consist of.
//!
//! A term times a polynomial is a run, already in order. A sum of products with short factors is a set of
//! runs, which are merged in pairs, the factors multiplied on the way, without a product stored in between.
//! Very few terms are formed and sorted instead; long times long is left to the multiplication.

use crate::accumulator::{Accumulator, ProductsOf};
use crate::error::Error;
use crate::layout::{KINDS, Layout};
use crate::packed::{Packed, PackedMonomial};
use crate::polynomial::Polynomial;
use crate::ring::Ring;
use crate::terms::{Term, TermList};

/// Up to this many products of terms are formed and sorted.
const SMALL: usize = 24;
/// Up to this many runs are merged.
const MOST_RUNS: usize = 64;
/// A single product of more runs is left to the multiplication, unless it is shorter than this.
const FEW_RUNS: usize = 8;
const SHORT: usize = 256;

/// A product and whether it is subtracted.
pub(crate) type SignedProduct<'a> = (bool, &'a Polynomial, &'a Polynomial);

impl Polynomial {
    /// The sum of the products of pairs, or [`Error::RingMismatch`] or [`Error::ExponentOverflow`].
    pub fn sum_of_products<'a>(
        ring: Ring,
        pairs: impl IntoIterator<Item = (&'a Polynomial, &'a Polynomial)>,
    ) -> Result<Polynomial, Error> {
        let products: Vec<SignedProduct<'a>> =
            pairs.into_iter().map(|(f, g)| (false, f, g)).collect();
        Polynomial::signed_sum_of_products(ring, &products)
    }

    /// The sum of products, some of them subtracted.
    pub(crate) fn signed_sum_of_products(
        ring: Ring,
        products: &[SignedProduct<'_>],
    ) -> Result<Polynomial, Error> {
        if products
            .iter()
            .any(|(_, f, g)| f.ring != ring || g.ring != ring)
        {
            return Err(Error::RingMismatch);
        }
        if let Some(sum) = fused(ring, products) {
            return Ok(sum);
        }
        let products = products
            .iter()
            .filter(|(_, f, g)| !f.is_zero() && !g.is_zero());
        let signed = products.map(|&(negate, f, g)| {
            let product = f.try_mul(g)?;
            Ok(if negate { -product } else { product })
        });
        Polynomial::sum(ring, signed)
    }
}

/// The sum of products of this ring, if a method here is the right one for it.
#[inline]
pub(crate) fn fused(ring: Ring, products: &[SignedProduct<'_>]) -> Option<Polynomial> {
    let narrowest = ring.narrowest();
    let kinds = products
        .iter()
        .flat_map(|(_, f, g)| [f.terms.kind(), g.terms.kind()]);
    let mut widest = narrowest;
    let mut narrow = true;
    for kind in kinds {
        narrow &= kind == narrowest;
        widest = widest.max(kind);
    }
    if narrow {
        match fuse_in_kind(ring, narrowest, products) {
            Fused::Sum(sum) => return Some(sum),
            Fused::Unsuitable => return None,
            Fused::LayoutTooNarrow => widest += 1,
        }
    }
    fused_wider(ring, widest, products)
}

/// The same with all operands in one layout, perhaps a wider one, so that the result fits.
#[cold]
fn fused_wider(ring: Ring, widest: usize, products: &[SignedProduct<'_>]) -> Option<Polynomial> {
    for kind in (widest..KINDS).filter(|&kind| ring.layout(kind).is_some()) {
        let convert = |f: &Polynomial| Polynomial::of(ring, f.terms.in_kind(ring, kind));
        let converted: Vec<(bool, Polynomial, Polynomial)> = products
            .iter()
            .map(|(negate, f, g)| (*negate, convert(f), convert(g)))
            .collect();
        let borrowed: Vec<SignedProduct<'_>> = converted
            .iter()
            .map(|(negate, f, g)| (*negate, f, g))
            .collect();
        match fuse_in_kind(ring, kind, &borrowed) {
            Fused::Sum(sum) => return Some(sum),
            Fused::Unsuitable => return None,
            Fused::LayoutTooNarrow => {}
        }
    }
    None
}

/// What came of an attempt.
enum Fused<T> {
    Sum(T),
    /// Long times long, or coefficients that need more than two words.
    Unsuitable,
    /// An exponent may not fit the layout.
    LayoutTooNarrow,
}

#[inline]
fn fuse_in_kind(ring: Ring, kind: usize, products: &[SignedProduct<'_>]) -> Fused<Polynomial> {
    match kind {
        0 => fuse::<Packed<1>>(ring, products),
        1 => fuse::<Packed<2>>(ring, products),
        2 => fuse::<Packed<4>>(ring, products),
        3 => fuse::<Packed<8>>(ring, products),
        _ => Fused::Unsuitable,
    }
}

/// A term times a list of word coefficients.
#[derive(Clone, Copy)]
struct Run<'a, M> {
    monomial: M,
    factor: i64,
    list: &'a [Term<M, i64>],
}

fn fuse<'a, M: PackedMonomial + Copy>(
    ring: Ring,
    products: &[SignedProduct<'a>],
) -> Fused<Polynomial> {
    let layout = M::layout(ring);
    if let &[(negate, f, g)] = products
        && let (Some(f), Some(g)) = (M::words(&f.terms), M::words(&g.terms))
        && let (&[ref term], list) | (list, &[ref term]) = (f, g)
    {
        return scale(ring, layout, Run::new(negate, term, list));
    }
    // First only what decides about the method: most sums are short and need no vector of runs.
    let (mut total, mut rows, mut bits, mut overflows) = (0, 0, 0, false);
    for (_, f, g) in products {
        let (Some(f), Some(g)) = (M::words(&f.terms), M::words(&g.terms)) else {
            return Fused::Unsuitable;
        };
        if rows + f.len().min(g.len()) > MOST_RUNS {
            return Fused::Unsuitable;
        }
        let (Some((a, m)), Some((b, n))) = (extent(f, layout), extent(g, layout)) else {
            continue;
        };
        total += f.len() * g.len();
        rows += f.len().min(g.len());
        bits = bits.max(a + b);
        overflows |= m.product(&n).overflows(layout);
    }
    if overflows {
        return Fused::LayoutTooNarrow;
    }
    if products.len() == 1 && rows > FEW_RUNS && total > SHORT {
        return Fused::Unsuitable;
    }
    // A coefficient of the sum adds at most one term of each run. (The negative of the least word is the
    // one factor that would be wrong; the bound keeps it out.)
    bits += usize::BITS - rows.leading_zeros();
    let runs = products.iter().flat_map(|&(negate, f, g)| {
        let f = M::words(&f.terms).unwrap_or_default();
        let g = M::words(&g.terms).unwrap_or_default();
        let (f, list) = if f.len() <= g.len() { (f, g) } else { (g, f) };
        f.iter().map(move |term| Run::new(negate, term, list))
    });
    let list = match bits {
        0..=62 if total <= SMALL => {
            let mut all: Vec<Term<M, i64>> = Vec::with_capacity(total);
            for run in runs {
                all.extend((0..run.list.len()).map(|k| run.term::<i64>(k)));
            }
            i64::collect(all)
        }
        0..=62 => accumulate::<M, i64>(&runs.collect::<Vec<_>>(), total),
        63..=126 => {
            let runs: Vec<Run<'a, M>> = runs.collect();
            if runs.iter().any(|run| run.factor == i64::MIN) {
                return Fused::Unsuitable;
            }
            accumulate::<M, i128>(&runs, total)
        }
        _ => return Fused::Unsuitable,
    };
    Fused::Sum(Polynomial::of(ring, list.into_terms(ring)))
}

/// A single run: no sum at all.
#[inline]
fn scale<M: PackedMonomial + Copy>(
    ring: Ring,
    layout: &Layout,
    run: Run<'_, M>,
) -> Fused<Polynomial> {
    if run.factor == i64::MIN {
        return Fused::Unsuitable;
    }
    let mut terms: Vec<Term<M, i64>> = Vec::with_capacity(run.list.len());
    for term in run.list {
        let monomial = run.monomial.product(&term.monomial);
        if monomial.overflows(layout) {
            return Fused::LayoutTooNarrow;
        }
        let Some(coefficient) = run.factor.checked_mul(term.coefficient) else {
            return Fused::Unsuitable;
        };
        terms.push(Term {
            monomial,
            coefficient,
        });
    }
    Fused::Sum(Polynomial::of(ring, TermList::Word(terms).into_terms(ring)))
}

/// The bits of the largest coefficient and, field by field, the greatest exponents; `None` for no terms.
#[inline]
fn extent<M: PackedMonomial + Copy>(terms: &[Term<M, i64>], layout: &Layout) -> Option<(u32, M)> {
    let (first, rest) = terms.split_first()?;
    let mut size = first.coefficient.unsigned_abs();
    let mut most = first.monomial;
    for term in rest {
        size |= term.coefficient.unsigned_abs();
        most = most.maximum(&term.monomial, layout);
    }
    Some((64 - size.leading_zeros(), most))
}

/// A sum of products of words.
trait Sum: ProductsOf<i64> + Copy {
    /// The list, in order and without zeros.
    fn into_list<M: PackedMonomial>(terms: Vec<Term<M, Self>>) -> TermList<M>;
}

impl Sum for i64 {
    fn into_list<M: PackedMonomial>(terms: Vec<Term<M, i64>>) -> TermList<M> {
        TermList::Word(terms)
    }
}

impl Sum for i128 {
    fn into_list<M: PackedMonomial>(terms: Vec<Term<M, i128>>) -> TermList<M> {
        let mut list = TermList::with_capacity(terms.len());
        for term in terms {
            term.coefficient.append(term.monomial, &mut list);
        }
        list
    }
}

impl<'a, M: PackedMonomial + Copy> Run<'a, M> {
    #[inline]
    fn new(negate: bool, term: &Term<M, i64>, list: &'a [Term<M, i64>]) -> Self {
        Run {
            monomial: term.monomial,
            factor: if negate {
                term.coefficient.wrapping_neg()
            } else {
                term.coefficient
            },
            list,
        }
    }

    #[inline(always)]
    fn term<A: Sum>(&self, index: usize) -> Term<M, A> {
        let term = &self.list[index];
        Term {
            monomial: self.monomial.product(&term.monomial),
            coefficient: A::product(&self.factor, &term.coefficient),
        }
    }
}

fn accumulate<M: PackedMonomial + Copy, A: Sum>(runs: &[Run<'_, M>], total: usize) -> TermList<M> {
    if let [run] = runs {
        return A::into_list((0..run.list.len()).map(|k| run.term(k)).collect());
    }
    if total <= SMALL {
        let mut all: Vec<Term<M, A>> = Vec::with_capacity(total);
        for run in runs {
            all.extend((0..run.list.len()).map(|k| run.term::<A>(k)));
        }
        return A::collect(all);
    }
    let mut level: Vec<Vec<Term<M, A>>> = runs
        .chunks(2)
        .map(|pair| {
            let lengths = (pair[0].list.len(), pair.get(1).map_or(0, |b| b.list.len()));
            merge(lengths, |i| pair[0].term(i), |j| pair[1].term(j))
        })
        .collect();
    while level.len() > 1 {
        // Both lists of a pair are given back when they are merged.
        let mut next = Vec::with_capacity(level.len().div_ceil(2));
        let mut lists = level.into_iter();
        while let Some(a) = lists.next() {
            next.push(match lists.next() {
                Some(b) => merge((a.len(), b.len()), |i| a[i].clone(), |j| b[j].clone()),
                None => a,
            });
        }
        level = next;
    }
    A::into_list(level.pop().unwrap_or_default())
}

/// The sum of two descending lists, given by their lengths and terms. Which list is ahead is as good as
/// random, so the comparison moves the places by arithmetic instead of a branch.
#[inline(always)]
fn merge<M: PackedMonomial + Copy, A: Sum>(
    (m, n): (usize, usize),
    a: impl Fn(usize) -> Term<M, A>,
    b: impl Fn(usize) -> Term<M, A>,
) -> Vec<Term<M, A>> {
    let mut sum: Vec<Term<M, A>> = Vec::with_capacity(m + n);
    let (mut i, mut j) = (0, 0);
    while i < m && j < n {
        let (x, y) = (a(i), b(j));
        let left = x.monomial >= y.monomial;
        let right = y.monomial >= x.monomial;
        let mut coefficient = if left { x.coefficient } else { A::ZERO };
        coefficient.add(&if right { y.coefficient } else { A::ZERO });
        i += usize::from(left);
        j += usize::from(right);
        if !coefficient.is_zero() {
            sum.push(Term {
                monomial: if left { x.monomial } else { y.monomial },
                coefficient,
            });
        }
    }
    sum.extend((i..m).map(a));
    sum.extend((j..n).map(b));
    sum
}
