//! Reading the plain notation: sums, differences, products, quotients, powers, brackets.
//!
//! Every value within is a pair of polynomials; a pair is reduced once, at the end.

use crate::budget::Budget;
use crate::error::{Error, ParseErrorKind};
use crate::polynomial::Polynomial;
use crate::rational_function::RationalFunction;
use crate::ring::{Ring, is_name_continue, is_name_start};
use num_bigint::BigInt;
use std::str::FromStr;

/// Brackets and signs nested deeper than this are refused.
const MAX_DEPTH: usize = 200;

impl Polynomial {
    /// Reads a polynomial in the plain notation, for example `3*a^2*b - (a - 1)*(a + 1)`. Quotients are
    /// allowed where the result has integer coefficients.
    pub fn parse(ring: Ring, text: &str) -> Result<Self, Error> {
        let (numerator, denominator) = RationalFunction::parse(ring, text)?.into_parts();
        if denominator.is_one() {
            Ok(numerator)
        } else {
            Err(Error::Parse {
                position: 0,
                kind: ParseErrorKind::NotAPolynomial,
            })
        }
    }
}

impl RationalFunction {
    /// Reads a rational function in the plain notation, for example `(x - 1)/(2*x) + 1/3`.
    pub fn parse(ring: Ring, text: &str) -> Result<Self, Error> {
        let budget = Budget::new(1_000_000, 100_000, 30_000_000);
        let mut parser = Parser {
            ring,
            text,
            position: 0,
            depth: 0,
            budget,
        };
        let (numerator, denominator) = parser.sum()?;
        parser.skip_space();
        match parser.peek() {
            None => RationalFunction::new_within(numerator, denominator, &parser.budget)
                .map_err(|_| parser.error(ParseErrorKind::TooLarge)),
            Some(')') => Err(parser.error(ParseErrorKind::UnbalancedBracket)),
            Some(_) => Err(parser.error(ParseErrorKind::UnexpectedCharacter)),
        }
    }
}

/// Numerator and denominator, not reduced.
type Pair = (Polynomial, Polynomial);

struct Parser<'a> {
    ring: Ring,
    text: &'a str,
    position: usize,
    depth: usize,
    budget: Budget,
}

impl Parser<'_> {
    fn error(&self, kind: ParseErrorKind) -> Error {
        Error::Parse {
            position: self.position,
            kind,
        }
    }

    fn peek(&self) -> Option<char> {
        self.text[self.position..].chars().next()
    }

    fn skip_space(&mut self) {
        let rest = &self.text[self.position..];
        self.position += rest.len() - rest.trim_start().len();
    }

    /// Skips white space, then one of the characters if it stands there.
    fn accept(&mut self, wanted: &[char]) -> Option<char> {
        self.skip_space();
        let c = self.peek().filter(|c| wanted.contains(c))?;
        self.position += c.len_utf8();
        Some(c)
    }

    fn take_while(&mut self, accept: impl Fn(char) -> bool) -> &str {
        let rest = &self.text[self.position..];
        let length = rest.find(|c| !accept(c)).unwrap_or(rest.len());
        self.position += length;
        &rest[..length]
    }

    fn limited(&self, result: Result<Polynomial, Error>) -> Result<Polynomial, Error> {
        result.map_err(|_| self.error(ParseErrorKind::TooLarge))
    }

    fn multiply(&self, a: &Polynomial, b: &Polynomial) -> Result<Polynomial, Error> {
        if a.is_one() {
            return Ok(b.clone());
        }
        if b.is_one() {
            return Ok(a.clone());
        }
        self.limited(a.mul_within(b, &self.budget))
    }

    fn enter(&mut self) -> Result<(), Error> {
        self.depth += 1;
        if self.depth > MAX_DEPTH {
            Err(self.error(ParseErrorKind::TooLarge))
        } else {
            Ok(())
        }
    }

    fn sum(&mut self) -> Result<Pair, Error> {
        self.enter()?;
        // Summands over the same denominator are gathered and added at once.
        let mut denominator = Polynomial::one(self.ring);
        let mut summands: Vec<Polynomial> = Vec::new();
        let mut negative = false;
        loop {
            let (n, d) = self.product()?;
            let n = if negative { -n } else { n };
            if d == denominator {
                summands.push(n);
            } else {
                let so_far = self.add_all(&mut summands)?;
                let left = self.multiply(&so_far, &d)?;
                summands.push(left.try_add(&self.multiply(&n, &denominator)?)?);
                denominator = self.multiply(&denominator, &d)?;
            }
            match self.accept(&['+', '-']) {
                Some(sign) => negative = sign == '-',
                None => break,
            }
        }
        self.depth -= 1;
        Ok((self.add_all(&mut summands)?, denominator))
    }

    fn add_all(&self, summands: &mut Vec<Polynomial>) -> Result<Polynomial, Error> {
        let terms = summands.iter().flat_map(Polynomial::terms);
        let sum = Polynomial::from_terms(self.ring, terms)?;
        summands.clear();
        Ok(sum)
    }

    fn product(&mut self) -> Result<Pair, Error> {
        let (mut n, mut d) = self.power()?;
        while let Some(operator) = self.accept(&['*', '/']) {
            let start = self.position;
            let (a, b) = self.power()?;
            if operator == '*' {
                (n, d) = (self.multiply(&n, &a)?, self.multiply(&d, &b)?);
            } else if a.is_zero() {
                self.position = start;
                return Err(self.error(ParseErrorKind::DivisionByZero));
            } else {
                (n, d) = (self.multiply(&n, &b)?, self.multiply(&d, &a)?);
            }
        }
        Ok((n, d))
    }

    /// A signed power; the sign binds less than `^`: `-x^2` is `-(x^2)`.
    fn power(&mut self) -> Result<Pair, Error> {
        if let Some(sign) = self.accept(&['+', '-']) {
            self.enter()?;
            let (n, d) = self.power()?;
            self.depth -= 1;
            return Ok((if sign == '-' { -n } else { n }, d));
        }
        let (n, d) = self.operand()?;
        if self.accept(&['^']).is_none() {
            return Ok((n, d));
        }
        let inverse = self.accept(&['-']).is_some();
        self.skip_space();
        let start = self.position;
        let digits = self.take_while(|c| c.is_ascii_digit());
        let Ok(exponent) = digits.parse::<u32>() else {
            self.position = start;
            return Err(self.error(ParseErrorKind::InvalidExponent));
        };
        if inverse && n.is_zero() {
            self.position = start;
            return Err(self.error(ParseErrorKind::DivisionByZero));
        }
        let n = self.limited(n.pow_within(exponent, &self.budget))?;
        let d = self.limited(d.pow_within(exponent, &self.budget))?;
        Ok(if inverse { (d, n) } else { (n, d) })
    }

    fn operand(&mut self) -> Result<Pair, Error> {
        self.skip_space();
        let one = Polynomial::one(self.ring);
        let start = self.position;
        match self.peek() {
            Some('(') => {
                self.position += 1;
                let value = self.sum()?;
                if self.accept(&[')']).is_none() {
                    let kind = match self.peek() {
                        None => ParseErrorKind::UnbalancedBracket,
                        Some(_) => ParseErrorKind::UnexpectedCharacter,
                    };
                    return Err(self.error(kind));
                }
                Ok(value)
            }
            Some(c) if c.is_ascii_digit() => {
                let digits = self.take_while(|c| c.is_ascii_digit());
                if digits.len() > 100_000 {
                    return Err(self.error(ParseErrorKind::TooLarge));
                }
                let value = BigInt::from_str(digits).expect("decimal digits");
                Ok((Polynomial::constant(self.ring, value), one))
            }
            Some(c) if is_name_start(c) => {
                let name = self.take_while(is_name_continue).to_string();
                match self.ring.index_of(&name) {
                    Ok(index) => Ok((Polynomial::variable(self.ring, index), one)),
                    Err(_) => {
                        self.position = start;
                        Err(self.error(ParseErrorKind::UnknownVariable))
                    }
                }
            }
            _ => Err(self.error(ParseErrorKind::ExpectedOperand)),
        }
    }
}
