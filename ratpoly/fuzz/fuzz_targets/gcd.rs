//! Three polynomials from any bytes: the product with a common factor divides back, and the gcd contains
//! the factor and leaves coprime cofactors.
#![no_main]

use libfuzzer_sys::fuzz_target;
use ratpoly::{BigInt, Budget, Error, Order, Polynomial, Ring, gcd_cofactors_within};

/// Six bytes a term: three exponents, and a coefficient that is sometimes large.
fn polynomial(ring: Ring, bytes: &[u8]) -> Polynomial {
    let terms = bytes.chunks_exact(6).map(|b| {
        let exponents = [b[0] % 6, b[1] % 6, b[2] % 6].map(u32::from);
        let coefficient = BigInt::from(i16::from_le_bytes([b[3], b[4]]));
        (exponents, coefficient << (b[5] as u32 % 8 * 16))
    });
    Polynomial::from_terms(ring, terms).expect("three exponents")
}

fn check(bytes: &[u8]) -> Result<(), Error> {
    let orders = [Order::Lex, Order::Grlex, Order::Grevlex];
    let Some((&first, bytes)) = bytes.split_first() else { return Ok(()) };
    let ring = Ring::new(["x", "y", "z"], orders[first as usize % 3])?;
    let third = bytes.len() / 3;
    let [f, g, h] = [0, 1, 2].map(|i| polynomial(ring, &bytes[i * third..(i + 1) * third]));
    let (p, q) = (&f * &h, &g * &h);
    if !h.is_zero() {
        assert_eq!(p.div_exact(&h), Some(f));
    }
    let budget = Budget::new(100_000, 100_000, 100_000_000);
    let found = gcd_cofactors_within(&p, &q, &budget)?;
    assert_eq!((&found.gcd * &found.first, &found.gcd * &found.second), (p, q));
    if !found.gcd.is_zero() {
        assert!(h.divides(&found.gcd));
        let rest = gcd_cofactors_within(&found.first, &found.second, &budget)?;
        assert!(rest.gcd.is_one());
    }
    Ok(())
}

fuzz_target!(|bytes: &[u8]| {
    if bytes.len() < 200 {
        // Running out of budget is an answer.
        let _ = check(bytes);
    }
});
