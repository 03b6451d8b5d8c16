//! What hypotheses say of the rates of processes, and which points know it.
//!
//! Where hypotheses tie processes, whose rates are letters of their own at a point, a point shows something
//! false only if the values of these rates are free to be chosen so: if each hypothesis can be solved for a
//! rate of which no other knows the higher ones (an autoreduced system; J. F. Ritt, Differential Algebra, 1950,
//! chapter I). Otherwise a link can only be proved.

use super::{Checker, Verdict};
use crate::domain::{Domain, Symbolic};
use crate::evaluate::{Evaluator, Value};
use crate::expr::walk::visit;
use crate::expr::{Expr, ExprKind, Relation};
use crate::model::links::Link;
use crate::model::names::Resolved;
use crate::model::time::Clock;
use crate::model::{DefinitionKind, Hypothesis, Letter};
use crate::verdict::Positivity;
use ratpoly::RationalFunction;
use std::collections::BTreeSet;

/// A process or its derivative of an order.
type Rate = (usize, u8);

/// When hypotheses between constants and the time hold, as far as the print says.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Timed {
    /// There are none.
    No,
    /// At a moment: that \omega t = \pi/2 with \omega > 0 cannot be meant always.
    AtAMoment,
    /// At a moment, or always: x t = y t says t = 0 or x = y.
    PerhapsAlways,
}

/// The most ways to choose what the hypotheses are solved for.
const MOST_CHOICES: usize = 4_096;

impl Checker<'_> {
    /// The verdict on a link of which no point can show that it is false.
    pub(super) fn proved_only(
        &mut self,
        equation: usize,
        link: &Link,
        positivity: &mut Option<Positivity>,
    ) -> Verdict {
        let repair = std::mem::replace(&mut self.options.repair, false);
        let verdict = self.exactly(|checker| match link.relation == Relation::Equal {
            true => checker.claim(equation, link),
            false => checker.inequality(equation, link, positivity),
        });
        self.options.repair = repair;
        match verdict {
            Verdict::Refuted(refutation)
                if refutation.misfit().is_none() && refutation.missing().is_none() =>
            {
                Verdict::Undecided {
                    reason: "false at points of which it is not known whether they are admitted: \
                             only proofs use what hypotheses say of the time and of \
                             rates, and that a covariance is one"
                        .into(),
                }
            }
            verdict => verdict,
        }
    }

    /// Whether a point at which a link is false need not be one that the document admits.
    pub(super) fn is_only_proved(&mut self, equation: usize, link: &Link) -> bool {
        let bounded = || {
            let display = self.exact.display(equation);
            let sides = [link.left, link.right].into_iter();
            let mut sides = sides.filter_map(|p| p.find(display));
            link.relation != Relation::Equal
                || self.hypotheses_of(equation).next().is_some()
                || sides.any(|side| self.has_corners(side))
        };
        self.has_moments(equation, link) && bounded()
            || self.ties_rates(equation, link)
            || match self.timed(equation) {
                Timed::PerhapsAlways => true,
                Timed::AtAMoment => self.ties_processes(equation),
                Timed::No => false,
            }
            || self.starts_somewhere(equation, link)
    }

    /// Whether a process stands behind a link or its hypotheses of which the document says where it starts: where it
    /// is later follows from its motion, and a point knows nothing of that.
    fn starts_somewhere(&self, equation: usize, link: &Link) -> bool {
        let model = self.model;
        let started: BTreeSet<usize> = model
            .definitions
            .iter()
            .filter(|d| matches!(d.kind, DefinitionKind::ValueAt(_)))
            .filter_map(|d| match model.resolve(&d.name.undotted(), &|_| false) {
                Ok(Resolved::Letter { symbol, .. }) => Some(symbol),
                Ok(
                    Resolved::Node { .. }
                    | Resolved::Bound(_)
                    | Resolved::Primed { .. }
                    | Resolved::Indexed { .. },
                )
                | Err(_) => None,
            })
            .collect();
        if started.is_empty() {
            return false;
        }
        let display = |e: usize| self.exact.display(e);
        let own = self.exact.display(equation);
        let sides = [link.left, link.right]
            .into_iter()
            .filter_map(|p| p.find(own));
        let supposed = self
            .hypotheses_of(equation)
            .flat_map(|h| [&h.left, &h.right]);
        let mut found = false;
        for side in sides.chain(supposed) {
            model.visit_behind(side, &display, &mut |e| {
                let name = match &e.kind {
                    ExprKind::Name(name) => name,
                    ExprKind::Apply {
                        function,
                        arguments,
                    } if arguments.iter().any(|a| a.as_number().is_none()) => function,
                    _ => return,
                };
                if let Ok(Resolved::Letter { symbol, .. }) =
                    model.resolve(&name.undotted(), &|_| false)
                {
                    found |= started.contains(&symbol);
                }
            });
        }
        found
    }

    /// When the hypotheses with a time behind them and no process hold.
    pub(super) fn timed(&self, equation: usize) -> Timed {
        let equations = self.hypotheses_of(equation);
        let equations: Vec<&Hypothesis> = equations
            .filter(|h| h.relation == Relation::Equal)
            .collect();
        if equations.is_empty() {
            return Timed::No;
        }
        let mut exact = self.unsupposed();
        let mut timed = Timed::No;
        for hypothesis in equations {
            for entry in self.entries_of_a_moment(hypothesis, &mut exact) {
                let only = match exact.differentiate(Value::Scalar(entry), 1, hypothesis.span) {
                    Ok(Value::Scalar(rate)) => self.signs(rate.numerator()).excludes_zero(),
                    Ok(Value::Matrix(_) | Value::Zero) | Err(_) => false,
                };
                if !only {
                    return Timed::PerhapsAlways;
                }
                timed = Timed::AtAMoment;
            }
        }
        timed
    }

    /// Whether one of these hypotheses is between constants and the time.
    pub(super) fn hold_at_a_moment(&self, hypotheses: &[&Hypothesis]) -> bool {
        let equations = hypotheses.iter().filter(|h| h.relation == Relation::Equal);
        let equations: Vec<&&Hypothesis> = equations.collect();
        if equations.is_empty() {
            return false;
        }
        let mut exact = self.unsupposed();
        equations
            .into_iter()
            .any(|h| !self.entries_of_a_moment(h, &mut exact).is_empty())
    }

    /// The entries of what a hypothesis says to vanish that have a time behind them and no process.
    pub(super) fn entries_of_a_moment(
        &self,
        hypothesis: &Hypothesis,
        exact: &mut Evaluator<'_, Symbolic>,
    ) -> Vec<RationalFunction> {
        let Ok(value) = exact.expression_without_cases(&hypothesis.difference()) else {
            return Vec::new();
        };
        let is_rate = |letter: &usize| match self.model.letters[*letter] {
            Letter::Symbol { symbol, .. } => self.is_process(symbol),
            Letter::Abbreviation { .. } | Letter::Function { .. } => false,
        };
        let entries = value.entries().into_iter().filter(|entry| {
            let behind = exact.field.letters_behind(entry);
            behind.iter().any(|l| self.is_clock(*l)) && !behind.iter().any(is_rate)
        });
        entries.cloned().collect()
    }

    /// Whether a letter is a time: it goes on by itself.
    pub(super) fn is_clock(&self, letter: usize) -> bool {
        match self.model.letters[letter] {
            Letter::Symbol { symbol, order: 0 } => {
                let declared = &self.model.symbols[symbol];
                declared.function_of.is_none()
                    && (self.model.is_time(&declared.name)
                        || matches!(self.model.clock(symbol), Clock::Runs(_)))
            }
            Letter::Symbol { .. } | Letter::Abbreviation { .. } | Letter::Function { .. } => false,
        }
    }

    /// Whether a link has rates, and its hypotheses tie them in a way that values at a point do not
    /// know.
    fn ties_rates(&mut self, equation: usize, link: &Link) -> bool {
        let tied = self.hypotheses_of(equation);
        let tied: Vec<&Hypothesis> = tied
            .filter(|h| self.is_random(&h.left) || self.is_random(&h.right))
            .collect();
        if tied.is_empty() || !self.has_rates(equation, link) {
            return false;
        }
        let mut exact = self.unsupposed();
        let mut equations = Vec::new();
        for hypothesis in tied {
            match hypothesis.relation {
                Relation::Equal => match exact.expression_without_cases(&hypothesis.difference()) {
                    Ok(Value::Scalar(value)) => equations.push(value),
                    Ok(Value::Matrix(m)) => equations.extend(m.iter().cloned()),
                    Ok(Value::Zero) => {}
                    Err(_) => return true,
                },
                // A point is inside of them.
                Relation::Less | Relation::Greater | Relation::NotEqual => {}
                Relation::LessEqual
                | Relation::GreaterEqual
                | Relation::Distributed
                | Relation::Approximately
                | Relation::Tends => return true,
            }
        }
        equations.retain(|e| !e.is_zero());
        !self.is_autoreduced(&equations, &exact.field) && !self.solves_all(equation)
    }

    /// Whether the hypotheses are solved for processes and their rates, and leave no relation between them.
    fn solves_all(&mut self, equation: usize) -> bool {
        let stated: Vec<&Hypothesis> = self.model.equations[equation].given.iter().collect();
        let under = match stated.is_empty() {
            true => None,
            false => match self.suppose(&stated) {
                Ok(under) => Some(under.supposed),
                Err(_) => return false,
            },
        };
        let supposed = under.as_ref().unwrap_or(&self.supposed);
        supposed.relations.iter().all(|relation| {
            relation.variables_occurring().into_iter().all(|letter| {
                match self.model.letters[letter] {
                    Letter::Symbol { symbol, .. } => !self.is_process(symbol),
                    Letter::Abbreviation { .. } => true,
                    Letter::Function { .. } => false,
                }
            })
        })
    }

    /// Whether a link has rates of which hypotheses say something that the points of the second route do
    /// not know: these know what one hypothesis says of a rate, and not what follows from several, or for
    /// the rate of that rate.
    pub(super) fn misses_rates(&self, equation: usize, link: &Link) -> bool {
        let tied = self.hypotheses_of(equation);
        let tied: Vec<&Hypothesis> = tied
            .filter(|h| h.relation == Relation::Equal)
            .filter(|h| self.is_random(&h.left) || self.is_random(&h.right))
            .collect();
        let asked = self.rates(equation, link);
        let mut known = 0;
        for side in tied.iter().flat_map(|h| [&h.left, &h.right]) {
            visit(side, &mut |e| known = known.max(self.rate_in(e)));
        }
        asked > 0 && (tied.len() > 1 || known > 0 && asked > known)
    }

    /// The order of the time derivative that an expression is itself.
    fn rate_in(&self, expr: &Expr) -> u8 {
        match &expr.kind {
            ExprKind::Name(name) | ExprKind::Apply { function: name, .. } => name.dots,
            // Of what has dots perhaps.
            ExprKind::Derivative { variable, .. }
                if variable.as_ref().is_none_or(|v| self.model.is_time(v)) =>
            {
                u8::MAX
            }
            ExprKind::Constant => u8::MAX,
            _ => 0,
        }
    }

    pub(super) fn has_rates(&self, equation: usize, link: &Link) -> bool {
        self.rates(equation, link) > 0
    }

    /// The highest order of a time derivative that stands behind a link.
    fn rates(&self, equation: usize, link: &Link) -> u8 {
        let display = |e: usize| self.exact.display(e);
        let mut found = 0;
        for place in [link.left, link.right] {
            let Some(side) = place.find(self.exact.display(equation)) else {
                continue;
            };
            self.model.visit_behind(side, &display, &mut |e| {
                found = found.max(self.rate_in(e));
            });
        }
        found
    }

    /// Whether each of these equations can be solved for a rate of its own, of which no equation has a
    /// higher one, and of which no other equation has that one.
    fn is_autoreduced(&self, equations: &[RationalFunction], field: &Symbolic) -> bool {
        let model = self.model;
        let rates: Vec<BTreeSet<Rate>> = equations
            .iter()
            .map(|value| {
                let letters = field.letters_behind(value).into_iter();
                letters
                    .filter_map(|letter| match model.letters[letter] {
                        Letter::Symbol { symbol, order } if self.is_process(symbol) => {
                            Some((symbol, order))
                        }
                        Letter::Symbol { .. }
                        | Letter::Abbreviation { .. }
                        | Letter::Function { .. } => None,
                    })
                    .collect()
            })
            .collect();
        let slope_is_free = |value: &RationalFunction, rate: Rate| {
            let Some(letter) = model.letter_of_symbol(rate.0, rate.1) else {
                return false;
            };
            let Some(partials) = field.partial_derivatives(value) else {
                return false;
            };
            let mut functions = partials.iter().filter(|(l, _)| *l != letter);
            let inside = functions.any(|(l, _)| match model.letters[*l] {
                Letter::Function { .. } => true,
                Letter::Symbol { .. } | Letter::Abbreviation { .. } => false,
            });
            let slope = partials.into_iter().find(|(l, _)| *l == letter);
            !inside
                && slope.is_some_and(|(_, slope)| {
                    let behind = field.letters_behind(&slope);
                    !behind.iter().any(|l| {
                        matches!(model.letters[*l], Letter::Symbol { symbol, .. } if self.is_process(symbol))
                    })
                })
        };
        let candidates: Vec<Vec<Rate>> = equations
            .iter()
            .zip(&rates)
            .map(|(value, rates)| {
                let fits =
                    |rate: &&Rate| slope_is_free(value, **rate) && !self.has_own_motion(rate.0);
                rates.iter().filter(fits).copied().collect()
            })
            .collect();
        let ways: usize = candidates.iter().map(Vec::len).product();
        if ways == 0 || ways > MOST_CHOICES {
            return equations.is_empty();
        }
        (0..ways).any(|mut way| {
            let mut leaders = Vec::new();
            for own in &candidates {
                leaders.push(own[way % own.len()]);
                way /= own.len();
            }
            leaders.iter().enumerate().all(|(i, leader)| {
                rates.iter().enumerate().all(|(j, all)| {
                    let mut higher = all.iter().filter(|r| r.0 == leader.0 && r.1 >= leader.1);
                    higher.all(|r| i == j && r == leader)
                })
            })
        })
    }

    /// Whether an equation of the document gives a rate of a process.
    pub(super) fn has_own_motion(&self, symbol: usize) -> bool {
        let model = self.model;
        let mut name = model.symbols[symbol].name.clone();
        (0..4).any(|_| {
            name.dots = name.dots.saturating_add(1);
            matches!(model.resolve(&name, &|_| false), Ok(Resolved::Node { .. }))
        })
    }
}
