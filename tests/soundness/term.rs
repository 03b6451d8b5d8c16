//! Formulas as the generator makes them: written as LaTeX by a writer of their own, and evaluated
//! exactly over the rationals or in complex floating point. Nothing here is the program's.

use super::complex::Complex;
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Signed, ToPrimitive, Zero};
use std::ops::{Add, Div, Mul, Neg, Sub};

/// A function of one argument.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Function {
    Sqrt,
    Exp,
    Ln,
    Sin,
    Cos,
    Tan,
    Cot,
    Sinh,
    Cosh,
    Tanh,
    Abs,
    Re,
    Im,
}

/// A formula.
#[derive(Clone, Debug, PartialEq)]
pub enum Term {
    Number(BigRational),
    Letter(&'static str),
    Sum(Vec<Term>),
    Product(Vec<Term>),
    Minus(Box<Term>),
    Quotient(Box<Term>, Box<Term>),
    Power(Box<Term>, Box<Term>),
    Call(Function, Box<Term>),
    Pi,
    /// The base of exponentials.
    E,
    /// The imaginary unit.
    I,
}

/// What a letter stands for.
pub type Letters<'l, T> = &'l dyn Fn(&str) -> Option<T>;

pub fn n(value: i64) -> Term {
    Term::Number(BigRational::from_integer(BigInt::from(value)))
}

pub fn q(numerator: i64, denominator: i64) -> Term {
    Term::Number(BigRational::new(numerator.into(), denominator.into()))
}

pub fn v(letter: &'static str) -> Term {
    Term::Letter(letter)
}

pub fn call(function: Function, argument: Term) -> Term {
    Term::Call(function, Box::new(argument))
}

pub fn sqrt(t: Term) -> Term {
    call(Function::Sqrt, t)
}
pub fn exp(t: Term) -> Term {
    call(Function::Exp, t)
}
pub fn ln(t: Term) -> Term {
    call(Function::Ln, t)
}
pub fn sin(t: Term) -> Term {
    call(Function::Sin, t)
}
pub fn cos(t: Term) -> Term {
    call(Function::Cos, t)
}
pub fn tan(t: Term) -> Term {
    call(Function::Tan, t)
}
pub fn sinh(t: Term) -> Term {
    call(Function::Sinh, t)
}
pub fn cosh(t: Term) -> Term {
    call(Function::Cosh, t)
}
pub fn tanh(t: Term) -> Term {
    call(Function::Tanh, t)
}
pub fn abs(t: Term) -> Term {
    call(Function::Abs, t)
}

impl Add for Term {
    type Output = Term;
    fn add(self, o: Term) -> Term {
        let mut terms = match self {
            Term::Sum(terms) => terms,
            other => vec![other],
        };
        terms.push(o);
        Term::Sum(terms)
    }
}
impl Sub for Term {
    type Output = Term;
    fn sub(self, o: Term) -> Term {
        self + -o
    }
}
impl Neg for Term {
    type Output = Term;
    fn neg(self) -> Term {
        Term::Minus(Box::new(self))
    }
}
impl Mul for Term {
    type Output = Term;
    fn mul(self, o: Term) -> Term {
        let mut factors = match self {
            Term::Product(factors) => factors,
            other => vec![other],
        };
        match o {
            Term::Product(more) => factors.extend(more),
            other => factors.push(other),
        }
        Term::Product(factors)
    }
}
impl Div for Term {
    type Output = Term;
    fn div(self, o: Term) -> Term {
        Term::Quotient(Box::new(self), Box::new(o))
    }
}

impl Term {
    pub fn pow(self, exponent: i64) -> Term {
        self.to(n(exponent))
    }

    pub fn to(self, exponent: Term) -> Term {
        Term::Power(Box::new(self), Box::new(exponent))
    }

    /// In LaTeX.
    pub fn latex(&self) -> String {
        match self {
            Term::Number(x) => number(x),
            Term::Letter(name) => (*name).to_string(),
            Term::Pi => r"\pi".into(),
            Term::E => "e".into(),
            Term::I => "j".into(),
            Term::Sum(terms) => sum(terms),
            Term::Product(factors) => product(factors),
            Term::Minus(t) => format!("-{}", bracketed_minus(t.as_factor())),
            Term::Quotient(a, b) => format!(r"\frac{{{}}}{{{}}}", a.latex(), b.latex()),
            Term::Power(base, exponent) => power(base, exponent),
            Term::Call(function, argument) => called(*function, argument, None),
        }
    }

    /// In LaTeX where a factor stands.
    fn as_factor(&self) -> String {
        match self {
            Term::Sum(_) | Term::Minus(_) => format!("({})", self.latex()),
            Term::Number(x) if x.is_negative() => format!("({})", self.latex()),
            _ => self.latex(),
        }
    }

    /// Each part of it, from outside.
    pub fn children_mut(&mut self) -> Vec<&mut Term> {
        match self {
            Term::Number(_) | Term::Letter(_) | Term::Pi | Term::E | Term::I => Vec::new(),
            Term::Sum(parts) | Term::Product(parts) => parts.iter_mut().collect(),
            Term::Minus(t) | Term::Call(_, t) => vec![&mut **t],
            Term::Quotient(a, b) | Term::Power(a, b) => vec![&mut **a, &mut **b],
        }
    }

    pub fn children(&self) -> Vec<&Term> {
        match self {
            Term::Number(_) | Term::Letter(_) | Term::Pi | Term::E | Term::I => Vec::new(),
            Term::Sum(parts) | Term::Product(parts) => parts.iter().collect(),
            Term::Minus(t) | Term::Call(_, t) => vec![&**t],
            Term::Quotient(a, b) | Term::Power(a, b) => vec![&**a, &**b],
        }
    }

    /// Its letters, each once.
    pub fn letters(&self) -> Vec<&'static str> {
        let mut found = Vec::new();
        self.collect(&mut found);
        found
    }

    fn collect(&self, found: &mut Vec<&'static str>) {
        if let Term::Letter(name) = self
            && !found.contains(name)
        {
            found.push(name);
        }
        for child in self.children() {
            child.collect(found);
        }
    }

    /// With a letter replaced.
    #[must_use]
    pub fn with(&self, letter: &str, by: &Term) -> Term {
        if matches!(self, Term::Letter(name) if *name == letter) {
            return by.clone();
        }
        let mut copy = self.clone();
        for child in copy.children_mut() {
            *child = child.with(letter, by);
        }
        copy
    }

    /// Its exact value, where it is rational in its letters; none at a pole.
    pub fn exact(&self, letters: Letters<'_, BigRational>) -> Option<BigRational> {
        Some(match self {
            Term::Number(x) => x.clone(),
            Term::Letter(name) => letters(name)?,
            Term::Sum(terms) => {
                let mut total = BigRational::zero();
                for term in terms {
                    total += term.exact(letters)?;
                }
                total
            }
            Term::Product(factors) => {
                let mut total = BigRational::one();
                for factor in factors {
                    total *= factor.exact(letters)?;
                }
                total
            }
            Term::Minus(t) => -t.exact(letters)?,
            Term::Quotient(a, b) => {
                let b = b.exact(letters)?;
                if b.is_zero() {
                    return None;
                }
                a.exact(letters)? / b
            }
            Term::Power(base, exponent) => {
                let exponent = exponent.exact(letters)?;
                let base = base.exact(letters)?;
                if !exponent.is_integer() || (base.is_zero() && !exponent.is_positive()) {
                    return None;
                }
                let k = exponent.to_integer().to_i32()?;
                num_traits::pow::Pow::pow(base, k)
            }
            Term::Call(Function::Abs, t) => t.exact(letters)?.abs(),
            Term::Call(..) | Term::Pi | Term::E | Term::I => return None,
        })
    }

    /// Its value in floating point; none where it has none.
    pub fn value(&self, letters: Letters<'_, Complex>) -> Option<Complex> {
        let found = match self {
            Term::Number(x) => Complex::real(x.to_f64()?),
            Term::Letter(name) => letters(name)?,
            Term::Pi => Complex::real(std::f64::consts::PI),
            Term::E => Complex::real(std::f64::consts::E),
            Term::I => Complex::I,
            Term::Sum(terms) => {
                let mut total = Complex::real(0.0);
                for term in terms {
                    total = total + term.value(letters)?;
                }
                total
            }
            Term::Product(factors) => {
                let mut total = Complex::real(1.0);
                for factor in factors {
                    total = total * factor.value(letters)?;
                }
                total
            }
            Term::Minus(t) => -t.value(letters)?,
            Term::Quotient(a, b) => {
                let b = b.value(letters)?;
                if b.modulus() < 1e-6 {
                    return None;
                }
                a.value(letters)? / b
            }
            Term::Power(base, exponent) => base.value(letters)?.power(exponent.value(letters)?)?,
            Term::Call(function, t) => function.value(t.value(letters)?)?,
        };
        found.is_usable().then_some(found)
    }
}

impl Function {
    pub fn value(self, x: Complex) -> Option<Complex> {
        let divided = |a: Complex, b: Complex| (b.modulus() > 1e-6).then(|| a / b);
        match self {
            Function::Sqrt => Some(x.sqrt()),
            Function::Exp => Some(x.exp()),
            Function::Ln => (x.modulus() > 0.0).then(|| x.ln()),
            Function::Sin => Some(x.sin()),
            Function::Cos => Some(x.cos()),
            Function::Tan => divided(x.sin(), x.cos()),
            Function::Cot => divided(x.cos(), x.sin()),
            Function::Sinh => Some(x.sinh()),
            Function::Cosh => Some(x.cosh()),
            Function::Tanh => divided(x.sinh(), x.cosh()),
            Function::Abs => Some(Complex::real(x.modulus())),
            Function::Re => Some(Complex::real(x.re)),
            Function::Im => Some(Complex::real(x.im)),
        }
    }

    fn name(self) -> &'static str {
        match self {
            Function::Ln => r"\ln",
            Function::Sin => r"\sin",
            Function::Cos => r"\cos",
            Function::Tan => r"\tan",
            Function::Cot => r"\cot",
            Function::Sinh => r"\sinh",
            Function::Cosh => r"\cosh",
            Function::Tanh => r"\tanh",
            Function::Re => r"\operatorname{Re}",
            Function::Im => r"\operatorname{Im}",
            Function::Sqrt | Function::Exp | Function::Abs => "",
        }
    }

    /// Whether its powers are printed at its name.
    fn has_powers(self) -> bool {
        match self {
            Function::Sin
            | Function::Cos
            | Function::Tan
            | Function::Cot
            | Function::Sinh
            | Function::Cosh
            | Function::Tanh => true,
            Function::Sqrt
            | Function::Exp
            | Function::Ln
            | Function::Abs
            | Function::Re
            | Function::Im => false,
        }
    }
}

fn number(x: &BigRational) -> String {
    let sign = if x.is_negative() { "-" } else { "" };
    let (a, b) = (x.numer().abs(), x.denom());
    match b.is_one() {
        true => format!("{sign}{a}"),
        false => format!(r"{sign}\frac{{{a}}}{{{b}}}"),
    }
}

fn called(function: Function, argument: &Term, exponent: Option<&str>) -> String {
    let inner = argument.latex();
    match function {
        Function::Sqrt => format!(r"\sqrt{{{inner}}}"),
        Function::Exp => format!("e^{{{inner}}}"),
        Function::Abs => format!(r"\left|{inner}\right|"),
        _ => {
            let exponent = exponent.map_or(String::new(), |e| format!("^{{{e}}}"));
            format!(r"{}{exponent}\left({inner}\right)", function.name())
        }
    }
}

fn power(base: &Term, exponent: &Term) -> String {
    let shown = exponent.latex();
    match base {
        Term::Call(function, argument)
            if function.has_powers()
                && matches!(exponent, Term::Number(x) if x.is_integer() && x.is_positive()) =>
        {
            called(*function, argument, Some(&shown))
        }
        Term::Letter(_) | Term::Pi | Term::E | Term::I => format!("{}^{{{shown}}}", base.latex()),
        Term::Number(x) if x.is_integer() && !x.is_negative() => {
            format!("{}^{{{shown}}}", base.latex())
        }
        Term::Call(Function::Abs, _) => format!("{}^{{{shown}}}", base.latex()),
        _ => format!(r"\left({}\right)^{{{shown}}}", base.latex()),
    }
}

fn sum(terms: &[Term]) -> String {
    let mut out = String::new();
    for term in terms {
        let (minus, shown) = match term {
            Term::Minus(t) => (true, bracketed_minus(t.as_factor())),
            Term::Number(x) if x.is_negative() => (true, number(&-x)),
            Term::Sum(_) => (false, format!("({})", term.latex())),
            Term::Product(factors) => match factors.first() {
                Some(Term::Number(x)) if x.is_negative() => {
                    let mut positive = factors.clone();
                    positive[0] = Term::Number(-x);
                    (true, product(&positive))
                }
                _ => (false, term.latex()),
            },
            _ => (false, term.latex()),
        };
        match (minus, out.is_empty()) {
            (true, true) => out += "-",
            (true, false) => out += " - ",
            (false, true) => {}
            (false, false) => out += " + ",
        }
        out += &shown;
    }
    out
}

/// In brackets where it begins with a sign.
fn bracketed_minus(shown: String) -> String {
    match shown.starts_with('-') {
        true => format!("({shown})"),
        false => shown,
    }
}

fn product(factors: &[Term]) -> String {
    // A factor 1 or -1 before others is not written.
    if let [Term::Number(x), rest @ ..] = factors
        && x.abs().is_one()
        && !rest.is_empty()
    {
        let sign = if x.is_negative() { "-" } else { "" };
        let rest = match rest {
            [only] => bracketed_minus(only.as_factor()),
            _ => bracketed_minus(product(rest)),
        };
        return format!("{sign}{rest}");
    }
    let mut out = String::new();
    let mut after_call = false;
    for (k, factor) in factors.iter().enumerate() {
        let shown = match factor {
            // At its beginning a product may carry its sign.
            Term::Number(_) if k == 0 => factor.latex(),
            _ => bracketed_minus(factor.as_factor()),
        };
        let signed = shown.starts_with("(-");
        let digit = shown.starts_with(|c: char| c.is_ascii_digit());
        let mixed = shown.starts_with(r"\frac") && out.ends_with(|c: char| c.is_ascii_digit());
        if k > 0 {
            out += if digit || after_call || mixed || signed {
                r" \cdot "
            } else {
                " "
            };
        }
        out += &shown;
        after_call = ends_with_call(factor);
    }
    out
}

/// Whether what follows could be read as part of an argument.
fn ends_with_call(t: &Term) -> bool {
    match t {
        Term::Call(Function::Sqrt | Function::Exp | Function::Abs, _) => false,
        Term::Call(..) => true,
        Term::Power(base, _) => ends_with_call(base),
        _ => false,
    }
}

pub fn integer(value: i64) -> BigRational {
    BigRational::from_integer(BigInt::from(value))
}
