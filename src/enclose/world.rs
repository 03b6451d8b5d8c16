//! What an evaluator asks of a document: its model, the sizes of an instance, corrected displays, and
//! what each name's value depends on.

use super::evaluator::Key;
use super::point::Point;
use super::value::Value;
use crate::expr::walk::children;
use crate::expr::{Chain, Display, Expr, ExprKind, Name, Relation};
use crate::latex;
use crate::model::links::Place;
use crate::model::names::Resolved;
use crate::model::{Definition, DefinitionKind, Model, Node};
use crate::real::Complex;
use std::collections::{BTreeMap, BTreeSet};
use std::sync::{Arc, Mutex};

/// What a value depends on.
#[derive(Clone, Debug, Default)]
pub(super) struct Behind {
    /// The symbols.
    pub symbols: BTreeSet<usize>,
    /// The nodes, all unknowns of a system being one.
    pub nodes: BTreeSet<Node>,
}

/// A document's model in one instance, as printed or as corrected.
#[derive(Debug)]
pub struct World<'m> {
    pub(super) model: &'m Model,
    pub(super) instance: usize,
    corrected: BTreeMap<usize, Display>,
    /// The letters that dots differentiate by, in canonical form.
    pub(super) times: BTreeSet<String>,
    /// The definitions of values of processes at numbers, by the canonical name of the process.
    values: BTreeMap<String, Vec<Node>>,
    behind: Mutex<BTreeMap<Node, Arc<Behind>>>,
    /// Values at the first points, which claim after claim is evaluated at: by the number of the point,
    /// the binary digits, and the name.
    known: Mutex<BTreeMap<(usize, u32, Key), Arc<Known>>>,
}

/// The value of a name at a point.
#[derive(Debug)]
pub(super) struct Known {
    pub value: Value,
    /// The letters that it was computed from.
    pub used: BTreeMap<(usize, u8), Complex>,
    /// Whether it was computed to few digits only.
    pub coarse: bool,
}

/// The points whose values are kept.
const KEPT_POINTS: usize = 6;

impl<'m> World<'m> {
    /// A model in one of its instances, with these displays in place of the printed ones.
    pub fn new(model: &'m Model, instance: usize, corrected: BTreeMap<usize, Display>) -> Self {
        let times = model.times.clone();
        let mut values: BTreeMap<String, Vec<Node>> = BTreeMap::new();
        for (d, definition) in model.definitions.iter().enumerate() {
            if let DefinitionKind::ValueAt(_) = definition.kind {
                let name = latex::canonical(&definition.name);
                values.entry(name).or_default().push(Node::Definition(d));
            }
        }
        World {
            model,
            instance,
            corrected,
            times,
            values,
            behind: Mutex::default(),
            known: Mutex::default(),
        }
    }

    /// A value that was computed before at a point without determined letters.
    pub(super) fn known(&self, point: &Point, bits: u32, key: &Key) -> Option<Arc<Known>> {
        let number = point.drawn_number().filter(|n| *n < KEPT_POINTS)?;
        let known = self.known.lock().ok()?;
        known.get(&(number, bits, key.clone())).cloned()
    }

    /// Keeps a value for other claims.
    pub(super) fn keep(&self, point: &Point, bits: u32, key: &Key, value: &Arc<Known>) {
        if let Some(number) = point.drawn_number().filter(|n| *n < KEPT_POINTS)
            && let Ok(mut known) = self.known.lock()
        {
            known.insert((number, bits, key.clone()), value.clone());
        }
    }

    /// The model.
    pub fn model(&self) -> &'m Model {
        self.model
    }

    /// The display that an equation is read from.
    pub fn display(&self, equation: usize) -> &Display {
        self.corrected
            .get(&equation)
            .unwrap_or(&self.model.equations[equation].display)
    }

    /// The size that a letter stands for in this instance.
    pub(super) fn size(&self, letter: &str) -> Option<i64> {
        let sizes = &self.model.instances[self.instance];
        sizes.get(letter).and_then(|n| i64::try_from(*n).ok())
    }

    /// What a node's value depends on, through all definitions.
    pub(super) fn behind(&self, node: Node) -> Arc<Behind> {
        if let Ok(known) = self.behind.lock()
            && let Some(found) = known.get(&node)
        {
            return found.clone();
        }
        let mut found = Behind::default();
        let mut open = vec![normal(node)];
        while let Some(node) = open.pop() {
            if !found.nodes.insert(node) {
                continue;
            }
            self.directly(node, &mut |e| self.uses(e, &mut open, &mut found.symbols));
            match node {
                Node::Symbol(s) => {
                    found.symbols.insert(s);
                }
                Node::Matrix(m) => {
                    let entries = self.model.symbols.iter().enumerate();
                    let own = entries.filter(|(_, s)| s.entry_of.is_some_and(|(of, ..)| of == m));
                    found.symbols.extend(own.map(|(s, _)| s));
                }
                Node::Definition(_) | Node::Notation(_) | Node::Unknown { .. } => {}
            }
        }
        // A process depends on what it is a function of.
        let arguments: Vec<usize> = found
            .symbols
            .iter()
            .flat_map(|s| self.model.argument_symbols(*s))
            .collect();
        found.symbols.extend(arguments);
        let found = Arc::new(found);
        if let Ok(mut known) = self.behind.lock() {
            known.insert(node, found.clone());
        }
        found
    }

    /// What an expression depends on.
    pub(super) fn behind_expression(&self, expr: &Expr) -> Behind {
        let mut found = Behind::default();
        let mut open = Vec::new();
        each(expr, &mut |e| self.uses(e, &mut open, &mut found.symbols));
        for node in open {
            let behind = self.behind(node);
            found.symbols.extend(&behind.symbols);
            found.nodes.extend(&behind.nodes);
        }
        let arguments: Vec<usize> = found
            .symbols
            .iter()
            .flat_map(|s| self.model.argument_symbols(*s))
            .collect();
        found.symbols.extend(arguments);
        found
    }

    /// Every expression that a node's value is computed from directly.
    fn directly(&self, node: Node, see: &mut impl FnMut(&Expr)) {
        match node {
            Node::Symbol(_) | Node::Matrix(_) => {}
            Node::Definition(d) => {
                let definition = &self.model.definitions[d];
                let display = self.display(definition.equation);
                if let Some(value) = definition.place.find(display) {
                    each(value, see);
                }
                for condition in self.range_of(definition) {
                    for member in &condition.members {
                        each(member, see);
                    }
                }
                let own = self.model.exceptions(d);
                for argument in definition.arguments.iter().filter(|_| !own.is_empty()) {
                    see(&Expr::new(
                        ExprKind::Name(argument.clone()),
                        Default::default(),
                    ));
                }
                for (_, value) in own {
                    let value = &self.model.definitions[value];
                    if let Some(value) = value.place.find(self.display(value.equation)) {
                        each(value, see);
                    }
                }
            }
            Node::Notation(n) => {
                if let Some(target) = self.model.notation[n].kind.target() {
                    each(target, see);
                }
            }
            Node::Unknown { system, .. } => {
                let display = self.display(self.model.systems[system].equation);
                for clause in &display.clauses {
                    for member in &clause.chain.members {
                        each(member, see);
                    }
                }
            }
        }
    }

    fn uses(&self, expr: &Expr, nodes: &mut Vec<Node>, symbols: &mut BTreeSet<usize>) {
        let mut direct = BTreeSet::new();
        match &expr.kind {
            ExprKind::Name(name) | ExprKind::Apply { function: name, .. } => {
                if let Ok(Resolved::Letter { symbol, order }) = self.model.resolve(name, &|_| false)
                {
                    symbols.insert(symbol);
                    // An equation of motion may say what a derivative is.
                    nodes.extend(self.motions(symbol, order));
                }
                // What it may be the derivative of.
                if name.letter.primes > 0 {
                    let plain = Expr::new(ExprKind::Name(unprimed(name)), expr.span);
                    self.model.collect(&plain, &mut direct);
                }
                let plain = Expr::new(ExprKind::Name(name.clone()), expr.span);
                self.model.collect(&plain, &mut direct);
                if !self.values.is_empty() {
                    let values = self.values.get(&latex::canonical(name));
                    nodes.extend(values.into_iter().flatten());
                }
            }
            ExprKind::Power { .. } => {
                // Its parts are seen on their own: here only a power that is defined as such.
                let shallow = shallow_power(expr);
                self.model.collect(&shallow, &mut direct);
            }
            ExprKind::Expectation(_) => {
                for (_, node, covariance) in self.model.covariances() {
                    nodes.push(normal(node));
                    self.model.collect(&covariance.product, &mut direct);
                }
            }
            // They name nothing, and their parts are seen on their own.
            ExprKind::Number(_)
            | ExprKind::Named { .. }
            | ExprKind::Call { .. }
            | ExprKind::Sum(_)
            | ExprKind::Product(_)
            | ExprKind::Quotient { .. }
            | ExprKind::Transpose(_)
            | ExprKind::Group { .. }
            | ExprKind::Matrix { .. }
            | ExprKind::Tuple(_)
            | ExprKind::BigSum { .. }
            | ExprKind::Integral { .. }
            | ExprKind::Derivative { .. }
            | ExprKind::Underbrace { .. }
            | ExprKind::Cases(_)
            | ExprKind::Infinity
            | ExprKind::Constant => {}
        }
        nodes.extend(direct.into_iter().map(normal));
    }

    /// The nodes that say what higher derivatives of a process are.
    pub(super) fn motions(&self, symbol: usize, order: u8) -> Vec<Node> {
        let declared = &self.model.symbols[symbol];
        if declared.function_of.is_none() {
            return Vec::new();
        }
        let name = match declared.entry_of {
            Some((matrix, ..)) => &self.model.matrices[matrix].name,
            None => &declared.name,
        };
        (order..=order.saturating_add(4))
            .filter_map(|k| {
                let mut dotted = name.clone();
                dotted.dots = dotted.dots.saturating_add(k);
                match self.model.resolve(&dotted, &|_| false) {
                    Ok(Resolved::Node { node, .. }) => match node {
                        Node::Matrix(_) => None,
                        Node::Symbol(_)
                        | Node::Definition(_)
                        | Node::Unknown { .. }
                        | Node::Notation(_) => Some(normal(node)),
                    },
                    _ => None,
                }
            })
            .collect()
    }

    /// The conditions printed beside a definition: between which numbers or letters a letter lies.
    pub(super) fn range_of(&self, definition: &Definition) -> Vec<&Chain> {
        if definition.arguments.is_empty() {
            return Vec::new();
        }
        let own = definition.place.clause();
        let clauses = self.display(definition.equation).clauses.iter();
        clauses
            .enumerate()
            .filter(|(k, clause)| *k != own && self.is_range(&clause.chain))
            .map(|(_, clause)| &clause.chain)
            .collect()
    }

    /// Whether a chain says between which numbers or letters something lies.
    pub(super) fn is_range(&self, chain: &Chain) -> bool {
        let letter = |name: &Name| {
            matches!(
                self.model.resolve(name, &|_| false),
                Ok(Resolved::Letter { order: 0, .. })
            )
        };
        let plain = |e: &Expr| {
            e.as_name().is_some_and(letter)
                || e.as_infinity().is_some()
                || crate::model::names::literal_number(e).is_some()
        };
        let order = |r: &Relation| r.limits();
        !chain.relations.is_empty()
            && chain.members.iter().all(plain)
            && chain.relations.iter().all(order)
    }

    /// The letters that a definition is one of functions of, as corrected.
    pub(super) fn parameters(&self, definition: &Definition) -> Vec<Name> {
        let clause = definition.place.clause();
        let head = Place::Member { clause, member: 0 };
        let display = self.display(definition.equation);
        let Some(ExprKind::Apply { arguments, .. }) = head.find(display).map(|e| &e.kind) else {
            return definition.arguments.clone();
        };
        let names: Option<Vec<Name>> = arguments
            .iter()
            .map(|argument| argument.as_name().cloned())
            .collect();
        names
            .filter(|names| names.len() == definition.arguments.len())
            .unwrap_or_else(|| definition.arguments.clone())
    }

    /// Whether dots differentiate by this letter.
    pub(super) fn is_time(&self, letter: &Name) -> bool {
        self.times.contains(&latex::canonical(letter))
    }

    /// Whether a symbol changes with the letter of this canonical name.
    pub(super) fn changes_with(&self, symbol: usize, time: &str) -> bool {
        let declared = &self.model.symbols[symbol];
        let function = declared.function_of.as_ref();
        function.is_some_and(|t| latex::canonical(t) == time)
            || declared.entry_of.is_none() && latex::canonical(&declared.name) == time
    }
}

/// Without its primes.
pub(super) fn unprimed(name: &Name) -> Name {
    let mut plain = name.clone();
    plain.letter.primes = 0;
    plain
}

/// The node as dependences know it.
pub(super) fn normal(node: Node) -> Node {
    match node {
        Node::Unknown { system, .. } => Node::Unknown {
            system,
            position: 0,
        },
        Node::Symbol(_) | Node::Matrix(_) | Node::Definition(_) | Node::Notation(_) => node,
    }
}

/// The same power of the same name, without what else stands in it.
fn shallow_power(expr: &Expr) -> Expr {
    if let ExprKind::Power { base, exponent } = &expr.kind
        && base.as_name().is_some()
        && exponent.as_number().is_some()
    {
        return expr.clone();
    }
    Expr::new(ExprKind::Infinity, expr.span)
}

/// Every expression of a tree, conditions of cases among them.
pub(super) fn each(expr: &Expr, see: &mut impl FnMut(&Expr)) {
    see(expr);
    for child in children(expr) {
        each(child, see);
    }
    if let ExprKind::Cases(cases) = &expr.kind {
        for member in cases.iter().flat_map(|(_, conditions)| conditions) {
            for side in &member.members {
                each(side, see);
            }
        }
    }
}
