//! Polynomials as maps from exponents to coefficients, for expanding a term apart from the program.

use super::term::{Term, integer, v};
use num_rational::BigRational;
use num_traits::{One, ToPrimitive, Zero};
use std::collections::BTreeMap;

/// A polynomial: exponents of the letters, in the order of their names.
#[derive(Clone, Debug, PartialEq)]
pub struct Polynomial(BTreeMap<Vec<(&'static str, u32)>, BigRational>);

impl Polynomial {
    fn constant(x: BigRational) -> Self {
        let terms = [(Vec::new(), x)].into_iter().filter(|(_, x)| !x.is_zero());
        Polynomial(terms.collect())
    }

    fn plus(&self, other: &Self) -> Self {
        let mut sum = self.0.clone();
        for (m, x) in &other.0 {
            *sum.entry(m.clone()).or_insert_with(BigRational::zero) += x;
        }
        sum.retain(|_, x| !x.is_zero());
        Polynomial(sum)
    }

    fn times(&self, other: &Self) -> Self {
        let mut product = Polynomial(BTreeMap::new());
        for (m, x) in &self.0 {
            for (k, y) in &other.0 {
                let mut exponents: BTreeMap<&'static str, u32> = m.iter().copied().collect();
                for (letter, e) in k {
                    *exponents.entry(letter).or_insert(0) += e;
                }
                let one = BTreeMap::from([(exponents.into_iter().collect(), x * y)]);
                product = product.plus(&Polynomial(one));
            }
        }
        product
    }

    /// How many terms.
    pub fn len(&self) -> usize {
        self.0.len()
    }

    /// As a sum of monomials.
    pub fn term(&self) -> Term {
        let monomials = self.0.iter().map(|(m, x)| {
            let mut factors = Vec::new();
            if !x.is_one() || m.is_empty() {
                factors.push(Term::Number(x.clone()));
            }
            for (letter, e) in m {
                factors.push(match e {
                    1 => v(letter),
                    e => v(letter).pow(i64::from(*e)),
                });
            }
            match factors.len() {
                1 => factors.remove(0),
                _ => Term::Product(factors),
            }
        });
        let mut monomials: Vec<Term> = monomials.collect();
        match monomials.len() {
            0 => Term::Number(integer(0)),
            1 => monomials.remove(0),
            _ => Term::Sum(monomials),
        }
    }
}

/// Numerator and denominator of a term that is rational in its letters.
pub fn fraction(t: &Term) -> Option<(Polynomial, Polynomial)> {
    let one = || Polynomial::constant(BigRational::one());
    Some(match t {
        Term::Number(x) => (Polynomial::constant(x.clone()), one()),
        Term::Letter(name) => {
            let monomial = BTreeMap::from([(vec![(*name, 1)], BigRational::one())]);
            (Polynomial(monomial), one())
        }
        Term::Sum(terms) => {
            let mut total = (Polynomial::constant(BigRational::zero()), one());
            for term in terms {
                let (a, b) = fraction(term)?;
                total = match total.1 == b {
                    true => (total.0.plus(&a), b),
                    false => (
                        total.0.times(&b).plus(&a.times(&total.1)),
                        total.1.times(&b),
                    ),
                };
            }
            total
        }
        Term::Product(factors) => {
            let mut total = (one(), one());
            for factor in factors {
                let (a, b) = fraction(factor)?;
                total = (total.0.times(&a), total.1.times(&b));
            }
            total
        }
        Term::Minus(t) => {
            let (a, b) = fraction(t)?;
            (a.times(&Polynomial::constant(integer(-1))), b)
        }
        Term::Quotient(x, y) => {
            let ((a, b), (c, d)) = (fraction(x)?, fraction(y)?);
            (a.times(&d), b.times(&c))
        }
        Term::Power(base, exponent) => {
            let Term::Number(k) = &**exponent else {
                return None;
            };
            let (a, b) = fraction(base)?;
            let times = k.to_integer().magnitude().to_u32()?;
            let power = |p: &Polynomial| (0..times).fold(one(), |x, _| x.times(p));
            match *k < BigRational::zero() {
                false => (power(&a), power(&b)),
                true => (power(&b), power(&a)),
            }
        }
        Term::Call(..) | Term::Pi | Term::E | Term::I => return None,
    })
}
