//! How well the units of an equation fit in each of its readings.
//!
//! The units that the other equations teach are found out once: only what stands from the equation on
//! is asked anew for each reading, and no reading twice.

use super::Checker;
use crate::expr::Display;
use crate::unit::Units;
use std::cell::RefCell;

/// What is known of the readings of one equation.
pub(crate) struct Readings {
    equation: usize,
    /// The corrections of the other equations.
    others: Vec<(usize, Display)>,
    /// What the equations before it teach.
    before: Units,
    misfits: Vec<(Display, usize)>,
}

/// The readings of the equation that was asked for last.
pub(crate) type KnownReadings = RefCell<Option<Readings>>;

impl Checker<'_> {
    /// Those of some readings of an equation whose units fit in the most places, in their order.
    pub(super) fn fitting_units_best<T>(
        &self,
        equation: usize,
        mut readings: Vec<T>,
        display: impl Fn(&T) -> &Display,
    ) -> Vec<T> {
        if readings.len() > 1 {
            let misfits: Vec<usize> = readings
                .iter()
                .map(|reading| self.unit_misfits(equation, display(reading)))
                .collect();
            let fewest = misfits.iter().min().copied();
            let mut misfits = misfits.into_iter();
            readings.retain(|_| misfits.next() == fewest);
        }
        readings
    }

    /// In how many places of a corrected equation the units do not fit, and whether there are none or no
    /// more than in print.
    pub(super) fn fits_units(
        &self,
        equation: usize,
        printed: &Display,
        corrected: &Display,
    ) -> (usize, bool) {
        let left = self.unit_misfits(equation, corrected);
        (
            left,
            left == 0 || left <= self.unit_misfits(equation, printed),
        )
    }

    /// In how many places the units of an equation do not fit if it reads so.
    fn unit_misfits(&self, equation: usize, display: &Display) -> usize {
        let label = |e: usize| &self.model.equations[e].label[..];
        let corrections = self.exact.world().corrections();
        let others: Vec<_> = corrections.filter(|(e, _)| *e != equation).collect();
        let mut known = self.readings.borrow_mut();
        let same = |r: &Readings| {
            r.equation == equation
                && r.others.len() == others.len()
                && r.others
                    .iter()
                    .zip(&others)
                    .all(|((e, d), other)| (*e, d) == *other)
        };
        if !known.as_ref().is_some_and(same) {
            let mut before = Units::of(self.model);
            for e in 0..equation {
                before.check(label(e), self.exact.display(e));
            }
            *known = Some(Readings {
                equation,
                others: others.iter().map(|(e, d)| (*e, (*d).clone())).collect(),
                before,
                misfits: Vec::new(),
            });
        }
        let Some(readings) = known.as_mut() else {
            return 0;
        };
        if let Some((_, misfits)) = readings.misfits.iter().find(|(d, _)| d == display) {
            return *misfits;
        }
        let others = |e: usize| (label(e), self.exact.display(e));
        let before = (0..equation).map(others);
        let after = (equation + 1..self.model.equations.len()).map(others);
        let one = (label(equation), display);
        let misfits = readings.before.clone().check_one_of(before, one, after);
        let misfits = misfits.len();
        readings.misfits.push((display.clone(), misfits));
        misfits
    }
}
