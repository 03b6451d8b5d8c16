//! Other letters put into functions, the chain rule, and the points where functions are rational.

use super::{FunctionLetter, FunctionTable, Impossible, Possible};
use num_rational::BigRational;
use num_traits::{One, Signed, ToPrimitive, Zero};
use ratpoly::{Polynomial, RationalFunction};
use std::collections::BTreeSet;

/// One step of the chain rule: the derivative of a letter by its argument, and the argument.
pub type ChainStep = (RationalFunction, RationalFunction);

impl FunctionTable {
    /// What the function of a letter is taken of; a base before its exponent.
    pub fn arguments(&self, letter: usize) -> Vec<RationalFunction> {
        match self.meaning(letter) {
            Some(
                FunctionLetter::Exponential(u)
                | FunctionLetter::Cosine(u)
                | FunctionLetter::Sine(u, _)
                | FunctionLetter::Dirac(u),
            ) => vec![u],
            Some(FunctionLetter::Root(p) | FunctionLetter::Logarithm(p)) => vec![p.into()],
            Some(FunctionLetter::Power(base, exponent)) => vec![base.into(), exponent],
            Some(
                FunctionLetter::Pi | FunctionLetter::ImaginaryUnit | FunctionLetter::Bound { .. },
            )
            | None => Vec::new(),
        }
    }

    /// The letters that an element depends on: its own, and those in the arguments of functions.
    pub fn letters_behind(&self, f: &RationalFunction) -> BTreeSet<usize> {
        let mut found = BTreeSet::new();
        let mut open = occurring(f);
        while let Some(letter) = open.pop() {
            if found.insert(letter) {
                open.extend(self.arguments(letter).iter().flat_map(occurring));
            }
        }
        found
    }

    /// The images together with the images of the functions that depend on them.
    ///
    /// # Errors
    /// Where a function has no value at its new argument.
    pub fn extended(
        &self,
        images: &[(usize, RationalFunction)],
        needed: &BTreeSet<usize>,
    ) -> Possible<Vec<(usize, RationalFunction)>> {
        self.images_behind(images, needed, false)
    }

    /// The same; with `roots` evaluated anew where nothing behind them changes too.
    pub(super) fn images_behind(
        &self,
        images: &[(usize, RationalFunction)],
        needed: &BTreeSet<usize>,
        roots: bool,
    ) -> Possible<Vec<(usize, RationalFunction)>> {
        let mut all = images.to_vec();
        // Arguments mention earlier letters only, so that one pass is enough.
        for (letter, function) in self.all() {
            if !needed.contains(&letter) || all.iter().any(|(l, _)| *l == letter) {
                continue;
            }
            let changed =
                |f: &RationalFunction| occurring(f).iter().any(|l| all.iter().any(|(k, _)| k == l));
            let root = roots && matches!(function, FunctionLetter::Root(_));
            if !root && !self.arguments(letter).iter().any(changed) {
                continue;
            }
            let image = |f: &RationalFunction| -> Possible<RationalFunction> {
                Ok(self.reduce_quadratics(f.substitute(&all)?))
            };
            let value = match function {
                FunctionLetter::Exponential(u) => self.exponential(&image(&u)?)?,
                FunctionLetter::Cosine(u) => self.cosine_and_sine(&image(&u)?)?.0,
                FunctionLetter::Sine(u, _) => self.cosine_and_sine(&image(&u)?)?.1,
                FunctionLetter::Dirac(u) => self.dirac(&image(&u)?)?,
                FunctionLetter::Root(p) => self.square_root(&image(&p.into())?)?,
                FunctionLetter::Logarithm(p) => self.logarithm(&image(&p.into())?)?,
                FunctionLetter::Power(base, exponent) => {
                    self.power(&image(&base.into())?, &image(&exponent)?)?
                }
                FunctionLetter::Pi
                | FunctionLetter::ImaginaryUnit
                | FunctionLetter::Bound { .. } => continue,
            };
            if value != self.variable(letter) {
                all.push((letter, value));
            }
        }
        Ok(all)
    }

    /// An element with other elements in place of letters, in the arguments of functions too.
    ///
    /// # Errors
    /// Where a denominator vanishes or a function has no value.
    pub fn substitute(
        &self,
        f: &RationalFunction,
        images: &[(usize, RationalFunction)],
    ) -> Possible<RationalFunction> {
        Ok(self.reduce(self.substitute_unrefined(f, images)?))
    }

    /// The same without putting finer letters in place of coarser ones.
    pub(super) fn substitute_unrefined(
        &self,
        f: &RationalFunction,
        images: &[(usize, RationalFunction)],
    ) -> Possible<RationalFunction> {
        let all = self.extended(images, &self.letters_behind(f))?;
        Ok(self.reduce_quadratics(f.substitute(&all)?))
    }

    /// The chain rule for a letter of the reserve: its derivative is the sum of the first times
    /// the derivative of the second of each pair. `None` for what has no derivative here.
    pub fn chain(&self, letter: usize) -> Option<Possible<Vec<ChainStep>>> {
        let function = self.meaning(letter)?;
        let itself = self.variable(letter);
        Some(match function {
            FunctionLetter::Pi | FunctionLetter::ImaginaryUnit | FunctionLetter::Bound { .. } => {
                Ok(Vec::new())
            }
            FunctionLetter::Exponential(u) => Ok(vec![(itself, u)]),
            FunctionLetter::Cosine(u) => self
                .letter_value(FunctionLetter::Sine(u.clone(), letter))
                .map(|sine| vec![(-&sine, u)]),
            FunctionLetter::Sine(u, cosine) => Ok(vec![(self.variable(cosine), u)]),
            FunctionLetter::Root(p) => {
                let double = &itself + &itself;
                double
                    .inverse()
                    .map(|rate| vec![(self.reduce(rate), p.into())])
                    .map_err(Impossible::from)
            }
            FunctionLetter::Logarithm(p) => {
                let p = RationalFunction::from(p);
                p.inverse()
                    .map(|rate| vec![(rate, p)])
                    .map_err(Impossible::from)
            }
            FunctionLetter::Power(base, exponent) => self.power_chain(&itself, base, exponent),
            FunctionLetter::Dirac(_) => Err(Impossible::unsupported(
                "the derivative of a Dirac distribution",
            )),
        })
    }

    /// d(b^e) = b^e (e/b db + ln b de); the logarithm only where the exponent is no constant.
    fn power_chain(
        &self,
        itself: &RationalFunction,
        base: Polynomial,
        exponent: RationalFunction,
    ) -> Possible<Vec<ChainStep>> {
        let base = RationalFunction::from(base);
        let by_base = (itself * &exponent).checked_div(&base)?;
        let mut steps = vec![(by_base, base.clone())];
        if exponent.as_constant().is_none() {
            steps.push((itself * &self.logarithm(&base)?, exponent));
        }
        Ok(steps)
    }

    /// The partial derivative by a letter, through the arguments of functions too.
    ///
    /// # Errors
    /// Where a function has no derivative here.
    pub fn derivative(&self, f: &RationalFunction, by: usize) -> Possible<RationalFunction> {
        let mut sum = f.derivative(by)?;
        for letter in occurring(f) {
            let Some(steps) = self.chain(letter) else {
                continue;
            };
            if letter == by || !self.letters_behind(&self.variable(letter)).contains(&by) {
                continue;
            }
            let mut rate = RationalFunction::zero(self.ring());
            for (factor, argument) in steps? {
                rate = &rate + &(&factor * &self.derivative(&argument, by)?);
            }
            sum = &sum + &(&f.derivative(letter)? * &rate);
        }
        Ok(self.reduce(sum))
    }

    /// The rational value of an element at a point where some letters have values, if it is one:
    /// a function counts only where it is rational itself, as `cos 0` and `sqrt 4` are.
    pub fn rational_value(
        &self,
        f: &RationalFunction,
        point: &[Option<BigRational>],
    ) -> Option<BigRational> {
        let known = |v: &Option<BigRational>| v.clone().unwrap_or_else(BigRational::zero);
        let mut values: Vec<BigRational> = point.iter().map(known).collect();
        for letter in occurring(f) {
            values[letter] = match self.meaning(letter) {
                Some(function) => self.rational_letter(&function, point)?,
                None => point.get(letter)?.clone()?,
            };
        }
        f.evaluate(&values).ok()
    }

    fn rational_letter(
        &self,
        function: &FunctionLetter,
        point: &[Option<BigRational>],
    ) -> Option<BigRational> {
        let at = |f: &RationalFunction| self.rational_value(f, point);
        let one = BigRational::one();
        match function {
            FunctionLetter::Exponential(u) | FunctionLetter::Cosine(u) => {
                at(u)?.is_zero().then_some(one)
            }
            FunctionLetter::Sine(u, _) => at(u)?.is_zero().then(BigRational::zero),
            FunctionLetter::Logarithm(p) => at(&p.clone().into())?.is_one().then(BigRational::zero),
            FunctionLetter::Root(p) => {
                let square = at(&p.clone().into())?;
                if square.is_negative() {
                    return None;
                }
                let (above, below) = (square.numer().sqrt(), square.denom().sqrt());
                let root = BigRational::new(above, below);
                (&root * &root == square).then_some(root)
            }
            FunctionLetter::Power(base, exponent) => {
                let (base, exponent) = (at(&base.clone().into())?, at(exponent)?);
                if base.is_one() {
                    return Some(one);
                }
                let n = exponent
                    .is_integer()
                    .then(|| exponent.to_integer().to_i32())??;
                (n.abs() <= 64 && !base.is_zero()).then(|| base.pow(n))
            }
            // No rational number, or none that is known.
            FunctionLetter::Pi
            | FunctionLetter::ImaginaryUnit
            | FunctionLetter::Dirac(_)
            | FunctionLetter::Bound { .. } => None,
        }
    }
}

fn occurring(f: &RationalFunction) -> Vec<usize> {
    let mut letters = f.numerator().variables_occurring();
    letters.extend(f.denominator().variables_occurring());
    letters.sort_unstable();
    letters.dedup();
    letters
}
