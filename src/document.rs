//! A document: Markdown whose fences hold the equations of a paper and what the letters are.
//!
//! Only fenced code blocks whose first word is `math`, `statement` or `toml` count; everything else is for
//! the reader. Every part keeps its place in the whole text, so that each later stage can
//! point at it. The format is described in `proofs/README.md`.

mod equation;
pub mod figure;
mod lookalike;
mod markdown;
mod number;
mod numeric;
mod paper;
mod references;
mod size;
mod statement;
mod symbols;
mod table;

/// The bytes of a file, one more than so many at most. What is no file of its own, such as a pipe or a
/// device, may have no end, or nobody who writes to it.
pub(crate) fn bytes_of(path: &Path, limit: usize) -> std::io::Result<Vec<u8>> {
    use std::io::{Error, Read};
    let metadata = std::fs::metadata(path)?;
    if metadata.is_dir() {
        return Err(Error::other("this is a folder; name a file in it"));
    }
    if !metadata.is_file() {
        return Err(Error::other(
            "this is a pipe or a device; write the text to a file",
        ));
    }
    let most = metadata.len().min(limit as u64);
    let mut bytes = Vec::with_capacity(most as usize);
    let file = std::fs::File::open(path)?;
    file.take(limit as u64 + 1).read_to_end(&mut bytes)?;
    Ok(bytes)
}

#[cfg(test)]
mod tests;
mod words;

pub use equation::{Equation, Role, Settings, Source, VerdictWord};
pub use figure::{Figure, FigureKind};
pub use number::{EXPONENT_LIMIT, exact_number, write_number};
pub use numeric::{Numeric, Point, SampleRange, Scale};
pub use paper::Paper;
pub use size::{Instance, Size, instance_text};
pub use statement::{Meaning, Predicate, Statement};
pub use symbols::{MatrixShape, Notation, NotationKind, Structure, Symbol};

use crate::diagnostic::{self, Diagnostic, DiagnosticKind, Rejection};
use crate::latex;
use crate::span::Span;
use markdown::Fence;
use num_rational::BigRational;
use std::collections::{BTreeMap, BTreeSet};
use std::ops::RangeInclusive;
use std::path::Path;
use table::Fields;
use words::{or, split_word};

/// A piece of a document's text with its place.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Text {
    /// The words.
    pub text: String,
    /// Where they stand.
    pub span: Span,
}

impl Text {
    /// The same with blanks for line ends: a line of what is printed is never one of a document.
    fn on_one_line(mut self) -> Text {
        if self.text.contains(['\n', '\t']) {
            self.text = self.text.replace(['\n', '\t'], " ");
        }
        self
    }
}

/// A paper as an executable document, decoded but not yet read as mathematics.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Document {
    /// The file's name, for messages.
    pub name: String,
    /// The whole text, into which every span points.
    pub text: String,
    /// The title: the table's, else the first heading, else the name.
    pub title: String,
    /// The publication that is checked.
    pub source: Option<Text>,
    /// The paper that it covers a part of, together with the other documents of that paper.
    pub paper: Option<Paper>,
    /// The letters that sizes of matrices depend on, with the values that they are checked for.
    pub instance_letters: Vec<(Text, Vec<usize>)>,
    /// The values that these letters have together: at least one, empty where there are no letters.
    pub instance_values: Vec<Instance>,
    /// The printed equation numbers that the coverage counts, in increasing order without overlap.
    pub equation_numbers: Vec<RangeInclusive<u32>>,
    /// The printed figure numbers that the coverage counts, likewise.
    pub figure_numbers: Vec<RangeInclusive<u32>>,
    /// What the letters are.
    pub symbols: Vec<Symbol>,
    /// What the paper leaves to the reader.
    pub notation: Vec<Notation>,
    /// Where the floating-point comparison looks.
    pub numeric: Option<Numeric>,
    /// The equations in the order of reading.
    pub equations: Vec<Equation>,
    /// The figures in the order of reading.
    pub figures: Vec<Figure>,
    /// The statements in words, in the order of reading.
    pub statements: Vec<Statement>,
    /// Remarks on what the paper writes without saying what it is, or in two ways.
    pub remarks: Vec<Text>,
    /// What its verdicts rest on besides its letters: an example, a kind of function.
    pub rests_on: Option<Text>,
    /// Where it stands among the documents of its paper; the first number that it covers unless told.
    pub order: Option<BigRational>,
}

impl Document {
    /// Reads a file.
    pub fn read(path: &Path) -> Result<Document, Rejection> {
        let name = diagnostic::printable_line(&path.display().to_string()).into_owned();
        let reject = |text: String, kind, span| Rejection {
            name: name.clone(),
            text,
            diagnostics: vec![Diagnostic::new(kind, span)],
        };
        let bytes = bytes_of(path, LARGEST_DOCUMENT).map_err(|error| {
            let kind = DiagnosticKind::Unreadable {
                message: error.to_string(),
            };
            reject(String::new(), kind, Span::default())
        })?;
        if bytes.len() > LARGEST_DOCUMENT {
            let whole = std::fs::metadata(path).map_or(0, |m| m.len() as usize);
            let (size, limit) = (whole.max(bytes.len()), LARGEST_DOCUMENT);
            let what = "a document";
            let kind = DiagnosticKind::TooLong { what, size, limit };
            return Err(reject(String::new(), kind, Span::default()));
        }
        match String::from_utf8(bytes) {
            Ok(text) => match Document::parse(&name, &text) {
                Ok(document) => Ok(document),
                Err(diagnostics) => Err(Rejection {
                    name,
                    text,
                    diagnostics,
                }),
            },
            Err(error) => {
                // The text before the first wrong byte is unchanged, so the place is right in the
                // repaired text too, where a replacement character stands for what is wrong.
                let at = error.utf8_error().valid_up_to();
                let text = String::from_utf8_lossy(error.as_bytes()).into_owned();
                let span = Span::new(at, at + char::REPLACEMENT_CHARACTER.len_utf8());
                Err(reject(text, DiagnosticKind::NotUtf8, span))
            }
        }
    }

    /// Decodes a text; on failure every error of the document is in the list, by place.
    pub fn parse(name: &str, text: &str) -> Result<Document, Vec<Diagnostic>> {
        if text.len() > LARGEST_DOCUMENT {
            let (size, limit) = (text.len(), LARGEST_DOCUMENT);
            let what = "a document";
            let kind = DiagnosticKind::TooLong { what, size, limit };
            return Err(vec![Diagnostic::new(kind, Span::default())]);
        }
        let scanned = markdown::scan(text);
        let heading = scanned.title;
        let mut reader = Reader::new(text);
        let lookalikes = lookalike::lookalikes(text, &scanned.fences, &scanned.comments);
        reader.counts = !lookalikes.is_empty();
        reader.report.extend(lookalikes);
        for fence in &scanned.fences {
            reader.fence(fence);
        }
        reader.attach_settings();
        reader.check_sizes();
        if !reader.counts {
            reader.error(DiagnosticKind::EmptyDocument, Span::default());
        }
        let mut report = reader.report;
        if !report.is_empty() {
            // What is wrong with the characters of the equations, whatever the letters are.
            let bodies = reader.equations.iter().map(|equation| &equation.body);
            report.extend(bodies.flat_map(|body| latex::misprints(&body.text, body.span.start)));
            report.sort_by_key(|diagnostic| diagnostic.span);
            return Err(diagnostic::one_for_each_cause(
                report,
                text,
                BTreeSet::new(),
            ));
        }
        Ok(Document {
            name: name.into(),
            text: text.into(),
            title: reader
                .title
                .map(|title| title.text)
                .or_else(|| Some(diagnostic::printable_line(&heading?).into_owned()))
                .unwrap_or_else(|| name.into()),
            source: reader.source,
            paper: reader.paper,
            instance_letters: reader.instance_letters,
            instance_values: reader.instance_values,
            equation_numbers: reader.equation_numbers,
            figure_numbers: reader.figure_numbers,
            symbols: reader.symbols,
            notation: reader.notation,
            numeric: reader.numeric,
            equations: reader.equations,
            figures: reader.figures,
            statements: reader.statements,
            remarks: reader.remarks,
            rests_on: reader.rests_on,
            order: reader.order,
        })
    }

    /// The equation under a label.
    pub fn equation(&self, label: &str) -> Option<&Equation> {
        self.equations
            .iter()
            .find(|equation| equation.label.text == label)
    }

    /// Every combination of values of the letters that sizes depend on; one empty combination where
    /// there are no such letters.
    pub fn instances(&self) -> Vec<Instance> {
        self.instance_values.clone()
    }

    /// The printed numbers that the coverage counts, one by one.
    pub fn announced_numbers(&self) -> impl Iterator<Item = u32> + '_ {
        self.equation_numbers.iter().cloned().flatten()
    }

    /// The printed figure numbers that the coverage counts, one by one.
    pub fn announced_figures(&self) -> impl Iterator<Item = u32> + '_ {
        self.figure_numbers.iter().cloned().flatten()
    }

    /// Where it stands among the documents of its paper: as it says, or by the first number that it
    /// covers; what covers none comes last.
    pub fn order(&self) -> BigRational {
        let first = self.announced_numbers().next().unwrap_or(u32::MAX);
        let own = self.order.clone();
        own.unwrap_or_else(|| BigRational::from_integer(first.into()))
    }

    /// The figure under a label.
    pub fn figure(&self, label: &str) -> Option<&Figure> {
        self.figures.iter().find(|f| f.label.text == label)
    }

    /// These diagnostics of a later stage together with the text that they point into.
    pub fn reject(&self, diagnostics: Vec<Diagnostic>) -> Rejection {
        Rejection {
            name: self.name.clone(),
            text: self.text.clone(),
            diagnostics,
        }
    }
}

/// The largest document that is read, in bytes.
pub const LARGEST_DOCUMENT: usize = 4 << 20;

/// The first words of the fences that count.
const LANGUAGES: [&str; 3] = ["math", "statement", "toml"];

/// The tables that are not the settings of an equation.
const TABLES: [&str; 5] = ["document", "symbols", "notation", "numeric", "figure"];

/// The parts collected so far, and all that is wrong with them.
struct Reader<'t> {
    text: &'t str,
    report: Vec<Diagnostic>,
    /// Whether some fence counts.
    counts: bool,
    title: Option<Text>,
    source: Option<Text>,
    paper: Option<Paper>,
    remarks: Vec<Text>,
    rests_on: Option<Text>,
    order: Option<BigRational>,
    instance_letters: Vec<(Text, Vec<usize>)>,
    instance_values: Vec<Instance>,
    equation_numbers: Vec<RangeInclusive<u32>>,
    figure_numbers: Vec<RangeInclusive<u32>>,
    symbols: Vec<Symbol>,
    notation: Vec<Notation>,
    numeric: Option<Numeric>,
    equations: Vec<Equation>,
    figures: Vec<Figure>,
    statements: Vec<Statement>,
    /// The settings by label, which may stand before or after their equation.
    settings: Vec<(Text, table::Entries)>,
    /// Where each label, name of a letter and single table stood first.
    labels: BTreeMap<String, Span>,
    names: BTreeMap<String, Span>,
    single: BTreeMap<String, Span>,
    figure_labels: BTreeMap<String, Span>,
}

impl<'t> Reader<'t> {
    fn new(text: &'t str) -> Self {
        Reader {
            text,
            report: Vec::new(),
            counts: false,
            title: None,
            source: None,
            paper: None,
            remarks: Vec::new(),
            rests_on: None,
            order: None,
            instance_letters: Vec::new(),
            instance_values: vec![Instance::new()],
            equation_numbers: Vec::new(),
            figure_numbers: Vec::new(),
            symbols: Vec::new(),
            notation: Vec::new(),
            numeric: None,
            equations: Vec::new(),
            figures: Vec::new(),
            statements: Vec::new(),
            settings: Vec::new(),
            labels: BTreeMap::new(),
            names: BTreeMap::new(),
            single: BTreeMap::new(),
            figure_labels: BTreeMap::new(),
        }
    }

    fn error(&mut self, kind: DiagnosticKind, span: Span) {
        self.report.push(Diagnostic::new(kind, span));
    }

    fn fence(&mut self, fence: &Fence) {
        let (language, rest) = split_word(self.text, fence.info);
        if !LANGUAGES.contains(&language.text.as_str()) {
            return;
        }
        self.counts = true;
        if !fence.closed {
            let delimiter = "```".into();
            self.error(DiagnosticKind::Unbalanced { delimiter }, fence.info);
        }
        let (label, rest) = split_word(self.text, rest);
        match language.text.as_str() {
            "math" => self.equation(fence, label, rest),
            "statement" => self.statement(fence, label, rest),
            _ => self.table(fence, label, rest),
        }
    }

    fn equation(&mut self, fence: &Fence, label: Text, rest: Span) {
        let (role_word, arguments) = split_word(self.text, rest);
        self.label(fence, &label);
        let words = &self.text[arguments.start..arguments.end];
        let role = match role_word.text.as_str() {
            "define" => Role::Define,
            "claim" => Role::Claim,
            "recall" => Role::Recall,
            "solve" => {
                let targets = equation::targets(words, arguments.start);
                if targets.is_empty() {
                    self.error(
                        DiagnosticKind::Unexpected {
                            found: "nothing after `solve`".into(),
                            expected: "the names to solve for, as in `solve x, y`".into(),
                        },
                        role_word.span,
                    );
                }
                Role::Solve(targets)
            }
            // Without a proper label the role cannot be told either: one message is enough.
            _ if !equation::is_label(&label.text)
                || equation::ROLES.contains(&label.text.as_str()) =>
            {
                return;
            }
            _ => {
                let role = role_word.text.clone();
                self.error(
                    DiagnosticKind::UnknownRole { role },
                    or(role_word.span, fence.info),
                );
                return;
            }
        };
        if !matches!(role, Role::Solve(_)) && !words.is_empty() {
            self.error(
                DiagnosticKind::Unexpected {
                    found: format!("`{words}`"),
                    expected: format!("nothing after `{}`", role_word.text),
                },
                arguments,
            );
        }
        self.equations.push(Equation {
            label,
            role,
            body: Text {
                text: fence.body.clone(),
                span: fence.body_span,
            },
            settings: Settings::default(),
        });
    }

    fn statement(&mut self, fence: &Fence, label: Text, rest: Span) {
        self.label(fence, &label);
        self.nothing_more(rest);
        self.statements.push(Statement {
            label,
            sentence: Text {
                text: fence.body.split_whitespace().collect::<Vec<_>>().join(" "),
                span: fence.body_span,
            },
            settings: Settings::default(),
            own: false,
            alternatives: false,
            meaning: None,
        });
    }

    /// Refuses what cannot be a label, and one that was used before.
    fn label(&mut self, fence: &Fence, label: &Text) {
        if !equation::is_label(&label.text) || equation::ROLES.contains(&label.text.as_str()) {
            let found = label.text.clone();
            self.error(
                DiagnosticKind::BadLabel { found },
                or(label.span, fence.info),
            );
        } else if let Some(&first) = self.labels.get(&label.text) {
            self.report.push(Diagnostic {
                kind: DiagnosticKind::DuplicateLabel {
                    label: label.text.clone(),
                },
                span: label.span,
                related: Some(first),
            });
        } else {
            self.labels.insert(label.text.clone(), label.span);
        }
    }

    fn nothing_more(&mut self, rest: Span) {
        if rest.start < rest.end {
            let found = format!("`{}`", &self.text[rest.start..rest.end]);
            let expected = "nothing more on this line".into();
            self.error(DiagnosticKind::Unexpected { found, expected }, rest);
        }
    }

    fn table(&mut self, fence: &Fence, label: Text, rest: Span) {
        if label.text == "figure" {
            return self.figure(fence, rest);
        }
        self.nothing_more(rest);
        let entries = table::parse(&fence.body, fence.body_span.start, &mut self.report);
        // Of these two tables there is one; symbols and notation may be spread over several.
        if matches!(label.text.as_str(), "document" | "numeric")
            && let Some(first) = self.single.insert(label.text.clone(), label.span)
        {
            self.report.push(Diagnostic {
                kind: DiagnosticKind::DuplicateLabel {
                    label: label.text.clone(),
                },
                span: label.span,
                related: Some(first),
            });
        }
        match label.text.as_str() {
            "document" => self.document(entries),
            "symbols" => {
                let decoded = symbols::symbols(entries, &mut self.report);
                self.declare(decoded.iter().map(|symbol| &symbol.name));
                self.symbols.extend(decoded);
            }
            "notation" => {
                let decoded = symbols::notation(entries, &mut self.report);
                // That a matrix is a covariance is said beside what else determines it.
                let names = decoded
                    .iter()
                    .filter(|n| !matches!(n.kind, NotationKind::CovarianceOf(..)));
                self.declare(names.map(|notation| &notation.name));
                self.notation.extend(decoded);
            }
            "numeric" => {
                let decoded = numeric::numeric(entries, fence.body_span, &mut self.report);
                self.numeric = Some(decoded);
            }
            word if equation::is_label(word) => self.settings.push((label, entries)),
            _ => {
                let found = label.text.clone();
                self.error(
                    DiagnosticKind::BadLabel { found },
                    or(label.span, fence.info),
                );
            }
        }
    }

    fn document(&mut self, entries: table::Entries) {
        let mut fields = Fields::new(entries, &mut self.report);
        self.title = fields.words("title");
        self.source = fields.words("source");
        let numbers = fields.text("equations");
        let figures = fields.text("figures");
        let paper = fields.take("paper");
        let remarks = fields.texts("remarks").into_iter();
        self.remarks = remarks.map(Text::on_one_line).collect();
        self.rests_on = fields.text("rests_on");
        self.order = fields.number("order").map(|(order, _)| order);
        let instances = fields.take("instances");
        (self.instance_letters, self.instance_values) = size::named(instances, fields.report());
        self.equation_numbers = paper::numbers(numbers, fields.report());
        self.figure_numbers = paper::numbers(figures, fields.report());
        self.paper = paper.and_then(|value| paper::paper(value, fields.report()));
        fields.finish();
    }

    fn figure(&mut self, fence: &Fence, rest: Span) {
        let (label, more) = split_word(self.text, rest);
        if more.start < more.end {
            let found = format!("`{}`", &self.text[more.start..more.end]);
            let expected = "nothing more on this line".into();
            self.error(DiagnosticKind::Unexpected { found, expected }, more);
        }
        if !equation::is_label(&label.text) {
            let found = label.text.clone();
            let span = or(label.span, fence.info);
            self.error(DiagnosticKind::BadLabel { found }, span);
        } else if let Some(first) = self.figure_labels.insert(label.text.clone(), label.span) {
            self.report.push(Diagnostic {
                kind: DiagnosticKind::DuplicateLabel {
                    label: label.text.clone(),
                },
                span: label.span,
                related: Some(first),
            });
        }
        let entries = table::parse(&fence.body, fence.body_span.start, &mut self.report);
        let figure = figure::figure(label, entries, fence.body_span, &mut self.report);
        self.figures.extend(figure);
    }

    /// Sizes depend on declared letters only.
    fn check_sizes(&mut self) {
        let known: Vec<String> = self
            .instance_letters
            .iter()
            .map(|(letter, _)| letter.text.clone())
            .collect();
        let shapes = self
            .symbols
            .iter()
            .filter_map(|symbol| Some((symbol.shape.as_ref()?, symbol.name.span)))
            .flat_map(|(shape, span)| [(&shape.rows, span), (&shape.columns, span)]);
        let orders = self
            .notation
            .iter()
            .filter_map(|notation| match &notation.kind {
                NotationKind::Identity(order) => Some((order, notation.name.span)),
                _ => None,
            });
        let unknown: Vec<Diagnostic> = shapes
            .chain(orders)
            .filter_map(|(size, span)| {
                let letter = size.letter.clone().filter(|l| !known.contains(l))?;
                let known = known.clone();
                let kind = DiagnosticKind::UnknownWord {
                    word: letter,
                    known,
                };
                Some(Diagnostic::new(kind, span))
            })
            .collect();
        self.report.extend(unknown);
        self.report.dedup();
    }

    /// Notes where names are declared, and refuses a second declaration in the same spelling.
    fn declare<'n>(&mut self, names: impl Iterator<Item = &'n Text>) {
        for name in names {
            match self.names.get(&name.text) {
                None => {
                    self.names.insert(name.text.clone(), name.span);
                }
                Some(&first) => self.report.push(Diagnostic {
                    kind: DiagnosticKind::DuplicateName {
                        name: name.text.clone(),
                    },
                    span: name.span,
                    related: Some(first),
                }),
            }
        }
    }

    /// Gives every settings table to its equation, then asks each recalled equation for its reason.
    fn attach_settings(&mut self) {
        let mut with_predicate: Vec<String> = Vec::new();
        for (label, entries) in std::mem::take(&mut self.settings) {
            let mut statements = self.statements.iter_mut();
            if let Some(statement) = statements.find(|s| s.label.text == label.text) {
                if entries.iter().any(|(key, _)| key.text == "predicate") {
                    with_predicate.push(label.text.clone());
                }
                statement::settings(entries, label.span, statement, &mut self.report);
                continue;
            }
            let equation = self
                .equations
                .iter_mut()
                .find(|equation| equation.label.text == label.text);
            match equation {
                Some(equation) => {
                    equation::settings(entries, &mut equation.settings, &mut self.report);
                }
                // An equation whose fence was refused already has its message.
                None if self.labels.contains_key(&label.text) => {}
                None => {
                    let kind = DiagnosticKind::UnknownLabel {
                        label: label.text,
                        tables: TABLES.map(Into::into).into(),
                    };
                    self.report.push(Diagnostic::new(kind, label.span));
                }
            }
        }
        references::check(&self.equations, &self.statements, &mut self.report);
        for equation in &self.equations {
            if equation.role == Role::Recall && equation.settings.reason.is_none() {
                let kind = DiagnosticKind::MissingReason {
                    label: equation.label.text.clone(),
                };
                self.report.push(Diagnostic::new(kind, equation.label.span));
            }
        }
        for statement in &self.statements {
            let label = statement.label.text.clone();
            if statement.settings.reason.is_none() && !with_predicate.contains(&label) {
                let kind = DiagnosticKind::MissingMeaning { label };
                self.report
                    .push(Diagnostic::new(kind, statement.label.span));
            }
        }
    }
}
