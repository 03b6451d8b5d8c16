//! The sign of a polynomial on a product of open intervals, decided where the methods here reach.
//!
//! Each interval is mapped to the positive half-line by a Möbius transformation, so that only the open
//! positive orthant is left ([`orthant`]): there coefficients of one sign decide at once (on a box these
//! are the Bernstein coefficients), otherwise exact sample points, discriminants, Pólya's multipliers
//! (Pólya 1928) and subdivision are tried, factor by factor ([`product`]). Every answer but [`RegionSign::Undecided`] is proved.

mod orthant;
mod product;
mod samples;

use crate::allowance;
use crate::budget::Budget;
use crate::error::Error;
use crate::polynomial::Polynomial;
use crate::rational_function::RationalFunction;
use crate::real_roots::Bound;
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Signed, Zero};

/// What is known about the sign of a function on a region.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum RegionSign {
    /// Zero everywhere.
    Zero,
    /// Positive everywhere.
    Positive,
    /// Negative everywhere.
    Negative,
    /// Nowhere negative, positive somewhere; it may vanish somewhere.
    NonNegative,
    /// Nowhere positive, negative somewhere; it may vanish somewhere.
    NonPositive,
    /// Both signs occur.
    Changes {
        /// A point of the region at which it is positive.
        positive: Vec<BigRational>,
        /// A point of the region at which it is negative.
        negative: Vec<BigRational>,
    },
    /// The methods do not reach.
    Undecided,
}

/// A product of open intervals, one for each variable of a ring.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Region {
    intervals: Vec<(Bound, Bound)>,
}

impl Region {
    /// The product of open intervals; each must have a lower end below its upper end.
    pub fn new(intervals: impl Into<Vec<(Bound, Bound)>>) -> Result<Self, Error> {
        let intervals = intervals.into();
        if intervals.iter().any(|(a, b)| a.compare(b).is_ge()) {
            return Err(Error::Unsupported("an interval is empty"));
        }
        Ok(Region { intervals })
    }

    /// All variables positive.
    pub fn positive_orthant(variables: usize) -> Self {
        Region {
            intervals: vec![(Bound::from(0), Bound::PositiveInfinity); variables],
        }
    }

    /// The intervals.
    pub fn intervals(&self) -> &[(Bound, Bound)] {
        &self.intervals
    }

    /// Whether a point lies in the region.
    pub fn contains(&self, point: &[BigRational]) -> bool {
        point.len() == self.intervals.len()
            && self.intervals.iter().zip(point).all(|((a, b), x)| {
                let x = Bound::Finite(x.clone());
                a.compare(&x).is_lt() && x.compare(b).is_lt()
            })
    }
}

impl RegionSign {
    /// The sign of the negated function.
    pub fn negated(self) -> Self {
        match self {
            RegionSign::Positive => RegionSign::Negative,
            RegionSign::Negative => RegionSign::Positive,
            RegionSign::NonNegative => RegionSign::NonPositive,
            RegionSign::NonPositive => RegionSign::NonNegative,
            RegionSign::Changes { positive, negative } => RegionSign::Changes {
                positive: negative,
                negative: positive,
            },
            same => same,
        }
    }

    /// The sign of a product of two functions, neither of which is known to change its sign; of a
    /// polynomial that is not zero everywhere a product is not either.
    pub(crate) fn times(self, other: Self) -> Self {
        use RegionSign::*;
        match (self, other) {
            (Zero, _) | (_, Zero) => Zero,
            (Positive, sign) | (sign, Positive) => sign,
            (Negative, sign) | (sign, Negative) => sign.negated(),
            (NonNegative, sign @ (NonNegative | NonPositive)) => sign,
            (NonPositive, sign @ (NonNegative | NonPositive)) => sign.negated(),
            _ => Undecided,
        }
    }

    /// What is known on a union of two regions; a change of sign that only the two together show is
    /// `None`, for its witnesses are still to be found.
    pub(crate) fn union(self, other: Self) -> Option<Self> {
        use RegionSign::*;
        Some(match (self, other) {
            (change @ Changes { .. }, _) | (_, change @ Changes { .. }) => change,
            (Undecided, _) | (_, Undecided) => Undecided,
            (a, b) if a == b => a,
            (Zero | Positive | NonNegative, Zero | Positive | NonNegative) => NonNegative,
            (Zero | Negative | NonPositive, Zero | Negative | NonPositive) => NonPositive,
            _ => return None,
        })
    }
}

/// The sign of a polynomial on a region.
///
/// ```
/// use ratpoly::{Budget, Order, Polynomial, Region, RegionSign, Ring, sign_on};
/// # fn main() -> Result<(), ratpoly::Error> {
/// let ring = Ring::new(["x", "y"], Order::Lex)?;
/// let orthant = Region::positive_orthant(2);
/// let sign = |text| sign_on(&Polynomial::parse(ring, text)?, &orthant, &Budget::default());
/// assert_eq!(sign("x^2 - x*y + y^2")?, RegionSign::Positive);
/// assert!(matches!(sign("x^2 - 3*x*y + y^2")?, RegionSign::Changes { .. }));
/// # Ok(())
/// # }
/// ```
pub fn sign_on(f: &Polynomial, region: &Region, budget: &Budget) -> Result<RegionSign, Error> {
    let expected = f.ring().len();
    if region.intervals.len() != expected {
        return Err(Error::WrongLength {
            expected,
            found: region.intervals.len(),
        });
    }
    let occurring = f.variables_occurring();
    let line = (Bound::NegativeInfinity, Bound::PositiveInfinity);
    let lines = occurring.iter().copied();
    let lines: Vec<usize> = lines.filter(|&i| region.intervals[i] == line).collect();
    if let [first, others @ ..] = &lines[..] {
        // Each line makes three parts of the region: that is dear where a few points tell.
        if !others.is_empty()
            && let Some(found) = change_across_zero(f, region, &lines, budget)
        {
            return Ok(found);
        }
        return sign_across_zero(f, region, *first, budget);
    }
    let mut g = f.clone();
    let mut maps = Vec::with_capacity(expected);
    for (i, (low, high)) in region.intervals.iter().enumerate() {
        let map = Moebius::onto(low, high);
        if occurring.contains(&i) {
            g = map.apply(&g, i, budget)?;
        }
        maps.push(map);
    }
    let back = |point: Vec<BigRational>| -> Vec<BigRational> {
        maps.iter()
            .zip(point)
            .map(|(map, t)| map.value(&t))
            .collect()
    };
    Ok(match orthant::decide(&g, orthant::DEPTH, budget)? {
        RegionSign::Changes { positive, negative } => RegionSign::Changes {
            positive: back(positive),
            negative: back(negative),
        },
        other => other,
    })
}

/// The sign of a rational function on a region in which its denominator does not vanish; where it does,
/// or may do so, [`RegionSign::Undecided`].
pub fn sign_of_quotient_on(
    f: &RationalFunction,
    region: &Region,
    budget: &Budget,
) -> Result<RegionSign, Error> {
    let numerator = sign_on(f.numerator(), region, budget)?;
    Ok(match sign_on(f.denominator(), region, budget)? {
        RegionSign::Positive => numerator,
        RegionSign::Negative => numerator.negated(),
        _ => RegionSign::Undecided,
    })
}

/// How many parts of a region with several lines are looked at by points, and how many points of each.
const PARTS: u64 = 16;
const POINTS: usize = 4;

/// A change of sign that shows at a few points on both sides of zero.
fn change_across_zero(
    f: &Polynomial,
    region: &Region,
    lines: &[usize],
    budget: &Budget,
) -> Option<RegionSign> {
    let (mut positive, mut negative) = (None, None);
    for part in 0..PARTS {
        // Bits of multiples of an odd number: each line is on either side in about half of the parts.
        let sides = part.wrapping_mul(0x9E37_79B9_7F4A_7C15);
        let mut half = region.clone();
        for (bit, &i) in (1..64).rev().zip(lines) {
            half.intervals[i] = match sides >> bit & 1 {
                0 => (Bound::from(0), Bound::PositiveInfinity),
                _ => (Bound::NegativeInfinity, Bound::from(0)),
            };
        }
        for (point, sign) in samples::in_region(f, &half, budget).take(POINTS) {
            match sign {
                std::cmp::Ordering::Greater => positive = Some(point),
                std::cmp::Ordering::Less => negative = Some(point),
                std::cmp::Ordering::Equal => {}
            }
        }
        if let (Some(positive), Some(negative)) = (&positive, &negative) {
            return Some(RegionSign::Changes {
                positive: positive.clone(),
                negative: negative.clone(),
            });
        }
    }
    None
}

/// Splits the whole line of one variable at zero.
fn sign_across_zero(
    f: &Polynomial,
    region: &Region,
    variable: usize,
    budget: &Budget,
) -> Result<RegionSign, Error> {
    let half = |low: Bound, high: Bound| {
        let mut half = region.clone();
        half.intervals[variable] = (low, high);
        half
    };
    let right = half(Bound::from(0), Bound::PositiveInfinity);
    let left = half(Bound::NegativeInfinity, Bound::from(0));
    let slice = f.substitute(&[(variable, Polynomial::zero(f.ring()))])?;
    // On the slice the variable does not occur; any value of it will do, zero for witnesses.
    let mut on_slice = sign_on(&slice, &right, budget)?;
    if let RegionSign::Changes { positive, negative } = &mut on_slice {
        positive[variable] = BigRational::zero();
        negative[variable] = BigRational::zero();
    }
    let changes = |sign: &RegionSign| matches!(sign, RegionSign::Changes { .. });
    if changes(&on_slice) {
        return Ok(on_slice);
    }
    let on_right = sign_on(f, &right, budget)?;
    if changes(&on_right) {
        return Ok(on_right);
    }
    let parts = [(on_right, right), (sign_on(f, &left, budget)?, left)];
    let mut sum = on_slice;
    for (sign, _) in &parts {
        match sum.union(sign.clone()) {
            Some(union) => sum = union,
            None => {
                // Both halves are open, so each sign is taken inside one of them; which may have it, is known.
                use std::cmp::Ordering::{Greater, Less};
                let find = |wanted: std::cmp::Ordering| {
                    let able = |sign: &RegionSign| match sign {
                        RegionSign::Positive | RegionSign::NonNegative => wanted == Greater,
                        RegionSign::Negative | RegionSign::NonPositive => wanted == Less,
                        _ => false,
                    };
                    parts
                        .iter()
                        .filter(|(sign, _)| able(sign))
                        .find_map(|(_, part)| {
                            samples::in_region(f, part, budget).find(|(_, sign)| *sign == wanted)
                        })
                };
                return Ok(match (find(Greater), find(Less)) {
                    (Some((positive, _)), Some((negative, _))) => {
                        RegionSign::Changes { positive, negative }
                    }
                    _ => RegionSign::Undecided,
                });
            }
        }
    }
    Ok(sum)
}

/// `x = (a + b t) / (c + d t)` with integers and a denominator that is positive for positive `t`.
pub(crate) struct Moebius {
    a: BigInt,
    b: BigInt,
    c: BigInt,
    d: BigInt,
}

impl Moebius {
    /// The map of the positive half-line onto an interval that is not the whole line.
    pub(crate) fn onto(low: &Bound, high: &Bound) -> Self {
        let [a, b, c, d] = match (low, high) {
            (Bound::Finite(x), Bound::Finite(y)) => [
                x.numer() * y.denom(),
                y.numer() * x.denom(),
                x.denom() * y.denom(),
                x.denom() * y.denom(),
            ],
            (Bound::Finite(x), _) => [
                x.numer().clone(),
                x.denom().clone(),
                x.denom().clone(),
                BigInt::zero(),
            ],
            (_, Bound::Finite(y)) => [
                y.numer().clone(),
                -y.denom(),
                y.denom().clone(),
                BigInt::zero(),
            ],
            // The whole line: only for variables that do not occur.
            _ => [BigInt::zero(), BigInt::one(), BigInt::one(), BigInt::zero()],
        };
        Moebius { a, b, c, d }
    }

    pub(crate) fn value(&self, t: &BigRational) -> BigRational {
        // Two quotients in lowest terms; points are taken for each of the variables, many times over.
        allowance::spend(100 + 8 * (t.numer().bits() + t.denom().bits()) / 64);
        (t * &self.b + &self.a) / (t * &self.d + &self.c)
    }

    /// The numerator of `f` at the image, that is, `f` times a positive factor.
    pub(crate) fn apply(
        &self,
        f: &Polynomial,
        variable: usize,
        budget: &Budget,
    ) -> Result<Polynomial, Error> {
        let ring = f.ring();
        let t = Polynomial::variable(ring, variable);
        let linear =
            |p: &BigInt, q: &BigInt| Polynomial::constant(ring, p.clone()) + t.mul_integer(q);
        let (top, bottom) = (linear(&self.a, &self.b), linear(&self.c, &self.d));
        if top == t && bottom.is_one() {
            return Ok(f.clone());
        }
        let mut sum = Polynomial::zero(ring);
        let mut scale = Polynomial::one(ring);
        // Horner's rule, homogenised.
        for c in f.coefficients_in_within(variable, budget)?.iter().rev() {
            sum = sum
                .mul_within(&top, budget)?
                .try_add(&c.mul_within(&scale, budget)?)?;
            scale = scale.mul_within(&bottom, budget)?;
        }
        let content = sum.content();
        if content.is_positive() && !content.is_one() {
            sum = sum.div_integer(&content).expect("the content divides");
        }
        Ok(sum)
    }
}
