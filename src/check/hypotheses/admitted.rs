//! Which values of the letters are admitted, and which signs polynomials have there.
//!
//! Each letter has a [`Range`]; beside these some polynomials are supposed to have a sign, such as
//! b - a where a < b. The sign of a polynomial is decided on the box of the ranges, its faces
//! included where the ends belong to them; then by the suppositions: the polynomial may be one of
//! them, or a letter in which a supposition is linear is replaced by the supposed difference, whose
//! range is a half-line. Whatever is said is proved: a set of signs is only ever too large.

use super::possible::Signs;
use crate::model::range::{End, Numbers, Range};
use num_rational::BigRational;
use num_traits::{One, Signed, Zero};
use ratpoly::{Bound, Budget, Polynomial, RationalFunction, Region, sign_on};

/// Faces of a box in more dimensions than this are not looked at one by one.
const FACES: usize = 4;
/// How many suppositions are used at once, how many there may be, and for polynomials of how many terms.
const DEPTH: usize = 3;
const MOST: usize = 12;
const LONG: usize = 40;

/// The admitted values of the letters of a ring.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Admitted {
    /// Which numbers each letter stands for.
    pub ranges: Vec<Range>,
    /// Polynomials with the signs that they are supposed to have.
    pub signs: Vec<(Polynomial, Signs)>,
}

impl Admitted {
    /// These ranges and nothing beside them.
    pub fn within(ranges: Vec<Range>) -> Self {
        Admitted {
            ranges,
            signs: Vec::new(),
        }
    }

    /// Supposes a sign: of a letter beside a number it is an end of its range.
    pub fn suppose(&mut self, p: &Polynomial, signs: Signs) {
        if let Some((letter, at, rising)) = single_letter(p)
            && self.ranges.len() > letter
        {
            let signs = if rising { signs } else { signs.reversed() };
            let range = &mut self.ranges[letter];
            if !signs.admits(Signs::NEGATIVE) {
                range.raise(at.clone(), signs.admits(Signs::ZERO));
            }
            if !signs.admits(Signs::POSITIVE) {
                range.lower(at.clone(), signs.admits(Signs::ZERO));
            }
            if signs != Signs::NOT_ZERO {
                return;
            }
        }
        let (p, flipped) = normal(p);
        let signs = if flipped { signs.reversed() } else { signs };
        match self.signs.iter_mut().find(|(known, _)| *known == p) {
            Some((_, known)) => *known = known.and(signs),
            None => self.signs.push((p, signs)),
        }
    }

    /// The signs that a polynomial may have; `others` are the ranges of letters beyond those here.
    pub fn signs_of(
        &self,
        p: &Polynomial,
        others: &dyn Fn(usize) -> Range,
        budget: &Budget,
    ) -> Signs {
        let range = |letter: usize| match self.ranges.get(letter) {
            Some(range) => range.clone(),
            None => others(letter),
        };
        let occurring = p.variables_occurring();
        let mut ranges: Vec<Range> = vec![Range::default(); p.ring().len()];
        for letter in &occurring {
            ranges[*letter] = range(*letter);
            if ranges[*letter].numbers == Numbers::Complex {
                return Signs::ANY;
            }
        }
        let mut found = on_box(p, &ranges, budget);
        if found.only().is_some() || self.signs.is_empty() {
            return found;
        }
        let (q, flipped) = normal(p);
        for (known, signs) in &self.signs {
            if *known == q {
                found = found.and(if flipped { signs.reversed() } else { *signs });
            }
        }
        if found.only().is_none() && self.signs.len() <= MOST && p.len() <= LONG {
            for (known, _) in &self.signs {
                for letter in known.variables_occurring() {
                    ranges[letter] = range(letter);
                }
            }
            found = found.and(by_sums(p, &ranges, &self.signs, budget));
            let shifted = by_suppositions(p, &ranges, &self.signs, DEPTH, budget);
            found = found.and(shifted);
        }
        found
    }

    /// Whether what is admitted is seen to be nothing: a range is empty, or a supposition contradicts the
    /// others.
    pub fn is_empty(&self, others: &dyn Fn(usize) -> Range, budget: &Budget) -> bool {
        self.ranges.iter().any(Range::is_empty)
            || (0..self.signs.len()).any(|k| {
                let mut rest = self.clone();
                let (p, signs) = rest.signs.remove(k);
                rest.signs_of(&p, others, budget).and(signs) == Signs::NONE
            })
    }
}

/// The primitive polynomial with a positive leading coefficient, and whether it has the other sign.
fn normal(p: &Polynomial) -> (Polynomial, bool) {
    let flipped = p.leading_coefficient().is_negative();
    (p.primitive_part().unit_normal(), flipped)
}

/// The letter x and the number c where the polynomial is a multiple of x - c, and whether a positive one.
fn single_letter(p: &Polynomial) -> Option<(usize, BigRational, bool)> {
    let [letter] = p.variables_occurring()[..] else {
        return None;
    };
    let coefficients = p.coefficients_in(letter);
    let [constant, slope] = coefficients.as_slice() else {
        return None;
    };
    let slope = slope.as_constant()?;
    let rising = slope.is_positive();
    Some((
        letter,
        BigRational::new(-constant.as_constant()?, slope),
        rising,
    ))
}

/// The signs on the box of the ranges.
fn on_box(p: &Polynomial, ranges: &[Range], budget: &Budget) -> Signs {
    let mut p = p.clone();
    let mut faces: Vec<(usize, BigRational)> = Vec::new();
    for letter in p.variables_occurring() {
        let range = ranges[letter].tightened();
        if range.is_empty() {
            return Signs::NONE;
        }
        if let Some(value) = range.single() {
            let Some(there) = at(&p, letter, value) else {
                return Signs::ANY;
            };
            p = there;
            continue;
        }
        for end in [range.low, range.high].into_iter().flatten() {
            if end.included {
                faces.push((letter, end.value));
            }
        }
    }
    if let Some(number) = p.as_constant() {
        return Signs::of(number.cmp(&num_bigint::BigInt::zero()));
    }
    let occurring = p.variables_occurring();
    faces.retain(|(letter, _)| occurring.contains(letter));
    let mut found = inside(&p, ranges, budget);
    if found == Signs::ANY {
        return found;
    }
    if faces.len() > FACES {
        // A continuous function has no sign on the closure that it has not inside, but zero.
        return found.or(Signs::ZERO);
    }
    // Each face with the others of the letters after it, so that none is looked at twice.
    let mut open: Vec<Range> = ranges.to_vec();
    for (letter, value) in faces {
        let Some(face) = at(&p, letter, &value) else {
            return Signs::ANY;
        };
        let mut rest = open[letter].tightened();
        for end in [&mut rest.low, &mut rest.high].into_iter().flatten() {
            if end.value == value {
                end.included = false;
            }
        }
        open[letter] = rest;
        found = found.or(on_box(&face, &open, budget));
        if found == Signs::ANY {
            break;
        }
    }
    found
}

/// The signs inside of the box, where no letter is at an end of its range.
fn inside(p: &Polynomial, ranges: &[Range], budget: &Budget) -> Signs {
    let mut terms = p.terms().map(|(_, c)| c.is_positive());
    let first = terms.next();
    let alike = terms.all(|s| Some(s) == first);
    let occurring = p.variables_occurring();
    let above_zero = |l: &usize| {
        let low = ranges[*l].low.as_ref();
        low.is_some_and(|low| !low.value.is_negative())
    };
    if alike && occurring.iter().all(above_zero) {
        return match first {
            Some(true) => Signs::POSITIVE,
            _ => Signs::NEGATIVE,
        };
    }
    let bound = |end: &Option<End>, infinite: Bound| match end {
        Some(end) => Bound::Finite(end.value.clone()),
        None => infinite,
    };
    let intervals: Vec<(Bound, Bound)> = ranges
        .iter()
        .enumerate()
        .map(|(letter, range)| {
            if !occurring.contains(&letter) {
                return (Bound::from(0), Bound::PositiveInfinity);
            }
            let range = range.tightened();
            (
                bound(&range.low, Bound::NegativeInfinity),
                bound(&range.high, Bound::PositiveInfinity),
            )
        })
        .collect();
    Region::new(intervals)
        .and_then(|region| sign_on(p, &region, budget))
        .map_or(Signs::ANY, |sign| Signs::of_region(&sign))
}

/// The signs of sums of a supposed polynomial times a number and a rest whose sign is known on the box:
/// the number is one with which a term of both cancels.
fn by_sums(
    p: &Polynomial,
    ranges: &[Range],
    supposed: &[(Polynomial, Signs)],
    budget: &Budget,
) -> Signs {
    let mut found = Signs::ANY;
    for (known, signs) in supposed {
        for (monomial, coefficient) in known.terms() {
            let own = p.coefficient(monomial.exponents());
            if own.is_zero() || found.only().is_some() {
                continue;
            }
            // c p = o q + r: the signs of o q and r, turned where c is negative.
            let rest = &p.mul_integer(&coefficient) - &known.mul_integer(&own);
            let part = match own.is_negative() {
                true => signs.reversed(),
                false => *signs,
            };
            let sum = part.plus(on_box(&rest, ranges, budget));
            found = found.and(match coefficient.is_negative() {
                true => sum.reversed(),
                false => sum,
            });
        }
    }
    found
}

/// The signs that follow from suppositions: t stands for a supposed polynomial in place of a letter in
/// which that is linear, and has the supposed sign; what is known of the letter itself is left out.
fn by_suppositions(
    p: &Polynomial,
    ranges: &[Range],
    supposed: &[(Polynomial, Signs)],
    depth: usize,
    budget: &Budget,
) -> Signs {
    let mut found = Signs::ANY;
    if depth == 0 {
        return found;
    }
    let occurring = p.variables_occurring();
    for (k, (known, signs)) in supposed.iter().enumerate() {
        let Some(range) = range_of(*signs) else {
            continue;
        };
        for letter in known.variables_occurring() {
            if !occurring.contains(&letter) {
                continue;
            }
            let [rest, slope] = &known.coefficients_in(letter)[..] else {
                continue;
            };
            let Some(slope) = slope.as_constant() else {
                continue;
            };
            // slope letter + rest = t
            let t = RationalFunction::variable(p.ring(), letter);
            let divisor = RationalFunction::constant(p.ring(), BigRational::from_integer(slope));
            let Ok(image) = (&t - &RationalFunction::from(rest.clone())).checked_div(&divisor)
            else {
                continue;
            };
            let images = [(letter, image)];
            let put = |q: &Polynomial| -> Option<Polynomial> {
                let value = RationalFunction::from(q.clone()).substitute(&images).ok()?;
                // The denominator is a positive number.
                Some(value.numerator().clone())
            };
            let Some(image) = put(p) else { continue };
            let mut there = ranges.to_vec();
            there[letter] = range.clone();
            found = found.and(on_box(&image, &there, budget));
            let mut others = Vec::new();
            for (j, (other, signs)) in supposed.iter().enumerate() {
                if j != k
                    && let Some(other) = put(other)
                {
                    others.push((other, *signs));
                }
            }
            // What was known of the letter is one supposition more.
            let own = &ranges[letter];
            for (end, signs) in [
                (&own.low, [Signs::POSITIVE, Signs::NOT_NEGATIVE]),
                (&own.high, [Signs::NEGATIVE, Signs::NOT_POSITIVE]),
            ] {
                if let Some(end) = end
                    && let Some(own) = put(&distance(p, letter, &end.value))
                {
                    others.push((own, signs[usize::from(end.included)]));
                }
            }
            if found.only().is_none() && !others.is_empty() {
                found = found.and(by_suppositions(&image, &there, &others, depth - 1, budget));
            }
            if found.only().is_some() {
                return found;
            }
        }
    }
    found
}

/// A positive multiple of letter - value.
fn distance(p: &Polynomial, letter: usize, value: &BigRational) -> Polynomial {
    let x = Polynomial::variable(p.ring(), letter);
    &x.mul_integer(value.denom()) - &Polynomial::constant(p.ring(), value.numer().clone())
}

/// The numbers with these signs; none for those that are no interval.
fn range_of(signs: Signs) -> Option<Range> {
    let mut range = Range::default();
    let zero = BigRational::zero;
    match signs {
        Signs::POSITIVE => range.raise(zero(), false),
        Signs::NOT_NEGATIVE => range.raise(zero(), true),
        Signs::NEGATIVE => range.lower(zero(), false),
        Signs::NOT_POSITIVE => range.lower(zero(), true),
        _ => return None,
    }
    Some(range)
}

/// A positive multiple of the polynomial where a letter has a value.
fn at(p: &Polynomial, letter: usize, value: &BigRational) -> Option<Polynomial> {
    let image = RationalFunction::constant(p.ring(), value.clone());
    let there = RationalFunction::from(p.clone())
        .substitute(&[(letter, image)])
        .ok()?;
    debug_assert!(
        there
            .denominator()
            .as_constant()
            .is_some_and(|d| d.is_positive() || d.is_one())
    );
    Some(there.numerator().clone())
}

#[cfg(test)]
mod tests {
    use super::*;
    use ratpoly::{Order, Ring};

    fn signs(text: &str, supposed: &[(&str, Signs)]) -> Signs {
        let ring = Ring::new(["a", "b", "c", "x"], Order::Grevlex).unwrap();
        let p = |text: &str| Polynomial::parse(ring, text).unwrap();
        let mut admitted = Admitted::within(vec![
            Range::positive(),
            Range::positive(),
            Range::positive(),
            Range::default(),
        ]);
        for (text, signs) in supposed {
            admitted.suppose(&p(text), *signs);
        }
        let others = |_: usize| Range::default();
        admitted.signs_of(&p(text), &others, &Budget::default())
    }

    #[test]
    fn ranges_and_suppositions_give_signs() {
        use Signs as S;
        assert_eq!(signs("a + b", &[]), S::POSITIVE);
        assert_eq!(signs("a - b", &[]), S::ANY);
        assert_eq!(signs("a - b", &[("b - a", S::POSITIVE)]), S::NEGATIVE);
        assert_eq!(signs("a^2 - b^2", &[("b - a", S::POSITIVE)]), S::NEGATIVE);
        let chain = [("b - a", S::POSITIVE), ("c - b", S::POSITIVE)];
        assert_eq!(signs("c - a", &chain), S::POSITIVE);
        assert_eq!(signs("x", &[("x", S::NOT_NEGATIVE)]), S::NOT_NEGATIVE);
        assert_eq!(signs("x + 1", &[("x", S::NOT_NEGATIVE)]), S::POSITIVE);
        assert_eq!(signs("x^2 - 4", &[("x - 2", S::NEGATIVE)]), S::ANY);
        let between = [("x - 2", S::NEGATIVE), ("x + 2", S::POSITIVE)];
        assert_eq!(signs("x^2 - 4", &between), S::NEGATIVE);
        let closed = [("x - 2", S::NOT_POSITIVE), ("x + 2", S::NOT_NEGATIVE)];
        assert_eq!(signs("x^2 - 4", &closed), S::NOT_POSITIVE);
        assert_eq!(signs("a - b", &[("a - b", S::NOT_ZERO)]), S::NOT_ZERO);
        assert_eq!(
            signs("1 - a", &[("b - 1", S::NEGATIVE), ("b - a", S::POSITIVE)]),
            S::POSITIVE
        );
        assert_eq!(
            signs(
                "x - 3",
                &[("x - 3", S::NOT_NEGATIVE), ("x - 3", S::NOT_POSITIVE)]
            ),
            S::ZERO
        );
    }

    #[test]
    fn what_contradicts_is_empty() {
        let ring = Ring::new(["a", "b"], Order::Grevlex).unwrap();
        let p = |text: &str| Polynomial::parse(ring, text).unwrap();
        let others = |_: usize| Range::default();
        let budget = Budget::default();
        let empty = |supposed: &[(&str, Signs)]| {
            let mut admitted = Admitted::within(vec![Range::positive(), Range::default()]);
            for (text, signs) in supposed {
                admitted.suppose(&p(text), *signs);
            }
            admitted.is_empty(&others, &budget)
        };
        assert!(empty(&[("a", Signs::NEGATIVE)]));
        assert!(empty(&[
            ("a - b", Signs::NEGATIVE),
            ("b - a", Signs::NEGATIVE)
        ]));
        assert!(empty(&[
            ("a - b", Signs::NEGATIVE),
            ("b", Signs::NOT_POSITIVE)
        ]));
        assert!(!empty(&[("a - b", Signs::NEGATIVE)]));
    }
}
