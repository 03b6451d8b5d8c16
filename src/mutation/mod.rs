//! How many wrong equations the checker lets through: every claim and every definition of a document
//! is damaged in every single way, and what becomes of each mutant is counted.
//!
//! Mutation analysis (DeMillo, Lipton & Sayward 1978) of the checker itself: a *mutant* is the
//! document with one edit of one equation. It is *refuted* by the code that decides every verdict,
//! or has no meaning at all; or it is *equivalent*: the values of both displays are the same, which
//! is decided apart from the verdict. What the checker lets pass and is not equivalent has
//! *survived*, a fault of ours. A changed definition that no claim tells from the printed one is
//! *undecided*, never a pass.
//!
//! The other half: true claims are *rewritten* so that they say the same, and each must keep its verdict.
//! What is rejected then is a fault of ours as well.

mod base;
mod bench;
mod dependence;
mod fresh;
mod kept;
mod mutants;
mod repairs;
mod rewritings;
mod sample;
pub mod tally;

pub use base::LeftOut;

pub use crate::check::trial::{Finding, Nonsense};
use crate::diagnostic::Rejection;
use crate::document::Document;
use crate::expr::Display;
use crate::latex;
use crate::model::Model;
use crate::progress::Watch;
use crate::stack::{Queue, processors, with_deep_stack};
use crate::verdict::EditClass;
use base::Standing;
use bench::{Bench, Plan};
use dependence::{Dependences, LinkAt};
pub use kept::{Kept, Said};
use mutants::Mutant;
pub use repairs::Repair;
pub use rewritings::Rewriting;
use sample::sample;

/// How much is tried.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Options {
    /// What the samples are drawn with.
    pub seed: u64,
    /// How many of the refuted mutants of a document the search for corrections is tried on; all
    /// where it is none.
    pub repairs: Option<usize>,
    /// How many mutants of a document are judged, drawn at random; all where it is none.
    pub limit: Option<usize>,
    /// How many threads work.
    pub threads: usize,
}

impl Default for Options {
    fn default() -> Self {
        Options {
            seed: 1,
            repairs: Some(200),
            limit: None,
            threads: processors(),
        }
    }
}

/// How an equation was changed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Class {
    /// By an edit that damages it.
    Edit(EditClass),
    /// By a rewriting that says the same.
    Rewriting(Rewriting),
}

/// A changed equation that is to be judged.
#[derive(Clone, Copy, Debug)]
pub struct Case<'c> {
    /// How it was changed.
    pub class: Class,
    /// The equation before the edit.
    pub original: &'c Display,
    /// The equation with the edit.
    pub changed: &'c Display,
}

/// Who decides about a changed equation: the checker, or in tests one that is blind.
pub trait Decide: Sync {
    /// The finding, for which `checker` may be asked.
    fn decide(&self, case: &Case<'_>, checker: &mut dyn FnMut() -> Finding) -> Finding;
}

/// The checker itself.
#[derive(Clone, Copy, Debug)]
pub struct TheChecker;

impl Decide for TheChecker {
    fn decide(&self, _: &Case<'_>, checker: &mut dyn FnMut() -> Finding) -> Finding {
        checker()
    }
}

/// Why a mutant says the same as the original.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Equivalence {
    /// It prints the same.
    PrintsTheSame,
    /// Its values are the same once all definitions are inserted.
    SameValue,
    /// It is an inequality or a limit that is proved as well, and looks true at points chosen apart
    /// from the proof.
    TrueAsWell,
}

impl Equivalence {
    /// In words.
    pub fn as_str(self) -> &'static str {
        match self {
            Equivalence::PrintsTheSame => "prints the same",
            Equivalence::SameValue => "has the same value",
            Equivalence::TrueAsWell => "another inequality or limit that is true as well",
        }
    }
}

/// What becomes of a mutant.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Fate {
    /// The checker says that it is false.
    Refuted {
        /// The label and the number of the link that is false.
        by: (String, usize),
        /// Whether its values are those of the original all the same: a fault of ours.
        false_alarm: bool,
    },
    /// It has no value, which the checker says; counted among the refuted.
    Meaningless {
        /// Why.
        why: Nonsense,
        /// The label and the number of the link that shows it; none where the document is refused.
        by: Option<(String, usize)>,
    },
    /// It says the same as the original.
    Equivalent(Equivalence),
    /// A limit was hit, or no claim depends on what is changed.
    Undecided(String),
    /// The checker lets it pass, and it is not equivalent: a fault of ours.
    Survived,
}

/// One mutant and what became of it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Tried {
    /// The label of the damaged equation.
    pub label: String,
    /// The link of it whose side the edit is in, from 1.
    pub member: usize,
    /// Whether a definition was damaged, or else a claim.
    pub definition: bool,
    /// The class of the edit.
    pub class: EditClass,
    /// What the edit replaces, in LaTeX.
    pub from: String,
    /// What it puts there.
    pub to: String,
    /// The whole equation before, in LaTeX.
    pub printed: String,
    /// The whole mutant in LaTeX.
    pub mutant: String,
    /// What became of it.
    pub fate: Fate,
    /// What the search for corrections proposes, where it was tried.
    pub repair: Option<Repair>,
}

impl Tried {
    /// Whether it is a claim that is refuted and has a meaning.
    pub fn is_refuted_claim(&self) -> bool {
        !self.definition && matches!(self.fate, Fate::Refuted { .. })
    }
}

/// The mutants of one document.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Mutation {
    /// The document's name.
    pub document: String,
    /// The document's title.
    pub title: String,
    /// The seed of the samples.
    pub seed: u64,
    /// How many mutants there are in all; more than were tried where a limit was set or the run
    /// interrupted.
    pub possible: usize,
    /// Those that were tried, in the order of the document.
    pub tried: Vec<Tried>,
    /// How many rewritings there are in all.
    pub possible_rewritings: usize,
    /// Those that were tried, in the order of the document.
    pub rewritten: Vec<Said>,
    /// Links that are not true, or not known to be, and were left as they are.
    pub left_out: Vec<LeftOut>,
}

/// Damages a document in every single way.
///
/// # Errors
/// When the undamaged document cannot be checked.
pub fn mutate(
    document: &Document,
    options: &Options,
    watch: &(dyn Watch + Sync),
) -> Result<Mutation, Rejection> {
    mutate_by(document, options, &TheChecker, watch)
}

/// The same with another judge in place of the checker.
///
/// # Errors
/// As [`mutate`].
pub fn mutate_by(
    document: &Document,
    options: &Options,
    decide: &dyn Decide,
    watch: &(dyn Watch + Sync),
) -> Result<Mutation, Rejection> {
    with_deep_stack(|| run(document, options, decide, watch))
}

fn run(
    printed: &Document,
    options: &Options,
    decide: &dyn Decide,
    watch: &(dyn Watch + Sync),
) -> Result<Mutation, Rejection> {
    let document = base::corrected(printed)?;
    let model = Model::build(&document).map_err(|d| document.reject(d))?;
    let mut checkers = bench::checkers(&model).map_err(|d| document.reject(d))?;
    let standings = base::standings(&model, &mut checkers);
    drop(checkers);
    let links = || {
        standings
            .iter()
            .enumerate()
            .flat_map(|(e, links)| links.iter().enumerate().map(move |(l, s)| ((e, l), s)))
    };
    let with = |wanted: &[Standing]| -> Vec<LinkAt> {
        links()
            .filter(|(_, s)| wanted.contains(s))
            .map(|(at, _)| at)
            .collect()
    };
    let claims = with(&[Standing::True]);
    let left_out = links()
        .filter_map(|((e, l), standing)| match standing {
            Standing::Out(why) => Some(LeftOut {
                label: model.equations[e].label.clone(),
                member: model.equations[e].links[l].member,
                why: why.clone(),
            }),
            _ => None,
        })
        .collect();
    let sound = with(&[Standing::True, Standing::Defines]);
    let rewritings = rewritings::rewritings(&model, &sound);
    let mutants = mutants::mutants(&model, &sound);
    let (possible, possible_rewritings) = (mutants.len(), rewritings.len());
    let (mutants, rewritings) = match options.limit {
        Some(limit) => (
            sample(mutants, limit, options.seed),
            sample(rewritings, limit, options.seed),
        ),
        None => (mutants, rewritings),
    };
    let dependences = Dependences::of(&model, &claims);
    let plan = Plan {
        document: &document,
        claims: &claims,
        dependences: &dependences,
        decide,
    };
    watch.begin("mutating", mutants.len());
    let fates = in_parallel(&plan, options.threads, mutants.len(), watch, |bench, k| {
        bench.fate(&mutants[k])
    });
    watch.end();
    let mut tried: Vec<Tried> = Vec::new();
    let mut finished: Vec<&Mutant> = Vec::new();
    for (mutant, fate) in mutants.iter().zip(fates) {
        if let Some(fate) = fate {
            finished.push(mutant);
            tried.push(told(&model, &standings, mutant, fate));
        }
    }
    let chosen = repairs::chosen(&tried, &finished, options);
    watch.begin("repairing", chosen.len());
    let found = in_parallel(&plan, options.threads, chosen.len(), watch, |bench, k| {
        bench.repair(finished[chosen[k]])
    });
    watch.end();
    for (k, repair) in chosen.into_iter().zip(found) {
        tried[k].repair = repair;
    }
    watch.begin("rewriting", rewritings.len());
    let kept = in_parallel(
        &plan,
        options.threads,
        rewritings.len(),
        watch,
        |bench, k| bench.keeps(&rewritings[k]),
    );
    watch.end();
    let finished = rewritings.iter().zip(kept);
    let rewritten =
        finished.filter_map(|(rewritten, kept)| Some(kept::said(&model, rewritten, kept?)));
    let rewritten = rewritten.collect();
    Ok(Mutation {
        document: printed.name.clone(),
        title: printed.title.clone(),
        seed: options.seed,
        possible,
        tried,
        possible_rewritings,
        rewritten,
        left_out,
    })
}

fn told(model: &Model, standings: &[Vec<Standing>], mutant: &Mutant, fate: Fate) -> Tried {
    let (e, l) = mutant.at;
    let equation = &model.equations[e];
    Tried {
        label: equation.label.clone(),
        member: equation.links[l].member,
        definition: standings[e][l] == Standing::Defines,
        class: mutant.class,
        from: mutant.edit.printed.clone(),
        to: mutant.edit.corrected.clone(),
        printed: latex::write_display(&equation.display),
        mutant: latex::write_display(&mutant.display),
        fate,
        repair: None,
    }
}

/// Does units of work on benches of their own, one for each thread, and gives the results in the
/// order of the units: none for a unit that an interruption has left undone.
fn in_parallel<T: Send>(
    plan: &Plan<'_>,
    threads: usize,
    units: usize,
    watch: &(dyn Watch + Sync),
    work: impl Fn(&mut Bench<'_, '_>, usize) -> T + Sync,
) -> Vec<Option<T>> {
    Queue::run(units, threads, |queue| {
        // A model of its own: letters for functions are given out in the order of this thread's work.
        let Ok(model) = Model::build(plan.document) else {
            return;
        };
        let Ok(mut bench) = Bench::new(plan, &model) else {
            return;
        };
        while !watch.stop()
            && let Some(unit) = queue.take()
        {
            queue.put(unit, work(&mut bench, unit));
            watch.advance();
        }
    })
}
