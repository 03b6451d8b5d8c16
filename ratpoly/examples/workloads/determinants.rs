//! W2 and W5: determinants of structured matrices of letters.

use crate::timing::report;
use ratpoly::{
    Budget, Matrix, Order, Polynomial, Ring, hurwitz_cofactors, hurwitz_matrix, toeplitz_matrix,
};
use std::hint::black_box;

const PRIME: u64 = 1_000_000_007;
const PRIMES: [u64; 35] = [
    2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31, 37, 41, 43, 47, 53, 59, 61, 67, 71, 73, 79, 83, 89, 97,
    101, 103, 107, 109, 113, 127, 131, 137, 139, 149,
];

/// The value modulo 10^9 + 7 at the first primes.
fn value(f: &Polynomial) -> u64 {
    f.evaluate_mod(&PRIMES[..f.ring().len()], PRIME)
        .expect("a value for each variable")
}

fn letters(names: impl Iterator<Item = String>) -> Result<(Ring, Vec<Polynomial>), String> {
    let ring = Ring::new(names, Order::Lex).map_err(|e| e.to_string())?;
    let letters = (0..ring.len()).map(|k| Polynomial::variable(ring, k));
    Ok((ring, letters.collect()))
}

/// W2: with `a_0 s^n + ... + a_n` and `b_0, ..., b_(n-1)`, the denominator and numerator of the integral of
/// the spectrum: det H, and det H with its first column replaced.
pub fn run_integral(n: &str) -> Result<(), String> {
    let n: usize = n.parse().map_err(|_| format!("not a number: {n}"))?;
    let names = (0..=n)
        .map(|k| format!("a{k}"))
        .chain((0..n).map(|k| format!("b{k}")));
    let (ring, x) = letters(names)?;
    let (a, b) = x.split_at(n + 1);
    let budget = Budget::unlimited();
    let integral = || -> Result<(Polynomial, Polynomial), ratpoly::Error> {
        let (cofactors, determinant) = hurwitz_cofactors(ring, a, &budget)?;
        let numerator = Polynomial::sum_of_products(ring, b.iter().zip(&cofactors))?;
        Ok((determinant, numerator))
    };
    let (d, m) = integral().map_err(|e| e.to_string())?;
    let checks = format!(
        "terms={} val={} Nterms={} Nval={}",
        d.len(),
        value(&d),
        m.len(),
        value(&m)
    );
    report(&format!("w2-{n} ratpoly"), &checks, || {
        let _ = black_box(integral());
    });
    Ok(())
}

/// W5: the determinant of a Hurwitz (`h`), symmetric (`s`) or general (`t`) Toeplitz matrix.
pub fn run_determinant(which: &str) -> Result<(), String> {
    let unknown = || format!("not one of hN, sN, tN: {which}");
    let n: usize = which
        .get(1..)
        .and_then(|n| n.parse().ok())
        .ok_or_else(unknown)?;
    if n == 0 {
        return Err(unknown());
    }
    let count = match which.as_bytes()[0] {
        b'h' => n + 1,
        b's' => n,
        b't' => 2 * n - 1,
        _ => return Err(unknown()),
    };
    let (ring, x) = letters((0..count).map(|k| format!("x{k}")))?;
    let budget = Budget::unlimited();
    let matrix = match which.as_bytes()[0] {
        b'h' => hurwitz_matrix(ring, &x),
        b's' => {
            let diagonals: Vec<Polynomial> = (0..2 * n - 1)
                .map(|k| x[k.abs_diff(n - 1)].clone())
                .collect();
            toeplitz_matrix(ring, &diagonals)
        }
        // The diagonal i - j = k holds x_(k + n - 1).
        _ => toeplitz_matrix(ring, &x),
    };
    let matrix: Matrix<Polynomial> = matrix.map_err(|e| e.to_string())?;
    let d = matrix.determinant(&budget).map_err(|e| e.to_string())?;
    let checks = format!("terms={} val={}", d.len(), value(&d));
    report(&format!("w5-{which} ratpoly"), &checks, || {
        let _ = black_box(matrix.determinant(&budget));
    });
    Ok(())
}
