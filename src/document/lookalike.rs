//! Lines that look like the beginning of one of the document's fences and are none.
//!
//! A claim that nobody checks because of a misspelt `math`, a missing blank or an indentation must
//! not pass in silence. A line is suspected if it begins like a fence and its first words are nearly
//! those of the format; it is refused unless Markdown sees a fence of the document there. Examples of
//! the format stand in a fence with more marks than theirs, and what is commented out in `<!-- -->`
//! is meant to be.

use super::equation::ROLES;
use super::markdown::Fence;
use super::{LANGUAGES, TABLES};
use crate::diagnostic::{Diagnostic, DiagnosticKind};
use crate::span::Span;

/// Every line that looks like a fence of the document and is none.
pub(super) fn lookalikes(text: &str, fences: &[Fence], comments: &[Span]) -> Vec<Diagnostic> {
    let mut found = Vec::new();
    let mut at = 0;
    // Fences, and comments, are in the order of the text.
    let mut fences = fences.iter().peekable();
    let mut comments = comments.iter().peekable();
    for line in text.split_inclusive('\n') {
        let span = Span::new(at, at + line.trim_end().len());
        at += line.len();
        let Some((mark, count, info)) = opening(line) else {
            continue;
        };
        while fences
            .next_if(|fence| fence.whole.end <= span.start)
            .is_some()
        {}
        while comments.next_if(|c| c.end <= span.start).is_some() {}
        if comments.peek().is_some_and(|c| c.start <= span.start) {
            continue;
        }
        let around = fences.peek().filter(|f| f.whole.start < span.end);
        let begins = around.is_some_and(|f| f.info.start <= span.end && f.info.start >= span.start);
        let suspected = match around {
            // The language of a fence that Markdown sees.
            Some(f) if begins => {
                !is_language(&text[f.info.start..f.info.end]) && is_nearly_ours(info)
            }
            // Inside of another one, which a line of so many marks would close.
            Some(fence) => fence.mark == mark && count >= fence.count && is_nearly_ours(info),
            None => is_nearly_ours(info),
        };
        if suspected {
            found.push(Diagnostic::new(
                DiagnosticKind::NoFence {
                    line: line.trim().to_owned(),
                    expected: expected(info),
                },
                span,
            ));
        }
    }
    found
}

/// The mark, how many of it, and the words after them, if the line begins like a fence: two marks or
/// more, after whatever Markdown or an editor may have put before them.
fn opening(line: &str) -> Option<(char, usize, &str)> {
    let unseen = |c: char| {
        c.is_whitespace() || c.is_control() || matches!(c, '\u{feff}' | '\u{200b}'..='\u{200f}')
    };
    let before = |c: char| unseen(c) || c == '>';
    let mut rest = line.trim_start_matches(before);
    // The markers of a list.
    if let Some(item) = rest.strip_prefix(['-', '*', '+']) {
        rest = item.trim_start_matches(before);
    }
    let mark = rest.chars().next().filter(|c| matches!(c, '`' | '~'))?;
    let info = rest.trim_start_matches(mark);
    let count = rest.len() - info.len();
    let info = info.trim_matches(unseen);
    // Not code in a line, which the same marks close.
    let closed = info.contains(&rest[..count]);
    (count >= 2 && !info.is_empty() && !closed).then_some((mark, count, info))
}

/// Whether the first word is exactly a language of the document, so that the rest is read.
fn is_language(info: &str) -> bool {
    let word = info.split_whitespace().next().unwrap_or_default();
    LANGUAGES.contains(&word)
}

/// Whether the words are those of the format, or nearly: another case, a letter more or less, a
/// missing blank; or something else before a label and a role.
fn is_nearly_ours(info: &str) -> bool {
    let mut words = info.split_whitespace();
    let first = words.next().unwrap_or_default().to_lowercase();
    let letters: String = first.chars().take_while(|c| c.is_alphabetic()).collect();
    let label = words.next();
    let role = words.next().map(str::to_lowercase);
    let word = |rest: &str| TABLES.contains(&rest) || ROLES.contains(&rest);
    let near = LANGUAGES.iter().any(|language| {
        // A missing blank: `tomlsymbols`.
        letters.strip_prefix(language).is_some_and(word)
            || match strsim::damerau_levenshtein(&letters, language) {
                0 => true,
                1 => letters.len() > 3 || label.is_some(),
                _ => false,
            }
    });
    near || role.is_some_and(|role| ROLES.contains(&role.as_str()))
}

/// How the line should begin.
fn expected(info: &str) -> String {
    let first = info
        .split_whitespace()
        .next()
        .unwrap_or_default()
        .to_lowercase();
    let nearest = LANGUAGES
        .iter()
        .min_by_key(|language| strsim::damerau_levenshtein(&first, language))
        .unwrap_or(&"math");
    match *nearest {
        "toml" => "```toml TABLE".into(),
        "statement" => "```statement LABEL".into(),
        _ => "```math LABEL ROLE".into(),
    }
}
