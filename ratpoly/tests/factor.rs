//! Laws of the factorisation, fixed results from the literature, and known irreducible factors found again.

use num_bigint::BigInt;
use num_traits::One;
use proptest::prelude::*;
use ratpoly::{Budget, Error, Factorization, Order, Polynomial, Resource, Ring, gcd};

const NAMES: [&str; 8] = ["a", "b", "c", "d", "e", "f", "g", "h"];

fn ring(variables: usize) -> Ring {
    Ring::new(NAMES[..variables].iter().copied(), Order::Lex).unwrap()
}

fn poly(ring: Ring, text: &str) -> Polynomial {
    Polynomial::parse(ring, text).unwrap()
}

/// What every factorisation must satisfy.
fn check(f: &Polynomial) -> Factorization {
    let product = f.factor();
    assert_eq!(product.expand(), *f, "multiplies back");
    for (i, (g, multiplicity)) in product.factors.iter().enumerate() {
        assert!(g.is_canonical() && !g.is_constant() && *multiplicity > 0);
        assert!(
            g.content().is_one() && *g == g.unit_normal(),
            "primitive and positive: {g}"
        );
        assert!(
            product.factors[..i].iter().all(|(h, _)| gcd(g, h).is_one()),
            "coprime"
        );
    }
    assert_eq!(product, f.factor(), "deterministic");
    product
}

/// A factorisation written as a text: the parts in any order, each with its multiplicity.
fn expect(f: &Polynomial, content: i64, parts: &[(&str, u32)]) {
    let product = check(f);
    let mut found: Vec<(String, u32)> = product
        .factors
        .iter()
        .map(|(g, m)| (g.to_string(), *m))
        .collect();
    let mut wanted: Vec<(String, u32)> = parts
        .iter()
        .map(|(text, m)| (poly(f.ring(), text).unit_normal().to_string(), *m))
        .collect();
    found.sort();
    wanted.sort();
    assert_eq!((product.content, found), (BigInt::from(content), wanted));
}

/// Polynomials with few terms in 1 to 4 variables, with small and large coefficients.
fn polynomials(count: usize, degree: u32) -> impl Strategy<Value = Vec<Polynomial>> {
    (1usize..=4).prop_flat_map(move |n| {
        let coefficient = prop_oneof![5 => (-5i64..=5).prop_map(BigInt::from), 1 => any::<i64>().prop_map(|c| BigInt::from(c) << 40u32)];
        let term = (prop::collection::vec(0..=degree, n), coefficient);
        let terms = prop::collection::vec(term, 1..5);
        prop::collection::vec(terms, count)
            .prop_map(move |lists| lists.into_iter().map(|list| Polynomial::from_terms(ring(n), list).unwrap()).collect())
    })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(60))]

    #[test]
    fn products_are_taken_apart(p in polynomials(3, 2), i in 1u32..3) {
        let f = &p[0] * p[1].pow(i) * &p[2];
        let product = check(&f);
        if !f.is_zero() {
            let count = |f: &Polynomial| f.factor().factors.iter().map(|(_, m)| m).sum::<u32>();
            let parts = count(&p[0]) + i * count(&p[1]) + count(&p[2]);
            prop_assert_eq!(product.factors.iter().map(|(_, m)| m).sum::<u32>(), parts);
            // Every irreducible factor of a factor is among them.
            for g in &p {
                for (h, _) in g.factor().factors {
                    prop_assert!(product.factors.iter().any(|(k, _)| *k == h));
                }
            }
        }
    }

    #[test]
    fn factors_are_irreducible(p in polynomials(2, 3)) {
        let f = &p[0] * &p[1];
        for (g, _) in check(&f).factors {
            prop_assert!(g.is_irreducible());
            prop_assert_eq!(check(&g).factors, vec![(g, 1)]);
        }
    }

    #[test]
    fn square_free_parts(p in polynomials(3, 2)) {
        let f = &p[0] * p[1].pow(2) * p[2].pow(3);
        let parts = f.square_free_factorization();
        prop_assert_eq!(parts.expand(), f.clone());
        let multiplicities: Vec<u32> = parts.factors.iter().map(|(_, m)| *m).collect();
        for (i, (g, m)) in parts.factors.iter().enumerate() {
            prop_assert!(g.is_square_free() && g.factor().factors.iter().all(|(_, m)| *m == 1));
            prop_assert!(!multiplicities[..i].contains(m));
        }
        let full = f.factor();
        prop_assert_eq!(f.is_square_free(), !f.is_zero() && full.factors.iter().all(|(_, m)| *m == 1));
    }

    /// By Eisenstein's criterion in a with the prime c: irreducible whatever the middle is.
    #[test]
    fn eisenstein_factors_are_found_again(
        middles in prop::collection::vec(prop::collection::vec((0u32..3, 0u32..3, -9i64..10), 1..4), 2..4),
    ) {
        let ring = ring(3);
        let mut factors: Vec<Polynomial> = Vec::new();
        for (i, middle) in (0i64..).zip(middles) {
            let terms = middle.into_iter().map(|(a, b, c)| (vec![a.min(2), b, 1], BigInt::from(c)));
            let middle = Polynomial::from_terms(ring, terms).unwrap();
            let last = poly(ring, "c").mul_integer(&(2 * i + 1).into());
            factors.push((poly(ring, "a^3") + middle * poly(ring, "a") + last).unit_normal());
        }
        let product = check(&factors.iter().fold(Polynomial::one(ring), |f, g| f * g));
        let mut found: Vec<Polynomial> = product.factors.into_iter().map(|(g, _)| g).collect();
        found.sort();
        factors.sort();
        factors.dedup();
        prop_assert_eq!(found, factors);
    }
}

#[test]
fn zero_constants_and_monomials() {
    let ring = ring(3);
    for (text, content, parts) in [
        ("0", 0, &[][..]),
        ("1", 1, &[]),
        ("-60", -60, &[]),
        ("-12*a^3*c", -12, &[("a", 3), ("c", 1)]),
        ("2*a + 4", 2, &[("a + 2", 1)]),
        ("-a^2", -1, &[("a", 2)]),
    ] {
        expect(&poly(ring, text), content, parts);
    }
    assert!(!poly(ring, "2*a").is_irreducible() && !Polynomial::one(ring).is_irreducible());
    assert!(poly(ring, "b").is_irreducible() && poly(ring, "-a*b - c").is_irreducible());
    assert!(!Polynomial::zero(ring).is_square_free() && poly(ring, "4*a").is_square_free());
}

/// Known shapes: differences of powers, Sophie Germain, a sum of cubes, a determinant.
#[test]
fn classics() {
    let ring = ring(6);
    expect(
        &poly(ring, "a^4 + 4*b^4"),
        1,
        &[("a^2 - 2*a*b + 2*b^2", 1), ("a^2 + 2*a*b + 2*b^2", 1)],
    );
    expect(
        &poly(ring, "a^6 - b^6"),
        1,
        &[
            ("a - b", 1),
            ("a + b", 1),
            ("a^2 - a*b + b^2", 1),
            ("a^2 + a*b + b^2", 1),
        ],
    );
    expect(
        &poly(ring, "a^3 + b^3 + c^3 - 3*a*b*c"),
        1,
        &[("a + b + c", 1), ("a^2 - a*b - a*c + b^2 - b*c + c^2", 1)],
    );
    expect(
        &poly(ring, "(a^2 + b^2)*(c^2 + d^2)*(a*c + b*d)^2*(e^2 + f^3)^3"),
        1,
        &[
            ("a^2 + b^2", 1),
            ("c^2 + d^2", 1),
            ("a*c + b*d", 2),
            ("e^2 + f^3", 3),
        ],
    );
    // The Vandermonde determinant, a product of differences.
    expect(
        &poly(ring, "(b-a)*(c-a)*(d-a)*(c-b)*(d-b)*(d-c)"),
        1,
        &[
            ("a - b", 1),
            ("a - c", 1),
            ("a - d", 1),
            ("b - c", 1),
            ("b - d", 1),
            ("c - d", 1),
        ],
    );
    for irreducible in [
        "a^2 + b^2 + c^2",
        "a^2*b^2 + c^2*d^2 + e^2*f^2 + 1",
        "a^4 + b^4",
        "a^2 - 2*b^2",
        "a^2*b^3 - c^2",
    ] {
        assert!(poly(ring, irreducible).is_irreducible(), "{irreducible}");
    }
}

/// What makes factoring in several variables hard, as P. S. Wang sets it out in *An improved multivariate
/// polynomial factoring algorithm*, 1978: leading coefficients that are polynomials, factors that share
/// them, images with more factors. The polynomials are made up here.
#[test]
fn leading_coefficients_that_are_polynomials() {
    let ring = ring(4);
    let products: [&[&str]; 5] = [
        &[
            "a^2*b*c + a*b^3*c^2 + 11",
            "a*b*c^2 - a^2 + 3",
            "a^3*b^2 - c + 5",
        ],
        &[
            "4*c*b^4 + 4*c^4 - 4*c*b + 10",
            "(b^3 - c^2)*a^2 - 3*a + 7*c",
        ],
        &[
            "(b^2*c^3 - 2)*a^3 + c*a - b^2",
            "(b + c)*a^2 + (b - c)*a + b*c",
            "(b - c)*a^2 + 3",
        ],
        &[
            "a^3*b^2 + 2*c*a - 14*d",
            "a^2*d^3 - c^2*b + 9",
            "a*b*c*d - 1",
        ],
        &["(b^4 + 3)*a^4 + c*b*a + d", "(b^4 + 3)*a^4 - c*b*a + d"],
    ];
    for factors in products {
        let list: Vec<Polynomial> = factors.iter().map(|text| poly(ring, text)).collect();
        let f = list.iter().fold(Polynomial::one(ring), |f, g| f * g);
        let found = check(&f);
        let wanted: u32 = list
            .iter()
            .map(|g| check(g).factors.iter().map(|(_, m)| m).sum::<u32>())
            .sum();
        assert_eq!(found.factors.iter().map(|(_, m)| m).sum::<u32>(), wanted);
        for g in &list {
            assert!(
                found
                    .factors
                    .iter()
                    .any(|(h, _)| *h == g.primitive_part().unit_normal()),
                "{g}"
            );
        }
    }
}

/// x^105 - 1 and the homogeneous x^30 - y^30: one factor for each divisor of the exponent.
#[test]
fn cyclotomic_polynomials() {
    let ring = ring(2);
    let (a, b) = (Polynomial::variable(ring, 0), Polynomial::variable(ring, 1));
    assert_eq!(
        check(&(a.pow(105) - Polynomial::one(ring))).factors.len(),
        8
    );
    assert_eq!(check(&(a.pow(30) - b.pow(30))).factors.len(), 8);
    assert_eq!(check(&(a.pow(16) - b.pow(16))).factors.len(), 5);
}

/// Irreducible, but with factors modulo every prime and at many points: x⁴ + 1 and its relatives, norms of
/// sums of square roots of variables.
#[test]
fn norms_of_square_roots() {
    let ring = ring(4);
    // The norm of d + √a + √b, and of d + √a + √b + √c.
    let two = poly(ring, "(d^2 - a - b)^2 - 4*a*b");
    assert!(two.is_irreducible());
    let m = poly(ring, "(d^2 + a - b - c)^2 + 4*a*d^2 - 4*b*c");
    let three = m.pow(2) - poly(ring, "16*a*d^2*(d^2 + a - b - c)^2");
    let product = check(&(&three * &two));
    assert!(product.factors.iter().any(|(g, _)| *g == two.unit_normal()));
    // At squares everything splits.
    let squares = [(0, poly(ring, "a^2")), (1, poly(ring, "b^2"))];
    let split = two.substitute(&squares).unwrap();
    expect(
        &split,
        1,
        &[
            ("a + b + d", 1),
            ("a + b - d", 1),
            ("a - b + d", 1),
            ("a - b - d", 1),
        ],
    );
}

/// The determinant of the Hurwitz matrix of the quarter car: a factor that the car shares with no filter,
/// and the resultant of car and filter, of degree two in most letters.
#[test]
fn hurwitz_determinants() {
    let ring = ring(7);
    let car = ["1", "d + e", "a + b + c", "c*d", "a*c"].map(|text| poly(ring, text));
    // The resultant of s⁴ + ... and the filter s² - f·s + g with s → -s: Π (rᵢ² + f·rᵢ + g).
    let mut power = (Polynomial::one(ring), Polynomial::zero(ring)); // s^k = p·... as (constant, linear) modulo s² + f s + g
    let (f, g) = (poly(ring, "f"), poly(ring, "g"));
    let mut value = (Polynomial::zero(ring), Polynomial::zero(ring));
    for c in car.iter().rev() {
        value = (&value.0 + &(c * &power.0), &value.1 + &(c * &power.1));
        power = (-(&g * &power.1), &power.0 - &(&f * &power.1));
    }
    // Its norm: u² - f·u·v + g·v².
    let resultant = value.0.pow(2) - &f * &value.0 * &value.1 + &g * value.1.pow(2);
    assert!(resultant.is_irreducible());
    let hurwitz = &car[1] * &car[2] * &car[3] - car[3].pow(2) - &car[4] * car[1].pow(2);
    let det = &car[4] * &hurwitz * &f * &g * &resultant;
    let product = check(&det);
    assert_eq!(
        product.factors.iter().filter(|(h, _)| h.len() > 1).count(),
        check(&hurwitz)
            .factors
            .iter()
            .filter(|(h, _)| h.len() > 1)
            .count()
            + 1
    );
    assert!(
        product
            .factors
            .iter()
            .any(|(h, _)| *h == resultant.unit_normal())
    );
}

/// Coefficients that need several primes.
#[test]
fn huge_coefficients() {
    let ring = ring(3);
    let big = (BigInt::one() << 500u32) + 7u32;
    let f = poly(ring, "a^2*b + c^3").mul_integer(&big) + poly(ring, "a - 1");
    let g = poly(ring, "a^2*c - 5*b^2") + Polynomial::constant(ring, big);
    let product = check(&(&f * &g));
    let mut wanted = vec![(f.unit_normal(), 1), (g.unit_normal(), 1)];
    wanted.sort();
    let mut found = product.factors;
    found.sort();
    assert_eq!(found, wanted);
}

#[test]
fn budgets_are_kept() {
    let ring = ring(4);
    let f = poly(
        ring,
        "(a^3*b^2 + c^4 - d)*(a^2*d^3 - c^2 + b^2)*(a^2 + b^3*c - 7*d^2)",
    );
    assert_eq!(
        f.factor_within(&Budget::new(usize::MAX, u64::MAX, 500)),
        Err(Error::BudgetExceeded(Resource::Steps))
    );
    assert_eq!(
        f.factor_within(&Budget::default()).unwrap().factors.len(),
        3
    );
    let square = f.pow(2);
    assert_eq!(
        square.square_free_factorization_within(&Budget::new(usize::MAX, u64::MAX, 500)),
        Err(Error::BudgetExceeded(Resource::Steps))
    );
}
