//! The figures for programs: `rederive mutate --json`, described by `schemas/mutation.schema.json`.

use crate::mutation::tally::{Kepts, Tally, kepts, tally};
use crate::mutation::{Fate, Kept, Mutation, Said, Tried};
use crate::report::json::Software;
use crate::report::ordered::Ordered;
use serde::Serialize;

/// The whole object.
#[derive(Debug, Serialize)]
pub struct Figures {
    software: Software,
    seed: u64,
    repairs_tried: usize,
    /// All mutants of the documents, tried or not.
    possible: usize,
    total: Counts,
    by_class: Ordered<Counts>,
    documents: Vec<Document>,
    survivors: Vec<Mutant>,
    false_alarms: Vec<Mutant>,
    equivalents: Vec<Mutant>,
    undecided: Vec<Mutant>,
    /// Refuted claims for which the search was tried and the original was not its first proposal.
    not_repaired_first: Vec<Mutant>,
    rewritings: Rewritings,
}

/// True claims said in another way.
#[derive(Debug, Serialize)]
struct Rewritings {
    /// All rewritings of the documents, tried or not.
    possible: usize,
    total: KeptCounts,
    by_kind: Ordered<KeptCounts>,
    wrongly_rejected: Vec<Rewritten>,
    undecided: Vec<Rewritten>,
}

#[derive(Debug, Serialize)]
struct KeptCounts {
    rewritings: usize,
    accepted: usize,
    undecided: usize,
    wrongly_rejected: usize,
}

#[derive(Debug, Serialize)]
struct Rewritten {
    document: String,
    label: String,
    member: usize,
    rewriting: &'static str,
    /// The equation as it was, in LaTeX.
    printed: String,
    /// The rewritten equation.
    rewritten: String,
    /// Why it was rejected or is undecided.
    why: String,
}

#[derive(Debug, Serialize)]
struct Counts {
    mutants: usize,
    refuted: usize,
    meaningless: usize,
    equivalent: usize,
    undecided: usize,
    survived: usize,
    false_alarms: usize,
    repairs_tried: usize,
    repaired_first: usize,
    repaired_any: usize,
}

#[derive(Debug, Serialize)]
struct Document {
    document: String,
    title: String,
    possible: usize,
    total: Counts,
    by_class: Ordered<Counts>,
    left_out: Vec<LeftOut>,
}

#[derive(Debug, Serialize)]
struct LeftOut {
    label: String,
    member: usize,
    why: String,
}

#[derive(Debug, Serialize)]
struct Mutant {
    document: String,
    label: String,
    member: usize,
    definition: bool,
    class: &'static str,
    from: String,
    to: String,
    /// The undamaged equation in LaTeX.
    printed: String,
    /// The mutant in LaTeX.
    mutant: String,
    /// Why it is equivalent or undecided.
    why: Option<String>,
    /// The first proposal of the search, where it was tried.
    proposal: Option<String>,
}

/// The figures of some documents.
pub fn figures(mutations: &[Mutation], seed: u64) -> Figures {
    let (total, by_class) = tally(mutations);
    let listed = |wanted: &dyn Fn(&Tried) -> bool| -> Vec<Mutant> {
        mutations
            .iter()
            .flat_map(|m| m.tried.iter().map(move |t| (m, t)))
            .filter(|(_, t)| wanted(t))
            .map(|(m, t)| mutant(m, t))
            .collect()
    };
    Figures {
        software: Software::this(),
        seed,
        repairs_tried: total.repairs_tried,
        possible: mutations.iter().map(|m| m.possible).sum(),
        total: counts(&total),
        by_class: classes(by_class),
        documents: mutations.iter().map(document).collect(),
        survivors: listed(&|t| t.fate == Fate::Survived),
        false_alarms: listed(&|t| {
            matches!(
                t.fate,
                Fate::Refuted {
                    false_alarm: true,
                    ..
                }
            )
        }),
        equivalents: listed(&|t| matches!(t.fate, Fate::Equivalent(_))),
        undecided: listed(&|t| matches!(t.fate, Fate::Undecided(_))),
        not_repaired_first: listed(&|t| t.repair.as_ref().is_some_and(|r| !r.first)),
        rewritings: rewritings(mutations),
    }
}

fn rewritings(mutations: &[Mutation]) -> Rewritings {
    let (total, by_kind) = kepts(mutations);
    let listed = |wanted: &dyn Fn(&Said) -> Option<String>| -> Vec<Rewritten> {
        mutations
            .iter()
            .flat_map(|m| m.rewritten.iter().map(move |said| (m, said)))
            .filter_map(|(m, said)| {
                Some(Rewritten {
                    document: m.document.clone(),
                    label: said.label.clone(),
                    member: said.member,
                    rewriting: said.rewriting.as_str(),
                    printed: said.printed.clone(),
                    rewritten: said.rewritten.clone(),
                    why: wanted(said)?,
                })
            })
            .collect()
    };
    Rewritings {
        possible: mutations.iter().map(|m| m.possible_rewritings).sum(),
        total: kept_counts(&total),
        by_kind: Ordered(
            by_kind
                .iter()
                .map(|(kind, kepts)| (kind.as_str().to_string(), kept_counts(kepts)))
                .collect(),
        ),
        wrongly_rejected: listed(&|said| match &said.kept {
            Kept::Rejected(why) => Some(why.clone()),
            Kept::Accepted | Kept::Undecided(_) => None,
        }),
        undecided: listed(&|said| match &said.kept {
            Kept::Undecided(why) => Some(why.clone()),
            Kept::Accepted | Kept::Rejected(_) => None,
        }),
    }
}

fn kept_counts(kepts: &Kepts) -> KeptCounts {
    KeptCounts {
        rewritings: kepts.rewritings,
        accepted: kepts.accepted,
        undecided: kepts.undecided,
        wrongly_rejected: kepts.rejected,
    }
}

fn classes(
    by_class: std::collections::BTreeMap<crate::verdict::EditClass, Tally>,
) -> Ordered<Counts> {
    let entries = by_class.iter();
    Ordered(
        entries
            .map(|(class, tally)| (class.as_str().to_string(), counts(tally)))
            .collect(),
    )
}

fn document(mutation: &Mutation) -> Document {
    let (total, by_class) = tally([mutation]);
    Document {
        document: mutation.document.clone(),
        title: mutation.title.clone(),
        possible: mutation.possible,
        total: counts(&total),
        by_class: classes(by_class),
        left_out: mutation
            .left_out
            .iter()
            .map(|left| LeftOut {
                label: left.label.clone(),
                member: left.member,
                why: left.why.clone(),
            })
            .collect(),
    }
}

fn counts(tally: &Tally) -> Counts {
    Counts {
        mutants: tally.mutants,
        refuted: tally.refuted,
        meaningless: tally.meaningless,
        equivalent: tally.equivalent,
        undecided: tally.undecided,
        survived: tally.survived,
        false_alarms: tally.false_alarms,
        repairs_tried: tally.repairs_tried,
        repaired_first: tally.repaired_first,
        repaired_any: tally.repaired_any,
    }
}

fn mutant(mutation: &Mutation, tried: &Tried) -> Mutant {
    Mutant {
        document: mutation.document.clone(),
        label: tried.label.clone(),
        member: tried.member,
        definition: tried.definition,
        class: tried.class.as_str(),
        from: tried.from.clone(),
        to: tried.to.clone(),
        printed: tried.printed.clone(),
        mutant: tried.mutant.clone(),
        why: match &tried.fate {
            Fate::Equivalent(equivalence) => Some(equivalence.as_str().into()),
            Fate::Undecided(reason) => Some(reason.clone()),
            _ => None,
        },
        proposal: tried.repair.as_ref().and_then(|r| r.proposal.clone()),
    }
}
