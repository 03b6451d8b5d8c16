//! Real roots of integer polynomials in one variable: counted by Sturm's theorem, isolated by Descartes'
//! rule, refined by bisection; everything in exact rational numbers.

pub(crate) mod dense;
pub(crate) mod isolate;
mod sturm;

pub use sturm::{Bound, SturmSequence};

use crate::budget::Budget;
use crate::error::Error;
use crate::polynomial::Polynomial;
use num_bigint::BigInt;
use num_integer::Integer as _;
use num_rational::BigRational;
use num_traits::Signed;
use std::cmp::Ordering;
use std::sync::Arc;

/// A real root: the only one of its polynomial in an interval with rational ends.
#[derive(Debug, Clone)]
pub struct RealRoot {
    /// Primitive and square-free, shared by all roots of one polynomial.
    polynomial: Arc<[BigInt]>,
    low: BigRational,
    high: BigRational,
    multiplicity: usize,
}

/// The distinct real roots in ascending order, in disjoint intervals, of a nonzero polynomial in which
/// only this variable occurs.
///
/// ```
/// use ratpoly::{Budget, Order, Polynomial, Ring, real_roots};
/// # fn main() -> Result<(), ratpoly::Error> {
/// let ring = Ring::new(["x"], Order::Lex)?;
/// let f = Polynomial::parse(ring, "(x^2 - 2)*(2*x - 1)^3")?;
/// let roots = real_roots(&f, 0, &Budget::default())?;
/// assert_eq!(roots.len(), 3);
/// assert_eq!(roots[1].multiplicity(), 3);
/// assert_eq!(roots[2].decimal(5), "1.41421");
/// # Ok(())
/// # }
/// ```
pub fn real_roots(
    f: &Polynomial,
    variable: usize,
    budget: &Budget,
) -> Result<Vec<RealRoot>, Error> {
    let full = dense::from_polynomial(f, variable)?;
    if full.is_empty() {
        return Err(Error::Unsupported("every number is a root of zero"));
    }
    let simple: Arc<[BigInt]> = dense::square_free_part(&full).into();
    let mut roots: Vec<RealRoot> = isolate::isolate(&simple, budget)?
        .into_iter()
        .map(|(low, high)| RealRoot {
            polynomial: simple.clone(),
            low,
            high,
            multiplicity: 1,
        })
        .collect();
    // A root of multiplicity m is one of m - 1 further gcds with derivatives.
    let mut rest = dense::gcd(&full, &dense::derivative(&full));
    while rest.len() > 1 {
        let part = dense::square_free_part(&rest);
        for root in &mut roots {
            root.multiplicity += usize::from(root.is_shared_with(&part));
        }
        rest = dense::gcd(&rest, &dense::derivative(&rest));
    }
    Ok(roots)
}

impl RealRoot {
    /// The lower end of the interval, below the root or equal to it.
    pub fn low(&self) -> &BigRational {
        &self.low
    }

    /// The upper end of the interval, above the root or equal to it.
    pub fn high(&self) -> &BigRational {
        &self.high
    }

    /// The root itself, if it was found to be rational. (A rational root may also be known only by its
    /// interval.)
    pub fn exact(&self) -> Option<&BigRational> {
        (self.low == self.high).then_some(&self.low)
    }

    /// How often it is a root.
    pub fn multiplicity(&self) -> usize {
        self.multiplicity
    }

    /// Shrinks the interval until it is shorter than `width`, which must be positive.
    pub fn refine(&mut self, width: &BigRational) -> Result<(), Error> {
        if !width.is_positive() {
            return Err(Error::Unsupported("a width must be positive"));
        }
        let interval = (self.low.clone(), self.high.clone());
        (self.low, self.high) = isolate::refine(&self.polynomial, interval, width);
        Ok(())
    }

    /// Whether the root is below, at or above a rational number.
    pub fn compare(&self, x: &BigRational) -> Ordering {
        if let Some(root) = self.exact() {
            return root.cmp(x);
        }
        if x <= &self.low {
            return Ordering::Greater;
        }
        if x >= &self.high {
            return Ordering::Less;
        }
        let at = dense::sign_at(&self.polynomial, x);
        if at.is_eq() {
            Ordering::Equal
        } else if at == dense::sign_at(&self.polynomial, &self.low) {
            Ordering::Greater
        } else {
            Ordering::Less
        }
    }

    /// The root in decimal notation, cut off (toward zero) after the given number of digits.
    pub fn decimal(&self, digits: u32) -> String {
        let unit = num_traits::pow(BigInt::from(10), digits as usize);
        let interval = (self.low.clone(), self.high.clone());
        let width = BigRational::new(1.into(), unit.clone());
        let (low, high) = isolate::refine(&self.polynomial, interval, &width);
        // An interval lies on one side of zero, and now at most one multiple of the unit lies inside.
        let negative = low.is_negative();
        let (inner, outer) = if negative { (high, low) } else { (low, high) };
        let cut = |x: &BigRational| (x.abs() * &unit).to_integer();
        let (mut digits_of, far) = (cut(&inner), cut(&outer));
        if digits_of != far {
            let sign = if negative { -1 } else { 1 };
            let order = self.compare(&BigRational::new(&far * sign, unit.clone()));
            if order.is_eq() || order.is_lt() == negative {
                digits_of = far;
            }
        }
        let (whole, fraction) = digits_of.div_rem(&unit);
        let sign = if negative { "-" } else { "" };
        match digits as usize {
            0 => format!("{sign}{whole}"),
            d => format!(
                "{sign}{whole}.{fraction:0>d$}",
                fraction = fraction.to_string()
            ),
        }
    }

    /// Whether a square-free divisor of the polynomial has this root.
    fn is_shared_with(&self, part: &[BigInt]) -> bool {
        match self.exact() {
            Some(x) => dense::sign_at(part, x).is_eq(),
            None => dense::sign_at(part, &self.low) != dense::sign_at(part, &self.high),
        }
    }
}
