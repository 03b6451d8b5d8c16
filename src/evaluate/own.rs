//! Functions with a value of their own at a number: `F(x) = \frac{\sin x}{x}, \quad F(0) = 1`.
//!
//! At an argument that is this number identically the value is the one given; at one that certainly is another number
//! it is the general one. At any other argument it may be either, and there is none here. Where the general
//! definition has a value at the number too, it must be the same one; else the document contradicts itself, and nothing
//! that rests on the function has a value.

use super::{Evaluator, Failure, FailureKind, Value, value};
use crate::domain::Domain;
use crate::expr::Expr;
use crate::functions::Sign;
use crate::model::names::Resolved;
use crate::model::{DefinitionKind, Node};
use crate::span::Span;
use num_rational::BigRational;

type Result<T> = std::result::Result<T, Failure>;

impl<D: Domain> Evaluator<'_, D> {
    /// That a definition has a value: of a function with values of its own, that these do not contradict it.
    ///
    /// # Errors
    /// Why it has none.
    pub fn defined(&mut self, definition: usize, span: Span) -> Result<()> {
        if self.model.exceptions(definition).is_empty() {
            let key = (Node::Definition(definition), Vec::new(), 0);
            return self.value_of(key, span).map(|_| ());
        }
        self.own_values(definition, span)?;
        self.printed_value(definition, span).map(|_| ())
    }

    /// The value of its own that a function has where its letter stands for what it stands for now; none where that is
    /// certainly no number at which it has one.
    pub(super) fn own_value_here(
        &mut self,
        definition: usize,
        span: Span,
    ) -> Result<Option<Value<D::Element>>> {
        let model = self.model;
        if let DefinitionKind::ValueAt(_) = model.definitions[definition].kind {
            let general = model.resolve(&model.definitions[definition].name, &|_| false);
            if let Ok(Resolved::Node {
                node: Node::Definition(general),
                ..
            }) = general
                && !model.exceptions(general).is_empty()
            {
                self.own_values(general, span)?;
            }
            return Ok(None);
        }
        if model.exceptions(definition).is_empty() {
            return Ok(None);
        }
        let (own, letter) = self.own_values(definition, span)?;
        let argument = self.letter(letter).clone();
        for (at, value) in own {
            let difference = self.field.subtract(&argument, &at);
            if self.field.is_zero(&difference) {
                return self.printed_value(value, span).map(Some);
            }
            let constant = self.field.letters_behind(&difference).is_empty();
            let functions = self.field.functions();
            let known: Vec<_> = self
                .choice
                .known()
                .iter()
                .chain(&self.frame.between)
                .cloned()
                .collect();
            let sign = functions.and_then(|f| f.sign_where(&difference, &known));
            if !constant && !matches!(sign, Some(Sign::Positive | Sign::Negative)) {
                let what = "a function where its argument may be a number at which it has a value of its own";
                return Err(Failure::unsupported(what, span));
            }
        }
        Ok(None)
    }

    /// The numbers at which a function has a value that its general definition does not give, with the definitions
    /// of these values, and the letter that it is a function of.
    fn own_values(
        &mut self,
        definition: usize,
        span: Span,
    ) -> Result<(Vec<(D::Element, usize)>, usize)> {
        let model = self.model;
        let unclear = || Failure::unsupported("a function of what is no letter", span);
        let parameters = self.parameters(&model.definitions[definition]);
        let [parameter] = &parameters[..] else {
            return Err(unclear());
        };
        let Ok(Resolved::Letter { symbol, order: 0 }) = model.resolve(parameter, &|_| false) else {
            return Err(unclear());
        };
        let letter = model.letter_of_symbol(symbol, 0).ok_or_else(unclear)?;
        let range = self.range_of(&model.definitions[definition], &parameters);
        let mut own = Vec::new();
        for (at, given) in model.exceptions(definition) {
            if self
                .symbols_behind(Node::Definition(given))
                .contains(&symbol)
            {
                let what = "a value of a function at a number that depends on its argument";
                return Err(Failure::unsupported(what, span));
            }
            let there = self.number(&at, span)?;
            let image = there.clone();
            let conditions = self.conditions.len();
            let (general, cases) = self.in_case(0, |e| {
                e.with_symbols(vec![(symbol, image)], |e| {
                    e.suppose_range(&range, span)?;
                    e.printed_value(definition, span)
                })
            });
            self.conditions.truncate(conditions);
            let general = match general {
                Ok(general) if cases <= 1 => general,
                // It has none there, or not one that is known.
                Ok(_) | Err(_) => {
                    own.push((there, given));
                    continue;
                }
            };
            let printed = self.printed_value(given, span)?;
            let difference = value::subtract(&self.field, &general, &printed, span)?;
            if difference.entries().iter().any(|e| !self.field.is_zero(e)) {
                let what = "a function with two values at one number";
                return Err(Failure::unsupported(what, span));
            }
        }
        Ok((own, letter))
    }

    fn number(&self, at: &BigRational, span: Span) -> Result<D::Element> {
        let number = self.field.rational(at);
        number.ok_or_else(|| Failure::new(FailureKind::DivisionByZero, span))
    }

    /// The value of what is printed as a definition's.
    fn printed_value(&mut self, definition: usize, span: Span) -> Result<Value<D::Element>> {
        let expr = self.printed(definition, span)?;
        let at = self.frame.at.take();
        let bound = std::mem::take(&mut self.frame.bound);
        let value = self.expression(&expr);
        self.frame.bound = bound;
        self.frame.at = at;
        value
    }

    /// What is printed as a definition's value.
    pub(super) fn printed(&self, definition: usize, span: Span) -> Result<Expr> {
        let printed = &self.model.definitions[definition];
        let expr = printed.place.find(self.display(printed.equation)).cloned();
        expr.ok_or_else(|| Failure::unsupported("a definition without a value", span))
    }
}
