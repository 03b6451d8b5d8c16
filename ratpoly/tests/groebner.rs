//! Gröbner bases, ideal membership, elimination: published bases, laws on generated ideals, refusals.

use proptest::prelude::*;
use ratpoly::{
    BigInt, Budget, Error, GroebnerBasis, Ideal, Order, Polynomial, RationalFunction, Resource,
    Ring, normal_form, relations, relations_within,
};

fn parse(ring: Ring, texts: &[&str]) -> Vec<Polynomial> {
    let parse = |text: &&str| Polynomial::parse(ring, text).unwrap();
    texts.iter().map(parse).collect()
}

fn basis(ring: Ring, texts: &[&str]) -> GroebnerBasis {
    GroebnerBasis::with_cofactors(ring, &parse(ring, texts), &Budget::default()).unwrap()
}

fn shown(basis: &GroebnerBasis) -> Vec<String> {
    basis.elements().iter().map(ToString::to_string).collect()
}

/// What every basis must satisfy; slow and by the definition only.
fn assert_is_reduced_basis(basis: &GroebnerBasis) {
    let budget = Budget::default();
    let elements: Vec<&Polynomial> = basis.elements().iter().collect();
    for (i, f) in elements.iter().enumerate() {
        assert!(f.is_canonical());
        assert_eq!(f.content(), BigInt::from(1));
        assert!(f.leading_coefficient() > BigInt::from(0));
        for (j, g) in elements.iter().enumerate() {
            let lead = g.leading_monomial().unwrap();
            assert!(i == j || f.terms().all(|(m, _)| !lead.divides(&m)));
            // Buchberger's criterion, every pair.
            let (m, n) = (f.leading_monomial().unwrap(), lead);
            let lcm = m.lcm(&n);
            let left = f.mul_term(&lcm.checked_div(&m).unwrap(), &g.leading_coefficient());
            let right = g.mul_term(&lcm.checked_div(&n).unwrap(), &f.leading_coefficient());
            let spoly = left.unwrap() - right.unwrap();
            let form = normal_form(&spoly, &elements, &budget).unwrap();
            assert!(form.remainder.is_zero());
        }
    }
    for g in basis.generators() {
        assert!(basis.contains(g, &budget).unwrap());
    }
    for (i, element) in basis.elements().iter().enumerate() {
        let origin = basis.cofactors_of(i).unwrap();
        assert!(origin.remainder.is_zero());
        assert!(origin.verify(element, basis.generators()).unwrap());
    }
}

#[test]
fn cox_little_oshea_section_2_7() {
    // Ideals, Varieties, and Algorithms, section 2.7, example 1: (x^3 - 2xy, x^2 y - 2y^2 + x) in grlex.
    let ring = Ring::new(["x", "y"], Order::Grlex).unwrap();
    let basis = basis(ring, &["x^3 - 2*x*y", "x^2*y - 2*y^2 + x"]);
    assert_eq!(shown(&basis), ["x^2", "x*y", "2*y^2 - x"]);
    assert_is_reduced_basis(&basis);
}

#[test]
fn cox_little_oshea_section_3_1() {
    // Section 3.1, system (4): x^2 + y + z = x + y^2 + z = x + y + z^2 = 1 in lex.
    let ring = Ring::new(["x", "y", "z"], Order::Lex).unwrap();
    let basis = basis(
        ring,
        &["x^2 + y + z - 1", "x + y^2 + z - 1", "x + y + z^2 - 1"],
    );
    assert_eq!(
        shown(&basis),
        [
            "x + y + z^2 - 1",
            "y^2 - y - z^2 + z",
            "2*y*z^2 + z^4 - z^2",
            "z^6 - 4*z^4 + 4*z^3 - z^2",
        ]
    );
    assert_is_reduced_basis(&basis);
}

#[test]
fn twisted_cubic() {
    // Cox, Little, O'Shea, section 3.3: the implicit equations of (t, t^2, t^3).
    let ring = Ring::new(["t"], Order::Grevlex).unwrap();
    let f = |text| RationalFunction::parse(ring, text).unwrap();
    let cubic = relations(&[("x", f("t")), ("y", f("t^2")), ("z", f("t^3"))]).unwrap();
    let cubic: Vec<_> = cubic.iter().map(ToString::to_string).collect();
    assert_eq!(cubic, ["x^2 - y", "x*y - z", "y^2 - x*z"]);
}

#[test]
fn cyclic_4_and_katsura_3() {
    // Cyclic 4 (Davenport 1987): one-dimensional, seven elements in grevlex.
    let ring = Ring::new(["a", "b", "c", "d"], Order::Grevlex).unwrap();
    let cyclic = basis(
        ring,
        &[
            "a + b + c + d",
            "a*b + b*c + c*d + d*a",
            "a*b*c + b*c*d + c*d*a + d*a*b",
            "a*b*c*d - 1",
        ],
    );
    assert_is_reduced_basis(&cyclic);
    assert_eq!(cyclic.elements().len(), 7);
    // Katsura 3: finitely many zeros, 2^3 of them with multiplicity (Katsura 1986, Boege et al. 1986).
    let ring = Ring::new(["u0", "u1", "u2", "u3"], Order::Grevlex).unwrap();
    let katsura = basis(
        ring,
        &[
            "u0 + 2*u1 + 2*u2 + 2*u3 - 1",
            "u0^2 + 2*u1^2 + 2*u2^2 + 2*u3^2 - u0",
            "2*u0*u1 + 2*u1*u2 + 2*u2*u3 - u1",
            "u1^2 + 2*u0*u2 + 2*u1*u3 - u2",
        ],
    );
    assert_is_reduced_basis(&katsura);
    let leads: Vec<_> = katsura
        .elements()
        .iter()
        .map(|f| f.leading_monomial().unwrap())
        .collect();
    let mut standard = 0;
    for code in 0..10_u32.pow(4) {
        let e: Vec<u32> = (0..4).map(|k| code / 10_u32.pow(k) % 10).collect();
        let e = ratpoly::Monomial::new(e);
        standard += u32::from(leads.iter().all(|m| !m.divides(&e)));
    }
    assert_eq!(standard, 8);
}

#[test]
fn quarter_car_parameters_satisfy_one_relation() {
    // Schiehlen, eq. (47): five quotients of five parameters, one hidden dependence.
    let ring = Ring::new(["cA", "cR", "dA", "mA", "mR"], Order::Lex).unwrap();
    let f = |text| RationalFunction::parse(ring, text).unwrap();
    let quotients = [
        ("a", f("cA/mA")),
        ("b", f("cA/mR")),
        ("c", f("cR/mR")),
        ("d", f("dA/mA")),
        ("e", f("dA/mR")),
    ];
    let found = relations(&quotients).unwrap();
    assert_eq!(found.len(), 1);
    assert_eq!(found[0].to_string(), "a*e - b*d");
    // Without e there is none.
    assert!(relations(&quotients[..4]).unwrap().is_empty());
}

#[test]
fn relations_of_special_functions() {
    let ring = Ring::new(["x", "y"], Order::Grevlex).unwrap();
    let f = |text| RationalFunction::parse(ring, text).unwrap();
    let show = |list: &[(&str, RationalFunction)]| {
        let found = relations(list).unwrap();
        found.iter().map(ToString::to_string).collect::<Vec<_>>()
    };
    assert!(show(&[]).is_empty());
    assert_eq!(show(&[("k", f("0"))]), ["k"]);
    assert_eq!(show(&[("k", f("2/3"))]), ["3*k - 2"]);
    assert_eq!(show(&[("x", f("y")), ("y", f("y"))]), ["x - y"]);
    assert_eq!(
        show(&[("p", f("x^2/y^3")), ("q", f("y^3/x^2"))]),
        ["p*q - 1"]
    );
    // Without the saturation the zero of the denominator would add a false component.
    assert_eq!(
        show(&[("p", f("x/(x + y)")), ("q", f("y/(x + y)"))]),
        ["p + q - 1"]
    );
}

#[test]
fn whole_ring_zero_ideal_and_zero_generators() {
    let ring = Ring::new(["x", "y"], Order::Lex).unwrap();
    let whole = basis(ring, &["x*y - 1", "x", "y^5 + x"]);
    assert_eq!(shown(&whole), ["1"]);
    assert!(whole.is_whole_ring());
    assert_is_reduced_basis(&whole);
    let zero = basis(ring, &["0", "0"]);
    assert!(zero.elements().is_empty() && !zero.is_whole_ring());
    let f = Polynomial::parse(ring, "3*x - y").unwrap();
    let form = zero.membership(&f, &Budget::default()).unwrap();
    assert_eq!(form.remainder, f);
    assert_eq!(form.cofactors.len(), 2);
    assert!(form.verify(&f, zero.generators()).unwrap());
    assert_eq!(
        shown(&basis(ring, &["-4*x + 6*y", "2*x - 3*y"])),
        ["2*x - 3*y"]
    );
}

#[test]
fn radical_membership_and_saturation() {
    let ring = Ring::new(["x", "y"], Order::Grevlex).unwrap();
    let budget = Budget::default();
    let p = |text| Polynomial::parse(ring, text).unwrap();
    // Cox, Little, O'Shea, section 4.2: y - x^2 + 1 in the radical of (xy^2 + 2y^2, x^4 - 2x^2 + 1).
    let ideal = Ideal::new(ring, [p("x*y^2 + 2*y^2"), p("x^4 - 2*x^2 + 1")]).unwrap();
    assert!(!ideal.contains(&p("y - x^2 + 1"), &budget).unwrap());
    assert!(ideal.radical_contains(&p("y - x^2 + 1"), &budget).unwrap());
    assert!(!ideal.radical_contains(&p("y - x"), &budget).unwrap());
    let ideal = Ideal::new(ring, [p("x^3*y - x^3")]).unwrap();
    let line = Ideal::new(ring, [p("y - 1")]).unwrap();
    assert!(
        ideal
            .saturate(&p("x"), &budget)
            .unwrap()
            .is_same_as(&line, &budget)
            .unwrap()
    );
    assert!(!ideal.is_same_as(&line, &budget).unwrap());
}

#[test]
fn a_false_certificate_is_refused() {
    let ring = Ring::new(["x", "y"], Order::Lex).unwrap();
    let basis = basis(ring, &["x^2 - y", "x*y - 1"]);
    let f = Polynomial::parse(ring, "x^3 - 1").unwrap();
    let form = basis.membership(&f, &Budget::default()).unwrap();
    assert!(form.remainder.is_zero());
    assert!(form.verify(&f, basis.generators()).unwrap());
    let mut wrong = form.clone();
    wrong.cofactors.swap(0, 1);
    assert!(!wrong.verify(&f, basis.generators()).unwrap());
    let mut trivial = form.clone();
    trivial.multiplier = 0.into();
    trivial.cofactors = vec![Polynomial::zero(ring); 2];
    assert!(!trivial.verify(&f, basis.generators()).unwrap());
    assert_eq!(
        form.verify(&f, &basis.generators()[..1]),
        Err(Error::WrongLength {
            expected: 2,
            found: 1
        })
    );
}

#[test]
fn refusals() {
    let (ring, other) = (
        Ring::new(["x", "y"], Order::Lex).unwrap(),
        Ring::new(["x", "y"], Order::Grlex).unwrap(),
    );
    let budget = Budget::default();
    let (f, g) = (
        Polynomial::variable(ring, 0),
        Polynomial::variable(other, 0),
    );
    let mixed = GroebnerBasis::new(ring, &[f.clone(), g.clone()], &budget);
    assert_eq!(mixed.unwrap_err(), Error::RingMismatch);
    assert_eq!(normal_form(&f, &[&g], &budget), Err(Error::RingMismatch));
    let zero = Polynomial::zero(ring);
    assert_eq!(
        normal_form(&f, &[&zero], &budget),
        Err(Error::DivisionByZero)
    );
    let plain = GroebnerBasis::new(ring, std::slice::from_ref(&f), &budget).unwrap();
    assert!(matches!(
        plain.membership(&f, &budget),
        Err(Error::Unsupported(_))
    ));
    let ideal = Ideal::new(ring, [f.clone()]).unwrap();
    assert_eq!(
        ideal.eliminate(&[2], &budget).unwrap_err(),
        Error::VariableOutOfRange(2)
    );
    let twice = [
        ("k", RationalFunction::from(f.clone())),
        ("k", f.clone().into()),
    ];
    assert_eq!(relations(&twice), Err(Error::DuplicateVariable("k".into())));
    let mixed = [("k", RationalFunction::from(f)), ("l", g.into())];
    assert_eq!(relations(&mixed), Err(Error::RingMismatch));
}

#[test]
fn budgets_stop_the_search() {
    let ring = Ring::new(["x", "y", "z"], Order::Lex).unwrap();
    let generators = parse(
        ring,
        &["x^5 + y^4 + z^3 - 1", "x^3 + y^3 + z^2 - 1", "x*y*z - 7"],
    );
    let steps = GroebnerBasis::new(ring, &generators, &Budget::new(1000, 1000, 500));
    assert_eq!(steps.unwrap_err(), Error::BudgetExceeded(Resource::Steps));
    let terms = GroebnerBasis::new(ring, &generators, &Budget::new(4, 1000, u64::MAX));
    assert_eq!(terms.unwrap_err(), Error::BudgetExceeded(Resource::Terms));
    let bits = GroebnerBasis::new(ring, &generators, &Budget::new(1000, 8, 10_000_000));
    assert_eq!(bits.unwrap_err(), Error::BudgetExceeded(Resource::Bits));
    let f = |text| RationalFunction::parse(ring, text).unwrap();
    let list = [
        ("a", f("(x^3 - y)/(z + x)")),
        ("b", f("y^2/(x - z)")),
        ("c", f("x*y/z")),
        ("d", f("z^3 - x")),
    ];
    let few = relations_within(&list, &Budget::new(1000, 1000, 100));
    assert_eq!(few, Err(Error::BudgetExceeded(Resource::Steps)));
}

/// Few and short polynomials of which the lexicographic basis has coefficients of thousands of digits on the
/// way: the steps count the length of the coefficients, so that they run out in a fraction of a second and not
/// the patience of the caller.
#[test]
fn long_coefficients_are_paid_for() {
    let ring = Ring::new(["x", "y", "z"], Order::Lex).unwrap();
    let texts = [
        "17*x^2 - 31*x*y + 42*x*z - 8*y^2 + 29*y*z - 13*z^2 + 5*x - 44*y + 37*z - 19",
        "-23*x^2 + 11*x*y + 9*x*z + 35*y^2 - 48*y*z + 26*z^2 - 14*x + 3*y - 41*z + 7",
        "39*x^2 + 45*x*y - 12*x*z - 21*y^2 + 16*y*z + 33*z^2 + 28*x - 36*y + 10*z - 47",
    ];
    let generators = parse(ring, &texts);
    let steps = Err(Error::BudgetExceeded(Resource::Steps));
    for limit in [0, 1_000_000, 100_000_000] {
        let budget = Budget::new(usize::MAX, u64::MAX, limit);
        let found = GroebnerBasis::new(ring, &generators, &budget);
        assert_eq!(found.map(|_| ()), steps);
        let budget = Budget::new(usize::MAX, u64::MAX, limit);
        let found = GroebnerBasis::with_cofactors(ring, &generators, &budget);
        assert_eq!(found.map(|_| ()), steps);
    }
}

fn small(ring: Ring) -> impl Strategy<Value = Polynomial> {
    let term = (prop::collection::vec(0u32..3, 3), -3i32..4);
    prop::collection::vec(term, 0..4).prop_map(move |terms| {
        Polynomial::from_terms(ring, terms.into_iter().map(|(e, c)| (e, BigInt::from(c)))).unwrap()
    })
}

fn case() -> impl Strategy<Value = (Vec<Polynomial>, Polynomial)> {
    prop::sample::select(vec![Order::Lex, Order::Grlex, Order::Grevlex]).prop_flat_map(|order| {
        let ring = Ring::new(["x", "y", "z"], order).unwrap();
        (prop::collection::vec(small(ring), 0..4), small(ring))
    })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(100))]

    #[test]
    fn every_basis_is_reduced_and_every_certificate_multiplies_out((generators, f) in case()) {
        let ring = f.ring();
        let budget = Budget::new(300, 600, 2_000_000);
        // Some generated ideals are too hard for the budget: refused, not guessed.
        let Ok(basis) = GroebnerBasis::with_cofactors(ring, &generators, &budget) else { return Ok(()) };
        assert_is_reduced_basis(&basis);
        let plain = GroebnerBasis::new(ring, &generators, &Budget::default()).unwrap();
        prop_assert_eq!(plain.elements(), basis.elements());
        let form = basis.membership(&f, &Budget::default()).unwrap();
        prop_assert!(form.verify(&f, &generators).unwrap());
        // f times a generator plus the remainder has the same normal form as the remainder.
        if let Some(g) = generators.first() {
            let shifted = &form.remainder + &f * g;
            let again = basis.normal_form(&shifted, &Budget::default()).unwrap();
            prop_assert_eq!(again.remainder, form.remainder.mul_integer(&again.multiplier));
        }
        let mut reversed = generators.clone();
        reversed.reverse();
        let reversed = GroebnerBasis::new(ring, &reversed, &Budget::default()).unwrap();
        prop_assert_eq!(reversed.elements(), basis.elements());
    }

    #[test]
    fn elimination_agrees_with_lex((generators, _) in case()) {
        let ring = Ring::new(["x", "y", "z"], Order::Lex).unwrap();
        let generators: Vec<_> = generators.iter().map(|g| g.to_ring(ring).unwrap()).collect();
        let budget = Budget::new(300, 600, 2_000_000);
        let Ok(basis) = GroebnerBasis::new(ring, &generators, &budget) else { return Ok(()) };
        let free = |f: &&Polynomial| f.degree(0) == Some(0);
        let expected: Vec<Polynomial> = basis.elements().iter().filter(free).cloned().collect();
        let ideal = Ideal::new(ring, generators).unwrap();
        let found = ideal.eliminate(&[0], &Budget::default()).unwrap();
        prop_assert_eq!(found.generators(), &expected[..]);
    }
}
