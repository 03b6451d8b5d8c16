//! What a verdict says of sizes that it was not found for.
//!
//! A document names sizes by letters, f, and the numbers that these have: each claim is checked for
//! each. That proves it for these numbers and no others: `\det(-\mathbf M) = \det\mathbf M` for even f
//! only. What depends on a size and holds says for which it was seen; one number, or numbers of one
//! parity, show nothing of the rest, and the claim stays undecided. What has a proof free of sizes
//! ([`words`]) holds plainly.

use super::{Verdicts, words};
use crate::document::VerdictWord;
use crate::expr::walk::visit;
use crate::expr::{Display, Expr, ExprKind, Relation};
use crate::latex;
use crate::model::links::Place;
use crate::model::{Hypothesis, Model, Node, NotationKind};
use crate::verdict::{Outcome, Verdict};
use std::collections::{BTreeMap, BTreeSet};

/// Says of each link and each statement that holds for which sizes it does.
pub(super) fn name(model: &Model, verdicts: &mut Verdicts) {
    if model.instances.iter().all(|instance| instance.is_empty()) {
        return;
    }
    let corrected = corrections(&verdicts.links);
    for outcome in &mut verdicts.links {
        of_link(model, &corrected, outcome);
    }
    for outcome in &mut verdicts.statements {
        let true_ = matches!(outcome.word, VerdictWord::Holds | VerdictWord::Loose);
        let proposition = model.statements[outcome.statement]
            .propositions
            .get(outcome.member - 1);
        let Some(proposition) = proposition.filter(|_| true_) else {
            continue;
        };
        let letters = model.size_letters(&proposition.expressions().collect::<Vec<_>>());
        let all: Vec<usize> = (0..model.instances.len()).collect();
        if let Some(reason) = too_few(model, &letters, &all) {
            outcome.word = VerdictWord::Undecided;
            outcome.loose = None;
            outcome.reason = Some(reason);
        }
    }
}

/// The displays that stand in place of misprinted ones.
fn corrections(outcomes: &[Outcome]) -> BTreeMap<usize, Display> {
    let mut corrected = BTreeMap::new();
    for outcome in outcomes {
        if let Verdict::Misprint { correction, .. } = &outcome.verdict {
            corrected.insert(outcome.equation, correction.display.clone());
            if let Some((definition, display)) = &correction.definition {
                corrected.insert(*definition, display.clone());
            }
        }
    }
    corrected
}

fn of_link(model: &Model, corrected: &BTreeMap<usize, Display>, outcome: &mut Outcome) {
    let true_ = match &outcome.verdict {
        Verdict::Holds { .. } | Verdict::HoldsGiven(..) => true,
        Verdict::Misprint { .. }
        | Verdict::Refuted(_)
        | Verdict::Undecided { .. }
        | Verdict::Definition { .. }
        | Verdict::Recalled { .. } => false,
    };
    if !true_ {
        return;
    }
    let letters = model.sizes_behind(outcome.equation, outcome.member);
    if letters.is_empty() {
        return;
    }
    let printed = &model.equations[outcome.equation];
    let display = corrected.get(&outcome.equation).unwrap_or(&printed.display);
    let link = printed.links.iter().find(|l| l.member == outcome.member);
    let any = |link| words::hold_for_any_size(model, corrected, display, link);
    let link = link.filter(|l| l.relation == Relation::Equal);
    if matches!(outcome.verdict, Verdict::Holds { .. }) && link.is_some_and(any) {
        return;
    }
    match too_few(model, &letters, &outcome.instances) {
        Some(reason) => outcome.verdict = Verdict::Undecided { reason },
        None => outcome.sizes = Some(outcome.instances.clone()),
    }
}

/// Why these instances show nothing of other sizes: a letter without an odd or an even value.
fn too_few(model: &Model, letters: &BTreeSet<String>, instances: &[usize]) -> Option<String> {
    letters.iter().find_map(|letter| {
        let mut values: Vec<usize> = instances
            .iter()
            .filter_map(|i| model.instances.get(*i)?.get(letter).copied())
            .collect();
        values.sort_unstable();
        values.dedup();
        let even = values.iter().any(|n| n.is_multiple_of(2));
        let odd = values.iter().any(|n| !n.is_multiple_of(2));
        let shown: Vec<String> = values.iter().map(ToString::to_string).collect();
        (!(even && odd)).then(|| {
            format!(
                "true for {letter} = {}, which proves nothing of other sizes: name an even and an odd one, such as {letter} = [2, 3]",
                shown.join(", ")
            )
        })
    })
}

impl Model {
    /// The letters for sizes that a link depends on, through all definitions and hypotheses.
    pub(crate) fn sizes_behind(&self, equation: usize, member: usize) -> BTreeSet<String> {
        let printed = &self.equations[equation];
        let Some(link) = printed.links.iter().find(|l| l.member == member) else {
            return BTreeSet::new();
        };
        let mut expressions: Vec<&Expr> = Vec::new();
        let at = |place: Place| place.find(&printed.display);
        expressions.extend(at(link.left));
        expressions.extend(at(link.right));
        for range in &printed.display.clauses[link.left.clause()].ranges {
            expressions.extend([&range.from, &range.step, &range.to]);
        }
        for Hypothesis { left, right, .. } in printed.assume.iter().chain(&printed.given) {
            expressions.extend([left, right]);
        }
        self.size_letters(&expressions)
    }

    /// The letters for sizes that some expressions depend on.
    pub(crate) fn size_letters(&self, expressions: &[&Expr]) -> BTreeSet<String> {
        let mut letters = BTreeSet::new();
        let mut open = BTreeSet::new();
        for expression in expressions {
            self.named_sizes(expression, &mut letters);
            self.collect(expression, &mut open);
        }
        let mut seen = BTreeSet::new();
        let mut open: Vec<Node> = open.into_iter().collect();
        while let Some(node) = open.pop() {
            if !seen.insert(node) {
                continue;
            }
            open.extend(self.needs(node));
            match node {
                Node::Matrix(m) => {
                    let shape = &self.matrices[m].shape;
                    let sizes = [&shape.rows.letter, &shape.columns.letter];
                    letters.extend(sizes.into_iter().flatten().cloned());
                }
                Node::Notation(n) => match &self.notation[n].kind {
                    NotationKind::Identity(size) => letters.extend(size.letter.clone()),
                    kind => {
                        if let Some(target) = kind.target() {
                            self.named_sizes(target, &mut letters);
                        }
                    }
                },
                Node::Definition(d) => {
                    let definition = &self.definitions[d];
                    let display = &self.equations[definition.equation].display;
                    if let Some(value) = definition.place.find(display) {
                        self.named_sizes(value, &mut letters);
                    }
                }
                Node::Unknown { system, .. } => {
                    let display = &self.equations[self.systems[system].equation].display;
                    for member in display.clauses.iter().flat_map(|c| &c.chain.members) {
                        self.named_sizes(member, &mut letters);
                    }
                }
                Node::Symbol(_) => {}
            }
        }
        letters
    }

    /// The letters for sizes that an expression names.
    fn named_sizes(&self, expression: &Expr, letters: &mut BTreeSet<String>) {
        visit(expression, &mut |e| {
            let name = match &e.kind {
                ExprKind::Name(name) | ExprKind::Apply { function: name, .. } => name,
                _ => return,
            };
            let mut own = vec![latex::canonical(name)];
            for index in name.subscript.iter().flat_map(|s| &s.indices) {
                visit(index, &mut |e| {
                    if let ExprKind::Name(name) = &e.kind {
                        own.push(latex::canonical(name));
                    }
                });
            }
            letters.extend(
                own.into_iter()
                    .filter(|name| self.instances[0].contains_key(name)),
            );
        });
    }
}
