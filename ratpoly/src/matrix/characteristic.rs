//! The characteristic polynomial `det(s E - A) = s^n + a_1 s^(n-1) + ... + a_n`.

use super::Matrix;
use crate::budget::Budget;
use crate::error::Error;
use crate::polynomial::Polynomial;
use num_bigint::BigInt;

/// The recursion of Faddeev and Le Verrier: `A_0 = E`, `a_m = -trace(A A_(m-1)) / m`,
/// `A_m = A A_(m-1) + a_m E`. Then `A_n = 0`, and `A_0, ..., A_(n-1)` are the coefficients of the adjugate of
/// `s E - A`.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct FaddeevLeVerrier {
    /// `1, a_1, ..., a_n`.
    pub coefficients: Vec<Polynomial>,
    /// `A_0, ..., A_n`, the last zero.
    pub matrices: Vec<Matrix<Polynomial>>,
}

impl Matrix<Polynomial> {
    /// The coefficients `1, a_1, ..., a_n` of the characteristic polynomial, without any division (Berkowitz
    /// 1984).
    pub fn characteristic_polynomial(&self, budget: &Budget) -> Result<Vec<Polynomial>, Error> {
        let n = self.check_square()?;
        let ring = self.ring;
        let mut coefficients = vec![Polynomial::one(ring)];
        for k in 0..n {
            // The leading principal submatrix of size k is bordered by a row R, a column C and a corner d:
            // the new coefficients are a Toeplitz matrix with the first column 1, -d, -R C, -R A C, ...
            // times the old ones.
            let mut toeplitz = vec![Polynomial::one(ring), -&self[(k, k)]];
            let mut column: Vec<Polynomial> = (0..k).map(|i| self[(i, k)].clone()).collect();
            for _ in 0..k {
                let row = self.row(k)[..k].iter();
                toeplitz.push(-sum_within(self, row.zip(&column), budget)?);
                column = (0..k)
                    .map(|i| sum_within(self, self.row(i)[..k].iter().zip(&column), budget))
                    .collect::<Result<_, _>>()?;
            }
            coefficients = (0..k + 2)
                .map(|i| {
                    let pairs = coefficients.iter().enumerate().take(i + 1);
                    sum_within(self, pairs.map(|(j, c)| (&toeplitz[i - j], c)), budget)
                })
                .collect::<Result<_, _>>()?;
        }
        Ok(coefficients)
    }

    /// The coefficients of the characteristic polynomial and of the adjugate of `s E - A`; divides by
    /// integers only.
    pub fn faddeev_le_verrier(&self, budget: &Budget) -> Result<FaddeevLeVerrier, Error> {
        let n = self.check_square()?;
        let mut coefficients = vec![Polynomial::one(self.ring)];
        let mut matrices = vec![Matrix::<Polynomial>::identity(self.ring, n)];
        for m in 1..=n {
            let mut next = self.try_mul(&matrices[m - 1])?;
            for entry in &next.entries {
                budget.spend(entry.len() as u64)?;
                budget.check_terms(entry.len())?;
                budget.check_bits(entry.coefficient_bits())?;
            }
            let trace = next.trace()?;
            let minus_m = -BigInt::from(m);
            let a = trace.div_integer(&minus_m).expect("m divides the trace");
            for i in 0..n {
                let diagonal = &mut next.entries[i * n + i];
                *diagonal = diagonal.try_add(&a)?;
            }
            coefficients.push(a);
            matrices.push(next);
        }
        Ok(FaddeevLeVerrier {
            coefficients,
            matrices,
        })
    }
}

fn sum_within<'a>(
    matrix: &Matrix<Polynomial>,
    pairs: impl Iterator<Item = (&'a Polynomial, &'a Polynomial)>,
    budget: &Budget,
) -> Result<Polynomial, Error> {
    let pairs: Vec<_> = pairs
        .filter(|(f, g)| !f.is_zero() && !g.is_zero())
        .collect();
    for (f, g) in &pairs {
        budget.spend(f.len() as u64 * g.len() as u64)?;
    }
    let sum = Polynomial::sum_of_products(matrix.ring, pairs)?;
    budget.check_terms(sum.len())?;
    budget.check_bits(sum.coefficient_bits())?;
    Ok(sum)
}
