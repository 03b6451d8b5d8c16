//! Substitution, composition and change of ring.

use crate::budget::Budget;
use crate::error::Error;
use crate::polynomial::Polynomial;
use crate::powers::Powers;
use crate::ring::Ring;
use std::collections::BTreeMap;

/// The images of those variables that occur; of two images of one variable the later.
pub(crate) fn occurring<'a, T>(
    f: &Polynomial,
    images: &'a [(usize, T)],
) -> Result<BTreeMap<usize, &'a T>, Error> {
    let degrees = f.degrees();
    let mut found = BTreeMap::new();
    for (variable, image) in images {
        match degrees.get(*variable) {
            None => return Err(Error::VariableOutOfRange(*variable)),
            Some(0) => {}
            Some(_) => {
                found.insert(*variable, image);
            }
        }
    }
    Ok(found)
}

impl Polynomial {
    /// Replaces some variables, all at once, by polynomials of the same ring.
    pub fn substitute(&self, images: &[(usize, Polynomial)]) -> Result<Polynomial, Error> {
        self.substitute_within(images, &Budget::unlimited())
    }

    /// [`substitute`](Self::substitute) within a budget.
    pub fn substitute_within(
        &self,
        images: &[(usize, Polynomial)],
        budget: &Budget,
    ) -> Result<Polynomial, Error> {
        let ring = self.ring();
        if images.iter().any(|(_, image)| image.ring() != ring) {
            return Err(Error::RingMismatch);
        }
        let images = occurring(self, images)?;
        if images.is_empty() {
            return Ok(self.clone());
        }
        let variables: Vec<usize> = images.keys().copied().collect();
        let groups = self.coefficients_in_all(&variables);
        let mut tables = Vec::with_capacity(images.len());
        for (k, image) in images.values().enumerate() {
            tables.push(Powers::new(
                &groups.keys().map(|exponents| exponents[k]).collect(),
                |e| image.pow_within(e, budget),
                |a, b| a.mul_within(b, budget),
            )?);
        }
        let summands = groups.into_iter().map(|(exponents, mut value)| {
            for (&e, table) in exponents.iter().zip(&tables) {
                if e > 0 {
                    value = value.mul_within(table.get(e), budget)?;
                }
            }
            budget.spend(value.len() as u64)?;
            Ok(value)
        });
        let sum = Polynomial::sum(ring, summands)?;
        budget.check_terms(sum.len())?;
        Ok(sum)
    }

    /// The value at polynomials of a ring, one for each variable of `self`.
    pub fn compose(&self, target: Ring, images: &[Polynomial]) -> Result<Polynomial, Error> {
        self.compose_within(target, images, &Budget::unlimited())
    }

    /// [`compose`](Self::compose) within a budget.
    pub fn compose_within(
        &self,
        target: Ring,
        images: &[Polynomial],
        budget: &Budget,
    ) -> Result<Polynomial, Error> {
        let expected = self.ring().len();
        if images.len() != expected {
            return Err(Error::WrongLength {
                expected,
                found: images.len(),
            });
        }
        if images.iter().any(|image| image.ring() != target) {
            return Err(Error::RingMismatch);
        }
        let mut tables = Vec::with_capacity(images.len());
        let variables: Vec<usize> = (0..expected).collect();
        for (image, exponents) in images.iter().zip(self.exponents_of(&variables)) {
            tables.push(Powers::new(
                &exponents,
                |e| image.pow_within(e, budget),
                |a, b| a.mul_within(b, budget),
            )?);
        }
        let summands = self.terms().map(|(monomial, c)| {
            let mut value = Polynomial::constant(target, c);
            for (&e, table) in monomial.iter().zip(&tables) {
                if e > 0 {
                    value = value.mul_within(table.get(e), budget)?;
                }
            }
            budget.spend(value.len() as u64)?;
            Ok(value)
        });
        let sum = Polynomial::sum(target, summands)?;
        budget.check_terms(sum.len())?;
        Ok(sum)
    }

    /// The same polynomial in another ring: variable `i` becomes variable `map[i]` there. A variable that
    /// maps to `None` must not occur.
    pub fn map_ring(&self, target: Ring, map: &[Option<usize>]) -> Result<Polynomial, Error> {
        let expected = self.ring().len();
        if map.len() != expected {
            return Err(Error::WrongLength {
                expected,
                found: map.len(),
            });
        }
        let mut list = Vec::with_capacity(self.len());
        for (monomial, c) in self.terms() {
            let mut exponents = vec![0u32; target.len()];
            for (i, (&e, image)) in monomial.iter().zip(map).enumerate() {
                if e == 0 {
                    continue;
                }
                let image = image
                    .ok_or_else(|| Error::UnknownVariable(self.ring().variables()[i].clone()))?;
                let slot = exponents
                    .get_mut(image)
                    .ok_or(Error::VariableOutOfRange(image))?;
                *slot = slot.checked_add(e).ok_or(Error::ExponentOverflow)?;
            }
            list.push((exponents, c));
        }
        Polynomial::from_terms(target, list)
    }

    /// The same polynomial in a ring that has all the variables that occur, matched by name.
    pub fn to_ring(&self, target: Ring) -> Result<Polynomial, Error> {
        if target == self.ring() {
            return Ok(self.clone());
        }
        let map: Vec<_> = self
            .ring()
            .variables()
            .iter()
            .map(|name| target.index_of(name).ok())
            .collect();
        self.map_ring(target, &map)
    }
}
