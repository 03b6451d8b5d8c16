//! Poles of A and of B that `A + B cos(kx)` does not have, for one k or several.
//!
//! For k >= 0 the integrals over the half axis of (1 - cos kx)/x^2 and, as principal values, of 1/(p^2 - x^2) and
//! cos(kx)/(p^2 - x^2) are pi k/2, zero and pi sin(kp)/(2p) (Gradshteyn & Ryzhik, 3.782 and 3.723). Where the poles
//! cancel, the principal values of the parts make the integral of the whole.

use super::integral::{Spectrum, is_even};
use super::{FunctionTable, Impossible, Possible};
use ratpoly::{Budget, RationalFunction};

/// `A + B cos(kx)` without its removable poles.
pub(super) struct Regular {
    /// A without them.
    pub rest: RationalFunction,
    /// Each B without them.
    pub spectra: Vec<Spectrum>,
    /// What was taken out, integrated over the half axis, by pi.
    pub value: RationalFunction,
}

impl FunctionTable {
    /// Takes the removable poles on the axis out of all parts.
    ///
    /// # Errors
    /// Where a pole is not known to be removable.
    pub(super) fn without_removable_poles(
        &self,
        rest: &RationalFunction,
        spectra: &[Spectrum],
        variable: usize,
    ) -> Possible<Regular> {
        let mut regular = Regular {
            rest: rest.clone(),
            spectra: spectra.to_vec(),
            value: self.integer(0),
        };
        let parts = || spectra.iter().map(|s| &s.spectrum).chain([rest]);
        if !parts().all(|f| is_even(f, variable)) {
            return Ok(regular);
        }
        let x = self.variable(variable);
        let square = self.reduce(&x * &x);
        let pole_at_zero = |f: &RationalFunction| {
            let below = f.denominator().coefficients_in(variable);
            below.first().is_some_and(|c| c.is_zero())
        };
        if parts().any(pole_at_zero) {
            let zero = self.integer(0);
            let mut left = self.take_out(&mut regular.rest, &square, &zero, variable)?;
            for one in &mut regular.spectra {
                let part = &mut one.spectrum;
                let beta = self.take_out(part, &square, &zero, variable)?;
                let time = self.absolute(&one.frequency)?;
                let half = (&beta * &time).checked_div(&self.integer(2))?;
                regular.value = &regular.value - &half;
                left = &left + &beta;
            }
            self.nothing_left(left)?;
        }
        let mut squares: Vec<RationalFunction> = Vec::new();
        for f in parts() {
            for (factor, _) in f.denominator().factor_within(&Budget::default())?.factors {
                let found = self.square_of_pole(&factor, variable);
                squares.extend(found.filter(|s| !squares.contains(s)));
            }
        }
        for pole in squares {
            let place = self.square_root(&pole)?;
            let below = &pole - &square;
            let mut left = self.take_out(&mut regular.rest, &below, &pole, variable)?;
            for one in &mut regular.spectra {
                let part = &mut one.spectrum;
                let beta = self.take_out(part, &below, &pole, variable)?;
                let time = self.absolute(&one.frequency)?;
                let (cosine, sine) = self.cosine_and_sine(&(&time * &place))?;
                let value = (&beta * &sine).checked_div(&(&self.integer(2) * &place))?;
                regular.value = &regular.value + &value;
                left = &left + &(&beta * &cosine);
            }
            self.nothing_left(left)?;
        }
        regular.value = self.reduce(regular.value);
        Ok(regular)
    }

    /// Takes `c / below` out of a part, where c is the value of the part times `below` at a square of the variable.
    fn take_out(
        &self,
        part: &mut RationalFunction,
        below: &RationalFunction,
        square: &RationalFunction,
        variable: usize,
    ) -> Possible<RationalFunction> {
        let whole = below * &*part;
        let above = self.at_square(whole.numerator(), variable, square)?;
        let beside = self.at_square(whole.denominator(), variable, square)?;
        let (Some(above), Some(beside)) = (above, beside.filter(|b| !b.is_zero())) else {
            return Err(over_pole());
        };
        let residue = self.reduce(above.checked_div(&beside)?);
        *part = self.reduce(&*part - &residue.checked_div(below)?);
        Ok(residue)
    }

    /// That the poles of all parts together cancel.
    fn nothing_left(&self, left: RationalFunction) -> Possible<()> {
        match self.reduce(left).is_zero() {
            true => Ok(()),
            false => Err(over_pole()),
        }
    }
}

fn over_pole() -> Impossible {
    Impossible::unsupported("an integral over a pole")
}
