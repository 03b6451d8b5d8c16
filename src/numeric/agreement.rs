//! How many digits of a floating-point result are right, measured against the exact value.
//!
//! Every finite double is a rational number, so its relative error against an exact rational is
//! itself an exact rational; only its logarithm is rounded. The exact value is never rounded to
//! a double first: that would hide up to one unit in the last place.

use num_bigint::BigUint;
use num_rational::BigRational;
use num_traits::{ToPrimitive, Zero};

/// The digits of a double, `53 log10 2` rounded down to two places: more are never claimed.
pub const MOST_DIGITS: f64 = 15.95;

/// What the comparison of a double with an exact value says.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Agreement {
    /// `-log10` of the relative error, between 0 and [`MOST_DIGITS`].
    Digits(f64),
    /// The exact value is zero and so is the computed one.
    BothZero,
    /// The exact value is zero and the computed one is not: no relative error exists.
    NotZero(f64),
    /// The computed value is infinite or not a number.
    NotFinite,
}

impl Agreement {
    /// Compares `computed` with `exact`.
    pub fn of(computed: f64, exact: &BigRational) -> Self {
        let Some(value) = BigRational::from_float(computed) else {
            return Agreement::NotFinite;
        };
        if exact.is_zero() {
            return if value.is_zero() {
                Agreement::BothZero
            } else {
                Agreement::NotZero(computed)
            };
        }
        Agreement::Digits(digits(&value, exact, exact))
    }

    /// Compares `computed` with `exact` by the error relative to `scale`, which is not zero: an entry
    /// of a covariance matrix whose exact value is zero is measured by its neighbours' size.
    pub fn at_scale(computed: f64, exact: &BigRational, scale: &BigRational) -> Self {
        let Some(value) = BigRational::from_float(computed) else {
            return Agreement::NotFinite;
        };
        if scale.is_zero() {
            return Agreement::of(computed, exact);
        }
        Agreement::Digits(digits(&value, exact, scale))
    }

    /// The number of correct digits: all for two zeros, none where no digit can be right.
    pub fn digits(self) -> f64 {
        match self {
            Agreement::Digits(digits) => digits,
            Agreement::BothZero => MOST_DIGITS,
            Agreement::NotZero(_) | Agreement::NotFinite => 0.0,
        }
    }
}

/// `-log10 |(value - exact) / scale|`, at least 0 and at most [`MOST_DIGITS`].
fn digits(value: &BigRational, exact: &BigRational, scale: &BigRational) -> f64 {
    // The quotient's logarithm needs no lowest terms.
    let error = value.numer() * exact.denom() - exact.numer() * value.denom();
    if error.is_zero() {
        return MOST_DIGITS;
    }
    let top = error * scale.denom();
    let bottom = value.denom() * exact.denom() * scale.numer();
    // Zero digits have no sign.
    (-log10(top.magnitude(), bottom.magnitude())).clamp(0.0, MOST_DIGITS) + 0.0
}

/// `log10` of a quotient of positive integers of any size, to about 15 digits.
fn log10(top: &BigUint, bottom: &BigUint) -> f64 {
    let leading = |n: &BigUint| {
        let shift = n.bits().saturating_sub(64);
        ((n >> shift).to_f64().unwrap_or(1.0), shift as i64)
    };
    let ((above, up), (below, down)) = (leading(top), leading(bottom));
    libm::log10(above / below) + (up - down) as f64 * std::f64::consts::LOG10_2
}

/// The double nearest to a rational (ties to even); none on overflow.
pub fn nearest(x: &BigRational) -> Option<f64> {
    x.to_f64().filter(|value| value.is_finite())
}

/// The digits of many comparisons: how many, the worst, the best and the median.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Digits {
    values: Vec<(f64, usize)>,
}

impl Digits {
    /// Collects the digits of comparisons in the order of their index.
    pub fn collect(agreements: impl IntoIterator<Item = Agreement>) -> Self {
        let mut values: Vec<(f64, usize)> = agreements
            .into_iter()
            .enumerate()
            .map(|(index, agreement)| (agreement.digits(), index))
            .collect();
        values.sort_by(|x, y| x.0.total_cmp(&y.0).then(x.1.cmp(&y.1)));
        Digits { values }
    }

    /// How many.
    pub fn count(&self) -> usize {
        self.values.len()
    }

    /// The fewest digits and the index of the first comparison that has them.
    pub fn worst(&self) -> Option<(f64, usize)> {
        self.values.first().copied()
    }

    /// The most digits and an index of a comparison that has them.
    pub fn best(&self) -> Option<(f64, usize)> {
        self.values.last().copied()
    }

    /// The lower median.
    pub fn median(&self) -> Option<f64> {
        let middle = self.values.len().checked_sub(1)? / 2;
        self.values.get(middle).map(|(digits, _)| *digits)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_abs_diff_eq;
    use num_traits::Signed;
    use proptest::prelude::*;

    fn ratio(numerator: i64, denominator: i64) -> BigRational {
        BigRational::new(numerator.into(), denominator.into())
    }

    #[test]
    fn a_wrong_third_digit() {
        let agreement = Agreement::of(1.001, &ratio(1, 1));
        assert_abs_diff_eq!(agreement.digits(), 3.0, epsilon = 1e-9);
    }

    #[test]
    fn the_nearest_double_to_a_third_is_not_a_third() {
        // 1/3 rounded has the relative error 2^-54: log10 gives 16.26, reported as all digits.
        assert_eq!(Agreement::of(1.0 / 3.0, &ratio(1, 3)).digits(), MOST_DIGITS);
        // Two units above it the error is 5/3 units of 2^-54, and would be 2 had 1/3 been rounded.
        let above = f64::from_bits((1.0f64 / 3.0).to_bits() + 2);
        let seen = Agreement::of(above, &ratio(1, 3)).digits();
        assert_abs_diff_eq!(seen, -(5.0 * 2.0f64.powi(-54)).log10(), epsilon = 1e-9);
    }

    #[test]
    fn zeros_infinities_and_nonsense() {
        let zero = ratio(0, 1);
        assert_eq!(Agreement::of(0.0, &zero), Agreement::BothZero);
        assert_eq!(Agreement::of(-0.0, &zero), Agreement::BothZero);
        assert_eq!(Agreement::of(1e-300, &zero), Agreement::NotZero(1e-300));
        assert_eq!(Agreement::of(1e-300, &zero).digits(), 0.0);
        let scaled = Agreement::at_scale(1e-12, &zero, &ratio(1, 1));
        assert_abs_diff_eq!(scaled.digits(), 12.0, epsilon = 1e-12);
        assert_eq!(Agreement::of(f64::NAN, &zero), Agreement::NotFinite);
        assert_eq!(
            Agreement::of(f64::INFINITY, &ratio(1, 1)),
            Agreement::NotFinite
        );
        assert_eq!(Agreement::of(-5.0, &ratio(5, 1)), Agreement::Digits(0.0));
        assert_eq!(Agreement::of(0.0, &ratio(5, 1)), Agreement::Digits(0.0));
    }

    #[test]
    fn exact_values_far_outside_the_doubles() {
        let integer = BigUint::from(7u8).pow(2000);
        let huge = BigRational::from_integer(integer.clone().into());
        assert_eq!(nearest(&huge), None);
        assert_eq!(Agreement::of(1.0, &huge), Agreement::Digits(0.0));
        assert_eq!(Agreement::of(1.0, &huge.recip()), Agreement::Digits(0.0));
        let (one, expected) = (BigUint::from(1u8), 2000.0 * 7f64.log10());
        assert_abs_diff_eq!(log10(&integer, &one), expected, epsilon = 1e-9);
        assert_abs_diff_eq!(log10(&one, &integer), -expected, epsilon = 1e-9);
    }

    #[test]
    fn summary_names_the_worst() {
        let digits = Digits::collect([
            Agreement::Digits(12.0),
            Agreement::Digits(3.5),
            Agreement::BothZero,
            Agreement::Digits(3.5),
        ]);
        assert_eq!(digits.worst(), Some((3.5, 1)));
        assert_eq!(digits.best(), Some((MOST_DIGITS, 2)));
        assert_eq!(digits.median(), Some(3.5));
        assert_eq!(digits.count(), 4);
        assert_eq!(Digits::collect([]).worst(), None);
        assert_eq!(Digits::collect([]).median(), None);
    }

    proptest! {
        #[test]
        fn a_double_agrees_fully_with_itself_and_is_nearest_to_itself(x in any::<f64>()) {
            prop_assume!(x.is_finite());
            let exact = BigRational::from_float(x).unwrap();
            prop_assert_eq!(Agreement::of(x, &exact).digits(), MOST_DIGITS);
            prop_assert_eq!(nearest(&exact), Some(x));
        }

        #[test]
        fn no_neighbour_is_nearer_than_the_nearest(n in any::<i64>(), d in 1..i64::MAX) {
            let exact = ratio(n, d);
            let x = nearest(&exact).unwrap();
            let error = |y: f64| (BigRational::from_float(y).unwrap() - &exact).abs();
            if x != 0.0 {
                for bits in [x.to_bits() - 1, x.to_bits() + 1] {
                    prop_assert!(error(x) <= error(f64::from_bits(bits)));
                }
            }
        }

        #[test]
        fn digits_fall_as_the_error_grows(e in 0.0f64..14.0) {
            let exact = ratio(1, 1);
            let near = Agreement::of(1.0 + 10f64.powf(-e - 1.0), &exact).digits();
            let far = Agreement::of(1.0 + 10f64.powf(-e), &exact).digits();
            prop_assert!(near > far);
            prop_assert!((far - e).abs() < 0.2 || e > 13.0);
        }
    }
}
