//! Polynomial rings: named variables and a monomial order.
//!
//! Rings are interned: two rings with the same variables and the same order are one object, so that a
//! ring is a `Copy` handle and comparing two rings compares two pointers. The description of a ring
//! (some hundred bytes) is kept until the process ends.

use crate::error::Error;
use crate::layout::{KINDS, Layout};
use std::cmp::Ordering;
use std::fmt;
use std::hash::{Hash, Hasher};
use std::sync::Mutex;

/// An admissible order of the monomials.
#[derive(
    Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, serde::Serialize, serde::Deserialize,
)]
pub enum Order {
    /// Lexicographic: the first variable counts most.
    Lex,
    /// Total degree, ties lexicographically.
    Grlex,
    /// Total degree, ties by the smaller exponent of the last variable.
    Grevlex,
}

/// The ring of polynomials with integer coefficients in named variables. A `Copy` handle.
#[derive(Clone, Copy)]
pub struct Ring(&'static RingData);

struct RingData {
    variables: Vec<String>,
    order: Order,
    /// The ways to pack a monomial, the narrowest first; the last always exists.
    layouts: [Option<Layout>; KINDS],
    narrowest: usize,
}

static RINGS: Mutex<Vec<&'static RingData>> = Mutex::new(Vec::new());

impl Ring {
    /// The ring in the given variables. A name is a letter or `_`, then letters, digits, `_` or `'`.
    pub fn new<I>(variables: I, order: Order) -> Result<Self, Error>
    where
        I: IntoIterator,
        I::Item: Into<String>,
    {
        let variables: Vec<String> = variables.into_iter().map(Into::into).collect();
        for (i, name) in variables.iter().enumerate() {
            if !is_variable_name(name) {
                return Err(Error::InvalidVariableName(name.clone()));
            }
            if variables[..i].contains(name) {
                return Err(Error::DuplicateVariable(name.clone()));
            }
        }
        let mut rings = RINGS
            .lock()
            .unwrap_or_else(|poisoned| poisoned.into_inner());
        if let Some(known) = rings
            .iter()
            .find(|r| r.order == order && r.variables == variables)
        {
            return Ok(Ring(known));
        }
        let layouts = Layout::all(order, variables.len());
        let narrowest = layouts
            .iter()
            .position(Option::is_some)
            .expect("the last layout exists");
        let ring: &'static RingData = Box::leak(Box::new(RingData {
            variables,
            order,
            layouts,
            narrowest,
        }));
        rings.push(ring);
        Ok(Ring(ring))
    }

    /// The names of the variables, the most significant first.
    pub fn variables(&self) -> &'static [String] {
        &self.0.variables
    }

    /// The number of variables.
    pub fn len(&self) -> usize {
        self.0.variables.len()
    }

    /// Whether the ring has no variables, that is, consists of the integers.
    pub fn is_empty(&self) -> bool {
        self.0.variables.is_empty()
    }

    /// The monomial order.
    pub fn order(&self) -> Order {
        self.0.order
    }

    /// The position of a variable.
    pub fn index_of(&self, name: &str) -> Result<usize, Error> {
        self.0
            .variables
            .iter()
            .position(|v| v == name)
            .ok_or_else(|| Error::UnknownVariable(name.to_string()))
    }

    /// The same variables under another order.
    pub fn with_order(&self, order: Order) -> Ring {
        Ring::new(self.0.variables.iter().cloned(), order).expect("the names are those of a ring")
    }

    /// A layout of the monomials by kind, if the ring has it.
    #[inline]
    pub(crate) fn layout(&self, kind: usize) -> Option<&'static Layout> {
        self.0.layouts[kind].as_ref()
    }

    /// The kind of the narrowest layout.
    #[inline]
    pub(crate) fn narrowest(&self) -> usize {
        self.0.narrowest
    }

    /// Compares two exponent vectors in the ring's order.
    ///
    /// # Panics
    /// If a vector's length is not the number of variables.
    pub fn compare(&self, a: &[u32], b: &[u32]) -> Ordering {
        assert!(
            a.len() == self.len() && b.len() == self.len(),
            "exponent vector of another ring"
        );
        let degree = |e: &[u32]| e.iter().map(|&x| u64::from(x)).sum::<u64>();
        match self.0.order {
            Order::Lex => a.cmp(b),
            Order::Grlex => degree(a).cmp(&degree(b)).then_with(|| a.cmp(b)),
            Order::Grevlex => degree(a)
                .cmp(&degree(b))
                .then_with(|| b.iter().rev().cmp(a.iter().rev())),
        }
    }
}

/// Whether a text may name a variable.
pub(crate) fn is_variable_name(name: &str) -> bool {
    let mut chars = name.chars();
    chars.next().is_some_and(is_name_start) && chars.all(is_name_continue)
}

pub(crate) fn is_name_start(c: char) -> bool {
    c.is_alphabetic() || c == '_'
}

pub(crate) fn is_name_continue(c: char) -> bool {
    c.is_alphanumeric() || c == '_' || c == '\''
}

impl PartialEq for Ring {
    fn eq(&self, other: &Self) -> bool {
        std::ptr::eq(self.0, other.0)
    }
}

impl Eq for Ring {}

impl Hash for Ring {
    /// By content, so that a hash does not depend on addresses.
    fn hash<H: Hasher>(&self, state: &mut H) {
        self.0.variables.hash(state);
        self.0.order.hash(state);
    }
}

impl PartialOrd for Ring {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Ring {
    /// By content, so that the order does not depend on addresses.
    fn cmp(&self, other: &Self) -> Ordering {
        if self == other {
            return Ordering::Equal;
        }
        (&self.0.variables, self.0.order).cmp(&(&other.0.variables, other.0.order))
    }
}

impl fmt::Debug for Ring {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "Z[{}] {:?}", self.0.variables.join(", "), self.0.order)
    }
}
