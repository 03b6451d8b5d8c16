//! A point: a value for every letter, drawn by a rule that depends on nothing but the letter, the
//! number of the point and what the document declares of the letter.
//!
//! Values are rational, but for letters that an equation between them determines. A positive definite
//! matrix is drawn as L L^T, a process as a free jet: its value and its derivatives independently. The
//! first points are small and positive, then come the reference values, both signs, zeros and ones, large
//! and small numbers.

use super::apply::Truth;
use crate::model::Model;
use crate::model::range::{Numbers, Range};
use crate::real::{Complex, Real};
use num_rational::BigRational;
use num_traits::{Signed, Zero};
use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;

/// The highest derivative of a process that has a value.
const HIGHEST_ORDER: u8 = 24;
/// Numerators of small numbers.
const PRIMES: [i64; 16] = [2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31, 37, 41, 43, 47, 53];

/// How the letters of a point are drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Style {
    Positive,
    Reference,
    Mixed,
    Negative,
    Zero,
    Special,
    Scales,
    Small,
}

/// Values for all letters of a model.
#[derive(Clone, Debug)]
pub struct Point {
    number: usize,
    ranges: Arc<Vec<Range>>,
    /// Whether these ranges are those that the document declares.
    declared: bool,
    fixed: BTreeMap<(usize, u8), Complex>,
    /// The highest derivative of a process whose derivatives an equation determines.
    highest: BTreeMap<usize, u8>,
    /// Whether equations between letters must be seen to be exactly true.
    pub(super) verify: bool,
    /// What equations between letters are about.
    pub(super) tangle: Arc<Tangle>,
}

/// The symbols that hypotheses tie to each other.
#[derive(Clone, Debug, Default)]
pub(super) struct Tangle {
    /// Those of any equation: a derivative by one of them is not what it is without the equation.
    pub symbols: BTreeSet<usize>,
    /// Those that an equation ties to the time, though they are declared constant.
    pub moving: BTreeSet<usize>,
}

/// A number that depends on these and looks random (G. L. Steele, D. Lea & C. H. Flood, *Fast splittable
/// pseudorandom number generators*, 2014).
fn mixed(parts: [usize; 4]) -> u64 {
    let mut z = 0x9e37_79b9_7f4a_7c15u64;
    for part in parts {
        z = z
            .wrapping_add(part as u64)
            .wrapping_add(0x9e37_79b9_7f4a_7c15);
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^= z >> 31;
    }
    z
}

fn ratio(n: i64, d: i64) -> BigRational {
    BigRational::new(n.into(), d.into())
}

fn integer(n: i64) -> BigRational {
    BigRational::from_integer(n.into())
}

impl Point {
    /// The point of a number, with letters in these ranges.
    pub(super) fn new(
        number: usize,
        ranges: Arc<Vec<Range>>,
        declared: bool,
        tangle: Arc<Tangle>,
    ) -> Self {
        Point {
            number,
            ranges,
            declared,
            fixed: BTreeMap::new(),
            highest: BTreeMap::new(),
            verify: false,
            tangle,
        }
    }

    /// The point of a number where letters have the ranges that the document declares.
    pub fn of(model: &Model, number: usize) -> Self {
        let ranges = model.symbols.iter().map(|s| s.range.clone()).collect();
        Point::new(number, Arc::new(ranges), true, Arc::default())
    }

    /// Which point it is, where all letters are drawn as the document declares them.
    pub(super) fn drawn_number(&self) -> Option<usize> {
        let declared = self.declared && self.fixed.is_empty() && self.highest.is_empty();
        (declared && self.tangle.symbols.is_empty()).then_some(self.number)
    }

    /// Which point it is.
    pub fn number(&self) -> usize {
        self.number
    }

    /// The same with another value of a symbol's derivative of an order, 0 for the symbol itself.
    #[must_use]
    pub fn with(mut self, symbol: usize, order: u8, value: Complex) -> Self {
        self.fixed.insert((symbol, order), value);
        self
    }

    /// The same, where equations between letters must be seen to be exactly true.
    pub(super) fn verified_exactly(mut self) -> Self {
        self.verify = true;
        self
    }

    /// Whether the values that were not drawn lie in these ranges.
    pub(super) fn in_ranges(&self, ranges: &[Range]) -> Truth {
        let mut all = Truth::True;
        for ((symbol, order), value) in &self.fixed {
            let range = &ranges[*symbol];
            if range.numbers == Numbers::Complex {
                continue;
            }
            if !value.is_real() {
                all = all.and(Truth::Unknown);
                continue;
            }
            if *order > 0 {
                continue;
            }
            all = all.and(match &value.re {
                Real::Exact(x) if range.contains(x) => Truth::True,
                Real::Exact(_) => Truth::False,
                Real::Enclosed(x) => {
                    let ends = [x.low(), x.high()].map(|end| range.contains(&end.to_rational()));
                    match ends {
                        [true, true] if range.numbers == Numbers::Real => Truth::True,
                        _ => Truth::Unknown,
                    }
                }
            });
        }
        all
    }

    /// The same without derivatives of a process beyond an order.
    pub(super) fn up_to(mut self, symbol: usize, order: u8) -> Self {
        self.highest.insert(symbol, order);
        self
    }

    /// Whether the value of this letter was not drawn but determined.
    pub(super) fn is_fixed(&self, symbol: usize, order: u8) -> bool {
        self.fixed.contains_key(&(symbol, order))
    }

    /// The symbols whose values were determined.
    pub(super) fn fixed_symbols(&self) -> impl Iterator<Item = usize> {
        self.fixed.keys().map(|(symbol, _)| *symbol)
    }

    /// The value of a symbol's derivative of an order, 0 for the symbol itself; none for too high an
    /// order or where no number is admitted.
    pub fn value(&self, model: &Model, symbol: usize, order: u8, _bits: u32) -> Option<Complex> {
        if let Some(value) = self.fixed.get(&(symbol, order)) {
            return Some(value.clone());
        }
        let highest = self.highest.get(&symbol).unwrap_or(&HIGHEST_ORDER);
        if order > *highest {
            return None;
        }
        let declared = &model.symbols[symbol];
        if order == 0
            && let Some((m, i, j)) = declared.entry_of
            && model.matrices[m].shape.positive_definite
        {
            let positive = declared.range.is_positive();
            return Some(Real::rational(self.definite_entry(m, i, j, positive)).into());
        }
        let style = self.style(model);
        let range = &self.ranges[symbol];
        if order > 0 {
            let value = self.plain([symbol, order.into(), self.number, 0], Style::Mixed);
            return Some(Real::rational(value).into());
        }
        if range.numbers == Numbers::Complex {
            let part = |k| Real::rational(self.plain([symbol, k, self.number, 3], Style::Mixed));
            return Some(match self.number % 6 {
                2 => part(0).into(),
                3 => Complex {
                    re: Real::zero(),
                    im: part(1),
                },
                _ => Complex {
                    re: part(0),
                    im: part(1),
                },
            });
        }
        let reference = declared
            .value
            .as_ref()
            .filter(|_| declared.entry_of.is_none());
        let value = match (style, reference) {
            (Style::Reference, Some(value)) if range.contains(value) => value.clone(),
            _ => self.within(range, symbol, style)?,
        };
        // Where processes have values of their own, time does not stand.
        let special = model.has_values_at(&value);
        let value = if special {
            self.within(range, symbol + 7919, Style::Positive)?
        } else {
            value
        };
        Some(Real::rational(value).into())
    }

    fn style(&self, model: &Model) -> Style {
        let has_reference = model.symbols.iter().any(|s| s.value.is_some());
        match self.number {
            0 => Style::Positive,
            1 if has_reference => Style::Reference,
            1 | 2 => Style::Mixed,
            3 => Style::Negative,
            4 => Style::Zero,
            5 => Style::Scales,
            6 => Style::Special,
            n => match n % 5 {
                0 => Style::Special,
                1 => Style::Mixed,
                2 => Style::Small,
                3 => Style::Positive,
                _ => Style::Scales,
            },
        }
    }

    /// A number of a style, whatever the range.
    fn plain(&self, seed: [usize; 4], style: Style) -> BigRational {
        let h = mixed(seed);
        let pick = |shift: u32, n: u64| ((h >> shift) % n) as usize;
        // Neighbouring letters have different numerators.
        let numerator =
            PRIMES[(seed[0] * 5 + 3 * seed[1] + self.number + pick(8, 3)) % PRIMES.len()];
        let negative = pick(40, 2) == 1;
        let signed = |x: BigRational| if negative { -x } else { x };
        match style {
            Style::Positive | Style::Reference => ratio(numerator, 1 + pick(16, 4) as i64),
            Style::Mixed => signed(ratio(numerator, 1 + pick(16, 5) as i64)),
            Style::Negative => -ratio(numerator, 1 + pick(16, 4) as i64),
            Style::Zero => integer(0),
            Style::Special => match pick(16, 8) {
                0 | 1 => integer(0),
                2 | 3 => integer(1),
                4 => integer(-1),
                5 => integer(2),
                6 => ratio(1, 2),
                _ => integer(-2),
            },
            Style::Scales => signed(match pick(16, 4) {
                0 => integer(100 * numerator),
                1 => ratio(numerator, 100),
                2 => integer(numerator),
                _ => ratio(numerator, 7),
            }),
            Style::Small => signed(ratio(numerator, 60 + pick(16, 7) as i64)),
        }
    }

    /// A number of a style within a range; none where there is none.
    fn within(&self, range: &Range, symbol: usize, style: Style) -> Option<BigRational> {
        let integers = range.numbers == Numbers::Integer;
        let seed = [symbol, 0, self.number, 1];
        let mut candidate = self.plain(seed, style);
        if integers {
            candidate = candidate.round();
        }
        if range.contains(&candidate) {
            return Some(candidate);
        }
        let distance = candidate.abs();
        let step = |x: BigRational| if integers { x.ceil() } else { x };
        let found = match (&range.low, &range.high) {
            (None, None) => candidate,
            (Some(low), None) => {
                let from = if integers {
                    low.value.ceil()
                } else {
                    low.value.clone()
                };
                let aside = if low.included {
                    distance
                } else {
                    distance + integer(i64::from(integers))
                };
                let aside = if aside.is_zero() && !low.included {
                    ratio(1, 3)
                } else {
                    aside
                };
                step(from + aside)
            }
            (None, Some(high)) => {
                let from = if integers {
                    high.value.floor()
                } else {
                    high.value.clone()
                };
                let aside = if high.included {
                    distance
                } else {
                    distance + integer(i64::from(integers))
                };
                let aside = if aside.is_zero() && !high.included {
                    ratio(1, 3)
                } else {
                    aside
                };
                from - step(aside)
            }
            (Some(low), Some(high)) => {
                let at_end = style == Style::Special && low.included && high.included;
                let h = mixed(seed);
                let part = match (at_end, h % 4) {
                    (true, 0) => integer(0),
                    (true, 1) => integer(1),
                    _ => ratio(1 + (h >> 8) as i64 % 11, 12),
                };
                let value = &low.value + (&high.value - &low.value) * part;
                if integers {
                    let down = value.floor();
                    [
                        down.clone(),
                        down + integer(1),
                        low.value.ceil(),
                        low.value.floor() + integer(1),
                    ]
                    .into_iter()
                    .find(|v| range.contains(v))?
                } else {
                    value
                }
            }
        };
        range.contains(&found).then_some(found)
    }

    /// An entry of L L^T with a lower triangular matrix L whose diagonal is positive.
    fn definite_entry(&self, matrix: usize, i: usize, j: usize, positive: bool) -> BigRational {
        let lower = |i: usize, k: usize| -> BigRational {
            let h = mixed([matrix, i * 64 + k, self.number, 2]);
            match i.cmp(&k) {
                std::cmp::Ordering::Less => integer(0),
                std::cmp::Ordering::Equal => {
                    ratio(1 + (h >> 8) as i64 % 5, 1 + (h >> 20) as i64 % 2)
                }
                std::cmp::Ordering::Greater => {
                    let n = (h >> 8) as i64 % 7 - 3;
                    ratio(if positive { n.abs() + 1 } else { n }, 2)
                }
            }
        };
        (0..=i.min(j)).map(|k| lower(i, k) * lower(j, k)).sum()
    }
}
