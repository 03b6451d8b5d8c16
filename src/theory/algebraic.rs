//! Real algebraic numbers: an irreducible polynomial over the integers and an interval that holds
//! one of its roots.
//!
//! A rational function at algebraic numbers is found by eliminating them with resultants from
//! `y D(x) - N(x)` and choosing, among the roots in `y`, the one that the values of ever smaller
//! intervals leave over (R. Loos, Computing in algebraic extensions, 1982). Invariants: a rational
//! number is stored as such; the polynomial of another one is irreducible and primitive with a
//! positive leading coefficient; equal numbers have equal polynomials and the same root of them.

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Signed, Zero};
use ratpoly::{
    Budget, Error, Order, Polynomial, RationalFunction, RealRoot, Ring, real_roots,
    resultant_within,
};
use std::cmp::Ordering;

/// How often intervals are refined to tell numbers apart.
const REFINEMENTS: u32 = 60;
/// The bits by which each refinement shrinks the intervals.
const STEP: usize = 16;

/// A real algebraic number.
#[derive(Clone, Debug)]
pub enum Algebraic {
    /// A rational number.
    Rational(BigRational),
    /// Any other.
    Root {
        /// The irreducible polynomial, in the first variable of its ring.
        polynomial: Polynomial,
        /// Which of its roots.
        root: RealRoot,
        /// Which one counted from the smallest, from 0.
        index: usize,
    },
}

impl PartialEq for Algebraic {
    fn eq(&self, other: &Self) -> bool {
        match (self, other) {
            (Algebraic::Rational(a), Algebraic::Rational(b)) => a == b,
            (
                Algebraic::Root {
                    polynomial, index, ..
                },
                Algebraic::Root {
                    polynomial: p,
                    index: i,
                    ..
                },
            ) => polynomial == p && index == i,
            _ => false,
        }
    }
}

impl Eq for Algebraic {}

impl From<BigRational> for Algebraic {
    fn from(value: BigRational) -> Self {
        Algebraic::Rational(value)
    }
}

/// The ring of the polynomials that define algebraic numbers.
fn line() -> Result<Ring, Error> {
    Ring::new(["y"], Order::Lex)
}

impl Algebraic {
    /// The real roots of a polynomial in one variable, in increasing order.
    ///
    /// # Errors
    /// A limit of the budget, or a polynomial with other variables.
    pub fn roots(
        f: &Polynomial,
        variable: usize,
        budget: &Budget,
    ) -> Result<Vec<Algebraic>, Error> {
        let ring = line()?;
        let mut map = vec![None; f.ring().len()];
        map[variable] = Some(0);
        let f = f.map_ring(ring, &map)?;
        let mut found = Vec::new();
        for (factor, _) in f.factor_within(budget)?.factors {
            let factor = factor.unit_normal();
            if factor.degree(0) == Some(1) {
                let c = |k| factor.coefficient(&[k]);
                found.push(Algebraic::Rational(BigRational::new(-c(0), c(1))));
                continue;
            }
            for (index, root) in real_roots(&factor, 0, budget)?.into_iter().enumerate() {
                found.push(Algebraic::Root {
                    polynomial: factor.clone(),
                    root,
                    index,
                });
            }
        }
        found.sort_by(|a, b| a.compare(b));
        Ok(found)
    }

    /// The value of a rational function at algebraic numbers, one for each variable that occurs.
    ///
    /// # Errors
    /// A limit of the budget, a variable without a value, or a pole.
    pub fn evaluate(
        f: &RationalFunction,
        values: &[(usize, Algebraic)],
        budget: &Budget,
    ) -> Result<Algebraic, Error> {
        let rational: Vec<(usize, RationalFunction)> = values
            .iter()
            .filter_map(|(variable, value)| {
                let value = value.as_rational()?.clone();
                Some((*variable, RationalFunction::constant(f.ring(), value)))
            })
            .collect();
        let f = f.substitute(&rational)?;
        if let Some(value) = f.as_constant() {
            return Ok(Algebraic::Rational(value));
        }
        let mut occurring = f.numerator().variables_occurring();
        occurring.extend(f.denominator().variables_occurring());
        let irrational: Vec<&(usize, Algebraic)> = values
            .iter()
            .filter(|(variable, _)| occurring.contains(variable))
            .collect();
        if occurring
            .iter()
            .any(|v| !values.iter().any(|(w, _)| w == v))
        {
            return Err(Error::Unsupported("a variable without a value"));
        }
        let names = (0..irrational.len()).map(|k| format!("x{k}"));
        let ring = Ring::new(names.chain(["y".to_string()]), Order::Lex)?;
        let y = irrational.len();
        let mut map = vec![None; f.ring().len()];
        for (k, (variable, _)) in irrational.iter().enumerate() {
            map[*variable] = Some(k);
        }
        let numerator = f.numerator().map_ring(ring, &map)?;
        let denominator = f.denominator().map_ring(ring, &map)?;
        let mut eliminated =
            Polynomial::variable(ring, y).mul_within(&denominator, budget)? - numerator.clone();
        for (k, (_, value)) in irrational.iter().enumerate() {
            if let Algebraic::Root { polynomial, .. } = value {
                let minimal = polynomial.map_ring(ring, &[Some(k)])?;
                eliminated = resultant_within(&minimal, &eliminated, k, budget)?;
            }
        }
        let candidates = Algebraic::roots(&eliminated, y, budget)?;
        let mut width = BigRational::one();
        for _ in 0..REFINEMENTS {
            width /= BigInt::one() << STEP;
            let intervals: Vec<Interval> = irrational
                .iter()
                .map(|(_, value)| value.enclosure(&width))
                .collect::<Result<_, _>>()?;
            let Some((low, high)) = quotient(
                &image(&numerator, &intervals),
                &image(&denominator, &intervals),
            ) else {
                continue;
            };
            let mut inside = candidates
                .iter()
                .filter(|c| c.compare_rational(&low).is_ge() && c.compare_rational(&high).is_le());
            if let (Some(only), None) = (inside.next(), inside.next()) {
                return Ok(only.clone());
            }
        }
        Err(Error::Unsupported("a number that cannot be told apart"))
    }

    /// The quotient.
    ///
    /// # Errors
    /// A limit of the budget, or a division by zero.
    pub fn divided_by(&self, other: &Algebraic, budget: &Budget) -> Result<Algebraic, Error> {
        let ring = Ring::new(["x", "y"], Order::Lex)?;
        let [x, y] = [0, 1].map(|k| RationalFunction::variable(ring, k));
        let values = [(0, self.clone()), (1, other.clone())];
        Algebraic::evaluate(&x.checked_div(&y)?, &values, budget)
    }

    /// The number less one.
    ///
    /// # Errors
    /// A limit of the budget.
    pub fn less_one(&self, budget: &Budget) -> Result<Algebraic, Error> {
        let ring = line()?;
        let f = RationalFunction::variable(ring, 0) - RationalFunction::one(ring);
        Algebraic::evaluate(&f, &[(0, self.clone())], budget)
    }

    /// The number, if it is rational.
    pub fn as_rational(&self) -> Option<&BigRational> {
        match self {
            Algebraic::Rational(value) => Some(value),
            Algebraic::Root { .. } => None,
        }
    }

    /// Rational numbers around it that are closer to each other than `width`, which is positive.
    ///
    /// # Errors
    /// When `width` is not positive.
    pub fn enclosure(&self, width: &BigRational) -> Result<Interval, Error> {
        match self {
            Algebraic::Rational(value) => Ok((value.clone(), value.clone())),
            Algebraic::Root { root, .. } => {
                let mut root = root.clone();
                root.refine(width)?;
                Ok((root.low().clone(), root.high().clone()))
            }
        }
    }

    /// Where it lies against a rational number.
    pub fn compare_rational(&self, value: &BigRational) -> Ordering {
        match self {
            Algebraic::Rational(own) => own.cmp(value),
            Algebraic::Root { root, .. } => root.compare(value),
        }
    }

    /// Where it lies against another one.
    pub fn compare(&self, other: &Algebraic) -> Ordering {
        if self == other {
            return Ordering::Equal;
        }
        if let Some(value) = other.as_rational() {
            return self.compare_rational(value);
        }
        // They differ, so that intervals that are small enough are apart.
        let mut width = BigRational::one();
        loop {
            width /= BigInt::one() << STEP;
            match (self.enclosure(&width), other.enclosure(&width)) {
                (Ok((_, high)), Ok((low, _))) if high < low => return Ordering::Less,
                (Ok((low, _)), Ok((_, high))) if high < low => return Ordering::Greater,
                (Ok(_), Ok(_)) => {}
                _ => return Ordering::Equal,
            }
        }
    }

    /// Whether it is greater than zero.
    pub fn is_positive(&self) -> bool {
        self.compare_rational(&BigRational::zero()).is_gt()
    }

    /// In decimal notation, rounded to so many significant digits; whole digits are all kept.
    pub fn decimal(&self, digits: u32) -> String {
        if let Some(integer) = self.as_rational().filter(|v| v.is_integer()) {
            return integer.to_string();
        }
        let ten = BigInt::from(10);
        let mut width = BigRational::one();
        let mut shown = String::new();
        for _ in 0..REFINEMENTS {
            let Ok((low, high)) = self.enclosure(&width) else {
                break;
            };
            width /= BigInt::one() << STEP;
            let size = low.abs().max(high.abs());
            // Digits after the point: more for small numbers, fewer for large ones.
            let mut places = i64::from(digits) - 1;
            let mut scale = BigRational::one();
            while size < scale && !size.is_zero() && places < 60 {
                scale /= &ten;
                places += 1;
            }
            while size >= &scale * &ten && places > 0 {
                scale *= &ten;
                places -= 1;
            }
            let places = usize::try_from(places).unwrap_or(0);
            shown = rounded(&low, places);
            if shown == rounded(&high, places) {
                break;
            }
        }
        shown
    }

    /// The number in square roots, where its polynomial has degree two, or degree two in the
    /// square.
    pub fn radicals(&self) -> Option<Radicals> {
        let Algebraic::Root {
            polynomial, root, ..
        } = self
        else {
            return None;
        };
        let c = |k: u32| polynomial.coefficient(&[k]);
        match polynomial.degree(0)? {
            2 => Some(Radicals {
                squared: false,
                negative: false,
                sum: quadratic(&c(2), &c(1), &c(0), &|x, larger| {
                    // The two roots lie on the two sides of the middle.
                    root.compare(x).is_gt() == larger
                })?,
            }),
            4 if c(1).is_zero() && c(3).is_zero() => {
                let negative = root.compare(&BigRational::zero()).is_lt();
                let width = BigRational::new(1.into(), BigInt::one() << 40);
                let (low, high) = self.enclosure(&width).ok()?;
                let square = {
                    let (a, b) = (&low * &low, &high * &high);
                    if a < b { (a, b) } else { (b, a) }
                };
                Some(Radicals {
                    squared: true,
                    negative,
                    sum: quadratic(&c(4), &c(2), &c(0), &|x, larger| {
                        if larger { &square.0 > x } else { &square.1 < x }
                    })?,
                })
            }
            _ => None,
        }
    }
}

/// `rational + coefficient sqrt(radicand)`, or plus or minus the square root of that.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Radicals {
    /// Whether the number is the square root of what follows.
    pub squared: bool,
    /// Whether it is the negative square root.
    pub negative: bool,
    /// Rational part, coefficient, and a radicand without square factors that are easily found.
    pub sum: (BigRational, BigRational, BigInt),
}

/// The root of `a y^2 + b y + c` on the side of its middle that `is_root` names.
fn quadratic(
    a: &BigInt,
    b: &BigInt,
    c: &BigInt,
    is_root: &dyn Fn(&BigRational, bool) -> bool,
) -> Option<(BigRational, BigRational, BigInt)> {
    let discriminant = b * b - BigInt::from(4) * a * c;
    if !discriminant.is_positive() {
        return None;
    }
    let (outside, inside) = square_part(&discriminant);
    let middle = BigRational::new(-b, BigInt::from(2) * a);
    let half = BigRational::new(outside, BigInt::from(2) * a.abs());
    let larger = is_root(&middle, true);
    if larger == is_root(&middle, false) {
        return None;
    }
    Some((middle, if larger { half } else { -half }, inside))
}

/// Rounded to so many places, halves away from zero.
fn rounded(value: &BigRational, places: usize) -> String {
    let unit = num_traits::pow(BigInt::from(10), places);
    let scaled = (value.abs() * &unit).round().to_integer();
    let sign = if value.is_negative() && !scaled.is_zero() {
        "-"
    } else {
        ""
    };
    let (whole, rest) = (&scaled / &unit, &scaled % &unit);
    if places == 0 {
        return format!("{sign}{whole}");
    }
    let rest = rest.to_string();
    format!("{sign}{whole}.{rest:0>places$}")
}

/// `n = outside^2 inside`, with all square factors of small primes outside, and what else is left if it
/// is a square.
pub fn square_part(n: &BigInt) -> (BigInt, BigInt) {
    let (mut outside, mut small, mut rest) = (BigInt::one(), BigInt::one(), n.clone());
    let mut p = 2_u32;
    while p < 2000 && !rest.is_one() {
        let square = BigInt::from(p * p);
        while (&rest % &square).is_zero() {
            rest /= &square;
            outside *= p;
        }
        if (&rest % p).is_zero() {
            rest /= p;
            small *= p;
        }
        p += if p == 2 { 1 } else { 2 };
    }
    let root = rest.abs().sqrt();
    if rest.is_positive() && &root * &root == rest {
        (outside * root, small)
    } else {
        (outside, small * rest)
    }
}

/// A closed interval.
pub type Interval = (BigRational, BigRational);

/// An interval that holds the values of a polynomial in the first variables of its ring.
fn image(f: &Polynomial, intervals: &[Interval]) -> Interval {
    let mut sum = (BigRational::zero(), BigRational::zero());
    for (monomial, coefficient) in f.terms() {
        let coefficient = BigRational::from_integer(coefficient);
        let mut term = (coefficient.clone(), coefficient);
        for (interval, &exponent) in intervals.iter().zip(monomial.exponents()) {
            for _ in 0..exponent {
                term = product(&term, interval);
            }
        }
        sum = (sum.0 + term.0, sum.1 + term.1);
    }
    sum
}

fn product(a: &Interval, b: &Interval) -> Interval {
    let ends = [&a.0 * &b.0, &a.0 * &b.1, &a.1 * &b.0, &a.1 * &b.1];
    let least = ends.iter().min().cloned().unwrap_or_default();
    let most = ends.iter().max().cloned().unwrap_or_default();
    (least, most)
}

fn quotient(a: &Interval, b: &Interval) -> Option<Interval> {
    if !(b.0.is_positive() || b.1.is_negative()) {
        return None;
    }
    Some(product(a, &(b.1.recip(), b.0.recip())))
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn roots(text: &str) -> Vec<Algebraic> {
        let ring = Ring::new(["x"], Order::Lex).unwrap();
        let f = Polynomial::parse(ring, text).unwrap();
        Algebraic::roots(&f, 0, &Budget::default()).unwrap()
    }

    fn at(text: &str, values: &[Algebraic]) -> Result<Algebraic, Error> {
        let ring = Ring::new(["p", "q"], Order::Lex).unwrap();
        let f = RationalFunction::parse(ring, text).unwrap();
        let values: Vec<(usize, Algebraic)> = values.iter().cloned().enumerate().collect();
        Algebraic::evaluate(&f, &values, &Budget::default())
    }

    fn rational(n: i64, d: i64) -> Algebraic {
        BigRational::new(n.into(), d.into()).into()
    }

    #[test]
    fn roots_in_order_and_rational_ones_as_such() {
        let found = roots("(x^2 - 2)*(2*x - 1)*x*(x + 3)");
        assert_eq!(found.len(), 5);
        assert_eq!(found[0], rational(-3, 1));
        assert_eq!(found[2], rational(0, 1));
        assert_eq!(found[3], rational(1, 2));
        assert!(found[4].as_rational().is_none() && found[4].is_positive());
        assert!(roots("x^2 + 1").is_empty());
    }

    #[test]
    fn sums_and_products_of_square_roots() {
        let (two, three) = (roots("x^2 - 2")[1].clone(), roots("x^2 - 3")[1].clone());
        let six = roots("x^2 - 6")[1].clone();
        assert_eq!(at("p*q", &[two.clone(), three.clone()]).unwrap(), six);
        assert_eq!(
            at("p*p", &[two.clone(), three.clone()]).unwrap(),
            rational(2, 1)
        );
        assert_eq!(at("p/q", &[six.clone(), two.clone()]).unwrap(), three);
        // The sum has degree four; twice its square less ten squared is 24.
        let sum = at("p + q", &[two.clone(), three.clone()]).unwrap();
        assert_eq!(sum.decimal(5), "3.1463");
        assert_eq!(
            at("(p^2 - 5)^2", &[sum.clone(), six]).unwrap(),
            rational(24, 1)
        );
        let shown = sum.radicals().unwrap();
        assert!(shown.squared && !shown.negative);
        assert_eq!(shown.sum, (5.into_rational(), 2.into_rational(), 6.into()));
        assert!(at("1/(p^2 - 2)", &[two, three]).is_err());
    }

    trait IntoRational {
        fn into_rational(self) -> BigRational;
    }
    impl IntoRational for i64 {
        fn into_rational(self) -> BigRational {
            BigRational::from_integer(self.into())
        }
    }

    #[test]
    fn both_roots_of_a_quadratic_in_radicals() {
        let [small, large] = <[Algebraic; 2]>::try_from(roots("4*x^2 - 4*x - 7")).unwrap();
        let half = BigRational::new(1.into(), 2.into());
        let one = BigRational::one();
        assert_eq!(
            large.radicals().unwrap().sum,
            (half.clone(), one.clone(), 2.into())
        );
        assert_eq!(small.radicals().unwrap().sum, (half, -one, 2.into()));
        assert_eq!(small.decimal(3), "-0.914");
        assert_eq!(rational(2, 3).decimal(3), "0.667");
        assert_eq!(rational(1, 592).decimal(4), "0.001689");
        assert_eq!(rational(46_475_800, 1000).decimal(4), "46476");
        assert_eq!(rational(0, 1).decimal(3), "0");
        assert!(roots("x^3 - 2")[0].radicals().is_none());
        assert!(small.compare(&large).is_lt() && large.compare(&small).is_gt());
    }

    proptest! {
        /// Rational numbers behave as they do elsewhere, zero and equal arguments included.
        #[test]
        fn rational_arguments(a in -9_i64..9, b in -9_i64..9, d in 1_i64..5) {
            let (p, q) = (rational(a, d), rational(b, 1));
            let expected = BigRational::new(a.into(), d.into()) + BigRational::from_integer(b.into());
            prop_assert_eq!(at("p + q", &[p.clone(), q.clone()]).unwrap(), expected.into());
            prop_assert_eq!(p.compare(&q), (a).cmp(&(b * d)));
            prop_assert_eq!(at("1/q", &[p, q]).is_err(), b == 0);
        }

        /// The square of the square root, by resultants and intervals, is the number again.
        #[test]
        fn square_roots_square(n in 1_i64..200, m in 1_i64..200) {
            let one = roots(&format!("x^2 - {n}")).pop().unwrap();
            let other = roots(&format!("x^2 - {m}")).pop().unwrap();
            let product = at("p*q", &[one.clone(), other.clone()]).unwrap();
            prop_assert_eq!(at("p^2", &[product, rational(0, 1)]).unwrap(), rational(n * m, 1));
            prop_assert_eq!(one.compare(&other), n.cmp(&m));
        }
    }
}
