//! The grammar: recursive descent over laid-out lexemes, one file for each part of it.
//!
//! A failure carries its diagnostic; the places that can go on after one (the cells of a
//! matrix, the equations of a display) record it and look further, so that all of a text's
//! errors come out together. The recursion is bounded by [`DEPTH_LIMIT`].

mod apply;
mod bracket;
mod call;
mod display;
mod matrix;
mod name;
mod operator;
mod script;
mod slash;
mod vector;

pub(super) use operator::begins_with_bracket;
pub(super) use script::is_mark;
pub(crate) use script::is_matrix_like;
pub(super) use slash::{ends_divisor, ends_in_bare_letters};

use super::Reading;
use super::layout::{DEPTH_LIMIT, Layout};
use super::lexer::{Delimiter, Lexeme, Token};
use super::signature::Signature;
use super::vocabulary;
use crate::diagnostic::{Diagnostic, DiagnosticKind};
use crate::expr::{
    Bracket, Chain, Expr, ExprKind, Name, QuotientStyle, Relation, Separation, Sign,
};
use crate::span::Span;
use vector::Dot;

/// What was read, or why it could not be.
type Parse<T> = Result<T, Box<Diagnostic>>;

/// The state of the descent.
pub(super) struct Parser<'s> {
    lexemes: Vec<Lexeme>,
    partner: Vec<usize>,
    position: usize,
    end: Span,
    signature: &'s Signature,
    /// How many factors are open around this one.
    depth: usize,
    /// How many brackets, braces and cells are open; words outside all of them are remarks.
    nesting: usize,
    /// Whether `dx` ends what is being read.
    in_integral: bool,
    /// How many integrals wait for their `dx`.
    open_integrals: usize,
    /// Whether `|` ends what is being read.
    in_bars: bool,
    /// The word before the clause that is read next, such as "for".
    joined: Option<String>,
    /// What separates that clause from the one before it.
    separation: Separation,
    /// Whether the clauses that are read stand in brackets of their own.
    bracketed: bool,
    /// The running indices of the sums that are read.
    running: Vec<Name>,
    /// What was read in one of several ways.
    readings: Vec<Reading>,
    diagnostics: Vec<Diagnostic>,
}

impl<'s> Parser<'s> {
    pub(super) fn new(layout: Layout, signature: &'s Signature) -> Self {
        Parser {
            lexemes: layout.lexemes,
            partner: layout.partner,
            position: 0,
            end: layout.end,
            signature,
            depth: 0,
            nesting: 0,
            in_integral: false,
            open_integrals: 0,
            in_bars: false,
            joined: None,
            separation: Separation::None,
            bracketed: false,
            running: Vec::new(),
            readings: Vec::new(),
            diagnostics: Vec::new(),
        }
    }

    /// The result and the readings that were chosen, unless something was wrong on the way.
    pub(super) fn finish<T>(
        mut self,
        result: Parse<T>,
    ) -> Result<(T, Vec<Reading>), Vec<Diagnostic>> {
        match result {
            Ok(value) if self.diagnostics.is_empty() => Ok((value, self.readings)),
            Ok(_) => Err(self.diagnostics),
            Err(diagnostic) => {
                self.diagnostics.push(*diagnostic);
                self.diagnostics.sort_by_key(|d| d.span);
                Err(self.diagnostics)
            }
        }
    }

    /// Reads with `part` and insists that nothing is left.
    pub(super) fn whole<T>(&mut self, part: fn(&mut Self) -> Parse<T>) -> Parse<T> {
        let value = part(self)?;
        match self.peek() {
            None => Ok(value),
            Some(_) => Err(self.unexpected("the end")),
        }
    }

    fn peek(&self) -> Option<&Token> {
        Some(&self.lexemes.get(self.position)?.token)
    }

    fn peek_at(&self, distance: usize) -> Option<&Token> {
        Some(&self.lexemes.get(self.position + distance)?.token)
    }

    /// Where the next lexeme stands.
    fn here(&self) -> Span {
        self.lexemes
            .get(self.position)
            .map_or(self.end, |lexeme| lexeme.span)
    }

    /// From `start` to the end of the lexeme just read.
    fn since(&self, start: Span) -> Span {
        match self.position.checked_sub(1) {
            Some(last) => start.to(self.lexemes[last].span),
            None => start,
        }
    }

    fn at(&self, token: &Token) -> bool {
        self.peek() == Some(token)
    }

    fn at_symbol(&self, symbol: char) -> bool {
        self.at(&Token::Symbol(symbol))
    }

    fn at_command(&self, command: &str) -> bool {
        matches!(self.peek(), Some(Token::Command(c)) if c == command)
    }

    fn accept_symbol(&mut self, symbol: char) -> bool {
        let found = self.at_symbol(symbol);
        self.position += usize::from(found);
        found
    }

    fn expect_symbol(&mut self, symbol: char) -> Parse<()> {
        if self.accept_symbol(symbol) {
            Ok(())
        } else {
            Err(self.unexpected(&symbol.to_string()))
        }
    }

    /// Whether the next lexeme closes a bracket or environment, or nothing is left.
    fn at_close(&self) -> bool {
        matches!(self.peek(), None | Some(Token::Close(_) | Token::End(_)))
    }

    /// Steps over the closing lexeme at `close`, or says what else stands here.
    fn close(&mut self, close: usize) -> Parse<()> {
        if self.position != close {
            let expected = self.lexemes[close].token.spelling();
            return Err(self.unexpected(&expected));
        }
        self.position += 1;
        Ok(())
    }

    fn unexpected(&self, expected: &str) -> Box<Diagnostic> {
        let found = self.peek().map_or("the end".to_owned(), Token::spelling);
        let expected = expected.to_owned();
        self.error(DiagnosticKind::Unexpected { found, expected }, self.here())
    }

    fn error(&self, kind: DiagnosticKind, span: Span) -> Box<Diagnostic> {
        Box::new(Diagnostic::new(kind, span))
    }

    fn ambiguous(&self, readings: [&str; 2], span: Span) -> Box<Diagnostic> {
        let readings = readings.map(str::to_owned).to_vec();
        self.error(DiagnosticKind::Ambiguous { readings }, span)
    }

    /// One level deeper.
    fn nested<T>(&mut self, part: impl FnOnce(&mut Self) -> Parse<T>) -> Parse<T> {
        if self.depth == DEPTH_LIMIT {
            let kind = DiagnosticKind::TooDeep { limit: DEPTH_LIMIT };
            return Err(self.error(kind, self.here()));
        }
        self.depth += 1;
        let result = part(self);
        self.depth -= 1;
        result
    }

    /// Inside a bracket, where neither `dx` nor `|` of the outside ends anything.
    fn inside<T>(&mut self, part: impl FnOnce(&mut Self) -> Parse<T>) -> Parse<T> {
        let outside = (self.in_integral, self.open_integrals, self.in_bars);
        (self.in_integral, self.open_integrals, self.in_bars) = (false, 0, false);
        self.nesting += 1;
        let result = part(self);
        self.nesting -= 1;
        (self.in_integral, self.open_integrals, self.in_bars) = outside;
        result
    }

    /// `X = Y = Z`
    pub(super) fn chain(&mut self) -> Parse<Chain> {
        let start = self.here();
        let mut members = vec![self.expression()?];
        let mut relations = Vec::new();
        while let Some(relation) = self.relation() {
            relations.push(relation);
            members.push(self.expression()?);
        }
        Ok(Chain {
            members,
            relations,
            span: self.since(start),
        })
    }

    /// Takes a relation if one follows.
    fn relation(&mut self) -> Option<Relation> {
        let relation = match self.peek()? {
            Token::Symbol('=') => Relation::Equal,
            Token::Symbol('<') => Relation::Less,
            Token::Symbol('>') => Relation::Greater,
            Token::Symbol(':') if self.peek_at(1) == Some(&Token::Symbol('=')) => {
                self.position += 1;
                Relation::Equal
            }
            Token::Command(command) => vocabulary::relation(command)?,
            _ => return None,
        };
        self.position += 1;
        Some(relation)
    }

    /// Terms with signs between them.
    pub(super) fn expression(&mut self) -> Parse<Expr> {
        let start = self.here();
        let leading = self.sign();
        let mut terms = vec![(leading.unwrap_or(Sign::Plus), self.term()?)];
        while let Some(sign) = self.sign() {
            terms.push((sign, self.term()?));
        }
        if leading.is_none()
            && terms.len() == 1
            && let Some((_, only)) = terms.pop()
        {
            return Ok(only);
        }
        Ok(Expr::new(ExprKind::Sum(terms), self.since(start)))
    }

    fn sign(&mut self) -> Option<Sign> {
        let sign = match self.peek()? {
            Token::Symbol('+') => Sign::Plus,
            Token::Symbol('-') => Sign::Minus,
            _ => return None,
        };
        self.position += 1;
        Some(sign)
    }

    /// Juxtaposed runs joined by `\cdot` or `\times`.
    fn term(&mut self) -> Parse<Expr> {
        let start = self.here();
        let mut factors = self.run()?;
        loop {
            let sign = match self.peek() {
                Some(Token::Command(c)) if c == "cdot" => Dot::Scalar,
                Some(Token::Command(c)) if c == "times" => Dot::Cross,
                _ => break,
            };
            let left = self.since(start);
            self.position += 1;
            let right = self.run()?;
            factors = self.multiplied(factors, sign, right, left)?;
        }
        Ok(product(factors, self.since(start)))
    }

    /// At least one factor, with nothing between them.
    fn juxtaposed(&mut self) -> Parse<Vec<Expr>> {
        self.spaced_factors().map(|(factors, _)| factors)
    }

    /// At least one factor, and how many precede each printed space between them.
    fn spaced_factors(&mut self) -> Parse<(Vec<Expr>, Vec<usize>)> {
        let mut factors = Vec::new();
        let mut gaps = Vec::new();
        self.push_factor(&mut factors)?;
        while self.starts_factor() {
            if matches!(self.peek(), Some(Token::Number(_))) {
                self.number_after(factors.last())?;
            }
            if self.lexemes[self.position].gap {
                gaps.push(factors.len());
            }
            let here = self.here();
            self.push_factor(&mut factors)?;
            if let [.., before, after] = factors.as_slice()
                && looks_mixed(before, after)
            {
                return Err(self.ambiguous(["a mixed number", "a product"], here));
            }
        }
        Ok((factors, gaps))
    }

    fn push_factor(&mut self, factors: &mut Vec<Expr>) -> Parse<()> {
        let factor = self.factor()?;
        match factor.kind {
            ExprKind::Product(parts) => factors.extend(parts),
            _ => factors.push(factor),
        }
        Ok(())
    }

    /// A number may follow a bracket, as in `0(1)6`, and nothing else.
    fn number_after(&self, before: Option<&Expr>) -> Parse<()> {
        match before.map(|before| &before.kind) {
            None | Some(ExprKind::Group { .. }) => Ok(()),
            Some(ExprKind::Number(_)) => {
                Err(self.ambiguous(["one number", "a product of two"], self.here()))
            }
            Some(_) => Err(self.ambiguous(["a factor", "an index or exponent"], self.here())),
        }
    }

    /// Whether the next lexeme continues a product.
    fn starts_factor(&self) -> bool {
        match self.peek() {
            Some(Token::Letter(_)) => !self.at_differential(),
            Some(Token::Number(_) | Token::Open(_) | Token::Begin(_)) => true,
            Some(Token::Text(word)) => {
                !self.at_differential()
                    && !self.is_remark(word)
                    && !vocabulary::is_conjunction(word)
            }
            Some(Token::Symbol('|')) => !self.in_bars,
            Some(Token::Command(command)) => starts_operand(command),
            _ => false,
        }
    }

    /// Whether upright words outside all brackets are said about the equation, not in it.
    fn is_remark(&self, word: &str) -> bool {
        self.nesting == 0
            && !vocabulary::is_constant(word)
            && !vocabulary::is_conjunction(word)
            && (word.contains(' ') || word.ends_with([',', ';', '.', ':']))
    }

    /// One factor with its index, exponent and arguments.
    fn factor(&mut self) -> Parse<Expr> {
        self.nested(Self::unguarded_factor)
    }

    fn unguarded_factor(&mut self) -> Parse<Expr> {
        match self.peek() {
            Some(Token::Letter(_)) => self.name_factor(),
            Some(Token::Number(_)) => {
                let number = self.number()?;
                self.raised(number)
            }
            Some(Token::Text(word)) => {
                if vocabulary::is_constant(word) {
                    let kind = ExprKind::Constant;
                    let span = self.here();
                    self.position += 1;
                    Ok(Expr::new(kind, span))
                } else if let Some(function) = vocabulary::word_function(word) {
                    self.call(function)
                } else if self.is_remark(word) || vocabulary::is_conjunction(word) {
                    Err(self.unexpected("a factor"))
                } else {
                    self.name_factor()
                }
            }
            Some(Token::Open(Delimiter::Brace)) => self.braced(),
            Some(Token::Open(Delimiter::Visible(b) | Delimiter::Stretched(b))) => {
                if *b == Bracket::Bar {
                    self.absolute()
                } else {
                    let bracketed = self.bracketed()?;
                    self.raised(bracketed)
                }
            }
            Some(Token::Symbol('|')) => self.absolute(),
            Some(Token::Begin(_)) => {
                let matrix = self.environment()?;
                match matrix.kind {
                    ExprKind::Matrix { .. } | ExprKind::Call { .. } => self.raised(matrix),
                    _ => Ok(matrix),
                }
            }
            Some(Token::Command(command)) => {
                if let Some(function) = vocabulary::function(command) {
                    return self.call(function);
                }
                match command.as_str() {
                    "frac" | "tfrac" | "dfrac" => self.fraction(),
                    "sum" => self.big_sum(),
                    "int" => self.integral(),
                    "underbrace" => self.underbrace(),
                    "infty" => {
                        let span = self.here();
                        self.position += 1;
                        Ok(Expr::new(ExprKind::Infinity, span))
                    }
                    command if starts_operand(command) => self.name_factor(),
                    _ => Err(self.unexpected("a factor")),
                }
            }
            _ => Err(self.unexpected("a factor")),
        }
    }
}

/// Whether a number and a fraction below one stand side by side, as in two and a half.
pub(super) fn looks_mixed(before: &Expr, after: &Expr) -> bool {
    let ExprKind::Quotient {
        numerator,
        denominator,
        style: QuotientStyle::Bar,
    } = &after.kind
    else {
        return false;
    };
    match (&before.kind, &numerator.kind, &denominator.kind) {
        (ExprKind::Number(whole), ExprKind::Number(above), ExprKind::Number(below)) => {
            whole.is_integer() && above < below
        }
        _ => false,
    }
}

/// Whether an operand can begin with this command.
fn starts_operand(command: &str) -> bool {
    starts_name(command)
        || vocabulary::function(command).is_some()
        || matches!(
            command,
            "frac" | "tfrac" | "dfrac" | "sum" | "int" | "underbrace" | "infty"
        )
}

/// Whether a name can begin with this command.
fn starts_name(command: &str) -> bool {
    vocabulary::is_letter(command)
        || command == "partial"
        || vocabulary::font(command).is_some()
        || vocabulary::accent(command).is_some()
        || vocabulary::dots(command).is_some()
}

/// The product of the factors; a single factor is itself.
fn product(mut factors: Vec<Expr>, span: Span) -> Expr {
    if factors.len() == 1
        && let Some(only) = factors.pop()
    {
        return only;
    }
    Expr::new(ExprKind::Product(factors), span)
}
