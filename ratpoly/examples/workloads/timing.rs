//! Repeated timing by one rule, and the peak memory of the process.

use std::time::Instant;

/// Runs until there are five runs and 1.5 seconds, or three and 20 seconds, or a minute, or 201 runs, and prints a
/// line with the median. `ONCE=1` in the environment stops after the first run.
pub fn report(name: &str, checks: &str, mut run: impl FnMut()) {
    let once = std::env::var_os("ONCE").is_some();
    let mut times: Vec<f64> = Vec::new();
    let mut total = 0.0;
    while times.len() < 201 {
        let start = Instant::now();
        run();
        let time = start.elapsed().as_secs_f64();
        total += time;
        times.push(time);
        let n = times.len();
        if (n >= 5 && total > 1.5) || (n >= 3 && total > 20.0) || total > 60.0 || once {
            break;
        }
    }
    times.sort_by(f64::total_cmp);
    println!(
        "{name} median_s={:.9} min_s={:.9} reps={} {checks} peak_kB={}",
        times[times.len() / 2],
        times[0],
        times.len(),
        peak_memory().map_or("unknown".into(), |kb| kb.to_string()),
    );
}

/// The largest resident size of the process so far in kB, where the system tells.
pub fn peak_memory() -> Option<u64> {
    let status = std::fs::read_to_string("/proc/self/status").ok()?;
    let line = status.lines().find(|line| line.starts_with("VmHWM:"))?;
    line.split_whitespace().nth(1)?.parse().ok()
}
