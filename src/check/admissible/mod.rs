//! The admissible values of a document's letters: their ranges and domains, and matrices that are
//! declared positive definite drawn as such.
//!
//! A symmetric matrix is positive definite if and only if it is L L^T with a lower triangular L whose
//! diagonal is positive (Cholesky; Golub & Van Loan, *Matrix Computations*, 4.2). The entries of L
//! take the places of the entries of the matrix, so that what is asked of all definite matrices is
//! asked of a box, and a point of the box is a definite matrix.
//!
//! Invariant: every sign but [`RegionSign::Undecided`] is proved for all admissible values at which
//! the function is defined, and the points of a change are admissible. Letters that stand for
//! functions are held to be free within bounds of their values, which is enough for a proof and for
//! no point: where they occur there is no [`RegionSign::Changes`].

mod faces;
mod points;

pub(crate) use faces::sign_within;

use super::Checker;
use crate::functions::{FunctionTable, Sign};
use crate::model::matrices::MatrixEntry;
use crate::model::range::{Numbers, Range};
use crate::model::{Letter, Model};
use num_rational::BigRational;
use num_traits::Zero;
use ratpoly::{Budget, RationalFunction, RegionSign, Ring};

/// Definite matrices of a higher order keep their entries as letters.
const ORDER: usize = 4;
/// What the search for a sign may use: terms, bits and steps.
const SIGN: (usize, u64, u64) = (20_000, 4_000, 2_000_000);
/// With more terms than this no entries of a triangular matrix are inserted.
const TERMS: usize = 400;

/// Where the letters of a ring may be.
pub(crate) struct Admissible {
    ring: Ring,
    /// By letter of the ring; of an entry of a definite matrix, the range of that of L.
    ranges: Vec<Range>,
    /// The reference values, where there are such and they are no entries.
    reference: Vec<Option<BigRational>>,
    /// Entries of definite matrices as polynomials in those of L.
    entries: Vec<(usize, RationalFunction)>,
    /// By matrix, all letters of its entries.
    matrices: Vec<Vec<usize>>,
    table: Option<FunctionTable>,
    /// Whether hypotheses say more than the ranges: then no point here is known to be admissible.
    in_force: bool,
}

impl Checker<'_> {
    /// Where the letters may be for the equation that is being settled.
    pub(crate) fn admissible(&self) -> Admissible {
        let mut admissible = Admissible::of(self.model, self.instance);
        if self.supposed.in_force {
            admissible.suppose(&self.supposed.admitted.ranges, self.functions().cloned());
        }
        admissible
    }
}

impl Admissible {
    /// Where the letters of a model may be in one of its instances.
    pub(crate) fn of(model: &Model, instance: usize) -> Self {
        let table = model.functions.clone();
        let ranges = (0..model.letters.len())
            .map(|letter| match model.letters[letter] {
                Letter::Symbol { symbol, order: 0 } => {
                    faces::tightened(&model.symbols[symbol].range)
                }
                Letter::Symbol { symbol, .. } => Range {
                    numbers: match model.symbols[symbol].range.numbers {
                        Numbers::Complex => Numbers::Complex,
                        Numbers::Real | Numbers::Integer => Numbers::Real,
                    },
                    ..Range::default()
                },
                Letter::Abbreviation { .. } => Range::default(),
                // What it stands for is known when it is met.
                Letter::Function { .. } => Range::default(),
            })
            .collect();
        let reference = model.letters.iter().map(|letter| match letter {
            Letter::Symbol { symbol, order: 0 } => model.symbols[*symbol].value.clone(),
            Letter::Symbol { .. } | Letter::Abbreviation { .. } | Letter::Function { .. } => None,
        });
        let mut admissible = Admissible {
            ring: model.ring,
            ranges,
            reference: reference.collect(),
            entries: Vec::new(),
            matrices: Vec::new(),
            table,
            in_force: false,
        };
        for matrix in &model.matrices {
            let (order, _) = matrix.shape_in(&model.instances[instance]);
            if matrix.shape.positive_definite && order <= ORDER {
                let letter = |i: usize, j: usize| match matrix.entry(i, j) {
                    MatrixEntry::Symbol(symbol) => model.letter_of_symbol(symbol, 0),
                    MatrixEntry::Zero | MatrixEntry::MinusSymbol(_) => None,
                };
                admissible.draw_definite(order, letter);
            }
        }
        admissible
    }
}

/// Bounds of a letter that stands for a function; one that may be complex has none.
fn function_range(table: Option<&FunctionTable>, letter: usize) -> Range {
    match table {
        Some(table) if table.is_real_letter(letter) => table.letter_range(letter),
        Some(_) | None => Range {
            numbers: Numbers::Complex,
            ..Range::default()
        },
    }
}

impl Admissible {
    /// Puts L L^T in place of the entries of a matrix.
    fn draw_definite(&mut self, order: usize, letter: impl Fn(usize, usize) -> Option<usize>) {
        let lower = |i: usize, j: usize| Some(RationalFunction::variable(self.ring, letter(j, i)?));
        let product = |i: usize, j: usize| {
            let mut sum = RationalFunction::zero(self.ring);
            for k in 0..=i.min(j) {
                sum = &sum + &(&lower(i, k)? * &lower(j, k)?);
            }
            Some(sum)
        };
        let places = (0..order).flat_map(|i| (i..order).map(move |j| (i, j)));
        let entries: Option<Vec<_>> = places
            .map(|(i, j)| Some((letter(i, j)?, product(i, j)?)))
            .collect();
        let Some(entries) = entries else {
            return;
        };
        for (i, place) in (0..order).filter_map(|i| Some((i, letter(i, i)?))) {
            debug_assert!(i < order);
            self.ranges[place] = Range::positive();
        }
        for (entry, _) in &entries {
            self.reference[*entry] = None;
        }
        self.matrices
            .push(entries.iter().map(|(entry, _)| *entry).collect());
        self.entries.extend(entries);
    }

    /// Narrows the ranges to those under hypotheses, which may say more.
    fn suppose(&mut self, ranges: &[Range], table: Option<FunctionTable>) {
        for (letter, range) in ranges.iter().enumerate() {
            if !self.is_drawn(letter) {
                self.ranges[letter] = faces::tightened(range);
                self.reference[letter] = None;
            }
        }
        self.table = table;
        self.in_force = true;
    }

    /// The range of a letter.
    pub(crate) fn range(&self, letter: usize) -> &Range {
        &self.ranges[letter]
    }

    /// The sign of a function at all admissible values at which it is defined.
    pub(crate) fn sign(&self, f: &RationalFunction) -> RegionSign {
        let (terms, bits, steps) = SIGN;
        let budget = Budget::new(terms, bits, steps);
        let drawn = if f.numerator().len() + f.denominator().len() > TERMS {
            None
        } else {
            f.substitute(&self.entries).ok()
        };
        let mut found = RegionSign::Undecided;
        if let Some(drawn) = &drawn {
            found = self.sign_of_quotient(drawn, &budget);
        }
        // Letters of functions are not free, and hypotheses may exclude a point of the box: that a
        // change is found there says nothing, and what is known beside the box may tell the sign.
        if matches!(found, RegionSign::Changes { .. }) && (self.has_functions(f) || self.in_force) {
            found = RegionSign::Undecided;
        }
        if found == RegionSign::Undecided
            && let Some(table) = &self.table
            && self.entries.iter().all(|(l, _)| !occurs(f, *l))
            && !self.has_complex(f)
        {
            found = match table.known_sign(f) {
                Some(Sign::Positive) => RegionSign::Positive,
                Some(Sign::Negative) => RegionSign::Negative,
                Some(Sign::NotNegative) => RegionSign::NonNegative,
                Some(Sign::NotPositive) => RegionSign::NonPositive,
                Some(Sign::Zero) => RegionSign::Zero,
                None => RegionSign::Undecided,
            };
        }
        match found {
            RegionSign::Changes { positive, negative } => {
                let points = [positive, negative].map(|p| self.back(p));
                self.change_at(f, points)
            }
            other => other,
        }
    }

    /// A change of sign between two points, if they are admissible; an integer may have to be found.
    fn change_at(&self, f: &RationalFunction, [p, n]: [Vec<BigRational>; 2]) -> RegionSign {
        let zero = BigRational::zero();
        let right = |point: &[BigRational], positive: bool| {
            let value = f.evaluate(point).ok();
            value.is_some_and(|v| if positive { v > zero } else { v < zero })
                && self.is_admissible(f, point)
        };
        let positive = if right(&p, true) {
            Some(p)
        } else {
            self.full_points(f).find(|p| right(p, true))
        };
        let negative = if right(&n, false) {
            Some(n)
        } else {
            self.full_points(f).find(|p| right(p, false))
        };
        match (positive, negative) {
            (Some(positive), Some(negative)) => RegionSign::Changes { positive, negative },
            _ => RegionSign::Undecided,
        }
    }

    /// The ranges of all letters, and bounds of those that stand for functions in a function.
    pub(crate) fn ranges_for(&self, f: &RationalFunction) -> Vec<Range> {
        let mut ranges = self.ranges.clone();
        for letter in super::identity::letters_of([f]) {
            if self.stands_for_a_function(letter) {
                ranges[letter] = function_range(self.table.as_ref(), letter);
            }
        }
        ranges
    }

    /// Whether a letter stands for a function or a constant.
    pub(crate) fn stands_for_a_function(&self, letter: usize) -> bool {
        let table = self.table.as_ref();
        table.is_some_and(|table| table.meaning(letter).is_some())
    }

    fn sign_of_quotient(&self, f: &RationalFunction, budget: &Budget) -> RegionSign {
        let ranges = self.ranges_for(f);
        let above = faces::sign_within(f.numerator(), &ranges, budget);
        if above == RegionSign::Zero {
            return above;
        }
        match faces::sign_within(f.denominator(), &ranges, budget) {
            // Where it vanishes, the function has no value.
            RegionSign::Positive | RegionSign::NonNegative
                if !matches!(above, RegionSign::Changes { .. })
                    || f.denominator().is_constant() =>
            {
                above
            }
            RegionSign::Negative | RegionSign::NonPositive
                if !matches!(above, RegionSign::Changes { .. }) =>
            {
                above.negated()
            }
            RegionSign::Zero => RegionSign::Undecided,
            // The product has the sign of the quotient, and vanishes nowhere where that has a value but
            // with the numerator.
            RegionSign::Positive
            | RegionSign::Negative
            | RegionSign::NonNegative
            | RegionSign::NonPositive
            | RegionSign::Changes { .. }
            | RegionSign::Undecided => {
                let product = f.numerator() * f.denominator();
                match faces::sign_within(&product, &ranges, budget) {
                    RegionSign::Zero => RegionSign::Undecided,
                    sign => sign,
                }
            }
        }
    }

    pub(crate) fn has_functions(&self, f: &RationalFunction) -> bool {
        let letters = super::identity::letters_of([f]);
        letters.into_iter().any(|l| self.stands_for_a_function(l))
    }

    fn has_complex(&self, f: &RationalFunction) -> bool {
        let letters = match &self.table {
            Some(table) => table.letters_behind(f),
            None => super::identity::letters_of([f]),
        };
        letters
            .into_iter()
            .any(|l| self.ranges[l].numbers == Numbers::Complex)
    }

    /// Whether a letter is an entry of a definite matrix, in whose place one of a triangular matrix is
    /// drawn.
    pub(crate) fn is_drawn(&self, letter: usize) -> bool {
        self.matrices.iter().any(|m| m.contains(&letter))
    }
}

fn occurs(f: &RationalFunction, letter: usize) -> bool {
    [f.numerator(), f.denominator()]
        .iter()
        .any(|p| p.variables_occurring().contains(&letter))
}
