//! Pairs of edits.
//!
//! With one edit made, the value that each subexpression must have so that the sides agree follows
//! from the side down: in a sum it is what is missing beside the other terms, in a product the
//! quotient by the other factors. A second edit does if its value is the needed one, which a table
//! of the values of all edits at that place tells at once: n edits and n walks of the tree decide n^2
//! pairs. Below a matrix product, a running sum or a function nothing is needed in particular;
//! pairs in such places are evaluated one by one.

use super::images::square_root;
use super::sites::Trial;
use super::store::{Id, Residue};
use super::{Candidate, SECOND_SLIP, edited};
use crate::check::edit::{Address, Replacement};
use crate::domain::{Domain, PrimeField};
use crate::evaluate::{Value, value};
use crate::expr::{Expr, ExprKind, Function, Sign};
use crate::matrix::Matrix;
use crate::model::links::children;
use crate::model::names::literal_integer;
use crate::span::Span;
use std::collections::{BTreeMap, HashMap};

/// Pairs that are evaluated one by one are so many times dearer than those that are looked up.
const DEARER: usize = 50;

/// Pairs that agree are collected up to this number.
const FOUND: usize = 5_000;

/// The edits at each place by the value that they put there.
struct Table {
    by_value: HashMap<(usize, Vec<u64>), Vec<usize>>,
    /// How many edits each place has.
    sizes: Vec<usize>,
    /// Subexpressions by their span and node, where that tells them apart.
    spots: HashMap<(Span, Id), Option<usize>>,
}

impl Trial<'_, '_> {
    /// The pairs of single edits that make the sides agree.
    pub fn pairs(&mut self, singles: &[Replacement]) -> Vec<Candidate> {
        if !self.fast {
            return Vec::new();
        }
        let table = self.table(singles);
        let mut found: Vec<Candidate> = Vec::new();
        for (i, one) in singles.iter().enumerate() {
            if self.tried >= self.limit || found.len() >= FOUND {
                break;
            }
            let display = edited(self.display, std::slice::from_ref(one));
            let places = [self.link.left, self.link.right];
            let exprs = places.map(|p| p.find(&display));
            let [Some(left), Some(right)] = exprs else {
                continue;
            };
            let ids = [self.store.node(left), self.store.node(right)];
            let values = ids.map(|id| self.store.value(id, self.env));
            for (side, place) in places.into_iter().enumerate() {
                let (Some(needed), Some(expr)) = (values[1 - side].value(), places[side].find(&display))
                else {
                    continue;
                };
                let mut walk = Walk {
                    trial: self,
                    table: &table,
                    hits: Vec::new(),
                    looked_at: 0,
                };
                let mut address = Address::of_side(place);
                walk.descend(expr, &mut address, &[needed.clone()]);
                let Walk { hits, looked_at, .. } = walk;
                self.tried += looked_at;
                for (address, j) in hits {
                    let two = &singles[j];
                    if i == j {
                        continue;
                    }
                    let second = Replacement {
                        address,
                        ..two.clone()
                    };
                    found.push(Candidate {
                        steps: vec![one.clone(), second],
                        cost: one.cost + two.cost + SECOND_SLIP,
                    });
                }
            }
        }
        self.one_by_one(singles, &table, &mut found);
        found.sort_by_key(|candidate| candidate.cost);
        found.dedup_by(|one, other| one.cost == other.cost && same_edits(one, other));
        found.truncate(FOUND);
        self.sifted(found, Vec::new())
    }

    fn table(&mut self, singles: &[Replacement]) -> Table {
        let mut table = Table {
            by_value: HashMap::new(),
            sizes: vec![0; self.spots.len()],
            spots: HashMap::new(),
        };
        for (s, spot) in self.spots.iter().enumerate() {
            if let Some(expr) = spot.address.find(self.display) {
                let known = table.spots.entry((expr.span, spot.id));
                known.and_modify(|k| *k = None).or_insert(Some(s));
            }
        }
        for (j, single) in singles.iter().enumerate() {
            let Some(spot) = self.spot_at.get(&single.address).copied() else {
                continue;
            };
            let expr = Expr::new(single.kind.clone(), Span::default());
            let id = self.store.node(&expr);
            if let Residue::Is(value) = self.store.value(id, self.env) {
                let key = (spot, key(&value));
                table.by_value.entry(key).or_default().push(j);
                table.sizes[spot] += 1;
            }
        }
        table
    }

    /// Pairs where neither place has a needed value.
    fn one_by_one(&mut self, singles: &[Replacement], table: &Table, found: &mut Vec<Candidate>) {
        let reached = self.reached(table);
        let apart: Vec<&Replacement> = singles
            .iter()
            .filter(|r| {
                let spot = self.spot_at.get(&r.address);
                spot.is_some_and(|s| !reached.contains_key(s))
            })
            .collect();
        for (k, one) in apart.iter().enumerate() {
            for two in &apart[k + 1..] {
                if self.tried.saturating_add(DEARER) > self.limit || found.len() >= FOUND {
                    return;
                }
                if one.address.is_nested_with(&two.address) {
                    continue;
                }
                self.tried += DEARER;
                let candidate = Candidate {
                    steps: vec![(*one).clone(), (*two).clone()],
                    cost: one.cost + two.cost + SECOND_SLIP,
                };
                if self.agrees(&candidate) {
                    found.push(candidate);
                }
            }
        }
    }

    /// The places of the printed sides that have a needed value.
    fn reached(&mut self, table: &Table) -> BTreeMap<usize, ()> {
        let mut reached = BTreeMap::new();
        let places = [self.link.left, self.link.right];
        let values = self.sides().map(|id| self.store.value(id, self.env));
        let display = self.display;
        for (side, place) in places.into_iter().enumerate() {
            if let (Some(needed), Some(expr)) = (values[1 - side].value(), place.find(display)) {
                let mut walk = Walk {
                    trial: self,
                    table,
                    hits: Vec::new(),
                    looked_at: 0,
                };
                let mut address = Address::of_side(place);
                let mut all = Vec::new();
                walk.places(expr, &mut address, &[needed.clone()], &mut all);
                for address in all {
                    if let Some(spot) = self.spot_at.get(&address) {
                        reached.insert(*spot, ());
                    }
                }
            }
        }
        reached
    }
}

/// Whether two pairs are the same edits in another order.
fn same_edits(one: &Candidate, other: &Candidate) -> bool {
    let same = |a: &Replacement, b: &Replacement| a.address == b.address && a.kind == b.kind;
    match (one.steps.as_slice(), other.steps.as_slice()) {
        ([a, b], [c, d]) => same(a, c) && same(b, d) || same(a, d) && same(b, c),
        _ => false,
    }
}

/// A value as a key; the shape goes with it.
fn key(value: &Value<u64>) -> Vec<u64> {
    let (rows, _) = value.shape().unwrap_or_default();
    let mut key: Vec<u64> = value.entries().into_iter().copied().collect();
    if key.len() > 1 {
        key.push(rows as u64);
    }
    key
}

struct Walk<'w, 'r, 'm> {
    trial: &'w mut Trial<'r, 'm>,
    table: &'w Table,
    /// Where in the edited side, and which edit.
    hits: Vec<(Address, usize)>,
    looked_at: usize,
}

impl Walk<'_, '_, '_> {
    fn descend(&mut self, expr: &Expr, address: &mut Address, needed: &[Value<u64>]) {
        let id = self.trial.store.node(expr);
        if let Some(Some(spot)) = self.table.spots.get(&(expr.span, id)) {
            let size = self.table.sizes[*spot];
            if size > 0 {
                self.looked_at += size;
                for value in needed {
                    if let Some(edits) = self.table.by_value.get(&(*spot, key(value))) {
                        let here = edits.iter().map(|j| (address.clone(), *j));
                        self.hits.extend(here);
                    }
                }
            }
        }
        for (step, child) in children(expr).into_iter().enumerate() {
            let below = self.below(expr, step, needed);
            if !below.is_empty() {
                address.path.push(step);
                self.descend(child, address, &below);
                address.path.pop();
            }
        }
    }

    /// All places that have a needed value.
    fn places(
        &mut self,
        expr: &Expr,
        address: &mut Address,
        needed: &[Value<u64>],
        found: &mut Vec<Address>,
    ) {
        found.push(address.clone());
        for (step, child) in children(expr).into_iter().enumerate() {
            let below = self.below(expr, step, needed);
            if !below.is_empty() {
                address.path.push(step);
                self.places(child, address, &below, found);
                address.path.pop();
            }
        }
    }

    fn value(&mut self, expr: &Expr) -> Option<Value<u64>> {
        let id = self.trial.store.node(expr);
        match self.trial.store.value(id, self.trial.env) {
            Residue::Is(value) => Some(value),
            _ => None,
        }
    }

    /// The values that a child must have, for the needed values of the whole.
    fn below(&mut self, expr: &Expr, step: usize, needed: &[Value<u64>]) -> Vec<Value<u64>> {
        let mut found = Vec::new();
        for whole in needed {
            self.needed(expr, step, whole, &mut found);
        }
        found
    }

    fn needed(
        &mut self,
        expr: &Expr,
        step: usize,
        whole: &Value<u64>,
        found: &mut Vec<Value<u64>>,
    ) {
        let field = PrimeField;
        let span = Span::default();
        match &expr.kind {
            ExprKind::Group { .. } | ExprKind::Underbrace { .. } => found.push(whole.clone()),
            ExprKind::Sum(terms) => {
                let mut rest = whole.clone();
                for (k, (sign, term)) in terms.iter().enumerate() {
                    if k == step {
                        continue;
                    }
                    let Some(value) = self.value(term) else {
                        return;
                    };
                    let next = match sign {
                        Sign::Plus => value::subtract(&field, &rest, &value, span),
                        Sign::Minus => value::add(&field, &rest, &value, span),
                    };
                    match next {
                        Ok(next) => rest = next,
                        Err(_) => return,
                    }
                }
                found.push(match terms[step].0 {
                    Sign::Plus => rest,
                    Sign::Minus => value::negate(&field, &rest),
                });
            }
            ExprKind::Product(factors) => {
                let mut others = 1;
                for (k, factor) in factors.iter().enumerate() {
                    if k == step {
                        continue;
                    }
                    match self.value(factor) {
                        Some(Value::Scalar(s)) => others = field.multiply(&others, &s),
                        _ => return,
                    }
                }
                if let Some(inverse) = field.divide(&1, &others) {
                    found.extend(value::multiply(&field, &Value::Scalar(inverse), whole, span));
                }
            }
            ExprKind::Quotient {
                numerator,
                denominator,
                ..
            } => match (step, whole) {
                (0, _) => {
                    if let Some(below @ Value::Scalar(_)) = self.value(denominator) {
                        found.extend(value::multiply(&field, &below, whole, span));
                    }
                }
                (_, Value::Scalar(whole)) => {
                    if let Some(Value::Scalar(above)) = self.value(numerator) {
                        found.extend(field.divide(&above, whole).map(Value::Scalar));
                    }
                }
                _ => {}
            },
            ExprKind::Power { exponent, .. } if step == 0 => {
                let Value::Scalar(whole) = whole else {
                    return;
                };
                let power = literal_integer(exponent);
                let whole = match power {
                    Some(1..) => Some(*whole),
                    _ => field.divide(&1, whole),
                };
                let (Some(power), Some(whole)) = (power, whole) else {
                    return;
                };
                match power.abs() {
                    1 => found.push(Value::Scalar(whole)),
                    2 => {
                        if let Some(root) = square_root(whole) {
                            found.push(Value::Scalar(root));
                            found.push(Value::Scalar(field.negate(&root)));
                        }
                    }
                    _ => {}
                }
            }
            ExprKind::Call {
                function: Function::SquareRoot,
                ..
            } => {
                if let Value::Scalar(whole) = whole {
                    found.push(Value::Scalar(field.multiply(whole, whole)));
                }
            }
            ExprKind::Transpose(_) => found.push(match whole {
                Value::Matrix(m) => Value::Matrix(m.transpose()),
                other => other.clone(),
            }),
            ExprKind::Matrix { .. } => {
                let (Some(Value::Matrix(printed)), Value::Matrix(whole)) = (self.value(expr), whole)
                else {
                    return;
                };
                found.extend(entry(&printed, whole, step).map(Value::Scalar));
            }
            _ => {}
        }
    }
}

/// What an entry must be where all others are as they must be.
fn entry(printed: &Matrix<u64>, needed: &Matrix<u64>, step: usize) -> Option<u64> {
    if printed.shape() != needed.shape() {
        return None;
    }
    let mut entries = printed.iter().zip(needed.iter()).enumerate();
    let others = entries.all(|(k, (one, other))| k == step || one == other);
    let (columns, at) = (needed.columns(), step);
    others.then(|| needed[(at / columns, at % columns)])
}
