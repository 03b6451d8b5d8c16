//! Signs of elements with functions, wherever the letters have the values of their ranges.
//!
//! In order: coefficients of one sign in positive letters; what is supposed; numbers by enclosures; a
//! polynomial on the box of its letters' ranges; factors; a sum a + b t with a root t by comparing a^2 with
//! b^2 t^2; sums of logarithms; estimates, e^u >= 1 + u and their like; half angles. Nothing is sampled, and a certificate says what was used.

use super::monotone::Increasing;
use super::{FunctionLetter, FunctionTable};
use crate::model::range::Range;
use num_rational::BigRational;
use num_traits::{Signed, Zero};
use ratpoly::{Bound, Budget, Polynomial, RationalFunction, Region, RegionSign, sign_on};
use std::cmp::Ordering;
use std::collections::{BTreeMap, HashMap};

/// What is known of a sign.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Sign {
    /// Less than zero.
    Negative,
    /// Not greater than zero.
    NotPositive,
    /// Zero everywhere.
    Zero,
    /// Not less than zero.
    NotNegative,
    /// Greater than zero.
    Positive,
}

impl Sign {
    /// The sign of the negated element.
    #[must_use]
    pub fn reversed(self) -> Self {
        match self {
            Sign::Negative => Sign::Positive,
            Sign::NotPositive => Sign::NotNegative,
            Sign::Zero => Sign::Zero,
            Sign::NotNegative => Sign::NotPositive,
            Sign::Positive => Sign::Negative,
        }
    }

    /// The sign of a product.
    #[must_use]
    pub fn times(self, other: Self) -> Self {
        match (self, other) {
            (Sign::Zero, _) | (_, Sign::Zero) => Sign::Zero,
            (Sign::Positive, sign) | (sign, Sign::Positive) => sign,
            (Sign::Negative, sign) | (sign, Sign::Negative) => sign.reversed(),
            (Sign::NotNegative, sign) => sign,
            (Sign::NotPositive, sign) => sign.reversed(),
        }
    }

    /// The sign of a sum, where the two tell it.
    #[must_use]
    pub fn plus(self, other: Self) -> Option<Self> {
        match (self, other) {
            (Sign::Zero, sign) | (sign, Sign::Zero) => Some(sign),
            (Sign::Positive, Sign::Positive | Sign::NotNegative)
            | (Sign::NotNegative, Sign::Positive) => Some(Sign::Positive),
            (Sign::NotNegative, Sign::NotNegative) => Some(Sign::NotNegative),
            (Sign::Negative, Sign::Negative | Sign::NotPositive)
            | (Sign::NotPositive, Sign::Negative) => Some(Sign::Negative),
            (Sign::NotPositive, Sign::NotPositive) => Some(Sign::NotPositive),
            (Sign::Positive | Sign::NotNegative, Sign::Negative | Sign::NotPositive)
            | (Sign::Negative | Sign::NotPositive, Sign::Positive | Sign::NotNegative) => None,
        }
    }

    /// Whether it is never negative.
    pub fn is_not_negative(self) -> bool {
        matches!(self, Sign::Zero | Sign::NotNegative | Sign::Positive)
    }

    /// Whether it is never positive.
    pub fn is_not_positive(self) -> bool {
        self.reversed().is_not_negative()
    }

    /// The order to zero, where there is one for all values.
    pub fn strict(self) -> Option<Ordering> {
        match self {
            Sign::Negative => Some(Ordering::Less),
            Sign::Zero => Some(Ordering::Equal),
            Sign::Positive => Some(Ordering::Greater),
            Sign::NotPositive | Sign::NotNegative => None,
        }
    }
}

/// Something that the proof of a sign uses.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum SignFact {
    /// The values of a letter lie in this range.
    Range(usize, Range),
    /// A number's enclosure does not contain zero.
    Enclosure(Polynomial),
    /// This is positive, or not negative, by what is supposed.
    Supposed(RationalFunction),
    /// A sum a + b t with the root t: the sign of a^2 - b^2 t^2, which is this.
    Squares {
        /// The root's letter.
        root: usize,
        /// The difference of the squares.
        difference: RationalFunction,
    },
    /// A sum of logarithms has the sign of this.
    Logarithms(RationalFunction),
    /// With the tangent of half of an angle, which is any real number, it has the sign of this.
    HalfAngle(RationalFunction),
    /// A letter was bounded by an estimate of its function: in its place stands this, in which the letter is
    /// a number from zero on.
    Estimate {
        /// The letter.
        letter: usize,
        /// What it is.
        image: RationalFunction,
    },
}

/// A sign and what proves it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SignCertificate {
    /// The sign.
    pub sign: Sign,
    /// What was used.
    pub facts: Vec<SignFact>,
}

impl SignCertificate {
    pub(super) fn new(sign: Sign, facts: Vec<SignFact>) -> Self {
        SignCertificate { sign, facts }
    }
}

/// Signs that were asked for: a search asks for the same ones again and again.
#[derive(Debug, Default)]
pub(super) struct KnownSigns {
    found: HashMap<Polynomial, Option<SignCertificate>>,
    generation: u64,
    /// Short bounds of increasing functions at rational numbers, which nothing changes.
    pub(super) ends: HashMap<(Increasing, BigRational), Option<(BigRational, BigRational)>>,
}

/// The most signs that are kept.
const MOST_SIGNS: usize = 10_000;
/// How deep squares are compared.
const DEEPEST: usize = 4;
/// The most letters with an end that belongs to their range: each face is looked at.
const MOST_CLOSED: usize = 5;

impl FunctionTable {
    /// The sign of an element wherever the letters have admitted values, if it has one: never
    /// `Equal` but for zero itself.
    pub fn sign(&self, f: &RationalFunction) -> Option<Ordering> {
        self.known_sign(f)?.strict()
    }

    /// What is known of an element's sign, where it has a value.
    pub fn known_sign(&self, f: &RationalFunction) -> Option<Sign> {
        Some(self.sign_certificate(f)?.sign)
    }

    /// What is known of an element's sign, where it has a value, and why.
    pub fn sign_certificate(&self, f: &RationalFunction) -> Option<SignCertificate> {
        self.sign_within(f, DEEPEST)
    }

    pub(super) fn sign_within(
        &self,
        f: &RationalFunction,
        depth: usize,
    ) -> Option<SignCertificate> {
        let above = self.sign_of_polynomial(f.numerator(), depth)?;
        let below = self.sign_of_polynomial(f.denominator(), depth)?;
        // Where there is a value the denominator is not zero.
        let below_sign = match below.sign {
            Sign::NotNegative | Sign::Positive => Sign::Positive,
            Sign::NotPositive | Sign::Negative => Sign::Negative,
            Sign::Zero => return None,
        };
        let facts = [above.facts, below.facts].concat();
        Some(SignCertificate::new(above.sign.times(below_sign), facts))
    }

    /// Whether an element is known to be positive.
    pub fn is_positive(&self, f: &RationalFunction) -> bool {
        self.sign(f) == Some(Ordering::Greater)
    }

    pub(super) fn sign_of_polynomial(
        &self,
        p: &Polynomial,
        depth: usize,
    ) -> Option<SignCertificate> {
        if let Some(constant) = p.as_constant() {
            let sign = match constant {
                c if c.is_zero() => Sign::Zero,
                c if c.is_positive() => Sign::Positive,
                _ => Sign::Negative,
            };
            return Some(SignCertificate::new(sign, Vec::new()));
        }
        let occurring = p.variables_occurring();
        let mut signs = p.terms().map(|(_, c)| c.is_positive());
        let first = signs.next()?;
        if signs.all(|s| s == first) && occurring.iter().all(|l| self.is_positive_letter(*l)) {
            let sign = match first {
                true => Sign::Positive,
                false => Sign::Negative,
            };
            let facts = occurring.iter();
            let facts = facts.map(|l| SignFact::Range(*l, Range::positive()));
            return Some(SignCertificate::new(sign, facts.collect()));
        }
        let generation = self.lock().generation;
        {
            let mut known = self.known_signs();
            if known.generation != generation || known.found.len() >= MOST_SIGNS {
                known.found.clear();
                known.generation = generation;
            }
            if let Some(found) = known.found.get(p) {
                return found.clone();
            }
        }
        let sign = self.search_sign(p, &occurring, depth);
        // What was cut off by the depth may be found from elsewhere.
        if sign.is_some() || depth == DEEPEST {
            self.known_signs().found.insert(p.clone(), sign.clone());
        }
        sign
    }

    pub(super) fn known_signs(&self) -> std::sync::MutexGuard<'_, KnownSigns> {
        self.signs
            .lock()
            .unwrap_or_else(std::sync::PoisonError::into_inner)
    }

    fn search_sign(
        &self,
        p: &Polynomial,
        occurring: &[usize],
        depth: usize,
    ) -> Option<SignCertificate> {
        if !occurring.iter().all(|l| self.is_real_letter(*l)) {
            return None;
        }
        if let Some(found) = self.sign_supposed(p) {
            return Some(found);
        }
        if occurring.iter().all(|l| self.is_number(*l)) {
            let point = vec![None; self.ring.len()];
            let interval = self.enclosure(&p.clone().into(), &point)?;
            let sign = match () {
                () if interval.low.is_positive() => Sign::Positive,
                () if interval.high.is_negative() => Sign::Negative,
                () => return None,
            };
            let facts = vec![SignFact::Enclosure(p.clone())];
            return Some(SignCertificate::new(sign, facts));
        }
        let ranges: BTreeMap<usize, Range> = occurring
            .iter()
            .map(|l| (*l, self.letter_range(*l)))
            .collect();
        if let Some(sign) = self.sign_on_box(p, &ranges) {
            let facts = ranges.into_iter().map(|(l, r)| SignFact::Range(l, r));
            return Some(SignCertificate::new(sign, facts.collect()));
        }
        if depth == 0 {
            return None;
        }
        self.sign_by_factors(p, depth)
            .or_else(|| self.sign_by_squares(p, depth))
            .or_else(|| self.sign_by_logarithms(p, depth))
            .or_else(|| self.sign_by_estimates(p, &ranges))
            .or_else(|| self.sign_by_half_angles(p, depth))
    }

    /// The sign of what is supposed, up to a number as a factor.
    fn sign_supposed(&self, p: &Polynomial) -> Option<SignCertificate> {
        self.supposed.iter().find_map(|supposition| {
            let ratio = RationalFunction::from(p.clone())
                .checked_div(&supposition.element)
                .ok()?
                .as_constant()?;
            let sign = match supposition.strict {
                true => Sign::Positive,
                false => Sign::NotNegative,
            };
            let sign = match ratio.is_negative() {
                true => sign.reversed(),
                false => sign,
            };
            let facts = vec![SignFact::Supposed(supposition.element.clone())];
            Some(SignCertificate::new(sign, facts))
        })
    }

    /// The sign of a polynomial where its letters lie in these ranges: on the open box, and on each
    /// face that belongs to it.
    pub(super) fn sign_on_box(
        &self,
        p: &Polynomial,
        ranges: &BTreeMap<usize, Range>,
    ) -> Option<Sign> {
        self.sign_on_box_within(p, ranges, &Budget::new(20_000, 4_000, 5_000_000))
    }

    /// The same with a budget for each face.
    pub(super) fn sign_on_box_within(
        &self,
        p: &Polynomial,
        ranges: &BTreeMap<usize, Range>,
        budget: &Budget,
    ) -> Option<Sign> {
        let occurring = p.variables_occurring();
        let end = |end: &Option<crate::model::range::End>, infinite: Bound| match end {
            Some(end) => Bound::Finite(end.value.clone()),
            None => infinite,
        };
        let intervals: Vec<(Bound, Bound)> = (0..self.ring.len())
            .map(
                |l| match ranges.get(&l).filter(|_| occurring.contains(&l)) {
                    Some(range) => (
                        end(&range.low, Bound::NegativeInfinity),
                        end(&range.high, Bound::PositiveInfinity),
                    ),
                    None => (Bound::Finite(BigRational::zero()), Bound::PositiveInfinity),
                },
            )
            .collect();
        let region = Region::new(intervals).ok()?;
        let inside = match sign_on(p, &region, budget).ok()? {
            RegionSign::Zero => Sign::Zero,
            RegionSign::Positive => Sign::Positive,
            RegionSign::Negative => Sign::Negative,
            RegionSign::NonNegative => Sign::NotNegative,
            RegionSign::NonPositive => Sign::NotPositive,
            RegionSign::Changes { .. } | RegionSign::Undecided => return None,
        };
        let weak = match inside {
            Sign::Positive => Sign::NotNegative,
            Sign::Negative => Sign::NotPositive,
            // By continuity it is so on the faces.
            Sign::Zero | Sign::NotNegative | Sign::NotPositive => return Some(inside),
        };
        let closed = |l: &&usize| {
            ranges.get(l).is_some_and(|r| {
                let ends = [&r.low, &r.high];
                ends.iter().any(|e| e.as_ref().is_some_and(|e| e.included))
            })
        };
        if occurring.iter().filter(closed).count() > MOST_CLOSED {
            return Some(weak);
        }
        for letter in &occurring {
            let Some(range) = ranges.get(letter) else {
                continue;
            };
            for end in [&range.low, &range.high].into_iter().flatten() {
                if !end.included {
                    continue;
                }
                let at = RationalFunction::constant(self.ring, end.value.clone());
                let face = RationalFunction::from(p.clone())
                    .substitute(&[(*letter, at)])
                    .ok()?;
                let sign = self.sign_on_box_within(face.numerator(), ranges, budget)?;
                if sign != inside {
                    return Some(weak);
                }
            }
        }
        Some(inside)
    }

    /// The sign of a product.
    fn sign_by_factors(&self, p: &Polynomial, depth: usize) -> Option<SignCertificate> {
        let product = p
            .factor_within(&Budget::new(2_000, 2_000, 1_000_000))
            .ok()?;
        if matches!(product.factors[..], [] | [(_, 1)]) {
            return None;
        }
        let mut sign = match product.content.is_negative() {
            true => Sign::Negative,
            false => Sign::Positive,
        };
        let mut facts = Vec::new();
        for (factor, multiplicity) in &product.factors {
            let own = self.sign_of_polynomial(factor, depth - 1);
            let own = match own {
                Some(own) if multiplicity % 2 == 1 => own,
                Some(own) => SignCertificate::new(own.sign.times(own.sign), own.facts),
                None if multiplicity % 2 == 0 => {
                    SignCertificate::new(Sign::NotNegative, Vec::new())
                }
                None => return None,
            };
            sign = sign.times(own.sign);
            facts.extend(own.facts);
        }
        Some(SignCertificate::new(sign, facts))
    }

    /// a + b t with the root t >= 0 by the sign of a^2 - b^2 t^2, where those of a and b do not agree.
    fn sign_by_squares(&self, p: &Polynomial, depth: usize) -> Option<SignCertificate> {
        let reduced = self.reduce(p.clone().into());
        let p = reduced.numerator();
        if !reduced.denominator().is_constant() || p.is_constant() {
            return None;
        }
        let roots = p.variables_occurring().into_iter().rev();
        let roots = roots.filter_map(|letter| match self.meaning(letter) {
            Some(FunctionLetter::Root(radicand)) => Some((letter, radicand)),
            _ => None,
        });
        for (root, radicand) in roots {
            let parts = p.coefficients_in(root);
            let [a, b] = parts.as_slice() else {
                continue;
            };
            let sign_of = |p: &Polynomial| self.sign_of_polynomial(p, depth - 1);
            let root_sign = match self.is_positive(&radicand.clone().into()) {
                true => Sign::Positive,
                false => Sign::NotNegative,
            };
            let first = sign_of(a);
            let second = sign_of(b);
            let second_sign = second.as_ref().map(|s| s.sign.times(root_sign));
            let mut facts: Vec<SignFact> = [&first, &second]
                .into_iter()
                .flatten()
                .flat_map(|s| s.facts.clone())
                .collect();
            if let (Some(first), Some(second)) = (&first, second_sign)
                && let Some(sum) = first.sign.plus(second)
            {
                return Some(SignCertificate::new(sum, facts));
            }
            let difference = self.reduce((&(a * a) - &(&(b * b) * &radicand)).into());
            let Some(squares) = self.sign_within(&difference, depth - 1) else {
                continue;
            };
            let sign = match (first.map(|f| f.sign), second_sign) {
                // a >= 0 >= bt: the larger one is that with the larger square; and mirrored.
                (Some(a), Some(b)) if a.is_not_negative() && b.is_not_positive() => squares.sign,
                (Some(a), Some(b)) if a.is_not_positive() && b.is_not_negative() => {
                    squares.sign.reversed()
                }
                // Only one sign is known: its own square must be the larger one.
                (Some(a), _) if squares.sign.is_not_negative() => {
                    dominating(a, squares.sign == Sign::Positive)
                }
                (_, Some(b)) if squares.sign.is_not_positive() => {
                    dominating(b, squares.sign == Sign::Negative)
                }
                _ => continue,
            };
            facts.extend(squares.facts);
            facts.push(SignFact::Squares { root, difference });
            return Some(SignCertificate::new(sign, facts));
        }
        None
    }
}

/// The sign of a sum whose first part has this sign and a modulus that is not less than, or greater
/// than, that of the second.
fn dominating(sign: Sign, strictly: bool) -> Sign {
    match (sign.is_not_negative(), sign.is_not_positive()) {
        // The modulus is greater than another one, so that it is not zero.
        (true, false) if strictly => Sign::Positive,
        (false, true) if strictly => Sign::Negative,
        (true, false) => Sign::NotNegative,
        (false, true) => Sign::NotPositive,
        // Zero with a modulus that is not less than the other: both are zero.
        _ => Sign::Zero,
    }
}
