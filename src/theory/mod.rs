//! The field's mathematics on exact matrices, one concept a file.
//!
//! Everything here is generic over a [`Domain`](crate::domain::Domain) and knows no document.

pub mod algebraic;
pub mod arithmetic;
pub mod characteristic;
pub mod cosine_transform;
pub mod determinant;
pub mod discrete;
pub mod error;
pub mod extremum;
pub mod hurwitz;
pub mod hurwitz_integral;
pub mod limit;
pub mod linear;
pub mod lyapunov;
pub mod shape_filter;
pub mod sign;
pub mod spectral_factor;
pub mod spectrum;
pub mod stability;
pub mod state_equations;
pub mod words;
