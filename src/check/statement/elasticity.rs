//! Elasticities: the relative change of a quantity for a relative change of a letter, and the
//! statements that are decided by signs of derivatives or by the size of an elasticity.

use super::{Found, Ground};
use crate::document::VerdictWord;
use crate::model::range::Numbers;
use crate::model::statement::Proposition;
use crate::theory::algebraic::Algebraic;
use crate::verdict::statement::{Fact, Measure, Scope, Sign, Subject};
use num_rational::BigRational;
use num_traits::{One, Signed, Zero};
use ratpoly::{Budget, RationalFunction};

impl Ground {
    /// `x f'(x) / f(x)`.
    pub(super) fn elasticity(&self, f: &RationalFunction, x: usize) -> Option<RationalFunction> {
        let derivative = f.derivative(x).ok()?;
        (RationalFunction::variable(self.ring, x) * derivative)
            .checked_div(f)
            .ok()
    }

    /// The elasticity at the reference point. Where the quantity is zero there it has none, though what
    /// vanishes may have cancelled before.
    pub(super) fn elasticity_here(&self, f: &RationalFunction, x: usize) -> Option<BigRational> {
        if self.vanishes_here(f) {
            return None;
        }
        self.at(&self.elasticity(f, x)?)
    }

    /// The elasticity at the reference point and its range over the box, and what the box's least
    /// value of the letter alone does.
    pub(super) fn elasticity_facts(
        &self,
        f: &RationalFunction,
        x: usize,
        p: &Proposition,
    ) -> Vec<Fact> {
        let mut facts = Vec::new();
        let Some(elasticity) = self.elasticity(f, x).filter(|_| !self.vanishes_here(f)) else {
            return facts;
        };
        if let Some(value) = self.at(&elasticity) {
            facts.push(Fact::Number(Measure::Elasticity(x), value.into()));
        }
        let Some(scope) = self.box_of(p) else {
            return facts;
        };
        if let Some((low, high)) = self.range(&elasticity, &scope) {
            facts.push(Fact::Range {
                measure: Measure::Elasticity(x),
                low,
                high,
                scope,
            });
        }
        if self.sides(p).iter().any(|(letter, ..)| *letter == x) {
            facts.extend(self.factor(f, x, &p.times.0));
        }
        facts
    }

    /// By what the quantity is multiplied when the letter's reference value is.
    fn factor(&self, f: &RationalFunction, x: usize, times: &BigRational) -> Option<Fact> {
        let mut point = self.reference.clone();
        point[x] = Some(point[x].clone()? * times);
        let before = self.at(f).filter(|v| !v.is_zero())?;
        // A letter without a value may cancel.
        let after = self.at_point(f, &point)?;
        Some(Fact::Number(
            Measure::Factor(x, times.clone()),
            (after / before).into(),
        ))
    }

    pub(super) fn monotone(
        &self,
        f: &RationalFunction,
        x: usize,
        increasing: bool,
        p: &Proposition,
    ) -> Found {
        let Ok(derivative) = f.derivative(x) else {
            return Found::undecided("the derivative is out of reach");
        };
        let mut found = self
            .strict(&derivative, increasing, Subject::Derivative(x), Some(x), p)
            .and(self.elasticity_facts(f, x, p));
        // Between two integers a derivative may have any sign.
        if self.range_of(x).numbers != Numbers::Real && found.word != VerdictWord::Holds {
            return Found::undecided(
                "of a letter that is not real only derivatives of one sign tell",
            );
        }
        // Across a pole it does not go on as the derivative says; in a box the points may lie outside of it.
        if found.word == VerdictWord::Undecided
            && !p.only_in_box
            && let Some(points) = self.against(f, x, increasing)
        {
            let here = self.at(&derivative);
            let right = here.is_some_and(|v| match increasing {
                true => v.is_positive(),
                false => v.is_negative(),
            });
            found.word = match right {
                true => VerdictWord::Loose,
                false => VerdictWord::Refuted,
            };
            found.reason = None;
            for (point, value) in points {
                found.facts.push(Fact::Witness {
                    subject: Subject::Quantity,
                    point,
                    value,
                });
            }
        }
        // It turns so near to the reference value that this is as good as an extremum.
        let one = BigRational::one();
        let (low, high) = (&one - &p.tolerance, &one + &p.tolerance);
        let turns = |fact: &Fact| match fact {
            Fact::Number(Measure::Threshold(_), at) => {
                at.compare_rational(&low).is_ge() && at.compare_rational(&high).is_le()
            }
            _ => false,
        };
        if found.word == VerdictWord::Refuted && found.facts.iter().any(turns) {
            found.word = VerdictWord::Loose;
            found.facts.sort_by_key(|fact| !turns(fact));
            found = found.nearly();
        }
        found
    }

    /// Two points on one line in a letter, on both sides of a pole, at which the quantity goes against
    /// what is said.
    fn against(
        &self,
        f: &RationalFunction,
        x: usize,
        increasing: bool,
    ) -> Option<[(Vec<(usize, BigRational)>, BigRational); 2]> {
        let line = self.restricted(f, &[x])?;
        let poles = Algebraic::roots(line.denominator(), x, &Budget::default()).ok()?;
        for pole in poles {
            let mut width = BigRational::one();
            for _ in 0..8 {
                let (low, high) = pole.enclosure(&width).ok()?;
                let pair = [low - &width, high + &width];
                let values = pair.clone().map(|at| {
                    let mut point = self.reference.clone();
                    point[x] = Some(at);
                    let value = self.at_point(&line, &point)?;
                    let others = self.letters_in(f).into_iter();
                    let shown = others.map(|l| Some((l, point[l].clone()?)));
                    Some((shown.collect::<Option<Vec<_>>>()?, value))
                });
                if let [Some(left), Some(right)] = values
                    && pair.iter().all(|at| self.may_be(x, at))
                    && match increasing {
                        true => left.1 >= right.1,
                        false => left.1 <= right.1,
                    }
                {
                    return Some([left, right]);
                }
                width /= num_bigint::BigInt::from(16);
            }
        }
        None
    }

    pub(super) fn convex(&self, f: &RationalFunction, x: usize, p: &Proposition) -> Found {
        match f.derivative(x).and_then(|g| g.derivative(x)) {
            Ok(_) if self.range_of(x).numbers != Numbers::Real => {
                Found::undecided("a letter that is not real")
            }
            Ok(second) => self.strict(&second, true, Subject::SecondDerivative(x), Some(x), p),
            Err(_) => Found::undecided("the derivative is out of reach"),
        }
    }

    /// Both signs of the derivative occur: along the letter at the reference values of the others
    /// (holds), or only elsewhere (loose).
    pub(super) fn not_monotone(&self, f: &RationalFunction, x: usize, p: &Proposition) -> Found {
        let Ok(derivative) = f.derivative(x) else {
            return Found::undecided("the derivative is out of reach");
        };
        let subject = Subject::Derivative(x);
        if self.range_of(x).numbers != Numbers::Real {
            return Found::undecided("a letter that is not real");
        }
        let facts = self.elasticity_facts(f, x, p);
        if p.only_in_box {
            let scope = Scope::Box(self.sides(p));
            let study = self.sign(&derivative, &scope);
            let word = match study.sign {
                _ if !study.poles.is_empty() => {
                    return Found::undecided("it has a pole where it is meant").and(facts);
                }
                Some(Sign::Both) => VerdictWord::Holds,
                Some(_) => VerdictWord::Refuted,
                None => return Found::undecided("the sign of the derivative is out of reach"),
            };
            let sign = study.sign.map(|sign| Fact::Sign(subject, sign, scope));
            let mut found = Found::of(word, sign.into_iter().collect());
            found.signs.extend(study.certificate);
            return found.and(facts);
        }
        let line = self.sign(&derivative, &Scope::Line(x));
        if line.sign == Some(Sign::Both) {
            let fact = Fact::Sign(subject, Sign::Both, Scope::Line(x));
            return Found::of(VerdictWord::Holds, vec![fact])
                .and(self.extremum_facts(f, x, false))
                .and(facts);
        }
        let study = self.sign(&derivative, &Scope::Everywhere);
        // Beside a pole a derivative of one sign is not enough for being monotone.
        let poles: Vec<_> = study.poles.iter().chain(&line.poles).cloned().collect();
        if !poles.is_empty() {
            return Found::undecided("it has a pole where it is meant").and([Fact::Pole(poles)]);
        }
        let word = match (study.sign, line.sign) {
            (Some(Sign::Both), Some(_)) => VerdictWord::Loose,
            (Some(Sign::Both), None) => {
                return Found::undecided("there are no reference values").and(facts);
            }
            (Some(_), _) | (None, Some(_)) => VerdictWord::Refuted,
            (None, None) => return Found::undecided("the sign of the derivative is out of reach"),
        };
        let mut found = Found::of(word, Vec::new());
        let sign = study.sign;
        found.add_study(subject, study);
        if let (None | Some(Sign::Both), Some(sign)) = (sign, line.sign) {
            found.facts.push(Fact::Sign(subject, sign, Scope::Line(x)));
            found.signs.extend(line.certificate);
        }
        found.and(facts)
    }

    pub(super) fn independent(&self, f: &RationalFunction, x: usize, p: &Proposition) -> Found {
        let Ok(derivative) = f.derivative(x) else {
            return Found::undecided("the derivative is out of reach");
        };
        let subject = Subject::Derivative(x);
        if derivative.is_zero() {
            let fact = Fact::Sign(subject, Sign::Zero, Scope::Everywhere);
            return Found::of(VerdictWord::Holds, vec![fact]);
        }
        let word = match self.elasticity_here(f, x) {
            Some(value) if value.abs() <= p.tolerance => VerdictWord::Loose,
            // What is the same there whatever the letter is, though it has no elasticity.
            None if self.vanishes_on_lines(&derivative, &[x]) => VerdictWord::Loose,
            Some(_) | None => VerdictWord::Refuted,
        };
        let mut found = Found::of(word, self.elasticity_facts(f, x, p));
        // That it does depend on the letter is shown by one value of the derivative.
        if let Some(value) = self.at(&derivative).filter(|v| !v.is_zero()) {
            found.facts.push(Fact::Witness {
                subject,
                point: self.point_of(&derivative),
                value,
            });
        }
        found.add_study(subject, self.sign(&derivative, &Scope::Everywhere));
        found.and(self.extremum_facts(f, x, false)).nearly()
    }

    pub(super) fn essential(&self, f: &RationalFunction, x: usize, p: &Proposition) -> Found {
        let Some(elasticity) = self.elasticity(f, x) else {
            return Found::undecided("the derivative is out of reach");
        };
        if self.has_no_value(f) {
            return self.without_value(&[f]);
        }
        if self.vanishes_here(f) {
            return Found::undecided(
                "the elasticity has no value at the reference values, where the quantity is zero",
            );
        }
        let Some(value) = self.at(&elasticity) else {
            return self.without_value(&[&elasticity]);
        };
        let word = if value.abs() > p.tolerance {
            VerdictWord::Holds
        } else {
            VerdictWord::Refuted
        };
        Found::of(word, self.elasticity_facts(f, x, p)).and([Fact::About(Scope::Reference)])
    }
}
