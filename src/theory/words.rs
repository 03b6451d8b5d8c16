//! Matrix identities of any size: the normal form of noncommutative polynomials in matrix letters.
//!
//! A product of matrix letters is a word; a matrix is a sum of words with scalar coefficients. Two
//! expressions with the same normal form are equal for whatever sizes the letters have, since only
//! these rules are used: sums and products are associative and distributive, scalars commute with
//! everything, (A B)^T = B^T A^T, a symmetric letter is its transpose and a skew one its opposite, a
//! product of one row and one column is a scalar and equals its transpose, a trace does not change under
//! rotation and transposition, and det(A B) = det A det B for square letters. The converse does not
//! hold: what has two normal forms may be equal all the same.
//!
//! Invariants: a word between two places of size one has been taken out as a scalar; factors of
//! symmetric and skew letters are never transposed; no coefficient is zero.

use num_rational::BigRational;
use num_traits::{One, Zero};
use std::collections::BTreeMap;

/// More terms than these are not multiplied out.
const MOST_TERMS: usize = 2_000;

/// A number of rows or columns: a multiple of a letter, or a number where there is none.
pub type Size = (usize, Option<String>);

fn is_one(size: &Size) -> bool {
    *size == (1, None)
}

/// What is known of a matrix letter.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Symmetry {
    /// Nothing.
    General,
    /// It is its transpose.
    Symmetric,
    /// It is minus its transpose.
    Skew,
}

/// A matrix letter, or its transpose, in a word.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
struct Factor {
    letter: usize,
    transposed: bool,
}

type Word = Vec<Factor>;

/// What a scalar is made of.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Atom {
    /// A letter of the caller's.
    Letter(usize),
    /// A letter for a size.
    Size(String),
    /// A product of one row and one column.
    Product(Word),
    /// The trace of a word.
    Trace(Word),
    /// The determinant of a letter.
    Determinant(usize),
}

/// A polynomial in atoms: exponents by atom, with a coefficient.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Scalar(BTreeMap<BTreeMap<Atom, u32>, BigRational>);

/// A scalar, a matrix or the zero of any shape, in normal form.
#[derive(Clone, Debug, PartialEq)]
pub enum Form {
    /// A scalar.
    Scalar(Scalar),
    /// A matrix: its rows, its columns and its words.
    Matrix(Size, Size, Terms),
    /// Zero of any shape.
    Zero,
}

/// Words with their coefficients.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Terms(BTreeMap<Word, Scalar>);

impl Scalar {
    /// A number.
    pub fn number(value: BigRational) -> Self {
        let mut scalar = Scalar::default();
        scalar.add(BTreeMap::new(), value);
        scalar
    }

    /// A letter of the caller's.
    pub fn letter(letter: usize) -> Self {
        Scalar::atom(Atom::Letter(letter))
    }

    /// A size.
    pub fn size((factor, letter): &Size) -> Self {
        let factor = Scalar::number(BigRational::from_integer((*factor).into()));
        match letter {
            Some(letter) => factor.times(&Scalar::atom(Atom::Size(letter.clone()))),
            None => factor,
        }
    }

    fn atom(atom: Atom) -> Self {
        let mut scalar = Scalar::default();
        scalar.add(BTreeMap::from([(atom, 1)]), BigRational::one());
        scalar
    }

    fn add(&mut self, monomial: BTreeMap<Atom, u32>, coefficient: BigRational) {
        let sum = self.0.remove(&monomial).unwrap_or_else(BigRational::zero) + coefficient;
        if !sum.is_zero() {
            self.0.insert(monomial, sum);
        }
    }

    fn plus(&self, other: &Scalar) -> Scalar {
        let mut sum = self.clone();
        for (monomial, coefficient) in &other.0 {
            sum.add(monomial.clone(), coefficient.clone());
        }
        sum
    }

    fn times(&self, other: &Scalar) -> Scalar {
        let mut product = Scalar::default();
        for (m, a) in &self.0 {
            for (n, b) in &other.0 {
                let mut monomial = m.clone();
                for (atom, exponent) in n {
                    *monomial.entry(atom.clone()).or_default() += exponent;
                }
                product.add(monomial, a * b);
            }
        }
        product
    }

    /// Its value, if it is a number.
    fn as_number(&self) -> Option<BigRational> {
        match self.0.len() {
            0 => Some(BigRational::zero()),
            1 => self.0.get(&BTreeMap::new()).cloned(),
            _ => None,
        }
    }
}

/// The letters with their sizes and symmetries.
#[derive(Clone, Debug, Default)]
pub struct Alphabet {
    letters: Vec<(Size, Size, Symmetry)>,
}

impl Alphabet {
    /// A new letter, and it as a matrix.
    pub fn letter(&mut self, rows: Size, columns: Size, symmetry: Symmetry) -> usize {
        self.letters.push((rows, columns, symmetry));
        self.letters.len() - 1
    }

    /// A letter as a matrix.
    pub fn matrix(&self, letter: usize) -> Form {
        let (rows, columns, _) = self.letters[letter].clone();
        let factor = Factor {
            letter,
            transposed: false,
        };
        self.single(
            rows,
            columns,
            vec![factor],
            Scalar::number(BigRational::one()),
        )
    }

    /// The unit matrix.
    pub fn identity(&self, size: Size) -> Form {
        let one = Scalar::number(BigRational::one());
        self.single(size.clone(), size, Vec::new(), one)
    }

    fn rows<'s>(&'s self, factor: &Factor) -> &'s Size {
        let (rows, columns, _) = &self.letters[factor.letter];
        if factor.transposed { columns } else { rows }
    }

    fn columns<'s>(&'s self, factor: &Factor) -> &'s Size {
        let (rows, columns, _) = &self.letters[factor.letter];
        if factor.transposed { rows } else { columns }
    }

    /// A word with its scalar parts taken out, as a matrix or, where it has one row and one
    /// column, a scalar.
    fn single(&self, rows: Size, columns: Size, word: Word, coefficient: Scalar) -> Form {
        let (word, coefficient) = self.taken_out(word, coefficient);
        if is_one(&rows) && is_one(&columns) {
            return Form::Scalar(match word.is_empty() {
                true => coefficient,
                false => coefficient.times(&self.product(word)),
            });
        }
        let mut terms = Terms::default();
        if !coefficient.0.is_empty() {
            terms.0.insert(word, coefficient);
        }
        Form::Matrix(rows, columns, terms)
    }

    /// Takes the parts between two places of size one out of a word, but not the whole word.
    fn taken_out(&self, mut word: Word, mut coefficient: Scalar) -> (Word, Scalar) {
        loop {
            // Place i is the one before factor i.
            let mut ones: Vec<usize> = Vec::new();
            for (i, factor) in word.iter().enumerate() {
                if is_one(self.rows(factor)) {
                    ones.push(i);
                }
            }
            if word.last().is_some_and(|last| is_one(self.columns(last))) {
                ones.push(word.len());
            }
            let whole = |from: usize, to: usize| from == 0 && to == word.len();
            let Some(pair) = ones.windows(2).find(|p| !whole(p[0], p[1])) else {
                return (word, coefficient);
            };
            let (from, to) = (pair[0], pair[1]);
            let inner: Word = word.drain(from..to).collect();
            coefficient = coefficient.times(&self.product(inner));
        }
    }

    /// The transposed word, and whether it changes its sign.
    fn transposed(&self, word: &Word) -> (Word, bool) {
        let mut negative = false;
        let turned = word.iter().rev().map(|factor| {
            let transposed = match self.letters[factor.letter].2 {
                Symmetry::General => !factor.transposed,
                Symmetry::Symmetric => false,
                Symmetry::Skew => {
                    negative = !negative;
                    false
                }
            };
            Factor {
                letter: factor.letter,
                transposed,
            }
        });
        (turned.collect(), negative)
    }

    /// A word of one row and one column.
    fn product(&self, word: Word) -> Scalar {
        let (turned, negative) = self.transposed(&word);
        self.chosen(vec![(word, false), (turned, negative)], Atom::Product)
    }

    /// The least of several ways to write the same, up to sign; zero where it is its own opposite.
    fn chosen(&self, ways: Vec<(Word, bool)>, atom: impl Fn(Word) -> Atom) -> Scalar {
        let Some((least, negative)) = ways.iter().min().cloned() else {
            return Scalar::default();
        };
        if ways.contains(&(least.clone(), !negative)) {
            return Scalar::default();
        }
        let sign = BigRational::from_integer(if negative { -1 } else { 1 }.into());
        Scalar::number(sign).times(&Scalar::atom(atom(least)))
    }

    /// The sum; none where the shapes do not fit.
    pub fn plus(&self, left: &Form, right: &Form) -> Option<Form> {
        Some(match (left, right) {
            (Form::Zero, other) | (other, Form::Zero) => other.clone(),
            (Form::Scalar(a), Form::Scalar(b)) => Form::Scalar(a.plus(b)),
            (Form::Matrix(rows, columns, a), Form::Matrix(r, c, b))
                if (rows, columns) == (r, c) =>
            {
                let mut sum = a.clone();
                for (word, coefficient) in &b.0 {
                    sum.add(word.clone(), coefficient);
                }
                Form::Matrix(rows.clone(), columns.clone(), sum)
            }
            _ => return None,
        })
    }

    /// A multiple.
    pub fn scaled(&self, form: &Form, factor: &Scalar) -> Form {
        match form {
            Form::Zero => Form::Zero,
            Form::Scalar(s) => Form::Scalar(s.times(factor)),
            Form::Matrix(rows, columns, terms) => {
                let mut scaled = Terms::default();
                for (word, coefficient) in &terms.0 {
                    scaled.add(word.clone(), &coefficient.times(factor));
                }
                Form::Matrix(rows.clone(), columns.clone(), scaled)
            }
        }
    }

    /// The product; none where the shapes do not fit, or it has too many terms.
    pub fn times(&self, left: &Form, right: &Form) -> Option<Form> {
        match (left, right) {
            (Form::Zero, _) | (_, Form::Zero) => Some(Form::Zero),
            (Form::Scalar(s), other) | (other, Form::Scalar(s)) => {
                (size(other) * s.0.len() <= MOST_TERMS).then(|| self.scaled(other, s))
            }
            (Form::Matrix(rows, inner, a), Form::Matrix(own, columns, b)) => {
                if inner != own || size(left) * size(right) > MOST_TERMS {
                    return None;
                }
                let mut sum = match (is_one(rows), is_one(columns)) {
                    (true, true) => Form::Scalar(Scalar::default()),
                    _ => Form::Matrix(rows.clone(), columns.clone(), Terms::default()),
                };
                for (v, s) in &a.0 {
                    for (w, t) in &b.0 {
                        let word = v.iter().chain(w).cloned().collect();
                        let term = self.single(rows.clone(), columns.clone(), word, s.times(t));
                        sum = self.plus(&sum, &term)?;
                    }
                }
                Some(sum)
            }
        }
    }

    /// The transpose.
    pub fn transpose(&self, form: &Form) -> Form {
        let Form::Matrix(rows, columns, terms) = form else {
            return form.clone();
        };
        let mut turned = Terms::default();
        for (word, coefficient) in &terms.0 {
            let (word, negative) = self.transposed(word);
            let sign = BigRational::from_integer(if negative { -1 } else { 1 }.into());
            turned.add(word, &coefficient.times(&Scalar::number(sign)));
        }
        Form::Matrix(columns.clone(), rows.clone(), turned)
    }

    /// The trace; none of what is not square.
    pub fn trace(&self, form: &Form) -> Option<Form> {
        let (rows, terms) = match form {
            Form::Scalar(_) => return Some(form.clone()),
            Form::Matrix(rows, columns, terms) if rows == columns => (rows, terms),
            Form::Matrix(..) | Form::Zero => return None,
        };
        let mut sum = Scalar::default();
        for (word, coefficient) in &terms.0 {
            let trace = match word.iter().position(|f| is_one(self.rows(f))) {
                _ if word.is_empty() => Scalar::size(rows),
                // tr(x y^T) = y^T x.
                Some(at) => {
                    let rotated = [&word[at..], &word[..at]].concat();
                    let one = Scalar::number(BigRational::one());
                    let (word, inner) = self.taken_out(rotated, one);
                    inner.times(&self.product(word))
                }
                None => {
                    let (turned, negative) = self.transposed(word);
                    let mut ways = Vec::new();
                    for (word, negative) in [(word, false), (&turned, negative)] {
                        for at in 0..word.len() {
                            ways.push(([&word[at..], &word[..at]].concat(), negative));
                        }
                    }
                    self.chosen(ways, Atom::Trace)
                }
            };
            sum = sum.plus(&coefficient.times(&trace));
        }
        Some(Form::Scalar(sum))
    }

    /// The determinant of a product of square letters; none of anything else.
    pub fn determinant(&self, form: &Form) -> Option<Form> {
        let Form::Matrix(rows, columns, terms) = form else {
            return None;
        };
        let mut only = terms.0.iter();
        let (Some((word, coefficient)), None) = (only.next(), only.next()) else {
            return None;
        };
        // A factor would come out as often as there are rows.
        if rows != columns || !coefficient.as_number()?.is_one() {
            return None;
        }
        let mut product = Scalar::number(BigRational::one());
        for factor in word {
            if self.rows(factor) != self.columns(factor) {
                return None;
            }
            product = product.times(&Scalar::atom(Atom::Determinant(factor.letter)));
        }
        Some(Form::Scalar(product))
    }

    /// The quotient by a number that is not zero; none by anything else.
    pub fn divided(&self, form: &Form, by: &Form) -> Option<Form> {
        let Form::Scalar(by) = by else { return None };
        let number = by.as_number().filter(|n| !n.is_zero())?;
        Some(self.scaled(form, &Scalar::number(number.recip())))
    }
}

impl Terms {
    fn add(&mut self, word: Word, coefficient: &Scalar) {
        let sum = match self.0.remove(&word) {
            Some(known) => known.plus(coefficient),
            None => coefficient.clone(),
        };
        if !sum.0.is_empty() {
            self.0.insert(word, sum);
        }
    }
}

impl Form {
    /// A number.
    pub fn number(value: BigRational) -> Self {
        Form::Scalar(Scalar::number(value))
    }

    /// Whether it is zero for all sizes.
    pub fn is_zero(&self) -> bool {
        match self {
            Form::Zero => true,
            Form::Scalar(s) => s.0.is_empty(),
            Form::Matrix(_, _, terms) => terms.0.is_empty(),
        }
    }
}

/// How many terms a form has.
fn size(form: &Form) -> usize {
    match form {
        Form::Zero => 0,
        Form::Scalar(s) => s.0.len(),
        Form::Matrix(_, _, terms) => terms.0.values().map(|s| s.0.len()).sum(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn f() -> Size {
        (1, Some("f".into()))
    }

    fn one() -> Size {
        (1, None)
    }

    #[test]
    fn words_obey_the_rules_and_no_others() {
        let mut letters = Alphabet::default();
        let [m, k] = [0, 1].map(|_| letters.letter(f(), f(), Symmetry::General));
        let s = letters.letter(f(), f(), Symmetry::Symmetric);
        let g = letters.letter(f(), f(), Symmetry::Skew);
        let x = letters.letter(f(), one(), Symmetry::General);
        let [m, k, s, g, x] = [m, k, s, g, x].map(|l| letters.matrix(l));
        let times = |a: &Form, b: &Form| letters.times(a, b).unwrap();
        let turned = |a: &Form| letters.transpose(a);
        assert_eq!(turned(&times(&m, &k)), times(&turned(&k), &turned(&m)));
        assert_ne!(times(&m, &k), times(&k, &m));
        assert_eq!(turned(&s), s);
        assert_ne!(turned(&m), m);
        // x^T M x = x^T M^T x, x^T G x = 0.
        let form = |a: &Form| times(&times(&turned(&x), a), &x);
        assert_eq!(form(&m), form(&turned(&m)));
        assert_ne!(form(&m), form(&k));
        assert!(form(&g).is_zero() && !form(&s).is_zero());
        // (x x^T) x = (x^T x) x.
        let square = times(&turned(&x), &x);
        assert_eq!(times(&times(&x, &turned(&x)), &x), times(&square, &x));
        // Traces.
        let trace = |a: &Form| letters.trace(a).unwrap();
        assert_eq!(trace(&times(&m, &k)), trace(&times(&k, &m)));
        assert_eq!(
            trace(&times(&times(&m, &k), &s)),
            trace(&times(&times(&s, &m), &k))
        );
        assert_ne!(
            trace(&times(&times(&m, &k), &s)),
            trace(&times(&times(&k, &m), &s))
        );
        assert_eq!(trace(&times(&x, &turned(&x))), square);
        assert!(trace(&g).is_zero() && trace(&times(&g, &s)).is_zero());
        assert!(!trace(&times(&g, &g)).is_zero());
        assert_eq!(
            trace(&letters.identity(f())),
            Form::Scalar(Scalar::size(&f()))
        );
        // Determinants of products, and of nothing that brings out a power of the size.
        let determinant = |a: &Form| letters.determinant(a);
        assert_eq!(determinant(&times(&m, &k)), determinant(&times(&k, &m)));
        assert_eq!(determinant(&turned(&m)), determinant(&m));
        let minus = letters.scaled(&m, &Scalar::number(BigRational::from_integer((-1).into())));
        assert_eq!(determinant(&minus), None);
        assert_eq!(determinant(&letters.plus(&m, &k).unwrap()), None);
        assert_eq!(determinant(&times(&x, &turned(&x))), None);
    }
}
