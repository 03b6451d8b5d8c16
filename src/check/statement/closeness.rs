//! Comparisons at the reference point: the same, nearly the same, much smaller; and of units.

use super::{Found, Ground};
use crate::document::VerdictWord;
use crate::model::statement::Proposition;
use crate::unit::Units;
use crate::verdict::statement::{Fact, Measure, Scope, Sign, Subject};
use num_rational::BigRational;
use num_traits::{One, Signed, Zero};
use ratpoly::RationalFunction;

/// Whether a quantity has the unit of another.
pub(super) fn measured_like(p: &Proposition, units: &mut Units) -> Found {
    let (Some(to), own) = (&p.to, units.unit_of_expression(&p.of)) else {
        return Found::undecided("nothing says like what");
    };
    match (own, units.unit_of_expression(to)) {
        (Some(own), Some(other)) => {
            let word = if own == other {
                VerdictWord::Holds
            } else {
                VerdictWord::Refuted
            };
            Found::of(word, vec![Fact::Units(own, other)])
        }
        _ => Found::undecided("a unit is not known, or terms of different units are added"),
    }
}

impl Ground {
    pub(super) fn equals(&self, f: &RationalFunction, to: Option<&RationalFunction>) -> Found {
        let Some(to) = to else {
            return Found::undecided("nothing says to what");
        };
        if self.has_no_value(f) || self.has_no_value(to) {
            return self.without_value(&[f, to]);
        }
        let difference = f - to;
        if difference.is_zero() {
            let fact = Fact::Sign(Subject::Difference, Sign::Zero, Scope::Everywhere);
            return Found::of(VerdictWord::Holds, vec![fact]);
        }
        match (self.at(&difference), self.at(f)) {
            (Some(zero), Some(value)) if zero.is_zero() => Found::of(
                VerdictWord::Holds,
                vec![
                    Fact::Number(Measure::Value, value.into()),
                    Fact::About(Scope::Reference),
                ],
            ),
            (Some(value), _) => {
                let mut facts: Vec<Fact> = self
                    .ratio(f, to)
                    .map(|q| deviation(&q))
                    .into_iter()
                    .collect();
                facts.push(Fact::Witness {
                    subject: Subject::Difference,
                    point: self.point_of(&difference),
                    value,
                });
                facts.push(Fact::About(Scope::Reference));
                Found::of(VerdictWord::Refuted, facts)
            }
            (None, _) if self.vanishes_here(f) && self.vanishes_here(to) => Found::of(
                VerdictWord::Holds,
                vec![
                    Fact::Number(Measure::Value, BigRational::zero().into()),
                    Fact::About(Scope::Reference),
                ],
            ),
            // Letters without a value may cancel in the quotient.
            (None, _) => match self.ratio(f, to).filter(|q| !q.is_one()) {
                Some(ratio) => Found::of(VerdictWord::Refuted, vec![deviation(&ratio)]),
                None => Found::undecided("there are no reference values"),
            },
        }
    }

    /// The quotient at the reference point; letters without a value may cancel.
    fn ratio(&self, f: &RationalFunction, to: &RationalFunction) -> Option<BigRational> {
        self.at(&f.checked_div(to).ok()?)
    }

    pub(super) fn close(
        &self,
        f: &RationalFunction,
        to: Option<&RationalFunction>,
        p: &Proposition,
    ) -> Found {
        let one = RationalFunction::constant(self.ring, BigRational::one());
        self.within(f, to, p, Measure::Deviation, |ratio| ratio - one)
    }

    pub(super) fn small(
        &self,
        f: &RationalFunction,
        to: Option<&RationalFunction>,
        p: &Proposition,
    ) -> Found {
        self.within(f, to, p, Measure::Ratio, |ratio| ratio)
    }

    /// Whether a number that is made of a quotient is no larger than the tolerance, at the reference point
    /// or, where the statement is about its box, everywhere in there.
    fn within(
        &self,
        f: &RationalFunction,
        to: Option<&RationalFunction>,
        p: &Proposition,
        measure: Measure,
        of: impl FnOnce(RationalFunction) -> RationalFunction,
    ) -> Found {
        let Some(to) = to else {
            return Found::undecided("nothing says to what");
        };
        let Ok(ratio) = f.checked_div(to) else {
            return Found::undecided("it is compared with zero");
        };
        if self.has_no_value(f) || self.has_no_value(to) {
            return self.without_value(&[f, to]);
        }
        if self.vanishes_here(to) {
            return Found::undecided("at the reference values it is compared with zero");
        }
        let scope = p.only_in_box.then(|| self.box_of(p)).flatten();
        if let Some(scope) = &scope
            && self.cancels_a_pole(&ratio, [f, to], scope)
        {
            return Found::undecided("somewhere in the box it may have no value");
        }
        let f = of(ratio);
        let Some(value) = self.at(&f) else {
            return self.without_value(&[&f]);
        };
        let at_reference = value.abs() <= p.tolerance;
        let fact = Fact::Number(measure.clone(), value.into());
        let Some(scope) = scope else {
            let about = Fact::About(Scope::Reference);
            return Found::of(decided(at_reference), vec![fact, about]);
        };
        let Some((low, high)) = self.range(&f, &scope) else {
            return Found::undecided("its range over the box is out of reach");
        };
        let inside = low.compare_rational(&-&p.tolerance).is_ge()
            && high.compare_rational(&p.tolerance).is_le();
        let word = match (inside, at_reference) {
            (true, _) => VerdictWord::Holds,
            (false, true) => VerdictWord::Loose,
            (false, false) => VerdictWord::Refuted,
        };
        let range = Fact::Range {
            measure,
            low,
            high,
            scope,
        };
        Found::of(word, vec![range, fact])
    }
}

fn decided(true_: bool) -> VerdictWord {
    if true_ {
        VerdictWord::Holds
    } else {
        VerdictWord::Refuted
    }
}

fn deviation(ratio: &BigRational) -> Fact {
    Fact::Number(Measure::Deviation, (ratio - BigRational::one()).into())
}
