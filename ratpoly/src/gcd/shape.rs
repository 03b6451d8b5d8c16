//! What one pass over the exponents tells of a polynomial.

use crate::polynomial::Polynomial;

/// A polynomial that is not zero, its exponents side by side, and its shape.
pub(super) struct Operand<'a> {
    pub(super) polynomial: &'a Polynomial,
    /// The exponent vectors, term after term.
    pub(super) exponents: Vec<u32>,
    pub(super) shape: Shape,
}

impl<'a> Operand<'a> {
    /// The operand made of a polynomial that is not zero.
    pub(super) fn new(polynomial: &'a Polynomial) -> Operand<'a> {
        let exponents = polynomial.exponents_flat();
        let shape = Shape::of(&exponents, polynomial.ring().len());
        Operand {
            polynomial,
            exponents,
            shape,
        }
    }
}

/// The least and the greatest exponent of each variable and how many terms have it.
pub(super) struct Shape {
    pub(super) low: Vec<u32>,
    pub(super) high: Vec<u32>,
    /// The number of terms with the least exponent.
    pub(super) low_count: Vec<u32>,
    /// The number of terms with the greatest exponent.
    pub(super) high_count: Vec<u32>,
    /// The greatest common divisor of the distances between exponents; zero if they are all equal.
    pub(super) stride: Vec<u32>,
}

impl Shape {
    /// The shape of a list of exponent vectors of length `n`, at least one; without variables it is empty.
    fn of(exponents: &[u32], n: usize) -> Shape {
        let first = &exponents[..n];
        let mut shape = Shape {
            low: first.to_vec(),
            high: first.to_vec(),
            low_count: vec![1; n],
            high_count: vec![1; n],
            stride: vec![0; n],
        };
        for exponents in exponents[n..].chunks_exact(n.max(1)) {
            for (i, &e) in exponents.iter().enumerate() {
                if e <= shape.low[i] {
                    shape.low_count[i] = if e == shape.low[i] {
                        shape.low_count[i] + 1
                    } else {
                        1
                    };
                    shape.low[i] = e;
                }
                if e >= shape.high[i] {
                    shape.high_count[i] = if e == shape.high[i] {
                        shape.high_count[i] + 1
                    } else {
                        1
                    };
                    shape.high[i] = e;
                }
                if shape.stride[i] != 1 {
                    shape.stride[i] = gcd(shape.stride[i], e.abs_diff(first[i]));
                }
            }
        }
        shape
    }

    /// Whether the exponent of a variable is not the same in all terms.
    pub(super) fn varies(&self, variable: usize) -> bool {
        self.low[variable] < self.high[variable]
    }

    /// Whether the leading or the trailing coefficient with respect to a variable is a single term.
    pub(super) fn has_lone_extreme(&self, variable: usize) -> bool {
        self.low_count[variable] == 1 || self.high_count[variable] == 1
    }
}

/// Euclid's algorithm on machine words; most strides are 0 or 1, which end it at once.
pub(super) fn gcd(mut a: u32, mut b: u32) -> u32 {
    while b != 0 {
        (a, b) = (b, a % b);
    }
    a
}
