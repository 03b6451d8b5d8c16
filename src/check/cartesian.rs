//! Identities of complex letters: each is u + iv with real u and v.
//!
//! The modulus, the real part and the conjugate of a letter that may be complex are no rational functions of
//! it, but they are functions of its parts. Where nothing else decides an equation, both sides are
//! evaluated in the world in which each complex letter is put together from two new real letters; what is
//! an identity there is one for every complex number. Only what is put together from numbers and letters
//! by arithmetic and functions is read so: a derivative or an integral by such a letter would mean
//! something else.

use super::Checker;
use super::identity::Insertion;
use crate::expr::{ExprKind, Relation};
use crate::functions::{FunctionLetter, FunctionTable};
use crate::model::Letter;
use crate::model::links::Link;
use crate::model::names::Resolved;
use crate::model::range::Numbers;
use crate::verdict::Verdict;
use ratpoly::RationalFunction;
use std::collections::BTreeSet;

/// The number of the first part among variables of integration: no integral is as deep, no case either.
pub(super) const FIRST: usize = 2_000;
/// How many complex letters are taken apart.
const MOST: usize = 6;

impl Checker<'_> {
    /// That an equation is an identity in the parts of its complex letters.
    pub(super) fn in_cartesian_form(&mut self, equation: usize, link: &Link) -> Option<Verdict> {
        if link.relation != Relation::Equal || self.supposed.in_force {
            return None;
        }
        let letters = self.complex_letters(equation, link)?;
        let table = self.functions()?.clone();
        let count = table.given_out();
        let found = self.bounded(|c| c.identity_of_parts(equation, link, &letters, &table));
        // The proof is plain data: nothing else keeps the new letters.
        table.take_back(count);
        found.ok().flatten()
    }

    fn identity_of_parts(
        &mut self,
        equation: usize,
        link: &Link,
        letters: &[usize],
        table: &FunctionTable,
    ) -> Option<Verdict> {
        let world = self.exact.world().clone().inserting();
        let mut values = world.letters().to_vec();
        let mut images: Vec<(usize, RationalFunction)> = Vec::new();
        for (k, letter) in letters.iter().enumerate() {
            let part = |side: usize| table.bound(FIRST + 2 * k + side, false).ok();
            let i = table.imaginary_unit().ok()?;
            let image = &part(0)? + &(&part(1)? * &i);
            values[*letter] = image.clone();
            images.push((*letter, image));
        }
        let exact = self.exact.in_world(world.with_letters(values));
        let mut inside = self.beside(exact);
        let entries = inside.sides(equation, link).ok()?;
        if entries.iter().any(|e| e.left != e.right) {
            return None;
        }
        // A divisor is named in the letters of the document or not at all.
        for mut condition in inside.exact.conditions.clone() {
            let behind = table.letters_behind(&condition.divisor);
            if behind.into_iter().any(|l| is_part(table, l)) {
                let vanishes_with = |(_, image): &&(_, RationalFunction)| {
                    vanish_together(table, &condition.divisor, image)
                };
                let (letter, _) = images.iter().find(vanishes_with)?;
                condition.divisor = RationalFunction::variable(self.model.ring, *letter);
            }
            if !self.exact.conditions.contains(&condition) {
                self.exact.conditions.push(condition);
            }
        }
        let by = Insertion {
            letters: images,
            labels: Vec::new(),
        };
        let proof = inside.proved(equation, link, &entries, &by, None)?;
        Some(Verdict::Holds {
            by: by.labels,
            proof,
        })
    }

    /// The letters behind a link that may be complex, where all that stands there is put together by
    /// arithmetic and functions.
    fn complex_letters(&self, equation: usize, link: &Link) -> Option<Vec<usize>> {
        let model = self.model;
        let display = |e: usize| self.exact.display(e);
        let mut symbols = BTreeSet::new();
        let mut plain = true;
        for place in [link.left, link.right] {
            let side = place.find(self.exact.display(equation))?;
            model.visit_behind(side, &display, &mut |e| match &e.kind {
                ExprKind::Name(name) => {
                    if let Ok(Resolved::Letter { symbol, order }) = model.resolve(name, &|_| false)
                    {
                        let known = &model.symbols[symbol];
                        if known.range.numbers == Numbers::Complex {
                            plain &= order == 0
                                && known.function_of.is_none()
                                && known.arguments.is_empty();
                            symbols.insert(symbol);
                        }
                    }
                }
                ExprKind::Number(_)
                | ExprKind::Call { .. }
                | ExprKind::Sum(_)
                | ExprKind::Product(_)
                | ExprKind::Quotient { .. }
                | ExprKind::Power { .. }
                | ExprKind::Transpose(_)
                | ExprKind::Group { .. }
                | ExprKind::Matrix { .. }
                | ExprKind::Tuple(_)
                | ExprKind::BigSum { .. } => {}
                ExprKind::Apply { .. }
                | ExprKind::Named { .. }
                | ExprKind::Integral { .. }
                | ExprKind::Derivative { .. }
                | ExprKind::Expectation(_)
                | ExprKind::Underbrace { .. }
                | ExprKind::Cases(_)
                | ExprKind::Infinity
                | ExprKind::Constant => plain = false,
            });
        }
        let letters = model.letters.iter().enumerate();
        let letters = letters.filter_map(|(letter, kind)| match kind {
            Letter::Symbol { symbol, order: 0 } if symbols.contains(symbol) => Some(letter),
            Letter::Symbol { .. } | Letter::Abbreviation { .. } | Letter::Function { .. } => None,
        });
        let letters: Vec<usize> = letters.collect();
        (plain && !letters.is_empty() && letters.len() <= MOST).then_some(letters)
    }
}

/// Whether |f|^2 is a number times |g|^2 or |g|^4, as of g itself, its modulus, and the square of that.
fn vanish_together(table: &FunctionTable, f: &RationalFunction, g: &RationalFunction) -> bool {
    let norm = |f: &RationalFunction| Some(table.reduce(f * &table.conjugate(f).ok()?));
    let (Some(f), Some(g)) = (norm(f), norm(g)) else {
        return false;
    };
    [g.clone(), &g * &g].iter().any(|power| {
        let ratio = f.checked_div(power).map(|ratio| table.reduce(ratio));
        ratio.is_ok_and(|ratio| ratio.as_constant().is_some())
    })
}

/// Whether a letter is the real or imaginary part of one that is taken apart.
fn is_part(table: &FunctionTable, letter: usize) -> bool {
    matches!(table.meaning(letter), Some(FunctionLetter::Bound { depth, .. }) if depth >= FIRST)
}
