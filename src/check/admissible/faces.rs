//! The sign of a polynomial on a box whose faces belong to it or not.
//!
//! Inside, the polynomial engine decides. A sign that is not strict goes over to the closure, for
//! polynomials are continuous; a strict one is asked for on every face that belongs to the box.

use crate::model::range::{End, Numbers, Range};
use num_rational::BigRational;
use num_traits::{One, Zero};
use ratpoly::{Bound, Budget, Polynomial, RationalFunction, Region, RegionSign, sign_on};

/// Boxes with more closed faces than this are not looked at face by face.
const FACES: usize = 6;

/// The same numbers with ends that are taken: an end of a range of integers is an integer.
pub(super) fn tightened(range: &Range) -> Range {
    let mut range = range.clone();
    if range.numbers == Numbers::Integer {
        let one = BigRational::one();
        if let Some(End { value, included }) = &mut range.low {
            let whole = value.ceil();
            *value = if whole == *value && !*included {
                whole + &one
            } else {
                whole
            };
            *included = true;
        }
        if let Some(End { value, included }) = &mut range.high {
            let whole = value.floor();
            *value = if whole == *value && !*included {
                whole - &one
            } else {
                whole
            };
            *included = true;
        }
    }
    range
}

/// The sign on the product of the ranges, each of the letters that occur being one of real numbers.
pub(crate) fn sign_within(f: &Polynomial, ranges: &[Range], budget: &Budget) -> RegionSign {
    if f.is_zero() {
        return RegionSign::Zero;
    }
    let mut f = f.clone();
    let mut values = Vec::new();
    for letter in f.variables_occurring() {
        let range = &ranges[letter];
        if range.numbers == Numbers::Complex || range.is_empty() {
            return RegionSign::Undecided;
        }
        if let (Some(low), Some(high)) = (&range.low, &range.high)
            && low.value == high.value
        {
            values.push((letter, low.value.clone()));
        }
    }
    for (letter, value) in &values {
        let Some(there) = at(&f, *letter, value) else {
            return RegionSign::Undecided;
        };
        f = there;
    }
    let sign = on_open_and_closed(&f, ranges, budget);
    match sign {
        RegionSign::Changes {
            mut positive,
            mut negative,
        } => {
            for (letter, value) in values {
                positive[letter].clone_from(&value);
                negative[letter] = value;
            }
            RegionSign::Changes { positive, negative }
        }
        other => other,
    }
}

fn on_open_and_closed(f: &Polynomial, ranges: &[Range], budget: &Budget) -> RegionSign {
    if f.is_zero() {
        return RegionSign::Zero;
    }
    let inside = on_open(f, ranges, budget);
    if !matches!(inside, RegionSign::Positive | RegionSign::Negative) {
        return inside;
    }
    let weak = match inside {
        RegionSign::Positive => RegionSign::NonNegative,
        _ => RegionSign::NonPositive,
    };
    let mut faces = Vec::new();
    for letter in f.variables_occurring() {
        for end in [&ranges[letter].low, &ranges[letter].high]
            .into_iter()
            .flatten()
        {
            if end.included {
                faces.push((letter, end.value.clone()));
            }
        }
    }
    if faces.len() > FACES {
        return weak;
    }
    // Each face with those faces of the others only that were not looked at yet.
    let mut open = ranges.to_vec();
    for (letter, value) in faces {
        let Some(face) = at(f, letter, &value) else {
            return weak;
        };
        let Range { low, high, .. } = &mut open[letter];
        for end in [low, high].into_iter().flatten() {
            end.included &= end.value != value;
        }
        if sign_within(&face, &open, budget) != inside {
            return weak;
        }
    }
    inside
}

fn on_open(f: &Polynomial, ranges: &[Range], budget: &Budget) -> RegionSign {
    let occurring = f.variables_occurring();
    let bound = |end: &Option<End>, infinite: Bound| match end {
        Some(end) => Bound::Finite(end.value.clone()),
        None => infinite,
    };
    let intervals: Vec<(Bound, Bound)> = ranges
        .iter()
        .enumerate()
        .map(|(letter, range)| match occurring.contains(&letter) {
            true => (
                bound(&range.low, Bound::NegativeInfinity),
                bound(&range.high, Bound::PositiveInfinity),
            ),
            false => (Bound::from(0), Bound::PositiveInfinity),
        })
        .collect();
    Region::new(intervals)
        .and_then(|region| sign_on(f, &region, budget))
        .unwrap_or(RegionSign::Undecided)
}

/// A positive multiple of the polynomial where a letter has a value.
fn at(f: &Polynomial, letter: usize, value: &BigRational) -> Option<Polynomial> {
    let value = RationalFunction::constant(f.ring(), value.clone());
    let there = RationalFunction::from(f.clone())
        .substitute(&[(letter, value)])
        .ok()?;
    let denominator = there.denominator().as_constant()?;
    (denominator > num_bigint::BigInt::zero()).then(|| there.numerator().clone())
}

#[cfg(test)]
mod tests {
    use super::*;
    use ratpoly::{Order, Ring};

    fn sign(text: &str, ends: [(i64, bool); 2]) -> RegionSign {
        let ring = Ring::new(["x", "y"], Order::Lex).unwrap();
        let mut range = Range::default();
        let number = |n: i64| BigRational::from_integer(n.into());
        range.raise(number(ends[0].0), ends[0].1);
        range.lower(number(ends[1].0), ends[1].1);
        let f = Polynomial::parse(ring, text).unwrap();
        sign_within(&f, &[range.clone(), range], &Budget::default())
    }

    #[test]
    fn a_face_counts_where_it_belongs_to_the_box() {
        let open = [(0, false), (2, false)];
        let half = [(0, true), (2, false)];
        assert_eq!(sign("x", open), RegionSign::Positive);
        assert_eq!(sign("x", half), RegionSign::NonNegative);
        assert_eq!(sign("x + 1", half), RegionSign::Positive);
        assert_eq!(sign("x + y", half), RegionSign::NonNegative);
        assert_eq!(sign("x + y - x*y", open), RegionSign::Positive);
        assert_eq!(
            sign("x + y - x*y", [(0, true), (2, true)]),
            RegionSign::NonNegative
        );
        assert_eq!(sign("x - 2", [(2, true), (2, true)]), RegionSign::Zero);
        assert!(matches!(sign("x - 1", half), RegionSign::Changes { .. }));
    }

    #[test]
    fn integers_have_ends_that_they_take() {
        let mut range = Range {
            numbers: Numbers::Integer,
            ..Range::default()
        };
        range.raise(BigRational::zero(), false);
        let low = tightened(&range).low.unwrap();
        assert!(low.included && low.value.is_one());
    }
}
