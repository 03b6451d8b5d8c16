//! What lines, columns and spaces mean, settled before the grammar.
//!
//! Delimiters are paired (a lone one is reported at its place, nesting is limited), brackets
//! that were closed and reopened only to break a line are joined, `&` and `\\` of aligned
//! equations become the end of an equation or nothing, spaces in `[0 \ 0 \ 1]` become columns,
//! and the equation number at the end is taken off. After this stage every `&` and `\\` inside a
//! matrix separates entries, and everywhere else `\\`, `;` and wide spaces separate equations.

use super::lexer::{self, Delimiter, Lexeme, Token};
use super::vocabulary::{self, Environment};
use crate::diagnostic::{Diagnostic, DiagnosticKind};
use crate::expr::Bracket;
use crate::span::Span;

/// How deep brackets, braces and environments may be nested.
pub const DEPTH_LIMIT: usize = 200;

/// Lexemes ready for the grammar.
pub(super) struct Layout {
    pub lexemes: Vec<Lexeme>,
    /// For every delimiter the position of the other one of its pair; itself for other lexemes.
    pub partner: Vec<usize>,
    /// The equation number.
    pub tag: Option<String>,
    /// The place just after the text.
    pub end: Span,
}

/// Lexes and lays out a text; `display` says whether it may carry an equation number.
pub(super) fn prepare(text: &str, offset: usize, display: bool) -> Result<Layout, Vec<Diagnostic>> {
    let (lexemes, mut diagnostics) = lexer::lex(text, offset);
    let lexemes = join_broken_lines(lexemes);
    let partner = match pair(&lexemes) {
        Ok(partner) => partner,
        Err(unpaired) => {
            diagnostics.extend(unpaired);
            diagnostics.sort_by_key(|d| d.span);
            return Err(diagnostics);
        }
    };
    let mut resolver = Resolver {
        input: &lexemes,
        partner: &partner,
        next: next_printed(&lexemes),
        output: Vec::new(),
        containers: vec![Container::new(Inside::Lines)],
        diagnostics,
    };
    resolver.run();
    let mut output = resolver.output;
    let mut diagnostics = resolver.diagnostics;
    let tag = if display {
        take_tag(&mut output, &mut diagnostics)
    } else {
        None
    };
    if !diagnostics.is_empty() {
        diagnostics.sort_by_key(|d| d.span);
        return Err(diagnostics);
    }
    let partner = pair(&output)?;
    let end = offset + text.trim_end().len();
    Ok(Layout {
        lexemes: output,
        partner,
        tag,
        end: Span::new(end, end),
    })
}

/// Removes every `\right.` that is followed, after a line break, by `\left.`: TeX cannot break a
/// line inside `\left ... \right`, so authors close and reopen with invisible delimiters.
fn join_broken_lines(lexemes: Vec<Lexeme>) -> Vec<Lexeme> {
    let null = Delimiter::Stretched(Bracket::None);
    let mut joined: Vec<Lexeme> = Vec::with_capacity(lexemes.len());
    let mut lexemes = lexemes.into_iter().peekable();
    while let Some(lexeme) = lexemes.next() {
        if lexeme.token != Token::Close(null) {
            joined.push(lexeme);
            continue;
        }
        let mut between = Vec::new();
        while let Some(next) = lexemes.next_if(|next| {
            matches!(
                next.token,
                Token::RowBreak | Token::Symbol('&') | Token::Space(_)
            )
        }) {
            between.push(next);
        }
        let broken = between.iter().any(|l| l.token == Token::RowBreak);
        if broken && lexemes.peek().is_some_and(|l| l.token == Token::Open(null)) {
            lexemes.next();
        } else {
            joined.push(lexeme);
            joined.extend(between);
        }
    }
    joined
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

/// Whether a closing token fits an opening one.
fn fits(open: &Token, close: &Token) -> bool {
    match (open, close) {
        (Token::Open(Delimiter::Stretched(a)), Token::Close(Delimiter::Stretched(b))) => {
            a == b || *a == Bracket::None || *b == Bracket::None
        }
        (Token::Open(a), Token::Close(b)) => a == b,
        (Token::Begin(a), Token::End(b)) => a == b,
        _ => false,
    }
}

/// Whether TeX itself insists on the pair; `(` and `[` are only ink to it.
fn is_strong(token: &Token) -> bool {
    !matches!(
        token,
        Token::Open(Delimiter::Visible(_)) | Token::Close(Delimiter::Visible(_))
    )
}

/// The partner of every delimiter, or all lone delimiters.
fn pair(lexemes: &[Lexeme]) -> Result<Vec<usize>, Vec<Diagnostic>> {
    let mut partner: Vec<usize> = (0..lexemes.len()).collect();
    let mut open: Vec<usize> = Vec::new();
    let mut lone: Vec<usize> = Vec::new();
    for (position, lexeme) in lexemes.iter().enumerate() {
        match &lexeme.token {
            Token::Open(_) | Token::Begin(_) => {
                open.push(position);
                if open.len() > DEPTH_LIMIT {
                    let kind = DiagnosticKind::TooDeep { limit: DEPTH_LIMIT };
                    return Err(vec![Diagnostic::new(kind, lexeme.span)]);
                }
            }
            close @ (Token::Close(_) | Token::End(_)) => {
                // The nearest opener that fits, not looking past a stronger one.
                let mut found = None;
                for (height, &opener) in open.iter().enumerate().rev() {
                    let token = &lexemes[opener].token;
                    if fits(token, close) {
                        found = Some(height);
                        break;
                    }
                    if is_strong(token) {
                        break;
                    }
                }
                if let Some(height) = found {
                    lone.extend(open.drain(height + 1..));
                    let opener = open.remove(height);
                    partner[opener] = position;
                    partner[position] = opener;
                } else {
                    lone.push(position);
                }
            }
            _ => {}
        }
    }
    lone.extend(open);
    if lone.is_empty() {
        return Ok(partner);
    }
    lone.sort_unstable();
    Err(lone
        .into_iter()
        .map(|position| {
            let lexeme = &lexemes[position];
            let delimiter = lexeme.token.spelling();
            Diagnostic::new(DiagnosticKind::Unbalanced { delimiter }, lexeme.span)
        })
        .collect())
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
                Token::Symbol('&') => self.ampersand(lexeme),
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

    fn ampersand(&mut self, lexeme: Lexeme) {
        let at_display = self.containers.len() == 1;
        let enclosing = self.enclosing();
        let container = self.top();
        match container.inside {
            Inside::Entries => self.output.push(lexeme),
            Inside::Array => {}
            Inside::Lines if at_display => self.output.push(lexeme),
            Inside::Lines => {
                container.columns += 1;
                // Columns come in pairs: right-aligned, left-aligned. Every second `&` stands
                // between two equations.
                if container.columns.is_multiple_of(2) {
                    self.output.push(Lexeme {
                        token: Token::Symbol(';'),
                        ..lexeme
                    });
                }
            }
            Inside::Square | Inside::Bracket => {
                if enclosing == Inside::Entries {
                    self.output.push(lexeme);
                }
            }
        }
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
                            || is_operator(next) && !is_punctuation(previous)
                    }
                };
                if !continues {
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
        let negative = next == Some(&Token::Symbol('-')) && {
            self.input
                .get(self.next[position] + 1)
                .is_some_and(|after| starts_operand(&after.token))
        };
        let here = self.output.len();
        let container = self.top();
        match container.inside {
            Inside::Lines | Inside::Array if wide && ended && starts => self.output.push(lexeme),
            Inside::Square if ended && (starts || negative) => {
                if starts {
                    container.certain += 1;
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

pub(super) fn is_relation(token: &Token) -> bool {
    match token {
        Token::Symbol(c) => matches!(c, '=' | '<' | '>'),
        Token::Command(command) => vocabulary::relation(command).is_some(),
        _ => false,
    }
}

fn is_operator(token: &Token) -> bool {
    match token {
        Token::Symbol(c) => matches!(c, '+' | '-' | '/' | '_' | '^'),
        Token::Command(command) => matches!(command.as_str(), "cdot" | "times"),
        _ => false,
    }
}

fn is_punctuation(token: &Token) -> bool {
    matches!(token, Token::Symbol(',' | ';' | '.' | ':'))
}

fn is_operand_command(command: &str) -> bool {
    vocabulary::relation(command).is_none() && !matches!(command, "cdot" | "times")
}

fn ends_operand(token: &Token) -> bool {
    match token {
        Token::Letter(_)
        | Token::Number(_)
        | Token::Text(_)
        | Token::Close(_)
        | Token::End(_)
        | Token::Symbol('|' | '\'') => true,
        Token::Command(command) => is_operand_command(command),
        _ => false,
    }
}

fn starts_operand(token: &Token) -> bool {
    match token {
        Token::Letter(_)
        | Token::Number(_)
        | Token::Text(_)
        | Token::Open(_)
        | Token::Begin(_)
        | Token::Symbol('|') => true,
        Token::Command(command) => is_operand_command(command),
        _ => false,
    }
}

/// Takes the equation number off: `\tag{45}` anywhere, or `(45)` at the very end, set apart.
fn take_tag(output: &mut Vec<Lexeme>, diagnostics: &mut Vec<Diagnostic>) -> Option<String> {
    let mut tag = None;
    output.retain(|lexeme| {
        let Token::Tag(text) = &lexeme.token else {
            return true;
        };
        if tag.is_some() {
            let kind = DiagnosticKind::Unexpected {
                found: "a second \\tag".to_owned(),
                expected: "one equation number in a display".to_owned(),
            };
            diagnostics.push(Diagnostic::new(kind, lexeme.span));
        }
        tag = Some(text.clone());
        false
    });
    if tag.is_some() {
        return tag;
    }
    take_number(output, diagnostics)
}

/// Takes `(45)` off the end, also from inside the environment that ends there.
fn take_number(output: &mut Vec<Lexeme>, diagnostics: &mut Vec<Diagnostic>) -> Option<String> {
    let round = Delimiter::Visible(Bracket::Round);
    let mut close = output.len().checked_sub(1)?;
    while matches!(
        output[close].token,
        Token::End(Environment::Lines) | Token::Symbol('.')
    ) {
        close = close.checked_sub(1)?;
    }
    if output[close].token != Token::Close(round) {
        return None;
    }
    let open = output[..close]
        .iter()
        .rposition(|l| l.token == Token::Open(round))?;
    let number = match &output[open + 1..close] {
        [digits] => match &digits.token {
            Token::Number(digits) if !digits.contains('.') => digits.clone(),
            _ => return None,
        },
        [digits, letter] => match (&digits.token, &letter.token) {
            (Token::Number(digits), Token::Letter(c)) => format!("{digits}{c}"),
            _ => return None,
        },
        _ => return None,
    };
    let before = open.checked_sub(1).map(|before| &output[before].token)?;
    let apart = matches!(
        before,
        Token::Space(_)
            | Token::RowBreak
            | Token::End(_)
            | Token::Close(Delimiter::Stretched(Bracket::Curly | Bracket::None))
    ) || is_punctuation(before);
    if apart {
        output.drain(open..=close);
        return Some(number);
    }
    if close + 1 == output.len() && ends_operand(before) && output[open].spaced {
        let readings = vec![
            format!("the equation number ({number})"),
            format!("a factor ({number})"),
        ];
        let span = output[open].span.to(output[close].span);
        diagnostics.push(Diagnostic::new(
            DiagnosticKind::Ambiguous { readings },
            span,
        ));
    }
    None
}
