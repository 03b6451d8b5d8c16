//! Quotients of long integers in lowest terms.

use crate::integer_gcd::integer_gcd;
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Signed, Zero};

/// The quotient of two rational numbers; `None` for a zero divisor.
///
/// The result is that of `dividend / divisor`; the greatest common divisor of long integers is Lehmer's,
/// and powers of two, of which binary fractions consist, cost nothing.
pub fn quotient(dividend: &BigRational, divisor: &BigRational) -> Option<BigRational> {
    if divisor.is_zero() {
        return None;
    }
    let top = dividend.numer() * divisor.denom();
    Some(reduced(top, dividend.denom() * divisor.numer()))
}

/// A quotient in lowest terms; the denominator is not zero. Powers of two go first: coordinates are often
/// binary fractions.
pub(crate) fn reduced(numerator: BigInt, denominator: BigInt) -> BigRational {
    if numerator.is_zero() {
        return BigRational::zero();
    }
    let (numerator, denominator) = match denominator.is_negative() {
        true => (-numerator, -denominator),
        false => (numerator, denominator),
    };
    let twos = |n: &BigInt| n.trailing_zeros().unwrap_or(0);
    let shift = twos(&numerator).min(twos(&denominator));
    let (numerator, denominator) = (numerator >> shift, denominator >> shift);
    let odd = &denominator >> twos(&denominator);
    if odd.is_one() {
        return BigRational::new_raw(numerator, denominator);
    }
    let divisor = integer_gcd(&numerator, &odd);
    if divisor.is_one() {
        BigRational::new_raw(numerator, denominator)
    } else {
        BigRational::new_raw(numerator / &divisor, denominator / divisor)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn integer() -> impl Strategy<Value = BigInt> {
        (any::<i128>(), 0_u32..3, 0_u32..200)
            .prop_map(|(n, e, shift)| (BigInt::from(n >> 64).pow(e)) << shift)
    }

    proptest! {
        #[test]
        fn as_by_the_greatest_common_divisor(a in integer(), b in integer(), c in integer()) {
            prop_assume!(!b.is_zero() && !c.is_zero());
            let (x, y) = (BigRational::new(&a * &c, b.clone()), BigRational::new(&b * &b, c.clone()));
            let found = quotient(&x, &y).expect("no zero");
            let expected = &x / &y;
            prop_assert_eq!(found.numer(), expected.numer());
            prop_assert_eq!(found.denom(), expected.denom());
        }
    }

    #[test]
    fn nothing_is_divided_by_zero() {
        assert_eq!(quotient(&BigRational::one(), &BigRational::zero()), None);
        let zero = quotient(
            &BigRational::zero(),
            &BigRational::new((-3).into(), 4.into()),
        );
        assert_eq!(zero, Some(BigRational::zero()));
    }
}
