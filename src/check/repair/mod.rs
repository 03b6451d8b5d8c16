//! The search for the smallest correction of a refuted equation.
//!
//! Candidates are the single edits of [`super::edit`], the cheapest first; then slips repeated in
//! one equation (a dot lost in each row); then pairs of edits. Each is evaluated modulo a 61-bit
//! prime at a random point of the declared letters (Schwartz 1980, Zippel 1979): a candidate that is
//! true as a formula passes, a false one passes with negligible probability, and what passes is
//! then proved over the rational functions like any other claim.
//!
//! The number of candidates is bounded, and so is the work that is done for them all, in steps; no clock
//! decides. The candidates are sifted on several threads; how many changes nothing but the time.

mod changed;
mod definitions;
mod evaluators;
mod images;
mod needed;
mod pairs;
mod parallel;
mod preferred;
mod rejected;
mod residue;
mod restated;
mod saying;
mod sift;
mod sites;
mod solved;
mod store;
mod work;

use super::Checker;
use super::edit::{self, Replacement};
use super::identity::Decision;
use crate::evaluate::FailureKind;
use crate::expr::Display;
use crate::functions::FunctionTable;
use crate::latex;
use crate::model::links::Link;
use crate::progress::interrupted;
use crate::verdict::{
    Changed, Correction, Edit, EditClass, Ended, Given, Preferred, Proof, Proposal, Searched,
};
use ratpoly::allowance;
use sites::Trial;
use std::collections::BTreeSet;
use work::Spent;

/// How many candidates that the filter cannot judge are evaluated exactly.
const EXACTLY: usize = 400;

/// How many candidates that passed the filter are proved, the cheapest first.
const PASSING: usize = 48;

/// Steps for a proof beside those for its terms.
const PROOF: u64 = 1_000;

/// How many corrections beside the first are reported.
const OTHERS: usize = 12;

/// How many combinations of one slip repeated are tried for each number of repetitions.
const REPEATED: usize = 5_000;

/// What a pair of edits costs more than its parts: two slips are rarer than one.
const SECOND_SLIP: u32 = 40;

/// Some edits, one after the other, and what they cost together.
#[derive(Clone, Debug)]
pub(super) struct Candidate {
    steps: Vec<Replacement>,
    cost: u32,
}

impl Candidate {
    fn single(replacement: &Replacement) -> Self {
        Candidate {
            cost: replacement.cost,
            steps: vec![replacement.clone()],
        }
    }

    /// A slip repeated: each time after the first costs little.
    fn repeated(steps: Vec<&Replacement>) -> Self {
        let most = steps.iter().map(|r| r.cost).max().unwrap_or_default();
        Candidate {
            cost: most + 10 * (steps.len() as u32 - 1),
            steps: steps.into_iter().cloned().collect(),
        }
    }
}

/// A correction with its proof.
pub(crate) type Found = Correction;

/// The best correction so far of those that put in units that do not fit, and in how many places they
/// do not.
#[derive(Default)]
struct Best {
    found: Option<(Found, usize)>,
}

impl Best {
    /// A correction that puts in no misfit of units ends the search; others wait for what costs more: a
    /// letter for another of a different unit is no slip where two others leave the units right.
    fn among(
        &mut self,
        checker: &Checker<'_>,
        equation: usize,
        printed: &Display,
        found: Option<Found>,
    ) -> Option<Found> {
        let mut correction = found?;
        let (left, fits) = checker.fits_units(equation, printed, &correction.display);
        match &self.found {
            Some((_, before)) if left >= *before => None,
            before => {
                if before.is_some() {
                    correction.preferred = Some(Preferred::Units);
                }
                if fits {
                    return Some(correction);
                }
                self.found = Some((correction, left));
                None
            }
        }
    }
}

/// Whether some edits do with one of them less.
enum Fewer {
    /// Each is needed, as far as can be told.
    Needed,
    /// One less makes it true too, and says nothing: so do all of them.
    SaysNothing,
    /// One less mends it.
    Enough(Box<Proved>),
}

/// Why a candidate has no proof.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Unproved {
    /// It is false, or has no value.
    False,
    /// Nobody knows.
    Open,
}

/// A correction that was proved.
struct Proved {
    candidate: Candidate,
    display: Display,
    given: Option<Given>,
    proof: Proof,
}

impl<'m> Checker<'m> {
    /// The cheapest correction of a link with its proof, if one is found among `budget` candidates and
    /// before the work that the options allow is done.
    ///
    /// # Errors
    /// How many candidates were tried in vain.
    pub(crate) fn search(
        &mut self,
        equation: usize,
        link: &Link,
        budget: usize,
    ) -> Result<Found, Searched> {
        let limit = Spent {
            tried: budget,
            work: self.work_of_a_search(),
        };
        if budget == 0 {
            return Err(searched(limit, Spent::default(), 0, 0));
        }
        let display = self.exact.display(equation).clone();
        let places = [link.left, link.right];
        let context = edit::Context::of(self.model);
        let rows = edit::braces_under_all_rows(&display, link.right);
        let singles = edit::singles(&display, &places, &context);
        let mut trial = Trial::new(self, &display, link, limit);
        let first = usize::from(!rows.is_empty());
        let mut passing = trial.passing(first + singles.len(), |k| match k.checked_sub(first) {
            Some(k) => Candidate::single(&singles[k]),
            None => Candidate::repeated(rows.iter().collect()),
        });
        passing.extend(trial.solved(&context));
        let mut best = Best::default();
        let found = self.prove(equation, link, passing, &singles, &mut trial);
        if let Some(found) = best.among(self, equation, &display, found) {
            return Ok(found);
        }
        // One slip repeated: a lost dot in each row, both indices of a formula.
        let mut repeated = Vec::new();
        for size in 2..=4 {
            for (class, largest) in [
                (EditClass::Dot, 4),
                (EditClass::Transpose, 3),
                (EditClass::Index, 2),
            ] {
                if size <= largest {
                    let class: Vec<&Replacement> =
                        singles.iter().filter(|r| r.class == class).collect();
                    let sets = combinations(&class, size, REPEATED);
                    repeated.extend(sets);
                }
            }
        }
        let passing = trial.passing(repeated.len(), |k| Candidate::repeated(repeated[k].clone()));
        let found = self.prove(equation, link, passing, &singles, &mut trial);
        if let Some(found) = best.among(self, equation, &display, found) {
            return Ok(found);
        }
        if best.found.is_none() {
            let before = trial.spent.work;
            let found = self.by_definition(equation, link, &mut trial.spent, limit, None);
            allowance::spend(work::of_engine(trial.spent.work - before, false));
            if let Some(found) = found {
                return Ok(found);
            }
        }
        let mut passing = trial.pairs(&singles);
        let mut found = self.prove(equation, link, passing.clone(), &singles, &mut trial);
        // What would have to be evaluated pair by pair is of use only where it costs no more.
        let most = match &found {
            Some(correction)
                if correction.given.is_none()
                    && self.fits_units(equation, &display, &correction.display).1 =>
            {
                correction.cost
            }
            _ => u32::MAX,
        };
        let apart = trial.pairs_apart(&singles, most);
        if !apart.is_empty() {
            passing.extend(apart);
            found = self.prove(equation, link, passing, &singles, &mut trial);
        } else if let Some(correction) = &mut found {
            correction.tried = trial.spent.tried.min(limit.tried);
        }
        if let Some(found) = best.among(self, equation, &display, found) {
            return Ok(found);
        }
        if let Some((found, _)) = best.found {
            return Ok(found);
        }
        Err(searched(limit, trial.spent, trial.all, trial.empty))
    }

    /// Proves the candidates that were not ruled out, the cheapest first, until one is proved and
    /// those of the same cost are.
    fn prove(
        &mut self,
        equation: usize,
        link: &Link,
        mut passing: Vec<Candidate>,
        singles: &[Replacement],
        trial: &mut Trial<'_, 'm>,
    ) -> Option<Found> {
        let display = trial.display;
        passing.sort_by_key(|candidate| candidate.cost);
        let reserve = trial.spent.and(trial.reserve()).work;
        let mut proved: Vec<Proved> = Vec::new();
        let mut seen: BTreeSet<String> = BTreeSet::new();
        for (k, candidate) in passing.into_iter().enumerate() {
            let enough = proved.len() > OTHERS
                || k >= PASSING && proved.iter().any(|p| p.candidate.cost < candidate.cost);
            if enough || k >= EXACTLY || trial.spent.work >= reserve || interrupted() {
                break;
            }
            let corrected = edited(display, &candidate.steps);
            let sides = [link.left, link.right].map(|p| p.find(&corrected).map(latex::write_expr));
            let text = sides.map(Option::unwrap_or_default);
            if !seen.insert(text.join(" = ")) {
                continue;
            }
            let mark = trial.store.mark();
            let emptied = saying::emptied(self.model, equation, trial, &corrected, &candidate);
            trial.store.release(mark);
            if emptied.is_some() {
                trial.empty += 1;
                continue;
            }
            let spent = &mut trial.spent.work;
            let (given, proof) = match self.proof_with(equation, link, &corrected, spent) {
                Ok(proved) => proved,
                Err(unproved) => {
                    if unproved == Unproved::Open {
                        trial.unjudged.push(candidate.cost);
                    }
                    continue;
                }
            };
            if self.breaks_a_link(equation, link, [display, &corrected]) {
                trial.empty += 1;
                continue;
            }
            match self.with_one_less(equation, link, &candidate, trial) {
                Fewer::Needed => {}
                Fewer::SaysNothing => {
                    trial.empty += 1;
                    continue;
                }
                Fewer::Enough(fewer) => {
                    let sides = [link.left, link.right].map(|p| p.find(&fewer.display));
                    let text = sides.map(|e| e.map(latex::write_expr).unwrap_or_default());
                    if seen.insert(text.join(" = ")) {
                        proved.push(*fewer);
                    }
                    continue;
                }
            }
            proved.push(Proved {
                candidate,
                display: corrected,
                given,
                proof,
            });
        }
        // Identities before equations that need a relation; of these what fits the units best.
        proved.sort_by_key(|p| (p.given.is_some(), p.candidate.cost));
        let equals = |proved: &[Proved]| {
            let first = proved.first().map(sorting);
            let same = proved.iter().filter(|p| Some(sorting(p)) == first);
            (first, same.count())
        };
        let (cheapest, before) = equals(&proved);
        let mut proved = self.fitting_units_best(equation, proved, |p| &p.display);
        let by_units = equals(&proved).0 != cheapest || equals(&proved).1 < before;
        let preferred = by_units.then_some(Preferred::Units);
        let preferred = preferred
            .or_else(|| self.by_other_links(equation, link, &mut proved))
            .or_else(|| self.by_later_claims(equation, &mut proved));
        let mut proved = proved.into_iter();
        let first = proved.next()?;
        let steps = &first.candidate.steps;
        let edits = described(display, steps);
        let (mut alternatives, mut others) = (Vec::new(), Vec::new());
        for other in proved {
            let edits = described(display, &other.candidate.steps);
            if sorting(&other) == sorting(&first) {
                alternatives.push(edits.clone());
            }
            others.push(Proposal {
                edits,
                display: other.display,
                cost: other.candidate.cost,
            });
        }
        let rejected = self.rejected(display, link, steps, singles);
        let mut changed: Vec<Changed> = Vec::new();
        for step in steps {
            let side = match step.address.place == link.left {
                true => Changed::Left,
                false => Changed::Right,
            };
            if !changed.contains(&side) {
                changed.push(side);
            }
        }
        let as_cheap = trial
            .unjudged
            .iter()
            .filter(|c| **c <= first.candidate.cost);
        let correction = Correction {
            unjudged: as_cheap.count(),
            edits,
            display: first.display,
            definition: None,
            changed,
            cost: first.candidate.cost,
            given: first.given,
            proof: first.proof,
            tried: trial.spent.tried.min(trial.limit.tried),
            budget: trial.limit.tried,
            alternatives,
            others,
            preferred,
            rejected,
        };
        Some(correction)
    }
}

impl Checker<'_> {
    /// The proof of a link with this display; one that is too dear is none. The letters of functions that
    /// one without uses are given back.
    fn proof_with(
        &mut self,
        equation: usize,
        link: &Link,
        display: &Display,
        spent: &mut u64,
    ) -> Result<(Option<Given>, Proof), Unproved> {
        let table = self.functions().cloned();
        let given_out = table.as_ref().map(FunctionTable::given_out);
        let mut mended = self.corrected(equation, display.clone());
        let proof = mended.bounded(|checker| checker.proof_of(equation, link, spent));
        drop(mended);
        let proof = proof.unwrap_or(Err(Unproved::Open));
        if let (Err(_), Some(table), Some(count)) = (&proof, table, given_out) {
            table.take_back(count);
        }
        proof
    }

    /// Whether some edits that mend a link with functions do so with one of them less, which the filter
    /// does not always see.
    fn with_one_less(
        &mut self,
        equation: usize,
        link: &Link,
        candidate: &Candidate,
        trial: &mut Trial<'_, '_>,
    ) -> Fewer {
        if self.model.functions.is_none() || candidate.steps.len() < 2 {
            return Fewer::Needed;
        }
        for k in 0..candidate.steps.len() {
            let mut steps = candidate.steps.clone();
            steps.remove(k);
            let fewer = match steps.as_slice() {
                [only] => Candidate::single(only),
                _ => Candidate::repeated(steps.iter().collect()),
            };
            let display = edited(trial.display, &fewer.steps);
            let spent = &mut trial.spent.work;
            let Ok((given, proof)) = self.proof_with(equation, link, &display, spent) else {
                continue;
            };
            if given.is_some() {
                continue;
            }
            let mark = trial.store.mark();
            let emptied = saying::emptied(self.model, equation, trial, &display, &fewer);
            trial.store.release(mark);
            return match emptied {
                Some(_) => Fewer::SaysNothing,
                None => Fewer::Enough(Box::new(Proved {
                    candidate: fewer,
                    display,
                    given,
                    proof,
                })),
            };
        }
        Fewer::Needed
    }

    /// The proof of a link as it stands now, and the relation that it needs.
    fn proof_of(
        &mut self,
        equation: usize,
        link: &Link,
        spent: &mut u64,
    ) -> Result<(Option<Given>, Proof), Unproved> {
        let entries = self
            .sides(equation, link)
            .map_err(|failure| match failure.kind {
                FailureKind::Unsupported { .. }
                | FailureKind::Budget { .. }
                | FailureKind::Exhausted { .. } => Unproved::Open,
                FailureKind::Shape { .. }
                | FailureKind::DivisionByZero
                | FailureKind::Exponent { .. }
                | FailureKind::Outside { .. }
                | FailureKind::Ambiguous { .. }
                | FailureKind::Undeclared { .. }
                | FailureKind::NeedsItself
                | FailureKind::NotStationary
                | FailureKind::NotLinear
                | FailureKind::Underdetermined
                | FailureKind::Inconsistent
                | FailureKind::Divergent { .. } => Unproved::False,
            })?;
        let values = entries.iter().flat_map(|e| [&e.left, &e.right]);
        *spent += PROOF + work::exact(values);
        let values = entries.iter().flat_map(|e| [&e.left, &e.right]);
        let mut letters = super::identity::letters_of(values).into_iter();
        let rational = !letters.any(|letter| self.is_function(letter));
        match self.decide_true(&entries, equation) {
            Ok(Decision::Holds(by)) => {
                let proof = self.proved(equation, link, &entries, &by, None);
                Ok((None, proof.ok_or(Unproved::Open)?))
            }
            Ok(Decision::HoldsGiven(by, given)) => {
                let proof = self.proved(equation, link, &[], &by, Some(&given));
                Ok((Some(given), proof.ok_or(Unproved::Open)?))
            }
            Ok(Decision::Refuted(_)) => Err(Unproved::False),
            // Without functions the residual decides.
            Ok(Decision::False(..)) if rational => Err(Unproved::False),
            Ok(Decision::Follows(..) | Decision::False(..)) | Err(_) => Err(Unproved::Open),
        }
    }
}

/// How a search ended that found nothing.
fn searched(limit: Spent, spent: Spent, all: usize, empty: usize) -> Searched {
    let ended = if interrupted() {
        Some(Ended::Interrupted)
    } else if spent.tried >= limit.tried {
        Some(Ended::Candidates)
    } else if spent.work >= limit.work {
        Some(Ended::Work)
    } else {
        None
    };
    let tried = spent.tried.min(limit.tried);
    Searched {
        tried,
        of: all.max(tried),
        budget: limit.tried,
        ended,
        empty,
    }
}

/// What corrections are compared by.
fn sorting(proved: &Proved) -> (bool, u32) {
    (proved.given.is_some(), proved.candidate.cost)
}

/// A display with some edits made.
fn edited(display: &Display, steps: &[Replacement]) -> Display {
    let mut candidate = display.clone();
    for step in steps {
        step.apply(&mut candidate);
    }
    candidate
}

/// Edits in LaTeX, each of what the ones before it left.
fn described(display: &Display, steps: &[Replacement]) -> Vec<Edit> {
    let mut display = display.clone();
    let mut found = Vec::new();
    for step in steps {
        found.extend(step.describe(&display));
        step.apply(&mut display);
    }
    found
}

/// Combinations of `size` edits at different places, in order, at most `limit` of them.
fn combinations<'r>(
    class: &[&'r Replacement],
    size: usize,
    limit: usize,
) -> Vec<Vec<&'r Replacement>> {
    let mut class = class.to_vec();
    class.sort_by(|one, other| one.address.cmp(&other.address));
    let mut found: Vec<Vec<&Replacement>> = vec![Vec::new()];
    for _ in 0..size {
        let mut longer = Vec::new();
        for combination in &found {
            let from = combination.last().map(|last| &last.address);
            for replacement in &class {
                if longer.len() >= limit {
                    break;
                }
                if from.is_none_or(|a| *a < replacement.address) {
                    let mut next = combination.clone();
                    next.push(*replacement);
                    longer.push(next);
                }
            }
        }
        found = longer;
    }
    found
}
