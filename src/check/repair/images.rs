//! The images of exact values modulo the prime, at a random point of the declared letters.
//!
//! A function's letter has an image that keeps its relations: a root the square root of its
//! radicand's image where that is a square, a cosine and its sine a rational point of the circle;
//! exponentials, powers and logarithms are free. The imaginary unit is a root of minus one.

use crate::domain::{Domain, PRIME, PrimeField};
use crate::evaluate::FailureKind;
use crate::functions::{FunctionLetter, FunctionTable};
use ratpoly::RationalFunction;
use std::cell::RefCell;
use std::collections::BTreeMap;

/// Random residues, the same every time.
pub(super) struct SplitMix(pub u64);

impl SplitMix {
    /// SplitMix64 (Steele, Lea & Flood 2014).
    pub fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        (z ^ (z >> 31)) % PRIME
    }
}

/// A point: the images of the letters, those of functions as they are asked for.
pub(super) struct Images {
    table: Option<FunctionTable>,
    point: Vec<u64>,
    functions: RefCell<BTreeMap<usize, Option<u64>>>,
    seed: u64,
}

impl Images {
    /// One of the random points, with these definitions inserted.
    pub fn new(
        letters: usize,
        inserted: &BTreeMap<usize, RationalFunction>,
        table: Option<FunctionTable>,
        point: u64,
    ) -> Self {
        let seed = 0x9E37_79B9_7F4A_7C15 ^ point.wrapping_mul(0xD1B5_4A32_D192_ED03);
        let mut random = SplitMix(seed);
        let mut images = Images {
            table,
            point: (0..letters).map(|_| random.next()).collect(),
            functions: RefCell::default(),
            seed,
        };
        for (letter, value) in inserted {
            if let Ok(image) = images.image(value) {
                images.point[*letter] = image;
            }
        }
        images
    }

    /// The images of the letters that stand for no function.
    pub fn point(&self) -> &[u64] {
        &self.point
    }

    /// The image of an exact value.
    ///
    /// # Errors
    /// Where a divisor vanishes or a function has no image.
    pub fn image(&self, value: &RationalFunction) -> Result<u64, FailureKind> {
        let Some(table) = &self.table else {
            let image = PrimeField.image(value, &self.point);
            return image.ok_or(FailureKind::DivisionByZero);
        };
        let mut point = self.point.clone();
        let mut letters = value.numerator().variables_occurring();
        letters.extend(value.denominator().variables_occurring());
        for letter in letters {
            if let Some(meaning) = table.meaning(letter) {
                let image = self.of_function(letter, &meaning);
                point[letter] = image.ok_or(FailureKind::Unsupported {
                    what: "a function without an image modulo the prime".into(),
                })?;
            }
        }
        let image = PrimeField.image(value, &point);
        image.ok_or(FailureKind::DivisionByZero)
    }

    fn of_function(&self, letter: usize, meaning: &FunctionLetter) -> Option<u64> {
        if let Some(known) = self.functions.borrow().get(&letter) {
            return *known;
        }
        let free = SplitMix(self.seed ^ (letter as u64).wrapping_mul(0xA24B_AED4_963E_E407)).next();
        let field = PrimeField;
        let table = self.table.as_ref()?;
        if let Some(finer) = table.in_finer_letters(letter) {
            // Other elements may hold the finer letter: its image decides.
            return self.image(&finer).ok();
        }
        let image = match meaning {
            FunctionLetter::ImaginaryUnit => field.square_root(PRIME - 1),
            FunctionLetter::Dirac(_) => None,
            FunctionLetter::Root(radicand) => {
                let square = self.image(&RationalFunction::from(radicand.clone())).ok();
                square.and_then(|square| field.square_root(square))
            }
            // (1 - t^2)/(1 + t^2), so that the sine is rational too.
            FunctionLetter::Cosine(_) => {
                let square = field.multiply(&free, &free);
                field.divide(&field.subtract(&1, &square), &field.add(&1, &square))
            }
            FunctionLetter::Sine(_, cosine) => {
                let table = self.table.as_ref()?;
                let cosine = self.of_function(*cosine, &table.meaning(*cosine)?)?;
                field.square_root(field.subtract(&1, &field.multiply(&cosine, &cosine)))
            }
            FunctionLetter::Pi
            | FunctionLetter::Exponential(_)
            | FunctionLetter::Power(..)
            | FunctionLetter::Logarithm(_)
            | FunctionLetter::Bound { .. } => Some(free),
        };
        self.functions.borrow_mut().insert(letter, image);
        image
    }
}
