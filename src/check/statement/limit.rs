//! Limits of rational functions in one letter, by degrees and leading coefficients, on every way on
//! which the letter can come to its goal.

use super::{Found, Ground};
use crate::check::limits::{Printed, compared, ways_of};
use crate::document::VerdictWord;
use crate::theory::limit::{self, Behaviour};
use crate::verdict::statement::{Fact, Limit};
use ratpoly::RationalFunction;

impl Ground {
    pub(super) fn tends(
        &self,
        f: &RationalFunction,
        x: usize,
        to_infinity: bool,
        to: Option<&RationalFunction>,
    ) -> Found {
        let goal = (!to_infinity).then(|| RationalFunction::zero(self.ring));
        let Some(ways) = ways_of(x, goal, &self.admissible) else {
            return Found::undecided("the letter cannot go there");
        };
        let printed = match to {
            Some(to) => Printed::To(to.clone()),
            None => Printed::Infinite,
        };
        let mut facts = Vec::new();
        let (mut refuted, mut open, mut reason) = (false, false, None);
        for way in ways {
            let Ok(behaviour) = way.behaviour(f, &self.table, &self.admissible) else {
                open = true;
                reason = Some("its limit is out of reach");
                continue;
            };
            match compared(&behaviour, &printed, &self.admissible) {
                Some(true) => {}
                Some(false) => refuted = true,
                None => {
                    open = true;
                    reason = Some("it is unbounded, with a sign that is not known");
                }
            }
            let (limit, conditions) = match behaviour {
                Behaviour::Tends(limit, conditions) => (shown(limit), conditions),
                Behaviour::Unbounded(conditions) => (Limit::Unbounded, conditions),
                Behaviour::Two(one, _) => (shown(one), Vec::new()),
            };
            if !conditions.is_empty() {
                open = true;
                reason = Some("a leading coefficient may vanish");
                facts.push(Fact::Pole(conditions));
            }
            let fact = Fact::Limit(x, limit);
            if !facts.contains(&fact) {
                facts.push(fact);
            }
        }
        let mut found = Found::of(
            match (refuted, open) {
                (true, _) => VerdictWord::Refuted,
                (false, true) => VerdictWord::Undecided,
                (false, false) => VerdictWord::Holds,
            },
            facts,
        );
        if found.word == VerdictWord::Undecided {
            found.reason = reason.map(Into::into);
        }
        found
    }
}

fn shown(limit: limit::Limit) -> Limit {
    match limit {
        limit::Limit::To(value) => Limit::Finite(value),
        limit::Limit::Infinite => Limit::Infinity,
        limit::Limit::MinusInfinite => Limit::MinusInfinity,
    }
}
