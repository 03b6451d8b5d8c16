//! Resultants, subresultants, discriminants: against Sylvester's determinant, by their laws, published values.

mod common;

use common::{from_small, leibniz_determinant, sylvester};
use proptest::prelude::*;
use ratpoly::{
    Budget, Error, Order, Polynomial, Resource, Ring, discriminant, gcd, resultant,
    resultant_within, subresultants,
};

fn ring() -> Ring {
    Ring::new(["x", "y", "z"], Order::Lex).unwrap()
}

fn p(text: &str) -> Polynomial {
    Polynomial::parse(ring(), text).unwrap()
}

#[test]
fn published_values() {
    // Cox, Little, O'Shea, Ideals, Varieties, and Algorithms, section 3.6, example 3: xy - 1 and
    // x^2 + y^2 - 4 with respect to x.
    assert_eq!(
        resultant(&p("x*y - 1"), &p("x^2 + y^2 - 4"), 0),
        Ok(p("y^4 - 4*y^2 + 1"))
    );
    let ring = Ring::new(["x", "a", "b", "c", "d"], Order::Lex).unwrap();
    let q = |text| Polynomial::parse(ring, text).unwrap();
    assert_eq!(discriminant(&q("a*x^2 + b*x + c"), 0), Ok(q("b^2 - 4*a*c")));
    assert_eq!(
        discriminant(&q("a*x^3 + b*x^2 + c*x + d"), 0),
        Ok(q("b^2*c^2 - 4*a*c^3 - 4*b^3*d + 18*a*b*c*d - 27*a^2*d^2"))
    );
    assert_eq!(
        discriminant(&q("x^3 + c*x + d"), 0),
        Ok(q("-4*c^3 - 27*d^2"))
    );
    // Knuth, TAOCP 2, 4.6.1, the polynomials of the famous remainder sequence (8) and (9); the
    // subresultants of degree 1 and 0 there are 9326 x - 12300 (up to sign) and 260708.
    let (f, g) = (
        p("x^8 + x^6 - 3*x^4 - 3*x^3 + 8*x^2 + 2*x - 5"),
        p("3*x^6 + 5*x^4 - 4*x^2 - 9*x + 21"),
    );
    let all = subresultants(&f, &g, 0, &Budget::default()).unwrap();
    assert_eq!(all[0], p("260708"));
    assert_eq!(all[1].unit_normal(), p("9326*x - 12300"));
}

#[test]
fn small_degrees_and_zero() {
    assert_eq!(resultant(&p("0"), &p("x"), 0), Ok(p("0")));
    assert_eq!(resultant(&p("x"), &p("0"), 0), Ok(p("0")));
    assert_eq!(resultant(&p("3"), &p("y"), 0), Ok(p("1")));
    assert_eq!(resultant(&p("3"), &p("x^2*y + 1"), 0), Ok(p("9")));
    assert_eq!(
        resultant(&p("x^2*y + 1"), &p("y + z"), 0),
        Ok(p("y^2 + 2*y*z + z^2"))
    );
    assert_eq!(resultant(&p("x"), &p("x - y"), 0), Ok(p("-y")));
    assert_eq!(discriminant(&p("x - y"), 0), Ok(p("1")));
}

#[test]
fn refusals() {
    let other = Ring::new(["x"], Order::Lex).unwrap();
    let x = Polynomial::variable(other, 0);
    assert_eq!(resultant(&p("x"), &x, 0), Err(Error::RingMismatch));
    assert_eq!(
        resultant(&p("x"), &p("y"), 3),
        Err(Error::VariableOutOfRange(3))
    );
    assert!(matches!(
        discriminant(&p("y"), 0),
        Err(Error::Unsupported(_))
    ));
    assert!(matches!(
        subresultants(&p("x"), &p("x^2"), 0, &Budget::default()),
        Err(Error::Unsupported(_))
    ));
    let (f, g) = (p("x^5*y + x^2*z - y + 1"), p("z*x^5 + y*x^3 - x + z"));
    let few = Budget::new(20, 10_000, u64::MAX);
    assert_eq!(
        resultant_within(&f, &g, 0, &few),
        Err(Error::BudgetExceeded(Resource::Terms))
    );
}

fn polynomial() -> impl Strategy<Value = Polynomial> {
    let term = (prop::collection::vec(0u32..3, 3), -3i64..4);
    prop::collection::vec(term, 0..4).prop_map(|terms| from_small(ring(), terms))
}

/// The same with the letter in it.
fn in_x() -> impl Strategy<Value = Polynomial> {
    polynomial().prop_map(|f| {
        if has_x(&f) {
            f
        } else {
            f + Polynomial::variable(ring(), 0)
        }
    })
}

fn has_x(f: &Polynomial) -> bool {
    f.degree(0).is_some_and(|d| d > 0)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(150))]

    #[test]
    fn equals_the_sylvester_determinant(f in in_x(), g in in_x()) {
        let found = resultant(&f, &g, 0).unwrap();
        prop_assert!(found.is_canonical());
        prop_assert_eq!(&found, &leibniz_determinant(ring(), &sylvester(&f, &g, 0)));
        if f.degree(0) >= g.degree(0) {
            let all = subresultants(&f, &g, 0, &Budget::default()).unwrap();
            prop_assert_eq!(&all[0], &found);
            // The first that does not vanish is the gcd up to a factor without x.
            if let Some(s) = all.iter().find(|s| !s.is_zero()) {
                prop_assert_eq!(s.degree(0), gcd(&f, &g).degree(0));
                prop_assert_eq!(gcd(&f, &g).pseudo_remainder(s, 0).unwrap(), p("0"));
            }
        }
    }

    #[test]
    fn vanishes_exactly_for_a_common_factor(f in polynomial(), g in polynomial(), h in polynomial()) {
        if f.is_zero() || g.is_zero() {
            return Ok(());
        }
        let zero = resultant(&f, &g, 0).unwrap().is_zero();
        prop_assert_eq!(zero, has_x(&gcd(&f, &g)));
        if has_x(&h) {
            prop_assert!(resultant(&(&f * &h), &(&g * &h), 0).unwrap().is_zero());
            // A repeated factor kills the discriminant.
            prop_assert!(discriminant(&(&f * &h * &h), 0).unwrap().is_zero());
        }
    }

    #[test]
    fn is_multiplicative_and_alternating(f in in_x(), g in in_x(), h in in_x()) {
        let r = |a: &Polynomial, b: &Polynomial| resultant(a, b, 0).unwrap();
        prop_assert_eq!(r(&(&f * &g), &h), r(&f, &h) * r(&g, &h));
        let odd = f.degree(0).unwrap() * g.degree(0).unwrap() % 2 == 1;
        let swapped = r(&g, &f);
        prop_assert_eq!(r(&f, &g), if odd { -swapped } else { swapped });
    }
}
