//! The fields in which a document is evaluated.
//!
//! The same evaluation runs over three fields: the rational functions in the document's letters
//! (verdicts), the rational numbers at one point (witnesses, reference data) and the integers
//! modulo a word-sized prime (the filter of the repair search, whose survivors are proved over the
//! first). No floating-point field belongs here: that route is kept apart on purpose.

use crate::functions::{FunctionTable, Functions};
use crate::matrix::Matrix;
use crate::theory::error::TheoryError;
use crate::theory::lyapunov::{self, Lyapunov};
use num_bigint::BigInt;
use num_integer::Integer;
use num_rational::BigRational;
use num_traits::{ToPrimitive, Zero};
use ratpoly::{Budget, Polynomial, RationalFunction, Ring, allowance};
use std::collections::{BTreeMap, BTreeSet};

/// A field with exact equality.
pub trait Domain {
    /// An element in normal form: equal elements are structurally equal.
    type Element: Clone + PartialEq + std::fmt::Debug;

    /// The image of a rational number; `None` where its denominator vanishes in the field.
    fn rational(&self, value: &BigRational) -> Option<Self::Element>;
    /// The image of an integer.
    fn integer(&self, value: i64) -> Self::Element;
    /// Whether the element is zero.
    fn is_zero(&self, element: &Self::Element) -> bool;
    /// Sum.
    fn add(&self, left: &Self::Element, right: &Self::Element) -> Self::Element;
    /// Difference.
    fn subtract(&self, left: &Self::Element, right: &Self::Element) -> Self::Element;
    /// Product.
    fn multiply(&self, left: &Self::Element, right: &Self::Element) -> Self::Element;
    /// Quotient; `None` when the divisor is zero.
    fn divide(&self, left: &Self::Element, right: &Self::Element) -> Option<Self::Element>;
    /// Additive inverse.
    fn negate(&self, element: &Self::Element) -> Self::Element;
    /// Elimination prefers pivots of small size; 0 for fields where all are alike.
    fn size(&self, _element: &Self::Element) -> usize {
        0
    }

    /// The partial derivatives by the letters that occur; `None` over fields without letters.
    fn partial_derivatives(&self, _element: &Self::Element) -> Option<Vec<(usize, Self::Element)>> {
        None
    }

    /// Whether the elements hold letters.
    fn has_letters(&self) -> bool {
        false
    }

    /// The element that a rational function becomes where the letters have these values.
    fn image(
        &self,
        function: &RationalFunction,
        letters: &[Self::Element],
    ) -> Option<Self::Element>;

    /// The solution X of A X + X A^T + Q = 0, and det H of A, whose vanishing ends its uniqueness.
    ///
    /// # Errors
    /// Where X is not unique, or a limit is hit.
    fn lyapunov(
        &self,
        a: &Matrix<Self::Element>,
        q: &Matrix<Self::Element>,
    ) -> Result<Lyapunov<Self::Element>, TheoryError>
    where
        Self: Sized,
    {
        lyapunov::solve(self, a, q)
    }

    /// What the evaluation of a node counts in the steps of an [`allowance`].
    fn node_steps(&self) -> u64 {
        10
    }

    /// Whether the elements are numbers: they do not grow into sums of many terms.
    fn is_of_numbers(&self) -> bool {
        false
    }

    /// About how many bytes each of the terms takes that [`size`](Domain::size) counts.
    fn bytes_of_a_term(&self) -> usize {
        64
    }

    /// The letters that occur, in increasing order; none over fields without letters.
    fn letters(&self, _element: &Self::Element) -> Vec<usize> {
        Vec::new()
    }

    /// The letters that occur, those in the arguments of functions among them.
    fn letters_behind(&self, element: &Self::Element) -> BTreeSet<usize> {
        self.letters(element).into_iter().collect()
    }

    /// The element as a polynomial in some of the letters: each monomial as its letters in
    /// increasing order, each as often as its exponent says, with its coefficient. `None` over
    /// fields without letters, or where one of the letters stands in the denominator.
    fn polynomial_in(
        &self,
        _element: &Self::Element,
        _letters: &BTreeSet<usize>,
    ) -> Option<Vec<(Vec<usize>, Self::Element)>> {
        None
    }

    /// What the field can do beyond the four operations; `None` where it has no letters for it.
    fn functions(&self) -> Option<&dyn Functions<Self::Element>> {
        None
    }

    /// `base^exponent` by repeated squaring; `None` when the result would be too large to keep.
    fn power(&self, base: &Self::Element, mut exponent: u32) -> Option<Self::Element> {
        let mut square = base.clone();
        let mut result = self.integer(1);
        while exponent > 0 {
            if exponent & 1 == 1 {
                result = self.multiply(&result, &square);
            }
            exponent >>= 1;
            if exponent > 0 {
                square = self.multiply(&square, &square);
            }
        }
        Some(result)
    }
}

/// Rational functions over Q in the letters of a ring, some of which may stand for functions.
///
/// Elements are in the normal form of [`crate::functions`]; without functions that is the reduced
/// quotient itself.
#[derive(Clone, Debug)]
pub struct Symbolic {
    /// The letters.
    pub ring: Ring,
    functions: Option<FunctionTable>,
}

impl Symbolic {
    /// The field in the letters of a ring.
    pub fn new(ring: Ring) -> Self {
        Symbolic {
            ring,
            functions: None,
        }
    }

    /// The field in letters of which some are given out to functions.
    pub fn with_functions(table: FunctionTable) -> Self {
        Symbolic {
            ring: table.ring(),
            functions: Some(table),
        }
    }

    /// What the letters of functions stand for, if there are any.
    pub(crate) fn table(&self) -> Option<&FunctionTable> {
        self.functions.as_ref()
    }

    /// The normal form of an element that was put together from normal forms.
    fn normal(&self, element: RationalFunction) -> RationalFunction {
        match &self.functions {
            Some(table) => table.reduce(element),
            None => element,
        }
    }

    /// A sum of normal forms, one of which may be older than a letter that replaces one of its own.
    fn refined(&self, element: RationalFunction) -> RationalFunction {
        match &self.functions {
            Some(table) => table.refined(element),
            None => element,
        }
    }
}

impl Domain for Symbolic {
    type Element = RationalFunction;

    fn rational(&self, value: &BigRational) -> Option<RationalFunction> {
        Some(RationalFunction::constant(self.ring, value.clone()))
    }
    fn integer(&self, value: i64) -> RationalFunction {
        RationalFunction::constant(self.ring, BigRational::from_integer(BigInt::from(value)))
    }
    fn is_zero(&self, element: &RationalFunction) -> bool {
        element.is_zero()
    }
    fn add(&self, left: &RationalFunction, right: &RationalFunction) -> RationalFunction {
        self.refined(left + right)
    }
    fn subtract(&self, left: &RationalFunction, right: &RationalFunction) -> RationalFunction {
        self.refined(left - right)
    }
    fn multiply(&self, left: &RationalFunction, right: &RationalFunction) -> RationalFunction {
        self.normal(left * right)
    }
    fn divide(
        &self,
        left: &RationalFunction,
        right: &RationalFunction,
    ) -> Option<RationalFunction> {
        left.checked_div(right).ok().map(|q| self.normal(q))
    }
    fn functions(&self) -> Option<&dyn Functions<RationalFunction>> {
        self.functions
            .as_ref()
            .map(|table| table as &dyn Functions<RationalFunction>)
    }
    fn negate(&self, element: &RationalFunction) -> RationalFunction {
        -element
    }
    fn size(&self, element: &RationalFunction) -> usize {
        element.numerator().len() + element.denominator().len()
    }
    fn node_steps(&self) -> u64 {
        300
    }
    fn bytes_of_a_term(&self) -> usize {
        32 + 8 * self.ring.len()
    }
    fn partial_derivatives(
        &self,
        element: &RationalFunction,
    ) -> Option<Vec<(usize, RationalFunction)>> {
        self.letters(element)
            .into_iter()
            .map(|letter| Some((letter, element.derivative(letter).ok()?)))
            .collect()
    }
    fn has_letters(&self) -> bool {
        true
    }
    fn image(
        &self,
        function: &RationalFunction,
        letters: &[RationalFunction],
    ) -> Option<RationalFunction> {
        let mut values: Vec<_> = letters.iter().cloned().enumerate().collect();
        match &self.functions {
            Some(table) => {
                // Functions follow their arguments.
                values.retain(|(letter, value)| {
                    table.meaning(*letter).is_none()
                        && *value != RationalFunction::variable(self.ring, *letter)
                });
                table.substitute(function, &values).ok()
            }
            None => function.substitute(&values).ok(),
        }
    }
    fn lyapunov(
        &self,
        a: &Matrix<RationalFunction>,
        q: &Matrix<RationalFunction>,
    ) -> Result<Lyapunov<RationalFunction>, TheoryError> {
        // Letters of functions satisfy relations that the polynomial route does not know.
        let mut entries = a.iter().chain(q.iter());
        let related = |letter: usize| {
            let table = self.functions.as_ref();
            table.is_some_and(|table| table.meaning(letter).is_some())
        };
        if entries.any(|entry| self.letters(entry).into_iter().any(related)) {
            return lyapunov::solve(self, a, q);
        }
        lyapunov::solve_symbolic(self.ring, a, q)
    }
    fn letters(&self, element: &RationalFunction) -> Vec<usize> {
        let mut letters = element.numerator().variables_occurring();
        letters.extend(element.denominator().variables_occurring());
        letters.sort_unstable();
        letters.dedup();
        letters
    }
    fn letters_behind(&self, element: &RationalFunction) -> BTreeSet<usize> {
        match &self.functions {
            Some(table) => table.letters_behind(element),
            None => self.letters(element).into_iter().collect(),
        }
    }
    fn polynomial_in(
        &self,
        element: &RationalFunction,
        letters: &BTreeSet<usize>,
    ) -> Option<Vec<(Vec<usize>, RationalFunction)>> {
        let denominator = element.denominator();
        let below = denominator.variables_occurring();
        if below.iter().any(|letter| letters.contains(letter)) {
            return None;
        }
        let mut parts: BTreeMap<Vec<usize>, Vec<(Vec<u32>, BigInt)>> = BTreeMap::new();
        for (monomial, coefficient) in element.numerator().terms() {
            let mut rest = monomial.exponents().to_vec();
            let mut product = Vec::new();
            for letter in letters {
                let times = std::mem::take(&mut rest[*letter]);
                product.extend(std::iter::repeat_n(*letter, times as usize));
            }
            parts.entry(product).or_default().push((rest, coefficient));
        }
        parts
            .into_iter()
            .map(|(product, terms)| {
                let top = Polynomial::from_terms(self.ring, terms).ok()?;
                Some((
                    product,
                    RationalFunction::new(top, denominator.clone()).ok()?,
                ))
            })
            .collect()
    }
    fn power(&self, base: &RationalFunction, exponent: u32) -> Option<RationalFunction> {
        let exponent = i32::try_from(exponent).ok()?;
        let power = base.pow_within(exponent, &Budget::default()).ok()?;
        Some(self.normal(power))
    }
}

/// The rational numbers.
#[derive(Clone, Copy, Debug)]
pub struct Rationals;

impl Domain for Rationals {
    type Element = BigRational;

    fn is_of_numbers(&self) -> bool {
        true
    }

    fn image(&self, function: &RationalFunction, letters: &[BigRational]) -> Option<BigRational> {
        function.evaluate(letters).ok()
    }

    fn rational(&self, value: &BigRational) -> Option<BigRational> {
        Some(value.clone())
    }
    fn integer(&self, value: i64) -> BigRational {
        BigRational::from_integer(BigInt::from(value))
    }
    fn is_zero(&self, element: &BigRational) -> bool {
        element.is_zero()
    }
    fn add(&self, left: &BigRational, right: &BigRational) -> BigRational {
        allow(left, right);
        left + right
    }
    fn subtract(&self, left: &BigRational, right: &BigRational) -> BigRational {
        allow(left, right);
        left - right
    }
    fn multiply(&self, left: &BigRational, right: &BigRational) -> BigRational {
        allow(left, right);
        left * right
    }
    fn divide(&self, left: &BigRational, right: &BigRational) -> Option<BigRational> {
        allow(left, right);
        (!right.is_zero()).then(|| left / right)
    }
    fn negate(&self, element: &BigRational) -> BigRational {
        -element
    }
}

/// Counts an operation on two numbers against the allowance of the thread: their products of words, and
/// the memory of the result.
fn allow(left: &BigRational, right: &BigRational) {
    let words = |q: &BigRational| 1 + (q.numer().bits() + q.denom().bits()) / 64;
    let (left, right) = (words(left), words(right));
    allowance::spend(4 + left.saturating_mul(right));
    let bytes = usize::try_from((left + right).saturating_mul(8));
    allowance::reserve(bytes.unwrap_or(usize::MAX));
}

/// The integers modulo the prime 2^61 - 259, which is 5 modulo 8: minus one is a square, so that i
/// has an image too.
///
/// A claim that is false fails here at a random point with probability about
/// degree / 2^61 less than one (Schwartz 1980, Zippel 1979); whatever passes is proved exactly.
#[derive(Clone, Copy, Debug)]
pub struct PrimeField;

/// 2^61 - 259.
pub const PRIME: u64 = (1 << 61) - EXCESS;

/// 2^61 modulo the prime.
const EXCESS: u64 = 259;

impl PrimeField {
    /// The residue of an integer.
    pub fn residue(value: &BigInt) -> u64 {
        value
            .mod_floor(&BigInt::from(PRIME))
            .to_u64()
            .unwrap_or_default()
    }

    /// A square root, if there is one (Atkin 1992, for primes that are 5 modulo 8).
    pub fn square_root(self, value: u64) -> Option<u64> {
        let double = self.add(&value, &value);
        let v = self.power_u64(double, (PRIME - 5) / 8);
        let i = self.multiply(&double, &self.multiply(&v, &v));
        let root = self.multiply(&self.multiply(&value, &v), &self.subtract(&i, &1));
        (self.multiply(&root, &root) == value).then_some(root)
    }

    /// The multiplicative inverse of a nonzero residue, by Fermat.
    fn inverse(value: u64) -> u64 {
        PrimeField.power_u64(value, PRIME - 2)
    }

    fn power_u64(self, mut base: u64, mut exponent: u64) -> u64 {
        let mut result = 1;
        while exponent > 0 {
            if exponent & 1 == 1 {
                result = self.multiply(&result, &base);
            }
            base = self.multiply(&base, &base);
            exponent >>= 1;
        }
        result
    }
}

impl Domain for PrimeField {
    type Element = u64;

    fn is_of_numbers(&self) -> bool {
        true
    }

    fn image(&self, function: &RationalFunction, letters: &[u64]) -> Option<u64> {
        let top = function.numerator().evaluate_mod(letters, PRIME).ok()?;
        let bottom = function.denominator().evaluate_mod(letters, PRIME).ok()?;
        self.divide(&top, &bottom)
    }

    fn rational(&self, value: &BigRational) -> Option<u64> {
        self.divide(
            &PrimeField::residue(value.numer()),
            &PrimeField::residue(value.denom()),
        )
    }
    fn integer(&self, value: i64) -> u64 {
        value.rem_euclid(PRIME as i64) as u64
    }
    fn is_zero(&self, element: &u64) -> bool {
        *element == 0
    }
    fn add(&self, left: &u64, right: &u64) -> u64 {
        let sum = left + right;
        if sum >= PRIME { sum - PRIME } else { sum }
    }
    fn subtract(&self, left: &u64, right: &u64) -> u64 {
        if left >= right {
            left - right
        } else {
            left + PRIME - right
        }
    }
    fn multiply(&self, left: &u64, right: &u64) -> u64 {
        // Modulo the prime 2^61 is 259. The product is below 2^122, folded once below 2^70, folded twice
        // below 2^61 + 2^18.
        let fold = |x: u128| (x & ((1 << 61) - 1)) + (x >> 61) * u128::from(EXCESS);
        let folded = fold(fold(u128::from(*left) * u128::from(*right))) as u64;
        if folded >= PRIME {
            folded - PRIME
        } else {
            folded
        }
    }
    fn divide(&self, left: &u64, right: &u64) -> Option<u64> {
        (*right != 0).then(|| self.multiply(left, &PrimeField::inverse(*right)))
    }
    fn negate(&self, element: &u64) -> u64 {
        self.subtract(&0, element)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_prime_field_is_one() {
        let field = PrimeField;
        for a in [1, 2, 12345, PRIME - 1, PRIME / 2] {
            for b in [1, 3, PRIME - 1, PRIME / 3] {
                let product = u128::from(a) * u128::from(b) % u128::from(PRIME);
                assert_eq!(u128::from(field.multiply(&a, &b)), product);
            }
            assert_eq!(field.divide(&a, &a), Some(1));
            assert_eq!(field.add(&a, &field.negate(&a)), 0);
            assert_eq!(field.multiply(&a, &(PRIME - 1)), field.negate(&a));
            assert_eq!(field.power(&a, 5), Some(field.power_u64(a, 5)));
        }
        assert_eq!(field.divide(&1, &0), None);
        assert_eq!(field.integer(-1), PRIME - 1);
        for a in [0, 1, 2, 3, 12345, PRIME - 1, PRIME / 2] {
            let square = field.multiply(&a, &a);
            let root = field.square_root(square).unwrap();
            assert!(root == a || root == field.negate(&a));
        }
        let i = field.square_root(PRIME - 1).unwrap();
        assert_eq!(field.multiply(&i, &i), PRIME - 1);
        assert_eq!(field.square_root(2), None);
        let minus_half = BigRational::new(BigInt::from(-1), BigInt::from(2));
        let image = field.rational(&minus_half).unwrap();
        assert_eq!(field.multiply(&image, &field.integer(-2)), 1);
    }
}
