//! Rational intervals that contain a real number, as narrow as wanted.
//!
//! Function letters have irrational values at rational points; an interval tells how large they are
//! and whether two elements differ there, without rounding that is not accounted for. Series with
//! their remainders bounded, arguments reduced by halving; pi by Machin's formula (1706). What is computed on the way
//! has dyadic ends, rounded outwards to a fixed number of binary digits; what letters with rational values make
//! without functions is exact.

use super::{FunctionLetter, FunctionTable};
use crate::real::Interval as Ends;
use crate::real::dyadic::Dyadic;
use num_rational::BigRational;
use num_traits::Zero;
use ratpoly::{Budget, Polynomial, RationalFunction, allowance};
use std::collections::BTreeMap;

/// Binary digits that end points keep.
const BITS: u32 = 320;
/// Terms of a series below this are left to the remainder: 2 to the minus this.
const TAIL: i64 = 330;
/// Arguments beyond this are not enclosed.
const LARGEST_ARGUMENT: i64 = 100_000;

/// What an operation on intervals counts in the steps of an allowance.
const OPERATION: u64 = 100;

/// All numbers from `low` to `high`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Interval {
    /// The lower end.
    pub low: BigRational,
    /// The upper end.
    pub high: BigRational,
}

impl Interval {
    /// Whether the intervals have no number in common: then what they enclose differs.
    pub fn is_apart_from(&self, other: &Self) -> bool {
        self.high < other.low || other.high < self.low
    }

    /// The number in the middle.
    pub fn middle(&self) -> BigRational {
        (&self.low + &self.high) / BigRational::from_integer(2.into())
    }
}

impl From<Ends> for Interval {
    fn from(ends: Ends) -> Self {
        Interval {
            low: ends.low().to_rational(),
            high: ends.high().to_rational(),
        }
    }
}

/// Powers of rational numbers that stay exact.
fn short() -> Budget {
    Budget::new(usize::MAX, 4_000, u64::MAX)
}

fn sum(a: &Ends, b: &Ends) -> Ends {
    allowance::spend(OPERATION);
    a.add(b, BITS)
}

fn product(a: &Ends, b: &Ends) -> Ends {
    allowance::spend(OPERATION);
    a.multiply(b, BITS)
}

/// `None` where zero may be divided by.
fn quotient(a: &Ends, b: &Ends) -> Option<Ends> {
    allowance::spend(OPERATION);
    a.divide(b, BITS)
}

/// An interval over a natural number from one on.
fn over(a: &Ends, n: i64) -> Ends {
    quotient(a, &Ends::integer(n)).unwrap_or_else(|| a.clone())
}

fn power(base: &Ends, mut exponent: u32) -> Ends {
    let mut square = base.clone();
    let mut result = Ends::integer(1);
    while exponent > 0 {
        if exponent & 1 == 1 {
            result = product(&result, &square);
        }
        exponent >>= 1;
        if exponent > 0 {
            square = product(&square, &square);
        }
    }
    result
}

/// An argument halved until it is less than 1/16, and how often; `None` for one that is too large.
fn halved(x: &Dyadic) -> Option<(Dyadic, u32)> {
    if x.absolute() > Dyadic::integer(LARGEST_ARGUMENT) {
        return None;
    }
    // 2^(k-1) <= |x| < 2^k.
    let halvings = x.magnitude().map_or(0, |k| (k + 4).max(0));
    Some((x.scaled(-halvings), u32::try_from(halvings).ok()?))
}

fn enough() -> Dyadic {
    Dyadic::power_of_two(-TAIL)
}

/// e^x for one number.
fn exponential_at(x: &Dyadic) -> Option<Ends> {
    let (r, halvings) = halved(x)?;
    let r = Ends::point(r);
    let mut term = Ends::integer(1);
    let mut all = term.clone();
    let mut k = 1i64;
    while term.largest() > enough() {
        term = over(&product(&term, &r), k);
        all = sum(&all, &term);
        k += 1;
    }
    // |r| <= 1/16: what is left is less than the last term.
    all = all.widened(&enough(), BITS);
    for _ in 0..halvings {
        all = product(&all, &all);
    }
    Some(all)
}

/// cos x and sin x for one number.
fn cosine_and_sine(x: &Dyadic) -> Option<(Ends, Ends)> {
    let (r, halvings) = halved(x)?;
    let minus_square = Ends::point(r.times(&r)).negated();
    let series = |first: Dyadic, start: i64| {
        let mut term = Ends::point(first);
        let mut all = term.clone();
        let mut k = start;
        while term.largest() > enough() {
            term = over(&product(&term, &minus_square), k * (k + 1));
            all = sum(&all, &term);
            k += 2;
        }
        all.widened(&enough(), BITS)
    };
    let mut cosine = series(Dyadic::integer(1), 1);
    let mut sine = series(r, 2);
    for _ in 0..halvings {
        let doubled = product(&sine, &cosine).scaled(1);
        let square = product(&sine, &sine);
        cosine = sum(&Ends::integer(1), &square.scaled(1).negated());
        sine = doubled;
    }
    Some((cosine, sine))
}

/// The circle's constant: 16 arctan(1/5) - 4 arctan(1/239).
fn pi() -> Ends {
    let arctangent = |n: i64| {
        let mut power = over(&Ends::integer(1), n);
        let mut all = Ends::integer(0);
        let mut k = 0i64;
        while power.largest() > enough() {
            let term = over(&power, 2 * k + 1);
            all = match k % 2 {
                0 => sum(&all, &term),
                _ => sum(&all, &term.negated()),
            };
            power = over(&power, n * n);
            k += 1;
        }
        all.widened(&enough(), BITS)
    };
    sum(
        &arctangent(5).scaled(4),
        &arctangent(239).scaled(2).negated(),
    )
}

/// ln x for one positive number, by 2 artanh((x - 1)/(x + 1)) after taking roots of two.
fn logarithm_at(x: &Dyadic) -> Option<Ends> {
    let artanh = |y: &Ends| {
        let square = product(y, y);
        let mut power = y.clone();
        let mut all = Ends::integer(0);
        let mut k = 1i64;
        while power.largest() > enough() {
            all = sum(&all, &over(&power, k));
            power = product(&power, &square);
            k += 2;
        }
        // The squares are less than 1/8: what is left is less than the last power.
        all.widened(&enough(), BITS).scaled(1)
    };
    if !x.is_positive() {
        return None;
    }
    // 1 <= x / 2^twos < 2.
    let twos = x.magnitude()? - 1;
    let reduced = Ends::point(x.scaled(-twos));
    let one = Ends::integer(1);
    let rest = artanh(&quotient(
        &sum(&reduced, &one.negated()),
        &sum(&reduced, &one),
    )?);
    let two = artanh(&over(&one, 3));
    Some(sum(&rest, &product(&Ends::integer(twos), &two)))
}

/// e^x for one rational number.
pub(super) fn exponential(x: &BigRational) -> Option<Interval> {
    let found = Ends::rational(x, BITS).increasing(exponential_at)?;
    Some(found.into())
}

/// ln x for a positive rational number.
pub(super) fn logarithm(x: &BigRational) -> Option<Interval> {
    let found = Ends::rational(x, BITS).increasing(logarithm_at)?;
    Some(found.into())
}

/// The root of a rational number that is not negative.
pub(super) fn square_root(x: &BigRational) -> Option<Interval> {
    Some(Ends::rational(x, BITS).root(2, BITS)?.into())
}

/// A rational number, or numbers around a real one.
#[derive(Clone)]
enum Number {
    Exactly(BigRational),
    Between(Ends),
}

impl Number {
    fn ends(&self) -> Ends {
        match self {
            Number::Exactly(x) => Ends::rational(x, BITS),
            Number::Between(ends) => ends.clone(),
        }
    }
}

/// The values of letters at a point, each computed once however often it stands in arguments.
type Known = BTreeMap<usize, Number>;

impl FunctionTable {
    /// An interval that contains the value of a real element at a point where letters have rational
    /// values; `None` where it has none or the interval would be unbounded.
    pub fn enclosure(
        &self,
        f: &RationalFunction,
        point: &[Option<BigRational>],
    ) -> Option<Interval> {
        let found = self.enclosed_function(f, point, &mut BTreeMap::new())?;
        Some(match found {
            Number::Exactly(x) => Interval {
                low: x.clone(),
                high: x,
            },
            Number::Between(ends) => ends.into(),
        })
    }

    fn enclosed_function(
        &self,
        f: &RationalFunction,
        point: &[Option<BigRational>],
        known: &mut Known,
    ) -> Option<Number> {
        let above = self.enclosed(f.numerator(), point, known)?;
        let below = self.enclosed(f.denominator(), point, known)?;
        Some(match (&above, &below) {
            (_, Number::Exactly(below)) if below.is_zero() => return None,
            (Number::Exactly(above), Number::Exactly(below)) => Number::Exactly(above / below),
            _ => Number::Between(quotient(&above.ends(), &below.ends())?),
        })
    }

    fn enclosed(
        &self,
        p: &Polynomial,
        point: &[Option<BigRational>],
        known: &mut Known,
    ) -> Option<Number> {
        let letters = p.variables_occurring();
        for letter in &letters {
            if !known.contains_key(letter) {
                let value = match self.meaning(*letter) {
                    Some(function) => {
                        Number::Between(self.enclosed_letter(&function, point, known)?)
                    }
                    None => Number::Exactly(point.get(*letter)?.clone()?),
                };
                known.insert(*letter, value);
            }
        }
        let exact = |l: &usize| matches!(known.get(l), Some(Number::Exactly(_)));
        if letters.iter().all(exact) {
            let mut values = vec![BigRational::zero(); self.ring.len()];
            for letter in &letters {
                if let Some(Number::Exactly(x)) = known.get(letter) {
                    values[*letter] = x.clone();
                }
            }
            allowance::spend(OPERATION * (1 + p.len() as u64));
            if let Ok(value) = p.evaluate_within(&values, &short()) {
                return Some(Number::Exactly(value));
            }
        }
        let ends: BTreeMap<usize, Ends> = letters
            .iter()
            .filter_map(|l| Some((*l, known.get(l)?.ends())))
            .collect();
        let mut powers: BTreeMap<(usize, u32), Ends> = BTreeMap::new();
        let mut all = Ends::integer(0);
        for (monomial, coefficient) in p.terms() {
            let mut term = Ends::point(Dyadic::new(coefficient, 0)).rounded(BITS);
            for (letter, value) in &ends {
                let exponent = monomial.exponents()[*letter];
                if exponent > 0 {
                    let power = powers
                        .entry((*letter, exponent))
                        .or_insert_with(|| power(value, exponent));
                    term = product(&term, power);
                }
            }
            all = sum(&all, &term);
        }
        Some(Number::Between(all))
    }

    fn enclosed_letter(
        &self,
        function: &FunctionLetter,
        point: &[Option<BigRational>],
        known: &mut Known,
    ) -> Option<Ends> {
        match function {
            FunctionLetter::Pi => Some(pi()),
            FunctionLetter::Exponential(u) => {
                let exponent = self.enclosed_function(u, point, known)?.ends();
                exponent.increasing(exponential_at)
            }
            FunctionLetter::Cosine(u) | FunctionLetter::Sine(u, _) => {
                let angle = self.enclosed_function(u, point, known)?.ends();
                // The derivative is at most one.
                let (cosine, sine) = cosine_and_sine(&angle.middle(BITS))?;
                let value = if function.as_cosine().is_some() {
                    cosine
                } else {
                    sine
                };
                Some(value.widened(&angle.width(), BITS))
            }
            FunctionLetter::Root(p) => self.enclosed(p, point, known)?.ends().root(2, BITS),
            FunctionLetter::Logarithm(p) => {
                let argument = self.enclosed(p, point, known)?.ends();
                argument.increasing(logarithm_at)
            }
            FunctionLetter::Power(base, exponent) => {
                let base = self.enclosed(base, point, known)?.ends();
                let logarithm = base.increasing(logarithm_at)?;
                let exponent = self.enclosed_function(exponent, point, known)?.ends();
                product(&logarithm, &exponent).increasing(exponential_at)
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
    use num_bigint::BigInt;
    use num_traits::{One, Signed};

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
        let integer = |n: i64| BigRational::from_integer(n.into());
        shows(pi().into(), "3.14159265358979323846264");
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
        let tenth = BigRational::new(1.into(), 10.into());
        shows(logarithm(&tenth).unwrap(), "-2.30258509299404568401799");
        shows(
            square_root(&integer(2)).unwrap(),
            "1.41421356237309504880168",
        );
        let (cosine, sine) = cosine_and_sine(&Dyadic::integer(1)).unwrap();
        shows(cosine.into(), "0.54030230586813971740094");
        shows(sine.into(), "0.84147098480789650665250");
    }

    #[test]
    fn what_has_a_rational_value_is_that() {
        let integer = |n: i64| BigRational::from_integer(n.into());
        for n in [0, 1, 4, 49] {
            let root = square_root(&integer(n)).unwrap();
            assert_eq!(root.low, root.high);
            assert_eq!(&root.low * &root.low, integer(n));
        }
        assert!(square_root(&integer(-1)).is_none());
        assert!(logarithm(&integer(0)).is_none());
        let one = exponential(&integer(0)).unwrap();
        assert!(one.low <= integer(1) && integer(1) <= one.high);
    }
}
