//! One verdict from those of several instances: the common one, otherwise the worst.
//!
//! A correction must serve every instance in which the equation is false.

use super::Verdicts;
use crate::document::VerdictWord;
use crate::verdict::{Correction, Edit, Outcome, Verdict};

/// The verdicts on all links and statements in two sets of instances, taken together.
pub(super) fn all(first: Verdicts, second: Verdicts) -> Verdicts {
    let links = first.links.into_iter().zip(second.links);
    let statements = first.statements.into_iter().zip(second.statements);
    Verdicts {
        links: links.map(|(one, other)| merged(one, other)).collect(),
        statements: statements
            .map(|(one, other)| {
                if badness(other.word) > badness(one.word) {
                    other
                } else {
                    one
                }
            })
            .collect(),
    }
}

/// What is found out about the same link in two sets of instances, taken together.
fn merged(first: Outcome, second: Outcome) -> Outcome {
    let (one, other) = (first.verdict.word(), second.verdict.word());
    if one != other {
        let mut worse = if badness(other) > badness(one) {
            second
        } else {
            first
        };
        // A correction of what is true for another size would spoil it there.
        let right = |word| matches!(word, VerdictWord::Holds | VerdictWord::HoldsGiven);
        if let Verdict::Misprint { refutation, .. } = &worse.verdict
            && (right(one) || right(other))
        {
            worse.verdict = Verdict::Refuted(refutation.clone());
        }
        return worse;
    }
    let mut both = first.clone();
    both.instances.extend(&second.instances);
    for condition in second.conditions {
        if !both.conditions.contains(&condition) {
            both.conditions.push(condition);
        }
    }
    match (first.verdict, second.verdict) {
        (
            Verdict::Misprint {
                refutation,
                correction: small,
            },
            Verdict::Misprint {
                correction: large, ..
            },
        ) => {
            both.verdict = match common(*small, *large) {
                Some((correction, _)) => Verdict::Misprint {
                    refutation,
                    correction: Box::new(correction),
                },
                None => Verdict::Refuted(refutation),
            };
        }
        (
            Verdict::Holds { by, proof },
            Verdict::Holds {
                by: also,
                proof: second,
            },
        ) => {
            let more = also.into_iter().filter(|label| !by.contains(label));
            both.verdict = Verdict::Holds {
                by: by.iter().cloned().chain(more).collect(),
                proof: proof.for_sizes(second),
            };
        }
        (_, Verdict::HoldsGiven(given, proof)) => {
            // The larger instance needs every relation that the smaller one needs.
            both.verdict = Verdict::HoldsGiven(given, proof);
        }
        _ => {}
    }
    both
}

/// How bad a verdict is for an equation; unknown is no pass.
fn badness(word: VerdictWord) -> u8 {
    match word {
        VerdictWord::Definition | VerdictWord::Recalled => 0,
        VerdictWord::Holds => 1,
        VerdictWord::HoldsGiven => 2,
        VerdictWord::Loose => 3,
        VerdictWord::Undecided => 4,
        VerdictWord::Misprint => 5,
        VerdictWord::Refuted => 6,
    }
}

/// The correction that serves both, with the alternatives that do, and whether it is the second's.
fn common(small: Correction, large: Correction) -> Option<(Correction, bool)> {
    let all = |c: &Correction| -> Vec<Vec<Edit>> {
        let first = std::iter::once(c.edits.clone());
        first.chain(c.alternatives.iter().cloned()).collect()
    };
    let (smalls, larges) = (all(&small), all(&large));
    let shared: Vec<Vec<Edit>> = smalls.into_iter().filter(|e| larges.contains(e)).collect();
    let (mut chosen, from_second) = if shared.contains(&small.edits) {
        (small, false)
    } else if shared.contains(&large.edits) {
        (large, true)
    } else {
        return None;
    };
    chosen.alternatives = shared
        .into_iter()
        .filter(|edits| *edits != chosen.edits)
        .collect();
    Some((chosen, from_second))
}
