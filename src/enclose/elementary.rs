//! Elementary functions of numbers with infinitesimals, by the recurrences for their Taylor
//! coefficients (Moore, *Interval Analysis*, 1966, section 11.2; A. Griewank & A. Walther, *Evaluating
//! Derivatives*, 2008, chapter 13).
//!
//! Where a real argument has no real value the conventions are those of the documents: the square
//! root of a negative number is imaginary, its logarithm and its powers with other exponents than
//! integers and halves of integers have no value.

use super::arithmetic::Arithmetic;
use super::failure::{Reason, Undefined};
use super::jet::{Jet, Result};
use crate::real::{Complex, Real};
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{ToPrimitive, Zero};
use std::cmp::Ordering;

/// The largest exponent of a power that is multiplied out.
const LARGEST_EXPONENT: i32 = 10_000;

fn rational(n: usize, d: usize) -> Jet {
    Jet::from(Real::rational(BigRational::new(n.into(), d.into())))
}

impl Arithmetic {
    /// What a function costs beside a multiplication.
    fn spend_function(&self) -> Result<()> {
        self.spend(20)
    }

    /// `(1/k) sum of j u_j y_(k-j)` over j from 1 to k.
    fn chain(&self, u: &[Jet], y: &[Jet], k: usize) -> Result<Jet> {
        let mut sum = Jet::zero();
        for j in 1..=k.min(u.len() - 1) {
            let product = self.multiply(&u[j], &y[k - j])?;
            sum = self.add(&sum, &self.multiply(&product, &rational(j, k))?);
        }
        Ok(sum)
    }

    /// e^x.
    pub fn exponential(&self, x: &Jet) -> Result<Jet> {
        match x {
            Jet::Number(z) => {
                self.spend_function()?;
                Self::found(z.exponential(self.bits), Undefined::Size)
            }
            Jet::Form { .. } => Err(Reason::NotLinear),
            Jet::Series { variable, terms } => {
                let mut y = vec![self.exponential(&terms[0])?];
                for k in 1..=self.orders[*variable] {
                    y.push(self.chain(terms, &y, k)?);
                }
                Ok(Jet::series(*variable, y))
            }
        }
    }

    /// ln x, for numbers off the negative axis.
    pub fn logarithm(&self, x: &Jet) -> Result<Jet> {
        match x {
            Jet::Number(z) => {
                self.spend_function()?;
                if z.is_real() {
                    return match z.re.sign() {
                        Some(Ordering::Greater) => Self::found(
                            z.re.logarithm(self.bits).map(Complex::from),
                            Undefined::Logarithm,
                        ),
                        Some(_) => Err(Reason::Undefined(Undefined::Logarithm)),
                        None => Err(Reason::Imprecise(Undefined::Logarithm)),
                    };
                }
                Self::found(z.logarithm(self.bits), Undefined::Cut)
            }
            Jet::Form { .. } => Err(Reason::NotLinear),
            Jet::Series { variable, terms } => {
                // u_0 y_k = u_k - (1/k) sum of j y_j u_(k-j) over j from 1 to k - 1.
                let mut y = vec![self.logarithm(&terms[0])?];
                for k in 1..=self.orders[*variable] {
                    let mut rest = terms.get(k).cloned().unwrap_or_else(Jet::zero);
                    for j in 1..k {
                        let Some(u) = terms.get(k - j) else { continue };
                        let product = self.multiply(&y[j], u)?;
                        let part = self.multiply(&product, &rational(j, k))?;
                        rest = self.subtract(&rest, &part);
                    }
                    y.push(self.divide(&rest, &terms[0])?);
                }
                Ok(Jet::series(*variable, y))
            }
        }
    }

    /// cos x and sin x, or cosh x and sinh x.
    fn pair(&self, x: &Jet, hyperbolic: bool) -> Result<(Jet, Jet)> {
        match x {
            Jet::Number(z) => {
                self.spend_function()?;
                let both = if hyperbolic {
                    z.hyperbolic(self.bits)
                } else {
                    z.cosine_and_sine(self.bits)
                };
                let (even, odd) = both.ok_or(Reason::Imprecise(Undefined::Size))?;
                Ok((even.into(), odd.into()))
            }
            Jet::Form { .. } => Err(Reason::NotLinear),
            Jet::Series { variable, terms } => {
                let (even, odd) = self.pair(&terms[0], hyperbolic)?;
                let (mut even, mut odd) = (vec![even], vec![odd]);
                for k in 1..=self.orders[*variable] {
                    let slope = self.chain(terms, &odd, k)?;
                    odd.push(self.chain(terms, &even, k)?);
                    even.push(if hyperbolic { slope } else { slope.negated() });
                }
                Ok((Jet::series(*variable, even), Jet::series(*variable, odd)))
            }
        }
    }

    /// cos x and sin x.
    pub fn cosine_and_sine(&self, x: &Jet) -> Result<(Jet, Jet)> {
        self.pair(x, false)
    }

    /// cosh x and sinh x.
    pub fn hyperbolic(&self, x: &Jet) -> Result<(Jet, Jet)> {
        self.pair(x, true)
    }

    /// tan x.
    pub fn tangent(&self, x: &Jet) -> Result<Jet> {
        if let Jet::Number(z) = x
            && z.is_real()
        {
            self.spend_function()?;
            let value = z.re.tangent(self.bits).map(Complex::from);
            return Self::found(value, Undefined::Divisor);
        }
        let (cosine, sine) = self.cosine_and_sine(x)?;
        self.divide(&sine, &cosine)
    }

    /// tanh x.
    pub fn hyperbolic_tangent(&self, x: &Jet) -> Result<Jet> {
        if let Jet::Number(z) = x
            && z.is_real()
        {
            self.spend_function()?;
            let value = z.re.hyperbolic_tangent(self.bits).map(Complex::from);
            return Self::found(value, Undefined::Size);
        }
        let (cosine, sine) = self.hyperbolic(x)?;
        self.divide(&sine, &cosine)
    }

    /// |x|.
    pub fn absolute(&self, x: &Jet) -> Result<Jet> {
        match x {
            Jet::Number(z) => Self::found(z.modulus(self.bits).map(Complex::from), Undefined::Size),
            Jet::Form { .. } => Err(Reason::NotLinear),
            Jet::Series { .. } if x.is_real() => match x.number().re.sign() {
                Some(Ordering::Greater) => Ok(x.clone()),
                Some(Ordering::Less) => Ok(x.negated()),
                Some(Ordering::Equal) => Err(Reason::Undefined(Undefined::Derivative)),
                None => Err(Reason::Imprecise(Undefined::Derivative)),
            },
            Jet::Series { .. } => {
                let square = self.multiply(x, &x.conjugate())?.real_part();
                self.square_root(&square)
            }
        }
    }

    /// The principal square root.
    pub fn square_root(&self, x: &Jet) -> Result<Jet> {
        match x {
            Jet::Number(z) => {
                self.spend_function()?;
                Self::found(z.square_root(self.bits), Undefined::Cut)
            }
            Jet::Form { .. } => Err(Reason::NotLinear),
            Jet::Series { variable, terms } => {
                let half = BigRational::new(1.into(), 2.into());
                let first = self.square_root(&terms[0])?;
                self.power_series(*variable, terms, first, &Jet::from(Real::rational(half)))
            }
        }
    }

    /// The series of u^r from u_0^r: `k u_0 y_k = sum of (r j - (k - j)) u_j y_(k-j)`, j from 1 to k.
    fn power_series(&self, variable: usize, u: &[Jet], first: Jet, r: &Jet) -> Result<Jet> {
        if u[0].is_zero() {
            return Err(Reason::Undefined(Undefined::Derivative));
        }
        let lack = |reason: Reason| reason.renamed(Undefined::Divisor, Undefined::Derivative);
        let mut y = vec![first];
        for k in 1..=self.orders[variable] {
            let mut sum = Jet::zero();
            for j in 1..=k.min(u.len() - 1) {
                let product = self.multiply(&u[j], &y[k - j])?;
                let by_exponent = self.multiply(r, &rational(j, k))?;
                let factor = self.subtract(&by_exponent, &rational(k - j, k));
                sum = self.add(&sum, &self.multiply(&product, &factor)?);
            }
            y.push(self.divide(&sum, &u[0]).map_err(lack)?);
        }
        Ok(Jet::series(variable, y))
    }

    /// `x^y` for any exponent.
    pub fn power(&self, x: &Jet, y: &Jet) -> Result<Jet> {
        if let Some(exponent) = y.as_number().filter(|y| y.is_real())
            && let Some(exponent) = exponent.re.exact()
        {
            if exponent.is_integer() {
                let n = exponent.to_integer().to_i32();
                let n = n.filter(|n| n.abs() <= LARGEST_EXPONENT);
                let n = n.ok_or(Reason::Budget("the exponent of a power"))?;
                // A number that is a zero exponent by chance, not by its print.
                if n == 0 && x.number().may_vanish() {
                    return Err(self.zero_base(x));
                }
                return self.integer_power(x, n);
            }
            if *exponent.denom() == BigInt::from(2) {
                let n = exponent.numer().to_i32();
                let n = n.filter(|n| n.abs() <= LARGEST_EXPONENT);
                let n = n.ok_or(Reason::Budget("the exponent of a power"))?;
                return self.integer_power(&self.square_root(x)?, n);
            }
        }
        if x.is_zero() {
            // A positive power of zero is zero.
            return match y.as_number().filter(|y| y.is_real()).map(|y| y.re.sign()) {
                Some(Some(Ordering::Greater)) => Ok(Jet::zero()),
                Some(None) => Err(Reason::Imprecise(Undefined::Power)),
                _ => Err(Reason::Undefined(Undefined::Power)),
            };
        }
        if let (Jet::Series { variable, terms }, Jet::Number(_)) = (x, y) {
            let first = self.power(&terms[0], y)?;
            return self.power_series(*variable, terms, first, y);
        }
        if let (Jet::Number(z), Some(exponent)) = (x, y.as_number())
            && z.is_real()
            && exponent.is_real()
            && let Some(exponent) = exponent.re.exact()
            && let (Some(n), Some(d)) = (exponent.numer().to_i32(), exponent.denom().to_u32())
            && n.abs() <= LARGEST_EXPONENT
            && d <= 64
            && !exponent.numer().is_zero()
        {
            let sign = z.re.sign();
            return match sign {
                Some(Ordering::Greater) => {
                    self.spend_function()?;
                    let root = z.re.root(d, self.bits).map(Complex::from);
                    let root = Self::found(root, Undefined::Power)?;
                    self.integer_power(&root, n)
                }
                Some(_) => Err(Reason::Undefined(Undefined::Power)),
                None => Err(Reason::Imprecise(Undefined::Power)),
            };
        }
        let lack = |reason: Reason| reason.renamed(Undefined::Logarithm, Undefined::Power);
        let logarithm = self.logarithm(x).map_err(lack)?;
        self.exponential(&self.multiply(&logarithm, y)?)
    }

    fn zero_base(&self, x: &Jet) -> Reason {
        if x.number().is_zero() {
            Reason::Undefined(Undefined::Power)
        } else {
            Reason::Imprecise(Undefined::Power)
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The series of x + e at a number.
    fn at(x: (i64, i64)) -> Jet {
        let x = Jet::from(Real::rational(BigRational::new(x.0.into(), x.1.into())));
        Jet::series(0, vec![x, Jet::integer(1)])
    }

    fn arithmetic() -> Arithmetic {
        let mut arithmetic = Arithmetic::new(128, 1_000_000);
        arithmetic.open(6);
        arithmetic
    }

    fn agree(x: &Jet, y: &Jet) {
        for k in 0..=6 {
            let (x, y) = (x.coefficient(0, k), y.coefficient(0, k));
            assert!(!x.number().is_apart_from(y.number()), "coefficient {k}");
            assert!(
                x.number()
                    .subtract(y.number(), 64)
                    .re
                    .largest(64)
                    .magnitude()
                    < Some(-40)
            );
        }
    }

    #[test]
    fn identities_between_series() {
        let a = arithmetic();
        for x in [(1, 2), (7, 3), (2, 1)] {
            let x = at(x);
            agree(&a.logarithm(&a.exponential(&x).unwrap()).unwrap(), &x);
            agree(&a.exponential(&a.logarithm(&x).unwrap()).unwrap(), &x);
            let root = a.square_root(&x).unwrap();
            agree(&a.multiply(&root, &root).unwrap(), &x);
            let (cosine, sine) = a.cosine_and_sine(&x).unwrap();
            let squares = a.add(
                &a.multiply(&cosine, &cosine).unwrap(),
                &a.multiply(&sine, &sine).unwrap(),
            );
            agree(&squares, &Jet::integer(1));
            let (cosh, sinh) = a.hyperbolic(&x).unwrap();
            agree(&a.add(&cosh, &sinh), &a.exponential(&x).unwrap());
            let third = Jet::from(Real::rational(BigRational::new(1.into(), 3.into())));
            let cube_root = a.power(&x, &third).unwrap();
            agree(&a.integer_power(&cube_root, 3).unwrap(), &x);
            let own = a.power(&x, &x).unwrap();
            let logarithm = a.multiply(&x, &a.logarithm(&x).unwrap()).unwrap();
            agree(&a.logarithm(&own).unwrap(), &logarithm);
            agree(&a.divide(&sine, &cosine).unwrap(), &a.tangent(&x).unwrap());
            agree(&a.absolute(&x.negated()).unwrap(), &x);
        }
    }

    #[test]
    fn what_has_no_value() {
        let a = arithmetic();
        let undefined = |lack| Err(Reason::Undefined(lack));
        assert_eq!(
            a.logarithm(&Jet::integer(-1)),
            undefined(Undefined::Logarithm)
        );
        assert_eq!(a.absolute(&at((0, 1))), undefined(Undefined::Derivative));
        assert_eq!(a.square_root(&at((0, 1))), undefined(Undefined::Derivative));
        let third = Jet::from(Real::rational(BigRational::new(1.into(), 3.into())));
        assert_eq!(
            a.power(&Jet::integer(-8), &third),
            undefined(Undefined::Power)
        );
        assert_eq!(
            a.power(&Jet::zero(), &Jet::zero()),
            undefined(Undefined::Power)
        );
        assert_eq!(
            a.divide(&at((1, 1)), &Jet::zero()),
            undefined(Undefined::Divisor)
        );
        let two = a.power(
            &Jet::integer(-4),
            &Jet::from(Real::rational(BigRational::new(1.into(), 2.into()))),
        );
        assert_eq!(two.unwrap().number().im, Real::integer(2));
    }
}
