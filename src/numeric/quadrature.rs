//! Globally adaptive Gauss-Kronrod quadrature.
//!
//! Each interval is measured with the 15-point Kronrod extension of the 7-point Gauss rule; the
//! interval with the largest error estimate is halved until the sum of the estimates meets the
//! tolerance (Piessens, de Doncker-Kapenga, Ueberhuber & Kahaner, *QUADPACK*, 1983, routine QAG
//! and its error estimate; nodes from Kronrod 1965). A half axis is mapped to the unit interval.

use super::NumericError;

/// Positive nodes of the 15-point Kronrod rule on [-1, 1]; the odd-numbered ones (from 0) and the
/// centre are the nodes of the 7-point Gauss rule.
const NODES: [f64; 7] = [
    0.991_455_371_120_812_6,
    0.949_107_912_342_758_5,
    0.864_864_423_359_769_1,
    0.741_531_185_599_394_4,
    0.586_087_235_467_691_1,
    0.405_845_151_377_397_2,
    0.207_784_955_007_898_47,
];
const KRONROD_WEIGHTS: [f64; 7] = [
    0.022_935_322_010_529_224,
    0.063_092_092_629_978_56,
    0.104_790_010_322_250_19,
    0.140_653_259_715_525_92,
    0.169_004_726_639_267_9,
    0.190_350_578_064_785_4,
    0.204_432_940_075_298_9,
];
const KRONROD_CENTRE: f64 = 0.209_482_141_084_727_82;
const GAUSS_WEIGHTS: [f64; 3] = [
    0.129_484_966_168_869_7,
    0.279_705_391_489_276_64,
    0.381_830_050_505_118_9,
];
const GAUSS_CENTRE: f64 = 0.417_959_183_673_469_4;
const POINTS: usize = 15;
/// Halvings that may leave value and error as they were before rounding is held to be the cause
/// (QUADPACK's test, with a larger count).
const FRUITLESS: usize = 20;

/// When to stop.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Limits {
    /// The error estimate sought, relative to the value.
    pub relative_tolerance: f64,
    /// Evaluations of the integrand allowed.
    pub evaluations: usize,
}

impl Default for Limits {
    fn default() -> Self {
        Limits {
            relative_tolerance: 1e-12,
            evaluations: 50_000,
        }
    }
}

/// An integral with its error estimate.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Quadrature {
    /// The value.
    pub value: f64,
    /// Estimate of the absolute error.
    pub error: f64,
    /// Evaluations of the integrand.
    pub evaluations: usize,
    /// Why it ended.
    pub end: End,
}

/// Why a quadrature ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum End {
    /// The error estimate meets the tolerance.
    Tolerance,
    /// Halving no longer lowers the error estimate: what is left is rounding in the integrand.
    Rounding,
}

/// One interval with its contribution.
#[derive(Clone, Copy)]
struct Piece {
    from: f64,
    to: f64,
    value: f64,
    error: f64,
    /// Halving cannot improve it: its error is rounding, or no double lies inside.
    settled: bool,
}

/// The integral of `f` over the intervals between neighbours in `points` (finite, increasing).
///
/// Points of difficulty (peaks, kinks) belong among them; `f` is never evaluated at them.
/// [`NumericError::Tolerance`] with the best value when the limit is reached first.
pub fn integrate(
    f: &mut impl FnMut(f64) -> Result<f64, NumericError>,
    points: &[f64],
    limits: Limits,
) -> Result<Quadrature, NumericError> {
    let increasing = points.windows(2).all(|pair| pair[0] < pair[1]);
    if points.len() < 2 || !increasing || points.iter().any(|x| !x.is_finite()) {
        return Err(NumericError::Range);
    }
    let mut pieces = Vec::new();
    let mut evaluations = 0;
    let mut fruitless = 0;
    for pair in points.windows(2) {
        pieces.push(measure(f, pair[0], pair[1])?);
        evaluations += POINTS;
    }
    loop {
        let value: f64 = pieces.iter().map(|piece| piece.value).sum();
        let error: f64 = pieces.iter().map(|piece| piece.error).sum();
        let worst = (0..pieces.len())
            .filter(|&i| !pieces[i].settled)
            .max_by(|&i, &j| pieces[i].error.total_cmp(&pieces[j].error));
        let done = |end| Quadrature {
            value,
            error,
            evaluations,
            end,
        };
        if error <= limits.relative_tolerance * value.abs() {
            return Ok(done(End::Tolerance));
        }
        let Some(worst) = worst.filter(|_| fruitless < FRUITLESS) else {
            return Ok(done(End::Rounding));
        };
        if evaluations + 2 * POINTS > limits.evaluations {
            return Err(NumericError::Tolerance {
                value,
                error,
                evaluations,
            });
        }
        let whole = pieces[worst];
        let middle = 0.5 * whole.from + 0.5 * whole.to;
        let halves = [
            measure(f, whole.from, middle)?,
            measure(f, middle, whole.to)?,
        ];
        let sum = halves[0].value + halves[1].value;
        let same = (sum - whole.value).abs() <= 1e-5 * sum.abs();
        if same && halves[0].error + halves[1].error >= 0.99 * whole.error {
            fruitless += 1;
        }
        pieces[worst] = halves[0];
        pieces.push(halves[1]);
        evaluations += 2 * POINTS;
    }
}

/// The integral of `f` over `0 < x < infinity` by `x = scale u / (1 - u)`.
///
/// A rational `f` that falls like `x^-2` becomes a rational function without a pole on [0, 1].
/// `scale > 0` is a typical `x`; `points` are difficult places on the axis, in any order.
pub fn integrate_half_axis(
    f: &mut impl FnMut(f64) -> Result<f64, NumericError>,
    scale: f64,
    points: &[f64],
    limits: Limits,
) -> Result<Quadrature, NumericError> {
    let positive = |x: &f64| x.is_finite() && *x > 0.0;
    if !positive(&scale) || !points.iter().all(positive) {
        return Err(NumericError::Range);
    }
    let mut mapped: Vec<f64> = points.iter().map(|x| x / (x + scale)).collect();
    mapped.extend([0.0, 1.0]);
    mapped.sort_by(f64::total_cmp);
    mapped.dedup();
    integrate(
        &mut |u| {
            let rest = 1.0 - u;
            if rest == 0.0 {
                return Ok(0.0);
            }
            Ok(f(scale * u / rest)? * (scale / rest / rest))
        },
        &mapped,
        limits,
    )
}

fn measure(
    f: &mut impl FnMut(f64) -> Result<f64, NumericError>,
    from: f64,
    to: f64,
) -> Result<Piece, NumericError> {
    let centre = 0.5 * from + 0.5 * to;
    let half = 0.5 * to - 0.5 * from;
    let mut at = |x: f64| match f(x) {
        Ok(value) if !value.is_finite() => Err(NumericError::NotFinite),
        other => other,
    };
    let middle = at(centre)?;
    let mut kronrod = KRONROD_CENTRE * middle;
    let mut gauss = GAUSS_CENTRE * middle;
    let mut absolute = KRONROD_CENTRE * middle.abs();
    let mut values = [(0.0, 0.0); 7];
    for (k, pair) in values.iter_mut().enumerate() {
        *pair = (at(centre - half * NODES[k])?, at(centre + half * NODES[k])?);
        kronrod += KRONROD_WEIGHTS[k] * (pair.0 + pair.1);
        absolute += KRONROD_WEIGHTS[k] * (pair.0.abs() + pair.1.abs());
        if k % 2 == 1 {
            gauss += GAUSS_WEIGHTS[k / 2] * (pair.0 + pair.1);
        }
    }
    // How much f varies about its mean sets the scale of the error (QUADPACK, section 2.2.4.1).
    let mean = 0.5 * kronrod;
    let mut variation = KRONROD_CENTRE * (middle - mean).abs();
    for (weight, (left, right)) in KRONROD_WEIGHTS.iter().zip(values) {
        variation += weight * ((left - mean).abs() + (right - mean).abs());
    }
    variation *= half;
    absolute *= half;
    let mut error = ((kronrod - gauss) * half).abs();
    if variation != 0.0 && error != 0.0 {
        let ratio = 200.0 * error / variation;
        error = variation * (ratio * ratio.sqrt()).min(1.0);
    }
    let rounding = 50.0 * f64::EPSILON * absolute;
    let narrow = !(from < centre && centre < to);
    Ok(Piece {
        from,
        to,
        value: kronrod * half,
        error: error.max(rounding),
        settled: error <= rounding || narrow,
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    fn power(n: i32) -> impl FnMut(f64) -> Result<f64, NumericError> {
        move |x| Ok(x.powi(n))
    }

    #[test]
    fn one_application_is_exact_up_to_degree_22_and_the_gauss_rule_up_to_13() {
        for n in (0..=22).step_by(2) {
            let piece = measure(&mut power(n), -1.0, 1.0).unwrap();
            assert_relative_eq!(piece.value, 2.0 / f64::from(n + 1), max_relative = 4e-15);
            // The estimate hangs on kronrod - gauss, which must vanish for low degrees only.
            assert_eq!(piece.settled, n <= 12, "degree {n}");
        }
        let piece = measure(&mut power(24), -1.0, 1.0).unwrap();
        assert!((piece.value - 2.0 / 25.0).abs() > 1e-12);
    }

    #[test]
    fn lorentz_peak_on_the_half_axis() {
        // Int_0^oo dx / ((x - p)^2 + w^2) = (pi / 2 + atan(p / w)) / w
        for w in [1.0f64, 1e-3, 1e-6] {
            let p = 3.0;
            let result = integrate_half_axis(
                &mut |x| Ok(1.0 / ((x - p) * (x - p) + w * w)),
                1.0,
                &[p],
                Limits::default(),
            )
            .unwrap();
            let exact = (std::f64::consts::FRAC_PI_2 + (p / w).atan()) / w;
            assert_relative_eq!(result.value, exact, max_relative = 1e-11);
            assert!(result.error >= 0.0 && result.error <= 1e-10 * exact);
        }
    }

    #[test]
    fn the_error_estimate_covers_the_error() {
        let result = integrate(
            &mut |x: f64| Ok(x.sqrt()),
            &[0.0, 1.0],
            Limits {
                relative_tolerance: 1e-8,
                evaluations: 10_000,
            },
        )
        .unwrap();
        assert!((result.value - 2.0 / 3.0).abs() <= result.error);
    }

    #[test]
    fn a_divergent_integral_reaches_the_limit() {
        let tail = integrate_half_axis(
            &mut |x| Ok(1.0 / (1.0 + x)),
            1.0,
            &[],
            Limits {
                relative_tolerance: 1e-10,
                evaluations: 2_000,
            },
        );
        assert!(
            matches!(tail, Err(NumericError::Tolerance { evaluations, .. }) if evaluations <= 2_000)
        );
    }

    #[test]
    fn refuses_empty_ranges_and_poles() {
        let limits = Limits::default();
        for points in [
            &[][..],
            &[1.0],
            &[1.0, 1.0],
            &[2.0, 1.0],
            &[0.0, f64::INFINITY],
        ] {
            assert_eq!(
                integrate(&mut power(0), points, limits),
                Err(NumericError::Range)
            );
        }
        for scale in [0.0, -1.0, f64::NAN] {
            assert_eq!(
                integrate_half_axis(&mut power(0), scale, &[], limits),
                Err(NumericError::Range)
            );
        }
        assert_eq!(
            integrate(&mut |x| Ok(1.0 / (x - 0.5)), &[0.0, 1.0], limits),
            Err(NumericError::NotFinite)
        );
    }
}
