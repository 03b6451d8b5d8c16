//! What the checker says of a statement in words: a verdict, and the facts behind it.
//!
//! Every number is exact: rational, or a real algebraic number. A sign that was proved by its
//! coefficients or by completing a square carries that proof, which [`SignCertificate::verify`]
//! multiplies out.

use crate::document::VerdictWord;
use crate::theory::algebraic::Algebraic;
use num_rational::BigRational;
use num_traits::{Signed, Zero};
use ratpoly::{Polynomial, RationalFunction, RegionSign};

/// Everything that was found out about one proposition of a statement.
#[derive(Clone, Debug)]
pub struct StatementOutcome {
    /// The statement, as an index into the model.
    pub statement: usize,
    /// The proposition's number within it, from 1.
    pub member: usize,
    /// The verdict: holds, loose, refuted, undecided or recalled.
    pub word: VerdictWord,
    /// How a loose one falls short.
    pub loose: Option<Loose>,
    /// Why it is undecided or recalled.
    pub reason: Option<String>,
    /// What was found, the most telling first.
    pub facts: Vec<Fact>,
    /// The signs that it rests on.
    pub signs: Vec<SignCertificate>,
}

/// How a statement that is loose falls short of being true.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Loose {
    /// True at the reference values, and not for all values.
    Partly,
    /// False, by no more than the tolerance.
    Nearly,
    /// False in this reading and true in another one of the same sentence.
    Otherwise,
}

/// What a sign or a witness is about.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Subject {
    /// The quantity.
    Quantity,
    /// Its derivative by a letter.
    Derivative(usize),
    /// Its second derivative by a letter.
    SecondDerivative(usize),
    /// The difference to what it is compared with.
    Difference,
    /// The derivative of the quotient with what it is compared with.
    QuotientDerivative(usize),
}

/// Where something is so.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Scope {
    /// For all values of the letters, the positive ones positive.
    Everywhere,
    /// Inside a box: letters with their least and largest values, the others as in the reference.
    Box(Vec<(usize, BigRational, BigRational)>),
    /// At the reference values.
    Reference,
    /// For one letter, the others as in the reference.
    Line(usize),
    /// Everywhere as long as a letter is greater than this.
    Above(usize, BigRational),
    /// For one letter greater than this, the others as in the reference.
    LineAbove(usize, BigRational),
}

/// A sign.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Sign {
    /// Zero everywhere.
    Zero,
    /// Greater than zero.
    Positive,
    /// Less than zero.
    Negative,
    /// Not less than zero.
    NonNegative,
    /// Not greater than zero.
    NonPositive,
    /// Both signs.
    Both,
}

impl Sign {
    /// The sign that is known of a region.
    pub fn of(sign: &RegionSign) -> Option<Sign> {
        Some(match sign {
            RegionSign::Zero => Sign::Zero,
            RegionSign::Positive => Sign::Positive,
            RegionSign::Negative => Sign::Negative,
            RegionSign::NonNegative => Sign::NonNegative,
            RegionSign::NonPositive => Sign::NonPositive,
            RegionSign::Changes { .. } => Sign::Both,
            _ => return None,
        })
    }
}

/// What a number is.
#[derive(Clone, Debug, PartialEq)]
pub enum Measure {
    /// The relative change of the quantity for a relative change of a letter.
    Elasticity(usize),
    /// The same for the quotient with what the quantity is compared with.
    QuotientElasticity(usize),
    /// How much one elasticity changes with the logarithm of another letter.
    MixedElasticity(usize, usize),
    /// By what the quantity is multiplied when a letter's reference value is multiplied.
    Factor(usize, BigRational),
    /// The value of a letter at which the quantity is least or largest, the others as in the
    /// reference.
    Stationary(usize),
    /// A value of a letter over the one at which the quantity is least or largest, less one.
    Distance(usize),
    /// The quantity there over its least or largest value, less one.
    Loss(usize),
    /// The quantity over what it is compared with.
    Ratio,
    /// The same, less one.
    Deviation,
    /// From which multiple of a letter's reference value on it is otherwise.
    Threshold(usize),
    /// The value of a letter, other than its reference value, at which the quantity is the same.
    SameAgain(usize),
    /// The quantity at the other quantity's minimum over its own minimum, less one.
    Worse(usize),
    /// The quantity at the other quantity's minimum over its value at the reference point.
    AgainstReference(usize),
    /// The value at the reference point.
    Value,
}

/// The limit of a quantity.
#[derive(Clone, Debug, PartialEq)]
pub enum Limit {
    /// A function of the other letters.
    Finite(RationalFunction),
    /// It grows beyond all numbers.
    Infinity,
    /// It falls below all numbers.
    MinusInfinity,
    /// It is unbounded, with a sign that is not known.
    Unbounded,
}

/// A root in closed form: `rational + outside sqrt(inside)`.
#[derive(Clone, Debug, PartialEq)]
pub struct ClosedForm {
    /// The part without a root.
    pub rational: RationalFunction,
    /// What stands before the root.
    pub outside: RationalFunction,
    /// What stands below it; one where there is no root.
    pub inside: RationalFunction,
}

/// Something that was found out.
#[derive(Clone, Debug, PartialEq)]
pub enum Fact {
    /// A number.
    Number(Measure, Algebraic),
    /// The least and the largest value of a number inside a box.
    Range {
        /// What number.
        measure: Measure,
        /// Its least value.
        low: Algebraic,
        /// Its largest value.
        high: Algebraic,
        /// Where.
        scope: Scope,
    },
    /// A sign.
    Sign(Subject, Sign, Scope),
    /// Irreducible polynomials at whose zeros a sign changes.
    Boundary(Subject, Vec<Polynomial>),
    /// An exact point with a value that has the wrong sign.
    Witness {
        /// The value of what.
        subject: Subject,
        /// The point.
        point: Vec<(usize, BigRational)>,
        /// The value.
        value: BigRational,
    },
    /// The only stationary point on the positive half-line of a letter.
    Extremum {
        /// The letter.
        letter: usize,
        /// Whether the quantity is least there; otherwise it is largest.
        minimum: bool,
        /// The letter's value there, where it has a closed form.
        closed: Option<ClosedForm>,
        /// Whether it is so for all values of the other letters, or for the reference values.
        scope: Scope,
        /// Whether it is at an end of the letter's range.
        at_end: bool,
        /// Whether it is about the other quantity that the statement names.
        other: bool,
    },
    /// At the value of a letter that is named it is less (larger) than at all others, for all values of
    /// the other letters.
    Best {
        /// The letter.
        letter: usize,
        /// Whether the quantity is least there; otherwise it is largest.
        minimum: bool,
        /// Whether that is an end of the letter's range.
        end: bool,
    },
    /// There is no such point.
    NoExtremum(usize, Scope),
    /// It is least (largest) at several values of a letter, or at none.
    NotOnce {
        /// The letter.
        letter: usize,
        /// Whether it is about the least values.
        minimum: bool,
        /// At several and not at none.
        several: bool,
        /// Where this is so.
        scope: Scope,
    },
    /// A limit.
    Limit(usize, Limit),
    /// Divisors that may vanish where the statement is meant: there it has a pole.
    Pole(Vec<Polynomial>),
    /// Where the verdict is about, if that is not everywhere.
    About(Scope),
    /// The letters that it depends on.
    DependsOn(Vec<usize>),
    /// The quotient of the quantity and what it is compared with.
    Quotient(RationalFunction),
    /// The unit that was found, and the one that was expected.
    Units(String, String),
    /// Separates as a sum, or as a product.
    Separates(bool),
    /// A rational function, or a matrix of them: how many entries, how many terms.
    Explicit(usize, usize),
    /// Letters in it stand for functions that are not rational.
    Functions(Vec<usize>),
    /// The equations that it was judged with as corrected: with what is printed it is not seen to be so.
    Corrected(Vec<usize>),
}

/// The sign of a function as the product of the signs of its factors.
#[derive(Clone, Debug)]
pub struct SignCertificate {
    /// What has the sign.
    pub function: RationalFunction,
    /// The sign that is claimed.
    pub sign: Sign,
    /// The positive letters.
    pub positive: Vec<usize>,
    /// A number whose sign counts, and factors with their multiplicity and proof: their product is
    /// numerator times denominator.
    pub content: num_bigint::BigInt,
    /// The factors.
    pub factors: Vec<(Polynomial, u32, FactorProof)>,
}

/// Why a factor has one sign while its letters are positive.
#[derive(Clone, Debug, PartialEq)]
pub enum FactorProof {
    /// All coefficients have this sign.
    Coefficients(Sign),
    /// With `f = a x^2 + b x + c`: a has this sign, and so have all coefficients of `4ac - b^2`
    /// times the sign of a; so `4a f = (2ax + b)^2 + (4ac - b^2)`.
    Square(usize, Sign),
    /// By the methods of the polynomial engine (samples, discriminants, multipliers, subdivision).
    Engine(Sign),
}

impl FactorProof {
    /// The sign that it proves.
    pub fn sign(&self) -> Sign {
        match self {
            FactorProof::Coefficients(s) | FactorProof::Square(_, s) | FactorProof::Engine(s) => *s,
        }
    }
}

impl SignCertificate {
    /// Whether every step can be checked by multiplication.
    pub fn is_elementary(&self) -> bool {
        let engine = |p: &FactorProof| matches!(p, FactorProof::Engine(_));
        !self.factors.iter().any(|(_, _, proof)| engine(proof))
    }

    /// Multiplies the factors out and looks at the coefficients; what only the engine knows is
    /// taken from it.
    pub fn verify(&self) -> bool {
        let ring = self.function.ring();
        let mut product = Polynomial::constant(ring, self.content.clone());
        for (factor, multiplicity, _) in &self.factors {
            product *= factor.pow(*multiplicity);
        }
        if product != self.function.numerator() * self.function.denominator() {
            return false;
        }
        if self.content.is_zero() {
            return self.sign == Sign::Zero;
        }
        let mut sign = signed(self.content.is_positive());
        for (factor, multiplicity, proof) in &self.factors {
            if !self.proves(factor, proof) {
                return false;
            }
            sign = times(sign, power(proof.sign(), *multiplicity));
        }
        sign == self.sign
    }

    fn proves(&self, factor: &Polynomial, proof: &FactorProof) -> bool {
        match proof {
            FactorProof::Coefficients(sign) => {
                coefficient_sign(factor, &self.positive) == Some(*sign)
            }
            FactorProof::Square(x, sign) => square_sign(factor, *x, &self.positive) == Some(*sign),
            FactorProof::Engine(_) => true,
        }
    }
}

fn signed(positive: bool) -> Sign {
    if positive {
        Sign::Positive
    } else {
        Sign::Negative
    }
}

/// The sign of a product.
pub fn times(a: Sign, b: Sign) -> Sign {
    use Sign::{Both, Negative, NonNegative, NonPositive, Positive, Zero};
    match (a, b) {
        (Zero, _) | (_, Zero) => Zero,
        (Both, _) | (_, Both) => Both,
        (Positive, x) | (x, Positive) => x,
        (Negative, Negative) => Positive,
        (Negative, NonNegative) | (NonNegative, Negative) => NonPositive,
        (Negative, NonPositive) | (NonPositive, Negative) => NonNegative,
        (NonNegative, NonPositive) | (NonPositive, NonNegative) => NonPositive,
        (NonNegative, NonNegative) | (NonPositive, NonPositive) => NonNegative,
    }
}

/// The sign of a power.
pub fn power(sign: Sign, exponent: u32) -> Sign {
    match sign {
        _ if exponent % 2 == 1 => sign,
        Sign::Zero => Sign::Zero,
        Sign::Positive | Sign::Negative => Sign::Positive,
        _ => Sign::NonNegative,
    }
}

/// The sign of a polynomial whose letters are all positive and whose coefficients have one sign.
pub fn coefficient_sign(f: &Polynomial, positive: &[usize]) -> Option<Sign> {
    if f.variables_occurring()
        .iter()
        .any(|x| !positive.contains(x))
    {
        return None;
    }
    let mut signs = f.terms().map(|(_, c)| c.is_positive());
    let first = signs.next()?;
    signs.all(|s| s == first).then(|| signed(first))
}

/// The sign of a quadratic polynomial in `x` whose discriminant is negative by its coefficients.
pub fn square_sign(f: &Polynomial, x: usize, positive: &[usize]) -> Option<Sign> {
    let [c, b, a] = <[Polynomial; 3]>::try_from(f.coefficients_in(x)).ok()?;
    let sign = coefficient_sign(&a, positive)?;
    let rest = &(&a * &c).mul_integer(&4.into()) - &(&b * &b);
    (coefficient_sign(&rest, positive) == Some(Sign::Positive)).then_some(sign)
}
