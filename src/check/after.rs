//! Links of one equation and the corrections of each other: which are false only because an earlier one was
//! corrected, and which a correction would make false.
//!
//! In `A = B = C` the correction of the first link may change `B`. What is then said of the second
//! link must not sound as if `B = C` were false on the printed page.

use super::Checker;
use super::identity::Decision;
use crate::expr::{Display, Relation};
use crate::model::links::{Link, Place};
use crate::verdict::After;

impl Checker<'_> {
    /// The first link before a false one whose correction had changed a side of it, `before` the false
    /// one was corrected itself.
    pub(super) fn after(&self, equation: usize, l: usize, before: &Display) -> Option<After> {
        let printed = &self.model.equations[equation];
        let link = &printed.links[l];
        let differs = |place: &Place| place.find(before) != place.find(&printed.display);
        let changed: Vec<Place> = [link.left, link.right]
            .into_iter()
            .filter(differs)
            .collect();
        let earlier = printed.links[..l]
            .iter()
            .find(|e| changed.contains(&e.left) || changed.contains(&e.right))?;
        Some(After {
            member: earlier.member,
            true_as_printed: self.is_true_in(equation, link, &printed.display),
        })
    }

    /// Whether a correction of a link makes an earlier one false that is true without.
    pub(super) fn breaks_a_link(
        &self,
        equation: usize,
        link: &Link,
        [before, corrected]: [&Display; 2],
    ) -> bool {
        let links = &self.model.equations[equation].links;
        let changes = |place: &Place| place.find(before) != place.find(corrected);
        let mut others = links.iter().filter(|other| {
            other.member < link.member
                && other.relation == Relation::Equal
                && (changes(&other.left) || changes(&other.right))
        });
        others.any(|other| {
            self.is_true_in(equation, other, before) && !self.is_true_in(equation, other, corrected)
        })
    }

    /// Whether a link is seen to be true in a display of its equation.
    fn is_true_in(&self, equation: usize, link: &Link, display: &Display) -> bool {
        let mut trial = self.corrected(equation, display.clone());
        let decision = match trial.sides(equation, link) {
            Ok(entries) => trial.decide_true(&entries, equation).ok(),
            Err(_) => None,
        };
        matches!(
            decision,
            Some(Decision::Holds(_) | Decision::HoldsGiven(..))
        )
    }
}
