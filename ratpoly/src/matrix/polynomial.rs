//! Arithmetic of matrices of polynomials.

use super::Matrix;
use crate::error::Error;
use crate::polynomial::Polynomial;
use crate::rational_function::RationalFunction;
use num_bigint::BigInt;

impl Matrix<Polynomial> {
    /// The sum.
    pub fn try_add(&self, other: &Self) -> Result<Self, Error> {
        self.check_same_shape(other)?;
        self.zip(other, Polynomial::try_add)
    }

    /// The difference.
    pub fn try_sub(&self, other: &Self) -> Result<Self, Error> {
        self.check_same_shape(other)?;
        self.zip(other, Polynomial::try_sub)
    }

    fn zip(
        &self,
        other: &Self,
        f: impl Fn(&Polynomial, &Polynomial) -> Result<Polynomial, Error>,
    ) -> Result<Self, Error> {
        Matrix::try_build(self.ring, (self.rows, self.columns), |i, j| {
            f(&self[(i, j)], &other[(i, j)])
        })
    }

    /// The product; each entry is one fused sum of products.
    pub fn try_mul(&self, other: &Self) -> Result<Self, Error> {
        self.check_product(other)?;
        Matrix::try_build(self.ring, (self.rows, other.columns), |i, j| {
            let pairs = self.row(i).iter().enumerate();
            let pairs = pairs.filter(|(_, a)| !a.is_zero());
            let pairs = pairs.map(|(k, a)| (a, &other.entries[k * other.columns + j]));
            Polynomial::sum_of_products(self.ring, pairs)
        })
    }

    /// Every entry multiplied by a polynomial.
    pub fn scale(&self, factor: &Polynomial) -> Result<Self, Error> {
        Matrix::try_build(self.ring, (self.rows, self.columns), |i, j| {
            self[(i, j)].try_mul(factor)
        })
    }

    /// Every entry multiplied by an integer.
    pub fn scale_integer(&self, factor: &BigInt) -> Self {
        Matrix::build(self.ring, (self.rows, self.columns), |i, j| {
            self[(i, j)].mul_integer(factor)
        })
    }

    /// The sum of the diagonal.
    pub fn trace(&self) -> Result<Polynomial, Error> {
        let n = self.check_square()?;
        let mut sum = Polynomial::zero(self.ring);
        for i in 0..n {
            sum = sum.try_add(&self[(i, i)])?;
        }
        Ok(sum)
    }

    /// The same matrix over the rational functions.
    pub fn to_rational(&self) -> Matrix<RationalFunction> {
        Matrix::build(self.ring, (self.rows, self.columns), |i, j| {
            self[(i, j)].clone().into()
        })
    }
}
