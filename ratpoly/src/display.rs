//! The plain notation: `3*a^2*b - 1`, `(x - y)/(2*x)`. [`parse`](crate::Polynomial::parse) reads it back.

use crate::polynomial::Polynomial;
use crate::rational_function::RationalFunction;
use num_traits::{One, Signed};
use std::fmt;

impl fmt::Display for Polynomial {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.is_zero() {
            return f.write_str("0");
        }
        let ring = self.ring();
        for (i, (monomial, coefficient)) in self.terms().enumerate() {
            f.write_str(match (i, coefficient.is_negative()) {
                (0, false) => "",
                (0, true) => "-",
                (_, false) => " + ",
                (_, true) => " - ",
            })?;
            let size = coefficient.abs();
            let mut first = true;
            if !size.is_one() || monomial.is_one() {
                write!(f, "{size}")?;
                first = false;
            }
            for (name, &e) in ring.variables().iter().zip(monomial.exponents()) {
                if e == 0 {
                    continue;
                }
                if !std::mem::take(&mut first) {
                    f.write_str("*")?;
                }
                f.write_str(name)?;
                if e > 1 {
                    write!(f, "^{e}")?;
                }
            }
        }
        Ok(())
    }
}

impl fmt::Display for RationalFunction {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (numerator, denominator) = (self.numerator(), self.denominator());
        if denominator.is_one() {
            return write!(f, "{numerator}");
        }
        if numerator.len() > 1 {
            write!(f, "({numerator})/")?;
        } else {
            write!(f, "{numerator}/")?;
        }
        if denominator.is_constant() || is_plain_power(denominator) {
            write!(f, "{denominator}")
        } else {
            write!(f, "({denominator})")
        }
    }
}

/// Whether this is a power of one variable, which needs no brackets in a denominator.
fn is_plain_power(p: &Polynomial) -> bool {
    p.len() == 1 && p.leading_coefficient().is_one() && p.variables_occurring().len() == 1
}

impl fmt::Debug for Polynomial {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{self}")
    }
}

impl fmt::Debug for RationalFunction {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{self}")
    }
}
