//! What a corrected equation says that the document says already: a definition or a hypothesis again, or
//! that one number is another.
//!
//! Definitions are inserted in the sides as they are written. What are then the same monomials on both
//! sides follows from the definitions alone, whatever the letters are called. And where the print is about
//! letters, an equation between constants is about nothing any more.

use crate::check::edit::build::group;
use crate::check::edit::{form, written};
use crate::document::Structure;
use crate::expr::walk::{children, children_mut, visit};
use crate::expr::{Expr, ExprKind, Name, Relation};
use crate::latex;
use crate::model::names::Resolved;
use crate::model::{DefinitionKind, Equation, Model, Node, NotationKind};
use std::collections::BTreeSet;

/// How deep definitions are inserted in each other.
const DEPTH: usize = 6;
/// The most nodes of a side with its definitions inserted.
const NODES: usize = 400;

/// Whether the sides are the same monomials once definitions are inserted, where they are not without.
pub(super) fn says_a_definition_again(model: &Model, sides: &[&Expr; 2]) -> bool {
    let mut changed = false;
    let mut insert = |side: &Expr| {
        let mut side = side.clone();
        let mut room = NODES;
        inserted(model, &mut side, DEPTH, &mut room, &mut changed).then_some(side)
    };
    let (left, right) = (insert(sides[0]), insert(sides[1]));
    let (Some(left), Some(right)) = (left, right) else {
        return false;
    };
    // What stacks vectors that are defined says in one equation what several say: no two of them are compared.
    let scalar = !form::is_ordered(&left) && !form::is_ordered(&right);
    changed && scalar && form::same_form(&left, &right)
}

/// Whether one side is a name that was put in, and the other what it is defined as.
pub(super) fn is_definition(
    model: &Model,
    sides: &[&Expr; 2],
    gained: &[BTreeSet<String>; 2],
) -> bool {
    (0..2).any(|k| {
        let Some(name) = sides[k].as_name().map(latex::canonical) else {
            return false;
        };
        gained[k].contains(&name)
            && defined_as(model, sides[k]).is_some_and(|mut value| {
                let mut other = sides[1 - k].clone();
                drop_idle_transposes(model, &mut value);
                drop_idle_transposes(model, &mut other);
                written::arranged(&value) == written::arranged(&other)
            })
    })
}

/// Whether the sides say what a hypothesis of the equation says.
pub(super) fn is_a_hypothesis(equation: &Equation, sides: &[&Expr; 2]) -> bool {
    let supposed = equation.assume.iter().chain(&equation.given);
    let mut equations = supposed.filter(|h| h.relation == Relation::Equal);
    equations.any(|h| {
        let same = |k: usize| {
            form::same_form(sides[k], &h.left) && form::same_form(sides[1 - k], &h.right)
        };
        same(0) || same(1)
    })
}

/// Takes away the transposes of symmetric matrices, which change nothing.
fn drop_idle_transposes(model: &Model, expr: &mut Expr) {
    for part in children_mut(expr) {
        drop_idle_transposes(model, part);
    }
    if let ExprKind::Transpose(inner) = &expr.kind
        && let Some(name) = inner.as_name()
        && let Ok(Resolved::Node {
            node: Node::Matrix(matrix),
            ..
        }) = model.resolve(name, &|_| false)
        && model.matrices[matrix].shape.structure == Structure::Symmetric
    {
        let inner = (**inner).clone();
        *expr = inner;
    }
}

/// Whether a rate of the time itself stands there, which is one.
pub(super) fn rates_the_time(model: &Model, sides: &[&Expr; 2]) -> bool {
    let mut found = false;
    for side in sides {
        visit(side, &mut |e| {
            found |= e
                .as_name()
                .is_some_and(|name| name.dots > 0 && model.is_time(&name.undotted()));
        });
    }
    found
}

/// Whether both sides are one number, perhaps written as a fraction.
pub(super) fn is_one_number(sides: &[&Expr; 2]) -> bool {
    sides.iter().all(|side| is_numeric(side))
}

/// Puts what names are defined as in their places; whether there was room.
fn inserted(
    model: &Model,
    expr: &mut Expr,
    depth: usize,
    room: &mut usize,
    changed: &mut bool,
) -> bool {
    if *room == 0 {
        return false;
    }
    *room -= 1;
    // A number is its own transpose.
    if let ExprKind::Transpose(inner) = &expr.kind
        && !form::is_ordered(inner)
    {
        let inner = (**inner).clone();
        *expr = inner;
    }
    let value = (depth > 0).then(|| defined_as(model, expr)).flatten();
    if let Some(value) = value {
        *changed = true;
        *expr = value;
        return inserted(model, expr, depth - 1, room, changed);
    }
    let mut parts = children_mut(expr).into_iter();
    parts.all(|part| inserted(model, part, depth, room, changed))
}

/// What a name, or a function of arguments, is defined as by arithmetic.
fn defined_as(model: &Model, expr: &Expr) -> Option<Expr> {
    let (name, arguments): (&Name, &[Expr]) = match &expr.kind {
        ExprKind::Name(name) => (name, &[]),
        ExprKind::Apply {
            function,
            arguments,
        } => (function, arguments),
        _ => return None,
    };
    let whole = |d: &&crate::model::Definition| {
        d.name == *name
            && matches!(d.kind, DefinitionKind::Whole)
            && d.arguments.len() == arguments.len()
    };
    let definition = model.definitions.iter().find(whole)?;
    let display = &model.equations[definition.equation].display;
    let mut value = definition.place.find(display)?.clone();
    if matches!(value.kind, ExprKind::Cases(_)) {
        return None;
    }
    for (parameter, argument) in definition.arguments.iter().zip(arguments) {
        replace(&mut value, parameter, argument);
    }
    Some(group(value))
}

fn replace(expr: &mut Expr, parameter: &Name, argument: &Expr) {
    if matches!(&expr.kind, ExprKind::Name(name) if name == parameter) {
        *expr = group(argument.clone());
        return;
    }
    for part in children_mut(expr) {
        replace(part, parameter, argument);
    }
}

/// Whether the print is about letters and the corrected sides are about none any more.
pub(super) fn only_constants(model: &Model, before: &[&Expr; 2], after: &[&Expr; 2]) -> bool {
    !letters(model, before).is_empty() && letters(model, after).is_empty()
}

/// Whether the print is about numbers alone, as a definite integral without letters is: whatever it says,
/// two edits make it fit.
pub(super) fn about_numbers(model: &Model, before: &[&Expr; 2]) -> bool {
    letters(model, before).is_empty()
}

/// The letters of some sides that stand for values: no constants, no functions that are applied, no variables
/// of sums and integrals.
fn letters(model: &Model, sides: &[&Expr; 2]) -> BTreeSet<String> {
    let mut found = BTreeSet::new();
    for side in sides {
        free(model, side, &mut Vec::new(), &mut found);
    }
    found
}

fn free<'e>(
    model: &Model,
    expr: &'e Expr,
    bound: &mut Vec<&'e Name>,
    found: &mut BTreeSet<String>,
) {
    let own = match &expr.kind {
        ExprKind::Name(name) => {
            if !bound.contains(&name) && !is_constant(model, name) {
                found.insert(latex::canonical(name));
            }
            None
        }
        ExprKind::BigSum { index, .. } => Some(index),
        ExprKind::Integral {
            limits: Some(_),
            variable,
            ..
        } => Some(variable),
        _ => None,
    };
    bound.extend(own);
    for child in children(expr) {
        free(model, child, bound, found);
    }
    if own.is_some() {
        bound.pop();
    }
}

/// Whether a name is a constant of the notation: the circle's, a unit matrix, zero.
fn is_constant(model: &Model, name: &Name) -> bool {
    let mut notation = model.notation.iter();
    notation.any(|n| {
        n.name == *name
            && match n.kind {
                NotationKind::Constant(_) | NotationKind::Identity(_) | NotationKind::Zero => true,
                NotationKind::CharacteristicCoefficient(_)
                | NotationKind::Cofactor(_)
                | NotationKind::LeadingMinor(_)
                | NotationKind::Entry(_)
                | NotationKind::HurwitzMatrix(_)
                | NotationKind::Dirac
                | NotationKind::Means(_)
                | NotationKind::Rows(_)
                | NotationKind::Covariance(_) => false,
            }
    })
}

/// Whether a number stands alone on one side and the other was given another number as a term: that number
/// would have been mended, had it been meant.
pub(super) fn adds_to_a_number(before: &[&Expr; 2], after: &[&Expr; 2]) -> bool {
    let number = |e: &Expr| matches!(&e.kind, ExprKind::Number(n) if !num_traits::Zero::is_zero(n));
    let terms = |e: &Expr| match &e.kind {
        ExprKind::Sum(terms) => terms.iter().filter(|(_, t)| is_numeric(t)).count(),
        _ => 0,
    };
    (0..2).any(|k| {
        let other = 1 - k;
        number(before[k]) && before[k] == after[k] && terms(after[other]) > terms(before[other])
    })
}

fn is_numeric(term: &Expr) -> bool {
    match &term.kind {
        ExprKind::Number(_) => true,
        ExprKind::Quotient {
            numerator,
            denominator,
            ..
        } => is_numeric(numerator) && is_numeric(denominator),
        _ => false,
    }
}
