//! Numbers with infinitesimals: truncated Taylor series, and linear forms in unknowns.
//!
//! A derivative is computed by adding an infinitesimal to its letter and reading off a coefficient
//! (R. E. Moore, *Interval Analysis*, 1966, chapter 11); derivatives of derivatives have one
//! infinitesimal each, the inner one with the higher number, so that a number is a tower: its
//! coefficients hold only infinitesimals with lower numbers. The unknowns of a linear system take part
//! as linear forms; what is not linear in them is refused, which proves that the rest is.
//!
//! Invariants: a series has at least two terms and its last is not exactly zero; a form has a slope
//! that is not exactly zero.

use super::failure::Reason;
use crate::real::{Complex, Real};
use std::collections::BTreeMap;

/// A number in a tower of infinitesimals.
#[derive(Clone, Debug, PartialEq)]
pub enum Jet {
    /// A number without any.
    Number(Complex),
    /// A polynomial in an infinitesimal, lowest power first.
    Series {
        /// Which infinitesimal.
        variable: usize,
        /// The coefficients.
        terms: Vec<Jet>,
    },
    /// A constant and multiples of the unknowns of a linear system.
    Form {
        /// Which system's unknowns, numbered as infinitesimals are.
        variable: usize,
        /// What it is where they are zero.
        constant: Box<Jet>,
        /// The factor of each unknown that occurs.
        slopes: BTreeMap<usize, Jet>,
    },
}

pub(super) type Result<T> = std::result::Result<T, Reason>;

impl From<Complex> for Jet {
    fn from(z: Complex) -> Self {
        Jet::Number(z)
    }
}

impl From<Real> for Jet {
    fn from(x: Real) -> Self {
        Jet::Number(x.into())
    }
}

impl Jet {
    /// An integer.
    pub fn integer(n: i64) -> Self {
        Jet::Number(Complex::integer(n))
    }

    /// Zero.
    pub fn zero() -> Self {
        Jet::integer(0)
    }

    /// The series with these coefficients.
    pub(super) fn series(variable: usize, mut terms: Vec<Jet>) -> Self {
        while terms.len() > 1 && terms.last().is_some_and(Jet::is_zero) {
            terms.pop();
        }
        if terms.len() == 1 {
            return terms.remove(0);
        }
        if terms.is_empty() {
            return Jet::zero();
        }
        Jet::Series { variable, terms }
    }

    pub(super) fn form(variable: usize, constant: Jet, mut slopes: BTreeMap<usize, Jet>) -> Self {
        slopes.retain(|_, slope| !slope.is_zero());
        if slopes.is_empty() {
            return constant;
        }
        Jet::Form {
            variable,
            constant: Box::new(constant),
            slopes,
        }
    }

    /// The highest infinitesimal in it.
    pub(super) fn variable(&self) -> Option<usize> {
        match self {
            Jet::Number(_) => None,
            Jet::Series { variable, .. } | Jet::Form { variable, .. } => Some(*variable),
        }
    }

    /// Whether it certainly is zero, with all its coefficients.
    pub fn is_zero(&self) -> bool {
        matches!(self, Jet::Number(z) if z.is_zero())
    }

    /// Whether it certainly is one.
    pub(super) fn is_one(&self) -> bool {
        matches!(self, Jet::Number(z) if z.is_one())
    }

    /// Whether it certainly has no imaginary part.
    pub fn is_real(&self) -> bool {
        match self {
            Jet::Number(z) => z.is_real(),
            Jet::Series { terms, .. } => terms.iter().all(Jet::is_real),
            Jet::Form {
                constant, slopes, ..
            } => constant.is_real() && slopes.values().all(Jet::is_real),
        }
    }

    /// The number that is left where all infinitesimals and unknowns are zero.
    pub fn number(&self) -> &Complex {
        match self {
            Jet::Number(z) => z,
            Jet::Series { terms, .. } => terms[0].number(),
            Jet::Form { constant, .. } => constant.number(),
        }
    }

    /// The number, if there is nothing else.
    pub fn as_number(&self) -> Option<&Complex> {
        match self {
            Jet::Number(z) => Some(z),
            Jet::Series { .. } | Jet::Form { .. } => None,
        }
    }

    /// The coefficient of a power of the highest infinitesimal.
    pub(super) fn coefficient(&self, of: usize, power: usize) -> Jet {
        match self {
            Jet::Series { variable, terms } if *variable == of => {
                terms.get(power).cloned().unwrap_or_else(Jet::zero)
            }
            Jet::Number(_) | Jet::Series { .. } | Jet::Form { .. } => {
                if power == 0 {
                    self.clone()
                } else {
                    Jet::zero()
                }
            }
        }
    }

    /// The constant and the slopes of a form in these unknowns.
    pub(super) fn parts(&self, of: usize) -> (Jet, BTreeMap<usize, Jet>) {
        match self {
            Jet::Form {
                variable,
                constant,
                slopes,
            } if *variable == of => ((**constant).clone(), slopes.clone()),
            Jet::Number(_) | Jet::Series { .. } | Jet::Form { .. } => {
                (self.clone(), BTreeMap::new())
            }
        }
    }

    /// The image of every coefficient under a map that is linear over real numbers.
    fn termwise(&self, image: &impl Fn(&Complex) -> Complex) -> Jet {
        match self {
            Jet::Number(z) => Jet::Number(image(z)),
            Jet::Series { variable, terms } => {
                Jet::series(*variable, terms.iter().map(|t| t.termwise(image)).collect())
            }
            Jet::Form {
                variable,
                constant,
                slopes,
            } => Jet::form(
                *variable,
                constant.termwise(image),
                slopes
                    .iter()
                    .map(|(k, s)| (*k, s.termwise(image)))
                    .collect(),
            ),
        }
    }

    /// `-z`.
    #[must_use]
    pub fn negated(&self) -> Jet {
        self.termwise(&Complex::negated)
    }

    /// The conjugate; infinitesimals are real.
    #[must_use]
    pub fn conjugate(&self) -> Jet {
        self.termwise(&Complex::conjugate)
    }

    /// The real part.
    #[must_use]
    pub fn real_part(&self) -> Jet {
        self.termwise(&|z| z.re.clone().into())
    }

    /// The imaginary part.
    #[must_use]
    pub fn imaginary_part(&self) -> Jet {
        self.termwise(&|z| z.im.clone().into())
    }
}
