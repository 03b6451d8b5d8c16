//! The fenced code blocks of a Markdown text (CommonMark), with their places.
//!
//! Invariant: a fence's body has exactly as many bytes as its span, so an offset into the body
//! is an offset into the document. Markers of an enclosing list or quotation, which Markdown
//! takes away, are blanked instead of removed.

use crate::span::Span;
use pulldown_cmark::{CodeBlockKind, Event, HeadingLevel, Parser, Tag, TagEnd};

/// A fenced code block.
#[derive(Clone, Debug)]
pub(super) struct Fence {
    /// What follows the opening fence on its line, raw (without Markdown's own unescaping).
    pub info: Span,
    /// What the fence holds, byte for byte as long as `body_span`.
    pub body: String,
    /// Where the body stands.
    pub body_span: Span,
    /// Whether the closing fence is there.
    pub closed: bool,
    /// The whole block with its fences.
    pub whole: Span,
    /// What the fence is made of, and how many.
    pub mark: char,
    /// How many marks.
    pub count: usize,
}

/// What Markdown sees in a text.
#[derive(Debug, Default)]
pub(super) struct Scan {
    /// All fenced blocks in the order of reading.
    pub fences: Vec<Fence>,
    /// The first heading of level one.
    pub title: Option<String>,
    /// What is commented out, in the order of reading.
    pub comments: Vec<Span>,
}

/// A byte order mark, which editors put before a text and which is no part of it.
const BYTE_ORDER_MARK: &str = "\u{feff}";

/// Reads a text as Markdown.
pub(super) fn scan(text: &str) -> Scan {
    // As many blanks, so that every place stays what it is.
    let blanked = text.strip_prefix(BYTE_ORDER_MARK).map(|rest| {
        let blanks = " ".repeat(BYTE_ORDER_MARK.len());
        format!("{blanks}{rest}")
    });
    let text = blanked.as_deref().unwrap_or(text);
    let mut comments = Vec::new();
    let mut fences = Vec::new();
    let mut title: Option<String> = None;
    let mut heading: Option<String> = None;
    // The block that is open, with the ranges of its text so far.
    let mut open: Option<(Span, Vec<Span>)> = None;

    for (event, range) in Parser::new(text).into_offset_iter() {
        let span = Span::new(range.start, range.end);
        match event {
            Event::Start(Tag::HtmlBlock)
                if text[range.clone()].trim_start().starts_with("<!--") =>
            {
                comments.push(span);
            }
            Event::Start(Tag::CodeBlock(CodeBlockKind::Fenced(_))) => open = Some((span, vec![])),
            Event::End(TagEnd::CodeBlock) => {
                if let Some((whole, pieces)) = open.take() {
                    fences.push(fence(text, whole, &pieces));
                }
            }
            Event::Start(Tag::Heading {
                level: HeadingLevel::H1,
                ..
            }) if title.is_none() => heading = Some(String::new()),
            Event::End(TagEnd::Heading(HeadingLevel::H1)) => {
                if let Some(words) = heading.take() {
                    title = Some(words);
                }
            }
            Event::Text(words) => {
                if let Some((_, pieces)) = &mut open {
                    pieces.push(span);
                } else if let Some(heading) = &mut heading {
                    heading.push_str(&words);
                }
            }
            Event::Code(words) => {
                if let Some(heading) = &mut heading {
                    heading.push_str(&words);
                }
            }
            _ => {}
        }
    }
    Scan {
        fences,
        title,
        comments,
    }
}

/// The fence that covers `whole`, whose text stands at `pieces`.
fn fence(text: &str, whole: Span, pieces: &[Span]) -> Fence {
    let source = &text[whole.start..whole.end];
    let first_line = source.lines().next().unwrap_or("");
    let indent = first_line.len() - first_line.trim_start().len();
    let mark = first_line[indent..].chars().next().unwrap_or('`');
    let ticks = first_line[indent..]
        .chars()
        .take_while(|&c| c == mark)
        .count();
    let info = first_line[indent + ticks..].trim();
    let info_start = whole.start + (info.as_ptr() as usize - source.as_ptr() as usize);
    let info_span = Span::new(info_start, info_start + info.len());

    let body_span = match (pieces.first(), pieces.last()) {
        (Some(first), Some(last)) => first.to(*last),
        _ => {
            let end = (whole.start + first_line.len() + 1).min(whole.end);
            Span::new(end, end)
        }
    };
    let closed = source.lines().skip(1).last().is_some_and(|line| {
        let bare = line.trim_start_matches(|c: char| c == '>' || c.is_whitespace());
        let bare = bare.trim_end();
        bare.len() >= ticks && bare.chars().all(|c| c == mark)
    });
    Fence {
        info: info_span,
        body: blanked(text, body_span, pieces),
        body_span,
        closed,
        whole,
        mark,
        count: ticks,
    }
}

/// The bytes of `span` with everything outside `pieces`, except line ends, made blank.
fn blanked(text: &str, span: Span, pieces: &[Span]) -> String {
    let mut body = String::with_capacity(span.end - span.start);
    let mut at = span.start;
    for piece in pieces {
        blank(&mut body, &text[at..piece.start.max(at)]);
        body.push_str(&text[piece.start.max(at)..piece.end.max(at)]);
        at = piece.end.max(at);
    }
    blank(&mut body, &text[at..span.end.max(at)]);
    body
}

fn blank(body: &mut String, gap: &str) {
    body.extend(gap.bytes().map(|b| if b == b'\n' { '\n' } else { ' ' }));
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Every fence keeps the invariant of the module.
    fn fences(text: &str) -> Vec<Fence> {
        let Scan { fences, .. } = scan(text);
        for fence in &fences {
            assert_eq!(
                fence.body.len(),
                fence.body_span.end - fence.body_span.start
            );
        }
        fences
    }

    #[test]
    fn bodies_stand_where_their_spans_say() {
        let text = "# A *title* with `code`\n\n```math 1 claim\na = b\nc\n```\n\n~~~~ toml 1\nx = 1\n~~~~\n";
        let found = fences(text);
        assert_eq!(scan(text).title.as_deref(), Some("A title with code"));
        assert_eq!(found.len(), 2);
        assert_eq!(found[0].body, "a = b\nc\n");
        assert_eq!(
            &text[found[0].info.start..found[0].info.end],
            "math 1 claim"
        );
        assert_eq!(
            &text[found[0].body_span.start..found[0].body_span.end],
            found[0].body
        );
        assert_eq!(&text[found[1].info.start..found[1].info.end], "toml 1");
        assert!(found.iter().all(|fence| fence.closed));
    }

    #[test]
    fn markers_of_an_enclosing_quotation_are_blanked() {
        let text = "> ```math 1 claim\n> a = b\n>  é\n> ```\n";
        let found = fences(text);
        assert_eq!(found[0].body, "a = b\n   é\n");
        assert!(found[0].closed);
    }

    #[test]
    fn windows_line_ends_do_not_move_anything() {
        let text = "x\r\n\r\n```math 1 claim\r\na = b\r\nc\r\n```\r\n";
        let found = fences(text);
        assert_eq!(
            found[0].body.split_whitespace().collect::<Vec<_>>(),
            ["a", "=", "b", "c"]
        );
        let at = found[0].body.find('c').unwrap() + found[0].body_span.start;
        assert_eq!(&text[at..=at], "c");
    }

    #[test]
    fn an_open_fence_is_seen() {
        assert!(!fences("```math 1 claim\na = b\n")[0].closed);
        assert!(!fences("```math 1 claim")[0].closed);
        assert!(fences("```math 1 claim\n```")[0].closed);
    }

    #[test]
    fn indented_blocks_are_not_fences() {
        assert!(fences("    ```math 1 claim\n    a\n").is_empty());
    }
}
