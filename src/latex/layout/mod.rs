//! What lines, columns and spaces mean, settled before the grammar.
//!
//! Delimiters are paired (a lone one is reported at its place, nesting is limited), brackets
//! that were closed and reopened only to break a line are joined, `&` and `\\` of aligned
//! equations become the end of an equation or nothing, spaces in `[0 \ 0 \ 1]` become columns,
//! and the equation number at the end is taken off. After this stage every `&` and `\\` inside a
//! matrix separates entries, and everywhere else `\\`, `;` and wide spaces separate equations.

mod kind;
mod number;
mod pair;
mod resolve;

pub(super) use kind::is_relation;
pub use pair::DEPTH_LIMIT;

use super::lexer::{self, Delimiter, Lexeme, Token};
use crate::diagnostic::{Diagnostic, DiagnosticKind};
use crate::expr::Bracket;
use crate::span::Span;
use number::take_tag;
use pair::pair;
use resolve::resolve;

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
    let is_long = |d: &Diagnostic| matches!(d.kind, DiagnosticKind::TooLong { .. });
    let partner = match pair(&lexemes) {
        Err(deep)
            if matches!(
                deep[..],
                [Diagnostic {
                    kind: DiagnosticKind::TooDeep { .. },
                    ..
                }]
            ) =>
        {
            return Err(deep);
        }
        // The rest was not looked at, so that nothing can be said of what lacks a partner.
        Ok(_) | Err(_) if diagnostics.iter().any(is_long) => {
            diagnostics.retain(is_long);
            return Err(diagnostics);
        }
        Ok(partner) => partner,
        Err(unpaired) => {
            diagnostics.extend(unpaired);
            diagnostics.sort_by_key(|d| d.span);
            return Err(diagnostics);
        }
    };
    let (mut output, ambiguous) = resolve(&lexemes, &partner);
    diagnostics.extend(ambiguous);
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
