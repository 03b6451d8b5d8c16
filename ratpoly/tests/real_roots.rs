//! Real roots: counts and isolation against constructed roots.

use proptest::prelude::*;
use ratpoly::{
    BigInt, BigRational, Bound, Budget, Error, Order, Polynomial, Resource, Ring, SturmSequence,
    real_roots,
};
use std::cmp::Ordering;

fn ring() -> Ring {
    Ring::new(["x", "y"], Order::Lex).unwrap()
}

fn p(text: &str) -> Polynomial {
    Polynomial::parse(ring(), text).unwrap()
}

fn ratio(n: i64, d: i64) -> BigRational {
    BigRational::new(n.into(), d.into())
}

fn decimals(text: &str, digits: u32) -> Vec<String> {
    let roots = real_roots(&p(text), 0, &Budget::default()).unwrap();
    roots.iter().map(|r| r.decimal(digits)).collect()
}

#[test]
fn known_roots() {
    assert_eq!(decimals("x^2 - 2", 10), ["-1.4142135623", "1.4142135623"]);
    assert_eq!(decimals("x^3 - x", 2), ["-1.00", "0.00", "1.00"]);
    assert_eq!(decimals("4*x^2 - 1", 3), ["-0.500", "0.500"]);
    assert_eq!(decimals("x^2 + x + 1", 3), [""; 0]);
    assert_eq!(decimals("7", 3), [""; 0]);
    assert_eq!(decimals("10*x - 29", 1), ["2.9"]);
    assert_eq!(decimals("x^2 - 99", 0), ["-9", "9"]);
    // Wallis's example, by which Newton explained his method: x^3 - 2x - 5, root 2.09455148...
    assert_eq!(decimals("x^3 - 2*x - 5", 8), ["2.09455148"]);
    // Mignotte's polynomial (1982): two roots closer than 10^-8 near 1/50.
    let close = real_roots(&p("x^10 - 2*(50*x - 1)^2"), 0, &Budget::default()).unwrap();
    assert_eq!(close.len(), 4);
    assert!(close[1].high() <= close[2].low());
}

#[test]
fn wilkinson_in_exact_arithmetic() {
    let mut f = Polynomial::one(ring());
    for k in 1..=20 {
        f *= p("x") - Polynomial::constant(ring(), k);
    }
    let roots = real_roots(&f, 0, &Budget::default()).unwrap();
    assert_eq!(roots.len(), 20);
    for (k, root) in (1..).zip(&roots) {
        assert_eq!(root.compare(&ratio(k, 1)), Ordering::Equal);
    }
    // Wilkinson's perturbation by 2^-23 of the coefficient of x^19 leaves ten real roots.
    let shifted = f.mul_integer(&BigInt::from(1 << 23)) - p("x^19");
    let sturm = SturmSequence::new(&shifted, 0).unwrap();
    assert_eq!(sturm.count_all(), 10);
}

#[test]
fn refusals() {
    let budget = Budget::default();
    assert!(matches!(
        real_roots(&p("0"), 0, &budget),
        Err(Error::Unsupported(_))
    ));
    assert!(matches!(
        real_roots(&p("x*y"), 0, &budget),
        Err(Error::Unsupported(_))
    ));
    assert_eq!(
        real_roots(&p("x"), 2, &budget).unwrap_err(),
        Error::VariableOutOfRange(2)
    );
    assert!(SturmSequence::new(&p("0"), 0).is_err());
    let few = Budget::new(100, 100_000, 100);
    let hard = real_roots(&p("x^10 - 2*(50*x - 1)^2"), 0, &few);
    assert_eq!(hard.unwrap_err(), Error::BudgetExceeded(Resource::Steps));
    let mut root = real_roots(&p("x^2 - 2"), 0, &budget).unwrap().remove(0);
    assert!(root.refine(&ratio(0, 1)).is_err());
}

/// Rational roots with multiplicities, and factors without real roots.
fn constructed() -> impl Strategy<Value = (Vec<(BigRational, usize)>, Polynomial)> {
    let roots = prop::collection::btree_map((-12i64..13, 1i64..5), 1usize..4, 0..5);
    (roots, 0usize..3).prop_map(|(map, pairs)| {
        let mut roots: Vec<(BigRational, usize)> = Vec::new();
        for ((n, d), m) in map {
            let x = ratio(n, d);
            if roots.iter().all(|(y, _)| *y != x) {
                roots.push((x, m));
            }
        }
        roots.sort();
        let mut f = p("-3");
        for (x, m) in &roots {
            let linear =
                p("x").mul_integer(x.denom()) - Polynomial::constant(ring(), x.numer().clone());
            f *= linear.pow(*m as u32);
        }
        f *= p("x^2 + x + 1").pow(pairs as u32);
        (roots, f)
    })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(150))]

    #[test]
    fn finds_constructed_roots((expected, f) in constructed(), low in -30i64..30, width in 0i64..40) {
        let roots = real_roots(&f, 0, &Budget::default()).unwrap();
        prop_assert_eq!(roots.len(), expected.len());
        for (root, (x, m)) in roots.iter().zip(&expected) {
            prop_assert_eq!(root.compare(x), Ordering::Equal);
            prop_assert_eq!(root.compare(&(x + ratio(1, 1000))), Ordering::Less);
            prop_assert_eq!(root.multiplicity(), *m);
            prop_assert!(root.low() <= x && x <= root.high());
            let mut fine = root.clone();
            fine.refine(&ratio(1, 1 << 20)).unwrap();
            prop_assert!(fine.high() - fine.low() < ratio(1, 1 << 20));
            prop_assert!(fine.low() <= x && x <= fine.high());
        }
        for pair in roots.windows(2) {
            prop_assert!(pair[0].high() <= pair[1].low());
        }
        let sturm = SturmSequence::new(&f, 0).unwrap();
        prop_assert_eq!(sturm.count_all(), expected.len());
        // Ends on a grid of halves, so that they often are roots themselves.
        let (a, b) = (ratio(low, 2), ratio(low + width, 2));
        let count = |test: &dyn Fn(&BigRational) -> bool| expected.iter().filter(|(x, _)| test(x)).count();
        let (low, high) = (Bound::from(a.clone()), Bound::from(b.clone()));
        prop_assert_eq!(sturm.count_closed(&low, &high), count(&|x| a <= *x && *x <= b));
        prop_assert_eq!(sturm.count_half_open(&low, &high), count(&|x| a < *x && *x <= b));
        prop_assert_eq!(sturm.count_open(&low, &high), count(&|x| a < *x && *x < b));
        prop_assert_eq!(sturm.count_open(&Bound::NegativeInfinity, &high), count(&|x| *x < b));
        prop_assert_eq!(sturm.count_half_open(&low, &Bound::PositiveInfinity), count(&|x| *x > a));
    }

    #[test]
    fn descartes_and_sturm_agree(coefficients in prop::collection::vec(-20i64..21, 1..9)) {
        let terms = coefficients.iter().zip(0u32..).map(|(&c, k)| (vec![k, 0], BigInt::from(c)));
        let f = Polynomial::from_terms(ring(), terms).unwrap();
        prop_assume!(!f.is_zero());
        let sturm = SturmSequence::new(&f, 0).unwrap();
        let roots = real_roots(&f, 0, &Budget::default()).unwrap();
        prop_assert_eq!(roots.len(), sturm.count_all());
        for root in &roots {
            let (low, high) = (root.low().clone().into(), root.high().clone().into());
            prop_assert_eq!(sturm.count_closed(&low, &high), 1);
        }
    }
}
