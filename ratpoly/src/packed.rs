//! Packed monomials: rows of fields in one, two, four or eight words, or one field a word. What the fields
//! mean is the business of [`Layout`].

use crate::layout::Layout;
use crate::ring::{Order, Ring};
use crate::terms::{Term, TermList, Terms};
use std::cmp::Ordering;
use std::fmt::Debug;
use std::hash::Hash;

/// A monomial in the layout of its ring and type. Its order is the order of the ring.
pub(crate) trait PackedMonomial: Clone + Ord + Hash + Debug + Send + Sync + 'static {
    /// The index of the layout among those of a ring.
    const KIND: usize;

    /// How many bytes it takes outside of itself.
    #[inline]
    fn bytes_apart(&self) -> usize {
        0
    }

    /// The layout of this type in a ring that has one.
    fn layout(ring: Ring) -> &'static Layout {
        ring.layout(Self::KIND)
            .expect("monomials exist only in a layout of their ring")
    }

    /// The monomial with the given fields, each below the limit of the layout.
    fn from_fields(layout: &Layout, field: impl Fn(usize) -> u64) -> Self;
    /// The value of a field.
    fn field(&self, layout: &Layout, field: usize) -> u64;
    /// The product; the caller sees to overflows.
    fn product(&self, other: &Self) -> Self;
    /// The fieldwise difference; the caller sees to borrows.
    fn difference(&self, other: &Self) -> Self;
    /// The quotient, if `other` divides.
    fn quotient(&self, other: &Self, layout: &Layout) -> Option<Self>;
    /// Whether a sum of two monomials has overflowed a field.
    fn overflows(&self, layout: &Layout) -> bool;
    /// Fields that are at least those of both, and have no more bits than the longer.
    fn join(&self, other: &Self) -> Self;
    /// The greater of each two fields.
    fn maximum(&self, other: &Self, layout: &Layout) -> Self;
    /// Whether a bit of the mask is set in a word.
    fn meets(&self, mask: u64) -> bool;
    /// The list among the lists of all kinds.
    fn wrap(list: TermList<Self>) -> Terms;
    /// The terms, if they are of this kind and their coefficients of one word.
    fn words(terms: &Terms) -> Option<&[Term<Self, i64>]>;
    /// The vector of terms, if they are of this kind and their coefficients of one word.
    fn words_mut(terms: &mut Terms) -> Option<&mut Vec<Term<Self, i64>>>;

    /// Packs exponents, unless one is too large for the layout.
    fn pack(layout: &Layout, exponents: &[u32]) -> Option<Self>;

    /// The exponent of a variable.
    fn exponent(&self, layout: &Layout, variable: usize) -> u32 {
        layout.exponent_of(variable, |k| self.field(layout, k)) as u32
    }

    /// Writes the exponents.
    fn unpack(&self, layout: &Layout, exponents: &mut [u32]);

    /// Whether this is the empty product.
    fn is_one(&self) -> bool {
        !self.meets(u64::MAX)
    }
}

/// Fields packed into `N` words.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub(crate) struct Packed<const N: usize>([u64; N]);

impl<const N: usize> Ord for Packed<N> {
    fn cmp(&self, other: &Self) -> Ordering {
        for k in 0..N - 1 {
            if self.0[k] != other.0[k] {
                return self.0[k].cmp(&other.0[k]);
            }
        }
        self.0[N - 1].cmp(&other.0[N - 1])
    }
}

impl<const N: usize> PartialOrd for Packed<N> {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

macro_rules! packed {
    ($words:literal $kind:literal $name:ident) => {
        impl PackedMonomial for Packed<$words> {
            const KIND: usize = $kind;

            fn wrap(list: TermList<Self>) -> Terms {
                Terms::$name(list)
            }

            #[inline]
            fn words(terms: &Terms) -> Option<&[Term<Self, i64>]> {
                if let Terms::$name(TermList::Word(terms)) = terms {
                    Some(terms)
                } else {
                    None
                }
            }

            #[inline]
            fn words_mut(terms: &mut Terms) -> Option<&mut Vec<Term<Self, i64>>> {
                if let Terms::$name(TermList::Word(terms)) = terms {
                    Some(terms)
                } else {
                    None
                }
            }

            fn from_fields(layout: &Layout, field: impl Fn(usize) -> u64) -> Self {
                let mut words = [0; $words];
                for k in 0..layout.fields {
                    let (word, shift) = layout.place(k);
                    words[word] |= field(k) << shift;
                }
                Packed(words)
            }

            fn field(&self, layout: &Layout, field: usize) -> u64 {
                let (word, shift) = layout.place(field);
                self.0[word] >> shift & layout.limit()
            }

            fn pack(layout: &Layout, exponents: &[u32]) -> Option<Self> {
                let (bits, limit) = (layout.bits, layout.limit());
                let mut words = [0; $words];
                let (mut word, mut shift) = layout.place(layout.fields - 1);
                let mut fits = true;
                layout.each_field(exponents, |value| {
                    if shift == 64 {
                        word -= 1;
                        shift = layout.place(layout.per_word - 1).1;
                    }
                    fits &= value <= limit;
                    words[word] |= value << shift;
                    shift += bits;
                });
                fits.then_some(Packed(words))
            }

            #[inline]
            fn unpack(&self, layout: &Layout, exponents: &mut [u32]) {
                let (bits, limit) = (layout.bits as usize, layout.limit());
                if layout.order == Order::Grevlex {
                    // The differences of neighbouring fields, all of a word at once; most are zero.
                    exponents.fill(0);
                    for (k, word) in self.0.iter().enumerate() {
                        let next = self.0.get(k + 1).map_or(0, |next| next >> (64 - bits));
                        let unused = 64 - bits * layout.per_word;
                        let mut rest = word - (word << bits | next << unused);
                        while rest != 0 {
                            let field = rest.leading_zeros() as usize / bits;
                            let shift = 64 - bits * (field + 1);
                            let variable = layout.variables - 1 - k * layout.per_word - field;
                            exponents[variable] = (rest >> shift & limit) as u32;
                            rest &= !(limit << shift);
                        }
                    }
                    return;
                }
                let fields = self.0.iter().flat_map(|word| {
                    (1..=layout.per_word).map(move |k| word >> (64 - bits * k) & limit)
                });
                layout.exponents_from(fields.take(layout.fields), exponents);
            }

            #[inline]
            fn product(&self, other: &Self) -> Self {
                Packed(std::array::from_fn(|k| self.0[k].wrapping_add(other.0[k])))
            }

            #[inline]
            fn difference(&self, other: &Self) -> Self {
                Packed(std::array::from_fn(|k| self.0[k].wrapping_sub(other.0[k])))
            }

            #[inline]
            fn quotient(&self, other: &Self, layout: &Layout) -> Option<Self> {
                let guard = layout.guard;
                let mut words = [0; $words];
                for (word, (a, b)) in words.iter_mut().zip(self.0.iter().zip(&other.0)) {
                    let difference = (a | guard).wrapping_sub(*b);
                    if difference & guard != guard {
                        return None;
                    }
                    *word = difference ^ guard;
                }
                let quotient = Packed(words);
                descends(&quotient, layout).then_some(quotient)
            }

            #[inline]
            fn overflows(&self, layout: &Layout) -> bool {
                self.meets(layout.guard)
            }

            #[inline]
            fn join(&self, other: &Self) -> Self {
                Packed(std::array::from_fn(|k| self.0[k] | other.0[k]))
            }

            #[inline]
            fn maximum(&self, other: &Self, layout: &Layout) -> Self {
                // A guard bit survives the difference where the left field is not less; below it a
                // mask of the whole field is made.
                Packed(std::array::from_fn(|k| {
                    let (a, b) = (self.0[k], other.0[k]);
                    let not_less = (a | layout.guard).wrapping_sub(b) & layout.guard;
                    let mask = not_less - (not_less >> (layout.bits - 1));
                    a & mask | b & !mask
                }))
            }

            #[inline]
            fn meets(&self, mask: u64) -> bool {
                self.0.iter().any(|w| w & mask != 0)
            }
        }
    };
}

packed!(1 0 One);
packed!(2 1 Two);
packed!(4 2 Four);
packed!(8 3 Eight);

/// One field a word, for exponents that fit no packing.
#[derive(Debug, Clone, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub(crate) struct Wide(Box<[u64]>);

impl PackedMonomial for Wide {
    const KIND: usize = 4;

    fn bytes_apart(&self) -> usize {
        // The allocator takes some besides.
        16 + size_of_val(&*self.0)
    }

    fn wrap(list: TermList<Self>) -> Terms {
        Terms::Wide(list)
    }

    fn words(terms: &Terms) -> Option<&[Term<Self, i64>]> {
        if let Terms::Wide(TermList::Word(terms)) = terms {
            Some(terms)
        } else {
            None
        }
    }

    fn words_mut(terms: &mut Terms) -> Option<&mut Vec<Term<Self, i64>>> {
        if let Terms::Wide(TermList::Word(terms)) = terms {
            Some(terms)
        } else {
            None
        }
    }

    fn from_fields(layout: &Layout, field: impl Fn(usize) -> u64) -> Self {
        Wide((0..layout.fields).map(field).collect())
    }

    fn field(&self, _: &Layout, field: usize) -> u64 {
        self.0[field]
    }

    fn pack(layout: &Layout, exponents: &[u32]) -> Option<Self> {
        let mut fields = Vec::with_capacity(layout.fields);
        layout.each_field(exponents, |value| fields.push(value));
        fields.reverse();
        let fits = fields.iter().all(|value| *value <= layout.limit());
        fits.then(|| Wide(fields.into_boxed_slice()))
    }

    fn unpack(&self, layout: &Layout, exponents: &mut [u32]) {
        layout.exponents_from(self.0.iter().copied(), exponents);
    }

    fn product(&self, other: &Self) -> Self {
        Wide(self.0.iter().zip(&other.0).map(|(a, b)| a + b).collect())
    }

    fn difference(&self, other: &Self) -> Self {
        Wide(self.0.iter().zip(&other.0).map(|(a, b)| a - b).collect())
    }

    fn quotient(&self, other: &Self, layout: &Layout) -> Option<Self> {
        let fields = self.0.iter().zip(&other.0).map(|(a, b)| a.checked_sub(*b));
        let quotient = Wide(fields.collect::<Option<_>>()?);
        descends(&quotient, layout).then_some(quotient)
    }

    /// Sums of fields are far from overflowing 64 bits, but an exponent is a `u32`.
    fn overflows(&self, layout: &Layout) -> bool {
        (0..layout.variables).any(|v| layout.exponent_of(v, |k| self.0[k]) > u64::from(u32::MAX))
    }

    /// The maximum: what it loses in bits it wins in truth.
    fn join(&self, other: &Self) -> Self {
        Wide(
            self.0
                .iter()
                .zip(&other.0)
                .map(|(a, b)| *a.max(b))
                .collect(),
        )
    }

    fn maximum(&self, other: &Self, _: &Layout) -> Self {
        self.join(other)
    }

    fn meets(&self, mask: u64) -> bool {
        self.0.iter().any(|w| w & mask != 0)
    }
}

/// Whether fields that came from a fieldwise difference are those of a monomial: in the orders by degree
/// the exponents are differences of fields and must not be negative.
#[inline]
fn descends<M: PackedMonomial>(monomial: &M, layout: &Layout) -> bool {
    let field = |k| monomial.field(layout, k);
    match layout.order {
        Order::Lex => true,
        Order::Grlex => field(0) >= (1..layout.fields).map(field).sum(),
        Order::Grevlex => (1..layout.fields).all(|k| field(k - 1) >= field(k)),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::layout::KINDS;

    fn round_trip<M: PackedMonomial>(layout: &Layout, exponents: &[u32]) {
        let field = |k: usize| -> u64 {
            let sum = |e: &[u32]| e.iter().map(|e| u64::from(*e)).sum();
            match layout.order {
                _ if exponents.is_empty() => 0,
                Order::Lex => exponents[k].into(),
                Order::Grlex if k == 0 => sum(exponents),
                Order::Grlex => exponents[k - 1].into(),
                Order::Grevlex => sum(&exponents[..exponents.len() - k]),
            }
        };
        let packed = M::pack(layout, exponents);
        let fits = (0..layout.fields).all(|k| field(k) <= layout.limit());
        assert_eq!(packed.is_some(), fits);
        let Some(packed) = packed else { return };
        assert!((0..layout.fields).all(|k| packed.field(layout, k) == field(k)));
        let mut found = vec![7; exponents.len()];
        packed.unpack(layout, &mut found);
        assert_eq!(found, exponents);
        for (variable, exponent) in exponents.iter().enumerate() {
            assert_eq!(packed.exponent(layout, variable), *exponent);
        }
    }

    /// The table of the module's fields, for rings of all sizes in all orders and layouts.
    #[test]
    fn packing_and_unpacking() {
        let mut state = 1_u64;
        let mut random = |below: u32| {
            state = state.wrapping_mul(6364136223846793005).wrapping_add(1);
            ((state >> 33) % u64::from(below)) as u32
        };
        for order in [Order::Lex, Order::Grlex, Order::Grevlex] {
            for variables in 0..80 {
                let layouts: [Option<Layout>; KINDS] = Layout::all(order, variables);
                for round in 0..40 {
                    let below = [2, 3, 20, 1 << 20][round % 4];
                    let exponents: Vec<u32> = (0..variables)
                        .map(|_| random(below) * random(2) * random(2))
                        .collect();
                    let [one, two, four, eight, wide] = &layouts;
                    if let Some(layout) = one {
                        round_trip::<Packed<1>>(layout, &exponents);
                    }
                    if let Some(layout) = two {
                        round_trip::<Packed<2>>(layout, &exponents);
                    }
                    if let Some(layout) = four {
                        round_trip::<Packed<4>>(layout, &exponents);
                    }
                    if let Some(layout) = eight {
                        round_trip::<Packed<8>>(layout, &exponents);
                    }
                    if let Some(layout) = wide {
                        round_trip::<Wide>(layout, &exponents);
                    }
                }
            }
        }
    }
}
