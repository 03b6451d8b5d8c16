//! Hypotheses that a document states and that are not printed (`given`): they are used where an
//! equation is false without them, and named in its verdict.

use super::Hypotheses;
use crate::check::Checker;
use crate::check::identity::{Decision, Insertion};
use crate::evaluate::Value;
use crate::expr::{Expr, ExprKind, Relation};
use crate::latex;
use crate::model::links::{Link, visit};
use crate::model::{Hypothesis, Role};
use crate::verdict::{Given, Refutation, Verdict};
use num_traits::Zero;
use ratpoly::{Polynomial, RationalFunction};
use std::collections::BTreeSet;

impl<'m> Checker<'m> {
    /// The verdict on a link that is false without the hypotheses that the document states; none where
    /// it states none, or the link does not follow from them.
    pub(in crate::check) fn under_stated(
        &mut self,
        equation: usize,
        link: &Link,
        refutation: &Refutation,
    ) -> Option<Verdict> {
        let model = self.model;
        let stated: Vec<&'m Hypothesis> = model.equations[equation].given.iter().collect();
        if stated.is_empty() {
            return None;
        }
        let undecided = |reason: String| Some(Verdict::Undecided { reason });
        if self.is_restated(equation, link, &stated) {
            return undecided("the stated hypothesis is the claim itself".into());
        }
        let conditions = self.exact.conditions.clone();
        let under = match self.suppose(&stated) {
            Ok(under) => under,
            Err(unusable) => return undecided(format!("as stated: {}", self.words_of(&unusable))),
        };
        let free = self.exchange(under);
        let decision = self
            .sides(equation, link)
            .map_err(|_| String::new())
            .and_then(|entries| Ok((self.decide_true(&entries, equation)?, entries)));
        let nothing = Insertion::default();
        let proof = match decision {
            Ok((Decision::Holds(by) | Decision::HoldsGiven(by, _), entries)) => {
                let mut all = self.insertion(&self.inserted.keys().copied().collect::<Vec<_>>());
                all.labels = by.labels;
                self.proved(equation, link, &entries, &all, None)
            }
            Ok((Decision::Follows(_, given), _)) => {
                self.proved(equation, link, &[], &nothing, Some(&given))
            }
            Ok((Decision::False(..) | Decision::Refuted(_), _)) | Err(_) => None,
        };
        let vanishing = self.vanishing_divisor().is_some() || self.divides_by_relation();
        self.exchange(free);
        let Some(proof) = proof else {
            self.exact.conditions = conditions;
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

    /// Puts an evaluation in place of this one, and gives back the one before.
    pub(in crate::check) fn exchange(&mut self, other: Hypotheses<'m>) -> Hypotheses<'m> {
        Hypotheses {
            exact: std::mem::replace(&mut self.exact, other.exact),
            inserted: std::mem::replace(&mut self.inserted, other.inserted),
            supposed: std::mem::replace(&mut self.supposed, other.supposed),
        }
    }

    /// Whether a link says what one of the hypotheses printed around it says.
    pub(in crate::check) fn is_circular(&mut self, equation: usize, l: usize) -> bool {
        let model = self.model;
        let printed = &model.equations[equation];
        if printed.assume.is_empty() || printed.role != Role::Claim {
            return false;
        }
        let hypotheses: Vec<&'m Hypothesis> = printed.assume.iter().collect();
        self.is_restated(equation, &printed.links[l], &hypotheses)
    }

    /// Whether a link says what one of these hypotheses says, but for a number as a factor.
    fn is_restated(&mut self, equation: usize, link: &Link, hypotheses: &[&Hypothesis]) -> bool {
        let display = self.exact.display(equation).clone();
        let (Some(left), Some(right)) = (link.left.find(&display), link.right.find(&display))
        else {
            return false;
        };
        // What names something else says something else; and its value may be dear.
        let claimed: BTreeSet<String> = [left, right].into_iter().flat_map(names).collect();
        let mut hypotheses = hypotheses
            .iter()
            .filter(|h| {
                let own: BTreeSet<String> =
                    [&h.left, &h.right].into_iter().flat_map(names).collect();
                claimed.is_subset(&own)
            })
            .peekable();
        if hypotheses.peek().is_none() {
            return false;
        }
        // In the letters as printed, before anything is supposed.
        let model = self.model;
        let mut exact = crate::check::symbolic(model).in_instance(self.instance);
        for (corrected, display) in self.exact.corrections() {
            exact.correct(*corrected, display.clone());
        }
        let mut vanishing = |left: &Expr, right: &Expr, relation: Relation| {
            let difference = Hypothesis {
                left: left.clone(),
                relation,
                right: right.clone(),
                span: left.span,
            };
            exact.expression(&difference.difference()).ok()
        };
        let Some(claim) = vanishing(left, right, link.relation) else {
            return false;
        };
        let Some(claim) = normal(&claim, link.relation) else {
            return false;
        };
        hypotheses.any(|h| {
            let said = vanishing(&h.left, &h.right, h.relation);
            said.and_then(|said| normal(&said, h.relation)) == Some(claim.clone())
        })
    }

    /// Whether the document's own numbers are none at which the hypotheses hold.
    pub(in crate::check) fn breaks_reference(&mut self, hypotheses: &[&Hypothesis]) -> bool {
        let point = self.reference_point();
        hypotheses.iter().any(|h| {
            let Ok(Value::Scalar(value)) = self.exact.expression(&h.difference()) else {
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

/// The names that an expression holds.
fn names(expr: &Expr) -> BTreeSet<String> {
    let mut found = BTreeSet::new();
    visit(expr, &mut |e| {
        if let ExprKind::Name(name) | ExprKind::Apply { function: name, .. } = &e.kind {
            found.insert(latex::canonical(name));
        }
    });
    found
}

/// What a relation says, comparable: the polynomials that vanish, or the difference that has a sign,
/// but for positive factors that are numbers.
fn normal(
    value: &Value<RationalFunction>,
    relation: Relation,
) -> Option<(Relation, BTreeSet<String>)> {
    let unit = |p: &Polynomial| p.primitive_part().unit_normal().to_string();
    let (relation, flipped) = match relation {
        Relation::Less => (Relation::Greater, true),
        Relation::LessEqual => (Relation::GreaterEqual, true),
        other => (other, false),
    };
    let entries = value.entries();
    let said: BTreeSet<String> = match relation {
        Relation::Equal | Relation::NotEqual => entries
            .iter()
            .filter(|e| !e.is_zero())
            .map(|e| unit(e.numerator()))
            .collect(),
        _ => {
            let [entry] = entries[..] else { return None };
            let entry = if flipped { -entry } else { entry.clone() };
            let content = entry.numerator().content();
            let top = entry.numerator().div_integer(&content)?;
            BTreeSet::from([format!("{top} / {}", unit(entry.denominator()))])
        }
    };
    (!said.is_empty()).then_some((relation, said))
}
