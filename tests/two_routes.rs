//! The exact and the floating-point route, which share the printed expressions and nothing else,
//! at the very same points.

use num_rational::BigRational;
use num_traits::Zero;
use rederive::document::Document;
use rederive::domain::Rationals;
use rederive::evaluate;
use rederive::expr::Expr;
use rederive::latex::{Signature, parse_expr};
use rederive::model::Model;
use rederive::numeric::LyapunovMethod;
use rederive::numeric::agreement::{Agreement, Digits};
use rederive::numeric::evaluate::Evaluator;
use rederive::numeric::point::Point;
use rederive::numeric::quadrature::Limits;
use rederive::numeric::simulation::Simulation;
use rederive::numeric::value::{FailureKind, Value};
use rederive::numeric::{hurwitz, spectral};
use rederive::span::Span;

fn quarter_car() -> Document {
    let text = include_str!("../proofs/schiehlen-2006/quarter-car.md");
    // (48) with the dots that it lost: its vector is what is random.
    let states = r"\begin{bmatrix} \dot{z}_A \\ \dot{z}_R \\ \dot{z}_A \\ \dot{z}_R \end{bmatrix}";
    let dots = r"\begin{bmatrix} \dot{z}_A \\ \dot{z}_R \\ \ddot{z}_A \\ \ddot{z}_R \end{bmatrix}";
    assert!(text.contains(states), "(48) is printed differently");
    let mended = text.replace(states, dots);
    Document::parse("quarter-car.md", &mended).expect("the document is sound")
}

fn expression(latex: &str) -> Expr {
    parse_expr(latex, 0, &Signature::default()).expect("an expression")
}

/// The exact value of a scalar at a point.
fn exact(model: &Model, point: &Point<'_>, expr: &Expr) -> BigRational {
    let values = point.exact();
    let letters = model.letters.iter().map(|letter| match letter {
        rederive::model::Letter::Symbol { symbol, order: 0 } => {
            values[*symbol].clone().unwrap_or_else(BigRational::zero)
        }
        _ => BigRational::zero(),
    });
    let world = evaluate::World::new(model, letters.collect());
    let mut evaluator = world.inserting().evaluator(Rationals);
    match evaluator.expression(expr) {
        Ok(evaluate::Value::Scalar(value)) => value,
        other => panic!("no scalar: {other:?}"),
    }
}

fn floating(point: &Point<'_>, method: LyapunovMethod, expr: &Expr) -> Result<f64, FailureKind> {
    match Evaluator::new(point, method).value(expr) {
        Ok(Value::Scalar(value)) => Ok(value),
        Ok(other) => panic!("no scalar: {other:?}"),
        Err(failure) => Err(failure.kind),
    }
}

#[test]
fn every_method_keeps_its_digits_at_ordinary_cars() {
    let document = quarter_car();
    let model = Model::build(&document).expect("a model");
    let table = document.numeric.clone().expect("a numeric table");
    let points = Point::of_table(&model, &table).expect("points");
    assert_eq!(points.len(), table.points.len() + table.samples);
    // Some samples suffice here; the report takes all.
    let samples = points[table.points.len()..].iter().step_by(40);
    let quantities = ["\\sigma_a^2", "\\sigma_f^2", "P_{34}", "P_{11}"].map(expression);
    for sample in samples.chain(&points[..1]) {
        for quantity in &quantities {
            let exact = exact(&model, &sample.point, quantity);
            for method in LyapunovMethod::ALL {
                let computed = floating(&sample.point, method, quantity).expect("a number");
                let digits = Agreement::of(computed, &exact).digits();
                assert!(digits > 7.0, "{} {method:?}: {digits}", sample.name);
            }
        }
    }
}

/// What is exact and printed twice is the same number twice: (67) and (68) against (51) and (52).
#[test]
fn the_final_formulas_need_no_matrix_and_lose_no_digits() {
    let document = quarter_car();
    let model = Model::build(&document).expect("a model");
    for label in ["67", "68"] {
        let equation = model.equation(label).expect("the equation");
        let [left, right] = model.equations[equation].display.clauses[0]
            .chain
            .members
            .as_slice()
        else {
            panic!("two members");
        };
        for named in Point::of_table(&model, document.numeric.as_ref().expect("table"))
            .expect("points")
            .iter()
            .step_by(15)
        {
            let exact = exact(&model, &named.point, left);
            let computed = floating(&named.point, LyapunovMethod::Kronecker, right);
            let digits = Agreement::of(computed.expect("a number"), &exact).digits();
            assert!(digits > 13.0, "({label}) at {}: {digits}", named.name);
        }
    }
}

/// The car with damping 1e-6: floating point loses what the exact value keeps, and the comparison
/// shows it. An agreement that always passes would hide it.
#[test]
fn light_damping_costs_digits_and_the_comparison_sees_it() {
    let document = quarter_car();
    let model = Model::build(&document).expect("a model");
    let points =
        Point::of_table(&model, document.numeric.as_ref().expect("table")).expect("points");
    let light = points
        .iter()
        .find(|p| p.name == "damping-1e-6")
        .expect("the point");
    let variance = expression("\\sigma_a^2");
    let exact = exact(&model, &light.point, &variance);
    let digits = Digits::collect(LyapunovMethod::ALL.map(|method| {
        let computed = floating(&light.point, method, &variance).expect("a number");
        Agreement::of(computed, &exact)
    }));
    let (worst, _) = digits.worst().expect("four methods");
    let (best, _) = digits.best().expect("four methods");
    assert!((3.0..8.0).contains(&worst), "{worst}");
    assert!(best > 12.0, "{best}");
}

/// The printed equation (54) gives the spectral integral, the Hurwitz formula and a simulation
/// their matrices.
#[test]
fn the_printed_lyapunov_equation_drives_the_other_methods() {
    let document = quarter_car();
    let model = Model::build(&document).expect("a model");
    let point = Point::reference(&model);
    let system = model
        .systems
        .iter()
        .position(|s| model.equations[s.equation].label == "54")
        .expect("the system");
    let mut evaluator = Evaluator::new(&point, LyapunovMethod::BartelsStewart);
    let form = evaluator
        .sylvester_form(system, Span::default())
        .expect("no failure")
        .expect("the form A X + X B + Q = 0");
    assert!(form.is_lyapunov());
    let c = evaluator
        .value(&expression("\\mathbf{c}"))
        .expect("a vector")
        .into_matrix((4, 1));
    let c = nalgebra::DVector::from_column_slice(c.as_slice());
    let exact = exact(&model, &point, &expression("\\sigma_a^2"));

    let formula = hurwitz::variance(&form.a, &form.q, &c)
        .expect("a variance")
        .value;
    assert!(Agreement::of(formula, &exact).digits() > 14.0);
    let (integral, quadrature) =
        spectral::variance(&form.a, &form.q, &c, Limits::default()).expect("a variance");
    assert!(Agreement::of(integral.value, &exact).digits() > 11.0);
    assert!(quadrature.error <= 1e-11 * integral.value);
    let estimate = Simulation::of(&form.a, 32_000, 2006)
        .and_then(|simulation| simulation.run(&form.a, &form.q))
        .expect("an estimate");
    let variance = (c.transpose() * &estimate.covariance * &c)[0];
    let digits = Agreement::of(variance, &exact).digits();
    assert!((1.0..6.0).contains(&digits), "{digits}");
}

#[test]
fn the_points_of_a_table_are_reproducible_and_doubles() {
    let document = quarter_car();
    let model = Model::build(&document).expect("a model");
    let table = document.numeric.as_ref().expect("table");
    let points = |table| -> Vec<Vec<Option<f64>>> {
        let points = Point::of_table(&model, table).expect("points");
        points.iter().map(|p| p.point.values().to_vec()).collect()
    };
    assert_eq!(points(table), points(table));
    let mut other = table.clone();
    other.seed += 1;
    assert_ne!(points(table), points(&other));
    // 1e-6 is no double: the point is the nearest one, and so is its exact value.
    let light = &Point::of_table(&model, table).expect("points")[table.points.len() - 1];
    let symbol = model
        .symbols
        .iter()
        .position(|s| s.meaning == "shock absorber");
    let symbol = symbol.expect("d_A");
    assert_eq!(light.point.values()[symbol], Some(1e-6));
    let decimal = BigRational::new(1.into(), 1_000_000.into());
    assert_ne!(light.point.exact()[symbol], Some(decimal));
}

#[test]
fn a_process_has_no_number() {
    let document = quarter_car();
    let model = Model::build(&document).expect("a model");
    let point = Point::reference(&model);
    for latex in ["z_A", "\\dot{z}_A", "\\lambda"] {
        let result = floating(&point, LyapunovMethod::Kronecker, &expression(latex));
        assert!(
            matches!(result, Err(FailureKind::WithoutValue { .. })),
            "{latex}: {result:?}"
        );
    }
    let unknown = floating(&point, LyapunovMethod::Kronecker, &expression("y"));
    assert!(matches!(unknown, Err(FailureKind::Undeclared { .. })));
}
