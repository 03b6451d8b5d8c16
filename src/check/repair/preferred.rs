//! What tells corrections of the same cost apart beside the units: the other links of the equation, the
//! claims that rest on what it defines, the symmetry of a matrix that is defined.

use super::super::Checker;
use super::super::identity::Decision;
use super::evaluators::holds_modulo;
use super::{Proved, sorting};
use crate::evaluate::Value;
use crate::expr::Display;
use crate::model::links::Link;
use crate::model::{DefinitionKind, Node};
use crate::span::Span;
use crate::verdict::Preferred;

impl Checker<'_> {
    /// Puts first one of those with the highest score; that score, where it tells them apart.
    pub(super) fn best_first<T>(proved: &mut [T], scores: &[usize]) -> Option<usize> {
        let most = scores.iter().copied().max()?;
        let best = scores.iter().position(|score| *score == most)?;
        proved[..=best].rotate_right(1);
        scores.iter().any(|score| *score < most).then_some(most)
    }

    /// How many corrections have the lowest cost, where there are several.
    fn equals(proved: &[Proved]) -> Option<usize> {
        let lowest = proved.first().map(sorting)?;
        let equals = proved.iter().take_while(|p| sorting(p) == lowest).count();
        (equals > 1).then_some(equals)
    }

    /// First those with which most of the other links of the equation hold.
    pub(super) fn by_other_links(
        &mut self,
        equation: usize,
        link: &Link,
        proved: &mut [Proved],
    ) -> Option<Preferred> {
        let equals = Self::equals(proved)?;
        let printed = &self.model.equations[equation];
        let shared = |other: &Link| {
            let places = [other.left, other.right];
            other.member != link.member
                && other.relation == link.relation
                && (places.contains(&link.left) || places.contains(&link.right))
        };
        // A link that defines is true whatever it says.
        let claims = printed.links.iter().zip(&printed.defines);
        let claims = claims.filter(|(_, defines)| defines.is_none());
        let others: Vec<Link> = claims.map(|(l, _)| *l).filter(|l| shared(l)).collect();
        if others.is_empty() {
            return None;
        }
        let mut scores = Vec::new();
        for one in &proved[..equals] {
            let mut mended = self.corrected(equation, one.display.clone());
            let mut score = 0;
            for other in &others {
                if let Ok(entries) = mended.sides(equation, other)
                    && let Ok(Decision::Holds(_) | Decision::HoldsGiven(..)) =
                        mended.decide_true(&entries, equation)
                {
                    score += 1;
                }
            }
            scores.push(score);
        }
        Self::best_first(proved, &scores).map(Preferred::OtherLinks)
    }

    /// Whether all matrices that an equation defines are symmetric if it reads so, and there is one.
    pub(super) fn defines_symmetric(&mut self, equation: usize, display: &Display) -> bool {
        let model = self.model;
        let mut exact = self.exact.corrected(equation, display.clone());
        let mut matrices = 0;
        let symmetric = (0..model.definitions.len())
            .filter(|d| model.definitions[*d].equation == equation)
            .filter(|d| matches!(model.definitions[*d].kind, DefinitionKind::Whole))
            .all(|d| {
                let key = (Node::Definition(d), Vec::new(), 0);
                match exact.value_of(key, Span::default()) {
                    Ok(Value::Matrix(m)) => {
                        matrices += 1;
                        m == m.transpose()
                    }
                    value => value.is_ok(),
                }
            });
        symmetric && matrices > 0
    }

    /// First those with which most of the claims hold that rest on what the equation defines.
    pub(super) fn by_later_claims(
        &mut self,
        equation: usize,
        proved: &mut [Proved],
    ) -> Option<Preferred> {
        let equals = Self::equals(proved)?;
        let claims = self.resting_on(equation);
        // Functions have no values of their own modulo the prime.
        if claims.is_empty() || self.model.functions.is_some() {
            return None;
        }
        let native = self.native();
        let model = self.model;
        let mut scores = Vec::new();
        for one in &proved[..equals] {
            let mut evaluator = native.corrected(equation, one.display.clone());
            let holds = |(e, link): &&(usize, Link)| {
                holds_modulo(&mut evaluator, &model.equations[*e].display, link)
            };
            scores.push(claims.iter().filter(holds).count());
        }
        Self::best_first(proved, &scores).map(Preferred::LaterClaims)
    }
}
