//! The value of a side with some edits made, which keeps nothing of them: it costs what they put in and
//! the operations from there up.

use super::edited;
use super::residue::{Residue, compared, operation};
use super::sites::Trial;
use super::store::{Id, Shape};
use super::work;
use crate::check::edit::{Address, Change, Replacement};
use crate::expr::Expr;
use crate::model::links::Place;

/// An edit at its place, with the nodes of what it puts in.
pub(super) struct Put<'e> {
    pub spot: usize,
    pub nodes: Vec<Id>,
    pub edit: &'e Replacement,
}

impl Trial<'_, '_> {
    /// Whether the sides agree with some edits, at the first indices that tell; none where that cannot
    /// be told.
    pub(super) fn told(&mut self, steps: &[Replacement]) -> Option<bool> {
        let mark = self.store.mark();
        let told = match self.puts(steps) {
            Some(puts) => {
                let sides = [self.link.left, self.link.right];
                let [left, right] = sides.map(|place| self.side_with(place, &puts));
                compared(&left, &right)
            }
            None => {
                let sides = self.edited_sides(steps);
                self.compare(sides, self.env)
            }
        };
        self.store.release(mark);
        told
    }

    /// Edits at places of which none holds another, with their nodes.
    fn puts<'e>(&mut self, steps: &'e [Replacement]) -> Option<Vec<Put<'e>>> {
        let mut puts: Vec<Put<'e>> = Vec::with_capacity(steps.len());
        for edit in steps {
            let spot = *self.spot_at.get(&edit.address)?;
            if puts.iter().any(|other| self.are_nested(spot, other.spot)) {
                return None;
            }
            let nodes = self.nodes_put_in(edit);
            puts.push(Put { spot, nodes, edit });
        }
        Some(puts)
    }

    /// The nodes of what an edit puts in.
    pub fn nodes_put_in(&mut self, edit: &Replacement) -> Vec<Id> {
        match &edit.change {
            Change::Whole(kind) => {
                let expr = Expr::new(kind.clone(), crate::span::Span::default());
                vec![self.store.node(&expr)]
            }
            change @ (Change::Terms { .. } | Change::Factors { .. }) => {
                let pieces = change.pieces().into_iter();
                pieces.map(|piece| self.store.node(piece)).collect()
            }
        }
    }

    /// The value of an edited subexpression; none where only the whole expression tells.
    pub fn put_value(&mut self, put: &Put<'_>) -> Option<Residue> {
        let printed = self.store.shape(self.spots[put.spot].id);
        let shape = match (&put.edit.change, &*printed) {
            (Change::Whole(_), _) => {
                let id = *put.nodes.first()?;
                return Some(self.store.value(id, self.env));
            }
            // An edit that another one of the same candidate moved is told by the whole only.
            (Change::Terms { to, .. }, Shape::Sum(terms)) if *to > terms.len() => return None,
            (Change::Factors { to, .. }, Shape::Product(factors)) if *to > factors.len() => {
                return None;
            }
            (Change::Terms { from, to, by }, Shape::Sum(terms)) => {
                let new = by
                    .iter()
                    .zip(&put.nodes)
                    .map(|((sign, _), id)| (*sign, *id));
                let mut terms = terms.clone();
                terms.splice(*from..*to, new);
                Shape::Sum(terms)
            }
            (Change::Factors { from, to, .. }, Shape::Product(factors)) => {
                let mut factors = factors.clone();
                factors.splice(*from..*to, put.nodes.iter().copied());
                Shape::Product(factors)
            }
            (Change::Terms { .. } | Change::Factors { .. }, _) => return None,
        };
        let residue = operation(&shape, &mut |_, id| self.store.value(id, self.env));
        let value = residue.as_ref().and_then(Residue::value);
        self.store.charge(work::operation(value, shape.operands()));
        residue
    }

    /// The nodes of both sides with some edits.
    fn edited_sides(&mut self, steps: &[Replacement]) -> [Id; 2] {
        let mut sides = self.sides();
        let display = edited(self.display, steps);
        for (side, place) in sides.iter_mut().zip([self.link.left, self.link.right]) {
            if let Some(expr) = place.find(&display) {
                *side = self.store.node(expr);
            }
        }
        sides
    }

    /// The value of a side with other nodes put in some of its places, which keeps nothing.
    pub fn side_with(&mut self, place: Place, puts: &[Put<'_>]) -> Residue {
        let Some(root) = self.spot_at.get(&Address::of_side(place)).copied() else {
            return Residue::Unknown;
        };
        if let Some(residue) = self.value_with(root, puts) {
            return residue;
        }
        let Some(printed) = place.find(self.display) else {
            return Residue::Unknown;
        };
        let mut side = printed.clone();
        let here = puts.iter().map(|put| put.edit);
        for edit in here.filter(|e| e.address.place == place) {
            if let Some(expr) = edit.address.below(&mut side) {
                edit.change.apply(expr);
            }
        }
        self.store.evaluated(&side, self.env)
    }

    /// The value of a subexpression that is no operation, with the edits below it made.
    fn value_of_changed(&mut self, spot: usize, puts: &[Put<'_>]) -> Residue {
        let (address, end) = (&self.spots[spot].address, self.spots[spot].end);
        let Some(printed) = address.find(self.display) else {
            return Residue::Unknown;
        };
        let mut changed = printed.clone();
        for put in puts.iter().filter(|put| (spot..end).contains(&put.spot)) {
            let below = Address {
                place: address.place,
                path: put.edit.address.path[address.path.len()..].to_vec(),
            };
            if let Some(expr) = below.below(&mut changed) {
                put.edit.change.apply(expr);
            }
        }
        let id = self.store.node(&changed);
        self.store.value(id, self.env)
    }

    /// The value of a printed subexpression with other nodes put in some places below it; none where
    /// only the whole expression tells.
    fn value_with(&mut self, spot: usize, puts: &[Put<'_>]) -> Option<Residue> {
        if let Some(put) = puts.iter().find(|put| put.spot == spot) {
            return self.put_value(put);
        }
        let here = &self.spots[spot];
        let inside = |from: usize| puts.iter().any(|put| (from..here.end).contains(&put.spot));
        if !inside(spot) {
            return Some(self.store.value(here.id, self.env));
        }
        if here.plain {
            return self.value_with(*here.children.first()?, puts);
        }
        let shape = self.store.shape(here.id);
        // An exponent, or what a function stands before, is no operand: that subexpression is evaluated.
        if let Some(next) = here.children.get(shape.operands())
            && inside(*next)
        {
            return Some(self.value_of_changed(spot, puts));
        }
        let mut told = true;
        let residue = operation(&shape, &mut |k, _| {
            let child = self.spots[spot].children.get(k).copied();
            let value = child.and_then(|child| self.value_with(child, puts));
            told &= value.is_some();
            value.unwrap_or(Residue::Unknown)
        });
        let value = residue.as_ref().and_then(Residue::value);
        self.store.charge(work::operation(value, shape.operands()));
        residue.filter(|_| told)
    }
}
