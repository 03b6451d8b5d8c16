//! What is supposed for a while: the condition of the case that is looked at, or a hypothesis with a sign.
//!
//! A table that supposes more gives out the same letters, and knows more signs: what it says is true
//! where all of its suppositions are.

use super::{FunctionTable, Possible};
use num_traits::{One, Signed};
use ratpoly::RationalFunction;
use std::sync::Arc;

/// An element that is supposed to be positive, or not negative.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Supposed<E> {
    /// The element.
    pub element: E,
    /// Whether it is not zero either.
    pub strict: bool,
}

impl FunctionTable {
    /// The table that supposes all of this besides.
    #[must_use]
    pub fn supposing(&self, supposed: &[Supposed<RationalFunction>]) -> Self {
        if supposed.is_empty() {
            return self.clone();
        }
        let mut ranges = self.ranges.to_vec();
        for supposition in supposed {
            self.narrow(&mut ranges, supposition);
        }
        let mut all = self.supposed.to_vec();
        all.extend(supposed.iter().cloned());
        FunctionTable {
            ranges: Arc::new(ranges),
            supposed: Arc::new(all),
            signs: Arc::default(),
            ..self.clone()
        }
    }

    /// Narrows the range of a letter where that is all that is supposed: `3 - x > 0`.
    fn narrow(
        &self,
        ranges: &mut [crate::model::range::Range],
        supposition: &Supposed<RationalFunction>,
    ) {
        let (above, below) = (
            supposition.element.numerator(),
            supposition.element.denominator(),
        );
        let occurring = above.variables_occurring();
        let (Some(below), [letter]) = (below.as_constant(), occurring.as_slice()) else {
            return;
        };
        let letter = *letter;
        if below.is_negative() || letter >= self.first || above.degree(letter) != Some(1) {
            return;
        }
        let coefficients = above.coefficients_in(letter);
        let at = |k: usize| coefficients.get(k).and_then(|c| c.as_constant());
        let (constant, slope) = (at(0).unwrap_or_default(), at(1).unwrap_or_else(One::one));
        let end = num_rational::BigRational::new(-constant, slope.clone());
        if slope.is_positive() {
            ranges[letter].raise(end, !supposition.strict);
        } else {
            ranges[letter].lower(end, !supposition.strict);
        }
    }

    /// An element with its functions evaluated anew: what was not known of roots when they were
    /// met may be known now.
    pub fn anew(&self, f: &RationalFunction) -> Possible<RationalFunction> {
        let all = self.images_behind(&[], &self.letters_behind(f), true)?;
        if all.is_empty() {
            return Ok(self.reduce(f.clone()));
        }
        Ok(self.reduce(f.substitute(&all)?))
    }
}
