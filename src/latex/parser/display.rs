//! Everything under one equation number: clauses, headings, ranges, remarks.

use super::{Parse, Parser};
use crate::diagnostic::DiagnosticKind;
use crate::expr::{Bracket, Chain, Clause, Expr, ExprKind, IndexRange, Name, Relation, Separation};
use crate::latex::layout::is_relation;
use crate::latex::lexer::{Delimiter, Token};
use crate::latex::signature::{Head, Shape};
use crate::latex::vocabulary::{self, Environment};
use num_rational::BigRational;
use num_traits::One;

/// The longest equation, in letters, numbers and signs.
const LONGEST_CLAUSE: usize = 20_000;

impl Parser<'_> {
    /// All clauses of the display.
    pub(in crate::latex) fn display(&mut self) -> Parse<Vec<Clause>> {
        let mut clauses = Vec::new();
        while self.peek().is_some() {
            self.clauses(&mut clauses)?;
            if self.peek().is_some() {
                let stray = self.unexpected("an equation");
                self.diagnostics.push(*stray);
                self.position += 1;
            }
        }
        if clauses.is_empty() && self.diagnostics.is_empty() {
            return Err(self.unexpected("an equation"));
        }
        Ok(clauses)
    }

    /// Clauses up to a closing lexeme; a bad one is reported and the next one read.
    fn clauses(&mut self, clauses: &mut Vec<Clause>) -> Parse<()> {
        loop {
            self.skip_separators();
            if self.at_close() {
                return Ok(());
            }
            let start = self.position;
            if let Err(diagnostic) = self.clause_or_group(clauses) {
                if matches!(diagnostic.kind, DiagnosticKind::TooDeep { .. }) {
                    return Err(diagnostic);
                }
                self.diagnostics.push(*diagnostic);
                self.position = self.position.max(start);
                self.skip_clause(start);
            }
        }
    }

    fn is_separator(token: &Token) -> bool {
        matches!(
            token,
            Token::Symbol(',' | ';' | '.') | Token::RowBreak | Token::Space(_)
        ) || matches!(token, Token::Text(word) if vocabulary::is_conjunction(word))
    }

    fn skip_separators(&mut self) {
        loop {
            if self.peek().is_some_and(Self::is_separator) {
                match self.peek() {
                    Some(Token::Text(word)) => {
                        self.joined = Some(word.trim().trim_end_matches(',').to_owned());
                    }
                    Some(mark) => self.separation = separated(self.separation, mark),
                    None => {}
                }
                self.position += 1;
            } else if self.at_bare_and() {
                self.joined = Some("and".to_owned());
                self.position += 3;
            } else {
                return;
            }
        }
    }

    /// The word "and" set in italics by an author who forgot `\text`.
    fn at_bare_and(&self) -> bool {
        let letters = ['a', 'n', 'd'];
        let set = letters.iter().enumerate().all(|(distance, letter)| {
            self.peek_at(distance) == Some(&Token::Letter(*letter))
                && (distance == 0 || !self.lexemes[self.position + distance].spaced)
        });
        set && self.position > 0
            && match self.lexemes.get(self.position + 3) {
                Some(next) => {
                    matches!(next.token, Token::Space(_))
                        || next.spaced && !is_relation(&next.token)
                }
                None => false,
            }
    }

    /// Goes to the separator that ends the clause that began at `start`.
    fn skip_clause(&mut self, start: usize) {
        let failed = self.position;
        self.position = start;
        while let Some(token) = self.peek() {
            match token {
                Token::Open(_) | Token::Begin(_) => {
                    self.position = self.partner[self.position];
                }
                Token::Close(_) | Token::End(_) if self.position >= failed => return,
                token if self.position >= failed && Self::is_separator(token) => return,
                _ => {}
            }
            self.position += 1;
        }
    }

    fn clause_or_group(&mut self, clauses: &mut Vec<Clause>) -> Parse<()> {
        match (self.peek(), self.peek_at(1)) {
            (Some(Token::Begin(Environment::Lines)), _) if self.is_group(self.position) => {
                let end = self.partner[self.position];
                self.position += 1;
                self.nested(|parser| parser.clauses(clauses))?;
                self.close(end)
            }
            (
                Some(Token::Open(Delimiter::Stretched(Bracket::None | Bracket::Curly))),
                Some(Token::Begin(Environment::Lines)),
            ) => {
                let close = self.partner[self.position];
                self.position += 1;
                self.nested(|parser| parser.clauses(clauses))?;
                self.close(close)
            }
            (Some(Token::Open(_)), _) if self.is_bracketed_clause() => {
                let close = self.partner[self.position];
                self.position += 1;
                let outside = std::mem::replace(&mut self.bracketed, true);
                let held = self.nested(|parser| parser.clauses(clauses));
                self.bracketed = outside;
                held?;
                self.close(close)
            }
            _ => self.clause(clauses),
        }
    }

    /// Whether the lines hold equations and not one expression that a chain goes on with.
    fn is_group(&self, begin: usize) -> bool {
        let after = self.lexemes.get(self.partner[begin] + 1);
        !after.is_some_and(|lexeme| is_relation(&lexeme.token))
    }

    /// `(g^2 q = 2a)` standing alone.
    fn is_bracketed_clause(&self) -> bool {
        if !matches!(
            self.peek(),
            Some(Token::Open(
                Delimiter::Visible(Bracket::Round) | Delimiter::Stretched(Bracket::Round)
            ))
        ) {
            return false;
        }
        let close = self.partner[self.position];
        let mut position = self.position + 1;
        let mut related = false;
        while position < close {
            let token = &self.lexemes[position].token;
            related |= is_relation(token);
            if matches!(token, Token::Open(_) | Token::Begin(_)) {
                position = self.partner[position];
            }
            position += 1;
        }
        related
            && self
                .lexemes
                .get(close + 1)
                .is_none_or(|l| Self::is_separator(&l.token) || matches!(l.token, Token::End(_)))
    }

    /// What the display defines: `a = ...`, `f(t) = ...` at the beginning of an equation, and
    /// the names under braces.
    pub(in crate::latex) fn heads(&mut self) -> Vec<Head> {
        let mut heads = Vec::new();
        let mut begins = true;
        for position in 0..self.lexemes.len() {
            let braced = self.at_brace_label(position);
            if begins || braced {
                self.position = if braced { position + 2 } else { position };
                heads.extend(self.head(braced));
            }
            begins = match &self.lexemes[position].token {
                Token::Begin(Environment::Lines)
                | Token::Open(Delimiter::Stretched(Bracket::None | Bracket::Curly)) => begins,
                token => Self::is_separator(token),
            };
        }
        heads
    }

    /// Whether the underscore of `\underbrace{...}_{` stands here.
    fn at_brace_label(&self, position: usize) -> bool {
        self.lexemes[position].token == Token::Symbol('_')
            && position > 0
            && self.lexemes[position - 1].token == Token::Close(Delimiter::Brace)
            && self.partner[position - 1] > 0
            && matches!(
                &self.lexemes[self.partner[position - 1] - 1].token,
                Token::Command(command) if command == "underbrace"
            )
            && self
                .lexemes
                .get(position + 1)
                .is_some_and(|next| next.token == Token::Open(Delimiter::Brace))
    }

    /// A name, perhaps with arguments that are names, before an equals sign or the end of a label.
    fn head(&mut self, braced: bool) -> Option<Head> {
        let name = self.lone_name().ok()?;
        let mut arguments = Vec::new();
        if self.at(&Token::Open(Delimiter::Visible(Bracket::Round))) {
            let close = self.partner[self.position];
            while self.position < close {
                self.position += 1;
                arguments.push(self.lone_name().ok()?);
                if self.position < close && !self.at_symbol(',') {
                    return None;
                }
            }
            self.position += 1;
        }
        let ends = self.at_symbol('=') || braced && self.at(&Token::Close(Delimiter::Brace));
        ends.then(|| Head {
            shape: self.shape_behind(),
            name,
            arguments,
        })
    }

    /// The shape of the matrix that is all that stands behind the equals sign.
    fn shape_behind(&self) -> Option<Shape> {
        let open = self.position + 1;
        let Token::Begin(Environment::Matrix(_)) = self.lexemes.get(open)?.token else {
            return None;
        };
        let close = self.partner[open];
        let ends = |token: &Token| {
            Self::is_separator(token)
                || is_relation(token)
                || matches!(token, Token::End(_) | Token::Close(_))
        };
        if self
            .lexemes
            .get(close + 1)
            .is_some_and(|next| !ends(&next.token))
        {
            return None;
        }
        let inside = |mark: &Token| self.lexemes[open..close].iter().any(|l| l.token == *mark);
        Some(match inside(&Token::Symbol('&')) {
            false if inside(&Token::RowBreak) => Shape::Column,
            _ => Shape::Matrix,
        })
    }

    fn clause(&mut self, clauses: &mut Vec<Clause>) -> Parse<()> {
        let heading = self.heading();
        self.skip_separators();
        let joined = self.joined.take();
        let separation = std::mem::take(&mut self.separation);
        self.bounded_clause()?;
        let chain = self.chain()?;
        if let Some(range) = self.range(&chain)? {
            return match clauses.last_mut() {
                Some(clause) => {
                    clause.ranges.push(range);
                    Ok(())
                }
                None => {
                    let kind = DiagnosticKind::Unexpected {
                        found: "the range of an index".to_owned(),
                        expected: "an equation before it".to_owned(),
                    };
                    Err(self.error(kind, chain.span))
                }
            };
        }
        self.number_goes_on()?;
        let remark = self.remark(!chain.relations.is_empty())?;
        if !self.at_close()
            && !self.peek().is_some_and(Self::is_separator)
            && !matches!(self.peek(), Some(Token::Begin(_)))
        {
            return Err(self.unexpected("an operator, a relation or the end of the equation"));
        }
        clauses.push(Clause {
            heading,
            joined,
            separation,
            bracketed: self.bracketed,
            chain,
            ranges: Vec::new(),
            remark,
        });
        Ok(())
    }

    /// Refuses what nobody printed as one equation before it takes room as a tree.
    fn bounded_clause(&self) -> Parse<()> {
        let start = self.position;
        let mut end = start;
        while let Some(lexeme) = self.lexemes.get(end) {
            match &lexeme.token {
                Token::Open(_) | Token::Begin(_) => end = self.partner[end],
                Token::Close(_) | Token::End(_) => break,
                token if Self::is_separator(token) => break,
                _ => {}
            }
            end += 1;
        }
        let size = end - start;
        if size <= LONGEST_CLAUSE {
            return Ok(());
        }
        let kind = DiagnosticKind::TooLong {
            what: "an equation",
            size,
            limit: LONGEST_CLAUSE,
        };
        Err(self.error(kind, self.lexemes[start].span))
    }

    /// Refuses a comma between digits, and a full stop before something, that no blank follows:
    /// `1,234x` and `5.x` may be one number.
    fn number_goes_on(&self) -> Parse<()> {
        let (Some(Token::Symbol(mark @ (',' | '.'))), Some(before), Some(after)) = (
            self.peek(),
            self.position.checked_sub(1).map(|p| &self.lexemes[p]),
            self.lexemes.get(self.position + 1),
        ) else {
            return Ok(());
        };
        let tight = !self.lexemes[self.position].spaced && !after.spaced && !after.gap;
        let span = before.span.to(after.span);
        match (&before.token, &after.token, mark) {
            (Token::Number(_), Token::Number(_), ',') if tight => {
                let readings = [
                    "one number, written 1234 or 1.234",
                    "two, written with a blank after the comma",
                ];
                Err(self.ambiguous(readings, span))
            }
            (_, Token::Letter(_) | Token::Number(_) | Token::Command(_), '.') if tight => {
                let readings = ["a decimal point", "the end of the equation"];
                Err(self.ambiguous(readings, span))
            }
            _ => Ok(()),
        }
    }

    /// `\text{I:}`, `\text{I}:` or `(I) \quad`.
    fn heading(&mut self) -> Option<String> {
        if let Some(Token::Text(word)) = self.peek() {
            let word = word.trim().to_owned();
            if vocabulary::restricts(&word) {
                return None;
            }
            if let Some(heading) = word.strip_suffix(':') {
                self.position += 1;
                return Some(heading.trim().to_owned());
            }
            if self.peek_at(1) == Some(&Token::Symbol(':')) {
                self.position += 2;
                return Some(word);
            }
            return None;
        }
        let Some(Token::Open(Delimiter::Visible(Bracket::Round))) = self.peek() else {
            return None;
        };
        let close = self.partner[self.position];
        if !matches!(
            self.lexemes.get(close + 1).map(|l| &l.token),
            Some(Token::Space(_))
        ) {
            return None;
        }
        let mut heading = String::new();
        for lexeme in &self.lexemes[self.position + 1..close] {
            match &lexeme.token {
                Token::Letter(c @ ('I' | 'V' | 'X' | 'i' | 'v' | 'x')) => heading.push(*c),
                Token::Text(word) => heading += word.trim(),
                _ => return None,
            }
        }
        if heading.is_empty() {
            return None;
        }
        self.position = close + 1;
        Some(heading)
    }

    /// Words after the equation that tell where it comes from. What else they say may be a condition, unless
    /// there is nothing that could hold under one.
    fn remark(&mut self, related: bool) -> Parse<Option<String>> {
        let start = self.here();
        let mut words: Vec<String> = Vec::new();
        while let Some(Token::Text(word)) = self.peek()
            && self.is_remark(word)
        {
            words.push(word.trim().to_owned());
            self.position += 1;
        }
        let words = words.join(" ");
        if words.is_empty() {
            return Ok(None);
        }
        if related && !vocabulary::is_justification(&words) {
            let readings = [
                "a remark, which can be left out of the display",
                "a condition, written with a relation as in `\\text{ for } x > 0`",
            ];
            return Err(self.ambiguous(readings, self.since(start)));
        }
        Ok(Some(words))
    }

    /// `m = 0(1)6`, or `m = 0, 1, \ldots, 6`, of which the first value is read.
    fn range(&mut self, chain: &Chain) -> Parse<Option<IndexRange>> {
        let ([left, right], [Relation::Equal]) =
            (chain.members.as_slice(), chain.relations.as_slice())
        else {
            return Ok(None);
        };
        let ExprKind::Name(index) = &left.kind else {
            return Ok(None);
        };
        if let ExprKind::Product(factors) = &right.kind
            && let [from, step, rest @ ..] = factors.as_slice()
            && let [first, .., last] | [first @ last] = rest
            && let ExprKind::Number(_) = &from.kind
            && let ExprKind::Group {
                bracket: Bracket::Round,
                inner,
            } = &step.kind
            && let ExprKind::Number(_) = &inner.kind
        {
            return Ok(Some(IndexRange {
                index: index.clone(),
                from: from.clone(),
                step: (**inner).clone(),
                to: super::product(rest.to_vec(), first.span.to(last.span)),
            }));
        }
        self.dotted_range(index, right)
    }

    /// The rest of `m = 0, 1, \ldots, 6`.
    fn dotted_range(&mut self, index: &Name, from: &Expr) -> Parse<Option<IndexRange>> {
        let dots = |token: Option<&Token>| matches!(token, Some(Token::Command(c)) if matches!(c.as_str(), "ldots" | "dots" | "cdots"));
        let comma = Token::Symbol(',');
        if !self.at(&comma) {
            return Ok(None);
        }
        let start = self.position;
        let mut step = Expr::new(ExprKind::Number(BigRational::one()), self.here());
        if dots(self.peek_at(1)) {
            self.position += 2;
        } else if matches!(self.peek_at(1), Some(Token::Number(_)))
            && self.peek_at(2) == Some(&comma)
            && dots(self.peek_at(3))
        {
            self.position += 1;
            let second = self.number()?;
            if let (ExprKind::Number(a), ExprKind::Number(b)) = (&from.kind, &second.kind)
                && a < b
            {
                step = Expr::new(ExprKind::Number(b - a), second.span);
            }
            self.position += 2;
        } else {
            return Ok(None);
        }
        if !self.accept_symbol(',') {
            self.position = start;
            return Ok(None);
        }
        let to = self.expression()?;
        Ok(Some(IndexRange {
            index: index.clone(),
            from: from.clone(),
            step,
            to,
        }))
    }
}

/// What separates clauses once this mark was read too.
fn separated(before: Separation, mark: &Token) -> Separation {
    match (mark, before) {
        (Token::Symbol('.'), _) => Separation::FullStop,
        (Token::Symbol(';'), _) => Separation::Semicolon,
        (Token::Symbol(','), _) => Separation::Comma,
        (Token::RowBreak, Separation::None | Separation::Space) => Separation::Line,
        (Token::RowBreak, Separation::Comma) => Separation::CommaAndLine,
        (Token::Space(_), Separation::None) => Separation::Space,
        (_, before) => before,
    }
}
