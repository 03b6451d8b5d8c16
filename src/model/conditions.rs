//! What a claim is said under: the clauses of its display that are conditions and no claims.
//!
//! `x = |y|, \quad y \ge 0` claims one thing and supposes another. A clause is a condition if a word
//! such as "for" or "if" stands before it, or if after an equation and a comma, or in brackets, it only
//! compares declared letters with numbers or each other. Beside at least one claim it becomes a hypothesis
//! of the equation, shown as one; a display of nothing but such clauses claims them. After "so that" and its
//! kin, "and" behind a claim, a full stop or on a line of its own, a clause asserts. Where neither words nor
//! marks decide (a semicolon, another column, a wide space, an equation behind a condition), both readings
//! are given back: a claim that vanished into a hypothesis would prove itself.

use super::build::Builder;
use super::{Hypothesis, Node};
use crate::diagnostic::DiagnosticKind;
use crate::document::Text;
use crate::expr::walk::mentions;
use crate::expr::{Chain, Clause, Display, Expr, ExprKind, Relation, Separation, Sign};
use crate::latex;
use std::sync::Arc;

/// The conditions of a display, taken out of it.
#[derive(Default)]
pub(super) struct Conditions {
    pub hypotheses: Vec<Hypothesis>,
    /// The same as printed.
    pub texts: Vec<Text>,
}

/// What a clause is in its display.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Standing {
    /// A claim.
    Claim,
    /// A claim that only compares letters and numbers, and so looks like a condition.
    Comparison,
    /// A condition, and whether more like it may follow after a comma: an equation, or what a word begins.
    Condition { goes_on: bool },
    /// A condition or a claim.
    Doubtful,
    /// No relation.
    Subject,
}

/// What stands before a clause of a display.
#[derive(Clone, Copy)]
struct Before {
    /// Whether anything is claimed.
    claims: bool,
    /// Whether more than a comparison is claimed.
    equations: bool,
    /// What the last clause with a relation is.
    last: Standing,
}

impl Builder {
    /// Takes the conditions out of the display of a claim.
    pub(super) fn conditions(&mut self, display: &mut Display) -> Conditions {
        let mut found = Conditions::default();
        let clauses = &display.clauses;
        let mut conditional = vec![false; clauses.len()];
        let mut doubtful = Vec::new();
        let mut before = Before {
            claims: false,
            equations: false,
            last: Standing::Subject,
        };
        for (k, clause) in clauses.iter().enumerate() {
            let standing = self.standing(clause, before);
            // `x > 0, \quad |x| = x`: what comes first may be what the rest is said under.
            if standing == Standing::Claim
                && before.last == Standing::Comparison
                && !before.equations
                && leads_on(clause)
            {
                doubtful.push(display.clauses[k - 1].chain.span);
            }
            match standing {
                Standing::Claim => before.equations = true,
                Standing::Condition { .. } => conditional[k] = true,
                Standing::Doubtful => doubtful.push(clause.chain.span),
                Standing::Comparison => {}
                Standing::Subject => continue,
            }
            before.claims |= matches!(standing, Standing::Claim | Standing::Comparison);
            before.last = standing;
        }
        let of_a_line = conditions_of_a_line(clauses, &conditional);
        for span in of_a_line {
            let readings = vec![
                "a condition of what is claimed in its line, written as an equation of its own"
                    .to_owned(),
                "a condition of all that is claimed, written on a line of its own".to_owned(),
            ];
            self.error(DiagnosticKind::Ambiguous { readings }, span);
        }
        for span in doubtful {
            let readings = vec![
                "a condition, written after a word such as `for`".to_owned(),
                "another claim, written as an equation of its own".to_owned(),
            ];
            self.error(DiagnosticKind::Ambiguous { readings }, span);
        }
        let clauses = &display.clauses;
        let claims = before.claims;
        if !claims {
            return found;
        }
        // `a, b > 0`: the letters before the comma share the relation.
        for k in (1..clauses.len()).rev() {
            let shared = conditional[k] && clauses[k].joined.is_none();
            let subject = clauses[k - 1].chain.relations.is_empty()
                && self.is_letter(&clauses[k - 1].chain.members[0]);
            if !(shared && subject && self.is_letter(&clauses[k].chain.members[0])) {
                continue;
            }
            conditional[k - 1] = true;
        }
        for (k, clause) in clauses.iter().enumerate() {
            if !conditional[k] {
                continue;
            }
            let chain = match clause.chain.relations.is_empty() {
                true => match self.shared_relation(&clauses[k..], &conditional[k..]) {
                    Some(chain) => chain,
                    None => continue,
                },
                false => clause.chain.clone(),
            };
            self.two_sided(&clauses[k..]);
            found.texts.push(Text {
                text: latex::write_chain(&chain),
                span: clause.chain.span,
            });
            found.hypotheses.extend(hypotheses(&chain));
        }
        let mut kept = conditional.iter().map(|conditional| !conditional);
        display.clauses.retain(|_| kept.next().unwrap_or(true));
        found
    }

    /// `a > 0` for the `a` of `a, b > 0`.
    fn shared_relation(&self, clauses: &[Arc<Clause>], conditional: &[bool]) -> Option<Chain> {
        let subject = &clauses[0].chain;
        let with = clauses.iter().zip(conditional).skip(1);
        let with = with.take_while(|(_, conditional)| **conditional);
        let related = with.map(|(clause, _)| &clause.chain);
        let related = related.into_iter().find(|c| !c.relations.is_empty())?;
        let mut members = related.members.clone();
        members[0] = subject.members[0].clone();
        Some(Chain {
            members,
            relations: related.relations.clone(),
            span: subject.span.to(related.span),
        })
    }

    /// Refuses `0 < a, b < 1`, which may mean that both lie between.
    fn two_sided(&mut self, clauses: &[Arc<Clause>]) {
        let [first, second, ..] = clauses else {
            return;
        };
        let ends = first.chain.members.last();
        if second.joined.is_none()
            && self.is_order(&first.chain)
            && self.is_order(&second.chain)
            && names_number(&first.chain.members[0])
            && ends.is_some_and(|e| self.is_letter(e))
            && self.is_letter(&second.chain.members[0])
        {
            let readings = vec![
                "one condition on two letters, written apart for each".to_owned(),
                "two conditions, with `and` between them".to_owned(),
            ];
            let span = first.chain.span.to(second.chain.span);
            self.error(DiagnosticKind::Ambiguous { readings }, span);
        }
    }

    fn standing(&self, clause: &Clause, before: Before) -> Standing {
        let chain = &clause.chain;
        if chain.relations.is_empty() {
            return Standing::Subject;
        }
        let (order, plain) = (self.is_order(chain), self.is_plain(chain));
        let equation = chain.relations.iter().all(|r| *r == Relation::Equal);
        let claim = match order && plain {
            true => Standing::Comparison,
            false => Standing::Claim,
        };
        if !order && !equation {
            return claim;
        }
        let behind = matches!(before.last, Standing::Condition { .. });
        match clause.joined.as_deref() {
            Some(word) if latex::is_condition(word) => Standing::Condition { goes_on: true },
            Some("where" | "with") if order && plain => Standing::Condition { goes_on: true },
            Some("where" | "with") if equation && self.is_letter(&chain.members[0]) => {
                Standing::Condition { goes_on: true }
            }
            Some("where" | "with") => claim,
            // What it joins is of one kind.
            Some("and") if behind && (order || plain) => before.last,
            Some("and") if behind && before.claims => Standing::Doubtful,
            Some(_) => claim,
            None => match clause.bracketed && before.claims {
                true if order && plain => Standing::Condition { goes_on: false },
                true => Standing::Doubtful,
                false => self.separated(clause, claim, before),
            },
        }
    }

    /// What a clause is that no word joins to what stands before it.
    fn separated(&self, clause: &Clause, claim: Standing, before: Before) -> Standing {
        let doubtful = match (claim, before.last) {
            // After `b > 0`, `c > 0` is another claim like it, but not where that followed from an equation.
            (Standing::Comparison, Standing::Comparison) => before.equations,
            (Standing::Comparison, _) if !before.equations => false,
            (Standing::Comparison, _) => match clause.separation {
                Separation::Comma => {
                    return Standing::Condition {
                        goes_on: matches!(before.last, Standing::Condition { goes_on: true }),
                    };
                }
                Separation::CommaAndLine | Separation::Space | Separation::Semicolon => true,
                Separation::None | Separation::Line | Separation::FullStop => false,
            },
            (_, Standing::Condition { goes_on }) => {
                before.claims
                    && (goes_on || self.is_order(&clause.chain) || self.is_plain(&clause.chain))
            }
            (_, _) => false,
        };
        let ended = matches!(clause.separation, Separation::Line | Separation::FullStop);
        match doubtful && !ended {
            true => Standing::Doubtful,
            false => claim,
        }
    }

    /// Whether all its relations compare by size.
    fn is_order(&self, chain: &Chain) -> bool {
        !chain.relations.is_empty()
            && chain.relations.iter().all(|relation| match relation {
                Relation::Less
                | Relation::LessEqual
                | Relation::Greater
                | Relation::GreaterEqual
                | Relation::NotEqual => true,
                Relation::Equal
                | Relation::Distributed
                | Relation::Approximately
                | Relation::Tends => false,
            })
    }

    /// Whether only declared letters and numbers are compared.
    fn is_plain(&self, chain: &Chain) -> bool {
        let plain = |e: &Expr| self.is_letter(e) || names_number(e);
        chain.members.iter().all(plain) && chain.members.iter().any(|e| self.is_letter(e))
    }

    /// Whether the expression is a declared letter.
    fn is_letter(&self, expr: &Expr) -> bool {
        let ExprKind::Name(name) = &expr.kind else {
            return false;
        };
        matches!(
            self.names.whole.get(&latex::canonical(name)),
            Some(Node::Symbol(_))
        )
    }

    /// Refuses a range beside several definitions: it may be meant for one of them or for all.
    pub(super) fn refuse_shared_ranges(&mut self, display: &Display) {
        let clauses = &display.clauses;
        for clause in clauses {
            if !self.is_order(&clause.chain) || !self.is_plain(&clause.chain) {
                continue;
            }
            // What a function is at a number has no letter that could have a range.
            let letters: Vec<_> = clause
                .chain
                .members
                .iter()
                .filter_map(Expr::as_name)
                .collect();
            let about = |c: &&Arc<Clause>| {
                c.chain.relations.first() == Some(&Relation::Equal)
                    && c.chain
                        .members
                        .iter()
                        .any(|m| letters.iter().any(|l| mentions(m, l)))
            };
            if clauses.iter().filter(about).count() > 1 {
                let readings = vec![
                    "the range of the definition before it, written as an equation of its own"
                        .to_owned(),
                    "the range of all of them".to_owned(),
                ];
                self.error(DiagnosticKind::Ambiguous { readings }, clause.chain.span);
            }
        }
    }

    /// Refuses what is no equation to be solved: other relations, and what it is said under.
    pub(super) fn refuse_unsolvable(&mut self, display: &Display) {
        for clause in &display.clauses {
            let chain = &clause.chain;
            let equations = chain.relations.iter().all(|r| *r == Relation::Equal);
            let under = clause.joined.as_deref().is_some_and(latex::is_condition);
            if equations && !under {
                continue;
            }
            let found = format!("`{}`", latex::write_chain(chain));
            let expected = "equations to be solved, and nothing else: between what its letters lie \
                            their declarations say";
            let expected = expected.into();
            self.error(DiagnosticKind::Unexpected { found, expected }, chain.span);
        }
    }

    /// Refuses what a display cannot say: alternatives, and clauses without a relation in a claim.
    pub(super) fn refuse_clauses(&mut self, display: &Display, claim: bool) {
        for clause in &display.clauses {
            if clause.joined.as_deref() == Some("or") {
                self.error(DiagnosticKind::Alternatives, clause.chain.span);
            }
            let [only] = clause.chain.members.as_slice() else {
                continue;
            };
            let braced = super::links::underbraces(&clause.chain);
            let labelled = braced.iter().any(|(_, label)| !label.members.is_empty());
            if names_number(only) || claim && !labelled {
                let clause = latex::write_expr(only);
                self.error(DiagnosticKind::SaysNothing { clause }, only.span);
            }
        }
    }
}

/// The conditions that stand behind a claim of their line, where something is claimed in another line too.
fn conditions_of_a_line(clauses: &[Arc<Clause>], conditional: &[bool]) -> Vec<crate::span::Span> {
    let mut line = 0;
    let lines: Vec<usize> = clauses
        .iter()
        .enumerate()
        .map(|(k, clause)| {
            let ends = matches!(
                clause.separation,
                Separation::Line | Separation::FullStop | Separation::CommaAndLine
            );
            line += usize::from(k > 0 && ends);
            line
        })
        .collect();
    let claims: Vec<usize> = (0..clauses.len())
        .filter(|k| !conditional[*k] && !clauses[*k].chain.relations.is_empty())
        .collect();
    (0..clauses.len())
        .filter(|k| conditional[*k])
        .filter(|k| claims.iter().any(|c| c < k && lines[*c] == lines[*k]))
        .filter(|k| claims.iter().any(|c| lines[*c] != lines[*k]))
        .map(|k| clauses[k].chain.span)
        .collect()
}

/// Whether a clause is neither set apart from the one before it nor joined to it as its like.
fn leads_on(clause: &Clause) -> bool {
    let apart = matches!(clause.separation, Separation::Line | Separation::FullStop);
    match clause.joined.as_deref() {
        Some(word) => word != "and" && word != "or" && !apart,
        None => !apart,
    }
}

/// The neighbours of a chain, but for those that say nothing, such as `a < \infty`.
fn hypotheses(chain: &Chain) -> Vec<Hypothesis> {
    let pairs = chain.members.windows(2).zip(&chain.relations);
    pairs
        .filter_map(|(sides, relation)| match sides {
            [left, right] if !is_infinite(left) && !is_infinite(right) => Some(Hypothesis {
                left: left.clone(),
                relation: *relation,
                right: right.clone(),
                span: left.span.to(right.span),
            }),
            _ => None,
        })
        .collect()
}

fn is_infinite(expr: &Expr) -> bool {
    match &expr.kind {
        ExprKind::Infinity => true,
        ExprKind::Sum(terms) => terms.iter().any(|(_, term)| is_infinite(term)),
        _ => false,
    }
}

/// Whether the expression spells a number or infinity.
fn names_number(expr: &Expr) -> bool {
    match &expr.kind {
        ExprKind::Sum(terms) => match terms.as_slice() {
            [(Sign::Plus | Sign::Minus, only)] => names_number(only),
            _ => super::names::literal_number(expr).is_some(),
        },
        ExprKind::Infinity => true,
        _ => super::names::literal_number(expr).is_some(),
    }
}
