//! Addition and subtraction: merging two descending lists.

use crate::accumulator::{Accumulator, Additive};
use crate::coefficient::Double;
use crate::packed::{Packed, PackedMonomial};
use crate::polynomial::Polynomial;
use crate::terms::{Term, TermList, Terms, each_layout};
use num_bigint::BigInt;
use std::cmp::Ordering;

/// A coefficient that can be added and subtracted, unless the result does not fit.
trait Addend: Clone {
    type Sum: Accumulator;
    fn sum(a: &Self, b: &Self, subtract: bool) -> Option<Self::Sum>;
    /// The coefficient or its negative.
    fn alone(a: &Self, negate: bool) -> Option<Self::Sum>;
}

impl Addend for i64 {
    type Sum = i64;
    #[inline]
    fn sum(a: &i64, b: &i64, subtract: bool) -> Option<i64> {
        if subtract {
            a.checked_sub(*b)
        } else {
            a.checked_add(*b)
        }
    }
    #[inline]
    fn alone(a: &i64, negate: bool) -> Option<i64> {
        if negate { a.checked_neg() } else { Some(*a) }
    }
}

impl Addend for Double {
    type Sum = i128;
    fn sum(a: &Double, b: &Double, subtract: bool) -> Option<i128> {
        let (a, b) = (i128::from(*a), i128::from(*b));
        if subtract {
            a.checked_sub(b)
        } else {
            a.checked_add(b)
        }
    }
    fn alone(a: &Double, negate: bool) -> Option<i128> {
        if negate {
            i128::from(*a).checked_neg()
        } else {
            Some((*a).into())
        }
    }
}

impl Addend for BigInt {
    type Sum = BigInt;
    fn sum(a: &BigInt, b: &BigInt, subtract: bool) -> Option<BigInt> {
        Some(if subtract { a - b } else { a + b })
    }
    fn alone(a: &BigInt, negate: bool) -> Option<BigInt> {
        Some(if negate { -a } else { a.clone() })
    }
}

impl Polynomial {
    /// Adds or subtracts another polynomial within the vector of this one; `false`, with nothing changed,
    /// if that is not possible.
    #[inline]
    pub(crate) fn merge_in_place<const SUBTRACT: bool>(&mut self, other: &Polynomial) -> bool {
        // In a layout that is not the narrowest a sum may have to change its layout.
        if self.ring != other.ring || self.terms.kind() != self.ring.narrowest() {
            return false;
        }
        self.allow_sum(other);
        fn merge<M: PackedMonomial, const SUBTRACT: bool>(a: &mut Terms, b: &Terms) -> bool {
            match (M::words_mut(a), M::words(b)) {
                (Some(a), Some(b)) => merge_words::<M, SUBTRACT>(a, b),
                _ => false,
            }
        }
        match self.terms {
            Terms::One(_) => merge::<Packed<1>, SUBTRACT>(&mut self.terms, &other.terms),
            Terms::Two(_) => merge::<Packed<2>, SUBTRACT>(&mut self.terms, &other.terms),
            Terms::Four(_) => merge::<Packed<4>, SUBTRACT>(&mut self.terms, &other.terms),
            Terms::Eight(_) => merge::<Packed<8>, SUBTRACT>(&mut self.terms, &other.terms),
            Terms::Wide(_) => false,
        }
    }

    /// Changes every sign, in place where the coefficients are words.
    pub(crate) fn negate(&mut self) {
        let words = each_layout!(&mut self.terms, list => match list {
            TermList::Word(terms) if terms.iter().all(|t| t.coefficient != i64::MIN) => {
                terms.iter_mut().for_each(|t| t.coefficient = -t.coefficient);
                true
            }
            _ => false,
        });
        if !words {
            *self = -&*self;
        }
    }
}

/// Merges the second list into the first from the back, so that every term moves once; `false`, with
/// nothing changed, if a coefficient might overflow.
fn merge_words<M: PackedMonomial, const SUBTRACT: bool>(
    a: &mut Vec<Term<M, i64>>,
    b: &[Term<M, i64>],
) -> bool {
    const SAFE: u64 = 1 << 62;
    let fits = |terms: &[Term<M, i64>]| terms.iter().all(|t| t.coefficient.unsigned_abs() < SAFE);
    if !fits(a) || !fits(b) {
        return false;
    }
    let Some(filler) = b.first() else { return true };
    let (mut i, mut j) = (a.len(), b.len());
    a.resize(i + j, filler.clone());
    let mut free = a.len();
    // Invariant: what is left of both lists fits below `free`.
    while j > 0 {
        let y = &b[j - 1];
        let coefficient = if SUBTRACT {
            -y.coefficient
        } else {
            y.coefficient
        };
        if i > 0 && a[i - 1].monomial < y.monomial {
            free -= 1;
            i -= 1;
            a.swap(i, free);
        } else if i > 0 && a[i - 1].monomial == y.monomial {
            (i, j) = (i - 1, j - 1);
            let sum = a[i].coefficient + coefficient;
            if sum != 0 {
                free -= 1;
                a[i].coefficient = sum;
                a.swap(i, free);
            }
        } else {
            free -= 1;
            j -= 1;
            a[free] = Term {
                monomial: y.monomial.clone(),
                coefficient,
            };
        }
    }
    a.drain(i..free);
    true
}

impl<M: PackedMonomial> TermList<M> {
    /// The sum, or the difference if `SUBTRACT`.
    pub fn merge<const SUBTRACT: bool>(&self, other: &Self) -> Self {
        if let (TermList::Word(a), TermList::Word(b)) = (self, other)
            && let Some(list) = merge::<M, i64, SUBTRACT>(a, b)
        {
            return list;
        }
        if let (Some(a), Some(b)) = (self.to_double(), other.to_double())
            && let Some(list) = merge::<M, Double, SUBTRACT>(&a, &b)
        {
            return list;
        }
        merge::<M, BigInt, SUBTRACT>(&self.to_big(), &other.to_big())
            .expect("unbounded integers do not overflow")
    }

    /// The negative.
    pub fn negated(&self) -> Self {
        TermList::new().merge::<true>(self)
    }
}

/// Merges two lists; `None` if a coefficient does not fit.
#[inline]
fn merge<M: PackedMonomial, C: Addend, const SUBTRACT: bool>(
    a: &[Term<M, C>],
    b: &[Term<M, C>],
) -> Option<TermList<M>> {
    let mut list = TermList::with_capacity(a.len() + b.len());
    let (mut i, mut j) = (0, 0);
    while let (Some(x), Some(y)) = (a.get(i), b.get(j)) {
        match x.monomial.cmp(&y.monomial) {
            Ordering::Greater => {
                C::alone(&x.coefficient, false)?.append(x.monomial.clone(), &mut list);
                i += 1;
            }
            Ordering::Less => {
                C::alone(&y.coefficient, SUBTRACT)?.append(y.monomial.clone(), &mut list);
                j += 1;
            }
            Ordering::Equal => {
                let sum = C::sum(&x.coefficient, &y.coefficient, SUBTRACT)?;
                if !sum.is_zero() {
                    sum.append(x.monomial.clone(), &mut list);
                }
                (i, j) = (i + 1, j + 1);
            }
        }
    }
    for x in &a[i..] {
        C::alone(&x.coefficient, false)?.append(x.monomial.clone(), &mut list);
    }
    for y in &b[j..] {
        C::alone(&y.coefficient, SUBTRACT)?.append(y.monomial.clone(), &mut list);
    }
    Some(list)
}
