//! Rational intervals that contain a real number, as narrow as wanted.
//!
//! Function letters have irrational values at rational points; an interval tells how large they are
//! and whether two elements differ there, without rounding that is not accounted for. Series with
//! their remainders bounded, arguments reduced by halving; pi by Machin's formula (1706). End points
//! are rounded outwards to a fixed number of binary digits.

use super::{FunctionLetter, FunctionTable};
use num_bigint::BigInt;
use num_integer::Integer;
use num_rational::BigRational;
use num_traits::{One, Signed, Zero};
use ratpoly::{Polynomial, RationalFunction, allowance};
use std::collections::BTreeMap;

/// Binary digits that end points keep.
const BITS: i64 = 320;
/// Terms of a series below this are left to the remainder: 2 to the minus this.
const TAIL: usize = 330;
/// Arguments beyond this are not enclosed.
const LARGEST_ARGUMENT: i64 = 100_000;

/// What an operation on intervals counts in the steps of an allowance.
const OPERATION: u64 = 1_500;

/// All numbers from `low` to `high`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Interval {
    /// The lower end.
    pub low: BigRational,
    /// The upper end.
    pub high: BigRational,
}

fn integer(n: i64) -> BigRational {
    BigRational::from_integer(n.into())
}

/// `x` rounded down to [`BITS`] significant binary digits.
fn rounded_down(x: &BigRational) -> BigRational {
    if x.is_zero() {
        return x.clone();
    }
    let size = |n: &BigInt| i64::try_from(n.bits()).unwrap_or(i64::MAX / 4);
    let shift = BITS - (size(x.numer()) - size(x.denom()));
    let scaled = if shift >= 0 {
        (x.numer() << shift).div_floor(x.denom())
    } else {
        x.numer().div_floor(&(x.denom() << -shift))
    };
    if shift >= 0 {
        BigRational::new(scaled, BigInt::one() << shift)
    } else {
        BigRational::from_integer(scaled << -shift)
    }
}

impl Interval {
    /// A single rational number.
    pub fn point(x: BigRational) -> Self {
        Interval {
            low: x.clone(),
            high: x,
        }
    }

    fn outwards(low: &BigRational, high: &BigRational) -> Self {
        Interval {
            low: rounded_down(low),
            high: -rounded_down(&-high.clone()),
        }
    }

    fn add(&self, other: &Self) -> Self {
        allowance::spend(OPERATION);
        Interval::outwards(&(&self.low + &other.low), &(&self.high + &other.high))
    }

    fn negated(&self) -> Self {
        Interval {
            low: -self.high.clone(),
            high: -self.low.clone(),
        }
    }

    fn multiply(&self, other: &Self) -> Self {
        allowance::spend(OPERATION);
        let (a, b, c, d) = (&self.low, &self.high, &other.low, &other.high);
        let not_negative = |x: &BigRational| !x.is_negative();
        let not_positive = |x: &BigRational| !x.is_positive();
        // Which ends have the least and the greatest product follows from their signs.
        let (low, high) = if not_negative(a) {
            let low = if not_negative(c) { a * c } else { b * c };
            let high = if not_positive(d) { a * d } else { b * d };
            (low, high)
        } else if not_positive(b) {
            let low = if not_positive(d) { b * d } else { a * d };
            let high = if not_negative(c) { b * c } else { a * c };
            (low, high)
        } else if not_negative(c) {
            (a * d, b * d)
        } else if not_positive(d) {
            (b * c, a * c)
        } else {
            ((a * d).min(b * c), (a * c).max(b * d))
        };
        Interval::outwards(&low, &high)
    }

    /// `None` where zero may be divided by.
    fn inverse(&self) -> Option<Self> {
        if !self.low.is_positive() && !self.high.is_negative() {
            return None;
        }
        Some(Interval::outwards(&self.high.recip(), &self.low.recip()))
    }

    fn power(&self, mut exponent: u32) -> Self {
        let mut square = self.clone();
        let mut result = Interval::point(BigRational::one());
        while exponent > 0 {
            if exponent & 1 == 1 {
                result = result.multiply(&square);
            }
            exponent >>= 1;
            if exponent > 0 {
                square = square.multiply(&square);
            }
        }
        result
    }

    /// Whether the intervals have no number in common: then what they enclose differs.
    pub fn is_apart_from(&self, other: &Self) -> bool {
        self.high < other.low || other.high < self.low
    }

    /// The number in the middle.
    pub fn middle(&self) -> BigRational {
        (&self.low + &self.high) / integer(2)
    }
}

/// An argument halved until it is less than 1/16, and how often; `None` for one that is too large.
fn halved(x: &BigRational) -> Option<(BigRational, u32)> {
    if x.abs() > integer(LARGEST_ARGUMENT) {
        return None;
    }
    let mut halvings = 0;
    let mut r = x.clone();
    while r.abs() > BigRational::new(1.into(), 16.into()) {
        r /= integer(2);
        halvings += 1;
    }
    Some((r, halvings))
}

fn enough() -> BigRational {
    BigRational::new(BigInt::one(), BigInt::one() << TAIL)
}

/// e^x for one rational number.
pub(super) fn exponential(x: &BigRational) -> Option<Interval> {
    let (r, halvings) = halved(x)?;
    let mut term = Interval::point(BigRational::one());
    let mut sum = term.clone();
    let mut k = 1i64;
    while term.high.abs().max(term.low.abs()) > enough() {
        let factor = Interval::point(&r / integer(k));
        term = term.multiply(&factor);
        sum = sum.add(&term);
        k += 1;
    }
    // |r| < 1/16: what is left is less than the last term.
    sum = widened(&sum, &enough());
    for _ in 0..halvings {
        sum = sum.multiply(&sum);
    }
    Some(sum)
}

fn widened(interval: &Interval, by: &BigRational) -> Interval {
    Interval::outwards(&(&interval.low - by), &(&interval.high + by))
}

/// cos x and sin x for one rational number.
fn cosine_and_sine(x: &BigRational) -> Option<(Interval, Interval)> {
    let (r, halvings) = halved(x)?;
    let minus_square = Interval::point(-(&r * &r));
    let series = |first: BigRational, start: i64| {
        let mut term = Interval::point(first);
        let mut sum = term.clone();
        let mut k = start;
        while term.high.abs().max(term.low.abs()) > enough() {
            let divisor = Interval::point(BigRational::new(1.into(), (k * (k + 1)).into()));
            term = term.multiply(&minus_square).multiply(&divisor);
            sum = sum.add(&term);
            k += 2;
        }
        widened(&sum, &enough())
    };
    let mut cosine = series(BigRational::one(), 1);
    let mut sine = series(r.clone(), 2);
    let two = Interval::point(integer(2));
    for _ in 0..halvings {
        let doubled = two.multiply(&sine).multiply(&cosine);
        let square = sine.multiply(&sine);
        cosine = Interval::point(BigRational::one()).add(&two.multiply(&square).negated());
        sine = doubled;
    }
    Some((cosine, sine))
}

/// The circle's constant: 16 arctan(1/5) - 4 arctan(1/239).
fn pi() -> Interval {
    let arctangent = |n: i64| {
        let square = integer(n * n);
        let mut power = integer(n).recip();
        let mut sum = BigRational::zero();
        let mut k = 0i64;
        while power > enough() {
            let term = &power / integer(2 * k + 1);
            if k % 2 == 0 {
                sum += term;
            } else {
                sum -= term;
            }
            power /= &square;
            k += 1;
        }
        widened(&Interval::point(sum), &enough())
    };
    let sixteen = Interval::point(integer(16)).multiply(&arctangent(5));
    let four = Interval::point(integer(4)).multiply(&arctangent(239));
    sixteen.add(&four.negated())
}

/// The root of a rational number that is not negative, from below and above.
pub(super) fn square_root(x: &BigRational) -> Option<Interval> {
    if x.is_negative() {
        return None;
    }
    let scale = BigInt::one() << (2 * BITS);
    let scaled = (x.numer() * &scale * x.denom()).sqrt();
    let unit = BigInt::one() << BITS;
    let at = |n: BigInt| BigRational::new(n, x.denom() * &unit);
    Some(Interval {
        low: at(scaled.clone()),
        high: at(scaled + 1),
    })
}

/// ln x for a positive rational number, by 2 artanh((x - 1)/(x + 1)) after taking roots of two.
pub(super) fn logarithm(x: &BigRational) -> Option<Interval> {
    if !x.is_positive() {
        return None;
    }
    let artanh = |y: &BigRational| {
        let square = y * y;
        let mut power = Interval::point(y.clone());
        let mut sum = Interval::point(BigRational::zero());
        let mut k = 1i64;
        while power.high.abs().max(power.low.abs()) > enough() {
            let term = power.multiply(&Interval::point(integer(k).recip()));
            sum = sum.add(&term);
            power = power.multiply(&Interval::point(square.clone()));
            k += 2;
        }
        Interval::point(integer(2)).multiply(&widened(&sum, &enough()))
    };
    let mut reduced = x.clone();
    let mut twos = 0i64;
    while reduced > integer(2) {
        reduced /= integer(2);
        twos += 1;
    }
    while reduced < integer(1) {
        reduced *= integer(2);
        twos -= 1;
    }
    let rest = artanh(&((&reduced - integer(1)) / (&reduced + integer(1))));
    let two = artanh(&integer(3).recip());
    Some(rest.add(&Interval::point(integer(twos)).multiply(&two)))
}

/// The values of an increasing function at both ends.
fn between(x: &Interval, f: impl Fn(&BigRational) -> Option<Interval>) -> Option<Interval> {
    Some(Interval::outwards(&f(&x.low)?.low, &f(&x.high)?.high))
}

/// The values of letters at a point, each computed once however often it stands in arguments.
type Known = BTreeMap<usize, Interval>;

impl FunctionTable {
    /// An interval that contains the value of a real element at a point where letters have rational
    /// values; `None` where it has none or the interval would be unbounded.
    pub fn enclosure(
        &self,
        f: &RationalFunction,
        point: &[Option<BigRational>],
    ) -> Option<Interval> {
        self.enclosed_function(f, point, &mut BTreeMap::new())
    }

    fn enclosed_function(
        &self,
        f: &RationalFunction,
        point: &[Option<BigRational>],
        known: &mut Known,
    ) -> Option<Interval> {
        let above = self.enclosed(f.numerator(), point, known)?;
        let below = self.enclosed(f.denominator(), point, known)?;
        Some(above.multiply(&below.inverse()?))
    }

    fn enclosed(
        &self,
        p: &Polynomial,
        point: &[Option<BigRational>],
        known: &mut Known,
    ) -> Option<Interval> {
        let letters = p.variables_occurring();
        for letter in &letters {
            if !known.contains_key(letter) {
                let value = match self.meaning(*letter) {
                    Some(function) => self.enclosed_letter(&function, point, known)?,
                    None => Interval::point(point.get(*letter)?.clone()?),
                };
                known.insert(*letter, value);
            }
        }
        let mut powers: BTreeMap<(usize, u32), Interval> = BTreeMap::new();
        let mut sum = Interval::point(BigRational::zero());
        for (monomial, coefficient) in p.terms() {
            let mut term = Interval::point(BigRational::from_integer(coefficient));
            for letter in &letters {
                let exponent = monomial.exponents()[*letter];
                if let (true, Some(value)) = (exponent > 0, known.get(letter)) {
                    let power = powers
                        .entry((*letter, exponent))
                        .or_insert_with(|| value.power(exponent));
                    term = term.multiply(power);
                }
            }
            sum = sum.add(&term);
        }
        Some(sum)
    }

    fn enclosed_letter(
        &self,
        function: &FunctionLetter,
        point: &[Option<BigRational>],
        known: &mut Known,
    ) -> Option<Interval> {
        match function {
            FunctionLetter::Pi => Some(pi()),
            FunctionLetter::Exponential(u) => {
                between(&self.enclosed_function(u, point, known)?, exponential)
            }
            FunctionLetter::Cosine(u) | FunctionLetter::Sine(u, _) => {
                let angle = self.enclosed_function(u, point, known)?;
                // The derivative is at most one.
                let width = &angle.high - &angle.low;
                let (cosine, sine) = cosine_and_sine(&angle.middle())?;
                let value = if function.as_cosine().is_some() {
                    cosine
                } else {
                    sine
                };
                Some(widened(&value, &width))
            }
            FunctionLetter::Root(p) => between(&self.enclosed(p, point, known)?, square_root),
            FunctionLetter::Logarithm(p) => between(&self.enclosed(p, point, known)?, logarithm),
            FunctionLetter::Power(base, exponent) => {
                let logarithm = between(&self.enclosed(base, point, known)?, logarithm)?;
                let exponent = self.enclosed_function(exponent, point, known)?;
                between(&logarithm.multiply(&exponent), exponential)
            }
            FunctionLetter::ImaginaryUnit
            | FunctionLetter::Dirac(_)
            | FunctionLetter::Bound { .. } => None,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Digits from the tables of Abramowitz & Stegun (1964), 1.1 and 4.
    #[test]
    fn known_digits() {
        let shows = |interval: Interval, digits: &str| {
            let (whole, decimals) = digits.split_once('.').unwrap();
            let scale = num_traits::pow(BigInt::from(10), decimals.len());
            let known: BigInt = format!("{whole}{decimals}").parse().unwrap();
            let near = BigRational::new(known, scale.clone());
            let unit = BigRational::new(1.into(), scale);
            assert!((interval.middle() - near).abs() < unit, "{digits}");
            let width = &interval.high - &interval.low;
            assert!(width < BigRational::new(1.into(), BigInt::one() << 240));
        };
        shows(pi(), "3.14159265358979323846264");
        shows(
            exponential(&integer(1)).unwrap(),
            "2.71828182845904523536028",
        );
        shows(
            exponential(&integer(-2)).unwrap(),
            "0.13533528323661269189400",
        );
        shows(logarithm(&integer(2)).unwrap(), "0.69314718055994530941723");
        shows(
            logarithm(&integer(10)).unwrap(),
            "2.30258509299404568401799",
        );
        shows(
            square_root(&integer(2)).unwrap(),
            "1.41421356237309504880168",
        );
        let (cosine, sine) = cosine_and_sine(&integer(1)).unwrap();
        shows(cosine, "0.54030230586813971740094");
        shows(sine, "0.84147098480789650665250");
    }

    #[test]
    fn a_product_has_the_least_and_the_greatest_of_the_products_of_the_ends() {
        let ends = [(-3, -2), (-3, 0), (-2, 5), (0, 0), (0, 4), (1, 6)];
        for (a, b) in ends {
            for (c, d) in ends {
                let interval = |low, high| Interval {
                    low: integer(low),
                    high: integer(high),
                };
                let product = interval(a, b).multiply(&interval(c, d));
                let all = [a * c, a * d, b * c, b * d];
                let (low, high) = (all.iter().min().unwrap(), all.iter().max().unwrap());
                assert_eq!(product, interval(*low, *high), "{a} {b} {c} {d}");
            }
        }
    }

    #[test]
    fn a_rational_number_is_in_its_interval() {
        let third = BigRational::new(1.into(), 3.into());
        let sum = Interval::point(third.clone()).add(&Interval::point(third.clone()));
        assert!(sum.low <= &third + &third && &third + &third <= sum.high);
        let product = sum.multiply(&Interval::point(-third.clone()));
        assert!(product.high.is_negative());
        assert!(
            Interval {
                low: -third.clone(),
                high: third
            }
            .inverse()
            .is_none()
        );
    }
}
