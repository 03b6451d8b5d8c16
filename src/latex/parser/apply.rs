//! Functions applied to arguments: which bracket after a name holds arguments, and which a factor.

use super::{Parse, Parser, starts_name};
use crate::expr::{Bracket, Expr, ExprKind, Font, Name};
use crate::latex::lexer::{Delimiter, Token};
use crate::latex::vocabulary;
use crate::span::Span;

/// Why a bracket after a name holds arguments.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Applied {
    /// The name is declared so, or what stands in the bracket is an argument of it.
    Declared,
    /// The name has arguments wherever it stands: a choice, which is named.
    AsElsewhere,
}

impl Parser<'_> {
    /// Whether the bracket that follows holds arguments of the name, which may be raised already.
    pub(super) fn at_arguments(
        &self,
        name: &Name,
        span: Span,
        raised: bool,
    ) -> Parse<Option<Applied>> {
        let open = self.position;
        if !self.at_round_bracket() {
            return self.no_function_of_other_brackets(name, span);
        }
        let close = self.partner[open];
        if self.holds_list(open, close) {
            return Ok(Some(Applied::Declared));
        }
        let ambiguous = || {
            let span = span.to(self.lexemes[close].span);
            self.ambiguous(["a function of its argument", "a product"], span)
        };
        let Some(variables) = self.signature.variables(name) else {
            if self.signature.is_no_function(name) || !self.holds_one_name(open + 1, close) {
                return Ok(None);
            }
            let variable = close == open + 2
                && self
                    .letter_at(open + 1)
                    .is_some_and(|letter| self.signature.is_variable(&letter));
            return match (variable, self.signature.is_declared(name)) {
                (true, _) => Ok(Some(Applied::Declared)),
                (false, true) => Ok(None),
                (false, false) => Err(ambiguous()),
            };
        };
        let signed = usize::from(self.peek_at(1) == Some(&Token::Symbol('-')));
        if self.holds_one_name(open + 1 + signed, close) {
            return Ok(Some(Applied::Declared));
        }
        let mentioned = (open..close)
            .filter_map(|position| self.letter_at(position))
            .any(|letter| variables.contains(&letter));
        match (variables.is_empty(), mentioned, raised) {
            (_, true, _) | (true, _, false) => Ok(Some(Applied::Declared)),
            // M^{-1}(K + N): a power of the function at no argument, and a factor.
            (false, false, true) if name.letter.font == Font::Bold => Ok(None),
            (false, false, true) if !self.signature.is_formal(name) => Ok(None),
            (false, false, false) if self.signature.is_always_applied(name) => {
                Ok(Some(Applied::AsElsewhere))
            }
            (false, false, _) | (true, false, true) => Err(ambiguous()),
        }
    }

    /// Whether a round bracket is next.
    pub(super) fn at_round_bracket(&self) -> bool {
        matches!(
            self.peek(),
            Some(Token::Open(
                Delimiter::Visible(Bracket::Round) | Delimiter::Stretched(Bracket::Round)
            ))
        )
    }

    /// Whether square or curly brackets after a function hold what it is never a function of: then they are a factor.
    fn no_function_of_other_brackets(&self, name: &Name, span: Span) -> Parse<Option<Applied>> {
        let Some(Token::Open(
            Delimiter::Visible(Bracket::Square | Bracket::Curly)
            | Delimiter::Stretched(Bracket::Square | Bracket::Curly),
        )) = self.peek()
        else {
            return Ok(None);
        };
        let (open, close) = (self.position, self.partner[self.position]);
        let Some(variables) = self.signature.variables(name) else {
            return Ok(None);
        };
        let mut letters = (open..close).filter_map(|position| self.letter_at(position));
        if self.holds_one_name(open + 1, close) || letters.any(|l| variables.contains(&l)) {
            let span = span.to(self.lexemes[close].span);
            return Err(self.ambiguous(["a function of its argument", "a product"], span));
        }
        Ok(None)
    }

    /// The plain letter at a position.
    fn letter_at(&self, position: usize) -> Option<String> {
        match &self.lexemes[position].token {
            Token::Letter(c) => Some(c.to_string()),
            Token::Command(command) => Some(format!("\\{command}")),
            _ => None,
        }
    }

    /// Whether a comma or an equals sign stands in the bracket itself.
    fn holds_list(&self, open: usize, close: usize) -> bool {
        let mut position = open + 1;
        while position < close {
            match self.lexemes[position].token {
                Token::Symbol(',' | '=') => return true,
                Token::Open(_) | Token::Begin(_) => position = self.partner[position],
                _ => {}
            }
            position += 1;
        }
        false
    }

    /// Whether the bracket holds a single name or number, with accents and index.
    fn holds_one_name(&self, mut position: usize, close: usize) -> bool {
        let after = |position: usize| match self.lexemes[position].token {
            Token::Open(_) => self.partner[position] + 1,
            _ => position + 1,
        };
        while position < close {
            match &self.lexemes[position].token {
                Token::Command(c)
                    if vocabulary::font(c).is_some()
                        || vocabulary::accent(c).is_some()
                        || vocabulary::dots(c).is_some() =>
                {
                    position += 1;
                }
                Token::Open(Delimiter::Brace) | Token::Letter(_) | Token::Number(_) => break,
                Token::Text(_) => break,
                Token::Command(c) if starts_name(c) || c == "infty" => break,
                _ => return false,
            }
        }
        if position >= close {
            return false;
        }
        position = after(position);
        while position < close {
            match &self.lexemes[position].token {
                Token::Symbol('\'') => position += 1,
                Token::Symbol('_') if position + 1 < close => position = after(position + 1),
                _ => return false,
            }
        }
        true
    }

    /// The arguments in round brackets.
    pub(super) fn arguments(&mut self) -> Parse<Vec<Expr>> {
        let close = self.partner[self.position];
        self.position += 1;
        self.inside(|parser| {
            let mut arguments = vec![parser.argument_of_function()?];
            while parser.accept_symbol(',') {
                arguments.push(parser.argument_of_function()?);
            }
            parser.close(close)?;
            Ok(arguments)
        })
    }

    fn argument_of_function(&mut self) -> Parse<Expr> {
        let start = self.here();
        let argument = self.expression()?;
        if !self.at_symbol('=') {
            return Ok(argument);
        }
        let ExprKind::Name(name) = argument.kind else {
            return Err(self.unexpected(")"));
        };
        self.position += 1;
        let value = Box::new(self.expression()?);
        let kind = ExprKind::Named { name, value };
        Ok(Expr::new(kind, self.since(start)))
    }
}
