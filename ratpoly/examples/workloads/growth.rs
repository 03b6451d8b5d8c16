//! How cost and size grow: chains of masses, and the half car, nested and expanded.

use crate::covariance::{Covariance, Stages, covariance, reduced, residual_vanishes};
use crate::system::{HALF_CAR, System, chain, half_car};
use crate::timing::peak_memory;
use ratpoly::{
    BigInt, BigRational, Budget, Error, Matrix, Order, Polynomial, Ring, hurwitz_cofactors,
};
use std::time::Instant;

/// About the products of coefficients in a second.
const STEPS_PER_SECOND: u64 = 200_000_000;
/// Polynomials longer than this are given up.
const MOST_TERMS: usize = 4_000_000;

/// The upper triangle's terms.
fn size(covariance: &Covariance) -> usize {
    let n = covariance.numerators.rows();
    let upper = (0..n).flat_map(|i| (i..n).map(move |j| (i, j)));
    upper.map(|place| covariance.numerators[place].len()).sum()
}

/// Chains of n = 4, ..., 10 states: time of the covariance over one denominator, sizes, and time of the
/// reduction to lowest terms. Ends at the first that needs more than about a minute.
pub fn run_chains() -> Result<(), String> {
    let minute = || Budget::new(MOST_TERMS, 1 << 20, 60 * STEPS_PER_SECOND);
    println!(
        " n letters   covariance_s    detH_terms   P_terms   residual0   reduced_s  reduced_terms  peak_kB"
    );
    for n in 4..=10 {
        let row = || -> Result<String, Error> {
            let system = chain(n)?;
            let letters = system.ring.len();
            let start = Instant::now();
            let covariance = covariance(&system, &minute(), &mut Stages::default())?;
            let time = start.elapsed().as_secs_f64();
            let vanishes = residual_vanishes(&system, &covariance)?;
            let start = Instant::now();
            let mut terms = 0;
            for entry in reduced(&covariance)? {
                let entry = entry?;
                terms += entry.numerator().len() + entry.denominator().len();
            }
            let reduction = start.elapsed().as_secs_f64();
            Ok(format!(
                "{n:2} {letters:7} {time:14.6} {:13} {:9} {:>11} {reduction:11.6} {:14} {:8}",
                covariance.determinant.len(),
                size(&covariance),
                vanishes,
                terms,
                peak_memory().unwrap_or(0),
            ))
        };
        match row() {
            Ok(row) => println!("{row}"),
            Err(Error::BudgetExceeded(resource)) => {
                println!("{n:2} stopped: {resource:?}");
                break;
            }
            Err(error) => return Err(error.to_string()),
        }
    }
    Ok(())
}

/// The half car: in nested form with all letters, then expanded with more and more of them free.
pub fn run_half_car(seconds: &str) -> Result<(), String> {
    let seconds: u64 = seconds
        .parse()
        .map_err(|_| format!("not a number: {seconds}"))?;
    nested().map_err(|e| e.to_string())?;
    for free in 0..=HALF_CAR.len() {
        let start = Instant::now();
        let budget = Budget::new(
            MOST_TERMS,
            1 << 20,
            seconds.saturating_mul(STEPS_PER_SECOND),
        );
        let sizes = || -> Result<(usize, usize), Error> {
            let mut terms = 0;
            let mut determinant = 0;
            for axle in 0..2 {
                let system = half_car(axle, free)?;
                let covariance = covariance(&system, &budget, &mut Stages::default())?;
                determinant = covariance.determinant.len();
                terms += size(&covariance);
            }
            Ok((determinant, terms))
        };
        match sizes() {
            Ok((determinant, terms)) => println!(
                "halfcar expanded letters={free} ({}) time_s={:.6} detH_terms={determinant} P_terms={terms} peak_kB={}",
                HALF_CAR[..free].join(""),
                start.elapsed().as_secs_f64(),
                peak_memory().unwrap_or(0)
            ),
            Err(Error::BudgetExceeded(resource)) => {
                println!(
                    "halfcar expanded letters={free} stopped after {:.1} s: {resource:?}",
                    start.elapsed().as_secs_f64()
                );
                break;
            }
            Err(error) => return Err(error.to_string()),
        }
        if start.elapsed().as_secs() >= seconds {
            break;
        }
    }
    Ok(())
}

/// The covariance with named intermediates: the characteristic coefficients `a_k` and the vectors `A_m B` in the
/// twelve letters, the cofactors and det H in the `a_k`. Checked at a rational point by the exact residual.
fn nested() -> Result<(), Error> {
    let start = Instant::now();
    let budget = Budget::unlimited();
    let fronts = [half_car(0, 12)?, half_car(1, 12)?];
    let recursion = fronts[0].a.faddeev_le_verrier(&budget)?;
    let n = fronts[0].size();
    let mut vectors: Vec<Vec<Vec<Polynomial>>> = Vec::new();
    for System { ring, b, .. } in &fronts {
        let times = |m: &Matrix<Polynomial>| -> Result<Vec<Polynomial>, Error> {
            (0..n)
                .map(|i| Polynomial::sum_of_products(*ring, m.row(i).iter().zip(b)))
                .collect()
        };
        vectors.push(
            recursion.matrices[..n]
                .iter()
                .map(times)
                .collect::<Result<_, _>>()?,
        );
    }
    let names = Ring::new((0..=n).map(|k| format!("a{k}")), Order::Lex)?;
    let letters: Vec<Polynomial> = (0..=n).map(|k| Polynomial::variable(names, k)).collect();
    let (cofactors, determinant) = hurwitz_cofactors(names, &letters, &budget)?;
    let time = start.elapsed().as_secs_f64();
    let coefficient_terms: usize = recursion.coefficients.iter().map(Polynomial::len).sum();
    let vector_terms: usize = vectors
        .iter()
        .flatten()
        .flatten()
        .map(Polynomial::len)
        .sum();
    let cofactor_terms: usize = cofactors.iter().map(Polynomial::len).sum();

    // Evaluate the nested form at a point, and ask Lyapunov's equation.
    let start = Instant::now();
    let point: Vec<BigInt> = [3, 2, 1, 2, 5, 4, 1, 3, 7, 6, 11, 9]
        .map(BigInt::from)
        .into();
    let at = |f: &Polynomial| f.evaluate_integers(&point);
    let values: Vec<BigInt> = recursion
        .coefficients
        .iter()
        .map(at)
        .collect::<Result<_, _>>()?;
    let h: Vec<BigInt> = cofactors
        .iter()
        .map(|f| f.evaluate_integers(&values))
        .collect::<Result<_, _>>()?;
    let twice: BigInt = determinant.evaluate_integers(&values)? * 2;
    let mut covariance = vec![BigRational::from_integer(0.into()); n * n];
    let mut forcing = covariance.clone();
    for (front, vectors) in fronts.iter().zip(&vectors) {
        let v: Vec<Vec<BigInt>> = vectors
            .iter()
            .map(|row| row.iter().map(at).collect())
            .collect::<Result<_, _>>()?;
        let b: Vec<BigInt> = front.b.iter().map(at).collect::<Result<_, _>>()?;
        for i in 0..n {
            for j in 0..n {
                let mut sum = BigInt::from(0);
                for k in 0..n {
                    for m in (2 * k).saturating_sub(n - 1)..=(2 * k).min(n - 1) {
                        let term = &h[k] * &v[m][i] * &v[2 * k - m][j];
                        if m % 2 == 1 { sum -= term } else { sum += term }
                    }
                }
                covariance[i * n + j] += BigRational::new(sum, twice.clone());
                forcing[i * n + j] += BigRational::from_integer(&b[i] * &b[j]);
            }
        }
    }
    let mut vanishes = true;
    for i in 0..n {
        for j in 0..n {
            let mut sum = forcing[i * n + j].clone();
            for l in 0..n {
                sum += &covariance[l * n + j] * at(&fronts[0].a[(i, l)])?;
                sum += &covariance[i * n + l] * at(&fronts[0].a[(j, l)])?;
            }
            vanishes &= sum == BigRational::from_integer(0.into());
        }
    }
    println!(
        "halfcar nested letters=12 time_s={time:.6} coefficient_terms={coefficient_terms} vector_terms={vector_terms} cofactor_terms={cofactor_terms} detH_terms={} check_s={:.6} resid0_at_point={} peak_kB={}",
        determinant.len(),
        start.elapsed().as_secs_f64(),
        u8::from(vanishes),
        peak_memory().unwrap_or(0)
    );
    Ok(())
}
