//! The table of methods: what is said of them is measured.

use rederive::audit::Audit;
use rederive::check::Options;
use rederive::document::Document;
use rederive::methods::{AtPoint, Method, Methods};
use rederive::numeric::LyapunovMethod;
use rederive::report::methods::{headline, plain};
use std::path::Path;

fn methods(name: &str) -> Methods {
    let path = Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("proofs/schiehlen-2006")
        .join(name);
    let document = Document::read(&path).unwrap_or_else(|rejection| panic!("{rejection}"));
    let options = Options {
        repair: name == "quarter-car.md",
        ..Options::default()
    };
    let audit = Audit::of(&document, options).unwrap_or_else(|rejection| panic!("{rejection}"));
    Methods::of(&audit, false).expect("methods")
}

fn digits(at: &AtPoint, method: Method) -> f64 {
    let row = at.rows.iter().find(|r| r.method == method).expect("a row");
    row.output
        .unwrap_or_else(|| panic!("{method:?}: {}", row.remark))
}

fn operations(at: &AtPoint, method: Method) -> u64 {
    let row = at.rows.iter().find(|r| r.method == method).expect("a row");
    row.operations.expect("operations")
}

/// The headline of the paper: the covariance analysis needs no integration.
#[test]
fn integration_costs_more_and_gives_no_more() {
    for (name, order) in [
        ("quarter-car.md", 4),
        ("quarter-car-filter-1.md", 5),
        ("quarter-car-filter-2.md", 6),
    ] {
        let found = methods(name);
        assert!(found.points.len() >= 2, "{name}");
        let reference = &found.points[0];
        assert_eq!(
            (reference.order, &reference.point[..]),
            (order, "reference")
        );
        let solved = Method::Lyapunov(LyapunovMethod::BartelsStewart);
        for method in Method::ALL {
            let least = match method {
                Method::Simulation => 1.5,
                Method::Quadrature => 10.0,
                _ => 12.0,
            };
            let digits = digits(reference, method);
            assert!(digits > least, "{name}: {method:?} keeps {digits}");
        }
        assert!(operations(reference, Method::Quadrature) > 10 * operations(reference, solved));
        assert!(
            operations(reference, Method::Simulation) > operations(reference, Method::Quadrature)
        );
        assert!(headline(reference).is_some(), "{name}");
        // The same table again, byte by byte.
        assert_eq!(plain(&found, false), plain(&methods(name), false));
    }
}
