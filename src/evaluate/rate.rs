//! Derivatives by the time, and the derivatives of functions by their argument.
//!
//! A dot is the total derivative: processes have letters for theirs, a time has the rate one, and
//! everything else follows by the chain rule, abbreviations and functions included. Where the document
//! determines a derivative (an equation of motion) its value is inserted. A prime is the derivative of a
//! function by its argument, taken over a letter of its own and only then put at the printed
//! argument: f'(2x) is f' at 2x.
//!
//! Invariant: nothing has the rate zero but what depends on no time; what nothing is known about, and
//! what depends on two times, has none.

use super::{Evaluator, Failure, Key, Value};
use crate::domain::Domain;
use crate::expr::{Expr, ExprKind, Name};
use crate::model::names::Resolved;
use crate::model::time::Clock;
use crate::model::{Letter, Node};
use crate::span::Span;
use std::cmp::Ordering;
use std::collections::{BTreeMap, BTreeSet};

type Result<T> = std::result::Result<T, Failure>;

impl<D: Domain> Evaluator<'_, D> {
    /// The total time derivative of an order.
    pub(crate) fn differentiate(
        &mut self,
        value: Value<D::Element>,
        order: u8,
        span: Span,
    ) -> Result<Value<D::Element>> {
        if order > 0 && self.has_moving_arguments() {
            let what = "a time derivative in a function of what changes with the time";
            return Err(Failure::unsupported(what, span));
        }
        let mut value = value;
        for _ in 0..order {
            let mut rates: BTreeMap<usize, D::Element> = BTreeMap::new();
            value = value.try_map(|entry| {
                let partials = self.field.partial_derivatives(entry).ok_or_else(|| {
                    Failure::unsupported("a time derivative over this field", span)
                })?;
                let mut sum = self.field.integer(0);
                for (letter, partial) in partials {
                    let rate = match rates.get(&letter) {
                        Some(rate) => rate.clone(),
                        None => {
                            let rate = self.rate(letter, span)?;
                            rates.insert(letter, rate.clone());
                            rate
                        }
                    };
                    sum = self.field.add(&sum, &self.field.multiply(&partial, &rate));
                }
                Ok::<_, Failure>(sum)
            })?;
        }
        Ok(value)
    }

    /// The time derivative of a letter.
    fn rate(&mut self, letter: usize, span: Span) -> Result<D::Element> {
        let model = self.model;
        match model.letters[letter] {
            Letter::Abbreviation { definition } => {
                let key = (Node::Definition(definition), Vec::new(), 1);
                self.scalar_rate(|e| e.node(key, span), span)
            }
            Letter::Symbol { symbol, .. } if model.symbols[symbol].function_of.is_none() => {
                match model.clock(symbol) {
                    Clock::Still => Ok(self.field.integer(0)),
                    Clock::Runs(_) => Ok(self.field.integer(1)),
                    Clock::Unclear => Err(unclear(span)),
                }
            }
            Letter::Function { .. } => self.rate_of_function(letter, span),
            Letter::Symbol { symbol, order } => {
                // The derivative of an entry is the entry of the derivative, for which an equation
                // of motion may give a value.
                if let Some((matrix, i, j)) = model.symbols[symbol].entry_of {
                    let mut name = model.matrices[matrix].name.clone();
                    name.dots += order + 1;
                    return match self.name(&name, span)? {
                        Value::Matrix(m) if i < m.rows() && j < m.columns() => {
                            Ok(m[(i, j)].clone())
                        }
                        Value::Scalar(s) if (i, j) == (0, 0) => Ok(s),
                        Value::Matrix(_) | Value::Scalar(_) | Value::Zero => {
                            Err(Failure::unsupported("a derivative of another shape", span))
                        }
                    };
                }
                let mut name = model.letter_name(letter);
                name.dots += 1;
                self.scalar_rate(|e| e.name(&name, span), span)
            }
        }
    }

    fn scalar_rate(
        &mut self,
        rate: impl FnOnce(&mut Self) -> Result<Value<D::Element>>,
        span: Span,
    ) -> Result<D::Element> {
        match rate(self)? {
            Value::Scalar(s) => Ok(s),
            Value::Zero => Ok(self.field.integer(0)),
            Value::Matrix(_) => Err(Failure::unsupported("a derivative that is no scalar", span)),
        }
    }

    /// The time derivative of a letter that stands for a function.
    fn rate_of_function(&mut self, letter: usize, span: Span) -> Result<D::Element> {
        let steps = self.field.functions().and_then(|f| f.chain(letter));
        let mut rate = self.field.integer(0);
        for (factor, argument) in Self::possible(steps.unwrap_or(Ok(Vec::new())), span)? {
            let Value::Scalar(inner) = self.differentiate(Value::Scalar(argument), 1, span)? else {
                continue;
            };
            rate = self.field.add(&rate, &self.field.multiply(&factor, &inner));
        }
        Ok(rate)
    }

    /// The time derivative of a symbol that is no process: a hypothesis, or an argument, may stand
    /// for it.
    pub(super) fn rate_of_symbol(
        &mut self,
        symbol: usize,
        order: u8,
        span: Span,
    ) -> Result<Value<D::Element>> {
        if self.field.has_letters() {
            let at = self.frame.at.take();
            let value = self.symbol(symbol, 0, span);
            let rate = value.and_then(|value| self.differentiate(value, order, span));
            self.frame.at = at;
            return rate;
        }
        let one = match self.model.clock(symbol) {
            Clock::Unclear => return Err(unclear(span)),
            Clock::Still => false,
            Clock::Runs(_) => order == 1,
        };
        Ok(Value::Scalar(self.field.integer(i64::from(one))))
    }

    /// The time derivative of what a name stands for, from the derivative before it.
    pub(super) fn rate_of_node(&mut self, key: &Key, span: Span) -> Result<Value<D::Element>> {
        let (node, indices, derivatives) = key;
        let clocks = self.clocks(*node);
        if clocks.len() > 1 {
            return Err(two_times(span));
        }
        let before = (*node, indices.clone(), derivatives - 1);
        if self.frame.at.is_some() && !clocks.is_empty() {
            let what = "the rate at a number of what no equation of motion gives one";
            return Err(Failure::unsupported(what, span));
        }
        // An abbreviation is a letter: what it stands for is differentiated.
        let value = self.smooth(span, |e| match node {
            Node::Definition(d)
                if *derivatives == 1 && e.model.definitions[*d].letter.is_some() =>
            {
                e.compute(&before, span)
            }
            Node::Definition(_)
            | Node::Symbol(_)
            | Node::Matrix(_)
            | Node::Unknown { .. }
            | Node::Notation(_) => e.node(before, span),
        })?;
        if clocks.is_empty() && !self.field.has_letters() {
            return Ok(value.map(|_| self.field.integer(0)));
        }
        self.differentiate(value, 1, span)
    }

    /// Refuses the curly derivative by the time of what changes with it through processes: what it
    /// holds fixed, the print does not say.
    pub(super) fn nothing_held_fixed(&mut self, body: &Expr, span: Span) -> Result<()> {
        if !self.model.is_partial(span) {
            return Ok(());
        }
        let model = self.model;
        let is_process = |s: &usize| model.symbols[*s].function_of.is_some();
        let mut used = BTreeSet::new();
        model.collect(body, &mut used);
        let mut found = false;
        for node in used {
            found |= self.symbols_behind(node).iter().any(is_process);
        }
        crate::expr::walk::visit(body, &mut |e| {
            if let ExprKind::Name(name) | ExprKind::Apply { function: name, .. } = &e.kind
                && let Ok(Resolved::Letter { symbol, .. }) = model.resolve(name, &|_| false)
            {
                found |= is_process(&symbol);
            }
        });
        if found {
            let what = "a partial derivative by the time";
            return Err(Failure::unsupported(what, span));
        }
        Ok(())
    }

    /// The derivative of a defined function by its argument, at an argument; at the letter that it is
    /// defined with where none is printed.
    pub(super) fn derivative_by_argument(
        &mut self,
        function: Node,
        primes: u8,
        argument: Option<&Expr>,
        span: Span,
    ) -> Result<Value<D::Element>> {
        let model = self.model;
        let what = "a derivative by the argument";
        self.functions(what, span)?;
        let definition = model.function_definition(function);
        let parameters = definition.map(|d| self.parameters(d)).unwrap_or_default();
        let [parameter] = &parameters[..] else {
            return Err(Failure::unsupported(what, span));
        };
        let Ok(Resolved::Letter { symbol, order: 0 }) = model.resolve(parameter, &|_| false) else {
            return Err(Failure::unsupported(what, span));
        };
        let printed = match argument.map(|a| &a.kind) {
            Some(ExprKind::Named { name, value }) if name == parameter => Some(&**value),
            Some(ExprKind::Named { .. }) => return Err(Failure::unsupported(what, span)),
            Some(_) => argument,
            None => None,
        };
        let at = match printed {
            Some(argument) => self.expression(argument)?,
            None => self.symbol(symbol, 0, span)?,
        };
        let at = match at {
            Value::Scalar(at) => at,
            Value::Zero => self.field.integer(0),
            Value::Matrix(_) => return Err(Failure::unsupported("a matrix as an argument", span)),
        };
        if let Some(definition) = definition {
            let range = self.range_of(definition, &parameters);
            self.with_symbols(vec![(symbol, at.clone())], |e| {
                e.suppose_range(&range, span)
            })?;
        }
        self.derivative_over(symbol, primes, at, span, |e| {
            e.node((function, Vec::new(), 0), span)
        })
    }

    /// The value of what is differentiated: where two cases meet it may have no derivative.
    pub(super) fn smooth(
        &mut self,
        span: Span,
        body: impl FnOnce(&mut Self) -> Result<Value<D::Element>>,
    ) -> Result<Value<D::Element>> {
        let cases = std::mem::take(&mut self.choice.met);
        let value = body(self);
        // One case alone is a range, and inside of it nothing meets.
        let by_cases = std::mem::replace(&mut self.choice.met, cases) > 1;
        if by_cases && value.is_ok() {
            let what = "the derivative of what is defined by cases";
            return Err(Failure::unsupported(what, span));
        }
        value
    }

    /// A derivative by a symbol, taken over a letter of its own and then put at `at`.
    pub(super) fn derivative_over(
        &mut self,
        symbol: usize,
        order: u8,
        at: D::Element,
        span: Span,
        body: impl FnOnce(&mut Self) -> Result<Value<D::Element>>,
    ) -> Result<Value<D::Element>> {
        let what = "the derivative of a function";
        // The sign of the declared letter is that of the argument only where that has it.
        let functions = self.functions(what, span)?;
        let positive = self.model.symbols[symbol].range.is_positive()
            && functions.sign(&at) == Some(Ordering::Greater);
        let bound = self
            .functions(what, span)?
            .bound(self.frame.integrals, positive);
        let bound = Self::possible(bound, span)?;
        let by = match &self.field.letters(&bound)[..] {
            [letter] => *letter,
            _ => return Err(Failure::unsupported(what, span)),
        };
        self.frame.integrals += 1;
        let value = self.smooth(span, |e| e.with_symbols(vec![(symbol, bound)], body));
        let derivative = match value {
            Ok(mut value) => (0..order)
                .try_for_each(|_| {
                    value = value.try_map(|entry| self.partial(entry, by, span))?;
                    Ok(())
                })
                .map(|()| value),
            Err(failure) => Err(failure),
        };
        self.frame.integrals -= 1;
        let functions = self.functions(what, span)?;
        derivative?.try_map(|entry| Self::possible(functions.put(entry, by, &at), span))
    }

    /// The times that a node's value depends on.
    pub(super) fn clocks(&mut self, node: Node) -> BTreeSet<Clock> {
        let model = self.model;
        let symbols = self.symbols_behind(node);
        let clocks = symbols.iter().map(|s| model.clock(*s));
        clocks.filter(|c| matches!(c, Clock::Runs(_))).collect()
    }

    /// That an expression depends on one time only, which is this one where it is named.
    pub(super) fn one_time(&mut self, time: Option<&Name>, body: &Expr, span: Span) -> Result<()> {
        let model = self.model;
        if model.times.len() < 2 {
            return Ok(());
        }
        let mut used = BTreeSet::new();
        model.collect(body, &mut used);
        let mut clocks: BTreeSet<Clock> = BTreeSet::new();
        for node in used {
            clocks.extend(self.clocks(node));
        }
        crate::expr::walk::visit(body, &mut |e| {
            if let ExprKind::Name(name) | ExprKind::Apply { function: name, .. } = &e.kind
                && let Ok(Resolved::Letter { symbol, .. }) = model.resolve(name, &|_| false)
            {
                clocks.insert(model.clock(symbol));
            }
        });
        clocks.retain(|c| matches!(c, Clock::Runs(_)));
        if let Some(name) = time {
            clocks.insert(Clock::Runs(crate::latex::canonical(name)));
        }
        if clocks.len() > 1 {
            return Err(two_times(span));
        }
        Ok(())
    }
}

fn unclear(span: Span) -> Failure {
    let what = "a dot over what is a function of another letter than the time";
    Failure::unsupported(what, span)
}

fn two_times(span: Span) -> Failure {
    Failure::unsupported("a dot over what depends on two letters for the time", span)
}
