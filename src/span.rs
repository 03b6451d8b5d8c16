//! Where something stands in a document: a half-open range of byte offsets into its text.
//!
//! Every syntax-tree node and every diagnostic carries one, always relative to the whole
//! document and never to a fence, so that a message can quote the line a reader sees.

/// A half-open range `start..end` of byte offsets into a document's text.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Span {
    /// First byte.
    pub start: usize,
    /// One past the last byte.
    pub end: usize,
}

impl Span {
    /// The range `start..end`.
    pub fn new(start: usize, end: usize) -> Self {
        Span { start, end }
    }

    /// The smallest range that contains both.
    #[must_use]
    pub fn to(self, other: Span) -> Span {
        Span::new(self.start.min(other.start), self.end.max(other.end))
    }
}
