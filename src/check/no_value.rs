//! Divisors that vanish identically once all definitions are inserted.
//!
//! Abbreviations are kept as letters, so that `h/h` is 1 although `h = x - x`, and `(a^2-b^2)/(a-b)` is
//! a + b although a = b. Every divisor is recorded before anything cancels; here each is asked whether
//! it is zero with everything inserted. Whatever divides by zero has no value, and nothing holds of it.
//!
//! Most divisors do not vanish, which one value modulo a prime shows (Schwartz 1980, Zippel 1979);
//! only where that value is zero, or where a function has a definition in its argument, is the
//! divisor computed.

use super::Checker;
use crate::domain::{Domain, PRIME, PrimeField};
use crate::evaluate::{Failure, FailureKind, Origin};
use ratpoly::RationalFunction;

impl Checker<'_> {
    /// The failure by the first of the recorded divisors that is zero with all definitions inserted.
    pub(super) fn vanishing_divisor(&self) -> Option<Failure> {
        // The end of a range may belong to it.
        let divisors = self.exact.conditions.iter();
        let mut divisors = divisors.filter(|c| !matches!(c.origin, Origin::Range { .. }));
        let zero = divisors.find(|c| self.vanishes(&c.divisor))?;
        let span = match &zero.origin {
            Origin::Divisor(span) | Origin::Range { span, .. } => *span,
            Origin::Determinant(equation) | Origin::Stability(equation) => {
                self.model.equations[*equation].span
            }
        };
        Some(Failure::new(FailureKind::DivisionByZero, span))
    }

    /// Whether an element is zero with all definitions inserted.
    pub(super) fn vanishes(&self, element: &RationalFunction) -> bool {
        if element.is_zero() {
            return true;
        }
        let field = &self.exact.field;
        let behind = field.letters_behind(element);
        let occurring = field.letters(element);
        if !behind.iter().any(|l| self.inserted.contains_key(l)) {
            return false;
        }
        let in_function = behind
            .iter()
            .any(|l| self.inserted.contains_key(l) && !occurring.contains(l))
            || occurring.iter().any(|l| self.is_function(*l));
        if !in_function && self.residue(element).is_some_and(|r| r != 0) {
            return false;
        }
        let all = self.insertion(&self.inserted.keys().copied().collect::<Vec<_>>());
        let inserted = match &self.model.functions {
            Some(table) => table.substitute(element, &all.letters).ok(),
            None => element.substitute(&all.letters).ok(),
        };
        // Where not even the divisor has a value, nothing that divides by it has one.
        inserted.is_none_or(|value| value.is_zero())
    }

    /// The value modulo the prime where the declared letters have arbitrary values, and the
    /// abbreviations those of their definitions.
    fn residue(&self, element: &RationalFunction) -> Option<u64> {
        let field = PrimeField;
        let mut point: Vec<u64> = (0..self.model.letters.len() as u64)
            .map(|k| {
                let spread = (k + 1).wrapping_mul(0x9e37_79b9_7f4a_7c15);
                (spread ^ spread >> 29) % (PRIME - 1) + 1
            })
            .collect();
        let free = point.clone();
        for (letter, value) in self.inserted.iter() {
            point[*letter] = field.image(value, &free)?;
        }
        field.image(element, &point)
    }
}
