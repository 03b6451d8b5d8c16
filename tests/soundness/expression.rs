//! The printed tree, as the program has read it, evaluated in floating point: is it what was written,
//! and is a proposed correction true?

use super::complex::Complex;
use super::generator::Claim;
use super::random::Random;
use super::term::{Function, Letters};
use super::truth;
use num_traits::ToPrimitive;
use rederive::expr::{self, Bracket, Display, Expr, ExprKind, Sign};
use rederive::latex::canonical;

/// The value of a tree of numbers, letters, arithmetic and elementary functions; none for others.
fn value(e: &Expr, letters: Letters<'_, Complex>) -> Option<Complex> {
    let found = match &e.kind {
        ExprKind::Number(x) => Complex::real(x.to_f64()?),
        ExprKind::Name(name) => match canonical(name).as_str() {
            r"\pi" => Complex::real(std::f64::consts::PI),
            "e" => Complex::real(std::f64::consts::E),
            "j" => Complex::I,
            name => letters(name)?,
        },
        ExprKind::Sum(terms) => {
            let mut total = Complex::real(0.0);
            for (sign, term) in terms {
                let term = value(term, letters)?;
                total = match sign {
                    Sign::Plus => total + term,
                    Sign::Minus => total - term,
                };
            }
            total
        }
        ExprKind::Product(factors) => {
            let mut total = Complex::real(1.0);
            for factor in factors {
                total = total * value(factor, letters)?;
            }
            total
        }
        ExprKind::Quotient {
            numerator,
            denominator,
            ..
        } => {
            let below = value(denominator, letters)?;
            if below.modulus() < 1e-6 {
                return None;
            }
            value(numerator, letters)? / below
        }
        ExprKind::Power { base, exponent } => {
            value(base, letters)?.power(value(exponent, letters)?)?
        }
        ExprKind::Group { bracket, inner } if *bracket != Bracket::Bar => value(inner, letters)?,
        ExprKind::Call { function, argument } => {
            elementary(*function)?.value(value(argument, letters)?)?
        }
        _ => return None,
    };
    found.is_usable().then_some(found)
}

fn elementary(function: expr::Function) -> Option<Function> {
    use expr::Function as F;
    Some(match function {
        F::Cosine => Function::Cos,
        F::Sine => Function::Sin,
        F::Tangent => Function::Tan,
        F::Cotangent => Function::Cot,
        F::HyperbolicCosine => Function::Cosh,
        F::HyperbolicSine => Function::Sinh,
        F::HyperbolicTangent => Function::Tanh,
        F::Exponential => Function::Exp,
        F::Logarithm => Function::Ln,
        F::SquareRoot => Function::Sqrt,
        F::Absolute => Function::Abs,
        F::RealPart => Function::Re,
        F::ImaginaryPart => Function::Im,
        _ => return None,
    })
}

fn points(claim: &Claim) -> Vec<Vec<(&'static str, Complex)>> {
    let Some((left, right)) = &claim.sides else {
        return Vec::new();
    };
    let mut random = Random::new(2, &claim.label);
    let mut letters: Vec<&'static str> = truth::LETTERS.iter().map(|(l, _)| *l).collect();
    letters.retain(|l| {
        left.letters().contains(l)
            || right.letters().contains(l)
            // A correction may bring in another letter of the header.
            || !matches!(*l, "u" | "w" | "n" | "m")
    });
    (0..30)
        .map(|_| {
            letters
                .iter()
                .map(|l| (*l, truth::draw(l, &mut random)))
                .collect()
        })
        .collect()
}

fn sides(display: &Display) -> Option<(&Expr, &Expr)> {
    let [clause] = display.clauses.as_slice() else {
        return None;
    };
    let [left, right] = clause.chain.members.as_slice() else {
        return None;
    };
    (clause.chain.relations == [expr::Relation::Equal]).then_some((left, right))
}

/// Whether an equation is false at an admissible point, as far as it can be evaluated.
pub fn display_is_false(display: &Display, claim: &Claim) -> bool {
    let Some((left, right)) = sides(display) else {
        return false;
    };
    points(claim).iter().any(|point| {
        let of = |name: &str| point.iter().find(|(l, _)| *l == name).map(|(_, x)| *x);
        match (value(left, &of), value(right, &of)) {
            (Some(a), Some(b)) => (a - b).modulus() > 1e-4 * (1e-3 + a.modulus() + b.modulus()),
            _ => false,
        }
    })
}

/// Whether what was read has other values than what was written.
pub fn is_misread(display: &Display, claim: &Claim) -> bool {
    let (Some((left, right)), Some(written)) = (sides(display), &claim.sides) else {
        return false;
    };
    points(claim).iter().any(|point| {
        let of = |name: &str| point.iter().find(|(l, _)| *l == name).map(|(_, x)| *x);
        let differs =
            |read: &Expr, written: &super::term::Term| match (value(read, &of), written.value(&of))
            {
                (Some(a), Some(b)) => (a - b).modulus() > 1e-6 * (1e-3 + a.modulus() + b.modulus()),
                _ => false,
            };
        differs(left, &written.0) || differs(right, &written.1)
    })
}
