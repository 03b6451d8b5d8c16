//! Sums, products, quotients and powers of numbers with infinitesimals, to so many digits and within a
//! budget of work.

use super::failure::{Reason, Undefined};
use super::jet::{Jet, Result};
use crate::real::Complex;
use std::cell::Cell;
use std::collections::BTreeMap;

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
        // So that it ends where the user asks for it.
        ratpoly::allowance::spend(units);
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
                Jet::Series { .. } | Jet::Form { .. } => self.add_lower(lower, upper),
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
                Jet::Series { .. } | Jet::Number(_) | Jet::Form { .. } => {
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
