//! The functions of mathematical notation and how far their argument reaches.

use super::{Parse, Parser, product};
use crate::diagnostic::Diagnostic;
use crate::expr::{Bracket, Expr, ExprKind, Function, Sign};
use crate::latex::lexer::{Delimiter, Token};
use crate::latex::vocabulary::{self, Environment};
use crate::span::Span;
use num_traits::{One, Signed};

impl Parser<'_> {
    /// `\det\mathbf{H}`, `\cos \beta\xi`, `\sin^2 x`, `\sqrt{x}`; the name of the function is next.
    pub(super) fn call(&mut self, function: Function) -> Parse<Expr> {
        let start = self.here();
        if let Some(Token::Command(name) | Token::Text(name)) = self.peek()
            && name == "log"
        {
            let readings = [
                "the natural logarithm, written \\ln",
                "the decimal logarithm, written \\frac{\\ln x}{\\ln 10}",
            ];
            return Err(self.ambiguous(readings, start));
        }
        self.position += 1;
        let mut exponent = None;
        if self.at_symbol('^') {
            self.position += 1;
            let found = self.argument(true)?;
            if is_minus_one(&found) {
                return Err(self.inverse(found.span));
            }
            exponent = Some(found);
        }
        // A brace around a bracket is not seen.
        let brace = (function != Function::SquareRoot && self.at_braced_bracket())
            .then(|| self.partner[self.position]);
        self.position += usize::from(brace.is_some());
        let bracketed = function == Function::SquareRoot || self.at_bracket();
        let argument = match function {
            Function::SquareRoot => self.argument(false)?,
            _ if self.at_bracket() => self.bracket_argument()?,
            Function::Determinant
            | Function::Trace
            | Function::RealPart
            | Function::ImaginaryPart => self.factor()?,
            _ => self.letters()?,
        };
        if let Some(close) = brace {
            self.close(close)?;
        }
        let kind = ExprKind::Call {
            function,
            argument: Box::new(argument),
        };
        let call = Expr::new(kind, self.since(start));
        if !bracketed && self.argument_may_continue() {
            return Err(self.reach());
        }
        if bracketed && function != Function::SquareRoot && self.at_tight_bracket() {
            let readings = [
                "the function of the first bracket",
                "the function of the product",
            ];
            return Err(self.ambiguous(readings, self.since(start).to(self.here())));
        }
        if self.at_symbol('^') {
            // The determinant of a power is the power of the determinant; a cosine's is not.
            if !matches!(function, Function::Determinant | Function::SquareRoot) {
                let readings = ["a power of the function", "a power of its argument"];
                return Err(self.ambiguous(readings, self.here()));
            }
            if exponent.is_none() {
                return self.raised(call);
            }
        }
        match exponent {
            Some(exponent) => self.raise(call, exponent),
            None => Ok(call),
        }
    }

    fn at_bracket(&self) -> bool {
        matches!(
            self.peek(),
            Some(
                Token::Open(
                    Delimiter::Visible(Bracket::Round | Bracket::Square | Bracket::Curly)
                        | Delimiter::Stretched(Bracket::Round | Bracket::Square | Bracket::Curly)
                ) | Token::Begin(Environment::Matrix(_))
            )
        )
    }

    /// Whether a brace follows that holds one bracket and nothing else.
    fn at_braced_bracket(&self) -> bool {
        let open = self.position;
        self.at(&Token::Open(Delimiter::Brace))
            && matches!(
                self.peek_at(1),
                Some(Token::Open(
                    Delimiter::Visible(Bracket::Round | Bracket::Square | Bracket::Curly)
                        | Delimiter::Stretched(Bracket::Round | Bracket::Square | Bracket::Curly)
                ))
            )
            && self.partner[open + 1] + 1 == self.partner[open]
    }

    /// Whether a bracket follows with no printed space before it.
    fn at_tight_bracket(&self) -> bool {
        let opens = matches!(self.peek(), Some(Token::Open(_))) && self.at_bracket();
        opens && !self.lexemes[self.position].gap
    }

    /// What to say of the exponent -1 of a function.
    pub(super) fn inverse(&self, span: Span) -> Box<Diagnostic> {
        self.ambiguous(["the inverse function", "one over the function"], span)
    }

    fn bracket_argument(&mut self) -> Parse<Expr> {
        if matches!(self.peek(), Some(Token::Begin(_))) {
            return self.environment();
        }
        self.nested(Self::bracketed)
    }

    /// The letters and numbers that follow, as in `\cos 2\omega t`; or one fraction or bars.
    fn letters(&mut self) -> Parse<Expr> {
        let start = self.here();
        let mut factors = Vec::new();
        let lettered = self.at_letters();
        self.push_factor(&mut factors)?;
        if lettered {
            while self.at_letters() {
                // A printed space may end the argument, and so may an exponential: `\sin x\, y`, `\sin x e^{-t}`.
                let exponential =
                    self.at(&Token::Letter('e')) && self.peek_at(1) == Some(&Token::Symbol('^'));
                if self.lexemes[self.position].gap || exponential {
                    return Err(self.reach());
                }
                if matches!(self.peek(), Some(Token::Number(_))) {
                    self.number_after(factors.last())?;
                }
                self.push_factor(&mut factors)?;
            }
        }
        Ok(product(factors, self.since(start)))
    }

    /// Whether a letter or number follows.
    fn at_letters(&self) -> bool {
        self.starts_factor()
            && match self.peek() {
                Some(Token::Letter(_) | Token::Number(_)) => true,
                Some(Token::Text(word)) => {
                    vocabulary::word_function(word).is_none() && !vocabulary::is_constant(word)
                }
                Some(Token::Command(command)) => super::starts_name(command),
                _ => false,
            }
    }

    /// Whether something follows that a reader might take for a part of the argument.
    fn argument_may_continue(&self) -> bool {
        self.starts_factor()
            && match self.peek() {
                Some(Token::Command(command)) => {
                    super::starts_name(command)
                        || matches!(command.as_str(), "frac" | "tfrac" | "dfrac")
                }
                Some(Token::Text(word)) => vocabulary::word_function(word).is_none(),
                _ => true,
            }
    }

    fn reach(&self) -> Box<Diagnostic> {
        let readings = ["part of the argument", "a factor after the function"];
        self.ambiguous(readings, self.here())
    }
}

/// Whether an exponent is -1.
pub(super) fn is_minus_one(expr: &Expr) -> bool {
    match &expr.kind {
        ExprKind::Sum(terms) => match terms.as_slice() {
            [(Sign::Minus, one)] => {
                matches!(&one.kind, ExprKind::Number(n) if n.is_one() && n.is_positive())
            }
            _ => false,
        },
        _ => false,
    }
}
