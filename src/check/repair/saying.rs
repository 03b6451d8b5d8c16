//! Whether a corrected equation says as much as the printed one.
//!
//! A false equation becomes true by many edits that take its content away: both sides the same, a
//! factor 0, the one side's name on the other. The rule is one predicate over the printed sides, the
//! corrected ones and the values of their parts modulo the prime: [`emptied`] names the first way in
//! which a correction says less. An equation `... = 0` has its content among the terms of the other
//! side, which then vanishes as a whole: no part of it may.

use super::Candidate;
use super::residue::Residue;
use super::restated;
use super::sites::Trial;
use crate::check::edit::{form, name_of, written};
use crate::domain::{Domain, PrimeField};
use crate::evaluate::Value;
use crate::expr::walk::{children, mentions, visit};
use crate::expr::{Display, Expr, ExprKind, Name};
use crate::latex;
use crate::model::Model;
use crate::model::links::Link;
use crate::verdict::EditClass;
use num_traits::Zero;
use std::collections::BTreeSet;

/// In what way a correction says less than the print.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Emptied {
    /// Both sides are the same but for order and brackets.
    Tautology,
    /// Both sides are the same monomials, with the definitions inserted or without, and something was put
    /// in to make them so; or they say what is supposed.
    Restatement,
    /// Something is zero by its form, or vanishes in value, that did not.
    Vanishing,
    /// A factor 1, a term 0, what cancels or adds up at once, a power of a unit.
    Unwritten,
    /// A side has the name that the other side is.
    Borrowed,
    /// The zero that is claimed is no zero any more, but no number either.
    Zero,
    /// Letters are gone, all of them or several, or nearly all terms.
    Lost,
    /// Numbers alone, made to fit by several edits.
    Fitted,
    /// The same was put in on both sides.
    BothSides,
    /// Some of its edits do without the others.
    Superfluous,
}

/// In what way a candidate that makes the sides agree says less than the print did, if it does.
pub(super) fn emptied(
    model: &Model,
    equation: usize,
    trial: &mut Trial<'_, '_>,
    corrected: &Display,
    candidate: &Candidate,
) -> Option<Emptied> {
    let (printed, link) = (trial.display, trial.link);
    let before = sides(printed, link)?;
    let after = sides(corrected, link)?;
    let several = candidate.steps.len() > 1;
    let bare = after.map(written::without_units);
    if written::arranged(&bare[0]) == written::arranged(&bare[1]) {
        return Some(Emptied::Tautology);
    }
    if restated::only_constants(model, &before, &after) {
        return Some(Emptied::Lost);
    }
    if restated::is_one_number(&after) {
        return Some(Emptied::Tautology);
    }
    if several && restated::about_numbers(model, &before) {
        return Some(Emptied::Fitted);
    }
    if restated::adds_to_a_number(&before, &after) {
        return Some(Emptied::Unwritten);
    }
    let gained = [0, 1].map(|k| gained(before[k], after[k]));
    let put_in = gained.iter().any(|names| !names.is_empty());
    if form::same_form(after[0], after[1]) && (several || put_in) {
        return Some(Emptied::Restatement);
    }
    // A print that gives a definition in other words, with one letter lost inside of it, means that definition.
    let defined = |name: &String| {
        let mut definitions = model.definitions.iter();
        definitions.any(|d| crate::latex::canonical(&d.name) == *name)
    };
    let whole = candidate.steps.iter().any(|s| s.address.path.is_empty());
    let meant = !several && !whole && !gained.iter().flatten().any(defined);
    if put_in
        && !meant
        && renames(candidate, several)
        && restated::says_a_definition_again(model, &after)
    {
        return Some(Emptied::Restatement);
    }
    if restated::is_definition(model, &after, &gained)
        || restated::rates_the_time(model, &after)
        || restated::is_a_hypothesis(&model.equations[equation], &after)
    {
        return Some(Emptied::Restatement);
    }
    // u^T v = v^T u: each side was multiplied by the other.
    let multiplied = |k: usize| {
        let (own, other) = (written::names(before[k]), written::names(before[1 - k]));
        let now = written::names(after[k]);
        let kept = own.keys().all(|name| now.contains_key(name));
        kept && gained[k]
            .iter()
            .any(|name| other.contains_key(name) && !own.contains_key(name))
    };
    if several && multiplied(0) && multiplied(1) {
        return Some(Emptied::BothSides);
    }
    for (k, side) in after.iter().enumerate() {
        let other = 1 - k;
        let borrowed = written::subject(side)
            .is_some_and(|name| mentions(after[other], name) && !mentions(before[other], name));
        if borrowed {
            return Some(Emptied::Borrowed);
        }
        let claimed = is_zero(trial, before[k]) && before[k] != *side;
        if claimed && !matches!(side.kind, ExprKind::Number(_) | ExprKind::Name(_)) {
            return Some(Emptied::Zero);
        }
    }
    let odd = |sides: &[&Expr; 2]| sides.iter().map(|e| written::oddities(e)).sum::<usize>();
    if odd(&after) > odd(&before) {
        return Some(Emptied::Unwritten);
    }
    if let Some(emptied) = by_values(trial, &before, &after, several, put_in) {
        return Some(emptied);
    }
    let terms = |r: &&crate::check::edit::Replacement| r.class == EditClass::Term;
    let common = gained[0].intersection(&gained[1]).next().is_some();
    if several && common && candidate.steps.iter().any(|r| terms(&r)) {
        return Some(Emptied::BothSides);
    }
    if several && loses_content(&before, &after, candidate) {
        return Some(Emptied::Lost);
    }
    // Each edit of the sides is needed: one that is not was put in beside another that says nothing alone.
    let here: Vec<_> = candidate
        .steps
        .iter()
        .filter(|step| [link.left, link.right].contains(&step.address.place))
        .cloned()
        .collect();
    if here.len() > 1 {
        for k in 0..here.len() {
            let mut fewer = here.clone();
            let alone = vec![fewer.remove(k)];
            if trial.told(&fewer) == Some(true) || trial.told(&alone) == Some(true) {
                return Some(Emptied::Superfluous);
            }
        }
    }
    None
}

/// Whether names were put in for more than one slip of a letter: beside other edits, as factors or terms,
/// or as a whole side. Whoever writes one letter for another inside of a definition means that definition.
fn renames(candidate: &Candidate, several: bool) -> bool {
    candidate.steps.iter().any(|step| match step.class {
        EditClass::Letter => several || step.address.path.is_empty(),
        EditClass::Term => true,
        EditClass::Sign
        | EditClass::Factor
        | EditClass::Exponent
        | EditClass::Index
        | EditClass::Bracket
        | EditClass::Transpose
        | EditClass::Dot
        | EditClass::Inversion
        | EditClass::Measure
        | EditClass::Limit => false,
    })
}

fn sides<'d>(display: &'d Display, link: &Link) -> Option<[&'d Expr; 2]> {
    Some([link.left.find(display)?, link.right.find(display)?])
}

/// The names that a side has more often than before.
fn gained(before: &Expr, after: &Expr) -> BTreeSet<String> {
    let were = written::names(before);
    let are = written::names(after).into_iter();
    are.filter(|(name, n)| were.get(name).is_none_or(|m| n > m))
        .map(|(name, _)| name)
        .collect()
}

/// Whether a side is printed as zero: the number or the letter of a zero matrix.
fn is_zero(trial: &mut Trial<'_, '_>, side: &Expr) -> bool {
    match &side.kind {
        ExprKind::Number(n) => n.is_zero(),
        ExprKind::Name(_) => trial.is(side, Worth::Zero),
        _ => false,
    }
}

/// What only the values of the parts tell.
fn by_values(
    trial: &mut Trial<'_, '_>,
    before: &[&Expr; 2],
    after: &[&Expr; 2],
    several: bool,
    put_in: bool,
) -> Option<Emptied> {
    let vanished = before.map(|side| trial.is(side, Worth::Zero));
    let vanish = after.map(|side| trial.is(side, Worth::Zero));
    let claims_zero = vanished.contains(&true);
    if vanish == [true, true] && !claims_zero {
        return Some(Emptied::Vanishing);
    }
    // 1 = 1, whatever letters are still written.
    let ones = |trial: &mut Trial<'_, '_>, sides: &[&Expr; 2]| {
        sides.iter().all(|side| trial.is(side, Worth::One))
    };
    if ones(trial, after) && !before.iter().any(|side| trial.is(side, Worth::One)) {
        return Some(Emptied::Vanishing);
    }
    for (k, side) in after.iter().enumerate() {
        let whole = vanish[k] && claims_zero;
        let (old, new) = match whole {
            // What is claimed to vanish: its parts must not.
            true => (before[k], peeled(trial, side)),
            false => (before[k], *side),
        };
        if whole && !vanished[k] {
            // The content stands among its terms: there must be several, and no two cancel.
            let terms = match &new.kind {
                ExprKind::Sum(terms) => terms.len(),
                _ if has_shape(trial, new) => 2,
                _ => 1,
            };
            let empty = form::vanishes(new);
            if terms < 2 || empty && (several || put_in) {
                return Some(Emptied::Vanishing);
            }
        }
        let inside = usize::from(whole && form::vanishes(new));
        if form::zeros(side) > form::zeros(before[k]) + inside {
            return Some(Emptied::Vanishing);
        }
        let mut was = [0; 2];
        idle(trial, old, &mut was);
        let mut is = [0; 2];
        idle(trial, new, &mut is);
        if is[0] > was[0] {
            return Some(Emptied::Vanishing);
        }
        if is[1] > was[1] {
            return Some(Emptied::Unwritten);
        }
    }
    None
}

/// Whether something is a matrix in value: its entries are its terms.
fn has_shape(trial: &mut Trial<'_, '_>, expr: &Expr) -> bool {
    let id = trial.store.node(expr);
    matches!(
        trial.store.value(id, trial.env),
        Residue::Is(Value::Matrix(_))
    )
}

/// What has to vanish for the whole to: the factor, the numerator, what the bracket holds.
fn peeled<'e>(trial: &mut Trial<'_, '_>, expr: &'e Expr) -> &'e Expr {
    match &expr.kind {
        ExprKind::Group { inner, .. } | ExprKind::Underbrace { body: inner, .. } => {
            peeled(trial, inner)
        }
        ExprKind::Quotient { numerator, .. } => peeled(trial, numerator),
        ExprKind::Power { base, .. } => peeled(trial, base),
        ExprKind::Transpose(inner) => peeled(trial, inner),
        ExprKind::Sum(terms) if terms.len() == 1 => peeled(trial, &terms[0].1),
        ExprKind::Product(factors) => {
            let mut zeros = Vec::new();
            for factor in factors {
                if trial.is(factor, Worth::Zero) {
                    zeros.push(factor);
                }
            }
            match zeros.as_slice() {
                [only] => peeled(trial, only),
                _ => expr,
            }
        }
        _ => expr,
    }
}

/// What a value is that makes nothing of what it stands in.
#[derive(Clone, Copy)]
pub(super) enum Worth {
    Zero,
    One,
    /// A power of the imaginary unit.
    Unit,
}

impl Trial<'_, '_> {
    /// Whether an expression is known to have such a value.
    pub(super) fn is(&mut self, expr: &Expr, worth: Worth) -> bool {
        let id = self.store.node(expr);
        let Residue::Is(value) = self.store.value(id, self.env) else {
            return false;
        };
        match (worth, value) {
            (Worth::Zero, value) => value.entries().iter().all(|e| **e == 0),
            (Worth::One, Value::Scalar(s)) => s == 1,
            (Worth::Unit, Value::Scalar(s)) => PrimeField.power(&s, 4) == Some(1),
            (_, Value::Matrix(_) | Value::Zero) => false,
        }
    }
}

/// How many terms, factors and numerators of an expression vanish, and how many factors, divisors and
/// bases of powers are 1 or a unit.
fn idle(trial: &mut Trial<'_, '_>, expr: &Expr, count: &mut [usize; 2]) {
    match &expr.kind {
        ExprKind::Sum(terms) if terms.len() > 1 => {
            for (_, term) in terms {
                count[0] += usize::from(trial.is(term, Worth::Zero));
            }
        }
        ExprKind::Product(factors) => {
            for factor in factors {
                count[0] += usize::from(trial.is(factor, Worth::Zero));
                count[1] += usize::from(trial.is(factor, Worth::One));
            }
        }
        ExprKind::Quotient {
            numerator,
            denominator,
            ..
        } => {
            count[0] += usize::from(trial.is(numerator, Worth::Zero));
            count[1] += usize::from(trial.is(denominator, Worth::One));
        }
        ExprKind::Power { base, .. } => {
            count[0] += usize::from(trial.is(base, Worth::Zero));
            count[1] += usize::from(trial.is(base, Worth::Unit));
        }
        _ => {}
    }
    for child in children(expr) {
        idle(trial, child, count);
    }
}

/// Whether several edits leave little of what the equation is about: two letters that it no longer
/// names, or one whose terms and factors were all taken out.
fn loses_content(before: &[&Expr; 2], after: &[&Expr; 2], candidate: &Candidate) -> bool {
    let names = |sides: &[&Expr; 2]| {
        let mut found: BTreeSet<String> = BTreeSet::new();
        for expr in sides {
            visit(expr, &mut |e| {
                if let Some(name) = name_of(e) {
                    // Another index or dot is no other letter.
                    let bare = Name {
                        subscript: None,
                        ..name.undotted()
                    };
                    found.insert(latex::canonical(&bare));
                }
            });
        }
        found
    };
    let left = names(after);
    let lost = names(before).into_iter().filter(|n| !left.contains(n));
    let dropped = candidate.steps.iter().all(|s| s.class == EditClass::Term);
    lost.count() > usize::from(!dropped)
}
