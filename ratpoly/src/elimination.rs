//! Elimination of variables by Gröbner bases in block orders, saturation, and the polynomial relations
//! among given rational functions (Cox, Little, O'Shea, Ideals, Varieties, and Algorithms, sections 3.1,
//! 3.3 and 4.4).

use crate::budget::Budget;
use crate::error::Error;
use crate::gcd::lcm;
use crate::groebner::{BlockOrder, Terms, groebner_basis};
use crate::monomial::Monomial;
use crate::polynomial::Polynomial;
use crate::rational_function::RationalFunction;
use crate::ring::{Order, Ring};
use num_bigint::BigInt;
use num_traits::One;

/// The reduced Gröbner basis of the members in which none of the variables occurs.
pub(crate) fn eliminate(
    ring: Ring,
    generators: &[Polynomial],
    variables: &[usize],
    budget: &Budget,
) -> Result<Vec<Polynomial>, Error> {
    if let Some(&bad) = variables.iter().find(|&&v| v >= ring.len()) {
        return Err(Error::VariableOutOfRange(bad));
    }
    if generators.iter().any(|g| g.ring() != ring) {
        return Err(Error::RingMismatch);
    }
    let kept: Vec<usize> = (0..ring.len()).filter(|i| !variables.contains(i)).collect();
    let dropped: Vec<usize> = (0..ring.len()).filter(|i| variables.contains(i)).collect();
    let place: Vec<usize> = dropped.iter().chain(&kept).copied().collect();
    let lists = generators
        .iter()
        .map(|g| rearrange(g, |e| place.iter().map(|&i| e[i]).collect()))
        .collect::<Vec<_>>();
    eliminate_first(&lists, dropped.len(), ring, &kept, budget)
}

/// The members in which none of the first `count` variables occurs, with the others renamed to variables
/// of the target.
fn eliminate_first(
    generators: &[Terms],
    count: usize,
    target: Ring,
    names: &[usize],
    budget: &Budget,
) -> Result<Vec<Polynomial>, Error> {
    let order = BlockOrder::new([(count, Order::Grevlex), (names.len(), target.order())]);
    let mut lists = generators.to_vec();
    for list in &mut lists {
        list.sort_by(|a, b| order.compare(&b.0, &a.0));
    }
    let mut members = Vec::new();
    for element in groebner_basis(&order, &lists, None, budget)? {
        // The leading monomial decides: it is free of the first block only if all of them are.
        if element.terms[0].0[..count].iter().any(|&e| e > 0) {
            continue;
        }
        let terms = element.terms.into_iter().map(|(m, c)| {
            let mut exponents = vec![0; target.len()];
            for (&name, &e) in names.iter().zip(&m[count..]) {
                exponents[name] = e;
            }
            (exponents, c)
        });
        members.push(Polynomial::from_terms(target, terms)?);
    }
    Ok(members)
}

/// The polynomials of which the product with some power of `by` lies in the ideal: adjoin the reciprocal
/// `t` of `by` and eliminate it.
pub(crate) fn saturate(
    ring: Ring,
    generators: &[Polynomial],
    by: &Polynomial,
    budget: &Budget,
) -> Result<Vec<Polynomial>, Error> {
    if by.ring() != ring || generators.iter().any(|g| g.ring() != ring) {
        return Err(Error::RingMismatch);
    }
    let prefix = |e: &[u32], t: u32| [&[t], e].concat();
    let mut lists: Vec<Terms> = generators
        .iter()
        .map(|g| rearrange(g, |e| prefix(e, 0)))
        .collect();
    let mut unit = rearrange(by, |e| prefix(e, 1));
    unit.push((Monomial::one(ring.len() + 1), -BigInt::one()));
    lists.push(unit);
    let names: Vec<usize> = (0..ring.len()).collect();
    eliminate_first(&lists, 1, ring, &names, budget)
}

/// The ideal of all polynomial relations among rational functions: a reduced Gröbner basis in the ring of
/// the given names (same order as the functions' ring). Empty if the functions are algebraically
/// independent. A name may be that of a variable in the functions; it is another letter.
///
/// ```
/// use ratpoly::{Order, RationalFunction, Ring, relations};
/// # fn main() -> Result<(), ratpoly::Error> {
/// let ring = Ring::new(["t"], Order::Lex)?;
/// let f = |text| RationalFunction::parse(ring, text);
/// let circle = relations(&[("x", f("(1 - t^2)/(1 + t^2)")?), ("y", f("2*t/(1 + t^2)")?)])?;
/// assert_eq!(circle[0].to_string(), "x^2 + y^2 - 1");
/// # Ok(())
/// # }
/// ```
pub fn relations<S: AsRef<str>>(
    functions: &[(S, RationalFunction)],
) -> Result<Vec<Polynomial>, Error> {
    relations_within(functions, &Budget::default())
}

/// [`relations`] within a budget.
pub fn relations_within<S: AsRef<str>>(
    functions: &[(S, RationalFunction)],
    budget: &Budget,
) -> Result<Vec<Polynomial>, Error> {
    let Some((_, first)) = functions.first() else {
        return Ok(Vec::new());
    };
    let ring = first.ring();
    if functions.iter().any(|(_, f)| f.ring() != ring) {
        return Err(Error::RingMismatch);
    }
    let target = Ring::new(
        functions.iter().map(|(name, _)| name.as_ref()),
        ring.order(),
    )?;
    let mut common = Polynomial::one(ring);
    for (_, f) in functions {
        common = lcm(&common, &square_free_monomial(f.denominator())?);
    }
    let occurring: Vec<usize> = (0..ring.len())
        .filter(|&i| {
            let occurs = |p: &Polynomial| p.degree(i).is_some_and(|d| d > 0);
            functions
                .iter()
                .any(|(_, f)| occurs(f.numerator()) || occurs(f.denominator()))
        })
        .collect();
    // The variables are: t, the reciprocal of the denominators; those that occur; one for each function.
    let count = 1 + occurring.len();
    let place = |e: &[u32], t: u32, function: Option<usize>| {
        let mut exponents = vec![0; count + functions.len()];
        exponents[0] = t;
        for (slot, &i) in exponents[1..].iter_mut().zip(&occurring) {
            *slot = e[i];
        }
        if let Some(k) = function {
            exponents[count + k] = 1;
        }
        exponents
    };
    let mut lists: Vec<Terms> = Vec::new();
    for (k, (_, f)) in functions.iter().enumerate() {
        let mut list = rearrange(f.denominator(), |e| place(e, 0, Some(k)));
        list.extend(rearrange(&-f.numerator(), |e| place(e, 0, None)));
        lists.push(list);
    }
    let mut unit = rearrange(&common, |e| place(e, 1, None));
    unit.push((Monomial::one(count + functions.len()), -BigInt::one()));
    lists.push(unit);
    let names: Vec<usize> = (0..functions.len()).collect();
    eliminate_first(&lists, count, target, &names, budget)
}

/// The polynomial with its monomial content replaced by the product of the variables in it: the same
/// zeros, lower degree.
fn square_free_monomial(f: &Polynomial) -> Result<Polynomial, Error> {
    let content = f.monomial_content();
    let terms = f.terms().map(|(m, c)| {
        let exponents: Vec<u32> = m
            .iter()
            .zip(content.iter())
            .map(|(&e, &k)| e - k + k.min(1))
            .collect();
        (exponents, c)
    });
    Polynomial::from_terms(f.ring(), terms)
}

fn rearrange(f: &Polynomial, map: impl Fn(&[u32]) -> Vec<u32>) -> Terms {
    f.terms()
        .map(|(m, c)| (Monomial::new(map(&m)), c))
        .collect()
}
