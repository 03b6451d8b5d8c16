//! Integrals of exponential polynomials: sums of products of powers of the variable, exponentials,
//! cosines and sines of linear arguments.
//!
//! Products with the same exponentials and of bounded degree are mapped into themselves by the
//! derivative, so that an antiderivative is found by undetermined coefficients: one linear system for
//! each product of exponentials. It vanishes at infinity where its exponent tends to minus infinity.

use super::divergence::uncertain;
use super::integral::End;
use super::{FunctionLetter, FunctionTable, Impossible, Possible};
use crate::domain::Symbolic;
use crate::matrix::Matrix;
use crate::theory::linear::{Solution, solve};
use ratpoly::{Polynomial, RationalFunction};
use std::cmp::Ordering;
use std::collections::{BTreeMap, BTreeSet};

/// The most undetermined coefficients.
const MOST_UNKNOWN: usize = 48;

/// An angle linear in the variable: the letters of its cosine and sine, and its rate.
struct Angle {
    cosine: usize,
    sine: usize,
    rate: RationalFunction,
}

/// The functions of the variable in an integrand.
struct Functions {
    /// The letters of exponentials with the rates of their exponents.
    exponentials: Vec<(usize, RationalFunction)>,
    angles: Vec<Angle>,
}

/// `x^power` times for each angle powers of its cosine and sine, the latter at most once.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
struct Product {
    power: u32,
    circular: Vec<(u32, u32)>,
}

/// Coefficients of products.
type Combination = BTreeMap<Product, RationalFunction>;

impl FunctionTable {
    /// The integral of an exponential polynomial; `None` for any other integrand, and where an
    /// oscillation that does not decay is taken to infinity.
    ///
    /// # Errors
    /// [`Impossible::Divergent`] where the integrand grows exponentially.
    pub(super) fn integral_of_exponentials(
        &self,
        integrand: &RationalFunction,
        variable: usize,
        kernels: &[(usize, FunctionLetter)],
        from: &End<RationalFunction>,
        to: &End<RationalFunction>,
    ) -> Possible<Option<RationalFunction>> {
        let Some(functions) = self.linear_functions(variable, kernels)? else {
            return Ok(None);
        };
        let Some(groups) = self.by_exponentials(integrand, variable, &functions) else {
            return Ok(None);
        };
        let rate_of = |exponents: &[i64]| {
            let mut rate = self.integer(0);
            for (k, (_, own)) in exponents.iter().zip(&functions.exponentials) {
                rate = &rate + &(&self.integer(*k) * own);
            }
            self.reduce(rate)
        };
        let rates: Vec<RationalFunction> = groups.keys().map(|e| rate_of(e)).collect();
        // Nothing cancels where powers of a positive variable all have one sign.
        let positive = !matches!(from, End::Below) && self.is_positive(&self.variable(variable));
        let all = || groups.values().flatten();
        let plain = |p: &Product| p.circular.iter().all(|c| *c == (0, 0));
        let alike = positive
            && [Ordering::Less, Ordering::Greater].iter().any(|sign| {
                all().all(|(p, coefficient)| plain(p) && self.sign(coefficient) == Some(*sign))
            });
        let mut sum = self.integer(0);
        for (which, (exponents, given)) in groups.iter().enumerate() {
            let rate = rates[which].clone();
            let Some(found) = self.undetermined(given, &rate, &functions) else {
                return Ok(None);
            };
            for coefficient in found.values() {
                self.refuse_integer_poles(coefficient)?;
            }
            let antiderivative = self.composed(&found, exponents, variable, &functions)?;
            let derivative = self.derivative(&antiderivative, variable)?;
            if derivative != self.composed(given, exponents, variable, &functions)? {
                return Ok(None);
            }
            let infinite = [from, to].into_iter().any(|e| !matches!(e, End::At(_)));
            if infinite && !functions.angles.iter().all(|a| self.is_real(&a.rate)) {
                return Ok(None);
            }
            for (end, sign) in [(to, 1), (from, -1)] {
                let value = match self.at_end(&antiderivative, &rate, variable, end) {
                    // Another group may grow as fast, and the coefficients of this one may vanish.
                    Err(Impossible::Divergent { .. })
                        if !alike
                            && (!self.is_something(given)
                                || rates.iter().enumerate().any(|(other, r)| {
                                    other != which && !self.never_vanishes(&(r - &rate))
                                })) =>
                    {
                        return Err(uncertain());
                    }
                    value => value?,
                };
                let Some(value) = value else {
                    return Ok(None);
                };
                sum = &sum + &(&self.integer(sign) * &value);
            }
        }
        Ok(Some(self.reduce(sum)))
    }

    /// The functions of the variable, if their arguments are linear in it.
    fn linear_functions(
        &self,
        variable: usize,
        kernels: &[(usize, FunctionLetter)],
    ) -> Possible<Option<Functions>> {
        let mut functions = Functions {
            exponentials: Vec::new(),
            angles: Vec::new(),
        };
        for (letter, function) in kernels {
            let Some(u) = function.as_exponential().or(function.as_circular()) else {
                return Ok(None);
            };
            let rate = u.derivative(variable)?;
            let direct = u.numerator().variables_occurring().contains(&variable);
            if !direct || self.letters_behind(&rate).contains(&variable) {
                return Ok(None);
            }
            if function.as_exponential().is_some() {
                functions.exponentials.push((*letter, rate));
                continue;
            }
            let (cosine, sine) = if let FunctionLetter::Sine(_, cosine) = function {
                (*cosine, *letter)
            } else {
                let sine = self.letter(FunctionLetter::Sine(u.clone(), *letter))?;
                (*letter, sine)
            };
            if functions.angles.iter().all(|a| a.cosine != cosine) {
                let angle = Angle { cosine, sine, rate };
                functions.angles.push(angle);
            }
        }
        Ok(Some(functions))
    }

    /// The integrand by the exponents of the exponentials, if it is an exponential polynomial.
    fn by_exponentials(
        &self,
        integrand: &RationalFunction,
        variable: usize,
        functions: &Functions,
    ) -> Option<BTreeMap<Vec<i64>, Combination>> {
        type Parts = BTreeMap<(Vec<i64>, Product), super::TermList>;
        let parts = |p: &Polynomial| -> Parts {
            let mut parts = Parts::new();
            for (monomial, c) in p.terms() {
                let mut rest = monomial.exponents().to_vec();
                let mut take = |letter: usize| std::mem::take(&mut rest[letter]);
                let power = take(variable);
                let exponents = functions.exponentials.iter();
                let exponents = exponents.map(|(l, _)| i64::from(take(*l))).collect();
                let angles = functions.angles.iter();
                let circular = angles.map(|a| (take(a.cosine), take(a.sine))).collect();
                let key = (exponents, Product { power, circular });
                parts.entry(key).or_default().push((rest, c));
            }
            parts
        };
        let mut below = parts(integrand.denominator()).into_iter();
        let ((low, unit), divisor) = below.next()?;
        let plain = unit.power == 0 && unit.circular.iter().all(|c| *c == (0, 0));
        if !plain || below.next().is_some() {
            return None;
        }
        let divisor = Polynomial::from_terms(self.ring, divisor).ok()?;
        let mut groups: BTreeMap<Vec<i64>, Combination> = BTreeMap::new();
        for ((high, product), terms) in parts(integrand.numerator()) {
            if product.circular.iter().any(|(_, sines)| *sines > 1) {
                return None;
            }
            let exponents = high.iter().zip(&low).map(|(h, l)| h - l).collect();
            let coefficient = Polynomial::from_terms(self.ring, terms).ok()?;
            let coefficient = RationalFunction::new(coefficient, divisor.clone()).ok()?;
            let group = groups.entry(exponents).or_default();
            group.insert(product, coefficient);
        }
        Some(groups)
    }

    /// The combination whose derivative, times an exponential of this rate, is the given one.
    fn undetermined(
        &self,
        given: &Combination,
        rate: &RationalFunction,
        functions: &Functions,
    ) -> Option<Combination> {
        let unknowns = unknowns(given, rate.is_zero(), functions.angles.len())?;
        let derivatives: Vec<Combination> = unknowns
            .iter()
            .map(|product| self.derivative_of(product, rate, functions))
            .collect();
        let rows: BTreeSet<&Product> = derivatives
            .iter()
            .flat_map(BTreeMap::keys)
            .chain(given.keys())
            .collect();
        let rows: Vec<&Product> = rows.into_iter().collect();
        let zero = self.integer(0);
        let matrix = Matrix::from_fn(rows.len(), unknowns.len(), |i, j| {
            derivatives[j].get(rows[i]).unwrap_or(&zero).clone()
        });
        let right = rows.iter().map(|r| given.get(r).unwrap_or(&zero).clone());
        let field = Symbolic::with_functions(self.clone());
        match solve(&field, matrix, right.collect()) {
            Solution::Unique { values, .. } => Some(unknowns.into_iter().zip(values).collect()),
            Solution::Underdetermined | Solution::Inconsistent | Solution::TooLarge => None,
        }
    }

    /// The derivative of a product times an exponential, without the exponential.
    fn derivative_of(
        &self,
        product: &Product,
        rate: &RationalFunction,
        functions: &Functions,
    ) -> Combination {
        let mut sum = Combination::new();
        let mut add = |product: Product, coefficient: RationalFunction| {
            let old = sum.remove(&product).unwrap_or_else(|| self.integer(0));
            let new = &old + &coefficient;
            if !new.is_zero() {
                sum.insert(product, new);
            }
        };
        add(product.clone(), rate.clone());
        if product.power > 0 {
            let power = product.power - 1;
            let coefficient = self.integer(product.power.into());
            add(
                Product {
                    power,
                    ..product.clone()
                },
                coefficient,
            );
        }
        for (k, angle) in functions.angles.iter().enumerate() {
            let (p, q) = product.circular[k];
            let mut step = |change: (u32, u32), factor: i64| {
                let mut next = product.clone();
                next.circular[k] = change;
                add(next, &self.integer(factor) * &angle.rate);
            };
            let n = i64::from(p);
            match q {
                0 if p > 0 => step((p - 1, 1), -n),
                0 => {}
                // (c^p s)' = (p + 1) c^(p + 1) - p c^(p - 1), by s^2 = 1 - c^2.
                _ => {
                    step((p + 1, 0), n + 1);
                    if p > 0 {
                        step((p - 1, 0), -n);
                    }
                }
            }
        }
        sum
    }

    /// The element that a combination times powers of the exponentials is.
    fn composed(
        &self,
        combination: &Combination,
        exponents: &[i64],
        variable: usize,
        functions: &Functions,
    ) -> Possible<RationalFunction> {
        let mut sum = self.integer(0);
        for (product, coefficient) in combination {
            let mut term = coefficient.clone();
            let mut times = |letter: usize, power: u32| -> Possible<()> {
                let power = self.power_of(&self.variable(letter), power.into())?;
                term = &term * &power;
                Ok(())
            };
            times(variable, product.power)?;
            for ((p, q), angle) in product.circular.iter().zip(&functions.angles) {
                times(angle.cosine, *p)?;
                times(angle.sine, *q)?;
            }
            sum = &sum + &term;
        }
        for (k, (letter, _)) in exponents.iter().zip(&functions.exponentials) {
            sum = &sum * &self.power_of(&self.variable(*letter), *k)?;
        }
        Ok(self.reduce(sum))
    }

    /// Whether a combination is certainly not zero: one power without a sine, or a polynomial, with a coefficient that
    /// vanishes nowhere.
    fn is_something(&self, given: &Combination) -> bool {
        let plain = |p: &Product| p.circular.iter().all(|c| *c == (0, 0));
        let without_sine = |p: &Product| p.circular.iter().all(|(_, sines)| *sines == 0);
        let independent = given.keys().all(plain) || given.len() == 1;
        independent
            && given.iter().any(|(product, coefficient)| {
                without_sine(product) && self.never_vanishes(coefficient)
            })
    }

    /// The value of an antiderivative with an exponential of this rate at an end.
    fn at_end(
        &self,
        antiderivative: &RationalFunction,
        rate: &RationalFunction,
        variable: usize,
        end: &End<RationalFunction>,
    ) -> Possible<Option<RationalFunction>> {
        let outward = match end {
            End::At(value) => {
                return self
                    .substitute(antiderivative, &[(variable, value.clone())])
                    .map(Some);
            }
            End::Above => self.sign(rate),
            End::Below => self.sign(rate).map(Ordering::reverse),
        };
        match outward {
            Some(Ordering::Less) => Ok(Some(self.integer(0))),
            Some(Ordering::Greater) => {
                Err(Impossible::divergent("its integrand grows exponentially"))
            }
            Some(Ordering::Equal) => Ok(None),
            None => Err(Impossible::unsupported(
                "an integral to infinity over an exponential that may grow",
            )),
        }
    }
}

/// The products that an antiderivative may have; none if they are too many. With the rate zero a
/// power more is needed, and constants make no difference.
fn unknowns(given: &Combination, steady: bool, angles: usize) -> Option<Vec<Product>> {
    let most = given.keys().map(|p| p.power).max().unwrap_or(0);
    let degrees: Vec<u32> = (0..angles)
        .map(|k| {
            let degree = |p: &Product| p.circular[k].0 + p.circular[k].1;
            given.keys().map(degree).max().unwrap_or(0)
        })
        .collect();
    let mut circular: Vec<Vec<(u32, u32)>> = vec![Vec::new()];
    for degree in degrees {
        let choices: Vec<(u32, u32)> = (0..=degree)
            .map(|p| (p, 0))
            .chain((0..degree).map(|p| (p, 1)))
            .collect();
        if circular.len() * choices.len() > MOST_UNKNOWN {
            return None;
        }
        circular = circular
            .iter()
            .flat_map(|head| choices.iter().map(move |c| [&head[..], &[*c]].concat()))
            .collect();
    }
    let powers = most.checked_add(u32::from(steady))?;
    if (powers as usize).saturating_mul(circular.len()) > MOST_UNKNOWN {
        return None;
    }
    let products = (0..=powers).flat_map(|power| {
        circular.iter().map(move |circular| Product {
            power,
            circular: circular.clone(),
        })
    });
    let constant = |p: &Product| p.power == 0 && p.circular.iter().all(|c| *c == (0, 0));
    Some(products.filter(|p| !steady || !constant(p)).collect())
}
