//! What a printed name stands for.
//!
//! A subscript is a label (`m_A`) or an index (`a_4`, `H_{k,k+1}`, `P_{33}`). The label reading
//! is taken when the document declares exactly that name; otherwise the letter must be a family,
//! a notation pattern or a matrix, and the subscript its index. Nothing is guessed: a name that
//! fits neither is undeclared.

use super::{DefinitionKind, Model, Node};
use crate::diagnostic::DiagnosticKind;
use crate::expr::{Expr, ExprKind, Name, Sign};
use crate::latex;
use num_rational::BigRational;
use num_traits::{Signed, ToPrimitive, Zero};
use std::collections::BTreeMap;

/// The letter and the dots of a name, without its subscript: what a family is known by.
pub type FamilyKey = String;

/// Every name that a document gives a meaning.
#[derive(Clone, Debug, Default)]
pub struct Names {
    /// Complete names, with dots and label.
    pub(super) whole: BTreeMap<String, Node>,
    /// Powers that are defined as such, as in `\sigma_a^2 = ...`: by base and exponent.
    pub(super) powers: BTreeMap<(String, u32), usize>,
    /// Values of processes at a number that are given as such, as in `y(0) = y_0`.
    pub(super) values: BTreeMap<(String, BigRational), usize>,
    /// Single members of a family, by index.
    pub(super) elements: BTreeMap<(FamilyKey, Vec<i64>), Node>,
    /// Families with a running index, by key and number of indices.
    pub(super) families: BTreeMap<(FamilyKey, usize), Node>,
}

/// A printed name, read as far as it can be before its indices have values.
#[derive(Clone, Debug)]
pub enum Resolved<'a> {
    /// An index bound by a sum or a range.
    Bound(String),
    /// A letter of the ring: a declared symbol and the order of its time derivative.
    Letter {
        /// Which symbol.
        symbol: usize,
        /// How often it is differentiated.
        order: u8,
    },
    /// Something with a value of its own, differentiated so often.
    Node {
        /// What.
        node: Node,
        /// How often it is differentiated beyond its own dots.
        derivatives: u8,
    },
    /// The derivative of a function of one argument by its argument.
    Primed {
        /// The function.
        node: Node,
        /// How often it is differentiated.
        primes: u8,
    },
    /// A member of a family or an entry of a matrix.
    Indexed {
        /// Whose.
        key: FamilyKey,
        /// The index expressions.
        indices: Vec<&'a Expr>,
    },
}

/// A member of a family or a matrix once the indices have values.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Element {
    /// A node of its own.
    Node(Node),
    /// A member of the family at this node, for these indices.
    Member(Node, Vec<i64>),
    /// The entry (row, column), from 1, of the matrix at this node.
    Entry(Node, Vec<i64>),
}

/// The family that a name with a subscript belongs to.
pub fn family_key(name: &Name) -> FamilyKey {
    latex::canonical(&Name {
        letter: name.letter.clone(),
        dots: name.dots,
        subscript: None,
    })
}

/// The integer that an index expression shows literally, such as `4` or `-1`.
pub fn literal_integer(expr: &Expr) -> Option<i64> {
    match &expr.kind {
        ExprKind::Number(n) if n.is_integer() => n.to_integer().to_i64(),
        ExprKind::Sum(terms) => match terms.as_slice() {
            [(Sign::Minus, inner)] => literal_integer(inner).map(|v| -v),
            [(Sign::Plus, inner)] => literal_integer(inner),
            _ => None,
        },
        ExprKind::Group { inner, .. } => literal_integer(inner),
        _ => None,
    }
}

/// The rational number that an expression spells, if it is one.
pub fn literal_number(expr: &Expr) -> Option<BigRational> {
    match &expr.kind {
        ExprKind::Number(n) => Some(n.clone()),
        ExprKind::Sum(terms) => match terms.as_slice() {
            [(Sign::Minus, inner)] => literal_number(inner).map(|v| -v),
            [(Sign::Plus, inner)] => literal_number(inner),
            _ => None,
        },
        ExprKind::Group { inner, .. } => literal_number(inner),
        ExprKind::Quotient {
            numerator,
            denominator,
            ..
        } => {
            let below = literal_number(denominator).filter(|d| !d.is_zero())?;
            Some(literal_number(numerator)? / below)
        }
        _ => None,
    }
}

/// Whether an expression can be an index: integers and bound letters.
pub fn is_index(expr: &Expr, bound: &dyn Fn(&str) -> bool) -> bool {
    let mut plain = true;
    crate::expr::walk::visit(expr, &mut |e| {
        plain &= match &e.kind {
            ExprKind::Name(name) => bound(&latex::canonical(name)),
            ExprKind::Number(n) => n.is_integer(),
            ExprKind::Sum(_) | ExprKind::Product(_) | ExprKind::Group { .. } => true,
            _ => false,
        };
    });
    plain
}

/// The literal integer indices of a name, if its subscript consists of such.
pub fn literal_indices(name: &Name) -> Option<Vec<i64>> {
    let subscript = name.subscript.as_ref()?;
    if subscript.indices.is_empty() {
        return None;
    }
    subscript.indices.iter().map(literal_integer).collect()
}

/// Splits `33` into 3, 3 where two indices are expected and one number of two digits is printed.
pub fn split_digits(indices: &[i64], expected: usize) -> Option<Vec<i64>> {
    match indices {
        _ if indices.len() == expected => Some(indices.to_vec()),
        [number] if expected == 2 && (10..=99).contains(number) => {
            Some(vec![number / 10, number % 10])
        }
        _ => None,
    }
}

/// The letter of eigenvalues: `Re λ(A) < 0` is the sentence that A is asymptotically stable.
pub(crate) const EIGENVALUES: &str = "\\lambda";

impl Model {
    /// Whether a symbol is the spectrum of something that the document defines, as `\lambda` declared
    /// as a function of A: its values are those of A, and no point may choose them.
    pub(crate) fn is_spectrum(&self, symbol: usize) -> bool {
        let declared = &self.symbols[symbol];
        let of = declared.function_of.as_ref();
        declared.name.letter.base == EIGENVALUES
            && of
                .is_some_and(|of| matches!(self.resolve(of, &|_| false), Ok(Resolved::Node { .. })))
    }

    /// Reads a name where the indices in `bound` have values.
    ///
    /// # Errors
    /// When the document gives it no meaning.
    pub fn resolve<'a>(
        &'a self,
        name: &'a Name,
        bound: &dyn Fn(&str) -> bool,
    ) -> Result<Resolved<'a>, DiagnosticKind> {
        let whole = latex::canonical(name);
        if name.dots == 0 && bound(&whole) {
            return Ok(Resolved::Bound(whole));
        }
        let found = |node: &Node, derivatives| match node {
            Node::Symbol(symbol) => Resolved::Letter {
                symbol: *symbol,
                order: derivatives,
            },
            node => Resolved::Node {
                node: *node,
                derivatives,
            },
        };
        if let Some(node) = self.names.whole.get(&whole) {
            return Ok(found(node, 0));
        }
        // The value of a dotted name may be given for fewer dots and differentiated further.
        let mut fewer = name.clone();
        for derivatives in 1..=name.dots {
            fewer.dots = name.dots - derivatives;
            if let Some(node) = self.names.whole.get(&latex::canonical(&fewer)) {
                return Ok(found(node, derivatives));
            }
        }
        if let Some(derivative) = self.primed(name) {
            return Ok(derivative);
        }
        let key = family_key(name);
        if let Some(subscript) = &name.subscript
            && !subscript.indices.is_empty()
        {
            let indices: Vec<&Expr> = subscript.indices.iter().collect();
            let families = |n| self.names.families.contains_key(&(key.clone(), n));
            let matrix = self.matrix_behind(&key).is_some();
            let members = self.has_member(&key, name);
            let index = indices.iter().all(|i| is_index(i, bound));
            if index && (families(indices.len()) || families(2) || matrix || members) {
                return Ok(Resolved::Indexed { key, indices });
            }
        }
        Err(DiagnosticKind::UndeclaredName { name: whole })
    }

    /// What a name with primes is the derivative of, where it has no meaning of its own.
    fn primed<'a>(&self, name: &Name) -> Option<Resolved<'a>> {
        (1..=name.letter.primes).find_map(|primes| {
            let function = name.undotted().unprimed(primes)?;
            match self.names.whole.get(&latex::canonical(&function))? {
                Node::Symbol(symbol) => {
                    (self.symbols[*symbol].arguments.len() == 1).then(|| Resolved::Letter {
                        symbol: *symbol,
                        order: primes.saturating_add(name.dots),
                    })
                }
                node @ Node::Definition(d) => {
                    let function = self.definitions[*d].arguments.len() == 1;
                    (function && name.dots == 0).then_some(Resolved::Primed {
                        node: *node,
                        primes,
                    })
                }
                Node::Matrix(_) | Node::Notation(_) | Node::Unknown { .. } => None,
            }
        })
    }

    /// What a letter with these indices can stand for: a member of a family, or an entry of a
    /// matrix. `H_{11}` has two readings where the document has both `H_i` and `H_{i,j}`; which of
    /// them exist is seen where they are evaluated.
    pub fn elements(&self, key: &FamilyKey, indices: &[i64]) -> Vec<Element> {
        if let Some(node) = self.names.elements.get(&(key.clone(), indices.to_vec())) {
            return vec![Element::Node(*node)];
        }
        let mut arities = vec![indices.len(), 2];
        arities.dedup();
        let mut found = Vec::new();
        for arity in arities {
            if let Some(split) = split_digits(indices, arity)
                && let Some(node) = self.names.families.get(&(key.clone(), arity))
                && self.in_range(*node, &split)
            {
                found.push(Element::Member(*node, split));
            }
        }
        if found.is_empty()
            && !self.names.families.keys().any(|(k, _)| k == key)
            && let Some(node) = self.matrix_behind(key)
        {
            let split = split_digits(indices, 2).unwrap_or_else(|| indices.to_vec());
            found.push(Element::Entry(node, split));
        }
        found
    }

    /// Whether the letter has members of its own, and with literal indices this one: `P_{3,4}` is
    /// not the declared letter `P_{34}`.
    fn has_member(&self, key: &FamilyKey, name: &Name) -> bool {
        match literal_indices(name) {
            Some(indices) => self.names.elements.contains_key(&(key.clone(), indices)),
            None => self.names.elements.keys().any(|(k, _)| k == key),
        }
    }

    fn matrix_behind(&self, key: &FamilyKey) -> Option<Node> {
        self.names
            .whole
            .get(key)
            .copied()
            .filter(|node| !matches!(node, Node::Symbol(_)))
    }

    fn in_range(&self, node: Node, indices: &[i64]) -> bool {
        match node {
            Node::Definition(d) => match &self.definitions[d].kind {
                DefinitionKind::Family { ranges, .. } => ranges
                    .iter()
                    .zip(indices)
                    .all(|((from, to), i)| (from..=to).contains(&i)),
                _ => true,
            },
            // Coefficients beyond the degree are zero; negative ones and cofactors outside the
            // matrix do not exist and are refused where they are evaluated.
            _ => indices.iter().all(|i| !i.is_negative()),
        }
    }

    /// The node that defines a power of this base, such as `\sigma_a^2`, for the largest exponent
    /// that divides `exponent`, and the quotient of the exponents.
    pub fn power_node(&self, base: &Name, exponent: u32) -> Option<(Node, u32)> {
        let base = latex::canonical(base);
        (1..=exponent)
            .rev()
            .filter(|k| exponent.is_multiple_of(*k))
            .find_map(|k| {
                let index = self.names.powers.get(&(base.clone(), k))?;
                Some((Node::Definition(*index), exponent / k))
            })
    }

    /// Whether any power of this name (in canonical form) is defined.
    pub fn has_power_of(&self, base: &str) -> bool {
        self.names.powers.keys().any(|(b, _)| b == base)
    }
}
