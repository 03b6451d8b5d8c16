//! Verdicts on the links of a model.
//!
//! Equations are settled in the order of their dependencies, so that what a misprint would spoil
//! further down is computed from the corrected equation: slips do not cascade. No float is used
//! here, no verdict depends on what the author expects, and nothing unknown counts as true.

mod admissible;
mod after;
mod as_printed;
pub(crate) mod bounded;
mod by_cases;
mod cartesian;
mod challenge;
mod conditions;
mod definite;
mod definiteness;
mod divergent;
pub mod edit;
pub mod effect;
mod hypotheses;
mod identity;
mod instances;
mod letters;
mod limits;
mod link;
mod no_value;
mod order;
mod part;
mod proof;
mod rates;
mod recalled;
mod relations;
mod repair;
mod scope;
mod side_relation;
mod sides;
mod sizes;
mod statement;
mod stationary;
mod supports;
pub(crate) mod trial;
mod units;
mod unwritten;
mod witness;
mod words;
mod worlds;

pub(crate) use link::words_of_failure;
pub(crate) use recalled::recalled_and_false;

use crate::diagnostic::Diagnostic;
use crate::domain::Symbolic;
use crate::evaluate::{self, Evaluator, Failure, FailureKind};
use crate::expr::Display;
use crate::functions::FunctionTable;
use crate::model::Model;
use crate::verdict::statement::StatementOutcome;
use crate::verdict::{Contradiction, Outcome, Refutation, Verdict};
use as_printed::Known;
use hypotheses::Supposed;
use std::borrow::Cow;
use std::sync::Arc;
use worlds::{Insertions, Prints};

/// How much is spent.
#[derive(Clone, Copy, Debug)]
pub struct Options {
    /// Whether corrections are searched for.
    pub repair: bool,
    /// The largest number of candidates that the search looks at for one link.
    pub candidates: usize,
    /// The most work that the search does for one link, in steps: operations on numbers, nodes of
    /// expressions, and so many for each term of an exact value.
    pub work: u64,
    /// How many threads sift candidates; the results do not depend on it.
    pub threads: usize,
}

impl Default for Options {
    fn default() -> Self {
        Options {
            repair: true,
            candidates: 2_000_000,
            work: 30_000_000,
            threads: crate::stack::processors(),
        }
    }
}

/// The checker of one model.
pub struct Checker<'m> {
    pub(crate) model: &'m Model,
    pub(crate) exact: Evaluator<'m, Symbolic>,
    /// Which of the model's instances is checked.
    pub(crate) instance: usize,
    options: Options,
    /// What is supposed of the letters: by their declarations, and by hypotheses where these hold.
    pub(crate) supposed: Arc<Supposed>,
    /// For each letter that is an abbreviation, its value in the declared symbols.
    pub(crate) inserted: Arc<Insertions>,
    diagnostics: Vec<Diagnostic>,
    readings: units::KnownReadings,
    /// Whether one slip in a definition is sought that explains several false claims.
    in_definitions: bool,
    /// Who is told of what is false before its correction is searched for.
    tell: Option<&'m Teller<'m>>,
    /// Why the last link that was looked at stayed undecided, where its evaluation failed.
    failure: Option<FailureKind>,
    /// How the program contradicted itself on the last link, if it did.
    contradiction: Option<Contradiction>,
    /// The steps that are left for all links.
    pool: bounded::Pool,
    /// The equations as printed, with their hashes.
    prints: Prints,
}

/// The verdicts on a model.
#[derive(Clone, Debug)]
pub struct Verdicts {
    /// One outcome for each link, in the order of the document.
    pub links: Vec<Outcome>,
    /// One outcome for each proposition of the statements, in the order of the document.
    pub statements: Vec<StatementOutcome>,
}

/// Checks every link and every statement of a model.
///
/// # Errors
/// When evaluation shows that the document is unusable: shapes that do not fit, a divisor that is
/// zero identically, an exponent beyond the limit.
pub fn check(model: &Model, options: Options) -> Result<Verdicts, Vec<Diagnostic>> {
    check_telling(model, options, &|_| {})
}

/// A link that was found false, before a correction of it is searched for.
#[derive(Clone, Copy, Debug)]
pub struct Told<'r> {
    /// The equation, as an index into the model.
    pub equation: usize,
    /// The link's number within it, from 1.
    pub member: usize,
    /// Why it is false.
    pub refutation: &'r Refutation,
}

/// Who is told of what is found false.
pub type Teller<'t> = dyn Fn(Told<'_>) + Sync + 't;

/// The same, telling of each link that is false before the search for its correction begins.
///
/// # Errors
/// As [`check`].
pub fn check_telling<'m>(
    model: &'m Model,
    options: Options,
    tell: &'m Teller<'m>,
) -> Result<Verdicts, Vec<Diagnostic>> {
    let mut checker = Checker::new(model, options)?;
    checker.tell = Some(tell);
    let instances = model.instances.len();
    checker.pool = bounded::Pool::of_one_in(instances);
    let mut verdicts = checker.run()?;
    // A correction serves all instances: one of a definition that the first has none of serves none.
    let in_definitions = verdicts.links.iter().any(|outcome| {
        matches!(&outcome.verdict, Verdict::Misprint { correction, .. } if correction.definition.is_some())
    });
    for instance in 1..instances {
        let mut checker = Checker::in_instance(model, options, instance)?;
        checker.in_definitions = in_definitions;
        checker.tell = Some(tell);
        checker.pool = bounded::Pool::of_one_in(instances);
        verdicts = instances::all(verdicts, checker.run()?);
    }
    sizes::name(model, &mut verdicts);
    Ok(verdicts)
}

impl<'m> Checker<'m> {
    /// A checker of the first instance; the values of all abbreviations are computed.
    ///
    /// # Errors
    /// When an abbreviation has no value.
    pub fn new(model: &'m Model, options: Options) -> Result<Self, Vec<Diagnostic>> {
        Checker::in_instance(model, options, 0)
    }

    /// A checker of one of the model's instances.
    ///
    /// # Errors
    /// When an abbreviation has no value.
    pub fn in_instance(
        model: &'m Model,
        options: Options,
        instance: usize,
    ) -> Result<Self, Vec<Diagnostic>> {
        let world = evaluate::symbolic(model).in_instance(instance);
        let exact = world.evaluator(model.field());
        let declared = Arc::new(Supposed::declared(model));
        let mut checker = Checker::with(exact, options, Arc::default(), declared);
        checker.insert_abbreviations();
        if checker.diagnostics.is_empty() {
            Ok(checker)
        } else {
            Err(checker.diagnostics)
        }
    }

    /// Settles all equations, and the statements once all corrections are known; the outcomes are
    /// in the order of the document.
    ///
    /// # Errors
    /// As [`check`].
    pub fn run(mut self) -> Result<Verdicts, Vec<Diagnostic>> {
        let mut outcomes = Vec::new();
        let table = self.lent();
        let kept = table.as_ref().map_or(0, FunctionTable::given_out);
        for equation in self.model.settling_order() {
            self.settle_with_letters(equation, kept, &mut outcomes);
        }
        let mut better = outcomes.clone();
        let improved = self.bounded_in_all(|checker| {
            checker.common_definitions(&mut better);
            checker.explained_by_definitions(&mut better);
        });
        if improved.is_ok() {
            outcomes = better;
        }
        if let Some(table) = &table {
            self.make_room(table, kept, &mut outcomes);
        }
        let statements = self.statements();
        if !self.diagnostics.is_empty() {
            self.diagnostics.sort_by_key(|d| d.span);
            self.diagnostics.dedup();
            return Err(self.diagnostics);
        }
        outcomes.sort_by_key(|o| (o.equation, o.member));
        Ok(Verdicts {
            links: outcomes,
            statements,
        })
    }

    /// The display that an equation is evaluated from.
    fn display(&self, equation: usize) -> Cow<'m, Display> {
        match self.exact.world().correction(equation) {
            Some(display) => Cow::Owned(display.clone()),
            None => Cow::Borrowed(&self.model.equations[equation].display),
        }
    }

    fn note(&mut self, failure: &Failure) {
        self.diagnostics.extend(failure.diagnostic());
    }

    /// The outcomes of an equation's links: of each as printed, where it holds so, and else with what was
    /// corrected before.
    fn settle(&mut self, equation: usize) -> Vec<Outcome> {
        let (known, corrected) = self.known_as_printed(equation);
        let mut outcomes = self.settle_in_world(equation, known.clone());
        for (outcome, known) in outcomes.iter_mut().zip(&known) {
            let judged = match outcome.verdict {
                Verdict::Holds { .. }
                | Verdict::HoldsGiven(..)
                | Verdict::Misprint { .. }
                | Verdict::Refuted(_) => true,
                Verdict::Undecided { .. }
                | Verdict::Definition { .. }
                | Verdict::Recalled { .. } => false,
            };
            if !matches!(known, Known::Held(_)) && judged {
                outcome.corrected.clone_from(&corrected);
            }
            // A correction may put in what another one corrects.
            if let Verdict::Misprint { correction, .. } = &outcome.verdict {
                let links = self.model.equations[equation].links.iter();
                let own = links.filter(|link| link.member == outcome.member);
                let sides = own.flat_map(|link| [link.left, link.right]);
                let sides = sides.filter_map(|place| place.find(&correction.display));
                let behind = self.corrected_behind(sides, Some(equation));
                let more: Vec<usize> = behind
                    .into_iter()
                    .filter(|e| !outcome.corrected.contains(e))
                    .filter(|e| correction.definition.as_ref().is_none_or(|(d, _)| d != e))
                    .collect();
                outcome.corrected.extend(more);
            }
        }
        outcomes
    }

    /// The outcomes of an equation's links, under the hypotheses that are printed around it; some are known.
    fn settle_in_world(&mut self, equation: usize, known: Vec<Known>) -> Vec<Outcome> {
        let model = self.model;
        let printed = &model.equations[equation];
        let all_held = known.iter().all(|k| matches!(k, Known::Held(_)));
        if printed.assume.is_empty() || all_held {
            return self.settle_links(equation, None, known);
        }
        let supposed = self.bounded(|checker| checker.under_hypotheses(equation));
        let supposed = match supposed {
            Ok(supposed) => supposed,
            Err(exhausted) => {
                let words = self.words_of_exhaustion(exhausted);
                return self.settle_links(equation, Some(words), known);
            }
        };
        match supposed {
            Err(unusable) => {
                let reason = self.words_of(&unusable);
                self.settle_links(equation, Some(&reason), known)
            }
            Ok(mut under) => {
                let outcomes = under.settle_links(equation, None, known);
                self.learn(equation, under);
                outcomes
            }
        }
    }

    /// Takes over what a checker has found under the hypotheses of an equation.
    fn learn(&mut self, equation: usize, under: Checker<'m>) {
        self.pool = under.pool;
        self.diagnostics.extend(under.diagnostics);
        for (node, kind) in under.exact.world().without_value() {
            self.has_no_value(*node, kind.clone());
        }
        if let Some(display) = under.exact.world().correction(equation) {
            self.correct(equation, display.clone());
        }
    }

    fn settle_links(
        &mut self,
        equation: usize,
        unusable: Option<&str>,
        known: Vec<Known>,
    ) -> Vec<Outcome> {
        let links = known.into_iter().enumerate();
        links
            .map(|(l, known)| self.outcome_knowing(equation, l, unusable, known))
            .collect()
    }

    /// What is found out about one link of an equation, whose hypotheses may be unusable.
    fn outcome(&mut self, equation: usize, l: usize, unusable: Option<&str>) -> Outcome {
        let printed = &self.model.equations[equation];
        self.contradiction = None;
        let mut positivity = None;
        let before = self.exact.world().correction(equation).cloned();
        let found = self.bounded_in_all(|checker| {
            let mut positivity = None;
            let verdict = checker.verdict(equation, l, unusable, &mut positivity);
            (verdict, checker.conditions(), positivity)
        });
        let (verdict, conditions) = match found {
            Ok((verdict, conditions, found)) => {
                positivity = found;
                (verdict, conditions)
            }
            Err(exhausted) => {
                let reason = self.words_of_exhaustion(exhausted).into();
                (Verdict::Undecided { reason }, Vec::new())
            }
        };
        let assumed = printed.settings.assume.iter().map(|text| text.text.clone());
        let (falls, holds) = match &verdict {
            Verdict::Misprint { .. } | Verdict::Refuted(_) => (true, false),
            Verdict::Holds { .. } | Verdict::HoldsGiven(..) => (false, true),
            Verdict::Undecided { .. } | Verdict::Definition { .. } | Verdict::Recalled { .. } => {
                (false, false)
            }
        };
        let mut after = None;
        if falls || holds {
            let before = before.as_ref().unwrap_or(&printed.display);
            let found = self.bounded(|checker| checker.after(equation, l, before));
            // What holds as printed, too, needs no correction.
            after = found.ok().flatten().filter(|a| falls || !a.true_as_printed);
        }
        let no_correction = matches!(verdict, Verdict::Refuted(_));
        if no_correction && after.as_ref().is_some_and(|after| after.true_as_printed) {
            // Nothing mends it beside the correction of a side: it stays what it is in print.
            let mut there = self.as_printed(&[equation]).only_judging();
            let outcome = there.outcome(equation, l, unusable);
            self.pool = there.pool;
            return outcome;
        }
        Outcome {
            equation,
            member: printed.links[l].member,
            verdict,
            conditions,
            contradiction: self.contradiction.take(),
            positivity,
            after,
            corrected: Vec::new(),
            assumed: assumed.collect(),
            sizes: None,
            instances: vec![self.instance],
            letters: None,
        }
    }
}

/// An evaluator over the rational functions in the model's letters, with the corrected displays of these
/// verdicts in place of the printed ones.
pub(crate) fn corrected<'m>(model: &'m Model, outcomes: &[Outcome]) -> Evaluator<'m, Symbolic> {
    let mut world = evaluate::symbolic(model);
    for outcome in outcomes {
        if let Verdict::Misprint { correction, .. } = &outcome.verdict {
            world = world.corrected(outcome.equation, correction.display.clone());
            if let Some((definition, display)) = &correction.definition {
                world = world.corrected(*definition, display.clone());
            }
        }
    }
    world.evaluator(model.field())
}

/// All tuples of indices in these ranges, the last running fastest.
pub(crate) fn index_tuples(ranges: &[(i64, i64)]) -> Vec<Vec<i64>> {
    let mut tuples = vec![Vec::new()];
    for (from, to) in ranges {
        tuples = tuples
            .into_iter()
            .flat_map(|tuple| {
                (*from..=*to).map(move |i| {
                    let mut longer = tuple.clone();
                    longer.push(i);
                    longer
                })
            })
            .collect();
    }
    tuples
}
