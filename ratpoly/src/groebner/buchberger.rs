//! Buchberger's algorithm (Buchberger 1965) with the criteria of Gebauer and Möller (1988) in the form
//! of Becker and Weispfenning (Gröbner Bases, 1993, section 5.5), pairs chosen by sugar (Giovini, Mora,
//! Niesi, Robbiano, Traverso 1991). Coefficients are integers without a common factor.

use super::order::BlockOrder;
use super::reduce::{GCD_PRODUCTS, Terms, combine, make_primitive, reduce};
use crate::budget::Budget;
use crate::error::Error;
use crate::integer_gcd::integer_gcd;
use crate::monomial::Monomial;
use crate::polynomial::Polynomial;
use crate::ring::Ring;
use num_bigint::BigInt;
use num_traits::{One, Zero};

/// How an element of the ideal comes from its generators:
/// `multiplier * element = sum of cofactors[j] * generators[j]`.
#[derive(Debug, Clone)]
pub(crate) struct Origin {
    pub(crate) multiplier: BigInt,
    pub(crate) cofactors: Vec<Polynomial>,
}

/// An element of the ideal, primitive with a positive leading coefficient.
pub(crate) struct Element {
    pub(crate) terms: Terms,
    sugar: u64,
    pub(crate) origin: Option<Origin>,
}

struct Pair {
    i: usize,
    j: usize,
    lcm: Monomial,
    sugar: u64,
}

struct Buchberger<'a> {
    order: &'a BlockOrder,
    budget: &'a Budget,
    /// The ring of the cofactors, if they are wanted.
    trace: Option<Ring>,
    elements: Vec<Element>,
    /// The elements whose leading monomial no later one divides.
    active: Vec<usize>,
    pairs: Vec<Pair>,
}

/// The reduced Gröbner basis, greatest leading monomial first. With `trace` the ring is that of the
/// generators and its order is `order`.
pub(crate) fn groebner_basis(
    order: &BlockOrder,
    generators: &[Terms],
    trace: Option<Ring>,
    budget: &Budget,
) -> Result<Vec<Element>, Error> {
    let mut state = Buchberger {
        order,
        budget,
        trace,
        elements: Vec::new(),
        active: Vec::new(),
        pairs: Vec::new(),
    };
    let mut inputs: Vec<Element> = Vec::new();
    for (j, terms) in generators.iter().enumerate() {
        if terms.is_empty() {
            continue;
        }
        let origin = trace.map(|ring| Origin {
            multiplier: BigInt::one(),
            cofactors: (0..generators.len())
                .map(|k| Polynomial::constant(ring, i32::from(j == k)))
                .collect(),
        });
        inputs.push(Element {
            sugar: degree(terms),
            terms: terms.clone(),
            origin,
        });
    }
    inputs.sort_by(|a, b| order.compare(&a.terms[0].0, &b.terms[0].0));
    for mut input in inputs {
        primitive(&mut input);
        state.insert(input)?;
    }
    while let Some(pair) = state.next_pair() {
        // The pair was searched for, and its outcome is compared with all elements.
        budget.spend((state.pairs.len() + state.elements.len()) as u64)?;
        let spoly = state.s_polynomial(&pair)?;
        state.insert(spoly)?;
    }
    state.reduced()
}

impl Buchberger<'_> {
    fn leading(&self, i: usize) -> &Monomial {
        &self.elements[i].terms[0].0
    }

    /// Takes the pair of the least sugar, then of the least lcm, then of the least indices.
    fn next_pair(&mut self) -> Option<Pair> {
        let best = (0..self.pairs.len()).min_by(|&x, &y| {
            let (x, y) = (&self.pairs[x], &self.pairs[y]);
            x.sugar
                .cmp(&y.sugar)
                .then_with(|| self.order.compare(&x.lcm, &y.lcm))
                .then_with(|| (x.j, x.i).cmp(&(y.j, y.i)))
        })?;
        Some(self.pairs.swap_remove(best))
    }

    fn s_polynomial(&self, pair: &Pair) -> Result<Element, Error> {
        let (f, g) = (&self.elements[pair.i], &self.elements[pair.j]);
        let ((m, c), (n, d)) = (&f.terms[0], &g.terms[0]);
        let common = integer_gcd(c, d);
        let (a, b) = (d / &common, -(c / &common));
        let shift = |m| pair.lcm.checked_div(m).expect("a factor of the lcm");
        let (u, v) = (shift(m), shift(n));
        let one = BigInt::one();
        let none = Terms::new().into_iter();
        let head = combine(self.order, (&one, none), (&a, &u, &f.terms[1..]))?;
        let terms = combine(
            self.order,
            (&one, head.into_iter()),
            (&b, &v, &g.terms[1..]),
        )?;
        let steps = [(pair.i, u, a), (pair.j, v, b)];
        Ok(Element {
            terms,
            sugar: pair.sugar,
            origin: self.combine_origins(&steps, &one, None)?,
        })
    }

    /// The origin of `multiplier * start + sum of the steps`.
    fn combine_origins(
        &self,
        steps: &[(usize, Monomial, BigInt)],
        multiplier: &BigInt,
        start: Option<&Origin>,
    ) -> Result<Option<Origin>, Error> {
        let Some(ring) = self.trace else {
            return Ok(None);
        };
        let mut lists: Vec<Vec<(&Monomial, BigInt)>> = vec![Vec::new(); self.elements.len()];
        for (i, m, c) in steps {
            lists[*i].push((m, c.clone()));
        }
        let mut summands: Vec<(Polynomial, &Origin)> = Vec::new();
        if let Some(start) = start {
            summands.push((Polynomial::constant(ring, multiplier.clone()), start));
        }
        for (i, list) in lists.into_iter().enumerate() {
            if !list.is_empty() {
                let origin = self.elements[i].origin.as_ref().expect("all are traced");
                summands.push((Polynomial::from_terms(ring, list)?, origin));
            }
        }
        combine_cofactors(ring, &summands, self.budget).map(Some)
    }

    /// Reduces an element of the ideal and, unless it vanishes, adds it with its pairs.
    fn insert(&mut self, element: Element) -> Result<(), Error> {
        let mut element = self.reduce_element(element, None)?;
        if element.terms.is_empty() {
            return Ok(());
        }
        primitive(&mut element);
        self.update(element);
        Ok(())
    }

    /// Reduces by the active elements except one, the leading term included.
    fn reduce_element(&self, element: Element, except: Option<usize>) -> Result<Element, Error> {
        let divisors: Vec<_> = self
            .active
            .iter()
            .filter(|&&i| Some(i) != except)
            .map(|&i| (i, self.elements[i].terms.as_slice()))
            .collect();
        let reduction = reduce(self.order, element.terms, &divisors, self.budget)?;
        let mut sugar = element.sugar;
        for step in &reduction.steps {
            sugar = sugar.max(self.elements[step.index].sugar + step.shift.total_degree());
        }
        let (remainder, origin) = if self.trace.is_none() || reduction.remainder.is_empty() {
            (reduction.remainder, None)
        } else {
            let (identity, remainder) = reduction.into_identity(self.budget)?;
            let negative = identity.quotients.into_iter().map(|(i, m, c)| (i, m, -c));
            let origin = self.combine_origins(
                &negative.collect::<Vec<_>>(),
                &identity.multiplier,
                element.origin.as_ref(),
            )?;
            // That is the origin of `scale * remainder`.
            let origin = origin.map(|mut origin| {
                origin.multiplier *= identity.scale;
                origin
            });
            (remainder, origin)
        };
        Ok(Element {
            terms: remainder,
            sugar,
            origin,
        })
    }

    /// Adds an element and the pairs that the criteria leave.
    fn update(&mut self, element: Element) {
        let h = self.elements.len();
        self.elements.push(element);
        let lead = self.leading(h).clone();
        let coprime = |m: &Monomial| m.iter().zip(lead.iter()).all(|(&a, &b)| a == 0 || b == 0);
        // Old pairs that go through the new element.
        let leads: Vec<Monomial> = (0..h).map(|i| self.leading(i).lcm(&lead)).collect();
        self.pairs
            .retain(|p| !lead.divides(&p.lcm) || leads[p.i] == p.lcm || leads[p.j] == p.lcm);
        // New pairs, of which only those with a minimal lcm are needed; coprime ones are not needed but
        // make others superfluous.
        let mut waiting: Vec<usize> = self.active.clone();
        let mut kept: Vec<usize> = Vec::new();
        while let Some(i) = waiting.pop() {
            let minimal = || {
                waiting
                    .iter()
                    .chain(&kept)
                    .all(|&k| !leads[k].divides(&leads[i]))
            };
            if coprime(self.leading(i)) || minimal() {
                kept.push(i);
            }
        }
        kept.retain(|&i| !coprime(self.leading(i)));
        kept.sort_unstable();
        for i in kept {
            let lcm = leads[i].clone();
            let excess = |k: usize| {
                let element = &self.elements[k];
                element.sugar - element.terms[0].0.total_degree()
            };
            let sugar = lcm.total_degree() + excess(i).max(excess(h));
            self.pairs.push(Pair {
                i,
                j: h,
                lcm,
                sugar,
            });
        }
        self.active
            .retain(|&i| !lead.divides(&self.elements[i].terms[0].0));
        self.active.push(h);
    }

    /// The reduced basis: the active elements, each reduced by the others.
    fn reduced(mut self) -> Result<Vec<Element>, Error> {
        let mut active = self.active.clone();
        active.sort_by(|&i, &j| self.order.compare(self.leading(i), self.leading(j)));
        for &i in &active {
            let element = Element {
                terms: self.elements[i].terms.clone(),
                sugar: self.elements[i].sugar,
                origin: self.elements[i].origin.clone(),
            };
            let mut element = self.reduce_element(element, Some(i))?;
            primitive(&mut element);
            self.elements[i] = element;
        }
        let mut slots: Vec<Option<Element>> = self.elements.into_iter().map(Some).collect();
        Ok(active
            .iter()
            .rev()
            .filter_map(|&i| slots[i].take())
            .collect())
    }
}

/// `sum of factor * origin` as one origin, cleared of common integer factors.
pub(crate) fn combine_cofactors(
    ring: Ring,
    summands: &[(Polynomial, &Origin)],
    budget: &Budget,
) -> Result<Origin, Error> {
    let multiplier = summands.iter().fold(BigInt::one(), |l, (_, o)| {
        &l / integer_gcd(&l, &o.multiplier) * &o.multiplier
    });
    let count = summands.first().map_or(0, |s| s.1.cofactors.len());
    let mut cofactors = vec![Polynomial::zero(ring); count];
    for (factor, origin) in summands {
        let factor = factor.mul_integer(&(&multiplier / &origin.multiplier));
        for (sum, cofactor) in cofactors.iter_mut().zip(&origin.cofactors) {
            if !cofactor.is_zero() {
                *sum = sum.try_add(&factor.mul_within(cofactor, budget)?)?;
            }
        }
    }
    // The contents: one true gcd, then mostly divisions; again when the element becomes primitive.
    let lengths = cofactors.iter().map(|c| c.len() as u64).sum::<u64>();
    let bits = cofactors.iter().map(Polynomial::coefficient_bits).max();
    let bits = bits.unwrap_or(0).max(multiplier.bits());
    let products = 2 * (lengths + summands.len() as u64 * GCD_PRODUCTS);
    budget.spend(Budget::products(products, bits, multiplier.bits()))?;
    let mut origin = Origin {
        multiplier,
        cofactors,
    };
    origin.cancel();
    Ok(origin)
}

impl Origin {
    /// Divides by the common integer factor of the multiplier and all the cofactors.
    pub(crate) fn cancel(&mut self) {
        let mut common = self.multiplier.clone();
        for cofactor in &self.cofactors {
            if common.is_one() {
                return;
            }
            for (_, c) in cofactor.terms() {
                common = integer_gcd(&common, &c);
                if common.is_one() {
                    break;
                }
            }
        }
        if common.is_one() || common.is_zero() {
            return;
        }
        self.multiplier = &self.multiplier / &common;
        for cofactor in &mut self.cofactors {
            *cofactor = cofactor.div_integer(&common).expect("a common factor");
        }
    }
}

/// Makes the element primitive and keeps its origin true.
fn primitive(element: &mut Element) {
    let content = make_primitive(&mut element.terms);
    if let Some(origin) = &mut element.origin {
        origin.multiplier *= content;
        if origin.multiplier < BigInt::zero() {
            origin.multiplier = -&origin.multiplier;
            for cofactor in &mut origin.cofactors {
                *cofactor = -&*cofactor;
            }
        }
        origin.cancel();
    }
}

fn degree(terms: &Terms) -> u64 {
    let degrees = terms.iter().map(|t| t.0.total_degree());
    degrees.max().unwrap_or(0)
}
