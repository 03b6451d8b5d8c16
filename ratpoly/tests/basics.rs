//! Worked examples of the public interface.

use ratpoly::{BigInt, BigRational, Error, Order, Polynomial, RationalFunction, Ring, gcd, lcm};

fn ring() -> Ring {
    Ring::new(["x", "y", "z"], Order::Lex).unwrap()
}

fn p(text: &str) -> Polynomial {
    Polynomial::parse(ring(), text).unwrap()
}

fn r(text: &str) -> RationalFunction {
    RationalFunction::parse(ring(), text).unwrap()
}

#[test]
fn arithmetic_and_display() {
    assert_eq!(((p("x + y")) * p("x - y")).to_string(), "x^2 - y^2");
    assert_eq!(p("x + 1").pow(3).to_string(), "x^3 + 3*x^2 + 3*x + 1");
    assert!((p("x") - p("x")).is_zero());
    assert_eq!(p("2*x*(y - 3) + 6*x"), p("2*x*y"));
}

#[test]
fn division_and_gcd() {
    let (f, g) = (p("x^2*y - 3*z + 1"), p("x*y^3 + z^2 - 5"));
    assert_eq!((&f * &g).div_exact(&f), Some(g.clone()));
    assert_eq!(f.div_exact(&g), None);
    let h = p("2*x*z - y");
    assert_eq!(gcd(&(&f * &h), &(&g * &h)), h);
    assert_eq!(gcd(&p("6*x^2*y"), &p("4*x*y^2 + 2*x")), p("2*x"));
    assert_eq!(lcm(&p("2*x*y"), &p("3*y*z")), p("6*x*y*z"));
    assert_eq!(
        p("x^3 - 1").pseudo_remainder(&p("2*x + y"), 0).unwrap(),
        p("-y^3 - 8")
    );
    let (q, rest) = p("x^2*y + x*y^2 + y^2")
        .div_rem(&[&p("x*y - 1"), &p("y^2 - 1")])
        .unwrap();
    assert_eq!(
        (q[0].clone(), q[1].clone(), rest),
        (p("x + y"), p("1"), p("x + y + 1"))
    );
}

#[test]
fn rational_functions() {
    assert_eq!(r("x/(x + y) + y/(x + y)"), RationalFunction::one(ring()));
    assert_eq!((r("1/x") - r("1/y")).to_string(), "(-x + y)/(x*y)");
    assert_eq!(
        r("1/2").as_constant(),
        Some(BigRational::new(1.into(), 2.into()))
    );
    assert_eq!(r("x/y").derivative(1).unwrap(), r("-x/y^2"));
    assert_eq!(
        r("1/x").checked_div(&r("x - x")),
        Err(Error::DivisionByZero)
    );
    assert_eq!(
        r("x/(y - 1)").substitute(&[(1, r("1/x"))]).unwrap(),
        r("x^2/(1 - x)")
    );
    let point: Vec<BigRational> = [1, 2, 3].map(|v| BigInt::from(v).into()).into();
    assert_eq!(
        r("(x + z)/y").evaluate(&point).unwrap(),
        BigInt::from(2).into()
    );
}
