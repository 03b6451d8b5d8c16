//! Which numbers a letter stands for: its domain, and the ends between which its values lie.
//!
//! A letter is real unless the document says otherwise. `positive = true` is the range from zero on,
//! zero excluded; `range = "0 < a \le 2"` says both ends, each with whether it belongs to the range.

use crate::expr::Relation;
use num_rational::BigRational;
use num_traits::{Signed, Zero};

/// The numbers that a letter stands for.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Numbers {
    /// Any real number.
    #[default]
    Real,
    /// Any complex number.
    Complex,
    /// Any integer.
    Integer,
}

/// One end of a range.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct End {
    /// Where it is.
    pub value: BigRational,
    /// Whether it belongs to the range.
    pub included: bool,
}

/// Simple numbers of either sign, from small to large; among them are legs of right triangles with
/// hypotenuse one, so that s² + c² = 1 has points.
const SAMPLES: [(i64, i64); 29] = [
    (1, 1),
    (2, 1),
    (-1, 1),
    (3, 1),
    (1, 2),
    (-2, 1),
    (0, 1),
    (3, 5),
    (4, 5),
    (-1, 2),
    (5, 1),
    (1, 3),
    (-3, 5),
    (3, 2),
    (4, 1),
    (5, 13),
    (12, 13),
    (-3, 1),
    (7, 1),
    (1, 10),
    (-4, 5),
    (8, 17),
    (15, 17),
    (10, 1),
    (-5, 2),
    (2, 3),
    (1, 100),
    (100, 1),
    (-7, 3),
];

/// The values that a letter may have.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Range {
    /// Which numbers.
    pub numbers: Numbers,
    /// Nothing below it.
    pub low: Option<End>,
    /// Nothing above it.
    pub high: Option<End>,
}

impl Range {
    /// The positive real numbers.
    pub fn positive() -> Self {
        let mut range = Range::default();
        range.raise(BigRational::zero(), false);
        range
    }

    /// Leaves out what is below `value`, and the value itself unless it is `included`.
    pub fn raise(&mut self, value: BigRational, included: bool) {
        let closer = self
            .low
            .as_ref()
            .is_none_or(|low| value > low.value || value == low.value && low.included && !included);
        if closer {
            self.low = Some(End { value, included });
        }
    }

    /// Leaves out what is above `value`, and the value itself unless it is `included`.
    pub fn lower(&mut self, value: BigRational, included: bool) {
        let closer = self.high.as_ref().is_none_or(|high| {
            value < high.value || value == high.value && high.included && !included
        });
        if closer {
            self.high = Some(End { value, included });
        }
    }

    /// Takes in what a comparison with a number says, which stands on the left of the relation or on the right;
    /// whether it says between which numbers the letter lies.
    pub fn compare(&mut self, relation: Relation, on_the_left: bool, value: BigRational) -> bool {
        match (relation, on_the_left) {
            (Relation::Less, true) | (Relation::Greater, false) => self.raise(value, false),
            (Relation::LessEqual, true) | (Relation::GreaterEqual, false) => {
                self.raise(value, true)
            }
            (Relation::Greater, true) | (Relation::Less, false) => self.lower(value, false),
            (Relation::GreaterEqual, true) | (Relation::LessEqual, false) => {
                self.lower(value, true)
            }
            (
                Relation::Equal
                | Relation::NotEqual
                | Relation::Approximately
                | Relation::Distributed
                | Relation::Tends,
                _,
            ) => return false,
        }
        true
    }

    /// Whether a real number is among the values.
    pub fn contains(&self, number: &BigRational) -> bool {
        let above = self
            .low
            .as_ref()
            .is_none_or(|low| *number > low.value || low.included && *number == low.value);
        let below = self
            .high
            .as_ref()
            .is_none_or(|high| *number < high.value || high.included && *number == high.value);
        above && below && (self.numbers != Numbers::Integer || number.is_integer())
    }

    /// A number of the range that is near to another: the number itself, its negative on every second
    /// try, or one between the ends.
    pub fn near(&self, number: &BigRational, attempt: u32) -> BigRational {
        let flipped = if attempt.is_multiple_of(2) {
            -number
        } else {
            number.clone()
        };
        if self.contains(&flipped) {
            return flipped;
        }
        if self.contains(number) {
            return number.clone();
        }
        let one = BigRational::from_integer(1.into());
        // Between 0 and 1, increasing with the number.
        let share = number.abs() / (number.abs() + &one);
        let between = match (&self.low, &self.high) {
            (Some(low), Some(high)) => &low.value + (&high.value - &low.value) * share,
            (Some(low), None) => &low.value + number.abs(),
            (None, Some(high)) => &high.value - number.abs(),
            (None, None) => number.clone(),
        };
        if self.contains(&between) {
            return between;
        }
        let rounded = [between.floor(), between.ceil(), between.floor() + one];
        let ends = [&self.low, &self.high].map(|end| end.as_ref().map(|e| e.value.clone()));
        let mut candidates = rounded.into_iter().chain(ends.into_iter().flatten());
        candidates.find(|c| self.contains(c)).unwrap_or(between)
    }

    /// Whether every value is greater than zero.
    pub fn is_positive(&self) -> bool {
        self.numbers != Numbers::Complex
            && self
                .low
                .as_ref()
                .is_some_and(|low| low.value.is_positive() || low.value.is_zero() && !low.included)
    }

    /// Whether every value is less than zero.
    pub fn is_negative(&self) -> bool {
        self.numbers != Numbers::Complex
            && self.high.as_ref().is_some_and(|high| {
                high.value.is_negative() || high.value.is_zero() && !high.included
            })
    }

    /// Whether no value is less than zero.
    pub fn is_not_negative(&self) -> bool {
        self.numbers != Numbers::Complex
            && self
                .low
                .as_ref()
                .is_some_and(|low| !low.value.is_negative())
    }

    /// The same values of an integer with ends that are integers and belong to it.
    #[must_use]
    pub fn tightened(&self) -> Range {
        if self.numbers != Numbers::Integer {
            return self.clone();
        }
        let one = BigRational::from_integer(1.into());
        let end = |end: &Option<End>, up: bool| {
            end.as_ref().map(|end| {
                let mut value = match up {
                    true => end.value.ceil(),
                    false => end.value.floor(),
                };
                if value == end.value && !end.included {
                    value = if up { value + &one } else { value - &one };
                }
                End {
                    value,
                    included: true,
                }
            })
        };
        Range {
            numbers: Numbers::Integer,
            low: end(&self.low, true),
            high: end(&self.high, false),
        }
    }

    /// The value, where there is one only.
    pub fn single(&self) -> Option<&BigRational> {
        match (&self.low, &self.high) {
            (Some(low), Some(high)) if low.value == high.value && low.included && high.included => {
                Some(&low.value)
            }
            _ => None,
        }
    }

    /// A value that lies in the range, each number of a list of its own; the first ones are simple.
    pub fn sample(&self, number: usize) -> BigRational {
        let range = self.tightened();
        let (above, below) = SAMPLES[number % SAMPLES.len()];
        let sample = BigRational::new(above.into(), below.into());
        let integer = range.numbers == Numbers::Integer;
        let size = if integer {
            BigRational::from_integer((number % SAMPLES.len()).into())
        } else {
            sample.abs() + BigRational::new(i64::from(above == 0).into(), 64.into())
        };
        match (&range.low, &range.high) {
            (Some(low), _) if low.included && number % 7 == 6 => low.value.clone(),
            (_, Some(high)) if high.included && number % 7 == 5 => high.value.clone(),
            (Some(low), Some(high)) if integer => {
                let width = &high.value - &low.value;
                let steps = &width + BigRational::from_integer(1.into());
                let whole = (&size / &steps).floor() * &steps;
                &low.value + (size - whole)
            }
            // x/(1 + x) runs from 0 to 1.
            (Some(low), Some(high)) => {
                let part = &size / (&size + BigRational::from_integer(1.into()));
                &low.value + (&high.value - &low.value) * part
            }
            (Some(low), None) => &low.value + size,
            (None, Some(high)) => &high.value - size,
            (None, None) if integer => match number % 2 {
                0 => BigRational::from_integer((number / 2 % SAMPLES.len()).into()),
                _ => -BigRational::from_integer((number / 2 % SAMPLES.len() + 1).into()),
            },
            (None, None) => sample,
        }
    }

    /// Whether no number is left: an end below the other, or one point that does not belong to it.
    pub fn is_empty(&self) -> bool {
        match (&self.low, &self.high) {
            (Some(low), Some(high)) => {
                let integers = self.numbers == Numbers::Integer;
                if integers {
                    let first = match low.value.is_integer() && !low.included {
                        true => &low.value + BigRational::from_integer(1.into()),
                        false => low.value.ceil(),
                    };
                    return !self.contains(&first);
                }
                low.value > high.value
                    || low.value == high.value && !(low.included && high.included)
            }
            _ => false,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn number(n: i64) -> BigRational {
        BigRational::from_integer(n.into())
    }

    #[test]
    fn ends_belong_to_it_or_not() {
        let mut range = Range::positive();
        range.lower(number(2), true);
        assert!(range.is_positive() && !range.is_empty());
        assert!(range.contains(&number(2)) && !range.contains(&number(0)));
        range.lower(number(2), false);
        assert!(!range.contains(&number(2)));
        range.raise(number(2), true);
        assert!(range.is_empty());
    }

    #[test]
    fn samples_lie_in_the_range() {
        let ends = |low: Option<(i64, bool)>, high: Option<(i64, bool)>, numbers| {
            let mut range = Range {
                numbers,
                ..Range::default()
            };
            if let Some((low, included)) = low {
                range.raise(number(low), included);
            }
            if let Some((high, included)) = high {
                range.lower(number(high), included);
            }
            range
        };
        for numbers in [Numbers::Real, Numbers::Integer] {
            for low in [None, Some((0, false)), Some((-3, true))] {
                for high in [None, Some((2, false)), Some((5, true))] {
                    let range = ends(low, high, numbers);
                    for k in 0..200 {
                        let sample = range.sample(k);
                        assert!(range.contains(&sample), "{range:?} {k} {sample}");
                    }
                }
            }
        }
    }

    #[test]
    fn between_two_integers_there_may_be_none() {
        let mut range = Range {
            numbers: Numbers::Integer,
            ..Range::default()
        };
        range.raise(number(1), false);
        range.lower(number(2), false);
        assert!(range.is_empty());
        range.lower(number(3), false);
        assert!(range.is_empty());
    }
}
