//! Lifting a factorisation from one variable to many, modulo a prime.
//!
//! With the factors known in x, y₁, ..., y_{k-1} at y_k = β_k, ..., the next variable is lifted at a sequence
//! of points of the earlier ones: there the problem has two variables, x and y_k, and is solved densely
//! ([`lift_bivariate`]). For generic β a coefficient of x^a·y_k^b contains only monomials that the coefficient
//! of x^a already had; as many points as monomials give it back. One point more is a test.
//!
//! T. Chen and M. Monagan, *The complexity and parallel implementation of two sparse multivariate Hensel
//! lifting algorithms for polynomial factorization*, 2020; the bivariate step after D. Y. Y. Yun, *The
//! Hensel lemma in algebraic manipulation*, 1974.

use std::collections::BTreeMap;

use crate::budget::Budget;
use crate::error::Error;
use crate::modular::{PrimeField, random_elements, solve_transposed_vandermonde};
use crate::polynomial::Polynomial;
use crate::univariate::hensel::cofactor_inverses;
use crate::univariate::modular as dense;

/// What is lifted: a polynomial, the order of the variables (the main one first), the point for all
/// but the main one, and the leading coefficients of the factors to be found.
pub(super) struct Problem<'a> {
    pub(super) polynomial: &'a Polynomial,
    pub(super) order: &'a [usize],
    pub(super) point: &'a [i64],
    pub(super) leading: &'a [Polynomial],
}

/// A polynomial over the field; exponents in the order of the problem.
pub(super) type Terms = BTreeMap<Vec<u32>, u64>;

/// A polynomial in two variables, as its coefficients of the powers of the second.
type Bivariate = Vec<Vec<u64>>;

/// The factors with the given images (up to units) and leading coefficients, modulo the prime; `None` if
/// there are none or the point was unlucky.
pub(super) fn lift(
    field: &PrimeField,
    problem: &Problem,
    images: &[Vec<u64>],
    budget: &Budget,
) -> Result<Option<Vec<Terms>>, Error> {
    let polynomial = reduced(field, problem.polynomial, problem.order);
    let leading: Vec<Terms> = problem
        .leading
        .iter()
        .map(|c| reduced(field, c, problem.order))
        .collect();
    let point: Vec<u64> = problem.point.iter().map(|&c| field.from_i64(c)).collect();
    let mut factors = Vec::new();
    for (image, leading) in images.iter().zip(&leading) {
        let Some(scale) = image.last().and_then(|&c| field.inverse(c)) else {
            return Ok(None);
        };
        let scale = field.mul(scale, value(field, leading, &point));
        let mut factor = Terms::new();
        for (a, &c) in (0..).zip(image) {
            let mut exponents = vec![0; problem.order.len()];
            exponents[0] = a;
            factor.insert(exponents, field.mul(c, scale));
        }
        factors.push(factor);
    }
    for k in 1..problem.order.len() {
        match lift_variable(field, &polynomial, &leading, &point, factors, k, budget)? {
            Some(lifted) => factors = lifted,
            None => return Ok(None),
        }
    }
    Ok(Some(factors))
}

/// The polynomial over the field.
fn reduced(field: &PrimeField, f: &Polynomial, order: &[usize]) -> Terms {
    let n = f.ring().len();
    let terms = f.exponents_flat();
    let terms = terms.chunks_exact(n).zip(f.residues(field.modulus()));
    terms
        .map(|(e, c)| (order.iter().map(|&v| e[v]).collect(), field.from_u64(c)))
        .filter(|t| t.1 != 0)
        .collect()
}

/// The value at the point for all variables but the main one, which must not occur.
fn value(field: &PrimeField, f: &Terms, point: &[u64]) -> u64 {
    f.iter().fold(0, |sum, (exponents, &c)| {
        let term = exponents[1..]
            .iter()
            .zip(point)
            .fold(c, |c, (&e, &x)| field.mul(c, field.pow(x, e.into())));
        field.add(sum, term)
    })
}

/// The values of the terms of a polynomial along the points θ, θ², θ³, ... of the variables 1..k, with the
/// variables after k fixed: an array of coefficients of x^a·y_k^b for each point.
struct Walk {
    /// Place (a, b), value, ratio.
    terms: Vec<(usize, usize, u64, u64)>,
    degrees: (usize, usize),
}

impl Walk {
    fn new(field: &PrimeField, f: &Terms, k: usize, theta: &[u64], point: &[u64]) -> Walk {
        let mut degrees = (0, 0);
        let terms = f.iter().map(|(e, &c)| {
            let (a, b) = (e[0] as usize, e[k] as usize);
            degrees = (degrees.0.max(a), degrees.1.max(b));
            let power = |c: u64, (&e, &x): (&u32, &u64)| {
                if e == 0 {
                    c
                } else {
                    field.mul(c, field.pow(x, e.into()))
                }
            };
            let ratio = e[1..k].iter().zip(theta).fold(field.one(), power);
            let fixed = e[k + 1..].iter().zip(&point[k..]).fold(c, power);
            (a, b, field.mul(fixed, ratio), ratio)
        });
        let terms = terms.collect();
        Walk { terms, degrees }
    }

    /// The coefficients at the next point: first index b, second index a.
    fn next(&mut self, field: &PrimeField) -> Bivariate {
        let mut array = vec![vec![0; self.degrees.0 + 1]; self.degrees.1 + 1];
        for (a, b, value, ratio) in &mut self.terms {
            let place = &mut array[*b][*a];
            *place = field.add(*place, *value);
            *value = field.mul(*value, *ratio);
        }
        array
    }
}

/// The factors in x, y₁, ..., y_k from those in x, y₁, ..., y_{k-1}.
fn lift_variable(
    field: &PrimeField,
    polynomial: &Terms,
    leading: &[Terms],
    point: &[u64],
    factors: Vec<Terms>,
    k: usize,
    budget: &Budget,
) -> Result<Option<Vec<Terms>>, Error> {
    let theta = random_elements(field, 0x11f7 + k as u64, k - 1);
    // The monomials in y₁, ..., y_{k-1} of each coefficient of a power of x but the leading one.
    let mut supports: Vec<Vec<Vec<Vec<u32>>>> = Vec::new();
    for factor in &factors {
        let degree = factor.keys().map(|e| e[0]).max().unwrap_or(0) as usize;
        let mut support = vec![Vec::new(); degree];
        for e in factor.keys().filter(|e| (e[0] as usize) < degree) {
            support[e[0] as usize].push(e[1..k].to_vec());
        }
        supports.push(support);
    }
    let most = supports.iter().flatten().map(Vec::len).max().unwrap_or(0);
    let count = if k == 1 { 1 } else { most + 1 };
    let mut walk = Walk::new(field, polynomial, k, &theta, point);
    let mut leading_walks: Vec<Walk> = leading
        .iter()
        .map(|c| Walk::new(field, c, k, &theta, point))
        .collect();
    // The factors do not contain y_k yet.
    let mut factor_walks: Vec<Walk> = factors
        .iter()
        .map(|f| Walk::new(field, f, k, &theta, point))
        .collect();
    let mut samples = Vec::with_capacity(count);
    let size = (walk.degrees.0 + 1) * (walk.degrees.1 + 1);
    for _ in 0..count {
        budget.spend((polynomial.len() + size * (walk.degrees.1 + 1)) as u64)?;
        let array = shift(field, walk.next(field), point[k - 1]);
        let images: Vec<Vec<u64>> = factor_walks
            .iter_mut()
            .map(|w| w.next(field).swap_remove(0))
            .collect();
        let leading = leading_walks.iter_mut().map(|w| {
            let shifted = shift(field, w.next(field), point[k - 1]);
            shifted
                .into_iter()
                .map(|coefficient| coefficient[0])
                .collect::<Vec<u64>>()
        });
        let Some(lifted) = lift_bivariate(field, &array, images, &leading.collect::<Vec<_>>())
        else {
            return Ok(None);
        };
        let back = field.neg(point[k - 1]);
        samples.push(
            lifted
                .into_iter()
                .map(|f| shift(field, f, back))
                .collect::<Vec<Bivariate>>(),
        );
    }
    let mut result = Vec::new();
    for (i, (support, leading)) in supports.iter().zip(leading).enumerate() {
        let Some(mut lifted) =
            collect_coefficients(field, &samples, i, support, &theta, (k, point.len() + 1))
        else {
            return Ok(None);
        };
        // The leading coefficient is known; later variables are still at the point.
        for (exponents, &c) in leading {
            let fixed = exponents[k + 1..].iter().zip(&point[k..]);
            let c = fixed.fold(c, |c, (&e, &x)| field.mul(c, field.pow(x, e.into())));
            let mut place = exponents.clone();
            place[0] = support.len() as u32;
            place[k + 1..].fill(0);
            let sum = lifted.entry(place).or_insert(0);
            *sum = field.add(*sum, c);
        }
        lifted.retain(|_, c| *c != 0);
        result.push(lifted);
    }
    Ok(Some(result))
}

/// The terms of factor number `i` below its leading coefficient, from its samples along the walk;
/// `k` is the number of the variable just lifted and `width` the number of all.
fn collect_coefficients(
    field: &PrimeField,
    samples: &[Vec<Bivariate>],
    i: usize,
    support: &[Vec<Vec<u32>>],
    theta: &[u64],
    (k, width): (usize, usize),
) -> Option<Terms> {
    let mut terms = Terms::new();
    let degree = samples
        .iter()
        .map(|sample| sample[i].len())
        .max()
        .unwrap_or(0);
    for (a, monomials) in support.iter().enumerate() {
        let power = |c: u64, (&e, &x): (&u32, &u64)| field.mul(c, field.pow(x, e.into()));
        let nodes: Vec<u64> = monomials
            .iter()
            .map(|m| m.iter().zip(theta).fold(field.one(), power))
            .collect();
        for b in 0..degree {
            let read = |sample: &Vec<Bivariate>| {
                sample[i]
                    .get(b)
                    .and_then(|row| row.get(a))
                    .copied()
                    .unwrap_or(0)
            };
            let values: Vec<u64> = samples.iter().map(read).collect();
            if values.iter().all(|&v| v == 0) {
                continue;
            }
            let coefficients = solve_transposed_vandermonde(field, &nodes, &values)?;
            let test = coefficients.iter().zip(&nodes).fold(0, |sum, (&c, &node)| {
                field.add(sum, field.mul(c, field.pow(node, nodes.len() as u64)))
            });
            if values.get(nodes.len()).is_some_and(|&value| value != test) {
                return None;
            }
            for ((monomial, &node), &c) in monomials.iter().zip(&nodes).zip(&coefficients) {
                // The walk begins at θ, not at 1.
                let mut exponents = vec![0; width];
                exponents[0] = a as u32;
                exponents[1..k].copy_from_slice(monomial);
                exponents[k] = b as u32;
                terms.insert(exponents, field.mul(c, field.inverse(node)?));
            }
        }
    }
    Some(terms)
}

/// f(x, y + c), by Horner's rule in y.
fn shift(field: &PrimeField, mut f: Bivariate, c: u64) -> Bivariate {
    let n = f.len();
    if c == 0 {
        return f;
    }
    for start in 1..n {
        for b in (start - 1..n - 1).rev() {
            let (low, high) = f.split_at_mut(b + 1);
            for (a, &above) in low[b].iter_mut().zip(&high[0]) {
                *a = field.add(*a, field.mul(c, above));
            }
        }
    }
    f
}

/// The factors of f(x, y) with the given images at y = 0 and the given leading coefficients in x, if f
/// has such factors; all as coefficients of the powers of y. The images must have the values of the
/// leading coefficients at 0 as their own.
fn lift_bivariate(
    field: &PrimeField,
    f: &Bivariate,
    images: Vec<Vec<u64>>,
    leading: &[Vec<u64>],
) -> Option<Vec<Bivariate>> {
    let inverses = cofactor_inverses(field, &images)?;
    let n = f[0].len();
    let mut factors: Vec<Bivariate> = images.iter().map(|image| vec![image.clone()]).collect();
    // products[s] is the product of the factors 0..=s, so far as it is known.
    let mut products: Vec<Bivariate> = Vec::new();
    let mut product: Vec<u64> = vec![field.one()];
    for image in &images {
        product = dense::mul(field, &product, image);
        products.push(vec![product.clone()]);
    }
    let mut first = f[0].clone();
    dense::trim(&mut first);
    if first != product {
        return None;
    }
    for t in 1..f.len() {
        for ((factor, image), leading) in factors.iter_mut().zip(&images).zip(leading) {
            let mut coefficient = vec![0; image.len()];
            coefficient[image.len() - 1] = leading.get(t).copied().unwrap_or(0);
            dense::trim(&mut coefficient);
            factor.push(coefficient);
        }
        // The coefficient of y^t in each product.
        for s in 0..factors.len() {
            let coefficient = if s == 0 {
                factors[0][t].clone()
            } else {
                let mut sum = vec![0; n];
                for u in 0..=t {
                    for (sum, c) in sum.iter_mut().zip(dense::mul(
                        field,
                        &products[s - 1][u],
                        &factors[s][t - u],
                    )) {
                        *sum = field.add(*sum, c);
                    }
                }
                dense::trim(&mut sum);
                sum
            };
            products[s].push(coefficient);
        }
        let error = dense::sub(field, &f[t], &products[factors.len() - 1][t]);
        if error.is_empty() {
            continue;
        }
        if error.len() >= n {
            return None;
        }
        let mut change: Vec<u64> = Vec::new();
        for s in 0..factors.len() {
            let delta = dense::rem(field, &dense::mul(field, &error, &inverses[s]), &images[s]);
            factors[s][t] = dense::add(field, &factors[s][t], &delta);
            change = if s == 0 {
                delta
            } else {
                let first = dense::mul(field, &change, &images[s]);
                dense::add(
                    field,
                    &first,
                    &dense::mul(field, &products[s - 1][0], &delta),
                )
            };
            products[s][t] = dense::add(field, &products[s][t], &change);
        }
    }
    // The product is f modulo a power of y; it is f if the degrees add up.
    let degree = |f: &Bivariate| f.iter().rposition(|c| !c.is_empty()).unwrap_or(0);
    (factors.iter().map(degree).sum::<usize>() < f.len()).then_some(factors)
}
