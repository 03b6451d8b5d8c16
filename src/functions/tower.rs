//! Squares in a tower of quadratic letters.
//!
//! Over a field K with t^2 = r no square in K, a + b t is the square of u + v t if and only if its norm
//! a^2 - b^2 r is a square d^2 in K and one of (a + d)/2, (a - d)/2 is a square u^2 in K, with v = b/2u;
//! for b = 0 if and only if a or a/r is a square in K (Borodin, Fagin, Hopcroft & Tompa 1985, on
//! decreasing the nesting depth of expressions involving square roots). A root that is found is verified by
//! squaring, so that nothing rests on the tower being one.

use super::quadratic::Quadratic;
use super::{FunctionLetter, FunctionTable};
use num_rational::BigRational;
use num_traits::Signed;
use ratpoly::{Polynomial, RationalFunction};
use std::collections::BTreeSet;

/// The most quadratic letters that are looked at together: the search doubles with each.
const MOST_LETTERS: usize = 6;

impl FunctionTable {
    /// An element whose square this one is, if the letters so far have one; up to sign.
    pub(super) fn root_in_tower(&self, f: &RationalFunction) -> Option<RationalFunction> {
        let letters = self.related_quadratics(f);
        if letters.len() > MOST_LETTERS {
            return None;
        }
        let root = self.root_over(f, &letters)?;
        (self.reduce(&root * &root) == *f).then_some(root)
    }

    /// The quadratic letters in which a root of an element may be written: those that occur, and roots
    /// of what is made of them.
    fn related_quadratics(&self, f: &RationalFunction) -> Vec<Quadratic> {
        let quadratics = self.quadratics();
        let mut known: BTreeSet<usize> = BTreeSet::new();
        let occurring = f.numerator().variables_occurring();
        for quadratic in quadratics.iter() {
            if occurring.contains(&quadratic.letter) {
                known.insert(quadratic.letter);
                known.extend(self.letters_behind(&self.variable(quadratic.letter)));
            }
        }
        let is_quadratic = |letter: &usize| quadratics.iter().any(|q| q.letter == *letter);
        known.retain(is_quadratic);
        // A root of what holds such a letter, or of a symbol that the element holds.
        for quadratic in quadratics.iter() {
            if !matches!(
                self.meaning(quadratic.letter),
                Some(FunctionLetter::Root(_))
            ) {
                continue;
            }
            let radicand = quadratic.square.variables_occurring();
            let related = match radicand.is_empty() {
                true => known.iter().any(|l| self.is_number(*l)),
                false => radicand
                    .iter()
                    .any(|l| known.contains(l) || !known.is_empty() && occurring.contains(l)),
            };
            if related {
                known.insert(quadratic.letter);
            }
        }
        let related = quadratics.iter().filter(|q| known.contains(&q.letter));
        related.cloned().collect()
    }

    fn root_over(&self, f: &RationalFunction, letters: &[Quadratic]) -> Option<RationalFunction> {
        if f.is_zero() {
            return Some(f.clone());
        }
        let Some((last, before)) = letters.split_last() else {
            return rational_root(f);
        };
        let t = self.variable(last.letter);
        let square = RationalFunction::from(last.square.clone());
        let below = RationalFunction::from(f.denominator().clone());
        let parts = f.numerator().coefficients_in(last.letter);
        let part = |k: usize| -> Option<RationalFunction> {
            let p = parts.get(k).cloned();
            let p = p.unwrap_or_else(|| Polynomial::zero(self.ring));
            RationalFunction::from(p).checked_div(&below).ok()
        };
        if parts.len() > 2 || f.denominator().degree(last.letter) > Some(0) {
            return None;
        }
        let (a, b) = (part(0)?, part(1)?);
        if b.is_zero() {
            if let Some(u) = self.root_over(&a, before) {
                return Some(u);
            }
            let quotient = self.reduce(a.checked_div(&square).ok()?);
            let v = self.root_over(&quotient, before)?;
            return Some(self.reduce(&v * &t));
        }
        let norm = self.reduce(&(&a * &a) - &(&(&b * &b) * &square));
        let d = self.root_over(&norm, before)?;
        let half = RationalFunction::constant(self.ring, BigRational::new(1.into(), 2.into()));
        for d in [d.clone(), -&d] {
            let Some(u) = self.root_over(&(&(&a + &d) * &half), before) else {
                continue;
            };
            if u.is_zero() {
                continue;
            }
            let v = self.reduce((&b * &half).checked_div(&u).ok()?);
            return Some(self.reduce(&u + &(&v * &t)));
        }
        None
    }
}

/// The rational function whose square this is, up to sign.
fn rational_root(f: &RationalFunction) -> Option<RationalFunction> {
    let above = square_root_of(f.numerator())?;
    let below = square_root_of(f.denominator())?;
    RationalFunction::new(above, below).ok()
}

/// The polynomial whose square this is, if it is one, up to sign.
pub(crate) fn square_root_of(square: &Polynomial) -> Option<Polynomial> {
    let factorization = square.square_free_factorization();
    if factorization.content.is_negative() {
        return None;
    }
    let root = factorization.content.sqrt();
    if &root * &root != factorization.content {
        return None;
    }
    let mut product = Polynomial::constant(square.ring(), root);
    for (factor, multiplicity) in factorization.factors {
        if multiplicity % 2 == 1 {
            return None;
        }
        product = &product * &factor.try_pow(multiplicity / 2).ok()?;
    }
    Some(product)
}
