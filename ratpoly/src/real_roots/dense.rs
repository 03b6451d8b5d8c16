//! Dense integer polynomials in one variable, constant term first, no trailing zero: what root isolation
//! works on.

use crate::budget::Budget;
use crate::error::Error;
use crate::integer_gcd::integer_gcd;
use crate::polynomial::{Polynomial, check_dense_degree};
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Signed, Zero};
use std::cmp::Ordering;

/// The coefficients in the only variable that may occur.
pub(crate) fn from_polynomial(f: &Polynomial, variable: usize) -> Result<Vec<BigInt>, Error> {
    if variable >= f.ring().len() {
        return Err(Error::VariableOutOfRange(variable));
    }
    check_dense_degree(f.degree(variable).unwrap_or(0).into(), &Budget::unlimited())?;
    let mut dense = vec![BigInt::zero(); f.degree(variable).map_or(0, |d| d as usize + 1)];
    for (m, c) in f.terms() {
        if m.iter().enumerate().any(|(i, &e)| i != variable && e > 0) {
            return Err(Error::Unsupported("more than one variable occurs"));
        }
        dense[m[variable] as usize] = c;
    }
    Ok(dense)
}

pub(crate) fn trim(f: &mut Vec<BigInt>) {
    while f.last().is_some_and(Zero::is_zero) {
        f.pop();
    }
}

/// Divides by the positive content.
pub(crate) fn make_primitive(f: &mut [BigInt]) {
    let mut content = BigInt::zero();
    for c in f.iter() {
        content = integer_gcd(&content, c);
        if content.is_one() {
            return;
        }
    }
    if !content.is_zero() {
        f.iter_mut().for_each(|c| *c = &*c / &content);
    }
}

pub(crate) fn derivative(f: &[BigInt]) -> Vec<BigInt> {
    let powers = f.iter().enumerate().skip(1);
    powers.map(|(k, c)| c * BigInt::from(k)).collect()
}

/// A positive multiple of the remainder of `f` by `g`, primitive.
pub(crate) fn positive_remainder(f: &[BigInt], g: &[BigInt]) -> Vec<BigInt> {
    let mut rest = f.to_vec();
    let lead = &g[g.len() - 1];
    while rest.len() >= g.len() {
        let top = rest.pop().expect("not empty");
        let common = integer_gcd(&top, lead);
        let (mut a, mut b) = (lead / &common, top / &common);
        if a.is_negative() {
            (a, b) = (-a, -b);
        }
        if !a.is_one() {
            rest.iter_mut().for_each(|c| *c *= &a);
        }
        let shift = rest.len() + 1 - g.len();
        for (c, d) in rest[shift..].iter_mut().zip(g) {
            *c -= &b * d;
        }
        trim(&mut rest);
    }
    make_primitive(&mut rest);
    rest
}

/// The primitive gcd, up to sign.
pub(crate) fn gcd(f: &[BigInt], g: &[BigInt]) -> Vec<BigInt> {
    let (mut f, mut g) = (f.to_vec(), g.to_vec());
    while !g.is_empty() {
        let rest = positive_remainder(&f, &g);
        f = std::mem::replace(&mut g, rest);
    }
    make_primitive(&mut f);
    f
}

/// The quotient by a polynomial that divides over the rationals, primitive up to sign.
pub(crate) fn quotient(f: &[BigInt], g: &[BigInt]) -> Vec<BigInt> {
    let lead = &g[g.len() - 1];
    let count = f.len() + 1 - g.len();
    // Fractions are avoided by a power of the leading coefficient.
    let scale = num_traits::pow(lead.clone(), count);
    let mut rest: Vec<BigInt> = f.iter().map(|c| c * &scale).collect();
    let mut result = vec![BigInt::zero(); count];
    for k in (0..count).rev() {
        let q = &rest[k + g.len() - 1] / lead;
        for (c, d) in rest[k..].iter_mut().zip(g) {
            *c -= &q * d;
        }
        result[k] = q;
    }
    make_primitive(&mut result);
    result
}

/// The primitive polynomial with the same roots, each simple.
pub(crate) fn square_free_part(f: &[BigInt]) -> Vec<BigInt> {
    let common = gcd(f, &derivative(f));
    if common.len() <= 1 {
        let mut same = f.to_vec();
        make_primitive(&mut same);
        return same;
    }
    quotient(f, &common)
}

/// The sign of the value at a rational number: of the integer `d^n f(p/d)`.
pub(crate) fn sign_at(f: &[BigInt], x: &BigRational) -> Ordering {
    let mut value = BigInt::zero();
    let mut scale = BigInt::one();
    for c in f.iter().rev() {
        value = value * x.numer() + c * &scale;
        scale *= x.denom();
    }
    value.cmp(&BigInt::zero())
}

/// `f(x + 1)` by repeated synthetic division.
pub(crate) fn shift_by_one(f: &mut [BigInt]) {
    for start in 0..f.len() {
        for k in (start..f.len() - 1).rev() {
            let (left, right) = f.split_at_mut(k + 1);
            left[k] += &right[0];
        }
    }
}

/// The number of sign changes in the sequence, zeros left out.
pub(crate) fn sign_changes(signs: impl IntoIterator<Item = Ordering>) -> usize {
    let mut last = Ordering::Equal;
    let mut changes = 0;
    for sign in signs.into_iter().filter(|s| s.is_ne()) {
        changes += usize::from(last == sign.reverse());
        last = sign;
    }
    changes
}
