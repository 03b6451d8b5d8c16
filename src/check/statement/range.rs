//! The least and the largest value of a rational function over a closed box, exactly.
//!
//! A letter in which the function is monotone on the box is moved to the end of its side; what is
//! left of one letter is decided by the real roots of its derivative. Where that does not reach,
//! a vertex is an extreme value if the sign of the difference to it says so.

use super::Ground;
use crate::theory::algebraic::Algebraic;
use crate::verdict::statement::{Scope, Sign};
use num_rational::BigRational;
use ratpoly::{Budget, RationalFunction};

/// A letter with its least and largest value.
type Side = (usize, BigRational, BigRational);

impl Ground {
    /// The range of a function over a box; none where it is out of reach.
    pub(in crate::check) fn range(
        &self,
        f: &RationalFunction,
        scope: &Scope,
    ) -> Option<(Algebraic, Algebraic)> {
        let Scope::Box(sides) = scope else {
            return None;
        };
        let kept: Vec<usize> = sides.iter().map(|(letter, ..)| *letter).collect();
        let f = self.restricted(f, &kept)?;
        // Without poles.
        let denominator = RationalFunction::from(f.denominator().clone());
        match self.sign(&denominator, scope).sign {
            Some(Sign::Positive | Sign::Negative) => {}
            _ => return None,
        }
        Some((
            self.extreme(&f, sides, false)?,
            self.extreme(&f, sides, true)?,
        ))
    }

    fn extreme(&self, f: &RationalFunction, sides: &[Side], largest: bool) -> Option<Algebraic> {
        if let Some(value) = f.as_constant() {
            return Some(value.into());
        }
        let occurring = self.letters_in(f);
        let sides: Vec<Side> = sides
            .iter()
            .filter(|(letter, ..)| occurring.contains(letter))
            .cloned()
            .collect();
        let scope = Scope::Box(sides.clone());
        for (letter, low, high) in &sides {
            let rising = match self.sign(&f.derivative(*letter).ok()?, &scope).sign {
                Some(Sign::Positive | Sign::NonNegative) => true,
                Some(Sign::Negative | Sign::NonPositive) => false,
                _ => continue,
            };
            let end = if rising == largest { high } else { low };
            return self.extreme(&self.with(f, *letter, end)?, &sides, largest);
        }
        if let [(letter, low, high)] = &sides[..] {
            return self.extreme_on_side(f, *letter, low, high, largest);
        }
        self.extreme_vertex(f, &sides, largest)
    }

    fn with(
        &self,
        f: &RationalFunction,
        letter: usize,
        value: &BigRational,
    ) -> Option<RationalFunction> {
        let value = RationalFunction::constant(self.ring, value.clone());
        f.substitute(&[(letter, value)]).ok()
    }

    /// One letter: the ends, and the roots of the derivative between them.
    fn extreme_on_side(
        &self,
        f: &RationalFunction,
        letter: usize,
        low: &BigRational,
        high: &BigRational,
        largest: bool,
    ) -> Option<Algebraic> {
        let budget = Budget::default();
        let derivative = f.derivative(letter).ok()?;
        let mut best: Option<Algebraic> = None;
        let inner = Algebraic::roots(derivative.numerator(), letter, &budget).ok()?;
        let inner = inner
            .into_iter()
            .filter(|r| r.compare_rational(low).is_gt() && r.compare_rational(high).is_lt());
        for place in [low.clone().into(), high.clone().into()]
            .into_iter()
            .chain(inner)
        {
            let value = Algebraic::evaluate(f, &[(letter, place)], &budget).ok()?;
            let better = best.as_ref().is_none_or(|b| {
                let order = value.compare(b);
                if largest {
                    order.is_gt()
                } else {
                    order.is_lt()
                }
            });
            if better {
                best = Some(value);
            }
        }
        best
    }

    fn extreme_vertex(
        &self,
        f: &RationalFunction,
        sides: &[Side],
        largest: bool,
    ) -> Option<Algebraic> {
        let mut best: Option<BigRational> = None;
        for corner in 0..1_usize << sides.len() {
            let mut value = f.clone();
            for (k, (letter, low, high)) in sides.iter().enumerate() {
                let end = if corner >> k & 1 == 1 { high } else { low };
                value = self.with(&value, *letter, end)?;
            }
            let value = value.as_constant()?;
            if best
                .as_ref()
                .is_none_or(|b| (value > *b) == largest && value != *b)
            {
                best = Some(value);
            }
        }
        let best = best?;
        let difference = f.clone() - RationalFunction::constant(self.ring, best.clone());
        let sign = self.sign(&difference, &Scope::Box(sides.to_vec())).sign?;
        let outermost = match sign {
            Sign::Negative | Sign::NonPositive => largest,
            Sign::Positive | Sign::NonNegative => !largest,
            _ => return None,
        };
        outermost.then(|| best.into())
    }
}
