//! A claim at admissible points, to as many digits as it takes.

use super::evaluator::Evaluator;
use super::failure::NoValue;
use super::points::{NoPoint, Points};
use super::shown::{Comparison, Shown};
use super::world::World;
use crate::expr::Relation;
use crate::model::Hypothesis;
use crate::model::links::Link;
use crate::stack::with_deep_stack;

/// How much a challenge may cost.
#[derive(Clone, Debug)]
pub struct Budget {
    /// At how many points the claim is evaluated at most.
    pub points: usize,
    /// How many admissible points are looked at, those without a value among them.
    pub tries: usize,
    /// Binary digits, one after the other while the sides are wide.
    pub bits: Vec<u32>,
    /// Multiplications at all points together; those to more digits count more.
    pub work: u64,
}

impl Default for Budget {
    fn default() -> Self {
        Budget {
            points: 4,
            tries: 10,
            bits: vec![128, 512, 2048],
            work: 100_000,
        }
    }
}

/// What came of a claim at admissible points.
#[derive(Clone, Debug, Default)]
pub struct Challenge {
    /// At how many points both sides have values and nothing is apart.
    pub evaluated: usize,
    /// A point where the claim certainly is violated.
    pub apart: Option<Shown>,
    /// At how many points a side certainly has no value.
    pub undefined: usize,
    /// Why there is no value, where one was not found.
    pub inconclusive: Option<NoValue>,
    /// Why there are no further points.
    pub no_point: Option<NoPoint>,
}

/// Looks for a point where a link of an equation is violated, among those where the hypotheses
/// are true.
pub fn challenge<'w>(
    world: &'w World<'_>,
    equation: usize,
    link: &Link,
    hypotheses: impl IntoIterator<Item = &'w Hypothesis>,
    budget: &Budget,
) -> Challenge {
    let hypotheses: Vec<&Hypothesis> = hypotheses.into_iter().collect();
    with_deep_stack(|| at_points(world, equation, link, hypotheses, budget))
}

fn at_points(
    world: &World<'_>,
    equation: usize,
    link: &Link,
    hypotheses: Vec<&Hypothesis>,
    budget: &Budget,
) -> Challenge {
    let mut outcome = Challenge::default();
    let mut points = match Points::new(world, hypotheses) {
        Ok(points) => points,
        Err(none) => {
            outcome.no_point = Some(none);
            return outcome;
        }
    };
    let mut work = budget.work;
    // What is dear is looked at fewer times.
    let enough = budget.work - budget.work / 40;
    let is_equation = link.relation == Relation::Equal;
    // An inequality is violated on a part of the points only.
    let (wanted, tries) = if is_equation {
        (budget.points, budget.tries)
    } else {
        (budget.points.max(16), budget.tries.max(32))
    };
    for _ in 0..tries {
        let dear = is_equation && outcome.evaluated > 0 && work < enough;
        if outcome.evaluated >= wanted || dear {
            break;
        }
        let point = match points.next_point() {
            Ok(point) => point,
            Err(none) => {
                outcome.no_point = Some(none);
                break;
            }
        };
        let mut last = None;
        for bits in &budget.bits {
            let mut evaluator = Evaluator::new(world, &point, *bits, work);
            let found = evaluator.compare(world.display(equation), link);
            work = evaluator.arithmetic.left();
            let again = match &found {
                Comparison::Apart(_) | Comparison::Overlap { narrow: true } => false,
                Comparison::Overlap { narrow: false } => true,
                Comparison::NoValue(none) => none.reason.is_imprecise(),
            };
            last = Some(found);
            if !again {
                break;
            }
        }
        match last {
            Some(Comparison::Apart(shown)) => {
                outcome.apart = Some(*shown);
                return outcome;
            }
            Some(Comparison::Overlap { .. }) => outcome.evaluated += 1,
            Some(Comparison::NoValue(none)) if none.reason.is_certain() => outcome.undefined += 1,
            Some(Comparison::NoValue(none)) => {
                // What is unknown to the evaluator is so everywhere.
                let everywhere = !none.reason.is_imprecise();
                outcome.inconclusive = Some(none);
                if everywhere {
                    break;
                }
            }
            None => break,
        }
    }
    outcome
}
