//! The equation number at the end of a display.

use super::kind::{ends_operand, is_punctuation};
use crate::diagnostic::{Diagnostic, DiagnosticKind};
use crate::expr::Bracket;
use crate::latex::lexer::{Delimiter, Lexeme, Token};
use crate::latex::vocabulary::Environment;

/// Takes the equation number off: `\tag{45}` anywhere, or `(45)` at the very end, set apart.
pub(super) fn take_tag(
    output: &mut Vec<Lexeme>,
    diagnostics: &mut Vec<Diagnostic>,
) -> Option<String> {
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
