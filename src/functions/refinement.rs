//! Fractions of an argument that was met before: the letter of the finer argument takes the place of
//! that of the coarser one.
//!
//! Where e^{x/2} comes after e^x, the latter becomes the square of the former; where cos(x/2) comes after
//! cos x, that is a Chebyshev polynomial of it. Both are identities of entire functions, so that they hold
//! for complex arguments too. Among commensurable arguments one letter is active, and elements in normal
//! form have no other.

use super::{FunctionLetter, FunctionTable, Possible};
use ratpoly::RationalFunction;

/// A letter whose argument is a multiple of another one's.
#[derive(Clone, Debug)]
pub(super) struct Finer {
    /// The letter that is replaced.
    pub coarse: usize,
    /// The letter in whose terms it is written: of the same kind.
    pub fine: usize,
    /// How often the finer argument goes into the coarser one.
    pub times: u32,
}

/// How often refined letters may have finer ones behind them.
const MOST_STEPS: usize = 8;

impl FunctionTable {
    /// Says that a letter is to be written by a finer one from now on.
    pub(super) fn replace_by_finer(&self, coarse: usize, fine: usize, times: u32) {
        self.lock().finer.push(Finer {
            coarse,
            fine,
            times,
        });
    }

    /// Whether a letter is written by a finer one.
    pub(super) fn is_replaced(&self, letter: usize) -> bool {
        self.lock().finer.iter().any(|f| f.coarse == letter)
    }

    /// What a letter is in terms of a finer one, if it has been replaced.
    pub(crate) fn in_finer_letters(&self, letter: usize) -> Option<RationalFunction> {
        let meaning = self.meaning(letter)?;
        let replaced = if let FunctionLetter::Sine(_, cosine) = &meaning {
            *cosine
        } else {
            letter
        };
        let finer = {
            let given = self.lock();
            given.finer.iter().find(|f| f.coarse == replaced).cloned()
        }?;
        let times = i64::from(finer.times);
        match meaning {
            FunctionLetter::Exponential(_) | FunctionLetter::Power(..) => {
                self.power_of(&self.variable(finer.fine), times).ok()
            }
            FunctionLetter::Cosine(_) => Some(self.multiple_angle(finer.fine, times).ok()?.0),
            FunctionLetter::Sine(..) => Some(self.multiple_angle(finer.fine, times).ok()?.1),
            FunctionLetter::Pi
            | FunctionLetter::ImaginaryUnit
            | FunctionLetter::Root(_)
            | FunctionLetter::Logarithm(_)
            | FunctionLetter::Dirac(_)
            | FunctionLetter::Bound { .. } => None,
        }
    }

    /// Cosine and sine of a multiple of the angle that a letter is the cosine of.
    pub(super) fn multiple_angle(
        &self,
        cosine: usize,
        times: i64,
    ) -> Possible<(RationalFunction, RationalFunction)> {
        let Some(FunctionLetter::Cosine(angle)) = self.meaning(cosine) else {
            return Err(super::Impossible::unsupported("this angle"));
        };
        let sine = self.letter_value(FunctionLetter::Sine(angle, cosine))?;
        let once = (self.variable(cosine), sine);
        let mut all = (self.integer(1), self.integer(0));
        for _ in 0..times.unsigned_abs() {
            all = self.sum_of_angles(&all, &once);
        }
        if times < 0 {
            all.1 = -&all.1;
        }
        Ok(all)
    }

    /// An element with the finer letters in place of the coarser ones, in arguments too.
    pub(crate) fn refined(&self, f: RationalFunction) -> RationalFunction {
        let mut f = f;
        for _ in 0..MOST_STEPS {
            if self.lock().finer.is_empty() {
                return f;
            }
            let behind = self.letters_behind(&f);
            let images: Vec<(usize, RationalFunction)> = behind
                .into_iter()
                .filter_map(|letter| Some((letter, self.in_finer_letters(letter)?)))
                .collect();
            if images.is_empty() {
                return f;
            }
            match self.substitute_unrefined(&f, &images) {
                Ok(refined) => f = refined,
                Err(_) => return f,
            }
        }
        f
    }
}
