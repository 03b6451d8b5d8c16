//! What shows that something is false: a point, a structure, or a counter-proof, and nothing else.
//!
//! A [`Refutation`] cannot be made without one of the three. That two formulas look different is none.

use super::ResidualEntry;
use crate::span::Span;
use crate::theory::limit::Limit;
use num_rational::BigRational;
use num_traits::Signed;
use ratpoly::Polynomial;

/// Why an equation is false.
#[derive(Clone, Debug)]
pub struct Refutation {
    shown: Shown,
    /// How far a correction was looked for in vain; none where it was not looked for or was found.
    pub searched: Option<Searched>,
    /// Left minus right, the entries that do not vanish. With something missing, as if it were zero.
    pub residual: Vec<ResidualEntry>,
    /// Where it is true all the same, if it is false only on a part of its domain.
    pub part: Option<Part>,
    /// That the document's own values contradict what it states of the equation, in words: then the point that shows
    /// it false is none of theirs.
    pub contradicted: Option<String>,
}

/// What shows that a claim is false.
#[derive(Clone, Debug)]
pub enum Shown {
    /// Values of the letters that the declarations and hypotheses admit, at which the sides are apart.
    Point(Witness),
    /// Something that is read off without values.
    Structure(Structure),
    /// A proof of what excludes the claim.
    CounterProof(CounterProof),
}

/// What does not fit, whatever the values are.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Structure {
    /// Something that the equation names does not exist, such as `H_{0,1}`.
    Missing {
        /// Its name.
        name: String,
        /// A point where the sides differ if it is read as zero.
        read_as_zero: Option<Box<Witness>>,
    },
    /// Shapes that do not fit; then there is no residual.
    Misfit(Misfit),
    /// A function's argument is not free in what defines it.
    Scope {
        /// The argument.
        argument: String,
        /// Whether an integral binds it; otherwise it does not occur.
        bound: bool,
        /// The letters that are left free instead.
        free: Vec<String>,
    },
    /// The limit is taken elsewhere than at the printed argument.
    Elsewhere,
}

/// What was proved and excludes the claim.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum CounterProof {
    /// The limit is another one.
    Limit(Limit),
    /// An integral in it has no value.
    Divergent {
        /// Why.
        reason: String,
    },
    /// On two ways there it has two limits.
    TwoLimits(Limit, Limit),
    /// Against a test function the two sides give different numbers: the multiple of the Dirac
    /// distribution of this argument that left minus right contains is not zero at a point.
    Distribution {
        /// The letter of the ring that is the distribution's argument.
        argument: usize,
        /// The multiple on the left and on the right, at a point.
        multiples: Box<Witness>,
    },
    /// A covariance of a system that has no stationary state.
    Unstable {
        /// The order of the first Hurwitz determinant that is not positive.
        order: usize,
        /// That determinant, at the reference values where there are such.
        determinant: String,
    },
    /// What is called a covariance has a principal minor that is negative.
    NoCovariance {
        /// That minor, at the reference values where there are such.
        minor: String,
    },
}

impl Refutation {
    /// False, for what is shown.
    pub fn new(shown: Shown) -> Self {
        Refutation {
            shown,
            searched: None,
            residual: Vec::new(),
            part: None,
            contradicted: None,
        }
    }

    /// False at a point.
    pub fn at(witness: Witness) -> Self {
        Refutation::new(Shown::Point(witness))
    }

    /// False by its structure.
    pub fn by_structure(structure: Structure) -> Self {
        Refutation::new(Shown::Structure(structure))
    }

    /// False by a proof of something else.
    pub fn by_counter_proof(proof: CounterProof) -> Self {
        Refutation::new(Shown::CounterProof(proof))
    }

    /// The same with the residual of the sides.
    #[must_use]
    pub fn with_residual(mut self, residual: Vec<ResidualEntry>) -> Self {
        self.residual = residual;
        self
    }

    /// What shows it.
    pub fn shown(&self) -> &Shown {
        &self.shown
    }

    /// The point at which the sides are apart, if one shows it.
    pub fn witness(&self) -> Option<&Witness> {
        match &self.shown {
            Shown::Point(witness) => Some(witness),
            Shown::Structure(Structure::Missing { read_as_zero, .. }) => read_as_zero.as_deref(),
            Shown::Structure(_) | Shown::CounterProof(_) => None,
        }
    }

    /// The name of what does not exist, if that is why.
    pub fn missing(&self) -> Option<&str> {
        match &self.shown {
            Shown::Structure(Structure::Missing { name, .. }) => Some(name),
            Shown::Point(_) | Shown::Structure(_) | Shown::CounterProof(_) => None,
        }
    }

    /// The shapes that do not fit, if that is why.
    pub fn misfit(&self) -> Option<&Misfit> {
        match &self.shown {
            Shown::Structure(Structure::Misfit(misfit)) => Some(misfit),
            Shown::Point(_) | Shown::Structure(_) | Shown::CounterProof(_) => None,
        }
    }

    /// The counter-proof, if that is why.
    pub fn counter_proof(&self) -> Option<&CounterProof> {
        match &self.shown {
            Shown::CounterProof(proof) => Some(proof),
            Shown::Point(_) | Shown::Structure(_) => None,
        }
    }
}

/// How many candidates for a correction were tried, and how many would have been at most.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Searched {
    /// Tried.
    pub tried: usize,
    /// How many there were, as far as they had been listed when the search ended.
    pub of: usize,
    /// The most.
    pub budget: usize,
    /// What ended the search before all were tried, if anything did.
    pub ended: Option<Ended>,
    /// How many make it true and say less than the print, such as both sides the same.
    pub empty: usize,
}

impl Searched {
    /// A search of so many candidates that ended before the first was tried.
    pub fn none_of(budget: usize, ended: Ended) -> Self {
        Searched {
            tried: 0,
            of: 0,
            budget,
            ended: Some(ended),
            empty: 0,
        }
    }
}

/// What ends a search before all candidates are tried.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Ended {
    /// The number of candidates.
    Candidates,
    /// The work in steps.
    Work,
    /// Whoever started it.
    Interrupted,
}

/// Where an equation or inequality is true that is false elsewhere.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Part {
    /// Where all conditions of one of these lists hold.
    Signs(Vec<Vec<SignCondition>>),
    /// At least around this point.
    Around(Vec<(usize, BigRational)>),
}

/// That a function is not negative, or not positive.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SignCondition {
    /// The function of the declared letters.
    pub function: Polynomial,
    /// Whether it is not positive.
    pub negative: bool,
}

/// An operation in an equation whose operands' shapes do not fit.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Misfit {
    /// What was being done, such as `*` or `=`.
    pub operation: String,
    /// The left operand's shape, such as `4x1`.
    pub left: String,
    /// The right operand's shape.
    pub right: String,
    /// Where.
    pub span: Span,
}

/// A value at a point: exact, or between two rational numbers that are proved to enclose it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum PointValue {
    /// Exactly this number.
    Exact(BigRational),
    /// A real number that is at least the first and at most the second.
    Between(BigRational, BigRational),
    /// Real and imaginary part of a complex number.
    Complex(Box<[PointValue; 2]>),
}

impl PointValue {
    /// The number, where it is exact.
    pub fn exact(&self) -> Option<&BigRational> {
        match self {
            PointValue::Exact(number) => Some(number),
            PointValue::Between(..) | PointValue::Complex(_) => None,
        }
    }

    /// Whether the two certainly differ.
    pub fn is_apart_from(&self, other: &Self) -> bool {
        let zero = PointValue::Exact(BigRational::from_integer(0.into()));
        match (self, other) {
            (PointValue::Complex(a), PointValue::Complex(b)) => {
                a[0].is_apart_from(&b[0]) || a[1].is_apart_from(&b[1])
            }
            (PointValue::Complex(a), real) | (real, PointValue::Complex(a)) => {
                a[0].is_apart_from(real) || a[1].is_apart_from(&zero)
            }
            (
                PointValue::Exact(a) | PointValue::Between(a, _),
                PointValue::Exact(d) | PointValue::Between(_, d),
            ) if d < a => true,
            (
                PointValue::Exact(b) | PointValue::Between(_, b),
                PointValue::Exact(c) | PointValue::Between(c, _),
            ) => b < c,
        }
    }

    /// The digits that are certain, such as `3.14159...`; none where it is a fraction itself. What is very
    /// large is told by powers of two between which it lies.
    pub fn digits(low: &BigRational, high: &BigRational, most: usize) -> String {
        let sizes = [low, high].map(|end| {
            let whole = end.to_integer();
            whole.magnitude().bits()
        });
        if sizes.iter().any(|bits| *bits > LONGEST) {
            return between_powers(low, high, sizes);
        }
        for digits in (0..=most).rev() {
            let scale = num_traits::pow(BigRational::from_integer(10.into()), digits);
            let (from, to) = ((low * &scale).trunc(), (high * &scale).trunc());
            let same_sign = low.is_negative() == high.is_negative();
            if from == to && same_sign {
                let number = from.to_integer().magnitude().to_string();
                let padded = format!("{number:0>width$}", width = digits + 1);
                let (whole, decimals) = padded.split_at(padded.len() - digits);
                let sign = if low.is_negative() { "-" } else { "" };
                return match decimals.is_empty() {
                    true => format!("{sign}{whole}..."),
                    false => format!("{sign}{whole}.{decimals}..."),
                };
            }
        }
        // Next to a number with few digits none is certain, but how near it is.
        let scale = num_traits::pow(BigRational::from_integer(10.into()), most);
        let half = BigRational::new(1.into(), 2.into());
        let middle = ((low + high) * &half * &scale + &half).floor().to_integer();
        let near = |end: &BigRational| {
            (end * &scale - BigRational::from_integer(middle.clone())).abs()
                <= BigRational::from_integer(1.into())
        };
        if near(low) && near(high) {
            let number = middle.magnitude().to_string();
            let padded = format!("{number:0>width$}", width = most + 1);
            let (whole, decimals) = padded.split_at(padded.len() - most);
            let sign = if middle.is_negative() { "-" } else { "" };
            return format!("{sign}{whole}.{decimals} ± 10^-{most}");
        }
        // Where these have many digits themselves, numbers around them that have fewer.
        if [low, high].iter().all(|q| q.denom().bits() <= LONGEST / 4) {
            return format!("between {low} and {high}");
        }
        let wide = |end: &BigRational| (end * &scale).floor().to_integer();
        let [from, to] =
            [wide(low), wide(high) + 1].map(|n| BigRational::new(n, scale.to_integer()));
        format!("between {from} and {to}")
    }
}

/// How many binary digits a number may have that is written out.
const LONGEST: u64 = 256;

/// Powers of two between which a number lies whose ends have so many binary digits before the point.
fn between_powers(low: &BigRational, high: &BigRational, sizes: [u64; 2]) -> String {
    let outer = |bits: u64| format!("2^{bits}");
    let inner = |bits: u64, sign: &str| match bits.checked_sub(1) {
        Some(bits) => format!("{sign}2^{bits}"),
        None => "0".into(),
    };
    let from = match low.is_negative() {
        true => format!("-{}", outer(sizes[0])),
        false => inner(sizes[0], ""),
    };
    let to = match high.is_negative() {
        true => inner(sizes[1], "-"),
        false => outer(sizes[1]),
    };
    format!("between {from} and {to}")
}

/// A point with the values of both sides there.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Witness {
    /// Letters of the ring that occur and their values.
    pub point: Vec<(usize, PointValue)>,
    /// The left side's entry there.
    pub left: PointValue,
    /// The right side's entry there.
    pub right: PointValue,
    /// Which entry.
    pub place: Option<(usize, usize)>,
    /// Values of the running indices.
    pub indices: Vec<(String, i64)>,
}
