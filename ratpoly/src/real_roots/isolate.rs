//! Isolation of the real roots of a square-free polynomial by Descartes' rule of signs and bisection
//! (Collins, Akritas 1976; Basu, Pollack, Roy, section 10.2).

use super::dense;
use super::sturm::root_bound;
use crate::budget::Budget;
use crate::error::Error;
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Signed, Zero};
use std::cmp::Ordering;

/// Open intervals with one root each and no root at their ends, or single points (`low = high`),
/// ascending and disjoint; `f` is square-free and not zero. An interval does not contain 0.
pub(crate) fn isolate(
    f: &[BigInt],
    budget: &Budget,
) -> Result<Vec<(BigRational, BigRational)>, Error> {
    let mut rest = f;
    let mut roots = Vec::new();
    while rest.first().is_some_and(Zero::is_zero) {
        rest = &rest[1..];
        roots.push((BigRational::zero(), BigRational::zero()));
    }
    if rest.len() <= 1 {
        return Ok(roots);
    }
    for (lo, hi) in positive(rest, budget)? {
        roots.push((lo, hi));
    }
    let mirrored: Vec<BigInt> = rest
        .iter()
        .enumerate()
        .map(|(k, c)| if k % 2 == 1 { -c } else { c.clone() })
        .collect();
    for (lo, hi) in positive(&mirrored, budget)? {
        roots.push((-hi, -lo));
    }
    roots.sort();
    Ok(roots)
}

/// The roots above 0 of a polynomial that does not vanish there.
fn positive(f: &[BigInt], budget: &Budget) -> Result<Vec<(BigRational, BigRational)>, Error> {
    let bound = root_bound(f);
    // f(bound x) has its positive roots in (0, 1).
    let mut scale = BigInt::one();
    let scaled = f.iter().map(|c| {
        let value = c * &scale;
        scale *= &bound;
        value
    });
    // Each entry: the polynomial on (0, 1), and the interval (k, k + 1) / 2^level that this stands for.
    let mut stack = vec![(scaled.collect::<Vec<_>>(), BigInt::zero(), 0_u64)];
    let mut roots = Vec::new();
    let point = |k: &BigInt, level: u64| BigRational::new(k * &bound, BigInt::one() << level);
    while let Some((g, k, level)) = stack.pop() {
        budget.spend((g.len() * g.len()) as u64)?;
        match variations(&g) {
            0 => {}
            1 => {
                let (low, high) = (point(&k, level), point(&(&k + 1), level));
                roots.push(clean_ends(f, low, high));
            }
            _ => {
                // On the left half 2^n g(x/2), on the right half the same at x + 1.
                let n = g.len() as u64 - 1;
                let left = g.iter().zip(0..).map(|(c, i)| c << (n - i));
                let mut left: Vec<BigInt> = left.collect();
                budget.check_bits(left.iter().map(BigInt::bits).max().unwrap_or(0))?;
                dense::make_primitive(&mut left);
                let mut right = left.clone();
                dense::shift_by_one(&mut right);
                let middle: BigInt = 2 * &k + 1;
                if right[0].is_zero() {
                    let x = point(&middle, level + 1);
                    roots.push((x.clone(), x));
                    right.remove(0);
                }
                stack.push((right, middle, level + 1));
                stack.push((left, 2 * k, level + 1));
            }
        }
    }
    Ok(roots)
}

/// The sign changes of `(x + 1)^n f(1 / (x + 1))`: the number of roots in (0, 1), or more by an even number.
fn variations(f: &[BigInt]) -> usize {
    let mut reversed: Vec<BigInt> = f.iter().rev().cloned().collect();
    dense::shift_by_one(&mut reversed);
    dense::sign_changes(reversed.iter().map(|c| c.cmp(&BigInt::zero())))
}

/// Shrinks an interval with one root inside until neither end is a root (of another interval) or zero.
fn clean_ends(f: &[BigInt], low: BigRational, high: BigRational) -> (BigRational, BigRational) {
    let (mut a, mut b) = (low, high);
    while a.is_zero() || dense::sign_at(f, &a).is_eq() || dense::sign_at(f, &b).is_eq() {
        let middle = (&a + &b) / BigInt::from(2);
        // The sign just right of `a`, also if `a` is a root itself.
        let sign = dense::sign_at(f, &middle);
        if sign.is_eq() {
            return (middle.clone(), middle);
        }
        if sign == sign_right_of(f, &a) {
            a = middle;
        } else {
            b = middle;
        }
    }
    (a, b)
}

/// The sign of a square-free polynomial immediately to the right of a point.
fn sign_right_of(f: &[BigInt], x: &BigRational) -> Ordering {
    match dense::sign_at(f, x) {
        Ordering::Equal => dense::sign_at(&dense::derivative(f), x),
        sign => sign,
    }
}

/// Halves an isolating interval until it is shorter than `width`, or hits the root.
pub(crate) fn refine(
    f: &[BigInt],
    (mut low, mut high): (BigRational, BigRational),
    width: &BigRational,
) -> (BigRational, BigRational) {
    debug_assert!(width.is_positive());
    if low == high {
        return (low, high);
    }
    let left = dense::sign_at(f, &low);
    while &high - &low >= *width {
        let middle = (&low + &high) / BigInt::from(2);
        let sign = dense::sign_at(f, &middle);
        if sign.is_eq() {
            return (middle.clone(), middle);
        }
        if sign == left {
            low = middle;
        } else {
            high = middle;
        }
    }
    (low, high)
}
