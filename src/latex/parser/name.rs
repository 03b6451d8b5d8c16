//! Names: letters with typeface, accent and dots, their indices, exponents and arguments.

use super::{Parse, Parser, starts_name};
use crate::diagnostic::DiagnosticKind;
use crate::expr::{Bracket, Expr, ExprKind, Font, Letter, Name, Sign, Subscript};
use crate::latex::lexer::{Delimiter, Token};
use crate::latex::{vocabulary, writer};
use crate::span::Span;
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Signed, Zero};

/// The longest number that is read, in characters.
const LONGEST_NUMBER: usize = 1000;

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
        let mut exponent = None;
        loop {
            if self.at_symbol('_') || self.at_symbol('\'') {
                self.index_or_prime(&mut name)?;
            } else if self.at_symbol('^') {
                self.power_or_prime(&mut name, &mut exponent)?;
            } else {
                break;
            }
        }
        let scripted = self.since(start);
        if self.is_expectation(&name) {
            let mut inner = self.bracketed()?;
            if let ExprKind::Group { inner: held, .. } = inner.kind {
                inner = *held;
            }
            let kind = ExprKind::Expectation(Box::new(inner));
            let base = Expr::new(kind, self.since(start));
            return self.raised_by(base, exponent);
        }
        let mut base = Expr::new(ExprKind::Name(name), scripted);
        if self.at_arguments(&base)? {
            if let Some(exponent) = &exponent
                && !self.arguments_after_exponent(&base)?
            {
                return self.raise(base, exponent.clone());
            }
            let ExprKind::Name(function) = base.kind else {
                return Ok(base);
            };
            let arguments = self.arguments()?;
            let kind = ExprKind::Apply {
                function,
                arguments,
            };
            base = Expr::new(kind, self.since(start));
            return self.raised_by(base, exponent);
        }
        match exponent {
            Some(exponent) => self.raise(base, exponent),
            None => Ok(base),
        }
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

    fn double_superscript(&self, start: Span) -> Box<crate::diagnostic::Diagnostic> {
        self.ambiguous(["(a^b)^c", "a^(b^c)"], self.since(start))
    }

    /// Both readings of a subscript; the underscore is taken.
    fn subscript(&mut self) -> Parse<Subscript> {
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
        self.diagnostics.truncate(complaints);
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
                if script {
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
            return Err(self.error(bad(), span));
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
    fn raised_by(&mut self, base: Expr, before: Option<Expr>) -> Parse<Expr> {
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

    /// A power, a transpose, or the transpose of the inverse.
    pub(super) fn raise(&mut self, base: Expr, exponent: Expr) -> Parse<Expr> {
        let span = self.since(base.span).to(exponent.span);
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
        let declared = self.signature.knows_letter(&plain.letter.base);
        if is_matrix_like(base) {
            return Ok(true);
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

    fn is_expectation(&self, name: &Name) -> bool {
        let Some(Token::Open(Delimiter::Visible(bracket) | Delimiter::Stretched(bracket))) =
            self.peek()
        else {
            return false;
        };
        let letter = &name.letter;
        let conventional = letter.base == "E"
            && matches!(letter.font, Font::Roman | Font::Blackboard)
            && !self.signature.is_declared(name)
            && *bracket != Bracket::None;
        conventional || *bracket == Bracket::Curly && self.signature.is_expectation(name)
    }

    /// Whether arguments follow the name.
    fn at_arguments(&self, name: &Expr) -> Parse<bool> {
        let Some(Token::Open(
            Delimiter::Visible(Bracket::Round) | Delimiter::Stretched(Bracket::Round),
        )) = self.peek()
        else {
            return Ok(false);
        };
        let ExprKind::Name(printed) = &name.kind else {
            return Ok(false);
        };
        let open = self.position;
        let close = self.partner[open];
        if self.signature.is_function(printed) || self.holds_list(open, close) {
            return Ok(true);
        }
        if !self.signature.is_declared(printed) && self.holds_one_name(open + 1, close) {
            if close == open + 2
                && self
                    .letter_at(open + 1)
                    .is_some_and(|letter| self.signature.is_variable(&letter))
            {
                return Ok(true);
            }
            let span = name.span.to(self.lexemes[close].span);
            return Err(self.ambiguous(["a function of its argument", "a product"], span));
        }
        Ok(false)
    }

    /// The plain letter at a position.
    fn letter_at(&self, position: usize) -> Option<String> {
        match &self.lexemes[position].token {
            Token::Letter(c) => Some(c.to_string()),
            Token::Command(command) => Some(format!("\\{command}")),
            _ => None,
        }
    }

    /// Whether the bracket after `f^{-1}` holds the argument of `f`: a list, a name or a number,
    /// perhaps negative, or something in the letter that `f` is a function of. Anything else is
    /// a factor, as in `M^{-1}(K + N)`, if that letter is known.
    fn arguments_after_exponent(&self, function: &Expr) -> Parse<bool> {
        let open = self.position;
        let close = self.partner[open];
        let signed = usize::from(self.peek_at(1) == Some(&Token::Symbol('-')));
        if self.holds_list(open, close) || self.holds_one_name(open + 1 + signed, close) {
            return Ok(true);
        }
        let variables = match &function.kind {
            ExprKind::Name(name) => self.signature.variables(name),
            _ => None,
        };
        match variables {
            Some(variables) if !variables.is_empty() => Ok((open..close)
                .filter_map(|position| self.letter_at(position))
                .any(|letter| variables.contains(&letter))),
            _ => {
                let readings = ["the argument of the function", "a factor after its power"];
                Err(self.ambiguous(readings, self.lexemes[open].span))
            }
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
    fn arguments(&mut self) -> Parse<Vec<Expr>> {
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

/// Whether something bold or a matrix is printed in the expression.
fn is_matrix_like(expr: &Expr) -> bool {
    match &expr.kind {
        ExprKind::Matrix { .. } => true,
        ExprKind::Name(name) => name.letter.font == Font::Bold,
        ExprKind::Apply { function, .. } => function.letter.font == Font::Bold,
        ExprKind::Group { inner, .. } | ExprKind::Transpose(inner) => is_matrix_like(inner),
        ExprKind::Power { base, .. } => is_matrix_like(base),
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
