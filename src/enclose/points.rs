//! Admissible points, one after the other: those of the drawn ones where every hypothesis certainly
//! is true.
//!
//! A hypothesis that says between which numbers a letter lies narrows the letter's range beforehand;
//! an equation determines a letter by the others (see [`super::solved`]); every other hypothesis is a
//! filter. Where no point is found it is said why; where ranges leave no
//! number, that the hypotheses contradict.

use super::apply::Truth;
use super::evaluator::Evaluator;
use super::failure::NoValue;
use super::point::{Point, Tangle};
use super::solved::Solver;
use super::world::World;
use crate::expr::{Expr, Relation};
use crate::latex;
use crate::model::Hypothesis;
use crate::model::names::{Resolved, literal_number};
use crate::model::range::Range;
use crate::stack::with_deep_stack;
use std::sync::Arc;

/// How many points are drawn for one that is admissible: where hypotheses are filters, and where
/// equations are solved.
const MOST_TRIED: usize = 120;
const MOST_SOLVED: usize = 12;
/// The digits and the work that a hypothesis is looked at with.
const BITS: u32 = 128;
const WORK: u64 = 200_000;
/// The work that solving hypotheses may take for all points together.
const WORK_OF_ALL: u64 = 1_000_000;

/// Why there is no admissible point.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum NoPoint {
    /// A letter, as an index into the model's symbols, would have to lie where no number is.
    Contradictory(usize),
    /// So many points were drawn, and in none is every hypothesis true; why the last one was not
    /// accepted, where it was for want of a value.
    NoneFound {
        /// How many points were drawn.
        tried: usize,
        /// Why a hypothesis has no value.
        failure: Option<NoValue>,
    },
}

/// The admissible points of some hypotheses.
pub struct Points<'w, 'm> {
    world: &'w World<'m>,
    hypotheses: Vec<&'w Hypothesis>,
    ranges: Arc<Vec<Range>>,
    tangle: Arc<Tangle>,
    next: usize,
    work: u64,
    found: usize,
    failure: Option<NoValue>,
}

impl<'w, 'm> Points<'w, 'm> {
    /// The points where these hypotheses are true.
    ///
    /// # Errors
    /// When their ranges leave no number for a letter.
    pub fn new(
        world: &'w World<'m>,
        hypotheses: impl IntoIterator<Item = &'w Hypothesis>,
    ) -> Result<Self, NoPoint> {
        let hypotheses: Vec<&Hypothesis> = hypotheses.into_iter().collect();
        let model = world.model();
        let mut ranges: Vec<Range> = model.symbols.iter().map(|s| s.range.clone()).collect();
        for hypothesis in &hypotheses {
            narrow(world, hypothesis, &mut ranges);
        }
        if let Some(empty) = ranges.iter().position(Range::is_empty) {
            return Err(NoPoint::Contradictory(empty));
        }
        let tangle = Arc::new(tangle(world, &hypotheses));
        Ok(Points {
            world,
            hypotheses,
            ranges: Arc::new(ranges),
            tangle,
            next: 0,
            work: WORK_OF_ALL,
            found: 0,
            failure: None,
        })
    }

    /// The next admissible point.
    ///
    /// # Errors
    /// When no further one is found.
    pub fn next_point(&mut self) -> Result<Point, NoPoint> {
        with_deep_stack(|| self.following())
    }

    fn following(&mut self) -> Result<Point, NoPoint> {
        let equations: Vec<&Hypothesis> = self
            .hypotheses
            .iter()
            .copied()
            .filter(|h| h.relation == Relation::Equal)
            .collect();
        let most = if equations.is_empty() {
            MOST_TRIED
        } else {
            MOST_SOLVED
        };
        for _ in 0..most {
            let number = self.next;
            self.next += 1;
            let mut point = Point::new(
                number,
                self.ranges.clone(),
                self.hypotheses.is_empty(),
                self.tangle.clone(),
            );
            if !equations.is_empty() {
                let mut solver = Solver::new(self.world, &self.ranges, self.work);
                let solved = solver.solve(point, &equations);
                self.work = solver.left();
                match solved {
                    Some(solved) => point = solved,
                    None => {
                        self.failure = solver.failure();
                        if self.work == 0 {
                            break;
                        }
                        continue;
                    }
                }
            }
            match self.is_admissible(&point) {
                Ok(true) => {
                    self.found += 1;
                    return Ok(point);
                }
                Ok(false) => {}
                Err(failure) => self.failure = Some(failure),
            }
        }
        Err(NoPoint::NoneFound {
            tried: self.next,
            failure: self.failure.clone(),
        })
    }

    /// How many points were found.
    pub fn found(&self) -> usize {
        self.found
    }

    /// Whether a point of any origin is admissible: whether its letters lie in their ranges, the declared
    /// definite matrices are so, and every hypothesis is true.
    ///
    /// # Errors
    /// Why a hypothesis has no value there.
    pub fn admits(&self, point: &Point) -> Result<Truth, NoValue> {
        let mut truth = point.in_ranges(&self.ranges);
        let definite = with_deep_stack(|| {
            let mut solver = Solver::new(self.world, &self.ranges, WORK);
            solver.definite_stay_definite(point)
        });
        if !definite {
            truth = truth.and(Truth::False);
        }
        if truth == Truth::False {
            return Ok(truth);
        }
        let hypotheses = with_deep_stack(|| {
            let mut evaluator = Evaluator::new(self.world, point, BITS, WORK);
            let mut all = Truth::True;
            for hypothesis in &self.hypotheses {
                all = all.and(evaluator.is_true(hypothesis)?);
            }
            Ok::<Truth, NoValue>(all)
        })?;
        Ok(truth.and(hypotheses))
    }

    fn is_admissible(&self, point: &Point) -> Result<bool, NoValue> {
        let mut evaluator = Evaluator::new(self.world, point, BITS, WORK);
        for hypothesis in &self.hypotheses {
            let truth = evaluator.is_true(hypothesis)?;
            // An equation was solved: that its sides are enclosed only says nothing against it.
            let equation = hypothesis.relation == Relation::Equal && !point.verify;
            let solved = equation && truth == Truth::Unknown;
            if truth != Truth::True && !solved {
                return Ok(false);
            }
        }
        Ok(true)
    }
}

/// What the equations among hypotheses tie together.
fn tangle(world: &World<'_>, hypotheses: &[&Hypothesis]) -> Tangle {
    let mut tangle = Tangle::default();
    for hypothesis in hypotheses.iter().filter(|h| h.relation == Relation::Equal) {
        let mut symbols = world.behind_expression(&hypothesis.left).symbols;
        symbols.extend(world.behind_expression(&hypothesis.right).symbols);
        let declared = |s: &usize| &world.model().symbols[*s];
        let processes = symbols.iter().any(|s| declared(s).function_of.is_some());
        let is_time = |s: &usize| world.times.contains(&latex::canonical(&declared(s).name));
        if !processes && symbols.iter().any(is_time) {
            let constants = symbols.iter().copied().filter(|s| !is_time(s));
            tangle.moving.extend(constants);
        }
        tangle.symbols.extend(symbols);
    }
    tangle
}

/// Narrows the range of a letter that a hypothesis compares with a number.
fn narrow(world: &World<'_>, hypothesis: &Hypothesis, ranges: &mut [Range]) {
    let letter = |e: &Expr| match world.model().resolve(e.as_name()?, &|_| false) {
        Ok(Resolved::Letter { symbol, order: 0 }) => Some(symbol),
        _ => None,
    };
    let (left, right) = (&hypothesis.left, &hypothesis.right);
    let (symbol, number, relation) = match (letter(left), literal_number(right)) {
        (Some(symbol), Some(number)) => (symbol, number, hypothesis.relation),
        _ => match (literal_number(left), letter(right)) {
            (Some(number), Some(symbol)) => {
                let turned = match hypothesis.relation {
                    Relation::Less => Relation::Greater,
                    Relation::LessEqual => Relation::GreaterEqual,
                    Relation::Greater => Relation::Less,
                    Relation::GreaterEqual => Relation::LessEqual,
                    same @ (Relation::Equal
                    | Relation::NotEqual
                    | Relation::Distributed
                    | Relation::Approximately
                    | Relation::Tends) => same,
                };
                (symbol, number, turned)
            }
            _ => return,
        },
    };
    let range = &mut ranges[symbol];
    if range.numbers == crate::model::range::Numbers::Complex {
        return;
    }
    match relation {
        Relation::Less => range.lower(number, false),
        Relation::LessEqual => range.lower(number, true),
        Relation::Greater => range.raise(number, false),
        Relation::GreaterEqual => range.raise(number, true),
        Relation::Equal => {
            range.raise(number.clone(), true);
            range.lower(number, true);
        }
        Relation::NotEqual | Relation::Distributed | Relation::Approximately | Relation::Tends => {}
    }
}
