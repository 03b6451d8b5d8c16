//! The order in which equations are settled: each after those whose definitions it uses.

use crate::model::links::Place;
use crate::model::{Model, Node};

impl Model {
    /// The equations, each after those whose definitions it uses; otherwise in the order of the
    /// document.
    pub fn settling_order(&self) -> Vec<usize> {
        let mut order = Vec::new();
        let mut seen = vec![false; self.equations.len()];
        for equation in 0..self.equations.len() {
            self.settle_before(equation, &mut seen, &mut order);
        }
        order
    }

    fn settle_before(&self, equation: usize, seen: &mut [bool], order: &mut Vec<usize>) {
        if std::mem::replace(&mut seen[equation], true) {
            return;
        }
        let mut nodes = std::collections::BTreeSet::new();
        let mut pending = Vec::new();
        self.each_member(equation, &mut |e| self.collect(e, &mut nodes));
        pending.extend(nodes.iter().copied());
        while let Some(node) = pending.pop() {
            match node {
                Node::Definition(d) => {
                    self.settle_before(self.definitions[d].equation, seen, order);
                }
                Node::Unknown { system, .. } => {
                    self.settle_before(self.systems[system].equation, seen, order);
                }
                Node::Notation(_) | Node::Symbol(_) | Node::Matrix(_) => {
                    for next in self.needs(node) {
                        if nodes.insert(next) {
                            pending.push(next);
                        }
                    }
                }
            }
        }
        order.push(equation);
    }

    fn each_member(&self, equation: usize, see: &mut dyn FnMut(&crate::expr::Expr)) {
        let display = &self.equations[equation].display;
        let mut places: Vec<Place> = Vec::new();
        for link in &self.equations[equation].links {
            places.extend([link.left, link.right]);
        }
        places.sort_unstable();
        places.dedup();
        for expr in places.iter().filter_map(|p| p.find(display)) {
            see(expr);
        }
    }
}
