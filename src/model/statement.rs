//! Statements as mathematics: their quantities as expressions, their letters as symbols.

use super::build::Builder;
use super::{Model, Node};
use crate::diagnostic::DiagnosticKind;
use crate::document::{self, Document, Predicate, Settings, Text, VerdictWord};
use crate::expr::Expr;
use crate::latex::{self, Signature};
use crate::span::Span;
use num_rational::BigRational;

/// A sentence and the propositions that it consists of.
#[derive(Clone, Debug)]
pub struct Statement {
    /// Its label.
    pub label: String,
    /// The sentence as printed.
    pub sentence: String,
    /// The author's settings.
    pub settings: Settings,
    /// Whether the sentence is the document's own and none of the paper's.
    pub own: bool,
    /// Whether the propositions are readings of it of which one must be true.
    pub alternatives: bool,
    /// One for each quantity and letter; none where the sentence is recalled.
    pub propositions: Vec<Proposition>,
    /// Where it stands.
    pub span: Span,
}

/// A predicate of one quantity.
#[derive(Clone, Debug)]
pub struct Proposition {
    /// The predicate.
    pub predicate: Predicate,
    /// The quantity.
    pub of: Expr,
    /// The letter, or letters where they belong together, as indices into [`Model::symbols`].
    pub letters: Vec<usize>,
    /// Groups of symbols.
    pub groups: Vec<Vec<usize>>,
    /// What it is compared with; for a limit, none stands for infinity.
    pub to: Option<Expr>,
    /// The value of the letter; none for the reference value.
    pub at: Option<Expr>,
    /// Whether the letter grows beyond all numbers; otherwise it falls to zero.
    pub to_infinity: bool,
    /// The quantity whose minimum is meant.
    pub minimum_of: Option<Expr>,
    /// Symbols that have their reference values here; none of them is one of the letters.
    pub fixed: Vec<usize>,
    /// Whether the quantity is divided by its value at the reference values of the letters.
    pub normalised: bool,
    /// Whether only the box is meant.
    pub only_in_box: bool,
    /// The symbols of the box.
    pub around: Vec<usize>,
    /// Smallest and largest multiple of their reference values.
    pub times: (BigRational, BigRational),
    /// Up to where something is called small, or close.
    pub tolerance: BigRational,
}

impl Statement {
    /// The verdict that the document records for a proposition.
    pub fn expected(&self, member: usize) -> Option<VerdictWord> {
        self.settings.expected(member)
    }
}

impl Proposition {
    /// The expressions in it.
    pub fn expressions(&self) -> impl Iterator<Item = &Expr> {
        [
            Some(&self.of),
            self.to.as_ref(),
            self.at.as_ref(),
            self.minimum_of.as_ref(),
        ]
        .into_iter()
        .flatten()
    }
}

impl Model {
    /// The statement with this label.
    pub fn statement(&self, label: &str) -> Option<usize> {
        self.statements.iter().position(|s| s.label == label)
    }
}

impl Builder {
    pub(super) fn statements(&mut self, document: &Document, signature: &Signature) {
        for statement in &document.statements {
            let propositions = match &statement.meaning {
                Some(meaning) => self.propositions(meaning, signature),
                None => Vec::new(),
            };
            self.statements.push(Statement {
                label: statement.label.text.clone(),
                sentence: statement.sentence.text.clone(),
                settings: statement.settings.clone(),
                own: statement.own,
                alternatives: statement.alternatives,
                propositions,
                span: statement.sentence.span,
            });
        }
    }

    fn propositions(
        &mut self,
        meaning: &document::Meaning,
        signature: &Signature,
    ) -> Vec<Proposition> {
        let letters = self.constants(&meaning.letters);
        let fixed = self.constants(&meaning.fixed);
        let around = self.constants(&meaning.around);
        let groups = meaning
            .groups
            .iter()
            .map(|g| self.constants(g))
            .collect::<Vec<_>>();
        self.with_values(&around, &meaning.around);
        self.with_values(&fixed, &meaning.fixed);
        // Letters that belong together make one proposition, others one each.
        let choices: Vec<Vec<usize>> = match meaning.predicate {
            Predicate::DependsOnlyOn => vec![letters],
            _ if letters.is_empty() => vec![Vec::new()],
            _ => letters.into_iter().map(|l| vec![l]).collect(),
        };
        let at = self.optional(meaning.at.as_ref(), signature);
        if let (Some(at), Some(text)) = (&at, &meaning.at)
            && let Some(value) = super::names::literal_number(at)
            && let Some(symbol) = choices
                .iter()
                .flatten()
                .find(|symbol| !self.symbols[**symbol].range.contains(&value))
        {
            let letter = latex::canonical(&self.symbols[*symbol].name);
            let kind = DiagnosticKind::Unexpected {
                found: format!("`{letter} = {}`", text.text),
                expected: "a value that the declaration of the letter admits".into(),
            };
            self.error(kind, text.span);
        }
        let minimum_of = self.optional(meaning.minimum_of.as_ref(), signature);
        let to_infinity = self.approach(meaning);
        let mut found = Vec::new();
        for (k, text) in meaning.of.iter().enumerate() {
            let Some(of) = self.optional(Some(text), signature) else {
                continue;
            };
            let compared = meaning.to.get(k).or(meaning.to.first());
            let infinite = meaning.predicate == Predicate::TendsTo
                && compared.is_some_and(|t| INFINITY.contains(&t.text.trim()));
            let to = match compared {
                Some(text) if !infinite => self.optional(Some(text), signature),
                _ => None,
            };
            for letters in &choices {
                let others = fixed.iter().copied().filter(|s| !letters.contains(s));
                found.push(Proposition {
                    predicate: meaning.predicate,
                    of: of.clone(),
                    letters: letters.clone(),
                    groups: groups.clone(),
                    to: to.clone(),
                    at: at.clone(),
                    to_infinity,
                    minimum_of: minimum_of.clone(),
                    fixed: others.collect(),
                    normalised: meaning.normalised,
                    only_in_box: meaning.only_in_box,
                    around: around.clone(),
                    times: meaning.times.clone(),
                    tolerance: meaning.tolerance.clone(),
                });
            }
        }
        found
    }

    fn optional(&mut self, text: Option<&Text>, signature: &Signature) -> Option<Expr> {
        let text = text?;
        let result = latex::parse_expr(&text.text, text.span.start, signature);
        self.keep(result)
    }

    /// Declared symbols that are no functions.
    fn constants(&mut self, texts: &[Text]) -> Vec<usize> {
        let mut found = Vec::new();
        for text in texts {
            let Some(name) = self.parse_name(text) else {
                continue;
            };
            let node = self.names.whole.get(&latex::canonical(&name)).copied();
            match node {
                Some(Node::Symbol(symbol)) if self.symbols[symbol].function_of.is_none() => {
                    found.push(symbol);
                }
                _ => self.error(
                    DiagnosticKind::Unexpected {
                        found: format!("`{}`", text.text),
                        expected: "a constant letter from the table of symbols".into(),
                    },
                    text.span,
                ),
            }
        }
        found
    }

    fn with_values(&mut self, symbols: &[usize], texts: &[Text]) {
        for (symbol, text) in symbols.iter().zip(texts) {
            let symbol = &self.symbols[*symbol];
            if symbol.value.is_none() || !symbol.range.is_positive() {
                let kind = DiagnosticKind::Unexpected {
                    found: format!("`{}`", text.text),
                    expected: "a positive letter with a reference value".into(),
                };
                self.error(kind, text.span);
            }
        }
    }

    fn approach(&mut self, meaning: &document::Meaning) -> bool {
        let Some(text) = &meaning.approach else {
            return false;
        };
        let infinite = INFINITY.contains(&text.text.trim());
        if !infinite && text.text.trim() != "0" {
            self.error(
                DiagnosticKind::UnknownWord {
                    word: text.text.clone(),
                    known: vec!["0".into(), "\\infty".into()],
                },
                text.span,
            );
        }
        infinite
    }
}

/// How a document writes infinity.
const INFINITY: [&str; 2] = ["\\infty", "infinity"];
