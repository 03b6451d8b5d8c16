//! How far a slash reaches.
//!
//! A slash divides the whole juxtaposed product before it by the whole juxtaposed product after it:
//! `q/2de` is q/(2de), as papers print it. That is a convention, so the reading is named. Where it is
//! not what a reader takes, it is not taken: a printed space after a divisor that is closed in itself
//! ends it (`1/2\, mv^2` is half of mv^2, `1/(2m)\, p^2` likewise), and where nothing on the page
//! decides (`1/2 mv^2`, `a/b\, c`, `\sin\omega t/2` beside `\sin x/x`) both readings are given back.

use super::{Parse, Parser, product};
use crate::expr::{Bracket, Expr, ExprKind, Function, QuotientStyle};
use crate::latex::{Reading, writer};
use crate::span::Span;

impl Parser<'_> {
    /// Juxtaposed factors, perhaps divided by juxtaposed factors.
    pub(super) fn run(&mut self) -> Parse<Vec<Expr>> {
        let start = self.here();
        let numerator = self.juxtaposed()?;
        if !self.at_symbol('/') {
            return Ok(numerator);
        }
        let above = self.since(start);
        self.position += 1;
        let below = self.here();
        let (mut divisor, gaps) = self.spaced_factors()?;
        let below = self.since(below);
        if self.at_symbol('/') {
            return Err(self.ambiguous(["(a/b)/c", "a/(b/c)"], self.here()));
        }
        let span = self.since(start);
        if let Some((order, variable, doubtful)) = self.inline_operator(&numerator, &divisor) {
            let body = divisor.split_off(2);
            if body.is_empty() {
                return Err(match doubtful {
                    true => self.derivative_or_quotient(span),
                    false => self.unexpected("what is differentiated"),
                });
            }
            let body = Box::new(product(body, below));
            if super::begins_with_bracket(&body) {
                return Err(self.derivative_of_bracket(span));
            }
            let variable = Some(variable);
            let kind = ExprKind::Derivative {
                order,
                variable,
                body,
            };
            let derivative = Expr::new(kind, span);
            if doubtful {
                self.note_reading(&derivative);
            }
            return Ok(vec![derivative]);
        }
        if numerator.last().is_some_and(ends_in_bare_letters)
            && !matches!(divisor[0].kind, ExprKind::Call { .. })
        {
            let readings = ["a quotient in the argument", "a quotient of the function"];
            return Err(self.ambiguous(readings, span));
        }
        let quotient = |numerator: Vec<Expr>, divisor: Vec<Expr>| {
            let kind = ExprKind::Quotient {
                numerator: Box::new(product(numerator, above)),
                denominator: Box::new(product(divisor, below)),
                style: QuotientStyle::Slash,
            };
            Expr::new(kind, span)
        };
        if divisor.len() < 2 {
            return Ok(vec![quotient(numerator, divisor)]);
        }
        let whole = bracketed_divisor(&numerator, &divisor, above, below);
        let rest = divisor.split_off(1);
        let first = &divisor[0];
        let closed = ends_divisor(&product(numerator.clone(), above), first);
        let convention = !closed && gaps.is_empty();
        if convention {
            self.note_reading(&whole);
            divisor.extend(rest);
            return Ok(vec![quotient(numerator, divisor)]);
        }
        let short = quotient(numerator, divisor);
        let mut factors = vec![bracketed(short.clone())];
        factors.extend(rest.iter().cloned());
        let short_reading = product(factors, span);
        if !closed || gaps.first() != Some(&1) {
            let readings = [&short_reading, &whole].map(writer::write_expr);
            let readings = [readings[0].as_str(), readings[1].as_str()];
            return Err(self.ambiguous(readings, span));
        }
        self.note_reading(&short_reading);
        let mut factors = vec![short];
        factors.extend(rest);
        Ok(factors)
    }

    /// Remembers how something was read that could be read otherwise.
    pub(super) fn note_reading(&mut self, expr: &Expr) {
        let reading = Reading {
            span: expr.span,
            latex: writer::write_expr(expr),
        };
        // The same place may be read twice, as a subscript is.
        if !self.readings.contains(&reading) {
            self.readings.push(reading);
        }
    }
}

/// Whether a function stands at the right end whose argument is letters or a number without a bracket: a slash
/// behind it may still belong to the argument.
pub(in crate::latex) fn ends_in_bare_letters(expr: &Expr) -> bool {
    match &expr.kind {
        ExprKind::Call { function, argument } => {
            function.is_elementary()
                && matches!(
                    argument.kind,
                    ExprKind::Name(_)
                        | ExprKind::Number(_)
                        | ExprKind::Product(_)
                        | ExprKind::Power { .. }
                        | ExprKind::Apply { .. }
                )
        }
        ExprKind::Power { base, .. } => ends_in_bare_letters(base),
        _ => false,
    }
}

/// The quotient with brackets around the divisor.
fn bracketed_divisor(numerator: &[Expr], divisor: &[Expr], above: Span, below: Span) -> Expr {
    let kind = ExprKind::Quotient {
        numerator: Box::new(product(numerator.to_vec(), above)),
        denominator: Box::new(bracketed(product(divisor.to_vec(), below))),
        style: QuotientStyle::Slash,
    };
    Expr::new(kind, above.to(below))
}

pub(super) fn bracketed(inner: Expr) -> Expr {
    let span = inner.span;
    let kind = ExprKind::Group {
        bracket: Bracket::Round,
        inner: Box::new(inner),
    };
    Expr::new(kind, span)
}

/// Whether a divisor may end with this factor although others follow: it shows where it ends, and a
/// number does so below a number.
pub(in crate::latex) fn ends_divisor(numerator: &Expr, first: &Expr) -> bool {
    is_closed(first) && (is_number(numerator) || !is_number(first))
}

/// Whether a reader takes it for a number: digits, the circle's constant, a root or bracket of such.
fn is_number(expr: &Expr) -> bool {
    match &expr.kind {
        ExprKind::Number(_) => true,
        ExprKind::Name(name) => name.letter.base == "\\pi" && name.subscript.is_none(),
        ExprKind::Call {
            function: Function::SquareRoot,
            argument: inner,
        }
        | ExprKind::Group { inner, .. } => is_number(inner),
        ExprKind::Power { base, exponent } => is_number(base) && is_number(exponent),
        ExprKind::Sum(terms) => terms.iter().all(|(_, term)| is_number(term)),
        ExprKind::Product(factors) => factors.iter().all(is_number),
        ExprKind::Quotient {
            numerator,
            denominator,
            ..
        } => is_number(numerator) && is_number(denominator),
        _ => false,
    }
}

/// Whether a divisor shows where it ends: a number, a bracket, a root, bars, a fraction.
fn is_closed(expr: &Expr) -> bool {
    match &expr.kind {
        ExprKind::Number(_)
        | ExprKind::Group { .. }
        | ExprKind::Sum(_)
        | ExprKind::Tuple(_)
        | ExprKind::Matrix { .. } => true,
        ExprKind::Call { function, .. } => {
            matches!(function, Function::SquareRoot | Function::Absolute)
        }
        ExprKind::Quotient { style, .. } => *style == QuotientStyle::Bar,
        ExprKind::Power { base, .. } => is_closed(base),
        _ => false,
    }
}
