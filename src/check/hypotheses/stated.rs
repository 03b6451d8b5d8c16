//! Hypotheses that a document states and that are not printed (`given`): they are used where an
//! equation is false without them, and named in its verdict.

use crate::check::Checker;
use crate::check::identity::{Decision, Insertion};
use crate::evaluate::Value;
use crate::expr::Relation;
use crate::model::links::Link;
use crate::model::{Hypothesis, Role};
use crate::verdict::{Given, Proof, Refutation, Verdict};
use num_traits::Zero;

impl<'m> Checker<'m> {
    /// The verdict on a link that is false without the hypotheses that the document states; none where
    /// it states none, or where the link is false with them too: then the point that shows it is one at
    /// which they hold.
    pub(in crate::check) fn under_stated(
        &mut self,
        equation: usize,
        link: &Link,
        refutation: &mut Refutation,
    ) -> Option<Verdict> {
        let model = self.model;
        let stated: Vec<&'m Hypothesis> = model.equations[equation].given.iter().collect();
        if stated.is_empty() {
            return None;
        }
        let undecided = |reason: String| Some(Verdict::Undecided { reason });
        if self.is_multiple(equation, link, &stated) {
            return undecided("the stated hypothesis is the claim itself".into());
        }
        let conditions = self.exact.conditions.clone();
        let mut under = match self.suppose(&stated) {
            Ok(under) => under,
            Err(unusable) => return undecided(format!("as stated: {}", self.words_of(&unusable))),
        };
        let (proof, false_there) = under.proof_where_supposed(equation, link);
        self.diagnostics.append(&mut under.diagnostics);
        self.contradiction = self.contradiction.take().or(under.contradiction.take());
        let vanishing = under.vanishing_divisor().is_some() || under.divides_by_relation();
        let Some(proof) = proof else {
            self.exact.conditions = conditions;
            let Some(found) = false_there.or_else(|| self.violated(equation, link)) else {
                return undecided(
                    "it is false without the stated hypothesis, and neither proved nor shown false with it"
                        .into(),
                );
            };
            let residual = std::mem::take(&mut refutation.residual);
            *refutation = found.with_residual(residual);
            return None;
        };
        if vanishing {
            return undecided("a divisor vanishes under the stated hypotheses".into());
        }
        if self.breaks_reference(&stated) {
            return undecided("the reference values break the stated hypothesis".into());
        }
        let texts = &model.equations[equation].settings.given;
        let given = Given {
            relations: Vec::new(),
            stated: texts.iter().map(|text| text.text.clone()).collect(),
            implied_by: Vec::new(),
            cofactors: Vec::new(),
            counterexample: refutation.witness().cloned(),
            instance: None,
        };
        Some(Verdict::HoldsGiven(Box::new(given), proof))
    }

    /// The proof of a link where what is supposed holds, or what shows a relation of order false there.
    fn proof_where_supposed(
        &mut self,
        equation: usize,
        link: &Link,
    ) -> (Option<Proof>, Option<Refutation>) {
        if link.relation == Relation::Equal {
            return (self.proof_of_equation_where_supposed(equation, link), None);
        }
        match self.inequality(equation, link, &mut None) {
            Verdict::Holds { proof, .. } => (Some(proof), None),
            Verdict::Refuted(refutation) => (None, Some(refutation)),
            Verdict::HoldsGiven(..)
            | Verdict::Misprint { .. }
            | Verdict::Undecided { .. }
            | Verdict::Definition { .. }
            | Verdict::Recalled { .. } => (None, None),
        }
    }

    fn proof_of_equation_where_supposed(&mut self, equation: usize, link: &Link) -> Option<Proof> {
        let entries = self.sides(equation, link).ok()?;
        match self.decide_true(&entries, equation).ok()? {
            Decision::Holds(by) | Decision::HoldsGiven(by, _) => {
                let mut all = self.insertion(&self.inserted.keys().copied().collect::<Vec<_>>());
                all.labels = by.labels;
                self.proved(equation, link, &entries, &all, None)
            }
            Decision::Follows(_, given) => {
                self.proved(equation, link, &[], &Insertion::default(), Some(&given))
            }
            Decision::False(..) | Decision::Refuted(_) => None,
        }
    }

    /// Whether a link is printed as one of the hypotheses around it.
    pub(in crate::check) fn is_circular(&self, equation: usize, l: usize) -> bool {
        let printed = &self.model.equations[equation];
        if printed.assume.is_empty() || printed.role != Role::Claim {
            return false;
        }
        let (link, display) = (&printed.links[l], self.exact.display(equation));
        let (Some(left), Some(right)) = (link.left.find(display), link.right.find(display)) else {
            return false;
        };
        printed.assume.iter().any(|h| {
            h.relation == link.relation && h.left == *left && h.right == *right
                || h.relation == turned(link.relation) && h.left == *right && h.right == *left
        })
    }

    /// Whether left minus right of a link is a number times that of one of these hypotheses, in the
    /// letters as printed and before anything is supposed.
    fn is_multiple(&mut self, equation: usize, link: &Link, hypotheses: &[&Hypothesis]) -> bool {
        let display = self.exact.display(equation).clone();
        let (Some(left), Some(right)) = (link.left.find(&display), link.right.find(&display))
        else {
            return false;
        };
        let claim = Hypothesis {
            left: left.clone(),
            relation: link.relation,
            right: right.clone(),
            span: left.span,
        };
        let conditions = self.exact.conditions.clone();
        let mut difference =
            |h: &Hypothesis| match self.exact.expression_without_cases(&h.difference()) {
                Ok(Value::Scalar(value)) if !value.is_zero() => Some(value),
                _ => None,
            };
        let found = difference(&claim).is_some_and(|claim| {
            hypotheses.iter().any(|h| {
                let quotient = difference(h).and_then(|said| claim.checked_div(&said).ok());
                h.relation == Relation::Equal && quotient.is_some_and(|q| q.as_constant().is_some())
            })
        });
        self.exact.conditions = conditions;
        found
    }

    /// Whether the document's own numbers are none at which the hypotheses hold.
    pub(in crate::check) fn breaks_reference(&mut self, hypotheses: &[&Hypothesis]) -> bool {
        if hypotheses.is_empty() {
            return false;
        }
        let point = self.reference_point();
        hypotheses.iter().any(|h| {
            let Ok(Value::Scalar(value)) = self.exact.expression_without_cases(&h.difference())
            else {
                return false;
            };
            let all = self.insertion(&self.inserted.keys().copied().collect::<Vec<_>>());
            let Ok(value) = value.substitute(&all.letters) else {
                return true;
            };
            let letters = super::super::identity::letters_of([&value]);
            if !letters.iter().all(|l| self.has_reference(*l)) {
                return false;
            }
            let Ok(number) = value.evaluate(&point) else {
                return true;
            };
            let sign = number.cmp(&num_rational::BigRational::zero());
            !match h.relation {
                Relation::Equal => sign.is_eq(),
                Relation::NotEqual => sign.is_ne(),
                Relation::Less => sign.is_lt(),
                Relation::LessEqual => sign.is_le(),
                Relation::Greater => sign.is_gt(),
                Relation::GreaterEqual => sign.is_ge(),
                Relation::Approximately | Relation::Distributed | Relation::Tends => true,
            }
        })
    }
}

/// The relation with its sides exchanged.
fn turned(relation: Relation) -> Relation {
    match relation {
        Relation::Less => Relation::Greater,
        Relation::LessEqual => Relation::GreaterEqual,
        Relation::Greater => Relation::Less,
        Relation::GreaterEqual => Relation::LessEqual,
        Relation::Equal
        | Relation::NotEqual
        | Relation::Distributed
        | Relation::Approximately
        | Relation::Tends => relation,
    }
}
