//! From characters to lexemes, by TeX's rules.
//!
//! Written by hand and not generated: TeX has five rules, and two of them (the raw text of
//! `\text{...}`, the delimiter after `\left`) change how the next characters are read. Blanks,
//! comments and commands that only shape the look disappear here; spaces that can separate the
//! entries of a row or two equations stay. Every lexeme knows its place in the whole document.

use super::vocabulary::{self, Environment};
use crate::diagnostic::{Diagnostic, DiagnosticKind};
use crate::expr::Bracket;
use crate::span::Span;

/// The most lexemes of one text: a tree takes some hundred bytes for each.
const MOST_LEXEMES: usize = 150_000;

/// The longest length after a line break, such as `[2pt]`, in characters.
const LONGEST_SKIP: usize = 40;

/// A pair of delimiters.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Delimiter {
    /// `{ }`: grouping that is not printed.
    Brace,
    /// `( )` and the like.
    Visible(Bracket),
    /// A delimiter after `\left` or `\right`; `Bracket::None` is the full stop.
    Stretched(Bracket),
}

/// One lexeme.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum Token {
    /// A Latin letter.
    Letter(char),
    /// Digits, with or without a decimal point.
    Number(String),
    /// A control word of the vocabulary, without its backslash.
    Command(String),
    /// Upright words: `\text{...}`, `\mathrm{...}`.
    Text(String),
    /// Punctuation, operators, `_`, `^`, `&`, `|`, `'`.
    Symbol(char),
    /// An opening delimiter.
    Open(Delimiter),
    /// A closing delimiter.
    Close(Delimiter),
    /// `\begin{...}`
    Begin(Environment),
    /// `\end{...}`
    End(Environment),
    /// `\\`
    RowBreak,
    /// A space wide enough to separate entries; `true` if it is a quad or wider.
    Space(bool),
    /// `\tag{...}`
    Tag(String),
    /// Between two entries of a row vector; made by the layout, never by the lexer.
    Column,
}

impl Token {
    /// The token as it is written, for messages.
    pub(super) fn spelling(&self) -> String {
        let (bracket, opening, prefix) = match self {
            Token::Letter(c) | Token::Symbol(c) => return c.to_string(),
            Token::Number(digits) => return digits.clone(),
            Token::Command(command) => return format!("\\{command}"),
            Token::Text(text) => return format!("\\text{{{text}}}"),
            Token::RowBreak => return "\\\\".to_owned(),
            Token::Space(true) => return "\\quad".to_owned(),
            Token::Space(false) | Token::Column => return "\\ ".to_owned(),
            Token::Tag(text) => return format!("\\tag{{{text}}}"),
            Token::Begin(_) => return "\\begin".to_owned(),
            Token::End(_) => return "\\end".to_owned(),
            Token::Open(Delimiter::Brace) => return "{".to_owned(),
            Token::Close(Delimiter::Brace) => return "}".to_owned(),
            Token::Open(Delimiter::Visible(bracket)) => (bracket, true, ""),
            Token::Open(Delimiter::Stretched(bracket)) => (bracket, true, "\\left"),
            Token::Close(Delimiter::Visible(bracket)) => (bracket, false, ""),
            Token::Close(Delimiter::Stretched(bracket)) => (bracket, false, "\\right"),
        };
        let text = match (bracket, opening) {
            (Bracket::Round, true) => "(",
            (Bracket::Round, false) => ")",
            (Bracket::Square, true) => "[",
            (Bracket::Square, false) => "]",
            (Bracket::Curly, true) => "\\{",
            (Bracket::Curly, false) => "\\}",
            (Bracket::Bar, _) => "|",
            (Bracket::None, _) => ".",
        };
        format!("{prefix}{text}")
    }
}

/// A token, where it stands, and what precedes it.
#[derive(Clone, Debug)]
pub(super) struct Lexeme {
    pub token: Token,
    pub span: Span,
    /// Whether a blank precedes it, which is not printed.
    pub spaced: bool,
    /// Whether a space precedes it that is printed, such as `\,`.
    pub gap: bool,
}

/// All lexemes of a text, or everything that is wrong with its characters.
pub(super) fn lex(text: &str, offset: usize) -> (Vec<Lexeme>, Vec<Diagnostic>) {
    let mut lexer = Lexer {
        text,
        offset,
        at: 0,
        spaced: false,
        gap: false,
        lexemes: Vec::new(),
        diagnostics: Vec::new(),
    };
    lexer.run();
    (lexer.lexemes, lexer.diagnostics)
}

struct Lexer<'a> {
    text: &'a str,
    offset: usize,
    at: usize,
    spaced: bool,
    gap: bool,
    lexemes: Vec<Lexeme>,
    diagnostics: Vec<Diagnostic>,
}

impl Lexer<'_> {
    fn peek(&self) -> Option<char> {
        self.text[self.at..].chars().next()
    }

    fn span(&self, start: usize) -> Span {
        Span::new(self.offset + start, self.offset + self.at)
    }

    fn push(&mut self, token: Token, start: usize) {
        let span = self.span(start);
        // A space of its own is a gap before what follows it too.
        let space = matches!(token, Token::Space(_));
        self.lexemes.push(Lexeme {
            token,
            span,
            spaced: self.spaced,
            gap: self.gap,
        });
        self.spaced = false;
        self.gap = space;
    }

    fn complain(&mut self, kind: DiagnosticKind, start: usize) {
        let span = self.span(start);
        self.diagnostics.push(Diagnostic::new(kind, span));
    }

    /// Takes characters while they satisfy the predicate and returns them.
    fn take_while(&mut self, accept: impl Fn(char) -> bool) -> String {
        let rest = &self.text[self.at..];
        let length = rest.find(|c| !accept(c)).unwrap_or(rest.len());
        self.at += length;
        rest[..length].to_owned()
    }

    fn skip_blanks(&mut self) {
        loop {
            let taken = self.take_while(char::is_whitespace);
            if self.peek() == Some('%') {
                self.take_while(|c| c != '\n');
            } else if taken.is_empty() {
                return;
            }
        }
    }

    fn run(&mut self) {
        while let Some(c) = self.peek() {
            let start = self.at;
            if self.lexemes.len() == MOST_LEXEMES {
                let kind = DiagnosticKind::TooLong {
                    what: "a display",
                    size: self.text.len(),
                    limit: MOST_LEXEMES,
                };
                self.at = self.text.len();
                self.complain(kind, start);
                return;
            }
            if c.is_whitespace() || c == '%' {
                self.skip_blanks();
                self.spaced = true;
                continue;
            }
            if c.is_ascii_digit() || c == '.' && self.digit_after(1) {
                self.number(start);
                continue;
            }
            self.at += c.len_utf8();
            match c {
                '\\' => self.control(start),
                'a'..='z' | 'A'..='Z' => self.push(Token::Letter(c), start),
                '{' => self.push(Token::Open(Delimiter::Brace), start),
                '}' => self.push(Token::Close(Delimiter::Brace), start),
                '(' => self.push(Token::Open(Delimiter::Visible(Bracket::Round)), start),
                ')' => self.push(Token::Close(Delimiter::Visible(Bracket::Round)), start),
                '[' => self.push(Token::Open(Delimiter::Visible(Bracket::Square)), start),
                ']' => self.push(Token::Close(Delimiter::Visible(Bracket::Square)), start),
                '~' => self.push(Token::Space(false), start),
                '+' | '-' | '*' | '/' | '=' | '<' | '>' | ',' | ';' | ':' | '.' | '\'' | '&'
                | '_' | '^' | '|' => self.push(Token::Symbol(c), start),
                other => self.complain(
                    DiagnosticKind::Unexpected {
                        found: character(other),
                        expected: "a letter, a number, an operator or a LaTeX command".to_owned(),
                    },
                    start,
                ),
            }
        }
    }

    /// Whether a digit stands so many bytes on.
    fn digit_after(&self, distance: usize) -> bool {
        let next = self.text.as_bytes().get(self.at + distance);
        next.is_some_and(u8::is_ascii_digit)
    }

    /// `12`, `1.5`, `.5`, and with the comma of a decimal or of thousands in a brace `1{,}5`.
    fn number(&mut self, start: usize) {
        let mut digits = self.take_while(|c| c.is_ascii_digit());
        if self.peek() == Some('.') && self.digit_after(1) {
            self.at += 1;
            digits.push('.');
            digits += &self.take_while(|c| c.is_ascii_digit());
        }
        let mut groups = Vec::new();
        while self.text[self.at..].starts_with("{,}") && self.digit_after(3) {
            self.at += 3;
            groups.push(self.take_while(|c| c.is_ascii_digit()));
        }
        let thousands = (1..=3).contains(&digits.len())
            && !digits.contains('.')
            && groups.iter().all(|group| group.len() == 3);
        match groups.as_slice() {
            [] => {}
            [_] if thousands => {
                let readings = vec![
                    "a decimal comma".to_owned(),
                    "a comma of thousands".to_owned(),
                ];
                self.complain(DiagnosticKind::Ambiguous { readings }, start);
            }
            [decimals] if !digits.contains('.') => digits += &format!(".{decimals}"),
            groups if thousands => digits += &groups.concat(),
            _ => {
                let text = self.text[start..self.at].to_owned();
                self.complain(DiagnosticKind::BadNumber { text }, start);
            }
        }
        self.push(Token::Number(digits), start);
    }

    /// A control sequence; the backslash is taken.
    fn control(&mut self, start: usize) {
        let word = self.take_while(|c| c.is_ascii_alphabetic());
        if word.is_empty() {
            self.control_symbol(start);
            return;
        }
        match word.as_str() {
            "left" | "right" => self.stretched(start, word == "left"),
            "quad" | "qquad" => self.push(Token::Space(true), start),
            "begin" | "end" => self.environment(start, word == "begin"),
            "lbrace" => self.push(Token::Open(Delimiter::Visible(Bracket::Curly)), start),
            "rbrace" => self.push(Token::Close(Delimiter::Visible(Bracket::Curly)), start),
            "lbrack" => self.push(Token::Open(Delimiter::Visible(Bracket::Square)), start),
            "rbrack" => self.push(Token::Close(Delimiter::Visible(Bracket::Square)), start),
            "vert" | "lvert" | "rvert" => self.push(Token::Symbol('|'), start),
            "thinspace" => self.gap = true,
            "negthinspace" => {}
            "hspace" => {
                let width = self.raw_argument();
                self.gap |= width.is_some_and(|width| !width.trim_start().starts_with('-'));
            }
            "label" | "vspace" => {
                self.raw_argument();
            }
            "tag" => {
                if self.peek() == Some('*') {
                    self.at += 1;
                }
                if let Some(text) = self.raw_argument() {
                    self.push(Token::Tag(text.trim().to_owned()), start);
                }
            }
            command if vocabulary::is_invisible(command) => {}
            command if vocabulary::is_text(command) => {
                if self.peek() == Some('*') {
                    self.at += 1;
                }
                let is_words = matches!(command, "text" | "mbox" | "textrm" | "textnormal");
                if let Some(text) = self.word_argument() {
                    match is_words && text.contains('$') {
                        true => self.words_and_formulas(&text, start),
                        false => self.words(&text, is_words, start),
                    }
                }
            }
            command if vocabulary::is_known(command) => self.push(Token::Command(word), start),
            command => self.complain(
                DiagnosticKind::UnknownCommand {
                    command: format!("\\{command}"),
                },
                start,
            ),
        }
    }

    fn control_symbol(&mut self, start: usize) {
        let Some(c) = self.peek() else {
            self.complain(
                DiagnosticKind::Unexpected {
                    found: "\\".to_owned(),
                    expected: "a command".to_owned(),
                },
                start,
            );
            return;
        };
        self.at += c.len_utf8();
        match c {
            '\\' => {
                if self.peek() == Some('*') {
                    self.at += 1;
                }
                self.skip_row_skip();
                self.push(Token::RowBreak, start);
            }
            '{' => self.push(Token::Open(Delimiter::Visible(Bracket::Curly)), start),
            '}' => self.push(Token::Close(Delimiter::Visible(Bracket::Curly)), start),
            ',' => self.gap = true,
            '!' | '/' => {}
            c if c.is_whitespace() || matches!(c, ';' | ':' | '>') => {
                self.push(Token::Space(false), start);
            }
            c => self.complain(
                DiagnosticKind::UnknownCommand {
                    command: format!("\\{c}"),
                },
                start,
            ),
        }
    }

    /// The `[2pt]` of `\\[2pt]`.
    fn skip_row_skip(&mut self) {
        let rest = &self.text[self.at..];
        let Some(inner) = rest.strip_prefix('[') else {
            return;
        };
        let near = inner.char_indices().take(LONGEST_SKIP);
        let Some((close, _)) = near.into_iter().find(|(_, c)| *c == ']') else {
            return;
        };
        let length = inner[..close].trim();
        let number = length.trim_end_matches(|c: char| c.is_ascii_alphabetic());
        let unit = &length[number.len()..];
        if !number.is_empty()
            && number.chars().all(|c| "+-.0123456789 ".contains(c))
            && matches!(
                unit,
                "pt" | "em" | "ex" | "mm" | "cm" | "in" | "pc" | "bp" | "sp" | "mu"
            )
        {
            self.at += close + 2;
        }
    }

    /// `{...}` as raw text, or the one letter that TeX takes where no brace follows.
    fn words(&mut self, text: &str, is_words: bool, start: usize) {
        let joined = text.split_whitespace().collect::<Vec<_>>().join(" ");
        // A leading blank tells a remark from a word in the formula.
        let token = match is_words && text.starts_with(char::is_whitespace) {
            true => format!(" {joined}"),
            false => joined,
        };
        self.push(Token::Text(token), start);
    }

    /// `\text{if $x > 0$}`, of which the closing brace was just read: words and formulas in turn.
    fn words_and_formulas(&mut self, text: &str, start: usize) {
        if text.matches('$').count() % 2 == 1 {
            let delimiter = "$".to_owned();
            return self.complain(DiagnosticKind::Unbalanced { delimiter }, start);
        }
        let end = self.at;
        let mut at = end - 1 - text.len();
        for (k, part) in text.split('$').enumerate() {
            if k % 2 == 1 {
                let (lexemes, diagnostics) = lex(part, self.offset + at);
                self.lexemes.extend(lexemes);
                self.diagnostics.extend(diagnostics);
            } else if !part.trim().is_empty() {
                self.at = at + part.len();
                self.words(part, true, at);
            }
            at += part.len() + 1;
        }
        self.at = end;
    }

    fn word_argument(&mut self) -> Option<String> {
        self.skip_blanks();
        match self.peek() {
            Some(c) if c.is_ascii_alphabetic() => {
                self.at += 1;
                Some(c.to_string())
            }
            _ => self.raw_argument(),
        }
    }

    /// `{...}` taken as raw text.
    fn raw_argument(&mut self) -> Option<String> {
        self.skip_blanks();
        let open = self.at;
        if self.peek() != Some('{') {
            let found = self.peek().map_or("the end".to_owned(), String::from);
            self.at += self.peek().map_or(0, char::len_utf8);
            self.complain(
                DiagnosticKind::Unexpected {
                    found,
                    expected: "{".to_owned(),
                },
                open,
            );
            return None;
        }
        let mut depth = 0usize;
        for (position, c) in self.text[open..].char_indices() {
            match c {
                '{' => depth += 1,
                '}' => depth -= 1,
                _ => {}
            }
            if depth == 0 {
                let inner = self.text[open + 1..open + position].to_owned();
                self.at = open + position + 1;
                return Some(inner);
            }
        }
        self.at = open + 1;
        self.complain(
            DiagnosticKind::Unbalanced {
                delimiter: "{".to_owned(),
            },
            open,
        );
        self.at = self.text.len();
        None
    }

    /// The delimiter after `\left` or `\right`.
    fn stretched(&mut self, start: usize, opening: bool) {
        self.skip_blanks();
        let rest = &self.text[self.at..];
        let known = [
            ("\\{", Bracket::Curly),
            ("\\}", Bracket::Curly),
            ("\\lbrace", Bracket::Curly),
            ("\\rbrace", Bracket::Curly),
            ("\\lvert", Bracket::Bar),
            ("\\rvert", Bracket::Bar),
            ("\\vert", Bracket::Bar),
            ("(", Bracket::Round),
            (")", Bracket::Round),
            ("[", Bracket::Square),
            ("]", Bracket::Square),
            ("|", Bracket::Bar),
            (".", Bracket::None),
        ];
        let Some((text, bracket)) = known.iter().find(|(text, _)| rest.starts_with(text)) else {
            let found = self.peek().map_or("the end".to_owned(), String::from);
            self.complain(
                DiagnosticKind::Unexpected {
                    found,
                    expected: "a delimiter".to_owned(),
                },
                start,
            );
            return;
        };
        self.at += text.len();
        let delimiter = Delimiter::Stretched(*bracket);
        let token = if opening {
            Token::Open(delimiter)
        } else {
            Token::Close(delimiter)
        };
        self.push(token, start);
    }

    fn environment(&mut self, start: usize, opening: bool) {
        let Some(name) = self.raw_argument() else {
            return;
        };
        let Some(environment) = vocabulary::environment(&name) else {
            self.complain(
                DiagnosticKind::UnknownCommand {
                    command: format!("\\{}{{{name}}}", if opening { "begin" } else { "end" }),
                },
                start,
            );
            return;
        };
        if !opening {
            self.push(Token::End(environment), start);
            return;
        }
        if vocabulary::takes_argument(&name) {
            self.raw_argument();
        }
        self.push(Token::Begin(environment), start);
    }
}

/// A character that the fragment does not have, with its code point where it might be taken for
/// another one.
fn character(c: char) -> String {
    if c.is_ascii_graphic() {
        c.to_string()
    } else {
        format!("{c} (U+{:04X})", u32::from(c))
    }
}
