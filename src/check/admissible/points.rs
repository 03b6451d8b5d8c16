//! Admissible points, and what a function certainly is at one of them.

use super::Admissible;
use crate::model::range::{Numbers, Range};
use crate::verdict::PointValue;
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Zero};
use ratpoly::RationalFunction;

/// How many points are looked at, and how many where functions have to be enclosed.
const POINTS: usize = 400;
const ENCLOSED: usize = 10;
/// Sizes of the coordinates, the nearest to one first.
const SIZES: [(i64, i64); 13] = [
    (1, 1),
    (2, 1),
    (1, 2),
    (3, 1),
    (1, 3),
    (3, 2),
    (5, 1),
    (1, 5),
    (10, 1),
    (1, 10),
    (100, 1),
    (1, 100),
    (1000, 1),
];

impl Admissible {
    /// What the value of a function at a point certainly is; none where it has no value there, or none
    /// that is enclosed.
    pub(crate) fn certain(
        &self,
        f: &RationalFunction,
        point: &[Option<BigRational>],
    ) -> Option<PointValue> {
        let Some(table) = &self.table else {
            let known = |v: &Option<BigRational>| v.clone().unwrap_or_else(BigRational::zero);
            let point: Vec<BigRational> = point.iter().map(known).collect();
            return f.evaluate(&point).ok().map(PointValue::Exact);
        };
        // A function of a letter without a value, such as i, has none either.
        if let Some(value) = table.rational_value(f, point) {
            return Some(PointValue::Exact(value));
        }
        let interval = table.enclosure(f, point)?;
        Some(PointValue::Between(interval.low, interval.high))
    }

    /// Whether a function certainly is not zero at a point.
    pub(crate) fn is_apart_from_zero(
        &self,
        f: &RationalFunction,
        point: &[Option<BigRational>],
    ) -> bool {
        let zero = PointValue::Exact(BigRational::zero());
        let value = self.certain(f, point);
        value.is_some_and(|value| value.is_apart_from(&zero))
    }

    /// Admissible points: values for all letters but those that stand for functions. The reference
    /// point comes first, where it is complete.
    pub(crate) fn points(
        &self,
        f: &RationalFunction,
    ) -> impl Iterator<Item = Vec<Option<BigRational>>> + '_ {
        let letters = match &self.table {
            Some(table) => table.letters_behind(f),
            None => crate::check::identity::letters_of([f]),
        };
        let is_function = |l: usize| {
            let table = self.table.as_ref();
            table.is_some_and(|table| table.meaning(l).is_some())
        };
        let mut letters: Vec<usize> = letters.into_iter().filter(|l| !is_function(*l)).collect();
        // Of a matrix all entries have to be known.
        for matrix in &self.matrices {
            if matrix.iter().any(|l| letters.contains(l)) {
                letters.extend(matrix);
            }
        }
        letters.sort_unstable();
        letters.dedup();
        let possible = letters
            .iter()
            .all(|l| self.ranges[*l].numbers != Numbers::Complex);
        let tries = match (possible, self.has_functions(f)) {
            _ if self.in_force => 0,
            (true, false) => POINTS,
            (true, true) => ENCLOSED,
            (false, _) => 0,
        };
        (0..tries).filter_map(move |k| {
            let mut drawn = vec![BigRational::zero(); self.ring.len()];
            for (position, letter) in letters.iter().enumerate() {
                drawn[*letter] = match (k, &self.reference[*letter]) {
                    (0, Some(own)) => own.clone(),
                    _ => self.drawn(*letter, position, k)?,
                };
            }
            let back = self.back(drawn);
            let mut point = vec![None; self.ring.len()];
            for letter in &letters {
                point[*letter] = Some(back[*letter].clone());
            }
            Some(point)
        })
    }

    /// The same for functions of the declared letters alone.
    pub(super) fn full_points(
        &self,
        f: &RationalFunction,
    ) -> impl Iterator<Item = Vec<BigRational>> + '_ {
        let known = |v: Option<BigRational>| v.unwrap_or_else(BigRational::zero);
        self.points(f)
            .map(move |point| point.into_iter().map(known).collect())
    }

    /// A value for a letter in the k-th point.
    fn drawn(&self, letter: usize, position: usize, k: usize) -> Option<BigRational> {
        // Neighbouring letters run through the sizes at different speeds.
        let step = k * (2 * position + 1) + k / SIZES.len() * position;
        let (above, below) = SIZES[step % SIZES.len()];
        let size = BigRational::new(BigInt::from(above), BigInt::from(below));
        let negative = (k >> (position % 6)) & 1 == 1;
        value_in(&self.ranges[letter], size, negative, k)
    }

    /// The letters of a point of the box, the entries of definite matrices in place of those of L.
    pub(super) fn back(&self, point: Vec<BigRational>) -> Vec<BigRational> {
        let mut back = point.clone();
        for (entry, product) in &self.entries {
            if let Ok(value) = product.evaluate(&point) {
                back[*entry] = value;
            }
        }
        back
    }

    /// Whether the letters of a function lie in their ranges; entries of definite matrices do wherever
    /// they come from a point of the box.
    pub(super) fn is_admissible(&self, f: &RationalFunction, point: &[BigRational]) -> bool {
        crate::check::identity::letters_of([f])
            .into_iter()
            .filter(|l| !self.matrices.iter().any(|m| m.contains(l)))
            .all(|l| self.ranges[l].contains(&point[l]))
    }
}

/// A number of a range, near one of its ends or far away.
fn value_in(range: &Range, size: BigRational, negative: bool, k: usize) -> Option<BigRational> {
    let one = BigRational::one();
    let value = match (&range.low, &range.high) {
        (Some(low), Some(high)) => {
            // The ends themselves now and then, where they belong to it.
            match k % 7 {
                5 if low.included => low.value.clone(),
                6 if high.included => high.value.clone(),
                _ => {
                    let part = &size / (&one + &size);
                    &low.value + (&high.value - &low.value) * part
                }
            }
        }
        (Some(low), None) if k % 7 == 5 && low.included => low.value.clone(),
        (Some(low), None) => &low.value + size,
        (None, Some(high)) if k % 7 == 5 && high.included => high.value.clone(),
        (None, Some(high)) => &high.value - size,
        (None, None) if k % 11 == 7 => BigRational::zero(),
        (None, None) if negative => -size,
        (None, None) => size,
    };
    let value = match range.numbers {
        Numbers::Integer => value.round(),
        Numbers::Real | Numbers::Complex => value,
    };
    range.contains(&value).then_some(value)
}
