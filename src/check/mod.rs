//! Verdicts on the links of a model.
//!
//! Equations are settled in the order of their dependencies, so that what a misprint would spoil
//! further down is computed from the corrected equation: slips do not cascade. No float is used
//! here, no verdict depends on what the author expects, and nothing unknown counts as true.

mod after;
mod conditions;
mod definite;
pub mod edit;
pub mod effect;
mod hypotheses;
mod identity;
mod instances;
mod limits;
mod part;
mod relations;
mod repair;
mod scope;
mod sides;
mod statement;
mod stationary;
pub(crate) mod trial;
mod units;
mod witness;

use crate::diagnostic::Diagnostic;
use crate::domain::{Domain, Symbolic};
use crate::evaluate::{Evaluator, Failure, FailureKind, Value};
use crate::expr::{ExprKind, Relation};
use crate::latex;
use crate::model::links::{Link, Place};
use crate::model::names::Resolved;
use crate::model::{DefinitionKind, Letter, Model, Node, Role};
use crate::verdict::statement::StatementOutcome;
use crate::verdict::{Certificate, Outcome, Positivity, Refutation, Verdict};
use identity::Decision;
use num_traits::Signed;
use ratpoly::RationalFunction;
use std::collections::BTreeMap;

/// How much is spent.
#[derive(Clone, Copy, Debug)]
pub struct Options {
    /// Whether corrections are searched for.
    pub repair: bool,
    /// The largest number of candidates that the search looks at for one link.
    pub candidates: usize,
    /// How many threads sift candidates; the results do not depend on it.
    pub threads: usize,
}

impl Default for Options {
    fn default() -> Self {
        Options {
            repair: true,
            candidates: 2_000_000,
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
    /// For each letter that is an abbreviation, its value in the declared symbols.
    pub(crate) inserted: BTreeMap<usize, RationalFunction>,
    diagnostics: Vec<Diagnostic>,
    readings: units::KnownReadings,
    /// Whether one slip in a definition is sought that explains several false claims.
    in_definitions: bool,
    /// Why the last link that was looked at stayed undecided, where its evaluation failed.
    failure: Option<FailureKind>,
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
    let mut verdicts = Checker::new(model, options)?.run()?;
    // A correction serves all instances: one of a definition that the first has none of serves none.
    let in_definitions = verdicts.links.iter().any(|outcome| {
        matches!(&outcome.verdict, Verdict::Misprint { correction, .. } if correction.definition.is_some())
    });
    for instance in 1..model.instances.len() {
        let mut checker = Checker::in_instance(model, options, instance)?;
        checker.in_definitions = in_definitions;
        verdicts = instances::all(verdicts, checker.run()?);
    }
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
        let mut checker = Checker {
            model,
            exact: symbolic(model).in_instance(instance),
            instance,
            options,
            inserted: BTreeMap::new(),
            diagnostics: Vec::new(),
            readings: Default::default(),
            in_definitions: true,
            failure: None,
        };
        checker.insert_abbreviations();
        if checker.diagnostics.is_empty() {
            Ok(checker)
        } else {
            Err(checker.diagnostics)
        }
    }

    /// Computes the values of all abbreviations in the declared symbols.
    fn insert_abbreviations(&mut self) {
        let model = self.model;
        self.inserted.clear();
        let mut expanding = self.exact.anew();
        expanding.keep_abbreviations = false;
        for (letter, kind) in model.letters.iter().enumerate() {
            if let Letter::Abbreviation { definition } = kind {
                let node = (Node::Definition(*definition), Vec::new(), 0);
                let span = model.equations[model.definitions[*definition].equation].span;
                match expanding.value_of(node, span) {
                    Ok(Value::Scalar(value)) => {
                        self.inserted.insert(letter, value);
                    }
                    Ok(_) => {}
                    Err(failure) => self.note(&failure),
                }
            }
        }
    }

    /// Settles all equations, and the statements once all corrections are known; the outcomes are
    /// in the order of the document.
    ///
    /// # Errors
    /// As [`check`].
    pub fn run(mut self) -> Result<Verdicts, Vec<Diagnostic>> {
        let mut outcomes = Vec::new();
        for equation in self.model.settling_order() {
            outcomes.extend(self.settle(equation));
        }
        if self.in_definitions {
            self.common_definitions(&mut outcomes);
        }
        self.explained_by_definitions(&mut outcomes);
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

    fn note(&mut self, failure: &Failure) {
        self.diagnostics.extend(failure.diagnostic());
    }

    /// The outcomes of an equation's links, under the hypotheses that are printed around it.
    fn settle(&mut self, equation: usize) -> Vec<Outcome> {
        let model = self.model;
        let printed = &model.equations[equation];
        if printed.assume.is_empty() {
            return self.settle_links(equation, None);
        }
        match self.under_hypotheses(equation) {
            Err(reason) => self.settle_links(equation, Some(&reason)),
            Ok(hypotheses) => {
                let free = std::mem::replace(&mut self.exact, hypotheses.exact);
                let inserted = std::mem::replace(&mut self.inserted, hypotheses.inserted);
                let outcomes = self.settle_links(equation, None);
                let under = std::mem::replace(&mut self.exact, free);
                self.inserted = inserted;
                if let Some((_, display)) = under.corrections().find(|(e, _)| **e == equation) {
                    self.exact.correct(equation, display.clone());
                }
                outcomes
            }
        }
    }

    fn settle_links(&mut self, equation: usize, unusable: Option<&str>) -> Vec<Outcome> {
        let links = self.model.equations[equation].links.len();
        (0..links)
            .map(|l| self.outcome(equation, l, unusable))
            .collect()
    }

    /// What is found out about one link of an equation, whose hypotheses may be unusable.
    fn outcome(&mut self, equation: usize, l: usize, unusable: Option<&str>) -> Outcome {
        let printed = &self.model.equations[equation];
        let mut certificate = Certificate::default();
        let mut positivity = None;
        let before = self.exact.display(equation).clone();
        let verdict = self.verdict(equation, l, unusable, &mut certificate, &mut positivity);
        debug_assert!(certificate.verify(), "a certificate that does not verify");
        let conditions = self.conditions();
        let assumed = printed.settings.assume.iter().map(|text| text.text.clone());
        let after = match &verdict {
            Verdict::Misprint { .. } | Verdict::Refuted(_) => self.after(equation, l, &before),
            _ => None,
        };
        Outcome {
            equation,
            member: printed.links[l].member,
            verdict,
            conditions,
            certificate,
            positivity,
            after,
            assumed: assumed.collect(),
            instances: vec![self.instance],
        }
    }

    /// The verdict on one link, with what shows it.
    fn verdict(
        &mut self,
        equation: usize,
        l: usize,
        unusable: Option<&str>,
        certificate: &mut Certificate,
        positivity: &mut Option<Positivity>,
    ) -> Verdict {
        let model = self.model;
        let printed = &model.equations[equation];
        let link = &printed.links[l];
        self.exact.conditions.clear();
        if let Role::Recall(reason) = &printed.role {
            Verdict::Recalled {
                reason: reason.clone(),
            }
        } else if let Some(reason) = printed.settings.recalled_members.get(&link.member) {
            Verdict::Recalled {
                reason: reason.text.clone(),
            }
        } else if let Some(reason) = unusable {
            Verdict::Undecided {
                reason: reason.into(),
            }
        } else if printed.role == Role::Solve {
            self.solved(equation)
        } else if let Some(definition) = printed.defines[l] {
            self.misscoped(equation, link)
                .unwrap_or_else(|| self.definition(definition))
        } else if printed.role == Role::Define && self.is_range(equation, link) {
            Verdict::Definition {
                what: "the range in which it is meant".into(),
            }
        } else if link.left == link.right {
            self.bare(equation, link)
        } else if link.relation == Relation::Tends {
            self.tends(equation, link)
        } else if link.relation != Relation::Equal {
            self.inequality(equation, link, positivity)
        } else {
            self.claim(equation, link, certificate)
        }
    }

    /// A definition is right if it has a value.
    fn definition(&mut self, definition: usize) -> Verdict {
        let model = self.model;
        let d = &model.definitions[definition];
        let span = model.equations[d.equation].span;
        let indices: Vec<Vec<i64>> = match &d.kind {
            DefinitionKind::Family { ranges, .. } => index_tuples(ranges),
            _ => vec![Vec::new()],
        };
        for tuple in indices {
            let key = (Node::Definition(definition), tuple, 0);
            if let Err(failure) = self.exact.value_of(key, span) {
                return self.failed(&failure);
            }
        }
        let mut what = latex::canonical(&d.name);
        match &d.kind {
            DefinitionKind::Power(n) => what = format!("{what}^{n}"),
            DefinitionKind::ValueAt(at) => what = format!("{what}({at})"),
            _ => {}
        }
        Verdict::Definition { what }
    }

    /// A `solve` block is right if its unknowns are determined.
    fn solved(&mut self, equation: usize) -> Verdict {
        let model = self.model;
        let span = model.equations[equation].span;
        let Some(system) = model.systems.iter().position(|s| s.equation == equation) else {
            return Verdict::Undecided {
                reason: "no unknowns are named".into(),
            };
        };
        let key = (
            Node::Unknown {
                system,
                position: 0,
            },
            Vec::new(),
            0,
        );
        match self.exact.value_of(key, span) {
            Ok(_) => {
                if let Some(flaw) = self.instability(system) {
                    return Verdict::Refuted(Refutation {
                        flaw: Some(flaw),
                        ..Refutation::default()
                    });
                }
                let unknowns = &model.systems[system].unknowns;
                let names: Vec<String> = unknowns.iter().map(latex::canonical).collect();
                Verdict::Definition {
                    what: names.join(", "),
                }
            }
            Err(failure) => self.failed(&failure),
        }
    }

    /// Whether a link of a definition says between which numbers or letters a letter lies.
    fn is_range(&self, equation: usize, link: &Link) -> bool {
        let display = self.exact.display(equation);
        let plain = |place: Place| match place.find(display).map(|e| &e.kind) {
            Some(ExprKind::Number(_) | ExprKind::Infinity) => true,
            Some(ExprKind::Name(name)) => matches!(
                self.model.resolve(name, &|_| false),
                Ok(Resolved::Letter { order: 0, .. })
            ),
            _ => false,
        };
        let order = matches!(
            link.relation,
            Relation::Less | Relation::LessEqual | Relation::Greater | Relation::GreaterEqual
        );
        order && plain(link.left) && plain(link.right)
    }

    /// Whether a function of positive letters is negative by the signs of its coefficients.
    fn is_negative(&self, function: &RationalFunction) -> bool {
        let letters = self.exact.field.letters(function);
        letters.iter().all(|l| self.model.is_positive(*l))
            && function.numerator().terms().all(|(_, c)| c.is_negative())
            && function.denominator().terms().all(|(_, c)| c.is_positive())
    }

    /// A bare expression such as `a_i, i = 1(1)4` says that these things exist.
    fn bare(&mut self, equation: usize, link: &Link) -> Verdict {
        match self.sides(equation, link) {
            Ok(_) => Verdict::Definition {
                what: link
                    .left
                    .find(self.exact.display(equation))
                    .map_or_else(String::new, latex::write_expr),
            },
            Err(failure) => self.failed(&failure),
        }
    }

    fn claim(&mut self, equation: usize, link: &Link, certificate: &mut Certificate) -> Verdict {
        let entries = match self.sides(equation, link) {
            Ok(entries) => entries,
            Err(failure) => match &failure.kind {
                FailureKind::Outside { name } => {
                    let refutation = self.refute_outside(equation, link, name.clone());
                    return self.repaired(equation, link, refutation, certificate);
                }
                // Shapes that do not fit where the equation itself is printed make it false; a
                // misfit inside of a definition that it uses makes the document unusable.
                FailureKind::Shape { .. } if self.is_printed_in(equation, &failure) => {
                    let refutation = Refutation::of_misfit(&failure);
                    return self.repaired(equation, link, refutation, certificate);
                }
                _ => return self.failed(&failure),
            },
        };
        match self.decide(&entries, equation) {
            Ok(Decision::Holds(by)) => {
                *certificate = self.certificate(entries, &by, None);
                Verdict::Holds { by: by.labels }
            }
            Ok(Decision::HoldsGiven(by, given)) => {
                let not_identical = given.cofactors.iter().map(|g| g.entry.clone()).collect();
                *certificate = self.certificate(not_identical, &by, Some(&given));
                Verdict::HoldsGiven(Box::new(given))
            }
            Ok(Decision::Refuted(mut refutation)) => match self.part(&entries) {
                // What it lacks is a hypothesis; an edit would be an invention.
                Some((part, witness)) => {
                    refutation.part = Some(part);
                    refutation.witness = Some(witness);
                    Verdict::Refuted(refutation)
                }
                None => self.repaired(equation, link, refutation, certificate),
            },
            Ok(Decision::False(..)) => Verdict::Undecided {
                reason: "the sides differ, and nothing shows where".into(),
            },
            Err(reason) => Verdict::Undecided { reason },
        }
    }

    /// Whether a failure's place lies inside of an equation.
    fn is_printed_in(&self, equation: usize, failure: &Failure) -> bool {
        let span = self.model.equations[equation].span;
        span.start <= failure.span.start && failure.span.end <= span.end
    }

    fn certificate(
        &self,
        entries: Vec<crate::verdict::ResidualEntry>,
        by: &identity::Insertion,
        given: Option<&crate::verdict::Given>,
    ) -> Certificate {
        let functions = self.model.functions.as_ref();
        let mut inserted = by.letters.clone();
        if let Some(table) = functions {
            let needed = entries
                .iter()
                .flat_map(|e| [&e.left, &e.right])
                .flat_map(|side| table.letters_behind(side))
                .collect();
            if let Ok(all) = table.extended(&inserted, &needed) {
                inserted = all;
            }
        }
        Certificate {
            quadratics: functions.map_or_else(Vec::new, |table| table.quadratics().to_vec()),
            entries,
            inserted,
            relations: given.map_or_else(Vec::new, |g| g.relations.clone()),
            cofactors: given.map_or_else(Vec::new, |g| {
                g.cofactors.iter().map(|c| c.cofactors.clone()).collect()
            }),
        }
    }

    /// A refuted link with the correction that the search finds; the corrected display is what
    /// later equations are computed from.
    fn repaired(
        &mut self,
        equation: usize,
        link: &Link,
        mut refutation: Refutation,
        certificate: &mut Certificate,
    ) -> Verdict {
        // Where the document says what is meant instead, nothing is misprinted in the equation.
        let settings = &self.model.equations[equation].settings;
        if !self.options.repair || settings.instead.is_some() {
            return Verdict::Refuted(refutation);
        }
        match self.search(equation, link, self.options.candidates) {
            Ok((correction, proof)) => {
                *certificate = proof;
                self.exact.correct(equation, correction.display.clone());
                if let Some((definition, display)) = &correction.definition {
                    self.exact.correct(*definition, display.clone());
                }
                let definitions = &self.model.definitions;
                let defines = definitions.iter().any(|d| d.equation == equation);
                if defines || correction.definition.is_some() {
                    // It was computed so before the correction was accepted.
                    let _ = self.insert_anew();
                }
                Verdict::Misprint {
                    refutation,
                    correction: Box::new(correction),
                }
            }
            Err(searched) => {
                refutation.searched = Some(searched);
                Verdict::Refuted(refutation)
            }
        }
    }

    fn failed(&mut self, failure: &Failure) -> Verdict {
        Verdict::Undecided {
            reason: self.reason_of(failure),
        }
    }

    /// Why there is no value, in words; a fault of the document is noted.
    fn reason_of(&mut self, failure: &Failure) -> String {
        self.note(failure);
        self.failure = Some(failure.kind.clone());
        match &failure.kind {
            FailureKind::Unsupported { what } => format!("{what} is outside of what is decided"),
            FailureKind::Budget { what } => format!("too many {what}"),
            FailureKind::Outside { name } => format!("{name} does not exist"),
            FailureKind::Divergent { reason, .. } => format!("the integral diverges: {reason}"),
            FailureKind::NeedsItself => "a definition needs itself".into(),
            FailureKind::NotLinear => "the equation is not linear in its unknowns".into(),
            FailureKind::Underdetermined => "the unknowns are not determined".into(),
            FailureKind::Inconsistent => "the equations contradict each other".into(),
            _ => "the document has an error".into(),
        }
    }
}

/// An evaluator over the rational functions in the model's letters.
pub(crate) fn symbolic(model: &Model) -> Evaluator<'_, Symbolic> {
    let letters = (0..model.letters.len())
        .map(|i| RationalFunction::variable(model.ring, i))
        .collect();
    Evaluator::new(model, model.field(), letters)
}

/// The same with the corrected displays of these verdicts in place of the printed ones.
pub(crate) fn corrected<'m>(model: &'m Model, outcomes: &[Outcome]) -> Evaluator<'m, Symbolic> {
    let mut exact = symbolic(model);
    for outcome in outcomes {
        if let Verdict::Misprint { correction, .. } = &outcome.verdict {
            exact.correct(outcome.equation, correction.display.clone());
            if let Some((definition, display)) = &correction.definition {
                exact.correct(*definition, display.clone());
            }
        }
    }
    exact
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

impl Model {
    /// The equations, each after those whose definitions it uses; otherwise in the order of the
    /// document.
    pub fn settling_order(&self) -> Vec<usize> {
        let mut order = Vec::new();
        let mut seen = vec![false; self.equations.len()];
        for equation in 0..self.equations.len() {
            self.settle_before(equation, &mut seen, &mut order);
        }
        order
    }

    fn settle_before(&self, equation: usize, seen: &mut [bool], order: &mut Vec<usize>) {
        if std::mem::replace(&mut seen[equation], true) {
            return;
        }
        let mut nodes = std::collections::BTreeSet::new();
        let mut pending = Vec::new();
        self.each_member(equation, &mut |e| self.collect(e, &mut nodes));
        pending.extend(nodes.iter().copied());
        while let Some(node) = pending.pop() {
            match node {
                Node::Definition(d) => {
                    self.settle_before(self.definitions[d].equation, seen, order);
                }
                Node::Unknown { system, .. } => {
                    self.settle_before(self.systems[system].equation, seen, order);
                }
                Node::Notation(_) | Node::Symbol(_) | Node::Matrix(_) => {
                    for next in self.needs(node) {
                        if nodes.insert(next) {
                            pending.push(next);
                        }
                    }
                }
            }
        }
        order.push(equation);
    }

    fn each_member(&self, equation: usize, see: &mut dyn FnMut(&crate::expr::Expr)) {
        let display = &self.equations[equation].display;
        let mut places: Vec<Place> = Vec::new();
        for link in &self.equations[equation].links {
            places.extend([link.left, link.right]);
        }
        places.sort_unstable();
        places.dedup();
        for expr in places.iter().filter_map(|p| p.find(display)) {
            see(expr);
        }
    }
}
