//! Cosines and sines: addition theorems, angles that are rational multiples of pi, complex angles.
//!
//! Of a turn with the denominators 2^k, 3, 5 and their products the cosine is written by square roots:
//! the fraction is split into such with prime powers below (by the Chinese remainder theorem), cos(pi/3) = 1/2,
//! cos(pi/5) = (1 + sqrt 5)/4, and halving by cos^2(x/2) = (1 + cos x)/2.

use super::elementary::{Term, with_positive_lead};
use super::{FunctionLetter, FunctionTable, Impossible, Possible, square_root_of};
use num_bigint::BigInt;
use num_integer::Integer;
use num_rational::BigRational;
use num_traits::{One, ToPrimitive};
use ratpoly::RationalFunction;

/// The largest power of two below a fraction of pi that is written by roots.
const MOST_HALVINGS: u32 = 5;

/// Cosine and sine.
type Pair = (RationalFunction, RationalFunction);

impl FunctionTable {
    /// `cos argument` and `sin argument`.
    pub fn cosine_and_sine(&self, argument: &RationalFunction) -> Possible<Pair> {
        let argument = self.reduce(argument.clone());
        self.refuse_distributions(&argument)?;
        let (real, imaginary) = self.parts_by_i(&argument)?;
        let mut whole = (self.integer(1), self.integer(0));
        for term in self.terms(&real)? {
            let part = self.angle(term)?;
            whole = self.sum_of_angles(&whole, &part);
        }
        if imaginary.is_zero() {
            return Ok(whole);
        }
        // cos iv = cosh v, sin iv = i sinh v.
        let up = self.exponential(&imaginary)?;
        let down = self.reduce(up.inverse()?);
        let half = self.constant(BigRational::new(1.into(), 2.into()));
        let cosh = self.reduce(&(&up + &down) * &half);
        let sinh = self.reduce(&(&up - &down) * &half);
        let i = self.imaginary_unit()?;
        Ok(self.sum_of_angles(&whole, &(cosh, self.reduce(&i * &sinh))))
    }

    pub(super) fn sum_of_angles(&self, (c, s): &Pair, (d, t): &Pair) -> Pair {
        (
            self.reduce(&(c * d) - &(s * t)),
            self.reduce(&(s * d) + &(c * t)),
        )
    }

    /// Cosine and sine of one term.
    fn angle(&self, mut term: Term) -> Possible<Pair> {
        // |x| in an angle: the cosine is even, the sine odd.
        let mut odd = self.integer(1);
        let mut moduli = false;
        for (letter, function) in self.all() {
            let FunctionLetter::Root(square) = function else {
                continue;
            };
            if term.atom.numerator().degree(letter) != Some(1) {
                continue;
            }
            if let Some(x) = square_root_of(&square) {
                let magnitude = self.variable(letter);
                let x = RationalFunction::from(x);
                term.atom = &term.atom.checked_div(&magnitude)? * &x;
                odd = self.reduce(&odd * &magnitude.checked_div(&x)?);
                moduli = true;
            }
        }
        if moduli {
            // What stood between bars may be a sum.
            let argument = &self.constant(term.number) * &term.atom;
            let (cosine, sine) = self.cosine_and_sine(&argument)?;
            return Ok((cosine, self.reduce(&sine * &odd)));
        }
        if let Some(pair) = self.turn(&term)? {
            return Ok(pair);
        }
        if let Some(pair) = self.sign_of_half_turns(&term)? {
            return Ok(pair);
        }
        let (n, unit) = self.multiple(&term, |f| f.as_cosine().cloned())?;
        // The letter's angle has a positive leading coefficient.
        let (n, unit) = with_positive_lead(n, unit);
        let cosine = self.letter(FunctionLetter::Cosine(unit))?;
        self.multiple_angle(cosine, n)
    }

    /// Cosine and sine of a rational multiple of pi, where square roots are enough.
    fn turn(&self, term: &Term) -> Possible<Option<Pair>> {
        let is_pi = self
            .all()
            .iter()
            .any(|(l, f)| *f == FunctionLetter::Pi && self.variable(*l) == term.atom);
        if !is_pi {
            return Ok(None);
        }
        let two = BigRational::from_integer(2.into());
        let whole = &term.number - (&term.number / &two).floor() * &two;
        let mut parts = Vec::new();
        let mut rest = whole;
        for prime in [3, 5] {
            let prime = BigInt::from(prime);
            if rest.denom().is_multiple_of(&prime) {
                // rest = k/prime + what has no such divisor below.
                let other = rest.denom() / &prime;
                if other.is_multiple_of(&prime) {
                    return Ok(None);
                }
                let k = rest.numer() * other.extended_gcd(&prime).x;
                let k = k.mod_floor(&prime);
                let part = BigRational::new(k.clone(), prime.clone());
                rest -= &part;
                parts.push((prime, k));
            }
        }
        let halvings = rest.denom().trailing_zeros().unwrap_or(0);
        let halvings = u32::try_from(halvings).unwrap_or(u32::MAX);
        if halvings > MOST_HALVINGS || *rest.denom() != BigInt::one() << halvings {
            return Ok(None);
        }
        let quarters = |n: &BigInt| {
            let [c, s] = match n.mod_floor(&BigInt::from(4)).to_u8() {
                Some(0) => [1, 0],
                Some(1) => [0, 1],
                Some(2) => [-1, 0],
                _ => [0, -1],
            };
            (self.integer(c), self.integer(s))
        };
        let times = |pair: &Pair, n: &BigInt| -> Pair {
            let mut sum = (self.integer(1), self.integer(0));
            for _ in 0..n.to_u32().unwrap_or(0) {
                sum = self.sum_of_angles(&sum, pair);
            }
            sum
        };
        let mut sum = if halvings <= 1 {
            quarters(&(rest.numer() << (1 - halvings)))
        } else {
            let turns = BigInt::one() << (halvings + 1);
            let numerator = rest.numer().mod_floor(&turns);
            // Quarter turns apart, less than a quarter is left.
            let quarter = BigInt::one() << (halvings - 1);
            let (full, left) = numerator.div_mod_floor(&quarter);
            self.sum_of_angles(&quarters(&full), &times(&self.halved(halvings)?, &left))
        };
        for (prime, k) in parts {
            let base = self.prime_turn(&prime)?;
            sum = self.sum_of_angles(&sum, &times(&base, &k));
        }
        Ok(Some(sum))
    }

    /// Cosine and sine of pi/2^k, k > 1.
    fn halved(&self, k: u32) -> Possible<Pair> {
        let mut pair = (self.integer(0), self.integer(1));
        let half = self.constant(BigRational::new(1.into(), 2.into()));
        for _ in 1..k {
            let square = &(&pair.0 + &self.integer(1)) * &half;
            let cosine = self.square_root(&square)?;
            let twice = &cosine + &cosine;
            let sine = self.reduce(pair.1.checked_div(&twice)?);
            pair = (cosine, sine);
        }
        Ok(pair)
    }

    /// Cosine and sine of pi/3 and pi/5.
    fn prime_turn(&self, prime: &BigInt) -> Possible<Pair> {
        let rational = |n: i64, d: i64| self.constant(BigRational::new(n.into(), d.into()));
        let root = |n: i64| self.square_root(&self.integer(n));
        if *prime == BigInt::from(3) {
            let sine = &root(3)? * &rational(1, 2);
            return Ok((rational(1, 2), sine));
        }
        let five = root(5)?;
        let cosine = &(&five + &self.integer(1)) * &rational(1, 4);
        let square = &self.integer(10) - &(&five + &five);
        let sine = &self.square_root(&square)? * &rational(1, 4);
        Ok((cosine, self.reduce(sine)))
    }

    /// Refuses an argument with a distribution in it.
    pub(super) fn refuse_distributions(&self, f: &RationalFunction) -> Possible<()> {
        let letters = self.letters_behind(f);
        let distribution = |l: usize| matches!(self.meaning(l), Some(FunctionLetter::Dirac(_)));
        if letters.into_iter().any(distribution) {
            return Err(Impossible::unsupported("a function of a distribution"));
        }
        Ok(())
    }
}
