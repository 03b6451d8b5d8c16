//! Greatest common divisors: integer and monomial contents first, then the primitive remainder sequence
//! in one variable with contents by recursion (Collins 1967; Knuth, TAOCP 2, 4.6.1).

use crate::error::Error;
use crate::polynomial::Polynomial;
use num_integer::Integer as _;

/// The greatest common divisor, with a positive leading coefficient; `gcd(0, 0) = 0`.
///
/// # Panics
/// If the operands belong to different rings.
pub fn gcd(f: &Polynomial, g: &Polynomial) -> Polynomial {
    assert!(f.ring() == g.ring(), "{}", Error::RingMismatch);
    if f.is_zero() {
        return g.unit_normal();
    }
    if g.is_zero() {
        return f.unit_normal();
    }
    let ring = f.ring();
    let content = f.content().gcd(&g.content());
    let monomial = f.monomial_content().gcd(&g.monomial_content());
    let common = Polynomial::from_terms(ring, [(monomial, content)]).expect("a term of this ring");
    if f.len() == 1 || g.len() == 1 {
        return common;
    }
    let strip = |p: &Polynomial| {
        let term = Polynomial::from_terms(ring, [(p.monomial_content(), p.content())]);
        p.div_exact(&term.expect("a term of this ring"))
            .expect("the content divides")
    };
    let core = primitive_gcd(strip(f), strip(g));
    (core * common).unit_normal()
}

/// The least common multiple, with a positive leading coefficient; zero if an operand is.
///
/// # Panics
/// If the operands belong to different rings, or on an exponent overflow.
pub fn lcm(f: &Polynomial, g: &Polynomial) -> Polynomial {
    if f.is_zero() || g.is_zero() {
        return Polynomial::zero(f.ring());
    }
    let cofactor = f.div_exact(&gcd(f, g)).expect("the gcd divides");
    (cofactor * g).unit_normal()
}

/// The gcd of two nonzero polynomials, up to sign and integer content.
fn primitive_gcd(mut f: Polynomial, mut g: Polynomial) -> Polynomial {
    let ring = f.ring();
    // A variable that occurs in only one operand: the gcd divides all its coefficients there.
    let (in_f, in_g) = (f.variables_occurring(), g.variables_occurring());
    if let Some(&v) = in_f.iter().find(|v| !in_g.contains(v)) {
        return f.coefficients_in(v).iter().fold(g, |acc, c| gcd(&acc, c));
    }
    if let Some(&v) = in_g.iter().find(|v| !in_f.contains(v)) {
        return g.coefficients_in(v).iter().fold(f, |acc, c| gcd(&acc, c));
    }
    let Some(&v) = in_f.iter().min_by_key(|v| f.degree(**v).max(g.degree(**v))) else {
        return Polynomial::constant(ring, f.content().gcd(&g.content()));
    };
    let content_in = |p: &Polynomial| {
        p.coefficients_in(v)
            .iter()
            .fold(Polynomial::zero(ring), |acc, c| gcd(&acc, c))
    };
    let (cf, cg) = (content_in(&f), content_in(&g));
    let content = gcd(&cf, &cg);
    f = f.div_exact(&cf).expect("the content divides");
    g = g.div_exact(&cg).expect("the content divides");
    if f.degree(v) < g.degree(v) {
        std::mem::swap(&mut f, &mut g);
    }
    while !g.is_zero() {
        let r = f.pseudo_remainder(&g, v).unwrap_or_else(|e| panic!("{e}"));
        f = g;
        g = if r.is_zero() {
            r
        } else {
            let c = content_in(&r);
            r.div_exact(&c).expect("the content divides")
        };
    }
    if f.degree(v) == Some(0) {
        content
    } else {
        f * content
    }
}
