//! What each floating-point method costs, in counted operations and in time, both as a ratio to
//! Bartels-Stewart: the reference car of Schiehlen 2006 and chains of more masses.
//!
//! `cargo bench --bench floating_point`; a plain program, so that no harness is needed.

use nalgebra::{DMatrix, DVector};
use rederive::numeric::quadrature::Limits;
use rederive::numeric::simulation::Simulation;
use rederive::numeric::{LyapunovMethod, NumericError, hurwitz, spectral};
use std::hint::black_box;
use std::time::{Duration, Instant};

/// `bodies` equal masses in a row, the first held to the ground, each spring with a damper and the
/// last mass driven; `n = 2 bodies`.
fn chain(bodies: usize, damping: f64) -> (DMatrix<f64>, DMatrix<f64>) {
    let n = 2 * bodies;
    let mut a = DMatrix::zeros(n, n);
    let mut q = DMatrix::zeros(n, n);
    for i in 0..bodies {
        a[(i, bodies + i)] = 1.0;
        for (block, factor) in [(0, 1.0), (bodies, damping)] {
            let springs = if i + 1 < bodies { 2.0 } else { 1.0 };
            a[(bodies + i, block + i)] = -springs * factor;
            if i > 0 {
                a[(bodies + i, block + i - 1)] = factor;
            }
            if i + 1 < bodies {
                a[(bodies + i, block + i + 1)] = factor;
            }
        }
    }
    q[(n - 1, n - 1)] = 1.0;
    (a, q)
}

/// The shortest of several means, which disturbances can only lengthen.
fn time(
    mut run: impl FnMut() -> Result<u64, NumericError>,
) -> Result<(Duration, u64), NumericError> {
    let started = Instant::now();
    let operations = run()?;
    let repeats = (Duration::from_millis(20).as_nanos() / started.elapsed().as_nanos().max(1))
        .clamp(1, 10_000) as u32;
    let mut best = Duration::MAX;
    for _ in 0..5 {
        let started = Instant::now();
        for _ in 0..repeats {
            black_box(run()?);
        }
        best = best.min(started.elapsed() / repeats);
    }
    Ok((best, operations))
}

fn main() -> Result<(), NumericError> {
    for (bodies, damping) in [(2, 0.3), (2, 1e-6), (3, 0.3), (6, 0.3)] {
        let (a, q) = chain(bodies, damping);
        let n = a.nrows();
        let c = DVector::from_fn(n, |i, _| if i == n - 1 { 1.0 } else { 0.0 });
        let reference = time(|| Ok(LyapunovMethod::BartelsStewart.solve(&a, &q)?.operations))?;
        println!(
            "n = {n}, damping {damping}: Bartels-Stewart {:?}",
            reference.0
        );
        let mut rows = Vec::new();
        for method in LyapunovMethod::ALL {
            let measured = time(|| Ok(method.solve(&a, &q)?.operations))?;
            rows.push((format!("{method:?}"), measured));
        }
        let formula = time(|| Ok(hurwitz::variance(&a, &q, &c)?.operations))?;
        rows.push(("Hurwitz formula".into(), formula));
        let integral = time(|| {
            Ok(spectral::variance(&a, &q, &c, Limits::default())?
                .0
                .operations)
        })?;
        rows.push(("spectral integral".into(), integral));
        let simulation = Simulation::of(&a, 100_000, 1)?;
        let simulated = time(|| Ok(simulation.run(&a, &q)?.operations))?;
        rows.push(("simulation, 100000 steps".into(), simulated));
        for (name, (duration, operations)) in rows {
            println!(
                "  {name:<26} operations x {:>10.2}   time x {:>10.2}",
                operations as f64 / reference.1 as f64,
                duration.as_secs_f64() / reference.0.as_secs_f64()
            );
        }
    }
    Ok(())
}
