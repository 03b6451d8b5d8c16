//! A polynomial as one in a single variable with polynomial coefficients: degrees, coefficients, derivative.

use super::{Polynomial, layout_of, packed_like};
use crate::budget::Budget;
use crate::error::{Error, Resource};
use crate::monomial::Monomial;
use crate::packed::PackedMonomial;
use crate::ring::Ring;
use crate::scalar::Scalar;
use crate::terms::{TermList, each_layout};
use std::collections::{BTreeMap, BTreeSet};

/// The greatest degree of which a dense list of coefficients is ever made.
const DENSE_DEGREE: u64 = 1 << 24;

/// Refuses a dense list of coefficients up to this degree if the budget has not so many terms.
pub(crate) fn check_dense_degree(degree: u64, budget: &Budget) -> Result<(), Error> {
    if degree > DENSE_DEGREE {
        return Err(Error::BudgetExceeded(Resource::Terms));
    }
    budget.check_terms(degree as usize + 1)
}

impl Polynomial {
    /// The degree in one variable; `None` for the zero polynomial.
    ///
    /// # Panics
    /// If the ring has no such variable.
    pub fn degree(&self, variable: usize) -> Option<u32> {
        assert!(
            variable < self.ring.len(),
            "the ring has no variable number {variable}"
        );
        let mut degree = None;
        each_layout!(&self.terms, list => {
            let layout = layout_of(list, self.ring);
            list.all_monomials(|m| {
                degree = degree.max(Some(m.exponent(layout, variable)));
                true
            })
        });
        degree
    }

    /// The degrees in all variables, zeros for the zero polynomial.
    pub fn degrees(&self) -> Vec<u32> {
        each_layout!(&self.terms, list => list.degrees(layout_of(list, self.ring)))
    }

    /// The greatest total degree of a term; `None` for the zero polynomial.
    pub fn total_degree(&self) -> Option<u64> {
        let mut degree = None;
        self.for_each_term(|exponents, _| {
            degree = degree.max(Some(exponents.iter().map(|&e| u64::from(e)).sum()));
        });
        degree
    }

    /// For each of these variables the exponents with which it occurs, zero among them.
    pub(crate) fn exponents_of(&self, variables: &[usize]) -> Vec<BTreeSet<u32>> {
        let mut sets = vec![BTreeSet::new(); variables.len()];
        self.for_each_term(|exponents, _| {
            for (set, &i) in sets.iter_mut().zip(variables) {
                set.insert(exponents[i]);
            }
        });
        sets
    }

    /// The variables that occur, ascending.
    pub fn variables_occurring(&self) -> Vec<usize> {
        self.degrees()
            .iter()
            .enumerate()
            .filter(|(_, d)| **d > 0)
            .map(|(i, _)| i)
            .collect()
    }

    /// The coefficients as a polynomial in one variable: entry `k` belongs to its `k`-th power and no
    /// longer contains it. Empty for the zero polynomial.
    ///
    /// # Panics
    /// If the ring has no such variable.
    pub fn coefficients_in(&self, variable: usize) -> Vec<Polynomial> {
        let Some(degree) = self.degree(variable) else {
            return Vec::new();
        };
        each_layout!(&self.terms, list => {
            let layout = layout_of(list, self.ring);
            let mut lists = vec![TermList::new(); degree as usize + 1];
            let mut exponents = vec![0; self.ring.len()];
            // Terms with one power keep their order when it is taken out.
            list.for_each(|m, c| {
                m.unpack(layout, &mut exponents);
                let k = std::mem::take(&mut exponents[variable]) as usize;
                lists[k].push(packed_like(m, layout, &exponents), c.to_scalar());
            });
            lists.into_iter().map(|list| self.with(list)).collect()
        })
    }

    /// [`coefficients_in`](Self::coefficients_in) for degrees that the budget allows: a term for each power.
    pub(crate) fn coefficients_in_within(
        &self,
        variable: usize,
        budget: &Budget,
    ) -> Result<Vec<Polynomial>, Error> {
        let degree = self.degree(variable).unwrap_or(0);
        check_dense_degree(degree.into(), budget)?;
        Ok(self.coefficients_in(variable))
    }

    /// The coefficients that are not zero as a polynomial in some variables, with the exponents of these.
    pub(crate) fn coefficients_in_all(
        &self,
        variables: &[usize],
    ) -> BTreeMap<Vec<u32>, Polynomial> {
        self.coefficients_by(|exponents| {
            let taken = variables.iter().map(|&i| std::mem::take(&mut exponents[i]));
            taken.collect()
        })
    }

    /// The terms by what `take` takes out of their exponents. Those by one key keep their order.
    fn coefficients_by<K: Ord>(&self, take: impl Fn(&mut [u32]) -> K) -> BTreeMap<K, Polynomial> {
        each_layout!(&self.terms, list => {
            let layout = layout_of(list, self.ring);
            let mut lists: BTreeMap<K, TermList<_>> = BTreeMap::new();
            let mut exponents = vec![0; self.ring.len()];
            list.for_each(|m, c| {
                m.unpack(layout, &mut exponents);
                let key = take(&mut exponents);
                let list = lists.entry(key).or_insert_with(TermList::new);
                list.push(packed_like(m, layout, &exponents), c.to_scalar());
            });
            lists.into_iter().map(|(key, list)| (key, self.with(list))).collect()
        })
    }

    /// The coefficients that are not zero as a polynomial in one variable, by ascending powers. Unlike a
    /// dense list these are never more than the terms.
    pub(crate) fn nonzero_coefficients_in(&self, variable: usize) -> Vec<Polynomial> {
        let by_power = self.coefficients_by(|exponents| std::mem::take(&mut exponents[variable]));
        by_power.into_values().collect()
    }

    /// The leading coefficient as a polynomial in one variable; 0 for the zero polynomial.
    pub(crate) fn leading_coefficient_in(&self, variable: usize) -> Polynomial {
        let degree = self.degree(variable);
        each_layout!(&self.terms, list => {
            let layout = layout_of(list, self.ring);
            let mut lead = TermList::new();
            let mut exponents = vec![0; self.ring.len()];
            list.for_each(|m, c| {
                m.unpack(layout, &mut exponents);
                if Some(std::mem::take(&mut exponents[variable])) == degree {
                    lead.push(packed_like(m, layout, &exponents), c.to_scalar());
                }
            });
            self.with(lead)
        })
    }

    /// The sum of `coefficients[k]` times the `k`-th power of a variable.
    pub fn from_coefficients_in(
        ring: Ring,
        variable: usize,
        coefficients: &[Polynomial],
    ) -> Result<Polynomial, Error> {
        if variable >= ring.len() {
            return Err(Error::VariableOutOfRange(variable));
        }
        let mut list = Vec::new();
        for (k, polynomial) in coefficients.iter().enumerate() {
            if polynomial.ring != ring {
                return Err(Error::RingMismatch);
            }
            let k = u32::try_from(k).map_err(|_| Error::ExponentOverflow)?;
            let mut overflow = false;
            polynomial.for_each_term(|exponents, c| {
                let mut exponents = exponents.to_vec();
                match exponents[variable].checked_add(k) {
                    Some(e) => exponents[variable] = e,
                    None => overflow = true,
                }
                list.push((Monomial::new(exponents), c.to_scalar()));
            });
            if overflow {
                return Err(Error::ExponentOverflow);
            }
        }
        Ok(Polynomial::from_list(ring, list))
    }

    /// The derivative with respect to one variable.
    ///
    /// # Panics
    /// If the ring has no such variable.
    pub fn derivative(&self, variable: usize) -> Polynomial {
        assert!(
            variable < self.ring.len(),
            "the ring has no variable number {variable}"
        );
        let mut step = vec![0; self.ring.len()];
        step[variable] = 1;
        each_layout!(&self.terms, list => {
            let layout = layout_of(list, self.ring);
            let mut derivative = TermList::new();
            list.for_each(|m, c| {
                let step = packed_like(m, layout, &step);
                if let Some(quotient) = m.quotient(&step, layout) {
                    let e = Scalar::Small(m.exponent(layout, variable).into());
                    derivative.push(quotient, e.times(c));
                }
            });
            self.with(derivative)
        })
    }
}
