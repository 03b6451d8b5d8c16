//! The gcd by sparse interpolation of univariate images modulo primes of 62 bits.
//!
//! With a main variable x and γ the gcd of the leading (or the trailing) coefficients in x, the
//! polynomial Γ = (γ / lc G)·G has integer coefficients and a known leading coefficient, so that its
//! images at different points and primes fit together. For a random point β and an α of order 2^k, the
//! images at β·α^(S·j), j = 0, 1, ..., are monic univariate gcds scaled by γ; each coefficient of a power
//! of x runs through a sequence whose least recurrence gives the monomials. S is a mixed radix (Kronecker's
//! substitution) large enough to tell all monomials apart, and β makes the choice generic. The number
//! of images is twice the number of terms of the largest coefficient, instead of the product of degrees.
//! The first prime finds the monomials; further primes, if coefficients need them, take half the images.
//!
//! R. Zippel, *Probabilistic algorithms for sparse polynomials*, 1979; J. Hu and M. Monagan, *A fast parallel
//! sparse polynomial GCD algorithm*, 2016.

use num_bigint::BigInt;
use num_traits::{One, Zero};

use super::images::Images;
use super::view::Views;
use super::{Common, common, common_divisor, common_from_prime, prs};
use crate::budget::Budget;
use crate::error::Error;
use crate::integer_gcd::integer_gcd;
use crate::modular::{ChineseRemainder, PrimeField, two_adic_primes};
use crate::polynomial::Polynomial;

/// How often the search starts afresh before the slow method takes over; once is the rule.
const ATTEMPTS: u64 = 12;

/// The gcd of two polynomials that depend on the same variables, less its integer and monomial
/// content; `None` if that is 1. `bounds` are upper bounds of its degrees in the variables of the view;
/// the first prime is number `first` of the sequence.
pub(super) fn sparse_gcd(
    views: &Views,
    bounds: &[u32],
    first: usize,
    budget: &Budget,
) -> Result<Option<Common>, Error> {
    let plan = Plan::new(views, bounds, budget)?;
    match plan.two_adicity() {
        Some(k) => sparse_gcd_modulo(
            views,
            bounds,
            &plan,
            first,
            two_adic_primes(k).skip(first),
            budget,
        ),
        None => prs::primitive_gcd(views.polynomials(), budget),
    }
}

/// The same with a given sequence of primes.
fn sparse_gcd_modulo(
    views: &Views,
    bounds: &[u32],
    plan: &Plan,
    first: usize,
    primes: impl Iterator<Item = u64>,
    budget: &Budget,
) -> Result<Option<Common>, Error> {
    let mut known: Option<(Support, ChineseRemainder)> = None;
    let mut restarts = 0;
    for (number, p) in primes.enumerate() {
        if restarts > ATTEMPTS {
            break;
        }
        let Some(field) = PrimeField::new(p) else {
            continue;
        };
        let Some(mut images) = Images::new(&field, views, plan, number as u64) else {
            continue;
        };
        let first_look = known.is_none();
        let stable = match &mut known {
            None => {
                let Some((support, residues)) = images.interpolate(bounds, budget)? else {
                    restarts += 1;
                    continue;
                };
                let remainder = ChineseRemainder::new(&field, &residues);
                // If all coefficients are well below the prime, they are hardly residues of larger ones.
                let clearance = 40 / (1 + residues.len() as u64);
                let small = remainder.values().iter().all(|c| c.bits() + clearance < 61);
                known = Some((support, remainder));
                small
            }
            Some((support, remainder)) => match images.interpolate_on(support, budget)? {
                Some(residues) => !remainder.add(&field, &residues),
                None => {
                    // Either this prime or the first one was unlucky: begin again.
                    known = None;
                    restarts += 1;
                    continue;
                }
            },
        };
        let Some((support, remainder)) = &known else {
            continue;
        };
        budget.check_bits(remainder.modulus().bits())?;
        if !stable {
            continue;
        }
        let candidate = plan.candidate(views, support, remainder.values(), bounds, budget)?;
        if let Some(found) = common_divisor(views.polynomials(), &candidate, 0, budget)? {
            return finish(found, views, bounds, first + number + 1, budget);
        }
        // One prime may have shown residues of larger coefficients (2⁶³ is small modulo a prime just below
        // 2⁶²): go on. If even another prime changed nothing, some prime was unlucky: begin again.
        if first_look {
            continue;
        }
        restarts += 1;
        known = None;
    }
    prs::primitive_gcd(views.polynomials(), budget)
}

/// Makes sure that a common divisor is the greatest: by its degrees, or else by what its cofactors
/// have in common modulo later primes.
fn finish(
    found: Common,
    views: &Views,
    bounds: &[u32],
    next: usize,
    budget: &Budget,
) -> Result<Option<Common>, Error> {
    let degrees = found.gcd.degrees();
    let attained = |((&v, &bound), &stride): ((&usize, &u32), &u32)| degrees[v] == bound * stride;
    let mut greatest = Some(found);
    if !views
        .variables
        .iter()
        .zip(bounds)
        .zip(&views.stride)
        .all(attained)
        && let Some(Common {
            gcd,
            quotients: Some((p, q)),
        }) = &greatest
    {
        let rest = common_from_prime(p, q, next, budget)?.gcd;
        if rest.len() > 1 {
            greatest = Some(Common {
                gcd: super::primitive_part(&gcd.try_mul(&rest)?),
                quotients: None,
            });
        }
    }
    Ok(greatest.filter(|common| common.gcd.len() > 1))
}

/// What is decided before any prime is chosen.
pub(super) struct Plan {
    /// The position of the main variable in the view.
    pub(super) main: usize,
    /// Whether γ belongs to the leading coefficient, not to the trailing one.
    pub(super) leading: bool,
    /// The gcd γ of the two extreme coefficients, as a polynomial of the ring.
    pub(super) gamma: Polynomial,
    /// The exponents of γ as seen in the view, term after term.
    pub(super) gamma_exponents: Vec<u32>,
    /// For each variable of the view, one more than the degree bound of Γ; 1 for the main variable.
    pub(super) radix: Vec<u64>,
}

impl Plan {
    fn new(views: &Views, bounds: &[u32], budget: &Budget) -> Result<Plan, Error> {
        // The fewest terms in an extreme coefficient for each power of the main variable.
        let cost = |i: usize, leading: bool| {
            let v = views.variables[i];
            let shapes = [0, 1].map(|which| &views.operands[which].shape);
            let counts = shapes.map(|s| {
                if leading {
                    s[v].high_count
                } else {
                    s[v].low_count
                }
            });
            let terms = counts[0].min(counts[1]);
            u64::from(terms) * 1_000_000 / (u64::from(bounds[i]) + 1)
        };
        let (main, leading) = (0..views.variables.len())
            .flat_map(|i| [(i, true), (i, false)])
            .min_by_key(|&(i, leading)| cost(i, leading))
            .expect("a variable that both contain");
        let [p, q] = [0, 1].map(|which| extreme_coefficient(views, which, main, leading));
        let gamma = common(&p, &q, budget)?.gcd;
        let mut gamma_exponents = Vec::new();
        let mut radix: Vec<u64> = vec![1; bounds.len()];
        for exponents in gamma.exponents_flat().chunks_exact(gamma.ring().len()) {
            for (&v, &stride) in views.variables.iter().zip(&views.stride) {
                gamma_exponents.push(exponents[v] / stride);
            }
        }
        for (i, bound) in bounds.iter().enumerate().filter(|(i, _)| *i != main) {
            let in_gamma = gamma_exponents
                .chunks_exact(bounds.len())
                .map(|e| e[i])
                .max()
                .unwrap_or(0);
            radix[i] = u64::from(*bound) + u64::from(in_gamma) + 1;
        }
        Ok(Plan {
            main,
            leading,
            gamma,
            gamma_exponents,
            radix,
        })
    }

    /// The number of monomials that Γ can have for each power of the main variable.
    pub(super) fn range(&self) -> Option<u64> {
        self.radix
            .iter()
            .try_fold(1u64, |product, &r| product.checked_mul(r))
    }

    /// The 2-adicity wanted of the primes, if such primes exist.
    fn two_adicity(&self) -> Option<u32> {
        let bits = 64 - (self.range()? - 1).leading_zeros();
        [32, 40, 50].into_iter().find(|&k| bits <= k)
    }

    /// The candidate for the gcd from the integer coefficients of Γ.
    fn candidate(
        &self,
        views: &Views,
        support: &Support,
        values: &[BigInt],
        bounds: &[u32],
        budget: &Budget,
    ) -> Result<Polynomial, Error> {
        let ring = self.gamma.ring();
        let (n, main) = (views.variables.len(), views.variables[self.main]);
        let mut content = self.gamma.content();
        for value in values {
            if content.is_one() {
                break;
            }
            content = integer_gcd(&content, value);
        }
        let mut terms = Vec::with_capacity(values.len() + self.gamma.len());
        let extreme = if self.leading { support.degree } else { 0 };
        for (monomial, c) in self.gamma.terms() {
            let mut exponents = monomial.exponents().to_vec();
            exponents[main] = extreme * views.stride[self.main];
            terms.push((exponents, c / &content));
        }
        let mut values = values.iter();
        let mut degrees = vec![0; n];
        for (k, exponents) in support.groups() {
            for &packed in exponents {
                let value = values.next().expect("one value for each monomial");
                if value.is_zero() {
                    continue;
                }
                let mut full = vec![0; ring.len()];
                let mut rest = packed;
                for i in 0..n {
                    let e = if i == self.main {
                        k
                    } else {
                        (rest % self.radix[i]) as u32
                    };
                    rest /= self.radix[i];
                    full[views.variables[i]] = e * views.stride[i];
                    degrees[i] = degrees[i].max(e);
                }
                terms.push((full, value / &content));
            }
        }
        for (i, degree) in degrees.iter_mut().enumerate() {
            let in_gamma = self
                .gamma_exponents
                .chunks_exact(n)
                .map(|e| e[i])
                .max()
                .unwrap_or(0);
            *degree = if i == self.main {
                support.degree
            } else {
                (*degree).max(in_gamma)
            };
        }
        let scaled = Polynomial::from_terms(ring, terms)?;
        // Γ is G itself up to a term unless its degrees pass those of G.
        let scaled = super::primitive_part(&scaled);
        if self.gamma.len() == 1 || degrees.iter().zip(bounds).all(|(d, b)| d <= b) {
            return Ok(scaled);
        }
        let content = scaled.content_in_within(main, budget)?;
        Ok(super::exact(&scaled, &content))
    }
}

/// The leading or trailing coefficient of an operand in a variable of the view, less the operand's
/// monomial content.
fn extreme_coefficient(views: &Views, which: usize, main: usize, leading: bool) -> Polynomial {
    let operand = &views.operands[which];
    let (v, shape) = (views.variables[main], &operand.shape);
    let wanted = if leading { shape[v].high } else { shape[v].low };
    let terms = operand
        .polynomial
        .terms()
        .filter(|(monomial, _)| monomial[v] == wanted)
        .map(|(monomial, c)| {
            let above: Vec<u32> = monomial
                .iter()
                .zip(shape)
                .map(|(e, extent)| e - extent.low)
                .collect();
            (above, c)
        });
    let coefficient =
        Polynomial::from_terms(operand.polynomial.ring(), terms).expect("terms of the ring");
    if leading {
        without(coefficient, v)
    } else {
        coefficient
    }
}

/// The polynomial with a variable set to 1.
fn without(f: Polynomial, variable: usize) -> Polynomial {
    let terms = f.terms().map(|(monomial, c)| {
        let mut exponents = monomial.exponents().to_vec();
        exponents[variable] = 0;
        (exponents, c)
    });
    Polynomial::from_terms(f.ring(), terms).expect("terms of the ring")
}

/// The monomials of Γ, less those of its known extreme coefficient.
pub(super) struct Support {
    /// The degree in the main variable.
    pub(super) degree: u32,
    /// For each power of the main variable, the packed exponents of the other variables.
    pub(super) exponents: Vec<Vec<u64>>,
}

impl Support {
    /// The powers of the main variable with their packed monomials.
    fn groups(&self) -> impl Iterator<Item = (u32, &Vec<u64>)> {
        (0..).zip(&self.exponents)
    }
}
