//! Limits of quotients of power sums, towards zero from above and towards infinity.
//!
//! Numerator and denominator are sums of c x^e with exponents free of x; the term of the largest
//! exponent decides at infinity, that of the smallest at zero (Hardy, *Orders of Infinity*, 1910,
//! for the scale of powers). Exponents with letters are compared by the signs that their
//! differences have for all admitted values.

use crate::functions::{FunctionLetter, FunctionTable, Impossible, Possible, TermList};
use num_rational::BigRational;
use ratpoly::{Polynomial, RationalFunction};
use std::cmp::Ordering;

/// Where a letter goes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Towards {
    /// Zero, from above.
    Zero,
    /// Infinity.
    Infinity,
}

/// What becomes of an element there.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Limit {
    /// It tends to an element.
    To(RationalFunction),
    /// It grows beyond every bound, to plus infinity.
    Infinite,
    /// It falls below every bound.
    MinusInfinite,
}

/// `coefficient * x^exponent`, the leading term of a sum.
struct Leading {
    coefficient: RationalFunction,
    exponent: RationalFunction,
}

/// The limit of an element as a positive letter goes to zero or infinity.
///
/// # Errors
/// Where other functions of the letter occur, or a sign is not known.
pub fn limit(
    table: &FunctionTable,
    f: &RationalFunction,
    letter: usize,
    towards: Towards,
) -> Possible<Limit> {
    if f.is_zero() {
        return Ok(Limit::To(f.clone()));
    }
    let powers = powers_of(table, f, letter)?;
    let above = leading(table, f.numerator(), letter, &powers, towards)?;
    let below = leading(table, f.denominator(), letter, &powers, towards)?;
    let exponent = &above.exponent - &below.exponent;
    let coefficient = table.reduce(above.coefficient.checked_div(&below.coefficient)?);
    let growth = sign_of_exponent(table, &exponent)?;
    let growth = match towards {
        Towards::Infinity => growth,
        Towards::Zero => growth.reverse(),
    };
    match (growth, table.sign(&coefficient)) {
        (Ordering::Less, _) => Ok(Limit::To(RationalFunction::zero(table.ring()))),
        (Ordering::Equal, _) => Ok(Limit::To(coefficient)),
        (Ordering::Greater, Some(Ordering::Greater)) => Ok(Limit::Infinite),
        (Ordering::Greater, Some(Ordering::Less)) => Ok(Limit::MinusInfinite),
        _ => Err(Impossible::unsupported(
            "a limit whose sign depends on its letters",
        )),
    }
}

/// The letters that stand for powers of this one, with their exponents.
fn powers_of(
    table: &FunctionTable,
    f: &RationalFunction,
    letter: usize,
) -> Possible<Vec<(usize, RationalFunction)>> {
    let mut occurring = f.numerator().variables_occurring();
    occurring.extend(f.denominator().variables_occurring());
    let mut powers = Vec::new();
    for (other, function) in table.all() {
        let depends = || table.letters_behind(&RationalFunction::variable(table.ring(), other));
        if other == letter || !occurring.contains(&other) || !depends().contains(&letter) {
            continue;
        }
        match function {
            FunctionLetter::Power(base, exponent)
                if base == Polynomial::variable(table.ring(), letter)
                    && !table.letters_behind(&exponent).contains(&letter) =>
            {
                powers.push((other, exponent));
            }
            _ => {
                return Err(Impossible::unsupported(
                    "a limit of other functions than powers",
                ));
            }
        }
    }
    Ok(powers)
}

fn sign_of_exponent(table: &FunctionTable, exponent: &RationalFunction) -> Possible<Ordering> {
    table
        .sign(exponent)
        .ok_or_else(|| Impossible::unsupported("a limit that depends on the sign of an exponent"))
}

fn leading(
    table: &FunctionTable,
    p: &Polynomial,
    letter: usize,
    powers: &[(usize, RationalFunction)],
    towards: Towards,
) -> Possible<Leading> {
    let number =
        |n: u32| RationalFunction::constant(table.ring(), BigRational::from_integer(n.into()));
    let mut groups: Vec<(RationalFunction, TermList)> = Vec::new();
    for (monomial, c) in p.terms() {
        let mut rest = monomial.exponents().to_vec();
        let mut exponent = number(std::mem::take(&mut rest[letter]));
        for (power, e) in powers {
            exponent = &exponent + &(&number(std::mem::take(&mut rest[*power])) * e);
        }
        match groups.iter_mut().find(|(e, _)| *e == exponent) {
            Some((_, terms)) => terms.push((rest, c)),
            None => groups.push((exponent, vec![(rest, c)])),
        }
    }
    let mut best: Option<(RationalFunction, TermList)> = None;
    for (exponent, terms) in groups {
        let better = match &best {
            None => true,
            Some((known, _)) => {
                let sign = sign_of_exponent(table, &(&exponent - known))?;
                sign == match towards {
                    Towards::Infinity => Ordering::Greater,
                    Towards::Zero => Ordering::Less,
                }
            }
        };
        if better {
            best = Some((exponent, terms));
        }
    }
    let (exponent, terms) = best.ok_or(Impossible::DivisionByZero)?;
    Ok(Leading {
        coefficient: Polynomial::from_terms(table.ring(), terms)?.into(),
        exponent,
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::range::Range;
    use ratpoly::{Order, Ring};

    #[test]
    fn powers_with_letters_in_the_exponent() {
        let ring = Ring::new(["x", "w", "c", "r0", "r1"], Order::Grevlex).unwrap();
        let table = FunctionTable::new(ring, vec![Range::positive(); 3]);
        let [x, w, c] = [0, 1, 2].map(|l| RationalFunction::variable(ring, l));
        let fall = c.checked_div(&table.power(&x, &w).unwrap()).unwrap();
        let at = |f: &RationalFunction, towards| limit(&table, f, 0, towards).unwrap();
        assert_eq!(at(&fall, Towards::Zero), Limit::Infinite);
        assert_eq!(
            at(&fall, Towards::Infinity),
            Limit::To(RationalFunction::zero(ring))
        );
        // Whether x^(1 - w) grows depends on w.
        assert!(limit(&table, &(&fall * &x), 0, Towards::Infinity).is_err());
        let spectrum = RationalFunction::parse(ring, "c/(c^2 + x^2)").unwrap();
        assert_eq!(
            at(&(&(&x * &x) * &spectrum), Towards::Infinity),
            Limit::To(c.clone())
        );
        assert_eq!(
            at(&spectrum, Towards::Zero),
            Limit::To(c.inverse().unwrap())
        );
        assert_eq!(at(&-&(&x * &c), Towards::Infinity), Limit::MinusInfinite);
    }
}
