//! Addition and subtraction: merging two descending lists.

use crate::coefficient::{Accumulator, Double};
use crate::packed::PackedMonomial;
use crate::terms::{Term, TermList};
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
