//! What a print leaves unsaid, so that nothing can be said of it.
//!
//! A hypothesis is an equation at every moment or at one only, along the way to a limit or at its end; which of
//! them is meant is not written, and what is random, what is differentiated and what goes to a limit depends
//! on it. Where hypotheses tie processes, whose rates are letters of their own at a point, a point shows
//! something false only if the values of these rates are free to be chosen so: if each hypothesis can be
//! solved for a rate of which no other knows the higher ones (an autoreduced system; J. F. Ritt,
//! Differential Algebra, 1950, chapter I).

use super::limits::mentions;
use super::{Checker, Verdict};
use crate::domain::Domain;
use crate::evaluate::{self, Value};
use crate::expr::walk::{children, visit};
use crate::expr::{Expr, ExprKind, Function, Name, Relation};
use crate::model::links::Link;
use crate::model::names::Resolved;
use crate::model::{Hypothesis, Letter, Node};
use crate::verdict::Positivity;
use ratpoly::RationalFunction;
use std::collections::BTreeSet;

/// A process or its derivative of an order.
type Rate = (usize, u8);

/// The most ways to choose what the hypotheses are solved for.
const MOST_CHOICES: usize = 4_096;

impl Checker<'_> {
    /// Why nothing can be said of a link: what its hypotheses or declarations mean is not written.
    pub(super) fn unwritten(&self, equation: usize, link: &Link) -> Option<&'static str> {
        let display = self.exact.display(equation);
        if link.relation == Relation::Tends {
            let mut goes = display.clauses.iter().filter_map(|clause| {
                let first = clause.chain.members.first()?;
                let tends = clause.chain.relations.first() == Some(&Relation::Tends);
                match &first.kind {
                    ExprKind::Name(name) if tends => Some(name),
                    _ => None,
                }
            });
            let sides = [link.left, link.right];
            let sides: Vec<&Expr> = sides.iter().filter_map(|p| p.find(display)).collect();
            return goes.find_map(|name| {
                if self.ties(equation, name) || self.bounds_by_others(equation, name, |_| true) {
                    Some("a hypothesis ties the letter that goes to a limit")
                } else if sides.iter().any(|side| self.moves_with(side, name)) {
                    Some("how a process goes with the letter that goes to a limit is not written")
                } else {
                    None
                }
            });
        }
        let (mut tied, mut integrated, mut cornered, mut moved, mut moments) =
            (false, false, false, false, false);
        for place in [link.left, link.right] {
            let Some(side) = place.find(display) else {
                continue;
            };
            visit(side, &mut |e| {
                moments |= matches!(e.kind, ExprKind::Expectation(_));
                match &e.kind {
                    ExprKind::Derivative {
                        variable: Some(variable),
                        body,
                        ..
                    } if !self.model.is_time(variable) => {
                        tied |= self.ties(equation, variable) || self.pinches(equation, variable);
                        // The curly one holds all others fixed.
                        moved |= !self.model.is_partial(e.span) && self.moves_with(body, variable);
                        cornered |= self.ends_at(equation, variable) && self.has_corners(body);
                    }
                    ExprKind::Derivative { body, .. } => {
                        cornered |= self.has_bounded_process(equation) && self.has_corners(body);
                    }
                    ExprKind::Integral { variable, body, .. } => {
                        integrated |= self.ties(equation, variable);
                        moved |= self.moves_with(body, variable);
                    }
                    _ => {}
                }
            });
        }
        if self.ties_the_time(equation) && self.has_rates(equation, link) {
            return Some(
                "a hypothesis is about the time: whether it holds at a moment or always is not written",
            );
        }
        if moments && self.has_covariance_of_constants() {
            return Some("a covariance is declared of letters that are functions of nothing");
        }
        if self.ties_processes(equation) && (moments || self.has_moments(equation, link)) {
            return Some(
                "a hypothesis ties what is random: which moments it has then is not written",
            );
        }
        if moved {
            return Some("how processes go with each other is not written");
        }
        if self.moves_by_itself(equation) {
            return Some("a hypothesis is about a process whose motion the document determines");
        }
        if integrated {
            return Some("a hypothesis ties the letter over which is integrated");
        }
        if cornered {
            return Some("at the end of the range of its letter the derivative may not exist");
        }
        tied.then_some(
            "a hypothesis ties the letter by which is differentiated: what depends on it is not written",
        )
    }

    fn hypotheses_of(&self, equation: usize) -> impl Iterator<Item = &Hypothesis> {
        let printed = &self.model.equations[equation];
        printed.assume.iter().chain(&printed.given)
    }

    /// Whether an equation among the hypotheses has a letter.
    fn ties(&self, equation: usize, name: &Name) -> bool {
        let mut equations = self
            .hypotheses_of(equation)
            .filter(|h| h.relation == Relation::Equal);
        equations.any(|h| mentions(&h.left, name) || mentions(&h.right, name))
    }

    /// Whether an order that may be an equality, among the hypotheses, is between a letter and others.
    fn pinches(&self, equation: usize, name: &Name) -> bool {
        let orders = [Relation::LessEqual, Relation::GreaterEqual];
        self.bounds_by_others(equation, name, |relation| orders.contains(&relation))
    }

    /// Whether such a relation among the hypotheses is between a letter and others.
    fn bounds_by_others(
        &self,
        equation: usize,
        name: &Name,
        such: impl Fn(Relation) -> bool,
    ) -> bool {
        let mut hypotheses = self.hypotheses_of(equation).filter(|h| such(h.relation));
        hypotheses.any(|h| {
            let sides = [&h.left, &h.right];
            let (mut own, mut others) = (false, false);
            for side in sides {
                visit(side, &mut |e| {
                    if let ExprKind::Name(n) | ExprKind::Apply { function: n, .. } = &e.kind {
                        own |= n == name;
                        others |= n != name;
                    }
                });
            }
            own && others
        })
    }

    /// Whether an equation among the hypotheses has a time and nothing that changes with it.
    fn ties_the_time(&self, equation: usize) -> bool {
        let mut equations = self
            .hypotheses_of(equation)
            .filter(|h| h.relation == Relation::Equal);
        equations.any(|h| {
            let sides = [&h.left, &h.right];
            let mut timed = false;
            for side in sides {
                visit(side, &mut |e| {
                    if let ExprKind::Name(name) = &e.kind {
                        timed |= self.model.is_time(name);
                    }
                });
            }
            timed && !sides.into_iter().any(|side| self.is_random(side))
        })
    }

    /// Whether an equation among the hypotheses is about processes of which the document gives all a rate:
    /// nothing is left for which it could be solved.
    fn moves_by_itself(&self, equation: usize) -> bool {
        let mut equations = self
            .hypotheses_of(equation)
            .filter(|h| h.relation == Relation::Equal);
        equations.any(|h| {
            let (mut moving, mut free) = (false, false);
            for side in [&h.left, &h.right] {
                visit(side, &mut |e| {
                    if let ExprKind::Name(name) | ExprKind::Apply { function: name, .. } = &e.kind
                        && let Ok(Resolved::Letter { symbol, .. }) =
                            self.model.resolve(&name.undotted(), &|_| false)
                        && self.is_process(symbol)
                    {
                        match self.has_own_motion(symbol) {
                            true => moving = true,
                            false => free = true,
                        }
                    }
                });
            }
            moving && !free
        })
    }

    /// Whether the range of a letter, declared or supposed, has an end that belongs to it.
    fn ends_at(&self, equation: usize, name: &Name) -> bool {
        let mut bounds = self
            .hypotheses_of(equation)
            .filter(|h| matches!(h.relation, Relation::LessEqual | Relation::GreaterEqual));
        if bounds.any(|h| mentions(&h.left, name) || mentions(&h.right, name)) {
            return true;
        }
        let Ok(Resolved::Letter { symbol, .. }) = self.model.resolve(name, &|_| false) else {
            return false;
        };
        let range = &self.model.symbols[symbol].range;
        let ends = [&range.low, &range.high];
        ends.into_iter().flatten().any(|end| end.included)
    }

    /// Whether a hypothesis gives what processes stand in an end that belongs to its range.
    fn has_bounded_process(&self, equation: usize) -> bool {
        let mut bounds = self
            .hypotheses_of(equation)
            .filter(|h| matches!(h.relation, Relation::LessEqual | Relation::GreaterEqual));
        bounds.any(|h| self.is_random(&h.left) || self.is_random(&h.right))
    }

    /// Whether something that is not smooth stands behind an expression.
    fn has_corners(&self, expr: &Expr) -> bool {
        let mut found = false;
        let display = |e: usize| self.exact.display(e);
        self.model.visit_behind(expr, &display, &mut |e| {
            found |= matches!(
                e.kind,
                ExprKind::Cases(_)
                    | ExprKind::Call {
                        function: Function::Absolute | Function::SquareRoot,
                        ..
                    }
            );
        });
        found
    }

    /// Whether a process that is a function of a letter stands behind an expression.
    pub(super) fn moves_with(&self, expr: &Expr, letter: &Name) -> bool {
        let model = self.model;
        let Ok(Resolved::Letter { symbol: goes, .. }) = model.resolve(letter, &|_| false) else {
            return false;
        };
        // With a process its rates move, the time, and all that changes with the time.
        let process = self.is_process(goes);
        let mut found = false;
        let display = |e: usize| self.exact.display(e);
        model.visit_behind(expr, &display, &mut |e| {
            if let ExprKind::Name(name) | ExprKind::Apply { function: name, .. } = &e.kind {
                match model.resolve(name, &|_| false) {
                    Ok(Resolved::Letter { symbol, order }) => {
                        found |= model.argument_symbols(symbol).any(|s| s == goes);
                        found |= process
                            && (symbol == goes && order > 0
                                || symbol != goes && self.is_process(symbol)
                                || model.is_time(name));
                    }
                    Ok(Resolved::Node { derivatives, .. }) => found |= process && derivatives > 0,
                    Ok(Resolved::Bound(_) | Resolved::Primed { .. } | Resolved::Indexed { .. })
                    | Err(_) => {}
                }
            }
        });
        found
    }

    /// Whether a hypothesis of an equation is about processes themselves and not about their moments.
    fn ties_processes(&self, equation: usize) -> bool {
        let mut sides = self
            .hypotheses_of(equation)
            .flat_map(|h| [&h.left, &h.right]);
        sides.any(|side| self.is_random(side))
    }

    /// Whether a node is defined as a letter, or as a matrix of letters: values that the document does not
    /// compute.
    fn is_given_by_letters(&self, node: Node) -> bool {
        let Node::Definition(d) = node else {
            return false;
        };
        let definition = &self.model.definitions[d];
        let display = self.exact.display(definition.equation);
        let mut plain = true;
        let Some(value) = definition.place.find(display) else {
            return false;
        };
        visit(value, &mut |e| {
            plain &= matches!(
                e.kind,
                ExprKind::Name(_)
                    | ExprKind::Number(_)
                    | ExprKind::Matrix { .. }
                    | ExprKind::Group { .. }
            );
        });
        plain
    }

    /// Whether letters that the entries of a covariance are given in stand behind a link.
    pub(super) fn has_moments(&self, equation: usize, link: &Link) -> bool {
        let model = self.model;
        let display = |e: usize| self.exact.display(e);
        let mut behind = BTreeSet::new();
        for (_, node, _) in model.covariances() {
            if self.is_given_by_letters(node) {
                behind.extend(model.symbols_behind(node, &display));
            }
        }
        behind.retain(|s| !self.is_process(*s));
        if behind.is_empty() {
            return false;
        }
        let mut found = false;
        for place in [link.left, link.right] {
            let Some(side) = place.find(self.exact.display(equation)) else {
                continue;
            };
            model.visit_behind(side, &display, &mut |e| {
                if let ExprKind::Name(name) | ExprKind::Apply { function: name, .. } = &e.kind
                    && let Ok(Resolved::Letter { symbol, .. }) = model.resolve(name, &|_| false)
                {
                    found |= behind.contains(&symbol);
                }
            });
        }
        found
    }

    fn is_process(&self, symbol: usize) -> bool {
        self.model.symbols[symbol].function_of.is_some()
    }

    /// Whether a process stands in an expression outside of expectations.
    fn is_random(&self, expr: &Expr) -> bool {
        let model = self.model;
        let name = match &expr.kind {
            ExprKind::Expectation(_) => return false,
            ExprKind::Name(name) | ExprKind::Apply { function: name, .. } => Some(name),
            _ => None,
        };
        let own = name.is_some_and(|name| match model.resolve(name, &|_| false) {
            Ok(Resolved::Letter { symbol, .. }) => self.is_process(symbol),
            Ok(Resolved::Node { node, .. }) => {
                let behind = model.symbols_behind(node, &|e| model.display(e));
                behind.into_iter().any(|s| self.is_process(s))
            }
            Ok(Resolved::Bound(_) | Resolved::Primed { .. } | Resolved::Indexed { .. })
            | Err(_) => false,
        });
        own || children(expr)
            .into_iter()
            .any(|child| self.is_random(child))
    }

    /// Whether a covariance is that of a vector in which nothing is a process.
    fn has_covariance_of_constants(&self) -> bool {
        let model = self.model;
        model.covariances().any(|(_, _, covariance)| {
            let mut nodes = BTreeSet::new();
            model.collect(&covariance.product, &mut nodes);
            let mut behind = nodes.into_iter().flat_map(|n| match n {
                Node::Symbol(symbol) => BTreeSet::from([symbol]),
                node => model.symbols_behind(node, &|e| model.display(e)),
            });
            let mut letters = behind.by_ref().peekable();
            letters.peek().is_some() && !letters.any(|s| self.is_process(s))
        })
    }

    /// The verdict on a link of which no point can show that it is false.
    pub(super) fn proved_only(
        &mut self,
        equation: usize,
        link: &Link,
        positivity: &mut Option<Positivity>,
    ) -> Verdict {
        let repair = std::mem::replace(&mut self.options.repair, false);
        let verdict = self.exactly(|checker| match link.relation {
            Relation::Equal => checker.claim(equation, link),
            _ => checker.inequality(equation, link, positivity),
        });
        self.options.repair = repair;
        match verdict {
            Verdict::Refuted(refutation)
                if refutation.misfit().is_none() && refutation.missing().is_none() =>
            {
                Verdict::Undecided {
                    reason: "false at points of which it is not known whether they are admitted: \
                             only proofs use what hypotheses say of rates, and that a \
                             covariance is one"
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
        self.has_moments(equation, link) && bounded() || self.ties_rates(equation, link)
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
        let model = self.model;
        let world = evaluate::symbolic(model).in_instance(self.instance);
        let world = world.corrected_as(self.exact.world()).inserting();
        let mut exact = world.evaluator(model.field());
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

    fn has_rates(&self, equation: usize, link: &Link) -> bool {
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
    fn is_autoreduced(
        &self,
        equations: &[RationalFunction],
        field: &crate::domain::Symbolic,
    ) -> bool {
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
    fn has_own_motion(&self, symbol: usize) -> bool {
        let model = self.model;
        let mut name = model.symbols[symbol].name.clone();
        (0..4).any(|_| {
            name.dots = name.dots.saturating_add(1);
            matches!(model.resolve(&name, &|_| false), Ok(Resolved::Node { .. }))
        })
    }
}
