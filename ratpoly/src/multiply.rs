//! Multiplication, by shape: term by polynomial, all products sorted, or slices of a dense window.
//!
//! First a bound on the coefficients of the result chooses the accumulator (64 bits, 128 bits,
//! unbounded), and a bound on the exponents shows that the layout holds the result; then no kernel has
//! to look for overflows.

use crate::accumulator::ProductsOf;
use crate::budget::Budget;
use crate::coefficient::Coefficient;
use crate::error::{Error, Resource};
use crate::layout::Layout;
use crate::packed::PackedMonomial;
use crate::terms::{Term, TermList};
use crate::window;

/// Up to this many products nothing is planned: they are formed and sorted.
const SMALL: usize = 256;

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
    budget.spend((shorter.len() as u64).saturating_mul(longer.len() as u64))?;
    // A coefficient of the product is a sum of at most `shorter.len()` products.
    let carry = u64::from(usize::BITS - (shorter.len() - 1).leading_zeros());
    let bits = shorter.bits() + longer.bits() + carry;
    let product = match (shorter, longer) {
        (TermList::Word(f), TermList::Word(g)) if bits <= 63 => {
            products::<M, i64, i64>(f, g, layout, budget)
        }
        (TermList::Word(f), TermList::Word(g)) if bits <= 127 => {
            products::<M, i64, i128>(f, g, layout, budget)
        }
        (f, g) => match (f.to_double(), g.to_double()) {
            (Some(f), Some(g)) if bits <= 127 => products::<M, _, i128>(&f, &g, layout, budget),
            _ => products::<M, _, num_bigint::BigInt>(&f.to_big(), &g.to_big(), layout, budget),
        },
    }?;
    // Cancellation apart, the bound is sharp; only a tight budget needs the true size.
    if bits > budget.bits() {
        budget.check_bits(product.bits())?;
    }
    Ok(product)
}

/// The product of two nonempty lists with coefficients of one width.
fn products<M: PackedMonomial, C: Coefficient, A: ProductsOf<C>>(
    f: &[Term<M, C>],
    g: &[Term<M, C>],
    layout: &Layout,
    budget: &Budget,
) -> Result<TermList<M>, Error> {
    if let [term] = f {
        let mut list = TermList::with_capacity(g.len());
        budget.check_terms(g.len())?;
        for other in g {
            A::product(&term.coefficient, &other.coefficient)
                .append(term.monomial.product(&other.monomial), &mut list);
        }
        return Ok(list);
    }
    if f.len() * g.len() > SMALL {
        let shape = |terms: &[Term<M, C>]| {
            window::Shape::of(&mut terms.iter().map(|t| &t.monomial), layout)
        };
        if let Some(plan) = window::Plan::best(shape(f), shape(g), std::mem::size_of::<A>()) {
            return window::multiply::<M, C, A>(f, g, layout, &plan, budget.terms());
        }
    }
    let mut all: Vec<Term<M, A>> = Vec::with_capacity(f.len() * g.len());
    for a in f {
        for b in g {
            all.push(Term {
                monomial: a.monomial.product(&b.monomial),
                coefficient: A::product(&a.coefficient, &b.coefficient),
            });
        }
    }
    let list = A::collect(all);
    if list.len() > budget.terms() {
        return Err(Error::BudgetExceeded(Resource::Terms));
    }
    Ok(list)
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
