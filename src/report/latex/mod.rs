//! The report in LaTeX: what was checked and how, each equation as printed with its verdict and
//! the reasons, the intermediate results, the conditions.
//!
//! Article class and base packages only. Free text passes [`mod@escape`], printed equations pass
//! [`printed`]; nothing else of a document reaches TeX. A display that is too wide for its line is
//! set smaller, step by step.

mod equations;
pub mod escape;
mod figures;
mod floating;
mod grounds;
pub(crate) mod preamble;
pub mod printed;
mod results;
mod statements;
mod summary;
mod units;

use crate::inspection::Inspection;
use crate::paper::papers;
use crate::report::formula::Formulas;
use crate::report::prose::{Block, Prose};
use escape::escape;

/// The whole report on some documents.
pub fn report(inspections: &[Inspection]) -> String {
    let mut tex = Tex::default();
    tex.push(&preamble::preamble(inspections));
    let all = papers(inspections);
    if !all.is_empty() {
        tex.line("\\section*{What was checked}");
    }
    for paper in all {
        tex.paragraph(&Prose::of(format!(
            "{}: {}.",
            paper.title,
            paper.coverage()
        )));
        grounds::write(&mut tex, &paper, inspections);
    }
    if inspections.len() > 1 {
        tex.line("\\tableofcontents");
    }
    let audits: Vec<&crate::audit::Audit> = inspections.iter().map(|i| &i.audit).collect();
    let sheets: Vec<_> = crate::report::errata::sheets(&audits)
        .into_iter()
        .filter(|sheet| !sheet.is_empty())
        .collect();
    for sheet in &sheets {
        let title = match sheets.len() {
            1 => String::new(),
            _ => format!(": {}", escape(&sheet.title)),
        };
        tex.line(&format!("\\section{{What was found{title}}}"));
        crate::report::errata::write(&mut tex, sheet);
    }
    tex.push(preamble::METHOD);
    for inspection in inspections {
        let audit = &inspection.audit;
        let formulas = Formulas::of(&audit.model);
        tex.line(&format!(
            "\n\\keeproom[18]\n\\section{{{}}}",
            preamble::heading(inspection)
        ));
        summary::write(&mut tex, audit, &formulas);
        equations::write(&mut tex, audit, &formulas);
        statements::write(&mut tex, audit, &formulas);
        results::write(&mut tex, audit, &formulas);
        figures::write(&mut tex, audit);
        floating::write(&mut tex, inspection);
        units::write(&mut tex, audit);
    }
    tex.push(&preamble::documents(inspections));
    tex.line("\\end{document}");
    tex.text
}

/// LaTeX as it grows.
#[derive(Debug, Default)]
pub(crate) struct Tex {
    text: String,
}

impl Tex {
    /// The whole text.
    pub(crate) fn finish(self) -> String {
        self.text
    }

    fn push(&mut self, text: &str) {
        self.text.push_str(text);
    }

    pub(crate) fn line(&mut self, line: &str) {
        self.text.push_str(line);
        self.text.push('\n');
    }

    /// A heading below the document's own.
    pub(crate) fn heading(&mut self, title: &str) {
        self.line(&format!("\n\\keeproom\n\\subsection{{{title}}}"));
    }

    /// A paragraph.
    pub(crate) fn paragraph(&mut self, prose: &Prose) {
        let text = prose.to_latex();
        if !text.trim().is_empty() {
            self.line("");
            self.line(text.trim());
        }
    }

    /// Paragraphs as a list.
    pub(crate) fn list(&mut self, items: &[Prose]) {
        let items: Vec<String> = items.iter().map(Prose::to_latex).collect();
        let items: Vec<&str> = items.iter().map(|item| item.trim()).collect();
        if items.iter().all(|item| item.is_empty()) {
            return;
        }
        self.line("\\begin{itemize}\\setlength{\\itemsep}{0pt}");
        for item in items.into_iter().filter(|item| !item.is_empty()) {
            self.line(&format!("\\item {item}"));
        }
        self.line("\\end{itemize}");
    }

    /// The words before a table, with which it stands on one page.
    pub(crate) fn caption(&mut self, prose: &Prose) {
        self.line("\n\\keeproom");
        self.paragraph(prose);
    }

    /// A formula on a line of its own; smaller where it is too wide.
    pub(crate) fn display(&mut self, latex: &str) {
        self.line(&format!("\\fitted{{}}{{{latex}}}"));
    }

    /// A formula with a number.
    pub(crate) fn numbered(&mut self, number: &str, latex: &str) {
        self.line(&format!("\\fitted{{({})}}{{{latex}}}", escape(number)));
    }

    /// A table that may be longer than a page, with columns in these proportions.
    pub(crate) fn table(&mut self, widths: &[f64], head: &[String], rows: &[Vec<String>]) {
        // The gaps between columns are 12pt of a line of 455pt.
        let room = 0.998 - 0.0265 * widths.len().saturating_sub(1) as f64;
        let scale = room / widths.iter().sum::<f64>();
        let columns: String = widths
            .iter()
            .map(|w| (w * scale * 1000.0).floor() / 1000.0)
            .map(|w| format!(">{{\\raggedright\\arraybackslash}}p{{{w}\\linewidth}}"))
            .collect();
        self.line("");
        self.line(&format!("\\begin{{longtable}}{{@{{}}{columns}@{{}}}}"));
        self.line("\\toprule");
        self.line(&format!("{} \\\\", head.join(" & ")));
        self.line("\\midrule\n\\endhead");
        self.line("\\bottomrule\n\\endlastfoot");
        for row in rows {
            self.line(&format!("{} \\\\", row.join(" & ")));
        }
        self.line("\\end{longtable}");
    }

    pub(crate) fn blocks(&mut self, blocks: &[Block]) {
        for (k, block) in blocks.iter().enumerate() {
            match block {
                Block::Paragraph(prose)
                    if matches!(blocks.get(k + 1), Some(Block::Table { .. })) =>
                {
                    self.caption(prose);
                }
                Block::Paragraph(prose) => self.paragraph(prose),
                Block::Display { latex, .. } => self.display(latex),
                Block::Table { head, rows } => {
                    let widths = vec![1.0; head.len()];
                    let head: Vec<String> = head.iter().map(|h| escape(h)).collect();
                    let rows: Vec<Vec<String>> = rows
                        .iter()
                        .map(|row| row.iter().map(Prose::to_latex).collect())
                        .collect();
                    self.table(&widths, &head, &rows);
                }
            }
        }
    }
}
