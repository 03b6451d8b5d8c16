//! Signs of elements with functions, wherever the letters that are known to be positive are so.

use super::FunctionTable;
use num_traits::Signed;
use ratpoly::{Budget, Polynomial, RationalFunction, Region, RegionSign, sign_on};
use std::cmp::Ordering;
use std::collections::HashMap;

/// Signs that were asked for: a search asks for the same ones again and again.
#[derive(Debug, Default)]
pub(super) struct KnownSigns {
    found: HashMap<Polynomial, Option<Ordering>>,
    /// The end of the letters that occur in them.
    end: usize,
}

/// The most signs that are kept.
const MOST_SIGNS: usize = 10_000;

impl KnownSigns {
    fn insert(&mut self, p: &Polynomial, sign: Option<Ordering>, last_letter: usize) {
        if self.found.len() == MOST_SIGNS {
            self.found.clear();
            self.end = 0;
        }
        self.end = self.end.max(last_letter + 1);
        self.found.insert(p.clone(), sign);
    }

    /// Forgets what letters from `end` on occur in.
    pub fn take_back(&mut self, end: usize) {
        if self.end > end {
            let last = |p: &Polynomial| p.variables_occurring().last().copied();
            self.found.retain(|p, _| last(p) < Some(end));
            self.end = end;
        }
    }
}

impl FunctionTable {
    /// The sign of an element wherever the positive letters are positive, if it has one: never
    /// `Equal` but for zero itself.
    pub fn sign(&self, f: &RationalFunction) -> Option<Ordering> {
        let numerator = self.sign_of_polynomial(f.numerator())?;
        Some(match self.sign_of_polynomial(f.denominator())? {
            Ordering::Less => numerator.reverse(),
            _ => numerator,
        })
    }

    fn sign_of_polynomial(&self, p: &Polynomial) -> Option<Ordering> {
        if p.is_zero() {
            return Some(Ordering::Equal);
        }
        let occurring = p.variables_occurring();
        if !occurring.iter().all(|l| self.is_real_letter(*l)) {
            return None;
        }
        let mut signs = p.terms().map(|(_, c)| c.is_positive());
        let first = signs.next()?;
        if signs.all(|s| s == first) && occurring.iter().all(|l| self.is_positive_letter(*l)) {
            return Some(if first {
                Ordering::Greater
            } else {
                Ordering::Less
            });
        }
        if let Some(known) = self.lock().signs.found.get(p) {
            return *known;
        }
        let sign = self.sign_on_letters(p, &occurring);
        let last_letter = occurring.last().copied().unwrap_or(0);
        self.lock().signs.insert(p, sign, last_letter);
        sign
    }

    /// The sign of a polynomial where the positive ones among its letters are positive.
    fn sign_on_letters(&self, p: &Polynomial, occurring: &[usize]) -> Option<Ordering> {
        let zero = ratpoly::Bound::Finite(num_rational::BigRational::from_integer(0.into()));
        let line = (
            ratpoly::Bound::NegativeInfinity,
            ratpoly::Bound::PositiveInfinity,
        );
        let intervals: Vec<_> = (0..self.ring.len())
            .map(|l| match occurring.contains(&l) {
                true if self.is_positive_letter(l) => {
                    (zero.clone(), ratpoly::Bound::PositiveInfinity)
                }
                true => line.clone(),
                false => (zero.clone(), ratpoly::Bound::PositiveInfinity),
            })
            .collect();
        let region = Region::new(intervals).ok()?;
        match sign_on(p, &region, &Budget::new(20_000, 4_000, 5_000_000)).ok()? {
            RegionSign::Positive => Some(Ordering::Greater),
            RegionSign::Negative => Some(Ordering::Less),
            _ => None,
        }
    }

    /// Whether an element is known to be positive.
    pub fn is_positive(&self, f: &RationalFunction) -> bool {
        self.sign(f) == Some(Ordering::Greater)
    }
}
