//! Free and bound letters of a definition `f(x) = body`.
//!
//! The argument must be free in the body. Where it is bound by an integral instead, or does not
//! occur while the body applies functions to another letter, the definition does not say what f of
//! x is: the measure of the integration or the argument is misprinted, whatever the functions are.

use super::Checker;
use super::edit::{self, Address, Replacement};
use crate::expr::walk::children;
use crate::expr::{Display, Expr, ExprKind, Name};
use crate::latex;
use crate::model::links::{Link, Place};
use crate::verdict::certificate::Steps;
use crate::verdict::{Changed, Correction, Edit, EditClass, Refutation, Shown, Structure, Verdict};

/// The letters of an expression.
#[derive(Default)]
struct Letters {
    free: Vec<Name>,
    bound: Vec<Name>,
    /// Free letters that functions are applied to.
    applied: Vec<Name>,
}

impl Letters {
    fn collect(&mut self, expr: &Expr, bound: &mut Vec<Name>) {
        let push = |list: &mut Vec<Name>, name: &Name| {
            if !list.contains(name) {
                list.push(name.clone());
            }
        };
        match &expr.kind {
            ExprKind::Name(name) => {
                push(
                    if bound.contains(name) {
                        &mut self.bound
                    } else {
                        &mut self.free
                    },
                    name,
                );
            }
            ExprKind::Integral {
                limits,
                body,
                variable,
            } => {
                for limit in limits.iter().flat_map(|(from, to)| [from, to]) {
                    self.collect(limit, bound);
                }
                push(&mut self.bound, variable);
                bound.push(variable.clone());
                self.collect(body, bound);
                bound.pop();
            }
            _ => {
                if let ExprKind::Apply { arguments, .. } = &expr.kind {
                    for argument in arguments {
                        if let ExprKind::Name(name) = &argument.kind
                            && !bound.contains(name)
                        {
                            push(&mut self.applied, name);
                        }
                    }
                }
                for child in children(expr) {
                    self.collect(child, bound);
                }
            }
        }
    }
}

/// What is wrong with the letters of `left = body`, if anything is.
pub(super) fn flaw(left: &Expr, body: &Expr) -> Option<Structure> {
    let ExprKind::Apply { arguments, .. } = &left.kind else {
        return None;
    };
    let [argument] = arguments.as_slice() else {
        return None;
    };
    let ExprKind::Name(argument) = &argument.kind else {
        return None;
    };
    let mut letters = Letters::default();
    letters.collect(body, &mut Vec::new());
    let bound = letters.bound.contains(argument);
    if letters.free.contains(argument) || !bound && letters.applied.is_empty() {
        return None;
    }
    let free = if bound {
        &letters.free
    } else {
        &letters.applied
    };
    Some(Structure::Scope {
        argument: latex::canonical(argument),
        bound,
        free: free.iter().map(latex::canonical).collect(),
    })
}

impl Checker<'_> {
    /// The verdict on a definition whose letters do not fit, if they do not.
    pub(super) fn misscoped(&mut self, equation: usize, link: &Link) -> Option<Verdict> {
        let display = self.exact.display(equation).clone();
        let flaw_of = |display: &Display| flaw(link.left.find(display)?, link.right.find(display)?);
        let flaw = flaw_of(&display)?;
        let refutation = Refutation::by_structure(flaw);
        let mut candidates = edit::measures(&display, &[link.right]);
        candidates.extend(arguments(&display, link.left, &refutation));
        let tried = candidates.len();
        let mended: Vec<(Display, Vec<Edit>)> = candidates
            .iter()
            .filter_map(|candidate| {
                let mut corrected = display.clone();
                candidate.apply(&mut corrected);
                let edits = vec![candidate.describe(&display)?];
                flaw_of(&corrected).is_none().then_some((corrected, edits))
            })
            .collect();
        let mut mended = self
            .fitting_units_best(equation, mended, |(corrected, _)| corrected)
            .into_iter();
        let Some((corrected, edits)) = mended.next() else {
            return Some(Verdict::Refuted(refutation));
        };
        let alternatives = mended.map(|(_, edits)| edits).collect();
        let mut trial = self.corrected(equation, corrected.clone());
        let Some(proof) = trial.verified(equation, link, Steps::Scope) else {
            return Some(Verdict::Refuted(refutation));
        };
        self.adopt(trial);
        Some(Verdict::Misprint {
            refutation,
            correction: Box::new(Correction {
                edits,
                display: corrected,
                definition: None,
                changed: vec![Changed::Right],
                cost: edit::cost_of(EditClass::Measure),
                given: None,
                proof,
                tried,
                budget: tried,
                others: Vec::new(),
                preferred: None,
                unjudged: 0,
                alternatives,
                rejected: Vec::new(),
            }),
        })
    }
}

/// Another letter as the argument on the left.
fn arguments(display: &Display, left: Place, refutation: &Refutation) -> Vec<Replacement> {
    let Shown::Structure(Structure::Scope { free, bound, .. }) = refutation.shown() else {
        return Vec::new();
    };
    let Some(ExprKind::Apply { .. }) = left.find(display).map(|e| &e.kind) else {
        return Vec::new();
    };
    if *bound {
        return Vec::new();
    }
    free.iter()
        .filter_map(|name| latex::parse_name(name, 0).ok())
        .map(|name| Replacement {
            address: Address {
                place: left,
                path: vec![0],
            },
            class: EditClass::Letter,
            change: edit::Change::Whole(ExprKind::Name(name)),
            cost: edit::cost_of(EditClass::Letter),
        })
        .collect()
}
