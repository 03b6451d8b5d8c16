//! Tables of the powers that occur, and of no others: `x^4000000000` costs 32 squarings.

use std::collections::BTreeSet;

/// The powers of one base for a set of exponents.
pub(crate) struct Powers<T> {
    exponents: Vec<u32>,
    values: Vec<T>,
}

impl<T> Powers<T> {
    /// Each power is the one before times the power of the difference; `power` is asked for the
    /// differences and `product` multiplies.
    pub fn new<E>(
        exponents: &BTreeSet<u32>,
        mut power: impl FnMut(u32) -> Result<T, E>,
        mut product: impl FnMut(&T, &T) -> Result<T, E>,
    ) -> Result<Self, E> {
        let mut values: Vec<T> = Vec::with_capacity(exponents.len());
        let mut step: Option<(u32, T)> = None;
        let mut last = 0;
        for &e in exponents {
            // Mostly the difference is that of the time before: 1.
            if step.as_ref().is_none_or(|(gap, _)| *gap != e - last) {
                step = Some((e - last, power(e - last)?));
            }
            let (_, factor) = step.as_ref().expect("set above");
            values.push(match values.last() {
                Some(before) => product(before, factor)?,
                None => power(e)?,
            });
            last = e;
        }
        Ok(Powers {
            exponents: exponents.iter().copied().collect(),
            values,
        })
    }

    /// Multiplies each power by a factor.
    pub fn scale<'a>(&mut self, factor: impl Fn(u32) -> &'a T)
    where
        T: for<'b> std::ops::MulAssign<&'b T> + 'a,
    {
        for (value, &e) in self.values.iter_mut().zip(&self.exponents) {
            *value *= factor(e);
        }
    }

    /// A power that is in the table.
    pub fn get(&self, exponent: u32) -> &T {
        let place = self.exponents.binary_search(&exponent);
        &self.values[place.expect("the table was made for the exponents that occur")]
    }
}
