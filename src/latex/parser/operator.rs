//! Fractions, derivatives, sums, integrals and underbraces.

use super::script::small_order;
use super::{Parse, Parser, product};
use crate::expr::{Chain, Expr, ExprKind, Font, Letter, Name, QuotientStyle};
use crate::latex::lexer::{Delimiter, Token};
use crate::latex::vocabulary;
use crate::span::Span;

impl Parser<'_> {
    /// `\frac{a}{b}`; with a `d` above and below, a derivative.
    pub(super) fn fraction(&mut self) -> Parse<Expr> {
        let start = self.here();
        self.position += 1;
        let numerator = self.argument(false)?;
        let denominator = self.argument(false)?;
        let span = self.since(start);
        if let Some(variables) = self.differentials_below(&denominator) {
            let order = variables.iter().map(|(order, _)| order).sum();
            if self.differential_above(&numerator) == Some(order) {
                let body = self.term()?;
                return Ok(derivative(variables, body, self.since(start)));
            }
            if let ExprKind::Product(factors) = &numerator.kind
                && self.differential_above(&factors[0]) == Some(order)
            {
                let body = product(factors[1..].to_vec(), numerator.span);
                return Ok(derivative(variables, body, span));
            }
        }
        if self.at_symbol('^') {
            let readings = ["a power of the fraction", "a power of its numerator"];
            return Err(self.ambiguous(readings, self.here()));
        }
        let kind = ExprKind::Quotient {
            numerator: Box::new(numerator),
            denominator: Box::new(denominator),
            style: QuotientStyle::Bar,
        };
        Ok(Expr::new(kind, span))
    }

    /// Whether the name is the `d` of a differential: upright or curly, or italic in a document
    /// that has no letter `d`.
    fn is_differential(&self, name: &Name) -> bool {
        let italic = Name {
            letter: Letter {
                font: Font::Italic,
                ..name.letter.clone()
            },
            ..name.clone()
        };
        if italic == Name::italic("\\partial") {
            return true;
        }
        italic == Name::italic("d")
            && match name.letter.font {
                Font::Roman => true,
                Font::Italic => !self.signature.knows_letter("d"),
                _ => false,
            }
    }

    /// The order of `d` or `d^n` above the bar.
    fn differential_above(&self, expr: &Expr) -> Option<u8> {
        match &expr.kind {
            ExprKind::Name(name) if self.is_differential(name) => Some(1),
            ExprKind::Power { base, exponent } => match &base.kind {
                ExprKind::Name(name) if self.is_differential(name) => small_order(exponent),
                _ => None,
            },
            _ => None,
        }
    }

    /// The orders and variables of `dt`, `dt^n` or `\partial x \partial y` below the bar.
    fn differentials_below(&self, expr: &Expr) -> Option<Vec<(u8, Name)>> {
        let ExprKind::Product(factors) = &expr.kind else {
            return None;
        };
        let pairs = factors.chunks(2).map(|pair| match pair {
            [d, variable] => self.differential_of(d, variable),
            _ => None,
        });
        let variables: Vec<_> = pairs.collect::<Option<_>>()?;
        let order: u32 = variables.iter().map(|(order, _)| u32::from(*order)).sum();
        u8::try_from(order).is_ok().then_some(variables)
    }

    fn differential_of(&self, d: &Expr, variable: &Expr) -> Option<(u8, Name)> {
        match &d.kind {
            ExprKind::Name(name) if self.is_differential(name) => {}
            _ => return None,
        }
        match &variable.kind {
            ExprKind::Name(name) => Some((1, name.clone())),
            ExprKind::Power { base, exponent } => match &base.kind {
                ExprKind::Name(name) => Some((small_order(exponent)?, name.clone())),
                _ => None,
            },
            _ => None,
        }
    }

    /// `d/dt`, whose divisor goes on with what is differentiated.
    pub(super) fn inline_operator(&self, above: &[Expr], below: &[Expr]) -> Option<(u8, Name)> {
        let ([above], [d, variable, ..]) = (above, below) else {
            return None;
        };
        let (order, variable) = self.differential_of(d, variable)?;
        (self.differential_above(above)? == order).then_some((order, variable))
    }

    /// `\sum_{k=0}^{3}` and the product that follows.
    pub(super) fn big_sum(&mut self) -> Parse<Expr> {
        let start = self.here();
        self.position += 1;
        let (mut first, mut last) = (None, None);
        loop {
            if self.at_symbol('_') && first.is_none() {
                self.position += 1;
                first = Some(self.first_value()?);
            } else if self.at_symbol('^') && last.is_none() {
                self.position += 1;
                last = Some(self.argument(true)?);
            } else {
                break;
            }
        }
        let Some((index, from)) = first else {
            return Err(self.unexpected("_{index = first value}"));
        };
        let Some(to) = last else {
            return Err(self.unexpected("^{last value}"));
        };
        let body = self.term()?;
        let kind = ExprKind::BigSum {
            index,
            from: Box::new(from),
            to: Box::new(to),
            body: Box::new(body),
        };
        Ok(Expr::new(kind, self.since(start)))
    }

    /// `{k=0}` below a sum sign.
    fn first_value(&mut self) -> Parse<(Name, Expr)> {
        if !self.at(&Token::Open(Delimiter::Brace)) {
            return Err(self.unexpected("{index = first value}"));
        }
        let close = self.partner[self.position];
        self.position += 1;
        self.inside(|parser| {
            let index = parser.lone_name()?;
            parser.expect_symbol('=')?;
            let from = parser.expression()?;
            parser.close(close)?;
            Ok((index, from))
        })
    }

    /// Whether `dx` ends the integral that is being read.
    pub(super) fn at_differential(&self) -> bool {
        let letter = match self.peek() {
            Some(Token::Letter('d')) => true,
            Some(Token::Text(word)) => word == "d",
            _ => false,
        };
        self.in_integral
            && letter
            && match self.peek_at(1) {
                Some(Token::Letter(_)) => true,
                Some(Token::Text(word)) => !vocabulary::is_conjunction(word),
                Some(Token::Command(command)) => super::starts_name(command),
                _ => false,
            }
    }

    /// `\int_a^b body \, dx`
    pub(super) fn integral(&mut self) -> Parse<Expr> {
        let start = self.here();
        self.position += 1;
        let (mut lower, mut upper) = (None, None);
        loop {
            if self.at_symbol('_') && lower.is_none() {
                self.position += 1;
                lower = Some(self.argument(true)?);
            } else if self.at_symbol('^') && upper.is_none() {
                self.position += 1;
                upper = Some(self.argument(true)?);
            } else {
                break;
            }
        }
        let limits = match (lower, upper) {
            (Some(lower), Some(upper)) => Some((Box::new(lower), Box::new(upper))),
            (None, None) => None,
            _ => return Err(self.unexpected("both limits of the integral or none")),
        };
        let outside = std::mem::replace(&mut self.in_integral, true);
        let body = self.expression();
        let ended = self.at_differential();
        self.in_integral = outside;
        let body = body?;
        if !ended {
            return Err(self.unexpected("d and the variable of integration"));
        }
        self.position += 1;
        let variable = self.lone_name()?;
        let kind = ExprKind::Integral {
            limits,
            body: Box::new(body),
            variable,
        };
        Ok(Expr::new(kind, self.since(start)))
    }

    /// `\underbrace{body}_{label}`; without a label the brace says nothing.
    pub(super) fn underbrace(&mut self) -> Parse<Expr> {
        let start = self.here();
        self.position += 1;
        let body = self.argument(false)?;
        if !self.accept_symbol('_') {
            return match body.kind {
                ExprKind::Sum(_) => {
                    let inner = Box::new(body);
                    let bracket = crate::expr::Bracket::None;
                    let kind = ExprKind::Group { bracket, inner };
                    Ok(Expr::new(kind, self.since(start)))
                }
                _ => Ok(body),
            };
        }
        let label = self.underbrace_label()?;
        let kind = ExprKind::Underbrace {
            body: Box::new(body),
            label: Box::new(label),
        };
        let brace = Expr::new(kind, self.since(start));
        if self.at_symbol('^') {
            return Err(self.unexpected("brackets around what is raised"));
        }
        Ok(brace)
    }

    fn underbrace_label(&mut self) -> Parse<Chain> {
        if self.at(&Token::Open(Delimiter::Brace)) {
            let close = self.partner[self.position];
            self.position += 1;
            return self.inside(|parser| {
                let label = parser.chain()?;
                parser.close(close)?;
                Ok(label)
            });
        }
        let label = self.argument(true)?;
        Ok(Chain {
            span: label.span,
            members: vec![label],
            relations: Vec::new(),
        })
    }
}

/// The derivative by several variables, the last one first.
fn derivative(variables: Vec<(u8, Name)>, body: Expr, span: Span) -> Expr {
    variables
        .into_iter()
        .rev()
        .fold(body, |body, (order, variable)| {
            let kind = ExprKind::Derivative {
                order,
                variable: Some(variable),
                body: Box::new(body),
            };
            Expr::new(kind, span)
        })
}
