//! Functions: defined ones at any argument, the letters of the field, integrals and derivatives by a
//! named letter.
//!
//! A function's body is evaluated with its letters standing for the arguments; what does not depend
//! on these letters keeps the value it has. The variable of an integral is a letter of its own, so
//! that it cannot be mistaken for the same letter outside.

use super::{Evaluator, Failure, FailureKind, Value};
use crate::domain::Domain;
use crate::expr::{Expr, ExprKind, Function, Name, Sign};
use crate::functions::integral::End;
use crate::functions::{Constant, Functions, Impossible, Possible, Sign as KnownSign, Supposed};
use crate::latex;
use crate::model::links::Place;
use crate::model::names::{Resolved, literal_number};
use crate::model::range::Numbers;
use crate::model::time::Constancy;
use crate::model::{Definition, Letter, Node, NotationKind};
use crate::span::Span;
use std::cmp::Ordering;

type Result<T> = std::result::Result<T, Failure>;

impl<D: Domain> Evaluator<'_, D> {
    /// What the field can do with functions.
    pub(super) fn functions(&self, what: &str, span: Span) -> Result<&dyn Functions<D::Element>> {
        self.field
            .functions()
            .ok_or_else(|| Failure::unsupported(what, span))
    }

    pub(super) fn possible<T>(result: Possible<T>, span: Span) -> Result<T> {
        result.map_err(|why| Failure::impossible(why, span))
    }

    pub(super) fn constant(&self, constant: Constant, span: Span) -> Result<Value<D::Element>> {
        let functions = self.functions("a constant without a letter", span)?;
        Self::possible(functions.constant(constant), span).map(Value::Scalar)
    }

    /// A function of notation.
    pub(super) fn function_of(
        &self,
        function: Function,
        argument: &Value<D::Element>,
        span: Span,
    ) -> Result<Value<D::Element>> {
        let Value::Scalar(argument) = argument else {
            return Err(Failure::unsupported("a function of a matrix", span));
        };
        let functions = self.functions("a function whose values need not be rational", span)?;
        Self::possible(functions.call(function, argument), span).map(Value::Scalar)
    }

    /// A power whose exponent is no literal integer.
    pub(super) fn general_power(
        &mut self,
        base: &Expr,
        exponent: &Expr,
        failure: Failure,
    ) -> Result<Value<D::Element>> {
        let span = base.span.to(exponent.span);
        if self.field.functions().is_none() {
            // Whoever can ask a field with functions must hear that this one has none.
            return Err(match self.model.functions {
                Some(_) => Failure::unsupported("a power with such an exponent", span),
                None => failure,
            });
        }
        let Value::Scalar(power) = self.expression(exponent)? else {
            return Err(failure);
        };
        if let ExprKind::Name(name) = &base.kind
            && let Ok(Resolved::Node { node, .. }) = self.model.resolve(name, &|_| false)
            && let Node::Notation(n) = node
            && matches!(
                self.model.notation[n].kind,
                NotationKind::Constant(Constant::Euler)
            )
        {
            let functions = self.functions("", span)?;
            let value = functions.call(Function::Exponential, &power);
            return Self::possible(value, span).map(Value::Scalar);
        }
        let Value::Scalar(base) = self.expression(base)? else {
            return Err(failure);
        };
        let functions = self.functions("", span)?;
        if functions.sign(&base) != Some(Ordering::Greater) {
            self.conditions.push(super::Condition {
                divisor: base.clone(),
                origin: super::Origin::Divisor(span),
            });
        }
        let functions = self.functions("", span)?;
        Self::possible(functions.power(&base, &power), span).map(Value::Scalar)
    }

    /// A name applied to arguments: a process at its own letter, a defined function at any
    /// argument, the Dirac distribution.
    pub(super) fn apply(
        &mut self,
        function: &Name,
        arguments: &[Expr],
        span: Span,
    ) -> Result<Value<D::Element>> {
        let node = match self.model.resolve(function, &|_| false) {
            Ok(Resolved::Node {
                node,
                derivatives: 0,
            }) => Some(node),
            Ok(Resolved::Primed { node, primes }) => {
                let [argument] = arguments else {
                    let what = "the derivative of a function with several arguments";
                    return Err(Failure::unsupported(what, span));
                };
                return self.derivative_by_argument(node, primes, Some(argument), span);
            }
            _ => None,
        };
        if let Some(Node::Notation(n)) = node
            && matches!(self.model.notation[n].kind, NotationKind::Dirac)
            && let [argument] = arguments
        {
            let Value::Scalar(argument) = self.expression(argument)? else {
                return Err(Failure::unsupported("a distribution of a matrix", span));
            };
            self.refuse_at_an_end(&argument, span)?;
            let functions = self.functions("the Dirac distribution", span)?;
            return Self::possible(functions.dirac(&argument), span).map(Value::Scalar);
        }
        if let [argument] = arguments
            && let Some(at) = literal_number(argument)
            && self.model.has_values_at(&at)
            && !node.is_some_and(|node| self.model.is_function_of_no_time(node, &at))
        {
            return self.taken_at(function, &at, span);
        }
        if let Some(definition) = node.and_then(|node| self.model.function_definition(node)) {
            let parameters = self.parameters(definition);
            let range = self.range_of(definition, &parameters);
            let images = self.images(&parameters, arguments, span)?;
            return self.with_symbols(images, |e| {
                // A value of its own belongs to it, whatever the range of the general ones is.
                if let Some(Node::Definition(d)) = node
                    && let Some(value) = e.own_value_here(d, span)?
                {
                    return Ok(value);
                }
                e.suppose_range(&range, span)?;
                e.name(function, span)
            });
        }
        if self.model.is_plain_application(function, arguments) {
            self.name(function, span)
        } else {
            Err(Failure::unsupported("a function at another argument", span))
        }
    }

    /// Refuses a distribution where an integral over it may end: which half of it counts is not written.
    fn refuse_at_an_end(&self, argument: &D::Element, span: Span) -> Result<()> {
        let functions = self.functions("the Dirac distribution", span)?;
        let occurring = self.field.letters_behind(argument);
        for (variable, from, to) in &self.frame.open_integrals {
            let letters = self.field.letters(variable);
            let [letter] = letters[..] else { continue };
            if !occurring.contains(&letter) {
                continue;
            }
            for end in [from, to] {
                let End::At(end) = end else { continue };
                let there = Self::possible(functions.put(argument, letter, end), span)?;
                if !matches!(
                    functions.sign(&there),
                    Some(Ordering::Less | Ordering::Greater)
                ) {
                    let what = "a distribution at the end of an integral";
                    return Err(Failure::unsupported(what, span));
                }
            }
        }
        Ok(())
    }

    /// The letters that a definition is one of functions of, as corrected.
    pub(super) fn parameters(&self, definition: &Definition) -> Vec<Name> {
        let clause = definition.place.clause();
        let head = Place::Member { clause, member: 0 };
        let arguments = match head
            .find(self.display(definition.equation))
            .map(|e| &e.kind)
        {
            Some(ExprKind::Apply { arguments, .. }) => arguments.as_slice(),
            _ => &[],
        };
        let names: Vec<Name> = arguments
            .iter()
            .filter_map(|argument| argument.as_name().cloned())
            .collect();
        if names.len() == definition.arguments.len() {
            names
        } else {
            definition.arguments.clone()
        }
    }

    /// What the letters of a defined function are replaced by: by position, or by name as in `R(x = 0)`.
    fn images(
        &mut self,
        parameters: &[Name],
        arguments: &[Expr],
        span: Span,
    ) -> Result<Vec<(usize, D::Element)>> {
        let mut images = Vec::new();
        for (position, argument) in arguments.iter().enumerate() {
            let by_position = || parameters.get(position).map(|name| (name, argument));
            let (name, value) = argument
                .as_named_argument()
                .or_else(by_position)
                .ok_or_else(|| Failure::unsupported("more arguments than declared", span))?;
            let Ok(Resolved::Letter { symbol, order: 0 }) = self.model.resolve(name, &|_| false)
            else {
                let name = latex::canonical(name);
                return Err(Failure::new(
                    FailureKind::Undeclared { name },
                    argument.span,
                ));
            };
            let Value::Scalar(image) = self.expression(value)? else {
                return Err(Failure::unsupported(
                    "a matrix as an argument",
                    argument.span,
                ));
            };
            images.push((symbol, image));
        }
        Ok(images)
    }

    /// An integral, over a letter of its own.
    pub(super) fn integral(
        &mut self,
        limits: Option<(&Expr, &Expr)>,
        body: &Expr,
        variable: &Name,
        span: Span,
    ) -> Result<Value<D::Element>> {
        let Some((from, to)) = limits else {
            return Err(Failure::unsupported("an integral without limits", span));
        };
        self.functions("an integral", span)?;
        let from = self.end(from)?;
        let to = self.end(to)?;
        let Ok(Resolved::Letter { symbol, order: 0 }) = self.model.resolve(variable, &|_| false)
        else {
            let name = latex::canonical(variable);
            return Err(Failure::new(FailureKind::Undeclared { name }, span));
        };
        let functions = self.functions("an integral", span)?;
        // Between two numbers that are not negative.
        let positive = [&from, &to].into_iter().all(|end| match end {
            End::At(end) => functions
                .sign_where(end, &[])
                .is_some_and(KnownSign::is_not_negative),
            End::Above => true,
            End::Below => false,
        });
        let letter = Self::possible(functions.bound(self.frame.integrals, positive), span)?;
        let outer = self.frame.between.len();
        let between = self.between(&letter, &from, &to);
        self.frame.between.extend(between);
        self.frame
            .open_integrals
            .push((letter.clone(), from.clone(), to.clone()));
        self.frame.integrals += 1;
        let before = std::mem::take(&mut self.conditions);
        let integrand = self.with_symbols(vec![(symbol, letter.clone())], |e| e.expression(body));
        let inside = std::mem::replace(&mut self.conditions, before);
        self.frame.integrals -= 1;
        self.frame.between.truncate(outer);
        self.frame.open_integrals.pop();
        for condition in &inside {
            if !self.conditions.contains(condition) {
                self.conditions.push(condition.clone());
            }
        }
        let integrand = integrand?;
        let functions = self.functions("an integral", span)?;
        let variable = self.field.letters(&letter).first().copied();
        let vanishes = |condition: &super::Condition<D::Element>| {
            let entries = integrand.entries();
            variable.is_some_and(|l| {
                let at = |f: &D::Element| functions.vanishes_at_a_support(f, l, &condition.divisor);
                entries.into_iter().any(at)
            })
        };
        if inside.iter().any(vanishes) {
            let what = "an integral over a factor that has no value where a distribution stands";
            return Err(Failure::unsupported(what, span));
        }
        let of_matrix = matches!(integrand, Value::Matrix(_));
        let over = |entry: &D::Element| {
            let value = functions.integral(entry, &letter, &from, &to);
            // An entry says nothing of what the whole grows to.
            let value = value.map_err(|why| match why {
                Impossible::Divergent { reason, .. } if of_matrix => Impossible::Divergent {
                    reason,
                    towards: None,
                },
                why @ (Impossible::Unsupported(_)
                | Impossible::Divergent { .. }
                | Impossible::DivisionByZero
                | Impossible::NoLetter) => why,
            });
            Self::possible(value, span)
        };
        integrand.try_map(over)
    }

    /// That the variable of an integral lies between its ends, where these are known to be in order.
    fn between(
        &self,
        letter: &D::Element,
        from: &End<D::Element>,
        to: &End<D::Element>,
    ) -> Vec<Supposed<D::Element>> {
        let Some(functions) = self.field.functions() else {
            return Vec::new();
        };
        if let (End::At(from), End::At(to)) = (from, to) {
            let length = functions.sign_where(&self.field.subtract(to, from), &[]);
            if !length.is_some_and(KnownSign::is_not_negative) {
                return Vec::new();
            }
        }
        let mut all = Vec::new();
        let mut suppose = |element| {
            all.push(Supposed {
                element,
                strict: true,
            })
        };
        if let End::At(from) = from {
            suppose(self.field.subtract(letter, from));
        }
        if let End::At(to) = to {
            suppose(self.field.subtract(to, letter));
        }
        all
    }

    fn end(&mut self, expr: &Expr) -> Result<End<D::Element>> {
        match expr.as_infinity() {
            Some(Sign::Plus) => Ok(End::Above),
            Some(Sign::Minus) => Ok(End::Below),
            None => self
                .expression(expr)?
                .into_scalar(self.field.integer(0))
                .map(End::At)
                .ok_or_else(|| Failure::unsupported("a matrix as a limit", expr.span)),
        }
    }

    /// Both sides of a link of a chain that begins with `head`. That f(x) is constant says that its
    /// derivative by x is zero.
    ///
    /// # Errors
    /// A [`Failure`] with its place.
    pub fn sides_of_chain(
        &mut self,
        head: Option<&Expr>,
        left: &Expr,
        right: &Expr,
    ) -> Result<super::Sides<D::Element>> {
        let other = if left.kind == ExprKind::Constant {
            right
        } else if right.kind == ExprKind::Constant {
            left
        } else {
            return self.sides(left, right);
        };
        match self.model.constancy(head) {
            Constancy::Letter(name) => {
                let rate = self.derivative(1, name, other, other.span)?;
                Ok((rate, Value::Zero))
            }
            Constancy::Time => self.sides(left, right),
            Constancy::Unclear => {
                let what = "a constant where nothing says in which letter";
                Err(Failure::unsupported(what, other.span))
            }
        }
    }

    /// `d/dx`: by the time, every process moves; by any other letter nothing else does.
    pub(super) fn derivative(
        &mut self,
        order: u8,
        variable: &Name,
        body: &Expr,
        span: Span,
    ) -> Result<Value<D::Element>> {
        let Ok(Resolved::Letter { symbol, order: 0 }) = self.model.resolve(variable, &|_| false)
        else {
            return Err(Failure::unsupported(
                "a derivative by what is no letter",
                span,
            ));
        };
        if self.model.symbols[symbol].range.numbers == Numbers::Integer {
            return Err(Failure::unsupported("a derivative by an integer", span));
        }
        let letter = self.model.letter_of_symbol(symbol, 0);
        let letter = letter.ok_or_else(|| Failure::unsupported("this derivative", span))?;
        // Under an integral the letter is the variable of integration. A hypothesis that gives it a
        // value leaves nothing to differentiate by.
        let at = self.letter(letter).clone();
        let own = self.field.partial_derivatives(&at);
        let one = self.field.integer(1);
        let letter = match own.as_deref() {
            None => letter,
            Some([(own, slope)])
                if *slope == one
                    && (*own == letter
                        || self.field.functions().is_some_and(|f| f.is_bound(*own))) =>
            {
                *own
            }
            Some(_) => {
                return Err(Failure::unsupported(
                    "a derivative by a letter that a hypothesis replaces",
                    span,
                ));
            }
        };
        if self.is_in_an_argument(symbol, letter) {
            return self.derivative_over(symbol, order, at, span, |e| e.expression(body));
        }
        let mut value = self.smooth(span, |e| e.expression(body))?;
        for _ in 0..order {
            value = value.try_map(|entry| self.partial(entry, letter, span))?;
        }
        Ok(value)
    }

    pub(super) fn partial(
        &mut self,
        element: &D::Element,
        by: usize,
        span: Span,
    ) -> Result<D::Element> {
        let partials = self
            .field
            .partial_derivatives(element)
            .ok_or_else(|| Failure::unsupported("a derivative over this field", span))?;
        let mut sum = self.field.integer(0);
        for (letter, partial) in partials {
            let rate = if letter == by {
                self.field.integer(1)
            } else if let Letter::Abbreviation { definition } = self.model.letters[letter] {
                let outer = std::mem::take(&mut self.frame.bound);
                let key = (Node::Definition(definition), Vec::new(), 0);
                let behind = self.compute(&key, span);
                self.frame.bound = outer;
                match behind? {
                    Value::Scalar(behind) => self.partial(&behind, by, span)?,
                    Value::Zero => self.field.integer(0),
                    Value::Matrix(_) => {
                        return Err(Failure::unsupported("a derivative of a matrix", span));
                    }
                }
            } else {
                let steps = self.field.functions().and_then(|f| f.chain(letter));
                let mut rate = self.field.integer(0);
                for (factor, argument) in Self::possible(steps.unwrap_or(Ok(Vec::new())), span)? {
                    let inner = self.partial(&argument, by, span)?;
                    rate = self.field.add(&rate, &self.field.multiply(&factor, &inner));
                }
                rate
            };
            sum = self.field.add(&sum, &self.field.multiply(&partial, &rate));
        }
        Ok(sum)
    }
}
