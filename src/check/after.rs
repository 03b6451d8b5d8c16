//! Links that are false only because an earlier link of their equation was corrected.
//!
//! In `A = B = C` the correction of the first link may change `B`. What is then said of the second
//! link must not sound as if `B = C` were false on the printed page.

use super::Checker;
use super::identity::Decision;
use crate::expr::Display;
use crate::model::links::Place;
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
        let mut trial = self.corrected(equation, printed.display.clone());
        let decision = match trial.sides(equation, link) {
            Ok(entries) => trial.decide_true(&entries, equation).ok(),
            Err(_) => None,
        };
        let holds = |d| matches!(d, Decision::Holds(_) | Decision::HoldsGiven(..));
        Some(After {
            member: earlier.member,
            true_as_printed: decision.is_some_and(holds),
        })
    }
}
