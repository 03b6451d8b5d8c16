//! One edit of a display: where, and what stands there instead.
//!
//! Of a sum or product only the run of terms or factors that differs is kept, so that an edit of a sum
//! of a hundred terms is no copy of it: the edits of an equation together are about as long as it is
//! times the number of kinds of slips, not times its own length.

use super::{Address, Site, build, cost_of};
use crate::expr::walk::visit;
use crate::expr::{Display, Expr, ExprKind, Sign};
use crate::latex;
use crate::verdict::{Edit, EditClass};

/// A subexpression and what to put in its place.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Replacement {
    /// Where.
    pub address: Address,
    /// What kind of slip it would repair.
    pub class: EditClass,
    /// What to put there.
    pub change: Change,
    /// How far-fetched it is: ten times the rank of its class, and a little more for what is rarer.
    pub cost: u32,
}

/// What becomes of a subexpression.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Change {
    /// This stands there instead.
    Whole(ExprKind),
    /// Of a sum the terms from one to another, exclusive, are replaced by these.
    Terms {
        /// The first.
        from: usize,
        /// Behind the last.
        to: usize,
        /// By what.
        by: Vec<(Sign, Expr)>,
    },
    /// Of a product the factors from one to another, exclusive, are replaced by these.
    Factors {
        /// The first.
        from: usize,
        /// Behind the last.
        to: usize,
        /// By what.
        by: Vec<Expr>,
    },
}

/// The run in which two lists differ: where it begins, and where it ends in each.
fn run<T: PartialEq>(before: &[T], after: &[T]) -> (usize, usize, usize) {
    let pairs = before.iter().zip(after);
    let from = pairs.take_while(|(one, other)| one == other).count();
    let shorter = before.len().min(after.len()) - from;
    let pairs = before.iter().rev().zip(after.iter().rev()).take(shorter);
    let same = pairs.take_while(|(one, other)| one == other).count();
    (from, before.len() - same, after.len() - same)
}

impl Change {
    /// What turns one expression into another.
    pub fn between(old: &Expr, new: Expr) -> Self {
        match (&old.kind, new.kind) {
            (ExprKind::Sum(before), ExprKind::Sum(mut after)) if *before != after => {
                let (from, to, end) = run(before, &after);
                after.truncate(end);
                after.drain(..from);
                // Otherwise it takes the room of all that was there.
                after.shrink_to_fit();
                Change::Terms {
                    from,
                    to,
                    by: after,
                }
            }
            (ExprKind::Product(before), ExprKind::Product(mut after)) if *before != after => {
                let (from, to, end) = run(before, &after);
                after.truncate(end);
                after.drain(..from);
                // Otherwise it takes the room of all that was there.
                after.shrink_to_fit();
                Change::Factors {
                    from,
                    to,
                    by: after,
                }
            }
            (_, new) => Change::Whole(new),
        }
    }

    /// Some terms of a sum replaced by others, without a copy of the rest where it stays a sum.
    pub fn of_terms(terms: &[(Sign, Expr)], from: usize, to: usize, by: Vec<(Sign, Expr)>) -> Self {
        let span = terms.first().map_or_else(Default::default, |(_, t)| t.span);
        let by = match by.is_empty() {
            true => by,
            false => build::terms(&build::sum(by, span)),
        };
        let left = terms.len() - (to - from) + by.len();
        let lone_plus = left == 1 && {
            let rest = terms[..from].iter().chain(&by).chain(&terms[to..]);
            rest.into_iter().all(|(sign, _)| *sign == Sign::Plus)
        };
        if left == 0 || lone_plus {
            let mut all = terms[..from].to_vec();
            all.extend(by);
            all.extend(terms[to..].to_vec());
            return Change::Whole(build::sum(all, span).kind);
        }
        Change::Terms { from, to, by }
    }

    /// The changed expression; none where it is not one that the change is of.
    pub fn result(&self, old: &Expr) -> Option<ExprKind> {
        let mut new = old.clone();
        self.apply(&mut new).then_some(new.kind)
    }

    /// Changes an expression; `false` where it is not one that the change is of.
    pub fn apply(&self, expr: &mut Expr) -> bool {
        match (self, &mut expr.kind) {
            (Change::Whole(kind), place) => {
                *place = kind.clone();
                true
            }
            (Change::Terms { from, to, by }, ExprKind::Sum(terms)) if *to <= terms.len() => {
                terms.splice(*from..*to, by.iter().cloned());
                true
            }
            (Change::Factors { from, to, by }, ExprKind::Product(factors))
                if *to <= factors.len() =>
            {
                factors.splice(*from..*to, by.iter().cloned());
                true
            }
            (Change::Terms { .. } | Change::Factors { .. }, _) => false,
        }
    }

    /// What is put in.
    pub fn pieces(&self) -> Vec<&Expr> {
        match self {
            Change::Whole(_) => Vec::new(),
            Change::Terms { by, .. } => by.iter().map(|(_, term)| term).collect(),
            Change::Factors { by, .. } => by.iter().collect(),
        }
    }

    /// How many nodes the expressions have that are put in.
    pub fn size(&self) -> usize {
        let mut count = 0;
        let mut see = |_: &Expr| count += 1;
        match self {
            Change::Whole(kind) => {
                visit(&Expr::new(kind.clone(), Default::default()), &mut see);
            }
            Change::Terms { .. } | Change::Factors { .. } => {
                for piece in self.pieces() {
                    visit(piece, &mut see);
                }
            }
        }
        count + 1
    }

    /// A text by which changes of one expression are told apart; none for one that changes nothing.
    pub(super) fn text(&self, old: &Expr) -> Option<String> {
        let written = |kind: &ExprKind| latex::write_expr(&Expr::new(kind.clone(), old.span));
        let (text, printed) = match (self, &old.kind) {
            (Change::Whole(kind), _) => (written(kind), latex::write_expr(old)),
            (Change::Terms { from, to, by }, ExprKind::Sum(terms)) => {
                let run = |terms: &[(Sign, Expr)]| {
                    format!("{from} {to} {}", written(&ExprKind::Sum(terms.to_vec())))
                };
                (run(by), run(terms.get(*from..*to)?))
            }
            (Change::Factors { from, to, by }, ExprKind::Product(factors)) => {
                let run = |factors: &[Expr]| {
                    format!(
                        "{from} {to} {}",
                        written(&ExprKind::Product(factors.to_vec()))
                    )
                };
                (run(by), run(factors.get(*from..*to)?))
            }
            (Change::Terms { .. } | Change::Factors { .. }, _) => return None,
        };
        (text != printed).then_some(text)
    }
}

impl Replacement {
    /// An edit with the cost of its class.
    pub fn new(site: &Site<'_>, class: EditClass, to: Expr) -> Self {
        Replacement::of(site, class, Change::between(site.expr, to))
    }

    /// A change with the cost of its class.
    pub fn of(site: &Site<'_>, class: EditClass, change: Change) -> Self {
        Replacement {
            address: site.address.clone(),
            class,
            change,
            cost: cost_of(class),
        }
    }

    /// The same with a higher cost.
    #[must_use]
    pub fn rarer(mut self, by: u32) -> Self {
        self.cost += by;
        self
    }

    /// Changes the display; `false` when the address is not in it.
    pub fn apply(&self, display: &mut Display) -> bool {
        match self.address.find_mut(display) {
            Some(expr) => self.change.apply(expr),
            None => false,
        }
    }

    /// The change in LaTeX: of a long sum or product the part that differs.
    pub fn describe(&self, display: &Display) -> Option<Edit> {
        let old = self.address.find(display)?;
        let (printed, corrected) = differing(old, &self.change.result(old)?);
        Some(Edit {
            class: self.class,
            span: printed.span,
            printed: latex::write_expr(&printed),
            corrected: latex::write_expr(&corrected),
        })
    }
}

/// Terms that stay beside what differs when an edit of a long sum is described.
const SHOWN: usize = 1;

/// Of two sums that begin and end alike, the parts that differ.
fn differing(old: &Expr, new: &ExprKind) -> (Expr, Expr) {
    let whole = || (old.clone(), Expr::new(new.clone(), old.span));
    let (ExprKind::Sum(before), ExprKind::Sum(after)) = (&old.kind, new) else {
        return whole();
    };
    if before.len().max(after.len()) <= 4 {
        return whole();
    }
    let (alike, end, _) = run(before, after);
    let after_it = before.len() - end;
    let (from, behind) = (alike.saturating_sub(SHOWN), after_it.saturating_sub(SHOWN));
    let part = |terms: &[(Sign, Expr)]| {
        let terms = terms[from..terms.len() - behind].to_vec();
        let span = match (terms.first(), terms.last()) {
            (Some(first), Some(last)) => first.1.span.to(last.1.span),
            _ => old.span,
        };
        build::sum(terms, span)
    };
    (part(before), part(after))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::span::Span;

    /// The edits of a sum together are about as long as it is, in memory too.
    #[test]
    fn a_change_of_a_long_sum_keeps_the_terms_that_differ_and_no_room_for_others() {
        let number = |n: i64| {
            let n = num_rational::BigRational::from_integer(n.into());
            Expr::new(ExprKind::Number(n), Span::default())
        };
        let terms: Vec<(Sign, Expr)> = (0..500).map(|n| (Sign::Plus, number(n))).collect();
        let mut others = terms.clone();
        others[250].0 = Sign::Minus;
        let sum = |terms| Expr::new(ExprKind::Sum(terms), Span::default());
        match Change::between(&sum(terms), sum(others)) {
            Change::Terms { from, to, by } => {
                assert_eq!((from, to, by.len()), (250, 251, 1));
                assert!(by.capacity() < 8);
            }
            other => panic!("{other:?}"),
        }
    }
}
