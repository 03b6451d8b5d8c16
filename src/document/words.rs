//! Words of an info string at their places.

use super::Text;
use crate::span::Span;

/// The place, or the other one where it is empty.
pub(super) fn or(span: Span, other: Span) -> Span {
    if span.start < span.end { span } else { other }
}

/// The first word of a range of the text, and the trimmed rest.
pub(super) fn split_word(text: &str, span: Span) -> (Text, Span) {
    let words = &text[span.start..span.end];
    let length = words.find(char::is_whitespace).unwrap_or(words.len());
    let rest = &words[length..];
    let inset = rest.len() - rest.trim_start().len();
    let word = Text {
        text: words[..length].into(),
        span: Span::new(span.start, span.start + length),
    };
    (word, Span::new(span.start + length + inset, span.end))
}
