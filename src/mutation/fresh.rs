//! Rewritings that change what the document is made of: a letter under another name or in another
//! unit, a part with a name of its own. They are written into the text, and the text is read anew.

use super::dependence::LinkAt;
use super::rewritings::is_scalar;
use crate::expr::walk::{children, children_mut};
use crate::expr::{Bracket, Display, Expr, ExprKind, Name, QuotientStyle, Relation};
use crate::latex;
use crate::model::links::each_expression;
use crate::model::{Letter, Model};
use num_rational::BigRational;
use std::ops::RangeInclusive;
use std::sync::Arc;

/// A document with a rewritten equation.
#[derive(Clone, Debug)]
pub(super) struct Anew {
    /// Its text.
    pub text: String,
    /// The label of the equation.
    pub label: String,
    /// The links that are judged, from 1.
    pub members: RangeInclusive<usize>,
}

/// The factor by which a unit is scaled.
const SCALE: i64 = 1000;

/// Names that may be given; the first one that the document does not have is taken.
const NAMES: [&str; 6] = [
    r"\varrho",
    r"\vartheta",
    r"\chi",
    r"\psi",
    r"\kappa",
    r"\upsilon",
];

impl Anew {
    /// The document with an equation replaced, and fences put before its fence.
    pub(super) fn of(
        model: &Model,
        e: usize,
        display: &Display,
        before: &str,
        members: RangeInclusive<usize>,
    ) -> Option<Self> {
        let equation = &model.equations[e];
        let mut text = model.document.text.clone();
        let mut written = latex::write_display(display);
        if text[equation.span.start..equation.span.end].ends_with('\n') {
            written.push('\n');
        }
        text.replace_range(equation.span.start..equation.span.end, &written);
        let fence = text[..equation.span.start].rfind("```math")?;
        text.insert_str(fence, before);
        Some(Anew {
            text,
            label: equation.label.clone(),
            members,
        })
    }
}

/// A name that the document does not have.
fn fresh(model: &Model) -> Option<&'static str> {
    let text = &model.document.text;
    NAMES.into_iter().find(|name| !text.contains(name))
}

/// A label that the document does not have.
fn label(model: &Model) -> Option<String> {
    let mut labels = (1..100).map(|k| format!("rewriting-{k}"));
    labels.find(|l| !model.document.text.contains(l.as_str()))
}

/// The names of plain letters in an equation, none of which is bound or an argument anywhere in it.
fn letters(model: &Model, e: usize) -> Vec<Name> {
    let display = &model.equations[e].display;
    let tends = |relation: &Relation| match relation {
        Relation::Tends | Relation::Distributed => true,
        Relation::Equal
        | Relation::NotEqual
        | Relation::Less
        | Relation::LessEqual
        | Relation::Greater
        | Relation::GreaterEqual
        | Relation::Approximately => false,
    };
    let mut clauses = display.clauses.iter();
    if clauses.any(|c| c.chain.relations.iter().any(tends) || !c.ranges.is_empty()) {
        return Vec::new();
    }
    let mut found: Vec<Name> = Vec::new();
    let mut bound = Vec::new();
    each_expression(display, &mut |expr| match &expr.kind {
        ExprKind::Name(name) if is_plain(model, name) && !found.contains(name) => {
            found.push(name.clone());
        }
        ExprKind::Integral { variable, .. }
        | ExprKind::Derivative {
            variable: Some(variable),
            ..
        } => bound.push(variable.clone()),
        ExprKind::BigSum { index, .. } => bound.push(index.clone()),
        ExprKind::Named { name, .. } => bound.push(name.clone()),
        // An argument is found by its name.
        ExprKind::Apply { arguments, .. } => arguments.iter().for_each(|a| {
            if let ExprKind::Name(name) = &a.kind {
                bound.push(name.clone());
            }
        }),
        _ => {}
    });
    found.retain(|name| !bound.contains(name));
    found
}

/// Whether a name is a declared scalar letter that depends on nothing and on which no process does.
fn is_plain(model: &Model, name: &Name) -> bool {
    let key = latex::canonical(name);
    let declared = model.symbols.iter().enumerate();
    let mut of_this_name = declared.filter(|(_, s)| latex::canonical(&s.name) == key);
    of_this_name.any(|(symbol, s)| {
        let letter = Letter::Symbol { symbol, order: 0 };
        s.function_of.is_none()
            && s.arguments.is_empty()
            && s.entry_of.is_none()
            && model.letters.contains(&letter)
            && !model.arguments.contains(&key)
    })
}

/// Everywhere in an expression one thing for another.
fn replaced(expr: &mut Expr, what: &ExprKind, by: &Expr) {
    if expr.kind == *what {
        expr.kind = by.kind.clone();
        return;
    }
    if let ExprKind::Power { base, .. } = &mut expr.kind
        && base.kind == *what
        && matches!(by.kind, ExprKind::Quotient { .. })
    {
        base.kind = ExprKind::Group {
            bracket: Bracket::Round,
            inner: Box::new(by.clone()),
        };
    }
    for child in children_mut(expr) {
        replaced(child, what, by);
    }
}

fn replace_in(display: &Display, what: &ExprKind, by: &Expr) -> Display {
    let mut display = display.clone();
    for clause in display.clauses.iter_mut().map(Arc::make_mut) {
        for member in &mut clause.chain.members {
            replaced(member, what, by);
        }
    }
    display
}

fn name_of(name: &str, like: &Expr) -> Expr {
    Expr::new(ExprKind::Name(Name::italic(name.trim())), like.span)
}

/// A member to measure new trees by: where they are said to stand.
fn somewhere(display: &Display) -> Option<&Expr> {
    display.clauses.first()?.chain.members.first()
}

/// The claim in another name for one of its letters.
pub(super) fn renamed(model: &Model, (e, l): LinkAt) -> Vec<(Display, Anew)> {
    let display = &model.equations[e].display;
    let (Some(name), Some(like)) = (fresh(model), somewhere(display)) else {
        return Vec::new();
    };
    let letters = letters(model, e);
    let link = l + 1;
    let made = letters.iter().filter_map(|letter| {
        let old = latex::canonical(letter);
        let new = replace_in(
            display,
            &ExprKind::Name(letter.clone()),
            &name_of(name, like),
        );
        let fence = format!("```toml notation\n'{name}' = {{ means = '{old}' }}\n```\n");
        let anew = Anew::of(model, e, &new, &fence, link..=link)?;
        Some((new, anew))
    });
    made.collect()
}

/// The claim with a letter in another unit: a thousandth of what it was measured in.
pub(super) fn scaled(model: &Model, (e, l): LinkAt) -> Vec<(Display, Anew)> {
    let display = &model.equations[e].display;
    let (Some(name), Some(label), Some(like)) = (fresh(model), label(model), somewhere(display))
    else {
        return Vec::new();
    };
    let link = l + 1;
    let letters = letters(model, e);
    let made = letters.iter().filter_map(|letter| {
        let old = latex::canonical(letter);
        // A fraction stays one factor and one argument without a bracket, which a letter before it
        // could take for the bracket of its argument.
        let number = ExprKind::Number(BigRational::from_integer(SCALE.into()));
        let part = ExprKind::Quotient {
            numerator: Box::new(name_of(name, like)),
            denominator: Box::new(Expr::new(number, like.span)),
            style: QuotientStyle::Bar,
        };
        let by = Expr::new(part, like.span);
        let new = replace_in(display, &ExprKind::Name(letter.clone()), &by);
        let fence = format!("```math {label} define\n{name} = {SCALE} {old}\n```\n");
        let anew = Anew::of(model, e, &new, &fence, link..=link)?;
        Some((new, anew))
    });
    made.collect()
}

/// The claim with a name for one of its parts.
pub(super) fn with_definition(model: &Model, (e, l): LinkAt) -> Vec<(Display, Anew)> {
    let display = &model.equations[e].display;
    let (Some(name), Some(label), Some(like)) = (fresh(model), label(model), somewhere(display))
    else {
        return Vec::new();
    };
    let link = l + 1;
    let plain = letters(model, e);
    let mut parts: Vec<Expr> = Vec::new();
    each_expression(display, &mut |expr| {
        let part = match &expr.kind {
            ExprKind::Group { inner, .. } => &**inner,
            _ => expr,
        };
        let formula = match &part.kind {
            ExprKind::Sum(terms) => terms.len() > 1,
            ExprKind::Product(_) | ExprKind::Quotient { .. } | ExprKind::Call { .. } => true,
            _ => false,
        };
        if formula && is_scalar(model, part) && of_letters(part, &plain) && !parts.contains(part) {
            parts.push(part.clone());
        }
    });
    let made = parts.iter().filter_map(|part| {
        let new = replace_in(display, &part.kind, &name_of(name, like));
        let value = latex::write_expr(part);
        let fence = format!("```math {label} define\n{name} = {value}\n```\n");
        let anew = Anew::of(model, e, &new, &fence, link..=link)?;
        Some((new, anew))
    });
    made.collect()
}

fn of_letters(expr: &Expr, letters: &[Name]) -> bool {
    match &expr.kind {
        ExprKind::Name(name) => letters.contains(name),
        _ => children(expr).into_iter().all(|c| of_letters(c, letters)),
    }
}
