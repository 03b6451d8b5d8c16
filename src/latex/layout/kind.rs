//! What a lexeme is to its neighbours: relation, operator, punctuation, operand.

use crate::latex::lexer::Token;
use crate::latex::vocabulary;

pub(in crate::latex) fn is_relation(token: &Token) -> bool {
    match token {
        Token::Symbol(c) => matches!(c, '=' | '<' | '>'),
        Token::Command(command) => vocabulary::relation(command).is_some(),
        _ => false,
    }
}

pub(super) fn is_operator(token: &Token) -> bool {
    match token {
        Token::Symbol(c) => matches!(c, '+' | '-' | '/' | '_' | '^'),
        Token::Command(command) => matches!(command.as_str(), "cdot" | "times"),
        _ => false,
    }
}

pub(super) fn is_punctuation(token: &Token) -> bool {
    matches!(token, Token::Symbol(',' | ';' | '.' | ':'))
}

fn is_operand_command(command: &str) -> bool {
    vocabulary::relation(command).is_none() && !matches!(command, "cdot" | "times")
}

pub(super) fn ends_operand(token: &Token) -> bool {
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

pub(super) fn starts_operand(token: &Token) -> bool {
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
