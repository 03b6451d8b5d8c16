//! Slow plain definitions to test against, and generated input with hard corners.

// Every test binary uses its own part of this module.
#![allow(dead_code)]

use proptest::prelude::*;
use ratpoly::{BigInt, Order, Polynomial, Ring};
use std::collections::BTreeMap;

/// A polynomial by its plain definition: a finite map from exponents to coefficients.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Plain(pub BTreeMap<Vec<u32>, BigInt>);

impl Plain {
    pub fn new(terms: impl IntoIterator<Item = (Vec<u32>, BigInt)>) -> Self {
        let mut map = BTreeMap::new();
        for (exponents, c) in terms {
            *map.entry(exponents).or_insert(BigInt::ZERO) += c;
        }
        map.retain(|_, c| *c != BigInt::ZERO);
        Plain(map)
    }

    pub fn of(p: &Polynomial) -> Self {
        Plain(
            p.terms()
                .map(|(m, c)| (m.exponents().to_vec(), c))
                .collect(),
        )
    }

    pub fn to_polynomial(&self, ring: Ring) -> Polynomial {
        let terms = self.0.iter().map(|(e, c)| (e.clone(), c.clone()));
        Polynomial::from_terms(ring, terms).expect("exponents of this ring")
    }

    pub fn add(&self, other: &Self) -> Self {
        let both = self.0.iter().chain(&other.0);
        Plain::new(both.map(|(e, c)| (e.clone(), c.clone())))
    }

    pub fn scale(&self, factor: &BigInt) -> Self {
        Plain::new(self.0.iter().map(|(e, c)| (e.clone(), c * factor)))
    }

    pub fn mul(&self, other: &Self) -> Self {
        let pairs = self
            .0
            .iter()
            .flat_map(|a| other.0.iter().map(move |b| (a, b)));
        Plain::new(
            pairs.map(|((e, c), (f, d))| (e.iter().zip(f).map(|(x, y)| x + y).collect(), c * d)),
        )
    }

    pub fn derivative(&self, variable: usize) -> Self {
        let terms = self.0.iter().filter(|(e, _)| e[variable] > 0);
        Plain::new(terms.map(|(e, c)| {
            let mut e = e.clone();
            let factor = e[variable];
            e[variable] -= 1;
            (e, c * factor)
        }))
    }
}

/// What input a strategy makes.
#[derive(Debug, Clone, Copy)]
pub struct Sizes {
    pub terms: usize,
    pub degree: u32,
}

pub const SMALL: Sizes = Sizes {
    terms: 7,
    degree: 4,
};

pub fn order() -> impl Strategy<Value = Order> {
    prop_oneof![Just(Order::Lex), Just(Order::Grlex), Just(Order::Grevlex)]
}

/// A ring with 1 to `most` variables in any order.
pub fn ring(most: usize) -> impl Strategy<Value = Ring> {
    (1..=most, order()).prop_map(|(n, order)| {
        Ring::new((0..n).map(|k| format!("x{k}")), order).expect("distinct names")
    })
}

/// Coefficients: mostly small, some at the edges of one and two machine words, some huge.
pub fn coefficient() -> impl Strategy<Value = BigInt> {
    let near = |bits: u32| {
        (-2i64..=2, any::<bool>()).prop_map(move |(d, negative)| {
            let edge = (BigInt::from(1) << bits) + d;
            if negative { -edge } else { edge }
        })
    };
    prop_oneof![
        12 => (-9i64..=9).prop_map(BigInt::from),
        2 => any::<i64>().prop_map(BigInt::from),
        2 => near(31),
        2 => near(63),
        1 => near(62),
        1 => any::<i128>().prop_map(BigInt::from),
        1 => near(127),
        1 => near(200),
    ]
}

pub fn small_coefficient() -> impl Strategy<Value = BigInt> {
    (-9i64..=9).prop_map(BigInt::from)
}

/// The terms of a polynomial: zero, constants and single terms are frequent.
pub fn terms(
    variables: usize,
    sizes: Sizes,
    coefficient: impl Strategy<Value = BigInt>,
) -> impl Strategy<Value = Plain> {
    let exponents = prop::collection::vec(0..=sizes.degree, variables);
    let constant = Just(vec![0; variables]);
    let exponents = prop_oneof![6 => exponents, 1 => constant];
    prop::collection::vec((exponents, coefficient), 0..=sizes.terms).prop_map(Plain::new)
}

/// A polynomial of a ring with coefficients of all widths.
pub fn polynomial(ring: Ring, sizes: Sizes) -> impl Strategy<Value = Polynomial> {
    terms(ring.len(), sizes, coefficient()).prop_map(move |p| p.to_polynomial(ring))
}

/// A polynomial of a ring with small coefficients.
pub fn small_polynomial(ring: Ring, sizes: Sizes) -> impl Strategy<Value = Polynomial> {
    terms(ring.len(), sizes, small_coefficient()).prop_map(move |p| p.to_polynomial(ring))
}

/// Three polynomials of one ring; some of them are equal to each other or to multiples of each other.
pub fn triple(most_variables: usize, sizes: Sizes) -> impl Strategy<Value = [Polynomial; 3]> {
    ring(most_variables).prop_flat_map(move |ring| {
        let p = move || polynomial(ring, sizes);
        (p(), p(), p(), 0..8).prop_map(|(f, g, h, shape)| match shape {
            0 => [f.clone(), f, h],
            1 => [f.clone(), -&f, h],
            2 => [f.clone(), g, f],
            3 => [&f * &h, &g * &h, h],
            _ => [f, g, h],
        })
    })
}
