//! The divisors that must not vanish, in irreducible factors, and why they do not.
//!
//! A polynomial in positive letters whose coefficients all have one sign has no zero. Where the
//! printed letters do not show that, the definitions are inserted and it is asked again; then whether
//! it is a principal minor of a matrix that is declared positive definite, and what its sign is, with
//! the imaginary unit that of its squared modulus.

use super::Checker;
use super::hypotheses::possible::Signs;
use crate::evaluate::Origin;
use crate::functions::FunctionLetter;
use crate::functions::quadratic::reduce_polynomial;
use crate::matrix::Matrix;
use crate::model::matrices::MatrixEntry;
use crate::theory::determinant;
use crate::verdict::{Because, NonVanishing};
use num_traits::Signed;
use ratpoly::{Budget, Polynomial, RationalFunction, RegionSign};

/// The sign of a polynomial with more terms or letters than these is not asked for.
const LONG: usize = 40;
const MANY: usize = 6;

impl Checker<'_> {
    /// The conditions met since they were last cleared.
    pub(crate) fn conditions(&self) -> Vec<NonVanishing> {
        let mut found: Vec<NonVanishing> = Vec::new();
        for condition in &self.exact.conditions {
            // What must be positive is named whole: two negative factors would do.
            if let Origin::Stability(_) | Origin::Range { .. } = condition.origin {
                let factor = self.without_positive_factors(&condition.divisor);
                let meant = NonVanishing {
                    factor,
                    origin: condition.origin.clone(),
                    because: None,
                };
                // It is known to be positive.
                if meant.factor.is_one() {
                    continue;
                }
                if !found.contains(&meant) {
                    found.push(meant);
                }
                continue;
            }
            for factor in irreducible_factors(condition.divisor.numerator()) {
                if found.iter().any(|f| f.factor == factor) {
                    continue;
                }
                let because = self.nonvanishing(&factor);
                // Letters under an integral are none of the document's, and π is a number.
                if because.is_some() && self.is_no_condition(&factor) {
                    continue;
                }
                found.push(NonVanishing {
                    factor,
                    origin: condition.origin.clone(),
                    because,
                });
            }
        }
        found
    }

    /// A polynomial of the same sign.
    fn without_positive_factors(&self, value: &RationalFunction) -> Polynomial {
        let product = value.numerator() * value.denominator();
        let Ok(factored) = product.factor_within(&Budget::default()) else {
            return product;
        };
        let mut rest = Polynomial::one(self.model.ring);
        for (factor, multiplicity) in &factored.factors {
            match self.signs(factor) {
                Signs::POSITIVE => {}
                Signs::NEGATIVE if multiplicity % 2 == 0 => {}
                Signs::NEGATIVE => rest = -rest,
                _ if multiplicity % 2 == 0 => rest = &(&rest * factor) * factor,
                _ => rest = &rest * factor,
            }
        }
        match factored.content.is_negative() {
            true => -rest,
            false => rest,
        }
    }

    /// Whether something is divided by that vanishes wherever the hypotheses hold: then nothing is said.
    pub(super) fn divides_by_relation(&self) -> bool {
        if self.supposed.relations.is_empty() {
            return false;
        }
        let all = self.insertion(&self.inserted.keys().copied().collect::<Vec<_>>());
        self.exact.conditions.iter().any(|condition| {
            if matches!(condition.origin, Origin::Range { .. }) {
                return false;
            }
            let inserted = match self.functions() {
                Some(table) => table.substitute(&condition.divisor, &all.letters).ok(),
                None => condition.divisor.substitute(&all.letters).ok(),
            };
            inserted.is_some_and(|divisor| self.vanishes_under_relations(divisor.numerator()))
        })
    }

    fn nonvanishing(&self, factor: &Polynomial) -> Option<Because> {
        if self.has_one_sign(factor) {
            return Some(Because::Positive);
        }
        if self.supposed.in_force && self.signs(factor).excludes_zero() {
            return Some(Because::Supposed);
        }
        let abbreviations: Vec<usize> = factor
            .variables_occurring()
            .into_iter()
            .filter(|l| self.inserted.contains_key(l))
            .collect();
        let insertion = self.insertion(&abbreviations);
        let inserted = RationalFunction::from(factor.clone())
            .substitute(&insertion.letters)
            .ok()?;
        let positive =
            self.has_one_sign(inserted.numerator()) && self.has_one_sign(inserted.denominator());
        if positive {
            return Some(Because::PositiveBy(insertion.labels));
        }
        if let Some(name) = self.minor_of(factor) {
            return Some(Because::Definite(name));
        }
        let supposed = |p: &Polynomial| self.signs(p).excludes_zero();
        if supposed(inserted.numerator()) {
            return Some(match self.supposed.in_force {
                true => Because::Supposed,
                false => Because::Sign,
            });
        }
        let real = self.squared_modulus(inserted.numerator())?;
        let occurring = real.variables_occurring();
        if real.len() > LONG || occurring.len() > MANY {
            return None;
        }
        matches!(
            self.sign(&RationalFunction::from(real)),
            RegionSign::Positive | RegionSign::Negative
        )
        .then_some(Because::Sign)
    }

    /// The matrix that is declared positive definite and has this factor as a principal minor, which is
    /// positive then.
    fn minor_of(&self, factor: &Polynomial) -> Option<String> {
        let instance = &self.model.instances[self.instance];
        let occurring = factor.variables_occurring();
        for matrix in &self.model.matrices {
            if !matrix.shape.positive_definite {
                continue;
            }
            let (order, _) = matrix.shape_in(instance);
            let entry = |i: usize, j: usize| -> Option<RationalFunction> {
                let MatrixEntry::Symbol(symbol) = matrix.entry(i, j) else {
                    return None;
                };
                let letter = self.model.letter_of_symbol(symbol, 0)?;
                Some(RationalFunction::variable(self.model.ring, letter))
            };
            // The rows whose diagonal entries occur.
            let diagonal = |i: &usize| {
                let letter = entry(*i, *i)?.numerator().variables_occurring();
                Some(letter.iter().all(|l| occurring.contains(l)))
            };
            let kept: Vec<usize> = (0..order)
                .filter(|i| diagonal(i).unwrap_or(false))
                .collect();
            if kept.is_empty() || kept.len() > 4 {
                continue;
            }
            let minor = Matrix::try_from_fn(kept.len(), kept.len(), |i, j| {
                entry(kept[i], kept[j]).ok_or(())
            });
            let Ok(minor) = minor else { continue };
            let value = determinant::determinant(&self.exact.field, &minor);
            let normal = |p: &Polynomial| p.primitive_part().unit_normal();
            if value.is_some_and(|v| normal(v.numerator()) == normal(factor)) {
                return Some(crate::latex::canonical(&matrix.name));
            }
        }
        None
    }

    /// A real polynomial that vanishes where this one does: itself, or where it has the imaginary unit
    /// its product with the conjugate. None where it has other functions.
    fn squared_modulus(&self, f: &Polynomial) -> Option<Polynomial> {
        let Some(table) = self.functions() else {
            return Some(f.clone());
        };
        let mut unit = None;
        for letter in f.variables_occurring() {
            match table.meaning(letter) {
                None | Some(FunctionLetter::Pi) => {}
                Some(FunctionLetter::ImaginaryUnit) => unit = Some(letter),
                Some(FunctionLetter::Bound { .. }) => {}
                Some(_) => return None,
            }
        }
        let Some(unit) = unit else {
            return Some(f.clone());
        };
        let minus = -RationalFunction::variable(self.model.ring, unit);
        let conjugate = RationalFunction::from(f.clone())
            .substitute(&[(unit, minus)])
            .ok()?;
        let product = f * conjugate.numerator();
        Some(reduce_polynomial(&product, &table.quadratics()))
    }

    /// Whether a factor is about letters of integrals or numbers only.
    fn is_no_condition(&self, factor: &Polynomial) -> bool {
        let Some(table) = self.functions() else {
            return false;
        };
        let occurring = factor.variables_occurring();
        let mut meanings = occurring.iter().map(|l| table.meaning(*l));
        let all_numbers = occurring
            .iter()
            .all(|l| table.meaning(*l) == Some(FunctionLetter::Pi));
        all_numbers || meanings.any(|m| matches!(m, Some(FunctionLetter::Bound { .. })))
    }

    /// Whether all letters are positive and all coefficients of one sign.
    fn has_one_sign(&self, polynomial: &Polynomial) -> bool {
        let positive = |letter: &usize| {
            self.model.is_positive(*letter)
                || self.inserted.get(letter).is_some_and(|value| {
                    [value.numerator(), value.denominator()].iter().all(|p| {
                        p.variables_occurring()
                            .iter()
                            .all(|l| self.model.is_positive(*l))
                            && p.terms().all(|(_, c)| c.is_positive())
                    })
                })
        };
        let mut signs = polynomial.terms().map(|(_, c)| c.is_positive());
        let first = signs.next();
        first.is_some()
            && signs.all(|s| Some(s) == first)
            && polynomial.variables_occurring().iter().all(positive)
    }
}

/// The irreducible factors that are not constants; the polynomial itself where factoring is out of
/// reach.
fn irreducible_factors(polynomial: &Polynomial) -> Vec<Polynomial> {
    if polynomial.is_constant() {
        return Vec::new();
    }
    match polynomial.factor_within(&Budget::default()) {
        Ok(product) => product.factors.into_iter().map(|(f, _)| f).collect(),
        Err(_) => vec![polynomial.clone()],
    }
}
