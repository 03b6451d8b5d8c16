//! Exact division by a heap (Johnson 1974; Monagan and Pearce 2011).
//!
//! The terms of `dividend - quotient * divisor` are produced in descending order: for every divisor term
//! but the first, the heap holds its product with the next term of the quotient. A term that does not
//! cancel must be divisible by the leading term and gives the next term of the quotient.

use crate::accumulator::Accumulator;
use crate::coefficient::{Coefficient, Value};
use crate::layout::Layout;
use crate::packed::PackedMonomial;
use crate::terms::{Term, TermList, each_width};
use num_bigint::BigInt;
use num_integer::Integer as _;
use std::cmp::Ordering;
use std::collections::BinaryHeap;

/// What a division came to.
pub(crate) enum Outcome<M> {
    Quotient(TermList<M>),
    NotDivisible,
    /// The quotient, if there is one, has more terms than allowed.
    TooLong,
}

/// The quotient of two lists, the divisor not empty, if it divides and has at most `most` terms.
pub(crate) fn divide<M: PackedMonomial>(
    dividend: &TermList<M>,
    divisor: &TermList<M>,
    layout: &Layout,
    most: usize,
) -> Outcome<M> {
    if dividend.len() == 0 {
        return Outcome::Quotient(TermList::new());
    }
    if !ends_divide(dividend, divisor, layout) {
        return Outcome::NotDivisible;
    }
    if divisor.len() == 1 {
        return divide_by_term(dividend, divisor, layout);
    }
    if let TermList::Word(divisor) = divisor
        && !matches!(dividend, TermList::Big(_))
    {
        let source = |k: usize| dividend.get(k).map(|(m, c)| (m, small(c)));
        if let Ok(outcome) = exact::<M, i64, i128>(source, divisor, layout, most) {
            return outcome;
        }
    }
    let source = |k: usize| dividend.get(k).map(|(m, c)| (m, c.to_big()));
    match exact::<M, BigInt, BigInt>(source, &divisor.to_big(), layout, most) {
        Ok(outcome) => outcome,
        Err(Overflow) => unreachable!("unbounded integers do not overflow"),
    }
}

fn small(value: Value<'_>) -> i128 {
    match value {
        Value::Small(c) => c,
        Value::Big(_) => unreachable!("the width was looked at"),
    }
}

/// Whether leading term divides leading term, and last divides last: most failures show here.
fn ends_divide<M: PackedMonomial>(f: &TermList<M>, g: &TermList<M>, layout: &Layout) -> bool {
    let divides = |i: usize, j: usize| {
        f.get(i).zip(g.get(j)).is_some_and(|((m, c), (n, d))| {
            m.quotient(n, layout).is_some() && d.to_scalar().divide(c).is_some()
        })
    };
    divides(0, 0) && divides(f.len() - 1, g.len() - 1)
}

fn divide_by_term<M: PackedMonomial>(
    dividend: &TermList<M>,
    divisor: &TermList<M>,
    layout: &Layout,
) -> Outcome<M> {
    let (n, d) = divisor.get(0).expect("the divisor has a term");
    let d = d.to_scalar();
    let mut quotient = TermList::with_capacity(dividend.len());
    let divisible = each_width!(dividend, terms => terms.iter().all(|t| {
        match (t.monomial.quotient(n, layout), d.divide(t.coefficient.value())) {
            (Some(m), Some(c)) => { quotient.push(m, c); true }
            _ => false,
        }
    }));
    if divisible {
        Outcome::Quotient(quotient)
    } else {
        Outcome::NotDivisible
    }
}

/// A coefficient did not fit the width in which the division was tried.
pub(crate) struct Overflow;

/// The rest of a coefficient while products are taken from it.
pub(crate) trait Rest<C>: Accumulator {
    fn subtract_product(&mut self, a: &C, b: &C) -> Result<(), Overflow>;
    /// The quotient; `None` if the division leaves a remainder.
    fn quotient(&self, divisor: &C) -> Result<Option<C>, Overflow>;
    fn append_quotient<M: PackedMonomial>(coefficient: &C, monomial: M, list: &mut TermList<M>);
}

impl Rest<i64> for i128 {
    #[inline]
    fn subtract_product(&mut self, a: &i64, b: &i64) -> Result<(), Overflow> {
        *self = self
            .checked_sub(i128::from(*a) * i128::from(*b))
            .ok_or(Overflow)?;
        Ok(())
    }

    #[inline]
    fn quotient(&self, divisor: &i64) -> Result<Option<i64>, Overflow> {
        // Division of machine words is much faster than of pairs of words.
        let quotient = match i64::try_from(*self) {
            Ok(rest) if *divisor != -1 => {
                return Ok((rest % divisor == 0).then(|| rest / divisor));
            }
            _ => {
                let divisor = i128::from(*divisor);
                if self.checked_rem(divisor).ok_or(Overflow)? != 0 {
                    return Ok(None);
                }
                self / divisor
            }
        };
        i64::try_from(quotient).map(Some).map_err(|_| Overflow)
    }

    #[inline]
    fn append_quotient<M: PackedMonomial>(coefficient: &i64, monomial: M, list: &mut TermList<M>) {
        list.push_word(monomial, *coefficient);
    }
}

impl Rest<BigInt> for BigInt {
    fn subtract_product(&mut self, a: &BigInt, b: &BigInt) -> Result<(), Overflow> {
        *self -= a * b;
        Ok(())
    }

    fn quotient(&self, divisor: &BigInt) -> Result<Option<BigInt>, Overflow> {
        let (quotient, remainder) = self.div_rem(divisor);
        Ok((remainder == BigInt::ZERO).then_some(quotient))
    }

    fn append_quotient<M: PackedMonomial>(
        coefficient: &BigInt,
        monomial: M,
        list: &mut TermList<M>,
    ) {
        list.push(monomial, coefficient.clone().into());
    }
}

/// The product of a divisor term and a quotient term that waits in the heap.
struct Pending<M> {
    monomial: M,
    divisor: usize,
    quotient: usize,
}

impl<M: Ord> Ord for Pending<M> {
    fn cmp(&self, other: &Self) -> Ordering {
        self.monomial.cmp(&other.monomial)
    }
}

impl<M: Ord> PartialOrd for Pending<M> {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl<M: Ord> PartialEq for Pending<M> {
    fn eq(&self, other: &Self) -> bool {
        self.monomial == other.monomial
    }
}

impl<M: Ord> Eq for Pending<M> {}

/// The quotient in one width.
fn exact<'a, M: PackedMonomial, C: Coefficient, R: Rest<C>>(
    dividend: impl Fn(usize) -> Option<(&'a M, R)>,
    divisor: &[Term<M, C>],
    layout: &Layout,
    most: usize,
) -> Result<Outcome<M>, Overflow> {
    let lead = &divisor[0];
    let product = |a: &Term<M, C>, b: &Term<M, C>| a.monomial.product(&b.monomial);
    let mut quotient: Vec<Term<M, C>> = Vec::new();
    let mut list = TermList::new();
    let mut heap: BinaryHeap<Pending<M>> = BinaryHeap::with_capacity(divisor.len());
    // Divisor terms whose next product needs a quotient term that is not known yet; at first the second
    // term only: the product of a later one is smaller, it enters when its predecessor first leaves.
    let mut waiting: Vec<(usize, usize)> = vec![(1, 0)];
    let mut next = 0;
    loop {
        let head = dividend(next);
        // Where the divisor divides, all products have exponents that the dividend has too.
        if heap
            .peek()
            .is_some_and(|pending| pending.monomial.overflows(layout))
        {
            return Ok(Outcome::NotDivisible);
        }
        let monomial = match (&head, heap.peek()) {
            (None, None) => return Ok(Outcome::Quotient(list)),
            (Some((m, _)), Some(pending)) => (*m).max(&pending.monomial).clone(),
            (Some((m, _)), None) => (*m).clone(),
            (None, Some(pending)) => pending.monomial.clone(),
        };
        let mut rest = R::ZERO;
        if let Some((m, c)) = head
            && *m == monomial
        {
            rest = c;
            next += 1;
        }
        loop {
            let Some(mut top) = heap.peek_mut() else {
                break;
            };
            if top.monomial != monomial {
                break;
            }
            let (i, k) = (top.divisor, top.quotient);
            rest.subtract_product(&divisor[i].coefficient, &quotient[k].coefficient)?;
            // The next product of this divisor term takes its place.
            if k + 1 < quotient.len() {
                top.monomial = product(&divisor[i], &quotient[k + 1]);
                top.quotient = k + 1;
                drop(top);
            } else {
                std::collections::binary_heap::PeekMut::pop(top);
                waiting.push((i, k + 1));
            }
            if k == 0 && i + 1 < divisor.len() {
                let monomial = product(&divisor[i + 1], &quotient[0]);
                heap.push(Pending {
                    monomial,
                    divisor: i + 1,
                    quotient: 0,
                });
            }
        }
        if rest.is_zero() {
            continue;
        }
        let Some(m) = monomial.quotient(&lead.monomial, layout) else {
            return Ok(Outcome::NotDivisible);
        };
        let Some(c) = rest.quotient(&lead.coefficient)? else {
            return Ok(Outcome::NotDivisible);
        };
        if quotient.len() == most {
            return Ok(Outcome::TooLong);
        }
        R::append_quotient(&c, m.clone(), &mut list);
        quotient.push(Term {
            monomial: m,
            coefficient: c,
        });
        let k = quotient.len() - 1;
        for (i, wanted) in waiting.drain(..) {
            debug_assert_eq!(wanted, k);
            let monomial = product(&divisor[i], &quotient[k]);
            heap.push(Pending {
                monomial,
                divisor: i,
                quotient: k,
            });
        }
    }
}
