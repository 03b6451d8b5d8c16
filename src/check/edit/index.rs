//! Other readings of each printed index: the index expressions of the same link in other slots,
//! exchanged letters, the same subscript in another order, neighbours, digits exchanged.

use super::build::{number, sum};
use super::letter::{name_of, with_name};
use super::{Address, Replacement, Scene, Site};
use crate::expr::{Display, Expr, ExprKind, Name, Sign, Subscript};
use crate::latex;
use crate::model::links::children_mut;
use crate::model::names::literal_integer;
use crate::verdict::EditClass;

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
    let mut found = Vec::new();
    for (site, name, subscript, letters) in &subscripts {
        let pool = index_pool(&subscript.indices, letters);
        for tuple in tuples(&pool, subscript.indices.len()) {
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
    crate::model::links::visit(expr, &mut |e| {
        plain &= match &e.kind {
            ExprKind::Name(name) => letters.contains(name),
            ExprKind::Number(n) => n.is_integer(),
            ExprKind::Sum(_) | ExprKind::Product(_) | ExprKind::Group { .. } => true,
            _ => false,
        };
    });
    plain
}

/// What could stand in a slot of this subscript: its own items, these with two letters exchanged,
/// the literals in them and their neighbours.
fn index_pool(items: &[Expr], letters: &[Name]) -> Vec<Expr> {
    let mut pool: Vec<Expr> = Vec::new();
    let mut add = |expr: Expr| {
        if !pool.contains(&expr) {
            pool.push(expr);
        }
    };
    for item in items {
        add(item.clone());
    }
    for item in items {
        for (i, one) in letters.iter().enumerate() {
            for other in &letters[..i] {
                add(exchanged(item, one, other));
            }
        }
        crate::model::links::visit(item, &mut |e| {
            if matches!(e.kind, ExprKind::Number(_)) {
                add(e.clone());
            }
        });
        if let Some(value) = literal_integer(item) {
            for neighbour in [value - 1, value + 1] {
                if neighbour >= 0 {
                    add(number(neighbour, item.span));
                }
            }
            // Two indices of one digit each, printed as a number.
            if (10..=99).contains(&value) {
                let (first, second) = (value / 10, value % 10);
                for other in [second * 10 + first, value + 10, value - 10] {
                    add(number(other, item.span));
                }
            }
        } else {
            for sign in [Sign::Plus, Sign::Minus] {
                add(shifted(item, sign));
            }
        }
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

fn tuples(pool: &[Expr], length: usize) -> Vec<Vec<Expr>> {
    (0..length).fold(vec![Vec::new()], |shorter, _| {
        shorter
            .iter()
            .flat_map(|tuple| {
                pool.iter().map(move |item| {
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
