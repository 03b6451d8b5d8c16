//! Pairs of edits.
//!
//! With one edit made, the value that each subexpression must have so that the sides agree follows
//! from the side down: in a sum it is what is missing beside the other terms, in a product the
//! quotient by the other factors. A second edit does if its value is the needed one, which a table
//! of the values of all edits at that place tells at once: n edits and n walks of the tree decide n^2
//! pairs. Below a matrix product, a running sum or a function nothing is needed in particular;
//! pairs in such places are evaluated one by one, as far as they cost no more than what is known by then.

use super::changed::Put;
use super::needed::Walk;
use super::residue::{Residue, compared};
use super::sites::Trial;
use super::store::Id;
use super::{Candidate, SECOND_SLIP, edited};
use crate::check::edit::{Address, Replacement};
use crate::evaluate::Value;
use crate::expr::Expr;
use crate::span::Span;
use std::collections::{BTreeSet, HashMap};
use std::rc::Rc;

/// Pairs that are evaluated one by one are so many times dearer than those that are looked up.
const DEARER: usize = 50;

/// Pairs that agree are collected up to this number.
const FOUND: usize = 5_000;

/// The edits at each place by the value that they put there.
pub(super) struct Table {
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
        let seconds = |trial: &mut Trial<'_, '_>, i: usize| trial.seconds(singles, i);
        self.all = self.all.saturating_add(singles.len().saturating_pow(2));
        // The table of what each edit puts in, once for all.
        let sizes = singles.iter().map(|edit| edit.change.size() as u64);
        self.spent.work = self.spent.work.saturating_add(sizes.sum());
        let left = self.left();
        let results = self.each(singles.len(), left, seconds, |(_, looked_at)| *looked_at);
        let mut found: Vec<Candidate> = Vec::new();
        for (i, (hits, _)) in results.into_iter().enumerate() {
            if found.len() >= FOUND {
                break;
            }
            let one = &singles[i];
            found.extend(
                hits.into_iter()
                    .filter(|(_, j)| *j != i)
                    .map(|(address, j)| {
                        let two = &singles[j];
                        let second = Replacement {
                            address,
                            ..two.clone()
                        };
                        Candidate {
                            steps: vec![one.clone(), second],
                            cost: one.cost + two.cost + SECOND_SLIP,
                        }
                    }),
            );
        }
        found.sort_by_key(|candidate| candidate.cost);
        found.dedup_by(|one, other| one.cost == other.cost && same_edits(one, other));
        found.truncate(FOUND);
        self.sifted(&found)
    }

    /// With one edit made, the edits that do in its place or another, and how many were looked at.
    fn seconds(&mut self, singles: &[Replacement], i: usize) -> (Vec<(Address, usize)>, usize) {
        let table = match &self.table {
            Some(table) => Rc::clone(table),
            None => {
                let before = self.store.steps();
                let table = Rc::new(self.tabulate(singles));
                self.store.uncount(before);
                self.table = Some(Rc::clone(&table));
                table
            }
        };
        let (mut hits, mut looked_at) = (Vec::new(), 0);
        let mark = self.store.mark();
        let display = edited(self.display, std::slice::from_ref(&singles[i]));
        let places = [self.link.left, self.link.right];
        let exprs = places.map(|p| p.find(&display));
        let [Some(left), Some(right)] = exprs else {
            return (hits, looked_at);
        };
        let ids = [self.store.node(left), self.store.node(right)];
        let values = ids.map(|id| self.store.value(id, self.env));
        for (side, (place, expr)) in places.into_iter().zip([left, right]).enumerate() {
            let Some(needed) = values[1 - side].value() else {
                continue;
            };
            let mut walk = Walk { trial: self };
            let mut address = Address::of_side(place);
            let needed = [needed.clone()];
            walk.visit(
                expr,
                &mut address,
                &needed,
                &mut |expr, id, address, needed| {
                    looked_at += table.look_up(expr, id, address, needed, &mut hits);
                },
            );
        }
        self.store.release(mark);
        self.store.charge(looked_at as u64);
        hits.truncate(FOUND);
        (hits, looked_at)
    }

    fn tabulate(&mut self, singles: &[Replacement]) -> Table {
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
            let mark = self.store.mark();
            let nodes = self.nodes_put_in(single);
            let put = Put {
                spot,
                nodes,
                edit: single,
            };
            let value = self.put_value(&put);
            self.store.release(mark);
            if let Some(Residue::Is(value)) = value {
                let key = (spot, key(&value));
                table.by_value.entry(key).or_default().push(j);
                table.sizes[spot] += 1;
            }
        }
        table
    }

    /// The pairs of single edits that make the sides agree where neither place has a needed value, the
    /// cheapest first and none that costs more than `most`.
    pub fn pairs_apart(&mut self, singles: &[Replacement], most: u32) -> Vec<Candidate> {
        if !self.fast {
            return Vec::new();
        }
        let reached = self.reached();
        let apart: Vec<(usize, &Replacement)> = singles
            .iter()
            .filter_map(|r| Some((*self.spot_at.get(&r.address)?, r)))
            .filter(|(spot, _)| !reached.contains(spot))
            .collect();
        let left = self.left().tried / DEARER;
        let costs: Vec<u32> = apart.iter().map(|(_, r)| r.cost).collect();
        let most = bound(&costs, most.saturating_sub(SECOND_SLIP), left);
        let mut pairs: Vec<(u32, usize, usize)> = Vec::new();
        let mut dearest = 0;
        for (i, (one, first)) in apart.iter().enumerate() {
            let rest = apart.iter().enumerate().skip(i + 1);
            let cheap = rest.take_while(|(_, (_, second))| first.cost + second.cost <= most);
            let free = cheap.filter(|(_, (two, _))| !self.are_nested(*one, *two));
            let all = free.map(|(j, (_, second))| (first.cost + second.cost, i, j));
            // Of those at the bound, which may be very many, the first are as many as there may be.
            pairs.extend(all.filter(|(cost, ..)| {
                dearest += usize::from(*cost == most);
                *cost < most || dearest <= left
            }));
        }
        pairs.sort_unstable();
        pairs.truncate(left);
        let agree = |trial: &mut Trial<'_, '_>, k: usize| {
            let nodes = trial.nodes_of(&apart);
            let (_, i, j) = pairs[k];
            let puts = [i, j].map(|e| Put {
                spot: apart[e].0,
                nodes: nodes[e].clone(),
                edit: apart[e].1,
            });
            let sides = [trial.link.left, trial.link.right];
            let [left, right] = sides.map(|place| trial.side_with(place, &puts));
            compared(&left, &right) == Some(true)
        };
        self.all = self.all.saturating_add(DEARER * pairs.len());
        let agree = self.each(pairs.len(), self.left(), agree, |_| DEARER);
        let agreeing = pairs.iter().zip(agree).filter(|(_, agrees)| *agrees);
        let found = agreeing.take(FOUND).map(|((cost, i, j), _)| Candidate {
            steps: vec![apart[*i].1.clone(), apart[*j].1.clone()],
            cost: cost + SECOND_SLIP,
        });
        let found: Vec<Candidate> = found.collect();
        self.sifted(&found)
    }

    /// The nodes of what some edits put in, each once.
    fn nodes_of(&mut self, edits: &[(usize, &Replacement)]) -> Rc<Vec<Vec<Id>>> {
        if let Some(nodes) = &self.nodes {
            return Rc::clone(nodes);
        }
        let before = self.store.steps();
        let nodes = edits.iter().map(|(_, edit)| self.nodes_put_in(edit));
        let nodes = Rc::new(nodes.collect::<Vec<_>>());
        self.store.uncount(before);
        self.nodes = Some(Rc::clone(&nodes));
        nodes
    }

    /// The places of the printed sides that have a needed value.
    fn reached(&mut self) -> BTreeSet<usize> {
        let mut reached = BTreeSet::new();
        let places = [self.link.left, self.link.right];
        let values = self.sides().map(|id| self.store.value(id, self.env));
        let display = self.display;
        for (side, place) in places.into_iter().enumerate() {
            if let (Some(needed), Some(expr)) = (values[1 - side].value(), place.find(display)) {
                let mut all = Vec::new();
                let mut walk = Walk { trial: self };
                let mut address = Address::of_side(place);
                let needed = [needed.clone()];
                walk.visit(expr, &mut address, &needed, &mut |_, _, address, _| {
                    all.push(address.clone());
                });
                reached.extend(all.iter().filter_map(|a| self.spot_at.get(a)));
            }
        }
        reached
    }
}

impl Table {
    /// The edits that do at a place of an edited side; how many there are.
    fn look_up(
        &self,
        expr: &Expr,
        id: Id,
        address: &Address,
        needed: &[Value<u64>],
        hits: &mut Vec<(Address, usize)>,
    ) -> usize {
        let Some(Some(spot)) = self.spots.get(&(expr.span, id)) else {
            return 0;
        };
        if self.sizes[*spot] > 0 {
            for value in needed {
                if let Some(edits) = self.by_value.get(&(*spot, key(value))) {
                    hits.extend(edits.iter().map(|j| (address.clone(), *j)));
                }
            }
        }
        self.sizes[*spot]
    }
}

/// The least bound on the sum of two costs, of costs in increasing order, for which there are so many
/// pairs; no greater than `most`.
fn bound(costs: &[u32], most: u32, pairs: usize) -> u32 {
    let below = |sum: u32| -> usize {
        let partners = |cost: u32| costs.partition_point(|c| *c <= sum.saturating_sub(cost));
        let count = |(i, cost): (usize, &u32)| partners(*cost).saturating_sub(i + 1);
        costs.iter().enumerate().map(count).sum()
    };
    let greatest = costs.last().map_or(0, |c| 2 * c).min(most);
    let (mut low, mut high) = (0, greatest);
    while low < high {
        let middle = low.midpoint(high);
        match below(middle) >= pairs {
            true => high = middle,
            false => low = middle + 1,
        }
    }
    low
}

/// Whether two pairs are the same edits in another order.
fn same_edits(one: &Candidate, other: &Candidate) -> bool {
    let same = |a: &Replacement, b: &Replacement| a.address == b.address && a.change == b.change;
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
