//! Fractions, derivatives, sums, integrals and underbraces.

use super::script::small_order;
use super::{Parse, Parser, product};
use crate::diagnostic::Diagnostic;
use crate::expr::{Chain, Expr, ExprKind, Font, Letter, Name, QuotientStyle};
use crate::latex::layout::is_relation;
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
        if let Some((variables, doubt_below)) = self.differentials_below(&denominator) {
            let order: u8 = variables.iter().map(|(order, _)| order).sum();
            if let Some((found, doubt_above)) = self.differential_above(&numerator)
                && found == order
            {
                let doubtful = doubt_above && doubt_below;
                if doubtful && !self.starts_factor() {
                    return Err(self.derivative_or_quotient(span));
                }
                let body = self.term()?;
                if begins_with_bracket(&body) {
                    return Err(self.derivative_of_bracket(self.since(start)));
                }
                let derivative = derivative(variables, body, self.since(start));
                if doubtful {
                    self.note_reading(&derivative);
                }
                return Ok(derivative);
            }
            if let ExprKind::Product(factors) = &numerator.kind
                && let Some((found, doubt_above)) = self.differential_above(&factors[0])
                && found == order
            {
                if doubt_above && doubt_below {
                    return Err(self.derivative_or_quotient(span));
                }
                let body = product(factors[1..].to_vec(), numerator.span);
                if let ExprKind::Name(name) = &body.kind
                    && self.signature.is_function(name)
                    && self.at_round_bracket()
                {
                    let readings = ["the derivative at this argument", "a product"];
                    return Err(self.ambiguous(readings, self.here()));
                }
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

    /// What to say where something follows the bracket behind a `d/dx`.
    pub(super) fn derivative_of_bracket(&self, span: Span) -> Box<Diagnostic> {
        let readings = [
            "the derivative of what the bracket holds",
            "the derivative of the whole product",
        ];
        self.ambiguous(readings, span)
    }

    /// What to say where a letter `d` of the document stands above and below.
    pub(super) fn derivative_or_quotient(&self, span: Span) -> Box<Diagnostic> {
        let readings = [
            "a derivative, written with \\mathrm{d}",
            "a quotient with the letter d, written with brackets",
        ];
        self.ambiguous(readings, span)
    }

    /// Whether the name is the `d` of a differential, upright, curly or italic, and if so, whether
    /// that is in doubt because the document has an italic letter `d`.
    fn is_differential(&self, name: &Name) -> Option<bool> {
        let italic = Name {
            letter: Letter {
                font: Font::Italic,
                ..name.letter.clone()
            },
            ..name.clone()
        };
        if italic == Name::italic("\\partial") {
            return Some(false);
        }
        match name.letter.font {
            _ if italic != Name::italic("d") => None,
            Font::Roman => Some(false),
            Font::Italic => Some(self.signature.has_letter("d")),
            Font::Bold | Font::Calligraphic | Font::Blackboard => None,
        }
    }

    /// The order of `d` or `d^n` above the bar, and whether it is in doubt.
    fn differential_above(&self, expr: &Expr) -> Option<(u8, bool)> {
        match &expr.kind {
            ExprKind::Name(name) => Some((1, self.is_differential(name)?)),
            ExprKind::Power { base, exponent } => match &base.kind {
                ExprKind::Name(name) => {
                    let doubtful = self.is_differential(name)?;
                    Some((small_order(exponent)?, doubtful))
                }
                _ => None,
            },
            _ => None,
        }
    }

    /// The orders and variables of `dt`, `dt^n` or `\partial x \partial y` below the bar, and whether
    /// they are in doubt.
    fn differentials_below(&self, expr: &Expr) -> Option<(Vec<(u8, Name)>, bool)> {
        let ExprKind::Product(factors) = &expr.kind else {
            return None;
        };
        let pairs = factors.chunks(2).map(|pair| match pair {
            [d, variable] => self.differential_of(d, variable),
            _ => None,
        });
        let found: Vec<_> = pairs.collect::<Option<_>>()?;
        let order: u32 = found.iter().map(|(order, ..)| u32::from(*order)).sum();
        let doubtful = found.iter().all(|(.., doubtful)| *doubtful);
        let variables = found.into_iter().map(|(order, name, _)| (order, name));
        let variables = variables.collect();
        u8::try_from(order).is_ok().then_some((variables, doubtful))
    }

    fn differential_of(&self, d: &Expr, variable: &Expr) -> Option<(u8, Name, bool)> {
        let ExprKind::Name(name) = &d.kind else {
            return None;
        };
        let doubtful = self.is_differential(name)?;
        match &variable.kind {
            ExprKind::Name(name) => Some((1, name.clone(), doubtful)),
            ExprKind::Power { base, exponent } => match &base.kind {
                ExprKind::Name(name) => Some((small_order(exponent)?, name.clone(), doubtful)),
                _ => None,
            },
            _ => None,
        }
    }

    /// `d/dt`, whose divisor goes on with what is differentiated, and whether it is in doubt.
    pub(super) fn inline_operator(
        &self,
        above: &[Expr],
        below: &[Expr],
    ) -> Option<(u8, Name, bool)> {
        let ([above], [d, variable, ..]) = (above, below) else {
            return None;
        };
        let (order, variable, doubt_below) = self.differential_of(d, variable)?;
        let (found, doubt_above) = self.differential_above(above)?;
        (found == order).then_some((order, variable, doubt_above && doubt_below))
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
        self.running.push(index.clone());
        let body = self.term();
        self.running.pop();
        let body = body?;
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

    /// Whether, with a letter `d` in the document, the term goes on with more `d` before a letter
    /// than integrals wait for one.
    fn later_differential(&self) -> bool {
        let mut found = 0;
        let mut position = self.position + 1;
        while let Some(lexeme) = self.lexemes.get(position) {
            match &lexeme.token {
                Token::Letter('d') => found += 1,
                Token::Open(_) | Token::Begin(_) => position = self.partner[position],
                Token::Close(_) | Token::End(_) | Token::Space(_) | Token::RowBreak => break,
                Token::Symbol('+' | '-' | ',' | ';' | '&') => break,
                token if is_relation(token) => break,
                _ => {}
            }
            position += 1;
        }
        found > self.open_integrals
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
        self.open_integrals += 1;
        let body = self.expression();
        let ended = self.at_differential();
        self.in_integral = outside;
        self.open_integrals -= 1;
        let body = body?;
        if !ended {
            return Err(self.unexpected("d and the variable of integration"));
        }
        if self.at(&Token::Letter('d'))
            && self.signature.has_letter("d")
            && self.later_differential()
        {
            let readings = ["the differential", "a factor of the integrand"];
            return Err(self.ambiguous(readings, self.here()));
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

/// Whether a product or quotient begins with a bracket, which behind a `d/dx` may hold all that is meant.
pub(in crate::latex) fn begins_with_bracket(expr: &Expr) -> bool {
    let is_bracket = |e: &Expr| matches!(e.kind, ExprKind::Group { .. } | ExprKind::Sum(_));
    match &expr.kind {
        ExprKind::Product(factors) => is_bracket(&factors[0]) || begins_with_bracket(&factors[0]),
        ExprKind::Quotient {
            numerator,
            style: QuotientStyle::Slash,
            ..
        } => is_bracket(numerator) || begins_with_bracket(numerator),
        _ => false,
    }
}
