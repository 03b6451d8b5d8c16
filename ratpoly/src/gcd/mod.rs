//! Greatest common divisors of multivariate polynomials over the integers.
//!
//! From cheap to dear, each step leaves less for the next:
//!
//! 1. zero, single terms, equal operands, integer and monomial contents: read off;
//! 2. a variable whose extreme coefficient is a single term in one operand and that the other operand
//!    does not contain: nothing but a term can be common;
//! 3. tiny operands: one divides the other;
//! 4. one image modulo a prime bounds the degree of the gcd in every variable at once ([`degree_bounds`]):
//!    mostly it proves that there is no common factor;
//! 5. variables that the gcd cannot contain: it divides all coefficients with respect to them;
//! 6. the degree bounds of an operand: it probably divides the other;
//! 7. sparse modular interpolation ([`sparse`]).
//!
//! Whatever random choices propose is certified: a candidate is accepted only when it divides both
//! operands over the integers, and its degrees meet proven upper bounds or its cofactors are proven
//! coprime. The choices come from fixed seeds: the same input takes the same way.

mod degree_bounds;
mod images;
mod prs;
mod shape;
mod sparse;
mod split;
mod view;

use num_traits::{One, Signed, Zero};

use crate::budget::Budget;
use crate::error::Error;
use crate::polynomial::Polynomial;
use crate::ring::Ring;
pub(crate) use degree_bounds::square_free_by_images;
use shape::Operand;

/// A greatest common divisor and what it leaves: `first operand = gcd · first`, `second operand = gcd · second`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Cofactors {
    /// The greatest common divisor, with a positive leading coefficient; 0 only if both operands are.
    pub gcd: Polynomial,
    /// The first operand divided by the gcd; 0 if the operand is.
    pub first: Polynomial,
    /// The second operand divided by the gcd; 0 if the operand is.
    pub second: Polynomial,
}

/// The greatest common divisor, with a positive leading coefficient; `gcd(0, 0) = 0`.
///
/// # Panics
/// If the operands belong to different rings, or a degree is beyond what dense univariate images can
/// hold (some ten million); [`gcd_within`] returns these as errors.
pub fn gcd(f: &Polynomial, g: &Polynomial) -> Polynomial {
    gcd_within(f, g, &Budget::unlimited()).unwrap_or_else(|e| panic!("{e}"))
}

/// The greatest common divisor within a budget.
pub fn gcd_within(f: &Polynomial, g: &Polynomial, budget: &Budget) -> Result<Polynomial, Error> {
    Ok(common(f, g, budget)?.gcd)
}

/// The greatest common divisor and the cofactors, which it mostly yields for nothing.
///
/// # Panics
/// As [`gcd`].
pub fn gcd_cofactors(f: &Polynomial, g: &Polynomial) -> Cofactors {
    gcd_cofactors_within(f, g, &Budget::unlimited()).unwrap_or_else(|e| panic!("{e}"))
}

/// The greatest common divisor and the cofactors within a budget.
pub fn gcd_cofactors_within(
    f: &Polynomial,
    g: &Polynomial,
    budget: &Budget,
) -> Result<Cofactors, Error> {
    let Common { gcd, quotients } = common(f, g, budget)?;
    let (first, second) = match quotients {
        Some(quotients) => quotients,
        None if gcd.is_one() => (f.clone(), g.clone()),
        None => {
            let divide = |p: &Polynomial| -> Result<Polynomial, Error> {
                if p.is_zero() {
                    return Ok(p.clone());
                }
                let quotient = p.div_exact_within(&gcd, budget)?;
                Ok(quotient.expect("a known divisor"))
            };
            (divide(f)?, divide(g)?)
        }
    };
    Ok(Cofactors { gcd, first, second })
}

/// The greatest common divisor of any number of polynomials; 0 for none.
///
/// # Panics
/// As [`gcd`].
pub fn gcd_of<'a>(ring: Ring, polynomials: impl IntoIterator<Item = &'a Polynomial>) -> Polynomial {
    let list = polynomials.into_iter().cloned().collect();
    split::gcd_of_list(ring, list, &Budget::unlimited()).unwrap_or_else(|e| panic!("{e}"))
}

/// The least common multiple, with a positive leading coefficient; zero if an operand is.
///
/// # Panics
/// As [`gcd`], or on an exponent overflow.
pub fn lcm(f: &Polynomial, g: &Polynomial) -> Polynomial {
    if f.is_zero() || g.is_zero() {
        assert!(f.ring() == g.ring(), "{}", Error::RingMismatch);
        return Polynomial::zero(f.ring());
    }
    let Cofactors { first, .. } = gcd_cofactors(f, g);
    (first * g).unit_normal()
}

impl Polynomial {
    /// The content as a polynomial in one variable: the gcd of its coefficients, which are polynomials in
    /// the others. Its leading coefficient is positive; it is 0 for the zero polynomial.
    ///
    /// # Panics
    /// As [`gcd`].
    pub fn content_in(&self, variable: usize) -> Polynomial {
        self.content_in_within(variable, &Budget::unlimited())
            .unwrap_or_else(|e| panic!("{e}"))
    }

    /// The content as a polynomial in one variable, within a budget.
    pub(crate) fn content_in_within(
        &self,
        variable: usize,
        budget: &Budget,
    ) -> Result<Polynomial, Error> {
        split::gcd_of_list(self.ring(), self.nonzero_coefficients_in(variable), budget)
    }
}

/// A gcd and, where they fell off on the way, the operands divided by it.
pub(crate) struct Common {
    pub(crate) gcd: Polynomial,
    pub(crate) quotients: Option<(Polynomial, Polynomial)>,
}

/// f/g for a g that is known to divide.
fn exact(f: &Polynomial, g: &Polynomial) -> Polynomial {
    f.div_exact(g).expect("a known divisor")
}

/// Up to so many products of terms one operand is tried as a divisor of the other before all else.
const TINY: usize = 64;

/// The gcd with its parts in order: integer content, monomial content, and the rest.
pub(crate) fn common(f: &Polynomial, g: &Polynomial, budget: &Budget) -> Result<Common, Error> {
    common_from_prime(f, g, 0, budget)
}

/// The same, where the prime number `first` of the sequence is the first to be tried.
fn common_from_prime(
    f: &Polynomial,
    g: &Polynomial,
    first: usize,
    budget: &Budget,
) -> Result<Common, Error> {
    let ring = f.ring();
    if ring != g.ring() {
        return Err(Error::RingMismatch);
    }
    if f.is_zero() {
        return Ok(Common {
            gcd: g.unit_normal(),
            quotients: None,
        });
    }
    if g.is_zero() || f == g {
        return Ok(Common {
            gcd: f.unit_normal(),
            quotients: None,
        });
    }
    let term = common_term(f, g);
    if f.len() == 1 || g.len() == 1 {
        return Ok(Common {
            gcd: term,
            quotients: None,
        });
    }
    Ok(match primitive_common([f, g], first, budget)? {
        None => Common {
            gcd: term,
            quotients: None,
        },
        Some(common) if term.is_one() => common,
        Some(Common { gcd, quotients }) => {
            let quotients = quotients.map(|(p, q)| (exact(&p, &term), exact(&q, &term)));
            Common {
                gcd: gcd.try_mul(&term)?,
                quotients,
            }
        }
    })
}

/// The greatest term that divides both: the integer and the monomial content of the gcd.
fn common_term(f: &Polynomial, g: &Polynomial) -> Polynomial {
    let (short, long) = if f.len() <= g.len() { (f, g) } else { (g, f) };
    let mut content = short.content_scalar();
    if !content.is_one() {
        content = content.gcd(long.content_scalar().value());
    }
    let mut monomial = short.monomial_content();
    if !monomial.is_one() {
        monomial = monomial.gcd(&long.monomial_content());
    }
    Polynomial::from_term(f.ring(), &monomial, content)
}

/// The gcd of two polynomials of at least two terms each, less its integer and monomial content;
/// `None` if nothing is left, that is, if it is a term.
fn primitive_common(
    polynomials: [&Polynomial; 2],
    first: usize,
    budget: &Budget,
) -> Result<Option<Common>, Error> {
    let operands = &polynomials.map(Operand::new);
    let n = polynomials[0].ring().len();
    let extent = |which: usize, v: usize| &operands[which].shape[v];
    let varies = |which: usize, v: usize| extent(which, v).varies();
    for v in 0..n {
        for (which, other) in [(0, 1), (1, 0)] {
            if varies(which, v) && !varies(other, v) && extent(which, v).has_lone_extreme() {
                return Ok(None);
            }
        }
    }
    let shared: Vec<usize> = (0..n).filter(|&v| varies(0, v) && varies(1, v)).collect();
    if shared.is_empty() {
        return Ok(None);
    }
    budget.spend((polynomials[0].len() + polynomials[1].len()) as u64)?;
    // Tiny operands: divisions cost less than images.
    if polynomials[0].len() * polynomials[1].len() <= TINY {
        for (which, other) in [(0, 1), (1, 0)] {
            let span = |which: usize, v: usize| extent(which, v).high - extent(which, v).low;
            if (0..n).all(|v| span(which, v) <= span(other, v))
                && let candidate = primitive_part(polynomials[which])
                && let Some(found) = common_divisor(polynomials, &candidate, other, budget)?
            {
                return Ok(Some(found));
            }
        }
    }
    let views = view::Views::new(operands, shared)?;
    // Euclid's algorithm for the images in each variable.
    for (&d, &e) in views.degrees[0].iter().zip(&views.degrees[1]) {
        budget.spend(u64::from(d).saturating_mul(e.into()))?;
    }
    let bounds = degree_bounds::degree_bounds(&views, first);
    if bounds.iter().all(|&d| d == 0) {
        return Ok(None);
    }
    // Variables that the gcd cannot contain.
    let mut absent: Vec<bool> = (0..n).map(|v| varies(0, v) != varies(1, v)).collect();
    for (&v, &bound) in views.variables.iter().zip(&bounds) {
        absent[v] |= bound == 0;
    }
    if absent.contains(&true) {
        return split::common_without(polynomials, &absent, budget);
    }
    // An operand may divide the other.
    for (which, other) in [(0, 1), (1, 0)] {
        if views.degrees[which] == bounds
            && let candidate = primitive_part(polynomials[which])
            && let Some(found) = common_divisor(polynomials, &candidate, other, budget)?
        {
            return Ok(Some(found));
        }
    }
    sparse::sparse_gcd(&views, &bounds, first, budget)
}

/// The candidate as a common divisor with positive leading coefficient, if it divides both operands;
/// the operand number `first` is asked first.
fn common_divisor(
    operands: [&Polynomial; 2],
    candidate: &Polynomial,
    first: usize,
    budget: &Budget,
) -> Result<Option<Common>, Error> {
    let Some(asked) = operands[first].div_exact_within(candidate, budget)? else {
        return Ok(None);
    };
    let Some(other) = operands[1 - first].div_exact_within(candidate, budget)? else {
        return Ok(None);
    };
    let (p, q) = if first == 0 {
        (asked, other)
    } else {
        (other, asked)
    };
    Ok(Some(if candidate.leading_coefficient().is_negative() {
        Common {
            gcd: -candidate,
            quotients: Some((-p, -q)),
        }
    } else {
        Common {
            gcd: candidate.clone(),
            quotients: Some((p, q)),
        }
    }))
}

/// The polynomial without its integer and monomial content.
fn primitive_part(f: &Polynomial) -> Polynomial {
    let monomial = f.monomial_content();
    let content = f.content();
    if content.is_zero() || (content.is_one() && monomial.is_one()) {
        return f.clone();
    }
    exact(
        f,
        &Polynomial::from_terms(f.ring(), [(monomial, content)]).expect("a term of this ring"),
    )
}
