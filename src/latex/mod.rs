//! Reads LaTeX into the shared syntax tree, and writes it back.
//!
//! The way of a text: `lexer` (characters to lexemes), `layout` (lines, columns, spaces and
//! equation numbers), `parser` (recursive descent with a depth limit), and `writer` for the
//! way back. Equations are read as they are printed; the conventions that decide a reading are
//! these, and what they do not decide is reported as ambiguous:
//!
//! - Juxtaposed factors are a product. A slash divides the whole juxtaposed product before it by
//!   the whole juxtaposed product after it: `q/2de` is q/(2de), a reading that is named (see
//!   [`Reading`]); a second slash is ambiguous, and `\cdot` ends the divisor. A printed space ends a
//!   divisor that is closed in itself (`1/2\, mv^2`); elsewhere in a divisor it is ambiguous, and so
//!   is a number over a number with factors behind it (`1/2 mv^2`).
//! - `d` over `dx` is a derivative; if the document has a letter `d`, a reading that is named where
//!   something follows, and ambiguous otherwise. A whole superscript in brackets, `x^{(2)}`, is
//!   ambiguous.
//! - A sum sign, an integral and `d/dt` take the product that follows, up to the next plus or
//!   minus; `\det`, `\operatorname{tr}`, `\mathrm{Re}` take one factor; `\cos` and its kin take
//!   the juxtaposed letters and numbers that follow, or one bracket.
//! - A bracket directly behind the bracket of a function is ambiguous, as are `\log`, the exponent -1 of a function,
//!   and `E\{...\}` where E is a letter; the square of a defined function, `F^2(x)`, is a reading that is named.
//! - A dot between two columns is their scalar product, a reading that is named; a cross and a power of a column are
//!   ambiguous.
//! - A sign binds looser than a power: `-1^2` is -(1^2).
//! - A name before a round bracket is a function if the [`Signature`] says so or if commas or an
//!   equation stand in the bracket, a factor if it is declared as anything else or if the bracket
//!   holds more than a name or a number. Undeclared, it is a function before the letter that
//!   declared functions are functions of (`w(t)`), and ambiguous otherwise.
//! - `^T` and `^t` transpose. Where the letter has a meaning, `^T` still does on what is bold or a
//!   matrix, and so does `^t` where it is the time of functions, otherwise ambiguous; both are an exponent on other lower-case letters, numbers and brackets, and
//!   ambiguous on a capital; on `e` that nothing declares they are an exponent. What turns out to be a scalar is
//!   not transposed: nothing says that no power is meant.
//! - Round trip: `parse(write(x))` is `x` up to brackets that `x` lacks and the page needs.

mod layout;
mod lexer;
mod parser;
mod signature;
mod vocabulary;
mod writer;

/// How something was read that could be read otherwise.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Reading {
    /// What was read, in the document.
    pub span: Span,
    /// The reading, with the brackets that the print lacks.
    pub latex: String,
}

/// What is not computed where `^T` or `^t` stands at a scalar that looks like no matrix.
pub(crate) const SCALAR_TRANSPOSED: &str =
    "a transpose of a scalar, which may be meant as a power,";

pub use layout::DEPTH_LIMIT;
pub(crate) use parser::is_matrix_like;
pub(crate) use signature::Shape;
pub use signature::Signature;
pub(crate) use vocabulary::is_condition;
pub use writer::{canonical, write_chain, write_display, write_expr, write_relation};

use crate::diagnostic::Diagnostic;
use crate::expr::{Bracket, Chain, Display, Expr, Name};
use crate::span::Span;
use lexer::{Delimiter, Token};
use parser::Parser;
use signature::Head;
use std::sync::Arc;

/// Reads everything that stands under one equation number. `offset` is the place of `text` in
/// its document.
pub fn parse_display(
    text: &str,
    offset: usize,
    signature: &Signature,
) -> Result<Display, Vec<Diagnostic>> {
    parse_printed(text, offset, signature).map(|(display, _)| display)
}

/// The same, with the readings that were chosen where the print leaves a choice.
pub fn parse_printed(
    text: &str,
    offset: usize,
    signature: &Signature,
) -> Result<(Display, Vec<Reading>), Vec<Diagnostic>> {
    let layout = layout::prepare(text, offset, true)?;
    let tag = layout.tag.clone();
    let mut parser = Parser::new(layout, signature);
    let clauses = parser.display();
    parser.finish(clauses).map(|(clauses, readings)| {
        let clauses = clauses.into_iter().map(Arc::new).collect();
        (Display { clauses, tag }, readings)
    })
}

/// Reads one expression.
pub fn parse_expr(
    text: &str,
    offset: usize,
    signature: &Signature,
) -> Result<Expr, Vec<Diagnostic>> {
    let layout = layout::prepare(text, offset, false)?;
    let mut parser = Parser::new(layout, signature);
    let expr = parser.whole(Parser::expression);
    parser.finish(expr).map(|(expr, _)| expr)
}

/// Reads one chain of relations, such as `bd = ae`.
pub fn parse_chain(
    text: &str,
    offset: usize,
    signature: &Signature,
) -> Result<Chain, Vec<Diagnostic>> {
    let layout = layout::prepare(text, offset, false)?;
    let mut parser = Parser::new(layout, signature);
    let chain = parser.whole(Parser::chain);
    parser.finish(chain).map(|(chain, _)| chain)
}

/// Reads one name, with or without an index: a key of a table.
pub fn parse_name(text: &str, offset: usize) -> Result<Name, Vec<Diagnostic>> {
    let signature = Signature::default();
    let layout = layout::prepare(text, offset, false)?;
    let mut parser = Parser::new(layout, &signature);
    let name = parser.whole(Parser::lone_name);
    parser.finish(name).map(|(name, _)| name)
}

/// What is wrong with the characters of a display, its commands and delimiters, whatever its letters
/// are.
pub(crate) fn misprints(text: &str, offset: usize) -> Vec<Diagnostic> {
    layout::prepare(text, offset, true)
        .err()
        .unwrap_or_default()
}

/// The names that the equations of a display begin with, in canonical form.
pub(crate) fn heads(text: &str) -> impl Iterator<Item = String> {
    heads_with_arguments(text)
        .into_iter()
        .map(|head| canonical(&head.name))
}

/// The names that a display defines, with their arguments.
/// The letters that stand somewhere with no round bracket after them, their indices and primes.
fn letters_without_bracket(text: &str) -> Vec<String> {
    let Ok(layout) = layout::prepare(text, 0, true) else {
        return Vec::new();
    };
    let token = |position: usize| layout.lexemes.get(position).map(|l| &l.token);
    let letter = |position: usize| match token(position) {
        Some(Token::Letter(c)) => Some(c.to_string()),
        Some(Token::Command(command)) => Some(format!("\\{command}")),
        _ => None,
    };
    let bare = |mut position: usize| {
        position += 1;
        loop {
            match token(position) {
                Some(Token::Symbol('\'')) => position += 1,
                // What stands below is one lexeme or a group.
                Some(Token::Symbol('_')) => {
                    position = layout.partner.get(position + 1).map_or(position, |p| *p) + 1;
                }
                Some(Token::Open(
                    Delimiter::Visible(Bracket::Round) | Delimiter::Stretched(Bracket::Round),
                )) => return false,
                _ => return true,
            }
        }
    };
    let places = (0..layout.lexemes.len()).filter(|position| bare(*position));
    places.filter_map(letter).collect()
}

fn heads_with_arguments(text: &str) -> Vec<Head> {
    let Ok(layout) = layout::prepare(text, 0, true) else {
        return Vec::new();
    };
    Parser::new(layout, &Signature::default()).heads()
}
