//! Limits of what has an argument at the goal: `\Omega \to 0, \Phi(0) \to \infty`.
//!
//! Beside the letter that moves such an argument is what it says, as in a difference quotient, and where a
//! letter is bound it may be that letter. Only where the one letter that moves stands nowhere in what has the
//! limit is the argument read as moving, and the reading is named.

use super::Model;
use super::names::Resolved;
use crate::expr::walk::{children_mut, mentions, varied_name, visit};
use crate::expr::{Chain, Expr, ExprKind, Name, Relation};
use crate::latex::{self, Reading};

impl Model {
    /// What has a limit with the letter in place of its goal, if that is an argument there and nothing else in it
    /// moves.
    pub fn moved(&self, printed: &Expr, letter: &Name, goal: &Expr) -> Option<Expr> {
        if mentions(printed, letter) || self.moves_behind(printed, letter) {
            return None;
        }
        let mut moving = printed.clone();
        (put(&mut moving, letter, goal)? > 0).then_some(moving)
    }

    /// Whether what is printed is made of a letter, but for the functions of this letter.
    fn moves_behind(&self, printed: &Expr, letter: &Name) -> bool {
        let Ok(Resolved::Letter { symbol, .. }) = self.resolve(letter, &|_| false) else {
            return true;
        };
        let mut moves = false;
        visit(printed, &mut |e| {
            let (ExprKind::Name(name) | ExprKind::Apply { function: name, .. }) = &e.kind else {
                return;
            };
            moves |= match self.resolve(name, &|_| false) {
                Ok(Resolved::Node { node, .. } | Resolved::Primed { node, .. }) => {
                    let own = self.function_definition(node).is_some_and(|definition| {
                        let plain = matches!(e.kind, ExprKind::Apply { .. });
                        plain && definition.arguments.contains(letter)
                    });
                    !own && self
                        .symbols_behind(node, &|e| self.display(e))
                        .contains(&symbol)
                }
                Ok(Resolved::Letter { symbol: own, .. }) => {
                    own == symbol || self.argument_symbols(own).any(|s| s == symbol)
                }
                Ok(_) | Err(_) => false,
            };
        });
        moves
    }

    /// How the equations are read where an argument is the goal of the one letter that moves.
    pub(super) fn name_moving_arguments(&mut self) {
        let read: Vec<Vec<Reading>> = (0..self.equations.len())
            .map(|equation| self.moving_arguments(equation))
            .collect();
        for (equation, read) in self.equations.iter_mut().zip(read) {
            equation.readings.extend(read);
            equation.readings.sort_by_key(|reading| reading.span);
        }
    }

    fn moving_arguments(&self, equation: usize) -> Vec<Reading> {
        let tends = |chain: &Chain| match (chain.members.as_slice(), chain.relations.as_slice()) {
            ([left, right], [Relation::Tends]) => Some((left.clone(), right.clone())),
            _ => None,
        };
        let clauses = self.equations[equation].display.clauses.iter();
        let all = clauses.filter_map(|clause| tends(&clause.chain));
        let is_letter = |expr: &Expr| {
            expr.as_name().is_some_and(|name| {
                let letter = self.resolve(name, &|_| false);
                matches!(letter, Ok(Resolved::Letter { order: 0, .. }))
            })
        };
        let (letters, of): (Vec<_>, Vec<_>) = all.partition(|(left, _)| is_letter(left));
        let [(letter, goal)] = letters.as_slice() else {
            return Vec::new();
        };
        let Some(letter) = letter.as_name() else {
            return Vec::new();
        };
        let read = of.iter().filter_map(|(printed, _)| {
            Some(Reading {
                span: printed.span,
                latex: latex::write_expr(&self.moved(printed, letter, goal)?),
            })
        });
        read.collect()
    }
}

/// Puts the letter where its goal is an argument; in how many functions. None where it is several arguments of one.
fn put(expr: &mut Expr, letter: &Name, goal: &Expr) -> Option<usize> {
    if varied_name(expr).is_some() {
        return Some(0);
    }
    let mut count = 0;
    if let ExprKind::Apply { arguments, .. } = &mut expr.kind {
        for argument in arguments {
            if argument == goal {
                argument.kind = ExprKind::Name(letter.clone());
                count += 1;
            }
        }
    }
    if count > 1 {
        return None;
    }
    for child in children_mut(expr) {
        count += put(child, letter, goal)?;
    }
    Some(count)
}
