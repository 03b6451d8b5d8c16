//! Other readings of each printed index: its items in another order, neighbours, exchanged letters
//! and digits, the running letters and the literals of the other indices of the equation.

use super::build::{number, sum};
use super::letter::{name_of, with_name};
use super::{Address, Replacement, Scene, Site};
use crate::expr::walk::{children_mut, visit};
use crate::expr::{Display, Expr, ExprKind, Name, Sign, Subscript};
use crate::latex;
use crate::model::names::literal_integer;
use crate::verdict::EditClass;
use std::collections::BTreeSet;

/// Literals of the indices of an equation that are tried in its other indices.
const LITERALS: usize = 8;

pub(super) fn edits(scene: &Scene<'_>) -> Vec<Replacement> {
    let subscripts: Vec<(&Site<'_>, &Name, &Subscript, Vec<Name>)> = scene
        .sites
        .iter()
        .filter_map(|site| {
            let name = name_of(site.expr)?;
            let subscript = name.subscript.as_ref()?;
            let letters = bound_letters(scene.display, &site.address, &scene.sites);
            let is_index = !subscript.indices.is_empty()
                && subscript
                    .indices
                    .iter()
                    .all(|i| is_index_expression(i, &letters));
            is_index.then_some((site, name, subscript, letters))
        })
        .collect();
    let mut literals: Vec<Expr> = Vec::new();
    for index in subscripts.iter().flat_map(|(_, _, s, _)| &s.indices) {
        for literal in literals_in(index) {
            if literals.len() < LITERALS && !literals.contains(&literal) {
                literals.push(literal);
            }
        }
    }
    let mut found = Vec::new();
    for (site, name, subscript, letters) in &subscripts {
        for tuple in readings(&subscript.indices, letters, &literals) {
            if tuple == subscript.indices {
                continue;
            }
            // Signs stand close in subscripts.
            let close = |e: &Expr| latex::write_expr(e).replace(" + ", "+").replace(" - ", "-");
            let label: Vec<String> = tuple.iter().map(close).collect();
            let renamed = Name {
                subscript: Some(Subscript {
                    indices: tuple,
                    label: label.join(","),
                }),
                ..(*name).clone()
            };
            found.push(Replacement::new(
                site,
                EditClass::Index,
                with_name(site.expr, renamed),
            ));
        }
    }
    found
}

/// The indices that have a value at an address: those of its clause's ranges and of the sums around
/// it.
fn bound_letters(display: &Display, address: &Address, all: &[Site<'_>]) -> Vec<Name> {
    let clause = &display.clauses[address.place.clause()];
    let mut letters: Vec<Name> = clause.ranges.iter().map(|r| r.index.clone()).collect();
    for outer in all {
        if let ExprKind::BigSum { index, .. } = &outer.expr.kind
            && outer.address.place == address.place
            && address.path.starts_with(&outer.address.path)
            && address.path.get(outer.address.path.len()) == Some(&SUM_BODY)
            && !letters.contains(index)
        {
            letters.push(index.clone());
        }
    }
    letters
}

/// Which child of a sum is its body; the others are its limits, where its index has no value.
const SUM_BODY: usize = 2;

fn is_index_expression(expr: &Expr, letters: &[Name]) -> bool {
    let mut plain = true;
    visit(expr, &mut |e| {
        plain &= match &e.kind {
            ExprKind::Name(name) => letters.contains(name),
            ExprKind::Number(n) => n.is_integer(),
            ExprKind::Sum(_) | ExprKind::Product(_) | ExprKind::Group { .. } => true,
            _ => false,
        };
    });
    plain
}

/// Other tuples: made of the same letters and literals; each slot one more or less; two letters exchanged in all slots; and in one slot
/// whatever else could stand there.
fn readings(items: &[Expr], letters: &[Name], literals: &[Expr]) -> Vec<Vec<Expr>> {
    let slots: Vec<Vec<Expr>> = items.iter().map(neighbours).collect();
    let mut own = items.to_vec();
    own.extend(items.iter().flat_map(literals_in));
    let running = letters.iter().map(|l| ExprKind::Name(l.clone()));
    own.extend(running.map(|kind| Expr::new(kind, crate::span::Span::default())));
    let mut found = tuples(&vec![own; items.len()]);
    let printed = atoms(items);
    found.retain(|tuple| atoms(tuple) == printed);
    found.extend(tuples(&slots));
    for (i, one) in letters.iter().enumerate() {
        for other in &letters[..i] {
            let all = items.iter().map(|item| exchanged(item, one, other));
            found.push(all.collect());
        }
    }
    let pool = elsewhere(items, letters, literals);
    for slot in 0..items.len() {
        for other in &pool {
            let mut tuple = items.to_vec();
            tuple[slot] = other.clone();
            found.push(tuple);
        }
    }
    let mut seen: Vec<Vec<Expr>> = Vec::new();
    for tuple in found {
        if !seen.contains(&tuple) {
            seen.push(tuple);
        }
    }
    seen
}

fn literals_in(expr: &Expr) -> Vec<Expr> {
    let mut found = Vec::new();
    visit(expr, &mut |e| {
        if matches!(e.kind, ExprKind::Number(_)) {
            found.push(e.clone());
        }
    });
    found
}

/// The letters and literals of some items.
fn atoms(items: &[Expr]) -> BTreeSet<String> {
    let mut found = BTreeSet::new();
    for item in items {
        visit(item, &mut |e| {
            if matches!(e.kind, ExprKind::Name(_) | ExprKind::Number(_)) {
                found.insert(latex::write_expr(e));
            }
        });
    }
    found
}

/// An item, one more and one less.
fn neighbours(item: &Expr) -> Vec<Expr> {
    let mut found = vec![item.clone()];
    match literal_integer(item) {
        Some(value) => {
            let near = [value - 1, value + 1].into_iter().filter(|n| *n >= 0);
            found.extend(near.map(|n| number(n, item.span)));
        }
        None => found.extend([Sign::Plus, Sign::Minus].map(|sign| shifted(item, sign))),
    }
    found
}

/// What could stand in one slot: the neighbours of all items, these with two letters exchanged, the
/// literals printed in indices, and the running letters with their neighbours.
fn elsewhere(items: &[Expr], letters: &[Name], literals: &[Expr]) -> Vec<Expr> {
    let mut pool: Vec<Expr> = items.iter().flat_map(neighbours).collect();
    for item in items {
        for (i, one) in letters.iter().enumerate() {
            for other in &letters[..i] {
                pool.push(exchanged(item, one, other));
            }
        }
        // Two indices of one digit each, printed as a number.
        if let Some(value @ 10..=99) = literal_integer(item) {
            let (first, second) = (value / 10, value % 10);
            let others = [second * 10 + first, value + 10, value - 10];
            pool.extend(others.map(|n| number(n, item.span)));
        }
    }
    pool.extend(literals.to_vec());
    for letter in letters {
        let item = Expr::new(ExprKind::Name(letter.clone()), crate::span::Span::default());
        pool.extend(neighbours(&item));
    }
    pool
}

fn exchanged(expr: &Expr, one: &Name, other: &Name) -> Expr {
    let mut copy = expr.clone();
    if let ExprKind::Name(name) = &mut copy.kind {
        if name == one {
            *name = other.clone();
        } else if name == other {
            *name = one.clone();
        }
    }
    for child in children_mut(&mut copy) {
        *child = exchanged(child, one, other);
    }
    copy
}

/// One of the choices for each slot.
fn tuples(slots: &[Vec<Expr>]) -> Vec<Vec<Expr>> {
    slots.iter().fold(vec![Vec::new()], |shorter, choices| {
        shorter
            .iter()
            .flat_map(|tuple| {
                choices.iter().map(move |item| {
                    let mut longer: Vec<Expr> = tuple.clone();
                    longer.push(item.clone());
                    longer
                })
            })
            .collect()
    })
}

/// An index expression one more or one less.
fn shifted(item: &Expr, sign: Sign) -> Expr {
    let step = if sign == Sign::Plus { 1 } else { -1 };
    let mut terms = super::build::terms(item);
    let literal = terms.iter().position(|(_, e)| literal_integer(e).is_some());
    if let Some(k) = literal {
        let (sign, literal) = terms.remove(k);
        let value = literal_integer(&literal).unwrap_or_default();
        let value = if sign == Sign::Plus { value } else { -value } + step;
        if value != 0 {
            let sign = if value > 0 { Sign::Plus } else { Sign::Minus };
            terms.insert(k, (sign, number(value.abs(), item.span)));
        }
    } else {
        terms.push((sign, number(1, item.span)));
    }
    sum(terms, item.span)
}
