//! Claims that hold for any size: both sides have one normal form as words of matrix letters.
//!
//! Whatever is no sum, product, transpose, trace or determinant of declared matrices and of names
//! defined by such has no normal form here, and the claim is proved for the named sizes only.

use crate::document::Structure;
use crate::expr::{Display, Expr, ExprKind, Function, Sign};
use crate::latex;
use crate::model::links::Link;
use crate::model::names::{Resolved, literal_integer};
use crate::model::{DefinitionKind, Model, Node, NotationKind};
use crate::theory::words::{Alphabet, Form, Scalar, Size, Symmetry};
use num_rational::BigRational;
use num_traits::One;
use std::collections::BTreeMap;

/// The largest power that is multiplied out.
const LARGEST_POWER: i64 = 8;
/// How deep definitions may need each other.
const DEPTH: usize = 50;

/// Expressions as words.
struct Words<'m> {
    model: &'m Model,
    corrected: &'m BTreeMap<usize, Display>,
    alphabet: Alphabet,
    /// The letter of each declared matrix and order of its time derivative.
    letters: BTreeMap<(usize, u8), usize>,
    depth: usize,
}

/// Whether the sides of a link are equal for any size, as corrected.
pub(super) fn hold_for_any_size(
    model: &Model,
    corrected: &BTreeMap<usize, Display>,
    display: &Display,
    link: &Link,
) -> bool {
    let mut words = Words {
        model,
        corrected,
        alphabet: Alphabet::default(),
        letters: BTreeMap::new(),
        depth: 0,
    };
    let mut side = |place: crate::model::links::Place| words.form(place.find(display)?);
    let (Some(left), Some(right)) = (side(link.left), side(link.right)) else {
        return false;
    };
    let minus = words.alphabet.scaled(&right, &minus_one());
    let difference = words.alphabet.plus(&left, &minus);
    difference.is_some_and(|d| d.is_zero())
}

fn minus_one() -> Scalar {
    Scalar::number(-BigRational::one())
}

fn size(size: &crate::document::Size) -> Size {
    (size.factor, size.letter.clone())
}

impl Words<'_> {
    fn form(&mut self, expr: &Expr) -> Option<Form> {
        match &expr.kind {
            ExprKind::Number(n) => Some(Form::number(n.clone())),
            ExprKind::Name(name) => {
                let known = latex::canonical(name);
                if self.model.instances[0].contains_key(&known) {
                    return Some(Form::Scalar(Scalar::size(&(1, Some(known)))));
                }
                match self.model.resolve(name, &|_| false).ok()? {
                    Resolved::Letter { symbol, order } => {
                        let letter = self.model.letter_of_symbol(symbol, order)?;
                        Some(Form::Scalar(Scalar::letter(letter)))
                    }
                    Resolved::Node { node, derivatives } => self.node(node, derivatives),
                    Resolved::Bound(_) | Resolved::Primed { .. } | Resolved::Indexed { .. } => None,
                }
            }
            ExprKind::Apply {
                function,
                arguments,
            } => {
                let plain = arguments.iter().all(|a| {
                    matches!(&a.kind, ExprKind::Name(n)
                        if self.model.is_argument_of(function, &latex::canonical(n)))
                });
                let name = Expr::new(ExprKind::Name(function.clone()), expr.span);
                plain.then(|| self.form(&name))?
            }
            ExprKind::Group { inner, .. } | ExprKind::Underbrace { body: inner, .. } => {
                self.form(inner)
            }
            ExprKind::Sum(terms) => {
                let mut sum = Form::Zero;
                for (sign, term) in terms {
                    let mut term = self.form(term)?;
                    if *sign == Sign::Minus {
                        term = self.alphabet.scaled(&term, &minus_one());
                    }
                    sum = self.alphabet.plus(&sum, &term)?;
                }
                Some(sum)
            }
            ExprKind::Product(factors) => {
                let mut product = Form::number(BigRational::one());
                for factor in factors {
                    let factor = self.form(factor)?;
                    product = self.alphabet.times(&product, &factor)?;
                }
                Some(product)
            }
            ExprKind::Quotient {
                numerator,
                denominator,
                ..
            } => {
                let (above, below) = (self.form(numerator)?, self.form(denominator)?);
                self.alphabet.divided(&above, &below)
            }
            ExprKind::Power { base, exponent } => {
                // The power of a name may be defined as such.
                if matches!(&base.kind, ExprKind::Name(n)
                    if self.model.has_power_of(&latex::canonical(n)))
                {
                    return None;
                }
                let exponent =
                    literal_integer(exponent).filter(|n| (1..=LARGEST_POWER).contains(n))?;
                let base = self.form(base)?;
                let mut power = base.clone();
                for _ in 1..exponent {
                    power = self.alphabet.times(&power, &base)?;
                }
                Some(power)
            }
            ExprKind::Transpose(inner) => {
                let inner = self.form(inner)?;
                Some(self.alphabet.transpose(&inner))
            }
            ExprKind::Call { function, argument } => {
                let argument = self.form(argument)?;
                match function {
                    Function::Trace => self.alphabet.trace(&argument),
                    Function::Determinant => self.alphabet.determinant(&argument),
                    Function::RealPart
                    | Function::ImaginaryPart
                    | Function::Cosine
                    | Function::Sine
                    | Function::Tangent
                    | Function::Cotangent
                    | Function::HyperbolicCosine
                    | Function::HyperbolicSine
                    | Function::HyperbolicTangent
                    | Function::Exponential
                    | Function::Logarithm
                    | Function::SquareRoot
                    | Function::Absolute => None,
                }
            }
            ExprKind::Matrix { .. }
            | ExprKind::Tuple(_)
            | ExprKind::Named { .. }
            | ExprKind::BigSum { .. }
            | ExprKind::Integral { .. }
            | ExprKind::Derivative { .. }
            | ExprKind::Expectation(_)
            | ExprKind::Cases(_)
            | ExprKind::Infinity
            | ExprKind::Constant => None,
        }
    }

    fn node(&mut self, node: Node, derivatives: u8) -> Option<Form> {
        let model = self.model;
        match node {
            Node::Matrix(m) => {
                let matrix = &model.matrices[m];
                let (rows, columns) = (size(&matrix.shape.rows), size(&matrix.shape.columns));
                if derivatives > 0 && matrix.arguments.is_empty() {
                    return Some(Form::Zero);
                }
                let symmetry = match matrix.shape.structure {
                    Structure::General => Symmetry::General,
                    Structure::Symmetric => Symmetry::Symmetric,
                    Structure::Skew => Symmetry::Skew,
                };
                let letter = match self.letters.get(&(m, derivatives)) {
                    Some(letter) => *letter,
                    None => {
                        let letter = self.alphabet.letter(rows, columns, symmetry);
                        self.letters.insert((m, derivatives), letter);
                        letter
                    }
                };
                Some(self.alphabet.matrix(letter))
            }
            Node::Notation(n) => match &model.notation[n].kind {
                _ if derivatives > 0 => None,
                NotationKind::Identity(order) => Some(self.alphabet.identity(size(order))),
                NotationKind::Zero => Some(Form::Zero),
                NotationKind::Means(expr) => self.form(expr),
                NotationKind::CharacteristicCoefficient(_)
                | NotationKind::Cofactor(_)
                | NotationKind::LeadingMinor(_)
                | NotationKind::Entry(_)
                | NotationKind::HurwitzMatrix(_)
                | NotationKind::Constant(_)
                | NotationKind::Dirac
                | NotationKind::Rows(_)
                | NotationKind::Covariance(_) => None,
            },
            Node::Definition(d) => {
                let definition = &model.definitions[d];
                let whole = matches!(definition.kind, DefinitionKind::Whole)
                    && definition.arguments.is_empty()
                    && derivatives == 0
                    && self.depth < DEPTH;
                if !whole {
                    return None;
                }
                let printed = &model.equations[definition.equation].display;
                let display = self.corrected.get(&definition.equation).unwrap_or(printed);
                let value = definition.place.find(display)?;
                self.depth += 1;
                let form = self.form(value);
                self.depth -= 1;
                form
            }
            Node::Symbol(_) | Node::Unknown { .. } => None,
        }
    }
}
