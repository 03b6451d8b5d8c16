//! Subscripts, superscripts, the arguments of commands, and numbers.

use super::{Parse, Parser, starts_name};
use crate::diagnostic::{Diagnostic, DiagnosticKind};
use crate::expr::{Bracket, Expr, ExprKind, Font, Function, Letter, Name, Sign, Subscript};
use crate::latex::lexer::{Delimiter, Token};
use crate::latex::{vocabulary, writer};
use crate::span::Span;
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Signed, Zero};

/// The longest number that is read, in characters.
const LONGEST_NUMBER: usize = 1000;

impl Parser<'_> {
    /// Both readings of a subscript; the underscore is taken.
    pub(super) fn subscript(&mut self) -> Parse<Subscript> {
        if !self.at(&Token::Open(Delimiter::Brace)) {
            let index = self.argument(true)?;
            let indices = vec![index];
            let label = writer::index_label(&indices);
            return Ok(Subscript { indices, label });
        }
        let open = self.position;
        let close = self.partner[open];
        self.position += 1;
        let complaints = self.diagnostics.len();
        let readings = self.readings.len();
        let indices = self.inside(|parser| {
            let mut indices = vec![parser.expression()?];
            while parser.accept_symbol(',') {
                indices.push(parser.expression()?);
            }
            parser.close(close)?;
            Ok(indices)
        });
        let indices = match indices {
            Ok(indices) if self.diagnostics.len() == complaints => indices,
            Err(diagnostic) if matches!(diagnostic.kind, DiagnosticKind::TooDeep { .. }) => {
                return Err(diagnostic);
            }
            _ if close == open + 1 => {
                self.position = close;
                return Err(self.unexpected("an index"));
            }
            _ => Vec::new(),
        };
        // `A_{01}` is not `A_1`.
        let counted = self.lexemes[open..close]
            .iter()
            .all(|lexeme| match &lexeme.token {
                Token::Number(digits) => digits.len() < 2 || !digits.starts_with('0'),
                _ => true,
            });
        let indices = if counted { indices } else { Vec::new() };
        self.diagnostics.truncate(complaints);
        if indices.is_empty() {
            self.readings.truncate(readings);
        }
        self.position = close + 1;
        let label = if indices.is_empty() {
            writer::label(&self.lexemes[open + 1..close])
        } else {
            writer::index_label(&indices)
        };
        Ok(Subscript { indices, label })
    }

    /// What TeX takes as one argument: a brace or a single lexeme. A number of several digits
    /// without a brace is ambiguous as a script; elsewhere its first digit is the argument.
    pub(super) fn argument(&mut self, script: bool) -> Parse<Expr> {
        self.nested(|parser| parser.unguarded_argument(script))
    }

    fn unguarded_argument(&mut self, script: bool) -> Parse<Expr> {
        match self.peek() {
            Some(Token::Open(Delimiter::Brace)) => {
                let close = self.partner[self.position];
                self.position += 1;
                self.inside(|parser| {
                    let inner = parser.expression()?;
                    parser.close(close)?;
                    Ok(inner)
                })
            }
            Some(Token::Number(digits)) if digits.len() > 1 => {
                let digits = digits.clone();
                let span = self.here();
                if script || digits.contains('.') {
                    let readings = ["the whole number", "its first digit only, as TeX prints it"];
                    return Err(self.ambiguous(readings, span));
                }
                let (first, rest) = digits.split_at(1);
                let lexeme = &mut self.lexemes[self.position];
                lexeme.token = Token::Number(rest.to_owned());
                lexeme.span = Span::new(span.start + 1, span.end);
                let value = first.parse::<BigInt>().unwrap_or_default();
                let kind = ExprKind::Number(BigRational::from_integer(value));
                Ok(Expr::new(kind, Span::new(span.start, span.start + 1)))
            }
            Some(Token::Number(_)) => self.number(),
            Some(Token::Command(command)) => match command.as_str() {
                "top" | "intercal" => {
                    let mut name = Name::italic("T");
                    name.letter.font = Font::Roman;
                    let span = self.here();
                    self.position += 1;
                    Ok(Expr::new(ExprKind::Name(name), span))
                }
                "infty" | "frac" | "tfrac" | "dfrac" => self.factor(),
                command if starts_name(command) => self.letter(),
                _ => Err(self.unexpected("an argument")),
            },
            Some(Token::Letter(_)) => self.letter(),
            Some(Token::Text(word)) if vocabulary::is_constant(word) => self.factor(),
            Some(Token::Text(_)) => self.letter(),
            _ => Err(self.unexpected("an argument")),
        }
    }

    pub(super) fn number(&mut self) -> Parse<Expr> {
        let span = self.here();
        let Some(Token::Number(text)) = self.peek() else {
            return Err(self.unexpected("a number"));
        };
        let text = text.clone();
        self.position += 1;
        let bad = || DiagnosticKind::BadNumber {
            text: text.chars().take(40).collect(),
        };
        if text.len() > LONGEST_NUMBER {
            let kind = DiagnosticKind::LongNumber {
                digits: text.len(),
                limit: LONGEST_NUMBER,
            };
            return Err(self.error(kind, span));
        }
        let (whole, decimals) = text.split_once('.').unwrap_or((&text, ""));
        let Ok(digits) = format!("{whole}{decimals}").parse::<BigInt>() else {
            return Err(self.error(bad(), span));
        };
        let scale = num_traits::pow(BigInt::from(10), decimals.len());
        let kind = ExprKind::Number(BigRational::new(digits, scale));
        Ok(Expr::new(kind, span))
    }

    /// Takes the exponent after a finished operand, if one follows.
    pub(super) fn raised(&mut self, base: Expr) -> Parse<Expr> {
        self.raised_by(base, None)
    }

    /// The base with an exponent that stood before its arguments or stands after them.
    pub(super) fn raised_by(&mut self, base: Expr, before: Option<Expr>) -> Parse<Expr> {
        let start = self.here();
        let mut exponent = before;
        while self.accept_symbol('^') {
            let found = self.argument(true)?;
            if exponent.is_some() {
                return Err(self.double_superscript(start));
            }
            exponent = Some(found);
        }
        match exponent {
            Some(exponent) => self.raise(base, exponent),
            None => Ok(base),
        }
    }

    pub(super) fn double_superscript(&self, start: Span) -> Box<Diagnostic> {
        self.ambiguous(["(a^b)^c", "a^(b^c)"], self.since(start))
    }

    /// A power, a transpose, or the transpose of the inverse.
    pub(super) fn raise(&mut self, base: Expr, exponent: Expr) -> Parse<Expr> {
        let span = self.since(base.span).to(exponent.span);
        if is_mark(&base, &exponent) {
            let readings = ["a mark in brackets, or so many derivatives", "a power"];
            return Err(self.ambiguous(readings, exponent.span));
        }
        if let ExprKind::Number(number) = &exponent.kind
            && number.is_integer()
            && !number.is_one()
            && self.is_column(&base)
        {
            let readings = [
                "the scalar product with itself, written \\mathbf{u}^T\\mathbf{u}",
                "a power of a matrix",
            ];
            return Err(self.ambiguous(readings, span));
        }
        if let ExprKind::Name(letter) = &exponent.kind
            && self.transposes(&base, letter, exponent.span)?
        {
            return Ok(Expr::new(ExprKind::Transpose(Box::new(base)), span));
        }
        if let ExprKind::Sum(terms) = &exponent.kind
            && let [(Sign::Minus, only)] = terms.as_slice()
            && let ExprKind::Name(letter) = &only.kind
            && self.transposes(&base, letter, exponent.span)?
        {
            let one = Expr::new(ExprKind::Number(BigRational::one()), only.span);
            let minus_one = ExprKind::Sum(vec![(Sign::Minus, one)]);
            let inverse = ExprKind::Power {
                base: Box::new(base),
                exponent: Box::new(Expr::new(minus_one, exponent.span)),
            };
            let kind = ExprKind::Transpose(Box::new(Expr::new(inverse, span)));
            return Ok(Expr::new(kind, span));
        }
        let kind = ExprKind::Power {
            base: Box::new(base),
            exponent: Box::new(exponent),
        };
        Ok(Expr::new(kind, span))
    }

    /// Whether this superscript letter transposes this base.
    fn transposes(&self, base: &Expr, letter: &Name, span: Span) -> Parse<bool> {
        let plain = Name {
            letter: Letter {
                font: Font::Italic,
                ..letter.letter.clone()
            },
            ..letter.clone()
        };
        if plain != Name::italic("T") && plain != Name::italic("t") {
            return Ok(false);
        }
        if letter.letter.font == Font::Roman {
            return Ok(true);
        }
        let declared = self.signature.has_letter(&plain.letter.base);
        if is_matrix_like(base) {
            // Beside a time t or an energy T it is no riddle; by another letter a power may be meant.
            let number = plain == Name::italic("t") && !self.signature.is_variable("t");
            return match declared && number {
                true => Err(self.ambiguous(["a transpose", "a power"], span)),
                false => Ok(true),
            };
        }
        match &base.kind {
            ExprKind::Number(_) => Ok(false),
            ExprKind::Name(name) if name.letter.base == "e" => {
                Ok(!declared && self.signature.is_declared(name))
            }
            _ if !declared => Ok(true),
            ExprKind::Name(name) if name.letter.base.starts_with(|c: char| c.is_uppercase()) => {
                Err(self.ambiguous(["a transpose", "a power"], span))
            }
            _ => Ok(false),
        }
    }
}

/// Whether a whole superscript in brackets, as in `x^{(2)}`, may number what it stands at instead
/// of raising it. On a number or an exponential it raises, and a fraction numbers nothing.
pub(in crate::latex) fn is_mark(base: &Expr, exponent: &Expr) -> bool {
    let ExprKind::Group {
        bracket: Bracket::Round,
        inner,
    } = &exponent.kind
    else {
        return false;
    };
    let raises = match &base.without_brackets().kind {
        ExprKind::Number(_) => true,
        ExprKind::Name(name) => name.letter.base == "e",
        _ => false,
    };
    let transposes = |name: &Name| matches!(name.letter.base.as_str(), "T" | "t");
    !raises
        && match &inner.kind {
            ExprKind::Number(number) => number.is_integer(),
            ExprKind::Name(name) => !transposes(name),
            ExprKind::Sum(terms) => terms.iter().all(|(_, term)| match &term.kind {
                ExprKind::Number(number) => number.is_integer(),
                ExprKind::Name(name) => !transposes(name),
                _ => false,
            }),
            _ => false,
        }
}

/// Whether something bold or a matrix is printed in the expression.
pub(crate) fn is_matrix_like(expr: &Expr) -> bool {
    match &expr.kind {
        ExprKind::Matrix { .. } => true,
        ExprKind::Name(name) => name.letter.font == Font::Bold,
        ExprKind::Apply { function, .. } => function.letter.font == Font::Bold,
        ExprKind::Group { inner, .. } | ExprKind::Transpose(inner) => is_matrix_like(inner),
        ExprKind::Power { base, .. } => is_matrix_like(base),
        // det A^T means the same both ways.
        ExprKind::Call {
            function: Function::Determinant | Function::Trace,
            argument,
        } => is_matrix_like(argument),
        ExprKind::Sum(terms) => terms.iter().any(|(_, term)| is_matrix_like(term)),
        ExprKind::Product(factors) => factors.iter().any(is_matrix_like),
        _ => false,
    }
}

/// Whether the number is zero or positive and whole.
pub(super) fn small_order(expr: &Expr) -> Option<u8> {
    let ExprKind::Number(number) = &expr.kind else {
        return None;
    };
    if !number.is_integer() || number.is_zero() || number.is_negative() {
        return None;
    }
    u8::try_from(number.to_integer()).ok()
}
