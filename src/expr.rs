//! The syntax tree that every stage shares: what is printed, not what it means.
//!
//! A tree keeps enough of the typesetting (brackets, slash or bar, underbraces) to be written
//! back as the reader saw it, and nothing of the meaning: whether `P_{33}` is an entry or a
//! letter with a label is decided by the document's model. The exact and the floating-point
//! route meet only here.

pub mod integer;
pub mod reading;
pub mod walk;

use crate::span::Span;
use num_rational::BigRational;
use std::sync::Arc;

/// A printed expression with its place in the document.
#[derive(Clone, Debug)]
pub struct Expr {
    /// What is printed.
    pub kind: ExprKind,
    /// Where.
    pub span: Span,
}

/// Equality of what is printed; the place does not count.
impl PartialEq for Expr {
    fn eq(&self, other: &Self) -> bool {
        self.kind == other.kind
    }
}
impl Eq for Expr {}

/// The typeface of a letter; letters of different typefaces are different names.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Font {
    /// The default of mathematics: `c`.
    #[default]
    Italic,
    /// `\mathbf{c}`, `\boldsymbol{c}`, `\bm{c}`.
    Bold,
    /// `\mathrm{c}`, `\text{c}`, `\operatorname{c}`.
    Roman,
    /// `\mathcal{c}`.
    Calligraphic,
    /// `\mathbb{c}`.
    Blackboard,
}

/// An accent that is part of the name (dots are not: they are time derivatives).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Accent {
    /// `\tilde` or `\widetilde`.
    Tilde,
    /// `\hat` or `\widehat`.
    Hat,
    /// `\bar` or `\overline`.
    Bar,
    /// `\vec`.
    Vector,
}

/// A letter: its base, typeface, accent and primes, without dots, index or argument.
#[derive(Clone, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Letter {
    /// `m`, `\zeta`, or the word inside `\mathrm{...}`.
    pub base: String,
    /// The typeface.
    pub font: Font,
    /// The accent, if any.
    pub accent: Option<Accent>,
    /// How many primes follow.
    pub primes: u8,
}

/// A name as printed: a letter, its dots and its subscript.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct Name {
    /// The letter.
    pub letter: Letter,
    /// How many dots stand over it: the order of the time derivative.
    pub dots: u8,
    /// The subscript, which may turn out to be a label (`m_A`) or an index (`a_4`, `H_{k,k+1}`).
    pub subscript: Option<Subscript>,
}

/// A printed subscript, kept in both of its possible readings.
#[derive(Clone, Debug)]
pub struct Subscript {
    /// The items between top-level commas, read as expressions; empty when the subscript
    /// cannot be read as expressions at all and is a label only.
    pub indices: Vec<Expr>,
    /// The whole subscript in normal LaTeX (no superfluous blanks or braces): the label reading.
    pub label: String,
}

/// Equality of what is printed.
impl PartialEq for Subscript {
    fn eq(&self, other: &Self) -> bool {
        self.label == other.label
    }
}
impl Eq for Subscript {}
impl std::hash::Hash for Subscript {
    fn hash<H: std::hash::Hasher>(&self, state: &mut H) {
        self.label.hash(state);
    }
}

/// Sign of a term in a sum.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Sign {
    /// `+`
    Plus,
    /// `-`
    Minus,
}

/// A pair of brackets.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Bracket {
    /// `( )`
    Round,
    /// `[ ]`
    Square,
    /// `\{ \}`
    Curly,
    /// `| |` or `\vert \vert`; around a matrix it is printed for its determinant, which the tree
    /// says by a [`Function::Determinant`] around the matrix.
    Bar,
    /// No visible bracket (an array without delimiters).
    None,
}

/// How a quotient is printed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum QuotientStyle {
    /// `\frac{a}{b}`
    Bar,
    /// `a/b`; the divisor is the whole juxtaposed product that follows, a reading that the report shows.
    Slash,
}

/// The functions whose name is part of mathematical notation.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Function {
    /// `\det`
    Determinant,
    /// `\operatorname{tr}` or `\mathrm{tr}`
    Trace,
    /// `\mathrm{Re}` or `\Re`
    RealPart,
    /// `\mathrm{Im}` or `\Im`
    ImaginaryPart,
    /// `\cos`
    Cosine,
    /// `\sin`
    Sine,
    /// `\tan`
    Tangent,
    /// `\cot`
    Cotangent,
    /// `\cosh`
    HyperbolicCosine,
    /// `\sinh`
    HyperbolicSine,
    /// `\tanh`
    HyperbolicTangent,
    /// `\exp`
    Exponential,
    /// `\ln` or `\log`
    Logarithm,
    /// `\sqrt`
    SquareRoot,
    /// `|x|`
    Absolute,
}

impl Function {
    /// Whether it is written before its argument without brackets, and gives numbers for numbers.
    pub fn is_elementary(self) -> bool {
        use Function::*;
        matches!(
            self,
            Cosine
                | Sine
                | Tangent
                | Cotangent
                | HyperbolicCosine
                | HyperbolicSine
                | HyperbolicTangent
                | Exponential
                | Logarithm
        )
    }
}

/// What is printed.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum ExprKind {
    /// An exact number: an integer or a decimal.
    Number(BigRational),
    /// A name.
    Name(Name),
    /// A name applied to arguments, where the document declares it a function: `\zeta(t)`.
    Apply {
        /// The function's name.
        function: Name,
        /// Its arguments.
        arguments: Vec<Expr>,
    },
    /// An argument that names the letter it replaces, as in `R(\xi = 0)`; stands in [`ExprKind::Apply`] only.
    Named {
        /// The letter.
        name: Name,
        /// What it is replaced by.
        value: Box<Expr>,
    },
    /// A function of mathematical notation: `\det\mathbf{H}`, `\cos \beta\xi`.
    Call {
        /// Which.
        function: Function,
        /// Of what.
        argument: Box<Expr>,
    },
    /// A signed sum; a lone leading minus is a sum of one term.
    Sum(Vec<(Sign, Expr)>),
    /// A product of at least two factors, juxtaposed or with `\cdot` or `\times`.
    Product(Vec<Expr>),
    /// A quotient.
    Quotient {
        /// Above the bar.
        numerator: Box<Expr>,
        /// Below the bar.
        denominator: Box<Expr>,
        /// Bar or slash.
        style: QuotientStyle,
    },
    /// A power `base^exponent`; a matrix inverse is the power -1.
    Power {
        /// The base.
        base: Box<Expr>,
        /// The exponent.
        exponent: Box<Expr>,
    },
    /// `X^T` or `X^t`, where the document does not use the letter itself as an exponent.
    Transpose(Box<Expr>),
    /// A bracketed expression.
    Group {
        /// The brackets.
        bracket: Bracket,
        /// What they hold.
        inner: Box<Expr>,
    },
    /// A matrix, column or row by rows; all rows have the same length.
    Matrix {
        /// The entries.
        rows: Vec<Vec<Expr>>,
        /// Its delimiters.
        bracket: Bracket,
    },
    /// `(0, q)`: items between commas in brackets.
    Tuple(Vec<Expr>),
    /// `\sum_{k=0}^{3} body`.
    BigSum {
        /// The bound variable.
        index: Name,
        /// First value.
        from: Box<Expr>,
        /// Last value, inclusive.
        to: Box<Expr>,
        /// What is added.
        body: Box<Expr>,
    },
    /// `\int_a^b body \, d x`.
    Integral {
        /// Lower and upper limit; none for an indefinite integral.
        limits: Option<(Box<Expr>, Box<Expr>)>,
        /// The integrand.
        body: Box<Expr>,
        /// The variable after the `d`.
        variable: Name,
    },
    /// `d/dx` applied to an expression, or dots over something other than a letter.
    Derivative {
        /// The order.
        order: u8,
        /// The variable; none for dots, which mean time.
        variable: Option<Name>,
        /// What is differentiated.
        body: Box<Expr>,
    },
    /// `E\{...\}`: the expectation.
    Expectation(Box<Expr>),
    /// `\underbrace{body}_{label}`.
    Underbrace {
        /// What stands above the brace.
        body: Box<Expr>,
        /// What stands below it: a name for the body, or a whole equation.
        label: Box<Chain>,
    },
    /// Expressions by cases, each with its condition.
    Cases(Vec<(Expr, Vec<Chain>)>),
    /// `\infty`
    Infinity,
    /// `\mathrm{const}`: some constant.
    Constant,
}

/// A relation between neighbours of a chain.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Relation {
    /// `=`
    Equal,
    /// `\neq`
    NotEqual,
    /// `<`
    Less,
    /// `\le`
    LessEqual,
    /// `>`
    Greater,
    /// `\ge`
    GreaterEqual,
    /// `\sim`: is distributed as.
    Distributed,
    /// `\approx`
    Approximately,
    /// `\to`
    Tends,
}

/// `X = Y = Z`: members and the relations between neighbours (one fewer).
#[derive(Clone, Debug)]
pub struct Chain {
    /// At least one member.
    pub members: Vec<Expr>,
    /// `relations[i]` stands between `members[i]` and `members[i + 1]`.
    pub relations: Vec<Relation>,
    /// Where.
    pub span: Span,
}

/// Equality of what is printed; the place does not count.
impl PartialEq for Chain {
    fn eq(&self, other: &Self) -> bool {
        self.members == other.members && self.relations == other.relations
    }
}
impl Eq for Chain {}

/// `m = 0(1)6`: the values that an index takes.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct IndexRange {
    /// The index.
    pub index: Name,
    /// First value.
    pub from: Expr,
    /// Step, 1 in most papers.
    pub step: Expr,
    /// Last value, inclusive.
    pub to: Expr,
}

/// What is printed between a clause and the one before it, beside words.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Separation {
    /// Nothing: it is the first one, or only a word stands there.
    #[default]
    None,
    /// A wide space.
    Space,
    /// A comma, perhaps with a space.
    Comma,
    /// A comma at the end of the line before it.
    CommaAndLine,
    /// A semicolon, or another column of the same line.
    Semicolon,
    /// It has a line of its own.
    Line,
    /// A full stop.
    FullStop,
}

/// One equation (or chain) of a display with the side conditions printed after it.
#[derive(Clone, Debug)]
pub struct Clause {
    /// The heading before it, as in `\text{I:}`.
    pub heading: Option<String>,
    /// The word that joins it to the clause before it, such as "for" or "where"; none for a comma.
    pub joined: Option<String>,
    /// What separates it from the clause before it.
    pub separation: Separation,
    /// Whether it stands in brackets of its own, as in `x = |y| \quad (y > 0)`.
    pub bracketed: bool,
    /// The chain; a chain of one member is a bare expression such as `a_i, i = 1(1)4`.
    pub chain: Chain,
    /// The ranges of its indices.
    pub ranges: Vec<IndexRange>,
    /// The words after it, as in `\text{ driving comfort}`.
    pub remark: Option<String>,
}

/// Equality of what is said; how clauses are set apart does not count.
impl PartialEq for Clause {
    fn eq(&self, other: &Self) -> bool {
        self.heading == other.heading
            && self.joined == other.joined
            && self.chain == other.chain
            && self.ranges == other.ranges
            && self.remark == other.remark
    }
}
impl Eq for Clause {}

/// Everything that stands under one equation number.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Display {
    /// The clauses in the order of reading, shared between displays that differ in one of them.
    pub clauses: Vec<Arc<Clause>>,
    /// Number printed by `\tag` or at the end of the display, if any.
    pub tag: Option<String>,
}

impl Name {
    /// An italic letter without index: `a`, `\zeta`.
    pub fn italic(base: &str) -> Self {
        Name {
            letter: Letter {
                base: base.to_owned(),
                font: Font::Italic,
                accent: None,
                primes: 0,
            },
            dots: 0,
            subscript: None,
        }
    }

    /// The same name without its dots: what is differentiated.
    #[must_use]
    pub fn undotted(&self) -> Self {
        Name {
            dots: 0,
            ..self.clone()
        }
    }

    /// The same name without its last `primes` primes; `None` where it has not so many.
    pub fn unprimed(&self, primes: u8) -> Option<Self> {
        let mut name = self.clone();
        name.letter.primes = name.letter.primes.checked_sub(primes)?;
        Some(name)
    }
}

impl Relation {
    /// Whether it puts its sides in an order: one of the four inequalities.
    pub fn is_order(self) -> bool {
        match self {
            Relation::Less | Relation::LessEqual | Relation::Greater | Relation::GreaterEqual => {
                true
            }
            Relation::Equal
            | Relation::NotEqual
            | Relation::Distributed
            | Relation::Approximately
            | Relation::Tends => false,
        }
    }

    /// Whether it says which values a letter does not have: an inequality.
    pub fn limits(self) -> bool {
        self.is_order() || self == Relation::NotEqual
    }
}

impl Expr {
    /// An expression at a place.
    pub fn new(kind: ExprKind, span: Span) -> Self {
        Expr { kind, span }
    }

    /// The name that it is, where it is nothing more.
    pub fn as_name(&self) -> Option<&Name> {
        if let ExprKind::Name(name) = &self.kind {
            Some(name)
        } else {
            None
        }
    }

    /// The printed number that it is, where it is nothing more.
    pub fn as_number(&self) -> Option<&BigRational> {
        if let ExprKind::Number(number) = &self.kind {
            Some(number)
        } else {
            None
        }
    }

    /// The letter and its value, where it is an argument that names the letter it replaces.
    pub fn as_named_argument(&self) -> Option<(&Name, &Expr)> {
        if let ExprKind::Named { name, value } = &self.kind {
            Some((name, value))
        } else {
            None
        }
    }

    /// `\infty`, `+\infty` or `-\infty`: which of the two infinities it is.
    pub fn as_infinity(&self) -> Option<Sign> {
        if self.kind == ExprKind::Infinity {
            return Some(Sign::Plus);
        }
        if let ExprKind::Sum(terms) = &self.kind
            && let [(sign, term)] = terms.as_slice()
            && term.kind == ExprKind::Infinity
        {
            return Some(*sign);
        }
        None
    }

    /// What stands in its brackets, however many; itself where there are none.
    pub fn without_brackets(&self) -> &Expr {
        let mut inner = self;
        while let ExprKind::Group { inner: next, .. } = &inner.kind {
            inner = next;
        }
        inner
    }
}
