//! Single edits of an expression: what a typist, a typesetter or an author could have done.
//!
//! Every edit replaces one subexpression, addressed by the way to it. The lists are finite,
//! deterministic and depend on the printed equation alone, never on what would make it true.

use crate::expr::{Bracket, Display, Expr, ExprKind, Font, Name, Sign, Subscript};
use crate::latex;
use crate::model::links::{Place, children, children_mut};
use crate::model::names::literal_integer;
use crate::verdict::{Edit, EditClass};
use num_bigint::BigInt;
use num_rational::BigRational;

/// The way to a subexpression: a place of the display and the numbers of the children.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Address {
    /// The side it is in.
    pub place: Place,
    /// From there down.
    pub path: Vec<usize>,
}

impl Address {
    /// Whether one of the two subexpressions holds the other.
    pub fn is_nested_with(&self, other: &Address) -> bool {
        self.place == other.place
            && (self.path.starts_with(&other.path) || other.path.starts_with(&self.path))
    }

    /// The subexpression.
    pub fn find<'a>(&self, display: &'a Display) -> Option<&'a Expr> {
        let mut expr = self.place.find(display)?;
        for step in &self.path {
            expr = children(expr).into_iter().nth(*step)?;
        }
        Some(expr)
    }

    fn find_mut<'a>(&self, display: &'a mut Display) -> Option<&'a mut Expr> {
        let mut expr = self.place.find_mut(display)?;
        for step in &self.path {
            expr = children_mut(expr).into_iter().nth(*step)?;
        }
        Some(expr)
    }
}

/// A subexpression and what to put in its place.
#[derive(Clone, Debug)]
pub struct Replacement {
    /// Where.
    pub address: Address,
    /// What kind of slip it would repair.
    pub class: EditClass,
    /// What to put there.
    pub kind: ExprKind,
}

impl Replacement {
    /// Changes the display; `false` when the address is not in it.
    pub fn apply(&self, display: &mut Display) -> bool {
        match self.address.find_mut(display) {
            Some(expr) => {
                expr.kind = self.kind.clone();
                true
            }
            None => false,
        }
    }

    /// The change in LaTeX.
    pub fn describe(&self, display: &Display) -> Option<Edit> {
        let old = self.address.find(display)?;
        Some(Edit {
            class: self.class,
            span: old.span,
            printed: latex::write_expr(old),
            corrected: latex::write_expr(&Expr::new(self.kind.clone(), old.span)),
        })
    }
}

/// Every subexpression of a side with its address, parents first.
pub fn addresses(display: &Display, place: Place) -> Vec<(Address, Expr)> {
    fn descend(expr: &Expr, address: &Address, found: &mut Vec<(Address, Expr)>) {
        found.push((address.clone(), expr.clone()));
        for (step, child) in children(expr).into_iter().enumerate() {
            let mut deeper = address.clone();
            deeper.path.push(step);
            descend(child, &deeper, found);
        }
    }
    let mut found = Vec::new();
    if let Some(expr) = place.find(display) {
        let address = Address {
            place,
            path: Vec::new(),
        };
        descend(expr, &address, &mut found);
    }
    found
}

/// Braces that stand under the last of several rows and belong under all of them: each whole member
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
                address: Address {
                    place: Place::Body { clause, brace },
                    path: Vec::new(),
                },
                class: EditClass::Bracket,
                kind: ExprKind::Matrix {
                    rows: above.chain([(**body).clone()]).map(|e| vec![e]).collect(),
                    bracket: Bracket::Square,
                },
            });
        }
        crate::model::links::visit(member, &mut |e| {
            brace += usize::from(matches!(e.kind, ExprKind::Underbrace { .. }));
        });
    }
    found
}

/// One dot more or less over each dotted name, one dot on each name that occurs dotted, and one on
/// a name that stands alone under a brace.
pub fn dots(display: &Display, places: &[Place]) -> Vec<Replacement> {
    let all: Vec<_> = places.iter().flat_map(|p| addresses(display, *p)).collect();
    let dotted: Vec<String> = all
        .iter()
        .filter_map(|(_, e)| name_of(e))
        .filter(|n| n.dots > 0)
        .map(|n| latex::canonical(&n.undotted()))
        .collect();
    let mut found = Vec::new();
    for (address, expr) in &all {
        let Some(name) = name_of(expr) else { continue };
        let labels = matches!(address.place, Place::Label { .. }) && address.path.is_empty();
        if !labels && !dotted.contains(&latex::canonical(&name.undotted())) {
            continue;
        }
        for dots in [name.dots.checked_add(1), name.dots.checked_sub(1)] {
            let Some(dots) = dots.filter(|d| *d <= 4) else {
                continue;
            };
            found.push(Replacement {
                address: address.clone(),
                class: EditClass::Dot,
                kind: with_name(
                    expr,
                    Name {
                        dots,
                        ..name.clone()
                    },
                ),
            });
        }
    }
    found
}

/// One dot more or less over the letter in a subscript, as in the spectrum of a derivative.
pub fn dots_below(display: &Display, places: &[Place]) -> Vec<Replacement> {
    let mut found = Vec::new();
    for (address, expr) in places.iter().flat_map(|p| addresses(display, *p)) {
        let Some((name, index)) =
            name_of(&expr).and_then(|name| match name.subscript.as_ref()?.indices.as_slice() {
                [index] => Some((name, index)),
                _ => None,
            })
        else {
            continue;
        };
        let ExprKind::Name(below) = &index.kind else {
            continue;
        };
        if below.dots == 0 {
            continue;
        }
        for dots in [below.dots + 1, below.dots - 1] {
            let below = Expr::new(
                ExprKind::Name(Name {
                    dots,
                    ..below.clone()
                }),
                index.span,
            );
            let subscript = Subscript {
                label: latex::write_expr(&below),
                indices: vec![below],
            };
            let renamed = Name {
                subscript: Some(subscript),
                ..name.clone()
            };
            found.push(Replacement {
                address: address.clone(),
                class: EditClass::Dot,
                kind: with_name(&expr, renamed),
            });
        }
    }
    found
}

fn name_of(expr: &Expr) -> Option<&Name> {
    match &expr.kind {
        ExprKind::Name(name) | ExprKind::Apply { function: name, .. } => Some(name),
        _ => None,
    }
}

fn with_name(expr: &Expr, name: Name) -> ExprKind {
    match &expr.kind {
        ExprKind::Apply { arguments, .. } => ExprKind::Apply {
            function: name,
            arguments: arguments.clone(),
        },
        _ => ExprKind::Name(name),
    }
}

/// Other readings of each printed index: the index expressions of the same link put in other
/// slots, exchanged letters, and the same subscript in another order.
pub fn indices(display: &Display, places: &[Place]) -> Vec<Replacement> {
    let all: Vec<_> = places.iter().flat_map(|p| addresses(display, *p)).collect();
    let subscripts: Vec<(&Address, &Expr, &Name, &Subscript, Vec<Name>)> = all
        .iter()
        .filter_map(|(address, expr)| {
            let name = name_of(expr)?;
            let subscript = name.subscript.as_ref()?;
            let letters = bound_letters(display, address, &all);
            let is_index = !subscript.indices.is_empty()
                && subscript
                    .indices
                    .iter()
                    .all(|i| is_index_expression(i, &letters));
            is_index.then_some((address, expr, name, subscript, letters))
        })
        .collect();
    let mut found = Vec::new();
    for (address, expr, name, subscript, letters) in &subscripts {
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
            found.push(Replacement {
                address: (*address).clone(),
                class: EditClass::Index,
                kind: with_name(expr, renamed),
            });
        }
    }
    found
}

/// The indices that have a value at an address: those of its clause's ranges and of the sums around
/// it.
fn bound_letters(display: &Display, address: &Address, all: &[(Address, Expr)]) -> Vec<Name> {
    let clause = &display.clauses[address.place.clause()];
    let mut letters: Vec<Name> = clause.ranges.iter().map(|r| r.index.clone()).collect();
    for (outer, expr) in all {
        if let ExprKind::BigSum { index, .. } = &expr.kind
            && outer.place == address.place
            && address.path.starts_with(&outer.path)
            && address.path.get(outer.path.len()) == Some(&SUM_BODY)
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
                    add(number(neighbour, item));
                }
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

fn number(value: i64, at: &Expr) -> Expr {
    Expr::new(
        ExprKind::Number(BigRational::from_integer(BigInt::from(value))),
        at.span,
    )
}

/// The other sign for each term of each sum, and for each factor that is a whole side.
pub fn signs(display: &Display, places: &[Place]) -> Vec<Replacement> {
    let mut found = Vec::new();
    for place in places {
        for (address, expr) in addresses(display, *place) {
            if let ExprKind::Sum(terms) = &expr.kind {
                for k in 0..terms.len() {
                    let mut changed = terms.clone();
                    changed[k].0 = match changed[k].0 {
                        Sign::Plus => Sign::Minus,
                        Sign::Minus => Sign::Plus,
                    };
                    found.push(Replacement {
                        address: address.clone(),
                        class: EditClass::Sign,
                        kind: ExprKind::Sum(changed),
                    });
                }
            } else if address.path.is_empty() {
                found.push(Replacement {
                    address,
                    class: EditClass::Sign,
                    kind: ExprKind::Sum(vec![(Sign::Minus, expr)]),
                });
            }
        }
    }
    found
}

/// Exponents one or two off, lost, or restored on a letter that has none.
pub fn exponents(display: &Display, places: &[Place]) -> Vec<Replacement> {
    let mut found = Vec::new();
    for place in places {
        let all = addresses(display, *place);
        for (address, expr) in &all {
            match &expr.kind {
                ExprKind::Power { base, exponent } => {
                    let Some(value) = literal_integer(exponent) else {
                        continue;
                    };
                    for other in [value - 1, value + 1, value - 2, value + 2] {
                        let kind = match other {
                            1 => base.kind.clone(),
                            2.. => ExprKind::Power {
                                base: base.clone(),
                                exponent: Box::new(number(other, exponent)),
                            },
                            _ => continue,
                        };
                        found.push(Replacement {
                            address: address.clone(),
                            class: EditClass::Exponent,
                            kind,
                        });
                    }
                }
                ExprKind::Name(_) | ExprKind::Group { .. } => {
                    let in_power = address.path.split_last().is_some_and(|(_, up)| {
                        all.iter()
                            .any(|(a, e)| a.path == up && matches!(e.kind, ExprKind::Power { .. }))
                    });
                    if !in_power {
                        for exponent in [2, 3] {
                            found.push(Replacement {
                                address: address.clone(),
                                class: EditClass::Exponent,
                                kind: ExprKind::Power {
                                    base: Box::new(expr.clone()),
                                    exponent: Box::new(number(exponent, expr)),
                                },
                            });
                        }
                    }
                }
                _ => {}
            }
        }
    }
    found
}

/// Integer literals one off, doubled or halved.
pub fn literals(display: &Display, places: &[Place]) -> Vec<Replacement> {
    let mut found = Vec::new();
    for place in places {
        let all = addresses(display, *place);
        for (address, expr) in &all {
            let ExprKind::Number(value) = &expr.kind else {
                continue;
            };
            let is_exponent = address.path.split_last().is_some_and(|(last, up)| {
                *last == 1
                    && all
                        .iter()
                        .any(|(a, e)| a.path == up && matches!(e.kind, ExprKind::Power { .. }))
            });
            if is_exponent {
                continue;
            }
            let two = BigRational::from_integer(BigInt::from(2));
            let one = BigRational::from_integer(BigInt::from(1));
            for other in [value + &one, value - &one, value * &two, value / &two] {
                found.push(Replacement {
                    address: address.clone(),
                    class: EditClass::Factor,
                    kind: ExprKind::Number(other),
                });
            }
        }
    }
    found
}

/// Another letter of the integrand as the variable of an integral.
pub fn measures(display: &Display, places: &[Place]) -> Vec<Replacement> {
    let mut found = Vec::new();
    for place in places {
        for (address, expr) in addresses(display, *place) {
            let ExprKind::Integral {
                limits,
                body,
                variable,
            } = &expr.kind
            else {
                continue;
            };
            let mut names: Vec<Name> = Vec::new();
            crate::model::links::visit(body, &mut |e| {
                if let ExprKind::Name(name) = &e.kind
                    && name != variable
                    && !names.contains(name)
                {
                    names.push(name.clone());
                }
            });
            found.extend(names.into_iter().map(|variable| Replacement {
                address: address.clone(),
                class: EditClass::Measure,
                kind: ExprKind::Integral {
                    limits: limits.clone(),
                    body: body.clone(),
                    variable,
                },
            }));
        }
    }
    found
}

/// Each letter exchanged for another letter of the same side or of the other one.
pub fn letters(display: &Display, places: &[Place]) -> Vec<Replacement> {
    let all: Vec<_> = places.iter().flat_map(|p| addresses(display, *p)).collect();
    let mut names: Vec<Name> = Vec::new();
    for (_, expr) in &all {
        if let ExprKind::Name(name) = &expr.kind
            && !names.contains(name)
        {
            names.push(name.clone());
        }
    }
    let mut found = Vec::new();
    for (address, expr) in &all {
        let ExprKind::Name(name) = &expr.kind else {
            continue;
        };
        for other in &names {
            if other == name || other.letter.font != name.letter.font {
                continue;
            }
            // A process for another one: its own dots, or those that the printed letter has.
            let mut dots = vec![other.dots];
            if name.dots > 0 && other.undotted() != name.undotted() && other.dots != name.dots {
                dots.push(name.dots);
            }
            for dots in dots {
                let other = Name {
                    dots,
                    ..other.clone()
                };
                found.push(Replacement {
                    address: address.clone(),
                    class: EditClass::Letter,
                    kind: ExprKind::Name(other),
                });
            }
        }
    }
    found
}

/// A transposition more on each bold letter, bracket or matrix, or one less where there is one.
pub fn transpositions(display: &Display, places: &[Place]) -> Vec<Replacement> {
    let mut found = Vec::new();
    for place in places {
        let all = addresses(display, *place);
        for (address, expr) in &all {
            let kind = match &expr.kind {
                ExprKind::Transpose(inner) => inner.kind.clone(),
                _ if may_be_matrix(expr) && !inside_transpose(address, &all) => {
                    ExprKind::Transpose(Box::new(expr.clone()))
                }
                _ => continue,
            };
            found.push(Replacement {
                address: address.clone(),
                class: EditClass::Transpose,
                kind,
            });
        }
    }
    found
}

/// Whether a letter, bracket or matrix could be a matrix by what is printed: something bold in it.
fn may_be_matrix(expr: &Expr) -> bool {
    let bold = |e: &Expr| name_of(e).is_some_and(|n| n.letter.font == Font::Bold);
    match &expr.kind {
        ExprKind::Name(_) | ExprKind::Apply { .. } => bold(expr),
        ExprKind::Matrix { .. } => true,
        ExprKind::Group { .. } => {
            let mut any = false;
            crate::model::links::visit(expr, &mut |e| {
                any |= bold(e) || matches!(e.kind, ExprKind::Matrix { .. });
            });
            any
        }
        _ => false,
    }
}

/// Whether the expression at an address is what is transposed already.
fn inside_transpose(address: &Address, all: &[(Address, Expr)]) -> bool {
    address.path.split_last().is_some_and(|(_, up)| {
        all.iter()
            .any(|(a, e)| a.path == up && matches!(e.kind, ExprKind::Transpose(_)))
    })
}
