//! What letters stand for: their values at the point, and the layers that lie over it.
//!
//! A layer replaces a letter, adds an infinitesimal to it, lets time pass, or gives the unknowns of a
//! system their forms. Each layer says what a letter is in terms of the layers below it, so that
//! derivatives inside of integrals inside of derivatives mean what they say. A process is a free jet: its
//! value and each of its derivatives are letters of their own, but for those that an equation of
//! motion determines.

use super::evaluator::{Evaluator, Key, Result};
use super::failure::Reason;
use super::jet::Jet;
use super::value::Value;
use super::world::{Behind, World, normal};
use crate::expr::{Expr, Name};
use crate::latex;
use crate::model::Node;
use crate::model::names::Resolved;
use crate::model::range::Numbers;
use crate::span::Span;
use num_rational::BigRational;
use std::collections::BTreeMap;

/// The highest derivative that is computed.
const HIGHEST_ORDER: usize = 16;

/// What letters stand for, and the values computed so.
#[derive(Debug)]
pub(super) struct Layer {
    pub kind: LayerKind,
    /// Tells it from every other layer, those that lay at its depth before among them.
    pub number: u64,
    pub known: BTreeMap<Key, Value>,
}

#[derive(Debug)]
pub(super) enum LayerKind {
    /// A symbol has this value; `bound` where it is the variable of an integral.
    Replaced {
        symbol: usize,
        value: Jet,
        bound: bool,
    },
    /// An infinitesimal is added to a symbol or to one of its derivatives.
    Shifted {
        symbol: usize,
        order: u8,
        variable: usize,
    },
    /// Time passes, by an infinitesimal.
    Passing {
        time: String,
        variable: usize,
        order: usize,
    },
    /// Symbols and their derivatives have these values.
    Given(BTreeMap<(usize, u8), Jet>),
    /// Processes are taken at a number.
    At(BigRational),
    /// The unknowns of a system have these values.
    Unknowns { system: usize, values: Vec<Value> },
}

impl Layer {
    pub fn new(kind: LayerKind, number: u64) -> Self {
        Layer {
            kind,
            number,
            known: BTreeMap::new(),
        }
    }

    /// Whether something that depends on these has another value with this layer than without.
    pub fn affects(&self, behind: &Behind, world: &World<'_>) -> bool {
        match &self.kind {
            LayerKind::Replaced { symbol, .. } | LayerKind::Shifted { symbol, .. } => {
                behind.symbols.contains(symbol)
            }
            LayerKind::Passing { time, .. } => {
                let mut symbols = behind.symbols.iter();
                symbols.any(|s| world.changes_with(*s, time))
            }
            LayerKind::Given(values) => values.keys().any(|(s, _)| behind.symbols.contains(s)),
            LayerKind::At(_) => {
                let processes = |s: &usize| world.model.symbols[*s].function_of.is_some();
                behind.symbols.iter().any(processes)
            }
            LayerKind::Unknowns { system, .. } => behind.nodes.contains(&normal(Node::Unknown {
                system: *system,
                position: 0,
            })),
        }
    }
}

impl Evaluator<'_, '_> {
    /// Runs `body` with a layer over the others.
    pub(super) fn with_layer<T>(
        &mut self,
        kind: LayerKind,
        body: impl FnOnce(&mut Self) -> T,
    ) -> T {
        let depth = self.layers.len();
        self.push_layer(kind);
        let result = body(self);
        self.layers.truncate(depth);
        result
    }

    pub(super) fn push_layer(&mut self, kind: LayerKind) {
        self.layers_so_far += 1;
        self.layers.push(Layer::new(kind, self.layers_so_far));
    }

    /// Runs `body` with the lowest `depth` layers only.
    pub(super) fn below<T>(&mut self, depth: usize, body: impl FnOnce(&mut Self) -> T) -> T {
        let mut upper = self.layers.split_off(depth.min(self.layers.len()));
        let result = body(self);
        self.layers.append(&mut upper);
        result
    }

    /// Whether a derivative by a complex letter is being computed.
    pub(super) fn differentiates_by_complex(&self) -> bool {
        self.layers.iter().any(|layer| match &layer.kind {
            LayerKind::Shifted { symbol, .. } => {
                self.world.model.symbols[*symbol].range.numbers == Numbers::Complex
            }
            LayerKind::Replaced { .. }
            | LayerKind::Passing { .. }
            | LayerKind::Given(_)
            | LayerKind::At(_)
            | LayerKind::Unknowns { .. } => false,
        })
    }

    /// The value of a symbol or of its time derivative of an order.
    pub(super) fn letter(&mut self, symbol: usize, order: u8, span: Span) -> Result<Jet> {
        if self.world.model.is_spectrum(symbol) {
            let what = "an eigenvalue outside of Re λ(A) compared with a number";
            return Err(Reason::Unsupported(what).at(span));
        }
        if order > 0 {
            if let Some(value) = self.by_motion(symbol, order, span)? {
                return Ok(value);
            }
            let declared = &self.world.model.symbols[symbol];
            if declared.function_of.is_none() {
                if self.world.times.is_empty() {
                    return Err(Reason::Unsupported("a dot without a known time").at(span));
                }
                self.refuse_tied(symbol, span)?;
                let is_time = declared.entry_of.is_none() && self.world.is_time(&declared.name);
                return Ok(Jet::integer(i64::from(is_time && order == 1)));
            }
        }
        self.free_letter(symbol, order, span)
    }

    /// Nothing, unless a hypothesis ties a constant to the time.
    fn refuse_tied(&self, symbol: usize, span: Span) -> Result<()> {
        if self.point.tangle.moving.contains(&symbol) {
            let what = "the rate of a constant that a hypothesis ties to the time";
            return Err(Reason::Unsupported(what).at(span));
        }
        Ok(())
    }

    /// A derivative that an equation of motion gives.
    fn by_motion(&mut self, symbol: usize, order: u8, span: Span) -> Result<Option<Jet>> {
        let model = self.world.model;
        let declared = &model.symbols[symbol];
        let mut name = match declared.entry_of {
            Some((matrix, ..)) => model.matrices[matrix].name.clone(),
            None => declared.name.clone(),
        };
        name.dots = name.dots.saturating_add(order);
        let Ok(Resolved::Node { node, derivatives }) = model.resolve(&name, &|_| false) else {
            return Ok(None);
        };
        if matches!(node, Node::Matrix(_) | Node::Symbol(_)) {
            return Ok(None);
        }
        let value = self.node_rate(node, derivatives, span)?;
        let at = declared.entry_of.map_or((0, 0), |(_, i, j)| (i, j));
        match value {
            Value::Scalar(x) if at == (0, 0) => Ok(Some(x)),
            Value::Matrix(m) if at.0 < m.rows() && at.1 < m.columns() => Ok(Some(m[at].clone())),
            Value::Zero => Ok(Some(Jet::zero())),
            Value::Scalar(_) | Value::Matrix(_) => {
                Err(Reason::Unsupported("a derivative of another shape").at(span))
            }
        }
    }

    fn free_letter(&mut self, symbol: usize, order: u8, span: Span) -> Result<Jet> {
        let model = self.world.model;
        let Some(top) = self.layers.len().checked_sub(1) else {
            let value = self.point.value(model, symbol, order, self.arithmetic.bits);
            let value = value
                .ok_or_else(|| Reason::Unsupported("a derivative of so high an order").at(span))?;
            self.used.insert((symbol, order), value.clone());
            return Ok(Jet::Number(value));
        };
        match &self.layers[top].kind {
            LayerKind::Replaced {
                symbol: replaced,
                value,
                ..
            } => {
                if *replaced == symbol {
                    return if order == 0 {
                        Ok(value.clone())
                    } else {
                        Err(Reason::Unsupported("a derivative of an argument").at(span))
                    };
                }
                if model.argument_symbols(symbol).any(|s| s == *replaced) {
                    return Err(Reason::Unsupported("a process at another argument").at(span));
                }
                self.below(top, |e| e.letter(symbol, order, span))
            }
            LayerKind::Shifted {
                symbol: shifted,
                order: of,
                variable,
            } => {
                let (own, variable) = (*shifted == symbol && *of == order, *variable);
                if *shifted != symbol && model.argument_symbols(symbol).any(|s| s == *shifted) {
                    return Err(Reason::Unsupported("a partial derivative of a process").at(span));
                }
                let value = self.below(top, |e| e.letter(symbol, order, span))?;
                let step = || Jet::series(variable, vec![Jet::zero(), Jet::integer(1)]);
                Ok(if own {
                    self.arithmetic.add(&value, &step())
                } else {
                    value
                })
            }
            LayerKind::Passing {
                time,
                variable,
                order: highest,
            } => {
                let (variable, highest) = (*variable, *highest);
                let changes = self.world.changes_with(symbol, time);
                let replaced = self.layers[..top].iter().any(|layer| {
                    matches!(&layer.kind, LayerKind::Replaced { symbol: s, bound: false, .. } if *s == symbol)
                });
                if replaced {
                    return Err(Reason::Unsupported("a rate of an argument").at(span));
                }
                let first = self.below(top, |e| e.letter(symbol, order, span))?;
                if !changes {
                    self.refuse_tied(symbol, span)?;
                    return Ok(first);
                }
                let mut terms = vec![first];
                for k in 1..=highest {
                    let higher = u8::try_from(usize::from(order) + k)
                        .map_err(|_| Reason::Budget("the order of a derivative").at(span))?;
                    let rate = self.below(top, |e| e.letter(symbol, higher, span))?;
                    let mut factorial = Jet::integer(1);
                    factorial = self
                        .arithmetic
                        .times_factorial(&factorial, k)
                        .map_err(|r| r.at(span))?;
                    let term = self.arithmetic.divide(&rate, &factorial);
                    terms.push(term.map_err(|r| r.at(span))?);
                }
                Ok(Jet::series(variable, terms))
            }
            LayerKind::Given(values) => match values.get(&(symbol, order)) {
                Some(value) => Ok(value.clone()),
                None => self.below(top, |e| e.letter(symbol, order, span)),
            },
            LayerKind::At(_) => {
                if model.symbols[symbol].function_of.is_some() {
                    let what = "the value of a process where nothing says it";
                    return Err(Reason::Unsupported(what).at(span));
                }
                self.below(top, |e| e.letter(symbol, order, span))
            }
            LayerKind::Unknowns { .. } => self.below(top, |e| e.letter(symbol, order, span)),
        }
    }

    /// A node's time derivative of an order.
    pub(super) fn node_rate(&mut self, node: Node, order: u8, span: Span) -> Result<Value> {
        if order == 0 {
            return self.node((node, Vec::new()), span);
        }
        let behind = self.world.behind(node);
        self.rate(order, &behind, None, span, |e| {
            e.node((node, Vec::new()), span)
        })
    }

    /// `d/dx`, dots over an expression, and `\partial`.
    pub(super) fn derivative(
        &mut self,
        order: u8,
        variable: Option<&Name>,
        body: &Expr,
        span: Span,
    ) -> Result<Value> {
        let behind = self.world.behind_expression(body);
        let letter = match variable {
            None => return self.rate(order, &behind, None, span, |e| e.expression(body)),
            Some(letter) if self.world.is_time(letter) => {
                let time = latex::canonical(letter);
                // What it holds fixed, the print does not say.
                let processes = |s: &usize| self.world.model.symbols[*s].function_of.is_some();
                if self.world.model.is_partial(span) && behind.symbols.iter().any(processes) {
                    return Err(Reason::Unsupported("a partial derivative by the time").at(span));
                }
                return self.rate(order, &behind, Some(time), span, |e| e.expression(body));
            }
            Some(letter) => letter,
        };
        let resolved = self.world.model.resolve(letter, &|_| false);
        let Ok(Resolved::Letter { symbol, order: of }) = resolved else {
            return Err(Reason::Unsupported("a derivative by what is no letter").at(span));
        };
        if self.world.model.symbols[symbol].range.numbers == Numbers::Integer {
            return Err(Reason::Unsupported("a derivative by an integer").at(span));
        }
        if self.point.tangle.symbols.contains(&symbol) {
            let what = "a derivative by a letter that a hypothesis is about";
            return Err(Reason::Unsupported(what).at(span));
        }
        self.partial(symbol, of, order, span, |e| e.expression(body))
    }

    /// The partial derivative of what `body` computes by a symbol or by a derivative of it.
    pub(super) fn partial(
        &mut self,
        symbol: usize,
        of: u8,
        order: u8,
        span: Span,
        body: impl FnOnce(&mut Self) -> Result<Value>,
    ) -> Result<Value> {
        let order = usize::from(order);
        if order > HIGHEST_ORDER {
            return Err(Reason::Budget("the order of a derivative").at(span));
        }
        let variable = self.arithmetic.open(order);
        let kind = LayerKind::Shifted {
            symbol,
            order: of,
            variable,
        };
        let value = self.with_layer(kind, body);
        self.taken_apart(value, variable, order, span)
    }

    /// The total time derivative of what `body` computes, which depends on these.
    pub(super) fn rate(
        &mut self,
        order: u8,
        behind: &Behind,
        time: Option<String>,
        span: Span,
        body: impl FnOnce(&mut Self) -> Result<Value>,
    ) -> Result<Value> {
        let order = usize::from(order);
        if order > HIGHEST_ORDER {
            return Err(Reason::Budget("the order of a derivative").at(span));
        }
        let mut times: Vec<String> = self.world.times.iter().cloned().collect();
        times.retain(|t| {
            behind
                .symbols
                .iter()
                .any(|s| self.world.changes_with(*s, t))
        });
        let time = match (time, times.as_slice()) {
            (Some(time), _) => time,
            (None, [only]) => only.clone(),
            (None, []) => match self.world.times.first() {
                Some(any) => any.clone(),
                None => return Err(Reason::Unsupported("a dot without a known time").at(span)),
            },
            (None, _) => return Err(Reason::Unsupported("dots by more than one letter").at(span)),
        };
        let variable = self.arithmetic.open(order);
        let kind = LayerKind::Passing {
            time,
            variable,
            order,
        };
        let value = self.with_layer(kind, body);
        self.taken_apart(value, variable, order, span)
    }

    /// The coefficient that is the derivative.
    fn taken_apart(
        &mut self,
        value: Result<Value>,
        variable: usize,
        order: usize,
        span: Span,
    ) -> Result<Value> {
        self.arithmetic.close();
        let a = &self.arithmetic;
        value?
            .map(|entry| a.times_factorial(&entry.coefficient(variable, order), order))
            .map_err(|r| r.at(span))
    }
}
