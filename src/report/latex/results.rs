//! Intermediate results and solutions as formulas.

use super::Tex;
use crate::audit::Audit;
use crate::evaluate::Value;
use crate::matrix::Matrix;
use crate::report::formula::{Formulas, Script, width};
use crate::report::prose::Prose;
use crate::report::values::{Kind, Quantities, Quantity};
use ratpoly::RationalFunction;

/// A matrix is printed as such while its rows are no wider than this.
const ROW: usize = 72;
/// So many lines share a display, which no page break may cut.
const PAGE: usize = 6;
/// A formula longer than this says nothing to a reader.
const UNREADABLE: usize = 600;

const SECTIONS: [(&[Kind], &str); 3] = [
    (
        &[Kind::CharacteristicCoefficient],
        "The coefficients of the characteristic polynomial:",
    ),
    (
        &[
            Kind::HurwitzMatrix,
            Kind::Determinant,
            Kind::LeadingMinor,
            Kind::Cofactors,
        ],
        "The Hurwitz matrix with its determinant, leading principal minors and cofactors:",
    ),
    (&[Kind::Solution], "What the linear equations determine:"),
];

pub(super) fn write(tex: &mut Tex, audit: &Audit, formulas: &Formulas) {
    let quantities = Quantities::of(audit);
    let any = |kinds: &[Kind]| quantities.list.iter().any(|q| kinds.contains(&q.kind));
    if !SECTIONS.iter().any(|(kinds, _)| any(kinds)) {
        return;
    }
    tex.heading("Intermediate results");
    tex.paragraph(&Prose::of(
        "Computed exactly from the equations, where these are misprinted from the corrected ones.",
    ));
    for (kinds, words) in SECTIONS {
        if !any(kinds) {
            continue;
        }
        tex.paragraph(&Prose::of(words));
        let tex = &mut Lines {
            tex,
            line: String::new(),
            lines: Vec::new(),
        };
        let mut kind = None;
        for quantity in quantities.list.iter().filter(|q| kinds.contains(&q.kind)) {
            if kind.replace(quantity.kind) != Some(quantity.kind) {
                tex.flush();
            }
            show(tex, formulas, quantity, &quantity.value);
            let expanded = quantities.expanded(&quantity.value);
            if quantity.kind == Kind::Solution
                && let Some(expanded) = expanded.filter(|v| *v != quantity.value)
            {
                tex.paragraph(&Prose::of("The same in the declared symbols:"));
                show(tex, formulas, quantity, &expanded);
            }
        }
        tex.flush();
    }
}

/// Short formulas share a line, lines share a display.
struct Lines<'t> {
    tex: &'t mut Tex,
    line: String,
    lines: Vec<String>,
}

impl Lines<'_> {
    fn formula(&mut self, latex: &str) {
        if latex.contains("\\begin") {
            self.flush();
            self.tex.display(latex);
            return;
        }
        if !self.line.is_empty() && width(&self.line) + width(latex) + 4 > ROW {
            self.lines.push(std::mem::take(&mut self.line));
        }
        if self.lines.len() >= PAGE {
            self.flush();
        }
        if !self.line.is_empty() {
            self.line.push_str(",\\qquad ");
        }
        self.line.push_str(latex);
    }

    fn paragraph(&mut self, prose: &Prose) {
        self.flush();
        self.tex.paragraph(prose);
    }

    fn flush(&mut self) {
        if !self.line.is_empty() {
            self.lines.push(std::mem::take(&mut self.line));
        }
        let lines = std::mem::take(&mut self.lines);
        if !lines.is_empty() {
            let body = lines.join(", \\\\[1ex]\n");
            self.tex
                .display(&format!("\\begin{{gathered}}\n{body}\n\\end{{gathered}}"));
        }
    }
}

fn show(
    tex: &mut Lines<'_>,
    formulas: &Formulas,
    quantity: &Quantity,
    value: &Value<RationalFunction>,
) {
    match value {
        Value::Scalar(f) => scalar(tex, formulas, &quantity.name, f),
        Value::Matrix(m) => matrix(tex, formulas, quantity, m),
        Value::Zero => {}
    }
}

fn scalar(tex: &mut Lines<'_>, formulas: &Formulas, name: &str, f: &RationalFunction) {
    let latex = formulas.display(name, f);
    if width(&latex) > UNREADABLE {
        let terms = (f.numerator().len(), f.denominator().len());
        let words = format!(
            " is a quotient of polynomials with {} and {} terms, too long to print.",
            terms.0, terms.1
        );
        tex.paragraph(&Prose::new().math(name).words(words));
    } else {
        tex.formula(&latex);
    }
}

fn matrix(
    tex: &mut Lines<'_>,
    formulas: &Formulas,
    quantity: &Quantity,
    m: &Matrix<RationalFunction>,
) {
    let rows: Vec<Vec<String>> = (0..m.rows())
        .map(|i| {
            (0..m.columns())
                .map(|j| formulas.rational(&m[(i, j)], Script::Latex))
                .collect()
        })
        .collect();
    let row_width = |row: &Vec<String>| row.iter().map(|e| width(e) + 2).sum::<usize>();
    let fits = rows.iter().all(|row| row_width(row) <= ROW);
    if fits && quantity.kind != Kind::Cofactors {
        let rows: Vec<String> = rows.iter().map(|row| row.join(" & ")).collect();
        tex.formula(&format!(
            "{} = \\begin{{bmatrix}} {} \\end{{bmatrix}}",
            quantity.name,
            rows.join(" \\\\ ")
        ));
        return;
    }
    let symmetric = m.is_square() && (0..m.rows()).all(|i| (0..i).all(|j| m[(i, j)] == m[(j, i)]));
    if symmetric {
        let note = " is symmetric; its entries on and above the diagonal:";
        tex.paragraph(&Prose::new().math(quantity.name.clone()).words(note));
    }
    let base = match quantity.kind {
        Kind::Cofactors => quantity
            .name
            .split('_')
            .next()
            .unwrap_or(&quantity.name)
            .into(),
        _ => format!("\\bigl({}\\bigr)", quantity.name),
    };
    for i in 0..m.rows() {
        for j in if symmetric { i } else { 0 }..m.columns() {
            let name = format!("{base}_{{{}{}}}", i + 1, j + 1);
            scalar(tex, formulas, &name, &m[(i, j)]);
        }
    }
}
