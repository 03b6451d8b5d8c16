//! The representation of a polynomial: a vector of terms, in one of five monomial layouts and one of
//! three coefficient widths.
//!
//! Invariants: terms in strictly descending order, no zero coefficient, the narrowest layout that holds
//! all monomials, the narrowest width that holds all coefficients; so equality is structural. Zero is the
//! empty list in the narrowest layout and width.

use crate::coefficient::{Coefficient, Double, Value};
use crate::layout::Layout;
use crate::packed::{Packed, PackedMonomial, Wide};
use crate::ring::Ring;
use crate::scalar::Scalar;
use num_bigint::BigInt;
use num_traits::ToPrimitive;

/// A monomial with its coefficient.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub(crate) struct Term<M, C> {
    pub monomial: M,
    pub coefficient: C,
}

/// Terms in one layout, in the narrowest width that fits.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub(crate) enum TermList<M> {
    /// Coefficients of one word.
    Word(Vec<Term<M, i64>>),
    /// Coefficients of two words, at least one of which does not fit a word.
    Double(Vec<Term<M, Double>>),
    /// Unbounded coefficients, at least one of which does not fit two words.
    Big(Vec<Term<M, BigInt>>),
}

/// Terms in the narrowest layout and width.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub(crate) enum Terms {
    One(TermList<Packed<1>>),
    Two(TermList<Packed<2>>),
    Four(TermList<Packed<4>>),
    Eight(TermList<Packed<8>>),
    Wide(TermList<Wide>),
}

/// Evaluates an expression for the vector within a [`TermList`], whatever the width.
macro_rules! each_width {
    ($list:expr, $terms:pat => $body:expr) => {
        match $list {
            $crate::terms::TermList::Word($terms) => $body,
            $crate::terms::TermList::Double($terms) => $body,
            $crate::terms::TermList::Big($terms) => $body,
        }
    };
}

/// Evaluates an expression for the [`TermList`] within [`Terms`], whatever the layout.
macro_rules! each_layout {
    ($terms:expr, $list:pat => $body:expr) => {
        match $terms {
            $crate::terms::Terms::One($list) => $body,
            $crate::terms::Terms::Two($list) => $body,
            $crate::terms::Terms::Four($list) => $body,
            $crate::terms::Terms::Eight($list) => $body,
            $crate::terms::Terms::Wide($list) => $body,
        }
    };
}

/// Evaluates an expression for a pair of lists in the same layout; the operands are first brought to
/// the wider of their layouts.
macro_rules! same_layout {
    ($ring:expr, $a:expr, $b:expr, $x:ident, $y:ident => $body:expr) => {{
        use $crate::terms::Terms;
        let (a, b) = Terms::align($ring, $a, $b);
        match (&*a, &*b) {
            (Terms::One($x), Terms::One($y)) => $body,
            (Terms::Two($x), Terms::Two($y)) => $body,
            (Terms::Four($x), Terms::Four($y)) => $body,
            (Terms::Eight($x), Terms::Eight($y)) => $body,
            (Terms::Wide($x), Terms::Wide($y)) => $body,
            _ => unreachable!("aligned lists have one layout"),
        }
    }};
}

pub(crate) use {each_layout, each_width, same_layout};

impl<M: PackedMonomial> Default for TermList<M> {
    fn default() -> Self {
        TermList::new()
    }
}

impl<M: PackedMonomial> TermList<M> {
    /// The empty list.
    pub const fn new() -> Self {
        TermList::Word(Vec::new())
    }

    /// The empty list with room for some terms.
    pub fn with_capacity(terms: usize) -> Self {
        TermList::Word(Vec::with_capacity(terms))
    }

    pub fn len(&self) -> usize {
        each_width!(self, terms => terms.len())
    }

    /// About how many bytes they take.
    pub fn bytes(&self) -> usize {
        let inline = each_width!(self, terms => {
            let apart = terms.first().map_or(0, |t| t.monomial.bytes_apart());
            size_of_val(terms.as_slice()) + terms.len() * apart
        });
        let long = match self {
            TermList::Word(_) | TermList::Double(_) => 0,
            TermList::Big(terms) => {
                let bits = terms.iter().map(|t| t.coefficient.bits());
                usize::try_from(bits.sum::<u64>() / 8).unwrap_or(usize::MAX)
            }
        };
        inline.saturating_add(long)
    }

    /// The terms with their coefficients in one type.
    pub fn get(&self, index: usize) -> Option<(&M, Value<'_>)> {
        each_width!(self, terms => terms.get(index).map(|t| (&t.monomial, t.coefficient.value())))
    }

    /// Calls a function on every term in descending order.
    pub fn for_each<'a>(&'a self, mut f: impl FnMut(&'a M, Value<'a>)) {
        each_width!(self, terms => for t in terms { f(&t.monomial, t.coefficient.value()) });
    }

    /// Applies a map that sends nonzero coefficients to nonzero coefficients; `None` if it fails.
    pub fn map_coefficients(&self, f: impl Fn(Value<'_>) -> Option<Scalar>) -> Option<Self> {
        let mut mapped = TermList::with_capacity(self.len());
        each_width!(self, terms => for t in terms {
            mapped.push(t.monomial.clone(), f(t.coefficient.value())?);
        });
        Some(mapped)
    }

    /// Whether a predicate holds for every monomial.
    pub fn all_monomials(&self, mut f: impl FnMut(&M) -> bool) -> bool {
        each_width!(self, terms => terms.iter().all(|t| f(&t.monomial)))
    }

    /// The bits of the largest coefficient.
    pub fn bits(&self) -> u64 {
        match self {
            // The bits of the disjunction are those of the largest.
            TermList::Word(terms) => {
                let all = terms
                    .iter()
                    .fold(0, |all, t| all | t.coefficient.unsigned_abs());
                u64::from(64 - all.leading_zeros())
            }
            TermList::Double(terms) => terms
                .iter()
                .map(|t| t.coefficient.bits())
                .max()
                .unwrap_or(0),
            TermList::Big(terms) => terms
                .iter()
                .map(|t| t.coefficient.bits())
                .max()
                .unwrap_or(0),
        }
    }

    /// Appends a term below all others with a nonzero coefficient.
    #[inline]
    pub fn push_word(&mut self, monomial: M, coefficient: i64) {
        match self {
            TermList::Word(terms) => terms.push(Term {
                monomial,
                coefficient,
            }),
            _ => self.push_small(monomial, coefficient.into()),
        }
    }

    /// Appends a term below all others with a nonzero coefficient.
    #[inline]
    pub fn push_small(&mut self, monomial: M, coefficient: i128) {
        match self {
            TermList::Word(terms) => match i64::try_from(coefficient) {
                Ok(coefficient) => terms.push(Term {
                    monomial,
                    coefficient,
                }),
                Err(_) => {
                    self.widen_to_double();
                    self.push_small(monomial, coefficient);
                }
            },
            TermList::Double(terms) => {
                terms.push(Term {
                    monomial,
                    coefficient: coefficient.into(),
                });
            }
            TermList::Big(terms) => {
                terms.push(Term {
                    monomial,
                    coefficient: coefficient.into(),
                });
            }
        }
    }

    /// Appends a term below all others with a nonzero coefficient.
    #[inline]
    pub fn push(&mut self, monomial: M, coefficient: Scalar) {
        match coefficient {
            Scalar::Small(coefficient) => self.push_small(monomial, coefficient),
            Scalar::Big(coefficient) => {
                if !matches!(self, TermList::Big(_)) {
                    *self = TermList::Big(self.to_big());
                }
                if let TermList::Big(terms) = self {
                    terms.push(Term {
                        monomial,
                        coefficient,
                    });
                }
            }
        }
    }

    /// Appends the terms of a list that is below this one.
    pub fn append(&mut self, below: Self) {
        match (&mut *self, below) {
            (TermList::Word(a), TermList::Word(mut b)) => a.append(&mut b),
            (TermList::Double(a), TermList::Double(mut b)) => a.append(&mut b),
            (TermList::Big(a), TermList::Big(mut b)) => a.append(&mut b),
            (_, below) => each_width!(below, terms => for t in terms {
                self.push(t.monomial, t.coefficient.value().to_scalar());
            }),
        }
    }

    #[cold]
    fn widen_to_double(&mut self) {
        if let TermList::Word(terms) = self {
            let mut wide = Vec::with_capacity(terms.capacity().max(4));
            wide.extend(terms.drain(..).map(|t| Term {
                monomial: t.monomial,
                coefficient: i128::from(t.coefficient).into(),
            }));
            *self = TermList::Double(wide);
        }
    }

    /// A copy with coefficients of two words, if they fit.
    pub fn to_double(&self) -> Option<Vec<Term<M, Double>>> {
        match self {
            TermList::Word(terms) => Some(
                terms
                    .iter()
                    .map(|t| Term {
                        monomial: t.monomial.clone(),
                        coefficient: i128::from(t.coefficient).into(),
                    })
                    .collect(),
            ),
            TermList::Double(terms) => Some(terms.clone()),
            TermList::Big(_) => None,
        }
    }

    /// A copy with unbounded coefficients.
    pub fn to_big(&self) -> Vec<Term<M, BigInt>> {
        self.map_to(|c| c.to_big())
    }

    /// The terms with the coefficients mapped to another type.
    pub fn map_to<C>(&self, f: impl Fn(Value<'_>) -> C) -> Vec<Term<M, C>> {
        each_width!(self, terms => terms.iter().map(|t| Term {
            monomial: t.monomial.clone(),
            coefficient: f(t.coefficient.value()),
        }).collect())
    }

    /// For each field its greatest value.
    pub fn greatest_fields(&self, layout: &Layout) -> Vec<u64> {
        let mut greatest = vec![0; layout.fields];
        self.for_each(|m, _| {
            for (k, g) in greatest.iter_mut().enumerate() {
                *g = (*g).max(m.field(layout, k));
            }
        });
        greatest
    }

    /// For each variable its greatest exponent.
    pub fn degrees(&self, layout: &Layout) -> Vec<u32> {
        let mut degrees = vec![0; layout.variables];
        let mut exponents = vec![0; layout.variables];
        self.for_each(|m, _| {
            m.unpack(layout, &mut exponents);
            for (d, &e) in degrees.iter_mut().zip(&exponents) {
                *d = (*d).max(e);
            }
        });
        degrees
    }

    /// The same list in another layout that can hold it.
    fn convert<N: PackedMonomial>(&self, from: &Layout, to: &Layout) -> TermList<N> {
        let convert = |m: &M| N::from_fields(to, |k| m.field(from, k));
        macro_rules! terms {
            ($terms:expr) => {
                $terms
                    .iter()
                    .map(|t| Term {
                        monomial: convert(&t.monomial),
                        coefficient: t.coefficient.clone(),
                    })
                    .collect()
            };
        }
        match self {
            TermList::Word(terms) => TermList::Word(terms!(terms)),
            TermList::Double(terms) => TermList::Double(terms!(terms)),
            TermList::Big(terms) => TermList::Big(terms!(terms)),
        }
    }

    /// The list in the narrowest layout.
    #[inline]
    pub fn into_terms(self, ring: Ring) -> Terms {
        if M::KIND > ring.narrowest() {
            let layout = M::layout(ring);
            for kind in ring.narrowest()..M::KIND {
                let Some(narrower) = ring.layout(kind) else {
                    continue;
                };
                let excess = layout.excess_of(narrower);
                if self.all_monomials(|m| !m.meets(excess)) {
                    return self.convert_to_kind(ring, kind);
                }
            }
        }
        M::wrap(self)
    }

    #[cold]
    fn convert_to_kind(&self, ring: Ring, kind: usize) -> Terms {
        let (from, to) = (
            M::layout(ring),
            ring.layout(kind).expect("a layout of the ring"),
        );
        match kind {
            0 => Terms::One(self.convert(from, to)),
            1 => Terms::Two(self.convert(from, to)),
            2 => Terms::Four(self.convert(from, to)),
            3 => Terms::Eight(self.convert(from, to)),
            _ => Terms::Wide(self.convert(from, to)),
        }
    }

    fn is_canonical(&self, ring: Ring) -> bool {
        let layout = M::layout(ring);
        let descending = each_width!(self, terms =>
            terms.windows(2).all(|w| w[0].monomial > w[1].monomial));
        let narrow_width = match self {
            TermList::Word(terms) => terms.iter().all(|t| t.coefficient != 0),
            TermList::Double(terms) => {
                terms.iter().all(|t| i128::from(t.coefficient) != 0)
                    && terms
                        .iter()
                        .any(|t| i64::try_from(i128::from(t.coefficient)).is_err())
            }
            TermList::Big(terms) => {
                terms.iter().all(|t| t.coefficient != BigInt::ZERO)
                    && terms.iter().any(|t| t.coefficient.to_i128().is_none())
            }
        };
        // Packing the unpacked exponents must give back the monomial.
        let mut exponents = vec![0; ring.len()];
        let packed = self.all_monomials(|m| {
            m.unpack(layout, &mut exponents);
            M::pack(layout, &exponents).as_ref() == Some(m)
        });
        let narrow_layout = (ring.narrowest()..M::KIND).all(|kind| {
            ring.layout(kind).is_none_or(|narrower| {
                let excess = layout.excess_of(narrower);
                !self.all_monomials(|m| !m.meets(excess))
            })
        });
        descending && narrow_width && packed && narrow_layout
    }
}

impl Terms {
    /// About how many bytes they take.
    #[inline]
    pub fn bytes(&self) -> usize {
        each_layout!(self, list => list.bytes())
    }
}

impl Terms {
    /// The empty list.
    #[inline]
    pub fn zero(ring: Ring) -> Self {
        Terms::empty_of_kind(ring.narrowest())
    }

    fn empty_of_kind(kind: usize) -> Self {
        match kind {
            0 => Terms::One(TermList::new()),
            1 => Terms::Two(TermList::new()),
            2 => Terms::Four(TermList::new()),
            3 => Terms::Eight(TermList::new()),
            _ => Terms::Wide(TermList::new()),
        }
    }

    /// The index of the layout.
    #[inline]
    pub fn kind(&self) -> usize {
        match self {
            Terms::One(_) => 0,
            Terms::Two(_) => 1,
            Terms::Four(_) => 2,
            Terms::Eight(_) => 3,
            Terms::Wide(_) => 4,
        }
    }

    #[inline]
    pub fn len(&self) -> usize {
        each_layout!(self, list => list.len())
    }

    #[inline]
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// The same terms in the layout of a kind that can hold them: not canonical, for work in between.
    pub fn in_kind(&self, ring: Ring, kind: usize) -> Terms {
        each_layout!(self, list => list.convert_to_kind(ring, kind))
    }

    /// Both lists in the wider of their layouts.
    #[inline]
    pub fn align<'a>(ring: Ring, a: &'a Terms, b: &'a Terms) -> (Aligned<'a>, Aligned<'a>) {
        match a.kind().cmp(&b.kind()) {
            std::cmp::Ordering::Equal => (Aligned::Borrowed(a), Aligned::Borrowed(b)),
            std::cmp::Ordering::Less => (
                Aligned::Owned(a.in_kind(ring, b.kind())),
                Aligned::Borrowed(b),
            ),
            std::cmp::Ordering::Greater => (
                Aligned::Borrowed(a),
                Aligned::Owned(b.in_kind(ring, a.kind())),
            ),
        }
    }

    /// Whether the invariants hold.
    pub fn is_canonical(&self, ring: Ring) -> bool {
        let empty_is_zero = !self.is_empty() || *self == Terms::zero(ring);
        empty_is_zero && each_layout!(self, list => list.is_canonical(ring))
    }
}

/// A list as it was, or converted.
pub(crate) enum Aligned<'a> {
    Borrowed(&'a Terms),
    Owned(Terms),
}

impl std::ops::Deref for Aligned<'_> {
    type Target = Terms;
    #[inline]
    fn deref(&self) -> &Terms {
        match self {
            Aligned::Borrowed(terms) => terms,
            Aligned::Owned(terms) => terms,
        }
    }
}
