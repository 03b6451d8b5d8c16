//! Multiplication, by shape: term by polynomial, all products sorted, slices of a dense window, or three
//! products in place of four.
//!
//! First a bound on the coefficients of the result chooses the accumulator (64 bits, 128 bits, three
//! words, sums of digits, unbounded), and a bound on the exponents shows that the layout holds the result;
//! then no kernel has to look for overflows. (Sums on the way may wrap, see [`crate::accumulator`].)

use crate::accumulator::{Additive, ProductsOf};
use crate::allowance;
use crate::budget::Budget;
use crate::error::{Error, Resource};
use crate::karatsuba;
use crate::layout::Layout;
use crate::limbs::{self, DigitSum, Digits, Triple};
use crate::packed::PackedMonomial;
use crate::plan::{Plan, Shape};
use crate::terms::{Term, TermList};
use crate::window;
use num_bigint::BigInt;

/// Up to this many products nothing is planned: they are formed and sorted.
const SMALL: usize = 256;

/// The bytes of products that are formed before they are sorted and added.
const WAITING: usize = 16 << 20;

/// Why a product was not formed.
#[derive(Debug)]
pub(crate) enum Failure {
    /// An exponent does not fit the layout.
    Layout,
    /// Something that a wider layout does not mend.
    Error(Error),
}

impl From<Error> for Failure {
    fn from(error: Error) -> Self {
        Failure::Error(error)
    }
}

/// The product of two lists.
pub(crate) fn multiply<M: PackedMonomial>(
    f: &TermList<M>,
    g: &TermList<M>,
    layout: &Layout,
    budget: &Budget,
) -> Result<TermList<M>, Failure> {
    let (shorter, longer) = if f.len() <= g.len() { (f, g) } else { (g, f) };
    if shorter.len() == 0 {
        return Ok(TermList::new());
    }
    if !exponents_fit(shorter, longer, layout) {
        return Err(Failure::Layout);
    }
    let count = (shorter.len() as u64).saturating_mul(longer.len() as u64);
    budget.spend(Budget::products(count, shorter.bits(), longer.bits()))?;
    // Long monomials and products that meet no equal cost more than a step: each is copied.
    if shorter.len() == 1 || layout.is_wide() {
        let words = if layout.is_wide() {
            layout.fields as u64
        } else {
            4
        };
        allowance::spend(count.saturating_mul(words.max(4)));
    }
    // A coefficient of the product is a sum of at most `shorter.len()` products.
    let carry = u64::from(usize::BITS - (shorter.len() - 1).leading_zeros());
    let bits = shorter.bits() + longer.bits() + carry;
    // Differences of words must fit words.
    let spare = 63u32.saturating_sub(shorter.bits().max(longer.bits()) as u32);
    let product = match (shorter, longer) {
        (TermList::Word(f), TermList::Word(g)) => match bits {
            0..=63 => products::<M, i64, i64>(f, g, layout, budget, u32::MAX),
            64..=127 => products::<M, i64, i128>(f, g, layout, budget, spare),
            _ => products::<M, i64, Triple>(f, g, layout, budget, spare),
        },
        (f, g) => match (f.to_double(), g.to_double()) {
            (Some(f), Some(g)) if bits <= 127 => {
                products::<M, _, i128>(&f, &g, layout, budget, u32::MAX)
            }
            _ => long_products(f, g, layout, budget),
        },
    }?;
    // Cancellation apart, the bound is sharp; only a tight budget needs the true size.
    if bits > budget.bits() {
        budget.check_bits(product.bits())?;
    }
    Ok(product)
}

/// The product of two nonempty lists, with more bits than two words.
fn long_products<M: PackedMonomial>(
    f: &TermList<M>,
    g: &TermList<M>,
    layout: &Layout,
    budget: &Budget,
) -> Result<TermList<M>, Error> {
    fn in_digits<M: PackedMonomial, const L: usize>(
        f: &TermList<M>,
        g: &TermList<M>,
        layout: &Layout,
        budget: &Budget,
    ) -> Result<TermList<M>, Error> {
        let (f, g) = (f.map_to(Digits::<L>::of), g.map_to(Digits::<L>::of));
        products::<M, _, DigitSum<L>>(&f, &g, layout, budget, 63 - limbs::WIDTH)
    }
    let digits = f.bits().max(g.bits()).div_ceil(u64::from(limbs::WIDTH));
    // A single term needs no sums, and each product of coefficients adds `digits` products of digits.
    let digits = match (f.len() as u64).saturating_mul(digits) {
        _ if f.len() == 1 => u64::MAX,
        0..=limbs::MOST_PRODUCTS => digits,
        _ => u64::MAX,
    };
    match digits {
        0..=2 => in_digits::<M, 2>(f, g, layout, budget),
        3 => in_digits::<M, 3>(f, g, layout, budget),
        4 => in_digits::<M, 4>(f, g, layout, budget),
        5..=6 => in_digits::<M, 6>(f, g, layout, budget),
        _ => products::<M, _, BigInt>(&f.to_big(), &g.to_big(), layout, budget, u32::MAX),
    }
}

/// The product of two nonempty lists with coefficients of one width, of which differences may be formed
/// `headroom` times over.
fn products<M: PackedMonomial, C: Additive, A: ProductsOf<C>>(
    f: &[Term<M, C>],
    g: &[Term<M, C>],
    layout: &Layout,
    budget: &Budget,
    headroom: u32,
) -> Result<TermList<M>, Error> {
    if let [term] = f {
        allowance::reserve(bytes::<M, C>(g.len(), layout));
        let mut list = TermList::with_capacity(g.len());
        budget.check_terms(g.len())?;
        for other in g {
            A::product(&term.coefficient, &other.coefficient)
                .append(term.monomial.product(&other.monomial), &mut list);
        }
        return Ok(list);
    }
    if f.len() * g.len() > SMALL {
        if let Some(product) = karatsuba::multiply::<M, C, A>(f, g, layout, headroom) {
            budget.check_terms(product.len())?;
            return Ok(product);
        }
        let (a, b) = (Shape::of(f, layout), Shape::of(g, layout));
        if let Some(plan) = Plan::best(a, b, std::mem::size_of::<A>()) {
            return window::multiply::<M, C, A, _>(f, g, layout, &plan, budget.terms());
        }
    }
    // Some rows at a time, so that never many products wait that will meet equal ones.
    let row = bytes::<M, A>(g.len(), layout).max(1);
    let mut list = TermList::new();
    for rows in f.chunks((WAITING / row).max(1)) {
        // The steps are paid for; here somebody who asks to stop is heard.
        allowance::spend(0);
        let mut all: Vec<Term<M, A>> = Vec::with_capacity(rows.len() * g.len());
        for a in rows {
            for b in g {
                all.push(Term {
                    monomial: a.monomial.product(&b.monomial),
                    coefficient: A::product(&a.coefficient, &b.coefficient),
                });
            }
        }
        let part = A::collect(all);
        list = match list.len() {
            0 => part,
            _ => list.merge::<false>(&part),
        };
        allowance::reserve(bytes::<M, C>(list.len(), layout));
    }
    if list.len() > budget.terms() {
        return Err(Error::BudgetExceeded(Resource::Terms));
    }
    Ok(list)
}

/// The bytes of so many terms, those of long coefficients apart.
fn bytes<M, C>(terms: usize, layout: &Layout) -> usize {
    let apart = if layout.is_wide() {
        8 * layout.fields
    } else {
        0
    };
    terms.saturating_mul(std::mem::size_of::<Term<M, C>>() + apart)
}

/// Whether the layout holds all products of monomials.
fn exponents_fit<M: PackedMonomial>(f: &TermList<M>, g: &TermList<M>, layout: &Layout) -> bool {
    // A quick bound from the bits that occur, then the true maxima.
    if !layout.is_wide() {
        let (Some(a), Some(b)) = (join(f), join(g)) else {
            return true;
        };
        if !a.product(&b).overflows(layout) {
            return true;
        }
        let (a, b) = (f.greatest_fields(layout), g.greatest_fields(layout));
        return a.iter().zip(&b).all(|(x, y)| x + y <= layout.limit());
    }
    let (a, b) = (f.degrees(layout), g.degrees(layout));
    a.iter().zip(&b).all(|(x, y)| x.checked_add(*y).is_some())
}

fn join<M: PackedMonomial>(list: &TermList<M>) -> Option<M> {
    fn fold<M: PackedMonomial, C>(terms: &[Term<M, C>]) -> Option<M> {
        let (first, rest) = terms.split_first()?;
        Some(
            rest.iter()
                .fold(first.monomial.clone(), |all, t| all.join(&t.monomial)),
        )
    }
    crate::terms::each_width!(list, terms => fold(terms))
}
