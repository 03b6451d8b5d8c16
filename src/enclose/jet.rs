//! Numbers with infinitesimals: truncated Taylor series, and linear forms in unknowns.
//!
//! A derivative is computed by adding an infinitesimal to its letter and reading off a coefficient
//! (R. E. Moore, *Interval Analysis*, 1966, chapter 11); derivatives of derivatives have one
//! infinitesimal each, the inner one with the higher number, so that a number is a tower: its
//! coefficients hold only infinitesimals with lower numbers. The unknowns of a linear system take part
//! as linear forms; what is not linear in them is refused, which proves that the rest is.
//!
//! Invariants: a series has at least two terms and its last is not exactly zero; a form has a slope
//! that is not exactly zero.

use super::failure::{Reason, Undefined};
use crate::real::{Complex, Real};
use std::cell::Cell;
use std::collections::BTreeMap;

/// A number in a tower of infinitesimals.
#[derive(Clone, Debug, PartialEq)]
pub enum Jet {
    /// A number without any.
    Number(Complex),
    /// A polynomial in an infinitesimal, lowest power first.
    Series {
        /// Which infinitesimal.
        variable: usize,
        /// The coefficients.
        terms: Vec<Jet>,
    },
    /// A constant and multiples of the unknowns of a linear system.
    Form {
        /// Which system's unknowns, numbered as infinitesimals are.
        variable: usize,
        /// What it is where they are zero.
        constant: Box<Jet>,
        /// The factor of each unknown that occurs.
        slopes: BTreeMap<usize, Jet>,
    },
}

pub(super) type Result<T> = std::result::Result<T, Reason>;

impl From<Complex> for Jet {
    fn from(z: Complex) -> Self {
        Jet::Number(z)
    }
}

impl From<Real> for Jet {
    fn from(x: Real) -> Self {
        Jet::Number(x.into())
    }
}

impl Jet {
    /// An integer.
    pub fn integer(n: i64) -> Self {
        Jet::Number(Complex::integer(n))
    }

    /// Zero.
    pub fn zero() -> Self {
        Jet::integer(0)
    }

    /// The series with these coefficients.
    pub(super) fn series(variable: usize, mut terms: Vec<Jet>) -> Self {
        while terms.len() > 1 && terms.last().is_some_and(Jet::is_zero) {
            terms.pop();
        }
        if terms.len() == 1 {
            return terms.remove(0);
        }
        if terms.is_empty() {
            return Jet::zero();
        }
        Jet::Series { variable, terms }
    }

    pub(super) fn form(variable: usize, constant: Jet, mut slopes: BTreeMap<usize, Jet>) -> Self {
        slopes.retain(|_, slope| !slope.is_zero());
        if slopes.is_empty() {
            return constant;
        }
        Jet::Form {
            variable,
            constant: Box::new(constant),
            slopes,
        }
    }

    /// The highest infinitesimal in it.
    fn variable(&self) -> Option<usize> {
        match self {
            Jet::Number(_) => None,
            Jet::Series { variable, .. } | Jet::Form { variable, .. } => Some(*variable),
        }
    }

    /// Whether it certainly is zero, with all its coefficients.
    pub fn is_zero(&self) -> bool {
        matches!(self, Jet::Number(z) if z.is_zero())
    }

    /// Whether it certainly is one.
    fn is_one(&self) -> bool {
        matches!(self, Jet::Number(z) if z.is_one())
    }

    /// Whether it certainly has no imaginary part.
    pub fn is_real(&self) -> bool {
        match self {
            Jet::Number(z) => z.is_real(),
            Jet::Series { terms, .. } => terms.iter().all(Jet::is_real),
            Jet::Form {
                constant, slopes, ..
            } => constant.is_real() && slopes.values().all(Jet::is_real),
        }
    }

    /// The number that is left where all infinitesimals and unknowns are zero.
    pub fn number(&self) -> &Complex {
        match self {
            Jet::Number(z) => z,
            Jet::Series { terms, .. } => terms[0].number(),
            Jet::Form { constant, .. } => constant.number(),
        }
    }

    /// The number, if there is nothing else.
    pub fn as_number(&self) -> Option<&Complex> {
        match self {
            Jet::Number(z) => Some(z),
            Jet::Series { .. } | Jet::Form { .. } => None,
        }
    }

    /// The coefficient of a power of the highest infinitesimal.
    pub(super) fn coefficient(&self, of: usize, power: usize) -> Jet {
        match self {
            Jet::Series { variable, terms } if *variable == of => {
                terms.get(power).cloned().unwrap_or_else(Jet::zero)
            }
            other if power == 0 => other.clone(),
            _ => Jet::zero(),
        }
    }

    /// The constant and the slopes of a form in these unknowns.
    pub(super) fn parts(&self, of: usize) -> (Jet, BTreeMap<usize, Jet>) {
        match self {
            Jet::Form {
                variable,
                constant,
                slopes,
            } if *variable == of => ((**constant).clone(), slopes.clone()),
            other => (other.clone(), BTreeMap::new()),
        }
    }

    /// The image of every coefficient under a map that is linear over real numbers.
    fn termwise(&self, image: &impl Fn(&Complex) -> Complex) -> Jet {
        match self {
            Jet::Number(z) => Jet::Number(image(z)),
            Jet::Series { variable, terms } => {
                Jet::series(*variable, terms.iter().map(|t| t.termwise(image)).collect())
            }
            Jet::Form {
                variable,
                constant,
                slopes,
            } => Jet::form(
                *variable,
                constant.termwise(image),
                slopes
                    .iter()
                    .map(|(k, s)| (*k, s.termwise(image)))
                    .collect(),
            ),
        }
    }

    /// `-z`.
    #[must_use]
    pub fn negated(&self) -> Jet {
        self.termwise(&Complex::negated)
    }

    /// The conjugate; infinitesimals are real.
    #[must_use]
    pub fn conjugate(&self) -> Jet {
        self.termwise(&Complex::conjugate)
    }

    /// The real part.
    #[must_use]
    pub fn real_part(&self) -> Jet {
        self.termwise(&|z| z.re.clone().into())
    }

    /// The imaginary part.
    #[must_use]
    pub fn imaginary_part(&self) -> Jet {
        self.termwise(&|z| z.im.clone().into())
    }
}

/// How numbers are computed with: to how many digits and orders, and how much work is left.
#[derive(Debug)]
pub struct Arithmetic {
    /// Binary digits that intervals keep.
    pub bits: u32,
    /// The highest power of each infinitesimal that is kept; those of forms are not used.
    pub(super) orders: Vec<usize>,
    /// What is left of the work, in multiplications at the lowest precision.
    work: Cell<u64>,
}

impl Arithmetic {
    /// Arithmetic with so many digits and so many multiplications.
    pub fn new(bits: u32, work: u64) -> Self {
        Arithmetic {
            bits,
            orders: Vec::new(),
            work: Cell::new(work),
        }
    }

    /// Counts work.
    ///
    /// # Errors
    /// When none is left.
    pub(super) fn spend(&self, units: u64) -> Result<()> {
        let each = u64::from(self.bits / 192) + 1;
        match self.work.get().checked_sub(units * each) {
            Some(left) => {
                self.work.set(left);
                Ok(())
            }
            None => {
                self.work.set(0);
                Err(Reason::Budget("operations"))
            }
        }
    }

    /// How many multiplications are left.
    pub fn left(&self) -> u64 {
        self.work.get()
    }

    fn moderate(z: Complex) -> Result<Jet> {
        if z.is_moderate() {
            Ok(Jet::Number(z))
        } else {
            Err(Reason::Imprecise(Undefined::Size))
        }
    }

    /// A number from an operation on numbers that may have none.
    pub(super) fn found(z: Option<Complex>, lack: Undefined) -> Result<Jet> {
        Self::moderate(z.ok_or(Reason::Imprecise(lack))?)
    }

    /// `x + y`.
    pub fn add(&self, x: &Jet, y: &Jet) -> Jet {
        match (x, y) {
            (Jet::Number(a), Jet::Number(b)) => Jet::Number(a.add(b, self.bits)),
            _ => {
                let (upper, lower) = if x.variable() >= y.variable() {
                    (x, y)
                } else {
                    (y, x)
                };
                self.add_lower(upper, lower)
            }
        }
    }

    fn add_lower(&self, upper: &Jet, lower: &Jet) -> Jet {
        match (upper, lower) {
            (
                Jet::Series { variable, terms },
                Jet::Series {
                    variable: other,
                    terms: others,
                },
            ) if variable == other => {
                let length = terms.len().max(others.len());
                let sum = (0..length).map(|k| match (terms.get(k), others.get(k)) {
                    (Some(a), Some(b)) => self.add(a, b),
                    (Some(a), None) | (None, Some(a)) => a.clone(),
                    (None, None) => Jet::zero(),
                });
                Jet::series(*variable, sum.collect())
            }
            (
                Jet::Form {
                    variable,
                    constant,
                    slopes,
                },
                Jet::Form {
                    variable: other,
                    constant: second,
                    slopes: others,
                },
            ) if variable == other => {
                let mut sum = slopes.clone();
                for (k, slope) in others {
                    let whole = match sum.get(k) {
                        Some(own) => self.add(own, slope),
                        None => slope.clone(),
                    };
                    sum.insert(*k, whole);
                }
                Jet::form(*variable, self.add(constant, second), sum)
            }
            (Jet::Series { variable, terms }, lower) => {
                let mut sum = terms.clone();
                sum[0] = self.add(&sum[0], lower);
                Jet::series(*variable, sum)
            }
            (
                Jet::Form {
                    variable,
                    constant,
                    slopes,
                },
                lower,
            ) => Jet::form(*variable, self.add(constant, lower), slopes.clone()),
            (Jet::Number(a), lower) => match lower {
                Jet::Number(b) => Jet::Number(a.add(b, self.bits)),
                higher => self.add_lower(higher, upper),
            },
        }
    }

    /// `x - y`.
    pub fn subtract(&self, x: &Jet, y: &Jet) -> Jet {
        self.add(x, &y.negated())
    }

    /// `x y`.
    pub fn multiply(&self, x: &Jet, y: &Jet) -> Result<Jet> {
        if x.is_zero() || y.is_zero() {
            return Ok(Jet::zero());
        }
        if x.is_one() {
            return Ok(y.clone());
        }
        if y.is_one() {
            return Ok(x.clone());
        }
        match (x, y) {
            (Jet::Number(a), Jet::Number(b)) => {
                self.spend(1)?;
                Self::moderate(a.multiply(b, self.bits))
            }
            _ => {
                let (upper, lower) = if x.variable() >= y.variable() {
                    (x, y)
                } else {
                    (y, x)
                };
                self.multiply_lower(upper, lower)
            }
        }
    }

    fn multiply_lower(&self, upper: &Jet, lower: &Jet) -> Result<Jet> {
        match upper {
            Jet::Series { variable, terms } => match lower {
                Jet::Series {
                    variable: other,
                    terms: others,
                } if variable == other => {
                    let order = self.orders[*variable];
                    let length = (terms.len() + others.len() - 1).min(order + 1);
                    let mut product = Vec::with_capacity(length);
                    for k in 0..length {
                        product.push(self.convolution(terms, others, k)?);
                    }
                    Ok(Jet::series(*variable, product))
                }
                lower => {
                    let product: Result<Vec<Jet>> =
                        terms.iter().map(|t| self.multiply(t, lower)).collect();
                    Ok(Jet::series(*variable, product?))
                }
            },
            Jet::Form {
                variable,
                constant,
                slopes,
            } => {
                if lower.variable() == Some(*variable) {
                    return Err(Reason::NotLinear);
                }
                let mut product = BTreeMap::new();
                for (k, slope) in slopes {
                    product.insert(*k, self.multiply(slope, lower)?);
                }
                Ok(Jet::form(
                    *variable,
                    self.multiply(constant, lower)?,
                    product,
                ))
            }
            Jet::Number(_) => self.multiply(lower, upper),
        }
    }

    /// The k-th coefficient of a product.
    fn convolution(&self, a: &[Jet], b: &[Jet], k: usize) -> Result<Jet> {
        let mut sum = Jet::zero();
        let first = (k + 1).saturating_sub(b.len());
        for j in first..=k.min(a.len() - 1) {
            sum = self.add(&sum, &self.multiply(&a[j], &b[k - j])?);
        }
        Ok(sum)
    }

    /// `x / y`.
    pub fn divide(&self, x: &Jet, y: &Jet) -> Result<Jet> {
        if y.is_one() {
            return Ok(x.clone());
        }
        match y {
            Jet::Number(z) => {
                if z.is_zero() {
                    return Err(Reason::Undefined(Undefined::Divisor));
                }
                match x {
                    Jet::Number(w) => {
                        self.spend(1)?;
                        Self::found(w.divide(z, self.bits), Undefined::Divisor)
                    }
                    Jet::Series { .. } | Jet::Form { .. } => {
                        let inverse = Complex::integer(1).divide(z, self.bits);
                        let inverse = Self::found(inverse, Undefined::Divisor)?;
                        self.multiply(x, &inverse)
                    }
                }
            }
            Jet::Form { .. } => Err(Reason::NotLinear),
            Jet::Series { variable, terms } => {
                if x.variable() > Some(*variable) {
                    let inverse = self.divide(&Jet::integer(1), y)?;
                    return self.multiply(x, &inverse);
                }
                // q_k = (x_k - y_1 q_(k-1) - ... - y_k q_0) / y_0.
                let order = self.orders[*variable];
                let mut quotient: Vec<Jet> = Vec::with_capacity(order + 1);
                for k in 0..=order {
                    let mut rest = x.coefficient(*variable, k);
                    for j in 1..=k.min(terms.len() - 1) {
                        let product = self.multiply(&terms[j], &quotient[k - j])?;
                        rest = self.subtract(&rest, &product);
                    }
                    quotient.push(self.divide(&rest, &terms[0])?);
                }
                Ok(Jet::series(*variable, quotient))
            }
        }
    }

    /// `x^n` for an integer n, with 1 for n = 0.
    pub fn integer_power(&self, x: &Jet, n: i32) -> Result<Jet> {
        if let Jet::Number(z) = x {
            self.spend(u64::from(n.unsigned_abs().checked_ilog2().unwrap_or(0)) + 1)?;
            if n < 0 && z.is_zero() {
                return Err(Reason::Undefined(Undefined::Divisor));
            }
            return Self::found(z.power(n, self.bits), Undefined::Size);
        }
        let mut result = Jet::integer(1);
        let mut square = x.clone();
        let mut exponent = n.unsigned_abs();
        while exponent > 0 {
            if exponent & 1 == 1 {
                result = self.multiply(&result, &square)?;
            }
            exponent >>= 1;
            if exponent > 0 {
                square = self.multiply(&square, &square)?;
            }
        }
        if n < 0 {
            self.divide(&Jet::integer(1), &result)
        } else {
            Ok(result)
        }
    }

    /// `n! x`.
    pub(super) fn times_factorial(&self, x: &Jet, n: usize) -> Result<Jet> {
        let mut product = x.clone();
        for k in 2..=n {
            let factor = Jet::integer(i64::try_from(k).unwrap_or(i64::MAX));
            product = self.multiply(&product, &factor)?;
        }
        Ok(product)
    }

    /// A new infinitesimal with powers up to `order`.
    pub(super) fn open(&mut self, order: usize) -> usize {
        self.orders.push(order);
        self.orders.len() - 1
    }

    /// Gives up the newest infinitesimal.
    pub(super) fn close(&mut self) {
        self.orders.pop();
    }
}
