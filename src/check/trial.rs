//! What the checker says of one changed equation, the rest of the document being as it was.
//!
//! A link is decided by the code that decides every verdict; only the bookkeeping around it is
//! here: which values a changed display makes stale, and what a verdict says of a changed equation.

use super::Checker;
use super::sides::sides_of;
use crate::diagnostic::DiagnosticKind;
use crate::evaluate::{Failure, FailureKind, Value};
use crate::expr::Display;
use crate::model::links::Link;
use crate::model::{Definition, DefinitionKind, Node};
use crate::verdict::{Correction, Verdict};
use ratpoly::RationalFunction;
use std::fmt;

/// What the checker says of a link or a definition of a changed equation.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Finding {
    /// True, or a definition with a value.
    Accepted,
    /// False.
    Refuted,
    /// It has no value at all.
    Meaningless(Nonsense),
    /// It is no statement any more: nothing is left to check.
    NothingToCheck,
    /// A limit was hit, or it lies outside of what is decided.
    Undecided(String),
}

/// Why a changed equation has no value.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Nonsense {
    /// A name, an entry or a member that does not exist.
    Missing,
    /// Shapes that do not fit.
    Shapes,
    /// A divisor that is zero.
    Division,
    /// An exponent or an index that is no admitted integer.
    Exponent,
    /// A name with two meanings.
    Ambiguous,
    /// An equation that does not determine its unknowns.
    Undetermined,
    /// An integral without a value.
    Divergent,
    /// A definition that needs itself.
    Circular,
    /// Another name is defined, or one twice, and the document is refused.
    Unreadable,
}

impl Nonsense {
    /// In words.
    pub fn as_str(self) -> &'static str {
        match self {
            Nonsense::Missing => "something that does not exist",
            Nonsense::Shapes => "shapes that do not fit",
            Nonsense::Division => "division by zero",
            Nonsense::Exponent => "an exponent that is no integer",
            Nonsense::Ambiguous => "a name with two meanings",
            Nonsense::Undetermined => "unknowns that are not determined",
            Nonsense::Divergent => "an integral without a value",
            Nonsense::Circular => "a definition that needs itself",
            Nonsense::Unreadable => "a document that is refused",
        }
    }

    pub(crate) fn of_diagnostic(kind: &DiagnosticKind) -> Self {
        match kind {
            DiagnosticKind::ShapeMismatch { .. } => Nonsense::Shapes,
            DiagnosticKind::DivisionByZero => Nonsense::Division,
            DiagnosticKind::Exponent { .. } => Nonsense::Exponent,
            DiagnosticKind::Ambiguous { .. } => Nonsense::Ambiguous,
            DiagnosticKind::UndeclaredName { .. } => Nonsense::Missing,
            DiagnosticKind::CyclicDefinition { .. } => Nonsense::Circular,
            _ => Nonsense::Unreadable,
        }
    }

    fn of_failure(kind: &FailureKind) -> Option<Self> {
        Some(match kind {
            FailureKind::Shape { .. } => Nonsense::Shapes,
            FailureKind::DivisionByZero => Nonsense::Division,
            FailureKind::Exponent { .. } => Nonsense::Exponent,
            FailureKind::Outside { .. } | FailureKind::Undeclared { .. } => Nonsense::Missing,
            FailureKind::Ambiguous { .. } => Nonsense::Ambiguous,
            FailureKind::NotLinear | FailureKind::Underdetermined | FailureKind::Inconsistent => {
                Nonsense::Undetermined
            }
            FailureKind::NotStationary => Nonsense::Undetermined,
            FailureKind::Divergent { .. } => Nonsense::Divergent,
            FailureKind::NeedsItself => Nonsense::Circular,
            FailureKind::Budget { .. }
            | FailureKind::Exhausted { .. }
            | FailureKind::Unsupported { .. } => return None,
        })
    }
}

impl fmt::Display for Nonsense {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.as_str())
    }
}

/// Both sides of a link for each value of its indices, all definitions inserted.
pub(crate) type Expanded = Vec<[Value<RationalFunction>; 2]>;

impl<'m> Checker<'m> {
    /// A checker in which the hypotheses printed around an equation hold; none where there are none.
    ///
    /// # Errors
    /// Why they cannot be used.
    pub(crate) fn under(&mut self, equation: usize) -> Option<Result<Self, String>> {
        if self.model.equations[equation].assume.is_empty() {
            return None;
        }
        let under = self.under_hypotheses(equation);
        Some(under.map_err(|unusable| self.words_of(&unusable)))
    }

    /// What is wrong with the abbreviations since a change was put in place, if anything.
    pub(crate) fn nonsense(&mut self) -> Option<Nonsense> {
        let first = self.diagnostics.first().map(|d| &d.kind);
        let found = first.map(Nonsense::of_diagnostic);
        self.diagnostics.clear();
        found
    }

    /// What a link is found to be, by the same code as every verdict and under the hypotheses
    /// printed around it.
    pub(crate) fn finding(&mut self, equation: usize, link: usize) -> Finding {
        match self.under(equation) {
            None => self.finding_as_it_is(equation, link),
            Some(Ok(mut under)) => under.finding_as_it_is(equation, link),
            Some(Err(reason)) => match self.nonsense() {
                Some(nonsense) => Finding::Meaningless(nonsense),
                None => Finding::Undecided(reason),
            },
        }
    }

    /// The same in a checker in which the hypotheses hold already.
    pub(crate) fn finding_as_it_is(&mut self, equation: usize, link: usize) -> Finding {
        self.diagnostics.clear();
        self.failure = None;
        let verdict = self.verdict_alone(equation, link);
        if let Some(nonsense) = self.nonsense() {
            return Finding::Meaningless(nonsense);
        }
        match verdict {
            // Under a relation that nothing states or implies it is false.
            Verdict::HoldsGiven(given, _) if given.is_offered() => Finding::Refuted,
            Verdict::Holds { .. } | Verdict::HoldsGiven(..) => Finding::Accepted,
            Verdict::Definition { .. } => {
                let equation = &self.model.equations[equation];
                if equation.defines[link].is_some() || equation.role == crate::model::Role::Solve {
                    Finding::Accepted
                } else {
                    Finding::NothingToCheck
                }
            }
            Verdict::Recalled { .. } => Finding::NothingToCheck,
            Verdict::Refuted(refutation) | Verdict::Misprint { refutation, .. } => {
                if refutation.missing().is_some() {
                    Finding::Meaningless(Nonsense::Missing)
                } else if refutation.misfit().is_some() {
                    Finding::Meaningless(Nonsense::Shapes)
                } else {
                    Finding::Refuted
                }
            }
            Verdict::Undecided { reason } => {
                let nonsense = self.failure.as_ref().and_then(Nonsense::of_failure);
                nonsense.map_or(Finding::Undecided(reason), Finding::Meaningless)
            }
        }
    }

    /// The verdict on a link without the conditions that its divisors make.
    fn verdict_alone(&mut self, equation: usize, link: usize) -> Verdict {
        self.verdict(equation, link, None, &mut None)
    }

    /// The correction that the search proposes for a link, if it is refuted.
    pub(crate) fn correction(&mut self, equation: usize, link: usize) -> Option<Correction> {
        let verdict = match self.under(equation) {
            None => self.verdict_alone(equation, link),
            Some(Ok(mut under)) => under.verdict_alone(equation, link),
            Some(Err(_)) => return None,
        };
        match verdict {
            Verdict::Misprint { correction, .. } => Some(*correction),
            _ => None,
        }
    }

    /// Both sides of a link of a display, all definitions inserted; none where they have no values.
    pub(crate) fn expanded_sides(
        &mut self,
        equation: usize,
        display: &Display,
        link: &Link,
    ) -> Option<Expanded> {
        let span = self.model.equations[equation].span;
        let sides = sides_of(&mut self.exact, display, link, span).ok()?;
        sides
            .into_iter()
            .map(|(_, left, right)| Some([self.expanded(left)?, self.expanded(right)?]))
            .collect()
    }

    /// What a definition defines, all definitions inserted: one value for each index.
    pub(crate) fn defined(&mut self, definition: usize) -> Option<Vec<Value<RationalFunction>>> {
        let model = self.model;
        let Definition {
            kind,
            equation,
            letter,
            ..
        } = &model.definitions[definition];
        if let Some(letter) = letter {
            return Some(vec![Value::Scalar(self.inserted.get(letter)?.clone())]);
        }
        let tuples = match kind {
            DefinitionKind::Family { ranges, .. } => super::index_tuples(ranges),
            _ => vec![Vec::new()],
        };
        let span = model.equations[*equation].span;
        let mut values = Vec::new();
        for tuple in tuples {
            let key = (Node::Definition(definition), tuple, 0);
            let found = self
                .exact
                .in_each_case(|exact| exact.value_of(key.clone(), span));
            for (_, value) in found.ok()? {
                values.push(self.expanded(value)?);
            }
        }
        Some(values)
    }

    /// What a `solve` block determines, all definitions inserted.
    pub(crate) fn determined(&mut self, system: usize) -> Option<Vec<Value<RationalFunction>>> {
        let model = self.model;
        let span = model.equations[model.systems[system].equation].span;
        (0..model.systems[system].unknowns.len())
            .map(|position| {
                let key = (Node::Unknown { system, position }, Vec::new(), 0);
                let value = self.exact.value_of(key, span).ok()?;
                self.expanded(value)
            })
            .collect()
    }

    fn expanded(&self, value: Value<RationalFunction>) -> Option<Value<RationalFunction>> {
        let letters: Vec<(usize, RationalFunction)> =
            self.inserted.iter().map(|(l, v)| (*l, v.clone())).collect();
        value
            .try_map(|element| {
                let used = match self.functions() {
                    Some(table) => table.letters_behind(element),
                    None => super::identity::letters_of([element]),
                };
                if !letters.iter().any(|(letter, _)| used.contains(letter)) {
                    return Ok(element.clone());
                }
                match self.functions() {
                    Some(table) => table.substitute(element, &letters).ok(),
                    None => element.substitute(&letters).ok(),
                }
                .ok_or_else(|| Failure::unsupported("a value", Default::default()))
            })
            .ok()
    }
}
