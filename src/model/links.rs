//! The links of a display: which neighbours of which chain are to be compared, and which member
//! gives a name its value.
//!
//! A [`Place`] addresses an expression inside a display without borrowing it, so that the same
//! link can be read off the display as printed and off a corrected copy of the same structure.

use crate::expr::walk::{children_mut, visit};
use crate::expr::{Chain, Display, Expr, ExprKind, Relation};
use std::sync::Arc;

/// Where in a display an expression stands.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Place {
    /// Member `member` of the chain of clause `clause`.
    Member {
        /// Clause, from 0.
        clause: usize,
        /// Member, from 0.
        member: usize,
    },
    /// What stands above the `brace`-th underbrace of clause `clause`, in reading order.
    Body {
        /// Clause, from 0.
        clause: usize,
        /// Underbrace, from 0.
        brace: usize,
    },
    /// Member `member` of the chain below that underbrace.
    Label {
        /// Clause, from 0.
        clause: usize,
        /// Underbrace, from 0.
        brace: usize,
        /// Member, from 0.
        member: usize,
    },
}

impl Place {
    /// The clause it stands in.
    pub fn clause(self) -> usize {
        match self {
            Place::Member { clause, .. }
            | Place::Body { clause, .. }
            | Place::Label { clause, .. } => clause,
        }
    }

    /// The expression at this place of a display, if the display has one.
    pub fn find(self, display: &Display) -> Option<&Expr> {
        let chain = &display.clauses.get(self.clause())?.chain;
        match self {
            Place::Member { member, .. } => chain.members.get(member),
            Place::Body { brace, .. } => underbraces(chain).get(brace).map(|(body, _)| *body),
            Place::Label { brace, member, .. } => underbraces(chain)
                .get(brace)
                .and_then(|(_, label)| label.members.get(member)),
        }
    }
}

/// Two neighbours of a chain.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Link {
    /// Its number within the display, from 1, in the order of reading.
    pub member: usize,
    /// The left neighbour; equal to `right` for a bare expression.
    pub left: Place,
    /// The right neighbour.
    pub right: Place,
    /// What stands between them.
    pub relation: Relation,
}

/// All links of a display in reading order: the chain of each clause, then its underbraces.
pub fn links(display: &Display) -> Vec<Link> {
    let mut found = Vec::new();
    let mut push = |left, right, relation| {
        let member = found.len() + 1;
        found.push(Link {
            member,
            left,
            right,
            relation,
        });
    };
    for (clause, c) in display.clauses.iter().enumerate() {
        let at = |member| Place::Member { clause, member };
        if c.chain.relations.is_empty() {
            push(at(0), at(0), Relation::Equal);
        }
        for (i, relation) in c.chain.relations.iter().enumerate() {
            push(at(i), at(i + 1), *relation);
        }
        for (brace, (_, label)) in underbraces(&c.chain).into_iter().enumerate() {
            let below = |member| Place::Label {
                clause,
                brace,
                member,
            };
            if label.relations.is_empty() {
                push(below(0), Place::Body { clause, brace }, Relation::Equal);
            }
            for (i, relation) in label.relations.iter().enumerate() {
                push(below(i), below(i + 1), *relation);
            }
        }
    }
    found
}

/// The underbraces of a chain in reading order: body and label.
pub fn underbraces(chain: &Chain) -> Vec<(&Expr, &Chain)> {
    let mut found = Vec::new();
    for member in &chain.members {
        visit(member, &mut |e| {
            if let ExprKind::Underbrace { body, label } = &e.kind {
                found.push((&**body, &**label));
            }
        });
    }
    found
}

/// Calls `see` on every expression of a display, including the labels of underbraces.
pub fn each_expression<'a>(display: &'a Display, see: &mut impl FnMut(&'a Expr)) {
    for clause in &display.clauses {
        for member in &clause.chain.members {
            visit(member, see);
        }
        for (_, label) in underbraces(&clause.chain) {
            for member in &label.members {
                visit(member, see);
            }
        }
    }
}

impl Place {
    /// The expression at this place of a display, to be changed.
    pub fn find_mut(self, display: &mut Display) -> Option<&mut Expr> {
        let chain = &mut Arc::make_mut(display.clauses.get_mut(self.clause())?).chain;
        let (brace, label_member) = match self {
            Place::Member { member, .. } => return chain.members.get_mut(member),
            Place::Body { brace, .. } => (brace, None),
            Place::Label { brace, member, .. } => (brace, Some(member)),
        };
        let mut remaining = brace;
        chain
            .members
            .iter_mut()
            .find_map(|member| nth_underbrace(member, &mut remaining))
            .and_then(|expr| match &mut expr.kind {
                ExprKind::Underbrace { body, label } => match label_member {
                    None => Some(&mut **body),
                    Some(member) => label.members.get_mut(member),
                },
                _ => None,
            })
    }
}

fn nth_underbrace<'a>(expr: &'a mut Expr, remaining: &mut usize) -> Option<&'a mut Expr> {
    if matches!(expr.kind, ExprKind::Underbrace { .. }) {
        if *remaining == 0 {
            return Some(expr);
        }
        *remaining -= 1;
    }
    children_mut(expr)
        .into_iter()
        .find_map(|child| nth_underbrace(child, remaining))
}
