//! Letters for what lies beyond the four operations: pi, i, exp, cos, sin, roots, powers with a
//! symbolic exponent, logarithms, the Dirac distribution, variables of integration.
//!
//! A document that uses such functions gets a reserve of letters in its ring; a [`FunctionTable`]
//! says which letter stands for which function of which argument, and gives out letters on demand.
//! Equal functions have one letter: arguments are split into terms by the addition theorems, and
//! radicands into factors, so that `e^{-2at}` is a power of `e^{-at}`. Roots, i and sines are
//! quadratic over the letters before them: elements are kept in the [normal form](quadratic) in
//! which they occur linearly in the numerator and not at all in the denominator (the tower of
//! extensions of Risch 1969, here with quadratic steps). Where a fraction of an argument comes after
//! the argument, the finer letter takes the place of the coarser one (`refinement`). Symbols stand for
//! the numbers of their ranges, real ones unless told; what is true of real numbers only is used where
//! an element is known to be real (`bounds`).
//!
//! Every relation that is used is true at every admitted point, so that what is equal in the letters is
//! equal. Different normal forms show nothing by themselves.
//!
//! Invariants: an argument mentions only letters that were given out before; the table only grows, but for
//! letters that are taken back once nothing uses them.

#![warn(clippy::wildcard_enum_match_arm)]

mod angle;
mod bounds;
mod calculus;
mod distribution;
mod divergence;
mod elementary;
pub mod enclosure;
mod estimate;
mod exponential;
mod exponential_integral;
mod half_angle;
pub mod integral;
mod monotone;
mod parity;
pub mod quadratic;
mod refinement;
mod removable;
mod root;
mod sign;
mod supposition;
mod tower;

pub use calculus::ChainStep;
pub use sign::{Sign, SignCertificate, SignFact};
pub use supposition::Supposed;
pub(crate) use tower::square_root_of;

use crate::expr::{self, Function};
use crate::model::range::Range;
use integral::End;
use quadratic::Quadratic;
use ratpoly::{Polynomial, RationalFunction, Ring, allowance};
use refinement::Finer;
use sign::KnownSigns;
use std::cmp::Ordering;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

/// What a letter of the reserve stands for.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum FunctionLetter {
    /// The circle's constant.
    Pi,
    /// The imaginary unit.
    ImaginaryUnit,
    /// `e^argument`.
    Exponential(RationalFunction),
    /// `cos argument`.
    Cosine(RationalFunction),
    /// `sin argument`, by the letter of the cosine of the same argument.
    Sine(RationalFunction, usize),
    /// The principal root of a polynomial: not negative where that is not.
    Root(Polynomial),
    /// `base^exponent`, the base positive.
    Power(Polynomial, RationalFunction),
    /// The natural logarithm of something positive.
    Logarithm(Polynomial),
    /// The Dirac distribution.
    Dirac(RationalFunction),
    /// A variable of integration, at its depth of nesting.
    Bound {
        /// How many integrals stand around this one.
        depth: usize,
        /// Whether it runs over positive numbers only.
        positive: bool,
    },
}

impl FunctionLetter {
    /// The argument, of an exponential.
    fn as_exponential(&self) -> Option<&RationalFunction> {
        if let FunctionLetter::Exponential(argument) = self {
            Some(argument)
        } else {
            None
        }
    }

    /// The argument, of a cosine.
    fn as_cosine(&self) -> Option<&RationalFunction> {
        if let FunctionLetter::Cosine(argument) = self {
            Some(argument)
        } else {
            None
        }
    }

    /// The angle, of a cosine or a sine.
    fn as_circular(&self) -> Option<&RationalFunction> {
        if let FunctionLetter::Cosine(angle) | FunctionLetter::Sine(angle, _) = self {
            Some(angle)
        } else {
            None
        }
    }

    /// Base and exponent, of a power.
    fn as_power(&self) -> Option<(&Polynomial, &RationalFunction)> {
        if let FunctionLetter::Power(base, exponent) = self {
            Some((base, exponent))
        } else {
            None
        }
    }
}

/// Why an operation with functions comes to nothing.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Impossible {
    /// It lies outside of what is decided.
    Unsupported(String),
    /// An integral without a value, whatever admitted values the letters have.
    Divergent {
        /// Why.
        reason: String,
        /// The sign of the infinity that it grows to, if it is known to grow to one.
        towards: Option<expr::Sign>,
    },
    /// A divisor vanishes.
    DivisionByZero,
    /// The reserve of letters is used up.
    NoLetter,
}

impl Impossible {
    pub(crate) fn unsupported(what: &str) -> Self {
        Impossible::Unsupported(what.into())
    }

    pub(crate) fn divergent(reason: &str) -> Self {
        Impossible::Divergent {
            reason: reason.into(),
            towards: None,
        }
    }
}

impl From<ratpoly::Error> for Impossible {
    fn from(error: ratpoly::Error) -> Self {
        // Whatever else the engine refuses is a limit of its own.
        if let ratpoly::Error::DivisionByZero = error {
            Impossible::DivisionByZero
        } else {
            Impossible::unsupported("an expression beyond the limits")
        }
    }
}

/// Terms of a polynomial: exponents and coefficient.
pub(crate) type TermList = Vec<(Vec<u32>, ratpoly::BigInt)>;

/// A result, or why there is none.
pub type Possible<T> = Result<T, Impossible>;

/// The constants that have a letter of their own.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Constant {
    /// The ratio of a circle's circumference to its diameter.
    Pi,
    /// The base of the natural logarithm.
    Euler,
    /// The square root of -1.
    ImaginaryUnit,
}

/// What a field with function letters can do beyond the four operations.
pub trait Functions<E> {
    /// A function of an element.
    fn call(&self, function: Function, argument: &E) -> Possible<E>;
    /// A constant.
    fn constant(&self, constant: Constant) -> Possible<E>;
    /// A power with any exponent.
    fn power(&self, base: &E, exponent: &E) -> Possible<E>;
    /// The Dirac distribution.
    fn dirac(&self, argument: &E) -> Possible<E>;
    /// The variable of an integral inside `depth` others.
    fn bound(&self, depth: usize, positive: bool) -> Possible<E>;
    /// Whether a letter is the variable of an integral.
    fn is_bound(&self, letter: usize) -> bool;
    /// An element with another one in place of a letter, in the arguments of functions too.
    fn put(&self, element: &E, letter: usize, image: &E) -> Possible<E>;
    /// An integral over such a variable.
    fn integral(&self, integrand: &E, variable: &E, from: &End<E>, to: &End<E>) -> Possible<E>;
    /// The chain rule for a letter that stands for a function.
    fn chain(&self, letter: usize) -> Option<Possible<Vec<(E, E)>>>;
    /// The sign of an element, if it has one.
    fn sign(&self, element: &E) -> Option<Ordering>;
    /// What is known of the sign of an element where all of this is supposed.
    fn sign_where(&self, element: &E, supposed: &[Supposed<E>]) -> Option<Sign>;
    /// The element with its functions evaluated anew where all of this is supposed.
    fn value_where(&self, element: &E, supposed: &[Supposed<E>]) -> Possible<E>;
    /// Whether an element depends on the variable of an integral.
    fn depends_on_bound(&self, element: &E) -> bool;
    /// Whether a divisor vanishes, or has no value, where a distribution in an element stands, as functions of a letter.
    fn vanishes_at_a_support(&self, element: &E, letter: usize, divisor: &E) -> bool;
}

/// What a look at the meaning of a letter counts in the steps of an allowance: its argument is copied.
const MEANING: u64 = 40;

/// Which letters of a ring stand for which functions.
#[derive(Clone, Debug)]
pub struct FunctionTable {
    ring: Ring,
    /// The reserve: the last letters of the ring, from this one on.
    first: usize,
    /// Which numbers each letter before the reserve stands for.
    ranges: Arc<Vec<Range>>,
    given: Arc<Mutex<Given>>,
    /// What is not negative, or positive, besides: cases and hypotheses.
    supposed: Arc<Vec<Supposed<RationalFunction>>>,
    signs: Arc<Mutex<KnownSigns>>,
    /// Whether integrals may be distributions.
    distributions: bool,
}

/// What was given out.
#[derive(Debug, Default)]
struct Given {
    letters: Vec<FunctionLetter>,
    quadratics: Arc<Vec<Quadratic>>,
    finer: Vec<Finer>,
    /// How often letters were taken back: what is remembered of them is void then.
    generation: u64,
    /// How often there was no letter left for a function.
    refused: u64,
}

impl FunctionTable {
    /// A table for the letters of a ring beyond those whose ranges are given.
    pub fn new(ring: Ring, ranges: Vec<Range>) -> Self {
        FunctionTable {
            ring,
            first: ranges.len(),
            ranges: Arc::new(ranges),
            given: Arc::default(),
            supposed: Arc::default(),
            signs: Arc::default(),
            distributions: false,
        }
    }

    /// The same table where integrals that oscillate without end are distributions in their frequency,
    /// as a document means them that declares the Dirac distribution.
    #[must_use]
    pub fn with_distributions(self) -> Self {
        FunctionTable {
            distributions: true,
            ..self
        }
    }

    /// The ring.
    pub fn ring(&self) -> Ring {
        self.ring
    }

    fn lock(&self) -> MutexGuard<'_, Given> {
        // A list that only grows is whole whenever it is looked at.
        self.given.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// A table that gives out letters on its own from now on: what a search evaluates uses up none
    /// of this one's reserve.
    pub(crate) fn forked(&self) -> Self {
        let given = self.lock();
        let forked = Given {
            letters: given.letters.clone(),
            quadratics: Arc::clone(&given.quadratics),
            finer: given.finer.clone(),
            generation: given.generation,
            refused: given.refused,
        };
        drop(given);
        FunctionTable {
            given: Arc::new(Mutex::new(forked)),
            signs: Arc::default(),
            ..self.clone()
        }
    }

    /// How many letters there are for functions.
    pub(crate) fn reserve(&self) -> usize {
        self.ring.len() - self.first
    }

    /// How often there was no letter left.
    pub(crate) fn refused(&self) -> u64 {
        self.lock().refused
    }

    /// How many letters are left.
    pub(crate) fn remaining(&self) -> usize {
        self.ring.len() - self.first - self.lock().letters.len()
    }

    /// What a letter of the ring stands for, if it is a function.
    pub fn meaning(&self, letter: usize) -> Option<FunctionLetter> {
        let place = letter.checked_sub(self.first)?;
        allowance::spend(MEANING);
        self.lock().letters.get(place).cloned()
    }

    /// The letter of a function, if it has one already.
    pub(crate) fn place_of(&self, function: &FunctionLetter) -> Option<usize> {
        let given = self.lock();
        let mut letters = given.letters.iter();
        Some(self.first + letters.position(|known| known == function)?)
    }

    /// The functions so far, each with its letter.
    pub fn all(&self) -> Vec<(usize, FunctionLetter)> {
        // All are copied, and are as many monomials of all letters at least.
        allowance::spend((self.given_out() * self.ring.len()) as u64);
        (self.first..)
            .zip(self.lock().letters.iter().cloned())
            .collect()
    }

    /// The letter of a function: the one it has, or a new one.
    pub(crate) fn letter(&self, function: FunctionLetter) -> Possible<usize> {
        let known = |given: &Given| given.letters.iter().position(|known| *known == function);
        if let Some(place) = known(&self.lock()) {
            return Ok(self.first + place);
        }
        let square = self.square(&function);
        let mut given = self.lock();
        if let Some(place) = known(&given) {
            return Ok(self.first + place);
        }
        let letter = self.first + given.letters.len();
        if letter >= self.ring.len() {
            given.refused += 1;
            return Err(Impossible::NoLetter);
        }
        if let Some(square) = square {
            let mut quadratics = given.quadratics.to_vec();
            quadratics.push(Quadratic { letter, square });
            given.quadratics = Arc::new(quadratics);
        }
        given.letters.push(function);
        Ok(letter)
    }

    /// The square of a letter that is quadratic over those before it.
    fn square(&self, function: &FunctionLetter) -> Option<Polynomial> {
        match function {
            FunctionLetter::ImaginaryUnit => Some(-Polynomial::one(self.ring)),
            FunctionLetter::Root(radicand) => Some(radicand.clone()),
            FunctionLetter::Sine(_, cosine) => {
                let cosine = Polynomial::variable(self.ring, *cosine);
                Some(&Polynomial::one(self.ring) - &(&cosine * &cosine))
            }
            FunctionLetter::Cosine(angle) => self.square_of_sign(angle),
            FunctionLetter::Pi
            | FunctionLetter::Exponential(_)
            | FunctionLetter::Power(..)
            | FunctionLetter::Logarithm(_)
            | FunctionLetter::Dirac(_)
            | FunctionLetter::Bound { .. } => None,
        }
    }

    /// How many letters are given out.
    pub(crate) fn given_out(&self) -> usize {
        self.lock().letters.len()
    }

    /// Takes back all letters but the first `count` ones. No element with a later letter may be in
    /// use any more.
    pub(crate) fn take_back(&self, count: usize) {
        let mut given = self.lock();
        given.letters.truncate(count);
        let end = self.first + count;
        given.generation += 1;
        given.finer.retain(|f| f.fine < end && f.coarse < end);
        if given.quadratics.iter().any(|q| q.letter >= end) {
            let kept = given.quadratics.iter().filter(|q| q.letter < end);
            given.quadratics = Arc::new(kept.cloned().collect());
        }
    }

    pub(crate) fn variable(&self, letter: usize) -> RationalFunction {
        RationalFunction::variable(self.ring, letter)
    }

    pub(crate) fn letter_value(&self, function: FunctionLetter) -> Possible<RationalFunction> {
        Ok(self.variable(self.letter(function)?))
    }

    /// The circle's constant.
    pub fn pi(&self) -> Possible<RationalFunction> {
        self.letter_value(FunctionLetter::Pi)
    }

    /// The imaginary unit.
    pub fn imaginary_unit(&self) -> Possible<RationalFunction> {
        self.letter_value(FunctionLetter::ImaginaryUnit)
    }

    /// The variable of an integral inside `depth` others.
    pub fn bound(&self, depth: usize, positive: bool) -> Possible<RationalFunction> {
        self.letter_value(FunctionLetter::Bound { depth, positive })
    }

    /// The letters that are quadratic over the letters before them, with their squares.
    pub fn quadratics(&self) -> Arc<Vec<Quadratic>> {
        Arc::clone(&self.lock().quadratics)
    }

    /// The normal form of an element.
    pub fn reduce(&self, f: RationalFunction) -> RationalFunction {
        self.reduce_quadratics(self.refined(f))
    }

    /// The normal form over the quadratic letters, coarser letters left as they are.
    fn reduce_quadratics(&self, f: RationalFunction) -> RationalFunction {
        let quadratics = self.quadratics();
        if quadratics.is_empty() {
            f
        } else {
            quadratic::reduce(f, &quadratics)
        }
    }
}

impl Functions<RationalFunction> for FunctionTable {
    fn call(&self, function: Function, argument: &RationalFunction) -> Possible<RationalFunction> {
        FunctionTable::call(self, function, argument)
    }
    fn constant(&self, constant: Constant) -> Possible<RationalFunction> {
        match constant {
            Constant::Pi => self.pi(),
            Constant::ImaginaryUnit => self.imaginary_unit(),
            Constant::Euler => self.exponential(&RationalFunction::one(self.ring)),
        }
    }
    fn power(
        &self,
        base: &RationalFunction,
        exponent: &RationalFunction,
    ) -> Possible<RationalFunction> {
        FunctionTable::power(self, base, exponent)
    }
    fn dirac(&self, argument: &RationalFunction) -> Possible<RationalFunction> {
        FunctionTable::dirac(self, argument)
    }
    fn bound(&self, depth: usize, positive: bool) -> Possible<RationalFunction> {
        FunctionTable::bound(self, depth, positive)
    }
    fn is_bound(&self, letter: usize) -> bool {
        matches!(self.meaning(letter), Some(FunctionLetter::Bound { .. }))
    }
    fn put(
        &self,
        element: &RationalFunction,
        letter: usize,
        image: &RationalFunction,
    ) -> Possible<RationalFunction> {
        self.substitute(element, &[(letter, image.clone())])
    }
    fn integral(
        &self,
        integrand: &RationalFunction,
        variable: &RationalFunction,
        from: &End<RationalFunction>,
        to: &End<RationalFunction>,
    ) -> Possible<RationalFunction> {
        match variable.numerator().variables_occurring().as_slice() {
            [letter] => FunctionTable::integral(self, integrand, *letter, from, to),
            _ => Err(Impossible::unsupported("an integral over an expression")),
        }
    }
    fn chain(&self, letter: usize) -> Option<Possible<Vec<ChainStep>>> {
        FunctionTable::chain(self, letter)
    }
    fn sign(&self, element: &RationalFunction) -> Option<Ordering> {
        FunctionTable::sign(self, element)
    }
    fn sign_where(
        &self,
        element: &RationalFunction,
        supposed: &[Supposed<RationalFunction>],
    ) -> Option<Sign> {
        self.supposing(supposed).known_sign(element)
    }
    fn value_where(
        &self,
        element: &RationalFunction,
        supposed: &[Supposed<RationalFunction>],
    ) -> Possible<RationalFunction> {
        self.supposing(supposed).anew(element)
    }
    fn depends_on_bound(&self, element: &RationalFunction) -> bool {
        self.letters_behind(element)
            .into_iter()
            .any(|letter| Functions::is_bound(self, letter))
    }
    fn vanishes_at_a_support(
        &self,
        element: &RationalFunction,
        letter: usize,
        divisor: &RationalFunction,
    ) -> bool {
        let places = self.distributions(element).into_iter();
        let mut places = places.filter_map(|(_, u)| self.simple_zero(&u, letter));
        places.any(|(zero, _)| {
            let there = self.substitute(divisor, &[(letter, zero)]);
            there.is_ok_and(|there| there.is_zero())
        })
    }
}
