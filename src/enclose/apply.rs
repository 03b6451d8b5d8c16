//! Functions that a document defines, at any argument in their range; definitions by cases; and
//! whether a condition is true.

use super::arithmetic::Arithmetic;
use super::evaluator::{Evaluator, Result};
use super::failure::{Reason, Undefined};
use super::jet::Jet;
use super::letters::LayerKind;
use super::value::Value;
use super::world::unprimed;
use crate::expr::{Chain, Expr, ExprKind, Name, Relation, Sign};
use crate::latex;
use crate::model::names::{Resolved, literal_number};
use crate::model::{Definition, Node, NotationKind, Role};
use crate::span::Span;
use std::cmp::Ordering;

/// Whether something is true, as far as its enclosures tell.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Truth {
    /// It certainly is.
    True,
    /// It certainly is not.
    False,
    /// The enclosures do not tell.
    Unknown,
}

impl Truth {
    fn of(known: Option<bool>) -> Self {
        match known {
            Some(true) => Truth::True,
            Some(false) => Truth::False,
            None => Truth::Unknown,
        }
    }

    /// Both.
    #[must_use]
    pub fn and(self, other: Truth) -> Truth {
        match (self, other) {
            (Truth::False, _) | (_, Truth::False) => Truth::False,
            (Truth::True, Truth::True) => Truth::True,
            (Truth::Unknown, Truth::True | Truth::Unknown) | (Truth::True, Truth::Unknown) => {
                Truth::Unknown
            }
        }
    }
}

/// A side of a condition.
enum End {
    Below,
    At(Jet),
    Above,
}

impl Evaluator<'_, '_> {
    /// A name applied to arguments.
    pub(super) fn apply(
        &mut self,
        function: &Name,
        arguments: &[Expr],
        span: Span,
    ) -> Result<Value> {
        let model = self.world.model;
        let node = match model.resolve(function, &|_| false) {
            Ok(Resolved::Node {
                node,
                derivatives: 0,
            }) => Some(node),
            _ => None,
        };
        if let Some(Node::Notation(n)) = node
            && matches!(model.notation[n].kind, NotationKind::Dirac)
        {
            return Err(Reason::Unsupported("the Dirac distribution").at(span));
        }
        if let Some(derived) = self.by_primes(function, node) {
            return self.primed(&derived, function.letter.primes, arguments, span);
        }
        if let [argument] = arguments
            && let Some(at) = literal_number(argument)
            && model.has_values_at(&at)
            && !node.is_some_and(|node| model.is_function_of_no_time(node, &at))
        {
            let layer = LayerKind::At(at);
            return self.with_layer(layer, |e| e.name(function, span));
        }
        if let Some(definition) = node.and_then(|node| model.function_definition(node)) {
            let images = self.images(definition, arguments, span)?;
            return self.with_images(&images, |e| {
                if let Some(Node::Definition(d)) = node
                    && let Some(value) = e.own_value_here(d, span)?
                {
                    return Ok(value);
                }
                e.within_range(definition, span)?;
                e.name(function, span)
            });
        }
        let plain = arguments.iter().all(|a| {
            matches!(&a.kind, ExprKind::Name(n)
                if model.is_argument_of(function, &latex::canonical(n)))
        });
        if plain {
            self.name(function, span)
        } else {
            Err(Reason::Unsupported("a function at another argument").at(span))
        }
    }

    /// The function whose derivative primes mean: one with a single argument that is defined without
    /// them, where no definition gives the primed name a value of its own.
    fn by_primes(&self, function: &Name, own: Option<Node>) -> Option<Name> {
        if function.letter.primes == 0 {
            return None;
        }
        let model = self.world.model;
        if let Some(Node::Definition(d)) = own
            && model.equations[model.definitions[d].equation].role == Role::Define
        {
            return None;
        }
        let plain = unprimed(function);
        let Ok(Resolved::Node {
            node,
            derivatives: 0,
        }) = model.resolve(&plain, &|_| false)
        else {
            return None;
        };
        let definition = model.function_definition(node)?;
        (definition.arguments.len() == 1).then_some(plain)
    }

    /// `f'(x)`: the derivative of f by its argument, at x.
    fn primed(&mut self, plain: &Name, order: u8, arguments: &[Expr], span: Span) -> Result<Value> {
        let model = self.world.model;
        let unsupported = || Reason::Unsupported("a derivative by what is no letter").at(span);
        let Ok(Resolved::Node { node, .. }) = model.resolve(plain, &|_| false) else {
            return Err(unsupported());
        };
        let definition = model.function_definition(node).ok_or_else(unsupported)?;
        let images = self.images(definition, arguments, span)?;
        let parameters = self.world.parameters(definition);
        let symbol = match parameters.first().map(|p| model.resolve(p, &|_| false)) {
            Some(Ok(Resolved::Letter { symbol, order: 0 })) => symbol,
            _ => return Err(unsupported()),
        };
        if self.point.tangle.symbols.contains(&symbol) && images.is_empty() {
            return Err(
                Reason::Unsupported("a derivative by a letter that a hypothesis is about").at(span),
            );
        }
        self.with_images(&images, |e| {
            e.within_range(definition, span)?;
            e.partial(symbol, 0, order, span, |e| e.name(plain, span))
        })
    }

    /// What the letters of a definition are replaced by, where it is not by themselves.
    fn images(
        &mut self,
        definition: &Definition,
        arguments: &[Expr],
        span: Span,
    ) -> Result<Vec<(usize, Jet)>> {
        let parameters = self.world.parameters(definition);
        let mut images = Vec::new();
        for (position, argument) in arguments.iter().enumerate() {
            let by_position = || parameters.get(position).map(|name| (name, argument));
            let (name, value) = argument
                .as_named_argument()
                .or_else(by_position)
                .ok_or_else(|| Reason::Unsupported("more arguments than declared").at(span))?;
            let symbol = self.plain_letter(name);
            let symbol =
                symbol.ok_or_else(|| Reason::Undeclared(latex::canonical(name)).at(span))?;
            let letter = value.as_name().and_then(|n| self.plain_letter(n));
            if letter != Some(symbol) {
                images.push((symbol, self.scalar(value)?));
            }
        }
        Ok(images)
    }

    fn plain_letter(&self, name: &Name) -> Option<usize> {
        if self.bound_value(&latex::canonical(name)).is_some() {
            return None;
        }
        match self.world.model.resolve(name, &|_| false) {
            Ok(Resolved::Letter { symbol, order: 0 }) => Some(symbol),
            _ => None,
        }
    }

    fn with_images<T>(&mut self, images: &[(usize, Jet)], body: impl FnOnce(&mut Self) -> T) -> T {
        let depth = self.layers.len();
        for (symbol, value) in images {
            let kind = LayerKind::Replaced {
                symbol: *symbol,
                value: value.clone(),
                bound: false,
            };
            self.push_layer(kind);
        }
        let result = body(self);
        self.layers.truncate(depth);
        result
    }

    /// Nothing, where the arguments lie in the range that is printed beside the definition.
    fn within_range(&mut self, definition: &Definition, span: Span) -> Result<()> {
        let world = self.world;
        for condition in world.range_of(definition) {
            match self.holds(condition)? {
                Truth::True => {}
                Truth::False => return Err(Reason::Undefined(Undefined::Range).at(span)),
                Truth::Unknown => return Err(Reason::Imprecise(Undefined::Range).at(span)),
            }
        }
        Ok(())
    }

    /// The value of its own that a function has where its letter stands for what it stands for now, if it has one.
    /// Where the general definition has a certainly different one there, it has none at all.
    pub(super) fn own_value_here(
        &mut self,
        definition: usize,
        span: Span,
    ) -> Result<Option<Value>> {
        let model = self.world.model;
        let own = model.exceptions(definition);
        if own.is_empty() {
            return Ok(None);
        }
        let parameters = self.world.parameters(&model.definitions[definition]);
        let symbol = parameters.first().and_then(|p| self.plain_letter(p));
        let unclear = || Reason::Unsupported("a function of what is no letter").at(span);
        let symbol = symbol.ok_or_else(unclear)?;
        let argument = self.letter(symbol, 0, span)?;
        for (at, value) in own {
            let there = Jet::from(crate::real::Real::rational(at));
            let printed = self.printed_value(value, span)?;
            let general = self.with_images(&[(symbol, there.clone())], |e| {
                e.within_range(&model.definitions[definition], span)?;
                e.printed_value(definition, span)
            });
            let one = match general {
                Ok(general) if agree(&general, &printed) => true,
                Ok(_) => {
                    let what = "a function with two values at one number";
                    return Err(Reason::Unsupported(what).at(span));
                }
                Err(_) => false,
            };
            match self.arithmetic.related(&argument, Relation::Equal, &there) {
                Truth::True => return Ok(Some(printed)),
                Truth::False => {}
                Truth::Unknown if one => {}
                Truth::Unknown => return Err(Reason::Imprecise(Undefined::Range).at(span)),
            }
        }
        Ok(None)
    }

    /// The value of what is printed as a definition's.
    fn printed_value(&mut self, definition: usize, span: Span) -> Result<Value> {
        let world = self.world;
        let definition = &world.model.definitions[definition];
        let printed = definition.place.find(world.display(definition.equation));
        let printed =
            printed.ok_or_else(|| Reason::Unsupported("a definition without a value").at(span))?;
        let bound = std::mem::take(&mut self.bound);
        let value = self.expression(printed);
        self.bound = bound;
        value
    }

    /// The value in the case whose conditions are met. Where several are, they must agree.
    pub(super) fn by_cases(&mut self, cases: &[(Expr, Vec<Chain>)], span: Span) -> Result<Value> {
        let mut found: Option<Value> = None;
        let mut unknown = false;
        for (value, conditions) in cases {
            let mut met = Truth::True;
            for condition in conditions {
                met = met.and(self.holds(condition)?);
            }
            match met {
                Truth::False => {}
                Truth::Unknown => unknown = true,
                Truth::True => {
                    // A case without a condition is what is left.
                    if conditions.is_empty() && (found.is_some() || unknown) {
                        continue;
                    }
                    let value = self.expression(value)?;
                    if let Some(other) = &found {
                        if !agree(other, &value) {
                            let what = "cases that contradict each other";
                            return Err(Reason::Unsupported(what).at(span));
                        }
                    } else {
                        found = Some(value);
                    }
                }
            }
        }
        match found {
            _ if unknown => Err(Reason::Imprecise(Undefined::Cases).at(span)),
            Some(value) => Ok(value),
            None => Err(Reason::Undefined(Undefined::Cases).at(span)),
        }
    }

    /// Whether a chain of relations is true.
    ///
    /// # Errors
    /// Why a member has no value.
    pub fn holds(&mut self, chain: &Chain) -> Result<Truth> {
        let mut ends = Vec::with_capacity(chain.members.len());
        for member in &chain.members {
            ends.push(self.end(member)?);
        }
        let mut all = Truth::True;
        for (pair, relation) in ends.windows(2).zip(&chain.relations) {
            let [left, right] = pair else { continue };
            all = all.and(self.compared(left, *relation, right));
        }
        Ok(all)
    }

    fn compared(&self, left: &End, relation: Relation, right: &End) -> Truth {
        match (left, right) {
            (End::At(left), End::At(right)) => self.arithmetic.related(left, relation, right),
            (End::Below, End::At(_)) | (End::At(_), End::Above) | (End::Below, End::Above) => {
                Truth::of(match relation {
                    Relation::Less | Relation::LessEqual | Relation::NotEqual => Some(true),
                    Relation::Greater | Relation::GreaterEqual | Relation::Equal => Some(false),
                    Relation::Distributed | Relation::Approximately | Relation::Tends => None,
                })
            }
            (End::At(_), End::Below) | (End::Above, End::At(_)) | (End::Above, End::Below) => {
                Truth::of(match relation {
                    Relation::Greater | Relation::GreaterEqual | Relation::NotEqual => Some(true),
                    Relation::Less | Relation::LessEqual | Relation::Equal => Some(false),
                    Relation::Distributed | Relation::Approximately | Relation::Tends => None,
                })
            }
            (End::Below, End::Below) | (End::Above, End::Above) => Truth::Unknown,
        }
    }

    fn end(&mut self, expr: &Expr) -> Result<End> {
        if let ExprKind::Infinity = expr.kind {
            return Ok(End::Above);
        }
        if let ExprKind::Sum(terms) = &expr.kind
            && let [(sign, only)] = terms.as_slice()
            && only.kind == ExprKind::Infinity
        {
            return Ok(match sign {
                Sign::Plus => End::Above,
                Sign::Minus => End::Below,
            });
        }
        if let Some(number) = literal_number(expr) {
            return Ok(End::At(Jet::from(crate::real::Real::rational(number))));
        }
        self.scalar(expr).map(End::At)
    }
}

impl Arithmetic {
    /// Whether two numbers stand in a relation.
    pub(super) fn related(&self, left: &Jet, relation: Relation, right: &Jet) -> Truth {
        let difference = self.subtract(left, right);
        let moving = difference.as_number().is_none();
        let number = difference.number();
        // Where it moves and may vanish, it is one thing before and another after.
        if moving && number.may_vanish() {
            return Truth::Unknown;
        }
        let equal = match (number.is_zero(), number.may_vanish()) {
            (true, _) => Some(true),
            (false, false) => Some(false),
            (false, true) => None,
        };
        if !number.is_real() {
            return match relation {
                Relation::Equal => Truth::of(equal),
                Relation::NotEqual => Truth::of(equal.map(|e| !e)),
                Relation::Less
                | Relation::LessEqual
                | Relation::Greater
                | Relation::GreaterEqual
                | Relation::Distributed
                | Relation::Approximately
                | Relation::Tends => Truth::Unknown,
            };
        }
        let sign = number.re.sign();
        let ends = number.re.interval(self.bits);
        let (not_above, not_below) = (!ends.high().is_positive(), !ends.low().is_negative());
        match relation {
            Relation::Equal => Truth::of(equal),
            Relation::NotEqual => Truth::of(equal.map(|e| !e)),
            Relation::Less => match sign {
                Some(sign) => Truth::of(Some(sign == Ordering::Less)),
                None if not_below => Truth::False,
                None => Truth::Unknown,
            },
            Relation::Greater => match sign {
                Some(sign) => Truth::of(Some(sign == Ordering::Greater)),
                None if not_above => Truth::False,
                None => Truth::Unknown,
            },
            Relation::LessEqual => match sign {
                Some(sign) => Truth::of(Some(sign != Ordering::Greater)),
                None if not_above => Truth::True,
                None => Truth::Unknown,
            },
            Relation::GreaterEqual => match sign {
                Some(sign) => Truth::of(Some(sign != Ordering::Less)),
                None if not_below => Truth::True,
                None => Truth::Unknown,
            },
            Relation::Distributed | Relation::Approximately | Relation::Tends => Truth::Unknown,
        }
    }
}

/// Whether two values may be the same.
fn agree(a: &Value, b: &Value) -> bool {
    match (a, b) {
        (Value::Zero, other) | (other, Value::Zero) => {
            other.entries().iter().all(|e| e.number().may_vanish())
        }
        _ => {
            a.shape() == b.shape()
                && a.entries()
                    .iter()
                    .zip(b.entries())
                    .all(|(x, y)| !x.number().is_apart_from(y.number()))
        }
    }
}
