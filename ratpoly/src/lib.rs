//! Exact sparse multivariate polynomials and rational functions over the integers and rationals.
//!
//! The vocabulary, from small to large: a variable of a [`Ring`], a [`Monomial`] (a power product),
//! a term (monomial and coefficient), a [`Polynomial`] over the integers (terms in descending order),
//! a [`RationalFunction`] (a reduced pair of polynomials; the rationals enter here).
//!
//! Every value is canonical by construction, so that equality is structural. Operators panic only when
//! two rings are mixed or an exponent passes `u32::MAX`; the `try_` forms return a typed [`Error`], and
//! whatever can explode has a form that takes a [`Budget`].
//!
//! ```
//! use ratpoly::{Order, Polynomial, RationalFunction, Ring};
//! # fn main() -> Result<(), ratpoly::Error> {
//! let ring = Ring::new(["x", "y"], Order::Lex)?;
//! let f = Polynomial::parse(ring, "x^2 - y^2")?;
//! let g = Polynomial::parse(ring, "x^2 + 2*x*y + y^2")?;
//! assert_eq!(RationalFunction::new(f, g)?.to_string(), "(x - y)/(x + y)");
//! # Ok(())
//! # }
//! ```

mod add;
mod arithmetic;
mod budget;
mod coefficient;
mod common_denominator;
mod display;
mod divide;
mod divide_heap;
mod elimination;
mod error;
mod evaluate;
mod factor;
mod gcd;
mod groebner;
mod ideal;
mod layout;
mod matrix;
pub mod modular;
mod monomial;
mod multiply;
mod packed;
mod parse;
mod polynomial;
mod rational_function;
mod real_roots;
mod resultant;
mod ring;
mod serialize;
mod sign;
mod square_free;
mod substitute;
mod sum_of_products;
mod terms;
pub mod univariate;
mod window;

pub use budget::Budget;
pub use common_denominator::FactoredDenominator;
pub use elimination::{relations, relations_within};
pub use error::{Error, ParseErrorKind, Resource};
pub use factor::Factorization;
pub use gcd::{Cofactors, gcd, gcd_cofactors, gcd_cofactors_within, gcd_of, gcd_within, lcm};
pub use groebner::{GroebnerBasis, NormalForm, normal_form};
pub use ideal::Ideal;
pub use matrix::{
    DeterminantMethod, FaddeevLeVerrier, Matrix, hurwitz_cofactors, hurwitz_determinants,
    hurwitz_matrix, toeplitz_matrix,
};
pub use monomial::Monomial;
pub use polynomial::Polynomial;
pub use rational_function::RationalFunction;
pub use real_roots::{Bound, RealRoot, SturmSequence, real_roots};
pub use resultant::{
    discriminant, discriminant_within, resultant, resultant_within, subresultants,
};
pub use ring::{Order, Ring};
pub use sign::{Region, RegionSign, sign_of_quotient_on, sign_on};

pub use num_bigint::BigInt;
pub use num_rational::BigRational;
