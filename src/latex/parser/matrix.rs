//! Matrices and cases.

use super::{Parse, Parser};
use crate::diagnostic::DiagnosticKind;
use crate::expr::{Bracket, Chain, Expr, ExprKind, Function};
use crate::latex::lexer::Token;
use crate::latex::vocabulary::{self, Environment};

impl Parser<'_> {
    /// `\begin{...} ... \end{...}` as an operand.
    pub(super) fn environment(&mut self) -> Parse<Expr> {
        let start = self.here();
        let Some(Token::Begin(environment)) = self.peek() else {
            return Err(self.unexpected("\\begin"));
        };
        let environment = *environment;
        let end = self.partner[self.position];
        self.position += 1;
        let kind = self.nested(|parser| {
            parser.inside(|parser| match environment {
                Environment::Lines | Environment::Array => {
                    // One expression broken over several lines.
                    let inner = Box::new(parser.expression()?);
                    parser.close(end)?;
                    let bracket = Bracket::None;
                    Ok(ExprKind::Group { bracket, inner })
                }
                Environment::Matrix(bracket) => {
                    let rows = parser.rows(end)?;
                    Ok(ExprKind::Matrix { rows, bracket })
                }
                Environment::Determinant => {
                    let rows = parser.rows(end)?;
                    let bracket = Bracket::Bar;
                    let matrix = ExprKind::Matrix { rows, bracket };
                    Ok(ExprKind::Call {
                        function: Function::Determinant,
                        argument: Box::new(Expr::new(matrix, start)),
                    })
                }
                Environment::Cases => Ok(ExprKind::Cases(parser.cases(end)?)),
            })
        })?;
        let span = self.since(start);
        Ok(match kind {
            ExprKind::Group {
                bracket: Bracket::None,
                inner,
            } if !matches!(inner.kind, ExprKind::Sum(_)) => *inner,
            kind => Expr::new(kind, span),
        })
    }

    /// The rows up to the end of the environment, all of the same length. A bad entry is
    /// reported and the next one read.
    fn rows(&mut self, end: usize) -> Parse<Vec<Vec<Expr>>> {
        let mut rows: Vec<Vec<Expr>> = Vec::new();
        let mut row = Vec::new();
        let mut row_start = self.here();
        let mut complete = true;
        while self.position < end || !row.is_empty() {
            match self.expression() {
                Ok(entry) => row.push(entry),
                Err(diagnostic) => {
                    let fatal = matches!(diagnostic.kind, DiagnosticKind::TooDeep { .. });
                    if fatal {
                        return Err(diagnostic);
                    }
                    self.diagnostics.push(*diagnostic);
                    complete = false;
                    self.skip_entry(end);
                }
            }
            match self.peek() {
                Some(Token::Symbol('&')) => {
                    self.position += 1;
                    continue;
                }
                Some(Token::RowBreak) => self.position += 1,
                _ if self.position == end => {}
                _ => {
                    let diagnostic = self.unexpected("&, \\\\ or the end of the matrix");
                    self.diagnostics.push(*diagnostic);
                    complete = false;
                    self.skip_entry(end);
                    if self.position < end {
                        self.position += 1;
                        if !matches!(self.lexemes[self.position - 1].token, Token::RowBreak) {
                            continue;
                        }
                    }
                }
            }
            let found = std::mem::take(&mut row);
            if let Some(first) = rows.first()
                && first.len() != found.len()
                && complete
            {
                let kind = DiagnosticKind::ShapeMismatch {
                    operation: "the rows of a matrix".to_owned(),
                    left: format!("{} entries", first.len()),
                    right: format!("{} entries", found.len()),
                };
                let diagnostic = self.error(kind, self.since(row_start));
                self.diagnostics.push(*diagnostic);
            }
            rows.push(found);
            row_start = self.here();
            if self.position >= end {
                break;
            }
        }
        if rows.is_empty() {
            return Err(self.unexpected("an entry"));
        }
        self.close(end)?;
        Ok(rows)
    }

    /// Goes to the next `&`, `\\` or end of this environment.
    fn skip_entry(&mut self, end: usize) {
        while self.position < end {
            match self.lexemes[self.position].token {
                Token::Symbol('&') | Token::RowBreak => return,
                Token::Open(_) | Token::Begin(_) => {
                    self.position = self.partner[self.position] + 1;
                }
                _ => self.position += 1,
            }
        }
        self.position = end;
    }

    /// Values with their conditions; a row of words alone ("for") is passed over.
    /// The rows of cases: each value with the conditions under which it is meant, all of them; the last one
    /// perhaps otherwise. Of conditions joined by "or" each has a row of its own.
    fn cases(&mut self, end: usize) -> Parse<Vec<(Expr, Vec<Chain>)>> {
        let mut cases: Vec<(Expr, Vec<Chain>)> = Vec::new();
        while self.position < end {
            if self.words_only(end) {
                continue;
            }
            if cases
                .last()
                .is_some_and(|(_, conditions)| conditions.is_empty())
            {
                return Err(self.unexpected("no case behind the one that is meant otherwise"));
            }
            let value = self.expression()?;
            self.accept_punctuation();
            for conditions in self.conditions(end)? {
                cases.push((value.clone(), conditions));
            }
            if self.position < end && !self.at(&Token::RowBreak) {
                return Err(self.unexpected("&, \\\\ or the end of the cases"));
            }
            while self.at(&Token::RowBreak) {
                self.position += 1;
            }
        }
        if cases.is_empty() {
            return Err(self.unexpected("a case"));
        }
        self.close(end)?;
        Ok(cases)
    }

    /// The conditions of one case, in alternatives; one without any is meant otherwise.
    fn conditions(&mut self, end: usize) -> Parse<Vec<Vec<Chain>>> {
        let mut alternatives = vec![Vec::new()];
        let (mut otherwise, mut joined, mut listed) = (false, false, false);
        while self.accept_symbol('&') {
            otherwise |= self.case_words();
            while self.position < end
                && !matches!(self.peek(), Some(Token::RowBreak | Token::Symbol('&')))
            {
                let start = self.here();
                if otherwise {
                    return Err(self.unexpected("no condition beside the word for all other cases"));
                }
                let chain = self.chain()?;
                if chain.relations.is_empty() {
                    let kind = DiagnosticKind::Unexpected {
                        found: "an expression".to_owned(),
                        expected: "a condition such as `x > 0`, or \\text{otherwise}".to_owned(),
                    };
                    return Err(self.error(kind, self.since(start)));
                }
                if let Some(conditions) = alternatives.last_mut() {
                    listed |= !conditions.is_empty();
                    conditions.push(chain);
                }
                self.accept_punctuation();
                if matches!(self.peek(), Some(Token::Text(word)) if word.trim() == "or") {
                    joined = true;
                    self.position += 1;
                    alternatives.push(Vec::new());
                }
                if joined && listed {
                    let readings = ["(A and B) or C", "A and (B or C)"];
                    return Err(self.ambiguous(readings, self.since(start)));
                }
                otherwise |= self.case_words();
            }
        }
        let empty = alternatives.iter().any(Vec::is_empty);
        if empty && !(otherwise && alternatives.len() == 1) {
            return Err(self.unexpected("a condition such as `x > 0`, or \\text{otherwise}"));
        }
        if otherwise && !empty {
            return Err(self.unexpected("no condition beside the word for all other cases"));
        }
        Ok(alternatives)
    }

    fn accept_punctuation(&mut self) {
        while matches!(self.peek(), Some(Token::Symbol(',' | ';' | '.'))) {
            self.position += 1;
        }
    }

    /// Passes over "for", "if", "and"; whether the words say "otherwise".
    fn case_words(&mut self) -> bool {
        let mut otherwise = false;
        while let Some(Token::Text(word)) = self.peek()
            && word.trim() != "or"
            && (vocabulary::is_conjunction(word) || vocabulary::is_otherwise(word))
        {
            otherwise |= vocabulary::is_otherwise(word);
            self.position += 1;
            self.accept_punctuation();
        }
        otherwise
    }

    /// Passes over a row that holds words and no formula.
    fn words_only(&mut self, end: usize) -> bool {
        let start = self.position;
        if self.case_words() || self.position == start {
            self.position = start;
            return false;
        }
        while self.position < end && self.at_symbol('&') {
            self.position += 1;
        }
        if self.position == end || self.at(&Token::RowBreak) {
            self.position += usize::from(self.position < end);
            return true;
        }
        self.position = start;
        false
    }
}
