//! Sparse distributed polynomials over the integers.
//!
//! Invariants: the terms are in strictly descending order in the ring's order, no coefficient is zero, and
//! the representation (see `terms.rs`) is the narrowest that holds them.

mod content;
mod from_terms;
mod one_variable;

pub(crate) use one_variable::check_dense_degree;

use crate::allowance::Held;
use crate::coefficient::{Coefficient, Value};
use crate::error::Error;
use crate::layout::Layout;
use crate::monomial::Monomial;
use crate::packed::PackedMonomial;
use crate::ring::Ring;
use crate::scalar::Scalar;
use crate::terms::{TermList, Terms, each_layout, each_width, same_layout};
use num_bigint::BigInt;
use std::cmp::Ordering;

/// A polynomial over the integers, canonical by construction: equality is structural.
#[derive(Clone, PartialEq, Eq, Hash)]
pub struct Polynomial {
    pub(crate) ring: Ring,
    pub(crate) terms: Terms,
    /// What it takes of the memory that its thread may use.
    held: Held,
}

impl Polynomial {
    /// A polynomial with these terms.
    #[inline]
    pub(crate) fn of(ring: Ring, terms: Terms) -> Self {
        let held = Held::new(terms.bytes());
        Polynomial { ring, terms, held }
    }

    /// The zero polynomial.
    pub fn zero(ring: Ring) -> Self {
        Polynomial::of(ring, Terms::zero(ring))
    }

    /// The polynomial 1.
    pub fn one(ring: Ring) -> Self {
        Polynomial::from_scalar(ring, Scalar::Small(1))
    }

    /// A constant polynomial.
    pub fn constant(ring: Ring, value: impl Into<BigInt>) -> Self {
        Polynomial::from_scalar(ring, value.into().into())
    }

    /// The variable at a position of the ring.
    ///
    /// # Panics
    /// If the ring has no such variable.
    pub fn variable(ring: Ring, index: usize) -> Self {
        assert!(
            index < ring.len(),
            "the ring has no variable number {index}"
        );
        let mut exponents = vec![0; ring.len()];
        exponents[index] = 1;
        Polynomial::from_term(ring, &exponents, Scalar::Small(1))
    }

    /// The variable of this name.
    pub fn named(ring: Ring, name: &str) -> Result<Self, Error> {
        Ok(Polynomial::variable(ring, ring.index_of(name)?))
    }

    /// The ring.
    pub fn ring(&self) -> Ring {
        self.ring
    }

    /// The terms in descending order.
    pub fn terms(&self) -> impl DoubleEndedIterator<Item = (Monomial, BigInt)> + ExactSizeIterator {
        (0..self.len()).map(|k| self.term(k).expect("below the number of terms"))
    }

    fn term(&self, index: usize) -> Option<(Monomial, BigInt)> {
        each_layout!(&self.terms, list => list.get(index).map(|(m, c)| {
            (unpacked(m, self.ring), c.to_big())
        }))
    }

    /// The terms in descending order, coefficients of a word as such.
    pub(crate) fn scalar_terms(&self) -> impl Iterator<Item = (Monomial, Scalar)> {
        (0..self.len()).map(|k| {
            each_layout!(&self.terms, list => {
                let (m, c) = list.get(k).expect("below the number of terms");
                (unpacked(m, self.ring), c.to_scalar())
            })
        })
    }

    /// The exponent vectors of all terms, one after the other, in descending order.
    pub fn exponents_flat(&self) -> Vec<u32> {
        let mut flat = vec![0; self.len() * self.ring.len()];
        if !self.ring.is_empty() {
            let mut rows = flat.chunks_exact_mut(self.ring.len());
            each_layout!(&self.terms, list => {
                let layout = layout_of(list, self.ring);
                list.for_each(|m, _| m.unpack(layout, rows.next().expect("a row for each term")));
            });
        }
        flat
    }

    /// The residues of all coefficients in `0..modulus`, in the order of the terms.
    ///
    /// # Panics
    /// If the modulus is zero.
    pub fn residues(&self, modulus: u64) -> Vec<u64> {
        let mut residues = Vec::with_capacity(self.len());
        each_layout!(&self.terms, list => list.for_each(|_, c| residues.push(c.residue(modulus))));
        residues
    }

    /// Calls a function on the exponents and the coefficient of every term in descending order.
    pub(crate) fn for_each_term(&self, mut f: impl FnMut(&[u32], Value<'_>)) {
        let mut exponents = vec![0; self.ring.len()];
        each_layout!(&self.terms, list => {
            let layout = layout_of(list, self.ring);
            list.for_each(|m, c| {
                m.unpack(layout, &mut exponents);
                f(&exponents, c);
            });
        });
    }

    /// The number of terms.
    #[inline]
    pub fn len(&self) -> usize {
        self.terms.len()
    }

    /// Whether there is no term, the same as [`is_zero`](Self::is_zero).
    pub fn is_empty(&self) -> bool {
        self.is_zero()
    }

    /// Whether this is 0.
    #[inline]
    pub fn is_zero(&self) -> bool {
        self.terms.is_empty()
    }

    /// Whether this is 1.
    pub fn is_one(&self) -> bool {
        self.as_scalar().is_some_and(|c| c.is_one())
    }

    /// Whether no variable occurs.
    pub fn is_constant(&self) -> bool {
        self.as_scalar().is_some()
    }

    /// The value of a constant polynomial.
    pub fn as_constant(&self) -> Option<BigInt> {
        self.as_scalar().map(BigInt::from)
    }

    pub(crate) fn as_scalar(&self) -> Option<Scalar> {
        match self.len() {
            0 => Some(Scalar::Small(0)),
            1 => each_layout!(&self.terms, list => {
                list.get(0).filter(|t| t.0.is_one()).map(|t| t.1.to_scalar())
            }),
            _ => None,
        }
    }

    /// The greatest term.
    pub fn leading_term(&self) -> Option<(Monomial, BigInt)> {
        self.term(0)
    }

    /// The monomial of the greatest term.
    pub fn leading_monomial(&self) -> Option<Monomial> {
        each_layout!(&self.terms, list => list.get(0).map(|t| unpacked(t.0, self.ring)))
    }

    /// The coefficient of the greatest term, zero for the zero polynomial.
    pub fn leading_coefficient(&self) -> BigInt {
        each_layout!(&self.terms, list => list.get(0).map_or(BigInt::ZERO, |t| t.1.to_big()))
    }

    pub(crate) fn leading_scalar(&self) -> Option<(Monomial, Scalar)> {
        each_layout!(&self.terms, list => {
            list.get(0).map(|(m, c)| (unpacked(m, self.ring), c.to_scalar()))
        })
    }

    /// Whether the leading coefficient is negative.
    #[inline]
    pub(crate) fn leads_negative(&self) -> bool {
        each_layout!(&self.terms, list => list.get(0).is_some_and(|t| t.1.is_negative()))
    }

    /// The coefficient of a monomial, zero if it does not occur.
    pub fn coefficient(&self, exponents: &[u32]) -> BigInt {
        if exponents.len() != self.ring.len() {
            return BigInt::ZERO;
        }
        each_layout!(&self.terms, list => coefficient_of(list, self.ring, exponents))
    }

    /// The largest number of bits of a coefficient.
    pub fn coefficient_bits(&self) -> u64 {
        each_layout!(&self.terms, list => list.bits())
    }

    /// A polynomial of this ring with other terms.
    #[inline]
    pub(crate) fn with<M: PackedMonomial>(&self, list: TermList<M>) -> Polynomial {
        Polynomial::of(self.ring, list.into_terms(self.ring))
    }

    /// Applies a map that sends nonzero coefficients to nonzero coefficients; `None` if it fails.
    pub(crate) fn map_coefficients(
        &self,
        f: impl Fn(Value<'_>) -> Option<Scalar>,
    ) -> Option<Polynomial> {
        each_layout!(&self.terms, list => {
            Some(self.with(list.map_coefficients(&f)?))
        })
    }

    /// Whether the invariants hold. They always do; tests ask.
    pub fn is_canonical(&self) -> bool {
        self.terms.is_canonical(self.ring)
    }
}

/// The layout of a list in a ring.
#[inline]
pub(crate) fn layout_of<M: PackedMonomial>(_: &TermList<M>, ring: Ring) -> &'static Layout {
    M::layout(ring)
}

/// Packs exponents that fit as those of another monomial do.
fn packed_like<M: PackedMonomial>(_: &M, layout: &Layout, exponents: &[u32]) -> M {
    M::pack(layout, exponents).expect("exponents no greater than those of a monomial that fits")
}

fn unpacked<M: PackedMonomial>(monomial: &M, ring: Ring) -> Monomial {
    let mut exponents = vec![0; ring.len()];
    monomial.unpack(M::layout(ring), &mut exponents);
    Monomial::new(exponents)
}

fn coefficient_of<M: PackedMonomial>(list: &TermList<M>, ring: Ring, exponents: &[u32]) -> BigInt {
    let Some(wanted) = M::pack(M::layout(ring), exponents) else {
        return BigInt::ZERO;
    };
    each_width!(list, terms => {
        match terms.binary_search_by(|t| wanted.cmp(&t.monomial)) {
            Ok(k) => terms[k].coefficient.value().to_big(),
            Err(_) => BigInt::ZERO,
        }
    })
}

impl PartialOrd for Polynomial {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Polynomial {
    /// A total order for sorting: by ring, then term by term (monomial, then coefficient) from the
    /// leading term down; a polynomial is greater than its own leading part.
    fn cmp(&self, other: &Self) -> Ordering {
        self.ring.cmp(&other.ring).then_with(|| {
            same_layout!(self.ring, &self.terms, &other.terms, a, b => {
                for k in 0..a.len().min(b.len()) {
                    let ((m, c), (n, d)) = (a.get(k).expect("a term"), b.get(k).expect("a term"));
                    let order = m.cmp(n).then_with(|| c.compare(d));
                    if order.is_ne() {
                        return order;
                    }
                }
            });
            self.len().cmp(&other.len())
        })
    }
}
