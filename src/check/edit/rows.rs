//! Braces that stand under the last of several rows and belong under all of them.

use super::{Address, Change, Replacement};
use crate::expr::{Bracket, Display, ExprKind};
use crate::model::links::Place;
use crate::verdict::EditClass;

/// Few equations have such rows, and there is one way to mend them: before everything else.
const BRACE: u32 = 5;

/// Each whole member
/// of a row with a brace takes what stands above it in the rows before.
pub fn braces_under_all_rows(display: &Display, place: Place) -> Vec<Replacement> {
    let Place::Body { clause, .. } = place else {
        return Vec::new();
    };
    let members = &display.clauses[clause].chain.members;
    let rows = &display.clauses[..clause];
    if rows.is_empty()
        || rows
            .iter()
            .any(|row| row.chain.members.len() != members.len())
    {
        return Vec::new();
    }
    let mut brace = 0;
    let mut found = Vec::new();
    for (m, member) in members.iter().enumerate() {
        if let ExprKind::Underbrace { body, .. } = &member.kind {
            let above = rows.iter().map(|row| row.chain.members[m].clone());
            found.push(Replacement {
                address: Address::of_side(Place::Body { clause, brace }),
                class: EditClass::Bracket,
                cost: BRACE,
                change: Change::Whole(ExprKind::Matrix {
                    rows: above.chain([(**body).clone()]).map(|e| vec![e]).collect(),
                    bracket: Bracket::Square,
                }),
            });
        }
        crate::expr::walk::visit(member, &mut |e| {
            brace += usize::from(matches!(e.kind, ExprKind::Underbrace { .. }));
        });
    }
    found
}
