//! One letter for another of the same kind in the document, a letter for a number and a number for
//! a letter, one function of mathematical notation for its neighbour.

use super::build::number;
use super::{Kind, ROOM, Replacement, Scene, Site};
use crate::expr::{Expr, ExprKind, Function, Name};
use crate::verdict::EditClass;
use num_traits::Zero;

/// More letters of a document than these are not tried for each other, unless they look alike.
const LETTERS: usize = 40;

/// The name that an expression is, or the function that it applies.
pub fn name_of(expr: &Expr) -> Option<&Name> {
    match &expr.kind {
        ExprKind::Name(name) | ExprKind::Apply { function: name, .. } => Some(name),
        _ => None,
    }
}

/// The same with another name.
pub(super) fn with_name(expr: &Expr, name: Name) -> Expr {
    let kind = match &expr.kind {
        ExprKind::Apply { arguments, .. } => ExprKind::Apply {
            function: name,
            arguments: arguments.clone(),
        },
        _ => ExprKind::Name(name),
    };
    Expr::new(kind, expr.span)
}

pub(super) fn edits(scene: &Scene<'_>) -> Vec<Replacement> {
    let pool = pool(scene);
    let mut found = Vec::new();
    for site in scene.sites_in_time() {
        // Each takes room: those beyond are not looked at.
        if found.len() > ROOM {
            break;
        }
        match &site.expr.kind {
            ExprKind::Name(name) | ExprKind::Apply { function: name, .. } => {
                exchanged(scene, site, name, &pool, &mut found);
            }
            ExprKind::Number(_) => for_number(scene, site, &pool, &mut found),
            ExprKind::Call { function, argument } => {
                if let Some(other) = neighbour(*function) {
                    let kind = ExprKind::Call {
                        function: other,
                        argument: argument.clone(),
                    };
                    let to = Expr::new(kind, site.expr.span);
                    found.push(Replacement::new(site, EditClass::Letter, to).rarer(5));
                }
            }
            _ => {}
        }
    }
    found
}

/// A name that may stand for another one.
struct Candidate<'a> {
    name: Name,
    /// Whether it is printed in the same equation.
    near: bool,
    undotted: Name,
    kind: Kind,
    unit: Option<&'a str>,
}

/// The names of the equation, then those of the document.
fn pool<'a>(scene: &Scene<'a>) -> Vec<Candidate<'a>> {
    let context = scene.context;
    let mut found: Vec<Candidate<'a>> = Vec::new();
    let mut add = |name: &Name, near: bool| {
        if !found.iter().any(|c| c.name == *name) {
            found.push(Candidate {
                name: name.clone(),
                near,
                undotted: name.undotted(),
                kind: context.kind_of(name),
                unit: context.unit_of(name),
            });
        }
    };
    for site in scene.sites_in_time() {
        if let Some(name) = name_of(site.expr) {
            add(name, true);
        }
    }
    for known in &scene.context.letters {
        add(&known.name, false);
    }
    found
}

fn exchanged(
    scene: &Scene<'_>,
    site: &Site<'_>,
    name: &Name,
    pool: &[Candidate<'_>],
    found: &mut Vec<Replacement>,
) {
    let context = scene.context;
    let (kind, unit, undotted) = (
        context.kind_of(name),
        context.unit_of(name),
        name.undotted(),
    );
    let edit = |to: Expr| Replacement::new(site, EditClass::Letter, to);
    let many = context.letters.len() > LETTERS;
    for candidate in pool {
        let other = &candidate.name;
        let alike = other.letter.base == name.letter.base;
        let same_kind = candidate.kind == kind;
        let same_font = other.letter.font == name.letter.font;
        // Dots have a class of their own.
        let dotted = candidate.undotted == undotted;
        if dotted || !same_kind || !same_font || many && !candidate.near && !alike {
            continue;
        }
        // A function's name is no value, and a value is applied to nothing.
        if context.is_applied(other) != context.is_applied(name) {
            continue;
        }
        let same_unit = match (unit, candidate.unit) {
            (Some(one), Some(other)) => one == other,
            _ => true,
        };
        let rare = u32::from(!candidate.near) * 2
            + u32::from(!same_unit)
            + if alike && candidate.near { 0 } else { 1 };
        // A process for another one: its own dots, or those that the printed letter has.
        let mut dots = vec![other.dots];
        if name.dots > 0 && other.dots != name.dots {
            dots.push(name.dots);
        }
        for dots in dots {
            let other = Name {
                dots,
                ..other.clone()
            };
            found.push(edit(with_name(site.expr, other)).rarer(rare));
        }
    }
    // A factor that is zero is a term that is dropped.
    let whole = matches!(
        site.parent.map(|p| &p.kind),
        None | Some(ExprKind::Matrix { .. })
    );
    if let Some(zero) = &context.zero
        && whole
        && kind == Kind::Matrix
        && zero != name
        && matches!(site.expr.kind, ExprKind::Name(_))
    {
        found.push(edit(with_name(site.expr, zero.clone())).rarer(12));
    }
    let part = site.parent.is_some();
    let plain = part && matches!(site.expr.kind, ExprKind::Name(_)) && name.dots == 0;
    if plain && kind == Kind::Scalar {
        let entry = matches!(site.parent.map(|p| &p.kind), Some(ExprKind::Matrix { .. }));
        let values: &[i64] = if entry { &[0, 1] } else { &[1, 2] };
        for value in values {
            found.push(edit(number(*value, site.expr.span)).rarer(12));
        }
    }
}

/// A letter where a number is printed.
fn for_number(
    scene: &Scene<'_>,
    site: &Site<'_>,
    pool: &[Candidate<'_>],
    found: &mut Vec<Replacement>,
) {
    let zero = matches!(&site.expr.kind, ExprKind::Number(n) if n.is_zero());
    let side = site.parent.is_none();
    if site.is_count() || zero && side {
        return;
    }
    for candidate in pool {
        let name = &candidate.name;
        let value = scene.context.kind_of(name) == Kind::Scalar && !scene.context.is_applied(name);
        if !value || name.dots > 0 {
            continue;
        }
        let far = u32::from(!candidate.near) * 2;
        let to = Expr::new(ExprKind::Name(name.clone()), site.expr.span);
        found.push(Replacement::new(site, EditClass::Letter, to).rarer(12 + far));
    }
}

/// The function that is easily set for another.
fn neighbour(function: Function) -> Option<Function> {
    Some(match function {
        Function::Cosine => Function::Sine,
        Function::Sine => Function::Cosine,
        Function::Tangent => Function::Cotangent,
        Function::Cotangent => Function::Tangent,
        Function::HyperbolicCosine => Function::HyperbolicSine,
        Function::HyperbolicSine => Function::HyperbolicCosine,
        Function::RealPart => Function::ImaginaryPart,
        Function::ImaginaryPart => Function::RealPart,
        Function::Determinant => Function::Trace,
        Function::Trace => Function::Determinant,
        _ => return None,
    })
}
