//! Diagnostics for a reader: file, line, column, the source excerpt and what to do.
//!
//! Invariant: whatever of the document, or of its name, is repeated goes through
//! [`printable`], so that nothing in it acts on the terminal.

use super::words::{Words, words};
use super::{Diagnostic, Rejection, printable, printable_line};
use crate::span::Span;
use annotate_snippets::{Annotation, AnnotationKind, Group, Level, Renderer, Snippet};
use std::borrow::Cow;
use std::fmt;

/// Most diagnostics that are shown; the rest is counted.
const SHOWN_LIMIT: usize = 50;

/// Longest stretch of a line around a place that is handed to the renderer.
const LINE_LIMIT: usize = 2_000;

/// Longest stretch between two places that is handed to the renderer; a second place farther away is
/// left out.
const EXCERPT_LIMIT: usize = 100_000;

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
    let name = printable_line(name);
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
    let line = |words: &str| printable_line(words).into_owned();
    let title = Level::ERROR.primary_title(line(&words.title));
    let mut group = if text.is_empty() {
        title.element(Snippet::<Annotation<'_>>::source("").path(name))
    } else {
        let span = clipped(diagnostic.span);
        let near = |related: &Span| related.to(span).end - related.to(span).start <= EXCERPT_LIMIT;
        let related = diagnostic.related.map(clipped).filter(near);
        let excerpt = Excerpt::around(text, span, related);
        let mut primary = AnnotationKind::Primary.span(excerpt.range(span));
        if !words.label.is_empty() {
            primary = primary.label(line(&words.label));
        }
        let related = related.map(|span| {
            AnnotationKind::Context
                .span(excerpt.range(span))
                .label(words.related)
        });
        title.element(
            Snippet::source(excerpt.shown())
                .path(name)
                .line_start(excerpt.first_line)
                .annotation(primary)
                .annotations(related),
        )
    };
    if !words.help.is_empty() {
        group = group.element(Level::HELP.message(line(&words.help)));
    }
    group
}

/// A place of which no more is shown than a reader takes in.
fn clipped(span: Span) -> Span {
    let end = span.end.max(span.start);
    Span::new(span.start, end.min(span.start.saturating_add(LINE_LIMIT)))
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

    /// The lines as they are shown.
    fn shown(&self) -> Cow<'a, str> {
        printable(self.text)
    }

    /// Where the place stands in what is shown.
    fn range(&self, span: Span) -> std::ops::Range<usize> {
        let length = self.shown().len();
        let shown = |at: usize| {
            let at = boundary(self.text, at.saturating_sub(self.start));
            // Between the two characters of a line end of Windows the prefix is the longer one.
            boundary(&self.shown(), printable(&self.text[..at]).len().min(length))
        };
        let start = shown(span.start);
        start..shown(span.end.max(span.start)).max(start)
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
