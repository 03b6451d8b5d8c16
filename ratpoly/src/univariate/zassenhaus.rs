//! Factorisation over the integers after H. Zassenhaus (*On Hensel factorization I*, 1969).
//!
//! Factor modulo a prime of 62 bits, lift if the coefficients of a divisor may be larger, and try which
//! products of lifted factors divide. Several primes are looked at: the one with the fewest factors is
//! taken, and only degrees that are possible modulo all of them are tried, which proves most irreducible
//! polynomials irreducible without trying anything. The number of trials can grow exponentially with the
//! number of modular factors (Swinnerton-Dyer's polynomials); a budget bounds it.

use num_bigint::BigInt;
use num_integer::Integer;
use num_traits::{One, Signed, Zero};

use super::factor_modular::{degree_pattern, factor_square_free as factor_modular};
use super::integer::{self, symmetric_residue};
use super::{hensel, modular as dense};
use crate::budget::Budget;
use crate::error::Error;
use crate::modular::{PrimeField, two_adic_primes};

/// How many primes are looked at before one is chosen.
const PRIMES: usize = 4;

/// The irreducible factors over the integers of a square-free polynomial of positive degree, primitive
/// and with positive leading coefficients, sorted by degree and coefficients. An integer content is left out.
///
/// Returns [`Error::Unsupported`] if the polynomial is zero or constant, or not square-free.
pub fn factor_square_free(f: &[BigInt], budget: &Budget) -> Result<Vec<Vec<BigInt>>, Error> {
    let mut f = integer::primitive_part(f);
    let mut factors = Vec::new();
    if f.len() < 2 {
        return Err(Error::Unsupported(
            "a constant has no factorisation into irreducible polynomials",
        ));
    }
    if f[0].is_zero() {
        factors.push(vec![BigInt::zero(), BigInt::one()]);
        f.remove(0);
        if f[0].is_zero() {
            return Err(Error::Unsupported("the polynomial is not square-free"));
        }
    }
    if f.len() == 2 {
        factors.push(f);
    } else if f.len() > 2 {
        let (degrees, choice) = choose_prime(&f, budget)?;
        match choice {
            Some((field, image)) if degrees.iter().filter(|&&possible| possible).count() > 2 => {
                recombine(
                    f,
                    &field,
                    &factor_modular(&field, &image),
                    &degrees,
                    budget,
                    &mut factors,
                )?;
            }
            _ => factors.push(f),
        }
    }
    factors.sort_by(|a, b| a.len().cmp(&b.len()).then_with(|| a.cmp(b)));
    Ok(factors)
}

/// Whether each degree is possible for a divisor over the integers.
type Degrees = Vec<bool>;

/// A prime field and the image of a polynomial over it.
type Image = (PrimeField, Vec<u64>);

/// The degrees that divisors can have, and the prime with the fewest factors together with the image;
/// none if no degree but the trivial ones is possible.
fn choose_prime(f: &[BigInt], budget: &Budget) -> Result<(Degrees, Option<Image>), Error> {
    let n = f.len() - 1;
    let mut possible = vec![true; n + 1];
    let mut best: Option<(usize, PrimeField, Vec<u64>)> = None;
    let (mut looked_at, mut refused) = (0, 0);
    for p in two_adic_primes(32) {
        budget.spend((n * n * n) as u64)?;
        let field = PrimeField::new(p).expect("an odd prime below 2^62");
        let image = integer::reduce(&field, f);
        if image.len() != f.len() || !dense::is_square_free(&field, &image) {
            refused += 1;
            // The discriminant would have to be a multiple of all these primes.
            if refused > 8 + f.iter().map(|c| c.bits() as usize).max().unwrap_or(0) * n / 30 {
                return Err(Error::Unsupported("the polynomial is not square-free"));
            }
            continue;
        }
        let pattern = degree_pattern(&field, &image);
        let mut sums = vec![false; n + 1];
        sums[0] = true;
        for &d in &pattern {
            for s in (d..=n).rev() {
                sums[s] |= sums[s - d];
            }
        }
        for (possible, sum) in possible.iter_mut().zip(sums) {
            *possible &= sum;
        }
        if best
            .as_ref()
            .is_none_or(|(count, ..)| pattern.len() < *count)
        {
            best = Some((pattern.len(), field, image));
        }
        looked_at += 1;
        if looked_at == PRIMES || possible.iter().filter(|&&p| p).count() == 2 {
            break;
        }
    }
    Ok((possible, best.map(|(_, field, image)| (field, image))))
}

/// Finds the products of lifted modular factors that divide, smallest first.
fn recombine(
    mut f: Vec<BigInt>,
    field: &PrimeField,
    modular: &[Vec<u64>],
    degrees: &Degrees,
    budget: &Budget,
    factors: &mut Vec<Vec<BigInt>>,
) -> Result<(), Error> {
    let bound: BigInt = integer::divisor_bound(&f) * f.last().expect("not zero") * 2u32;
    let (mut lifted, modulus) = hensel::lift(field, &f, modular, &bound, budget)?;
    let mut size = 1;
    'sizes: while 2 * size <= lifted.len() {
        let mut chosen: Vec<usize> = (0..size).collect();
        loop {
            budget.spend(1 + size as u64)?;
            let tried = try_product(&f, &lifted, &chosen, &modulus, degrees, budget)?;
            if let Some((divisor, quotient)) = tried {
                factors.push(divisor);
                f = quotient;
                for &i in chosen.iter().rev() {
                    lifted.remove(i);
                }
                continue 'sizes;
            }
            if !next_combination(&mut chosen, lifted.len()) {
                break;
            }
        }
        size += 1;
    }
    if f.len() > 1 {
        factors.push(integer::primitive_part(&f));
    }
    Ok(())
}

/// The divisor of f whose image is the product of the chosen factors, and the quotient by it.
fn try_product(
    f: &[BigInt],
    lifted: &[Vec<BigInt>],
    chosen: &[usize],
    modulus: &BigInt,
    degrees: &Degrees,
    budget: &Budget,
) -> Result<Option<(Vec<BigInt>, Vec<BigInt>)>, Error> {
    let degree: usize = chosen.iter().map(|&i| lifted[i].len() - 1).sum();
    if !degrees[degree] {
        return Ok(None);
    }
    let leading = f.last().expect("not zero");
    // The constant terms decide nearly always.
    let constant = chosen.iter().fold(leading.clone(), |c, &i| {
        (c * &lifted[i][0]).mod_floor(modulus)
    });
    let constant = symmetric_residue(&constant, modulus);
    if constant.is_zero() || !(leading * &f[0]).is_multiple_of(&constant) {
        return Ok(None);
    }
    // The product and the division are quadratic in the degree, in words of the modulus.
    let words = 1 + modulus.bits() / 64;
    budget.spend((f.len() * f.len()) as u64 * words)?;
    let product = chosen.iter().fold(vec![leading.clone()], |product, &i| {
        integer::mul(&product, &lifted[i])
            .iter()
            .map(|c| c.mod_floor(modulus))
            .collect()
    });
    let candidate: Vec<BigInt> = product
        .iter()
        .map(|c| symmetric_residue(c, modulus))
        .collect();
    let candidate = integer::primitive_part(&candidate);
    let Some(quotient) = integer::div_exact(f, &candidate) else {
        return Ok(None);
    };
    debug_assert!(quotient.last().is_some_and(Signed::is_positive));
    Ok(Some((candidate, quotient)))
}

/// The next combination of numbers below n in lexicographic order; `false` after the last one.
fn next_combination(chosen: &mut [usize], n: usize) -> bool {
    let size = chosen.len();
    for i in (0..size).rev() {
        if chosen[i] < n - size + i {
            chosen[i] += 1;
            for j in i + 1..size {
                chosen[j] = chosen[j - 1] + 1;
            }
            return true;
        }
    }
    false
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::error::Resource;
    use proptest::prelude::*;

    fn integers(coefficients: &[i64]) -> Vec<BigInt> {
        coefficients.iter().map(|&c| BigInt::from(c)).collect()
    }

    fn binomial(n: usize) -> Vec<BigInt> {
        let mut f = vec![BigInt::zero(); n + 1];
        f[0] = BigInt::from(-1);
        f[n] = BigInt::one();
        f
    }

    fn product(factors: &[Vec<BigInt>]) -> Vec<BigInt> {
        factors
            .iter()
            .fold(vec![BigInt::one()], |product, g| integer::mul(&product, g))
    }

    #[test]
    fn cyclotomic_polynomials() {
        for n in [1usize, 2, 12, 30, 105] {
            let factors = factor_square_free(&binomial(n), &Budget::default()).unwrap();
            assert_eq!(product(&factors), binomial(n));
            let divisors: Vec<usize> = (1..=n).filter(|d| n.is_multiple_of(*d)).collect();
            let totient = |n: usize| (1..=n).filter(|k| k.gcd(&n) == 1).count();
            let mut degrees: Vec<usize> = divisors.iter().map(|&d| totient(d)).collect();
            degrees.sort_unstable();
            assert!(factors.iter().map(|f| f.len() - 1).eq(degrees), "{n}");
        }
        // The first coefficient that is neither 0 nor ±1 (A. Migotti, 1883): Φ₁₀₅ has -2 twice.
        let factors = factor_square_free(&binomial(105), &Budget::default()).unwrap();
        let minus_two = BigInt::from(-2);
        assert_eq!(
            factors
                .last()
                .unwrap()
                .iter()
                .filter(|&c| *c == minus_two)
                .count(),
            2
        );
    }

    /// The monic polynomial with the roots ±√2 ±√3 ±√5 ..., irreducible over the integers but with
    /// factors of degree at most two modulo every prime (H. P. F. Swinnerton-Dyer, in E. R. Berlekamp, 1970).
    fn swinnerton_dyer(primes: &[i64]) -> Vec<BigInt> {
        let mut f = integers(&[0, 1]);
        for &p in primes {
            // f(x + √p)·f(x - √p), with a + b√p kept as a pair.
            let (mut plain, mut root) = (Vec::<BigInt>::new(), Vec::<BigInt>::new());
            for c in f.iter().rev() {
                let mut next_plain = vec![c.clone()];
                let mut next_root = vec![BigInt::zero()];
                next_plain.resize(plain.len() + 1, BigInt::zero());
                next_root.resize(plain.len() + 1, BigInt::zero());
                for i in 0..plain.len() {
                    next_plain[i + 1] += &plain[i];
                    next_plain[i] += &root[i] * p;
                    next_root[i + 1] += &root[i];
                    next_root[i] += &plain[i];
                }
                (plain, root) = (next_plain, next_root);
            }
            let roots = integer::mul(&root, &root);
            f = integer::mul(&plain, &plain)
                .iter()
                .zip(&roots)
                .map(|(a, b)| a - b * p)
                .collect();
            integer::trim(&mut f);
        }
        f
    }

    #[test]
    fn swinnerton_dyer_polynomials_are_irreducible() {
        assert_eq!(swinnerton_dyer(&[2, 3]), integers(&[1, 0, -10, 0, 1]));
        for primes in [&[2, 3][..], &[2, 3, 5], &[2, 3, 5, 7], &[2, 3, 5, 7, 11]] {
            let f = swinnerton_dyer(primes);
            assert_eq!(factor_square_free(&f, &Budget::default()).unwrap(), [f]);
        }
        let two = [swinnerton_dyer(&[2, 3, 5]), swinnerton_dyer(&[2, 3, 7])];
        let mut factors = factor_square_free(&product(&two), &Budget::default()).unwrap();
        factors.sort();
        let mut expected = two.to_vec();
        expected.sort();
        assert_eq!(factors, expected);
        let exceeded = factor_square_free(
            &swinnerton_dyer(&[2, 3, 5, 7, 11]),
            &Budget::new(1000, 100_000, 100_000),
        );
        assert_eq!(exceeded, Err(Error::BudgetExceeded(Resource::Steps)));
    }

    /// Sophie Germain's identity, a difference of squares, x⁴ + 1 (reducible modulo every prime).
    #[test]
    fn small_classics() {
        let factor = |f: &[i64]| factor_square_free(&integers(f), &Budget::default()).unwrap();
        assert_eq!(
            factor(&[4, 0, 0, 0, 1]),
            [integers(&[2, -2, 1]), integers(&[2, 2, 1])]
        );
        assert_eq!(
            factor(&[-36, 0, 16]),
            [integers(&[-3, 2]), integers(&[3, 2])]
        );
        assert_eq!(factor(&[1, 0, 0, 0, 1]), [integers(&[1, 0, 0, 0, 1])]);
        assert_eq!(factor(&[0, -6, 2]), [integers(&[-3, 1]), integers(&[0, 1])]);
        assert!(matches!(
            factor_square_free(&integers(&[1, 2, 1]), &Budget::default()),
            Err(Error::Unsupported(_))
        ));
        // Twice the factor x, which is split off before any prime is looked at.
        assert!(matches!(
            factor_square_free(&integers(&[0, 0, -2, 3, 6, -1, 2]), &Budget::default()),
            Err(Error::Unsupported(_))
        ));
        assert!(matches!(
            factor_square_free(&integers(&[7]), &Budget::default()),
            Err(Error::Unsupported(_))
        ));
        assert!(matches!(
            factor_square_free(&[], &Budget::default()),
            Err(Error::Unsupported(_))
        ));
    }

    proptest! {
        #[test]
        fn factors_multiply_back_and_refine(
            lists in prop::collection::vec(prop::collection::vec(prop_oneof![-9i64..=9, any::<i64>()], 2..6), 1..5),
            shift in 0u32..200,
        ) {
            let mut given: Vec<Vec<BigInt>> = lists.iter().map(|list| integers(list)).collect();
            given[0][0] <<= shift;
            for g in &mut given {
                integer::trim(g);
            }
            prop_assume!(given.iter().all(|g| g.len() > 1));
            let f = integer::primitive_part(&product(&given));
            let Ok(factors) = factor_square_free(&f, &Budget::default()) else {
                return Ok(()); // Not square-free.
            };
            prop_assert_eq!(product(&factors), f);
            prop_assert!(factors.len() >= given.len());
            for g in &factors {
                prop_assert_eq!(factor_square_free(g, &Budget::default()).unwrap(), vec![g.clone()]);
            }
        }

        #[test]
        fn lifting_is_congruent(lists in prop::collection::vec(prop::collection::vec(-99i64..=99, 2..5), 2..5)) {
            let given: Vec<Vec<BigInt>> = lists.iter().map(|list| {
                let mut g = integers(list);
                g.push(BigInt::one());
                g
            }).collect();
            let f = product(&given);
            let field = PrimeField::new(two_adic_primes(32).next().unwrap()).unwrap();
            let image = integer::reduce(&field, &f);
            prop_assume!(dense::is_square_free(&field, &image));
            let factors = factor_modular(&field, &image);
            let bound = BigInt::one() << 1000u32;
            let (lifted, modulus) = hensel::lift(&field, &f, &factors, &bound, &Budget::default()).unwrap();
            prop_assert!(modulus > bound && hensel::is_factorisation(&f, &lifted, &modulus));
        }
    }
}
