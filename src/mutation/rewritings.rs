//! The other half of the measurement: true claims said in another way, which a checker must not
//! reject.
//!
//! A rewriting says the same by the laws of arithmetic alone, read off the tree: nothing here is
//! evaluated, so that the checker is measured by what it does not share. Products keep the order of
//! their factors unless all of them are scalars, so that every law used holds for matrices too.

use super::dependence::LinkAt;
use super::fresh::{Anew, renamed, scaled, with_definition};
use crate::expr::walk::{children, children_mut};
use crate::expr::{
    Bracket, Chain, Clause, Display, Expr, ExprKind, Function, QuotientStyle, Relation, Sign,
};
use crate::latex;
use crate::model::links::{Place, underbraces};
use crate::model::names::Resolved;
use crate::model::{Model, Node, Role};
use crate::span::Span;
use num_rational::BigRational;
use std::collections::BTreeSet;
use std::sync::Arc;

/// How a true claim is said in another way.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Rewriting {
    /// Products of sums and sums over a divisor are multiplied out.
    Expand,
    /// A common factor is put before a bracket.
    Factor,
    /// Terms, scalar factors or sides change places.
    Commute,
    /// A term goes to the other side.
    MoveTerm,
    /// Both sides are multiplied by the same.
    MultiplySides,
    /// A letter gets another name.
    RenameLetter,
    /// A letter is replaced by a multiple of another one.
    ScaleUnit,
    /// The links of a chain stand as equations of their own.
    SplitChain,
    /// A part of it gets a name.
    InsertDefinition,
}

impl Rewriting {
    /// All of them.
    pub const ALL: [Rewriting; 9] = [
        Rewriting::Expand,
        Rewriting::Factor,
        Rewriting::Commute,
        Rewriting::MoveTerm,
        Rewriting::MultiplySides,
        Rewriting::RenameLetter,
        Rewriting::ScaleUnit,
        Rewriting::SplitChain,
        Rewriting::InsertDefinition,
    ];

    /// In words.
    pub fn as_str(self) -> &'static str {
        match self {
            Rewriting::Expand => "expand",
            Rewriting::Factor => "factor",
            Rewriting::Commute => "commute",
            Rewriting::MoveTerm => "move a term",
            Rewriting::MultiplySides => "multiply both sides",
            Rewriting::RenameLetter => "rename a letter",
            Rewriting::ScaleUnit => "scale a unit",
            Rewriting::SplitChain => "split a chain",
            Rewriting::InsertDefinition => "insert a definition",
        }
    }
}

/// An equation that says the same in another way.
#[derive(Clone, Debug)]
pub(super) struct Rewritten {
    /// The equation and the link that is judged, as indices.
    pub at: LinkAt,
    /// How.
    pub rewriting: Rewriting,
    /// The rewritten display.
    pub display: Display,
    /// The whole document with it, where it brings in a name or another number of links, and the
    /// link to judge in it.
    pub anew: Option<Anew>,
}

/// All rewritings of the links in `links`, in the order of the document; each display once.
pub(super) fn rewritings(model: &Model, links: &[LinkAt]) -> Vec<Rewritten> {
    let mut found = Vec::new();
    for &at in links {
        let equation = &model.equations[at.0];
        let braces = |clause: &Arc<Clause>| !underbraces(&clause.chain).is_empty();
        // Where an underbrace stands, places are counted along it; such a display stays as it is.
        if equation.display.clauses.iter().any(braces) {
            continue;
        }
        let mut seen = BTreeSet::from([latex::write_display(&equation.display)]);
        let mut push = |rewriting, display: Display, anew: Option<Anew>| {
            let text = anew.as_ref().map_or_else(String::new, |a| a.text.clone());
            if seen.insert(latex::write_display(&display) + &text) {
                found.push(Rewritten {
                    at,
                    rewriting,
                    display,
                    anew,
                });
            }
        };
        inside(model, at, &mut push);
        if equation.role == Role::Claim && equation.defines.iter().all(Option::is_none) {
            whole(model, at, &mut push);
            split(model, at, &mut push);
            for (rewriting, anew) in [
                (Rewriting::RenameLetter, renamed(model, at)),
                (Rewriting::ScaleUnit, scaled(model, at)),
                (Rewriting::InsertDefinition, with_definition(model, at)),
            ] {
                for (display, anew) in anew {
                    push(rewriting, display, Some(anew));
                }
            }
        }
    }
    found
}

type Push<'p> = &'p mut dyn FnMut(Rewriting, Display, Option<Anew>);

/// One law at one place inside of a side.
fn inside(model: &Model, (e, l): LinkAt, push: Push<'_>) {
    let equation = &model.equations[e];
    let link = &equation.links[l];
    let defined = equation.defines[l].map(|d| model.definitions[d].place);
    for place in [link.left, link.right] {
        // What is defined is no formula, only its value is.
        if equation.defines[l].is_some() && defined != Some(place) {
            continue;
        }
        let Some(side) = place.find(&equation.display) else {
            continue;
        };
        for node in 0..count(side) {
            for rewriting in [Rewriting::Expand, Rewriting::Factor, Rewriting::Commute] {
                let mut display = equation.display.clone();
                let Some(side) = place.find_mut(&mut display) else {
                    continue;
                };
                let Some(at) = nth(side, &mut node.clone()) else {
                    continue;
                };
                let new = match rewriting {
                    Rewriting::Expand => expanded(at),
                    Rewriting::Factor => factored(at),
                    _ => commuted(model, at),
                };
                let Some(new) = new else { continue };
                // A sum in place of a factor or a base needs its bracket.
                at.kind = match at.kind {
                    ExprKind::Sum(_) => new,
                    _ => in_brackets(Expr::new(new, at.span)).kind,
                };
                push(rewriting, display, None);
            }
        }
    }
}

fn count(expr: &Expr) -> usize {
    1 + children(expr).into_iter().map(count).sum::<usize>()
}

fn nth<'e>(expr: &'e mut Expr, at: &mut usize) -> Option<&'e mut Expr> {
    if *at == 0 {
        return Some(expr);
    }
    *at -= 1;
    children_mut(expr).into_iter().find_map(|c| nth(c, at))
}

/// With a bracket around it where it is a sum.
pub(super) fn in_brackets(expr: Expr) -> Expr {
    let span = expr.span;
    match expr.kind {
        ExprKind::Sum(_) => Expr::new(
            ExprKind::Group {
                bracket: Bracket::Round,
                inner: Box::new(expr),
            },
            span,
        ),
        _ => expr,
    }
}

fn sum_in(expr: &Expr) -> Option<&[(Sign, Expr)]> {
    match &expr.kind {
        ExprKind::Group { bracket, inner } if is_plain(*bracket) => sum_in(inner),
        ExprKind::Sum(terms) if terms.len() > 1 => Some(terms),
        _ => None,
    }
}

fn is_plain(bracket: Bracket) -> bool {
    match bracket {
        Bracket::Round | Bracket::Square => true,
        Bracket::Curly | Bracket::Bar | Bracket::None => false,
    }
}

fn product(factors: Vec<Expr>, span: Span) -> Expr {
    let mut flat = Vec::new();
    for factor in factors {
        match factor.kind {
            ExprKind::Product(more) => flat.extend(more),
            _ => flat.push(in_brackets(factor)),
        }
    }
    match flat.len() {
        1 => flat.remove(0),
        _ => Expr::new(ExprKind::Product(flat), span),
    }
}

/// One factor that is a sum multiplied out, a square of a sum written as a product, or a divisor put
/// under each term.
fn expanded(expr: &Expr) -> Option<ExprKind> {
    let span = expr.span;
    match &expr.kind {
        ExprKind::Product(factors) => {
            let at = factors.iter().position(|f| sum_in(f).is_some())?;
            let terms = sum_in(&factors[at])?;
            let terms = terms.iter().map(|(sign, term)| {
                let mut copy = factors.clone();
                copy[at] = term.clone();
                (*sign, product(copy, span))
            });
            Some(ExprKind::Sum(terms.collect()))
        }
        ExprKind::Power { base, exponent } => {
            let ExprKind::Number(two) = &exponent.kind else {
                return None;
            };
            sum_in(base)?;
            let twice = vec![(**base).clone(), (**base).clone()];
            (*two == BigRational::from_integer(2.into())).then_some(ExprKind::Product(twice))
        }
        ExprKind::Quotient {
            numerator,
            denominator,
            style: QuotientStyle::Bar,
        } => {
            let terms = sum_in(numerator)?.iter().map(|(sign, term)| {
                let quotient = ExprKind::Quotient {
                    numerator: Box::new(term.clone()),
                    denominator: denominator.clone(),
                    style: QuotientStyle::Bar,
                };
                (*sign, Expr::new(quotient, span))
            });
            Some(ExprKind::Sum(terms.collect()))
        }
        _ => None,
    }
}

/// What all terms of a sum begin with, before a bracket.
fn factored(expr: &Expr) -> Option<ExprKind> {
    let ExprKind::Sum(terms) = &expr.kind else {
        return None;
    };
    let split = |term: &Expr| match &term.kind {
        ExprKind::Product(factors) if factors.len() > 1 => {
            let rest = product(factors[1..].to_vec(), term.span);
            Some((factors[0].clone(), rest))
        }
        _ => None,
    };
    let parts: Vec<(Expr, Expr)> = terms.iter().map(|(_, t)| split(t)).collect::<Option<_>>()?;
    let (first, _) = parts.first()?;
    if terms.len() < 2 || parts.iter().any(|(factor, _)| factor != first) {
        return None;
    }
    let rest = terms
        .iter()
        .zip(&parts)
        .map(|((s, _), (_, r))| (*s, r.clone()));
    let rest = Expr::new(ExprKind::Sum(rest.collect()), expr.span);
    Some(ExprKind::Product(vec![first.clone(), in_brackets(rest)]))
}

/// The terms of a sum, or the factors of a product of scalars, in the opposite order.
fn commuted(model: &Model, expr: &Expr) -> Option<ExprKind> {
    match &expr.kind {
        ExprKind::Sum(terms) if terms.len() > 1 => {
            Some(ExprKind::Sum(terms.iter().rev().cloned().collect()))
        }
        ExprKind::Product(factors) if factors.iter().all(|f| is_scalar(model, f)) => {
            Some(ExprKind::Product(factors.iter().rev().cloned().collect()))
        }
        _ => None,
    }
}

/// Whether an expression is a scalar for certain, and needs no index or argument from around it.
pub(super) fn is_scalar(model: &Model, expr: &Expr) -> bool {
    let parts = || children(expr).into_iter().all(|c| is_scalar(model, c));
    match &expr.kind {
        ExprKind::Number(_) => true,
        ExprKind::Name(name) => match model.resolve(name, &|_| false) {
            Ok(Resolved::Letter { symbol, .. }) => model.symbols[symbol].function_of.is_none(),
            Ok(Resolved::Node {
                node: Node::Definition(d),
                derivatives: 0,
            }) => model.definitions[d].letter.is_some(),
            _ => false,
        },
        ExprKind::Sum(_) | ExprKind::Product(_) | ExprKind::Quotient { .. } => parts(),
        ExprKind::Group { bracket, .. } => is_plain(*bracket) && parts(),
        ExprKind::Power { .. } => parts(),
        ExprKind::Call { function, .. } => match function {
            Function::Determinant | Function::Trace => false,
            Function::RealPart | Function::ImaginaryPart => false,
            Function::Cosine
            | Function::Sine
            | Function::Tangent
            | Function::Cotangent
            | Function::HyperbolicCosine
            | Function::HyperbolicSine
            | Function::HyperbolicTangent
            | Function::Exponential
            | Function::Logarithm
            | Function::SquareRoot
            | Function::Absolute => parts(),
        },
        ExprKind::Apply { .. }
        | ExprKind::Named { .. }
        | ExprKind::Transpose(_)
        | ExprKind::Matrix { .. }
        | ExprKind::Tuple(_)
        | ExprKind::BigSum { .. }
        | ExprKind::Integral { .. }
        | ExprKind::Derivative { .. }
        | ExprKind::Expectation(_)
        | ExprKind::Underbrace { .. }
        | ExprKind::Cases(_)
        | ExprKind::Infinity
        | ExprKind::Constant => false,
    }
}

/// The relation seen from the other side; none of one that has no such.
fn turned(relation: Relation) -> Option<Relation> {
    match relation {
        Relation::Equal => Some(Relation::Equal),
        Relation::NotEqual => Some(Relation::NotEqual),
        Relation::Less => Some(Relation::Greater),
        Relation::LessEqual => Some(Relation::GreaterEqual),
        Relation::Greater => Some(Relation::Less),
        Relation::GreaterEqual => Some(Relation::LessEqual),
        Relation::Distributed | Relation::Approximately | Relation::Tends => None,
    }
}

/// Whether both members are formulas with values.
fn is_arithmetic(expr: &Expr) -> bool {
    match expr.kind {
        ExprKind::Constant | ExprKind::Infinity | ExprKind::Tuple(_) => false,
        _ => children(expr).into_iter().all(is_arithmetic),
    }
}

/// Laws about the two sides of a link.
fn whole(model: &Model, (e, l): LinkAt, push: Push<'_>) {
    let equation = &model.equations[e];
    let link = &equation.links[l];
    let (Place::Member { clause, member: 0 }, Place::Member { member: 1, .. }) =
        (link.left, link.right)
    else {
        return;
    };
    let chain = &equation.display.clauses[clause].chain;
    let ([left, right], Some(back)) = (chain.members.as_slice(), turned(link.relation)) else {
        return;
    };
    if !is_arithmetic(left) || !is_arithmetic(right) {
        return;
    }
    let mut put = |rewriting, members: [Expr; 2], relation| {
        let mut display = equation.display.clone();
        let chain = &mut Arc::make_mut(&mut display.clauses[clause]).chain;
        chain.members = members.to_vec();
        chain.relations = vec![relation];
        // A link keeps the relation that its document gave it: with another one it is read anew.
        let anew = match relation == link.relation {
            true => None,
            false => match Anew::of(model, e, &display, "", l + 1..=l + 1) {
                Some(anew) => Some(anew),
                None => return,
            },
        };
        push(rewriting, display, anew);
    };
    let span = chain.span;
    put(Rewriting::Commute, [right.clone(), left.clone()], back);
    // Minus its last term on both sides; of a single term the right side's.
    let terms = |side: &Expr| -> Vec<(Sign, Expr)> {
        match &side.kind {
            ExprKind::Sum(terms) => terms.clone(),
            _ => vec![(Sign::Plus, side.clone())],
        }
    };
    let sum = |terms: Vec<(Sign, Expr)>| Expr::new(ExprKind::Sum(terms), span);
    let moved = |from: &Expr, to: &Expr| {
        let mut from = terms(from);
        let mut to = terms(to);
        let (sign, term) = from.pop().filter(|_| !from.is_empty())?;
        let opposite = match sign {
            Sign::Plus => Sign::Minus,
            Sign::Minus => Sign::Plus,
        };
        to.push((opposite, term));
        Some((sum(from), sum(to)))
    };
    if let Some((a, b)) = moved(left, right) {
        put(Rewriting::MoveTerm, [a, b], link.relation);
    }
    if let Some((b, a)) = moved(right, left) {
        put(Rewriting::MoveTerm, [a, b], link.relation);
    }
    let two = Expr::new(ExprKind::Number(BigRational::from_integer(2.into())), span);
    let times = |factor: &Expr, side: &Expr| product(vec![factor.clone(), side.clone()], span);
    put(
        Rewriting::MultiplySides,
        [times(&two, left), times(&two, right)],
        link.relation,
    );
    let positive = model
        .symbols
        .iter()
        .find(|s| s.range.is_positive() && s.function_of.is_none() && s.entry_of.is_none());
    if let Some(symbol) = positive {
        let factor = Expr::new(ExprKind::Name(symbol.name.clone()), span);
        let sides = [times(&factor, left), times(&factor, right)];
        put(Rewriting::MultiplySides, sides, link.relation);
    }
}

/// The links of a chain one by one, and its ends beside each other.
fn split(model: &Model, (e, l): LinkAt, push: Push<'_>) {
    let equation = &model.equations[e];
    let [clause] = equation.display.clauses.as_slice() else {
        return;
    };
    let chain = &clause.chain;
    if l > 0 || chain.members.len() < 3 || chain.relations.iter().any(|r| turned(*r).is_none()) {
        return;
    }
    let clauses = (0..chain.relations.len()).map(|k| Clause {
        chain: Chain {
            members: chain.members[k..k + 2].to_vec(),
            relations: vec![chain.relations[k]],
            span: chain.span,
        },
        ..Clause::clone(clause)
    });
    let mut display = equation.display.clone();
    display.clauses = clauses.map(Arc::new).collect();
    // What one settings table says of a member keeps its number, as links are numbered alike.
    if let Some(anew) = Anew::of(model, e, &display, "", 1..=chain.relations.len()) {
        push(Rewriting::SplitChain, display, Some(anew));
    }
}
