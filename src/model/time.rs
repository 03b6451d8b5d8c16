//! The time: what a dot differentiates by.
//!
//! A dot over a process is its derivative by the letter that the process is declared a function of. A
//! document's times are these letters; where no process is declared, the declared letter `t` is the
//! time, unless its unit says that it is something else. What is defined through a time depends on it.
//! A document without any time has no dots.
//!
//! Invariant: a time is a declared letter that stands for a number, or a letter that nothing but
//! processes mention.

use super::names::{Names, Resolved};
use super::{Model, Node, Symbol};
use crate::expr::walk::visit;
use crate::expr::{Expr, ExprKind, Name};
use crate::latex;
use crate::span::Span;
use crate::unit::{Base, Dimension, Unit};
use std::collections::BTreeSet;

/// How something depends on the time.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Clock {
    /// Not at all.
    Still,
    /// It changes with this time, by its canonical name.
    Runs(String),
    /// Nothing says: it is an argument of functions, or a letter `t` that is not the processes' time.
    Unclear,
}

/// In what something that is said to be constant does not change.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Constancy<'e> {
    /// In the time.
    Time,
    /// In the letter that it is a function of.
    Letter(&'e Name),
    /// It is made of functions of letters that stand still: nothing says which of them is meant.
    Unclear,
}

/// The times of a document by their canonical names.
pub(super) fn times(symbols: &[Symbol], names: &Names) -> BTreeSet<String> {
    let number = |name: &Name| match names.whole.get(&latex::canonical(name)) {
        Some(Node::Symbol(s)) => symbols[*s].function_of.is_none(),
        Some(_) => false,
        None => name.letter.font != crate::expr::Font::Bold,
    };
    let of_processes: BTreeSet<String> = symbols
        .iter()
        .filter_map(|s| s.function_of.as_ref())
        .filter(|name| number(name))
        .map(latex::canonical)
        .collect();
    if !of_processes.is_empty() {
        return of_processes;
    }
    let declared = symbols.iter().find(|s| is_t(s));
    declared
        .map(|s| latex::canonical(&s.name))
        .into_iter()
        .collect()
}

/// Whether a symbol is the letter `t` and may measure a time.
fn is_t(symbol: &Symbol) -> bool {
    let second = || Dimension::base(Base::Second);
    let time = |unit: &String| Unit::parse(unit).is_ok_and(|u| u.dimension == second());
    symbol.name == Name::italic("t")
        && symbol.function_of.is_none()
        && symbol.unit.as_ref().is_none_or(time)
}

impl Model {
    /// Whether the derivative that is printed there begins with curly d's.
    pub(crate) fn is_partial(&self, span: Span) -> bool {
        let printed = self.document.text.get(span.start..span.end);
        let first = printed.unwrap_or_default().find("\\partial");
        // Before it stands the fraction's command at most.
        first.is_some_and(|at| at < 8)
    }

    /// How a symbol depends on the time.
    pub fn clock(&self, symbol: usize) -> Clock {
        let declared = &self.symbols[symbol];
        if let Some(time) = &declared.function_of {
            return Clock::Runs(latex::canonical(time));
        }
        let name = latex::canonical(&declared.name);
        if self.times.contains(&name) {
            return Clock::Runs(name);
        }
        let argument = |d: &super::Definition| d.arguments.contains(&declared.name);
        // Where the time is known, what is no function of it stands still, arguments of functions too.
        let known = !self.times.is_empty();
        if is_t(declared) || !known && self.definitions.iter().any(argument) {
            return Clock::Unclear;
        }
        Clock::Still
    }

    /// What a chain that begins with `head` means by "constant": that f(x) is, is said of x; of anything
    /// else it is said of the time, unless functions of letters that know no time stand there.
    pub fn constancy<'e>(&self, head: Option<&'e Expr>) -> Constancy<'e> {
        let Some(head) = head.map(Expr::without_brackets) else {
            return Constancy::Time;
        };
        if let ExprKind::Apply { arguments, .. } = &head.kind
            && let [argument] = arguments.as_slice()
            && let Some(name) = argument.as_name()
            && !self.is_time(name)
        {
            return Constancy::Letter(name);
        }
        let still = |name: &Name| match self.resolve(name, &|_| false) {
            Ok(Resolved::Letter { symbol, .. }) => match self.clock(symbol) {
                Clock::Still | Clock::Unclear => true,
                Clock::Runs(_) => false,
            },
            Ok(
                Resolved::Bound(_)
                | Resolved::Node { .. }
                | Resolved::Primed { .. }
                | Resolved::Indexed { .. },
            )
            | Err(_) => false,
        };
        let mut unclear = false;
        visit(head, &mut |e| {
            if let ExprKind::Apply { arguments, .. } = &e.kind {
                for argument in arguments {
                    visit(argument, &mut |a| unclear |= a.as_name().is_some_and(still));
                }
            }
        });
        if unclear {
            Constancy::Unclear
        } else {
            Constancy::Time
        }
    }

    /// Whether a letter with this canonical name is a time.
    pub fn is_time(&self, name: &Name) -> bool {
        self.times.contains(&latex::canonical(name))
            || self
                .symbols
                .iter()
                .any(|s| s.function_of.as_ref() == Some(name))
    }
}
