//! Polynomials from lists of terms: the narrowest layout that holds the exponents, sorted and added.

use super::Polynomial;
use crate::accumulator::Accumulator;
use crate::error::Error;
use crate::layout::{KINDS, Layout};
use crate::monomial::Monomial;
use crate::packed::{Packed, PackedMonomial, Wide};
use crate::ring::Ring;
use crate::scalar::Scalar;
use crate::terms::{Term, TermList, Terms, each_layout};
use num_bigint::BigInt;

impl Polynomial {
    pub(crate) fn from_scalar(ring: Ring, value: Scalar) -> Self {
        fn single<M: PackedMonomial>(ring: Ring, value: Scalar) -> Terms {
            let mut list = TermList::with_capacity(1);
            list.push(M::from_fields(M::layout(ring), |_| 0), value);
            M::wrap(list)
        }
        if value.is_zero() {
            return Polynomial::zero(ring);
        }
        let terms = match ring.narrowest() {
            0 => single::<Packed<1>>(ring, value),
            1 => single::<Packed<2>>(ring, value),
            2 => single::<Packed<4>>(ring, value),
            3 => single::<Packed<8>>(ring, value),
            _ => single::<Wide>(ring, value),
        };
        Polynomial::of(ring, terms)
    }

    /// A polynomial of one term, or zero.
    pub(crate) fn from_term(ring: Ring, exponents: &[u32], value: Scalar) -> Self {
        fn single<M: PackedMonomial>(m: Option<M>, value: &Scalar, ring: Ring) -> Option<Terms> {
            let mut list = TermList::new();
            list.push(m?, value.clone());
            Some(list.into_terms(ring))
        }
        if value.is_zero() {
            return Polynomial::zero(ring);
        }
        let mut layouts = (0..KINDS).filter_map(|kind| Some((kind, ring.layout(kind)?)));
        let terms = layouts.find_map(|(kind, layout)| match kind {
            0 => single(Packed::<1>::pack(layout, exponents), &value, ring),
            1 => single(Packed::<2>::pack(layout, exponents), &value, ring),
            2 => single(Packed::<4>::pack(layout, exponents), &value, ring),
            3 => single(Packed::<8>::pack(layout, exponents), &value, ring),
            _ => single(Wide::pack(layout, exponents), &value, ring),
        });
        Polynomial::of(ring, terms.expect("the last layout holds all exponents"))
    }

    /// The sum of the given terms, in any order, repeated monomials allowed.
    pub fn from_terms<E, I>(ring: Ring, terms: I) -> Result<Self, Error>
    where
        E: AsRef<[u32]>,
        I: IntoIterator<Item = (E, BigInt)>,
    {
        let mut exponents = Vec::new();
        let mut coefficients = Vec::new();
        for (row, coefficient) in terms {
            let row = row.as_ref();
            if row.len() != ring.len() {
                return Err(Error::WrongLength {
                    expected: ring.len(),
                    found: row.len(),
                });
            }
            exponents.extend_from_slice(row);
            coefficients.push(coefficient.into());
        }
        Ok(Polynomial::from_rows(ring, &exponents, coefficients))
    }

    /// The sum of terms given by exponent vectors, one after the other, and coefficients.
    pub(crate) fn from_rows(ring: Ring, exponents: &[u32], coefficients: Vec<Scalar>) -> Self {
        let variables = ring.len();
        let rows = |k: usize| &exponents[k * variables..(k + 1) * variables];
        for kind in 0..KINDS {
            let Some(layout) = ring.layout(kind) else {
                continue;
            };
            let terms = match kind {
                0 => collect_rows(ring, layout, rows, &coefficients).map(Terms::One),
                1 => collect_rows(ring, layout, rows, &coefficients).map(Terms::Two),
                2 => collect_rows(ring, layout, rows, &coefficients).map(Terms::Four),
                3 => collect_rows(ring, layout, rows, &coefficients).map(Terms::Eight),
                _ => collect_rows(ring, layout, rows, &coefficients).map(Terms::Wide),
            };
            if let Some(terms) = terms {
                // A term that cancelled may have asked for the wide layout.
                let terms = each_layout!(terms, list => list.into_terms(ring));
                return Polynomial::of(ring, terms);
            }
        }
        unreachable!("the last layout holds all exponents")
    }

    /// The sum of the given terms of this ring.
    pub(crate) fn from_list(ring: Ring, list: Vec<(Monomial, Scalar)>) -> Self {
        let mut exponents = Vec::with_capacity(list.len() * ring.len());
        let mut coefficients = Vec::with_capacity(list.len());
        for (monomial, coefficient) in list {
            exponents.extend_from_slice(&monomial);
            coefficients.push(coefficient);
        }
        Polynomial::from_rows(ring, &exponents, coefficients)
    }
}

/// Sorts and adds terms in a layout; `None` if it does not hold them.
fn collect_rows<'a, M: PackedMonomial>(
    ring: Ring,
    layout: &Layout,
    rows: impl Fn(usize) -> &'a [u32],
    coefficients: &[Scalar],
) -> Option<TermList<M>> {
    debug_assert_eq!(layout.variables, ring.len());
    let small = coefficients.iter().map(|c| match c {
        // A sum of fewer than 2^63 such terms fits 128 bits.
        Scalar::Small(c) => i64::try_from(*c).ok(),
        Scalar::Big(_) => None,
    });
    if let Some(small) = small.collect::<Option<Vec<i64>>>() {
        let terms = small.into_iter().enumerate().map(|(k, c)| {
            Some(Term {
                monomial: M::pack(layout, rows(k))?,
                coefficient: i128::from(c),
            })
        });
        return Some(i128::collect(terms.collect::<Option<_>>()?));
    }
    let terms = coefficients.iter().enumerate().map(|(k, c)| {
        Some(Term {
            monomial: M::pack(layout, rows(k))?,
            coefficient: c.value().to_big(),
        })
    });
    Some(BigInt::collect(terms.collect::<Option<_>>()?))
}
