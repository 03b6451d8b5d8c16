//! Dimensions: products of rational powers of the seven SI base units and of unknown dimensions.
//!
//! Dimensions form a vector space over the rationals, written multiplicatively. Invariant: no
//! generator is stored with the exponent zero, so that equal dimensions are equal values.

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Signed, Zero};
use std::collections::BTreeMap;
use std::fmt;

/// A base unit of the SI, in the order in which a product of them is written.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Base {
    /// `kg`
    Kilogram,
    /// `m`
    Metre,
    /// `s`
    Second,
    /// `A`
    Ampere,
    /// `K`
    Kelvin,
    /// `mol`
    Mole,
    /// `cd`
    Candela,
}

impl Base {
    /// The symbol.
    pub fn symbol(self) -> &'static str {
        match self {
            Base::Kilogram => "kg",
            Base::Metre => "m",
            Base::Second => "s",
            Base::Ampere => "A",
            Base::Kelvin => "K",
            Base::Mole => "mol",
            Base::Candela => "cd",
        }
    }
}

/// A dimension that is not known yet.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub(super) struct Unknown(pub usize);

/// What dimensions are products of.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub(super) enum Generator {
    Base(Base),
    Unknown(Unknown),
}

/// A dimension.
#[derive(Clone, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub struct Dimension {
    exponents: BTreeMap<Generator, BigRational>,
}

impl Dimension {
    /// The dimension of a pure number.
    pub fn one() -> Self {
        Dimension::default()
    }

    /// A base unit.
    pub fn base(base: Base) -> Self {
        Dimension::generator(Generator::Base(base))
    }

    pub(super) fn unknown(unknown: Unknown) -> Self {
        Dimension::generator(Generator::Unknown(unknown))
    }

    fn generator(generator: Generator) -> Self {
        Dimension {
            exponents: BTreeMap::from([(generator, BigRational::one())]),
        }
    }

    /// Whether it is the dimension of a pure number.
    pub fn is_one(&self) -> bool {
        self.exponents.is_empty()
    }

    /// Whether nothing in it is unknown.
    pub fn is_known(&self) -> bool {
        self.first_unknown().is_none()
    }

    /// The unknown in it that came up last, with its exponent.
    pub(super) fn first_unknown(&self) -> Option<(Unknown, &BigRational)> {
        match self.exponents.last_key_value() {
            Some((Generator::Unknown(unknown), exponent)) => Some((*unknown, exponent)),
            _ => None,
        }
    }

    pub(super) fn unknowns(&self) -> impl Iterator<Item = (Unknown, &BigRational)> {
        self.exponents
            .iter()
            .filter_map(|(generator, exponent)| match generator {
                Generator::Unknown(unknown) => Some((*unknown, exponent)),
                Generator::Base(_) => None,
            })
    }

    /// The product with a power of another dimension.
    #[must_use]
    pub fn times_power(&self, other: &Dimension, power: &BigRational) -> Dimension {
        let mut exponents = self.exponents.clone();
        if !power.is_zero() {
            for (generator, exponent) in &other.exponents {
                let sum = exponents
                    .entry(*generator)
                    .or_insert_with(BigRational::zero);
                *sum += exponent * power;
                if sum.is_zero() {
                    exponents.remove(generator);
                }
            }
        }
        Dimension { exponents }
    }

    /// The product.
    #[must_use]
    pub fn times(&self, other: &Dimension) -> Dimension {
        self.times_power(other, &BigRational::one())
    }

    /// The quotient.
    #[must_use]
    pub fn over(&self, other: &Dimension) -> Dimension {
        self.times_power(other, &-BigRational::one())
    }

    /// A power.
    #[must_use]
    pub fn power(&self, exponent: &BigRational) -> Dimension {
        Dimension::one().times_power(self, exponent)
    }

    /// In SI base units, with a word for each unknown.
    pub(super) fn show(&self, name: &dyn Fn(Unknown) -> String) -> String {
        let mut above = Vec::new();
        let mut below = Vec::new();
        for (generator, exponent) in &self.exponents {
            let symbol = match generator {
                Generator::Base(base) => base.symbol().to_owned(),
                Generator::Unknown(unknown) => format!("[{}]", name(*unknown)),
            };
            let list = if exponent.is_positive() {
                &mut above
            } else {
                &mut below
            };
            list.push(raised(symbol, &exponent.abs()));
        }
        let numerator = if above.is_empty() {
            "1".to_owned()
        } else {
            above.join(" ")
        };
        match below.len() {
            0 => numerator,
            1 => format!("{numerator}/{}", below[0]),
            _ => format!("{numerator}/({})", below.join(" ")),
        }
    }
}

fn raised(symbol: String, exponent: &BigRational) -> String {
    if exponent.is_one() {
        symbol
    } else if exponent.denom() == &BigInt::one() {
        format!("{symbol}^{exponent}")
    } else {
        format!("{symbol}^({exponent})")
    }
}

/// In SI base units: `kg m/s^2`.
impl fmt::Display for Dimension {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.show(&|unknown| format!("?{}", unknown.0)))
    }
}
