//! The three steps of sparse interpolation modulo a prime.
//!
//! A polynomial with t terms c·x^e has the values `s_j = Σ c·(α^e)^j` at the powers of α. The least linear
//! recurrence of the sequence has the nodes α^e as its roots and is known after 2t values
//! ([`BerlekampMassey`]); the logarithms of the roots are the exponents ([`subgroup_logarithms`]); with the
//! nodes known, t values give the coefficients ([`solve_transposed_vandermonde`]).
//!
//! M. Ben-Or and P. Tiwari, *A deterministic algorithm for sparse multivariate polynomial interpolation*,
//! 1988; E. Kaltofen and L. Yagati, *Improved sparse multivariate polynomial interpolation algorithms*, 1988.

use super::PrimeField;
use crate::univariate::modular as dense;

/// The least linear recurrence of a sequence that is given element by element.
///
/// E. R. Berlekamp, *Algebraic Coding Theory*, 1968; J. L. Massey, *Shift-register synthesis and BCH
/// decoding*, 1969.
#[derive(Clone, Debug)]
pub struct BerlekampMassey {
    sequence: Vec<u64>,
    /// C with C₀ = 1 and Σ Cᵢ·s_{n-i} = 0 for every n ≥ length.
    connection: Vec<u64>,
    length: usize,
    /// The connection polynomial before the last change of length, its discrepancy inverted, its age.
    previous: Vec<u64>,
    inverse: u64,
    age: usize,
}

impl BerlekampMassey {
    /// The empty sequence.
    pub fn new(field: &PrimeField) -> BerlekampMassey {
        BerlekampMassey {
            sequence: Vec::new(),
            connection: vec![field.one()],
            length: 0,
            previous: vec![field.one()],
            inverse: field.one(),
            age: 1,
        }
    }

    /// Appends the next element of the sequence.
    pub fn push(&mut self, field: &PrimeField, element: u64) {
        let n = self.sequence.len();
        self.sequence.push(element);
        let terms = self.connection.iter().zip(self.sequence.iter().rev());
        let discrepancy = terms.fold(0, |sum, (&c, &s)| field.add(sum, field.mul(c, s)));
        if discrepancy == 0 {
            self.age += 1;
            return;
        }
        let before = (2 * self.length <= n).then(|| self.connection.clone());
        let factor = field.mul(discrepancy, self.inverse);
        if self.connection.len() < self.previous.len() + self.age {
            self.connection.resize(self.previous.len() + self.age, 0);
        }
        for (c, &b) in self.connection[self.age..].iter_mut().zip(&self.previous) {
            *c = field.sub(*c, field.mul(factor, b));
        }
        self.age += 1;
        if let Some(before) = before {
            self.length = n + 1 - self.length;
            self.previous = before;
            self.inverse = field.inverse(discrepancy).expect("not zero");
            self.age = 1;
        }
    }

    /// The order of the recurrence: the number of terms, once enough elements are known.
    pub fn length(&self) -> usize {
        self.length
    }

    /// How many elements beyond the necessary 2·length have confirmed the recurrence.
    pub fn confirmations(&self) -> usize {
        self.sequence.len().saturating_sub(2 * self.length)
    }

    /// The elements so far.
    pub fn sequence(&self) -> &[u64] {
        &self.sequence
    }

    /// The characteristic polynomial of the recurrence, monic, constant term first; `None` when it has a
    /// degree below the order, in which case zero is among its roots and the sequence is not one of nodes.
    pub fn locator(&self) -> Option<Vec<u64>> {
        let mut polynomial = self.connection.clone();
        while polynomial.last() == Some(&0) {
            polynomial.pop();
        }
        if polynomial.len() != self.length + 1 {
            return None;
        }
        polynomial.reverse();
        Some(polynomial)
    }
}

/// The exponents 0 ≤ e < 2^k, ascending, with f(α^e) = 0 where α has the order 2^k; `None` unless f splits
/// into distinct linear factors with such roots. `f` has its constant term first.
///
/// The roots are separated by the lowest bit of their exponent: (α^e)^(2^(k-1)) = (-1)^e.
pub fn subgroup_logarithms(field: &PrimeField, f: &[u64], alpha: u64, k: u32) -> Option<Vec<u64>> {
    let mut exponents = Vec::with_capacity(f.len());
    let mut f = f.to_vec();
    dense::trim(&mut f);
    if f.is_empty() {
        return None;
    }
    let degree = f.len() - 1;
    if !logarithms(field, f, alpha, k, 0, 0, &mut exponents) || exponents.len() != degree {
        return None;
    }
    exponents.sort_unstable();
    exponents
        .windows(2)
        .all(|pair| pair[0] < pair[1])
        .then_some(exponents)
}

/// The roots of `f` are α^e; what is pushed is `low + e·2^shift`.
fn logarithms(
    field: &PrimeField,
    f: Vec<u64>,
    alpha: u64,
    k: u32,
    low: u64,
    shift: u32,
    exponents: &mut Vec<u64>,
) -> bool {
    let degree = f.len() - 1;
    if degree == 0 {
        return true;
    }
    // Few points: try them all.
    if k == 0 || (k < 40 && (1u64 << k) <= 8 * degree as u64 * u64::from(k)) {
        let mut point = field.one();
        let mut found = 0;
        for e in 0..1u64 << k {
            if dense::evaluate(field, &f, point) == 0 {
                exponents.push(low + (e << shift));
                found += 1;
            }
            point = field.mul(point, alpha);
        }
        return found == degree;
    }
    if degree == 1 {
        let Some(inverse) = field.inverse(f[1]) else {
            return false;
        };
        let root = field.mul(field.neg(f[0]), inverse);
        return match logarithm(field, root, alpha, k) {
            Some(e) => {
                exponents.push(low + (e << shift));
                true
            }
            None => false,
        };
    }
    // x^(2^(k-1)) modulo f, less one, has the roots with an even exponent in common with f.
    let mut power = vec![0, field.one()];
    for _ in 0..k - 1 {
        power = dense::rem(field, &dense::square(field, &power), &f);
    }
    if power.is_empty() {
        return false;
    }
    power[0] = field.sub(power[0], field.one());
    dense::trim(&mut power);
    let even = dense::gcd(field, &f, &power);
    let (mut odd, _) = dense::div_rem(field, &f, &even);
    // The odd roots α·β become the even ones β of f(α·x).
    dense::scale_variable(field, &mut odd, alpha);
    let alpha_squared = field.mul(alpha, alpha);
    logarithms(field, even, alpha_squared, k - 1, low, shift + 1, exponents)
        && logarithms(
            field,
            odd,
            alpha_squared,
            k - 1,
            low + (1 << shift),
            shift + 1,
            exponents,
        )
}

/// The e with α^e = root, where α has the order 2^k (S. Pohlig and M. Hellman, 1978).
fn logarithm(field: &PrimeField, mut root: u64, alpha: u64, k: u32) -> Option<u64> {
    let mut inverse = field.inverse(alpha)?;
    let mut e = 0;
    for bit in 0..k {
        let sign = (0..k - 1 - bit).fold(root, |power, _| field.mul(power, power));
        if sign != field.one() {
            e |= 1 << bit;
            root = field.mul(root, inverse);
        }
        inverse = field.mul(inverse, inverse);
    }
    (root == field.one()).then_some(e)
}

/// The coefficients c with `Σᵢ cᵢ·nodeᵢ^j = valueⱼ` for j = 0, 1, ..., as many as there are nodes; further
/// values are ignored. `None` when two nodes are equal or there are too few values.
///
/// Quadratic in the number of nodes (R. Zippel, *Interpolating polynomials from their values*, 1990).
pub fn solve_transposed_vandermonde(
    field: &PrimeField,
    nodes: &[u64],
    values: &[u64],
) -> Option<Vec<u64>> {
    let n = nodes.len();
    if values.len() < n {
        return None;
    }
    // The master polynomial Π (z - nodeᵢ).
    let mut master = Vec::with_capacity(n + 1);
    master.push(field.one());
    for &node in nodes {
        master.push(0);
        for i in (0..master.len()).rev() {
            let shifted = if i == 0 { 0 } else { master[i - 1] };
            master[i] = field.sub(shifted, field.mul(node, master[i]));
        }
    }
    let (mut sums, mut denominators) = (Vec::with_capacity(n), Vec::with_capacity(n));
    for &node in nodes {
        // The quotient of the master polynomial by z - node, from its leading coefficient down.
        let (mut quotient, mut sum, mut at_node) = (0, 0, 0);
        for j in (0..n).rev() {
            quotient = field.add(field.mul(quotient, node), master[j + 1]);
            sum = field.add(sum, field.mul(quotient, values[j]));
            at_node = field.add(field.mul(at_node, node), quotient);
        }
        sums.push(sum);
        denominators.push(at_node);
    }
    if !field.invert_all(&mut denominators) {
        return None;
    }
    Some(
        sums.iter()
            .zip(denominators)
            .map(|(&sum, inverse)| field.mul(sum, inverse))
            .collect(),
    )
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::modular::two_adic_primes;
    use proptest::prelude::*;
    use std::collections::BTreeMap;

    const K: u32 = 32;

    fn field() -> PrimeField {
        PrimeField::new(two_adic_primes(K).next().unwrap()).unwrap()
    }

    /// An element of the exact order 2^k.
    fn root_of_unity(field: &PrimeField, k: u32) -> u64 {
        (2..)
            .map(|a| field.pow(field.from_u64(a), (field.modulus() - 1) >> k))
            .find(|&a| field.pow(a, 1 << (k - 1)) != field.one())
            .unwrap()
    }

    proptest! {
        #[test]
        fn sparse_polynomials_come_back(
            k in 1u32..=K,
            terms in prop::collection::btree_map(any::<u64>(), 1u64..1000, 0..40),
        ) {
            let field = field();
            let alpha = root_of_unity(&field, k);
            let terms: BTreeMap<u64, u64> = terms.into_iter().map(|(e, c)| (e % (1 << k), c)).collect();
            let mut recurrence = BerlekampMassey::new(&field);
            for j in 0..2 * terms.len() as u64 + 3 {
                let value = terms.iter().fold(0, |sum, (&e, &c)| {
                    let node = field.pow(alpha, e);
                    field.add(sum, field.mul(field.from_u64(c), field.pow(node, j)))
                });
                recurrence.push(&field, value);
            }
            prop_assert_eq!(recurrence.length(), terms.len());
            prop_assert_eq!(recurrence.confirmations(), 3);
            let locator = recurrence.locator().unwrap();
            let exponents = subgroup_logarithms(&field, &locator, alpha, k).unwrap();
            prop_assert!(exponents.iter().eq(terms.keys()));
            let nodes: Vec<u64> = exponents.iter().map(|&e| field.pow(alpha, e)).collect();
            let coefficients = solve_transposed_vandermonde(&field, &nodes, recurrence.sequence()).unwrap();
            prop_assert!(coefficients.iter().map(|&c| field.to_u64(c)).eq(terms.values().copied()));
        }
    }

    #[test]
    fn what_is_no_product_of_nodes_is_refused() {
        let field = field();
        let alpha = root_of_unity(&field, 20);
        let three = field.from_u64(3);
        let one = field.one();
        // 3 is not in the subgroup; a double root; the constant zero; no root at all.
        for f in [
            vec![field.neg(three), one],
            vec![one, field.neg(field.add(one, one)), one],
            vec![],
            vec![three, 0, one],
        ] {
            assert_eq!(subgroup_logarithms(&field, &f, alpha, 20), None, "{f:?}");
        }
        assert_eq!(
            subgroup_logarithms(&field, &[three], alpha, 20),
            Some(vec![])
        );
        assert_eq!(
            solve_transposed_vandermonde(&field, &[one, one], &[one, one]),
            None
        );
        assert_eq!(solve_transposed_vandermonde(&field, &[one], &[]), None);
    }
}
