//! What nobody writes: a factor 1, a term 0, `x - x`, `a\frac{b}{a}`, `2\cdot 3a`.
//!
//! An edit may turn a false equation into a true one by such a thing, and then it says less than the
//! print did. Here expressions are looked at as they are written, without values: what counts is
//! whether an edit leaves more of these than there were.

use super::form::{is_ordered, monomial_of};
use crate::expr::walk::{children, visit};
use crate::expr::{Expr, ExprKind, Function, Name, Sign};
use crate::latex;
use crate::model::names::literal_integer;
use num_bigint::BigInt;
use num_integer::Integer;
use num_rational::BigRational;
use num_traits::{One, Zero};
use std::collections::BTreeMap;

/// The same text for what is the same but for brackets and the order of terms and of scalar factors.
pub fn arranged(expr: &Expr) -> String {
    match &expr.kind {
        ExprKind::Group { inner, .. } | ExprKind::Underbrace { body: inner, .. } => arranged(inner),
        ExprKind::Sum(terms) => {
            let mut all: Vec<String> = terms
                .iter()
                .map(|(sign, term)| match sign {
                    Sign::Plus => format!("+{}", arranged(term)),
                    Sign::Minus => format!("-{}", arranged(term)),
                })
                .collect();
            all.sort_unstable();
            format!("<{}>", all.concat())
        }
        ExprKind::Product(factors) => {
            let mut all: Vec<String> = factors.iter().map(arranged).collect();
            if !is_ordered(expr) {
                all.sort_unstable();
            }
            format!("[{}]", all.join(" "))
        }
        _ => {
            let parts = children(expr);
            if parts.is_empty() {
                return latex::write_expr(expr);
            }
            let parts: Vec<String> = parts.into_iter().map(arranged).collect();
            format!("{}({})", head(expr), parts.join(";"))
        }
    }
}

/// What an expression with parts is, without them.
fn head(expr: &Expr) -> String {
    let mut empty = expr.clone();
    for part in crate::expr::walk::children_mut(&mut empty) {
        part.kind = ExprKind::Infinity;
    }
    latex::write_expr(&empty)
}

/// The expression without factors, divisors and exponents 1.
pub fn without_units(expr: &Expr) -> Expr {
    let one = |e: &Expr| number(e).is_some_and(One::is_one);
    let mut bare = expr.clone();
    for part in crate::expr::walk::children_mut(&mut bare) {
        *part = without_units(part);
    }
    let kept = match &mut bare.kind {
        ExprKind::Quotient {
            numerator,
            denominator,
            ..
        } if one(denominator) => Some((**numerator).clone()),
        ExprKind::Power { base, exponent } if one(exponent) => Some((**base).clone()),
        ExprKind::Product(factors) if factors.len() > 1 => {
            factors.retain(|f| !one(f));
            match factors.as_slice() {
                [] => Some(Expr::new(ExprKind::Number(BigRational::one()), expr.span)),
                [only] => Some(only.clone()),
                _ => None,
            }
        }
        _ => None,
    };
    kept.unwrap_or(bare)
}

/// What a side is about where it is one name but for a number, a sign, an exponent, a transposition.
pub fn subject(side: &Expr) -> Option<&Name> {
    match &side.kind {
        ExprKind::Name(name) | ExprKind::Apply { function: name, .. } => Some(name),
        ExprKind::Group { inner, .. } | ExprKind::Transpose(inner) => subject(inner),
        ExprKind::Power { base, .. } => subject(base),
        ExprKind::Sum(terms) => match terms.as_slice() {
            [(_, only)] => subject(only),
            _ => None,
        },
        ExprKind::Product(factors) => {
            let mut others = factors.iter().filter(|f| number(f).is_none());
            match (others.next(), others.next()) {
                (Some(only), None) => subject(only),
                _ => None,
            }
        }
        ExprKind::Quotient {
            numerator,
            denominator,
            ..
        } => match (number(numerator), number(denominator)) {
            (_, Some(_)) => subject(numerator),
            (Some(_), _) => subject(denominator),
            (None, None) => None,
        },
        _ => None,
    }
}

/// The names in an expression, as written, and how often each occurs.
pub fn names(expr: &Expr) -> BTreeMap<String, usize> {
    let mut found = BTreeMap::new();
    visit(expr, &mut |e| {
        if let Some(name) = super::name_of(e) {
            *found.entry(latex::canonical(name)).or_default() += 1;
        }
    });
    found
}

/// How many things stand in an expression that nobody writes.
pub fn oddities(expr: &Expr) -> usize {
    let mut count = 0;
    visit(expr, &mut |e| count += odd(e));
    count
}

fn odd(expr: &Expr) -> usize {
    let is = |e: &Expr, n: i64| number(e).is_some_and(|m| *m == integer(n));
    let trivial = |e: &Expr| is(e, 0) || is(e, 1);
    match &expr.kind {
        ExprKind::Sum(terms) => {
            let zeros = terms.iter().filter(|(_, t)| is(t, 0)).count();
            let alike = repeated(terms.iter().filter_map(|(_, t)| monomial_of(t)));
            zeros + alike + opposite(terms)
        }
        ExprKind::Product(factors) => {
            let numbers = factors.iter().filter(|f| number(f).is_some()).count();
            let trivial = factors.iter().filter(|f| trivial(f)).count();
            let scalars = factors.iter().filter(|f| !is_ordered(f));
            let bases = scalars.filter(|f| number(f).is_none()).map(base);
            trivial + numbers.saturating_sub(1) + repeated(bases) + cancelling(expr)
        }
        ExprKind::Quotient {
            numerator,
            denominator,
            ..
        } => {
            let zero = usize::from(is(numerator, 0));
            zero + usize::from(trivial(denominator)) + cancelling(expr)
        }
        ExprKind::Power { base, exponent } => {
            usize::from(trivial(base)) + usize::from(trivial(exponent))
        }
        // The root of a square is the square's base or its opposite.
        ExprKind::Call {
            function: Function::SquareRoot,
            argument,
        } => {
            let square = match &argument.without_brackets().kind {
                ExprKind::Power { exponent, .. } => {
                    literal_integer(exponent).is_some_and(|n| n % 2 == 0)
                }
                _ => false,
            };
            usize::from(square || trivial(argument))
        }
        _ => 0,
    }
}

fn integer(n: i64) -> BigRational {
    BigRational::from_integer(n.into())
}

/// The number that is printed here, in brackets or not.
fn number(expr: &Expr) -> Option<&BigRational> {
    match &expr.without_brackets().kind {
        ExprKind::Number(n) => Some(n),
        _ => None,
    }
}

/// A factor without its exponent.
fn base(factor: &Expr) -> String {
    match &factor.without_brackets().kind {
        ExprKind::Power { base, .. } => arranged(base),
        _ => arranged(factor),
    }
}

/// How many of some texts are there already.
fn repeated(texts: impl Iterator<Item = String>) -> usize {
    let mut seen = BTreeMap::new();
    let mut count = 0;
    for text in texts {
        let times: &mut usize = seen.entry(text).or_default();
        count += usize::from(*times > 0);
        *times += 1;
    }
    count
}

/// How many terms stand beside their opposites.
fn opposite(terms: &[(Sign, Expr)]) -> usize {
    let mut sums: BTreeMap<String, [usize; 2]> = BTreeMap::new();
    for (sign, term) in terms {
        sums.entry(arranged(term)).or_default()[usize::from(*sign == Sign::Minus)] += 1;
    }
    sums.values().map(|[plus, minus]| *plus.min(minus)).sum()
}

/// How many factors of a monomial could be cancelled.
fn cancelling(expr: &Expr) -> usize {
    let (mut above, mut below) = (Vec::new(), Vec::new());
    factors(expr, true, &mut above, &mut below);
    if below.is_empty() {
        return 0;
    }
    let product = |items: &[&Expr]| {
        let numbers = items.iter().filter_map(|e| number(e));
        let whole = numbers.filter(|n| n.is_integer() && !n.is_zero());
        whole.fold(BigInt::one(), |product, n| product * n.numer())
    };
    let common = product(&above).gcd(&product(&below));
    let bases = |items: &[&Expr]| -> Vec<String> {
        let scalars = items.iter().filter(|e| !is_ordered(e));
        scalars
            .filter(|e| number(e).is_none())
            .map(|e| base(e))
            .collect()
    };
    let (above, below) = (bases(&above), bases(&below));
    let both = above.iter().filter(|b| below.contains(b)).count();
    both + usize::from(!common.is_one())
}

fn factors<'e>(expr: &'e Expr, up: bool, above: &mut Vec<&'e Expr>, below: &mut Vec<&'e Expr>) {
    // Brackets around a monomial hide nothing.
    let inner = expr.without_brackets();
    match &inner.kind {
        ExprKind::Product(items) => {
            for item in items {
                factors(item, up, above, below);
            }
        }
        ExprKind::Quotient {
            numerator,
            denominator,
            ..
        } => {
            factors(numerator, up, above, below);
            factors(denominator, !up, above, below);
        }
        _ if up => above.push(expr),
        _ => below.push(expr),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::latex::{Signature, parse_display};

    fn read(text: &str) -> Expr {
        let mut signature = Signature::default();
        for letter in ["a", "b", "c", "x"] {
            signature.declare(&Name::italic(letter));
        }
        let mut display = parse_display(text, 0, &signature).expect("a formula");
        display.clauses.remove(0).chain.members[0].clone()
    }

    #[test]
    fn what_nobody_writes() {
        for text in [
            r"1\cdot a",
            r"0\cdot a",
            r"2\cdot 3a",
            r"a\frac{b}{a}",
            r"2\frac{3a}{2}",
            r"\frac{a}{1}",
            r"x - x",
            r"2a + a",
            r"x + 0",
            r"a^1",
            r"aba",
            r"\sqrt{a^2}",
            r"b + a(2 - 1)",
            r"\frac{(ab)}{a}",
            r"\frac{(\frac{ax}{2})}{a}",
        ] {
            assert_ne!(oddities(&read(text)), 0, "{text}");
        }
        for text in [
            r"a + 2ab + b^2",
            r"\frac{1}{2}a",
            r"\frac{2a}{3b}",
            r"\sqrt{a^2 + b^2}",
            r"(a + b) - a - b",
            r"a^{-1}b",
        ] {
            assert_eq!(oddities(&read(text)), 0, "{text}");
        }
    }

    #[test]
    fn order_and_brackets_do_not_matter() {
        assert_eq!(arranged(&read("ab + (c)")), arranged(&read("c + ba")));
        assert_ne!(
            arranged(&read(r"\frac{ab}{c}")),
            arranged(&read(r"a\frac{b}{c}"))
        );
        assert_eq!(subject(&read("-2x")), Some(&Name::italic("x")));
        assert_eq!(subject(&read("a + x")), None);
    }
}
