//! Diagnostics for a reader: file, line, column, the source excerpt and what to do.

use super::words::{Words, words};
use super::{Diagnostic, Rejection};
use crate::span::Span;
use annotate_snippets::{
    Annotation, AnnotationKind, Group, Level, Renderer, Snippet, normalize_untrusted_str,
};
use std::fmt;

/// Most diagnostics that are shown; the rest is counted.
const SHOWN_LIMIT: usize = 50;

/// Longest stretch of a line around a place that is handed to the renderer.
const LINE_LIMIT: usize = 2_000;

impl Rejection {
    /// The diagnostics in words, each with its file, line, column and excerpt. Colours are the
    /// escape sequences of a terminal: ask for them only when writing to one.
    pub fn render(&self, colour: bool) -> String {
        render(&self.name, &self.text, &self.diagnostics, colour)
    }
}

/// Without colours.
impl fmt::Display for Rejection {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.render(false))
    }
}

impl std::error::Error for Rejection {}

/// Diagnostics about a text in words, in the order given.
pub fn render(name: &str, text: &str, diagnostics: &[Diagnostic], colour: bool) -> String {
    let renderer = if colour {
        Renderer::styled()
    } else {
        Renderer::plain()
    };
    let name = normalize_untrusted_str(name);
    let mut out = String::new();
    for diagnostic in diagnostics.iter().take(SHOWN_LIMIT) {
        let words = words(&diagnostic.kind);
        out.push_str(&renderer.render(&[group(&name, text, diagnostic, &words)]));
        out.push_str("\n\n");
    }
    if diagnostics.len() > SHOWN_LIMIT {
        let more = diagnostics.len() - SHOWN_LIMIT;
        out.push_str(&format!("and {more} more in {name}\n\n"));
    }
    out.truncate(out.trim_end().len());
    out.push('\n');
    out
}

fn group<'a>(name: &'a str, text: &'a str, diagnostic: &Diagnostic, words: &Words) -> Group<'a> {
    let title = Level::ERROR.primary_title(normalize_untrusted_str(&words.title));
    let mut group = if text.is_empty() {
        title.element(Snippet::<Annotation<'_>>::source("").path(name))
    } else {
        let excerpt = Excerpt::around(text, diagnostic.span, diagnostic.related);
        let mut primary = AnnotationKind::Primary.span(excerpt.range(diagnostic.span));
        if !words.label.is_empty() {
            primary = primary.label(normalize_untrusted_str(&words.label));
        }
        let related = diagnostic.related.map(|span| {
            AnnotationKind::Context
                .span(excerpt.range(span))
                .label(words.related)
        });
        title.element(
            Snippet::source(excerpt.text)
                .path(name)
                .line_start(excerpt.first_line)
                .annotation(primary)
                .annotations(related),
        )
    };
    if !words.help.is_empty() {
        group = group.element(Level::HELP.message(normalize_untrusted_str(&words.help)));
    }
    group
}

/// The lines that a diagnostic needs, so that its cost does not grow with the document.
struct Excerpt<'a> {
    text: &'a str,
    start: usize,
    first_line: usize,
}

impl<'a> Excerpt<'a> {
    fn around(text: &'a str, span: Span, related: Option<Span>) -> Self {
        let whole = related.map_or(span, |related| related.to(span));
        let start = boundary(text, whole.start);
        let end = boundary(text, whole.end.max(whole.start));
        let line_start = text[..start].rfind('\n').map_or(0, |at| at + 1);
        let line_end = text[end..].find('\n').map_or(text.len(), |at| end + at);
        Excerpt {
            text: &text[line_start..line_end.min(boundary(text, end + LINE_LIMIT))],
            start: line_start,
            first_line: 1 + text[..line_start].matches('\n').count(),
        }
    }

    fn range(&self, span: Span) -> std::ops::Range<usize> {
        let start = boundary(self.text, span.start - self.start);
        start..boundary(self.text, span.end.max(span.start) - self.start).max(start)
    }
}

/// The nearest character boundary at or before an offset.
fn boundary(text: &str, at: usize) -> usize {
    let at = at.min(text.len());
    (0..=at)
        .rev()
        .find(|&at| text.is_char_boundary(at))
        .unwrap_or(0)
}
