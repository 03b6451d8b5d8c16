//! Names: letters with typeface, accent and dots, their indices, exponents and arguments.

use super::apply::Applied;
use super::call::is_minus_one;
use super::{Parse, Parser};
use crate::diagnostic::DiagnosticKind;
use crate::expr::{Bracket, Expr, ExprKind, Font, Letter, Name};
use crate::latex::lexer::{Delimiter, Token};
use crate::latex::{vocabulary, writer};
use crate::span::Span;
use num_traits::Signed;

impl Parser<'_> {
    /// A name and nothing more: the key of a table, the variable of an integral.
    pub(in crate::latex) fn lone_name(&mut self) -> Parse<Name> {
        let start = self.here();
        let letter = self.letter()?;
        let ExprKind::Name(mut name) = letter.kind else {
            let kind = DiagnosticKind::Unexpected {
                found: writer::write_expr(&letter),
                expected: "a name".to_owned(),
            };
            return Err(self.error(kind, self.since(start)));
        };
        while self.at_symbol('_') || self.at_symbol('\'') {
            self.index_or_prime(&mut name)?;
        }
        Ok(name)
    }

    /// A name with everything that belongs to it.
    pub(super) fn name_factor(&mut self) -> Parse<Expr> {
        let start = self.here();
        let letter = self.letter()?;
        match letter.kind {
            ExprKind::Name(name) => self.scripted(name, start),
            _ => self.raised(letter),
        }
    }

    /// The letter itself; something else if a font or dots stand over more than a letter.
    pub(super) fn letter(&mut self) -> Parse<Expr> {
        let start = self.here();
        let name = match self.peek() {
            Some(Token::Letter(c)) => Name::italic(&c.to_string()),
            Some(Token::Text(word)) if !word.trim().is_empty() => Name {
                letter: Letter {
                    base: word.trim().to_owned(),
                    font: Font::Roman,
                    accent: None,
                    primes: 0,
                },
                dots: 0,
                subscript: None,
            },
            Some(Token::Command(command)) => {
                let command = command.clone();
                if vocabulary::is_letter(&command) || command == "partial" {
                    Name::italic(&format!("\\{command}"))
                } else if let Some(font) = vocabulary::font(&command) {
                    self.position += 1;
                    return self.in_font(font, start);
                } else if let Some(accent) = vocabulary::accent(&command) {
                    self.position += 1;
                    let mut body = self.argument(false)?;
                    body.span = self.since(start);
                    return match &mut body.kind {
                        ExprKind::Name(name) if name.letter.accent.is_none() && name.dots == 0 => {
                            name.letter.accent = Some(accent);
                            Ok(body)
                        }
                        _ => {
                            let kind = DiagnosticKind::Unexpected {
                                found: format!("\\{command}"),
                                expected: "one accent over one letter".to_owned(),
                            };
                            Err(self.error(kind, body.span))
                        }
                    };
                } else if let Some(dots) = vocabulary::dots(&command) {
                    self.position += 1;
                    let mut body = self.argument(false)?;
                    let span = self.since(start);
                    if let ExprKind::Name(name) = &mut body.kind {
                        name.dots = name.dots.saturating_add(dots);
                        return Ok(Expr::new(body.kind, span));
                    }
                    let kind = ExprKind::Derivative {
                        order: dots,
                        variable: None,
                        body: Box::new(body),
                    };
                    return Ok(Expr::new(kind, span));
                } else {
                    return Err(self.unexpected("a name"));
                }
            }
            _ => return Err(self.unexpected("a name")),
        };
        self.position += 1;
        Ok(Expr::new(ExprKind::Name(name), start))
    }

    /// What `\mathbf{...}` makes of its argument.
    fn in_font(&mut self, font: Font, start: Span) -> Parse<Expr> {
        // Upright or bold words: \mathbf{const}.
        if self.at(&Token::Open(Delimiter::Brace)) {
            let close = self.partner[self.position];
            let word: Option<String> = self.lexemes[self.position + 1..close]
                .iter()
                .map(|lexeme| match lexeme.token {
                    Token::Letter(c) => Some(c),
                    _ => None,
                })
                .collect();
            if word.as_deref().is_some_and(vocabulary::is_constant) {
                self.position = close + 1;
                return Ok(Expr::new(ExprKind::Constant, self.since(start)));
            }
        }
        let mut body = self.argument(false)?;
        let span = self.since(start);
        match &mut body.kind {
            ExprKind::Name(name) if name.letter.font == Font::Italic => {
                name.letter.font = font;
                Ok(Expr::new(body.kind, span))
            }
            ExprKind::Number(number) if number.is_integer() && !number.is_negative() => {
                let mut name = Name::italic(&number.to_string());
                name.letter.font = font;
                Ok(Expr::new(ExprKind::Name(name), span))
            }
            ExprKind::Product(_) => {
                Err(self.ambiguous(["one name of several letters", "a product"], span))
            }
            _ => {
                let kind = DiagnosticKind::Unexpected {
                    found: writer::write_expr(&body),
                    expected: "a letter in another typeface".to_owned(),
                };
                Err(self.error(kind, span))
            }
        }
    }

    /// The index, exponent and arguments of a name, in the orders in which they are printed.
    pub(super) fn scripted(&mut self, mut name: Name, start: Span) -> Parse<Expr> {
        let mut exponent: Option<Expr> = None;
        loop {
            if self.at_symbol('_') || self.at_symbol('\'') {
                let index = self.at_symbol('_');
                self.index_or_prime(&mut name)?;
                let bold = name.letter.font == Font::Bold && self.names_an_entry(&name);
                if index && exponent.is_some() && (bold || self.signature.has_entries(&name)) {
                    let readings = [
                        "the power of the entry, with the index printed first",
                        "the entry of the power, which needs a name of its own",
                    ];
                    return Err(self.ambiguous(readings, self.since(start)));
                }
            } else if self.at_symbol('^') {
                self.power_or_prime(&mut name, &mut exponent)?;
            } else {
                break;
            }
        }
        let scripted = self.since(start);
        if self.is_expectation(&name, scripted)? {
            let mut inner = self.bracketed()?;
            if let ExprKind::Group { inner: held, .. } = inner.kind {
                inner = *held;
            }
            let kind = ExprKind::Expectation(Box::new(inner));
            let base = Expr::new(kind, self.since(start));
            return self.raised_by(base, exponent);
        }
        if let Some(why) = self.at_arguments(&name, scripted, exponent.is_some())? {
            let arguments = self.arguments()?;
            let chosen = match &exponent {
                Some(exponent) => self.raises_value(&name, &arguments, exponent)?,
                None => false,
            };
            let kind = ExprKind::Apply {
                function: name,
                arguments,
            };
            let base = Expr::new(kind, self.since(start));
            match why {
                Applied::Declared => {}
                Applied::AsElsewhere => self.note_reading(&base),
            }
            let raised = self.raised_by(base, exponent)?;
            if chosen {
                self.note_reading(&raised);
            }
            return Ok(raised);
        }
        if let Some(exponent) = &exponent
            && is_minus_one(exponent)
            && name.letter.font != Font::Bold
            && self.signature.is_formal(&name)
        {
            return Err(self.inverse(exponent.span));
        }
        let base = Expr::new(ExprKind::Name(name), scripted);
        match exponent {
            Some(exponent) => self.raise(base, exponent),
            None => Ok(base),
        }
    }

    /// Whether the index of a bold letter is made of numbers, and the letter without it is declared.
    fn names_an_entry(&self, name: &Name) -> bool {
        let Some(subscript) = &name.subscript else {
            return false;
        };
        let bare = Name {
            subscript: None,
            ..name.undotted()
        };
        let number = |e: &Expr| matches!(e.kind, ExprKind::Number(_));
        self.signature.is_declared(&bare)
            && !subscript.indices.is_empty()
            && subscript.indices.iter().all(number)
    }

    /// Whether `f^2(x)` is a choice: the square of f(x), and not f(f(x)), by the convention of `\sin^2 x`. Of
    /// `f^{-1}(x)` there is none. A matrix has no inverse but that of its value, and what has several
    /// arguments, or is declared as a function of the time, cannot be put into itself.
    fn raises_value(&self, name: &Name, arguments: &[Expr], exponent: &Expr) -> Parse<bool> {
        if name.letter.font == Font::Bold || arguments.len() != 1 {
            return Ok(false);
        }
        if is_minus_one(exponent) {
            return Err(self.inverse(exponent.span));
        }
        Ok(self.signature.is_formal(name))
    }

    fn index_or_prime(&mut self, name: &mut Name) -> Parse<()> {
        if self.accept_symbol('\'') {
            name.letter.primes = name.letter.primes.saturating_add(1);
            return Ok(());
        }
        let start = self.here();
        self.position += 1;
        let subscript = self.subscript()?;
        if name.subscript.is_some() {
            let readings = ["one index after the other", "an index of the index"];
            return Err(self.ambiguous(readings, self.since(start)));
        }
        name.subscript = Some(subscript);
        Ok(())
    }

    fn power_or_prime(&mut self, name: &mut Name, exponent: &mut Option<Expr>) -> Parse<()> {
        let start = self.here();
        self.position += 1;
        let primes = self.superscript_primes();
        if primes > 0 {
            name.letter.primes = name.letter.primes.saturating_add(primes);
            return Ok(());
        }
        let found = self.argument(true)?;
        if exponent.is_some() {
            return Err(self.double_superscript(start));
        }
        *exponent = Some(found);
        Ok(())
    }

    /// Takes `\prime` or `{\prime\prime}`.
    fn superscript_primes(&mut self) -> u8 {
        if self.at_command("prime") {
            self.position += 1;
            return 1;
        }
        if !self.at(&Token::Open(Delimiter::Brace)) {
            return 0;
        }
        let close = self.partner[self.position];
        let inner = &self.lexemes[self.position + 1..close];
        let all = inner
            .iter()
            .all(|l| matches!(&l.token, Token::Command(c) if c == "prime"));
        if inner.is_empty() || !all {
            return 0;
        }
        self.position = close + 1;
        u8::try_from(inner.len()).unwrap_or(u8::MAX)
    }

    fn is_expectation(&self, name: &Name, span: Span) -> Parse<bool> {
        let Some(Token::Open(Delimiter::Visible(bracket) | Delimiter::Stretched(bracket))) =
            self.peek()
        else {
            return Ok(false);
        };
        let letter = &name.letter;
        let conventional = letter.base == "E"
            && matches!(letter.font, Font::Roman | Font::Blackboard)
            && !self.signature.is_declared(name)
            && *bracket != Bracket::None;
        let curly = *bracket == Bracket::Curly && self.signature.is_expectation(name);
        let known = self.signature.is_declared(name)
            || self.signature.is_function(name)
            || self.running.contains(name);
        if curly && known {
            let span = span.to(self.lexemes[self.partner[self.position]].span);
            return Err(self.ambiguous(["the expectation", "a product with the letter"], span));
        }
        Ok(conventional || curly)
    }
}
