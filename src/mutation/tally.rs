//! The figures, by class and in all.

use super::{Fate, Kept, Mutation, Rewriting, Said, Tried};
use crate::verdict::EditClass;
use std::collections::BTreeMap;
use std::ops::AddAssign;

/// How many mutants had which fate.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Tally {
    /// Mutants that were judged: the sum of the refuted, equivalent, undecided and survived.
    pub mutants: usize,
    /// Refuted, those without a meaning included.
    pub refuted: usize,
    /// Those of the refuted that have no meaning at all.
    pub meaningless: usize,
    /// Proved to say the same as the original.
    pub equivalent: usize,
    /// Not decided.
    pub undecided: usize,
    /// Let pass: faults of ours.
    pub survived: usize,
    /// Refuted although their values are those of the original: faults of ours.
    pub false_alarms: usize,
    /// Those of the refuted that the search for corrections was tried on.
    pub repairs_tried: usize,
    /// Those of them whose first proposal is the original.
    pub repaired_first: usize,
    /// Those of them for which the original is among the proposals.
    pub repaired_any: usize,
}

impl Tally {
    fn count(&mut self, tried: &Tried) {
        self.mutants += 1;
        match &tried.fate {
            Fate::Refuted { false_alarm, .. } => {
                self.refuted += 1;
                self.false_alarms += usize::from(*false_alarm);
            }
            Fate::Meaningless { .. } => {
                self.refuted += 1;
                self.meaningless += 1;
            }
            Fate::Equivalent(_) => self.equivalent += 1,
            Fate::Undecided(_) => self.undecided += 1,
            Fate::Survived => self.survived += 1,
        }
        if let Some(repair) = &tried.repair {
            self.repairs_tried += 1;
            self.repaired_first += usize::from(repair.first);
            self.repaired_any += usize::from(repair.any);
        }
    }
}

impl AddAssign for Tally {
    fn add_assign(&mut self, other: Tally) {
        self.mutants += other.mutants;
        self.refuted += other.refuted;
        self.meaningless += other.meaningless;
        self.equivalent += other.equivalent;
        self.undecided += other.undecided;
        self.survived += other.survived;
        self.false_alarms += other.false_alarms;
        self.repairs_tried += other.repairs_tried;
        self.repaired_first += other.repaired_first;
        self.repaired_any += other.repaired_any;
    }
}

/// The figures of some documents: in all, and for each class that occurs.
pub fn tally<'t>(
    mutations: impl IntoIterator<Item = &'t Mutation>,
) -> (Tally, BTreeMap<EditClass, Tally>) {
    let mut total = Tally::default();
    let mut by_class: BTreeMap<EditClass, Tally> = BTreeMap::new();
    for tried in mutations.into_iter().flat_map(|m| &m.tried) {
        total.count(tried);
        by_class.entry(tried.class).or_default().count(tried);
    }
    (total, by_class)
}

/// How many rewritings were kept or not.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Kepts {
    /// Rewritings that were judged: the sum of the accepted, undecided and rejected.
    pub rewritings: usize,
    /// Accepted as before.
    pub accepted: usize,
    /// Not decided any more.
    pub undecided: usize,
    /// Wrongly rejected: faults of ours.
    pub rejected: usize,
}

impl Kepts {
    fn count(&mut self, said: &Said) {
        self.rewritings += 1;
        match said.kept {
            Kept::Accepted => self.accepted += 1,
            Kept::Undecided(_) => self.undecided += 1,
            Kept::Rejected(_) => self.rejected += 1,
        }
    }
}

/// The figures of the rewritings of some documents: in all, and for each kind that occurs.
pub fn kepts<'t>(
    mutations: impl IntoIterator<Item = &'t Mutation>,
) -> (Kepts, BTreeMap<Rewriting, Kepts>) {
    let mut total = Kepts::default();
    let mut by_kind: BTreeMap<Rewriting, Kepts> = BTreeMap::new();
    for said in mutations.into_iter().flat_map(|m| &m.rewritten) {
        total.count(said);
        by_kind.entry(said.rewriting).or_default().count(said);
    }
    (total, by_kind)
}
