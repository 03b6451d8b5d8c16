//! What the floating-point methods cost and how many digits they keep.
//!
//! At the points that a document's numeric table names under `methods`, its Lyapunov equation
//! A P + P A^T + Q = 0 is solved by every method of [`crate::numeric`], and the variance c^T P c of one
//! output also by the methods that give nothing else: the Hurwitz formula, adaptive quadrature of
//! the power spectral density, and a seeded simulation in time. Each is compared with the exact value at the
//! very same doubles. Operations are counted by [`crate::numeric::cost`]; times are measured only
//! where they are asked for, as ratios, since they are not the same twice.

use crate::audit::Audit;
use crate::check;
use crate::comparison::{corrections, exact_point};
use crate::evaluate;
use crate::latex::{self, Signature};
use crate::matrix::Matrix;
use crate::model::Node;
use crate::numeric::agreement::Agreement;
use crate::numeric::evaluate::Evaluator;
use crate::numeric::point::Point;
use crate::numeric::quadrature::Limits;
use crate::numeric::simulation::Simulation;
use crate::numeric::{LyapunovMethod, NumericError, hurwitz, spectral};
use crate::span::Span;
use crate::stack::with_deep_stack;
use nalgebra::{DMatrix, DVector};
use num_rational::BigRational;
use num_traits::{Signed, Zero};
use std::time::{Duration, Instant};

/// Samples of the simulation that count.
const SAMPLES: usize = 100_000;
/// How long a method is repeated to measure its time.
const MEASURED: Duration = Duration::from_millis(20);

/// A method of the table.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Method {
    /// One that gives the whole covariance matrix.
    Lyapunov(LyapunovMethod),
    /// The Hurwitz formula.
    Hurwitz,
    /// Adaptive quadrature of the spectral density.
    Quadrature,
    /// A simulation in time by exact discretisation.
    Simulation,
}

impl Method {
    /// All of them, in the order of the table; the first is what ratios refer to.
    pub const ALL: [Method; 7] = [
        Method::Lyapunov(LyapunovMethod::BartelsStewart),
        Method::Lyapunov(LyapunovMethod::Kronecker),
        Method::Lyapunov(LyapunovMethod::Smith),
        Method::Lyapunov(LyapunovMethod::Kreisselmeier),
        Method::Hurwitz,
        Method::Quadrature,
        Method::Simulation,
    ];

    /// Its name.
    pub fn name(self) -> &'static str {
        match self {
            Method::Lyapunov(LyapunovMethod::BartelsStewart) => "Bartels-Stewart (1972)",
            Method::Lyapunov(LyapunovMethod::Kronecker) => "Kronecker",
            Method::Lyapunov(LyapunovMethod::Smith) => "Smith (1968)",
            Method::Lyapunov(LyapunovMethod::Kreisselmeier) => "Kreisselmeier (1972)",
            Method::Hurwitz => "Hurwitz formula",
            Method::Quadrature => "spectral integral",
            Method::Simulation => "simulation in time",
        }
    }
}

/// What a method gave.
#[derive(Clone, Debug, PartialEq)]
pub struct Row {
    /// The method.
    pub method: Method,
    /// Correct digits of the output's variance.
    pub output: Option<f64>,
    /// Correct digits of the worst entry of the covariance, where the method gives the whole of it.
    pub covariance: Option<f64>,
    /// Floating-point operations.
    pub operations: Option<u64>,
    /// Its time by that of the first method, where times are measured.
    pub time: Option<f64>,
    /// Evaluations of an integrand, samples, or why there is no number.
    pub remark: String,
}

/// All methods at one point.
#[derive(Clone, Debug, PartialEq)]
pub struct AtPoint {
    /// The point's name in the document.
    pub point: String,
    /// The order of the system.
    pub order: usize,
    /// The rows, in the order of [`Method::ALL`].
    pub rows: Vec<Row>,
}

/// The methods on one document.
#[derive(Clone, Debug, PartialEq)]
pub struct Methods {
    /// The document's title.
    pub title: String,
    /// Its name.
    pub document: String,
    /// The seed of the simulation.
    pub seed: u64,
    /// The points.
    pub points: Vec<AtPoint>,
}

impl Methods {
    /// Runs the methods; `None` where the document names no points or has no Lyapunov equation.
    pub fn of(audit: &Audit, time: bool) -> Option<Methods> {
        with_deep_stack(|| Methods::compute(audit, time))
    }

    fn compute(audit: &Audit, time: bool) -> Option<Methods> {
        let model = &audit.model;
        let table = model.document.numeric.as_ref()?;
        let output = table.output.as_ref()?;
        let output = latex::parse_expr(&output.text, 0, &Signature::default()).ok()?;
        let mut exact = check::corrected(model, &audit.outcomes);
        let corrections = corrections(&exact);
        let weights = exact.expression(&output).ok()?;
        let abbreviations = exact.abbreviations();
        let mut points = Vec::new();
        for named in Point::of_table(model, table).ok()? {
            if !table.methods.iter().any(|m| m.text == named.name) {
                continue;
            }
            let mut resolver = named.point.clone();
            for (equation, display) in &corrections {
                resolver = resolver.corrected(*equation, display.clone());
            }
            let mut numeric = Evaluator::new(&resolver, LyapunovMethod::BartelsStewart);
            let found = (0..model.systems.len()).find_map(|system| {
                let form = numeric.sylvester_form(system, Span::default()).ok()??;
                form.is_lyapunov().then_some((system, form))
            });
            let Some((system, form)) = found else {
                continue;
            };
            let node = Node::Unknown {
                system,
                position: 0,
            };
            let covariance = exact
                .value_of((node, Vec::new(), 0), Span::default())
                .ok()?;
            let at = exact_point(model, &named.point, &abbreviations);
            let evaluated = |value: &evaluate::Value<_>| {
                value
                    .try_map(|f: &ratpoly::RationalFunction| f.evaluate(&at))
                    .ok()
            };
            let (evaluate::Value::Matrix(exact_p), evaluate::Value::Matrix(exact_c)) =
                (evaluated(&covariance)?, evaluated(&weights)?)
            else {
                continue;
            };
            let c = numeric
                .value(&output)
                .ok()?
                .into_matrix((exact_p.rows(), 1));
            if exact_c.shape() != (exact_p.rows(), 1) || c.shape() != exact_c.shape() {
                continue;
            }
            let case = Case {
                a: form.a,
                q: form.q,
                c: DVector::from_column_slice(c.as_slice()),
                variance: quadratic_form(&exact_c, &exact_p),
                covariance: exact_p,
                seed: table.seed,
            };
            points.push(AtPoint {
                point: named.name.clone(),
                order: case.a.nrows(),
                rows: case.rows(time),
            });
        }
        (!points.is_empty()).then(|| Methods {
            title: model.document.title.clone(),
            document: model.document.name.clone(),
            seed: table.seed,
            points,
        })
    }
}

/// c^T P c.
fn quadratic_form(c: &Matrix<BigRational>, p: &Matrix<BigRational>) -> BigRational {
    let n = p.rows();
    (0..n * n).fold(BigRational::zero(), |sum, k| {
        let (i, j) = (k / n, k % n);
        sum + &c[(i, 0)] * &p[(i, j)] * &c[(j, 0)]
    })
}

/// The equation in doubles, the output's weights, and the exact values.
struct Case {
    a: DMatrix<f64>,
    q: DMatrix<f64>,
    c: DVector<f64>,
    variance: BigRational,
    covariance: Matrix<BigRational>,
    seed: u64,
}

/// What a method returns: the output's variance, the covariance, the operations, a remark.
type Found = (f64, Option<DMatrix<f64>>, u64, String);

impl Case {
    fn rows(&self, time: bool) -> Vec<Row> {
        let mut rows: Vec<Row> = Vec::new();
        let mut reference = None;
        for method in Method::ALL {
            let elapsed = time.then(|| self.time(method));
            reference = reference.or(elapsed);
            let time = elapsed
                .zip(reference)
                .map(|(own, first)| own.as_secs_f64() / first.as_secs_f64().max(1e-12));
            rows.push(match self.run(method) {
                Ok((variance, covariance, operations, remark)) => Row {
                    method,
                    output: Some(Agreement::of(variance, &self.variance).digits()),
                    covariance: covariance.map(|p| self.worst(&p)),
                    operations: Some(operations),
                    time,
                    remark,
                },
                Err(error) => Row {
                    method,
                    output: None,
                    covariance: None,
                    operations: None,
                    time: None,
                    remark: format!("{error:?}"),
                },
            });
        }
        rows
    }

    fn run(&self, method: Method) -> Result<Found, NumericError> {
        let variance = |p: &DMatrix<f64>| (self.c.transpose() * p * &self.c)[0];
        Ok(match method {
            Method::Lyapunov(method) => {
                let solution = method.solve(&self.a, &self.q)?;
                let value = variance(&solution.matrix);
                let operations = solution.operations;
                (value, Some(solution.matrix), operations, String::new())
            }
            Method::Hurwitz => {
                let found = hurwitz::variance(&self.a, &self.q, &self.c)?;
                (found.value, None, found.operations, String::new())
            }
            Method::Quadrature => {
                let (found, quadrature) =
                    spectral::variance(&self.a, &self.q, &self.c, Limits::default())?;
                let remark = format!("{} evaluations", quadrature.evaluations);
                (found.value, None, found.operations, remark)
            }
            Method::Simulation => {
                let estimate =
                    Simulation::of(&self.a, SAMPLES, self.seed)?.run(&self.a, &self.q)?;
                let value = variance(&estimate.covariance);
                let remark = format!("{SAMPLES} samples");
                (
                    value,
                    Some(estimate.covariance),
                    estimate.operations,
                    remark,
                )
            }
        })
    }

    /// The shortest of the repeated runs.
    fn time(&self, method: Method) -> Duration {
        let begin = Instant::now();
        let mut shortest = Duration::MAX;
        loop {
            let start = Instant::now();
            let _ = std::hint::black_box(self.run(method));
            shortest = shortest.min(start.elapsed());
            if begin.elapsed() > MEASURED {
                return shortest;
            }
        }
    }

    /// The digits of the worst entry; one whose exact value is zero is measured by the largest.
    fn worst(&self, computed: &DMatrix<f64>) -> f64 {
        let entries = self.covariance.iter().enumerate();
        let scale = self.covariance.iter().map(|e| e.abs()).max();
        let scale = scale.unwrap_or_default();
        let n = self.covariance.columns();
        entries
            .map(|(k, exact)| {
                let computed = computed[(k / n, k % n)];
                if exact.is_zero() {
                    Agreement::at_scale(computed, exact, &scale).digits()
                } else {
                    Agreement::of(computed, exact).digits()
                }
            })
            .fold(f64::INFINITY, f64::min)
    }
}
