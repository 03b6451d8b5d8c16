//! What another value of a letter than the best one costs.
//!
//! How far it is from the best one, and by how much the quantity is larger (smaller) there, relatively to
//! the modulus of its extreme value: real algebraic numbers, at the reference values of the other letters.

use super::Ground;
use super::sign::SignStudy;
use crate::theory::algebraic::Algebraic;
use crate::verdict::statement::{Scope, Sign};
use num_rational::BigRational;
use num_traits::Zero;
use ratpoly::{Budget, RationalFunction, Ring};
use std::cmp::Ordering;

impl Ground {
    /// The quantity at a letter's value over the quantity at another, the other letters as in the
    /// reference; letters without a reference value may cancel.
    pub(super) fn quotient_at(
        &self,
        f: &RationalFunction,
        x: usize,
        above: &Algebraic,
        below: &Algebraic,
    ) -> Option<Algebraic> {
        let budget = Budget::default();
        // A second name for the letter.
        let mut names = self.ring.variables().to_vec();
        let mut spare = "elsewhere".to_string();
        while names.contains(&spare) {
            spare.push('_');
        }
        names.push(spare);
        let wide = Ring::new(names, self.ring.order()).ok()?;
        let y = self.reference.len();
        let known = self.letters_in(f).into_iter().filter(|l| *l != x);
        let images: Vec<(usize, RationalFunction)> = known
            .filter_map(|l| {
                let own = self.reference[l].clone()?;
                Some((l, RationalFunction::constant(self.ring, own)))
            })
            .collect();
        let f = f.substitute(&images).ok()?.to_ring(wide).ok()?;
        let renamed = f
            .substitute(&[(x, RationalFunction::variable(wide, y))])
            .ok()?;
        let quotient = f.checked_div(&renamed).ok()?;
        Algebraic::evaluate(
            &quotient,
            &[(x, above.clone()), (y, below.clone())],
            &budget,
        )
        .ok()
    }

    /// How far a value of the letter is from the extremum, relatively, and what that costs in terms of
    /// the modulus of the extreme value; each as far as it can be said.
    pub(super) fn distance_and_loss(
        &self,
        f: &RationalFunction,
        x: usize,
        value: &Algebraic,
        place: &Algebraic,
    ) -> (Option<Algebraic>, Option<Algebraic>) {
        let budget = Budget::default();
        let less_one = |q: Algebraic| q.less_one(&budget).ok();
        let distance = match place.as_rational() {
            Some(zero) if zero.is_zero() => None,
            _ => value.divided_by(place, &budget).ok().and_then(less_one),
        };
        (distance, self.relative_excess(f, x, value, place))
    }

    /// The quantity at a value of the letter, less that at another one, over the modulus of that; none
    /// where that is zero or its sign is not known.
    pub(super) fn relative_excess(
        &self,
        f: &RationalFunction,
        x: usize,
        above: &Algebraic,
        below: &Algebraic,
    ) -> Option<Algebraic> {
        let budget = Budget::default();
        let own = match self.restricted(f, &[x]) {
            Some(line) => {
                let value = self.value_at_place(&line, x, below)?;
                value.compare_rational(&BigRational::zero())
            }
            None => match self.sign(f, &Scope::Everywhere) {
                SignStudy {
                    sign: Some(Sign::Positive),
                    ..
                } => Ordering::Greater,
                SignStudy {
                    sign: Some(Sign::Negative),
                    ..
                } => Ordering::Less,
                _ => return None,
            },
        };
        let excess = self
            .quotient_at(f, x, above, below)?
            .less_one(&budget)
            .ok()?;
        match own {
            Ordering::Greater => Some(excess),
            Ordering::Equal => None,
            Ordering::Less => {
                let ring = Ring::new(["x"], self.ring.order()).ok()?;
                let minus = -RationalFunction::variable(ring, 0);
                Algebraic::evaluate(&minus, &[(0, excess)], &budget).ok()
            }
        }
    }
}
