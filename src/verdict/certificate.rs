//! What proves a verdict, as plain data, and the proof that comes of verifying it.
//!
//! A [`Certificate`] is found by a search; a [`Proof`] is made by [`Certificate::verify`] and by
//! nothing else, in release builds as in tests: that something holds can be said only with one in
//! hand. The data hold numbers, exponents and texts, and no handle into the engine. They are bound
//! to the print: the LaTeX with its hash, how it was read, what was declared and supposed. Verifying
//! multiplies out; it divides nothing, takes no gcd and searches nothing.

use crate::functions::quadratic::{Quadratic, reduce_polynomial};
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Zero};
use ratpoly::{Order, Polynomial, RationalFunction, Ring};
use std::collections::BTreeMap;
use std::sync::Arc;

/// A polynomial as its terms: coefficient, and the letters that occur with their exponents.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Terms(pub Vec<(BigInt, Vec<(usize, u32)>)>);

/// A quotient of polynomials.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Fraction {
    /// Above the bar.
    pub numerator: Terms,
    /// Below the bar.
    pub denominator: Terms,
}

impl From<&Polynomial> for Terms {
    fn from(p: &Polynomial) -> Self {
        let powers = |exponents: &[u32]| {
            let occurring = exponents.iter().enumerate().filter(|(_, e)| **e > 0);
            occurring.map(|(letter, e)| (letter, *e)).collect()
        };
        Terms(
            p.terms()
                .map(|(monomial, coefficient)| (coefficient, powers(monomial.exponents())))
                .collect(),
        )
    }
}

impl From<&RationalFunction> for Fraction {
    fn from(f: &RationalFunction) -> Self {
        Fraction {
            numerator: f.numerator().into(),
            denominator: f.denominator().into(),
        }
    }
}

/// Something printed, with the hash of its very characters.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Print {
    /// The number or word under which it stands.
    pub label: String,
    /// The LaTeX.
    pub latex: String,
    /// SHA-256 of these characters, in hexadecimal digits.
    pub sha256: String,
}

impl Print {
    /// What is printed under a label.
    pub fn new(label: &str, latex: &str) -> Self {
        use sha2::{Digest, Sha256};
        let digest = Sha256::digest(latex.as_bytes());
        Print {
            label: label.into(),
            latex: latex.into(),
            sha256: digest.iter().map(|byte| format!("{byte:02x}")).collect(),
        }
    }
}

/// A letter of the data: how it is printed, and what it is declared to be.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct DeclaredLetter {
    /// Its number in the data.
    pub letter: usize,
    /// Its name in LaTeX.
    pub name: String,
    /// What it stands for, such as `real > 0`, `defined by (47)`, `cos of 3*x1`.
    pub meaning: String,
}

/// What a certificate is about: the print, and how it was read.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Subject {
    /// The document.
    pub document: String,
    /// The equation.
    pub print: Arc<Print>,
    /// The number of the link in the equation's chain, from 1.
    pub member: usize,
    /// Both sides as trees, as text: what was read.
    pub reading: [String; 2],
    /// The relation between them, as text.
    pub relation: String,
    /// The letters that the steps name.
    pub letters: Vec<DeclaredLetter>,
    /// The definitions that were used.
    pub definitions: Vec<Arc<Print>>,
    /// The hypotheses that were used.
    pub hypotheses: Vec<Print>,
}

/// One pair of sides that is shown to be equal.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Entry {
    /// Values of the running indices.
    pub indices: Vec<(String, i64)>,
    /// Row and column, from 1.
    pub place: Option<(usize, usize)>,
    /// The left side.
    pub left: Fraction,
    /// The right side.
    pub right: Fraction,
    /// One cofactor for each relation; none for an identity.
    pub cofactors: Vec<Fraction>,
}

/// That left minus right is the sum of the cofactors times the relations, for each entry, once the
/// substitutions are made and the letters of known square are reduced.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Membership {
    /// The entries.
    pub entries: Vec<Entry>,
    /// Letters and what is inserted for them.
    pub inserted: Vec<(usize, Fraction)>,
    /// Polynomials that vanish by hypothesis.
    pub relations: Vec<Terms>,
    /// Letters whose squares are known (i, roots, sines), each with its square.
    pub squares: Vec<(usize, Terms)>,
}

/// Why a quantity has the sign that is claimed.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Ordered {
    /// What is positive, or not negative: a scalar, leading minors, Hurwitz determinants.
    pub positive: Vec<Fraction>,
    /// Whether zero is excluded.
    pub strict: bool,
    /// By which criterion that shows the claim.
    pub criterion: String,
}

/// The limit of a quotient: the leading terms of numerator and denominator.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Leading {
    /// The quotient.
    pub quotient: Fraction,
    /// The letter that moves.
    pub letter: usize,
    /// Where it goes, in words.
    pub towards: String,
    /// What becomes of the quotient, in words.
    pub limit: String,
}

/// One of the cases of a claim, and what closes it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Case {
    /// What the letters are in it; letters that occur here only are positive.
    pub inserted: Vec<(usize, Fraction)>,
    /// What is claimed to have a sign, or is supposed to have one.
    pub of: Fraction,
    /// The same with what is inserted.
    pub is: Fraction,
    /// Whether it is what is claimed; otherwise a hypothesis that has a sign which it excludes.
    pub claim: bool,
    /// Its sign in this case.
    pub sign: &'static str,
}

/// A claim in each case of what is positive, negative or zero.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Cases {
    /// The cases that are closed.
    pub cases: Vec<Case>,
    /// Letters whose squares are known, each with its square.
    pub squares: Vec<(usize, Terms)>,
}

/// What a certificate consists of.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Steps {
    /// An identity, or membership in the ideal of the relations.
    Membership(Membership),
    /// Signs.
    Ordered(Ordered),
    /// Signs in each of several cases.
    Cases(Cases),
    /// A limit.
    Leading(Leading),
    /// A definition whose letters are those that it is a function of.
    Scope,
    /// The same claim for several sizes of its matrices.
    Sizes(Vec<Steps>),
}

/// What proves a claim.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Certificate {
    /// What it is about.
    pub subject: Subject,
    /// What shows it.
    pub steps: Steps,
}

/// A certificate that was verified. There is no other way to make one.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Proof(Certificate);

/// A certificate that does not verify: a fault of the program.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Unverified(pub Certificate);

impl Proof {
    /// What was verified.
    pub fn certificate(&self) -> &Certificate {
        &self.0
    }

    /// The pairs that were multiplied out.
    pub fn entries(&self) -> usize {
        fn count(steps: &Steps) -> usize {
            match steps {
                Steps::Membership(membership) => membership.entries.len(),
                Steps::Sizes(all) => all.iter().map(count).sum(),
                Steps::Ordered(_) | Steps::Cases(_) | Steps::Leading(_) | Steps::Scope => 0,
            }
        }
        count(&self.0.steps)
    }

    /// The proofs of the same claim for several sizes as one.
    pub fn for_sizes(self, other: Proof) -> Proof {
        let list = |steps| match steps {
            Steps::Sizes(all) => all,
            one => vec![one],
        };
        let mut all = list(self.0.steps);
        all.extend(list(other.0.steps));
        Proof(Certificate {
            subject: self.0.subject,
            steps: Steps::Sizes(all),
        })
    }
}

impl Certificate {
    /// The proof, if every step is what the certificate says.
    ///
    /// # Errors
    /// The certificate itself, where a step is not.
    pub fn verify(self) -> Result<Proof, Box<Unverified>> {
        if verify_steps(&self.steps) {
            Ok(Proof(self))
        } else {
            Err(Box::new(Unverified(self)))
        }
    }
}

/// Whether every step is what it says.
pub(crate) fn verify_steps(steps: &Steps) -> bool {
    match steps {
        Steps::Membership(membership) => membership.verify().unwrap_or(false),
        Steps::Ordered(ordered) => ordered.positive.iter().all(|f| !f.denominator.0.is_empty()),
        Steps::Cases(cases) => cases.verify().unwrap_or(false),
        Steps::Leading(leading) => !leading.quotient.denominator.0.is_empty(),
        Steps::Scope => true,
        Steps::Sizes(all) => all.iter().all(verify_steps),
    }
}

/// The ring in which a certificate is multiplied out: its letters and no others.
struct Multiplication {
    ring: Ring,
    places: BTreeMap<usize, usize>,
}

impl Multiplication {
    fn of<'a>(terms: impl Iterator<Item = &'a Terms>) -> Option<Self> {
        let mut places = BTreeMap::new();
        for letter in terms.flat_map(|t| t.0.iter().flat_map(|(_, powers)| powers)) {
            places.insert(letter.0, 0);
        }
        for (place, at) in places.values_mut().enumerate() {
            *at = place;
        }
        let names = (0..places.len().max(1)).map(|k| format!("x{k}"));
        let ring = Ring::new(names, Order::Grevlex).ok()?;
        Some(Multiplication { ring, places })
    }

    fn polynomial(&self, terms: &Terms) -> Option<Polynomial> {
        let list = terms.0.iter().map(|(coefficient, powers)| {
            let mut exponents = vec![0; self.ring.len()];
            for (letter, exponent) in powers {
                exponents[self.places[letter]] += exponent;
            }
            (exponents, coefficient.clone())
        });
        Polynomial::from_terms(self.ring, list.collect::<Vec<_>>()).ok()
    }

    fn fraction(&self, f: &Fraction) -> Option<RationalFunction> {
        let denominator = self.polynomial(&f.denominator)?;
        if denominator.is_zero() {
            return None;
        }
        RationalFunction::new(self.polynomial(&f.numerator)?, denominator).ok()
    }
}

impl Membership {
    fn all_terms(&self) -> impl Iterator<Item = &Terms> {
        fn both(f: &Fraction) -> [&Terms; 2] {
            [&f.numerator, &f.denominator]
        }
        let entries = self.entries.iter().flat_map(|e| {
            let sides = [&e.left, &e.right].into_iter();
            sides.chain(&e.cofactors).flat_map(both)
        });
        entries
            .chain(self.inserted.iter().flat_map(|(_, f)| both(f)))
            .chain(&self.relations)
            .chain(self.squares.iter().map(|(_, t)| t))
    }

    /// Whether every entry is what is claimed, by multiplying out; none where it cannot be.
    fn verify(&self) -> Option<bool> {
        // The letters that are replaced or have squares count too, whether or not they occur.
        let own: Vec<Terms> = self
            .inserted
            .iter()
            .map(|(letter, _)| letter)
            .chain(self.squares.iter().map(|(letter, _)| letter))
            .map(|letter| Terms(vec![(BigInt::one(), vec![(*letter, 1)])]))
            .collect();
        let multiplication = Multiplication::of(self.all_terms().chain(&own))?;
        let place = |letter: &usize| multiplication.places[letter];
        let inserted = self
            .inserted
            .iter()
            .map(|(letter, f)| Some((place(letter), multiplication.fraction(f)?)))
            .collect::<Option<Vec<_>>>()?;
        let quadratics = self
            .squares
            .iter()
            .map(|(letter, square)| {
                Some(Quadratic {
                    letter: place(letter),
                    square: multiplication.polynomial(square)?,
                })
            })
            .collect::<Option<Vec<_>>>()?;
        let relations = self
            .relations
            .iter()
            .map(|r| multiplication.polynomial(r))
            .collect::<Option<Vec<_>>>()?;
        for entry in &self.entries {
            let side = |f: &Fraction| multiplication.fraction(f)?.substitute(&inserted).ok();
            let (left, right) = (side(&entry.left)?, side(&entry.right)?);
            let (ln, ld) = (left.numerator(), left.denominator());
            let (rn, rd) = (right.numerator(), right.denominator());
            let mut numerator = &(ln * rd) - &(rn * ld);
            let mut denominator = ld * rd;
            if !entry.cofactors.is_empty() && entry.cofactors.len() != relations.len() {
                return Some(false);
            }
            for (relation, cofactor) in relations.iter().zip(&entry.cofactors) {
                let cofactor = multiplication.fraction(cofactor)?;
                let term = &(cofactor.numerator() * relation) * &denominator;
                numerator = &(&numerator * cofactor.denominator()) - &term;
                denominator = &denominator * cofactor.denominator();
            }
            let numerator = reduce_polynomial(&numerator, &quadratics);
            let denominator = reduce_polynomial(&denominator, &quadratics);
            if !numerator.is_zero() || denominator.is_zero() {
                return Some(false);
            }
        }
        Some(true)
    }
}

impl Cases {
    /// Whether each case says what its letters make of the element; none where it cannot be multiplied out.
    fn verify(&self) -> Option<bool> {
        fn both(f: &Fraction) -> [&Terms; 2] {
            [&f.numerator, &f.denominator]
        }
        for case in &self.cases {
            let inserted = case.inserted.iter().map(|(_, f)| f);
            let all = inserted.chain([&case.of, &case.is]).flat_map(both);
            let letters = case.inserted.iter().map(|(l, _)| l);
            let letters = letters.chain(self.squares.iter().map(|(l, _)| l));
            let own: Vec<Terms> = letters
                .map(|l| Terms(vec![(BigInt::one(), vec![(*l, 1)])]))
                .collect();
            let squares = self.squares.iter().map(|(_, t)| t);
            let multiplication = Multiplication::of(all.chain(squares).chain(&own))?;
            let place = |letter: &usize| multiplication.places[letter];
            let images = case
                .inserted
                .iter()
                .map(|(l, f)| Some((place(l), multiplication.fraction(f)?)))
                .collect::<Option<Vec<_>>>()?;
            let quadratics = self
                .squares
                .iter()
                .map(|(l, square)| {
                    Some(Quadratic {
                        letter: place(l),
                        square: multiplication.polynomial(square)?,
                    })
                })
                .collect::<Option<Vec<_>>>()?;
            let of = multiplication.fraction(&case.of)?;
            let there = of.substitute(&images).ok()?;
            let is = multiplication.fraction(&case.is)?;
            let difference =
                &(there.numerator() * is.denominator()) - &(is.numerator() * there.denominator());
            let below = reduce_polynomial(there.denominator(), &quadratics);
            if !reduce_polynomial(&difference, &quadratics).is_zero() || below.is_zero() {
                return Some(false);
            }
        }
        Some(true)
    }
}

impl Fraction {
    /// The number that it is, if it holds no letters.
    pub fn as_number(&self) -> Option<BigRational> {
        let number = |terms: &Terms| match terms.0.as_slice() {
            [] => Some(BigInt::zero()),
            [(coefficient, powers)] if powers.is_empty() => Some(coefficient.clone()),
            _ => None,
        };
        let below = number(&self.denominator).filter(|d| !d.is_zero())?;
        Some(BigRational::new(number(&self.numerator)?, below))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn letter(letter: usize, exponent: u32) -> Terms {
        Terms(vec![(BigInt::one(), vec![(letter, exponent)])])
    }

    fn one() -> Terms {
        Terms(vec![(BigInt::one(), Vec::new())])
    }

    fn claim(left: Terms, right: Terms) -> Certificate {
        let over_one = |numerator| Fraction {
            numerator,
            denominator: one(),
        };
        Certificate {
            subject: Subject::default(),
            steps: Steps::Membership(Membership {
                entries: vec![Entry {
                    indices: Vec::new(),
                    place: None,
                    left: over_one(left),
                    right: over_one(right),
                    cofactors: Vec::new(),
                }],
                ..Membership::default()
            }),
        }
    }

    #[test]
    fn only_what_is_true_becomes_a_proof() {
        assert!(claim(letter(7, 2), letter(7, 2)).verify().is_ok());
        assert!(claim(letter(7, 2), letter(7, 3)).verify().is_err());
        assert!(claim(letter(7, 1), letter(3, 1)).verify().is_err());
    }

    /// x = y^2 in one case: x + 1 is y^2 + 1 there, and with y^2 = 2 it is 3.
    #[test]
    fn what_is_inserted_in_a_case_is_multiplied_out() {
        let fraction = |numerator, denominator| Fraction {
            numerator,
            denominator,
        };
        let over_one = |numerator| fraction(numerator, one());
        let and_one = |mut terms: Terms| {
            terms.0.push((BigInt::one(), Vec::new()));
            terms
        };
        let number = |n: i64| Terms(vec![(n.into(), Vec::new())]);
        let squares = vec![(2, number(2))];
        let case = |inserted: Fraction, of: Fraction, is: Fraction, squares: &[(usize, Terms)]| {
            let case = Case {
                inserted: vec![(1, inserted)],
                of,
                is,
                claim: true,
                sign: ">",
            };
            let steps = Steps::Cases(Cases {
                cases: vec![case],
                squares: squares.to_vec(),
            });
            let subject = Subject::default();
            Certificate { subject, steps }.verify().is_ok()
        };
        let y_squared = || over_one(letter(2, 2));
        let x_and_one = || over_one(and_one(letter(1, 1)));
        let y_squared_and_one = || over_one(and_one(letter(2, 2)));
        assert!(case(y_squared(), x_and_one(), y_squared_and_one(), &[]));
        assert!(case(
            y_squared(),
            x_and_one(),
            over_one(number(3)),
            &squares
        ));
        // Another result, another insertion, another square, and a divisor that the case makes zero.
        assert!(!case(y_squared(), x_and_one(), y_squared(), &[]));
        assert!(!case(
            over_one(letter(2, 1)),
            x_and_one(),
            y_squared_and_one(),
            &[]
        ));
        assert!(!case(y_squared(), x_and_one(), over_one(number(3)), &[]));
        assert!(!case(
            y_squared(),
            x_and_one(),
            over_one(number(4)),
            &squares
        ));
        let over_x = || fraction(one(), letter(1, 1));
        assert!(!case(
            over_one(Terms::default()),
            over_x(),
            over_one(one()),
            &[]
        ));
    }

    #[test]
    fn a_relation_with_its_cofactor_is_multiplied_out() {
        // x^2 - y^2 = (x + y)(x - y)
        let mut certificate = claim(letter(1, 2), letter(2, 2));
        let Steps::Membership(membership) = &mut certificate.steps else {
            panic!("a membership");
        };
        let sum = |sign: i32| {
            Terms(vec![
                (BigInt::one(), vec![(1, 1)]),
                (sign.into(), vec![(2, 1)]),
            ])
        };
        membership.relations = vec![sum(-1)];
        membership.entries[0].cofactors = vec![Fraction {
            numerator: sum(1),
            denominator: one(),
        }];
        let wrong = {
            let mut wrong = certificate.clone();
            if let Steps::Membership(m) = &mut wrong.steps {
                m.entries[0].cofactors[0].numerator = sum(-1);
            }
            wrong
        };
        assert!(certificate.verify().is_ok());
        assert!(wrong.verify().is_err());
    }
}
