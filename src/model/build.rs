//! From a document to a model: tables first, then every equation's definitions, then its claims;
//! all errors are collected before any is reported.

use super::conditions::Conditions;
use super::letters::{MOST_LETTERS, letters, reserve};
use super::links::{self, Place};
use super::matrices::{self, MatrixSymbol};
use super::names::{self, Names};
use super::range::{Numbers, Range};
use super::statement::Statement;
use super::{
    Covariance, Definition, DefinitionKind, Equation, Hypothesis, Letter, Model, Node, Notation,
    NotationKind, Role, Symbol, System,
};
use crate::diagnostic::{self, Diagnostic, DiagnosticKind};
use crate::document::{self, Document, Instance, MatrixShape};
use crate::expr::{Bracket, Expr, ExprKind, Name, Relation};
use crate::latex::{self, Signature};
use crate::span::Span;
use num_traits::ToPrimitive;
use ratpoly::{Order, Ring};
use std::collections::{BTreeMap, BTreeSet};

/// The largest range that an index may be declared to run over.
const LARGEST_RANGE: i64 = 1000;

impl Model {
    /// Reads a document as mathematics.
    ///
    /// # Errors
    /// Everything that is wrong with it, in the order of the text.
    pub fn build(document: &Document) -> Result<Model, Vec<Diagnostic>> {
        let mut builder = Builder::default();
        builder.symbols(document);
        builder.admit_points(document);
        let signature = builder.signature(document);
        builder.notation(document, &signature);
        builder.equations(document, &signature);
        builder.statements(document, &signature);
        builder.definitions();
        builder.covariances();
        builder.claims();
        builder.finish(document, signature)
    }
}

/// Running indices by canonical name, and their first and last values.
type Running = (Vec<String>, Vec<(i64, i64)>);

#[derive(Default)]
pub(super) struct Builder {
    report: Vec<Diagnostic>,
    pub(super) symbols: Vec<Symbol>,
    matrices: Vec<MatrixSymbol>,
    notation: Vec<Notation>,
    definitions: Vec<Definition>,
    systems: Vec<System>,
    equations: Vec<Equation>,
    pub(super) statements: Vec<Statement>,
    pub(super) names: Names,
    arguments: BTreeSet<String>,
    /// The covariances of the notation, which stand for themselves where nothing else gives their
    /// names a value.
    covariances: Vec<(Name, Node, Span)>,
    /// The names that equations which cannot be read begin with.
    unread: BTreeSet<String>,
    /// The letters that sizes depend on.
    sizes: BTreeSet<String>,
    /// Where each name got its meaning, for the second place of a duplicate.
    places: BTreeMap<String, Span>,
}

impl Builder {
    pub(super) fn error(&mut self, kind: DiagnosticKind, span: Span) {
        self.report.push(Diagnostic::new(kind, span));
    }

    pub(super) fn keep<T>(&mut self, result: Result<T, Vec<Diagnostic>>) -> Option<T> {
        result
            .map_err(|mut errors| self.report.append(&mut errors))
            .ok()
    }

    pub(super) fn parse_name(&mut self, text: &document::Text) -> Option<Name> {
        let result = latex::parse_name(&text.text, text.span.start);
        self.keep(result)
    }

    /// Gives a whole name its meaning; a second one is an error.
    fn bind(&mut self, name: &Name, node: Node, span: Span) {
        let key = latex::canonical(name);
        if let Some(first) = self.places.get(&key) {
            let first = *first;
            self.report.push(Diagnostic {
                related: Some(first),
                ..Diagnostic::new(DiagnosticKind::DuplicateName { name: key }, span)
            });
            return;
        }
        self.places.insert(key.clone(), span);
        if let Some(indices) = names::literal_indices(name) {
            self.names
                .elements
                .insert((names::family_key(name), indices), node);
        }
        self.names.whole.insert(key, node);
    }

    fn symbols(&mut self, document: &Document) {
        let mut largest = Instance::new();
        for (letter, values) in &document.instance_letters {
            // A size has its meaning: no equation gives it another one.
            self.places.insert(letter.text.clone(), letter.span);
            self.sizes.insert(letter.text.clone());
            largest.insert(
                letter.text.clone(),
                values.iter().copied().max().unwrap_or(1),
            );
        }
        for (declared, symbol) in document.symbols.iter().enumerate() {
            let Some(name) = self.parse_name(&symbol.name) else {
                continue;
            };
            let arguments: Vec<Name> = symbol
                .arguments
                .iter()
                .filter_map(|text| self.parse_name(text))
                .collect();
            self.arguments
                .extend(arguments.iter().map(latex::canonical));
            let value = Symbol {
                range: self.range(symbol, &name),
                name,
                value: symbol.value.clone(),
                unit: symbol.unit.as_ref().map(|u| u.text.clone()),
                meaning: symbol
                    .meaning
                    .as_ref()
                    .map_or_else(String::new, |m| m.text.clone()),
                function_of: arguments.last().cloned(),
                arguments,
                declared,
                entry_of: None,
            };
            match &symbol.shape {
                None => {
                    let node = Node::Symbol(self.symbols.len());
                    self.bind(&value.name, node, symbol.name.span);
                    self.symbols.push(value);
                }
                Some(shape) => self.matrix(&value, shape, &largest, symbol.name.span),
            }
        }
    }

    /// The values of named points are values that the letters may have.
    fn admit_points(&mut self, document: &Document) {
        let Some(numeric) = &document.numeric else {
            return;
        };
        for (letter, value) in numeric.points.iter().flat_map(|point| &point.values) {
            self.admit(letter, value);
        }
    }

    /// An error where a letter may not have a value.
    fn admit(&mut self, letter: &document::Text, value: &num_rational::BigRational) {
        let Ok(name) = latex::parse_name(&letter.text, letter.span.start) else {
            return;
        };
        let node = self.names.whole.get(&latex::canonical(&name));
        if let Some(Node::Symbol(symbol)) = node
            && !self.symbols[*symbol].range.contains(value)
        {
            let found = format!("`{} = {}`", letter.text, document::write_number(value));
            let expected = "a value that the declaration of the letter admits".into();
            self.error(DiagnosticKind::Unexpected { found, expected }, letter.span);
        }
    }

    /// Which numbers a symbol stands for.
    fn range(&mut self, symbol: &document::Symbol, name: &Name) -> Range {
        let mut range = match symbol.positive {
            true => Range::positive(),
            false => Range::default(),
        };
        range.numbers = symbol.domain;
        let Some(text) = &symbol.range else {
            return range;
        };
        let signature = Signature::default();
        let result = latex::parse_chain(&text.text, text.span.start, &signature);
        let Some(chain) = self.keep(result) else {
            return range;
        };
        let number = |e: &Expr| names::literal_number(e);
        let is_letter = |e: &Expr| matches!(&e.kind, ExprKind::Name(n) if n == name);
        let mut understood = symbol.domain != Numbers::Complex;
        for (sides, relation) in chain.members.windows(2).zip(&chain.relations) {
            let (left, right) = (&sides[0], &sides[1]);
            let (from_below, value) = match (number(left), number(right)) {
                (Some(n), None) if is_letter(right) => (true, n),
                (None, Some(n)) if is_letter(left) => (false, n),
                _ => {
                    understood = false;
                    continue;
                }
            };
            understood &= range.compare(*relation, from_below, value);
        }
        let inside = symbol.value.as_ref().is_none_or(|v| range.contains(v));
        if !understood || chain.members.len() < 2 || range.is_empty() || !inside {
            let expected = match (understood, inside) {
                (true, false) => "a range that the letter's value lies in".into(),
                _ => format!(
                    "the letter between numbers, such as 0 < {} < 2",
                    latex::canonical(name)
                ),
            };
            let found = text.text.clone();
            self.error(DiagnosticKind::Unexpected { found, expected }, text.span);
        }
        range
    }

    /// A declared matrix and the symbols of its entries.
    fn matrix(&mut self, symbol: &Symbol, shape: &MatrixShape, largest: &Instance, span: Span) {
        let (rows, columns) = (shape.rows.at(largest), shape.columns.at(largest));
        let count = self.symbols.len() + rows * columns;
        if count > MOST_LETTERS {
            let limit = MOST_LETTERS;
            self.error(DiagnosticKind::TooManyLetters { count, limit }, span);
            return;
        }
        let index = self.matrices.len();
        self.bind(&symbol.name, Node::Matrix(index), span);
        let mut letters = Vec::new();
        for (i, j) in (0..rows).flat_map(|i| (0..columns).map(move |j| (i, j))) {
            if matrices::own_letter(shape.structure, i, j) != (Some((i, j)), false) {
                continue;
            }
            letters.push(((i, j), self.symbols.len()));
            self.symbols.push(Symbol {
                name: matrices::entry_name(&symbol.name, (rows, columns), i, j),
                entry_of: Some((index, i, j)),
                ..symbol.clone()
            });
        }
        self.matrices.push(MatrixSymbol {
            name: symbol.name.clone(),
            shape: shape.clone(),
            unit: symbol.unit.clone(),
            meaning: symbol.meaning.clone(),
            arguments: symbol.arguments.clone(),
            declared: symbol.declared,
            letters,
        });
    }

    fn signature(&mut self, document: &Document) -> Signature {
        let mut signature = Signature::default();
        let scalars = self.symbols.iter().filter(|s| s.entry_of.is_none());
        let scalars = scalars.map(|s| (&s.name, &s.arguments));
        let matrices = self.matrices.iter().map(|m| (&m.name, &m.arguments));
        for (name, arguments) in scalars.chain(matrices) {
            if arguments.is_empty() {
                signature.declare(name);
            } else {
                signature.declare_function(name, arguments);
            }
        }
        for matrix in &self.matrices {
            let one = |size: &document::Size| size.factor == 1 && size.letter.is_none();
            let column = one(&matrix.shape.columns) && !one(&matrix.shape.rows);
            let shape = match column {
                true => latex::Shape::Column,
                false => latex::Shape::Matrix,
            };
            signature.declare_shape(&matrix.name, shape);
        }
        for notation in &document.notation {
            if let Ok(name) = latex::parse_name(&notation.name.text, notation.name.span.start) {
                match notation.kind {
                    document::NotationKind::Dirac => signature.declare_function(&name, &[]),
                    document::NotationKind::EntryOf(_) => signature.declare_entries(&name),
                    _ => signature.declare(&name),
                }
            }
        }
        for equation in &document.equations {
            signature.declare_definitions(&equation.body.text);
            signature.note_uses(&equation.body.text);
            let settings = &equation.settings;
            for text in settings.assume.iter().chain(&settings.given) {
                signature.note_uses(&text.text);
            }
        }
        signature
    }

    fn notation(&mut self, document: &Document, signature: &Signature) {
        use document::NotationKind as Written;
        for entry in &document.notation {
            let Some(name) = self.parse_name(&entry.name) else {
                continue;
            };
            let mut target = |text: &document::Text| {
                let result = latex::parse_expr(&text.text, text.span.start, signature);
                self.keep(result)
            };
            let kind = match &entry.kind {
                Written::Identity(n) => Some(NotationKind::Identity(n.clone())),
                Written::Zero => Some(NotationKind::Zero),
                Written::CharacteristicCoefficientOf(t) => {
                    target(t).map(NotationKind::CharacteristicCoefficient)
                }
                Written::CofactorOf(t) => target(t).map(NotationKind::Cofactor),
                Written::LeadingMinorOf(t) => target(t).map(NotationKind::LeadingMinor),
                Written::EntryOf(t) => target(t).map(NotationKind::Entry),
                Written::Means(t) => target(t).map(NotationKind::Means),
                Written::RowsOf(t) => target(t).map(NotationKind::Rows),
                Written::HurwitzMatrixOf(t) => target(t).map(NotationKind::HurwitzMatrix),
                Written::CovarianceOf(left, right) => {
                    let left = target(left);
                    let right = right.as_ref().map_or_else(|| left.clone(), target);
                    left.zip(right).map(|(l, r)| covariance(l, r))
                }
                Written::Constant(constant) => Some(NotationKind::Constant(*constant)),
                Written::Dirac => Some(NotationKind::Dirac),
            };
            let Some(kind) = kind else { continue };
            let node = Node::Notation(self.notation.len());
            if matches!(kind, NotationKind::Covariance(_)) {
                self.covariances.push((name.clone(), node, entry.name.span));
                self.notation.push(Notation { name, kind });
                continue;
            }
            let arity = match kind {
                NotationKind::CharacteristicCoefficient(_) | NotationKind::LeadingMinor(_) => 1,
                NotationKind::Cofactor(_) | NotationKind::Entry(_) => 2,
                _ => 0,
            };
            let span = entry.name.span;
            if arity == 0 {
                self.bind(&name, node, span);
            } else {
                let indices = name.subscript.as_ref().map_or(0, |s| s.indices.len());
                if indices == arity {
                    self.bind_family(names::family_key(&name), arity, node, span);
                } else {
                    self.error(
                        DiagnosticKind::Unexpected {
                            found: format!("{indices} indices"),
                            expected: format!("{arity}, separated by commas"),
                        },
                        span,
                    );
                }
            }
            self.notation.push(Notation { name, kind });
        }
    }

    fn bind_family(&mut self, key: String, arity: usize, node: Node, span: Span) {
        let shown = format!("{key}_{}", ["", "i", "{i,j}"][arity.min(2)]);
        if let Some(first) = self.places.insert(shown.clone(), span) {
            self.report.push(Diagnostic {
                related: Some(first),
                ..Diagnostic::new(DiagnosticKind::DuplicateName { name: shown }, span)
            });
        }
        self.names.families.insert((key, arity), node);
    }

    fn equations(&mut self, document: &Document, signature: &Signature) {
        for equation in &document.equations {
            let body = &equation.body;
            let result = latex::parse_printed(&body.text, body.span.start, signature);
            let Some((mut display, readings)) = self.keep(result) else {
                // What it would define is not undeclared as well.
                self.unread.extend(latex::heads(&body.text));
                continue;
            };
            let mut settings = equation.settings.clone();
            let conditions = match equation.role {
                document::Role::Claim => self.conditions(&mut display),
                _ => Conditions::default(),
            };
            settings.assume.extend(conditions.texts);
            if matches!(equation.role, document::Role::Solve(_)) {
                self.refuse_unsolvable(&display);
            }
            if matches!(equation.role, document::Role::Define) {
                self.refuse_shared_ranges(&display);
            }
            if !matches!(equation.role, document::Role::Recall) {
                let claim = matches!(equation.role, document::Role::Claim);
                self.refuse_clauses(&display, claim);
            }
            let given = equation
                .settings
                .given
                .iter()
                .flat_map(|text| self.hypotheses(text, signature))
                .collect();
            let assume = equation
                .settings
                .assume
                .iter()
                .flat_map(|text| self.hypotheses(text, signature))
                .chain(conditions.hypotheses)
                .collect();
            let role = match &equation.role {
                document::Role::Define => Role::Define,
                document::Role::Solve(_) => Role::Solve,
                document::Role::Claim => Role::Claim,
                document::Role::Recall => Role::Recall(
                    equation
                        .settings
                        .reason
                        .as_ref()
                        .map_or_else(String::new, |r| r.text.clone()),
                ),
            };
            let index = self.equations.len();
            if let document::Role::Solve(targets) = &equation.role {
                let unknowns: Vec<Name> =
                    targets.iter().filter_map(|t| self.parse_name(t)).collect();
                for (position, (name, text)) in unknowns.iter().zip(targets).enumerate() {
                    let node = Node::Unknown {
                        system: self.systems.len(),
                        position,
                    };
                    self.bind(name, node, text.span);
                }
                self.systems.push(System {
                    equation: index,
                    unknowns,
                });
            }
            let links = links::links(&display);
            self.equations.push(Equation {
                label: equation.label.text.clone(),
                role,
                source: body.text.clone(),
                defines: vec![None; links.len()],
                links,
                display,
                settings,
                given,
                assume,
                readings,
                span: body.span,
            });
        }
    }

    /// What a text supposes: the neighbours of each of its chains.
    fn hypotheses(&mut self, text: &document::Text, signature: &Signature) -> Vec<Hypothesis> {
        let result = latex::parse_display(&text.text, text.span.start, signature);
        let Some(display) = self.keep(result) else {
            return Vec::new();
        };
        let mut found = Vec::new();
        let mut complete = true;
        for (k, clause) in display.clauses.iter().enumerate() {
            // All of them are supposed: one of several is not, nor is one under the condition of another.
            let joined = clause.joined.as_deref();
            if joined.is_some_and(|word| k == 0 || !matches!(word, "and" | "with" | "where")) {
                let found = format!("`{}`", joined.unwrap_or_default());
                let expected = "hypotheses that all hold, joined by commas or `and`".into();
                self.error(DiagnosticKind::Unexpected { found, expected }, text.span);
            }
            complete &= !clause.chain.relations.is_empty();
            let members = &clause.chain.members;
            for (sides, relation) in members.windows(2).zip(&clause.chain.relations) {
                if let [left, right] = sides {
                    found.push(Hypothesis {
                        left: left.clone(),
                        relation: *relation,
                        right: right.clone(),
                        span: left.span.to(right.span),
                    });
                }
            }
        }
        // What is only nearly so proves nothing.
        let meant = |h: &Hypothesis| match h.relation {
            Relation::Equal
            | Relation::NotEqual
            | Relation::Less
            | Relation::LessEqual
            | Relation::Greater
            | Relation::GreaterEqual => true,
            Relation::Distributed | Relation::Approximately | Relation::Tends => false,
        };
        if found.is_empty() || !complete || !found.iter().all(meant) {
            self.error(
                DiagnosticKind::Unexpected {
                    found: text.text.clone(),
                    expected: "an equation or inequality, such as a = 2b or 0 < a < 2".into(),
                },
                text.span,
            );
        }
        found.retain(meant);
        found
    }

    /// The names that `define` blocks and underbraces give values.
    fn definitions(&mut self) {
        for e in 0..self.equations.len() {
            if matches!(self.equations[e].role, Role::Recall(_)) {
                continue;
            }
            for l in 0..self.equations[e].links.len() {
                let link = self.equations[e].links[l];
                let starts = matches!(link.left, Place::Member { member: 0, .. });
                let defining = self.equations[e].role == Role::Define && starts;
                let labelled = matches!(link.right, Place::Body { .. });
                if (defining || labelled) && link.relation == Relation::Equal {
                    self.define(e, l, defining && link.left != link.right);
                }
            }
        }
    }

    /// The covariances whose names no table, equation or `solve` block gives a value.
    fn covariances(&mut self) {
        for (name, node, span) in std::mem::take(&mut self.covariances) {
            if !self.has_meaning(&name, &DefinitionKind::Whole) {
                self.bind(&name, node, span);
            }
        }
    }

    /// The names that a claim's first member gives values, where nothing else does.
    fn claims(&mut self) {
        // First what has no primes: f' has a meaning where f is a function.
        for primed in [false, true] {
            self.claimed(primed);
        }
    }

    fn claimed(&mut self, primed: bool) {
        for e in 0..self.equations.len() {
            if self.equations[e].role != Role::Claim {
                continue;
            }
            for l in 0..self.equations[e].links.len() {
                let link = self.equations[e].links[l];
                let head = link.left.find(&self.equations[e].display);
                if head.is_some_and(has_primes) == primed
                    && matches!(link.left, Place::Member { member: 0, .. })
                    && link.left != link.right
                    && link.relation == Relation::Equal
                {
                    self.define(e, l, false);
                }
            }
        }
    }

    /// Makes the left side of a link a definition if it is a name; unless `always`, only when the
    /// name has no meaning yet.
    fn define(&mut self, equation: usize, link: usize, always: bool) {
        let index = self.definitions.len();
        if index > MOST_LETTERS {
            // Refused in the end; until then nothing grows with it.
            return;
        }
        let target = self.equations[equation].links[link];
        let display = &self.equations[equation].display;
        let Some(left) = target.left.find(display).cloned() else {
            return;
        };
        let right_name = match target.right.find(display).map(|right| &right.kind) {
            Some(ExprKind::Name(name)) => Some(name.clone()),
            _ => None,
        };
        let ranges = display.clauses[target.left.clause()].ranges.clone();
        let mut place = target.right;
        let (name, kind) = match &left.kind {
            // The value of a process at a number is given, or gives a name its meaning.
            ExprKind::Apply {
                function,
                arguments,
            } if always
                && let [argument] = &arguments[..]
                && let Some(at) = names::literal_number(argument) =>
            {
                match right_name {
                    Some(name) if !self.has_meaning(&name, &DefinitionKind::Whole) => {
                        place = target.left;
                        (name, DefinitionKind::Whole)
                    }
                    _ => (function.clone(), DefinitionKind::ValueAt(at)),
                }
            }
            ExprKind::Name(name) | ExprKind::Apply { function: name, .. } => {
                match self.running_indices(name, &ranges) {
                    Some((indices, ranges)) => {
                        (name.clone(), DefinitionKind::Family { indices, ranges })
                    }
                    None => match names::literal_indices(name) {
                        Some(values) if self.is_family(name) => {
                            (name.clone(), DefinitionKind::Element(values))
                        }
                        _ => (name.clone(), DefinitionKind::Whole),
                    },
                }
            }
            ExprKind::Power { base, exponent } => match (&base.kind, &exponent.kind) {
                (ExprKind::Name(name), ExprKind::Number(n)) if n.is_integer() => {
                    match n.to_integer().to_u32().filter(|n| *n > 0) {
                        Some(n) => (name.clone(), DefinitionKind::Power(n)),
                        None => return,
                    }
                }
                _ => return,
            },
            _ => return,
        };
        if !always && self.has_meaning(&name, &kind) {
            return;
        }
        if !self.can_be_defined(equation, link, &name, &kind, left.span) {
            return;
        }
        let node = Node::Definition(index);
        match &kind {
            DefinitionKind::Whole => self.bind(&name, node, left.span),
            DefinitionKind::Element(values) => {
                self.names
                    .elements
                    .insert((names::family_key(&name), values.clone()), node);
            }
            DefinitionKind::Family { indices, .. } => {
                self.bind_family(names::family_key(&name), indices.len(), node, left.span);
            }
            DefinitionKind::ValueAt(at) => {
                let key = (latex::canonical(&name), at.clone());
                self.names.values.insert(key, index);
            }
            DefinitionKind::Power(n) => {
                self.names
                    .powers
                    .insert((latex::canonical(&name), *n), index);
            }
        }
        self.equations[equation].defines[link] = Some(index);
        self.definitions.push(Definition {
            name,
            kind,
            equation,
            place,
            arguments: self.declared_arguments(&left),
            head: match &left.kind {
                ExprKind::Apply { arguments, .. } if target.left != place => {
                    Some(arguments.clone())
                }
                _ => None,
            },
            letter: None,
        });
    }

    /// Whether an equation may give this name its value: a claim only where more than the name rests
    /// on it, and nobody an index that is computed from letters without a range.
    fn can_be_defined(
        &mut self,
        equation: usize,
        link: usize,
        name: &Name,
        kind: &DefinitionKind,
        span: Span,
    ) -> bool {
        let whole = matches!(kind, DefinitionKind::Whole | DefinitionKind::Power(_));
        let indices = name.subscript.iter().flat_map(|s| &s.indices);
        let mut computed = indices.filter(|i| matches!(i.kind, ExprKind::Sum(_)));
        let computed = whole && computed.any(|i| names::literal_integer(i).is_none());
        let of = &self.equations[equation];
        let target = of.links[link];
        let labels = matches!(target.right, Place::Body { .. });
        let clause = &of.display.clauses[target.left.clause()];
        let where_ = matches!(clause.joined.as_deref(), Some("where" | "with"));
        let claimed = of.role == Role::Claim && !labels;
        if claimed && clause.chain.members.len() < 3 && !where_ || computed {
            let name = latex::canonical(name);
            self.error(DiagnosticKind::Undefined { name }, span);
            return false;
        }
        true
    }

    /// The arguments of `f(x, y)` on a left side, where all of them are declared symbols.
    fn declared_arguments(&self, left: &Expr) -> Vec<Name> {
        let ExprKind::Apply { arguments, .. } = &left.kind else {
            return Vec::new();
        };
        let declared = arguments.iter().map(|argument| match &argument.kind {
            ExprKind::Name(name) => self
                .names
                .whole
                .get(&latex::canonical(name))
                .is_some_and(|node| matches!(node, Node::Symbol(_)))
                .then(|| name.clone()),
            _ => None,
        });
        declared.collect::<Option<_>>().unwrap_or_default()
    }

    fn is_family(&self, name: &Name) -> bool {
        let key = names::family_key(name);
        let declared = self.names.families.keys().any(|(k, _)| *k == key);
        // A family that is defined by a range elsewhere in the document.
        declared
            || self.equations.iter().any(|e| {
                e.role == Role::Define
                    && e.display.clauses.iter().any(|c| {
                        !c.ranges.is_empty()
                            && matches!(&c.chain.members[0].kind,
                                ExprKind::Name(n) if names::family_key(n) == key)
                    })
            })
    }

    fn has_meaning(&self, name: &Name, kind: &DefinitionKind) -> bool {
        let mut fewer = name.clone();
        let whole = (0..=name.dots).any(|dots| {
            fewer.dots = dots;
            self.names.whole.contains_key(&latex::canonical(&fewer))
        });
        let derivative = (1..=name.letter.primes).any(|primes| {
            let function = name.undotted().unprimed(primes);
            function.is_some_and(|f| self.is_function_of_one(&f))
        });
        let key = names::family_key(name);
        let indexed = name.subscript.as_ref().is_some_and(|s| {
            !s.indices.is_empty()
                && s.indices
                    .iter()
                    .all(|i| names::literal_integer(i).is_some())
                // Rows and columns are counted from 1: \mathbf{x}_0 is no entry of \mathbf{x}.
                && (self.names.whole.contains_key(&key)
                    && s.indices.iter().all(|i| names::literal_integer(i) >= Some(1))
                    || self
                        .names
                        .families
                        .keys()
                        .any(|(k, n)| *k == key && (*n == s.indices.len() || *n == 2)))
        });
        let power = match kind {
            DefinitionKind::Power(n) => {
                let key = (latex::canonical(name), *n);
                self.names.powers.contains_key(&key)
            }
            DefinitionKind::Family { indices, .. } => {
                let key = (key, indices.len());
                self.names.families.contains_key(&key)
            }
            _ => false,
        };
        whole || derivative || indexed || power || self.sizes.contains(&latex::canonical(name))
    }

    /// Whether a name is a function of one argument, declared or defined.
    fn is_function_of_one(&self, name: &Name) -> bool {
        match self.names.whole.get(&latex::canonical(name)) {
            Some(Node::Symbol(s)) => self.symbols[*s].arguments.len() == 1,
            Some(Node::Definition(d)) => self.definitions[*d].arguments.len() == 1,
            Some(Node::Matrix(_) | Node::Notation(_) | Node::Unknown { .. }) | None => false,
        }
    }

    /// The running indices of a name with their ranges, if it has any.
    fn running_indices(
        &mut self,
        name: &Name,
        ranges: &[crate::expr::IndexRange],
    ) -> Option<Running> {
        let subscript = name.subscript.as_ref()?;
        let mut indices = Vec::new();
        let mut bounds = Vec::new();
        for index in &subscript.indices {
            let ExprKind::Name(running) = &index.kind else {
                return None;
            };
            let range = ranges.iter().find(|r| r.index == *running)?;
            bounds.push(self.bounds(range)?);
            indices.push(latex::canonical(running));
        }
        (!indices.is_empty()).then_some((indices, bounds))
    }

    fn bounds(&mut self, range: &crate::expr::IndexRange) -> Option<(i64, i64)> {
        let from = names::literal_integer(&range.from);
        let to = names::literal_integer(&range.to);
        let step = names::literal_integer(&range.step);
        match (from, step, to) {
            (Some(from), Some(1), Some(to)) if from <= to && to - from <= LARGEST_RANGE => {
                Some((from, to))
            }
            _ => {
                self.error(
                    DiagnosticKind::Unexpected {
                        found: "this range".into(),
                        expected: format!(
                            "integers in increasing order with step 1, at most {LARGEST_RANGE}"
                        ),
                    },
                    range.from.span.to(range.to.span),
                );
                None
            }
        }
    }

    fn finish(self, document: &Document, signature: Signature) -> Result<Model, Vec<Diagnostic>> {
        let mut report = self.report;
        let mut letters = letters(&self.symbols, &self.matrices, &self.equations);
        let reserve = reserve(&self.equations, &self.notation, &self.definitions);
        letters.extend((0..reserve).map(|slot| Letter::Function { slot }));
        // Refused before anything grows with it: every definition may turn out an abbreviation.
        let count = letters.len() + self.definitions.len();
        if count > MOST_LETTERS {
            report.push(Diagnostic::new(
                DiagnosticKind::TooManyLetters {
                    count,
                    limit: MOST_LETTERS,
                },
                self.equations.first().map_or(Span::default(), |e| e.span),
            ));
            report.sort_by_key(|d| d.span);
            return Err(report);
        }
        // The letters get their names once it is known which definitions are letters too.
        let ring = Ring::new(
            (0..letters.len()).map(|k| format!("letter_{k}")),
            Order::Grevlex,
        );
        let times = super::time::times(&self.symbols, &self.names);
        let mut model = Model {
            document: document.clone(),
            symbols: self.symbols,
            matrices: self.matrices,
            instances: document.instances(),
            notation: self.notation,
            definitions: self.definitions,
            systems: self.systems,
            equations: self.equations,
            statements: self.statements,
            letters,
            // An empty ring serves only to report what else is wrong.
            ring: match ring {
                Ok(ring) => ring,
                Err(_) => return Err(report),
            },
            functions: None,
            arguments: self.arguments,
            times,
            names: self.names,
            signature,
        };
        report.extend(model.check_names());
        report.sort_by_key(|d| d.span);
        let mut report = diagnostic::one_for_each_cause(report, &document.text, self.unread);
        if report.is_empty() {
            report.extend(model.find_cycles());
        }
        if report.is_empty() {
            model.name_abbreviations();
            model.name_moving_arguments();
            return Ok(model);
        }
        report.sort_by_key(|d| d.span);
        report.dedup();
        Err(report)
    }
}

/// Whether an expression is a name with primes, alone or applied.
fn has_primes(expr: &Expr) -> bool {
    matches!(&expr.kind, ExprKind::Name(name) | ExprKind::Apply { function: name, .. }
        if name.letter.primes > 0)
}

/// The covariance of two vectors, with their product spelt out.
fn covariance(left: Expr, right: Expr) -> NotationKind {
    let span = left.span.to(right.span);
    let grouped = |inner: &Expr| match inner.kind {
        ExprKind::Name(_) | ExprKind::Apply { .. } => inner.clone(),
        _ => Expr::new(
            ExprKind::Group {
                bracket: Bracket::Round,
                inner: Box::new(inner.clone()),
            },
            inner.span,
        ),
    };
    // Its own transpose is no power that looks like one, whatever the letter.
    let transposed = match latex::is_matrix_like(&right) {
        true => grouped(&right),
        false => {
            let kind = ExprKind::Matrix {
                rows: vec![vec![right.clone()]],
                bracket: Bracket::None,
            };
            Expr::new(kind, right.span)
        }
    };
    let transposed = Expr::new(ExprKind::Transpose(Box::new(transposed)), right.span);
    let product = Expr::new(ExprKind::Product(vec![grouped(&left), transposed]), span);
    NotationKind::Covariance(Box::new(Covariance {
        left,
        right,
        product,
    }))
}
