//! The candidates of one link as they are tried: each costs what it puts in and the operations from
//! there up to the side, and keeps nothing.

use super::evaluators::ExactFilter;
use super::pairs::Table;
use super::parallel::Seed;
use super::residue::compared;
use super::store::{Env, Id, Store};
use super::work::Spent;
use crate::check::edit::{Address, sites};
use crate::check::{Checker, index_tuples};
use crate::expr::{Display, ExprKind};
use crate::latex;
use crate::model::links::Link;
use std::collections::HashMap;
use std::rc::Rc;

/// A subexpression of the printed sides.
pub(super) struct Spot {
    pub address: Address,
    pub id: Id,
    pub parent: Option<usize>,
    /// What stands directly below.
    pub children: Vec<usize>,
    /// What stands below: all after this one and before that.
    pub end: usize,
    /// Whether it is no operation, but brackets or a brace around one.
    pub plain: bool,
}

/// The candidates of a link.
pub(super) struct Trial<'r, 'm> {
    pub display: &'r Display,
    pub link: &'r Link,
    pub store: Store<'m>,
    pub spots: Vec<Spot>,
    pub spot_at: HashMap<Address, usize>,
    /// The indices for which candidates are compared first: the sides as printed differ there.
    pub env: Env,
    /// Whether the store can judge at all.
    pub fast: bool,
    pub functions: bool,
    pub exact: Option<ExactFilter<'m>>,
    pub seed: Seed<'m>,
    pub threads: usize,
    /// Which point it is, and the trials at others, where functions may have images that have none here.
    pub point: u64,
    pub elsewhere: Vec<Trial<'r, 'm>>,
    /// Whether a side as printed has functions without an image at this point.
    pub blind: bool,
    /// For pairs: what each edit puts at its place.
    pub table: Option<Rc<Table>>,
    /// For pairs that are evaluated one by one: the node of each edit.
    pub nodes: Option<Rc<Vec<Vec<Id>>>>,
    pub spent: Spent,
    pub limit: Spent,
    /// How many candidates there are, as far as they were listed.
    pub all: usize,
    /// How many candidates make the sides agree and say less than the print.
    pub empty: usize,
    /// What candidates cost that could not be judged: they have no value, or no proof was found.
    pub unjudged: Vec<u32>,
}

/// At how many points of functions the sides as printed are tried before it is said that they have no
/// value modulo the prime: a root has one only where its radicand is a square.
const POINTS: u64 = 24;

impl<'r, 'm> Trial<'r, 'm> {
    /// The candidates of a link, at the first point at which its sides as printed have values.
    pub fn new(
        checker: &Checker<'m>,
        display: &'r Display,
        link: &'r Link,
        limit: Spent,
    ) -> Trial<'r, 'm> {
        let mut first = Trial::at(checker, display, link, limit, 0);
        if first.functions && first.blind {
            for point in 1..POINTS {
                let other = Trial::at(checker, display, link, limit, point);
                if !other.blind {
                    first = other;
                    break;
                }
            }
        }
        first
    }

    /// The same at one of several points.
    pub fn at(
        checker: &Checker<'m>,
        display: &'r Display,
        link: &'r Link,
        limit: Spent,
        point: u64,
    ) -> Trial<'r, 'm> {
        let (evaluator, exact, images) = checker.modulo_prime(point);
        // Derivatives, too, have no value modulo the prime: they are taken exactly.
        let functions = checker.model.functions.is_some() || differentiates(display, link);
        let exact = functions.then_some((exact, images));
        let mut store = Store::new(display, evaluator, exact);
        let mut spots: Vec<Spot> = Vec::new();
        let mut spot_at = HashMap::new();
        for place in [link.left, link.right] {
            for site in sites(display, place) {
                let parent = site.address.path.split_last().and_then(|(_, up)| {
                    let up = Address {
                        place,
                        path: up.to_vec(),
                    };
                    spot_at.get(&up).copied()
                });
                let here = spots.len();
                spot_at.insert(site.address.clone(), here);
                let mut above = parent;
                if let Some(parent) = parent {
                    spots[parent].children.push(here);
                }
                while let Some(spot) = above {
                    spots[spot].end = here + 1;
                    above = spots[spot].parent;
                }
                spots.push(Spot {
                    id: store.node(site.expr),
                    address: site.address,
                    parent,
                    children: Vec::new(),
                    end: here + 1,
                    plain: matches!(
                        site.expr.kind,
                        ExprKind::Group { .. } | ExprKind::Underbrace { .. }
                    ),
                });
            }
        }
        // The first values of the running indices for which the sides differ.
        let ranges = &display.clauses[link.left.clause()].ranges;
        let names = ranges.iter().map(|r| latex::canonical(&r.index));
        let names: Vec<String> = names.collect();
        let bounds: Option<Vec<(i64, i64)>> = ranges
            .iter()
            .map(|r| {
                let from = store.evaluator.integer(&r.from).ok()?;
                Some((from, store.evaluator.integer(&r.to).ok()?))
            })
            .collect();
        let mut trial = Trial {
            display,
            link,
            store,
            spots,
            spot_at,
            env: 0,
            fast: bounds.is_some() && !constant_or_cases(display, link),
            functions,
            exact: functions.then(|| ExactFilter::new(checker)),
            seed: Seed::of(checker),
            // The images of functions depend on the order in which they are met.
            threads: if functions {
                1
            } else {
                checker.options.threads
            },
            table: None,
            nodes: None,
            point,
            blind: false,
            elsewhere: Vec::new(),
            spent: Spent::default(),
            limit,
            all: 0,
            empty: 0,
            unjudged: Vec::new(),
        };
        let sides = trial.sides();
        let mut first = None;
        for tuple in index_tuples(&bounds.unwrap_or_default()) {
            let indices: Vec<(String, i64)> = names.iter().cloned().zip(tuple).collect();
            let env = trial.store.env(&indices);
            first = first.or(Some(env));
            if trial.compare(sides, env) != Some(true) {
                first = Some(env);
                break;
            }
        }
        trial.env = first.unwrap_or(0);
        trial.blind = trial.compare(sides, trial.env).is_none();
        trial.store.printed();
        trial
    }

    /// The nodes of both sides as printed.
    pub fn sides(&self) -> [Id; 2] {
        [self.link.left, self.link.right].map(|place| {
            let spot = self.spot_at.get(&Address::of_side(place));
            spot.map_or(0, |s| self.spots[*s].id)
        })
    }

    /// Whether two nodes are equal; none where that cannot be told.
    pub fn compare(&mut self, sides: [Id; 2], env: Env) -> Option<bool> {
        let [left, right] = sides.map(|id| self.store.value(id, env));
        compared(&left, &right)
    }

    /// Whether one of two places holds the other.
    pub fn are_nested(&self, one: usize, two: usize) -> bool {
        let holds = |a: usize, b: usize| (a..self.spots[a].end).contains(&b);
        holds(one, two) || holds(two, one)
    }
}

/// Whether a side is "some constant", or something is defined by cases.
fn constant_or_cases(display: &Display, link: &Link) -> bool {
    let mut found = false;
    for place in [link.left, link.right] {
        if let Some(expr) = place.find(display) {
            crate::expr::walk::visit(expr, &mut |e| {
                found |= matches!(e.kind, ExprKind::Constant | ExprKind::Cases(_));
            });
        }
    }
    found
}

/// Whether something is differentiated in a side of a link, but for the dots of letters.
fn differentiates(display: &Display, link: &Link) -> bool {
    let sides = [link.left, link.right].into_iter();
    let mut found = false;
    for side in sides.filter_map(|place| place.find(display)) {
        crate::expr::walk::visit(side, &mut |e| {
            found |= matches!(e.kind, ExprKind::Derivative { .. });
        });
    }
    found
}
