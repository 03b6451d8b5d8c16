//! Hypotheses that a document states and that are not printed (`given`): they are used where an
//! equation is false without them, and named in its verdict.

use crate::check::Checker;
use crate::check::identity::{Decision, Insertion, letters_of};
use crate::evaluate::Value;
use crate::expr::{Chain, Relation};
use crate::latex;
use crate::model::links::Link;
use crate::model::{Hypothesis, Letter, Role};
use crate::verdict::{Given, PointValue, Proof, Refutation, Verdict};
use num_rational::BigRational;
use num_traits::{Signed, Zero};
use ratpoly::RationalFunction;
use std::cmp::Ordering;

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
        // Then the document's own numbers are put aside: only a point at which what is stated holds shows anything.
        let broken = self.words_of_broken(equation);
        let conditions = self.exact.conditions.clone();
        let mut under = match self.suppose(&stated) {
            Ok(under) => under,
            Err(unusable) => {
                let words = || format!("as stated: {}", self.words_of(&unusable));
                return undecided(broken.unwrap_or_else(words));
            }
        };
        let (proof, false_there) = under.proof_where_supposed(equation, link);
        self.diagnostics.append(&mut under.diagnostics);
        self.contradiction = self.contradiction.take().or(under.contradiction.take());
        let vanishing = under.vanishing_divisor().is_some() || under.divides_by_relation();
        let Some(proof) = proof else {
            self.exact.conditions = conditions;
            let there = false_there.filter(|_| broken.is_none());
            let Some(found) = there.or_else(|| self.violated(equation, link)) else {
                let neither = "it is false without the stated hypothesis, and neither proved nor shown false with it";
                return undecided(broken.unwrap_or_else(|| neither.into()));
            };
            let residual = std::mem::take(&mut refutation.residual);
            *refutation = found.with_residual(residual);
            return None;
        };
        if vanishing {
            return undecided("a divisor vanishes under the stated hypotheses".into());
        }
        if let Some(reason) = broken {
            return undecided(reason);
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
        self.broken_by_reference(hypotheses).is_some()
    }

    /// The first of these hypotheses that the document's own numbers break, by its number, with the letters whose
    /// values do so.
    fn broken_by_reference(&mut self, hypotheses: &[&Hypothesis]) -> Option<(usize, Vec<usize>)> {
        if hypotheses.is_empty() {
            return None;
        }
        let conditions = self.exact.conditions.clone();
        let mut all = hypotheses.iter().enumerate();
        let found = all.find_map(|(k, h)| Some((k, self.broken_by(h)?)));
        self.exact.conditions = conditions;
        found
    }

    /// The letters whose reference values break a hypothesis, if they do.
    fn broken_by(&mut self, hypothesis: &Hypothesis) -> Option<Vec<usize>> {
        let difference = hypothesis.difference();
        let Ok(Value::Scalar(value)) = self.exact.expression_without_cases(&difference) else {
            return None;
        };
        let inserted = self.spelt_out(&value);
        let plain = |l: &usize| !self.is_function(*l);
        let letters: Vec<usize> = match (&inserted, self.functions()) {
            (Some(f), Some(table)) => table.letters_behind(f).into_iter().collect(),
            (Some(f), None) => letters_of([f]).into_iter().collect(),
            (None, _) => letters_of([&value]).into_iter().collect(),
        };
        let letters: Vec<usize> = letters.into_iter().filter(plain).collect();
        // Where it has no value at the document's numbers it does not hold there.
        let Some(value) = inserted else {
            return Some(letters);
        };
        if !letters.iter().all(|l| self.has_reference(*l)) {
            return None;
        }
        let point: Vec<Option<BigRational>> =
            self.reference_point().into_iter().map(Some).collect();
        let below = RationalFunction::from(value.denominator().clone());
        let sign = match self.certain_value(&value, &point) {
            Some(PointValue::Exact(number)) => number.cmp(&BigRational::zero()),
            Some(PointValue::Between(low, _)) if low.is_positive() => Ordering::Greater,
            Some(PointValue::Between(_, high)) if high.is_negative() => Ordering::Less,
            Some(PointValue::Between(..) | PointValue::Complex(_)) => return None,
            None => {
                let pole = self.certain_value(&below, &point);
                let pole = matches!(pole, Some(PointValue::Exact(zero)) if zero.is_zero());
                return pole.then_some(letters);
            }
        };
        let holds = match hypothesis.relation {
            Relation::Equal => sign.is_eq(),
            Relation::NotEqual => sign.is_ne(),
            Relation::Less => sign.is_lt(),
            Relation::LessEqual => sign.is_le(),
            Relation::Greater => sign.is_gt(),
            Relation::GreaterEqual => sign.is_ge(),
            Relation::Approximately | Relation::Distributed | Relation::Tends => false,
        };
        (!holds).then_some(letters)
    }

    /// That the document's own numbers break what it states, in words.
    pub(in crate::check) fn words_of_broken(&mut self, equation: usize) -> Option<String> {
        let model = self.model;
        let stated: Vec<&'m Hypothesis> = model.equations[equation].given.iter().collect();
        let (number, letters) = self.broken_by_reference(&stated)?;
        let text = latex::write_chain(&Chain {
            members: vec![stated[number].left.clone(), stated[number].right.clone()],
            relations: vec![stated[number].relation],
            span: stated[number].span,
        });
        let value = |l: usize| match model.letters[l] {
            Letter::Symbol { symbol, order: 0 } => {
                let symbol = &model.symbols[symbol];
                let value = symbol.value.as_ref()?;
                Some(format!("{} = {value}", latex::canonical(&symbol.name)))
            }
            Letter::Symbol { .. } | Letter::Abbreviation { .. } | Letter::Function { .. } => None,
        };
        let values: Vec<String> = letters.into_iter().filter_map(value).collect();
        Some(match values.is_empty() {
            true => format!("the reference values contradict the stated hypothesis {text}"),
            false => format!(
                "the reference values {} contradict the stated hypothesis {text}",
                values.join(", ")
            ),
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
