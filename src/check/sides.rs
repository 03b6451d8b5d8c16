//! Both sides of a link over any field: for every value of its running indices, and where something is
//! defined by cases in each case that can occur.

use super::index_tuples;
use crate::domain::Domain;
use crate::evaluate::{Evaluator, Failure, Value};
use crate::expr::Display;
use crate::latex;
use crate::model::links::Link;
use crate::span::Span;

/// What stands for the number of a case among the indices of an entry.
pub(super) const CASE: &str = "case";

/// The indices with their values, and both sides there.
pub(super) type Sides<E> = Vec<(Vec<(String, i64)>, Value<E>, Value<E>)>;

/// Both sides of a link of a display.
pub(super) fn sides_of<D: Domain>(
    evaluator: &mut Evaluator<'_, D>,
    display: &Display,
    link: &Link,
    span: Span,
) -> Result<Sides<D::Element>, Failure> {
    let missing = || Failure::unsupported("a link without its sides", span);
    let left = link.left.find(display).ok_or_else(missing)?;
    let right = link.right.find(display).ok_or_else(missing)?;
    let clause = &display.clauses[link.left.clause()];
    let head = clause.chain.members.first();
    let mut names = Vec::new();
    let mut bounds = Vec::new();
    for range in &clause.ranges {
        names.push(latex::canonical(&range.index));
        bounds.push((
            evaluator.integer(&range.from)?,
            evaluator.integer(&range.to)?,
        ));
    }
    let mut sides = Vec::new();
    for tuple in index_tuples(&bounds) {
        let indices: Vec<(String, i64)> = names.iter().cloned().zip(tuple).collect();
        let values = evaluator.in_each_case(|evaluator| {
            let sides = evaluator.with_indices(&indices, |e| e.sides_of_chain(head, left, right));
            sides.map(|(l, r)| (evaluator.in_this_case(l), evaluator.in_this_case(r)))
        })?;
        for (case, (l, r)) in values {
            let mut indices = indices.clone();
            if let Some(case) = case {
                let number = i64::try_from(case + 1).unwrap_or(i64::MAX);
                indices.push((CASE.into(), number));
            }
            sides.push((indices, l, r));
        }
    }
    Ok(sides)
}
