//! SI unit strings: `kg`, `N s/m`, `m^2/s`, `1/s`, `J/(kg K)`, `V/Hz^(1/2)`.
//!
//! After the SI brochure (9th edition, 2019, section 5): a blank or a dot multiplies, one solidus
//! divides, and what stands after it is one unit or bracketed, since `J/kg K` could mean two things.

use super::dimension::{Base, Dimension};
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Zero};

/// Largest numerator or denominator of an exponent.
const EXPONENT_LIMIT: i64 = 99;

/// Most brackets inside each other.
const DEPTH_LIMIT: usize = 20;

/// A unit: its dimension, and how many coherent SI units it is.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Unit {
    /// The dimension; radian and steradian are pure numbers.
    pub dimension: Dimension,
    /// Whether it is coherent: a product of powers of base units without a factor. `kg` is,
    /// `g`, `km` and `h` are not; numbers in formulas are meant in coherent units.
    pub coherent: bool,
}

impl Unit {
    /// Reads a unit string.
    ///
    /// # Errors
    /// What is wrong, in words.
    pub fn parse(text: &str) -> Result<Unit, String> {
        let mut reader = Reader {
            rest: text.trim(),
            depth: 0,
        };
        let quantity = reader.quotient()?;
        match reader.rest.chars().next() {
            None => Ok(Unit {
                coherent: quantity.factor.as_ref().is_some_and(One::is_one),
                dimension: quantity.dimension,
            }),
            Some('/') => Err("more than one solidus; use brackets".into()),
            Some(c) => Err(format!("`{c}` does not fit here")),
        }
    }
}

/// A dimension with its factor to the coherent unit; none where that is irrational.
struct Quantity {
    dimension: Dimension,
    factor: Option<BigRational>,
}

struct Reader<'t> {
    rest: &'t str,
    depth: usize,
}

impl Reader<'_> {
    fn quotient(&mut self) -> Result<Quantity, String> {
        let above = self.product()?;
        self.blanks();
        let Some(rest) = self.rest.strip_prefix('/') else {
            return Ok(above);
        };
        self.rest = rest;
        self.blanks();
        let below = self.factor()?;
        self.blanks();
        if self.rest.starts_with(|c: char| c != ')' && c != '/') {
            return Err("more than one unit after the solidus; use brackets".into());
        }
        let factor = match (above.factor, below.factor) {
            (Some(a), Some(b)) if !b.is_zero() => Some(a / b),
            _ => None,
        };
        Ok(Quantity {
            dimension: above.dimension.over(&below.dimension),
            factor,
        })
    }

    fn product(&mut self) -> Result<Quantity, String> {
        let mut product = self.factor()?;
        loop {
            self.blanks();
            if let Some(rest) = self.rest.strip_prefix(['*', '·', '.']) {
                self.rest = rest;
                self.blanks();
            } else if self.rest.is_empty() || self.rest.starts_with(['/', ')']) {
                return Ok(product);
            }
            let next = self.factor()?;
            product = Quantity {
                dimension: product.dimension.times(&next.dimension),
                factor: product.factor.zip(next.factor).map(|(a, b)| a * b),
            };
        }
    }

    fn factor(&mut self) -> Result<Quantity, String> {
        let quantity = if let Some(rest) = self.rest.strip_prefix('(') {
            self.depth += 1;
            if self.depth > DEPTH_LIMIT {
                return Err("too many brackets".into());
            }
            self.rest = rest;
            self.blanks();
            let inner = self.quotient()?;
            self.rest = self
                .rest
                .strip_prefix(')')
                .ok_or("a bracket is not closed")?;
            self.depth -= 1;
            inner
        } else if let Some(rest) = self.rest.strip_prefix('1') {
            self.rest = rest;
            Quantity {
                dimension: Dimension::one(),
                factor: Some(BigRational::one()),
            }
        } else {
            self.symbol()?
        };
        self.raised(quantity)
    }

    fn symbol(&mut self) -> Result<Quantity, String> {
        let length = self
            .rest
            .find(|c: char| !(c.is_alphabetic() || c == '%' || c == '°'))
            .unwrap_or(self.rest.len());
        let (symbol, rest) = self.rest.split_at(length);
        if symbol.is_empty() {
            return Err(match self.rest.chars().next() {
                None => "a unit is missing".into(),
                Some(c) => format!("`{c}` is not a unit"),
            });
        }
        self.rest = rest;
        if let Some(found) = named(symbol) {
            return Ok(found);
        }
        for (prefix, power) in PREFIXES {
            if let Some(bare) = symbol.strip_prefix(prefix)
                && PREFIXED.contains(&bare)
                && let Some(found) = named(bare)
            {
                let ten = BigRational::from(BigInt::from(10));
                return Ok(Quantity {
                    dimension: found.dimension,
                    factor: found.factor.map(|factor| factor * ten.pow(*power)),
                });
            }
        }
        Err(format!("`{symbol}` is not an SI unit"))
    }

    /// `^2`, `^-1`, `^(1/2)`, `²`.
    fn raised(&mut self, quantity: Quantity) -> Result<Quantity, String> {
        let superscript = [('²', 2), ('³', 3)]
            .into_iter()
            .find(|(c, _)| self.rest.starts_with(*c));
        let exponent = if let Some((c, power)) = superscript {
            self.rest = &self.rest[c.len_utf8()..];
            BigRational::from(BigInt::from(power))
        } else if let Some(rest) = self.rest.strip_prefix('^') {
            self.rest = rest;
            match self.rest.strip_prefix(['(', '{']) {
                None => BigRational::from(self.integer()?),
                Some(rest) => {
                    self.rest = rest;
                    let numerator = self.integer()?;
                    let denominator = match self.rest.strip_prefix('/') {
                        None => BigInt::one(),
                        Some(rest) => {
                            self.rest = rest;
                            self.integer()?
                        }
                    };
                    if denominator.is_zero() {
                        return Err("an exponent divides by zero".into());
                    }
                    self.rest = self
                        .rest
                        .strip_prefix([')', '}'])
                        .ok_or("the bracket of an exponent is not closed")?;
                    BigRational::new(numerator, denominator)
                }
            }
        } else {
            return Ok(quantity);
        };
        let factor = match quantity.factor {
            Some(factor) if factor.is_one() => Some(factor),
            Some(factor) if exponent.is_integer() => {
                let power: i32 = exponent.numer().try_into().unwrap_or(0);
                Some(factor.pow(power))
            }
            _ => None,
        };
        Ok(Quantity {
            dimension: quantity.dimension.power(&exponent),
            factor,
        })
    }

    fn integer(&mut self) -> Result<BigInt, String> {
        let sign = usize::from(self.rest.starts_with(['-', '+']));
        let digits = self.rest[sign..]
            .find(|c: char| !c.is_ascii_digit())
            .unwrap_or(self.rest.len() - sign);
        let (number, rest) = self.rest.split_at(sign + digits);
        self.rest = rest;
        match number.parse::<i64>() {
            Ok(n) if n.abs() <= EXPONENT_LIMIT => Ok(n.into()),
            Ok(_) => Err(format!("exponents go up to {EXPONENT_LIMIT}")),
            Err(_) => Err("an exponent is a whole number or a bracketed fraction".into()),
        }
    }

    fn blanks(&mut self) {
        self.rest = self.rest.trim_start();
    }
}

/// Powers of ten; two letters before one, so that `da` is not `d`.
const PREFIXES: &[(&str, i32)] = &[
    ("da", 1),
    ("h", 2),
    ("k", 3),
    ("M", 6),
    ("G", 9),
    ("T", 12),
    ("P", 15),
    ("E", 18),
    ("d", -1),
    ("c", -2),
    ("m", -3),
    ("µ", -6),
    ("μ", -6),
    ("u", -6),
    ("n", -9),
    ("p", -12),
    ("f", -15),
];

/// The units that take a prefix.
const PREFIXED: &[&str] = &[
    "m", "g", "s", "A", "K", "mol", "cd", "rad", "Hz", "N", "Pa", "J", "W", "C", "V", "F", "ohm",
    "Ω", "S", "Wb", "T", "H", "lm", "lx", "bar", "L", "l", "eV",
];

/// The units by their symbols, without prefix.
fn named(symbol: &str) -> Option<Quantity> {
    // Exponents of kg, m, s, A, K, mol, cd, and the factor as numerator and denominator.
    let (exponents, numerator, denominator): ([i32; 7], i64, i64) = match symbol {
        "kg" => ([1, 0, 0, 0, 0, 0, 0], 1, 1),
        "g" => ([1, 0, 0, 0, 0, 0, 0], 1, 1000),
        "t" => ([1, 0, 0, 0, 0, 0, 0], 1000, 1),
        "m" => ([0, 1, 0, 0, 0, 0, 0], 1, 1),
        "s" => ([0, 0, 1, 0, 0, 0, 0], 1, 1),
        "min" => ([0, 0, 1, 0, 0, 0, 0], 60, 1),
        "h" => ([0, 0, 1, 0, 0, 0, 0], 3600, 1),
        "A" => ([0, 0, 0, 1, 0, 0, 0], 1, 1),
        "K" => ([0, 0, 0, 0, 1, 0, 0], 1, 1),
        "mol" => ([0, 0, 0, 0, 0, 1, 0], 1, 1),
        "cd" | "lm" => ([0, 0, 0, 0, 0, 0, 1], 1, 1),
        "rad" | "sr" => ([0; 7], 1, 1),
        // Pi is irrational: any factor but one says that it is not coherent.
        "deg" | "°" => ([0; 7], 1, 180),
        "%" => ([0; 7], 1, 100),
        "Hz" | "Bq" => ([0, 0, -1, 0, 0, 0, 0], 1, 1),
        "N" => ([1, 1, -2, 0, 0, 0, 0], 1, 1),
        "Pa" => ([1, -1, -2, 0, 0, 0, 0], 1, 1),
        "bar" => ([1, -1, -2, 0, 0, 0, 0], 100_000, 1),
        "J" => ([1, 2, -2, 0, 0, 0, 0], 1, 1),
        // Only the dimension is used; the factor just says that it is not coherent.
        "eV" => ([1, 2, -2, 0, 0, 0, 0], 1, i64::MAX),
        "W" => ([1, 2, -3, 0, 0, 0, 0], 1, 1),
        "C" => ([0, 0, 1, 1, 0, 0, 0], 1, 1),
        "V" => ([1, 2, -3, -1, 0, 0, 0], 1, 1),
        "F" => ([-1, -2, 4, 2, 0, 0, 0], 1, 1),
        "ohm" | "Ω" => ([1, 2, -3, -2, 0, 0, 0], 1, 1),
        "S" => ([-1, -2, 3, 2, 0, 0, 0], 1, 1),
        "Wb" => ([1, 2, -2, -1, 0, 0, 0], 1, 1),
        "T" => ([1, 0, -2, -1, 0, 0, 0], 1, 1),
        "H" => ([1, 2, -2, -2, 0, 0, 0], 1, 1),
        "lx" => ([0, -2, 0, 0, 0, 0, 1], 1, 1),
        "Gy" | "Sv" => ([0, 2, -2, 0, 0, 0, 0], 1, 1),
        "kat" => ([0, 0, -1, 0, 0, 1, 0], 1, 1),
        "L" | "l" => ([0, 3, 0, 0, 0, 0, 0], 1, 1000),
        _ => return None,
    };
    let bases = [
        Base::Kilogram,
        Base::Metre,
        Base::Second,
        Base::Ampere,
        Base::Kelvin,
        Base::Mole,
        Base::Candela,
    ];
    let mut dimension = Dimension::one();
    for (base, exponent) in bases.into_iter().zip(exponents) {
        let exponent = BigRational::from(BigInt::from(exponent));
        dimension = dimension.times_power(&Dimension::base(base), &exponent);
    }
    Some(Quantity {
        dimension,
        factor: Some(BigRational::new(numerator.into(), denominator.into())),
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn shown(text: &str) -> String {
        match Unit::parse(text) {
            Ok(unit) => format!(
                "{}{}",
                unit.dimension,
                if unit.coherent { "" } else { ", with a factor" }
            ),
            Err(why) => why,
        }
    }

    #[test]
    fn units_in_base_units() {
        for (text, expected) in [
            ("kg", "kg"),
            ("N/m", "kg/s^2"),
            ("N s/m", "kg/s"),
            ("m^2/s", "m^2/s"),
            ("Hz", "1/s"),
            ("rad/m", "1/m"),
            ("1", "1"),
            ("1/s", "1/s"),
            ("J/(kg K)", "m^2/(s^2 K)"),
            ("kg*m·s^-2", "kg m/s^2"),
            ("V/Hz^(1/2)", "kg m^2/(s^(5/2) A)"),
            ("m²", "m^2"),
            ("ohm F", "s"),
            ("Pa m^3", "kg m^2/s^2"),
            ("mm/ms", "m/s"),
            ("km", "m, with a factor"),
            ("kN/m", "kg/s^2, with a factor"),
            ("g", "kg, with a factor"),
            ("min", "s, with a factor"),
            ("cd", "cd"),
            ("mm^(1/2)", "m^(1/2), with a factor"),
            ("deg", "1, with a factor"),
        ] {
            assert_eq!(shown(text), expected, "{text}");
        }
    }

    #[test]
    fn what_is_no_unit_is_refused() {
        for text in [
            "", "kilo", "kgm", "m/s/s", "kg/m s", "2 m", "m^", "m^x", "m^1.5", "m^(1/0)", "(m",
            "m)", "m^100", "/s", "m//s", "°C", "ft", "m^(1/2", "mkg", "kmin", "m^2^2x",
        ] {
            assert!(Unit::parse(text).is_err(), "{text} is {}", shown(text));
        }
        assert!(Unit::parse(&"(".repeat(100_000)).is_err());
    }

    proptest! {
        #[test]
        fn no_text_panics(text in "[a-zA-Zµ°²·0-9 /()^*.-]{0,20}") {
            let _ = Unit::parse(&text);
        }

        #[test]
        fn what_is_shown_is_read_back(kg in -4i32..5, m in -4i32..5, s in -4i32..5, half in -3i32..4) {
            let mut dimension = Dimension::one();
            for (base, n, d) in [(Base::Kilogram, kg, 1), (Base::Metre, m, 1), (Base::Second, s, 1), (Base::Ampere, half, 2)] {
                let exponent = BigRational::new(n.into(), d.into());
                dimension = dimension.times_power(&Dimension::base(base), &exponent);
            }
            let unit = Unit::parse(&dimension.to_string()).unwrap();
            prop_assert_eq!(unit.dimension, dimension);
            prop_assert!(unit.coherent);
        }
    }
}
