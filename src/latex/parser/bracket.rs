//! Brackets, braces, bars, tuples and row vectors.

use super::{Parse, Parser};
use crate::expr::{Bracket, Expr, ExprKind, Function, QuotientStyle};
use crate::latex::lexer::{Delimiter, Token};

impl Parser<'_> {
    /// `{...}`: grouping that nobody sees on paper, so it must not change what the reader sees.
    pub(super) fn braced(&mut self) -> Parse<Expr> {
        let start = self.here();
        let open = self.position;
        let close = self.partner[open];
        self.position += 1;
        if close == open + 1 {
            // An empty group is a common way to keep a space or a script apart.
            self.position += 1;
            return self.factor();
        }
        let inner = self.inside(|parser| {
            let inner = parser.expression()?;
            parser.close(close)?;
            Ok(inner)
        })?;
        let scripted = self.at_symbol('^') || self.at_symbol('_');
        let hidden = match &inner.kind {
            ExprKind::Sum(_)
            | ExprKind::Quotient {
                style: QuotientStyle::Slash,
                ..
            } => true,
            ExprKind::Product(_) | ExprKind::Power { .. } | ExprKind::Transpose(_) => scripted,
            _ => false,
        };
        let reaches = match end_of(&inner) {
            End::Open => scripted || self.starts_factor(),
            End::Bracketed => scripted,
            End::Closed => false,
        };
        if hidden || reaches {
            let readings = ["as if the brace were a bracket", "as if it were not there"];
            return Err(self.ambiguous(readings, self.since(start)));
        }
        match inner.kind {
            ExprKind::Name(name) => self.scripted(name, start),
            _ => self.raised(inner),
        }
    }

    /// Visible brackets, without an exponent: a group, a tuple or a row.
    pub(super) fn bracketed(&mut self) -> Parse<Expr> {
        let start = self.here();
        let open = self.position;
        let close = self.partner[open];
        let bracket = self.bracket_kind(open);
        self.position += 1;
        let mut row = false;
        let items = self.inside(|parser| {
            let mut items = vec![parser.expression()?];
            loop {
                if parser.at(&Token::Column) {
                    row = true;
                } else if !parser.at_symbol(',') {
                    break;
                }
                parser.position += 1;
                items.push(parser.expression()?);
            }
            if bracket == Bracket::Square && !row && parser.may_commute(&items) {
                let readings = [
                    "a commutator, written \\mathbf{A}\\mathbf{B} - \\mathbf{B}\\mathbf{A}",
                    "a row of two blocks, written as a matrix with &",
                ];
                return Err(parser.ambiguous(readings, parser.since(start)));
            }
            let is_cases =
                matches!(items.as_slice(), [only] if matches!(only.kind, ExprKind::Cases(_)));
            if parser.position == close && !is_cases {
                parser.bracket_closes(open, close)?;
            }
            parser.close(close)?;
            Ok(items)
        })?;
        let span = self.since(start);
        let kind = if items.len() > 1 {
            match bracket {
                Bracket::Round if !row => ExprKind::Tuple(items),
                Bracket::Square => ExprKind::Matrix {
                    rows: vec![items],
                    bracket,
                },
                _ => {
                    self.position = open;
                    return Err(self.unexpected("brackets around a single expression"));
                }
            }
        } else {
            let mut items = items;
            let Some(only) = items.pop() else {
                return Err(self.unexpected("an expression"));
            };
            return Ok(match (only.kind, bracket) {
                (kind, Bracket::None) | (kind @ ExprKind::Cases(_), Bracket::Curly) => {
                    Expr::new(kind, span)
                }
                (
                    ExprKind::Matrix {
                        rows,
                        bracket: Bracket::None,
                    },
                    bracket,
                ) => Expr::new(ExprKind::Matrix { rows, bracket }, span),
                (kind, bracket) => {
                    let inner = Box::new(Expr::new(kind, only.span));
                    Expr::new(ExprKind::Group { bracket, inner }, span)
                }
            });
        };
        Ok(Expr::new(kind, span))
    }

    /// The brackets opened at this position.
    fn bracket_kind(&self, open: usize) -> Bracket {
        match self.lexemes[open].token {
            Token::Open(Delimiter::Visible(bracket) | Delimiter::Stretched(bracket)) => bracket,
            _ => Bracket::None,
        }
    }

    /// Refuses `\left( ... \right.`: a bracket whose partner is invisible groups nothing.
    fn bracket_closes(&self, open: usize, close: usize) -> Parse<()> {
        let (a, b) = (&self.lexemes[open].token, &self.lexemes[close].token);
        match (a, b) {
            (Token::Open(a), Token::Close(b)) if a == b => Ok(()),
            _ => Err(self.unexpected("the partner of the opening bracket")),
        }
    }

    /// `|x|`; around a matrix, its determinant.
    pub(super) fn absolute(&mut self) -> Parse<Expr> {
        let start = self.here();
        let open = self.position;
        let paired = matches!(self.peek(), Some(Token::Open(_)));
        self.position += 1;
        let inner = self.inside(|parser| {
            parser.in_bars = !paired;
            let inner = parser.expression()?;
            if paired {
                let close = parser.partner[open];
                if parser.position == close {
                    parser.bracket_closes(open, close)?;
                }
                parser.close(close)?;
            } else {
                parser.expect_symbol('|')?;
            }
            Ok(inner)
        })?;
        let span = self.since(start);
        let (function, argument) = match inner.kind {
            ExprKind::Matrix {
                rows,
                bracket: Bracket::None,
            } => {
                let bracket = Bracket::Bar;
                let matrix = Expr::new(ExprKind::Matrix { rows, bracket }, inner.span);
                (Function::Determinant, matrix)
            }
            kind => (Function::Absolute, Expr::new(kind, inner.span)),
        };
        let kind = ExprKind::Call {
            function,
            argument: Box::new(argument),
        };
        self.raised(Expr::new(kind, span))
    }
}

/// Whether the end of an expression is seen where no brace is.
enum End {
    /// What follows would belong to it.
    Open,
    /// It ends with a bracket: only a script could belong to that bracket.
    Bracketed,
    /// It is seen.
    Closed,
}

fn end_of(expr: &Expr) -> End {
    match &expr.kind {
        ExprKind::Call {
            function: Function::Absolute | Function::SquareRoot,
            ..
        } => End::Closed,
        ExprKind::Call { argument, .. } => match &argument.kind {
            ExprKind::Group { .. } | ExprKind::Matrix { .. } => End::Bracketed,
            _ => End::Open,
        },
        ExprKind::BigSum { .. } | ExprKind::Derivative { .. } => End::Open,
        // The letter of the differential takes the script.
        ExprKind::Integral { .. } => End::Bracketed,
        ExprKind::Product(factors) => factors.last().map_or(End::Closed, end_of),
        ExprKind::Number(_)
        | ExprKind::Name(_)
        | ExprKind::Named { .. }
        | ExprKind::Apply { .. }
        | ExprKind::Sum(_)
        | ExprKind::Quotient { .. }
        | ExprKind::Power { .. }
        | ExprKind::Transpose(_)
        | ExprKind::Matrix { .. }
        | ExprKind::Group { .. }
        | ExprKind::Tuple(_)
        | ExprKind::Cases(_)
        | ExprKind::Expectation(_)
        | ExprKind::Underbrace { .. }
        | ExprKind::Infinity
        | ExprKind::Constant => End::Closed,
    }
}
