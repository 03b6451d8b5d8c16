//! Which delimiter closes which, and which stand alone.

use crate::diagnostic::{Diagnostic, DiagnosticKind};
use crate::expr::Bracket;
use crate::latex::lexer::{Delimiter, Lexeme, Token};

/// How deep brackets, braces and environments may be nested.
pub const DEPTH_LIMIT: usize = 100;

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
pub(super) fn pair(lexemes: &[Lexeme]) -> Result<Vec<usize>, Vec<Diagnostic>> {
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
