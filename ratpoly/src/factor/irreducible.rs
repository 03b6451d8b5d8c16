//! Proofs of irreducibility by univariate images.
//!
//! Let f be primitive in a variable x. A proper factor has a positive degree in x below that of f; at a
//! point and a prime where the leading coefficient in x survives, its image is a divisor of the same
//! degree. So if the degrees of the modular factors of several images have no sum in common but the
//! trivial ones, f is irreducible. For a random f of degree n in x one image succeeds with probability
//! about 1/n, which is why low degrees come first.

use crate::modular::{PowerTable, PrimeField, random_elements};
use crate::polynomial::Polynomial;
use crate::univariate::{factor_modular, modular as dense};

/// Small primes: a power of x costs them few squarings.
const PRIMES: [u64; 8] = [
    1048573, 1048571, 1048559, 1048549, 1048517, 1048507, 1048447, 1048433,
];

/// In how many variables a proof is tried, from the least degree.
pub(super) const VARIABLES: usize = 2;

/// The greatest degree for which this is worth while.
const MAXIMAL_DEGREE: u32 = 24;

/// Whether images in a variable prove f irreducible. It must be primitive in this variable, which occurs;
/// `degrees` are those of f. `false` proves nothing.
pub(super) fn is_proven(f: &Polynomial, degrees: &[u32], v: usize) -> bool {
    if degrees[v] > MAXIMAL_DEGREE {
        return false;
    }
    let exponents = f.exponents_flat();
    let n = degrees[v] as usize;
    let mut possible = vec![true; n + 1];
    let mut splits_always = true;
    for (trial, &p) in PRIMES.iter().enumerate() {
        let field = PrimeField::new(p).expect("an odd prime");
        let point = random_elements(&field, 1000 + trial as u64, degrees.len());
        let powers = PowerTable::new(&field, &point, degrees.iter().copied());
        let mut image = vec![0; n + 1];
        for (residue, term) in f
            .residues(p)
            .into_iter()
            .zip(exponents.chunks_exact(degrees.len()))
        {
            let place = &mut image[term[v] as usize];
            *place = field.add(*place, field.mul(residue, powers.monomial(&field, term)));
        }
        if image[n] == 0 {
            continue;
        }
        if !dense::is_square_free(&field, &image) {
            // Chance has a million to one against it: f has a repeated factor.
            return false;
        }
        let pattern = if n == 2 {
            quadratic_pattern(&field, &image)
        } else {
            factor_modular::degree_pattern(&field, &image)
        };
        splits_always &= pattern.len() > 1;
        let mut sums = vec![false; n + 1];
        sums[0] = true;
        for &d in &pattern {
            for s in (d..=n).rev() {
                sums[s] |= sums[s - d];
            }
        }
        for (possible, sum) in possible.iter_mut().zip(sums) {
            *possible &= sum;
        }
        if possible[1..n].iter().all(|&p| !p) {
            return true;
        }
        // A reducible f splits everywhere: do not insist.
        if trial >= 4 && splits_always && n > 4 {
            return false;
        }
    }
    false
}

/// The degrees of the factors of a square-free quadratic polynomial, by Euler's criterion for the
/// discriminant.
fn quadratic_pattern(field: &PrimeField, f: &[u64]) -> Vec<usize> {
    let four = field.from_u64(4);
    let discriminant = field.mul_sub_mul(f[1], f[1], field.mul(four, f[0]), f[2]);
    let symbol = field.pow(discriminant, (field.modulus() - 1) / 2);
    if symbol == field.one() {
        vec![1, 1]
    } else {
        vec![2]
    }
}
