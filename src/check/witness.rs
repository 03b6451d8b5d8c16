//! Exact points at which the two sides of an equation differ.

use super::Checker;
use super::identity::letters_of;
use crate::evaluate::Failure;
use crate::functions::FunctionLetter;
use crate::model::Letter;
use crate::model::links::Link;
use crate::model::matrices::MatrixEntry;
use crate::model::range::Numbers;
use crate::verdict::{
    CounterProof, PointValue, Refutation, ResidualEntry, Shown, Structure, Witness,
};
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{Signed, Zero};
use ratpoly::RationalFunction;

/// How many points are looked at: the sides differ at all but few.
const TRIES: u32 = 24;

impl Checker<'_> {
    /// Why the open entries are false, given the same entries with all definitions inserted; none
    /// where no admissible point was found at which they are apart.
    pub(crate) fn refutation(
        &self,
        open: &[&ResidualEntry],
        expanded: &[ResidualEntry],
    ) -> Option<Refutation> {
        let mut different = expanded.iter().filter(|e| e.left != e.right);
        let shown = different.find_map(|e| match self.reference_witness(e) {
            Some(witness) => Some(Shown::Point(witness)),
            None => self.different_multiples(e).map(Shown::CounterProof),
        })?;
        let residual = open.iter().map(|e| (*e).clone()).collect();
        Some(Refutation::new(shown).with_residual(residual))
    }

    /// That the sides hold different multiples of the Dirac distribution of a letter x, where nothing
    /// else in them depends on x: a test function that is one around zero and narrow enough gives
    /// different numbers.
    fn different_multiples(&self, entry: &ResidualEntry) -> Option<CounterProof> {
        let table = self.functions()?;
        let letters = [&entry.left, &entry.right].map(|side| table.letters_behind(side));
        let mut diracs =
            letters
                .iter()
                .flatten()
                .filter_map(|letter| match table.meaning(*letter)? {
                    FunctionLetter::Dirac(argument) => Some((*letter, argument)),
                    FunctionLetter::Pi
                    | FunctionLetter::ImaginaryUnit
                    | FunctionLetter::Exponential(_)
                    | FunctionLetter::Cosine(_)
                    | FunctionLetter::Sine(..)
                    | FunctionLetter::Root(_)
                    | FunctionLetter::Power(..)
                    | FunctionLetter::Logarithm(_)
                    | FunctionLetter::Bound { .. } => None,
                });
        let (dirac, argument) = diracs.next()?;
        if diracs.any(|(other, _)| other != dirac) {
            return None;
        }
        let x = match letters_of([&argument]).into_iter().collect::<Vec<_>>()[..] {
            [x] if argument == RationalFunction::variable(self.model.ring, x) => x,
            _ => return None,
        };
        let zero_is_admitted = match self.model.letters[x] {
            Letter::Symbol { order: 0, .. } => {
                let range = &self.supposed.admitted.ranges[x];
                let zero = BigRational::zero();
                range.numbers == Numbers::Real
                    && range.contains(&zero)
                    && !self.supposed.is_about(x, &|f| table.letters_behind(f))
            }
            _ => false,
        };
        let multiple = |side: &RationalFunction| {
            let multiple = side.derivative(dirac).ok()?;
            let rest = side - &(&multiple * &table.variable(dirac));
            let apart = |f: &RationalFunction| {
                let behind = table.letters_behind(f);
                !behind.contains(&x) && !behind.contains(&dirac)
            };
            (apart(&multiple) && apart(&table.reduce(rest))).then_some(multiple)
        };
        if !zero_is_admitted {
            return None;
        }
        let multiples = self.reference_witness(&ResidualEntry {
            left: multiple(&entry.left)?,
            right: multiple(&entry.right)?,
            ..entry.clone()
        })?;
        Some(CounterProof::Distribution {
            argument: x,
            multiples: Box::new(multiples),
        })
    }

    /// The refutation of a link that names something that does not exist: what is left when it is
    /// read as zero.
    pub(crate) fn refute_outside(
        &mut self,
        equation: usize,
        link: &Link,
        missing: String,
    ) -> Refutation {
        let world = self.exact.world().clone().leniently();
        let exact = self.exact.in_world(world);
        let entries = self.beside(exact).sides(equation, link);
        let mut residual = Vec::new();
        let mut witness = None;
        if let Ok(entries) = entries {
            let open: Vec<&ResidualEntry> = entries.iter().filter(|e| e.left != e.right).collect();
            let all = self.insertion(&self.inserted.keys().copied().collect::<Vec<_>>());
            let functions = self.functions();
            let expanded = super::identity::insert(&open, &all, functions).unwrap_or_default();
            let as_zero = self.refutation(&open, &expanded);
            witness = as_zero.and_then(|r| r.witness().cloned());
            residual = open.into_iter().cloned().collect();
        }
        Refutation::by_structure(Structure::Missing {
            name: missing,
            read_as_zero: witness.map(Box::new),
        })
        .with_residual(residual)
    }

    /// A point in the declared symbols: their reference values where these tell the sides apart,
    /// otherwise small numbers that their ranges admit.
    fn reference_witness(&self, entry: &ResidualEntry) -> Option<Witness> {
        let reference = |letter: usize| match self.model.letters[letter] {
            Letter::Symbol { symbol, order: 0 } => self.model.symbols[symbol].value.clone(),
            _ => None,
        };
        if self.supposed.in_force {
            return self.supposed_witness(entry);
        }
        (0..TRIES).find_map(|k| {
            self.witness_at(entry, |letter, position| {
                let small = || self.admissible_number(letter, position, k.max(1));
                if k == 0 {
                    reference(letter).unwrap_or_else(small)
                } else {
                    small()
                }
            })
        })
    }

    /// A small number that a letter's range admits, different for neighbouring letters and for each
    /// try.
    fn admissible_number(&self, letter: usize, position: usize, attempt: u32) -> BigRational {
        // Fractions too, each letter on its own tries.
        let number = match (attempt >> (1 + position % 3)) % 2 {
            0 => small(position, attempt),
            _ => small(position, attempt + 1).recip(),
        };
        let Letter::Symbol { symbol, order: 0 } = self.model.letters[letter] else {
            return number;
        };
        self.model.symbols[symbol].range.near(&number, attempt)
    }

    /// A point in the printed letters, abbreviations taken as free.
    pub(crate) fn free_witness(&self, entry: &ResidualEntry) -> Option<Witness> {
        (1..=TRIES).find_map(|k| {
            self.witness_at(entry, |letter, position| {
                self.admitted_value(letter, small(position, k), k)
            })
        })
    }

    /// A value that a letter may have: this one if it may.
    fn admitted_value(&self, letter: usize, value: BigRational, number: u32) -> BigRational {
        match self.supposed.admitted.ranges.get(letter) {
            Some(range) if !range.contains(&value) => range.sample(number as usize),
            _ => value,
        }
    }

    /// Whether a letter stands for a function.
    pub(crate) fn is_function(&self, letter: usize) -> bool {
        matches!(self.model.letters[letter], Letter::Function { .. })
    }

    /// Whether no point may choose the value of a letter: that of a function, or an eigenvalue of what
    /// the document defines.
    pub(super) fn is_no_choice(&self, letter: usize) -> bool {
        match self.model.letters[letter] {
            Letter::Symbol { symbol, .. } => self.model.is_spectrum(symbol),
            _ => self.is_function(letter),
        }
    }

    /// Whether a letter is a declared symbol with a reference value.
    pub(crate) fn has_reference(&self, letter: usize) -> bool {
        match self.model.letters[letter] {
            Letter::Symbol { symbol, order: 0 } => self.model.symbols[symbol].value.is_some(),
            _ => false,
        }
    }

    /// Whether a function of the declared symbols is positive, or not negative, at so many points,
    /// of which some are negative in the letters that may be so; false where none has a value.
    pub(crate) fn is_positive_at(&self, f: &RationalFunction, points: u32, strict: bool) -> bool {
        let mut seen = false;
        (0..points).all(|k| {
            let point: Vec<BigRational> = (0..self.model.letters.len())
                .map(|letter| {
                    // From far below one to far above.
                    let scale = BigInt::from(1_u32 << ((7 * k as usize + 3 * letter) % 13));
                    let value = small(letter, k) * BigRational::new(scale, 64.into());
                    let flipped = !self.model.is_positive(letter) && (k >> (letter % 5)) % 2 == 1;
                    if flipped { -value } else { value }
                })
                .collect();
            match f.evaluate(&point) {
                Ok(value) => {
                    seen = true;
                    value.is_positive() || !strict && value.is_zero()
                }
                // A pole says nothing.
                Err(_) => true,
            }
        }) && seen
    }

    /// A value for each letter: the reference values of the declared symbols where they have any,
    /// small integers for the others, and for the abbreviations what their definitions say.
    pub(crate) fn reference_point(&self) -> Vec<BigRational> {
        let mut point: Vec<BigRational> = (0..self.model.letters.len())
            .map(|letter| match self.model.letters[letter] {
                Letter::Symbol { symbol, order: 0 } => self.model.symbols[symbol]
                    .value
                    .clone()
                    .unwrap_or_else(|| self.admitted_value(letter, small(letter, 1), 0)),
                _ => self.admitted_value(letter, small(letter, 1), 0),
            })
            .collect();
        for (letter, value) in self.inserted.iter() {
            if let Ok(value) = value.evaluate(&point) {
                point[*letter] = value;
            }
        }
        point
    }

    pub(super) fn witness_at(
        &self,
        entry: &ResidualEntry,
        value: impl Fn(usize, usize) -> BigRational,
    ) -> Option<Witness> {
        let letters = match self.functions() {
            Some(table) => [&entry.left, &entry.right]
                .iter()
                .flat_map(|side| table.letters_behind(side))
                .collect(),
            None => letters_of([&entry.left, &entry.right]),
        };
        let mut point = vec![None; self.model.letters.len()];
        let mut shown = Vec::new();
        for (position, letter) in letters.into_iter().enumerate() {
            if matches!(self.model.letters[letter], Letter::Function { .. }) {
                continue;
            }
            let value = value(letter, position);
            shown.push((letter, PointValue::Exact(value.clone())));
            point[letter] = Some(value);
        }
        self.make_definite(&mut point, &mut shown);
        let left = self.certain_value(&entry.left, &point)?;
        let right = self.certain_value(&entry.right, &point)?;
        left.is_apart_from(&right).then_some(Witness {
            point: shown,
            left,
            right,
            place: entry.place,
            indices: entry.indices.clone(),
        })
    }

    /// The value of an element at a point: a rational number, or numbers that are proved to enclose
    /// it; none where it has no value there.
    pub(crate) fn certain_value(
        &self,
        f: &RationalFunction,
        point: &[Option<BigRational>],
    ) -> Option<PointValue> {
        if let Some(value) = self.value_at(f, point) {
            return Some(PointValue::Exact(value));
        }
        let table = self.functions()?;
        let enclosed = |f: &RationalFunction| match self.value_at(f, point) {
            Some(value) => Some(PointValue::Exact(value)),
            None => {
                let interval = table.enclosure(f, point)?;
                Some(PointValue::Between(interval.low, interval.high))
            }
        };
        if let Some(real) = enclosed(f) {
            return Some(real);
        }
        let (real, imaginary) = table.real_and_imaginary(f).ok()?;
        let (real, imaginary) = (enclosed(&real)?, enclosed(&imaginary)?);
        Some(PointValue::Complex(Box::new([real, imaginary])))
    }
}

impl Checker<'_> {
    /// Raises the diagonals of matrices that are declared positive definite until they dominate their
    /// rows, so that the point is one where the hypotheses hold.
    pub(super) fn make_definite(
        &self,
        point: &mut [Option<BigRational>],
        shown: &mut [(usize, PointValue)],
    ) {
        let instance = &self.model.instances[self.instance];
        for matrix in &self.model.matrices {
            if !matrix.shape.positive_definite {
                continue;
            }
            let (order, _) = matrix.shape_in(instance);
            let letter = |i: usize, j: usize| match matrix.entry(i, j) {
                MatrixEntry::Symbol(symbol) => self.model.letter_of_symbol(symbol, 0),
                _ => None,
            };
            for i in 0..order {
                let others = (0..order).filter(|j| *j != i).filter_map(|j| letter(i, j));
                let sum: BigRational = others
                    .filter_map(|l| point[l].as_ref().map(Signed::abs))
                    .sum();
                if let Some(diagonal) = letter(i, i)
                    && let Some(value) = &mut point[diagonal]
                {
                    *value = value.abs() + sum;
                    if let Some((_, known)) = shown.iter_mut().find(|(l, _)| *l == diagonal) {
                        *known = PointValue::Exact(value.clone());
                    }
                }
            }
        }
    }
}

impl Refutation {
    /// The refutation by a failure whose shapes do not fit, if it is one: there is no residual.
    pub(crate) fn of_misfit(failure: &Failure) -> Option<Refutation> {
        let misfit = failure.misfit()?;
        Some(Refutation::by_structure(Structure::Misfit(misfit)))
    }
}

impl Checker<'_> {
    /// The rational value of an element at a point, where it has one: functions count only where
    /// they are rational themselves.
    pub(crate) fn value_at(
        &self,
        f: &RationalFunction,
        point: &[Option<BigRational>],
    ) -> Option<BigRational> {
        match self.functions() {
            Some(table) => table.rational_value(f, point),
            None => {
                let known = |v: &Option<BigRational>| v.clone().unwrap_or_else(BigRational::zero);
                f.evaluate(&point.iter().map(known).collect::<Vec<_>>())
                    .ok()
            }
        }
    }
}

/// Small positive integers, different for neighbouring letters and for each try.
fn small(position: usize, attempt: u32) -> BigRational {
    let position = u32::try_from(position % 1000).unwrap_or(0);
    let value = 1 + (position * (attempt + 1) + attempt * attempt) % (7 + 2 * attempt);
    BigRational::from_integer(BigInt::from(value))
}
