//! What an expression measures: a dimension, or a matrix of dimensions.

use super::dimension::Dimension;
use crate::span::Span;
use num_rational::BigRational;

/// One scalar: its dimension, and the place to point at when it does not fit.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Entry {
    /// None for a literal zero, which has every dimension.
    pub dimension: Option<Dimension>,
    pub span: Span,
}

/// The dimension of a value of any shape.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum Measure {
    /// Nothing can be said about it.
    Opaque,
    /// A literal zero of any shape and dimension.
    Zero,
    /// A scalar.
    Scalar(Entry),
    /// A matrix by rows.
    Matrix { columns: usize, entries: Vec<Entry> },
}

impl Measure {
    pub fn scalar(dimension: Dimension, span: Span) -> Self {
        Measure::Scalar(Entry {
            dimension: Some(dimension),
            span,
        })
    }

    /// A matrix; one of a single entry is that scalar.
    pub fn matrix(columns: usize, entries: Vec<Entry>) -> Self {
        match entries.len() {
            0 => Measure::Opaque,
            1 => entries
                .into_iter()
                .next()
                .map_or(Measure::Opaque, Measure::Scalar),
            _ => Measure::Matrix { columns, entries },
        }
    }

    /// Rows and columns, where they are known.
    pub fn shape(&self) -> Option<(usize, usize)> {
        match self {
            Measure::Scalar(_) => Some((1, 1)),
            Measure::Matrix { columns, entries } => Some((entries.len() / columns, *columns)),
            Measure::Opaque | Measure::Zero => None,
        }
    }

    pub fn entries(&self) -> &[Entry] {
        match self {
            Measure::Opaque | Measure::Zero => &[],
            Measure::Scalar(entry) => std::slice::from_ref(entry),
            Measure::Matrix { entries, .. } => entries,
        }
    }

    /// The same shape with every entry changed.
    pub fn map(self, mut change: impl FnMut(usize, Entry) -> Entry) -> Measure {
        match self {
            Measure::Opaque | Measure::Zero => self,
            Measure::Scalar(entry) => Measure::Scalar(change(0, entry)),
            Measure::Matrix { columns, entries } => Measure::Matrix {
                columns,
                entries: entries
                    .into_iter()
                    .enumerate()
                    .map(|(at, entry)| change(at, entry))
                    .collect(),
            },
        }
    }

    /// Every entry times a power of a dimension.
    pub fn times_power(self, dimension: &Dimension, power: &BigRational) -> Measure {
        self.map(|_, entry| Entry {
            dimension: entry.dimension.map(|d| d.times_power(dimension, power)),
            span: entry.span,
        })
    }

    /// Every entry at one place: what a name means stands, at a use of the name, at that use.
    pub fn at(self, span: Span) -> Measure {
        self.map(|_, entry| Entry { span, ..entry })
    }

    pub fn transposed(self) -> Measure {
        match self {
            Measure::Matrix { columns, entries } => {
                let rows = entries.len() / columns;
                let transposed = (0..columns)
                    .flat_map(|j| (0..rows).map(move |i| (i, j)))
                    .map(|(i, j)| entries[i * columns + j].clone())
                    .collect();
                Measure::matrix(rows, transposed)
            }
            Measure::Opaque | Measure::Zero | Measure::Scalar(_) => self,
        }
    }

    /// The dimension of a scalar; none of a literal zero and of what is no scalar or not known.
    pub fn dimension(&self) -> Option<&Dimension> {
        match self {
            Measure::Scalar(entry) => entry.dimension.as_ref(),
            Measure::Opaque | Measure::Zero | Measure::Matrix { .. } => None,
        }
    }
}
