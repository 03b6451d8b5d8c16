//! Exact sparse multivariate polynomials and rational functions over the integers and rationals.
//!
//! The vocabulary, from small to large: a variable of a [`Ring`], a [`Monomial`] (a power product),
//! a term (monomial and coefficient), a [`Polynomial`] over the integers (terms in descending order),
//! a [`RationalFunction`] (a reduced pair of polynomials; the rationals enter here), a [`Matrix`].
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
//!
//! # Rings and values
//!
//! A ring is a list of named variables and a monomial [`Order`]. It is a `Copy` handle: rings with the
//! same variables and order are one object. Every value is canonical by construction, so that `==` is
//! structural and means mathematical equality.
//!
//! ```
//! # use ratpoly::{BigInt, Order, Polynomial, Ring};
//! # fn main() -> Result<(), ratpoly::Error> {
//! let ring = Ring::new(["a", "b", "c"], Order::Grevlex)?;
//! let (a, b) = (Polynomial::variable(ring, 0), Polynomial::named(ring, "b")?);
//! let f = (&a + &b).pow(2) - &a * &b;
//! assert_eq!(f.to_string(), "a^2 + a*b + b^2");
//! assert_eq!(f.coefficient(&[1, 1, 0]), BigInt::from(1));
//! assert_eq!((&f * &(&a - &b)).to_string(), "a^3 - b^3");
//! assert_eq!(f.derivative(0).to_string(), "2*a + b");
//! // The same polynomial in another ring, variables matched by name.
//! let larger = Ring::new(["t", "b", "a"], Order::Lex)?;
//! assert_eq!(f.to_ring(larger)?.to_string(), "b^2 + b*a + a^2");
//! # Ok(())
//! # }
//! ```
//!
//! # Division
//!
//! ```
//! # use ratpoly::{Order, Polynomial, Ring, gcd};
//! # fn main() -> Result<(), ratpoly::Error> {
//! # let ring = Ring::new(["x", "y"], Order::Lex)?;
//! let p = |text| Polynomial::parse(ring, text);
//! let (f, g) = (p("x^3*y - y^4")?, p("x^2*y - y^3")?);
//! assert_eq!(gcd(&f, &g), p("x*y - y^2")?);
//! assert_eq!(f.div_exact(&p("x - y")?), Some(p("x^2*y + x*y^2 + y^3")?));
//! assert_eq!(f.div_exact(&g), None);
//! // With remainder by several divisors: f = sum of quotient times divisor, plus remainder.
//! let (quotients, remainder) = f.div_rem(&[&p("x*y - 1")?, &p("y^2 - 1")?])?;
//! assert_eq!(quotients, [p("x^2")?, p("-y^2 - 1")?]);
//! assert_eq!(remainder, p("x^2 - 1")?);
//! # Ok(())
//! # }
//! ```
//!
//! # Rational functions
//!
//! ```
//! # use ratpoly::{BigInt, BigRational, Error, Order, RationalFunction, Ring};
//! # fn main() -> Result<(), ratpoly::Error> {
//! # let ring = Ring::new(["x", "y"], Order::Lex)?;
//! let r = |text| RationalFunction::parse(ring, text);
//! let sum = r("1/(x - y)")? + r("1/(x + y)")?;
//! assert_eq!(sum.to_string(), "2*x/(x^2 - y^2)");
//! assert_eq!(sum.substitute(&[(1, r("x/2")?)])?, r("8/(3*x)")?);
//! let point = [BigRational::from(BigInt::from(1)), BigRational::from(BigInt::from(1))];
//! assert_eq!(sum.evaluate(&point), Err(Error::DivisionByZero));
//! # Ok(())
//! # }
//! ```
//!
//! # Errors and budgets
//!
//! Operators panic only on a programming error (two rings are mixed, a division by zero) or if an
//! exponent passes `u32::MAX`; the `try_` and `checked_` forms return a typed [`Error`] instead. What can
//! explode has a form that takes a [`Budget`], and reports what ran out.
//!
//! ```
//! # use ratpoly::{Budget, Error, Order, Polynomial, Resource, Ring};
//! # fn main() -> Result<(), ratpoly::Error> {
//! # let ring = Ring::new(["x", "y"], Order::Lex)?;
//! let f = Polynomial::parse(ring, "x + y + 1")?;
//! let budget = Budget::new(1000, 64, 1_000_000);
//! assert_eq!(f.pow_within(100, &budget), Err(Error::BudgetExceeded(Resource::Terms)));
//! # Ok(())
//! # }
//! ```
//!
//! # How it is fast
//!
//! Monomials are packed into machine words, so that comparing and multiplying them is comparing and
//! adding integers; coefficients are machine words until they overflow. Both widen and narrow by
//! themselves and never show at the interface. Long products are formed in slices of a dense window of
//! accumulators, short sums of products in one pass ([`Polynomial::sum_of_products`]); exact division
//! uses a heap; greatest common divisors are found modulo word-sized primes and certified by division.

mod accumulator;
mod add;
pub mod allowance;
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
mod integer_gcd;
mod karatsuba;
mod layout;
mod limbs;
mod lowest_terms;
mod matrix;
pub mod modular;
mod monomial;
mod multiply;
mod packed;
mod parallel;
mod parse;
mod partial_fractions;
mod plan;
mod polynomial;
mod powers;
mod rational_function;
mod real_roots;
mod resultant;
mod ring;
mod scalar;
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
pub use lowest_terms::quotient;
pub use matrix::{
    DeterminantMethod, FaddeevLeVerrier, Matrix, hurwitz_cofactors, hurwitz_determinants,
    hurwitz_matrix, toeplitz_matrix,
};
pub use monomial::Monomial;
pub use partial_fractions::{PartialFraction, PartialFractions, partial_fractions};
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

#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
