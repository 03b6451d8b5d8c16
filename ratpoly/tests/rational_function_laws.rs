//! Laws of the field of rational functions; every result is reduced and of canonical sign.

mod plain;

use plain::{Sizes, ring, small_polynomial};
use proptest::prelude::*;
use ratpoly::{
    BigInt, BigRational, Budget, Error, Order, Polynomial, RationalFunction, Resource, Ring,
};

const TINY: Sizes = Sizes {
    terms: 3,
    degree: 2,
};

fn canonical(r: RationalFunction) -> RationalFunction {
    assert!(r.is_canonical(), "not canonical: {r}");
    r
}

/// Three functions of one ring whose numerators and denominators like to share factors.
fn triple() -> impl Strategy<Value = [RationalFunction; 3]> {
    ring(3).prop_flat_map(|ring| {
        let p = move || small_polynomial(ring, TINY);
        let one = Polynomial::one(ring);
        ([p(), p(), p()], [p(), p(), p()], p(), 0..5).prop_map(move |(n, d, common, shape)| {
            let common = if common.is_zero() {
                one.clone()
            } else {
                common
            };
            let build = |k: usize| {
                let d = if d[k].is_zero() {
                    one.clone()
                } else {
                    d[k].clone()
                };
                let (n, d) = match shape {
                    0 => (n[k].clone(), &d * &common),
                    1 => (&n[k] * &common, d),
                    2 => (n[k].clone(), common.clone()),
                    3 => (n[k].clone(), one.clone()),
                    _ => (n[k].clone(), d),
                };
                canonical(RationalFunction::new(n, d).unwrap())
            };
            [build(0), build(1), build(2)]
        })
    })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(200))]

    #[test]
    fn field_laws([a, b, c] in triple()) {
        let (zero, one) = (RationalFunction::zero(a.ring()), RationalFunction::one(a.ring()));
        prop_assert_eq!(canonical(&a + &b), canonical(&b + &a));
        prop_assert_eq!(canonical(&a * &b), canonical(&b * &a));
        prop_assert_eq!(&(&a + &b) + &c, &a + &(&b + &c));
        prop_assert_eq!(&(&a * &b) * &c, &a * &(&b * &c));
        prop_assert_eq!(&a * &(&b + &c), &a * &b + &a * &c);
        prop_assert_eq!(canonical(&a - &a), zero.clone());
        prop_assert_eq!(&a - &b, canonical(-&(&b - &a)));
        prop_assert_eq!(&a + &zero, a.clone());
        prop_assert_eq!(&a * &one, a.clone());
        if b.is_zero() {
            prop_assert_eq!(a.checked_div(&b), Err(Error::DivisionByZero));
            prop_assert_eq!(b.inverse(), Err(Error::DivisionByZero));
            prop_assert_eq!(b.pow(-1), Err(Error::DivisionByZero));
        } else {
            prop_assert_eq!(canonical(&a / &b) * &b, a.clone());
            prop_assert!((&b / &b).is_one());
            prop_assert_eq!(canonical(b.pow(-2).unwrap()) * b.pow(2).unwrap(), one);
        }
        prop_assert_eq!(canonical(a.pow(3).unwrap()), &(&a * &a) * &a);
    }

    /// The sum as by its definition: cross-multiplied, then reduced.
    #[test]
    fn sums_agree_with_the_plain_definition([a, b, _] in triple()) {
        let ((n, d), (m, e)) = (a.clone().into_parts(), b.clone().into_parts());
        let plain = RationalFunction::new(&n * &e + &m * &d, &d * &e).unwrap();
        prop_assert_eq!(&a + &b, plain);
        let plain = RationalFunction::new(&n * &m, &d * &e).unwrap();
        prop_assert_eq!(&a * &b, plain);
    }

    #[test]
    fn derivatives([a, b, _] in triple()) {
        let slope = |r: &RationalFunction| canonical(r.derivative(0).unwrap());
        prop_assert_eq!(slope(&(&a + &b)), slope(&a) + slope(&b));
        prop_assert_eq!(slope(&(&a * &b)), slope(&a) * &b + &a * slope(&b));
        if !b.is_zero() {
            let quotient = (slope(&a) * &b - &a * slope(&b)) / (&b * &b);
            prop_assert_eq!(slope(&(&a / &b)), quotient);
        }
    }

    #[test]
    fn substitution_commutes_with_evaluation([a, b, c] in triple(), x in -5i64..=5, y in 1i64..=7) {
        let images: Vec<RationalFunction> =
            [&b, &c, &a].into_iter().take(a.ring().len()).cloned().collect();
        let point: Vec<BigRational> =
            (0..a.ring().len() as i64).map(|k| BigRational::new((x + k).into(), y.into())).collect();
        let inner: Result<Vec<BigRational>, Error> =
            images.iter().map(|image| image.evaluate(&point)).collect();
        match a.compose(a.ring(), &images) {
            Err(error) => prop_assert_eq!(error, Error::DivisionByZero),
            Ok(composed) => {
                let composed = canonical(composed);
                // The composed function may be defined where a part is not, never the other way round
                // except where a factor cancelled.
                if let Ok(inner) = inner
                    && let (Ok(left), Ok(right)) = (composed.evaluate(&point), a.evaluate(&inner))
                {
                    prop_assert_eq!(left, right);
                }
            }
        }
    }

    #[test]
    fn text_and_other_rings_give_back([a, _, _] in triple()) {
        prop_assert_eq!(RationalFunction::parse(a.ring(), &a.to_string()).unwrap(), a.clone());
        for order in [Order::Lex, Order::Grlex, Order::Grevlex] {
            let other = canonical(a.to_ring(a.ring().with_order(order)).unwrap());
            prop_assert_eq!(other.to_ring(a.ring()).unwrap(), a.clone());
        }
    }
}

fn xy() -> Ring {
    Ring::new(["x", "y"], Order::Lex).unwrap()
}

fn r(text: &str) -> RationalFunction {
    RationalFunction::parse(xy(), text).unwrap()
}

#[test]
fn signs_and_contents_are_canonical() {
    assert_eq!(r("(2*x - 2*y)/(4*y - 4*x)").to_string(), "-1/2");
    assert_eq!(r("(6*x)/(-9*y)").to_string(), "-2*x/(3*y)");
    assert_eq!(r("(x^2 - 1)/(1 - x)").to_string(), "-x - 1");
    assert_eq!(r("0/(x - y)"), RationalFunction::zero(xy()));
    assert_eq!(
        r("3/6").as_constant(),
        Some(BigRational::new(1.into(), 2.into()))
    );
    assert_eq!(r("x").as_constant(), None);
}

#[test]
fn what_has_no_value_is_refused() {
    let (one, zero) = (Polynomial::one(xy()), Polynomial::zero(xy()));
    assert_eq!(
        RationalFunction::new(one.clone(), zero),
        Err(Error::DivisionByZero)
    );
    let other = Polynomial::one(Ring::new(["x"], Order::Lex).unwrap());
    assert_eq!(
        RationalFunction::new(one, other.clone()),
        Err(Error::RingMismatch)
    );
    assert_eq!(
        r("x").try_add(&other.clone().into()),
        Err(Error::RingMismatch)
    );
    assert_eq!(r("1/x").try_mul(&other.into()), Err(Error::RingMismatch));
    let origin = [BigInt::from(0).into(), BigInt::from(0).into()];
    assert_eq!(r("1/x").evaluate(&origin), Err(Error::DivisionByZero));
    assert_eq!(
        r("1/(x - y)").substitute(&[(0, r("y"))]),
        Err(Error::DivisionByZero)
    );
    assert_eq!(
        r("1/(x - y)").map_ring(xy(), &[Some(0), Some(0)]),
        Err(Error::DivisionByZero)
    );
    let budget = Budget::new(10, 100, 1000);
    let exceeded = Err(Error::BudgetExceeded(Resource::Terms));
    assert_eq!(r("1/(x + y)").pow_within(-20, &budget), exceeded);
}
