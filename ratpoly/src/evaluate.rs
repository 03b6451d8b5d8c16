//! Values of a polynomial at points: over the rationals, the integers, and modulo a word.

use crate::budget::Budget;
use crate::error::Error;
use crate::lowest_terms::reduced;
use crate::polynomial::Polynomial;
use crate::powers::Powers;
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Zero};
use std::collections::BTreeSet;

impl Polynomial {
    /// The value at a rational point, one coordinate for each variable.
    pub fn evaluate(&self, point: &[BigRational]) -> Result<BigRational, Error> {
        self.evaluate_within(point, &Budget::unlimited())
    }

    /// [`evaluate`](Self::evaluate) within a budget: its bits limit every power of a coordinate.
    pub fn evaluate_within(
        &self,
        point: &[BigRational],
        budget: &Budget,
    ) -> Result<BigRational, Error> {
        let (numerator, denominator) = self.fraction_at(point, budget)?;
        Ok(reduced(numerator, denominator))
    }

    /// The value at a rational point as a quotient of integers, not in lowest terms; the denominator is
    /// positive.
    pub(crate) fn fraction_at(
        &self,
        point: &[BigRational],
        budget: &Budget,
    ) -> Result<(BigInt, BigInt), Error> {
        self.check_point(point.len())?;
        // On a common denominator d_i in each variable the sum stays within the integers.
        let variables = self.variables_occurring();
        let exponents = self.exponents_of(&variables);
        let mut denominator = BigInt::one();
        let mut tables = Vec::with_capacity(variables.len());
        for (&i, occurring) in variables.iter().zip(&exponents) {
            let (x, degree) = (&point[i], occurring.last().copied().unwrap_or(0));
            let mut table = powers(x.numer(), occurring, budget)?;
            if !x.denom().is_one() {
                let down = occurring.iter().map(|e| degree - e).chain([degree]);
                let bottom = powers(x.denom(), &down.collect(), budget)?;
                table.scale(|e| bottom.get(degree - e));
                denominator *= bottom.get(degree);
            }
            tables.push(table);
        }
        Ok((self.nested_sum(&variables, &tables), denominator))
    }

    /// The sum of the terms with tabulated powers of the variables that occur. What neighbouring terms
    /// have in common is multiplied once, as in Horner's rule.
    fn nested_sum(&self, variables: &[usize], tables: &[Powers<BigInt>]) -> BigInt {
        // sums[k] adds up terms that agree in the first k variables, without the powers of these.
        let mut sums = vec![BigInt::zero(); variables.len() + 1];
        let mut current = vec![0; variables.len()];
        let fold = |sums: &mut Vec<BigInt>, current: &[u32], agreeing: usize| {
            for k in (agreeing..current.len()).rev() {
                let inner = std::mem::take(&mut sums[k + 1]);
                if !inner.is_zero() {
                    sums[k] += inner * tables[k].get(current[k]);
                }
            }
        };
        self.for_each_term(|exponents, c| {
            let next = variables.iter().map(|&i| exponents[i]);
            let agreeing = next.zip(&current).take_while(|(a, b)| a == *b).count();
            fold(&mut sums, &current, agreeing);
            for (e, &i) in current.iter_mut().zip(variables).skip(agreeing) {
                *e = exponents[i];
            }
            sums[variables.len()] += c.to_big();
        });
        fold(&mut sums, &current, 0);
        std::mem::take(&mut sums[0])
    }

    /// The value at an integer point.
    pub fn evaluate_integers(&self, point: &[BigInt]) -> Result<BigInt, Error> {
        self.check_point(point.len())?;
        let variables = self.variables_occurring();
        let mut tables = Vec::with_capacity(variables.len());
        for (&i, occurring) in variables.iter().zip(self.exponents_of(&variables)) {
            tables.push(powers(&point[i], &occurring, &Budget::unlimited())?);
        }
        Ok(self.nested_sum(&variables, &tables))
    }

    /// The value modulo `modulus` at a point of residues.
    pub fn evaluate_mod(&self, point: &[u64], modulus: u64) -> Result<u64, Error> {
        self.check_point(point.len())?;
        if modulus == 0 {
            return Err(Error::DivisionByZero);
        }
        let mul = |a: u64, b: u64| (u128::from(a) * u128::from(b) % u128::from(modulus)) as u64;
        let mut sum = 0u64;
        self.for_each_term(|exponents, c| {
            let mut value = c.residue(modulus);
            for (&e, &x) in exponents.iter().zip(point) {
                let (mut base, mut e) = (x % modulus, e);
                while e > 0 {
                    if e & 1 == 1 {
                        value = mul(value, base);
                    }
                    base = mul(base, base);
                    e >>= 1;
                }
            }
            sum = ((u128::from(sum) + u128::from(value)) % u128::from(modulus)) as u64;
        });
        Ok(sum)
    }

    fn check_point(&self, found: usize) -> Result<(), Error> {
        let expected = self.ring().len();
        if found == expected {
            Ok(())
        } else {
            Err(Error::WrongLength { expected, found })
        }
    }
}

/// The powers of an integer whose bits the budget allows.
fn powers(
    base: &BigInt,
    exponents: &BTreeSet<u32>,
    budget: &Budget,
) -> Result<Powers<BigInt>, Error> {
    let bits = base.bits().saturating_sub(1);
    let top = exponents.last().copied().unwrap_or(0);
    budget.check_bits(bits.saturating_mul(top.into()))?;
    Powers::new(exponents, |e| Ok(base.pow(e)), |a, b| Ok(a * b))
}
