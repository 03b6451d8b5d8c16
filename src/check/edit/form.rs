//! When two expressions are the same but for the order and the place of their factors and terms.
//!
//! The form of an expression collects like factors of each monomial and like monomials of each sum,
//! and multiplies no bracket out: `ab/c` and `b(a/c)` have one form, `(a + b)^2` and
//! `a^2 + 2ab + b^2` two. What is no sum or product, such as a cosine, has the forms of its parts.

use crate::expr::walk::{children, children_mut, visit};
use crate::expr::{Display, Expr, ExprKind, Font, Function, Sign};
use crate::latex;
use crate::model::links::Link;
use crate::model::names::literal_integer;
use num_rational::BigRational;
use num_traits::{One, Zero, pow};
use std::collections::BTreeMap;

/// Whether two expressions are the same monomials.
pub fn same_form(one: &Expr, other: &Expr) -> bool {
    text(&form(one)) == text(&form(other))
}

/// Whether a link reads alike in two displays: both of its sides have the same forms.
pub fn same_reading(one: &Display, other: &Display, link: &Link) -> bool {
    [link.left, link.right].iter().all(|place| {
        let sides = (place.find(one), place.find(other));
        matches!(sides, (Some(one), Some(other)) if same_form(one, other))
    })
}

/// How many subexpressions are sums that are zero by their form alone, such as `x - x`.
pub fn zeros(expr: &Expr) -> usize {
    let mut count = 0;
    visit(expr, &mut |e| {
        let sum = matches!(e.kind, ExprKind::Sum(_));
        count += usize::from(sum && form(e).is_empty());
    });
    count
}

/// Whether an expression is zero by its form alone.
pub fn vanishes(expr: &Expr) -> bool {
    form(expr).is_empty()
}

/// The monomial that an expression is, without its number; none where it is a sum of several or zero.
pub(super) fn monomial_of(expr: &Expr) -> Option<String> {
    let mut monomials = form(expr).into_keys();
    let only = monomials.next()?;
    monomials.next().is_none().then_some(only)
}

/// Monomials by their text, with their coefficients; none is zero.
type Form = BTreeMap<String, BigRational>;

fn text(form: &Form) -> String {
    let terms: Vec<String> = form.iter().map(|(m, c)| format!("{c}*{m}")).collect();
    terms.join("+")
}

/// A coefficient, scalar factors with exponents, and factors whose order matters.
struct Monomial {
    coefficient: BigRational,
    factors: BTreeMap<String, i64>,
    ordered: Vec<(String, i64)>,
}

impl Monomial {
    fn one() -> Self {
        Monomial {
            coefficient: BigRational::one(),
            factors: BTreeMap::new(),
            ordered: Vec::new(),
        }
    }

    /// Multiplied by a power of an expression.
    fn take(&mut self, expr: &Expr, exponent: i64) {
        match &expr.kind {
            ExprKind::Group { inner, .. } | ExprKind::Underbrace { body: inner, .. } => {
                self.take(inner, exponent);
            }
            ExprKind::Number(n) if !n.is_zero() => {
                let size = usize::try_from(exponent.unsigned_abs())
                    .unwrap_or(1)
                    .min(64);
                let power = pow(n.clone(), size);
                self.coefficient *= if exponent < 0 { power.recip() } else { power };
            }
            // The root of one says nothing.
            ExprKind::Call {
                function: Function::SquareRoot,
                argument,
            } if text(&form(argument)) == "1*1" => {}
            ExprKind::Product(items) if exponent == 1 || !items.iter().any(is_ordered) => {
                for item in items {
                    self.take(item, exponent);
                }
            }
            ExprKind::Quotient {
                numerator,
                denominator,
                ..
            } => {
                self.take(numerator, exponent);
                self.take(denominator, -exponent);
            }
            ExprKind::Power {
                base,
                exponent: above,
            } if literal_integer(above).is_some_and(|n| n.abs() <= 64) => {
                let n = literal_integer(above).unwrap_or(1);
                self.take(base, exponent * n);
            }
            _ => {
                let mut whole;
                if let ExprKind::Sum(_) = &expr.kind {
                    let inner = form(expr);
                    whole = text(&inner);
                    if inner.is_empty() {
                        self.coefficient = BigRational::zero();
                    }
                    // A sum that comes to one monomial, such as a lone minus, is that monomial.
                    if let (1, Some((monomial, coefficient))) = (inner.len(), inner.iter().next()) {
                        let size = usize::try_from(exponent.unsigned_abs())
                            .unwrap_or(1)
                            .min(64);
                        let power = pow(coefficient.clone(), size);
                        self.coefficient *= if exponent < 0 { power.recip() } else { power };
                        whole.clone_from(monomial);
                    }
                } else {
                    whole = shell(expr);
                }
                if is_ordered(expr) {
                    match self.ordered.last_mut() {
                        Some((last, times)) if *last == whole => *times += exponent,
                        _ => self.ordered.push((whole, exponent)),
                    }
                } else {
                    *self.factors.entry(whole).or_default() += exponent;
                }
            }
        }
    }
}

/// Whether something bold occurs: such factors keep their order.
pub fn is_ordered(expr: &Expr) -> bool {
    let mut found = false;
    visit(expr, &mut |e| {
        found |= match &e.kind {
            ExprKind::Name(name) | ExprKind::Apply { function: name, .. } => {
                name.letter.font == Font::Bold
            }
            ExprKind::Matrix { .. } => true,
            _ => false,
        };
    });
    found
}

/// What is neither sum nor product: how it is put together, with the forms of its parts.
fn shell(expr: &Expr) -> String {
    let parts = children(expr);
    if parts.is_empty() {
        return latex::write_expr(expr);
    }
    let forms: Vec<String> = parts.into_iter().map(|part| text(&form(part))).collect();
    let mut empty = expr.clone();
    for part in children_mut(&mut empty) {
        part.kind = ExprKind::Infinity;
    }
    format!("{}{{{}}}", latex::write_expr(&empty), forms.join(";"))
}

fn form(expr: &Expr) -> Form {
    let mut found = Form::new();
    match &expr.kind {
        ExprKind::Group { inner, .. } | ExprKind::Underbrace { body: inner, .. } => {
            return form(inner);
        }
        ExprKind::Number(n) => {
            found.insert("1".into(), n.clone());
        }
        ExprKind::Sum(terms) => {
            for (sign, term) in terms {
                for (monomial, coefficient) in form(term) {
                    let sum = found.entry(monomial).or_insert_with(BigRational::zero);
                    match sign {
                        Sign::Plus => *sum += coefficient,
                        Sign::Minus => *sum -= coefficient,
                    }
                }
            }
        }
        ExprKind::Product(_)
        | ExprKind::Quotient { .. }
        | ExprKind::Power { .. }
        | ExprKind::Call { .. } => {
            let mut monomial = Monomial::one();
            monomial.take(expr, 1);
            let scalar = monomial.factors.iter().filter(|(_, n)| **n != 0);
            let ordered = monomial.ordered.iter().filter(|(_, n)| *n != 0);
            let mut factors: Vec<String> = scalar.map(|(f, n)| format!("({f})^{n}")).collect();
            factors.extend(ordered.map(|(f, n)| format!("[{f}]^{n}")));
            let text = if factors.is_empty() {
                "1".to_string()
            } else {
                factors.concat()
            };
            found.insert(text, monomial.coefficient);
        }
        ExprKind::Name(_) => {
            let name = latex::write_expr(expr);
            let text = if is_ordered(expr) {
                format!("[{name}]^1")
            } else {
                format!("({name})^1")
            };
            found.insert(text, BigRational::one());
        }
        _ => {
            let text = if is_ordered(expr) {
                format!("[{}]^1", shell(expr))
            } else {
                format!("({})^1", shell(expr))
            };
            found.insert(text, BigRational::one());
        }
    }
    found.retain(|_, coefficient| !coefficient.is_zero());
    found
}
