//! Points on which equations between letters are true: a letter of each equation is determined by the
//! others.
//!
//! Where the equation is linear in a letter, or one between vectors is so in the entries of another, it
//! is solved by elimination; at rational points that is exact. Otherwise a root is enclosed (see
//! [`super::roots`]). An equation that processes take part in is true at all times: it is solved for the
//! highest derivative of one, and its time derivatives for the higher ones.

use super::apply::Truth;
use super::elimination::definite;
use super::evaluator::Evaluator;
use super::failure::{NoValue, Reason};
use super::jet::Jet;
use super::letters::LayerKind;
use super::point::Point;
use super::value::Value;
use super::world::World;
use crate::matrix::Matrix;
use crate::model::range::{Numbers, Range};
use crate::model::{Hypothesis, Node};
use crate::real::dyadic::Dyadic;
use crate::real::{Complex, Real};
use crate::span::Span;
use std::collections::{BTreeMap, BTreeSet};

/// A symbol or its derivative of an order.
pub(super) type Letter = (usize, u8);

/// Digits of roots, and the work of one evaluation.
pub(super) const BITS: u32 = 192;
const WORK: u64 = 100_000;
/// How many further derivatives of a process follow from an equation.
const FURTHER: u8 = 3;
/// One scalar equation: a hypothesis and an entry of it.
#[derive(Clone, Copy)]
pub(super) struct Equation<'h> {
    pub hypothesis: &'h Hypothesis,
    pub entry: usize,
}

/// The search for one point.
pub(super) struct Solver<'w, 'm> {
    world: &'w World<'m>,
    pub(super) ranges: &'w [Range],
    work: u64,
    failure: Option<NoValue>,
}

impl<'w, 'm> Solver<'w, 'm> {
    pub fn new(world: &'w World<'m>, ranges: &'w [Range], work: u64) -> Self {
        Solver {
            world,
            ranges,
            work,
            failure: None,
        }
    }

    /// How much work is left.
    pub fn left(&self) -> u64 {
        self.work
    }

    /// Why nothing was found, where it was for want of a value.
    pub fn failure(self) -> Option<NoValue> {
        self.failure
    }

    /// The point with letters determined so that these equations are true; none where that was not
    /// found.
    pub fn solve(&mut self, point: Point, hypotheses: &[&Hypothesis]) -> Option<Point> {
        let mut point = point;
        let mut equations = Vec::new();
        let mut locked = BTreeSet::new();
        for (k, hypothesis) in hypotheses.iter().enumerate() {
            let entries = self.entries(&point, hypothesis)?;
            let others = hypotheses.iter().enumerate().filter(|(l, _)| *l != k);
            let others: Vec<&Hypothesis> = others.map(|(_, h)| *h).collect();
            if entries > 1
                && let Some((solved, used)) =
                    self.by_vector(&point, hypothesis, entries, &others, &locked)
            {
                point = solved;
                locked.extend(used);
                continue;
            }
            equations.extend((0..entries).map(|entry| Equation { hypothesis, entry }));
        }
        let solved = self.all(point, &equations, &locked)?;
        self.definite_stay_definite(&solved).then_some(solved)
    }

    /// Solves an equation between vectors or matrices for all entries of a declared vector or matrix, or
    /// of a derivative of one, which no other hypothesis needs.
    fn by_vector(
        &mut self,
        point: &Point,
        hypothesis: &Hypothesis,
        entries: usize,
        others: &[&Hypothesis],
        locked: &BTreeSet<Letter>,
    ) -> Option<(Point, BTreeSet<Letter>)> {
        let model = self.world.model();
        let first = Equation {
            hypothesis,
            entry: 0,
        };
        let mut used = BTreeSet::new();
        for entry in 0..entries {
            used.extend(self.plain(point, Equation { entry, ..first })?.1);
        }
        let mut elsewhere = BTreeSet::new();
        for other in others {
            elsewhere.extend(self.world.behind_expression(&other.left).symbols);
            elsewhere.extend(self.world.behind_expression(&other.right).symbols);
        }
        let process = |s: usize| model.symbols[s].function_of.is_some();
        let moving = used.iter().any(|l| process(l.0));
        let matrices: BTreeSet<usize> = used
            .iter()
            .filter_map(|(s, _)| model.symbols[*s].entry_of.map(|(m, ..)| m))
            .collect();
        for m in matrices {
            let of = |l: &&Letter| model.symbols[l.0].entry_of.is_some_and(|(o, ..)| o == m);
            let highest = used.iter().filter(of).map(|l| l.1).max()?;
            let group: Vec<Letter> = used
                .iter()
                .filter(of)
                .filter(|l| l.1 == highest)
                .copied()
                .collect();
            let free = |l: &Letter| {
                !locked.contains(l) && !point.is_fixed(l.0, l.1) && !elsewhere.contains(&l.0)
            };
            let usable = group.len() == entries
                && !model.matrices[m].shape.positive_definite
                && group.iter().all(free)
                && (!moving || group.iter().all(|l| process(l.0)));
            if !usable {
                continue;
            }
            let Some(solved) = self.linearly(point, first.hypothesis, None, &group, moving) else {
                continue;
            };
            return Some((solved, used));
        }
        None
    }

    /// The point where an equation, or an entry of it, is true because of the values of these letters,
    /// in which it is linear; where it is true at all times, with those of their derivatives.
    fn linearly(
        &mut self,
        point: &Point,
        hypothesis: &Hypothesis,
        entry: Option<usize>,
        letters: &[Letter],
        moving: bool,
    ) -> Option<Point> {
        let mut point = point.clone();
        let further = if moving { FURTHER } else { 0 };
        for rate in 0..=further {
            let higher: Vec<Letter> = letters.iter().map(|l| (l.0, l.1 + rate)).collect();
            let values = self.affine(&point, hypothesis, entry, rate, &higher)?;
            for (letter, value) in higher.into_iter().zip(values) {
                if !self.admits(letter, &value) {
                    return None;
                }
                point = point.with(letter.0, letter.1, value);
            }
        }
        if moving {
            for letter in letters {
                point = point.up_to(letter.0, letter.1 + FURTHER);
            }
        }
        Some(point)
    }

    /// The values of letters for which an equation's difference, differentiated so often by time and
    /// linear in them, vanishes.
    fn affine(
        &mut self,
        point: &Point,
        hypothesis: &Hypothesis,
        entry: Option<usize>,
        rate: u8,
        letters: &[Letter],
    ) -> Option<Vec<Complex>> {
        let span = hypothesis.span;
        let solution = self.evaluate(point, |e| {
            let variable = e.arithmetic.open(0);
            let forms = letters.iter().enumerate().map(|(k, letter)| {
                let slopes = BTreeMap::from([(k, Jet::integer(1))]);
                (*letter, Jet::form(variable, Jet::zero(), slopes))
            });
            let layer = LayerKind::Given(forms.collect());
            let value = e.with_layer(layer, |e| e.rate_of_difference(hypothesis, rate));
            e.arithmetic.close();
            let value = value?;
            let parts: Vec<_> = value
                .entries()
                .into_iter()
                .enumerate()
                .filter(|(k, _)| entry.is_none_or(|only| only == *k))
                .map(|(_, x)| x.parts(variable))
                .collect();
            let n = letters.len();
            if parts.len() != n {
                return Err(Reason::Unsupported("an equation of another shape").at(span));
            }
            let zero = Jet::zero;
            let slope = |i: usize, k: usize| parts[i].1.get(&k).cloned().unwrap_or_else(zero);
            let matrix = Matrix::from_fn(n, n, slope);
            let right = Matrix::from_fn(n, 1, |i, _| parts[i].0.negated());
            let solution = e.arithmetic.solve(&matrix, &right);
            solution.map_err(|r| r.at(span))
        })?;
        solution.iter().map(|x| x.as_number().cloned()).collect()
    }

    /// How many scalar equations a hypothesis is.
    fn entries(&mut self, point: &Point, hypothesis: &Hypothesis) -> Option<usize> {
        let value = self.evaluate(point, |e| e.difference(hypothesis))?;
        Some(value.entries().len())
    }

    pub(super) fn evaluate<T>(
        &mut self,
        point: &Point,
        body: impl FnOnce(&mut Evaluator<'_, 'm>) -> Result<T, NoValue>,
    ) -> Option<T> {
        let granted = self.work.min(WORK);
        let mut evaluator = Evaluator::new(self.world, point, BITS, granted);
        // An evaluation costs something, however little is computed.
        let found = evaluator
            .arithmetic
            .spend(20)
            .map_err(|reason| reason.at(Span::default()))
            .and_then(|()| body(&mut evaluator));
        self.work -= granted - evaluator.arithmetic.left();
        found
            .map_err(|none| {
                self.failure.get_or_insert(none);
            })
            .ok()
    }

    /// The difference of the sides of an equation, and what letters take part.
    pub(super) fn plain(
        &mut self,
        point: &Point,
        equation: Equation<'_>,
    ) -> Option<(Jet, BTreeSet<Letter>)> {
        let entry = equation.entry;
        self.evaluate(point, |e| {
            let value = e.difference(equation.hypothesis)?;
            let whole = value.entries().get(entry).map(|x| (*x).clone());
            let whole = whole.unwrap_or_else(Jet::zero);
            Ok((whole, e.used.keys().copied().collect()))
        })
    }

    /// Solves the equations one after the other; `locked` are the letters of those that are true.
    fn all(
        &mut self,
        point: Point,
        equations: &[Equation<'_>],
        locked: &BTreeSet<Letter>,
    ) -> Option<Point> {
        let Some((equation, rest)) = equations.split_first() else {
            return Some(point);
        };
        let (value, used) = self.plain(&point, *equation)?;
        let model = self.world.model();
        let processes = |l: &&Letter| model.symbols[l.0].function_of.is_some();
        let moving = used.iter().any(|l| processes(&l));
        if value.is_zero() && !moving {
            let mut locked = locked.clone();
            locked.extend(&used);
            return self.all(point, rest, &locked);
        }
        // What the other equations do not need is solved for first, and of a process its highest
        // derivative.
        let mut elsewhere = BTreeSet::new();
        for other in rest {
            elsewhere.extend(self.plain(&point, *other)?.1);
        }
        let highest = |l: &&Letter| !used.iter().any(|o| o.0 == l.0 && o.1 > l.1);
        let mut candidates: Vec<Letter> = used
            .iter()
            .filter(|l| !locked.contains(l) && !point.is_fixed(l.0, l.1))
            .filter(|l| !moving || processes(l) && highest(l))
            .copied()
            .collect();
        candidates.sort_by_key(|l| (elsewhere.contains(l), std::cmp::Reverse(l.1), l.0));
        let mut rounds = vec![candidates];
        // An equation between matrices is evaluated as a whole: what it used, this entry need not have
        // used. With letters that others may need only what is exactly true in the end counts.
        let others = used.iter().filter(|l| locked.contains(l));
        let others = others.filter(|l| !point.is_fixed(l.0, l.1));
        rounds.push(
            others
                .filter(|l| !moving || processes(l))
                .copied()
                .collect(),
        );
        for (round, candidates) in rounds.iter().enumerate() {
            for linear in [true, false] {
                if !linear && round > 0 {
                    continue;
                }
                for letter in candidates {
                    let solved = if linear {
                        let entry = Some(equation.entry);
                        self.linearly(&point, equation.hypothesis, entry, &[*letter], moving)
                    } else {
                        self.by_root(&point, *equation, *letter, moving)
                    };
                    let Some(mut solved) = solved else { continue };
                    if round > 0 {
                        solved = solved.verified_exactly();
                    }
                    let mut locked = locked.clone();
                    locked.extend(&used);
                    if let Some(found) = self.all(solved, rest, &locked) {
                        return Some(found);
                    }
                }
            }
        }
        None
    }

    /// The point where an equation is true because a letter's value is a root of it.
    fn by_root(
        &mut self,
        point: &Point,
        equation: Equation<'_>,
        letter: Letter,
        moving: bool,
    ) -> Option<Point> {
        let root = Real::Enclosed(self.real_root(point, equation, letter)?);
        let mut point = point.clone().with(letter.0, letter.1, root.into());
        if !moving {
            return Some(point);
        }
        // Its derivatives are linear in the higher derivatives.
        for rate in 1..=FURTHER {
            let higher = (letter.0, letter.1 + rate);
            let entry = Some(equation.entry);
            let values = self.affine(&point, equation.hypothesis, entry, rate, &[higher])?;
            let value = values.into_iter().next().filter(Complex::is_real)?;
            point = point.with(higher.0, higher.1, value);
        }
        Some(point.up_to(letter.0, letter.1 + FURTHER))
    }

    fn admits(&self, (symbol, order): Letter, value: &Complex) -> bool {
        if order > 0 {
            return value.is_real();
        }
        let range = &self.ranges[symbol];
        match range.numbers {
            Numbers::Complex => true,
            Numbers::Real | Numbers::Integer => {
                value.is_real()
                    && match &value.re {
                        Real::Exact(x) => range.contains(x),
                        Real::Enclosed(x) => {
                            let inside = |end: &Dyadic| range.contains(&end.to_rational());
                            range.numbers == Numbers::Real && inside(x.low()) && inside(x.high())
                        }
                    }
            }
        }
    }

    /// Whether the declared definite matrices are so where their letters were determined.
    pub fn definite_stay_definite(&mut self, point: &Point) -> bool {
        let model = self.world.model();
        (0..model.matrices.len()).all(|m| {
            let entry = |s: usize| model.symbols[s].entry_of.is_some_and(|(of, ..)| of == m);
            if !model.matrices[m].shape.positive_definite || !point.fixed_symbols().any(entry) {
                return true;
            }
            let found = self.evaluate(point, |e| {
                let value = e.node((Node::Matrix(m), Vec::new()), Span::default())?;
                let matrix = value.square("order").map_err(|r| r.at(Span::default()))?;
                Ok(definite(&e.arithmetic, &matrix, true))
            });
            found == Some(Truth::True)
        })
    }
}

impl Evaluator<'_, '_> {
    /// Left minus right.
    pub(super) fn difference(&mut self, hypothesis: &Hypothesis) -> Result<Value, NoValue> {
        let left = self.expression(&hypothesis.left)?;
        let right = self.expression(&hypothesis.right)?;
        let difference = self.arithmetic.sum(&left, &right.negated());
        difference.map_err(|r| r.at(hypothesis.span))
    }

    /// The time derivative of left minus right.
    fn rate_of_difference(&mut self, hypothesis: &Hypothesis, order: u8) -> Result<Value, NoValue> {
        if order == 0 {
            return self.difference(hypothesis);
        }
        let mut behind = self.world.behind_expression(&hypothesis.left);
        let right = self.world.behind_expression(&hypothesis.right);
        behind.symbols.extend(&right.symbols);
        self.rate(order, &behind, None, hypothesis.span, |e| {
            e.difference(hypothesis)
        })
    }
}
