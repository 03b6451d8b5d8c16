//! On which letters a quantity depends, and how: proportionality, separation of letters.

use super::{Checker, Found, Ground};
use crate::check::identity::letters_of;
use crate::document::VerdictWord;
use crate::evaluate::Value;
use crate::functions::FunctionLetter;
use crate::model::statement::Proposition;
use crate::verdict::statement::{Fact, Measure, Scope, Sign, Subject};
use num_rational::BigRational;
use num_traits::{Signed, Zero};
use ratpoly::RationalFunction;

impl Checker<'_> {
    /// A value that was computed is a rational function of the letters if no letter in it stands for
    /// a function of others.
    pub(super) fn explicit(&self, value: &Value<RationalFunction>) -> Found {
        let entries = value.entries();
        let functions: Vec<usize> = letters_of(entries.iter().copied())
            .into_iter()
            .filter(|l| self.stands_for_a_function(*l))
            .collect();
        if !functions.is_empty() {
            // Letters that depend on each other might make up a rational function together.
            return match self.are_independent(&functions) {
                true => Found::of(VerdictWord::Refuted, vec![Fact::Functions(functions)]),
                false => Found::undecided("whether its functions cancel is out of reach"),
            };
        }
        let terms = entries
            .iter()
            .map(|e| e.numerator().len() + e.denominator().len())
            .sum();
        let fact = Fact::Explicit(entries.len(), terms);
        Found::of(VerdictWord::Holds, vec![fact])
    }

    /// Whether no letter of these is a rational function of the declared letters and the others, so that
    /// what has one of them in its normal form is none either: roots of different irreducible
    /// polynomials in the declared letters, or a single transcendental function of such.
    fn are_independent(&self, functions: &[usize]) -> bool {
        let Some(table) = &self.model.functions else {
            return false;
        };
        let plain = |f: &RationalFunction| {
            let letters = letters_of([f]);
            !letters.iter().any(|l| table.meaning(*l).is_some())
        };
        let moving = |f: &RationalFunction| plain(f) && !letters_of([f]).is_empty();
        let roots = functions.iter().all(|l| match table.meaning(*l) {
            Some(FunctionLetter::Root(p)) => plain(&p.into()),
            Some(FunctionLetter::ImaginaryUnit) => true,
            Some(
                FunctionLetter::Pi
                | FunctionLetter::Exponential(_)
                | FunctionLetter::Cosine(_)
                | FunctionLetter::Sine(..)
                | FunctionLetter::Power(..)
                | FunctionLetter::Logarithm(_)
                | FunctionLetter::Dirac(_)
                | FunctionLetter::Bound { .. },
            )
            | None => false,
        });
        let meanings: Vec<_> = functions.iter().filter_map(|l| table.meaning(*l)).collect();
        let single = match meanings.as_slice() {
            [FunctionLetter::Exponential(u) | FunctionLetter::Cosine(u)] => moving(u),
            [FunctionLetter::Sine(u, _)] => moving(u),
            [FunctionLetter::Cosine(u), FunctionLetter::Sine(v, _)] => u == v && moving(u),
            [FunctionLetter::Logarithm(p)] => moving(&p.clone().into()),
            _ => false,
        };
        roots || single || self.are_independent_powers(&meanings)
    }

    /// Whether these are exponentials of different monomials, each with a declared letter in it and at
    /// most one logarithm of a declared letter beside, as a^w and b^w are: no product of their powers
    /// is algebraic, so that none satisfies a relation (Ax, *On Schanuel's conjectures*, 1971).
    fn are_independent_powers(&self, meanings: &[FunctionLetter]) -> bool {
        let Some(table) = &self.model.functions else {
            return false;
        };
        let logarithm_of_a_letter = |letter: usize| match table.meaning(letter) {
            Some(FunctionLetter::Logarithm(p)) => p.len() == 1 && p.total_degree() == Some(1),
            _ => false,
        };
        // The monomial of an exponent, with the letter whose logarithm it is multiplied with.
        let exponent = |function: &FunctionLetter| match function {
            FunctionLetter::Exponential(u) => Some((u.clone(), None)),
            FunctionLetter::Power(base, u) => {
                let base = RationalFunction::from(base.clone());
                let letters: Vec<usize> = letters_of([&base]).into_iter().collect();
                match letters[..] {
                    [letter] if base == table.variable(letter) => Some((u.clone(), Some(letter))),
                    _ => None,
                }
            }
            FunctionLetter::Pi
            | FunctionLetter::ImaginaryUnit
            | FunctionLetter::Cosine(_)
            | FunctionLetter::Sine(..)
            | FunctionLetter::Root(_)
            | FunctionLetter::Logarithm(_)
            | FunctionLetter::Dirac(_)
            | FunctionLetter::Bound { .. } => None,
        };
        let mut monomials: Vec<(Vec<u32>, Option<usize>)> = Vec::new();
        for function in meanings {
            let Some((u, base)) = exponent(function) else {
                return false;
            };
            let mut terms = u.numerator().terms();
            let (Some((monomial, _)), None) = (terms.next(), terms.next()) else {
                return false;
            };
            let exponents = monomial.exponents().to_vec();
            let occurring = || exponents.iter().enumerate().filter(|(_, e)| **e > 0);
            let declared = |l: usize| table.meaning(l).is_none();
            let logarithms: u32 = occurring()
                .filter(|(l, _)| logarithm_of_a_letter(*l))
                .map(|(_, e)| *e)
                .sum();
            let fits = u.denominator().is_constant()
                && occurring().all(|(l, _)| declared(l) || logarithm_of_a_letter(l))
                && occurring().any(|(l, _)| declared(l))
                && logarithms + u32::from(base.is_some()) <= 1;
            let key = (exponents, base);
            if !fits || monomials.contains(&key) {
                return false;
            }
            monomials.push(key);
        }
        !monomials.is_empty()
    }
}

impl Ground {
    pub(super) fn depends_only(&self, f: &RationalFunction, p: &Proposition) -> Found {
        let named: Vec<usize> = p.letters.iter().filter_map(|s| self.letters[*s]).collect();
        let f = if p.normalised {
            let images = named
                .iter()
                .map(|l| {
                    let own = self.reference[*l].clone()?;
                    Some((*l, RationalFunction::constant(self.ring, own)))
                })
                .collect::<Option<Vec<_>>>();
            let normal = images
                .and_then(|images| f.substitute(&images).ok())
                .and_then(|reference| f.checked_div(&reference).ok());
            match normal {
                Some(normal) => normal,
                None => return Found::undecided("there are no reference values"),
            }
        } else {
            f.clone()
        };
        let mut depends = self.letters_in(&f);
        depends.sort_unstable();
        let mut expected = named;
        expected.sort_unstable();
        let word = if depends == expected {
            VerdictWord::Holds
        } else {
            VerdictWord::Refuted
        };
        let mut facts = vec![Fact::DependsOn(depends.clone())];
        for letter in depends.iter().filter(|l| !expected.contains(l)) {
            if let Some(value) = self.elasticity_here(&f, *letter) {
                facts.push(Fact::Number(Measure::Elasticity(*letter), value.into()));
            }
        }
        Found::of(word, facts)
    }

    /// A sum, or a product, of functions of one group of letters each.
    pub(super) fn separates(&self, f: &RationalFunction, p: &Proposition) -> Found {
        let groups: Vec<Vec<usize>> = p
            .groups
            .iter()
            .map(|g| g.iter().filter_map(|s| self.letters[*s]).collect())
            .collect();
        let mut pairs = Vec::new();
        for (k, group) in groups.iter().enumerate() {
            for other in &groups[k + 1..] {
                pairs.extend(group.iter().flat_map(|x| other.iter().map(|y| (*x, *y))));
            }
        }
        let (mut sum, mut product, mut measured) = (true, true, true);
        let mut largest: Option<(usize, usize, BigRational)> = None;
        for (x, y) in pairs {
            let mixed = || -> Option<(RationalFunction, RationalFunction)> {
                let (fx, fy) = (f.derivative(x).ok()?, f.derivative(y).ok()?);
                let fxy = fx.derivative(y).ok()?;
                let logarithmic = f * &fxy - fx * fy;
                Some((fxy, logarithmic))
            };
            let Some((fxy, logarithmic)) = mixed() else {
                return Found::undecided("a derivative is out of reach");
            };
            sum &= fxy.is_zero();
            product &= logarithmic.is_zero();
            let letters =
                RationalFunction::variable(self.ring, x) * RationalFunction::variable(self.ring, y);
            let elasticity = (letters * logarithmic).checked_div(&(f * f)).ok();
            let here = elasticity.filter(|_| !self.vanishes_here(f));
            let value = here.and_then(|e| self.at(&e));
            measured &= value.is_some();
            if let Some(value) = value {
                let less = |(_, _, old): &(usize, usize, BigRational)| old.abs() < value.abs();
                if largest.as_ref().is_none_or(less) {
                    largest = Some((x, y, value));
                }
            }
        }
        if sum || product {
            return Found::of(VerdictWord::Holds, vec![Fact::Separates(sum)]);
        }
        // Of what is zero there whatever these letters are, it is true at the reference values.
        let all: Vec<usize> = groups.concat();
        if self.vanishes_on_lines(f, &all) {
            return Found::of(VerdictWord::Loose, vec![Fact::About(Scope::Reference)]).nearly();
        }
        let Some((x, y, value)) = largest else {
            return Found::of(VerdictWord::Refuted, Vec::new());
        };
        let word = if measured && value.abs() <= p.tolerance {
            VerdictWord::Loose
        } else {
            VerdictWord::Refuted
        };
        let fact = Fact::Number(Measure::MixedElasticity(x, y), value.into());
        Found::of(word, vec![fact]).nearly()
    }

    pub(super) fn proportional(
        &self,
        f: &RationalFunction,
        to: &RationalFunction,
        p: &Proposition,
    ) -> Found {
        let Ok(quotient) = f.checked_div(to) else {
            return Found::undecided("it is compared with zero");
        };
        let occurring = self.letters_in(&quotient);
        let letters: Vec<usize> = self
            .letters_in(to)
            .into_iter()
            .filter(|l| occurring.contains(l))
            .collect();
        if letters.is_empty() {
            return Found::of(VerdictWord::Holds, vec![Fact::Quotient(quotient)]);
        }
        let mut facts = Vec::new();
        let mut near = true;
        for letter in letters {
            let value = self.elasticity_here(&quotient, letter);
            near &= match &value {
                Some(v) => v.abs() <= p.tolerance,
                None => self.vanishes_on_lines(&quotient, &[letter]),
            };
            if let Some(value) = value {
                facts.push(Fact::Number(
                    Measure::QuotientElasticity(letter),
                    value.into(),
                ));
            }
            if let Ok(derivative) = quotient.derivative(letter)
                && let Some(sign) = self.sign(&derivative, &Scope::Everywhere).sign
            {
                facts.push(Fact::Sign(
                    Subject::QuotientDerivative(letter),
                    sign,
                    Scope::Everywhere,
                ));
            }
        }
        let word = if near {
            VerdictWord::Loose
        } else {
            VerdictWord::Refuted
        };
        facts.retain(|f| !matches!(f, Fact::Sign(_, Sign::Zero, _)));
        if word == VerdictWord::Refuted && facts.iter().all(|f| !matches!(f, Fact::Number(..))) {
            facts.push(Fact::Quotient(quotient.clone()));
        }
        if self.at(&quotient).is_some_and(|v| v.is_zero()) {
            facts.push(Fact::Quotient(quotient));
        }
        Found::of(word, facts).nearly()
    }
}
