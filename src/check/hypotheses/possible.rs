//! Which signs a real number may have: a set of minus, zero and plus.
//!
//! What is known about a sign is the set of signs that are left. Of what is true at once the
//! intersection is left, over the parts of a region the union; the empty set is a contradiction.

use ratpoly::RegionSign;
use std::cmp::Ordering;

/// The signs that are possible.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Signs(u8);

impl Signs {
    /// None: there is no such number.
    pub const NONE: Signs = Signs(0);
    /// Less than zero.
    pub const NEGATIVE: Signs = Signs(1);
    /// Zero.
    pub const ZERO: Signs = Signs(2);
    /// Zero or less.
    pub const NOT_POSITIVE: Signs = Signs(3);
    /// Greater than zero.
    pub const POSITIVE: Signs = Signs(4);
    /// Anything but zero.
    pub const NOT_ZERO: Signs = Signs(5);
    /// Zero or greater.
    pub const NOT_NEGATIVE: Signs = Signs(6);
    /// Nothing is known.
    pub const ANY: Signs = Signs(7);

    /// The sign of one number.
    pub fn of(order: Ordering) -> Signs {
        match order {
            Ordering::Less => Signs::NEGATIVE,
            Ordering::Equal => Signs::ZERO,
            Ordering::Greater => Signs::POSITIVE,
        }
    }

    /// What is known from a region.
    pub fn of_region(sign: &RegionSign) -> Signs {
        match sign {
            RegionSign::Zero => Signs::ZERO,
            RegionSign::Positive => Signs::POSITIVE,
            RegionSign::Negative => Signs::NEGATIVE,
            RegionSign::NonNegative => Signs::NOT_NEGATIVE,
            RegionSign::NonPositive => Signs::NOT_POSITIVE,
            RegionSign::Changes { .. } | RegionSign::Undecided => Signs::ANY,
        }
    }

    /// The signs that both know to be possible.
    #[must_use]
    pub fn and(self, other: Signs) -> Signs {
        Signs(self.0 & other.0)
    }

    /// The signs that either admits.
    #[must_use]
    pub fn or(self, other: Signs) -> Signs {
        Signs(self.0 | other.0)
    }

    /// The signs of the negated number.
    #[must_use]
    pub fn reversed(self) -> Signs {
        Signs(self.0 & 2 | (self.0 & 1) << 2 | (self.0 & 4) >> 2)
    }

    /// The signs of a product.
    #[must_use]
    pub fn times(self, other: Signs) -> Signs {
        let mut product = Signs::NONE;
        if self.admits(Signs::ZERO) && other != Signs::NONE {
            product = Signs::ZERO;
        }
        if self.admits(Signs::POSITIVE) {
            product = product.or(other);
        }
        if self.admits(Signs::NEGATIVE) {
            product = product.or(other.reversed());
        }
        product
    }

    /// The signs of a sum.
    #[must_use]
    pub fn plus(self, other: Signs) -> Signs {
        let both = self.or(other);
        match () {
            () if self == Signs::NONE || other == Signs::NONE => Signs::NONE,
            () if self == Signs::ZERO => other,
            () if other == Signs::ZERO => self,
            () if both.admits(Signs::POSITIVE) && both.admits(Signs::NEGATIVE) => Signs::ANY,
            // One that is not zero is enough.
            () if self.excludes_zero() || other.excludes_zero() => both.and(Signs::NOT_ZERO),
            () => both,
        }
    }

    /// Whether one of these signs is possible.
    pub fn admits(self, signs: Signs) -> bool {
        self.0 & signs.0 != 0
    }

    /// Whether only these signs are possible.
    pub fn within(self, signs: Signs) -> bool {
        self.0 & !signs.0 == 0
    }

    /// Whether it cannot be zero.
    pub fn excludes_zero(self) -> bool {
        !self.admits(Signs::ZERO)
    }

    /// The sign, where there is one only.
    pub fn only(self) -> Option<Ordering> {
        match self {
            Signs::NEGATIVE => Some(Ordering::Less),
            Signs::ZERO => Some(Ordering::Equal),
            Signs::POSITIVE => Some(Ordering::Greater),
            _ => None,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const ALL: [Signs; 8] = [
        Signs::NONE,
        Signs::NEGATIVE,
        Signs::ZERO,
        Signs::NOT_POSITIVE,
        Signs::POSITIVE,
        Signs::NOT_ZERO,
        Signs::NOT_NEGATIVE,
        Signs::ANY,
    ];

    /// The numbers -1, 0, 1 with a sign of these.
    fn numbers(signs: Signs) -> Vec<i32> {
        (-1..=1)
            .filter(|n: &i32| signs.admits(Signs::of(n.cmp(&0))))
            .collect()
    }

    fn signs(numbers: impl IntoIterator<Item = i32>) -> Signs {
        numbers
            .into_iter()
            .fold(Signs::NONE, |s, n| s.or(Signs::of(n.cmp(&0))))
    }

    #[test]
    fn operations_are_those_of_the_numbers() {
        for a in ALL {
            assert_eq!(signs(numbers(a)), a);
            assert_eq!(a.reversed(), signs(numbers(a).iter().map(|n| -n)));
            for b in ALL {
                let products = numbers(a)
                    .into_iter()
                    .flat_map(|x| numbers(b).into_iter().map(move |y| x * y));
                assert_eq!(a.times(b), signs(products), "{a:?} {b:?}");
                // With moduli 1 and 2 every sign of a sum is met.
                let sizes = |s| numbers(s).into_iter().flat_map(|n| [n, 2 * n]);
                let sums = sizes(a).flat_map(|x| sizes(b).map(move |y| (x + y).signum()));
                assert_eq!(a.plus(b), signs(sums), "{a:?} {b:?}");
            }
        }
    }
}
