//! Partial fractions, and many fractions over one denominator.

mod common;

use common::from_small;
use proptest::prelude::*;
use ratpoly::{
    Budget, Error, FactoredDenominator, Order, Polynomial, RationalFunction, Resource, Ring,
    partial_fractions,
};

fn ring() -> Ring {
    Ring::new(["x", "a", "b"], Order::Lex).unwrap()
}

fn p(text: &str) -> Polynomial {
    Polynomial::parse(ring(), text).unwrap()
}

fn parts(text: &str) -> Vec<String> {
    let f = RationalFunction::parse(ring(), text).unwrap();
    let found = partial_fractions(&f, 0, &Budget::default()).unwrap();
    assert_eq!(found.recombine().unwrap(), f);
    let fractions = found
        .fractions
        .iter()
        .map(|q| format!("[{}] / ({})^{}", q.numerator, q.factor, q.power));
    std::iter::once(found.whole.to_string())
        .chain(fractions)
        .collect()
}

#[test]
fn worked_decompositions() {
    assert_eq!(parts("0"), ["0"]);
    assert_eq!(parts("(x^2 + a)/b"), ["(x^2 + a)/b"]);
    assert_eq!(
        parts("1/(x^2 - 1)"),
        ["0", "[1/2] / (x - 1)^1", "[-1/2] / (x + 1)^1"]
    );
    // Heaviside's case of a repeated factor.
    assert_eq!(
        parts("(x^2 + 1)/(x*(x - 1)^3)"),
        ["0", "[-1] / (x)^1", "[1] / (x - 1)^1", "[2] / (x - 1)^3"]
    );
    assert_eq!(parts("x^3/(x^2 + 1)"), ["x", "[-x] / (x^2 + 1)^1"]);
    assert_eq!(
        parts("1/((x + a)*(x + b))"),
        ["0", "[1/(a - b)] / (x + b)^1", "[-1/(a - b)] / (x + a)^1"]
    );
}

#[test]
fn refusals() {
    let f = RationalFunction::parse(ring(), "1/((x^2 + a)*(x^3 + b)*(x + a*b))").unwrap();
    assert_eq!(
        partial_fractions(&f, 3, &Budget::default()),
        Err(Error::VariableOutOfRange(3))
    );
    assert_eq!(
        partial_fractions(&f, 0, &Budget::new(1000, 1000, 50)),
        Err(Error::BudgetExceeded(Resource::Steps))
    );
    assert_eq!(
        FactoredDenominator::new(&p("0")).unwrap_err(),
        Error::DivisionByZero
    );
    let other = Ring::new(["x"], Order::Lex).unwrap();
    let denominator = FactoredDenominator::new(&p("x")).unwrap();
    assert_eq!(
        denominator.reduce(&Polynomial::one(other)),
        Err(Error::RingMismatch)
    );
}

fn polynomial(terms: usize) -> impl Strategy<Value = Polynomial> {
    let term = (prop::collection::vec(0u32..2, 3), -3i64..4);
    prop::collection::vec(term, 0..terms).prop_map(|terms| from_small(ring(), terms))
}

/// Products with repeated and shared factors, integers and variables among them.
fn product() -> impl Strategy<Value = Vec<(Polynomial, u32)>> {
    prop::collection::vec((polynomial(4), 0u32..3), 0..4)
}

fn expand(factors: &[(Polynomial, u32)]) -> Polynomial {
    factors.iter().fold(p("1"), |f, (g, m)| f * g.pow(*m))
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(80))]

    #[test]
    fn fractions_recombine(top in polynomial(5), bottom in product()) {
        let bottom = expand(&bottom);
        prop_assume!(!bottom.is_zero() && bottom.degree(0) <= Some(5));
        let f = RationalFunction::new(top, bottom).unwrap();
        let found = partial_fractions(&f, 0, &Budget::default()).unwrap();
        prop_assert_eq!(found.recombine().unwrap(), f);
        prop_assert_eq!(found.whole.denominator().degree(0), Some(0));
        for fraction in &found.fractions {
            let numerator = &fraction.numerator;
            prop_assert!(numerator.is_canonical() && !numerator.is_zero());
            prop_assert!(numerator.numerator().degree(0) < fraction.factor.degree(0));
            prop_assert_eq!(numerator.denominator().degree(0), Some(0));
        }
    }

    #[test]
    fn one_denominator_reduces_as_the_gcd_does(
        tops in prop::collection::vec(polynomial(5), 1..4),
        bottom in product(),
        sign in prop::sample::select(vec![-2i64, 1, 6]),
    ) {
        let denominator = expand(&bottom).mul_integer(&sign.into());
        prop_assume!(!denominator.is_zero());
        let common = FactoredDenominator::new(&denominator).unwrap();
        for top in tops {
            // The numerators share some of the factors.
            let shared = bottom.first().map_or(p("1"), |(g, _)| g.clone());
            for numerator in [top.clone(), &top * &shared, &top * &denominator] {
                let reduced = common.reduce(&numerator).unwrap();
                prop_assert!(reduced.is_canonical());
                prop_assert_eq!(reduced, RationalFunction::new(numerator, denominator.clone()).unwrap());
            }
        }
    }

    #[test]
    fn sums_of_products_are_sums_of_products(
        pairs in prop::collection::vec((polynomial(7), polynomial(9), any::<bool>()), 0..6),
        shift in prop::sample::select(vec![0u32, 1, 30, 63, 126]),
        stretch in prop::sample::select(vec![0u32, 6, 15_000, 1 << 20, 1 << 31]),
    ) {
        // Coefficients and exponents at the edges of the machine words.
        let huge = p("1").mul_integer(&(ratpoly::BigInt::from(1) << shift));
        let far = Polynomial::from_terms(ring(), [([0, stretch, 0], 1.into())]).unwrap();
        let pairs: Vec<(Polynomial, Polynomial)> = pairs
            .into_iter()
            .map(|(f, g, edge)| if edge { (f * &huge, g * &far) } else { (f, g) })
            .collect();
        let mut expected = p("0");
        for (f, g) in &pairs {
            let terms = f.terms().flat_map(|(m, c)| {
                g.terms().map(move |(n, d)| (m.checked_mul(&n).unwrap(), &c * d)).collect::<Vec<_>>()
            });
            expected += Polynomial::from_terms(ring(), terms).unwrap();
        }
        let found = Polynomial::sum_of_products(ring(), pairs.iter().map(|(f, g)| (f, g))).unwrap();
        prop_assert!(found.is_canonical());
        prop_assert_eq!(found, expected);
    }
}
