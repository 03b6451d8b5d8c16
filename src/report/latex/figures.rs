//! The figures, drawn anew from the exact formulas.

use super::Tex;
use crate::audit::Audit;
use crate::report::drawing::{pgf, remarks, scene};
use crate::report::prose::Prose;

pub(super) fn write(tex: &mut Tex, audit: &Audit) {
    if audit.figures.is_empty() {
        return;
    }
    tex.heading("Figures");
    tex.paragraph(&Prose::of(
        "Drawn from the exact formulas, as corrected where they are misprinted; the numbers behind \
         them stand in the CSV files beside this report. What is marked was determined exactly and is \
         shown rounded.",
    ));
    for figure in &audit.figures {
        // No float: it stays in its section, and no page is for it alone.
        tex.line("\n\\par\\medskip\\noindent\\begin{minipage}{\\linewidth}\n\\centering");
        if let Some(scene) = scene(figure) {
            tex.push(&pgf(&scene));
        }
        tex.line("\n\\begin{minipage}{0.92\\linewidth}\\small");
        let head = format!("Figure {}.", figure.label);
        let mut caption = Prose::new()
            .strong(head)
            .words(format!(" {}.", figure.title));
        for remark in remarks(figure) {
            caption = caption.words(" ").then(remark.capitalised()).words(".");
        }
        tex.line(caption.to_latex().trim());
        if let Some(note) = &figure.note {
            tex.line(&format!("\\par {}", Prose::text(note).to_latex()));
        }
        tex.line("\\end{minipage}\n\\end{minipage}\\par\\medskip");
    }
}
