//! How the exponents of a ring are packed into machine words.
//!
//! A monomial is a row of fields such that comparing rows compares monomials and adding rows multiplies
//! them: the fields are linear in the exponents (Monagan and Pearce 2007 pack likewise).
//!
//! | order | fields, the most significant first |
//! | --- | --- |
//! | lex | `e_1, ..., e_n` |
//! | grlex | `e_1 + ... + e_n`, then `e_1, ..., e_(n-1)` |
//! | grevlex | `e_1 + ... + e_n`, `e_1 + ... + e_(n-1)`, ..., `e_1` |
//!
//! A field has a guard bit on top that is zero in every stored monomial: a sum that sets it has
//! overflowed, and a difference that borrows shows there. Fields do not cross words, so that words of
//! one monomial are added without carries. Five layouts exist for a ring: 1, 2, 4, 8 words with fields of
//! equal width, and one field a word for whatever does not fit.

use crate::ring::Order;

/// Fields narrower than this (exponents up to 7) would overflow too often to be worth it.
const MIN_BITS: u32 = 4;
/// Wide enough for every exponent, a `u32`, and the guard bit.
const MAX_BITS: u32 = 33;

/// The number of layouts of a ring.
pub(crate) const KINDS: usize = 5;
/// The words of a monomial in the packed layouts.
const WORDS: [usize; KINDS - 1] = [1, 2, 4, 8];

/// One way to lay the exponents of a ring into words.
#[derive(Debug, Clone)]
pub(crate) struct Layout {
    pub order: Order,
    pub variables: usize,
    /// The number of fields.
    pub fields: usize,
    /// The bits of a field, guard bit included.
    pub bits: u32,
    /// The fields in a word, aligned to its upper end.
    pub per_word: usize,
    /// The guard bits of a word.
    pub guard: u64,
}

impl Layout {
    /// The layouts of a ring by kind; those are left out that hold no more than a smaller one. The last,
    /// one field a word, always exists.
    pub fn all(order: Order, variables: usize) -> [Option<Layout>; KINDS] {
        let fields = variables.max(1);
        let layout = |bits: u32, per_word: usize| {
            let guard = (0..per_word).fold(0, |g, k| g | 1 << (63 - bits as usize * k));
            Layout {
                order,
                variables,
                fields,
                bits,
                per_word,
                guard,
            }
        };
        let mut layouts = [None, None, None, None, Some(layout(64, 1))];
        let mut widest = MIN_BITS - 1;
        for (slot, words) in layouts.iter_mut().zip(WORDS) {
            let per_word = fields.div_ceil(words);
            let bits = u32::try_from(64 / per_word).unwrap_or(0).min(MAX_BITS);
            if bits > widest {
                *slot = Some(layout(bits, per_word));
                widest = bits;
            }
        }
        layouts
    }

    /// The bits of a word that no monomial sets which also fits the narrower layout's fields.
    pub fn excess_of(&self, narrower: &Layout) -> u64 {
        let field = (1u64 << (self.bits - 1)) - (1u64 << (narrower.bits - 1));
        (0..self.per_word).fold(0, |mask, k| mask | field << self.shift(k))
    }

    /// Whether this is the layout with one field a word.
    pub fn is_wide(&self) -> bool {
        self.bits == 64
    }

    /// The greatest value of a field.
    pub fn limit(&self) -> u64 {
        (1 << (self.bits - 1)) - 1
    }

    /// The word in which a field lies, and its shift there.
    pub fn place(&self, field: usize) -> (usize, u32) {
        (field / self.per_word, self.shift(field % self.per_word))
    }

    fn shift(&self, index_in_word: usize) -> u32 {
        64 - self.bits * (index_in_word as u32 + 1)
    }

    /// Calls `see` with the values of all fields for given exponents, the last field first.
    #[inline]
    pub fn each_field(&self, exponents: &[u32], mut see: impl FnMut(u64)) {
        match (self.order, exponents) {
            (_, []) => see(0),
            (Order::Lex, all) => all.iter().rev().for_each(|e| see(u64::from(*e))),
            (Order::Grlex, [others @ .., last]) => {
                let mut sum = u64::from(*last);
                for e in others.iter().rev() {
                    sum += u64::from(*e);
                    see(u64::from(*e));
                }
                see(sum);
            }
            (Order::Grevlex, all) => {
                let mut sum = 0;
                for e in all {
                    sum += u64::from(*e);
                    see(sum);
                }
            }
        }
    }

    /// The exponent of a variable, given the fields by a function.
    pub fn exponent_of(&self, variable: usize, field: impl Fn(usize) -> u64) -> u64 {
        match self.order {
            Order::Lex => field(variable),
            Order::Grlex if variable + 1 == self.variables => {
                field(0) - (1..self.fields).map(field).sum::<u64>()
            }
            Order::Grlex => field(variable + 1),
            Order::Grevlex => {
                let k = self.variables - 1 - variable;
                field(k) - if variable == 0 { 0 } else { field(k + 1) }
            }
        }
    }

    /// Writes the exponents for fields given in their order.
    pub fn exponents_from(&self, fields: impl Iterator<Item = u64>, exponents: &mut [u32]) {
        match self.order {
            Order::Lex => {
                for (e, field) in exponents.iter_mut().zip(fields) {
                    *e = field as u32;
                }
            }
            Order::Grlex => {
                let Some((last, others)) = exponents.split_last_mut() else {
                    return;
                };
                let mut fields = fields;
                let mut rest = fields.next().unwrap_or(0);
                for (e, field) in others.iter_mut().zip(fields) {
                    *e = field as u32;
                    rest -= field;
                }
                *last = rest as u32;
            }
            Order::Grevlex => {
                let mut fields = fields;
                let mut above = fields.next().unwrap_or(0);
                for e in exponents.iter_mut().rev() {
                    let field = fields.next().unwrap_or(0);
                    *e = (above - field) as u32;
                    above = field;
                }
            }
        }
    }
}
