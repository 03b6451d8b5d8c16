//! Slips in the definitions that a false claim rests on.
//!
//! Where no edit of the claim itself mends it, the single edits of the equations that define its
//! names are tried: modulo the prime, with everything computed anew from the edited definition. An
//! edit is a correction only if every claim that rests on the definition is true with it, so that it
//! explains more than the one claim; what passes is proved exactly.

use super::super::Checker;
use super::super::as_printed::Known;
use super::super::edit::{self, Replacement};
use super::super::identity::Decision;
use super::evaluators::holds_modulo;
use super::images::SplitMix;
use super::parallel::{Blocks, Seed};
use super::work::Spent;
use super::{Found, described};
use crate::domain::{PRIME, PrimeField};
use crate::evaluate::{Evaluator, World};
use crate::expr::{Display, Relation};
use crate::model::links::{Link, Place};
use crate::model::{DefinitionKind, Node, Role};
use crate::verdict::{Changed, Correction, Outcome, Preferred, Verdict};
use std::collections::{BTreeMap, BTreeSet};

/// How many edited definitions are evaluated: each costs everything that rests on it.
const EDITED: usize = 4_000;

/// Steps for each node of the document in which an edited definition is tried.
const PER_NODE: u64 = 4;

/// From how many on they are tried on several threads.
const MANY: usize = 200;

/// A claim: an equation and one of its links.
type Claim = (usize, Link);

/// Where edited definitions are tried.
struct Bench<'m> {
    checker: Checker<'m>,
    evaluator: Evaluator<'m, PrimeField>,
    /// For each definition the claims that rest on it.
    claims: BTreeMap<usize, Vec<Claim>>,
}

impl<'m> Bench<'m> {
    fn new(checker: Checker<'m>) -> Self {
        Bench {
            evaluator: checker.native(),
            checker,
            claims: BTreeMap::new(),
        }
    }

    /// Whether a false claim is true with an edited definition, and with it every claim that rests
    /// on that definition.
    fn mends(&mut self, claim: &Claim, (definition, edit): &(usize, Replacement)) -> bool {
        let printed = self.checker.exact.display(*definition).clone();
        let mut corrected = printed.clone();
        if !edit.apply(&mut corrected) {
            return false;
        }
        let mut evaluator = self.evaluator.corrected(*definition, corrected);
        let own = self.checker.exact.display(claim.0).clone();
        holds_modulo(&mut evaluator, &own, &claim.1) && {
            let resting = match self.claims.get(definition) {
                Some(resting) => resting.clone(),
                None => {
                    let resting = self.checker.resting_on(*definition);
                    self.claims.insert(*definition, resting.clone());
                    resting
                }
            };
            // As printed: what was corrected before may be true without.
            let model = self.checker.model;
            let mut holds = |claim: &Claim| {
                let printed = &model.equations[claim.0].display;
                holds_modulo(&mut evaluator, printed, &claim.1)
            };
            // One claim alone is as well mended where it stands.
            resting.len() > 1 && resting.iter().all(&mut holds)
        }
    }
}

impl<'m> Checker<'m> {
    /// The cheapest single edit of a definition, or of one `among` these, that makes a false link
    /// true, and with it every claim that rests on that definition.
    pub(super) fn by_definition(
        &mut self,
        equation: usize,
        link: &Link,
        spent: &mut Spent,
        limit: Spent,
        among: Option<&BTreeSet<usize>>,
    ) -> Option<Found> {
        let model = self.model;
        // What holds under hypotheses of its own says nothing of a definition. A claim with functions
        // has no value modulo the prime and is then not mended so.
        if !model.equations[equation].assume.is_empty() {
            return None;
        }
        let context = edit::Context::of(model);
        let mut candidates: Vec<(usize, Replacement)> = Vec::new();
        let defining = self.defining(equation);
        for definition in defining
            .into_iter()
            .filter(|d| among.is_none_or(|a| a.contains(d)))
        {
            let display = self.exact.display(definition).clone();
            let places = self.values_in(definition, &display);
            let singles = edit::singles(&display, &places, &context);
            candidates.extend(singles.into_iter().map(|r| (definition, r)));
        }
        candidates.sort_by_key(|(_, replacement)| replacement.cost);
        // Each costs everything that rests on it.
        let price = self.price_of_document();
        let left = limit.less(*spent);
        let most = usize::try_from(left.work / price).unwrap_or(usize::MAX);
        candidates.truncate(EDITED.min(left.tried).min(most));
        let seed = Seed::of(self);
        let claim = (equation, *link);
        let start = || Bench::new(seed.checker());
        let judge = |bench: &mut Bench<'m>, k: usize| bench.mends(&claim, &candidates[k]);
        let threads = match candidates.len() {
            0..MANY => 1,
            _ => self.options.threads,
        };
        let blocks = |units| Blocks {
            units,
            size: 16,
            threads,
        };
        // Up to the first that passes, then the others at its cost.
        let first = blocks(candidates.len()).run(
            Spent {
                tried: 1,
                work: u64::MAX,
            },
            start,
            |bench, range| range.map(|k| judge(bench, k)).collect::<Vec<bool>>(),
            |mends: &Vec<bool>| Spent {
                tried: usize::from(mends.contains(&true)),
                work: 0,
            },
        );
        let mut mends: Vec<bool> = first.concat();
        if let Some(k) = mends.iter().position(|m| *m) {
            let cost = candidates[k].1.cost;
            let end = candidates.partition_point(|(_, r)| r.cost <= cost);
            let done = mends.len();
            mends.truncate(end);
            if done < end {
                let rest = blocks(end - done).run(
                    Spent {
                        tried: usize::MAX,
                        work: u64::MAX,
                    },
                    start,
                    |bench, range| range.map(|k| judge(bench, done + k)).collect::<Vec<bool>>(),
                    |_| Spent::default(),
                );
                mends.extend(rest.concat());
            }
        }
        spent.tried += mends.len();
        spent.work += price * mends.len() as u64;
        let tried = spent.tried;
        let judged = candidates.into_iter().zip(mends);
        let passing: Vec<(usize, Replacement)> = judged
            .filter(|(_, mends)| *mends)
            .map(|(candidate, _)| candidate)
            .collect();
        let mut proved = Vec::new();
        for (definition, replacement) in passing {
            let printed = self.exact.display(definition).clone();
            let mut corrected = printed.clone();
            replacement.apply(&mut corrected);
            let mut mended = self.corrected(definition, corrected.clone());
            if mended.inserted.len() < self.inserted.len() {
                continue;
            }
            let decision = mended.sides(equation, link).ok().and_then(|entries| {
                let decision = mended.decide_true(&entries, equation).ok()?;
                Some((decision, entries))
            });
            let proof = match decision {
                Some((Decision::Holds(by), entries)) => {
                    mended.proved(equation, link, &entries, &by, None)
                }
                Some((Decision::HoldsGiven(by, given), _)) => {
                    mended.proved(equation, link, &[], &by, Some(&given))
                }
                Some((Decision::Follows(..) | Decision::Refuted(_) | Decision::False(..), _))
                | None => None,
            };
            if let Some(proof) = proof {
                let edits = described(&printed, std::slice::from_ref(&replacement));
                proved.push((definition, corrected, edits, replacement.cost, proof));
            }
        }
        let before = proved.len();
        let mut proved = match proved.first() {
            Some((first, ..)) if proved.iter().all(|p| p.0 == *first) => {
                let first = *first;
                self.fitting_units_best(first, proved, |p| &p.1)
            }
            _ => proved,
        };
        let mut preferred = (proved.len() < before).then_some(Preferred::Units);
        if preferred.is_none() && proved.len() > 1 {
            let mut scores = Vec::with_capacity(proved.len());
            for (definition, corrected, ..) in &proved {
                scores.push(usize::from(self.defines_symmetric(*definition, corrected)));
            }
            let symmetric = Self::best_first(&mut proved, &scores);
            preferred = symmetric.map(|_| Preferred::Symmetry);
        }
        let mut proved = proved.into_iter();
        let (definition, corrected, edits, cost, proof) = proved.next()?;
        let alternatives = proved.map(|(_, _, edits, ..)| edits).collect();
        let correction = Correction {
            edits,
            display: self.exact.display(equation).clone(),
            definition: Some((definition, corrected)),
            changed: vec![Changed::Definition(definition)],
            cost,
            given: None,
            proof,
            tried,
            budget: limit.tried,
            unjudged: 0,
            alternatives,
            others: Vec::new(),
            preferred,
            rejected: Vec::new(),
        };
        Some(correction)
    }

    /// Where several claims are false that rest on one definition, a slip there that explains all of
    /// them is likelier than a slip in each.
    pub(in crate::check) fn common_definitions(&mut self, outcomes: &mut [Outcome]) {
        let model = self.model;
        let budget = self.options.candidates;
        let sought = self.options.repair && self.in_definitions && budget > 0;
        if !sought {
            return;
        }
        let is_false = |outcome: &Outcome| match &outcome.verdict {
            Verdict::Misprint { correction, .. } => correction.definition.is_none(),
            Verdict::Refuted(refutation) => refutation.searched.is_some(),
            Verdict::Holds { .. }
            | Verdict::HoldsGiven(..)
            | Verdict::Definition { .. }
            | Verdict::Recalled { .. }
            | Verdict::Undecided { .. } => false,
        };
        let mut resting: BTreeMap<usize, Vec<usize>> = BTreeMap::new();
        for (k, outcome) in outcomes.iter().enumerate().filter(|(_, o)| is_false(o)) {
            for definition in self.defining(outcome.equation) {
                resting.entry(definition).or_default().push(k);
            }
        }
        resting.retain(|_, claims| claims.len() > 1);
        let firsts: BTreeSet<usize> = resting.values().map(|claims| claims[0]).collect();
        for first in firsts {
            if !is_false(&outcomes[first]) {
                continue;
            }
            let among: BTreeSet<usize> = resting
                .iter()
                .filter(|(_, claims)| claims[0] == first)
                .map(|(definition, _)| *definition)
                .collect();
            let equation = outcomes[first].equation;
            let links = model.equations[equation].links.iter();
            let Some(link) = links.copied().find(|l| l.member == outcomes[first].member) else {
                continue;
            };
            let mut printed = self.corrected(equation, model.display(equation).clone());
            let limit = Spent {
                tried: budget,
                work: self.options.work,
            };
            let found =
                printed.by_definition(equation, &link, &mut Spent::default(), limit, Some(&among));
            let Some(correction) = found else {
                continue;
            };
            let spoils = |(definition, display): &(usize, Display)| {
                self.spoils(*definition, display, outcomes)
            };
            if correction.definition.as_ref().is_some_and(spoils) {
                continue;
            }
            self.adopt(printed);
            if let Some((definition, display)) = &correction.definition {
                self.correct(*definition, display.clone());
            }
            let outcome = &mut outcomes[first];
            let (Verdict::Misprint { refutation, .. } | Verdict::Refuted(refutation)) =
                &outcome.verdict
            else {
                continue;
            };
            outcome.verdict = Verdict::Misprint {
                refutation: {
                    let mut refutation = refutation.clone();
                    refutation.searched = None;
                    refutation
                },
                correction: Box::new(correction),
            };
        }
    }

    /// Whether something that rests on a definition and holds is false with this correction of it: equations were
    /// asked, inequalities, limits and what holds under hypotheses were not.
    fn spoils(&self, definition: usize, display: &Display, outcomes: &[Outcome]) -> bool {
        let mut there = self.corrected(definition, display.clone()).only_judging();
        let holds = |outcome: &&Outcome| {
            matches!(
                outcome.verdict,
                Verdict::Holds { .. } | Verdict::HoldsGiven(..)
            )
        };
        let mut resting = outcomes.iter().filter(holds).filter(|o| {
            o.equation != definition && self.defining(o.equation).contains(&definition)
        });
        resting.any(|outcome| {
            let links = self.model.equations[outcome.equation].links.len();
            let found = there.settle_in_world(outcome.equation, vec![Known::Nothing; links]);
            found.iter().any(|o| {
                o.member == outcome.member
                    && matches!(o.verdict, Verdict::Refuted(_) | Verdict::Misprint { .. })
            })
        })
    }

    /// Gives claims that were corrected on their own the correction of a definition that they rest
    /// on, where they are true as printed with it.
    pub(in crate::check) fn explained_by_definitions(&mut self, outcomes: &mut [Outcome]) {
        let definitions: Vec<Correction> = outcomes
            .iter()
            .filter_map(|outcome| match &outcome.verdict {
                Verdict::Misprint { correction, .. } if correction.definition.is_some() => {
                    Some((**correction).clone())
                }
                Verdict::Misprint { .. }
                | Verdict::Refuted(_)
                | Verdict::Holds { .. }
                | Verdict::HoldsGiven(..)
                | Verdict::Definition { .. }
                | Verdict::Recalled { .. }
                | Verdict::Undecided { .. } => None,
            })
            .collect();
        for common in definitions {
            let Some((definition, _)) = common.definition else {
                continue;
            };
            let resting = self.resting_on(definition);
            for outcome in outcomes.iter_mut() {
                let claim = resting
                    .iter()
                    .find(|(e, link)| *e == outcome.equation && link.member == outcome.member);
                let (Some((equation, link)), Verdict::Misprint { correction, .. }) =
                    (claim, &mut outcome.verdict)
                else {
                    continue;
                };
                if correction.definition.is_some() {
                    continue;
                }
                let display = self.model.display(*equation).clone();
                let mut printed = self.corrected(*equation, display.clone());
                let entries = printed.sides(*equation, link).unwrap_or_default();
                if entries.is_empty() {
                    continue;
                }
                let Ok(Decision::Holds(by)) = printed.decide_true(&entries, *equation) else {
                    continue;
                };
                if let Some(proof) = printed.proved(*equation, link, &entries, &by, None) {
                    **correction = Correction {
                        display,
                        proof,
                        ..common.clone()
                    };
                    self.adopt(printed);
                }
            }
        }
    }

    /// What it costs to compute the whole document once modulo the prime.
    fn price_of_document(&self) -> u64 {
        let mut nodes = 0;
        for equation in &self.model.equations {
            crate::model::links::each_expression(&equation.display, &mut |_| nodes += 1);
        }
        PER_NODE * (nodes + 1)
    }

    /// An evaluator modulo the prime that computes everything from the equations.
    pub(super) fn native(&self) -> Evaluator<'m, PrimeField> {
        let mut random = SplitMix(0x5DEE_CE66_D1CE_4E5B);
        let letters = self.model.letters.iter().map(|_| random.next() % PRIME);
        let world = World::new(self.model, letters.collect()).in_instance(self.instance);
        let world = world.corrected_as(self.exact.world()).inserting();
        world.evaluator(PrimeField)
    }

    /// The equations that define what an equation names, directly or through others.
    fn defining(&self, equation: usize) -> BTreeSet<usize> {
        let model = self.model;
        let mut open: Vec<Node> = Vec::new();
        let mut direct = BTreeSet::new();
        crate::model::links::each_expression(self.exact.display(equation), &mut |e| {
            model.collect(e, &mut direct);
        });
        open.extend(direct);
        let mut seen = BTreeSet::new();
        let mut found = BTreeSet::new();
        while let Some(node) = open.pop() {
            if !seen.insert(node) {
                continue;
            }
            match node {
                Node::Definition(d) => {
                    found.insert(model.definitions[d].equation);
                }
                Node::Unknown { system, .. } => {
                    found.insert(model.systems[system].equation);
                }
                Node::Symbol(_) | Node::Matrix(_) | Node::Notation(_) => {}
            }
            open.extend(model.needs(node));
        }
        found.remove(&equation);
        found.retain(|e| matches!(model.equations[*e].role, Role::Define | Role::Solve));
        found
    }

    /// Where an equation says what its names are.
    fn values_in(&self, equation: usize, display: &Display) -> Vec<Place> {
        let model = self.model;
        if model.equations[equation].role == Role::Solve {
            let links = &model.equations[equation].links;
            let mut places: Vec<Place> = links.iter().flat_map(|l| [l.left, l.right]).collect();
            places.sort_unstable();
            places.dedup();
            return places;
        }
        let definitions = model.definitions.iter();
        definitions
            .filter(|d| d.equation == equation)
            .filter(|d| !matches!(d.kind, DefinitionKind::ValueAt(_)))
            .filter(|d| d.place.find(display).is_some())
            .map(|d| d.place)
            .collect()
    }

    /// The claims that rest on an equation: their links that are equations and no definitions.
    pub(super) fn resting_on(&self, definition: usize) -> Vec<Claim> {
        let model = self.model;
        let mut found = Vec::new();
        for (e, equation) in model.equations.iter().enumerate() {
            if e == definition
                || equation.role != Role::Claim
                || !equation.assume.is_empty()
                || !self.defining(e).contains(&definition)
            {
                continue;
            }
            for (l, link) in equation.links.iter().enumerate() {
                let recalled = equation
                    .settings
                    .recalled_members
                    .contains_key(&link.member);
                let claimed = equation.defines[l].is_none()
                    && link.relation == Relation::Equal
                    && link.left != link.right;
                if claimed && !recalled {
                    found.push((e, *link));
                }
            }
        }
        found
    }
}
