//! The verdict on one link: what it is (a definition, a claim, something recalled), and what shows it.

use super::challenge::is_decided_by_points;
use super::divergent::Comes;
use super::hypotheses::possible::Signs;
use super::identity::{Decision, Insertion};
use super::stationary::EXISTS_FOR_SOME;
use super::{Checker, Told, index_tuples};
use crate::evaluate::{Failure, FailureKind};
use crate::expr::{ExprKind, Relation};
use crate::latex;
use crate::model::links::{Link, Place};
use crate::model::names::{Resolved, literal_number};
use crate::model::{DefinitionKind, Node, Role};
use crate::verdict::{
    CounterProof, Ended, Positivity, Refutation, ResidualEntry, Searched, Verdict,
};
use ratpoly::allowance::Exhausted;

/// The most clauses that the corrected displays of one equation have together, if each of its links has one.
const CORRECTED_CLAUSES: usize = 2_000_000;

impl Checker<'_> {
    /// The verdict on one link, with what shows it.
    pub(super) fn verdict(
        &mut self,
        equation: usize,
        l: usize,
        unusable: Option<&str>,
        positivity: &mut Option<Positivity>,
    ) -> Verdict {
        self.exact.conditions.clear();
        let mut verdict = self.verdict_as_it_is(equation, l, unusable, positivity);
        if let Verdict::Refuted(refutation) = &mut verdict
            && refutation.part.is_some()
            && self.rests_on_partial_covariances(equation, &self.model.equations[equation].links[l])
        {
            refutation.part = None;
        }
        if let Verdict::Refuted(refutation) | Verdict::Misprint { refutation, .. } = &mut verdict {
            refutation.contradicted = self.words_of_broken(equation);
        }
        // Nothing is said of what has no value; a correction was proved to have one.
        let said = match &verdict {
            Verdict::Holds { .. } | Verdict::HoldsGiven(..) | Verdict::Definition { .. } => true,
            Verdict::Refuted(refutation) => refutation.misfit().is_none(),
            Verdict::Misprint { .. } | Verdict::Undecided { .. } | Verdict::Recalled { .. } => {
                false
            }
        };
        match self.vanishing_divisor().filter(|_| said) {
            Some(failure) => {
                *positivity = None;
                self.failed(&failure)
            }
            None if said && self.divides_by_relation() => {
                *positivity = None;
                Verdict::Undecided {
                    reason: "a divisor vanishes under the hypotheses".into(),
                }
            }
            None => verdict,
        }
    }

    fn verdict_as_it_is(
        &mut self,
        equation: usize,
        l: usize,
        unusable: Option<&str>,
        positivity: &mut Option<Positivity>,
    ) -> Verdict {
        let model = self.model;
        let printed = &model.equations[equation];
        let link = &printed.links[l];
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
            let unknowns = self.model.systems.iter().enumerate();
            let unknowns = unknowns.filter(|(_, s)| s.equation == equation);
            let nodes = unknowns.flat_map(|(system, s)| {
                (0..s.unknowns.len()).map(move |position| Node::Unknown { system, position })
            });
            self.once(nodes.collect(), |c| c.solved(equation))
        } else if let Some(definition) = printed.defines[l] {
            // Of a family a member may be too dear and the others not.
            let nodes = match self.model.definitions[definition].kind {
                DefinitionKind::Family { .. } => Vec::new(),
                DefinitionKind::Whole
                | DefinitionKind::Power(_)
                | DefinitionKind::ValueAt(_)
                | DefinitionKind::Element(_) => vec![Node::Definition(definition)],
            };
            self.misscoped(equation, link)
                .unwrap_or_else(|| self.once(nodes, |c| c.definition(definition)))
        } else if printed.role == Role::Define && self.is_range(equation, link) {
            Verdict::Definition {
                what: "the range in which it is meant".into(),
            }
        } else if link.left == link.right {
            self.bare(equation, link)
        } else if let Some(reason) = self.unwritten(equation, link) {
            Verdict::Undecided {
                reason: reason.into(),
            }
        } else if self.integrates_over_existence(equation, link) {
            Verdict::Undecided {
                reason: EXISTS_FOR_SOME.into(),
            }
        } else if link.relation == Relation::Tends {
            self.exactly(|c| {
                let verdict = c.tends(equation, link);
                c.where_covariances_exist(equation, link, verdict)
            })
        } else if self.is_circular(equation, l) {
            Verdict::Undecided {
                reason: "the claim is one of its hypotheses: nothing is left to show".into(),
            }
        } else if self.is_only_proved(equation, link) {
            self.proved_only(equation, link, positivity)
        } else if link.relation != Relation::Equal {
            let verdict = self.exactly(|c| match c.inequality(equation, link, positivity) {
                Verdict::Refuted(mut refutation) => c
                    .under_stated(equation, link, &mut refutation)
                    .unwrap_or(Verdict::Refuted(refutation)),
                verdict => verdict,
            });
            let verdict = self.second_opinion(equation, link, verdict);
            self.where_quantities_are_free(equation, link, verdict)
        } else {
            let verdict = self.exactly(|c| c.claim(equation, link));
            let verdict = self.second_opinion(equation, link, verdict);
            self.where_quantities_are_free(equation, link, verdict)
        }
    }

    /// The same for what gives these nodes their values: where these are too dear, what rests on them does
    /// not try it again.
    fn once(&mut self, nodes: Vec<Node>, decide: impl FnOnce(&mut Self) -> Verdict) -> Verdict {
        self.bounded(decide).unwrap_or_else(|exhausted| {
            let what = self.words_of_exhaustion(exhausted);
            let kind = FailureKind::Exhausted { what: what.into() };
            if exhausted != Exhausted::Interrupted {
                for node in nodes {
                    self.has_no_value(node, kind.clone());
                }
            }
            Verdict::Undecided {
                reason: what.into(),
            }
        })
    }

    /// What the exact engine finds within its allowance: beyond it the link is undecided, and a second
    /// route may still find a point.
    pub(super) fn exactly(&mut self, decide: impl FnOnce(&mut Self) -> Verdict) -> Verdict {
        self.bounded(decide)
            .unwrap_or_else(|exhausted| Verdict::Undecided {
                reason: self.words_of_exhaustion(exhausted).into(),
            })
    }

    /// What stands once a second route has looked at a verdict: what is proved true unless it is
    /// contradicted, and what could not be decided unless a point shows it false.
    fn second_opinion(&mut self, equation: usize, link: &Link, verdict: Verdict) -> Verdict {
        match verdict {
            Verdict::Undecided { .. }
                if self.contradiction.is_none() && is_decided_by_points(link.relation) =>
            {
                match self.violated(equation, link) {
                    Some(refutation) => Verdict::Refuted(refutation),
                    None => self
                        .bounded(|c| c.ordered_by_cases(equation, link))
                        .ok()
                        .flatten()
                        .or_else(|| self.in_cartesian_form(equation, link))
                        .or_else(|| {
                            let reason = self.words_of_broken(equation)?;
                            Some(Verdict::Undecided { reason })
                        })
                        .unwrap_or(verdict),
                }
            }
            Verdict::Refuted(refutation) if link.relation != Relation::Equal => {
                match self.confirmed(equation, link, refutation) {
                    Ok(refutation) => Verdict::Refuted(refutation),
                    Err(reason) => Verdict::Undecided { reason },
                }
            }
            verdict => self.challenged(equation, link, verdict),
        }
    }

    /// A definition is right if it has a value.
    pub(super) fn definition(&mut self, definition: usize) -> Verdict {
        let model = self.model;
        let d = &model.definitions[definition];
        let span = model.equations[d.equation].span;
        let indices: Vec<Vec<i64>> = match &d.kind {
            DefinitionKind::Family { ranges, .. } => index_tuples(ranges),
            _ => vec![Vec::new()],
        };
        for tuple in indices {
            let key = (Node::Definition(definition), tuple, 0);
            let value = match model.exceptions(definition).is_empty() {
                true => self.exact.value_of(key, span).map(|_| ()),
                false => self.exact.defined(definition, span),
            };
            if let Err(failure) = value {
                return self.failed(&failure);
            }
        }
        if let Some(verdict) = self.no_covariance(Node::Definition(definition), d.equation) {
            return verdict;
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
    pub(super) fn solved(&mut self, equation: usize) -> Verdict {
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
                let unknowns = &model.systems[system].unknowns;
                for position in 0..unknowns.len() {
                    let node = Node::Unknown { system, position };
                    if let Some(verdict) = self.no_covariance(node, equation) {
                        return verdict;
                    }
                }
                let names: Vec<String> = unknowns.iter().map(latex::canonical).collect();
                Verdict::Definition {
                    what: names.join(", "),
                }
            }
            Err(failure) => self.failed(&failure),
        }
    }

    /// Whether a link of a definition says between which numbers or letters a letter lies.
    pub(super) fn is_range(&self, equation: usize, link: &Link) -> bool {
        let display = self.exact.display(equation);
        let plain = |place: Place| match place.find(display).map(|e| (e, &e.kind)) {
            Some((_, ExprKind::Infinity)) => true,
            Some((_, ExprKind::Name(name))) => matches!(
                self.model.resolve(name, &|_| false),
                Ok(Resolved::Letter { order: 0, .. })
            ),
            Some((e, _)) => literal_number(e).is_some(),
            None => false,
        };
        link.relation.limits() && plain(link.left) && plain(link.right)
    }

    /// A bare expression such as `a_i, i = 1(1)4` says that these things exist.
    pub(super) fn bare(&mut self, equation: usize, link: &Link) -> Verdict {
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

    pub(super) fn claim(&mut self, equation: usize, link: &Link) -> Verdict {
        let entries = match self.sides(equation, link) {
            Ok(entries) => entries,
            Err(failure) => match &failure.kind {
                FailureKind::Outside { name } => {
                    let refutation = self.refute_outside(equation, link, name.clone());
                    return self.repaired(equation, link, refutation);
                }
                // Shapes that do not fit where the equation itself is printed make it false; a
                // misfit inside of a definition that it uses makes the document unusable.
                FailureKind::Shape { .. } if self.is_printed_in(equation, &failure) => {
                    return match Refutation::of_misfit(&failure) {
                        Some(refutation) => self.repaired(equation, link, refutation),
                        None => self.failed(&failure),
                    };
                }
                // An integral without a value equals nothing that has one.
                FailureKind::Divergent { reason, .. }
                    if self.is_printed_in(equation, &failure)
                        && self.only_one_has_a_value(equation, link) =>
                {
                    let proof = CounterProof::Divergent {
                        reason: reason.clone(),
                    };
                    let refutation = Refutation::by_counter_proof(proof);
                    return self.repaired(equation, link, refutation);
                }
                _ => return self.failed(&failure),
            },
        };
        match self.decide(&entries, equation) {
            Ok(Decision::Holds(by)) => match self.proved(equation, link, &entries, &by, None) {
                Some(proof) => Verdict::Holds {
                    by: by.labels,
                    proof,
                },
                None => unverified(),
            },
            Ok(Decision::Follows(by, given)) => {
                let nothing = Insertion::default();
                match self.proved(equation, link, &[], &nothing, Some(&given)) {
                    Some(proof) => Verdict::Holds {
                        by: by.labels,
                        proof,
                    },
                    None => unverified(),
                }
            }
            Ok(Decision::HoldsGiven(by, given)) => {
                match self.proved(equation, link, &[], &by, Some(&given)) {
                    Some(proof) => Verdict::HoldsGiven(Box::new(given), proof),
                    None => unverified(),
                }
            }
            Ok(decision @ (Decision::Refuted(_) | Decision::False(..))) => {
                let refuted = matches!(decision, Decision::Refuted(_));
                let mut refutation = match self.shown_false(equation, link, decision) {
                    Ok(refutation) => refutation,
                    Err(reason) => {
                        return self
                            .equal_by_cases(equation, link, &entries, refuted)
                            .unwrap_or(Verdict::Undecided { reason });
                    }
                };
                if let Some(verdict) = self.under_stated(equation, link, &mut refutation) {
                    return verdict;
                }
                // What it lacks is a hypothesis; an edit would be an invention.
                if let Some((part, witness)) = self.part(&entries) {
                    // Where a side has no value nothing is shown, nor where what is stated need not hold.
                    let stated = !self.model.equations[equation].given.is_empty();
                    let mut on_part = match stated || self.has_no_value_at(equation, link, &witness)
                    {
                        true => refutation.clone(),
                        false => Refutation::at(witness),
                    };
                    on_part.residual = std::mem::take(&mut refutation.residual);
                    on_part.part = Some(part);
                    return Verdict::Refuted(on_part);
                }
                let before = self.exact.display(equation).clone();
                let verdict = self.repaired(equation, link, refutation);
                self.or_side_relation(equation, link, &before, &entries, verdict)
            }
            Err(reason) => Verdict::Undecided { reason },
        }
    }

    /// Whether one side has a value and the other certainly none, as an integral in it diverges.
    fn only_one_has_a_value(&mut self, equation: usize, link: &Link) -> bool {
        let display = self.exact.display(equation).clone();
        let (Some(left), Some(right)) = (link.left.find(&display), link.right.find(&display))
        else {
            return false;
        };
        matches!(
            (self.comes_to(left), self.comes_to(right)),
            (Some(Comes::ToValue(_)), Some(Comes::ToNone(_)))
                | (Some(Comes::ToNone(_)), Some(Comes::ToValue(_)))
        )
    }

    /// That what is neither positive nor negative under the hypotheses, or in a case, is zero. A point may be
    /// outside of the case that it refutes, and no other refuted entry is looked at.
    fn equal_by_cases(
        &mut self,
        equation: usize,
        link: &Link,
        entries: &[ResidualEntry],
        refuted: bool,
    ) -> Option<Verdict> {
        let mut open = Vec::new();
        for entry in entries.iter().filter(|e| e.left != e.right) {
            let difference = self.spelt_out(&entry.difference())?;
            let beside = self.suppositions_of_case(equation, link, &entry.indices)?;
            if refuted && beside.is_empty() {
                return None;
            }
            open.push((difference, beside));
        }
        if open.is_empty() {
            return None;
        }
        let steps = self.by_cases(&open, Signs::ZERO)?;
        let proof = self.verified(equation, link, steps)?;
        Some(Verdict::Holds {
            by: Vec::new(),
            proof,
        })
    }

    /// Whether a failure's place lies inside of an equation.
    pub(super) fn is_printed_in(&self, equation: usize, failure: &Failure) -> bool {
        let span = self.model.equations[equation].span;
        span.start <= failure.span.start && failure.span.end <= span.end
    }

    /// A refuted link with the correction that the search finds; the corrected display is what
    /// later equations are computed from.
    pub(super) fn repaired(
        &mut self,
        equation: usize,
        link: &Link,
        mut refutation: Refutation,
    ) -> Verdict {
        // Where the document says what is meant instead, nothing is misprinted in the equation.
        let settings = &self.model.equations[equation].settings;
        if !self.options.repair || settings.instead.is_some() {
            return Verdict::Refuted(refutation);
        }
        // Each correction keeps the display that it makes.
        let candidates = self.options.candidates;
        let clauses = self.exact.display(equation).clauses.len();
        if (link.member - 1).saturating_mul(clauses) > CORRECTED_CLAUSES {
            refutation.searched = Some(Searched::none_of(candidates, Ended::Work));
            return Verdict::Refuted(refutation);
        }
        if let Some(tell) = self.tell {
            tell(Told {
                equation,
                member: link.member,
                refutation: &refutation,
            });
        }
        let found = self.bounded(|checker| checker.search(equation, link, candidates));
        let found = found.unwrap_or_else(|exhausted| {
            let ended = match exhausted {
                Exhausted::Steps | Exhausted::Memory => Ended::Work,
                Exhausted::Interrupted => Ended::Interrupted,
            };
            Err(Searched::none_of(candidates, ended))
        });
        match found {
            Ok(correction) => {
                self.correct(equation, correction.display.clone());
                if let Some((definition, display)) = &correction.definition {
                    self.correct(*definition, display.clone());
                }
                // The divisors of the corrected equation are those that must not vanish.
                let _ = self.sides(equation, link);
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

    pub(super) fn failed(&mut self, failure: &Failure) -> Verdict {
        Verdict::Undecided {
            reason: self.reason_of(failure),
        }
    }

    /// Why there is no value, in words; a fault of the document is noted.
    pub(super) fn reason_of(&mut self, failure: &Failure) -> String {
        self.note(failure);
        self.failure = Some(failure.kind.clone());
        words_of_failure(&failure.kind)
    }
}

/// Why there is no value, in words.
pub(crate) fn words_of_failure(kind: &FailureKind) -> String {
    match kind {
        FailureKind::Unsupported { what } => format!("{what} is outside of what is decided"),
        FailureKind::Budget { what } => format!("too many {what}"),
        FailureKind::Exhausted { what } => what.clone(),
        FailureKind::Outside { name } => format!("{name} does not exist"),
        FailureKind::Divergent { reason, .. } => format!("the integral diverges: {reason}"),
        FailureKind::NeedsItself => "a definition needs itself".into(),
        FailureKind::NotLinear => "the equation is not linear in its unknowns".into(),
        FailureKind::Underdetermined => "the unknowns are not determined".into(),
        FailureKind::Inconsistent => "the equations contradict each other".into(),
        FailureKind::DivisionByZero => "no value: it divides by what is zero".into(),
        FailureKind::NotStationary => "no stationary covariance: its system is not stable".into(),
        FailureKind::Shape { .. }
        | FailureKind::Exponent { .. }
        | FailureKind::Ambiguous { .. }
        | FailureKind::Undeclared { .. } => "the document has an error".into(),
    }
}

/// What is said where a certificate does not verify; the outcome says that it is a fault of the program.
pub(super) fn unverified() -> Verdict {
    Verdict::Undecided {
        reason: "what was found to prove it does not verify".into(),
    }
}
