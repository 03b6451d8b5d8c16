//! Whether what is called a covariance belongs to a system that has a stationary state.
//!
//! A covariance that solves A P + P A^T + Q = 0 exists if A is stable, one that solves P = F P F^T + Q if
//! all eigenvalues of F lie inside of the unit circle: Hurwitz's determinants say so. Of any other
//! covariance, scalars among them, what is known is that it has no negative principal minor. Either
//! must hold for all admitted values of the letters, or at the reference point; where nothing refers to
//! numbers, at some admitted point, and then it is a condition. What fails everywhere, or at the reference
//! point, has no covariance, and nothing holds of it; what is not seen to exist stays undecided.

mod degenerate;
mod form;
mod partial;

pub(super) use partial::{EXISTS_FOR_SOME, PartialCovariance};

use super::Checker;
use crate::domain::Domain;
use crate::evaluate::{Condition, FailureKind, Origin, Stationary, Value};
use crate::matrix::Matrix;
use crate::model::{Letter, Model, Node};
use crate::theory::stability::hurwitz_determinants;
use crate::theory::{characteristic, determinant, discrete};
use crate::verdict::{CounterProof, Refutation, Verdict};
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{Signed, Zero};
use ratpoly::{RationalFunction, RegionSign};
use std::cmp::Ordering;
use std::collections::BTreeSet;

/// How many points are looked at for one with a stationary state.
const POINTS: usize = 60;
/// Covariances of a larger order are not asked for all their principal minors.
const LARGEST_ORDER: usize = 3;
/// The sign of a function with more terms or letters is not sought for all values.
const LONG: usize = 40;
const MANY: usize = 6;

/// What must be positive for a covariance to exist.
struct Demand {
    /// What must be positive, or not negative.
    functions: Vec<RationalFunction>,
    /// Whether zero is excluded.
    strict: bool,
    /// Whether it is seen from how the system is made, and not from its solution.
    of_system: bool,
}

/// What became of it.
enum Standing {
    /// It exists for all admitted values.
    Exists,
    /// It exists where the functions are positive, and somewhere they are.
    Where(Vec<RationalFunction>),
    /// It does not exist.
    Never(CounterProof),
    /// Nothing shows that it exists.
    Unknown,
}

impl Model {
    /// The equation that gives a node its value; none where it stands for itself.
    fn equation_giving(&self, node: Node) -> Option<usize> {
        match node {
            Node::Definition(definition) => Some(self.definitions[definition].equation),
            Node::Unknown { system, .. } => Some(self.systems[system].equation),
            Node::Symbol(_) | Node::Matrix(_) | Node::Notation(_) => None,
        }
    }

    /// Whether a node is the covariance of a random vector with itself.
    fn is_covariance(&self, node: Node) -> bool {
        self.covariances()
            .any(|(_, n, covariance)| n == node && covariance.left == covariance.right)
    }
}

impl Checker<'_> {
    /// The verdict on an equation that determines a covariance which does not exist, or of which nothing
    /// shows that it does; none where all is well. What has no covariance has no value from now on.
    pub(super) fn no_covariance(&mut self, node: Node, equation: usize) -> Option<Verdict> {
        if let Some(verdict) = self.malformed_covariance(node) {
            return Some(verdict);
        }
        let (demand, determined) = self.demand(node)?;
        match self.standing(&demand) {
            Standing::Exists => None,
            Standing::Where(functions) => {
                if determined {
                    let conditions = functions.into_iter().map(|divisor| Condition {
                        divisor,
                        origin: Origin::Stability(equation),
                    });
                    self.exact.conditions.extend(conditions);
                }
                None
            }
            Standing::Never(proof) => {
                self.has_no_value(node, FailureKind::NotStationary);
                Some(Verdict::Refuted(Refutation::by_counter_proof(proof)))
            }
            // What is stated is stated; what is computed must exist.
            Standing::Unknown if !determined => None,
            Standing::Unknown => {
                let what = "a covariance of a system that nothing shows to be stable";
                let kind = FailureKind::Unsupported { what: what.into() };
                self.has_no_value(node, kind);
                Some(Verdict::Undecided {
                    reason: "nothing shows that the system is stable: declare its letters \
                             positive, or give them values"
                        .into(),
                })
            }
        }
    }

    /// What a covariance demands to exist, and whether a system determines it; none where it is none or has
    /// no value.
    fn demand(&mut self, node: Node) -> Option<(Demand, bool)> {
        if !self.model.is_covariance(node) {
            return None;
        }
        let equation = self.model.equation_giving(node)?;
        let span = self.model.equations[equation].span;
        let value = self.exact.value_of((node, Vec::new(), 0), span).ok()?;
        let solved = match node {
            Node::Unknown { system, .. } => self.demand_of_system(system),
            Node::Definition(_) | Node::Symbol(_) | Node::Matrix(_) | Node::Notation(_) => None,
        };
        let demand = match solved {
            Some(demand) => demand,
            None => self.demand_of_value(&value)?,
        };
        Some((demand, matches!(node, Node::Unknown { .. })))
    }

    /// What the system demands, where its equation is one of the two forms.
    fn demand_of_system(&self, system: usize) -> Option<Demand> {
        let field = &self.exact.field;
        let functions = match self.exact.stationary(system)? {
            Stationary::Continuous { matrix, noise } => {
                // -A P - P A^T - Q = 0 is the same equation.
                let matrix = match self.sign_of_noise(noise)? {
                    Ordering::Less => matrix.map(|entry| field.negate(entry)),
                    Ordering::Equal | Ordering::Greater => matrix.clone(),
                };
                hurwitz_determinants(field, "A", &matrix).ok()?
            }
            Stationary::Discrete { square } => {
                let coefficients = characteristic::characteristic_coefficients(field, square)?;
                let minus = |minors: Option<Vec<RationalFunction>>| match minors {
                    Some(minors) => minors,
                    None => vec![RationalFunction::zero(self.model.ring)],
                };
                minus(discrete::inside_the_unit_circle(field, &coefficients))
            }
        };
        Some(Demand {
            functions,
            strict: true,
            of_system: true,
        })
    }

    /// The sign of the intensity of the noise, for all values or at the reference point: by it the sign
    /// is told with which the equation is printed.
    fn sign_of_noise(&self, noise: &RationalFunction) -> Option<Ordering> {
        match self.sign(noise) {
            RegionSign::Positive | RegionSign::NonNegative => return Some(Ordering::Greater),
            RegionSign::Negative | RegionSign::NonPositive => return Some(Ordering::Less),
            RegionSign::Zero => return Some(Ordering::Equal),
            _ => {}
        }
        let noise = self.spelt(noise)?;
        self.all_have_values(&[&noise])
            .then(|| self.sign_at(&noise, &self.reference_point()))?
    }

    /// What a covariance itself demands: that no principal minor is negative.
    fn demand_of_value(&self, value: &Value<RationalFunction>) -> Option<Demand> {
        let field = &self.exact.field;
        let matrix = match value {
            Value::Scalar(s) => Matrix::from_fn(1, 1, |_, _| s.clone()),
            Value::Matrix(m) if m.is_square() => m.clone(),
            Value::Matrix(_) | Value::Zero => return None,
        };
        let n = matrix.rows();
        let subsets: Vec<Vec<usize>> = if n <= LARGEST_ORDER {
            (1..1usize << n)
                .map(|set| (0..n).filter(|i| set >> i & 1 == 1).collect())
                .collect()
        } else {
            (0..n).map(|i| vec![i]).collect()
        };
        let functions = subsets
            .iter()
            .map(|kept| {
                let minor = Matrix::from_fn(kept.len(), kept.len(), |i, j| {
                    matrix[(kept[i], kept[j])].clone()
                });
                determinant::determinant(field, &minor)
            })
            .collect::<Option<Vec<_>>>()?;
        Some(Demand {
            functions,
            strict: false,
            of_system: false,
        })
    }

    fn standing(&self, demand: &Demand) -> Standing {
        let spelt: Option<Vec<RationalFunction>> =
            demand.functions.iter().map(|f| self.spelt(f)).collect();
        let Some(functions) = spelt else {
            return Standing::Unknown;
        };
        let never = |k: usize, value: String| {
            Standing::Never(if demand.of_system {
                CounterProof::Unstable {
                    order: k + 1,
                    determinant: value,
                }
            } else {
                CounterProof::NoCovariance { minor: value }
            })
        };
        let fails = |sign: Ordering| match sign {
            Ordering::Less => true,
            Ordering::Equal => demand.strict,
            Ordering::Greater => false,
        };
        let refs: Vec<&RationalFunction> = functions.iter().collect();
        let referred = self.all_have_values(&refs);
        let reference = self.reference_point();
        if referred {
            for (k, function) in functions.iter().enumerate() {
                match self.sign_at(function, &reference) {
                    Some(sign) if fails(sign) => {
                        let value = function.evaluate(&reference);
                        let shown = match value {
                            Ok(value) if self.is_rational(function) => value.to_string(),
                            _ => function.to_string(),
                        };
                        return never(k, shown);
                    }
                    Some(_) => {}
                    None => return Standing::Unknown,
                }
            }
        }
        let mut open = Vec::new();
        for (k, function) in functions.iter().enumerate() {
            let short = function.numerator().len() + function.denominator().len() <= LONG
                && self.exact.field.letters_behind(function).len() <= MANY;
            let sign = match short {
                true => self.sign(function),
                false if self.has_positive_terms(function) => RegionSign::Positive,
                false => RegionSign::Undecided,
            };
            match sign {
                RegionSign::Positive => {}
                RegionSign::NonNegative if !demand.strict => {}
                RegionSign::Zero if !demand.strict => {}
                RegionSign::Zero | RegionSign::Negative => return never(k, function.to_string()),
                RegionSign::NonPositive if demand.strict => return never(k, function.to_string()),
                _ => open.push(demand.functions[k].clone()),
            }
        }
        if open.is_empty() {
            return Standing::Exists;
        }
        let admits = |point: &Vec<BigRational>| {
            let mut signs = functions.iter().map(|f| self.sign_at(f, point));
            signs.all(|sign| sign.is_some_and(|sign| !fails(sign)))
        };
        match referred || (0..POINTS).any(|k| admits(&self.admitted_point(k))) {
            true => Standing::Where(open),
            false => Standing::Unknown,
        }
    }

    /// A function with all definitions inserted.
    fn spelt(&self, function: &RationalFunction) -> Option<RationalFunction> {
        let all = self.insertion(&self.inserted.keys().copied().collect::<Vec<_>>());
        match &self.model.functions {
            Some(table) => table.substitute(function, &all.letters).ok(),
            None => function.substitute(&all.letters).ok(),
        }
    }

    /// Whether positive letters and coefficients show that a function is positive.
    fn has_positive_terms(&self, function: &RationalFunction) -> bool {
        let positive = |p: &ratpoly::Polynomial| p.terms().all(|(_, c)| c.is_positive());
        let letters = self.exact.field.letters(function);
        letters.iter().all(|l| self.model.is_positive(*l))
            && !function.is_zero()
            && positive(function.numerator())
            && positive(function.denominator())
    }

    fn is_rational(&self, function: &RationalFunction) -> bool {
        let letters = self.exact.field.letters(function);
        !letters.iter().any(|l| self.is_function(*l))
    }

    /// Whether all declared letters behind these have reference values.
    fn all_have_values(&self, functions: &[&RationalFunction]) -> bool {
        let field = &self.exact.field;
        let letters: BTreeSet<usize> = functions
            .iter()
            .flat_map(|f| field.letters_behind(f))
            .collect();
        let mut plain = letters.iter().filter(|l| !self.is_function(**l));
        plain.all(|l| self.has_reference(*l))
    }

    /// The sign of a function at a point of the declared letters, where it is certain.
    fn sign_at(&self, function: &RationalFunction, point: &[BigRational]) -> Option<Ordering> {
        let places: Vec<Option<BigRational>> = point
            .iter()
            .enumerate()
            .map(|(letter, value)| (!self.is_function(letter)).then(|| value.clone()))
            .collect();
        let zero = BigRational::zero();
        if let Some(value) = self.value_at(function, &places) {
            return Some(value.cmp(&zero));
        }
        let table = self.model.functions.as_ref()?;
        let interval = table.enclosure(function, &places)?;
        match (interval.low > zero, interval.high < zero) {
            (true, _) => Some(Ordering::Greater),
            (_, true) => Some(Ordering::Less),
            _ => None,
        }
    }

    /// Points at which every declared letter has a value that it may have.
    fn admitted_point(&self, k: usize) -> Vec<BigRational> {
        const SIZES: [(i64, i64); 9] = [
            (1, 1),
            (1, 2),
            (3, 1),
            (1, 5),
            (7, 1),
            (1, 20),
            (30, 1),
            (2, 3),
            (5, 4),
        ];
        (0..self.model.letters.len())
            .map(|letter| {
                let (above, below) = SIZES[(k * (letter + 1) + k / 9 + letter) % SIZES.len()];
                let size = BigRational::new(BigInt::from(above), BigInt::from(below));
                let Letter::Symbol { symbol, order: 0 } = self.model.letters[letter] else {
                    return size;
                };
                let declared = &self.model.symbols[symbol];
                if let Some(value) = &declared.value {
                    return value.clone();
                }
                let range = &declared.range;
                let ends = [&range.low, &range.high].map(|end| end.as_ref().map(|e| &e.value));
                let inside = match ends {
                    // Between both ends, and from one end on.
                    [Some(low), Some(high)] => {
                        let share = &size / (&size + BigRational::from_integer(1.into()));
                        low + (high - low) * share
                    }
                    [Some(low), None] => low + &size,
                    [None, Some(high)] => high - &size,
                    [None, None] if k >> (letter % 6) & 1 == 1 => -size,
                    [None, None] => size,
                };
                if range.contains(&inside) {
                    inside
                } else {
                    inside.ceil()
                }
            })
            .collect()
    }
}
