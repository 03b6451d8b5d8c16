//! Laws of the greatest common divisor, fixed results from the literature, and a slow plain definition.

use num_bigint::BigInt;
use num_traits::{One, Zero};
use proptest::prelude::*;
use ratpoly::modular::two_adic_primes;
use ratpoly::{
    Budget, Error, Order, Polynomial, Resource, Ring, gcd, gcd_cofactors, gcd_of, gcd_within, lcm,
};

const NAMES: [&str; 9] = ["a", "b", "c", "d", "e", "f", "g", "h", "i"];

fn ring(variables: usize, order: Order) -> Ring {
    Ring::new(NAMES[..variables].iter().copied(), order).unwrap()
}

fn poly(ring: Ring, text: &str) -> Polynomial {
    Polynomial::parse(ring, text).unwrap()
}

/// Coefficients of all sizes: tiny, at the edge of the machine word, huge.
fn coefficient() -> impl Strategy<Value = BigInt> {
    prop_oneof![
        6 => (-4i64..=4).prop_map(BigInt::from),
        2 => any::<i64>().prop_map(BigInt::from),
        1 => (-2i64..=2).prop_map(|d| BigInt::from(i64::MAX) + d),
        1 => (any::<i64>(), 1u32..300).prop_map(|(c, shift)| BigInt::from(c) << shift),
    ]
}

/// A polynomial in one of the orders with 1 to 6 of 9 variables, few terms, mixed degrees.
fn polynomials(count: usize) -> impl Strategy<Value = Vec<Polynomial>> {
    (1usize..=6, 0usize..3, 1u32..5).prop_flat_map(move |(n, order, degree)| {
        let order = [Order::Lex, Order::Grlex, Order::Grevlex][order];
        let term = (prop::collection::vec(0..=degree, n), coefficient());
        let terms = prop::collection::vec(term, 0..8);
        prop::collection::vec(terms, count).prop_map(move |lists| {
            lists
                .into_iter()
                .map(|list| Polynomial::from_terms(ring(n, order), list).unwrap())
                .collect()
        })
    })
}

/// Up to so many terms with small coefficients in three variables.
fn few_terms_of(most: usize) -> impl Strategy<Value = Polynomial> {
    let term = (prop::collection::vec(0u32..3, 3), -6i64..=6);
    prop::collection::vec(term, 0..=most).prop_map(|list| {
        let list = list.into_iter().map(|(e, c)| (e, BigInt::from(c)));
        Polynomial::from_terms(ring(3, Order::Lex), list).unwrap()
    })
}

/// The gcd by Euclid's algorithm with primitive remainders, variable by variable, and nothing else.
fn plain_gcd(f: &Polynomial, g: &Polynomial) -> Polynomial {
    if f.is_zero() || g.is_zero() {
        return (f + g).unit_normal();
    }
    let occurring = [f.variables_occurring(), g.variables_occurring()].concat();
    let Some(&v) = occurring.iter().min() else {
        let (a, b) = (f.as_constant().unwrap(), g.as_constant().unwrap());
        return Polynomial::constant(f.ring(), num_integer::Integer::gcd(&a, &b));
    };
    let content = |p: &Polynomial| {
        p.coefficients_in(v)
            .iter()
            .fold(Polynomial::zero(p.ring()), |c, d| plain_gcd(&c, d))
    };
    let primitive = |p: &Polynomial| {
        if p.is_zero() {
            p.clone()
        } else {
            p.div_exact(&content(p)).unwrap()
        }
    };
    let (mut a, mut b) = (primitive(f), primitive(g));
    if a.degree(v) < b.degree(v) {
        std::mem::swap(&mut a, &mut b);
    }
    while !b.is_zero() {
        let r = primitive(&a.pseudo_remainder(&b, v).unwrap());
        (a, b) = (b, r);
    }
    let content = plain_gcd(&content(f), &content(g));
    if a.degree(v) == Some(0) {
        content
    } else {
        (a * content).unit_normal()
    }
}

/// The defining properties, with the cofactors proven coprime by the function itself and, on small
/// operands, by the plain definition.
fn check(f: &Polynomial, g: &Polynomial) -> Polynomial {
    let found = gcd_cofactors(f, g);
    let d = found.gcd.clone();
    assert!(d.is_canonical() && found.first.is_canonical() && found.second.is_canonical());
    assert_eq!(d, gcd(f, g), "gcd and cofactors agree");
    assert_eq!(d, gcd(g, f), "symmetric");
    assert_eq!(d, d.unit_normal(), "positive");
    assert_eq!(
        (&found.first * &d, &found.second * &d),
        (f.clone(), g.clone())
    );
    if !d.is_zero() {
        assert!(f.is_zero() || g.is_zero() || gcd(&found.first, &found.second).is_one());
    } else {
        assert!(f.is_zero() && g.is_zero());
    }
    d
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(300))]

    #[test]
    fn common_factors_come_out(p in polynomials(3)) {
        let (f, g, h) = (&p[0], &p[1], &p[2]);
        let small = check(f, g);
        let large = check(&(f * h), &(g * h));
        prop_assert_eq!(large, (small * h).unit_normal());
    }

    #[test]
    fn repeated_and_shared_factors(p in polynomials(3), i in 0u32..3, j in 0u32..3) {
        let (f, g, h) = (&p[0], &p[1], &p[2]);
        let left = f.pow(2) * g.pow(i) * h;
        let right = f * g.pow(j) * h.pow(2);
        let d = check(&left, &right);
        if !f.is_zero() && !g.is_zero() && !h.is_zero() {
            prop_assert!(d.div_exact(&(f * g.pow(i.min(j)) * h)).is_some());
        }
    }

    #[test]
    fn equal_and_special_arguments(p in polynomials(1), c in coefficient()) {
        let f = &p[0];
        let (zero, one) = (Polynomial::zero(f.ring()), Polynomial::one(f.ring()));
        let constant = Polynomial::constant(f.ring(), c.clone());
        prop_assert_eq!(check(f, f), f.unit_normal());
        prop_assert_eq!(check(f, &-f), f.unit_normal());
        prop_assert_eq!(check(f, &zero), f.unit_normal());
        prop_assert!(check(f, &one).is_one());
        let content = Polynomial::constant(f.ring(), num_integer::Integer::gcd(&f.content(), &c));
        prop_assert_eq!(check(f, &constant), if c.is_zero() { f.unit_normal() } else { content });
        prop_assert_eq!(check(&(f * f), f), f.unit_normal());
        prop_assert_eq!(check(&(f * &constant), f), if c.is_zero() { f.unit_normal() } else { check(f, f) });
        let sum = f + &one;
        prop_assert!(f.is_zero() || check(f, &sum).is_one() || sum.is_zero());
    }

    #[test]
    fn few_terms(
        f in few_terms_of(4),
        g in few_terms_of(4),
        h in few_terms_of(3),
        t in few_terms_of(1),
    ) {
        // What structure alone decides: a term, a divisor of the other, a letter that only one has.
        for (p, q) in [
            (f.clone(), g.clone()),
            (f.clone(), t.clone()),
            (&f * &t, &g * &t),
            (&f * &h, h.clone()),
            (&f * &t, &f * &h),
            (&f * &h, &g * &h),
        ] {
            prop_assert_eq!(check(&p, &q), plain_gcd(&p, &q));
        }
    }

    #[test]
    fn least_common_multiple(p in polynomials(2)) {
        let (f, g) = (&p[0], &p[1]);
        prop_assert_eq!(lcm(f, g) * gcd(f, g), (f * g).unit_normal());
    }

    #[test]
    fn content_and_primitive_part(p in polynomials(2), v in 0usize..6) {
        let v = v % p[0].ring().len();
        let (f, c) = (&p[0], p[1].coefficients_in(v).pop().unwrap_or_else(|| Polynomial::zero(p[0].ring())));
        let product = f * &c;
        prop_assert_eq!(product.content_in(v), (f.content_in(v) * &c).unit_normal());
        prop_assert_eq!(gcd_of(f.ring(), &product.coefficients_in(v)), product.content_in(v));
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(200))]

    #[test]
    fn agrees_with_the_plain_definition(
        (n, lists) in (1usize..4).prop_flat_map(|n| {
            let terms = prop::collection::vec((prop::collection::vec(0u32..3, n), -3i64..=3), 0..5);
            (Just(n), prop::collection::vec(terms, 3))
        })
    ) {
        let ring = ring(n, Order::Lex);
        let p: Vec<Polynomial> = lists
            .into_iter()
            .map(|list| Polynomial::from_terms(ring, list.into_iter().map(|(e, c)| (e, c.into()))).unwrap())
            .collect();
        let (f, g) = (&p[0] * &p[2], &p[1] * &p[2]);
        prop_assert_eq!(check(&f, &g), plain_gcd(&f, &g));
    }
}

/// Euclid's worst friend: D. E. Knuth, The Art of Computer Programming 2, section 4.6.1, the classical
/// pair of polynomials with huge intermediate coefficients and the gcd 1.
#[test]
fn knuth_classical_pair() {
    let ring = ring(1, Order::Lex);
    let f = poly(ring, "a^8 + a^6 - 3*a^4 - 3*a^3 + 8*a^2 + 2*a - 5");
    let g = poly(ring, "3*a^6 + 5*a^4 - 4*a^2 - 9*a + 21");
    assert!(check(&f, &g).is_one());
    let h = poly(ring, "7*a^5 - 11*a + 13");
    assert_eq!(check(&(&f * &h), &(&g * &h)), h);
}

/// Families in a growing number of variables, of the kinds by which gcd algorithms have been compared since
/// W. S. Brown, *On Euclid's algorithm and the computation of polynomial greatest common divisors*, 1971:
/// gcd trivial, linear, sparse, dense. The polynomials themselves are made up here.
#[test]
fn families_of_known_gcd() {
    for v in 2..=8 {
        let ring = ring(v + 1, Order::Lex);
        let x = Polynomial::variable(ring, 0);
        let sum = (1..=v).fold(Polynomial::zero(ring), |s, i| {
            s + Polynomial::variable(ring, i)
        });
        let squares = (1..=v).fold(Polynomial::zero(ring), |s, i| {
            s + Polynomial::variable(ring, i).pow(2)
        });
        let product = (1..=v).fold(Polynomial::one(ring), |s, i| {
            s * Polynomial::variable(ring, i)
        });
        let (one, two) = (Polynomial::one(ring), Polynomial::constant(ring, 2));
        // 1: gcd 1.
        let f = (&x + &sum + &one) * (&x + &sum - &two);
        let g = (x.pow(2) + &squares + &one)
            * (Polynomial::constant(ring, 3) * &x * Polynomial::variable(ring, 1)
                + Polynomial::variable(ring, 1).pow(2)
                - &one);
        assert!(check(&f, &g).is_one(), "{v}");
        // 2: a linear gcd.
        let d = (&x + &sum + &one).pow(2);
        let f = &d * (&x - &sum - &two).pow(2);
        let g = &d * (&x + &sum + &two).pow(2);
        assert_eq!(check(&f, &g), d, "{v}");
        // 5: sparse with a product in the leading coefficient.
        let d = &x * &product - &one;
        let f = &d * (&x * &product + Polynomial::constant(ring, 3));
        let g = &d * (&x * &product - Polynomial::constant(ring, 3));
        assert_eq!(check(&f, &g), d, "{v}");
        // 7: a dense power.
        let d = (&x - &product + &one).pow(2);
        let f = &d * (&x + &product + Polynomial::constant(ring, 3));
        assert_eq!(check(&f, &(&d * (&x + &sum))), d, "{v}");
    }
}

/// The primes that the modular images use, in all their sequences: they divide leading coefficients, a
/// coefficient of the gcd itself, and the resultant of the cofactors, which then are equal modulo each.
#[test]
fn unlucky_primes_of_every_sequence() {
    let ring = ring(3, Order::Grevlex);
    let all = (20..=56).flat_map(|k| two_adic_primes(k).take(2));
    let all: BigInt = all.map(BigInt::from).product();
    let times = |text: &str| poly(ring, text).mul_integer(&all);
    let d = poly(ring, "a + c") + times("b");
    let pairs = [
        (times("a") + poly(ring, "b + 1"), poly(ring, "a - b")),
        (
            poly(ring, "a") + times("b"),
            poly(ring, "a") + times("2*b + c"),
        ),
        (
            times("a^2 + 1") + poly(ring, "b"),
            times("a^2 - c") - poly(ring, "b"),
        ),
    ];
    for (f, g) in pairs {
        assert!(check(&f, &g).is_one());
        assert_eq!(check(&(&d * &f), &(&d * &g)), d);
    }
}

/// Small points of evaluation are bad ones: there leading coefficients vanish, cofactors have a common
/// factor, or the polynomials are equal.
#[test]
fn unlucky_points() {
    let ring = ring(3, Order::Lex);
    let (a, b, c) = (poly(ring, "a"), poly(ring, "b"), poly(ring, "c"));
    let product = |x: &Polynomial| {
        let factors = (-12..=12).map(|k| x - &Polynomial::constant(ring, k));
        factors.fold(Polynomial::one(ring), |p, q| p * q)
    };
    let (in_b, in_c) = (product(&b), product(&c));
    let d = &(&in_b * &a.pow(2)) + &(&c + &a);
    let pairs = [
        (&a + &in_b, &a + &(&in_b * &c)),
        (&a + &in_b, &a - &in_c),
        (&in_c * &a + Polynomial::one(ring), &in_c * &a + &b),
        (&a + &b, &(&a + &b) + &(&in_b * &in_c)),
    ];
    for (f, g) in pairs {
        assert!(check(&f, &g).is_one());
        assert_eq!(check(&(&d * &f), &(&d * &g)), d);
    }
}

/// Cyclotomic exponents: gcd(x^m - 1, x^n - 1) = x^gcd(m, n) - 1, also with a stride that keeps it cheap.
#[test]
fn cyclotomic_exponents() {
    let ring = ring(2, Order::Grevlex);
    for (m, n, d) in [
        (105, 45, 15),
        (64, 48, 16),
        (30_000_000, 20_000_000, 10_000_000),
        (1, 7, 1),
    ] {
        let power = |e: u32| Polynomial::variable(ring, 0).pow(e) - Polynomial::one(ring);
        assert_eq!(check(&power(m), &power(n)), power(d));
        let homogeneous =
            |e: u32| Polynomial::variable(ring, 0).pow(e) - Polynomial::variable(ring, 1).pow(e);
        assert_eq!(check(&homogeneous(m), &homogeneous(n)), homogeneous(d));
    }
}

/// Coefficients of thousands of bits need many primes.
#[test]
fn huge_coefficients() {
    let ring = ring(3, Order::Lex);
    let big = |shift: u32| (BigInt::one() << shift) - BigInt::from(shift);
    let p = |a: u32, b: u32, text: &str| {
        poly(ring, text).mul_integer(&big(a)) + Polynomial::constant(ring, big(b))
    };
    let (f, g, h) = (
        p(3000, 17, "a*b - c^2"),
        p(61, 4000, "a^2 + b*c"),
        p(1000, 999, "a*c + b^2"),
    );
    assert_eq!(check(&(&f * &h), &(&g * &h)), h);
    assert!(check(&f, &g).is_one());
}

/// Powers of two have small residues modulo primes just below one: the first prime shows coefficients
/// that look final and are not. Found by the law tests as a hundredfold slowdown.
#[test]
fn coefficients_that_look_small() {
    let ring = ring(3, Order::Grevlex);
    let d = poly(
        ring,
        "9223372036854775809*a^4*b*c^5 + a^4*b^4*c + 2*a^3*b^2*c^3 + 2*a*b*c^5 + 2*b^2*c^2 - 3*b*c^3",
    );
    let f = &d * poly(ring, "9223372036854775805*a^2*b^2*c^3 + b^2 + 2*a");
    let g = &d * poly(ring, "9223372036854775809*a^3*b - 3*b*c^2 + 2");
    let budget = Budget::new(usize::MAX, u64::MAX, 20_000);
    assert_eq!(
        gcd_within(&f, &g, &budget).map(|found| found == d),
        Ok(true)
    );
}

/// A gcd with a content in every variable, of which the main variable's images see nothing.
#[test]
fn contents_in_every_variable() {
    let ring = ring(4, Order::Lex);
    let factors = [
        "a^2 + a + 2",
        "b^3 - b + 1",
        "c^2 + 5",
        "d^4 + d + 1",
        "a*b + c",
        "b*c*d - 1",
    ];
    let d = factors
        .iter()
        .fold(Polynomial::one(ring), |d, f| d * poly(ring, f));
    let f = &d * poly(ring, "a + b^2 + c + d^3") * poly(ring, "a^5 + 3");
    let g = &d * poly(ring, "a^2*c + b + d") * poly(ring, "b^5 + 3");
    assert_eq!(check(&f, &g), d);
}

/// A dense common factor: more terms than half the group that its exponents live in.
#[test]
fn dense_common_factor() {
    let ring = ring(3, Order::Grevlex);
    let d = (poly(ring, "a + 2*b - 3*c + 5")).pow(6) + poly(ring, "a*b*c");
    let f = &d * poly(ring, "a*b - c^3 + 1");
    let g = &d * poly(ring, "c*b - a^3 + 2");
    assert_eq!(check(&f, &g), d);
}

/// More monomials than a word-sized group has elements: the slow method takes over.
#[test]
fn too_many_variables_for_one_word() {
    let names: Vec<String> = (0..60).map(|i| format!("x{i}")).collect();
    let ring = Ring::new(names, Order::Lex).unwrap();
    let sum = |from: usize, to: usize| {
        (from..to).fold(Polynomial::one(ring), |s, i| {
            s + Polynomial::variable(ring, i)
        })
    };
    let (f, g, h) = (sum(0, 60), sum(0, 30) - sum(30, 60), sum(0, 59));
    assert_eq!(check(&(&f * &h), &(&g * &h)), h);
}

/// The coefficients of the operands are multiples of the first primes that are tried, so that these
/// primes lose degree, the gcd, or everything.
#[test]
fn unlucky_primes() {
    let ring = ring(2, Order::Lex);
    let primes: Vec<u64> = ratpoly::modular::two_adic_primes(32).take(4).collect();
    let m = primes.iter().fold(BigInt::one(), |m, &p| m * p);
    let constant = |c: &BigInt| Polynomial::constant(ring, c.clone());
    let (a, b) = (Polynomial::variable(ring, 0), Polynomial::variable(ring, 1));
    // Coprime, but equal modulo each of the primes.
    let f = &a * &b + &a.pow(2) + Polynomial::one(ring);
    let g = &f + constant(&m);
    assert!(check(&f, &g).is_one());
    // The leading coefficient of the gcd vanishes modulo the primes.
    let d = a.pow(2).mul_integer(&m) + &b + Polynomial::one(ring);
    assert_eq!(check(&(&d * &f), &(&d * &g)), d);
    // A coefficient in the middle vanishes modulo the first prime only.
    let d = a.pow(3) + a.mul_integer(&primes[0].into()) * &b + b.pow(2);
    assert_eq!(check(&(&d * &f), &(&d * (&g + &a))), d);
    // The cofactors have a common factor modulo the primes.
    assert_eq!(check(&(&d * &f), &(&d * &g)), d);
}

#[test]
fn budgets_are_kept() {
    let ring = ring(4, Order::Lex);
    let d = poly(ring, "(a + b + c + d + 1)^4");
    let (f, g) = (
        &d * poly(ring, "a^3 - b*c + d"),
        &d * poly(ring, "b^3 - a*d + c"),
    );
    let exceeded = gcd_within(&f, &g, &Budget::new(usize::MAX, u64::MAX, 100));
    assert_eq!(exceeded, Err(Error::BudgetExceeded(Resource::Steps)));
    assert_eq!(gcd_within(&f, &g, &Budget::default()), Ok(d));
    // Degrees for which no dense image can be made.
    let a = Polynomial::variable(ring, 0);
    let (f, g) = (
        a.pow(4_000_000_000) - &a + Polynomial::one(ring),
        a.pow(3_999_999_999) + Polynomial::constant(ring, 2),
    );
    assert_eq!(
        gcd_within(&f, &g, &Budget::default()),
        Err(Error::BudgetExceeded(Resource::Terms))
    );
}

/// Few terms of which the quotient has a thousand million: the budget stops the division, not the memory.
#[test]
fn long_quotients_are_paid_for() {
    let ring = ring(2, Order::Lex);
    let (f, g) = (poly(ring, "a^1000000000 + 1"), poly(ring, "a - 1"));
    let h = &f - Polynomial::constant(ring, 2);
    let terms = Err(Error::BudgetExceeded(Resource::Terms));
    for f in [&f, &h] {
        assert_eq!(gcd_within(f, &g, &Budget::default()), terms);
        let quotient = f.div_exact_within(&g, &Budget::default());
        assert_eq!(quotient.map(|_| ()), terms.clone().map(|_| ()));
    }
    let steps = Budget::new(usize::MAX, u64::MAX, 1000);
    assert_eq!(
        h.div_exact_within(&g, &steps),
        Err(Error::BudgetExceeded(Resource::Steps))
    );
    let (f, g) = (poly(ring, "a^10 - b^10"), poly(ring, "a - b"));
    assert_eq!(
        f.div_exact_within(&g, &Budget::new(10, 1, 20)),
        Ok(f.div_exact(&g))
    );
    let short = f.div_exact_within(&g, &Budget::new(9, 1, 20));
    assert_eq!(short, Err(Error::BudgetExceeded(Resource::Terms)));
    let zero = Polynomial::zero(ring);
    assert_eq!(f.div_exact_within(&zero, &Budget::default()), Ok(None));
}

#[test]
fn rings_do_not_mix() {
    let (f, g) = (
        Polynomial::one(ring(2, Order::Lex)),
        Polynomial::one(ring(3, Order::Lex)),
    );
    assert_eq!(
        gcd_within(&f, &g, &Budget::default()),
        Err(Error::RingMismatch)
    );
}

#[test]
fn of_many() {
    let ring = ring(3, Order::Lex);
    let list = [
        "6*a*b*(a + c)",
        "4*b^2*(a + c)*(b + c)",
        "0",
        "10*b*(a^2 - c^2)",
    ]
    .map(|text| poly(ring, text));
    assert_eq!(gcd_of(ring, &list), poly(ring, "2*b*(a + c)"));
    assert!(gcd_of(ring, []).is_zero());
    assert!(gcd_of(ring, &[-poly(ring, "a")]) == poly(ring, "a"));
}
