//! Proven upper bounds for the degrees of a gcd, from one evaluation.
//!
//! At a point of F_p the operands become, for each variable in turn, univariate polynomials in it. If the
//! leading coefficient of one operand with respect to that variable does not vanish at the point, neither
//! does that of the gcd, which divides it; the image of the gcd therefore keeps its degree, divides the
//! gcd of the images, and the degree of the latter is a bound. One pass over the terms serves all the
//! variables: scaling a variable by its coordinate changes no degree.

use super::view::{PowerTable, Views, random_elements};
use crate::modular::{PrimeField, two_adic_primes};
use crate::univariate::modular as dense;

/// The greatest prime c·2³² + 1 below 2⁶².
const FIELD: PrimeField = match PrimeField::new(4611685941117976577) {
    Some(field) => field,
    None => panic!("an odd number below 2^62"),
};

/// How many points are tried before the degrees of the operands are taken as bounds.
const ATTEMPTS: u64 = 3;

/// An upper bound for the degree of the gcd in each variable of the view, by the prime number `which`.
pub(super) fn degree_bounds(views: &Views, which: usize) -> Vec<u32> {
    if which == 0 {
        return degree_bounds_modulo(&FIELD, views);
    }
    let field = two_adic_primes(32).nth(which).and_then(PrimeField::new);
    degree_bounds_modulo(&field.expect("there are millions of these primes"), views)
}

/// The same with a given prime.
fn degree_bounds_modulo(field: &PrimeField, views: &Views) -> Vec<u32> {
    let n = views.variables.len();
    let mut bounds: Vec<u32> = (0..n)
        .map(|i| views.degrees[0][i].min(views.degrees[1][i]))
        .collect();
    let mut proven = vec![false; n];
    for seed in 0..ATTEMPTS {
        let images = [0, 1].map(|which| univariate_images(field, views, which, seed));
        let mut starts = [0; 2];
        for i in 0..n {
            let mut pair = [0, 1].map(|which| {
                let start = starts[which];
                starts[which] += views.degrees[which][i] as usize + 1;
                images[which][start..starts[which]].to_vec()
            });
            let keeps_degree = pair.iter().any(|image| image.last() != Some(&0));
            if proven[i] || !keeps_degree {
                continue;
            }
            for image in &mut pair {
                dense::trim(image);
            }
            let [f, g] = pair;
            let degree = dense::gcd_up_to_unit(field, f, g).len() - 1;
            bounds[i] = bounds[i].min(degree as u32);
            proven[i] = true;
        }
        if !proven.contains(&false) {
            break;
        }
    }
    bounds
}

/// The images of an operand in each variable, one after another, constant terms first, all up to one
/// common factor that is not zero.
fn univariate_images(field: &PrimeField, views: &Views, which: usize, seed: u64) -> Vec<u64> {
    let n = views.variables.len();
    let degrees = &views.degrees[which];
    let seen = random_elements(field, seed, n);
    let powers = PowerTable::new(field, &seen, degrees.iter().copied());
    // The variables that are not seen.
    let operand = &views.operands[which];
    let width = operand.shape.low.len();
    let others: Vec<usize> = (0..width)
        .filter(|v| operand.shape.varies(*v) && !views.variables.contains(v))
        .collect();
    let coordinates = random_elements(field, seed ^ 0x5eed, width);
    let starts: Vec<usize> = degrees
        .iter()
        .scan(0, |next, &d| {
            let start = *next;
            *next += d as usize + 1;
            Some(start)
        })
        .collect();
    let mut images = vec![0; degrees.iter().map(|&d| d as usize + 1).sum()];
    let full = operand.exponents.chunks_exact(width);
    let residues = operand.polynomial.residues(field.modulus());
    for ((residue, full), exponents) in residues
        .into_iter()
        .zip(full)
        .zip(views.exponents[which].chunks_exact(n))
    {
        // A residue in plain form times an element in Montgomery's: all images shrink by one factor R.
        let mut value = field.mul(residue, powers.monomial(field, exponents));
        for &v in &others {
            match full[v] {
                0 => {}
                1 => value = field.mul(value, coordinates[v]),
                e => value = field.mul(value, field.pow(coordinates[v], u64::from(e))),
            }
        }
        for (&start, &e) in starts.iter().zip(exponents) {
            let image = &mut images[start + e as usize];
            *image = field.add(*image, value);
        }
    }
    images
}
