//! What `&`, `\\` and spaces become inside each kind of bracket and environment.

use super::kind::{ends_operand, is_operator, is_punctuation, is_relation, starts_operand};
use crate::diagnostic::{Diagnostic, DiagnosticKind};
use crate::expr::Bracket;
use crate::latex::lexer::{Delimiter, Lexeme, Token};
use crate::latex::vocabulary::Environment;

/// The lexemes that remain, and what is ambiguous about them.
pub(super) fn resolve(input: &[Lexeme], partner: &[usize]) -> (Vec<Lexeme>, Vec<Diagnostic>) {
    let mut resolver = Resolver {
        input,
        partner,
        next: next_printed(input),
        output: Vec::with_capacity(input.len()),
        containers: vec![Container::new(Inside::Lines)],
        diagnostics: Vec::new(),
    };
    resolver.run();
    (resolver.output, resolver.diagnostics)
}

/// For every lexeme the position of the next one that is neither space nor alignment.
fn next_printed(lexemes: &[Lexeme]) -> Vec<usize> {
    let mut next = vec![lexemes.len(); lexemes.len()];
    let mut nearest = lexemes.len();
    for (position, lexeme) in lexemes.iter().enumerate().rev() {
        next[position] = nearest;
        if !matches!(lexeme.token, Token::Space(_) | Token::Symbol('&')) {
            nearest = position;
        }
    }
    next
}

/// What the innermost delimiter or environment makes of lines, columns and spaces.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Inside {
    /// Equations line by line; also the display itself.
    Lines,
    /// Equations in an `array`: every `&` is alignment.
    Array,
    /// Entries.
    Entries,
    /// A pair of square brackets, perhaps a row.
    Square,
    /// Any other pair of delimiters.
    Bracket,
}

struct Container {
    inside: Inside,
    /// How many `&` this line had.
    columns: usize,
    /// Positions in the output of the columns of a possible row: those between two operands,
    /// and those before a minus sign.
    certain: usize,
    signed: Vec<usize>,
    /// Where one of those between two operands is a narrow space.
    narrow: Option<usize>,
    /// What a closing `\end` must become.
    environment: Option<Environment>,
}

impl Container {
    fn new(inside: Inside) -> Self {
        Container {
            inside,
            columns: 0,
            certain: 0,
            signed: Vec::new(),
            narrow: None,
            environment: None,
        }
    }
}

struct Resolver<'a> {
    input: &'a [Lexeme],
    partner: &'a [usize],
    /// For every lexeme the position of the next one that is neither space nor alignment.
    next: Vec<usize>,
    output: Vec<Lexeme>,
    containers: Vec<Container>,
    diagnostics: Vec<Diagnostic>,
}

impl Resolver<'_> {
    fn run(&mut self) {
        for position in 0..self.input.len() {
            let lexeme = self.input[position].clone();
            match lexeme.token {
                Token::Open(delimiter) => {
                    let inside = match delimiter {
                        Delimiter::Visible(Bracket::Square)
                        | Delimiter::Stretched(Bracket::Square) => Inside::Square,
                        // `\left. ... \right\}` around lines holds equations, not a product.
                        Delimiter::Stretched(Bracket::None) => self.top().inside,
                        _ => Inside::Bracket,
                    };
                    self.containers.push(Container::new(inside));
                    self.output.push(lexeme);
                }
                Token::Begin(environment) => {
                    let environment = self.resolve_array(position, environment);
                    let inside = match environment {
                        Environment::Lines => Inside::Lines,
                        Environment::Array => Inside::Array,
                        _ => Inside::Entries,
                    };
                    let mut container = Container::new(inside);
                    container.environment = Some(match environment {
                        Environment::Array => Environment::Lines,
                        other => other,
                    });
                    self.output.push(Lexeme {
                        token: Token::Begin(container.environment.unwrap_or(environment)),
                        ..lexeme
                    });
                    self.containers.push(container);
                }
                Token::Close(_) => {
                    self.leave();
                    self.output.push(lexeme);
                }
                Token::End(environment) => {
                    let environment = self.leave().unwrap_or(environment);
                    self.output.push(Lexeme {
                        token: Token::End(environment),
                        ..lexeme
                    });
                }
                Token::Symbol('&') => self.ampersand(position, lexeme),
                Token::RowBreak => self.row_break(position, lexeme),
                Token::Space(wide) => self.space(position, wide, lexeme),
                _ => self.output.push(lexeme),
            }
        }
    }

    fn top(&mut self) -> &mut Container {
        if self.containers.is_empty() {
            self.containers.push(Container::new(Inside::Lines));
        }
        let last = self.containers.len() - 1;
        &mut self.containers[last]
    }

    /// Ends a container; a bracket whose only columns stand before a minus sign is ambiguous.
    fn leave(&mut self) -> Option<Environment> {
        let container = self.containers.pop()?;
        if container.certain == 0
            && let Some(&first) = container.signed.first()
        {
            let readings = vec![
                "a row whose entry is negative".to_owned(),
                "a difference".to_owned(),
            ];
            self.diagnostics.push(Diagnostic::new(
                DiagnosticKind::Ambiguous { readings },
                self.output[first].span,
            ));
        }
        if container.certain == 1
            && container.signed.is_empty()
            && let Some(only) = container.narrow
        {
            let readings = vec![
                "a row of two entries, written with &".to_owned(),
                "a product, written without the space".to_owned(),
            ];
            self.diagnostics.push(Diagnostic::new(
                DiagnosticKind::Ambiguous { readings },
                self.output[only].span,
            ));
        }
        container.environment
    }

    /// The innermost environment, seen through brackets.
    fn enclosing(&self) -> Inside {
        self.containers
            .iter()
            .rev()
            .map(|container| container.inside)
            .find(|inside| !matches!(inside, Inside::Square | Inside::Bracket))
            .unwrap_or(Inside::Lines)
    }

    /// What an `array` holds: equations if its first cell has a relation, or if any cell has one
    /// and no left brace makes it a choice by cases; entries otherwise.
    fn resolve_array(&self, begin: usize, environment: Environment) -> Environment {
        if environment != Environment::Array {
            return environment;
        }
        let end = self.partner[begin];
        let mut position = begin + 1;
        let (mut related, mut first_related, mut columns) = (false, false, 0usize);
        while position < end {
            let token = &self.input[position].token;
            match token {
                Token::Open(_) | Token::Begin(_) => position = self.partner[position],
                Token::Symbol('&') => columns += 1,
                _ if is_relation(token) => {
                    related = true;
                    first_related |= columns == 0;
                }
                _ => {}
            }
            position += 1;
        }
        let braced = begin > 0
            && self.input[begin - 1].token == Token::Open(Delimiter::Stretched(Bracket::Curly))
            && self.input.get(end + 1).is_some_and(|lexeme| {
                lexeme.token == Token::Close(Delimiter::Stretched(Bracket::None))
            });
        if related && (first_related || !braced) {
            Environment::Array
        } else if braced {
            Environment::Cases
        } else {
            Environment::Matrix(Bracket::None)
        }
    }

    fn ampersand(&mut self, position: usize, lexeme: Lexeme) {
        let at_display = self.containers.len() == 1;
        let enclosing = self.enclosing();
        let between = self.between_columns(position);
        let container = self.top();
        let separator = Lexeme {
            token: Token::Symbol(';'),
            ..lexeme.clone()
        };
        match container.inside {
            Inside::Entries => self.output.push(lexeme),
            Inside::Lines if at_display => self.output.push(lexeme),
            Inside::Lines | Inside::Array => {
                let lines = container.inside == Inside::Lines;
                container.columns += usize::from(lines);
                // Columns come in pairs: right-aligned, left-aligned. Every second `&` stands
                // between two equations.
                if lines && container.columns.is_multiple_of(2) || between == Some(true) {
                    self.output.push(separator);
                } else if between == Some(false) {
                    let readings = vec!["two columns".to_owned(), "a product".to_owned()];
                    self.diagnostics.push(Diagnostic::new(
                        DiagnosticKind::Ambiguous { readings },
                        lexeme.span,
                    ));
                }
            }
            Inside::Square | Inside::Bracket => {
                if enclosing == Inside::Entries {
                    self.output.push(lexeme);
                }
            }
        }
    }

    /// Whether a column between two operands stands between two equations; none where it stands elsewhere.
    fn between_columns(&self, position: usize) -> Option<bool> {
        let blank = |token: &Token| matches!(token, Token::Space(_));
        let before = self.input[..position].iter().rev();
        let previous = before.map(|l| &l.token).find(|token| !blank(token))?;
        let next = self.following(position)?;
        let signed = matches!(next, Token::Symbol('-' | '+'));
        let starts = starts_operand(next) || signed;
        if !ends_operand(previous) || !starts || matches!(next, Token::Text(_)) {
            return None;
        }
        let (before, after) = (
            self.is_related(position, false),
            self.is_related(position, true),
        );
        if signed {
            // A sum may go on in the next column; two equations are asked about.
            return (before && after).then_some(false);
        }
        // A long product may go on in the next column with its bracket.
        let goes_on = before && !after && matches!(next, Token::Open(_));
        (!goes_on).then_some(before && after)
    }

    /// Whether a relation stands between a place and the next end of its column, forwards or backwards, outside of
    /// brackets.
    fn is_related(&self, position: usize, forwards: bool) -> bool {
        let mut at = position;
        loop {
            let next = match forwards {
                true => at.checked_add(1),
                false => at.checked_sub(1),
            };
            let Some(token) = next.and_then(|n| Some(&self.input.get(n)?.token)) else {
                return false;
            };
            at = next.unwrap_or_default();
            match token {
                Token::RowBreak | Token::Symbol(',' | ';') => return false,
                Token::Symbol('&') if forwards => {
                    // A relation may stand right behind the alignment.
                    return self.following(at).is_some_and(is_relation);
                }
                Token::Open(_) | Token::Begin(_) if forwards => at = self.partner[at],
                Token::Close(_) | Token::End(_) if !forwards => at = self.partner[at],
                Token::Open(_) | Token::Begin(_) | Token::Close(_) | Token::End(_) => return false,
                token if is_relation(token) => return true,
                _ => {}
            }
        }
    }

    /// Whether the line that begins with a sign behind this break is an equation of its own: its relation is
    /// aligned, or both lines begin with the alignment. Where nothing says so and it has a relation it is asked about,
    /// unless it stands behind the alignment of the line before, which it goes on with.
    fn begins_with_a_sign(&mut self, position: usize) -> bool {
        let sign = self.next[position];
        let alignment = |l: &Lexeme| l.token == Token::Symbol('&');
        let behind = self.input[position + 1..sign].iter().any(alignment);
        if !matches!(
            self.input.get(sign).map(|l| &l.token),
            Some(Token::Symbol('-' | '+'))
        ) {
            return false;
        }
        let Some(aligned) = self.relation_of_row(sign) else {
            return false;
        };
        if behind && !aligned {
            return self.row_begins_with_alignment(position);
        }
        if behind || !aligned {
            let readings = vec![
                "an equation of its own, with a comma before it".to_owned(),
                "what the line before goes on with, with & before the sign".to_owned(),
            ];
            self.diagnostics.push(Diagnostic::new(
                DiagnosticKind::Ambiguous { readings },
                self.input[sign].span,
            ));
        }
        true
    }

    /// Whether the first relation from a place to the end of its row stands right behind an alignment; none where
    /// there is no relation.
    fn relation_of_row(&self, from: usize) -> Option<bool> {
        let mut at = from + 1;
        while let Some(lexeme) = self.input.get(at) {
            match &lexeme.token {
                Token::Open(_) | Token::Begin(_) => at = self.partner[at],
                Token::RowBreak | Token::Close(_) | Token::End(_) => return None,
                token if is_relation(token) => {
                    let mut before = self.input[from..at].iter().rev();
                    let previous = before.find(|l| !matches!(l.token, Token::Space(_)));
                    return Some(previous.is_some_and(|l| l.token == Token::Symbol('&')));
                }
                _ => {}
            }
            at += 1;
        }
        None
    }

    /// Whether the row before a break begins with an alignment.
    fn row_begins_with_alignment(&self, position: usize) -> bool {
        let mut at = position;
        let mut first = None;
        while let Some(before) = at.checked_sub(1) {
            match &self.input[before].token {
                Token::Close(_) | Token::End(_) => {
                    at = self.partner[before];
                    first = Some(at);
                    continue;
                }
                Token::RowBreak | Token::Open(_) | Token::Begin(_) => break,
                Token::Space(_) => {}
                _ => first = Some(before),
            }
            at = before;
        }
        first.is_some_and(|first| self.input[first].token == Token::Symbol('&'))
    }

    /// The next lexeme that is neither space nor alignment.
    fn following(&self, position: usize) -> Option<&Token> {
        Some(&self.input.get(self.next[position])?.token)
    }

    fn row_break(&mut self, position: usize, lexeme: Lexeme) {
        let enclosing = self.enclosing();
        let container = self.top();
        container.columns = 0;
        match container.inside {
            Inside::Entries => self.output.push(lexeme),
            Inside::Square | Inside::Bracket => {
                if enclosing == Inside::Entries {
                    self.output.push(lexeme);
                }
            }
            Inside::Lines | Inside::Array => {
                let next = self.following(position);
                let previous = self.output.last().map(|lexeme| &lexeme.token);
                let continues = match (previous, next) {
                    (None, _) | (_, None) => true,
                    (Some(previous), Some(next)) => {
                        is_relation(next)
                            || is_relation(previous)
                            || is_operator(previous)
                            || is_operator(next)
                                && !is_punctuation(previous)
                                && !matches!(previous, Token::Tag(_))
                    }
                };
                let own = continues
                    && previous.is_some_and(ends_operand)
                    && self.begins_with_a_sign(position);
                if !continues || own {
                    self.output.push(lexeme);
                }
            }
        }
    }

    fn space(&mut self, position: usize, wide: bool, lexeme: Lexeme) {
        let ended = self
            .output
            .last()
            .is_some_and(|lexeme| ends_operand(&lexeme.token));
        let next = self.following(position);
        let starts = next.is_some_and(starts_operand);
        let several = matches!(
            self.input.get(position + 1).map(|l| &l.token),
            Some(Token::Space(_))
        );
        let signed = matches!(next, Some(Token::Symbol('-' | '+')));
        let negative = next == Some(&Token::Symbol('-')) && {
            self.input
                .get(self.next[position] + 1)
                .is_some_and(|after| starts_operand(&after.token))
        };
        let doubtful = (wide || several)
            && ended
            && signed
            && self.is_related(self.next[position], true)
            && self.is_related(position, false);
        // Words, and what a column or a relation parts, are no factors.
        let parted = self.input[position..self.next[position]]
            .iter()
            .any(|l| l.token == Token::Symbol('&'))
            || matches!(next, Some(Token::Text(_)))
            || self.is_related(position, true)
            || self.is_related(position, false);
        let here = self.output.len();
        let container = self.top();
        match container.inside {
            Inside::Lines | Inside::Array if wide && ended && starts => self.output.push(lexeme),
            Inside::Bracket | Inside::Entries
                if wide && ended && (starts || negative) && !parted =>
            {
                let readings = vec![
                    "a row, written as a matrix with &".to_owned(),
                    "a product, written without the space".to_owned(),
                ];
                self.diagnostics.push(Diagnostic::new(
                    DiagnosticKind::Ambiguous { readings },
                    self.input[self.next[position]].span,
                ));
            }
            Inside::Lines | Inside::Array if doubtful => {
                let readings = vec![
                    "an equation of its own, with a comma before it".to_owned(),
                    "a difference".to_owned(),
                ];
                self.diagnostics.push(Diagnostic::new(
                    DiagnosticKind::Ambiguous { readings },
                    self.input[self.next[position]].span,
                ));
            }
            Inside::Square if ended && (starts || negative) => {
                if starts {
                    container.certain += 1;
                    if !wide {
                        container.narrow = Some(here);
                    }
                } else {
                    container.signed.push(here);
                }
                self.output.push(Lexeme {
                    token: Token::Column,
                    ..lexeme
                });
            }
            _ => {}
        }
    }
}
