//! Neighbours that must have one dimension, and what is reported when they have not.

use super::dimension::Dimension;
use super::finding::{UnitFinding, UnitSite};
use super::infer::Checker;
use super::measure::{Entry, Measure};
use crate::span::Span;

impl Checker<'_> {
    pub fn find(&mut self, site: UnitSite, span: Span, found: &Dimension, expected: &Dimension) {
        let finding = UnitFinding {
            label: self.label.into(),
            site,
            found: self.names.unification.show(found),
            expected: self.names.unification.show(expected),
            span,
            suspects: Vec::new(),
        };
        let known = |other: &UnitFinding| other.site == finding.site && other.span == finding.span;
        if !self.findings.iter().any(known) {
            self.findings.push(finding);
        }
    }

    /// Makes the entries agree, and reports those that differ from most others.
    pub fn agree(&mut self, entries: &[&Entry], site: &dyn Fn(usize) -> UnitSite) -> Entry {
        let resolved: Vec<Option<Dimension>> = entries
            .iter()
            .map(|entry| {
                let dimension = entry.dimension.as_ref()?;
                Some(self.names.unification.resolve(dimension))
            })
            .collect();
        // What most agree on; the known before the unknown, the first before the later.
        let mut counts: Vec<(&Dimension, usize)> = Vec::new();
        for dimension in resolved.iter().flatten() {
            match counts.iter_mut().find(|(other, _)| *other == dimension) {
                Some((_, count)) => *count += 1,
                None => counts.push((dimension, 1)),
            }
        }
        let best = counts
            .iter()
            .enumerate()
            .max_by_key(|(at, (d, count))| (d.is_known(), *count, std::cmp::Reverse(*at)))
            .map(|(_, (dimension, _))| (*dimension).clone());
        let span = entries.first().map_or(Span::default(), |entry| entry.span);
        let Some(expected) = best else {
            return Entry {
                dimension: None,
                span,
            };
        };
        for (at, dimension) in resolved.iter().enumerate() {
            if let Some(dimension) = dimension
                && !self.names.unification.unify(dimension, &expected)
            {
                self.find(site(at), entries[at].span, dimension, &expected);
            }
        }
        Entry {
            dimension: Some(expected),
            span,
        }
    }

    /// Makes measures of one shape agree entry by entry; zero and what is opaque fit everything.
    pub fn agree_measures(
        &mut self,
        measures: &[Measure],
        site: &dyn Fn(usize, Option<(usize, usize)>) -> UnitSite,
    ) -> Measure {
        let speaking: Vec<(usize, &Measure)> = measures
            .iter()
            .enumerate()
            .filter(|(_, measure)| measure.shape().is_some())
            .collect();
        let Some((_, first)) = speaking.first() else {
            let zero = measures.iter().all(|measure| *measure == Measure::Zero);
            return if zero { Measure::Zero } else { Measure::Opaque };
        };
        // Shapes that differ are the algebra's to report.
        if speaking.iter().any(|(_, m)| m.shape() != first.shape()) {
            return Measure::Opaque;
        }
        let columns = first.shape().map_or(1, |(_, columns)| columns);
        let count = first.entries().len();
        let entries = (0..count)
            .map(|at| {
                let entries: Vec<&Entry> = speaking.iter().map(|(_, m)| &m.entries()[at]).collect();
                let place = (count > 1).then_some((at / columns + 1, at % columns + 1));
                self.agree(&entries, &|which| site(speaking[which].0, place))
            })
            .collect();
        Measure::matrix(columns, entries)
    }

    /// Reports where a measure differs from what it must be.
    pub fn expect(&mut self, found: &Measure, expected: &Measure, site: UnitSite) {
        let (Some(shape), Some((_, columns))) = (found.shape(), expected.shape()) else {
            return;
        };
        if Some(shape) != expected.shape() {
            return;
        }
        for (at, (f, e)) in found.entries().iter().zip(expected.entries()).enumerate() {
            if let (Some(found), Some(expected)) = (&f.dimension, &e.dimension)
                && !self.names.unification.unify(found, expected)
            {
                let site = if site == UnitSite::Term && shape != (1, 1) {
                    UnitSite::TermEntry {
                        row: at / columns + 1,
                        column: at % columns + 1,
                    }
                } else {
                    site.clone()
                };
                self.find(site, f.span, found, expected);
            }
        }
    }
}
