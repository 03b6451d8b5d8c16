//! What comes of a comparison, and how a point that shows a relation false is written.

use super::failure::NoValue;
use crate::expr::{Name, Relation};
use crate::matrix::Matrix;
use crate::model::Model;
use crate::real::decimal::complex_digits;
use crate::real::{Complex, Real};

/// The most binary digits of a number that is written.
const LONGEST: u64 = 1 << 16;

/// What a link's sides are at a point.
#[derive(Clone, Debug)]
pub enum Comparison {
    /// The relation certainly is violated.
    Apart(Box<Shown>),
    /// Nothing contradicts it.
    Overlap {
        /// Whether the sides agree to many digits, or certainly stand in the relation.
        narrow: bool,
    },
    /// A side has no value, or none was found.
    NoValue(NoValue),
}

/// A point that shows a relation false.
#[derive(Clone, Debug)]
pub struct Shown {
    /// The letters that the sides were computed from: symbol, order of its derivative, value.
    pub letters: Vec<(usize, u8, Complex)>,
    /// The running indices.
    pub indices: Vec<(String, i64)>,
    /// Row and column from 1 of an entry that shows it; none for scalars and for definiteness.
    pub entry: Option<(usize, usize)>,
    /// The left side, or its entry.
    pub left: Complex,
    /// The right side, or its entry.
    pub right: Complex,
    /// The relation that is violated.
    pub relation: Relation,
    /// Where both sides are matrices in a relation of order, their difference; the matrix of a claim
    /// about eigenvalues, of which `left` then is the Hurwitz determinant that is not positive.
    pub matrix: Option<Matrix<Complex>>,
}

impl Shown {
    /// The names of the letters with their values: exact, or with digits that are proved.
    pub fn point(&self, model: &Model, digits: usize) -> Vec<(Name, String)> {
        let named = |(symbol, order, value): &(usize, u8, Complex)| {
            let mut name = model.symbols[*symbol].name.clone();
            name.dots = name.dots.saturating_add(*order);
            (name, shown(value, digits))
        };
        self.letters.iter().map(named).collect()
    }

    /// Both sides, exact or with digits that are proved: as many as there are up to `digits`.
    pub fn sides(&self, digits: usize) -> [String; 2] {
        [shown(&self.left, digits), shown(&self.right, digits)]
    }

    /// Whether all its numbers have so few digits that they can be written.
    pub fn can_be_written(&self) -> bool {
        let matrix = self.matrix.iter().flat_map(Matrix::iter);
        let sides = [&self.left, &self.right].into_iter().chain(matrix);
        let letters = self.letters.iter().map(|(_, _, z)| z);
        sides.chain(letters).all(|z| {
            let mut parts = [&z.re, &z.im].into_iter();
            parts.all(|x| x.length() <= LONGEST)
        })
    }

    /// Whether every letter of the point has a rational value.
    pub fn is_rational(&self) -> bool {
        let exact = |x: &Real| x.exact().is_some();
        self.letters
            .iter()
            .all(|(_, _, z)| exact(&z.re) && exact(&z.im))
    }
}

/// A number with proved digits; between which numbers it lies where not even one is.
fn shown(z: &Complex, digits: usize) -> String {
    complex_digits(z, digits).unwrap_or_else(|| {
        let part = |x: &Real| match x {
            Real::Exact(x) => x.to_string(),
            Real::Enclosed(x) => {
                let size = x.largest().magnitude().unwrap_or(0);
                format!("within 2^{size} of 0")
            }
        };
        if z.is_real() {
            part(&z.re)
        } else {
            format!("{} and {} i", part(&z.re), part(&z.im))
        }
    })
}
