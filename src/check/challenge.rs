//! Verdicts challenged at admissible points, by a route that shares nothing with the exact engine.
//!
//! What is proved true is evaluated by certified enclosures of what is printed; where these are apart
//! the program contradicts itself, and nothing is said of the equation. What the exact engine finds
//! different is false where the enclosures say so too: at the engine's own point, or at another one.

use super::Checker;
use super::identity::Decision;
use super::sides::CASE;
use crate::enclose::{Budget, Challenge, Comparison, Point, Points, Shown, World, challenge};
use crate::expr::walk::visit;
use crate::expr::{Display, ExprKind, Relation};
use crate::model::links::Link;
use crate::model::{Hypothesis, Letter};
use crate::real::{Complex, Real};
use crate::verdict::{Contradiction, Part, PointValue, Refutation, Verdict, Witness};
use num_traits::Zero;

/// Binary digits with which the exact engine's own points are looked at.
const BITS: [u32; 3] = [128, 512, 2048];
/// At how many points an inequality is looked at.
const INEQUALITY_POINTS: usize = 40;
/// How many values of the letters that a point leaves open are looked at.
const COMPLETIONS: usize = 12;
/// Multiplications at one point.
const WORK: u64 = 300_000;

/// What a second route finds at a point.
#[derive(Debug)]
enum There {
    /// The sides are apart.
    Apart(Box<Shown>),
    /// They are the same, to many digits.
    Together,
    /// A side certainly has no value: the point shows nothing.
    NoValue,
    /// Nothing is known.
    Unknown,
}

impl<'m> Checker<'m> {
    /// The document as the second route sees it, with displays in place of some equations'.
    fn world<'d>(&self, changed: impl IntoIterator<Item = (usize, &'d Display)>) -> World<'m> {
        let corrected = self.exact.world().corrections();
        let displays = corrected
            .map(|(e, d)| (e, d.clone()))
            .chain(changed.into_iter().map(|(e, d)| (e, d.clone())));
        World::new(self.model, self.instance, displays.collect())
    }

    /// What is proved of a link, unless a second route finds its sides apart at a point.
    pub(super) fn challenged(&mut self, equation: usize, link: &Link, verdict: Verdict) -> Verdict {
        let printed = &self.model.equations[equation];
        let (given, corrections): (&[Hypothesis], _) = match &verdict {
            Verdict::Holds { .. } => (&[], Vec::new()),
            // What the definitions imply is true at every point.
            Verdict::HoldsGiven(given, _) if !given.implied_by.is_empty() => (&[], Vec::new()),
            Verdict::HoldsGiven(..) if !printed.given.is_empty() => (&printed.given, Vec::new()),
            Verdict::Misprint { correction, .. } if correction.given.is_none() => {
                let mut displays = vec![(equation, &correction.display)];
                displays.extend(
                    correction
                        .definition
                        .as_ref()
                        .map(|(d, display)| (*d, display)),
                );
                (&[], displays)
            }
            Verdict::HoldsGiven(..)
            | Verdict::Misprint { .. }
            | Verdict::Refuted(_)
            | Verdict::Undecided { .. }
            | Verdict::Definition { .. }
            | Verdict::Recalled { .. } => return verdict,
        };
        let world = self.world(corrections);
        let hypotheses = printed.assume.iter().chain(given);
        if self.misses_rates(equation, link) {
            return verdict;
        }
        let found = challenge(&world, equation, link, hypotheses, &Budget::default());
        let Some(shown) = found.apart else {
            if found.evaluated == 0 && found.undefined > 0 {
                return Verdict::Undecided {
                    reason: "at none of the admissible points looked at both sides have a value"
                        .into(),
                };
            }
            return verdict;
        };
        if shown.can_be_written() {
            let witness = self.witness_of(&shown);
            self.contradiction = Some(Contradiction::Challenge(Box::new(witness)));
        }
        Verdict::Undecided {
            reason: "what was found to prove it is contradicted at a point".into(),
        }
    }

    /// What becomes of a link whose sides are different formulas: false where certified enclosures
    /// are apart at an admissible point.
    pub(super) fn shown_false(
        &mut self,
        equation: usize,
        link: &Link,
        decision: Decision,
    ) -> Result<Refutation, String> {
        let found = self.points_apart(equation, link, &[]);
        match decision {
            Decision::Refuted(refutation) => {
                // A point of one case may be none at which that case is taken.
                let in_a_case = refutation
                    .witness()
                    .is_some_and(|w| w.indices.iter().any(|(name, _)| name == CASE));
                if let (true, Some(shown)) = (in_a_case, &found.apart) {
                    let shown = Refutation::at(self.witness_of(shown));
                    return Ok(shown.with_residual(refutation.residual));
                }
                // A second route that knows values elsewhere must find those of this point apart.
                let disagree = "two routes disagree on whether its sides are apart";
                let own = match (&found.apart, refutation.witness()) {
                    (_, Some(w)) if w.point.iter().any(|(l, _)| self.is_no_choice(*l)) => {
                        return Err(disagree.into());
                    }
                    // In a case the sides differ as formulas; whether a point of it shows that is open.
                    (None, Some(_)) if in_a_case && found.evaluated > 0 => {
                        return Err(
                            "the sides differ as formulas in a case of a definition, and no \
                             admissible point of that case was found at which they are apart"
                                .into(),
                        );
                    }
                    (_, Some(witness)) => self.at_witness(equation, link, witness),
                    (_, None) => There::Unknown,
                };
                match (own, &found.apart) {
                    (There::NoValue | There::Together, Some(shown)) => {
                        let shown = Refutation::at(self.witness_of(shown));
                        Ok(shown.with_residual(refutation.residual))
                    }
                    (There::NoValue, None) => {
                        Err("at the point at which the formulas differ a side has no value".into())
                    }
                    (There::Together, None) => Err(disagree.into()),
                    (There::Apart(_) | There::Unknown, _) => Ok(refutation),
                }
            }
            Decision::False(open, _) => match found.apart {
                Some(shown) => Ok(Refutation::at(self.witness_of(&shown)).with_residual(open)),
                None => Err(
                    "the sides differ as formulas, and no admissible point was found at which \
                     their values are apart"
                        .into(),
                ),
            },
            Decision::Holds(_) | Decision::Follows(..) | Decision::HoldsGiven(..) => {
                Err("it was not refuted".into())
            }
        }
    }

    /// A refutation of what is no equation by a point that a second route confirms. A point that gives
    /// a value to a letter that stands for a function is none.
    pub(super) fn confirmed(
        &mut self,
        equation: usize,
        link: &Link,
        refutation: Refutation,
    ) -> Result<Refutation, String> {
        let Some(witness) = refutation.witness() else {
            return Ok(refutation);
        };
        if self.is_inequality_of_moments(equation, link) {
            return Err(
                "no point is known at which the covariances exist and it is violated".into(),
            );
        }
        let free = witness.point.iter().all(|(l, _)| !self.is_no_choice(*l));
        let own = match free {
            true => self.at_witness(equation, link, witness),
            false => There::Together,
        };
        match own {
            // The engine compares the difference with zero; what was printed are the sides.
            There::Apart(shown) if shown.matrix.is_none() && shown.can_be_written() => {
                let sides = self.witness_of(&shown);
                let point = witness.point.clone();
                let mut found = Refutation::at(Witness { point, ..sides });
                found.searched = refutation.searched;
                found.residual = refutation.residual;
                found.part = refutation.part;
                return Ok(self.without_idle_part(equation, link, found));
            }
            There::Apart(_) | There::Unknown => {
                return Ok(self.without_idle_part(equation, link, refutation));
            }
            There::Together | There::NoValue => {}
        }
        match self.violated(equation, link) {
            Some(mut found) => {
                found.residual.clone_from(&refutation.residual);
                Ok(found)
            }
            None => Err("no admissible point was found at which it is violated".into()),
        }
    }

    /// Where an inequality is said to be true its sides have values: a function may be defined on a range only.
    fn without_idle_part(
        &self,
        equation: usize,
        link: &Link,
        mut refutation: Refutation,
    ) -> Refutation {
        if let (Some(Part::Around(around)), Some(witness)) =
            (&refutation.part, refutation.witness())
        {
            let point = around
                .iter()
                .map(|(l, v)| (*l, PointValue::Exact(v.clone())));
            let there = Witness {
                point: point.collect(),
                ..witness.clone()
            };
            if self.has_no_value_at(equation, link, &there) {
                refutation.part = None;
            }
        }
        refutation
    }

    /// A point at which a link that could not be decided is violated.
    pub(super) fn violated(&mut self, equation: usize, link: &Link) -> Option<Refutation> {
        if self.is_inequality_of_moments(equation, link) {
            return None;
        }
        let stated: &'m [Hypothesis] = &self.model.equations[equation].given;
        let all: Vec<&'m Hypothesis> = stated.iter().collect();
        // No point is shown by what is stated and holds nowhere.
        if self.breaks_reference(&all) && self.suppose(&all).is_err() {
            return None;
        }
        let shown = self.points_apart(equation, link, stated).apart?;
        Some(Refutation::at(self.witness_of(&shown)))
    }

    /// Whether moments are compared: at a point they have values only where the matrix that stands for
    /// a covariance is one, and the points do not see to that.
    fn is_inequality_of_moments(&self, equation: usize, link: &Link) -> bool {
        let display = self.exact.display(equation);
        let mut moments = false;
        for side in [link.left, link.right]
            .iter()
            .filter_map(|p| p.find(display))
        {
            visit(side, &mut |e| {
                moments |= matches!(e.kind, ExprKind::Expectation(_));
            });
        }
        moments && !matches!(link.relation, Relation::Equal)
    }

    fn points_apart(&self, equation: usize, link: &Link, stated: &[Hypothesis]) -> Challenge {
        if self.misses_rates(equation, link) {
            return Challenge::default();
        }
        let world = self.world(None);
        // What the document states is meant too, though it is not printed.
        let hypotheses = self.model.equations[equation].assume.iter().chain(stated);
        let mut budget = Budget::default();
        if link.relation != Relation::Equal {
            // An equation that is false is so nearly everywhere, an inequality perhaps only somewhere.
            (budget.points, budget.tries) = (INEQUALITY_POINTS, 2 * INEQUALITY_POINTS);
        }
        let mut found = challenge(&world, equation, link, hypotheses, &budget);
        // What nobody could read shows nothing.
        found.apart = found.apart.filter(Shown::can_be_written);
        found
    }

    /// What the second route finds at the point of a witness. Letters that it does not give a value have their
    /// reference values or are drawn: that there is no value is seen of many such points.
    fn at_witness(&self, equation: usize, link: &Link, witness: &Witness) -> There {
        let world = self.world(None);
        let mut given = Vec::new();
        for (letter, value) in &witness.point {
            if let Letter::Symbol { symbol, order } = self.model.letters[*letter] {
                let Some(exact) = value.exact() else {
                    return There::Unknown;
                };
                given.push((symbol, order, exact));
            }
        }
        for number in 0..COMPLETIONS {
            let mut point = Point::of(self.model, number);
            let own = self.model.symbols.iter().enumerate();
            for (symbol, value) in own.filter_map(|(s, d)| Some((s, d.value.as_ref()?))) {
                if number == 0 {
                    point = point.with(symbol, 0, Complex::from(Real::rational(value.clone())));
                }
            }
            for (symbol, order, value) in &given {
                let value = Complex::from(Real::rational((*value).clone()));
                point = point.with(*symbol, *order, value);
            }
            match self.found_at(&world, equation, link, &point) {
                There::NoValue => {}
                found @ (There::Apart(_) | There::Together | There::Unknown) => return found,
            }
        }
        There::NoValue
    }

    /// Whether a side certainly has no value at the point of a witness.
    pub(super) fn has_no_value_at(&self, equation: usize, link: &Link, witness: &Witness) -> bool {
        matches!(self.at_witness(equation, link, witness), There::NoValue)
    }

    fn found_at(&self, world: &World<'m>, equation: usize, link: &Link, point: &Point) -> There {
        for bits in BITS {
            match world.compare(equation, link, point, bits, WORK) {
                Comparison::Apart(shown) => return There::Apart(shown),
                // A small difference of large numbers shows only with more digits.
                Comparison::Overlap { narrow: true } if Some(&bits) == BITS.last() => {
                    return There::Together;
                }
                Comparison::Overlap { .. } => {}
                Comparison::NoValue(none) if none.reason.is_imprecise() => {}
                Comparison::NoValue(none) if none.reason.is_certain() => return There::NoValue,
                Comparison::NoValue(_) => return There::Unknown,
            }
        }
        There::Unknown
    }

    /// Whether these hypotheses are true at some admissible point; none where it is certain that they
    /// are at none.
    pub(super) fn admits_a_point(&self, hypotheses: &[&Hypothesis]) -> Option<bool> {
        let world = self.world(None);
        let hypotheses = hypotheses.iter().copied();
        match Points::new(&world, hypotheses).and_then(|mut points| points.next_point()) {
            Ok(_) => Some(true),
            Err(crate::enclose::NoPoint::Contradictory(_)) => None,
            Err(crate::enclose::NoPoint::NoneFound { .. }) => Some(false),
        }
    }

    fn witness_of(&self, shown: &Shown) -> Witness {
        let letters = shown.letters.iter().filter_map(|(symbol, order, value)| {
            let letter = self.model.letter_of_symbol(*symbol, *order)?;
            Some((letter, point_value(value)))
        });
        Witness {
            point: letters.collect(),
            left: point_value(&shown.left),
            right: point_value(&shown.right),
            place: shown.entry,
            indices: shown.indices.clone(),
        }
    }
}

/// A number of the second route.
fn point_value(value: &Complex) -> PointValue {
    let part = |real: &Real| match real {
        Real::Exact(number) => PointValue::Exact(number.clone()),
        Real::Enclosed(interval) => {
            let [low, high] = [interval.low(), interval.high()].map(|end| end.to_rational());
            PointValue::Between(low, high)
        }
    };
    match part(&value.im) {
        PointValue::Exact(zero) if zero.is_zero() => part(&value.re),
        imaginary => PointValue::Complex(Box::new([part(&value.re), imaginary])),
    }
}

/// Whether a relation is one that values at points can violate.
pub(super) fn is_decided_by_points(relation: Relation) -> bool {
    match relation {
        Relation::Equal
        | Relation::NotEqual
        | Relation::Less
        | Relation::LessEqual
        | Relation::Greater
        | Relation::GreaterEqual => true,
        Relation::Distributed | Relation::Approximately | Relation::Tends => false,
    }
}
