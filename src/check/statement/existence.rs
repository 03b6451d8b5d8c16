//! What may be said where the covariances behind a proposition exist for some values of the letters only.

use super::{Found, Ground};
use crate::check::Checker;
use crate::check::stationary::{EXISTS_FOR_SOME, PartialCovariance};
use crate::document::{Predicate, VerdictWord};
use crate::model::statement::Proposition;
use crate::verdict::statement::Fact;
use num_rational::BigRational;

impl Checker<'_> {
    /// What may be said where the covariances behind a proposition exist for some values of the letters only.
    /// What was proved for all values is so for those; what is shown false by a point is, if they exist there;
    /// how a quantity depends on the letters is seen wherever it is.
    pub(super) fn where_it_exists(
        &self,
        found: Found,
        p: &Proposition,
        ground: &Ground,
        partial: &[PartialCovariance],
    ) -> Found {
        let behind = match partial {
            [] => Vec::new(),
            _ => self.behind(p.expressions(), partial),
        };
        if behind.is_empty() || found.word == VerdictWord::Undecided {
            return found;
        }
        let exist = |point: &[(usize, BigRational)]| {
            behind
                .iter()
                .all(|covariance| self.exists_at(covariance, point))
        };
        let reference: Vec<(usize, BigRational)> = (ground.reference.iter().enumerate())
            .filter_map(|(letter, value)| Some((letter, value.clone()?)))
            .collect();
        let holds = found.word == VerdictWord::Holds;
        let stands = match p.predicate {
            Predicate::Positive
            | Predicate::IncreasingIn
            | Predicate::DecreasingIn
            | Predicate::ConvexIn => {
                let mut shown = found.facts.iter().filter_map(|fact| match fact {
                    Fact::Witness { point, .. } => Some(exist(point)),
                    _ => None,
                });
                holds || shown.next().is_some_and(|first| first && shown.all(|s| s))
            }
            Predicate::IndependentOf
            | Predicate::DependsOnlyOn
            | Predicate::SeparatesInto
            | Predicate::ProportionalTo
            | Predicate::Explicit
            | Predicate::MeasuredLike => true,
            Predicate::TendsTo => holds,
            Predicate::Equals
            | Predicate::CloseTo
            | Predicate::SmallComparedWith
            | Predicate::DependsEssentiallyOn => !p.only_in_box && exist(&reference),
            Predicate::NotMonotoneIn
            | Predicate::HasAMinimumIn
            | Predicate::HasAMaximumIn
            | Predicate::MinimalAt
            | Predicate::MaximalAt
            | Predicate::NearlyMinimalAt
            | Predicate::LeastAtTheLowerBoundOf
            | Predicate::WorseAtTheMinimumOf => false,
        };
        match stands {
            true => found,
            false => Found::undecided(EXISTS_FOR_SOME),
        }
    }
}
