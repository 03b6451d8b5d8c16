//! Coefficients in three widths: `i64`, 128 bits, and unbounded.
//!
//! A polynomial holds its coefficients in the narrowest width that fits them all. Kernels sum products in
//! an [`Accumulator`] that was chosen beforehand from a bound on the result, so that the machine-word
//! widths cannot overflow there.

use crate::packed::PackedMonomial;
use crate::terms::{Term, TermList};
use num_bigint::BigInt;
use num_integer::Integer as _;
use num_traits::{Signed, ToPrimitive};
use std::cmp::Ordering;
use std::fmt::Debug;
use std::hash::Hash;

/// An `i128` in two words, so that a term of one word and a coefficient takes 24 bytes, not 32.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub(crate) struct Double {
    low: u64,
    high: i64,
}

impl From<i128> for Double {
    #[inline]
    fn from(value: i128) -> Self {
        Double {
            low: value as u64,
            high: (value >> 64) as i64,
        }
    }
}

impl From<Double> for i128 {
    #[inline]
    fn from(value: Double) -> Self {
        i128::from(value.high) << 64 | i128::from(value.low)
    }
}

/// A stored coefficient.
pub(crate) trait Coefficient:
    Clone + PartialEq + Eq + Hash + Debug + Send + Sync + 'static
{
    /// The value in one type for all widths.
    fn value(&self) -> Value<'_>;
    /// The bits of the magnitude.
    fn bits(&self) -> u64;
}

impl Coefficient for i64 {
    #[inline]
    fn value(&self) -> Value<'_> {
        Value::Small(i128::from(*self))
    }
    #[inline]
    fn bits(&self) -> u64 {
        u64::from(64 - self.unsigned_abs().leading_zeros())
    }
}

impl Coefficient for Double {
    #[inline]
    fn value(&self) -> Value<'_> {
        Value::Small((*self).into())
    }
    #[inline]
    fn bits(&self) -> u64 {
        u64::from(128 - i128::from(*self).unsigned_abs().leading_zeros())
    }
}

impl Coefficient for BigInt {
    fn value(&self) -> Value<'_> {
        Value::Big(self)
    }
    fn bits(&self) -> u64 {
        BigInt::bits(self)
    }
}

/// A coefficient of any width, by value where it is small.
#[derive(Debug, Clone, Copy)]
pub(crate) enum Value<'a> {
    Small(i128),
    Big(&'a BigInt),
}

impl Value<'_> {
    pub fn to_big(self) -> BigInt {
        match self {
            Value::Small(c) => c.into(),
            Value::Big(c) => c.clone(),
        }
    }

    pub fn to_scalar(self) -> Scalar {
        match self {
            Value::Small(c) => Scalar::Small(c),
            Value::Big(c) => Scalar::from(c.clone()),
        }
    }

    pub fn compare(self, other: Value<'_>) -> Ordering {
        match (self, other) {
            (Value::Small(a), Value::Small(b)) => a.cmp(&b),
            (a, b) => a.to_big().cmp(&b.to_big()),
        }
    }

    pub fn is_negative(self) -> bool {
        match self {
            Value::Small(c) => c < 0,
            Value::Big(c) => c.is_negative(),
        }
    }

    /// The residue in `0..modulus`.
    pub fn residue(self, modulus: u64) -> u64 {
        match self {
            Value::Small(c) => match i64::try_from(c) {
                Ok(c) => {
                    let r = c.unsigned_abs() % modulus;
                    if c < 0 && r > 0 { modulus - r } else { r }
                }
                Err(_) => c.rem_euclid(i128::from(modulus)) as u64,
            },
            Value::Big(c) => c
                .mod_floor(&modulus.into())
                .to_u64()
                .expect("below the modulus"),
        }
    }
}

/// An integer that is worked on: in 128 bits while it fits, then unbounded.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) enum Scalar {
    Small(i128),
    /// Never a value that fits 128 bits.
    Big(BigInt),
}

impl From<BigInt> for Scalar {
    fn from(value: BigInt) -> Self {
        match value.to_i128() {
            Some(small) => Scalar::Small(small),
            None => Scalar::Big(value),
        }
    }
}

impl From<&BigInt> for Scalar {
    fn from(value: &BigInt) -> Self {
        match value.to_i128() {
            Some(small) => Scalar::Small(small),
            None => Scalar::Big(value.clone()),
        }
    }
}

impl From<Scalar> for BigInt {
    fn from(value: Scalar) -> Self {
        match value {
            Scalar::Small(c) => c.into(),
            Scalar::Big(c) => c,
        }
    }
}

impl Scalar {
    pub fn value(&self) -> Value<'_> {
        match self {
            Scalar::Small(c) => Value::Small(*c),
            Scalar::Big(c) => Value::Big(c),
        }
    }

    pub fn is_one(&self) -> bool {
        matches!(self, Scalar::Small(1))
    }

    pub fn is_zero(&self) -> bool {
        matches!(self, Scalar::Small(0))
    }

    pub fn negated(self) -> Scalar {
        match self {
            Scalar::Small(c) if c != i128::MIN => Scalar::Small(-c),
            other => (-BigInt::from(other)).into(),
        }
    }

    pub fn times(&self, other: Value<'_>) -> Scalar {
        if let (Scalar::Small(a), Value::Small(b)) = (self, other)
            && let Some(product) = a.checked_mul(b)
        {
            return Scalar::Small(product);
        }
        (self.value().to_big() * other.to_big()).into()
    }

    /// The nonnegative greatest common divisor.
    pub fn gcd(&self, other: Value<'_>) -> Scalar {
        match (self, other) {
            (Scalar::Small(a), Value::Small(b)) => {
                let (a, b) = (a.unsigned_abs(), b.unsigned_abs());
                let gcd = match (u64::try_from(a), u64::try_from(b)) {
                    (Ok(a), Ok(b)) => u128::from(a.gcd(&b)),
                    _ => a.gcd(&b),
                };
                // 2^127 is the one magnitude that does not fit.
                i128::try_from(gcd).map_or_else(|_| BigInt::from(gcd).into(), Scalar::Small)
            }
            (a, b) => a.value().to_big().gcd(&b.to_big()).into(),
        }
    }

    /// The quotient of a value by this scalar, if it divides (zero divides nothing here).
    pub fn divide(&self, value: Value<'_>) -> Option<Scalar> {
        match (value, self) {
            (_, Scalar::Small(0)) => None,
            (value, Scalar::Small(1)) => Some(value.to_scalar()),
            (Value::Small(a), Scalar::Small(b)) => match (i64::try_from(a), i64::try_from(*b)) {
                (Ok(a), Ok(b)) if b != -1 => (a % b == 0).then(|| Scalar::Small((a / b).into())),
                _ if *b == -1 => Some(Scalar::Small(a).negated()),
                _ => (a % b == 0).then(|| Scalar::Small(a / b)),
            },
            (a, b) => {
                let (quotient, remainder) = a.to_big().div_rem(&b.value().to_big());
                (remainder == BigInt::ZERO).then(|| quotient.into())
            }
        }
    }
}

/// A sum of products under way.
pub(crate) trait Accumulator: Clone + Send + Sync {
    const ZERO: Self;
    fn is_zero(&self) -> bool;
    fn add(&mut self, other: &Self);
    /// Appends a term with this nonzero coefficient.
    fn append<M: PackedMonomial>(self, monomial: M, list: &mut TermList<M>);

    /// Sorts terms, adds equal monomials and drops zeros: the normalising constructor in a layout.
    fn collect<M: PackedMonomial>(mut terms: Vec<Term<M, Self>>) -> TermList<M> {
        // The rows of a product are already in order; the stable sort makes use of it.
        terms.sort_by(|a, b| b.monomial.cmp(&a.monomial));
        let mut list = TermList::with_capacity(terms.len());
        let mut terms = terms.into_iter();
        let Some(mut current) = terms.next() else {
            return list;
        };
        for term in terms {
            if term.monomial == current.monomial {
                current.coefficient.add(&term.coefficient);
            } else {
                let done = std::mem::replace(&mut current, term);
                if !done.coefficient.is_zero() {
                    done.coefficient.append(done.monomial, &mut list);
                }
            }
        }
        if !current.coefficient.is_zero() {
            current.coefficient.append(current.monomial, &mut list);
        }
        list
    }
}

impl Accumulator for i64 {
    const ZERO: Self = 0;
    #[inline]
    fn is_zero(&self) -> bool {
        *self == 0
    }
    #[inline]
    fn add(&mut self, other: &Self) {
        *self += other;
    }
    #[inline]
    fn append<M: PackedMonomial>(self, monomial: M, list: &mut TermList<M>) {
        list.push_word(monomial, self);
    }

    fn collect<M: PackedMonomial>(mut terms: Vec<Term<M, Self>>) -> TermList<M> {
        if terms.len() <= INSERTION {
            combine_by_insertion(&mut terms);
        } else {
            terms.sort_by(|a, b| b.monomial.cmp(&a.monomial));
            combine_neighbours(&mut terms);
        }
        terms.retain(|t| t.coefficient != 0);
        TermList::Word(terms)
    }
}

/// Up to this many terms are sorted by insertion.
const INSERTION: usize = 24;

/// Sorts terms and adds equal monomials; zeros may remain.
fn combine_by_insertion<M: PackedMonomial>(terms: &mut Vec<Term<M, i64>>) {
    let mut done = 0;
    for next in 0..terms.len() {
        let (sorted, rest) = terms.split_at(next);
        let monomial = &rest[0].monomial;
        let mut place = done;
        while place > 0 && sorted[place - 1].monomial < *monomial {
            place -= 1;
        }
        if place > 0 && sorted[place - 1].monomial == *monomial {
            terms[place - 1].coefficient += terms[next].coefficient;
        } else {
            terms.swap(done, next);
            terms[place..=done].rotate_right(1);
            done += 1;
        }
    }
    terms.truncate(done);
}

/// Adds equal monomials among sorted terms; zeros may remain.
fn combine_neighbours<M: PackedMonomial>(terms: &mut Vec<Term<M, i64>>) {
    terms.dedup_by(|next, kept| {
        let equal = next.monomial == kept.monomial;
        if equal {
            kept.coefficient += next.coefficient;
        }
        equal
    });
}

impl Accumulator for i128 {
    const ZERO: Self = 0;
    #[inline]
    fn is_zero(&self) -> bool {
        *self == 0
    }
    #[inline]
    fn add(&mut self, other: &Self) {
        *self += other;
    }
    #[inline]
    fn append<M: PackedMonomial>(self, monomial: M, list: &mut TermList<M>) {
        list.push_small(monomial, self);
    }
}

impl Accumulator for BigInt {
    const ZERO: Self = BigInt::ZERO;
    fn is_zero(&self) -> bool {
        *self == BigInt::ZERO
    }
    fn add(&mut self, other: &Self) {
        *self += other;
    }
    fn append<M: PackedMonomial>(self, monomial: M, list: &mut TermList<M>) {
        list.push(monomial, self.into());
    }
}

/// An accumulator for products of coefficients of one width.
pub(crate) trait ProductsOf<C>: Accumulator {
    fn product(a: &C, b: &C) -> Self;
    #[inline]
    fn add_product(&mut self, a: &C, b: &C) {
        self.add(&Self::product(a, b));
    }
}

impl ProductsOf<i64> for i64 {
    #[inline]
    fn product(a: &i64, b: &i64) -> Self {
        a * b
    }
}

impl ProductsOf<i64> for i128 {
    #[inline]
    fn product(a: &i64, b: &i64) -> Self {
        i128::from(*a) * i128::from(*b)
    }
}

impl ProductsOf<Double> for i128 {
    #[inline]
    fn product(a: &Double, b: &Double) -> Self {
        i128::from(*a) * i128::from(*b)
    }
}

impl ProductsOf<BigInt> for BigInt {
    fn product(a: &BigInt, b: &BigInt) -> Self {
        a * b
    }
}
