//! W3 and W4: products, greatest common divisors and exact quotients of larger polynomials.

use crate::timing::report;
use ratpoly::{BigInt, Order, Polynomial, Ring, gcd};
use std::hint::black_box;

const PRIME: u64 = 1_000_000_007;

/// W3: f (f + 1) for f = (1 + x + y + z + t)^20, or the sparse product of Monagan and Pearce.
pub fn run_product(which: &str) -> Result<(), String> {
    let parse = |ring, text| Polynomial::parse(ring, text).map_err(|e| e.to_string());
    let (f, g) = match which {
        "fateman" => {
            let ring = Ring::new(["x", "y", "z", "t"], Order::Lex).map_err(|e| e.to_string())?;
            let f = parse(ring, "1 + x + y + z + t")?.pow(20);
            let g = &f + Polynomial::one(ring);
            (f, g)
        }
        "sparse" => {
            let ring =
                Ring::new(["x", "y", "z", "t", "u"], Order::Lex).map_err(|e| e.to_string())?;
            let f = parse(ring, "1 + x + y + 2*z^2 + 3*t^3 + 5*u^5")?.pow(12);
            let g = parse(ring, "1 + u + t + 2*z^2 + 3*y^3 + 5*x^5")?.pow(12);
            (f, g)
        }
        _ => return Err(format!("not fateman or sparse: {which}")),
    };
    let h = &f * &g;
    let ones = vec![1; f.ring().len()];
    let sum = h.evaluate_mod(&ones, PRIME).map_err(|e| e.to_string())?;
    let checks = format!("terms={} sum={sum} threads=1", h.len());
    report(&format!("w3-{which} ratpoly"), &checks, || {
        black_box(&f * &g);
    });
    Ok(())
}

/// Knuth's linear congruential generator (MMIX), the upper 31 bits of each state.
struct Random(u64);

impl Random {
    fn next(&mut self) -> u64 {
        self.0 = self
            .0
            .wrapping_mul(6364136223846793005)
            .wrapping_add(1442695040888963407);
        self.0 >> 33
    }

    fn polynomial(&mut self, ring: Ring, terms: usize, degree: u64) -> Result<Polynomial, String> {
        let mut list = Vec::new();
        for _ in 0..terms {
            let exponents: Vec<u32> = (0..5)
                .map(|_| (self.next() % (degree + 1)) as u32)
                .collect();
            let c = (self.next() % 2001) as i64 - 1000;
            list.push((exponents, BigInt::from(if c == 0 { 1 } else { c })));
        }
        Polynomial::from_terms(ring, list).map_err(|e| e.to_string())
    }
}

/// W4: gcd(f g, f h) and (f g) / f for random f, g, h.
pub fn run_gcd(size: &str) -> Result<(), String> {
    let (terms, degree) = match size {
        "S" => (10, 5),
        "M" => (50, 10),
        "L" => (200, 20),
        "D" => (300, 3),
        _ => return Err(format!("not one of S, M, L, D: {size}")),
    };
    let names = ["a", "b", "c", "d", "e"];
    let ring = Ring::new(names, Order::Lex).map_err(|e| e.to_string())?;
    let mut random = Random(1);
    let f = random.polynomial(ring, terms, degree)?;
    let g = random.polynomial(ring, terms, degree)?;
    let h = random.polynomial(ring, terms, degree)?;
    let (p, q) = (&f * &g, &f * &h);
    let r = gcd(&p, &q);
    let similar = f
        .div_exact(&r)
        .is_some_and(|quotient| quotient.is_constant());
    let value = |f: &Polynomial| f.evaluate_mod(&[2, 3, 5, 7, 11], PRIME).unwrap_or(0);
    let checks = format!(
        "|fg|={} |gcd|={} gcd~f={} quo==g:{} fval={} pval={}",
        p.len(),
        r.len(),
        u8::from(similar),
        u8::from(p.div_exact(&f) == Some(g)),
        value(&f),
        value(&p)
    );
    report(&format!("w4-gcd-{size} ratpoly"), &checks, || {
        black_box(gcd(&p, &q));
    });
    report(&format!("w4-div-{size} ratpoly"), "", || {
        black_box(p.div_exact(&f));
    });
    Ok(())
}
