//! Factorisation over a prime field of odd characteristic.
//!
//! Distinct degrees by x^(p^d) - x, equal degrees by random splitting with a fixed seed; the Frobenius map
//! is a matrix, after E. R. Berlekamp, *Factoring polynomials over finite fields*, 1967.
//! D. G. Cantor and H. Zassenhaus, *A new algorithm for factoring polynomials over finite fields*, 1981.

use super::modular as dense;
use crate::modular::PrimeField;

/// The map a ↦ a^p modulo a polynomial, as the matrix of its values at 1, x, x², ...
pub struct Frobenius {
    rows: Vec<Vec<u64>>,
}

impl Frobenius {
    /// The map modulo `f`, which is not constant.
    pub fn new(field: &PrimeField, f: &[u64]) -> Frobenius {
        let image = dense::pow_mod(field, &[0, field.one()], field.modulus(), f);
        let mut rows = vec![vec![field.one()]];
        for i in 1..f.len() - 1 {
            rows.push(dense::rem(
                field,
                &dense::mul(field, &rows[i - 1], &image),
                f,
            ));
        }
        Frobenius { rows }
    }

    /// a^p, where the degree of `a` is below that of the modulus.
    pub fn apply(&self, field: &PrimeField, a: &[u64]) -> Vec<u64> {
        let mut power = vec![0; self.rows.len()];
        for (&c, row) in a.iter().zip(&self.rows) {
            for (sum, &entry) in power.iter_mut().zip(row) {
                *sum = field.add(*sum, field.mul(c, entry));
            }
        }
        dense::trim(&mut power);
        power
    }
}

/// For a square-free f of positive degree, the pairs (d, product of the monic irreducible factors of
/// degree d), by ascending d; and the Frobenius map that was made for it.
pub fn distinct_degrees(field: &PrimeField, f: &[u64]) -> (Vec<(usize, Vec<u64>)>, Frobenius) {
    let mut rest = f.to_vec();
    dense::monic(field, &mut rest);
    let frobenius = Frobenius::new(field, &rest);
    let x = [0, field.one()];
    let mut power = dense::rem(field, &x, &rest);
    let mut list = Vec::new();
    let mut d = 0;
    while rest.len() > 1 {
        d += 1;
        if 2 * d >= rest.len() {
            // What is left has no factor of a degree up to its half.
            list.push((rest.len() - 1, rest));
            break;
        }
        power = frobenius.apply(field, &power);
        let product = dense::gcd(field, &rest, &dense::sub(field, &power, &x));
        if product.len() > 1 {
            rest = dense::div_rem(field, &rest, &product).0;
            list.push((d, product));
        }
    }
    (list, frobenius)
}

/// The degrees of the irreducible factors of a square-free f, ascending: cheaper than the factors.
pub fn degree_pattern(field: &PrimeField, f: &[u64]) -> Vec<usize> {
    let (list, _) = distinct_degrees(field, f);
    list.iter()
        .flat_map(|(d, product)| std::iter::repeat_n(*d, (product.len() - 1) / d))
        .collect()
}

/// The monic irreducible factors of a square-free polynomial of positive degree, sorted by degree and
/// coefficients.
pub fn factor_square_free(field: &PrimeField, f: &[u64]) -> Vec<Vec<u64>> {
    let (list, frobenius) = distinct_degrees(field, f);
    let mut factors = Vec::new();
    let mut state = 0x2545_f491_4f6c_dd1d;
    for (d, product) in list {
        split_equal_degrees(field, &frobenius, product, d, &mut state, &mut factors);
    }
    factors.sort_by(|a, b| a.len().cmp(&b.len()).then_with(|| a.cmp(b)));
    factors
}

/// Splits a product of irreducible factors of degree d by a^((p^d - 1)/2), which is ±1 modulo each.
fn split_equal_degrees(
    field: &PrimeField,
    frobenius: &Frobenius,
    product: Vec<u64>,
    d: usize,
    state: &mut u64,
    factors: &mut Vec<Vec<u64>>,
) {
    let degree = product.len() - 1;
    if degree == d {
        factors.push(product);
        return;
    }
    loop {
        let mut a: Vec<u64> = (0..degree).map(|_| random_element(field, state)).collect();
        dense::trim(&mut a);
        // The norm a·a^p·a^(p²)···, then its power (p - 1)/2.
        let mut conjugate = a.clone();
        let mut norm = a;
        for _ in 1..d {
            conjugate = dense::rem(field, &frobenius.apply(field, &conjugate), &product);
            norm = dense::rem(field, &dense::mul(field, &norm, &conjugate), &product);
        }
        let power = dense::pow_mod(field, &norm, (field.modulus() - 1) / 2, &product);
        let part = dense::gcd(field, &product, &dense::sub(field, &power, &[field.one()]));
        if part.len() > 1 && part.len() < product.len() {
            let (rest, _) = dense::div_rem(field, &product, &part);
            split_equal_degrees(field, frobenius, part, d, state, factors);
            split_equal_degrees(field, frobenius, rest, d, state, factors);
            return;
        }
    }
}

/// The next element of a fixed pseudo-random sequence (G. Marsaglia, *Xorshift RNGs*, 2003).
fn random_element(field: &PrimeField, state: &mut u64) -> u64 {
    *state ^= *state << 13;
    *state ^= *state >> 7;
    *state ^= *state << 17;
    field.from_u64(*state)
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    /// All monic polynomials of a degree over a small field.
    fn monic_polynomials(field: &PrimeField, degree: usize) -> Vec<Vec<u64>> {
        let p = field.modulus();
        (0..p.pow(degree as u32))
            .map(|mut code| {
                let mut f: Vec<u64> = Vec::new();
                for _ in 0..degree {
                    f.push(field.from_u64(code % p));
                    code /= p;
                }
                f.push(field.one());
                f
            })
            .collect()
    }

    #[test]
    fn the_number_of_irreducible_polynomials_is_gauss_s() {
        // C. F. Gauss: (1/n) Σ_{d | n} μ(n/d) p^d.
        for (p, degree, count) in [
            (3, 2, 3),
            (3, 3, 8),
            (3, 4, 18),
            (5, 2, 10),
            (5, 3, 40),
            (7, 3, 112),
        ] {
            let field = PrimeField::new(p).unwrap();
            let all = monic_polynomials(&field, degree);
            let irreducible = all.iter().filter(|f| {
                dense::is_square_free(&field, f) && degree_pattern(&field, f) == [degree]
            });
            assert_eq!(irreducible.count(), count, "p = {p}, degree {degree}");
        }
    }

    proptest! {
        #[test]
        fn factors_multiply_back(
            which in 0usize..4,
            lists in prop::collection::vec(prop::collection::vec(any::<u64>(), 1..5), 1..6),
        ) {
            let field = PrimeField::new([3, 101, 65537, (1 << 62) - 57][which]).unwrap();
            let mut f = vec![field.one()];
            for list in lists {
                let mut g: Vec<u64> = list.into_iter().map(|c| field.from_u64(c)).collect();
                g.push(field.one());
                f = dense::mul(&field, &f, &g);
            }
            prop_assume!(dense::is_square_free(&field, &f));
            let factors = factor_square_free(&field, &f);
            let product = factors.iter().fold(vec![field.one()], |product, g| dense::mul(&field, &product, g));
            prop_assert_eq!(product, f.clone());
            for g in &factors {
                prop_assert_eq!(degree_pattern(&field, g), vec![g.len() - 1]);
            }
            let mut degrees: Vec<usize> = factors.iter().map(|g| g.len() - 1).collect();
            degrees.sort_unstable();
            prop_assert_eq!(degree_pattern(&field, &f), degrees);
        }
    }
}
