//! Points at which all that is supposed holds: small rational numbers in the ranges of the letters, and
//! from the relations the letters that they determine.
//!
//! A relation without rational zeros is exhibited by two points between which it changes its sign, with
//! nothing but one letter between them: there is a zero on the way (Bolzano 1817).

use super::Supposed;
use crate::check::Checker;
use crate::check::hypotheses::admitted::Admitted;
use crate::check::hypotheses::possible::Signs;
use crate::domain::Rationals;
use crate::matrix::Matrix;
use crate::model::Letter;
use crate::model::matrices::MatrixEntry;
use crate::model::range::{Numbers, Range};
use crate::theory::determinant;
use crate::verdict::{PointValue, Refutation, ResidualEntry, Witness};
use num_rational::BigRational;
use num_traits::{Signed, Zero};
use ratpoly::{Budget, Polynomial, RationalFunction};
use std::cmp::Ordering;
use std::collections::BTreeSet;

/// How many points are tried.
const TRIES: usize = 240;
/// How many points a relation's two signs are looked for at.
const SIGNS: usize = 60;
/// At how many points the value of a function is enclosed.
const ENCLOSED: usize = 6;
/// Roots are looked for in polynomials of degrees up to this.
const DEGREE: u32 = 6;

/// Values of some letters.
pub(crate) type Point = Vec<Option<BigRational>>;

impl Checker<'_> {
    /// Whether some point is known at which all that is supposed holds.
    pub(super) fn is_exhibited(&self, supposed: &Supposed) -> bool {
        if supposed.relations.is_empty() && supposed.admitted.signs.is_empty() {
            // The ranges are not empty, and letters that were solved for have values.
            return true;
        }
        self.points_in(supposed, &BTreeSet::new()).next().is_some()
            || self.has_zero_between(supposed)
    }

    /// Points that give these letters, and all that what is supposed mentions, values at which it holds.
    pub(crate) fn admitted_points<'a>(
        &'a self,
        letters: &BTreeSet<usize>,
    ) -> impl Iterator<Item = Point> + 'a {
        self.points_in(&self.supposed, letters)
    }

    /// Points at which something else than the hypotheses in force is supposed.
    pub(crate) fn points_under(
        &self,
        supposed: &Supposed,
        letters: &BTreeSet<usize>,
    ) -> Vec<Point> {
        self.points_in(supposed, letters).take(SIGNS).collect()
    }

    fn points_in<'a>(
        &'a self,
        supposed: &'a Supposed,
        letters: &BTreeSet<usize>,
    ) -> impl Iterator<Item = Point> + 'a {
        let free = self.free_letters(supposed, letters);
        let determined = self.determined_letters(supposed, &free);
        (0..TRIES).filter_map(move |k| self.point(supposed, &free, &determined, k))
    }

    /// The letters that need values: those of what is supposed, and what these are functions of.
    fn free_letters(&self, supposed: &Supposed, more: &BTreeSet<usize>) -> Vec<usize> {
        let mut open: BTreeSet<usize> = more.clone();
        let relations = supposed.relations.iter();
        let signs = supposed.admitted.signs.iter().map(|(p, _)| p);
        for p in relations.chain(signs).chain(&supposed.divisors) {
            open.extend(p.variables_occurring());
        }
        for (letter, value) in &supposed.replaced {
            open.remove(letter);
            open.extend(super::super::identity::letters_of([value]));
        }
        let mut letters = BTreeSet::new();
        for letter in open {
            match self.functions() {
                Some(table) => letters.extend(table.letters_behind(&table.variable(letter))),
                None => {
                    letters.insert(letter);
                }
            }
        }
        let replaced = |l: &usize| supposed.replaced.iter().any(|(letter, _)| letter == l);
        // All entries of a definite matrix, once one is needed.
        letters.extend(self.definite_letters(&letters));
        letters.retain(|l| matches!(self.model.letters[*l], Letter::Symbol { .. }) && !replaced(l));
        letters.into_iter().collect()
    }

    /// For each relation a letter that is left to it, one that it is linear in if there is one.
    fn determined_letters(&self, supposed: &Supposed, free: &[usize]) -> Vec<usize> {
        let mut taken: Vec<usize> = Vec::new();
        for relation in &supposed.relations {
            let occurring = relation.variables_occurring();
            let behind = |l: usize| {
                self.functions().is_some_and(|table| {
                    let mut functions = occurring.iter().filter(|f| **f != l);
                    functions.any(|f| table.letters_behind(&table.variable(*f)).contains(&l))
                })
            };
            let able = free
                .iter()
                .filter(|l| occurring.contains(l) && !taken.contains(l) && !behind(**l));
            let best = able.min_by_key(|l| (relation.degree(**l), std::cmp::Reverse(**l)));
            taken.extend(best);
        }
        taken
    }

    /// The point of a number, where what is supposed holds at it.
    fn point(
        &self,
        supposed: &Supposed,
        free: &[usize],
        determined: &[usize],
        k: usize,
    ) -> Option<Point> {
        let mut point: Point = vec![None; self.model.letters.len()];
        for (position, letter) in free.iter().enumerate() {
            if determined.contains(letter) {
                continue;
            }
            let range = &supposed.admitted.ranges[*letter];
            point[*letter] = Some(self.choice(*letter, range, position, k));
        }
        self.make_definite(&mut point, &mut []);
        let mut open: Vec<&Polynomial> = supposed.relations.iter().collect();
        let mut turn = k;
        while !open.is_empty() {
            let next = open.iter().position(|relation| {
                let unknown = self.unknown(relation, &point);
                unknown.is_some_and(|letters| letters.len() <= 1)
            })?;
            let relation = open.remove(next);
            match self.unknown(relation, &point)?[..] {
                [letter] => {
                    let roots = self.roots(relation, letter, &point)?;
                    let range = &supposed.admitted.ranges[letter];
                    let roots: Vec<_> = roots.into_iter().filter(|r| range.contains(r)).collect();
                    if roots.is_empty() {
                        return None;
                    }
                    point[letter] = Some(roots[turn % roots.len()].clone());
                    turn /= roots.len();
                }
                _ if self.value_at(&relation.clone().into(), &point)?.is_zero() => {}
                _ => return None,
            }
        }
        for letter in determined {
            if point[*letter].is_none() {
                let range = &supposed.admitted.ranges[*letter];
                point[*letter] = Some(range.sample(k));
            }
        }
        for (letter, value) in &supposed.replaced {
            // What is irrational has no value here, and stays without one.
            if let Some(value) = self.value_at(value, &point) {
                if !self.model.range_of(*letter).contains(&value) {
                    return None;
                }
                point[*letter] = Some(value);
            }
        }
        let holds = |p: &Polynomial, signs: Signs| {
            let sign = self.sign_there(p, &point)?;
            Some(signs.admits(Signs::of(sign)))
        };
        for (p, signs) in &supposed.admitted.signs {
            if !holds(p, *signs)? {
                return None;
            }
        }
        for divisor in &supposed.divisors {
            if !holds(divisor, Signs::NOT_ZERO)? {
                return None;
            }
        }
        let inside = |l: &usize| {
            let value = point[*l].as_ref();
            value.is_some_and(|v| supposed.admitted.ranges[*l].contains(v))
        };
        (free.iter().all(inside) && self.is_definite_at(&point)).then_some(point)
    }

    /// All letters of matrices that are declared positive definite and have one among these.
    fn definite_letters(&self, among: &BTreeSet<usize>) -> BTreeSet<usize> {
        let mut found = BTreeSet::new();
        for entries in self.definite_entries() {
            let letters = || entries.iter().flatten();
            if letters().any(|l| among.contains(l)) {
                found.extend(letters());
            }
        }
        found
    }

    /// The letters in the entries of the matrices that are declared positive definite.
    fn definite_entries(&self) -> Vec<Matrix<Option<usize>>> {
        let instance = &self.model.instances[self.instance];
        let definite = self
            .model
            .matrices
            .iter()
            .filter(|m| m.shape.positive_definite);
        definite
            .map(|matrix| {
                let (order, _) = matrix.shape_in(instance);
                Matrix::from_fn(order, order, |i, j| match matrix.entry(i, j) {
                    MatrixEntry::Symbol(symbol) => self.model.letter_of_symbol(symbol, 0),
                    MatrixEntry::Zero | MatrixEntry::MinusSymbol(_) => None,
                })
            })
            .collect()
    }

    /// Whether matrices that are declared positive definite are so at a point, as far as they have
    /// values there.
    fn is_definite_at(&self, point: &Point) -> bool {
        self.definite_entries().into_iter().all(|entries| {
            let value = |entry: &Option<usize>| entry.and_then(|l| point[l].clone());
            if entries.iter().all(|entry| value(entry).is_none()) {
                return true;
            }
            let Ok(matrix) = entries.try_map(|entry| value(entry).ok_or(())) else {
                return false;
            };
            (1..=matrix.rows()).all(|n| {
                determinant::determinant(&Rationals, &matrix.leading(n))
                    .is_some_and(|minor| minor.is_positive())
            })
        })
    }

    /// The value that a letter has at the point of a number: its reference value first.
    fn choice(&self, letter: usize, range: &Range, position: usize, k: usize) -> BigRational {
        if k == 0
            && let Letter::Symbol { symbol, order: 0 } = self.model.letters[letter]
            && let Some(value) = &self.model.symbols[symbol].value
            && range.contains(value)
        {
            return value.clone();
        }
        // Different for neighbours, simple numbers first.
        let mixed = (k.wrapping_mul(2 * position + 3) + position * 5) ^ (k >> 3);
        range.sample(mixed % (4 + k / 4).max(2))
    }

    /// The letters of a polynomial that have no value yet; none where one stands in a function.
    fn unknown(&self, p: &Polynomial, point: &Point) -> Option<Vec<usize>> {
        let mut unknown = Vec::new();
        for letter in p.variables_occurring() {
            match self.functions().filter(|t| t.meaning(letter).is_some()) {
                Some(table) => {
                    let behind = table.letters_behind(&table.variable(letter));
                    let open = |l: &usize| {
                        matches!(self.model.letters[*l], Letter::Symbol { .. })
                            && point[*l].is_none()
                    };
                    if behind.iter().any(open) {
                        return None;
                    }
                }
                None if point[letter].is_none() => unknown.push(letter),
                None => {}
            }
        }
        Some(unknown)
    }

    /// The rational roots in one letter where the others have values.
    fn roots(&self, p: &Polynomial, letter: usize, point: &Point) -> Option<Vec<BigRational>> {
        let coefficients = p
            .coefficients_in(letter)
            .iter()
            .map(|c| self.value_at(&c.clone().into(), point))
            .collect::<Option<Vec<_>>>()?;
        let ring = p.ring();
        let x = RationalFunction::variable(ring, letter);
        let mut sum = RationalFunction::zero(ring);
        for c in coefficients.into_iter().rev() {
            sum = &(&sum * &x) + &RationalFunction::constant(ring, c);
        }
        if sum.is_zero() {
            // Any value will do.
            return Some(vec![self.supposed.admitted.ranges[letter].sample(0)]);
        }
        if sum.numerator().degree(letter)? > DEGREE {
            return None;
        }
        let factors = sum.numerator().factor_within(&Budget::default()).ok()?;
        let root = |f: &Polynomial| match &f.coefficients_in(letter)[..] {
            [constant, slope] => {
                let (c, s) = (constant.as_constant()?, slope.as_constant()?);
                Some(BigRational::new(-c, s))
            }
            _ => None,
        };
        Some(
            factors
                .factors
                .iter()
                .filter_map(|(f, _)| root(f))
                .collect(),
        )
    }

    /// The sign of a polynomial at a point, by an enclosure where it is irrational.
    fn sign_there(&self, p: &Polynomial, point: &Point) -> Option<Ordering> {
        let value = RationalFunction::from(p.clone());
        if let Some(value) = self.value_at(&value, point) {
            return Some(value.cmp(&BigRational::zero()));
        }
        let enclosure = self.functions()?.enclosure(&value, point)?;
        match () {
            () if enclosure.low.is_positive() => Some(Ordering::Greater),
            () if enclosure.high.is_negative() => Some(Ordering::Less),
            () => None,
        }
    }

    /// Whether a single relation changes its sign between two points that differ in one letter, and all
    /// else that is supposed holds between them.
    fn has_zero_between(&self, supposed: &Supposed) -> bool {
        let [relation] = &supposed.relations[..] else {
            return false;
        };
        let free = self.free_letters(supposed, &BTreeSet::new());
        let ranges = &supposed.admitted.ranges;
        let real = |l: &&usize| ranges[**l].numbers == Numbers::Real;
        let continuous = |p: &Polynomial| self.is_continuous(p, supposed);
        let signs = &supposed.admitted.signs;
        let polynomials = signs.iter().map(|(p, _)| p).chain(&supposed.divisors);
        if !continuous(relation) {
            return false;
        }
        let polynomials: Vec<&Polynomial> = polynomials.collect();
        let functions =
            |p: &&Polynomial| p.variables_occurring().iter().any(|l| self.is_function(*l));
        if polynomials.iter().any(functions)
            || !self
                .definite_letters(&free.iter().copied().collect())
                .is_empty()
        {
            return false;
        }
        for moving in free.iter().filter(real) {
            for k in 0..SIGNS {
                let mut point: Point = vec![None; self.model.letters.len()];
                for (position, letter) in free.iter().enumerate() {
                    point[*letter] = Some(self.choice(*letter, &ranges[*letter], position, k));
                }
                let mut seen: [Option<BigRational>; 2] = [None, None];
                for step in 0..8 {
                    let value = ranges[*moving].sample(step);
                    point[*moving] = Some(value.clone());
                    match self.sign_there(relation, &point) {
                        Some(Ordering::Less) => seen[0] = Some(value),
                        Some(Ordering::Greater) => seen[1] = Some(value),
                        Some(Ordering::Equal) | None => {}
                    }
                }
                let [Some(one), Some(other)] = &seen else {
                    continue;
                };
                let mut between = vec![Range::default(); ranges.len()];
                for letter in &free {
                    if let Some(value) = &point[*letter] {
                        between[*letter].raise(value.clone(), true);
                        between[*letter].lower(value.clone(), true);
                    }
                }
                between[*moving] = Range::default();
                between[*moving].raise(one.min(other).clone(), true);
                between[*moving].lower(one.max(other).clone(), true);
                let there = Admitted::within(between);
                let budget = Budget::new(20_000, 4_000, 1_000_000);
                let others = |_: usize| Range::default();
                let holds =
                    |p: &Polynomial, s: Signs| there.signs_of(p, &others, &budget).within(s);
                if signs.iter().all(|(p, s)| holds(p, *s))
                    && supposed.divisors.iter().all(|d| holds(d, Signs::NOT_ZERO))
                {
                    return true;
                }
            }
        }
        false
    }

    /// Whether a polynomial has no poles or gaps where the letters have admitted values.
    fn is_continuous(&self, p: &Polynomial, supposed: &Supposed) -> bool {
        let Some(table) = self.functions() else {
            return true;
        };
        p.variables_occurring().into_iter().all(|letter| {
            use crate::functions::FunctionLetter as L;
            let defined = match table.meaning(letter) {
                None | Some(L::Pi | L::Exponential(_) | L::Cosine(_) | L::Sine(..)) => true,
                Some(L::Root(square)) => !self.signs_in(supposed, &square).admits(Signs::NEGATIVE),
                Some(L::Power(base, _) | L::Logarithm(base)) => {
                    self.signs_in(supposed, &base) == Signs::POSITIVE
                }
                Some(L::ImaginaryUnit | L::Dirac(_) | L::Bound { .. }) => false,
            };
            defined
                && table.arguments(letter).iter().all(|f| {
                    self.signs_in(supposed, f.denominator()).excludes_zero()
                        && self.is_continuous(f.numerator(), supposed)
                        && self.is_continuous(f.denominator(), supposed)
                })
        })
    }

    /// A point at which all that is supposed holds and the sides of an entry differ.
    pub(crate) fn supposed_witness(&self, entry: &ResidualEntry) -> Option<Witness> {
        let letters: BTreeSet<usize> = match self.functions() {
            Some(table) => [&entry.left, &entry.right]
                .iter()
                .flat_map(|side| table.letters_behind(side))
                .collect(),
            None => super::super::identity::letters_of([&entry.left, &entry.right]),
        };
        self.admitted_points(&letters).find_map(|point| {
            let left = self.certain_value(&entry.left, &point)?;
            let right = self.certain_value(&entry.right, &point)?;
            left.is_apart_from(&right).then(|| Witness {
                point: self.shown(&point),
                left,
                right,
                place: entry.place,
                indices: entry.indices.clone(),
            })
        })
    }

    /// Points at which all that is supposed holds and a function is zero, as far as rational ones are
    /// found: the function is one relation more.
    pub(in crate::check) fn zeros_where_supposed(&self, f: &RationalFunction) -> Vec<Point> {
        let letters: BTreeSet<usize> = match self.functions() {
            Some(table) => table.letters_behind(f),
            None => super::super::identity::letters_of([f]),
        };
        let mut there = Supposed::clone(&self.supposed);
        there.relations.push(f.numerator().clone());
        let is_zero = |point: &Point| self.value_at(f, point).is_some_and(|v| v.is_zero());
        let points = self.points_under(&there, &letters);
        points.into_iter().filter(is_zero).collect()
    }

    /// A point at which the hypotheses in force hold and what should be positive is not.
    pub(in crate::check) fn violated_where_supposed(
        &self,
        value: &RationalFunction,
        inserted: &RationalFunction,
        strict: bool,
    ) -> Option<Refutation> {
        if !self.supposed.in_force {
            return None;
        }
        let letters: BTreeSet<usize> = match self.functions() {
            Some(table) => table.letters_behind(inserted),
            None => super::super::identity::letters_of([inserted]),
        };
        let zero = BigRational::zero();
        // Enclosures are dear, and another route looks at more of them.
        let mut enclosed = 0;
        let mut certainly = |point: Point| {
            let found = match self.value_at(inserted, &point) {
                Some(value) => PointValue::Exact(value),
                None if enclosed < ENCLOSED => {
                    enclosed += 1;
                    self.certain_value(inserted, &point)?
                }
                None => return None,
            };
            let violated = match &found {
                PointValue::Exact(value) => value.is_negative() || strict && value.is_zero(),
                PointValue::Between(_, high) => high.is_negative(),
                PointValue::Complex(_) => false,
            };
            violated.then_some((point, found))
        };
        let mut points = self.admitted_points(&letters);
        let (point, found) = points.find_map(&mut certainly).or_else(|| {
            // What is positive but for its zeros is violated at these alone.
            let zeros = match strict {
                true => self.zeros_where_supposed(inserted),
                false => Vec::new(),
            };
            zeros.into_iter().find_map(&mut certainly)
        })?;
        let witness = Witness {
            point: self.shown(&point),
            left: found,
            right: PointValue::Exact(zero),
            place: None,
            indices: Vec::new(),
        };
        let residual = ResidualEntry {
            indices: Vec::new(),
            place: None,
            left: value.clone(),
            right: RationalFunction::zero(self.model.ring),
        };
        Some(Refutation::at(witness).with_residual(vec![residual]))
    }

    /// The letters that have values, with these.
    pub(crate) fn shown(&self, point: &Point) -> Vec<(usize, PointValue)> {
        point
            .iter()
            .enumerate()
            .filter_map(|(letter, value)| Some((letter, PointValue::Exact(value.clone()?))))
            .collect()
    }
}
