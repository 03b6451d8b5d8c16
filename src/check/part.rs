//! Where an equation that is false in general is true: `|x| = x` for x ≥ 0.
//!
//! Each root of a square is `s` where `s ≥ 0` and `-s` elsewhere. With one choice of all signs put in
//! for the roots, the sides either agree as formulas or they do not; where they do, the equation holds
//! on the part of its domain that has these signs.

use super::Checker;
use super::identity::insert;
use crate::functions::{FunctionLetter, square_root_of};
use crate::verdict::{Part, ResidualEntry, SignCondition, Witness};
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::Signed;
use ratpoly::{Polynomial, RationalFunction};
use std::collections::BTreeSet;

/// More roots of squares than these are not looked at: their signs have too many combinations.
const ROOTS: usize = 4;
/// How many points are tried for one on the part, and for one beside it.
const POINTS: usize = 300;

impl Checker<'_> {
    /// The part on which a link holds that is false in general, with a point beside it where the
    /// sides differ; none where there is no such part.
    pub(super) fn part(&self, entries: &[ResidualEntry]) -> Option<(Part, Witness)> {
        let table = self.functions()?;
        let open: Vec<&ResidualEntry> = entries.iter().filter(|e| e.left != e.right).collect();
        let all = self.insertion(&self.inserted.keys().copied().collect::<Vec<_>>());
        let expanded = insert(&open, &all, Some(table)).ok()?;
        let letters: BTreeSet<usize> = expanded
            .iter()
            .flat_map(|e| [&e.left, &e.right])
            .flat_map(|side| table.letters_behind(side))
            .collect();
        let mut roots: Vec<(usize, Polynomial)> = letters
            .iter()
            .copied()
            .filter_map(|letter| match table.meaning(letter)? {
                FunctionLetter::Root(square) => Some((letter, square_root_of(&square)?)),
                _ => None,
            })
            .collect();
        // The letters of functions are numbered as they are met; the declared ones are not.
        roots.sort_by_key(|(_, s)| s.variables_occurring());
        if roots.is_empty() || roots.len() > ROOTS {
            return None;
        }
        let holds = |signs: usize| {
            let images: Vec<(usize, RationalFunction)> = roots
                .iter()
                .enumerate()
                .map(|(k, (letter, s))| {
                    let s = RationalFunction::from(s.clone());
                    (*letter, if signs >> k & 1 == 0 { s } else { -&s })
                })
                .collect();
            expanded.iter().all(|e| {
                let difference = e.difference().substitute(&images);
                difference.is_ok_and(|d| {
                    d.is_zero() || table.substitute(&d, &[]).is_ok_and(|d| d.is_zero())
                })
            })
        };
        let held: Vec<usize> = (0..1 << roots.len())
            .filter(|signs| holds(*signs))
            .collect();
        // A root whose sign does not matter is not named.
        let matters: Vec<usize> = (0..roots.len())
            .filter(|k| held.iter().any(|signs| !held.contains(&(signs ^ 1 << k))))
            .collect();
        let points: Vec<Vec<BigRational>> = match self.supposed.in_force {
            true => self
                .admitted_points(&letters)
                .map(|point| point.into_iter().map(Option::unwrap_or_default).collect())
                .collect(),
            false => self.points().collect(),
        };
        let mut choices: Vec<Vec<SignCondition>> = Vec::new();
        for signs in held {
            let reached = points.iter().any(|point| {
                matters.iter().all(|k| {
                    let value = RationalFunction::from(roots[*k].1.clone()).evaluate(point);
                    value.is_ok_and(|v| {
                        if signs >> k & 1 == 0 {
                            v.is_positive()
                        } else {
                            v.is_negative()
                        }
                    })
                })
            });
            let conditions: Vec<SignCondition> = matters
                .iter()
                .map(|k| SignCondition {
                    function: roots[*k].1.clone(),
                    negative: signs >> k & 1 == 1,
                })
                .collect();
            if reached && !conditions.is_empty() && !choices.contains(&conditions) {
                choices.push(conditions);
            }
        }
        if choices.is_empty() {
            return None;
        }
        let witness = expanded.iter().find_map(|entry| {
            points
                .iter()
                .find_map(|point| self.witness_at(entry, |letter, _| point[letter].clone()))
        })?;
        Some((Part::Signs(choices), witness))
    }

    /// Points of the declared letters, the reference point first: small fractions of either sign.
    fn points(&self) -> impl Iterator<Item = Vec<BigRational>> + '_ {
        let sizes = [
            (1, 1),
            (1, 2),
            (2, 1),
            (1, 3),
            (3, 1),
            (1, 5),
            (5, 1),
            (1, 20),
            (20, 1),
            (1, 1000),
            (1000, 1),
        ];
        let at = move |k: usize| -> Vec<BigRational> {
            (0..self.model.letters.len())
                .map(|letter| {
                    let (above, below) =
                        sizes[(k * (2 * letter + 1) + k / 11 * letter) % sizes.len()];
                    let size = BigRational::new(BigInt::from(above), BigInt::from(below));
                    let flipped = !self.model.is_positive(letter) && (k >> (letter % 7)) & 1 == 1;
                    let value = if flipped { -size } else { size };
                    match self.supposed.admitted.ranges.get(letter) {
                        Some(range) if !range.contains(&value) => range.sample(k),
                        _ => value,
                    }
                })
                .collect()
        };
        std::iter::once(self.reference_point()).chain((0..POINTS).map(at))
    }
}
